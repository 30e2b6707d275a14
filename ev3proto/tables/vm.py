"""The virtual machine itself: programs, objects, calls, breakpoints, brick settings, strings, factory tests.

Most serve compiled programs; direct commands mainly use program control, INFO, STRINGS and TST.
"""

from ev3proto.tables.declaration import (
    ARRAY_TYPED,
    DATA8,
    DATA16,
    DATA32,
    DATAF,
    EXTENSIONS,
    LABEL,
    STRING,
    Command,
    Count,
    Direction,
    Effect,
    In,
    Opcode,
    Out,
    Role,
)
from ev3proto.tables.enumerations import OBJSTAT, RESULT, SLOT

PRGID = In("PRGID", DATA16, "program slot", enum=SLOT)
OBJID = In("OBJID", DATA16, "object of the program, counted from 1", role=Role.OBJECT)
SOURCE1 = In("SOURCE1", STRING, "text to work on")
NUMBER_TEXT = Out("DESTINATION", STRING, "resulting text, zero-terminated", most=129)
DESTINATION = Out("DESTINATION", STRING, "resulting text, zero-terminated")
PORT = In("PORT", DATA8, "sensor port minus one", range=(0, 3), role=Role.PORT)
PINS_PORT = In("PORT", DATA8, "connector: 0..3 are sensor ports 1-4, 16..19 are motor ports A-D", range=(0, 19))
LAYER_OUT = Out("Layer", DATA8, "position in the daisy chain", range=(0, 3), special={0: "this brick"})
VM_NAMES = {0: "RobotC", 1: "LabVIEW"}


def _dynload_entries(numbers: tuple[int, ...]) -> tuple[Opcode, ...]:
    """Builds the entry points of a loaded virtual machine, which differ only in their number."""
    return tuple(
        Opcode(
            number,
            f"DYNLOAD_ENTRY_{entry}",
            f"Calls entry point {entry} of the additional virtual machine that is loaded",
            (
                In("CMD", DATA8, "function to call, in that machine's numbering"),
                In("LENGTH_IN", DATA8, "amount of data passed"),
                Out("LENGTH_OUT", DATA16, "number of elements returned"),
                Out("VALUE", ARRAY_TYPED, "the returned elements; their type depends on CMD", length="LENGTH_OUT"),
            ),
            effects=(Effect.CONTROLS_PROGRAMS,),
            dialects=EXTENSIONS,
        )
        for entry, number in enumerate(numbers)
    )


VM = (
    Opcode(0x00, "ERROR", "Ends the program with a failure; never valid on the wire", effects=(Effect.NEVER_RUNS,)),
    Opcode(0x01, "NOP", "Does nothing; a harmless way to test whether the brick answers", effects=(Effect.READS,)),
    Opcode(
        0x02,
        "PROGRAM_STOP",
        "Stops the program of a slot",
        (
            In(
                "PRGID",
                DATA16,
                "program slot to stop",
                enum=SLOT,
                special={0: "all programs", -1: "the calling program"},
            ),
        ),
        effects=(Effect.MAY_END, Effect.CONTROLS_PROGRAMS),
        sentence="stops the program in slot {PRGID}",
        words="abort kill",
    ),
    Opcode(
        0x03,
        "PROGRAM_START",
        "Starts a loaded program; a direct command can do this only while no user program runs",
        (
            PRGID,
            In("SIZE", DATA32, "size of the image; read and ignored", unit="bytes"),
            In("IP", DATA32, "address of the image, as FILE.LOAD_IMAGE returned it", role=Role.ADDRESS),
            In("DEBUG", DATA8, "how to run it", range=(0, 2), special={0: "run", 1: "debug", 2: "load, do not run"}),
        ),
        effects=(Effect.CONTROLS_PROGRAMS,),
        sentence="starts the program in slot {PRGID}",
        words="run launch",
    ),
    Opcode(
        0x04,
        "OBJECT_STOP",
        "Stops an object of its own program",
        (OBJID,),
        effects=(Effect.MAY_END, Effect.OF_PROGRAMS),
    ),
    Opcode(0x05, "OBJECT_START", "Starts an object of its own program", (OBJID,), effects=(Effect.OF_PROGRAMS,)),
    Opcode(
        0x06,
        "OBJECT_TRIG",
        "Counts an object's trigger down; at zero the object starts",
        (OBJID,),
        effects=(Effect.OF_PROGRAMS,),
    ),
    Opcode(
        0x07,
        "OBJECT_WAIT",
        "Waits until an object has ended",
        (OBJID,),
        effects=(Effect.WAITS, Effect.OF_PROGRAMS),
    ),
    Opcode(
        0x08,
        "RETURN",
        "Returns from a subroutine to its caller",
        effects=(Effect.ENDS, Effect.OF_PROGRAMS),
    ),
    Opcode(
        0x09,
        "CALL",
        "Calls a subroutine of its own program; waits while another thread runs it",
        (
            In("OBJID", DATA16, "object number of the subroutine, counted from 1", role=Role.OBJECT),
            Count(
                "PARAMETERS",
                "number of parameters follow; the subroutine declares their types and directions",
                element=DATA32,
                elements=Direction.IN,
                each="parameter of the subroutine",
                any_type=True,
            ),
        ),
        effects=(Effect.WAITS, Effect.OF_PROGRAMS),
    ),
    Opcode(
        0x0A,
        "OBJECT_END",
        "Ends the object; the firmware appends one to every direct command",
        effects=(Effect.ENDS, Effect.ENDS_CODE, Effect.COMPUTES),
    ),
    Opcode(0x0B, "SLEEP", "Gives up the rest of the thread's time slice", effects=(Effect.COMPUTES,)),
    Opcode(
        0x0C,
        "PROGRAM_INFO",
        "Asks about a program or controls its objects",
        commands=(
            Command(
                0,
                "OBJ_STOP",
                "Stops an object of a running program",
                (PRGID, OBJID),
                effects=(Effect.CONTROLS_PROGRAMS,),
            ),
            Command(
                4,
                "OBJ_START",
                "Starts an object of a running program from its beginning",
                (PRGID, OBJID),
                effects=(Effect.CONTROLS_PROGRAMS,),
            ),
            Command(
                22,
                "GET_STATUS",
                "Asks whether a program runs",
                (PRGID, Out("DATA", DATA8, "state of the program", enum=OBJSTAT)),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                23,
                "GET_SPEED",
                "Asks for a program's speed",
                (PRGID, Out("DATA", DATA32, "speed since the program started", unit="instructions/s")),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                24,
                "GET_PRGRESULT",
                "Asks how a program ended",
                (PRGID, Out("DATA", DATA8, "OK, BUSY (still running) or FAIL", enum=RESULT)),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                25,
                "SET_INSTR",
                "Sets how many instructions the calling thread may still run in its time slice",
                (PRGID,),
                note=(
                    "The 2013 virtual machine reads a second 16-bit value, the number of instructions, after PRGID; "
                    "its validator and other published tables have only PRGID."
                ),
                effects=(Effect.CONTROLS_PROGRAMS, Effect.FAILS),
            ),
            Command(
                26,
                "GET_PRGNAME",
                "Asks for the name of a program",
                (
                    PRGID,
                    Out(
                        "NAME",
                        STRING,
                        "name of the program, zero-terminated",
                        note="Other tables say PAR8, which is the first character of the text.",
                    ),
                ),
                dialects=EXTENSIONS,
                effects=(Effect.COMPUTES,),
            ),
        ),
    ),
    Opcode(
        0x0D,
        "LABEL",
        "Marks a place that jumps can name; does nothing itself",
        (In("NO", LABEL, "number of the label", range=(0, 31), role=Role.LABEL),),
        effects=(Effect.COMPUTES,),
    ),
    Opcode(
        0x0E,
        "PROBE",
        "Prints a program's memory on the brick's debug terminal",
        (
            PRGID,
            In("OBJID", DATA16, "object whose local memory to print", special={0: "the global memory"}),
            In("OFFSET", DATA32, "first byte", unit="bytes"),
            In(
                "SIZE",
                DATA32,
                "number of bytes to print",
                unit="bytes",
                range=(0, 1024),
                special={0: "all, 1024 at most"},
            ),
        ),
    ),
    Opcode(
        0x0F,
        "DO",
        "Runs byte code that is already in memory, ending the slot's previous program",
        (
            PRGID,
            In("IMAGE", DATA32, "address of the byte code image"),
            In("GLOBAL", DATA32, "address of the global memory it uses"),
        ),
        effects=(Effect.CONTROLS_PROGRAMS, Effect.FAILS),
    ),
    Opcode(
        0x60,
        "SYSTEM",
        "Runs a shell command on the brick's Linux and waits until it ends",
        (
            In("COMMAND", STRING, "the command line"),
            Out(
                "STATUS",
                DATA32,
                "wait status as C's system() gives it: 256 times the exit code",
                special={0: "success", -1: "could not run"},
            ),
        ),
        effects=(Effect.WAITS, Effect.RUNS_SHELL),
    ),
    Opcode(
        0x61,
        "PORT_CNV_OUTPUT",
        "Splits a motor port number as LEGO's editor writes it",
        (
            In("PortIn", DATA32, "three decimal digits, each 1-4: layer, first port, second port (123: B and C)"),
            LAYER_OUT,
            Out("Bitfield", DATA8, "motor ports as bits: A=1 B=2 C=4 D=8", range=(0, 15)),
            Out(
                "Inverted",
                DATA8,
                "whether the first port comes after the second, as in CA",
                range=(0, 1),
                special={0: "no", 1: "yes"},
            ),
        ),
        effects=(Effect.READS,),
    ),
    Opcode(
        0x62,
        "PORT_CNV_INPUT",
        "Splits a sensor port number as LEGO's editor writes it",
        (
            In("PortIn", DATA32, "three decimal digits: layer 1-4, any, port 1-4 (103: port 3)"),
            LAYER_OUT,
            Out("PortOut", DATA8, "sensor port minus one, as in INPUT_*", range=(0, 3)),
        ),
        effects=(Effect.READS,),
    ),
    Opcode(
        0x63,
        "NOTE_TO_FREQ",
        "Converts the name of a note to its frequency",
        (
            In("NOTE", STRING, "C4 to B6, sharps as C#4"),
            Out("FREQ", DATA16, "frequency; 440 for an unknown note", unit="Hz", range=(262, 1976)),
        ),
        effects=(Effect.COMPUTES,),
    ),
    Opcode(
        0x7C,
        "INFO",
        "Reads and sets the error log, the volume and the time to power off",
        commands=(
            Command(
                1,
                "SET_ERROR",
                "Adds an error to the brick's error log",
                (In("NUMBER", DATA8, "number of the error", role=Role.ERROR, special={0: "nothing is logged"}),),
                effects=(Effect.CHANGES_SETTINGS,),
            ),
            Command(
                2,
                "GET_ERROR",
                "Removes and returns the oldest error of the brick's error log",
                (Out("NUMBER", DATA8, "number of the error", role=Role.ERROR, special={0: "the log is empty"}),),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                3,
                "ERRORTEXT",
                "Converts the number of an error to its name",
                (
                    In("NUMBER", DATA8, "number of the error", role=Role.ERROR, special={0: "gives an empty text"}),
                    In(
                        "LENGTH",
                        DATA8,
                        "size of the text buffer, including the zero",
                        unit="bytes",
                        special={-1: "no limit"},
                    ),
                    Out(
                        "DESTINATION",
                        STRING,
                        "name of the error, at most 31 characters",
                        length="LENGTH",
                        role=Role.PUBLIC,
                    ),
                ),
                effects=(Effect.READS,),
            ),
            Command(
                4,
                "GET_VOLUME",
                "Reads the volume setting",
                (Out("VALUE", DATA8, "volume", range=(0, 100), unit="%"),),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                5,
                "SET_VOLUME",
                "Changes the volume setting",
                (In("VALUE", DATA8, "volume", range=(0, 100), unit="%"),),
                effects=(Effect.CHANGES_SETTINGS,),
                sentence="sets the volume to {VALUE}",
            ),
            Command(
                6,
                "GET_MINUTES",
                "Reads the idle time after which the brick powers off",
                (Out("VALUE", DATA8, "idle time", range=(0, 120), unit="min", special={0: "never"}),),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                7,
                "SET_MINUTES",
                "Changes the idle time after which the brick powers off",
                (In("VALUE", DATA8, "idle time", range=(0, 120), unit="min", special={0: "never"}),),
                effects=(Effect.CHANGES_SETTINGS,),
                sentence="has the brick power off after {VALUE} without use",
            ),
        ),
    ),
    Opcode(
        0x7D,
        "STRINGS",
        "Works with texts: joins, compares, converts from and to numbers",
        commands=(
            Command(
                1,
                "GET_SIZE",
                "Reads the length of a text",
                (SOURCE1, Out("SIZE", DATA16, "its length, not including the zero", unit="bytes")),
                effects=(Effect.COMPUTES,),
            ),
            Command(
                2,
                "ADD",
                "Joins two texts",
                (In("SOURCE1", STRING, "first part"), In("SOURCE2", STRING, "second part"), DESTINATION),
                effects=(Effect.COMPUTES,),
            ),
            Command(
                3,
                "COMPARE",
                "Reports whether two texts are equal; case matters",
                (
                    In("SOURCE1", STRING, "one text"),
                    In("SOURCE2", STRING, "the other text"),
                    Out(
                        "RESULT", DATA8, "whether they are equal", range=(0, 1), special={0: "different", 1: "the same"}
                    ),
                ),
                effects=(Effect.COMPUTES,),
            ),
            Command(5, "DUPLICATE", "Copies a text", (SOURCE1, DESTINATION), effects=(Effect.COMPUTES,)),
            Command(
                6,
                "VALUE_TO_STRING",
                "Writes a floating-point number as text, without trailing zeros",
                (
                    In("VALUE", DATAF, "number to write; NaN becomes ----"),
                    In("FIGURES", DATA8, "width, including the point; negative aligns left", unit="characters"),
                    In("DECIMALS", DATA8, "digits after the point"),
                    NUMBER_TEXT,
                ),
                effects=(Effect.COMPUTES,),
            ),
            Command(
                7,
                "STRING_TO_VALUE",
                "Reads a number from a text",
                (
                    In("SOURCE1", STRING, "text to read; a comma counts as decimal point"),
                    Out("DESTINATION", DATAF, "the number"),
                ),
                effects=(Effect.COMPUTES,),
            ),
            Command(8, "STRIP", "Removes every space from a text", (SOURCE1, DESTINATION), effects=(Effect.COMPUTES,)),
            Command(
                9,
                "NUMBER_TO_STRING",
                "Writes a whole number as text, with leading zeros",
                (
                    In("VALUE", DATA16, "number to write"),
                    In("FIGURES", DATA8, "width of the text", unit="characters"),
                    NUMBER_TEXT,
                ),
                effects=(Effect.COMPUTES,),
            ),
            Command(
                10,
                "SUB",
                "Returns the part of a text after another text found in it",
                (
                    In("SOURCE1", STRING, "text to search"),
                    In("SOURCE2", STRING, "text to find; must occur"),
                    DESTINATION,
                ),
                effects=(Effect.COMPUTES,),
            ),
            Command(
                11,
                "VALUE_FORMATTED",
                "Writes a floating-point number as text in a format of C's printf",
                (
                    In("VALUE", DATAF, "number to write"),
                    In("FORMAT", STRING, "format, such as %5.2f", role=Role.FORMAT),
                    In("SIZE", DATA8, "size of the text buffer, including the zero", unit="bytes"),
                    Out("DESTINATION", STRING, "resulting text", length="SIZE"),
                ),
                effects=(Effect.COMPUTES,),
            ),
            Command(
                12,
                "NUMBER_FORMATTED",
                "Writes a whole number as text in a format of C's printf",
                (
                    In("VALUE", DATA32, "number to write"),
                    In("FORMAT", STRING, "format, such as %05d or %X", role=Role.FORMAT),
                    In("SIZE", DATA8, "size of the text buffer, including the zero", unit="bytes"),
                    Out("DESTINATION", STRING, "resulting text", length="SIZE"),
                ),
                effects=(Effect.COMPUTES,),
            ),
        ),
    ),
    Opcode(
        0x88,
        "BP0",
        "Stops at breakpoint 0; BP_SET puts it over the instruction it replaces",
        effects=(Effect.CONTROLS_PROGRAMS,),
    ),
    Opcode(
        0x89,
        "BP1",
        "Stops at breakpoint 1; BP_SET puts it over the instruction it replaces",
        effects=(Effect.CONTROLS_PROGRAMS,),
    ),
    Opcode(
        0x8A,
        "BP2",
        "Stops at breakpoint 2; BP_SET puts it over the instruction it replaces",
        effects=(Effect.CONTROLS_PROGRAMS,),
    ),
    Opcode(
        0x8B,
        "BP3",
        "Pulses test pin TP4 and continues; BP_SET puts it over the instruction it replaces",
        effects=(Effect.CONTROLS_PROGRAMS,),
    ),
    Opcode(
        0x8C,
        "BP_SET",
        "Sets or removes a breakpoint in a running program",
        (
            PRGID,
            In("NO", DATA8, "number of the breakpoint", range=(0, 2), special={3: "pulse on test pin TP4, no stop"}),
            In("ADDRESS", DATA32, "offset in the image", unit="bytes", special={0: "remove the breakpoint"}),
        ),
        effects=(Effect.CONTROLS_PROGRAMS,),
    ),
    Opcode(
        0xF0,
        "DYNLOAD_VMLOAD",
        "Loads an additional virtual machine; fails while another one is loaded",
        (
            In("VMINDEX", DATA8, "which one", range=(0, 1), special=VM_NAMES),
            Out("RESULT", DATA8, "OK or FAIL", enum=RESULT),
        ),
        effects=(Effect.CONTROLS_PROGRAMS,),
        dialects=EXTENSIONS,
    ),
    Opcode(
        0xF1,
        "DYNLOAD_VMEXIT",
        "Unloads the additional virtual machine",
        effects=(Effect.CONTROLS_PROGRAMS,),
        dialects=EXTENSIONS,
    ),
    *_dynload_entries((0xF2, 0xF3, 0xF4, 0xF5, 0xF6, 0xF7, 0xF8, 0xF9, 0xFA, 0xFB)),
    Opcode(
        0xFC,
        "DYNLOAD_GET_VM",
        "Asks which additional virtual machine is loaded",
        (Out("RESULT", DATA8, "which one", range=(0, 1), special={-1: "none", **VM_NAMES}),),
        dialects=EXTENSIONS,
    ),
    Opcode(
        0xFF,
        "TST",
        "Tests the hardware, as the factory does; all fail before TST_OPEN",
        commands=(
            Command(
                10,
                "TST_OPEN",
                "Allows test commands for 10 seconds; each one restarts the timer",
                effects=(Effect.WRITES_TO_DEVICES,),
            ),
            Command(11, "TST_CLOSE", "Ends the test mode", effects=(Effect.WRITES_TO_DEVICES,)),
            Command(
                12,
                "TST_READ_PINS",
                "Reads the pins of a connector",
                (
                    PINS_PORT,
                    In("LENGTH", DATA8, "number of pins to read, usually 5"),
                    Out("STRING", DATA8, "one character per pin: 0 low, 1 high", length="LENGTH"),
                ),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                13,
                "TST_WRITE_PINS",
                "Sets the pins of a connector",
                (
                    PINS_PORT,
                    In("LENGTH", DATA8, "number of pins to set, usually 5"),
                    In(
                        "STRING",
                        DATA8,
                        "one character per pin: 0 low, 1 high, X floating, - unchanged",
                        length="LENGTH",
                    ),
                ),
                effects=(Effect.WRITES_TO_DEVICES,),
            ),
            Command(
                14,
                "TST_READ_ADC",
                "Reads the analog converter",
                (
                    In(
                        "INDEX",
                        DATA8,
                        "channel: 0..3 pin 1 and 4..7 pin 6 of sensor ports, 8..11 pin 5 of motor ports",
                        range=(0, 15),
                        special={
                            12: "battery temperature",
                            13: "motor current",
                            14: "battery current",
                            15: "battery voltage",
                        },
                    ),
                    Out("VALUE", DATA16, "raw reading", range=(0, 4095), unit="counts"),
                ),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                15,
                "TST_WRITE_UART",
                "Sends bytes on a sensor port's serial line",
                (
                    PORT,
                    In("LENGTH", DATA8, "number of bytes to send", unit="bytes", range=(0, 63)),
                    In("STRING", DATA8, "the bytes", length="LENGTH"),
                ),
                effects=(Effect.WRITES_TO_DEVICES,),
            ),
            Command(
                16,
                "TST_READ_UART",
                "Reads the bytes received on a sensor port's serial line",
                (
                    PORT,
                    In("LENGTH", DATA8, "number of bytes to read", unit="bytes", range=(0, 63)),
                    Out("STRING", DATA8, "the bytes, padded with zeros", length="LENGTH"),
                ),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                17,
                "TST_ENABLE_UART",
                "Switches the serial lines of all sensor ports on",
                (In("BITRATE", DATA32, "speed of the line", range=(2400, 115200), unit="bit/s"),),
                effects=(Effect.WRITES_TO_DEVICES,),
            ),
            Command(
                18,
                "TST_DISABLE_UART",
                "Switches the serial lines of all sensor ports off",
                effects=(Effect.WRITES_TO_DEVICES,),
            ),
            Command(
                19,
                "TST_ACCU_SWITCH",
                "Reads the switch that senses the rechargeable battery",
                (
                    Out(
                        "ACTIVE",
                        DATA8,
                        "state of the switch",
                        range=(0, 1),
                        special={0: "other batteries", 1: "rechargeable battery"},
                    ),
                ),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                20,
                "TST_BOOT_MODE2",
                "Starts Bluetooth mode 2, for Apple devices",
                effects=(Effect.WRITES_TO_DEVICES,),
            ),
            Command(
                21,
                "TST_POLL_MODE2",
                "Asks for the state of the start of Bluetooth mode 2",
                (Out("STATUS", DATA8, "OK, BUSY (still starting) or FAIL", range=(0, 2), enum=RESULT),),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(22, "TST_CLOSE_MODE2", "Ends Bluetooth mode 2", effects=(Effect.WRITES_TO_DEVICES,)),
            Command(
                23,
                "TST_RAM_CHECK",
                "Asks for the result of the memory test at power-on",
                (Out("STATUS", DATA8, "OK or FAIL", range=(0, 2), enum=RESULT),),
                effects=(Effect.COMPUTES,),
            ),
        ),
        cmd_table="INFO",
    ),
)
