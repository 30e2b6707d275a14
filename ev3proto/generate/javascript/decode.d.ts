/** The firmware whose operations are known. */
export type Dialect = "official" | "xtended" | "compat";

/**
 * Returns what a frame says: the object that `ev3proto decode --json` prints. Any bytes give one; its `fault` says what is wrong.
 *
 * @param frame from the length field to the last byte
 * @param known of a reply: the command that it answers, as a frame or as `decode` returned it, which gives the reply's values names and units
 */
export declare function decode(
  frame: Uint8Array,
  known?: { request?: Uint8Array | Message | null; dialect?: Dialect },
): Message;

/** What is declared of an argument: its type in memory, its unit, the name of the enumeration of its values. */
export type Parameter = { name: string; type: string; direction?: "out" | "inout"; unit?: string; enum?: string };

/** Returns the declared parameter of each argument of an operation that `decode` returned. */
export declare function parametersOf(operation: Operation, dialect?: Dialect): Parameter[];

/** Returns the fields of a system message that `decode` returned: their types, offsets and lengths in the frame. */
export declare function fieldsOf(
  message: SystemCommand | SystemReply,
): { name: string; type: string; offset: number; length: number }[];

/** Cuts a stream of bytes into frames, wherever its chunks end. */
export declare class Frames {
  /** The bytes of the unfinished frame. */
  readonly pending: Uint8Array;

  /**
   * Takes the next bytes of the stream, any number. Returns an iterator over the frames that are complete with them; those not taken come with
   * the next chunk. Two zeros between frames are a poll and are skipped.
   *
   * @throws RangeError for an impossible length: where the next frame begins is then unknown
   */
  feed(chunk: Uint8Array): IterableIterator<Uint8Array>;
}

/** The frames of one computer and one brick, in both directions. A reply answers the oldest command with its counter that it fits. */
export declare class Dialogue {
  constructor(options?: { dialect?: Dialect });

  /** The commands that wait for a reply, oldest first. */
  readonly unanswered: Message[];

  /**
   * Takes the next frame. Returns what `decode` returns of it: a reply with the values that its command asked for, and with a `note` if several
   * commands may be the one that it answers.
   */
  feed(frame: Uint8Array): Message;
}

