"""From an opcode to its handler and to how its parameters are read: one table a dialect, made from the tables."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache
from typing import Any

import ev3proto.brick.operations  # noqa: F401 - registers the handlers
from ev3proto.brick.handlers import HANDLERS, UNKNOWN_COMMANDS, Dispatch, Entry, Family, Function, Handler
from ev3proto.brick.machine import Machine
from ev3proto.tables import operations
from ev3proto.tables.declaration import Declaration, Direction, Parameter, Type

Reader = Callable[[Machine], Any]


@cache
def dispatch_table(dialect: str) -> Dispatch:
    """The table of a dialect. ValueError for an unknown dialect, or for a handler that cannot be called as declared."""
    plain: dict[int, Entry] = {}
    families: dict[int, dict[int, Entry]] = {}
    unknown: dict[int, Function | None] = {}
    for name, declaration in operations(dialect).items():
        number = declaration.opcode.number
        if declaration.opcode.is_family:
            families.setdefault(number, {})
            unknown[number] = UNKNOWN_COMMANDS.get(declaration.opcode.name)
        handler = HANDLERS.get(name)
        if handler is None:
            entry = Entry(_missing, None)
        else:
            entry = Entry(handler.function, None if handler.raw else _readers(declaration, handler))
        if declaration.command is None:
            plain[number] = entry
        else:
            families[number][declaration.command.number] = entry
    return tuple(
        Family(families[number], unknown[number]) if number in families else plain.get(number) for number in range(256)
    )


def _missing(vm: Machine) -> None:
    """What an operation without a handler does."""
    vm.fail()


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
        Type.COUNT: Machine.places,
    }
    unknown = handler.places - {parameter.name for parameter in declaration.parameters}
    if unknown:
        raise ValueError(f"{declaration.name} has no parameter {', '.join(sorted(unknown))}")

    def reader(parameter: Parameter) -> Reader:
        if parameter.type is Type.VALUES:
            raise ValueError(f"the handler of {declaration.name} has to read its values itself: raw=True")
        is_array = parameter.length is not None and parameter.type is not Type.STRING
        if parameter.direction is not Direction.IN or is_array or parameter.name in handler.places:
            return Machine.place
        return numbers[parameter.type]

    return tuple(reader(parameter) for parameter in declaration.parameters)


def coverage(dialect: str = "official") -> Iterator[tuple[str, bool]]:
    """Every operation of a dialect by name, and whether it has a handler. ValueError for an unknown dialect."""
    for name in operations(dialect):
        yield name, name in HANDLERS
