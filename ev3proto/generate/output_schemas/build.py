"""The schema file: a schema for each command under `$defs`, made of those of messages, texts and programs."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import fields, is_dataclass
from types import NoneType, UnionType
from typing import Any, get_args, get_origin, get_type_hints

from ev3proto.capture.record import TextKind
from ev3proto.capture.statistics import Summary
from ev3proto.checking.report import Change, Severity
from ev3proto.generate.tables_json.shapes import ref, written
from ev3proto.messages import Message
from ev3proto.tables.carriers import CARRIERS
from ev3proto.tables.daisy import DaisySubCommand
from ev3proto.tables.declaration import Direction, Type
from ev3proto.tables.frame import TYPES_BY_KIND
from ev3proto.tables.mailboxes import LOGIC_MESSAGE, NUMBER_MESSAGE, TEXT_MESSAGE
from ev3proto.tables.system import SYSTEM, SystemStatus
from ev3proto.version import VERSION

FILE_NAME = "ev3-output.schema.json"

_COMMANDS = ("decode", "check", "check_counts", "stats", "values")

Schema = dict[str, Any]

WHOLE: Schema = {"type": "integer", "minimum": 0}
TEXT: Schema = {"type": "string"}
NUMBER: Schema = {"type": "number"}
FLAG: Schema = {"type": "boolean"}
HEX: Schema = {"type": "string", "pattern": "^([0-9a-f]{2})*$"}
TIME: Schema = {"type": "string", "pattern": "^([0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9:.]+Z|-?[0-9]+[.][0-9]{6,9})$"}
NOT_FINITE: Schema = {"enum": ["nan", "inf", "-inf"]}

_PLAIN = {int: {"type": "integer"}, float: NUMBER, str: TEXT, bool: FLAG}


def object_of(properties: Schema, *optional: str) -> Schema:
    """Returns an object with these keys and no others."""
    required = [name for name in properties if name not in optional]
    return {"type": "object", "properties": properties, "required": required, "additionalProperties": False}


def by_name(values: Schema, names: Iterable[str] | None = None) -> Schema:
    """Returns an object whose keys are names: any, or some of these."""
    found: Schema = {"type": "object", "additionalProperties": values}
    return found if names is None else found | {"propertyNames": {"enum": sorted(set(names))}}


def list_of(items: Schema) -> Schema:
    """Returns a list."""
    return {"type": "array", "items": items}


def maybe(schema: Schema) -> Schema:
    """Returns the same schema, or null."""
    return {"anyOf": [schema, {"type": "null"}]}


def of_dataclass(kind: type) -> Schema:
    """Returns the schema of what `dataclasses.asdict` makes of a class, by its annotations."""
    hints = get_type_hints(kind)
    return object_of({field.name: _of_type(hints[field.name]) for field in fields(kind)})


def _of_type(hint: Any) -> Schema:
    if hint in _PLAIN:
        return _PLAIN[hint]
    if is_dataclass(hint) and isinstance(hint, type):
        return of_dataclass(hint)
    arguments = get_args(hint)
    match get_origin(hint):
        case origin if origin is list:
            return list_of(_of_type(arguments[0]))
        case origin if origin is dict:
            return by_name(_of_type(arguments[1]))
        case origin if origin is UnionType:
            (inner,) = (argument for argument in arguments if argument is not NoneType)
            return maybe(_of_type(inner))
    raise TypeError(f"cannot describe {hint} by a schema")


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
        "decode": {"anyOf": [ref(name) for name in ("message", "text", "dialogue", "program")]},
        "message": {"anyOf": [ref(kind) for kind in (*_contents(), Message().kind)]},
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
        "direct-command": {"globals": WHOLE, "locals": WHOLE, "operations": list_of(ref("operation"))},
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
            "operations": list_of(ref("operation")),
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
        "values": list_of(ref("value")),
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
        "args": list_of(ref("argument")),
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
        "command": ref("message"),
        "reply": ref("message"),
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
        "operations": list_of(ref("operation")),
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


def build() -> str:
    """Returns the text of the file."""
    commands: Schema = {
        "check": _check(),
        "check_counts": _counts(),
        "finding": _finding(),
        "stats": of_dataclass(Summary),
        "values": _values(),
    }
    return written(
        {
            "$schema": "https://json-schema.org/draft/2020-12/schema",
            "title": f"What ev3proto {VERSION} prints with --json",
            "description": "$defs/decode, check and values: a line of each; $defs/stats: all of stats;"
            " $defs/check_counts: all of check --quiet.",
            "anyOf": [ref(name) for name in _COMMANDS],
            "$defs": definitions() | commands,
        }
    )


def _check() -> Schema:
    properties: Schema = {
        "source": TEXT,
        "packet": WHOLE,
        "line": WHOLE,
        "column": WHOLE,
        "accepted": FLAG,
        "rejected_at": maybe(WHOLE),
        "findings": list_of(ref("finding")),
        "nearest": list_of(_suggestion()),
        "hex": HEX,
        "fixed": FLAG,
        "changes": list_of(object_of({field.name: TEXT for field in fields(Change)})),
        "unfixed": list_of(TEXT),
        "omitted": WHOLE,
    }
    maybe_absent = ("source", "packet", "line", "column", "nearest", "fixed", "changes", "unfixed", "omitted")
    return object_of(properties, *maybe_absent)


def _suggestion() -> Schema:
    span = list_of(WHOLE)
    facts = {"kind": TEXT, "offset": WHOLE, "length": WHOLE, "message": TEXT, "hex": HEX}
    return object_of(facts | {"unknown": list_of(span), "sure": FLAG, "harm": TEXT}, "harm")


def _counts() -> Schema:
    names = ("frames", "programs", "replies", *(f"{severity}s" for severity in Severity))
    return object_of(dict.fromkeys(names, WHOLE))


def _finding() -> Schema:
    properties: Schema = {
        "severity": {"enum": [severity.value for severity in Severity]},
        "code": {"type": "string", "pattern": "^([EWH][0-9]{3}|source)$"},
        "offset": WHOLE,
        "length": WHOLE,
        "message": TEXT,
        "help": TEXT,
        "operation": TEXT,
        "parameter": TEXT,
        "line": WHOLE,
        "column": WHOLE,
    }
    return object_of(properties, "operation", "parameter", "line", "column")


def _values() -> Schema:
    one = {"anyOf": [NUMBER, TEXT, list_of({"anyOf": [NUMBER, NOT_FINITE]})]}
    properties = {"file": TEXT, "time": maybe(TIME), "packet": WHOLE, "peer": TEXT, "values": by_name(one)}
    return object_of(properties, "file")
