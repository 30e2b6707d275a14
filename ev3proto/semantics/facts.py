"""What follows from the declaration of an operation and of its parameters, derived once: `operation_facts`.

The checker, the verdict, the drafts of operations, and everything about memory read it here.
"""

from __future__ import annotations

from collections.abc import Mapping
from copy import copy
from functools import cache, cached_property
from typing import Any, NamedTuple

from ev3proto.messages import OperationReader
from ev3proto.semantics.domain import Domain, domain_of
from ev3proto.tables.declaration import Direction, Effect, Parameter, Role, Type
from ev3proto.tables.encoding import RANGES, limits_of
from ev3proto.tables.validation import LABELS

UNTYPED_SIZE = 4
"""Bytes of the largest number, reserved for a value whose type only the brick knows."""


class Requirement(NamedTuple):
    """The validator's requirements on an argument."""

    kind: Type  # the type that it expects
    numbers: range | None = None  # the constants that it accepts, None for any
    alignment: int = 1  # the index of a variable is a multiple of this: 1, 2 or 4
    handle_alignment: int = Type.HANDLE.size  # the same if the variable holds a handle


def _whole(kind: Type) -> range:
    return range(RANGES[kind].low, RANGES[kind].high + 1)


_REQUIREMENTS = {
    Type.DATA8: Requirement(Type.DATA8, _whole(Type.DATA8)),
    # It checks the first character of a text.
    Type.STRING: Requirement(Type.DATA8, _whole(Type.DATA8)),
    Type.DATA16: Requirement(Type.DATA16, _whole(Type.DATA16), alignment=2),
    Type.HANDLE: Requirement(Type.HANDLE, _whole(Type.HANDLE), alignment=2),
    Type.DATA32: Requirement(Type.DATA32, _whole(Type.DATA32), alignment=4),
    Type.DATAF: Requirement(Type.DATAF, alignment=4),
    Type.ARRAY_TYPED: Requirement(Type.ARRAY_TYPED),
    Type.LABEL: Requirement(Type.LABEL, range(LABELS)),
}
_NOT_VALIDATED = Requirement(Type.DATA8, handle_alignment=1)
"""The count of a list that has its own, and the elements of any list, are not checked."""


def requirement(parameter: Parameter) -> Requirement:
    """Returns the validator's requirements on the argument of a parameter."""
    if parameter.counts:
        return _NOT_VALIDATED
    # A jump distance is a number; only LABEL has a label.
    return _REQUIREMENTS[Type.DATA32 if parameter.role is Role.JUMP else parameter.validated or parameter.type]


def _rooms(parameter: Parameter, *, is_element: bool) -> tuple[int | None, int | None]:
    """Returns the maximum bytes of one value, and those to reserve for it; None if unknown."""
    if parameter.type is Type.ARRAY_TYPED:
        # The elements of a mailbox may be texts, those of an array are numbers.
        return None if is_element else UNTYPED_SIZE, UNTYPED_SIZE
    size = None if parameter.type is Type.STRING and parameter.length is None else max(parameter.type.size, 1)
    return size, size


_LIMITS = {kind: RANGES[kind] for kind in (Type.DATA8, Type.DATA16, Type.DATA32, Type.HANDLE)}


class ParameterFacts:
    """What follows from the declaration of one parameter of an operation, or of an element of its list.

    Attributes:
        parameter: The declaration.
        is_first: Whether the validator decides by it: the first argument of an operation without CMD.
        limits: The numbers that its bytes can hold, None if it is not a number of fixed size.
        validated: The validator's requirements.
        size: Bytes of one value in memory, 1 if the type does not tell.
        most: Maximum bytes of one value, None if unknown.
        room: Bytes to reserve for one value when a place is chosen, None if unknown.
        fixed_length: Number of values, if fixed in the tables.
        length: Index of the argument with the number of values, or None.
        indexed_by: Index of the argument with the index of the element used, or None.
        is_counted: Whether the operation gives the number of values or bytes.
        is_array: Whether it is or may be more than one value.
        is_read: Whether the operation reads it.
        is_written: Whether the operation writes it.
        is_result: Whether a reply carries it under the parameter's name.
        is_text: Whether the values are the bytes of a text.
        validator_alignment: Alignment of a variable required by the validator: 1, 2 or 4.
        cpu_alignment: Alignment required by the processor: 1, 2 or 4.
        alignment: Alignment when a place is chosen: 1, 2 or 4.
    """

    def __init__(
        self, parameter: Parameter, indexes: Mapping[Any, int], *, is_first: bool = False, is_element: bool = False
    ) -> None:
        kind, direction, length = parameter.type, parameter.direction, parameter.length
        is_untyped = kind is Type.ARRAY_TYPED
        self.parameter = parameter
        self.is_first = is_first
        self.limits = None if parameter.counts else _LIMITS.get(kind)
        self.validated = _NOT_VALIDATED if is_element else requirement(parameter)
        self.is_text = kind is Type.STRING
        self.size = max(kind.size, 1)
        self.most, self.room = _rooms(parameter, is_element=is_element)
        self.fixed_length = length if isinstance(length, int) else None
        self.length, self.indexed_by = indexes.get(length), indexes.get(parameter.indexed_by)
        self.is_counted = length is not None or parameter.indexed_by is not None
        self.is_array = self.is_text or is_untyped or self.is_counted
        self.is_read = not parameter.stores and direction is not Direction.OUT
        self.is_written = parameter.stores or direction is not Direction.IN
        self.is_result = direction is not Direction.IN
        self.validator_alignment = self.validated.alignment
        self.cpu_alignment = 1 if kind is Type.LABEL else self.size
        self.alignment = max(self.validator_alignment, self.cpu_alignment, UNTYPED_SIZE * is_untyped)
        self._marked: dict[tuple[bool, bool], ParameterFacts] = {}

    def marked(self, handle: bool, address: bool) -> ParameterFacts:
        """Returns the facts of a variable that holds a handle or an address instead of the value."""
        found = self._marked.get((handle, address))
        if found is None:
            found = self._marked[handle, address] = copy(self)
            found.size = found.most = found.room = found.cpu_alignment = (Type.HANDLE if handle else Type.DATA32).size
            if handle:
                found.validator_alignment = self.validated.handle_alignment
            found.alignment = max(found.validator_alignment, found.cpu_alignment)
            found.is_counted = found.is_array = found.is_written = False
            found.is_read = True
            found.is_result = self.is_result and not address
        return found

    @cached_property
    def domain(self) -> Domain | None:
        """The legal numbers of the tables, None if only the type limits them."""
        domain = domain_of(self.parameter)
        return domain if domain is not None and domain.is_documented else None

    @cached_property
    def legal(self) -> range | frozenset[int]:
        """Whole numbers that are legal constants; not necessarily all of them."""
        parameter = self.parameter
        if parameter.direction is not Direction.IN or parameter.type in (Type.STRING, Type.DATAF, Type.LABEL):
            return frozenset()
        limits = RANGES[parameter.validated] if parameter.validated else limits_of(parameter)
        if limits is None:
            return frozenset()
        if self.domain is None:
            return range(limits.low, limits.high + 1)
        if self.domain.spans:
            low, high = self.domain.spans[0]
            return range(max(low, limits.low), min(high, limits.high) + 1)
        return frozenset(number for number in self.domain.singles if limits.low <= number <= limits.high)


@cache
def facts_of(parameter: Parameter) -> ParameterFacts:
    """Returns the facts about a parameter without its operation."""
    return ParameterFacts(parameter, {})


class OperationFacts:
    """What follows from the declaration of one operation.

    Attributes:
        declaration: Its entry in the tables.
        name: `SOUND.TONE`.
        parameters: The facts of each argument before the elements of a list.
        effects: Its side effects.
        is_jump: Whether its last argument is a jump target.
        has_lists: Whether it takes texts or arrays with a known or limited length.
        ends_code: Whether the firmware reads nothing after it.
        has_handles: Whether it makes or uses handles of files or arrays.
        has_letters: Whether the firmware refuses some characters of a text, or adds a suffix.
    """

    def __init__(self, schema: OperationReader) -> None:
        declaration = schema.declaration
        parameters = declaration.fixed
        indexes = {parameter.name: number for number, parameter in enumerate(parameters)}
        self.declaration = declaration
        self.name = declaration.name
        first = None if declaration.command is not None else 0
        self.parameters = tuple(
            [ParameterFacts(one, indexes, is_first=number == first) for number, one in enumerate(parameters)]
        )
        self.effects = frozenset(declaration.effects)
        self.is_jump = declaration.is_jump
        self.has_lists = any(each.length is not None or each.most is not None for each in parameters)
        self.has_handles = any(each.role in (Role.FILE, Role.ARRAY) for each in parameters)
        self.has_letters = any(each.letters or each.suffix for each in parameters)
        self.ends_code = Effect.ENDS_CODE in declaration.effects
        self._elements: dict[tuple[Type, Direction], ParameterFacts] = {}

    def of(self, number: int, parameter: Parameter) -> ParameterFacts:
        """Returns the facts of an argument; the parameter of a list's element depends on the other arguments."""
        if number < len(self.parameters):
            return self.parameters[number]
        key = parameter.type, parameter.direction
        found = self._elements.get(key)
        if found is None:
            found = self._elements[key] = ParameterFacts(parameter, {}, is_element=True)
        return found


@cache
def operation_facts(schema: OperationReader) -> OperationFacts:
    """Returns the facts about an operation, created once for each schema."""
    return OperationFacts(schema)
