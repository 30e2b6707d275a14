"""Arithmetic, bits, shifts, MATH, RANDOM."""

from __future__ import annotations

import math
from collections.abc import Callable

from ev3proto.brick import soft_float
from ev3proto.brick.conversions import single
from ev3proto.brick.formatting import fixed
from ev3proto.brick.handlers import handles
from ev3proto.brick.machine import Machine
from ev3proto.brick.places import Place
from ev3proto.tables.declaration import Type
from ev3proto.tables.encoding import RANGES
from ev3proto.tables.math import SIZES

_TYPES = {suffix: kind for suffix, kind, _ in SIZES}
_INTEGERS = {suffix: kind for suffix, kind in _TYPES.items() if kind is not Type.DATAF}

IntegerFunction = Callable[[int, int], int]


def quotient(dividend: int, divisor: int) -> int:
    """A division as in C: towards zero. The divisor is not 0."""
    result = abs(dividend) // abs(divisor)
    return result if (dividend < 0) == (divisor < 0) else -result


def _integer_operation(kind: Type, function: IntegerFunction) -> Callable[[Machine, int, int, Place], None]:
    write = {Type.DATA8: Place.write8, Type.DATA16: Place.write16, Type.DATA32: Place.write32}[kind]

    def operate(_: Machine, left: int, right: int, destination: Place) -> None:
        write(destination, function(left, right))

    return operate


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
    """A shift to the left of the value as 32 bits; the low byte of the count counts."""
    count &= 0xFF
    return value << count if count < 32 else 0


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
    ):
        # ADD8, SUB8, MUL8, DIV8, OR8, AND8, XOR8, RL8, ADD16, SUB16, MUL16, DIV16, OR16, AND16, XOR16,
        # RL16, ADD32, SUB32, MUL32, DIV32, OR32, AND32, XOR32, RL32
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
"""Of a degree, as the firmware writes it."""

DEGREES = 57.2957795
"""Of a radian, as the firmware writes it."""

MOST_DECIMALS = 9


def _defined(function: Callable[[float], float]) -> Callable[[float], float]:
    """The function of C that Python raises errors for: infinity beyond the range, NaN outside the domain."""

    def calculate(value: float) -> float:
        try:
            return function(value)
        except OverflowError:
            return math.inf
        except ValueError:
            return math.nan

    return calculate


def _logarithm(function: Callable[[float], float]) -> Callable[[float], float]:
    def calculate(value: float) -> float:
        if value == 0:
            return -math.inf
        return math.nan if value < 0 else function(value)

    return calculate


def _whole(function: Callable[[float], int]) -> Callable[[float], float]:
    """Floor or ceiling, with the sign of zero kept."""

    def calculate(value: float) -> float:
        return value if math.isinf(value) or math.isnan(value) else math.copysign(function(value), value)

    return calculate


def _of_degrees(function: Callable[[float], float]) -> Callable[[float], float]:
    return _defined(lambda value: function(single(value * RADIANS)))


def _in_degrees(function: Callable[[float], float]) -> Callable[[float], float]:
    return _defined(lambda value: function(value) * DEGREES)


def _single_argument(function: Callable[[float], float]) -> Callable[[Machine, float, Place], None]:
    def operate(_: Machine, value: float, result: Place) -> None:
        result.write_float(function(value))

    return operate


for _name, _calculate in (
    ("MATH.EXP", _defined(math.exp)),
    ("MATH.FLOOR", _whole(math.floor)),
    ("MATH.CEIL", _whole(math.ceil)),
    ("MATH.ROUND", soft_float.round_half_away),
    ("MATH.SQRT", _defined(math.sqrt)),
    ("MATH.LOG", _logarithm(math.log10)),
    ("MATH.LN", _logarithm(math.log)),
    ("MATH.SIN", _of_degrees(math.sin)),
    ("MATH.COS", _of_degrees(math.cos)),
    ("MATH.TAN", _of_degrees(math.tan)),
    ("MATH.ASIN", _in_degrees(math.asin)),
    ("MATH.ACOS", _in_degrees(math.acos)),
    ("MATH.ATAN", _in_degrees(math.atan)),
):
    handles(_name)(_single_argument(_calculate))


@handles("MATH.ABS", raw=True)
def absolute(vm: Machine) -> None:
    """The sign is dropped, that of NaN too."""
    bits = vm.float_bits()
    vm.place().write32(bits & 0x7FFFFFFF)


@handles("MATH.NEGATE", raw=True)
def negate(vm: Machine) -> None:
    """0 - X, so that 0 stays without a sign."""
    bits = vm.float_bits()
    vm.place().write32(soft_float.subtract(0, bits))


@handles("MATH.MOD")
def modulo(_: Machine, dividend: float, divisor: float, result: Place) -> None:
    """The remainder with the sign of the dividend; NaN by zero."""
    try:
        result.write_float(math.fmod(dividend, divisor))
    except ValueError:
        result.write_float(math.nan)


@handles("MATH.POW")
def power(_: Machine, base: float, exponent: float, result: Place) -> None:
    """X to the power of Y."""
    try:
        result.write_float(math.pow(base, exponent))
    except OverflowError:
        is_odd = exponent == int(exponent) and int(exponent) % 2 == 1
        result.write_float(-math.inf if base < 0 and is_odd else math.inf)
    except ValueError:
        # Zero to a negative power, or a negative number to a power that is not whole.
        is_odd = not math.isinf(exponent) and exponent == int(exponent) and int(exponent) % 2 == 1
        result.write_float(math.copysign(math.inf, base if is_odd else 1) if base == 0 else math.nan)


@handles("MATH.TRUNC")
def truncate(_: Machine, value: float, decimals: int, result: Place) -> None:
    """X as text with 6 decimals, cut after so many of them."""
    text = fixed(value, 6)
    point = text.find(".")
    if point >= 0:
        text = text[: point + 1 + min(max(decimals, 0), MOST_DECIMALS)]
    result.write_float(float(text))


def _integer_modulo(kind: Type) -> Callable[[Machine, int, int, Place], None]:
    def remainder(_: Machine, dividend: int, divisor: int, result: Place) -> None:
        # By zero, which kills the real machine, there is nothing left over.
        result.write(kind, dividend - quotient(dividend, divisor) * divisor if divisor else 0)

    return remainder


for _suffix, _kind in _INTEGERS.items():
    # MATH.MOD8, MATH.MOD16, MATH.MOD32
    handles(f"MATH.MOD{_suffix}")(_integer_modulo(_kind))


@handles("RANDOM")
def random_number(vm: Machine, low: int, high: int, value: Place) -> None:
    """One of both ends and what is between; the ends are half as likely as the others."""
    drawn = vm.brick.random.randrange(0x8000)
    value.write16(quotient(drawn * (high - low) + 0x3FFF, 0x7FFF) + low)
