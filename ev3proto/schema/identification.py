"""The identification byte: the first byte of every argument, which tells its kind, its width and often its value.

The bits are declared once, as a Construct. There are only 256 such bytes, so the declared forms are run over all their
bits when this module is imported, and decoding an argument is looking up what was found then.
"""

from __future__ import annotations

from itertools import product
from typing import Any

from construct import Array, BitsInteger, BitStruct, Bitwise, Const, Construct, Flag, IfThenElse, Struct, this
from construct.lib import integer2bits

from ev3proto.tables.encoding import (
    CONSTANT,
    GLOBAL,
    JUMP,
    LOCAL,
    STRING_OLD,
    STRING_ZERO,
    TEXT,
    WIDTHS,
    Encoding,
)

_FORM_BITS = 6
"""The bits after the first two, which select what these stand for."""

LONG_FORM = Struct(
    "selector" / Flag,  # of variables: global; of constants: label
    "handle" / Flag,
    "address" / Flag,
    "width" / BitsInteger(3),
)
"""Bits 5 to 0 where the value stands in the bytes that follow."""

SHORT_CONSTANT = Struct("value" / BitsInteger(_FORM_BITS, signed=True))
SHORT_VARIABLE = Struct("is_global" / Flag, "value" / BitsInteger(5))

_BITS = Struct(
    "is_long" / Flag,
    "is_variable" / Flag,
    "form" / IfThenElse(this.is_long, LONG_FORM, IfThenElse(this.is_variable, SHORT_VARIABLE, SHORT_CONSTANT)),
)
"""All of it: bit 7 long, bit 6 variable, then what the two select."""

IDENTIFICATION = Bitwise(_BITS)
"""The byte as it stands in a frame."""

LABEL_BYTE = BitStruct(Const(True, Flag), Const(False, Flag), Const(True, Flag), Const(0, BitsInteger(5))).build(None)[
    0
]
"""The identification byte of a label (LAB1)."""


def _long_encoding(is_variable: bool, selector: bool, handle: bool, address: bool, width: int) -> Encoding | None:
    if is_variable:
        if width not in WIDTHS:
            return None
        scope, letter = (GLOBAL, "G") if selector else (LOCAL, "L")
        return Encoding(f"{letter}V{WIDTHS[width]}", scope, WIDTHS[width], handle, address)
    if selector:
        # The firmware looks at no further bit of a label's identification byte.
        return Encoding("LAB1", JUMP, 1, handle, address)
    if width in (STRING_OLD, STRING_ZERO):
        return Encoding("LCS" if width == STRING_ZERO else "LCS_OLD", TEXT, None, handle, address)
    if width not in WIDTHS:
        return None
    return Encoding(f"LC{WIDTHS[width]}", CONSTANT, WIDTHS[width], handle, address)


_SHORT_CONSTANT = Encoding("LC0", CONSTANT, 0)
_SHORT_VARIABLE = {False: Encoding("LV0", LOCAL, 0), True: Encoding("GV0", GLOBAL, 0)}


def _readings(form: Construct) -> list[tuple[Any, ...]]:
    """The values of a form's fields, for all that its bits can be, in order.

    Each field is run over its own bits: the whole byte 256 times takes ten times as long, at each import.
    """
    fields = []
    for field in form.subcons:
        size = field.sizeof()
        bits = b"".join(integer2bits(number, size) for number in range(1 << size))
        fields.append(Array(1 << size, field).parse(bits))
    return list(product(*fields))


def _survey() -> tuple[tuple[Encoding | None, ...], tuple[int | None, ...]]:
    constants, variables, longs = map(_readings, (SHORT_CONSTANT, SHORT_VARIABLE, LONG_FORM))
    # Bytes with neither of the first two bits come first, then those with the second, the first, and both.
    encodings = (
        *(_SHORT_CONSTANT for _ in constants),
        *(_SHORT_VARIABLE[is_global] for is_global, _ in variables),
        *(_long_encoding(False, *fields) for fields in longs),
        *(_long_encoding(True, *fields) for fields in longs),
    )
    values = (*(value for *_, value in (*constants, *variables)), *[None] * (2 * len(longs)))
    return encodings, values


ENCODINGS, SHORT_VALUES = _survey()
"""For each of the 256 bytes: its encoding (None where the firmware defines none); for short forms, the value in it."""
