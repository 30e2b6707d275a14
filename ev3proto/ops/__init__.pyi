"""Every operation of LEGO's own firmware as a function.

Generated from ev3proto/tables by ev3proto.generate.stubs: edit those.
"""

# ruff: noqa: I001

from collections.abc import Sequence
from typing import Literal, TypeAlias, overload

from ev3proto.compose import Draft, Place
from ev3proto.enums import (
    SLOT,
    DEL,
    LEDPATTERN,
    BUTTONTYPE,
    ICONTYPE,
    L_ICON_NO,
    N_ICON_NO,
    BROWSERTYPE,
    FONTTYPE,
    TYPE,
    DATA_FORMAT,
    RESULT,
    HWTYPE,
    ENCRYPT,
    FILETYPE,
)
from ev3proto.messages import Argument, Variable

_Variable: TypeAlias = Variable | Place | Argument | bytes
_Number: TypeAlias = int | _Variable
_Real: TypeAlias = float | _Variable
_Text: TypeAlias = str | _Variable
_Elements: TypeAlias = int | str | _Variable
_Untyped: TypeAlias = float | str | _Variable
_Output: TypeAlias = _Variable | None
_Outputs: TypeAlias = Sequence[_Output] | Variable | Place | int | None
_SLOT_name: TypeAlias = Literal[
    "GUI_SLOT",
    "USER_SLOT",
    "CMD_SLOT",
    "TERM_SLOT",
    "DEBUG_SLOT",
    "CURRENT_SLOT",
]
_SLOT: TypeAlias = SLOT | _SLOT_name | _Number
_DEL_name: TypeAlias = Literal[
    "DEL_NONE",
    "DEL_TAB",
    "DEL_SPACE",
    "DEL_RETURN",
    "DEL_COLON",
    "DEL_COMMA",
    "DEL_LINEFEED",
    "DEL_CRLF",
]
_DEL: TypeAlias = DEL | _DEL_name | _Number
_LEDPATTERN_name: TypeAlias = Literal[
    "LED_BLACK",
    "LED_GREEN",
    "LED_RED",
    "LED_ORANGE",
    "LED_GREEN_FLASH",
    "LED_RED_FLASH",
    "LED_ORANGE_FLASH",
    "LED_GREEN_PULSE",
    "LED_RED_PULSE",
    "LED_ORANGE_PULSE",
]
_LEDPATTERN: TypeAlias = LEDPATTERN | _LEDPATTERN_name | _Number
_BUTTONTYPE_name: TypeAlias = Literal[
    "NO_BUTTON",
    "UP_BUTTON",
    "ENTER_BUTTON",
    "DOWN_BUTTON",
    "RIGHT_BUTTON",
    "LEFT_BUTTON",
    "BACK_BUTTON",
    "ANY_BUTTON",
]
_BUTTONTYPE: TypeAlias = BUTTONTYPE | _BUTTONTYPE_name | _Number
_ICONTYPE_name: TypeAlias = Literal[
    "NORMAL_ICON",
    "SMALL_ICON",
    "LARGE_ICON",
    "MENU_ICON",
    "ARROW_ICON",
]
_ICONTYPE: TypeAlias = ICONTYPE | _ICONTYPE_name | _Number
_L_ICON_NO_name: TypeAlias = Literal[
    "YES_NOTSEL",
    "YES_SEL",
    "NO_NOTSEL",
    "NO_SEL",
    "OFF",
    "WAIT_VERT",
    "WAIT_HORZ",
    "TO_MANUAL",
    "WARNSIGN",
    "WARN_BATT",
    "WARN_POWER",
    "WARN_TEMP",
    "NO_USBSTICK",
    "TO_EXECUTE",
    "TO_BRICK",
    "TO_SDCARD",
    "TO_USBSTICK",
    "TO_BLUETOOTH",
    "TO_WIFI",
    "TO_TRASH",
    "TO_COPY",
    "TO_FILE",
    "CHAR_ERROR",
    "COPY_ERROR",
    "PROGRAM_ERROR",
    "WARN_MEMORY",
]
_L_ICON_NO: TypeAlias = L_ICON_NO | _L_ICON_NO_name | _Number
_N_ICON_NO_name: TypeAlias = Literal[
    "ICON_NONE",
    "ICON_RUN",
    "ICON_FOLDER",
    "ICON_FOLDER2",
    "ICON_USB",
    "ICON_SD",
    "ICON_SOUND",
    "ICON_IMAGE",
    "ICON_SETTINGS",
    "ICON_ONOFF",
    "ICON_SEARCH",
    "ICON_WIFI",
    "ICON_CONNECTIONS",
    "ICON_ADD_HIDDEN",
    "ICON_TRASHBIN",
    "ICON_VISIBILITY",
    "ICON_KEY",
    "ICON_CONNECT",
    "ICON_DISCONNECT",
    "ICON_UP",
    "ICON_DOWN",
    "ICON_WAIT1",
    "ICON_WAIT2",
    "ICON_BLUETOOTH",
    "ICON_INFO",
    "ICON_TEXT",
    "ICON_QUESTIONMARK",
    "ICON_INFO_FILE",
    "ICON_DISC",
    "ICON_CONNECTED",
    "ICON_OBP",
    "ICON_OBD",
    "ICON_OPENFOLDER",
    "ICON_BRICK1",
]
_N_ICON_NO: TypeAlias = N_ICON_NO | _N_ICON_NO_name | _Number
_BROWSERTYPE_name: TypeAlias = Literal[
    "BROWSE_FOLDERS",
    "BROWSE_FOLDS_FILES",
    "BROWSE_CACHE",
    "BROWSE_FILES",
]
_BROWSERTYPE: TypeAlias = BROWSERTYPE | _BROWSERTYPE_name | _Number
_FONTTYPE_name: TypeAlias = Literal[
    "NORMAL_FONT",
    "SMALL_FONT",
    "LARGE_FONT",
    "TINY_FONT",
]
_FONTTYPE: TypeAlias = FONTTYPE | _FONTTYPE_name | _Number
_TYPE_name: TypeAlias = Literal[
    "MODE_KEEP",
    "TYPE_KEEP",
    "TYPE_NXT_TOUCH",
    "TYPE_NXT_LIGHT",
    "TYPE_NXT_SOUND",
    "TYPE_NXT_COLOR",
    "TYPE_NXT_ULTRASONIC",
    "TYPE_NXT_TEMPERATURE",
    "TYPE_TACHO",
    "TYPE_MINITACHO",
    "TYPE_NEWTACHO",
    "TYPE_TOUCH",
    "TYPE_COLOR",
    "TYPE_ULTRASONIC",
    "TYPE_GYRO",
    "TYPE_IR",
    "TYPE_THIRD_PARTY_START",
    "TYPE_THIRD_PARTY_END",
    "TYPE_ENERGYMETER",
    "TYPE_IIC_UNKNOWN",
    "TYPE_NXT_TEST",
    "TYPE_NXT_IIC",
    "TYPE_TERMINAL",
    "TYPE_UNKNOWN",
    "TYPE_NONE",
    "TYPE_ERROR",
]
_TYPE: TypeAlias = TYPE | _TYPE_name | _Number
_DATA_FORMAT_name: TypeAlias = Literal[
    "DATA_8",
    "DATA_16",
    "DATA_32",
    "DATA_F",
    "DATA_S",
    "DATA_A",
    "DATA_V",
    "DATA_PCT",
    "DATA_RAW",
    "DATA_SI",
]
_DATA_FORMAT: TypeAlias = DATA_FORMAT | _DATA_FORMAT_name | _Number
_RESULT_name: TypeAlias = Literal[
    "OK",
    "BUSY",
    "FAIL",
    "STOP",
    "START",
]
_RESULT: TypeAlias = RESULT | _RESULT_name | _Number
_HWTYPE_name: TypeAlias = Literal[
    "HW_USB",
    "HW_BT",
    "HW_WIFI",
]
_HWTYPE: TypeAlias = HWTYPE | _HWTYPE_name | _Number
_ENCRYPT_name: TypeAlias = Literal[
    "ENCRYPT_NONE",
    "ENCRYPT_WPA2",
]
_ENCRYPT: TypeAlias = ENCRYPT | _ENCRYPT_name | _Number
_FILETYPE_name: TypeAlias = Literal[
    "FILETYPE_UNKNOWN",
    "TYPE_FOLDER",
    "TYPE_SOUND",
    "TYPE_BYTECODE",
    "TYPE_GRAPHICS",
    "TYPE_DATALOG",
    "TYPE_PROGRAM",
    "TYPE_TEXT",
    "TYPE_SDCARD",
    "TYPE_USBSTICK",
    "TYPE_RESTART_BROWSER",
    "TYPE_REFRESH_BROWSER",
]
_FILETYPE: TypeAlias = FILETYPE | _FILETYPE_name | _Number

class _ProgramInfo:
    """PROGRAM_INFO: Asks about a program or controls its objects."""

    def obj_stop(self, prgid: _SLOT, objid: _Number, *, unchecked: bool = False) -> Draft:
        """Stops an object of a running program.

        prgid  program slot; a member of SLOT; DATA16
        objid  object of the program, counted from 1; DATA16
        """

    def obj_start(self, prgid: _SLOT, objid: _Number, *, unchecked: bool = False) -> Draft:
        """Starts an object of a running program from its beginning.

        prgid  program slot; a member of SLOT; DATA16
        objid  object of the program, counted from 1; DATA16
        """

    def get_status(self, prgid: _SLOT, data: _Output = None, *, unchecked: bool = False) -> Draft:
        """Asks whether a program runs.

        prgid  program slot; a member of SLOT; DATA16
        data   state of the program; a member of OBJSTAT; DATA8; an output, in global memory when left away
        """

    def get_speed(self, prgid: _SLOT, data: _Output = None, *, unchecked: bool = False) -> Draft:
        """Asks how fast a program runs.

        prgid  program slot; a member of SLOT; DATA16
        data   speed since the program started; instructions/s; DATA32; an output, in global memory when
               left away
        """

    def get_prgresult(self, prgid: _SLOT, data: _Output = None, *, unchecked: bool = False) -> Draft:
        """Asks how a program ended.

        prgid  program slot; a member of SLOT; DATA16
        data   OK, BUSY (still running) or FAIL; a member of RESULT; DATA8; an output, in global memory when
               left away
        """

    def set_instr(self, prgid: _SLOT, *, unchecked: bool = False) -> Draft:
        """Sets how many instructions the calling thread may still run in its time slice.

        prgid  program slot; a member of SLOT; DATA16
        """

class _Info:
    """INFO: Reads and sets the error log, the volume and the time to power off."""

    def set_error(self, number: _Number, *, unchecked: bool = False) -> Draft:
        """Puts an error into the brick's error log.

        number  number of the error; 0: nothing is logged; DATA8
        """

    def get_error(self, number: _Output = None, *, unchecked: bool = False) -> Draft:
        """Takes the oldest error out of the brick's error log.

        number  number of the error; 0: the log is empty; DATA8; an output, in global memory when left away
        """

    def errortext(
        self,
        number: _Number,
        length: _Number,
        destination: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Converts the number of an error to its name.

        number       number of the error; 0: gives an empty text; DATA8
        length       room for the text, with its zero; bytes; -1: no limit; DATA8
        destination  name of the error, less than 32 characters; string; an output, in global memory when
                     left away
        """

    def get_volume(self, value: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads the volume setting.

        value  how loud; 0 to 100 %; DATA8; an output, in global memory when left away
        """

    def set_volume(self, value: _Number, *, unchecked: bool = False) -> Draft:
        """Changes the volume setting.

        value  how loud; 0 to 100 %; DATA8
        """

    def get_minutes(self, value: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads after how long without use the brick powers off.

        value  time without use; 0 to 120 min; 0: never; DATA8; an output, in global memory when left away
        """

    def set_minutes(self, value: _Number, *, unchecked: bool = False) -> Draft:
        """Changes after how long without use the brick powers off.

        value  time without use; 0 to 120 min; 0: never; DATA8
        """

class _Strings:
    """STRINGS: Works with texts: joins, compares, converts from and to numbers."""

    def get_size(self, source1: _Text, size: _Output = None, *, unchecked: bool = False) -> Draft:
        """Measures a text.

        source1  text to work on; string
        size     its length without the zero; bytes; DATA16; an output, in global memory when left away
        """

    def add(self, source1: _Text, source2: _Text, destination: _Output = None, *, unchecked: bool = False) -> Draft:
        """Joins two texts.

        source1      first part; string
        source2      second part; string
        destination  resulting text, ended by its zero; string; an output, in global memory when left away
        """

    def compare(self, source1: _Text, source2: _Text, result: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells whether two texts are the same, upper and lower case kept apart.

        source1  one text; string
        source2  the other text; string
        result   whether they match; 0 to 1; 0: different, 1: the same; DATA8; an output, in global memory
                 when left away
        """

    def duplicate(self, source1: _Text, destination: _Output = None, *, unchecked: bool = False) -> Draft:
        """Copies a text.

        source1      text to work on; string
        destination  resulting text, ended by its zero; string; an output, in global memory when left away
        """

    def value_to_string(
        self,
        value: _Real,
        figures: _Number,
        decimals: _Number,
        destination: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Writes a floating-point number as text, without zeros at its end.

        value        number to write; NaN becomes ----; DATAF
        figures      width with the point; negative aligns left; characters; DATA8
        decimals     digits after the point; DATA8
        destination  resulting text, ended by its zero; string; an output, in global memory when left away
        """

    def string_to_value(self, source1: _Text, destination: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads a number from a text.

        source1      text to read; a comma counts as decimal point; string
        destination  the number; DATAF; an output, in global memory when left away
        """

    def strip(self, source1: _Text, destination: _Output = None, *, unchecked: bool = False) -> Draft:
        """Removes every space from a text.

        source1      text to work on; string
        destination  resulting text, ended by its zero; string; an output, in global memory when left away
        """

    def number_to_string(
        self,
        value: _Number,
        figures: _Number,
        destination: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Writes a whole number as text, with zeros in front.

        value        number to write; DATA16
        figures      width of the text; characters; DATA8
        destination  resulting text, ended by its zero; string; an output, in global memory when left away
        """

    def sub(self, source1: _Text, source2: _Text, destination: _Output = None, *, unchecked: bool = False) -> Draft:
        """Takes from a text what comes after another text found in it.

        source1      text to search; string
        source2      text to find; it should be there; string
        destination  resulting text, ended by its zero; string; an output, in global memory when left away
        """

    def value_formatted(
        self,
        value: _Real,
        format: _Text,
        size: _Number,
        destination: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Writes a floating-point number as text in a format of C's printf.

        value        number to write; DATAF
        format       format, such as %5.2f; string
        size         room for the text, with its zero; bytes; DATA8
        destination  resulting text; string; an output, in global memory when left away
        """

    def number_formatted(
        self,
        value: _Number,
        format: _Text,
        size: _Number,
        destination: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Writes a whole number as text in a format of C's printf.

        value        number to write; DATA32
        format       format, such as %05d or %X; string
        size         room for the text, with its zero; bytes; DATA8
        destination  resulting text; string; an output, in global memory when left away
        """

class _Tst:
    """TST: Tests the hardware, as the factory does; all but TST_OPEN fail unless opened before."""

    def tst_open(self, *, unchecked: bool = False) -> Draft:
        """Allows test commands for 10 seconds; each one renews the time."""

    def tst_close(self, *, unchecked: bool = False) -> Draft:
        """Ends the test mode."""

    def tst_read_pins(
        self,
        port: _Number,
        length: _Number,
        string: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Reads the pins of a connector.

        port    connector: 0..3 are sensor ports 1-4, 16..19 are motor ports A-D; 0 to 19; DATA8
        length  how many pins to read, usually 5; DATA8
        string  one character per pin: 0 low, 1 high; DATA8; an output, in global memory when left away
        """

    def tst_write_pins(self, port: _Number, length: _Number, string: _Elements, *, unchecked: bool = False) -> Draft:
        """Sets the pins of a connector.

        port    connector: 0..3 are sensor ports 1-4, 16..19 are motor ports A-D; 0 to 19; DATA8
        length  how many pins to set, usually 5; DATA8
        string  one character per pin: 0 low, 1 high, X floating, - as it is; DATA8
        """

    def tst_read_adc(self, index: _Number, value: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads the analog converter.

        index  channel: 0..3 pin 1 and 4..7 pin 6 of sensor ports, 8..11 pin 5 of motor ports; 0 to 15; 12:
               battery temperature, 13: motor current, 14: battery current, 15: battery voltage; DATA8
        value  raw reading; 0 to 4095 counts; DATA16; an output, in global memory when left away
        """

    def tst_write_uart(self, port: _Number, length: _Number, string: _Elements, *, unchecked: bool = False) -> Draft:
        """Sends bytes out of a sensor port's serial line.

        port    sensor port less one; 0 to 3; DATA8
        length  how many bytes to send; 0 to 63 bytes; DATA8
        string  the bytes; DATA8
        """

    def tst_read_uart(
        self,
        port: _Number,
        length: _Number,
        string: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Reads bytes that arrived on a sensor port's serial line.

        port    sensor port less one; 0 to 3; DATA8
        length  how many bytes to read; 0 to 63 bytes; DATA8
        string  the bytes, filled up with zeros; DATA8; an output, in global memory when left away
        """

    def tst_enable_uart(self, bitrate: _Number, *, unchecked: bool = False) -> Draft:
        """Switches the serial lines of all sensor ports on.

        bitrate  speed of the line; 2400 to 115200 bit/s; DATA32
        """

    def tst_disable_uart(self, *, unchecked: bool = False) -> Draft:
        """Switches the serial lines of all sensor ports off."""

    def tst_accu_switch(self, active: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads the switch that senses the rechargeable battery.

        active  state of the switch; 0 to 1; 0: other batteries, 1: rechargeable battery; DATA8; an output,
                in global memory when left away
        """

    def tst_boot_mode2(self, *, unchecked: bool = False) -> Draft:
        """Starts mode 2 of Bluetooth, the one for Apple's devices."""

    def tst_poll_mode2(self, status: _Output = None, *, unchecked: bool = False) -> Draft:
        """Asks how far the start of Bluetooth's mode 2 is.

        status  OK, BUSY (still starting) or FAIL; 0 to 2; a member of RESULT; DATA8; an output, in global
                memory when left away
        """

    def tst_close_mode2(self, *, unchecked: bool = False) -> Draft:
        """Ends mode 2 of Bluetooth."""

    def tst_ram_check(self, status: _Output = None, *, unchecked: bool = False) -> Draft:
        """Asks how the memory test at power-on went.

        status  OK or FAIL; 0 to 2; a member of RESULT; DATA8; an output, in global memory when left away
        """

class _Math:
    """MATH: Applies a mathematical function."""

    def exp(self, x: _Real, r: _Output = None, *, unchecked: bool = False) -> Draft:
        """Raises e to a power.

        x  the power; DATAF
        r  result; DATAF; an output, in global memory when left away
        """

    def mod(self, x: _Real, y: _Real, r: _Output = None, *, unchecked: bool = False) -> Draft:
        """Takes the remainder of a floating-point division.

        x  number to divide; DATAF
        y  number to divide by; DATAF
        r  what is left over, with the sign of X; DATAF; an output, in global memory when left away
        """

    def floor(self, x: _Real, r: _Output = None, *, unchecked: bool = False) -> Draft:
        """Rounds down to a whole number.

        x  number to work on; DATAF
        r  result; DATAF; an output, in global memory when left away
        """

    def ceil(self, x: _Real, r: _Output = None, *, unchecked: bool = False) -> Draft:
        """Rounds up to a whole number.

        x  number to work on; DATAF
        r  result; DATAF; an output, in global memory when left away
        """

    def round(self, x: _Real, r: _Output = None, *, unchecked: bool = False) -> Draft:
        """Rounds to the nearest whole number, halves away from zero.

        x  number to work on; DATAF
        r  result; DATAF; an output, in global memory when left away
        """

    def abs(self, x: _Real, r: _Output = None, *, unchecked: bool = False) -> Draft:
        """Drops the sign.

        x  number to work on; DATAF
        r  result; DATAF; an output, in global memory when left away
        """

    def negate(self, x: _Real, r: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reverses the sign.

        x  number to work on; DATAF
        r  result; DATAF; an output, in global memory when left away
        """

    def sqrt(self, x: _Real, r: _Output = None, *, unchecked: bool = False) -> Draft:
        """Takes the square root.

        x  number to work on, not negative; DATAF
        r  result; DATAF; an output, in global memory when left away
        """

    def log(self, x: _Real, r: _Output = None, *, unchecked: bool = False) -> Draft:
        """Takes the logarithm to base 10.

        x  number to work on, above 0; DATAF
        r  result; DATAF; an output, in global memory when left away
        """

    def ln(self, x: _Real, r: _Output = None, *, unchecked: bool = False) -> Draft:
        """Takes the natural logarithm.

        x  number to work on, above 0; DATAF
        r  result; DATAF; an output, in global memory when left away
        """

    def sin(self, x: _Real, r: _Output = None, *, unchecked: bool = False) -> Draft:
        """Takes the sine of an angle in degrees.

        x  angle; degrees; DATAF
        r  sine, -1 to 1; DATAF; an output, in global memory when left away
        """

    def cos(self, x: _Real, r: _Output = None, *, unchecked: bool = False) -> Draft:
        """Takes the cosine of an angle in degrees.

        x  angle; degrees; DATAF
        r  cosine, -1 to 1; DATAF; an output, in global memory when left away
        """

    def tan(self, x: _Real, r: _Output = None, *, unchecked: bool = False) -> Draft:
        """Takes the tangent of an angle in degrees.

        x  angle; degrees; DATAF
        r  tangent; DATAF; an output, in global memory when left away
        """

    def asin(self, x: _Real, r: _Output = None, *, unchecked: bool = False) -> Draft:
        """Finds the angle that has a sine.

        x  sine; -1 to 1; DATAF
        r  angle; degrees; DATAF; an output, in global memory when left away
        """

    def acos(self, x: _Real, r: _Output = None, *, unchecked: bool = False) -> Draft:
        """Finds the angle that has a cosine.

        x  cosine; -1 to 1; DATAF
        r  angle; degrees; DATAF; an output, in global memory when left away
        """

    def atan(self, x: _Real, r: _Output = None, *, unchecked: bool = False) -> Draft:
        """Finds the angle that has a tangent.

        x  tangent; DATAF
        r  angle; degrees; DATAF; an output, in global memory when left away
        """

    def mod8(self, x: _Number, y: _Number, r: _Output = None, *, unchecked: bool = False) -> Draft:
        """Takes the remainder of an 8-bit division.

        x  number to divide; DATA8
        y  number to divide by, not 0; DATA8
        r  what is left over, with the sign of X; DATA8; an output, in global memory when left away
        """

    def mod16(self, x: _Number, y: _Number, r: _Output = None, *, unchecked: bool = False) -> Draft:
        """Takes the remainder of a 16-bit division.

        x  number to divide; DATA16
        y  number to divide by, not 0; DATA16
        r  what is left over, with the sign of X; DATA16; an output, in global memory when left away
        """

    def mod32(self, x: _Number, y: _Number, r: _Output = None, *, unchecked: bool = False) -> Draft:
        """Takes the remainder of a 32-bit division.

        x  number to divide; DATA32
        y  number to divide by, not 0; DATA32
        r  what is left over, with the sign of X; DATA32; an output, in global memory when left away
        """

    def pow(self, x: _Real, y: _Real, r: _Output = None, *, unchecked: bool = False) -> Draft:
        """Raises a number to a power.

        x  number to raise; DATAF
        y  the power; DATAF
        r  result; DATAF; an output, in global memory when left away
        """

    def trunc(self, x: _Real, p: _Number, r: _Output = None, *, unchecked: bool = False) -> Draft:
        """Cuts off decimals without rounding.

        x  number to work on; DATAF
        p  how many decimals to keep (more than 6 are not there); 0 to 9; DATA8
        r  result; DATAF; an output, in global memory when left away
        """

class _UiRead:
    """UI_READ: Reads the state of the brick or what the terminal received."""

    def get_vbatt(self, value: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads the battery voltage.

        value  voltage; V; DATAF; an output, in global memory when left away
        """

    def get_ibatt(self, value: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads the battery current.

        value  current; A; DATAF; an output, in global memory when left away
        """

    def get_os_vers(self, length: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads name and version of the operating system.

        length       most bytes to return, the zero included; 0 to 127 bytes; -1: no limit; DATA8
        destination  system and kernel release, such as Linux 2.6.33-rc4; string; an output, in global
                     memory when left away
        """

    def get_event(self, event: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads and clears the pending event (used by the brick's own menus).

        event  what happened; 0: nothing, 1: Bluetooth asks for a PIN, 2: Bluetooth asks to confirm a
               connection; DATA8; an output, in global memory when left away
        """

    def get_tbatt(self, value: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads how much the batteries have warmed up, as estimated from the current.

        value  estimated rise of the temperature; °C; DATAF; an output, in global memory when left away
        """

    def get_iint(self, iint: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads the battery current smoothed over time.

        iint  integrated current; A; DATAF; an output, in global memory when left away
        """

    def get_imotor(self, value: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads the current of all motors together.

        value  current; A; DATAF; an output, in global memory when left away
        """

    def get_string(self, length: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
        """Waits for a line typed at the terminal and reads it.

        length       most bytes to return; the zero comes on top; 0 to 127 bytes; DATA8
        destination  the line; string; an output, in global memory when left away
        """

    def get_hw_vers(self, length: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads the hardware version.

        length       most bytes to return, the zero included; 0 to 127 bytes; -1: no limit; DATA8
        destination  hardware version, such as V0.60; string; an output, in global memory when left away
        """

    def get_fw_vers(self, length: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads the firmware version.

        length       most bytes to return, the zero included; 0 to 127 bytes; -1: no limit; DATA8
        destination  firmware version, such as V1.04H; string; an output, in global memory when left away
        """

    def get_fw_build(self, length: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads when the firmware was built.

        length       most bytes to return, the zero included; 0 to 127 bytes; -1: no limit; DATA8
        destination  build time as yymmddhhmm; string; an output, in global memory when left away
        """

    def get_os_build(self, length: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads when the operating system was built.

        length       most bytes to return, the zero included; 0 to 127 bytes; -1: no limit; DATA8
        destination  build time as yymmddhhmm; string; an output, in global memory when left away
        """

    def get_address(self, value: _Output = None, *, unchecked: bool = False) -> Draft:
        """Waits for a decimal number typed at the terminal and reads it (debugging).

        value  the number, meant as an address; DATA32; an output, in global memory when left away
        """

    def get_code(
        self,
        length: _Number,
        image: _Number,
        global_: _Output = None,
        flag: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Waits for byte code typed as hex at the terminal and makes a program of it (debugging).

        length   most bytes of the program, headers included; bytes; DATA32
        image    address of the memory where the program is built; DATA32
        global_  address of the program's global variables; DATA32; an output, in global memory when left
                 away
        flag     whether the program can be started; 1 or left as it was; 1: ready; DATA8; an output, in
                 global memory when left away
        """

    def key(self, value: _Output = None, *, unchecked: bool = False) -> Draft:
        """Takes one key from the terminal without waiting.

        value  character code of the key; 0: no key; DATA8; an output, in global memory when left away
        """

    def get_shutdown(self, flag: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads and clears the wish to shut down (used by the brick's own menus).

        flag  whether the brick wants to shut down; 0 to 1; 0: no, 1: yes; DATA8; an output, in global
              memory when left away
        """

    def get_warning(self, warnings: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads what the brick warns of.

        warnings  one bit for each warning; 0: none; a member of WARNING; DATA8; an output, in global memory
                  when left away
        """

    def get_lbatt(self, pct: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads how full the battery is, derived from its voltage.

        pct  battery level; 0 to 100 %; DATA8; an output, in global memory when left away
        """

    def textbox_read(
        self,
        text: _Text,
        size: _Number,
        del_: _DEL,
        length: _Number,
        line: _Number,
        destination: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Reads one line of the text of a text box.

        text         whole text of the box, its lines separated by DEL; string
        size         bytes that the box has for its text, the zero included; bytes; DATA32
        del_         what separates the lines; a member of DEL; DATA8
        length       most bytes to return, the zero included; 0 to 127 bytes; -1: no limit; DATA8
        line         which line, counted from 1; DATA16
        destination  the line, empty where there is no such line; string; an output, in global memory when
                     left away
        """

    def get_version(self, length: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads name, version and build date of the firmware in one.

        length       most bytes to return, the zero included; 0 to 127 bytes; -1: no limit; DATA8
        destination  such as LMS2012 V1.04H(Jul 26 2013 12:00:00); string; an output, in global memory when
                     left away
        """

    def get_ip(self, length: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads the brick's IP address.

        length       most bytes to return, the zero included; 0 to 127 bytes; -1: no limit; DATA8
        destination  address in dotted notation; string; an output, in global memory when left away
        """

    def get_power(
        self,
        vbatt: _Output = None,
        ibatt: _Output = None,
        iint: _Output = None,
        imotor: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Reads all values of the power supply at once.

        vbatt   battery voltage; V; DATAF; an output, in global memory when left away
        ibatt   battery current; A; DATAF; an output, in global memory when left away
        iint    battery current smoothed over time; A; DATAF; an output, in global memory when left away
        imotor  current of all motors together; A; DATAF; an output, in global memory when left away
        """

    def get_sdcard(
        self,
        state: _Output = None,
        total: _Output = None,
        free: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Reads whether an SD card is in and its space.

        state  whether one is present; 0 to 1; 0: absent, 1: present; DATA8; an output, in global memory
               when left away
        total  size; KiB; DATA32; an output, in global memory when left away
        free   free space; KiB; DATA32; an output, in global memory when left away
        """

    def get_usbstick(
        self,
        state: _Output = None,
        total: _Output = None,
        free: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Reads whether a USB stick is in and its space.

        state  whether one is present; 0 to 1; 0: absent, 1: present; DATA8; an output, in global memory
               when left away
        total  size; KiB; DATA32; an output, in global memory when left away
        free   free space; KiB; DATA32; an output, in global memory when left away
        """

class _UiWrite:
    """UI_WRITE: Writes to the terminal or sets lights and states of the brick."""

    def write_flush(self, *, unchecked: bool = False) -> Draft:
        """Sends what is still in the terminal's buffer, like UI_FLUSH."""

    def floatvalue(self, value: _Real, figures: _Number, decimals: _Number, *, unchecked: bool = False) -> Draft:
        """Writes a number in a fixed format to the terminal.

        value     number to write; DATAF
        figures   characters in all, decimal point included; negative aligns left; DATA8
        decimals  digits after the decimal point; DATA8
        """

    def stamp(self, value: _Text, *, unchecked: bool = False) -> Draft:
        """Writes time, program, object, position and a remark to the terminal.

        value  remark; string
        """

    def put_string(self, string: _Text, *, unchecked: bool = False) -> Draft:
        """Writes text to the terminal.

        string  text to write; string
        """

    def value8(self, value: _Number, *, unchecked: bool = False) -> Draft:
        """Writes a whole number to the terminal.

        value  number to write; DATA8
        """

    def value16(self, value: _Number, *, unchecked: bool = False) -> Draft:
        """Writes a whole number to the terminal, without its sign.

        value  number to write; DATA16
        """

    def value32(self, value: _Number, *, unchecked: bool = False) -> Draft:
        """Writes a whole number to the terminal.

        value  number to write; DATA32
        """

    def valuef(self, value: _Real, *, unchecked: bool = False) -> Draft:
        """Writes a number to the terminal.

        value  number to write; DATAF
        """

    def address(self, value: _Output = None, *, unchecked: bool = False) -> Draft:
        """Has a number but no code in the firmware: the program that runs it fails.

        value  address; never written; DATA32; an output, in global memory when left away
        """

    def code(self, array: _Number, length: _Number, *, unchecked: bool = False) -> Draft:
        """Writes bytes of memory as hex to the terminal.

        array   address of the bytes; DATA32
        length  how many bytes; bytes; DATA32
        """

    def download_end(self, *, unchecked: bool = False) -> Draft:
        """Plays the sound of a finished download and refreshes the file browser."""

    def screen_block(self, status: _Number, *, unchecked: bool = False) -> Draft:
        """Blocks or frees the display and the buttons for programs.

        status  whether drawing is ignored; 0 to 1; 0: normal, 1: blocked; DATA8
        """

    def allow_pulse(self, value: _Number, *, unchecked: bool = False) -> Draft:
        """Selects the debug pulses that are shown (only in firmware built for it).

        value  sum of bits; 1: menu background, 2: browser, 4: key; DATA8
        """

    def set_pulse(self, value: _Number, *, unchecked: bool = False) -> Draft:
        """Raises debug pulses (only in firmware built for it).

        value  sum of bits; 1: menu background, 2: browser, 4: key; DATA8
        """

    def textbox_append(
        self,
        text: _Variable,
        size: _Number,
        del_: _DEL,
        source: _Text,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Appends a line to the text of a text box.

        text    whole text of the box, its lines separated by DEL; string, a variable that is read and
                written
        size    bytes that the box has for its text, the zero included; bytes; DATA32
        del_    what separates the lines; a member of DEL; DATA8
        source  line to append; string
        """

    def set_busy(self, value: _Number, *, unchecked: bool = False) -> Draft:
        """Sets or clears the busy bit among the warnings.

        value  whether the brick counts as busy; 0 to 1; 0: no, 1: yes; DATA8
        """

    def set_testpin(self, state: _Number, *, unchecked: bool = False) -> Draft:
        """Sets the test pin on the brick's circuit board.

        state  level of the pin; 0 to 1; 0: low, 1: high; DATA8
        """

    def init_run(self, *, unchecked: bool = False) -> Draft:
        """Shows the animation of a running program until something draws."""

    def update_run(self, *, unchecked: bool = False) -> Draft:
        """Does nothing."""

    def led(self, pattern: _LEDPATTERN, *, unchecked: bool = False) -> Draft:
        """Sets colour and blinking of the light around the buttons.

        pattern  colour and rhythm; a member of LEDPATTERN; DATA8
        """

    def power(self, value: _Number, *, unchecked: bool = False) -> Draft:
        """Sets the power driver's flag for switching off when the firmware ends.

        value  the flag; 0 to 1; DATA8
        """

    def graph_sample(self, *, unchecked: bool = False) -> Draft:
        """Adds the present values to the graph that GRAPH_SETUP has set up."""

    def terminal(self, state: _Number, *, unchecked: bool = False) -> Draft:
        """Switches the debug terminal on or off.

        state  whether the terminal is on; 0 to 1; 0: off, 1: on; DATA8
        """

class _UiButton:
    """UI_BUTTON: Reads or simulates the buttons."""

    def shortpress(self, button: _BUTTONTYPE, state: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells whether a button was pressed since last asked, and forgets it.

        button  which button; a member of BUTTONTYPE; DATA8
        state   whether the button was pressed; 0 to 1; 0: no, 1: yes; DATA8; an output, in global memory
                when left away
        """

    def longpress(self, button: _BUTTONTYPE, state: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells whether a button was held for 3 s since last asked, and forgets it.

        button  which button; a member of BUTTONTYPE; DATA8
        state   whether the button was held for 3 s; 0 to 1; 0: no, 1: yes; DATA8; an output, in global
                memory when left away
        """

    def wait_for_press(self, *, unchecked: bool = False) -> Draft:
        """Waits until any button has been pressed, by hand or by PRESS."""

    def flush(self, *, unchecked: bool = False) -> Draft:
        """Forgets all presses that nobody has asked for."""

    def press(self, button: _BUTTONTYPE, *, unchecked: bool = False) -> Draft:
        """Presses a button as if by hand and holds it until RELEASE.

        button  which button; a member of BUTTONTYPE; DATA8
        """

    def release(self, button: _BUTTONTYPE, *, unchecked: bool = False) -> Draft:
        """Releases a button that PRESS holds.

        button  which button; a member of BUTTONTYPE; DATA8
        """

    def get_horz(self, value: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads the left and right buttons as one axis, and forgets their presses.

        value  direction; -1 to 1; -1: left, 1: right, 0: not pressed; DATA16; an output, in global memory
               when left away
        """

    def get_vert(self, value: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads the up and down buttons as one axis, and forgets their presses.

        value  direction; -1 to 1; -1: up, 1: down, 0: not pressed; DATA16; an output, in global memory when
               left away
        """

    def pressed(self, button: _BUTTONTYPE, state: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells whether a button is down at the moment.

        button  which button; a member of BUTTONTYPE; DATA8
        state   whether the button is down; 0 to 1; 0: no, 1: yes; DATA8; an output, in global memory when
                left away
        """

    def set_back_block(self, blocked: _Number, *, unchecked: bool = False) -> Draft:
        """Sets whether the back button is kept from ending the running program.

        blocked  whether the back button is blocked; 0 to 1; 0: not blocked, 1: blocked; DATA8
        """

    def get_back_block(self, blocked: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells whether the back button is kept from ending the running program.

        blocked  whether the back button is blocked; 0 to 1; 0: not blocked, 1: blocked; DATA8; an output,
                 in global memory when left away
        """

    def testshortpress(self, button: _BUTTONTYPE, state: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells like SHORTPRESS whether a button was pressed, without forgetting it.

        button  which button; a member of BUTTONTYPE; DATA8
        state   whether the button was pressed; 0 to 1; 0: no, 1: yes; DATA8; an output, in global memory
                when left away
        """

    def testlongpress(self, button: _BUTTONTYPE, state: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells like LONGPRESS whether a button was held for 3 s, without forgetting it.

        button  which button; a member of BUTTONTYPE; DATA8
        state   whether the button was held for 3 s; 0 to 1; 0: no, 1: yes; DATA8; an output, in global
                memory when left away
        """

    def get_bumbed(self, button: _BUTTONTYPE, state: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells whether a button was pressed and let go since last asked, and forgets it.

        button  which button; a member of BUTTONTYPE; DATA8
        state   whether the button was pressed and let go; 0 to 1; 0: no, 1: yes; DATA8; an output, in
                global memory when left away
        """

    def get_click(self, click: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells whether a key click is due because a press was handled, and forgets it.

        click  whether a click is due; 0 to 1; 0: no, 1: yes; DATA8; an output, in global memory when left
               away
        """

class _UiDraw:
    """UI_DRAW: Draws on the canvas of the display, or runs a dialogue on it."""

    def update(self, *, unchecked: bool = False) -> Draft:
        """Shows on the display what has been drawn, and returns to the normal font."""

    def clean(self, *, unchecked: bool = False) -> Draft:
        """Wipes the canvas white, and returns to the normal font."""

    def pixel(self, color: _Number, x0: _Number, y0: _Number, *, unchecked: bool = False) -> Draft:
        """Draws one pixel.

        color  colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0     column; 0 to 177 px; DATA16
        y0     row; 0 to 127 px; DATA16
        """

    def line(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        x1: _Number,
        y1: _Number,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Draws a line between two points.

        color  colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0     column of the start; 0 to 177 px; DATA16
        y0     row of the start; 0 to 127 px; DATA16
        x1     column of the end; 0 to 177 px; DATA16
        y1     row of the end; 0 to 127 px; DATA16
        """

    def circle(self, color: _Number, x0: _Number, y0: _Number, r: _Number, *, unchecked: bool = False) -> Draft:
        """Draws a circle.

        color  colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0     column of the centre; 0 to 177 px; DATA16
        y0     row of the centre; 0 to 127 px; DATA16
        r      radius; px; 0: draws nothing; DATA16
        """

    def text(self, color: _Number, x0: _Number, y0: _Number, string: _Text, *, unchecked: bool = False) -> Draft:
        """Draws text in the font that SELECT_FONT has chosen.

        color   colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0      left edge; 0 to 177 px; DATA16
        y0      top edge; 0 to 127 px; DATA16
        string  text to draw; string
        """

    def icon(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        type: _ICONTYPE,
        no: _Number,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Draws one of the built-in icons.

        color  colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0     left edge; 0 to 177 px; DATA16
        y0     top edge; 0 to 127 px; DATA16
        type   set of icons; a member of ICONTYPE; DATA8
        no     number of the icon in its set; DATA8
        """

    def picture(self, color: _Number, x0: _Number, y0: _Number, ip: _Number, *, unchecked: bool = False) -> Draft:
        """Draws a picture that is in memory.

        color  colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0     left edge; 0 to 177 px; DATA16
        y0     top edge; 0 to 127 px; DATA16
        ip     address of the picture; 0: draws nothing; DATA32
        """

    def value(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        value: _Real,
        figures: _Number,
        decimals: _Number,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Draws a number, or dashes where it is not a number.

        color     colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0        left edge; 0 to 177 px; DATA16
        y0        top edge; 0 to 127 px; DATA16
        value     number to draw; DATAF
        figures   characters in all, decimal point included; negative aligns left; DATA8
        decimals  digits after the decimal point; DATA8
        """

    def fillrect(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        x1: _Number,
        y1: _Number,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Draws a filled rectangle.

        color  colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0     left edge; 0 to 177 px; DATA16
        y0     top edge; 0 to 127 px; DATA16
        x1     width; 0 to 178 px; DATA16
        y1     height; 0 to 128 px; DATA16
        """

    def rect(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        x1: _Number,
        y1: _Number,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Draws the outline of a rectangle.

        color  colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0     left edge; 0 to 177 px; DATA16
        y0     top edge; 0 to 127 px; DATA16
        x1     width; 0 to 178 px; DATA16
        y1     height; 0 to 128 px; DATA16
        """

    def notification(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        icon1: _L_ICON_NO,
        icon2: _L_ICON_NO,
        icon3: _L_ICON_NO,
        string: _Text,
        state: _Variable,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Shows icons and text in a window and waits for the centre button.

        color   colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0      left edge; 0 to 177 px; DATA16
        y0      top edge; 0 to 127 px; DATA16
        icon1   first large icon; -1: none; a member of L_ICON_NO; DATA8
        icon2   second large icon; -1: none; a member of L_ICON_NO; DATA8
        icon3   third large icon; -1: none; a member of L_ICON_NO; DATA8
        string  text beside the icons; may be empty; string
        state   variable the dialogue keeps its progress in; set to 0 before; 0 to 1; 0: start, or done, 1:
                being shown; DATA8, a variable that is read and written
        """

    def question(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        icon1: _L_ICON_NO,
        icon2: _L_ICON_NO,
        string: _Text,
        state: _Variable,
        ok: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Shows icons in a window and waits for yes or no.

        color   colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0      left edge; 0 to 177 px; DATA16
        y0      top edge; 0 to 127 px; DATA16
        icon1   first large icon; -1: none; a member of L_ICON_NO; DATA8
        icon2   second large icon; -1: none; a member of L_ICON_NO; DATA8
        string  text of the question (LEGO's firmware does not show it); string
        state   variable the dialogue keeps its progress in; set to 0 before; 0 to 1; 0: start, or done, 1:
                being shown; DATA8, a variable that is read and written
        ok      answer; what the variable holds before is selected first; -1 to 1; 0: no, 1: yes, -1: left
                with the back button; DATA8; an output, in global memory when left away
        """

    def keyboard(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        icon: _N_ICON_NO,
        length: _Number,
        default: _Text,
        charset: _Variable,
        string: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Shows a keyboard on the display and waits until a text has been entered.

        color    colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0       left edge; 0 to 177 px; DATA16
        y0       top edge; 0 to 127 px; DATA16
        icon     normal icon before the caption; a member of N_ICON_NO; DATA8
        length   most bytes to return, the zero included; 0 to 127 bytes; DATA8
        default  caption above the text, not a preset as its name says; 0: none; string
        charset  variable with the sum of what may be typed; becomes 0 once the keyboard shows; 0: being
                 shown, 1: brick name, 2: file name, 4: Bluetooth PIN, 8: WiFi password, 16: WiFi name;
                 DATA8, a variable that is read and written
        string   text entered; what the variable holds before is edited, back button empties it; string; an
                 output, in global memory when left away
        """

    def browse(
        self,
        type: _BROWSERTYPE,
        x0: _Number,
        y0: _Number,
        x1: _Number,
        y1: _Number,
        length: _Number,
        item_type: _Output = None,
        string: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Shows files and folders and waits until one is chosen.

        type       what is listed; a member of BROWSERTYPE; DATA8
        x0         left edge; 0 to 177 px; DATA16
        y0         top edge; 0 to 127 px; DATA16
        x1         width; 0 to 178 px; DATA16
        y1         height; 0 to 128 px; DATA16
        length     most bytes to return, the zero included; 0 to 127 bytes; DATA8
        item_type  kind of what was chosen; set the variable to 0 before; a member of FILETYPE; DATA8; an
                   output, in global memory when left away
        string     path of what was chosen; the variable holds the top folder before; string; an output, in
                   global memory when left away
        """

    def vertbar(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        x1: _Number,
        y1: _Number,
        min: _Number,
        max: _Number,
        act: _Number,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Draws a vertical scroll bar.

        color  colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0     left edge; 0 to 177 px; DATA16
        y0     top edge; 0 to 127 px; DATA16
        x1     width; 0 to 178 px; DATA16
        y1     height; 0 to 128 px; DATA16
        min    value at one end of the bar; DATA16
        max    value at the other end of the bar; DATA16
        act    value that the knob shows; DATA16
        """

    def inverserect(self, x0: _Number, y0: _Number, x1: _Number, y1: _Number, *, unchecked: bool = False) -> Draft:
        """Swaps black and white in a rectangle.

        x0  left edge; 0 to 177 px; DATA16
        y0  top edge; 0 to 127 px; DATA16
        x1  width; 0 to 178 px; DATA16
        y1  height; 0 to 128 px; DATA16
        """

    def select_font(self, type: _FONTTYPE, *, unchecked: bool = False) -> Draft:
        """Chooses the font for text until UPDATE, CLEAN or FILLWINDOW.

        type  font; 0 to 3; a member of FONTTYPE; DATA8
        """

    def topline(self, enable: _Number, *, unchecked: bool = False) -> Draft:
        """Switches the status line at the top on or off.

        enable  whether the status line is shown; 0 to 1; 0: disabled, 1: enabled; DATA8
        """

    def fillwindow(self, color: _Number, y0: _Number, y1: _Number, *, unchecked: bool = False) -> Draft:
        """Fills rows over the whole width, and returns to the normal font.

        color  colour to fill with; any other value makes a test pattern; 0: white, 1: black; DATA8
        y0     top edge; 0 to 127 px; DATA16
        y1     height; nothing is filled where Y0 and it make 128 or more; 0 to 127 px; 0: down to the
               bottom; DATA16
        """

    def scroll(self, y: _Number, *, unchecked: bool = False) -> Draft:
        """Moves the canvas up.

        y  how far; 1 to 127 px; DATA16
        """

    def dotline(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        x1: _Number,
        y1: _Number,
        on: _Number,
        off: _Number,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Draws a dashed line between two points.

        color  colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0     column of the start; 0 to 177 px; DATA16
        y0     row of the start; 0 to 127 px; DATA16
        x1     column of the end; 0 to 177 px; DATA16
        y1     row of the end; 0 to 127 px; DATA16
        on     length of a dash; px; DATA16
        off    length of a gap; px; DATA16
        """

    def view_value(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        value: _Real,
        figures: _Number,
        decimals: _Number,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Draws a number centred in its place, with > instead of digits where it does not fit.

        color     colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0        left edge; 0 to 177 px; DATA16
        y0        top edge; 0 to 127 px; DATA16
        value     number to draw; DATAF
        figures   characters in all, decimal point included; DATA8
        decimals  digits after the decimal point; DATA8
        """

    def view_unit(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        value: _Real,
        figures: _Number,
        decimals: _Number,
        length: _Number,
        string: _Text,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Draws a number in large figures and its unit in small letters.

        color     colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0        left edge; 0 to 177 px; DATA16
        y0        top edge; 0 to 127 px; DATA16
        value     number to draw; DATAF
        figures   characters in all, decimal point included; DATA8
        decimals  digits after the decimal point; DATA8
        length    most bytes of the unit, the zero included; 0 to 127 bytes; DATA8
        string    unit to draw behind the number; string
        """

    def fillcircle(self, color: _Number, x0: _Number, y0: _Number, r: _Number, *, unchecked: bool = False) -> Draft:
        """Draws a filled circle.

        color  colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0     column of the centre; 0 to 177 px; DATA16
        y0     row of the centre; 0 to 127 px; DATA16
        r      radius; px; 0: draws nothing; DATA16
        """

    def store(self, no: _Number, *, unchecked: bool = False) -> Draft:
        """Keeps a copy of the canvas.

        no  memory for one screen; 0 holds the one from before the program ran; 0 to 2; DATA8
        """

    def restore(self, no: _Number, *, unchecked: bool = False) -> Draft:
        """Brings back a canvas kept by STORE.

        no  memory for one screen; 0 holds the one from before the program ran; 0 to 2; DATA8
        """

    def icon_question(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        state: _Variable,
        icons: _Variable,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Shows a row of icons and waits until one is chosen.

        color  colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0     left edge; 0 to 177 px; DATA16
        y0     top edge; 0 to 127 px; DATA16
        state  variable the dialogue keeps its progress in; set to 0 before; 0 to 1; 0: start, or done, 1:
               being shown; DATA8, a variable that is read and written
        icons  bit n stands for large icon n: before those to show, then the one chosen; 0: none: left with
               the back button; DATA32, a variable that is read and written
        """

    def bmpfile(self, color: _Number, x0: _Number, y0: _Number, name: _Text, *, unchecked: bool = False) -> Draft:
        """Draws a picture file in LEGO's own format .rgf (no .bmp despite the name).

        color  colour of the set pixels; 0 to 1; 0: white, picture inverted, 1: black; DATA8
        x0     left edge; 0 to 177 px; DATA16
        y0     top edge; 0 to 127 px; DATA16
        name   file with extension .rgf, absolute or relative to /home/root/lms2012/sys; at most 119
               characters; string
        """

    def popup(self, open: _Number, *, unchecked: bool = False) -> Draft:
        """Opens a window that only its opener draws on, or closes it and brings back the display.

        open  what to do; 0 to 1; 0: close, 1: open; DATA8
        """

    def graph_setup(
        self,
        x0: _Number,
        x1: _Number,
        items: _Number,
        offset: _Elements,
        span: _Elements,
        min: _Elements,
        max: _Elements,
        sample: _Elements,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Sets up a graph of up to 8 curves; their arrays must outlive it, so useless in direct commands.

        x0      left edge; 0 to 177 px; DATA16
        x1      width; 0 to 178 px; DATA16
        items   how many curves; 0 to 8; DATA8
        offset  top edge of each curve; 0 to 127 px; DATA16
        span    height of each curve; 0 to 128 px; DATA16
        min     value at the bottom of each curve; DATAF
        max     value at the top of each curve; DATAF
        sample  present value of each curve, read anew at each GRAPH_SAMPLE; DATAF
        """

    def graph_draw(
        self,
        view: _Number,
        actual: _Output = None,
        lowest: _Output = None,
        highest: _Output = None,
        average: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Draws the graph and measures the curve it shows.

        view     curve to draw, counted from 0; any other value draws all and measures none; -1: all; DATA8
        actual   latest value, not a number where there is none; DATAF; an output, in global memory when
                 left away
        lowest   lowest value in the graph; DATAF; an output, in global memory when left away
        highest  highest value in the graph; DATAF; an output, in global memory when left away
        average  mean of the values in the graph; DATAF; an output, in global memory when left away
        """

    def textbox(
        self,
        x0: _Number,
        y0: _Number,
        x1: _Number,
        y1: _Number,
        text: _Text,
        size: _Number,
        del_: _DEL,
        line: _Variable,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Shows a text with a scroll bar and waits until a line is chosen.

        x0    left edge; 0 to 177 px; DATA16
        y0    top edge; 0 to 127 px; DATA16
        x1    width; 0 to 178 px; DATA16
        y1    height; 0 to 128 px; DATA16
        text  whole text of the box, its lines separated by DEL; string
        size  bytes that the box has for its text, the zero included; bytes; DATA32
        del_  what separates the lines; a member of DEL; DATA8
        line  variable, set to -1 before; then the line chosen, counted from 1; -1: start, or left with the
              back button, 0: being shown; DATA16, a variable that is read and written
        """

class _Sound:
    """SOUND: Plays or stops a sound."""

    def break_(self, *, unchecked: bool = False) -> Draft:
        """Stops the tone or file that is playing."""

    def tone(self, volume: _Number, frequency: _Number, duration: _Number, *, unchecked: bool = False) -> Draft:
        """Plays one tone and returns at once.

        volume     how loud; 0 to 100 %; 0: silent; DATA8
        frequency  pitch; the driver moves others into the range; 250 to 10000 Hz; DATA16
        duration   how long, read without sign (-1 is 65535); ms; 0: until BREAK or the next sound; DATA16
        """

    def play(self, volume: _Number, name: _Text, *, unchecked: bool = False) -> Draft:
        """Plays a sound file once and returns at once.

        volume  how loud; 0 to 100 %; 0: silent; DATA8
        name    sound file without its extension .rsf, absolute or relative to /home/root/lms2012/sys; at
                most 119 characters; string
        """

    def repeat(self, volume: _Number, name: _Text, *, unchecked: bool = False) -> Draft:
        """Plays a sound file over and over until BREAK and returns at once.

        volume  how loud; 0 to 100 %; 0: silent; DATA8
        name    sound file without its extension .rsf, absolute or relative to /home/root/lms2012/sys; at
                most 119 characters; string
        """

    def service(self, *, unchecked: bool = False) -> Draft:
        """Does nothing here: the firmware itself feeds its sound driver by this number."""

class _InputDevice:
    """INPUT_DEVICE: Asks about devices, calibrates them, reads several values."""

    def insert_type(self, typedata: _Text, force: _Number, error: _Output = None, *, unchecked: bool = False) -> Draft:
        """Adds a line to the table of device types, for third party types (50 to 98) only.

        typedata  the line as in typedata.rcf, starting with the type's number; string
        force     whether to replace a known type; 0 to 1; 0: refuse a known type, 1: replace a known type;
                  DATA8
        error     whether it failed; 0 to 1; 0: done, 1: failed or known; DATA8; an output, in global memory
                  when left away
        """

    def get_format(
        self,
        layer: _Number,
        no: _Number,
        datasets: _Output = None,
        format: _Output = None,
        modes: _Output = None,
        views: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Tells the shape of a device's values in its present mode.

        layer     brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
        no        port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1, 1: port 2, 2: port 3, 3:
                  port 4, 16: motor port A, 17: motor port B, 18: motor port C, 19: motor port D; DATA8
        datasets  how many values one reading has; DATA8; an output, in global memory when left away
        format    type of one raw value; 0 to 3; a member of DATA_FORMAT; DATA8; an output, in global memory
                  when left away
        modes     how many modes the device has; 1 to 8; DATA8; an output, in global memory when left away
        views     how many of the modes are shown to users; 1 to 8; DATA8; an output, in global memory when
                  left away
        """

    def cal_minmax(
        self,
        type: _TYPE,
        mode: _Number,
        cal_min: _Number,
        cal_max: _Number,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Sets the raw values that scale a type and mode to percent and SI.

        type     type of device the calibration is for; a member of TYPE; DATA8
        mode     mode the calibration is for; 0 to 7; DATA8
        cal_min  raw value at the lower end; DATA32
        cal_max  raw value at full scale; DATA32
        """

    def cal_default(self, type: _TYPE, mode: _Number, *, unchecked: bool = False) -> Draft:
        """Goes back to the built-in scaling of a type and mode.

        type  type of device the calibration is for; a member of TYPE; DATA8
        mode  mode the calibration is for; 0 to 7; DATA8
        """

    def get_typemode(
        self,
        layer: _Number,
        no: _Number,
        type: _Output = None,
        mode: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Tells which device is at a port and in which mode.

        layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
        no     port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1, 1: port 2, 2: port 3, 3: port
               4, 16: motor port A, 17: motor port B, 18: motor port C, 19: motor port D; DATA8
        type   type of the device; a member of TYPE; DATA8; an output, in global memory when left away
        mode   mode the device is in; 0 to 7; DATA8; an output, in global memory when left away
        """

    def get_symbol(
        self,
        layer: _Number,
        no: _Number,
        length: _Number,
        destination: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Reads the symbol of the unit of the present mode.

        layer        brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
        no           port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1, 1: port 2, 2: port 3, 3:
                     port 4, 16: motor port A, 17: motor port B, 18: motor port C, 19: motor port D; DATA8
        length       room for the text with its zero; bytes; -1: as long as it is (handles only); DATA8
        destination  symbol, filled up with blanks; string; an output, in global memory when left away
        """

    def cal_min(self, type: _TYPE, mode: _Number, cal_min: _Number, *, unchecked: bool = False) -> Draft:
        """Sets the lower end of the scaling of a type and mode.

        type     type of device the calibration is for; a member of TYPE; DATA8
        mode     mode the calibration is for; 0 to 7; DATA8
        cal_min  value at the lower end, in SI units once calibrated; DATA32
        """

    def cal_max(self, type: _TYPE, mode: _Number, cal_max: _Number, *, unchecked: bool = False) -> Draft:
        """Sets the full scale of a type and mode.

        type     type of device the calibration is for; a member of TYPE; DATA8
        mode     mode the calibration is for; 0 to 7; DATA8
        cal_max  value at full scale, in SI units once calibrated; DATA32
        """

    def setup(
        self,
        layer: _Number,
        no: _Number,
        repeat: _Number,
        time: _Number,
        write_len: _Number,
        write_data: _Elements,
        read_len: _Number,
        read_data: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Writes to an I2C sensor and reads its answer, again and again if asked to.

        layer       brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
        no          sensor port, counted from 0; 0 to 3; 0: port 1, 1: port 2, 2: port 3, 3: port 4; DATA8
        repeat      how often to write and read; 0: without end; DATA8
        time        time between repeats; 10 to 1000 ms; 0: 10 ms; DATA16
        write_len   how many bytes to write; 0 to 32 bytes; DATA8
        write_data  bytes to write: I2C address, register, data; DATA8
        read_len    how many bytes to read, negative: in reverse order; -32 to 32 bytes; DATA8
        read_data   bytes read; DATA8; an output, in global memory when left away
        """

    def clr_all(self, layer: _Number, *, unchecked: bool = False) -> Draft:
        """Clears counters and angles of all devices.

        layer  brick in the daisy chain; 0 to 3; -1: all layers; DATA8
        """

    def get_raw(self, layer: _Number, no: _Number, value: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads the first raw value of a device.

        layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
        no     port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1, 1: port 2, 2: port 3, 3: port
               4, 16: motor port A, 17: motor port B, 18: motor port C, 19: motor port D; DATA8
        value  raw value, NaN where there is none; DATA32; an output, in global memory when left away
        """

    def get_connection(self, layer: _Number, no: _Number, conn: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells how the device at a port is connected.

        layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
        no     port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1, 1: port 2, 2: port 3, 3: port
               4, 16: motor port A, 17: motor port B, 18: motor port C, 19: motor port D; DATA8
        conn   kind of connection; a member of CONN; DATA8; an output, in global memory when left away
        """

    def stop_all(self, layer: _Number, *, unchecked: bool = False) -> Draft:
        """Stops all devices, motors among them.

        layer  brick in the daisy chain; 0 to 3; -1: all layers; DATA8
        """

    def set_typemode(
        self,
        type: _TYPE,
        mode: _Number,
        newtype: _TYPE,
        newmode: _Number,
        error: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Renumbers an entry of the table of device types, third party types only.

        type     type the entry has; 50 to 98; a member of TYPE; DATA8
        mode     mode the entry has; 0 to 7; DATA8
        newtype  type the entry shall have; 50 to 98; a member of TYPE; DATA8
        newmode  mode the entry shall have; 0 to 7; DATA8
        error    whether it failed; 0 to 1; 0: done, 1: failed or not found; DATA8; an output, in global
                 memory when left away
        """

    def ready_iic(
        self,
        layer: _Number,
        no: _Number,
        wrlng: _Number,
        wrdata: _Elements,
        rdlng: _Number,
        rddata: _Output = None,
        result: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Writes to an I2C sensor once, waits for its answer and tells how it went.

        layer   brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
        no      sensor port, counted from 0; 0 to 3; 0: port 1, 1: port 2, 2: port 3, 3: port 4; DATA8
        wrlng   how many bytes to write; 0 to 32 bytes; DATA8
        wrdata  bytes to write: I2C address, register, data; DATA8
        rdlng   how many bytes to read, negative: in reverse order; -32 to 32 bytes; DATA8
        rddata  bytes read; DATA8; an output, in global memory when left away
        result  how the transfer ended; a member of RESULT; DATA8; an output, in global memory when left
                away
        """

    def get_name(
        self,
        layer: _Number,
        no: _Number,
        length: _Number,
        destination: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Reads the name of a device in its present mode, such as TOUCH or COL-REFLECT.

        layer        brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
        no           port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1, 1: port 2, 2: port 3, 3:
                     port 4, 16: motor port A, 17: motor port B, 18: motor port C, 19: motor port D; DATA8
        length       room for the text with its zero; bytes; -1: as long as it is (handles only); DATA8
        destination  name, filled up with blanks; string; an output, in global memory when left away
        """

    def get_modename(
        self,
        layer: _Number,
        no: _Number,
        mode: _Number,
        length: _Number,
        destination: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Reads the name of any mode of a device.

        layer        brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
        no           port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1, 1: port 2, 2: port 3, 3:
                     port 4, 16: motor port A, 17: motor port B, 18: motor port C, 19: motor port D; DATA8
        mode         mode to name; 0 to 7; DATA8
        length       room for the text with its zero; bytes; -1: as long as it is (handles only); DATA8
        destination  name, filled up with blanks; string; an output, in global memory when left away
        """

    def set_raw(self, layer: _Number, no: _Number, type: _TYPE, value: _Number, *, unchecked: bool = False) -> Draft:
        """Pretends that a device has read this raw value.

        layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
        no     port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1, 1: port 2, 2: port 3, 3: port
               4, 16: motor port A, 17: motor port B, 18: motor port C, 19: motor port D; DATA8
        type   type the device shall have; 0: keep the type; a member of TYPE; DATA8
        value  raw value to pretend; DATA32
        """

    def get_figures(
        self,
        layer: _Number,
        no: _Number,
        figures: _Output = None,
        decimals: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Tells how many digits a value of the present mode needs.

        layer     brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
        no        port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1, 1: port 2, 2: port 3, 3:
                  port 4, 16: motor port A, 17: motor port B, 18: motor port C, 19: motor port D; DATA8
        figures   characters in all, with point and decimals; DATA8; an output, in global memory when left
                  away
        decimals  digits after the point; DATA8; an output, in global memory when left away
        """

    def get_changes(self, layer: _Number, no: _Number, value: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads how often a touch sensor changed in positive direction since CLR_CHANGES.

        layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
        no     port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1, 1: port 2, 2: port 3, 3: port
               4, 16: motor port A, 17: motor port B, 18: motor port C, 19: motor port D; DATA8
        value  number of changes, 0 for other sensors; DATAF; an output, in global memory when left away
        """

    def clr_changes(self, layer: _Number, no: _Number, *, unchecked: bool = False) -> Draft:
        """Sets the counts of GET_CHANGES and GET_BUMPS to zero.

        layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
        no     port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1, 1: port 2, 2: port 3, 3: port
               4, 16: motor port A, 17: motor port B, 18: motor port C, 19: motor port D; DATA8
        """

    def ready_pct(
        self,
        layer: _Number,
        no: _Number,
        type: _TYPE,
        mode: _Number,
        values: _Outputs = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Sets type and mode, waits until the device is ready and reads percent values.

        layer   brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
        no      port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1, 1: port 2, 2: port 3, 3: port
                4, 16: motor port A, 17: motor port B, 18: motor port C, 19: motor port D; DATA8
        type    type the device shall have; 0: keep the type; a member of TYPE; DATA8
        mode    mode the device shall have; 0 to 7; -1: keep the mode; DATA8
        values  how many values follow, each in percent; a list of DATA8; an output for each: a list of
                variables, or how many; one when left away
        """

    def ready_raw(
        self,
        layer: _Number,
        no: _Number,
        type: _TYPE,
        mode: _Number,
        values: _Outputs = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Sets type and mode, waits until the device is ready and reads raw values.

        layer   brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
        no      port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1, 1: port 2, 2: port 3, 3: port
                4, 16: motor port A, 17: motor port B, 18: motor port C, 19: motor port D; DATA8
        type    type the device shall have; 0: keep the type; a member of TYPE; DATA8
        mode    mode the device shall have; 0 to 7; -1: keep the mode; DATA8
        values  how many raw values follow; a list of DATA32; an output for each: a list of variables, or
                how many; one when left away
        """

    def ready_si(
        self,
        layer: _Number,
        no: _Number,
        type: _TYPE,
        mode: _Number,
        values: _Outputs = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Sets type and mode, waits until the device is ready and reads SI values.

        layer   brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
        no      port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1, 1: port 2, 2: port 3, 3: port
                4, 16: motor port A, 17: motor port B, 18: motor port C, 19: motor port D; DATA8
        type    type the device shall have; 0: keep the type; a member of TYPE; DATA8
        mode    mode the device shall have; 0 to 7; -1: keep the mode; DATA8
        values  how many values follow, each in SI units; a list of DATAF; an output for each: a list of
                variables, or how many; one when left away
        """

    def get_minmax(
        self,
        layer: _Number,
        no: _Number,
        min: _Output = None,
        max: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Tells between which SI values the present mode moves.

        layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
        no     port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1, 1: port 2, 2: port 3, 3: port
               4, 16: motor port A, 17: motor port B, 18: motor port C, 19: motor port D; DATA8
        min    smallest value in SI units; DATAF; an output, in global memory when left away
        max    largest value in SI units; DATAF; an output, in global memory when left away
        """

    def get_bumps(self, layer: _Number, no: _Number, value: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads how often a touch sensor changed in negative direction since CLR_CHANGES.

        layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
        no     port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1, 1: port 2, 2: port 3, 3: port
               4, 16: motor port A, 17: motor port B, 18: motor port C, 19: motor port D; DATA8
        value  number of changes, 0 for other sensors; DATAF; an output, in global memory when left away
        """

class _File:
    """FILE: Works on files, folders, data logs, program images and the list of recent files."""

    def open_append(self, name: _Text, handle: _Output = None, *, unchecked: bool = False) -> Draft:
        """Opens a file to write at its end, creates it where there is none.

        name    path of the file; a bare name is taken from the program's own folder; at most 119
                characters; string
        handle  what names the file from now on; handle; an output, in global memory when left away
        """

    def open_read(self, name: _Text, handle: _Output = None, size: _Output = None, *, unchecked: bool = False) -> Draft:
        """Opens a file to read.

        name    path of the file; a bare name is taken from the program's own folder; at most 119
                characters; string
        handle  what names the file from now on; handle; an output, in global memory when left away
        size    size of the file; bytes; 0: not found; DATA32; an output, in global memory when left away
        """

    def open_write(self, name: _Text, handle: _Output = None, *, unchecked: bool = False) -> Draft:
        """Creates a file or empties the one there is, and opens it to write.

        name    path of the file; a bare name is taken from the program's own folder; at most 119
                characters; string
        handle  what names the file from now on; handle; an output, in global memory when left away
        """

    def read_value(self, handle: _Number, del_: _DEL, value: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads the text up to the next delimiter and turns it into a number.

        handle  the open file; handle
        del_    what stands between two values in the file; a member of DEL; DATA8
        value   the number, 0 where the text is none; DATAF; an output, in global memory when left away
        """

    def write_value(
        self,
        handle: _Number,
        del_: _DEL,
        value: _Real,
        figures: _Number,
        decimals: _Number,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Writes a number as text, and a delimiter after it.

        handle    the open file; handle
        del_      what stands between two values in the file; a member of DEL; DATA8
        value     the number; DATAF
        figures   least width in characters, the decimal point included; DATA8
        decimals  digits after the decimal point; DATA8
        """

    def read_text(
        self,
        handle: _Number,
        del_: _DEL,
        length: _Number,
        text: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Reads text up to the next delimiter.

        handle  the open file; handle
        del_    what stands between two values in the file; a member of DEL; DATA8
        length  most bytes to read; LEGO's firmware keeps the low 8 bits, so 127; bytes; DATA16
        text    the text, without a zero at its end when it fills all the room; string; an output, in global
                memory when left away
        """

    def write_text(self, handle: _Number, del_: _DEL, text: _Text, *, unchecked: bool = False) -> Draft:
        """Writes text without its zero, and a delimiter after it.

        handle  the open file; handle
        del_    what stands between two values in the file; a member of DEL; DATA8
        text    the text; string
        """

    def close(self, handle: _Number, *, unchecked: bool = False) -> Draft:
        """Closes a file and gives its handle back.

        handle  the open file; handle
        """

    def load_image(
        self,
        prgid: _SLOT,
        name: _Text,
        size: _Output = None,
        ip: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Loads a program file into a stopped slot, for PROGRAM_START to run.

        prgid  slot to load it into; 0 to 4; a member of SLOT; DATA16
        name   path of the program, relative to /home/root/lms2012/sys; .rbf may be left out; at most 119
               characters; string
        size   size of the program; bytes; 0: not loaded; DATA32; an output, in global memory when left away
        ip     where it was loaded, to be handed to PROGRAM_START; 0: not loaded; DATA32; an output, in
               global memory when left away
        """

    def get_handle(
        self,
        name: _Text,
        handle: _Output = None,
        write: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Finds the handle of a file that is already open.

        name    path of the file; a bare name is taken from the program's own folder; at most 119
                characters; string
        handle  the open file; -1: not open; handle; an output, in global memory when left away
        write   whether it is open to write or append; 0: no, 1: yes; DATA8; an output, in global memory
                when left away
        """

    def make_folder(self, name: _Text, success: _Output = None, *, unchecked: bool = False) -> Draft:
        """Creates a folder unless it is there.

        name     path of the folder, relative to /home/root/lms2012/sys; at most 119 characters; string
        success  whether the folder is there now; 0: no, 1: yes; DATA8; an output, in global memory when
                 left away
        """

    def get_pool(self, size: _Number, handle: _Output = None, ip: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reserves a block of memory for the program.

        size    how much memory; 0 to 2147483647 bytes; DATA32
        handle  what names the block from now on; handle; an output, in global memory when left away
        ip      address of the block; DATA32; an output, in global memory when left away
        """

    def set_log_sync_time(self, time: _Number, tick: _Number, *, unchecked: bool = False) -> Draft:
        """Stores the time and tick by which data logs are lined up.

        time  the common time; DATA32
        tick  the brick's tick at that time; DATA32
        """

    def get_folders(self, name: _Text, items: _Output = None, *, unchecked: bool = False) -> Draft:
        """Counts the entries of a folder, hidden ones left out.

        name   path of the folder with its closing slash, such as ../prjs/; at most 119 characters; string
        items  how many entries there are; DATA8; an output, in global memory when left away
        """

    def get_log_sync_time(self, time: _Output = None, tick: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells the time and tick by which data logs are lined up.

        time  the common time; DATA32; an output, in global memory when left away
        tick  the brick's tick at that time; DATA32; an output, in global memory when left away
        """

    def get_subfolder_name(
        self,
        name: _Text,
        item: _Number,
        length: _Number,
        string: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Tells the name of one entry of a folder.

        name    path of the folder with its closing slash, such as ../prjs/; at most 119 characters; string
        item    which entry of the folder, the first is 1; 1 to 127; DATA8
        length  room for the string, its zero included; bytes; DATA8
        string  its name without extension, empty where there is no such entry; string; an output, in global
                memory when left away
        """

    def write_log(
        self,
        handle: _Number,
        time: _Number,
        items: _Number,
        values: _Elements,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Adds one row of samples to a data log.

        handle  the open data log; handle
        time    time of the samples since the log began; ms; DATA32
        items   how many samples; with 0 nothing is written; 0 to 127; DATA8
        values  the samples, in one array; DATAF
        """

    def close_log(self, handle: _Number, name: _Text, *, unchecked: bool = False) -> Draft:
        """Writes a data log to its end and closes it.

        handle  the open data log; handle
        name    path of the log as given to OPEN_LOG; .rdf may be left out; string
        """

    def get_image(
        self,
        name: _Text,
        prgid: _SLOT,
        item: _Number,
        ip: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Loads an entry of a folder; LEGO's 2013 firmware has no code for it and fails.

        name   path of the folder with its closing slash, such as ../prjs/; at most 119 characters; string
        prgid  slot to load it into; a member of SLOT; DATA16
        item   which entry of the folder, the first is 1; 1 to 127; DATA8
        ip     where it was loaded; DATA32; an output, in global memory when left away
        """

    def get_item(self, name: _Text, string: _Text, item: _Output = None, *, unchecked: bool = False) -> Draft:
        """Finds an entry of a folder by its name.

        name    path of the folder with its closing slash, such as ../prjs/; at most 119 characters; string
        string  name to look for, without extension; string
        item    which entry it is, the first is 1; 1 to 127; 0: not found; DATA8; an output, in global
                memory when left away
        """

    def get_cache_files(self, items: _Output = None, *, unchecked: bool = False) -> Draft:
        """Counts the recently run files.

        items  how many there are, 10 at most; DATA8; an output, in global memory when left away
        """

    def put_cache_file(self, string: _Text, *, unchecked: bool = False) -> Draft:
        """Puts a file first in the list of recently run files.

        string  path of the file; string
        """

    def get_cache_file(
        self,
        item: _Number,
        length: _Number,
        string: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Tells the path of one recently run file.

        item    which one, 1 is the latest; 1 to 10; DATA8
        length  room for the string, its zero included; bytes; DATA8
        string  path of the file, empty where there is none; string; an output, in global memory when left
                away
        """

    def del_cache_file(self, string: _Text, *, unchecked: bool = False) -> Draft:
        """Takes a file off the list of recently run files.

        string  path of the file, as PUT_CACHE_FILE got it; string
        """

    def del_subfolder(self, name: _Text, item: _Number, *, unchecked: bool = False) -> Draft:
        """Deletes one entry of a folder together with the files in it.

        name  path of the folder with its closing slash, such as ../prjs/; at most 119 characters; string
        item  which entry of the folder, the first is 1; 1 to 127; DATA8
        """

    def get_log_name(self, length: _Number, name: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells the path of the data log that is open.

        length  room for the string, its zero included; bytes; DATA8
        name    path of the log, empty where none is open; string; an output, in global memory when left
                away
        """

    def open_log(
        self,
        name: _Text,
        syncedtime: _Number,
        syncedtick: _Number,
        nowtick: _Number,
        sample_interval_in_ms: _Number,
        duration_in_ms: _Number,
        sdata: _Text,
        handle: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Creates a data log and writes its header.

        name                   path of the log; .rdf may be left out; with an empty one it stays in memory;
                               string
        syncedtime             the common time, as GET_LOG_SYNC_TIME tells it; DATA32
        syncedtick             the brick's tick at that time; DATA32
        nowtick                the brick's tick at the start of the log; DATA32
        sample_interval_in_ms  time between samples; fast logs are kept in memory first; ms; DATA32
        duration_in_ms         how long the log is to run; ms; DATA32
        sdata                  text that describes the sensors, copied into the header; string
        handle                 what names the log from now on; handle; an output, in global memory when left
                               away
        """

    def read_bytes(
        self,
        handle: _Number,
        bytes: _Number,
        destination: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Reads bytes from a file as they are.

        handle       the open file; handle
        bytes        how many bytes; 0 to 32767 bytes; DATA16
        destination  the bytes; a zero follows where the file ended early; DATA8; an output, in global
                     memory when left away
        """

    def write_bytes(self, handle: _Number, bytes: _Number, source: _Elements, *, unchecked: bool = False) -> Draft:
        """Writes bytes to a file as they are.

        handle  the open file; handle
        bytes   how many bytes; 0 to 32767 bytes; DATA16
        source  the bytes; DATA8
        """

    def remove(self, name: _Text, *, unchecked: bool = False) -> Draft:
        """Deletes a file, or a folder with the files in it.

        name  path of the file; a bare name is taken from the program's own folder; at most 119 characters;
              string
        """

    def move(self, source: _Text, dest: _Text, *, unchecked: bool = False) -> Draft:
        """Copies a file or folder over whatever is at the destination; the source stays.

        source  path to copy from; string
        dest    path to copy to; what is there is deleted first; string
        """

class _Array:
    """ARRAY: Makes, fills, copies and resizes arrays."""

    def delete(self, handle: _Number, *, unchecked: bool = False) -> Draft:
        """Deletes an array and gives its handle back.

        handle  the array; handle
        """

    def create8(self, elements: _Number, handle: _Output = None, *, unchecked: bool = False) -> Draft:
        """Creates an array of DATA8 elements.

        elements  how many elements it has at first; 0 to 2147483647; DATA32
        handle    what names the array from now on; handle; an output, in global memory when left away
        """

    def create16(self, elements: _Number, handle: _Output = None, *, unchecked: bool = False) -> Draft:
        """Creates an array of DATA16 elements.

        elements  how many elements it has at first; 0 to 2147483647; DATA32
        handle    what names the array from now on; handle; an output, in global memory when left away
        """

    def create32(self, elements: _Number, handle: _Output = None, *, unchecked: bool = False) -> Draft:
        """Creates an array of DATA32 elements.

        elements  how many elements it has at first; 0 to 2147483647; DATA32
        handle    what names the array from now on; handle; an output, in global memory when left away
        """

    def createf(self, elements: _Number, handle: _Output = None, *, unchecked: bool = False) -> Draft:
        """Creates an array of DATAF elements.

        elements  how many elements it has at first; 0 to 2147483647; DATA32
        handle    what names the array from now on; handle; an output, in global memory when left away
        """

    def resize(self, handle: _Number, elements: _Number, *, unchecked: bool = False) -> Draft:
        """Changes how many elements an array has.

        handle    the array; handle
        elements  how many elements it has from now on; 0 to 2147483647; DATA32
        """

    def fill(self, handle: _Number, value: _Real, *, unchecked: bool = False) -> Draft:
        """Sets every element of an array to one value.

        handle  the array; handle
        value   the value, of the array's type; array-typed
        """

    def copy(self, hsource: _Number, hdest: _Number, *, unchecked: bool = False) -> Draft:
        """Copies the content of one array into another of the same type, which takes its size.

        hsource  array to copy from; handle
        hdest    array to copy into, which has to exist; handle
        """

    @overload
    def init8(
        self,
        handle: _Number,
        index: _Number,
        elements: _Number | None,
        values: Sequence[_Number],
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Writes several elements of a DATA8 array, all within its size.

        handle    the array; handle
        index     first element to write, counted from 0; 0 to 2147483647; DATA32
        elements  how many values follow; 0 to 2147483647; DATA32; worked out when left away
        values    the values, one parameter each; a list of DATA8
        """

    @overload
    def init8(
        self,
        handle: _Number,
        index: _Number,
        *,
        elements: _Number | None = None,
        values: Sequence[_Number],
        unchecked: bool = False,
    ) -> Draft:
        """Writes several elements of a DATA8 array, all within its size.

        handle    the array; handle
        index     first element to write, counted from 0; 0 to 2147483647; DATA32
        elements  how many values follow; 0 to 2147483647; DATA32; worked out when left away
        values    the values, one parameter each; a list of DATA8
        """

    @overload
    def init16(
        self,
        handle: _Number,
        index: _Number,
        elements: _Number | None,
        values: Sequence[_Number],
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Writes several elements of a DATA16 array, all within its size.

        handle    the array; handle
        index     first element to write, counted from 0; 0 to 2147483647; DATA32
        elements  how many values follow; 0 to 2147483647; DATA32; worked out when left away
        values    the values, one parameter each; a list of DATA16
        """

    @overload
    def init16(
        self,
        handle: _Number,
        index: _Number,
        *,
        elements: _Number | None = None,
        values: Sequence[_Number],
        unchecked: bool = False,
    ) -> Draft:
        """Writes several elements of a DATA16 array, all within its size.

        handle    the array; handle
        index     first element to write, counted from 0; 0 to 2147483647; DATA32
        elements  how many values follow; 0 to 2147483647; DATA32; worked out when left away
        values    the values, one parameter each; a list of DATA16
        """

    @overload
    def init32(
        self,
        handle: _Number,
        index: _Number,
        elements: _Number | None,
        values: Sequence[_Number],
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Writes several elements of a DATA32 array, all within its size.

        handle    the array; handle
        index     first element to write, counted from 0; 0 to 2147483647; DATA32
        elements  how many values follow; 0 to 2147483647; DATA32; worked out when left away
        values    the values, one parameter each; a list of DATA32
        """

    @overload
    def init32(
        self,
        handle: _Number,
        index: _Number,
        *,
        elements: _Number | None = None,
        values: Sequence[_Number],
        unchecked: bool = False,
    ) -> Draft:
        """Writes several elements of a DATA32 array, all within its size.

        handle    the array; handle
        index     first element to write, counted from 0; 0 to 2147483647; DATA32
        elements  how many values follow; 0 to 2147483647; DATA32; worked out when left away
        values    the values, one parameter each; a list of DATA32
        """

    @overload
    def initf(
        self,
        handle: _Number,
        index: _Number,
        elements: _Number | None,
        values: Sequence[_Real],
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Writes several elements of a DATAF array, all within its size.

        handle    the array; handle
        index     first element to write, counted from 0; 0 to 2147483647; DATA32
        elements  how many values follow; 0 to 2147483647; DATA32; worked out when left away
        values    the values, one parameter each; a list of DATAF
        """

    @overload
    def initf(
        self,
        handle: _Number,
        index: _Number,
        *,
        elements: _Number | None = None,
        values: Sequence[_Real],
        unchecked: bool = False,
    ) -> Draft:
        """Writes several elements of a DATAF array, all within its size.

        handle    the array; handle
        index     first element to write, counted from 0; 0 to 2147483647; DATA32
        elements  how many values follow; 0 to 2147483647; DATA32; worked out when left away
        values    the values, one parameter each; a list of DATAF
        """

    def size(self, handle: _Number, elements: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells how many elements an array has.

        handle    the array; handle
        elements  how many elements it has, 0 where there is no such array; DATA32; an output, in global
                  memory when left away
        """

    def read_content(
        self,
        prgid: _SLOT,
        handle: _Number,
        index: _Number,
        bytes: _Number,
        array: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Reads an array's content as bytes, of another program too.

        prgid   slot of the program that owns the array; a member of SLOT; DATA16
        handle  the array; handle
        index   first byte in the array's content, whatever its elements; 0 to 2147483647; DATA32
        bytes   how many bytes; 0 to 2147483647 bytes; DATA32
        array   the bytes, zeros beyond the end of the array; DATA8; an output, in global memory when left
                away
        """

    def write_content(
        self,
        prgid: _SLOT,
        handle: _Number,
        index: _Number,
        bytes: _Number,
        array: _Elements,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Writes an array's content as bytes; the array then ends with them.

        prgid   slot of the program that owns the array; a member of SLOT; DATA16
        handle  the array; handle
        index   first byte in the array's content, whatever its elements; 0 to 2147483647; DATA32
        bytes   how many bytes; 0 to 2147483647 bytes; DATA32
        array   the bytes; DATA8
        """

    def read_size(self, prgid: _SLOT, handle: _Number, bytes: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells how many bytes an array's content has, of another program too.

        prgid   slot of the program that owns the array; a member of SLOT; DATA16
        handle  the array; handle
        bytes   how many bytes, 0 where there is no such array; bytes; DATA32; an output, in global memory
                when left away
        """

class _Filename:
    """FILENAME: Takes file names apart, checks them, and packs files."""

    def exist(self, name: _Text, flag: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells whether a file or folder is there.

        name  path of the file; a bare name is taken from the program's own folder; at most 119 characters;
              string
        flag  whether it is there; 0: no, 1: yes; DATA8; an output, in global memory when left away
        """

    def totalsize(self, name: _Text, files: _Output = None, size: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells how many files a folder has and their size.

        name   path of the folder or file; string
        files  how many entries, with . and .. counted in; 0 for a file; DATA32; an output, in global memory
               when left away
        size   size of all of them, rounded up; KiB; DATA32; an output, in global memory when left away
        """

    def split(
        self,
        filename: _Text,
        length: _Number,
        folder: _Output = None,
        name: _Output = None,
        ext: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Takes a path apart into folder, name and extension.

        filename  the path; string
        length    room for each of the three parts, its zero included; bytes; DATA8
        folder    the folder, on LEGO's firmware with its closing slash; string; an output, in global memory
                  when left away
        name      the name, without folder and extension; string; an output, in global memory when left away
        ext       the extension with its dot; string; an output, in global memory when left away
        """

    def merge(
        self,
        folder: _Text,
        name: _Text,
        ext: _Text,
        length: _Number,
        filename: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Puts a path together from folder, name and extension.

        folder    the folder, without a slash at its end; string
        name      the name; string
        ext       the extension with its dot; string
        length    room for the string, its zero included; bytes; DATA8
        filename  the path; string; an output, in global memory when left away
        """

    def check(self, filename: _Text, ok: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells whether a path has allowed characters and lengths; the file need not exist.

        filename  the path; string
        ok        whether the path can be used; 0: not allowed, 1: allowed; DATA8; an output, in global
                  memory when left away
        """

    def pack(self, filename: _Text, *, unchecked: bool = False) -> Draft:
        """Packs a file or folder into a .raf archive beside it.

        filename  path of what to pack; string
        """

    def unpack(self, filename: _Text, *, unchecked: bool = False) -> Draft:
        """Unpacks a .raf archive into the folder it is in.

        filename  path of the archive; whatever its extension, .raf is taken; string
        """

    def get_foldername(self, length: _Number, foldername: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells the program's own folder.

        length      room for the string, its zero included; bytes; DATA8
        foldername  path of the folder, without a slash at its end; string; an output, in global memory when
                    left away
        """

class _ComRead:
    """COM_READ: Fetches direct commands, for the brick's own command program."""

    def command(
        self,
        length: _Number,
        image: _Output = None,
        global_: _Output = None,
        flag: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Tells where the direct command received last lies in the brick's memory.

        length   most bytes of code, ignored by the firmware; bytes; DATA32
        image    address of the code; DATA32; an output, in global memory when left away
        global_  address of its global memory; DATA32; an output, in global memory when left away
        flag     whether a command waits; 0 to 1; 0: none, 1: ready to run; DATA8; an output, in global
                 memory when left away
        """

class _ComWrite:
    """COM_WRITE: Answers direct commands, for the brick's own command program."""

    def reply(self, image: _Number, global_: _Number, status: _RESULT, *, unchecked: bool = False) -> Draft:
        """Sends the global memory of a direct command that has run as its reply.

        image    address of the code; DATA32
        global_  address of its global memory; DATA32
        status   how it ended, all but OK give DIRECT_REPLY_ERROR; a member of RESULT; DATA8
        """

class _ComGet:
    """COM_GET: Asks about the brick's connections and the devices around it."""

    def get_on_off(self, hardware: _HWTYPE, active: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells whether Bluetooth or WiFi is on.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        active    whether it is on; 0 to 1; 0: off, 1: on; DATA8; an output, in global memory when left away
        """

    def get_visible(self, hardware: _HWTYPE, visible: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells whether other devices can see the brick by Bluetooth.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        visible   whether it is visible; 0 to 1; 0: no, 1: yes; DATA8; an output, in global memory when left
                  away
        """

    def get_result(self, hardware: _HWTYPE, item: _Number, result: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells how a search or connection request is going.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        item      place in the list, ignored by the firmware; DATA8
        result    state of the request; a member of RESULT; DATA8; an output, in global memory when left
                  away
        """

    def get_pin(
        self,
        hardware: _HWTYPE,
        name: _Text,
        length: _Number,
        pincode: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Reads the PIN for a device, always 1234.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        name      name of the other device or network; string
        length    room for the PIN with its zero; bytes; DATA8
        pincode   the PIN; string; an output, in global memory when left away
        """

    def search_items(self, hardware: _HWTYPE, items: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells how many devices or networks a search found.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        items     how many the list has; DATA8; an output, in global memory when left away
        """

    def search_item(
        self,
        hardware: _HWTYPE,
        item: _Number,
        length: _Number,
        name: _Output = None,
        paired: _Output = None,
        connected: _Output = None,
        type: _Output = None,
        visible: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Describes one device or network that a search found.

        hardware   which way to communicate; a member of HWTYPE; DATA8
        item       place in the list, counted from 0; DATA8
        length     room for the text with its zero; bytes; -1: as long as it gets (handles only); DATA8
        name       name of the other device or network; string; an output, in global memory when left away
        paired     whether it is paired (Bluetooth) or known (WiFi); 0 to 1; 0: no, 1: yes; DATA8; an
                   output, in global memory when left away
        connected  whether it is connected; 0 to 1; 0: no, 1: yes; DATA8; an output, in global memory when
                   left away
        type       kind of device (Bluetooth) or encryption (WiFi); 0: WiFi, not encrypted, 1: WiFi, WPA2; a
                   member of BTTYPE; DATA8; an output, in global memory when left away
        visible    whether it is in sight; 0 to 1; 0: no, 1: yes; DATA8; an output, in global memory when
                   left away
        """

    def favour_items(self, hardware: _HWTYPE, items: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells how many devices are paired, in sight or not.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        items     how many the list has; DATA8; an output, in global memory when left away
        """

    def favour_item(
        self,
        hardware: _HWTYPE,
        item: _Number,
        length: _Number,
        name: _Output = None,
        paired: _Output = None,
        connected: _Output = None,
        type: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Describes one paired device or known network.

        hardware   which way to communicate; a member of HWTYPE; DATA8
        item       place in the list, counted from 0; DATA8
        length     room for the text with its zero; bytes; -1: as long as it gets (handles only); DATA8
        name       name of the other device or network; string; an output, in global memory when left away
        paired     whether it is paired (Bluetooth) or known (WiFi); 0 to 1; 0: no, 1: yes; DATA8; an
                   output, in global memory when left away
        connected  whether it is connected; 0 to 1; 0: no, 1: yes; DATA8; an output, in global memory when
                   left away
        type       kind of device (Bluetooth) or encryption (WiFi); 0: WiFi, not encrypted, 1: WiFi, WPA2; a
                   member of BTTYPE; DATA8; an output, in global memory when left away
        """

    def get_id(self, hardware: _HWTYPE, length: _Number, string: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads the brick's Bluetooth address.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        length    room for the text with its zero; bytes; -1: as long as it gets (handles only); DATA8
        string    12 hex digits; string; an output, in global memory when left away
        """

    def get_brickname(self, length: _Number, name: _Output = None, *, unchecked: bool = False) -> Draft:
        """Reads the brick's name.

        length  room for the text with its zero; bytes; -1: as long as it gets (handles only); DATA8
        name    name of the brick; string; an output, in global memory when left away
        """

    def get_network(
        self,
        hardware: _HWTYPE,
        length: _Number,
        name: _Output = None,
        mac: _Output = None,
        ip: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Reads network name and addresses, WiFi only.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        length    room for each of the three texts with its zero; bytes; -1: as long as it gets (handles
                  only); DATA8
        name      name of the network, NONE without one; string; an output, in global memory when left away
        mac       MAC address of the brick, ?? when WiFi is off; string; an output, in global memory when
                  left away
        ip        IP address of the brick, ?? when not connected; string; an output, in global memory when
                  left away
        """

    def get_present(self, hardware: _HWTYPE, ok: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells whether the hardware is there, for WiFi a known dongle.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        ok        whether it is there; 0 to 1; 0: no, 1: yes; DATA8; an output, in global memory when left
                  away
        """

    def get_encrypt(self, hardware: _HWTYPE, item: _Number, type: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells the encryption of a network, WiFi only.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        item      place in the list, counted from 0; DATA8
        type      kind of encryption, the 2013 firmware says none; a member of ENCRYPT; DATA8; an output, in
                  global memory when left away
        """

    def connec_items(self, hardware: _HWTYPE, items: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells how many devices are connected, Bluetooth only.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        items     how many the list has; DATA8; an output, in global memory when left away
        """

    def connec_item(
        self,
        hardware: _HWTYPE,
        item: _Number,
        length: _Number,
        name: _Output = None,
        type: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Describes one connected device, Bluetooth only.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        item      place in the list, counted from 0; DATA8
        length    room for the text with its zero; bytes; -1: as long as it gets (handles only); DATA8
        name      name of the device; string; an output, in global memory when left away
        type      kind of device; a member of BTTYPE; DATA8; an output, in global memory when left away
        """

    def get_incoming(
        self,
        hardware: _HWTYPE,
        length: _Number,
        name: _Output = None,
        type: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Tells which device asks for a connection, Bluetooth only.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        length    room for the text with its zero; bytes; -1: as long as it gets (handles only); DATA8
        name      name of the device; string; an output, in global memory when left away
        type      kind of device; a member of BTTYPE; DATA8; an output, in global memory when left away
        """

    def get_mode2(self, hardware: _HWTYPE, active: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells whether Bluetooth is in its mode for Apple devices.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        active    whether it is on; 0 to 1; 0: off, 1: on; DATA8; an output, in global memory when left away
        """

class _ComSet:
    """COM_SET: Changes the brick's name, its connections and its lists of devices."""

    def set_on_off(self, hardware: _HWTYPE, active: _Number, *, unchecked: bool = False) -> Draft:
        """Switches Bluetooth or WiFi on or off.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        active    whether to switch it on; 0 to 1; 0: off, 1: on; DATA8
        """

    def set_visible(self, hardware: _HWTYPE, visible: _Number, *, unchecked: bool = False) -> Draft:
        """Makes the brick visible or invisible, Bluetooth only.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        visible   whether other devices shall see it; 0 to 1; 0: invisible, 1: visible; DATA8
        """

    def set_search(self, hardware: _HWTYPE, search: _Number, *, unchecked: bool = False) -> Draft:
        """Starts or stops the search for devices or networks.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        search    whether to search; 0 to 1; 0: stop (Bluetooth only), 1: start; DATA8
        """

    def set_pin(self, hardware: _HWTYPE, name: _Text, pincode: _Text, *, unchecked: bool = False) -> Draft:
        """Answers the request for a PIN (Bluetooth) or stores a network's password (WiFi).

        hardware  which way to communicate; a member of HWTYPE; DATA8
        name      name of the other device or network; string
        pincode   PIN or password; string
        """

    def set_passkey(self, hardware: _HWTYPE, accept: _Number, *, unchecked: bool = False) -> Draft:
        """Answers the request to confirm a passkey, Bluetooth only.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        accept    the answer; 0 to 1; 0: reject, 1: accept; DATA8
        """

    def set_connection(self, hardware: _HWTYPE, name: _Text, connection: _Number, *, unchecked: bool = False) -> Draft:
        """Connects a device or network, or ends a Bluetooth connection.

        hardware    which way to communicate; a member of HWTYPE; DATA8
        name        name of the other device or network; string
        connection  what to do; 0 to 1; 0: disconnect, 1: connect; DATA8
        """

    def set_brickname(self, name: _Text, *, unchecked: bool = False) -> Draft:
        """Renames the brick.

        name  new name, at most 118 characters, else refused; at most 118 characters; string
        """

    def set_moveup(self, hardware: _HWTYPE, item: _Number, *, unchecked: bool = False) -> Draft:
        """Moves a network up in the list, WiFi only.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        item      place in the list, counted from 0; DATA8
        """

    def set_movedown(self, hardware: _HWTYPE, item: _Number, *, unchecked: bool = False) -> Draft:
        """Moves a network down in the list, WiFi only.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        item      place in the list, counted from 0; DATA8
        """

    def set_encrypt(self, hardware: _HWTYPE, item: _Text, encrypt: _ENCRYPT, *, unchecked: bool = False) -> Draft:
        """Sets the encryption of a network, WiFi only.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        item      name of the network; string
        encrypt   kind of encryption; a member of ENCRYPT; DATA8
        """

    def set_ssid(self, hardware: _HWTYPE, name: _Text, *, unchecked: bool = False) -> Draft:
        """Adds a network to the end of the list, WiFi only.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        name      name of the network; string
        """

    def set_mode2(self, hardware: _HWTYPE, active: _Number, *, unchecked: bool = False) -> Draft:
        """Switches the Bluetooth mode for Apple devices on or off.

        hardware  which way to communicate; a member of HWTYPE; DATA8
        active    whether to switch it on; 0 to 1; 0: off, 1: on; DATA8
        """

program_info: _ProgramInfo
info: _Info
strings: _Strings
tst: _Tst
math: _Math
ui_read: _UiRead
ui_write: _UiWrite
ui_button: _UiButton
ui_draw: _UiDraw
sound: _Sound
input_device: _InputDevice
file: _File
array: _Array
filename: _Filename
com_read: _ComRead
com_write: _ComWrite
com_get: _ComGet
com_set: _ComSet

def error(*, unchecked: bool = False) -> Draft:
    """Ends the program with a failure; never valid on the wire."""

def nop(*, unchecked: bool = False) -> Draft:
    """Does nothing; a harmless way to see whether the brick answers."""

def program_stop(prgid: _SLOT, *, unchecked: bool = False) -> Draft:
    """Stops the program of a slot.

    prgid  program slot to stop; 0: all programs, -1: the program that says so; a member of SLOT; DATA16
    """

def program_start(prgid: _SLOT, size: _Number, ip: _Number, debug: _Number, *, unchecked: bool = False) -> Draft:
    """Starts a loaded program; by direct command only while no user program runs.

    prgid  program slot; a member of SLOT; DATA16
    size   size of the image; read and ignored; bytes; DATA32
    ip     address of the image, as FILE.LOAD_IMAGE returned it; DATA32
    debug  how to run it; 0 to 2; 0: run, 1: debug, 2: load, do not run; DATA8
    """

def object_stop(objid: _Number, *, unchecked: bool = False) -> Draft:
    """Stops an object of the own program.

    objid  object of the program, counted from 1; DATA16
    """

def object_start(objid: _Number, *, unchecked: bool = False) -> Draft:
    """Starts an object of the own program.

    objid  object of the program, counted from 1; DATA16
    """

def object_trig(objid: _Number, *, unchecked: bool = False) -> Draft:
    """Counts an object's trigger down; at zero the object starts.

    objid  object of the program, counted from 1; DATA16
    """

def object_wait(objid: _Number, *, unchecked: bool = False) -> Draft:
    """Waits until an object has ended.

    objid  object of the program, counted from 1; DATA16
    """

def return_(*, unchecked: bool = False) -> Draft:
    """Returns from a subroutine to its caller."""

def call(objid: _Number, parameters: Sequence[_Number], *, unchecked: bool = False) -> Draft:
    """Calls a subroutine of the own program; waits while another thread is in it.

    objid       object that is the subroutine, counted from 1; DATA16
    parameters  how many parameters follow; the subroutine declares their types and directions; a list
                of DATA32
    """

def object_end(*, unchecked: bool = False) -> Draft:
    """Ends the object; the firmware puts one behind every direct command."""

def sleep(*, unchecked: bool = False) -> Draft:
    """Gives up the rest of the thread's time slice."""

def label(no: _Number, *, unchecked: bool = False) -> Draft:
    """Marks a place that jumps can name; does nothing itself.

    no  number of the label; 0 to 31; label
    """

def probe(prgid: _SLOT, objid: _Number, offset: _Number, size: _Number, *, unchecked: bool = False) -> Draft:
    """Prints a program's memory on the brick's debug terminal.

    prgid   program slot; a member of SLOT; DATA16
    objid   object whose local memory to print; 0: the global memory; DATA16
    offset  where to begin; bytes; DATA32
    size    how much to print; 0 to 1024 bytes; 0: all, 1024 at most; DATA32
    """

def do(prgid: _SLOT, image: _Number, global_: _Number, *, unchecked: bool = False) -> Draft:
    """Runs byte code that is already in memory, ending what the slot ran before.

    prgid    program slot; a member of SLOT; DATA16
    image    address of the byte code image; DATA32
    global_  address of the global memory it uses; DATA32
    """

def system(command: _Text, status: _Output = None, *, unchecked: bool = False) -> Draft:
    """Runs a shell command on the brick's Linux and waits for its end.

    command  the command line; string
    status   wait status as C's system() gives it: 256 times the exit code; 0: success, -1: could not
             run; DATA32; an output, in global memory when left away
    """

def port_cnv_output(
    portin: _Number,
    layer: _Output = None,
    bitfield: _Output = None,
    inverted: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Splits a motor port number as LEGO's editor writes it.

    portin    three decimal digits, each 1-4: layer, first port, second port (123: B and C); DATA32
    layer     position in the daisy chain; 0 to 3; 0: this brick; DATA8; an output, in global memory
              when left away
    bitfield  motor ports as bits: A=1 B=2 C=4 D=8; 0 to 15; DATA8; an output, in global memory when
              left away
    inverted  whether the first port comes after the second, as in C and A; 0 to 1; 0: no, 1: yes;
              DATA8; an output, in global memory when left away
    """

def port_cnv_input(
    portin: _Number,
    layer: _Output = None,
    portout: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Splits a sensor port number as LEGO's editor writes it.

    portin   three decimal digits: layer 1-4, any, port 1-4 (103: port 3); DATA32
    layer    position in the daisy chain; 0 to 3; 0: this brick; DATA8; an output, in global memory when
             left away
    portout  sensor port less one, as INPUT_* takes it; 0 to 3; DATA8; an output, in global memory when
             left away
    """

def note_to_freq(note: _Text, freq: _Output = None, *, unchecked: bool = False) -> Draft:
    """Converts the name of a note to its frequency.

    note  C4 to B6, sharps as C#4; string
    freq  frequency; 440 for a note it does not know; 262 to 1976 Hz; DATA16; an output, in global
          memory when left away
    """

def bp0(*, unchecked: bool = False) -> Draft:
    """Stops at breakpoint 0; BP_SET puts it over the instruction it replaces."""

def bp1(*, unchecked: bool = False) -> Draft:
    """Stops at breakpoint 1; BP_SET puts it over the instruction it replaces."""

def bp2(*, unchecked: bool = False) -> Draft:
    """Stops at breakpoint 2; BP_SET puts it over the instruction it replaces."""

def bp3(*, unchecked: bool = False) -> Draft:
    """Pulses test pin TP4 and goes on; BP_SET puts it over the instruction it replaces."""

def bp_set(prgid: _SLOT, no: _Number, address: _Number, *, unchecked: bool = False) -> Draft:
    """Sets or removes a breakpoint in a running program.

    prgid    program slot; a member of SLOT; DATA16
    no       number of the breakpoint; 0 to 2; 3: pulse on test pin TP4, no stop; DATA8
    address  where in the image; bytes; 0: remove the breakpoint; DATA32
    """

def add8(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Adds two 8-bit numbers.

    source1      first number; DATA8
    source2      second number; DATA8
    destination  their sum; DATA8; an output, in global memory when left away
    """

def add16(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Adds two 16-bit numbers.

    source1      first number; DATA16
    source2      second number; DATA16
    destination  their sum; DATA16; an output, in global memory when left away
    """

def add32(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Adds two 32-bit numbers.

    source1      first number; DATA32
    source2      second number; DATA32
    destination  their sum; DATA32; an output, in global memory when left away
    """

def addf(source1: _Real, source2: _Real, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Adds two floating-point numbers.

    source1      first number; DATAF
    source2      second number; DATAF
    destination  their sum; DATAF; an output, in global memory when left away
    """

def sub8(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Subtracts one 8-bit number from another.

    source1      number to subtract from; DATA8
    source2      number to subtract; DATA8
    destination  SOURCE1 less SOURCE2; DATA8; an output, in global memory when left away
    """

def sub16(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Subtracts one 16-bit number from another.

    source1      number to subtract from; DATA16
    source2      number to subtract; DATA16
    destination  SOURCE1 less SOURCE2; DATA16; an output, in global memory when left away
    """

def sub32(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Subtracts one 32-bit number from another.

    source1      number to subtract from; DATA32
    source2      number to subtract; DATA32
    destination  SOURCE1 less SOURCE2; DATA32; an output, in global memory when left away
    """

def subf(source1: _Real, source2: _Real, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Subtracts one floating-point number from another.

    source1      number to subtract from; DATAF
    source2      number to subtract; DATAF
    destination  SOURCE1 less SOURCE2; DATAF; an output, in global memory when left away
    """

def mul8(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Multiplies two 8-bit numbers.

    source1      first factor; DATA8
    source2      second factor; DATA8
    destination  their product; DATA8; an output, in global memory when left away
    """

def mul16(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Multiplies two 16-bit numbers.

    source1      first factor; DATA16
    source2      second factor; DATA16
    destination  their product; DATA16; an output, in global memory when left away
    """

def mul32(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Multiplies two 32-bit numbers.

    source1      first factor; DATA32
    source2      second factor; DATA32
    destination  their product; DATA32; an output, in global memory when left away
    """

def mulf(source1: _Real, source2: _Real, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Multiplies two floating-point numbers.

    source1      first factor; DATAF
    source2      second factor; DATAF
    destination  their product; DATAF; an output, in global memory when left away
    """

def div8(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Divides two 8-bit numbers; by zero gives the largest or smallest value.

    source1      number to divide; DATA8
    source2      number to divide by; DATA8
    destination  quotient, cut off towards zero (0 for 0 / 0); DATA8; an output, in global memory when
                 left away
    """

def div16(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Divides two 16-bit numbers; by zero gives the largest or smallest value.

    source1      number to divide; DATA16
    source2      number to divide by; DATA16
    destination  quotient, cut off towards zero (0 for 0 / 0); DATA16; an output, in global memory when
                 left away
    """

def div32(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Divides two 32-bit numbers; by zero gives the largest or smallest value.

    source1      number to divide; DATA32
    source2      number to divide by; DATA32
    destination  quotient, cut off towards zero (0 for 0 / 0); DATA32; an output, in global memory when
                 left away
    """

def divf(source1: _Real, source2: _Real, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Divides two floating-point numbers; by zero gives infinity or NaN.

    source1      number to divide; DATAF
    source2      number to divide by; DATAF
    destination  quotient; DATAF; an output, in global memory when left away
    """

def or8(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 8-bit values, bit by bit, by OR.

    source1      first; DATA8
    source2      second; DATA8
    destination  bits set in either; DATA8; an output, in global memory when left away
    """

def or16(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 16-bit values, bit by bit, by OR.

    source1      first; DATA16
    source2      second; DATA16
    destination  bits set in either; DATA16; an output, in global memory when left away
    """

def or32(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 32-bit values, bit by bit, by OR.

    source1      first; DATA32
    source2      second; DATA32
    destination  bits set in either; DATA32; an output, in global memory when left away
    """

def and8(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 8-bit values, bit by bit, by AND.

    source1      first; DATA8
    source2      second; DATA8
    destination  bits set in both; DATA8; an output, in global memory when left away
    """

def and16(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 16-bit values, bit by bit, by AND.

    source1      first; DATA16
    source2      second; DATA16
    destination  bits set in both; DATA16; an output, in global memory when left away
    """

def and32(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 32-bit values, bit by bit, by AND.

    source1      first; DATA32
    source2      second; DATA32
    destination  bits set in both; DATA32; an output, in global memory when left away
    """

def xor8(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 8-bit values, bit by bit, by exclusive OR.

    source1      first; DATA8
    source2      second; DATA8
    destination  bits set in just one of the two; DATA8; an output, in global memory when left away
    """

def xor16(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 16-bit values, bit by bit, by exclusive OR.

    source1      first; DATA16
    source2      second; DATA16
    destination  bits set in just one of the two; DATA16; an output, in global memory when left away
    """

def xor32(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 32-bit values, bit by bit, by exclusive OR.

    source1      first; DATA32
    source2      second; DATA32
    destination  bits set in just one of the two; DATA32; an output, in global memory when left away
    """

def rl8(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Shifts 8-bit values left; despite the name (rotate), bits leaving on the left are lost.

    source1      value to shift; DATA8
    source2      how many places; bits; DATA8
    destination  shifted value, filled up with zero bits; DATA8; an output, in global memory when left
                 away
    """

def rl16(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Shifts 16-bit values left; despite the name (rotate), bits leaving on the left are lost.

    source1      value to shift; DATA16
    source2      how many places; bits; DATA16
    destination  shifted value, filled up with zero bits; DATA16; an output, in global memory when left
                 away
    """

def rl32(source1: _Number, source2: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Shifts 32-bit values left; despite the name (rotate), bits leaving on the left are lost.

    source1      value to shift; DATA32
    source2      how many places; bits; DATA32
    destination  shifted value, filled up with zero bits; DATA32; an output, in global memory when left
                 away
    """

def random(min: _Number, max: _Number, value: _Output = None, *, unchecked: bool = False) -> Draft:
    """Draws a random whole number.

    min    smallest number to draw; DATA16
    max    largest number to draw; DATA16
    value  the number drawn, MIN to MAX, both included; DATA16; an output, in global memory when left
           away
    """

@overload
def init_bytes(
    destination: _Output,
    length: _Number | None,
    source: Sequence[_Number],
    *,
    unchecked: bool = False,
) -> Draft:
    """Fills consecutive bytes of memory with values given in place.

    destination  first byte to fill; DATA8; an output, in global memory when left away
    length       how many values follow; a negative count hangs the brick; bytes; DATA32; worked out
                 when left away
    source       the values, one per byte; a list of DATA8
    """

@overload
def init_bytes(
    *,
    destination: _Output = None,
    length: _Number | None = None,
    source: Sequence[_Number],
    unchecked: bool = False,
) -> Draft:
    """Fills consecutive bytes of memory with values given in place.

    destination  first byte to fill; DATA8; an output, in global memory when left away
    length       how many values follow; a negative count hangs the brick; bytes; DATA32; worked out
                 when left away
    source       the values, one per byte; a list of DATA8
    """

def move8_8(source: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Copies a value to another variable, both 8-bit.

    source       value to copy; DATA8
    destination  copy of the value; DATA8; an output, in global memory when left away
    """

def move8_16(source: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 8-bit to 16-bit; NaN stays NaN.

    source       value to copy; DATA8
    destination  copy of the value; DATA16; an output, in global memory when left away
    """

def move8_32(source: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 8-bit to 32-bit; NaN stays NaN.

    source       value to copy; DATA8
    destination  copy of the value; DATA32; an output, in global memory when left away
    """

def move8_f(source: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 8-bit to floating-point; NaN stays NaN.

    source       value to copy; DATA8
    destination  copy of the value; DATAF; an output, in global memory when left away
    """

def move16_8(source: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 16-bit to 8-bit; limited to what fits, NaN stays NaN.

    source       value to copy; DATA16
    destination  copy of the value; DATA8; an output, in global memory when left away
    """

def move16_16(source: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Copies a value to another variable, both 16-bit.

    source       value to copy; DATA16
    destination  copy of the value; DATA16; an output, in global memory when left away
    """

def move16_32(source: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 16-bit to 32-bit; NaN stays NaN.

    source       value to copy; DATA16
    destination  copy of the value; DATA32; an output, in global memory when left away
    """

def move16_f(source: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 16-bit to floating-point; NaN stays NaN.

    source       value to copy; DATA16
    destination  copy of the value; DATAF; an output, in global memory when left away
    """

def move32_8(source: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 32-bit to 8-bit; limited to what fits, NaN stays NaN.

    source       value to copy; DATA32
    destination  copy of the value; DATA8; an output, in global memory when left away
    """

def move32_16(source: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 32-bit to 16-bit; limited to what fits, NaN stays NaN.

    source       value to copy; DATA32
    destination  copy of the value; DATA16; an output, in global memory when left away
    """

def move32_32(source: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Copies a value to another variable, both 32-bit.

    source       value to copy; DATA32
    destination  copy of the value; DATA32; an output, in global memory when left away
    """

def move32_f(source: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 32-bit to floating-point; NaN stays NaN.

    source       value to copy; DATA32
    destination  copy of the value; DATAF; an output, in global memory when left away
    """

def movef_8(source: _Real, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, floating-point to 8-bit; limited to what fits, NaN stays NaN.

    source       value to copy; DATAF
    destination  copy of the value; DATA8; an output, in global memory when left away
    """

def movef_16(source: _Real, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, floating-point to 16-bit; limited to what fits, NaN stays NaN.

    source       value to copy; DATAF
    destination  copy of the value; DATA16; an output, in global memory when left away
    """

def movef_32(source: _Real, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, floating-point to 32-bit; limited to what fits, NaN stays NaN.

    source       value to copy; DATAF
    destination  copy of the value; DATA32; an output, in global memory when left away
    """

def movef_f(source: _Real, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Copies a value to another variable, both floating-point.

    source       value to copy; DATAF
    destination  copy of the value; DATAF; an output, in global memory when left away
    """

def read8(source: _Number, index: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Takes one element out of an array of 8-bit values.

    source       first element of the array, as a variable; DATA8
    index        which element, counted from 0; the firmware does not check it; 0 to 127; DATA8
    destination  the element's value; DATA8; an output, in global memory when left away
    """

def read16(source: _Number, index: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Takes one element out of an array of 16-bit values.

    source       first element of the array, as a variable; DATA16
    index        which element, counted from 0; the firmware does not check it; 0 to 127; DATA8
    destination  the element's value; DATA16; an output, in global memory when left away
    """

def read32(source: _Number, index: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Takes one element out of an array of 32-bit values.

    source       first element of the array, as a variable; DATA32
    index        which element, counted from 0; the firmware does not check it; 0 to 127; DATA8
    destination  the element's value; DATA32; an output, in global memory when left away
    """

def readf(source: _Real, index: _Number, destination: _Output = None, *, unchecked: bool = False) -> Draft:
    """Takes one element out of an array of floating-point values.

    source       first element of the array, as a variable; DATAF
    index        which element, counted from 0; the firmware does not check it; 0 to 127; DATA8
    destination  the element's value; DATAF; an output, in global memory when left away
    """

def write8(source: _Number, index: _Number, destination: _Number, *, unchecked: bool = False) -> Draft:
    """Sets one element of an array of 8-bit values.

    source       value to set; DATA8
    index        which element, counted from 0; the firmware does not check it; 0 to 127; DATA8
    destination  first element of the array, as a variable; element INDEX is written; DATA8
    """

def write16(source: _Number, index: _Number, destination: _Number, *, unchecked: bool = False) -> Draft:
    """Sets one element of an array of 16-bit values.

    source       value to set; DATA16
    index        which element, counted from 0; the firmware does not check it; 0 to 127; DATA8
    destination  first element of the array, as a variable; element INDEX is written; DATA16
    """

def write32(source: _Number, index: _Number, destination: _Number, *, unchecked: bool = False) -> Draft:
    """Sets one element of an array of 32-bit values.

    source       value to set; DATA32
    index        which element, counted from 0; the firmware does not check it; 0 to 127; DATA8
    destination  first element of the array, as a variable; element INDEX is written; DATA32
    """

def writef(source: _Real, index: _Number, destination: _Real, *, unchecked: bool = False) -> Draft:
    """Sets one element of an array of floating-point values.

    source       value to set; DATAF
    index        which element, counted from 0; the firmware does not check it; 0 to 127; DATA8
    destination  first element of the array, as a variable; element INDEX is written; DATAF
    """

def jr(offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps always.

    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_false(flag: _Number, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if a flag is 0.

    flag    the condition: anything but 0 is true; 0: false, 1: true; DATA8
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_true(flag: _Number, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if a flag is not 0.

    flag    the condition: anything but 0 is true; 0: false, 1: true; DATA8
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_nan(value: _Real, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if a value is not a number, as a sensor without data gives.

    value   value to look at; DATAF
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_lt8(left: _Number, right: _Number, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than RIGHT, as 8-bit numbers.

    left    left side of the comparison; DATA8
    right   right side of the comparison; DATA8
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_lt16(left: _Number, right: _Number, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than RIGHT, as 16-bit numbers.

    left    left side of the comparison; DATA16
    right   right side of the comparison; DATA16
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_lt32(left: _Number, right: _Number, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than RIGHT, as 32-bit numbers.

    left    left side of the comparison; DATA32
    right   right side of the comparison; DATA32
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_ltf(left: _Real, right: _Real, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than RIGHT, as floating-point numbers.

    left    left side of the comparison; DATAF
    right   right side of the comparison; DATAF
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_gt8(left: _Number, right: _Number, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than RIGHT, as 8-bit numbers.

    left    left side of the comparison; DATA8
    right   right side of the comparison; DATA8
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_gt16(left: _Number, right: _Number, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than RIGHT, as 16-bit numbers.

    left    left side of the comparison; DATA16
    right   right side of the comparison; DATA16
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_gt32(left: _Number, right: _Number, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than RIGHT, as 32-bit numbers.

    left    left side of the comparison; DATA32
    right   right side of the comparison; DATA32
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_gtf(left: _Real, right: _Real, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than RIGHT, as floating-point numbers.

    left    left side of the comparison; DATAF
    right   right side of the comparison; DATAF
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_eq8(left: _Number, right: _Number, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is equal to RIGHT, as 8-bit numbers.

    left    left side of the comparison; DATA8
    right   right side of the comparison; DATA8
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_eq16(left: _Number, right: _Number, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is equal to RIGHT, as 16-bit numbers.

    left    left side of the comparison; DATA16
    right   right side of the comparison; DATA16
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_eq32(left: _Number, right: _Number, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is equal to RIGHT, as 32-bit numbers.

    left    left side of the comparison; DATA32
    right   right side of the comparison; DATA32
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_eqf(left: _Real, right: _Real, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is equal to RIGHT, as floating-point numbers.

    left    left side of the comparison; DATAF
    right   right side of the comparison; DATAF
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_neq8(left: _Number, right: _Number, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is different from RIGHT, as 8-bit numbers.

    left    left side of the comparison; DATA8
    right   right side of the comparison; DATA8
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_neq16(left: _Number, right: _Number, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is different from RIGHT, as 16-bit numbers.

    left    left side of the comparison; DATA16
    right   right side of the comparison; DATA16
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_neq32(left: _Number, right: _Number, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is different from RIGHT, as 32-bit numbers.

    left    left side of the comparison; DATA32
    right   right side of the comparison; DATA32
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_neqf(left: _Real, right: _Real, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is different from RIGHT, as floating-point numbers.

    left    left side of the comparison; DATAF
    right   right side of the comparison; DATAF
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_lteq8(left: _Number, right: _Number, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than or equal to RIGHT, as 8-bit numbers.

    left    left side of the comparison; DATA8
    right   right side of the comparison; DATA8
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_lteq16(left: _Number, right: _Number, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than or equal to RIGHT, as 16-bit numbers.

    left    left side of the comparison; DATA16
    right   right side of the comparison; DATA16
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_lteq32(left: _Number, right: _Number, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than or equal to RIGHT, as 32-bit numbers.

    left    left side of the comparison; DATA32
    right   right side of the comparison; DATA32
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_lteqf(left: _Real, right: _Real, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than or equal to RIGHT, as floating-point numbers.

    left    left side of the comparison; DATAF
    right   right side of the comparison; DATAF
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_gteq8(left: _Number, right: _Number, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than or equal to RIGHT, as 8-bit numbers.

    left    left side of the comparison; DATA8
    right   right side of the comparison; DATA8
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_gteq16(left: _Number, right: _Number, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than or equal to RIGHT, as 16-bit numbers.

    left    left side of the comparison; DATA16
    right   right side of the comparison; DATA16
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_gteq32(left: _Number, right: _Number, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than or equal to RIGHT, as 32-bit numbers.

    left    left side of the comparison; DATA32
    right   right side of the comparison; DATA32
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def jr_gteqf(left: _Real, right: _Real, offset: _Number, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than or equal to RIGHT, as floating-point numbers.

    left    left side of the comparison; DATAF
    right   right side of the comparison; DATAF
    offset  how far to jump from the end of this operation; negative jumps back; or a label; bytes;
            label
    """

def cp_lt8(left: _Number, right: _Number, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is less than RIGHT, as 8-bit numbers.

    left   left side of the comparison; DATA8
    right  right side of the comparison; DATA8
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_lt16(left: _Number, right: _Number, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is less than RIGHT, as 16-bit numbers.

    left   left side of the comparison; DATA16
    right  right side of the comparison; DATA16
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_lt32(left: _Number, right: _Number, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is less than RIGHT, as 32-bit numbers.

    left   left side of the comparison; DATA32
    right  right side of the comparison; DATA32
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_ltf(left: _Real, right: _Real, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is less than RIGHT, as floating-point numbers.

    left   left side of the comparison; DATAF
    right  right side of the comparison; DATAF
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_gt8(left: _Number, right: _Number, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is greater than RIGHT, as 8-bit numbers.

    left   left side of the comparison; DATA8
    right  right side of the comparison; DATA8
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_gt16(left: _Number, right: _Number, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is greater than RIGHT, as 16-bit numbers.

    left   left side of the comparison; DATA16
    right  right side of the comparison; DATA16
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_gt32(left: _Number, right: _Number, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is greater than RIGHT, as 32-bit numbers.

    left   left side of the comparison; DATA32
    right  right side of the comparison; DATA32
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_gtf(left: _Real, right: _Real, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is greater than RIGHT, as floating-point numbers.

    left   left side of the comparison; DATAF
    right  right side of the comparison; DATAF
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_eq8(left: _Number, right: _Number, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is equal to RIGHT, as 8-bit numbers.

    left   left side of the comparison; DATA8
    right  right side of the comparison; DATA8
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_eq16(left: _Number, right: _Number, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is equal to RIGHT, as 16-bit numbers.

    left   left side of the comparison; DATA16
    right  right side of the comparison; DATA16
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_eq32(left: _Number, right: _Number, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is equal to RIGHT, as 32-bit numbers.

    left   left side of the comparison; DATA32
    right  right side of the comparison; DATA32
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_eqf(left: _Real, right: _Real, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is equal to RIGHT, as floating-point numbers.

    left   left side of the comparison; DATAF
    right  right side of the comparison; DATAF
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_neq8(left: _Number, right: _Number, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is different from RIGHT, as 8-bit numbers.

    left   left side of the comparison; DATA8
    right  right side of the comparison; DATA8
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_neq16(left: _Number, right: _Number, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is different from RIGHT, as 16-bit numbers.

    left   left side of the comparison; DATA16
    right  right side of the comparison; DATA16
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_neq32(left: _Number, right: _Number, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is different from RIGHT, as 32-bit numbers.

    left   left side of the comparison; DATA32
    right  right side of the comparison; DATA32
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_neqf(left: _Real, right: _Real, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is different from RIGHT, as floating-point numbers.

    left   left side of the comparison; DATAF
    right  right side of the comparison; DATAF
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_lteq8(left: _Number, right: _Number, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is less than or equal to RIGHT, as 8-bit numbers.

    left   left side of the comparison; DATA8
    right  right side of the comparison; DATA8
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_lteq16(left: _Number, right: _Number, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is less than or equal to RIGHT, as 16-bit numbers.

    left   left side of the comparison; DATA16
    right  right side of the comparison; DATA16
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_lteq32(left: _Number, right: _Number, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is less than or equal to RIGHT, as 32-bit numbers.

    left   left side of the comparison; DATA32
    right  right side of the comparison; DATA32
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_lteqf(left: _Real, right: _Real, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is less than or equal to RIGHT, as floating-point numbers.

    left   left side of the comparison; DATAF
    right  right side of the comparison; DATAF
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_gteq8(left: _Number, right: _Number, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is greater than or equal to RIGHT, as 8-bit numbers.

    left   left side of the comparison; DATA8
    right  right side of the comparison; DATA8
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_gteq16(left: _Number, right: _Number, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is greater than or equal to RIGHT, as 16-bit numbers.

    left   left side of the comparison; DATA16
    right  right side of the comparison; DATA16
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_gteq32(left: _Number, right: _Number, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is greater than or equal to RIGHT, as 32-bit numbers.

    left   left side of the comparison; DATA32
    right  right side of the comparison; DATA32
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def cp_gteqf(left: _Real, right: _Real, flag: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is greater than or equal to RIGHT, as floating-point numbers.

    left   left side of the comparison; DATAF
    right  right side of the comparison; DATAF
    flag   whether it holds; 0 to 1; 0: false, 1: true; DATA8; an output, in global memory when left
           away
    """

def select8(
    flag: _Number,
    source1: _Number,
    source2: _Number,
    result: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Takes one of two 8-bit values, whichever the flag says.

    flag     which to take: anything but 0 takes SOURCE1; 0: SOURCE2, 1: SOURCE1; DATA8
    source1  value taken if the flag is set; DATA8
    source2  value taken if the flag is 0; DATA8
    result   the value taken; DATA8; an output, in global memory when left away
    """

def select16(
    flag: _Number,
    source1: _Number,
    source2: _Number,
    result: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Takes one of two 16-bit values, whichever the flag says.

    flag     which to take: anything but 0 takes SOURCE1; 0: SOURCE2, 1: SOURCE1; DATA8
    source1  value taken if the flag is set; DATA16
    source2  value taken if the flag is 0; DATA16
    result   the value taken; DATA16; an output, in global memory when left away
    """

def select32(
    flag: _Number,
    source1: _Number,
    source2: _Number,
    result: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Takes one of two 32-bit values, whichever the flag says.

    flag     which to take: anything but 0 takes SOURCE1; 0: SOURCE2, 1: SOURCE1; DATA8
    source1  value taken if the flag is set; DATA32
    source2  value taken if the flag is 0; DATA32
    result   the value taken; DATA32; an output, in global memory when left away
    """

def selectf(
    flag: _Number,
    source1: _Real,
    source2: _Real,
    result: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Takes one of two floating-point values, whichever the flag says.

    flag     which to take: anything but 0 takes SOURCE1; 0: SOURCE2, 1: SOURCE1; DATA8
    source1  value taken if the flag is set; DATAF
    source2  value taken if the flag is 0; DATAF
    result   the value taken; DATAF; an output, in global memory when left away
    """

def ui_flush(*, unchecked: bool = False) -> Draft:
    """Sends what was written for the terminal and is still in its buffer."""

def keep_alive(minutes: _Output = None, *, unchecked: bool = False) -> Draft:
    """Restarts the time after which the idle brick switches off, and reads it.

    minutes  idle time before switching off; min; 0: never; DATA8; an output, in global memory when left
             away
    """

def timer_wait(time: _Number, timer: _Output = None, *, unchecked: bool = False) -> Draft:
    """Notes when a wait will be over and returns at once; TIMER_READY does the waiting.

    time   how long to wait; 0 to 2147483647 ms; DATA32
    timer  variable that gets the end of the wait, on the brick's millisecond clock; DATA32; an output,
           in global memory when left away
    """

def timer_ready(timer: _Number, *, unchecked: bool = False) -> Draft:
    """Waits until the time that TIMER_WAIT noted has come.

    timer  variable that TIMER_WAIT has set; DATA32
    """

def timer_read(time: _Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the time since the program or direct command that asks was started.

    time  time since the start; ms; DATA32; an output, in global memory when left away
    """

def timer_read_us(time: _Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the free-running microsecond clock, for differences only.

    time  low 32 bits of the clock, back to 0 every 71.6 minutes; us; DATA32; an output, in global
          memory when left away
    """

def sound_test(busy: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether a sound is playing.

    busy  whether a sound is playing; 0 to 1; 0: ready, 1: busy; DATA8; an output, in global memory when
          left away
    """

def sound_ready(*, unchecked: bool = False) -> Draft:
    """Waits until the sound has ended (for ever after REPEAT or a tone without end)."""

def input_sample(
    time: _Number,
    samples: _Number,
    init: _Elements,
    devices: _Elements,
    types: _TYPE,
    modes: _Elements,
    datasets: _Elements,
    values: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Reads one SI value of each of several devices, sampled in the background.

    time      time between two samples; ms; DATA32
    samples   how many devices the arrays list; DATA16
    init      place in the sample buffer of each device, -1 starts it anew; DATA16
    devices   ports, 0 to 3 for sensors, 4 to 7 for motors A to D; DATA8
    types     type each device shall have; a member of TYPE; DATA8
    modes     mode each device shall have; DATA8
    datasets  which of its values to read from each device, from 0; DATA8
    values    one value per device, NaN where there is none; DATAF; an output, in global memory when
              left away
    """

def input_device_list(
    length: _Number,
    array: _Output = None,
    changed: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Lists the types of all devices, sensor ports of each layer first, then motor ports.

    length   room in the array, 32 takes the whole daisy chain; DATA8
    array    type of device at each port; a member of TYPE; DATA8; an output, in global memory when left
             away
    changed  whether devices came or went since the last call; 0: no change; DATA8; an output, in global
             memory when left away
    """

def input_read(
    layer: _Number,
    no: _Number,
    type: _TYPE,
    mode: _Number,
    pct: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Sets type and mode and reads the first value in percent at once.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    no     port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1, 1: port 2, 2: port 3, 3: port
           4, 16: motor port A, 17: motor port B, 18: motor port C, 19: motor port D; DATA8
    type   type the device shall have; 0: keep the type; a member of TYPE; DATA8
    mode   mode the device shall have; 0 to 7; -1: keep the mode; DATA8
    pct    value, NaN where there is none; %; DATA8; an output, in global memory when left away
    """

def input_test(layer: _Number, no: _Number, busy: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether a device is still changing type or mode.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    no     port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1, 1: port 2, 2: port 3, 3: port
           4, 16: motor port A, 17: motor port B, 18: motor port C, 19: motor port D; DATA8
    busy   whether to wait; 0 to 1; 0: ready, 1: busy; DATA8; an output, in global memory when left away
    """

def input_ready(layer: _Number, no: _Number, *, unchecked: bool = False) -> Draft:
    """Waits until a device has valid values.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    no     port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1, 1: port 2, 2: port 3, 3: port
           4, 16: motor port A, 17: motor port B, 18: motor port C, 19: motor port D; DATA8
    """

def input_readsi(
    layer: _Number,
    no: _Number,
    type: _TYPE,
    mode: _Number,
    si: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Sets type and mode and reads the first value in SI units at once.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    no     port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1, 1: port 2, 2: port 3, 3: port
           4, 16: motor port A, 17: motor port B, 18: motor port C, 19: motor port D; DATA8
    type   type the device shall have; 0: keep the type; a member of TYPE; DATA8
    mode   mode the device shall have; 0 to 7; -1: keep the mode; DATA8
    si     value in the mode's unit, NaN where there is none; DATAF; an output, in global memory when
           left away
    """

def input_readext(
    layer: _Number,
    no: _Number,
    type: _TYPE,
    mode: _Number,
    format: _DATA_FORMAT,
    values: _Outputs = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Sets type and mode and reads several values at once, in the format asked for.

    layer   brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    no      port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1, 1: port 2, 2: port 3, 3: port
            4, 16: motor port A, 17: motor port B, 18: motor port C, 19: motor port D; DATA8
    type    type the device shall have; 0: keep the type; a member of TYPE; DATA8
    mode    mode the device shall have; 0 to 7; -1: keep the mode; DATA8
    format  DATA_PCT, DATA_RAW or DATA_SI, others give NaN; a member of DATA_FORMAT; DATA8
    values  how many values follow, each in FORMAT; a list, of the type that format tells; an output for
            each: a list of variables, or how many; one when left away
    """

def input_write(layer: _Number, no: _Number, bytes: _Number, data: _Elements, *, unchecked: bool = False) -> Draft:
    """Sends bytes to a UART sensor.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    no     sensor port, counted from 0; 0 to 3; 0: port 1, 1: port 2, 2: port 3, 3: port 4; DATA8
    bytes  how many bytes to send; 1 to 32 bytes; DATA8
    data   bytes to send; DATA8
    """

def output_set_type(layer: _Number, no: _Number, type: _TYPE, *, unchecked: bool = False) -> Draft:
    """Declares which type of motor is at a port.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    no     port, counted from 0; 0 to 3; 0: A, 1: B, 2: C, 3: D; DATA8
    type   type of the motor; a member of TYPE; DATA8
    """

def output_reset(layer: _Number, nos: _Number, *, unchecked: bool = False) -> Draft:
    """Sets the tacho counts that moves and OUTPUT_READ use to zero.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    nos    ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none, 1: A, 2: B, 3: A+B, 4: C, 5: A+C,
           6: B+C, 7: A+B+C, 8: D, 9: A+D, 10: B+D, 11: A+B+D, 12: C+D, 13: A+C+D, 14: B+C+D, 15:
           A+B+C+D; DATA8
    """

def output_stop(layer: _Number, nos: _Number, brake: _Number, *, unchecked: bool = False) -> Draft:
    """Stops motors.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    nos    ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none, 1: A, 2: B, 3: A+B, 4: C, 5: A+C,
           6: B+C, 7: A+B+C, 8: D, 9: A+D, 10: B+D, 11: A+B+D, 12: C+D, 13: A+C+D, 14: B+C+D, 15:
           A+B+C+D; DATA8
    brake  what the motors do at the end; 0 to 1; 0: coast, 1: brake and hold; DATA8
    """

def output_power(layer: _Number, nos: _Number, power: _Number, *, unchecked: bool = False) -> Draft:
    """Sets the power of motors, OUTPUT_START makes them run.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    nos    ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none, 1: A, 2: B, 3: A+B, 4: C, 5: A+C,
           6: B+C, 7: A+B+C, 8: D, 9: A+D, 10: B+D, 11: A+B+D, 12: C+D, 13: A+C+D, 14: B+C+D, 15:
           A+B+C+D; DATA8
    power  unregulated power, negative: backward; -100 to 100 %; DATA8
    """

def output_speed(layer: _Number, nos: _Number, speed: _Number, *, unchecked: bool = False) -> Draft:
    """Sets the speed of motors, OUTPUT_START makes them run.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    nos    ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none, 1: A, 2: B, 3: A+B, 4: C, 5: A+C,
           6: B+C, 7: A+B+C, 8: D, 9: A+D, 10: B+D, 11: A+B+D, 12: C+D, 13: A+C+D, 14: B+C+D, 15:
           A+B+C+D; DATA8
    speed  regulated speed, negative: backward; -100 to 100 %; DATA8
    """

def output_start(layer: _Number, nos: _Number, *, unchecked: bool = False) -> Draft:
    """Starts motors with the power or speed set before.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    nos    ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none, 1: A, 2: B, 3: A+B, 4: C, 5: A+C,
           6: B+C, 7: A+B+C, 8: D, 9: A+D, 10: B+D, 11: A+B+D, 12: C+D, 13: A+C+D, 14: B+C+D, 15:
           A+B+C+D; DATA8
    """

def output_polarity(layer: _Number, nos: _Number, pol: _Number, *, unchecked: bool = False) -> Draft:
    """Sets the direction of motors.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    nos    ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none, 1: A, 2: B, 3: A+B, 4: C, 5: A+C,
           6: B+C, 7: A+B+C, 8: D, 9: A+D, 10: B+D, 11: A+B+D, 12: C+D, 13: A+C+D, 14: B+C+D, 15:
           A+B+C+D; DATA8
    pol    direction; -1 to 1; -1: backward, 0: opposite of the present one, 1: forward; DATA8
    """

def output_read(
    layer: _Number,
    no: _Number,
    speed: _Output = None,
    tacho: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Reads speed and tacho count of one motor, 0 on layers other than 0.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    no     port, counted from 0; 0 to 3; 0: A, 1: B, 2: C, 3: D; DATA8
    speed  present speed; -100 to 100 %; DATA8; an output, in global memory when left away
    tacho  angle since OUTPUT_RESET; degrees; DATA32; an output, in global memory when left away
    """

def output_test(layer: _Number, nos: _Number, busy: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether one of the motors is still in a move that ends by itself.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    nos    ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none, 1: A, 2: B, 3: A+B, 4: C, 5: A+C,
           6: B+C, 7: A+B+C, 8: D, 9: A+D, 10: B+D, 11: A+B+D, 12: C+D, 13: A+C+D, 14: B+C+D, 15:
           A+B+C+D; DATA8
    busy   whether to wait; 0 to 1; 0: ready, 1: busy; DATA8; an output, in global memory when left away
    """

def output_ready(layer: _Number, nos: _Number, *, unchecked: bool = False) -> Draft:
    """Waits until the moves of the motors have ended, OUTPUT_START does not count.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    nos    ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none, 1: A, 2: B, 3: A+B, 4: C, 5: A+C,
           6: B+C, 7: A+B+C, 8: D, 9: A+D, 10: B+D, 11: A+B+D, 12: C+D, 13: A+C+D, 14: B+C+D, 15:
           A+B+C+D; DATA8
    """

def output_step_power(
    layer: _Number,
    nos: _Number,
    power: _Number,
    step1: _Number,
    step2: _Number,
    step3: _Number,
    brake: _Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Turns motors by an angle with unregulated power.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    nos    ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none, 1: A, 2: B, 3: A+B, 4: C, 5: A+C,
           6: B+C, 7: A+B+C, 8: D, 9: A+D, 10: B+D, 11: A+B+D, 12: C+D, 13: A+C+D, 14: B+C+D, 15:
           A+B+C+D; DATA8
    power  unregulated power, negative: backward; -100 to 100 %; DATA8
    step1  angle of the ramp up; 0 to 2147483647 degrees; DATA32
    step2  angle at constant drive; 0 to 2147483647 degrees; DATA32
    step3  angle of the ramp down; 0 to 2147483647 degrees; DATA32
    brake  what the motors do at the end; 0 to 1; 0: coast, 1: brake and hold; DATA8
    """

def output_time_power(
    layer: _Number,
    nos: _Number,
    power: _Number,
    time1: _Number,
    time2: _Number,
    time3: _Number,
    brake: _Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Runs motors for a time with unregulated power.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    nos    ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none, 1: A, 2: B, 3: A+B, 4: C, 5: A+C,
           6: B+C, 7: A+B+C, 8: D, 9: A+D, 10: B+D, 11: A+B+D, 12: C+D, 13: A+C+D, 14: B+C+D, 15:
           A+B+C+D; DATA8
    power  unregulated power, negative: backward; -100 to 100 %; DATA8
    time1  time of the ramp up; 0 to 2147483647 ms; DATA32
    time2  time at constant drive; 0 to 2147483647 ms; DATA32
    time3  time of the ramp down; 0 to 2147483647 ms; DATA32
    brake  what the motors do at the end; 0 to 1; 0: coast, 1: brake and hold; DATA8
    """

def output_step_speed(
    layer: _Number,
    nos: _Number,
    speed: _Number,
    step1: _Number,
    step2: _Number,
    step3: _Number,
    brake: _Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Turns motors by an angle with regulated speed.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    nos    ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none, 1: A, 2: B, 3: A+B, 4: C, 5: A+C,
           6: B+C, 7: A+B+C, 8: D, 9: A+D, 10: B+D, 11: A+B+D, 12: C+D, 13: A+C+D, 14: B+C+D, 15:
           A+B+C+D; DATA8
    speed  regulated speed, negative: backward; -100 to 100 %; DATA8
    step1  angle of the ramp up; 0 to 2147483647 degrees; DATA32
    step2  angle at constant drive; 0 to 2147483647 degrees; DATA32
    step3  angle of the ramp down; 0 to 2147483647 degrees; DATA32
    brake  what the motors do at the end; 0 to 1; 0: coast, 1: brake and hold; DATA8
    """

def output_time_speed(
    layer: _Number,
    nos: _Number,
    speed: _Number,
    time1: _Number,
    time2: _Number,
    time3: _Number,
    brake: _Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Runs motors for a time with regulated speed.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    nos    ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none, 1: A, 2: B, 3: A+B, 4: C, 5: A+C,
           6: B+C, 7: A+B+C, 8: D, 9: A+D, 10: B+D, 11: A+B+D, 12: C+D, 13: A+C+D, 14: B+C+D, 15:
           A+B+C+D; DATA8
    speed  regulated speed, negative: backward; -100 to 100 %; DATA8
    time1  time of the ramp up; 0 to 2147483647 ms; DATA32
    time2  time at constant drive; 0 to 2147483647 ms; DATA32
    time3  time of the ramp down; 0 to 2147483647 ms; DATA32
    brake  what the motors do at the end; 0 to 1; 0: coast, 1: brake and hold; DATA8
    """

def output_step_sync(
    layer: _Number,
    nos: _Number,
    speed: _Number,
    turn: _Number,
    step: _Number,
    brake: _Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Turns two motors in step by an angle.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    nos    ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none, 1: A, 2: B, 3: A+B, 4: C, 5: A+C,
           6: B+C, 7: A+B+C, 8: D, 9: A+D, 10: B+D, 11: A+B+D, 12: C+D, 13: A+C+D, 14: B+C+D, 15:
           A+B+C+D; DATA8
    speed  regulated speed, negative: backward; -100 to 100 %; DATA8
    turn   how tight the turn is, positive slows the higher port, negative the lower; -200 to 200; -200:
           spin, lower port runs backward, -100: lower port stands, 0: straight, 100: higher port
           stands, 200: spin, higher port runs backward; DATA16
    step   angle of the faster motor; 0 to 2147483647 degrees; 0: no end; DATA32
    brake  what the motors do at the end; 0 to 1; 0: coast, 1: brake and hold; DATA8
    """

def output_time_sync(
    layer: _Number,
    nos: _Number,
    speed: _Number,
    turn: _Number,
    time: _Number,
    brake: _Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Runs two motors in step for a time.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    nos    ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none, 1: A, 2: B, 3: A+B, 4: C, 5: A+C,
           6: B+C, 7: A+B+C, 8: D, 9: A+D, 10: B+D, 11: A+B+D, 12: C+D, 13: A+C+D, 14: B+C+D, 15:
           A+B+C+D; DATA8
    speed  regulated speed, negative: backward; -100 to 100 %; DATA8
    turn   how tight the turn is, positive slows the higher port, negative the lower; -200 to 200; -200:
           spin, lower port runs backward, -100: lower port stands, 0: straight, 100: higher port
           stands, 200: spin, higher port runs backward; DATA16
    time   how long to run; 0 to 2147483647 ms; 0: no end; DATA32
    brake  what the motors do at the end; 0 to 1; 0: coast, 1: brake and hold; DATA8
    """

def output_clr_count(layer: _Number, nos: _Number, *, unchecked: bool = False) -> Draft:
    """Sets the tacho counts that motors have as sensors to zero.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    nos    ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none, 1: A, 2: B, 3: A+B, 4: C, 5: A+C,
           6: B+C, 7: A+B+C, 8: D, 9: A+D, 10: B+D, 11: A+B+D, 12: C+D, 13: A+C+D, 14: B+C+D, 15:
           A+B+C+D; DATA8
    """

def output_get_count(layer: _Number, nos: _Number, tacho: _Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the tacho count that a motor has as a sensor.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    nos    port, counted from 0; 0 to 3; 0: A, 1: B, 2: C, 3: D; DATA8
    tacho  angle since OUTPUT_CLR_COUNT; degrees; DATA32; an output, in global memory when left away
    """

def output_prg_stop(*, unchecked: bool = False) -> Draft:
    """Stops and resets all motors as the end of a program does."""

def memory_write(
    prgid: _SLOT,
    objid: _Number,
    offset: _Number,
    size: _Number,
    array: _Elements,
    *,
    unchecked: bool = False,
) -> Draft:
    """Writes bytes into the variables of a running program.

    prgid   slot of the program, which has to be running; 0 to 4; a member of SLOT; DATA16
    objid   object whose local memory is meant; 0: the program's global memory; DATA16
    offset  first byte in that memory; 0 to 2147483647 bytes; DATA32
    size    how many bytes; 0 to 2147483647 bytes; DATA32
    array   the bytes; those beyond the end of the memory are dropped; DATA8
    """

def memory_read(
    prgid: _SLOT,
    objid: _Number,
    offset: _Number,
    size: _Number,
    array: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Reads bytes from the variables of a running program.

    prgid   slot of the program, which has to be running; 0 to 4; a member of SLOT; DATA16
    objid   object whose local memory is meant; 0: the program's global memory; DATA16
    offset  first byte in that memory; 0 to 2147483647 bytes; DATA32
    size    how many bytes; 0 to 2147483647 bytes; DATA32
    array   the bytes, zeros beyond the end of the memory; DATA8; an output, in global memory when left
            away
    """

def array_write(handle: _Number, index: _Number, value: _Real, *, unchecked: bool = False) -> Draft:
    """Writes one element of an array, which grows where needed.

    handle  the array; handle
    index   which element, the first is 0; 0 to 2147483647; DATA32
    value   the value, of the array's type; array-typed
    """

def array_read(handle: _Number, index: _Number, value: _Output = None, *, unchecked: bool = False) -> Draft:
    """Reads one element of an array.

    handle  the array; handle
    index   which element, the first is 0; 0 to 2147483647; DATA32
    value   the value, of the array's type; array-typed; an output, in global memory when left away
    """

def array_append(handle: _Number, value: _Real, *, unchecked: bool = False) -> Draft:
    """Adds one element to the end of an array.

    handle  the array; handle
    value   the value, of the array's type; array-typed
    """

def memory_usage(total: _Output = None, free: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells how much memory for user files there is and how much of it is free.

    total  all of it; KiB; DATA32; an output, in global memory when left away
    free   what is free; KiB; DATA32; an output, in global memory when left away
    """

def com_ready(hardware: _HWTYPE, name: _Text, *, unchecked: bool = False) -> Draft:
    """Waits until nothing is being sent to a device.

    hardware  which way to communicate; a member of HWTYPE; DATA8
    name      name of the other device, empty: the brick's own adapter; string
    """

def com_readdata(
    value1: _HWTYPE,
    value2: _Number,
    value3: _Number,
    value4: _Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Does nothing in the firmware, meant to receive data.

    value1  which way to communicate, ignored; a member of HWTYPE; DATA8
    value2  name of the other device, ignored; DATA8
    value3  number of bytes, ignored; bytes; DATA16
    value4  the bytes, ignored; DATA8
    """

def com_writedata(
    value1: _HWTYPE,
    value2: _Number,
    value3: _Number,
    value4: _Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Does nothing in the firmware, meant to send data.

    value1  which way to communicate, ignored; a member of HWTYPE; DATA8
    value2  name of the other device, ignored; DATA8
    value3  number of bytes, ignored; bytes; DATA16
    value4  the bytes, ignored; DATA8
    """

def com_test(hardware: _HWTYPE, name: _Text, busy: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether something is still being sent to a device.

    hardware  which way to communicate; a member of HWTYPE; DATA8
    name      name of the other device, empty: the brick's own adapter; string
    busy      whether to wait; 0 to 1; 0: ready, 1: busy; DATA8; an output, in global memory when left
              away
    """

def com_remove(hardware: _HWTYPE, remote_name: _Text, *, unchecked: bool = False) -> Draft:
    """Forgets a paired device or a known network.

    hardware     which way to communicate; a member of HWTYPE; DATA8
    remote_name  name of the other device or network; string
    """

def com_writefile(
    hardware: _HWTYPE,
    remote_name: _Text,
    file_name: _Text,
    file_type: _FILETYPE,
    *,
    unchecked: bool = False,
) -> Draft:
    """Sends a file or a folder to another brick, Bluetooth only.

    hardware     which way to communicate; a member of HWTYPE; DATA8
    remote_name  name of the other device or network; string
    file_name    path of the file or folder on this brick; string
    file_type    TYPE_FOLDER for a folder, else a file; a member of FILETYPE; DATA8
    """

def mailbox_open(
    no: _Number,
    boxname: _Text,
    types: _DATA_FORMAT,
    fifosize: _Number,
    values: _Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Opens a mailbox on this brick, at most 250 bytes of content.

    no        number of the mailbox on this brick; 0 to 29; DATA8
    boxname   name of the mailbox, at most 49 characters; at most 49 characters; string
    types     type of its values; a member of DATA_FORMAT; DATA8
    fifosize  depth of the queue, ignored by the firmware; DATA8
    values    number of values, ignored by the firmware; DATA8
    """

def mailbox_write(
    brickname: _Text,
    hardware: _HWTYPE,
    boxname: _Text,
    type: _DATA_FORMAT,
    values: Sequence[_Untyped],
    *,
    unchecked: bool = False,
) -> Draft:
    """Sends values to a mailbox of another brick, Bluetooth only.

    brickname  name of the other brick, empty: all connected ones; string
    hardware   which way to communicate; a member of HWTYPE; DATA8
    boxname    name of the mailbox; string
    type       type of the values; a member of DATA_FORMAT; DATA8
    values     how many values of TYPE follow, one only for a string; a list, of the type that type
               tells
    """

def mailbox_read(no: _Number, length: _Number, values: _Outputs = None, *, unchecked: bool = False) -> Draft:
    """Reads the content of a mailbox and marks it read.

    no      number of the mailbox on this brick; 0 to 29; DATA8
    length  most bytes to read, ignored by the firmware; bytes; DATA8
    values  how many values follow, of the type given to MAILBOX_OPEN; a list of array-typed; an output
            for each: a list of variables, or how many; one when left away
    """

def mailbox_test(no: _Number, busy: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether a mailbox has an unread message.

    no    number of the mailbox on this brick; 0 to 29; DATA8
    busy  whether to wait; 0 to 1; 0: a new message is there, 1: nothing new; DATA8; an output, in
          global memory when left away
    """

def mailbox_ready(no: _Number, *, unchecked: bool = False) -> Draft:
    """Waits for an unread message in a mailbox.

    no  number of the mailbox on this brick; 0 to 29; DATA8
    """

def mailbox_close(no: _Number, *, unchecked: bool = False) -> Draft:
    """Closes a mailbox on this brick.

    no  number of the mailbox on this brick; 0 to 29; DATA8
    """
