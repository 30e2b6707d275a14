"""The flat names that programs for the EV3 are written with: `opSound`, `TONE`, `LED_RED`, `PORT_A`, `LCX(440)`.

Courses and the package ev3_dc join byte code by hand, one constant after the other. So that their programs run here,
every name of the tables has its value under that spelling:

    opcodes               one byte; `opUI_Draw`, in any case after the `op`
    CMDs                  the constant that encodes the number (LC0, for TEXTBOX LC1)
    enumerations          the same, also for the name of the number after the last (BUTTONTYPES)
    system commands       one byte
    system statuses       one byte, as SYSTEM_ and the status
    ports                 PORT_1 and PORT_A_SENSOR encoded; PORT_A is a bit, an int, so that ports can be added up
    NXTCOLOR, NXT_, EV3_  ints, because programs compare them with what a sensor said
    CONSTANTS             as they stand in the tables

Where two tables have a name, the first in this order keeps it, and the commands of the bootloader come last of all:
GET_VERSION is UI_READ's, BEGIN_DOWNLOAD is the firmware's 0x92. That is what ev3_dc means by them too.
"""

# ruff: noqa: N802 - the functions have the names of LEGO's macros

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from ev3proto.errors import BuildError, near_misses
from ev3proto.messages import GV, LV
from ev3proto.schema.argument import (
    ENCODINGS,
    encode_as,
    encode_float,
    encode_integer,
    encode_label,
    encode_string,
    encode_variable,
    with_bits,
)
from ev3proto.tables import OPCODES, enumerations
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.encoding import CONSTANT, GLOBAL, LOCAL
from ev3proto.tables.input import MOTOR_PORTS
from ev3proto.tables.input import PORTS as SENSOR_PORTS
from ev3proto.tables.output import PORTS as OUTPUT_PORTS
from ev3proto.tables.system import SYSTEM, SystemStatus

Constant = bytes | int | str

# How ev3_dc spells the words of opcodes that it does not simply capitalise.
_SPELLINGS = {"UI": "UI", "READSI": "ReadSI", "READEXT": "ReadExt"}

_OPCODE_ALIASES = {
    "OBJECT_RETURN": "RETURN",
    "OBJECT_CALL": "CALL",
    "CP_NE8": "CP_NEQ8",
    "CP_NE16": "CP_NEQ16",
    "CP_NE32": "CP_NEQ32",
    "CP_NEF": "CP_NEQF",
}

# opEN_LOG is what became of OPEN_LOG when ev3_dc spelled all names that begin with OP as opcodes.
_ALIASES = {
    "LED_OFF": "LED_BLACK",
    "SYSTEM_REPLY_OK": "SYSTEM_SUCCESS",
    "opEN_LOG": "OPEN_LOG",
}

_DEVICE_ALIASES = {
    "NXT_TOUCH": "TYPE_NXT_TOUCH",
    "NXT_LIGHT": "TYPE_NXT_LIGHT",
    "NXT_SOUND": "TYPE_NXT_SOUND",
    "NXT_COLOR": "TYPE_NXT_COLOR",
    "NXT_ULTRASONIC": "TYPE_NXT_ULTRASONIC",
    "NXT_TEMPERATURE": "TYPE_NXT_TEMPERATURE",
    "EV3_LARGE_MOTOR": "TYPE_TACHO",
    "EV3_MEDIUM_MOTOR": "TYPE_MINITACHO",
    "EV3_TOUCH": "TYPE_TOUCH",
    "EV3_COLOR": "TYPE_COLOR",
    "EV3_ULTRASONIC": "TYPE_ULTRASONIC",
    "EV3_GYRO": "TYPE_GYRO",
    "EV3_IR": "TYPE_IR",
}

# What the EV3's own colour sensor says besides NXTCOLOR; the firmware has no names for these two.
_SENSOR_COLORS = {"NONECOLOR": 0, "BROWNCOLOR": 7}

# No part of the protocol: how a program tells ev3_dc which carrier to use and when to wait for replies.
_OPTIONS = {
    "WIFI": "WiFi",
    "BLUETOOTH": "Bluetooth",
    "USB": "USB",
    "STD": "STD",
    "ASYNC": "ASYNC",
    "SYNC": "SYNC",
}


def constant(name: str) -> Constant:
    """The value of a name.

    Args:
        name: As `constant_names` has it; opcodes in any case after the `op` (`opUI_Draw`, `opUI_DRAW`).

    Returns:
        Encoded bytes, an int or a str; the text at the head of this module says which.

    Raises:
        KeyError: There is no such name. The error suggests the nearest ones.
    """
    known = _constants()
    if name in known:
        return known[name]
    if name.startswith("op") and name[2:].upper() in _opcodes():
        return _opcodes()[name[2:].upper()]
    raise KeyError(f"there is no constant {name}{near_misses(name, known)}")


def constant_names() -> list[str]:
    """Every name that `constant` knows, sorted; opcodes once each, as ev3_dc spells them."""
    return sorted(_constants())


@cache
def _constants() -> dict[str, Constant]:
    found: dict[str, Constant] = {}
    for name, value in _values():
        found.setdefault(name, value)
    return found | {alias: found[name] for alias, name in _ALIASES.items()}


@cache
def _opcodes() -> dict[str, bytes]:
    found = {opcode.name: bytes((opcode.number,)) for opcode in OPCODES}
    return found | {alias: found[name] for alias, name in _OPCODE_ALIASES.items()}


def _values() -> Iterator[tuple[str, Constant]]:
    for name, value in _opcodes().items():
        yield f"op{'_'.join(_spelled(word) for word in name.split('_'))}", value
    for opcode in OPCODES:
        for command in opcode.commands:
            yield command.name, encode_integer(command.number)
    yield from _members()
    for entry in SYSTEM:
        if not entry.bootloader:
            yield entry.name, bytes((entry.number,))
    for status in SystemStatus:
        yield f"SYSTEM_{status.name}", bytes((status,))
    yield from _ports()
    yield from ((alias, enumerations.TYPE.members[name]) for alias, name in _DEVICE_ALIASES.items())
    yield from _SENSOR_COLORS.items()
    yield from CONSTANTS.items()
    yield from _OPTIONS.items()
    for entry in SYSTEM:
        if entry.bootloader:
            yield entry.name, bytes((entry.number,))


def _spelled(word: str) -> str:
    if word in _SPELLINGS:
        return _SPELLINGS[word]
    # A final F is the type of the operands: AddF, Jr_LtF, Move8_F.
    return word[:-1].capitalize() + "F" if word.endswith("F") else word.capitalize()


def _members() -> Iterator[tuple[str, Constant]]:
    for name, number in enumerations.NUMBERS.items():
        yield name, number if name in enumerations.NXTCOLOR.members else encode_integer(number)


def _ports() -> Iterator[tuple[str, Constant]]:
    for number in SENSOR_PORTS:
        yield f"PORT_{number + 1}", encode_integer(number)
    for letter, number in zip(OUTPUT_PORTS.values(), MOTOR_PORTS, strict=True):
        yield f"PORT_{letter}_SENSOR", encode_integer(number)
    bits = {letter: 1 << number for number, letter in OUTPUT_PORTS.items()}
    yield from ((f"PORT_{letter}", bit) for letter, bit in bits.items())
    yield "PORTS_ALL", sum(bits.values())


def LCX(value: int) -> bytes:
    """The shortest constant for a whole number: LC0 for -32 to 31, LC1 to +-127, LC2 to +-32767, LC4 beyond.

    Args:
        value: A whole number, -2147483648 to 2147483647; the lowest one is the 32-bit pattern for "not a number".

    Raises:
        BuildError: It is another number, or no whole number (True and False are none).
    """
    return encode_integer(_whole(value, "LCX"))


def LC0(value: int) -> bytes:
    """A constant in one byte.

    Args:
        value: A whole number, -32 to 31.

    Raises:
        BuildError: It is anything else.
    """
    return encode_as("LC0", _whole(value, "LC0"))


def LC1(value: int) -> bytes:
    """A constant in two bytes.

    Args:
        value: A whole number, -128 ("not a number") to 127.

    Raises:
        BuildError: It is anything else.
    """
    return encode_as("LC1", _whole(value, "LC1"))


def LC2(value: int) -> bytes:
    """A constant in three bytes.

    Args:
        value: A whole number, -32768 ("not a number") to 32767.

    Raises:
        BuildError: It is anything else.
    """
    return encode_as("LC2", _whole(value, "LC2"))


def LC4(value: int) -> bytes:
    """A constant in five bytes.

    Args:
        value: A whole number, -2147483648 ("not a number") to 2147483647.

    Raises:
        BuildError: It is anything else.
    """
    return encode_as("LC4", _whole(value, "LC4"))


def LCF(value: float) -> bytes:
    """A float constant: an LC4 whose four bytes are an IEEE single.

    Args:
        value: A number that a single holds, rounded to the nearest one; NaN becomes the firmware's "not a number".

    Raises:
        BuildError: It is beyond +-3.4028235e38, or no number.
    """
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise BuildError(f"LCF takes a number, not {value!r}")
    return encode_float(value, "LCF")


def LCS(value: str) -> bytes:
    r"""A string with its zero.

    Args:
        value: Text of ISO-8859-1, the brick's character set, without "\0".

    Raises:
        BuildError: It has other characters or a zero, or is no str.
    """
    if not isinstance(value, str):
        raise BuildError(f"LCS takes a str, not {value!r}")
    return encode_string(value, "LCS")


def LVX(value: int) -> bytes:
    """The shortest form of a local variable: LV0 for 0 to 31, LV1 to 255, LV2 to 65535, LV4 beyond.

    Args:
        value: Bytes from the start of local memory, 0 to 4294967295; of direct commands at most 62.

    Raises:
        BuildError: It is anything else.
    """
    return encode_variable(LV(_whole(value, "LVX")), "LVX")


def GVX(value: int) -> bytes:
    """The shortest form of a global variable: GV0 for 0 to 31, GV1 to 255, GV2 to 65535, GV4 beyond.

    Args:
        value: Bytes from the start of global memory, 0 to 4294967295; of direct commands at most 1018.

    Raises:
        BuildError: It is anything else.
    """
    return encode_variable(GV(_whole(value, "GVX")), "GVX")


def LAB1(value: int) -> bytes:
    """A label or a short jump in two bytes.

    Args:
        value: A whole number, -128 to 127.

    Raises:
        BuildError: It is anything else.
    """
    return encode_label(_whole(value, "LAB1"), "LAB1")


def HND(encoded: bytes) -> bytes:
    """An argument marked as a handle to a memory object.

    Args:
        encoded: One constant or variable in a long form, such as LC1(3) or GVX(40).

    Raises:
        BuildError: It is anything else: a short form (LC0, LV0, GV0) has no bit for the mark.
    """
    return with_bits(_one_number(encoded, "HND"), handle=True)


def ADR(encoded: bytes) -> bytes:
    """An argument marked as an absolute address.

    Args:
        encoded: One constant or variable in a long form, such as LC4(0x8000) or GVX(40).

    Raises:
        BuildError: It is anything else: a short form (LC0, LV0, GV0) has no bit for the mark.
    """
    return with_bits(_one_number(encoded, "ADR"), address=True)


def _whole(value: int, name: str) -> int:
    # A bool is an int to Python; here it would be the result of a comparison that somebody meant to act on.
    if isinstance(value, bool) or not isinstance(value, int):
        raise BuildError(f"{name} takes a whole number, not {value!r}")
    return value


def _one_number(encoded: bytes, name: str) -> bytes:
    form = ENCODINGS[encoded[0]] if isinstance(encoded, bytes) and encoded else None
    if form is not None and form.kind in (CONSTANT, LOCAL, GLOBAL) and len(encoded) == 1 + (form.width or 0):
        return encoded
    raise BuildError(f"{name} takes the bytes of one encoded constant or variable, not {encoded!r}")
