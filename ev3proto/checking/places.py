"""Where operations read and write memory: for each argument that is a variable, which bytes it takes."""

from __future__ import annotations

from typing import NamedTuple

from ev3proto.checking.subject import Step
from ev3proto.checking.traits import Expected, expected_of_element
from ev3proto.messages import Argument
from ev3proto.tables.declaration import Type
from ev3proto.tables.encoding import CONSTANT, GLOBAL, LOCAL
from ev3proto.tables.move import INDEX


class Place(NamedTuple):
    """The bytes of one variable.

    step        the operation
    argument    the variable
    start       its first byte
    end         the byte behind the last that it takes for sure
    is_open     it may take more: nobody can tell from the frame
    is_array    it is more than one value, or may be
    is_written  the operation writes it
    is_read     the operation reads it
    noticed     what the validator wants its index to be a multiple of
    wanted      what the processor wants its index to be a multiple of
    """

    step: Step
    argument: Argument
    start: int
    end: int
    is_open: bool
    is_array: bool
    is_written: bool
    is_read: bool
    noticed: int
    wanted: int

    @property
    def is_global(self) -> bool:
        """Global memory or local."""
        return self.argument.form.kind == GLOBAL


def places_of(steps: tuple[Step, ...]) -> list[Place]:
    """The variables of all operations, in their order."""
    found: list[Place] = []
    for step in steps:
        expected = step.traits.expected
        for number, argument in enumerate(step.arguments):
            form = argument.form
            if form.kind == LOCAL or form.kind == GLOBAL:
                known = expected[number] if number < len(expected) else expected_of_element(argument.parameter)
                found.append(_place(step, argument, known))
    return found


def _place(step: Step, argument: Argument, known: Expected) -> Place:
    form, start = argument.form, int(argument.value)
    if form.handle or form.address:
        # The variable only says where the value is.
        kind = Type.HANDLE if form.handle else Type.DATA32
        noticed = kind.size if form.handle and known.is_checked else known.noticed
        return Place(step, argument, start, start + kind.size, False, False, False, True, noticed, kind.size)
    size, is_open, is_array = known.size, known.is_open, known.is_array
    if known.is_sized:
        size, is_open = _extent(step, argument, size)
        is_array = is_open or size > known.size or known.is_element
    return Place(
        step,
        argument,
        start,
        start + size,
        is_open,
        is_array,
        known.is_written,
        known.is_read,
        known.noticed,
        known.wanted,
    )


def _extent(step: Step, argument: Argument, one: int) -> tuple[int, bool]:
    """Bytes that an array takes, and whether it may be more."""
    length = argument.parameter.length
    if isinstance(length, int):
        return one * length, False
    if length is None:
        # READ8, WRITE8 and their kind: all elements up to the one at INDEX.
        index = number_of(next((other for other in step.arguments if other.parameter is INDEX), None))
        return (one, True) if index is None or index < 0 else (one * (index + 1), False)
    count = number_of(next((other for other in step.arguments if other.name == length), None))
    # -1 stands for no limit; other negative lengths are those of bytes in reverse order.
    return (one, True) if count is None or count == -1 else (one * abs(count), False)


def number_of(argument: Argument | None) -> int | None:
    """The value of an argument that is a whole number, None for all others."""
    if argument is None or argument.form.kind != CONSTANT or argument.form.handle or argument.form.address:
        return None
    return argument.value if isinstance(argument.value, int) else None
