/**
 * The protocol of the LEGO MINDSTORMS EV3 for JavaScript: numbers by name, functions that make frames. Licence: MIT.
 *
 *     import { GV, directCommand, ops } from "./ev3.mjs";
 *
 *     directCommand([ops.SOUND.TONE(1, 440, 1000)], { counter: 42 });
 *     directCommand([ops.UI_READ.GET_VBATT(GV(0))], { counter: 43, globals: 4 });
 *
 * Names are the firmware's. A number gets its shortest encoding; what cannot be encoded is a RangeError.
 *
 * This file is made by ev3proto 0.2.0 from its tables (ev3proto export javascript): change those, not this.
 */

const ENCODING = Object.freeze({ LC0: 0x20, LV0: 0x40, GV0: 0x60, LCS_OLD: 0x80, LC1: 0x81, LC2: 0x82, LC4: 0x83, LCS: 0x84, LAB1: 0xa0, LV1: 0xc1, LV2: 0xc2, LV4: 0xc3, GV1: 0xe1, GV2: 0xe2, GV4: 0xe3 });
const HANDLE_BIT = 16;
const NAN_FLOAT = [0, 0, 192, 127];
const LENGTH_FIELD = 2;
const MAX_FRAME = 1024;
const MAX_GLOBALS = 1023;
const MAX_LOCALS = 63;
const GLOBAL_BITS = 10;

/** Message types */
export const MessageType = Object.freeze({
  DIRECT_COMMAND_REPLY: 0, DIRECT_COMMAND_NO_REPLY: 128, SYSTEM_COMMAND_REPLY: 1, SYSTEM_COMMAND_NO_REPLY: 129,
  DIRECT_REPLY: 2, DIRECT_REPLY_ERROR: 4, SYSTEM_REPLY: 3, SYSTEM_REPLY_ERROR: 5, DAISY_COMMAND_REPLY: 10,
  DAISY_COMMAND_NO_REPLY: 138, DAISY_REPLY: 8, DAISY_REPLY_ERROR: 9,
});

/** The status of a system command */
export const SystemStatus = Object.freeze({
  SUCCESS: 0, UNKNOWN_HANDLE: 1, HANDLE_NOT_READY: 2, CORRUPT_FILE: 3, NO_HANDLES_AVAILABLE: 4, NO_PERMISSION: 5,
  ILLEGAL_PATH: 6, FILE_EXITS: 7, END_OF_FILE: 8, SIZE_ERROR: 9, UNKNOWN_ERROR: 10, ILLEGAL_FILENAME: 11,
  ILLEGAL_CONNECTION: 12,
});

/** Opcodes */
export const Opcode = Object.freeze({
  ERROR: 0, NOP: 1, PROGRAM_STOP: 2, PROGRAM_START: 3, OBJECT_STOP: 4, OBJECT_START: 5, OBJECT_TRIG: 6, OBJECT_WAIT: 7,
  RETURN: 8, CALL: 9, OBJECT_END: 10, SLEEP: 11, PROGRAM_INFO: 12, LABEL: 13, PROBE: 14, DO: 15, SYSTEM: 96,
  PORT_CNV_OUTPUT: 97, PORT_CNV_INPUT: 98, NOTE_TO_FREQ: 99, INFO: 124, STRINGS: 125, BP0: 136, BP1: 137, BP2: 138,
  BP3: 139, BP_SET: 140, DYNLOAD_VMLOAD: 240, DYNLOAD_VMEXIT: 241, DYNLOAD_ENTRY_0: 242, DYNLOAD_ENTRY_1: 243,
  DYNLOAD_ENTRY_2: 244, DYNLOAD_ENTRY_3: 245, DYNLOAD_ENTRY_4: 246, DYNLOAD_ENTRY_5: 247, DYNLOAD_ENTRY_6: 248,
  DYNLOAD_ENTRY_7: 249, DYNLOAD_ENTRY_8: 250, DYNLOAD_ENTRY_9: 251, DYNLOAD_GET_VM: 252, TST: 255, ADD8: 16, ADD16: 17,
  ADD32: 18, ADDF: 19, SUB8: 20, SUB16: 21, SUB32: 22, SUBF: 23, MUL8: 24, MUL16: 25, MUL32: 26, MULF: 27, DIV8: 28,
  DIV16: 29, DIV32: 30, DIVF: 31, OR8: 32, OR16: 33, OR32: 34, AND8: 36, AND16: 37, AND32: 38, XOR8: 40, XOR16: 41,
  XOR32: 42, RL8: 44, RL16: 45, RL32: 46, MATH: 141, RANDOM: 142, INIT_BYTES: 47, MOVE8_8: 48, MOVE8_16: 49,
  MOVE8_32: 50, MOVE8_F: 51, MOVE16_8: 52, MOVE16_16: 53, MOVE16_32: 54, MOVE16_F: 55, MOVE32_8: 56, MOVE32_16: 57,
  MOVE32_32: 58, MOVE32_F: 59, MOVEF_8: 60, MOVEF_16: 61, MOVEF_32: 62, MOVEF_F: 63, READ8: 200, READ16: 201,
  READ32: 202, READF: 203, WRITE8: 204, WRITE16: 205, WRITE32: 206, WRITEF: 207, JR: 64, JR_FALSE: 65, JR_TRUE: 66,
  JR_NAN: 67, JR_LT8: 100, JR_LT16: 101, JR_LT32: 102, JR_LTF: 103, JR_GT8: 104, JR_GT16: 105, JR_GT32: 106,
  JR_GTF: 107, JR_EQ8: 108, JR_EQ16: 109, JR_EQ32: 110, JR_EQF: 111, JR_NEQ8: 112, JR_NEQ16: 113, JR_NEQ32: 114,
  JR_NEQF: 115, JR_LTEQ8: 116, JR_LTEQ16: 117, JR_LTEQ32: 118, JR_LTEQF: 119, JR_GTEQ8: 120, JR_GTEQ16: 121,
  JR_GTEQ32: 122, JR_GTEQF: 123, CP_LT8: 68, CP_LT16: 69, CP_LT32: 70, CP_LTF: 71, CP_GT8: 72, CP_GT16: 73, CP_GT32: 74,
  CP_GTF: 75, CP_EQ8: 76, CP_EQ16: 77, CP_EQ32: 78, CP_EQF: 79, CP_NEQ8: 80, CP_NEQ16: 81, CP_NEQ32: 82, CP_NEQF: 83,
  CP_LTEQ8: 84, CP_LTEQ16: 85, CP_LTEQ32: 86, CP_LTEQF: 87, CP_GTEQ8: 88, CP_GTEQ16: 89, CP_GTEQ32: 90, CP_GTEQF: 91,
  SELECT8: 92, SELECT16: 93, SELECT32: 94, SELECTF: 95, UI_FLUSH: 128, UI_READ: 129, UI_WRITE: 130, UI_BUTTON: 131,
  UI_DRAW: 132, KEEP_ALIVE: 144, TIMER_WAIT: 133, TIMER_READY: 134, TIMER_READ: 135, TIMER_READ_US: 143, SOUND: 148,
  SOUND_TEST: 149, SOUND_READY: 150, INPUT_SAMPLE: 151, INPUT_DEVICE_LIST: 152, INPUT_DEVICE: 153, INPUT_READ: 154,
  INPUT_TEST: 155, INPUT_READY: 156, INPUT_READSI: 157, INPUT_READEXT: 158, INPUT_WRITE: 159, INPUT_SET_CONN: 224,
  INPUT_IIC_READ: 225, INPUT_IIC_STATUS: 226, INPUT_IIC_WRITE: 227, INPUT_SET_AUTOID: 228, OUTPUT_GET_TYPE: 160,
  OUTPUT_SET_TYPE: 161, OUTPUT_RESET: 162, OUTPUT_STOP: 163, OUTPUT_POWER: 164, OUTPUT_SPEED: 165, OUTPUT_START: 166,
  OUTPUT_POLARITY: 167, OUTPUT_READ: 168, OUTPUT_TEST: 169, OUTPUT_READY: 170, OUTPUT_POSITION: 171,
  OUTPUT_STEP_POWER: 172, OUTPUT_TIME_POWER: 173, OUTPUT_STEP_SPEED: 174, OUTPUT_TIME_SPEED: 175, OUTPUT_STEP_SYNC: 176,
  OUTPUT_TIME_SYNC: 177, OUTPUT_CLR_COUNT: 178, OUTPUT_GET_COUNT: 179, OUTPUT_PRG_STOP: 180, MEMORY_WRITE: 126,
  MEMORY_READ: 127, FILE: 192, ARRAY: 193, ARRAY_WRITE: 194, ARRAY_READ: 195, ARRAY_APPEND: 196, MEMORY_USAGE: 197,
  FILENAME: 198, FILE_MD5SUM: 230, COM_READ: 145, COM_WRITE: 146, COM_READY: 208, COM_READDATA: 209, COM_WRITEDATA: 210,
  COM_GET: 211, COM_SET: 212, COM_TEST: 213, COM_REMOVE: 214, COM_WRITEFILE: 215, MAILBOX_OPEN: 216, MAILBOX_WRITE: 217,
  MAILBOX_READ: 218, MAILBOX_TEST: 219, MAILBOX_READY: 220, MAILBOX_CLOSE: 221, MAILBOX_SIZE: 229,
});

/** Types of devices on the ports; MODE_KEEP and TYPE_KEEP ask to leave mode or type as it is */
export const TYPE = Object.freeze({
  MODE_KEEP: -1, TYPE_KEEP: 0, TYPE_NXT_TOUCH: 1, TYPE_NXT_LIGHT: 2, TYPE_NXT_SOUND: 3, TYPE_NXT_COLOR: 4,
  TYPE_NXT_ULTRASONIC: 5, TYPE_NXT_TEMPERATURE: 6, TYPE_TACHO: 7, TYPE_MINITACHO: 8, TYPE_NEWTACHO: 9, TYPE_TOUCH: 16,
  TYPE_COLOR: 29, TYPE_ULTRASONIC: 30, TYPE_GYRO: 32, TYPE_IR: 33, TYPE_THIRD_PARTY_START: 50, TYPE_THIRD_PARTY_END: 98,
  TYPE_ENERGYMETER: 99, TYPE_IIC_UNKNOWN: 100, TYPE_NXT_TEST: 101, TYPE_NXT_IIC: 123, TYPE_TERMINAL: 124,
  TYPE_UNKNOWN: 125, TYPE_NONE: 126, TYPE_ERROR: 127,
});

/** Program slots of the virtual machine; direct commands run in CMD_SLOT */
export const SLOT = Object.freeze({
  GUI_SLOT: 0, USER_SLOT: 1, CMD_SLOT: 2, TERM_SLOT: 3, DEBUG_SLOT: 4, CURRENT_SLOT: -1,
});

/** Buttons of the brick */
export const BUTTONTYPE = Object.freeze({
  NO_BUTTON: 0, UP_BUTTON: 1, ENTER_BUTTON: 2, DOWN_BUTTON: 3, RIGHT_BUTTON: 4, LEFT_BUTTON: 5, BACK_BUTTON: 6,
  ANY_BUTTON: 7,
});

/** What the file browser on the display lists */
export const BROWSERTYPE = Object.freeze({
  BROWSE_FOLDERS: 0, BROWSE_FOLDS_FILES: 1, BROWSE_CACHE: 2, BROWSE_FILES: 3,
});

/** Fonts of the display */
export const FONTTYPE = Object.freeze({
  NORMAL_FONT: 0, SMALL_FONT: 1, LARGE_FONT: 2, TINY_FONT: 3,
});

/** Sets of icons; the set decides what an icon's number means */
export const ICONTYPE = Object.freeze({
  NORMAL_ICON: 0, SMALL_ICON: 1, LARGE_ICON: 2, MENU_ICON: 3, ARROW_ICON: 4,
});

/** Icons of the set SMALL_ICON: battery, Bluetooth, WiFi and USB in the top line */
export const S_ICON_NO = Object.freeze({
  SICON_CHARGING: 0, SICON_BATT_4: 1, SICON_BATT_3: 2, SICON_BATT_2: 3, SICON_BATT_1: 4, SICON_BATT_0: 5,
  SICON_WAIT1: 6, SICON_WAIT2: 7, SICON_BT_ON: 8, SICON_BT_VISIBLE: 9, SICON_BT_CONNECTED: 10, SICON_BT_CONNVISIB: 11,
  SICON_WIFI_3: 12, SICON_WIFI_2: 13, SICON_WIFI_1: 14, SICON_WIFI_CONNECTED: 15, SICON_USB: 21,
});

/** Icons of the set NORMAL_ICON: files, folders and settings */
export const N_ICON_NO = Object.freeze({
  ICON_NONE: -1, ICON_RUN: 0, ICON_FOLDER: 1, ICON_FOLDER2: 2, ICON_USB: 3, ICON_SD: 4, ICON_SOUND: 5, ICON_IMAGE: 6,
  ICON_SETTINGS: 7, ICON_ONOFF: 8, ICON_SEARCH: 9, ICON_WIFI: 10, ICON_CONNECTIONS: 11, ICON_ADD_HIDDEN: 12,
  ICON_TRASHBIN: 13, ICON_VISIBILITY: 14, ICON_KEY: 15, ICON_CONNECT: 16, ICON_DISCONNECT: 17, ICON_UP: 18,
  ICON_DOWN: 19, ICON_WAIT1: 20, ICON_WAIT2: 21, ICON_BLUETOOTH: 22, ICON_INFO: 23, ICON_TEXT: 24,
  ICON_QUESTIONMARK: 27, ICON_INFO_FILE: 28, ICON_DISC: 29, ICON_CONNECTED: 30, ICON_OBP: 31, ICON_OBD: 32,
  ICON_OPENFOLDER: 33, ICON_BRICK1: 34,
});

/** Icons of the set LARGE_ICON: answers, warnings and file operations */
export const L_ICON_NO = Object.freeze({
  YES_NOTSEL: 0, YES_SEL: 1, NO_NOTSEL: 2, NO_SEL: 3, OFF: 4, WAIT_VERT: 5, WAIT_HORZ: 6, TO_MANUAL: 7, WARNSIGN: 8,
  WARN_BATT: 9, WARN_POWER: 10, WARN_TEMP: 11, NO_USBSTICK: 12, TO_EXECUTE: 13, TO_BRICK: 14, TO_SDCARD: 15,
  TO_USBSTICK: 16, TO_BLUETOOTH: 17, TO_WIFI: 18, TO_TRASH: 19, TO_COPY: 20, TO_FILE: 21, CHAR_ERROR: 22,
  COPY_ERROR: 23, PROGRAM_ERROR: 24, WARN_MEMORY: 27,
});

/** Icons of the set MENU_ICON: kinds of Bluetooth peers, locks and check boxes */
export const M_ICON_NO = Object.freeze({
  ICON_STAR: 0, ICON_LOCKSTAR: 1, ICON_LOCK: 2, ICON_PC: 3, ICON_PHONE: 4, ICON_BRICK: 5, ICON_UNKNOWN: 6,
  ICON_FROM_FOLDER: 7, ICON_CHECKBOX: 8, ICON_CHECKED: 9, ICON_XED: 10,
});

/** Icons of the set ARROW_ICON: small arrows */
export const A_ICON_NO = Object.freeze({
  ICON_LEFT: 1, ICON_RIGHT: 2,
});

/** Kinds of Bluetooth peers, numbered like their icons in the set MENU_ICON */
export const BTTYPE = Object.freeze({
  BTTYPE_PC: 3, BTTYPE_PHONE: 4, BTTYPE_BRICK: 5, BTTYPE_UNKNOWN: 6,
});

/** Colours and rhythms of the light behind the buttons */
export const LEDPATTERN = Object.freeze({
  LED_BLACK: 0, LED_GREEN: 1, LED_RED: 2, LED_ORANGE: 3, LED_GREEN_FLASH: 4, LED_RED_FLASH: 5, LED_ORANGE_FLASH: 6,
  LED_GREEN_PULSE: 7, LED_RED_PULSE: 8, LED_ORANGE_PULSE: 9,
});

/** Single lights behind the buttons: right or left, red or green */
export const LEDTYPE = Object.freeze({
  LED_ALL: 0, LED_RR: 1, LED_RG: 2, LED_LR: 3, LED_LG: 4,
});

/** Kinds of files in the browser; it ORs TYPE_SDCARD or TYPE_USBSTICK to the kind found there */
export const FILETYPE = Object.freeze({
  FILETYPE_UNKNOWN: 0, TYPE_FOLDER: 1, TYPE_SOUND: 2, TYPE_BYTECODE: 3, TYPE_GRAPHICS: 4, TYPE_DATALOG: 5,
  TYPE_PROGRAM: 6, TYPE_TEXT: 7, TYPE_SDCARD: 16, TYPE_USBSTICK: 32, TYPE_RESTART_BROWSER: -1, TYPE_REFRESH_BROWSER: -2,
});

/** Result of an operation, or that it is still running */
export const RESULT = Object.freeze({
  OK: 0, BUSY: 1, FAIL: 2, STOP: 4, START: 8,
});

/** Formats of values, for sensors and mailboxes; FORMAT_TYPES has their types */
export const DATA_FORMAT = Object.freeze({
  DATA_8: 0, DATA_16: 1, DATA_32: 2, DATA_F: 3, DATA_S: 4, DATA_A: 5, DATA_V: 7, DATA_PCT: 16, DATA_RAW: 18,
  DATA_SI: 19,
});

/** Separators between two values in a text file */
export const DEL = Object.freeze({
  DEL_NONE: 0, DEL_TAB: 1, DEL_SPACE: 2, DEL_RETURN: 3, DEL_COLON: 4, DEL_COMMA: 5, DEL_LINEFEED: 6, DEL_CRLF: 7,
});

/** Carriers of the protocol */
export const HWTYPE = Object.freeze({
  HW_USB: 1, HW_BT: 2, HW_WIFI: 3,
});

/** Encryption of a WiFi network (official and compat firmware only) */
export const ENCRYPT = Object.freeze({
  ENCRYPT_NONE: 0, ENCRYPT_WPA2: 1,
});

/** Encryption of a WiFi network, under the names of the extended firmware (xtended firmware only) */
export const LMS_ENCRYPT = Object.freeze({
  LMS_ENCRYPT_NONE: 0, LMS_ENCRYPT_WPA2: 1,
});

/** Colour channels of the NXT colour sensor; BLANK is the reading without light */
export const COLOR = Object.freeze({
  RED: 0, GREEN: 1, BLUE: 2, BLANK: 3,
});

/** Colours that a colour sensor recognises */
export const NXTCOLOR = Object.freeze({
  BLACKCOLOR: 1, BLUECOLOR: 2, GREENCOLOR: 3, YELLOWCOLOR: 4, REDCOLOR: 5, WHITECOLOR: 6,
});

/** Warnings of the brick, one bit each; WARNINGS masks those shown to the user */
export const WARNING = Object.freeze({
  WARNING_TEMP: 1, WARNING_CURRENT: 2, WARNING_VOLTAGE: 4, WARNING_MEMORY: 8, WARNING_DSPSTAT: 16, WARNING_RAM: 32,
  WARNING_BATTLOW: 64, WARNING_BUSY: 128,
});

/** State of a program or object; one at a time, though each number is a single bit */
export const OBJSTAT = Object.freeze({
  RUNNING: 16, WAITING: 32, STOPPED: 64, HALTED: 128,
});

/** Commands to a UART sensor; DEVCMD_FIRE is another name of DEVCMD_RESET (compat lacks it) */
export const DEVCMD = Object.freeze({
  DEVCMD_RESET: 17, DEVCMD_FIRE: 17, DEVCMD_CHANNEL: 18,
});

/** Kinds of connection that a port detects */
export const CONN = Object.freeze({
  CONN_UNKNOWN: 111, CONN_DAISYCHAIN: 117, CONN_NXT_COLOR: 118, CONN_NXT_DUMB: 119, CONN_NXT_IIC: 120,
  CONN_INPUT_DUMB: 121, CONN_INPUT_UART: 122, CONN_OUTPUT_DUMB: 123, CONN_OUTPUT_INTELLIGENT: 124,
  CONN_OUTPUT_TACHO: 125, CONN_NONE: 126, CONN_ERROR: 127,
});

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

const data8 = integer(-127, 127);
const data16 = integer(-32767, 32767);
const data16Unsigned = integer(-32767, 65535);
const data32 = integer(-2147483647, 2147483647);
const handle = integer(-32767, 32767);
const label = integer(-2147483647, 2147483647);

/** A function for each operation, which returns its bytes. */
export const ops = Object.freeze({
  /** Ends the program with a failure; never valid on the wire */
  ERROR: () => operation(Opcode.ERROR),
  /** Does nothing; a harmless way to test whether the brick answers */
  NOP: () => operation(Opcode.NOP),
  /** Stops the program of a slot */
  PROGRAM_STOP: (PRGID) => operation(Opcode.PROGRAM_STOP, data16("PRGID", PRGID)),
  /** Starts a loaded program; a direct command can do this only while no user program runs */
  PROGRAM_START: (PRGID, SIZE, IP, DEBUG) => operation(
    Opcode.PROGRAM_START, data16("PRGID", PRGID), data32("SIZE", SIZE), data32("IP", IP), data8("DEBUG", DEBUG),
  ),
  /** Stops an object of its own program */
  OBJECT_STOP: (OBJID) => operation(Opcode.OBJECT_STOP, data16("OBJID", OBJID)),
  /** Starts an object of its own program */
  OBJECT_START: (OBJID) => operation(Opcode.OBJECT_START, data16("OBJID", OBJID)),
  /** Counts an object's trigger down; at zero the object starts */
  OBJECT_TRIG: (OBJID) => operation(Opcode.OBJECT_TRIG, data16("OBJID", OBJID)),
  /** Waits until an object has ended */
  OBJECT_WAIT: (OBJID) => operation(Opcode.OBJECT_WAIT, data16("OBJID", OBJID)),
  /** Returns from a subroutine to its caller */
  RETURN: () => operation(Opcode.RETURN),
  /** Calls a subroutine of its own program; waits while another thread runs it */
  CALL: (OBJID, PARAMETERS) => operation(Opcode.CALL, data16("OBJID", OBJID), list("PARAMETERS", PARAMETERS, any)),
  /** Ends the object; the firmware appends one to every direct command */
  OBJECT_END: () => operation(Opcode.OBJECT_END),
  /** Gives up the rest of the thread's time slice */
  SLEEP: () => operation(Opcode.SLEEP),
  /** Marks a place that jumps can name; does nothing itself */
  LABEL: (NO) => operation(Opcode.LABEL, label("NO", NO)),
  /** Prints a program's memory on the brick's debug terminal */
  PROBE: (PRGID, OBJID, OFFSET, SIZE) => operation(
    Opcode.PROBE, data16("PRGID", PRGID), data16("OBJID", OBJID), data32("OFFSET", OFFSET), data32("SIZE", SIZE),
  ),
  /** Runs byte code that is already in memory, ending the slot's previous program */
  DO: (PRGID, IMAGE, GLOBAL) => operation(
    Opcode.DO, data16("PRGID", PRGID), data32("IMAGE", IMAGE), data32("GLOBAL", GLOBAL),
  ),
  /** Runs a shell command on the brick's Linux and waits until it ends */
  SYSTEM: (COMMAND, STATUS) => operation(Opcode.SYSTEM, text("COMMAND", COMMAND), output("STATUS", STATUS)),
  /** Splits a motor port number as LEGO's editor writes it */
  PORT_CNV_OUTPUT: (PortIn, Layer, Bitfield, Inverted) => operation(
    Opcode.PORT_CNV_OUTPUT, data32("PortIn", PortIn), output("Layer", Layer), output("Bitfield", Bitfield),
    output("Inverted", Inverted),
  ),
  /** Splits a sensor port number as LEGO's editor writes it */
  PORT_CNV_INPUT: (PortIn, Layer, PortOut) => operation(
    Opcode.PORT_CNV_INPUT, data32("PortIn", PortIn), output("Layer", Layer), output("PortOut", PortOut),
  ),
  /** Converts the name of a note to its frequency */
  NOTE_TO_FREQ: (NOTE, FREQ) => operation(Opcode.NOTE_TO_FREQ, text("NOTE", NOTE), output("FREQ", FREQ)),
  /** Stops at breakpoint 0; BP_SET puts it over the instruction it replaces */
  BP0: () => operation(Opcode.BP0),
  /** Stops at breakpoint 1; BP_SET puts it over the instruction it replaces */
  BP1: () => operation(Opcode.BP1),
  /** Stops at breakpoint 2; BP_SET puts it over the instruction it replaces */
  BP2: () => operation(Opcode.BP2),
  /** Pulses test pin TP4 and continues; BP_SET puts it over the instruction it replaces */
  BP3: () => operation(Opcode.BP3),
  /** Sets or removes a breakpoint in a running program */
  BP_SET: (PRGID, NO, ADDRESS) => operation(
    Opcode.BP_SET, data16("PRGID", PRGID), data8("NO", NO), data32("ADDRESS", ADDRESS),
  ),
  /** Loads an additional virtual machine; fails while another one is loaded (xtended and compat firmware only) */
  DYNLOAD_VMLOAD: (VMINDEX, RESULT) => operation(
    Opcode.DYNLOAD_VMLOAD, data8("VMINDEX", VMINDEX), output("RESULT", RESULT),
  ),
  /** Unloads the additional virtual machine (xtended and compat firmware only) */
  DYNLOAD_VMEXIT: () => operation(Opcode.DYNLOAD_VMEXIT),
  /** Calls entry point 0 of the additional virtual machine that is loaded (xtended and compat firmware only) */
  DYNLOAD_ENTRY_0: (CMD, LENGTH_IN, LENGTH_OUT, VALUE) => operation(
    Opcode.DYNLOAD_ENTRY_0, data8("CMD", CMD), data8("LENGTH_IN", LENGTH_IN), output("LENGTH_OUT", LENGTH_OUT),
    output("VALUE", VALUE),
  ),
  /** Calls entry point 1 of the additional virtual machine that is loaded (xtended and compat firmware only) */
  DYNLOAD_ENTRY_1: (CMD, LENGTH_IN, LENGTH_OUT, VALUE) => operation(
    Opcode.DYNLOAD_ENTRY_1, data8("CMD", CMD), data8("LENGTH_IN", LENGTH_IN), output("LENGTH_OUT", LENGTH_OUT),
    output("VALUE", VALUE),
  ),
  /** Calls entry point 2 of the additional virtual machine that is loaded (xtended and compat firmware only) */
  DYNLOAD_ENTRY_2: (CMD, LENGTH_IN, LENGTH_OUT, VALUE) => operation(
    Opcode.DYNLOAD_ENTRY_2, data8("CMD", CMD), data8("LENGTH_IN", LENGTH_IN), output("LENGTH_OUT", LENGTH_OUT),
    output("VALUE", VALUE),
  ),
  /** Calls entry point 3 of the additional virtual machine that is loaded (xtended and compat firmware only) */
  DYNLOAD_ENTRY_3: (CMD, LENGTH_IN, LENGTH_OUT, VALUE) => operation(
    Opcode.DYNLOAD_ENTRY_3, data8("CMD", CMD), data8("LENGTH_IN", LENGTH_IN), output("LENGTH_OUT", LENGTH_OUT),
    output("VALUE", VALUE),
  ),
  /** Calls entry point 4 of the additional virtual machine that is loaded (xtended and compat firmware only) */
  DYNLOAD_ENTRY_4: (CMD, LENGTH_IN, LENGTH_OUT, VALUE) => operation(
    Opcode.DYNLOAD_ENTRY_4, data8("CMD", CMD), data8("LENGTH_IN", LENGTH_IN), output("LENGTH_OUT", LENGTH_OUT),
    output("VALUE", VALUE),
  ),
  /** Calls entry point 5 of the additional virtual machine that is loaded (xtended and compat firmware only) */
  DYNLOAD_ENTRY_5: (CMD, LENGTH_IN, LENGTH_OUT, VALUE) => operation(
    Opcode.DYNLOAD_ENTRY_5, data8("CMD", CMD), data8("LENGTH_IN", LENGTH_IN), output("LENGTH_OUT", LENGTH_OUT),
    output("VALUE", VALUE),
  ),
  /** Calls entry point 6 of the additional virtual machine that is loaded (xtended and compat firmware only) */
  DYNLOAD_ENTRY_6: (CMD, LENGTH_IN, LENGTH_OUT, VALUE) => operation(
    Opcode.DYNLOAD_ENTRY_6, data8("CMD", CMD), data8("LENGTH_IN", LENGTH_IN), output("LENGTH_OUT", LENGTH_OUT),
    output("VALUE", VALUE),
  ),
  /** Calls entry point 7 of the additional virtual machine that is loaded (xtended and compat firmware only) */
  DYNLOAD_ENTRY_7: (CMD, LENGTH_IN, LENGTH_OUT, VALUE) => operation(
    Opcode.DYNLOAD_ENTRY_7, data8("CMD", CMD), data8("LENGTH_IN", LENGTH_IN), output("LENGTH_OUT", LENGTH_OUT),
    output("VALUE", VALUE),
  ),
  /** Calls entry point 8 of the additional virtual machine that is loaded (xtended and compat firmware only) */
  DYNLOAD_ENTRY_8: (CMD, LENGTH_IN, LENGTH_OUT, VALUE) => operation(
    Opcode.DYNLOAD_ENTRY_8, data8("CMD", CMD), data8("LENGTH_IN", LENGTH_IN), output("LENGTH_OUT", LENGTH_OUT),
    output("VALUE", VALUE),
  ),
  /** Calls entry point 9 of the additional virtual machine that is loaded (xtended and compat firmware only) */
  DYNLOAD_ENTRY_9: (CMD, LENGTH_IN, LENGTH_OUT, VALUE) => operation(
    Opcode.DYNLOAD_ENTRY_9, data8("CMD", CMD), data8("LENGTH_IN", LENGTH_IN), output("LENGTH_OUT", LENGTH_OUT),
    output("VALUE", VALUE),
  ),
  /** Asks which additional virtual machine is loaded (xtended and compat firmware only) */
  DYNLOAD_GET_VM: (RESULT) => operation(Opcode.DYNLOAD_GET_VM, output("RESULT", RESULT)),
  /** Adds two 8-bit numbers */
  ADD8: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.ADD8, data8("SOURCE1", SOURCE1), data8("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Adds two 16-bit numbers */
  ADD16: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.ADD16, data16("SOURCE1", SOURCE1), data16("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Adds two 32-bit numbers */
  ADD32: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.ADD32, data32("SOURCE1", SOURCE1), data32("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Adds two floating-point numbers */
  ADDF: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.ADDF, float("SOURCE1", SOURCE1), float("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Subtracts one 8-bit number from another */
  SUB8: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.SUB8, data8("SOURCE1", SOURCE1), data8("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Subtracts one 16-bit number from another */
  SUB16: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.SUB16, data16("SOURCE1", SOURCE1), data16("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Subtracts one 32-bit number from another */
  SUB32: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.SUB32, data32("SOURCE1", SOURCE1), data32("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Subtracts one floating-point number from another */
  SUBF: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.SUBF, float("SOURCE1", SOURCE1), float("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Multiplies two 8-bit numbers */
  MUL8: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.MUL8, data8("SOURCE1", SOURCE1), data8("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Multiplies two 16-bit numbers */
  MUL16: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.MUL16, data16("SOURCE1", SOURCE1), data16("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Multiplies two 32-bit numbers */
  MUL32: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.MUL32, data32("SOURCE1", SOURCE1), data32("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Multiplies two floating-point numbers */
  MULF: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.MULF, float("SOURCE1", SOURCE1), float("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Divides two 8-bit numbers; by zero gives the largest or smallest value */
  DIV8: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.DIV8, data8("SOURCE1", SOURCE1), data8("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Divides two 16-bit numbers; by zero gives the largest or smallest value */
  DIV16: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.DIV16, data16("SOURCE1", SOURCE1), data16("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Divides two 32-bit numbers; by zero gives the largest or smallest value */
  DIV32: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.DIV32, data32("SOURCE1", SOURCE1), data32("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Divides two floating-point numbers; by zero gives infinity or NaN */
  DIVF: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.DIVF, float("SOURCE1", SOURCE1), float("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Combines 8-bit values, bit by bit, by OR */
  OR8: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.OR8, data8("SOURCE1", SOURCE1), data8("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Combines 16-bit values, bit by bit, by OR */
  OR16: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.OR16, data16("SOURCE1", SOURCE1), data16("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Combines 32-bit values, bit by bit, by OR */
  OR32: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.OR32, data32("SOURCE1", SOURCE1), data32("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Combines 8-bit values, bit by bit, by AND */
  AND8: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.AND8, data8("SOURCE1", SOURCE1), data8("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Combines 16-bit values, bit by bit, by AND */
  AND16: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.AND16, data16("SOURCE1", SOURCE1), data16("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Combines 32-bit values, bit by bit, by AND */
  AND32: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.AND32, data32("SOURCE1", SOURCE1), data32("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Combines 8-bit values, bit by bit, by exclusive OR */
  XOR8: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.XOR8, data8("SOURCE1", SOURCE1), data8("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Combines 16-bit values, bit by bit, by exclusive OR */
  XOR16: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.XOR16, data16("SOURCE1", SOURCE1), data16("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Combines 32-bit values, bit by bit, by exclusive OR */
  XOR32: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.XOR32, data32("SOURCE1", SOURCE1), data32("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Shifts 8-bit values left; despite the name (rotate), bits shifted out on the left are lost */
  RL8: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.RL8, data8("SOURCE1", SOURCE1), data8("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Shifts 16-bit values left; despite the name (rotate), bits shifted out on the left are lost */
  RL16: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.RL16, data16("SOURCE1", SOURCE1), data16("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Shifts 32-bit values left; despite the name (rotate), bits shifted out on the left are lost */
  RL32: (SOURCE1, SOURCE2, DESTINATION) => operation(
    Opcode.RL32, data32("SOURCE1", SOURCE1), data32("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
  ),
  /** Draws a random whole number */
  RANDOM: (MIN, MAX, VALUE) => operation(Opcode.RANDOM, data16("MIN", MIN), data16("MAX", MAX), output("VALUE", VALUE)),
  /** Fills consecutive bytes of memory with constant values */
  INIT_BYTES: (DESTINATION, SOURCE) => operation(
    Opcode.INIT_BYTES, output("DESTINATION", DESTINATION), list("SOURCE", SOURCE, data8),
  ),
  /** Copies a value to another variable, both 8-bit */
  MOVE8_8: (SOURCE, DESTINATION) => operation(
    Opcode.MOVE8_8, data8("SOURCE", SOURCE), output("DESTINATION", DESTINATION),
  ),
  /** Converts a value, 8-bit to 16-bit; NaN stays NaN */
  MOVE8_16: (SOURCE, DESTINATION) => operation(
    Opcode.MOVE8_16, data8("SOURCE", SOURCE), output("DESTINATION", DESTINATION),
  ),
  /** Converts a value, 8-bit to 32-bit; NaN stays NaN */
  MOVE8_32: (SOURCE, DESTINATION) => operation(
    Opcode.MOVE8_32, data8("SOURCE", SOURCE), output("DESTINATION", DESTINATION),
  ),
  /** Converts a value, 8-bit to floating-point; NaN stays NaN */
  MOVE8_F: (SOURCE, DESTINATION) => operation(
    Opcode.MOVE8_F, data8("SOURCE", SOURCE), output("DESTINATION", DESTINATION),
  ),
  /** Converts a value, 16-bit to 8-bit; limited to what fits, NaN stays NaN */
  MOVE16_8: (SOURCE, DESTINATION) => operation(
    Opcode.MOVE16_8, data16("SOURCE", SOURCE), output("DESTINATION", DESTINATION),
  ),
  /** Copies a value to another variable, both 16-bit */
  MOVE16_16: (SOURCE, DESTINATION) => operation(
    Opcode.MOVE16_16, data16("SOURCE", SOURCE), output("DESTINATION", DESTINATION),
  ),
  /** Converts a value, 16-bit to 32-bit; NaN stays NaN */
  MOVE16_32: (SOURCE, DESTINATION) => operation(
    Opcode.MOVE16_32, data16("SOURCE", SOURCE), output("DESTINATION", DESTINATION),
  ),
  /** Converts a value, 16-bit to floating-point; NaN stays NaN */
  MOVE16_F: (SOURCE, DESTINATION) => operation(
    Opcode.MOVE16_F, data16("SOURCE", SOURCE), output("DESTINATION", DESTINATION),
  ),
  /** Converts a value, 32-bit to 8-bit; limited to what fits, NaN stays NaN */
  MOVE32_8: (SOURCE, DESTINATION) => operation(
    Opcode.MOVE32_8, data32("SOURCE", SOURCE), output("DESTINATION", DESTINATION),
  ),
  /** Converts a value, 32-bit to 16-bit; limited to what fits, NaN stays NaN */
  MOVE32_16: (SOURCE, DESTINATION) => operation(
    Opcode.MOVE32_16, data32("SOURCE", SOURCE), output("DESTINATION", DESTINATION),
  ),
  /** Copies a value to another variable, both 32-bit */
  MOVE32_32: (SOURCE, DESTINATION) => operation(
    Opcode.MOVE32_32, data32("SOURCE", SOURCE), output("DESTINATION", DESTINATION),
  ),
  /** Converts a value, 32-bit to floating-point; NaN stays NaN */
  MOVE32_F: (SOURCE, DESTINATION) => operation(
    Opcode.MOVE32_F, data32("SOURCE", SOURCE), output("DESTINATION", DESTINATION),
  ),
  /** Converts a value, floating-point to 8-bit; limited to what fits, NaN stays NaN */
  MOVEF_8: (SOURCE, DESTINATION) => operation(
    Opcode.MOVEF_8, float("SOURCE", SOURCE), output("DESTINATION", DESTINATION),
  ),
  /** Converts a value, floating-point to 16-bit; limited to what fits, NaN stays NaN */
  MOVEF_16: (SOURCE, DESTINATION) => operation(
    Opcode.MOVEF_16, float("SOURCE", SOURCE), output("DESTINATION", DESTINATION),
  ),
  /** Converts a value, floating-point to 32-bit; limited to what fits, NaN stays NaN */
  MOVEF_32: (SOURCE, DESTINATION) => operation(
    Opcode.MOVEF_32, float("SOURCE", SOURCE), output("DESTINATION", DESTINATION),
  ),
  /** Copies a value to another variable, both floating-point */
  MOVEF_F: (SOURCE, DESTINATION) => operation(
    Opcode.MOVEF_F, float("SOURCE", SOURCE), output("DESTINATION", DESTINATION),
  ),
  /** Reads one element of an array of 8-bit values */
  READ8: (SOURCE, INDEX, DESTINATION) => operation(
    Opcode.READ8, data8("SOURCE", SOURCE), data8("INDEX", INDEX), output("DESTINATION", DESTINATION),
  ),
  /** Reads one element of an array of 16-bit values */
  READ16: (SOURCE, INDEX, DESTINATION) => operation(
    Opcode.READ16, data16("SOURCE", SOURCE), data8("INDEX", INDEX), output("DESTINATION", DESTINATION),
  ),
  /** Reads one element of an array of 32-bit values */
  READ32: (SOURCE, INDEX, DESTINATION) => operation(
    Opcode.READ32, data32("SOURCE", SOURCE), data8("INDEX", INDEX), output("DESTINATION", DESTINATION),
  ),
  /** Reads one element of an array of floating-point values */
  READF: (SOURCE, INDEX, DESTINATION) => operation(
    Opcode.READF, float("SOURCE", SOURCE), data8("INDEX", INDEX), output("DESTINATION", DESTINATION),
  ),
  /** Writes one element of an array of 8-bit values */
  WRITE8: (SOURCE, INDEX, DESTINATION) => operation(
    Opcode.WRITE8, data8("SOURCE", SOURCE), data8("INDEX", INDEX), data8("DESTINATION", DESTINATION),
  ),
  /** Writes one element of an array of 16-bit values */
  WRITE16: (SOURCE, INDEX, DESTINATION) => operation(
    Opcode.WRITE16, data16("SOURCE", SOURCE), data8("INDEX", INDEX), data16("DESTINATION", DESTINATION),
  ),
  /** Writes one element of an array of 32-bit values */
  WRITE32: (SOURCE, INDEX, DESTINATION) => operation(
    Opcode.WRITE32, data32("SOURCE", SOURCE), data8("INDEX", INDEX), data32("DESTINATION", DESTINATION),
  ),
  /** Writes one element of an array of floating-point values */
  WRITEF: (SOURCE, INDEX, DESTINATION) => operation(
    Opcode.WRITEF, float("SOURCE", SOURCE), data8("INDEX", INDEX), float("DESTINATION", DESTINATION),
  ),
  /** Jumps always */
  JR: (OFFSET) => operation(Opcode.JR, label("OFFSET", OFFSET)),
  /** Jumps if a flag is 0 */
  JR_FALSE: (FLAG, OFFSET) => operation(Opcode.JR_FALSE, data8("FLAG", FLAG), label("OFFSET", OFFSET)),
  /** Jumps if a flag is not 0 */
  JR_TRUE: (FLAG, OFFSET) => operation(Opcode.JR_TRUE, data8("FLAG", FLAG), label("OFFSET", OFFSET)),
  /** Jumps if a value is not a number, as read from a sensor without data */
  JR_NAN: (VALUE, OFFSET) => operation(Opcode.JR_NAN, float("VALUE", VALUE), label("OFFSET", OFFSET)),
  /** Jumps if LEFT is less than RIGHT, as 8-bit numbers */
  JR_LT8: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_LT8, data8("LEFT", LEFT), data8("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is less than RIGHT, as 16-bit numbers */
  JR_LT16: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_LT16, data16("LEFT", LEFT), data16("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is less than RIGHT, as 32-bit numbers */
  JR_LT32: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_LT32, data32("LEFT", LEFT), data32("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is less than RIGHT, as floating-point numbers */
  JR_LTF: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_LTF, float("LEFT", LEFT), float("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is greater than RIGHT, as 8-bit numbers */
  JR_GT8: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_GT8, data8("LEFT", LEFT), data8("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is greater than RIGHT, as 16-bit numbers */
  JR_GT16: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_GT16, data16("LEFT", LEFT), data16("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is greater than RIGHT, as 32-bit numbers */
  JR_GT32: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_GT32, data32("LEFT", LEFT), data32("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is greater than RIGHT, as floating-point numbers */
  JR_GTF: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_GTF, float("LEFT", LEFT), float("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is equal to RIGHT, as 8-bit numbers */
  JR_EQ8: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_EQ8, data8("LEFT", LEFT), data8("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is equal to RIGHT, as 16-bit numbers */
  JR_EQ16: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_EQ16, data16("LEFT", LEFT), data16("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is equal to RIGHT, as 32-bit numbers */
  JR_EQ32: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_EQ32, data32("LEFT", LEFT), data32("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is equal to RIGHT, as floating-point numbers */
  JR_EQF: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_EQF, float("LEFT", LEFT), float("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is different from RIGHT, as 8-bit numbers */
  JR_NEQ8: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_NEQ8, data8("LEFT", LEFT), data8("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is different from RIGHT, as 16-bit numbers */
  JR_NEQ16: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_NEQ16, data16("LEFT", LEFT), data16("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is different from RIGHT, as 32-bit numbers */
  JR_NEQ32: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_NEQ32, data32("LEFT", LEFT), data32("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is different from RIGHT, as floating-point numbers */
  JR_NEQF: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_NEQF, float("LEFT", LEFT), float("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is less than or equal to RIGHT, as 8-bit numbers */
  JR_LTEQ8: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_LTEQ8, data8("LEFT", LEFT), data8("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is less than or equal to RIGHT, as 16-bit numbers */
  JR_LTEQ16: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_LTEQ16, data16("LEFT", LEFT), data16("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is less than or equal to RIGHT, as 32-bit numbers */
  JR_LTEQ32: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_LTEQ32, data32("LEFT", LEFT), data32("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is less than or equal to RIGHT, as floating-point numbers */
  JR_LTEQF: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_LTEQF, float("LEFT", LEFT), float("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is greater than or equal to RIGHT, as 8-bit numbers */
  JR_GTEQ8: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_GTEQ8, data8("LEFT", LEFT), data8("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is greater than or equal to RIGHT, as 16-bit numbers */
  JR_GTEQ16: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_GTEQ16, data16("LEFT", LEFT), data16("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is greater than or equal to RIGHT, as 32-bit numbers */
  JR_GTEQ32: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_GTEQ32, data32("LEFT", LEFT), data32("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Jumps if LEFT is greater than or equal to RIGHT, as floating-point numbers */
  JR_GTEQF: (LEFT, RIGHT, OFFSET) => operation(
    Opcode.JR_GTEQF, float("LEFT", LEFT), float("RIGHT", RIGHT), label("OFFSET", OFFSET),
  ),
  /** Tests whether LEFT is less than RIGHT, as 8-bit numbers */
  CP_LT8: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_LT8, data8("LEFT", LEFT), data8("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is less than RIGHT, as 16-bit numbers */
  CP_LT16: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_LT16, data16("LEFT", LEFT), data16("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is less than RIGHT, as 32-bit numbers */
  CP_LT32: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_LT32, data32("LEFT", LEFT), data32("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is less than RIGHT, as floating-point numbers */
  CP_LTF: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_LTF, float("LEFT", LEFT), float("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is greater than RIGHT, as 8-bit numbers */
  CP_GT8: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_GT8, data8("LEFT", LEFT), data8("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is greater than RIGHT, as 16-bit numbers */
  CP_GT16: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_GT16, data16("LEFT", LEFT), data16("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is greater than RIGHT, as 32-bit numbers */
  CP_GT32: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_GT32, data32("LEFT", LEFT), data32("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is greater than RIGHT, as floating-point numbers */
  CP_GTF: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_GTF, float("LEFT", LEFT), float("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is equal to RIGHT, as 8-bit numbers */
  CP_EQ8: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_EQ8, data8("LEFT", LEFT), data8("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is equal to RIGHT, as 16-bit numbers */
  CP_EQ16: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_EQ16, data16("LEFT", LEFT), data16("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is equal to RIGHT, as 32-bit numbers */
  CP_EQ32: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_EQ32, data32("LEFT", LEFT), data32("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is equal to RIGHT, as floating-point numbers */
  CP_EQF: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_EQF, float("LEFT", LEFT), float("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is different from RIGHT, as 8-bit numbers */
  CP_NEQ8: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_NEQ8, data8("LEFT", LEFT), data8("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is different from RIGHT, as 16-bit numbers */
  CP_NEQ16: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_NEQ16, data16("LEFT", LEFT), data16("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is different from RIGHT, as 32-bit numbers */
  CP_NEQ32: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_NEQ32, data32("LEFT", LEFT), data32("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is different from RIGHT, as floating-point numbers */
  CP_NEQF: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_NEQF, float("LEFT", LEFT), float("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is less than or equal to RIGHT, as 8-bit numbers */
  CP_LTEQ8: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_LTEQ8, data8("LEFT", LEFT), data8("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is less than or equal to RIGHT, as 16-bit numbers */
  CP_LTEQ16: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_LTEQ16, data16("LEFT", LEFT), data16("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is less than or equal to RIGHT, as 32-bit numbers */
  CP_LTEQ32: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_LTEQ32, data32("LEFT", LEFT), data32("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is less than or equal to RIGHT, as floating-point numbers */
  CP_LTEQF: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_LTEQF, float("LEFT", LEFT), float("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is greater than or equal to RIGHT, as 8-bit numbers */
  CP_GTEQ8: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_GTEQ8, data8("LEFT", LEFT), data8("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is greater than or equal to RIGHT, as 16-bit numbers */
  CP_GTEQ16: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_GTEQ16, data16("LEFT", LEFT), data16("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is greater than or equal to RIGHT, as 32-bit numbers */
  CP_GTEQ32: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_GTEQ32, data32("LEFT", LEFT), data32("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Tests whether LEFT is greater than or equal to RIGHT, as floating-point numbers */
  CP_GTEQF: (LEFT, RIGHT, FLAG) => operation(
    Opcode.CP_GTEQF, float("LEFT", LEFT), float("RIGHT", RIGHT), output("FLAG", FLAG),
  ),
  /** Selects one of two 8-bit values by a flag */
  SELECT8: (FLAG, SOURCE1, SOURCE2, RESULT) => operation(
    Opcode.SELECT8, data8("FLAG", FLAG), data8("SOURCE1", SOURCE1), data8("SOURCE2", SOURCE2),
    output("RESULT", RESULT),
  ),
  /** Selects one of two 16-bit values by a flag */
  SELECT16: (FLAG, SOURCE1, SOURCE2, RESULT) => operation(
    Opcode.SELECT16, data8("FLAG", FLAG), data16("SOURCE1", SOURCE1), data16("SOURCE2", SOURCE2),
    output("RESULT", RESULT),
  ),
  /** Selects one of two 32-bit values by a flag */
  SELECT32: (FLAG, SOURCE1, SOURCE2, RESULT) => operation(
    Opcode.SELECT32, data8("FLAG", FLAG), data32("SOURCE1", SOURCE1), data32("SOURCE2", SOURCE2),
    output("RESULT", RESULT),
  ),
  /** Selects one of two floating-point values by a flag */
  SELECTF: (FLAG, SOURCE1, SOURCE2, RESULT) => operation(
    Opcode.SELECTF, data8("FLAG", FLAG), float("SOURCE1", SOURCE1), float("SOURCE2", SOURCE2),
    output("RESULT", RESULT),
  ),
  /** Sends the contents of the terminal's output buffer */
  UI_FLUSH: () => operation(Opcode.UI_FLUSH),
  /** Restarts the timer that switches off an idle brick, and reads its time */
  KEEP_ALIVE: (MINUTES) => operation(Opcode.KEEP_ALIVE, output("MINUTES", MINUTES)),
  /** Stores the end of a wait and returns at once; TIMER_READY does the waiting */
  TIMER_WAIT: (TIME, TIMER) => operation(Opcode.TIMER_WAIT, data32("TIME", TIME), output("TIMER", TIMER)),
  /** Waits until the time that TIMER_WAIT stored */
  TIMER_READY: (TIMER) => operation(Opcode.TIMER_READY, data32("TIMER", TIMER)),
  /** Reads the time since the start of the program or direct command that asks */
  TIMER_READ: (TIME) => operation(Opcode.TIMER_READ, output("TIME", TIME)),
  /** Reads the free-running microsecond clock, for differences only */
  TIMER_READ_US: (TIME) => operation(Opcode.TIMER_READ_US, output("TIME", TIME)),
  /** Reports whether a sound is playing */
  SOUND_TEST: (BUSY) => operation(Opcode.SOUND_TEST, output("BUSY", BUSY)),
  /** Waits until the sound has ended (forever after REPEAT, an endless tone or a missing file) */
  SOUND_READY: () => operation(Opcode.SOUND_READY),
  /** Reads one SI value of each of several devices, sampled in the background */
  INPUT_SAMPLE: (TIME, SAMPLES, INIT, DEVICES, TYPES, MODES, DATASETS, VALUES) => operation(
    Opcode.INPUT_SAMPLE, data32("TIME", TIME), data16("SAMPLES", SAMPLES), data16("INIT", INIT),
    data8("DEVICES", DEVICES), data8("TYPES", TYPES), data8("MODES", MODES), data8("DATASETS", DATASETS),
    output("VALUES", VALUES),
  ),
  /** Lists the types of all devices, sensor ports of each layer first, then motor ports */
  INPUT_DEVICE_LIST: (LENGTH, ARRAY, CHANGED) => operation(
    Opcode.INPUT_DEVICE_LIST, data8("LENGTH", LENGTH), output("ARRAY", ARRAY), output("CHANGED", CHANGED),
  ),
  /** Sets type and mode and reads the first value in percent at once */
  INPUT_READ: (LAYER, NO, TYPE, MODE, PCT) => operation(
    Opcode.INPUT_READ, data8("LAYER", LAYER), data8("NO", NO), data8("TYPE", TYPE), data8("MODE", MODE),
    output("PCT", PCT),
  ),
  /** Reports whether a device is still changing type or mode */
  INPUT_TEST: (LAYER, NO, BUSY) => operation(
    Opcode.INPUT_TEST, data8("LAYER", LAYER), data8("NO", NO), output("BUSY", BUSY),
  ),
  /** Waits until a device has valid values */
  INPUT_READY: (LAYER, NO) => operation(Opcode.INPUT_READY, data8("LAYER", LAYER), data8("NO", NO)),
  /** Sets type and mode and reads the first value in SI units at once */
  INPUT_READSI: (LAYER, NO, TYPE, MODE, SI) => operation(
    Opcode.INPUT_READSI, data8("LAYER", LAYER), data8("NO", NO), data8("TYPE", TYPE), data8("MODE", MODE),
    output("SI", SI),
  ),
  /** Sets type and mode and reads several values at once, in the format asked for */
  INPUT_READEXT: (LAYER, NO, TYPE, MODE, FORMAT, VALUES) => operation(
    Opcode.INPUT_READEXT, data8("LAYER", LAYER), data8("NO", NO), data8("TYPE", TYPE), data8("MODE", MODE),
    data8("FORMAT", FORMAT), list("VALUES", VALUES, output),
  ),
  /** Sends bytes to a UART sensor */
  INPUT_WRITE: (LAYER, NO, BYTES, DATA) => operation(
    Opcode.INPUT_WRITE, data8("LAYER", LAYER), data8("NO", NO), data8("BYTES", BYTES), data8("DATA", DATA),
  ),
  /** Sets how a port is connected, for ports whose automatic detection is off (xtended and compat firmware only) */
  INPUT_SET_CONN: (LAYER, NO, CONN) => operation(
    Opcode.INPUT_SET_CONN, data8("LAYER", LAYER), data8("NO", NO), data8("CONN", CONN),
  ),
  /** Fetches the bytes that an I2C sensor answered to INPUT_IIC_WRITE (xtended and compat firmware only) */
  INPUT_IIC_READ: (LAYER, NO, RDLNG, RDDATA, RESULT) => operation(
    Opcode.INPUT_IIC_READ, data8("LAYER", LAYER), data8("NO", NO), data8("RDLNG", RDLNG), output("RDDATA", RDDATA),
    output("RESULT", RESULT),
  ),
  /** Reports the state of the I2C bus of a port (xtended and compat firmware only) */
  INPUT_IIC_STATUS: (LAYER, NO, RESULT) => operation(
    Opcode.INPUT_IIC_STATUS, data8("LAYER", LAYER), data8("NO", NO), output("RESULT", RESULT),
  ),
  /** Sends bytes to an I2C sensor once, without waiting for its answer (xtended and compat firmware only) */
  INPUT_IIC_WRITE: (LAYER, NO, WRLNG, WRDATA, RDLNG, RESULT) => operation(
    Opcode.INPUT_IIC_WRITE, data8("LAYER", LAYER), data8("NO", NO), data8("WRLNG", WRLNG), data8("WRDATA", WRDATA),
    data8("RDLNG", RDLNG), output("RESULT", RESULT),
  ),
  /** Switches the automatic detection of sensors at a port on or off (xtended and compat firmware only) */
  INPUT_SET_AUTOID: (LAYER, NO, ENABLE) => operation(
    Opcode.INPUT_SET_AUTOID, data8("LAYER", LAYER), data8("NO", NO), data8("ENABLE", ENABLE),
  ),
  /** Reports the type of motor at a port; documented, but not implemented by any firmware (not in any firmware) */
  OUTPUT_GET_TYPE: (LAYER, NO, TYPE) => operation(
    Opcode.OUTPUT_GET_TYPE, data8("LAYER", LAYER), data8("NO", NO), output("TYPE", TYPE),
  ),
  /** Declares which type of motor is at a port */
  OUTPUT_SET_TYPE: (LAYER, NO, TYPE) => operation(
    Opcode.OUTPUT_SET_TYPE, data8("LAYER", LAYER), data8("NO", NO), data8("TYPE", TYPE),
  ),
  /** Sets the tacho counts that moves and OUTPUT_READ use to zero */
  OUTPUT_RESET: (LAYER, NOS) => operation(Opcode.OUTPUT_RESET, data8("LAYER", LAYER), data8("NOS", NOS)),
  /** Stops motors */
  OUTPUT_STOP: (LAYER, NOS, BRAKE) => operation(
    Opcode.OUTPUT_STOP, data8("LAYER", LAYER), data8("NOS", NOS), data8("BRAKE", BRAKE),
  ),
  /** Sets the power of motors, which run at the next OUTPUT_START */
  OUTPUT_POWER: (LAYER, NOS, POWER) => operation(
    Opcode.OUTPUT_POWER, data8("LAYER", LAYER), data8("NOS", NOS), data8("POWER", POWER),
  ),
  /** Sets the speed of motors, which run at the next OUTPUT_START */
  OUTPUT_SPEED: (LAYER, NOS, SPEED) => operation(
    Opcode.OUTPUT_SPEED, data8("LAYER", LAYER), data8("NOS", NOS), data8("SPEED", SPEED),
  ),
  /** Starts motors with the power or speed set before */
  OUTPUT_START: (LAYER, NOS) => operation(Opcode.OUTPUT_START, data8("LAYER", LAYER), data8("NOS", NOS)),
  /** Sets the direction of motors */
  OUTPUT_POLARITY: (LAYER, NOS, POL) => operation(
    Opcode.OUTPUT_POLARITY, data8("LAYER", LAYER), data8("NOS", NOS), data8("POL", POL),
  ),
  /** Reads speed and tacho count of one motor, 0 on layers other than 0 */
  OUTPUT_READ: (LAYER, NO, SPEED, TACHO) => operation(
    Opcode.OUTPUT_READ, data8("LAYER", LAYER), data8("NO", NO), output("SPEED", SPEED), output("TACHO", TACHO),
  ),
  /** Reports whether one of the motors is still in a move that ends by itself */
  OUTPUT_TEST: (LAYER, NOS, BUSY) => operation(
    Opcode.OUTPUT_TEST, data8("LAYER", LAYER), data8("NOS", NOS), output("BUSY", BUSY),
  ),
  /** Waits until the moves of the motors have ended; ignores those from OUTPUT_START */
  OUTPUT_READY: (LAYER, NOS) => operation(Opcode.OUTPUT_READY, data8("LAYER", LAYER), data8("NOS", NOS)),
  /** Reports the position of motors; documented, but not implemented by any firmware (not in any firmware) */
  OUTPUT_POSITION: (LAYER, NOS, POS) => operation(
    Opcode.OUTPUT_POSITION, data8("LAYER", LAYER), data8("NOS", NOS), output("POS", POS),
  ),
  /** Turns motors by an angle with unregulated power */
  OUTPUT_STEP_POWER: (LAYER, NOS, POWER, STEP1, STEP2, STEP3, BRAKE) => operation(
    Opcode.OUTPUT_STEP_POWER, data8("LAYER", LAYER), data8("NOS", NOS), data8("POWER", POWER), data32("STEP1", STEP1),
    data32("STEP2", STEP2), data32("STEP3", STEP3), data8("BRAKE", BRAKE),
  ),
  /** Runs motors for a time with unregulated power */
  OUTPUT_TIME_POWER: (LAYER, NOS, POWER, TIME1, TIME2, TIME3, BRAKE) => operation(
    Opcode.OUTPUT_TIME_POWER, data8("LAYER", LAYER), data8("NOS", NOS), data8("POWER", POWER), data32("TIME1", TIME1),
    data32("TIME2", TIME2), data32("TIME3", TIME3), data8("BRAKE", BRAKE),
  ),
  /** Turns motors by an angle with regulated speed */
  OUTPUT_STEP_SPEED: (LAYER, NOS, SPEED, STEP1, STEP2, STEP3, BRAKE) => operation(
    Opcode.OUTPUT_STEP_SPEED, data8("LAYER", LAYER), data8("NOS", NOS), data8("SPEED", SPEED), data32("STEP1", STEP1),
    data32("STEP2", STEP2), data32("STEP3", STEP3), data8("BRAKE", BRAKE),
  ),
  /** Runs motors for a time with regulated speed */
  OUTPUT_TIME_SPEED: (LAYER, NOS, SPEED, TIME1, TIME2, TIME3, BRAKE) => operation(
    Opcode.OUTPUT_TIME_SPEED, data8("LAYER", LAYER), data8("NOS", NOS), data8("SPEED", SPEED), data32("TIME1", TIME1),
    data32("TIME2", TIME2), data32("TIME3", TIME3), data8("BRAKE", BRAKE),
  ),
  /** Turns two motors in step by an angle */
  OUTPUT_STEP_SYNC: (LAYER, NOS, SPEED, TURN, STEP, BRAKE) => operation(
    Opcode.OUTPUT_STEP_SYNC, data8("LAYER", LAYER), data8("NOS", NOS), data8("SPEED", SPEED), data16("TURN", TURN),
    data32("STEP", STEP), data8("BRAKE", BRAKE),
  ),
  /** Runs two motors in step for a time */
  OUTPUT_TIME_SYNC: (LAYER, NOS, SPEED, TURN, TIME, BRAKE) => operation(
    Opcode.OUTPUT_TIME_SYNC, data8("LAYER", LAYER), data8("NOS", NOS), data8("SPEED", SPEED), data16("TURN", TURN),
    data32("TIME", TIME), data8("BRAKE", BRAKE),
  ),
  /** Sets the tacho counts of motors read as sensors to zero */
  OUTPUT_CLR_COUNT: (LAYER, NOS) => operation(Opcode.OUTPUT_CLR_COUNT, data8("LAYER", LAYER), data8("NOS", NOS)),
  /** Reads the tacho count of a motor read as a sensor */
  OUTPUT_GET_COUNT: (LAYER, NOS, TACHO) => operation(
    Opcode.OUTPUT_GET_COUNT, data8("LAYER", LAYER), data8("NOS", NOS), output("TACHO", TACHO),
  ),
  /** Stops and resets all motors as the end of a program does */
  OUTPUT_PRG_STOP: () => operation(Opcode.OUTPUT_PRG_STOP),
  /** Writes bytes into the variables of a running program */
  MEMORY_WRITE: (PRGID, OBJID, OFFSET, SIZE, ARRAY) => operation(
    Opcode.MEMORY_WRITE, data16("PRGID", PRGID), data16("OBJID", OBJID), data32("OFFSET", OFFSET),
    data32("SIZE", SIZE), data8("ARRAY", ARRAY),
  ),
  /** Reads bytes from the variables of a running program */
  MEMORY_READ: (PRGID, OBJID, OFFSET, SIZE, ARRAY) => operation(
    Opcode.MEMORY_READ, data16("PRGID", PRGID), data16("OBJID", OBJID), data32("OFFSET", OFFSET),
    data32("SIZE", SIZE), output("ARRAY", ARRAY),
  ),
  /** Writes one element of an array, which grows where needed */
  ARRAY_WRITE: (HANDLE, INDEX, VALUE) => operation(
    Opcode.ARRAY_WRITE, handle("HANDLE", HANDLE), data32("INDEX", INDEX), any("VALUE", VALUE),
  ),
  /** Reads one element of an array */
  ARRAY_READ: (HANDLE, INDEX, VALUE) => operation(
    Opcode.ARRAY_READ, handle("HANDLE", HANDLE), data32("INDEX", INDEX), output("VALUE", VALUE),
  ),
  /** Adds one element to the end of an array */
  ARRAY_APPEND: (HANDLE, VALUE) => operation(Opcode.ARRAY_APPEND, handle("HANDLE", HANDLE), any("VALUE", VALUE)),
  /** Reports the total and free memory for user files */
  MEMORY_USAGE: (TOTAL, FREE) => operation(Opcode.MEMORY_USAGE, output("TOTAL", TOTAL), output("FREE", FREE)),
  /** Computes the MD5 digest of a file (xtended and compat firmware only) */
  FILE_MD5SUM: (NAME, MD5SUM, SUCCESS) => operation(
    Opcode.FILE_MD5SUM, text("NAME", NAME), output("MD5SUM", MD5SUM), output("SUCCESS", SUCCESS),
  ),
  /** Waits until nothing is being sent to a device */
  COM_READY: (HARDWARE, NAME) => operation(Opcode.COM_READY, data8("HARDWARE", HARDWARE), text("NAME", NAME)),
  /** Does nothing in the firmware; meant to receive data */
  COM_READDATA: (VALUE1, VALUE2, VALUE3, VALUE4) => operation(
    Opcode.COM_READDATA, data8("VALUE1", VALUE1), data8("VALUE2", VALUE2), data16("VALUE3", VALUE3),
    data8("VALUE4", VALUE4),
  ),
  /** Does nothing in the firmware; meant to send data */
  COM_WRITEDATA: (VALUE1, VALUE2, VALUE3, VALUE4) => operation(
    Opcode.COM_WRITEDATA, data8("VALUE1", VALUE1), data8("VALUE2", VALUE2), data16("VALUE3", VALUE3),
    data8("VALUE4", VALUE4),
  ),
  /** Reports whether something is still being sent to a device */
  COM_TEST: (HARDWARE, NAME, BUSY) => operation(
    Opcode.COM_TEST, data8("HARDWARE", HARDWARE), text("NAME", NAME), output("BUSY", BUSY),
  ),
  /** Forgets a paired device or a known network */
  COM_REMOVE: (HARDWARE, REMOTE_NAME) => operation(
    Opcode.COM_REMOVE, data8("HARDWARE", HARDWARE), text("REMOTE_NAME", REMOTE_NAME),
  ),
  /** Sends a file or a folder to another brick, Bluetooth only */
  COM_WRITEFILE: (HARDWARE, REMOTE_NAME, FILE_NAME, FILE_TYPE) => operation(
    Opcode.COM_WRITEFILE, data8("HARDWARE", HARDWARE), text("REMOTE_NAME", REMOTE_NAME), text("FILE_NAME", FILE_NAME),
    data8("FILE_TYPE", FILE_TYPE),
  ),
  /** Opens a mailbox on this brick, at most 250 bytes of content */
  MAILBOX_OPEN: (NO, BOXNAME, TYPES, FIFOSIZE, VALUES) => operation(
    Opcode.MAILBOX_OPEN, data8("NO", NO), text("BOXNAME", BOXNAME), data8("TYPES", TYPES),
    data8("FIFOSIZE", FIFOSIZE), data8("VALUES", VALUES),
  ),
  /** Sends values to a mailbox of another brick, Bluetooth only */
  MAILBOX_WRITE: (BRICKNAME, HARDWARE, BOXNAME, TYPE, VALUES) => operation(
    Opcode.MAILBOX_WRITE, text("BRICKNAME", BRICKNAME), data8("HARDWARE", HARDWARE), text("BOXNAME", BOXNAME),
    data8("TYPE", TYPE), list("VALUES", VALUES, any),
  ),
  /** Reads the content of a mailbox and marks it read */
  MAILBOX_READ: (NO, LENGTH, VALUES) => operation(
    Opcode.MAILBOX_READ, data8("NO", NO), data8("LENGTH", LENGTH), list("VALUES", VALUES, output),
  ),
  /** Reports whether a mailbox has an unread message */
  MAILBOX_TEST: (NO, BUSY) => operation(Opcode.MAILBOX_TEST, data8("NO", NO), output("BUSY", BUSY)),
  /** Waits for an unread message in a mailbox */
  MAILBOX_READY: (NO) => operation(Opcode.MAILBOX_READY, data8("NO", NO)),
  /** Closes a mailbox on this brick */
  MAILBOX_CLOSE: (NO) => operation(Opcode.MAILBOX_CLOSE, data8("NO", NO)),
  /** Returns the size of a mailbox's content (xtended and compat firmware only) */
  MAILBOX_SIZE: (NO, SIZE) => operation(Opcode.MAILBOX_SIZE, data8("NO", NO), output("SIZE", SIZE)),
  PROGRAM_INFO: Object.freeze({
    /** Stops an object of a running program */
    OBJ_STOP: (PRGID, OBJID) => operation(Opcode.PROGRAM_INFO, LC(0), data16("PRGID", PRGID), data16("OBJID", OBJID)),
    /** Starts an object of a running program from its beginning */
    OBJ_START: (PRGID, OBJID) => operation(Opcode.PROGRAM_INFO, LC(4), data16("PRGID", PRGID), data16("OBJID", OBJID)),
    /** Asks whether a program runs */
    GET_STATUS: (PRGID, DATA) => operation(Opcode.PROGRAM_INFO, LC(22), data16("PRGID", PRGID), output("DATA", DATA)),
    /** Asks for a program's speed */
    GET_SPEED: (PRGID, DATA) => operation(Opcode.PROGRAM_INFO, LC(23), data16("PRGID", PRGID), output("DATA", DATA)),
    /** Asks how a program ended */
    GET_PRGRESULT: (PRGID, DATA) => operation(
      Opcode.PROGRAM_INFO, LC(24), data16("PRGID", PRGID), output("DATA", DATA),
    ),
    /** Sets how many instructions the calling thread may still run in its time slice */
    SET_INSTR: (PRGID) => operation(Opcode.PROGRAM_INFO, LC(25), data16("PRGID", PRGID)),
    /** Asks for the name of a program (xtended and compat firmware only) */
    GET_PRGNAME: (PRGID, NAME) => operation(Opcode.PROGRAM_INFO, LC(26), data16("PRGID", PRGID), output("NAME", NAME)),
  }),
  INFO: Object.freeze({
    /** Adds an error to the brick's error log */
    SET_ERROR: (NUMBER) => operation(Opcode.INFO, LC(1), data8("NUMBER", NUMBER)),
    /** Removes and returns the oldest error of the brick's error log */
    GET_ERROR: (NUMBER) => operation(Opcode.INFO, LC(2), output("NUMBER", NUMBER)),
    /** Converts the number of an error to its name */
    ERRORTEXT: (NUMBER, LENGTH, DESTINATION) => operation(
      Opcode.INFO, LC(3), data8("NUMBER", NUMBER), data8("LENGTH", LENGTH), output("DESTINATION", DESTINATION),
    ),
    /** Reads the volume setting */
    GET_VOLUME: (VALUE) => operation(Opcode.INFO, LC(4), output("VALUE", VALUE)),
    /** Changes the volume setting */
    SET_VOLUME: (VALUE) => operation(Opcode.INFO, LC(5), data8("VALUE", VALUE)),
    /** Reads the idle time after which the brick powers off */
    GET_MINUTES: (VALUE) => operation(Opcode.INFO, LC(6), output("VALUE", VALUE)),
    /** Changes the idle time after which the brick powers off */
    SET_MINUTES: (VALUE) => operation(Opcode.INFO, LC(7), data8("VALUE", VALUE)),
  }),
  STRINGS: Object.freeze({
    /** Reads the length of a text */
    GET_SIZE: (SOURCE1, SIZE) => operation(Opcode.STRINGS, LC(1), text("SOURCE1", SOURCE1), output("SIZE", SIZE)),
    /** Joins two texts */
    ADD: (SOURCE1, SOURCE2, DESTINATION) => operation(
      Opcode.STRINGS, LC(2), text("SOURCE1", SOURCE1), text("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
    ),
    /** Reports whether two texts are equal; case matters */
    COMPARE: (SOURCE1, SOURCE2, RESULT) => operation(
      Opcode.STRINGS, LC(3), text("SOURCE1", SOURCE1), text("SOURCE2", SOURCE2), output("RESULT", RESULT),
    ),
    /** Copies a text */
    DUPLICATE: (SOURCE1, DESTINATION) => operation(
      Opcode.STRINGS, LC(5), text("SOURCE1", SOURCE1), output("DESTINATION", DESTINATION),
    ),
    /** Writes a floating-point number as text, without trailing zeros */
    VALUE_TO_STRING: (VALUE, FIGURES, DECIMALS, DESTINATION) => operation(
      Opcode.STRINGS, LC(6), float("VALUE", VALUE), data8("FIGURES", FIGURES), data8("DECIMALS", DECIMALS),
      output("DESTINATION", DESTINATION),
    ),
    /** Reads a number from a text */
    STRING_TO_VALUE: (SOURCE1, DESTINATION) => operation(
      Opcode.STRINGS, LC(7), text("SOURCE1", SOURCE1), output("DESTINATION", DESTINATION),
    ),
    /** Removes every space from a text */
    STRIP: (SOURCE1, DESTINATION) => operation(
      Opcode.STRINGS, LC(8), text("SOURCE1", SOURCE1), output("DESTINATION", DESTINATION),
    ),
    /** Writes a whole number as text, with leading zeros */
    NUMBER_TO_STRING: (VALUE, FIGURES, DESTINATION) => operation(
      Opcode.STRINGS, LC(9), data16("VALUE", VALUE), data8("FIGURES", FIGURES), output("DESTINATION", DESTINATION),
    ),
    /** Returns the part of a text after another text found in it */
    SUB: (SOURCE1, SOURCE2, DESTINATION) => operation(
      Opcode.STRINGS, LC(10), text("SOURCE1", SOURCE1), text("SOURCE2", SOURCE2), output("DESTINATION", DESTINATION),
    ),
    /** Writes a floating-point number as text in a format of C's printf */
    VALUE_FORMATTED: (VALUE, FORMAT, SIZE, DESTINATION) => operation(
      Opcode.STRINGS, LC(11), float("VALUE", VALUE), text("FORMAT", FORMAT), data8("SIZE", SIZE),
      output("DESTINATION", DESTINATION),
    ),
    /** Writes a whole number as text in a format of C's printf */
    NUMBER_FORMATTED: (VALUE, FORMAT, SIZE, DESTINATION) => operation(
      Opcode.STRINGS, LC(12), data32("VALUE", VALUE), text("FORMAT", FORMAT), data8("SIZE", SIZE),
      output("DESTINATION", DESTINATION),
    ),
  }),
  TST: Object.freeze({
    /** Allows test commands for 10 seconds; each one restarts the timer */
    TST_OPEN: () => operation(Opcode.TST, LC(10)),
    /** Ends the test mode */
    TST_CLOSE: () => operation(Opcode.TST, LC(11)),
    /** Reads the pins of a connector */
    TST_READ_PINS: (PORT, LENGTH, STRING) => operation(
      Opcode.TST, LC(12), data8("PORT", PORT), data8("LENGTH", LENGTH), output("STRING", STRING),
    ),
    /** Sets the pins of a connector */
    TST_WRITE_PINS: (PORT, LENGTH, STRING) => operation(
      Opcode.TST, LC(13), data8("PORT", PORT), data8("LENGTH", LENGTH), data8("STRING", STRING),
    ),
    /** Reads the analog converter */
    TST_READ_ADC: (INDEX, VALUE) => operation(Opcode.TST, LC(14), data8("INDEX", INDEX), output("VALUE", VALUE)),
    /** Sends bytes on a sensor port's serial line */
    TST_WRITE_UART: (PORT, LENGTH, STRING) => operation(
      Opcode.TST, LC(15), data8("PORT", PORT), data8("LENGTH", LENGTH), data8("STRING", STRING),
    ),
    /** Reads the bytes received on a sensor port's serial line */
    TST_READ_UART: (PORT, LENGTH, STRING) => operation(
      Opcode.TST, LC(16), data8("PORT", PORT), data8("LENGTH", LENGTH), output("STRING", STRING),
    ),
    /** Switches the serial lines of all sensor ports on */
    TST_ENABLE_UART: (BITRATE) => operation(Opcode.TST, LC(17), data32("BITRATE", BITRATE)),
    /** Switches the serial lines of all sensor ports off */
    TST_DISABLE_UART: () => operation(Opcode.TST, LC(18)),
    /** Reads the switch that senses the rechargeable battery */
    TST_ACCU_SWITCH: (ACTIVE) => operation(Opcode.TST, LC(19), output("ACTIVE", ACTIVE)),
    /** Starts Bluetooth mode 2, for Apple devices */
    TST_BOOT_MODE2: () => operation(Opcode.TST, LC(20)),
    /** Asks for the state of the start of Bluetooth mode 2 */
    TST_POLL_MODE2: (STATUS) => operation(Opcode.TST, LC(21), output("STATUS", STATUS)),
    /** Ends Bluetooth mode 2 */
    TST_CLOSE_MODE2: () => operation(Opcode.TST, LC(22)),
    /** Asks for the result of the memory test at power-on */
    TST_RAM_CHECK: (STATUS) => operation(Opcode.TST, LC(23), output("STATUS", STATUS)),
  }),
  MATH: Object.freeze({
    /** Raises e to a power */
    EXP: (X, R) => operation(Opcode.MATH, LC(1), float("X", X), output("R", R)),
    /** Takes the remainder of a floating-point division */
    MOD: (X, Y, R) => operation(Opcode.MATH, LC(2), float("X", X), float("Y", Y), output("R", R)),
    /** Rounds down to a whole number */
    FLOOR: (X, R) => operation(Opcode.MATH, LC(3), float("X", X), output("R", R)),
    /** Rounds up to a whole number */
    CEIL: (X, R) => operation(Opcode.MATH, LC(4), float("X", X), output("R", R)),
    /** Rounds to the nearest whole number, halves away from zero */
    ROUND: (X, R) => operation(Opcode.MATH, LC(5), float("X", X), output("R", R)),
    /** Drops the sign */
    ABS: (X, R) => operation(Opcode.MATH, LC(6), float("X", X), output("R", R)),
    /** Reverses the sign */
    NEGATE: (X, R) => operation(Opcode.MATH, LC(7), float("X", X), output("R", R)),
    /** Takes the square root */
    SQRT: (X, R) => operation(Opcode.MATH, LC(8), float("X", X), output("R", R)),
    /** Takes the logarithm to base 10 */
    LOG: (X, R) => operation(Opcode.MATH, LC(9), float("X", X), output("R", R)),
    /** Takes the natural logarithm */
    LN: (X, R) => operation(Opcode.MATH, LC(10), float("X", X), output("R", R)),
    /** Takes the sine of an angle in degrees */
    SIN: (X, R) => operation(Opcode.MATH, LC(11), float("X", X), output("R", R)),
    /** Takes the cosine of an angle in degrees */
    COS: (X, R) => operation(Opcode.MATH, LC(12), float("X", X), output("R", R)),
    /** Takes the tangent of an angle in degrees */
    TAN: (X, R) => operation(Opcode.MATH, LC(13), float("X", X), output("R", R)),
    /** Finds the angle that has a sine */
    ASIN: (X, R) => operation(Opcode.MATH, LC(14), float("X", X), output("R", R)),
    /** Finds the angle that has a cosine */
    ACOS: (X, R) => operation(Opcode.MATH, LC(15), float("X", X), output("R", R)),
    /** Finds the angle that has a tangent */
    ATAN: (X, R) => operation(Opcode.MATH, LC(16), float("X", X), output("R", R)),
    /** Takes the remainder of an 8-bit division */
    MOD8: (X, Y, R) => operation(Opcode.MATH, LC(17), data8("X", X), data8("Y", Y), output("R", R)),
    /** Takes the remainder of a 16-bit division */
    MOD16: (X, Y, R) => operation(Opcode.MATH, LC(18), data16("X", X), data16("Y", Y), output("R", R)),
    /** Takes the remainder of a 32-bit division */
    MOD32: (X, Y, R) => operation(Opcode.MATH, LC(19), data32("X", X), data32("Y", Y), output("R", R)),
    /** Raises a number to a power */
    POW: (X, Y, R) => operation(Opcode.MATH, LC(20), float("X", X), float("Y", Y), output("R", R)),
    /** Cuts off decimals without rounding */
    TRUNC: (X, P, R) => operation(Opcode.MATH, LC(21), float("X", X), data8("P", P), output("R", R)),
  }),
  UI_READ: Object.freeze({
    /** Reads the battery voltage */
    GET_VBATT: (VALUE) => operation(Opcode.UI_READ, LC(1), output("VALUE", VALUE)),
    /** Reads the battery current */
    GET_IBATT: (VALUE) => operation(Opcode.UI_READ, LC(2), output("VALUE", VALUE)),
    /** Reads name and version of the operating system */
    GET_OS_VERS: (LENGTH, DESTINATION) => operation(
      Opcode.UI_READ, LC(3), data8("LENGTH", LENGTH), output("DESTINATION", DESTINATION),
    ),
    /** Reads and clears the pending event (used by the brick's own menus) */
    GET_EVENT: (EVENT) => operation(Opcode.UI_READ, LC(4), output("EVENT", EVENT)),
    /** Reads the rise in battery temperature, estimated from the current */
    GET_TBATT: (VALUE) => operation(Opcode.UI_READ, LC(5), output("VALUE", VALUE)),
    /** Reads the battery current smoothed over time */
    GET_IINT: (IINT) => operation(Opcode.UI_READ, LC(6), output("IINT", IINT)),
    /** Reads the current of all motors together */
    GET_IMOTOR: (VALUE) => operation(Opcode.UI_READ, LC(7), output("VALUE", VALUE)),
    /** Waits for a line typed at the terminal and reads it */
    GET_STRING: (LENGTH, DESTINATION) => operation(
      Opcode.UI_READ, LC(8), data8("LENGTH", LENGTH), output("DESTINATION", DESTINATION),
    ),
    /** Reads the hardware version */
    GET_HW_VERS: (LENGTH, DESTINATION) => operation(
      Opcode.UI_READ, LC(9), data8("LENGTH", LENGTH), output("DESTINATION", DESTINATION),
    ),
    /** Reads the firmware version */
    GET_FW_VERS: (LENGTH, DESTINATION) => operation(
      Opcode.UI_READ, LC(10), data8("LENGTH", LENGTH), output("DESTINATION", DESTINATION),
    ),
    /** Reads the build time of the firmware */
    GET_FW_BUILD: (LENGTH, DESTINATION) => operation(
      Opcode.UI_READ, LC(11), data8("LENGTH", LENGTH), output("DESTINATION", DESTINATION),
    ),
    /** Reads the build time of the operating system */
    GET_OS_BUILD: (LENGTH, DESTINATION) => operation(
      Opcode.UI_READ, LC(12), data8("LENGTH", LENGTH), output("DESTINATION", DESTINATION),
    ),
    /** Waits for a decimal number typed at the terminal and reads it (debugging) */
    GET_ADDRESS: (VALUE) => operation(Opcode.UI_READ, LC(13), output("VALUE", VALUE)),
    /** Waits for byte code typed as hex at the terminal and builds a program from it (debugging) */
    GET_CODE: (LENGTH, IMAGE, GLOBAL, FLAG) => operation(
      Opcode.UI_READ, LC(14), data32("LENGTH", LENGTH), data32("IMAGE", IMAGE), output("GLOBAL", GLOBAL),
      output("FLAG", FLAG),
    ),
    /** Takes one key from the terminal without waiting */
    KEY: (VALUE) => operation(Opcode.UI_READ, LC(15), output("VALUE", VALUE)),
    /** Reads and clears the request to shut down (used by the brick's own menus) */
    GET_SHUTDOWN: (FLAG) => operation(Opcode.UI_READ, LC(16), output("FLAG", FLAG)),
    /** Reads the brick's warnings */
    GET_WARNING: (WARNINGS) => operation(Opcode.UI_READ, LC(17), output("WARNINGS", WARNINGS)),
    /** Reads the battery level, derived from its voltage */
    GET_LBATT: (PCT) => operation(Opcode.UI_READ, LC(18), output("PCT", PCT)),
    /** Reads one line of the text of a text box */
    TEXTBOX_READ: (TEXT, SIZE, DEL, LENGTH, LINE, DESTINATION) => operation(
      Opcode.UI_READ, LC(21), text("TEXT", TEXT), data32("SIZE", SIZE), data8("DEL", DEL), data8("LENGTH", LENGTH),
      data16("LINE", LINE), output("DESTINATION", DESTINATION),
    ),
    /** Reads name, version and build date of the firmware in one string */
    GET_VERSION: (LENGTH, DESTINATION) => operation(
      Opcode.UI_READ, LC(26), data8("LENGTH", LENGTH), output("DESTINATION", DESTINATION),
    ),
    /** Reads the brick's IP address */
    GET_IP: (LENGTH, DESTINATION) => operation(
      Opcode.UI_READ, LC(27), data8("LENGTH", LENGTH), output("DESTINATION", DESTINATION),
    ),
    /** Reads all values of the power supply at once */
    GET_POWER: (VBATT, IBATT, IINT, IMOTOR) => operation(
      Opcode.UI_READ, LC(29), output("VBATT", VBATT), output("IBATT", IBATT), output("IINT", IINT),
      output("IMOTOR", IMOTOR),
    ),
    /** Reads whether an SD card is present, and its space */
    GET_SDCARD: (STATE, TOTAL, FREE) => operation(
      Opcode.UI_READ, LC(30), output("STATE", STATE), output("TOTAL", TOTAL), output("FREE", FREE),
    ),
    /** Reads whether a USB stick is present, and its space */
    GET_USBSTICK: (STATE, TOTAL, FREE) => operation(
      Opcode.UI_READ, LC(31), output("STATE", STATE), output("TOTAL", TOTAL), output("FREE", FREE),
    ),
  }),
  UI_WRITE: Object.freeze({
    /** Sends the contents of the terminal's output buffer, like UI_FLUSH */
    WRITE_FLUSH: () => operation(Opcode.UI_WRITE, LC(1)),
    /** Writes a number in a fixed format to the terminal */
    FLOATVALUE: (VALUE, FIGURES, DECIMALS) => operation(
      Opcode.UI_WRITE, LC(2), float("VALUE", VALUE), data8("FIGURES", FIGURES), data8("DECIMALS", DECIMALS),
    ),
    /** Writes time, program, object, position and a comment to the terminal */
    STAMP: (VALUE) => operation(Opcode.UI_WRITE, LC(3), text("VALUE", VALUE)),
    /** Writes text to the terminal */
    PUT_STRING: (STRING) => operation(Opcode.UI_WRITE, LC(8), text("STRING", STRING)),
    /** Writes a whole number to the terminal */
    VALUE8: (VALUE) => operation(Opcode.UI_WRITE, LC(9), data8("VALUE", VALUE)),
    /** Writes an unsigned whole number to the terminal */
    VALUE16: (VALUE) => operation(Opcode.UI_WRITE, LC(10), data16Unsigned("VALUE", VALUE)),
    /** Writes a whole number to the terminal */
    VALUE32: (VALUE) => operation(Opcode.UI_WRITE, LC(11), data32("VALUE", VALUE)),
    /** Writes a number to the terminal */
    VALUEF: (VALUE) => operation(Opcode.UI_WRITE, LC(12), float("VALUE", VALUE)),
    /** Not implemented in the firmware: the program that runs it fails */
    ADDRESS: (VALUE) => operation(Opcode.UI_WRITE, LC(13), output("VALUE", VALUE)),
    /** Writes bytes of memory as hex to the terminal */
    CODE: (ARRAY, LENGTH) => operation(Opcode.UI_WRITE, LC(14), data32("ARRAY", ARRAY), data32("LENGTH", LENGTH)),
    /** Plays the sound of a finished download and refreshes the file browser */
    DOWNLOAD_END: () => operation(Opcode.UI_WRITE, LC(15)),
    /** Blocks or unblocks the display and the buttons for programs */
    SCREEN_BLOCK: (STATUS) => operation(Opcode.UI_WRITE, LC(16), data8("STATUS", STATUS)),
    /** Selects the debug pulses that are shown (only in debug builds of the firmware) */
    ALLOW_PULSE: (VALUE) => operation(Opcode.UI_WRITE, LC(17), data8("VALUE", VALUE)),
    /** Raises debug pulses (only in debug builds of the firmware) */
    SET_PULSE: (VALUE) => operation(Opcode.UI_WRITE, LC(18), data8("VALUE", VALUE)),
    /** Appends a line to the text of a text box */
    TEXTBOX_APPEND: (TEXT, SIZE, DEL, SOURCE) => operation(
      Opcode.UI_WRITE, LC(21), output("TEXT", TEXT), data32("SIZE", SIZE), data8("DEL", DEL), text("SOURCE", SOURCE),
    ),
    /** Sets or clears the busy bit among the warnings */
    SET_BUSY: (VALUE) => operation(Opcode.UI_WRITE, LC(22), data8("VALUE", VALUE)),
    /** Sets the test pin on the brick's circuit board */
    SET_TESTPIN: (STATE) => operation(Opcode.UI_WRITE, LC(24), data8("STATE", STATE)),
    /** Shows the animation of a running program until something draws */
    INIT_RUN: () => operation(Opcode.UI_WRITE, LC(25)),
    /** Does nothing */
    UPDATE_RUN: () => operation(Opcode.UI_WRITE, LC(26)),
    /** Sets colour and blinking of the light around the buttons */
    LED: (PATTERN) => operation(Opcode.UI_WRITE, LC(27), data8("PATTERN", PATTERN)),
    /** Sets the flag that makes the power driver switch off when the firmware ends */
    POWER: (VALUE) => operation(Opcode.UI_WRITE, LC(29), data8("VALUE", VALUE)),
    /** Adds the current values to the graph of GRAPH_SETUP */
    GRAPH_SAMPLE: () => operation(Opcode.UI_WRITE, LC(30)),
    /** Switches the debug terminal on or off */
    TERMINAL: (STATE) => operation(Opcode.UI_WRITE, LC(31), data8("STATE", STATE)),
  }),
  UI_BUTTON: Object.freeze({
    /** Reports whether a button was pressed since the last query, and clears the press */
    SHORTPRESS: (BUTTON, STATE) => operation(Opcode.UI_BUTTON, LC(1), data8("BUTTON", BUTTON), output("STATE", STATE)),
    /** Reports whether a button was held for 3 s since the last query, and clears it */
    LONGPRESS: (BUTTON, STATE) => operation(Opcode.UI_BUTTON, LC(2), data8("BUTTON", BUTTON), output("STATE", STATE)),
    /** Waits until any button has been pressed, by hand or by PRESS */
    WAIT_FOR_PRESS: () => operation(Opcode.UI_BUTTON, LC(3)),
    /** Clears all pending presses */
    FLUSH: () => operation(Opcode.UI_BUTTON, LC(4)),
    /** Presses a button as if by hand and holds it until RELEASE */
    PRESS: (BUTTON) => operation(Opcode.UI_BUTTON, LC(5), data8("BUTTON", BUTTON)),
    /** Releases a button that PRESS holds */
    RELEASE: (BUTTON) => operation(Opcode.UI_BUTTON, LC(6), data8("BUTTON", BUTTON)),
    /** Reads the left and right buttons as one axis, and clears their presses */
    GET_HORZ: (VALUE) => operation(Opcode.UI_BUTTON, LC(7), output("VALUE", VALUE)),
    /** Reads the up and down buttons as one axis, and clears their presses */
    GET_VERT: (VALUE) => operation(Opcode.UI_BUTTON, LC(8), output("VALUE", VALUE)),
    /** Reports whether a button is down at the moment */
    PRESSED: (BUTTON, STATE) => operation(Opcode.UI_BUTTON, LC(9), data8("BUTTON", BUTTON), output("STATE", STATE)),
    /** Blocks or unblocks the back button, which ends the running program */
    SET_BACK_BLOCK: (BLOCKED) => operation(Opcode.UI_BUTTON, LC(10), data8("BLOCKED", BLOCKED)),
    /** Reports whether the back button is blocked */
    GET_BACK_BLOCK: (BLOCKED) => operation(Opcode.UI_BUTTON, LC(11), output("BLOCKED", BLOCKED)),
    /** Reports, like SHORTPRESS, whether a button was pressed, without clearing the press */
    TESTSHORTPRESS: (BUTTON, STATE) => operation(
      Opcode.UI_BUTTON, LC(12), data8("BUTTON", BUTTON), output("STATE", STATE),
    ),
    /** Reports, like LONGPRESS, whether a button was held for 3 s, without clearing it */
    TESTLONGPRESS: (BUTTON, STATE) => operation(
      Opcode.UI_BUTTON, LC(13), data8("BUTTON", BUTTON), output("STATE", STATE),
    ),
    /** Reports whether a button was pressed and released since the last query, and clears it (official and xtended firmware only) */
    GET_BUMBED: (BUTTON, STATE) => operation(Opcode.UI_BUTTON, LC(14), data8("BUTTON", BUTTON), output("STATE", STATE)),
    /** Reports whether a button was pressed and released since the last query, and clears it (compat firmware only) */
    GET_BUMPED: (BUTTON, STATE) => operation(Opcode.UI_BUTTON, LC(14), data8("BUTTON", BUTTON), output("STATE", STATE)),
    /** Reports whether a key click is due for a handled press, and clears it */
    GET_CLICK: (CLICK) => operation(Opcode.UI_BUTTON, LC(15), output("CLICK", CLICK)),
  }),
  UI_DRAW: Object.freeze({
    /** Shows on the display what has been drawn, and restores the normal font */
    UPDATE: () => operation(Opcode.UI_DRAW, LC(0)),
    /** Clears the canvas to white, and restores the normal font */
    CLEAN: () => operation(Opcode.UI_DRAW, LC(1)),
    /** Draws one pixel */
    PIXEL: (COLOR, X0, Y0) => operation(
      Opcode.UI_DRAW, LC(2), data8("COLOR", COLOR), data16("X0", X0), data16("Y0", Y0),
    ),
    /** Draws a line between two points */
    LINE: (COLOR, X0, Y0, X1, Y1) => operation(
      Opcode.UI_DRAW, LC(3), data8("COLOR", COLOR), data16("X0", X0), data16("Y0", Y0), data16("X1", X1),
      data16("Y1", Y1),
    ),
    /** Draws a circle */
    CIRCLE: (COLOR, X0, Y0, R) => operation(
      Opcode.UI_DRAW, LC(4), data8("COLOR", COLOR), data16("X0", X0), data16("Y0", Y0), data16("R", R),
    ),
    /** Draws text in the font chosen by SELECT_FONT */
    TEXT: (COLOR, X0, Y0, STRING) => operation(
      Opcode.UI_DRAW, LC(5), data8("COLOR", COLOR), data16("X0", X0), data16("Y0", Y0), text("STRING", STRING),
    ),
    /** Draws one of the built-in icons */
    ICON: (COLOR, X0, Y0, TYPE, NO) => operation(
      Opcode.UI_DRAW, LC(6), data8("COLOR", COLOR), data16("X0", X0), data16("Y0", Y0), data8("TYPE", TYPE),
      data8("NO", NO),
    ),
    /** Draws a picture from memory */
    PICTURE: (COLOR, X0, Y0, IP) => operation(
      Opcode.UI_DRAW, LC(7), data8("COLOR", COLOR), data16("X0", X0), data16("Y0", Y0), data32("IP", IP),
    ),
    /** Draws a number, or dashes where it is not a number */
    VALUE: (COLOR, X0, Y0, VALUE, FIGURES, DECIMALS) => operation(
      Opcode.UI_DRAW, LC(8), data8("COLOR", COLOR), data16("X0", X0), data16("Y0", Y0), float("VALUE", VALUE),
      data8("FIGURES", FIGURES), data8("DECIMALS", DECIMALS),
    ),
    /** Draws a filled rectangle */
    FILLRECT: (COLOR, X0, Y0, X1, Y1) => operation(
      Opcode.UI_DRAW, LC(9), data8("COLOR", COLOR), data16("X0", X0), data16("Y0", Y0), data16("X1", X1),
      data16("Y1", Y1),
    ),
    /** Draws the outline of a rectangle (official firmware only) */
    RECT: (COLOR, X0, Y0, X1, Y1) => operation(
      Opcode.UI_DRAW, LC(10), data8("COLOR", COLOR), data16("X0", X0), data16("Y0", Y0), data16("X1", X1),
      data16("Y1", Y1),
    ),
    /** Draws the outline of a rectangle (xtended and compat firmware only) */
    RECTANGLE: (COLOR, X0, Y0, X1, Y1) => operation(
      Opcode.UI_DRAW, LC(10), data8("COLOR", COLOR), data16("X0", X0), data16("Y0", Y0), data16("X1", X1),
      data16("Y1", Y1),
    ),
    /** Shows icons and text in a window and waits for the centre button */
    NOTIFICATION: (COLOR, X0, Y0, ICON1, ICON2, ICON3, STRING, STATE) => operation(
      Opcode.UI_DRAW, LC(11), data8("COLOR", COLOR), data16("X0", X0), data16("Y0", Y0), data8("ICON1", ICON1),
      data8("ICON2", ICON2), data8("ICON3", ICON3), text("STRING", STRING), output("STATE", STATE),
    ),
    /** Shows icons in a window and waits for yes or no */
    QUESTION: (COLOR, X0, Y0, ICON1, ICON2, STRING, STATE, OK) => operation(
      Opcode.UI_DRAW, LC(12), data8("COLOR", COLOR), data16("X0", X0), data16("Y0", Y0), data8("ICON1", ICON1),
      data8("ICON2", ICON2), text("STRING", STRING), output("STATE", STATE), output("OK", OK),
    ),
    /** Shows a keyboard on the display and waits until a text has been entered */
    KEYBOARD: (COLOR, X0, Y0, ICON, LENGTH, DEFAULT, CHARSET, STRING) => operation(
      Opcode.UI_DRAW, LC(13), data8("COLOR", COLOR), data16("X0", X0), data16("Y0", Y0), data8("ICON", ICON),
      data8("LENGTH", LENGTH), text("DEFAULT", DEFAULT), output("CHARSET", CHARSET), output("STRING", STRING),
    ),
    /** Shows files and folders and waits until one is chosen */
    BROWSE: (TYPE, X0, Y0, X1, Y1, LENGTH, ITEM_TYPE, STRING) => operation(
      Opcode.UI_DRAW, LC(14), data8("TYPE", TYPE), data16("X0", X0), data16("Y0", Y0), data16("X1", X1),
      data16("Y1", Y1), data8("LENGTH", LENGTH), output("ITEM_TYPE", ITEM_TYPE), output("STRING", STRING),
    ),
    /** Draws a vertical scroll bar */
    VERTBAR: (COLOR, X0, Y0, X1, Y1, MIN, MAX, ACT) => operation(
      Opcode.UI_DRAW, LC(15), data8("COLOR", COLOR), data16("X0", X0), data16("Y0", Y0), data16("X1", X1),
      data16("Y1", Y1), data16("MIN", MIN), data16("MAX", MAX), data16("ACT", ACT),
    ),
    /** Swaps black and white in a rectangle */
    INVERSERECT: (X0, Y0, X1, Y1) => operation(
      Opcode.UI_DRAW, LC(16), data16("X0", X0), data16("Y0", Y0), data16("X1", X1), data16("Y1", Y1),
    ),
    /** Chooses the font for text, until UPDATE, CLEAN or FILLWINDOW */
    SELECT_FONT: (TYPE) => operation(Opcode.UI_DRAW, LC(17), data8("TYPE", TYPE)),
    /** Switches the status line at the top on or off */
    TOPLINE: (ENABLE) => operation(Opcode.UI_DRAW, LC(18), data8("ENABLE", ENABLE)),
    /** Fills rows over the whole width, and restores the normal font */
    FILLWINDOW: (COLOR, Y0, Y1) => operation(
      Opcode.UI_DRAW, LC(19), data8("COLOR", COLOR), data16("Y0", Y0), data16("Y1", Y1),
    ),
    /** Moves the canvas up */
    SCROLL: (Y) => operation(Opcode.UI_DRAW, LC(20), data16("Y", Y)),
    /** Draws a dashed line between two points */
    DOTLINE: (COLOR, X0, Y0, X1, Y1, ON, OFF) => operation(
      Opcode.UI_DRAW, LC(21), data8("COLOR", COLOR), data16("X0", X0), data16("Y0", Y0), data16("X1", X1),
      data16("Y1", Y1), data16("ON", ON), data16("OFF", OFF),
    ),
    /** Draws a number centred in its place, or > instead of digits if it does not fit */
    VIEW_VALUE: (COLOR, X0, Y0, VALUE, FIGURES, DECIMALS) => operation(
      Opcode.UI_DRAW, LC(22), data8("COLOR", COLOR), data16("X0", X0), data16("Y0", Y0), float("VALUE", VALUE),
      data8("FIGURES", FIGURES), data8("DECIMALS", DECIMALS),
    ),
    /** Draws a number in large figures and its unit in small letters */
    VIEW_UNIT: (COLOR, X0, Y0, VALUE, FIGURES, DECIMALS, LENGTH, STRING) => operation(
      Opcode.UI_DRAW, LC(23), data8("COLOR", COLOR), data16("X0", X0), data16("Y0", Y0), float("VALUE", VALUE),
      data8("FIGURES", FIGURES), data8("DECIMALS", DECIMALS), data8("LENGTH", LENGTH), text("STRING", STRING),
    ),
    /** Draws a filled circle */
    FILLCIRCLE: (COLOR, X0, Y0, R) => operation(
      Opcode.UI_DRAW, LC(24), data8("COLOR", COLOR), data16("X0", X0), data16("Y0", Y0), data16("R", R),
    ),
    /** Keeps a copy of the canvas */
    STORE: (NO) => operation(Opcode.UI_DRAW, LC(25), data8("NO", NO)),
    /** Restores a canvas kept by STORE */
    RESTORE: (NO) => operation(Opcode.UI_DRAW, LC(26), data8("NO", NO)),
    /** Shows a row of icons and waits until one is chosen */
    ICON_QUESTION: (COLOR, X0, Y0, STATE, ICONS) => operation(
      Opcode.UI_DRAW, LC(27), data8("COLOR", COLOR), data16("X0", X0), data16("Y0", Y0), output("STATE", STATE),
      output("ICONS", ICONS),
    ),
    /** Draws a picture file in LEGO's own format .rgf (no .bmp despite the name) */
    BMPFILE: (COLOR, X0, Y0, NAME) => operation(
      Opcode.UI_DRAW, LC(28), data8("COLOR", COLOR), data16("X0", X0), data16("Y0", Y0), text("NAME", NAME),
    ),
    /** Opens a window that only its opener can draw on, or closes it and restores the display */
    POPUP: (OPEN) => operation(Opcode.UI_DRAW, LC(29), data8("OPEN", OPEN)),
    /** Sets up a graph of up to 8 curves; useless in direct commands, since the arrays must outlive it */
    GRAPH_SETUP: (X0, X1, ITEMS, OFFSET, SPAN, MIN, MAX, SAMPLE) => operation(
      Opcode.UI_DRAW, LC(30), data16("X0", X0), data16("X1", X1), data8("ITEMS", ITEMS), data16("OFFSET", OFFSET),
      data16("SPAN", SPAN), float("MIN", MIN), float("MAX", MAX), float("SAMPLE", SAMPLE),
    ),
    /** Draws the graph and measures the curve it shows */
    GRAPH_DRAW: (VIEW, ACTUAL, LOWEST, HIGHEST, AVERAGE) => operation(
      Opcode.UI_DRAW, LC(31), data8("VIEW", VIEW), output("ACTUAL", ACTUAL), output("LOWEST", LOWEST),
      output("HIGHEST", HIGHEST), output("AVERAGE", AVERAGE),
    ),
    /** Shows a text with a scroll bar and waits until a line is chosen */
    TEXTBOX: (X0, Y0, X1, Y1, TEXT, SIZE, DEL, LINE) => operation(
      Opcode.UI_DRAW, LC(32), data16("X0", X0), data16("Y0", Y0), data16("X1", X1), data16("Y1", Y1),
      text("TEXT", TEXT), data32("SIZE", SIZE), data8("DEL", DEL), output("LINE", LINE),
    ),
  }),
  SOUND: Object.freeze({
    /** Stops the tone or file that is playing */
    BREAK: () => operation(Opcode.SOUND, LC(0)),
    /** Plays one tone and returns at once */
    TONE: (VOLUME, FREQUENCY, DURATION) => operation(
      Opcode.SOUND, LC(1), data8("VOLUME", VOLUME), data16("FREQUENCY", FREQUENCY),
      data16Unsigned("DURATION", DURATION),
    ),
    /** Plays a sound file once and returns at once */
    PLAY: (VOLUME, NAME) => operation(Opcode.SOUND, LC(2), data8("VOLUME", VOLUME), text("NAME", NAME)),
    /** Plays a sound file over and over until BREAK and returns at once */
    REPEAT: (VOLUME, NAME) => operation(Opcode.SOUND, LC(3), data8("VOLUME", VOLUME), text("NAME", NAME)),
    /** Does nothing; the number is used inside the firmware to feed the sound driver */
    SERVICE: () => operation(Opcode.SOUND, LC(4)),
  }),
  INPUT_DEVICE: Object.freeze({
    /** Adds a line to the table of device types, for third party types (50 to 98) only */
    INSERT_TYPE: (TYPEDATA, FORCE, ERROR) => operation(
      Opcode.INPUT_DEVICE, LC(1), text("TYPEDATA", TYPEDATA), data8("FORCE", FORCE), output("ERROR", ERROR),
    ),
    /** Describes the values of a device in its current mode */
    GET_FORMAT: (LAYER, NO, DATASETS, FORMAT, MODES, VIEWS) => operation(
      Opcode.INPUT_DEVICE, LC(2), data8("LAYER", LAYER), data8("NO", NO), output("DATASETS", DATASETS),
      output("FORMAT", FORMAT), output("MODES", MODES), output("VIEWS", VIEWS),
    ),
    /** Sets the raw values that scale a type and mode to percent and SI */
    CAL_MINMAX: (TYPE, MODE, CAL_MIN, CAL_MAX) => operation(
      Opcode.INPUT_DEVICE, LC(3), data8("TYPE", TYPE), data8("MODE", MODE), data32("CAL_MIN", CAL_MIN),
      data32("CAL_MAX", CAL_MAX),
    ),
    /** Restores the built-in scaling of a type and mode */
    CAL_DEFAULT: (TYPE, MODE) => operation(Opcode.INPUT_DEVICE, LC(4), data8("TYPE", TYPE), data8("MODE", MODE)),
    /** Reports the device at a port and its mode */
    GET_TYPEMODE: (LAYER, NO, TYPE, MODE) => operation(
      Opcode.INPUT_DEVICE, LC(5), data8("LAYER", LAYER), data8("NO", NO), output("TYPE", TYPE), output("MODE", MODE),
    ),
    /** Reads the symbol of the unit of the current mode */
    GET_SYMBOL: (LAYER, NO, LENGTH, DESTINATION) => operation(
      Opcode.INPUT_DEVICE, LC(6), data8("LAYER", LAYER), data8("NO", NO), data8("LENGTH", LENGTH),
      output("DESTINATION", DESTINATION),
    ),
    /** Sets the lower end of the scaling of a type and mode */
    CAL_MIN: (TYPE, MODE, CAL_MIN) => operation(
      Opcode.INPUT_DEVICE, LC(7), data8("TYPE", TYPE), data8("MODE", MODE), data32("CAL_MIN", CAL_MIN),
    ),
    /** Sets the full scale of a type and mode */
    CAL_MAX: (TYPE, MODE, CAL_MAX) => operation(
      Opcode.INPUT_DEVICE, LC(8), data8("TYPE", TYPE), data8("MODE", MODE), data32("CAL_MAX", CAL_MAX),
    ),
    /** Writes to an I2C sensor and reads its answer, repeatedly if requested */
    SETUP: (LAYER, NO, REPEAT, TIME, WRITE_LEN, WRITE_DATA, READ_LEN, READ_DATA) => operation(
      Opcode.INPUT_DEVICE, LC(9), data8("LAYER", LAYER), data8("NO", NO), data8("REPEAT", REPEAT),
      data16("TIME", TIME), data8("WRITE_LEN", WRITE_LEN), data8("WRITE_DATA", WRITE_DATA),
      data8("READ_LEN", READ_LEN), output("READ_DATA", READ_DATA),
    ),
    /** Clears counters and angles of all devices */
    CLR_ALL: (LAYER) => operation(Opcode.INPUT_DEVICE, LC(10), data8("LAYER", LAYER)),
    /** Reads the first raw value of a device */
    GET_RAW: (LAYER, NO, VALUE) => operation(
      Opcode.INPUT_DEVICE, LC(11), data8("LAYER", LAYER), data8("NO", NO), output("VALUE", VALUE),
    ),
    /** Reports how the device at a port is connected */
    GET_CONNECTION: (LAYER, NO, CONN) => operation(
      Opcode.INPUT_DEVICE, LC(12), data8("LAYER", LAYER), data8("NO", NO), output("CONN", CONN),
    ),
    /** Stops all devices, motors among them */
    STOP_ALL: (LAYER) => operation(Opcode.INPUT_DEVICE, LC(13), data8("LAYER", LAYER)),
    /** Renumbers an entry of the table of device types, third party types only */
    SET_TYPEMODE: (TYPE, MODE, NEWTYPE, NEWMODE, ERROR) => operation(
      Opcode.INPUT_DEVICE, LC(14), data8("TYPE", TYPE), data8("MODE", MODE), data8("NEWTYPE", NEWTYPE),
      data8("NEWMODE", NEWMODE), output("ERROR", ERROR),
    ),
    /** Writes to an I2C sensor once, waits for its answer and reports the result */
    READY_IIC: (LAYER, NO, WRLNG, WRDATA, RDLNG, RDDATA, RESULT) => operation(
      Opcode.INPUT_DEVICE, LC(15), data8("LAYER", LAYER), data8("NO", NO), data8("WRLNG", WRLNG),
      data8("WRDATA", WRDATA), data8("RDLNG", RDLNG), output("RDDATA", RDDATA), output("RESULT", RESULT),
    ),
    /** Reads the name of a device in its current mode, such as TOUCH or COL-REFLECT */
    GET_NAME: (LAYER, NO, LENGTH, DESTINATION) => operation(
      Opcode.INPUT_DEVICE, LC(21), data8("LAYER", LAYER), data8("NO", NO), data8("LENGTH", LENGTH),
      output("DESTINATION", DESTINATION),
    ),
    /** Reads the name of any mode of a device */
    GET_MODENAME: (LAYER, NO, MODE, LENGTH, DESTINATION) => operation(
      Opcode.INPUT_DEVICE, LC(22), data8("LAYER", LAYER), data8("NO", NO), data8("MODE", MODE),
      data8("LENGTH", LENGTH), output("DESTINATION", DESTINATION),
    ),
    /** Simulates a raw value of a device */
    SET_RAW: (LAYER, NO, TYPE, VALUE) => operation(
      Opcode.INPUT_DEVICE, LC(23), data8("LAYER", LAYER), data8("NO", NO), data8("TYPE", TYPE),
      data32("VALUE", VALUE),
    ),
    /** Reports the number of digits that a value of the current mode needs */
    GET_FIGURES: (LAYER, NO, FIGURES, DECIMALS) => operation(
      Opcode.INPUT_DEVICE, LC(24), data8("LAYER", LAYER), data8("NO", NO), output("FIGURES", FIGURES),
      output("DECIMALS", DECIMALS),
    ),
    /** Reads how often a touch sensor changed to pressed since CLR_CHANGES */
    GET_CHANGES: (LAYER, NO, VALUE) => operation(
      Opcode.INPUT_DEVICE, LC(25), data8("LAYER", LAYER), data8("NO", NO), output("VALUE", VALUE),
    ),
    /** Sets the counts of GET_CHANGES and GET_BUMPS to zero */
    CLR_CHANGES: (LAYER, NO) => operation(Opcode.INPUT_DEVICE, LC(26), data8("LAYER", LAYER), data8("NO", NO)),
    /** Sets type and mode, waits until the device is ready and reads percent values */
    READY_PCT: (LAYER, NO, TYPE, MODE, VALUES) => operation(
      Opcode.INPUT_DEVICE, LC(27), data8("LAYER", LAYER), data8("NO", NO), data8("TYPE", TYPE), data8("MODE", MODE),
      list("VALUES", VALUES, output),
    ),
    /** Sets type and mode, waits until the device is ready and reads raw values */
    READY_RAW: (LAYER, NO, TYPE, MODE, VALUES) => operation(
      Opcode.INPUT_DEVICE, LC(28), data8("LAYER", LAYER), data8("NO", NO), data8("TYPE", TYPE), data8("MODE", MODE),
      list("VALUES", VALUES, output),
    ),
    /** Sets type and mode, waits until the device is ready and reads SI values */
    READY_SI: (LAYER, NO, TYPE, MODE, VALUES) => operation(
      Opcode.INPUT_DEVICE, LC(29), data8("LAYER", LAYER), data8("NO", NO), data8("TYPE", TYPE), data8("MODE", MODE),
      list("VALUES", VALUES, output),
    ),
    /** Reports the range of SI values of the current mode */
    GET_MINMAX: (LAYER, NO, MIN, MAX) => operation(
      Opcode.INPUT_DEVICE, LC(30), data8("LAYER", LAYER), data8("NO", NO), output("MIN", MIN), output("MAX", MAX),
    ),
    /** Reads how often a touch sensor changed to released since CLR_CHANGES */
    GET_BUMPS: (LAYER, NO, VALUE) => operation(
      Opcode.INPUT_DEVICE, LC(31), data8("LAYER", LAYER), data8("NO", NO), output("VALUE", VALUE),
    ),
  }),
  FILE: Object.freeze({
    /** Opens a file for appending; creates it if it does not exist */
    OPEN_APPEND: (NAME, HANDLE) => operation(Opcode.FILE, LC(0), text("NAME", NAME), output("HANDLE", HANDLE)),
    /** Opens a file for reading */
    OPEN_READ: (NAME, HANDLE, SIZE) => operation(
      Opcode.FILE, LC(1), text("NAME", NAME), output("HANDLE", HANDLE), output("SIZE", SIZE),
    ),
    /** Creates or truncates a file and opens it for writing */
    OPEN_WRITE: (NAME, HANDLE) => operation(Opcode.FILE, LC(2), text("NAME", NAME), output("HANDLE", HANDLE)),
    /** Reads the text up to the next delimiter and turns it into a number */
    READ_VALUE: (HANDLE, DEL, VALUE) => operation(
      Opcode.FILE, LC(3), handle("HANDLE", HANDLE), data8("DEL", DEL), output("VALUE", VALUE),
    ),
    /** Writes a number as text, and a delimiter after it */
    WRITE_VALUE: (HANDLE, DEL, VALUE, FIGURES, DECIMALS) => operation(
      Opcode.FILE, LC(4), handle("HANDLE", HANDLE), data8("DEL", DEL), float("VALUE", VALUE),
      data8("FIGURES", FIGURES), data8("DECIMALS", DECIMALS),
    ),
    /** Reads text up to the next delimiter */
    READ_TEXT: (HANDLE, DEL, LENGTH, TEXT) => operation(
      Opcode.FILE, LC(5), handle("HANDLE", HANDLE), data8("DEL", DEL), data16("LENGTH", LENGTH), output("TEXT", TEXT),
    ),
    /** Writes text without its zero, and a delimiter after it */
    WRITE_TEXT: (HANDLE, DEL, TEXT) => operation(
      Opcode.FILE, LC(6), handle("HANDLE", HANDLE), data8("DEL", DEL), text("TEXT", TEXT),
    ),
    /** Closes a file and frees its handle */
    CLOSE: (HANDLE) => operation(Opcode.FILE, LC(7), handle("HANDLE", HANDLE)),
    /** Loads a program file into a stopped slot, for PROGRAM_START to run */
    LOAD_IMAGE: (PRGID, NAME, SIZE, IP) => operation(
      Opcode.FILE, LC(8), data16("PRGID", PRGID), text("NAME", NAME), output("SIZE", SIZE), output("IP", IP),
    ),
    /** Finds the handle of a file that is already open */
    GET_HANDLE: (NAME, HANDLE, WRITE) => operation(
      Opcode.FILE, LC(9), text("NAME", NAME), output("HANDLE", HANDLE), output("WRITE", WRITE),
    ),
    /** Creates a folder unless it exists */
    MAKE_FOLDER: (NAME, SUCCESS) => operation(Opcode.FILE, LC(10), text("NAME", NAME), output("SUCCESS", SUCCESS)),
    /** Reserves a block of memory for the program */
    GET_POOL: (SIZE, HANDLE, IP) => operation(
      Opcode.FILE, LC(11), data32("SIZE", SIZE), output("HANDLE", HANDLE), output("IP", IP),
    ),
    /** Stores the time and tick to which data logs are aligned */
    SET_LOG_SYNC_TIME: (TIME, TICK) => operation(Opcode.FILE, LC(12), data32("TIME", TIME), data32("TICK", TICK)),
    /** Counts the entries of a folder, without hidden ones */
    GET_FOLDERS: (NAME, ITEMS) => operation(Opcode.FILE, LC(13), text("NAME", NAME), output("ITEMS", ITEMS)),
    /** Reads the time and tick to which data logs are aligned */
    GET_LOG_SYNC_TIME: (TIME, TICK) => operation(Opcode.FILE, LC(14), output("TIME", TIME), output("TICK", TICK)),
    /** Reads the name of one entry of a folder */
    GET_SUBFOLDER_NAME: (NAME, ITEM, LENGTH, STRING) => operation(
      Opcode.FILE, LC(15), text("NAME", NAME), data8("ITEM", ITEM), data8("LENGTH", LENGTH), output("STRING", STRING),
    ),
    /** Adds one row of samples to a data log */
    WRITE_LOG: (HANDLE, TIME, ITEMS, VALUES) => operation(
      Opcode.FILE, LC(16), handle("HANDLE", HANDLE), data32("TIME", TIME), data8("ITEMS", ITEMS),
      float("VALUES", VALUES),
    ),
    /** Writes the rest of a data log and closes it */
    CLOSE_LOG: (HANDLE, NAME) => operation(Opcode.FILE, LC(17), handle("HANDLE", HANDLE), text("NAME", NAME)),
    /** Loads an entry of a folder; LEGO's 2013 firmware has no code for it and fails */
    GET_IMAGE: (NAME, PRGID, ITEM, IP) => operation(
      Opcode.FILE, LC(18), text("NAME", NAME), data16("PRGID", PRGID), data8("ITEM", ITEM), output("IP", IP),
    ),
    /** Finds an entry of a folder by its name */
    GET_ITEM: (NAME, STRING, ITEM) => operation(
      Opcode.FILE, LC(19), text("NAME", NAME), text("STRING", STRING), output("ITEM", ITEM),
    ),
    /** Counts the recently run files */
    GET_CACHE_FILES: (ITEMS) => operation(Opcode.FILE, LC(20), output("ITEMS", ITEMS)),
    /** Puts a file first in the list of recently run files */
    PUT_CACHE_FILE: (STRING) => operation(Opcode.FILE, LC(21), text("STRING", STRING)),
    /** Reads the path of one recently run file */
    GET_CACHE_FILE: (ITEM, LENGTH, STRING) => operation(
      Opcode.FILE, LC(22), data8("ITEM", ITEM), data8("LENGTH", LENGTH), output("STRING", STRING),
    ),
    /** Removes a file from the list of recently run files */
    DEL_CACHE_FILE: (STRING) => operation(Opcode.FILE, LC(23), text("STRING", STRING)),
    /** Deletes one entry of a folder together with the files in it */
    DEL_SUBFOLDER: (NAME, ITEM) => operation(Opcode.FILE, LC(24), text("NAME", NAME), data8("ITEM", ITEM)),
    /** Reads the path of the open data log */
    GET_LOG_NAME: (LENGTH, NAME) => operation(Opcode.FILE, LC(25), data8("LENGTH", LENGTH), output("NAME", NAME)),
    /** Creates a data log and writes its header */
    OPEN_LOG: (NAME, syncedTime, syncedTick, nowTick, sample_interval_in_ms, duration_in_ms, SDATA, HANDLE) => operation(
      Opcode.FILE, LC(27), text("NAME", NAME), data32("syncedTime", syncedTime), data32("syncedTick", syncedTick),
      data32("nowTick", nowTick), data32("sample_interval_in_ms", sample_interval_in_ms),
      data32("duration_in_ms", duration_in_ms), text("SDATA", SDATA), output("HANDLE", HANDLE),
    ),
    /** Reads raw bytes from a file */
    READ_BYTES: (HANDLE, BYTES, DESTINATION) => operation(
      Opcode.FILE, LC(28), handle("HANDLE", HANDLE), data16("BYTES", BYTES), output("DESTINATION", DESTINATION),
    ),
    /** Writes raw bytes to a file */
    WRITE_BYTES: (HANDLE, BYTES, SOURCE) => operation(
      Opcode.FILE, LC(29), handle("HANDLE", HANDLE), data16("BYTES", BYTES), data8("SOURCE", SOURCE),
    ),
    /** Deletes a file, or a folder with the files in it */
    REMOVE: (NAME) => operation(Opcode.FILE, LC(30), text("NAME", NAME)),
    /** Copies a file or folder and replaces the destination; the source is kept */
    MOVE: (SOURCE, DEST) => operation(Opcode.FILE, LC(31), text("SOURCE", SOURCE), text("DEST", DEST)),
  }),
  ARRAY: Object.freeze({
    /** Deletes an array and frees its handle (official firmware only) */
    DELETE: (HANDLE) => operation(Opcode.ARRAY, LC(0), handle("HANDLE", HANDLE)),
    /** Deletes an array and frees its handle (LEGO's name for it is DELETE) (xtended and compat firmware only) */
    DESTROY: (HANDLE) => operation(Opcode.ARRAY, LC(0), handle("HANDLE", HANDLE)),
    /** Creates an array of DATA8 elements */
    CREATE8: (ELEMENTS, HANDLE) => operation(
      Opcode.ARRAY, LC(1), data32("ELEMENTS", ELEMENTS), output("HANDLE", HANDLE),
    ),
    /** Creates an array of DATA16 elements */
    CREATE16: (ELEMENTS, HANDLE) => operation(
      Opcode.ARRAY, LC(2), data32("ELEMENTS", ELEMENTS), output("HANDLE", HANDLE),
    ),
    /** Creates an array of DATA32 elements */
    CREATE32: (ELEMENTS, HANDLE) => operation(
      Opcode.ARRAY, LC(3), data32("ELEMENTS", ELEMENTS), output("HANDLE", HANDLE),
    ),
    /** Creates an array of DATAF elements */
    CREATEF: (ELEMENTS, HANDLE) => operation(
      Opcode.ARRAY, LC(4), data32("ELEMENTS", ELEMENTS), output("HANDLE", HANDLE),
    ),
    /** Changes the number of elements of an array */
    RESIZE: (HANDLE, ELEMENTS) => operation(
      Opcode.ARRAY, LC(5), handle("HANDLE", HANDLE), data32("ELEMENTS", ELEMENTS),
    ),
    /** Sets every element of an array to one value */
    FILL: (HANDLE, VALUE) => operation(Opcode.ARRAY, LC(6), handle("HANDLE", HANDLE), any("VALUE", VALUE)),
    /** Copies the content of one array into another of the same type, which is resized to match */
    COPY: (HSOURCE, HDEST) => operation(Opcode.ARRAY, LC(7), handle("HSOURCE", HSOURCE), handle("HDEST", HDEST)),
    /** Writes several elements of a DATA8 array, all within its size */
    INIT8: (HANDLE, INDEX, VALUES) => operation(
      Opcode.ARRAY, LC(8), handle("HANDLE", HANDLE), data32("INDEX", INDEX), list("VALUES", VALUES, data8),
    ),
    /** Writes several elements of a DATA16 array, all within its size */
    INIT16: (HANDLE, INDEX, VALUES) => operation(
      Opcode.ARRAY, LC(9), handle("HANDLE", HANDLE), data32("INDEX", INDEX), list("VALUES", VALUES, data16),
    ),
    /** Writes several elements of a DATA32 array, all within its size */
    INIT32: (HANDLE, INDEX, VALUES) => operation(
      Opcode.ARRAY, LC(10), handle("HANDLE", HANDLE), data32("INDEX", INDEX), list("VALUES", VALUES, data32),
    ),
    /** Writes several elements of a DATAF array, all within its size */
    INITF: (HANDLE, INDEX, VALUES) => operation(
      Opcode.ARRAY, LC(11), handle("HANDLE", HANDLE), data32("INDEX", INDEX), list("VALUES", VALUES, float),
    ),
    /** Counts the elements of an array (official firmware only) */
    SIZE: (HANDLE, ELEMENTS) => operation(Opcode.ARRAY, LC(12), handle("HANDLE", HANDLE), output("ELEMENTS", ELEMENTS)),
    /** Counts the elements of an array (LEGO's name for it is SIZE) (xtended and compat firmware only) */
    SET_SIZE: (HANDLE, ELEMENTS) => operation(
      Opcode.ARRAY, LC(12), handle("HANDLE", HANDLE), output("ELEMENTS", ELEMENTS),
    ),
    /** Reads an array's content as bytes, also of another program */
    READ_CONTENT: (PRGID, HANDLE, INDEX, BYTES, ARRAY) => operation(
      Opcode.ARRAY, LC(13), data16("PRGID", PRGID), handle("HANDLE", HANDLE), data32("INDEX", INDEX),
      data32("BYTES", BYTES), output("ARRAY", ARRAY),
    ),
    /** Writes an array's content as bytes; the array then ends after them */
    WRITE_CONTENT: (PRGID, HANDLE, INDEX, BYTES, ARRAY) => operation(
      Opcode.ARRAY, LC(14), data16("PRGID", PRGID), handle("HANDLE", HANDLE), data32("INDEX", INDEX),
      data32("BYTES", BYTES), data8("ARRAY", ARRAY),
    ),
    /** Returns the size of an array's content, also of another program */
    READ_SIZE: (PRGID, HANDLE, BYTES) => operation(
      Opcode.ARRAY, LC(15), data16("PRGID", PRGID), handle("HANDLE", HANDLE), output("BYTES", BYTES),
    ),
  }),
  FILENAME: Object.freeze({
    /** Reports whether a file or folder exists */
    EXIST: (NAME, FLAG) => operation(Opcode.FILENAME, LC(16), text("NAME", NAME), output("FLAG", FLAG)),
    /** Reports the number of files in a folder and their size */
    TOTALSIZE: (NAME, FILES, SIZE) => operation(
      Opcode.FILENAME, LC(17), text("NAME", NAME), output("FILES", FILES), output("SIZE", SIZE),
    ),
    /** Splits a path into folder, name and extension */
    SPLIT: (FILENAME, LENGTH, FOLDER, NAME, EXT) => operation(
      Opcode.FILENAME, LC(18), text("FILENAME", FILENAME), data8("LENGTH", LENGTH), output("FOLDER", FOLDER),
      output("NAME", NAME), output("EXT", EXT),
    ),
    /** Builds a path from folder, name and extension */
    MERGE: (FOLDER, NAME, EXT, LENGTH, FILENAME) => operation(
      Opcode.FILENAME, LC(19), text("FOLDER", FOLDER), text("NAME", NAME), text("EXT", EXT), data8("LENGTH", LENGTH),
      output("FILENAME", FILENAME),
    ),
    /** Reports whether a path's characters and lengths are allowed; the file need not exist */
    CHECK: (FILENAME, OK) => operation(Opcode.FILENAME, LC(20), text("FILENAME", FILENAME), output("OK", OK)),
    /** Packs a file or folder into a .raf archive beside it */
    PACK: (FILENAME) => operation(Opcode.FILENAME, LC(21), text("FILENAME", FILENAME)),
    /** Unpacks a .raf archive into the folder it is in */
    UNPACK: (FILENAME) => operation(Opcode.FILENAME, LC(22), text("FILENAME", FILENAME)),
    /** Reads the path of the program's own folder */
    GET_FOLDERNAME: (LENGTH, FOLDERNAME) => operation(
      Opcode.FILENAME, LC(23), data8("LENGTH", LENGTH), output("FOLDERNAME", FOLDERNAME),
    ),
  }),
  COM_READ: Object.freeze({
    /** Returns the address of the last direct command received */
    COMMAND: (LENGTH, IMAGE, GLOBAL, FLAG) => operation(
      Opcode.COM_READ, LC(14), data32("LENGTH", LENGTH), output("IMAGE", IMAGE), output("GLOBAL", GLOBAL),
      output("FLAG", FLAG),
    ),
  }),
  COM_WRITE: Object.freeze({
    /** Sends the global memory of a direct command that has run as its reply */
    REPLY: (IMAGE, GLOBAL, STATUS) => operation(
      Opcode.COM_WRITE, LC(14), data32("IMAGE", IMAGE), data32("GLOBAL", GLOBAL), data8("STATUS", STATUS),
    ),
  }),
  COM_GET: Object.freeze({
    /** Reports whether Bluetooth or WiFi is on */
    GET_ON_OFF: (HARDWARE, ACTIVE) => operation(
      Opcode.COM_GET, LC(1), data8("HARDWARE", HARDWARE), output("ACTIVE", ACTIVE),
    ),
    /** Reports whether other devices can see the brick by Bluetooth */
    GET_VISIBLE: (HARDWARE, VISIBLE) => operation(
      Opcode.COM_GET, LC(2), data8("HARDWARE", HARDWARE), output("VISIBLE", VISIBLE),
    ),
    /** Reports the state of a search or connection request */
    GET_RESULT: (HARDWARE, ITEM, RESULT) => operation(
      Opcode.COM_GET, LC(4), data8("HARDWARE", HARDWARE), data8("ITEM", ITEM), output("RESULT", RESULT),
    ),
    /** Reads the PIN for a device, always 1234 */
    GET_PIN: (HARDWARE, NAME, LENGTH, PINCODE) => operation(
      Opcode.COM_GET, LC(5), data8("HARDWARE", HARDWARE), text("NAME", NAME), data8("LENGTH", LENGTH),
      output("PINCODE", PINCODE),
    ),
    /** Reads a counter that changes when a device enters or leaves a list (compat firmware only) */
    LIST_STATE: (HARDWARE, STATE) => operation(
      Opcode.COM_GET, LC(7), data8("HARDWARE", HARDWARE), output("STATE", STATE),
    ),
    /** Counts the devices or networks that a search found */
    SEARCH_ITEMS: (HARDWARE, ITEMS) => operation(
      Opcode.COM_GET, LC(8), data8("HARDWARE", HARDWARE), output("ITEMS", ITEMS),
    ),
    /** Describes one device or network that a search found */
    SEARCH_ITEM: (HARDWARE, ITEM, LENGTH, NAME, PAIRED, CONNECTED, TYPE, VISIBLE) => operation(
      Opcode.COM_GET, LC(9), data8("HARDWARE", HARDWARE), data8("ITEM", ITEM), data8("LENGTH", LENGTH),
      output("NAME", NAME), output("PAIRED", PAIRED), output("CONNECTED", CONNECTED), output("TYPE", TYPE),
      output("VISIBLE", VISIBLE),
    ),
    /** Counts the paired devices, in range or not */
    FAVOUR_ITEMS: (HARDWARE, ITEMS) => operation(
      Opcode.COM_GET, LC(10), data8("HARDWARE", HARDWARE), output("ITEMS", ITEMS),
    ),
    /** Describes one paired device or known network */
    FAVOUR_ITEM: (HARDWARE, ITEM, LENGTH, NAME, PAIRED, CONNECTED, TYPE) => operation(
      Opcode.COM_GET, LC(11), data8("HARDWARE", HARDWARE), data8("ITEM", ITEM), data8("LENGTH", LENGTH),
      output("NAME", NAME), output("PAIRED", PAIRED), output("CONNECTED", CONNECTED), output("TYPE", TYPE),
    ),
    /** Reads the brick's Bluetooth address */
    GET_ID: (HARDWARE, LENGTH, STRING) => operation(
      Opcode.COM_GET, LC(12), data8("HARDWARE", HARDWARE), data8("LENGTH", LENGTH), output("STRING", STRING),
    ),
    /** Reads the brick's name */
    GET_BRICKNAME: (LENGTH, NAME) => operation(Opcode.COM_GET, LC(13), data8("LENGTH", LENGTH), output("NAME", NAME)),
    /** Reads network name and addresses, WiFi only */
    GET_NETWORK: (HARDWARE, LENGTH, NAME, MAC, IP) => operation(
      Opcode.COM_GET, LC(14), data8("HARDWARE", HARDWARE), data8("LENGTH", LENGTH), output("NAME", NAME),
      output("MAC", MAC), output("IP", IP),
    ),
    /** Reports whether the hardware is present (for WiFi: a known dongle) */
    GET_PRESENT: (HARDWARE, OK) => operation(Opcode.COM_GET, LC(15), data8("HARDWARE", HARDWARE), output("OK", OK)),
    /** Reports the encryption of a network, WiFi only */
    GET_ENCRYPT: (HARDWARE, ITEM, TYPE) => operation(
      Opcode.COM_GET, LC(16), data8("HARDWARE", HARDWARE), data8("ITEM", ITEM), output("TYPE", TYPE),
    ),
    /** Counts the connected devices, Bluetooth only */
    CONNEC_ITEMS: (HARDWARE, ITEMS) => operation(
      Opcode.COM_GET, LC(17), data8("HARDWARE", HARDWARE), output("ITEMS", ITEMS),
    ),
    /** Describes one connected device, Bluetooth only */
    CONNEC_ITEM: (HARDWARE, ITEM, LENGTH, NAME, TYPE) => operation(
      Opcode.COM_GET, LC(18), data8("HARDWARE", HARDWARE), data8("ITEM", ITEM), data8("LENGTH", LENGTH),
      output("NAME", NAME), output("TYPE", TYPE),
    ),
    /** Reports which device asks for a connection, Bluetooth only */
    GET_INCOMING: (HARDWARE, LENGTH, NAME, TYPE) => operation(
      Opcode.COM_GET, LC(19), data8("HARDWARE", HARDWARE), data8("LENGTH", LENGTH), output("NAME", NAME),
      output("TYPE", TYPE),
    ),
    /** Reports whether Bluetooth is in its mode for Apple devices */
    GET_MODE2: (HARDWARE, ACTIVE) => operation(
      Opcode.COM_GET, LC(20), data8("HARDWARE", HARDWARE), output("ACTIVE", ACTIVE),
    ),
  }),
  COM_SET: Object.freeze({
    /** Switches Bluetooth or WiFi on or off */
    SET_ON_OFF: (HARDWARE, ACTIVE) => operation(
      Opcode.COM_SET, LC(1), data8("HARDWARE", HARDWARE), data8("ACTIVE", ACTIVE),
    ),
    /** Makes the brick visible or invisible, Bluetooth only */
    SET_VISIBLE: (HARDWARE, VISIBLE) => operation(
      Opcode.COM_SET, LC(2), data8("HARDWARE", HARDWARE), data8("VISIBLE", VISIBLE),
    ),
    /** Starts or stops the search for devices or networks */
    SET_SEARCH: (HARDWARE, SEARCH) => operation(
      Opcode.COM_SET, LC(3), data8("HARDWARE", HARDWARE), data8("SEARCH", SEARCH),
    ),
    /** Answers the request for a PIN (Bluetooth) or stores a network's password (WiFi) */
    SET_PIN: (HARDWARE, NAME, PINCODE) => operation(
      Opcode.COM_SET, LC(5), data8("HARDWARE", HARDWARE), text("NAME", NAME), text("PINCODE", PINCODE),
    ),
    /** Answers the request to confirm a passkey, Bluetooth only */
    SET_PASSKEY: (HARDWARE, ACCEPT) => operation(
      Opcode.COM_SET, LC(6), data8("HARDWARE", HARDWARE), data8("ACCEPT", ACCEPT),
    ),
    /** Connects a device or network, or ends a Bluetooth connection */
    SET_CONNECTION: (HARDWARE, NAME, CONNECTION) => operation(
      Opcode.COM_SET, LC(7), data8("HARDWARE", HARDWARE), text("NAME", NAME), data8("CONNECTION", CONNECTION),
    ),
    /** Renames the brick */
    SET_BRICKNAME: (NAME) => operation(Opcode.COM_SET, LC(8), text("NAME", NAME)),
    /** Moves a network up in the list, WiFi only */
    SET_MOVEUP: (HARDWARE, ITEM) => operation(Opcode.COM_SET, LC(9), data8("HARDWARE", HARDWARE), data8("ITEM", ITEM)),
    /** Moves a network down in the list, WiFi only */
    SET_MOVEDOWN: (HARDWARE, ITEM) => operation(
      Opcode.COM_SET, LC(10), data8("HARDWARE", HARDWARE), data8("ITEM", ITEM),
    ),
    /** Sets the encryption of a network, WiFi only */
    SET_ENCRYPT: (HARDWARE, ITEM, ENCRYPT) => operation(
      Opcode.COM_SET, LC(11), data8("HARDWARE", HARDWARE), text("ITEM", ITEM), data8("ENCRYPT", ENCRYPT),
    ),
    /** Adds a network to the end of the list, WiFi only */
    SET_SSID: (HARDWARE, NAME) => operation(Opcode.COM_SET, LC(12), data8("HARDWARE", HARDWARE), text("NAME", NAME)),
    /** Switches the Bluetooth mode for Apple devices on or off */
    SET_MODE2: (HARDWARE, ACTIVE) => operation(
      Opcode.COM_SET, LC(13), data8("HARDWARE", HARDWARE), data8("ACTIVE", ACTIVE),
    ),
  }),
});

/** A function for each system command, which returns what follows the message type. */
export const system = Object.freeze({
  /** Opens a file on the brick for writing and announces its size */
  BEGIN_DOWNLOAD: (size, path, data) => request(0x92, u32("size", size), line("path", path), bytes("data", data ?? [])),
  /** Writes the next piece of a file; the file closes itself when it is complete */
  CONTINUE_DOWNLOAD: (handle, data) => request(0x93, u8("handle", handle), bytes("data", data)),
  /** Opens a file on the brick for reading and fetches its first piece */
  BEGIN_UPLOAD: (max_bytes, path) => request(0x94, u16("max_bytes", max_bytes), line("path", path)),
  /** Fetches the next piece of a file */
  CONTINUE_UPLOAD: (handle, max_bytes) => request(0x95, u8("handle", handle), u16("max_bytes", max_bytes)),
  /** Opens a file that may still be growing, such as a data log, and fetches its first piece */
  BEGIN_GETFILE: (max_bytes, path) => request(0x96, u16("max_bytes", max_bytes), line("path", path)),
  /** Fetches the next piece of a file that may still be growing */
  CONTINUE_GETFILE: (handle, max_bytes) => request(0x97, u8("handle", handle), u16("max_bytes", max_bytes)),
  /** Closes an open file before its end */
  CLOSE_FILEHANDLE: (handle, hash) => request(0x98, u8("handle", handle), bytes("hash", hash ?? [])),
  /** Lists a folder and fetches the first piece of the listing */
  LIST_FILES: (max_bytes, path) => request(0x99, u16("max_bytes", max_bytes), line("path", path)),
  /** Fetches the next piece of a listing */
  CONTINUE_LIST_FILES: (handle, max_bytes) => request(0x9A, u8("handle", handle), u16("max_bytes", max_bytes)),
  /** Creates a folder */
  CREATE_DIR: (path) => request(0x9B, line("path", path)),
  /** Deletes a file or an empty folder */
  DELETE_FILE: (path) => request(0x9C, line("path", path)),
  /** Asks which file handles are in use */
  LIST_OPEN_HANDLES: () => request(0x9D),
  /** Puts a message into a mailbox of the program that runs on the brick */
  WRITEMAILBOX: (name, payload) => request(
    0x9E, counted(u8, line)("name", name), counted(u16, message)("payload", payload),
  ),
  /** Sends the PIN for a Bluetooth device (USB only) */
  BLUETOOTHPIN: (mac, pin) => request(0x9F, counted(u8, line)("mac", mac), counted(u8, line)("pin", pin)),
  /** Restarts the brick into its firmware updater */
  ENTERFWUPDATE: () => request(0xA0),
  /** Sets the bundle identifier that the brick shows to Apple devices */
  SETBUNDLEID: (id) => request(0xA1, line("id", id)),
  /** Sets the bundle seed identifier that the brick shows to Apple devices */
  SETBUNDLESEEDID: (id) => request(0xA2, line("id", id)),
});
