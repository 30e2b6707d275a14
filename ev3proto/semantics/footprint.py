"""Which bytes of memory an operation uses: for each argument that is a variable, where they start and how many.

What the tables tell of a parameter is worked out once for each operation (`memory_facts`). What its arguments add, such
as the number of bytes in an array, is worked out for each operation in a frame (`footprints`).
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
"""Bytes of the largest number: what to set aside for a value whose type only the brick knows."""

NO_LIMIT = -1
"""The length of a text that stands for as much as there is."""


class MemoryFacts(NamedTuple):
    """What the tables tell of a variable that stands for a parameter.

    size                 bytes of one value, 1 where the type does not tell
    most                 bytes of one value at most, None where that is not known
    room                 bytes to set aside for one value where a place is chosen, None where that is not known
    fixed_length         how many values there are, where the tables tell
    length               number of the argument that tells how many values there are, None where none does
    indexed_by           number of the argument that tells which element of an array is used, None where none does
    is_counted           the operation tells how many values or bytes it has
    is_array             it is more than one value, or may be
    is_read              the operation reads it
    is_written           the operation writes it
    is_result            a reply carries it under the parameter's name
    is_text              the values are the bytes of a text
    is_validated         the validator looks at where it lies
    validator_alignment  what the validator wants its index to be a multiple of: 1, 2 or 4
    cpu_alignment        what the processor wants its index to be a multiple of: 1, 2 or 4
    alignment            what to align it to where a place is chosen: 1, 2 or 4
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
    """The memory that an operation uses by one argument that is a variable.

    operation            the operation
    number               of the argument in the operation, from 0
    argument             the variable
    start                its first byte
    size                 bytes that it takes for sure
    most                 bytes that it takes at most, None where that is not known
    room                 bytes to set aside where a place is chosen, None where that is not known
    is_array             it is more than one value, or may be
    is_read              the operation reads it
    is_written           the operation writes it
    is_result            a reply carries it under the parameter's name
    validator_alignment  what the validator wants `start` to be a multiple of: 1, 2 or 4
    cpu_alignment        what the processor wants `start` to be a multiple of: 1, 2 or 4
    alignment            what to align it to where a place is chosen: 1, 2 or 4
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
        """The first byte after those that it takes for sure."""
        return self.start + self.size

    @property
    def is_open(self) -> bool:
        """True where that is not known from the operation how many bytes it takes."""
        return self.most is None

    @property
    def is_exact(self) -> bool:
        """True where it takes neither more nor fewer bytes than `size`."""
        return self.most == self.size

    @property
    def is_global(self) -> bool:
        """True for global memory, False for local."""
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
    """The bytes that some variables of one memory take. It tells at once whether another one has any of them.

    A frame may have hundreds of variables, so to ask each of them for each other one takes long.
    """

    def __init__(self, found: Iterable[tuple[int, int]]) -> None:
        """`found`: where each of them starts and ends."""
        places = sorted(found)
        self._starts = [start for start, _ in places]
        # For each place, where the furthest of those up to it ends.
        self._ends = list(accumulate([end for _, end in places], max))

    def has_some_of(self, start: int, end: int) -> bool:
        """Whether there is a byte between these two that is taken."""
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
    """The memory that an operation uses, in the order of its arguments.

    Args:
        operation: The operation, whole or cut off.
        arguments: Its arguments, where the caller has read them already.
    """
    if arguments is None:
        arguments = operation.arguments
    return [
        footprint(operation, number, arguments) for number, argument in enumerate(arguments) if argument.is_variable
    ]


def results(operation: Operation) -> list[Footprint]:
    """The memory of those arguments alone whose values a reply carries, in their order."""
    return [found for found in footprints(operation) if found.is_result and found.is_global]


def footprint(operation: Operation, number: int, arguments: Sequence[Argument]) -> Footprint:
    """The memory that an operation uses by one argument, which is a variable.

    Args:
        operation: The operation, whole or cut off.
        number: That of the argument, from 0.
        arguments: All arguments of the operation.
    """
    schema, *_ = operation
    facts = memory_facts(schema)
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
    """The memory of a variable that only says where the value is: by a handle or an address."""
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
    """How many values an array has, as far as they are used; None where that is not known."""
    if known.fixed_length is not None:
        return known.fixed_length
    number = known.length if known.length is not None else known.indexed_by
    count = whole_number(arguments[number]) if number is not None and number < len(arguments) else None
    if count is None or (count == NO_LIMIT and known.is_text):
        return None
    if known.length is None:
        # All elements up to the one that is used.
        return count + 1 if count >= 0 else None
    # Other negative lengths are those of bytes in reverse order.
    return abs(count)


def whole_number(argument: Argument | None) -> int | None:
    """The value of an argument that is a whole number in the frame itself, None for all others."""
    if argument is None or argument.form.kind != CONSTANT or argument.form.handle or argument.form.address:
        return None
    return argument.value if isinstance(argument.value, int) else None


@cache
def memory_facts(schema: OperationReader) -> tuple[MemoryFacts, ...]:
    """What the tables tell of the memory of an operation: one entry for each argument before the elements of a list."""
    parameters = schema.declaration.parameters
    numbers = {parameter.name: number for number, parameter in enumerate(parameters)}
    fixed = parameters[:-1] if parameters and parameters[-1].type is Type.VALUES else parameters
    return tuple(
        _facts(parameter, numbers, is_validated=parameter.type not in LISTS, is_element=False) for parameter in fixed
    )


def element_facts(parameter: Parameter) -> MemoryFacts:
    """The same for an element of a list. The validator does not look at where it lies."""
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
