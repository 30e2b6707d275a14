"""What the functions of `ev3proto.ops` take for their parameters, for type checkers and editors.

A number may be given as such, by the name of an enumeration's member, or be in a variable. Bytes are one
encoded argument, such as `LC2(5)`. None leaves the place of an output to `ev3proto.command`.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, TypeAlias

from ev3proto.enums import (
    BROWSERTYPE,
    BUTTONTYPE,
    CONN,
    DATA_FORMAT,
    DEL,
    ENCRYPT,
    FILETYPE,
    FONTTYPE,
    HWTYPE,
    ICONTYPE,
    L_ICON_NO,
    LEDPATTERN,
    N_ICON_NO,
    RESULT,
    SLOT,
    TYPE,
)
from ev3proto.messages import Argument, Variable
from ev3proto.semantics.drafts.placeholders import Label, Placeholder

AnyVariable: TypeAlias = "Variable | Placeholder | Argument | bytes"
Number: TypeAlias = "int | AnyVariable"
Real: TypeAlias = "float | AnyVariable"
Text: TypeAlias = "str | AnyVariable"
Elements: TypeAlias = "int | str | AnyVariable"
NamedNumber: TypeAlias = "int | str | AnyVariable"
Untyped: TypeAlias = "float | str | AnyVariable"
Jump: TypeAlias = "int | Label | AnyVariable"
Output: TypeAlias = "AnyVariable | None"
Outputs: TypeAlias = "Sequence[Output] | Variable | Placeholder | int | None"

_SLOT_NAME: TypeAlias = Literal[
    "GUI_SLOT",
    "USER_SLOT",
    "CMD_SLOT",
    "TERM_SLOT",
    "DEBUG_SLOT",
    "CURRENT_SLOT",
]
AnySLOT: TypeAlias = "SLOT | _SLOT_NAME | Number"

_DEL_NAME: TypeAlias = Literal[
    "DEL_NONE",
    "DEL_TAB",
    "DEL_SPACE",
    "DEL_RETURN",
    "DEL_COLON",
    "DEL_COMMA",
    "DEL_LINEFEED",
    "DEL_CRLF",
]
AnyDEL: TypeAlias = "DEL | _DEL_NAME | Number"

_LEDPATTERN_NAME: TypeAlias = Literal[
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
AnyLEDPATTERN: TypeAlias = "LEDPATTERN | _LEDPATTERN_NAME | Number"

_BUTTONTYPE_NAME: TypeAlias = Literal[
    "NO_BUTTON",
    "UP_BUTTON",
    "ENTER_BUTTON",
    "DOWN_BUTTON",
    "RIGHT_BUTTON",
    "LEFT_BUTTON",
    "BACK_BUTTON",
    "ANY_BUTTON",
]
AnyBUTTONTYPE: TypeAlias = "BUTTONTYPE | _BUTTONTYPE_NAME | Number"

_ICONTYPE_NAME: TypeAlias = Literal[
    "NORMAL_ICON",
    "SMALL_ICON",
    "LARGE_ICON",
    "MENU_ICON",
    "ARROW_ICON",
]
AnyICONTYPE: TypeAlias = "ICONTYPE | _ICONTYPE_NAME | Number"

_L_ICON_NO_NAME: TypeAlias = Literal[
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
AnyL_ICON_NO: TypeAlias = "L_ICON_NO | _L_ICON_NO_NAME | Number"

_N_ICON_NO_NAME: TypeAlias = Literal[
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
AnyN_ICON_NO: TypeAlias = "N_ICON_NO | _N_ICON_NO_NAME | Number"

_BROWSERTYPE_NAME: TypeAlias = Literal[
    "BROWSE_FOLDERS",
    "BROWSE_FOLDS_FILES",
    "BROWSE_CACHE",
    "BROWSE_FILES",
]
AnyBROWSERTYPE: TypeAlias = "BROWSERTYPE | _BROWSERTYPE_NAME | Number"

_FONTTYPE_NAME: TypeAlias = Literal[
    "NORMAL_FONT",
    "SMALL_FONT",
    "LARGE_FONT",
    "TINY_FONT",
]
AnyFONTTYPE: TypeAlias = "FONTTYPE | _FONTTYPE_NAME | Number"

_TYPE_NAME: TypeAlias = Literal[
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
AnyTYPE: TypeAlias = "TYPE | _TYPE_NAME | Number"

_DATA_FORMAT_NAME: TypeAlias = Literal[
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
AnyDATA_FORMAT: TypeAlias = "DATA_FORMAT | _DATA_FORMAT_NAME | Number"

_RESULT_NAME: TypeAlias = Literal[
    "OK",
    "BUSY",
    "FAIL",
    "STOP",
    "START",
]
AnyRESULT: TypeAlias = "RESULT | _RESULT_NAME | Number"

_HWTYPE_NAME: TypeAlias = Literal[
    "HW_USB",
    "HW_BT",
    "HW_WIFI",
]
AnyHWTYPE: TypeAlias = "HWTYPE | _HWTYPE_NAME | Number"

_ENCRYPT_NAME: TypeAlias = Literal[
    "ENCRYPT_NONE",
    "ENCRYPT_WPA2",
]
AnyENCRYPT: TypeAlias = "ENCRYPT | _ENCRYPT_NAME | Number"

_FILETYPE_NAME: TypeAlias = Literal[
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
AnyFILETYPE: TypeAlias = "FILETYPE | _FILETYPE_NAME | Number"

_CONN_NAME: TypeAlias = Literal[
    "CONN_UNKNOWN",
    "CONN_DAISYCHAIN",
    "CONN_NXT_COLOR",
    "CONN_NXT_DUMB",
    "CONN_NXT_IIC",
    "CONN_INPUT_DUMB",
    "CONN_INPUT_UART",
    "CONN_OUTPUT_DUMB",
    "CONN_OUTPUT_INTELLIGENT",
    "CONN_OUTPUT_TACHO",
    "CONN_NONE",
    "CONN_ERROR",
]
AnyCONN: TypeAlias = "CONN | _CONN_NAME | Number"
