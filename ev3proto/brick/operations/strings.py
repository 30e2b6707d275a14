"""STRINGS: joining, comparing, cutting texts, and numbers to and from them."""

from __future__ import annotations

import math
from typing import Any

from ev3proto.brick.formatting import fixed, formatted, read_number
from ev3proto.brick.handlers import computes, handles
from ev3proto.brick.locations import NOT_A_NUMBER, Location
from ev3proto.brick.machine import Machine

NO_TEXT = b"(null)"
"""What printf shows for a missing text."""

NEGATIVE_NOT_A_NUMBER = NOT_A_NUMBER | 0x80000000
"""The bits of NaN, read from a text with a minus sign."""

MOST_CHARACTERS = 1023
"""Bytes of the buffer in which the firmware builds a text."""

MOST_DASHES = 4
"""Maximum number of dashes for NaN."""


computes(
    {
        "STRINGS.GET_SIZE": lambda _, text: len(text),
        # 1: equal byte for byte.
        "STRINGS.COMPARE": lambda _, first, second: first == second,
    }
)


@handles("STRINGS.ADD", "STRINGS.DUPLICATE")
def add(vm: Machine, *parameters: Any) -> None:
    """Writes one text, or two, one after the other."""
    *texts, destination = parameters
    vm.write_text(destination, b"".join(texts))


@handles("STRINGS.STRIP")
def strip(vm: Machine, text: bytes, destination: Location) -> None:
    """Removes all blanks; tabs stay. An array gets room for the blanks, too."""
    vm.write_text(destination, text.replace(b" ", b""), len(text) + 1)


@handles("STRINGS.SUB")
def sub(vm: Machine, text: bytes, sought: bytes, destination: Location) -> None:
    """Writes the text after the first occurrence of another; without one, the rest of printf's missing text."""
    at = text.find(sought)
    rest = (NO_TEXT if at < 0 else text[at:][:MOST_CHARACTERS])[len(sought) :]
    vm.write_text(destination, rest, len(text) + 1)


@handles("STRINGS.NUMBER_TO_STRING")
def number_to_string(vm: Machine, value: int, figures: int, destination: Location) -> None:
    """Writes a number padded with zeros, cut to this number of figures."""
    text = formatted(b"%%%s%dd" % (b"0" if figures >= 0 else b"", figures), value)
    if vm.resize(destination, figures + 2):
        destination.write_cut(text, figures + 1)


@handles("STRINGS.VALUE_TO_STRING")
def value_to_string(vm: Machine, value: float, figures: int, decimals: int, destination: Location) -> None:
    """Writes a number without zeros at the end; a negative number of figures aligns left."""
    text = _no_number(figures) if value != value else _number(value, figures, decimals)
    vm.write_text(destination, text.encode(), abs(figures) + 2)


def _number(value: float, figures: int, decimals: int) -> str:
    """Formats a number; zero bytes replace what the firmware removes at the end by overwriting it."""
    text = fixed(value, decimals)
    if figures >= 0:
        text = text.rjust(figures)
    text = text[: abs(figures)]
    if decimals == 0:
        return text
    # The firmware does not check for a point: 100 becomes 1.
    kept = text[:1] + text[1:].rstrip("0")
    if len(kept) > 1:
        kept = kept.removesuffix(".")
    return kept.ljust(len(text), "\0")


def _no_number(figures: int) -> str:
    dashes = "-" * min(abs(figures), MOST_DASHES)
    return dashes.rjust(figures) if figures >= 0 else dashes.ljust(-figures)


@handles("STRINGS.STRING_TO_VALUE", places=("SOURCE1",))
def string_to_value(_: Machine, source: Location, destination: Location) -> None:
    """Reads a number; a comma becomes a point in the source itself. A text without a number gives 0."""
    text = source.read_text().replace(b",", b".")
    source.write_bytes(text)
    number = read_number(text[:MOST_CHARACTERS])
    if number is not None and number != number:
        # Such a number has the sign of the text.
        destination.write32(NEGATIVE_NOT_A_NUMBER if math.copysign(1, number) < 0 else NOT_A_NUMBER)
    else:
        destination.write_float(0.0 if number is None else number)


@handles("STRINGS.VALUE_FORMATTED", "STRINGS.NUMBER_FORMATTED")
def value_formatted(vm: Machine, value: float, pattern: bytes, size: int, destination: Location) -> None:
    """Writes a number in a format of printf, cut to the size with its zero; an array gets what is needed instead."""
    text = formatted(pattern, value, MOST_CHARACTERS).partition(b"\0")[0]
    if destination.handle >= 0 or size < 0:
        vm.write_text(destination, text)
    elif size > 0:
        destination.write_text(text[: size - 1])
