"""Texts and arrays that stand in an operation itself, and how many bytes the operation says that they have."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from ev3proto.messages import Argument
from ev3proto.semantics.footprint import NO_LIMIT, whole_number
from ev3proto.tables.declaration import Direction, Type
from ev3proto.tables.encoding import CONSTANT, TEXT

NUMBER_SIZE = 4
"""Bytes of a number in the operation itself, where the brick reads it as an array."""


class InlineArray(NamedTuple):
    """A text or number that the brick reads as an array.

    argument  the text or number
    length    the parameter that tells how many values it has
    one       bytes of one value
    stated    bytes that it has by that parameter
    present   bytes that it has, the zero of a text included
    """

    argument: Argument
    length: str
    one: int
    stated: int
    present: int


def inline_arrays(arguments: Sequence[Argument]) -> Iterator[InlineArray]:
    """The texts and arrays among an operation's arguments whose length another argument tells."""
    for argument in arguments:
        parameter, form, *_ = argument
        length = parameter.length
        if not isinstance(length, str) or parameter.direction is not Direction.IN:
            continue
        if form.kind not in (CONSTANT, TEXT) or form.handle or form.address:
            continue
        count = whole_number(next((other for other in arguments if other.name == length), None))
        if count is None or (count == NO_LIMIT and parameter.type is Type.STRING):
            continue
        one = max(parameter.type.size, 1)
        # Other negative lengths are those of bytes in reverse order.
        present = argument.length - 1 if form.kind == TEXT else NUMBER_SIZE
        yield InlineArray(argument, length, one, one * abs(count), present)
