"""Arithmetic, bits, shifts, MATH, RANDOM."""

from __future__ import annotations

import math
from collections.abc import Callable

from ev3proto.brick import soft_float
from ev3proto.brick.conversions import quotient, single
from ev3proto.brick.formatting import fixed
from ev3proto.brick.handlers import computes, handles
from ev3proto.brick.locations import WRITERS, Location
from ev3proto.brick.machine import Machine
from ev3proto.tables.declaration import NUMBER_TYPES, Type
from ev3proto.tables.encoding import RANGES

_TYPES = {suffix: kind for suffix, kind, _ in NUMBER_TYPES}
_INTEGERS = {suffix: kind for suffix, kind in _TYPES.items() if kind is not Type.DATAF}

IntegerFunction = Callable[[int, int], int]


def _float_operation(function: IntegerFunction) -> Callable[[Machine], None]:
    def operate(vm: Machine) -> None:
        left = vm.float_bits()
        right = vm.float_bits()
        vm.place().write32(function(left, right))

    return operate


def _division(kind: Type) -> IntegerFunction:
    most = RANGES[kind].high

    def divide(dividend: int, divisor: int) -> int:
        if divisor == 0:
            return most if dividend > 0 else -most if dividend < 0 else 0
        return quotient(dividend, divisor)

    return divide


def _shift(value: int, count: int) -> int:
    """Returns the value as 32 bits, shifted to the left by the low byte of the count."""
    count &= 0xFF
    return value << count if count < 32 else 0


def _remainder(dividend: int, divisor: int) -> int:
    """Returns the remainder of `quotient`. By zero, which kills the real machine, it is 0."""
    return dividend - quotient(dividend, divisor) * divisor if divisor else 0


def _integer_operation(kind: Type, function: IntegerFunction) -> Callable[[Machine, int, int, Location], None]:
    write = WRITERS[kind]
    return lambda _, left, right, destination: write(destination, function(left, right))


for _suffix, _kind in _INTEGERS.items():
    for _name, _function in (
        ("ADD", int.__add__),
        ("SUB", int.__sub__),
        ("MUL", int.__mul__),
        ("DIV", _division(_kind)),
        ("OR", int.__or__),
        ("AND", int.__and__),
        ("XOR", int.__xor__),
        ("RL", _shift),
        ("MATH.MOD", _remainder),
    ):
        # ADD8, SUB8, MUL8, DIV8, OR8, AND8, XOR8, RL8, MATH.MOD8, ADD16, SUB16, MUL16, DIV16, OR16, AND16, XOR16,
        # RL16, MATH.MOD16, ADD32, SUB32, MUL32, DIV32, OR32, AND32, XOR32, RL32, MATH.MOD32
        handles(_name + _suffix)(_integer_operation(_kind, _function))
for _name, _function in (
    ("ADDF", soft_float.add),
    ("SUBF", soft_float.subtract),
    ("MULF", soft_float.multiply),
    ("DIVF", soft_float.divide),
):
    handles(_name, raw=True)(_float_operation(_function))


# MATH

RADIANS = 0.0174532925
"""A degree in radians, as the firmware writes it."""

DEGREES = 57.2957795
"""A radian in degrees, as the firmware writes it."""

MOST_DECIMALS = 9


def _defined(function: Callable[..., float]) -> Callable[..., float]:
    """Returns a function as in C: infinity beyond the range and NaN outside the domain, where Python raises errors."""

    def calculate(_: Machine, *values: float) -> float:
        try:
            return function(*values)
        except OverflowError:
            return math.inf
        except ValueError:
            return math.nan

    return calculate


def _logarithm(function: Callable[[float], float]) -> Callable[..., float]:
    return _defined(lambda value: function(value) if value else -math.inf)


def _whole(function: Callable[[float], int]) -> Callable[..., float]:
    """Returns floor or ceiling, keeping the sign of zero."""
    return lambda _, value: math.copysign(function(value), value) if math.isfinite(value) else value


def _of_degrees(function: Callable[[float], float]) -> Callable[..., float]:
    return _defined(lambda value: function(single(value * RADIANS)))


def _in_degrees(function: Callable[[float], float]) -> Callable[..., float]:
    return _defined(lambda value: function(value) * DEGREES)


def _power(base: float, exponent: float) -> float:
    """Returns X to the power of Y; infinite results keep the sign of X for odd powers only."""
    is_odd = math.isfinite(exponent) and exponent % 2 == 1
    try:
        return math.pow(base, exponent)
    except OverflowError:
        return -math.inf if base < 0 and is_odd else math.inf
    except ValueError:
        # Zero to a negative power, or a negative number to a power that is not whole.
        return math.copysign(math.inf, base if is_odd else 1) if base == 0 else math.nan


def _truncated(value: float, decimals: int) -> float:
    """Cuts X, as a text with 6 decimals, after a number of them (9 at most)."""
    text = fixed(value, 6)
    point = text.find(".")
    return float(text if point < 0 else text[: point + 1 + min(max(decimals, 0), MOST_DECIMALS)])


def _drawn(vm: Machine, low: int, high: int) -> int:
    """Returns a random number between two ends; the ends are half as likely as the others."""
    return quotient(vm.brick.random.randrange(0x8000) * (high - low) + 0x3FFF, 0x7FFF) + low


computes(
    {
        "MATH.EXP": _defined(math.exp),
        "MATH.FLOOR": _whole(math.floor),
        "MATH.CEIL": _whole(math.ceil),
        "MATH.ROUND": _defined(soft_float.round_half_away),
        "MATH.SQRT": _defined(math.sqrt),
        "MATH.LOG": _logarithm(math.log10),
        "MATH.LN": _logarithm(math.log),
        "MATH.SIN": _of_degrees(math.sin),
        "MATH.COS": _of_degrees(math.cos),
        "MATH.TAN": _of_degrees(math.tan),
        "MATH.ASIN": _in_degrees(math.asin),
        "MATH.ACOS": _in_degrees(math.acos),
        "MATH.ATAN": _in_degrees(math.atan),
        # With the sign of the dividend; NaN by zero.
        "MATH.MOD": _defined(math.fmod),
        "MATH.POW": _defined(_power),
        "MATH.TRUNC": _defined(_truncated),
        "RANDOM": _drawn,
    }
)


@handles("MATH.ABS", raw=True)
def absolute(vm: Machine) -> None:
    """Drops the sign, also that of NaN."""
    bits = vm.float_bits()
    vm.place().write32(bits & 0x7FFFFFFF)


@handles("MATH.NEGATE", raw=True)
def negate(vm: Machine) -> None:
    """Writes 0 - X, so that 0 stays without a sign."""
    bits = vm.float_bits()
    vm.place().write32(soft_float.subtract(0, bits))
