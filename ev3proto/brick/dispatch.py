"""The dispatch table of a dialect: the handler of each opcode, and the readers of its parameters."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache
from typing import Any

import ev3proto.brick.operations  # noqa: F401 - registers the handlers
from ev3proto.brick.exits import NoOperation
from ev3proto.brick.handlers import HANDLERS, UNKNOWN_COMMANDS, Dispatch, DispatchEntry, Family, Function, Handler
from ev3proto.brick.locations import WRITERS
from ev3proto.brick.machine import Machine
from ev3proto.brick.operations.without_effect import fail
from ev3proto.tables import operations
from ev3proto.tables.declaration import Declaration, Direction, Parameter, Type

Reader = Callable[[Machine], Any]


@cache
def dispatch_table(dialect: str) -> Dispatch:
    """Returns the table of a dialect. ValueError for an unknown dialect, or a handler that does not fit."""
    found: list[DispatchEntry | Family] = [DispatchEntry(_no_operation, None)] * 256
    for declaration in operations(dialect).values():
        opcode, entry = declaration.opcode, _entry(declaration)
        if declaration.command is None:
            found[opcode.number] = entry
            continue
        family = found[opcode.number]
        if not isinstance(family, Family):
            unknown = UNKNOWN_COMMANDS.get(opcode.name, _nothing)
            family = found[opcode.number] = Family({}, DispatchEntry(unknown, None, is_quick=True))
        family.entries[declaration.command.number] = entry
    return tuple(found)


def _no_operation(_: Machine) -> None:
    raise NoOperation


def _nothing(_: Machine) -> None:
    pass


def _entry(declaration: Declaration) -> DispatchEntry:
    handler = HANDLERS.get(declaration.name)
    if handler is None:
        return DispatchEntry(fail, None)
    function = _computing(declaration, handler.function) if handler.computes else handler.function
    is_quick = all(parameter.type.size for parameter in declaration.parameters) and declaration.tail is None
    return DispatchEntry(function, None if handler.raw else _readers(declaration, handler), is_quick)


def _computing(declaration: Declaration, function: Function) -> Function:
    """Returns a handler that writes what a function of the inputs returns to the outputs, which follow the inputs."""
    writers = [WRITERS[each.type] for each in declaration.parameters if each.is_output]
    count = len(declaration.parameters) - len(writers)

    def compute(vm: Machine, *parameters: Any) -> None:
        found = function(vm, *parameters[:count])
        if writers:
            values = found if isinstance(found, tuple) else (found,)
            for write, place, value in zip(writers, parameters[count:], values, strict=True):
                write(place, value)

    return compute


def _readers(declaration: Declaration, handler: Handler) -> tuple[Reader, ...]:
    numbers: dict[Type, Reader] = {
        Type.DATA8: Machine.int8,
        Type.DATA16: Machine.int16,
        Type.HANDLE: Machine.int16,
        Type.DATA32: Machine.int32,
        Type.LABEL: Machine.int32,
        Type.DATAF: Machine.float32,
        Type.STRING: Machine.text,
        Type.ARRAY_TYPED: Machine.place,
    }
    unknown = handler.places - {parameter.name for parameter in declaration.parameters}
    if unknown:
        raise ValueError(f"{declaration.name} has no parameter {', '.join(sorted(unknown))}")

    def reader(parameter: Parameter) -> Reader:
        if parameter.counts:
            return Machine.places
        if parameter.is_list:
            raise ValueError(f"the handler of {declaration.name} has to read its values itself: raw=True")
        is_array = parameter.length is not None and parameter.type is not Type.STRING
        if parameter.direction is not Direction.IN or is_array or parameter.name in handler.places:
            return Machine.place
        return numbers[parameter.type]

    return tuple(reader(parameter) for parameter in declaration.parameters)


def coverage(dialect: str = "official") -> Iterator[tuple[str, bool]]:
    """Yields every operation of a dialect by name, and whether it has a handler. ValueError for an unknown dialect."""
    for name in operations(dialect):
        yield name, name in HANDLERS
