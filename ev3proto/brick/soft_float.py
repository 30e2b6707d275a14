"""Arithmetic on singles as on the brick's processor, which has no floating-point unit.

Numbers are IEEE's, so Python's results are the same once they are rounded to singles. But processors differ in which
NaN they return, and its bits are in the reply: here they follow the ARM's software floats.
Values are the 32 bits of a single.
"""

from __future__ import annotations

import math

from ev3proto.brick.conversions import bits_of, float_of, is_nan
from ev3proto.brick.locations import NOT_A_NUMBER

_SIGN = 0x80000000
_EXPONENT = 0x7F800000
_QUIET = 0x00400000


def add(left: int, right: int) -> int:
    """Returns the sum."""
    if not (_is_special(left) or _is_special(right)):
        return bits_of(float_of(left) + float_of(right))
    if not _is_special(left):
        left = right
    elif not _is_special(right):
        right = left
    return left if left == right and not is_nan(left) else left | _QUIET


def subtract(left: int, right: int) -> int:
    """Returns the difference, which is left plus the negated right, even where that is NaN."""
    return add(left, right ^ _SIGN)


def multiply(left: int, right: int) -> int:
    """Returns the product."""
    if not (_is_special(left) or _is_special(right)):
        return bits_of(float_of(left) * float_of(right))
    if not left & ~_SIGN:
        return right | NOT_A_NUMBER
    if not right & ~_SIGN or is_nan(left):
        return left | NOT_A_NUMBER
    if is_nan(right):
        return right | NOT_A_NUMBER
    return (left ^ right) & _SIGN | _EXPONENT


def divide(left: int, right: int) -> int:
    """Returns the quotient."""
    sign = (left ^ right) & _SIGN
    if is_nan(left):
        return left | NOT_A_NUMBER
    if _is_special(left):
        return right | NOT_A_NUMBER if _is_special(right) else sign | _EXPONENT
    if is_nan(right):
        return right | NOT_A_NUMBER
    if _is_special(right):
        return sign
    if not right & ~_SIGN:
        return sign | _EXPONENT if left & ~_SIGN else left | NOT_A_NUMBER
    return bits_of(float_of(left) / float_of(right))


def _is_special(bits: int) -> bool:
    """Returns whether a single is infinity or NaN."""
    return bits & _EXPONENT == _EXPONENT


def round_half_away(value: float) -> float:
    """Returns the nearest whole number, halves away from zero: the sum with a half is a single, too."""
    if math.isnan(value) or math.isinf(value):
        return value
    half = float_of(bits_of(value + 0.5 if value >= 0 else value - 0.5))
    # The sign of zero is kept, as by floor() and ceil() of C.
    return math.copysign(math.floor(half) if value >= 0 else math.ceil(half), half)
