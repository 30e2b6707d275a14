"""Conversions between the types of numbers, and results of arithmetic cut to their width, as in the firmware."""

from __future__ import annotations

import struct

from ev3proto.brick.locations import NOT_A_NUMBER
from ev3proto.tables.declaration import Type
from ev3proto.tables.encoding import RANGES

_FLOAT = struct.Struct("<f")
_BITS = struct.Struct("<I")

NAN8, NAN16, NAN32 = (RANGES[kind].nan for kind in (Type.DATA8, Type.DATA16, Type.DATA32))


def wrap8(value: int) -> int:
    """Returns the low 8 bits of a number, with their sign."""
    return (value + 0x80 & 0xFF) - 0x80


def wrap16(value: int) -> int:
    """Returns the low 16 bits of a number, with their sign."""
    return (value + 0x8000 & 0xFFFF) - 0x8000


def quotient(dividend: int, divisor: int) -> int:
    """Returns a quotient as in C, cut towards zero. The divisor is not 0."""
    result = abs(dividend) // abs(divisor)
    return result if (dividend < 0) == (divisor < 0) else -result


def single(value: float) -> float:
    """Returns the nearest single to a number; infinity beyond their range."""
    try:
        return float(_FLOAT.unpack(_FLOAT.pack(value))[0])
    except OverflowError:
        return float("inf") if value > 0 else float("-inf")


def bits_of(value: float) -> int:
    """Returns the bits of the nearest single; for any NaN the bits of the brick's own NaN."""
    if value != value:
        return NOT_A_NUMBER
    return int(_BITS.unpack(_FLOAT.pack(single(value)))[0])


def float_of(bits: int) -> float:
    """Returns the single that has these bits."""
    return float(_FLOAT.unpack(_BITS.pack(bits))[0])


def is_nan(bits: int) -> bool:
    """Returns whether a single with these bits is not a number."""
    return bits & 0x7FFFFFFF > 0x7F800000


def narrowed(value: int, source_nan: int, target: Type) -> int:
    """Returns an integer limited to the range of a narrower type; NaN stays NaN."""
    low, high, nan = RANGES[target]
    return nan if value == source_nan else min(high, max(low, value))


def widened(value: int, source_nan: int, target: Type) -> int:
    """Returns an integer converted to a wider type; NaN stays NaN."""
    return RANGES[target].nan if value == source_nan else value


def float_to_integer(bits: int, target: Type) -> int:
    """Returns a single as an integer, limited to the target's range and cut towards zero; NaN stays NaN."""
    # Limits of 32 bits are singles themselves, so the lowest one is -2147483648, which is the pattern for NaN.
    low, high, nan = RANGES[target]
    if is_nan(bits):
        return nan
    value = float_of(bits)
    if target is Type.DATA32:
        if value >= 2147483648.0:
            return high
        return nan if value <= -2147483648.0 else int(value)
    return int(min(float(high), max(float(low), value)))
