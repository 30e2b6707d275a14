-- LEGO MINDSTORMS EV3 dissector for Wireshark 4.0 and later (Lua 5.2 and 5.4). Licence: MIT.
--
-- To install it, put this file into the personal Lua plugins folder, which Wireshark names under Help, About,
-- Folders; or run: ev3proto dissector install
--
-- This file is made by ev3proto 0.2.0, from its tables of the EV3's protocol and its runtime for Wireshark.
-- Change those, not this file.

set_plugin_info({
    version = "0.2.0",
    description = "LEGO MINDSTORMS EV3: direct and system commands over WiFi, USB and Bluetooth",
    author = "the ev3proto authors",
})

if package.loaded["ev3.lua"] then
    io.stderr:write("ev3.lua is loaded already; this copy is ignored: ", debug.getinfo(1, "S").short_src, "\n")
    return
end
package.loaded["ev3.lua"] = true
local ev3 = Proto("EV3", "LEGO MINDSTORMS EV3")

-- Words --------------------------------------------------------------------------------------------------------------
--
-- The vocabulary of the tables below.

local IN, OUT, INOUT =
    "IN", "OUT", "INOUT"
local DATA8, DATA16, DATA32, DATAF, STRING, HANDLE, ARRAY_TYPED, LABEL, COUNT, VALUES =
    "DATA8", "DATA16", "DATA32", "DATAF", "STRING", "HANDLE", "ARRAY_TYPED", "LABEL", "COUNT", "VALUES"
local CONSTANT, CONSTANT_TEXT, LOCAL, GLOBAL, JUMP =
    "CONSTANT", "CONSTANT_TEXT", "LOCAL", "GLOBAL", "JUMP"
local U8, U16, U32, TEXT, COUNTED_TEXT, BYTES, LISTING =
    "U8", "U16", "U32", "TEXT", "COUNTED_TEXT", "BYTES", "LISTING"
local TYPE_NAMES = { DATA8 = "DATA8", DATA16 = "DATA16", DATA32 = "DATA32", DATAF = "DATAF", STRING = "string", HANDLE = "handle",
    ARRAY_TYPED = "array-typed", LABEL = "label", COUNT = "count", VALUES = "values" }
-- Bytes of a value in memory, for the types that have one.
local SIZE_OF = { DATA8 = 1, DATA16 = 2, DATA32 = 4, DATAF = 4, HANDLE = 2 }
local DIALECTS = { "official", "xtended", "compat" }

-- Frames -------------------------------------------------------------------------------------------------------------
--
-- The header, the types of messages, and limits.

local LENGTH_FIELD = 2
local HEADER_SIZE = 5
local COMMAND_HEADER_SIZE = 7
local MIN_LENGTH = 3
local MAX_LENGTH = 1022
local MOST_COUNTED = 127
local SPINNING = 1000000
local GLOBAL_MASK = 0x03FF
local LOCAL_MASK = 0xFC00
local REPORT_SIZES = { [64] = "daisy", [1024] = "computer" }

local MESSAGE_TYPES = {
    [0x00] = { name = "DIRECT_COMMAND_REPLY", carries = "direct", is_command = true, wants_reply = true },
    [0x80] = { name = "DIRECT_COMMAND_NO_REPLY", carries = "direct", is_command = true },
    [0x01] = { name = "SYSTEM_COMMAND_REPLY", carries = "system", is_command = true, wants_reply = true },
    [0x81] = { name = "SYSTEM_COMMAND_NO_REPLY", carries = "system", is_command = true },
    [0x02] = { name = "DIRECT_REPLY", carries = "direct" },
    [0x04] = { name = "DIRECT_REPLY_ERROR", carries = "direct", is_error = true },
    [0x03] = { name = "SYSTEM_REPLY", carries = "system" },
    [0x05] = { name = "SYSTEM_REPLY_ERROR", carries = "system", is_error = true },
    [0x0A] = { name = "DAISY_COMMAND_REPLY", carries = "daisy", is_command = true, wants_reply = true },
    [0x8A] = { name = "DAISY_COMMAND_NO_REPLY", carries = "daisy", is_command = true },
    [0x08] = { name = "DAISY_REPLY", carries = "daisy" },
    [0x09] = { name = "DAISY_REPLY_ERROR", carries = "daisy", is_error = true },
}
-- Bytes 1 to 4 of a header. No message type is a special character of patterns.
local HEADER_PATTERN = "[\0-\3]..[\0\128\1\129\2\4\3\5\10\138\8\9]"
local NAMES = { message_types = {}, opcodes = {}, system_commands = {} }
for number, declared in pairs(MESSAGE_TYPES) do
    NAMES.message_types[number] = declared.name
end

-- Arguments ----------------------------------------------------------------------------------------------------------
--
-- Identification bytes: first and last byte, encoding, kind, number of bytes that follow.

local ENCODING_ROWS = {
    { 0x00, 0x1F, "LC0", CONSTANT, 0, value = 0 },
    { 0x20, 0x3F, "LC0", CONSTANT, 0, value = -32 },
    { 0x40, 0x5F, "LV0", LOCAL, 0, value = 0 },
    { 0x60, 0x7F, "GV0", GLOBAL, 0, value = 0 },
    { 0x80, 0x80, "LCS_OLD", CONSTANT_TEXT },
    { 0x81, 0x81, "LC1", CONSTANT, 1 },
    { 0x82, 0x82, "LC2", CONSTANT, 2 },
    { 0x83, 0x83, "LC4", CONSTANT, 4 },
    { 0x84, 0x84, "LCS", CONSTANT_TEXT },
    { 0x88, 0x88, "LCS_OLD", CONSTANT_TEXT, address = true },
    { 0x89, 0x89, "LC1", CONSTANT, 1, address = true },
    { 0x8A, 0x8A, "LC2", CONSTANT, 2, address = true },
    { 0x8B, 0x8B, "LC4", CONSTANT, 4, address = true },
    { 0x8C, 0x8C, "LCS", CONSTANT_TEXT, address = true },
    { 0x90, 0x90, "LCS_OLD", CONSTANT_TEXT, handle = true },
    { 0x91, 0x91, "LC1", CONSTANT, 1, handle = true },
    { 0x92, 0x92, "LC2", CONSTANT, 2, handle = true },
    { 0x93, 0x93, "LC4", CONSTANT, 4, handle = true },
    { 0x94, 0x94, "LCS", CONSTANT_TEXT, handle = true },
    { 0x98, 0x98, "LCS_OLD", CONSTANT_TEXT, handle = true, address = true },
    { 0x99, 0x99, "LC1", CONSTANT, 1, handle = true, address = true },
    { 0x9A, 0x9A, "LC2", CONSTANT, 2, handle = true, address = true },
    { 0x9B, 0x9B, "LC4", CONSTANT, 4, handle = true, address = true },
    { 0x9C, 0x9C, "LCS", CONSTANT_TEXT, handle = true, address = true },
    { 0xA0, 0xA7, "LAB1", JUMP, 1 },
    { 0xA8, 0xAF, "LAB1", JUMP, 1, address = true },
    { 0xB0, 0xB7, "LAB1", JUMP, 1, handle = true },
    { 0xB8, 0xBF, "LAB1", JUMP, 1, handle = true, address = true },
    { 0xC1, 0xC1, "LV1", LOCAL, 1 },
    { 0xC2, 0xC2, "LV2", LOCAL, 2 },
    { 0xC3, 0xC3, "LV4", LOCAL, 4 },
    { 0xC9, 0xC9, "LV1", LOCAL, 1, address = true },
    { 0xCA, 0xCA, "LV2", LOCAL, 2, address = true },
    { 0xCB, 0xCB, "LV4", LOCAL, 4, address = true },
    { 0xD1, 0xD1, "LV1", LOCAL, 1, handle = true },
    { 0xD2, 0xD2, "LV2", LOCAL, 2, handle = true },
    { 0xD3, 0xD3, "LV4", LOCAL, 4, handle = true },
    { 0xD9, 0xD9, "LV1", LOCAL, 1, handle = true, address = true },
    { 0xDA, 0xDA, "LV2", LOCAL, 2, handle = true, address = true },
    { 0xDB, 0xDB, "LV4", LOCAL, 4, handle = true, address = true },
    { 0xE1, 0xE1, "GV1", GLOBAL, 1 },
    { 0xE2, 0xE2, "GV2", GLOBAL, 2 },
    { 0xE3, 0xE3, "GV4", GLOBAL, 4 },
    { 0xE9, 0xE9, "GV1", GLOBAL, 1, address = true },
    { 0xEA, 0xEA, "GV2", GLOBAL, 2, address = true },
    { 0xEB, 0xEB, "GV4", GLOBAL, 4, address = true },
    { 0xF1, 0xF1, "GV1", GLOBAL, 1, handle = true },
    { 0xF2, 0xF2, "GV2", GLOBAL, 2, handle = true },
    { 0xF3, 0xF3, "GV4", GLOBAL, 4, handle = true },
    { 0xF9, 0xF9, "GV1", GLOBAL, 1, handle = true, address = true },
    { 0xFA, 0xFA, "GV2", GLOBAL, 2, handle = true, address = true },
    { 0xFB, 0xFB, "GV4", GLOBAL, 4, handle = true, address = true },
}

-- Enumerations -------------------------------------------------------------------------------------------------------
--
-- Names of numbers.

local ENUMERATIONS = {
    BROWSERTYPE = { names = { [0] = "BROWSE_FOLDERS", [1] = "BROWSE_FOLDS_FILES", [2] = "BROWSE_CACHE", [3] = "BROWSE_FILES" } },
    BTTYPE = { names = { [3] = "BTTYPE_PC", [4] = "BTTYPE_PHONE", [5] = "BTTYPE_BRICK", [6] = "BTTYPE_UNKNOWN" } },
    BUTTONTYPE = { names = { [0] = "NO_BUTTON", [1] = "UP_BUTTON", [2] = "ENTER_BUTTON", [3] = "DOWN_BUTTON", [4] = "RIGHT_BUTTON", [5] = "LEFT_BUTTON",
            [6] = "BACK_BUTTON", [7] = "ANY_BUTTON" } },
    CONN = { names = { [111] = "CONN_UNKNOWN", [117] = "CONN_DAISYCHAIN", [118] = "CONN_NXT_COLOR", [119] = "CONN_NXT_DUMB", [120] = "CONN_NXT_IIC",
            [121] = "CONN_INPUT_DUMB", [122] = "CONN_INPUT_UART", [123] = "CONN_OUTPUT_DUMB", [124] = "CONN_OUTPUT_INTELLIGENT",
            [125] = "CONN_OUTPUT_TACHO", [126] = "CONN_NONE", [127] = "CONN_ERROR" } },
    DATA_FORMAT = { names = { [0] = "DATA_8", [1] = "DATA_16", [2] = "DATA_32", [3] = "DATA_F", [4] = "DATA_S", [5] = "DATA_A", [7] = "DATA_V",
            [16] = "DATA_PCT", [18] = "DATA_RAW", [19] = "DATA_SI" } },
    DEL = { names = { [0] = "DEL_NONE", [1] = "DEL_TAB", [2] = "DEL_SPACE", [3] = "DEL_RETURN", [4] = "DEL_COLON", [5] = "DEL_COMMA",
            [6] = "DEL_LINEFEED", [7] = "DEL_CRLF" } },
    ENCRYPT = { names = { [0] = "ENCRYPT_NONE", [1] = "ENCRYPT_WPA2" } },
    FILETYPE = { names = { [0] = "FILETYPE_UNKNOWN", [1] = "TYPE_FOLDER", [2] = "TYPE_SOUND", [3] = "TYPE_BYTECODE", [4] = "TYPE_GRAPHICS",
            [5] = "TYPE_DATALOG", [6] = "TYPE_PROGRAM", [7] = "TYPE_TEXT", [16] = "TYPE_SDCARD", [32] = "TYPE_USBSTICK",
            [-1] = "TYPE_RESTART_BROWSER", [-2] = "TYPE_REFRESH_BROWSER" } },
    FONTTYPE = { names = { [0] = "NORMAL_FONT", [1] = "SMALL_FONT", [2] = "LARGE_FONT", [3] = "TINY_FONT" } },
    HWTYPE = { names = { [1] = "HW_USB", [2] = "HW_BT", [3] = "HW_WIFI" } },
    ICONTYPE = { names = { [0] = "NORMAL_ICON", [1] = "SMALL_ICON", [2] = "LARGE_ICON", [3] = "MENU_ICON", [4] = "ARROW_ICON" } },
    LEDPATTERN = { names = { [0] = "LED_BLACK", [1] = "LED_GREEN", [2] = "LED_RED", [3] = "LED_ORANGE", [4] = "LED_GREEN_FLASH", [5] = "LED_RED_FLASH",
            [6] = "LED_ORANGE_FLASH", [7] = "LED_GREEN_PULSE", [8] = "LED_RED_PULSE", [9] = "LED_ORANGE_PULSE" } },
    L_ICON_NO = { names = { [0] = "YES_NOTSEL", [1] = "YES_SEL", [2] = "NO_NOTSEL", [3] = "NO_SEL", [4] = "OFF", [5] = "WAIT_VERT", [6] = "WAIT_HORZ",
            [7] = "TO_MANUAL", [8] = "WARNSIGN", [9] = "WARN_BATT", [10] = "WARN_POWER", [11] = "WARN_TEMP", [12] = "NO_USBSTICK",
            [13] = "TO_EXECUTE", [14] = "TO_BRICK", [15] = "TO_SDCARD", [16] = "TO_USBSTICK", [17] = "TO_BLUETOOTH", [18] = "TO_WIFI",
            [19] = "TO_TRASH", [20] = "TO_COPY", [21] = "TO_FILE", [22] = "CHAR_ERROR", [23] = "COPY_ERROR", [24] = "PROGRAM_ERROR",
            [27] = "WARN_MEMORY" } },
    N_ICON_NO = { names = { [-1] = "ICON_NONE", [0] = "ICON_RUN", [1] = "ICON_FOLDER", [2] = "ICON_FOLDER2", [3] = "ICON_USB", [4] = "ICON_SD",
            [5] = "ICON_SOUND", [6] = "ICON_IMAGE", [7] = "ICON_SETTINGS", [8] = "ICON_ONOFF", [9] = "ICON_SEARCH", [10] = "ICON_WIFI",
            [11] = "ICON_CONNECTIONS", [12] = "ICON_ADD_HIDDEN", [13] = "ICON_TRASHBIN", [14] = "ICON_VISIBILITY", [15] = "ICON_KEY",
            [16] = "ICON_CONNECT", [17] = "ICON_DISCONNECT", [18] = "ICON_UP", [19] = "ICON_DOWN", [20] = "ICON_WAIT1",
            [21] = "ICON_WAIT2", [22] = "ICON_BLUETOOTH", [23] = "ICON_INFO", [24] = "ICON_TEXT", [27] = "ICON_QUESTIONMARK",
            [28] = "ICON_INFO_FILE", [29] = "ICON_DISC", [30] = "ICON_CONNECTED", [31] = "ICON_OBP", [32] = "ICON_OBD",
            [33] = "ICON_OPENFOLDER", [34] = "ICON_BRICK1" } },
    OBJSTAT = { names = { [16] = "RUNNING", [32] = "WAITING", [64] = "STOPPED", [128] = "HALTED" } },
    RESULT = { names = { [0] = "OK", [1] = "BUSY", [2] = "FAIL", [4] = "STOP", [8] = "START" } },
    SLOT = { names = { [0] = "GUI_SLOT", [1] = "USER_SLOT", [2] = "CMD_SLOT", [3] = "TERM_SLOT", [4] = "DEBUG_SLOT", [-1] = "CURRENT_SLOT" } },
    TYPE = { names = { [-1] = "MODE_KEEP", [0] = "TYPE_KEEP", [1] = "TYPE_NXT_TOUCH", [2] = "TYPE_NXT_LIGHT", [3] = "TYPE_NXT_SOUND",
            [4] = "TYPE_NXT_COLOR", [5] = "TYPE_NXT_ULTRASONIC", [6] = "TYPE_NXT_TEMPERATURE", [7] = "TYPE_TACHO", [8] = "TYPE_MINITACHO",
            [9] = "TYPE_NEWTACHO", [16] = "TYPE_TOUCH", [29] = "TYPE_COLOR", [30] = "TYPE_ULTRASONIC", [32] = "TYPE_GYRO",
            [33] = "TYPE_IR", [50] = "TYPE_THIRD_PARTY_START", [98] = "TYPE_THIRD_PARTY_END", [99] = "TYPE_ENERGYMETER",
            [100] = "TYPE_IIC_UNKNOWN", [101] = "TYPE_NXT_TEST", [123] = "TYPE_NXT_IIC", [124] = "TYPE_TERMINAL", [125] = "TYPE_UNKNOWN",
            [126] = "TYPE_NONE", [127] = "TYPE_ERROR" } },
    WARNING = { is_flags = true,
        names = { [1] = "WARNING_TEMP", [2] = "WARNING_CURRENT", [4] = "WARNING_VOLTAGE", [8] = "WARNING_MEMORY", [16] = "WARNING_DSPSTAT",
            [32] = "WARNING_RAM", [64] = "WARNING_BATTLOW", [128] = "WARNING_BUSY" } },
}

-- The types of values by DATA_FORMAT.
local FORMAT_TYPES = { [0] = DATA8, [1] = DATA16, [2] = DATA32, [3] = DATAF, [4] = STRING, [5] = ARRAY_TYPED, [7] = ARRAY_TYPED, [16] = DATA8,
    [18] = DATA32, [19] = DATAF }

-- Operations ---------------------------------------------------------------------------------------------------------
--
-- Opcode, name, description; then parameters or, for a family, its commands, which have the same. A parameter
-- is a name, direction, type and description.

local OPERATIONS = {
    { 0x00, "ERROR", "Ends the program with a failure; never valid on the wire", {} },
    { 0x01, "NOP", "Does nothing; a harmless way to test whether the brick answers", {} },
    { 0x02, "PROGRAM_STOP", "Stops the program of a slot",
        { { "PRGID", IN, DATA16, "program slot to stop", enum = ENUMERATIONS.SLOT,
                special = { [0] = "all programs", [-1] = "the calling program" }, outside = { ", which is not in SLOT", "NO_MEMBER" } } } },
    { 0x03, "PROGRAM_START", "Starts a loaded program; a direct command can do this only while no user program runs",
        { { "PRGID", IN, DATA16, "program slot", enum = ENUMERATIONS.SLOT, outside = { ", which is not in SLOT", "NO_MEMBER" } },
            { "SIZE", IN, DATA32, "size of the image; read and ignored", unit = "bytes" },
            { "IP", IN, DATA32, "address of the image, as FILE.LOAD_IMAGE returned it" },
            { "DEBUG", IN, DATA8, "how to run it", special = { [0] = "run", [1] = "debug", [2] = "load, do not run" }, range = { 0, 2 },
                outside = { ", outside of 0 to 2", "OUTSIDE" } } } },
    { 0x04, "OBJECT_STOP", "Stops an object of its own program", { { "OBJID", IN, DATA16, "object of the program, counted from 1" } } },
    { 0x05, "OBJECT_START", "Starts an object of its own program", { { "OBJID", IN, DATA16, "object of the program, counted from 1" } } },
    { 0x06, "OBJECT_TRIG", "Counts an object's trigger down; at zero the object starts",
        { { "OBJID", IN, DATA16, "object of the program, counted from 1" } } },
    { 0x07, "OBJECT_WAIT", "Waits until an object has ended", { { "OBJID", IN, DATA16, "object of the program, counted from 1" } } },
    { 0x08, "RETURN", "Returns from a subroutine to its caller", {} },
    { 0x09, "CALL", "Calls a subroutine of its own program; waits while another thread runs it",
        { { "OBJID", IN, DATA16, "object number of the subroutine, counted from 1" },
            { "PARAMETERS", IN, COUNT, "number of parameters follow; the subroutine declares their types and directions", any = true,
                element = DATA32, elements = IN } } },
    { 0x0A, "OBJECT_END", "Ends the object; the firmware appends one to every direct command", {} },
    { 0x0B, "SLEEP", "Gives up the rest of the thread's time slice", {} },
    { 0x0C, "PROGRAM_INFO", "Asks about a program or controls its objects",
        commands = {
            { 0, "OBJ_STOP", "Stops an object of a running program",
                { { "PRGID", IN, DATA16, "program slot", enum = ENUMERATIONS.SLOT, outside = { ", which is not in SLOT", "NO_MEMBER" } },
                    { "OBJID", IN, DATA16, "object of the program, counted from 1" } } },
            { 4, "OBJ_START", "Starts an object of a running program from its beginning",
                { { "PRGID", IN, DATA16, "program slot", enum = ENUMERATIONS.SLOT, outside = { ", which is not in SLOT", "NO_MEMBER" } },
                    { "OBJID", IN, DATA16, "object of the program, counted from 1" } } },
            { 22, "GET_STATUS", "Asks whether a program runs",
                { { "PRGID", IN, DATA16, "program slot", enum = ENUMERATIONS.SLOT, outside = { ", which is not in SLOT", "NO_MEMBER" } },
                    { "DATA", OUT, DATA8, "state of the program", enum = ENUMERATIONS.OBJSTAT } } },
            { 23, "GET_SPEED", "Asks for a program's speed",
                { { "PRGID", IN, DATA16, "program slot", enum = ENUMERATIONS.SLOT, outside = { ", which is not in SLOT", "NO_MEMBER" } },
                    { "DATA", OUT, DATA32, "speed since the program started", unit = "instructions/s" } } },
            { 24, "GET_PRGRESULT", "Asks how a program ended",
                { { "PRGID", IN, DATA16, "program slot", enum = ENUMERATIONS.SLOT, outside = { ", which is not in SLOT", "NO_MEMBER" } },
                    { "DATA", OUT, DATA8, "OK, BUSY (still running) or FAIL", enum = ENUMERATIONS.RESULT } } },
            { 25, "SET_INSTR", "Sets how many instructions the calling thread may still run in its time slice",
                { { "PRGID", IN, DATA16, "program slot", enum = ENUMERATIONS.SLOT, outside = { ", which is not in SLOT", "NO_MEMBER" } } } },
            { 26, "GET_PRGNAME", "Asks for the name of a program",
                { { "PRGID", IN, DATA16, "program slot", enum = ENUMERATIONS.SLOT, outside = { ", which is not in SLOT", "NO_MEMBER" } },
                    { "NAME", OUT, STRING, "name of the program, zero-terminated" } },
                dialects = { xtended = true, compat = true } },
        } },
    { 0x0D, "LABEL", "Marks a place that jumps can name; does nothing itself",
        { { "NO", IN, LABEL, "number of the label", range = { 0, 31 }, is_label = true } } },
    { 0x0E, "PROBE", "Prints a program's memory on the brick's debug terminal",
        { { "PRGID", IN, DATA16, "program slot", enum = ENUMERATIONS.SLOT, outside = { ", which is not in SLOT", "NO_MEMBER" } },
            { "OBJID", IN, DATA16, "object whose local memory to print", special = { [0] = "the global memory" } },
            { "OFFSET", IN, DATA32, "first byte", unit = "bytes" },
            { "SIZE", IN, DATA32, "number of bytes to print", unit = "bytes", special = { [0] = "all, 1024 at most" }, range = { 0, 1024 },
                outside = { " bytes, outside of 0 to 1024 bytes", "OUTSIDE" } } } },
    { 0x0F, "DO", "Runs byte code that is already in memory, ending the slot's previous program",
        { { "PRGID", IN, DATA16, "program slot", enum = ENUMERATIONS.SLOT, outside = { ", which is not in SLOT", "NO_MEMBER" } },
            { "IMAGE", IN, DATA32, "address of the byte code image" }, { "GLOBAL", IN, DATA32, "address of the global memory it uses" } } },
    { 0x60, "SYSTEM", "Runs a shell command on the brick's Linux and waits until it ends",
        { { "COMMAND", IN, STRING, "the command line" },
            { "STATUS", OUT, DATA32, "wait status as C's system() gives it: 256 times the exit code",
                special = { [0] = "success", [-1] = "could not run" } } } },
    { 0x61, "PORT_CNV_OUTPUT", "Splits a motor port number as LEGO's editor writes it",
        { { "PortIn", IN, DATA32, "three decimal digits, each 1-4: layer, first port, second port (123: B and C)" },
            { "Layer", OUT, DATA8, "position in the daisy chain", special = { [0] = "this brick" }, range = { 0, 3 } },
            { "Bitfield", OUT, DATA8, "motor ports as bits: A=1 B=2 C=4 D=8", range = { 0, 15 } },
            { "Inverted", OUT, DATA8, "whether the first port comes after the second, as in CA", special = { [0] = "no", [1] = "yes" },
                range = { 0, 1 } } } },
    { 0x62, "PORT_CNV_INPUT", "Splits a sensor port number as LEGO's editor writes it",
        { { "PortIn", IN, DATA32, "three decimal digits: layer 1-4, any, port 1-4 (103: port 3)" },
            { "Layer", OUT, DATA8, "position in the daisy chain", special = { [0] = "this brick" }, range = { 0, 3 } },
            { "PortOut", OUT, DATA8, "sensor port minus one, as in INPUT_*", range = { 0, 3 } } } },
    { 0x63, "NOTE_TO_FREQ", "Converts the name of a note to its frequency",
        { { "NOTE", IN, STRING, "C4 to B6, sharps as C#4" },
            { "FREQ", OUT, DATA16, "frequency; 440 for an unknown note", unit = "Hz", range = { 262, 1976 } } } },
    { 0x7C, "INFO", "Reads and sets the error log, the volume and the time to power off",
        commands = {
            { 1, "SET_ERROR", "Adds an error to the brick's error log",
                { { "NUMBER", IN, DATA8, "number of the error", special = { [0] = "nothing is logged" } } } },
            { 2, "GET_ERROR", "Removes and returns the oldest error of the brick's error log",
                { { "NUMBER", OUT, DATA8, "number of the error", special = { [0] = "the log is empty" } } } },
            { 3, "ERRORTEXT", "Converts the number of an error to its name",
                { { "NUMBER", IN, DATA8, "number of the error", special = { [0] = "gives an empty text" } },
                    { "LENGTH", IN, DATA8, "size of the text buffer, including the zero", unit = "bytes", special = { [-1] = "no limit" } },
                    { "DESTINATION", OUT, STRING, "name of the error, at most 31 characters", length = "LENGTH" } } },
            { 4, "GET_VOLUME", "Reads the volume setting", { { "VALUE", OUT, DATA8, "volume", unit = "%", range = { 0, 100 } } } },
            { 5, "SET_VOLUME", "Changes the volume setting",
                { { "VALUE", IN, DATA8, "volume", unit = "%", range = { 0, 100 }, outside = { " %, outside of 0 to 100 %", "OUTSIDE" } } } },
            { 6, "GET_MINUTES", "Reads the idle time after which the brick powers off",
                { { "VALUE", OUT, DATA8, "idle time", unit = "min", special = { [0] = "never" }, range = { 0, 120 } } } },
            { 7, "SET_MINUTES", "Changes the idle time after which the brick powers off",
                { { "VALUE", IN, DATA8, "idle time", unit = "min", special = { [0] = "never" }, range = { 0, 120 },
                        outside = { " min, outside of 0 to 120 min", "OUTSIDE" } } } },
        } },
    { 0x7D, "STRINGS", "Works with texts: joins, compares, converts from and to numbers",
        commands = {
            { 1, "GET_SIZE", "Reads the length of a text",
                { { "SOURCE1", IN, STRING, "text to work on" }, { "SIZE", OUT, DATA16, "its length, not including the zero", unit = "bytes" } } },
            { 2, "ADD", "Joins two texts",
                { { "SOURCE1", IN, STRING, "first part" }, { "SOURCE2", IN, STRING, "second part" },
                    { "DESTINATION", OUT, STRING, "resulting text, zero-terminated" } } },
            { 3, "COMPARE", "Reports whether two texts are equal; case matters",
                { { "SOURCE1", IN, STRING, "one text" }, { "SOURCE2", IN, STRING, "the other text" },
                    { "RESULT", OUT, DATA8, "whether they are equal", special = { [0] = "different", [1] = "the same" }, range = { 0, 1 } } } },
            { 5, "DUPLICATE", "Copies a text",
                { { "SOURCE1", IN, STRING, "text to work on" }, { "DESTINATION", OUT, STRING, "resulting text, zero-terminated" } } },
            { 6, "VALUE_TO_STRING", "Writes a floating-point number as text, without trailing zeros",
                { { "VALUE", IN, DATAF, "number to write; NaN becomes ----" },
                    { "FIGURES", IN, DATA8, "width, including the point; negative aligns left", unit = "characters" },
                    { "DECIMALS", IN, DATA8, "digits after the point" },
                    { "DESTINATION", OUT, STRING, "resulting text, zero-terminated", most = 128 } } },
            { 7, "STRING_TO_VALUE", "Reads a number from a text",
                { { "SOURCE1", IN, STRING, "text to read; a comma counts as decimal point" }, { "DESTINATION", OUT, DATAF, "the number" } } },
            { 8, "STRIP", "Removes every space from a text",
                { { "SOURCE1", IN, STRING, "text to work on" }, { "DESTINATION", OUT, STRING, "resulting text, zero-terminated" } } },
            { 9, "NUMBER_TO_STRING", "Writes a whole number as text, with leading zeros",
                { { "VALUE", IN, DATA16, "number to write" }, { "FIGURES", IN, DATA8, "width of the text", unit = "characters" },
                    { "DESTINATION", OUT, STRING, "resulting text, zero-terminated", most = 128 } } },
            { 10, "SUB", "Returns the part of a text after another text found in it",
                { { "SOURCE1", IN, STRING, "text to search" }, { "SOURCE2", IN, STRING, "text to find; must occur" },
                    { "DESTINATION", OUT, STRING, "resulting text, zero-terminated" } } },
            { 11, "VALUE_FORMATTED", "Writes a floating-point number as text in a format of C's printf",
                { { "VALUE", IN, DATAF, "number to write" }, { "FORMAT", IN, STRING, "format, such as %5.2f" },
                    { "SIZE", IN, DATA8, "size of the text buffer, including the zero", unit = "bytes" },
                    { "DESTINATION", OUT, STRING, "resulting text", length = "SIZE" } } },
            { 12, "NUMBER_FORMATTED", "Writes a whole number as text in a format of C's printf",
                { { "VALUE", IN, DATA32, "number to write" }, { "FORMAT", IN, STRING, "format, such as %05d or %X" },
                    { "SIZE", IN, DATA8, "size of the text buffer, including the zero", unit = "bytes" },
                    { "DESTINATION", OUT, STRING, "resulting text", length = "SIZE" } } },
        } },
    { 0x88, "BP0", "Stops at breakpoint 0; BP_SET puts it over the instruction it replaces", {} },
    { 0x89, "BP1", "Stops at breakpoint 1; BP_SET puts it over the instruction it replaces", {} },
    { 0x8A, "BP2", "Stops at breakpoint 2; BP_SET puts it over the instruction it replaces", {} },
    { 0x8B, "BP3", "Pulses test pin TP4 and continues; BP_SET puts it over the instruction it replaces", {} },
    { 0x8C, "BP_SET", "Sets or removes a breakpoint in a running program",
        { { "PRGID", IN, DATA16, "program slot", enum = ENUMERATIONS.SLOT, outside = { ", which is not in SLOT", "NO_MEMBER" } },
            { "NO", IN, DATA8, "number of the breakpoint", special = { [3] = "pulse on test pin TP4, no stop" }, range = { 0, 2 },
                outside = { ", outside of 0 to 2 or 3 (pulse on test pin TP4, no stop)", "OUTSIDE" } },
            { "ADDRESS", IN, DATA32, "offset in the image", unit = "bytes", special = { [0] = "remove the breakpoint" } } } },
    { 0xF0, "DYNLOAD_VMLOAD", "Loads an additional virtual machine; fails while another one is loaded",
        { { "VMINDEX", IN, DATA8, "which one", special = { [0] = "RobotC", [1] = "LabVIEW" }, range = { 0, 1 },
                outside = { ", outside of 0 to 1", "OUTSIDE" } },
            { "RESULT", OUT, DATA8, "OK or FAIL", enum = ENUMERATIONS.RESULT } },
        dialects = { xtended = true, compat = true } },
    { 0xF1, "DYNLOAD_VMEXIT", "Unloads the additional virtual machine", {}, dialects = { xtended = true, compat = true } },
    { 0xF2, "DYNLOAD_ENTRY_0", "Calls entry point 0 of the additional virtual machine that is loaded",
        { { "CMD", IN, DATA8, "function to call, in that machine's numbering" }, { "LENGTH_IN", IN, DATA8, "amount of data passed" },
            { "LENGTH_OUT", OUT, DATA16, "number of elements returned" },
            { "VALUE", OUT, ARRAY_TYPED, "the returned elements; their type depends on CMD", length = "LENGTH_OUT" } },
        dialects = { xtended = true, compat = true } },
    { 0xF3, "DYNLOAD_ENTRY_1", "Calls entry point 1 of the additional virtual machine that is loaded",
        { { "CMD", IN, DATA8, "function to call, in that machine's numbering" }, { "LENGTH_IN", IN, DATA8, "amount of data passed" },
            { "LENGTH_OUT", OUT, DATA16, "number of elements returned" },
            { "VALUE", OUT, ARRAY_TYPED, "the returned elements; their type depends on CMD", length = "LENGTH_OUT" } },
        dialects = { xtended = true, compat = true } },
    { 0xF4, "DYNLOAD_ENTRY_2", "Calls entry point 2 of the additional virtual machine that is loaded",
        { { "CMD", IN, DATA8, "function to call, in that machine's numbering" }, { "LENGTH_IN", IN, DATA8, "amount of data passed" },
            { "LENGTH_OUT", OUT, DATA16, "number of elements returned" },
            { "VALUE", OUT, ARRAY_TYPED, "the returned elements; their type depends on CMD", length = "LENGTH_OUT" } },
        dialects = { xtended = true, compat = true } },
    { 0xF5, "DYNLOAD_ENTRY_3", "Calls entry point 3 of the additional virtual machine that is loaded",
        { { "CMD", IN, DATA8, "function to call, in that machine's numbering" }, { "LENGTH_IN", IN, DATA8, "amount of data passed" },
            { "LENGTH_OUT", OUT, DATA16, "number of elements returned" },
            { "VALUE", OUT, ARRAY_TYPED, "the returned elements; their type depends on CMD", length = "LENGTH_OUT" } },
        dialects = { xtended = true, compat = true } },
    { 0xF6, "DYNLOAD_ENTRY_4", "Calls entry point 4 of the additional virtual machine that is loaded",
        { { "CMD", IN, DATA8, "function to call, in that machine's numbering" }, { "LENGTH_IN", IN, DATA8, "amount of data passed" },
            { "LENGTH_OUT", OUT, DATA16, "number of elements returned" },
            { "VALUE", OUT, ARRAY_TYPED, "the returned elements; their type depends on CMD", length = "LENGTH_OUT" } },
        dialects = { xtended = true, compat = true } },
    { 0xF7, "DYNLOAD_ENTRY_5", "Calls entry point 5 of the additional virtual machine that is loaded",
        { { "CMD", IN, DATA8, "function to call, in that machine's numbering" }, { "LENGTH_IN", IN, DATA8, "amount of data passed" },
            { "LENGTH_OUT", OUT, DATA16, "number of elements returned" },
            { "VALUE", OUT, ARRAY_TYPED, "the returned elements; their type depends on CMD", length = "LENGTH_OUT" } },
        dialects = { xtended = true, compat = true } },
    { 0xF8, "DYNLOAD_ENTRY_6", "Calls entry point 6 of the additional virtual machine that is loaded",
        { { "CMD", IN, DATA8, "function to call, in that machine's numbering" }, { "LENGTH_IN", IN, DATA8, "amount of data passed" },
            { "LENGTH_OUT", OUT, DATA16, "number of elements returned" },
            { "VALUE", OUT, ARRAY_TYPED, "the returned elements; their type depends on CMD", length = "LENGTH_OUT" } },
        dialects = { xtended = true, compat = true } },
    { 0xF9, "DYNLOAD_ENTRY_7", "Calls entry point 7 of the additional virtual machine that is loaded",
        { { "CMD", IN, DATA8, "function to call, in that machine's numbering" }, { "LENGTH_IN", IN, DATA8, "amount of data passed" },
            { "LENGTH_OUT", OUT, DATA16, "number of elements returned" },
            { "VALUE", OUT, ARRAY_TYPED, "the returned elements; their type depends on CMD", length = "LENGTH_OUT" } },
        dialects = { xtended = true, compat = true } },
    { 0xFA, "DYNLOAD_ENTRY_8", "Calls entry point 8 of the additional virtual machine that is loaded",
        { { "CMD", IN, DATA8, "function to call, in that machine's numbering" }, { "LENGTH_IN", IN, DATA8, "amount of data passed" },
            { "LENGTH_OUT", OUT, DATA16, "number of elements returned" },
            { "VALUE", OUT, ARRAY_TYPED, "the returned elements; their type depends on CMD", length = "LENGTH_OUT" } },
        dialects = { xtended = true, compat = true } },
    { 0xFB, "DYNLOAD_ENTRY_9", "Calls entry point 9 of the additional virtual machine that is loaded",
        { { "CMD", IN, DATA8, "function to call, in that machine's numbering" }, { "LENGTH_IN", IN, DATA8, "amount of data passed" },
            { "LENGTH_OUT", OUT, DATA16, "number of elements returned" },
            { "VALUE", OUT, ARRAY_TYPED, "the returned elements; their type depends on CMD", length = "LENGTH_OUT" } },
        dialects = { xtended = true, compat = true } },
    { 0xFC, "DYNLOAD_GET_VM", "Asks which additional virtual machine is loaded",
        { { "RESULT", OUT, DATA8, "which one", special = { [-1] = "none", [0] = "RobotC", [1] = "LabVIEW" }, range = { 0, 1 } } },
        dialects = { xtended = true, compat = true } },
    { 0xFF, "TST", "Tests the hardware, as the factory does; all fail before TST_OPEN",
        commands = {
            { 10, "TST_OPEN", "Allows test commands for 10 seconds; each one restarts the timer", {} },
            { 11, "TST_CLOSE", "Ends the test mode", {} },
            { 12, "TST_READ_PINS", "Reads the pins of a connector",
                { { "PORT", IN, DATA8, "connector: 0..3 are sensor ports 1-4, 16..19 are motor ports A-D", range = { 0, 19 },
                        outside = { ", outside of 0 to 19", "OUTSIDE" } },
                    { "LENGTH", IN, DATA8, "number of pins to read, usually 5" },
                    { "STRING", OUT, DATA8, "one character per pin: 0 low, 1 high", length = "LENGTH" } } },
            { 13, "TST_WRITE_PINS", "Sets the pins of a connector",
                { { "PORT", IN, DATA8, "connector: 0..3 are sensor ports 1-4, 16..19 are motor ports A-D", range = { 0, 19 },
                        outside = { ", outside of 0 to 19", "OUTSIDE" } },
                    { "LENGTH", IN, DATA8, "number of pins to set, usually 5" },
                    { "STRING", IN, DATA8, "one character per pin: 0 low, 1 high, X floating, - unchanged", length = "LENGTH" } } },
            { 14, "TST_READ_ADC", "Reads the analog converter",
                { { "INDEX", IN, DATA8, "channel: 0..3 pin 1 and 4..7 pin 6 of sensor ports, 8..11 pin 5 of motor ports",
                        special = { [12] = "battery temperature", [13] = "motor current", [14] = "battery current", [15] = "battery voltage" },
                        range = { 0, 15 }, outside = { ", outside of 0 to 15", "OUTSIDE" } },
                    { "VALUE", OUT, DATA16, "raw reading", unit = "counts", range = { 0, 4095 } } } },
            { 15, "TST_WRITE_UART", "Sends bytes on a sensor port's serial line",
                { { "PORT", IN, DATA8, "sensor port minus one", range = { 0, 3 }, outside = { ", outside of 0 to 3", "OUTSIDE" } },
                    { "LENGTH", IN, DATA8, "number of bytes to send", unit = "bytes", range = { 0, 63 },
                        outside = { " bytes, outside of 0 to 63 bytes", "OUTSIDE" } },
                    { "STRING", IN, DATA8, "the bytes", length = "LENGTH" } } },
            { 16, "TST_READ_UART", "Reads the bytes received on a sensor port's serial line",
                { { "PORT", IN, DATA8, "sensor port minus one", range = { 0, 3 }, outside = { ", outside of 0 to 3", "OUTSIDE" } },
                    { "LENGTH", IN, DATA8, "number of bytes to read", unit = "bytes", range = { 0, 63 },
                        outside = { " bytes, outside of 0 to 63 bytes", "OUTSIDE" } },
                    { "STRING", OUT, DATA8, "the bytes, padded with zeros", length = "LENGTH" } } },
            { 17, "TST_ENABLE_UART", "Switches the serial lines of all sensor ports on",
                { { "BITRATE", IN, DATA32, "speed of the line", unit = "bit/s", range = { 2400, 115200 },
                        outside = { " bit/s, outside of 2400 to 115200 bit/s", "OUTSIDE" } } } },
            { 18, "TST_DISABLE_UART", "Switches the serial lines of all sensor ports off", {} },
            { 19, "TST_ACCU_SWITCH", "Reads the switch that senses the rechargeable battery",
                { { "ACTIVE", OUT, DATA8, "state of the switch", special = { [0] = "other batteries", [1] = "rechargeable battery" },
                        range = { 0, 1 } } } },
            { 20, "TST_BOOT_MODE2", "Starts Bluetooth mode 2, for Apple devices", {} },
            { 21, "TST_POLL_MODE2", "Asks for the state of the start of Bluetooth mode 2",
                { { "STATUS", OUT, DATA8, "OK, BUSY (still starting) or FAIL", enum = ENUMERATIONS.RESULT, range = { 0, 2 }, is_ranged = true } } },
            { 22, "TST_CLOSE_MODE2", "Ends Bluetooth mode 2", {} },
            { 23, "TST_RAM_CHECK", "Asks for the result of the memory test at power-on",
                { { "STATUS", OUT, DATA8, "OK or FAIL", enum = ENUMERATIONS.RESULT, range = { 0, 2 }, is_ranged = true } } },
        } },
    { 0x10, "ADD8", "Adds two 8-bit numbers",
        { { "SOURCE1", IN, DATA8, "first number" }, { "SOURCE2", IN, DATA8, "second number" }, { "DESTINATION", OUT, DATA8, "their sum" } } },
    { 0x11, "ADD16", "Adds two 16-bit numbers",
        { { "SOURCE1", IN, DATA16, "first number" }, { "SOURCE2", IN, DATA16, "second number" }, { "DESTINATION", OUT, DATA16, "their sum" } } },
    { 0x12, "ADD32", "Adds two 32-bit numbers",
        { { "SOURCE1", IN, DATA32, "first number" }, { "SOURCE2", IN, DATA32, "second number" }, { "DESTINATION", OUT, DATA32, "their sum" } } },
    { 0x13, "ADDF", "Adds two floating-point numbers",
        { { "SOURCE1", IN, DATAF, "first number" }, { "SOURCE2", IN, DATAF, "second number" }, { "DESTINATION", OUT, DATAF, "their sum" } } },
    { 0x14, "SUB8", "Subtracts one 8-bit number from another",
        { { "SOURCE1", IN, DATA8, "number to subtract from" }, { "SOURCE2", IN, DATA8, "number to subtract" },
            { "DESTINATION", OUT, DATA8, "SOURCE1 less SOURCE2" } } },
    { 0x15, "SUB16", "Subtracts one 16-bit number from another",
        { { "SOURCE1", IN, DATA16, "number to subtract from" }, { "SOURCE2", IN, DATA16, "number to subtract" },
            { "DESTINATION", OUT, DATA16, "SOURCE1 less SOURCE2" } } },
    { 0x16, "SUB32", "Subtracts one 32-bit number from another",
        { { "SOURCE1", IN, DATA32, "number to subtract from" }, { "SOURCE2", IN, DATA32, "number to subtract" },
            { "DESTINATION", OUT, DATA32, "SOURCE1 less SOURCE2" } } },
    { 0x17, "SUBF", "Subtracts one floating-point number from another",
        { { "SOURCE1", IN, DATAF, "number to subtract from" }, { "SOURCE2", IN, DATAF, "number to subtract" },
            { "DESTINATION", OUT, DATAF, "SOURCE1 less SOURCE2" } } },
    { 0x18, "MUL8", "Multiplies two 8-bit numbers",
        { { "SOURCE1", IN, DATA8, "first factor" }, { "SOURCE2", IN, DATA8, "second factor" }, { "DESTINATION", OUT, DATA8, "their product" } } },
    { 0x19, "MUL16", "Multiplies two 16-bit numbers",
        { { "SOURCE1", IN, DATA16, "first factor" }, { "SOURCE2", IN, DATA16, "second factor" }, { "DESTINATION", OUT, DATA16, "their product" } } },
    { 0x1A, "MUL32", "Multiplies two 32-bit numbers",
        { { "SOURCE1", IN, DATA32, "first factor" }, { "SOURCE2", IN, DATA32, "second factor" }, { "DESTINATION", OUT, DATA32, "their product" } } },
    { 0x1B, "MULF", "Multiplies two floating-point numbers",
        { { "SOURCE1", IN, DATAF, "first factor" }, { "SOURCE2", IN, DATAF, "second factor" }, { "DESTINATION", OUT, DATAF, "their product" } } },
    { 0x1C, "DIV8", "Divides two 8-bit numbers; by zero gives the largest or smallest value",
        { { "SOURCE1", IN, DATA8, "number to divide" }, { "SOURCE2", IN, DATA8, "number to divide by" },
            { "DESTINATION", OUT, DATA8, "quotient, cut off towards zero (0 for 0 / 0)" } } },
    { 0x1D, "DIV16", "Divides two 16-bit numbers; by zero gives the largest or smallest value",
        { { "SOURCE1", IN, DATA16, "number to divide" }, { "SOURCE2", IN, DATA16, "number to divide by" },
            { "DESTINATION", OUT, DATA16, "quotient, cut off towards zero (0 for 0 / 0)" } } },
    { 0x1E, "DIV32", "Divides two 32-bit numbers; by zero gives the largest or smallest value",
        { { "SOURCE1", IN, DATA32, "number to divide" }, { "SOURCE2", IN, DATA32, "number to divide by" },
            { "DESTINATION", OUT, DATA32, "quotient, cut off towards zero (0 for 0 / 0)" } } },
    { 0x1F, "DIVF", "Divides two floating-point numbers; by zero gives infinity or NaN",
        { { "SOURCE1", IN, DATAF, "number to divide" }, { "SOURCE2", IN, DATAF, "number to divide by" },
            { "DESTINATION", OUT, DATAF, "quotient" } } },
    { 0x20, "OR8", "Combines 8-bit values, bit by bit, by OR",
        { { "SOURCE1", IN, DATA8, "first" }, { "SOURCE2", IN, DATA8, "second" }, { "DESTINATION", OUT, DATA8, "bits set in either" } } },
    { 0x21, "OR16", "Combines 16-bit values, bit by bit, by OR",
        { { "SOURCE1", IN, DATA16, "first" }, { "SOURCE2", IN, DATA16, "second" }, { "DESTINATION", OUT, DATA16, "bits set in either" } } },
    { 0x22, "OR32", "Combines 32-bit values, bit by bit, by OR",
        { { "SOURCE1", IN, DATA32, "first" }, { "SOURCE2", IN, DATA32, "second" }, { "DESTINATION", OUT, DATA32, "bits set in either" } } },
    { 0x24, "AND8", "Combines 8-bit values, bit by bit, by AND",
        { { "SOURCE1", IN, DATA8, "first" }, { "SOURCE2", IN, DATA8, "second" }, { "DESTINATION", OUT, DATA8, "bits set in both" } } },
    { 0x25, "AND16", "Combines 16-bit values, bit by bit, by AND",
        { { "SOURCE1", IN, DATA16, "first" }, { "SOURCE2", IN, DATA16, "second" }, { "DESTINATION", OUT, DATA16, "bits set in both" } } },
    { 0x26, "AND32", "Combines 32-bit values, bit by bit, by AND",
        { { "SOURCE1", IN, DATA32, "first" }, { "SOURCE2", IN, DATA32, "second" }, { "DESTINATION", OUT, DATA32, "bits set in both" } } },
    { 0x28, "XOR8", "Combines 8-bit values, bit by bit, by exclusive OR",
        { { "SOURCE1", IN, DATA8, "first" }, { "SOURCE2", IN, DATA8, "second" },
            { "DESTINATION", OUT, DATA8, "bits set in just one of the two" } } },
    { 0x29, "XOR16", "Combines 16-bit values, bit by bit, by exclusive OR",
        { { "SOURCE1", IN, DATA16, "first" }, { "SOURCE2", IN, DATA16, "second" },
            { "DESTINATION", OUT, DATA16, "bits set in just one of the two" } } },
    { 0x2A, "XOR32", "Combines 32-bit values, bit by bit, by exclusive OR",
        { { "SOURCE1", IN, DATA32, "first" }, { "SOURCE2", IN, DATA32, "second" },
            { "DESTINATION", OUT, DATA32, "bits set in just one of the two" } } },
    { 0x2C, "RL8", "Shifts 8-bit values left; despite the name (rotate), bits shifted out on the left are lost",
        { { "SOURCE1", IN, DATA8, "value to shift" }, { "SOURCE2", IN, DATA8, "number of places", unit = "bits" },
            { "DESTINATION", OUT, DATA8, "shifted value, filled up with zero bits" } } },
    { 0x2D, "RL16", "Shifts 16-bit values left; despite the name (rotate), bits shifted out on the left are lost",
        { { "SOURCE1", IN, DATA16, "value to shift" }, { "SOURCE2", IN, DATA16, "number of places", unit = "bits" },
            { "DESTINATION", OUT, DATA16, "shifted value, filled up with zero bits" } } },
    { 0x2E, "RL32", "Shifts 32-bit values left; despite the name (rotate), bits shifted out on the left are lost",
        { { "SOURCE1", IN, DATA32, "value to shift" }, { "SOURCE2", IN, DATA32, "number of places", unit = "bits" },
            { "DESTINATION", OUT, DATA32, "shifted value, filled up with zero bits" } } },
    { 0x8D, "MATH", "Applies a mathematical function",
        commands = {
            { 1, "EXP", "Raises e to a power", { { "X", IN, DATAF, "the power" }, { "R", OUT, DATAF, "result" } } },
            { 2, "MOD", "Takes the remainder of a floating-point division",
                { { "X", IN, DATAF, "number to divide" }, { "Y", IN, DATAF, "number to divide by" },
                    { "R", OUT, DATAF, "remainder, with the sign of X" } } },
            { 3, "FLOOR", "Rounds down to a whole number", { { "X", IN, DATAF, "number to work on" }, { "R", OUT, DATAF, "result" } } },
            { 4, "CEIL", "Rounds up to a whole number", { { "X", IN, DATAF, "number to work on" }, { "R", OUT, DATAF, "result" } } },
            { 5, "ROUND", "Rounds to the nearest whole number, halves away from zero",
                { { "X", IN, DATAF, "number to work on" }, { "R", OUT, DATAF, "result" } } },
            { 6, "ABS", "Drops the sign", { { "X", IN, DATAF, "number to work on" }, { "R", OUT, DATAF, "result" } } },
            { 7, "NEGATE", "Reverses the sign", { { "X", IN, DATAF, "number to work on" }, { "R", OUT, DATAF, "result" } } },
            { 8, "SQRT", "Takes the square root", { { "X", IN, DATAF, "number to work on, not negative" }, { "R", OUT, DATAF, "result" } } },
            { 9, "LOG", "Takes the logarithm to base 10", { { "X", IN, DATAF, "number to work on, above 0" }, { "R", OUT, DATAF, "result" } } },
            { 10, "LN", "Takes the natural logarithm", { { "X", IN, DATAF, "number to work on, above 0" }, { "R", OUT, DATAF, "result" } } },
            { 11, "SIN", "Takes the sine of an angle in degrees",
                { { "X", IN, DATAF, "angle", unit = "degrees" }, { "R", OUT, DATAF, "sine, -1 to 1" } } },
            { 12, "COS", "Takes the cosine of an angle in degrees",
                { { "X", IN, DATAF, "angle", unit = "degrees" }, { "R", OUT, DATAF, "cosine, -1 to 1" } } },
            { 13, "TAN", "Takes the tangent of an angle in degrees",
                { { "X", IN, DATAF, "angle", unit = "degrees" }, { "R", OUT, DATAF, "tangent" } } },
            { 14, "ASIN", "Finds the angle that has a sine",
                { { "X", IN, DATAF, "sine", range = { -1, 1 }, outside = { ", outside of -1 to 1", "OUTSIDE" } },
                    { "R", OUT, DATAF, "angle", unit = "degrees" } } },
            { 15, "ACOS", "Finds the angle that has a cosine",
                { { "X", IN, DATAF, "cosine", range = { -1, 1 }, outside = { ", outside of -1 to 1", "OUTSIDE" } },
                    { "R", OUT, DATAF, "angle", unit = "degrees" } } },
            { 16, "ATAN", "Finds the angle that has a tangent",
                { { "X", IN, DATAF, "tangent" }, { "R", OUT, DATAF, "angle", unit = "degrees" } } },
            { 17, "MOD8", "Takes the remainder of an 8-bit division",
                { { "X", IN, DATA8, "number to divide" }, { "Y", IN, DATA8, "number to divide by, not 0" },
                    { "R", OUT, DATA8, "remainder, with the sign of X" } } },
            { 18, "MOD16", "Takes the remainder of a 16-bit division",
                { { "X", IN, DATA16, "number to divide" }, { "Y", IN, DATA16, "number to divide by, not 0" },
                    { "R", OUT, DATA16, "remainder, with the sign of X" } } },
            { 19, "MOD32", "Takes the remainder of a 32-bit division",
                { { "X", IN, DATA32, "number to divide" }, { "Y", IN, DATA32, "number to divide by, not 0" },
                    { "R", OUT, DATA32, "remainder, with the sign of X" } } },
            { 20, "POW", "Raises a number to a power",
                { { "X", IN, DATAF, "number to raise" }, { "Y", IN, DATAF, "the power" }, { "R", OUT, DATAF, "result" } } },
            { 21, "TRUNC", "Cuts off decimals without rounding",
                { { "X", IN, DATAF, "number to work on" },
                    { "P", IN, DATA8, "number of decimals to keep (at most 6 are available)", range = { 0, 9 },
                        outside = { ", outside of 0 to 9", "OUTSIDE" } },
                    { "R", OUT, DATAF, "result" } } },
        } },
    { 0x8E, "RANDOM", "Draws a random whole number",
        { { "MIN", IN, DATA16, "smallest number to draw" }, { "MAX", IN, DATA16, "largest number to draw" },
            { "VALUE", OUT, DATA16, "the number drawn, MIN to MAX, both included" } } },
    { 0x2F, "INIT_BYTES", "Fills consecutive bytes of memory with constant values",
        { { "DESTINATION", OUT, DATA8, "first byte to fill", length = "LENGTH" },
            { "LENGTH", IN, DATA32, "number of values that follow; a negative count hangs the brick", unit = "bytes" },
            { "SOURCE", IN, VALUES, "the values, one per byte", element = DATA8 } } },
    { 0x30, "MOVE8_8", "Copies a value to another variable, both 8-bit",
        { { "SOURCE", IN, DATA8, "value to copy" }, { "DESTINATION", OUT, DATA8, "copy of the value" } } },
    { 0x31, "MOVE8_16", "Converts a value, 8-bit to 16-bit; NaN stays NaN",
        { { "SOURCE", IN, DATA8, "value to copy" }, { "DESTINATION", OUT, DATA16, "copy of the value" } } },
    { 0x32, "MOVE8_32", "Converts a value, 8-bit to 32-bit; NaN stays NaN",
        { { "SOURCE", IN, DATA8, "value to copy" }, { "DESTINATION", OUT, DATA32, "copy of the value" } } },
    { 0x33, "MOVE8_F", "Converts a value, 8-bit to floating-point; NaN stays NaN",
        { { "SOURCE", IN, DATA8, "value to copy" }, { "DESTINATION", OUT, DATAF, "copy of the value" } } },
    { 0x34, "MOVE16_8", "Converts a value, 16-bit to 8-bit; limited to what fits, NaN stays NaN",
        { { "SOURCE", IN, DATA16, "value to copy" }, { "DESTINATION", OUT, DATA8, "copy of the value" } } },
    { 0x35, "MOVE16_16", "Copies a value to another variable, both 16-bit",
        { { "SOURCE", IN, DATA16, "value to copy" }, { "DESTINATION", OUT, DATA16, "copy of the value" } } },
    { 0x36, "MOVE16_32", "Converts a value, 16-bit to 32-bit; NaN stays NaN",
        { { "SOURCE", IN, DATA16, "value to copy" }, { "DESTINATION", OUT, DATA32, "copy of the value" } } },
    { 0x37, "MOVE16_F", "Converts a value, 16-bit to floating-point; NaN stays NaN",
        { { "SOURCE", IN, DATA16, "value to copy" }, { "DESTINATION", OUT, DATAF, "copy of the value" } } },
    { 0x38, "MOVE32_8", "Converts a value, 32-bit to 8-bit; limited to what fits, NaN stays NaN",
        { { "SOURCE", IN, DATA32, "value to copy" }, { "DESTINATION", OUT, DATA8, "copy of the value" } } },
    { 0x39, "MOVE32_16", "Converts a value, 32-bit to 16-bit; limited to what fits, NaN stays NaN",
        { { "SOURCE", IN, DATA32, "value to copy" }, { "DESTINATION", OUT, DATA16, "copy of the value" } } },
    { 0x3A, "MOVE32_32", "Copies a value to another variable, both 32-bit",
        { { "SOURCE", IN, DATA32, "value to copy" }, { "DESTINATION", OUT, DATA32, "copy of the value" } } },
    { 0x3B, "MOVE32_F", "Converts a value, 32-bit to floating-point; NaN stays NaN",
        { { "SOURCE", IN, DATA32, "value to copy" }, { "DESTINATION", OUT, DATAF, "copy of the value" } } },
    { 0x3C, "MOVEF_8", "Converts a value, floating-point to 8-bit; limited to what fits, NaN stays NaN",
        { { "SOURCE", IN, DATAF, "value to copy" }, { "DESTINATION", OUT, DATA8, "copy of the value" } } },
    { 0x3D, "MOVEF_16", "Converts a value, floating-point to 16-bit; limited to what fits, NaN stays NaN",
        { { "SOURCE", IN, DATAF, "value to copy" }, { "DESTINATION", OUT, DATA16, "copy of the value" } } },
    { 0x3E, "MOVEF_32", "Converts a value, floating-point to 32-bit; limited to what fits, NaN stays NaN",
        { { "SOURCE", IN, DATAF, "value to copy" }, { "DESTINATION", OUT, DATA32, "copy of the value" } } },
    { 0x3F, "MOVEF_F", "Copies a value to another variable, both floating-point",
        { { "SOURCE", IN, DATAF, "value to copy" }, { "DESTINATION", OUT, DATAF, "copy of the value" } } },
    { 0xC8, "READ8", "Reads one element of an array of 8-bit values",
        { { "SOURCE", IN, DATA8, "first element of the array, as a variable" },
            { "INDEX", IN, DATA8, "which element, counted from 0; the firmware does not check it", range = { 0, 127 },
                outside = { ", outside of 0 to 127", "OUTSIDE" } },
            { "DESTINATION", OUT, DATA8, "the element's value" } } },
    { 0xC9, "READ16", "Reads one element of an array of 16-bit values",
        { { "SOURCE", IN, DATA16, "first element of the array, as a variable" },
            { "INDEX", IN, DATA8, "which element, counted from 0; the firmware does not check it", range = { 0, 127 },
                outside = { ", outside of 0 to 127", "OUTSIDE" } },
            { "DESTINATION", OUT, DATA16, "the element's value" } } },
    { 0xCA, "READ32", "Reads one element of an array of 32-bit values",
        { { "SOURCE", IN, DATA32, "first element of the array, as a variable" },
            { "INDEX", IN, DATA8, "which element, counted from 0; the firmware does not check it", range = { 0, 127 },
                outside = { ", outside of 0 to 127", "OUTSIDE" } },
            { "DESTINATION", OUT, DATA32, "the element's value" } } },
    { 0xCB, "READF", "Reads one element of an array of floating-point values",
        { { "SOURCE", IN, DATAF, "first element of the array, as a variable" },
            { "INDEX", IN, DATA8, "which element, counted from 0; the firmware does not check it", range = { 0, 127 },
                outside = { ", outside of 0 to 127", "OUTSIDE" } },
            { "DESTINATION", OUT, DATAF, "the element's value" } } },
    { 0xCC, "WRITE8", "Writes one element of an array of 8-bit values",
        { { "SOURCE", IN, DATA8, "value to write" },
            { "INDEX", IN, DATA8, "which element, counted from 0; the firmware does not check it", range = { 0, 127 },
                outside = { ", outside of 0 to 127", "OUTSIDE" } },
            { "DESTINATION", IN, DATA8, "first element of the array, as a variable; element INDEX is written" } } },
    { 0xCD, "WRITE16", "Writes one element of an array of 16-bit values",
        { { "SOURCE", IN, DATA16, "value to write" },
            { "INDEX", IN, DATA8, "which element, counted from 0; the firmware does not check it", range = { 0, 127 },
                outside = { ", outside of 0 to 127", "OUTSIDE" } },
            { "DESTINATION", IN, DATA16, "first element of the array, as a variable; element INDEX is written" } } },
    { 0xCE, "WRITE32", "Writes one element of an array of 32-bit values",
        { { "SOURCE", IN, DATA32, "value to write" },
            { "INDEX", IN, DATA8, "which element, counted from 0; the firmware does not check it", range = { 0, 127 },
                outside = { ", outside of 0 to 127", "OUTSIDE" } },
            { "DESTINATION", IN, DATA32, "first element of the array, as a variable; element INDEX is written" } } },
    { 0xCF, "WRITEF", "Writes one element of an array of floating-point values",
        { { "SOURCE", IN, DATAF, "value to write" },
            { "INDEX", IN, DATA8, "which element, counted from 0; the firmware does not check it", range = { 0, 127 },
                outside = { ", outside of 0 to 127", "OUTSIDE" } },
            { "DESTINATION", IN, DATAF, "first element of the array, as a variable; element INDEX is written" } } },
    { 0x40, "JR", "Jumps always",
        { { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x41, "JR_FALSE", "Jumps if a flag is 0",
        { { "FLAG", IN, DATA8, "the condition: anything but 0 is true", special = { [0] = "false", [1] = "true" } },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x42, "JR_TRUE", "Jumps if a flag is not 0",
        { { "FLAG", IN, DATA8, "the condition: anything but 0 is true", special = { [0] = "false", [1] = "true" } },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x43, "JR_NAN", "Jumps if a value is not a number, as read from a sensor without data",
        { { "VALUE", IN, DATAF, "value to look at" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x64, "JR_LT8", "Jumps if LEFT is less than RIGHT, as 8-bit numbers",
        { { "LEFT", IN, DATA8, "left side of the comparison" }, { "RIGHT", IN, DATA8, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x65, "JR_LT16", "Jumps if LEFT is less than RIGHT, as 16-bit numbers",
        { { "LEFT", IN, DATA16, "left side of the comparison" }, { "RIGHT", IN, DATA16, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x66, "JR_LT32", "Jumps if LEFT is less than RIGHT, as 32-bit numbers",
        { { "LEFT", IN, DATA32, "left side of the comparison" }, { "RIGHT", IN, DATA32, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x67, "JR_LTF", "Jumps if LEFT is less than RIGHT, as floating-point numbers",
        { { "LEFT", IN, DATAF, "left side of the comparison" }, { "RIGHT", IN, DATAF, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x68, "JR_GT8", "Jumps if LEFT is greater than RIGHT, as 8-bit numbers",
        { { "LEFT", IN, DATA8, "left side of the comparison" }, { "RIGHT", IN, DATA8, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x69, "JR_GT16", "Jumps if LEFT is greater than RIGHT, as 16-bit numbers",
        { { "LEFT", IN, DATA16, "left side of the comparison" }, { "RIGHT", IN, DATA16, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x6A, "JR_GT32", "Jumps if LEFT is greater than RIGHT, as 32-bit numbers",
        { { "LEFT", IN, DATA32, "left side of the comparison" }, { "RIGHT", IN, DATA32, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x6B, "JR_GTF", "Jumps if LEFT is greater than RIGHT, as floating-point numbers",
        { { "LEFT", IN, DATAF, "left side of the comparison" }, { "RIGHT", IN, DATAF, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x6C, "JR_EQ8", "Jumps if LEFT is equal to RIGHT, as 8-bit numbers",
        { { "LEFT", IN, DATA8, "left side of the comparison" }, { "RIGHT", IN, DATA8, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x6D, "JR_EQ16", "Jumps if LEFT is equal to RIGHT, as 16-bit numbers",
        { { "LEFT", IN, DATA16, "left side of the comparison" }, { "RIGHT", IN, DATA16, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x6E, "JR_EQ32", "Jumps if LEFT is equal to RIGHT, as 32-bit numbers",
        { { "LEFT", IN, DATA32, "left side of the comparison" }, { "RIGHT", IN, DATA32, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x6F, "JR_EQF", "Jumps if LEFT is equal to RIGHT, as floating-point numbers",
        { { "LEFT", IN, DATAF, "left side of the comparison" }, { "RIGHT", IN, DATAF, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x70, "JR_NEQ8", "Jumps if LEFT is different from RIGHT, as 8-bit numbers",
        { { "LEFT", IN, DATA8, "left side of the comparison" }, { "RIGHT", IN, DATA8, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x71, "JR_NEQ16", "Jumps if LEFT is different from RIGHT, as 16-bit numbers",
        { { "LEFT", IN, DATA16, "left side of the comparison" }, { "RIGHT", IN, DATA16, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x72, "JR_NEQ32", "Jumps if LEFT is different from RIGHT, as 32-bit numbers",
        { { "LEFT", IN, DATA32, "left side of the comparison" }, { "RIGHT", IN, DATA32, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x73, "JR_NEQF", "Jumps if LEFT is different from RIGHT, as floating-point numbers",
        { { "LEFT", IN, DATAF, "left side of the comparison" }, { "RIGHT", IN, DATAF, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x74, "JR_LTEQ8", "Jumps if LEFT is less than or equal to RIGHT, as 8-bit numbers",
        { { "LEFT", IN, DATA8, "left side of the comparison" }, { "RIGHT", IN, DATA8, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x75, "JR_LTEQ16", "Jumps if LEFT is less than or equal to RIGHT, as 16-bit numbers",
        { { "LEFT", IN, DATA16, "left side of the comparison" }, { "RIGHT", IN, DATA16, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x76, "JR_LTEQ32", "Jumps if LEFT is less than or equal to RIGHT, as 32-bit numbers",
        { { "LEFT", IN, DATA32, "left side of the comparison" }, { "RIGHT", IN, DATA32, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x77, "JR_LTEQF", "Jumps if LEFT is less than or equal to RIGHT, as floating-point numbers",
        { { "LEFT", IN, DATAF, "left side of the comparison" }, { "RIGHT", IN, DATAF, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x78, "JR_GTEQ8", "Jumps if LEFT is greater than or equal to RIGHT, as 8-bit numbers",
        { { "LEFT", IN, DATA8, "left side of the comparison" }, { "RIGHT", IN, DATA8, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x79, "JR_GTEQ16", "Jumps if LEFT is greater than or equal to RIGHT, as 16-bit numbers",
        { { "LEFT", IN, DATA16, "left side of the comparison" }, { "RIGHT", IN, DATA16, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x7A, "JR_GTEQ32", "Jumps if LEFT is greater than or equal to RIGHT, as 32-bit numbers",
        { { "LEFT", IN, DATA32, "left side of the comparison" }, { "RIGHT", IN, DATA32, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x7B, "JR_GTEQF", "Jumps if LEFT is greater than or equal to RIGHT, as floating-point numbers",
        { { "LEFT", IN, DATAF, "left side of the comparison" }, { "RIGHT", IN, DATAF, "right side of the comparison" },
            { "OFFSET", IN, LABEL, "how far to jump from the end of this operation; negative jumps back; or a label", unit = "bytes" } } },
    { 0x44, "CP_LT8", "Tests whether LEFT is less than RIGHT, as 8-bit numbers",
        { { "LEFT", IN, DATA8, "left side of the comparison" }, { "RIGHT", IN, DATA8, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x45, "CP_LT16", "Tests whether LEFT is less than RIGHT, as 16-bit numbers",
        { { "LEFT", IN, DATA16, "left side of the comparison" }, { "RIGHT", IN, DATA16, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x46, "CP_LT32", "Tests whether LEFT is less than RIGHT, as 32-bit numbers",
        { { "LEFT", IN, DATA32, "left side of the comparison" }, { "RIGHT", IN, DATA32, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x47, "CP_LTF", "Tests whether LEFT is less than RIGHT, as floating-point numbers",
        { { "LEFT", IN, DATAF, "left side of the comparison" }, { "RIGHT", IN, DATAF, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x48, "CP_GT8", "Tests whether LEFT is greater than RIGHT, as 8-bit numbers",
        { { "LEFT", IN, DATA8, "left side of the comparison" }, { "RIGHT", IN, DATA8, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x49, "CP_GT16", "Tests whether LEFT is greater than RIGHT, as 16-bit numbers",
        { { "LEFT", IN, DATA16, "left side of the comparison" }, { "RIGHT", IN, DATA16, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x4A, "CP_GT32", "Tests whether LEFT is greater than RIGHT, as 32-bit numbers",
        { { "LEFT", IN, DATA32, "left side of the comparison" }, { "RIGHT", IN, DATA32, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x4B, "CP_GTF", "Tests whether LEFT is greater than RIGHT, as floating-point numbers",
        { { "LEFT", IN, DATAF, "left side of the comparison" }, { "RIGHT", IN, DATAF, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x4C, "CP_EQ8", "Tests whether LEFT is equal to RIGHT, as 8-bit numbers",
        { { "LEFT", IN, DATA8, "left side of the comparison" }, { "RIGHT", IN, DATA8, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x4D, "CP_EQ16", "Tests whether LEFT is equal to RIGHT, as 16-bit numbers",
        { { "LEFT", IN, DATA16, "left side of the comparison" }, { "RIGHT", IN, DATA16, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x4E, "CP_EQ32", "Tests whether LEFT is equal to RIGHT, as 32-bit numbers",
        { { "LEFT", IN, DATA32, "left side of the comparison" }, { "RIGHT", IN, DATA32, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x4F, "CP_EQF", "Tests whether LEFT is equal to RIGHT, as floating-point numbers",
        { { "LEFT", IN, DATAF, "left side of the comparison" }, { "RIGHT", IN, DATAF, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x50, "CP_NEQ8", "Tests whether LEFT is different from RIGHT, as 8-bit numbers",
        { { "LEFT", IN, DATA8, "left side of the comparison" }, { "RIGHT", IN, DATA8, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x51, "CP_NEQ16", "Tests whether LEFT is different from RIGHT, as 16-bit numbers",
        { { "LEFT", IN, DATA16, "left side of the comparison" }, { "RIGHT", IN, DATA16, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x52, "CP_NEQ32", "Tests whether LEFT is different from RIGHT, as 32-bit numbers",
        { { "LEFT", IN, DATA32, "left side of the comparison" }, { "RIGHT", IN, DATA32, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x53, "CP_NEQF", "Tests whether LEFT is different from RIGHT, as floating-point numbers",
        { { "LEFT", IN, DATAF, "left side of the comparison" }, { "RIGHT", IN, DATAF, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x54, "CP_LTEQ8", "Tests whether LEFT is less than or equal to RIGHT, as 8-bit numbers",
        { { "LEFT", IN, DATA8, "left side of the comparison" }, { "RIGHT", IN, DATA8, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x55, "CP_LTEQ16", "Tests whether LEFT is less than or equal to RIGHT, as 16-bit numbers",
        { { "LEFT", IN, DATA16, "left side of the comparison" }, { "RIGHT", IN, DATA16, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x56, "CP_LTEQ32", "Tests whether LEFT is less than or equal to RIGHT, as 32-bit numbers",
        { { "LEFT", IN, DATA32, "left side of the comparison" }, { "RIGHT", IN, DATA32, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x57, "CP_LTEQF", "Tests whether LEFT is less than or equal to RIGHT, as floating-point numbers",
        { { "LEFT", IN, DATAF, "left side of the comparison" }, { "RIGHT", IN, DATAF, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x58, "CP_GTEQ8", "Tests whether LEFT is greater than or equal to RIGHT, as 8-bit numbers",
        { { "LEFT", IN, DATA8, "left side of the comparison" }, { "RIGHT", IN, DATA8, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x59, "CP_GTEQ16", "Tests whether LEFT is greater than or equal to RIGHT, as 16-bit numbers",
        { { "LEFT", IN, DATA16, "left side of the comparison" }, { "RIGHT", IN, DATA16, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x5A, "CP_GTEQ32", "Tests whether LEFT is greater than or equal to RIGHT, as 32-bit numbers",
        { { "LEFT", IN, DATA32, "left side of the comparison" }, { "RIGHT", IN, DATA32, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x5B, "CP_GTEQF", "Tests whether LEFT is greater than or equal to RIGHT, as floating-point numbers",
        { { "LEFT", IN, DATAF, "left side of the comparison" }, { "RIGHT", IN, DATAF, "right side of the comparison" },
            { "FLAG", OUT, DATA8, "result of the comparison", special = { [0] = "false", [1] = "true" }, range = { 0, 1 } } } },
    { 0x5C, "SELECT8", "Selects one of two 8-bit values by a flag",
        { { "FLAG", IN, DATA8, "which one: anything but 0 selects SOURCE1", special = { [0] = "SOURCE2", [1] = "SOURCE1" } },
            { "SOURCE1", IN, DATA8, "value selected if the flag is set" }, { "SOURCE2", IN, DATA8, "value selected if the flag is 0" },
            { "RESULT", OUT, DATA8, "the selected value" } } },
    { 0x5D, "SELECT16", "Selects one of two 16-bit values by a flag",
        { { "FLAG", IN, DATA8, "which one: anything but 0 selects SOURCE1", special = { [0] = "SOURCE2", [1] = "SOURCE1" } },
            { "SOURCE1", IN, DATA16, "value selected if the flag is set" }, { "SOURCE2", IN, DATA16, "value selected if the flag is 0" },
            { "RESULT", OUT, DATA16, "the selected value" } } },
    { 0x5E, "SELECT32", "Selects one of two 32-bit values by a flag",
        { { "FLAG", IN, DATA8, "which one: anything but 0 selects SOURCE1", special = { [0] = "SOURCE2", [1] = "SOURCE1" } },
            { "SOURCE1", IN, DATA32, "value selected if the flag is set" }, { "SOURCE2", IN, DATA32, "value selected if the flag is 0" },
            { "RESULT", OUT, DATA32, "the selected value" } } },
    { 0x5F, "SELECTF", "Selects one of two floating-point values by a flag",
        { { "FLAG", IN, DATA8, "which one: anything but 0 selects SOURCE1", special = { [0] = "SOURCE2", [1] = "SOURCE1" } },
            { "SOURCE1", IN, DATAF, "value selected if the flag is set" }, { "SOURCE2", IN, DATAF, "value selected if the flag is 0" },
            { "RESULT", OUT, DATAF, "the selected value" } } },
    { 0x80, "UI_FLUSH", "Sends the contents of the terminal's output buffer", {} },
    { 0x81, "UI_READ", "Reads the state of the brick or what the terminal received",
        commands = {
            { 1, "GET_VBATT", "Reads the battery voltage", { { "VALUE", OUT, DATAF, "voltage", unit = "V" } } },
            { 2, "GET_IBATT", "Reads the battery current", { { "VALUE", OUT, DATAF, "current", unit = "A" } } },
            { 3, "GET_OS_VERS", "Reads name and version of the operating system",
                { { "LENGTH", IN, DATA8, "maximum number of bytes to return, including the zero", unit = "bytes",
                        special = { [-1] = "no limit" }, range = { 0, 127 },
                        outside = { " bytes, outside of 0 to 127 bytes or -1 (no limit)", "OUTSIDE" } },
                    { "DESTINATION", OUT, STRING, "system and kernel release, such as Linux 2.6.33-rc4", length = "LENGTH" } } },
            { 4, "GET_EVENT", "Reads and clears the pending event (used by the brick's own menus)",
                { { "EVENT", OUT, DATA8, "what happened",
                        special = { [0] = "nothing", [1] = "Bluetooth asks for a PIN", [2] = "Bluetooth asks to confirm a connection" } } } },
            { 5, "GET_TBATT", "Reads the rise in battery temperature, estimated from the current",
                { { "VALUE", OUT, DATAF, "estimated rise in temperature", unit = "°C" } } },
            { 6, "GET_IINT", "Reads the battery current smoothed over time", { { "IINT", OUT, DATAF, "integrated current", unit = "A" } } },
            { 7, "GET_IMOTOR", "Reads the current of all motors together", { { "VALUE", OUT, DATAF, "current", unit = "A" } } },
            { 8, "GET_STRING", "Waits for a line typed at the terminal and reads it",
                { { "LENGTH", IN, DATA8, "maximum number of bytes to return, not including the zero", unit = "bytes", range = { 0, 127 },
                        outside = { " bytes, outside of 0 to 127 bytes", "OUTSIDE" } },
                    { "DESTINATION", OUT, STRING, "the line", length = "LENGTH" } } },
            { 9, "GET_HW_VERS", "Reads the hardware version",
                { { "LENGTH", IN, DATA8, "maximum number of bytes to return, including the zero", unit = "bytes",
                        special = { [-1] = "no limit" }, range = { 0, 127 },
                        outside = { " bytes, outside of 0 to 127 bytes or -1 (no limit)", "OUTSIDE" } },
                    { "DESTINATION", OUT, STRING, "hardware version, such as V0.60", length = "LENGTH" } } },
            { 10, "GET_FW_VERS", "Reads the firmware version",
                { { "LENGTH", IN, DATA8, "maximum number of bytes to return, including the zero", unit = "bytes",
                        special = { [-1] = "no limit" }, range = { 0, 127 },
                        outside = { " bytes, outside of 0 to 127 bytes or -1 (no limit)", "OUTSIDE" } },
                    { "DESTINATION", OUT, STRING, "firmware version, such as V1.04H", length = "LENGTH" } } },
            { 11, "GET_FW_BUILD", "Reads the build time of the firmware",
                { { "LENGTH", IN, DATA8, "maximum number of bytes to return, including the zero", unit = "bytes",
                        special = { [-1] = "no limit" }, range = { 0, 127 },
                        outside = { " bytes, outside of 0 to 127 bytes or -1 (no limit)", "OUTSIDE" } },
                    { "DESTINATION", OUT, STRING, "build time as yymmddhhmm", length = "LENGTH" } } },
            { 12, "GET_OS_BUILD", "Reads the build time of the operating system",
                { { "LENGTH", IN, DATA8, "maximum number of bytes to return, including the zero", unit = "bytes",
                        special = { [-1] = "no limit" }, range = { 0, 127 },
                        outside = { " bytes, outside of 0 to 127 bytes or -1 (no limit)", "OUTSIDE" } },
                    { "DESTINATION", OUT, STRING, "build time as yymmddhhmm", length = "LENGTH" } } },
            { 13, "GET_ADDRESS", "Waits for a decimal number typed at the terminal and reads it (debugging)",
                { { "VALUE", OUT, DATA32, "the number, meant as an address" } } },
            { 14, "GET_CODE", "Waits for byte code typed as hex at the terminal and builds a program from it (debugging)",
                { { "LENGTH", IN, DATA32, "maximum number of bytes of the program, including headers", unit = "bytes" },
                    { "IMAGE", IN, DATA32, "address of the memory where the program is built" },
                    { "GLOBAL", OUT, DATA32, "address of the program's global variables" },
                    { "FLAG", OUT, DATA8, "whether the program can be started; 1 or unchanged", special = { [1] = "ready" } } } },
            { 15, "KEY", "Takes one key from the terminal without waiting",
                { { "VALUE", OUT, DATA8, "character code of the key", special = { [0] = "no key" } } } },
            { 16, "GET_SHUTDOWN", "Reads and clears the request to shut down (used by the brick's own menus)",
                { { "FLAG", OUT, DATA8, "whether the brick wants to shut down", special = { [0] = "no", [1] = "yes" }, range = { 0, 1 } } } },
            { 17, "GET_WARNING", "Reads the brick's warnings",
                { { "WARNINGS", OUT, DATA8, "one bit for each warning", enum = ENUMERATIONS.WARNING, special = { [0] = "none" } } } },
            { 18, "GET_LBATT", "Reads the battery level, derived from its voltage",
                { { "PCT", OUT, DATA8, "battery level", unit = "%", range = { 0, 100 } } } },
            { 21, "TEXTBOX_READ", "Reads one line of the text of a text box",
                { { "TEXT", IN, STRING, "whole text of the box, its lines separated by DEL" },
                    { "SIZE", IN, DATA32, "size of the box's text buffer, including the zero", unit = "bytes" },
                    { "DEL", IN, DATA8, "what separates the lines", enum = ENUMERATIONS.DEL, outside = { ", which is not in DEL", "NO_MEMBER" } },
                    { "LENGTH", IN, DATA8, "maximum number of bytes to return, including the zero", unit = "bytes",
                        special = { [-1] = "no limit" }, range = { 0, 127 },
                        outside = { " bytes, outside of 0 to 127 bytes or -1 (no limit)", "OUTSIDE" } },
                    { "LINE", IN, DATA16, "which line, counted from 1" },
                    { "DESTINATION", OUT, STRING, "the line, empty if there is no such line", length = "LENGTH" } } },
            { 26, "GET_VERSION", "Reads name, version and build date of the firmware in one string",
                { { "LENGTH", IN, DATA8, "maximum number of bytes to return, including the zero", unit = "bytes",
                        special = { [-1] = "no limit" }, range = { 0, 127 },
                        outside = { " bytes, outside of 0 to 127 bytes or -1 (no limit)", "OUTSIDE" } },
                    { "DESTINATION", OUT, STRING, "such as LMS2012 V1.04H(Jul 26 2013 12:00:00)", length = "LENGTH" } } },
            { 27, "GET_IP", "Reads the brick's IP address",
                { { "LENGTH", IN, DATA8, "maximum number of bytes to return, including the zero", unit = "bytes",
                        special = { [-1] = "no limit" }, range = { 0, 127 },
                        outside = { " bytes, outside of 0 to 127 bytes or -1 (no limit)", "OUTSIDE" } },
                    { "DESTINATION", OUT, STRING, "address in dotted notation", length = "LENGTH" } } },
            { 29, "GET_POWER", "Reads all values of the power supply at once",
                { { "VBATT", OUT, DATAF, "battery voltage", unit = "V" }, { "IBATT", OUT, DATAF, "battery current", unit = "A" },
                    { "IINT", OUT, DATAF, "battery current smoothed over time", unit = "A" },
                    { "IMOTOR", OUT, DATAF, "current of all motors together", unit = "A" } } },
            { 30, "GET_SDCARD", "Reads whether an SD card is present, and its space",
                { { "STATE", OUT, DATA8, "whether one is present", special = { [0] = "absent", [1] = "present" }, range = { 0, 1 } },
                    { "TOTAL", OUT, DATA32, "size", unit = "KiB" }, { "FREE", OUT, DATA32, "free space", unit = "KiB" } } },
            { 31, "GET_USBSTICK", "Reads whether a USB stick is present, and its space",
                { { "STATE", OUT, DATA8, "whether one is present", special = { [0] = "absent", [1] = "present" }, range = { 0, 1 } },
                    { "TOTAL", OUT, DATA32, "size", unit = "KiB" }, { "FREE", OUT, DATA32, "free space", unit = "KiB" } } },
        } },
    { 0x82, "UI_WRITE", "Writes to the terminal or sets lights and states of the brick",
        commands = {
            { 1, "WRITE_FLUSH", "Sends the contents of the terminal's output buffer, like UI_FLUSH", {} },
            { 2, "FLOATVALUE", "Writes a number in a fixed format to the terminal",
                { { "VALUE", IN, DATAF, "number to write" },
                    { "FIGURES", IN, DATA8, "total number of characters, including the decimal point; negative aligns left" },
                    { "DECIMALS", IN, DATA8, "digits after the decimal point" } } },
            { 3, "STAMP", "Writes time, program, object, position and a comment to the terminal", { { "VALUE", IN, STRING, "remark" } } },
            { 8, "PUT_STRING", "Writes text to the terminal", { { "STRING", IN, STRING, "text to write" } } },
            { 9, "VALUE8", "Writes a whole number to the terminal", { { "VALUE", IN, DATA8, "number to write" } } },
            { 10, "VALUE16", "Writes an unsigned whole number to the terminal",
                { { "VALUE", IN, DATA16, "number to write", range = { -32767, 65535 }, unsigned = true } } },
            { 11, "VALUE32", "Writes a whole number to the terminal", { { "VALUE", IN, DATA32, "number to write" } } },
            { 12, "VALUEF", "Writes a number to the terminal", { { "VALUE", IN, DATAF, "number to write" } } },
            { 13, "ADDRESS", "Not implemented in the firmware: the program that runs it fails",
                { { "VALUE", OUT, DATA32, "address; never written" } } },
            { 14, "CODE", "Writes bytes of memory as hex to the terminal",
                { { "ARRAY", IN, DATA32, "address of the bytes", validated = DATA8 },
                    { "LENGTH", IN, DATA32, "number of bytes", unit = "bytes" } } },
            { 15, "DOWNLOAD_END", "Plays the sound of a finished download and refreshes the file browser", {} },
            { 16, "SCREEN_BLOCK", "Blocks or unblocks the display and the buttons for programs",
                { { "STATUS", IN, DATA8, "whether drawing is ignored", special = { [0] = "normal", [1] = "blocked" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } } } },
            { 17, "ALLOW_PULSE", "Selects the debug pulses that are shown (only in debug builds of the firmware)",
                { { "VALUE", IN, DATA8, "sum of bits", special = { [1] = "menu background", [2] = "browser", [4] = "key" } } } },
            { 18, "SET_PULSE", "Raises debug pulses (only in debug builds of the firmware)",
                { { "VALUE", IN, DATA8, "sum of bits", special = { [1] = "menu background", [2] = "browser", [4] = "key" } } } },
            { 21, "TEXTBOX_APPEND", "Appends a line to the text of a text box",
                { { "TEXT", INOUT, STRING, "whole text of the box, its lines separated by DEL", length = "SIZE" },
                    { "SIZE", IN, DATA32, "size of the box's text buffer, including the zero", unit = "bytes" },
                    { "DEL", IN, DATA8, "what separates the lines", enum = ENUMERATIONS.DEL, outside = { ", which is not in DEL", "NO_MEMBER" } },
                    { "SOURCE", IN, STRING, "line to append" } } },
            { 22, "SET_BUSY", "Sets or clears the busy bit among the warnings",
                { { "VALUE", IN, DATA8, "whether the brick counts as busy", special = { [0] = "no", [1] = "yes" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } } } },
            { 24, "SET_TESTPIN", "Sets the test pin on the brick's circuit board",
                { { "STATE", IN, DATA8, "level of the pin", special = { [0] = "low", [1] = "high" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } } } },
            { 25, "INIT_RUN", "Shows the animation of a running program until something draws", {} },
            { 26, "UPDATE_RUN", "Does nothing", {} },
            { 27, "LED", "Sets colour and blinking of the light around the buttons",
                { { "PATTERN", IN, DATA8, "colour and rhythm", enum = ENUMERATIONS.LEDPATTERN,
                        outside = { ", which is not in LEDPATTERN", "NO_MEMBER" } } } },
            { 29, "POWER", "Sets the flag that makes the power driver switch off when the firmware ends",
                { { "VALUE", IN, DATA8, "the flag", range = { 0, 1 }, outside = { ", outside of 0 to 1", "OUTSIDE" } } } },
            { 30, "GRAPH_SAMPLE", "Adds the current values to the graph of GRAPH_SETUP", {} },
            { 31, "TERMINAL", "Switches the debug terminal on or off",
                { { "STATE", IN, DATA8, "whether the terminal is on", special = { [0] = "off", [1] = "on" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } } } },
        } },
    { 0x83, "UI_BUTTON", "Reads or simulates the buttons",
        commands = {
            { 1, "SHORTPRESS", "Reports whether a button was pressed since the last query, and clears the press",
                { { "BUTTON", IN, DATA8, "which button", enum = ENUMERATIONS.BUTTONTYPE,
                        outside = { ", which is not in BUTTONTYPE", "NO_MEMBER" } },
                    { "STATE", OUT, DATA8, "whether the button was pressed", special = { [0] = "no", [1] = "yes" }, range = { 0, 1 } } } },
            { 2, "LONGPRESS", "Reports whether a button was held for 3 s since the last query, and clears it",
                { { "BUTTON", IN, DATA8, "which button", enum = ENUMERATIONS.BUTTONTYPE,
                        outside = { ", which is not in BUTTONTYPE", "NO_MEMBER" } },
                    { "STATE", OUT, DATA8, "whether the button was held for 3 s", special = { [0] = "no", [1] = "yes" }, range = { 0, 1 } } } },
            { 3, "WAIT_FOR_PRESS", "Waits until any button has been pressed, by hand or by PRESS", {} },
            { 4, "FLUSH", "Clears all pending presses", {} },
            { 5, "PRESS", "Presses a button as if by hand and holds it until RELEASE",
                { { "BUTTON", IN, DATA8, "which button", enum = ENUMERATIONS.BUTTONTYPE,
                        outside = { ", which is not in BUTTONTYPE", "NO_MEMBER" } } } },
            { 6, "RELEASE", "Releases a button that PRESS holds",
                { { "BUTTON", IN, DATA8, "which button", enum = ENUMERATIONS.BUTTONTYPE,
                        outside = { ", which is not in BUTTONTYPE", "NO_MEMBER" } } } },
            { 7, "GET_HORZ", "Reads the left and right buttons as one axis, and clears their presses",
                { { "VALUE", OUT, DATA16, "direction", special = { [-1] = "left", [1] = "right", [0] = "not pressed" }, range = { -1, 1 } } } },
            { 8, "GET_VERT", "Reads the up and down buttons as one axis, and clears their presses",
                { { "VALUE", OUT, DATA16, "direction", special = { [-1] = "up", [1] = "down", [0] = "not pressed" }, range = { -1, 1 } } } },
            { 9, "PRESSED", "Reports whether a button is down at the moment",
                { { "BUTTON", IN, DATA8, "which button", enum = ENUMERATIONS.BUTTONTYPE,
                        outside = { ", which is not in BUTTONTYPE", "NO_MEMBER" } },
                    { "STATE", OUT, DATA8, "whether the button is down", special = { [0] = "no", [1] = "yes" }, range = { 0, 1 } } } },
            { 10, "SET_BACK_BLOCK", "Blocks or unblocks the back button, which ends the running program",
                { { "BLOCKED", IN, DATA8, "whether the back button is blocked", special = { [0] = "not blocked", [1] = "blocked" },
                        range = { 0, 1 }, outside = { ", outside of 0 to 1", "OUTSIDE" } } } },
            { 11, "GET_BACK_BLOCK", "Reports whether the back button is blocked",
                { { "BLOCKED", OUT, DATA8, "whether the back button is blocked", special = { [0] = "not blocked", [1] = "blocked" },
                        range = { 0, 1 } } } },
            { 12, "TESTSHORTPRESS", "Reports, like SHORTPRESS, whether a button was pressed, without clearing the press",
                { { "BUTTON", IN, DATA8, "which button", enum = ENUMERATIONS.BUTTONTYPE,
                        outside = { ", which is not in BUTTONTYPE", "NO_MEMBER" } },
                    { "STATE", OUT, DATA8, "whether the button was pressed", special = { [0] = "no", [1] = "yes" }, range = { 0, 1 } } } },
            { 13, "TESTLONGPRESS", "Reports, like LONGPRESS, whether a button was held for 3 s, without clearing it",
                { { "BUTTON", IN, DATA8, "which button", enum = ENUMERATIONS.BUTTONTYPE,
                        outside = { ", which is not in BUTTONTYPE", "NO_MEMBER" } },
                    { "STATE", OUT, DATA8, "whether the button was held for 3 s", special = { [0] = "no", [1] = "yes" }, range = { 0, 1 } } } },
            { 14, "GET_BUMBED", "Reports whether a button was pressed and released since the last query, and clears it",
                { { "BUTTON", IN, DATA8, "which button", enum = ENUMERATIONS.BUTTONTYPE,
                        outside = { ", which is not in BUTTONTYPE", "NO_MEMBER" } },
                    { "STATE", OUT, DATA8, "whether the button was pressed and released", special = { [0] = "no", [1] = "yes" },
                        range = { 0, 1 } } },
                dialects = { official = true, xtended = true } },
            { 14, "GET_BUMPED", "Reports whether a button was pressed and released since the last query, and clears it",
                { { "BUTTON", IN, DATA8, "which button", enum = ENUMERATIONS.BUTTONTYPE,
                        outside = { ", which is not in BUTTONTYPE", "NO_MEMBER" } },
                    { "STATE", OUT, DATA8, "whether the button was pressed and released", special = { [0] = "no", [1] = "yes" },
                        range = { 0, 1 } } },
                dialects = { compat = true } },
            { 15, "GET_CLICK", "Reports whether a key click is due for a handled press, and clears it",
                { { "CLICK", OUT, DATA8, "whether a click is due", special = { [0] = "no", [1] = "yes" }, range = { 0, 1 } } } },
        } },
    { 0x84, "UI_DRAW", "Draws on the canvas of the display, or runs a dialogue on it",
        commands = {
            { 0, "UPDATE", "Shows on the display what has been drawn, and restores the normal font", {} },
            { 1, "CLEAN", "Clears the canvas to white, and restores the normal font", {} },
            { 2, "PIXEL", "Draws one pixel",
                { { "COLOR", IN, DATA8, "colour to draw in", special = { [0] = "white", [1] = "black" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } },
                    { "X0", IN, DATA16, "column", unit = "px", range = { 0, 177 }, outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "row", unit = "px", range = { 0, 127 }, outside = { " px, outside of 0 to 127 px", "OUTSIDE" } } } },
            { 3, "LINE", "Draws a line between two points",
                { { "COLOR", IN, DATA8, "colour to draw in", special = { [0] = "white", [1] = "black" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } },
                    { "X0", IN, DATA16, "column of the start", unit = "px", range = { 0, 177 },
                        outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "row of the start", unit = "px", range = { 0, 127 },
                        outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "X1", IN, DATA16, "column of the end", unit = "px", range = { 0, 178 },
                        outside = { " px, outside of 0 to 178 px", "OUTSIDE" } },
                    { "Y1", IN, DATA16, "row of the end", unit = "px", range = { 0, 128 },
                        outside = { " px, outside of 0 to 128 px", "OUTSIDE" } } } },
            { 4, "CIRCLE", "Draws a circle",
                { { "COLOR", IN, DATA8, "colour to draw in", special = { [0] = "white", [1] = "black" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } },
                    { "X0", IN, DATA16, "column of the centre", unit = "px", range = { 0, 177 },
                        outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "row of the centre", unit = "px", range = { 0, 127 },
                        outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "R", IN, DATA16, "radius", unit = "px", special = { [0] = "draws nothing" } } } },
            { 5, "TEXT", "Draws text in the font chosen by SELECT_FONT",
                { { "COLOR", IN, DATA8, "colour to draw in", special = { [0] = "white", [1] = "black" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } },
                    { "X0", IN, DATA16, "left edge", unit = "px", range = { 0, 177 }, outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "top edge", unit = "px", range = { 0, 127 }, outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "STRING", IN, STRING, "text to draw" } } },
            { 6, "ICON", "Draws one of the built-in icons",
                { { "COLOR", IN, DATA8, "colour to draw in", special = { [0] = "white", [1] = "black" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } },
                    { "X0", IN, DATA16, "left edge", unit = "px", range = { 0, 177 }, outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "top edge", unit = "px", range = { 0, 127 }, outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "TYPE", IN, DATA8, "set of icons", enum = ENUMERATIONS.ICONTYPE, outside = { ", which is not in ICONTYPE", "NO_MEMBER" } },
                    { "NO", IN, DATA8, "number of the icon in its set" } } },
            { 7, "PICTURE", "Draws a picture from memory",
                { { "COLOR", IN, DATA8, "colour to draw in", special = { [0] = "white", [1] = "black" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } },
                    { "X0", IN, DATA16, "left edge", unit = "px", range = { 0, 177 }, outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "top edge", unit = "px", range = { 0, 127 }, outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "IP", IN, DATA32, "address of the picture", special = { [0] = "draws nothing" } } } },
            { 8, "VALUE", "Draws a number, or dashes where it is not a number",
                { { "COLOR", IN, DATA8, "colour to draw in", special = { [0] = "white", [1] = "black" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } },
                    { "X0", IN, DATA16, "left edge", unit = "px", range = { 0, 177 }, outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "top edge", unit = "px", range = { 0, 127 }, outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "VALUE", IN, DATAF, "number to draw" },
                    { "FIGURES", IN, DATA8, "total number of characters, including the decimal point; negative aligns left" },
                    { "DECIMALS", IN, DATA8, "digits after the decimal point" } } },
            { 9, "FILLRECT", "Draws a filled rectangle",
                { { "COLOR", IN, DATA8, "colour to draw in", special = { [0] = "white", [1] = "black" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } },
                    { "X0", IN, DATA16, "left edge", unit = "px", range = { 0, 177 }, outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "top edge", unit = "px", range = { 0, 127 }, outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "X1", IN, DATA16, "width", unit = "px", range = { 0, 178 }, outside = { " px, outside of 0 to 178 px", "OUTSIDE" } },
                    { "Y1", IN, DATA16, "height", unit = "px", range = { 0, 128 }, outside = { " px, outside of 0 to 128 px", "OUTSIDE" } } } },
            { 10, "RECT", "Draws the outline of a rectangle",
                { { "COLOR", IN, DATA8, "colour to draw in", special = { [0] = "white", [1] = "black" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } },
                    { "X0", IN, DATA16, "left edge", unit = "px", range = { 0, 177 }, outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "top edge", unit = "px", range = { 0, 127 }, outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "X1", IN, DATA16, "width", unit = "px", range = { 0, 178 }, outside = { " px, outside of 0 to 178 px", "OUTSIDE" } },
                    { "Y1", IN, DATA16, "height", unit = "px", range = { 0, 128 }, outside = { " px, outside of 0 to 128 px", "OUTSIDE" } } },
                dialects = { official = true } },
            { 10, "RECTANGLE", "Draws the outline of a rectangle",
                { { "COLOR", IN, DATA8, "colour to draw in", special = { [0] = "white", [1] = "black" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } },
                    { "X0", IN, DATA16, "left edge", unit = "px", range = { 0, 177 }, outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "top edge", unit = "px", range = { 0, 127 }, outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "X1", IN, DATA16, "width", unit = "px", range = { 0, 178 }, outside = { " px, outside of 0 to 178 px", "OUTSIDE" } },
                    { "Y1", IN, DATA16, "height", unit = "px", range = { 0, 128 }, outside = { " px, outside of 0 to 128 px", "OUTSIDE" } } },
                dialects = { xtended = true, compat = true } },
            { 11, "NOTIFICATION", "Shows icons and text in a window and waits for the centre button",
                { { "COLOR", IN, DATA8, "colour to draw in", special = { [0] = "white", [1] = "black" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } },
                    { "X0", IN, DATA16, "left edge", unit = "px", range = { 0, 177 }, outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "top edge", unit = "px", range = { 0, 127 }, outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "ICON1", IN, DATA8, "first large icon", enum = ENUMERATIONS.L_ICON_NO, special = { [-1] = "none" },
                        outside = { ", which is not in L_ICON_NO", "NO_MEMBER" } },
                    { "ICON2", IN, DATA8, "second large icon", enum = ENUMERATIONS.L_ICON_NO, special = { [-1] = "none" },
                        outside = { ", which is not in L_ICON_NO", "NO_MEMBER" } },
                    { "ICON3", IN, DATA8, "third large icon", enum = ENUMERATIONS.L_ICON_NO, special = { [-1] = "none" },
                        outside = { ", which is not in L_ICON_NO", "NO_MEMBER" } },
                    { "STRING", IN, STRING, "text beside the icons; may be empty" },
                    { "STATE", INOUT, DATA8, "variable for the dialogue's progress; must be 0 at first",
                        special = { [0] = "start, or done", [1] = "being shown" }, range = { 0, 1 } } } },
            { 12, "QUESTION", "Shows icons in a window and waits for yes or no",
                { { "COLOR", IN, DATA8, "colour to draw in", special = { [0] = "white", [1] = "black" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } },
                    { "X0", IN, DATA16, "left edge", unit = "px", range = { 0, 177 }, outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "top edge", unit = "px", range = { 0, 127 }, outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "ICON1", IN, DATA8, "first large icon", enum = ENUMERATIONS.L_ICON_NO, special = { [-1] = "none" },
                        outside = { ", which is not in L_ICON_NO", "NO_MEMBER" } },
                    { "ICON2", IN, DATA8, "second large icon", enum = ENUMERATIONS.L_ICON_NO, special = { [-1] = "none" },
                        outside = { ", which is not in L_ICON_NO", "NO_MEMBER" } },
                    { "STRING", IN, STRING, "text of the question (LEGO's firmware does not show it)" },
                    { "STATE", INOUT, DATA8, "variable for the dialogue's progress; must be 0 at first",
                        special = { [0] = "start, or done", [1] = "being shown" }, range = { 0, 1 } },
                    { "OK", OUT, DATA8, "answer; the variable's previous value is selected at first",
                        special = { [0] = "no", [1] = "yes", [-1] = "closed with the back button" }, range = { -1, 1 } } } },
            { 13, "KEYBOARD", "Shows a keyboard on the display and waits until a text has been entered",
                { { "COLOR", IN, DATA8, "colour to draw in", special = { [0] = "white", [1] = "black" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } },
                    { "X0", IN, DATA16, "left edge", unit = "px", range = { 0, 177 }, outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "top edge", unit = "px", range = { 0, 127 }, outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "ICON", IN, DATA8, "normal icon before the caption", enum = ENUMERATIONS.N_ICON_NO,
                        outside = { ", which is not in N_ICON_NO", "NO_MEMBER" } },
                    { "LENGTH", IN, DATA8, "maximum number of bytes to return, including the zero", unit = "bytes", range = { 0, 127 },
                        outside = { " bytes, outside of 0 to 127 bytes", "OUTSIDE" } },
                    { "DEFAULT", IN, STRING, "caption above the text, not a preset as its name says", special = { [0] = "none" } },
                    { "CHARSET", INOUT, DATA8, "variable with the sum of the allowed kinds of text; becomes 0 once the keyboard is shown",
                        special = { [0] = "being shown", [1] = "brick name", [2] = "file name", [4] = "Bluetooth PIN", [8] = "WiFi password",
                            [16] = "WiFi name" } },
                    { "STRING", OUT, STRING, "entered text; the variable's previous text is edited, the back button empties it",
                        length = "LENGTH" } } },
            { 14, "BROWSE", "Shows files and folders and waits until one is chosen",
                { { "TYPE", IN, DATA8, "what to list", enum = ENUMERATIONS.BROWSERTYPE,
                        outside = { ", which is not in BROWSERTYPE", "NO_MEMBER" } },
                    { "X0", IN, DATA16, "left edge", unit = "px", range = { 0, 177 }, outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "top edge", unit = "px", range = { 0, 127 }, outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "X1", IN, DATA16, "width", unit = "px", range = { 0, 178 }, outside = { " px, outside of 0 to 178 px", "OUTSIDE" } },
                    { "Y1", IN, DATA16, "height", unit = "px", range = { 0, 128 }, outside = { " px, outside of 0 to 128 px", "OUTSIDE" } },
                    { "LENGTH", IN, DATA8, "maximum number of bytes to return, including the zero", unit = "bytes", range = { 0, 127 },
                        outside = { " bytes, outside of 0 to 127 bytes", "OUTSIDE" } },
                    { "ITEM_TYPE", OUT, DATA8, "kind of the chosen entry; the variable must be 0 at first", enum = ENUMERATIONS.FILETYPE },
                    { "STRING", OUT, STRING, "path of the chosen entry; set the variable to the top folder first", length = "LENGTH" } } },
            { 15, "VERTBAR", "Draws a vertical scroll bar",
                { { "COLOR", IN, DATA8, "colour to draw in", special = { [0] = "white", [1] = "black" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } },
                    { "X0", IN, DATA16, "left edge", unit = "px", range = { 0, 177 }, outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "top edge", unit = "px", range = { 0, 127 }, outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "X1", IN, DATA16, "width", unit = "px", range = { 0, 178 }, outside = { " px, outside of 0 to 178 px", "OUTSIDE" } },
                    { "Y1", IN, DATA16, "height", unit = "px", range = { 0, 128 }, outside = { " px, outside of 0 to 128 px", "OUTSIDE" } },
                    { "MIN", IN, DATA16, "value at one end of the bar" }, { "MAX", IN, DATA16, "value at the other end of the bar" },
                    { "ACT", IN, DATA16, "value that the knob shows" } } },
            { 16, "INVERSERECT", "Swaps black and white in a rectangle",
                { { "X0", IN, DATA16, "left edge", unit = "px", range = { 0, 177 }, outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "top edge", unit = "px", range = { 0, 127 }, outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "X1", IN, DATA16, "width", unit = "px", range = { 0, 178 }, outside = { " px, outside of 0 to 178 px", "OUTSIDE" } },
                    { "Y1", IN, DATA16, "height", unit = "px", range = { 0, 128 }, outside = { " px, outside of 0 to 128 px", "OUTSIDE" } } } },
            { 17, "SELECT_FONT", "Chooses the font for text, until UPDATE, CLEAN or FILLWINDOW",
                { { "TYPE", IN, DATA8, "font", enum = ENUMERATIONS.FONTTYPE, range = { 0, 3 }, is_ranged = true,
                        outside = { ", outside of 0 to 3", "OUTSIDE" } } } },
            { 18, "TOPLINE", "Switches the status line at the top on or off",
                { { "ENABLE", IN, DATA8, "whether the status line is shown", special = { [0] = "disabled", [1] = "enabled" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } } } },
            { 19, "FILLWINDOW", "Fills rows over the whole width, and restores the normal font",
                { { "COLOR", IN, DATA8, "colour to fill with; any other value makes a test pattern",
                        special = { [0] = "white", [1] = "black" } },
                    { "Y0", IN, DATA16, "top edge", unit = "px", range = { 0, 127 }, outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "Y1", IN, DATA16, "height; nothing is filled if Y0 plus it is 128 or more", unit = "px",
                        special = { [0] = "down to the bottom" }, range = { 0, 127 }, outside = { " px, outside of 0 to 127 px", "OUTSIDE" } } } },
            { 20, "SCROLL", "Moves the canvas up",
                { { "Y", IN, DATA16, "distance", unit = "px", range = { 1, 127 }, outside = { " px, outside of 1 to 127 px", "OUTSIDE" } } } },
            { 21, "DOTLINE", "Draws a dashed line between two points",
                { { "COLOR", IN, DATA8, "colour to draw in", special = { [0] = "white", [1] = "black" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } },
                    { "X0", IN, DATA16, "column of the start", unit = "px", range = { 0, 177 },
                        outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "row of the start", unit = "px", range = { 0, 127 },
                        outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "X1", IN, DATA16, "column of the end", unit = "px", range = { 0, 178 },
                        outside = { " px, outside of 0 to 178 px", "OUTSIDE" } },
                    { "Y1", IN, DATA16, "row of the end", unit = "px", range = { 0, 128 },
                        outside = { " px, outside of 0 to 128 px", "OUTSIDE" } },
                    { "ON", IN, DATA16, "length of a dash", unit = "px" }, { "OFF", IN, DATA16, "length of a gap", unit = "px" } } },
            { 22, "VIEW_VALUE", "Draws a number centred in its place, or > instead of digits if it does not fit",
                { { "COLOR", IN, DATA8, "colour to draw in", special = { [0] = "white", [1] = "black" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } },
                    { "X0", IN, DATA16, "left edge", unit = "px", range = { 0, 177 }, outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "top edge", unit = "px", range = { 0, 127 }, outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "VALUE", IN, DATAF, "number to draw" }, { "FIGURES", IN, DATA8, "total number of characters, including the decimal point" },
                    { "DECIMALS", IN, DATA8, "digits after the decimal point" } } },
            { 23, "VIEW_UNIT", "Draws a number in large figures and its unit in small letters",
                { { "COLOR", IN, DATA8, "colour to draw in", special = { [0] = "white", [1] = "black" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } },
                    { "X0", IN, DATA16, "left edge", unit = "px", range = { 0, 177 }, outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "top edge", unit = "px", range = { 0, 127 }, outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "VALUE", IN, DATAF, "number to draw" }, { "FIGURES", IN, DATA8, "total number of characters, including the decimal point" },
                    { "DECIMALS", IN, DATA8, "digits after the decimal point" },
                    { "LENGTH", IN, DATA8, "maximum number of bytes of the unit, including the zero", unit = "bytes", range = { 0, 127 },
                        outside = { " bytes, outside of 0 to 127 bytes", "OUTSIDE" } },
                    { "STRING", IN, STRING, "unit to draw after the number" } } },
            { 24, "FILLCIRCLE", "Draws a filled circle",
                { { "COLOR", IN, DATA8, "colour to draw in", special = { [0] = "white", [1] = "black" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } },
                    { "X0", IN, DATA16, "column of the centre", unit = "px", range = { 0, 177 },
                        outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "row of the centre", unit = "px", range = { 0, 127 },
                        outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "R", IN, DATA16, "radius", unit = "px", special = { [0] = "draws nothing" } } } },
            { 25, "STORE", "Keeps a copy of the canvas",
                { { "NO", IN, DATA8, "slot for one screen; 0 holds the screen from before the program ran", range = { 0, 2 },
                        outside = { ", outside of 0 to 2", "OUTSIDE" } } } },
            { 26, "RESTORE", "Restores a canvas kept by STORE",
                { { "NO", IN, DATA8, "slot for one screen; 0 holds the screen from before the program ran", range = { 0, 2 },
                        outside = { ", outside of 0 to 2", "OUTSIDE" } } } },
            { 27, "ICON_QUESTION", "Shows a row of icons and waits until one is chosen",
                { { "COLOR", IN, DATA8, "colour to draw in", special = { [0] = "white", [1] = "black" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } },
                    { "X0", IN, DATA16, "left edge", unit = "px", range = { 0, 177 }, outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "top edge", unit = "px", range = { 0, 127 }, outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "STATE", INOUT, DATA8, "variable for the dialogue's progress; must be 0 at first",
                        special = { [0] = "start, or done", [1] = "being shown" }, range = { 0, 1 } },
                    { "ICONS", INOUT, DATA32, "bit n is large icon n: first the icons to show, then the chosen one",
                        special = { [0] = "none: closed with the back button" } } } },
            { 28, "BMPFILE", "Draws a picture file in LEGO's own format .rgf (no .bmp despite the name)",
                { { "COLOR", IN, DATA8, "colour of the set pixels", special = { [0] = "white, picture inverted", [1] = "black" },
                        range = { 0, 1 }, outside = { ", outside of 0 to 1", "OUTSIDE" } },
                    { "X0", IN, DATA16, "left edge", unit = "px", range = { 0, 177 }, outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "top edge", unit = "px", range = { 0, 127 }, outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "NAME", IN, STRING, "file with extension .rgf, absolute or relative to /home/root/lms2012/sys", most = 119 } } },
            { 29, "POPUP", "Opens a window that only its opener can draw on, or closes it and restores the display",
                { { "OPEN", IN, DATA8, "action", special = { [0] = "close", [1] = "open" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } } } },
            { 30, "GRAPH_SETUP", "Sets up a graph of up to 8 curves; useless in direct commands, since the arrays must outlive it",
                { { "X0", IN, DATA16, "left edge", unit = "px", range = { 0, 177 }, outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "X1", IN, DATA16, "width", unit = "px", range = { 0, 178 }, outside = { " px, outside of 0 to 178 px", "OUTSIDE" } },
                    { "ITEMS", IN, DATA8, "number of curves", range = { 0, 8 }, outside = { ", outside of 0 to 8", "OUTSIDE" },
                        validated = DATA16 },
                    { "OFFSET", IN, DATA16, "top edge of each curve", unit = "px", range = { 0, 127 },
                        outside = { " px, outside of 0 to 127 px", "OUTSIDE" }, length = "ITEMS" },
                    { "SPAN", IN, DATA16, "height of each curve", unit = "px", range = { 0, 128 },
                        outside = { " px, outside of 0 to 128 px", "OUTSIDE" }, length = "ITEMS", validated = DATA8 },
                    { "MIN", IN, DATAF, "value at the bottom of each curve", length = "ITEMS", validated = DATA16 },
                    { "MAX", IN, DATAF, "value at the top of each curve", length = "ITEMS", validated = DATA16 },
                    { "SAMPLE", IN, DATAF, "current value of each curve, read again at each GRAPH_SAMPLE", length = "ITEMS", validated = DATA16 } } },
            { 31, "GRAPH_DRAW", "Draws the graph and measures the curve it shows",
                { { "VIEW", IN, DATA8, "curve to draw, counted from 0; any other value draws all and measures none",
                        special = { [-1] = "all" } },
                    { "ACTUAL", OUT, DATAF, "latest value, NaN if there is none" }, { "LOWEST", OUT, DATAF, "lowest value in the graph" },
                    { "HIGHEST", OUT, DATAF, "highest value in the graph" }, { "AVERAGE", OUT, DATAF, "mean of the values in the graph" } } },
            { 32, "TEXTBOX", "Shows a text with a scroll bar and waits until a line is chosen",
                { { "X0", IN, DATA16, "left edge", unit = "px", range = { 0, 177 }, outside = { " px, outside of 0 to 177 px", "OUTSIDE" } },
                    { "Y0", IN, DATA16, "top edge", unit = "px", range = { 0, 127 }, outside = { " px, outside of 0 to 127 px", "OUTSIDE" } },
                    { "X1", IN, DATA16, "width", unit = "px", range = { 0, 178 }, outside = { " px, outside of 0 to 178 px", "OUTSIDE" } },
                    { "Y1", IN, DATA16, "height", unit = "px", range = { 0, 128 }, outside = { " px, outside of 0 to 128 px", "OUTSIDE" } },
                    { "TEXT", IN, STRING, "whole text of the box, its lines separated by DEL" },
                    { "SIZE", IN, DATA32, "size of the box's text buffer, including the zero", unit = "bytes" },
                    { "DEL", IN, DATA8, "what separates the lines", enum = ENUMERATIONS.DEL, outside = { ", which is not in DEL", "NO_MEMBER" } },
                    { "LINE", INOUT, DATA16, "variable, must be -1 at first; then the chosen line, counted from 1",
                        special = { [-1] = "start, or closed with the back button", [0] = "being shown" }, validated = DATA8 } } },
        } },
    { 0x90, "KEEP_ALIVE", "Restarts the timer that switches off an idle brick, and reads its time",
        { { "MINUTES", OUT, DATA8, "idle time before switching off", unit = "min", special = { [0] = "never" } } } },
    { 0x85, "TIMER_WAIT", "Stores the end of a wait and returns at once; TIMER_READY does the waiting",
        { { "TIME", IN, DATA32, "duration of the wait", unit = "ms", range = { 0, 2147483647 },
                outside = { " ms, outside of 0 to 2147483647 ms", "OUTSIDE" } },
            { "TIMER", OUT, DATA32, "variable that gets the end of the wait, on the brick's millisecond clock" } } },
    { 0x86, "TIMER_READY", "Waits until the time that TIMER_WAIT stored", { { "TIMER", IN, DATA32, "variable that TIMER_WAIT has set" } } },
    { 0x87, "TIMER_READ", "Reads the time since the start of the program or direct command that asks",
        { { "TIME", OUT, DATA32, "time since the start", unit = "ms" } } },
    { 0x8F, "TIMER_READ_US", "Reads the free-running microsecond clock, for differences only",
        { { "TIME", OUT, DATA32, "low 32 bits of the clock, wraps every 71.6 minutes", unit = "us" } } },
    { 0x94, "SOUND", "Plays or stops a sound",
        commands = {
            { 0, "BREAK", "Stops the tone or file that is playing", {} },
            { 1, "TONE", "Plays one tone and returns at once",
                { { "VOLUME", IN, DATA8, "volume", unit = "%", special = { [0] = "silent" }, range = { 0, 100 },
                        outside = { " %, outside of 0 to 100 %", "OUTSIDE" } },
                    { "FREQUENCY", IN, DATA16, "pitch; the driver clamps it to the range", unit = "Hz", range = { 250, 10000 },
                        outside = { " Hz, outside of 250 to 10000 Hz", "OUTSIDE" } },
                    { "DURATION", IN, DATA16, "duration, read unsigned (-1 is 65535)", unit = "ms",
                        special = { [0] = "until BREAK or the next sound" }, range = { -32767, 65535 }, unsigned = true } } },
            { 2, "PLAY", "Plays a sound file once and returns at once",
                { { "VOLUME", IN, DATA8, "volume", unit = "%", special = { [0] = "silent" }, range = { 0, 100 },
                        outside = { " %, outside of 0 to 100 %", "OUTSIDE" } },
                    { "NAME", IN, STRING, "sound file without its extension .rsf, absolute or relative to /home/root/lms2012/sys", most = 119 } } },
            { 3, "REPEAT", "Plays a sound file over and over until BREAK and returns at once",
                { { "VOLUME", IN, DATA8, "volume", unit = "%", special = { [0] = "silent" }, range = { 0, 100 },
                        outside = { " %, outside of 0 to 100 %", "OUTSIDE" } },
                    { "NAME", IN, STRING, "sound file without its extension .rsf, absolute or relative to /home/root/lms2012/sys", most = 119 } } },
            { 4, "SERVICE", "Does nothing; the number is used inside the firmware to feed the sound driver", {} },
        } },
    { 0x95, "SOUND_TEST", "Reports whether a sound is playing",
        { { "BUSY", OUT, DATA8, "whether a sound is playing", special = { [0] = "ready", [1] = "busy" }, range = { 0, 1 } } } },
    { 0x96, "SOUND_READY", "Waits until the sound has ended (forever after REPEAT, an endless tone or a missing file)", {} },
    { 0x97, "INPUT_SAMPLE", "Reads one SI value of each of several devices, sampled in the background",
        { { "TIME", IN, DATA32, "time between two samples", unit = "ms" }, { "SAMPLES", IN, DATA16, "number of devices the arrays list" },
            { "INIT", IN, DATA16, "place in the sample buffer of each device, -1 starts it anew", length = "SAMPLES" },
            { "DEVICES", IN, DATA8, "ports, 0 to 3 for sensors, 4 to 7 for motors A to D", length = "SAMPLES" },
            { "TYPES", IN, DATA8, "type to set for each device", enum = ENUMERATIONS.TYPE, range = { 50, 98 },
                outside = { ", which is not in TYPE", "NO_MEMBER" }, length = "SAMPLES" },
            { "MODES", IN, DATA8, "mode to set for each device", length = "SAMPLES" },
            { "DATASETS", IN, DATA8, "index of the value to read from each device, from 0", length = "SAMPLES" },
            { "VALUES", OUT, DATAF, "one value per device, NaN if there is none", length = "SAMPLES" } } },
    { 0x98, "INPUT_DEVICE_LIST", "Lists the types of all devices, sensor ports of each layer first, then motor ports",
        { { "LENGTH", IN, DATA8, "size of the array; 32 holds the whole daisy chain", range = { 0, 127 },
                outside = { ", outside of 0 to 127", "OUTSIDE" } },
            { "ARRAY", OUT, DATA8, "type of device at each port", enum = ENUMERATIONS.TYPE, range = { 50, 98 }, length = "LENGTH" },
            { "CHANGED", OUT, DATA8, "whether devices came or went since the last call", special = { [0] = "no change" } } } },
    { 0x99, "INPUT_DEVICE", "Asks about devices, calibrates them, reads several values",
        commands = {
            { 1, "INSERT_TYPE", "Adds a line to the table of device types, for third party types (50 to 98) only",
                { { "TYPEDATA", IN, STRING, "the line as in typedata.rcf, starting with the type's number" },
                    { "FORCE", IN, DATA8, "whether to replace a known type",
                        special = { [0] = "refuse a known type", [1] = "replace a known type" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } },
                    { "ERROR", OUT, DATA8, "whether it failed", special = { [0] = "done", [1] = "failed or known" }, range = { 0, 1 } } } },
            { 2, "GET_FORMAT", "Describes the values of a device in its current mode",
                { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                        outside = { ", outside of 0 to 3", "OUTSIDE" } },
                    { "NO", IN, DATA8, "port, counted from 0; 16 to 19 for motors", label = "Port",
                        special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4", [16] = "motor port A", [17] = "motor port B",
                            [18] = "motor port C", [19] = "motor port D" },
                        range = { 0, 19 }, outside = { ", outside of 0 to 19", "OUTSIDE" } },
                    { "DATASETS", OUT, DATA8, "number of values in one reading" },
                    { "FORMAT", OUT, DATA8, "type of one raw value", enum = ENUMERATIONS.DATA_FORMAT, range = { 0, 3 }, is_ranged = true },
                    { "MODES", OUT, DATA8, "number of modes of the device", range = { 1, 8 } },
                    { "VIEWS", OUT, DATA8, "number of modes shown to users", range = { 1, 8 } } } },
            { 3, "CAL_MINMAX", "Sets the raw values that scale a type and mode to percent and SI",
                { { "TYPE", IN, DATA8, "type of device the calibration is for", enum = ENUMERATIONS.TYPE, range = { 50, 98 },
                        outside = { ", which is not in TYPE", "NO_MEMBER" } },
                    { "MODE", IN, DATA8, "mode the calibration is for", range = { 0, 7 }, outside = { ", outside of 0 to 7", "OUTSIDE" } },
                    { "CAL_MIN", IN, DATA32, "raw value at the lower end" }, { "CAL_MAX", IN, DATA32, "raw value at full scale" } } },
            { 4, "CAL_DEFAULT", "Restores the built-in scaling of a type and mode",
                { { "TYPE", IN, DATA8, "type of device the calibration is for", enum = ENUMERATIONS.TYPE, range = { 50, 98 },
                        outside = { ", which is not in TYPE", "NO_MEMBER" } },
                    { "MODE", IN, DATA8, "mode the calibration is for", range = { 0, 7 }, outside = { ", outside of 0 to 7", "OUTSIDE" } } } },
            { 5, "GET_TYPEMODE", "Reports the device at a port and its mode",
                { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                        outside = { ", outside of 0 to 3", "OUTSIDE" } },
                    { "NO", IN, DATA8, "port, counted from 0; 16 to 19 for motors", label = "Port",
                        special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4", [16] = "motor port A", [17] = "motor port B",
                            [18] = "motor port C", [19] = "motor port D" },
                        range = { 0, 19 }, outside = { ", outside of 0 to 19", "OUTSIDE" } },
                    { "TYPE", OUT, DATA8, "type of the device", enum = ENUMERATIONS.TYPE, range = { 50, 98 } },
                    { "MODE", OUT, DATA8, "mode the device is in", range = { 0, 7 } } } },
            { 6, "GET_SYMBOL", "Reads the symbol of the unit of the current mode",
                { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                        outside = { ", outside of 0 to 3", "OUTSIDE" } },
                    { "NO", IN, DATA8, "port, counted from 0; 16 to 19 for motors", label = "Port",
                        special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4", [16] = "motor port A", [17] = "motor port B",
                            [18] = "motor port C", [19] = "motor port D" },
                        range = { 0, 19 }, outside = { ", outside of 0 to 19", "OUTSIDE" } },
                    { "LENGTH", IN, DATA8, "size of the text buffer, including the zero", unit = "bytes",
                        special = { [-1] = "unlimited (handles only)" } },
                    { "DESTINATION", OUT, STRING, "symbol, padded with blanks", length = "LENGTH" } } },
            { 7, "CAL_MIN", "Sets the lower end of the scaling of a type and mode",
                { { "TYPE", IN, DATA8, "type of device the calibration is for", enum = ENUMERATIONS.TYPE, range = { 50, 98 },
                        outside = { ", which is not in TYPE", "NO_MEMBER" } },
                    { "MODE", IN, DATA8, "mode the calibration is for", range = { 0, 7 }, outside = { ", outside of 0 to 7", "OUTSIDE" } },
                    { "CAL_MIN", IN, DATA32, "value at the lower end, in SI units once calibrated" } } },
            { 8, "CAL_MAX", "Sets the full scale of a type and mode",
                { { "TYPE", IN, DATA8, "type of device the calibration is for", enum = ENUMERATIONS.TYPE, range = { 50, 98 },
                        outside = { ", which is not in TYPE", "NO_MEMBER" } },
                    { "MODE", IN, DATA8, "mode the calibration is for", range = { 0, 7 }, outside = { ", outside of 0 to 7", "OUTSIDE" } },
                    { "CAL_MAX", IN, DATA32, "value at full scale, in SI units once calibrated" } } },
            { 9, "SETUP", "Writes to an I2C sensor and reads its answer, repeatedly if requested",
                { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                        outside = { ", outside of 0 to 3", "OUTSIDE" } },
                    { "NO", IN, DATA8, "sensor port, counted from 0", label = "Port",
                        special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4" }, range = { 0, 3 },
                        outside = { ", outside of 0 to 3", "OUTSIDE" } },
                    { "REPEAT", IN, DATA8, "number of repeats", special = { [0] = "endless" } },
                    { "TIME", IN, DATA16, "time between repeats", unit = "ms", special = { [0] = "10 ms" }, range = { 10, 1000 },
                        outside = { " ms, outside of 10 to 1000 ms or 0 (10 ms)", "OUTSIDE" } },
                    { "WRITE_LEN", IN, DATA8, "number of bytes to write", unit = "bytes", range = { 0, 32 },
                        outside = { " bytes, outside of 0 to 32 bytes", "OUTSIDE" } },
                    { "WRITE_DATA", IN, DATA8, "bytes to write: I2C address, register, data", length = "WRITE_LEN" },
                    { "READ_LEN", IN, DATA8, "number of bytes to read, negative: in reverse order", unit = "bytes", range = { -32, 32 },
                        outside = { " bytes, outside of -32 to 32 bytes", "OUTSIDE" } },
                    { "READ_DATA", OUT, DATA8, "bytes read", length = "READ_LEN" } } },
            { 10, "CLR_ALL", "Clears counters and angles of all devices",
                { { "LAYER", IN, DATA8, "brick in the daisy chain", label = "Daisy chain", special = { [-1] = "all layers" }, range = { 0, 3 },
                        outside = { ", outside of 0 to 3 or -1 (all layers)", "OUTSIDE" } } } },
            { 11, "GET_RAW", "Reads the first raw value of a device",
                { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                        outside = { ", outside of 0 to 3", "OUTSIDE" } },
                    { "NO", IN, DATA8, "port, counted from 0; 16 to 19 for motors", label = "Port",
                        special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4", [16] = "motor port A", [17] = "motor port B",
                            [18] = "motor port C", [19] = "motor port D" },
                        range = { 0, 19 }, outside = { ", outside of 0 to 19", "OUTSIDE" } },
                    { "VALUE", OUT, DATA32, "raw value, NaN if there is none" } } },
            { 12, "GET_CONNECTION", "Reports how the device at a port is connected",
                { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                        outside = { ", outside of 0 to 3", "OUTSIDE" } },
                    { "NO", IN, DATA8, "port, counted from 0; 16 to 19 for motors", label = "Port",
                        special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4", [16] = "motor port A", [17] = "motor port B",
                            [18] = "motor port C", [19] = "motor port D" },
                        range = { 0, 19 }, outside = { ", outside of 0 to 19", "OUTSIDE" } },
                    { "CONN", OUT, DATA8, "kind of connection", enum = ENUMERATIONS.CONN } } },
            { 13, "STOP_ALL", "Stops all devices, motors among them",
                { { "LAYER", IN, DATA8, "brick in the daisy chain", label = "Daisy chain", special = { [-1] = "all layers" }, range = { 0, 3 },
                        outside = { ", outside of 0 to 3 or -1 (all layers)", "OUTSIDE" } } } },
            { 14, "SET_TYPEMODE", "Renumbers an entry of the table of device types, third party types only",
                { { "TYPE", IN, DATA8, "type of the entry", enum = ENUMERATIONS.TYPE, range = { 50, 98 }, is_ranged = true,
                        outside = { ", outside of 50 to 98", "OUTSIDE" } },
                    { "MODE", IN, DATA8, "mode of the entry", range = { 0, 7 }, outside = { ", outside of 0 to 7", "OUTSIDE" } },
                    { "NEWTYPE", IN, DATA8, "new type of the entry", enum = ENUMERATIONS.TYPE, range = { 50, 98 }, is_ranged = true,
                        outside = { ", outside of 50 to 98", "OUTSIDE" } },
                    { "NEWMODE", IN, DATA8, "new mode of the entry", range = { 0, 7 }, outside = { ", outside of 0 to 7", "OUTSIDE" } },
                    { "ERROR", OUT, DATA8, "whether it failed", special = { [0] = "done", [1] = "failed or not found" }, range = { 0, 1 } } } },
            { 15, "READY_IIC", "Writes to an I2C sensor once, waits for its answer and reports the result",
                { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                        outside = { ", outside of 0 to 3", "OUTSIDE" } },
                    { "NO", IN, DATA8, "sensor port, counted from 0", label = "Port",
                        special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4" }, range = { 0, 3 },
                        outside = { ", outside of 0 to 3", "OUTSIDE" } },
                    { "WRLNG", IN, DATA8, "number of bytes to write", unit = "bytes", range = { 0, 32 },
                        outside = { " bytes, outside of 0 to 32 bytes", "OUTSIDE" } },
                    { "WRDATA", IN, DATA8, "bytes to write: I2C address, register, data", length = "WRLNG" },
                    { "RDLNG", IN, DATA8, "number of bytes to read, negative: in reverse order", unit = "bytes", range = { -32, 32 },
                        outside = { " bytes, outside of -32 to 32 bytes", "OUTSIDE" } },
                    { "RDDATA", OUT, DATA8, "bytes read", length = "RDLNG" },
                    { "RESULT", OUT, DATA8, "how the transfer ended", enum = ENUMERATIONS.RESULT } } },
            { 21, "GET_NAME", "Reads the name of a device in its current mode, such as TOUCH or COL-REFLECT",
                { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                        outside = { ", outside of 0 to 3", "OUTSIDE" } },
                    { "NO", IN, DATA8, "port, counted from 0; 16 to 19 for motors", label = "Port",
                        special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4", [16] = "motor port A", [17] = "motor port B",
                            [18] = "motor port C", [19] = "motor port D" },
                        range = { 0, 19 }, outside = { ", outside of 0 to 19", "OUTSIDE" } },
                    { "LENGTH", IN, DATA8, "size of the text buffer, including the zero", unit = "bytes",
                        special = { [-1] = "unlimited (handles only)" } },
                    { "DESTINATION", OUT, STRING, "name, padded with blanks", length = "LENGTH" } } },
            { 22, "GET_MODENAME", "Reads the name of any mode of a device",
                { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                        outside = { ", outside of 0 to 3", "OUTSIDE" } },
                    { "NO", IN, DATA8, "port, counted from 0; 16 to 19 for motors", label = "Port",
                        special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4", [16] = "motor port A", [17] = "motor port B",
                            [18] = "motor port C", [19] = "motor port D" },
                        range = { 0, 19 }, outside = { ", outside of 0 to 19", "OUTSIDE" } },
                    { "MODE", IN, DATA8, "mode to name", range = { 0, 7 }, outside = { ", outside of 0 to 7", "OUTSIDE" } },
                    { "LENGTH", IN, DATA8, "size of the text buffer, including the zero", unit = "bytes",
                        special = { [-1] = "unlimited (handles only)" } },
                    { "DESTINATION", OUT, STRING, "name, padded with blanks", length = "LENGTH" } } },
            { 23, "SET_RAW", "Simulates a raw value of a device",
                { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                        outside = { ", outside of 0 to 3", "OUTSIDE" } },
                    { "NO", IN, DATA8, "port, counted from 0; 16 to 19 for motors", label = "Port",
                        special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4", [16] = "motor port A", [17] = "motor port B",
                            [18] = "motor port C", [19] = "motor port D" },
                        range = { 0, 19 }, outside = { ", outside of 0 to 19", "OUTSIDE" } },
                    { "TYPE", IN, DATA8, "type to set", enum = ENUMERATIONS.TYPE, special = { [0] = "keep the type" }, range = { 50, 98 },
                        outside = { ", which is not in TYPE", "NO_MEMBER" } },
                    { "VALUE", IN, DATA32, "raw value to simulate" } } },
            { 24, "GET_FIGURES", "Reports the number of digits that a value of the current mode needs",
                { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                        outside = { ", outside of 0 to 3", "OUTSIDE" } },
                    { "NO", IN, DATA8, "port, counted from 0; 16 to 19 for motors", label = "Port",
                        special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4", [16] = "motor port A", [17] = "motor port B",
                            [18] = "motor port C", [19] = "motor port D" },
                        range = { 0, 19 }, outside = { ", outside of 0 to 19", "OUTSIDE" } },
                    { "FIGURES", OUT, DATA8, "total number of characters, with point and decimals" },
                    { "DECIMALS", OUT, DATA8, "digits after the point" } } },
            { 25, "GET_CHANGES", "Reads how often a touch sensor changed to pressed since CLR_CHANGES",
                { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                        outside = { ", outside of 0 to 3", "OUTSIDE" } },
                    { "NO", IN, DATA8, "port, counted from 0; 16 to 19 for motors", label = "Port",
                        special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4", [16] = "motor port A", [17] = "motor port B",
                            [18] = "motor port C", [19] = "motor port D" },
                        range = { 0, 19 }, outside = { ", outside of 0 to 19", "OUTSIDE" } },
                    { "VALUE", OUT, DATAF, "number of changes, 0 for other sensors" } } },
            { 26, "CLR_CHANGES", "Sets the counts of GET_CHANGES and GET_BUMPS to zero",
                { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                        outside = { ", outside of 0 to 3", "OUTSIDE" } },
                    { "NO", IN, DATA8, "port, counted from 0; 16 to 19 for motors", label = "Port",
                        special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4", [16] = "motor port A", [17] = "motor port B",
                            [18] = "motor port C", [19] = "motor port D" },
                        range = { 0, 19 }, outside = { ", outside of 0 to 19", "OUTSIDE" } } } },
            { 27, "READY_PCT", "Sets type and mode, waits until the device is ready and reads percent values",
                { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                        outside = { ", outside of 0 to 3", "OUTSIDE" } },
                    { "NO", IN, DATA8, "port, counted from 0; 16 to 19 for motors", label = "Port",
                        special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4", [16] = "motor port A", [17] = "motor port B",
                            [18] = "motor port C", [19] = "motor port D" },
                        range = { 0, 19 }, outside = { ", outside of 0 to 19", "OUTSIDE" } },
                    { "TYPE", IN, DATA8, "type to set", enum = ENUMERATIONS.TYPE, special = { [0] = "keep the type" }, range = { 50, 98 },
                        outside = { ", which is not in TYPE", "NO_MEMBER" } },
                    { "MODE", IN, DATA8, "mode to set", special = { [-1] = "keep the mode" }, range = { 0, 7 },
                        outside = { ", outside of 0 to 7 or -1 (keep the mode)", "OUTSIDE" } },
                    { "VALUES", IN, COUNT, "number of values that follow, each in percent", element = DATA8, elements = OUT } } },
            { 28, "READY_RAW", "Sets type and mode, waits until the device is ready and reads raw values",
                { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                        outside = { ", outside of 0 to 3", "OUTSIDE" } },
                    { "NO", IN, DATA8, "port, counted from 0; 16 to 19 for motors", label = "Port",
                        special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4", [16] = "motor port A", [17] = "motor port B",
                            [18] = "motor port C", [19] = "motor port D" },
                        range = { 0, 19 }, outside = { ", outside of 0 to 19", "OUTSIDE" } },
                    { "TYPE", IN, DATA8, "type to set", enum = ENUMERATIONS.TYPE, special = { [0] = "keep the type" }, range = { 50, 98 },
                        outside = { ", which is not in TYPE", "NO_MEMBER" } },
                    { "MODE", IN, DATA8, "mode to set", special = { [-1] = "keep the mode" }, range = { 0, 7 },
                        outside = { ", outside of 0 to 7 or -1 (keep the mode)", "OUTSIDE" } },
                    { "VALUES", IN, COUNT, "number of raw values that follow", reading = "raw", element = DATA32, elements = OUT } } },
            { 29, "READY_SI", "Sets type and mode, waits until the device is ready and reads SI values",
                { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                        outside = { ", outside of 0 to 3", "OUTSIDE" } },
                    { "NO", IN, DATA8, "port, counted from 0; 16 to 19 for motors", label = "Port",
                        special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4", [16] = "motor port A", [17] = "motor port B",
                            [18] = "motor port C", [19] = "motor port D" },
                        range = { 0, 19 }, outside = { ", outside of 0 to 19", "OUTSIDE" } },
                    { "TYPE", IN, DATA8, "type to set", enum = ENUMERATIONS.TYPE, special = { [0] = "keep the type" }, range = { 50, 98 },
                        outside = { ", which is not in TYPE", "NO_MEMBER" } },
                    { "MODE", IN, DATA8, "mode to set", special = { [-1] = "keep the mode" }, range = { 0, 7 },
                        outside = { ", outside of 0 to 7 or -1 (keep the mode)", "OUTSIDE" } },
                    { "VALUES", IN, COUNT, "number of values that follow, each in SI units", reading = "si", element = DATAF, elements = OUT } } },
            { 30, "GET_MINMAX", "Reports the range of SI values of the current mode",
                { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                        outside = { ", outside of 0 to 3", "OUTSIDE" } },
                    { "NO", IN, DATA8, "port, counted from 0; 16 to 19 for motors", label = "Port",
                        special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4", [16] = "motor port A", [17] = "motor port B",
                            [18] = "motor port C", [19] = "motor port D" },
                        range = { 0, 19 }, outside = { ", outside of 0 to 19", "OUTSIDE" } },
                    { "MIN", OUT, DATAF, "smallest value in SI units" }, { "MAX", OUT, DATAF, "largest value in SI units" } } },
            { 31, "GET_BUMPS", "Reads how often a touch sensor changed to released since CLR_CHANGES",
                { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                        outside = { ", outside of 0 to 3", "OUTSIDE" } },
                    { "NO", IN, DATA8, "port, counted from 0; 16 to 19 for motors", label = "Port",
                        special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4", [16] = "motor port A", [17] = "motor port B",
                            [18] = "motor port C", [19] = "motor port D" },
                        range = { 0, 19 }, outside = { ", outside of 0 to 19", "OUTSIDE" } },
                    { "VALUE", OUT, DATAF, "number of changes, 0 for other sensors" } } },
        } },
    { 0x9A, "INPUT_READ", "Sets type and mode and reads the first value in percent at once",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NO", IN, DATA8, "port, counted from 0; 16 to 19 for motors", label = "Port",
                special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4", [16] = "motor port A", [17] = "motor port B",
                    [18] = "motor port C", [19] = "motor port D" },
                range = { 0, 19 }, outside = { ", outside of 0 to 19", "OUTSIDE" } },
            { "TYPE", IN, DATA8, "type to set", enum = ENUMERATIONS.TYPE, special = { [0] = "keep the type" }, range = { 50, 98 },
                outside = { ", which is not in TYPE", "NO_MEMBER" } },
            { "MODE", IN, DATA8, "mode to set", special = { [-1] = "keep the mode" }, range = { 0, 7 },
                outside = { ", outside of 0 to 7 or -1 (keep the mode)", "OUTSIDE" } },
            { "PCT", OUT, DATA8, "value, NaN if there is none", unit = "%" } } },
    { 0x9B, "INPUT_TEST", "Reports whether a device is still changing type or mode",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NO", IN, DATA8, "port, counted from 0; 16 to 19 for motors", label = "Port",
                special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4", [16] = "motor port A", [17] = "motor port B",
                    [18] = "motor port C", [19] = "motor port D" },
                range = { 0, 19 }, outside = { ", outside of 0 to 19", "OUTSIDE" } },
            { "BUSY", OUT, DATA8, "whether to wait", special = { [0] = "ready", [1] = "busy" }, range = { 0, 1 } } } },
    { 0x9C, "INPUT_READY", "Waits until a device has valid values",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NO", IN, DATA8, "port, counted from 0; 16 to 19 for motors", label = "Port",
                special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4", [16] = "motor port A", [17] = "motor port B",
                    [18] = "motor port C", [19] = "motor port D" },
                range = { 0, 19 }, outside = { ", outside of 0 to 19", "OUTSIDE" } } } },
    { 0x9D, "INPUT_READSI", "Sets type and mode and reads the first value in SI units at once",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NO", IN, DATA8, "port, counted from 0; 16 to 19 for motors", label = "Port",
                special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4", [16] = "motor port A", [17] = "motor port B",
                    [18] = "motor port C", [19] = "motor port D" },
                range = { 0, 19 }, outside = { ", outside of 0 to 19", "OUTSIDE" } },
            { "TYPE", IN, DATA8, "type to set", enum = ENUMERATIONS.TYPE, special = { [0] = "keep the type" }, range = { 50, 98 },
                outside = { ", which is not in TYPE", "NO_MEMBER" } },
            { "MODE", IN, DATA8, "mode to set", special = { [-1] = "keep the mode" }, range = { 0, 7 },
                outside = { ", outside of 0 to 7 or -1 (keep the mode)", "OUTSIDE" } },
            { "SI", OUT, DATAF, "value in the mode's unit, NaN if there is none", reading = "si" } } },
    { 0x9E, "INPUT_READEXT", "Sets type and mode and reads several values at once, in the format asked for",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NO", IN, DATA8, "port, counted from 0; 16 to 19 for motors", label = "Port",
                special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4", [16] = "motor port A", [17] = "motor port B",
                    [18] = "motor port C", [19] = "motor port D" },
                range = { 0, 19 }, outside = { ", outside of 0 to 19", "OUTSIDE" } },
            { "TYPE", IN, DATA8, "type to set", enum = ENUMERATIONS.TYPE, special = { [0] = "keep the type" }, range = { 50, 98 },
                outside = { ", which is not in TYPE", "NO_MEMBER" } },
            { "MODE", IN, DATA8, "mode to set", special = { [-1] = "keep the mode" }, range = { 0, 7 },
                outside = { ", outside of 0 to 7 or -1 (keep the mode)", "OUTSIDE" } },
            { "FORMAT", IN, DATA8, "DATA_PCT, DATA_RAW or DATA_SI; others give NaN", enum = ENUMERATIONS.DATA_FORMAT,
                outside = { ", which is not in DATA_FORMAT", "NO_MEMBER" } },
            { "VALUES", IN, COUNT, "number of values that follow, each in FORMAT", element = "FORMAT", elements = OUT } } },
    { 0x9F, "INPUT_WRITE", "Sends bytes to a UART sensor",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NO", IN, DATA8, "sensor port, counted from 0", label = "Port",
                special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4" }, range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "BYTES", IN, DATA8, "number of bytes to send", unit = "bytes", range = { 1, 32 },
                outside = { " bytes, outside of 1 to 32 bytes", "OUTSIDE" } },
            { "DATA", IN, DATA8, "bytes to send", length = "BYTES" } } },
    { 0xE0, "INPUT_SET_CONN", "Sets how a port is connected, for ports whose automatic detection is off",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NO", IN, DATA8, "sensor port, counted from 0", label = "Port",
                special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4" }, range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "CONN", IN, DATA8, "CONN_NXT_IIC, CONN_NXT_DUMB, CONN_INPUT_DUMB or CONN_NONE", enum = ENUMERATIONS.CONN,
                outside = { ", which is not in CONN", "NO_MEMBER" } } },
        dialects = { xtended = true, compat = true } },
    { 0xE1, "INPUT_IIC_READ", "Fetches the bytes that an I2C sensor answered to INPUT_IIC_WRITE",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NO", IN, DATA8, "sensor port, counted from 0", label = "Port",
                special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4" }, range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "RDLNG", IN, DATA8, "number of bytes to read", unit = "bytes", range = { 0, 32 },
                outside = { " bytes, outside of 0 to 32 bytes", "OUTSIDE" } },
            { "RDDATA", OUT, DATA8, "bytes read", length = "RDLNG" }, { "RESULT", OUT, DATA8, "OK or FAIL", enum = ENUMERATIONS.RESULT } },
        dialects = { xtended = true, compat = true } },
    { 0xE2, "INPUT_IIC_STATUS", "Reports the state of the I2C bus of a port",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NO", IN, DATA8, "sensor port, counted from 0", label = "Port",
                special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4" }, range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "RESULT", OUT, DATA8, "state of the bus", enum = ENUMERATIONS.RESULT } },
        dialects = { xtended = true, compat = true } },
    { 0xE3, "INPUT_IIC_WRITE", "Sends bytes to an I2C sensor once, without waiting for its answer",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NO", IN, DATA8, "sensor port, counted from 0", label = "Port",
                special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4" }, range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "WRLNG", IN, DATA8, "number of bytes to write", unit = "bytes", range = { 0, 32 },
                outside = { " bytes, outside of 0 to 32 bytes", "OUTSIDE" } },
            { "WRDATA", IN, DATA8, "bytes to write: I2C address, register, data", length = "WRLNG" },
            { "RDLNG", IN, DATA8, "number of bytes in the sensor's answer", unit = "bytes", range = { 0, 32 },
                outside = { " bytes, outside of 0 to 32 bytes", "OUTSIDE" } },
            { "RESULT", OUT, DATA8, "state of the bus after the request", enum = ENUMERATIONS.RESULT } },
        dialects = { xtended = true, compat = true } },
    { 0xE4, "INPUT_SET_AUTOID", "Switches the automatic detection of sensors at a port on or off",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NO", IN, DATA8, "sensor port, counted from 0", label = "Port",
                special = { [0] = "port 1", [1] = "port 2", [2] = "port 3", [3] = "port 4" }, range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "ENABLE", IN, DATA8, "whether to detect", special = { [0] = "off", [1] = "on" }, range = { 0, 1 },
                outside = { ", outside of 0 to 1", "OUTSIDE" } } },
        dialects = { xtended = true, compat = true } },
    { 0xA0, "OUTPUT_GET_TYPE", "Reports the type of motor at a port; documented, but not implemented by any firmware",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NO", IN, DATA8, "port, counted from 0", label = "Port", special = { [0] = "A", [1] = "B", [2] = "C", [3] = "D" }, is_motor = true,
                range = { 0, 3 }, outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "TYPE", OUT, DATA8, "type of the motor", enum = ENUMERATIONS.TYPE, range = { 50, 98 } } },
        dialects = {} },
    { 0xA1, "OUTPUT_SET_TYPE", "Declares which type of motor is at a port",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NO", IN, DATA8, "port, counted from 0", label = "Port", special = { [0] = "A", [1] = "B", [2] = "C", [3] = "D" }, is_motor = true,
                range = { 0, 3 }, outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "TYPE", IN, DATA8, "type of the motor", enum = ENUMERATIONS.TYPE, range = { 50, 98 },
                outside = { ", which is not in TYPE", "NO_MEMBER" } } } },
    { 0xA2, "OUTPUT_RESET", "Sets the tacho counts that moves and OUTPUT_READ use to zero",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NOS", IN, DATA8, "ports as a bit mask: A 1, B 2, C 4, D 8", label = "Ports",
                special = { [0] = "none", [1] = "A", [2] = "B", [3] = "A+B", [4] = "C", [5] = "A+C", [6] = "B+C", [7] = "A+B+C", [8] = "D",
                    [9] = "A+D", [10] = "B+D", [11] = "A+B+D", [12] = "C+D", [13] = "A+C+D", [14] = "B+C+D", [15] = "A+B+C+D" },
                is_set = true, range = { 1, 15 }, outside = { ", outside of 0 to 15", "OUTSIDE" } } } },
    { 0xA3, "OUTPUT_STOP", "Stops motors",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NOS", IN, DATA8, "ports as a bit mask: A 1, B 2, C 4, D 8", label = "Ports",
                special = { [0] = "none", [1] = "A", [2] = "B", [3] = "A+B", [4] = "C", [5] = "A+C", [6] = "B+C", [7] = "A+B+C", [8] = "D",
                    [9] = "A+D", [10] = "B+D", [11] = "A+B+D", [12] = "C+D", [13] = "A+C+D", [14] = "B+C+D", [15] = "A+B+C+D" },
                is_set = true, range = { 1, 15 }, outside = { ", outside of 0 to 15", "OUTSIDE" } },
            { "BRAKE", IN, DATA8, "what the motors do at the end", special = { [0] = "coast", [1] = "brake and hold" }, range = { 0, 1 },
                outside = { ", outside of 0 to 1", "OUTSIDE" } } } },
    { 0xA4, "OUTPUT_POWER", "Sets the power of motors, which run at the next OUTPUT_START",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NOS", IN, DATA8, "ports as a bit mask: A 1, B 2, C 4, D 8", label = "Ports",
                special = { [0] = "none", [1] = "A", [2] = "B", [3] = "A+B", [4] = "C", [5] = "A+C", [6] = "B+C", [7] = "A+B+C", [8] = "D",
                    [9] = "A+D", [10] = "B+D", [11] = "A+B+D", [12] = "C+D", [13] = "A+C+D", [14] = "B+C+D", [15] = "A+B+C+D" },
                is_set = true, range = { 1, 15 }, outside = { ", outside of 0 to 15", "OUTSIDE" } },
            { "POWER", IN, DATA8, "unregulated power; negative: backward", unit = "%", range = { -100, 100 },
                outside = { " %, outside of -100 to 100 %", "OUTSIDE" } } } },
    { 0xA5, "OUTPUT_SPEED", "Sets the speed of motors, which run at the next OUTPUT_START",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NOS", IN, DATA8, "ports as a bit mask: A 1, B 2, C 4, D 8", label = "Ports",
                special = { [0] = "none", [1] = "A", [2] = "B", [3] = "A+B", [4] = "C", [5] = "A+C", [6] = "B+C", [7] = "A+B+C", [8] = "D",
                    [9] = "A+D", [10] = "B+D", [11] = "A+B+D", [12] = "C+D", [13] = "A+C+D", [14] = "B+C+D", [15] = "A+B+C+D" },
                is_set = true, range = { 1, 15 }, outside = { ", outside of 0 to 15", "OUTSIDE" } },
            { "SPEED", IN, DATA8, "regulated speed; negative: backward", unit = "%", range = { -100, 100 },
                outside = { " %, outside of -100 to 100 %", "OUTSIDE" } } } },
    { 0xA6, "OUTPUT_START", "Starts motors with the power or speed set before",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NOS", IN, DATA8, "ports as a bit mask: A 1, B 2, C 4, D 8", label = "Ports",
                special = { [0] = "none", [1] = "A", [2] = "B", [3] = "A+B", [4] = "C", [5] = "A+C", [6] = "B+C", [7] = "A+B+C", [8] = "D",
                    [9] = "A+D", [10] = "B+D", [11] = "A+B+D", [12] = "C+D", [13] = "A+C+D", [14] = "B+C+D", [15] = "A+B+C+D" },
                is_set = true, range = { 1, 15 }, outside = { ", outside of 0 to 15", "OUTSIDE" } } } },
    { 0xA7, "OUTPUT_POLARITY", "Sets the direction of motors",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NOS", IN, DATA8, "ports as a bit mask: A 1, B 2, C 4, D 8", label = "Ports",
                special = { [0] = "none", [1] = "A", [2] = "B", [3] = "A+B", [4] = "C", [5] = "A+C", [6] = "B+C", [7] = "A+B+C", [8] = "D",
                    [9] = "A+D", [10] = "B+D", [11] = "A+B+D", [12] = "C+D", [13] = "A+C+D", [14] = "B+C+D", [15] = "A+B+C+D" },
                is_set = true, range = { 1, 15 }, outside = { ", outside of 0 to 15", "OUTSIDE" } },
            { "POL", IN, DATA8, "direction", special = { [-1] = "backward", [0] = "opposite of the current one", [1] = "forward" },
                range = { -1, 1 }, outside = { ", outside of -1 to 1", "OUTSIDE" } } } },
    { 0xA8, "OUTPUT_READ", "Reads speed and tacho count of one motor, 0 on layers other than 0",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NO", IN, DATA8, "port, counted from 0", label = "Port", special = { [0] = "A", [1] = "B", [2] = "C", [3] = "D" }, is_motor = true,
                range = { 0, 3 }, outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "SPEED", OUT, DATA8, "current speed", unit = "%", range = { -100, 100 } },
            { "TACHO", OUT, DATA32, "angle in the current phase of a move; about 0 after one that brakes", unit = "degrees" } } },
    { 0xA9, "OUTPUT_TEST", "Reports whether one of the motors is still in a move that ends by itself",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NOS", IN, DATA8, "ports as a bit mask: A 1, B 2, C 4, D 8", label = "Ports",
                special = { [0] = "none", [1] = "A", [2] = "B", [3] = "A+B", [4] = "C", [5] = "A+C", [6] = "B+C", [7] = "A+B+C", [8] = "D",
                    [9] = "A+D", [10] = "B+D", [11] = "A+B+D", [12] = "C+D", [13] = "A+C+D", [14] = "B+C+D", [15] = "A+B+C+D" },
                is_set = true, range = { 1, 15 }, outside = { ", outside of 0 to 15", "OUTSIDE" } },
            { "BUSY", OUT, DATA8, "whether to wait", special = { [0] = "ready", [1] = "busy" }, range = { 0, 1 } } } },
    { 0xAA, "OUTPUT_READY", "Waits until the moves of the motors have ended; ignores those from OUTPUT_START",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NOS", IN, DATA8, "ports as a bit mask: A 1, B 2, C 4, D 8", label = "Ports",
                special = { [0] = "none", [1] = "A", [2] = "B", [3] = "A+B", [4] = "C", [5] = "A+C", [6] = "B+C", [7] = "A+B+C", [8] = "D",
                    [9] = "A+D", [10] = "B+D", [11] = "A+B+D", [12] = "C+D", [13] = "A+C+D", [14] = "B+C+D", [15] = "A+B+C+D" },
                is_set = true, range = { 1, 15 }, outside = { ", outside of 0 to 15", "OUTSIDE" } } } },
    { 0xAB, "OUTPUT_POSITION", "Reports the position of motors; documented, but not implemented by any firmware",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NOS", IN, DATA8, "ports as a bit mask: A 1, B 2, C 4, D 8", label = "Ports",
                special = { [0] = "none", [1] = "A", [2] = "B", [3] = "A+B", [4] = "C", [5] = "A+C", [6] = "B+C", [7] = "A+B+C", [8] = "D",
                    [9] = "A+D", [10] = "B+D", [11] = "A+B+D", [12] = "C+D", [13] = "A+C+D", [14] = "B+C+D", [15] = "A+B+C+D" },
                is_set = true, range = { 1, 15 }, outside = { ", outside of 0 to 15", "OUTSIDE" } },
            { "POS", OUT, DATA32, "position", unit = "degrees" } },
        dialects = {} },
    { 0xAC, "OUTPUT_STEP_POWER", "Turns motors by an angle with unregulated power",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NOS", IN, DATA8, "ports as a bit mask: A 1, B 2, C 4, D 8", label = "Ports",
                special = { [0] = "none", [1] = "A", [2] = "B", [3] = "A+B", [4] = "C", [5] = "A+C", [6] = "B+C", [7] = "A+B+C", [8] = "D",
                    [9] = "A+D", [10] = "B+D", [11] = "A+B+D", [12] = "C+D", [13] = "A+C+D", [14] = "B+C+D", [15] = "A+B+C+D" },
                is_set = true, range = { 1, 15 }, outside = { ", outside of 0 to 15", "OUTSIDE" } },
            { "POWER", IN, DATA8, "unregulated power; negative: backward", unit = "%", range = { -100, 100 },
                outside = { " %, outside of -100 to 100 %", "OUTSIDE" } },
            { "STEP1", IN, DATA32, "angle of the ramp up", unit = "degrees", range = { 0, 2147483647 },
                outside = { " degrees, outside of 0 to 2147483647 degrees", "OUTSIDE" } },
            { "STEP2", IN, DATA32, "angle at constant drive", unit = "degrees", range = { 0, 2147483647 },
                outside = { " degrees, outside of 0 to 2147483647 degrees", "OUTSIDE" } },
            { "STEP3", IN, DATA32, "angle of the ramp down", unit = "degrees", range = { 0, 2147483647 },
                outside = { " degrees, outside of 0 to 2147483647 degrees", "OUTSIDE" } },
            { "BRAKE", IN, DATA8, "what the motors do at the end", special = { [0] = "coast", [1] = "brake and hold" }, range = { 0, 1 },
                outside = { ", outside of 0 to 1", "OUTSIDE" } } } },
    { 0xAD, "OUTPUT_TIME_POWER", "Runs motors for a time with unregulated power",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NOS", IN, DATA8, "ports as a bit mask: A 1, B 2, C 4, D 8", label = "Ports",
                special = { [0] = "none", [1] = "A", [2] = "B", [3] = "A+B", [4] = "C", [5] = "A+C", [6] = "B+C", [7] = "A+B+C", [8] = "D",
                    [9] = "A+D", [10] = "B+D", [11] = "A+B+D", [12] = "C+D", [13] = "A+C+D", [14] = "B+C+D", [15] = "A+B+C+D" },
                is_set = true, range = { 1, 15 }, outside = { ", outside of 0 to 15", "OUTSIDE" } },
            { "POWER", IN, DATA8, "unregulated power; negative: backward", unit = "%", range = { -100, 100 },
                outside = { " %, outside of -100 to 100 %", "OUTSIDE" } },
            { "TIME1", IN, DATA32, "time of the ramp up", unit = "ms", range = { 0, 2147483647 },
                outside = { " ms, outside of 0 to 2147483647 ms", "OUTSIDE" } },
            { "TIME2", IN, DATA32, "time at constant drive", unit = "ms", range = { 0, 2147483647 },
                outside = { " ms, outside of 0 to 2147483647 ms", "OUTSIDE" } },
            { "TIME3", IN, DATA32, "time of the ramp down", unit = "ms", range = { 0, 2147483647 },
                outside = { " ms, outside of 0 to 2147483647 ms", "OUTSIDE" } },
            { "BRAKE", IN, DATA8, "what the motors do at the end", special = { [0] = "coast", [1] = "brake and hold" }, range = { 0, 1 },
                outside = { ", outside of 0 to 1", "OUTSIDE" } } } },
    { 0xAE, "OUTPUT_STEP_SPEED", "Turns motors by an angle with regulated speed",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NOS", IN, DATA8, "ports as a bit mask: A 1, B 2, C 4, D 8", label = "Ports",
                special = { [0] = "none", [1] = "A", [2] = "B", [3] = "A+B", [4] = "C", [5] = "A+C", [6] = "B+C", [7] = "A+B+C", [8] = "D",
                    [9] = "A+D", [10] = "B+D", [11] = "A+B+D", [12] = "C+D", [13] = "A+C+D", [14] = "B+C+D", [15] = "A+B+C+D" },
                is_set = true, range = { 1, 15 }, outside = { ", outside of 0 to 15", "OUTSIDE" } },
            { "SPEED", IN, DATA8, "regulated speed; negative: backward", unit = "%", range = { -100, 100 },
                outside = { " %, outside of -100 to 100 %", "OUTSIDE" } },
            { "STEP1", IN, DATA32, "angle of the ramp up", unit = "degrees", range = { 0, 2147483647 },
                outside = { " degrees, outside of 0 to 2147483647 degrees", "OUTSIDE" } },
            { "STEP2", IN, DATA32, "angle at constant drive", unit = "degrees", range = { 0, 2147483647 },
                outside = { " degrees, outside of 0 to 2147483647 degrees", "OUTSIDE" } },
            { "STEP3", IN, DATA32, "angle of the ramp down", unit = "degrees", range = { 0, 2147483647 },
                outside = { " degrees, outside of 0 to 2147483647 degrees", "OUTSIDE" } },
            { "BRAKE", IN, DATA8, "what the motors do at the end", special = { [0] = "coast", [1] = "brake and hold" }, range = { 0, 1 },
                outside = { ", outside of 0 to 1", "OUTSIDE" } } } },
    { 0xAF, "OUTPUT_TIME_SPEED", "Runs motors for a time with regulated speed",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NOS", IN, DATA8, "ports as a bit mask: A 1, B 2, C 4, D 8", label = "Ports",
                special = { [0] = "none", [1] = "A", [2] = "B", [3] = "A+B", [4] = "C", [5] = "A+C", [6] = "B+C", [7] = "A+B+C", [8] = "D",
                    [9] = "A+D", [10] = "B+D", [11] = "A+B+D", [12] = "C+D", [13] = "A+C+D", [14] = "B+C+D", [15] = "A+B+C+D" },
                is_set = true, range = { 1, 15 }, outside = { ", outside of 0 to 15", "OUTSIDE" } },
            { "SPEED", IN, DATA8, "regulated speed; negative: backward", unit = "%", range = { -100, 100 },
                outside = { " %, outside of -100 to 100 %", "OUTSIDE" } },
            { "TIME1", IN, DATA32, "time of the ramp up", unit = "ms", range = { 0, 2147483647 },
                outside = { " ms, outside of 0 to 2147483647 ms", "OUTSIDE" } },
            { "TIME2", IN, DATA32, "time at constant drive", unit = "ms", range = { 0, 2147483647 },
                outside = { " ms, outside of 0 to 2147483647 ms", "OUTSIDE" } },
            { "TIME3", IN, DATA32, "time of the ramp down", unit = "ms", range = { 0, 2147483647 },
                outside = { " ms, outside of 0 to 2147483647 ms", "OUTSIDE" } },
            { "BRAKE", IN, DATA8, "what the motors do at the end", special = { [0] = "coast", [1] = "brake and hold" }, range = { 0, 1 },
                outside = { ", outside of 0 to 1", "OUTSIDE" } } } },
    { 0xB0, "OUTPUT_STEP_SYNC", "Turns two motors in step by an angle",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NOS", IN, DATA8, "ports as a bit mask: A 1, B 2, C 4, D 8", label = "Ports",
                special = { [0] = "none", [1] = "A", [2] = "B", [3] = "A+B", [4] = "C", [5] = "A+C", [6] = "B+C", [7] = "A+B+C", [8] = "D",
                    [9] = "A+D", [10] = "B+D", [11] = "A+B+D", [12] = "C+D", [13] = "A+C+D", [14] = "B+C+D", [15] = "A+B+C+D" },
                is_set = true, range = { 1, 15 }, outside = { ", outside of 0 to 15", "OUTSIDE" } },
            { "SPEED", IN, DATA8, "regulated speed; negative: backward", unit = "%", range = { -100, 100 },
                outside = { " %, outside of -100 to 100 %", "OUTSIDE" } },
            { "TURN", IN, DATA16, "how tight the turn is, positive slows the higher port, negative the lower",
                special = { [-200] = "spin, lower port runs backward", [-100] = "lower port stands still", [0] = "straight",
                    [100] = "higher port stands still", [200] = "spin, higher port runs backward" },
                range = { -200, 200 }, outside = { ", outside of -200 to 200", "OUTSIDE" } },
            { "STEP", IN, DATA32, "angle of the faster motor", unit = "degrees", special = { [0] = "endless" }, range = { 0, 2147483647 },
                outside = { " degrees, outside of 0 to 2147483647 degrees", "OUTSIDE" } },
            { "BRAKE", IN, DATA8, "what the motors do at the end", special = { [0] = "coast", [1] = "brake and hold" }, range = { 0, 1 },
                outside = { ", outside of 0 to 1", "OUTSIDE" } } } },
    { 0xB1, "OUTPUT_TIME_SYNC", "Runs two motors in step for a time",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NOS", IN, DATA8, "ports as a bit mask: A 1, B 2, C 4, D 8", label = "Ports",
                special = { [0] = "none", [1] = "A", [2] = "B", [3] = "A+B", [4] = "C", [5] = "A+C", [6] = "B+C", [7] = "A+B+C", [8] = "D",
                    [9] = "A+D", [10] = "B+D", [11] = "A+B+D", [12] = "C+D", [13] = "A+C+D", [14] = "B+C+D", [15] = "A+B+C+D" },
                is_set = true, range = { 1, 15 }, outside = { ", outside of 0 to 15", "OUTSIDE" } },
            { "SPEED", IN, DATA8, "regulated speed; negative: backward", unit = "%", range = { -100, 100 },
                outside = { " %, outside of -100 to 100 %", "OUTSIDE" } },
            { "TURN", IN, DATA16, "how tight the turn is, positive slows the higher port, negative the lower",
                special = { [-200] = "spin, lower port runs backward", [-100] = "lower port stands still", [0] = "straight",
                    [100] = "higher port stands still", [200] = "spin, higher port runs backward" },
                range = { -200, 200 }, outside = { ", outside of -200 to 200", "OUTSIDE" } },
            { "TIME", IN, DATA32, "how long to run", unit = "ms", special = { [0] = "endless" }, range = { 0, 2147483647 },
                outside = { " ms, outside of 0 to 2147483647 ms", "OUTSIDE" } },
            { "BRAKE", IN, DATA8, "what the motors do at the end", special = { [0] = "coast", [1] = "brake and hold" }, range = { 0, 1 },
                outside = { ", outside of 0 to 1", "OUTSIDE" } } } },
    { 0xB2, "OUTPUT_CLR_COUNT", "Sets the tacho counts of motors read as sensors to zero",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NOS", IN, DATA8, "ports as a bit mask: A 1, B 2, C 4, D 8", label = "Ports",
                special = { [0] = "none", [1] = "A", [2] = "B", [3] = "A+B", [4] = "C", [5] = "A+C", [6] = "B+C", [7] = "A+B+C", [8] = "D",
                    [9] = "A+D", [10] = "B+D", [11] = "A+B+D", [12] = "C+D", [13] = "A+C+D", [14] = "B+C+D", [15] = "A+B+C+D" },
                is_set = true, range = { 1, 15 }, outside = { ", outside of 0 to 15", "OUTSIDE" } } } },
    { 0xB3, "OUTPUT_GET_COUNT", "Reads the tacho count of a motor read as a sensor",
        { { "LAYER", IN, DATA8, "brick in the daisy chain, 0 is the one addressed", label = "Daisy chain", range = { 0, 3 },
                outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "NOS", IN, DATA8, "port, counted from 0", label = "Port", special = { [0] = "A", [1] = "B", [2] = "C", [3] = "D" },
                is_motor = true, range = { 0, 3 }, outside = { ", outside of 0 to 3", "OUTSIDE" } },
            { "TACHO", OUT, DATA32, "angle since OUTPUT_CLR_COUNT", unit = "degrees" } } },
    { 0xB4, "OUTPUT_PRG_STOP", "Stops and resets all motors as the end of a program does", {} },
    { 0x7E, "MEMORY_WRITE", "Writes bytes into the variables of a running program",
        { { "PRGID", IN, DATA16, "slot of the program, which must be running", enum = ENUMERATIONS.SLOT, range = { 0, 4 }, is_ranged = true,
                outside = { ", outside of 0 to 4", "OUTSIDE" } },
            { "OBJID", IN, DATA16, "object whose local memory is meant", special = { [0] = "the program's global memory" } },
            { "OFFSET", IN, DATA32, "first byte in that memory", unit = "bytes", range = { 0, 2147483647 },
                outside = { " bytes, outside of 0 to 2147483647 bytes", "OUTSIDE" } },
            { "SIZE", IN, DATA32, "number of bytes", unit = "bytes", range = { 0, 2147483647 },
                outside = { " bytes, outside of 0 to 2147483647 bytes", "OUTSIDE" } },
            { "ARRAY", IN, DATA8, "the bytes; those beyond the end of the memory are dropped", length = "SIZE" } } },
    { 0x7F, "MEMORY_READ", "Reads bytes from the variables of a running program",
        { { "PRGID", IN, DATA16, "slot of the program, which must be running", enum = ENUMERATIONS.SLOT, range = { 0, 4 }, is_ranged = true,
                outside = { ", outside of 0 to 4", "OUTSIDE" } },
            { "OBJID", IN, DATA16, "object whose local memory is meant", special = { [0] = "the program's global memory" } },
            { "OFFSET", IN, DATA32, "first byte in that memory", unit = "bytes", range = { 0, 2147483647 },
                outside = { " bytes, outside of 0 to 2147483647 bytes", "OUTSIDE" } },
            { "SIZE", IN, DATA32, "number of bytes", unit = "bytes", range = { 0, 2147483647 },
                outside = { " bytes, outside of 0 to 2147483647 bytes", "OUTSIDE" } },
            { "ARRAY", OUT, DATA8, "the bytes, zeros beyond the end of the memory", length = "SIZE" } } },
    { 0xC0, "FILE", "Works on files, folders, data logs, program images and the list of recent files",
        commands = {
            { 0, "OPEN_APPEND", "Opens a file for appending; creates it if it does not exist",
                { { "NAME", IN, STRING, "path of the file; a bare name is taken from the program's own folder", most = 119 },
                    { "HANDLE", OUT, HANDLE, "handle of the opened file" } } },
            { 1, "OPEN_READ", "Opens a file for reading",
                { { "NAME", IN, STRING, "path of the file; a bare name is taken from the program's own folder", most = 119 },
                    { "HANDLE", OUT, HANDLE, "handle of the opened file" },
                    { "SIZE", OUT, DATA32, "size of the file", unit = "bytes", special = { [0] = "not found" } } } },
            { 2, "OPEN_WRITE", "Creates or truncates a file and opens it for writing",
                { { "NAME", IN, STRING, "path of the file; a bare name is taken from the program's own folder", most = 119 },
                    { "HANDLE", OUT, HANDLE, "handle of the opened file" } } },
            { 3, "READ_VALUE", "Reads the text up to the next delimiter and turns it into a number",
                { { "HANDLE", IN, HANDLE, "the open file" },
                    { "DEL", IN, DATA8, "separator between two values in the file", enum = ENUMERATIONS.DEL,
                        outside = { ", which is not in DEL", "NO_MEMBER" } },
                    { "VALUE", OUT, DATAF, "the number, 0 if the text is not a number" } } },
            { 4, "WRITE_VALUE", "Writes a number as text, and a delimiter after it",
                { { "HANDLE", IN, HANDLE, "the open file" },
                    { "DEL", IN, DATA8, "separator between two values in the file", enum = ENUMERATIONS.DEL,
                        outside = { ", which is not in DEL", "NO_MEMBER" } },
                    { "VALUE", IN, DATAF, "the number" }, { "FIGURES", IN, DATA8, "minimum width in characters, including the decimal point" },
                    { "DECIMALS", IN, DATA8, "digits after the decimal point" } } },
            { 5, "READ_TEXT", "Reads text up to the next delimiter",
                { { "HANDLE", IN, HANDLE, "the open file" },
                    { "DEL", IN, DATA8, "separator between two values in the file", enum = ENUMERATIONS.DEL,
                        outside = { ", which is not in DEL", "NO_MEMBER" } },
                    { "LENGTH", IN, DATA16, "maximum number of bytes to read; LEGO's firmware keeps the low 8 bits, so 127", unit = "bytes" },
                    { "TEXT", OUT, STRING, "the text, without a zero at its end if it fills the whole buffer", length = "LENGTH" } } },
            { 6, "WRITE_TEXT", "Writes text without its zero, and a delimiter after it",
                { { "HANDLE", IN, HANDLE, "the open file" },
                    { "DEL", IN, DATA8, "separator between two values in the file", enum = ENUMERATIONS.DEL,
                        outside = { ", which is not in DEL", "NO_MEMBER" } },
                    { "TEXT", IN, STRING, "the text" } } },
            { 7, "CLOSE", "Closes a file and frees its handle", { { "HANDLE", IN, HANDLE, "the open file" } } },
            { 8, "LOAD_IMAGE", "Loads a program file into a stopped slot, for PROGRAM_START to run",
                { { "PRGID", IN, DATA16, "slot to load it into", enum = ENUMERATIONS.SLOT, range = { 0, 4 }, is_ranged = true,
                        outside = { ", outside of 0 to 4", "OUTSIDE" } },
                    { "NAME", IN, STRING, "path of the program, relative to /home/root/lms2012/sys; .rbf may be omitted", most = 119 },
                    { "SIZE", OUT, DATA32, "size of the program", unit = "bytes", special = { [0] = "not loaded" } },
                    { "IP", OUT, DATA32, "where it was loaded, for PROGRAM_START", special = { [0] = "not loaded" } } } },
            { 9, "GET_HANDLE", "Finds the handle of a file that is already open",
                { { "NAME", IN, STRING, "path of the file; a bare name is taken from the program's own folder", most = 119 },
                    { "HANDLE", OUT, HANDLE, "the open file", special = { [-1] = "not open" } },
                    { "WRITE", OUT, DATA8, "whether it is open for writing or appending", special = { [0] = "no", [1] = "yes" } } } },
            { 10, "MAKE_FOLDER", "Creates a folder unless it exists",
                { { "NAME", IN, STRING, "path of the folder, relative to /home/root/lms2012/sys", most = 119 },
                    { "SUCCESS", OUT, DATA8, "whether the folder exists now", special = { [0] = "no", [1] = "yes" } } } },
            { 11, "GET_POOL", "Reserves a block of memory for the program",
                { { "SIZE", IN, DATA32, "how much memory", unit = "bytes", range = { 1, 6000000 },
                        outside = { " bytes, outside of 1 to 6000000 bytes", "OUTSIDE" } },
                    { "HANDLE", OUT, HANDLE, "handle of the block" }, { "IP", OUT, DATA32, "address of the block" } } },
            { 12, "SET_LOG_SYNC_TIME", "Stores the time and tick to which data logs are aligned",
                { { "TIME", IN, DATA32, "the common time" }, { "TICK", IN, DATA32, "the brick's tick at that time" } } },
            { 13, "GET_FOLDERS", "Counts the entries of a folder, without hidden ones",
                { { "NAME", IN, STRING, "path of the folder with its closing slash, such as ../prjs/", most = 119 },
                    { "ITEMS", OUT, DATA8, "number of entries" } } },
            { 14, "GET_LOG_SYNC_TIME", "Reads the time and tick to which data logs are aligned",
                { { "TIME", OUT, DATA32, "the common time" }, { "TICK", OUT, DATA32, "the brick's tick at that time" } } },
            { 15, "GET_SUBFOLDER_NAME", "Reads the name of one entry of a folder",
                { { "NAME", IN, STRING, "path of the folder with its closing slash, such as ../prjs/", most = 119 },
                    { "ITEM", IN, DATA8, "which entry of the folder, the first is 1", range = { 1, 127 },
                        outside = { ", outside of 1 to 127", "OUTSIDE" } },
                    { "LENGTH", IN, DATA8, "size of the string's buffer, including the zero", unit = "bytes" },
                    { "STRING", OUT, STRING, "its name without extension, empty if there is no such entry", length = "LENGTH" } } },
            { 16, "WRITE_LOG", "Adds one row of samples to a data log",
                { { "HANDLE", IN, HANDLE, "the open data log" }, { "TIME", IN, DATA32, "time of the samples since the log began", unit = "ms" },
                    { "ITEMS", IN, DATA8, "number of samples; with 0 nothing is written", range = { 0, 127 },
                        outside = { ", outside of 0 to 127", "OUTSIDE" } },
                    { "VALUES", IN, DATAF, "the samples, in one array", length = "ITEMS" } } },
            { 17, "CLOSE_LOG", "Writes the rest of a data log and closes it",
                { { "HANDLE", IN, HANDLE, "the open data log" },
                    { "NAME", IN, STRING, "path of the log as given to OPEN_LOG; .rdf may be omitted" } } },
            { 18, "GET_IMAGE", "Loads an entry of a folder; LEGO's 2013 firmware has no code for it and fails",
                { { "NAME", IN, STRING, "path of the folder with its closing slash, such as ../prjs/", most = 119 },
                    { "PRGID", IN, DATA16, "slot to load it into", enum = ENUMERATIONS.SLOT, outside = { ", which is not in SLOT", "NO_MEMBER" } },
                    { "ITEM", IN, DATA8, "which entry of the folder, the first is 1", range = { 1, 127 },
                        outside = { ", outside of 1 to 127", "OUTSIDE" } },
                    { "IP", OUT, DATA32, "where it was loaded" } } },
            { 19, "GET_ITEM", "Finds an entry of a folder by its name",
                { { "NAME", IN, STRING, "path of the folder with its closing slash, such as ../prjs/", most = 119 },
                    { "STRING", IN, STRING, "name to look for, without extension" },
                    { "ITEM", OUT, DATA8, "number of the entry; the first is 1", special = { [0] = "not found" }, range = { 1, 127 } } } },
            { 20, "GET_CACHE_FILES", "Counts the recently run files", { { "ITEMS", OUT, DATA8, "number of files, at most 10" } } },
            { 21, "PUT_CACHE_FILE", "Puts a file first in the list of recently run files", { { "STRING", IN, STRING, "path of the file" } } },
            { 22, "GET_CACHE_FILE", "Reads the path of one recently run file",
                { { "ITEM", IN, DATA8, "which one, 1 is the latest", range = { 1, 10 }, outside = { ", outside of 1 to 10", "OUTSIDE" } },
                    { "LENGTH", IN, DATA8, "size of the string's buffer, including the zero", unit = "bytes" },
                    { "STRING", OUT, STRING, "path of the file, empty if there is none", length = "LENGTH" } } },
            { 23, "DEL_CACHE_FILE", "Removes a file from the list of recently run files",
                { { "STRING", IN, STRING, "path of the file, as given to PUT_CACHE_FILE" } } },
            { 24, "DEL_SUBFOLDER", "Deletes one entry of a folder together with the files in it",
                { { "NAME", IN, STRING, "path of the folder with its closing slash, such as ../prjs/", most = 119 },
                    { "ITEM", IN, DATA8, "which entry of the folder, the first is 1", range = { 1, 127 },
                        outside = { ", outside of 1 to 127", "OUTSIDE" } } } },
            { 25, "GET_LOG_NAME", "Reads the path of the open data log",
                { { "LENGTH", IN, DATA8, "size of the string's buffer, including the zero", unit = "bytes" },
                    { "NAME", OUT, STRING, "path of the log, empty if none is open", length = "LENGTH" } } },
            { 27, "OPEN_LOG", "Creates a data log and writes its header",
                { { "NAME", IN, STRING, "path of the log; .rdf may be omitted; with an empty one it stays in memory" },
                    { "syncedTime", IN, DATA32, "the common time, as GET_LOG_SYNC_TIME returns it" },
                    { "syncedTick", IN, DATA32, "the brick's tick at that time" },
                    { "nowTick", IN, DATA32, "the brick's tick at the start of the log" },
                    { "sample_interval_in_ms", IN, DATA32, "time between samples; fast logs are kept in memory first", unit = "ms" },
                    { "duration_in_ms", IN, DATA32, "duration of the log", unit = "ms" },
                    { "SDATA", IN, STRING, "text that describes the sensors, copied into the header" },
                    { "HANDLE", OUT, HANDLE, "handle of the log" } } },
            { 28, "READ_BYTES", "Reads raw bytes from a file",
                { { "HANDLE", IN, HANDLE, "the open file" },
                    { "BYTES", IN, DATA16, "number of bytes", unit = "bytes", range = { 0, 32767 },
                        outside = { " bytes, outside of 0 to 32767 bytes", "OUTSIDE" } },
                    { "DESTINATION", OUT, DATA8, "the bytes; followed by a zero if the file ended early", length = "BYTES" } } },
            { 29, "WRITE_BYTES", "Writes raw bytes to a file",
                { { "HANDLE", IN, HANDLE, "the open file" },
                    { "BYTES", IN, DATA16, "number of bytes", unit = "bytes", range = { 0, 32767 },
                        outside = { " bytes, outside of 0 to 32767 bytes", "OUTSIDE" } },
                    { "SOURCE", IN, DATA8, "the bytes", length = "BYTES" } } },
            { 30, "REMOVE", "Deletes a file, or a folder with the files in it",
                { { "NAME", IN, STRING, "path of the file; a bare name is taken from the program's own folder", most = 119 } } },
            { 31, "MOVE", "Copies a file or folder and replaces the destination; the source is kept",
                { { "SOURCE", IN, STRING, "path to copy from" }, { "DEST", IN, STRING, "path to copy to; any existing one is deleted first" } } },
        } },
    { 0xC1, "ARRAY", "Creates, fills, copies and resizes arrays",
        commands = {
            { 0, "DELETE", "Deletes an array and frees its handle", { { "HANDLE", IN, HANDLE, "the array" } }, dialects = { official = true } },
            { 0, "DESTROY", "Deletes an array and frees its handle (LEGO's name for it is DELETE)", { { "HANDLE", IN, HANDLE, "the array" } },
                dialects = { xtended = true, compat = true } },
            { 1, "CREATE8", "Creates an array of DATA8 elements",
                { { "ELEMENTS", IN, DATA32, "initial number of elements", range = { 0, 6000000 },
                        outside = { ", outside of 0 to 6000000", "OUTSIDE" } },
                    { "HANDLE", OUT, HANDLE, "handle of the new array" } } },
            { 2, "CREATE16", "Creates an array of DATA16 elements",
                { { "ELEMENTS", IN, DATA32, "initial number of elements", range = { 0, 3000000 },
                        outside = { ", outside of 0 to 3000000", "OUTSIDE" } },
                    { "HANDLE", OUT, HANDLE, "handle of the new array" } } },
            { 3, "CREATE32", "Creates an array of DATA32 elements",
                { { "ELEMENTS", IN, DATA32, "initial number of elements", range = { 0, 1500000 },
                        outside = { ", outside of 0 to 1500000", "OUTSIDE" } },
                    { "HANDLE", OUT, HANDLE, "handle of the new array" } } },
            { 4, "CREATEF", "Creates an array of DATAF elements",
                { { "ELEMENTS", IN, DATA32, "initial number of elements", range = { 0, 1500000 },
                        outside = { ", outside of 0 to 1500000", "OUTSIDE" } },
                    { "HANDLE", OUT, HANDLE, "handle of the new array" } } },
            { 5, "RESIZE", "Changes the number of elements of an array",
                { { "HANDLE", IN, HANDLE, "the array" },
                    { "ELEMENTS", IN, DATA32, "new number of elements", range = { 0, 6000000 },
                        outside = { ", outside of 0 to 6000000", "OUTSIDE" } } } },
            { 6, "FILL", "Sets every element of an array to one value",
                { { "HANDLE", IN, HANDLE, "the array" }, { "VALUE", IN, ARRAY_TYPED, "the value, of the array's type" } } },
            { 7, "COPY", "Copies the content of one array into another of the same type, which is resized to match",
                { { "HSOURCE", IN, HANDLE, "array to copy from" }, { "HDEST", IN, HANDLE, "array to copy into, which must exist" } } },
            { 8, "INIT8", "Writes several elements of a DATA8 array, all within its size",
                { { "HANDLE", IN, HANDLE, "the array" },
                    { "INDEX", IN, DATA32, "first element to write, counted from 0", range = { 0, 5999999 },
                        outside = { ", outside of 0 to 5999999", "OUTSIDE" } },
                    { "ELEMENTS", IN, DATA32, "number of values that follow", range = { 0, 2147483647 },
                        outside = { ", outside of 0 to 2147483647", "OUTSIDE" } },
                    { "VALUES", IN, VALUES, "the values, one parameter each", element = DATA8 } } },
            { 9, "INIT16", "Writes several elements of a DATA16 array, all within its size",
                { { "HANDLE", IN, HANDLE, "the array" },
                    { "INDEX", IN, DATA32, "first element to write, counted from 0", range = { 0, 5999999 },
                        outside = { ", outside of 0 to 5999999", "OUTSIDE" } },
                    { "ELEMENTS", IN, DATA32, "number of values that follow", range = { 0, 2147483647 },
                        outside = { ", outside of 0 to 2147483647", "OUTSIDE" } },
                    { "VALUES", IN, VALUES, "the values, one parameter each", element = DATA16 } } },
            { 10, "INIT32", "Writes several elements of a DATA32 array, all within its size",
                { { "HANDLE", IN, HANDLE, "the array" },
                    { "INDEX", IN, DATA32, "first element to write, counted from 0", range = { 0, 5999999 },
                        outside = { ", outside of 0 to 5999999", "OUTSIDE" } },
                    { "ELEMENTS", IN, DATA32, "number of values that follow", range = { 0, 2147483647 },
                        outside = { ", outside of 0 to 2147483647", "OUTSIDE" } },
                    { "VALUES", IN, VALUES, "the values, one parameter each", element = DATA32 } } },
            { 11, "INITF", "Writes several elements of a DATAF array, all within its size",
                { { "HANDLE", IN, HANDLE, "the array" },
                    { "INDEX", IN, DATA32, "first element to write, counted from 0", range = { 0, 5999999 },
                        outside = { ", outside of 0 to 5999999", "OUTSIDE" } },
                    { "ELEMENTS", IN, DATA32, "number of values that follow", range = { 0, 2147483647 },
                        outside = { ", outside of 0 to 2147483647", "OUTSIDE" } },
                    { "VALUES", IN, VALUES, "the values, one parameter each", element = DATAF } } },
            { 12, "SIZE", "Counts the elements of an array",
                { { "HANDLE", IN, HANDLE, "the array" }, { "ELEMENTS", OUT, DATA32, "number of elements, 0 if there is no such array" } },
                dialects = { official = true } },
            { 12, "SET_SIZE", "Counts the elements of an array (LEGO's name for it is SIZE)",
                { { "HANDLE", IN, HANDLE, "the array" }, { "ELEMENTS", OUT, DATA32, "number of elements, 0 if there is no such array" } },
                dialects = { xtended = true, compat = true } },
            { 13, "READ_CONTENT", "Reads an array's content as bytes, also of another program",
                { { "PRGID", IN, DATA16, "slot of the program that owns the array", enum = ENUMERATIONS.SLOT,
                        outside = { ", which is not in SLOT", "NO_MEMBER" } },
                    { "HANDLE", IN, HANDLE, "the array" },
                    { "INDEX", IN, DATA32, "first byte in the array's content, whatever its elements", range = { 0, 2147483647 },
                        outside = { ", outside of 0 to 2147483647", "OUTSIDE" } },
                    { "BYTES", IN, DATA32, "number of bytes", unit = "bytes", range = { 0, 2147483647 },
                        outside = { " bytes, outside of 0 to 2147483647 bytes", "OUTSIDE" } },
                    { "ARRAY", OUT, DATA8, "the bytes, zeros beyond the end of the array", length = "BYTES" } } },
            { 14, "WRITE_CONTENT", "Writes an array's content as bytes; the array then ends after them",
                { { "PRGID", IN, DATA16, "slot of the program that owns the array", enum = ENUMERATIONS.SLOT,
                        outside = { ", which is not in SLOT", "NO_MEMBER" } },
                    { "HANDLE", IN, HANDLE, "the array" },
                    { "INDEX", IN, DATA32, "first byte in the array's content, whatever its elements", range = { 0, 2147483647 },
                        outside = { ", outside of 0 to 2147483647", "OUTSIDE" } },
                    { "BYTES", IN, DATA32, "number of bytes", unit = "bytes", range = { 0, 2147483647 },
                        outside = { " bytes, outside of 0 to 2147483647 bytes", "OUTSIDE" } },
                    { "ARRAY", IN, DATA8, "the bytes", length = "BYTES" } } },
            { 15, "READ_SIZE", "Returns the size of an array's content, also of another program",
                { { "PRGID", IN, DATA16, "slot of the program that owns the array", enum = ENUMERATIONS.SLOT,
                        outside = { ", which is not in SLOT", "NO_MEMBER" } },
                    { "HANDLE", IN, HANDLE, "the array" },
                    { "BYTES", OUT, DATA32, "number of bytes, 0 if there is no such array", unit = "bytes" } } },
        } },
    { 0xC2, "ARRAY_WRITE", "Writes one element of an array, which grows where needed",
        { { "HANDLE", IN, HANDLE, "the array" },
            { "INDEX", IN, DATA32, "which element, the first is 0", range = { 0, 5999999 }, outside = { ", outside of 0 to 5999999", "OUTSIDE" } },
            { "VALUE", IN, ARRAY_TYPED, "the value, of the array's type" } } },
    { 0xC3, "ARRAY_READ", "Reads one element of an array",
        { { "HANDLE", IN, HANDLE, "the array" },
            { "INDEX", IN, DATA32, "which element, the first is 0", range = { 0, 5999999 }, outside = { ", outside of 0 to 5999999", "OUTSIDE" } },
            { "VALUE", OUT, ARRAY_TYPED, "the value, of the array's type" } } },
    { 0xC4, "ARRAY_APPEND", "Adds one element to the end of an array",
        { { "HANDLE", IN, HANDLE, "the array" }, { "VALUE", IN, ARRAY_TYPED, "the value, of the array's type" } } },
    { 0xC5, "MEMORY_USAGE", "Reports the total and free memory for user files",
        { { "TOTAL", OUT, DATA32, "total memory", unit = "KiB" }, { "FREE", OUT, DATA32, "free memory", unit = "KiB" } } },
    { 0xC6, "FILENAME", "Splits and checks file names, and packs files",
        commands = {
            { 16, "EXIST", "Reports whether a file or folder exists",
                { { "NAME", IN, STRING, "path of the file; a bare name is taken from the program's own folder", most = 119 },
                    { "FLAG", OUT, DATA8, "whether it exists", special = { [0] = "no", [1] = "yes" } } } },
            { 17, "TOTALSIZE", "Reports the number of files in a folder and their size",
                { { "NAME", IN, STRING, "path of the folder or file" },
                    { "FILES", OUT, DATA32, "number of entries, including . and ..; 0 for a file" },
                    { "SIZE", OUT, DATA32, "size of all of them, rounded up", unit = "KiB" } } },
            { 18, "SPLIT", "Splits a path into folder, name and extension",
                { { "FILENAME", IN, STRING, "the path" },
                    { "LENGTH", IN, DATA8, "buffer size for each of the three parts, including the zero", unit = "bytes" },
                    { "FOLDER", OUT, STRING, "the folder, with its closing slash on LEGO's firmware", length = "LENGTH" },
                    { "NAME", OUT, STRING, "the name, without folder and extension", length = "LENGTH" },
                    { "EXT", OUT, STRING, "the extension with its dot", length = "LENGTH" } } },
            { 19, "MERGE", "Builds a path from folder, name and extension",
                { { "FOLDER", IN, STRING, "the folder, without a slash at its end" }, { "NAME", IN, STRING, "the name" },
                    { "EXT", IN, STRING, "the extension with its dot" },
                    { "LENGTH", IN, DATA8, "size of the string's buffer, including the zero", unit = "bytes" },
                    { "FILENAME", OUT, STRING, "the path", length = "LENGTH" } } },
            { 20, "CHECK", "Reports whether a path's characters and lengths are allowed; the file need not exist",
                { { "FILENAME", IN, STRING, "the path" },
                    { "OK", OUT, DATA8, "whether the path can be used", special = { [0] = "not allowed", [1] = "allowed" } } } },
            { 21, "PACK", "Packs a file or folder into a .raf archive beside it", { { "FILENAME", IN, STRING, "path of the file or folder" } } },
            { 22, "UNPACK", "Unpacks a .raf archive into the folder it is in",
                { { "FILENAME", IN, STRING, "path of the archive; its extension is replaced by .raf" } } },
            { 23, "GET_FOLDERNAME", "Reads the path of the program's own folder",
                { { "LENGTH", IN, DATA8, "size of the string's buffer, including the zero", unit = "bytes" },
                    { "FOLDERNAME", OUT, STRING, "path of the folder, without a slash at its end", length = "LENGTH" } } },
        } },
    { 0xE6, "FILE_MD5SUM", "Computes the MD5 digest of a file",
        { { "NAME", IN, STRING, "path of the file" }, { "MD5SUM", OUT, DATA8, "the digest, as 16 bytes", length = 16 },
            { "SUCCESS", OUT, DATA8, "whether the file could be read", special = { [0] = "no", [1] = "yes" } } },
        dialects = { xtended = true, compat = true } },
    { 0x91, "COM_READ", "Fetches direct commands, for the brick's own command program",
        commands = {
            { 14, "COMMAND", "Returns the address of the last direct command received",
                { { "LENGTH", IN, DATA32, "maximum number of bytes of code, ignored by the firmware", unit = "bytes" },
                    { "IMAGE", OUT, DATA32, "address of the code" }, { "GLOBAL", OUT, DATA32, "address of its global memory" },
                    { "FLAG", OUT, DATA8, "whether one is waiting", special = { [0] = "none", [1] = "ready to run" }, range = { 0, 1 } } } },
        } },
    { 0x92, "COM_WRITE", "Answers direct commands, for the brick's own command program",
        commands = {
            { 14, "REPLY", "Sends the global memory of a direct command that has run as its reply",
                { { "IMAGE", IN, DATA32, "address of the code" }, { "GLOBAL", IN, DATA32, "address of its global memory" },
                    { "STATUS", IN, DATA8, "how it ended; all but OK give DIRECT_REPLY_ERROR", enum = ENUMERATIONS.RESULT,
                        outside = { ", which is not in RESULT", "NO_MEMBER" } } } },
        } },
    { 0xD0, "COM_READY", "Waits until nothing is being sent to a device",
        { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, outside = { ", which is not in HWTYPE", "NO_MEMBER" } },
            { "NAME", IN, STRING, "name of the other device, empty: the brick's own adapter" } } },
    { 0xD1, "COM_READDATA", "Does nothing in the firmware; meant to receive data",
        { { "VALUE1", IN, DATA8, "carrier, ignored", enum = ENUMERATIONS.HWTYPE, outside = { ", which is not in HWTYPE", "NO_MEMBER" } },
            { "VALUE2", IN, DATA8, "name of the other device, ignored" }, { "VALUE3", IN, DATA16, "number of bytes, ignored", unit = "bytes" },
            { "VALUE4", IN, DATA8, "the bytes, ignored" } } },
    { 0xD2, "COM_WRITEDATA", "Does nothing in the firmware; meant to send data",
        { { "VALUE1", IN, DATA8, "carrier, ignored", enum = ENUMERATIONS.HWTYPE, outside = { ", which is not in HWTYPE", "NO_MEMBER" } },
            { "VALUE2", IN, DATA8, "name of the other device, ignored" }, { "VALUE3", IN, DATA16, "number of bytes, ignored", unit = "bytes" },
            { "VALUE4", IN, DATA8, "the bytes, ignored" } } },
    { 0xD3, "COM_GET", "Asks about the brick's connections and the devices around it",
        commands = {
            { 1, "GET_ON_OFF", "Reports whether Bluetooth or WiFi is on",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, range = { 2, 3 }, is_ranged = true,
                        outside = { ", outside of 2 to 3", "OUTSIDE" } },
                    { "ACTIVE", OUT, DATA8, "whether it is on", special = { [0] = "off", [1] = "on" }, range = { 0, 1 } } } },
            { 2, "GET_VISIBLE", "Reports whether other devices can see the brick by Bluetooth",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, range = { 1, 3 }, is_ranged = true,
                        outside = { ", outside of 1 to 3", "OUTSIDE" } },
                    { "VISIBLE", OUT, DATA8, "whether it is visible", special = { [0] = "no", [1] = "yes" }, range = { 0, 1 } } } },
            { 4, "GET_RESULT", "Reports the state of a search or connection request",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, range = { 2, 3 }, is_ranged = true,
                        outside = { ", outside of 2 to 3", "OUTSIDE" } },
                    { "ITEM", IN, DATA8, "place in the list, ignored by the firmware" },
                    { "RESULT", OUT, DATA8, "state of the request", enum = ENUMERATIONS.RESULT } } },
            { 5, "GET_PIN", "Reads the PIN for a device, always 1234",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, outside = { ", which is not in HWTYPE", "NO_MEMBER" } },
                    { "NAME", IN, STRING, "name of the other device or network" },
                    { "LENGTH", IN, DATA8, "size of the PIN's buffer, including the zero", unit = "bytes" },
                    { "PINCODE", OUT, STRING, "the PIN", length = "LENGTH" } } },
            { 7, "LIST_STATE", "Reads a counter that changes when a device enters or leaves a list",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, outside = { ", which is not in HWTYPE", "NO_MEMBER" } },
                    { "STATE", OUT, DATA16, "number to compare with the one of the last call" } },
                dialects = { compat = true } },
            { 8, "SEARCH_ITEMS", "Counts the devices or networks that a search found",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, range = { 2, 3 }, is_ranged = true,
                        outside = { ", outside of 2 to 3", "OUTSIDE" } },
                    { "ITEMS", OUT, DATA8, "number of entries in the list" } } },
            { 9, "SEARCH_ITEM", "Describes one device or network that a search found",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, outside = { ", which is not in HWTYPE", "NO_MEMBER" } },
                    { "ITEM", IN, DATA8, "place in the list, counted from 0" },
                    { "LENGTH", IN, DATA8, "size of the text buffer, including the zero", unit = "bytes",
                        special = { [-1] = "unlimited (handles only)" } },
                    { "NAME", OUT, STRING, "name of the other device or network", length = "LENGTH" },
                    { "PAIRED", OUT, DATA8, "whether it is paired (Bluetooth) or known (WiFi)", special = { [0] = "no", [1] = "yes" },
                        range = { 0, 1 } },
                    { "CONNECTED", OUT, DATA8, "whether it is connected", special = { [0] = "no", [1] = "yes" }, range = { 0, 1 } },
                    { "TYPE", OUT, DATA8, "kind of device (Bluetooth) or encryption (WiFi)", enum = ENUMERATIONS.BTTYPE,
                        special = { [0] = "WiFi, not encrypted", [1] = "WiFi, WPA2" } },
                    { "VISIBLE", OUT, DATA8, "whether it is in range", special = { [0] = "no", [1] = "yes" }, range = { 0, 1 } } } },
            { 10, "FAVOUR_ITEMS", "Counts the paired devices, in range or not",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, range = { 2, 2 }, is_ranged = true,
                        outside = { ", outside of 2 to 2", "OUTSIDE" } },
                    { "ITEMS", OUT, DATA8, "number of entries in the list" } } },
            { 11, "FAVOUR_ITEM", "Describes one paired device or known network",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, outside = { ", which is not in HWTYPE", "NO_MEMBER" } },
                    { "ITEM", IN, DATA8, "place in the list, counted from 0" },
                    { "LENGTH", IN, DATA8, "size of the text buffer, including the zero", unit = "bytes",
                        special = { [-1] = "unlimited (handles only)" } },
                    { "NAME", OUT, STRING, "name of the other device or network", length = "LENGTH" },
                    { "PAIRED", OUT, DATA8, "whether it is paired (Bluetooth) or known (WiFi)", special = { [0] = "no", [1] = "yes" },
                        range = { 0, 1 } },
                    { "CONNECTED", OUT, DATA8, "whether it is connected", special = { [0] = "no", [1] = "yes" }, range = { 0, 1 } },
                    { "TYPE", OUT, DATA8, "kind of device (Bluetooth) or encryption (WiFi)", enum = ENUMERATIONS.BTTYPE,
                        special = { [0] = "WiFi, not encrypted", [1] = "WiFi, WPA2" } } } },
            { 12, "GET_ID", "Reads the brick's Bluetooth address",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, range = { 2, 2 }, is_ranged = true,
                        outside = { ", outside of 2 to 2", "OUTSIDE" } },
                    { "LENGTH", IN, DATA8, "size of the text buffer, including the zero", unit = "bytes",
                        special = { [-1] = "unlimited (handles only)" } },
                    { "STRING", OUT, STRING, "12 hex digits", length = "LENGTH" } } },
            { 13, "GET_BRICKNAME", "Reads the brick's name",
                { { "LENGTH", IN, DATA8, "size of the text buffer, including the zero", unit = "bytes",
                        special = { [-1] = "unlimited (handles only)" } },
                    { "NAME", OUT, STRING, "name of the brick", length = "LENGTH" } } },
            { 14, "GET_NETWORK", "Reads network name and addresses, WiFi only",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, outside = { ", which is not in HWTYPE", "NO_MEMBER" } },
                    { "LENGTH", IN, DATA8, "buffer size for each of the three texts, including the zero", unit = "bytes",
                        special = { [-1] = "unlimited (handles only)" } },
                    { "NAME", OUT, STRING, "name of the network, NONE without one", length = "LENGTH" },
                    { "MAC", OUT, STRING, "MAC address of the brick, ?? when WiFi is off", length = "LENGTH", most = 17 },
                    { "IP", OUT, STRING, "IP address of the brick, ?? when not connected", length = "LENGTH", most = 15 } } },
            { 15, "GET_PRESENT", "Reports whether the hardware is present (for WiFi: a known dongle)",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, outside = { ", which is not in HWTYPE", "NO_MEMBER" } },
                    { "OK", OUT, DATA8, "whether it is present", special = { [0] = "no", [1] = "yes" }, range = { 0, 1 } } } },
            { 16, "GET_ENCRYPT", "Reports the encryption of a network, WiFi only",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, range = { 3, 3 }, is_ranged = true,
                        outside = { ", outside of 3 to 3", "OUTSIDE" } },
                    { "ITEM", IN, DATA8, "place in the list, counted from 0" },
                    { "TYPE", OUT, DATA8, "kind of encryption; always none in the 2013 firmware", enum = ENUMERATIONS.ENCRYPT } } },
            { 17, "CONNEC_ITEMS", "Counts the connected devices, Bluetooth only",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, range = { 1, 3 }, is_ranged = true,
                        outside = { ", outside of 1 to 3", "OUTSIDE" } },
                    { "ITEMS", OUT, DATA8, "number of entries in the list" } } },
            { 18, "CONNEC_ITEM", "Describes one connected device, Bluetooth only",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, outside = { ", which is not in HWTYPE", "NO_MEMBER" } },
                    { "ITEM", IN, DATA8, "place in the list, counted from 0" },
                    { "LENGTH", IN, DATA8, "size of the text buffer, including the zero", unit = "bytes",
                        special = { [-1] = "unlimited (handles only)" } },
                    { "NAME", OUT, STRING, "name of the device", length = "LENGTH" },
                    { "TYPE", OUT, DATA8, "kind of device", enum = ENUMERATIONS.BTTYPE } } },
            { 19, "GET_INCOMING", "Reports which device asks for a connection, Bluetooth only",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, range = { 2, 2 }, is_ranged = true,
                        outside = { ", outside of 2 to 2", "OUTSIDE" } },
                    { "LENGTH", IN, DATA8, "size of the text buffer, including the zero", unit = "bytes",
                        special = { [-1] = "unlimited (handles only)" } },
                    { "NAME", OUT, STRING, "name of the device", length = "LENGTH" },
                    { "TYPE", OUT, DATA8, "kind of device", enum = ENUMERATIONS.BTTYPE } } },
            { 20, "GET_MODE2", "Reports whether Bluetooth is in its mode for Apple devices",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, range = { 2, 2 }, is_ranged = true,
                        outside = { ", outside of 2 to 2", "OUTSIDE" } },
                    { "ACTIVE", OUT, DATA8, "whether it is on", special = { [0] = "off", [1] = "on" }, range = { 0, 1 } } } },
        } },
    { 0xD4, "COM_SET", "Changes the brick's name, its connections and its lists of devices",
        commands = {
            { 1, "SET_ON_OFF", "Switches Bluetooth or WiFi on or off",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, range = { 2, 3 }, is_ranged = true,
                        outside = { ", outside of 2 to 3", "OUTSIDE" } },
                    { "ACTIVE", IN, DATA8, "whether to switch it on", special = { [0] = "off", [1] = "on" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } } } },
            { 2, "SET_VISIBLE", "Makes the brick visible or invisible, Bluetooth only",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, outside = { ", which is not in HWTYPE", "NO_MEMBER" } },
                    { "VISIBLE", IN, DATA8, "whether other devices can see it", special = { [0] = "invisible", [1] = "visible" },
                        range = { 0, 1 }, outside = { ", outside of 0 to 1", "OUTSIDE" } } } },
            { 3, "SET_SEARCH", "Starts or stops the search for devices or networks",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, range = { 2, 3 }, is_ranged = true,
                        outside = { ", outside of 2 to 3", "OUTSIDE" } },
                    { "SEARCH", IN, DATA8, "whether to search", special = { [0] = "stop (Bluetooth only)", [1] = "start" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } } } },
            { 5, "SET_PIN", "Answers the request for a PIN (Bluetooth) or stores a network's password (WiFi)",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, range = { 2, 3 }, is_ranged = true,
                        outside = { ", outside of 2 to 3", "OUTSIDE" } },
                    { "NAME", IN, STRING, "name of the other device or network" }, { "PINCODE", IN, STRING, "PIN or password" } } },
            { 6, "SET_PASSKEY", "Answers the request to confirm a passkey, Bluetooth only",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, range = { 2, 2 }, is_ranged = true,
                        outside = { ", outside of 2 to 2", "OUTSIDE" } },
                    { "ACCEPT", IN, DATA8, "the answer", special = { [0] = "reject", [1] = "accept" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } } } },
            { 7, "SET_CONNECTION", "Connects a device or network, or ends a Bluetooth connection",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, range = { 2, 3 }, is_ranged = true,
                        outside = { ", outside of 2 to 3", "OUTSIDE" } },
                    { "NAME", IN, STRING, "name of the other device or network" },
                    { "CONNECTION", IN, DATA8, "what to do", special = { [0] = "disconnect", [1] = "connect" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } } } },
            { 8, "SET_BRICKNAME", "Renames the brick", { { "NAME", IN, STRING, "new name, at most 118 characters, else refused", most = 118 } } },
            { 9, "SET_MOVEUP", "Moves a network up in the list, WiFi only",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, range = { 3, 3 }, is_ranged = true,
                        outside = { ", outside of 3 to 3", "OUTSIDE" } },
                    { "ITEM", IN, DATA8, "place in the list, counted from 0" } } },
            { 10, "SET_MOVEDOWN", "Moves a network down in the list, WiFi only",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, range = { 3, 3 }, is_ranged = true,
                        outside = { ", outside of 3 to 3", "OUTSIDE" } },
                    { "ITEM", IN, DATA8, "place in the list, counted from 0" } } },
            { 11, "SET_ENCRYPT", "Sets the encryption of a network, WiFi only",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, range = { 3, 3 }, is_ranged = true,
                        outside = { ", outside of 3 to 3", "OUTSIDE" } },
                    { "ITEM", IN, STRING, "name of the network" },
                    { "ENCRYPT", IN, DATA8, "kind of encryption", enum = ENUMERATIONS.ENCRYPT,
                        outside = { ", which is not in ENCRYPT", "NO_MEMBER" } } } },
            { 12, "SET_SSID", "Adds a network to the end of the list, WiFi only",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, range = { 3, 3 }, is_ranged = true,
                        outside = { ", outside of 3 to 3", "OUTSIDE" } },
                    { "NAME", IN, STRING, "name of the network" } } },
            { 13, "SET_MODE2", "Switches the Bluetooth mode for Apple devices on or off",
                { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, range = { 2, 2 }, is_ranged = true,
                        outside = { ", outside of 2 to 2", "OUTSIDE" } },
                    { "ACTIVE", IN, DATA8, "whether to switch it on", special = { [0] = "off", [1] = "on" }, range = { 0, 1 },
                        outside = { ", outside of 0 to 1", "OUTSIDE" } } } },
        } },
    { 0xD5, "COM_TEST", "Reports whether something is still being sent to a device",
        { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, outside = { ", which is not in HWTYPE", "NO_MEMBER" } },
            { "NAME", IN, STRING, "name of the other device, empty: the brick's own adapter" },
            { "BUSY", OUT, DATA8, "whether to wait", special = { [0] = "ready", [1] = "busy" }, range = { 0, 1 } } } },
    { 0xD6, "COM_REMOVE", "Forgets a paired device or a known network",
        { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, outside = { ", which is not in HWTYPE", "NO_MEMBER" } },
            { "REMOTE_NAME", IN, STRING, "name of the other device or network" } } },
    { 0xD7, "COM_WRITEFILE", "Sends a file or a folder to another brick, Bluetooth only",
        { { "HARDWARE", IN, DATA8, "carrier to use", enum = ENUMERATIONS.HWTYPE, outside = { ", which is not in HWTYPE", "NO_MEMBER" } },
            { "REMOTE_NAME", IN, STRING, "name of the other device or network" },
            { "FILE_NAME", IN, STRING, "path of the file or folder on this brick" },
            { "FILE_TYPE", IN, DATA8, "TYPE_FOLDER for a folder, else a file", enum = ENUMERATIONS.FILETYPE,
                outside = { ", which is not in FILETYPE", "NO_MEMBER" } } } },
    { 0xD8, "MAILBOX_OPEN", "Opens a mailbox on this brick, at most 250 bytes of content",
        { { "NO", IN, DATA8, "number of the mailbox on this brick", range = { 0, 29 }, outside = { ", outside of 0 to 29", "OUTSIDE" } },
            { "BOXNAME", IN, STRING, "name of the mailbox", most = 49 },
            { "TYPES", IN, DATA8, "type of its values", enum = ENUMERATIONS.DATA_FORMAT,
                outside = { ", which is not in DATA_FORMAT", "NO_MEMBER" } },
            { "FIFOSIZE", IN, DATA8, "depth of the queue, ignored by the firmware" },
            { "VALUES", IN, DATA8, "number of values, ignored by the firmware" } } },
    { 0xD9, "MAILBOX_WRITE", "Sends values to a mailbox of another brick, Bluetooth only",
        { { "BRICKNAME", IN, STRING, "name of the other brick, empty: all connected ones" },
            { "HARDWARE", IN, DATA8, "read by the firmware and never used", enum = ENUMERATIONS.HWTYPE, special = { [0] = "as compilers write" },
                outside = { ", which is not in HWTYPE", "NO_MEMBER" } },
            { "BOXNAME", IN, STRING, "name of the mailbox", most = 49 },
            { "TYPE", IN, DATA8, "type of the values", enum = ENUMERATIONS.DATA_FORMAT,
                outside = { ", which is not in DATA_FORMAT", "NO_MEMBER" } },
            { "VALUES", IN, COUNT, "number of values of TYPE follow; exactly one for a string, of at most 249 characters", element = "TYPE",
                elements = IN, most = 249 } } },
    { 0xDA, "MAILBOX_READ", "Reads the content of a mailbox and marks it read",
        { { "NO", IN, DATA8, "number of the mailbox on this brick", range = { 0, 29 }, outside = { ", outside of 0 to 29", "OUTSIDE" } },
            { "LENGTH", IN, DATA8, "maximum number of bytes to read, ignored by the firmware", unit = "bytes" },
            { "VALUES", IN, COUNT, "number of values that follow, in the type of MAILBOX_OPEN", element = ARRAY_TYPED, elements = OUT } } },
    { 0xDB, "MAILBOX_TEST", "Reports whether a mailbox has an unread message",
        { { "NO", IN, DATA8, "number of the mailbox on this brick", range = { 0, 29 }, outside = { ", outside of 0 to 29", "OUTSIDE" } },
            { "BUSY", OUT, DATA8, "whether to wait", special = { [0] = "a new message is there", [1] = "nothing new" }, range = { 0, 1 } } } },
    { 0xDC, "MAILBOX_READY", "Waits for an unread message in a mailbox",
        { { "NO", IN, DATA8, "number of the mailbox on this brick", range = { 0, 29 }, outside = { ", outside of 0 to 29", "OUTSIDE" } } } },
    { 0xDD, "MAILBOX_CLOSE", "Closes a mailbox on this brick",
        { { "NO", IN, DATA8, "number of the mailbox on this brick", range = { 0, 29 }, outside = { ", outside of 0 to 29", "OUTSIDE" } } } },
    { 0xE5, "MAILBOX_SIZE", "Returns the size of a mailbox's content",
        { { "NO", IN, DATA8, "number of the mailbox on this brick", range = { 0, 29 }, outside = { ", outside of 0 to 29", "OUTSIDE" } },
            { "SIZE", OUT, DATA8, "size of the content", unit = "bytes" } },
        dialects = { xtended = true, compat = true } },
}
for _, row in ipairs(OPERATIONS) do
    NAMES.opcodes[row[1]] = NAMES.opcodes[row[1]] or row[2]
end

-- Readings -----------------------------------------------------------------------------------------------------------
--
-- What devices measure, by type and mode: name and unit of each value. Raw values are in the unit where this
-- `agrees`.

local READINGS = {
    [1] = { [0] = { { "pressed" } }, [1] = { { "bumps" }, agrees = true } },
    [2] = { [0] = { { "reflected light", "%" } }, [1] = { { "ambient light", "%" } } },
    [3] = { [0] = { { "loudness", "%" } }, [1] = { { "loudness", "%" } } },
    [4] = { [0] = { { "reflected light", "%" } }, [1] = { { "ambient light", "%" } }, [2] = { { "colour" }, agrees = true },
        [3] = { { "reflected light", "%" } }, [4] = { { "reflected light", "%" } },
        [5] = { { "red" }, { "green" }, { "blue" }, { "ambient light" }, agrees = true } },
    [5] = { [0] = { { "distance", "cm" }, agrees = true }, [1] = { { "distance", "inches" } } },
    [6] = { [0] = { { "temperature", "°C" } }, [1] = { { "temperature", "°F" } } },
    [7] = { [0] = { { "angle", "degrees" }, agrees = true }, [1] = { { "angle", "rotations" } }, [2] = { { "speed", "%" }, agrees = true } },
    [8] = { [0] = { { "angle", "degrees" }, agrees = true }, [1] = { { "angle", "rotations" } }, [2] = { { "speed", "%" }, agrees = true } },
    [16] = { [0] = { { "pressed" } }, [1] = { { "bumps" }, agrees = true } },
    [29] = { [0] = { { "reflected light", "%" }, agrees = true }, [1] = { { "ambient light", "%" }, agrees = true },
        [2] = { { "colour" }, agrees = true }, [4] = { { "red" }, { "green" }, { "blue" }, agrees = true } },
    [30] = { [0] = { { "distance", "cm" } }, [1] = { { "distance", "inches" } }, [2] = { { "other sensor heard" }, agrees = true },
        [3] = { { "distance", "cm" } }, [4] = { { "distance", "inches" } }, [5] = { { "distance", "cm" } },
        [6] = { { "distance", "inches" } } },
    [32] = { [0] = { { "angle", "degrees" }, agrees = true }, [1] = { { "rate", "degrees/s" }, agrees = true },
        [3] = { { "angle", "degrees" }, { "rate", "degrees/s" }, agrees = true } },
    [33] = { [0] = { { "distance", "%" }, agrees = true },
        [1] = { { "heading on channel 1" }, { "distance on channel 1", "%" }, { "heading on channel 2" }, { "distance on channel 2", "%" },
            { "heading on channel 3" }, { "distance on channel 3", "%" }, { "heading on channel 4" }, { "distance on channel 4", "%" },
            agrees = true },
        [2] = { { "buttons on channel 1" }, { "buttons on channel 2" }, { "buttons on channel 3" }, { "buttons on channel 4" }, agrees = true },
        [3] = { { "buttons" }, agrees = true } },
    [99] = { [0] = { { "input voltage", "V" } }, [1] = { { "input current", "A" } }, [2] = { { "output voltage", "V" } },
        [3] = { { "output current", "A" } }, [4] = { { "energy", "J" }, agrees = true }, [5] = { { "input power", "W" } },
        [6] = { { "output power", "W" } },
        [7] = { { "input voltage", "V" }, { "input current", "A" }, { "output voltage", "V" }, { "output current", "A" }, { "energy", "J" },
            { "input power", "W" }, { "output power", "W" } } },
}

-- System commands ----------------------------------------------------------------------------------------------------
--
-- Request and reply have fields; statuses are the meanings of those other than SUCCESS.

local SYSTEM_COMMANDS = {
    [0x92] = { name = "BEGIN_DOWNLOAD", text = "Opens a file on the brick for writing and announces its size",
        request = { { name = "size", kind = U32, filter = "file_len" }, { name = "path", kind = TEXT, filter = "file_name" },
            { name = "data", kind = BYTES, filter = "data", optional = true } },
        reply = { { name = "handle", kind = U8, filter = "handle" } }, transfer = "begin", is_long = true, has_data = true,
        statuses = { [8] = "the file is complete: its size is 0, or this frame held all of it",
            [1] = "the file cannot be created: it is a folder, or the file system refuses the name",
            [9] = "there is not enough room for a file of that size, or the frame had more data than announced",
            [4] = "all handles are in use: earlier files were neither completed nor closed" } },
    [0x93] = { name = "CONTINUE_DOWNLOAD", text = "Writes the next piece of a file; the file closes itself when it is complete",
        request = { { name = "handle", kind = U8, filter = "handle" }, { name = "data", kind = BYTES, filter = "data" } },
        reply = { { name = "handle", kind = U8, filter = "handle" } }, transfer = "continue", is_long = true, has_data = true,
        statuses = { [8] = "the file is now complete and closed; bytes beyond its size are dropped",
            [1] = "no file is open under that handle: it is complete, closed, or was never opened",
            [10] = "the handle is known, but its file is not open" } },
    [0x94] = { name = "BEGIN_UPLOAD", text = "Opens a file on the brick for reading and fetches its first piece",
        request = { { name = "max_bytes", kind = U16, filter = "max_bytes" }, { name = "path", kind = TEXT, filter = "file_name" } },
        reply = { { name = "size", kind = U32, filter = "file_len" }, { name = "handle", kind = U8, filter = "handle" },
            { name = "data", kind = BYTES, filter = "data" } },
        transfer = "begin", statuses = { [8] = "this reply holds the whole file", [1] = "no such file", [4] = "all handles are in use" } },
    [0x95] = { name = "CONTINUE_UPLOAD", text = "Fetches the next piece of a file",
        request = { { name = "handle", kind = U8, filter = "handle" }, { name = "max_bytes", kind = U16, filter = "max_bytes" } },
        reply = { { name = "handle", kind = U8, filter = "handle" }, { name = "data", kind = BYTES, filter = "data" } },
        transfer = "continue",
        statuses = { [8] = "that was the last piece of the file", [2] = "the handle is known, but its file is not open",
            [1] = "no file is open under that handle" } },
    [0x96] = { name = "BEGIN_GETFILE", text = "Opens a file that may still be growing, such as a data log, and fetches its first piece",
        request = { { name = "max_bytes", kind = U16, filter = "max_bytes" }, { name = "path", kind = TEXT, filter = "file_name" } },
        reply = { { name = "size", kind = U32, filter = "file_len" }, { name = "handle", kind = U8, filter = "handle" },
            { name = "data", kind = BYTES, filter = "data" } },
        transfer = "begin",
        statuses = { [8] = "this reply holds all that the file has so far", [2] = "no such file", [1] = "all handles are in use" } },
    [0x97] = { name = "CONTINUE_GETFILE", text = "Fetches the next piece of a file that may still be growing",
        request = { { name = "handle", kind = U8, filter = "handle" }, { name = "max_bytes", kind = U16, filter = "max_bytes" } },
        reply = { { name = "size", kind = U32, filter = "file_len" }, { name = "handle", kind = U8, filter = "handle" },
            { name = "data", kind = BYTES, filter = "data" } },
        transfer = "continue",
        statuses = { [8] = "that was the last of what the file has so far", [2] = "the handle is known, but its file is not open",
            [1] = "no file is open under that handle" } },
    [0x98] = { name = "CLOSE_FILEHANDLE", text = "Closes an open file before its end",
        request = { { name = "handle", kind = U8, filter = "handle" }, { name = "hash", kind = BYTES, filter = "hash", optional = true } },
        reply = { { name = "handle", kind = U8, filter = "handle", optional = true } }, transfer = "close", has_data = true,
        statuses = { [1] = "no file is open under that handle" } },
    [0x99] = { name = "LIST_FILES", text = "Lists a folder and fetches the first piece of the listing",
        request = { { name = "max_bytes", kind = U16, filter = "max_bytes" }, { name = "path", kind = TEXT, filter = "path_name" } },
        reply = { { name = "list_size", kind = U32, filter = "list_size" }, { name = "handle", kind = U8, filter = "handle" },
            { name = "list", kind = LISTING, filter = "list" } },
        transfer = "begin", statuses = { [8] = "this reply holds the whole listing", [10] = "no such folder, or no free handle" } },
    [0x9A] = { name = "CONTINUE_LIST_FILES", text = "Fetches the next piece of a listing",
        request = { { name = "handle", kind = U8, filter = "handle" }, { name = "max_bytes", kind = U16, filter = "max_bytes" } },
        reply = { { name = "handle", kind = U8, filter = "handle" }, { name = "list", kind = LISTING, filter = "list" } },
        transfer = "continue", statuses = { [8] = "that was the last piece of the listing", [10] = "the handle holds no listing" } },
    [0x9B] = { name = "CREATE_DIR", text = "Creates a folder", request = { { name = "path", kind = TEXT, filter = "path_name" } }, reply = {},
        statuses = { [5] = "it cannot be created: it exists, its parent does not, or permission is denied" } },
    [0x9C] = { name = "DELETE_FILE", text = "Deletes a file or an empty folder",
        request = { { name = "path", kind = TEXT, filter = "path_name" } }, reply = {},
        statuses = { [5] = "it cannot be removed: it does not exist, is not empty, or permission is denied" } },
    [0x9D] = { name = "LIST_OPEN_HANDLES", text = "Asks which file handles are in use", request = {},
        reply = { { name = "handles", kind = BYTES, filter = "handles" } }, statuses = {} },
    [0x9E] = { name = "WRITEMAILBOX", text = "Puts a message into a mailbox of the program that runs on the brick",
        request = { { name = "name_length", kind = U8, filter = "mailbox_length", counts = "name" },
            { name = "name", kind = COUNTED_TEXT, filter = "mailbox" },
            { name = "payload_length", kind = U16, filter = "payload_length", counts = "payload" },
            { name = "payload", kind = BYTES, filter = "payload", is_message = true } },
        reply = {}, has_data = true, has_message = true, statuses = {} },
    [0x9F] = { name = "BLUETOOTHPIN", text = "Sends the PIN for a Bluetooth device (USB only)",
        request = { { name = "mac_length", kind = U8, filter = "mac_length", counts = "mac" },
            { name = "mac", kind = COUNTED_TEXT, filter = "mac" },
            { name = "pin_length", kind = U8, filter = "pin_length", counts = "pin" },
            { name = "pin", kind = COUNTED_TEXT, filter = "pin" } },
        reply = { { name = "mac_length", kind = U8, filter = "mac_length", counts = "mac" },
            { name = "mac", kind = COUNTED_TEXT, filter = "mac" },
            { name = "pin_length", kind = U8, filter = "pin_length", counts = "pin" },
            { name = "pin", kind = COUNTED_TEXT, filter = "pin" } },
        statuses = { [12] = "this works by USB only" } },
    [0xA0] = { name = "ENTERFWUPDATE", text = "Restarts the brick into its firmware updater", request = {}, reply = {}, statuses = {} },
    [0xA1] = { name = "SETBUNDLEID", text = "Sets the bundle identifier that the brick shows to Apple devices",
        request = { { name = "id", kind = TEXT, filter = "id" } }, reply = {}, statuses = {} },
    [0xA2] = { name = "SETBUNDLESEEDID", text = "Sets the bundle seed identifier that the brick shows to Apple devices",
        request = { { name = "id", kind = TEXT, filter = "id" } }, reply = {}, statuses = {} },
    [0xF0] = { name = "BEGIN_DOWNLOAD_WITH_ERASE", text = "Erases a region of the flash memory and prepares to write it",
        request = { { name = "address", kind = U32, filter = "address", hexadecimal = true },
            { name = "image_size", kind = U32, filter = "image_size" } },
        reply = {}, is_bootloader = true, statuses = {} },
    [0xF1] = { name = "BEGIN_DOWNLOAD", text = "Prepares to write a region of the flash memory that is already erased",
        request = { { name = "address", kind = U32, filter = "address", hexadecimal = true },
            { name = "image_size", kind = U32, filter = "image_size" } },
        reply = {}, is_bootloader = true, statuses = {} },
    [0xF2] = { name = "DOWNLOAD_DATA", text = "Writes the next piece of the image",
        request = { { name = "data", kind = BYTES, filter = "data" } }, reply = {}, is_bootloader = true, has_data = true, statuses = {} },
    [0xF3] = { name = "CHIP_ERASE", text = "Erases the whole flash memory", request = {}, reply = {}, is_bootloader = true, statuses = {} },
    [0xF4] = { name = "START_APP", text = "Leaves the updater and starts the firmware", request = {}, reply = {}, is_bootloader = true,
        statuses = {} },
    [0xF5] = { name = "GET_CHECKSUM", text = "Asks for the checksum of a region of the flash memory",
        request = { { name = "address", kind = U32, filter = "address", hexadecimal = true },
            { name = "image_size", kind = U32, filter = "image_size" } },
        reply = { { name = "checksum", kind = U32, filter = "checksum", hexadecimal = true } }, is_bootloader = true, statuses = {} },
    [0xF6] = { name = "GET_VERSION", text = "Asks for the versions of hardware and firmware", request = {},
        reply = { { name = "hardware_version", kind = U32, filter = "hw_id", hexadecimal = true },
            { name = "firmware_version", kind = U32, filter = "fw_id", hexadecimal = true } },
        is_bootloader = true, statuses = {} },
}
for number, command in pairs(SYSTEM_COMMANDS) do
    NAMES.system_commands[number] = command.name
end

local STATUS = { names = { [0] = "SUCCESS", [1] = "UNKNOWN_HANDLE", [2] = "HANDLE_NOT_READY", [3] = "CORRUPT_FILE", [4] = "NO_HANDLES_AVAILABLE",
        [5] = "NO_PERMISSION", [6] = "ILLEGAL_PATH", [7] = "FILE_EXITS", [8] = "END_OF_FILE", [9] = "SIZE_ERROR", [10] = "UNKNOWN_ERROR",
        [11] = "ILLEGAL_FILENAME", [12] = "ILLEGAL_CONNECTION" },
    fails = { [0] = false, [1] = true, [2] = true, [3] = true, [4] = true, [5] = true, [6] = true, [7] = true, [8] = false, [9] = true,
        [10] = true, [11] = true, [12] = true },
    success = 0, end_of_file = 8 }

-- Daisy chain --------------------------------------------------------------------------------------------------------
--
-- Messages between bricks that are connected by USB.

local DAISY = { names = { [160] = "DOWNSTREAM", [161] = "UPSTREAM", [162] = "INFO", [163] = "UNLOCK_SLAVE", [164] = "SET_TYPE",
        [165] = "DOWNSTREAM_WITH_BUSY" },
    carries_operations = { [160] = true, [165] = true }, most_layers = 4,
    sensor_report = { { name = "layer", size = 1 }, { name = "port", size = 1 }, { name = "status", size = 1 }, { name = "type", size = 1 },
        { name = "mode", size = 1 }, { name = "data", size = 32 }, { name = "checksum", size = 1 }, { name = "busy" } },
    sensor_report_size = 38 }

-- Pairing ------------------------------------------------------------------------------------------------------------
--
-- When a reply answers a command; times are in nanoseconds.

local MOST_PER_COUNTER = 256
local PAIRING = { patience = 3, least = 50000000, first = 10000000000,
    unsure = "the pairing is unsure: several commands with its counter waited",
    other_size = "the command requests {asked} of memory, but this reply has {size}" }

-- Claims -------------------------------------------------------------------------------------------------------------
--
-- When traffic is claimed as this protocol.

local CLAIMS = { strange_packets = 3, replies = 2, most_held = 4, never_sent = 0, not_telling = { [2] = true, [3] = true, [12] = true },
    only_in_programs = { [4] = true, [5] = true, [6] = true, [7] = true, [8] = true, [9] = true, [10] = true, [11] = true, [13] = true,
        [14] = true, [15] = true, [64] = true },
    nxt_write = 33537, nxt_flag = 128, still_sent = { WHOLE = true, NAN_FLOAT = true, LONG = true } }
-- The range of each type.
local TYPE_RANGES = { DATA8 = { -127, 127, text = "DATA8, -127 to 127", named = "-127 to 127 as DATA8" },
    DATA16 = { -32767, 32767, text = "DATA16, -32767 to 32767", named = "-32767 to 32767 as DATA16" },
    DATA32 = { -2147483647, 2147483647, text = "DATA32, -2147483647 to 2147483647", named = "-2147483647 to 2147483647 as DATA32" },
    HANDLE = { -32767, 32767, text = "handle, -32767 to 32767", named = "-32767 to 32767 as handle" },
    ARRAY_TYPED = { -2147483647, 2147483647, text = "array-typed, -2147483647 to 2147483647", named = "-2147483647 to 2147483647 as array-typed" },
    LABEL = { -2147483647, 2147483647, text = "label, -2147483647 to 2147483647", named = "-2147483647 to 2147483647 as label" } }
-- The motors of each bit mask.
local PORT_SETS = { [0] = "none", [1] = "A", [2] = "B", [3] = "A+B", [4] = "C", [5] = "A+C", [6] = "B+C", [7] = "A+B+C", [8] = "D", [9] = "A+D",
    [10] = "B+D", [11] = "A+B+D", [12] = "C+D", [13] = "A+C+D", [14] = "B+C+D", [15] = "A+B+C+D" }
-- The numbers of labels for jumps; those of a LABEL include 0.
local LABELS = { 1, 31 }

-- Findings -----------------------------------------------------------------------------------------------------------
--
-- What is said of constants: code and words. The brick refuses those of REFUSED.

local FINDINGS = {
    NEVER_RUNS = { "E201", "{byte} is {owner}, which the firmware never runs" },
    REFUSED = { "E204", "{name} is {value}, but the brick accepts only {accepted} in a first parameter" },
    LABEL_NUMBER = { "E206", "{name} is {value}, but labels are 0 to 31" },
    TRUNCATED = { "E301", "{name} is {value}, which the brick truncates to {read}: it is a {type}" },
    WRITTEN = { "E302", "{name} is a constant, but the brick writes to it" },
    NUMBER = { "E303", "{name} is the number {value}, but the brick reads a text" },
    TEXT = { "E304", "{name} is a text, but the brick reads a {kind}" },
    WHOLE = { "E305", "{name} is the whole number {value}, but the brick reads its bits as a float" },
    LABEL = { "E307", "{byte} is LAB1, a label: the brick puts the place of label {value} here, not a number" },
    NEGATIVE = { "W301", "{name} is {value}, which the brick reads as {read}: it is a {type}" },
    NAN = { "W302", "{name} is {value}, which means \"not a number\"" },
    NAN_FLOAT = { "W302", "{name} is {value}, which means \"not a number\"" },
    OUTSIDE = { "W303", "{name} is {value}{outside}[; the brick reads it as {read}]" },
    MASK = { "W303", "{name} is {value}, the bit mask of {ports}, but it takes the number of one port" },
    NO_MEMBER = { "W304", "{name} is {value}{outside}[; the brick reads it as {read}]" },
    LABEL_BYTE = { "W305", "{byte} is LAB1, a label, but labels are 1 to 31: the brick takes this one as the number {read}" },
    LONG = { "E502", "{name} has {characters}; the firmware accepts at most {most}" },
    NO_PORTS = { "H702", "{name} is 0, a bit mask without a port, so {owner} does nothing" },
    MAILBOX_NAME = { "W804", "the name has {size} characters; that of a mailbox has at most 49" },
    MAILBOX_CONTENT = { "W804", "the message has {size} bytes, but a mailbox has room for only 250" },
    MISALIGNED = { "E205", "{name} is {variable}, and must start at a multiple of {step}" },
    BEYOND_global = { "E402", "{name} takes {bytes} of {scope} memory, but the header requests {asked} {scope} memory" },
    BEYOND_local = { "E401", "{name} takes {bytes} of {scope} memory, but the header requests {asked} {scope} memory" },
    UNKNOWN_TYPE = { "E105", "unknown message type {type}" },
    CUT_FRAME = { "E102", "the length field says that {stated} it, but there are {follow}" },
    EMPTY = { "E106", "the command has no operation" },
    NO_MEMORY = { "E106", "the command ends before the two bytes that request memory" },
    UNKNOWN_OPCODE = { "E201", "unknown opcode {byte} for the {dialect} firmware" },
    OTHER_DIALECT = { "E201", "{byte} is {known} in the dialects {others}, but not an opcode of {dialect} firmware" },
    UNRELEASED = { "E201", "{byte} is {known}, which is documented but not implemented by any firmware" },
    AFTER_END = { "E202", "the firmware refuses the command: {bytes} too many after the OBJECT_END at offset {end}" },
    CUT_OFF = { "E203", "{owner}: {reason}" },
    CUT_LIST = { "E203", "{name} says {values}, but only {bytes} follow" },
    SPINS = { "E207", "{name} is [{value}][{encoding}, which is not a number]: the brick reads millions of values before it does anything else" },
    UNKNOWN_CMD = { "E208",
        "{owner} has no CMD {value}[; the brick reads the next bytes as operations, and refuses the command at offset {refused_at}]" },
    VARIABLE_CMD = { "E209", "{reason}" },
    UNDEFINED_FORM = { "E210", "undefined identification byte {byte} for {name} of {owner}" },
    BAD_COUNT = { "E211",
        "{name} is [{value}][{encoding}, which is not a number][; the brick reads the next bytes as operations, and refuses the command at " ..
            "offset {refused_at}]" },
    UNKNOWN_SYSTEM = { "E801", "unknown system command {number}" },
    NO_SYSTEM = { "E801", "the frame ends before the number of the system command" },
    WRONG_FIELDS = { "E802", "{owner}: {reason}" },
    UNKNOWN_DAISY = { "E806", "{reason}" },
}
local FILES = { longer = "it has {size} bytes, but {done} were moved", incomplete = "{done} of {size} bytes were captured" }
local MOST_IN_MAILBOX = { MAILBOX_NAME = 49, MAILBOX_CONTENT = 250 }
local SLIPS = {
    length_self = "this is a frame whose length counts its own two bytes: it says {length}, the size of all that was sent; the brick takes " ..
        "{more} bytes of the next one",
    length_swapped = "this is a frame whose length has its high byte first: it says {length}, but {follow} bytes follow it",
    length = "the length field says that {length} bytes follow it, but there are {follow}",
    left_over = "the frame before ends here by its length field, {bytes} before the end of what was sent",
}
-- Why frames cannot be read.
local REASONS = {
    no_header = "a frame has at least 5 bytes (length, counter, type), this one has {size}",
    wrong_length = "the length field says {length}; it can be 3 to 1022",
    too_long = "the frame has {size} bytes; the maximum is 1024",
    cut_off = "the frame is cut off: its length field says that {length} bytes follow, but {size} do",
    longer = "the frame is longer than its length field says: {length} bytes should follow it, but {size} do",
    bootloader = "{reason}. From a brick on a USB 3 port this is a known fault of its bootloader: the reply to {name} with the request written " ..
        "over its first bytes",
    no_type = "unknown message type {byte}",
    two = "{reason}; and at offset {offset}: {inner}",
    direct_command = "the frame ends before the two bytes that request memory",
    system_command = "the frame ends before the system command",
    system_reply = "the frame ends before the command answered and the status",
    daisy_command = "the frame ends before the sub-command and the two layers",
    daisy_reply = "the frame ends before the two layers",
    no_system = "unknown system command {byte}",
    no_daisy = "unknown daisy sub-command {byte}",
    no_opcode = "unknown opcode {byte} for the {dialect} firmware",
    no_cmd = "{owner} has no CMD {value} (it has {known}, ...)",
    variable_cmd = "CMD of {owner} is {value}, but must be a constant",
    no_argument = "the frame ends before the argument {name}",
    no_form = "undefined identification byte {byte} (argument {name})",
    cut_string = "the string {name} runs past the end of the frame: its terminating zero is missing",
    cut_argument = "the argument {name} runs past the end of the frame: {form} needs {more}",
    no_count = "{name} must be a constant: it is the number of values that follow",
    no_room = "{name} cannot be {value}: there is room for 0 to {room} values",
    left_over = "{bytes} left over after the last field",
    wrong_count = "{counter} says {stated} bytes, but {size} follow to the end of the frame",
    cut_text = "a text of length {length} runs past the end of the frame",
    no_zero = "the terminating zero of a text is missing",
    other_zero = "a text of length {length} must end with a zero, not with {byte}",
    endless_text = "the text {name} runs past the end of the frame: its terminating zero is missing",
    no_field = "the frame ends before the field {name} ({kind})",
}
local REFUSED = { E204 = true, E206 = true }

-- USB and Bluetooth --------------------------------------------------------------------------------------------------
--
-- How a brick is recognised.

-- USB products are vendor and product in one number: the brick, and its bootloader.
local CARRIERS = { usb_products = { 0x06940005, 0x06940006 }, rfcomm_channel = 1, tcp_port = 5555, beacon_port = 3015,
    beacon_lines = { { name = "serial", label = "Serial-Number" }, { name = "port", label = "Port" }, { name = "name", label = "Name" },
        { name = "protocol", label = "Protocol" } },
    protocol = "EV3" }

-- WiFi ---------------------------------------------------------------------------------------------------------------
--
-- The texts before the first frame.

-- The text that unlocks the brick over WiFi, and its answer. By their lengths, frames start differently.
local UNLOCK = { patterns = { "^GET /target%?sn=([%w_:]*) ?VMTP1%.0(\r?\n)Protocol: ?EV3()", "^GET /target%?sn=([%w_:]*) ?(\r?\n)Protocol: ?EV3()" },
    request = "GET /target?sn=", most_bytes = 128, endings = 2, answer = "Accept:EV340\r\n\r\n",
    starts = { [71] = true, [65] = true },
    missing = "the connection begins without the unlock text (GET /target?sn=...): a brick ignores its commands" }

-- Names for filters --------------------------------------------------------------------------------------------------
--
-- Fields, besides those of parameters and system messages, and expert information.

local field = {
    bytes = ProtoField.bytes("ev3.bytes", "Bytes", base.NONE, "all bytes of a frame, or of a text between frames"),
    brick = ProtoField.string("ev3.brick", "Brick", "the brick that it goes to or comes from"),
    connection = ProtoField.uint32("ev3.connection", "Connection", base.DEC, nil, nil, "the number of its conversation in the capture, from 1"),
    length = ProtoField.uint16("ev3.msg_len", "Length", base.DEC, nil, nil, "bytes that follow this field"),
    counter = ProtoField.uint16("ev3.msg_num", "Message counter", base.DEC, nil, nil, "chosen by the sender, echoed in the reply"),
    type = ProtoField.uint8("ev3.cmd_type", "Type", base.HEX, NAMES.message_types),
    memory_sizes = ProtoField.uint16("ev3.vars", "Requested memory", base.HEX),
    globals = ProtoField.uint16("ev3.globals", "Global memory", base.UNIT_STRING, { " byte", " bytes" }, GLOBAL_MASK, "bytes of the reply's payload"),
    locals = ProtoField.uint16("ev3.locals", "Local memory", base.UNIT_STRING, { " byte", " bytes" }, LOCAL_MASK),
    opcode = ProtoField.uint8("ev3.op", "Opcode", base.HEX, NAMES.opcodes),
    cmd = ProtoField.string("ev3.cmd", "CMD", "opcode and CMD by name, such as SOUND.TONE"),
    encoding = ProtoField.string("ev3.argument.encoding", "Encoding", "how the argument is encoded"),
    variable = ProtoField.string("ev3.argument.variable", "Variable", "the variable that is used as an argument, such as GV(0)"),
    port_0 = ProtoField.bool("ev3.ports.a", "A", 8, nil, 0x01, "a motor in NOS"),
    port_1 = ProtoField.bool("ev3.ports.b", "B", 8, nil, 0x02, "a motor in NOS"),
    port_2 = ProtoField.bool("ev3.ports.c", "C", 8, nil, 0x04, "a motor in NOS"),
    port_3 = ProtoField.bool("ev3.ports.d", "D", 8, nil, 0x08, "a motor in NOS"),
    other = ProtoField.string("ev3.argument.value", "Value", "a constant whose type differs from its parameter's"),
    memory = ProtoField.bytes("ev3.memory", "Global memory"),
    answers = ProtoField.string("ev3.answers", "Answers", "the operation that these values of a reply belong to, such as UI_READ.GET_VBATT"),
    list = ProtoField.none("ev3.values", "Values"),
    system_command = ProtoField.uint8("ev3.sys_cmd", "System command", base.HEX, NAMES.system_commands),
    status = ProtoField.uint8("ev3.reply_status", "Status", base.HEX, STATUS.names),
    message_text = ProtoField.string("ev3.payload.text", "Text", "a mailbox's message as text"),
    message_number = ProtoField.float("ev3.payload.number", "Number", "a mailbox's message as a number"),
    message_logic = ProtoField.bool("ev3.payload.logic", "Logic", base.NONE, nil, 0, "a mailbox's message as true or false"),
    daisy_command = ProtoField.uint8("ev3.daisy.command", "Sub-command", base.HEX, DAISY.names),
    layer_from = ProtoField.uint8("ev3.daisy.layer_from", "From layer"),
    layer_to = ProtoField.uint8("ev3.daisy.layer_to", "To layer"),
    daisy_payload = ProtoField.bytes("ev3.daisy.payload", "Payload"),
    rest = ProtoField.bytes("ev3.rest", "Not read", base.SPACE, "bytes that could not be read"),
    padding = ProtoField.bytes("ev3.padding", "Padding", base.SPACE, "the unused rest of a USB report"),
    fragment = ProtoField.bytes("ev3.fragment", "Part of a frame", base.SPACE),
    fragment_of = ProtoField.framenum("ev3.fragment_of", "Frame complete in"),
    fragments = ProtoField.framenum("ev3.fragments", "Began in"),
    response_in = ProtoField.framenum("ev3.response_in", "Response in", base.NONE, frametype.RESPONSE),
    request_in = ProtoField.framenum("ev3.request_in", "Request in", base.NONE, frametype.REQUEST),
    response_time = ProtoField.relative_time("ev3.response_time", "Response time"),
    transfer_path = ProtoField.string("ev3.transfer.path", "File"),
    transfer_done = ProtoField.uint32("ev3.transfer.done", "Transferred", base.UNIT_STRING, { " byte", " bytes" }),
    transfer_size = ProtoField.uint32("ev3.transfer.size", "Size", base.UNIT_STRING, { " byte", " bytes" }),
    beacon_answer = ProtoField.bytes("ev3.beacon.answer", "Answer to a beacon", base.SPACE),
    unlock = ProtoField.string("ev3.unlock", "Unlock"),
    unlock_serial = ProtoField.string("ev3.unlock.serial", "Serial number"),
    accept = ProtoField.string("ev3.accept", "Accept"),
    beacon_serial = ProtoField.string("ev3.beacon.serial", "Serial-Number"),
    beacon_port = ProtoField.string("ev3.beacon.port", "Port"),
    beacon_name = ProtoField.string("ev3.beacon.name", "Name"),
    beacon_protocol = ProtoField.string("ev3.beacon.protocol", "Protocol"),
    system_file_len = ProtoField.uint32("ev3.file_len", "Size"),
    system_file_name = ProtoField.string("ev3.file_name", "Path"),
    system_data = ProtoField.bytes("ev3.data", "Data"),
    system_handle = ProtoField.uint8("ev3.handle", "Handle"),
    system_max_bytes = ProtoField.uint16("ev3.max_bytes", "Max bytes"),
    system_hash = ProtoField.bytes("ev3.hash", "Hash"),
    system_path_name = ProtoField.string("ev3.path_name", "Path"),
    system_list_size = ProtoField.uint32("ev3.list_size", "List size"),
    system_list = ProtoField.string("ev3.list", "List"),
    system_handles = ProtoField.bytes("ev3.handles", "Handles"),
    system_mailbox_length = ProtoField.uint8("ev3.mailbox_length", "Name length"),
    system_mailbox = ProtoField.string("ev3.mailbox", "Name"),
    system_payload_length = ProtoField.uint16("ev3.payload_length", "Payload length"),
    system_payload = ProtoField.bytes("ev3.payload", "Payload"),
    system_mac_length = ProtoField.uint8("ev3.mac_length", "Mac length"),
    system_mac = ProtoField.string("ev3.mac", "Mac"),
    system_pin_length = ProtoField.uint8("ev3.pin_length", "Pin length"),
    system_pin = ProtoField.string("ev3.pin", "Pin"),
    system_id = ProtoField.string("ev3.id", "Id"),
    system_address = ProtoField.uint32("ev3.address", "Address", base.HEX),
    system_image_size = ProtoField.uint32("ev3.image_size", "Image size"),
    system_checksum = ProtoField.uint32("ev3.checksum", "Checksum", base.HEX),
    system_hw_id = ProtoField.uint32("ev3.hw_id", "Hardware version", base.HEX),
    system_fw_id = ProtoField.uint32("ev3.fw_id", "Firmware version", base.HEX),
    daisy_layer = ProtoField.uint8("ev3.daisy.layer", "layer"),
    daisy_port = ProtoField.uint8("ev3.daisy.port", "port"),
    daisy_status = ProtoField.uint8("ev3.daisy.status", "status"),
    daisy_type = ProtoField.uint8("ev3.daisy.type", "type"),
    daisy_mode = ProtoField.uint8("ev3.daisy.mode", "mode"),
    daisy_data = ProtoField.bytes("ev3.daisy.data", "data"),
    daisy_checksum = ProtoField.uint8("ev3.daisy.checksum", "checksum"),
    daisy_busy = ProtoField.bytes("ev3.daisy.busy", "busy"),
}
local experts = {
    fault = ProtoExpert.new("ev3.expert.fault", "Faulty frame", expert.group.MALFORMED, expert.severity.ERROR),
    unknown_opcode = ProtoExpert.new("ev3.expert.unknown_opcode", "Unknown opcode", expert.group.MALFORMED, expert.severity.ERROR),
    unknown_cmd = ProtoExpert.new("ev3.expert.unknown_cmd", "Unknown CMD", expert.group.MALFORMED, expert.severity.ERROR),
    cut_off = ProtoExpert.new("ev3.expert.cut_off", "Cut off", expert.group.MALFORMED, expert.severity.ERROR),
    cut_by_capture = ProtoExpert.new("ev3.expert.cut_by_capture", "Cut by the capture", expert.group.UNDECODED, expert.severity.NOTE),
    misaligned = ProtoExpert.new("ev3.expert.misaligned", "Misaligned variable", expert.group.PROTOCOL, expert.severity.ERROR),
    beyond_memory = ProtoExpert.new("ev3.expert.beyond_memory", "Variable beyond the requested memory", expert.group.PROTOCOL, expert.severity.WARN),
    refused = ProtoExpert.new("ev3.expert.refused", "Argument that the brick refuses", expert.group.PROTOCOL, expert.severity.ERROR),
    misread = ProtoExpert.new("ev3.expert.misread", "Value that the brick misreads, or that is not documented", expert.group.PROTOCOL, expert.severity.WARN),
    no_boundary = ProtoExpert.new("ev3.expert.no_boundary", "No frame starts here", expert.group.MALFORMED, expert.severity.ERROR),
    error_reply = ProtoExpert.new("ev3.expert.error_reply", "The brick refused the command, or it failed", expert.group.RESPONSE_CODE, expert.severity.WARN),
    failed = ProtoExpert.new("ev3.expert.failed", "The command failed", expert.group.RESPONSE_CODE, expert.severity.WARN),
    orphan = ProtoExpert.new("ev3.expert.orphan", "The command that this reply answers was not seen", expert.group.SEQUENCE, expert.severity.NOTE),
    locked = ProtoExpert.new("ev3.expert.locked", "A connection without the unlock text", expert.group.SEQUENCE, expert.severity.WARN),
    unanswered = ProtoExpert.new("ev3.expert.unanswered", "No reply to this command was seen", expert.group.SEQUENCE, expert.severity.WARN),
    waiting = ProtoExpert.new("ev3.expert.waiting", "No reply to this command was seen so far", expert.group.SEQUENCE, expert.severity.NOTE),
    incomplete_file = ProtoExpert.new("ev3.expert.incomplete_file", "A file with another size than announced", expert.group.SEQUENCE, expert.severity.WARN),
    unsure = ProtoExpert.new("ev3.expert.unsure", "The pairing is unsure", expert.group.SEQUENCE, expert.severity.NOTE),
    other_size = ProtoExpert.new("ev3.expert.other_size", "Another size than the command requests", expert.group.PROTOCOL, expert.severity.WARN),
    bootloader_fault = ProtoExpert.new("ev3.expert.bootloader_fault", "Bootloader fault on USB 3", expert.group.PROTOCOL, expert.severity.ERROR),
}

-- Fields ------------------------------------------------------------------------------------------------------------
--
-- Every value in a frame is a field for filters. Fields of operations have the firmware's names:
-- ev3.<opcode>.<cmd>.<parameter>, in lower case.

local byte, find, format, gsub, sub = string.byte, string.find, string.format, string.gsub, string.sub
local concat, floor = table.concat, math.floor

-- The same for Decode As, without the rule of Claims below.
local ev3_all = Proto("EV3_all", "EV3 (all of it)")

local fields = {}

for _, declared in pairs(field) do fields[#fields + 1] = declared end

-- Whether the bytes of each frame are added as a field, for programs that read the output.
local gives_bytes = false

-- Returns the text of a hardware or IP address. Wireshark's own has a name where it knows one, as of LEGO's block, and
-- has no other access to the bytes: they are found by comparing.
local plain_address
do
    local KINDS = {
        { make = Address.ether, parts = 6, form = "%02x", between = ":" },
        { make = Address.ip, parts = 4, form = "%d", between = "." },
    }
    local known = {}

    local function found(address, kind)
        local bytes = {}
        for index = 1, kind.parts do bytes[index] = format(kind.form, 0) end
        for index = 1, kind.parts do
            local value = 0
            for bit = 7, 0, -1 do
                bytes[index] = format(kind.form, value + 2 ^ bit)
                if kind.make(concat(bytes, kind.between)) <= address then value = value + 2 ^ bit end
            end
            bytes[index] = format(kind.form, value)
        end
        local text = concat(bytes, kind.between)
        return kind.make(text) == address and text
    end

    function plain_address(address)
        local shown = tostring(address)
        if not known[shown] then
            known[shown] = find(shown, "^[%x:%.]*$") and shown or found(address, KINDS[1]) or found(address, KINDS[2])
        end
        return known[shown] or shown
    end
end

-- Adds the item of a frame, or of a text around frames. Without `said` its text comes later. `brick` is the name of the
-- packet's brick; functions that show its parts get it, false without a tree.
local add_item
do
    -- Looking up methods of items takes time; frequent ones are local.
    local add, set_generated, brick_field = TreeItem.add, TreeItem.set_generated, field.brick

    function add_item(tree, range, brick, said)
        local item = said and add(tree, ev3, range, "EV3: " .. said) or add(tree, ev3, range)
        if brick then set_generated(add(item, brick_field, brick)) end
        if gives_bytes then add(item, field.bytes, range) end
        return item
    end
end

-- The kinds of values in fields.
local NUMBER, FLOAT, TEXT_VALUE = "number", "float", "text"

-- Adds expert information. Wireshark also collects it without a tree: then `item` is the root.
local add_expert_info = TreeItem.add_proto_expert_info
local function complain(item, kind, text)
    add_expert_info(item, experts[kind], text)
end

-- The instruction set, made ready -----------------------------------------------------------------------------------
--
-- The tables above are written for people. Here they become tables for reading arguments. Wireshark needs all fields at
-- startup; an operation gets its parameters when it is first seen, because a capture uses few operations, and the
-- garbage collector visits everything repeatedly.

-- Returns a table whose entries are made on first use.
local function made_late(make)
    return setmetatable({}, { __index = function(made, key)
        local entry = make(key)
        if entry then made[key] = entry end
        return entry
    end })
end

local INSTRUCTION_SETS, prepare_operation
do
    local PARAMETER_KINDS = { [DATAF] = FLOAT, [STRING] = TEXT_VALUE }

    -- Tells whether the tables allow no negative number for a parameter.
    local function is_natural(row)
        for value in pairs(row.special or {}) do
            if value < 0 then return false end
        end
        return row[2] == IN and row.range ~= nil and row.range[1] >= 0
    end

    -- Makes the field of one parameter; `kind` is the kind of its values.
    local function parameter_field(abbreviation, parameter, kind, name, text)
        if kind == TEXT_VALUE then return ProtoField.string(abbreviation, name, text) end
        if kind == FLOAT then return ProtoField.float(abbreviation, name, text) end
        local whole = is_natural(parameter) and ProtoField.uint32 or ProtoField.int32
        if parameter.enum and not parameter.enum.is_flags then
            return whole(abbreviation, name, base.DEC, parameter.enum.names, nil, text)
        elseif parameter.unit then
            return whole(abbreviation, name, base.UNIT_STRING, { " " .. parameter.unit }, nil, text)
        end
        return whole(abbreviation, name, base.DEC, nil, nil, text)
    end

    -- Returns the names of a parameter in filters and in the tree, and the kind of its values.
    local function described(name, row)
        local own, type = row[1], row[3]
        local label = row.label and row.label .. " " .. own or own
        local kind = PARAMETER_KINDS[type == VALUES and row.element or type] or NUMBER
        return ("ev3." .. name .. "." .. own):lower(), label, kind
    end

    -- The validator takes the first character of a text, and the distance of a jump, for numbers.
    local VALIDATED_AS = { [STRING] = DATA8, [LABEL] = DATA32 }

    -- Makes a parameter from its row in the tables; `value_name` is its name in the line of a reply.
    local function ready_parameter(row, value_name)
        local name, direction, type, kind = row[1], row[2], row[3], row.kind
        local is_flags = row.enum and row.enum.is_flags
        return {
            name = name, type = type, field = row.field, kind = kind, is_float = type == DATAF, label = row.label,
            size = SIZE_OF[type] or 1, is_natural = kind == NUMBER and is_natural(row), is_output = direction ~= IN,
            -- The index of a variable must be a multiple of this, else the brick refuses the command.
            alignment = SIZE_OF[row.validated or type] or 1,
            -- What precedes the value in the line of a command and of a reply.
            key = direction ~= OUT and " " .. name:lower() .. "=" or nil,
            value_key = direction ~= IN and " " .. value_name:lower() .. "=" or nil,
            unit = row.unit, names = row.enum and not is_flags and row.enum.names or nil,
            -- The letters of motors, for lines; whether it is a bit mask of ports.
            motors = (row.is_motor or row.is_set) and row.special or nil,
            is_set = row.is_set, is_motor = row.is_motor, is_ranged = row.is_ranged,
            flags = is_flags and row.enum.names or nil, special = not is_flags and row.special or nil,
            length = row.length, most = row.most, any = row.any, is_unsigned = row.unsigned, is_label = row.is_label,
            range = direction == IN and (row.range or not row.enum and not row.any and TYPE_RANGES[type]) or nil,
            -- What is said of a number outside of what the tables document, and the kind of that finding.
            outside = row.outside,
            -- Whether it receives a reading of a device, in its unit or raw, and which of its values.
            reading = type ~= COUNT and row.reading or nil, number = 1,
            limits = SIZE_OF[type] and TYPE_RANGES[type],
        }
    end

    -- Makes the field of the values after a count. If another argument determines their type, it is a double, which
    -- holds any of them.
    local function element_field(abbreviation, row)
        local name, element, text = row[1], row.element, row[4]
        if not TYPE_NAMES[element] then return ProtoField.double(abbreviation, name, text) end
        return parameter_field(abbreviation, {}, PARAMETER_KINDS[element] or NUMBER, name, text)
    end

    -- Makes the elements of a list of one type, by number.
    local function ready_elements(list, row, declared, type)
        local kind = PARAMETER_KINDS[type] or NUMBER
        if row[3] == COUNT and not TYPE_NAMES[row.element] then kind = FLOAT end
        local direction = row[3] == COUNT and row.elements or IN
        return made_late(function(number)
            local name = format("%s[%d]", list.name, number)
            local one = { name, direction, type, any = row.any, most = row.most, reading = row.reading,
                field = declared, kind = kind }
            local element = ready_parameter(one, name)
            element.label, element.numbered, element.number, element.alignment = name, name, number + 1, 1
            return element
        end)
    end

    -- Makes the list at the end of an operation; `declared` is the field of its elements.
    local function ready_list(parameter, row, declared)
        local function make(type)
            return ready_elements(parameter, row, declared, type)
        end
        local type = TYPE_NAMES[row.element] and row.element or ARRAY_TYPED
        return { is_count = row[3] == COUNT, element_type = type, elements_of = made_late(make) }
    end

    -- Makes an operation, and the fields of its parameters: one for each, and one for the values after a count.
    local function declare_operation(name, rows)
        for _, row in ipairs(rows) do
            local abbreviation, label, kind = described(name, row)
            row.label, row.kind, row.field = label, kind, parameter_field(abbreviation, row, kind, label, row[4])
            row.item_field = row[3] == COUNT and element_field(abbreviation .. ".item", row) or row.field
            fields[#fields + 1] = row.field
            if row[3] == COUNT then fields[#fields + 1] = row.item_field end
        end
        return { name = name, rows = rows }
    end

    -- Adds the parameters to an operation on first use. Values after a count are in its `list`. Only operations of a
    -- family have a `cmd_name`.
    function prepare_operation(operation)
        local name, rows, by_name = operation.name, operation.rows, {}
        operation.cmd_name, operation.rows, operation.parameters = name:match("%.(.+)$"), nil, {}
        for _, row in ipairs(rows) do
            local own, type = row[1], row[3]
            -- The line of a reply names a VALUE after its command: VALUE of GET_VBATT is VBATT.
            local value_name = own == "VALUE" and name:match("%.GET_(.+)$") or own
            local parameter = ready_parameter(row, value_name)
            by_name[own] = parameter
            if type ~= VALUES then table.insert(operation.parameters, parameter) end
            if type == COUNT or type == VALUES then
                operation.list = ready_list(parameter, row, row.item_field)
                operation.list.counter = operation.parameters[#operation.parameters]
            end
        end
        for _, row in ipairs(rows) do
            if by_name[row.length] then by_name[row.length].is_stated, operation.has_stated = true, true end
            if row.reading then
                by_name.TYPE.is_stated, by_name.MODE.is_stated, operation.has_stated = true, true, true
            end
            if by_name[row.element] then by_name[row.element].tells_type = true end
        end
        local first = not operation.cmd_name and operation.parameters[1]
        if first then
            first.accepted = first.is_label and first.range
                or TYPE_RANGES[rows[1].validated or VALIDATED_AS[first.type] or first.type]
        end
    end

    -- By dialect and opcode: an operation, or a family, which has a name and `commands`, its operations by CMD.
    INSTRUCTION_SETS = {}
    for _, dialect in ipairs(DIALECTS) do INSTRUCTION_SETS[dialect] = {} end
    for _, row in ipairs(OPERATIONS) do
        local operation = not row.commands and declare_operation(row[2], row[4])
        local operations = {}
        for _, command in ipairs(row.commands or {}) do
            operations[command] = declare_operation(row[2] .. "." .. command[2], command[4])
        end
        for dialect, set in pairs(INSTRUCTION_SETS) do
            if not row.dialects or row.dialects[dialect] then
                local family = { name = row[2], commands = {} }
                for command, declared in pairs(operations) do
                    local dialects = command.dialects
                    if not dialects or dialects[dialect] then family.commands[command[1]] = declared end
                end
                set[row[1]] = operation or family
            end
        end
    end

    for _, command in pairs(SYSTEM_COMMANDS) do
        for _, side in ipairs({ command.request, command.reply }) do
            for _, declared in ipairs(side) do
                declared.field = field["system_" .. declared.filter]
            end
        end
    end
end

local dialect = DIALECTS[1]
local instructions = INSTRUCTION_SETS[dialect]

-- Memory ------------------------------------------------------------------------------------------------------------
--
-- The places of messages, and the garbage of trees.

local storage = {}
do
    -- The place of a message: the number of its packet and its offset there, in one number.
    local OFFSETS = 0x100000

    function storage.place_of(number, offset)
        return number * OFFSETS + offset
    end

    function storage.number_of(place)
        return floor(place / OFFSETS)
    end

    -- Items and ranges of a tree are garbage after their packet. Collected soon, they are still in the processor's
    -- cache. With much memory held, as by other scripts, a collection takes long. Lua's own would wait until twice the
    -- memory is used.
    local SOON, LATER, MUCH_KILOBYTES = 1.15, 1.5, 32 * 1024
    local limit = 0

    function storage.free_unused(is_shown)
        local size = collectgarbage("count")
        if size < limit then return end
        -- Finalizers of other scripts may raise errors.
        pcall(collectgarbage)
        size = collectgarbage("count")
        limit = size * (is_shown and size < MUCH_KILOBYTES and SOON or LATER)
    end
end

-- Reading -----------------------------------------------------------------------------------------------------------
--
-- Bytes to operations and fields. A frame is a string. Offsets start at 0, as in all documents about the protocol: the
-- byte at offset 0 is byte(text, 1). Nothing here raises errors: a fault is returned as its offset and reason.

local reading = {}

-- The texts of Phrases below, by which faults are named.
local phrases = {}
do
    local unpack = Struct.unpack

    local NAN = unpack("<f", "\0\0\192\127")

    -- Functions that read a number at an offset, nil if the text ends too early. Most numbers are bytes and words,
    -- which are read faster without Struct.
    local function unsigned8(text, at)
        return byte(text, at + 1)
    end

    function reading.unsigned16(text, at)
        local low, high = byte(text, at + 1, at + 2)
        return high and low + high * 0x100
    end

    -- Returns the bytes of global and local memory that a direct command requests.
    function reading.memory_sizes(text)
        local sizes = reading.unsigned16(text, HEADER_SIZE)
        local globals = sizes % (GLOBAL_MASK + 1)
        return globals, (sizes - globals) / (GLOBAL_MASK + 1)
    end

    local function signed8(text, at)
        local low = byte(text, at + 1)
        return low and low >= 0x80 and low - 0x100 or low
    end

    local function signed16(text, at)
        local low, high = byte(text, at + 1, at + 2)
        return high and low + 0x100 * (high < 0x80 and high or high - 0x100)
    end

    local function reader32(form)
        return function(text, at)
            return at + 4 <= #text and unpack(form, text, at + 1) or nil
        end
    end

    local function single(text, at)
        if at + 4 > #text then return nil end
        local value = unpack("<f", text, at + 1)
        -- All NaNs look the same, also where the machine's own would be printed as -nan.
        return value == value and value or NAN
    end

    local READ_UNSIGNED = { [1] = unsigned8, [2] = reading.unsigned16, [4] = reader32("<I4") }
    local READ_SIGNED = { [1] = signed8, [2] = signed16, [4] = reader32("<i4") }
    reading.READ_TYPE = {
        [DATA8] = signed8, [DATA16] = signed16, [DATA32] = READ_SIGNED[4], [DATAF] = single, [HANDLE] = signed16,
    }

    -- By identification byte: its encoding and, for short forms, the value.
    local SHORT_VALUES = {}
    local ENCODINGS = {}
    reading.ENCODINGS = ENCODINGS
    local SCOPES = { [LOCAL] = "LV(", [GLOBAL] = "GV(" }
    for _, row in ipairs(ENCODING_ROWS) do
        local kind, width = row[4], row[5]
        local scope = SCOPES[kind]
        local encoding = {
            name = row[3], kind = kind, width = width, handle = row.handle, address = row.address, scope = scope,
            label = row[3] .. (row.handle and " HND" or "") .. (row.address and " ADR" or ""),
            -- The value of a variable is its index.
            read = (scope and READ_UNSIGNED or READ_SIGNED)[width], is_long = kind == CONSTANT and width == 4,
        }
        for first = row[1], row[2] do
            ENCODINGS[first] = encoding
            if row.value then SHORT_VALUES[first] = row.value + first - row[1] end
        end
    end

    -- A zero would end the text in Wireshark; its symbol is shown.
    local utf8_of = made_late(function(character)
        local code = byte(character)
        if code == 0 then return "\226\144\128" end
        return string.char(0xC0 + floor(code / 0x40), 0x80 + code % 0x40)
    end)

    -- The brick's strings are ISO-8859-1, Wireshark's are UTF-8.
    function reading.utf8_text(text)
        if not find(text, "[\0\128-\255]") then return text end
        return (gsub(text, "[\0\128-\255]", utf8_of))
    end

    -- Returns the fault of the argument at an offset: its offset, reason and kind.
    local function argument_fault(text, at, name, owner)
        local first = byte(text, at + 1)
        local encoding, values, why = ENCODINGS[first], { name = name, owner = owner }, "cut_argument"
        if first and not encoding then
            values.byte = format("0x%02X", first)
            return at, phrases.finding("UNDEFINED_FORM", values), "fault"
        elseif not first then
            why = "no_argument"
        elseif encoding.kind == CONSTANT_TEXT then
            why = "cut_string"
        else
            values.form, values.more = encoding.name, phrases.plural(at + 1 + encoding.width - #text, "more byte")
        end
        return at, phrases.unreadable("CUT_OFF", owner, why, values), "cut_off"
    end

    -- Returns what is said of an opcode that the firmware lacks.
    local function opcode_reason(code)
        local key, values, others = "UNKNOWN_OPCODE", { byte = format("0x%02X", code), dialect = dialect }, {}
        for _, row in ipairs(OPERATIONS) do
            if row[1] == code and not values.known then
                for _, name in ipairs(DIALECTS) do
                    if row.dialects[name] then others[#others + 1] = name end
                end
                values.known, values.others = row[2], concat(others, " and ")
                key = others[1] and "OTHER_DIALECT" or "UNRELEASED"
            end
        end
        return (phrases.finding(key, values))
    end

    -- Reads the argument at an offset: its encoding, value, and the offset after it; else nil.
    local function read_argument(text, at, is_float)
        local first = byte(text, at + 1)
        local encoding, value = ENCODINGS[first], SHORT_VALUES[first]
        if value then return encoding, value, at + 1 end
        if not encoding then return nil end
        if encoding.kind == CONSTANT_TEXT then
            local zero = find(text, "\0", at + 2, true)
            if not zero then return nil end
            return encoding, sub(text, at + 2, zero - 1), zero
        end
        value = (is_float and encoding.is_long and single or encoding.read)(text, at + 1)
        if value then return encoding, value, at + 1 + encoding.width end
    end

    -- Returns the operation of an opcode and its CMD, and the offset after them; else nil, offset, reason and kind.
    -- `set` has the instructions, by default the preferred ones.
    function reading.select_operation(text, at, set)
        local code = byte(text, at + 1)
        local operation, after = (set or instructions)[code], at + 1
        if not operation then return nil, at, opcode_reason(code), "unknown_opcode" end
        local commands = operation.commands
        if commands then
            local encoding, value
            encoding, value, after = read_argument(text, at + 1)
            if not encoding then return nil, argument_fault(text, at + 1, "CMD", operation.name) end
            if encoding.kind ~= CONSTANT then
                local said = encoding.kind == JUMP and "a label" or "a string"
                if encoding.scope then said = encoding.scope .. value .. ")" end
                local about = { owner = operation.name, value = said }
                return nil, at + 1, phrases.unreadable("VARIABLE_CMD", nil, "variable_cmd", about), "unknown_cmd"
            end
            if not commands[value] then
                local reason = phrases.finding("UNKNOWN_CMD", { owner = operation.name, value = value })
                return nil, at + 1, reason, "unknown_cmd"
            end
            operation = commands[value]
        end
        if not operation.parameters then prepare_operation(operation) end
        return operation, after
    end

    -- Returns the reason why a list cannot have the number of elements in its argument, else nil.
    local function count_fault(list, encoding, value, room)
        local is_number, key = encoding.kind == CONSTANT, "BAD_COUNT"
        if is_number and value >= 0 and value <= room and not (list.is_count and value > MOST_COUNTED) then
            return nil
        end
        if is_number and not list.is_count and (value < 0 or value >= SPINNING) then
            key = "SPINS"
        elseif is_number and value >= 0 and not (list.is_count and value > MOST_COUNTED) then
            key = "CUT_LIST"
        end
        return (phrases.finding(key, {
            name = list.counter.name, value = is_number and value, encoding = not is_number and encoding.name,
            values = is_number and phrases.plural(value, "value"), bytes = phrases.plural(room, "byte"),
        }))
    end

    -- Reads the arguments of an operation, from the offset after its opcode and CMD. `visit` gets each one: its
    -- parameter, encoding, value, the offsets of its first byte and after its last, and `context`. Returns the offset
    -- after the last one that could be read, and after a fault its offset, reason and kind.
    function reading.read_arguments(operation, text, at, visit, context)
        local parameters, list = operation.parameters, operation.list
        local element_type = list and list.element_type
        local index, last, elements = 0, #parameters, nil
        while index < last do
            index = index + 1
            local parameter = parameters[index] or elements[index - #parameters - 1]
            local encoding, value, after = read_argument(text, at, parameter.is_float)
            if not encoding then return at, argument_fault(text, at, parameter.name, operation.name) end
            visit(parameter, encoding, value, at, after, context)
            if list and not elements then
                if parameter.tells_type and encoding.kind == CONSTANT then
                    element_type = FORMAT_TYPES[value] or element_type
                end
                if index == last then
                    local reason = count_fault(list, encoding, value, #text - after)
                    if reason then return after, at, reason, "fault" end
                    elements, last = list.elements_of[element_type], last + value
                end
            end
            at = after
        end
        return at
    end

    local function pass_over() end

    -- Reads one operation with its arguments, as above. Returns the operation, and the same as above.
    function reading.read_operation(text, at, visit, set)
        local operation, after, reason, kind = reading.select_operation(text, at, set)
        if not operation then return nil, at, after, reason, kind end
        return operation, reading.read_arguments(operation, text, after, visit or pass_over)
    end

    -- Reads one field of a system message: its value and the offset after it; else nil, offset and key of the reason.
    local function read_field(text, at, stop, declared, before)
        local kind = declared.kind
        local size = kind == U8 and 1 or kind == U16 and 2 or kind == U32 and 4
        if size then
            if at + size > stop then return nil, at, "no_field" end
            return READ_UNSIGNED[size](text, at), at + size
        elseif kind == TEXT then
            local zero = find(text, "\0", at + 1, true)
            if not zero or zero > stop then return nil, at, "endless_text" end
            return sub(text, at + 1, zero - 1), zero
        elseif kind == COUNTED_TEXT then
            local length = before[declared.name]
            if at + length > stop then return nil, at, "cut_text" end
            -- Some senders count the terminating zero, others do not.
            if length > 0 and byte(text, at + length) == 0 then
                return sub(text, at + 1, at + length - 1), at + length
            elseif at + length >= stop then
                return nil, at, "no_zero"
            elseif byte(text, at + length + 1) ~= 0 then
                return nil, at + length, "other_zero"
            end
            return sub(text, at + 1, at + length), at + length + 1
        end
        if before[declared.name] and before[declared.name] ~= stop - at then return nil, at, "wrong_count" end
        return sub(text, at + 1, stop), stop
    end

    -- Reads the fields of a system message. Returns a list of { declared, value, at, stop }, the offset after them, and
    -- the fault, if any. Replies to failed commands may end before any field: they are not `complete`.
    function reading.read_fields(text, at, stop, declarations, complete, owner)
        local found, counted, counters = {}, {}, {}
        local function fault_at(place, why, name, kind)
            return { at = place, kind = "fault", reason = phrases.unreadable("WRONG_FIELDS", owner, why, {
                name = name, kind = kind and kind:lower(), bytes = phrases.plural(stop - place, "byte"),
                counter = counters[name], stated = counted[name], length = counted[name], size = stop - place,
                byte = format("0x%02X", byte(text, place + 1) or 0),
            }) }
        end
        for _, declared in ipairs(declarations) do
            if at == stop and (declared.optional or not complete) then break end
            local value, after, reason = read_field(text, at, stop, declared, counted)
            if not value then return found, at, fault_at(after, reason, declared.name, declared.kind) end
            found[#found + 1] = { declared = declared, value = value, at = at, stop = after }
            found[declared.name] = value
            if declared.counts then counted[declared.counts], counters[declared.counts] = value, declared.name end
            at = after
        end
        if at < stop then return found, at, fault_at(at, "left_over") end
        return found, at
    end
end

-- Phrases -----------------------------------------------------------------------------------------------------------
--
-- The texts of the info column and of headings in the tree.

do
    -- Maximum number of values in a line.
    phrases.MOST_VALUES = 12
    local MOST_TEXT = 60
    -- Characters for the names of a command's other operations.
    local MOST_NAMES = 80

    function phrases.plural(count, word)
        return format("%d %s%s", count, word, count == 1 and "" or "s")
    end

    -- Returns a template with values for its names in braces. Words in brackets are about a value that may be lacking.
    function phrases.filled(template, about)
        if find(template, "[", 1, true) then
            template = gsub(template, "%[(.-{([%w_]+)}.-)%]", function(words, name)
                return about[name] and words or ""
            end)
        end
        return (gsub(template, "{([%w_]+)}", about))
    end

    -- Returns what `ev3proto check` says, by the key of its words, and its code; but not what the brick does next.
    function phrases.finding(key, about)
        local code, words = FINDINGS[key][1], FINDINGS[key][2]
        return phrases.filled(words, about) .. " (" .. code .. ")", code
    end

    -- Returns the same about an operation or a system command that cannot be read, by the key of the reason.
    function phrases.unreadable(key, owner, why, values)
        return (phrases.finding(key, { owner = owner, reason = phrases.filled(REASONS[why], values) }))
    end

    -- Returns the names of the operations after the first one, as far as there is room.
    function phrases.others_text(names)
        local size, shown, index = 0, {}, 2
        while index <= #names do
            local name, first = names[index], index
            while names[index + 1] == name do index = index + 1 end
            if index > first then name = format("%s x %d", name, index - first + 1) end
            size = size + #name + 2
            if size > MOST_NAMES then
                shown[#shown + 1] = format("%d more", #names - first + 1)
                break
            end
            shown[#shown + 1], index = name, index + 1
        end
        return "(+" .. concat(shown, ", ") .. ")"
    end

    -- What represents a byte of a text in a line: the symbol of a control character, because a newline would end the
    -- line; a mark for U+0080 to U+009F, which have no symbols and control some terminals; else UTF-8.
    local REPLACEMENT = "\239\191\189"
    local in_line = made_late(function(character)
        local code = byte(character)
        if code < 0x20 or code == 0x7F then
            return "\226\144" .. string.char(code == 0x7F and 0xA1 or 0x80 + code)
        elseif code < 0xA0 then
            return REPLACEMENT
        end
        return reading.utf8_text(character)
    end)

    function phrases.on_one_line(text)
        if not find(text, "[\0-\31\127-\255]") then return text end
        return (gsub(text, "[\0-\31\127-\255]", in_line))
    end

    function phrases.shortened(text)
        if #text > MOST_TEXT then text = sub(text, 1, MOST_TEXT) .. "..." end
        return '"' .. phrases.on_one_line(text) .. '"'
    end

    function phrases.number_text(value)
        -- NaN is the only value that differs from itself.
        if value ~= value then return "NaN" end
        if value % 1 ~= 0 or value <= -1e15 or value >= 1e15 then return format("%.7g", value) end
        return format("%d", value)
    end

    -- Returns the special meaning of a value, or the names of its flags. Wireshark itself shows other names.
    function phrases.meaning_of(parameter, value)
        local flags, names = parameter.flags, {}
        if not flags then names[1] = parameter.special and parameter.special[value] end
        for bit = 0, flags and value >= 0 and value <= 0xFF and 7 or -1 do
            local flag = 2 ^ bit
            if value % (2 * flag) >= flag then names[#names + 1] = flags[flag] or format("0x%02X", flag) end
        end
        return names[1] and "(" .. concat(names, "|") .. ")"
    end

    -- Tells whether the tables allow a number for a parameter.
    function phrases.is_allowed(parameter, value)
        local range, names, special = parameter.range, parameter.names, parameter.special
        if range and value >= range[1] and value <= range[2] then return true end
        if not names and not special then return not range end
        return names and not parameter.is_ranged and names[value] ~= nil or special and special[value] ~= nil
    end

    local function is_outside(value, range)
        return range and (value < range[1] or value > range[2])
    end

    local WHOLE = { [DATA8] = true, [DATA16] = true, [DATA32] = true }

    -- What is wrong with a number by the tables.
    local function of_tables(parameter, value)
        if not parameter.outside or phrases.is_allowed(parameter, value) then return nil end
        return parameter.is_motor and PORT_SETS[value] and "MASK" or parameter.outside[2]
    end

    -- What the validator has against a first argument.
    local function of_first(parameter, value)
        if type(value) ~= "number" or not is_outside(value, parameter.accepted) then return nil end
        return parameter.is_label and "LABEL_NUMBER" or "REFUSED"
    end

    -- The same for a whole number, and the number that the brick reads instead.
    local function of_whole(parameter, value)
        local limits = parameter.limits
        if not limits then return nil end
        local low, high = limits[1], limits[2]
        if parameter.is_unsigned and value >= low - 1 and value <= high * 2 + 1 then
            return nil
        elseif value >= low and value <= high then
            return of_tables(parameter, value)
        elseif value == low - 1 then
            return "NAN"
        end
        local span = high * 2 + 2
        local read = (value + span / 2) % span - span / 2
        if value < 0 or value >= span then return "TRUNCATED", read end
        return of_tables(parameter, read) or "NEGATIVE", read
    end

    local function of_number(parameter, encoding, value)
        if parameter.type == STRING then return "NUMBER" end
        if parameter.is_float then
            if value ~= value then return "NAN_FLOAT" end
            if encoding.is_long then return of_tables(parameter, value) end
            return value ~= 0 and not parameter.length and "WHOLE" or nil
        end
        local refused = parameter.accepted and of_first(parameter, value)
        if refused then return refused end
        return of_whole(parameter, value)
    end

    -- Returns what is wrong with a constant, as a key of FINDINGS, and the number that the brick reads instead; nil if
    -- nothing is. `ev3proto/semantics/judgement.py` says the same.
    function phrases.judge(parameter, encoding, value)
        local sort, kind = parameter.type, encoding.kind
        local is_whole = WHOLE[sort] and not parameter.length and not parameter.is_output
        if kind == JUMP and is_whole then
            if is_outside(value, LABELS) then return "LABEL_BYTE", sort == DATA8 and value or value % 256 end
            return "LABEL", value
        elseif (encoding.handle or encoding.address) and not (kind == CONSTANT_TEXT and is_whole) then
            return of_first(parameter, value)
        elseif parameter.is_output then
            return "WRITTEN"
        elseif kind ~= CONSTANT_TEXT then
            return of_number(parameter, encoding, value)
        elseif sort ~= STRING and not parameter.length and sort ~= ARRAY_TYPED and not parameter.any then
            return "TEXT"
        elseif parameter.most and #value > parameter.most then
            return "LONG"
        end
    end

    -- Returns a number as `ev3proto check` writes it: a float with its decimals.
    local function spelled(parameter, encoding, value)
        if value ~= value then return "nan" end
        local text = phrases.number_text(value)
        return parameter.is_float and encoding.is_long and not find(text, "[^%d-]") and text .. ".0" or text
    end

    -- How the values of a template about a constant are written, by their names.
    local PARTS = {
        name = function(about) return about.parameter.name end,
        kind = function(about) return TYPE_NAMES[about.parameter.type] end,
        most = function(about) return about.parameter.most end,
        ports = function(about) return PORT_SETS[about.constant] end,
        value = function(about) return spelled(about.parameter, about.encoding, about.constant) end,
        read = function(about) return about.meant and format("%d", about.meant) end,
        type = function(about) return about.parameter.limits.text end,
        accepted = function(about) return about.parameter.accepted.named end,
        outside = function(about) return about.parameter.outside[1] end,
        byte = function(about) return format("0x%02X", about.first) end,
        characters = function(about) return phrases.plural(#about.constant, "character") end,
    }
    local OF_CONSTANT = { __index = function(about, name) return PARTS[name] and PARTS[name](about) end }

    -- Returns what `ev3proto check` says of a constant, and its code; nil if it says nothing.
    function phrases.misuse(parameter, encoding, value, owner, first)
        local wrong, meant = phrases.judge(parameter, encoding, value)
        if not wrong then
            if not parameter.is_set or value ~= 0 then return nil end
            wrong = "NO_PORTS"
        end
        return phrases.finding(wrong, setmetatable({
            parameter = parameter, encoding = encoding, constant = value, meant = meant, owner = owner, first = first,
        }, OF_CONSTANT))
    end

    -- Returns a value for a line: a text, a name, or a number with its unit.
    local function value_text(parameter, value, dataset)
        if type(value) == "string" then return phrases.shortened(value) end
        local name = parameter.names and parameter.names[value] or parameter.motors and parameter.motors[value]
        if name then return name end
        local text = phrases.number_text(value)
        local unit = dataset and dataset[2] or parameter.unit
        return unit and text .. " " .. unit or text
    end

    function phrases.argument_text(parameter, encoding, value)
        if encoding.scope then return encoding.scope .. value .. ")" end
        return value_text(parameter, value)
    end

    local function one_value_text(output, value)
        return output.is_handle and phrases.number_text(value) or value_text(output.parameter, value, output.dataset)
    end

    function phrases.output_text(output)
        local list = output.value
        if type(list) ~= "table" then return one_value_text(output, list) end
        local pieces = {}
        for index = 1, math.min(#list, phrases.MOST_VALUES) do
            pieces[index] = one_value_text(output, list[index])
        end
        if #list > phrases.MOST_VALUES then pieces[#pieces + 1] = "..." end
        return "[" .. concat(pieces, ", ") .. "]"
    end

    -- Appends values to a head: 7.92 V; several as vbatt=7.92 V ibatt=0.21 A. Those of operations with a `telling` are
    -- grouped by it: no=0: 1, no=1: 12
    function phrases.values_text(head, outputs)
        if #outputs == 1 and not outputs[1].telling then return head .. " " .. phrases.output_text(outputs[1]) end
        local pieces = { head }
        for index = 1, math.min(#outputs, phrases.MOST_VALUES) do
            local output = outputs[index]
            local before, after = outputs[index - 1], outputs[index + 1]
            local is_first, key = not before or before.at ~= output.at, output.parameter.value_key
            local is_only = is_first and (not after or after.at ~= output.at)
            if output.telling and is_first then
                pieces[#pieces + 1] = format("%s %s:", before and "," or "", output.telling)
            elseif before and before.telling and is_first then
                pieces[#pieces + 1] = ","
            end
            pieces[#pieces + 1] = (output.telling and is_only and " " or key) .. phrases.output_text(output)
        end
        if #outputs > phrases.MOST_VALUES then pieces[#pieces + 1] = " ..." end
        return concat(pieces)
    end

    function phrases.transfer_text(transfer)
        local text = phrases.shortened(transfer.path)
        if transfer.size then
            text = format("%s %d of %s", text, transfer.done, phrases.plural(transfer.size, "byte"))
        end
        return text
    end
end

-- Dialogues ---------------------------------------------------------------------------------------------------------
--
-- Which reply answers which command, and which file a message belongs to. Wireshark dissects all packets once in order,
-- and afterwards those that are displayed. What the first pass finds is kept by the place of each message; later passes
-- look it up.

-- The functions that read and show one message are defined below.
local messages = {}

local dialogues = {}
do
    local CARRIES = { direct = 0x000000, system = 0x010000, daisy = 0x020000 }
    local NUMBERS = 0x040000

    -- Nanoseconds of a conversation after which a command has no reply.
    local GIVEN_UP = 1e9

    -- By the number of a command that wants a reply, from 1: its place, that of its reply or false, its time in
    -- nanoseconds or, once it is answered, the response time, its conversation until then, the bytes after the type.
    -- `of_packet` has the number for the first message of a packet, `others` for others, by place. Of few: `unsure`, by
    -- number, if several commands waited; by place, the `transfers` of files, and the `locks` of connections.
    local asked, answers, times, bodies, owners, of_packet, others, unsure, transfers, locks, count

    -- One string for equal bodies; conversations by key, the number of the newest one, and by packet that of its
    -- conversation, if it is not the first.
    local shared, conversations, newest_number, numbers

    function dialogues.forget()
        asked, answers, times, bodies, owners, of_packet, others, unsure = {}, {}, {}, {}, {}, {}, {}, {}
        transfers, locks = {}, {}
        count, shared, conversations, newest_number, numbers = 0, {}, {}, 0, {}
    end

    local function set_number(place, number)
        local packet = storage.number_of(place)
        if of_packet[packet] then
            others[place] = number
        else
            of_packet[packet] = number
        end
    end

    local function number_at(place)
        local number = of_packet[storage.number_of(place)]
        return number and (asked[number] == place or answers[number] == place) and number or others[place]
    end

    -- Returns the command that a reply answers: its `place`, the `delay` of the reply in nanoseconds, the `body`, the
    -- bytes after the type (of a system command those that matter here), and whether it `is_unsure`.
    function dialogues.request_of(place)
        local at = number_at(place)
        return at and { place = asked[at], delay = times[at], body = bodies[at], is_unsure = unsure[at] }
    end

    -- Returns the number of the packet with the reply to a command; without one, nil and whether none is expected.
    function dialogues.reply_to(place)
        local at = number_at(place)
        if at and answers[at] then return storage.number_of(answers[at]) end
        return nil, at ~= nil and owners[at].newest - times[at] > GIVEN_UP
    end

    -- Returns the file that a message belongs to: path, size, and bytes done.
    function dialogues.transfer_at(place)
        return transfers[place]
    end

    -- Returns what is wrong with the size of the file that a message belongs to, nil if nothing is. That the file has
    -- no further message is known only after the first pass.
    function dialogues.trouble_at(place, is_new)
        local now = transfers[place]
        local file = now and now.file
        if not file or file.is_listing or not now.size or now.done == now.size then return nil end
        if now.done > now.size then return now.is_longer and phrases.filled(FILES.longer, now) or nil end
        local is_last = not is_new and file.last == place and not file.is_over
        return (now.is_closed or is_last) and phrases.filled(FILES.incomplete, now) or nil
    end

    -- Returns the conversation of a computer and a brick. `waiting` has the numbers of the commands that wait for a
    -- reply: lists by `pending_key`, oldest first; `longest` is the longest time in nanoseconds that a reply took
    -- for which one command waited. Transfers are `begun` by counter, and `open` by handle.
    function dialogues.conversation_of(key)
        local conversation = conversations[key]
        if not conversation then
            conversation = { key = key, waiting = {}, begun = {}, open = {} }
            conversations[key] = conversation
        end
        return conversation
    end

    -- Begins another connection between the same ends: it has replies, files and a number of its own.
    function dialogues.renew(conversation)
        conversation.waiting, conversation.begun, conversation.open = {}, {}, {}
        conversation.number, conversation.longest = nil, nil
    end

    -- Tells whether a message is on a connection that begins without the unlock text, and has no reply. Whether its
    -- beginning was captured is known only where Wireshark shows all fields of a packet in a tree, and is then kept: to
    -- request the field would slow down all captures.
    function dialogues.is_locked(place)
        local lock = locks[place]
        if not lock or lock.is_open then return false end
        for _, info in ipairs(lock.is_begun == nil and { all_field_infos() } or {}) do
            if info.name == "tcp.completeness" then lock.is_begun = info.value % 2 == 1 end
        end
        return lock.is_begun
    end

    -- Ends the lock of a conversation, if it has one: the text or a reply was seen.
    function dialogues.unlock(conversation)
        if conversation.lock then conversation.lock.is_open, conversation.lock = true, nil end
    end

    -- Returns the number of the conversation of a message. It gets the next one with its first message.
    function dialogues.number_at(place)
        return numbers[storage.number_of(place)] or 1
    end

    -- Returns what a reply has in common with its command.
    local function pending_key(message)
        local carries = message.type.carries
        local number = carries == "system" and byte(message.text, HEADER_SIZE + 1) or 0
        return CARRIES[carries] + message.counter + NUMBERS * number
    end

    local function remember(conversation, place, message, now)
        -- Of a system command, its number and a handle are enough.
        local body = sub(message.text, HEADER_SIZE + 1, message.command and HEADER_SIZE + 2 or -1)
        shared[body], count = shared[body] or body, count + 1
        asked[count], answers[count], times[count], bodies[count] = place, false, now, shared[body]
        owners[count] = conversation
        set_number(place, count)
        local key = pending_key(message)
        local commands = conversation.waiting[key] or {}
        conversation.waiting[key] = commands
        if #commands == MOST_PER_COUNTER then table.remove(commands, 1) end
        commands[#commands + 1] = count
    end

    -- Returns the bytes of memory that a direct reply must have by its command's body, nil for others.
    function dialogues.asked_size(message, body)
        local type, sizes = message.type, reading.unsigned16(body, 0)
        if type.carries ~= "direct" or type.is_error or not sizes then return nil end
        return sizes % (GLOBAL_MASK + 1)
    end

    -- Tells whether the reply to a command shows that both are ours: a direct reply has the requested length, or is an
    -- error; a system reply has the command's number, known or not, but not 0. `body` is what follows the type in the
    -- command; zeros prove nothing.
    local function is_proof(reply, body)
        local carries, memory, sizes = reply.type.carries, reply.size - HEADER_SIZE, reading.unsigned16(body, 0)
        if carries == "system" then
            local number = byte(body, 1)
            return number ~= nil and number ~= 0 and number == byte(reply.text, HEADER_SIZE + 1)
        end
        if carries ~= "direct" or find(body, "^..\0+$") then return false end
        return sizes ~= nil and memory == sizes % (GLOBAL_MASK + 1) or reply.type.is_error and memory == 0
    end

    -- Tells whether a message is the reply to a command, and shows that both are ours.
    function dialogues.proves(reply, command)
        local type, asked = reply.type, command.type
        if not type or type.is_command or not asked or not asked.wants_reply then return false end
        return pending_key(reply) == pending_key(command) and is_proof(reply, sub(command.text, HEADER_SIZE + 1))
    end

    -- Returns the number of the command that a reply answers, and whether others may be it. A brick answers in
    -- order: it is the oldest that the reply fits and that has not waited much longer than this brick takes; the
    -- oldest of all if it is slow now; the newest if the reply fits none. Earlier commands are given up.
    local function answered(conversation, message, now)
        local key, fitting = pending_key(message), {}
        local commands, longest = conversation.waiting[key] or {}, conversation.longest
        for index, command in ipairs(commands) do
            local size = dialogues.asked_size(message, bodies[command])
            if not size or message.size - HEADER_SIZE == size then fitting[#fitting + 1] = index end
        end
        local found, is_unsure = fitting[1] or #commands, #fitting > 1 or not fitting[1] and #commands > 1
        if is_unsure then
            local limit = longest and math.max(PAIRING.patience * longest, PAIRING.least) or PAIRING.first
            for index = #fitting, 1, -1 do
                if now - times[commands[fitting[index]]] <= limit then found = fitting[index] end
            end
        elseif commands[1] then
            conversation.longest = math.max(longest or 0, now - times[commands[found]])
        end
        local command = commands[found]
        for _ = 1, found do table.remove(commands, 1) end
        if #commands == 0 then conversation.waiting[key] = nil end
        return command, is_unsure
    end

    -- Adds a piece to a file and returns the file. The brick closes a complete file; more data for its handle belong to
    -- another file, whose beginning was not captured: then returns nil.
    local function add_piece(conversation, handle, transfer, piece)
        if #piece > 0 and transfer.size and transfer.done >= transfer.size then
            conversation.open[handle] = nil
            return nil
        end
        transfer.done = transfer.done + #piece
        return transfer
    end

    -- Returns the file that a system command belongs to, with its progress.
    local function follow_request(conversation, message)
        local command, values = message.command, message.fields
        if command.transfer == "begin" then
            local transfer = {
                path = values.path or "", size = values.size, done = #(values.data or ""),
                is_listing = find(command.name, "^LIST") ~= nil,
            }
            conversation.begun[message.counter] = transfer
            return transfer
        end
        local transfer = conversation.open[values.handle]
        if not transfer or not values.data then return transfer end
        return add_piece(conversation, values.handle, transfer, values.data)
    end

    -- The same for a reply. `asked` is the handle in its command, which is the first field, if that was captured.
    local function follow_reply(conversation, message, asked)
        local command, values = message.command, message.fields
        local failed = message.type.is_error or STATUS.fails[message.status] ~= false
        local handle, transfer = values.handle or asked, nil
        if command.transfer == "begin" then
            transfer = conversation.begun[message.counter]
            conversation.begun[message.counter] = nil
            if failed and transfer then transfer.is_over = true end
            if failed or not values.handle then return transfer end
            -- Even if the command was not captured, the handle now belongs to another file.
            conversation.open[handle] = transfer
        else
            transfer = handle and conversation.open[handle]
            -- The brick releases a handle when its file is closed, complete, or failed.
            if handle and (command.transfer == "close" or failed or message.status == STATUS.end_of_file) then
                conversation.open[handle] = nil
                if failed and transfer then transfer.is_over = true end
            end
        end
        if not transfer then return nil end
        transfer.size = values.size or values.list_size or transfer.size
        return add_piece(conversation, handle, transfer, values.data or values.list or "")
    end

    -- Records a message of a conversation, in the first pass.
    function dialogues.take_note(place, conversation, message, pinfo)
        local type = message.type
        local is_on_file = message.command and message.command.transfer
        local now, transfer = floor(pinfo.rel_ts * 1e9 + 0.5), nil
        conversation.newest = now
        if not conversation.number then newest_number, conversation.number = newest_number + 1, newest_number + 1 end
        if conversation.number > 1 then numbers[storage.number_of(place)] = conversation.number end
        locks[place] = conversation.lock
        if not type or message.is_overwritten then return end
        if not type.is_command then dialogues.unlock(conversation) end
        if type.is_command and not type.wants_reply and not is_on_file then return end
        if type.is_command then
            if type.wants_reply then remember(conversation, place, message, now) end
            transfer = is_on_file and follow_request(conversation, message)
        else
            local request, is_unsure = answered(conversation, message, now)
            local body = bodies[request]
            if request then
                if conversation.state == "claimed" and is_proof(message, body) then conversation.state = "answered" end
                answers[request], times[request], unsure[request] = place, now - times[request], is_unsure or nil
                owners[request] = false
                set_number(place, request)
            end
            transfer = is_on_file and follow_reply(conversation, message, body and byte(body, 2))
        end
        if transfer then
            local is_closed = type.is_command and is_on_file == "close"
            local is_longer = transfer.size and transfer.done > transfer.size
            transfers[place] = {
                path = transfer.path, done = transfer.done, size = transfer.size, file = transfer,
                is_closed = is_closed, is_longer = is_longer and not transfer.is_longer,
            }
            transfer.last, transfer.is_over, transfer.is_longer = place, transfer.is_over or is_closed, is_longer
        end
    end
end

-- Reply values ------------------------------------------------------------------------------------------------------
--
-- A reply to a direct command is only memory. The command's output parameters that are global variables tell what it
-- contains and where.

local reply_values = {}
do
    -- Returns the number of bytes or elements of a parameter, by its length parameter, else `most`. `stated` has the
    -- constants that were given for length parameters, and for the type and mode of readings.
    function reply_values.stated_length(parameter, stated, most)
        local length = parameter.length
        if type(length) == "string" then length = stated[length] end
        if not length then return most end
        -- Negative lengths: -1 for no limit, others for bytes in reverse order.
        if length == -1 and parameter.type == STRING then return most end
        return floor(math.abs(length))
    end

    -- Returns what a parameter receives from a device, by the stated type and mode: name, and unit if it has one; or
    -- nil.
    function reply_values.dataset_of(parameter, stated)
        local modes = parameter.reading and READINGS[stated.TYPE]
        local mode = modes and modes[stated.MODE]
        return mode and (parameter.reading == "si" or mode.agrees) and mode[parameter.number] or nil
    end

    -- Returns the type of an output that has the type of an array: the largest that fits before the operation's next
    -- output.
    local function untyped(output, outputs, stop)
        for _, other in ipairs(outputs) do
            if other.at == output.at and output.index < other.index and other.index < stop then stop = other.index end
        end
        local room = stop - output.index
        return room >= 4 and DATA32 or room >= 2 and DATA16 or room >= 1 and DATA8 or DATA32
    end

    -- Reads the `value` of an output, which may be a list, and its `size`. Returns false if the memory ends before it.
    function reply_values.read(output, outputs, memory)
        local parameter, start, stated = output.parameter, output.index, output.stated
        local kind = output.is_handle and HANDLE or parameter.type
        if kind == STRING then
            local stop = math.min(start + reply_values.stated_length(parameter, stated, #memory), #memory)
            output.value = sub(memory, start + 1, stop):match("^[^\0]*")
            output.size = #output.value
            return start < #memory
        end
        local is_list = parameter.length and kind ~= ARRAY_TYPED and not output.is_handle
        if kind == ARRAY_TYPED then kind = untyped(output, outputs, #memory) end
        local read, size = reading.READ_TYPE[kind], SIZE_OF[kind]
        if not read then return false end
        if not is_list then
            output.value, output.size = read(memory, start), size
            return output.value ~= nil
        end
        local room = floor((#memory - start) / size)
        local count = math.min(reply_values.stated_length(parameter, stated, room), room)
        if count < 1 then return false end
        local list = {}
        for index = 1, count do list[index] = read(memory, start + (index - 1) * size) end
        output.value, output.size = list, count * size
        return true
    end
end

-- Operations --------------------------------------------------------------------------------------------------------
--
-- The operations of a direct command, or of a daisy command's payload: their line, their faults, and their items.

local operations = {}
do
    local add, set_len, new_range = TreeItem.add, TreeItem.set_len, Tvb.range
    local select_operation, read_arguments = reading.select_operation, reading.read_arguments
    local argument_text, plural, misuse_of = phrases.argument_text, phrases.plural, phrases.misuse
    local NOTHING_STATED = {}
    local VARIABLE, OPCODE, CMD, ENCODING = field.variable, field.opcode, field.cmd, field.encoding
    local PORTS, PORT_FIELDS = 1, { field.port_0, field.port_1, field.port_2, field.port_3 }

    -- Returns what the item of a value needs besides its range: the field of its parameter, or one for texts if its
    -- type differs; the value; its label, and what is appended, or nil. `numbered` is the name of an element of a list,
    -- with its number; `dataset` is what it receives from a device.
    local function value_parts(parameter, value, numbered, dataset)
        local declared, kind, is_text = parameter.field, parameter.kind, type(value) == "string"
        local is_other = is_text ~= (kind == TEXT_VALUE)
        if is_other or kind == NUMBER and (value % 1 ~= 0 or parameter.is_natural and value < 0) then
            local text = is_text and reading.utf8_text(value) or phrases.number_text(value)
            return field.other, text, (numbered or parameter.name) .. ": " .. text
        elseif is_text then
            return declared, reading.utf8_text(value), numbered and numbered .. ": " .. phrases.shortened(value)
        end
        local unit, meaning, label = kind == FLOAT and parameter.unit, nil, nil
        if parameter.special or parameter.flags then meaning = phrases.meaning_of(parameter, value) end
        if dataset then unit, meaning = dataset[2], "(" .. dataset[1] .. ")" end
        if numbered then
            local name, text = parameter.names and parameter.names[value], phrases.number_text(value)
            label = numbered .. ": " .. (name and format("%s (%s)", name, text) or text)
        end
        return declared, value, label, unit and meaning and unit .. " " .. meaning or unit or meaning
    end

    -- Adds a value with the field of its parameter.
    function operations.add_value(tree, parameter, range, value, numbered, dataset)
        local declared, shown, label, appended = value_parts(parameter, value, numbered, dataset)
        return add(tree, declared, range, shown, label, appended)
    end

    -- Steps are the items of operations in one list, which costs less than adding the items again by their bytes. An
    -- item is its field, offset, size, value, label, and what is appended; then what is said of it, as false, kind and
    -- text; the set of ports that it is, as PORTS and a number; and its encoding, as true and a label.
    local function add_step(steps, declared, at, size, value, label, appended)
        local last = #steps
        steps[last + 1], steps[last + 2], steps[last + 3], steps[last + 4] = declared, at, size, value
        steps[last + 5], steps[last + 6] = label or false, appended or false
    end

    local function add_mark(steps, mark, value)
        local last = #steps
        steps[last + 1], steps[last + 2] = mark, value
    end

    -- Adds the items of steps to a message's item; `base` is the frame's offset in the buffer.
    local function show_steps(steps, item, tvb, base)
        local index, last, heading, newest, range = 1, #steps, nil, nil, nil
        while index < last do
            local declared = steps[index]
            if declared == true then
                add(newest, ENCODING, range, steps[index + 1])
                index = index + 2
            elseif declared == PORTS then
                for _, port in ipairs(PORT_FIELDS) do add(newest, port, range, steps[index + 1]) end
                index = index + 2
            elseif not declared then
                complain(newest, steps[index + 1], steps[index + 2])
                index = index + 3
            else
                local is_heading, size = declared == OPCODE, steps[index + 2]
                -- A range costs more than an item: one serves both an argument and its encoding.
                range = new_range(tvb, base + steps[index + 1], is_heading and size or 1)
                newest = add(is_heading and item or heading, declared, range,
                    steps[index + 3], steps[index + 4], steps[index + 5])
                if is_heading then
                    heading = newest
                elseif size > 1 then
                    set_len(newest, size)
                end
                index = index + 6
            end
        end
    end

    -- Functions below share a `run` of reading operations: the `text`; the `steps`, nil if they are not wanted; the
    -- requested memory, `global` and `local`; the `operation`, its offset `at`, and the constants `stated` by its
    -- arguments; what was `said` so far, and the number of arguments in it; the first `remark`, the `complaints` for no
    -- tree, whether a variable `is_beyond` the memory, and the `outputs`.

    -- Nothing is said of what follows an OBJECT_END. Without a tree only the first variable beyond the memory is
    -- reported; `is_again` marks others.
    local function report(run, kind, at, text, is_again)
        if run.is_over then return end
        local steps, complaints = run.steps, run.complaints
        run.remark = run.remark or format("at offset %d: %s", at, text)
        if steps then
            local last = #steps
            steps[last + 1], steps[last + 2], steps[last + 3] = false, kind, text
        end
        if is_again then return end
        local last = #complaints
        complaints[last + 1], complaints[last + 2] = kind, text
    end

    -- Checks the index of a variable: its alignment, and whether it is within the requested memory.
    local function check_variable(run, at, parameter, encoding, index)
        local size, alignment = parameter.size, parameter.alignment
        if encoding.handle then
            size, alignment = SIZE_OF[HANDLE], parameter.numbered and 1 or SIZE_OF[HANDLE]
        elseif encoding.address then
            size = SIZE_OF[DATA32]
        end
        if index % alignment ~= 0 then
            local text = argument_text(parameter, encoding, index)
            local said = phrases.finding("MISALIGNED", { name = parameter.name, variable = text, step = alignment })
            report(run, "misaligned", at, said)
        end
        local scope = encoding.kind == GLOBAL and "global" or "local"
        local asked = run[scope]
        if not asked then return end
        if parameter.length and parameter.is_output and not encoding.handle then
            size = size * reply_values.stated_length(parameter, run.stated, 1)
        end
        local is_again = run.is_beyond
        if index + size <= asked or is_again and not run.steps then return end
        run.is_beyond = true
        local said = phrases.finding("BEYOND_" .. scope, {
            name = parameter.name, scope = scope, asked = asked > 0 and plural(asked, "byte") .. " of" or "no",
            bytes = size == 1 and "byte " .. index or format("bytes %d to %d", index, index + size - 1),
        })
        report(run, "beyond_memory", at, said, is_again)
    end

    -- Appends an argument to the line of its operation.
    local function say_argument(run, parameter, encoding, value)
        run.count = run.count + 1
        if run.count <= phrases.MOST_VALUES then
            run.said = run.said .. parameter.key .. argument_text(parameter, encoding, value)
        elseif run.count == phrases.MOST_VALUES + 1 then
            run.said = run.said .. " ..."
        end
    end

    -- Keeps an output for the reply: its parameter, the `index` of its variable, its operation, the constants that
    -- the operation's arguments state, and what it receives from a device.
    local function note_output(run, parameter, encoding, index)
        local stated = run.stated
        run.outputs[#run.outputs + 1] = {
            parameter = parameter, index = index, is_handle = encoding.handle, operation = run.operation, at = run.at,
            stated = stated, dataset = not encoding.handle and reply_values.dataset_of(parameter, stated) or nil,
        }
    end

    local function take_argument(parameter, encoding, value, at, after, run)
        local steps = run.steps
        if steps and encoding.scope then
            local variable = argument_text(parameter, encoding, value)
            add_step(steps, VARIABLE, at, after - at, variable, parameter.label .. ": " .. variable)
        elseif steps then
            local declared, shown, label, appended = value_parts(parameter, value, parameter.numbered)
            add_step(steps, declared, at, after - at, shown, label, appended)
            if parameter.is_set and declared ~= field.other then add_mark(steps, PORTS, value) end
        end
        if encoding.scope then
            check_variable(run, at, parameter, encoding, value)
            -- An address is the place of a value, not a value.
            if encoding.kind == GLOBAL and parameter.is_output and not encoding.address then
                note_output(run, parameter, encoding, value)
            end
        else
            if parameter.is_stated and encoding.kind == CONSTANT and not encoding.handle and not encoding.address then
                run.stated[parameter.name] = value
            end
            local range = not parameter.is_float and parameter.range
            if encoding.kind ~= CONSTANT or not range or not (value >= range[1] and value <= range[2]) then
                local reason, code = misuse_of(parameter, encoding, value, run.operation.name, byte(run.text, at + 1))
                if reason then report(run, REFUSED[code] and "refused" or "misread", at, reason) end
            end
        end
        if steps then add_mark(steps, true, encoding.label) end
        if run.said and parameter.key then say_argument(run, parameter, encoding, value) end
    end

    -- Reads the operations from an offset to the end of a frame; the last two arguments are the requested memory, if
    -- known. Returns the `line` of the operations, which may be empty; the offset `after` the last one that could be
    -- read; the `fault`, or nil; the `first` operation, or nil; `remark`, `complaints`, `outputs`, and with
    -- `wants_steps` the `steps` of their items.
    local function read(text, at, wants_steps, globals, locals)
        local first, phrase, names, fault, line = nil, "", {}, nil, ""
        local steps = wants_steps and {} or nil
        local run = { text = text, steps = steps, global = globals, ["local"] = locals, complaints = {}, outputs = {} }
        while at < #text and not fault do
            local heading = steps and #steps
            if steps then add_step(steps, OPCODE, at, 1, byte(text, at + 1)) end
            local selected, after, reason, kind = select_operation(text, at)
            if not selected then
                fault = { at = after, reason = reason, kind = kind }
                break
            end
            if byte(text, at + 1) == CLAIMS.never_sent then
                report(run, "refused", at, (phrases.finding("NEVER_RUNS", { byte = "0x00", owner = selected.name })))
            elseif selected.name == "OBJECT_END" and after < #text then
                local said = { bytes = plural(#text - after, "byte"), ["end"] = at }
                report(run, "refused", at, (phrases.finding("AFTER_END", said)))
                run.is_over = true
            end
            local cmd = selected.cmd_name
            if steps and cmd then
                add_step(steps, CMD, at + 1, after - at - 1, selected.name)
                if after > at + 2 then add_mark(steps, true, reading.ENCODINGS[byte(text, at + 2)].label) end
            end
            run.operation, run.at, run.stated = selected, at, selected.has_stated and {} or NOTHING_STATED
            -- The line has the arguments of the first operation only.
            run.said, run.count = (steps or not first) and "", 0
            local offset
            after, offset, reason, kind = read_arguments(selected, text, after, take_argument, run)
            local said = run.said
            if not first then first, phrase = selected, said end
            names[#names + 1] = selected.name
            if steps then
                steps[heading + 3] = after - at
                steps[heading + 6] = cmd and cmd .. said or said ~= "" and sub(said, 2)
            end
            at = after
            if reason then fault = { at = offset, reason = reason, kind = kind } end
        end
        if first then line = first.name .. phrase end
        if names[2] then line = line .. " " .. phrases.others_text(names) end
        if first and run.remark then line = format("%s [%s]", line, run.remark) end
        return {
            line = line, after = at, fault = fault, first = first, complaints = run.complaints, outputs = run.outputs,
            remark = fault and format("at offset %d: %s", fault.at, fault.reason) or run.remark, steps = steps,
            names = names[2] and names,
        }
    end

    -- Summaries of direct commands, by their bytes after the type, because programs repeat their commands. Each holds
    -- about as much for its tables as the second number, besides its body.
    local MOST_BYTES, SUMMARY_BYTES = 512 * 1024, 512
    -- The same for steps, of which each value takes as much as the second number.
    local MOST_STEP_BYTES, STEP_BYTES = 2048 * 1024, 20
    local HEADER = ("\0"):rep(HEADER_SIZE)
    local summaries, summary_bytes, step_bytes = {}, 0, 0

    function operations.forget()
        summaries, summary_bytes, step_bytes = {}, 0, 0
    end

    -- Keeps a summary that was read; its steps only from the second time on that its items are shown, because some
    -- programs never repeat a command.
    local function keep(body, summary, is_again)
        if summary_bytes > MOST_BYTES or step_bytes > MOST_STEP_BYTES then operations.forget() end
        if not summaries[body] then summary_bytes = summary_bytes + #body + SUMMARY_BYTES end
        summaries[body], summary.is_shown = summary, summary.steps ~= nil
        if not is_again then summary.steps = nil end
        step_bytes = step_bytes + (summary.steps and #summary.steps * STEP_BYTES or 0)
    end

    -- Returns the summary of a direct command by its bytes after the type, and its steps if they are wanted. Offsets
    -- are those in the frame.
    function operations.summary_of(body, wants_steps)
        local kept = summaries[body]
        if kept and (kept.steps or not wants_steps) then return kept, kept.steps end
        local text = HEADER .. body
        if #text < COMMAND_HEADER_SIZE then return { outputs = {} } end
        local summary = read(text, COMMAND_HEADER_SIZE, wants_steps, reading.memory_sizes(text))
        local steps = summary.steps
        keep(body, summary, kept and kept.is_shown)
        return summary, steps
    end

    -- Shows what was read. Returns its line, the offset after it, and the fault, or nil.
    local function show(summary, shown, item, view)
        if item then
            show_steps(shown, item, view.tvb, view.base)
        else
            local complaints = summary.complaints
            for index = 1, #complaints, 2 do
                complain(view.root, complaints[index], complaints[index + 1])
            end
        end
        return summary.line, summary.after, summary.fault
    end

    -- Shows the operations of a direct command.
    function operations.show(text, view)
        local summary, shown = operations.summary_of(sub(text, HEADER_SIZE + 1), view.item ~= nil)
        return show(summary, shown, view.item, view)
    end

    -- The same for the payload of a daisy command, from an offset on. Its layout is not certain: operations are shown
    -- only if all of it can be read.
    function operations.show_payload(text, at, view, payload)
        local summary = read(text, at, payload ~= nil)
        if summary.fault then return summary.line, summary.after, summary.fault end
        return show(summary, summary.steps, payload, view)
    end

    -- Gives each operation of a list the inputs that tell it apart from the others, as few of the first ones as do.
    local function tell_apart(list, telling)
        local count = 1
        for index = 1, #list[1] do
            local texts, known, distinct = {}, {}, 0
            for number, inputs in ipairs(list) do
                local own = inputs[index] or ""
                texts[number] = telling[inputs.at] and telling[inputs.at] .. " " .. own or own
                if not known[texts[number]] then known[texts[number]], distinct = true, distinct + 1 end
            end
            for number, inputs in ipairs(distinct > count and list or {}) do
                telling[inputs.at] = texts[number]
            end
            count = math.max(count, distinct)
        end
    end

    -- Gives the outputs of operations that have the same name a `telling`: the inputs in which these differ.
    local function add_tellings(summary, body)
        local known, has_twins = {}, false
        for _, name in ipairs(summary.names) do
            has_twins, known[name] = has_twins or known[name], true
        end
        if not has_twins then return end
        local text, at, reason, by_name, telling = HEADER .. body, COMMAND_HEADER_SIZE, nil, {}, {}
        while at < #text and not reason do
            local inputs = { at = at }
            local operation, after, _, fault = reading.read_operation(text, at, function(parameter, encoding, value)
                local key = parameter.key
                if key then inputs[#inputs + 1] = sub(key, 2) .. argument_text(parameter, encoding, value) end
            end)
            local list = operation and by_name[operation.name] or {}
            list[#list + 1] = inputs
            if operation then by_name[operation.name] = list end
            at, reason = after, fault
        end
        for _, list in pairs(by_name) do
            if list[2] then tell_apart(list, telling) end
        end
        for _, output in ipairs(summary.outputs) do output.telling = telling[output.at] end
    end

    -- Returns the values in a direct reply to a command, up to the end of its memory, and the first operation.
    function operations.read_outputs(body, reply)
        local summary = operations.summary_of(body)
        local memory, found, outputs = sub(reply.text, HEADER_SIZE + 1), {}, summary.outputs
        if #outputs > 1 and outputs[1].at ~= outputs[#outputs].at and not summary.is_told then
            summary.is_told = true
            add_tellings(summary, body)
        end
        for _, output in ipairs(outputs) do
            if reply_values.read(output, outputs, memory) then found[#found + 1] = output end
        end
        return found, summary.first
    end
end

-- Messages ----------------------------------------------------------------------------------------------------------
--
-- One frame, read up to its first fault. Each kind of message has one function, which returns the line for the info
-- column, and adds items if there is a tree. They share a `view`: `root`, the tree; `item`, the message's item, or nil;
-- `target`, for expert information, the item or else the root; `tvb` and `base`, the buffer and the frame's offset in
-- it; `place`, the message's place in the capture.

do
    local add, add_le, set_generated = TreeItem.add, TreeItem.add_le, TreeItem.set_generated
    local set_len, set_text = TreeItem.set_len, TreeItem.set_text
    local new_range = Tvb.range

    -- Bytes of a daisy command before its payload: the sub-command and two layers.
    local DAISY_PAYLOAD = 3

    local function bytes_between(view, at, stop)
        return new_range(view.tvb, view.base + at, stop - at)
    end

    local function add_rest(message, view, at)
        if view.item and at < message.stop then view.item:add(field.rest, bytes_between(view, at, message.stop)) end
    end

    local function set_fault(message, at, reason, kind)
        message.fault = { at = at, reason = reason, kind = kind }
    end

    -- Returns the line of a message that ends before its type's fixed fields.
    local function cut_off(message, view, reason)
        add_rest(message, view, HEADER_SIZE)
        set_fault(message, message.stop, reason, "cut_off")
        return message.type.name
    end

    local function show_direct_command(message, view)
        if message.stop < COMMAND_HEADER_SIZE then return cut_off(message, view, (phrases.finding("NO_MEMORY", {}))) end
        if view.item then
            local range = bytes_between(view, HEADER_SIZE, COMMAND_HEADER_SIZE)
            local asked = add_le(view.item, field.memory_sizes, range)
            add_le(asked, field.globals, range)
            add_le(asked, field.locals, range)
        end
        local line, after, fault = operations.show(message.text, view)
        message.fault = fault
        if fault then add_rest(message, view, after) end
        if line ~= "" then return line end
        if fault then return message.type.name end
        if not message.is_cut then complain(view.target, "refused", (phrases.finding("EMPTY", {}))) end
        return "no operations"
    end

    local function add_output(tree, view, output)
        local parameter, at, name = output.parameter, HEADER_SIZE + output.index, output.parameter.name
        local range = bytes_between(view, at, at + output.size)
        local list = output.value
        if type(list) ~= "table" then
            local item = operations.add_value(tree, parameter, range, list, parameter.numbered, output.dataset)
            if output.is_handle then set_text(item, name .. ": handle " .. list) end
            return
        end
        local item = add(tree, field.list, range):set_text(name .. ": " .. phrases.output_text(output))
        local size = output.size / #list
        for index, element in ipairs(list) do
            local start = at + (index - 1) * size
            local one = bytes_between(view, start, start + size)
            operations.add_value(item, parameter, one, element, format("%s[%d]", name, index - 1))
        end
    end

    -- Adds the values of a reply, grouped by operation.
    local function add_outputs(view, outputs)
        local first = 1
        while first <= #outputs do
            local at, last = outputs[first].at, first
            local start, stop = outputs[first].index, 0
            while outputs[last] and outputs[last].at == at do
                start = math.min(start, outputs[last].index)
                stop = math.max(stop, outputs[last].index + outputs[last].size)
                last = last + 1
            end
            local range = bytes_between(view, HEADER_SIZE + start, HEADER_SIZE + stop)
            local output = outputs[first]
            local item = add(view.item, field.answers, range, output.operation.name, nil, output.telling)
            for index = first, last - 1 do add_output(item, view, outputs[index]) end
            first = last
        end
    end

    local function show_direct_reply(message, view)
        local request, stop = view.request, message.stop
        if view.item and stop > HEADER_SIZE then
            add(view.item, field.memory, bytes_between(view, HEADER_SIZE, stop))
        end
        if message.type.is_error then
            local summary = request and operations.summary_of(request.body) or {}
            local why = summary.remark and "in the command, " .. summary.remark or "it does not say why"
            complain(view.target, "error_reply", "the brick refused the command or failed to execute it; " .. why)
            local first = summary.first
            return first and "error reply to " .. first.name or "error reply"
        end
        local size = phrases.plural(stop - HEADER_SIZE, "byte")
        if not request then return "reply: " .. size .. ", command not seen" end
        local outputs, first = operations.read_outputs(request.body, message)
        if view.item then add_outputs(view, outputs) end
        local head = first and "reply to " .. first.name .. ":" or "reply:"
        if outputs[1] then return phrases.values_text(head, outputs) end
        return head .. " " .. (stop == HEADER_SIZE and "ok" or size)
    end

    -- Returns the possible interpretations of a mailbox's message, whose type is not in the frame: field, value, and
    -- text.
    local function meanings_of(payload)
        local meanings = {}
        local function add_reading(kind, value, text)
            meanings[#meanings + 1] = { field = field["message_" .. kind], value = value, text = kind .. " " .. text }
        end
        if payload == "\0" or payload == "\1" then
            add_reading("logic", payload == "\1", payload == "\1" and "true" or "false")
        end
        if #payload == SIZE_OF[DATAF] then
            local number = reading.READ_TYPE[DATAF](payload, 0)
            add_reading("number", number, phrases.number_text(number))
        end
        local text = payload:match("^([^\0]*)\0$")
        if text and (#payload ~= SIZE_OF[DATAF] or not find(text, "[^\32-\126\160-\255]")) then
            add_reading("text", reading.utf8_text(text), phrases.shortened(text))
        end
        return meanings
    end

    -- Returns the main values of a system message: its texts, and the amount of data.
    local function fields_text(message)
        local pieces = {}
        for _, found in ipairs(message.fields) do
            local declared, value = found.declared, found.value
            local kind = declared.kind
            if kind == TEXT or kind == COUNTED_TEXT then
                pieces[#pieces + 1] = " " .. phrases.shortened(value)
            elseif kind == BYTES or kind == LISTING then
                local texts = {}
                for index, meaning in ipairs(declared.is_message and meanings_of(value) or {}) do
                    texts[index] = meaning.text
                end
                pieces[#pieces + 1] = " " .. (texts[1] and concat(texts, " or ") or phrases.plural(#value, "byte"))
            elseif not declared.counts and declared.name ~= "handle" then
                pieces[#pieces + 1] = format(declared.hexadecimal and " %s=0x%X" or " %s=%d", declared.filter, value)
            end
        end
        return concat(pieces)
    end

    -- Returns the subject of a system message; for a piece of a file, the file and its progress.
    local function subject_text(message, place)
        local transfer = dialogues.transfer_at(place)
        local is_first = message.command.transfer == "begin" and message.type.is_command
        if transfer and transfer.path ~= "" and not is_first then return " " .. phrases.transfer_text(transfer) end
        return fields_text(message)
    end

    local function status_text(status)
        return STATUS.names[status] or format("status %d", status)
    end

    -- Returns the meaning of a status for its command, after a colon; empty if the firmware does not use it there.
    local function status_meaning(message)
        local meaning = message.command and message.command.statuses[message.status]
        return meaning and ": " .. meaning or ""
    end

    local function add_system_message(message, view)
        local item, at, command, text = view.item, HEADER_SIZE, message.command, message.text
        if byte(text, at + 1) then
            local added = item:add(field.system_command, bytes_between(view, at, at + 1))
            if command then added:append_text(": " .. command.text) end
        end
        if message.status then
            local added = item:add(field.status, bytes_between(view, at + 1, at + 2), message.status)
            added:append_text(status_meaning(message))
        end
        for _, found in ipairs(message.fields) do
            local declared, range = found.declared, bytes_between(view, found.at, found.stop)
            local value = found.value
            if type(value) == "string" then value = reading.utf8_text(value) end
            local added = declared.kind == BYTES and item:add(declared.field, range)
                or item:add(declared.field, range, value)
            for _, meaning in ipairs(declared.is_message and meanings_of(found.value) or {}) do
                added:add(meaning.field, range, meaning.value)
            end
            -- A piece of a listing may begin and end within a line.
            for line in (declared.kind == LISTING and found.value or ""):gmatch("[^\n]+") do
                local size, name = line:match("^%x+ (%x+) (.+)$")
                local shown = phrases.on_one_line(name or line)
                if size then shown = format("%s, %s bytes", shown, phrases.number_text(tonumber(size, 16))) end
                added:add(range, shown)
            end
        end
        add_rest(message, view, message.rest)
    end

    -- Complains about a name and a message that are too long for a mailbox.
    local function check_mailbox(fields, target)
        for _, found in ipairs(fields) do
            local key = found.declared.is_message and "MAILBOX_CONTENT" or "MAILBOX_NAME"
            local size = type(found.value) == "string" and #found.value or 0
            if size > MOST_IN_MAILBOX[key] then complain(target, "misread", phrases.finding(key, { size = size })) end
        end
    end

    -- Commands and replies. Their fields were read with the frame, because file transfers need them.
    local function show_system_message(message, view)
        local command, status = message.command, message.status
        if view.item then add_system_message(message, view) end
        if command and command.has_message then check_mailbox(message.fields, view.target) end
        if status and (STATUS.fails[status] ~= false or message.type.is_error) then
            complain(view.target, "failed", "the command failed: " .. status_text(status) .. status_meaning(message))
        end
        if not command then
            local number = byte(message.text, HEADER_SIZE + 1)
            return number and format("system command 0x%02X", number) or message.type.name
        end
        local line = command.name .. subject_text(message, view.place)
        if message.type.is_command then return line end
        return "reply: " .. (status ~= STATUS.success and line .. " " .. status_text(status) or line)
    end

    -- Adds the two layers at an offset, and the payload after them. Returns the payload's item, if any.
    local function add_layers(message, view, at)
        local item, stop = view.item, message.stop
        if not item then return nil end
        item:add(field.layer_from, bytes_between(view, at, at + 1))
        item:add(field.layer_to, bytes_between(view, at + 1, at + 2))
        return at + 2 < stop and item:add(field.daisy_payload, bytes_between(view, at + 2, stop)) or nil
    end

    local function show_daisy_command(message, view)
        local text, at = message.text, HEADER_SIZE
        if message.stop < at + DAISY_PAYLOAD then
            return cut_off(message, view, (phrases.finding("UNKNOWN_DAISY", { reason = REASONS.daisy_command })))
        end
        local number, from, to = byte(text, at + 1, at + 3)
        local name = DAISY.names[number]
        if not name then
            local reason = phrases.filled(REASONS.no_daisy, { byte = format("0x%02X", number) })
            set_fault(message, at, phrases.finding("UNKNOWN_DAISY", { reason = reason }), "fault")
        end
        if view.item then view.item:add(field.daisy_command, bytes_between(view, at, at + 1)) end
        local payload = add_layers(message, view, at + 1)
        local line = format("daisy %s layer %d to %d", name or format("0x%02X", number), from, to)
        at = at + DAISY_PAYLOAD
        if at == message.stop or not DAISY.carries_operations[number] then return line end
        -- The payload's layout is not certain: operations are shown only if all of it can be read.
        local said, _, fault = operations.show_payload(text, at, view, payload)
        return fault and line or line .. ": " .. said
    end

    local function show_daisy_reply(message, view)
        local at, stop = HEADER_SIZE, message.stop
        if stop < at + 2 then return cut_off(message, view, REASONS.daisy_reply) end
        local payload = add_layers(message, view, at)
        local line = format("daisy reply layer %d to %d", byte(message.text, at + 1, at + 2))
        at = at + 2
        if not payload or stop - at < DAISY.sensor_report_size then return line end
        for _, declared in ipairs(DAISY.sensor_report) do
            -- The last part extends to the end.
            local after = declared.size and at + declared.size or stop
            if after > at then payload:add(field["daisy_" .. declared.name], bytes_between(view, at, after)) end
            at = after
        end
        return line
    end

    local function show_unknown_message(message, view)
        local code = byte(message.text, HEADER_SIZE)
        add_rest(message, view, HEADER_SIZE)
        local reason = phrases.finding("UNKNOWN_TYPE", { type = format("0x%02X", code) })
        set_fault(message, HEADER_SIZE - 1, reason, "fault")
        return format("message of unknown type 0x%02X", code)
    end

    local SHOW_COMMAND = { direct = show_direct_command, system = show_system_message, daisy = show_daisy_command }
    local SHOW_REPLY = { direct = show_direct_reply, system = show_system_message, daisy = show_daisy_reply }

    -- Tells whether a fault in the captured beginning of a frame is real: with zeros for the rest, it is the same.
    local function is_real(fault, message)
        local type = message.type
        if not type or type.carries == "daisy" then return fault.kind ~= "cut_off" end
        local whole = messages.read(message.text .. ("\0"):rep(message.size - message.stop))
        local found = whole.fault
        if type.carries == "direct" then found = operations.summary_of(sub(whole.text, HEADER_SIZE + 1)).fault end
        return found ~= nil and found.at == fault.at and found.reason == fault.reason
    end

    -- A truncated frame has no other fault at its end.
    local function check_size(message)
        local stop, size, fault = message.stop, message.size, message.fault
        if stop == size then return end
        if message.is_cut then
            if fault and is_real(fault, message) then return end
            set_fault(message, stop, format("the capture has %d of the frame's %d bytes", stop, size), "cut_by_capture")
        elseif not fault or fault.kind == "cut_off" then
            local stated = phrases.plural(size - LENGTH_FIELD, "byte") .. " follow"
            local reason = phrases.finding("CUT_FRAME", { stated = stated, follow = stop - LENGTH_FIELD })
            set_fault(message, 0, reason, "cut_off")
        end
    end

    -- `reply` is the packet of the reply, nil without one, false if that is not known yet.
    local function add_links(message, view, is_new, reply, is_given_up)
        local type, item, target, place = message.type, view.item, view.target, view.place
        if not type or message.is_overwritten then return end
        if item and dialogues.is_locked(place) then complain(target, "locked", UNLOCK.missing) end
        if type.wants_reply then
            if is_given_up then
                complain(target, "unanswered", "no reply to this command was seen")
            elseif reply == nil then
                complain(target, "waiting", "no reply to this command was seen so far")
            elseif reply and item then
                set_generated(add(item, field.response_in, reply))
            end
        elseif not type.is_command then
            local request = view.request
            if not request then
                complain(target, "orphan", "the command that this reply answers was not seen")
            elseif item then
                local seconds = floor(request.delay / 1e9)
                set_generated(add(item, field.request_in, storage.number_of(request.place)))
                set_generated(add(item, field.response_time, NSTime.new(seconds, request.delay - seconds * 1e9)))
            end
            local asked, size = request and dialogues.asked_size(message, request.body), message.size - HEADER_SIZE
            if asked and asked ~= size then
                local values = { asked = phrases.plural(asked, "byte"), size = size }
                complain(target, "other_size", phrases.filled(PAIRING.other_size, values))
            elseif request and request.is_unsure then
                complain(target, "unsure", PAIRING.unsure)
            end
        end
        local trouble = message.command and dialogues.trouble_at(place, is_new)
        if trouble then complain(target, "incomplete_file", trouble) end
        local transfer = item and dialogues.transfer_at(place)
        if transfer then
            set_generated(add(item, field.transfer_path, reading.utf8_text(transfer.path)))
            set_generated(add(item, field.transfer_done, transfer.done))
            if transfer.size then set_generated(add(item, field.transfer_size, transfer.size)) end
        end
    end

    local function read_system_fields(message)
        local text, at, stop, type = message.text, HEADER_SIZE, message.stop, message.type
        message.fields = {}
        local start = type.is_command and at + 1 or at + 2
        if stop < start then
            message.rest = type.is_command and stop or at
            local reason = type.is_command and phrases.finding("NO_SYSTEM", {}) or REASONS.system_reply
            return set_fault(message, stop, reason, "cut_off")
        end
        local number = byte(text, at + 1)
        if not type.is_command then message.status = byte(text, at + 2) end
        message.command = SYSTEM_COMMANDS[number]
        if not message.command then
            message.rest = start
            local reason = phrases.finding("UNKNOWN_SYSTEM", { number = format("0x%02X", number) })
            return set_fault(message, at, reason, "fault")
        end
        local declared = type.is_command and message.command.request or message.command.reply
        -- Replies to failed commands may end before any field.
        local is_complete = type.is_command or (message.status == STATUS.success and not type.is_error)
        message.fields, message.rest, message.fault =
            reading.read_fields(text, start, stop, declared, is_complete, message.command.name)
    end

    -- Reads a frame. `text` may be shorter than its length field says.
    function messages.read(text)
        local low, high, first, second, code = byte(text, 1, HEADER_SIZE)
        local message = {
            text = text, stop = #text, size = LENGTH_FIELD + low + high * 0x100,
            counter = first + second * 0x100, type = MESSAGE_TYPES[code],
        }
        if message.type and message.type.carries == "system" then read_system_fields(message) end
        return message
    end

    -- Adds the item of a message, with its header. Its text comes later.
    local function add_frame(tree, tvb, base, message, place, brick)
        local range = new_range(tvb, base, message.stop)
        local item = add_item(tree, range, brick)
        set_generated(add(item, field.connection, dialogues.number_at(place)))
        -- A range costs more than an item: the length shares the frame's.
        set_len(add(item, field.length, range, message.size - LENGTH_FIELD), LENGTH_FIELD)
        add_le(item, field.counter, new_range(tvb, base + LENGTH_FIELD, 2))
        add(item, field.type, new_range(tvb, base + HEADER_SIZE - 1, 1))
        return item
    end

    -- Shows a message. Returns its line and, with a tree, its item. The frame is at offset `base` of the buffer; `said`
    -- replaces the message's own line; `is_new` is true in the first pass.
    function messages.show(message, place, tvb, base, tree, brick, said, is_new)
        local type, item = message.type, brick and add_frame(tree, tvb, base, message, place, brick) or nil
        local view = {
            root = tree, item = item, target = item or tree, tvb = tvb, base = base, place = place, request = nil,
        }
        local show = show_unknown_message
        if type and type.is_command then
            show = SHOW_COMMAND[type.carries]
        elseif type then
            show, view.request = SHOW_REPLY[type.carries], dialogues.request_of(place)
        end
        local line = show(message, view)
        check_size(message)
        if message.slip then set_fault(message, 0, message.slip, "fault") end
        local fault = message.fault
        if said then
            line = said
        elseif fault and fault.kind == "cut_by_capture" then
            line = line .. " [cut by the capture]"
        elseif fault then
            line = format("%s [fault at offset %d: %s]", line, fault.at, fault.reason)
        end
        -- In the first pass, the reply is still to come.
        local reply, is_given_up = false, false
        if type and type.wants_reply and not is_new then reply, is_given_up = dialogues.reply_to(place) end
        if is_given_up then line = line .. " (no reply)" end
        if item then set_text(item, "EV3: " .. line) end
        add_links(message, view, is_new, reply, is_given_up)
        if fault then complain(view.target, fault.kind, format("at offset %d: %s", fault.at, fault.reason)) end
        return line, item
    end
end

-- Frames in packets -------------------------------------------------------------------------------------------------
--
-- What all carriers have in common: one frame in a buffer, and the columns of a packet.

-- Tells whether the tree is needed: not for one-line output if filters, columns and colours use only other protocols.
local has_tree
do
    local this_dissector
    local is_referenced = TreeItem.referenced

    function has_tree(tree)
        this_dissector = this_dissector or Dissector.get("ev3")
        return is_referenced(tree, this_dissector)
    end
end

-- The columns of a packet. If frames are split over packets, TCP passes a packet on in several buffers; the text of
-- each is appended to the info column, which Wireshark truncates.
local start_line, say, show
do
    local pieces, shown, last_number, last_offset = {}, 0, 0, 0

    -- Begins a buffer: the first one of a packet, or another one of the same packet.
    function start_line(number, offset)
        if number ~= last_number or offset <= last_offset then pieces, shown = {}, 0 end
        last_number, last_offset = number, offset
    end

    function say(said)
        pieces[#pieces + 1] = said
    end

    function show(pinfo, tvb, tree)
        -- The protocol hierarchy counts items; before 4.6 has_tree does not tell. If there is a tree, Wireshark's own
        -- item for Lua is hidden.
        if tree.hidden and not has_tree(tree) then tree:add(ev3, tvb) end
        local columns, count = pinfo.cols, #pieces
        columns.protocol = "EV3"
        if count == shown then return end
        local text = concat(pieces, "; ", shown + 1, count)
        if shown > 0 then
            columns.info:append("; " .. text)
        else
            columns.info = text
        end
        shown = count
    end
end

-- Claims and Finding below decide which conversations are a brick's, and where frames start.
local claiming, finding = {}, {}

-- Each carrier below adds its dissectors, by Wireshark's type of ports, and a table: `register`, which registers them;
-- `forget`, which drops the state of the last capture and begins each; optionally `prefs_changed`.
local dissectors, carriers = {}, {}

-- Looking up these methods for each packet would take longer than calling them.
local bytes_of, captured_len, offset_of = Tvb.raw, Tvb.len, Tvb.offset

local function is_command(type) return type.is_command end

-- The number of the first packet with data of which the capture has only the beginning, as with a snap length.
local first_cut = math.huge

-- Tells whether data end where the capture cut their packet.
local function is_cut_by_capture(tvb, stop, pinfo)
    if stop < tvb:len() or pinfo.caplen >= pinfo.len then return false end
    first_cut = math.min(first_cut, pinfo.number)
    return true
end

-- Dissects a message in a buffer. `conversation` is given in the first pass only; `said` replaces the message's own
-- line. Returns the line for the info column and, if there is a tree, the message's item.
local function dissect_message(tvb, at, message, conversation, place, pinfo, tree, brick, said)
    if conversation then
        dialogues.take_note(place, conversation, message, pinfo)
        claiming.note(conversation, message)
    end
    message.is_cut = message.stop < message.size and is_cut_by_capture(tvb, at + message.stop, pinfo)
    local line, item = messages.show(message, place, tvb, at, tree, brick, said, conversation)
    storage.free_unused(brick)
    return line, item
end

-- Returns the offset after the frame that starts at an offset, by its length; nil without a length.
local function stop_of(text, at)
    local length = reading.unsigned16(text, at)
    return length and at + LENGTH_FIELD + length
end

-- Reads the frame at an offset of a text.
function messages.read_at(text, at)
    return messages.read(sub(text, at + 1, stop_of(text, at)))
end

local function is_usual_length(length)
    return length >= MIN_LENGTH and length <= MAX_LENGTH
end

-- Tells whether the length field at an offset can be a frame's; those of downloads may be larger than all others.
local function is_length(text, at)
    local length = reading.unsigned16(text, at)
    if is_usual_length(length) then return true end
    local code, number = byte(text, at + HEADER_SIZE, at + HEADER_SIZE + 1)
    local type, command = MESSAGE_TYPES[code], SYSTEM_COMMANDS[number]
    if length < MIN_LENGTH or not type or not type.is_command then return false end
    return type.carries == "system" and (not number or command ~= nil and command.is_long == true)
end

-- Tells whether a frame may start at an offset, judging by as much of its header as is present.
local function may_start(text, at)
    if #text - at < LENGTH_FIELD then return #text > at end
    local type = byte(text, at + HEADER_SIZE)
    return is_length(text, at) and (not type or MESSAGE_TYPES[type] ~= nil)
end

-- Returns the offset after the polls at an offset: lengths of 0 between frames, which the brick ignores.
local function after_polls(text, at)
    while sub(text, at + 1, at + LENGTH_FIELD) == "\0\0" do at = at + LENGTH_FIELD end
    return at
end

-- Claims ------------------------------------------------------------------------------------------------------------
--
-- Decides which conversations are a brick's, since other protocols use the same ports and channels. The rule is in
-- ev3proto's tables. Decisions are made in the first pass, and kept.

-- Results of judging data: OURS; PART if more is needed to decide; nil if they are not a brick's.
local OURS, PART = "ours", "part"

-- Results of searching them: CHAIN, a plausible command; SINGLE, whole frames that a reply may prove; OPEN, bytes that
-- may become a command.
local CHAIN, SINGLE, OPEN = "chain", "single", "open"

do
    -- Reads operations from an offset on. `judge` gets the opcode of each, `visit` each argument. Returns nil, or the
    -- kind of the fault that ends them, and its operation. `set` has the instructions, by default the preferred ones.
    function claiming.scan(text, at, stop, judge, visit, set)
        while at < stop do
            local code = byte(text, at + 1)
            if code == CLAIMS.never_sent then return "fault" end
            local operation, after, _, reason, kind = reading.read_operation(text, at, visit, set)
            if operation and judge then judge(code) end
            if reason then return kind, operation end
            at = after
        end
    end

    -- Tells whether a frame has no fault and a meaning: empty commands and impossible layers have none.
    function claiming.is_sensible(message)
        local type, text = message.type, message.text
        if not type or message.stop < message.size or message.fault then return false end
        if type.carries == "daisy" then
            local at = HEADER_SIZE + (type.is_command and 2 or 1)
            local from, to = byte(text, at, at + 1)
            if not to or type.is_command and not DAISY.names[byte(text, HEADER_SIZE + 1)] then return false end
            return math.max(from, to) <= DAISY.most_layers
        end
        if type.carries ~= "direct" or not type.is_command then return true end
        return message.stop > COMMAND_HEADER_SIZE and not claiming.scan(text, COMMAND_HEADER_SIZE, message.stop)
    end

    -- Tells whether an argument has a kind and range that its parameter accepts; `sizes` is the requested memory, by
    -- scope.
    local function is_in_place(parameter, encoding, value, sizes)
        if encoding.scope then return value < sizes[encoding.kind] end
        local wrong = phrases.judge(parameter, encoding, value)
        return not (value == 0 and parameter.is_set) and (not wrong or CLAIMS.still_sent[wrong] == true)
    end

    -- The same for all operations of a direct command by a firmware's instructions; at least one must be evidence.
    local function fits(text, stop, is_cut, set)
        local sizes, is_right, is_telling = {}, true, false
        sizes[GLOBAL], sizes[LOCAL] = reading.memory_sizes(text)
        local function visit(parameter, encoding, value)
            is_right = is_right and is_in_place(parameter, encoding, value, sizes)
        end
        local function judge(code)
            if CLAIMS.only_in_programs[code] then is_right = false end
            if not CLAIMS.not_telling[code] then is_telling = true end
        end
        local kind = claiming.scan(text, COMMAND_HEADER_SIZE, stop, judge, visit, set)
        return is_right and is_telling and (not kind or is_cut and kind == "cut_off")
    end

    -- Tells whether a message is a plausible command by the instructions of some firmware. With `is_cut` the capture
    -- has only its beginning, which then counts.
    function claiming.is_plausible(message, is_cut)
        local type, stop = message.type, message.stop
        if not type or not type.is_command then return false end
        if not is_cut and (stop < message.size or message.fault) then return false end
        if type.carries == "direct" then
            if stop < COMMAND_HEADER_SIZE then return false end
            for _, set in pairs(INSTRUCTION_SETS) do
                if fits(message.text, stop, is_cut, set) then return true end
            end
            return false
        end
        if is_cut then return false end
        if type.carries == "daisy" then return claiming.is_sensible(message) end
        local counter = message.counter
        return counter ~= CLAIMS.nxt_write and counter - CLAIMS.nxt_flag ~= CLAIMS.nxt_write
    end

    -- The types with which a claim of a stream begins.
    function claiming.begins(type) return type.is_command and type.carries ~= "daisy" end

    -- The state of a conversation: nil, not claimed; "claimed" from a plausible command, or from replies, on;
    -- "answered", when a reply has proved it: faulty frames keep the claim, too; "sure", for good; "ended", claimed
    -- before: a new claim may begin anywhere in a packet.
    local IS_CLAIMED = { claimed = true, answered = true, sure = true }

    function claiming.is_claimed(conversation) return IS_CLAIMED[conversation.state] == true end

    -- Claims a conversation from now on.
    function claiming.begin(conversation, state)
        conversation.state, conversation.held, conversation.replies = state or "claimed", {}, 0
        conversation.strange, conversation.unread, conversation.has_frame, conversation.is_good = 0, 0, false, false
        conversation.claims = (conversation.claims or 0) + 1
    end

    -- Takes a packet with commands that a reply has proved.
    local function adopt(conversation, packet)
        local offset = packet.adopt(packet.number, packet.frames[1].at)
        for _, frame in ipairs(packet.frames) do
            local place = storage.place_of(packet.number, offset + frame.at)
            dialogues.take_note(place, conversation, frame.message, { rel_ts = packet.time })
        end
    end

    -- Claims a conversation, beginning with a waiting command, if a frame from another side is its reply.
    local function is_proved(conversation, side, reply)
        local held = conversation.held or {}
        for index = #held, 1, -1 do
            local packet = held[index]
            for _, frame in ipairs(packet.side ~= side and packet.frames or {}) do
                if dialogues.proves(reply, frame.message) then
                    claiming.begin(conversation, "answered")
                    conversation.side_to_brick = packet.side
                    for later = index, #held do
                        if held[later].side ~= side then adopt(conversation, held[later]) end
                    end
                    return true
                end
            end
        end
        return false
    end

    -- Counts complete, non-empty replies; they begin a claim if there are enough in a row.
    local function has_replies(conversation, text)
        local places, stop = finding.frames_of(text, 0, #text)
        local count = (conversation.replies or 0) + #places
        for _, at in ipairs(places) do
            local message = messages.read_at(text, at)
            local type = message.type
            local is_empty = type.carries == "direct" and (type.is_error or message.stop == HEADER_SIZE)
            if type.is_command or type.carries == "daisy" or message.fault or is_empty then count = 0 end
        end
        conversation.replies = stop == #text and count or 0
        if conversation.replies < CLAIMS.replies then return false end
        claiming.begin(conversation)
        return true
    end

    -- Judges the newest packet of a conversation that is not claimed, and what waits before it. `packet` has
    --   side       its direction
    --   to_brick   whether that goes to the brick; nil if only commands tell
    --   text       the bytes, in which packets begin at `starts`, the newest last
    --   reported   their number on the wire
    --   begins     tells which types begin a claim
    --   adopt      is called when a reply has proved its commands, with the packet's number and the offset of the first
    --              of them; returns the offset of the text in the packet
    -- Returns CHAIN and the offset from which on it is ours; OPEN and the offset of what waits; SINGLE; or nil.
    function claiming.judge(conversation, pinfo, packet)
        local text, starts, side = packet.text, packet.starts, packet.side
        if not packet.to_brick then
            local newest = starts[#starts]
            -- Its length, counter and type are enough: the rest of a long reply comes in later packets.
            local is_reply = #text - newest >= HEADER_SIZE and is_length(text, newest)
            local reply = is_reply and messages.read_at(text, newest)
            if reply and is_proved(conversation, side, reply) then return CHAIN, newest end
        end
        if packet.to_brick == false then return has_replies(conversation, text) and CHAIN or nil, 0 end
        local is_ended = conversation.state == "ended"
        local found, place = finding.find_command(text, starts, packet.begins, packet.reported, is_ended)
        if found == CHAIN and packet.needs_reply then found = SINGLE end
        if found == CHAIN then
            claiming.begin(conversation)
            conversation.side_to_brick = side
        elseif found == SINGLE then
            packet.frames, packet.number, packet.time = {}, pinfo.number, pinfo.rel_ts
            for index, at in ipairs((finding.frames_of(text, place, packet.reported))) do
                packet.frames[index] = { at = at, message = messages.read_at(text, at) }
            end
            local held = conversation.held or {}
            if #held == CLAIMS.most_held then table.remove(held, 1) end
            held[#held + 1], conversation.held = packet, held
        end
        return found, place
    end

    -- Records a message of a claimed conversation, in the first pass.
    function claiming.note(conversation, message)
        if not claiming.is_claimed(conversation) or conversation.state == "sure" then return end
        conversation.has_frame = true
        local is_answered = conversation.state == "answered"
        conversation.is_good = conversation.is_good or not is_answered
            and (message.slip ~= nil or claiming.is_sensible(message))
    end

    -- Counts a packet of a claimed conversation; `size` is the number of its bytes outside of frames.
    function claiming.count(conversation, size, number)
        local is_good, has_frame = conversation.is_good, conversation.has_frame
        local is_answered = conversation.state == "answered"
        conversation.is_good, conversation.has_frame = false, false
        if conversation.state == "sure" or not has_frame and size == 0 then return end
        if is_good or is_answered and has_frame then
            conversation.strange, conversation.unread, conversation.counted = 0, 0, number
            return
        end
        -- A packet counts once, even if it comes in several buffers.
        if conversation.counted ~= number then conversation.strange = conversation.strange + 1 end
        conversation.unread, conversation.counted = conversation.unread + size, number
        -- In a dialogue, the rest of a frame may come in many packets.
        if conversation.strange >= CLAIMS.strange_packets
            and (not is_answered or conversation.unread > LENGTH_FIELD + MAX_LENGTH) then
            conversation.state, conversation.side_to_brick = "ended", nil
        end
    end
end

-- Finding -----------------------------------------------------------------------------------------------------------
--
-- Finds frames in streams that are not claimed yet, or out of step after a gap. A header alone is often a coincidence,
-- so a frame is also judged by its contents and by what follows it.

do
    -- Maximum number of places in one piece of a stream where a frame is parsed.
    local MOST_TRIALS = 64

    -- Number of following headers that confirm a frame, which are checked at most.
    finding.MOST_FOLLOWING = 2

    -- The minimum size of a command that is cut or inside a packet: one byte of operations, as NOP, proves nothing.
    local LEAST = COMMAND_HEADER_SIZE + 2

    -- Tells whether an incomplete frame at an offset may become one without a fault.
    function finding.may_become(text, at, accepts)
        if not may_start(text, at) then return false end
        local code, number = byte(text, at + HEADER_SIZE, at + HEADER_SIZE + 1)
        local type = MESSAGE_TYPES[code]
        if not type then return true end
        if not accepts(type) then return false end
        if type.carries == "system" then return not number or SYSTEM_COMMANDS[number] ~= nil end
        if type.carries ~= "direct" or not type.is_command then return true end
        local kind, operation = claiming.scan(text, at + COMMAND_HEADER_SIZE, #text)
        -- A list that continues in the next packet has the fault of being too long.
        return not kind or kind == "cut_off" or kind == "fault" and operation ~= nil and operation.list ~= nil
    end

    -- Iterates over the places from an offset on where the header of an accepted type may be: place, end of the frame,
    -- type.
    local function each_start(text, at, accepts)
        local hit, trials = at + 1, 0
        return function()
            while trials < MOST_TRIALS do
                hit = find(text, HEADER_PATTERN, hit + 1)
                if not hit then return nil end
                local place = hit - 2
                local type = MESSAGE_TYPES[byte(text, place + HEADER_SIZE)]
                if is_length(text, place) and accepts(type) then
                    trials = trials + 1
                    return place, stop_of(text, place), type
                end
            end
        end
    end

    -- Returns the first place from an offset on where an incomplete header may start at the end of a text, nil if there
    -- is none.
    function finding.header_at_end(text, at)
        for place = math.max(#text - HEADER_SIZE + 1, at), #text - 1 do
            if may_start(text, place) then return place end
        end
    end

    -- Returns the offsets of the whole frames that follow each other from an offset on, and the offset after them. The
    -- last one may be cut by the capture: it then ends at `reported`.
    function finding.frames_of(text, at, reported)
        local places = {}
        while #text - at >= HEADER_SIZE and may_start(text, at) do
            local stop = stop_of(text, at)
            if stop > #text and stop ~= reported then break end
            places[#places + 1], at = at, stop
        end
        return places, at
    end

    -- Tells whether whole frames of accepted types fill a text from an offset on, sensible ones if that is asked.
    function finding.is_filled(text, at, accepts, reported, is_sensible)
        local places, stop = finding.frames_of(text, at, reported)
        for _, place in ipairs(places) do
            if not accepts(MESSAGE_TYPES[byte(text, place + HEADER_SIZE)]) then return false end
            if is_sensible and not claiming.is_sensible(messages.read_at(text, place)) then return false end
        end
        return stop == reported and places[1] ~= nil
    end

    local function is_split(starts, place, stop)
        for _, start in ipairs(starts) do
            if place < start and start < stop then return true end
        end
        return false
    end

    -- Counts consecutive headers from an offset on, a few at most; nil if none can start there.
    function finding.follow(text, at)
        local size, count = #text, 0
        while at < size and count < finding.MOST_FOLLOWING do
            at = after_polls(text, at)
            if at < size and not may_start(text, at) then return nil end
            if size - at < HEADER_SIZE then break end
            at, count = stop_of(text, at), count + 1
        end
        return count
    end

    -- Returns the slip in the length field of a command that was sent alone, up to an offset, and the length; nil if it
    -- has none. `accept` judges the command with the right length.
    local function slip_in(text, at, sent, accept)
        local follow = sent and sent - at - LENGTH_FIELD
        if not follow or follow <= MIN_LENGTH then return nil end
        local length, slip = reading.unsigned16(text, at), nil
        local head, more = string.char(follow % 0x100, floor(follow / 0x100)), length - follow
        if more == LENGTH_FIELD then
            slip = "length_self"
        elseif more ~= 0 and head:reverse() == sub(text, at + 1, at + LENGTH_FIELD) then
            slip = "length_swapped"
        elseif more ~= 0 and math.abs(more) <= 2 then
            slip = "length"
        end
        local meant = slip and messages.read(head .. sub(text, at + LENGTH_FIELD + 1, sent))
        return meant and meant.type and meant.type.is_command and accept(meant) and slip, length
    end

    -- Searches for a command with which a claim begins. Packets begin at `starts`: anything may follow a command there,
    -- elsewhere another header must, at least its length. With `anywhere`, as after a gap, frames may begin and end
    -- anywhere. Returns what is found first, of a CHAIN, a SINGLE, what is OPEN, and its offset; or nil.
    function finding.find_command(text, starts, accepts, reported, anywhere)
        local size, is_begin = #text, {}
        local function examine(place)
            local sent = size
            for index = #starts, 1, -1 do
                if starts[index] > place then sent = starts[index] end
            end
            if is_begin[place] and reported == size and slip_in(text, place, sent, claiming.is_plausible) then
                return CHAIN
            end
            local code, number = byte(text, place + HEADER_SIZE, place + HEADER_SIZE + 1)
            local type, stop = MESSAGE_TYPES[code], stop_of(text, place)
            if not may_start(text, place) or type and not accepts(type) then return nil end
            local is_cut = type and reported > size and stop == reported and size - place >= LEAST
            local is_whole = type and stop <= size or is_cut
            local is_data = type and type.carries == "system" and (SYSTEM_COMMANDS[number] or {}).has_data
            if is_data and (not is_whole or is_split(starts, place, stop)) then return nil end
            if not is_whole then
                return (is_begin[place] or anywhere) and finding.may_become(text, place, accepts) and OPEN or nil
            end
            local is_enough = stop - place >= LEAST and (anywhere or size - stop >= LENGTH_FIELD)
            local is_followed = is_enough and (stop == size or may_start(text, stop)) and finding.follow(text, stop)
            local message = (is_begin[place] or is_followed) and messages.read_at(text, place)
            if message and claiming.is_plausible(message, is_cut) then return CHAIN end
            return is_begin[place] and finding.is_filled(text, place, accepts, reported) and SINGLE or nil
        end
        local places, first = {}, {}
        for index, start in ipairs(starts) do places[index], is_begin[start] = start, true end
        for place in each_start(text, 0, accepts) do
            if not is_begin[place] then places[#places + 1] = place end
        end
        for place = math.max(size - HEADER_SIZE + 1, 0), anywhere and size - 1 or -1 do
            if not is_begin[place] then places[#places + 1] = place end
        end
        table.sort(places)
        for _, place in ipairs(places) do
            local found = (is_begin[place] or not first[SINGLE]) and examine(place)
            if found == CHAIN then return CHAIN, place end
            if found then first[found] = first[found] or place end
        end
        if first[SINGLE] then return SINGLE, first[SINGLE] end
        return first[OPEN] and OPEN, first[OPEN]
    end

    -- Finds where a stream that is out of step continues, from an offset on. Returns the place of a complete frame
    -- without a fault, and the number of headers after it, at least `least`; else the place of an incomplete frame that
    -- may have no fault; else nil. Packets start at `first` and `second`: a frame there may have faults, or be followed
    -- by anything.
    function finding.find_step(text, at, accepts, least, first, second)
        local open, single, begun
        for place, stop in each_start(text, at, accepts) do
            local following, is_begin = stop <= #text and finding.follow(text, stop), place == first or place == second
            if stop > #text then
                if not open and finding.may_become(text, place, accepts) then open = place end
            elseif (following or is_begin) and (following or 0) >= least then
                local is_sound = claiming.is_sensible(messages.read_at(text, place))
                if is_sound and following and following > 0 then return place, following end
                if is_sound and following then
                    single = single or place
                elseif is_begin and (is_sound or following) then
                    begun = begun or place
                end
            end
        end
        if single or begun then return single or begun, 0 end
        return open
    end

    -- Returns what is wrong with the length field of a frame, nil if nothing is. Its packet starts with it and ends at
    -- `sent`, and the field says nearly that size; only with the right length the frame makes sense.
    function finding.slip_of(text, at, sent, is_last)
        local slip, length = slip_in(text, at, sent, claiming.is_sensible)
        if not slip then return nil end
        local stop = is_length(text, at) and stop_of(text, at) or #text
        -- An empty command has no fault.
        if stop > #text and not is_last or stop == at + COMMAND_HEADER_SIZE then return nil end
        if is_length(text, at) and claiming.is_sensible(messages.read_at(text, at)) then return nil end
        local said = { length = length, follow = sent - at - LENGTH_FIELD, more = LENGTH_FIELD }
        return phrases.filled(SLIPS[slip], said)
    end

    -- Judges a frame that seems to be split over several packets, with possible gaps between them: OURS, PART, or nil.
    -- The newest packet starts at `joint`.
    function finding.judge_split(text, at, accepts, joint, is_last)
        local stop = stop_of(text, at)
        if stop > #text then
            if finding.may_become(text, at, accepts) then return PART end
            local _, following = finding.find_step(text, at + 1, accepts, 0)
            return not following and PART or nil
        end
        local message, following = messages.read_at(text, at), finding.follow(text, stop)
        local type = message.type
        local is_sound = type and accepts(type) and claiming.is_sensible(message)
        if not following then return nil end
        -- A whole frame that ends with its packet is complete, whatever its data look like.
        if is_sound and stop == #text and stop > joint then return OURS end
        -- Random bytes are rarely valid operations.
        if is_sound and (following > 0 or type.is_command and type.carries == "direct") then return OURS end
        -- After a gap between two packets, frames start in the newer one.
        local inside, following_inside = finding.find_step(text, is_sound and joint or at + 1, accepts, 0, joint)
        local is_inside = inside and inside < stop
        if is_inside and following_inside then return nil end
        -- A header after a frame without a fault confirms it, two do after another.
        local is_open = is_inside and following <= (is_sound and 0 or 1) or following == 0 and not is_sound
        return is_open and not is_last and PART or OURS
    end
end

-- Streams -----------------------------------------------------------------------------------------------------------
--
-- The byte stream of a TCP connection or of RFCOMM. Frames may be split over packets and share them; over TCP a text
-- from each side may precede them.

-- `sure_places`: where bytes are in no frame, in conversations that are a brick's for sure.
local streaming = { sure_places = {} }
do
    -- Matches the text that unlocks the brick's port: the offset after it, and the serial number.
    local function match_unlock(text, at)
        local serial, newline, after
        for _, pattern in ipairs(UNLOCK.patterns) do
            if not serial then serial, newline, after = text:match(pattern, at + 1) end
        end
        if not serial then return nil end
        for _ = 1, UNLOCK.endings do
            if sub(text, after, after + #newline - 1) == newline then after = after + #newline end
        end
        return after - 1, serial
    end

    -- Adds bytes that are not a frame. Returns their line, the offset after them, and their item, nil without a tree.
    local function add_bytes(stream, at, stop, said, declared)
        if not stream.brick then return said, stop end
        local range = stream.tvb(at, stop - at)
        local item = add_item(stream.tree, range, stream.brick, said)
        item:add(declared, range)
        return said, stop, item
    end

    -- Dissects one of the texts: its line, and the offset after it; else nil. The firmware also sends the terminating
    -- zero of its answer, unless that zero is the start of a frame's length.
    local function dissect_text(stream, at)
        local text = stream.text
        local after, serial = match_unlock(text, at)
        if after then
            local _, _, item = add_bytes(stream, at, after, "unlock " .. serial, field.unlock)
            if item then item:add(field.unlock_serial, stream.tvb(at + #UNLOCK.request, #serial)) end
            return "unlock " .. serial, after
        end
        after = at + #UNLOCK.answer
        if sub(text, at + 1, after) ~= UNLOCK.answer then return nil end
        local zero, next = byte(text, after + 1, after + 2)
        if zero == 0 and not (next and is_length(text, after)) then after = after + 1 end
        return add_bytes(stream, at, after, "accepted", field.accept)
    end

    -- Tells whether one of the texts may begin here and continue in the next segment.
    local function is_part_of_text(text, at)
        local part = sub(text, at + 1)
        if find(UNLOCK.answer, part, 1, true) == 1 or find(UNLOCK.request, part, 1, true) == 1 then return true end
        return #part < UNLOCK.most_bytes and sub(part, 1, #UNLOCK.request) == UNLOCK.request
    end

    -- Judges data at the start of a connection: OURS if they begin with one of the texts, PART, or nil.
    function streaming.judge_text(text)
        if not UNLOCK.starts[byte(text, 1)] then return nil end
        if sub(text, 1, #UNLOCK.answer) == UNLOCK.answer or match_unlock(text, 0) then return OURS end
        return is_part_of_text(text, 0) and PART or nil
    end

    -- Returns the offset after the newlines or the zero that end a text of an earlier segment; frames must follow.
    local function end_of_text(text, at)
        local after = at == 0 and (text:match("^[\r\n]+()") or text:match("^\0()"))
        local stop = after and after - 1
        while stop and stop < #text do
            if not may_start(text, stop) or #text - stop < HEADER_SIZE then return nil end
            stop = stop_of(text, stop)
        end
        return stop == #text and after - 1 or nil
    end

    local function add_faulty(stream, at, stop, said, kind, reason)
        local _, _, item = add_bytes(stream, at, stop, said, field.rest)
        complain(item or stream.tree, kind, reason)
        return said, stop
    end

    -- Returns the plain text between two offsets, nil if they have other bytes or less than four characters.
    local function plain_text(text, at, stop)
        return sub(text, at + 1, stop):match("^([\32-\126][\32-\126][\32-\126][\32-\126]+)[\r\n]*\0?$")
    end

    -- Returns why bytes are in no frame. `length` is the length field there, `plain` the text that they are,
    -- `left_over` the number of bytes to the end of the packet if a frame in it ends here, and `is_gap` tells whether
    -- bytes may be missing before them.
    local function reason_of(length, plain, left_over, is_gap)
        if plain then return "no frame can start here: this is text; a Messaging block needs WRITEMAILBOX" end
        local is_possible = not length or is_usual_length(length)
        local reason = "no frame can start here: the length field says %d, but it can be %d to %d"
        if left_over then
            reason = is_possible and "no frame can start here" or format(reason, length, MIN_LENGTH, MAX_LENGTH)
            return reason .. "; " .. phrases.filled(SLIPS.left_over, { bytes = phrases.plural(left_over, "byte") })
        elseif is_possible or is_gap then
            return "bytes that are in no frame" .. (is_gap and ", as after a gap in the capture" or "")
        end
        return format(reason, length, MIN_LENGTH, MAX_LENGTH)
    end

    -- Adds the bytes between two offsets, which are outside of frames. They may belong to a frame that the capture cut,
    -- in this packet or before.
    function streaming.add_no_frame(stream, at, stop, plain, left_over, is_gap)
        local said = plain and format("text, not a frame: %.60s", plain)
            or format("no frame (%s)", phrases.plural(stop - at, "byte"))
        local is_cut = is_cut_by_capture(stream.tvb, stop, stream.pinfo) or stream.pinfo.number > first_cut
        local reason = reason_of(reading.unsigned16(stream.text, at), plain, left_over, is_gap)
        return add_faulty(stream, at, stop, said, is_cut and "cut_by_capture" or "no_boundary", reason)
    end

    -- Finds where a stream that is out of step continues: at a frame, a text, or the end; returns that, and whether
    -- more is needed to decide. The last bytes may be the start of a header if there are at least `least`; nil if
    -- nothing more comes.
    local function next_step(text, at, accepts, least, first, second)
        local place, following = finding.find_step(text, at, accepts, 0, first, second)
        local is_open = least and place ~= nil and not following
        if not place and least then
            place = finding.header_at_end(text, at) or #text
            is_open = place <= #text - least
        end
        if not following and not is_open then place = #text end
        for _, start in ipairs({ UNLOCK.request, UNLOCK.answer }) do
            local hit = find(text, start, at + 1, true)
            if hit and hit - 1 < place then place, is_open = hit - 1, false end
        end
        return place, is_open
    end

    -- The steps of a stream in which a frame must be searched for.
    local LOST = { lost = true, astray = true }

    -- Judges the bytes from an offset on: OURS for a frame that can be dissected, with what is wrong with its length;
    -- PART for one that has to wait, with the bytes it needs, if known, and the step of the stream; nil for no frame.
    local function judge_frame(stream, at)
        local text, step = stream.text, stream.step
        local code, stop = byte(text, at + HEADER_SIZE), stop_of(text, at)
        if LOST[step] then return nil end
        local sent = at < stream.joint and stream.sent
        if at == math.max(stream.joint, stream.start or 0) and stream.reported == #text then sent = #text end
        local slip = finding.slip_of(text, at, sent, stream.is_last or stream.joint + at == 0 and not stream.may_gap)
        if slip then return OURS, slip end
        if stop and not is_length(text, at) then return nil end
        if code and at < stream.joint and stream.may_gap then
            local verdict = finding.judge_split(text, at, stream.accepts, stream.joint, stream.is_last)
            if not verdict then return nil end
            if verdict == PART and stop <= #text then return PART, nil, step end
        elseif code and at < stream.joint and stop ~= #text and stop - LENGTH_FIELD ~= stream.joint
            and finding.is_filled(text, stream.joint, stream.accepts, #text, true) then
            -- Whole frames fill the newest packet: the frame before it, which is incomplete, was before a gap.
            return nil
        end
        if stream.is_last or code and stop <= stream.reported then return OURS end
        -- There may be a gap before it, so it is judged again with each packet.
        if step == "likely" and at == 0 then return PART, nil, step end
        -- At the start of a packet there may be one, too: then the whole next packet tells.
        return PART, at > 0 and stop and stop - stream.reported or nil, step == "text" and step or "sure"
    end

    -- Takes a conversation with a text of WiFi for one of a brick: a request begins it anew.
    local function confirm(conversation, text, at)
        local is_request = sub(text, at + 1, at + #UNLOCK.request) == UNLOCK.request
        if is_request and conversation.number then dialogues.renew(conversation) end
        dialogues.unlock(conversation)
        if conversation.state ~= "sure" then claiming.begin(conversation, "sure") end
    end

    -- Each of these takes what is at an offset: its line and the offset after it; PART if it has to wait; nil if
    -- something else is there.
    local takers = {}

    takers[1] = function(stream, at)
        local text = stream.text
        if not UNLOCK.starts[byte(text, at + 1)] then return nil end
        local said, after = dissect_text(stream, at)
        if not said then return not stream.is_last and is_part_of_text(text, at) and PART or nil end
        stream.step = "text"
        if stream.conversation then confirm(stream.conversation, text, at) end
        return said, after
    end

    takers[2] = function(stream, at)
        local after = LOST[stream.step] and at or after_polls(stream.text, at)
        if after == at or after < #stream.text and not may_start(stream.text, after) then return nil end
        return add_bytes(stream, at, after, "poll", field.padding)
    end

    takers[3] = function(stream, at)
        local tvb, text, captured, pinfo = stream.tvb, stream.text, #stream.text, stream.pinfo
        if at == stream.no_frame_at then return nil end
        local verdict, detail, step = judge_frame(stream, at)
        if verdict == PART then stream.wanted, stream.step = detail, step end
        if verdict ~= OURS then return verdict end
        if captured - at < HEADER_SIZE then
            local kind = is_cut_by_capture(tvb, captured, pinfo) and "cut_by_capture" or "cut_off"
            return add_faulty(stream, at, captured, "part of a frame", kind, "the frame is cut off in its header")
        end
        local after, place = math.min(stop_of(text, at), captured), storage.place_of(stream.number, tvb:offset() + at)
        local message = messages.read_at(text, at)
        message.slip = detail
        -- The bytes after it in the packet are the rest of the next frame.
        if detail then stream.no_frame_at = after end
        if stream.step == "text" then stream.step = "sure" end
        return dissect_message(tvb, at, message, stream.conversation, place, pinfo, stream.tree, stream.brick), after
    end

    takers[4] = function(stream, at)
        local after = stream.step == "text" and end_of_text(stream.text, at)
        if not after then return nil end
        return add_bytes(stream, at, after, "end of the text before", field.rest)
    end

    -- Returns the plain text at an offset in a conversation that is a brick's for sure, if a frame may start there, up
    -- to either of two offsets, and its end.
    local function find_plain(stream, at, stop, after)
        local place, conversation = storage.place_of(stream.number, stream.tvb:offset() + at), stream.conversation
        if conversation and conversation.state == "sure" then streaming.sure_places[place] = true end
        if LOST[stream.step] or not streaming.sure_places[place] then return nil, after end
        local plain = plain_text(stream.text, at, stop)
        return plain or plain_text(stream.text, at, after), plain and stop or after
    end

    -- Bytes that are in no frame; `is_open` tells whether more is needed to decide where they end.
    takers[5] = function(stream, at)
        local text, captured, was_lost, joint = stream.text, #stream.text, LOST[stream.step], stream.joint
        -- After a frame in the same packet this is the sender's fault, and ends with the packet.
        local is_after = at == stream.no_frame_at or not (was_lost or stream.may_gap) and at > 0 and at ~= joint
        local stop = is_after and at < joint and joint or captured
        local least = not (stream.is_last or is_after) and (was_lost or stream.may_gap) and 1
        local found, is_open =
            next_step(sub(text, 1, stop), was_lost and at or at + 1, stream.accepts, least, stream.first, joint)
        local plain, after = find_plain(stream, at, stop, found)
        stream.is_open = is_open and after == found
        local is_gap = stream.may_gap or stream.step == "lost"
        local is_sure = not stream.is_open and (after < captured or plain or is_after)
        stream.step = is_sure and "sure" or is_gap and "lost" or "astray"
        stream.lost = stream.lost + after - at
        local said = after > at and streaming.add_no_frame(stream, at, after, plain, is_after and stop - at, is_gap)
        return said, after
    end

    -- Dissects the frames and texts in a piece of a stream. Returns the offset after the last one that is whole, and
    -- how many bytes the next one wants, nil if its length is not known yet. `stream` has `tvb`, `text`, `number`,
    -- `conversation`, `pinfo`, `tree` and `brick`, and
    --   reported   the size of the piece on the wire, of which a capture may have less
    --   is_last    there is nothing more to wait for
    --   step       "sure" if a frame starts with the piece, "likely" if one does unless there is a gap before it,
    --              "text" if the end of a text may come before; if one is searched for, "lost" after a gap, or
    --              "astray"; afterwards the step at the end
    --   start      how many bytes of it are done, if any
    --   joint      where in the piece the newest packet starts; `first` is 0 if a packet starts with the piece, too
    --   sent       the same, if what was sent before can be all of a frame
    --   may_gap    gaps between the packets go unnoticed
    --   accepts    tells which types go in its direction, if that is known
    --   lost       afterwards: how many bytes are in no frame
    function streaming.dissect(stream)
        local at = stream.start or 0
        stream.lost = 0
        while at < #stream.text do
            local said, after
            for _, take in ipairs(takers) do
                said, after = take(stream, at)
                if said == PART then return at, stream.wanted end
                if after then break end
            end
            if said then say(said) end
            at = after
            if stream.is_open then return at, nil end
        end
        return at, 0
    end
end

-- USB ---------------------------------------------------------------------------------------------------------------
--
-- Each report has one frame at its start; the rest is padding.

do
    -- The "port" of the host; that of a device is the number of its endpoint.
    local HOST = 0xFFFFFFFF

    local function is_from_host(pinfo) return pinfo.src_port == HOST end

    -- Returns the device that a report comes from or goes to, without its endpoint.
    local function device_key(pinfo)
        local address = tostring(is_from_host(pinfo) and pinfo.dst or pinfo.src)
        return address:match("^(.*)%.%d+$") or address
    end

    -- Detects a known fault of the bootloader: its reply is partly overwritten by the request.
    local function is_overwritten(message, pinfo)
        local type, command = message.type, message.command
        return type and type.is_command and command and command.is_bootloader and not is_from_host(pinfo)
    end

    -- The numbers of our packets, of devices whose product is not known.
    local taken

    -- The number of the last packet from or to a known brick, or a device that the user chose.
    local marked

    local function forget_devices() taken, marked = {}, nil end

    -- Reads the message at the start of a report, without the padding.
    local function read_report(tvb)
        local stop = stop_of(bytes_of(tvb, 0, LENGTH_FIELD), 0)
        return messages.read(bytes_of(tvb, 0, math.min(stop, captured_len(tvb))))
    end

    local function dissect_report(tvb, message, device, pinfo, tree)
        local number, offset, captured = pinfo.number, offset_of(tvb), captured_len(tvb)
        local command, line = message.command, nil
        if is_overwritten(message, pinfo) then
            message.is_overwritten = true
            line = "bootloader fault: reply to " .. command.name .. " overwritten by its request"
        end
        local stop, conversation = message.stop, not pinfo.visited and dialogues.conversation_of(device)
        local brick = has_tree(tree) and device
        local place = storage.place_of(number, offset)
        local said, item = dissect_message(tvb, 0, message, conversation, place, pinfo, tree, brick, line)
        if line then
            local reason = "a known fault of the EV3's bootloader on USB 3 ports: the reply to %s with the request"
                .. " written over its first bytes"
            complain(item or tree, "bootloader_fault", format(reason, command.name))
        end
        if item and stop < captured then
            item:set_len(captured)
            local rest = tvb(stop, captured - stop)
            item:add(field.padding, rest):append_text(format(" (%s)", phrases.plural(captured - stop, "byte")))
        end
        start_line(number, offset)
        say(said)
        show(pinfo, tvb, tree)
        return captured
    end

    -- Dissects any report of a brick, except of control transfers. Returns 0 if it is too short for a frame.
    local function dissect_known(tvb, pinfo, tree)
        local captured, device = captured_len(tvb), device_key(pinfo)
        if pinfo.src_port == 0 or pinfo.dst_port == 0 or captured < HEADER_SIZE then return 0 end
        local text = bytes_of(tvb, 0, LENGTH_FIELD)
        if is_length(text, 0) then return dissect_report(tvb, read_report(tvb), device, pinfo, tree) end
        start_line(pinfo.number, offset_of(tvb))
        local report = { tvb = tvb, text = text, pinfo = pinfo, tree = tree, brick = has_tree(tree) and device }
        say((streaming.add_no_frame(report, 0, captured)))
        show(pinfo, tvb, tree)
        return captured
    end

    -- Wireshark calls this for all transfers of a known or chosen device. Bulk transfers are not ours: other
    -- software on the brick uses them with the same product number. So the packet is only marked here; for interrupt
    -- transfers Wireshark then calls the heuristic below.
    local function mark_known(_, pinfo)
        marked = pinfo.number
        return 0
    end

    -- Returns the message in a report of a device whose product is not known, nil if it is not ours. The report must
    -- have the size for its type, because other devices have reports, too.
    local function claimed_message(tvb, key, pinfo)
        local sort, captured, message = REPORT_SIZES[tvb:reported_len()], captured_len(tvb), nil
        local header = bytes_of(tvb, 0, math.min(captured, HEADER_SIZE))
        local type = MESSAGE_TYPES[byte(header, HEADER_SIZE)]
        if sort and type and (sort == "computer" or type.carries == "daisy")
            and is_usual_length(reading.unsigned16(header, 0)) and stop_of(header, 0) <= tvb:reported_len() then
            message = read_report(tvb)
            -- Bricks in a chain send commands both ways, in smaller reports than computers.
            if sort == "daisy" or is_overwritten(message, pinfo) then
                return claiming.is_sensible(message) and message or nil
            end
        end
        local conversation, number, from_host = dialogues.conversation_of(key), pinfo.number, is_from_host(pinfo)
        if not message or (type.is_command == true) ~= from_host then
            if claiming.is_claimed(conversation) then claiming.count(conversation, captured, number) end
            return nil
        end
        if claiming.is_claimed(conversation) then return message end
        local offset, text = offset_of(tvb), message.text
        local found = claiming.judge(conversation, pinfo, {
            side = from_host, text = text, starts = { 0 }, reported = message.size, begins = is_command,
            needs_reply = #text < message.size,
            adopt = function()
                taken[number] = true
                return offset
            end,
        })
        return found == CHAIN and message or nil
    end

    -- Dissects reports of a known brick, or of a device whose product was not captured, as in most captures that were
    -- started after the brick was plugged in.
    local function guess_usb(tvb, pinfo, tree)
        local number, device, message = pinfo.number, device_key(pinfo), nil
        if number == marked then return dissect_known(tvb, pinfo, tree) > 0 end
        if pinfo.visited then
            message = taken[number] and read_report(tvb)
        else
            message = claimed_message(tvb, device, pinfo)
            if message then taken[number] = true end
        end
        if not message then return false end
        dissect_report(tvb, message, device, pinfo, tree)
        local conversation = not pinfo.visited and dialogues.conversation_of(device)
        if conversation and claiming.is_claimed(conversation) then claiming.count(conversation, 0, number) end
        return true
    end

    local function register()
        local products = DissectorTable.get("usb.product")
        for _, product in ipairs(CARRIERS.usb_products) do products:add(product, ev3) end
        products:add_for_decode_as(ev3_all)
        DissectorTable.get("usb.device"):add_for_decode_as(ev3_all)
        ev3:register_heuristic("usb.interrupt", guess_usb)
    end

    dissectors[8] = mark_known
    carriers[#carriers + 1] = { forget = forget_devices, register = register }
end

-- Bluetooth ---------------------------------------------------------------------------------------------------------
--
-- Wireshark passes the stream on in pieces and does not join them: an incomplete frame waits here for its rest. The
-- first pass keeps the bytes that were waiting before each packet.

do
    -- Our packets, by number. `accepts` tells which types go this way. `step` is "lost" if the stream was out of step
    -- before, "sure" if the claim begins here, after `start` bytes that are not ours. For a frame that continues in the
    -- packet, `list` has the numbers of its packets, of which the first `earlier` came before this one; if it is
    -- complete now, `before` has the bytes of those. `begun` is the list of a frame that starts here and is incomplete.
    -- All packets of a frame share its list; its `complete_in` is the packet with the last piece.
    local packets, streams

    local function forget_streams() packets, streams = {}, {} end

    -- Returns the conversation of a packet's channel, and the stream of its direction. Devices are identified by
    -- hardware addresses: Wireshark adds names to the other addresses as soon as it learns them. A capture that was
    -- started after the connection has no addresses, but usually the direction.
    local function channel_of(pinfo)
        local from, to, channel = plain_address(pinfo.dl_src), plain_address(pinfo.dl_dst), floor(pinfo.match_uint / 2)
        local ends = from < to and from .. " " .. to or to .. " " .. from
        local conversation = dialogues.conversation_of(ends .. " " .. channel)
        conversation.sides = conversation.sides or {}
        local key = from .. " > " .. to .. " " .. channel .. " " .. pinfo.p2p_dir
        local stream = streams[key]
        if not stream then
            stream = { left = "", look_at = 0 }
            streams[key] = stream
            table.insert(conversation.sides, stream)
        end
        return conversation, stream
    end

    -- Bricks write into each other's mailboxes, so some commands come from a brick.
    local function is_from_brick(type)
        return not type.is_command or type.carries == "system" and not type.wants_reply
    end

    local function clear(stream)
        stream.left, stream.list, stream.starts, stream.look_at = "", nil, nil, 0
    end

    -- Forgets the waiting bytes of both directions.
    local function clear_sides(conversation)
        for _, stream in ipairs(conversation.sides) do
            clear(stream)
            stream.step = nil
        end
    end

    -- Keeps the waiting bytes and those of the newest packet, from an offset on. `list` has the numbers of their
    -- packets, `starts` where each packet begins in them.
    local function keep(stream, text, place, number)
        local list, starts = {}, {}
        local before = stream.list or {}
        for index, start in ipairs(stream.starts or {}) do
            local stop = stream.starts[index + 1] or #stream.left
            if stop > place then list[#list + 1], starts[#starts + 1] = before[index], math.max(start - place, 0) end
        end
        list[#list + 1], starts[#starts + 1] = number, math.max(#stream.left - place, 0)
        stream.left, stream.list, stream.starts = sub(text, place + 1), list, starts
    end

    -- Makes the records of the packets that a command came in: the newest, in which it ends, and those before it. The
    -- pieces are in the stream; `left` is what waited before the newest.
    local function record_packets(list, left, place, number)
        local packet = { accepts = is_command, step = "sure" }
        packets[number] = packet
        if place >= #left then
            packet.start = place - #left
            return
        end
        list[#list] = nil
        for index, before in ipairs(list) do
            packets[before] = { accepts = is_command, list = list, earlier = index - 1, begun = index == 1 and list }
        end
        list.complete_in = number
        packet.list, packet.earlier, packet.before = list, #list, sub(left, place + 1)
    end

    -- Looks for a reason to claim a channel, and makes the packet's record if it finds one. The beginning of a possible
    -- command is kept: typed text, for example, arrives letter by letter.
    local function claim(conversation, stream, piece, missing, offset, pinfo)
        local number, left, starts = pinfo.number, stream.left, { table.unpack(stream.starts or {}) }
        starts[#starts + 1] = #left
        local text, list = left .. piece, nil
        local found, place = claiming.judge(conversation, pinfo, {
            side = stream, text = text, starts = starts, reported = #text + missing, begins = claiming.begins,
            adopt = function(_, first)
                record_packets(list, left, first, number)
                return first < #left and -first or offset - #left
            end,
        })
        if found then keep(stream, text, place, number) end
        list = stream.list
        if found ~= OPEN then clear(stream) end
        if found == CHAIN and stream == conversation.side_to_brick then
            clear_sides(conversation)
            record_packets(list, left, place, number)
        elseif found == CHAIN then
            packets[number] = { accepts = is_from_brick, step = "sure", start = 0 }
        end
    end

    -- Tells whether all of a text has to wait for more; the newest packet starts at `joint`.
    local function waits(stream, text, accepts, joint)
        if stream.step ~= "lost" then
            local stop = stop_of(text, 0)
            local part = not stop or is_length(text, 0) and stop > #text
            if #text < HEADER_SIZE or part and #text < stream.look_at then return part end
            -- A frame that arrives byte by byte is not examined again at each byte.
            stream.look_at = floor(#text * 1.25) + 1
            if not is_length(text, 0) or finding.slip_of(text, 0, #stream.list == 1 and joint) then return false end
            return finding.judge_split(text, 0, accepts, joint) == PART
        end
        local place, following = finding.find_step(text, 0, accepts, 0, 0)
        return place == 0 and not following
    end

    -- Joins a packet with the bytes that wait for it, in the first pass.
    local function join(stream, piece, packet, number)
        local left = stream.left
        if left == "" then return end
        packet.list, packet.earlier = stream.list, #stream.list
        if waits(stream, left .. piece, packet.accepts, #left) then
            stream.left = left .. piece
            table.insert(stream.list, number)
        else
            packet.before = left
            stream.list.complete_in = number
            clear(stream)
        end
    end

    local function add_joined(tree, tvb, packet)
        local said = "EV3: joined with " .. phrases.plural(#packet.before, "byte") .. " of earlier packets"
        local item = tree:add(ev3, tvb(), said)
        for index = 1, packet.earlier do
            item:add(field.fragments, packet.list[index]):set_generated()
        end
    end

    -- Adds the incomplete frame at the end of a packet.
    local function add_part(tree, tvb, size, packet, brick)
        local range = tvb(math.max(tvb:len() - size, 0))
        local item = tree:add(ev3, range, "EV3: part of a frame")
        item:add(field.brick, brick):set_generated()
        item:add(field.fragment, range)
        local list = packet.begun or packet.list
        if not packet.begun and list then item:add(field.fragments, list[1]):set_generated() end
        if list and list.complete_in then item:add(field.fragment_of, list.complete_in):set_generated() end
    end

    -- Tells whether a direction goes to the brick. If the user claimed the channel, the computer sends to it.
    local function is_to_brick(conversation, stream, pinfo)
        if conversation.side_to_brick then return stream == conversation.side_to_brick end
        return pinfo.p2p_dir == P2P_DIR_SENT
    end

    -- Ends a packet that is a command with a wrong length: the other side sends, so nothing more belongs to it.
    local function end_answered(conversation, stream)
        local alone = #(stream.list or {}) == 1 and stream.alone
        if not alone or not finding.slip_of(stream.left, 0, #stream.left, true) then return end
        dialogues.take_note(alone.place, conversation, messages.read_at(stream.left, 0), alone)
        clear(stream)
    end

    -- Makes the record of a packet in the first pass, if it is ours.
    local function first_look(conversation, stream, piece, missing, offset, pinfo)
        if not claiming.is_claimed(conversation) then
            return claim(conversation, stream, piece, missing, offset, pinfo)
        end
        for _, side in ipairs(conversation.sides) do
            if side ~= stream then end_answered(conversation, side) end
        end
        local accepts = is_to_brick(conversation, stream, pinfo) and is_command or is_from_brick
        packets[pinfo.number] = { accepts = accepts, step = stream.step == "lost" and "lost" or nil }
        join(stream, piece, packets[pinfo.number], pinfo.number)
    end

    local function dissect_rfcomm(tvb, pinfo, tree, is_all)
        local piece, number, missing = tvb:raw(), pinfo.number, tvb:reported_len() - tvb:len()
        if piece == "" then return 0 end
        local conversation, stream
        if not pinfo.visited then
            conversation, stream = channel_of(pinfo)
            if is_all and conversation.state ~= "sure" then claiming.begin(conversation, "sure") end
            first_look(conversation, stream, piece, missing, tvb:offset(), pinfo)
        end
        local packet = packets[number]
        if not packet then return 0 end
        local size, before = #piece, packet.before
        local brick = has_tree(tree) and plain_address(packet.accepts == is_command and pinfo.dl_dst or pinfo.dl_src)
        start_line(number, tvb:offset())
        -- If the packet only continues a frame, there is nothing to dissect yet.
        if before or not packet.list then
            local text, whole = (before or "") .. piece, tvb
            if before then
                whole = ByteArray.new(text, true):tvb("EV3 frames")
                if brick then add_joined(tree, tvb, packet) end
            end
            local joint, begun = before and #before or 0, pinfo.visited and packet.begun
            local state = {
                tvb = whole, text = text, conversation = conversation, number = number, pinfo = pinfo, tree = tree,
                brick = brick, reported = #text, step = packet.step or "likely", start = packet.start,
                is_last = missing > 0 or begun and not begun[2] and not begun.complete_in,
                joint = joint, sent = packet.earlier == 1 and joint, first = not before and 0, may_gap = true,
                accepts = packet.accepts,
            }
            local after = streaming.dissect(state)
            size = #text - after
            if stream then
                if size > 0 then
                    stream.left, stream.list = sub(text, after + 1), { number }
                    packet.begun = stream.list
                    local is_alone = after == math.max(joint, packet.start or 0)
                    local place = storage.place_of(number, whole:offset() + after)
                    stream.alone = is_alone and { place = place, rel_ts = pinfo.rel_ts }
                end
                stream.step = state.step
                claiming.count(conversation, state.lost, number)
                if not claiming.is_claimed(conversation) then clear_sides(conversation) end
            end
        end
        if size > 0 then
            if brick then add_part(tree, tvb, size, packet, brick) end
            say("part of a frame")
        end
        show(pinfo, tvb, tree)
        return #piece
    end

    -- The channel of the serial port profile, opened by either side.
    local function register()
        local channels = DissectorTable.get("btrfcomm.dlci")
        channels:add(2 * CARRIERS.rfcomm_channel, ev3)
        channels:add(2 * CARRIERS.rfcomm_channel + 1, ev3)
        channels:add_for_decode_as(ev3_all)
    end

    dissectors[11] = dissect_rfcomm
    carriers[#carriers + 1] = { forget = forget_streams, register = register }
end

-- WiFi --------------------------------------------------------------------------------------------------------------
--
-- The beacon in UDP datagrams, and the byte stream of a TCP connection.

do
    local MAX_PORT = 65535

    local tcp_ports = DissectorTable.get("tcp.port")

    -- Lists of addresses by port, each with the `name` of its brick: `announced`, where bricks listen by their beacons;
    -- `bricks`, from where beacons came, at port 0. `answers`: the bricks of the packets to these. `has_found`: whether
    -- connections on other ports were claimed.
    local bricks, answers, announced, has_found

    -- The ports in the preference; without any, the usual one, whose connections are judged.
    local listed = ""

    -- Buffers by place, if unusual: DECLINED if it is not ours; else `asked`, the offset from which on more was
    -- requested before the connection was claimed; or the `step` of the stream, and the number of bytes that were
    -- `done`.
    local buffers
    local DECLINED = {}

    -- The same ports as keys.
    local ports = {}

    -- By both ports: the directions of connections, the newest first, `older` the next one. Their addresses are
    -- compared as objects: the text of an address may become a name. `conversation` is that of both directions.
    -- `pending` has the bytes that wait for the next segment, `step` the step of the stream there, `done` the number of
    -- bytes before them in their buffer; `number` is the last packet. Until the claim, `waits` is the number of waiting
    -- bytes, in which packets begin at `starts`.
    local connections

    local function find_direction(ends, from, to)
        local known = connections[ends]
        while known and (known.from ~= from or known.to ~= to) do known = known.older end
        return known
    end

    -- Returns a packet's conversation, and the packet's direction.
    local function connection_of(pinfo)
        local from, to, port, other = pinfo.src, pinfo.dst, pinfo.src_port, pinfo.dst_port
        local ends = port * 0x10000 + other
        local known = find_direction(ends, from, to)
        if not known then
            local back = find_direction(other * 0x10000 + port, to, from)
            known = { from = from, to = to, older = connections[ends], waits = 0, starts = {} }
            known.conversation = back and back.conversation or dialogues.conversation_of(known)
            if not back then known.conversation.lock = {} end
            connections[ends] = known
        end
        return known.conversation, known
    end

    -- Returns the entry of an address and port in a list of places.
    local function entry_at(places, address, port)
        for _, entry in ipairs(places[port] or {}) do
            if entry.address == address then return entry end
        end
    end

    local function add_entry(places, address, port, name)
        local entry = entry_at(places, address, port)
        if not entry then
            entry = { address = address }
            places[port] = places[port] or {}
            table.insert(places[port], entry)
        end
        entry.name = name
    end

    local function forget_wifi()
        bricks, answers, announced, has_found = {}, {}, {}, false
        buffers, connections = {}, {}
    end

    -- Which types go to the brick and which come from it. Bricks in a chain send commands both ways.
    local function goes_to_brick(type) return type.is_command or type.carries == "daisy" end

    local function comes_from_brick(type) return not type.is_command or type.carries == "daisy" end

    local dissect_claimed
    do
        -- Returns the step of the stream at a buffer in the first pass, how many bytes of the buffer came before, and
        -- how many of these are done: TCP passes bytes on again if a frame in them is incomplete. TCP joins segments
        -- only if nothing is missing between them: then the buffer has the offset 0 and begins with what waits. Bytes
        -- that wait and are not joined were before a gap. Otherwise a frame starts where the last one ended.
        local function first_step(known, text, offset, number)
            local pending, before, is_further = known.pending, known.step, number == known.number
            known.pending, known.number = nil, number
            if offset > 0 then return pending and not is_further and "lost" or before or "sure", 0, 0 end
            for _, done in ipairs({ 0, known.done }) do
                if pending and sub(text, done + 1, done + #pending) == pending then
                    return before, done + #pending, done
                end
            end
            return "sure", 0, 0
        end

        -- The same in any pass; `known`, the direction, is given in the first pass only.
        local function step_of(known, text, offset, number, start)
            local place = storage.place_of(number, offset)
            if not known then
                local buffer = buffers[place] or {}
                return buffer.step or "sure", buffer.joint or 0, buffer.done or 0
            end
            local step, joint, done = "sure", 0, start
            if start then
                known.number = number
            else
                step, joint, done = first_step(known, text, offset, number)
            end
            if step ~= "sure" or done > 0 or joint > 0 then
                buffers[place] = { step = step, done = done, joint = joint }
            end
            return step, joint, done
        end

        -- A command with a wrong length is shown at once, as nothing more may come. If the next segment completes a
        -- right one, they are joined here, unless the brick sent anything in between. Returns the buffer, its bytes,
        -- and how many of them came before.
        local function join(conversation, known, tvb, text, place)
            local short, buffer = known and conversation.short, buffers[place]
            if short then conversation.short = nil end
            local held = short and short.side == known and short
            if held and claiming.is_sensible(messages.read_at(held.text .. text, 0)) then
                buffer, buffers[held.place] = { before = held.text }, { is_part = true }
                buffers[place] = buffer
            end
            local before = buffer and buffer.before
            if not before then return tvb, text, 0 end
            return ByteArray.new(before .. text, true):tvb("EV3 frame"), before .. text, #before
        end

        -- Dissects a buffer of a claimed connection; `start` is where the claim begins, if in this buffer.
        function dissect_claimed(tvb, text, pinfo, tree, number, conversation, known, start)
            local size, offset, earlier = #text, offset_of(tvb), nil
            local place, whole = storage.place_of(number, offset), tvb
            whole, text, earlier = join(conversation, known, tvb, text, place)
            local captured = #text
            if known and known.claims ~= conversation.claims then
                known.claims, known.pending, known.step, known.number = conversation.claims, nil, nil, nil
            end
            local step, joint, done = step_of(known, text, offset, number, start)
            local brick = has_tree(tree) and (conversation or connection_of(pinfo)).name
            start_line(number, offset)
            -- Nearly every buffer is exactly one frame.
            local lost = 0
            if step == "sure" and joint == 0 and done == 0 and MESSAGE_TYPES[byte(text, HEADER_SIZE)]
                and stop_of(text, 0) == captured and is_usual_length(captured - LENGTH_FIELD) then
                say((dissect_message(whole, 0, messages.read(text), conversation, place, pinfo, tree, brick)))
            elseif buffers[place] and buffers[place].is_part then
                say("part of a frame")
                if brick then add_item(tree, tvb(), brick, "part of a frame"):add(field.fragment, tvb()) end
            else
                local reported = whole:reported_len()
                local named = conversation or connection_of(pinfo)
                local is_sent = named.port == pinfo.dst_port and named.address == pinfo.dst
                local stream = {
                    tvb = whole, text = text, conversation = conversation, number = number, pinfo = pinfo, tree = tree,
                    brick = brick, reported = reported, is_last = captured < reported or pinfo.can_desegment == 0,
                    step = step, start = done, joint = joint, sent = joint, first = 0,
                    accepts = is_sent and goes_to_brick or comes_from_brick,
                }
                local after, wanted = streaming.dissect(stream)
                lost = stream.lost
                if after < captured then
                    pinfo.desegment_offset = after - earlier
                    pinfo.desegment_len = wanted or DESEGMENT_ONE_MORE_SEGMENT
                end
                if known then
                    known.pending = after < captured and sub(text, after + 1) or nil
                    known.step, known.done = stream.step, after
                    local is_short = captured == reported and after == captured and (stop_of(text, 0) or 0) > captured
                    conversation.short = is_short and { side = known, text = text, place = place } or nil
                end
            end
            if known then claiming.count(conversation, lost, number) end
            show(pinfo, tvb, tree)
            return size
        end
    end

    -- Tells whether a beacon announced this port.
    local function is_announced(address, port) return entry_at(announced, address, port) ~= nil end

    -- Returns the address and port of the brick to which a packet goes or from which it comes.
    local function brick_end(pinfo, to_brick)
        if to_brick then return pinfo.dst, pinfo.dst_port end
        return pinfo.src, pinfo.src_port
    end

    -- Names a connection after its brick.
    local function name_brick(conversation, pinfo, to_brick)
        local address, port = brick_end(pinfo, to_brick)
        conversation.name = plain_address(address) .. ":" .. port
        conversation.address, conversation.port = address, port
    end

    local dissect_first
    do
        -- Tells whether an end of a connection may be a brick, by its port.
        local function may_be_brick(address, port)
            return ports[port] or is_announced(address, port)
        end

        -- Tells whether data go to the brick, if both ends may be one by their ports.
        local function tells_brick(text, is_text, pinfo)
            if is_text then return byte(text, 1) == byte(UNLOCK.request, 1) end
            local type = MESSAGE_TYPES[byte(text, HEADER_SIZE)]
            if not type or type.carries == "daisy" then return pinfo.match_uint == pinfo.dst_port end
            return type.is_command
        end

        -- Judges a buffer of a connection that is not claimed, in the first pass: CHAIN, with the offset where ours
        -- begins; OPEN, with the offset from which on more is needed; or anything else.
        local function claim(conversation, known, text, reported, offset, pinfo)
            local to_brick = may_be_brick(pinfo.dst, pinfo.dst_port)
            if not to_brick and not may_be_brick(pinfo.src, pinfo.src_port) then return nil end
            local verdict, found, place = streaming.judge_text(text), CHAIN, 0
            if verdict == PART then return OPEN, 0 end
            -- If the preference includes the ports of both ends, as a wide range may, the data tell which is the brick.
            if verdict == OURS or ports[pinfo.src_port] and ports[pinfo.dst_port] then
                to_brick = tells_brick(text, verdict ~= nil, pinfo)
            end
            -- The user's preference, or a beacon, is sure.
            if verdict == OURS or listed ~= "" or is_announced(brick_end(pinfo, to_brick)) then
                claiming.begin(conversation, "sure")
            else
                local function adopt(number, first)
                    buffers[storage.place_of(number, offset)] = { step = "sure", done = first }
                    return offset
                end
                found, place = claiming.judge(conversation, pinfo, {
                    side = known, to_brick = to_brick, text = text, starts = known.starts, reported = reported,
                    begins = claiming.begins, adopt = adopt,
                })
                if found ~= CHAIN then return found, place end
            end
            conversation.claimed_in = pinfo.number
            name_brick(conversation, pinfo, to_brick)
            return CHAIN, place
        end

        -- Requests the rest of a possible frame or text, from an offset on.
        local function ask_for_more(known, text, place, pinfo)
            local starts = {}
            for _, start in ipairs(known.starts) do
                if start >= place then starts[#starts + 1] = start - place end
            end
            pinfo.desegment_offset, pinfo.desegment_len = place, DESEGMENT_ONE_MORE_SEGMENT
            known.waits, known.starts = #text - place, starts
        end

        function dissect_first(tvb, text, pinfo, tree, number, is_all)
            local conversation, known = connection_of(pinfo)
            -- Wireshark may offer a declined buffer again, for the port of the other end.
            local offset, reported = offset_of(tvb), tvb:reported_len()
            local place = storage.place_of(number, offset)
            if buffers[place] == DECLINED then return 0 end
            local port = pinfo.match_uint
            if not conversation.name and (is_all or not ports[port]) then
                name_brick(conversation, pinfo, pinfo.dst_port == port)
                claiming.begin(conversation, "sure")
            end
            if claiming.is_claimed(conversation) then
                return dissect_claimed(tvb, text, pinfo, tree, number, conversation, known)
            end
            if offset > 0 then known.waits, known.starts = 0, {} end
            table.insert(known.starts, known.waits)
            local found, at = claim(conversation, known, text, reported, offset, pinfo)
            if found == OPEN and #text == reported and pinfo.can_desegment > 0 then
                ask_for_more(known, text, at, pinfo)
                buffers[place] = { asked = at }
                return #text
            end
            -- More may have been requested for the same packet before.
            known.waits, known.starts, buffers[place] = 0, {}, nil
            if found ~= CHAIN then
                buffers[place] = DECLINED
                return 0
            end
            return dissect_claimed(tvb, text, pinfo, tree, number, conversation, known, at)
        end
    end

    local function dissect_tcp(tvb, pinfo, tree, is_all)
        local text, number = bytes_of(tvb), pinfo.number
        if not pinfo.visited then return dissect_first(tvb, text, pinfo, tree, number, is_all) end
        local buffer = buffers[storage.place_of(number, offset_of(tvb))]
        if buffer == DECLINED then return 0 end
        if buffer and buffer.asked then
            pinfo.desegment_offset, pinfo.desegment_len = buffer.asked, DESEGMENT_ONE_MORE_SEGMENT
            return #text
        end
        if has_found then
            local conversation = connection_of(pinfo)
            if conversation.is_found and number < conversation.claimed_in then return 0 end
        end
        return dissect_claimed(tvb, text, pinfo, tree, number)
    end

    -- Claims a connection on any other port after a beacon that names the port, or from the unlock text on. Wireshark
    -- then passes all packets of the conversation to us; in later passes also those before.
    local function guess_tcp(tvb, pinfo, tree)
        if pinfo.visited then return false end
        local to_brick, size = is_announced(pinfo.dst, pinfo.dst_port), #UNLOCK.request
        if not to_brick and not is_announced(pinfo.src, pinfo.src_port) then
            if tvb:len() <= size or bytes_of(tvb, 0, size) ~= UNLOCK.request then return false end
            local verdict = streaming.judge_text(bytes_of(tvb))
            if verdict == PART and pinfo.can_desegment > 0 then
                pinfo.desegment_offset, pinfo.desegment_len = 0, DESEGMENT_ONE_MORE_SEGMENT
                return true
            end
            if verdict ~= OURS then return false end
            to_brick = true
        end
        local conversation, known = connection_of(pinfo)
        pinfo.conversation = ev3
        claiming.begin(conversation, "sure")
        conversation.is_found, conversation.claimed_in, has_found = true, pinfo.number, true
        name_brick(conversation, pinfo, to_brick)
        dissect_claimed(tvb, bytes_of(tvb), pinfo, tree, pinfo.number, conversation, known)
        return true
    end

    local dissect_udp
    do
        local function remember_brick(pinfo, named)
            local address = pinfo.src
            local name = plain_address(address) .. ":" .. (named or pinfo.src_port)
            add_entry(bricks, address, 0, name)
            if named then add_entry(announced, address, named, name) end
        end

        local function dissect_beacon(tvb, text, tree, pinfo)
            local item = has_tree(tree) and add_item(tree, tvb(), nil, "beacon")
            local at, values, port = 0, {}, nil
            for _, line in ipairs(CARRIERS.beacon_lines) do
                local head = line.label .. ": "
                local stop = find(text, "\r\n", at + 1, true)
                if not stop or sub(text, at + 1, at + #head) ~= head then
                    local kind = is_cut_by_capture(tvb, tvb:len(), pinfo) and "cut_by_capture" or "fault"
                    complain(item or tree, kind, format("at offset %d: expected a line '%s...'", at, head))
                    break
                end
                local value = sub(text, at + #head + 1, stop - 1)
                values[#values + 1] = phrases.on_one_line(value)
                local number = line.name == "port" and tonumber(value:match("^%d%d?%d?%d?%d?$") or 0) or 0
                if number > 0 and number <= MAX_PORT then port = number end
                local range = tvb(at + #head, #value)
                if item then item:add(field["beacon_" .. line.name], range, reading.utf8_text(value)) end
                at = stop + 1
            end
            local said = "beacon: " .. concat(values, " ")
            if item then item:set_text("EV3: " .. said) end
            if item and port then item:add(field.brick, plain_address(pinfo.src) .. ":" .. port):set_generated() end
            return said, port
        end

        -- Tells whether a datagram is a beacon: it begins with the labels of the first two lines, unless truncated, and
        -- does not name another protocol. With Decode As the first label is enough.
        local function is_beacon(tvb, text, is_forced)
            local lines = CARRIERS.beacon_lines
            local first, second, last = lines[1].label .. ": ", lines[2].label .. ": ", lines[#lines].label .. ": "
            if sub(text, 1, #first) ~= first then return false end
            if is_forced then return true end
            local rest = text:match("\r\n(.*)") or ""
            local is_cut = tvb:len() < tvb:reported_len()
            if sub(rest, 1, #second) ~= second and not (is_cut and sub(second, 1, #rest) == rest) then return false end
            local protocol = rest:match("\r\n" .. last .. "([^\r]*)") or ""
            return sub(CARRIERS.protocol, 1, #protocol) == protocol
        end

        -- Dissects a brick's beacon, or a host's answer to it from or to the port of beacons.
        function dissect_udp(tvb, pinfo, tree)
            local text, number = tvb:raw(), pinfo.number
            local is_forced = pinfo.match_uint ~= CARRIERS.beacon_port and pinfo.match_uint ~= 0
            local said, port
            if is_beacon(tvb, text, is_forced) then
                said, port = dissect_beacon(tvb, text, tree, pinfo)
                if not pinfo.visited then remember_brick(pinfo, port) end
            else
                if not pinfo.visited then answers[number] = (entry_at(bricks, pinfo.dst, 0) or {}).name end
                local brick = answers[number]
                said = "answer to a beacon"
                if not brick and not is_forced then return 0 end
                if has_tree(tree) then add_item(tree, tvb(), brick, said):add(field.beacon_answer, tvb()) end
            end
            start_line(number, tvb:offset())
            say(said)
            show(pinfo, tvb, tree)
            return tvb:len()
        end
    end

    -- Registers the ports of the preference, such as 5555,6000-6003.
    local function take_ports()
        local taken = listed ~= "" and listed or tostring(CARRIERS.tcp_port)
        tcp_ports:add(taken, ev3)
        ports = {}
        for first, last in taken:gmatch("(%d+)%-?(%d*)") do
            for port = tonumber(first), tonumber(last ~= "" and last or first) do
                ports[port] = true
            end
        end
    end

    local function follow_ports()
        if listed == ev3.prefs.tcp_ports then return end
        tcp_ports:remove(listed ~= "" and listed or tostring(CARRIERS.tcp_port), ev3)
        listed = ev3.prefs.tcp_ports
        take_ports()
    end

    local function register()
        local text = "TCP ports on which bricks listen: all their traffic is shown. By default, port "
            .. CARRIERS.tcp_port .. " is judged by its contents"
        ev3.prefs.tcp_ports = Pref.range("TCP ports", listed, text, MAX_PORT)
        take_ports()
        tcp_ports:add_for_decode_as(ev3_all)
        ev3:register_heuristic("tcp", guess_tcp)
        DissectorTable.get("udp.port"):add(CARRIERS.beacon_port, ev3)
    end

    dissectors[2], dissectors[3] = dissect_tcp, dissect_udp
    carriers[#carriers + 1] = { forget = forget_wifi, register = register, prefs_changed = follow_ports }
end

-- Registration ------------------------------------------------------------------------------------------------------

do
    ev3.fields = fields
    ev3.experts = experts

    -- One protocol serves all carriers, so that "Decode As" offers it everywhere by one name.
    for is_all, protocol in pairs({ [false] = ev3, [true] = ev3_all }) do
        function protocol.dissector(tvb, pinfo, tree)
            local dissect = dissectors[pinfo.port_type]
            return dissect and dissect(tvb, pinfo, tree, is_all) or 0
        end
    end

    function ev3.init()
        dialogues.forget()
        first_cut, streaming.sure_places = math.huge, {}
        for _, carrier in ipairs(carriers) do carrier.forget() end
    end

    -- Wireshark registers only protocols that have a dissector.
    for _, carrier in ipairs(carriers) do carrier.register() end

    local dialect_choices = {}
    for number, name in ipairs(DIALECTS) do dialect_choices[number] = { number, name, number } end

    ev3.prefs.firmware = Pref.enum("Firmware", 1, "Firmware whose instruction set is used", dialect_choices, false)
    ev3.prefs.bytes = Pref.bool("Bytes as a field", false, "Add the bytes of each frame as a field, for other programs")

    function ev3.prefs_changed()
        for _, carrier in ipairs(carriers) do
            if carrier.prefs_changed then carrier.prefs_changed() end
        end
        gives_bytes = ev3.prefs.bytes
        dialect = DIALECTS[ev3.prefs.firmware]
        instructions = INSTRUCTION_SETS[dialect]
        operations.forget()
    end
end
-- Checksum of the lines above, by which a changed file is recognised: 477a33e89167de7d
