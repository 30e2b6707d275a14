"""The bytes of memory that an operation uses: start and size for each argument that is a variable.

`operation_facts` has what follows from its declaration. The arguments add the size of arrays.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import accumulate
from typing import NamedTuple

from ev3proto.messages import Argument, Operation, Variable
from ev3proto.schema.header import MOST_IN_REPLY
from ev3proto.semantics.facts import ParameterFacts, operation_facts
from ev3proto.tables.declaration import Direction, Type
from ev3proto.tables.encoding import CONSTANT, GLOBAL, LOCAL, TEXT
from ev3proto.tables.frame import MAX_LOCALS

MEMORY_LIMITS = {GLOBAL: MOST_IN_REPLY, LOCAL: MAX_LOCALS}
"""Maximum bytes of each memory: more globals do not fit into a reply, more locals cannot be requested."""

NO_LIMIT = -1
"""The length that means "as long as the text is"."""


@dataclass(slots=True)
class Footprint:
    """The memory that an operation uses for one argument that is a variable."""

    operation: Operation
    number: int  # of the argument in the operation, from 0
    argument: Argument  # the variable
    # what follows from the declaration of its parameter: its alignment, whether it is read or written
    facts: ParameterFacts
    start: int  # its first byte
    size: int  # minimum number of bytes
    most: int | None  # maximum number of bytes, None if unknown
    room: int | None  # bytes to reserve when a place is chosen, None if unknown
    is_array: bool  # whether it is or may be more than one value

    @property
    def end(self) -> int:
        """The first byte after the minimum size."""
        return self.start + self.size

    @property
    def reserved(self) -> int:
        """Bytes to reserve when a place is chosen: its maximum size, or else the certain part."""
        return self.size if self.room is None else self.room

    @property
    def is_open(self) -> bool:
        """Whether the operation does not tell its maximum size."""
        return self.most is None

    @property
    def is_exact(self) -> bool:
        """Whether it takes exactly `size` bytes."""
        return self.most == self.size

    @property
    def is_global(self) -> bool:
        """Whether it is in global memory."""
        return self.argument.form.kind == GLOBAL

    @property
    def variable(self) -> Variable:
        """The variable."""
        form = self.argument.form
        return Variable(form.kind, self.start, form.handle, form.address)

    @property
    def full_name(self) -> str:
        """`VALUE of UI_READ.GET_VBATT`."""
        return f"{self.argument.name} of {self.operation.full_name}"


class Taken:
    """The bytes of one memory that some variables take, with a fast test for overlaps.

    A frame may have hundreds of variables, so comparing each with all others is slow.
    """

    def __init__(self, found: Iterable[tuple[int, int]]) -> None:
        """`found`: start and end of each variable."""
        places = sorted(found)
        self._starts = [start for start, _ in places]
        # For each start, the furthest end of those up to it.
        self._ends = list(accumulate([end for _, end in places], max))

    def has_some_of(self, start: int, end: int) -> bool:
        """Returns whether any byte between the two offsets is taken."""
        before = bisect_left(self._starts, end)
        return before > 0 and self._ends[before - 1] > start


def needed(used: Iterable[Footprint]) -> int | None:
    """Returns how many bytes of one memory variables take, None if that is unknown."""
    end = 0
    for place in used:
        if place.most is None:
            return None
        end = max(end, place.start + place.most)
    return end


class Memory(NamedTuple):
    """The memory that a command of some operations has to request.

    Attributes:
        globals: The bytes of global memory.
        locals: The bytes of local memory.
        is_exact: Whether the operations tell the maximum size of all that they use.
    """

    globals: int
    locals: int
    is_exact: bool = True

    @property
    def excess(self) -> str | None:
        """What is wrong with sizes that no command can request or no reply carry, as a sentence; None if all fits."""
        for scope, size in zip((GLOBAL, LOCAL), self, strict=False):
            if size > MEMORY_LIMITS[scope]:
                return f"the operations use {size} bytes of {scope} memory; there are {MEMORY_LIMITS[scope]}"
        return None


NO_MEMORY = Memory(0, 0)


def memory_of(operations: Iterable[Operation]) -> Memory:
    """Returns the memory to request for operations: up to the last byte reserved for one of their variables."""
    sizes, is_exact = {GLOBAL: 0, LOCAL: 0}, True
    for operation in operations:
        for place in footprints(operation):
            scope = place.argument.form.kind
            sizes[scope] = max(sizes[scope], place.start + place.reserved)
            is_exact &= place.most is not None
    return Memory(sizes[GLOBAL], sizes[LOCAL], is_exact)


def unread(used: Sequence[Footprint]) -> Iterator[Footprint]:
    """Yields the results among the variables of one memory that no operation reads."""
    read = Taken((place.start, place.end) for place in used if place.facts.is_read)
    for place in used:
        if place.facts.is_written and place.size and not read.has_some_of(place.start, place.end):
            yield place


def footprints(operation: Operation, arguments: Sequence[Argument] | None = None) -> list[Footprint]:
    """Returns the memory that an operation uses, in the order of its arguments."""
    if arguments is None:
        arguments = operation.arguments
    return [
        footprint(operation, number, arguments) for number, argument in enumerate(arguments) if argument.is_variable
    ]


def results(operation: Operation) -> list[Footprint]:
    """Returns the memory of the arguments whose values a reply carries, in order."""
    return [found for found in footprints(operation) if found.facts.is_result and found.is_global]


def footprint(operation: Operation, number: int, arguments: Sequence[Argument]) -> Footprint:
    """Returns the memory that an operation uses for one argument, which is a variable."""
    argument = arguments[number]
    form, start = argument.form, argument.value
    assert isinstance(start, int)
    known = operation_facts(operation.schema).of(number, argument.parameter)
    if form.handle or form.address:
        known = known.marked(form.handle, form.address)
    size, most, room, is_array = known.size, known.most, known.room, known.is_array
    if known.is_counted:
        count = _count(known, arguments)
        if count is None:
            most = room = None
        else:
            size *= count
            most = None if most is None else most * count
            room = None if room is None else room * count
        is_array = count is None or size > known.size or known.indexed_by is not None
    return Footprint(operation, number, argument, known, start, size, most, room, is_array)


def _count(known: ParameterFacts, arguments: Sequence[Argument]) -> int | None:
    """Returns the number of values of an array that are used; None if unknown."""
    if known.fixed_length is not None:
        return known.fixed_length
    number = known.length if known.length is not None else known.indexed_by
    count = whole_number(arguments[number]) if number is not None and number < len(arguments) else None
    if count is None or (count == NO_LIMIT and known.is_text):
        return None
    if known.length is None:
        # All elements up to the one used.
        return count + 1 if count >= 0 else None
    # Other negative lengths are those of bytes in reverse order.
    return abs(count)


def whole_number(argument: Argument | None) -> int | None:
    """Returns the value of an argument that is a constant whole number, else None."""
    if argument is None or argument.form.kind != CONSTANT or argument.form.handle or argument.form.address:
        return None
    return argument.value if isinstance(argument.value, int) else None


NUMBER_SIZE = 4
"""Bytes of a constant number that the brick reads as an array."""


class InlineArray(NamedTuple):
    """A text or number that the brick reads as an array."""

    argument: Argument  # the text or number
    length: str  # the parameter with the number of values
    one: int  # bytes of one value
    stated: int  # its size by that parameter, in bytes
    present: int  # its actual size, including the zero of a text


def inline_arrays(arguments: Sequence[Argument]) -> Iterator[InlineArray]:
    """Yields the constant texts and arrays of an operation whose length another argument gives."""
    for argument in arguments:
        parameter, form = argument.parameter, argument.form
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
