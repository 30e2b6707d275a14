"""Frames, the bodies of all message types, arguments, and the meaning of their first byte."""

from __future__ import annotations

from construct import Bytes, GreedyBytes

from ev3proto.generate.kaitai.naming import field_name, identifier, system_name
from ev3proto.generate.kaitai.yaml import Block, Hexadecimal, Value
from ev3proto.schema.wire_format import SENSOR_REPORT
from ev3proto.tables import daisy
from ev3proto.tables.encoding import CONSTANT, IDENTIFICATIONS, TEXT, Encoding
from ev3proto.tables.frame import GLOBAL_BITS, MAX_GLOBALS, MAX_LENGTH, MIN_LENGTH, MessageType
from ev3proto.tables.system import SYSTEM, FieldKind, SystemDeclaration, SystemField, SystemStatus

Mapping = dict[str | int, Value]

_REQUEST, _REPLY = "request", "reply"
_REST: Mapping = {"size-eos": True}


def message_types() -> Mapping:
    """Returns all types except those of operations."""
    bodies: Mapping = {f"message_type::{member.name.lower()}": member.kind.replace("-", "_") for member in MessageType}
    return {
        "frame": {
            "doc": Block(
                "A length that counts the bytes after it, then these bytes. Zero lengths may precede it, which\n"
                "the brick ignores; at the end of a stream, they are a frame without a message."
            ),
            "seq": [
                {
                    "id": "lengths",
                    "type": "u2",
                    "repeat": "until",
                    "repeat-until": "_ != 0 or _io.eof",
                    "valid": {"expr": f"_ == 0 or _ >= {MIN_LENGTH}"},
                },
                {"id": "message", "type": "message", "size": "length", "if": "length != 0"},
            ],
            "instances": {
                "length": {
                    "value": "lengths.last",
                    "doc": f"At most {MAX_LENGTH}, except for downloads of files over WiFi.",
                }
            },
        },
        "message": {
            "seq": [
                {"id": "counter", "type": "u2", "doc": "Of the sender; the reply has the same."},
                {"id": "kind", "type": "u1", "enum": "message_type", "valid": {"in-enum": True}},
                {"id": "body", "type": {"switch-on": "kind", "cases": bodies}},
            ]
        },
        "direct_command": {
            "seq": [
                {"id": "memory", "type": "u2"},
                {"id": "operations", "type": "operation", "repeat": "eos"},
            ],
            "instances": {
                "global_size": {"value": f"memory & {MAX_GLOBALS}", "doc": "Bytes of global memory: the reply's."},
                "local_size": {"value": f"memory >> {GLOBAL_BITS}", "doc": "Bytes of local memory."},
            },
        },
        "direct_reply": {
            "doc": "Only the command tells what these bytes mean, by its outputs in global memory.",
            "seq": [{"id": "memory", **_REST}],
        },
        **_system(),
        **_daisy(),
        "argument": _argument(),
    }


def enumeration_types() -> Mapping:
    """Returns the enumerations of the numbers before fields and operations."""
    return {
        "message_type": {Hexadecimal(member.value): member.name.lower() for member in MessageType},
        "system_code": {Hexadecimal(entry.number): {"id": system_name(entry), "doc": entry.text} for entry in SYSTEM},
        "system_status": {status.value: status.name.lower() for status in SystemStatus},
        "daisy_code": {
            Hexadecimal(entry.value): {"id": entry.name.lower(), "doc": daisy.TEXTS[entry]}
            for entry in daisy.DaisySubCommand
        },
    }


# System commands


def _system() -> Mapping:
    number: Mapping = {"id": "command", "type": "u1", "enum": "system_code", "valid": {"in-enum": True}}
    status: Mapping = {"id": "status", "type": "u1", "enum": "system_status"}
    request: Mapping = {"id": "fields", "type": {"switch-on": "command", "cases": _cases(_REQUEST)}}
    reply: Mapping = {"id": "fields", "type": {"switch-on": "command", "cases": _cases(_REPLY)}, "if": "not _io.eof"}
    found: Mapping = {
        "system_command": {"seq": [number, request]},
        "system_reply": {"doc": "A failed one may end before any field.", "seq": [number, status, reply]},
    }
    for entry in SYSTEM:
        for side, fields in ((_REQUEST, entry.request), (_REPLY, entry.reply)):
            if fields:
                seq: list[Value] = [_field(field, fields, is_reply=side == _REPLY) for field in fields]
                found[_type(entry, side)] = {"doc": entry.text, "seq": seq}
    text = 'is_counted ? bytes.to_s("ISO-8859-1").substring(0, length - 1) : bytes.to_s("ISO-8859-1")'
    found["counted_text"] = {
        "doc": "A text preceded by its length. Some senders count its zero, some do not; the zero is always there.",
        "params": [{"id": "length", "type": "u1"}],
        "seq": [
            {"id": "bytes", "size": "length"},
            {"id": "zero", "type": "u1", "valid": 0, "if": "not is_counted"},
        ],
        "instances": {
            "is_counted": {"value": "length > 0 and bytes[length - 1] == 0"},
            "text": {"value": text},
        },
    }
    return found


def _type(entry: SystemDeclaration, side: str) -> str:
    return f"{side}_{system_name(entry)}"


def _cases(side: str) -> Mapping:
    return {
        f"system_code::{system_name(entry)}": _type(entry, side)
        for entry in SYSTEM
        if (entry.request if side == _REQUEST else entry.reply)
    }


_NUMBERS = {FieldKind.U8: "u1", FieldKind.U16: "u2", FieldKind.U32: "u4"}


def _field(field: SystemField, fields: tuple[SystemField, ...], *, is_reply: bool) -> Mapping:
    found: Mapping = {"id": field_name(field)}
    counter = next((field_name(other) for other in fields if other.counts == field.name), None)
    if field.kind in _NUMBERS:
        found["type"] = _NUMBERS[field.kind]
    elif field.kind is FieldKind.TEXT:
        found["type"] = "strz"
    elif field.kind is FieldKind.COUNTED_TEXT:
        found["type"] = f"counted_text({counter})"
    elif counter is not None:
        found["size"] = counter
    else:
        found |= _REST
        if field.kind is FieldKind.LISTING:
            found["type"] = "str"
    if is_reply or field.optional:
        found["if"] = "not _io.eof"
    return found | {"doc": field.text}


# Daisy chain


def _daisy() -> Mapping:
    layers: list[Value] = [{"id": "layer_from", "type": "u1"}, {"id": "layer_to", "type": "u1"}]
    carrying = [
        f"command == daisy_code::{entry.name.lower()}" for entry in daisy.DaisySubCommand if entry.carries_operations
    ]
    carries = " or ".join(carrying)
    size = sum(part.sizeof() for part in SENSOR_REPORT.subcons if part.subcon is not GreedyBytes)
    parts: list[Value] = []
    for part in SENSOR_REPORT.subcons:
        rest: Mapping = {"size": part.subcon.length} if isinstance(part.subcon, Bytes) else {"type": "u1"}
        parts.append({"id": identifier(part.name), **(_REST if part.subcon is GreedyBytes else rest)})
    return {
        "daisy_command": {
            "seq": [
                {"id": "command", "type": "u1", "enum": "daisy_code", "valid": {"in-enum": True}},
                *layers,
                {"id": "operations", "type": "operation", "repeat": "eos", "if": carries},
                {"id": "payload", **_REST, "if": f"not ({carries})"},
            ]
        },
        "daisy_reply": {
            "seq": [
                *layers,
                {"id": "report", "type": "sensor_report", "if": f"_io.size - _io.pos >= {size}"},
                {"id": "payload", **_REST},
            ]
        },
        "sensor_report": {"seq": parts},
    }


# Arguments

_TEXT = 8
"""In `form`: a string. Values below it are widths of constants, values above it those of variables."""


_WIDTH_BITS = 7


def _is_long_constant(encoding: Encoding) -> bool:
    return encoding.kind == CONSTANT and encoding.width != 0


def _argument() -> Mapping:
    codes = {row.encoding.width: row.first & _WIDTH_BITS for row in IDENTIFICATIONS if _is_long_constant(row.encoding)}
    widths = sorted(codes.values())
    cases: Mapping = {code: f"s{width}" for width, code in codes.items()}
    cases |= {_TEXT + code: f"u{width}" for width, code in codes.items()}
    one_byte, four_bytes = codes[1], codes[4]
    texts = sorted({row.first & _WIDTH_BITS for row in IDENTIFICATIONS if row.encoding.kind == TEXT})
    is_text = f"({' or '.join(f'width == {code}' for code in texts)})"
    form = f"not is_long ? 0 : is_variable ? {_TEXT} + width : is_label ? {one_byte} : {is_text} ? {_TEXT} : width"
    defined = " or ".join(f"width == {width}" for width in widths)
    return {
        "doc": Block(
            "One argument: constant, string, local or global variable, or label.\n"
            "The bits of its first byte say which, and how many bytes follow."
        ),
        "params": [{"id": "is_float", "type": "bool", "doc": "Whether a constant of four bytes is a float."}],
        "seq": [
            {"id": "is_long", "type": "b1"},
            {"id": "is_variable", "type": "b1"},
            {"id": "selector", "type": "b1", "doc": "Of variables: global. Of long constants: label."},
            {"id": "is_handle_bit", "type": "b1", "if": "is_long"},
            {"id": "is_address_bit", "type": "b1", "if": "is_long"},
            {
                "id": "width",
                "type": "b3",
                "if": "is_long",
                "valid": {"expr": f"is_label or {defined} or (not is_variable and {is_text})"},
            },
            {"id": "short_value", "type": "b5", "if": "not is_long"},
            {
                "id": "float_value",
                "type": "f4",
                "if": f"is_float and form == {four_bytes}",
            },
            {
                "id": "number",
                "type": {"switch-on": "form", "cases": cases},
                "if": f"form != 0 and form != {_TEXT} and not (is_float and form == {four_bytes})",
            },
            {"id": "text", "type": "strz", "if": f"form == {_TEXT}"},
        ],
        "instances": {
            "is_label": {"value": "is_long and not is_variable and selector"},
            "is_global": {"value": "is_variable and selector"},
            "is_handle": {"value": "is_long and is_handle_bit"},
            "is_address": {"value": "is_long and is_address_bit"},
            "is_number": {
                "value": f"not is_variable and not is_label and form != {_TEXT}"
                f" and not (is_float and form == {four_bytes})",
                "doc": "Whether it is a whole number, which may be that of an enumeration's member.",
            },
            "form": {"value": form},
            "value": {
                "value": "is_long ? number : is_variable ? short_value : selector ? short_value - 32 : short_value",
                "if": f"form != {_TEXT} and not (is_float and form == {four_bytes})",
                "doc": "A number, an index, or how far to jump. Strings are in text, floats in float_value.",
            },
        },
    }
