"""The flat names of EV3 programs: `opSound`, `TONE`, `LED_RED`, `PORT_A`, `LCX(440)`.

Courses and the package ev3_dc write byte code by hand, constant by constant. To run their programs,
every name of the tables is available in that spelling:

    opcodes               one byte; `opUI_Draw`, in any case after the `op`
    CMDs                  the constant that encodes the number (LC0, for TEXTBOX LC1)
    enumerations          the same, also for the name of the number after the last (BUTTONTYPES)
    system commands       one byte
    system statuses       one byte, as SYSTEM_ and the status
    ports                 PORT_1 and PORT_A_SENSOR encoded; PORT_A is a bit, an int, so that ports can be added
    NXTCOLOR, NXT_, EV3_  ints, because programs compare them with sensor values
    CONSTANTS             as in the tables

If a name is in two tables, the first in this order has it; the commands of the bootloader come last:
GET_VERSION is UI_READ's, BEGIN_DOWNLOAD is the firmware's 0x92. ev3_dc does the same.
"""

# ruff: noqa: N802 - the functions are named like LEGO's macros

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from ev3proto.errors import BuildError, near_misses
from ev3proto.messages import GV, LV
from ev3proto.schema.argument import (
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
from ev3proto.tables.encoding import CONSTANT, ENCODINGS, GLOBAL, LOCAL
from ev3proto.tables.input import MOTOR_PORTS, SENSOR_PORTS
from ev3proto.tables.ports import MotorPort, MotorPorts
from ev3proto.tables.system import SYSTEM, SystemStatus

Constant = bytes | int | str

# ev3_dc's spelling of opcode words that are not simply capitalised.
_SPELLINGS = {"UI": "UI", "READSI": "ReadSI", "READEXT": "ReadExt"}

_OPCODE_ALIASES = {
    "OBJECT_RETURN": "RETURN",
    "OBJECT_CALL": "CALL",
    "CP_NE8": "CP_NEQ8",
    "CP_NE16": "CP_NEQ16",
    "CP_NE32": "CP_NEQ32",
    "CP_NEF": "CP_NEQF",
}

# ev3_dc spells OPEN_LOG as opEN_LOG, since it takes all names that begin with OP for opcodes.
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

# Values of the EV3's own colour sensor besides NXTCOLOR; the firmware does not name these two.
_SENSOR_COLORS = {"NONECOLOR": 0, "BROWNCOLOR": 7}

# Not part of the protocol: ev3_dc's names for carriers and for when to wait for replies.
_OPTIONS = {
    "WIFI": "WiFi",
    "BLUETOOTH": "Bluetooth",
    "USB": "USB",
    "STD": "STD",
    "ASYNC": "ASYNC",
    "SYNC": "SYNC",
}


def constant(name: str) -> Constant:
    """Returns the value of a name, opcodes in any case after the `op`. Raises KeyError, which suggests the nearest."""
    known = _constants()
    if name in known:
        return known[name]
    if name.startswith("op") and name[2:].upper() in _opcodes():
        return _opcodes()[name[2:].upper()]
    raise KeyError(f"unknown constant {name}{near_misses(name, known)}")


def constant_names() -> list[str]:
    """Returns every name that `constant` knows, sorted; opcodes once each, in ev3_dc's spelling."""
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
    for status in SystemStatus:
        yield f"SYSTEM_{status.name}", bytes((status,))
    yield from _ports()
    yield from ((alias, enumerations.TYPE.members[name]) for alias, name in _DEVICE_ALIASES.items())
    yield from _SENSOR_COLORS.items()
    yield from CONSTANTS.items()
    yield from _OPTIONS.items()
    # Some of the bootloader have names of the firmware's.
    yield from ((entry.name, bytes((entry.number,))) for entry in sorted(SYSTEM, key=lambda entry: entry.bootloader))


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
    for port, number in zip(MotorPort, MOTOR_PORTS, strict=True):
        yield f"PORT_{port.name}_SENSOR", encode_integer(number)
    yield from ((f"PORT_{port.name}", port.value) for port in MotorPorts)
    yield "PORTS_ALL", MotorPorts.ALL.value


def LCX(value: int) -> bytes:
    """Returns the shortest constant for a whole number: LC0 for -32 to 31, LC1 to +-127, LC2 to +-32767, LC4 beyond.

    Args:
        value: A whole number, -2147483648 to 2147483647; the lowest one is the 32-bit pattern for "not a number".

    Raises:
        BuildError: The value is not such a whole number (True and False are not).
    """
    return encode_integer(_whole(value, "LCX"))


def LC0(value: int) -> bytes:
    """Returns a constant of one byte.

    Args:
        value: A whole number, -32 to 31.

    Raises:
        BuildError: The value is anything else.
    """
    return encode_as("LC0", _whole(value, "LC0"))


def LC1(value: int) -> bytes:
    """Returns a constant of two bytes.

    Args:
        value: A whole number, -128 ("not a number") to 127.

    Raises:
        BuildError: The value is anything else.
    """
    return encode_as("LC1", _whole(value, "LC1"))


def LC2(value: int) -> bytes:
    """Returns a constant of three bytes.

    Args:
        value: A whole number, -32768 ("not a number") to 32767.

    Raises:
        BuildError: The value is anything else.
    """
    return encode_as("LC2", _whole(value, "LC2"))


def LC4(value: int) -> bytes:
    """Returns a constant of five bytes.

    Args:
        value: A whole number, -2147483648 ("not a number") to 2147483647.

    Raises:
        BuildError: The value is anything else.
    """
    return encode_as("LC4", _whole(value, "LC4"))


def LCF(value: float) -> bytes:
    """Returns a float constant: an LC4 whose four bytes are an IEEE single.

    Args:
        value: A number in the range of a single, to which it is rounded; NaN becomes the firmware's "not a number".

    Raises:
        BuildError: The value is beyond +-3.4028235e38, or not a number.
    """
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise BuildError(f"LCF takes a number, not {value!r}")
    return encode_float(value, "LCF")


def LCS(value: str) -> bytes:
    r"""Returns a string with its zero.

    Args:
        value: Text of ISO-8859-1, the brick's character set, without "\0".

    Raises:
        BuildError: The value has other characters or a zero, or is not a str.
    """
    if not isinstance(value, str):
        raise BuildError(f"LCS takes a str, not {value!r}")
    return encode_string(value, "LCS")


def LVX(value: int) -> bytes:
    """Returns the shortest form of a local variable: LV0 for 0 to 31, LV1 to 255, LV2 to 65535, LV4 beyond.

    Args:
        value: Bytes from the start of local memory, 0 to 4294967295; of direct commands at most 62.

    Raises:
        BuildError: The value is anything else.
    """
    return encode_variable(LV(_whole(value, "LVX")), "LVX")


def GVX(value: int) -> bytes:
    """Returns the shortest form of a global variable: GV0 for 0 to 31, GV1 to 255, GV2 to 65535, GV4 beyond.

    Args:
        value: Bytes from the start of global memory, 0 to 4294967295; of direct commands at most 1018.

    Raises:
        BuildError: The value is anything else.
    """
    return encode_variable(GV(_whole(value, "GVX")), "GVX")


def port_motor_input(port_output: int) -> bytes:
    """Returns the port of a motor as INPUT operations take it: `PORT_A_SENSOR` for `PORT_A`.

    Args:
        port_output: PORT_A, PORT_B, PORT_C or PORT_D.

    Raises:
        BuildError: The value is anything else.
    """
    bits = dict(zip(map(int, MotorPorts), MOTOR_PORTS, strict=True))
    number = _whole(port_output, "port_motor_input")
    if number not in bits:
        raise BuildError(f"port_motor_input takes one of the ports {', '.join(map(str, bits))}, not {number}")
    return encode_integer(bits[number])


def LAB1(value: int) -> bytes:
    """Returns a label or a short jump of two bytes.

    Args:
        value: A whole number, -128 to 127.

    Raises:
        BuildError: The value is anything else.
    """
    return encode_label(_whole(value, "LAB1"), "LAB1")


def HND(encoded: bytes) -> bytes:
    """Returns an argument marked as a handle to a memory object.

    Args:
        encoded: One constant or variable in a long form, such as LC1(3) or GVX(40).

    Raises:
        BuildError: The argument is anything else: a short form (LC0, LV0, GV0) has no bit for the mark.
    """
    return with_bits(_one_number(encoded, "HND"), handle=True)


def ADR(encoded: bytes) -> bytes:
    """Returns an argument marked as an absolute address.

    Args:
        encoded: One constant or variable in a long form, such as LC4(0x8000) or GVX(40).

    Raises:
        BuildError: The argument is anything else: a short form (LC0, LV0, GV0) has no bit for the mark.
    """
    return with_bits(_one_number(encoded, "ADR"), address=True)


def _whole(value: int, name: str) -> int:
    # In Python a bool is an int; here it would be an unintended result of a comparison.
    if isinstance(value, bool) or not isinstance(value, int):
        raise BuildError(f"{name} takes a whole number, not {value!r}")
    return value


def _one_number(encoded: bytes, name: str) -> bytes:
    form = ENCODINGS[encoded[0]] if isinstance(encoded, bytes) and encoded else None
    if form is not None and form.kind in (CONSTANT, LOCAL, GLOBAL) and len(encoded) == 1 + (form.width or 0):
        return encoded
    raise BuildError(f"{name} takes the bytes of one encoded constant or variable, not {encoded!r}")
