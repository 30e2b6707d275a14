"""The JSON Schema (draft 2020-12) of the tables: the properties of each entry, and their meaning."""

from __future__ import annotations

from typing import Any

from ev3proto.schema.argument import ENCODINGS
from ev3proto.tables import AREAS
from ev3proto.tables.declaration import DIALECTS, Direction, Effect, Role, Type
from ev3proto.tables.encoding import CONSTANT, GLOBAL, JUMP, LOCAL, TEXT
from ev3proto.tables.enumerations import ENUMERATIONS
from ev3proto.tables.frame import MAX_FRAME, MessageType
from ev3proto.tables.system import Kind

Schema = dict[str, Any]

DRAFT = "https://json-schema.org/draft/2020-12/schema"
NAME = "^[A-Za-z][A-Za-z0-9_]*$"


def schema() -> Schema:
    """Returns the whole schema: the document, and its definitions."""
    sections = {
        "$schema": _text("where this schema is"),
        "version": _text("version of ev3proto that the tables are of"),
        "dialects": _array(_ref("dialect"), "the firmwares whose instruction sets differ"),
        "frame": _frame(),
        "message_types": _array(_ref("message_type"), "the byte after the message counter"),
        "types": _array(_ref("type"), "what parameters hold"),
        "encodings": _array(_ref("encoding"), "what the first byte of an argument says; bytes omitted are undefined"),
        "areas": _object(
            {area: _array(_ref("opcode"), f"the area {area}") for area in AREAS}, "the opcodes by the firmware's areas"
        ),
        "enumerations": _map(_ref("enumeration"), "names of numbers, by the name that parameters refer to"),
        "format_types": _array(_ref("format_type"), "the type of values that a number of DATA_FORMAT announces"),
        "system_commands": _array(_ref("system_command"), "files, mailboxes, PINs, the bootloader"),
        "system_statuses": _array(_ref("system_status"), "the byte that says how a system command went"),
        "daisy_commands": _array(_ref("daisy_command"), "what bricks say to each other when they are joined by USB"),
        "carriers": _carriers(),
        "constants": _map({"type": ["integer", "string"]}, "plain numbers and names of the firmware"),
    }
    return {
        "$schema": DRAFT,
        "title": "The protocol of the LEGO MINDSTORMS EV3",
        **_object(sections, "Opcodes, enumerations, system commands and their frames, as ev3proto knows them."),
        "$defs": _definitions(),
    }


# Words


def _object(properties: Schema, text: str, optional: tuple[str, ...] = ()) -> Schema:
    return {
        "type": "object",
        "description": text,
        "properties": properties,
        "required": [name for name in properties if name not in optional],
        "additionalProperties": False,
    }


def _map(values: Schema, text: str) -> Schema:
    return {
        "type": "object",
        "description": text,
        "propertyNames": {"pattern": NAME},
        "additionalProperties": values,
    }


def _array(items: Schema, text: str, **more: Any) -> Schema:
    return {"type": "array", "description": text, "items": items, **more}


def _ref(name: str) -> Schema:
    return {"$ref": f"#/$defs/{name}"}


def _text(text: str) -> Schema:
    return {"type": "string", "description": text}


def _name(text: str) -> Schema:
    return {"type": "string", "description": text, "pattern": NAME}


def _number(text: str, low: int | None = None, high: int | None = None) -> Schema:
    limits = {name: value for name, value in (("minimum", low), ("maximum", high)) if value is not None}
    return {"type": "integer", "description": text, **limits}


def _byte(text: str) -> Schema:
    return _number(text, 0, 0xFF)


def _flag(text: str) -> Schema:
    return {"type": "boolean", "description": text}


def _one_of(names: list[str], text: str) -> Schema:
    return {"enum": names, "description": text}


_LINE = _text("one line of meaning")
_NOTE = _text("where the entry differs from other published tables, and why")
_DIALECTS = {
    "type": "array",
    "description": "the firmwares that have it: all where this is omitted, none where it is only in their headers",
    "items": {"$ref": "#/$defs/dialect"},
}
_EFFECTS = {
    "type": "array",
    "description": "what it does besides what its parameters say",
    "items": {"oneOf": [{"const": effect.name, "description": effect.value} for effect in Effect]},
    "uniqueItems": True,
}


# Sections


def _frame() -> Schema:
    return _object(
        {
            "length_field": _number("bytes of the length field, which counts what follows it", 1),
            "header_size": _number("bytes of length, counter and type, which every frame starts with", 1),
            "command_header_size": _number("bytes before the operations of a direct command", 1),
            "most_bytes": _number("bytes of the largest frame, its length field included", 1),
            "global_bits": _number("lower bits of the memory field: bytes of global memory", 1),
            "local_bits": _number("upper bits of the memory field: bytes of local memory", 1),
            "string_coding": _text("how strings are encoded"),
        },
        "sizes of what all frames have; numbers of more than one byte are little-endian",
    )


def _carriers() -> Schema:
    port = {"low": 1, "high": 0xFFFF}
    usb = {
        "vendor": _number("LEGO's number", 0, 0xFFFF),
        "product": _number("the brick running its firmware", 0, 0xFFFF),
        "bootloader_product": _number("the brick while its firmware is updated", 0, 0xFFFF),
        "endpoint_out": _byte("interrupt endpoint of the reports to the brick"),
        "endpoint_in": _byte("interrupt endpoint of the reports from the brick"),
        "report_sizes": _array(_number("bytes", 1, MAX_FRAME), "bytes of a report: daisy chain, computer"),
    }
    wifi = {
        "beacon_port": _number("UDP port of the bricks' beacons", **port),
        "tcp_port": _number("TCP port on which a brick listens", **port),
        "beacon_lines": _array(_text("a label"), "the lines of a beacon in their order"),
        "unlock": _text("what a host sends first, with SERIAL in the place of the brick's serial number"),
        "accept": _text("what the brick answers to that"),
    }
    return _object(
        {
            "usb": _object(usb, "how a brick shows itself on USB"),
            "bluetooth": _object(
                {"rfcomm_channel": _number("serial port of a brick", 1, 30)}, "where it listens on Bluetooth"
            ),
            "wifi": _object(wifi, "how it is found and unlocked on WiFi"),
        },
        "what carries frames",
    )


# Definitions


def _definitions() -> Schema:
    return {
        "dialect": _one_of(list(DIALECTS), "a firmware"),
        "type_name": _one_of([member.label for member in Type], "what a value is"),
        "direction": _one_of([member.value for member in Direction], "to the operation, from it, or both"),
        "message_type": _message_type(),
        "type": _type(),
        "encoding": _encoding(),
        "opcode": _opcode(),
        "command": _command(),
        "parameter": _parameter(),
        "enumeration": _enumeration(),
        "format_type": _object({"format": _byte("of DATA_FORMAT"), "type": _ref("type_name")}, "a format and its type"),
        "system_command": _system_command(),
        "field": _field(),
        "system_status": _object(
            {
                "number": _byte("in the reply"),
                "name": _name("as the firmware spells it"),
                "is_failure": _flag("whether the command did not do what it was asked"),
            },
            "a status",
        ),
        "daisy_command": _object(
            {
                "number": _byte("after the message type"),
                "name": _name("as the firmware spells it"),
                "text": _LINE,
                "carries_operations": _flag("whether byte code follows"),
            },
            "a sub-command of the daisy chain",
        ),
    }


def _message_type() -> Schema:
    return _object(
        {
            "number": _byte("in the frame"),
            "name": _name("as the firmware spells it"),
            "kind": _one_of(sorted({member.kind for member in MessageType}), "what follows it"),
            "wants_reply": _flag("whether the brick answers"),
            "is_error": _flag("whether the command failed"),
        },
        "a message type",
    )


def _pair(items: Schema, text: str) -> Schema:
    return {"type": "array", "description": text, "items": items, "minItems": 2, "maxItems": 2}


def _type() -> Schema:
    return _object(
        {
            "name": _ref("type_name"),
            "size": _number("bytes of one value in memory; omitted where it varies", 1),
            "range": _pair({"type": "integer"}, "smallest and largest constant"),
            "nan": {
                "type": ["integer", "string"],
                "description": 'the number that means "not a number", or the four bytes of that float in hex',
            },
        },
        "a type",
        optional=("size", "range", "nan"),
    )


def _encoding() -> Schema:
    kinds = [CONSTANT, TEXT, LOCAL, GLOBAL, JUMP]
    return _object(
        {
            "name": _one_of(sorted({entry.name for entry in ENCODINGS if entry}), "as in the firmware's macros"),
            "first": _byte("the first of the bytes that say this"),
            "last": _byte("the last of them"),
            "kind": _one_of(kinds, "what the argument is"),
            "value": _number("of short forms: the value in the byte `first`; the next byte has the next value"),
            "width": _number("bytes that follow; omitted for strings, which end at their zero", 0, 4),
            "handle": _flag("the value is a handle to a memory object"),
            "address": _flag("the value is an absolute address"),
        },
        "what a run of identification bytes says",
        optional=("value", "width", "handle", "address"),
    )


def _opcode() -> Schema:
    return {
        **_object(
            {
                "number": _byte("the operation's first byte"),
                "name": _name("as the firmware spells it"),
                "text": _LINE,
                "dialects": _DIALECTS,
                "note": _NOTE,
                "effects": _EFFECTS,
                "parameters": _array(_ref("parameter"), "what follows the opcode"),
                "commands": _array(_ref("command"), "of a family: what its first argument CMD selects", minItems=1),
            },
            "an opcode: either with parameters or, for a family, with commands that have them",
            optional=("dialects", "note", "effects", "parameters", "commands"),
        ),
        "oneOf": [{"required": ["parameters"]}, {"required": ["commands"]}],
    }


def _command() -> Schema:
    return _object(
        {
            "number": _number("the value of CMD", 0, 0x7F),
            "name": _name("as the firmware spells it"),
            "text": _LINE,
            "dialects": _DIALECTS,
            "note": _NOTE,
            "effects": _EFFECTS,
            "parameters": _array(_ref("parameter"), "what follows CMD"),
        },
        "a CMD of a family",
        optional=("dialects", "note", "effects"),
    )


def _parameter() -> Schema:
    facts = {
        "name": _name("as the firmware spells it"),
        "type": _ref("type_name"),
        "direction": _ref("direction"),
        "text": _LINE,
        "unit": _text("of the value, as people write it"),
        "range": _pair({"type": "integer"}, "smallest and largest value that makes sense"),
        "enum": _one_of([enum.name for enum in ENUMERATIONS], "the enumeration that names its values"),
        "special": {
            "type": "object",
            "description": "single values with a meaning of their own",
            "propertyNames": {"pattern": "^-?[0-9]+$"},
            "additionalProperties": {"type": "string"},
        },
        "length": _number("bytes (strings) or elements (others) that there are", 0),
        "length_from": _name("the parameter that tells how many there are"),
        "element": {**_ref("type_name"), "description": "of counts and lists: the type of each value that follows"},
        "element_from": _name("of counts: the parameter that tells the type of each value that follows"),
        "elements": {**_ref("direction"), "description": "of counts: the direction of what follows, if it is not in"},
        "validated": {**_ref("type_name"), "description": "what the firmware's validator takes it for"},
        "role": {
            "description": "what else depends on it",
            "oneOf": [{"const": role.name, "description": role.value} for role in Role],
        },
        "note": _NOTE,
    }
    optional = tuple(name for name in facts if name not in ("name", "type", "direction", "text"))
    return _object(facts, "a parameter: an argument in the frame", optional)


def _enumeration() -> Schema:
    return _object(
        {
            "text": _LINE,
            "members": _map({"type": "integer"}, "numbers by name; of names with the same number the first is shown"),
            "end": _object(
                {"name": _name("a constant"), "number": _number("its value")},
                "the name of the number after the last, which is not a value itself",
            ),
            "flags": _flag("whether the value is a set of bits and each member one of them"),
            "dialects": _DIALECTS,
        },
        "names of numbers",
        optional=("end", "flags", "dialects"),
    )


def _system_command() -> Schema:
    return _object(
        {
            "number": _byte("in the frame"),
            "name": _name("as the firmware spells it; the bootloader has names of the firmware's again"),
            "text": _LINE,
            "request": _array(_ref("field"), "what follows the number in the command"),
            "reply": _array(_ref("field"), "what follows number and status in the reply, unless that says it failed"),
            "answered": _flag("whether the brick ever replies"),
            "bootloader": _flag("only the brick's firmware updater knows it"),
            "transfer": _one_of(["begin", "continue", "close"], "the part it plays in moving a file"),
            "effects": _EFFECTS,
        },
        "a system command",
        optional=("bootloader", "transfer", "effects"),
    )


def _field() -> Schema:
    kinds = "a number, a text up to its zero, a text preceded by its length, or all the bytes that are left"
    return _object(
        {
            "name": _name("as ev3proto calls it"),
            "kind": _one_of([kind.value for kind in Kind], kinds),
            "text": _LINE,
            "counts": _name("of lengths: the field whose bytes they count"),
            "optional": _flag("senders may omit it"),
            "most_bytes": _number("largest number of bytes that the firmware takes", 1),
        },
        "a field of a system message",
        optional=("counts", "optional", "most_bytes"),
    )
