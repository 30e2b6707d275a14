"""JSON Schemas of what `decode --json`, `check --json` and `stats --json` print, for programs that read it.

More keys may be added to what is printed, and none is renamed: the schemas let further keys through.
"""

from __future__ import annotations

from typing import Any

from ev3proto.checking.report import Severity
from ev3proto.generate.tables_json.writing import written
from ev3proto.messages import Message
from ev3proto.tables.carriers import CARRIERS
from ev3proto.tables.frame import MessageType
from ev3proto.tables.system import SystemStatus

FILE_NAME = "ev3-output.schema.json"

Schema = dict[str, Any]

_WHOLE: Schema = {"type": "integer", "minimum": 0}
_TEXT: Schema = {"type": "string"}
_NUMBER: Schema = {"type": "number"}
_FLAG: Schema = {"type": "boolean"}
_HEX: Schema = {"type": "string", "pattern": "^([0-9a-f]{2})*$"}


def build() -> str:
    """The text of the file: a schema for each under `$defs`."""
    return written(
        {
            "$schema": "https://json-schema.org/draft/2020-12/schema",
            "title": "What ev3proto prints with --json",
            "description": "$defs/decode: a line of decode; $defs/check: a line of check; $defs/stats: all of stats.",
            "anyOf": [{"$ref": f"#/$defs/{name}"} for name in ("decode", "check", "stats")],
            "$defs": {
                "decode": _decode(),
                "operation": _operation(),
                "argument": _argument(),
                "value": _value(),
                "check": _check(),
                "finding": _finding(),
                "stats": _stats(),
                "summary": _summary(),
                "amount": _object({"messages": _WHOLE, "bytes": _WHOLE}),
                "latency": _latency(),
            },
        }
    )


def _object(properties: Schema, *optional: str) -> Schema:
    return {
        "type": "object",
        "properties": properties,
        "required": [name for name in properties if name not in optional],
    }


def _list(of: str) -> Schema:
    return {"type": "array", "items": {"$ref": f"#/$defs/{of}"}}


def _maybe(schema: Schema) -> Schema:
    return {"anyOf": [schema, {"type": "null"}]}


def _decode() -> Schema:
    kinds = list(dict.fromkeys([*(member.kind for member in MessageType), Message().kind]))
    fault = _object({"offset": _WHOLE, "reason": _TEXT})
    properties: Schema = {
        "kind": {"enum": kinds},
        "type": _maybe({"enum": [member.name for member in MessageType]}),
        "length": _WHOLE,
        "counter": _WHOLE,
        "hex": _HEX,
        "globals": _WHOLE,
        "locals": _WHOLE,
        "operations": _list("operation"),
        "command": _maybe(_TEXT),
        "fields": {"type": "object"},
        "status": {"enum": ["ok", "error", *(status.name for status in SystemStatus)]},
        "values": _list("value"),
        "fault": fault,
        "direction": _maybe({"enum": ["sent", "received"]}),
        "time": _TEXT,
        "packets": {"type": "array", "items": _WHOLE},
        "interface": _maybe(_TEXT),
        "carrier": {"enum": [*CARRIERS]},
        "source": _TEXT,
        "target": _TEXT,
        "peer": _TEXT,
        "answers": _WHOLE,
        "latency": _maybe(_NUMBER),
        "note": _TEXT,
    }
    return {**_object(properties), "required": ["kind", "hex"]}


def _operation() -> Schema:
    return _object(
        {
            "op": _TEXT,
            "opcode": {"type": "integer", "minimum": 0, "maximum": 255},
            "command": _maybe(_TEXT),
            "offset": _WHOLE,
            "length": _WHOLE,
            "args": _list("argument"),
        },
        "command",
    )


def _argument() -> Schema:
    kinds = ["constant", "string", "local", "global", "label"]
    properties: Schema = {
        "name": _TEXT,
        "kind": {"enum": kinds},
        "encoding": _TEXT,
        "value": {"type": ["number", "string", "null"]},
        "offset": _WHOLE,
        "length": _WHOLE,
        "handle": _FLAG,
        "address": _FLAG,
    }
    return _object(properties, "handle", "address")


def _value() -> Schema:
    values = {"type": ["number", "string", "array", "null"]}
    return _object({"op": _TEXT, "command": _maybe(_TEXT), "name": _TEXT, "value": values}, "command")


def _check() -> Schema:
    properties: Schema = {
        "accepted": _FLAG,
        "rejected_at": _maybe(_WHOLE),
        "findings": _list("finding"),
        "hex": _HEX,
    }
    return _object(properties)


def _finding() -> Schema:
    properties: Schema = {
        "severity": {"enum": [severity.value for severity in Severity]},
        "code": {"type": "string", "pattern": "^[EWH][0-9]{3}$"},
        "offset": _WHOLE,
        "length": _WHOLE,
        "message": _TEXT,
        "mend": _TEXT,
        "operation": _TEXT,
        "parameter": _TEXT,
    }
    return _object(properties, "operation", "parameter")


def _stats() -> Schema:
    return {**_object({"whole": {"$ref": "#/$defs/summary"}}), "additionalProperties": True}


def _summary() -> Schema:
    counted: Schema = {"type": "object", "additionalProperties": {"$ref": "#/$defs/amount"}}
    operation = _object(
        {
            "name": _TEXT,
            "kind": _TEXT,
            "uses": _WHOLE,
            "commands": _WHOLE,
            "replies": _WHOLE,
            "errors": _WHOLE,
            "unanswered": _WHOLE,
            "bytes": _WHOLE,
            "latency": _maybe({"$ref": "#/$defs/latency"}),
        },
        "latency",
    )
    properties: Schema = {
        "name": _TEXT,
        "messages": {"$ref": "#/$defs/amount"},
        "kinds": counted,
        "operations": {"type": "array", "items": operation},
    }
    return _object(properties)


def _latency() -> Schema:
    names = ("min", "median", "p90", "p99", "max")
    return _object({"count": _WHOLE, **dict.fromkeys(names, _NUMBER), "exact": _FLAG})
