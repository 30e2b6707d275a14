/*
 * The protocol of the LEGO MINDSTORMS EV3 for C (C99 and later) and C++ (C++11 and later). Licence: MIT.
 *
 * Constant frames are arrays, in the macros of the firmware's own source, which fix every encoding. The length field
 * counts what follows it:
 *
 *     static const uint8_t tone[] = {
 *         EV3_HEADER(16, 42, DIRECT_COMMAND_NO_REPLY), EV3_MEMORY(0, 0),
 *         opSOUND, LC0(TONE), LC0(1), LC2(440), LC2(1000)
 *     };
 *
 * Frames whose values are known later are filled by functions, which choose the shortest encodings:
 *
 *     ev3_frame frame;
 *     ev3_begin_direct(&frame, 42, DIRECT_COMMAND_NO_REPLY, 0, 0);
 *     ev3_operation(&frame, opSOUND, TONE);
 *     ev3_integer(&frame, volume);
 *     ev3_integer(&frame, frequency);
 *     ev3_integer(&frame, duration);
 *     size = ev3_end(&frame);
 *     send(socket, frame.bytes, size, 0);
 *
 * Opcodes, CMDs and enumerations have the firmware's names. Where another header defines one of them as a macro, as
 * windows.h does, include this one first.
 *
 * This file is made by ev3proto 0.2.0 from its tables (ev3proto export c-header): change those, not this.
 */

#ifndef EV3PROTO_H
#define EV3PROTO_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* Frames --------------------------------------------------------------------------------------------------------- */

/*
 * Bytes of the largest frame, its length field included, and of a report on USB. If memory is scarce, define a smaller
 * even number before you include this file: an ev3_frame takes that many bytes and four.
 */
#ifndef EV3_MAX_FRAME
#define EV3_MAX_FRAME 1024
#endif

/* TCP port on which a brick listens */
#define EV3_TCP_PORT 5555

/* One byte of a number, which may be negative */
#define EV3_BYTE(value, bits) ((uint8_t)((uint32_t)(value) >> (bits) & 0xFFu))

/* Two bytes of a number, the lower one first */
#define EV3_WORD(value) EV3_BYTE(value, 0), EV3_BYTE(value, 8)

/* The start of every frame: bytes of the whole frame, message counter (0 to 65535), message type */
#define EV3_HEADER(size, counter, type) EV3_WORD((size) - 2), EV3_WORD(counter), EV3_BYTE(type, 0)

/* The next part of a direct command: bytes of global (0 to 1023) and local (0 to 63) memory */
#define EV3_MEMORY(globals, locals) EV3_WORD((uint32_t)(locals) << 10 | (uint32_t)(globals))

/* Encodings of arguments ----------------------------------------------------------------------------------------- */

/* Constants: LC0 holds -32 to 31, the others 1, 2 and 4 bytes, whose lowest number means "not a number" */
#define LC0(value) ((uint8_t)(0x00 | ((uint32_t)(value) & 0x3Fu)))
#define LC1(value) 0x81, EV3_BYTE(value, 0)
#define LC2(value) 0x82, EV3_BYTE(value, 0), EV3_BYTE(value, 8)
#define LC4(value) 0x83, EV3_BYTE(value, 0), EV3_BYTE(value, 8), EV3_BYTE(value, 16), EV3_BYTE(value, 24)

/* A float. In C, use this in arrays inside functions that are not static; elsewhere give LC4 its bits */
#define LCF(value) \
    0x83, ev3_float_byte(value, 0), ev3_float_byte(value, 8), ev3_float_byte(value, 16), ev3_float_byte(value, 24)

/* A string: LCS, 'h', 'i', 0. Some senders still start one with the old byte */
#define LCS 0x84
#define LCS_OLD 0x80

/* Local and global variables: 0 holds the indexes 0 to 31, the others 1, 2 and 4 bytes */
#define LV0(index) ((uint8_t)(0x40 | ((uint32_t)(index) & 0x1Fu)))
#define LV1(index) 0xC1, EV3_BYTE(index, 0)
#define LV2(index) 0xC2, EV3_BYTE(index, 0), EV3_BYTE(index, 8)
#define LV4(index) 0xC3, EV3_BYTE(index, 0), EV3_BYTE(index, 8), EV3_BYTE(index, 16), EV3_BYTE(index, 24)
#define GV0(index) ((uint8_t)(0x60 | ((uint32_t)(index) & 0x1Fu)))
#define GV1(index) 0xE1, EV3_BYTE(index, 0)
#define GV2(index) 0xE2, EV3_BYTE(index, 0), EV3_BYTE(index, 8)
#define GV4(index) 0xE3, EV3_BYTE(index, 0), EV3_BYTE(index, 8), EV3_BYTE(index, 16), EV3_BYTE(index, 24)

/* A label or a short jump, -128 to 127 */
#define LAB1(value) 0xA0, EV3_BYTE(value, 0)

/* A long form that holds a handle to a memory object, or an absolute address: HND(GV1(40)) */
#define HND(...) 0x10 | __VA_ARGS__
#define ADR(...) 0x08 | __VA_ARGS__

/* Message types ---------------------------------------------------------------------------------------------------- */

enum {
    DIRECT_COMMAND_REPLY = 0x00,
    DIRECT_COMMAND_NO_REPLY = 0x80,
    SYSTEM_COMMAND_REPLY = 0x01,
    SYSTEM_COMMAND_NO_REPLY = 0x81,
    DIRECT_REPLY = 0x02,
    DIRECT_REPLY_ERROR = 0x04,
    SYSTEM_REPLY = 0x03,
    SYSTEM_REPLY_ERROR = 0x05,
    DAISY_COMMAND_REPLY = 0x0A,
    DAISY_COMMAND_NO_REPLY = 0x8A,
    DAISY_REPLY = 0x08,
    DAISY_REPLY_ERROR = 0x09,
};

/* Programs and the virtual machine --------------------------------------------------------------------------------- */

enum {
    /* Ends the program with a failure; never valid on the wire */
    opERROR = 0x00,

    /* Does nothing; a harmless way to test whether the brick answers */
    opNOP = 0x01,

    /*
     * Stops the program of a slot
     *   PRGID  DATA16  program slot to stop (0: all programs; -1: the calling program; a member of SLOT)
     */
    opPROGRAM_STOP = 0x02,

    /*
     * Starts a loaded program; a direct command can do this only while no user program runs
     *   PRGID  DATA16  program slot (a member of SLOT)
     *   SIZE   DATA32  size of the image; read and ignored (bytes)
     *   IP     DATA32  address of the image, as FILE.LOAD_IMAGE returned it
     *   DEBUG  DATA8   how to run it (0 to 2; 0: run; 1: debug; 2: load, do not run)
     */
    opPROGRAM_START = 0x03,

    /*
     * Stops an object of its own program
     *   OBJID  DATA16  object of the program, counted from 1
     */
    opOBJECT_STOP = 0x04,

    /*
     * Starts an object of its own program
     *   OBJID  DATA16  object of the program, counted from 1
     */
    opOBJECT_START = 0x05,

    /*
     * Counts an object's trigger down; at zero the object starts
     *   OBJID  DATA16  object of the program, counted from 1
     */
    opOBJECT_TRIG = 0x06,

    /*
     * Waits until an object has ended
     *   OBJID  DATA16  object of the program, counted from 1
     */
    opOBJECT_WAIT = 0x07,

    /* Returns from a subroutine to its caller */
    opRETURN = 0x08,

    /*
     * Calls a subroutine of its own program; waits while another thread runs it
     *   OBJID       DATA16  object number of the subroutine, counted from 1
     *   PARAMETERS  count   number of parameters follow; the subroutine declares their types and directions (each is
     *       DATA32)
     */
    opCALL = 0x09,

    /* Ends the object; the firmware appends one to every direct command */
    opOBJECT_END = 0x0A,

    /* Gives up the rest of the thread's time slice */
    opSLEEP = 0x0B,

    /* Asks about a program or controls its objects: a CMD follows, below */
    opPROGRAM_INFO = 0x0C,

    /*
     * Marks a place that jumps can name; does nothing itself
     *   NO  label  number of the label (0 to 31)
     */
    opLABEL = 0x0D,

    /*
     * Prints a program's memory on the brick's debug terminal
     *   PRGID   DATA16  program slot (a member of SLOT)
     *   OBJID   DATA16  object whose local memory to print (0: the global memory)
     *   OFFSET  DATA32  first byte (bytes)
     *   SIZE    DATA32  number of bytes to print (0 to 1024 bytes; 0: all, 1024 at most)
     */
    opPROBE = 0x0E,

    /*
     * Runs byte code that is already in memory, ending the slot's previous program
     *   PRGID   DATA16  program slot (a member of SLOT)
     *   IMAGE   DATA32  address of the byte code image
     *   GLOBAL  DATA32  address of the global memory it uses
     */
    opDO = 0x0F,

    /*
     * Runs a shell command on the brick's Linux and waits until it ends
     *   COMMAND  string      the command line
     *   STATUS   out DATA32  wait status as C's system() gives it: 256 times the exit code (0: success; -1: could
     *       not run)
     */
    opSYSTEM = 0x60,

    /*
     * Splits a motor port number as LEGO's editor writes it
     *   PortIn    DATA32     three decimal digits, each 1-4: layer, first port, second port (123: B and C)
     *   Layer     out DATA8  position in the daisy chain (0 to 3; 0: this brick)
     *   Bitfield  out DATA8  motor ports as bits: A=1 B=2 C=4 D=8 (0 to 15)
     *   Inverted  out DATA8  whether the first port comes after the second, as in CA (0 to 1; 0: no; 1: yes)
     */
    opPORT_CNV_OUTPUT = 0x61,

    /*
     * Splits a sensor port number as LEGO's editor writes it
     *   PortIn   DATA32     three decimal digits: layer 1-4, any, port 1-4 (103: port 3)
     *   Layer    out DATA8  position in the daisy chain (0 to 3; 0: this brick)
     *   PortOut  out DATA8  sensor port minus one, as in INPUT_* (0 to 3)
     */
    opPORT_CNV_INPUT = 0x62,

    /*
     * Converts the name of a note to its frequency
     *   NOTE  string      C4 to B6, sharps as C#4
     *   FREQ  out DATA16  frequency; 440 for an unknown note (262 to 1976 Hz)
     */
    opNOTE_TO_FREQ = 0x63,

    /* Reads and sets the error log, the volume and the time to power off: a CMD follows, below */
    opINFO = 0x7C,

    /* Works with texts: joins, compares, converts from and to numbers: a CMD follows, below */
    opSTRINGS = 0x7D,

    /* Stops at breakpoint 0; BP_SET puts it over the instruction it replaces */
    opBP0 = 0x88,

    /* Stops at breakpoint 1; BP_SET puts it over the instruction it replaces */
    opBP1 = 0x89,

    /* Stops at breakpoint 2; BP_SET puts it over the instruction it replaces */
    opBP2 = 0x8A,

    /* Pulses test pin TP4 and continues; BP_SET puts it over the instruction it replaces */
    opBP3 = 0x8B,

    /*
     * Sets or removes a breakpoint in a running program
     *   PRGID    DATA16  program slot (a member of SLOT)
     *   NO       DATA8   number of the breakpoint (0 to 2; 3: pulse on test pin TP4, no stop)
     *   ADDRESS  DATA32  offset in the image (bytes; 0: remove the breakpoint)
     */
    opBP_SET = 0x8C,

    /*
     * Loads an additional virtual machine; fails while another one is loaded (xtended and compat firmware only)
     *   VMINDEX  DATA8      which one (0 to 1; 0: RobotC; 1: LabVIEW)
     *   RESULT   out DATA8  OK or FAIL (a member of RESULT)
     */
    opDYNLOAD_VMLOAD = 0xF0,

    /* Unloads the additional virtual machine (xtended and compat firmware only) */
    opDYNLOAD_VMEXIT = 0xF1,

    /*
     * Calls entry point 0 of the additional virtual machine that is loaded (xtended and compat firmware only)
     *   CMD         DATA8            function to call, in that machine's numbering
     *   LENGTH_IN   DATA8            amount of data passed
     *   LENGTH_OUT  out DATA16       number of elements returned
     *   VALUE       out array-typed  the returned elements; their type depends on CMD (as many values as LENGTH_OUT
     *       says)
     */
    opDYNLOAD_ENTRY_0 = 0xF2,

    /*
     * Calls entry point 1 of the additional virtual machine that is loaded (xtended and compat firmware only)
     *   CMD         DATA8            function to call, in that machine's numbering
     *   LENGTH_IN   DATA8            amount of data passed
     *   LENGTH_OUT  out DATA16       number of elements returned
     *   VALUE       out array-typed  the returned elements; their type depends on CMD (as many values as LENGTH_OUT
     *       says)
     */
    opDYNLOAD_ENTRY_1 = 0xF3,

    /*
     * Calls entry point 2 of the additional virtual machine that is loaded (xtended and compat firmware only)
     *   CMD         DATA8            function to call, in that machine's numbering
     *   LENGTH_IN   DATA8            amount of data passed
     *   LENGTH_OUT  out DATA16       number of elements returned
     *   VALUE       out array-typed  the returned elements; their type depends on CMD (as many values as LENGTH_OUT
     *       says)
     */
    opDYNLOAD_ENTRY_2 = 0xF4,

    /*
     * Calls entry point 3 of the additional virtual machine that is loaded (xtended and compat firmware only)
     *   CMD         DATA8            function to call, in that machine's numbering
     *   LENGTH_IN   DATA8            amount of data passed
     *   LENGTH_OUT  out DATA16       number of elements returned
     *   VALUE       out array-typed  the returned elements; their type depends on CMD (as many values as LENGTH_OUT
     *       says)
     */
    opDYNLOAD_ENTRY_3 = 0xF5,

    /*
     * Calls entry point 4 of the additional virtual machine that is loaded (xtended and compat firmware only)
     *   CMD         DATA8            function to call, in that machine's numbering
     *   LENGTH_IN   DATA8            amount of data passed
     *   LENGTH_OUT  out DATA16       number of elements returned
     *   VALUE       out array-typed  the returned elements; their type depends on CMD (as many values as LENGTH_OUT
     *       says)
     */
    opDYNLOAD_ENTRY_4 = 0xF6,

    /*
     * Calls entry point 5 of the additional virtual machine that is loaded (xtended and compat firmware only)
     *   CMD         DATA8            function to call, in that machine's numbering
     *   LENGTH_IN   DATA8            amount of data passed
     *   LENGTH_OUT  out DATA16       number of elements returned
     *   VALUE       out array-typed  the returned elements; their type depends on CMD (as many values as LENGTH_OUT
     *       says)
     */
    opDYNLOAD_ENTRY_5 = 0xF7,

    /*
     * Calls entry point 6 of the additional virtual machine that is loaded (xtended and compat firmware only)
     *   CMD         DATA8            function to call, in that machine's numbering
     *   LENGTH_IN   DATA8            amount of data passed
     *   LENGTH_OUT  out DATA16       number of elements returned
     *   VALUE       out array-typed  the returned elements; their type depends on CMD (as many values as LENGTH_OUT
     *       says)
     */
    opDYNLOAD_ENTRY_6 = 0xF8,

    /*
     * Calls entry point 7 of the additional virtual machine that is loaded (xtended and compat firmware only)
     *   CMD         DATA8            function to call, in that machine's numbering
     *   LENGTH_IN   DATA8            amount of data passed
     *   LENGTH_OUT  out DATA16       number of elements returned
     *   VALUE       out array-typed  the returned elements; their type depends on CMD (as many values as LENGTH_OUT
     *       says)
     */
    opDYNLOAD_ENTRY_7 = 0xF9,

    /*
     * Calls entry point 8 of the additional virtual machine that is loaded (xtended and compat firmware only)
     *   CMD         DATA8            function to call, in that machine's numbering
     *   LENGTH_IN   DATA8            amount of data passed
     *   LENGTH_OUT  out DATA16       number of elements returned
     *   VALUE       out array-typed  the returned elements; their type depends on CMD (as many values as LENGTH_OUT
     *       says)
     */
    opDYNLOAD_ENTRY_8 = 0xFA,

    /*
     * Calls entry point 9 of the additional virtual machine that is loaded (xtended and compat firmware only)
     *   CMD         DATA8            function to call, in that machine's numbering
     *   LENGTH_IN   DATA8            amount of data passed
     *   LENGTH_OUT  out DATA16       number of elements returned
     *   VALUE       out array-typed  the returned elements; their type depends on CMD (as many values as LENGTH_OUT
     *       says)
     */
    opDYNLOAD_ENTRY_9 = 0xFB,

    /*
     * Asks which additional virtual machine is loaded (xtended and compat firmware only)
     *   RESULT  out DATA8  which one (0 to 1; -1: none; 0: RobotC; 1: LabVIEW)
     */
    opDYNLOAD_GET_VM = 0xFC,

    /* Tests the hardware, as the factory does; all fail before TST_OPEN: a CMD follows, below */
    opTST = 0xFF,
};

/* CMDs of opPROGRAM_INFO */
enum {
    /*
     * Stops an object of a running program
     *   PRGID  DATA16  program slot (a member of SLOT)
     *   OBJID  DATA16  object of the program, counted from 1
     */
    OBJ_STOP = 0,

    /*
     * Starts an object of a running program from its beginning
     *   PRGID  DATA16  program slot (a member of SLOT)
     *   OBJID  DATA16  object of the program, counted from 1
     */
    OBJ_START = 4,

    /*
     * Asks whether a program runs
     *   PRGID  DATA16     program slot (a member of SLOT)
     *   DATA   out DATA8  state of the program (a member of OBJSTAT)
     */
    GET_STATUS = 22,

    /*
     * Asks for a program's speed
     *   PRGID  DATA16      program slot (a member of SLOT)
     *   DATA   out DATA32  speed since the program started (instructions/s)
     */
    GET_SPEED = 23,

    /*
     * Asks how a program ended
     *   PRGID  DATA16     program slot (a member of SLOT)
     *   DATA   out DATA8  OK, BUSY (still running) or FAIL (a member of RESULT)
     */
    GET_PRGRESULT = 24,

    /*
     * Sets how many instructions the calling thread may still run in its time slice
     *   PRGID  DATA16  program slot (a member of SLOT)
     */
    SET_INSTR = 25,

    /*
     * Asks for the name of a program (xtended and compat firmware only)
     *   PRGID  DATA16      program slot (a member of SLOT)
     *   NAME   out string  name of the program, zero-terminated
     */
    GET_PRGNAME = 26,
};

/* CMDs of opINFO */
enum {
    /*
     * Adds an error to the brick's error log
     *   NUMBER  DATA8  number of the error (0: nothing is logged)
     */
    SET_ERROR = 1,

    /*
     * Removes and returns the oldest error of the brick's error log
     *   NUMBER  out DATA8  number of the error (0: the log is empty)
     */
    GET_ERROR = 2,

    /*
     * Converts the number of an error to its name
     *   NUMBER       DATA8       number of the error (0: gives an empty text)
     *   LENGTH       DATA8       size of the text buffer, including the zero (bytes; -1: no limit)
     *   DESTINATION  out string  name of the error, at most 31 characters (as many bytes as LENGTH says)
     */
    ERRORTEXT = 3,

    /*
     * Reads the volume setting
     *   VALUE  out DATA8  volume (0 to 100 %)
     */
    GET_VOLUME = 4,

    /*
     * Changes the volume setting
     *   VALUE  DATA8  volume (0 to 100 %)
     */
    SET_VOLUME = 5,

    /*
     * Reads the idle time after which the brick powers off
     *   VALUE  out DATA8  idle time (0 to 120 min; 0: never)
     */
    GET_MINUTES = 6,

    /*
     * Changes the idle time after which the brick powers off
     *   VALUE  DATA8  idle time (0 to 120 min; 0: never)
     */
    SET_MINUTES = 7,
};

/* CMDs of opSTRINGS */
enum {
    /*
     * Reads the length of a text
     *   SOURCE1  string      text to work on
     *   SIZE     out DATA16  its length, not including the zero (bytes)
     */
    GET_SIZE = 1,

    /*
     * Joins two texts
     *   SOURCE1      string      first part
     *   SOURCE2      string      second part
     *   DESTINATION  out string  resulting text, zero-terminated
     */
    ADD = 2,

    /*
     * Reports whether two texts are equal; case matters
     *   SOURCE1  string     one text
     *   SOURCE2  string     the other text
     *   RESULT   out DATA8  whether they are equal (0 to 1; 0: different; 1: the same)
     */
    COMPARE = 3,

    /*
     * Copies a text
     *   SOURCE1      string      text to work on
     *   DESTINATION  out string  resulting text, zero-terminated
     */
    DUPLICATE = 5,

    /*
     * Writes a floating-point number as text, without trailing zeros
     *   VALUE        DATAF       number to write; NaN becomes ----
     *   FIGURES      DATA8       width, including the point; negative aligns left (characters)
     *   DECIMALS     DATA8       digits after the point
     *   DESTINATION  out string  resulting text, zero-terminated (at most 128 characters)
     */
    VALUE_TO_STRING = 6,

    /*
     * Reads a number from a text
     *   SOURCE1      string     text to read; a comma counts as decimal point
     *   DESTINATION  out DATAF  the number
     */
    STRING_TO_VALUE = 7,

    /*
     * Removes every space from a text
     *   SOURCE1      string      text to work on
     *   DESTINATION  out string  resulting text, zero-terminated
     */
    STRIP = 8,

    /*
     * Writes a whole number as text, with leading zeros
     *   VALUE        DATA16      number to write
     *   FIGURES      DATA8       width of the text (characters)
     *   DESTINATION  out string  resulting text, zero-terminated (at most 128 characters)
     */
    NUMBER_TO_STRING = 9,

    /*
     * Returns the part of a text after another text found in it
     *   SOURCE1      string      text to search
     *   SOURCE2      string      text to find; must occur
     *   DESTINATION  out string  resulting text, zero-terminated
     */
    SUB = 10,

    /*
     * Writes a floating-point number as text in a format of C's printf
     *   VALUE        DATAF       number to write
     *   FORMAT       string      format, such as %5.2f
     *   SIZE         DATA8       size of the text buffer, including the zero (bytes)
     *   DESTINATION  out string  resulting text (as many bytes as SIZE says)
     */
    VALUE_FORMATTED = 11,

    /*
     * Writes a whole number as text in a format of C's printf
     *   VALUE        DATA32      number to write
     *   FORMAT       string      format, such as %05d or %X
     *   SIZE         DATA8       size of the text buffer, including the zero (bytes)
     *   DESTINATION  out string  resulting text (as many bytes as SIZE says)
     */
    NUMBER_FORMATTED = 12,
};

/* CMDs of opTST */
enum {
    /* Allows test commands for 10 seconds; each one restarts the timer */
    TST_OPEN = 10,

    /* Ends the test mode */
    TST_CLOSE = 11,

    /*
     * Reads the pins of a connector
     *   PORT    DATA8      connector: 0..3 are sensor ports 1-4, 16..19 are motor ports A-D (0 to 19)
     *   LENGTH  DATA8      number of pins to read, usually 5
     *   STRING  out DATA8  one character per pin: 0 low, 1 high (as many values as LENGTH says)
     */
    TST_READ_PINS = 12,

    /*
     * Sets the pins of a connector
     *   PORT    DATA8  connector: 0..3 are sensor ports 1-4, 16..19 are motor ports A-D (0 to 19)
     *   LENGTH  DATA8  number of pins to set, usually 5
     *   STRING  DATA8  one character per pin: 0 low, 1 high, X floating, - unchanged (as many values as LENGTH says)
     */
    TST_WRITE_PINS = 13,

    /*
     * Reads the analog converter
     *   INDEX  DATA8       channel: 0..3 pin 1 and 4..7 pin 6 of sensor ports, 8..11 pin 5 of motor ports (0 to 15;
     *       12: battery temperature; 13: motor current; 14: battery current; 15: battery voltage)
     *   VALUE  out DATA16  raw reading (0 to 4095 counts)
     */
    TST_READ_ADC = 14,

    /*
     * Sends bytes on a sensor port's serial line
     *   PORT    DATA8  sensor port minus one (0 to 3)
     *   LENGTH  DATA8  number of bytes to send (0 to 63 bytes)
     *   STRING  DATA8  the bytes (as many values as LENGTH says)
     */
    TST_WRITE_UART = 15,

    /*
     * Reads the bytes received on a sensor port's serial line
     *   PORT    DATA8      sensor port minus one (0 to 3)
     *   LENGTH  DATA8      number of bytes to read (0 to 63 bytes)
     *   STRING  out DATA8  the bytes, padded with zeros (as many values as LENGTH says)
     */
    TST_READ_UART = 16,

    /*
     * Switches the serial lines of all sensor ports on
     *   BITRATE  DATA32  speed of the line (2400 to 115200 bit/s)
     */
    TST_ENABLE_UART = 17,

    /* Switches the serial lines of all sensor ports off */
    TST_DISABLE_UART = 18,

    /*
     * Reads the switch that senses the rechargeable battery
     *   ACTIVE  out DATA8  state of the switch (0 to 1; 0: other batteries; 1: rechargeable battery)
     */
    TST_ACCU_SWITCH = 19,

    /* Starts Bluetooth mode 2, for Apple devices */
    TST_BOOT_MODE2 = 20,

    /*
     * Asks for the state of the start of Bluetooth mode 2
     *   STATUS  out DATA8  OK, BUSY (still starting) or FAIL (0 to 2; a member of RESULT)
     */
    TST_POLL_MODE2 = 21,

    /* Ends Bluetooth mode 2 */
    TST_CLOSE_MODE2 = 22,

    /*
     * Asks for the result of the memory test at power-on
     *   STATUS  out DATA8  OK or FAIL (0 to 2; a member of RESULT)
     */
    TST_RAM_CHECK = 23,
};

/* Arithmetic ------------------------------------------------------------------------------------------------------- */

enum {
    /*
     * Adds two 8-bit numbers
     *   SOURCE1      DATA8      first number
     *   SOURCE2      DATA8      second number
     *   DESTINATION  out DATA8  their sum
     */
    opADD8 = 0x10,

    /*
     * Adds two 16-bit numbers
     *   SOURCE1      DATA16      first number
     *   SOURCE2      DATA16      second number
     *   DESTINATION  out DATA16  their sum
     */
    opADD16 = 0x11,

    /*
     * Adds two 32-bit numbers
     *   SOURCE1      DATA32      first number
     *   SOURCE2      DATA32      second number
     *   DESTINATION  out DATA32  their sum
     */
    opADD32 = 0x12,

    /*
     * Adds two floating-point numbers
     *   SOURCE1      DATAF      first number
     *   SOURCE2      DATAF      second number
     *   DESTINATION  out DATAF  their sum
     */
    opADDF = 0x13,

    /*
     * Subtracts one 8-bit number from another
     *   SOURCE1      DATA8      number to subtract from
     *   SOURCE2      DATA8      number to subtract
     *   DESTINATION  out DATA8  SOURCE1 less SOURCE2
     */
    opSUB8 = 0x14,

    /*
     * Subtracts one 16-bit number from another
     *   SOURCE1      DATA16      number to subtract from
     *   SOURCE2      DATA16      number to subtract
     *   DESTINATION  out DATA16  SOURCE1 less SOURCE2
     */
    opSUB16 = 0x15,

    /*
     * Subtracts one 32-bit number from another
     *   SOURCE1      DATA32      number to subtract from
     *   SOURCE2      DATA32      number to subtract
     *   DESTINATION  out DATA32  SOURCE1 less SOURCE2
     */
    opSUB32 = 0x16,

    /*
     * Subtracts one floating-point number from another
     *   SOURCE1      DATAF      number to subtract from
     *   SOURCE2      DATAF      number to subtract
     *   DESTINATION  out DATAF  SOURCE1 less SOURCE2
     */
    opSUBF = 0x17,

    /*
     * Multiplies two 8-bit numbers
     *   SOURCE1      DATA8      first factor
     *   SOURCE2      DATA8      second factor
     *   DESTINATION  out DATA8  their product
     */
    opMUL8 = 0x18,

    /*
     * Multiplies two 16-bit numbers
     *   SOURCE1      DATA16      first factor
     *   SOURCE2      DATA16      second factor
     *   DESTINATION  out DATA16  their product
     */
    opMUL16 = 0x19,

    /*
     * Multiplies two 32-bit numbers
     *   SOURCE1      DATA32      first factor
     *   SOURCE2      DATA32      second factor
     *   DESTINATION  out DATA32  their product
     */
    opMUL32 = 0x1A,

    /*
     * Multiplies two floating-point numbers
     *   SOURCE1      DATAF      first factor
     *   SOURCE2      DATAF      second factor
     *   DESTINATION  out DATAF  their product
     */
    opMULF = 0x1B,

    /*
     * Divides two 8-bit numbers; by zero gives the largest or smallest value
     *   SOURCE1      DATA8      number to divide
     *   SOURCE2      DATA8      number to divide by
     *   DESTINATION  out DATA8  quotient, cut off towards zero (0 for 0 / 0)
     */
    opDIV8 = 0x1C,

    /*
     * Divides two 16-bit numbers; by zero gives the largest or smallest value
     *   SOURCE1      DATA16      number to divide
     *   SOURCE2      DATA16      number to divide by
     *   DESTINATION  out DATA16  quotient, cut off towards zero (0 for 0 / 0)
     */
    opDIV16 = 0x1D,

    /*
     * Divides two 32-bit numbers; by zero gives the largest or smallest value
     *   SOURCE1      DATA32      number to divide
     *   SOURCE2      DATA32      number to divide by
     *   DESTINATION  out DATA32  quotient, cut off towards zero (0 for 0 / 0)
     */
    opDIV32 = 0x1E,

    /*
     * Divides two floating-point numbers; by zero gives infinity or NaN
     *   SOURCE1      DATAF      number to divide
     *   SOURCE2      DATAF      number to divide by
     *   DESTINATION  out DATAF  quotient
     */
    opDIVF = 0x1F,

    /*
     * Combines 8-bit values, bit by bit, by OR
     *   SOURCE1      DATA8      first
     *   SOURCE2      DATA8      second
     *   DESTINATION  out DATA8  bits set in either
     */
    opOR8 = 0x20,

    /*
     * Combines 16-bit values, bit by bit, by OR
     *   SOURCE1      DATA16      first
     *   SOURCE2      DATA16      second
     *   DESTINATION  out DATA16  bits set in either
     */
    opOR16 = 0x21,

    /*
     * Combines 32-bit values, bit by bit, by OR
     *   SOURCE1      DATA32      first
     *   SOURCE2      DATA32      second
     *   DESTINATION  out DATA32  bits set in either
     */
    opOR32 = 0x22,

    /*
     * Combines 8-bit values, bit by bit, by AND
     *   SOURCE1      DATA8      first
     *   SOURCE2      DATA8      second
     *   DESTINATION  out DATA8  bits set in both
     */
    opAND8 = 0x24,

    /*
     * Combines 16-bit values, bit by bit, by AND
     *   SOURCE1      DATA16      first
     *   SOURCE2      DATA16      second
     *   DESTINATION  out DATA16  bits set in both
     */
    opAND16 = 0x25,

    /*
     * Combines 32-bit values, bit by bit, by AND
     *   SOURCE1      DATA32      first
     *   SOURCE2      DATA32      second
     *   DESTINATION  out DATA32  bits set in both
     */
    opAND32 = 0x26,

    /*
     * Combines 8-bit values, bit by bit, by exclusive OR
     *   SOURCE1      DATA8      first
     *   SOURCE2      DATA8      second
     *   DESTINATION  out DATA8  bits set in just one of the two
     */
    opXOR8 = 0x28,

    /*
     * Combines 16-bit values, bit by bit, by exclusive OR
     *   SOURCE1      DATA16      first
     *   SOURCE2      DATA16      second
     *   DESTINATION  out DATA16  bits set in just one of the two
     */
    opXOR16 = 0x29,

    /*
     * Combines 32-bit values, bit by bit, by exclusive OR
     *   SOURCE1      DATA32      first
     *   SOURCE2      DATA32      second
     *   DESTINATION  out DATA32  bits set in just one of the two
     */
    opXOR32 = 0x2A,

    /*
     * Shifts 8-bit values left; despite the name (rotate), bits shifted out on the left are lost
     *   SOURCE1      DATA8      value to shift
     *   SOURCE2      DATA8      number of places (bits)
     *   DESTINATION  out DATA8  shifted value, filled up with zero bits
     */
    opRL8 = 0x2C,

    /*
     * Shifts 16-bit values left; despite the name (rotate), bits shifted out on the left are lost
     *   SOURCE1      DATA16      value to shift
     *   SOURCE2      DATA16      number of places (bits)
     *   DESTINATION  out DATA16  shifted value, filled up with zero bits
     */
    opRL16 = 0x2D,

    /*
     * Shifts 32-bit values left; despite the name (rotate), bits shifted out on the left are lost
     *   SOURCE1      DATA32      value to shift
     *   SOURCE2      DATA32      number of places (bits)
     *   DESTINATION  out DATA32  shifted value, filled up with zero bits
     */
    opRL32 = 0x2E,

    /* Applies a mathematical function: a CMD follows, below */
    opMATH = 0x8D,

    /*
     * Draws a random whole number
     *   MIN    DATA16      smallest number to draw
     *   MAX    DATA16      largest number to draw
     *   VALUE  out DATA16  the number drawn, MIN to MAX, both included
     */
    opRANDOM = 0x8E,
};

/* CMDs of opMATH */
enum {
    /*
     * Raises e to a power
     *   X  DATAF      the power
     *   R  out DATAF  result
     */
    EXP = 1,

    /*
     * Takes the remainder of a floating-point division
     *   X  DATAF      number to divide
     *   Y  DATAF      number to divide by
     *   R  out DATAF  remainder, with the sign of X
     */
    MOD = 2,

    /*
     * Rounds down to a whole number
     *   X  DATAF      number to work on
     *   R  out DATAF  result
     */
    FLOOR = 3,

    /*
     * Rounds up to a whole number
     *   X  DATAF      number to work on
     *   R  out DATAF  result
     */
    CEIL = 4,

    /*
     * Rounds to the nearest whole number, halves away from zero
     *   X  DATAF      number to work on
     *   R  out DATAF  result
     */
    ROUND = 5,

    /*
     * Drops the sign
     *   X  DATAF      number to work on
     *   R  out DATAF  result
     */
    ABS = 6,

    /*
     * Reverses the sign
     *   X  DATAF      number to work on
     *   R  out DATAF  result
     */
    NEGATE = 7,

    /*
     * Takes the square root
     *   X  DATAF      number to work on, not negative
     *   R  out DATAF  result
     */
    SQRT = 8,

    /*
     * Takes the logarithm to base 10
     *   X  DATAF      number to work on, above 0
     *   R  out DATAF  result
     */
    LOG = 9,

    /*
     * Takes the natural logarithm
     *   X  DATAF      number to work on, above 0
     *   R  out DATAF  result
     */
    LN = 10,

    /*
     * Takes the sine of an angle in degrees
     *   X  DATAF      angle (degrees)
     *   R  out DATAF  sine, -1 to 1
     */
    SIN = 11,

    /*
     * Takes the cosine of an angle in degrees
     *   X  DATAF      angle (degrees)
     *   R  out DATAF  cosine, -1 to 1
     */
    COS = 12,

    /*
     * Takes the tangent of an angle in degrees
     *   X  DATAF      angle (degrees)
     *   R  out DATAF  tangent
     */
    TAN = 13,

    /*
     * Finds the angle that has a sine
     *   X  DATAF      sine (-1 to 1)
     *   R  out DATAF  angle (degrees)
     */
    ASIN = 14,

    /*
     * Finds the angle that has a cosine
     *   X  DATAF      cosine (-1 to 1)
     *   R  out DATAF  angle (degrees)
     */
    ACOS = 15,

    /*
     * Finds the angle that has a tangent
     *   X  DATAF      tangent
     *   R  out DATAF  angle (degrees)
     */
    ATAN = 16,

    /*
     * Takes the remainder of an 8-bit division
     *   X  DATA8      number to divide
     *   Y  DATA8      number to divide by, not 0
     *   R  out DATA8  remainder, with the sign of X
     */
    MOD8 = 17,

    /*
     * Takes the remainder of a 16-bit division
     *   X  DATA16      number to divide
     *   Y  DATA16      number to divide by, not 0
     *   R  out DATA16  remainder, with the sign of X
     */
    MOD16 = 18,

    /*
     * Takes the remainder of a 32-bit division
     *   X  DATA32      number to divide
     *   Y  DATA32      number to divide by, not 0
     *   R  out DATA32  remainder, with the sign of X
     */
    MOD32 = 19,

    /*
     * Raises a number to a power
     *   X  DATAF      number to raise
     *   Y  DATAF      the power
     *   R  out DATAF  result
     */
    POW = 20,

    /*
     * Cuts off decimals without rounding
     *   X  DATAF      number to work on
     *   P  DATA8      number of decimals to keep (at most 6 are available) (0 to 9)
     *   R  out DATAF  result
     */
    TRUNC = 21,
};

/* Moving and converting values ------------------------------------------------------------------------------------- */

enum {
    /*
     * Fills consecutive bytes of memory with constant values
     *   DESTINATION  out DATA8  first byte to fill (as many values as LENGTH says)
     *   LENGTH       DATA32     number of values that follow; a negative count hangs the brick (bytes)
     *   SOURCE       values     the values, one per byte (each is DATA8)
     */
    opINIT_BYTES = 0x2F,

    /*
     * Copies a value to another variable, both 8-bit
     *   SOURCE       DATA8      value to copy
     *   DESTINATION  out DATA8  copy of the value
     */
    opMOVE8_8 = 0x30,

    /*
     * Converts a value, 8-bit to 16-bit; NaN stays NaN
     *   SOURCE       DATA8       value to copy
     *   DESTINATION  out DATA16  copy of the value
     */
    opMOVE8_16 = 0x31,

    /*
     * Converts a value, 8-bit to 32-bit; NaN stays NaN
     *   SOURCE       DATA8       value to copy
     *   DESTINATION  out DATA32  copy of the value
     */
    opMOVE8_32 = 0x32,

    /*
     * Converts a value, 8-bit to floating-point; NaN stays NaN
     *   SOURCE       DATA8      value to copy
     *   DESTINATION  out DATAF  copy of the value
     */
    opMOVE8_F = 0x33,

    /*
     * Converts a value, 16-bit to 8-bit; limited to what fits, NaN stays NaN
     *   SOURCE       DATA16     value to copy
     *   DESTINATION  out DATA8  copy of the value
     */
    opMOVE16_8 = 0x34,

    /*
     * Copies a value to another variable, both 16-bit
     *   SOURCE       DATA16      value to copy
     *   DESTINATION  out DATA16  copy of the value
     */
    opMOVE16_16 = 0x35,

    /*
     * Converts a value, 16-bit to 32-bit; NaN stays NaN
     *   SOURCE       DATA16      value to copy
     *   DESTINATION  out DATA32  copy of the value
     */
    opMOVE16_32 = 0x36,

    /*
     * Converts a value, 16-bit to floating-point; NaN stays NaN
     *   SOURCE       DATA16     value to copy
     *   DESTINATION  out DATAF  copy of the value
     */
    opMOVE16_F = 0x37,

    /*
     * Converts a value, 32-bit to 8-bit; limited to what fits, NaN stays NaN
     *   SOURCE       DATA32     value to copy
     *   DESTINATION  out DATA8  copy of the value
     */
    opMOVE32_8 = 0x38,

    /*
     * Converts a value, 32-bit to 16-bit; limited to what fits, NaN stays NaN
     *   SOURCE       DATA32      value to copy
     *   DESTINATION  out DATA16  copy of the value
     */
    opMOVE32_16 = 0x39,

    /*
     * Copies a value to another variable, both 32-bit
     *   SOURCE       DATA32      value to copy
     *   DESTINATION  out DATA32  copy of the value
     */
    opMOVE32_32 = 0x3A,

    /*
     * Converts a value, 32-bit to floating-point; NaN stays NaN
     *   SOURCE       DATA32     value to copy
     *   DESTINATION  out DATAF  copy of the value
     */
    opMOVE32_F = 0x3B,

    /*
     * Converts a value, floating-point to 8-bit; limited to what fits, NaN stays NaN
     *   SOURCE       DATAF      value to copy
     *   DESTINATION  out DATA8  copy of the value
     */
    opMOVEF_8 = 0x3C,

    /*
     * Converts a value, floating-point to 16-bit; limited to what fits, NaN stays NaN
     *   SOURCE       DATAF       value to copy
     *   DESTINATION  out DATA16  copy of the value
     */
    opMOVEF_16 = 0x3D,

    /*
     * Converts a value, floating-point to 32-bit; limited to what fits, NaN stays NaN
     *   SOURCE       DATAF       value to copy
     *   DESTINATION  out DATA32  copy of the value
     */
    opMOVEF_32 = 0x3E,

    /*
     * Copies a value to another variable, both floating-point
     *   SOURCE       DATAF      value to copy
     *   DESTINATION  out DATAF  copy of the value
     */
    opMOVEF_F = 0x3F,

    /*
     * Reads one element of an array of 8-bit values
     *   SOURCE       DATA8      first element of the array, as a variable
     *   INDEX        DATA8      which element, counted from 0; the firmware does not check it (0 to 127)
     *   DESTINATION  out DATA8  the element's value
     */
    opREAD8 = 0xC8,

    /*
     * Reads one element of an array of 16-bit values
     *   SOURCE       DATA16      first element of the array, as a variable
     *   INDEX        DATA8       which element, counted from 0; the firmware does not check it (0 to 127)
     *   DESTINATION  out DATA16  the element's value
     */
    opREAD16 = 0xC9,

    /*
     * Reads one element of an array of 32-bit values
     *   SOURCE       DATA32      first element of the array, as a variable
     *   INDEX        DATA8       which element, counted from 0; the firmware does not check it (0 to 127)
     *   DESTINATION  out DATA32  the element's value
     */
    opREAD32 = 0xCA,

    /*
     * Reads one element of an array of floating-point values
     *   SOURCE       DATAF      first element of the array, as a variable
     *   INDEX        DATA8      which element, counted from 0; the firmware does not check it (0 to 127)
     *   DESTINATION  out DATAF  the element's value
     */
    opREADF = 0xCB,

    /*
     * Writes one element of an array of 8-bit values
     *   SOURCE       DATA8  value to write
     *   INDEX        DATA8  which element, counted from 0; the firmware does not check it (0 to 127)
     *   DESTINATION  DATA8  first element of the array, as a variable; element INDEX is written
     */
    opWRITE8 = 0xCC,

    /*
     * Writes one element of an array of 16-bit values
     *   SOURCE       DATA16  value to write
     *   INDEX        DATA8   which element, counted from 0; the firmware does not check it (0 to 127)
     *   DESTINATION  DATA16  first element of the array, as a variable; element INDEX is written
     */
    opWRITE16 = 0xCD,

    /*
     * Writes one element of an array of 32-bit values
     *   SOURCE       DATA32  value to write
     *   INDEX        DATA8   which element, counted from 0; the firmware does not check it (0 to 127)
     *   DESTINATION  DATA32  first element of the array, as a variable; element INDEX is written
     */
    opWRITE32 = 0xCE,

    /*
     * Writes one element of an array of floating-point values
     *   SOURCE       DATAF  value to write
     *   INDEX        DATA8  which element, counted from 0; the firmware does not check it (0 to 127)
     *   DESTINATION  DATAF  first element of the array, as a variable; element INDEX is written
     */
    opWRITEF = 0xCF,
};

/* Jumps ------------------------------------------------------------------------------------------------------------ */

enum {
    /*
     * Jumps always
     *   OFFSET  label  how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR = 0x40,

    /*
     * Jumps if a flag is 0
     *   FLAG    DATA8  the condition: anything but 0 is true (0: false; 1: true)
     *   OFFSET  label  how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_FALSE = 0x41,

    /*
     * Jumps if a flag is not 0
     *   FLAG    DATA8  the condition: anything but 0 is true (0: false; 1: true)
     *   OFFSET  label  how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_TRUE = 0x42,

    /*
     * Jumps if a value is not a number, as read from a sensor without data
     *   VALUE   DATAF  value to look at
     *   OFFSET  label  how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_NAN = 0x43,

    /*
     * Jumps if LEFT is less than RIGHT, as 8-bit numbers
     *   LEFT    DATA8  left side of the comparison
     *   RIGHT   DATA8  right side of the comparison
     *   OFFSET  label  how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_LT8 = 0x64,

    /*
     * Jumps if LEFT is less than RIGHT, as 16-bit numbers
     *   LEFT    DATA16  left side of the comparison
     *   RIGHT   DATA16  right side of the comparison
     *   OFFSET  label   how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_LT16 = 0x65,

    /*
     * Jumps if LEFT is less than RIGHT, as 32-bit numbers
     *   LEFT    DATA32  left side of the comparison
     *   RIGHT   DATA32  right side of the comparison
     *   OFFSET  label   how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_LT32 = 0x66,

    /*
     * Jumps if LEFT is less than RIGHT, as floating-point numbers
     *   LEFT    DATAF  left side of the comparison
     *   RIGHT   DATAF  right side of the comparison
     *   OFFSET  label  how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_LTF = 0x67,

    /*
     * Jumps if LEFT is greater than RIGHT, as 8-bit numbers
     *   LEFT    DATA8  left side of the comparison
     *   RIGHT   DATA8  right side of the comparison
     *   OFFSET  label  how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_GT8 = 0x68,

    /*
     * Jumps if LEFT is greater than RIGHT, as 16-bit numbers
     *   LEFT    DATA16  left side of the comparison
     *   RIGHT   DATA16  right side of the comparison
     *   OFFSET  label   how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_GT16 = 0x69,

    /*
     * Jumps if LEFT is greater than RIGHT, as 32-bit numbers
     *   LEFT    DATA32  left side of the comparison
     *   RIGHT   DATA32  right side of the comparison
     *   OFFSET  label   how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_GT32 = 0x6A,

    /*
     * Jumps if LEFT is greater than RIGHT, as floating-point numbers
     *   LEFT    DATAF  left side of the comparison
     *   RIGHT   DATAF  right side of the comparison
     *   OFFSET  label  how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_GTF = 0x6B,

    /*
     * Jumps if LEFT is equal to RIGHT, as 8-bit numbers
     *   LEFT    DATA8  left side of the comparison
     *   RIGHT   DATA8  right side of the comparison
     *   OFFSET  label  how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_EQ8 = 0x6C,

    /*
     * Jumps if LEFT is equal to RIGHT, as 16-bit numbers
     *   LEFT    DATA16  left side of the comparison
     *   RIGHT   DATA16  right side of the comparison
     *   OFFSET  label   how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_EQ16 = 0x6D,

    /*
     * Jumps if LEFT is equal to RIGHT, as 32-bit numbers
     *   LEFT    DATA32  left side of the comparison
     *   RIGHT   DATA32  right side of the comparison
     *   OFFSET  label   how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_EQ32 = 0x6E,

    /*
     * Jumps if LEFT is equal to RIGHT, as floating-point numbers
     *   LEFT    DATAF  left side of the comparison
     *   RIGHT   DATAF  right side of the comparison
     *   OFFSET  label  how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_EQF = 0x6F,

    /*
     * Jumps if LEFT is different from RIGHT, as 8-bit numbers
     *   LEFT    DATA8  left side of the comparison
     *   RIGHT   DATA8  right side of the comparison
     *   OFFSET  label  how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_NEQ8 = 0x70,

    /*
     * Jumps if LEFT is different from RIGHT, as 16-bit numbers
     *   LEFT    DATA16  left side of the comparison
     *   RIGHT   DATA16  right side of the comparison
     *   OFFSET  label   how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_NEQ16 = 0x71,

    /*
     * Jumps if LEFT is different from RIGHT, as 32-bit numbers
     *   LEFT    DATA32  left side of the comparison
     *   RIGHT   DATA32  right side of the comparison
     *   OFFSET  label   how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_NEQ32 = 0x72,

    /*
     * Jumps if LEFT is different from RIGHT, as floating-point numbers
     *   LEFT    DATAF  left side of the comparison
     *   RIGHT   DATAF  right side of the comparison
     *   OFFSET  label  how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_NEQF = 0x73,

    /*
     * Jumps if LEFT is less than or equal to RIGHT, as 8-bit numbers
     *   LEFT    DATA8  left side of the comparison
     *   RIGHT   DATA8  right side of the comparison
     *   OFFSET  label  how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_LTEQ8 = 0x74,

    /*
     * Jumps if LEFT is less than or equal to RIGHT, as 16-bit numbers
     *   LEFT    DATA16  left side of the comparison
     *   RIGHT   DATA16  right side of the comparison
     *   OFFSET  label   how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_LTEQ16 = 0x75,

    /*
     * Jumps if LEFT is less than or equal to RIGHT, as 32-bit numbers
     *   LEFT    DATA32  left side of the comparison
     *   RIGHT   DATA32  right side of the comparison
     *   OFFSET  label   how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_LTEQ32 = 0x76,

    /*
     * Jumps if LEFT is less than or equal to RIGHT, as floating-point numbers
     *   LEFT    DATAF  left side of the comparison
     *   RIGHT   DATAF  right side of the comparison
     *   OFFSET  label  how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_LTEQF = 0x77,

    /*
     * Jumps if LEFT is greater than or equal to RIGHT, as 8-bit numbers
     *   LEFT    DATA8  left side of the comparison
     *   RIGHT   DATA8  right side of the comparison
     *   OFFSET  label  how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_GTEQ8 = 0x78,

    /*
     * Jumps if LEFT is greater than or equal to RIGHT, as 16-bit numbers
     *   LEFT    DATA16  left side of the comparison
     *   RIGHT   DATA16  right side of the comparison
     *   OFFSET  label   how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_GTEQ16 = 0x79,

    /*
     * Jumps if LEFT is greater than or equal to RIGHT, as 32-bit numbers
     *   LEFT    DATA32  left side of the comparison
     *   RIGHT   DATA32  right side of the comparison
     *   OFFSET  label   how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_GTEQ32 = 0x7A,

    /*
     * Jumps if LEFT is greater than or equal to RIGHT, as floating-point numbers
     *   LEFT    DATAF  left side of the comparison
     *   RIGHT   DATAF  right side of the comparison
     *   OFFSET  label  how far to jump from the end of this operation; negative jumps back; or a label (bytes)
     */
    opJR_GTEQF = 0x7B,
};

/* Comparisons ------------------------------------------------------------------------------------------------------ */

enum {
    /*
     * Tests whether LEFT is less than RIGHT, as 8-bit numbers
     *   LEFT   DATA8      left side of the comparison
     *   RIGHT  DATA8      right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_LT8 = 0x44,

    /*
     * Tests whether LEFT is less than RIGHT, as 16-bit numbers
     *   LEFT   DATA16     left side of the comparison
     *   RIGHT  DATA16     right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_LT16 = 0x45,

    /*
     * Tests whether LEFT is less than RIGHT, as 32-bit numbers
     *   LEFT   DATA32     left side of the comparison
     *   RIGHT  DATA32     right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_LT32 = 0x46,

    /*
     * Tests whether LEFT is less than RIGHT, as floating-point numbers
     *   LEFT   DATAF      left side of the comparison
     *   RIGHT  DATAF      right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_LTF = 0x47,

    /*
     * Tests whether LEFT is greater than RIGHT, as 8-bit numbers
     *   LEFT   DATA8      left side of the comparison
     *   RIGHT  DATA8      right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_GT8 = 0x48,

    /*
     * Tests whether LEFT is greater than RIGHT, as 16-bit numbers
     *   LEFT   DATA16     left side of the comparison
     *   RIGHT  DATA16     right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_GT16 = 0x49,

    /*
     * Tests whether LEFT is greater than RIGHT, as 32-bit numbers
     *   LEFT   DATA32     left side of the comparison
     *   RIGHT  DATA32     right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_GT32 = 0x4A,

    /*
     * Tests whether LEFT is greater than RIGHT, as floating-point numbers
     *   LEFT   DATAF      left side of the comparison
     *   RIGHT  DATAF      right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_GTF = 0x4B,

    /*
     * Tests whether LEFT is equal to RIGHT, as 8-bit numbers
     *   LEFT   DATA8      left side of the comparison
     *   RIGHT  DATA8      right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_EQ8 = 0x4C,

    /*
     * Tests whether LEFT is equal to RIGHT, as 16-bit numbers
     *   LEFT   DATA16     left side of the comparison
     *   RIGHT  DATA16     right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_EQ16 = 0x4D,

    /*
     * Tests whether LEFT is equal to RIGHT, as 32-bit numbers
     *   LEFT   DATA32     left side of the comparison
     *   RIGHT  DATA32     right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_EQ32 = 0x4E,

    /*
     * Tests whether LEFT is equal to RIGHT, as floating-point numbers
     *   LEFT   DATAF      left side of the comparison
     *   RIGHT  DATAF      right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_EQF = 0x4F,

    /*
     * Tests whether LEFT is different from RIGHT, as 8-bit numbers
     *   LEFT   DATA8      left side of the comparison
     *   RIGHT  DATA8      right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_NEQ8 = 0x50,

    /*
     * Tests whether LEFT is different from RIGHT, as 16-bit numbers
     *   LEFT   DATA16     left side of the comparison
     *   RIGHT  DATA16     right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_NEQ16 = 0x51,

    /*
     * Tests whether LEFT is different from RIGHT, as 32-bit numbers
     *   LEFT   DATA32     left side of the comparison
     *   RIGHT  DATA32     right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_NEQ32 = 0x52,

    /*
     * Tests whether LEFT is different from RIGHT, as floating-point numbers
     *   LEFT   DATAF      left side of the comparison
     *   RIGHT  DATAF      right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_NEQF = 0x53,

    /*
     * Tests whether LEFT is less than or equal to RIGHT, as 8-bit numbers
     *   LEFT   DATA8      left side of the comparison
     *   RIGHT  DATA8      right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_LTEQ8 = 0x54,

    /*
     * Tests whether LEFT is less than or equal to RIGHT, as 16-bit numbers
     *   LEFT   DATA16     left side of the comparison
     *   RIGHT  DATA16     right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_LTEQ16 = 0x55,

    /*
     * Tests whether LEFT is less than or equal to RIGHT, as 32-bit numbers
     *   LEFT   DATA32     left side of the comparison
     *   RIGHT  DATA32     right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_LTEQ32 = 0x56,

    /*
     * Tests whether LEFT is less than or equal to RIGHT, as floating-point numbers
     *   LEFT   DATAF      left side of the comparison
     *   RIGHT  DATAF      right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_LTEQF = 0x57,

    /*
     * Tests whether LEFT is greater than or equal to RIGHT, as 8-bit numbers
     *   LEFT   DATA8      left side of the comparison
     *   RIGHT  DATA8      right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_GTEQ8 = 0x58,

    /*
     * Tests whether LEFT is greater than or equal to RIGHT, as 16-bit numbers
     *   LEFT   DATA16     left side of the comparison
     *   RIGHT  DATA16     right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_GTEQ16 = 0x59,

    /*
     * Tests whether LEFT is greater than or equal to RIGHT, as 32-bit numbers
     *   LEFT   DATA32     left side of the comparison
     *   RIGHT  DATA32     right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_GTEQ32 = 0x5A,

    /*
     * Tests whether LEFT is greater than or equal to RIGHT, as floating-point numbers
     *   LEFT   DATAF      left side of the comparison
     *   RIGHT  DATAF      right side of the comparison
     *   FLAG   out DATA8  result of the comparison (0 to 1; 0: false; 1: true)
     */
    opCP_GTEQF = 0x5B,

    /*
     * Selects one of two 8-bit values by a flag
     *   FLAG     DATA8      which one: anything but 0 selects SOURCE1 (0: SOURCE2; 1: SOURCE1)
     *   SOURCE1  DATA8      value selected if the flag is set
     *   SOURCE2  DATA8      value selected if the flag is 0
     *   RESULT   out DATA8  the selected value
     */
    opSELECT8 = 0x5C,

    /*
     * Selects one of two 16-bit values by a flag
     *   FLAG     DATA8       which one: anything but 0 selects SOURCE1 (0: SOURCE2; 1: SOURCE1)
     *   SOURCE1  DATA16      value selected if the flag is set
     *   SOURCE2  DATA16      value selected if the flag is 0
     *   RESULT   out DATA16  the selected value
     */
    opSELECT16 = 0x5D,

    /*
     * Selects one of two 32-bit values by a flag
     *   FLAG     DATA8       which one: anything but 0 selects SOURCE1 (0: SOURCE2; 1: SOURCE1)
     *   SOURCE1  DATA32      value selected if the flag is set
     *   SOURCE2  DATA32      value selected if the flag is 0
     *   RESULT   out DATA32  the selected value
     */
    opSELECT32 = 0x5E,

    /*
     * Selects one of two floating-point values by a flag
     *   FLAG     DATA8      which one: anything but 0 selects SOURCE1 (0: SOURCE2; 1: SOURCE1)
     *   SOURCE1  DATAF      value selected if the flag is set
     *   SOURCE2  DATAF      value selected if the flag is 0
     *   RESULT   out DATAF  the selected value
     */
    opSELECTF = 0x5F,
};

/* Display, buttons, lights, battery -------------------------------------------------------------------------------- */

enum {
    /* Sends the contents of the terminal's output buffer */
    opUI_FLUSH = 0x80,

    /* Reads the state of the brick or what the terminal received: a CMD follows, below */
    opUI_READ = 0x81,

    /* Writes to the terminal or sets lights and states of the brick: a CMD follows, below */
    opUI_WRITE = 0x82,

    /* Reads or simulates the buttons: a CMD follows, below */
    opUI_BUTTON = 0x83,

    /* Draws on the canvas of the display, or runs a dialogue on it: a CMD follows, below */
    opUI_DRAW = 0x84,

    /*
     * Restarts the timer that switches off an idle brick, and reads its time
     *   MINUTES  out DATA8  idle time before switching off (min; 0: never)
     */
    opKEEP_ALIVE = 0x90,
};

/* CMDs of opUI_READ */
enum {
    /*
     * Reads the battery voltage
     *   VALUE  out DATAF  voltage (V)
     */
    GET_VBATT = 1,

    /*
     * Reads the battery current
     *   VALUE  out DATAF  current (A)
     */
    GET_IBATT = 2,

    /*
     * Reads name and version of the operating system
     *   LENGTH       DATA8       maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no
     *       limit)
     *   DESTINATION  out string  system and kernel release, such as Linux 2.6.33-rc4 (as many bytes as LENGTH says)
     */
    GET_OS_VERS = 3,

    /*
     * Reads and clears the pending event (used by the brick's own menus)
     *   EVENT  out DATA8  what happened (0: nothing; 1: Bluetooth asks for a PIN; 2: Bluetooth asks to confirm a
     *       connection)
     */
    GET_EVENT = 4,

    /*
     * Reads the rise in battery temperature, estimated from the current
     *   VALUE  out DATAF  estimated rise in temperature (deg C)
     */
    GET_TBATT = 5,

    /*
     * Reads the battery current smoothed over time
     *   IINT  out DATAF  integrated current (A)
     */
    GET_IINT = 6,

    /*
     * Reads the current of all motors together
     *   VALUE  out DATAF  current (A)
     */
    GET_IMOTOR = 7,

    /*
     * Waits for a line typed at the terminal and reads it
     *   LENGTH       DATA8       maximum number of bytes to return, not including the zero (0 to 127 bytes)
     *   DESTINATION  out string  the line (as many bytes as LENGTH says)
     */
    GET_STRING = 8,

    /*
     * Reads the hardware version
     *   LENGTH       DATA8       maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no
     *       limit)
     *   DESTINATION  out string  hardware version, such as V0.60 (as many bytes as LENGTH says)
     */
    GET_HW_VERS = 9,

    /*
     * Reads the firmware version
     *   LENGTH       DATA8       maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no
     *       limit)
     *   DESTINATION  out string  firmware version, such as V1.04H (as many bytes as LENGTH says)
     */
    GET_FW_VERS = 10,

    /*
     * Reads the build time of the firmware
     *   LENGTH       DATA8       maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no
     *       limit)
     *   DESTINATION  out string  build time as yymmddhhmm (as many bytes as LENGTH says)
     */
    GET_FW_BUILD = 11,

    /*
     * Reads the build time of the operating system
     *   LENGTH       DATA8       maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no
     *       limit)
     *   DESTINATION  out string  build time as yymmddhhmm (as many bytes as LENGTH says)
     */
    GET_OS_BUILD = 12,

    /*
     * Waits for a decimal number typed at the terminal and reads it (debugging)
     *   VALUE  out DATA32  the number, meant as an address
     */
    GET_ADDRESS = 13,

    /*
     * Waits for byte code typed as hex at the terminal and builds a program from it (debugging)
     *   LENGTH  DATA32      maximum number of bytes of the program, including headers (bytes)
     *   IMAGE   DATA32      address of the memory where the program is built
     *   GLOBAL  out DATA32  address of the program's global variables
     *   FLAG    out DATA8   whether the program can be started; 1 or unchanged (1: ready)
     */
    GET_CODE = 14,

    /*
     * Takes one key from the terminal without waiting
     *   VALUE  out DATA8  character code of the key (0: no key)
     */
    KEY = 15,

    /*
     * Reads and clears the request to shut down (used by the brick's own menus)
     *   FLAG  out DATA8  whether the brick wants to shut down (0 to 1; 0: no; 1: yes)
     */
    GET_SHUTDOWN = 16,

    /*
     * Reads the brick's warnings
     *   WARNINGS  out DATA8  one bit for each warning (0: none; a member of WARNING)
     */
    GET_WARNING = 17,

    /*
     * Reads the battery level, derived from its voltage
     *   PCT  out DATA8  battery level (0 to 100 %)
     */
    GET_LBATT = 18,

    /*
     * Reads one line of the text of a text box
     *   TEXT         string      whole text of the box, its lines separated by DEL
     *   SIZE         DATA32      size of the box's text buffer, including the zero (bytes)
     *   DEL          DATA8       what separates the lines (a member of DEL)
     *   LENGTH       DATA8       maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no
     *       limit)
     *   LINE         DATA16      which line, counted from 1
     *   DESTINATION  out string  the line, empty if there is no such line (as many bytes as LENGTH says)
     */
    TEXTBOX_READ = 21,

    /*
     * Reads name, version and build date of the firmware in one string
     *   LENGTH       DATA8       maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no
     *       limit)
     *   DESTINATION  out string  such as LMS2012 V1.04H(Jul 26 2013 12:00:00) (as many bytes as LENGTH says)
     */
    GET_VERSION = 26,

    /*
     * Reads the brick's IP address
     *   LENGTH       DATA8       maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no
     *       limit)
     *   DESTINATION  out string  address in dotted notation (as many bytes as LENGTH says)
     */
    GET_IP = 27,

    /*
     * Reads all values of the power supply at once
     *   VBATT   out DATAF  battery voltage (V)
     *   IBATT   out DATAF  battery current (A)
     *   IINT    out DATAF  battery current smoothed over time (A)
     *   IMOTOR  out DATAF  current of all motors together (A)
     */
    GET_POWER = 29,

    /*
     * Reads whether an SD card is present, and its space
     *   STATE  out DATA8   whether one is present (0 to 1; 0: absent; 1: present)
     *   TOTAL  out DATA32  size (KiB)
     *   FREE   out DATA32  free space (KiB)
     */
    GET_SDCARD = 30,

    /*
     * Reads whether a USB stick is present, and its space
     *   STATE  out DATA8   whether one is present (0 to 1; 0: absent; 1: present)
     *   TOTAL  out DATA32  size (KiB)
     *   FREE   out DATA32  free space (KiB)
     */
    GET_USBSTICK = 31,
};

/* CMDs of opUI_WRITE */
enum {
    /* Sends the contents of the terminal's output buffer, like UI_FLUSH */
    WRITE_FLUSH = 1,

    /*
     * Writes a number in a fixed format to the terminal
     *   VALUE     DATAF  number to write
     *   FIGURES   DATA8  total number of characters, including the decimal point; negative aligns left
     *   DECIMALS  DATA8  digits after the decimal point
     */
    FLOATVALUE = 2,

    /*
     * Writes time, program, object, position and a comment to the terminal
     *   VALUE  string  remark
     */
    STAMP = 3,

    /*
     * Writes text to the terminal
     *   STRING  string  text to write
     */
    PUT_STRING = 8,

    /*
     * Writes a whole number to the terminal
     *   VALUE  DATA8  number to write
     */
    VALUE8 = 9,

    /*
     * Writes an unsigned whole number to the terminal
     *   VALUE  DATA16  number to write
     */
    VALUE16 = 10,

    /*
     * Writes a whole number to the terminal
     *   VALUE  DATA32  number to write
     */
    VALUE32 = 11,

    /*
     * Writes a number to the terminal
     *   VALUE  DATAF  number to write
     */
    VALUEF = 12,

    /*
     * Not implemented in the firmware: the program that runs it fails
     *   VALUE  out DATA32  address; never written
     */
    ADDRESS = 13,

    /*
     * Writes bytes of memory as hex to the terminal
     *   ARRAY   DATA32  address of the bytes
     *   LENGTH  DATA32  number of bytes (bytes)
     */
    CODE = 14,

    /* Plays the sound of a finished download and refreshes the file browser */
    DOWNLOAD_END = 15,

    /*
     * Blocks or unblocks the display and the buttons for programs
     *   STATUS  DATA8  whether drawing is ignored (0 to 1; 0: normal; 1: blocked)
     */
    SCREEN_BLOCK = 16,

    /*
     * Selects the debug pulses that are shown (only in debug builds of the firmware)
     *   VALUE  DATA8  sum of bits (1: menu background; 2: browser; 4: key)
     */
    ALLOW_PULSE = 17,

    /*
     * Raises debug pulses (only in debug builds of the firmware)
     *   VALUE  DATA8  sum of bits (1: menu background; 2: browser; 4: key)
     */
    SET_PULSE = 18,

    /*
     * Appends a line to the text of a text box
     *   TEXT    in/out string  whole text of the box, its lines separated by DEL (as many bytes as SIZE says)
     *   SIZE    DATA32         size of the box's text buffer, including the zero (bytes)
     *   DEL     DATA8          what separates the lines (a member of DEL)
     *   SOURCE  string         line to append
     */
    TEXTBOX_APPEND = 21,

    /*
     * Sets or clears the busy bit among the warnings
     *   VALUE  DATA8  whether the brick counts as busy (0 to 1; 0: no; 1: yes)
     */
    SET_BUSY = 22,

    /*
     * Sets the test pin on the brick's circuit board
     *   STATE  DATA8  level of the pin (0 to 1; 0: low; 1: high)
     */
    SET_TESTPIN = 24,

    /* Shows the animation of a running program until something draws */
    INIT_RUN = 25,

    /* Does nothing */
    UPDATE_RUN = 26,

    /*
     * Sets colour and blinking of the light around the buttons
     *   PATTERN  DATA8  colour and rhythm (a member of LEDPATTERN)
     */
    LED = 27,

    /*
     * Sets the flag that makes the power driver switch off when the firmware ends
     *   VALUE  DATA8  the flag (0 to 1)
     */
    POWER = 29,

    /* Adds the current values to the graph of GRAPH_SETUP */
    GRAPH_SAMPLE = 30,

    /*
     * Switches the debug terminal on or off
     *   STATE  DATA8  whether the terminal is on (0 to 1; 0: off; 1: on)
     */
    TERMINAL = 31,
};

/* CMDs of opUI_BUTTON */
enum {
    /*
     * Reports whether a button was pressed since the last query, and clears the press
     *   BUTTON  DATA8      which button (a member of BUTTONTYPE)
     *   STATE   out DATA8  whether the button was pressed (0 to 1; 0: no; 1: yes)
     */
    SHORTPRESS = 1,

    /*
     * Reports whether a button was held for 3 s since the last query, and clears it
     *   BUTTON  DATA8      which button (a member of BUTTONTYPE)
     *   STATE   out DATA8  whether the button was held for 3 s (0 to 1; 0: no; 1: yes)
     */
    LONGPRESS = 2,

    /* Waits until any button has been pressed, by hand or by PRESS */
    WAIT_FOR_PRESS = 3,

    /* Clears all pending presses */
    FLUSH = 4,

    /*
     * Presses a button as if by hand and holds it until RELEASE
     *   BUTTON  DATA8  which button (a member of BUTTONTYPE)
     */
    PRESS = 5,

    /*
     * Releases a button that PRESS holds
     *   BUTTON  DATA8  which button (a member of BUTTONTYPE)
     */
    RELEASE = 6,

    /*
     * Reads the left and right buttons as one axis, and clears their presses
     *   VALUE  out DATA16  direction (-1 to 1; -1: left; 1: right; 0: not pressed)
     */
    GET_HORZ = 7,

    /*
     * Reads the up and down buttons as one axis, and clears their presses
     *   VALUE  out DATA16  direction (-1 to 1; -1: up; 1: down; 0: not pressed)
     */
    GET_VERT = 8,

    /*
     * Reports whether a button is down at the moment
     *   BUTTON  DATA8      which button (a member of BUTTONTYPE)
     *   STATE   out DATA8  whether the button is down (0 to 1; 0: no; 1: yes)
     */
    PRESSED = 9,

    /*
     * Blocks or unblocks the back button, which ends the running program
     *   BLOCKED  DATA8  whether the back button is blocked (0 to 1; 0: not blocked; 1: blocked)
     */
    SET_BACK_BLOCK = 10,

    /*
     * Reports whether the back button is blocked
     *   BLOCKED  out DATA8  whether the back button is blocked (0 to 1; 0: not blocked; 1: blocked)
     */
    GET_BACK_BLOCK = 11,

    /*
     * Reports, like SHORTPRESS, whether a button was pressed, without clearing the press
     *   BUTTON  DATA8      which button (a member of BUTTONTYPE)
     *   STATE   out DATA8  whether the button was pressed (0 to 1; 0: no; 1: yes)
     */
    TESTSHORTPRESS = 12,

    /*
     * Reports, like LONGPRESS, whether a button was held for 3 s, without clearing it
     *   BUTTON  DATA8      which button (a member of BUTTONTYPE)
     *   STATE   out DATA8  whether the button was held for 3 s (0 to 1; 0: no; 1: yes)
     */
    TESTLONGPRESS = 13,

    /*
     * Reports whether a button was pressed and released since the last query, and clears it (official and xtended
     *     firmware only)
     *   BUTTON  DATA8      which button (a member of BUTTONTYPE)
     *   STATE   out DATA8  whether the button was pressed and released (0 to 1; 0: no; 1: yes)
     */
    GET_BUMBED = 14,

    /*
     * Reports whether a button was pressed and released since the last query, and clears it (compat firmware only)
     *   BUTTON  DATA8      which button (a member of BUTTONTYPE)
     *   STATE   out DATA8  whether the button was pressed and released (0 to 1; 0: no; 1: yes)
     */
    GET_BUMPED = 14,

    /*
     * Reports whether a key click is due for a handled press, and clears it
     *   CLICK  out DATA8  whether a click is due (0 to 1; 0: no; 1: yes)
     */
    GET_CLICK = 15,
};

/* CMDs of opUI_DRAW */
enum {
    /* Shows on the display what has been drawn, and restores the normal font */
    UPDATE = 0,

    /* Clears the canvas to white, and restores the normal font */
    CLEAN = 1,

    /*
     * Draws one pixel
     *   COLOR  DATA8   colour to draw in (0 to 1; 0: white; 1: black)
     *   X0     DATA16  column (0 to 177 px)
     *   Y0     DATA16  row (0 to 127 px)
     */
    PIXEL = 2,

    /*
     * Draws a line between two points
     *   COLOR  DATA8   colour to draw in (0 to 1; 0: white; 1: black)
     *   X0     DATA16  column of the start (0 to 177 px)
     *   Y0     DATA16  row of the start (0 to 127 px)
     *   X1     DATA16  column of the end (0 to 178 px)
     *   Y1     DATA16  row of the end (0 to 128 px)
     */
    LINE = 3,

    /*
     * Draws a circle
     *   COLOR  DATA8   colour to draw in (0 to 1; 0: white; 1: black)
     *   X0     DATA16  column of the centre (0 to 177 px)
     *   Y0     DATA16  row of the centre (0 to 127 px)
     *   R      DATA16  radius (px; 0: draws nothing)
     */
    CIRCLE = 4,

    /*
     * Draws text in the font chosen by SELECT_FONT
     *   COLOR   DATA8   colour to draw in (0 to 1; 0: white; 1: black)
     *   X0      DATA16  left edge (0 to 177 px)
     *   Y0      DATA16  top edge (0 to 127 px)
     *   STRING  string  text to draw
     */
    TEXT = 5,

    /*
     * Draws one of the built-in icons
     *   COLOR  DATA8   colour to draw in (0 to 1; 0: white; 1: black)
     *   X0     DATA16  left edge (0 to 177 px)
     *   Y0     DATA16  top edge (0 to 127 px)
     *   TYPE   DATA8   set of icons (a member of ICONTYPE)
     *   NO     DATA8   number of the icon in its set
     */
    ICON = 6,

    /*
     * Draws a picture from memory
     *   COLOR  DATA8   colour to draw in (0 to 1; 0: white; 1: black)
     *   X0     DATA16  left edge (0 to 177 px)
     *   Y0     DATA16  top edge (0 to 127 px)
     *   IP     DATA32  address of the picture (0: draws nothing)
     */
    PICTURE = 7,

    /*
     * Draws a number, or dashes where it is not a number
     *   COLOR     DATA8   colour to draw in (0 to 1; 0: white; 1: black)
     *   X0        DATA16  left edge (0 to 177 px)
     *   Y0        DATA16  top edge (0 to 127 px)
     *   VALUE     DATAF   number to draw
     *   FIGURES   DATA8   total number of characters, including the decimal point; negative aligns left
     *   DECIMALS  DATA8   digits after the decimal point
     */
    VALUE = 8,

    /*
     * Draws a filled rectangle
     *   COLOR  DATA8   colour to draw in (0 to 1; 0: white; 1: black)
     *   X0     DATA16  left edge (0 to 177 px)
     *   Y0     DATA16  top edge (0 to 127 px)
     *   X1     DATA16  width (0 to 178 px)
     *   Y1     DATA16  height (0 to 128 px)
     */
    FILLRECT = 9,

    /*
     * Draws the outline of a rectangle (official firmware only)
     *   COLOR  DATA8   colour to draw in (0 to 1; 0: white; 1: black)
     *   X0     DATA16  left edge (0 to 177 px)
     *   Y0     DATA16  top edge (0 to 127 px)
     *   X1     DATA16  width (0 to 178 px)
     *   Y1     DATA16  height (0 to 128 px)
     */
    RECT = 10,

    /*
     * Draws the outline of a rectangle (xtended and compat firmware only)
     *   COLOR  DATA8   colour to draw in (0 to 1; 0: white; 1: black)
     *   X0     DATA16  left edge (0 to 177 px)
     *   Y0     DATA16  top edge (0 to 127 px)
     *   X1     DATA16  width (0 to 178 px)
     *   Y1     DATA16  height (0 to 128 px)
     */
    RECTANGLE = 10,

    /*
     * Shows icons and text in a window and waits for the centre button
     *   COLOR   DATA8         colour to draw in (0 to 1; 0: white; 1: black)
     *   X0      DATA16        left edge (0 to 177 px)
     *   Y0      DATA16        top edge (0 to 127 px)
     *   ICON1   DATA8         first large icon (-1: none; a member of L_ICON_NO)
     *   ICON2   DATA8         second large icon (-1: none; a member of L_ICON_NO)
     *   ICON3   DATA8         third large icon (-1: none; a member of L_ICON_NO)
     *   STRING  string        text beside the icons; may be empty
     *   STATE   in/out DATA8  variable for the dialogue's progress; must be 0 at first (0 to 1; 0: start, or done;
     *       1: being shown)
     */
    NOTIFICATION = 11,

    /*
     * Shows icons in a window and waits for yes or no
     *   COLOR   DATA8         colour to draw in (0 to 1; 0: white; 1: black)
     *   X0      DATA16        left edge (0 to 177 px)
     *   Y0      DATA16        top edge (0 to 127 px)
     *   ICON1   DATA8         first large icon (-1: none; a member of L_ICON_NO)
     *   ICON2   DATA8         second large icon (-1: none; a member of L_ICON_NO)
     *   STRING  string        text of the question (LEGO's firmware does not show it)
     *   STATE   in/out DATA8  variable for the dialogue's progress; must be 0 at first (0 to 1; 0: start, or done;
     *       1: being shown)
     *   OK      out DATA8     answer; the variable's previous value is selected at first (-1 to 1; 0: no; 1: yes;
     *       -1: closed with the back button)
     */
    QUESTION = 12,

    /*
     * Shows a keyboard on the display and waits until a text has been entered
     *   COLOR    DATA8         colour to draw in (0 to 1; 0: white; 1: black)
     *   X0       DATA16        left edge (0 to 177 px)
     *   Y0       DATA16        top edge (0 to 127 px)
     *   ICON     DATA8         normal icon before the caption (a member of N_ICON_NO)
     *   LENGTH   DATA8         maximum number of bytes to return, including the zero (0 to 127 bytes)
     *   DEFAULT  string        caption above the text, not a preset as its name says (0: none)
     *   CHARSET  in/out DATA8  variable with the sum of the allowed kinds of text; becomes 0 once the keyboard is
     *       shown
     *   STRING   out string    entered text; the variable's previous text is edited, the back button empties it (as
     *       many bytes as LENGTH says)
     */
    KEYBOARD = 13,

    /*
     * Shows files and folders and waits until one is chosen
     *   TYPE       DATA8       what to list (a member of BROWSERTYPE)
     *   X0         DATA16      left edge (0 to 177 px)
     *   Y0         DATA16      top edge (0 to 127 px)
     *   X1         DATA16      width (0 to 178 px)
     *   Y1         DATA16      height (0 to 128 px)
     *   LENGTH     DATA8       maximum number of bytes to return, including the zero (0 to 127 bytes)
     *   ITEM_TYPE  out DATA8   kind of the chosen entry; the variable must be 0 at first (a member of FILETYPE)
     *   STRING     out string  path of the chosen entry; set the variable to the top folder first (as many bytes as
     *       LENGTH says)
     */
    BROWSE = 14,

    /*
     * Draws a vertical scroll bar
     *   COLOR  DATA8   colour to draw in (0 to 1; 0: white; 1: black)
     *   X0     DATA16  left edge (0 to 177 px)
     *   Y0     DATA16  top edge (0 to 127 px)
     *   X1     DATA16  width (0 to 178 px)
     *   Y1     DATA16  height (0 to 128 px)
     *   MIN    DATA16  value at one end of the bar
     *   MAX    DATA16  value at the other end of the bar
     *   ACT    DATA16  value that the knob shows
     */
    VERTBAR = 15,

    /*
     * Swaps black and white in a rectangle
     *   X0  DATA16  left edge (0 to 177 px)
     *   Y0  DATA16  top edge (0 to 127 px)
     *   X1  DATA16  width (0 to 178 px)
     *   Y1  DATA16  height (0 to 128 px)
     */
    INVERSERECT = 16,

    /*
     * Chooses the font for text, until UPDATE, CLEAN or FILLWINDOW
     *   TYPE  DATA8  font (0 to 3; a member of FONTTYPE)
     */
    SELECT_FONT = 17,

    /*
     * Switches the status line at the top on or off
     *   ENABLE  DATA8  whether the status line is shown (0 to 1; 0: disabled; 1: enabled)
     */
    TOPLINE = 18,

    /*
     * Fills rows over the whole width, and restores the normal font
     *   COLOR  DATA8   colour to fill with; any other value makes a test pattern (0: white; 1: black)
     *   Y0     DATA16  top edge (0 to 127 px)
     *   Y1     DATA16  height; nothing is filled if Y0 plus it is 128 or more (0 to 127 px; 0: down to the bottom)
     */
    FILLWINDOW = 19,

    /*
     * Moves the canvas up
     *   Y  DATA16  distance (1 to 127 px)
     */
    SCROLL = 20,

    /*
     * Draws a dashed line between two points
     *   COLOR  DATA8   colour to draw in (0 to 1; 0: white; 1: black)
     *   X0     DATA16  column of the start (0 to 177 px)
     *   Y0     DATA16  row of the start (0 to 127 px)
     *   X1     DATA16  column of the end (0 to 178 px)
     *   Y1     DATA16  row of the end (0 to 128 px)
     *   ON     DATA16  length of a dash (px)
     *   OFF    DATA16  length of a gap (px)
     */
    DOTLINE = 21,

    /*
     * Draws a number centred in its place, or > instead of digits if it does not fit
     *   COLOR     DATA8   colour to draw in (0 to 1; 0: white; 1: black)
     *   X0        DATA16  left edge (0 to 177 px)
     *   Y0        DATA16  top edge (0 to 127 px)
     *   VALUE     DATAF   number to draw
     *   FIGURES   DATA8   total number of characters, including the decimal point
     *   DECIMALS  DATA8   digits after the decimal point
     */
    VIEW_VALUE = 22,

    /*
     * Draws a number in large figures and its unit in small letters
     *   COLOR     DATA8   colour to draw in (0 to 1; 0: white; 1: black)
     *   X0        DATA16  left edge (0 to 177 px)
     *   Y0        DATA16  top edge (0 to 127 px)
     *   VALUE     DATAF   number to draw
     *   FIGURES   DATA8   total number of characters, including the decimal point
     *   DECIMALS  DATA8   digits after the decimal point
     *   LENGTH    DATA8   maximum number of bytes of the unit, including the zero (0 to 127 bytes)
     *   STRING    string  unit to draw after the number
     */
    VIEW_UNIT = 23,

    /*
     * Draws a filled circle
     *   COLOR  DATA8   colour to draw in (0 to 1; 0: white; 1: black)
     *   X0     DATA16  column of the centre (0 to 177 px)
     *   Y0     DATA16  row of the centre (0 to 127 px)
     *   R      DATA16  radius (px; 0: draws nothing)
     */
    FILLCIRCLE = 24,

    /*
     * Keeps a copy of the canvas
     *   NO  DATA8  slot for one screen; 0 holds the screen from before the program ran (0 to 2)
     */
    STORE = 25,

    /*
     * Restores a canvas kept by STORE
     *   NO  DATA8  slot for one screen; 0 holds the screen from before the program ran (0 to 2)
     */
    RESTORE = 26,

    /*
     * Shows a row of icons and waits until one is chosen
     *   COLOR  DATA8          colour to draw in (0 to 1; 0: white; 1: black)
     *   X0     DATA16         left edge (0 to 177 px)
     *   Y0     DATA16         top edge (0 to 127 px)
     *   STATE  in/out DATA8   variable for the dialogue's progress; must be 0 at first (0 to 1; 0: start, or done;
     *       1: being shown)
     *   ICONS  in/out DATA32  bit n is large icon n: first the icons to show, then the chosen one (0: none: closed
     *       with the back button)
     */
    ICON_QUESTION = 27,

    /*
     * Draws a picture file in LEGO's own format .rgf (no .bmp despite the name)
     *   COLOR  DATA8   colour of the set pixels (0 to 1; 0: white, picture inverted; 1: black)
     *   X0     DATA16  left edge (0 to 177 px)
     *   Y0     DATA16  top edge (0 to 127 px)
     *   NAME   string  file with extension .rgf, absolute or relative to /home/root/lms2012/sys (at most 119
     *       characters)
     */
    BMPFILE = 28,

    /*
     * Opens a window that only its opener can draw on, or closes it and restores the display
     *   OPEN  DATA8  action (0 to 1; 0: close; 1: open)
     */
    POPUP = 29,

    /*
     * Sets up a graph of up to 8 curves; useless in direct commands, since the arrays must outlive it
     *   X0      DATA16  left edge (0 to 177 px)
     *   X1      DATA16  width (0 to 178 px)
     *   ITEMS   DATA8   number of curves (0 to 8)
     *   OFFSET  DATA16  top edge of each curve (0 to 127 px; as many values as ITEMS says)
     *   SPAN    DATA16  height of each curve (0 to 128 px; as many values as ITEMS says)
     *   MIN     DATAF   value at the bottom of each curve (as many values as ITEMS says)
     *   MAX     DATAF   value at the top of each curve (as many values as ITEMS says)
     *   SAMPLE  DATAF   current value of each curve, read again at each GRAPH_SAMPLE (as many values as ITEMS says)
     */
    GRAPH_SETUP = 30,

    /*
     * Draws the graph and measures the curve it shows
     *   VIEW     DATA8      curve to draw, counted from 0; any other value draws all and measures none (-1: all)
     *   ACTUAL   out DATAF  latest value, NaN if there is none
     *   LOWEST   out DATAF  lowest value in the graph
     *   HIGHEST  out DATAF  highest value in the graph
     *   AVERAGE  out DATAF  mean of the values in the graph
     */
    GRAPH_DRAW = 31,

    /*
     * Shows a text with a scroll bar and waits until a line is chosen
     *   X0    DATA16         left edge (0 to 177 px)
     *   Y0    DATA16         top edge (0 to 127 px)
     *   X1    DATA16         width (0 to 178 px)
     *   Y1    DATA16         height (0 to 128 px)
     *   TEXT  string         whole text of the box, its lines separated by DEL
     *   SIZE  DATA32         size of the box's text buffer, including the zero (bytes)
     *   DEL   DATA8          what separates the lines (a member of DEL)
     *   LINE  in/out DATA16  variable, must be -1 at first; then the chosen line, counted from 1 (-1: start, or
     *       closed with the back button; 0: being shown)
     */
    TEXTBOX = 32,
};

/* Timers ----------------------------------------------------------------------------------------------------------- */

enum {
    /*
     * Stores the end of a wait and returns at once; TIMER_READY does the waiting
     *   TIME   DATA32      duration of the wait (0 to 2147483647 ms)
     *   TIMER  out DATA32  variable that gets the end of the wait, on the brick's millisecond clock
     */
    opTIMER_WAIT = 0x85,

    /*
     * Waits until the time that TIMER_WAIT stored
     *   TIMER  DATA32  variable that TIMER_WAIT has set
     */
    opTIMER_READY = 0x86,

    /*
     * Reads the time since the start of the program or direct command that asks
     *   TIME  out DATA32  time since the start (ms)
     */
    opTIMER_READ = 0x87,

    /*
     * Reads the free-running microsecond clock, for differences only
     *   TIME  out DATA32  low 32 bits of the clock, wraps every 71.6 minutes (us)
     */
    opTIMER_READ_US = 0x8F,
};

/* Sound ------------------------------------------------------------------------------------------------------------ */

enum {
    /* Plays or stops a sound: a CMD follows, below */
    opSOUND = 0x94,

    /*
     * Reports whether a sound is playing
     *   BUSY  out DATA8  whether a sound is playing (0 to 1; 0: ready; 1: busy)
     */
    opSOUND_TEST = 0x95,

    /* Waits until the sound has ended (forever after REPEAT, an endless tone or a missing file) */
    opSOUND_READY = 0x96,
};

/* CMDs of opSOUND */
enum {
    /* Stops the tone or file that is playing */
    BREAK = 0,

    /*
     * Plays one tone and returns at once
     *   VOLUME     DATA8   volume (0 to 100 %; 0: silent)
     *   FREQUENCY  DATA16  pitch; the driver clamps it to the range (250 to 10000 Hz)
     *   DURATION   DATA16  duration, read unsigned (-1 is 65535) (ms; 0: until BREAK or the next sound)
     */
    TONE = 1,

    /*
     * Plays a sound file once and returns at once
     *   VOLUME  DATA8   volume (0 to 100 %; 0: silent)
     *   NAME    string  sound file without its extension .rsf, absolute or relative to /home/root/lms2012/sys (at
     *       most 119 characters)
     */
    PLAY = 2,

    /*
     * Plays a sound file over and over until BREAK and returns at once
     *   VOLUME  DATA8   volume (0 to 100 %; 0: silent)
     *   NAME    string  sound file without its extension .rsf, absolute or relative to /home/root/lms2012/sys (at
     *       most 119 characters)
     */
    REPEAT = 3,

    /* Does nothing; the number is used inside the firmware to feed the sound driver */
    SERVICE = 4,
};

/* Sensors ---------------------------------------------------------------------------------------------------------- */

enum {
    /*
     * Reads one SI value of each of several devices, sampled in the background
     *   TIME      DATA32     time between two samples (ms)
     *   SAMPLES   DATA16     number of devices the arrays list
     *   INIT      DATA16     place in the sample buffer of each device, -1 starts it anew (as many values as SAMPLES
     *       says)
     *   DEVICES   DATA8      ports, 0 to 3 for sensors, 4 to 7 for motors A to D (as many values as SAMPLES says)
     *   TYPES     DATA8      type to set for each device (a member of TYPE; as many values as SAMPLES says)
     *   MODES     DATA8      mode to set for each device (as many values as SAMPLES says)
     *   DATASETS  DATA8      index of the value to read from each device, from 0 (as many values as SAMPLES says)
     *   VALUES    out DATAF  one value per device, NaN if there is none (as many values as SAMPLES says)
     */
    opINPUT_SAMPLE = 0x97,

    /*
     * Lists the types of all devices, sensor ports of each layer first, then motor ports
     *   LENGTH   DATA8      size of the array; 32 holds the whole daisy chain (0 to 127)
     *   ARRAY    out DATA8  type of device at each port (a member of TYPE; as many values as LENGTH says)
     *   CHANGED  out DATA8  whether devices came or went since the last call (0: no change)
     */
    opINPUT_DEVICE_LIST = 0x98,

    /* Asks about devices, calibrates them, reads several values: a CMD follows, below */
    opINPUT_DEVICE = 0x99,

    /*
     * Sets type and mode and reads the first value in percent at once
     *   LAYER  DATA8      brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO     DATA8      port, counted from 0; 16 to 19 for motors (0 to 19)
     *   TYPE   DATA8      type to set (0: keep the type; a member of TYPE)
     *   MODE   DATA8      mode to set (0 to 7; -1: keep the mode)
     *   PCT    out DATA8  value, NaN if there is none (%)
     */
    opINPUT_READ = 0x9A,

    /*
     * Reports whether a device is still changing type or mode
     *   LAYER  DATA8      brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO     DATA8      port, counted from 0; 16 to 19 for motors (0 to 19)
     *   BUSY   out DATA8  whether to wait (0 to 1; 0: ready; 1: busy)
     */
    opINPUT_TEST = 0x9B,

    /*
     * Waits until a device has valid values
     *   LAYER  DATA8  brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO     DATA8  port, counted from 0; 16 to 19 for motors (0 to 19)
     */
    opINPUT_READY = 0x9C,

    /*
     * Sets type and mode and reads the first value in SI units at once
     *   LAYER  DATA8      brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO     DATA8      port, counted from 0; 16 to 19 for motors (0 to 19)
     *   TYPE   DATA8      type to set (0: keep the type; a member of TYPE)
     *   MODE   DATA8      mode to set (0 to 7; -1: keep the mode)
     *   SI     out DATAF  value in the mode's unit, NaN if there is none
     */
    opINPUT_READSI = 0x9D,

    /*
     * Sets type and mode and reads several values at once, in the format asked for
     *   LAYER   DATA8  brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO      DATA8  port, counted from 0; 16 to 19 for motors (0 to 19)
     *   TYPE    DATA8  type to set (0: keep the type; a member of TYPE)
     *   MODE    DATA8  mode to set (0 to 7; -1: keep the mode)
     *   FORMAT  DATA8  DATA_PCT, DATA_RAW or DATA_SI; others give NaN (a member of DATA_FORMAT)
     *   VALUES  count  number of values that follow, each in FORMAT (each is what FORMAT says)
     */
    opINPUT_READEXT = 0x9E,

    /*
     * Sends bytes to a UART sensor
     *   LAYER  DATA8  brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO     DATA8  sensor port, counted from 0 (0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4)
     *   BYTES  DATA8  number of bytes to send (1 to 32 bytes)
     *   DATA   DATA8  bytes to send (as many values as BYTES says)
     */
    opINPUT_WRITE = 0x9F,

    /*
     * Sets how a port is connected, for ports whose automatic detection is off (xtended and compat firmware only)
     *   LAYER  DATA8  brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO     DATA8  sensor port, counted from 0 (0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4)
     *   CONN   DATA8  CONN_NXT_IIC, CONN_NXT_DUMB, CONN_INPUT_DUMB or CONN_NONE (a member of CONN)
     */
    opINPUT_SET_CONN = 0xE0,

    /*
     * Fetches the bytes that an I2C sensor answered to INPUT_IIC_WRITE (xtended and compat firmware only)
     *   LAYER   DATA8      brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO      DATA8      sensor port, counted from 0 (0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4)
     *   RDLNG   DATA8      number of bytes to read (0 to 32 bytes)
     *   RDDATA  out DATA8  bytes read (as many values as RDLNG says)
     *   RESULT  out DATA8  OK or FAIL (a member of RESULT)
     */
    opINPUT_IIC_READ = 0xE1,

    /*
     * Reports the state of the I2C bus of a port (xtended and compat firmware only)
     *   LAYER   DATA8      brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO      DATA8      sensor port, counted from 0 (0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4)
     *   RESULT  out DATA8  state of the bus (a member of RESULT)
     */
    opINPUT_IIC_STATUS = 0xE2,

    /*
     * Sends bytes to an I2C sensor once, without waiting for its answer (xtended and compat firmware only)
     *   LAYER   DATA8      brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO      DATA8      sensor port, counted from 0 (0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4)
     *   WRLNG   DATA8      number of bytes to write (0 to 32 bytes)
     *   WRDATA  DATA8      bytes to write: I2C address, register, data (as many values as WRLNG says)
     *   RDLNG   DATA8      number of bytes in the sensor's answer (0 to 32 bytes)
     *   RESULT  out DATA8  state of the bus after the request (a member of RESULT)
     */
    opINPUT_IIC_WRITE = 0xE3,

    /*
     * Switches the automatic detection of sensors at a port on or off (xtended and compat firmware only)
     *   LAYER   DATA8  brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO      DATA8  sensor port, counted from 0 (0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4)
     *   ENABLE  DATA8  whether to detect (0 to 1; 0: off; 1: on)
     */
    opINPUT_SET_AUTOID = 0xE4,
};

/* CMDs of opINPUT_DEVICE */
enum {
    /*
     * Adds a line to the table of device types, for third party types (50 to 98) only
     *   TYPEDATA  string     the line as in typedata.rcf, starting with the type's number
     *   FORCE     DATA8      whether to replace a known type (0 to 1; 0: refuse a known type; 1: replace a known
     *       type)
     *   ERROR     out DATA8  whether it failed (0 to 1; 0: done; 1: failed or known)
     */
    INSERT_TYPE = 1,

    /*
     * Describes the values of a device in its current mode
     *   LAYER     DATA8      brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO        DATA8      port, counted from 0; 16 to 19 for motors (0 to 19)
     *   DATASETS  out DATA8  number of values in one reading
     *   FORMAT    out DATA8  type of one raw value (0 to 3; a member of DATA_FORMAT)
     *   MODES     out DATA8  number of modes of the device (1 to 8)
     *   VIEWS     out DATA8  number of modes shown to users (1 to 8)
     */
    GET_FORMAT = 2,

    /*
     * Sets the raw values that scale a type and mode to percent and SI
     *   TYPE     DATA8   type of device the calibration is for (a member of TYPE)
     *   MODE     DATA8   mode the calibration is for (0 to 7)
     *   CAL_MIN  DATA32  raw value at the lower end
     *   CAL_MAX  DATA32  raw value at full scale
     */
    CAL_MINMAX = 3,

    /*
     * Restores the built-in scaling of a type and mode
     *   TYPE  DATA8  type of device the calibration is for (a member of TYPE)
     *   MODE  DATA8  mode the calibration is for (0 to 7)
     */
    CAL_DEFAULT = 4,

    /*
     * Reports the device at a port and its mode
     *   LAYER  DATA8      brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO     DATA8      port, counted from 0; 16 to 19 for motors (0 to 19)
     *   TYPE   out DATA8  type of the device (a member of TYPE)
     *   MODE   out DATA8  mode the device is in (0 to 7)
     */
    GET_TYPEMODE = 5,

    /*
     * Reads the symbol of the unit of the current mode
     *   LAYER        DATA8       brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO           DATA8       port, counted from 0; 16 to 19 for motors (0 to 19)
     *   LENGTH       DATA8       size of the text buffer, including the zero (bytes; -1: unlimited (handles only))
     *   DESTINATION  out string  symbol, padded with blanks (as many bytes as LENGTH says)
     */
    GET_SYMBOL = 6,

    /*
     * Sets the lower end of the scaling of a type and mode
     *   TYPE     DATA8   type of device the calibration is for (a member of TYPE)
     *   MODE     DATA8   mode the calibration is for (0 to 7)
     *   CAL_MIN  DATA32  value at the lower end, in SI units once calibrated
     */
    CAL_MIN = 7,

    /*
     * Sets the full scale of a type and mode
     *   TYPE     DATA8   type of device the calibration is for (a member of TYPE)
     *   MODE     DATA8   mode the calibration is for (0 to 7)
     *   CAL_MAX  DATA32  value at full scale, in SI units once calibrated
     */
    CAL_MAX = 8,

    /*
     * Writes to an I2C sensor and reads its answer, repeatedly if requested
     *   LAYER       DATA8      brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO          DATA8      sensor port, counted from 0 (0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4)
     *   REPEAT      DATA8      number of repeats (0: endless)
     *   TIME        DATA16     time between repeats (10 to 1000 ms; 0: 10 ms)
     *   WRITE_LEN   DATA8      number of bytes to write (0 to 32 bytes)
     *   WRITE_DATA  DATA8      bytes to write: I2C address, register, data (as many values as WRITE_LEN says)
     *   READ_LEN    DATA8      number of bytes to read, negative: in reverse order (-32 to 32 bytes)
     *   READ_DATA   out DATA8  bytes read (as many values as READ_LEN says)
     */
    SETUP = 9,

    /*
     * Clears counters and angles of all devices
     *   LAYER  DATA8  brick in the daisy chain (0 to 3; -1: all layers)
     */
    CLR_ALL = 10,

    /*
     * Reads the first raw value of a device
     *   LAYER  DATA8       brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO     DATA8       port, counted from 0; 16 to 19 for motors (0 to 19)
     *   VALUE  out DATA32  raw value, NaN if there is none
     */
    GET_RAW = 11,

    /*
     * Reports how the device at a port is connected
     *   LAYER  DATA8      brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO     DATA8      port, counted from 0; 16 to 19 for motors (0 to 19)
     *   CONN   out DATA8  kind of connection (a member of CONN)
     */
    GET_CONNECTION = 12,

    /*
     * Stops all devices, motors among them
     *   LAYER  DATA8  brick in the daisy chain (0 to 3; -1: all layers)
     */
    STOP_ALL = 13,

    /*
     * Renumbers an entry of the table of device types, third party types only
     *   TYPE     DATA8      type of the entry (50 to 98; a member of TYPE)
     *   MODE     DATA8      mode of the entry (0 to 7)
     *   NEWTYPE  DATA8      new type of the entry (50 to 98; a member of TYPE)
     *   NEWMODE  DATA8      new mode of the entry (0 to 7)
     *   ERROR    out DATA8  whether it failed (0 to 1; 0: done; 1: failed or not found)
     */
    SET_TYPEMODE = 14,

    /*
     * Writes to an I2C sensor once, waits for its answer and reports the result
     *   LAYER   DATA8      brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO      DATA8      sensor port, counted from 0 (0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4)
     *   WRLNG   DATA8      number of bytes to write (0 to 32 bytes)
     *   WRDATA  DATA8      bytes to write: I2C address, register, data (as many values as WRLNG says)
     *   RDLNG   DATA8      number of bytes to read, negative: in reverse order (-32 to 32 bytes)
     *   RDDATA  out DATA8  bytes read (as many values as RDLNG says)
     *   RESULT  out DATA8  how the transfer ended (a member of RESULT)
     */
    READY_IIC = 15,

    /*
     * Reads the name of a device in its current mode, such as TOUCH or COL-REFLECT
     *   LAYER        DATA8       brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO           DATA8       port, counted from 0; 16 to 19 for motors (0 to 19)
     *   LENGTH       DATA8       size of the text buffer, including the zero (bytes; -1: unlimited (handles only))
     *   DESTINATION  out string  name, padded with blanks (as many bytes as LENGTH says)
     */
    GET_NAME = 21,

    /*
     * Reads the name of any mode of a device
     *   LAYER        DATA8       brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO           DATA8       port, counted from 0; 16 to 19 for motors (0 to 19)
     *   MODE         DATA8       mode to name (0 to 7)
     *   LENGTH       DATA8       size of the text buffer, including the zero (bytes; -1: unlimited (handles only))
     *   DESTINATION  out string  name, padded with blanks (as many bytes as LENGTH says)
     */
    GET_MODENAME = 22,

    /*
     * Simulates a raw value of a device
     *   LAYER  DATA8   brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO     DATA8   port, counted from 0; 16 to 19 for motors (0 to 19)
     *   TYPE   DATA8   type to set (0: keep the type; a member of TYPE)
     *   VALUE  DATA32  raw value to simulate
     */
    SET_RAW = 23,

    /*
     * Reports the number of digits that a value of the current mode needs
     *   LAYER     DATA8      brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO        DATA8      port, counted from 0; 16 to 19 for motors (0 to 19)
     *   FIGURES   out DATA8  total number of characters, with point and decimals
     *   DECIMALS  out DATA8  digits after the point
     */
    GET_FIGURES = 24,

    /*
     * Reads how often a touch sensor changed to pressed since CLR_CHANGES
     *   LAYER  DATA8      brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO     DATA8      port, counted from 0; 16 to 19 for motors (0 to 19)
     *   VALUE  out DATAF  number of changes, 0 for other sensors
     */
    GET_CHANGES = 25,

    /*
     * Sets the counts of GET_CHANGES and GET_BUMPS to zero
     *   LAYER  DATA8  brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO     DATA8  port, counted from 0; 16 to 19 for motors (0 to 19)
     */
    CLR_CHANGES = 26,

    /*
     * Sets type and mode, waits until the device is ready and reads percent values
     *   LAYER   DATA8  brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO      DATA8  port, counted from 0; 16 to 19 for motors (0 to 19)
     *   TYPE    DATA8  type to set (0: keep the type; a member of TYPE)
     *   MODE    DATA8  mode to set (0 to 7; -1: keep the mode)
     *   VALUES  count  number of values that follow, each in percent (each is DATA8)
     */
    READY_PCT = 27,

    /*
     * Sets type and mode, waits until the device is ready and reads raw values
     *   LAYER   DATA8  brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO      DATA8  port, counted from 0; 16 to 19 for motors (0 to 19)
     *   TYPE    DATA8  type to set (0: keep the type; a member of TYPE)
     *   MODE    DATA8  mode to set (0 to 7; -1: keep the mode)
     *   VALUES  count  number of raw values that follow (each is DATA32)
     */
    READY_RAW = 28,

    /*
     * Sets type and mode, waits until the device is ready and reads SI values
     *   LAYER   DATA8  brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO      DATA8  port, counted from 0; 16 to 19 for motors (0 to 19)
     *   TYPE    DATA8  type to set (0: keep the type; a member of TYPE)
     *   MODE    DATA8  mode to set (0 to 7; -1: keep the mode)
     *   VALUES  count  number of values that follow, each in SI units (each is DATAF)
     */
    READY_SI = 29,

    /*
     * Reports the range of SI values of the current mode
     *   LAYER  DATA8      brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO     DATA8      port, counted from 0; 16 to 19 for motors (0 to 19)
     *   MIN    out DATAF  smallest value in SI units
     *   MAX    out DATAF  largest value in SI units
     */
    GET_MINMAX = 30,

    /*
     * Reads how often a touch sensor changed to released since CLR_CHANGES
     *   LAYER  DATA8      brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO     DATA8      port, counted from 0; 16 to 19 for motors (0 to 19)
     *   VALUE  out DATAF  number of changes, 0 for other sensors
     */
    GET_BUMPS = 31,
};

/* Motors ----------------------------------------------------------------------------------------------------------- */

enum {
    /*
     * Reports the type of motor at a port; documented, but not implemented by any firmware (not in any firmware)
     *   LAYER  DATA8      brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO     DATA8      port, counted from 0 (0 to 3; 0: A; 1: B; 2: C; 3: D)
     *   TYPE   out DATA8  type of the motor (a member of TYPE)
     */
    opOUTPUT_GET_TYPE = 0xA0,

    /*
     * Declares which type of motor is at a port
     *   LAYER  DATA8  brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO     DATA8  port, counted from 0 (0 to 3; 0: A; 1: B; 2: C; 3: D)
     *   TYPE   DATA8  type of the motor (a member of TYPE)
     */
    opOUTPUT_SET_TYPE = 0xA1,

    /*
     * Sets the tacho counts that moves and OUTPUT_READ use to zero
     *   LAYER  DATA8  brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NOS    DATA8  ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
     */
    opOUTPUT_RESET = 0xA2,

    /*
     * Stops motors
     *   LAYER  DATA8  brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NOS    DATA8  ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
     *   BRAKE  DATA8  what the motors do at the end (0 to 1; 0: coast; 1: brake and hold)
     */
    opOUTPUT_STOP = 0xA3,

    /*
     * Sets the power of motors, which run at the next OUTPUT_START
     *   LAYER  DATA8  brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NOS    DATA8  ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
     *   POWER  DATA8  unregulated power; negative: backward (-100 to 100 %)
     */
    opOUTPUT_POWER = 0xA4,

    /*
     * Sets the speed of motors, which run at the next OUTPUT_START
     *   LAYER  DATA8  brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NOS    DATA8  ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
     *   SPEED  DATA8  regulated speed; negative: backward (-100 to 100 %)
     */
    opOUTPUT_SPEED = 0xA5,

    /*
     * Starts motors with the power or speed set before
     *   LAYER  DATA8  brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NOS    DATA8  ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
     */
    opOUTPUT_START = 0xA6,

    /*
     * Sets the direction of motors
     *   LAYER  DATA8  brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NOS    DATA8  ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
     *   POL    DATA8  direction (-1 to 1; -1: backward; 0: opposite of the current one; 1: forward)
     */
    opOUTPUT_POLARITY = 0xA7,

    /*
     * Reads speed and tacho count of one motor, 0 on layers other than 0
     *   LAYER  DATA8       brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NO     DATA8       port, counted from 0 (0 to 3; 0: A; 1: B; 2: C; 3: D)
     *   SPEED  out DATA8   current speed (-100 to 100 %)
     *   TACHO  out DATA32  angle in the current phase of a move; about 0 after one that brakes (degrees)
     */
    opOUTPUT_READ = 0xA8,

    /*
     * Reports whether one of the motors is still in a move that ends by itself
     *   LAYER  DATA8      brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NOS    DATA8      ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
     *   BUSY   out DATA8  whether to wait (0 to 1; 0: ready; 1: busy)
     */
    opOUTPUT_TEST = 0xA9,

    /*
     * Waits until the moves of the motors have ended; ignores those from OUTPUT_START
     *   LAYER  DATA8  brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NOS    DATA8  ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
     */
    opOUTPUT_READY = 0xAA,

    /*
     * Reports the position of motors; documented, but not implemented by any firmware (not in any firmware)
     *   LAYER  DATA8       brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NOS    DATA8       ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
     *   POS    out DATA32  position (degrees)
     */
    opOUTPUT_POSITION = 0xAB,

    /*
     * Turns motors by an angle with unregulated power
     *   LAYER  DATA8   brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NOS    DATA8   ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
     *   POWER  DATA8   unregulated power; negative: backward (-100 to 100 %)
     *   STEP1  DATA32  angle of the ramp up (0 to 2147483647 degrees)
     *   STEP2  DATA32  angle at constant drive (0 to 2147483647 degrees)
     *   STEP3  DATA32  angle of the ramp down (0 to 2147483647 degrees)
     *   BRAKE  DATA8   what the motors do at the end (0 to 1; 0: coast; 1: brake and hold)
     */
    opOUTPUT_STEP_POWER = 0xAC,

    /*
     * Runs motors for a time with unregulated power
     *   LAYER  DATA8   brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NOS    DATA8   ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
     *   POWER  DATA8   unregulated power; negative: backward (-100 to 100 %)
     *   TIME1  DATA32  time of the ramp up (0 to 2147483647 ms)
     *   TIME2  DATA32  time at constant drive (0 to 2147483647 ms)
     *   TIME3  DATA32  time of the ramp down (0 to 2147483647 ms)
     *   BRAKE  DATA8   what the motors do at the end (0 to 1; 0: coast; 1: brake and hold)
     */
    opOUTPUT_TIME_POWER = 0xAD,

    /*
     * Turns motors by an angle with regulated speed
     *   LAYER  DATA8   brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NOS    DATA8   ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
     *   SPEED  DATA8   regulated speed; negative: backward (-100 to 100 %)
     *   STEP1  DATA32  angle of the ramp up (0 to 2147483647 degrees)
     *   STEP2  DATA32  angle at constant drive (0 to 2147483647 degrees)
     *   STEP3  DATA32  angle of the ramp down (0 to 2147483647 degrees)
     *   BRAKE  DATA8   what the motors do at the end (0 to 1; 0: coast; 1: brake and hold)
     */
    opOUTPUT_STEP_SPEED = 0xAE,

    /*
     * Runs motors for a time with regulated speed
     *   LAYER  DATA8   brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NOS    DATA8   ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
     *   SPEED  DATA8   regulated speed; negative: backward (-100 to 100 %)
     *   TIME1  DATA32  time of the ramp up (0 to 2147483647 ms)
     *   TIME2  DATA32  time at constant drive (0 to 2147483647 ms)
     *   TIME3  DATA32  time of the ramp down (0 to 2147483647 ms)
     *   BRAKE  DATA8   what the motors do at the end (0 to 1; 0: coast; 1: brake and hold)
     */
    opOUTPUT_TIME_SPEED = 0xAF,

    /*
     * Turns two motors in step by an angle
     *   LAYER  DATA8   brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NOS    DATA8   ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
     *   SPEED  DATA8   regulated speed; negative: backward (-100 to 100 %)
     *   TURN   DATA16  how tight the turn is, positive slows the higher port, negative the lower (-200 to 200; -200:
     *       spin, lower port runs backward; -100: lower port stands still; 0: straight; 100: higher port stands
     *       still; 200: spin, higher port runs backward)
     *   STEP   DATA32  angle of the faster motor (0 to 2147483647 degrees; 0: endless)
     *   BRAKE  DATA8   what the motors do at the end (0 to 1; 0: coast; 1: brake and hold)
     */
    opOUTPUT_STEP_SYNC = 0xB0,

    /*
     * Runs two motors in step for a time
     *   LAYER  DATA8   brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NOS    DATA8   ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
     *   SPEED  DATA8   regulated speed; negative: backward (-100 to 100 %)
     *   TURN   DATA16  how tight the turn is, positive slows the higher port, negative the lower (-200 to 200; -200:
     *       spin, lower port runs backward; -100: lower port stands still; 0: straight; 100: higher port stands
     *       still; 200: spin, higher port runs backward)
     *   TIME   DATA32  how long to run (0 to 2147483647 ms; 0: endless)
     *   BRAKE  DATA8   what the motors do at the end (0 to 1; 0: coast; 1: brake and hold)
     */
    opOUTPUT_TIME_SYNC = 0xB1,

    /*
     * Sets the tacho counts of motors read as sensors to zero
     *   LAYER  DATA8  brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NOS    DATA8  ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)
     */
    opOUTPUT_CLR_COUNT = 0xB2,

    /*
     * Reads the tacho count of a motor read as a sensor
     *   LAYER  DATA8       brick in the daisy chain, 0 is the one addressed (0 to 3)
     *   NOS    DATA8       port, counted from 0 (0 to 3; 0: A; 1: B; 2: C; 3: D)
     *   TACHO  out DATA32  angle since OUTPUT_CLR_COUNT (degrees)
     */
    opOUTPUT_GET_COUNT = 0xB3,

    /* Stops and resets all motors as the end of a program does */
    opOUTPUT_PRG_STOP = 0xB4,
};

/* Files and arrays ------------------------------------------------------------------------------------------------- */

enum {
    /*
     * Writes bytes into the variables of a running program
     *   PRGID   DATA16  slot of the program, which must be running (0 to 4; a member of SLOT)
     *   OBJID   DATA16  object whose local memory is meant (0: the program's global memory)
     *   OFFSET  DATA32  first byte in that memory (0 to 2147483647 bytes)
     *   SIZE    DATA32  number of bytes (0 to 2147483647 bytes)
     *   ARRAY   DATA8   the bytes; those beyond the end of the memory are dropped (as many values as SIZE says)
     */
    opMEMORY_WRITE = 0x7E,

    /*
     * Reads bytes from the variables of a running program
     *   PRGID   DATA16     slot of the program, which must be running (0 to 4; a member of SLOT)
     *   OBJID   DATA16     object whose local memory is meant (0: the program's global memory)
     *   OFFSET  DATA32     first byte in that memory (0 to 2147483647 bytes)
     *   SIZE    DATA32     number of bytes (0 to 2147483647 bytes)
     *   ARRAY   out DATA8  the bytes, zeros beyond the end of the memory (as many values as SIZE says)
     */
    opMEMORY_READ = 0x7F,

    /* Works on files, folders, data logs, program images and the list of recent files: a CMD follows, below */
    opFILE = 0xC0,

    /* Creates, fills, copies and resizes arrays: a CMD follows, below */
    opARRAY = 0xC1,

    /*
     * Writes one element of an array, which grows where needed
     *   HANDLE  handle       the array
     *   INDEX   DATA32       which element, the first is 0 (0 to 5999999)
     *   VALUE   array-typed  the value, of the array's type
     */
    opARRAY_WRITE = 0xC2,

    /*
     * Reads one element of an array
     *   HANDLE  handle           the array
     *   INDEX   DATA32           which element, the first is 0 (0 to 5999999)
     *   VALUE   out array-typed  the value, of the array's type
     */
    opARRAY_READ = 0xC3,

    /*
     * Adds one element to the end of an array
     *   HANDLE  handle       the array
     *   VALUE   array-typed  the value, of the array's type
     */
    opARRAY_APPEND = 0xC4,

    /*
     * Reports the total and free memory for user files
     *   TOTAL  out DATA32  total memory (KiB)
     *   FREE   out DATA32  free memory (KiB)
     */
    opMEMORY_USAGE = 0xC5,

    /* Splits and checks file names, and packs files: a CMD follows, below */
    opFILENAME = 0xC6,

    /*
     * Computes the MD5 digest of a file (xtended and compat firmware only)
     *   NAME     string     path of the file
     *   MD5SUM   out DATA8  the digest, as 16 bytes (16 values)
     *   SUCCESS  out DATA8  whether the file could be read (0: no; 1: yes)
     */
    opFILE_MD5SUM = 0xE6,
};

/* CMDs of opFILE */
enum {
    /*
     * Opens a file for appending; creates it if it does not exist
     *   NAME    string      path of the file; a bare name is taken from the program's own folder (at most 119
     *       characters)
     *   HANDLE  out handle  handle of the opened file
     */
    OPEN_APPEND = 0,

    /*
     * Opens a file for reading
     *   NAME    string      path of the file; a bare name is taken from the program's own folder (at most 119
     *       characters)
     *   HANDLE  out handle  handle of the opened file
     *   SIZE    out DATA32  size of the file (bytes; 0: not found)
     */
    OPEN_READ = 1,

    /*
     * Creates or truncates a file and opens it for writing
     *   NAME    string      path of the file; a bare name is taken from the program's own folder (at most 119
     *       characters)
     *   HANDLE  out handle  handle of the opened file
     */
    OPEN_WRITE = 2,

    /*
     * Reads the text up to the next delimiter and turns it into a number
     *   HANDLE  handle     the open file
     *   DEL     DATA8      separator between two values in the file (a member of DEL)
     *   VALUE   out DATAF  the number, 0 if the text is not a number
     */
    READ_VALUE = 3,

    /*
     * Writes a number as text, and a delimiter after it
     *   HANDLE    handle  the open file
     *   DEL       DATA8   separator between two values in the file (a member of DEL)
     *   VALUE     DATAF   the number
     *   FIGURES   DATA8   minimum width in characters, including the decimal point
     *   DECIMALS  DATA8   digits after the decimal point
     */
    WRITE_VALUE = 4,

    /*
     * Reads text up to the next delimiter
     *   HANDLE  handle      the open file
     *   DEL     DATA8       separator between two values in the file (a member of DEL)
     *   LENGTH  DATA16      maximum number of bytes to read; LEGO's firmware keeps the low 8 bits, so 127 (bytes)
     *   TEXT    out string  the text, without a zero at its end if it fills the whole buffer (as many bytes as
     *       LENGTH says)
     */
    READ_TEXT = 5,

    /*
     * Writes text without its zero, and a delimiter after it
     *   HANDLE  handle  the open file
     *   DEL     DATA8   separator between two values in the file (a member of DEL)
     *   TEXT    string  the text
     */
    WRITE_TEXT = 6,

    /*
     * Closes a file and frees its handle
     *   HANDLE  handle  the open file
     */
    CLOSE = 7,

    /*
     * Loads a program file into a stopped slot, for PROGRAM_START to run
     *   PRGID  DATA16      slot to load it into (0 to 4; a member of SLOT)
     *   NAME   string      path of the program, relative to /home/root/lms2012/sys; .rbf may be omitted (at most 119
     *       characters)
     *   SIZE   out DATA32  size of the program (bytes; 0: not loaded)
     *   IP     out DATA32  where it was loaded, for PROGRAM_START (0: not loaded)
     */
    LOAD_IMAGE = 8,

    /*
     * Finds the handle of a file that is already open
     *   NAME    string      path of the file; a bare name is taken from the program's own folder (at most 119
     *       characters)
     *   HANDLE  out handle  the open file (-1: not open)
     *   WRITE   out DATA8   whether it is open for writing or appending (0: no; 1: yes)
     */
    GET_HANDLE = 9,

    /*
     * Creates a folder unless it exists
     *   NAME     string     path of the folder, relative to /home/root/lms2012/sys (at most 119 characters)
     *   SUCCESS  out DATA8  whether the folder exists now (0: no; 1: yes)
     */
    MAKE_FOLDER = 10,

    /*
     * Reserves a block of memory for the program
     *   SIZE    DATA32      how much memory (1 to 6000000 bytes)
     *   HANDLE  out handle  handle of the block
     *   IP      out DATA32  address of the block
     */
    GET_POOL = 11,

    /*
     * Stores the time and tick to which data logs are aligned
     *   TIME  DATA32  the common time
     *   TICK  DATA32  the brick's tick at that time
     */
    SET_LOG_SYNC_TIME = 12,

    /*
     * Counts the entries of a folder, without hidden ones
     *   NAME   string     path of the folder with its closing slash, such as ../prjs/ (at most 119 characters)
     *   ITEMS  out DATA8  number of entries
     */
    GET_FOLDERS = 13,

    /*
     * Reads the time and tick to which data logs are aligned
     *   TIME  out DATA32  the common time
     *   TICK  out DATA32  the brick's tick at that time
     */
    GET_LOG_SYNC_TIME = 14,

    /*
     * Reads the name of one entry of a folder
     *   NAME    string      path of the folder with its closing slash, such as ../prjs/ (at most 119 characters)
     *   ITEM    DATA8       which entry of the folder, the first is 1 (1 to 127)
     *   LENGTH  DATA8       size of the string's buffer, including the zero (bytes)
     *   STRING  out string  its name without extension, empty if there is no such entry (as many bytes as LENGTH
     *       says)
     */
    GET_SUBFOLDER_NAME = 15,

    /*
     * Adds one row of samples to a data log
     *   HANDLE  handle  the open data log
     *   TIME    DATA32  time of the samples since the log began (ms)
     *   ITEMS   DATA8   number of samples; with 0 nothing is written (0 to 127)
     *   VALUES  DATAF   the samples, in one array (as many values as ITEMS says)
     */
    WRITE_LOG = 16,

    /*
     * Writes the rest of a data log and closes it
     *   HANDLE  handle  the open data log
     *   NAME    string  path of the log as given to OPEN_LOG; .rdf may be omitted
     */
    CLOSE_LOG = 17,

    /*
     * Loads an entry of a folder; LEGO's 2013 firmware has no code for it and fails
     *   NAME   string      path of the folder with its closing slash, such as ../prjs/ (at most 119 characters)
     *   PRGID  DATA16      slot to load it into (a member of SLOT)
     *   ITEM   DATA8       which entry of the folder, the first is 1 (1 to 127)
     *   IP     out DATA32  where it was loaded
     */
    GET_IMAGE = 18,

    /*
     * Finds an entry of a folder by its name
     *   NAME    string     path of the folder with its closing slash, such as ../prjs/ (at most 119 characters)
     *   STRING  string     name to look for, without extension
     *   ITEM    out DATA8  number of the entry; the first is 1 (1 to 127; 0: not found)
     */
    GET_ITEM = 19,

    /*
     * Counts the recently run files
     *   ITEMS  out DATA8  number of files, at most 10
     */
    GET_CACHE_FILES = 20,

    /*
     * Puts a file first in the list of recently run files
     *   STRING  string  path of the file
     */
    PUT_CACHE_FILE = 21,

    /*
     * Reads the path of one recently run file
     *   ITEM    DATA8       which one, 1 is the latest (1 to 10)
     *   LENGTH  DATA8       size of the string's buffer, including the zero (bytes)
     *   STRING  out string  path of the file, empty if there is none (as many bytes as LENGTH says)
     */
    GET_CACHE_FILE = 22,

    /*
     * Removes a file from the list of recently run files
     *   STRING  string  path of the file, as given to PUT_CACHE_FILE
     */
    DEL_CACHE_FILE = 23,

    /*
     * Deletes one entry of a folder together with the files in it
     *   NAME  string  path of the folder with its closing slash, such as ../prjs/ (at most 119 characters)
     *   ITEM  DATA8   which entry of the folder, the first is 1 (1 to 127)
     */
    DEL_SUBFOLDER = 24,

    /*
     * Reads the path of the open data log
     *   LENGTH  DATA8       size of the string's buffer, including the zero (bytes)
     *   NAME    out string  path of the log, empty if none is open (as many bytes as LENGTH says)
     */
    GET_LOG_NAME = 25,

    /*
     * Creates a data log and writes its header
     *   NAME                   string      path of the log; .rdf may be omitted; with an empty one it stays in
     *       memory
     *   syncedTime             DATA32      the common time, as GET_LOG_SYNC_TIME returns it
     *   syncedTick             DATA32      the brick's tick at that time
     *   nowTick                DATA32      the brick's tick at the start of the log
     *   sample_interval_in_ms  DATA32      time between samples; fast logs are kept in memory first (ms)
     *   duration_in_ms         DATA32      duration of the log (ms)
     *   SDATA                  string      text that describes the sensors, copied into the header
     *   HANDLE                 out handle  handle of the log
     */
    OPEN_LOG = 27,

    /*
     * Reads raw bytes from a file
     *   HANDLE       handle     the open file
     *   BYTES        DATA16     number of bytes (0 to 32767 bytes)
     *   DESTINATION  out DATA8  the bytes; followed by a zero if the file ended early (as many values as BYTES says)
     */
    READ_BYTES = 28,

    /*
     * Writes raw bytes to a file
     *   HANDLE  handle  the open file
     *   BYTES   DATA16  number of bytes (0 to 32767 bytes)
     *   SOURCE  DATA8   the bytes (as many values as BYTES says)
     */
    WRITE_BYTES = 29,

    /*
     * Deletes a file, or a folder with the files in it
     *   NAME  string  path of the file; a bare name is taken from the program's own folder (at most 119 characters)
     */
    REMOVE = 30,

    /*
     * Copies a file or folder and replaces the destination; the source is kept
     *   SOURCE  string  path to copy from
     *   DEST    string  path to copy to; any existing one is deleted first
     */
    MOVE = 31,
};

/* CMDs of opARRAY */
enum {
    /*
     * Deletes an array and frees its handle (official firmware only)
     *   HANDLE  handle  the array
     */
    DELETE = 0,

    /*
     * Deletes an array and frees its handle (LEGO's name for it is DELETE) (xtended and compat firmware only)
     *   HANDLE  handle  the array
     */
    DESTROY = 0,

    /*
     * Creates an array of DATA8 elements
     *   ELEMENTS  DATA32      initial number of elements (0 to 6000000)
     *   HANDLE    out handle  handle of the new array
     */
    CREATE8 = 1,

    /*
     * Creates an array of DATA16 elements
     *   ELEMENTS  DATA32      initial number of elements (0 to 3000000)
     *   HANDLE    out handle  handle of the new array
     */
    CREATE16 = 2,

    /*
     * Creates an array of DATA32 elements
     *   ELEMENTS  DATA32      initial number of elements (0 to 1500000)
     *   HANDLE    out handle  handle of the new array
     */
    CREATE32 = 3,

    /*
     * Creates an array of DATAF elements
     *   ELEMENTS  DATA32      initial number of elements (0 to 1500000)
     *   HANDLE    out handle  handle of the new array
     */
    CREATEF = 4,

    /*
     * Changes the number of elements of an array
     *   HANDLE    handle  the array
     *   ELEMENTS  DATA32  new number of elements (0 to 6000000)
     */
    RESIZE = 5,

    /*
     * Sets every element of an array to one value
     *   HANDLE  handle       the array
     *   VALUE   array-typed  the value, of the array's type
     */
    FILL = 6,

    /*
     * Copies the content of one array into another of the same type, which is resized to match
     *   HSOURCE  handle  array to copy from
     *   HDEST    handle  array to copy into, which must exist
     */
    COPY = 7,

    /*
     * Writes several elements of a DATA8 array, all within its size
     *   HANDLE    handle  the array
     *   INDEX     DATA32  first element to write, counted from 0 (0 to 5999999)
     *   ELEMENTS  DATA32  number of values that follow (0 to 2147483647)
     *   VALUES    values  the values, one parameter each (each is DATA8)
     */
    INIT8 = 8,

    /*
     * Writes several elements of a DATA16 array, all within its size
     *   HANDLE    handle  the array
     *   INDEX     DATA32  first element to write, counted from 0 (0 to 5999999)
     *   ELEMENTS  DATA32  number of values that follow (0 to 2147483647)
     *   VALUES    values  the values, one parameter each (each is DATA16)
     */
    INIT16 = 9,

    /*
     * Writes several elements of a DATA32 array, all within its size
     *   HANDLE    handle  the array
     *   INDEX     DATA32  first element to write, counted from 0 (0 to 5999999)
     *   ELEMENTS  DATA32  number of values that follow (0 to 2147483647)
     *   VALUES    values  the values, one parameter each (each is DATA32)
     */
    INIT32 = 10,

    /*
     * Writes several elements of a DATAF array, all within its size
     *   HANDLE    handle  the array
     *   INDEX     DATA32  first element to write, counted from 0 (0 to 5999999)
     *   ELEMENTS  DATA32  number of values that follow (0 to 2147483647)
     *   VALUES    values  the values, one parameter each (each is DATAF)
     */
    INITF = 11,

    /*
     * Counts the elements of an array (official firmware only)
     *   HANDLE    handle      the array
     *   ELEMENTS  out DATA32  number of elements, 0 if there is no such array
     */
    SIZE = 12,

    /*
     * Counts the elements of an array (LEGO's name for it is SIZE) (xtended and compat firmware only)
     *   HANDLE    handle      the array
     *   ELEMENTS  out DATA32  number of elements, 0 if there is no such array
     */
    SET_SIZE = 12,

    /*
     * Reads an array's content as bytes, also of another program
     *   PRGID   DATA16     slot of the program that owns the array (a member of SLOT)
     *   HANDLE  handle     the array
     *   INDEX   DATA32     first byte in the array's content, whatever its elements (0 to 2147483647)
     *   BYTES   DATA32     number of bytes (0 to 2147483647 bytes)
     *   ARRAY   out DATA8  the bytes, zeros beyond the end of the array (as many values as BYTES says)
     */
    READ_CONTENT = 13,

    /*
     * Writes an array's content as bytes; the array then ends after them
     *   PRGID   DATA16  slot of the program that owns the array (a member of SLOT)
     *   HANDLE  handle  the array
     *   INDEX   DATA32  first byte in the array's content, whatever its elements (0 to 2147483647)
     *   BYTES   DATA32  number of bytes (0 to 2147483647 bytes)
     *   ARRAY   DATA8   the bytes (as many values as BYTES says)
     */
    WRITE_CONTENT = 14,

    /*
     * Returns the size of an array's content, also of another program
     *   PRGID   DATA16      slot of the program that owns the array (a member of SLOT)
     *   HANDLE  handle      the array
     *   BYTES   out DATA32  number of bytes, 0 if there is no such array (bytes)
     */
    READ_SIZE = 15,
};

/* CMDs of opFILENAME */
enum {
    /*
     * Reports whether a file or folder exists
     *   NAME  string     path of the file; a bare name is taken from the program's own folder (at most 119
     *       characters)
     *   FLAG  out DATA8  whether it exists (0: no; 1: yes)
     */
    EXIST = 16,

    /*
     * Reports the number of files in a folder and their size
     *   NAME   string      path of the folder or file
     *   FILES  out DATA32  number of entries, including . and ..; 0 for a file
     *   SIZE   out DATA32  size of all of them, rounded up (KiB)
     */
    TOTALSIZE = 17,

    /*
     * Splits a path into folder, name and extension
     *   FILENAME  string      the path
     *   LENGTH    DATA8       buffer size for each of the three parts, including the zero (bytes)
     *   FOLDER    out string  the folder, with its closing slash on LEGO's firmware (as many bytes as LENGTH says)
     *   NAME      out string  the name, without folder and extension (as many bytes as LENGTH says)
     *   EXT       out string  the extension with its dot (as many bytes as LENGTH says)
     */
    SPLIT = 18,

    /*
     * Builds a path from folder, name and extension
     *   FOLDER    string      the folder, without a slash at its end
     *   NAME      string      the name
     *   EXT       string      the extension with its dot
     *   LENGTH    DATA8       size of the string's buffer, including the zero (bytes)
     *   FILENAME  out string  the path (as many bytes as LENGTH says)
     */
    MERGE = 19,

    /*
     * Reports whether a path's characters and lengths are allowed; the file need not exist
     *   FILENAME  string     the path
     *   OK        out DATA8  whether the path can be used (0: not allowed; 1: allowed)
     */
    CHECK = 20,

    /*
     * Packs a file or folder into a .raf archive beside it
     *   FILENAME  string  path of the file or folder
     */
    PACK = 21,

    /*
     * Unpacks a .raf archive into the folder it is in
     *   FILENAME  string  path of the archive; its extension is replaced by .raf
     */
    UNPACK = 22,

    /*
     * Reads the path of the program's own folder
     *   LENGTH      DATA8       size of the string's buffer, including the zero (bytes)
     *   FOLDERNAME  out string  path of the folder, without a slash at its end (as many bytes as LENGTH says)
     */
    GET_FOLDERNAME = 23,
};

/* Communication ---------------------------------------------------------------------------------------------------- */

enum {
    /* Fetches direct commands, for the brick's own command program: a CMD follows, below */
    opCOM_READ = 0x91,

    /* Answers direct commands, for the brick's own command program: a CMD follows, below */
    opCOM_WRITE = 0x92,

    /*
     * Waits until nothing is being sent to a device
     *   HARDWARE  DATA8   carrier to use (a member of HWTYPE)
     *   NAME      string  name of the other device, empty: the brick's own adapter
     */
    opCOM_READY = 0xD0,

    /*
     * Does nothing in the firmware; meant to receive data
     *   VALUE1  DATA8   carrier, ignored (a member of HWTYPE)
     *   VALUE2  DATA8   name of the other device, ignored
     *   VALUE3  DATA16  number of bytes, ignored (bytes)
     *   VALUE4  DATA8   the bytes, ignored
     */
    opCOM_READDATA = 0xD1,

    /*
     * Does nothing in the firmware; meant to send data
     *   VALUE1  DATA8   carrier, ignored (a member of HWTYPE)
     *   VALUE2  DATA8   name of the other device, ignored
     *   VALUE3  DATA16  number of bytes, ignored (bytes)
     *   VALUE4  DATA8   the bytes, ignored
     */
    opCOM_WRITEDATA = 0xD2,

    /* Asks about the brick's connections and the devices around it: a CMD follows, below */
    opCOM_GET = 0xD3,

    /* Changes the brick's name, its connections and its lists of devices: a CMD follows, below */
    opCOM_SET = 0xD4,

    /*
     * Reports whether something is still being sent to a device
     *   HARDWARE  DATA8      carrier to use (a member of HWTYPE)
     *   NAME      string     name of the other device, empty: the brick's own adapter
     *   BUSY      out DATA8  whether to wait (0 to 1; 0: ready; 1: busy)
     */
    opCOM_TEST = 0xD5,

    /*
     * Forgets a paired device or a known network
     *   HARDWARE     DATA8   carrier to use (a member of HWTYPE)
     *   REMOTE_NAME  string  name of the other device or network
     */
    opCOM_REMOVE = 0xD6,

    /*
     * Sends a file or a folder to another brick, Bluetooth only
     *   HARDWARE     DATA8   carrier to use (a member of HWTYPE)
     *   REMOTE_NAME  string  name of the other device or network
     *   FILE_NAME    string  path of the file or folder on this brick
     *   FILE_TYPE    DATA8   TYPE_FOLDER for a folder, else a file (a member of FILETYPE)
     */
    opCOM_WRITEFILE = 0xD7,

    /*
     * Opens a mailbox on this brick, at most 250 bytes of content
     *   NO        DATA8   number of the mailbox on this brick (0 to 29)
     *   BOXNAME   string  name of the mailbox (at most 49 characters)
     *   TYPES     DATA8   type of its values (a member of DATA_FORMAT)
     *   FIFOSIZE  DATA8   depth of the queue, ignored by the firmware
     *   VALUES    DATA8   number of values, ignored by the firmware
     */
    opMAILBOX_OPEN = 0xD8,

    /*
     * Sends values to a mailbox of another brick, Bluetooth only
     *   BRICKNAME  string  name of the other brick, empty: all connected ones
     *   HARDWARE   DATA8   read by the firmware and never used (0: as compilers write; a member of HWTYPE)
     *   BOXNAME    string  name of the mailbox (at most 49 characters)
     *   TYPE       DATA8   type of the values (a member of DATA_FORMAT)
     *   VALUES     count   number of values of TYPE follow; exactly one for a string, of at most 249 characters (at
     *       most 249 characters; each is what TYPE says)
     */
    opMAILBOX_WRITE = 0xD9,

    /*
     * Reads the content of a mailbox and marks it read
     *   NO      DATA8  number of the mailbox on this brick (0 to 29)
     *   LENGTH  DATA8  maximum number of bytes to read, ignored by the firmware (bytes)
     *   VALUES  count  number of values that follow, in the type of MAILBOX_OPEN (each is array-typed)
     */
    opMAILBOX_READ = 0xDA,

    /*
     * Reports whether a mailbox has an unread message
     *   NO    DATA8      number of the mailbox on this brick (0 to 29)
     *   BUSY  out DATA8  whether to wait (0 to 1; 0: a new message is there; 1: nothing new)
     */
    opMAILBOX_TEST = 0xDB,

    /*
     * Waits for an unread message in a mailbox
     *   NO  DATA8  number of the mailbox on this brick (0 to 29)
     */
    opMAILBOX_READY = 0xDC,

    /*
     * Closes a mailbox on this brick
     *   NO  DATA8  number of the mailbox on this brick (0 to 29)
     */
    opMAILBOX_CLOSE = 0xDD,

    /*
     * Returns the size of a mailbox's content (xtended and compat firmware only)
     *   NO    DATA8      number of the mailbox on this brick (0 to 29)
     *   SIZE  out DATA8  size of the content (bytes)
     */
    opMAILBOX_SIZE = 0xE5,
};

/* CMDs of opCOM_READ */
enum {
    /*
     * Returns the address of the last direct command received
     *   LENGTH  DATA32      maximum number of bytes of code, ignored by the firmware (bytes)
     *   IMAGE   out DATA32  address of the code
     *   GLOBAL  out DATA32  address of its global memory
     *   FLAG    out DATA8   whether one is waiting (0 to 1; 0: none; 1: ready to run)
     */
    COMMAND = 14,
};

/* CMDs of opCOM_WRITE */
enum {
    /*
     * Sends the global memory of a direct command that has run as its reply
     *   IMAGE   DATA32  address of the code
     *   GLOBAL  DATA32  address of its global memory
     *   STATUS  DATA8   how it ended; all but OK give DIRECT_REPLY_ERROR (a member of RESULT)
     */
    REPLY = 14,
};

/* CMDs of opCOM_GET */
enum {
    /*
     * Reports whether Bluetooth or WiFi is on
     *   HARDWARE  DATA8      carrier to use (2 to 3; a member of HWTYPE)
     *   ACTIVE    out DATA8  whether it is on (0 to 1; 0: off; 1: on)
     */
    GET_ON_OFF = 1,

    /*
     * Reports whether other devices can see the brick by Bluetooth
     *   HARDWARE  DATA8      carrier to use (1 to 3; a member of HWTYPE)
     *   VISIBLE   out DATA8  whether it is visible (0 to 1; 0: no; 1: yes)
     */
    GET_VISIBLE = 2,

    /*
     * Reports the state of a search or connection request
     *   HARDWARE  DATA8      carrier to use (2 to 3; a member of HWTYPE)
     *   ITEM      DATA8      place in the list, ignored by the firmware
     *   RESULT    out DATA8  state of the request (a member of RESULT)
     */
    GET_RESULT = 4,

    /*
     * Reads the PIN for a device, always 1234
     *   HARDWARE  DATA8       carrier to use (a member of HWTYPE)
     *   NAME      string      name of the other device or network
     *   LENGTH    DATA8       size of the PIN's buffer, including the zero (bytes)
     *   PINCODE   out string  the PIN (as many bytes as LENGTH says)
     */
    GET_PIN = 5,

    /*
     * Reads a counter that changes when a device enters or leaves a list (compat firmware only)
     *   HARDWARE  DATA8       carrier to use (a member of HWTYPE)
     *   STATE     out DATA16  number to compare with the one of the last call
     */
    LIST_STATE = 7,

    /*
     * Counts the devices or networks that a search found
     *   HARDWARE  DATA8      carrier to use (2 to 3; a member of HWTYPE)
     *   ITEMS     out DATA8  number of entries in the list
     */
    SEARCH_ITEMS = 8,

    /*
     * Describes one device or network that a search found
     *   HARDWARE   DATA8       carrier to use (a member of HWTYPE)
     *   ITEM       DATA8       place in the list, counted from 0
     *   LENGTH     DATA8       size of the text buffer, including the zero (bytes; -1: unlimited (handles only))
     *   NAME       out string  name of the other device or network (as many bytes as LENGTH says)
     *   PAIRED     out DATA8   whether it is paired (Bluetooth) or known (WiFi) (0 to 1; 0: no; 1: yes)
     *   CONNECTED  out DATA8   whether it is connected (0 to 1; 0: no; 1: yes)
     *   TYPE       out DATA8   kind of device (Bluetooth) or encryption (WiFi) (0: WiFi, not encrypted; 1: WiFi,
     *       WPA2; a member of BTTYPE)
     *   VISIBLE    out DATA8   whether it is in range (0 to 1; 0: no; 1: yes)
     */
    SEARCH_ITEM = 9,

    /*
     * Counts the paired devices, in range or not
     *   HARDWARE  DATA8      carrier to use (2 to 2; a member of HWTYPE)
     *   ITEMS     out DATA8  number of entries in the list
     */
    FAVOUR_ITEMS = 10,

    /*
     * Describes one paired device or known network
     *   HARDWARE   DATA8       carrier to use (a member of HWTYPE)
     *   ITEM       DATA8       place in the list, counted from 0
     *   LENGTH     DATA8       size of the text buffer, including the zero (bytes; -1: unlimited (handles only))
     *   NAME       out string  name of the other device or network (as many bytes as LENGTH says)
     *   PAIRED     out DATA8   whether it is paired (Bluetooth) or known (WiFi) (0 to 1; 0: no; 1: yes)
     *   CONNECTED  out DATA8   whether it is connected (0 to 1; 0: no; 1: yes)
     *   TYPE       out DATA8   kind of device (Bluetooth) or encryption (WiFi) (0: WiFi, not encrypted; 1: WiFi,
     *       WPA2; a member of BTTYPE)
     */
    FAVOUR_ITEM = 11,

    /*
     * Reads the brick's Bluetooth address
     *   HARDWARE  DATA8       carrier to use (2 to 2; a member of HWTYPE)
     *   LENGTH    DATA8       size of the text buffer, including the zero (bytes; -1: unlimited (handles only))
     *   STRING    out string  12 hex digits (as many bytes as LENGTH says)
     */
    GET_ID = 12,

    /*
     * Reads the brick's name
     *   LENGTH  DATA8       size of the text buffer, including the zero (bytes; -1: unlimited (handles only))
     *   NAME    out string  name of the brick (as many bytes as LENGTH says)
     */
    GET_BRICKNAME = 13,

    /*
     * Reads network name and addresses, WiFi only
     *   HARDWARE  DATA8       carrier to use (a member of HWTYPE)
     *   LENGTH    DATA8       buffer size for each of the three texts, including the zero (bytes; -1: unlimited
     *       (handles only))
     *   NAME      out string  name of the network, NONE without one (as many bytes as LENGTH says)
     *   MAC       out string  MAC address of the brick, ?? when WiFi is off (at most 17 characters; as many bytes as
     *       LENGTH says)
     *   IP        out string  IP address of the brick, ?? when not connected (at most 15 characters; as many bytes
     *       as LENGTH says)
     */
    GET_NETWORK = 14,

    /*
     * Reports whether the hardware is present (for WiFi: a known dongle)
     *   HARDWARE  DATA8      carrier to use (a member of HWTYPE)
     *   OK        out DATA8  whether it is present (0 to 1; 0: no; 1: yes)
     */
    GET_PRESENT = 15,

    /*
     * Reports the encryption of a network, WiFi only
     *   HARDWARE  DATA8      carrier to use (3 to 3; a member of HWTYPE)
     *   ITEM      DATA8      place in the list, counted from 0
     *   TYPE      out DATA8  kind of encryption; always none in the 2013 firmware (a member of ENCRYPT)
     */
    GET_ENCRYPT = 16,

    /*
     * Counts the connected devices, Bluetooth only
     *   HARDWARE  DATA8      carrier to use (1 to 3; a member of HWTYPE)
     *   ITEMS     out DATA8  number of entries in the list
     */
    CONNEC_ITEMS = 17,

    /*
     * Describes one connected device, Bluetooth only
     *   HARDWARE  DATA8       carrier to use (a member of HWTYPE)
     *   ITEM      DATA8       place in the list, counted from 0
     *   LENGTH    DATA8       size of the text buffer, including the zero (bytes; -1: unlimited (handles only))
     *   NAME      out string  name of the device (as many bytes as LENGTH says)
     *   TYPE      out DATA8   kind of device (a member of BTTYPE)
     */
    CONNEC_ITEM = 18,

    /*
     * Reports which device asks for a connection, Bluetooth only
     *   HARDWARE  DATA8       carrier to use (2 to 2; a member of HWTYPE)
     *   LENGTH    DATA8       size of the text buffer, including the zero (bytes; -1: unlimited (handles only))
     *   NAME      out string  name of the device (as many bytes as LENGTH says)
     *   TYPE      out DATA8   kind of device (a member of BTTYPE)
     */
    GET_INCOMING = 19,

    /*
     * Reports whether Bluetooth is in its mode for Apple devices
     *   HARDWARE  DATA8      carrier to use (2 to 2; a member of HWTYPE)
     *   ACTIVE    out DATA8  whether it is on (0 to 1; 0: off; 1: on)
     */
    GET_MODE2 = 20,
};

/* CMDs of opCOM_SET */
enum {
    /*
     * Switches Bluetooth or WiFi on or off
     *   HARDWARE  DATA8  carrier to use (2 to 3; a member of HWTYPE)
     *   ACTIVE    DATA8  whether to switch it on (0 to 1; 0: off; 1: on)
     */
    SET_ON_OFF = 1,

    /*
     * Makes the brick visible or invisible, Bluetooth only
     *   HARDWARE  DATA8  carrier to use (a member of HWTYPE)
     *   VISIBLE   DATA8  whether other devices can see it (0 to 1; 0: invisible; 1: visible)
     */
    SET_VISIBLE = 2,

    /*
     * Starts or stops the search for devices or networks
     *   HARDWARE  DATA8  carrier to use (2 to 3; a member of HWTYPE)
     *   SEARCH    DATA8  whether to search (0 to 1; 0: stop (Bluetooth only); 1: start)
     */
    SET_SEARCH = 3,

    /*
     * Answers the request for a PIN (Bluetooth) or stores a network's password (WiFi)
     *   HARDWARE  DATA8   carrier to use (2 to 3; a member of HWTYPE)
     *   NAME      string  name of the other device or network
     *   PINCODE   string  PIN or password
     */
    SET_PIN = 5,

    /*
     * Answers the request to confirm a passkey, Bluetooth only
     *   HARDWARE  DATA8  carrier to use (2 to 2; a member of HWTYPE)
     *   ACCEPT    DATA8  the answer (0 to 1; 0: reject; 1: accept)
     */
    SET_PASSKEY = 6,

    /*
     * Connects a device or network, or ends a Bluetooth connection
     *   HARDWARE    DATA8   carrier to use (2 to 3; a member of HWTYPE)
     *   NAME        string  name of the other device or network
     *   CONNECTION  DATA8   what to do (0 to 1; 0: disconnect; 1: connect)
     */
    SET_CONNECTION = 7,

    /*
     * Renames the brick
     *   NAME  string  new name, at most 118 characters, else refused (at most 118 characters)
     */
    SET_BRICKNAME = 8,

    /*
     * Moves a network up in the list, WiFi only
     *   HARDWARE  DATA8  carrier to use (3 to 3; a member of HWTYPE)
     *   ITEM      DATA8  place in the list, counted from 0
     */
    SET_MOVEUP = 9,

    /*
     * Moves a network down in the list, WiFi only
     *   HARDWARE  DATA8  carrier to use (3 to 3; a member of HWTYPE)
     *   ITEM      DATA8  place in the list, counted from 0
     */
    SET_MOVEDOWN = 10,

    /*
     * Sets the encryption of a network, WiFi only
     *   HARDWARE  DATA8   carrier to use (3 to 3; a member of HWTYPE)
     *   ITEM      string  name of the network
     *   ENCRYPT   DATA8   kind of encryption (a member of ENCRYPT)
     */
    SET_ENCRYPT = 11,

    /*
     * Adds a network to the end of the list, WiFi only
     *   HARDWARE  DATA8   carrier to use (3 to 3; a member of HWTYPE)
     *   NAME      string  name of the network
     */
    SET_SSID = 12,

    /*
     * Switches the Bluetooth mode for Apple devices on or off
     *   HARDWARE  DATA8  carrier to use (2 to 2; a member of HWTYPE)
     *   ACTIVE    DATA8  whether to switch it on (0 to 1; 0: off; 1: on)
     */
    SET_MODE2 = 13,
};

/* Enumerations ----------------------------------------------------------------------------------------------------- */

/* Names of the values of parameters. */

/* TYPE: Types of devices on the ports; MODE_KEEP and TYPE_KEEP ask to leave mode or type as it is */
enum {
    MODE_KEEP = -1,
    TYPE_KEEP = 0,
    TYPE_NXT_TOUCH = 1,
    TYPE_NXT_LIGHT = 2,
    TYPE_NXT_SOUND = 3,
    TYPE_NXT_COLOR = 4,
    TYPE_NXT_ULTRASONIC = 5,
    TYPE_NXT_TEMPERATURE = 6,
    TYPE_TACHO = 7,
    TYPE_MINITACHO = 8,
    TYPE_NEWTACHO = 9,
    TYPE_TOUCH = 16,
    TYPE_COLOR = 29,
    TYPE_ULTRASONIC = 30,
    TYPE_GYRO = 32,
    TYPE_IR = 33,
    TYPE_THIRD_PARTY_START = 50,
    TYPE_THIRD_PARTY_END = 98,
    TYPE_ENERGYMETER = 99,
    TYPE_IIC_UNKNOWN = 100,
    TYPE_NXT_TEST = 101,
    TYPE_NXT_IIC = 123,
    TYPE_TERMINAL = 124,
    TYPE_UNKNOWN = 125,
    TYPE_NONE = 126,
    TYPE_ERROR = 127,
};

/* SLOT: Program slots of the virtual machine; direct commands run in CMD_SLOT */
enum {
    GUI_SLOT = 0,
    USER_SLOT = 1,
    CMD_SLOT = 2,
    TERM_SLOT = 3,
    DEBUG_SLOT = 4,
    CURRENT_SLOT = -1,
    SLOTS = 5,
};

/* BUTTONTYPE: Buttons of the brick */
enum {
    NO_BUTTON = 0,
    UP_BUTTON = 1,
    ENTER_BUTTON = 2,
    DOWN_BUTTON = 3,
    RIGHT_BUTTON = 4,
    LEFT_BUTTON = 5,
    BACK_BUTTON = 6,
    ANY_BUTTON = 7,
    BUTTONTYPES = 8,
};

/* BROWSERTYPE: What the file browser on the display lists */
enum {
    BROWSE_FOLDERS = 0,
    BROWSE_FOLDS_FILES = 1,
    BROWSE_CACHE = 2,
    BROWSE_FILES = 3,
    BROWSERTYPES = 4,
};

/* FONTTYPE: Fonts of the display */
enum {
    NORMAL_FONT = 0,
    SMALL_FONT = 1,
    LARGE_FONT = 2,
    TINY_FONT = 3,
    FONTTYPES = 4,
};

/* ICONTYPE: Sets of icons; the set decides what an icon's number means */
enum {
    NORMAL_ICON = 0,
    SMALL_ICON = 1,
    LARGE_ICON = 2,
    MENU_ICON = 3,
    ARROW_ICON = 4,
    ICONTYPES = 5,
};

/* S_ICON_NO: Icons of the set SMALL_ICON: battery, Bluetooth, WiFi and USB in the top line */
enum {
    SICON_CHARGING = 0,
    SICON_BATT_4 = 1,
    SICON_BATT_3 = 2,
    SICON_BATT_2 = 3,
    SICON_BATT_1 = 4,
    SICON_BATT_0 = 5,
    SICON_WAIT1 = 6,
    SICON_WAIT2 = 7,
    SICON_BT_ON = 8,
    SICON_BT_VISIBLE = 9,
    SICON_BT_CONNECTED = 10,
    SICON_BT_CONNVISIB = 11,
    SICON_WIFI_3 = 12,
    SICON_WIFI_2 = 13,
    SICON_WIFI_1 = 14,
    SICON_WIFI_CONNECTED = 15,
    SICON_USB = 21,
    S_ICON_NOS = 22,
};

/* N_ICON_NO: Icons of the set NORMAL_ICON: files, folders and settings */
enum {
    ICON_NONE = -1,
    ICON_RUN = 0,
    ICON_FOLDER = 1,
    ICON_FOLDER2 = 2,
    ICON_USB = 3,
    ICON_SD = 4,
    ICON_SOUND = 5,
    ICON_IMAGE = 6,
    ICON_SETTINGS = 7,
    ICON_ONOFF = 8,
    ICON_SEARCH = 9,
    ICON_WIFI = 10,
    ICON_CONNECTIONS = 11,
    ICON_ADD_HIDDEN = 12,
    ICON_TRASHBIN = 13,
    ICON_VISIBILITY = 14,
    ICON_KEY = 15,
    ICON_CONNECT = 16,
    ICON_DISCONNECT = 17,
    ICON_UP = 18,
    ICON_DOWN = 19,
    ICON_WAIT1 = 20,
    ICON_WAIT2 = 21,
    ICON_BLUETOOTH = 22,
    ICON_INFO = 23,
    ICON_TEXT = 24,
    ICON_QUESTIONMARK = 27,
    ICON_INFO_FILE = 28,
    ICON_DISC = 29,
    ICON_CONNECTED = 30,
    ICON_OBP = 31,
    ICON_OBD = 32,
    ICON_OPENFOLDER = 33,
    ICON_BRICK1 = 34,
    N_ICON_NOS = 35,
};

/* L_ICON_NO: Icons of the set LARGE_ICON: answers, warnings and file operations */
enum {
    YES_NOTSEL = 0,
    YES_SEL = 1,
    NO_NOTSEL = 2,
    NO_SEL = 3,
    OFF = 4,
    WAIT_VERT = 5,
    WAIT_HORZ = 6,
    TO_MANUAL = 7,
    WARNSIGN = 8,
    WARN_BATT = 9,
    WARN_POWER = 10,
    WARN_TEMP = 11,
    NO_USBSTICK = 12,
    TO_EXECUTE = 13,
    TO_BRICK = 14,
    TO_SDCARD = 15,
    TO_USBSTICK = 16,
    TO_BLUETOOTH = 17,
    TO_WIFI = 18,
    TO_TRASH = 19,
    TO_COPY = 20,
    TO_FILE = 21,
    CHAR_ERROR = 22,
    COPY_ERROR = 23,
    PROGRAM_ERROR = 24,
    WARN_MEMORY = 27,
    L_ICON_NOS = 28,
};

/* M_ICON_NO: Icons of the set MENU_ICON: kinds of Bluetooth peers, locks and check boxes */
enum {
    ICON_STAR = 0,
    ICON_LOCKSTAR = 1,
    ICON_LOCK = 2,
    ICON_PC = 3,
    ICON_PHONE = 4,
    ICON_BRICK = 5,
    ICON_UNKNOWN = 6,
    ICON_FROM_FOLDER = 7,
    ICON_CHECKBOX = 8,
    ICON_CHECKED = 9,
    ICON_XED = 10,
    M_ICON_NOS = 11,
};

/* A_ICON_NO: Icons of the set ARROW_ICON: small arrows */
enum {
    ICON_LEFT = 1,
    ICON_RIGHT = 2,
    A_ICON_NOS = 3,
};

/* BTTYPE: Kinds of Bluetooth peers, numbered like their icons in the set MENU_ICON */
enum {
    BTTYPE_PC = 3,
    BTTYPE_PHONE = 4,
    BTTYPE_BRICK = 5,
    BTTYPE_UNKNOWN = 6,
    BTTYPES = 7,
};

/* LEDPATTERN: Colours and rhythms of the light behind the buttons */
enum {
    LED_BLACK = 0,
    LED_GREEN = 1,
    LED_RED = 2,
    LED_ORANGE = 3,
    LED_GREEN_FLASH = 4,
    LED_RED_FLASH = 5,
    LED_ORANGE_FLASH = 6,
    LED_GREEN_PULSE = 7,
    LED_RED_PULSE = 8,
    LED_ORANGE_PULSE = 9,
    LEDPATTERNS = 10,
};

/* LEDTYPE: Single lights behind the buttons: right or left, red or green */
enum {
    LED_ALL = 0,
    LED_RR = 1,
    LED_RG = 2,
    LED_LR = 3,
    LED_LG = 4,
};

/* FILETYPE: Kinds of files in the browser; it ORs TYPE_SDCARD or TYPE_USBSTICK to the kind found there */
enum {
    FILETYPE_UNKNOWN = 0,
    TYPE_FOLDER = 1,
    TYPE_SOUND = 2,
    TYPE_BYTECODE = 3,
    TYPE_GRAPHICS = 4,
    TYPE_DATALOG = 5,
    TYPE_PROGRAM = 6,
    TYPE_TEXT = 7,
    TYPE_SDCARD = 16,
    TYPE_USBSTICK = 32,
    TYPE_RESTART_BROWSER = -1,
    TYPE_REFRESH_BROWSER = -2,
    FILETYPES = 33,
};

/* RESULT: Result of an operation, or that it is still running */
enum {
    OK = 0,
    BUSY = 1,
    FAIL = 2,
    STOP = 4,
    START = 8,
};

/* DATA_FORMAT: Formats of values, for sensors and mailboxes; FORMAT_TYPES has their types */
enum {
    DATA_8 = 0,
    DATA_16 = 1,
    DATA_32 = 2,
    DATA_F = 3,
    DATA_S = 4,
    DATA_A = 5,
    DATA_V = 7,
    DATA_PCT = 16,
    DATA_RAW = 18,
    DATA_SI = 19,
    DATA_FORMATS = 20,
};

/* DEL: Separators between two values in a text file */
enum {
    DEL_NONE = 0,
    DEL_TAB = 1,
    DEL_SPACE = 2,
    DEL_RETURN = 3,
    DEL_COLON = 4,
    DEL_COMMA = 5,
    DEL_LINEFEED = 6,
    DEL_CRLF = 7,
    DELS = 8,
};

/* HWTYPE: Carriers of the protocol */
enum {
    HW_USB = 1,
    HW_BT = 2,
    HW_WIFI = 3,
    HWTYPES = 4,
};

/* ENCRYPT: Encryption of a WiFi network (official and compat firmware only) */
enum {
    ENCRYPT_NONE = 0,
    ENCRYPT_WPA2 = 1,
    ENCRYPTS = 2,
};

/* LMS_ENCRYPT: Encryption of a WiFi network, under the names of the extended firmware (xtended firmware only) */
enum {
    LMS_ENCRYPT_NONE = 0,
    LMS_ENCRYPT_WPA2 = 1,
    LMS_ENCRYPTS = 2,
};

/* COLOR: Colour channels of the NXT colour sensor; BLANK is the reading without light */
enum {
    RED = 0,
    GREEN = 1,
    BLUE = 2,
    BLANK = 3,
    COLORS = 4,
};

/* NXTCOLOR: Colours that a colour sensor recognises */
enum {
    BLACKCOLOR = 1,
    BLUECOLOR = 2,
    GREENCOLOR = 3,
    YELLOWCOLOR = 4,
    REDCOLOR = 5,
    WHITECOLOR = 6,
};

/* WARNING: Warnings of the brick, one bit each; WARNINGS masks those shown to the user */
enum {
    WARNING_TEMP = 1,
    WARNING_CURRENT = 2,
    WARNING_VOLTAGE = 4,
    WARNING_MEMORY = 8,
    WARNING_DSPSTAT = 16,
    WARNING_RAM = 32,
    WARNING_BATTLOW = 64,
    WARNING_BUSY = 128,
    WARNINGS = 63,
};

/* OBJSTAT: State of a program or object; one at a time, though each number is a single bit */
enum {
    RUNNING = 16,
    WAITING = 32,
    STOPPED = 64,
    HALTED = 128,
};

/* DEVCMD: Commands to a UART sensor; DEVCMD_FIRE is another name of DEVCMD_RESET (compat lacks it) */
enum {
    DEVCMD_RESET = 17,
    DEVCMD_FIRE = 17,
    DEVCMD_CHANNEL = 18,
    DEVCMDS = 19,
};

/* CONN: Kinds of connection that a port detects */
enum {
    CONN_UNKNOWN = 111,
    CONN_DAISYCHAIN = 117,
    CONN_NXT_COLOR = 118,
    CONN_NXT_DUMB = 119,
    CONN_NXT_IIC = 120,
    CONN_INPUT_DUMB = 121,
    CONN_INPUT_UART = 122,
    CONN_OUTPUT_DUMB = 123,
    CONN_OUTPUT_INTELLIGENT = 124,
    CONN_OUTPUT_TACHO = 125,
    CONN_NONE = 126,
    CONN_ERROR = 127,
};

/* System commands -------------------------------------------------------------------------------------------------- */

/* The byte after the message type, and what follows it. */

enum {
    /*
     * Opens a file on the brick for writing and announces its size
     *   asks with: size (u32), path (text), data (optional data)
     *   gets: handle (u8)
     */
    BEGIN_DOWNLOAD = 0x92,

    /*
     * Writes the next piece of a file; the file closes itself when it is complete
     *   asks with: handle (u8), data (data)
     *   gets: handle (u8)
     */
    CONTINUE_DOWNLOAD = 0x93,

    /*
     * Opens a file on the brick for reading and fetches its first piece
     *   asks with: max_bytes (u16), path (text)
     *   gets: size (u32), handle (u8), data (data)
     */
    BEGIN_UPLOAD = 0x94,

    /*
     * Fetches the next piece of a file
     *   asks with: handle (u8), max_bytes (u16)
     *   gets: handle (u8), data (data)
     */
    CONTINUE_UPLOAD = 0x95,

    /*
     * Opens a file that may still be growing, such as a data log, and fetches its first piece
     *   asks with: max_bytes (u16), path (text)
     *   gets: size (u32), handle (u8), data (data)
     */
    BEGIN_GETFILE = 0x96,

    /*
     * Fetches the next piece of a file that may still be growing
     *   asks with: handle (u8), max_bytes (u16)
     *   gets: size (u32), handle (u8), data (data)
     */
    CONTINUE_GETFILE = 0x97,

    /*
     * Closes an open file before its end
     *   asks with: handle (u8), hash (optional data)
     *   gets: handle (optional u8)
     */
    CLOSE_FILEHANDLE = 0x98,

    /*
     * Lists a folder and fetches the first piece of the listing
     *   asks with: max_bytes (u16), path (text)
     *   gets: list_size (u32), handle (u8), list (listing)
     */
    LIST_FILES = 0x99,

    /*
     * Fetches the next piece of a listing
     *   asks with: handle (u8), max_bytes (u16)
     *   gets: handle (u8), list (listing)
     */
    CONTINUE_LIST_FILES = 0x9A,

    /*
     * Creates a folder
     *   asks with: path (text)
     */
    CREATE_DIR = 0x9B,

    /*
     * Deletes a file or an empty folder
     *   asks with: path (text)
     */
    DELETE_FILE = 0x9C,

    /*
     * Asks which file handles are in use
     *   gets: handles (data)
     */
    LIST_OPEN_HANDLES = 0x9D,

    /*
     * Puts a message into a mailbox of the program that runs on the brick
     *   asks with: name_length (u8), name (counted text), payload_length (u16), payload (data)
     *   gets no reply
     */
    WRITEMAILBOX = 0x9E,

    /*
     * Sends the PIN for a Bluetooth device (USB only)
     *   asks with: mac_length (u8), mac (counted text), pin_length (u8), pin (counted text)
     *   gets: mac_length (u8), mac (counted text), pin_length (u8), pin (counted text)
     */
    BLUETOOTHPIN = 0x9F,

    /*
     * Restarts the brick into its firmware updater
     *   gets no reply
     */
    ENTERFWUPDATE = 0xA0,

    /*
     * Sets the bundle identifier that the brick shows to Apple devices
     *   asks with: id (text)
     */
    SETBUNDLEID = 0xA1,

    /*
     * Sets the bundle seed identifier that the brick shows to Apple devices
     *   asks with: id (text)
     */
    SETBUNDLESEEDID = 0xA2,

    /*
     * Erases a region of the flash memory and prepares to write it
     *   asks with: address (u32), image_size (u32)
     */
    BOOTLOADER_BEGIN_DOWNLOAD_WITH_ERASE = 0xF0,

    /*
     * Prepares to write a region of the flash memory that is already erased
     *   asks with: address (u32), image_size (u32)
     */
    BOOTLOADER_BEGIN_DOWNLOAD = 0xF1,

    /*
     * Writes the next piece of the image
     *   asks with: data (data)
     */
    BOOTLOADER_DOWNLOAD_DATA = 0xF2,

    /* Erases the whole flash memory */
    BOOTLOADER_CHIP_ERASE = 0xF3,

    /* Leaves the updater and starts the firmware */
    BOOTLOADER_START_APP = 0xF4,

    /*
     * Asks for the checksum of a region of the flash memory
     *   asks with: address (u32), image_size (u32)
     *   gets: checksum (u32)
     */
    BOOTLOADER_GET_CHECKSUM = 0xF5,

    /*
     * Asks for the versions of hardware and firmware
     *   gets: hardware_version (u32), firmware_version (u32)
     */
    BOOTLOADER_GET_VERSION = 0xF6,
};

/* The byte after the command's number in a reply */
enum {
    SYSTEM_SUCCESS = 0,
    SYSTEM_UNKNOWN_HANDLE = 1,
    SYSTEM_HANDLE_NOT_READY = 2,
    SYSTEM_CORRUPT_FILE = 3,
    SYSTEM_NO_HANDLES_AVAILABLE = 4,
    SYSTEM_NO_PERMISSION = 5,
    SYSTEM_ILLEGAL_PATH = 6,
    SYSTEM_FILE_EXITS = 7,
    SYSTEM_END_OF_FILE = 8,
    SYSTEM_SIZE_ERROR = 9,
    SYSTEM_UNKNOWN_ERROR = 10,
    SYSTEM_ILLEGAL_FILENAME = 11,
    SYSTEM_ILLEGAL_CONNECTION = 12,
};

/* Daisy chain ------------------------------------------------------------------------------------------------------ */

/* The byte after the message type, between bricks that are joined by USB. */

enum {
    /* Forwards operations to a brick further down */
    DAISY_DOWNSTREAM = 0xA0,

    /* Passes sensor data up towards the first brick */
    DAISY_UPSTREAM = 0xA1,

    /* Asks which sensors a brick further down has */
    DAISY_INFO = 0xA2,

    /* Allows the brick below to answer again */
    DAISY_UNLOCK_SLAVE = 0xA3,

    /* Sets type and mode of a sensor further down */
    DAISY_SET_TYPE = 0xA4,

    /* Forwards operations, and names the motors to report as busy */
    DAISY_DOWNSTREAM_WITH_BUSY = 0xA5,
};

/* Constants -------------------------------------------------------------------------------------------------------- */

/* Sizes, limits, folders, files and positions, as the firmware has them. */

enum {
    OUTPUTS = 4,
    INPUTS = 4,
    BUTTONS = 6,
    LEDS = 4,
    LCD_WIDTH = 178,
    LCD_HEIGHT = 128,
    TOPLINE_HEIGHT = 10,
    LCD_STORE_LEVELS = 3,
    FG_COLOR = 1,
    BG_COLOR = 0,
    DEFAULT_VOLUME = 100,
    DEFAULT_SLEEPMINUTES = 30,
    CHAIN_DEPT = 4,
    PATHSIZE = 84,
    NAMESIZE = 32,
    EXTSIZE = 5,
    FILENAMESIZE = 120,
    MACSIZE = 18,
    IPSIZE = 16,
    BTADRSIZE = 13,
    ERR_STRING_SIZE = 32,
    BRICKNAMESIZE = 120,
    BTPASSKEYSIZE = 7,
    WIFIPASSKEYSIZE = 33,
    EVENT_NONE = 0,
    EVENT_BT_PIN = 1,
    EVENT_BT_REQ_CONF = 2,
    MAX_VALID_TYPE = 101,
    DIR_DEEPT = 127,
    CHARSET_NAME = 1,
    CHARSET_FILENAME = 2,
    CHARSET_BTPASSKEY = 4,
    CHARSET_WIFIPASSKEY = 8,
    CHARSET_WIFISSID = 16,
    DATA8_MIN = -127,
    DATA8_MAX = 127,
    DATA16_MIN = -32767,
    DATA16_MAX = 32767,
    DATA8_NAN = 128,
    PULSE_GUI_BACKGROUND = 1,
    PULSE_BROWSER = 2,
    PULSE_KEY = 4,
    POP3_ABS_X = 16,
    POP3_ABS_Y = 50,
    POP3_ABS_WARN_ICON_X = 64,
    POP3_ABS_WARN_ICON_X1 = 40,
    POP3_ABS_WARN_ICON_X2 = 72,
    POP3_ABS_WARN_ICON_X3 = 104,
    POP3_ABS_WARN_ICON_Y = 60,
    POP3_ABS_WARN_SPEC_ICON_X = 88,
    POP3_ABS_WARN_SPEC_ICON_Y = 60,
    POP3_ABS_WARN_TEXT_X = 80,
    POP3_ABS_WARN_TEXT_Y = 68,
    POP3_ABS_WARN_YES_X = 72,
    POP3_ABS_WARN_YES_Y = 90,
    POP3_ABS_WARN_LINE_X = 21,
    POP3_ABS_WARN_LINE_Y = 89,
    POP3_ABS_WARN_LINE_ENDX = 155,
};

#define MEMORY_FOLDER "/mnt/ramdisk"
#define PROGRAM_FOLDER "../prjs/BrkProg_SAVE"
#define DATALOG_FOLDER "../prjs/BrkDL_SAVE"
#define SDCARD_FOLDER "../prjs/SD_Card"
#define USBSTICK_FOLDER "../prjs/USB_Stick"
#define PRJS_DIR "../prjs"
#define APPS_DIR "../apps"
#define TOOLS_DIR "../tools"
#define TMP_DIR "../tmp"
#define SETTINGS_DIR "../sys/settings"
#define LASTRUN_FILE_NAME "lastrun"
#define CALDATA_FILE_NAME "caldata"
#define SLEEP_FILE_NAME "Sleep"
#define VOLUME_FILE_NAME "Volume"
#define WIFI_FILE_NAME "WiFi"
#define BLUETOOTH_FILE_NAME "Bluetooth"
#define EXT_SOUND ".rsf"
#define EXT_GRAPHICS ".rgf"
#define EXT_BYTECODE ".rbf"
#define EXT_TEXT ".rtf"
#define EXT_DATALOG ".rdf"
#define EXT_PROGRAM ".rpf"
#define EXT_CONFIG ".rcf"
#define EXT_ARCHIVE ".raf"
#define DATA32_MIN (-2147483647)
#define DATA32_MAX 0x7FFFFFFFu
#define DATAF_MIN (-2147483647)
#define DATAF_MAX 0x7FFFFFFFu
#define DATA16_NAN 0x8000u
#define DATA32_NAN 0x80000000u
#define DATAF_NAN 0x7FC00000u


/* Filling a frame ------------------------------------------------------------------------------------------------ */

/*
 * A frame being filled. Data that does not fit is omitted, and ev3_end then returns 0.
 *
 *   bytes  the frame, to be sent as it is; on USB it is filled up with zeros to 1024 bytes
 *   size   number of bytes so far
 *   full   nonzero once something did not fit or could not be encoded
 */
typedef struct {
    uint8_t bytes[EV3_MAX_FRAME];
    uint16_t size;
    uint16_t full;
} ev3_frame;

/* Raw bytes */
static inline void ev3_raw(ev3_frame *frame, const void *bytes, size_t count)
{
    if (count > (size_t)(EV3_MAX_FRAME - frame->size)) {
        frame->full = 1;
        return;
    }
    memcpy(frame->bytes + frame->size, bytes, count);
    frame->size = (uint16_t)(frame->size + count);
}

/* A number of 1, 2 or 4 bytes without anything around it, as system commands have them */
static inline void ev3_number(ev3_frame *frame, uint32_t value, size_t count)
{
    uint8_t bytes[] = {EV3_BYTE(value, 0), EV3_BYTE(value, 8), EV3_BYTE(value, 16), EV3_BYTE(value, 24)};
    ev3_raw(frame, bytes, count);
}

/* A text and its zero without anything around it, as system commands have them; ISO-8859-1 */
static inline void ev3_text(ev3_frame *frame, const char *text)
{
    ev3_raw(frame, text, strlen(text) + 1);
}

static inline void ev3_begin(ev3_frame *frame, uint16_t counter, int type)
{
    memset(frame, 0, sizeof *frame);
    ev3_number(frame, 0, 2);
    ev3_number(frame, counter, 2);
    ev3_number(frame, (uint32_t)type, 1);
}

/* Starts a direct command: a message type and bytes of memory, global 0 to 1023, local 0 to 63 */
static inline void ev3_begin_direct(ev3_frame *frame, uint16_t counter, int type, unsigned globals, unsigned locals)
{
    ev3_begin(frame, counter, type);
    frame->full = globals > 1023 || locals > 63;
    ev3_number(frame, (uint32_t)locals << 10 | globals, 2);
}

/* Starts a system command: a message type and the command's number */
static inline void ev3_begin_system(ev3_frame *frame, uint16_t counter, int type, int command)
{
    ev3_begin(frame, counter, type);
    ev3_number(frame, (uint32_t)command, 1);
}

/* A whole number in its shortest encoding */
static inline void ev3_integer(ev3_frame *frame, int32_t value)
{
    const uint32_t bits = (uint32_t)value;
    const uint8_t lc0[] = {LC0(bits)}, lc1[] = {LC1(bits)}, lc2[] = {LC2(bits)}, lc4[] = {LC4(bits)};
    if (-32 <= value && value <= 31)
        ev3_raw(frame, lc0, sizeof lc0);
    else if (-127 <= value && value <= 127)
        ev3_raw(frame, lc1, sizeof lc1);
    else if (-32767 <= value && value <= 32767)
        ev3_raw(frame, lc2, sizeof lc2);
    else
        ev3_raw(frame, lc4, sizeof lc4);
}

/* The bits of a float; of all that are not a number, the one that the firmware knows */
static inline uint32_t ev3_float_bits(float value)
{
    uint32_t bits;
    if (value != value)
        return 0x7FC00000;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

/* One byte of a float, for LCF */
static inline uint8_t ev3_float_byte(double value, unsigned bits)
{
    return EV3_BYTE(ev3_float_bits((float)value), bits);
}

/* A float */
static inline void ev3_float(ev3_frame *frame, float value)
{
    const uint8_t lcf[] = {LC4(ev3_float_bits(value))};
    ev3_raw(frame, lcf, sizeof lcf);
}

/* A string */
static inline void ev3_string(ev3_frame *frame, const char *text)
{
    ev3_number(frame, LCS, 1);
    ev3_text(frame, text);
}

/* The local variable at an index, in its shortest encoding */
static inline void ev3_local(ev3_frame *frame, uint32_t index)
{
    const uint8_t lv0[] = {LV0(index)}, lv1[] = {LV1(index)}, lv2[] = {LV2(index)}, lv4[] = {LV4(index)};
    if (index <= 31)
        ev3_raw(frame, lv0, sizeof lv0);
    else if (index <= 0xFF)
        ev3_raw(frame, lv1, sizeof lv1);
    else if (index <= 0xFFFF)
        ev3_raw(frame, lv2, sizeof lv2);
    else
        ev3_raw(frame, lv4, sizeof lv4);
}

/* The same for a global variable, which the reply carries from byte 5 + index on */
static inline void ev3_global(ev3_frame *frame, uint32_t index)
{
    const uint8_t gv0[] = {GV0(index)}, gv1[] = {GV1(index)}, gv2[] = {GV2(index)}, gv4[] = {GV4(index)};
    if (index <= 31)
        ev3_raw(frame, gv0, sizeof gv0);
    else if (index <= 0xFF)
        ev3_raw(frame, gv1, sizeof gv1);
    else if (index <= 0xFFFF)
        ev3_raw(frame, gv2, sizeof gv2);
    else
        ev3_raw(frame, gv4, sizeof gv4);
}

/* Starts an operation without a CMD */
static inline void ev3_opcode(ev3_frame *frame, int opcode)
{
    ev3_number(frame, (uint32_t)opcode, 1);
}

/* Starts an operation that has a CMD */
static inline void ev3_operation(ev3_frame *frame, int opcode, int command)
{
    ev3_opcode(frame, opcode);
    ev3_integer(frame, command);
}

/* Writes the length field. Returns the bytes of the frame, 0 if something did not fit */
static inline size_t ev3_end(ev3_frame *frame)
{
    const size_t length = (size_t)(frame->size - 2);
    if (frame->full)
        return 0;
    frame->bytes[0] = EV3_BYTE(length, 0);
    frame->bytes[1] = EV3_BYTE(length, 8);
    return frame->size;
}

/* Reading a reply ------------------------------------------------------------------------------------------------ */

/*
 * Readers take the received bytes, from the length field on, and their count. A reader returns 0 if bytes that it needs
 * are missing, and then leaves its value unchanged.
 */

/* Bytes of the frame that starts here, by its length field; 0 if that is missing */
static inline size_t ev3_size(const uint8_t *bytes, size_t count)
{
    return count < 2 ? 0 : (size_t)(bytes[0] | bytes[1] << 8) + 2;
}

/* The message counter, which is that of the command */
static inline int ev3_counter(const uint8_t *bytes, size_t count, uint16_t *counter)
{
    if (count < 5)
        return 0;
    *counter = (uint16_t)(bytes[2] | bytes[3] << 8);
    return 1;
}

/* The type: DIRECT_REPLY, DIRECT_REPLY_ERROR, SYSTEM_REPLY, ...; -1 if it is missing */
static inline int ev3_type(const uint8_t *bytes, size_t count)
{
    return count < 5 ? -1 : bytes[5 - 1];
}

/* The status of the reply to a system command, such as SYSTEM_SUCCESS; -1 if it is missing */
static inline int ev3_status(const uint8_t *bytes, size_t count)
{
    return count < 5 + 2 ? -1 : bytes[5 + 1];
}

/* The bytes of a value in global memory, from an index on; NULL if the reply does not have them */
static inline const uint8_t *ev3_memory(const uint8_t *bytes, size_t count, size_t index, size_t wanted)
{
    const size_t end = ev3_size(bytes, count) < count ? ev3_size(bytes, count) : count;
    if (end < 5 || index > end - 5 || wanted > end - 5 - index)
        return NULL;
    return bytes + 5 + index;
}

/* The value that an operation wrote to GV(index): a number of 8, 16 or 32 bits, or a float */
static inline int ev3_reply8(const uint8_t *bytes, size_t count, size_t index, int8_t *value)
{
    const uint8_t *found = ev3_memory(bytes, count, index, 1);
    if (found != NULL)
        memcpy(value, found, 1);
    return found != NULL;
}

static inline int ev3_reply16(const uint8_t *bytes, size_t count, size_t index, int16_t *value)
{
    const uint8_t *found = ev3_memory(bytes, count, index, 2);
    uint16_t bits;
    if (found == NULL)
        return 0;
    bits = (uint16_t)(found[0] | found[1] << 8);
    memcpy(value, &bits, sizeof bits);
    return 1;
}

static inline int ev3_reply32(const uint8_t *bytes, size_t count, size_t index, int32_t *value)
{
    const uint8_t *found = ev3_memory(bytes, count, index, 4);
    uint32_t bits;
    if (found == NULL)
        return 0;
    bits = (uint32_t)found[0] | (uint32_t)found[1] << 8 | (uint32_t)found[2] << 16 | (uint32_t)found[3] << 24;
    memcpy(value, &bits, sizeof bits);
    return 1;
}

static inline int ev3_replyf(const uint8_t *bytes, size_t count, size_t index, float *value)
{
    int32_t bits = 0;
    if (!ev3_reply32(bytes, count, index, &bits))
        return 0;
    memcpy(value, &bits, sizeof bits);
    return 1;
}

#endif /* EV3PROTO_H */
