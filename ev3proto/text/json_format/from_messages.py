"""A message as one JSON object, with every key that other tools may rely on."""

from __future__ import annotations

import math
from collections.abc import Callable
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
from ev3proto.semantics.readings import datasets_of
from ev3proto.semantics.replies import guesses
from ev3proto.tables.frame import LENGTH_FIELD
from ev3proto.tables.system import status_meaning
from ev3proto.text.phrases import Seen, lacks_status


def record(exchange: Exchange, seen: Seen) -> dict[str, Any]:
    """Returns the object of one message.

    Floats that are not finite are the strings "nan", "inf", "-inf"; bytes are hex; keys that do not apply are absent.
    """
    message = exchange.message
    frame = message.build() if seen.frame is None else seen.frame
    fault = message.fault
    entry = {
        "kind": message.kind,
        "type": None if message.type is None else message.type.name,
        "length": _length(message, frame),
        "counter": None if message.type is None else message.counter,
        "direction": seen.direction,
        "label": seen.label or None,
        "time": seen.time,
        **_CONTENTS.get(type(message), lambda _: {})(message),
        **_values(exchange),
        "fault": fault and {"offset": fault.offset, "reason": fault.reason},
        "cut": bool(seen.missing) or None,
        "missing": seen.missing or None,
        "unknown": sorted(seen.unknown) or None,
        "rest": message.rest.hex() or None,
        "note": exchange.note,
        "hex": frame.hex(),
    }
    return {key: value for key, value in entry.items() if value is not None or key == "command"}


def _length(message: Message, frame: bytes) -> int | None:
    """Returns what the length field says, or would say; None for bytes that are too short for a frame."""
    if message.stated_length is not None:
        return message.stated_length
    return None if message.fault is not None and message.type is None else len(frame) - LENGTH_FIELD


def _values(exchange: Exchange) -> dict[str, Any]:
    """Returns the values of a reply, or what its bytes may mean if its command is unknown."""
    message = exchange.message
    if exchange.request is not None or isinstance(message, SystemReply):
        return {"values": [_value(value) for value in exchange.values]}
    found = guesses(message.memory) if isinstance(message, DirectReply) else None
    return {"readings": {kind: _plain(value) for kind, value in found.items()}} if found else {}


def _direct_command(message: DirectCommand) -> dict[str, Any]:
    operations = list(map(operation_record, message.operations))
    return {"globals": message.global_size, "locals": message.local_size, "operations": operations}


def _direct_reply(message: DirectReply) -> dict[str, Any]:
    return {"status": "error" if message.is_error else "ok", "memory": message.memory.hex()}


def _system_command(message: SystemCommand) -> dict[str, Any]:
    found = {"command": message.command, "number": message.number, "fields": _fields(message)}
    readings = {kind: _plain(value) for kind, value in message.readings.items()}
    return found | ({"readings": readings} if readings else {})


def _system_reply(message: SystemReply) -> dict[str, Any]:
    return {
        "command": message.command,
        "number": message.number,
        "status": "error" if message.is_error else "ok",
        "status_name": None if lacks_status(message) or message.status is None else message.status.name,
        "status_code": message.status_code,
        "status_meaning": status_meaning(message.number, message.status_code),
        "fields": _fields(message),
    }


def _sent_on(message: DaisyCommand | DaisyReply) -> dict[str, Any]:
    return {
        "layer_from": message.layer_from,
        "layer_to": message.layer_to,
        "payload": message.payload.hex(),
    }


def _daisy_command(message: DaisyCommand) -> dict[str, Any]:
    return {
        "command": message.command,
        "number": message.number,
        "fields": _sent_on(message),
        "operations": list(map(operation_record, message.operations)),
    }


def _daisy_reply(message: DaisyReply) -> dict[str, Any]:
    fields = _sent_on(message)
    if message.report is not None:
        names = ("layer", "port", "status", "type", "mode", "data", "checksum", "busy")
        fields |= {name: _plain(getattr(message.report, name)) for name in names}
    return {"status": "error" if message.type and message.type.is_error else "ok", "fields": fields}


_CONTENTS: dict[type[Message], Callable[[Any], dict[str, Any]]] = {
    DirectCommand: _direct_command,
    DirectReply: _direct_reply,
    SystemCommand: _system_command,
    SystemReply: _system_reply,
    DaisyCommand: _daisy_command,
    DaisyReply: _daisy_reply,
}
"""What is in a message, by its class; there is nothing in one whose type is unknown."""


def _fields(message: SystemCommand | SystemReply) -> dict[str, Any]:
    return {name: _plain(value) for name, value in message.fields.items()}


def operation_record(operation: Operation) -> dict[str, Any]:
    """Returns the object of one operation."""
    entry: dict[str, Any] = {
        "op": operation.name,
        "opcode": operation.opcode,
        "command": operation.command,
        "offset": operation.offset,
        "length": operation.length,
        "args": [_argument(argument) for argument in operation.arguments],
    }
    for number, dataset in datasets_of(operation).items():
        entry["args"][number] |= {"quantity": dataset.name} | ({"unit": dataset.unit} if dataset.unit else {})
    cmd = operation.cmd if operation.is_complete else None
    if cmd is not None and cmd.length > 1:
        entry["command_encoding"] = cmd.encoding
    if not operation.is_complete:
        entry["complete"] = False
    return entry


def _argument(argument: Argument) -> dict[str, Any]:
    parameter, form, value, offset = argument.parameter, argument.form, argument.value, argument.offset
    entry: dict[str, Any] = {
        "name": parameter.name,
        "kind": form.kind,
        "encoding": form.name,
        "value": value if type(value) is int else _plain(value),
        "offset": offset,
        "length": argument.length,
    }
    if form.handle:
        entry["handle"] = True
    if form.address:
        entry["address"] = True
    symbol = argument.symbol
    if symbol is not None:
        entry["symbol"] = symbol
    return entry


def _value(value: Value) -> dict[str, Any]:
    entry = {
        "op": value.op,
        "command": value.command,
        "name": value.name,
        "value": _plain(value.value),
        "type": value.type,
        "offset": value.offset,
        "length": value.length,
    }
    known = {"unit": value.unit, "quantity": value.quantity, "symbol": value.symbol}
    return entry | {key: one for key, one in known.items() if one is not None}


def _plain(value: Any) -> Any:
    if isinstance(value, bytes):
        return value.hex()
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    if isinstance(value, list):
        return [_plain(item) for item in value]
    return value
