"""Schemas of what `decode --json` prints: messages, WiFi texts, dialogues, programs."""

from __future__ import annotations

from ev3proto.capture.record import TextKind
from ev3proto.generate.output_schemas.parts import (
    FLAG,
    HEX,
    NOT_FINITE,
    NUMBER,
    TEXT,
    TIME,
    WHOLE,
    Schema,
    by_name,
    list_of,
    maybe,
    object_of,
    reference,
)
from ev3proto.messages import Message
from ev3proto.tables.carriers import CARRIERS
from ev3proto.tables.daisy import DaisySubCommand
from ev3proto.tables.declaration import Direction, Type
from ev3proto.tables.frame import TYPES_BY_KIND
from ev3proto.tables.mailboxes import LOGIC_MESSAGE, NUMBER_MESSAGE, TEXT_MESSAGE
from ev3proto.tables.system import SYSTEM, SystemStatus

_BYTE: Schema = {"type": "integer", "minimum": 0, "maximum": 255}
_DIRECTION: Schema = {"enum": ["sent", "received"]}
_FAULT: Schema = object_of({"offset": WHOLE, "reason": TEXT})

_PLACE: Schema = {
    "packets": list_of(WHOLE),
    "interface": maybe(TEXT),
    "carrier": {"enum": [*CARRIERS]},
    "source": maybe(TEXT),
    "target": maybe(TEXT),
    "peer": maybe(TEXT),
}
"""Keys for the place of a frame in a capture."""

_SEEN: Schema = {"direction": maybe(_DIRECTION), "label": TEXT, "time": TEXT, **_PLACE, "connection": WHOLE}
"""Keys of messages from a log or a capture."""

_LINKED: Schema = {"answers": WHOLE, "latency": maybe(NUMBER), "note": TEXT}
"""Keys of replies whose command was captured, and of frames with remarks."""

_ODD: Schema = {"fault": _FAULT, "cut": FLAG, "missing": WHOLE, "rest": HEX}
"""Keys of faulty frames."""

_OUTCOME: Schema = {"enum": ["ok", "error"]}


def definitions() -> Schema:
    """Returns the schemas by their names under `$defs`."""
    return {
        "decode": {"anyOf": [reference(name) for name in ("message", "text", "dialogue", "program")]},
        "message": {"anyOf": [reference(kind) for kind in (*_contents(), Message().kind)]},
        **{kind: _message(kind, contents) for kind, contents in _contents().items()},
        Message().kind: _unknown(),
        "operation": _operation(),
        "argument": _argument(),
        "value": _value(),
        "text": _text(),
        "dialogue": _dialogue(),
        "program": _program(),
    }


def _contents() -> Schema:
    """Returns the keys that only messages of each kind have."""
    fields = {field.name for entry in SYSTEM for field in (*entry.request, *entry.reply)}
    values: Schema = {"type": ["string", "integer"]}
    system: Schema = {"command": maybe(TEXT), "number": _BYTE, "fields": by_name(values, fields)}
    daisy = ("layer_from", "layer_to", "payload")
    report = ("layer", "port", "status", "type", "mode", "data", "checksum", "busy")
    return {
        "direct-command": {"globals": WHOLE, "locals": WHOLE, "operations": list_of(reference("operation"))},
        "direct-reply": {"status": _OUTCOME, "memory": HEX, "readings": _guesses()},
        "system-command": {**system, "readings": _readings()},
        "system-reply": {
            **system,
            "status": _OUTCOME,
            "status_name": {"enum": [status.name for status in SystemStatus]},
            "status_code": _BYTE,
            "status_meaning": maybe(TEXT),
        },
        "daisy-command": {
            "command": maybe({"enum": [member.name for member in DaisySubCommand]}),
            "number": _BYTE,
            "fields": by_name(values, daisy),
            "operations": list_of(reference("operation")),
        },
        "daisy-reply": {"status": _OUTCOME, "fields": by_name({"type": ["string", "integer"]}, (*daisy, *report))},
    }


def _readings() -> Schema:
    """Returns the schema of a mailbox message's possible meanings; a number that is not finite is a text."""
    kinds: Schema = {TEXT_MESSAGE: TEXT, NUMBER_MESSAGE: {"anyOf": [NUMBER, NOT_FINITE]}, LOGIC_MESSAGE: FLAG}
    return object_of(kinds, *kinds)


def _guesses() -> Schema:
    """Returns the schema of what the memory of a reply may hold, by type: a text, a number, or several."""
    number: Schema = {"anyOf": [NUMBER, NOT_FINITE]}
    numbers: Schema = {"anyOf": [number, list_of(number)]}
    kinds = {kind.label: numbers for kind in (Type.DATAF, Type.DATA32, Type.DATA16, Type.DATA8)}
    return object_of({Type.STRING.label: TEXT, **kinds}, Type.STRING.label, *kinds)


def _message(kind: str, contents: Schema) -> Schema:
    types = [member.name for member in TYPES_BY_KIND[kind]]
    properties: Schema = {
        "kind": {"const": kind},
        "type": {"enum": types},
        "length": WHOLE,
        "counter": WHOLE,
        **_SEEN,
        **contents,
        "values": list_of(reference("value")),
        **_LINKED,
        **_ODD,
        "hex": HEX,
    }
    # A frame that ends early lacks its last keys.
    always = {"kind", "type", "length", "counter", "hex"}
    return object_of(properties, *(name for name in properties if name not in always))


def _unknown() -> Schema:
    properties: Schema = {"kind": {"const": Message().kind}, "length": WHOLE, **_SEEN, **_LINKED, **_ODD, "hex": HEX}
    return object_of(properties, *(name for name in properties if name not in ("kind", "hex")))


def _operation() -> Schema:
    properties: Schema = {
        "op": TEXT,
        "opcode": _BYTE,
        "command": maybe(TEXT),
        "offset": WHOLE,
        "length": WHOLE,
        "args": list_of(reference("argument")),
        "command_encoding": TEXT,
        "complete": {"const": False},
        "target": TEXT,
    }
    return object_of(properties, "command_encoding", "complete", "target")


def _argument() -> Schema:
    properties: Schema = {
        "name": TEXT,
        "kind": {"enum": ["constant", "string", "local", "global", "label"]},
        "encoding": TEXT,
        "value": {"type": ["number", "string"]},
        "offset": WHOLE,
        "length": WHOLE,
        "handle": {"const": True},
        "address": {"const": True},
        "symbol": TEXT,
        "quantity": TEXT,
        "unit": TEXT,
    }
    return object_of(properties, "handle", "address", "symbol", "quantity", "unit")


def _value() -> Schema:
    one: Schema = {"anyOf": [NUMBER, TEXT]}
    properties: Schema = {
        "op": TEXT,
        "command": maybe(TEXT),
        "name": TEXT,
        "value": {"anyOf": [one, list_of({"anyOf": [NUMBER, NOT_FINITE]})]},
        "type": TEXT,
        "offset": WHOLE,
        "length": WHOLE,
        "unit": TEXT,
        "quantity": TEXT,
        "symbol": {"anyOf": [TEXT, list_of(maybe(TEXT))]},
    }
    return object_of(properties, "unit", "quantity", "symbol")


def _text() -> Schema:
    properties: Schema = {
        "kind": {"enum": [said.name.lower() for said in TextKind]},
        "direction": maybe(_DIRECTION),
        "time": TIME,
        **_PLACE,
        "text": by_name(TEXT, ("serial", "port", "name", "protocol")),
        "hex": HEX,
    }
    return object_of(properties)


def _dialogue() -> Schema:
    properties: Schema = {
        "command": reference("message"),
        "reply": reference("message"),
        "latency": maybe(NUMBER),
    }
    return object_of(properties, "command", "reply")


def _program() -> Schema:
    parameter = object_of(
        {"type": TEXT, "direction": {"enum": [str(each) for each in Direction]}, "offset": WHOLE, "size": WHOLE}
    )
    part: Schema = {
        "number": WHOLE,
        "kind": TEXT,
        "owner": WHOLE,
        "triggers": WHOLE,
        "locals": WHOLE,
        "offset": WHOLE,
        "parameters": list_of(parameter),
        "shares": WHOLE,
        "length": WHOLE,
        "calls": list_of(WHOLE),
        "operations": list_of(reference("operation")),
        "rest": HEX,
        "fault": _FAULT,
    }
    properties: Schema = {
        "kind": {"const": "program"},
        "size": WHOLE,
        "version": WHOLE,
        "globals": WHOLE,
        "objects": list_of(object_of(part, "shares", "length", "calls", "operations", "rest", "fault")),
        "faults": list_of(_FAULT),
        "origin": TEXT,
    }
    return object_of(properties, "origin")
