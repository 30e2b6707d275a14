"""JSON objects, as `ev3proto decode --json` prints them, back to the bytes of their frames."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from ev3proto.dialogue import Exchange
from ev3proto.errors import BuildError, near_misses
from ev3proto.messages import (
    GV,
    LV,
    DaisyCommand,
    DaisyReply,
    DirectCommand,
    DirectReply,
    Flaw,
    Message,
    Operation,
    PartialOperation,
    SystemCommand,
    SystemReply,
)
from ev3proto.schema.argument import ArgumentSchema, encode_as, encode_float, with_bits
from ev3proto.schema.fields import REPLIES, REQUESTS, Fields
from ev3proto.schema.frame import parse
from ev3proto.schema.instructions import OperationSchema, instruction_set
from ev3proto.schema.wire_format import NUMBERS
from ev3proto.tables.declaration import Parameter, Type
from ev3proto.tables.encoding import CONSTANT, GLOBAL, LOCAL, TEXT
from ev3proto.tables.frame import COUNTERS, MAX_GLOBALS, MAX_LOCALS, MessageType
from ev3proto.tables.system import SYSTEM, SYSTEM_BY_NUMBER, FieldKind, SystemField, SystemStatus
from ev3proto.text.json_format.from_messages import record
from ev3proto.text.phrases import Seen

MAX_RECORD = 1 << 22
"""Maximum characters of one object; the largest frame needs a tenth of them."""

_MOST_SAID = 500
_OUTSIDE = ("direction", "time", "values", "fault", "cut", "missing", "length")
"""Keys that describe more than the bytes, or follow from them."""

_FLOATS = ("nan", "inf", "-inf")
_OF_FLOATS = "LC4"
_ELEMENT = ArgumentSchema(Parameter("an element", Type.ARRAY_TYPED, "an element of a list"))
_UNKNOWN = Message().kind
_SPEAKERS = ("command", "reply")


Object = Mapping[str, Any]
"""An object of JSON."""


class RecordError(ValueError):
    """An object that does not describe a frame; the sentence names the faulty key and what would be right."""

    def __init__(self, reason: str, line: int | None = None, column: int | None = None) -> None:
        super().__init__(reason if len(reason) <= _MOST_SAID else f"{reason[:_MOST_SAID]}...")
        self.line = line  # of the text that is not JSON, the first is 1
        self.column = column


def read_records(lines: Iterable[str]) -> Iterator[tuple[int, Any]]:
    """Yields objects, one a line or as `jq` prints them, with their first lines. Raises RecordError."""
    kept: list[str] = []
    start = size = 0
    for number, line in enumerate(lines, 1):
        if not kept and not line.strip():
            continue
        start = start if kept else number
        kept.append(line)
        size += len(line)
        if size > MAX_RECORD:
            raise RecordError(f"the object has more than {MAX_RECORD} characters", start)
        # An object over several lines ends with a brace alone on a line; parsing is tried only there.
        if len(kept) > 1 and line.rstrip() != "}":
            continue
        try:
            found = json.loads("".join(kept).rstrip())
        except (ValueError, RecursionError) as error:
            if len(kept) == 1 and line.rstrip() == "{":
                continue
            raise _no_json(error, start) from None
        yield start, found
        kept, size = [], 0
    if kept:
        raise RecordError("the object that starts here never ends", start)


def _no_json(error: Exception, start: int) -> RecordError:
    if isinstance(error, json.JSONDecodeError):
        return RecordError(f"invalid JSON: {error.msg}", start + error.lineno - 1, error.colno)
    return RecordError("this JSON cannot be read: it is nested too deep, or a number is too long", start)


def frames_of_json(entry: Any, *, dialect: str = "official") -> Iterator[bytes]:
    """Yields the frames of one object: one, the two of a dialogue, or none for a text on WiFi. Raises RecordError.

    The object's keys decide. If they agree with its key `hex`, that is the frame, so every frame comes back byte for
    byte. If they were changed, the frame is built from them.
    """
    if not isinstance(entry, dict):
        raise RecordError(f"expected an object such as decode --json prints, not {_shown(entry)}")
    spoken = [entry[name] for name in _SPEAKERS if isinstance(entry.get(name), dict)]
    for one in spoken or [entry]:
        if not {"type", "hex", "rest"} & one.keys():
            raise RecordError("not a message: the object has neither type nor hex")
        if "type" in one or one.get("kind", _UNKNOWN) == _UNKNOWN:
            yield frame_of(one, dialect=dialect)


def frame_of(entry: Object, *, dialect: str = "official") -> bytes:
    """Makes the frame of one message's object. Raises RecordError."""
    if "hex" in entry:
        frame = _bytes(entry, "hex")
        if "type" not in entry or _is_told(entry, frame, dialect):
            return frame
    elif "type" not in entry:
        return _bytes(entry, "rest")
    try:
        return _made(entry, dialect)
    except BuildError as error:
        raise RecordError(str(error)) from None


def _is_told(entry: Object, frame: bytes, dialect: str) -> bool:
    """Tells whether the object's keys are those of its frame in `hex`."""
    message = parse(frame, strict=False, dialect=dialect)
    written = record(Exchange(message, None, [], None), Seen())
    return all(entry[key] == value for key, value in written.items() if key in entry and key not in _OUTSIDE)


# A frame from its keys


def _made(entry: Object, dialect: str) -> bytes:
    try:
        kind = MessageType[_text(entry, "type")]
    except KeyError:
        hint = near_misses(entry["type"], MessageType.__members__)
        raise RecordError(f"unknown message type {_shown(entry['type'])}{hint}") from None
    is_faulty = "fault" in entry
    length = _whole(entry, "length", 0xFFFF) if is_faulty and "length" in entry else None
    counter, flaw = _whole(entry, "counter", COUNTERS - 1, 0), Flaw(None, _bytes(entry, "rest"), length)
    message = replace(_MAKERS[kind.kind](entry, dialect), type=kind, counter=counter, flaw=flaw)
    frame = message.build()
    fault = parse(frame, strict=False, dialect=dialect).fault
    if fault is not None and not is_faulty:
        raise RecordError(f"the frame of this object would be at fault: {fault}")
    return frame


def _direct_command(entry: Object, dialect: str) -> Message:
    return DirectCommand(
        global_size=_whole(entry, "globals", MAX_GLOBALS, 0),
        local_size=_whole(entry, "locals", MAX_LOCALS, 0),
        operations=tuple(_operations(entry, dialect)),
    )


def _direct_reply(entry: Object, _dialect: str) -> Message:
    return DirectReply(memory=_bytes(entry, "memory"))


def _system_command(entry: Object, _dialect: str) -> Message:
    number = _number(entry)
    return SystemCommand(number=number, fields=_fields(entry, REQUESTS.get(number)))


def _system_reply(entry: Object, _dialect: str) -> Message:
    number = _number(entry)
    status = _whole(entry, "status_code", 0xFF, SystemStatus.SUCCESS)
    return SystemReply(number=number, status_code=status, fields=_fields(entry, REPLIES.get(number)))


def _daisy_command(entry: Object, dialect: str) -> Message:
    sent, code = _sent_on(entry), b"".join(one.raw for one in _operations(entry, dialect))
    return DaisyCommand(number=_whole(entry, "number", 0xFF), **sent | ({"payload": code} if code else {}))


def _daisy_reply(entry: Object, _dialect: str) -> Message:
    return DaisyReply(**_sent_on(entry))


def _sent_on(entry: Object) -> dict[str, Any]:
    fields = _object(entry, "fields")
    layers = {name: _whole(fields, name, 0xFF, 0) for name in ("layer_from", "layer_to")}
    return {**layers, "payload": _bytes(fields, "payload")}


_MAKERS: dict[str, Callable[[Object, str], Message]] = {
    "direct-command": _direct_command,
    "direct-reply": _direct_reply,
    "system-command": _system_command,
    "system-reply": _system_reply,
    "daisy-command": _daisy_command,
    "daisy-reply": _daisy_reply,
}


def _number(entry: Object) -> int:
    """Returns the number of a system command: as given, or by its name."""
    if "number" in entry:
        return _whole(entry, "number", 0xFF)
    name = _text(entry, "command")
    for known in SYSTEM:
        if known.name == name:
            return known.number
    raise RecordError(f"unknown system command {name}{near_misses(name, [known.name for known in SYSTEM])}")


def _fields(entry: Object, schema: Fields | None) -> dict[str, Any]:
    given = _object(entry, "fields")
    if schema is None:
        if given:
            raise RecordError(f"unknown system command 0x{_number(entry):02X}: its fields cannot be built")
        return {}
    values = {name: _field(schema.by_name.get(name), name, given) for name in given}
    completed = schema.completed(values)
    if "fault" in entry or entry.get("status_code") or MessageType[entry["type"]].is_error:
        return completed
    try:
        schema.write(values)  # for what it refuses
    except BuildError as error:
        name = SYSTEM_BY_NUMBER[_number(entry)].name
        raise RecordError(f"{name}: {error}") from None
    return completed


def _field(field: SystemField | None, name: str, given: Object) -> Any:
    if field is None or (field.kind not in NUMBERS and field.kind is not FieldKind.DATA):
        return given[name]
    return _bytes(given, name) if field.kind is FieldKind.DATA else _whole(given, name, 0xFFFFFFFF)


# Operations


def _operations(entry: Object, dialect: str) -> list[Operation]:
    operations = entry.get("operations", [])
    if not isinstance(operations, list):
        raise RecordError(f"operations takes a list, not {_shown(operations)}")
    found = []
    for index, operation in enumerate(operations):
        if not isinstance(operation, dict):
            raise RecordError(f"operations[{index}] takes an object, not {_shown(operation)}")
        try:
            found.append(_operation(operation, dialect))
        except (BuildError, RecordError) as error:
            raise RecordError(f"operations[{index}]: {error}") from None
    return found


def _operation(entry: Object, dialect: str) -> Operation:
    name = _text(entry, "op")
    if entry.get("command") is not None:
        name += f".{_text(entry, 'command')}"
    try:
        schema = instruction_set(dialect)[name]
    except KeyError as error:
        raise RecordError(error.args[0]) from None
    arguments = entry.get("args", [])
    if not isinstance(arguments, list):
        raise RecordError(f"args takes a list, not {_shown(arguments)}")
    head = _head(schema, entry)
    if entry.get("complete") is False:
        raw = head + b"".join(_written(schema, arguments))
        return PartialOperation((schema, raw, 0, len(raw)))
    raw = head + schema.write(list(_written(schema, arguments)))[len(schema.head) :]
    return Operation((schema, raw, 0, len(raw)))


def _head(schema: OperationSchema, entry: Object) -> bytes:
    """Returns opcode and CMD, which may be encoded longer than necessary."""
    command = schema.declaration.command
    if command is None or "command_encoding" not in entry:
        return schema.head
    return schema.head[:1] + encode_as(_text(entry, "command_encoding"), command.number)


def _written(schema: OperationSchema, arguments: Sequence[Any]) -> Iterator[bytes]:
    for index, argument in enumerate(arguments):
        one = schema.fixed[index] if index < len(schema.fixed) else _ELEMENT
        given = argument if isinstance(argument, dict) else {"value": argument}
        if "value" not in given:
            raise RecordError(f"args[{index}] lacks its value")
        yield _argument(given, one)


def _argument(argument: Object, schema: ArgumentSchema) -> bytes:
    value = argument["value"]
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        raise RecordError(f"{schema.parameter.name} cannot be {_shown(value)}: it is a number or a text")
    kind = argument.get("kind")
    marks = {name: argument.get(name) is True for name in ("handle", "address")}
    if "encoding" not in argument:
        if kind in (LOCAL, GLOBAL):
            return schema.write((GV if kind == GLOBAL else LV)(_whole(argument, "value", 0xFFFFFFFF), **marks))
        return schema.write(value)
    encoded = _encoded(value, kind, _text(argument, "encoding"), schema)
    return with_bits(encoded, **marks) if any(marks.values()) else encoded


def _encoded(value: float | str, kind: Any, encoding: str, schema: ArgumentSchema) -> bytes:
    """Returns the bytes of a value in the encoding that its object names."""
    if (kind == TEXT) != isinstance(value, str) and value not in _FLOATS:
        raise RecordError(f"{schema.parameter.name} cannot be {_shown(value)}, which is not a {kind}")
    if kind == CONSTANT and value in _FLOATS:
        value = float(value)
    # A float is four bytes, and other programs write 1 for 1.0.
    is_float = schema.parameter.type is Type.DATAF and kind == CONSTANT and encoding == _OF_FLOATS
    if isinstance(value, float) or is_float:
        return encode_float(float(value), schema.parameter.name)
    return encode_as(encoding, value)


# Keys


def _shown(value: Any) -> str:
    text = json.dumps(value, ensure_ascii=False, default=str)
    return text if len(text) <= 40 else f"{text[:40]}..."


def _text(entry: Object, key: str, default: str | None = None) -> str:
    value = entry.get(key, default)
    if not isinstance(value, str):
        raise RecordError(f"{key} takes a text, not {_shown(value)}")
    return value


def _object(entry: Object, key: str) -> Object:
    value = entry.get(key, {})
    if not isinstance(value, dict):
        raise RecordError(f"{key} takes an object, not {_shown(value)}")
    return value


def _bytes(entry: Object, key: str) -> bytes:
    try:
        return bytes.fromhex(_text(entry, key, ""))
    except ValueError:
        raise RecordError(f"{key} takes bytes in hex, not {_shown(entry.get(key))}") from None


def _whole(entry: Object, key: str, most: int, default: int | None = None) -> int:
    value = entry.get(key, default)
    if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value <= most:
        raise RecordError(f"{key} cannot be {_shown(value)}: it is a whole number from 0 to {most}")
    return value
