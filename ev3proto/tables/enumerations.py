"""The firmware's names for numbers: ports, buttons, colours, icons, device types, results.

Each enumeration is defined once; the parameters that use it refer to it. ENUMERATIONS holds them all. FORMAT_TYPES
maps a DATA_FORMAT to a type, for counts whose element is the name of a parameter (FORMAT, TYPE).
"""

from collections.abc import Mapping

from ev3proto.tables.declaration import ARRAY_TYPED, DATA8, DATA16, DATA32, DATAF, STRING, Enumeration, Type

TYPE = Enumeration(
    "TYPE",
    "Types of devices on the ports; MODE_KEEP and TYPE_KEEP ask to leave mode or type as it is",
    {
        "MODE_KEEP": -1,
        "TYPE_KEEP": 0,
        "TYPE_NXT_TOUCH": 1,
        "TYPE_NXT_LIGHT": 2,
        "TYPE_NXT_SOUND": 3,
        "TYPE_NXT_COLOR": 4,
        "TYPE_NXT_ULTRASONIC": 5,
        "TYPE_NXT_TEMPERATURE": 6,
        "TYPE_TACHO": 7,
        "TYPE_MINITACHO": 8,
        "TYPE_NEWTACHO": 9,
        "TYPE_TOUCH": 16,
        "TYPE_COLOR": 29,
        "TYPE_ULTRASONIC": 30,
        "TYPE_GYRO": 32,
        "TYPE_IR": 33,
        "TYPE_THIRD_PARTY_START": 50,
        "TYPE_THIRD_PARTY_END": 98,
        "TYPE_ENERGYMETER": 99,
        "TYPE_IIC_UNKNOWN": 100,
        "TYPE_NXT_TEST": 101,
        "TYPE_NXT_IIC": 123,
        "TYPE_TERMINAL": 124,
        "TYPE_UNKNOWN": 125,
        "TYPE_NONE": 126,
        "TYPE_ERROR": 127,
    },
)

SLOT = Enumeration(
    "SLOT",
    "Program slots of the virtual machine; direct commands run in CMD_SLOT",
    {
        "GUI_SLOT": 0,
        "USER_SLOT": 1,
        "CMD_SLOT": 2,
        "TERM_SLOT": 3,
        "DEBUG_SLOT": 4,
        "CURRENT_SLOT": -1,
    },
    end=("SLOTS", 5),
)

BUTTONTYPE = Enumeration(
    "BUTTONTYPE",
    "Buttons of the brick",
    {
        "NO_BUTTON": 0,
        "UP_BUTTON": 1,
        "ENTER_BUTTON": 2,
        "DOWN_BUTTON": 3,
        "RIGHT_BUTTON": 4,
        "LEFT_BUTTON": 5,
        "BACK_BUTTON": 6,
        "ANY_BUTTON": 7,
    },
    end=("BUTTONTYPES", 8),
)

BROWSERTYPE = Enumeration(
    "BROWSERTYPE",
    "What the file browser on the display lists",
    {
        "BROWSE_FOLDERS": 0,
        "BROWSE_FOLDS_FILES": 1,
        "BROWSE_CACHE": 2,
        "BROWSE_FILES": 3,
    },
    end=("BROWSERTYPES", 4),
)

FONTTYPE = Enumeration(
    "FONTTYPE",
    "Fonts of the display",
    {
        "NORMAL_FONT": 0,
        "SMALL_FONT": 1,
        "LARGE_FONT": 2,
        "TINY_FONT": 3,
    },
    end=("FONTTYPES", 4),
)

ICONTYPE = Enumeration(
    "ICONTYPE",
    "Sets of icons; the set decides what an icon's number means",
    {
        "NORMAL_ICON": 0,
        "SMALL_ICON": 1,
        "LARGE_ICON": 2,
        "MENU_ICON": 3,
        "ARROW_ICON": 4,
    },
    end=("ICONTYPES", 5),
)

S_ICON_NO = Enumeration(
    "S_ICON_NO",
    "Icons of the set SMALL_ICON: battery, Bluetooth, WiFi and USB in the top line",
    {
        "SICON_CHARGING": 0,
        "SICON_BATT_4": 1,
        "SICON_BATT_3": 2,
        "SICON_BATT_2": 3,
        "SICON_BATT_1": 4,
        "SICON_BATT_0": 5,
        "SICON_WAIT1": 6,
        "SICON_WAIT2": 7,
        "SICON_BT_ON": 8,
        "SICON_BT_VISIBLE": 9,
        "SICON_BT_CONNECTED": 10,
        "SICON_BT_CONNVISIB": 11,
        "SICON_WIFI_3": 12,
        "SICON_WIFI_2": 13,
        "SICON_WIFI_1": 14,
        "SICON_WIFI_CONNECTED": 15,
        "SICON_USB": 21,
    },
    end=("S_ICON_NOS", 22),
)

N_ICON_NO = Enumeration(
    "N_ICON_NO",
    "Icons of the set NORMAL_ICON: files, folders and settings",
    {
        "ICON_NONE": -1,
        "ICON_RUN": 0,
        "ICON_FOLDER": 1,
        "ICON_FOLDER2": 2,
        "ICON_USB": 3,
        "ICON_SD": 4,
        "ICON_SOUND": 5,
        "ICON_IMAGE": 6,
        "ICON_SETTINGS": 7,
        "ICON_ONOFF": 8,
        "ICON_SEARCH": 9,
        "ICON_WIFI": 10,
        "ICON_CONNECTIONS": 11,
        "ICON_ADD_HIDDEN": 12,
        "ICON_TRASHBIN": 13,
        "ICON_VISIBILITY": 14,
        "ICON_KEY": 15,
        "ICON_CONNECT": 16,
        "ICON_DISCONNECT": 17,
        "ICON_UP": 18,
        "ICON_DOWN": 19,
        "ICON_WAIT1": 20,
        "ICON_WAIT2": 21,
        "ICON_BLUETOOTH": 22,
        "ICON_INFO": 23,
        "ICON_TEXT": 24,
        "ICON_QUESTIONMARK": 27,
        "ICON_INFO_FILE": 28,
        "ICON_DISC": 29,
        "ICON_CONNECTED": 30,
        "ICON_OBP": 31,
        "ICON_OBD": 32,
        "ICON_OPENFOLDER": 33,
        "ICON_BRICK1": 34,
    },
    end=("N_ICON_NOS", 35),
)

L_ICON_NO = Enumeration(
    "L_ICON_NO",
    "Icons of the set LARGE_ICON: answers, warnings and file operations",
    {
        "YES_NOTSEL": 0,
        "YES_SEL": 1,
        "NO_NOTSEL": 2,
        "NO_SEL": 3,
        "OFF": 4,
        "WAIT_VERT": 5,
        "WAIT_HORZ": 6,
        "TO_MANUAL": 7,
        "WARNSIGN": 8,
        "WARN_BATT": 9,
        "WARN_POWER": 10,
        "WARN_TEMP": 11,
        "NO_USBSTICK": 12,
        "TO_EXECUTE": 13,
        "TO_BRICK": 14,
        "TO_SDCARD": 15,
        "TO_USBSTICK": 16,
        "TO_BLUETOOTH": 17,
        "TO_WIFI": 18,
        "TO_TRASH": 19,
        "TO_COPY": 20,
        "TO_FILE": 21,
        "CHAR_ERROR": 22,
        "COPY_ERROR": 23,
        "PROGRAM_ERROR": 24,
        "WARN_MEMORY": 27,
    },
    end=("L_ICON_NOS", 28),
)

M_ICON_NO = Enumeration(
    "M_ICON_NO",
    "Icons of the set MENU_ICON: kinds of Bluetooth peers, locks and check boxes",
    {
        "ICON_STAR": 0,
        "ICON_LOCKSTAR": 1,
        "ICON_LOCK": 2,
        "ICON_PC": 3,
        "ICON_PHONE": 4,
        "ICON_BRICK": 5,
        "ICON_UNKNOWN": 6,
        "ICON_FROM_FOLDER": 7,
        "ICON_CHECKBOX": 8,
        "ICON_CHECKED": 9,
        "ICON_XED": 10,
    },
    end=("M_ICON_NOS", 11),
)

A_ICON_NO = Enumeration(
    "A_ICON_NO",
    "Icons of the set ARROW_ICON: small arrows",
    {
        "ICON_LEFT": 1,
        "ICON_RIGHT": 2,
    },
    end=("A_ICON_NOS", 3),
)

BTTYPE = Enumeration(
    "BTTYPE",
    "Kinds of Bluetooth peers, numbered like their icons in the set MENU_ICON",
    {
        "BTTYPE_PC": 3,
        "BTTYPE_PHONE": 4,
        "BTTYPE_BRICK": 5,
        "BTTYPE_UNKNOWN": 6,
    },
    end=("BTTYPES", 7),
)

LEDPATTERN = Enumeration(
    "LEDPATTERN",
    "Colours and rhythms of the light behind the buttons",
    {
        "LED_BLACK": 0,
        "LED_GREEN": 1,
        "LED_RED": 2,
        "LED_ORANGE": 3,
        "LED_GREEN_FLASH": 4,
        "LED_RED_FLASH": 5,
        "LED_ORANGE_FLASH": 6,
        "LED_GREEN_PULSE": 7,
        "LED_RED_PULSE": 8,
        "LED_ORANGE_PULSE": 9,
    },
    end=("LEDPATTERNS", 10),
)

LEDTYPE = Enumeration(
    "LEDTYPE",
    "Single lights behind the buttons: right or left, red or green",
    {
        "LED_ALL": 0,
        "LED_RR": 1,
        "LED_RG": 2,
        "LED_LR": 3,
        "LED_LG": 4,
    },
)

FILETYPE = Enumeration(
    "FILETYPE",
    "Kinds of files in the browser; it ORs TYPE_SDCARD or TYPE_USBSTICK to the kind found there",
    {
        "FILETYPE_UNKNOWN": 0,
        "TYPE_FOLDER": 1,
        "TYPE_SOUND": 2,
        "TYPE_BYTECODE": 3,
        "TYPE_GRAPHICS": 4,
        "TYPE_DATALOG": 5,
        "TYPE_PROGRAM": 6,
        "TYPE_TEXT": 7,
        "TYPE_SDCARD": 16,
        "TYPE_USBSTICK": 32,
        "TYPE_RESTART_BROWSER": -1,
        "TYPE_REFRESH_BROWSER": -2,
    },
    end=("FILETYPES", 33),
)

RESULT = Enumeration(
    "RESULT",
    "Result of an operation, or that it is still running",
    {
        "OK": 0,
        "BUSY": 1,
        "FAIL": 2,
        "STOP": 4,
        "START": 8,
    },
)

DATA_FORMAT = Enumeration(
    "DATA_FORMAT",
    "Formats of values, for sensors and mailboxes; FORMAT_TYPES has their types",
    {
        "DATA_8": 0,
        "DATA_16": 1,
        "DATA_32": 2,
        "DATA_F": 3,
        "DATA_S": 4,
        "DATA_A": 5,
        "DATA_V": 7,
        "DATA_PCT": 16,
        "DATA_RAW": 18,
        "DATA_SI": 19,
    },
    end=("DATA_FORMATS", 20),
)

FORMAT_TYPES: Mapping[int, Type] = {
    0: DATA8,
    1: DATA16,
    2: DATA32,
    3: DATAF,
    4: STRING,
    5: ARRAY_TYPED,  # DATA_A, an array's handle
    7: ARRAY_TYPED,  # DATA_V, of any type
    16: DATA8,  # DATA_PCT, percent
    18: DATA32,  # DATA_RAW, as the sensor sent it
    19: DATAF,  # DATA_SI, in the sensor's unit
}
"""The type of the values by their DATA_FORMAT."""

DEL = Enumeration(
    "DEL",
    "Separators between two values in a text file",
    {
        "DEL_NONE": 0,
        "DEL_TAB": 1,
        "DEL_SPACE": 2,
        "DEL_RETURN": 3,
        "DEL_COLON": 4,
        "DEL_COMMA": 5,
        "DEL_LINEFEED": 6,
        "DEL_CRLF": 7,
    },
    end=("DELS", 8),
)

HWTYPE = Enumeration(
    "HWTYPE",
    "Carriers of the protocol",
    {
        "HW_USB": 1,
        "HW_BT": 2,
        "HW_WIFI": 3,
    },
    end=("HWTYPES", 4),
)

ENCRYPT = Enumeration(
    "ENCRYPT",
    "Encryption of a WiFi network",
    {
        "ENCRYPT_NONE": 0,
        "ENCRYPT_WPA2": 1,
    },
    end=("ENCRYPTS", 2),
    dialects=("official", "compat"),
)

LMS_ENCRYPT = Enumeration(
    "LMS_ENCRYPT",
    "Encryption of a WiFi network, under the names of the extended firmware",
    {
        "LMS_ENCRYPT_NONE": 0,
        "LMS_ENCRYPT_WPA2": 1,
    },
    end=("LMS_ENCRYPTS", 2),
    dialects=("xtended",),
)

COLOR = Enumeration(
    "COLOR",
    "Colour channels of the NXT colour sensor; BLANK is the reading without light",
    {
        "RED": 0,
        "GREEN": 1,
        "BLUE": 2,
        "BLANK": 3,
    },
    end=("COLORS", 4),
)

NXTCOLOR = Enumeration(
    "NXTCOLOR",
    "Colours that a colour sensor recognises",
    {
        "BLACKCOLOR": 1,
        "BLUECOLOR": 2,
        "GREENCOLOR": 3,
        "YELLOWCOLOR": 4,
        "REDCOLOR": 5,
        "WHITECOLOR": 6,
    },
)

# The only set of bits here. OBJSTAT and RESULT use single bits too, but one at a time; FILETYPE ORs two of its
# members to plain numbers.
WARNING = Enumeration(
    "WARNING",
    "Warnings of the brick, one bit each; WARNINGS masks those shown to the user",
    {
        "WARNING_TEMP": 1,
        "WARNING_CURRENT": 2,
        "WARNING_VOLTAGE": 4,
        "WARNING_MEMORY": 8,
        "WARNING_DSPSTAT": 16,
        "WARNING_RAM": 32,
        "WARNING_BATTLOW": 64,
        "WARNING_BUSY": 128,
    },
    end=("WARNINGS", 63),
    flags=True,
)

OBJSTAT = Enumeration(
    "OBJSTAT",
    "State of a program or object; one at a time, though each number is a single bit",
    {
        "RUNNING": 16,
        "WAITING": 32,
        "STOPPED": 64,
        "HALTED": 128,
    },
)

DEVCMD = Enumeration(
    "DEVCMD",
    "Commands to a UART sensor; DEVCMD_FIRE is another name of DEVCMD_RESET (compat lacks it)",
    {
        "DEVCMD_RESET": 17,
        "DEVCMD_FIRE": 17,
        "DEVCMD_CHANNEL": 18,
    },
    end=("DEVCMDS", 19),
)

CONN = Enumeration(
    "CONN",
    "Kinds of connection that a port detects",
    {
        "CONN_UNKNOWN": 111,
        "CONN_DAISYCHAIN": 117,
        "CONN_NXT_COLOR": 118,
        "CONN_NXT_DUMB": 119,
        "CONN_NXT_IIC": 120,
        "CONN_INPUT_DUMB": 121,
        "CONN_INPUT_UART": 122,
        "CONN_OUTPUT_DUMB": 123,
        "CONN_OUTPUT_INTELLIGENT": 124,
        "CONN_OUTPUT_TACHO": 125,
        "CONN_NONE": 126,
        "CONN_ERROR": 127,
    },
)

ENUMERATIONS: tuple[Enumeration, ...] = tuple(found for found in vars().values() if isinstance(found, Enumeration))
"""All of them, in the order of this file."""

NUMBERS: dict[str, int] = {}
"""Every name with its number, including the `end` names. If a name occurs more than once, the first one counts."""

for _found in ENUMERATIONS:
    for _name, _number in (*_found.members.items(), *((_found.end,) if _found.end else ())):
        NUMBERS.setdefault(_name, _number)
