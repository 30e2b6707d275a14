"""A message as one JSON object: every key that other tools may rely on."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from functools import cache
from types import MappingProxyType
from typing import Any

from ev3proto.dialogue import Exchange, Value
from ev3proto.messages import (
    Argument,
    DaisyCommand,
    DaisyReply,
    DirectCommand,
    DirectReply,
    Message,
    Operation,
    SystemCommand,
    SystemReply,
)
from ev3proto.schema.argument import STRINGS
from ev3proto.schema.frame import command_head
from ev3proto.schema.header import COMMAND_HEADER_SIZE
from ev3proto.schema.instructions import PADDING, InstructionSet
from ev3proto.schema.operation import OperationSchema
from ev3proto.tables.declaration import Parameter
from ev3proto.tables.encoding import TEXT, Encoding
from ev3proto.tables.frame import LENGTH_FIELD, MAX_FRAME
from ev3proto.text.heading import Seen
from ev3proto.text.patterns import (
    LONG,
    SHORT_NUMBERS,
    ArgumentTexts,
    Around,
    CommandTexts,
    OperationTexts,
    Pattern,
)


def record(exchange: Exchange, seen: Seen) -> dict[str, Any]:
    """The object of one message.

    Floats that are not finite are the strings "nan", "inf", "-inf"; bytes are hex; keys that do not apply are absent.
    """
    message = exchange.message
    return _record(exchange, seen, [operation_record(operation) for operation in _operations(message)])


def _operations(message: Message) -> tuple[Operation, ...]:
    return message.operations if isinstance(message, DirectCommand | DaisyCommand) else ()


def _record(exchange: Exchange, seen: Seen, operations: list[dict[str, Any]]) -> dict[str, Any]:
    message = exchange.message
    frame = message.build() if seen.frame is None else seen.frame
    entry: dict[str, Any] = {"kind": message.kind}
    if message.type is not None:
        entry["type"] = message.type.name
    if message.stated_length is not None:
        entry["length"] = message.stated_length
    elif message.fault is None or message.type is not None:
        entry["length"] = len(frame) - LENGTH_FIELD
    entry["counter"] = message.counter if message.type is not None else None
    if seen.direction is not None:
        entry["direction"] = seen.direction
    if seen.time is not None:
        entry["time"] = seen.time
    entry.update(_contents(message, operations))
    if exchange.request is not None or isinstance(message, SystemReply):
        entry["values"] = [_value(value) for value in exchange.values]
    if message.fault is not None:
        entry["fault"] = {"offset": message.fault.offset, "reason": message.fault.reason}
    if seen.cut:
        entry["cut"] = True
    if message.rest:
        entry["rest"] = message.rest.hex()
    entry["hex"] = frame.hex()
    return {key: value for key, value in entry.items() if value is not None or key in ("command",)}


_encode = json.JSONEncoder(ensure_ascii=False).encode

_NO_OPERATIONS = '"operations": []'


def record_text(exchange: Exchange, seen: Seen, more: Mapping[str, Any] = MappingProxyType({})) -> str:
    """The same as a text on one line.

    Args:
        exchange: The message.
        seen: How it was come by.
        more: Further keys.

    Returns:
        JSON.

    """
    message = exchange.message
    if not isinstance(message, DirectCommand):
        return _encode(record(exchange, seen) | dict(more))
    # The operations are most of the text. They are put together from what those of the same kind have in common.
    entry = _encode(_record(exchange, seen, []) | dict(more))
    texts: list[str] = []
    _COMMANDS.add_all(texts, message)
    return entry.replace(_NO_OPERATIONS, f'"operations": [{", ".join(texts)}]', 1)


def command_text(frame: bytes, direction: str | None, more: str, instructions: InstructionSet) -> str | None:
    """The text of a direct command without making a message of its frame: a capture is shown in half the time.

    Args:
        frame: From its length field to its last byte.
        direction: `sent` or `received`, None where nobody knows.
        more: Further keys with their values, as they stand in JSON.
        instructions: The instruction set to read by.

    Returns:
        The text that `record_text` gives. None for other messages, and for commands that are faulty or unusual.

    """
    head = command_head(frame)
    texts: list[str] = []
    if head is None or not _COMMANDS.add(texts, frame, COMMAND_HEADER_SIZE, instructions):
        return None
    kind, counter, global_size, local_size = head
    sent = "" if direction is None else f', "direction": "{direction}"'
    return (
        f'{{"kind": "{kind.kind}", "type": "{kind.name}", "length": {len(frame) - LENGTH_FIELD}, "counter": {counter}'
        f'{sent}, "globals": {global_size}, "locals": {local_size}, "operations": [{", ".join(texts)}]'
        f', "hex": "{frame.hex()}", {more}}}'
    )


_PLACES = tuple(f', "offset": {offset}' for offset in range(MAX_FRAME + len(PADDING)))
"""What stands after the value of an argument, by its offset."""


class _JsonTexts(OperationTexts):
    """The objects of operations of one kind."""

    __slots__ = ("_arguments", "_head", "_start")

    def __init__(self, schema: OperationSchema, parameters: tuple[Parameter, ...]) -> None:
        opcode, command = schema.declaration.opcode, schema.declaration.command
        head = {"op": opcode.name, "opcode": opcode.number, "command": command.name if command else None}
        self._head = _encode(head)[:-1]
        self._start = schema.start
        self._arguments = [ArgumentTexts(parameter, Pattern(parameter, _split), _said) for parameter in parameters]

    def add(self, texts: list[str], data: bytes, at: int) -> int:
        """Adds the object of the operation at an offset."""
        start = at
        at += self._start
        found = []
        for argument in self._arguments:
            first = data[at]
            if first < LONG:
                before, after = argument.short[first] or argument.of_short(first)
                found.append(f"{before}{SHORT_NUMBERS[first]}{_PLACES[at]}{after}")
                at += 1
                continue
            narrow = argument.narrow[first]
            if narrow is not None:
                numbers, before, after = narrow
                found.append(f"{before}{numbers[data[at + 1]]}{_PLACES[at]}{after}")
                at += 2
                continue
            place = at
            before, value, after, at = argument.read(data, at)
            length = f', "length": {at - place}' if first in STRINGS else ""
            found.append(f"{before}{value}{_PLACES[place]}{length}{after}")
        texts.append(f'{self._head}{_PLACES[start]}, "length": {at - start}, "args": [{", ".join(found)}]}}')
        return at


_COMMANDS = CommandTexts(_JsonTexts, lambda operation: [_encode(operation_record(operation))])


def _said(value: float | str) -> str:
    return _encode(value) if isinstance(value, str) else repr(value) if math.isfinite(value) else f'"{value}"'


def _split(argument: Argument) -> Around:
    if argument.form.kind == TEXT:
        return _around(argument.name, argument.form, None)
    before, after = _around(argument.name, argument.form, argument.length)
    symbol = argument.symbol
    return before, after if symbol is None else f'{after[:-1]}, "symbol": {_encode(symbol)}}}'


@cache
def _around(name: str, form: Encoding, length: int | None) -> Around:
    """What stands before the value of an argument and after its offset, where its value has no name.

    The length of a text is no part of it: texts of the same encoding have different ones.
    """
    entry = _encode(_named(name, form, 0, 0, length or 0))
    before, _, after = entry.partition('0, "offset": 0' if length is not None else '0, "offset": 0, "length": 0')
    return before, after


def _contents(message: Message, operations: list[dict[str, Any]]) -> dict[str, Any]:
    match message:
        case DirectCommand():
            return {
                "globals": message.global_size,
                "locals": message.local_size,
                "operations": operations,
            }
        case DirectReply():
            return {"status": "error" if message.is_error else "ok", "memory": message.memory.hex()}
        case SystemCommand():
            return {"command": message.command, "number": message.number, "fields": _fields(message)}
        case SystemReply():
            return {
                "command": message.command,
                "number": message.number,
                "status": "error" if message.is_error else "ok",
                "status_name": message.status.name if message.status is not None else None,
                "status_code": message.status_code,
                "fields": _fields(message),
            }
        case DaisyCommand():
            return {
                "command": message.command,
                "number": message.number,
                "fields": {
                    "layer_from": message.layer_from,
                    "layer_to": message.layer_to,
                    "payload": message.payload.hex(),
                },
                "operations": operations,
            }
        case DaisyReply():
            fields: dict[str, Any] = {
                "layer_from": message.layer_from,
                "layer_to": message.layer_to,
                "payload": message.payload.hex(),
            }
            if message.report is not None:
                for name in ("layer", "port", "status", "type", "mode", "data", "checksum", "busy"):
                    fields[name] = _plain(getattr(message.report, name))
            return {"status": "error" if message.type and message.type.is_error else "ok", "fields": fields}
    return {}


def _fields(message: SystemCommand | SystemReply) -> dict[str, Any]:
    return {name: _plain(value) for name, value in message.fields.items()}


def operation_record(operation: Operation) -> dict[str, Any]:
    """The object of one operation."""
    entry: dict[str, Any] = {
        "op": operation.name,
        "opcode": operation.opcode,
        "command": operation.command,
        "offset": operation.offset,
        "length": operation.length,
        "args": [_argument(argument) for argument in operation.arguments],
    }
    cmd = operation.cmd if operation.is_complete else None
    if cmd is not None and cmd.length > 1:
        entry["command_encoding"] = cmd.encoding
    if not operation.is_complete:
        entry["complete"] = False
    return entry


def _argument(argument: Argument) -> dict[str, Any]:
    entry = _named(argument.name, argument.form, _plain(argument.value), argument.offset, argument.length)
    symbol = argument.symbol
    if symbol is not None:
        entry["symbol"] = symbol
    return entry


def _named(name: str, form: Encoding, value: Any, offset: int, length: int) -> dict[str, Any]:
    entry: dict[str, Any] = {
        "name": name,
        "kind": form.kind,
        "encoding": form.name,
        "value": value,
        "offset": offset,
        "length": length,
    }
    if form.handle:
        entry["handle"] = True
    if form.address:
        entry["address"] = True
    return entry


def _value(value: Value) -> dict[str, Any]:
    entry: dict[str, Any] = {
        "op": value.op,
        "command": value.command,
        "name": value.name,
        "value": _plain(value.value),
        "type": value.type,
        "offset": value.offset,
        "length": value.length,
    }
    if value.unit is not None:
        entry["unit"] = value.unit
    if value.symbol is not None:
        entry["symbol"] = value.symbol
    return entry


def _plain(value: Any) -> Any:
    if isinstance(value, bytes):
        return value.hex()
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    if isinstance(value, list):
        return [_plain(item) for item in value]
    return value
