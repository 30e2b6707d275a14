"""Values on the virtual brick: moves, arithmetic, comparing, jumps, as they were measured on the firmware."""

from __future__ import annotations

import math
import struct

import pytest
from support.bricks import FAIL, OK, op, run

from ev3proto.brick import Brick
from ev3proto.messages import GV, LV

NAN_8, NAN_16, NAN_32, NAN_F = -128, -32768, -2147483648, 0x7FC00000


def integer(brick: Brick, *code: bytes, size: int = 4) -> int:
    kind, memory = run(brick, *code, globals=size)
    assert kind == OK
    return int.from_bytes(memory, "little", signed=True)


def bits(brick: Brick, *code: bytes) -> int:
    return integer(brick, *code) & 0xFFFFFFFF


def number(brick: Brick, *code: bytes) -> float:
    return float(struct.unpack("<f", struct.pack("<I", bits(brick, *code)))[0])


def in_locals(type_: str, value: float | int) -> bytes:
    """Puts a value of any bits into LV0."""
    packed = struct.pack({"8": "<b", "16": "<h", "32": "<i", "F": "<f"}[type_], value)
    return op("INIT_BYTES", LV(0), len(packed), list(struct.unpack(f"{len(packed)}b", packed)))


SIZES = {"8": 1, "16": 2, "32": 4, "F": 4}


@pytest.mark.parametrize(
    ("source", "target", "value", "expected"),
    [
        ("8", "16", NAN_8, NAN_16),
        ("8", "32", NAN_8, NAN_32),
        ("8", "32", -5, -5),
        ("16", "32", NAN_16, NAN_32),
        ("16", "8", NAN_16, NAN_8),
        ("16", "8", 1000, 127),
        ("16", "8", -1000, -127),
        ("16", "8", -128, -127),
        ("32", "8", NAN_32, NAN_8),
        ("32", "16", 70000, 32767),
        ("32", "16", -70000, -32767),
        ("32", "16", -32768, -32767),
        ("F", "8", 127.9, 127),
        ("F", "8", -2.5, -2),
        ("F", "8", -128.0, -127),
        ("F", "8", math.inf, 127),
        ("F", "8", math.nan, NAN_8),
        ("F", "16", 40000.0, 32767),
        ("F", "16", -math.inf, -32767),
        ("F", "32", 2147483648.0, 2147483647),
        ("F", "32", math.inf, 2147483647),
        ("F", "32", 2147483520.0, 2147483520),
        ("F", "32", -2147483648.0, NAN_32),
        ("F", "32", -math.inf, NAN_32),
        ("F", "32", math.nan, NAN_32),
        ("8", "8", NAN_8, NAN_8),
    ],
)
def test_moves_to_integers(brick: Brick, source: str, target: str, value: float, expected: int) -> None:
    code = in_locals(source, value), op(f"MOVE{source}_{target}", LV(0), GV(0))
    kind, memory = run(brick, *code, globals=SIZES[target], locals=4)
    assert (kind, int.from_bytes(memory, "little", signed=True)) == (OK, expected)


@pytest.mark.parametrize(
    ("source", "value", "expected"),
    [
        ("8", NAN_8, NAN_F),
        ("16", NAN_16, NAN_F),
        ("32", NAN_32, NAN_F),
        ("8", -3, 0xC0400000),
        ("32", 16777217, 0x4B800000),  # rounded to even
        ("32", 16777219, 0x4B800002),
        ("32", 2147483647, 0x4F000000),
    ],
)
def test_moves_to_floats(brick: Brick, source: str, value: int, expected: int) -> None:
    assert bits(brick, in_locals(source, value), op(f"MOVE{source}_F", LV(0), GV(0))) == expected


def test_a_float_is_copied_with_the_bits_of_its_nan(brick: Brick) -> None:
    signalling = op("INIT_BYTES", LV(0), 4, [1, 0, -128, 127])
    assert bits(brick, signalling, op("MOVEF_F", LV(0), GV(0))) == 0x7F800001
    assert bits(brick, signalling, op("SELECTF", 1, LV(0), 1.0, GV(0))) == 0x7F800001


def test_bytes_and_elements(brick: Brick) -> None:
    code = (
        op("INIT_BYTES", LV(0), 6, [1, 2, 3, 4, 5, 6]),
        op("READ16", LV(0), 2, GV(0)),
        op("WRITE8", 9, 3, GV(0)),
        op("READ8", LV(4), -3, GV(2)),
    )
    assert run(brick, *code, globals=4, locals=6) == (OK, bytes((5, 6, 2, 9)))


def test_bytes_are_cut_to_eight_bits(brick: Brick) -> None:
    assert run(brick, bytes.fromhex("2F 60 02 82 2C 01 3F"), globals=2) == (OK, bytes((44, 255)))


@pytest.mark.parametrize(
    ("name", "left", "right", "expected"),
    [
        ("ADD8", 100, 100, -56),
        ("SUB8", -100, 100, 56),
        ("MUL8", 100, 3, 44),
        ("ADD16", 30000, 30000, -5536),
        ("MUL16", 300, 300, 24464),
        ("ADD32", 2147483647, 1, -2147483648),
        ("MUL32", 65536, 65536, 0),
        ("DIV8", 7, -2, -3),
        ("DIV8", -7, 2, -3),
        ("DIV8", 5, 0, 127),
        ("DIV8", -5, 0, -127),
        ("DIV8", 0, 0, 0),
        ("DIV8", NAN_8, -1, -128),
        ("DIV16", 5, 0, 32767),
        ("DIV16", -5, 0, -32767),
        ("DIV16", NAN_16, -1, -32768),
        ("DIV32", 5, 0, 2147483647),
        ("DIV32", -5, 0, -2147483647),
        ("DIV32", NAN_32, -1, -2147483648),
        ("OR8", 0x55, 0x0F, 0x5F),
        ("AND16", 0x5555, 0x0FF0, 0x0550),
        ("XOR32", -1, 0x0F, -16),
        ("RL8", 1, 7, -128),
        ("RL8", 1, 8, 0),
        ("RL8", -1, 31, 0),
        ("RL16", 3, 4, 48),
        ("RL32", 1, 31, -2147483648),
        ("RL32", 1, 32, 0),
        ("RL32", 1, -1, 0),
        ("RL32", -1, 256, -1),
        ("MATH.MOD8", -7, 3, -1),
        ("MATH.MOD16", 7, -3, 1),
        ("MATH.MOD32", NAN_32, 7, -2),
    ],
)
def test_integer_arithmetic(brick: Brick, name: str, left: int, right: int, expected: int) -> None:
    size = {"8": "8", "6": "16", "2": "32"}[name[-1]]
    layout = {"8": "<b", "16": "<h", "32": "<i"}[size]
    packed = struct.pack(layout, left).ljust(4, b"\0") + struct.pack(layout, right)
    values = op("INIT_BYTES", LV(0), len(packed), list(struct.unpack(f"{len(packed)}b", packed)))
    kind, memory = run(brick, values, op(name, LV(0), LV(4), GV(0)), globals=SIZES[size], locals=8)
    assert (kind, int.from_bytes(memory, "little", signed=True)) == (OK, expected)


def test_the_remainder_by_zero_does_not_kill_this_machine(brick: Brick) -> None:
    assert integer(brick, op("MATH.MOD32", 5, 0, GV(0))) == 0


@pytest.mark.parametrize(
    ("name", "left", "right", "expected"),
    [
        ("ADDF", 16777216.0, 1.0, 0x4B800000),
        ("ADDF", 3e38, 3e38, 0x7F800000),
        ("MULF", -3e38, 3e38, 0xFF800000),
        ("SUBF", 1.0, 1.0, 0),
        ("DIVF", 1.0, 0.0, 0x7F800000),
        ("DIVF", -1.0, 0.0, 0xFF800000),
        ("DIVF", 0.0, 0.0, NAN_F),
        ("DIVF", 1.0, 3.0, 0x3EAAAAAB),
        ("DIVF", 1.0, math.inf, 0),
        ("SUBF", math.inf, math.inf, NAN_F),
        ("ADDF", math.nan, 1.0, NAN_F),
        ("MULF", math.inf, 0.0, NAN_F),
        ("MULF", 0.0, -math.inf, 0xFFC00000),
        ("SUBF", 1.0, math.nan, 0xFFC00000),
        ("DIVF", math.nan, 0.0, NAN_F),
        ("DIVF", math.inf, -2.0, 0xFF800000),
    ],
)
def test_float_arithmetic(brick: Brick, name: str, left: float, right: float, expected: int) -> None:
    assert bits(brick, op(name, left, right, GV(0))) == expected


@pytest.mark.parametrize(
    ("name", "values", "expected"),
    [
        ("EXP", (1.0,), math.e),
        ("EXP", (1000.0,), math.inf),
        ("LN", (math.e,), 1.0),
        ("LN", (0.0,), -math.inf),
        ("LOG", (1000.0,), 3.0),
        ("LOG", (0.0,), -math.inf),
        ("SQRT", (2.0,), 1.4142135),
        ("POW", (2.0, 0.5), 1.4142135),
        ("POW", (-2.0, 3.0), -8.0),
        ("POW", (0.0, -1.0), math.inf),
        ("POW", (-10.0, 39.0), -math.inf),
        ("FLOOR", (-1.5,), -2.0),
        ("CEIL", (1.2,), 2.0),
        ("ROUND", (2.5,), 3.0),
        ("ROUND", (-2.5,), -3.0),
        ("ROUND", (0.49999997,), 1.0),
        ("ABS", (-2.0,), 2.0),
        ("NEGATE", (2.0,), -2.0),
        ("TRUNC", (1.999, 2), 1.99),
        ("TRUNC", (-1.999, 0), -1.0),
        ("TRUNC", (1.23456789, 9), 1.234568),
        ("TRUNC", (1.5, -3), 1.0),
        ("MOD", (-7.5, 2.0), -1.5),
        ("SIN", (30.0,), 0.5),
        ("COS", (180.0,), -1.0),
        ("TAN", (45.0,), 1.0),
        ("ASIN", (1.0,), 90.0),
        ("ACOS", (-1.0,), 180.0),
        ("ATAN", (1.0,), 45.0),
    ],
)
def test_functions(brick: Brick, name: str, values: tuple[float, ...], expected: float) -> None:
    assert number(brick, op(f"MATH.{name}", *values, GV(0))) == pytest.approx(expected, rel=3e-7)


@pytest.mark.parametrize(
    ("name", "values", "expected"),
    [
        ("LN", (-1.0,), NAN_F),
        ("LOG", (-1.0,), NAN_F),
        ("SQRT", (-1.0,), NAN_F),
        ("ASIN", (1.5,), NAN_F),
        ("ACOS", (-1.5,), NAN_F),
        ("MOD", (5.0, 0.0), NAN_F),
        ("SQRT", (-0.0,), 0x80000000),
        ("CEIL", (-0.5,), 0x80000000),
        ("NEGATE", (0.0,), 0),
        ("FLOOR", (0.5,), 0),
    ],
)
def test_nan_results_and_zeros_with_their_sign(
    brick: Brick, name: str, values: tuple[float, ...], expected: int
) -> None:
    assert bits(brick, op(f"MATH.{name}", *values, GV(0))) == expected


def test_random_numbers_reach_both_ends(brick: Brick) -> None:
    drawn = {integer(brick, op("RANDOM", -1, 2, GV(0)), size=2) for _ in range(300)}
    assert drawn == {-1, 0, 1, 2}


@pytest.mark.parametrize(
    ("name", "left", "right", "expected"),
    [
        ("LT8", -127, 1, 1),
        ("GT16", 5, 5, 0),
        ("GTEQ32", 5, 5, 1),
        ("NEQ8", 1, 2, 1),
        ("EQF", -0.0, 0.0, 1),
        ("LTF", math.nan, 1.0, 0),
        ("GTF", 1.0, math.nan, 0),
        ("EQF", math.nan, math.nan, 0),
        ("LTEQF", math.nan, 1.0, 0),
        ("GTEQF", math.nan, 1.0, 0),
        ("NEQF", math.nan, math.nan, 1),
    ],
)
def test_comparing_and_the_jump_that_does_the_same(
    brick: Brick, name: str, left: float, right: float, expected: int
) -> None:
    assert integer(brick, op(f"CP_{name}", left, right, GV(0)), size=1) == expected
    jump = op(f"JR_{name}", left, right, 3), op("MOVE8_8", 1, GV(0)), op("NOP")
    assert integer(brick, op("MOVE8_8", 0, GV(0)), *jump, size=1) == 1 - expected


def test_select_takes_one_of_two(brick: Brick) -> None:
    assert integer(brick, op("SELECT8", 2, 10, 20, GV(0)), size=1) == 10
    assert integer(brick, op("SELECT32", 0, 10, -20, GV(0))) == -20


@pytest.mark.parametrize(
    ("jump", "is_taken"),
    [
        (op("JR", 3), True),
        (op("JR_TRUE", 2, 3), True),
        (op("JR_TRUE", 0, 3), False),
        (op("JR_FALSE", 0, 3), True),
        (op("JR_FALSE", -1, 3), False),
        (op("JR_NAN", math.nan, 3), True),
        (op("JR_NAN", 1.0, 3), False),
    ],
)
def test_jumps(brick: Brick, jump: bytes, is_taken: bool) -> None:
    code = op("MOVE8_8", 0, GV(0)), jump, op("MOVE8_8", 1, GV(0))
    assert integer(brick, *code, size=1) == (not is_taken)


def test_the_offset_of_a_jump_may_be_a_variable(brick: Brick) -> None:
    code = op("MOVE32_32", 3, LV(0)), op("JR", LV(0)), op("MOVE8_8", 1, GV(0)), op("MOVE8_8", 2, GV(1))
    assert run(brick, op("MOVE16_16", 0, GV(0)), globals=2) == (OK, bytes(2))
    assert run(brick, *code, globals=2, locals=4) == (OK, bytes((0, 2)))


def test_a_jump_to_the_end_ends_the_command_and_one_beyond_fails(brick: Brick) -> None:
    assert run(brick, op("JR", 3), op("MOVE8_8", 1, GV(0)))[0] == OK
    assert run(brick, op("JR", 4), op("MOVE8_8", 1, GV(0)))[0] == FAIL
    assert run(brick, op("JR", -3))[0] == FAIL
