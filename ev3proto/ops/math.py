"""MATH: applies a mathematical function.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import Number, Output, Real
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = [
    "abs",
    "acos",
    "asin",
    "atan",
    "ceil",
    "cos",
    "exp",
    "floor",
    "ln",
    "log",
    "mod",
    "mod8",
    "mod16",
    "mod32",
    "negate",
    "pow",
    "round",
    "sin",
    "sqrt",
    "tan",
    "trunc",
]

_OPERATIONS = drafts("official")


def exp(x: Real, r: Output = None, *, unchecked: bool = False) -> Draft:
    """Raises e to a power.

    Args:
        x: The power; DATAF.
        r: Result; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MATH.EXP"].draft((x, r), unchecked)


def mod(x: Real, y: Real, r: Output = None, *, unchecked: bool = False) -> Draft:
    """Takes the remainder of a floating-point division.

    Args:
        x: Number to divide; DATAF.
        y: Number to divide by; DATAF.
        r: Remainder, with the sign of X; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MATH.MOD"].draft((x, y, r), unchecked)


def floor(x: Real, r: Output = None, *, unchecked: bool = False) -> Draft:
    """Rounds down to a whole number.

    Args:
        x: Number to work on; DATAF.
        r: Result; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MATH.FLOOR"].draft((x, r), unchecked)


def ceil(x: Real, r: Output = None, *, unchecked: bool = False) -> Draft:
    """Rounds up to a whole number.

    Args:
        x: Number to work on; DATAF.
        r: Result; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MATH.CEIL"].draft((x, r), unchecked)


def round(x: Real, r: Output = None, *, unchecked: bool = False) -> Draft:
    """Rounds to the nearest whole number, halves away from zero.

    Args:
        x: Number to work on; DATAF.
        r: Result; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MATH.ROUND"].draft((x, r), unchecked)


def abs(x: Real, r: Output = None, *, unchecked: bool = False) -> Draft:
    """Drops the sign.

    Args:
        x: Number to work on; DATAF.
        r: Result; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MATH.ABS"].draft((x, r), unchecked)


def negate(x: Real, r: Output = None, *, unchecked: bool = False) -> Draft:
    """Reverses the sign.

    Args:
        x: Number to work on; DATAF.
        r: Result; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MATH.NEGATE"].draft((x, r), unchecked)


def sqrt(x: Real, r: Output = None, *, unchecked: bool = False) -> Draft:
    """Takes the square root.

    Args:
        x: Number to work on, not negative; DATAF.
        r: Result; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MATH.SQRT"].draft((x, r), unchecked)


def log(x: Real, r: Output = None, *, unchecked: bool = False) -> Draft:
    """Takes the logarithm to base 10.

    Args:
        x: Number to work on, above 0; DATAF.
        r: Result; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MATH.LOG"].draft((x, r), unchecked)


def ln(x: Real, r: Output = None, *, unchecked: bool = False) -> Draft:
    """Takes the natural logarithm.

    Args:
        x: Number to work on, above 0; DATAF.
        r: Result; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MATH.LN"].draft((x, r), unchecked)


def sin(x: Real, r: Output = None, *, unchecked: bool = False) -> Draft:
    """Takes the sine of an angle in degrees.

    Args:
        x: Angle; degrees; DATAF.
        r: Sine, -1 to 1; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MATH.SIN"].draft((x, r), unchecked)


def cos(x: Real, r: Output = None, *, unchecked: bool = False) -> Draft:
    """Takes the cosine of an angle in degrees.

    Args:
        x: Angle; degrees; DATAF.
        r: Cosine, -1 to 1; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MATH.COS"].draft((x, r), unchecked)


def tan(x: Real, r: Output = None, *, unchecked: bool = False) -> Draft:
    """Takes the tangent of an angle in degrees.

    Args:
        x: Angle; degrees; DATAF.
        r: Tangent; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MATH.TAN"].draft((x, r), unchecked)


def asin(x: Real, r: Output = None, *, unchecked: bool = False) -> Draft:
    """Finds the angle that has a sine.

    Args:
        x: Sine; -1 to 1; DATAF.
        r: Angle; degrees; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MATH.ASIN"].draft((x, r), unchecked)


def acos(x: Real, r: Output = None, *, unchecked: bool = False) -> Draft:
    """Finds the angle that has a cosine.

    Args:
        x: Cosine; -1 to 1; DATAF.
        r: Angle; degrees; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MATH.ACOS"].draft((x, r), unchecked)


def atan(x: Real, r: Output = None, *, unchecked: bool = False) -> Draft:
    """Finds the angle that has a tangent.

    Args:
        x: Tangent; DATAF.
        r: Angle; degrees; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MATH.ATAN"].draft((x, r), unchecked)


def mod8(x: Number, y: Number, r: Output = None, *, unchecked: bool = False) -> Draft:
    """Takes the remainder of an 8-bit division.

    Args:
        x: Number to divide; DATA8.
        y: Number to divide by, not 0; DATA8.
        r: Remainder, with the sign of X; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MATH.MOD8"].draft((x, y, r), unchecked)


def mod16(x: Number, y: Number, r: Output = None, *, unchecked: bool = False) -> Draft:
    """Takes the remainder of a 16-bit division.

    Args:
        x: Number to divide; DATA16.
        y: Number to divide by, not 0; DATA16.
        r: Remainder, with the sign of X; DATA16; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MATH.MOD16"].draft((x, y, r), unchecked)


def mod32(x: Number, y: Number, r: Output = None, *, unchecked: bool = False) -> Draft:
    """Takes the remainder of a 32-bit division.

    Args:
        x: Number to divide; DATA32.
        y: Number to divide by, not 0; DATA32.
        r: Remainder, with the sign of X; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MATH.MOD32"].draft((x, y, r), unchecked)


def pow(x: Real, y: Real, r: Output = None, *, unchecked: bool = False) -> Draft:
    """Raises a number to a power.

    Args:
        x: Number to raise; DATAF.
        y: The power; DATAF.
        r: Result; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MATH.POW"].draft((x, y, r), unchecked)


def trunc(x: Real, p: Number, r: Output = None, *, unchecked: bool = False) -> Draft:
    """Cuts off decimals without rounding.

    Args:
        x: Number to work on; DATAF.
        p: Number of decimals to keep (at most 6 are available); 0 to 9; DATA8.
        r: Result; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MATH.TRUNC"].draft((x, p, r), unchecked)
