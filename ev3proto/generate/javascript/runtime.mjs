/** The bytes of one argument. */
export class Argument {
  constructor(bytes) {
    this.bytes = Uint8Array.from(bytes);
  }
}

/** A place in local or global memory. */
export class Variable extends Argument {
  constructor(memory, index, { isHandle = false } = {}) {
    if (!Number.isInteger(index) || index < 0 || index >= 2 ** 32) throw new RangeError(`${index} is not an index`);
    const size = [0, 1, 2, 4].find((size) => index < (size ? 2 ** (8 * size) : 32) && (size || !isHandle));
    const head = ENCODING[`${memory}${size}`] | (isHandle ? HANDLE_BIT : 0);
    super(size ? [head, ...littleEndian(index, size)] : [head | index]);
    this.memory = memory;
    this.index = index;
  }
}

const littleEndian = (value, size) => Array.from({ length: size }, (_, at) => Math.floor(value / 256 ** at) & 0xff);

const isWithin = (value, size) => Math.abs(value) < 2 ** (8 * size - 1);

/** A whole number, in its shortest encoding. */
export function LC(value) {
  if (!Number.isInteger(value) || !isWithin(value, 4)) throw new RangeError(`${value} is not a whole number of 32 bits`);
  if (value >= -32 && value <= 31) return new Argument([value & 0x3f]);
  const size = [1, 2, 4].find((size) => isWithin(value, size));
  return new Argument([ENCODING[`LC${size}`], ...littleEndian(value, size)]);
}

/** A float; of all that are not a number, the one that the firmware knows. */
export function LCF(value) {
  const view = new DataView(new ArrayBuffer(4));
  view.setFloat32(0, value, true);
  const bytes = Number.isNaN(value) ? NAN_FLOAT : new Uint8Array(view.buffer);
  return new Argument([ENCODING.LC4, ...bytes]);
}

/** A text of ISO-8859-1 and its zero. */
export function LCS(text) {
  return new Argument([ENCODING.LCS, ...zeroEnded(text)]);
}

function zeroEnded(text) {
  const codes = Array.from(text, (letter) => letter.codePointAt(0));
  const odd = codes.find((code) => code === 0 || code > 0xff);
  if (odd !== undefined) throw new RangeError(`${JSON.stringify(text)} has a character that the brick lacks: code ${odd}`);
  return [...codes, 0];
}

/** A place in local memory, in its shortest encoding. */
export const LV = (index) => new Variable("LV", index);

/** A place in global memory, which the reply carries. */
export const GV = (index) => new Variable("GV", index);

/** The array or text whose handle a variable holds. */
export const HND = ({ memory, index }) => new Variable(memory, index, { isHandle: true });

const named = (name, make) => {
  try {
    return make();
  } catch (error) {
    throw new RangeError(`${name}: ${error.message}`, { cause: error });
  }
};

// The kinds of parameters: each takes a name for errors, and a value.
const integer = (low, high) => (name, value) => {
  if (value instanceof Argument) return value;
  if (Number.isInteger(value) && value >= low && value <= high) return LC(value);
  throw new RangeError(`${name}: ${value} is not a whole number from ${low} to ${high}`);
};
const float = (name, value) => (value instanceof Argument ? value : named(name, () => LCF(value)));
const text = (name, value) => (value instanceof Argument ? value : named(name, () => LCS(value)));
const any = (name, value) => {
  if (typeof value === "string") return text(name, value);
  return Number.isInteger(value) ? data32(name, value) : float(name, value);
};
const output = (name, value) => {
  if (!(value instanceof Argument)) throw new TypeError(`${name} is an output: give GV(0), LV(0), or another variable`);
  return value;
};
const list = (name, values, kind) => {
  if (!Array.isArray(values)) throw new TypeError(`${name} is a list: give an array`);
  return [LC(values.length), ...values.map((value) => kind(name, value))];
};

const operation = (opcode, ...parts) => Uint8Array.from([opcode, ...parts.flat().flatMap((part) => [...part.bytes])]);

function frame(type, counter, body) {
  const size = LENGTH_FIELD + 3 + body.length;
  if (size > MAX_FRAME) throw new RangeError(`a frame has at most ${MAX_FRAME} bytes, this one has ${size}`);
  return Uint8Array.from([...littleEndian(size - LENGTH_FIELD, 2), ...littleEndian(counter, 2), type, ...body]);
}

/**
 * A direct command: operations, the message counter, and bytes of global and local memory. A reply is requested where there is
 * global memory, if `reply` does not say otherwise.
 */
export function directCommand(operations, { counter = 0, globals = 0, locals = 0, reply = globals > 0 } = {}) {
  integer(0, MAX_GLOBALS)("globals", globals);
  integer(0, MAX_LOCALS)("locals", locals);
  const type = reply ? MessageType.DIRECT_COMMAND_REPLY : MessageType.DIRECT_COMMAND_NO_REPLY;
  const memory = littleEndian((locals << GLOBAL_BITS) | globals, 2);
  return frame(type, counter, [...memory, ...operations.flatMap((bytes) => [...bytes])]);
}

/** A system command: its bytes from `system`, and the message counter. */
export function systemCommand(bytes, { counter = 0, reply = true } = {}) {
  return frame(reply ? MessageType.SYSTEM_COMMAND_REPLY : MessageType.SYSTEM_COMMAND_NO_REPLY, counter, [...bytes]);
}

// The kinds of fields of system commands: numbers of 1, 2 and 4 bytes, texts, bytes, and both with their length in front.
const number = (size) => (name, value) => {
  integer(0, 256 ** size - 1)(name, value);
  return littleEndian(value, size);
};
const [u8, u16, u32] = [1, 2, 4].map(number);
const line = (name, value) => named(name, () => zeroEnded(value));
const bytes = (name, value) => [...value];
const message = (name, value) => {
  if (typeof value === "string") return line(name, value);
  if (typeof value === "boolean") return [Number(value)];
  return typeof value === "number" ? [...LCF(value).bytes.subarray(1)] : bytes(name, value);
};
const counted = (size, kind) => (name, value) => {
  const data = kind(name, value);
  return [...size(name, data.length), ...data];
};
const request = (...parts) => Uint8Array.from(parts.flat());
