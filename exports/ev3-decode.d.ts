/**
 * Reads frames of the LEGO MINDSTORMS EV3, in Node and browsers. Licence: MIT.
 *
 *     import { decode } from "./ev3-decode.mjs";
 *
 *     decode(reply, { request }).values; // [{ op: "UI_READ", command: "GET_VBATT", name: "VALUE", value: 7.5 }]
 *
 * This file is made by ev3proto 0.2.0 from its tables (ev3proto export javascript --decoder): change those, not this.
 */

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

export type Message = DirectCommand | DirectReply | SystemCommand | SystemReply | DaisyCommand | DaisyReply | Unknown;

export type DirectCommand = {
  kind: "direct-command";
  type: "DIRECT_COMMAND_REPLY" | "DIRECT_COMMAND_NO_REPLY";
  length: number;
  counter: number;
  direction?: "sent" | "received" | null;
  label?: string;
  time?: string;
  packets?: Array<number>;
  interface?: string | null;
  carrier?: "usb" | "bluetooth" | "wifi";
  source?: string | null;
  target?: string | null;
  peer?: string | null;
  connection?: number;
  globals?: number;
  locals?: number;
  operations?: Array<Operation>;
  values?: Array<Value>;
  answers?: number;
  latency?: number | null;
  note?: string;
  fault?: { offset: number; reason: string; };
  cut?: boolean;
  missing?: number;
  rest?: string;
  hex: string;
};

export type SystemCommand = {
  kind: "system-command";
  type: "SYSTEM_COMMAND_REPLY" | "SYSTEM_COMMAND_NO_REPLY";
  length: number;
  counter: number;
  direction?: "sent" | "received" | null;
  label?: string;
  time?: string;
  packets?: Array<number>;
  interface?: string | null;
  carrier?: "usb" | "bluetooth" | "wifi";
  source?: string | null;
  target?: string | null;
  peer?: string | null;
  connection?: number;
  command?: string | null;
  number?: number;
  fields?: Partial<Record<"address" | "checksum" | "data" | "firmware_version" | "handle" | "handles" | "hardware_version" | "hash" | "id" | "image_size" | "list" | "list_size" | "mac" | "mac_length" | "max_bytes" | "name" | "name_length" | "path" | "payload" | "payload_length" | "pin" | "pin_length" | "size", string | number>>;
  readings?: { text?: string; number?: number | "nan" | "inf" | "-inf"; logic?: boolean; };
  values?: Array<Value>;
  answers?: number;
  latency?: number | null;
  note?: string;
  fault?: { offset: number; reason: string; };
  cut?: boolean;
  missing?: number;
  rest?: string;
  hex: string;
};

export type DirectReply = {
  kind: "direct-reply";
  type: "DIRECT_REPLY" | "DIRECT_REPLY_ERROR";
  length: number;
  counter: number;
  direction?: "sent" | "received" | null;
  label?: string;
  time?: string;
  packets?: Array<number>;
  interface?: string | null;
  carrier?: "usb" | "bluetooth" | "wifi";
  source?: string | null;
  target?: string | null;
  peer?: string | null;
  connection?: number;
  status?: "ok" | "error";
  memory?: string;
  readings?: { string?: string; DATAF?: number | "nan" | "inf" | "-inf" | Array<number | "nan" | "inf" | "-inf">; DATA32?: number | "nan" | "inf" | "-inf" | Array<number | "nan" | "inf" | "-inf">; DATA16?: number | "nan" | "inf" | "-inf" | Array<number | "nan" | "inf" | "-inf">; DATA8?: number | "nan" | "inf" | "-inf" | Array<number | "nan" | "inf" | "-inf">; };
  values?: Array<Value>;
  answers?: number;
  latency?: number | null;
  note?: string;
  fault?: { offset: number; reason: string; };
  cut?: boolean;
  missing?: number;
  rest?: string;
  hex: string;
};

export type SystemReply = {
  kind: "system-reply";
  type: "SYSTEM_REPLY" | "SYSTEM_REPLY_ERROR";
  length: number;
  counter: number;
  direction?: "sent" | "received" | null;
  label?: string;
  time?: string;
  packets?: Array<number>;
  interface?: string | null;
  carrier?: "usb" | "bluetooth" | "wifi";
  source?: string | null;
  target?: string | null;
  peer?: string | null;
  connection?: number;
  command?: string | null;
  number?: number;
  fields?: Partial<Record<"address" | "checksum" | "data" | "firmware_version" | "handle" | "handles" | "hardware_version" | "hash" | "id" | "image_size" | "list" | "list_size" | "mac" | "mac_length" | "max_bytes" | "name" | "name_length" | "path" | "payload" | "payload_length" | "pin" | "pin_length" | "size", string | number>>;
  status?: "ok" | "error";
  status_name?: "SUCCESS" | "UNKNOWN_HANDLE" | "HANDLE_NOT_READY" | "CORRUPT_FILE" | "NO_HANDLES_AVAILABLE" | "NO_PERMISSION" | "ILLEGAL_PATH" | "FILE_EXITS" | "END_OF_FILE" | "SIZE_ERROR" | "UNKNOWN_ERROR" | "ILLEGAL_FILENAME" | "ILLEGAL_CONNECTION";
  status_code?: number;
  status_meaning?: string | null;
  values?: Array<Value>;
  answers?: number;
  latency?: number | null;
  note?: string;
  fault?: { offset: number; reason: string; };
  cut?: boolean;
  missing?: number;
  rest?: string;
  hex: string;
};

export type DaisyCommand = {
  kind: "daisy-command";
  type: "DAISY_COMMAND_REPLY" | "DAISY_COMMAND_NO_REPLY";
  length: number;
  counter: number;
  direction?: "sent" | "received" | null;
  label?: string;
  time?: string;
  packets?: Array<number>;
  interface?: string | null;
  carrier?: "usb" | "bluetooth" | "wifi";
  source?: string | null;
  target?: string | null;
  peer?: string | null;
  connection?: number;
  command?: "DOWNSTREAM" | "UPSTREAM" | "INFO" | "UNLOCK_SLAVE" | "SET_TYPE" | "DOWNSTREAM_WITH_BUSY" | null;
  number?: number;
  fields?: Partial<Record<"layer_from" | "layer_to" | "payload", string | number>>;
  operations?: Array<Operation>;
  values?: Array<Value>;
  answers?: number;
  latency?: number | null;
  note?: string;
  fault?: { offset: number; reason: string; };
  cut?: boolean;
  missing?: number;
  rest?: string;
  hex: string;
};

export type DaisyReply = {
  kind: "daisy-reply";
  type: "DAISY_REPLY" | "DAISY_REPLY_ERROR";
  length: number;
  counter: number;
  direction?: "sent" | "received" | null;
  label?: string;
  time?: string;
  packets?: Array<number>;
  interface?: string | null;
  carrier?: "usb" | "bluetooth" | "wifi";
  source?: string | null;
  target?: string | null;
  peer?: string | null;
  connection?: number;
  status?: "ok" | "error";
  fields?: Partial<Record<"busy" | "checksum" | "data" | "layer" | "layer_from" | "layer_to" | "mode" | "payload" | "port" | "status" | "type", string | number>>;
  values?: Array<Value>;
  answers?: number;
  latency?: number | null;
  note?: string;
  fault?: { offset: number; reason: string; };
  cut?: boolean;
  missing?: number;
  rest?: string;
  hex: string;
};

export type Unknown = {
  kind: "unknown";
  length?: number;
  direction?: "sent" | "received" | null;
  label?: string;
  time?: string;
  packets?: Array<number>;
  interface?: string | null;
  carrier?: "usb" | "bluetooth" | "wifi";
  source?: string | null;
  target?: string | null;
  peer?: string | null;
  connection?: number;
  answers?: number;
  latency?: number | null;
  note?: string;
  fault?: { offset: number; reason: string; };
  cut?: boolean;
  missing?: number;
  rest?: string;
  hex: string;
};

export type Operation = {
  op: string;
  opcode: number;
  command: string | null;
  offset: number;
  length: number;
  args: Array<Argument>;
  command_encoding?: string;
  complete?: false;
  target?: string;
};

export type Argument = {
  name: string;
  kind: "constant" | "string" | "local" | "global" | "label";
  encoding: string;
  value: number | string;
  offset: number;
  length: number;
  handle?: true;
  address?: true;
  symbol?: string;
  quantity?: string;
  unit?: string;
};

export type Value = {
  op: string;
  command: string | null;
  name: string;
  value: number | string | Array<number | "nan" | "inf" | "-inf">;
  type: string;
  offset: number;
  length: number;
  unit?: string;
  quantity?: string;
  symbol?: string | Array<string | null>;
};
