"""The firmware's enumerations for use in Python: `LED.RED_FLASH`, `BUTTON.UP`, `TYPE.TYPE_TOUCH`.

Each is a class under the firmware's name with members under the firmware's names
(`LEDPATTERN.LED_RED_FLASH`). Where all members begin or end with the same word, they have a name without
it, too, and the class has that word as a second name (`LED.RED_FLASH`).

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

# ruff: noqa: N801 - the names are the firmware's

from enum import IntEnum, IntFlag

from ev3proto.errors import MemberNames

__all__ = [
    "A_ICON_NO",
    "BROWSE",
    "BROWSERTYPE",
    "BTTYPE",
    "BUTTON",
    "BUTTONTYPE",
    "COLOR",
    "CONN",
    "DATA_FORMAT",
    "DEL",
    "DEVCMD",
    "ENCRYPT",
    "FILETYPE",
    "FONT",
    "FONTTYPE",
    "HW",
    "HWTYPE",
    "ICON",
    "ICONTYPE",
    "LED",
    "LEDPATTERN",
    "LEDTYPE",
    "LMS_ENCRYPT",
    "L_ICON_NO",
    "M_ICON_NO",
    "NXTCOLOR",
    "N_ICON_NO",
    "OBJSTAT",
    "RESULT",
    "SICON",
    "SLOT",
    "S_ICON_NO",
    "TYPE",
    "WARNING",
]


class TYPE(IntEnum, metaclass=MemberNames):
    """Types of devices on the ports; MODE_KEEP and TYPE_KEEP ask to leave mode or type as it is."""

    MODE_KEEP = -1
    TYPE_KEEP = 0
    TYPE_NXT_TOUCH = 1
    TYPE_NXT_LIGHT = 2
    TYPE_NXT_SOUND = 3
    TYPE_NXT_COLOR = 4
    TYPE_NXT_ULTRASONIC = 5
    TYPE_NXT_TEMPERATURE = 6
    TYPE_TACHO = 7
    TYPE_MINITACHO = 8
    TYPE_NEWTACHO = 9
    TYPE_TOUCH = 16
    TYPE_COLOR = 29
    TYPE_ULTRASONIC = 30
    TYPE_GYRO = 32
    TYPE_IR = 33
    TYPE_THIRD_PARTY_START = 50
    TYPE_THIRD_PARTY_END = 98
    TYPE_ENERGYMETER = 99
    TYPE_IIC_UNKNOWN = 100
    TYPE_NXT_TEST = 101
    TYPE_NXT_IIC = 123
    TYPE_TERMINAL = 124
    TYPE_UNKNOWN = 125
    TYPE_NONE = 126
    TYPE_ERROR = 127


class SLOT(IntEnum, metaclass=MemberNames):
    """Program slots of the virtual machine; direct commands run in CMD_SLOT."""

    GUI_SLOT = 0
    USER_SLOT = 1
    CMD_SLOT = 2
    TERM_SLOT = 3
    DEBUG_SLOT = 4
    CURRENT_SLOT = -1

    GUI = GUI_SLOT
    USER = USER_SLOT
    CMD = CMD_SLOT
    TERM = TERM_SLOT
    DEBUG = DEBUG_SLOT
    CURRENT = CURRENT_SLOT


class BUTTONTYPE(IntEnum, metaclass=MemberNames):
    """Buttons of the brick."""

    NO_BUTTON = 0
    UP_BUTTON = 1
    ENTER_BUTTON = 2
    DOWN_BUTTON = 3
    RIGHT_BUTTON = 4
    LEFT_BUTTON = 5
    BACK_BUTTON = 6
    ANY_BUTTON = 7

    NO = NO_BUTTON
    UP = UP_BUTTON
    ENTER = ENTER_BUTTON
    DOWN = DOWN_BUTTON
    RIGHT = RIGHT_BUTTON
    LEFT = LEFT_BUTTON
    BACK = BACK_BUTTON
    ANY = ANY_BUTTON


class BROWSERTYPE(IntEnum, metaclass=MemberNames):
    """What the file browser on the display lists."""

    BROWSE_FOLDERS = 0
    BROWSE_FOLDS_FILES = 1
    BROWSE_CACHE = 2
    BROWSE_FILES = 3

    FOLDERS = BROWSE_FOLDERS
    FOLDS_FILES = BROWSE_FOLDS_FILES
    CACHE = BROWSE_CACHE
    FILES = BROWSE_FILES


class FONTTYPE(IntEnum, metaclass=MemberNames):
    """Fonts of the display."""

    NORMAL_FONT = 0
    SMALL_FONT = 1
    LARGE_FONT = 2
    TINY_FONT = 3

    NORMAL = NORMAL_FONT
    SMALL = SMALL_FONT
    LARGE = LARGE_FONT
    TINY = TINY_FONT


class ICONTYPE(IntEnum, metaclass=MemberNames):
    """Sets of icons; the set decides what an icon's number means."""

    NORMAL_ICON = 0
    SMALL_ICON = 1
    LARGE_ICON = 2
    MENU_ICON = 3
    ARROW_ICON = 4

    NORMAL = NORMAL_ICON
    SMALL = SMALL_ICON
    LARGE = LARGE_ICON
    MENU = MENU_ICON
    ARROW = ARROW_ICON


class S_ICON_NO(IntEnum, metaclass=MemberNames):
    """Icons of the set SMALL_ICON: battery, Bluetooth, WiFi and USB in the top line."""

    SICON_CHARGING = 0
    SICON_BATT_4 = 1
    SICON_BATT_3 = 2
    SICON_BATT_2 = 3
    SICON_BATT_1 = 4
    SICON_BATT_0 = 5
    SICON_WAIT1 = 6
    SICON_WAIT2 = 7
    SICON_BT_ON = 8
    SICON_BT_VISIBLE = 9
    SICON_BT_CONNECTED = 10
    SICON_BT_CONNVISIB = 11
    SICON_WIFI_3 = 12
    SICON_WIFI_2 = 13
    SICON_WIFI_1 = 14
    SICON_WIFI_CONNECTED = 15
    SICON_USB = 21

    CHARGING = SICON_CHARGING
    BATT_4 = SICON_BATT_4
    BATT_3 = SICON_BATT_3
    BATT_2 = SICON_BATT_2
    BATT_1 = SICON_BATT_1
    BATT_0 = SICON_BATT_0
    WAIT1 = SICON_WAIT1
    WAIT2 = SICON_WAIT2
    BT_ON = SICON_BT_ON
    BT_VISIBLE = SICON_BT_VISIBLE
    BT_CONNECTED = SICON_BT_CONNECTED
    BT_CONNVISIB = SICON_BT_CONNVISIB
    WIFI_3 = SICON_WIFI_3
    WIFI_2 = SICON_WIFI_2
    WIFI_1 = SICON_WIFI_1
    WIFI_CONNECTED = SICON_WIFI_CONNECTED
    USB = SICON_USB


class N_ICON_NO(IntEnum, metaclass=MemberNames):
    """Icons of the set NORMAL_ICON: files, folders and settings."""

    ICON_NONE = -1
    ICON_RUN = 0
    ICON_FOLDER = 1
    ICON_FOLDER2 = 2
    ICON_USB = 3
    ICON_SD = 4
    ICON_SOUND = 5
    ICON_IMAGE = 6
    ICON_SETTINGS = 7
    ICON_ONOFF = 8
    ICON_SEARCH = 9
    ICON_WIFI = 10
    ICON_CONNECTIONS = 11
    ICON_ADD_HIDDEN = 12
    ICON_TRASHBIN = 13
    ICON_VISIBILITY = 14
    ICON_KEY = 15
    ICON_CONNECT = 16
    ICON_DISCONNECT = 17
    ICON_UP = 18
    ICON_DOWN = 19
    ICON_WAIT1 = 20
    ICON_WAIT2 = 21
    ICON_BLUETOOTH = 22
    ICON_INFO = 23
    ICON_TEXT = 24
    ICON_QUESTIONMARK = 27
    ICON_INFO_FILE = 28
    ICON_DISC = 29
    ICON_CONNECTED = 30
    ICON_OBP = 31
    ICON_OBD = 32
    ICON_OPENFOLDER = 33
    ICON_BRICK1 = 34

    NONE = ICON_NONE
    RUN = ICON_RUN
    FOLDER = ICON_FOLDER
    FOLDER2 = ICON_FOLDER2
    USB = ICON_USB
    SD = ICON_SD
    SOUND = ICON_SOUND
    IMAGE = ICON_IMAGE
    SETTINGS = ICON_SETTINGS
    ONOFF = ICON_ONOFF
    SEARCH = ICON_SEARCH
    WIFI = ICON_WIFI
    CONNECTIONS = ICON_CONNECTIONS
    ADD_HIDDEN = ICON_ADD_HIDDEN
    TRASHBIN = ICON_TRASHBIN
    VISIBILITY = ICON_VISIBILITY
    KEY = ICON_KEY
    CONNECT = ICON_CONNECT
    DISCONNECT = ICON_DISCONNECT
    UP = ICON_UP
    DOWN = ICON_DOWN
    WAIT1 = ICON_WAIT1
    WAIT2 = ICON_WAIT2
    BLUETOOTH = ICON_BLUETOOTH
    INFO = ICON_INFO
    TEXT = ICON_TEXT
    QUESTIONMARK = ICON_QUESTIONMARK
    INFO_FILE = ICON_INFO_FILE
    DISC = ICON_DISC
    CONNECTED = ICON_CONNECTED
    OBP = ICON_OBP
    OBD = ICON_OBD
    OPENFOLDER = ICON_OPENFOLDER
    BRICK1 = ICON_BRICK1


class L_ICON_NO(IntEnum, metaclass=MemberNames):
    """Icons of the set LARGE_ICON: answers, warnings and file operations."""

    YES_NOTSEL = 0
    YES_SEL = 1
    NO_NOTSEL = 2
    NO_SEL = 3
    OFF = 4
    WAIT_VERT = 5
    WAIT_HORZ = 6
    TO_MANUAL = 7
    WARNSIGN = 8
    WARN_BATT = 9
    WARN_POWER = 10
    WARN_TEMP = 11
    NO_USBSTICK = 12
    TO_EXECUTE = 13
    TO_BRICK = 14
    TO_SDCARD = 15
    TO_USBSTICK = 16
    TO_BLUETOOTH = 17
    TO_WIFI = 18
    TO_TRASH = 19
    TO_COPY = 20
    TO_FILE = 21
    CHAR_ERROR = 22
    COPY_ERROR = 23
    PROGRAM_ERROR = 24
    WARN_MEMORY = 27


class M_ICON_NO(IntEnum, metaclass=MemberNames):
    """Icons of the set MENU_ICON: kinds of Bluetooth peers, locks and check boxes."""

    ICON_STAR = 0
    ICON_LOCKSTAR = 1
    ICON_LOCK = 2
    ICON_PC = 3
    ICON_PHONE = 4
    ICON_BRICK = 5
    ICON_UNKNOWN = 6
    ICON_FROM_FOLDER = 7
    ICON_CHECKBOX = 8
    ICON_CHECKED = 9
    ICON_XED = 10

    STAR = ICON_STAR
    LOCKSTAR = ICON_LOCKSTAR
    LOCK = ICON_LOCK
    PC = ICON_PC
    PHONE = ICON_PHONE
    BRICK = ICON_BRICK
    UNKNOWN = ICON_UNKNOWN
    FROM_FOLDER = ICON_FROM_FOLDER
    CHECKBOX = ICON_CHECKBOX
    CHECKED = ICON_CHECKED
    XED = ICON_XED


class A_ICON_NO(IntEnum, metaclass=MemberNames):
    """Icons of the set ARROW_ICON: small arrows."""

    ICON_LEFT = 1
    ICON_RIGHT = 2

    LEFT = ICON_LEFT
    RIGHT = ICON_RIGHT


class BTTYPE(IntEnum, metaclass=MemberNames):
    """Kinds of Bluetooth peers, numbered like their icons in the set MENU_ICON."""

    BTTYPE_PC = 3
    BTTYPE_PHONE = 4
    BTTYPE_BRICK = 5
    BTTYPE_UNKNOWN = 6

    PC = BTTYPE_PC
    PHONE = BTTYPE_PHONE
    BRICK = BTTYPE_BRICK
    UNKNOWN = BTTYPE_UNKNOWN


class LEDPATTERN(IntEnum, metaclass=MemberNames):
    """Colours and rhythms of the light behind the buttons."""

    LED_BLACK = 0
    LED_GREEN = 1
    LED_RED = 2
    LED_ORANGE = 3
    LED_GREEN_FLASH = 4
    LED_RED_FLASH = 5
    LED_ORANGE_FLASH = 6
    LED_GREEN_PULSE = 7
    LED_RED_PULSE = 8
    LED_ORANGE_PULSE = 9

    BLACK = LED_BLACK
    GREEN = LED_GREEN
    RED = LED_RED
    ORANGE = LED_ORANGE
    GREEN_FLASH = LED_GREEN_FLASH
    RED_FLASH = LED_RED_FLASH
    ORANGE_FLASH = LED_ORANGE_FLASH
    GREEN_PULSE = LED_GREEN_PULSE
    RED_PULSE = LED_RED_PULSE
    ORANGE_PULSE = LED_ORANGE_PULSE


class LEDTYPE(IntEnum, metaclass=MemberNames):
    """Single lights behind the buttons: right or left, red or green."""

    LED_ALL = 0
    LED_RR = 1
    LED_RG = 2
    LED_LR = 3
    LED_LG = 4

    ALL = LED_ALL
    RR = LED_RR
    RG = LED_RG
    LR = LED_LR
    LG = LED_LG


class FILETYPE(IntEnum, metaclass=MemberNames):
    """Kinds of files in the browser; it ORs TYPE_SDCARD or TYPE_USBSTICK to the kind found there."""

    FILETYPE_UNKNOWN = 0
    TYPE_FOLDER = 1
    TYPE_SOUND = 2
    TYPE_BYTECODE = 3
    TYPE_GRAPHICS = 4
    TYPE_DATALOG = 5
    TYPE_PROGRAM = 6
    TYPE_TEXT = 7
    TYPE_SDCARD = 16
    TYPE_USBSTICK = 32
    TYPE_RESTART_BROWSER = -1
    TYPE_REFRESH_BROWSER = -2


class RESULT(IntEnum, metaclass=MemberNames):
    """Result of an operation, or that it is still running."""

    OK = 0
    BUSY = 1
    FAIL = 2
    STOP = 4
    START = 8


class DATA_FORMAT(IntEnum, metaclass=MemberNames):
    """Formats of values, for sensors and mailboxes; FORMAT_TYPES has their types."""

    DATA_8 = 0
    DATA_16 = 1
    DATA_32 = 2
    DATA_F = 3
    DATA_S = 4
    DATA_A = 5
    DATA_V = 7
    DATA_PCT = 16
    DATA_RAW = 18
    DATA_SI = 19


class DEL(IntEnum, metaclass=MemberNames):
    """Separators between two values in a text file."""

    DEL_NONE = 0
    DEL_TAB = 1
    DEL_SPACE = 2
    DEL_RETURN = 3
    DEL_COLON = 4
    DEL_COMMA = 5
    DEL_LINEFEED = 6
    DEL_CRLF = 7

    NONE = DEL_NONE
    TAB = DEL_TAB
    SPACE = DEL_SPACE
    RETURN = DEL_RETURN
    COLON = DEL_COLON
    COMMA = DEL_COMMA
    LINEFEED = DEL_LINEFEED
    CRLF = DEL_CRLF


class HWTYPE(IntEnum, metaclass=MemberNames):
    """Carriers of the protocol."""

    HW_USB = 1
    HW_BT = 2
    HW_WIFI = 3

    USB = HW_USB
    BT = HW_BT
    WIFI = HW_WIFI


class ENCRYPT(IntEnum, metaclass=MemberNames):
    """Encryption of a WiFi network."""

    ENCRYPT_NONE = 0
    ENCRYPT_WPA2 = 1

    NONE = ENCRYPT_NONE
    WPA2 = ENCRYPT_WPA2


class LMS_ENCRYPT(IntEnum, metaclass=MemberNames):
    """Encryption of a WiFi network, under the names of the extended firmware."""

    LMS_ENCRYPT_NONE = 0
    LMS_ENCRYPT_WPA2 = 1

    NONE = LMS_ENCRYPT_NONE
    WPA2 = LMS_ENCRYPT_WPA2


class COLOR(IntEnum, metaclass=MemberNames):
    """Colour channels of the NXT colour sensor; BLANK is the reading without light."""

    RED = 0
    GREEN = 1
    BLUE = 2
    BLANK = 3


class NXTCOLOR(IntEnum, metaclass=MemberNames):
    """Colours that a colour sensor recognises."""

    BLACKCOLOR = 1
    BLUECOLOR = 2
    GREENCOLOR = 3
    YELLOWCOLOR = 4
    REDCOLOR = 5
    WHITECOLOR = 6


class WARNING(IntFlag, metaclass=MemberNames):
    """Warnings of the brick, one bit each; WARNINGS masks those shown to the user."""

    WARNING_TEMP = 1
    WARNING_CURRENT = 2
    WARNING_VOLTAGE = 4
    WARNING_MEMORY = 8
    WARNING_DSPSTAT = 16
    WARNING_RAM = 32
    WARNING_BATTLOW = 64
    WARNING_BUSY = 128

    TEMP = WARNING_TEMP
    CURRENT = WARNING_CURRENT
    VOLTAGE = WARNING_VOLTAGE
    MEMORY = WARNING_MEMORY
    DSPSTAT = WARNING_DSPSTAT
    RAM = WARNING_RAM
    BATTLOW = WARNING_BATTLOW
    BUSY = WARNING_BUSY


class OBJSTAT(IntEnum, metaclass=MemberNames):
    """State of a program or object; one at a time, though each number is a single bit."""

    RUNNING = 16
    WAITING = 32
    STOPPED = 64
    HALTED = 128


class DEVCMD(IntEnum, metaclass=MemberNames):
    """Commands to a UART sensor; DEVCMD_FIRE is another name of DEVCMD_RESET (compat lacks it)."""

    DEVCMD_RESET = 17
    DEVCMD_FIRE = 17
    DEVCMD_CHANNEL = 18

    RESET = DEVCMD_RESET
    FIRE = DEVCMD_FIRE
    CHANNEL = DEVCMD_CHANNEL


class CONN(IntEnum, metaclass=MemberNames):
    """Kinds of connection that a port detects."""

    CONN_UNKNOWN = 111
    CONN_DAISYCHAIN = 117
    CONN_NXT_COLOR = 118
    CONN_NXT_DUMB = 119
    CONN_NXT_IIC = 120
    CONN_INPUT_DUMB = 121
    CONN_INPUT_UART = 122
    CONN_OUTPUT_DUMB = 123
    CONN_OUTPUT_INTELLIGENT = 124
    CONN_OUTPUT_TACHO = 125
    CONN_NONE = 126
    CONN_ERROR = 127

    UNKNOWN = CONN_UNKNOWN
    DAISYCHAIN = CONN_DAISYCHAIN
    NXT_COLOR = CONN_NXT_COLOR
    NXT_DUMB = CONN_NXT_DUMB
    NXT_IIC = CONN_NXT_IIC
    INPUT_DUMB = CONN_INPUT_DUMB
    INPUT_UART = CONN_INPUT_UART
    OUTPUT_DUMB = CONN_OUTPUT_DUMB
    OUTPUT_INTELLIGENT = CONN_OUTPUT_INTELLIGENT
    OUTPUT_TACHO = CONN_OUTPUT_TACHO
    NONE = CONN_NONE
    ERROR = CONN_ERROR


BUTTON = BUTTONTYPE
BROWSE = BROWSERTYPE
FONT = FONTTYPE
ICON = ICONTYPE
SICON = S_ICON_NO
LED = LEDPATTERN
HW = HWTYPE
