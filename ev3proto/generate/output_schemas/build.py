"""The schema file: a schema for each command under `$defs`."""

from __future__ import annotations

from dataclasses import fields

from ev3proto.capture.statistics import Summary
from ev3proto.checking.report import Change, Severity
from ev3proto.generate.output_schemas.messages import definitions
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
    of_dataclass,
    reference,
)
from ev3proto.generate.tables_json.shapes import written
from ev3proto.version import VERSION

FILE_NAME = "ev3-output.schema.json"

_COMMANDS = ("decode", "check", "check_counts", "stats", "values")


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
            "anyOf": [reference(name) for name in _COMMANDS],
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
        "findings": list_of(reference("finding")),
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
