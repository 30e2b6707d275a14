/** The bytes of one argument. */
export declare class Argument {
  constructor(bytes: Iterable<number>);
  readonly bytes: Uint8Array;
}

/** A place in local or global memory. */
export declare class Variable extends Argument {
  constructor(memory: "LV" | "GV", index: number, options?: { isHandle?: boolean });
  readonly memory: "LV" | "GV";
  readonly index: number;
}

/** A whole number, in its shortest encoding. */
export declare function LC(value: number): Argument;

/** A float; of all that are not a number, the one that the firmware knows. */
export declare function LCF(value: number): Argument;

/** A text of ISO-8859-1 and its zero. */
export declare function LCS(text: string): Argument;

/** A place in local memory, in its shortest encoding. */
export declare function LV(index: number): Variable;

/** A place in global memory, which the reply carries. */
export declare function GV(index: number): Variable;

/** The array or text whose handle a variable holds. */
export declare function HND(variable: Variable): Variable;

/** A number or a text, or a variable that holds it. */
export type Value = number | Argument;
export type Text = string | Argument;
export type Any = number | string | Argument;

/**
 * A direct command: operations, the message counter, and bytes of global and local memory. A reply is requested where there is
 * global memory, if `reply` does not say otherwise.
 */
export declare function directCommand(
  operations: readonly Uint8Array[],
  options?: { counter?: number; globals?: number; locals?: number; reply?: boolean },
): Uint8Array;

/** A system command: its bytes from `system`, and the message counter. */
export declare function systemCommand(bytes: Uint8Array, options?: { counter?: number; reply?: boolean }): Uint8Array;
