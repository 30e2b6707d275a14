// The lines and the header of one frame without Python, of what the exported decoder says: see first.js. A test holds them to Python's.

import { fieldsOf, parametersOf } from "./ev3-decode.mjs";
import { texts } from "./ev3-texts.mjs";

/** @typedef {import("./ev3-decode.mjs").Operation} Operation */
/** @typedef {import("./ev3-decode.mjs").Argument} Argument */
/** @typedef {import("./answer.js").Row} Row */
/** @typedef {any} Known  a message of a kind that was asked for */

/** Characters that steer a terminal, or hide a text within another. */
const HARMFUL = /[\0-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2060-\u206f\ufeff\ufff9-\ufffb\ufffe\uffff]/g;
const visible = (text = "") => text.replace(HARMFUL, (each) => `\\u${each.charCodeAt(0).toString(16).padStart(4, "0")}`);
const counted = (count = 0, noun = "") => `${count} ${noun}${count === 1 ? "" : "s"}`;
const spaced = (hex = "") => hex.toUpperCase().replace(/..(?=.)/g, "$& ");
const byteName = (byte = 0) => `0x${byte.toString(16).toUpperCase().padStart(2, "0")}`;
/** Returns the bytes of a text in hex. */
export const bytesOf = (hex = "") => Array.from(hex.match(/../g) ?? [], (pair) => parseInt(pair, 16));
const bytesText = (hex = "") => (hex.length <= 48 ? spaced(hex) : `${spaced(hex.slice(0, 48))} ... (${hex.length / 2} bytes)`);

/** Rounds as Python does, which takes the even digit of two that are equally near. @param {number} value @param {number} digits */
const rounded = (value, digits) => {
  const [mantissa = "", exponent] = value.toExponential(digits).split("e"), isExact = Number(`${mantissa}e${exponent}`) === value;
  return Number(isExact && /[02468]\.?5$/.test(mantissa) ? `${mantissa.slice(0, -1)}e${exponent}` : value.toExponential(digits - 1));
};
/** Returns a single-precision float in as few digits as identify it: `7.92`. @param {number | string} value */
const shortFloat = (value) => {
  if (typeof value === "string") return value;
  const number = [6, 7, 8, 9].map((digits) => rounded(value, digits)).find((each) => Math.fround(each) === value) ?? value;
  const [digits = "", exponent] = number.toExponential().split("e"), power = Number(exponent);
  if (number === 0) return "0.0";
  if (power < -4 || power >= 16) return `${digits}e${power < 0 ? "-" : "+"}${String(Math.abs(power)).padStart(2, "0")}`;
  return Number.isInteger(number) ? `${number}.0` : number.toFixed(Math.max(0, digits.replace(/\D/g, "").length - 1 - power));
};

/** Returns a line of the page. @param {string[][]} pieces @param {number} [offset] @param {number} [length] @param {string} [place] @returns {Row} */
const row = (pieces, offset = -1, length = 0, place = "") => {
  const found = /** @type {any[]} */ (pieces.filter(([text]) => text).map(([text = "", role]) => [visible(text), role]));
  const last = found.at(-1);
  last[0] = last[0].trimEnd();
  for (const piece of found) if (place && piece[1] === "operation") piece.push(place);
  return offset < 0 ? [found, -1, 0, 0] : [found, 0, offset, length];
};

const isVariable = (kind = "") => kind === "local" || kind === "global";
/** @param {Argument} argument @param {boolean} isFloat */
const argumentText = ({ kind, value, handle, address }, isFloat) => {
  let text = kind === "string" ? JSON.stringify(value) : isFloat ? shortFloat(value) : String(value);
  if (isVariable(kind)) text = `${kind === "local" ? "L" : "G"}V(${text})`;
  if (handle) text = `handle ${text}`;
  return address ? `address ${text}` : text;
};

const meaningOf = (/** @type {Argument} */ { symbol, value }, /** @type {Record<string, string>} */ special, unit = "") => symbol ?? special[value] ?? unit;
const formOf = (/** @type {Argument} */ { encoding, kind, length, offset, value }, /** @type {number[]} */ bytes) => (length === 1 && kind === "constant" && Number(value) < 0 ? `${encoding} ${byteName(bytes[offset])}` : encoding);
const saidOf = (/** @type {Argument} */ { quantity, unit }, said = "") => (quantity && unit ? `${quantity}, in ${unit}` : quantity ?? said);

/** @param {string} hex @param {Operation} operation @returns {Row[]} */
const operationRows = (hex, operation) => {
  const { op, command, offset, length, args, command_encoding: encoding } = operation, name = command === null ? op : `${op}.${command}`;
  const { area, text, parameters, special, each } = /** @type {Known} */ (texts.operations[name]), declared = parametersOf(operation), bytes = bytesOf(hex);
  const place = `${area}.html#${name.toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "")}`, at = (/** @type {number} */ each) => `  ${String(each).padStart(4)}  `;
  const rows = [row([[at(offset), "aside"], [name, "operation"], [`  ${text}`, "aside"]], offset, length, place)];
  if (encoding) {
    const width = Number(encoding.slice(2)), [value] = new Int32Array([bytes.slice(offset + 2, offset + 2 + width).reduceRight((all, byte) => all * 256 + byte, 0)]);
    rows.push(row([[`${at(offset + 1)}  CMD = ${value}`, "plain"], [`  ${encoding}`, "aside"]], offset + 1, 1 + width));
  }
  const width = Math.max(0, ...args.map((each) => each.name.length));
  args.forEach((argument, index) => {
    const { name, kind } = argument, { type, unit } = /** @type {Known} */ (declared[index]), last = Math.min(index, parameters.length - 1);
    const isFloat = kind === "constant" && argument.length === 5 && type === "DATAF", said = (name.endsWith("]") && each) || parameters[last];
    const meaning = isVariable(kind) || kind === "string" ? "" : meaningOf(argument, isFloat ? {} : special[last], unit);
    rows.push(row([
      [`${at(argument.offset)}  `, "aside"], [name.padEnd(width), "name"], [" = ", "plain"], [argumentText(argument, isFloat), "value"],
      [meaning && ` ${meaning}`, "meaning"], [`  ${formOf(argument, bytes)}: ${saidOf(argument, said)}`, "aside"],
    ], argument.offset, argument.length));
  });
  return rows;
};

/** @type {(kind: string, value: unknown) => string} */
const readingText = (kind, value) => {
  if (Array.isArray(value)) return `[${value.map((each) => readingText(kind, each)).join(", ")}]`;
  if (kind === "text" || kind === "string") return JSON.stringify(value);
  return kind === "DATAF" || kind === "number" ? shortFloat(/** @type {number} */ (value)) : String(value);
};
const readingsText = (/** @type {object} */ readings = {}) => Object.entries(readings).map(([name, value]) => `${name} ${readingText(name, value)}`).join(" or ");

/** @type {Record<string, number>} */
const HEAD = { "direct-command": 7, "system-command": 6, "system-reply": 7, "daisy-command": 8, "daisy-reply": 7, "direct-reply": 5 };
/** Whether a frame ends before what every message of its kind has. @param {Known} message */
const isHeadless = ({ kind, hex, length = 0 }) => Math.min(hex.length / 2, Math.max(length + 2, 5)) < (HEAD[kind] ?? 0);
const statusOf = (/** @type {Known} */ message) => message.status_name ?? `status ${message.status_code}`;
const commandOf = (/** @type {Known} */ message) => message.command ?? (isHeadless(message) ? "no command" : byteName(message.number));

/** Returns the fields of a header after the type. @type {(message: Known) => [name: string, offset: number, length: number, text: string][]} */
const morePartsOf = (message) => {
  const { kind, number, fields, globals, locals, status_code: code } = message, at = kind === "daisy-command" ? 6 : 5;
  const command = /** @type {ReturnType<typeof morePartsOf>} */ (number === undefined ? [] : [["command", 5, 1, `${byteName(number)} ${commandOf(message)}`]]);
  if (kind === "direct-command") return [["memory", 5, 2, `${globals} bytes global, for the reply; ${locals} bytes local, for its own use`]];
  if (kind === "system-reply") return [...command, ["status", 6, 1, `${code} ${statusOf(message)}`]];
  return kind.startsWith("daisy") ? [...command, ["layer_from", at, 1, String(fields.layer_from)], ["layer_to", at + 1, 1, String(fields.layer_to)]] : command;
};

/** Returns the fields of the header: their bytes, and what they say. @param {Known} message */
export const partsOf = (message) => {
  const { hex, type } = message, bytes = bytesOf(hex), size = bytes.length, [low = 0, high = 0, first = 0, second = 0, code = 0] = bytes;
  const stated = low + 256 * high, wrong = stated === size - 2 ? "" : ` according to it; in fact ${size - 2}`;
  /** @type {ReturnType<typeof morePartsOf>} */
  const parts = [["length", 0, 2, `${counted(stated, "byte")} after this field${wrong}`], ["counter", 2, 2, `${first + 256 * second}; a reply has the counter of its command`]];
  if (type) parts.push(["type", 4, 1, `${byteName(code)} ${type}: ${texts.message_types[type]}`]);
  if (type && !isHeadless(message)) parts.push(...morePartsOf(message));
  return parts.filter(([, offset, length]) => offset + length <= size).map(([name, offset, length, text]) => ({ name, offset, length, text }));
};

/** @type {(message: Known) => Row} */
const headingOf = (message) => {
  const { kind, type, hex, status, counter } = message, size = counted(hex.length / 2, "byte"), [result, color] = status === "error" ? [": error", "fault"] : [": ok", "value"];
  if (!type) return row([[`no EV3 message, ${size}`, "heading"]], 0, hex.length / 2);
  const pieces = [[type, "heading"], [`, counter ${counter}, ${size}`, "plain"]];
  if (kind === "system-reply" && isHeadless(message)) pieces.push([": no status", "fault"]);
  else if ("number" in message) pieces.push([": ", "plain"], [commandOf(message), "operation"], ...(kind === "system-reply" ? [[` ${statusOf(message)}`, color]] : []));
  else if (status) pieces.push([result, color]);
  if (kind.endsWith("reply")) pieces.push([` (the command it answers was not seen${type === "DIRECT_REPLY_ERROR" ? ": check that one to find the fault" : ""})`, "aside"]);
  return row(pieces, 0, hex.length / 2);
};

/** What is in a message, by its kind. @type {Record<string, (message: Known) => Row[]>} */
const CONTENTS = {
  direct: ({ kind, globals, locals, operations, hex, memory, readings }) => {
    if (kind === "direct-command") {
      const rows = globals || locals ? [row([[`  memory: ${globals} bytes global, ${locals} bytes local`, "aside"]], 5, 2)] : [];
      return [...rows, ...operations.flatMap((/** @type {Operation} */ each) => operationRows(hex, each))];
    }
    const meaning = readingsText(readings);
    return memory ? [row([[`     5  global memory: ${spaced(memory)}`, "plain"], [meaning && `  ${meaning}`, "meaning"]], 5, memory.length / 2)] : [];
  },
  system: (message) => {
    const { kind, number, fields, readings, status_meaning: said } = message, width = Math.max(0, ...Object.keys(fields).map((name) => name.length)), meaning = readingsText(readings);
    const text = kind === "system-command" ? texts.system_commands[number] : said;
    const rows = text ? [row([[`        ${text}`, kind === "system-command" ? "aside" : "meaning"]])] : [];
    return [...rows, ...fieldsOf(message).map(({ name, type, offset, length }) => {
      const value = fields[name], shown = type === "data" ? bytesText(value) : typeof value === "string" ? JSON.stringify(value) : String(value);
      return row([["        ", "plain"], [name.padEnd(width), "name"], [" = ", "plain"], [shown, "value"], [type === "data" && meaning ? `  ${meaning}` : "", "meaning"]], offset, length);
    })];
  },
  daisy: (message) => {
    const { command, hex, operations = [], fields: { layer_from: from, layer_to: to, payload, data, layer, port, type, mode, status } } = message;
    if (isHeadless(message)) return [];
    const line = (/** @type {string} */ text, role = "plain") => row([[`        ${text}`, role]]);
    const rows = [...(command ? [line(texts.daisy_commands[command] ?? "", "aside")] : []), line(`from layer ${from} to layer ${to}`)];
    if (operations.length) rows.push(...operations.flatMap((/** @type {Operation} */ each) => operationRows(hex, each)));
    else if (data !== undefined) rows.push(line(`layer ${layer} port ${port}: type ${type} mode ${mode} status ${status}`, "value"), line(`data ${bytesText(data)}`));
    else if (payload) rows.push(line(`payload ${bytesText(payload)}`));
    return rows;
  },
};
const lettersOf = (rest = "") => {
  const [head = 0, ...bytes] = bytesOf(rest), end = bytes.indexOf(0), text = String.fromCharCode(...(end < 0 ? bytes : bytes.slice(0, end)));
  return (head & 0xe3) === 0x80 && text && !/[\0-\x1f\x7f-\xa0\xad]/.test(text) ? `  "${text}..."` : "";
};

/** Returns the lines of a message. @param {Known} message @returns {Row[]} */
export const rowsOf = (message) => {
  const { kind, hex, fault, rest = "" } = message, size = hex.length / 2, rows = [headingOf(message), ...(CONTENTS[kind.split("-")[0]] ?? (() => []))(message)];
  const shown = `${spaced(rest.slice(0, 64))}${rest.length > 64 ? " ..." : ""}`;
  if (rest) rows.push(row([["        not read: ", "aside"], [shown, "plain"], [lettersOf(rest), "meaning"]], size - rest.length / 2, rest.length / 2));
  if (fault) rows.push(row([[`  fault at offset ${fault.offset}: ${fault.reason}`, "fault"]], fault.offset, 1));
  return rows;
};
