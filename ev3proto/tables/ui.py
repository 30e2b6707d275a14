"""The user interface: display, buttons, lights, debug terminal, battery and other state.

Drawing goes to a canvas that UI_DRAW.UPDATE makes visible. Dialogues (NOTIFICATION, QUESTION, KEYBOARD, BROWSE,
TEXTBOX, ...) keep the program or direct command waiting until a button is pressed.
"""

from ev3proto.tables import paths
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.declaration import (
    DATA8,
    DATA16,
    DATA32,
    DATAF,
    EXTENSIONS,
    STRING,
    Command,
    Effect,
    In,
    InOut,
    Opcode,
    Out,
    Parameter,
    Role,
)
from ev3proto.tables.enumerations import (
    BROWSERTYPE,
    BUTTONTYPE,
    DEL,
    FILETYPE,
    FONTTYPE,
    ICONTYPE,
    L_ICON_NO,
    LEDPATTERN,
    N_ICON_NO,
    WARNING,
)

NO_YES = {0: "no", 1: "yes"}

LENGTH = In("LENGTH", DATA8, "maximum number of bytes to return, including the zero", range=(0, 127), unit="bytes")
LENGTH_OR_ALL = In(
    "LENGTH",
    DATA8,
    "maximum number of bytes to return, including the zero",
    range=(0, 127),
    unit="bytes",
    special={-1: "no limit"},
)

BUTTON = In("BUTTON", DATA8, "which button", enum=BUTTONTYPE)
IS_DOWN = Out("STATE", DATA8, "whether the button is down", range=(0, 1), special=NO_YES)
WAS_PRESSED = Out("STATE", DATA8, "whether the button was pressed", range=(0, 1), special=NO_YES)
WAS_HELD = Out("STATE", DATA8, "whether the button was held for 3 s", range=(0, 1), special=NO_YES)
WAS_BUMPED = Out("STATE", DATA8, "whether the button was pressed and released", range=(0, 1), special=NO_YES)

FIGURES = In("FIGURES", DATA8, "total number of characters, including the decimal point")
FIGURES_SIGNED = In("FIGURES", DATA8, "total number of characters, including the decimal point; negative aligns left")
DECIMALS = In("DECIMALS", DATA8, "digits after the decimal point")

COLORS = {name: int(CONSTANTS[name]) for name in ("FG_COLOR", "BG_COLOR")}
COLOR = In("COLOR", DATA8, "colour to draw in", range=(0, 1), special={0: "white", 1: "black"}, names=COLORS)
X0 = In("X0", DATA16, "left edge", range=(0, 177), unit="px")
Y0 = In("Y0", DATA16, "top edge", range=(0, 127), unit="px")
WIDTH = In("X1", DATA16, "width", range=(0, 178), unit="px")
HEIGHT = In("Y1", DATA16, "height", range=(0, 128), unit="px")
X_START = In("X0", DATA16, "column of the start", range=(0, 177), unit="px")
Y_START = In("Y0", DATA16, "row of the start", range=(0, 127), unit="px")
X_END = In("X1", DATA16, "column of the end", range=(0, 178), unit="px")
Y_END = In("Y1", DATA16, "row of the end", range=(0, 128), unit="px")
X_CENTRE = In("X0", DATA16, "column of the centre", range=(0, 177), unit="px")
Y_CENTRE = In("Y0", DATA16, "row of the centre", range=(0, 127), unit="px")
RADIUS = In("R", DATA16, "radius", unit="px", special={0: "draws nothing"})

NO_ICON = {"ICON_NONE": N_ICON_NO.members["ICON_NONE"]}
ICON1 = In("ICON1", DATA8, "first large icon", enum=L_ICON_NO, special={-1: "none"}, names=NO_ICON)
ICON2 = In("ICON2", DATA8, "second large icon", enum=L_ICON_NO, special={-1: "none"}, names=NO_ICON)
ICON3 = In("ICON3", DATA8, "third large icon", enum=L_ICON_NO, special={-1: "none"}, names=NO_ICON)
DIALOGUE_STATE = InOut(
    "STATE",
    DATA8,
    "variable for the dialogue's progress; must be 0 at first",
    range=(0, 1),
    special={0: "start, or done", 1: "being shown"},
    note="the firmware writes it at each step; its documentation lists it among the inputs",
)

STORED_SCREEN = In("NO", DATA8, "slot for one screen; 0 holds the screen from before the program ran", range=(0, 2))

TEXT = In(
    "TEXT",
    STRING,
    "whole text of the box, its lines separated by DEL",
    note="published as one DATA8; the firmware reads a string there",
)
SIZE = In("SIZE", DATA32, "size of the box's text buffer, including the zero", unit="bytes")
DELIMITER = In("DEL", DATA8, "what separates the lines", enum=DEL)

STATE_PRESENT = Out("STATE", DATA8, "whether one is present", range=(0, 1), special={0: "absent", 1: "present"})
TOTAL = Out("TOTAL", DATA32, "size", unit="KiB")
FREE = Out("FREE", DATA32, "free space", unit="KiB")


def _version(text: str) -> tuple[Parameter, ...]:
    """Builds the parameters of a command that only returns a version."""
    return (LENGTH_OR_ALL, Out("DESTINATION", STRING, text, length="LENGTH", role=Role.PUBLIC))


UI = (
    Opcode(0x80, "UI_FLUSH", "Sends the contents of the terminal's output buffer", effects=(Effect.PRINTS,)),
    Opcode(
        0x81,
        "UI_READ",
        "Reads the state of the brick or what the terminal received",
        commands=(
            Command(
                1,
                "GET_VBATT",
                "Reads the battery voltage",
                (Out("VALUE", DATAF, "voltage", unit="V"),),
                effects=(Effect.VARIES, Effect.READS),
                words="battery",
            ),
            Command(
                2,
                "GET_IBATT",
                "Reads the battery current",
                (Out("VALUE", DATAF, "current", unit="A"),),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                3,
                "GET_OS_VERS",
                "Reads name and version of the operating system",
                _version("system and kernel release, such as Linux 2.6.33-rc4"),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                4,
                "GET_EVENT",
                "Reads and clears the pending event (used by the brick's own menus)",
                (
                    Out(
                        "EVENT",
                        DATA8,
                        "what happened",
                        special={
                            0: "nothing",
                            1: "Bluetooth asks for a PIN",
                            2: "Bluetooth asks to confirm a connection",
                        },
                    ),
                ),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                5,
                "GET_TBATT",
                "Reads the rise in battery temperature, estimated from the current",
                (Out("VALUE", DATAF, "estimated rise in temperature", unit="°C"),),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                6,
                "GET_IINT",
                "Reads the battery current smoothed over time",
                (Out("IINT", DATAF, "integrated current", unit="A"),),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                7,
                "GET_IMOTOR",
                "Reads the current of all motors together",
                (Out("VALUE", DATAF, "current", unit="A"),),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                8,
                "GET_STRING",
                "Waits for a line typed at the terminal and reads it",
                (
                    In(
                        "LENGTH",
                        DATA8,
                        "maximum number of bytes to return, not including the zero",
                        range=(0, 127),
                        unit="bytes",
                    ),
                    Out("DESTINATION", STRING, "the line", length="LENGTH"),
                ),
                effects=(Effect.WAITS, Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                9,
                "GET_HW_VERS",
                "Reads the hardware version",
                _version("hardware version, such as V0.60"),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                10,
                "GET_FW_VERS",
                "Reads the firmware version",
                _version("firmware version, such as V1.04H"),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                11,
                "GET_FW_BUILD",
                "Reads the build time of the firmware",
                _version("build time as yymmddhhmm"),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                12,
                "GET_OS_BUILD",
                "Reads the build time of the operating system",
                _version("build time as yymmddhhmm"),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                13,
                "GET_ADDRESS",
                "Waits for a decimal number typed at the terminal and reads it (debugging)",
                (Out("VALUE", DATA32, "the number, meant as an address"),),
                effects=(Effect.WAITS, Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                14,
                "GET_CODE",
                "Waits for byte code typed as hex at the terminal and builds a program from it (debugging)",
                (
                    In("LENGTH", DATA32, "maximum number of bytes of the program, including headers", unit="bytes"),
                    In(
                        "IMAGE",
                        DATA32,
                        "address of the memory where the program is built",
                        note="the firmware reads the address; its documentation lists it among the outputs",
                    ),
                    Out("GLOBAL", DATA32, "address of the program's global variables"),
                    Out("FLAG", DATA8, "whether the program can be started; 1 or unchanged", special={1: "ready"}),
                ),
                effects=(Effect.WAITS, Effect.VARIES),
            ),
            Command(
                15,
                "KEY",
                "Takes one key from the terminal without waiting",
                (Out("VALUE", DATA8, "character code of the key", special={0: "no key"}),),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                16,
                "GET_SHUTDOWN",
                "Reads and clears the request to shut down (used by the brick's own menus)",
                (Out("FLAG", DATA8, "whether the brick wants to shut down", range=(0, 1), special=NO_YES),),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                17,
                "GET_WARNING",
                "Reads the brick's warnings",
                (Out("WARNINGS", DATA8, "one bit for each warning", enum=WARNING, special={0: "none"}),),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                18,
                "GET_LBATT",
                "Reads the battery level, derived from its voltage",
                (Out("PCT", DATA8, "battery level", range=(0, 100), unit="%"),),
                effects=(Effect.VARIES, Effect.READS),
                words="battery",
            ),
            Command(
                21,
                "TEXTBOX_READ",
                "Reads one line of the text of a text box",
                (
                    TEXT,
                    SIZE,
                    DELIMITER,
                    LENGTH_OR_ALL,
                    In("LINE", DATA16, "which line, counted from 1"),
                    Out(
                        "DESTINATION",
                        STRING,
                        "the line, empty if there is no such line",
                        length="LENGTH",
                        note="published as an input DATA8; the firmware writes a string there",
                    ),
                ),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                26,
                "GET_VERSION",
                "Reads name, version and build date of the firmware in one string",
                _version("such as LMS2012 V1.04H(Jul 26 2013 12:00:00)"),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                27,
                "GET_IP",
                "Reads the brick's IP address",
                (
                    LENGTH_OR_ALL,
                    Out("DESTINATION", STRING, "address in dotted notation", length="LENGTH"),
                ),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                29,
                "GET_POWER",
                "Reads all values of the power supply at once",
                (
                    Out("VBATT", DATAF, "battery voltage", unit="V"),
                    Out("IBATT", DATAF, "battery current", unit="A"),
                    Out("IINT", DATAF, "battery current smoothed over time", unit="A"),
                    Out("IMOTOR", DATAF, "current of all motors together", unit="A"),
                ),
                newer=True,
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                30,
                "GET_SDCARD",
                "Reads whether an SD card is present, and its space",
                (STATE_PRESENT, TOTAL, FREE),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                31,
                "GET_USBSTICK",
                "Reads whether a USB stick is present, and its space",
                (STATE_PRESENT, TOTAL, FREE),
                effects=(Effect.VARIES, Effect.READS),
            ),
        ),
    ),
    Opcode(
        0x82,
        "UI_WRITE",
        "Writes to the terminal or sets lights and states of the brick",
        commands=(
            Command(
                1,
                "WRITE_FLUSH",
                "Sends the contents of the terminal's output buffer, like UI_FLUSH",
                effects=(Effect.PRINTS,),
            ),
            Command(
                2,
                "FLOATVALUE",
                "Writes a number in a fixed format to the terminal",
                (In("VALUE", DATAF, "number to write"), FIGURES_SIGNED, DECIMALS),
                effects=(Effect.PRINTS,),
            ),
            Command(
                3,
                "STAMP",
                "Writes time, program, object, position and a comment to the terminal",
                (
                    In(
                        "VALUE",
                        STRING,
                        "remark",
                        note="published as DATA8; the firmware prints a string from there",
                    ),
                ),
                effects=(Effect.PRINTS,),
            ),
            Command(
                8,
                "PUT_STRING",
                "Writes text to the terminal",
                (In("STRING", STRING, "text to write"),),
                effects=(Effect.PRINTS,),
            ),
            Command(
                9,
                "VALUE8",
                "Writes a whole number to the terminal",
                (In("VALUE", DATA8, "number to write"),),
                effects=(Effect.PRINTS,),
            ),
            Command(
                10,
                "VALUE16",
                "Writes an unsigned whole number to the terminal",
                (In("VALUE", DATA16, "number to write", unsigned=True),),
                effects=(Effect.PRINTS,),
            ),
            Command(
                11,
                "VALUE32",
                "Writes a whole number to the terminal",
                (In("VALUE", DATA32, "number to write"),),
                effects=(Effect.PRINTS,),
            ),
            Command(
                12,
                "VALUEF",
                "Writes a number to the terminal",
                (In("VALUE", DATAF, "number to write"),),
                effects=(Effect.PRINTS,),
            ),
            Command(
                13,
                "ADDRESS",
                "Not implemented in the firmware: the program that runs it fails",
                (Out("VALUE", DATA32, "address; never written"),),
                effects=(Effect.FAILS,),
                newer=True,
            ),
            Command(
                14,
                "CODE",
                "Writes bytes of memory as hex to the terminal",
                (
                    In(
                        "ARRAY",
                        DATA32,
                        "address of the bytes",
                        validated=DATA8,
                        note="documented as the first byte of an array; the firmware takes the value as an address",
                    ),
                    In("LENGTH", DATA32, "number of bytes", unit="bytes"),
                ),
                effects=(Effect.FAILS,),
            ),
            Command(
                15,
                "DOWNLOAD_END",
                "Plays the sound of a finished download and refreshes the file browser",
                effects=(Effect.SIGNALS,),
            ),
            Command(
                16,
                "SCREEN_BLOCK",
                "Blocks or unblocks the display and the buttons for programs",
                (
                    In(
                        "STATUS",
                        DATA8,
                        "whether drawing is ignored",
                        range=(0, 1),
                        special={0: "normal", 1: "blocked"},
                    ),
                ),
                effects=(Effect.CHANGES_SETTINGS,),
            ),
            Command(
                17,
                "ALLOW_PULSE",
                "Selects the debug pulses that are shown (only in debug builds of the firmware)",
                (In("VALUE", DATA8, "sum of bits", special={1: "menu background", 2: "browser", 4: "key"}),),
                newer=True,
                effects=(Effect.FAILS, Effect.SIGNALS),
            ),
            Command(
                18,
                "SET_PULSE",
                "Raises debug pulses (only in debug builds of the firmware)",
                (In("VALUE", DATA8, "sum of bits", special={1: "menu background", 2: "browser", 4: "key"}),),
                newer=True,
                effects=(Effect.FAILS, Effect.SIGNALS),
            ),
            Command(
                21,
                "TEXTBOX_APPEND",
                "Appends a line to the text of a text box",
                (
                    InOut(
                        "TEXT",
                        STRING,
                        "whole text of the box, its lines separated by DEL",
                        length="SIZE",
                        note="the firmware appends in place; its documentation lists it among the inputs",
                    ),
                    SIZE,
                    DELIMITER,
                    In("SOURCE", STRING, "line to append"),
                ),
                effects=(Effect.COMPUTES,),
            ),
            Command(
                22,
                "SET_BUSY",
                "Sets or clears the busy bit among the warnings",
                (In("VALUE", DATA8, "whether the brick counts as busy", range=(0, 1), special=NO_YES),),
                effects=(Effect.CHANGES_SETTINGS,),
            ),
            Command(
                24,
                "SET_TESTPIN",
                "Sets the test pin on the brick's circuit board",
                (In("STATE", DATA8, "level of the pin", range=(0, 1), special={0: "low", 1: "high"}),),
                effects=(Effect.WRITES_TO_DEVICES,),
            ),
            Command(
                25,
                "INIT_RUN",
                "Shows the animation of a running program until something draws",
                effects=(Effect.PRINTS,),
            ),
            Command(26, "UPDATE_RUN", "Does nothing", effects=(Effect.PRINTS,)),
            Command(
                27,
                "LED",
                "Sets colour and blinking of the light around the buttons",
                (In("PATTERN", DATA8, "colour and rhythm", enum=LEDPATTERN),),
                effects=(Effect.SIGNALS,),
                sentence="sets the light around the buttons to {PATTERN}",
                words="light lamp",
            ),
            Command(
                29,
                "POWER",
                "Sets the flag that makes the power driver switch off when the firmware ends",
                (In("VALUE", DATA8, "the flag", range=(0, 1)),),
                effects=(Effect.CHANGES_SETTINGS,),
            ),
            Command(
                30, "GRAPH_SAMPLE", "Adds the current values to the graph of GRAPH_SETUP", effects=(Effect.PRINTS,)
            ),
            Command(
                31,
                "TERMINAL",
                "Switches the debug terminal on or off",
                (In("STATE", DATA8, "whether the terminal is on", range=(0, 1), special={0: "off", 1: "on"}),),
                effects=(Effect.CHANGES_SETTINGS,),
            ),
        ),
    ),
    Opcode(
        0x83,
        "UI_BUTTON",
        "Reads or simulates the buttons",
        commands=(
            Command(
                1,
                "SHORTPRESS",
                "Reports whether a button was pressed since the last query, and clears the press",
                (BUTTON, WAS_PRESSED),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                2,
                "LONGPRESS",
                "Reports whether a button was held for 3 s since the last query, and clears it",
                (BUTTON, WAS_HELD),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                3,
                "WAIT_FOR_PRESS",
                "Waits until any button has been pressed, by hand or by PRESS",
                effects=(Effect.WAITS, Effect.COMPUTES),
            ),
            Command(4, "FLUSH", "Clears all pending presses", effects=(Effect.COMPUTES,)),
            Command(
                5,
                "PRESS",
                "Presses a button as if by hand and holds it until RELEASE",
                (BUTTON,),
                effects=(Effect.PRESSES_BUTTONS,),
            ),
            Command(6, "RELEASE", "Releases a button that PRESS holds", (BUTTON,), effects=(Effect.PRESSES_BUTTONS,)),
            Command(
                7,
                "GET_HORZ",
                "Reads the left and right buttons as one axis, and clears their presses",
                (
                    Out(
                        "VALUE",
                        DATA16,
                        "direction",
                        range=(-1, 1),
                        special={-1: "left", 1: "right", 0: "not pressed"},
                    ),
                ),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                8,
                "GET_VERT",
                "Reads the up and down buttons as one axis, and clears their presses",
                (Out("VALUE", DATA16, "direction", range=(-1, 1), special={-1: "up", 1: "down", 0: "not pressed"}),),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                9,
                "PRESSED",
                "Reports whether a button is down at the moment",
                (BUTTON, IS_DOWN),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                10,
                "SET_BACK_BLOCK",
                "Blocks or unblocks the back button, which ends the running program",
                (
                    In(
                        "BLOCKED",
                        DATA8,
                        "whether the back button is blocked",
                        range=(0, 1),
                        special={0: "not blocked", 1: "blocked"},
                    ),
                ),
                effects=(Effect.CHANGES_SETTINGS,),
            ),
            Command(
                11,
                "GET_BACK_BLOCK",
                "Reports whether the back button is blocked",
                (
                    Out(
                        "BLOCKED",
                        DATA8,
                        "whether the back button is blocked",
                        range=(0, 1),
                        special={0: "not blocked", 1: "blocked"},
                    ),
                ),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                12,
                "TESTSHORTPRESS",
                "Reports, like SHORTPRESS, whether a button was pressed, without clearing the press",
                (BUTTON, WAS_PRESSED),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                13,
                "TESTLONGPRESS",
                "Reports, like LONGPRESS, whether a button was held for 3 s, without clearing it",
                (BUTTON, WAS_HELD),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                14,
                "GET_BUMBED",
                "Reports whether a button was pressed and released since the last query, and clears it",
                (BUTTON, WAS_BUMPED),
                dialects=("official", "xtended"),
                note="spelling of LEGO's headers; lms2012-compat says GET_BUMPED",
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                14,
                "GET_BUMPED",
                "Reports whether a button was pressed and released since the last query, and clears it",
                (BUTTON, WAS_BUMPED),
                dialects=("compat",),
                note="GET_BUMBED in LEGO's headers",
                effects=(Effect.COMPUTES,),
            ),
            Command(
                15,
                "GET_CLICK",
                "Reports whether a key click is due for a handled press, and clears it",
                (Out("CLICK", DATA8, "whether a click is due", range=(0, 1), special=NO_YES),),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
        ),
    ),
    Opcode(
        0x84,
        "UI_DRAW",
        "Draws on the canvas of the display, or runs a dialogue on it",
        commands=(
            Command(
                0,
                "UPDATE",
                "Shows on the display what has been drawn, and restores the normal font",
                effects=(Effect.SHOWS,),
                sentence="shows on the display what has been drawn",
                words="screen refresh",
            ),
            Command(
                1,
                "CLEAN",
                "Clears the canvas to white, and restores the normal font",
                effects=(Effect.DRAWS, Effect.WIPES),
                sentence="clears the canvas",
            ),
            Command(
                2,
                "PIXEL",
                "Draws one pixel",
                (
                    COLOR,
                    In("X0", DATA16, "column", range=(0, 177), unit="px"),
                    In("Y0", DATA16, "row", range=(0, 127), unit="px"),
                ),
                effects=(Effect.DRAWS,),
                sentence="draws a {COLOR} pixel at ({X0}, {Y0})",
            ),
            Command(
                3,
                "LINE",
                "Draws a line between two points",
                (COLOR, X_START, Y_START, X_END, Y_END),
                effects=(Effect.DRAWS,),
                sentence="draws a {COLOR} line from ({X0}, {Y0}) to ({X1}, {Y1})",
            ),
            Command(
                4,
                "CIRCLE",
                "Draws a circle",
                (COLOR, X_CENTRE, Y_CENTRE, RADIUS),
                effects=(Effect.DRAWS,),
                sentence="draws a {COLOR} circle around ({X0}, {Y0}) with radius {R}",
            ),
            Command(
                5,
                "TEXT",
                "Draws text in the font chosen by SELECT_FONT",
                (COLOR, X0, Y0, In("STRING", STRING, "text to draw")),
                effects=(Effect.DRAWS,),
                sentence="draws the text {STRING} in {COLOR} at ({X0}, {Y0})",
                words="print write screen",
            ),
            Command(
                6,
                "ICON",
                "Draws one of the built-in icons",
                (
                    COLOR,
                    X0,
                    Y0,
                    In("TYPE", DATA8, "set of icons", enum=ICONTYPE),
                    In("NO", DATA8, "number of the icon in its set"),
                ),
                effects=(Effect.DRAWS,),
            ),
            Command(
                7,
                "PICTURE",
                "Draws a picture from memory",
                (COLOR, X0, Y0, In("IP", DATA32, "address of the picture", special={0: "draws nothing"})),
                effects=(Effect.DRAWS,),
            ),
            Command(
                8,
                "VALUE",
                "Draws a number, or dashes where it is not a number",
                (COLOR, X0, Y0, In("VALUE", DATAF, "number to draw"), FIGURES_SIGNED, DECIMALS),
                effects=(Effect.DRAWS,),
                sentence="draws the number {VALUE} in {COLOR} at ({X0}, {Y0})",
            ),
            Command(
                9,
                "FILLRECT",
                "Draws a filled rectangle",
                (COLOR, X0, Y0, WIDTH, HEIGHT),
                effects=(Effect.DRAWS,),
                sentence="draws a filled {COLOR} rectangle at ({X0}, {Y0}), {X1} wide and {Y1} high",
            ),
            Command(
                10,
                "RECT",
                "Draws the outline of a rectangle",
                (COLOR, X0, Y0, WIDTH, HEIGHT),
                dialects=("official",),
                note="the other firmwares name it RECTANGLE",
                effects=(Effect.DRAWS,),
                sentence="draws a {COLOR} rectangle at ({X0}, {Y0}), {X1} wide and {Y1} high",
            ),
            Command(
                10,
                "RECTANGLE",
                "Draws the outline of a rectangle",
                (COLOR, X0, Y0, WIDTH, HEIGHT),
                dialects=EXTENSIONS,
                note="RECT in LEGO's firmware",
                effects=(Effect.DRAWS,),
            ),
            Command(
                11,
                "NOTIFICATION",
                "Shows icons and text in a window and waits for the centre button",
                (
                    COLOR,
                    X0,
                    Y0,
                    ICON1,
                    ICON2,
                    ICON3,
                    In("STRING", STRING, "text beside the icons; may be empty"),
                    DIALOGUE_STATE,
                ),
                effects=(Effect.DIALOG, Effect.WAITS),
            ),
            Command(
                12,
                "QUESTION",
                "Shows icons in a window and waits for yes or no",
                (
                    COLOR,
                    X0,
                    Y0,
                    ICON1,
                    ICON2,
                    In("STRING", STRING, "text of the question (LEGO's firmware does not show it)"),
                    DIALOGUE_STATE,
                    Out(
                        "OK",
                        DATA8,
                        "answer; the variable's previous value is selected at first",
                        range=(-1, 1),
                        special={0: "no", 1: "yes", -1: "closed with the back button"},
                    ),
                ),
                effects=(Effect.DIALOG, Effect.WAITS),
            ),
            Command(
                13,
                "KEYBOARD",
                "Shows a keyboard on the display and waits until a text has been entered",
                (
                    COLOR,
                    X0,
                    Y0,
                    In("ICON", DATA8, "normal icon before the caption", enum=N_ICON_NO),
                    LENGTH,
                    In("DEFAULT", STRING, "caption above the text, not a preset as its name says", special={0: "none"}),
                    InOut(
                        "CHARSET",
                        DATA8,
                        "variable with the sum of the allowed kinds of text; becomes 0 once the keyboard is shown",
                        special={
                            0: "being shown",
                            1: "brick name",
                            2: "file name",
                            4: "Bluetooth PIN",
                            8: "WiFi password",
                            16: "WiFi name",
                        },
                        note="the firmware sets it to 0; its documentation lists it among the inputs",
                    ),
                    Out(
                        "STRING",
                        STRING,
                        "entered text; the variable's previous text is edited, the back button empties it",
                        length="LENGTH",
                    ),
                ),
                effects=(Effect.DIALOG, Effect.WAITS),
            ),
            Command(
                14,
                "BROWSE",
                "Shows files and folders and waits until one is chosen",
                (
                    In("TYPE", DATA8, "what to list", enum=BROWSERTYPE),
                    X0,
                    Y0,
                    WIDTH,
                    HEIGHT,
                    LENGTH,
                    Out("ITEM_TYPE", DATA8, "kind of the chosen entry; the variable must be 0 at first", enum=FILETYPE),
                    Out(
                        "STRING",
                        STRING,
                        "path of the chosen entry; set the variable to the top folder first",
                        length="LENGTH",
                    ),
                ),
                effects=(Effect.DIALOG, Effect.WAITS),
            ),
            Command(
                15,
                "VERTBAR",
                "Draws a vertical scroll bar",
                (
                    COLOR,
                    X0,
                    Y0,
                    WIDTH,
                    HEIGHT,
                    In("MIN", DATA16, "value at one end of the bar"),
                    In("MAX", DATA16, "value at the other end of the bar"),
                    In("ACT", DATA16, "value that the knob shows"),
                ),
                effects=(Effect.DRAWS,),
            ),
            Command(
                16,
                "INVERSERECT",
                "Swaps black and white in a rectangle",
                (X0, Y0, WIDTH, HEIGHT),
                effects=(Effect.DRAWS,),
            ),
            Command(
                17,
                "SELECT_FONT",
                "Chooses the font for text, until UPDATE, CLEAN or FILLWINDOW",
                (In("TYPE", DATA8, "font", range=(0, 3), enum=FONTTYPE),),
                effects=(Effect.PRINTS,),
            ),
            Command(
                18,
                "TOPLINE",
                "Switches the status line at the top on or off",
                (
                    In(
                        "ENABLE",
                        DATA8,
                        "whether the status line is shown",
                        range=(0, 1),
                        special={0: "disabled", 1: "enabled"},
                    ),
                ),
                effects=(Effect.PRINTS,),
            ),
            Command(
                19,
                "FILLWINDOW",
                "Fills rows over the whole width, and restores the normal font",
                (
                    In(
                        "COLOR",
                        DATA8,
                        "colour to fill with; any other value makes a test pattern",
                        special={0: "white", 1: "black"},
                        names=COLORS,
                    ),
                    Y0,
                    In(
                        "Y1",
                        DATA16,
                        "height; nothing is filled if Y0 plus it is 128 or more",
                        range=(0, 127),
                        unit="px",
                        special={0: "down to the bottom"},
                    ),
                ),
                effects=(Effect.DRAWS, Effect.WIPES),
                words="clear erase screen",
            ),
            Command(
                20,
                "SCROLL",
                "Moves the canvas up",
                (In("Y", DATA16, "distance", range=(1, 127), unit="px"),),
                effects=(Effect.DRAWS,),
            ),
            Command(
                21,
                "DOTLINE",
                "Draws a dashed line between two points",
                (
                    COLOR,
                    X_START,
                    Y_START,
                    X_END,
                    Y_END,
                    In("ON", DATA16, "length of a dash", unit="px"),
                    In("OFF", DATA16, "length of a gap", unit="px"),
                ),
                effects=(Effect.DRAWS,),
                sentence="draws a dashed {COLOR} line from ({X0}, {Y0}) to ({X1}, {Y1})",
            ),
            Command(
                22,
                "VIEW_VALUE",
                "Draws a number centred in its place, or > instead of digits if it does not fit",
                (COLOR, X0, Y0, In("VALUE", DATAF, "number to draw"), FIGURES, DECIMALS),
                effects=(Effect.DRAWS,),
            ),
            Command(
                23,
                "VIEW_UNIT",
                "Draws a number in large figures and its unit in small letters",
                (
                    COLOR,
                    X0,
                    Y0,
                    In("VALUE", DATAF, "number to draw"),
                    FIGURES,
                    DECIMALS,
                    In(
                        "LENGTH",
                        DATA8,
                        "maximum number of bytes of the unit, including the zero",
                        range=(0, 127),
                        unit="bytes",
                    ),
                    In("STRING", STRING, "unit to draw after the number"),
                ),
                effects=(Effect.DRAWS,),
            ),
            Command(
                24,
                "FILLCIRCLE",
                "Draws a filled circle",
                (COLOR, X_CENTRE, Y_CENTRE, RADIUS),
                effects=(Effect.DRAWS,),
                sentence="draws a filled {COLOR} circle around ({X0}, {Y0}) with radius {R}",
            ),
            Command(25, "STORE", "Keeps a copy of the canvas", (STORED_SCREEN,), effects=(Effect.PRINTS,)),
            Command(
                26,
                "RESTORE",
                "Restores a canvas kept by STORE",
                (STORED_SCREEN,),
                effects=(Effect.DRAWS, Effect.WIPES),
            ),
            Command(
                27,
                "ICON_QUESTION",
                "Shows a row of icons and waits until one is chosen",
                (
                    COLOR,
                    X0,
                    Y0,
                    DIALOGUE_STATE,
                    InOut(
                        "ICONS",
                        DATA32,
                        "bit n is large icon n: first the icons to show, then the chosen one",
                        special={0: "none: closed with the back button"},
                        note="the firmware writes the choice; its documentation lists it among the inputs",
                    ),
                ),
                effects=(Effect.DIALOG, Effect.WAITS),
            ),
            Command(
                28,
                "BMPFILE",
                "Draws a picture file in LEGO's own format .rgf (no .bmp despite the name)",
                (
                    In(
                        "COLOR",
                        DATA8,
                        "colour of the set pixels",
                        range=(0, 1),
                        special={0: "white, picture inverted", 1: "black"},
                    ),
                    X0,
                    Y0,
                    In(
                        "NAME",
                        STRING,
                        "file with extension .rgf, absolute or relative to /home/root/lms2012/sys",
                        most=paths.WHOLE,
                    ),
                ),
                effects=(Effect.DRAWS,),
                sentence="draws the picture {NAME} at ({X0}, {Y0})",
            ),
            Command(
                29,
                "POPUP",
                "Opens a window that only its opener can draw on, or closes it and restores the display",
                (In("OPEN", DATA8, "action", range=(0, 1), special={0: "close", 1: "open"}),),
                effects=(Effect.DIALOG, Effect.WAITS),
            ),
            Command(
                30,
                "GRAPH_SETUP",
                "Sets up a graph of up to 8 curves; useless in direct commands, since the arrays must outlive it",
                (
                    X0,
                    WIDTH,
                    In("ITEMS", DATA8, "number of curves", range=(0, 8), validated=DATA16),
                    In("OFFSET", DATA16, "top edge of each curve", range=(0, 127), unit="px", length="ITEMS"),
                    In(
                        "SPAN",
                        DATA16,
                        "height of each curve",
                        range=(0, 128),
                        unit="px",
                        length="ITEMS",
                        validated=DATA8,
                    ),
                    In("MIN", DATAF, "value at the bottom of each curve", length="ITEMS", validated=DATA16),
                    In("MAX", DATAF, "value at the top of each curve", length="ITEMS", validated=DATA16),
                    In(
                        "SAMPLE",
                        DATAF,
                        "current value of each curve, read again at each GRAPH_SAMPLE",
                        length="ITEMS",
                        validated=DATA16,
                    ),
                ),
                effects=(Effect.PRINTS,),
            ),
            Command(
                31,
                "GRAPH_DRAW",
                "Draws the graph and measures the curve it shows",
                (
                    In(
                        "VIEW",
                        DATA8,
                        "curve to draw, counted from 0; any other value draws all and measures none",
                        special={-1: "all"},
                        note="documented as 0 for all, but then the firmware draws the first curve",
                    ),
                    Out("ACTUAL", DATAF, "latest value, NaN if there is none"),
                    Out("LOWEST", DATAF, "lowest value in the graph"),
                    Out("HIGHEST", DATAF, "highest value in the graph"),
                    Out("AVERAGE", DATAF, "mean of the values in the graph"),
                ),
                effects=(Effect.DRAWS,),
            ),
            Command(
                32,
                "TEXTBOX",
                "Shows a text with a scroll bar and waits until a line is chosen",
                (
                    X0,
                    Y0,
                    WIDTH,
                    HEIGHT,
                    TEXT,
                    SIZE,
                    DELIMITER,
                    InOut(
                        "LINE",
                        DATA16,
                        "variable, must be -1 at first; then the chosen line, counted from 1",
                        special={-1: "start, or closed with the back button", 0: "being shown"},
                        validated=DATA8,
                    ),
                ),
                effects=(Effect.DIALOG, Effect.WAITS),
            ),
        ),
    ),
    Opcode(
        0x90,
        "KEEP_ALIVE",
        "Restarts the timer that switches off an idle brick, and reads its time",
        (Out("MINUTES", DATA8, "idle time before switching off", unit="min", special={0: "never"}),),
        effects=(Effect.VARIES, Effect.COMPUTES),
    ),
)
