// The tables by number and name
const byNumber = (list) => new Map(list.map((each) => [each.number, each]));
const kinds = Object.fromEntries(TABLES.types.map((each) => [each.name, { size: 1, ...each }]));
const formats = new Map(TABLES.format_types.map(({ format, type }) => [format, kinds[type]]));
const { DATA8, DATA16, DATA32, DATAF, handle: HANDLE, string: STRING, label: LABEL, "array-typed": UNTYPED } = kinds;
const types = byNumber(TABLES.message_types), system = byNumber(TABLES.system_commands), daisy = byNumber(TABLES.daisy_commands);
const statuses = byNumber(TABLES.system_statuses), devices = byNumber(TABLES.devices);

/** What each identification byte says. */
const forms = [];
for (const { first, last, name, value, ...form } of TABLES.encodings) {
  for (let byte = first; byte <= last; byte++) forms[byte] = { ...form, encoding: name, value: value === undefined ? null : value + byte - first };
}

/** Returns what is known of an operation: its names, its parameters, and the list at its end. */
const declared = (op, { name: command, parameters = [] }) => {
  const fixed = parameters.map((each) => ({ ...each, kind: kinds[each.type] })), last = fixed.at(-1) ?? {};
  const entry = { op, command, fixed, tail: null, reading: parameters.find(({ role }) => role)?.role };
  if (!last.element && !last.element_from) return entry;
  const element = { ...last, direction: last.elements, kind: kinds[last.element] ?? UNTYPED };
  if (last.type === "values") fixed.pop();
  return { ...entry, tail: { hasOwnCount: last.type === "count", element, typedBy: last.element_from, made: {} } };
};

/** Returns the operations of a dialect, by the numbers of opcode and CMD. */
const read = (dialect) => {
  if (!TABLES.dialects.includes(dialect)) throw new RangeError(`unknown dialect ${dialect}; it can be ${TABLES.dialects.join(", ")}`);
  const opcodes = [], has = ({ dialects = TABLES.dialects }) => dialects.includes(dialect);
  for (const opcode of Object.values(TABLES.areas).flat().filter(has)) {
    const cmds = opcode.commands?.filter(has).map((each) => [each.number, declared(opcode.name, each)]);
    opcodes[opcode.number] = { name: opcode.name, plain: cmds ? null : declared(opcode.name, { ...opcode, name: null }), cmds: new Map(cmds) };
  }
  return { dialect, opcodes };
};
const sets = Object.create(null);
const instructions = (dialect = "official") => (sets[dialect] ??= read(dialect));
const entryOf = ({ opcode, command }, { opcodes }) => opcodes[opcode].plain ?? [...opcodes[opcode].cmds.values()].find((each) => each.command === command);

/** Returns the parameter of an argument, which for an element of a list may depend on the arguments before it. */
const parameterOf = ({ fixed, tail }, args, index) => {
  if (index < fixed.length) return fixed[index];
  const format = args.find(({ name, kind }) => name === tail.typedBy && kind === "constant")?.value;
  const kind = formats.get(Math.trunc(format)) ?? tail.element.kind;
  const made = (tail.made[kind.name] ??= []), number = index - fixed.length;
  return (made[number] ??= { ...tail.element, kind, name: `${tail.element.name}[${number}]` });
};

// Values
const hexOfByte = Array.from({ length: 256 }, (_, byte) => byte.toString(16).padStart(2, "0"));
const hexOf = (bytes) => { let text = ""; for (const byte of bytes) text += hexOfByte[byte]; return text; };
const textOf = (bytes) => { let text = ""; for (const byte of bytes) text += String.fromCharCode(byte); return text; };
const shown = (byte) => `0x${hexOfByte[byte].toUpperCase()}`;
const counted = (count, noun) => `${count} ${noun}${count === 1 ? "" : "s"}`;
const READERS = new Map([[DATA8, "getInt8"], [DATA16, "getInt16"], [HANDLE, "getInt16"], [DATA32, "getInt32"], [DATAF, "getFloat32"]]);
const numberAt = (bytes, kind, at) => new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)[READERS.get(kind)](at, true);
const unsigned = (bytes, at, size) => { let value = 0; for (let index = size; index-- > 0;) value = value * 256 + bytes[at + index]; return value; };

/** Returns a value as JSON has it: bytes as hex, and numbers that are not finite as texts. */
const plain = (value) => {
  if (value instanceof Uint8Array) return hexOf(value);
  if (Array.isArray(value)) return value.map(plain);
  if (typeof value !== "number" || Number.isFinite(value)) return value;
  return Number.isNaN(value) ? "nan" : value > 0 ? "inf" : "-inf";
};

/** Returns the name of a number; null for none. */
const nameOf = (names, value) => {
  const pairs = names ? Object.entries(names.members) : [], found = pairs.find(([, number]) => number === value);
  if (found || !names?.flags || !value) return found?.[0] ?? null;
  const parts = pairs.filter(([, number]) => (value & number) === number), sum = parts.reduce((all, [, number]) => all + number, 0);
  return parts.length && sum === (value & 0xff) ? parts.map(([name]) => name).join("|") : null;
};

// Operations
/** What is wrong, and where; `truncated` if more bytes could mend it. */
const said = (key, parts) => TABLES.reasons[key].replace(/{(\w+)}/g, (_, name) => (name === "byte" ? shown(parts.byte) : parts[name]));
class Fault { constructor(offset, key, parts = {}, truncated = false) { Object.assign(this, { offset, reason: said(key, parts), truncated }); } }
const faultOf = (read) => { try { return read() ?? null; } catch (fault) { if (fault instanceof Fault) return fault; throw fault; } };
const cut = (data, kind) => new Fault(data.length, kind, {}, true);

/** Reads a text up to its zero. Returns it, and the offset after it. */
const readText = (data, start, at, key, parts) => {
  const zero = data.indexOf(0, start);
  if (zero < 0) throw new Fault(at, key, parts, true);
  return [textOf(data.subarray(start, zero)), zero + 1];
};

/** Whether an argument is a float: a constant of four bytes, where the parameter is one. */
const isFloat = ({ kind, length }, parameter) => parameter.kind === DATAF && kind === "constant" && length === 5;
const LETTERS = { local: "L", global: "G" };
const isVariable = ({ kind }) => kind in LETTERS;

/** Returns the value of an argument and the offset after it. */
const readValue = (data, at, parameter, form) => {
  const { name } = parameter, { kind, encoding, width, value } = form, end = at + 1 + width, missing = end - data.length;
  if (width === undefined) return readText(data, at + 1, at, "cut_string", { name });
  if (value !== null) return [value, at + 1];
  if (missing > 0) throw new Fault(at, "cut_argument", { name, form: encoding, more: counted(missing, "more byte") }, true);
  if (isFloat({ kind, length: 1 + width }, parameter)) return [plain(numberAt(data, DATAF, at + 1)), end];
  const number = unsigned(data, at + 1, width), isNegative = number >= 2 ** (8 * width - 1) && !isVariable(form);
  return [isNegative ? number - 2 ** (8 * width) : number, end];
};

/** Reads an argument into a list. Returns the offset after it. */
const readArgument = (data, at, parameter, args) => {
  const { name } = parameter, form = forms[data[at]];
  if (at >= data.length) throw new Fault(at, "no_argument", { name }, true);
  if (!form) throw new Fault(at, "no_form", { byte: data[at], name });
  const { kind, encoding, handle, address } = form, read = readValue(data, at, parameter, form), value = read[0], end = read[1];
  const argument = { name, kind, encoding, value, offset: at, length: end - at };
  const symbol = isVariable(form) || isFloat(argument, parameter) ? null : nameOf(TABLES.enumerations[parameter.enum], value);
  if (handle || address) Object.assign(argument, given({ handle, address }));
  if (symbol !== null) argument.symbol = symbol;
  args.push(argument);
  return end;
};
const CMD = { name: "CMD", kind: DATA8 };

/** Returns the entry at an opcode, CMD where it has one, and the offset after them. */
const select = (data, at, { opcodes, dialect }) => {
  const opcode = opcodes[data[at]];
  if (!opcode) throw new Fault(at, "no_opcode", { byte: data[at], dialect });
  if (opcode.plain) return [opcode.plain, null, at + 1];
  const args = [], next = readArgument(data, at + 1, CMD, args), [cmd] = args, { kind, value } = cmd, owner = opcode.name, entry = opcode.cmds.get(value);
  if (kind !== "constant") throw new Fault(at + 1, "variable_cmd", { owner, value: isVariable(cmd) ? `${LETTERS[kind]}V(${value})` : `a ${kind}` });
  if (entry) return [entry, cmd, next];
  const first = [...opcode.cmds].sort(([one], [other]) => one - other).slice(0, 3).map(([number, { command }]) => `${number} ${command}`);
  throw new Fault(at + 1, "no_cmd", { owner, value, known: first.join(", ") });
};

/** Returns how many values of a list follow, for which there is some room. */
const countOf = ({ hasOwnCount }, { name, kind, value, offset }, room) => {
  const most = TABLES.frame.most_counted, bound = hasOwnCount ? Math.min(room, most) : room;
  if (kind !== "constant" || typeof value !== "number") throw new Fault(offset, "no_count", { name });
  if (value >= 0 && value <= bound) return value;
  throw new Fault(offset, "no_room", { name, value, room: bound }, value >= 0 && value <= most);
};

/** Returns the argument of a parameter that is a constant whole number, null for any other. */
const wholeOf = (name, fixed, args) => {
  const index = fixed.findIndex((each) => each.name === name), argument = args[index];
  const isWhole = argument?.kind === "constant" && !argument.handle && !argument.address && !isFloat(argument, fixed[index]);
  return isWhole ? argument.value : null;
};

/** Adds what the arguments receive from a device, where type and mode tell it. */
const addReadings = ({ fixed, tail, reading }, args) => {
  const mode = devices.get(wholeOf("TYPE", fixed, args))?.modes[wholeOf("MODE", fixed, args)];
  if (!mode || (reading === "RAW_READING" && mode.is_scaled)) return;
  args.slice(fixed.length - (tail ? 0 : 1)).forEach((argument, index) => {
    const { name, unit } = mode.values[index] ?? {};
    if (name && !argument.handle) Object.assign(argument, unit ? { quantity: name, unit } : { quantity: name });
  });
};

/** Reads operations in a row. Returns them, the offset after them, and what is wrong there. */
const readOperations = (data, start, set) => {
  const operations = [];
  let at = start, fault = null;
  while (at < data.length && !fault) {
    const offset = at, args = [];
    let entry = null, cmd;
    fault = faultOf(() => {
      [entry, cmd, at] = select(data, at, set);
      for (const parameter of entry.fixed) at = readArgument(data, at, parameter, args);
      const last = entry.tail ? args.length + countOf(entry.tail, args.at(-1), data.length - at) : 0;
      while (args.length < last) at = readArgument(data, at, parameterOf(entry, args, args.length), args);
    });
    if (!entry) break;
    if (entry.reading) addReadings(entry, args);
    const more = fault ? { complete: false } : cmd?.length > 1 && { command_encoding: cmd.encoding };
    operations.push({ op: entry.op, opcode: data[offset], command: entry.command, offset, length: at - offset, args, ...more });
  }
  return { operations, at, fault };
};

// System messages, and what their bytes may mean
/** Reads a text of a length that may count its zero. */
const readCountedText = (data, at, length, left) => {
  if (left < length) throw new Fault(at, "cut_text", { length }, true);
  const end = at + length, zero = data[end];
  if (length && data[end - 1] === 0) return [textOf(data.subarray(at, end - 1)), end];
  if (left === length) throw new Fault(at, "no_zero", {}, true);
  if (zero) throw new Fault(end, "other_zero", { length, byte: zero });
  return [textOf(data.subarray(at, end)), end + 1];
};

/** Returns the value of a field and the offset after it. */
const readField = (data, at, { name, kind }, counter, length) => {
  const left = data.length - at, size = kind.startsWith("u") ? Number(kind.slice(1)) / 8 : 0;
  if (left < size) throw new Fault(at, "no_field", { name, kind }, true);
  if (size) return [unsigned(data, at, size), at + size];
  if (kind === "text") return readText(data, at, at, "endless_text", { name });
  if (kind === "counted text") return readCountedText(data, at, length, left);
  if (length !== undefined && length !== left) throw new Fault(at, "wrong_count", { counter, stated: length, size: left });
  return [kind === "listing" ? textOf(data.subarray(at)) : data.subarray(at), data.length];
};

/** Reads the fields of a system message. `places` has the offset and length of each. */
const readFields = (list, data, begin, mayEnd) => {
  const fields = {}, places = {}, counters = Object.fromEntries(list.map(({ name, counts }) => [counts, name]));
  let at = begin;
  const fault = faultOf(() => {
    for (const field of list) {
      if (at === data.length && (field.optional || mayEnd)) break;
      const { name } = field, [value, end] = readField(data, at, field, counters[name], fields[counters[name]]);
      fields[name] = value;
      places[name] = { offset: at, length: end - at };
      at = end;
    }
    return at < data.length ? new Fault(at, "left_over", { bytes: counted(data.length - at, "byte") }) : null;
  });
  return { fields, places, at, fault };
};
const plainFields = (fields) => Object.fromEntries(Object.entries(fields).map(([name, value]) => [name, plain(value)]));
const isPrintable = (bytes) => bytes.every((byte) => (byte >= 0x20 && byte < 0x7f) || byte >= 0xa0);
const isLikely = (number) => number === 0 || Number.isNaN(number) || (Math.abs(number) >= 1e-6 && Math.abs(number) < 1e7);
const orNone = (found) => (Object.keys(found).length ? { readings: found } : {});

/** Returns what a message to a mailbox may be. */
const readings = (bytes) => {
  const found = {}, zero = bytes.indexOf(0), text = bytes.subarray(0, -1), isNumber = bytes.length === 4;
  if (bytes.length === 1 && bytes[0] < 2) found.logic = bytes[0] === 1;
  if (isNumber) found.number = plain(numberAt(bytes, DATAF, 0));
  if (zero >= 0 && zero === bytes.length - 1 && (!isNumber || isPrintable(text))) found.text = textOf(text);
  return orNone(found);
};

/** Returns what the memory of a reply may be whose command is not known. */
const guesses = (memory) => {
  const found = {}, zero = memory.indexOf(0), text = memory.subarray(0, Math.max(zero, 0)), size = [4, 2, 1].find((each) => memory.length % each === 0);
  if (zero > 1 && isPrintable(text) && memory.subarray(zero).every((byte) => byte === 0)) found.string = textOf(text);
  if (!memory.length || memory.length > size * 8) return orNone(found);
  for (const kind of [DATAF, DATA32, DATA16, DATA8].filter((each) => each.size === size)) {
    const numbers = Array.from({ length: memory.length / size }, (_, index) => numberAt(memory, kind, index * size));
    if (kind !== DATAF || numbers.every(isLikely)) found[kind.name] = plain(numbers.length > 1 ? numbers : numbers[0]);
  }
  return orNone(found);
};

// Replies to direct commands: the memory, by the outputs of the command
/** Returns how many values an operation writes to an argument; null if it does not say. */
const lengthOf = ({ length, length_from: from, indexed_by: indexedBy, kind }, fixed, args) => {
  const name = from ?? indexedBy, count = wholeOf(name, fixed, args);
  if (length !== undefined || name === undefined) return length ?? 1;
  if (count === null) return null;
  if (from === undefined) return count >= 0 ? count + 1 : null;
  return count === -1 && kind === STRING ? null : Math.abs(count);
};

/** Returns the outputs of an operation in global memory: where each begins, and its end if the operation says it. */
const outputsOf = (operation, set) => {
  const entry = entryOf(operation, set), { args } = operation;
  return args.flatMap((argument, index) => {
    const parameter = parameterOf(entry, args, index), { kind, direction, length, length_from: from } = parameter, start = argument.value;
    if (argument.kind !== "global" || !direction || argument.address) return [];
    if (argument.handle) return [{ argument, kind: HANDLE, start, end: start + 2, isArray: false, parameter: {} }];
    const count = lengthOf(parameter, entry.fixed, args), isArray = [length, from].some((each) => each !== undefined);
    const isOpen = count === null || (kind === STRING && !isArray) || (kind === UNTYPED && index >= entry.fixed.length);
    return [{ argument, kind, start, end: isOpen ? Infinity : start + kind.size * count, isArray, parameter }];
  });
};

/** Reads the text or the numbers that an output has in memory; null for none. `room` is the number of bytes before the next output. */
const readOutput = (memory, { kind: stated, start, end, isArray, parameter }, room) => {
  const rest = memory.subarray(start, end), isList = isArray && stated !== UNTYPED;
  const kind = stated === UNTYPED ? [DATA32, DATA16, DATA8].find(({ size }) => size <= room) : stated;
  const [text] = textOf(rest).split("\0");
  if (kind === STRING) return { value: text, kind, length: text.length, symbol: null };
  const length = isList ? Math.floor(rest.length / kind.size) * kind.size : kind.size;
  if (length < 1 || start + length > memory.length) return null;
  const numbers = Array.from({ length: length / kind.size }, (_, index) => numberAt(memory, kind, start + index * kind.size));
  const names = TABLES.enumerations[parameter.enum], symbol = isList && names ? numbers.map((each) => nameOf(names, each)) : nameOf(names, numbers[0]);
  return { value: isList ? numbers : numbers[0], kind, length, symbol };
};

const replyValues = ({ operations }, memory, set) => operations.flatMap((operation) => {
  const outputs = outputsOf(operation, set);
  return outputs.filter(({ kind, start }) => kind !== LABEL && start < memory.length).flatMap((output) => {
    const { argument, start, parameter } = output, next = outputs.map((each) => each.start).filter((each) => each > start);
    const read = readOutput(memory, output, Math.min(memory.length, ...next) - start);
    if (!read) return [];
    const { value, kind, length, symbol } = read, { quantity, unit = quantity ? undefined : parameter.unit } = argument;
    const found = { op: operation.op, command: operation.command, name: argument.name, value: plain(value), type: kind.name, offset: 5 + start, length };
    return [{ ...found, ...(unit && { unit }), ...(quantity && { quantity }), ...(symbol !== null && { symbol }) }];
  });
});

// Frames
const MOST = TABLES.frame.most_bytes, MOST_WAITING = 65536, MOST_ALIKE = 256;
const statusOf = (isError) => (isError ? "error" : "ok");
const given = (keys) => Object.fromEntries(Object.entries(keys).filter(([, value]) => value !== undefined));

/** What is in a message, by its kind: its keys, the fault, and the offset from which on nothing was read. */
const BODIES = {
  "direct-command": (data, { set }) => {
    if (data.length < 7) return { globals: 0, locals: 0, operations: [], at: 5, fault: cut(data, "direct-command") };
    const memory = unsigned(data, 5, 2), bits = TABLES.frame.global_bits, { operations, at, fault } = readOperations(data, 7, set);
    return { globals: memory % 2 ** bits, locals: memory >> bits, operations, at, fault };
  },
  "direct-reply": (data, { isError, request, set }) => {
    const memory = data.subarray(5), isRead = !isError && request?.kind === "direct-command";
    const found = request ? { values: isRead ? replyValues(request, memory, set) : [] } : guesses(memory);
    return { status: statusOf(isError), memory: hexOf(memory), ...found };
  },
  "system-command": (data) => {
    const number = data[5], entry = system.get(number), found = { command: entry?.name ?? null, number: number ?? 0, fields: {}, at: 6 };
    if (number === undefined) return { ...found, fault: cut(data, "system-command"), at: 5 };
    if (!entry) return { ...found, fault: new Fault(5, "no_system", { byte: number }) };
    const { fields, at, fault } = readFields(entry.request, data, 6, false), payload = fields[entry.request.find((each) => each.is_message)?.name];
    return { ...found, fields: plainFields(fields), ...(payload ? readings(payload) : {}), at, fault };
  },
  "system-reply": (data, { isError }) => {
    const none = { command: null, number: 0, status: statusOf(isError), status_code: 0, fields: {}, values: [] };
    if (data.length < 7) return { ...none, at: 5, fault: cut(data, "system-reply") };
    const [number, code] = data.subarray(5), { name: saying, is_failure: isFailure } = statuses.get(code) ?? { is_failure: true };
    const { name: command = null, reply, statuses: { [code]: meaning } = {} } = system.get(number) ?? {};
    const found = { ...none, command, number, status: statusOf(isError || isFailure), status_code: code, ...given({ status_name: saying, status_meaning: meaning }) };
    if (!reply) return { ...found, at: 7, fault: new Fault(5, "no_system", { byte: number }) };
    const { fields, places, at, fault } = readFields(reply, data, 7, isError || code !== 0);
    const has = ({ name }) => name in fields, valueOf = ({ name, kind: type }) => ({ op: command, command: null, name, value: plain(fields[name]), type, ...places[name] });
    return { ...found, fields: plainFields(fields), values: reply.filter(has).map(valueOf), at, fault };
  },
  "daisy-command": (data, { set }) => {
    const isCut = data.length < 8, [number, layer_from, layer_to] = isCut ? [0, 0, 0] : data.subarray(5), entry = isCut ? null : daisy.get(number);
    const { operations, fault } = entry?.carries_operations ? readOperations(data, 8, set) : { operations: [] };
    const found = { command: entry?.name ?? null, number, fields: { layer_from, layer_to, payload: hexOf(data.subarray(8)) }, operations: fault ? [] : operations };
    return isCut ? { ...found, at: 5, fault: cut(data, "daisy-command") } : { ...found, fault: entry ? null : new Fault(5, "no_daisy", { byte: number }) };
  },
  "daisy-reply": (data, { isError }) => {
    const isCut = data.length < 7, [layer_from, layer_to] = isCut ? [0, 0] : data.subarray(5), payload = data.subarray(7), end = 5 + TABLES.frame.sensor_data;
    const fields = { layer_from, layer_to, payload: hexOf(payload) }, found = { status: statusOf(isError), fields };
    if (payload.length > end) {
      ["layer", "port", "status", "type", "mode"].forEach((name, index) => { fields[name] = payload[index]; });
      Object.assign(fields, { data: hexOf(payload.subarray(5, end)), checksum: payload[end], busy: hexOf(payload.subarray(end + 1)) });
    }
    return isCut ? { ...found, at: 5, fault: cut(data, "daisy-reply") } : found;
  },
};

/** Whether a frame may have a length: some system commands may be longer than all others. */
const isPossible = (data, length, { kind } = {}) => length >= 3 && (length + 2 <= MOST || (kind === "system-command" && (data.length < 6 || system.get(data[5])?.is_long)));

/** Returns what is wrong with a frame outside its body. */
const envelopeFault = (data, length, type) => {
  const size = data.length - 2;
  if (!isPossible(data, length, type)) return size === length ? new Fault(0, "too_long", { size: size + 2 }) : new Fault(0, "wrong_length", { length });
  if (size < length) return new Fault(0, "cut_off", { length, size }, true);
  if (size === length) return type ? null : new Fault(4, "no_type", { byte: data[4] });
  const longer = new Fault(length + 2, "longer", { length, size }), { name, bootloader } = (type?.name === "SYSTEM_COMMAND_REPLY" && system.get(data[5])) || {};
  return bootloader ? new Fault(length + 2, "bootloader", { reason: longer.reason, name }) : longer;
};

/** Joins the faults outside and in a frame's body: the outer one first, then the inner one, unless the first explains it. */
const worse = (outer, inner) => {
  if (!outer || !inner || inner.truncated) return outer ?? inner;
  return new Fault(outer.offset, "two", { reason: outer.reason, offset: inner.offset, inner: inner.reason });
};
const faulty = (message, { offset, reason }, rest, hex) => ({ ...message, fault: { offset, reason }, ...(rest && { rest }), hex });

/** Returns what a frame says, as `ev3proto decode --json` prints it. `request` is the command that a reply answers: a frame, or its object. */
export const decode = (frame, { request, dialect } = {}) => {
  if (request instanceof Uint8Array) return decode(frame, { request: decode(request, { dialect }), dialect });
  const set = instructions(dialect), size = frame.length, hex = hexOf(frame);
  if (size < 5) return faulty({ kind: "unknown" }, new Fault(size, "no_header", { size }), hex, hex);
  const length = unsigned(frame, 0, 2), counter = unsigned(frame, 2, 2), type = types.get(frame[4]), isWrong = length + 2 !== size, outer = envelopeFault(frame, length, type);
  if (!type) return faulty({ kind: "unknown", ...(isWrong && { length }) }, outer, hex, hex);
  const data = isWrong ? frame.subarray(0, Math.max(length + 2, 5)) : frame;
  const { at = data.length, fault: inner, ...keys } = BODIES[type.kind](data, { isError: type.is_error === true, request, set });
  const message = { kind: type.kind, type: type.name, length, counter, ...keys }, fault = worse(outer, inner);
  return fault ? faulty(message, fault, hexOf(data.subarray(at)) + hexOf(frame.subarray(data.length)), hex) : Object.assign(message, { hex });
};

// What the tables say of a message
/** Returns the declared parameter of each argument of an operation. */
export const parametersOf = (operation, dialect) => {
  const entry = entryOf(operation, instructions(dialect)), { args } = operation;
  return args.map((_, index) => parameterOf(entry, args, index)).map(({ kind, ...parameter }) => ({ ...parameter, type: kind.name }));
};

/** Returns the fields of a system message with their places. */
export const fieldsOf = ({ kind, number, values, hex }) => {
  if (kind !== "system-command") return values.map(({ name, type, offset, length }) => ({ name, type, offset, length }));
  const bytes = Uint8Array.from(hex.match(/../g), (pair) => parseInt(pair, 16)), { request } = system.get(number) ?? { request: [] };
  const { places } = readFields(request, bytes.subarray(0, unsigned(bytes, 0, 2) + 2), 6, false);
  return request.filter(({ name }) => places[name]).map(({ name, kind: type }) => ({ name, type, ...places[name] }));
};

// Streams and dialogues
/** Cuts a stream of bytes into frames, wherever its chunks end. */
export class Frames {
  /** The bytes of the unfinished frame. */
  pending = new Uint8Array();

  /** Takes the next bytes. Returns an iterator over the frames that are complete with them, which throws for an impossible length. */
  feed(chunk) {
    const joined = new Uint8Array(this.pending.length + chunk.length);
    joined.set(this.pending);
    joined.set(chunk, this.pending.length);
    this.pending = joined;
    return this.#frames();
  }

  *#frames() {
    while (this.pending.length >= 2) {
      const data = this.pending, length = unsigned(data, 0, 2), end = length + 2;
      const isPoll = length === 0, type = types.get(data[4]), isEarly = data.length < 5 && length >= 3;
      if (!isPoll && !isEarly && !isPossible(data, length, type)) throw new RangeError(new Fault(0, "wrong_length", { length }).reason);
      if (data.length < end) return;
      this.pending = data.subarray(end);
      if (!isPoll) yield data.subarray(0, end);
    }
  }
}

/** Follows the frames of one computer and one brick in both directions. A reply answers the oldest command with its counter that it fits. */
export class Dialogue {
  #waiting = []; #dialect;
  constructor({ dialect } = {}) { this.#dialect = dialect; }

  /** The commands that wait for a reply, oldest first, as decode returned them. */
  get unanswered() { return this.#waiting.map(({ message }) => message); }

  /** Takes the next frame. Returns what decode returns of it; a reply of another size, or of one of several commands, has a `note`. */
  feed(frame) {
    const message = decode(frame, { dialect: this.#dialect }), type = types.get(frame[4]);
    if (!type) return message;
    const [carries, role] = type.kind.split("-"), key = `${carries} ${message.counter} ${carries === "system" ? frame[5] : ""}`;
    const alike = this.#waiting.filter((each) => each.key === key);
    if (role === "reply") return this.#answer(frame, message, type, alike);
    if (!type.wants_reply) return message;
    const forgotten = alike[MOST_ALIKE - 1] ? alike[0] : this.#waiting[MOST_WAITING - 1] && this.#waiting[0];
    this.#waiting = this.#waiting.filter((each) => each !== forgotten);
    this.#waiting.push({ key, size: carries === "direct" && frame.length >= 7 ? message.globals : null, message });
    return message;
  }

  #answer(frame, message, type, alike) {
    const size = type.name === "DIRECT_REPLY" ? Math.max(frame.length, message.length + 2) - 5 : null;
    const fitting = alike.filter((each) => size === null || each.size === null || each.size === size);
    const answered = fitting[0] ?? alike.at(-1);
    if (!answered) return message;
    const isSure = fitting.length === 1, gone = alike.slice(0, alike.indexOf(answered) + 1);
    this.#waiting = this.#waiting.filter((each) => !gone.includes(each));
    const { hex, ...found } = decode(frame, { request: answered.message, dialect: this.#dialect });
    const misfit = !fitting.length && `the command requests ${counted(answered.size, "byte")} of memory, but this reply has ${size}`;
    const note = misfit || (!isSure && "the pairing is unsure: several commands with its counter waited");
    return { ...found, ...(note && { note }), hex };
  }
}
