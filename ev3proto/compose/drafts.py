"""Operations whose values are checked and encoded, with places in memory that may still be open."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from typing import Any

from ev3proto.compose.calls import REQUIRED, MissingValueError
from ev3proto.compose.meanings import (
    check_arrays,
    check_meaning,
    check_number,
    check_places,
    check_text,
    no_variable,
    wrong_name,
)
from ev3proto.compose.places import Place
from ev3proto.errors import BuildError
from ev3proto.messages import GV, Operation, Variable
from ev3proto.schema.argument import encode_variable
from ev3proto.schema.instructions import instruction_set
from ev3proto.schema.operation import OperationSchema
from ev3proto.semantics.footprint import LISTS, Footprint, footprints
from ev3proto.tables.declaration import Declaration, Direction, Parameter, Type
from ev3proto.tables.encoding import RANGES

_PLAIN = (int, float, str, bool)
"""Types of values that are no variables: an operation of these takes no memory."""

_STAND_IN = GV(0)
"""What stands in a draft for a variable whose place is open."""

_ENUMS = "ev3proto.enums"
"""The module whose classes are the enumerations of the tables, under the same names."""


class Open:
    """An output that was left away: `command` makes a global variable of it, in each command that has it."""

    __slots__ = ()

    def __repr__(self) -> str:
        return "left away"


LEFT_AWAY = Open()


class Draft:
    """An operation that was asked for: what `ev3proto.ops` makes and `ev3proto.command` takes.

    Its values are checked and encoded. What is open are the places of its outputs that were left away and of
    variables that are `Local()` or `Global()`; a command gives them theirs.

    Attributes:
        footprints: The memory that it uses; variables whose place is open start at 0 there.
    """

    __slots__ = ("_operation", "_places", "footprints")

    def __init__(
        self, operation: Operation, places: Mapping[int, Place | Open], footprints: Sequence[Footprint]
    ) -> None:
        self.footprints = tuple(footprints)
        self._operation = operation
        self._places = dict(places)

    @property
    def declaration(self) -> Declaration:
        """What the tables say of the operation."""
        return self._operation.declaration

    @property
    def name(self) -> str:
        """`SOUND.TONE`, or the opcode's name alone."""
        return self.declaration.name

    @property
    def is_complete(self) -> bool:
        """True when no place is open."""
        return not self._places

    @property
    def operation(self) -> Operation:
        """The operation, by itself at offset 0. Raises BuildError while a place is open."""
        if self._places:
            names = ", ".join(found.argument.name for found in self.footprints if found.number in self._places)
            raise BuildError(
                f"{self.name}: {names} has no place in memory yet: ev3proto.command gives it one, or GV(0) and the like"
            )
        return self._operation

    @property
    def raw(self) -> bytes:
        """Its bytes, opcode first. Raises BuildError while a place is open."""
        return self.operation.raw

    def place_of(self, footprint: Footprint) -> Place | Open | None:
        """What stands in the place of a variable that is open; None for one that has an index."""
        return self._places.get(footprint.number)

    def placed(self, variables: Mapping[int, Variable]) -> Operation:
        """The operation with variables, by the number of the argument, in the places that are open."""
        operation = self._operation
        if not self._places:
            return operation
        schema, data, *_ = operation
        arguments = operation.arguments
        pieces = [data[: arguments[0].offset]]
        for number, argument in enumerate(arguments):
            variable = variables.get(number)
            pieces.append(argument.raw if variable is None else encode_variable(variable, argument.name))
        raw = b"".join(pieces)
        return Operation((schema, raw, 0, len(raw)))

    def __repr__(self) -> str:
        arguments = ", ".join(
            f"{argument.name}={self._places.get(number, argument.value)!r}"
            for number, argument in enumerate(self._operation.arguments)
        )
        return f"<{self.name}({arguments})>"


def may_be_left_away(declaration: Declaration, number: int) -> bool:
    """Whether a parameter, by its number from 0, is an output, or the count of the list behind it."""
    parameters = declaration.parameters
    parameter = parameters[number]
    if parameter.type is Type.COUNT:
        return parameter.elements is Direction.OUT
    return parameter.direction is Direction.OUT or (
        number + 1 < len(parameters) and parameters[number + 1].type is Type.VALUES
    )


def draft(schema: OperationSchema, values: Sequence[Any], *, unchecked: bool = False) -> Draft:
    """A draft from one value for each parameter, in their order.

    values     as `ev3proto.operation` takes them, a `Place`, or None for an output or a count that is left away; a list
               parameter takes a list, one of outputs their number, too
    unchecked  let values through that the tables do not provide for, as far as they can be encoded

    Raises BuildError, which names operation, parameter, and what would be right.
    """
    declaration = schema.declaration
    try:
        flat = _flat(declaration, values, unchecked)
        places = {number: value for number, value in enumerate(flat) if isinstance(value, Place | Open)}
        operation = schema.make([_standing(value) for value in flat] if places else flat)
        if _is_simple(schema, flat):
            return Draft(operation, places, ())
        arguments = operation.arguments
        used = footprints(operation, arguments)
        if not unchecked:
            check_arrays(arguments)
            for argument in arguments:
                check_meaning(argument)
            check_places(used)
        _refuse_unknown_size(used, places)
    except BuildError as error:
        sentence = str(error)
        prefix = "" if sentence.startswith(declaration.name) else f"{declaration.name}: "
        raise BuildError(prefix + sentence) from None
    return Draft(operation, places, used)


class OperationDrafts:
    """Drafts of one operation."""

    def __init__(self, schema: OperationSchema) -> None:
        self.schema = schema

    def draft(self, values: Sequence[Any], unchecked: bool) -> Draft:
        """A draft from one value for each parameter, as `draft` makes it."""
        return draft(self.schema, values, unchecked=unchecked)


class Drafts(dict[str, OperationDrafts]):
    """Drafts of the operations of one dialect by name (`SOUND.TONE`); each is prepared when it is first asked for."""

    def __init__(self, dialect: str) -> None:
        super().__init__()
        self._dialect = dialect

    def __missing__(self, name: str) -> OperationDrafts:
        found = self[name] = OperationDrafts(instruction_set(self._dialect)[name])
        return found


@cache
def drafts(dialect: str) -> Drafts:
    """The drafts of one dialect's operations."""
    return Drafts(dialect)


def _is_simple(schema: OperationSchema, flat: Sequence[Any]) -> bool:
    """Whether there are only numbers and texts, each of which was looked at by itself."""
    if schema.list_parameter is not None or any(type(value) not in _PLAIN for value in flat):
        return False
    return all(parameter.length is None for parameter in schema.declaration.parameters)


def draft_of(operation: Operation) -> Draft:
    """An operation that was made otherwise, as a draft in which nothing is open."""
    return Draft(operation, {}, footprints(operation))


def _standing(value: Any) -> Any:
    if isinstance(value, Open):
        return _STAND_IN
    if isinstance(value, Place):
        # The scope is kept for messages; the index is the shortest that there is.
        return Variable(value.scope, 0, value.handle, value.address)
    return value


def _flat(declaration: Declaration, values: Sequence[Any], unchecked: bool) -> list[Any]:
    """One value for each argument: lists drawn out, their counts put in, what was left away marked."""
    flat: list[Any] = []
    for parameter, value in zip(declaration.parameters, values, strict=True):
        if value is REQUIRED:
            raise MissingValueError
        if parameter.type in LISTS:
            elements = _elements(parameter, value)
            if parameter.type is Type.COUNT:
                flat.append(len(elements))
            elif flat[-1] is LEFT_AWAY:
                flat[-1] = len(elements)
            flat += elements
        elif value is None:
            if not may_be_left_away(declaration, len(flat)):
                raise BuildError(f"{parameter.name} cannot be left away: {parameter.text}")
            flat.append(LEFT_AWAY)
        else:
            if parameter.enum is not None:
                _check_name(parameter, value)
            if not unchecked and isinstance(value, int | float | str):
                _check_constant(parameter, value)
            flat.append(value)
    return flat


def _elements(parameter: Parameter, value: Any) -> list[Any]:
    if parameter.type is Type.COUNT and parameter.elements is not Direction.IN:
        if value is None:
            return [LEFT_AWAY]
        if isinstance(value, int) and not isinstance(value, bool):
            most = RANGES[Type.COUNT].high
            if not 0 <= value <= most:
                raise BuildError(f"{parameter.name} cannot be {value}: as a number of outputs it is 0 to {most}")
            return [LEFT_AWAY] * value
        if isinstance(value, Variable | Place):
            return [value]
    if isinstance(value, str | bytes) or not isinstance(value, Iterable):
        raise BuildError(f"{parameter.name} takes a list, not {value!r}")
    return [LEFT_AWAY if element is None else element for element in value]


def _check_name(parameter: Parameter, value: Any) -> None:
    """Refuses what names no member of the parameter's enumeration, or a member of another one."""
    assert parameter.enum is not None
    if isinstance(value, str) and value not in parameter.enum.members and parameter.length is None:
        raise wrong_name(parameter, value)
    meant = type(value)
    if meant.__module__ == _ENUMS and meant.__name__ != parameter.enum.name:
        raise BuildError(f"{parameter.name} takes a member of {parameter.enum.name}, not {value!r}")


def _check_constant(parameter: Parameter, value: float | str) -> None:
    if parameter.direction is Direction.INOUT:
        raise no_variable(parameter, value)
    if parameter.direction is Direction.IN:
        if isinstance(value, str):
            check_text(parameter, value)
        else:
            check_number(parameter, value)


def _refuse_unknown_size(used: Iterable[Footprint], places: Mapping[int, Place | Open]) -> None:
    for found in used:
        if found.room is None and isinstance(places.get(found.number), Open):
            raise BuildError(
                f"{found.argument.name} cannot be omitted: nobody can tell how long it becomes. Give the bytes that it"
                " may take, Global(32), or its place, GV(0)"
            )
