"""The bytes of memory that an operation uses: start and size for each argument that is a variable.

The facts of the tables are computed once for each operation (`memory_facts`). What the arguments add, such
as the size of an array, is computed for each operation in a frame (`footprints`).
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import accumulate
from typing import NamedTuple

from ev3proto.messages import Argument, Operation, OperationReader, Variable
from ev3proto.tables.declaration import LISTS, Direction, Parameter, Role, Type
from ev3proto.tables.encoding import CONSTANT, GLOBAL, TEXT

UNTYPED_SIZE = 4
"""Bytes of the largest number, reserved for a value whose type only the brick knows."""

NO_LIMIT = -1
"""The length that means "as long as the text is"."""


class MemoryFacts(NamedTuple):
    """The facts of the tables about a variable for a parameter.

    size                 bytes of one value, 1 if the type does not tell
    most                 maximum bytes of one value, None if unknown
    room                 bytes to reserve for one value when a place is chosen, None if unknown
    fixed_length         number of values, if fixed in the tables
    length               index of the argument with the number of values, or None
    indexed_by           index of the argument with the index of the element used, or None
    is_counted           whether the operation gives the number of values or bytes
    is_array             whether it is or may be more than one value
    is_read              whether the operation reads it
    is_written           whether the operation writes it
    is_result            whether a reply carries it under the parameter's name
    is_text              whether the values are the bytes of a text
    is_validated         whether the validator checks its alignment
    validator_alignment  alignment required by the validator: 1, 2 or 4
    cpu_alignment        alignment required by the processor: 1, 2 or 4
    alignment            alignment when a place is chosen: 1, 2 or 4
    """

    size: int
    most: int | None
    room: int | None
    fixed_length: int | None
    length: int | None
    indexed_by: int | None
    is_counted: bool
    is_array: bool
    is_read: bool
    is_written: bool
    is_result: bool
    is_text: bool
    is_validated: bool
    validator_alignment: int
    cpu_alignment: int
    alignment: int


@dataclass(slots=True)
class Footprint:
    """The memory that an operation uses for one argument that is a variable.

    operation            the operation
    number               of the argument in the operation, from 0
    argument             the variable
    start                its first byte
    size                 minimum number of bytes
    most                 maximum number of bytes, None if unknown
    room                 bytes to reserve when a place is chosen, None if unknown
    is_array             whether it is or may be more than one value
    is_read              whether the operation reads it
    is_written           whether the operation writes it
    is_result            whether a reply carries it under the parameter's name
    validator_alignment  alignment required by the validator: 1, 2 or 4
    cpu_alignment        alignment required by the processor: 1, 2 or 4
    alignment            alignment when a place is chosen: 1, 2 or 4
    """

    operation: Operation
    number: int
    argument: Argument
    start: int
    size: int
    most: int | None
    room: int | None
    is_array: bool
    is_read: bool
    is_written: bool
    is_result: bool
    validator_alignment: int
    cpu_alignment: int
    alignment: int

    @property
    def end(self) -> int:
        """The first byte after the minimum size."""
        return self.start + self.size

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
    """Returns how many bytes of one memory variables take, None where that is not known."""
    end = 0
    for place in used:
        if place.most is None:
            return None
        end = max(end, place.start + place.most)
    return end


def unread(used: Sequence[Footprint]) -> Iterator[Footprint]:
    """Yields the results among the variables of one memory that no operation reads."""
    read = Taken((place.start, place.end) for place in used if place.is_read)
    for place in used:
        if place.is_written and place.size and not read.has_some_of(place.start, place.end):
            yield place


def footprints(operation: Operation, arguments: Sequence[Argument] | None = None) -> list[Footprint]:
    """Returns the memory that an operation uses, in the order of its arguments.

    Args:
        operation: The operation, whole or cut off.
        arguments: Its arguments, if the caller has already read them.
    """
    if arguments is None:
        arguments = operation.arguments
    return [
        footprint(operation, number, arguments) for number, argument in enumerate(arguments) if argument.is_variable
    ]


def results(operation: Operation) -> list[Footprint]:
    """Returns the memory of the arguments whose values a reply carries, in order."""
    return [found for found in footprints(operation) if found.is_result and found.is_global]


def footprint(operation: Operation, number: int, arguments: Sequence[Argument]) -> Footprint:
    """Returns the memory that an operation uses for one argument, which is a variable.

    Args:
        operation: The operation, whole or cut off.
        number: The number of the argument, from 0.
        arguments: All arguments of the operation.
    """
    facts = memory_facts(operation.schema)
    argument = arguments[number]
    known = facts[number] if number < len(facts) else element_facts(argument.parameter)
    _, form, start, *_ = argument
    assert isinstance(start, int)
    if form.handle or form.address:
        return _marked(operation, number, argument, known)
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
    return Footprint(
        operation,
        number,
        argument,
        start,
        size,
        most,
        room,
        is_array,
        known.is_read,
        known.is_written,
        known.is_result,
        known.validator_alignment,
        known.cpu_alignment,
        known.alignment,
    )


def _marked(operation: Operation, number: int, argument: Argument, known: MemoryFacts) -> Footprint:
    """Returns the memory of a variable that holds a handle or an address."""
    form = argument.form
    size = Type.HANDLE.size if form.handle else Type.DATA32.size
    validator_alignment = size if form.handle and known.is_validated else known.validator_alignment
    return Footprint(
        operation,
        number,
        argument,
        int(argument.value),
        size,
        most=size,
        room=size,
        is_array=False,
        is_read=True,
        is_written=False,
        is_result=known.is_result and not form.address,
        validator_alignment=validator_alignment,
        cpu_alignment=size,
        alignment=max(validator_alignment, size),
    )


def _count(known: MemoryFacts, arguments: Sequence[Argument]) -> int | None:
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


@cache
def memory_facts(schema: OperationReader) -> tuple[MemoryFacts, ...]:
    """Returns the memory facts of an operation: one entry for each argument before the elements of a list."""
    parameters = schema.declaration.parameters
    numbers = {parameter.name: number for number, parameter in enumerate(parameters)}
    fixed = parameters[:-1] if parameters and parameters[-1].type is Type.VALUES else parameters
    return tuple(
        _facts(parameter, numbers, is_validated=parameter.type not in LISTS, is_element=False) for parameter in fixed
    )


def element_facts(parameter: Parameter) -> MemoryFacts:
    """Returns the memory facts of an element of a list. The validator does not check its alignment."""
    return _element_facts(parameter.type, parameter.direction)


@cache
def _element_facts(kind: Type, direction: Direction) -> MemoryFacts:
    return _facts(Parameter("", kind, "", direction), {}, is_validated=False, is_element=True)


def _facts(parameter: Parameter, numbers: dict[str, int], *, is_validated: bool, is_element: bool) -> MemoryFacts:
    kind, direction = parameter.type, parameter.direction
    is_text, is_untyped = kind is Type.STRING, kind is Type.ARRAY_TYPED
    is_counted = parameter.length is not None or parameter.indexed_by is not None
    size = max(kind.size, 1)
    most: int | None = size
    room: int | None = UNTYPED_SIZE if is_untyped else size
    if is_text and parameter.length is None:
        most = room = None
    elif is_untyped:
        # The elements of a mailbox may be texts, those of an array are numbers.
        most = None if is_element else UNTYPED_SIZE
    is_seen = is_validated and parameter.role is not Role.LABEL
    validator_alignment = max((parameter.validated or kind).size, 1) if is_seen else 1
    cpu_alignment = 1 if kind is Type.LABEL else size
    return MemoryFacts(
        size,
        most,
        room,
        fixed_length=parameter.length if isinstance(parameter.length, int) else None,
        length=numbers.get(parameter.length) if isinstance(parameter.length, str) else None,
        indexed_by=None if parameter.indexed_by is None else numbers.get(parameter.indexed_by),
        is_counted=is_counted,
        is_array=is_text or is_untyped or is_counted,
        is_read=not parameter.stores and direction is not Direction.OUT,
        is_written=parameter.stores or direction is not Direction.IN,
        is_result=direction is not Direction.IN,
        is_text=is_text,
        is_validated=is_validated,
        validator_alignment=validator_alignment,
        cpu_alignment=cpu_alignment,
        alignment=max(validator_alignment, cpu_alignment, UNTYPED_SIZE if is_untyped else 1),
    )


NUMBER_SIZE = 4
"""Bytes of a constant number that the brick reads as an array."""


class InlineArray(NamedTuple):
    """A text or number that the brick reads as an array.

    argument  the text or number
    length    the parameter with the number of values
    one       bytes of one value
    stated    its size by that parameter, in bytes
    present   its actual size, including the zero of a text
    """

    argument: Argument
    length: str
    one: int
    stated: int
    present: int


def inline_arrays(arguments: Sequence[Argument]) -> Iterator[InlineArray]:
    """Yields the constant texts and arrays of an operation whose length another argument gives."""
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
