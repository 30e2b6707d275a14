"""From the values of a call to a draft, value by value: every kind of value is known here, and every mistake named."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from ev3proto.errors import BuildError
from ev3proto.messages import Variable
from ev3proto.schema.operation import OperationSchema
from ev3proto.semantics.drafts.draft import OMITTED, STAND_IN, Draft, Open
from ev3proto.semantics.drafts.labels import NO_DISTANCE, Label
from ev3proto.semantics.drafts.meanings import (
    check_number,
    check_text,
    no_variable,
    objections,
    wrong_name,
)
from ev3proto.semantics.drafts.placeholders import Placeholder
from ev3proto.semantics.footprint import Footprint, footprints
from ev3proto.tables.declaration import LISTS, Declaration, Direction, Parameter, Role, Type
from ev3proto.tables.encoding import RANGES


class _Required:
    """The default of a parameter that has to be given, where another before it may be omitted."""

    def __repr__(self) -> str:
        return "required"


REQUIRED: Any = _Required()

_ENUMS = "ev3proto.enums"
"""The module whose classes are the enumerations of the tables, under the same names."""


def may_be_omitted(declaration: Declaration, number: int) -> bool:
    """Whether a parameter, by its number from 0, is an output, or the count of the list after it."""
    parameters = declaration.parameters
    parameter = parameters[number]
    if parameter.type is Type.COUNT:
        return parameter.elements is Direction.OUT
    return parameter.direction is Direction.OUT or (
        number + 1 < len(parameters) and parameters[number + 1].type is Type.VALUES
    )


def draft(schema: OperationSchema, values: Sequence[Any], *, unchecked: bool = False) -> Draft:
    """A draft from one value for each parameter, in their order.

    Args:
        schema: The operation.
        values: As `ev3proto.operation` takes them, a `Placeholder`, or None for an output or a count that is omitted. A
            list parameter takes a list, one of outputs their number, too.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.

    Raises:
        BuildError: Names operation, parameter, and what would be right.
        TypeError: A value is REQUIRED.
    """
    declaration = schema.declaration
    try:
        flat = _flat(declaration, values, unchecked)
        places = {number: value for number, value in enumerate(flat) if isinstance(value, Placeholder | Open)}
        label = flat[-1] if flat and isinstance(flat[-1], Label) and declaration.is_jump else None
        operation = schema.make([_standing(value) for value in flat] if places or label is not None else flat)
        if not unchecked:
            for _, error in objections(operation):
                raise error
        _refuse_unknown_size(footprints(operation), places)
    except BuildError as error:
        sentence = str(error)
        prefix = "" if sentence.startswith(declaration.name) else f"{declaration.name}: "
        raise BuildError(prefix + sentence) from None
    return Draft(schema, operation.raw, places, label=label)


def _standing(value: Any) -> Any:
    if isinstance(value, Label):
        return NO_DISTANCE
    if isinstance(value, Open):
        return STAND_IN
    if isinstance(value, Placeholder):
        # The scope is kept for messages; the index is the shortest that there is.
        return Variable(value.scope, 0, value.handle, value.address)
    return value


def _flat(declaration: Declaration, values: Sequence[Any], unchecked: bool) -> list[Any]:
    """One value for each argument: lists drawn out, their counts put in, what was omitted marked."""
    flat: list[Any] = []
    for parameter, value in zip(declaration.parameters, values, strict=True):
        if value is REQUIRED:
            raise TypeError(f"{declaration.name} needs {parameter.name}, too")
        if parameter.type in LISTS:
            elements = _elements(parameter, value)
            if parameter.type is Type.COUNT:
                flat.append(len(elements))
            elif flat[-1] is OMITTED:
                flat[-1] = len(elements)
            flat += elements
        elif value is None:
            if not may_be_omitted(declaration, len(flat)):
                raise BuildError(f"{parameter.name} cannot be omitted: {parameter.text}")
            flat.append(OMITTED)
        else:
            check_constant(parameter, value, unchecked=unchecked)
            flat.append(value)
    return flat


def _elements(parameter: Parameter, value: Any) -> list[Any]:
    if parameter.type is Type.COUNT and parameter.elements is not Direction.IN:
        if value is None:
            return [OMITTED]
        if isinstance(value, int) and not isinstance(value, bool):
            most = RANGES[Type.COUNT].high
            if not 0 <= value <= most:
                raise BuildError(f"{parameter.name} must be 0 to {most} as a number of outputs, not {value}")
            return [OMITTED] * value
        if isinstance(value, Variable | Placeholder):
            return [value]
    if isinstance(value, str | bytes) or not isinstance(value, Iterable):
        raise BuildError(f"{parameter.name} takes a list, not {value!r}")
    return [OMITTED if element is None else element for element in value]


def check_constant(parameter: Parameter, value: Any, *, unchecked: bool = False) -> None:
    """Refuses a value by itself that is not legal for a parameter; variables and encoded arguments are.

    Args:
        parameter: What the tables declare.
        value: Anything.
        unchecked: Refuse only what names no member of the parameter's enumeration.

    Raises:
        BuildError: Names the parameter and what would be right.
    """
    if parameter.enum is not None:
        _check_name(parameter, value)
    if parameter.role is Role.JUMP and isinstance(value, str):
        raise BuildError(f"{parameter.name} takes a number, a variable or {Label(value or 'again')!r}, not {value!r}")
    if unchecked or not isinstance(value, int | float | str):
        return
    if parameter.direction is Direction.INOUT:
        raise no_variable(parameter, value)
    if parameter.direction is Direction.IN:
        if isinstance(value, str):
            check_text(parameter, value)
        elif parameter.type is not Type.ARRAY_TYPED or isinstance(value, int):
            check_number(parameter, value)


def _check_name(parameter: Parameter, value: Any) -> None:
    """Refuses what names no member of the parameter's enumeration, or a member of another one."""
    assert parameter.enum is not None
    if isinstance(value, str) and parameter.number_of(value) is None and parameter.length is None:
        raise wrong_name(parameter, value)
    meant = type(value)
    is_of_another = meant.__module__ == _ENUMS and meant.__name__ != parameter.enum.name
    if is_of_another and value.name not in parameter.names:
        raise BuildError(f"{parameter.name} takes a member of {parameter.enum.name}, not {value!r}")


def _refuse_unknown_size(used: Iterable[Footprint], places: Mapping[int, Placeholder | Open]) -> None:
    for found in used:
        if found.room is None and isinstance(places.get(found.number), Open):
            raise BuildError(
                f"{found.argument.name} cannot be omitted: it is not known how long it becomes. Give the bytes that it"
                " may take, Global(32), or its place, GV(0)"
            )
