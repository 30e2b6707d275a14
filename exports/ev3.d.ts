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

/** Message types */
export declare const MessageType: {
  readonly DIRECT_COMMAND_REPLY: 0; readonly DIRECT_COMMAND_NO_REPLY: 128; readonly SYSTEM_COMMAND_REPLY: 1;
  readonly SYSTEM_COMMAND_NO_REPLY: 129; readonly DIRECT_REPLY: 2; readonly DIRECT_REPLY_ERROR: 4;
  readonly SYSTEM_REPLY: 3; readonly SYSTEM_REPLY_ERROR: 5; readonly DAISY_COMMAND_REPLY: 10;
  readonly DAISY_COMMAND_NO_REPLY: 138; readonly DAISY_REPLY: 8; readonly DAISY_REPLY_ERROR: 9;
};

/** The status of a system command */
export declare const SystemStatus: {
  readonly SUCCESS: 0; readonly UNKNOWN_HANDLE: 1; readonly HANDLE_NOT_READY: 2; readonly CORRUPT_FILE: 3;
  readonly NO_HANDLES_AVAILABLE: 4; readonly NO_PERMISSION: 5; readonly ILLEGAL_PATH: 6; readonly FILE_EXITS: 7;
  readonly END_OF_FILE: 8; readonly SIZE_ERROR: 9; readonly UNKNOWN_ERROR: 10; readonly ILLEGAL_FILENAME: 11;
  readonly ILLEGAL_CONNECTION: 12;
};

/** Opcodes */
export declare const Opcode: {
  readonly ERROR: 0; readonly NOP: 1; readonly PROGRAM_STOP: 2; readonly PROGRAM_START: 3; readonly OBJECT_STOP: 4;
  readonly OBJECT_START: 5; readonly OBJECT_TRIG: 6; readonly OBJECT_WAIT: 7; readonly RETURN: 8; readonly CALL: 9;
  readonly OBJECT_END: 10; readonly SLEEP: 11; readonly PROGRAM_INFO: 12; readonly LABEL: 13; readonly PROBE: 14;
  readonly DO: 15; readonly SYSTEM: 96; readonly PORT_CNV_OUTPUT: 97; readonly PORT_CNV_INPUT: 98;
  readonly NOTE_TO_FREQ: 99; readonly INFO: 124; readonly STRINGS: 125; readonly BP0: 136; readonly BP1: 137;
  readonly BP2: 138; readonly BP3: 139; readonly BP_SET: 140; readonly DYNLOAD_VMLOAD: 240;
  readonly DYNLOAD_VMEXIT: 241; readonly DYNLOAD_ENTRY_0: 242; readonly DYNLOAD_ENTRY_1: 243;
  readonly DYNLOAD_ENTRY_2: 244; readonly DYNLOAD_ENTRY_3: 245; readonly DYNLOAD_ENTRY_4: 246;
  readonly DYNLOAD_ENTRY_5: 247; readonly DYNLOAD_ENTRY_6: 248; readonly DYNLOAD_ENTRY_7: 249;
  readonly DYNLOAD_ENTRY_8: 250; readonly DYNLOAD_ENTRY_9: 251; readonly DYNLOAD_GET_VM: 252; readonly TST: 255;
  readonly ADD8: 16; readonly ADD16: 17; readonly ADD32: 18; readonly ADDF: 19; readonly SUB8: 20; readonly SUB16: 21;
  readonly SUB32: 22; readonly SUBF: 23; readonly MUL8: 24; readonly MUL16: 25; readonly MUL32: 26; readonly MULF: 27;
  readonly DIV8: 28; readonly DIV16: 29; readonly DIV32: 30; readonly DIVF: 31; readonly OR8: 32; readonly OR16: 33;
  readonly OR32: 34; readonly AND8: 36; readonly AND16: 37; readonly AND32: 38; readonly XOR8: 40; readonly XOR16: 41;
  readonly XOR32: 42; readonly RL8: 44; readonly RL16: 45; readonly RL32: 46; readonly MATH: 141; readonly RANDOM: 142;
  readonly INIT_BYTES: 47; readonly MOVE8_8: 48; readonly MOVE8_16: 49; readonly MOVE8_32: 50; readonly MOVE8_F: 51;
  readonly MOVE16_8: 52; readonly MOVE16_16: 53; readonly MOVE16_32: 54; readonly MOVE16_F: 55; readonly MOVE32_8: 56;
  readonly MOVE32_16: 57; readonly MOVE32_32: 58; readonly MOVE32_F: 59; readonly MOVEF_8: 60; readonly MOVEF_16: 61;
  readonly MOVEF_32: 62; readonly MOVEF_F: 63; readonly READ8: 200; readonly READ16: 201; readonly READ32: 202;
  readonly READF: 203; readonly WRITE8: 204; readonly WRITE16: 205; readonly WRITE32: 206; readonly WRITEF: 207;
  readonly JR: 64; readonly JR_FALSE: 65; readonly JR_TRUE: 66; readonly JR_NAN: 67; readonly JR_LT8: 100;
  readonly JR_LT16: 101; readonly JR_LT32: 102; readonly JR_LTF: 103; readonly JR_GT8: 104; readonly JR_GT16: 105;
  readonly JR_GT32: 106; readonly JR_GTF: 107; readonly JR_EQ8: 108; readonly JR_EQ16: 109; readonly JR_EQ32: 110;
  readonly JR_EQF: 111; readonly JR_NEQ8: 112; readonly JR_NEQ16: 113; readonly JR_NEQ32: 114; readonly JR_NEQF: 115;
  readonly JR_LTEQ8: 116; readonly JR_LTEQ16: 117; readonly JR_LTEQ32: 118; readonly JR_LTEQF: 119;
  readonly JR_GTEQ8: 120; readonly JR_GTEQ16: 121; readonly JR_GTEQ32: 122; readonly JR_GTEQF: 123; readonly CP_LT8: 68;
  readonly CP_LT16: 69; readonly CP_LT32: 70; readonly CP_LTF: 71; readonly CP_GT8: 72; readonly CP_GT16: 73;
  readonly CP_GT32: 74; readonly CP_GTF: 75; readonly CP_EQ8: 76; readonly CP_EQ16: 77; readonly CP_EQ32: 78;
  readonly CP_EQF: 79; readonly CP_NEQ8: 80; readonly CP_NEQ16: 81; readonly CP_NEQ32: 82; readonly CP_NEQF: 83;
  readonly CP_LTEQ8: 84; readonly CP_LTEQ16: 85; readonly CP_LTEQ32: 86; readonly CP_LTEQF: 87; readonly CP_GTEQ8: 88;
  readonly CP_GTEQ16: 89; readonly CP_GTEQ32: 90; readonly CP_GTEQF: 91; readonly SELECT8: 92; readonly SELECT16: 93;
  readonly SELECT32: 94; readonly SELECTF: 95; readonly UI_FLUSH: 128; readonly UI_READ: 129; readonly UI_WRITE: 130;
  readonly UI_BUTTON: 131; readonly UI_DRAW: 132; readonly KEEP_ALIVE: 144; readonly TIMER_WAIT: 133;
  readonly TIMER_READY: 134; readonly TIMER_READ: 135; readonly TIMER_READ_US: 143; readonly SOUND: 148;
  readonly SOUND_TEST: 149; readonly SOUND_READY: 150; readonly INPUT_SAMPLE: 151; readonly INPUT_DEVICE_LIST: 152;
  readonly INPUT_DEVICE: 153; readonly INPUT_READ: 154; readonly INPUT_TEST: 155; readonly INPUT_READY: 156;
  readonly INPUT_READSI: 157; readonly INPUT_READEXT: 158; readonly INPUT_WRITE: 159; readonly INPUT_SET_CONN: 224;
  readonly INPUT_IIC_READ: 225; readonly INPUT_IIC_STATUS: 226; readonly INPUT_IIC_WRITE: 227;
  readonly INPUT_SET_AUTOID: 228; readonly OUTPUT_GET_TYPE: 160; readonly OUTPUT_SET_TYPE: 161;
  readonly OUTPUT_RESET: 162; readonly OUTPUT_STOP: 163; readonly OUTPUT_POWER: 164; readonly OUTPUT_SPEED: 165;
  readonly OUTPUT_START: 166; readonly OUTPUT_POLARITY: 167; readonly OUTPUT_READ: 168; readonly OUTPUT_TEST: 169;
  readonly OUTPUT_READY: 170; readonly OUTPUT_POSITION: 171; readonly OUTPUT_STEP_POWER: 172;
  readonly OUTPUT_TIME_POWER: 173; readonly OUTPUT_STEP_SPEED: 174; readonly OUTPUT_TIME_SPEED: 175;
  readonly OUTPUT_STEP_SYNC: 176; readonly OUTPUT_TIME_SYNC: 177; readonly OUTPUT_CLR_COUNT: 178;
  readonly OUTPUT_GET_COUNT: 179; readonly OUTPUT_PRG_STOP: 180; readonly MEMORY_WRITE: 126; readonly MEMORY_READ: 127;
  readonly FILE: 192; readonly ARRAY: 193; readonly ARRAY_WRITE: 194; readonly ARRAY_READ: 195;
  readonly ARRAY_APPEND: 196; readonly MEMORY_USAGE: 197; readonly FILENAME: 198; readonly FILE_MD5SUM: 230;
  readonly COM_READ: 145; readonly COM_WRITE: 146; readonly COM_READY: 208; readonly COM_READDATA: 209;
  readonly COM_WRITEDATA: 210; readonly COM_GET: 211; readonly COM_SET: 212; readonly COM_TEST: 213;
  readonly COM_REMOVE: 214; readonly COM_WRITEFILE: 215; readonly MAILBOX_OPEN: 216; readonly MAILBOX_WRITE: 217;
  readonly MAILBOX_READ: 218; readonly MAILBOX_TEST: 219; readonly MAILBOX_READY: 220; readonly MAILBOX_CLOSE: 221;
  readonly MAILBOX_SIZE: 229;
};

/** Types of devices on the ports; MODE_KEEP and TYPE_KEEP ask to leave mode or type as it is */
export declare const TYPE: {
  readonly MODE_KEEP: -1; readonly TYPE_KEEP: 0; readonly TYPE_NXT_TOUCH: 1; readonly TYPE_NXT_LIGHT: 2;
  readonly TYPE_NXT_SOUND: 3; readonly TYPE_NXT_COLOR: 4; readonly TYPE_NXT_ULTRASONIC: 5;
  readonly TYPE_NXT_TEMPERATURE: 6; readonly TYPE_TACHO: 7; readonly TYPE_MINITACHO: 8; readonly TYPE_NEWTACHO: 9;
  readonly TYPE_TOUCH: 16; readonly TYPE_COLOR: 29; readonly TYPE_ULTRASONIC: 30; readonly TYPE_GYRO: 32;
  readonly TYPE_IR: 33; readonly TYPE_THIRD_PARTY_START: 50; readonly TYPE_THIRD_PARTY_END: 98;
  readonly TYPE_ENERGYMETER: 99; readonly TYPE_IIC_UNKNOWN: 100; readonly TYPE_NXT_TEST: 101;
  readonly TYPE_NXT_IIC: 123; readonly TYPE_TERMINAL: 124; readonly TYPE_UNKNOWN: 125; readonly TYPE_NONE: 126;
  readonly TYPE_ERROR: 127;
};

/** Program slots of the virtual machine; direct commands run in CMD_SLOT */
export declare const SLOT: {
  readonly GUI_SLOT: 0; readonly USER_SLOT: 1; readonly CMD_SLOT: 2; readonly TERM_SLOT: 3; readonly DEBUG_SLOT: 4;
  readonly CURRENT_SLOT: -1;
};

/** Buttons of the brick */
export declare const BUTTONTYPE: {
  readonly NO_BUTTON: 0; readonly UP_BUTTON: 1; readonly ENTER_BUTTON: 2; readonly DOWN_BUTTON: 3;
  readonly RIGHT_BUTTON: 4; readonly LEFT_BUTTON: 5; readonly BACK_BUTTON: 6; readonly ANY_BUTTON: 7;
};

/** What the file browser on the display lists */
export declare const BROWSERTYPE: {
  readonly BROWSE_FOLDERS: 0; readonly BROWSE_FOLDS_FILES: 1; readonly BROWSE_CACHE: 2; readonly BROWSE_FILES: 3;
};

/** Fonts of the display */
export declare const FONTTYPE: {
  readonly NORMAL_FONT: 0; readonly SMALL_FONT: 1; readonly LARGE_FONT: 2; readonly TINY_FONT: 3;
};

/** Sets of icons; the set decides what an icon's number means */
export declare const ICONTYPE: {
  readonly NORMAL_ICON: 0; readonly SMALL_ICON: 1; readonly LARGE_ICON: 2; readonly MENU_ICON: 3;
  readonly ARROW_ICON: 4;
};

/** Icons of the set SMALL_ICON: battery, Bluetooth, WiFi and USB in the top line */
export declare const S_ICON_NO: {
  readonly SICON_CHARGING: 0; readonly SICON_BATT_4: 1; readonly SICON_BATT_3: 2; readonly SICON_BATT_2: 3;
  readonly SICON_BATT_1: 4; readonly SICON_BATT_0: 5; readonly SICON_WAIT1: 6; readonly SICON_WAIT2: 7;
  readonly SICON_BT_ON: 8; readonly SICON_BT_VISIBLE: 9; readonly SICON_BT_CONNECTED: 10;
  readonly SICON_BT_CONNVISIB: 11; readonly SICON_WIFI_3: 12; readonly SICON_WIFI_2: 13; readonly SICON_WIFI_1: 14;
  readonly SICON_WIFI_CONNECTED: 15; readonly SICON_USB: 21;
};

/** Icons of the set NORMAL_ICON: files, folders and settings */
export declare const N_ICON_NO: {
  readonly ICON_NONE: -1; readonly ICON_RUN: 0; readonly ICON_FOLDER: 1; readonly ICON_FOLDER2: 2; readonly ICON_USB: 3;
  readonly ICON_SD: 4; readonly ICON_SOUND: 5; readonly ICON_IMAGE: 6; readonly ICON_SETTINGS: 7;
  readonly ICON_ONOFF: 8; readonly ICON_SEARCH: 9; readonly ICON_WIFI: 10; readonly ICON_CONNECTIONS: 11;
  readonly ICON_ADD_HIDDEN: 12; readonly ICON_TRASHBIN: 13; readonly ICON_VISIBILITY: 14; readonly ICON_KEY: 15;
  readonly ICON_CONNECT: 16; readonly ICON_DISCONNECT: 17; readonly ICON_UP: 18; readonly ICON_DOWN: 19;
  readonly ICON_WAIT1: 20; readonly ICON_WAIT2: 21; readonly ICON_BLUETOOTH: 22; readonly ICON_INFO: 23;
  readonly ICON_TEXT: 24; readonly ICON_QUESTIONMARK: 27; readonly ICON_INFO_FILE: 28; readonly ICON_DISC: 29;
  readonly ICON_CONNECTED: 30; readonly ICON_OBP: 31; readonly ICON_OBD: 32; readonly ICON_OPENFOLDER: 33;
  readonly ICON_BRICK1: 34;
};

/** Icons of the set LARGE_ICON: answers, warnings and file operations */
export declare const L_ICON_NO: {
  readonly YES_NOTSEL: 0; readonly YES_SEL: 1; readonly NO_NOTSEL: 2; readonly NO_SEL: 3; readonly OFF: 4;
  readonly WAIT_VERT: 5; readonly WAIT_HORZ: 6; readonly TO_MANUAL: 7; readonly WARNSIGN: 8; readonly WARN_BATT: 9;
  readonly WARN_POWER: 10; readonly WARN_TEMP: 11; readonly NO_USBSTICK: 12; readonly TO_EXECUTE: 13;
  readonly TO_BRICK: 14; readonly TO_SDCARD: 15; readonly TO_USBSTICK: 16; readonly TO_BLUETOOTH: 17;
  readonly TO_WIFI: 18; readonly TO_TRASH: 19; readonly TO_COPY: 20; readonly TO_FILE: 21; readonly CHAR_ERROR: 22;
  readonly COPY_ERROR: 23; readonly PROGRAM_ERROR: 24; readonly WARN_MEMORY: 27;
};

/** Icons of the set MENU_ICON: kinds of Bluetooth peers, locks and check boxes */
export declare const M_ICON_NO: {
  readonly ICON_STAR: 0; readonly ICON_LOCKSTAR: 1; readonly ICON_LOCK: 2; readonly ICON_PC: 3; readonly ICON_PHONE: 4;
  readonly ICON_BRICK: 5; readonly ICON_UNKNOWN: 6; readonly ICON_FROM_FOLDER: 7; readonly ICON_CHECKBOX: 8;
  readonly ICON_CHECKED: 9; readonly ICON_XED: 10;
};

/** Icons of the set ARROW_ICON: small arrows */
export declare const A_ICON_NO: {
  readonly ICON_LEFT: 1; readonly ICON_RIGHT: 2;
};

/** Kinds of Bluetooth peers, numbered like their icons in the set MENU_ICON */
export declare const BTTYPE: {
  readonly BTTYPE_PC: 3; readonly BTTYPE_PHONE: 4; readonly BTTYPE_BRICK: 5; readonly BTTYPE_UNKNOWN: 6;
};

/** Colours and rhythms of the light behind the buttons */
export declare const LEDPATTERN: {
  readonly LED_BLACK: 0; readonly LED_GREEN: 1; readonly LED_RED: 2; readonly LED_ORANGE: 3;
  readonly LED_GREEN_FLASH: 4; readonly LED_RED_FLASH: 5; readonly LED_ORANGE_FLASH: 6; readonly LED_GREEN_PULSE: 7;
  readonly LED_RED_PULSE: 8; readonly LED_ORANGE_PULSE: 9;
};

/** Single lights behind the buttons: right or left, red or green */
export declare const LEDTYPE: {
  readonly LED_ALL: 0; readonly LED_RR: 1; readonly LED_RG: 2; readonly LED_LR: 3; readonly LED_LG: 4;
};

/** Kinds of files in the browser; it ORs TYPE_SDCARD or TYPE_USBSTICK to the kind found there */
export declare const FILETYPE: {
  readonly FILETYPE_UNKNOWN: 0; readonly TYPE_FOLDER: 1; readonly TYPE_SOUND: 2; readonly TYPE_BYTECODE: 3;
  readonly TYPE_GRAPHICS: 4; readonly TYPE_DATALOG: 5; readonly TYPE_PROGRAM: 6; readonly TYPE_TEXT: 7;
  readonly TYPE_SDCARD: 16; readonly TYPE_USBSTICK: 32; readonly TYPE_RESTART_BROWSER: -1;
  readonly TYPE_REFRESH_BROWSER: -2;
};

/** Result of an operation, or that it is still running */
export declare const RESULT: {
  readonly OK: 0; readonly BUSY: 1; readonly FAIL: 2; readonly STOP: 4; readonly START: 8;
};

/** Formats of values, for sensors and mailboxes; FORMAT_TYPES has their types */
export declare const DATA_FORMAT: {
  readonly DATA_8: 0; readonly DATA_16: 1; readonly DATA_32: 2; readonly DATA_F: 3; readonly DATA_S: 4;
  readonly DATA_A: 5; readonly DATA_V: 7; readonly DATA_PCT: 16; readonly DATA_RAW: 18; readonly DATA_SI: 19;
};

/** Separators between two values in a text file */
export declare const DEL: {
  readonly DEL_NONE: 0; readonly DEL_TAB: 1; readonly DEL_SPACE: 2; readonly DEL_RETURN: 3; readonly DEL_COLON: 4;
  readonly DEL_COMMA: 5; readonly DEL_LINEFEED: 6; readonly DEL_CRLF: 7;
};

/** Carriers of the protocol */
export declare const HWTYPE: {
  readonly HW_USB: 1; readonly HW_BT: 2; readonly HW_WIFI: 3;
};

/** Encryption of a WiFi network (official and compat firmware only) */
export declare const ENCRYPT: {
  readonly ENCRYPT_NONE: 0; readonly ENCRYPT_WPA2: 1;
};

/** Encryption of a WiFi network, under the names of the extended firmware (xtended firmware only) */
export declare const LMS_ENCRYPT: {
  readonly LMS_ENCRYPT_NONE: 0; readonly LMS_ENCRYPT_WPA2: 1;
};

/** Colour channels of the NXT colour sensor; BLANK is the reading without light */
export declare const COLOR: {
  readonly RED: 0; readonly GREEN: 1; readonly BLUE: 2; readonly BLANK: 3;
};

/** Colours that a colour sensor recognises */
export declare const NXTCOLOR: {
  readonly BLACKCOLOR: 1; readonly BLUECOLOR: 2; readonly GREENCOLOR: 3; readonly YELLOWCOLOR: 4; readonly REDCOLOR: 5;
  readonly WHITECOLOR: 6;
};

/** Warnings of the brick, one bit each; WARNINGS masks those shown to the user */
export declare const WARNING: {
  readonly WARNING_TEMP: 1; readonly WARNING_CURRENT: 2; readonly WARNING_VOLTAGE: 4; readonly WARNING_MEMORY: 8;
  readonly WARNING_DSPSTAT: 16; readonly WARNING_RAM: 32; readonly WARNING_BATTLOW: 64; readonly WARNING_BUSY: 128;
};

/** State of a program or object; one at a time, though each number is a single bit */
export declare const OBJSTAT: {
  readonly RUNNING: 16; readonly WAITING: 32; readonly STOPPED: 64; readonly HALTED: 128;
};

/** Commands to a UART sensor; DEVCMD_FIRE is another name of DEVCMD_RESET (compat lacks it) */
export declare const DEVCMD: {
  readonly DEVCMD_RESET: 17; readonly DEVCMD_FIRE: 17; readonly DEVCMD_CHANNEL: 18;
};

/** Kinds of connection that a port detects */
export declare const CONN: {
  readonly CONN_UNKNOWN: 111; readonly CONN_DAISYCHAIN: 117; readonly CONN_NXT_COLOR: 118; readonly CONN_NXT_DUMB: 119;
  readonly CONN_NXT_IIC: 120; readonly CONN_INPUT_DUMB: 121; readonly CONN_INPUT_UART: 122;
  readonly CONN_OUTPUT_DUMB: 123; readonly CONN_OUTPUT_INTELLIGENT: 124; readonly CONN_OUTPUT_TACHO: 125;
  readonly CONN_NONE: 126; readonly CONN_ERROR: 127;
};

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

/** A function for each operation, which returns its bytes. */
export declare const ops: {
  /**
   * Ends the program with a failure; never valid on the wire
   */
  ERROR(): Uint8Array;
  /**
   * Does nothing; a harmless way to test whether the brick answers
   */
  NOP(): Uint8Array;
  /**
   * Stops the program of a slot
   * @param PRGID program slot to stop (0: all programs; -1: the calling program; a member of SLOT)
   */
  PROGRAM_STOP(PRGID: Value): Uint8Array;
  /**
   * Starts a loaded program; a direct command can do this only while no user program runs
   * @param PRGID program slot (a member of SLOT)
   * @param SIZE size of the image; read and ignored (bytes)
   * @param IP address of the image, as FILE.LOAD_IMAGE returned it
   * @param DEBUG how to run it (0 to 2; 0: run; 1: debug; 2: load, do not run)
   */
  PROGRAM_START(PRGID: Value, SIZE: Value, IP: Value, DEBUG: Value): Uint8Array;
  /**
   * Stops an object of its own program
   * @param OBJID object of the program, counted from 1
   */
  OBJECT_STOP(OBJID: Value): Uint8Array;
  /**
   * Starts an object of its own program
   * @param OBJID object of the program, counted from 1
   */
  OBJECT_START(OBJID: Value): Uint8Array;
  /**
   * Counts an object's trigger down; at zero the object starts
   * @param OBJID object of the program, counted from 1
   */
  OBJECT_TRIG(OBJID: Value): Uint8Array;
  /**
   * Waits until an object has ended
   * @param OBJID object of the program, counted from 1
   */
  OBJECT_WAIT(OBJID: Value): Uint8Array;
  /**
   * Returns from a subroutine to its caller
   */
  RETURN(): Uint8Array;
  /**
   * Calls a subroutine of its own program; waits while another thread runs it
   * @param OBJID object number of the subroutine, counted from 1
   * @param PARAMETERS number of parameters follow; the subroutine declares their types and directions
   */
  CALL(OBJID: Value, PARAMETERS: readonly Any[]): Uint8Array;
  /**
   * Ends the object; the firmware appends one to every direct command
   */
  OBJECT_END(): Uint8Array;
  /**
   * Gives up the rest of the thread's time slice
   */
  SLEEP(): Uint8Array;
  /**
   * Marks a place that jumps can name; does nothing itself
   * @param NO number of the label (0 to 31)
   */
  LABEL(NO: Value): Uint8Array;
  /**
   * Prints a program's memory on the brick's debug terminal
   * @param PRGID program slot (a member of SLOT)
   * @param OBJID object whose local memory to print (0: the global memory)
   * @param OFFSET first byte (bytes)
   * @param SIZE number of bytes to print (0 to 1024 bytes; 0: all, 1024 at most)
   */
  PROBE(PRGID: Value, OBJID: Value, OFFSET: Value, SIZE: Value): Uint8Array;
  /**
   * Runs byte code that is already in memory, ending the slot's previous program
   * @param PRGID program slot (a member of SLOT)
   * @param IMAGE address of the byte code image
   * @param GLOBAL address of the global memory it uses
   */
  DO(PRGID: Value, IMAGE: Value, GLOBAL: Value): Uint8Array;
  /**
   * Runs a shell command on the brick's Linux and waits until it ends
   * @param COMMAND the command line
   * @param STATUS wait status as C's system() gives it: 256 times the exit code (0: success; -1: could not run)
   */
  SYSTEM(COMMAND: Text, STATUS: Argument): Uint8Array;
  /**
   * Splits a motor port number as LEGO's editor writes it
   * @param PortIn three decimal digits, each 1-4: layer, first port, second port (123: B and C)
   * @param Layer position in the daisy chain (0 to 3; 0: this brick)
   * @param Bitfield motor ports as bits: A=1 B=2 C=4 D=8 (0 to 15)
   * @param Inverted whether the first port comes after the second, as in CA (0 to 1; 0: no; 1: yes)
   */
  PORT_CNV_OUTPUT(PortIn: Value, Layer: Argument, Bitfield: Argument, Inverted: Argument): Uint8Array;
  /**
   * Splits a sensor port number as LEGO's editor writes it
   * @param PortIn three decimal digits: layer 1-4, any, port 1-4 (103: port 3)
   * @param Layer position in the daisy chain (0 to 3; 0: this brick)
   * @param PortOut sensor port minus one, as in INPUT_* (0 to 3)
   */
  PORT_CNV_INPUT(PortIn: Value, Layer: Argument, PortOut: Argument): Uint8Array;
  /**
   * Converts the name of a note to its frequency
   * @param NOTE C4 to B6, sharps as C#4
   * @param FREQ frequency; 440 for an unknown note (262 to 1976 Hz)
   */
  NOTE_TO_FREQ(NOTE: Text, FREQ: Argument): Uint8Array;
  /**
   * Stops at breakpoint 0; BP_SET puts it over the instruction it replaces
   */
  BP0(): Uint8Array;
  /**
   * Stops at breakpoint 1; BP_SET puts it over the instruction it replaces
   */
  BP1(): Uint8Array;
  /**
   * Stops at breakpoint 2; BP_SET puts it over the instruction it replaces
   */
  BP2(): Uint8Array;
  /**
   * Pulses test pin TP4 and continues; BP_SET puts it over the instruction it replaces
   */
  BP3(): Uint8Array;
  /**
   * Sets or removes a breakpoint in a running program
   * @param PRGID program slot (a member of SLOT)
   * @param NO number of the breakpoint (0 to 2; 3: pulse on test pin TP4, no stop)
   * @param ADDRESS offset in the image (bytes; 0: remove the breakpoint)
   */
  BP_SET(PRGID: Value, NO: Value, ADDRESS: Value): Uint8Array;
  /**
   * Loads an additional virtual machine; fails while another one is loaded (xtended and compat firmware only)
   * @param VMINDEX which one (0 to 1; 0: RobotC; 1: LabVIEW)
   * @param RESULT OK or FAIL (a member of RESULT)
   */
  DYNLOAD_VMLOAD(VMINDEX: Value, RESULT: Argument): Uint8Array;
  /**
   * Unloads the additional virtual machine (xtended and compat firmware only)
   */
  DYNLOAD_VMEXIT(): Uint8Array;
  /**
   * Calls entry point 0 of the additional virtual machine that is loaded (xtended and compat firmware only)
   * @param CMD function to call, in that machine's numbering
   * @param LENGTH_IN amount of data passed
   * @param LENGTH_OUT number of elements returned
   * @param VALUE the returned elements; their type depends on CMD (as many values as LENGTH_OUT says)
   */
  DYNLOAD_ENTRY_0(CMD: Value, LENGTH_IN: Value, LENGTH_OUT: Argument, VALUE: Argument): Uint8Array;
  /**
   * Calls entry point 1 of the additional virtual machine that is loaded (xtended and compat firmware only)
   * @param CMD function to call, in that machine's numbering
   * @param LENGTH_IN amount of data passed
   * @param LENGTH_OUT number of elements returned
   * @param VALUE the returned elements; their type depends on CMD (as many values as LENGTH_OUT says)
   */
  DYNLOAD_ENTRY_1(CMD: Value, LENGTH_IN: Value, LENGTH_OUT: Argument, VALUE: Argument): Uint8Array;
  /**
   * Calls entry point 2 of the additional virtual machine that is loaded (xtended and compat firmware only)
   * @param CMD function to call, in that machine's numbering
   * @param LENGTH_IN amount of data passed
   * @param LENGTH_OUT number of elements returned
   * @param VALUE the returned elements; their type depends on CMD (as many values as LENGTH_OUT says)
   */
  DYNLOAD_ENTRY_2(CMD: Value, LENGTH_IN: Value, LENGTH_OUT: Argument, VALUE: Argument): Uint8Array;
  /**
   * Calls entry point 3 of the additional virtual machine that is loaded (xtended and compat firmware only)
   * @param CMD function to call, in that machine's numbering
   * @param LENGTH_IN amount of data passed
   * @param LENGTH_OUT number of elements returned
   * @param VALUE the returned elements; their type depends on CMD (as many values as LENGTH_OUT says)
   */
  DYNLOAD_ENTRY_3(CMD: Value, LENGTH_IN: Value, LENGTH_OUT: Argument, VALUE: Argument): Uint8Array;
  /**
   * Calls entry point 4 of the additional virtual machine that is loaded (xtended and compat firmware only)
   * @param CMD function to call, in that machine's numbering
   * @param LENGTH_IN amount of data passed
   * @param LENGTH_OUT number of elements returned
   * @param VALUE the returned elements; their type depends on CMD (as many values as LENGTH_OUT says)
   */
  DYNLOAD_ENTRY_4(CMD: Value, LENGTH_IN: Value, LENGTH_OUT: Argument, VALUE: Argument): Uint8Array;
  /**
   * Calls entry point 5 of the additional virtual machine that is loaded (xtended and compat firmware only)
   * @param CMD function to call, in that machine's numbering
   * @param LENGTH_IN amount of data passed
   * @param LENGTH_OUT number of elements returned
   * @param VALUE the returned elements; their type depends on CMD (as many values as LENGTH_OUT says)
   */
  DYNLOAD_ENTRY_5(CMD: Value, LENGTH_IN: Value, LENGTH_OUT: Argument, VALUE: Argument): Uint8Array;
  /**
   * Calls entry point 6 of the additional virtual machine that is loaded (xtended and compat firmware only)
   * @param CMD function to call, in that machine's numbering
   * @param LENGTH_IN amount of data passed
   * @param LENGTH_OUT number of elements returned
   * @param VALUE the returned elements; their type depends on CMD (as many values as LENGTH_OUT says)
   */
  DYNLOAD_ENTRY_6(CMD: Value, LENGTH_IN: Value, LENGTH_OUT: Argument, VALUE: Argument): Uint8Array;
  /**
   * Calls entry point 7 of the additional virtual machine that is loaded (xtended and compat firmware only)
   * @param CMD function to call, in that machine's numbering
   * @param LENGTH_IN amount of data passed
   * @param LENGTH_OUT number of elements returned
   * @param VALUE the returned elements; their type depends on CMD (as many values as LENGTH_OUT says)
   */
  DYNLOAD_ENTRY_7(CMD: Value, LENGTH_IN: Value, LENGTH_OUT: Argument, VALUE: Argument): Uint8Array;
  /**
   * Calls entry point 8 of the additional virtual machine that is loaded (xtended and compat firmware only)
   * @param CMD function to call, in that machine's numbering
   * @param LENGTH_IN amount of data passed
   * @param LENGTH_OUT number of elements returned
   * @param VALUE the returned elements; their type depends on CMD (as many values as LENGTH_OUT says)
   */
  DYNLOAD_ENTRY_8(CMD: Value, LENGTH_IN: Value, LENGTH_OUT: Argument, VALUE: Argument): Uint8Array;
  /**
   * Calls entry point 9 of the additional virtual machine that is loaded (xtended and compat firmware only)
   * @param CMD function to call, in that machine's numbering
   * @param LENGTH_IN amount of data passed
   * @param LENGTH_OUT number of elements returned
   * @param VALUE the returned elements; their type depends on CMD (as many values as LENGTH_OUT says)
   */
  DYNLOAD_ENTRY_9(CMD: Value, LENGTH_IN: Value, LENGTH_OUT: Argument, VALUE: Argument): Uint8Array;
  /**
   * Asks which additional virtual machine is loaded (xtended and compat firmware only)
   * @param RESULT which one (0 to 1; -1: none; 0: RobotC; 1: LabVIEW)
   */
  DYNLOAD_GET_VM(RESULT: Argument): Uint8Array;
  /**
   * Adds two 8-bit numbers
   * @param SOURCE1 first number
   * @param SOURCE2 second number
   * @param DESTINATION their sum
   */
  ADD8(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Adds two 16-bit numbers
   * @param SOURCE1 first number
   * @param SOURCE2 second number
   * @param DESTINATION their sum
   */
  ADD16(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Adds two 32-bit numbers
   * @param SOURCE1 first number
   * @param SOURCE2 second number
   * @param DESTINATION their sum
   */
  ADD32(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Adds two floating-point numbers
   * @param SOURCE1 first number
   * @param SOURCE2 second number
   * @param DESTINATION their sum
   */
  ADDF(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Subtracts one 8-bit number from another
   * @param SOURCE1 number to subtract from
   * @param SOURCE2 number to subtract
   * @param DESTINATION SOURCE1 less SOURCE2
   */
  SUB8(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Subtracts one 16-bit number from another
   * @param SOURCE1 number to subtract from
   * @param SOURCE2 number to subtract
   * @param DESTINATION SOURCE1 less SOURCE2
   */
  SUB16(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Subtracts one 32-bit number from another
   * @param SOURCE1 number to subtract from
   * @param SOURCE2 number to subtract
   * @param DESTINATION SOURCE1 less SOURCE2
   */
  SUB32(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Subtracts one floating-point number from another
   * @param SOURCE1 number to subtract from
   * @param SOURCE2 number to subtract
   * @param DESTINATION SOURCE1 less SOURCE2
   */
  SUBF(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Multiplies two 8-bit numbers
   * @param SOURCE1 first factor
   * @param SOURCE2 second factor
   * @param DESTINATION their product
   */
  MUL8(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Multiplies two 16-bit numbers
   * @param SOURCE1 first factor
   * @param SOURCE2 second factor
   * @param DESTINATION their product
   */
  MUL16(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Multiplies two 32-bit numbers
   * @param SOURCE1 first factor
   * @param SOURCE2 second factor
   * @param DESTINATION their product
   */
  MUL32(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Multiplies two floating-point numbers
   * @param SOURCE1 first factor
   * @param SOURCE2 second factor
   * @param DESTINATION their product
   */
  MULF(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Divides two 8-bit numbers; by zero gives the largest or smallest value
   * @param SOURCE1 number to divide
   * @param SOURCE2 number to divide by
   * @param DESTINATION quotient, cut off towards zero (0 for 0 / 0)
   */
  DIV8(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Divides two 16-bit numbers; by zero gives the largest or smallest value
   * @param SOURCE1 number to divide
   * @param SOURCE2 number to divide by
   * @param DESTINATION quotient, cut off towards zero (0 for 0 / 0)
   */
  DIV16(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Divides two 32-bit numbers; by zero gives the largest or smallest value
   * @param SOURCE1 number to divide
   * @param SOURCE2 number to divide by
   * @param DESTINATION quotient, cut off towards zero (0 for 0 / 0)
   */
  DIV32(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Divides two floating-point numbers; by zero gives infinity or NaN
   * @param SOURCE1 number to divide
   * @param SOURCE2 number to divide by
   * @param DESTINATION quotient
   */
  DIVF(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Combines 8-bit values, bit by bit, by OR
   * @param SOURCE1 first
   * @param SOURCE2 second
   * @param DESTINATION bits set in either
   */
  OR8(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Combines 16-bit values, bit by bit, by OR
   * @param SOURCE1 first
   * @param SOURCE2 second
   * @param DESTINATION bits set in either
   */
  OR16(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Combines 32-bit values, bit by bit, by OR
   * @param SOURCE1 first
   * @param SOURCE2 second
   * @param DESTINATION bits set in either
   */
  OR32(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Combines 8-bit values, bit by bit, by AND
   * @param SOURCE1 first
   * @param SOURCE2 second
   * @param DESTINATION bits set in both
   */
  AND8(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Combines 16-bit values, bit by bit, by AND
   * @param SOURCE1 first
   * @param SOURCE2 second
   * @param DESTINATION bits set in both
   */
  AND16(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Combines 32-bit values, bit by bit, by AND
   * @param SOURCE1 first
   * @param SOURCE2 second
   * @param DESTINATION bits set in both
   */
  AND32(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Combines 8-bit values, bit by bit, by exclusive OR
   * @param SOURCE1 first
   * @param SOURCE2 second
   * @param DESTINATION bits set in just one of the two
   */
  XOR8(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Combines 16-bit values, bit by bit, by exclusive OR
   * @param SOURCE1 first
   * @param SOURCE2 second
   * @param DESTINATION bits set in just one of the two
   */
  XOR16(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Combines 32-bit values, bit by bit, by exclusive OR
   * @param SOURCE1 first
   * @param SOURCE2 second
   * @param DESTINATION bits set in just one of the two
   */
  XOR32(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Shifts 8-bit values left; despite the name (rotate), bits shifted out on the left are lost
   * @param SOURCE1 value to shift
   * @param SOURCE2 number of places (bits)
   * @param DESTINATION shifted value, filled up with zero bits
   */
  RL8(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Shifts 16-bit values left; despite the name (rotate), bits shifted out on the left are lost
   * @param SOURCE1 value to shift
   * @param SOURCE2 number of places (bits)
   * @param DESTINATION shifted value, filled up with zero bits
   */
  RL16(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Shifts 32-bit values left; despite the name (rotate), bits shifted out on the left are lost
   * @param SOURCE1 value to shift
   * @param SOURCE2 number of places (bits)
   * @param DESTINATION shifted value, filled up with zero bits
   */
  RL32(SOURCE1: Value, SOURCE2: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Draws a random whole number
   * @param MIN smallest number to draw
   * @param MAX largest number to draw
   * @param VALUE the number drawn, MIN to MAX, both included
   */
  RANDOM(MIN: Value, MAX: Value, VALUE: Argument): Uint8Array;
  /**
   * Fills consecutive bytes of memory with constant values
   * @param DESTINATION first byte to fill (as many values as LENGTH says)
   * @param SOURCE number of values that follow; a negative count hangs the brick
   */
  INIT_BYTES(DESTINATION: Argument, SOURCE: readonly Value[]): Uint8Array;
  /**
   * Copies a value to another variable, both 8-bit
   * @param SOURCE value to copy
   * @param DESTINATION copy of the value
   */
  MOVE8_8(SOURCE: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Converts a value, 8-bit to 16-bit; NaN stays NaN
   * @param SOURCE value to copy
   * @param DESTINATION copy of the value
   */
  MOVE8_16(SOURCE: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Converts a value, 8-bit to 32-bit; NaN stays NaN
   * @param SOURCE value to copy
   * @param DESTINATION copy of the value
   */
  MOVE8_32(SOURCE: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Converts a value, 8-bit to floating-point; NaN stays NaN
   * @param SOURCE value to copy
   * @param DESTINATION copy of the value
   */
  MOVE8_F(SOURCE: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Converts a value, 16-bit to 8-bit; limited to what fits, NaN stays NaN
   * @param SOURCE value to copy
   * @param DESTINATION copy of the value
   */
  MOVE16_8(SOURCE: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Copies a value to another variable, both 16-bit
   * @param SOURCE value to copy
   * @param DESTINATION copy of the value
   */
  MOVE16_16(SOURCE: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Converts a value, 16-bit to 32-bit; NaN stays NaN
   * @param SOURCE value to copy
   * @param DESTINATION copy of the value
   */
  MOVE16_32(SOURCE: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Converts a value, 16-bit to floating-point; NaN stays NaN
   * @param SOURCE value to copy
   * @param DESTINATION copy of the value
   */
  MOVE16_F(SOURCE: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Converts a value, 32-bit to 8-bit; limited to what fits, NaN stays NaN
   * @param SOURCE value to copy
   * @param DESTINATION copy of the value
   */
  MOVE32_8(SOURCE: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Converts a value, 32-bit to 16-bit; limited to what fits, NaN stays NaN
   * @param SOURCE value to copy
   * @param DESTINATION copy of the value
   */
  MOVE32_16(SOURCE: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Copies a value to another variable, both 32-bit
   * @param SOURCE value to copy
   * @param DESTINATION copy of the value
   */
  MOVE32_32(SOURCE: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Converts a value, 32-bit to floating-point; NaN stays NaN
   * @param SOURCE value to copy
   * @param DESTINATION copy of the value
   */
  MOVE32_F(SOURCE: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Converts a value, floating-point to 8-bit; limited to what fits, NaN stays NaN
   * @param SOURCE value to copy
   * @param DESTINATION copy of the value
   */
  MOVEF_8(SOURCE: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Converts a value, floating-point to 16-bit; limited to what fits, NaN stays NaN
   * @param SOURCE value to copy
   * @param DESTINATION copy of the value
   */
  MOVEF_16(SOURCE: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Converts a value, floating-point to 32-bit; limited to what fits, NaN stays NaN
   * @param SOURCE value to copy
   * @param DESTINATION copy of the value
   */
  MOVEF_32(SOURCE: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Copies a value to another variable, both floating-point
   * @param SOURCE value to copy
   * @param DESTINATION copy of the value
   */
  MOVEF_F(SOURCE: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Reads one element of an array of 8-bit values
   * @param SOURCE first element of the array, as a variable
   * @param INDEX which element, counted from 0; the firmware does not check it (0 to 127)
   * @param DESTINATION the element's value
   */
  READ8(SOURCE: Value, INDEX: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Reads one element of an array of 16-bit values
   * @param SOURCE first element of the array, as a variable
   * @param INDEX which element, counted from 0; the firmware does not check it (0 to 127)
   * @param DESTINATION the element's value
   */
  READ16(SOURCE: Value, INDEX: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Reads one element of an array of 32-bit values
   * @param SOURCE first element of the array, as a variable
   * @param INDEX which element, counted from 0; the firmware does not check it (0 to 127)
   * @param DESTINATION the element's value
   */
  READ32(SOURCE: Value, INDEX: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Reads one element of an array of floating-point values
   * @param SOURCE first element of the array, as a variable
   * @param INDEX which element, counted from 0; the firmware does not check it (0 to 127)
   * @param DESTINATION the element's value
   */
  READF(SOURCE: Value, INDEX: Value, DESTINATION: Argument): Uint8Array;
  /**
   * Writes one element of an array of 8-bit values
   * @param SOURCE value to write
   * @param INDEX which element, counted from 0; the firmware does not check it (0 to 127)
   * @param DESTINATION first element of the array, as a variable; element INDEX is written
   */
  WRITE8(SOURCE: Value, INDEX: Value, DESTINATION: Value): Uint8Array;
  /**
   * Writes one element of an array of 16-bit values
   * @param SOURCE value to write
   * @param INDEX which element, counted from 0; the firmware does not check it (0 to 127)
   * @param DESTINATION first element of the array, as a variable; element INDEX is written
   */
  WRITE16(SOURCE: Value, INDEX: Value, DESTINATION: Value): Uint8Array;
  /**
   * Writes one element of an array of 32-bit values
   * @param SOURCE value to write
   * @param INDEX which element, counted from 0; the firmware does not check it (0 to 127)
   * @param DESTINATION first element of the array, as a variable; element INDEX is written
   */
  WRITE32(SOURCE: Value, INDEX: Value, DESTINATION: Value): Uint8Array;
  /**
   * Writes one element of an array of floating-point values
   * @param SOURCE value to write
   * @param INDEX which element, counted from 0; the firmware does not check it (0 to 127)
   * @param DESTINATION first element of the array, as a variable; element INDEX is written
   */
  WRITEF(SOURCE: Value, INDEX: Value, DESTINATION: Value): Uint8Array;
  /**
   * Jumps always
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR(OFFSET: Value): Uint8Array;
  /**
   * Jumps if a flag is 0
   * @param FLAG the condition: anything but 0 is true (0: false; 1: true)
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_FALSE(FLAG: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if a flag is not 0
   * @param FLAG the condition: anything but 0 is true (0: false; 1: true)
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_TRUE(FLAG: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if a value is not a number, as read from a sensor without data
   * @param VALUE value to look at
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_NAN(VALUE: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is less than RIGHT, as 8-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_LT8(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is less than RIGHT, as 16-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_LT16(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is less than RIGHT, as 32-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_LT32(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is less than RIGHT, as floating-point numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_LTF(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is greater than RIGHT, as 8-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_GT8(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is greater than RIGHT, as 16-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_GT16(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is greater than RIGHT, as 32-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_GT32(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is greater than RIGHT, as floating-point numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_GTF(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is equal to RIGHT, as 8-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_EQ8(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is equal to RIGHT, as 16-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_EQ16(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is equal to RIGHT, as 32-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_EQ32(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is equal to RIGHT, as floating-point numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_EQF(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is different from RIGHT, as 8-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_NEQ8(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is different from RIGHT, as 16-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_NEQ16(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is different from RIGHT, as 32-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_NEQ32(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is different from RIGHT, as floating-point numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_NEQF(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is less than or equal to RIGHT, as 8-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_LTEQ8(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is less than or equal to RIGHT, as 16-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_LTEQ16(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is less than or equal to RIGHT, as 32-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_LTEQ32(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is less than or equal to RIGHT, as floating-point numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_LTEQF(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is greater than or equal to RIGHT, as 8-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_GTEQ8(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is greater than or equal to RIGHT, as 16-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_GTEQ16(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is greater than or equal to RIGHT, as 32-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_GTEQ32(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Jumps if LEFT is greater than or equal to RIGHT, as floating-point numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param OFFSET how far to jump from the end of this operation; negative jumps back; or a label (bytes)
   */
  JR_GTEQF(LEFT: Value, RIGHT: Value, OFFSET: Value): Uint8Array;
  /**
   * Tests whether LEFT is less than RIGHT, as 8-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_LT8(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is less than RIGHT, as 16-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_LT16(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is less than RIGHT, as 32-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_LT32(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is less than RIGHT, as floating-point numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_LTF(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is greater than RIGHT, as 8-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_GT8(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is greater than RIGHT, as 16-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_GT16(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is greater than RIGHT, as 32-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_GT32(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is greater than RIGHT, as floating-point numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_GTF(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is equal to RIGHT, as 8-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_EQ8(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is equal to RIGHT, as 16-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_EQ16(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is equal to RIGHT, as 32-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_EQ32(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is equal to RIGHT, as floating-point numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_EQF(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is different from RIGHT, as 8-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_NEQ8(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is different from RIGHT, as 16-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_NEQ16(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is different from RIGHT, as 32-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_NEQ32(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is different from RIGHT, as floating-point numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_NEQF(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is less than or equal to RIGHT, as 8-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_LTEQ8(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is less than or equal to RIGHT, as 16-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_LTEQ16(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is less than or equal to RIGHT, as 32-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_LTEQ32(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is less than or equal to RIGHT, as floating-point numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_LTEQF(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is greater than or equal to RIGHT, as 8-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_GTEQ8(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is greater than or equal to RIGHT, as 16-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_GTEQ16(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is greater than or equal to RIGHT, as 32-bit numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_GTEQ32(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Tests whether LEFT is greater than or equal to RIGHT, as floating-point numbers
   * @param LEFT left side of the comparison
   * @param RIGHT right side of the comparison
   * @param FLAG result of the comparison (0 to 1; 0: false; 1: true)
   */
  CP_GTEQF(LEFT: Value, RIGHT: Value, FLAG: Argument): Uint8Array;
  /**
   * Selects one of two 8-bit values by a flag
   * @param FLAG which one: anything but 0 selects SOURCE1 (0: SOURCE2; 1: SOURCE1)
   * @param SOURCE1 value selected if the flag is set
   * @param SOURCE2 value selected if the flag is 0
   * @param RESULT the selected value
   */
  SELECT8(FLAG: Value, SOURCE1: Value, SOURCE2: Value, RESULT: Argument): Uint8Array;
  /**
   * Selects one of two 16-bit values by a flag
   * @param FLAG which one: anything but 0 selects SOURCE1 (0: SOURCE2; 1: SOURCE1)
   * @param SOURCE1 value selected if the flag is set
   * @param SOURCE2 value selected if the flag is 0
   * @param RESULT the selected value
   */
  SELECT16(FLAG: Value, SOURCE1: Value, SOURCE2: Value, RESULT: Argument): Uint8Array;
  /**
   * Selects one of two 32-bit values by a flag
   * @param FLAG which one: anything but 0 selects SOURCE1 (0: SOURCE2; 1: SOURCE1)
   * @param SOURCE1 value selected if the flag is set
   * @param SOURCE2 value selected if the flag is 0
   * @param RESULT the selected value
   */
  SELECT32(FLAG: Value, SOURCE1: Value, SOURCE2: Value, RESULT: Argument): Uint8Array;
  /**
   * Selects one of two floating-point values by a flag
   * @param FLAG which one: anything but 0 selects SOURCE1 (0: SOURCE2; 1: SOURCE1)
   * @param SOURCE1 value selected if the flag is set
   * @param SOURCE2 value selected if the flag is 0
   * @param RESULT the selected value
   */
  SELECTF(FLAG: Value, SOURCE1: Value, SOURCE2: Value, RESULT: Argument): Uint8Array;
  /**
   * Sends the contents of the terminal's output buffer
   */
  UI_FLUSH(): Uint8Array;
  /**
   * Restarts the timer that switches off an idle brick, and reads its time
   * @param MINUTES idle time before switching off (min; 0: never)
   */
  KEEP_ALIVE(MINUTES: Argument): Uint8Array;
  /**
   * Stores the end of a wait and returns at once; TIMER_READY does the waiting
   * @param TIME duration of the wait (0 to 2147483647 ms)
   * @param TIMER variable that gets the end of the wait, on the brick's millisecond clock
   */
  TIMER_WAIT(TIME: Value, TIMER: Argument): Uint8Array;
  /**
   * Waits until the time that TIMER_WAIT stored
   * @param TIMER variable that TIMER_WAIT has set
   */
  TIMER_READY(TIMER: Value): Uint8Array;
  /**
   * Reads the time since the start of the program or direct command that asks
   * @param TIME time since the start (ms)
   */
  TIMER_READ(TIME: Argument): Uint8Array;
  /**
   * Reads the free-running microsecond clock, for differences only
   * @param TIME low 32 bits of the clock, wraps every 71.6 minutes (us)
   */
  TIMER_READ_US(TIME: Argument): Uint8Array;
  /**
   * Reports whether a sound is playing
   * @param BUSY whether a sound is playing (0 to 1; 0: ready; 1: busy)
   */
  SOUND_TEST(BUSY: Argument): Uint8Array;
  /**
   * Waits until the sound has ended (forever after REPEAT, an endless tone or a missing file)
   */
  SOUND_READY(): Uint8Array;
  /**
   * Reads one SI value of each of several devices, sampled in the background
   * @param TIME time between two samples (ms)
   * @param SAMPLES number of devices the arrays list
   * @param INIT place in the sample buffer of each device, -1 starts it anew (as many values as SAMPLES says)
   * @param DEVICES ports, 0 to 3 for sensors, 4 to 7 for motors A to D (as many values as SAMPLES says)
   * @param TYPES type to set for each device (a member of TYPE; as many values as SAMPLES says)
   * @param MODES mode to set for each device (as many values as SAMPLES says)
   * @param DATASETS index of the value to read from each device, from 0 (as many values as SAMPLES says)
   * @param VALUES one value per device, NaN if there is none (as many values as SAMPLES says)
   */
  INPUT_SAMPLE(TIME: Value, SAMPLES: Value, INIT: Value, DEVICES: Value, TYPES: Value, MODES: Value, DATASETS: Value, VALUES: Argument): Uint8Array;
  /**
   * Lists the types of all devices, sensor ports of each layer first, then motor ports
   * @param LENGTH size of the array; 32 holds the whole daisy chain (0 to 127)
   * @param ARRAY type of device at each port (a member of TYPE; as many values as LENGTH says)
   * @param CHANGED whether devices came or went since the last call (0: no change)
   */
  INPUT_DEVICE_LIST(LENGTH: Value, ARRAY: Argument, CHANGED: Argument): Uint8Array;
  /**
   * Sets type and mode and reads the first value in percent at once
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NO port, counted from 0; 16 to 19 for motors (0 to 19)
   * @param TYPE type to set (0: keep the type; a member of TYPE)
   * @param MODE mode to set (0 to 7; -1: keep the mode)
   * @param PCT value, NaN if there is none (%)
   */
  INPUT_READ(LAYER: Value, NO: Value, TYPE: Value, MODE: Value, PCT: Argument): Uint8Array;
  /**
   * Reports whether a device is still changing type or mode
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NO port, counted from 0; 16 to 19 for motors (0 to 19)
   * @param BUSY whether to wait (0 to 1; 0: ready; 1: busy)
   */
  INPUT_TEST(LAYER: Value, NO: Value, BUSY: Argument): Uint8Array;
  /**
   * Waits until a device has valid values
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NO port, counted from 0; 16 to 19 for motors (0 to 19)
   */
  INPUT_READY(LAYER: Value, NO: Value): Uint8Array;
  /**
   * Sets type and mode and reads the first value in SI units at once
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NO port, counted from 0; 16 to 19 for motors (0 to 19)
   * @param TYPE type to set (0: keep the type; a member of TYPE)
   * @param MODE mode to set (0 to 7; -1: keep the mode)
   * @param SI value in the mode's unit, NaN if there is none
   */
  INPUT_READSI(LAYER: Value, NO: Value, TYPE: Value, MODE: Value, SI: Argument): Uint8Array;
  /**
   * Sets type and mode and reads several values at once, in the format asked for
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NO port, counted from 0; 16 to 19 for motors (0 to 19)
   * @param TYPE type to set (0: keep the type; a member of TYPE)
   * @param MODE mode to set (0 to 7; -1: keep the mode)
   * @param FORMAT DATA_PCT, DATA_RAW or DATA_SI; others give NaN (a member of DATA_FORMAT)
   * @param VALUES number of values that follow, each in FORMAT
   */
  INPUT_READEXT(LAYER: Value, NO: Value, TYPE: Value, MODE: Value, FORMAT: Value, VALUES: readonly Argument[]): Uint8Array;
  /**
   * Sends bytes to a UART sensor
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NO sensor port, counted from 0 (0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4)
   * @param BYTES number of bytes to send (1 to 32 bytes)
   * @param DATA bytes to send (as many values as BYTES says)
   */
  INPUT_WRITE(LAYER: Value, NO: Value, BYTES: Value, DATA: Value): Uint8Array;
  /**
   * Sets how a port is connected, for ports whose automatic detection is off (xtended and compat firmware only)
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NO sensor port, counted from 0 (0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4)
   * @param CONN CONN_NXT_IIC, CONN_NXT_DUMB, CONN_INPUT_DUMB or CONN_NONE (a member of CONN)
   */
  INPUT_SET_CONN(LAYER: Value, NO: Value, CONN: Value): Uint8Array;
  /**
   * Fetches the bytes that an I2C sensor answered to INPUT_IIC_WRITE (xtended and compat firmware only)
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NO sensor port, counted from 0 (0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4)
   * @param RDLNG number of bytes to read (0 to 32 bytes)
   * @param RDDATA bytes read (as many values as RDLNG says)
   * @param RESULT OK or FAIL (a member of RESULT)
   */
  INPUT_IIC_READ(LAYER: Value, NO: Value, RDLNG: Value, RDDATA: Argument, RESULT: Argument): Uint8Array;
  /**
   * Reports the state of the I2C bus of a port (xtended and compat firmware only)
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NO sensor port, counted from 0 (0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4)
   * @param RESULT state of the bus (a member of RESULT)
   */
  INPUT_IIC_STATUS(LAYER: Value, NO: Value, RESULT: Argument): Uint8Array;
  /**
   * Sends bytes to an I2C sensor once, without waiting for its answer (xtended and compat firmware only)
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NO sensor port, counted from 0 (0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4)
   * @param WRLNG number of bytes to write (0 to 32 bytes)
   * @param WRDATA bytes to write: I2C address, register, data (as many values as WRLNG says)
   * @param RDLNG number of bytes in the sensor's answer (0 to 32 bytes)
   * @param RESULT state of the bus after the request (a member of RESULT)
   */
  INPUT_IIC_WRITE(LAYER: Value, NO: Value, WRLNG: Value, WRDATA: Value, RDLNG: Value, RESULT: Argument): Uint8Array;
  /**
   * Switches the automatic detection of sensors at a port on or off (xtended and compat firmware only)
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NO sensor port, counted from 0 (0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4)
   * @param ENABLE whether to detect (0 to 1; 0: off; 1: on)
   */
  INPUT_SET_AUTOID(LAYER: Value, NO: Value, ENABLE: Value): Uint8Array;
  /**
   * Reports the type of motor at a port; documented, but not implemented by any firmware (not in any firmware)
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NO port, counted from 0 (0 to 3; 0: A; 1: B; 2: C; 3: D)
   * @param TYPE type of the motor (a member of TYPE)
   */
  OUTPUT_GET_TYPE(LAYER: Value, NO: Value, TYPE: Argument): Uint8Array;
  /**
   * Declares which type of motor is at a port
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NO port, counted from 0 (0 to 3; 0: A; 1: B; 2: C; 3: D)
   * @param TYPE type of the motor (a member of TYPE)
   */
  OUTPUT_SET_TYPE(LAYER: Value, NO: Value, TYPE: Value): Uint8Array;
  /**
   * Sets the tacho counts that moves and OUTPUT_READ use to zero
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NOS ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
   */
  OUTPUT_RESET(LAYER: Value, NOS: Value): Uint8Array;
  /**
   * Stops motors
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NOS ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
   * @param BRAKE what the motors do at the end (0 to 1; 0: coast; 1: brake and hold)
   */
  OUTPUT_STOP(LAYER: Value, NOS: Value, BRAKE: Value): Uint8Array;
  /**
   * Sets the power of motors, which run at the next OUTPUT_START
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NOS ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
   * @param POWER unregulated power; negative: backward (-100 to 100 %)
   */
  OUTPUT_POWER(LAYER: Value, NOS: Value, POWER: Value): Uint8Array;
  /**
   * Sets the speed of motors, which run at the next OUTPUT_START
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NOS ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
   * @param SPEED regulated speed; negative: backward (-100 to 100 %)
   */
  OUTPUT_SPEED(LAYER: Value, NOS: Value, SPEED: Value): Uint8Array;
  /**
   * Starts motors with the power or speed set before
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NOS ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
   */
  OUTPUT_START(LAYER: Value, NOS: Value): Uint8Array;
  /**
   * Sets the direction of motors
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NOS ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
   * @param POL direction (-1 to 1; -1: backward; 0: opposite of the current one; 1: forward)
   */
  OUTPUT_POLARITY(LAYER: Value, NOS: Value, POL: Value): Uint8Array;
  /**
   * Reads speed and tacho count of one motor, 0 on layers other than 0
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NO port, counted from 0 (0 to 3; 0: A; 1: B; 2: C; 3: D)
   * @param SPEED current speed (-100 to 100 %)
   * @param TACHO angle in the current phase of a move; about 0 after one that brakes (degrees)
   */
  OUTPUT_READ(LAYER: Value, NO: Value, SPEED: Argument, TACHO: Argument): Uint8Array;
  /**
   * Reports whether one of the motors is still in a move that ends by itself
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NOS ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
   * @param BUSY whether to wait (0 to 1; 0: ready; 1: busy)
   */
  OUTPUT_TEST(LAYER: Value, NOS: Value, BUSY: Argument): Uint8Array;
  /**
   * Waits until the moves of the motors have ended; ignores those from OUTPUT_START
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NOS ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
   */
  OUTPUT_READY(LAYER: Value, NOS: Value): Uint8Array;
  /**
   * Reports the position of motors; documented, but not implemented by any firmware (not in any firmware)
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NOS ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
   * @param POS position (degrees)
   */
  OUTPUT_POSITION(LAYER: Value, NOS: Value, POS: Argument): Uint8Array;
  /**
   * Turns motors by an angle with unregulated power
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NOS ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
   * @param POWER unregulated power; negative: backward (-100 to 100 %)
   * @param STEP1 angle of the ramp up (0 to 2147483647 degrees)
   * @param STEP2 angle at constant drive (0 to 2147483647 degrees)
   * @param STEP3 angle of the ramp down (0 to 2147483647 degrees)
   * @param BRAKE what the motors do at the end (0 to 1; 0: coast; 1: brake and hold)
   */
  OUTPUT_STEP_POWER(LAYER: Value, NOS: Value, POWER: Value, STEP1: Value, STEP2: Value, STEP3: Value, BRAKE: Value): Uint8Array;
  /**
   * Runs motors for a time with unregulated power
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NOS ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
   * @param POWER unregulated power; negative: backward (-100 to 100 %)
   * @param TIME1 time of the ramp up (0 to 2147483647 ms)
   * @param TIME2 time at constant drive (0 to 2147483647 ms)
   * @param TIME3 time of the ramp down (0 to 2147483647 ms)
   * @param BRAKE what the motors do at the end (0 to 1; 0: coast; 1: brake and hold)
   */
  OUTPUT_TIME_POWER(LAYER: Value, NOS: Value, POWER: Value, TIME1: Value, TIME2: Value, TIME3: Value, BRAKE: Value): Uint8Array;
  /**
   * Turns motors by an angle with regulated speed
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NOS ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
   * @param SPEED regulated speed; negative: backward (-100 to 100 %)
   * @param STEP1 angle of the ramp up (0 to 2147483647 degrees)
   * @param STEP2 angle at constant drive (0 to 2147483647 degrees)
   * @param STEP3 angle of the ramp down (0 to 2147483647 degrees)
   * @param BRAKE what the motors do at the end (0 to 1; 0: coast; 1: brake and hold)
   */
  OUTPUT_STEP_SPEED(LAYER: Value, NOS: Value, SPEED: Value, STEP1: Value, STEP2: Value, STEP3: Value, BRAKE: Value): Uint8Array;
  /**
   * Runs motors for a time with regulated speed
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NOS ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
   * @param SPEED regulated speed; negative: backward (-100 to 100 %)
   * @param TIME1 time of the ramp up (0 to 2147483647 ms)
   * @param TIME2 time at constant drive (0 to 2147483647 ms)
   * @param TIME3 time of the ramp down (0 to 2147483647 ms)
   * @param BRAKE what the motors do at the end (0 to 1; 0: coast; 1: brake and hold)
   */
  OUTPUT_TIME_SPEED(LAYER: Value, NOS: Value, SPEED: Value, TIME1: Value, TIME2: Value, TIME3: Value, BRAKE: Value): Uint8Array;
  /**
   * Turns two motors in step by an angle
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NOS ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
   * @param SPEED regulated speed; negative: backward (-100 to 100 %)
   * @param TURN how tight the turn is, positive slows the higher port, negative the lower (-200 to 200; -200: spin, lower port runs backward; -100: lower port stands still; 0: straight; 100: higher port stands still; 200: spin, higher port runs backward)
   * @param STEP angle of the faster motor (0 to 2147483647 degrees; 0: endless)
   * @param BRAKE what the motors do at the end (0 to 1; 0: coast; 1: brake and hold)
   */
  OUTPUT_STEP_SYNC(LAYER: Value, NOS: Value, SPEED: Value, TURN: Value, STEP: Value, BRAKE: Value): Uint8Array;
  /**
   * Runs two motors in step for a time
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NOS ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
   * @param SPEED regulated speed; negative: backward (-100 to 100 %)
   * @param TURN how tight the turn is, positive slows the higher port, negative the lower (-200 to 200; -200: spin, lower port runs backward; -100: lower port stands still; 0: straight; 100: higher port stands still; 200: spin, higher port runs backward)
   * @param TIME how long to run (0 to 2147483647 ms; 0: endless)
   * @param BRAKE what the motors do at the end (0 to 1; 0: coast; 1: brake and hold)
   */
  OUTPUT_TIME_SYNC(LAYER: Value, NOS: Value, SPEED: Value, TURN: Value, TIME: Value, BRAKE: Value): Uint8Array;
  /**
   * Sets the tacho counts of motors read as sensors to zero
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NOS ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
   */
  OUTPUT_CLR_COUNT(LAYER: Value, NOS: Value): Uint8Array;
  /**
   * Reads the tacho count of a motor read as a sensor
   * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
   * @param NOS port, counted from 0 (0 to 3; 0: A; 1: B; 2: C; 3: D)
   * @param TACHO angle since OUTPUT_CLR_COUNT (degrees)
   */
  OUTPUT_GET_COUNT(LAYER: Value, NOS: Value, TACHO: Argument): Uint8Array;
  /**
   * Stops and resets all motors as the end of a program does
   */
  OUTPUT_PRG_STOP(): Uint8Array;
  /**
   * Writes bytes into the variables of a running program
   * @param PRGID slot of the program, which must be running (0 to 4; a member of SLOT)
   * @param OBJID object whose local memory is meant (0: the program's global memory)
   * @param OFFSET first byte in that memory (0 to 2147483647 bytes)
   * @param SIZE number of bytes (0 to 2147483647 bytes)
   * @param ARRAY the bytes; those beyond the end of the memory are dropped (as many values as SIZE says)
   */
  MEMORY_WRITE(PRGID: Value, OBJID: Value, OFFSET: Value, SIZE: Value, ARRAY: Value): Uint8Array;
  /**
   * Reads bytes from the variables of a running program
   * @param PRGID slot of the program, which must be running (0 to 4; a member of SLOT)
   * @param OBJID object whose local memory is meant (0: the program's global memory)
   * @param OFFSET first byte in that memory (0 to 2147483647 bytes)
   * @param SIZE number of bytes (0 to 2147483647 bytes)
   * @param ARRAY the bytes, zeros beyond the end of the memory (as many values as SIZE says)
   */
  MEMORY_READ(PRGID: Value, OBJID: Value, OFFSET: Value, SIZE: Value, ARRAY: Argument): Uint8Array;
  /**
   * Writes one element of an array, which grows where needed
   * @param HANDLE the array
   * @param INDEX which element, the first is 0 (0 to 5999999)
   * @param VALUE the value, of the array's type
   */
  ARRAY_WRITE(HANDLE: Value, INDEX: Value, VALUE: Any): Uint8Array;
  /**
   * Reads one element of an array
   * @param HANDLE the array
   * @param INDEX which element, the first is 0 (0 to 5999999)
   * @param VALUE the value, of the array's type
   */
  ARRAY_READ(HANDLE: Value, INDEX: Value, VALUE: Argument): Uint8Array;
  /**
   * Adds one element to the end of an array
   * @param HANDLE the array
   * @param VALUE the value, of the array's type
   */
  ARRAY_APPEND(HANDLE: Value, VALUE: Any): Uint8Array;
  /**
   * Reports the total and free memory for user files
   * @param TOTAL total memory (KiB)
   * @param FREE free memory (KiB)
   */
  MEMORY_USAGE(TOTAL: Argument, FREE: Argument): Uint8Array;
  /**
   * Computes the MD5 digest of a file (xtended and compat firmware only)
   * @param NAME path of the file
   * @param MD5SUM the digest, as 16 bytes (16 values)
   * @param SUCCESS whether the file could be read (0: no; 1: yes)
   */
  FILE_MD5SUM(NAME: Text, MD5SUM: Argument, SUCCESS: Argument): Uint8Array;
  /**
   * Waits until nothing is being sent to a device
   * @param HARDWARE carrier to use (a member of HWTYPE)
   * @param NAME name of the other device, empty: the brick's own adapter
   */
  COM_READY(HARDWARE: Value, NAME: Text): Uint8Array;
  /**
   * Does nothing in the firmware; meant to receive data
   * @param VALUE1 carrier, ignored (a member of HWTYPE)
   * @param VALUE2 name of the other device, ignored
   * @param VALUE3 number of bytes, ignored (bytes)
   * @param VALUE4 the bytes, ignored
   */
  COM_READDATA(VALUE1: Value, VALUE2: Value, VALUE3: Value, VALUE4: Value): Uint8Array;
  /**
   * Does nothing in the firmware; meant to send data
   * @param VALUE1 carrier, ignored (a member of HWTYPE)
   * @param VALUE2 name of the other device, ignored
   * @param VALUE3 number of bytes, ignored (bytes)
   * @param VALUE4 the bytes, ignored
   */
  COM_WRITEDATA(VALUE1: Value, VALUE2: Value, VALUE3: Value, VALUE4: Value): Uint8Array;
  /**
   * Reports whether something is still being sent to a device
   * @param HARDWARE carrier to use (a member of HWTYPE)
   * @param NAME name of the other device, empty: the brick's own adapter
   * @param BUSY whether to wait (0 to 1; 0: ready; 1: busy)
   */
  COM_TEST(HARDWARE: Value, NAME: Text, BUSY: Argument): Uint8Array;
  /**
   * Forgets a paired device or a known network
   * @param HARDWARE carrier to use (a member of HWTYPE)
   * @param REMOTE_NAME name of the other device or network
   */
  COM_REMOVE(HARDWARE: Value, REMOTE_NAME: Text): Uint8Array;
  /**
   * Sends a file or a folder to another brick, Bluetooth only
   * @param HARDWARE carrier to use (a member of HWTYPE)
   * @param REMOTE_NAME name of the other device or network
   * @param FILE_NAME path of the file or folder on this brick
   * @param FILE_TYPE TYPE_FOLDER for a folder, else a file (a member of FILETYPE)
   */
  COM_WRITEFILE(HARDWARE: Value, REMOTE_NAME: Text, FILE_NAME: Text, FILE_TYPE: Value): Uint8Array;
  /**
   * Opens a mailbox on this brick, at most 250 bytes of content
   * @param NO number of the mailbox on this brick (0 to 29)
   * @param BOXNAME name of the mailbox (at most 49 characters)
   * @param TYPES type of its values (a member of DATA_FORMAT)
   * @param FIFOSIZE depth of the queue, ignored by the firmware
   * @param VALUES number of values, ignored by the firmware
   */
  MAILBOX_OPEN(NO: Value, BOXNAME: Text, TYPES: Value, FIFOSIZE: Value, VALUES: Value): Uint8Array;
  /**
   * Sends values to a mailbox of another brick, Bluetooth only
   * @param BRICKNAME name of the other brick, empty: all connected ones
   * @param HARDWARE read by the firmware and never used (0: as compilers write; a member of HWTYPE)
   * @param BOXNAME name of the mailbox (at most 49 characters)
   * @param TYPE type of the values (a member of DATA_FORMAT)
   * @param VALUES number of values of TYPE follow; exactly one for a string, of at most 249 characters
   */
  MAILBOX_WRITE(BRICKNAME: Text, HARDWARE: Value, BOXNAME: Text, TYPE: Value, VALUES: readonly Any[]): Uint8Array;
  /**
   * Reads the content of a mailbox and marks it read
   * @param NO number of the mailbox on this brick (0 to 29)
   * @param LENGTH maximum number of bytes to read, ignored by the firmware (bytes)
   * @param VALUES number of values that follow, in the type of MAILBOX_OPEN
   */
  MAILBOX_READ(NO: Value, LENGTH: Value, VALUES: readonly Argument[]): Uint8Array;
  /**
   * Reports whether a mailbox has an unread message
   * @param NO number of the mailbox on this brick (0 to 29)
   * @param BUSY whether to wait (0 to 1; 0: a new message is there; 1: nothing new)
   */
  MAILBOX_TEST(NO: Value, BUSY: Argument): Uint8Array;
  /**
   * Waits for an unread message in a mailbox
   * @param NO number of the mailbox on this brick (0 to 29)
   */
  MAILBOX_READY(NO: Value): Uint8Array;
  /**
   * Closes a mailbox on this brick
   * @param NO number of the mailbox on this brick (0 to 29)
   */
  MAILBOX_CLOSE(NO: Value): Uint8Array;
  /**
   * Returns the size of a mailbox's content (xtended and compat firmware only)
   * @param NO number of the mailbox on this brick (0 to 29)
   * @param SIZE size of the content (bytes)
   */
  MAILBOX_SIZE(NO: Value, SIZE: Argument): Uint8Array;
  readonly PROGRAM_INFO: {
    /**
     * Stops an object of a running program
     * @param PRGID program slot (a member of SLOT)
     * @param OBJID object of the program, counted from 1
     */
    OBJ_STOP(PRGID: Value, OBJID: Value): Uint8Array;
    /**
     * Starts an object of a running program from its beginning
     * @param PRGID program slot (a member of SLOT)
     * @param OBJID object of the program, counted from 1
     */
    OBJ_START(PRGID: Value, OBJID: Value): Uint8Array;
    /**
     * Asks whether a program runs
     * @param PRGID program slot (a member of SLOT)
     * @param DATA state of the program (a member of OBJSTAT)
     */
    GET_STATUS(PRGID: Value, DATA: Argument): Uint8Array;
    /**
     * Asks for a program's speed
     * @param PRGID program slot (a member of SLOT)
     * @param DATA speed since the program started (instructions/s)
     */
    GET_SPEED(PRGID: Value, DATA: Argument): Uint8Array;
    /**
     * Asks how a program ended
     * @param PRGID program slot (a member of SLOT)
     * @param DATA OK, BUSY (still running) or FAIL (a member of RESULT)
     */
    GET_PRGRESULT(PRGID: Value, DATA: Argument): Uint8Array;
    /**
     * Sets how many instructions the calling thread may still run in its time slice
     * @param PRGID program slot (a member of SLOT)
     */
    SET_INSTR(PRGID: Value): Uint8Array;
    /**
     * Asks for the name of a program (xtended and compat firmware only)
     * @param PRGID program slot (a member of SLOT)
     * @param NAME name of the program, zero-terminated
     */
    GET_PRGNAME(PRGID: Value, NAME: Argument): Uint8Array;
  };
  readonly INFO: {
    /**
     * Adds an error to the brick's error log
     * @param NUMBER number of the error (0: nothing is logged)
     */
    SET_ERROR(NUMBER: Value): Uint8Array;
    /**
     * Removes and returns the oldest error of the brick's error log
     * @param NUMBER number of the error (0: the log is empty)
     */
    GET_ERROR(NUMBER: Argument): Uint8Array;
    /**
     * Converts the number of an error to its name
     * @param NUMBER number of the error (0: gives an empty text)
     * @param LENGTH size of the text buffer, including the zero (bytes; -1: no limit)
     * @param DESTINATION name of the error, at most 31 characters (as many bytes as LENGTH says)
     */
    ERRORTEXT(NUMBER: Value, LENGTH: Value, DESTINATION: Argument): Uint8Array;
    /**
     * Reads the volume setting
     * @param VALUE volume (0 to 100 %)
     */
    GET_VOLUME(VALUE: Argument): Uint8Array;
    /**
     * Changes the volume setting
     * @param VALUE volume (0 to 100 %)
     */
    SET_VOLUME(VALUE: Value): Uint8Array;
    /**
     * Reads the idle time after which the brick powers off
     * @param VALUE idle time (0 to 120 min; 0: never)
     */
    GET_MINUTES(VALUE: Argument): Uint8Array;
    /**
     * Changes the idle time after which the brick powers off
     * @param VALUE idle time (0 to 120 min; 0: never)
     */
    SET_MINUTES(VALUE: Value): Uint8Array;
  };
  readonly STRINGS: {
    /**
     * Reads the length of a text
     * @param SOURCE1 text to work on
     * @param SIZE its length, not including the zero (bytes)
     */
    GET_SIZE(SOURCE1: Text, SIZE: Argument): Uint8Array;
    /**
     * Joins two texts
     * @param SOURCE1 first part
     * @param SOURCE2 second part
     * @param DESTINATION resulting text, zero-terminated
     */
    ADD(SOURCE1: Text, SOURCE2: Text, DESTINATION: Argument): Uint8Array;
    /**
     * Reports whether two texts are equal; case matters
     * @param SOURCE1 one text
     * @param SOURCE2 the other text
     * @param RESULT whether they are equal (0 to 1; 0: different; 1: the same)
     */
    COMPARE(SOURCE1: Text, SOURCE2: Text, RESULT: Argument): Uint8Array;
    /**
     * Copies a text
     * @param SOURCE1 text to work on
     * @param DESTINATION resulting text, zero-terminated
     */
    DUPLICATE(SOURCE1: Text, DESTINATION: Argument): Uint8Array;
    /**
     * Writes a floating-point number as text, without trailing zeros
     * @param VALUE number to write; NaN becomes ----
     * @param FIGURES width, including the point; negative aligns left (characters)
     * @param DECIMALS digits after the point
     * @param DESTINATION resulting text, zero-terminated (at most 128 characters)
     */
    VALUE_TO_STRING(VALUE: Value, FIGURES: Value, DECIMALS: Value, DESTINATION: Argument): Uint8Array;
    /**
     * Reads a number from a text
     * @param SOURCE1 text to read; a comma counts as decimal point
     * @param DESTINATION the number
     */
    STRING_TO_VALUE(SOURCE1: Text, DESTINATION: Argument): Uint8Array;
    /**
     * Removes every space from a text
     * @param SOURCE1 text to work on
     * @param DESTINATION resulting text, zero-terminated
     */
    STRIP(SOURCE1: Text, DESTINATION: Argument): Uint8Array;
    /**
     * Writes a whole number as text, with leading zeros
     * @param VALUE number to write
     * @param FIGURES width of the text (characters)
     * @param DESTINATION resulting text, zero-terminated (at most 128 characters)
     */
    NUMBER_TO_STRING(VALUE: Value, FIGURES: Value, DESTINATION: Argument): Uint8Array;
    /**
     * Returns the part of a text after another text found in it
     * @param SOURCE1 text to search
     * @param SOURCE2 text to find; must occur
     * @param DESTINATION resulting text, zero-terminated
     */
    SUB(SOURCE1: Text, SOURCE2: Text, DESTINATION: Argument): Uint8Array;
    /**
     * Writes a floating-point number as text in a format of C's printf
     * @param VALUE number to write
     * @param FORMAT format, such as %5.2f
     * @param SIZE size of the text buffer, including the zero (bytes)
     * @param DESTINATION resulting text (as many bytes as SIZE says)
     */
    VALUE_FORMATTED(VALUE: Value, FORMAT: Text, SIZE: Value, DESTINATION: Argument): Uint8Array;
    /**
     * Writes a whole number as text in a format of C's printf
     * @param VALUE number to write
     * @param FORMAT format, such as %05d or %X
     * @param SIZE size of the text buffer, including the zero (bytes)
     * @param DESTINATION resulting text (as many bytes as SIZE says)
     */
    NUMBER_FORMATTED(VALUE: Value, FORMAT: Text, SIZE: Value, DESTINATION: Argument): Uint8Array;
  };
  readonly TST: {
    /**
     * Allows test commands for 10 seconds; each one restarts the timer
     */
    TST_OPEN(): Uint8Array;
    /**
     * Ends the test mode
     */
    TST_CLOSE(): Uint8Array;
    /**
     * Reads the pins of a connector
     * @param PORT connector: 0..3 are sensor ports 1-4, 16..19 are motor ports A-D (0 to 19)
     * @param LENGTH number of pins to read, usually 5
     * @param STRING one character per pin: 0 low, 1 high (as many values as LENGTH says)
     */
    TST_READ_PINS(PORT: Value, LENGTH: Value, STRING: Argument): Uint8Array;
    /**
     * Sets the pins of a connector
     * @param PORT connector: 0..3 are sensor ports 1-4, 16..19 are motor ports A-D (0 to 19)
     * @param LENGTH number of pins to set, usually 5
     * @param STRING one character per pin: 0 low, 1 high, X floating, - unchanged (as many values as LENGTH says)
     */
    TST_WRITE_PINS(PORT: Value, LENGTH: Value, STRING: Value): Uint8Array;
    /**
     * Reads the analog converter
     * @param INDEX channel: 0..3 pin 1 and 4..7 pin 6 of sensor ports, 8..11 pin 5 of motor ports (0 to 15; 12: battery temperature; 13: motor current; 14: battery current; 15: battery voltage)
     * @param VALUE raw reading (0 to 4095 counts)
     */
    TST_READ_ADC(INDEX: Value, VALUE: Argument): Uint8Array;
    /**
     * Sends bytes on a sensor port's serial line
     * @param PORT sensor port minus one (0 to 3)
     * @param LENGTH number of bytes to send (0 to 63 bytes)
     * @param STRING the bytes (as many values as LENGTH says)
     */
    TST_WRITE_UART(PORT: Value, LENGTH: Value, STRING: Value): Uint8Array;
    /**
     * Reads the bytes received on a sensor port's serial line
     * @param PORT sensor port minus one (0 to 3)
     * @param LENGTH number of bytes to read (0 to 63 bytes)
     * @param STRING the bytes, padded with zeros (as many values as LENGTH says)
     */
    TST_READ_UART(PORT: Value, LENGTH: Value, STRING: Argument): Uint8Array;
    /**
     * Switches the serial lines of all sensor ports on
     * @param BITRATE speed of the line (2400 to 115200 bit/s)
     */
    TST_ENABLE_UART(BITRATE: Value): Uint8Array;
    /**
     * Switches the serial lines of all sensor ports off
     */
    TST_DISABLE_UART(): Uint8Array;
    /**
     * Reads the switch that senses the rechargeable battery
     * @param ACTIVE state of the switch (0 to 1; 0: other batteries; 1: rechargeable battery)
     */
    TST_ACCU_SWITCH(ACTIVE: Argument): Uint8Array;
    /**
     * Starts Bluetooth mode 2, for Apple devices
     */
    TST_BOOT_MODE2(): Uint8Array;
    /**
     * Asks for the state of the start of Bluetooth mode 2
     * @param STATUS OK, BUSY (still starting) or FAIL (0 to 2; a member of RESULT)
     */
    TST_POLL_MODE2(STATUS: Argument): Uint8Array;
    /**
     * Ends Bluetooth mode 2
     */
    TST_CLOSE_MODE2(): Uint8Array;
    /**
     * Asks for the result of the memory test at power-on
     * @param STATUS OK or FAIL (0 to 2; a member of RESULT)
     */
    TST_RAM_CHECK(STATUS: Argument): Uint8Array;
  };
  readonly MATH: {
    /**
     * Raises e to a power
     * @param X the power
     * @param R result
     */
    EXP(X: Value, R: Argument): Uint8Array;
    /**
     * Takes the remainder of a floating-point division
     * @param X number to divide
     * @param Y number to divide by
     * @param R remainder, with the sign of X
     */
    MOD(X: Value, Y: Value, R: Argument): Uint8Array;
    /**
     * Rounds down to a whole number
     * @param X number to work on
     * @param R result
     */
    FLOOR(X: Value, R: Argument): Uint8Array;
    /**
     * Rounds up to a whole number
     * @param X number to work on
     * @param R result
     */
    CEIL(X: Value, R: Argument): Uint8Array;
    /**
     * Rounds to the nearest whole number, halves away from zero
     * @param X number to work on
     * @param R result
     */
    ROUND(X: Value, R: Argument): Uint8Array;
    /**
     * Drops the sign
     * @param X number to work on
     * @param R result
     */
    ABS(X: Value, R: Argument): Uint8Array;
    /**
     * Reverses the sign
     * @param X number to work on
     * @param R result
     */
    NEGATE(X: Value, R: Argument): Uint8Array;
    /**
     * Takes the square root
     * @param X number to work on, not negative
     * @param R result
     */
    SQRT(X: Value, R: Argument): Uint8Array;
    /**
     * Takes the logarithm to base 10
     * @param X number to work on, above 0
     * @param R result
     */
    LOG(X: Value, R: Argument): Uint8Array;
    /**
     * Takes the natural logarithm
     * @param X number to work on, above 0
     * @param R result
     */
    LN(X: Value, R: Argument): Uint8Array;
    /**
     * Takes the sine of an angle in degrees
     * @param X angle (degrees)
     * @param R sine, -1 to 1
     */
    SIN(X: Value, R: Argument): Uint8Array;
    /**
     * Takes the cosine of an angle in degrees
     * @param X angle (degrees)
     * @param R cosine, -1 to 1
     */
    COS(X: Value, R: Argument): Uint8Array;
    /**
     * Takes the tangent of an angle in degrees
     * @param X angle (degrees)
     * @param R tangent
     */
    TAN(X: Value, R: Argument): Uint8Array;
    /**
     * Finds the angle that has a sine
     * @param X sine (-1 to 1)
     * @param R angle (degrees)
     */
    ASIN(X: Value, R: Argument): Uint8Array;
    /**
     * Finds the angle that has a cosine
     * @param X cosine (-1 to 1)
     * @param R angle (degrees)
     */
    ACOS(X: Value, R: Argument): Uint8Array;
    /**
     * Finds the angle that has a tangent
     * @param X tangent
     * @param R angle (degrees)
     */
    ATAN(X: Value, R: Argument): Uint8Array;
    /**
     * Takes the remainder of an 8-bit division
     * @param X number to divide
     * @param Y number to divide by, not 0
     * @param R remainder, with the sign of X
     */
    MOD8(X: Value, Y: Value, R: Argument): Uint8Array;
    /**
     * Takes the remainder of a 16-bit division
     * @param X number to divide
     * @param Y number to divide by, not 0
     * @param R remainder, with the sign of X
     */
    MOD16(X: Value, Y: Value, R: Argument): Uint8Array;
    /**
     * Takes the remainder of a 32-bit division
     * @param X number to divide
     * @param Y number to divide by, not 0
     * @param R remainder, with the sign of X
     */
    MOD32(X: Value, Y: Value, R: Argument): Uint8Array;
    /**
     * Raises a number to a power
     * @param X number to raise
     * @param Y the power
     * @param R result
     */
    POW(X: Value, Y: Value, R: Argument): Uint8Array;
    /**
     * Cuts off decimals without rounding
     * @param X number to work on
     * @param P number of decimals to keep (at most 6 are available) (0 to 9)
     * @param R result
     */
    TRUNC(X: Value, P: Value, R: Argument): Uint8Array;
  };
  readonly UI_READ: {
    /**
     * Reads the battery voltage
     * @param VALUE voltage (V)
     */
    GET_VBATT(VALUE: Argument): Uint8Array;
    /**
     * Reads the battery current
     * @param VALUE current (A)
     */
    GET_IBATT(VALUE: Argument): Uint8Array;
    /**
     * Reads name and version of the operating system
     * @param LENGTH maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no limit)
     * @param DESTINATION system and kernel release, such as Linux 2.6.33-rc4 (as many bytes as LENGTH says)
     */
    GET_OS_VERS(LENGTH: Value, DESTINATION: Argument): Uint8Array;
    /**
     * Reads and clears the pending event (used by the brick's own menus)
     * @param EVENT what happened (0: nothing; 1: Bluetooth asks for a PIN; 2: Bluetooth asks to confirm a connection)
     */
    GET_EVENT(EVENT: Argument): Uint8Array;
    /**
     * Reads the rise in battery temperature, estimated from the current
     * @param VALUE estimated rise in temperature (°C)
     */
    GET_TBATT(VALUE: Argument): Uint8Array;
    /**
     * Reads the battery current smoothed over time
     * @param IINT integrated current (A)
     */
    GET_IINT(IINT: Argument): Uint8Array;
    /**
     * Reads the current of all motors together
     * @param VALUE current (A)
     */
    GET_IMOTOR(VALUE: Argument): Uint8Array;
    /**
     * Waits for a line typed at the terminal and reads it
     * @param LENGTH maximum number of bytes to return, not including the zero (0 to 127 bytes)
     * @param DESTINATION the line (as many bytes as LENGTH says)
     */
    GET_STRING(LENGTH: Value, DESTINATION: Argument): Uint8Array;
    /**
     * Reads the hardware version
     * @param LENGTH maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no limit)
     * @param DESTINATION hardware version, such as V0.60 (as many bytes as LENGTH says)
     */
    GET_HW_VERS(LENGTH: Value, DESTINATION: Argument): Uint8Array;
    /**
     * Reads the firmware version
     * @param LENGTH maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no limit)
     * @param DESTINATION firmware version, such as V1.04H (as many bytes as LENGTH says)
     */
    GET_FW_VERS(LENGTH: Value, DESTINATION: Argument): Uint8Array;
    /**
     * Reads the build time of the firmware
     * @param LENGTH maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no limit)
     * @param DESTINATION build time as yymmddhhmm (as many bytes as LENGTH says)
     */
    GET_FW_BUILD(LENGTH: Value, DESTINATION: Argument): Uint8Array;
    /**
     * Reads the build time of the operating system
     * @param LENGTH maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no limit)
     * @param DESTINATION build time as yymmddhhmm (as many bytes as LENGTH says)
     */
    GET_OS_BUILD(LENGTH: Value, DESTINATION: Argument): Uint8Array;
    /**
     * Waits for a decimal number typed at the terminal and reads it (debugging)
     * @param VALUE the number, meant as an address
     */
    GET_ADDRESS(VALUE: Argument): Uint8Array;
    /**
     * Waits for byte code typed as hex at the terminal and builds a program from it (debugging)
     * @param LENGTH maximum number of bytes of the program, including headers (bytes)
     * @param IMAGE address of the memory where the program is built
     * @param GLOBAL address of the program's global variables
     * @param FLAG whether the program can be started; 1 or unchanged (1: ready)
     */
    GET_CODE(LENGTH: Value, IMAGE: Value, GLOBAL: Argument, FLAG: Argument): Uint8Array;
    /**
     * Takes one key from the terminal without waiting
     * @param VALUE character code of the key (0: no key)
     */
    KEY(VALUE: Argument): Uint8Array;
    /**
     * Reads and clears the request to shut down (used by the brick's own menus)
     * @param FLAG whether the brick wants to shut down (0 to 1; 0: no; 1: yes)
     */
    GET_SHUTDOWN(FLAG: Argument): Uint8Array;
    /**
     * Reads the brick's warnings
     * @param WARNINGS one bit for each warning (0: none; a member of WARNING)
     */
    GET_WARNING(WARNINGS: Argument): Uint8Array;
    /**
     * Reads the battery level, derived from its voltage
     * @param PCT battery level (0 to 100 %)
     */
    GET_LBATT(PCT: Argument): Uint8Array;
    /**
     * Reads one line of the text of a text box
     * @param TEXT whole text of the box, its lines separated by DEL
     * @param SIZE size of the box's text buffer, including the zero (bytes)
     * @param DEL what separates the lines (a member of DEL)
     * @param LENGTH maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no limit)
     * @param LINE which line, counted from 1
     * @param DESTINATION the line, empty if there is no such line (as many bytes as LENGTH says)
     */
    TEXTBOX_READ(TEXT: Text, SIZE: Value, DEL: Value, LENGTH: Value, LINE: Value, DESTINATION: Argument): Uint8Array;
    /**
     * Reads name, version and build date of the firmware in one string
     * @param LENGTH maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no limit)
     * @param DESTINATION such as LMS2012 V1.04H(Jul 26 2013 12:00:00) (as many bytes as LENGTH says)
     */
    GET_VERSION(LENGTH: Value, DESTINATION: Argument): Uint8Array;
    /**
     * Reads the brick's IP address
     * @param LENGTH maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no limit)
     * @param DESTINATION address in dotted notation (as many bytes as LENGTH says)
     */
    GET_IP(LENGTH: Value, DESTINATION: Argument): Uint8Array;
    /**
     * Reads all values of the power supply at once
     * @param VBATT battery voltage (V)
     * @param IBATT battery current (A)
     * @param IINT battery current smoothed over time (A)
     * @param IMOTOR current of all motors together (A)
     */
    GET_POWER(VBATT: Argument, IBATT: Argument, IINT: Argument, IMOTOR: Argument): Uint8Array;
    /**
     * Reads whether an SD card is present, and its space
     * @param STATE whether one is present (0 to 1; 0: absent; 1: present)
     * @param TOTAL size (KiB)
     * @param FREE free space (KiB)
     */
    GET_SDCARD(STATE: Argument, TOTAL: Argument, FREE: Argument): Uint8Array;
    /**
     * Reads whether a USB stick is present, and its space
     * @param STATE whether one is present (0 to 1; 0: absent; 1: present)
     * @param TOTAL size (KiB)
     * @param FREE free space (KiB)
     */
    GET_USBSTICK(STATE: Argument, TOTAL: Argument, FREE: Argument): Uint8Array;
  };
  readonly UI_WRITE: {
    /**
     * Sends the contents of the terminal's output buffer, like UI_FLUSH
     */
    WRITE_FLUSH(): Uint8Array;
    /**
     * Writes a number in a fixed format to the terminal
     * @param VALUE number to write
     * @param FIGURES total number of characters, including the decimal point; negative aligns left
     * @param DECIMALS digits after the decimal point
     */
    FLOATVALUE(VALUE: Value, FIGURES: Value, DECIMALS: Value): Uint8Array;
    /**
     * Writes time, program, object, position and a comment to the terminal
     * @param VALUE remark
     */
    STAMP(VALUE: Text): Uint8Array;
    /**
     * Writes text to the terminal
     * @param STRING text to write
     */
    PUT_STRING(STRING: Text): Uint8Array;
    /**
     * Writes a whole number to the terminal
     * @param VALUE number to write
     */
    VALUE8(VALUE: Value): Uint8Array;
    /**
     * Writes an unsigned whole number to the terminal
     * @param VALUE number to write
     */
    VALUE16(VALUE: Value): Uint8Array;
    /**
     * Writes a whole number to the terminal
     * @param VALUE number to write
     */
    VALUE32(VALUE: Value): Uint8Array;
    /**
     * Writes a number to the terminal
     * @param VALUE number to write
     */
    VALUEF(VALUE: Value): Uint8Array;
    /**
     * Not implemented in the firmware: the program that runs it fails
     * @param VALUE address; never written
     */
    ADDRESS(VALUE: Argument): Uint8Array;
    /**
     * Writes bytes of memory as hex to the terminal
     * @param ARRAY address of the bytes
     * @param LENGTH number of bytes (bytes)
     */
    CODE(ARRAY: Value, LENGTH: Value): Uint8Array;
    /**
     * Plays the sound of a finished download and refreshes the file browser
     */
    DOWNLOAD_END(): Uint8Array;
    /**
     * Blocks or unblocks the display and the buttons for programs
     * @param STATUS whether drawing is ignored (0 to 1; 0: normal; 1: blocked)
     */
    SCREEN_BLOCK(STATUS: Value): Uint8Array;
    /**
     * Selects the debug pulses that are shown (only in debug builds of the firmware)
     * @param VALUE sum of bits (1: menu background; 2: browser; 4: key)
     */
    ALLOW_PULSE(VALUE: Value): Uint8Array;
    /**
     * Raises debug pulses (only in debug builds of the firmware)
     * @param VALUE sum of bits (1: menu background; 2: browser; 4: key)
     */
    SET_PULSE(VALUE: Value): Uint8Array;
    /**
     * Appends a line to the text of a text box
     * @param TEXT whole text of the box, its lines separated by DEL (as many bytes as SIZE says)
     * @param SIZE size of the box's text buffer, including the zero (bytes)
     * @param DEL what separates the lines (a member of DEL)
     * @param SOURCE line to append
     */
    TEXTBOX_APPEND(TEXT: Argument, SIZE: Value, DEL: Value, SOURCE: Text): Uint8Array;
    /**
     * Sets or clears the busy bit among the warnings
     * @param VALUE whether the brick counts as busy (0 to 1; 0: no; 1: yes)
     */
    SET_BUSY(VALUE: Value): Uint8Array;
    /**
     * Sets the test pin on the brick's circuit board
     * @param STATE level of the pin (0 to 1; 0: low; 1: high)
     */
    SET_TESTPIN(STATE: Value): Uint8Array;
    /**
     * Shows the animation of a running program until something draws
     */
    INIT_RUN(): Uint8Array;
    /**
     * Does nothing
     */
    UPDATE_RUN(): Uint8Array;
    /**
     * Sets colour and blinking of the light around the buttons
     * @param PATTERN colour and rhythm (a member of LEDPATTERN)
     */
    LED(PATTERN: Value): Uint8Array;
    /**
     * Sets the flag that makes the power driver switch off when the firmware ends
     * @param VALUE the flag (0 to 1)
     */
    POWER(VALUE: Value): Uint8Array;
    /**
     * Adds the current values to the graph of GRAPH_SETUP
     */
    GRAPH_SAMPLE(): Uint8Array;
    /**
     * Switches the debug terminal on or off
     * @param STATE whether the terminal is on (0 to 1; 0: off; 1: on)
     */
    TERMINAL(STATE: Value): Uint8Array;
  };
  readonly UI_BUTTON: {
    /**
     * Reports whether a button was pressed since the last query, and clears the press
     * @param BUTTON which button (a member of BUTTONTYPE)
     * @param STATE whether the button was pressed (0 to 1; 0: no; 1: yes)
     */
    SHORTPRESS(BUTTON: Value, STATE: Argument): Uint8Array;
    /**
     * Reports whether a button was held for 3 s since the last query, and clears it
     * @param BUTTON which button (a member of BUTTONTYPE)
     * @param STATE whether the button was held for 3 s (0 to 1; 0: no; 1: yes)
     */
    LONGPRESS(BUTTON: Value, STATE: Argument): Uint8Array;
    /**
     * Waits until any button has been pressed, by hand or by PRESS
     */
    WAIT_FOR_PRESS(): Uint8Array;
    /**
     * Clears all pending presses
     */
    FLUSH(): Uint8Array;
    /**
     * Presses a button as if by hand and holds it until RELEASE
     * @param BUTTON which button (a member of BUTTONTYPE)
     */
    PRESS(BUTTON: Value): Uint8Array;
    /**
     * Releases a button that PRESS holds
     * @param BUTTON which button (a member of BUTTONTYPE)
     */
    RELEASE(BUTTON: Value): Uint8Array;
    /**
     * Reads the left and right buttons as one axis, and clears their presses
     * @param VALUE direction (-1 to 1; -1: left; 1: right; 0: not pressed)
     */
    GET_HORZ(VALUE: Argument): Uint8Array;
    /**
     * Reads the up and down buttons as one axis, and clears their presses
     * @param VALUE direction (-1 to 1; -1: up; 1: down; 0: not pressed)
     */
    GET_VERT(VALUE: Argument): Uint8Array;
    /**
     * Reports whether a button is down at the moment
     * @param BUTTON which button (a member of BUTTONTYPE)
     * @param STATE whether the button is down (0 to 1; 0: no; 1: yes)
     */
    PRESSED(BUTTON: Value, STATE: Argument): Uint8Array;
    /**
     * Blocks or unblocks the back button, which ends the running program
     * @param BLOCKED whether the back button is blocked (0 to 1; 0: not blocked; 1: blocked)
     */
    SET_BACK_BLOCK(BLOCKED: Value): Uint8Array;
    /**
     * Reports whether the back button is blocked
     * @param BLOCKED whether the back button is blocked (0 to 1; 0: not blocked; 1: blocked)
     */
    GET_BACK_BLOCK(BLOCKED: Argument): Uint8Array;
    /**
     * Reports, like SHORTPRESS, whether a button was pressed, without clearing the press
     * @param BUTTON which button (a member of BUTTONTYPE)
     * @param STATE whether the button was pressed (0 to 1; 0: no; 1: yes)
     */
    TESTSHORTPRESS(BUTTON: Value, STATE: Argument): Uint8Array;
    /**
     * Reports, like LONGPRESS, whether a button was held for 3 s, without clearing it
     * @param BUTTON which button (a member of BUTTONTYPE)
     * @param STATE whether the button was held for 3 s (0 to 1; 0: no; 1: yes)
     */
    TESTLONGPRESS(BUTTON: Value, STATE: Argument): Uint8Array;
    /**
     * Reports whether a button was pressed and released since the last query, and clears it (official and xtended firmware only)
     * @param BUTTON which button (a member of BUTTONTYPE)
     * @param STATE whether the button was pressed and released (0 to 1; 0: no; 1: yes)
     */
    GET_BUMBED(BUTTON: Value, STATE: Argument): Uint8Array;
    /**
     * Reports whether a button was pressed and released since the last query, and clears it (compat firmware only)
     * @param BUTTON which button (a member of BUTTONTYPE)
     * @param STATE whether the button was pressed and released (0 to 1; 0: no; 1: yes)
     */
    GET_BUMPED(BUTTON: Value, STATE: Argument): Uint8Array;
    /**
     * Reports whether a key click is due for a handled press, and clears it
     * @param CLICK whether a click is due (0 to 1; 0: no; 1: yes)
     */
    GET_CLICK(CLICK: Argument): Uint8Array;
  };
  readonly UI_DRAW: {
    /**
     * Shows on the display what has been drawn, and restores the normal font
     */
    UPDATE(): Uint8Array;
    /**
     * Clears the canvas to white, and restores the normal font
     */
    CLEAN(): Uint8Array;
    /**
     * Draws one pixel
     * @param COLOR colour to draw in (0 to 1; 0: white; 1: black)
     * @param X0 column (0 to 177 px)
     * @param Y0 row (0 to 127 px)
     */
    PIXEL(COLOR: Value, X0: Value, Y0: Value): Uint8Array;
    /**
     * Draws a line between two points
     * @param COLOR colour to draw in (0 to 1; 0: white; 1: black)
     * @param X0 column of the start (0 to 177 px)
     * @param Y0 row of the start (0 to 127 px)
     * @param X1 column of the end (0 to 178 px)
     * @param Y1 row of the end (0 to 128 px)
     */
    LINE(COLOR: Value, X0: Value, Y0: Value, X1: Value, Y1: Value): Uint8Array;
    /**
     * Draws a circle
     * @param COLOR colour to draw in (0 to 1; 0: white; 1: black)
     * @param X0 column of the centre (0 to 177 px)
     * @param Y0 row of the centre (0 to 127 px)
     * @param R radius (px; 0: draws nothing)
     */
    CIRCLE(COLOR: Value, X0: Value, Y0: Value, R: Value): Uint8Array;
    /**
     * Draws text in the font chosen by SELECT_FONT
     * @param COLOR colour to draw in (0 to 1; 0: white; 1: black)
     * @param X0 left edge (0 to 177 px)
     * @param Y0 top edge (0 to 127 px)
     * @param STRING text to draw
     */
    TEXT(COLOR: Value, X0: Value, Y0: Value, STRING: Text): Uint8Array;
    /**
     * Draws one of the built-in icons
     * @param COLOR colour to draw in (0 to 1; 0: white; 1: black)
     * @param X0 left edge (0 to 177 px)
     * @param Y0 top edge (0 to 127 px)
     * @param TYPE set of icons (a member of ICONTYPE)
     * @param NO number of the icon in its set
     */
    ICON(COLOR: Value, X0: Value, Y0: Value, TYPE: Value, NO: Value): Uint8Array;
    /**
     * Draws a picture from memory
     * @param COLOR colour to draw in (0 to 1; 0: white; 1: black)
     * @param X0 left edge (0 to 177 px)
     * @param Y0 top edge (0 to 127 px)
     * @param IP address of the picture (0: draws nothing)
     */
    PICTURE(COLOR: Value, X0: Value, Y0: Value, IP: Value): Uint8Array;
    /**
     * Draws a number, or dashes where it is not a number
     * @param COLOR colour to draw in (0 to 1; 0: white; 1: black)
     * @param X0 left edge (0 to 177 px)
     * @param Y0 top edge (0 to 127 px)
     * @param VALUE number to draw
     * @param FIGURES total number of characters, including the decimal point; negative aligns left
     * @param DECIMALS digits after the decimal point
     */
    VALUE(COLOR: Value, X0: Value, Y0: Value, VALUE: Value, FIGURES: Value, DECIMALS: Value): Uint8Array;
    /**
     * Draws a filled rectangle
     * @param COLOR colour to draw in (0 to 1; 0: white; 1: black)
     * @param X0 left edge (0 to 177 px)
     * @param Y0 top edge (0 to 127 px)
     * @param X1 width (0 to 178 px)
     * @param Y1 height (0 to 128 px)
     */
    FILLRECT(COLOR: Value, X0: Value, Y0: Value, X1: Value, Y1: Value): Uint8Array;
    /**
     * Draws the outline of a rectangle (official firmware only)
     * @param COLOR colour to draw in (0 to 1; 0: white; 1: black)
     * @param X0 left edge (0 to 177 px)
     * @param Y0 top edge (0 to 127 px)
     * @param X1 width (0 to 178 px)
     * @param Y1 height (0 to 128 px)
     */
    RECT(COLOR: Value, X0: Value, Y0: Value, X1: Value, Y1: Value): Uint8Array;
    /**
     * Draws the outline of a rectangle (xtended and compat firmware only)
     * @param COLOR colour to draw in (0 to 1; 0: white; 1: black)
     * @param X0 left edge (0 to 177 px)
     * @param Y0 top edge (0 to 127 px)
     * @param X1 width (0 to 178 px)
     * @param Y1 height (0 to 128 px)
     */
    RECTANGLE(COLOR: Value, X0: Value, Y0: Value, X1: Value, Y1: Value): Uint8Array;
    /**
     * Shows icons and text in a window and waits for the centre button
     * @param COLOR colour to draw in (0 to 1; 0: white; 1: black)
     * @param X0 left edge (0 to 177 px)
     * @param Y0 top edge (0 to 127 px)
     * @param ICON1 first large icon (-1: none; a member of L_ICON_NO)
     * @param ICON2 second large icon (-1: none; a member of L_ICON_NO)
     * @param ICON3 third large icon (-1: none; a member of L_ICON_NO)
     * @param STRING text beside the icons; may be empty
     * @param STATE variable for the dialogue's progress; must be 0 at first (0 to 1; 0: start, or done; 1: being shown)
     */
    NOTIFICATION(COLOR: Value, X0: Value, Y0: Value, ICON1: Value, ICON2: Value, ICON3: Value, STRING: Text, STATE: Argument): Uint8Array;
    /**
     * Shows icons in a window and waits for yes or no
     * @param COLOR colour to draw in (0 to 1; 0: white; 1: black)
     * @param X0 left edge (0 to 177 px)
     * @param Y0 top edge (0 to 127 px)
     * @param ICON1 first large icon (-1: none; a member of L_ICON_NO)
     * @param ICON2 second large icon (-1: none; a member of L_ICON_NO)
     * @param STRING text of the question (LEGO's firmware does not show it)
     * @param STATE variable for the dialogue's progress; must be 0 at first (0 to 1; 0: start, or done; 1: being shown)
     * @param OK answer; the variable's previous value is selected at first (-1 to 1; 0: no; 1: yes; -1: closed with the back button)
     */
    QUESTION(COLOR: Value, X0: Value, Y0: Value, ICON1: Value, ICON2: Value, STRING: Text, STATE: Argument, OK: Argument): Uint8Array;
    /**
     * Shows a keyboard on the display and waits until a text has been entered
     * @param COLOR colour to draw in (0 to 1; 0: white; 1: black)
     * @param X0 left edge (0 to 177 px)
     * @param Y0 top edge (0 to 127 px)
     * @param ICON normal icon before the caption (a member of N_ICON_NO)
     * @param LENGTH maximum number of bytes to return, including the zero (0 to 127 bytes)
     * @param DEFAULT caption above the text, not a preset as its name says (0: none)
     * @param CHARSET variable with the sum of the allowed kinds of text; becomes 0 once the keyboard is shown
     * @param STRING entered text; the variable's previous text is edited, the back button empties it (as many bytes as LENGTH says)
     */
    KEYBOARD(COLOR: Value, X0: Value, Y0: Value, ICON: Value, LENGTH: Value, DEFAULT: Text, CHARSET: Argument, STRING: Argument): Uint8Array;
    /**
     * Shows files and folders and waits until one is chosen
     * @param TYPE what to list (a member of BROWSERTYPE)
     * @param X0 left edge (0 to 177 px)
     * @param Y0 top edge (0 to 127 px)
     * @param X1 width (0 to 178 px)
     * @param Y1 height (0 to 128 px)
     * @param LENGTH maximum number of bytes to return, including the zero (0 to 127 bytes)
     * @param ITEM_TYPE kind of the chosen entry; the variable must be 0 at first (a member of FILETYPE)
     * @param STRING path of the chosen entry; set the variable to the top folder first (as many bytes as LENGTH says)
     */
    BROWSE(TYPE: Value, X0: Value, Y0: Value, X1: Value, Y1: Value, LENGTH: Value, ITEM_TYPE: Argument, STRING: Argument): Uint8Array;
    /**
     * Draws a vertical scroll bar
     * @param COLOR colour to draw in (0 to 1; 0: white; 1: black)
     * @param X0 left edge (0 to 177 px)
     * @param Y0 top edge (0 to 127 px)
     * @param X1 width (0 to 178 px)
     * @param Y1 height (0 to 128 px)
     * @param MIN value at one end of the bar
     * @param MAX value at the other end of the bar
     * @param ACT value that the knob shows
     */
    VERTBAR(COLOR: Value, X0: Value, Y0: Value, X1: Value, Y1: Value, MIN: Value, MAX: Value, ACT: Value): Uint8Array;
    /**
     * Swaps black and white in a rectangle
     * @param X0 left edge (0 to 177 px)
     * @param Y0 top edge (0 to 127 px)
     * @param X1 width (0 to 178 px)
     * @param Y1 height (0 to 128 px)
     */
    INVERSERECT(X0: Value, Y0: Value, X1: Value, Y1: Value): Uint8Array;
    /**
     * Chooses the font for text, until UPDATE, CLEAN or FILLWINDOW
     * @param TYPE font (0 to 3; a member of FONTTYPE)
     */
    SELECT_FONT(TYPE: Value): Uint8Array;
    /**
     * Switches the status line at the top on or off
     * @param ENABLE whether the status line is shown (0 to 1; 0: disabled; 1: enabled)
     */
    TOPLINE(ENABLE: Value): Uint8Array;
    /**
     * Fills rows over the whole width, and restores the normal font
     * @param COLOR colour to fill with; any other value makes a test pattern (0: white; 1: black)
     * @param Y0 top edge (0 to 127 px)
     * @param Y1 height; nothing is filled if Y0 plus it is 128 or more (0 to 127 px; 0: down to the bottom)
     */
    FILLWINDOW(COLOR: Value, Y0: Value, Y1: Value): Uint8Array;
    /**
     * Moves the canvas up
     * @param Y distance (1 to 127 px)
     */
    SCROLL(Y: Value): Uint8Array;
    /**
     * Draws a dashed line between two points
     * @param COLOR colour to draw in (0 to 1; 0: white; 1: black)
     * @param X0 column of the start (0 to 177 px)
     * @param Y0 row of the start (0 to 127 px)
     * @param X1 column of the end (0 to 178 px)
     * @param Y1 row of the end (0 to 128 px)
     * @param ON length of a dash (px)
     * @param OFF length of a gap (px)
     */
    DOTLINE(COLOR: Value, X0: Value, Y0: Value, X1: Value, Y1: Value, ON: Value, OFF: Value): Uint8Array;
    /**
     * Draws a number centred in its place, or > instead of digits if it does not fit
     * @param COLOR colour to draw in (0 to 1; 0: white; 1: black)
     * @param X0 left edge (0 to 177 px)
     * @param Y0 top edge (0 to 127 px)
     * @param VALUE number to draw
     * @param FIGURES total number of characters, including the decimal point
     * @param DECIMALS digits after the decimal point
     */
    VIEW_VALUE(COLOR: Value, X0: Value, Y0: Value, VALUE: Value, FIGURES: Value, DECIMALS: Value): Uint8Array;
    /**
     * Draws a number in large figures and its unit in small letters
     * @param COLOR colour to draw in (0 to 1; 0: white; 1: black)
     * @param X0 left edge (0 to 177 px)
     * @param Y0 top edge (0 to 127 px)
     * @param VALUE number to draw
     * @param FIGURES total number of characters, including the decimal point
     * @param DECIMALS digits after the decimal point
     * @param LENGTH maximum number of bytes of the unit, including the zero (0 to 127 bytes)
     * @param STRING unit to draw after the number
     */
    VIEW_UNIT(COLOR: Value, X0: Value, Y0: Value, VALUE: Value, FIGURES: Value, DECIMALS: Value, LENGTH: Value, STRING: Text): Uint8Array;
    /**
     * Draws a filled circle
     * @param COLOR colour to draw in (0 to 1; 0: white; 1: black)
     * @param X0 column of the centre (0 to 177 px)
     * @param Y0 row of the centre (0 to 127 px)
     * @param R radius (px; 0: draws nothing)
     */
    FILLCIRCLE(COLOR: Value, X0: Value, Y0: Value, R: Value): Uint8Array;
    /**
     * Keeps a copy of the canvas
     * @param NO slot for one screen; 0 holds the screen from before the program ran (0 to 2)
     */
    STORE(NO: Value): Uint8Array;
    /**
     * Restores a canvas kept by STORE
     * @param NO slot for one screen; 0 holds the screen from before the program ran (0 to 2)
     */
    RESTORE(NO: Value): Uint8Array;
    /**
     * Shows a row of icons and waits until one is chosen
     * @param COLOR colour to draw in (0 to 1; 0: white; 1: black)
     * @param X0 left edge (0 to 177 px)
     * @param Y0 top edge (0 to 127 px)
     * @param STATE variable for the dialogue's progress; must be 0 at first (0 to 1; 0: start, or done; 1: being shown)
     * @param ICONS bit n is large icon n: first the icons to show, then the chosen one (0: none: closed with the back button)
     */
    ICON_QUESTION(COLOR: Value, X0: Value, Y0: Value, STATE: Argument, ICONS: Argument): Uint8Array;
    /**
     * Draws a picture file in LEGO's own format .rgf (no .bmp despite the name)
     * @param COLOR colour of the set pixels (0 to 1; 0: white, picture inverted; 1: black)
     * @param X0 left edge (0 to 177 px)
     * @param Y0 top edge (0 to 127 px)
     * @param NAME file with extension .rgf, absolute or relative to /home/root/lms2012/sys (at most 119 characters)
     */
    BMPFILE(COLOR: Value, X0: Value, Y0: Value, NAME: Text): Uint8Array;
    /**
     * Opens a window that only its opener can draw on, or closes it and restores the display
     * @param OPEN action (0 to 1; 0: close; 1: open)
     */
    POPUP(OPEN: Value): Uint8Array;
    /**
     * Sets up a graph of up to 8 curves; useless in direct commands, since the arrays must outlive it
     * @param X0 left edge (0 to 177 px)
     * @param X1 width (0 to 178 px)
     * @param ITEMS number of curves (0 to 8)
     * @param OFFSET top edge of each curve (0 to 127 px; as many values as ITEMS says)
     * @param SPAN height of each curve (0 to 128 px; as many values as ITEMS says)
     * @param MIN value at the bottom of each curve (as many values as ITEMS says)
     * @param MAX value at the top of each curve (as many values as ITEMS says)
     * @param SAMPLE current value of each curve, read again at each GRAPH_SAMPLE (as many values as ITEMS says)
     */
    GRAPH_SETUP(X0: Value, X1: Value, ITEMS: Value, OFFSET: Value, SPAN: Value, MIN: Value, MAX: Value, SAMPLE: Value): Uint8Array;
    /**
     * Draws the graph and measures the curve it shows
     * @param VIEW curve to draw, counted from 0; any other value draws all and measures none (-1: all)
     * @param ACTUAL latest value, NaN if there is none
     * @param LOWEST lowest value in the graph
     * @param HIGHEST highest value in the graph
     * @param AVERAGE mean of the values in the graph
     */
    GRAPH_DRAW(VIEW: Value, ACTUAL: Argument, LOWEST: Argument, HIGHEST: Argument, AVERAGE: Argument): Uint8Array;
    /**
     * Shows a text with a scroll bar and waits until a line is chosen
     * @param X0 left edge (0 to 177 px)
     * @param Y0 top edge (0 to 127 px)
     * @param X1 width (0 to 178 px)
     * @param Y1 height (0 to 128 px)
     * @param TEXT whole text of the box, its lines separated by DEL
     * @param SIZE size of the box's text buffer, including the zero (bytes)
     * @param DEL what separates the lines (a member of DEL)
     * @param LINE variable, must be -1 at first; then the chosen line, counted from 1 (-1: start, or closed with the back button; 0: being shown)
     */
    TEXTBOX(X0: Value, Y0: Value, X1: Value, Y1: Value, TEXT: Text, SIZE: Value, DEL: Value, LINE: Argument): Uint8Array;
  };
  readonly SOUND: {
    /**
     * Stops the tone or file that is playing
     */
    BREAK(): Uint8Array;
    /**
     * Plays one tone and returns at once
     * @param VOLUME volume (0 to 100 %; 0: silent)
     * @param FREQUENCY pitch; the driver clamps it to the range (250 to 10000 Hz)
     * @param DURATION duration, read unsigned (-1 is 65535) (ms; 0: until BREAK or the next sound)
     */
    TONE(VOLUME: Value, FREQUENCY: Value, DURATION: Value): Uint8Array;
    /**
     * Plays a sound file once and returns at once
     * @param VOLUME volume (0 to 100 %; 0: silent)
     * @param NAME sound file without its extension .rsf, absolute or relative to /home/root/lms2012/sys (at most 119 characters)
     */
    PLAY(VOLUME: Value, NAME: Text): Uint8Array;
    /**
     * Plays a sound file over and over until BREAK and returns at once
     * @param VOLUME volume (0 to 100 %; 0: silent)
     * @param NAME sound file without its extension .rsf, absolute or relative to /home/root/lms2012/sys (at most 119 characters)
     */
    REPEAT(VOLUME: Value, NAME: Text): Uint8Array;
    /**
     * Does nothing; the number is used inside the firmware to feed the sound driver
     */
    SERVICE(): Uint8Array;
  };
  readonly INPUT_DEVICE: {
    /**
     * Adds a line to the table of device types, for third party types (50 to 98) only
     * @param TYPEDATA the line as in typedata.rcf, starting with the type's number
     * @param FORCE whether to replace a known type (0 to 1; 0: refuse a known type; 1: replace a known type)
     * @param ERROR whether it failed (0 to 1; 0: done; 1: failed or known)
     */
    INSERT_TYPE(TYPEDATA: Text, FORCE: Value, ERROR: Argument): Uint8Array;
    /**
     * Describes the values of a device in its current mode
     * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
     * @param NO port, counted from 0; 16 to 19 for motors (0 to 19)
     * @param DATASETS number of values in one reading
     * @param FORMAT type of one raw value (0 to 3; a member of DATA_FORMAT)
     * @param MODES number of modes of the device (1 to 8)
     * @param VIEWS number of modes shown to users (1 to 8)
     */
    GET_FORMAT(LAYER: Value, NO: Value, DATASETS: Argument, FORMAT: Argument, MODES: Argument, VIEWS: Argument): Uint8Array;
    /**
     * Sets the raw values that scale a type and mode to percent and SI
     * @param TYPE type of device the calibration is for (a member of TYPE)
     * @param MODE mode the calibration is for (0 to 7)
     * @param CAL_MIN raw value at the lower end
     * @param CAL_MAX raw value at full scale
     */
    CAL_MINMAX(TYPE: Value, MODE: Value, CAL_MIN: Value, CAL_MAX: Value): Uint8Array;
    /**
     * Restores the built-in scaling of a type and mode
     * @param TYPE type of device the calibration is for (a member of TYPE)
     * @param MODE mode the calibration is for (0 to 7)
     */
    CAL_DEFAULT(TYPE: Value, MODE: Value): Uint8Array;
    /**
     * Reports the device at a port and its mode
     * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
     * @param NO port, counted from 0; 16 to 19 for motors (0 to 19)
     * @param TYPE type of the device (a member of TYPE)
     * @param MODE mode the device is in (0 to 7)
     */
    GET_TYPEMODE(LAYER: Value, NO: Value, TYPE: Argument, MODE: Argument): Uint8Array;
    /**
     * Reads the symbol of the unit of the current mode
     * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
     * @param NO port, counted from 0; 16 to 19 for motors (0 to 19)
     * @param LENGTH size of the text buffer, including the zero (bytes; -1: unlimited (handles only))
     * @param DESTINATION symbol, padded with blanks (as many bytes as LENGTH says)
     */
    GET_SYMBOL(LAYER: Value, NO: Value, LENGTH: Value, DESTINATION: Argument): Uint8Array;
    /**
     * Sets the lower end of the scaling of a type and mode
     * @param TYPE type of device the calibration is for (a member of TYPE)
     * @param MODE mode the calibration is for (0 to 7)
     * @param CAL_MIN value at the lower end, in SI units once calibrated
     */
    CAL_MIN(TYPE: Value, MODE: Value, CAL_MIN: Value): Uint8Array;
    /**
     * Sets the full scale of a type and mode
     * @param TYPE type of device the calibration is for (a member of TYPE)
     * @param MODE mode the calibration is for (0 to 7)
     * @param CAL_MAX value at full scale, in SI units once calibrated
     */
    CAL_MAX(TYPE: Value, MODE: Value, CAL_MAX: Value): Uint8Array;
    /**
     * Writes to an I2C sensor and reads its answer, repeatedly if requested
     * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
     * @param NO sensor port, counted from 0 (0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4)
     * @param REPEAT number of repeats (0: endless)
     * @param TIME time between repeats (10 to 1000 ms; 0: 10 ms)
     * @param WRITE_LEN number of bytes to write (0 to 32 bytes)
     * @param WRITE_DATA bytes to write: I2C address, register, data (as many values as WRITE_LEN says)
     * @param READ_LEN number of bytes to read, negative: in reverse order (-32 to 32 bytes)
     * @param READ_DATA bytes read (as many values as READ_LEN says)
     */
    SETUP(LAYER: Value, NO: Value, REPEAT: Value, TIME: Value, WRITE_LEN: Value, WRITE_DATA: Value, READ_LEN: Value, READ_DATA: Argument): Uint8Array;
    /**
     * Clears counters and angles of all devices
     * @param LAYER brick in the daisy chain (0 to 3; -1: all layers)
     */
    CLR_ALL(LAYER: Value): Uint8Array;
    /**
     * Reads the first raw value of a device
     * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
     * @param NO port, counted from 0; 16 to 19 for motors (0 to 19)
     * @param VALUE raw value, NaN if there is none
     */
    GET_RAW(LAYER: Value, NO: Value, VALUE: Argument): Uint8Array;
    /**
     * Reports how the device at a port is connected
     * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
     * @param NO port, counted from 0; 16 to 19 for motors (0 to 19)
     * @param CONN kind of connection (a member of CONN)
     */
    GET_CONNECTION(LAYER: Value, NO: Value, CONN: Argument): Uint8Array;
    /**
     * Stops all devices, motors among them
     * @param LAYER brick in the daisy chain (0 to 3; -1: all layers)
     */
    STOP_ALL(LAYER: Value): Uint8Array;
    /**
     * Renumbers an entry of the table of device types, third party types only
     * @param TYPE type of the entry (50 to 98; a member of TYPE)
     * @param MODE mode of the entry (0 to 7)
     * @param NEWTYPE new type of the entry (50 to 98; a member of TYPE)
     * @param NEWMODE new mode of the entry (0 to 7)
     * @param ERROR whether it failed (0 to 1; 0: done; 1: failed or not found)
     */
    SET_TYPEMODE(TYPE: Value, MODE: Value, NEWTYPE: Value, NEWMODE: Value, ERROR: Argument): Uint8Array;
    /**
     * Writes to an I2C sensor once, waits for its answer and reports the result
     * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
     * @param NO sensor port, counted from 0 (0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4)
     * @param WRLNG number of bytes to write (0 to 32 bytes)
     * @param WRDATA bytes to write: I2C address, register, data (as many values as WRLNG says)
     * @param RDLNG number of bytes to read, negative: in reverse order (-32 to 32 bytes)
     * @param RDDATA bytes read (as many values as RDLNG says)
     * @param RESULT how the transfer ended (a member of RESULT)
     */
    READY_IIC(LAYER: Value, NO: Value, WRLNG: Value, WRDATA: Value, RDLNG: Value, RDDATA: Argument, RESULT: Argument): Uint8Array;
    /**
     * Reads the name of a device in its current mode, such as TOUCH or COL-REFLECT
     * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
     * @param NO port, counted from 0; 16 to 19 for motors (0 to 19)
     * @param LENGTH size of the text buffer, including the zero (bytes; -1: unlimited (handles only))
     * @param DESTINATION name, padded with blanks (as many bytes as LENGTH says)
     */
    GET_NAME(LAYER: Value, NO: Value, LENGTH: Value, DESTINATION: Argument): Uint8Array;
    /**
     * Reads the name of any mode of a device
     * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
     * @param NO port, counted from 0; 16 to 19 for motors (0 to 19)
     * @param MODE mode to name (0 to 7)
     * @param LENGTH size of the text buffer, including the zero (bytes; -1: unlimited (handles only))
     * @param DESTINATION name, padded with blanks (as many bytes as LENGTH says)
     */
    GET_MODENAME(LAYER: Value, NO: Value, MODE: Value, LENGTH: Value, DESTINATION: Argument): Uint8Array;
    /**
     * Simulates a raw value of a device
     * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
     * @param NO port, counted from 0; 16 to 19 for motors (0 to 19)
     * @param TYPE type to set (0: keep the type; a member of TYPE)
     * @param VALUE raw value to simulate
     */
    SET_RAW(LAYER: Value, NO: Value, TYPE: Value, VALUE: Value): Uint8Array;
    /**
     * Reports the number of digits that a value of the current mode needs
     * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
     * @param NO port, counted from 0; 16 to 19 for motors (0 to 19)
     * @param FIGURES total number of characters, with point and decimals
     * @param DECIMALS digits after the point
     */
    GET_FIGURES(LAYER: Value, NO: Value, FIGURES: Argument, DECIMALS: Argument): Uint8Array;
    /**
     * Reads how often a touch sensor changed to pressed since CLR_CHANGES
     * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
     * @param NO port, counted from 0; 16 to 19 for motors (0 to 19)
     * @param VALUE number of changes, 0 for other sensors
     */
    GET_CHANGES(LAYER: Value, NO: Value, VALUE: Argument): Uint8Array;
    /**
     * Sets the counts of GET_CHANGES and GET_BUMPS to zero
     * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
     * @param NO port, counted from 0; 16 to 19 for motors (0 to 19)
     */
    CLR_CHANGES(LAYER: Value, NO: Value): Uint8Array;
    /**
     * Sets type and mode, waits until the device is ready and reads percent values
     * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
     * @param NO port, counted from 0; 16 to 19 for motors (0 to 19)
     * @param TYPE type to set (0: keep the type; a member of TYPE)
     * @param MODE mode to set (0 to 7; -1: keep the mode)
     * @param VALUES number of values that follow, each in percent
     */
    READY_PCT(LAYER: Value, NO: Value, TYPE: Value, MODE: Value, VALUES: readonly Argument[]): Uint8Array;
    /**
     * Sets type and mode, waits until the device is ready and reads raw values
     * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
     * @param NO port, counted from 0; 16 to 19 for motors (0 to 19)
     * @param TYPE type to set (0: keep the type; a member of TYPE)
     * @param MODE mode to set (0 to 7; -1: keep the mode)
     * @param VALUES number of raw values that follow
     */
    READY_RAW(LAYER: Value, NO: Value, TYPE: Value, MODE: Value, VALUES: readonly Argument[]): Uint8Array;
    /**
     * Sets type and mode, waits until the device is ready and reads SI values
     * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
     * @param NO port, counted from 0; 16 to 19 for motors (0 to 19)
     * @param TYPE type to set (0: keep the type; a member of TYPE)
     * @param MODE mode to set (0 to 7; -1: keep the mode)
     * @param VALUES number of values that follow, each in SI units
     */
    READY_SI(LAYER: Value, NO: Value, TYPE: Value, MODE: Value, VALUES: readonly Argument[]): Uint8Array;
    /**
     * Reports the range of SI values of the current mode
     * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
     * @param NO port, counted from 0; 16 to 19 for motors (0 to 19)
     * @param MIN smallest value in SI units
     * @param MAX largest value in SI units
     */
    GET_MINMAX(LAYER: Value, NO: Value, MIN: Argument, MAX: Argument): Uint8Array;
    /**
     * Reads how often a touch sensor changed to released since CLR_CHANGES
     * @param LAYER brick in the daisy chain, 0 is the one addressed (0 to 3)
     * @param NO port, counted from 0; 16 to 19 for motors (0 to 19)
     * @param VALUE number of changes, 0 for other sensors
     */
    GET_BUMPS(LAYER: Value, NO: Value, VALUE: Argument): Uint8Array;
  };
  readonly FILE: {
    /**
     * Opens a file for appending; creates it if it does not exist
     * @param NAME path of the file; a bare name is taken from the program's own folder (at most 119 characters)
     * @param HANDLE handle of the opened file
     */
    OPEN_APPEND(NAME: Text, HANDLE: Argument): Uint8Array;
    /**
     * Opens a file for reading
     * @param NAME path of the file; a bare name is taken from the program's own folder (at most 119 characters)
     * @param HANDLE handle of the opened file
     * @param SIZE size of the file (bytes; 0: not found)
     */
    OPEN_READ(NAME: Text, HANDLE: Argument, SIZE: Argument): Uint8Array;
    /**
     * Creates or truncates a file and opens it for writing
     * @param NAME path of the file; a bare name is taken from the program's own folder (at most 119 characters)
     * @param HANDLE handle of the opened file
     */
    OPEN_WRITE(NAME: Text, HANDLE: Argument): Uint8Array;
    /**
     * Reads the text up to the next delimiter and turns it into a number
     * @param HANDLE the open file
     * @param DEL separator between two values in the file (a member of DEL)
     * @param VALUE the number, 0 if the text is not a number
     */
    READ_VALUE(HANDLE: Value, DEL: Value, VALUE: Argument): Uint8Array;
    /**
     * Writes a number as text, and a delimiter after it
     * @param HANDLE the open file
     * @param DEL separator between two values in the file (a member of DEL)
     * @param VALUE the number
     * @param FIGURES minimum width in characters, including the decimal point
     * @param DECIMALS digits after the decimal point
     */
    WRITE_VALUE(HANDLE: Value, DEL: Value, VALUE: Value, FIGURES: Value, DECIMALS: Value): Uint8Array;
    /**
     * Reads text up to the next delimiter
     * @param HANDLE the open file
     * @param DEL separator between two values in the file (a member of DEL)
     * @param LENGTH maximum number of bytes to read; LEGO's firmware keeps the low 8 bits, so 127 (bytes)
     * @param TEXT the text, without a zero at its end if it fills the whole buffer (as many bytes as LENGTH says)
     */
    READ_TEXT(HANDLE: Value, DEL: Value, LENGTH: Value, TEXT: Argument): Uint8Array;
    /**
     * Writes text without its zero, and a delimiter after it
     * @param HANDLE the open file
     * @param DEL separator between two values in the file (a member of DEL)
     * @param TEXT the text
     */
    WRITE_TEXT(HANDLE: Value, DEL: Value, TEXT: Text): Uint8Array;
    /**
     * Closes a file and frees its handle
     * @param HANDLE the open file
     */
    CLOSE(HANDLE: Value): Uint8Array;
    /**
     * Loads a program file into a stopped slot, for PROGRAM_START to run
     * @param PRGID slot to load it into (0 to 4; a member of SLOT)
     * @param NAME path of the program, relative to /home/root/lms2012/sys; .rbf may be omitted (at most 119 characters)
     * @param SIZE size of the program (bytes; 0: not loaded)
     * @param IP where it was loaded, for PROGRAM_START (0: not loaded)
     */
    LOAD_IMAGE(PRGID: Value, NAME: Text, SIZE: Argument, IP: Argument): Uint8Array;
    /**
     * Finds the handle of a file that is already open
     * @param NAME path of the file; a bare name is taken from the program's own folder (at most 119 characters)
     * @param HANDLE the open file (-1: not open)
     * @param WRITE whether it is open for writing or appending (0: no; 1: yes)
     */
    GET_HANDLE(NAME: Text, HANDLE: Argument, WRITE: Argument): Uint8Array;
    /**
     * Creates a folder unless it exists
     * @param NAME path of the folder, relative to /home/root/lms2012/sys (at most 119 characters)
     * @param SUCCESS whether the folder exists now (0: no; 1: yes)
     */
    MAKE_FOLDER(NAME: Text, SUCCESS: Argument): Uint8Array;
    /**
     * Reserves a block of memory for the program
     * @param SIZE how much memory (1 to 6000000 bytes)
     * @param HANDLE handle of the block
     * @param IP address of the block
     */
    GET_POOL(SIZE: Value, HANDLE: Argument, IP: Argument): Uint8Array;
    /**
     * Stores the time and tick to which data logs are aligned
     * @param TIME the common time
     * @param TICK the brick's tick at that time
     */
    SET_LOG_SYNC_TIME(TIME: Value, TICK: Value): Uint8Array;
    /**
     * Counts the entries of a folder, without hidden ones
     * @param NAME path of the folder with its closing slash, such as ../prjs/ (at most 119 characters)
     * @param ITEMS number of entries
     */
    GET_FOLDERS(NAME: Text, ITEMS: Argument): Uint8Array;
    /**
     * Reads the time and tick to which data logs are aligned
     * @param TIME the common time
     * @param TICK the brick's tick at that time
     */
    GET_LOG_SYNC_TIME(TIME: Argument, TICK: Argument): Uint8Array;
    /**
     * Reads the name of one entry of a folder
     * @param NAME path of the folder with its closing slash, such as ../prjs/ (at most 119 characters)
     * @param ITEM which entry of the folder, the first is 1 (1 to 127)
     * @param LENGTH size of the string's buffer, including the zero (bytes)
     * @param STRING its name without extension, empty if there is no such entry (as many bytes as LENGTH says)
     */
    GET_SUBFOLDER_NAME(NAME: Text, ITEM: Value, LENGTH: Value, STRING: Argument): Uint8Array;
    /**
     * Adds one row of samples to a data log
     * @param HANDLE the open data log
     * @param TIME time of the samples since the log began (ms)
     * @param ITEMS number of samples; with 0 nothing is written (0 to 127)
     * @param VALUES the samples, in one array (as many values as ITEMS says)
     */
    WRITE_LOG(HANDLE: Value, TIME: Value, ITEMS: Value, VALUES: Value): Uint8Array;
    /**
     * Writes the rest of a data log and closes it
     * @param HANDLE the open data log
     * @param NAME path of the log as given to OPEN_LOG; .rdf may be omitted
     */
    CLOSE_LOG(HANDLE: Value, NAME: Text): Uint8Array;
    /**
     * Loads an entry of a folder; LEGO's 2013 firmware has no code for it and fails
     * @param NAME path of the folder with its closing slash, such as ../prjs/ (at most 119 characters)
     * @param PRGID slot to load it into (a member of SLOT)
     * @param ITEM which entry of the folder, the first is 1 (1 to 127)
     * @param IP where it was loaded
     */
    GET_IMAGE(NAME: Text, PRGID: Value, ITEM: Value, IP: Argument): Uint8Array;
    /**
     * Finds an entry of a folder by its name
     * @param NAME path of the folder with its closing slash, such as ../prjs/ (at most 119 characters)
     * @param STRING name to look for, without extension
     * @param ITEM number of the entry; the first is 1 (1 to 127; 0: not found)
     */
    GET_ITEM(NAME: Text, STRING: Text, ITEM: Argument): Uint8Array;
    /**
     * Counts the recently run files
     * @param ITEMS number of files, at most 10
     */
    GET_CACHE_FILES(ITEMS: Argument): Uint8Array;
    /**
     * Puts a file first in the list of recently run files
     * @param STRING path of the file
     */
    PUT_CACHE_FILE(STRING: Text): Uint8Array;
    /**
     * Reads the path of one recently run file
     * @param ITEM which one, 1 is the latest (1 to 10)
     * @param LENGTH size of the string's buffer, including the zero (bytes)
     * @param STRING path of the file, empty if there is none (as many bytes as LENGTH says)
     */
    GET_CACHE_FILE(ITEM: Value, LENGTH: Value, STRING: Argument): Uint8Array;
    /**
     * Removes a file from the list of recently run files
     * @param STRING path of the file, as given to PUT_CACHE_FILE
     */
    DEL_CACHE_FILE(STRING: Text): Uint8Array;
    /**
     * Deletes one entry of a folder together with the files in it
     * @param NAME path of the folder with its closing slash, such as ../prjs/ (at most 119 characters)
     * @param ITEM which entry of the folder, the first is 1 (1 to 127)
     */
    DEL_SUBFOLDER(NAME: Text, ITEM: Value): Uint8Array;
    /**
     * Reads the path of the open data log
     * @param LENGTH size of the string's buffer, including the zero (bytes)
     * @param NAME path of the log, empty if none is open (as many bytes as LENGTH says)
     */
    GET_LOG_NAME(LENGTH: Value, NAME: Argument): Uint8Array;
    /**
     * Creates a data log and writes its header
     * @param NAME path of the log; .rdf may be omitted; with an empty one it stays in memory
     * @param syncedTime the common time, as GET_LOG_SYNC_TIME returns it
     * @param syncedTick the brick's tick at that time
     * @param nowTick the brick's tick at the start of the log
     * @param sample_interval_in_ms time between samples; fast logs are kept in memory first (ms)
     * @param duration_in_ms duration of the log (ms)
     * @param SDATA text that describes the sensors, copied into the header
     * @param HANDLE handle of the log
     */
    OPEN_LOG(NAME: Text, syncedTime: Value, syncedTick: Value, nowTick: Value, sample_interval_in_ms: Value, duration_in_ms: Value, SDATA: Text, HANDLE: Argument): Uint8Array;
    /**
     * Reads raw bytes from a file
     * @param HANDLE the open file
     * @param BYTES number of bytes (0 to 32767 bytes)
     * @param DESTINATION the bytes; followed by a zero if the file ended early (as many values as BYTES says)
     */
    READ_BYTES(HANDLE: Value, BYTES: Value, DESTINATION: Argument): Uint8Array;
    /**
     * Writes raw bytes to a file
     * @param HANDLE the open file
     * @param BYTES number of bytes (0 to 32767 bytes)
     * @param SOURCE the bytes (as many values as BYTES says)
     */
    WRITE_BYTES(HANDLE: Value, BYTES: Value, SOURCE: Value): Uint8Array;
    /**
     * Deletes a file, or a folder with the files in it
     * @param NAME path of the file; a bare name is taken from the program's own folder (at most 119 characters)
     */
    REMOVE(NAME: Text): Uint8Array;
    /**
     * Copies a file or folder and replaces the destination; the source is kept
     * @param SOURCE path to copy from
     * @param DEST path to copy to; any existing one is deleted first
     */
    MOVE(SOURCE: Text, DEST: Text): Uint8Array;
  };
  readonly ARRAY: {
    /**
     * Deletes an array and frees its handle (official firmware only)
     * @param HANDLE the array
     */
    DELETE(HANDLE: Value): Uint8Array;
    /**
     * Deletes an array and frees its handle (LEGO's name for it is DELETE) (xtended and compat firmware only)
     * @param HANDLE the array
     */
    DESTROY(HANDLE: Value): Uint8Array;
    /**
     * Creates an array of DATA8 elements
     * @param ELEMENTS initial number of elements (0 to 6000000)
     * @param HANDLE handle of the new array
     */
    CREATE8(ELEMENTS: Value, HANDLE: Argument): Uint8Array;
    /**
     * Creates an array of DATA16 elements
     * @param ELEMENTS initial number of elements (0 to 3000000)
     * @param HANDLE handle of the new array
     */
    CREATE16(ELEMENTS: Value, HANDLE: Argument): Uint8Array;
    /**
     * Creates an array of DATA32 elements
     * @param ELEMENTS initial number of elements (0 to 1500000)
     * @param HANDLE handle of the new array
     */
    CREATE32(ELEMENTS: Value, HANDLE: Argument): Uint8Array;
    /**
     * Creates an array of DATAF elements
     * @param ELEMENTS initial number of elements (0 to 1500000)
     * @param HANDLE handle of the new array
     */
    CREATEF(ELEMENTS: Value, HANDLE: Argument): Uint8Array;
    /**
     * Changes the number of elements of an array
     * @param HANDLE the array
     * @param ELEMENTS new number of elements (0 to 6000000)
     */
    RESIZE(HANDLE: Value, ELEMENTS: Value): Uint8Array;
    /**
     * Sets every element of an array to one value
     * @param HANDLE the array
     * @param VALUE the value, of the array's type
     */
    FILL(HANDLE: Value, VALUE: Any): Uint8Array;
    /**
     * Copies the content of one array into another of the same type, which is resized to match
     * @param HSOURCE array to copy from
     * @param HDEST array to copy into, which must exist
     */
    COPY(HSOURCE: Value, HDEST: Value): Uint8Array;
    /**
     * Writes several elements of a DATA8 array, all within its size
     * @param HANDLE the array
     * @param INDEX first element to write, counted from 0 (0 to 5999999)
     * @param VALUES number of values that follow
     */
    INIT8(HANDLE: Value, INDEX: Value, VALUES: readonly Value[]): Uint8Array;
    /**
     * Writes several elements of a DATA16 array, all within its size
     * @param HANDLE the array
     * @param INDEX first element to write, counted from 0 (0 to 5999999)
     * @param VALUES number of values that follow
     */
    INIT16(HANDLE: Value, INDEX: Value, VALUES: readonly Value[]): Uint8Array;
    /**
     * Writes several elements of a DATA32 array, all within its size
     * @param HANDLE the array
     * @param INDEX first element to write, counted from 0 (0 to 5999999)
     * @param VALUES number of values that follow
     */
    INIT32(HANDLE: Value, INDEX: Value, VALUES: readonly Value[]): Uint8Array;
    /**
     * Writes several elements of a DATAF array, all within its size
     * @param HANDLE the array
     * @param INDEX first element to write, counted from 0 (0 to 5999999)
     * @param VALUES number of values that follow
     */
    INITF(HANDLE: Value, INDEX: Value, VALUES: readonly Value[]): Uint8Array;
    /**
     * Counts the elements of an array (official firmware only)
     * @param HANDLE the array
     * @param ELEMENTS number of elements, 0 if there is no such array
     */
    SIZE(HANDLE: Value, ELEMENTS: Argument): Uint8Array;
    /**
     * Counts the elements of an array (LEGO's name for it is SIZE) (xtended and compat firmware only)
     * @param HANDLE the array
     * @param ELEMENTS number of elements, 0 if there is no such array
     */
    SET_SIZE(HANDLE: Value, ELEMENTS: Argument): Uint8Array;
    /**
     * Reads an array's content as bytes, also of another program
     * @param PRGID slot of the program that owns the array (a member of SLOT)
     * @param HANDLE the array
     * @param INDEX first byte in the array's content, whatever its elements (0 to 2147483647)
     * @param BYTES number of bytes (0 to 2147483647 bytes)
     * @param ARRAY the bytes, zeros beyond the end of the array (as many values as BYTES says)
     */
    READ_CONTENT(PRGID: Value, HANDLE: Value, INDEX: Value, BYTES: Value, ARRAY: Argument): Uint8Array;
    /**
     * Writes an array's content as bytes; the array then ends after them
     * @param PRGID slot of the program that owns the array (a member of SLOT)
     * @param HANDLE the array
     * @param INDEX first byte in the array's content, whatever its elements (0 to 2147483647)
     * @param BYTES number of bytes (0 to 2147483647 bytes)
     * @param ARRAY the bytes (as many values as BYTES says)
     */
    WRITE_CONTENT(PRGID: Value, HANDLE: Value, INDEX: Value, BYTES: Value, ARRAY: Value): Uint8Array;
    /**
     * Returns the size of an array's content, also of another program
     * @param PRGID slot of the program that owns the array (a member of SLOT)
     * @param HANDLE the array
     * @param BYTES number of bytes, 0 if there is no such array (bytes)
     */
    READ_SIZE(PRGID: Value, HANDLE: Value, BYTES: Argument): Uint8Array;
  };
  readonly FILENAME: {
    /**
     * Reports whether a file or folder exists
     * @param NAME path of the file; a bare name is taken from the program's own folder (at most 119 characters)
     * @param FLAG whether it exists (0: no; 1: yes)
     */
    EXIST(NAME: Text, FLAG: Argument): Uint8Array;
    /**
     * Reports the number of files in a folder and their size
     * @param NAME path of the folder or file
     * @param FILES number of entries, including . and ..; 0 for a file
     * @param SIZE size of all of them, rounded up (KiB)
     */
    TOTALSIZE(NAME: Text, FILES: Argument, SIZE: Argument): Uint8Array;
    /**
     * Splits a path into folder, name and extension
     * @param FILENAME the path
     * @param LENGTH buffer size for each of the three parts, including the zero (bytes)
     * @param FOLDER the folder, with its closing slash on LEGO's firmware (as many bytes as LENGTH says)
     * @param NAME the name, without folder and extension (as many bytes as LENGTH says)
     * @param EXT the extension with its dot (as many bytes as LENGTH says)
     */
    SPLIT(FILENAME: Text, LENGTH: Value, FOLDER: Argument, NAME: Argument, EXT: Argument): Uint8Array;
    /**
     * Builds a path from folder, name and extension
     * @param FOLDER the folder, without a slash at its end
     * @param NAME the name
     * @param EXT the extension with its dot
     * @param LENGTH size of the string's buffer, including the zero (bytes)
     * @param FILENAME the path (as many bytes as LENGTH says)
     */
    MERGE(FOLDER: Text, NAME: Text, EXT: Text, LENGTH: Value, FILENAME: Argument): Uint8Array;
    /**
     * Reports whether a path's characters and lengths are allowed; the file need not exist
     * @param FILENAME the path
     * @param OK whether the path can be used (0: not allowed; 1: allowed)
     */
    CHECK(FILENAME: Text, OK: Argument): Uint8Array;
    /**
     * Packs a file or folder into a .raf archive beside it
     * @param FILENAME path of the file or folder
     */
    PACK(FILENAME: Text): Uint8Array;
    /**
     * Unpacks a .raf archive into the folder it is in
     * @param FILENAME path of the archive; its extension is replaced by .raf
     */
    UNPACK(FILENAME: Text): Uint8Array;
    /**
     * Reads the path of the program's own folder
     * @param LENGTH size of the string's buffer, including the zero (bytes)
     * @param FOLDERNAME path of the folder, without a slash at its end (as many bytes as LENGTH says)
     */
    GET_FOLDERNAME(LENGTH: Value, FOLDERNAME: Argument): Uint8Array;
  };
  readonly COM_READ: {
    /**
     * Returns the address of the last direct command received
     * @param LENGTH maximum number of bytes of code, ignored by the firmware (bytes)
     * @param IMAGE address of the code
     * @param GLOBAL address of its global memory
     * @param FLAG whether one is waiting (0 to 1; 0: none; 1: ready to run)
     */
    COMMAND(LENGTH: Value, IMAGE: Argument, GLOBAL: Argument, FLAG: Argument): Uint8Array;
  };
  readonly COM_WRITE: {
    /**
     * Sends the global memory of a direct command that has run as its reply
     * @param IMAGE address of the code
     * @param GLOBAL address of its global memory
     * @param STATUS how it ended; all but OK give DIRECT_REPLY_ERROR (a member of RESULT)
     */
    REPLY(IMAGE: Value, GLOBAL: Value, STATUS: Value): Uint8Array;
  };
  readonly COM_GET: {
    /**
     * Reports whether Bluetooth or WiFi is on
     * @param HARDWARE carrier to use (2 to 3; a member of HWTYPE)
     * @param ACTIVE whether it is on (0 to 1; 0: off; 1: on)
     */
    GET_ON_OFF(HARDWARE: Value, ACTIVE: Argument): Uint8Array;
    /**
     * Reports whether other devices can see the brick by Bluetooth
     * @param HARDWARE carrier to use (1 to 3; a member of HWTYPE)
     * @param VISIBLE whether it is visible (0 to 1; 0: no; 1: yes)
     */
    GET_VISIBLE(HARDWARE: Value, VISIBLE: Argument): Uint8Array;
    /**
     * Reports the state of a search or connection request
     * @param HARDWARE carrier to use (2 to 3; a member of HWTYPE)
     * @param ITEM place in the list, ignored by the firmware
     * @param RESULT state of the request (a member of RESULT)
     */
    GET_RESULT(HARDWARE: Value, ITEM: Value, RESULT: Argument): Uint8Array;
    /**
     * Reads the PIN for a device, always 1234
     * @param HARDWARE carrier to use (a member of HWTYPE)
     * @param NAME name of the other device or network
     * @param LENGTH size of the PIN's buffer, including the zero (bytes)
     * @param PINCODE the PIN (as many bytes as LENGTH says)
     */
    GET_PIN(HARDWARE: Value, NAME: Text, LENGTH: Value, PINCODE: Argument): Uint8Array;
    /**
     * Reads a counter that changes when a device enters or leaves a list (compat firmware only)
     * @param HARDWARE carrier to use (a member of HWTYPE)
     * @param STATE number to compare with the one of the last call
     */
    LIST_STATE(HARDWARE: Value, STATE: Argument): Uint8Array;
    /**
     * Counts the devices or networks that a search found
     * @param HARDWARE carrier to use (2 to 3; a member of HWTYPE)
     * @param ITEMS number of entries in the list
     */
    SEARCH_ITEMS(HARDWARE: Value, ITEMS: Argument): Uint8Array;
    /**
     * Describes one device or network that a search found
     * @param HARDWARE carrier to use (a member of HWTYPE)
     * @param ITEM place in the list, counted from 0
     * @param LENGTH size of the text buffer, including the zero (bytes; -1: unlimited (handles only))
     * @param NAME name of the other device or network (as many bytes as LENGTH says)
     * @param PAIRED whether it is paired (Bluetooth) or known (WiFi) (0 to 1; 0: no; 1: yes)
     * @param CONNECTED whether it is connected (0 to 1; 0: no; 1: yes)
     * @param TYPE kind of device (Bluetooth) or encryption (WiFi) (0: WiFi, not encrypted; 1: WiFi, WPA2; a member of BTTYPE)
     * @param VISIBLE whether it is in range (0 to 1; 0: no; 1: yes)
     */
    SEARCH_ITEM(HARDWARE: Value, ITEM: Value, LENGTH: Value, NAME: Argument, PAIRED: Argument, CONNECTED: Argument, TYPE: Argument, VISIBLE: Argument): Uint8Array;
    /**
     * Counts the paired devices, in range or not
     * @param HARDWARE carrier to use (2 to 2; a member of HWTYPE)
     * @param ITEMS number of entries in the list
     */
    FAVOUR_ITEMS(HARDWARE: Value, ITEMS: Argument): Uint8Array;
    /**
     * Describes one paired device or known network
     * @param HARDWARE carrier to use (a member of HWTYPE)
     * @param ITEM place in the list, counted from 0
     * @param LENGTH size of the text buffer, including the zero (bytes; -1: unlimited (handles only))
     * @param NAME name of the other device or network (as many bytes as LENGTH says)
     * @param PAIRED whether it is paired (Bluetooth) or known (WiFi) (0 to 1; 0: no; 1: yes)
     * @param CONNECTED whether it is connected (0 to 1; 0: no; 1: yes)
     * @param TYPE kind of device (Bluetooth) or encryption (WiFi) (0: WiFi, not encrypted; 1: WiFi, WPA2; a member of BTTYPE)
     */
    FAVOUR_ITEM(HARDWARE: Value, ITEM: Value, LENGTH: Value, NAME: Argument, PAIRED: Argument, CONNECTED: Argument, TYPE: Argument): Uint8Array;
    /**
     * Reads the brick's Bluetooth address
     * @param HARDWARE carrier to use (2 to 2; a member of HWTYPE)
     * @param LENGTH size of the text buffer, including the zero (bytes; -1: unlimited (handles only))
     * @param STRING 12 hex digits (as many bytes as LENGTH says)
     */
    GET_ID(HARDWARE: Value, LENGTH: Value, STRING: Argument): Uint8Array;
    /**
     * Reads the brick's name
     * @param LENGTH size of the text buffer, including the zero (bytes; -1: unlimited (handles only))
     * @param NAME name of the brick (as many bytes as LENGTH says)
     */
    GET_BRICKNAME(LENGTH: Value, NAME: Argument): Uint8Array;
    /**
     * Reads network name and addresses, WiFi only
     * @param HARDWARE carrier to use (a member of HWTYPE)
     * @param LENGTH buffer size for each of the three texts, including the zero (bytes; -1: unlimited (handles only))
     * @param NAME name of the network, NONE without one (as many bytes as LENGTH says)
     * @param MAC MAC address of the brick, ?? when WiFi is off (at most 17 characters; as many bytes as LENGTH says)
     * @param IP IP address of the brick, ?? when not connected (at most 15 characters; as many bytes as LENGTH says)
     */
    GET_NETWORK(HARDWARE: Value, LENGTH: Value, NAME: Argument, MAC: Argument, IP: Argument): Uint8Array;
    /**
     * Reports whether the hardware is present (for WiFi: a known dongle)
     * @param HARDWARE carrier to use (a member of HWTYPE)
     * @param OK whether it is present (0 to 1; 0: no; 1: yes)
     */
    GET_PRESENT(HARDWARE: Value, OK: Argument): Uint8Array;
    /**
     * Reports the encryption of a network, WiFi only
     * @param HARDWARE carrier to use (3 to 3; a member of HWTYPE)
     * @param ITEM place in the list, counted from 0
     * @param TYPE kind of encryption; always none in the 2013 firmware (a member of ENCRYPT)
     */
    GET_ENCRYPT(HARDWARE: Value, ITEM: Value, TYPE: Argument): Uint8Array;
    /**
     * Counts the connected devices, Bluetooth only
     * @param HARDWARE carrier to use (1 to 3; a member of HWTYPE)
     * @param ITEMS number of entries in the list
     */
    CONNEC_ITEMS(HARDWARE: Value, ITEMS: Argument): Uint8Array;
    /**
     * Describes one connected device, Bluetooth only
     * @param HARDWARE carrier to use (a member of HWTYPE)
     * @param ITEM place in the list, counted from 0
     * @param LENGTH size of the text buffer, including the zero (bytes; -1: unlimited (handles only))
     * @param NAME name of the device (as many bytes as LENGTH says)
     * @param TYPE kind of device (a member of BTTYPE)
     */
    CONNEC_ITEM(HARDWARE: Value, ITEM: Value, LENGTH: Value, NAME: Argument, TYPE: Argument): Uint8Array;
    /**
     * Reports which device asks for a connection, Bluetooth only
     * @param HARDWARE carrier to use (2 to 2; a member of HWTYPE)
     * @param LENGTH size of the text buffer, including the zero (bytes; -1: unlimited (handles only))
     * @param NAME name of the device (as many bytes as LENGTH says)
     * @param TYPE kind of device (a member of BTTYPE)
     */
    GET_INCOMING(HARDWARE: Value, LENGTH: Value, NAME: Argument, TYPE: Argument): Uint8Array;
    /**
     * Reports whether Bluetooth is in its mode for Apple devices
     * @param HARDWARE carrier to use (2 to 2; a member of HWTYPE)
     * @param ACTIVE whether it is on (0 to 1; 0: off; 1: on)
     */
    GET_MODE2(HARDWARE: Value, ACTIVE: Argument): Uint8Array;
  };
  readonly COM_SET: {
    /**
     * Switches Bluetooth or WiFi on or off
     * @param HARDWARE carrier to use (2 to 3; a member of HWTYPE)
     * @param ACTIVE whether to switch it on (0 to 1; 0: off; 1: on)
     */
    SET_ON_OFF(HARDWARE: Value, ACTIVE: Value): Uint8Array;
    /**
     * Makes the brick visible or invisible, Bluetooth only
     * @param HARDWARE carrier to use (a member of HWTYPE)
     * @param VISIBLE whether other devices can see it (0 to 1; 0: invisible; 1: visible)
     */
    SET_VISIBLE(HARDWARE: Value, VISIBLE: Value): Uint8Array;
    /**
     * Starts or stops the search for devices or networks
     * @param HARDWARE carrier to use (2 to 3; a member of HWTYPE)
     * @param SEARCH whether to search (0 to 1; 0: stop (Bluetooth only); 1: start)
     */
    SET_SEARCH(HARDWARE: Value, SEARCH: Value): Uint8Array;
    /**
     * Answers the request for a PIN (Bluetooth) or stores a network's password (WiFi)
     * @param HARDWARE carrier to use (2 to 3; a member of HWTYPE)
     * @param NAME name of the other device or network
     * @param PINCODE PIN or password
     */
    SET_PIN(HARDWARE: Value, NAME: Text, PINCODE: Text): Uint8Array;
    /**
     * Answers the request to confirm a passkey, Bluetooth only
     * @param HARDWARE carrier to use (2 to 2; a member of HWTYPE)
     * @param ACCEPT the answer (0 to 1; 0: reject; 1: accept)
     */
    SET_PASSKEY(HARDWARE: Value, ACCEPT: Value): Uint8Array;
    /**
     * Connects a device or network, or ends a Bluetooth connection
     * @param HARDWARE carrier to use (2 to 3; a member of HWTYPE)
     * @param NAME name of the other device or network
     * @param CONNECTION what to do (0 to 1; 0: disconnect; 1: connect)
     */
    SET_CONNECTION(HARDWARE: Value, NAME: Text, CONNECTION: Value): Uint8Array;
    /**
     * Renames the brick
     * @param NAME new name, at most 118 characters, else refused (at most 118 characters)
     */
    SET_BRICKNAME(NAME: Text): Uint8Array;
    /**
     * Moves a network up in the list, WiFi only
     * @param HARDWARE carrier to use (3 to 3; a member of HWTYPE)
     * @param ITEM place in the list, counted from 0
     */
    SET_MOVEUP(HARDWARE: Value, ITEM: Value): Uint8Array;
    /**
     * Moves a network down in the list, WiFi only
     * @param HARDWARE carrier to use (3 to 3; a member of HWTYPE)
     * @param ITEM place in the list, counted from 0
     */
    SET_MOVEDOWN(HARDWARE: Value, ITEM: Value): Uint8Array;
    /**
     * Sets the encryption of a network, WiFi only
     * @param HARDWARE carrier to use (3 to 3; a member of HWTYPE)
     * @param ITEM name of the network
     * @param ENCRYPT kind of encryption (a member of ENCRYPT)
     */
    SET_ENCRYPT(HARDWARE: Value, ITEM: Text, ENCRYPT: Value): Uint8Array;
    /**
     * Adds a network to the end of the list, WiFi only
     * @param HARDWARE carrier to use (3 to 3; a member of HWTYPE)
     * @param NAME name of the network
     */
    SET_SSID(HARDWARE: Value, NAME: Text): Uint8Array;
    /**
     * Switches the Bluetooth mode for Apple devices on or off
     * @param HARDWARE carrier to use (2 to 2; a member of HWTYPE)
     * @param ACTIVE whether to switch it on (0 to 1; 0: off; 1: on)
     */
    SET_MODE2(HARDWARE: Value, ACTIVE: Value): Uint8Array;
  };
};

/** A function for each system command, which returns what follows the message type. */
export declare const system: {
  /**
   * Opens a file on the brick for writing and announces its size
   * @param size bytes of the whole file
   * @param path path of the file or folder, absolute or relative to /home/root/lms2012/sys
   * @param data the first bytes of the file, usually none
   */
  BEGIN_DOWNLOAD(size: number, path: string, data: Iterable<number>): Uint8Array;
  /**
   * Writes the next piece of a file; the file closes itself when it is complete
   * @param handle the open file on the brick, as its reply to BEGIN_... gave it
   * @param data a piece of the file's contents
   */
  CONTINUE_DOWNLOAD(handle: number, data: Iterable<number>): Uint8Array;
  /**
   * Opens a file on the brick for reading and fetches its first piece
   * @param max_bytes maximum number of content bytes in the reply
   * @param path path of the file or folder, absolute or relative to /home/root/lms2012/sys
   */
  BEGIN_UPLOAD(max_bytes: number, path: string): Uint8Array;
  /**
   * Fetches the next piece of a file
   * @param handle the open file on the brick, as its reply to BEGIN_... gave it
   * @param max_bytes maximum number of content bytes in the reply
   */
  CONTINUE_UPLOAD(handle: number, max_bytes: number): Uint8Array;
  /**
   * Opens a file that may still be growing, such as a data log, and fetches its first piece
   * @param max_bytes maximum number of content bytes in the reply
   * @param path path of the file or folder, absolute or relative to /home/root/lms2012/sys
   */
  BEGIN_GETFILE(max_bytes: number, path: string): Uint8Array;
  /**
   * Fetches the next piece of a file that may still be growing
   * @param handle the open file on the brick, as its reply to BEGIN_... gave it
   * @param max_bytes maximum number of content bytes in the reply
   */
  CONTINUE_GETFILE(handle: number, max_bytes: number): Uint8Array;
  /**
   * Closes an open file before its end
   * @param handle the open file on the brick, as its reply to BEGIN_... gave it
   * @param hash MD5 of the file, often omitted
   */
  CLOSE_FILEHANDLE(handle: number, hash: Iterable<number>): Uint8Array;
  /**
   * Lists a folder and fetches the first piece of the listing
   * @param max_bytes maximum number of content bytes in the reply
   * @param path path of the file or folder, absolute or relative to /home/root/lms2012/sys
   */
  LIST_FILES(max_bytes: number, path: string): Uint8Array;
  /**
   * Fetches the next piece of a listing
   * @param handle the open file on the brick, as its reply to BEGIN_... gave it
   * @param max_bytes maximum number of content bytes in the reply
   */
  CONTINUE_LIST_FILES(handle: number, max_bytes: number): Uint8Array;
  /**
   * Creates a folder
   * @param path path of the file or folder, absolute or relative to /home/root/lms2012/sys
   */
  CREATE_DIR(path: string): Uint8Array;
  /**
   * Deletes a file or an empty folder
   * @param path path of the file or folder, absolute or relative to /home/root/lms2012/sys
   */
  DELETE_FILE(path: string): Uint8Array;
  /**
   * Asks which file handles are in use
   */
  LIST_OPEN_HANDLES(): Uint8Array;
  /**
   * Puts a message into a mailbox of the program that runs on the brick
   * @param name the mailbox
   * @param payload the message: a text (with its zero), a number (a single), a logic value (one byte), or other bytes
   */
  WRITEMAILBOX(name: string, payload: string | number | boolean | Iterable<number>): Uint8Array;
  /**
   * Sends the PIN for a Bluetooth device (USB only)
   * @param mac MAC address of the other device, in hex
   * @param pin the PIN
   */
  BLUETOOTHPIN(mac: string, pin: string): Uint8Array;
  /**
   * Restarts the brick into its firmware updater
   */
  ENTERFWUPDATE(): Uint8Array;
  /**
   * Sets the bundle identifier that the brick shows to Apple devices
   * @param id the identifier
   */
  SETBUNDLEID(id: string): Uint8Array;
  /**
   * Sets the bundle seed identifier that the brick shows to Apple devices
   * @param id the identifier
   */
  SETBUNDLESEEDID(id: string): Uint8Array;
};
