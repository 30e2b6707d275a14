"""The flat names against ev3_dc, from which programs bring them: constants and encoding functions."""

from __future__ import annotations

import inspect
import math
import struct
from collections.abc import Callable
from typing import Any

import ev3_dc
import ev3_dc.constants
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.cases import each

import ev3proto
from ev3proto.errors import BuildError
from ev3proto.schema.names import ADR, GVX, HND, LAB1, LC0, LC1, LC2, LC4, LCF, LCS, LCX, LVX, constant, constant_names
from ev3proto.tables import OPCODES, enumerations
from ev3proto.tables.declaration import Enumeration
from ev3proto.tables.system import SYSTEM

REFERENCE: dict[str, Any] = {name: value for name, value in vars(ev3_dc.constants).items() if not name.startswith("_")}

MINUS_ONE = "ev3_dc has 0x21, which says -31 to the brick; the firmware's number is -1"
TOO_BIG = "ev3_dc has the number as a bare byte, which says another number to the brick: it needs an LC1"
VARIABLE = "ev3_dc has the number 64 as a bare byte, which is the local variable 0 to the brick"
STRING = "ev3_dc has the number 128 as a bare byte, which starts a string to the brick"
SIGNED_BYTE = "ev3_dc packs the index as a signed byte and raises struct.error from 128 on"
SIGNED_SHORT = "ev3_dc packs the index as a signed 16-bit number and raises struct.error from 32768 on"
SIGNED_INT = "ev3_dc packs the index as a signed 32-bit number and raises struct.error from 2147483648 on"
BOOL = "a bool is an int to ev3_dc; as an argument it is more likely a mistake"

# Every difference there is: a name that comes to agree must leave this list, or the tests fail.
DIFFERENT = {
    "opTst": "ev3_dc has 0xDD, which is MAILBOX_CLOSE; the firmware's TST is 0xFF",
    "OBJ_STOP": "ev3_dc has the int 0, which cannot be joined; all its other CMDs are bytes",
    "SET_TESTPIN": "ev3_dc is one too low: the firmware has 24, and UI_WRITE has no CMD 23 in LEGO's firmware",
    "INIT_RUN": "ev3_dc is one too low: the firmware has 25, and 24 is SET_TESTPIN",
    "CURRENT_SLOT": MINUS_ONE,
    "ICON_NONE": MINUS_ONE,
    "MODE_KEEP": MINUS_ONE,
    "TYPE_RESTART_BROWSER": MINUS_ONE,
    "TYPE_REFRESH_BROWSER": "ev3_dc has 0x22, which says -30 to the brick; the firmware's number is -2",
    "TEXTBOX": TOO_BIG,
    "ICON_OBD": TOO_BIG,
    "ICON_OPENFOLDER": TOO_BIG,
    "ICON_BRICK1": TOO_BIG,
    "TYPE_USBSTICK": TOO_BIG,
    "WAITING": TOO_BIG,
    "WARNING_BATTLOW": VARIABLE,
    "STOPPED": VARIABLE,
    "WARNING_BUSY": STRING,
    "HALTED": STRING,
    "LCX(True)": BOOL,
    "LVX(True)": BOOL,
    "GVX(True)": BOOL,
    "LVX(128)": SIGNED_BYTE,
    "GVX(128)": SIGNED_BYTE,
    "LVX(255)": SIGNED_BYTE,
    "GVX(255)": SIGNED_BYTE,
    "LVX(32768)": SIGNED_SHORT,
    "GVX(32768)": SIGNED_SHORT,
    "LVX(65535)": SIGNED_SHORT,
    "GVX(65535)": SIGNED_SHORT,
    "LVX(2147483648)": SIGNED_INT,
    "GVX(2147483648)": SIGNED_INT,
    "LVX(4294967295)": SIGNED_INT,
    "GVX(4294967295)": SIGNED_INT,
    "LCS('größer')": "ev3_dc encodes UTF-8; the brick shows every byte as a character of ISO-8859-1",
    "LCS('5 €')": "ev3_dc encodes UTF-8; ISO-8859-1 has no such character, so there is nothing right to send",
    "LCS('a\\x00b')": "ev3_dc lets a zero into the string, where it ends the string and the rest is read as byte code",
}

LEFT_OUT = """
EV3 DirCmdError SysCmdError
FileSystem Motor Sound Jukebox Voice Touch Color Infrared Ultrasonic Gyro TwoWheelVehicle
RGBColor RawRGBColor VehiclePosition MotorPositions
TRIAD ALLE_MEINE_ENTCHEN HAPPY_BIRTHDAY EU_ANTEMN FRERE_JACQUES
pid
"""
"""What ev3_dc exports beside constants and encoding functions: connection and exceptions, device classes, which send
by themselves, their results, songs, and a controller."""

FUNCTIONS: dict[str, Callable[[Any], bytes]] = {
    "LCX": LCX,
    "LCS": LCS,
    "LVX": LVX,
    "GVX": GVX,
    "port_motor_input": ev3proto.port_motor_input,
}

INDEXES = (-1, 0, 31, 32, 127, 128, 255, 256, 32767, 32768, 65535, 65536, 2**31 - 1, 2**31, 2**32 - 1, 2**32, True, "1")
NUMBERS = (
    *(-32, -33, 31, 32, -127, -128, 127, 128, -32767, -32768, 32767, 32768),
    *(-(2**31), -(2**31) - 1, 2**31, True, 1.5),
)
ARGUMENTS: dict[str, tuple[Any, ...]] = {
    "LCX": NUMBERS,
    "LCS": ("", "myEV3", "größer", "5 €", "a\0b", 5, b"a"),
    "LVX": INDEXES,
    "GVX": INDEXES,
    "port_motor_input": (0, 1, 2, 3, 4, 8, 15, 16, "1"),
}
CALLS = {f"{name}({argument!r})": (name, argument) for name in FUNCTIONS for argument in ARGUMENTS[name]}


def outcome(function: Callable[[Any], bytes], argument: Any) -> bytes | None:
    """What a function gives, None where it refuses: the two packages agree on refusing, not on the exception."""
    try:
        return function(argument)
    except (AssertionError, BuildError, struct.error):
        return None


@each("name", sorted(REFERENCE))
def test_every_constant_of_ev3_dc(name: str) -> None:
    ours, theirs = constant(name), REFERENCE[name]
    if name in DIFFERENT:
        assert ours != theirs, f"{name} agrees now: take it out of DIFFERENT"
    else:
        assert ours == theirs
        assert type(ours) is type(theirs)


@pytest.mark.parametrize("call", CALLS)
def test_every_function_of_ev3_dc(call: str) -> None:
    name, argument = CALLS[call]
    ours, theirs = outcome(FUNCTIONS[name], argument), outcome(getattr(ev3_dc, name), argument)
    if call in DIFFERENT:
        assert ours != theirs, f"{call} agrees now: take it out of DIFFERENT"
    else:
        assert ours == theirs


def test_each_difference_is_tested() -> None:
    assert set(DIFFERENT) <= {*REFERENCE, *CALLS}


def test_all_names_of_ev3_dc_are_known() -> None:
    exported = {name for name, value in vars(ev3_dc).items() if not (name.startswith("_") or inspect.ismodule(value))}
    assert exported - {*REFERENCE, *FUNCTIONS} == set(LEFT_OUT.split())


def test_constants_spelled_as_ev3_dc_spells_them() -> None:
    # `constant` takes opcodes in any case, so that it finds them would not prove the spelling.
    assert set(REFERENCE) <= set(constant_names())


def read_by_the_brick(raw: bytes) -> tuple[str, Any]:
    """Encoding and value of one argument: TIMER_READY has just one."""
    frame = struct.pack("<HHBH", 6 + len(raw), 1, 0x80, 0) + ev3_dc.opTimer_Ready + raw
    message = ev3proto.parse(frame, expect=ev3proto.DirectCommand)
    (argument,) = message.operations[0].arguments
    return argument.encoding, argument.value


# A name of two tables takes the value of the one that names.py puts first; a third such name must be decided on.


def test_names_in_two_tables() -> None:
    tables = [("opcode", f"op{opcode.name}") for opcode in OPCODES]
    tables += [(opcode.name, command.name) for opcode in OPCODES for command in opcode.commands]
    for found in vars(enumerations).values():
        if isinstance(found, Enumeration):
            tables += [(found.name, name) for name in (*found.members, *(found.end or ())[:1])]
    tables += [("bootloader" if entry.bootloader else "system", entry.name) for entry in SYSTEM]
    owners: dict[str, set[str]] = {}
    for table, name in tables:
        owners.setdefault(name, set()).add(table)
    assert {name: tables for name, tables in owners.items() if len(tables) > 1} == {
        "GET_VERSION": {"UI_READ", "bootloader"},
        "BEGIN_DOWNLOAD": {"system", "bootloader"},
    }
    assert constant("GET_VERSION") == b"\x1a"
    assert constant("BEGIN_DOWNLOAD") == b"\x92"


# `constant` and the package's attributes.


def test_constant_values() -> None:
    assert constant("opUI_Draw") == constant("opUI_DRAW") == constant("opui_draw") == b"\x84"
    assert constant("opObject_Return") == constant("opReturn") == constant("opOBJECT_RETURN") == b"\x08"
    assert (constant("TEXTBOX"), constant("CURRENT_SLOT"), constant("HALTED")) == (b"\x81\x20", b"\x3f", b"\x82\x80\0")
    assert (constant("opTst"), constant("SET_TESTPIN"), constant("OBJ_STOP")) == (b"\xff", b"\x18", b"\0")
    assert constant("LED_BLACK") == constant("LED_OFF") == b"\0"
    assert constant("EV3_COLOR") == 29
    assert constant("TYPE_COLOR") == LCX(29)
    assert constant("PORTS_ALL") == 15
    assert constant("opEN_LOG") == constant("OPEN_LOG") == b"\x1b"
    assert constant("START_APP") == b"\xf4"
    assert constant("LCD_WIDTH") == 178
    assert constant("EXT_SOUND") == ".rsf"


def test_unknown_constants_suggest_others() -> None:
    with pytest.raises(KeyError, match="LED_RED_FLASH"):
        constant("LED_RED_FLSH")
    with pytest.raises(KeyError, match="did you mean LED_RED"):
        constant("led_red")
    with pytest.raises(KeyError, match="unknown constant zzz'"):
        constant("zzz")


def test_constant_names() -> None:
    names = constant_names()
    assert names == sorted(set(names))
    for name in names:
        assert getattr(ev3proto, name) == constant(name)
    with pytest.raises(AttributeError, match="opUI_Draw"):
        _ = ev3proto.opUI_Drw
    for name, meant in (
        ("decode", "parse"),
        ("encode", "command"),
        ("pars", "parse"),
        ("Brick", "ev3proto.brick.Brick"),
    ):
        with pytest.raises(AttributeError, match=rf"has no attribute '{name}': did you mean {meant}\?$"):
            getattr(ev3proto, name)


# The encoding functions.


@settings(database=None)
@given(st.integers(-(2**31), 2**31 - 1))
def test_lcx_is_ev3_dc_s(value: int) -> None:
    assert LCX(value) == ev3_dc.LCX(value)
    encoding, read = read_by_the_brick(LCX(value))
    assert read == value
    assert {"LC0": LC0, "LC1": LC1, "LC2": LC2, "LC4": LC4}[encoding](value) == LCX(value)


@settings(database=None)
@given(st.integers(0, 127) | st.integers(256, 32767) | st.integers(65536, 2**31 - 1))
def test_variables_are_ev3_dc_s(index: int) -> None:
    assert LVX(index) == ev3_dc.LVX(index)
    assert GVX(index) == ev3_dc.GVX(index)


@settings(database=None)
@given(st.integers(0, 2**32 - 1))
def test_variables_keep_their_index(index: int) -> None:
    assert read_by_the_brick(LVX(index))[1] == index
    assert read_by_the_brick(GVX(index))[1] == index


@pytest.mark.parametrize(
    ("encoded", "expected"),
    [
        (LC0(-1), "3f"),
        (LC0(31), "1f"),
        (LC1(-128), "81 80"),
        (LC2(-2), "82 fe ff"),
        (LC4(5), "83 05 00 00 00"),
        (LCF(-2), "83 00 00 00 c0"),
        (LCF(math.nan), "83 00 00 c0 7f"),
        (LCF(math.inf), "83 00 00 80 7f"),
        (LAB1(-3), "a0 fd"),
        (LVX(40), "c1 28"),
        (LVX(200), "c1 c8"),
        (GVX(40000), "e2 40 9c"),
        (HND(LC1(3)), "91 03"),
        (ADR(LC4(0x8000)), "8b 00 80 00 00"),
        (ADR(HND(LVX(300))), "da 2c 01"),
    ],
)
def test_encoding(encoded: bytes, expected: str) -> None:
    assert encoded == bytes.fromhex(expected)


@pytest.mark.parametrize(
    ("function", "argument", "sentence"),
    [
        (LCX, True, "LCX takes a whole number, not True"),
        (LCX, "1", "LCX takes a whole number, not '1'"),
        (LCX, 2**31, "a constant cannot be 2147483648"),
        (LC0, 32, "LC0 cannot hold 32"),
        (LC1, 128, "LC1 cannot hold 128"),
        (LC4, 1.0, "LC4 takes a whole number"),
        (LCF, "1", "LCF takes a number"),
        (LCF, 1e39, "LCF cannot be 1e"),
        (LCS, b"a", "LCS takes a str"),
        (LCS, "a\0", "a text cannot contain a zero"),
        (LCS, "€", "ISO-8859-1"),
        (LVX, -1, "LVX cannot be"),
        (GVX, 2**32, "GVX cannot be"),
        (LAB1, 128, "LAB1 cannot be 128"),
        (HND, LVX(3), "is a short form"),
        (HND, b"", "HND takes the bytes of one encoded constant or variable"),
        (ADR, LCS("a"), "ADR takes the bytes of one"),
        (ADR, LAB1(1), "ADR takes the bytes of one"),
    ],
)
def test_refusals(function: Callable[[Any], bytes], argument: Any, sentence: str) -> None:
    with pytest.raises(BuildError) as caught:
        function(argument)
    assert sentence in str(caught.value)
