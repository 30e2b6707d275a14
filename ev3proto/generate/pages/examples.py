"""An example of each operation and system command: its call in Python, its frame, and the meaning of its bytes.

The values are the same every time, legal, and realistic where the tables say enough for that.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from importlib import import_module
from typing import Any, NamedTuple

from ev3proto.checking.checking import check
from ev3proto.compose import Draft, Global, command
from ev3proto.errors import BuildError
from ev3proto.generate.modules.source import python_name
from ev3proto.messages import LV, Argument, DirectCommand, Message, SystemCommand, Variable
from ev3proto.schema.fields import REQUESTS
from ev3proto.schema.frame import parse
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE
from ev3proto.semantics.domain import domain_of
from ev3proto.tables import with_effect
from ev3proto.tables.declaration import DIALECTS, Declaration, Direction, Effect, Parameter, Role, Type
from ev3proto.tables.frame import LENGTH_FIELD
from ev3proto.tables.system import FieldKind, SystemDeclaration, SystemField
from ev3proto.text.phrases import argument_meaning, argument_value, plain

_BY_UNIT = {"%": 50, "Hz": 440, "ms": 1000}
"""Usual numbers for a unit."""

_BY_ROLE = {Role.JUMP: 0, Role.LABEL: 1, Role.MOTORS: 1, Role.OBJECT: 1, Role.ADDRESS: 2}

_NUMBER = 2
"""The number for a parameter without a unit."""

_SIZE = 8
"""Length of a text or list that the brick writes, if an argument gives it."""

_LIST = (1, 2)
"""The elements of a list."""

_ROOM = 16
"""Bytes for an output of unknown length."""

_PATH = "../prjs/demo/"
_TEXT = "demo"
_NOTE = "A4"

_COUNTER = 1
_PAIR = 6
"""The motors B and C, which drive most robots."""


class Example(NamedTuple):
    """One example."""

    call: str
    frame: bytes  # what the call builds


def example_of(declaration: Declaration, dialect: str) -> Example:
    """Returns the example of an operation. After one that draws, the picture is shown. Raises BuildError."""
    try:
        calls = [_call(declaration, dialect, omitted=True)]
    except BuildError:  # the length of an output must be given if it is not known
        calls = [_call(declaration, dialect, omitted=False)]
    if Effect.DRAWS in declaration.effects and Effect.SHOWS not in declaration.effects:
        calls.append(_call(with_effect(Effect.SHOWS), DIALECTS[0], omitted=True))
    frame = command(*(draft for _, draft in calls), counter=_COUNTER).build()
    return Example(f"ev3proto.command({', '.join(call for call, _ in calls)}, counter={_COUNTER})", frame)


def _call(declaration: Declaration, dialect: str, *, omitted: bool) -> tuple[str, Draft]:
    """Returns a call of an operation's function, and its result."""
    values = {name: value for name, value in _values(declaration, omitted=omitted) if value is not None}
    path, function = _function(declaration, dialect)
    arguments = ", ".join(f"{name}={_written(value)}" for name, value in values.items())
    draft: Draft = function(**values)
    return f"{path}({arguments})", draft


def _function(declaration: Declaration, dialect: str) -> tuple[str, Any]:
    """Returns the function of an operation: its name in a program, and the function itself."""
    package = "ev3proto.ops" if dialect == DIALECTS[0] else f"ev3proto.ops.{dialect}"
    names = [python_name(part) for part in declaration.name.split(".")]
    found: Any = import_module(package)
    for name in names:
        found = getattr(found, name)
    return ".".join([package.rpartition(".")[2], *names]), found


def _values(declaration: Declaration, *, omitted: bool) -> Iterator[tuple[str, Any]]:
    """Returns a value for each parameter; None if it is omitted."""
    has_list = any(parameter.is_list and not parameter.counts for parameter in declaration.parameters)
    for index, parameter in enumerate(declaration.parameters):
        counted = [each for each in declaration.parameters if each.length == parameter.name]
        value = _value(parameter, index, omitted=omitted)
        if Effect.SYNCHRONIZES in declaration.effects and parameter.role is Role.MOTORS:
            value = _PAIR
        if counted and not parameter.is_output:
            value = len(_LIST) if has_list else _SIZE if counted[0].is_output else 1
        yield python_name(parameter.name), value


def _value(parameter: Parameter, index: int, *, omitted: bool) -> Any:
    if parameter.is_list:
        return list(_LIST) if parameter.elements is Direction.IN else None
    if parameter.direction is Direction.OUT:
        return None if omitted else Global(_ROOM)
    if parameter.direction is Direction.INOUT:
        return Global() if omitted else Global(_ROOM)
    if parameter.type is Type.STRING:
        return _text(parameter)
    if parameter.type is Type.HANDLE:
        return LV(0) if parameter.length is not None or "handle" not in parameter.text else 0
    return _number(parameter, index)


def _text(parameter: Parameter) -> str:
    words = parameter.text
    if "C4" in words:
        return _NOTE
    if "such as %" in words:
        return words.split("such as ")[1].split()[0]
    if "closing slash" in words or "path of the folder" in words:
        return _PATH
    if "path" in words or "extension" in words or "relative to" in words:
        return _PATH + _TEXT
    return _TEXT


def _number(parameter: Parameter, index: int) -> int | float:
    if parameter.role in _BY_ROLE:
        return _BY_ROLE[parameter.role]
    if parameter.role is not None or parameter.length is not None:
        return 0
    domain = domain_of(parameter)
    usual = 10 * index if parameter.type is Type.DATA16 else _NUMBER
    wanted = _BY_UNIT.get(parameter.unit or "", usual)
    if domain is None:
        return float(wanted) if parameter.type is Type.DATAF else wanted
    if parameter.enum is not None:
        return next((it for it in parameter.enum.members.values() if it > 0 and domain.covers(it)), 0)
    low, high = domain.spans[0]
    return min(max(wanted, low), high)


def _written(value: Any) -> str:
    """Returns a value as Python source."""
    if isinstance(value, Variable):
        return str(value)
    return json.dumps(value) if isinstance(value, str) else repr(value).replace("'", '"')


def system_example(entry: SystemDeclaration) -> Example:
    """Returns the example of a system command."""
    package = "system.bootloader" if entry.bootloader else "system"
    name = python_name(entry.name)
    values = {field.name: value for field in entry.request if (value := _field_value(field)) is not None}
    arguments = ", ".join([*(f"{name}={_written(value)}" for name, value in values.items()), f"counter={_COUNTER}"])
    function = getattr(import_module(f"ev3proto.{package}"), name)
    return Example(f"{package}.{name}({arguments})", function(**values, counter=_COUNTER).build())


def _field_value(field: SystemField) -> Any:
    if field.counts is not None or field.optional or field.name == "max_bytes":
        return None
    if field.kind is FieldKind.DATA:
        return b"abc"
    if field.kind in (FieldKind.TEXT, FieldKind.COUNTED_TEXT):
        return f"{_PATH}{_TEXT}.rtf" if field.name == "path" else _TEXT
    return 1


def is_accepted(example: Example, dialect: str) -> bool:
    """Tells whether the brick accepts the frame."""
    return check(example.frame, dialect=dialect).accepted


def explained(frame: bytes, dialect: str = "official") -> Iterator[str]:
    """Yields the bytes of a frame, one part a line, with the meaning of each part."""
    message = parse(frame, dialect=dialect)
    rows = list(_rows(frame, message))
    width = max(len(data.hex(" ")) for data, _ in rows)
    yield from (f"{data.hex(' ').upper():{width}}  {meaning}" for data, meaning in rows)


def _rows(frame: bytes, message: Message) -> Iterator[tuple[bytes, str]]:
    assert message.type is not None
    yield frame[:LENGTH_FIELD], f"length: {len(frame) - LENGTH_FIELD} bytes follow"
    yield frame[LENGTH_FIELD : HEADER_SIZE - 1], f"message counter {message.counter}"
    yield frame[HEADER_SIZE - 1 : HEADER_SIZE], message.type.name
    if isinstance(message, DirectCommand):
        memory = f"memory: {message.global_size} bytes global, {message.local_size} bytes local"
        yield frame[HEADER_SIZE:COMMAND_HEADER_SIZE], memory
        for operation in message.operations:
            yield frame[operation.offset : operation.offset + 1], operation.name
            if operation.cmd is not None:
                yield operation.cmd.raw, f"CMD {operation.command}"
            yield from (_argument_row(argument) for argument in operation.arguments)
    elif isinstance(message, SystemCommand):
        yield frame[HEADER_SIZE : HEADER_SIZE + 1], str(message.command)
        fields = message.fields
        at = HEADER_SIZE + 1
        for number, name in enumerate(fields, 1):
            before = dict(list(fields.items())[:number])
            end = HEADER_SIZE + 1 + len(REQUESTS[message.number].write_present(before))
            yield frame[at:end], f"{name} = {plain(fields[name])}"
            at = end


def _argument_row(argument: Argument) -> tuple[bytes, str]:
    meaning = argument_meaning(argument)
    said = f" {meaning}" if meaning and meaning == argument.parameter.unit else f" ({meaning})" if meaning else ""
    return argument.raw, f"{argument.name} = {argument_value(argument)}{said}  {argument.encoding}"
