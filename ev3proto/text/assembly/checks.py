"""What a program says that assembles and is not what the operation takes: warnings, as the strict assembler has errors.

The bytes do not depend on any of it. A `!` in front of an argument keeps them quiet.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ev3proto.errors import counted
from ev3proto.schema.instructions import OperationSchema, instruction_set
from ev3proto.tables import OPCODES
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.declaration import DIALECTS, Direction, Parameter, Type
from ev3proto.tables.encoding import BITS, RANGES
from ev3proto.text.assembly.errors import cited
from ev3proto.text.assembly.names import Callee, Meaning, Place
from ev3proto.text.assembly.syntax import Call, Name, Value

_NUMBERS = {opcode.name: opcode.number for opcode in OPCODES}
_COMMANDS = {(opcode.name, command.name) for opcode in OPCODES for command in opcode.commands}
_UNTYPED = (Type.ARRAY_TYPED, Type.LABEL, Type.COUNT, Type.VALUES, Type.HANDLE)

Warnings = Iterator[tuple[int, str]]
Meant = Sequence[Meaning | None]
"""What the arguments of an operation mean; None for one that is not to be checked."""


def of_operation(call: Call, name: str, values: Meant) -> Warnings:
    """What may not be meant of an operation, CMD included.

    Args:
        call: The operation as it is written.
        name: Its name.
        values: What its arguments mean.
    """
    number = _NUMBERS[name]
    arguments = [argument.value for argument in call.arguments]
    schemas = [one.opcodes[number] for one in map(instruction_set, DIALECTS)]
    families = [one.families[number] for one in map(instruction_set, DIALECTS)]
    if any(families):
        if not values:
            yield call.at, f"the CMD of {name} is missing"
            return
        cmd, first = values[0], arguments[0]
        if not isinstance(cmd, int):
            return
        schemas = [family.commands.get(cmd) for family in families if family is not None]
        if isinstance(first, Name) and (name, first.text) not in _COMMANDS:
            yield first.at, f"{cited(first.text)} is not a CMD of {name}, and counts as the number {cmd}"
        if not any(schemas):
            yield call.at, f"{name} has no CMD {cmd}"
        arguments, values = arguments[1:], values[1:]
    schema = next((schema for schema in schemas if schema is not None), None)
    if schema is not None:
        yield from _of_parameters(call, schema, arguments, values)


def of_call(call: Call, values: Meant, callee: Callee) -> Warnings:
    """What may not be meant of what a CALL hands over."""
    arguments = [argument.value for argument in call.arguments[1:]]
    for number, ((direction, kind), argument, value) in enumerate(
        zip(callee.parameters or (), arguments, values, strict=False), 1
    ):
        yield from _of_one("CALL", Parameter(f"parameter {number}", kind, "", direction), argument, value)


def _of_parameters(call: Call, schema: OperationSchema, arguments: Sequence[Value], values: Meant) -> Warnings:
    name, fixed = schema.declaration.name, schema.fixed
    wanted: int | None = len(fixed)
    if schema.list_parameter is not None:
        count = values[len(fixed) - 1] if len(values) >= len(fixed) else None
        wanted = len(fixed) + count if isinstance(count, int) else None
    if wanted is not None and len(values) != wanted:
        yield call.at, f"{name} takes {counted(wanted, 'argument')}, and here are {len(values)}"
    for one, argument, value in zip(fixed, arguments, values, strict=False):
        yield from _of_one(name, one.parameter, argument, value)


def _of_one(operation: str, parameter: Parameter, argument: Value, value: Meaning | None) -> Warnings:
    reason = (
        _wrong_place(parameter, value)
        if isinstance(value, Place)
        else _wrong_constant(parameter, value)
        if isinstance(value, int | float | str)
        else None
    )
    if reason is not None:
        shown = f": {cited(argument.text)}" if isinstance(argument, Name) else ""
        yield argument.at, f"{parameter.name} of {operation} {reason}{shown}"


def _wrong_constant(parameter: Parameter, value: int | float | str) -> str | None:
    kind = parameter.type
    if parameter.direction is Direction.OUT:
        return "is an output, and what is written into a constant is lost"
    if isinstance(value, float):
        return None if kind in (Type.DATAF, Type.ARRAY_TYPED) else f"is a {kind}, and here is a float"
    if isinstance(value, str):
        is_text = kind in (Type.STRING, Type.ARRAY_TYPED, Type.DATA8)
        return None if is_text else f"is a {kind}, and here is a string"
    if kind is Type.DATAF:
        if value in (0, CONSTANTS["DATAF_NAN"]):
            return None
        return "is a DATAF, and a whole number means its bits there, while floats end in F"
    if kind is Type.STRING:
        return "is a string, and here is a number"
    limits = RANGES.get(kind) if kind in (Type.DATA8, Type.DATA16) else None
    if parameter.unsigned and value in BITS[kind]:
        return None
    if limits is not None and not limits.low <= value <= limits.high and value != limits.nan & (limits.high * 2 + 1):
        return f"is a {kind}, which reaches from {limits.low} to {limits.high}: it cannot be {value}"
    return None


def _wrong_place(parameter: Parameter, place: Place) -> str | None:
    kind = parameter.type
    if kind in _UNTYPED or place.type is kind:
        return None
    if kind is Type.STRING:
        is_text = place.type in (Type.STRING, Type.DATA8, Type.HANDLE)
        return None if is_text else f"is a string, and here is a {place.type}"
    if place.type is Type.STRING:
        return None if kind is Type.DATA8 else f"is a {kind}, and here is a string"
    if place.type.size != kind.size or (place.type is Type.DATAF) is not (kind is Type.DATAF):
        return f"is a {kind}, and here is a {place.type}"
    return None
