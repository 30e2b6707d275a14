"""What the rules want to know of an operation, worked out from the tables once and for all frames."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

from ev3proto.schema.operation import OperationSchema
from ev3proto.tables.branch import OFFSET
from ev3proto.tables.declaration import Declaration, Direction, Enumeration, Parameter, Type
from ev3proto.tables.encoding import RANGES
from ev3proto.tables.move import INDEX

_LISTS = (Type.COUNT, Type.VALUES)


class Meaning(NamedTuple):
    """The numbers that the tables provide for.

    spans    pairs of lowest and highest
    singles  single ones beside them
    mask     bits that may be set in any combination, 0 where they may not
    told     what is right, for a sentence
    by_name  whether the numbers have names
    """

    spans: tuple[tuple[int, int], ...]
    singles: frozenset[int]
    mask: int
    told: str
    by_name: bool

    def covers(self, value: int) -> bool:
        """Whether it may be that number."""
        if value in self.singles or any(low <= value <= high for low, high in self.spans):
            return True
        return bool(self.mask) and not value & ~self.mask


class Expected(NamedTuple):
    """What is expected of the argument for a parameter.

    parameter   the parameter
    numbers     whole numbers about which there is nothing to say; there may be more
    meaning     the numbers that the tables provide for, None where its type alone limits it
    size        bytes that a variable takes, of an array its first element
    is_open     it may take more, and nobody can tell from the frame
    is_array    it is, or may be, more than one value
    is_sized    another argument tells how many elements there are
    is_element  it is the array of READ8, WRITE8 and their kind, of which one element is meant
    is_written  the operation writes a variable
    is_read     the operation reads a variable
    is_checked  the validator looks where a variable lies
    noticed     what it wants an index to be a multiple of
    wanted      what the processor wants it to be a multiple of
    """

    parameter: Parameter
    numbers: range | frozenset[int]
    meaning: Meaning | None
    size: int
    is_open: bool
    is_array: bool
    is_sized: bool
    is_element: bool
    is_written: bool
    is_read: bool
    is_checked: bool
    noticed: int
    wanted: int


class Traits(NamedTuple):
    """What is known of an operation beside its arguments.

    declaration  what the tables say of it
    name         `SOUND.TONE`
    expected     of each argument in front of a list
    has_cmd      its opcode has CMDs
    is_jump      its last argument says where to
    """

    declaration: Declaration
    name: str
    expected: tuple[Expected, ...]
    has_cmd: bool
    is_jump: bool


@cache
def traits_of(schema: OperationSchema) -> Traits:
    """The traits of an operation."""
    declaration = schema.declaration
    parameters = declaration.parameters
    array = _array_of(declaration)
    fixed = parameters[:-1] if parameters and parameters[-1].type is Type.VALUES else parameters
    return Traits(
        declaration,
        declaration.name,
        tuple(
            _expected(
                parameter,
                is_element=parameter is array,
                is_filled=parameter is array and parameter is parameters[-1],
                is_checked=parameter.type not in _LISTS,
            )
            for parameter in fixed
        ),
        declaration.command is not None,
        bool(parameters) and parameters[-1] is OFFSET,
    )


@cache
def expected_of_element(parameter: Parameter) -> Expected:
    """What is expected of an element of a list. The validator does not look where it lies."""
    return _expected(parameter, is_element=False, is_filled=False, is_checked=False)


def _array_of(declaration: Declaration) -> Parameter | None:
    """The array of READ8, WRITE8 and their kind, of which one element is read or written."""
    parameters = declaration.parameters
    if not any(parameter is INDEX for parameter in parameters):
        return None
    return parameters[0] if parameters[-1].is_output else parameters[-1]


def _expected(parameter: Parameter, *, is_element: bool, is_filled: bool, is_checked: bool) -> Expected:
    """What is expected of the argument for a parameter.

    is_element  it is the array of READ8, WRITE8 and their kind
    is_filled   it is that of WRITE8, of which an element is written
    is_checked  the validator looks where a variable lies
    """
    kind, direction = parameter.type, parameter.direction
    is_written = is_filled or direction is not Direction.IN
    is_read = not is_filled and direction is not Direction.OUT
    is_vague = not kind.size and kind is not Type.COUNT
    is_sized = parameter.length is not None or is_element
    wanted = 1 if kind is Type.LABEL else max(kind.size, 1)
    checked = parameter.validated or kind
    noticed = 1 if not is_checked or (checked is Type.LABEL and parameter is not OFFSET) else max(checked.size, 1)
    meaning = _meaning(parameter)
    return Expected(
        parameter,
        _numbers(parameter, meaning),
        meaning,
        max(kind.size, 1),
        is_vague,
        is_vague or is_sized,
        is_sized,
        is_element,
        is_written,
        is_read,
        is_checked,
        noticed,
        wanted,
    )


def _numbers(parameter: Parameter, meaning: Meaning | None) -> range | frozenset[int]:
    if parameter.direction is not Direction.IN or parameter.type in (Type.STRING, Type.DATAF, Type.LABEL):
        return frozenset()
    limits = RANGES.get(parameter.validated or parameter.type)
    if limits is None:
        return frozenset()
    whole = range(limits.low, limits.high + 1)
    if meaning is None:
        return whole
    if meaning.spans:
        low, high = meaning.spans[0]
        return range(max(low, limits.low), min(high, limits.high) + 1)
    return frozenset(number for number in meaning.singles if number in whole)


def _meaning(parameter: Parameter) -> Meaning | None:
    singles = frozenset(parameter.special)
    if parameter.range is not None:
        low, high = parameter.range
        beside = [f"{value} ({text})" for value, text in parameter.special.items() if not low <= value <= high]
        unit = f" {parameter.unit}" if parameter.unit else ""
        return Meaning(((low, high),), singles, 0, " or ".join((f"{low} to {high}{unit}", *beside)), False)
    if parameter.enum is None:
        return None
    members = parameter.enum.members
    mask = sum(members.values()) if parameter.enum.flags else 0
    return Meaning(_spans(parameter.enum), singles | frozenset(members.values()), mask, _names(parameter.enum), True)


def _spans(enum: Enumeration) -> tuple[tuple[int, int], ...]:
    """Numbers between two members that name both ends of a span: TYPE_THIRD_PARTY_START and ..._END."""
    members = enum.members
    ends = {name: members.get(f"{name.removesuffix('_START')}_END") for name in members if name.endswith("_START")}
    return tuple((members[name], end) for name, end in ends.items() if end is not None)


_MOST_NAMES = 8


def _names(enum: Enumeration) -> str:
    told = [f"{number} {name}" for name, number in enum.members.items()]
    return ", ".join(told[:_MOST_NAMES]) + (", ..." if len(told) > _MOST_NAMES else "")
