"""The two files: each section, each kind of entry, each property with its meaning and its value."""

from __future__ import annotations

from collections.abc import Iterator
from operator import attrgetter
from typing import Any, NamedTuple

from ev3proto.generate.tables_json.shapes import (
    JsonSchema,
    Object,
    Shape,
    array,
    byte,
    flag,
    map_of,
    name,
    number,
    one_of,
    pair,
    ref,
    text,
    written,
)
from ev3proto.schema.discovery import Unlock
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE
from ev3proto.tables import AREAS, carriers, daisy, discovery, frame
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.declaration import DIALECTS, Direction, Effect, Role, Type
from ev3proto.tables.devices import DEVICE_TYPES
from ev3proto.tables.encoding import (
    CONSTANT,
    COUNTS,
    GLOBAL,
    IDENTIFICATIONS,
    JUMP,
    LOCAL,
    NAN_FLOAT,
    RANGES,
    STRING_CODING,
    TEXT,
    NumberRange,
)
from ev3proto.tables.enumerations import ENUMERATIONS, FORMAT_TYPES
from ev3proto.tables.frame import MessageType
from ev3proto.tables.system import SYSTEM, FieldKind, SystemStatus
from ev3proto.version import VERSION

TABLES_NAME = "ev3-tables.json"
SCHEMA_NAME = "ev3-tables.schema.json"

DRAFT = "https://json-schema.org/draft/2020-12/schema"

_LINE = text("one line of meaning")
_NOTE = text("where the entry differs from other published tables, and why")
_SPELT = name("as the firmware spells it")
_DIALECTS = (
    array(
        ref("dialect"), "the firmwares that have it: all where this is omitted, none where it is only in their headers"
    ),
    lambda it: None if it.dialects == DIALECTS else list(it.dialects),
)
_EFFECTS = (
    array(
        {"oneOf": [{"const": effect.name, "description": effect.value} for effect in Effect]},
        "what it does besides what its parameters say",
        uniqueItems=True,
    ),
    lambda it: [effect.name for effect in it.effects] or None,
)


def _label(kind: Any) -> str | None:
    return kind.label if isinstance(kind, Type) else None


def _value(member: Any) -> Any:
    return None if member is None else member.value


# Kinds of entries

_MESSAGE_TYPE = Shape(
    "a message type",
    {
        "number": (byte("in the frame"), _value),
        "name": _SPELT,
        "kind": one_of(sorted({member.kind for member in MessageType}), "what follows it"),
        "wants_reply": flag("whether the brick answers"),
        "is_error": flag("whether the command failed"),
        "text": (_LINE, lambda it: frame.TYPE_MEANINGS[it]),
    },
)

_NAN = {
    "type": ["integer", "string"],
    "description": 'the number that means "not a number", or the four bytes of that float in hex',
}


class _Type(NamedTuple):
    name: str
    size: int = 0
    limits: NumberRange | None = None
    nan: int | str | None = None


def _types() -> Iterator[_Type]:
    """Yields what the type of a parameter can be: also the two ways to count a list."""
    for each in Type:
        limits = RANGES.get(each)
        nan = NAN_FLOAT.hex() if each is Type.DATAF else limits and limits.nan
        yield _Type(each.label, each.size, limits, nan)
    yield _Type("count", 0, COUNTS, COUNTS.nan)
    yield _Type("values")


_TYPE = Shape(
    "a type",
    {
        "name": (ref("type_name"), attrgetter("name")),
        "size": (number("bytes of one value in memory; omitted where it varies", 1), lambda it: it.size or None),
        "range": (pair("smallest and largest constant"), lambda it: it.limits and [it.limits.low, it.limits.high]),
        "nan": (_NAN, attrgetter("nan")),
    },
    optional=("size", "range", "nan"),
)

_PARAMETER_PROPERTIES: dict[str, Any] = {
    "name": _SPELT,
    "type": (ref("type_name"), lambda it: it.label),
    "direction": (ref("direction"), lambda it: it.direction.value),
    "text": _LINE,
    "unit": text("of the value, as people write it"),
    "range": (pair("smallest and largest value that makes sense"), lambda it: it.range and list(it.range)),
    "enum": (
        one_of([enum.name for enum in ENUMERATIONS], "the enumeration that names its values"),
        lambda it: it.enum and it.enum.name,
    ),
    "special": (
        {
            "type": "object",
            "description": "single values with a meaning of their own",
            "propertyNames": {"pattern": "^-?[0-9]+$"},
            "additionalProperties": {"type": "string"},
        },
        lambda it: {str(value): said for value, said in it.special.items()},
    ),
    "length": (
        number("number of bytes (strings) or elements (others)", 0),
        lambda it: it.length if isinstance(it.length, int) else None,
    ),
    "length_from": (
        name("the parameter that tells how many there are"),
        lambda it: it.length if isinstance(it.length, str) else None,
    ),
    "each": text("of counts and lists: what each value that follows is"),
    "indexed_by": name("of arrays: the parameter with the index of the element that is written"),
    "element": (
        {**ref("type_name"), "description": "of counts and lists: the type of each value that follows"},
        lambda it: _label(it.element),
    ),
    "element_from": (
        name("of counts: the parameter that tells the type of each value that follows"),
        lambda it: it.element if isinstance(it.element, str) else None,
    ),
    "elements": (
        {**ref("direction"), "description": "of counts: the direction of what follows, if it is not in"},
        lambda it: it.elements.value if it.elements is not Direction.IN else None,
    ),
    "validated": (
        {**ref("type_name"), "description": "what the firmware's validator takes it for"},
        lambda it: _label(it.validated),
    ),
    "role": (
        {
            "description": "what else depends on it",
            "oneOf": [{"const": role.name, "description": role.value} for role in Role],
        },
        lambda it: it.role and it.role.name,
    ),
    "note": _NOTE,
}
_PARAMETER = Shape(
    "a parameter: an argument in the frame",
    _PARAMETER_PROPERTIES,
    optional=tuple(key for key in _PARAMETER_PROPERTIES if key not in ("name", "type", "direction", "text")),
)


def _parameters(entry: Any) -> list[Object]:
    return [_PARAMETER.data(parameter) for parameter in entry.parameters]


_HAS_LIST = (
    flag("a list of values ends its arguments: the last or last but one parameter says how many follow"),
    lambda it: bool(it.parameters) and it.parameters[-1].is_list,
)

_COMMAND = Shape(
    "a CMD of a family",
    {
        "number": number("the value of CMD", 0, 0x7F),
        "name": _SPELT,
        "text": _LINE,
        "dialects": _DIALECTS,
        "note": _NOTE,
        "effects": _EFFECTS,
        "has_list": _HAS_LIST,
        "parameters": (array(ref("parameter"), "what follows CMD"), _parameters),
    },
    optional=("dialects", "note", "effects", "has_list"),
)

_OPCODE = Shape(
    "an opcode: either with parameters or, for a family, with commands that have them",
    {
        "number": byte("the operation's first byte"),
        "name": _SPELT,
        "text": _LINE,
        "dialects": _DIALECTS,
        "note": _NOTE,
        "effects": _EFFECTS,
        "has_list": _HAS_LIST,
        "parameters": (
            array(ref("parameter"), "what follows the opcode"),
            lambda it: None if it.is_family else _parameters(it),
        ),
        "commands": (
            array(ref("command"), "of a family: what its first argument CMD selects", minItems=1),
            lambda it: [_COMMAND.data(command) for command in it.commands] if it.is_family else None,
        ),
    },
    optional=("dialects", "note", "effects", "has_list", "parameters", "commands"),
)

_ENCODING = Shape(
    "what a run of identification bytes says",
    {
        "name": (
            one_of(sorted({row.encoding.name for row in IDENTIFICATIONS}), "as in the firmware's macros"),
            attrgetter("encoding.name"),
        ),
        "first": byte("the first of the bytes that say this"),
        "last": byte("the last of them"),
        "kind": (one_of([CONSTANT, TEXT, LOCAL, GLOBAL, JUMP], "what the argument is"), attrgetter("encoding.kind")),
        "value": (
            number("of short forms: the value in the byte `first`; the next byte has the next value"),
            attrgetter("value"),
        ),
        "width": (
            number("bytes that follow; omitted for strings, which end at their zero", 0, 4),
            attrgetter("encoding.width"),
        ),
        "handle": (flag("the value is a handle to a memory object"), attrgetter("encoding.handle")),
        "address": (flag("the value is an absolute address"), attrgetter("encoding.address")),
    },
    optional=("value", "width", "handle", "address"),
)

_END = Shape(
    "the name of the number after the last, which is not a value itself",
    {"name": (name("a constant"), lambda it: it[0]), "number": (number("its value"), lambda it: it[1])},
)
_ENUMERATION = Shape(
    "names of numbers",
    {
        "text": _LINE,
        "members": (
            map_of({"type": "integer"}, "numbers by name; of names with the same number the first is shown"),
            lambda it: dict(it.members),
        ),
        "end": (_END.schema, lambda it: it.end and _END.data(it.end)),
        "flags": flag("whether the value is a set of bits and each member one of them"),
        "dialects": _DIALECTS,
    },
    optional=("end", "flags", "dialects"),
)

_FORMAT_TYPE = Shape(
    "a format and its type",
    {"format": (byte("of DATA_FORMAT"), lambda it: it[0]), "type": (ref("type_name"), lambda it: it[1].label)},
)

_KINDS = (
    "a number, a text up to its zero, a text preceded by its length, or all the bytes that are left"
    " (`data`, or `listing`, a text)"
)
_FIELD = Shape(
    "a field of a system message",
    {
        "name": name("as ev3proto calls it"),
        "kind": (one_of([kind.value for kind in FieldKind], _KINDS), lambda it: it.kind.value),
        "text": _LINE,
        "counts": name("of lengths: the field whose bytes they count"),
        "optional": flag("senders may omit it"),
        "most_bytes": (number("largest number of bytes that the firmware takes", 1), lambda it: it.most),
        "is_message": flag("a mailbox's message: a text, a number or a logic value"),
    },
    optional=("counts", "optional", "most_bytes", "is_message"),
)

_SYSTEM_COMMAND = Shape(
    "a system command",
    {
        "number": byte("in the frame"),
        "name": name("as the firmware spells it; the bootloader has names of the firmware's again"),
        "text": _LINE,
        "request": (
            array(ref("field"), "what follows the number in the command"),
            lambda it: [_FIELD.data(field) for field in it.request],
        ),
        "reply": (
            array(ref("field"), "what follows number and status in the reply, unless that says it failed"),
            lambda it: [_FIELD.data(field) for field in it.reply],
        ),
        "answered": flag("whether the brick ever replies"),
        "bootloader": flag("only the brick's firmware updater knows it"),
        "transfer": one_of(["begin", "continue", "close"], "the part it plays in moving a file"),
        "effects": _EFFECTS,
        "is_long": flag("its frame may be longer than the largest of others"),
        "statuses": (
            {
                "type": "object",
                "description": "what the statuses mean that the firmware answers with, other than 0",
                "propertyNames": {"pattern": "^[0-9]+$"},
                "additionalProperties": {"type": "string"},
            },
            lambda it: {str(status.value): meaning for status, meaning in it.statuses},
        ),
    },
    optional=("bootloader", "transfer", "effects", "is_long", "statuses"),
)

_SYSTEM_STATUS = Shape(
    "a status",
    {
        "number": (byte("in the reply"), _value),
        "name": _SPELT,
        "is_failure": flag("whether the command did not do what it was asked"),
    },
)

_DAISY_COMMAND = Shape(
    "a sub-command of the daisy chain",
    {
        "number": (byte("after the message type"), _value),
        "name": _SPELT,
        "text": (_LINE, lambda it: daisy.TEXTS[it]),
        "carries_operations": flag("whether byte code follows"),
    },
)

_DATASET = Shape(
    "a value of a reading",
    {"name": text("what it measures"), "unit": text("as people write it")},
    optional=("unit",),
)
_MODE = Shape(
    "a mode of a device",
    {
        "name": text("as the firmware spells it"),
        "is_scaled": (flag("its raw values are not in the unit"), lambda it: it.raw != it.si),
        "values": (
            array(_DATASET.schema, "the values of a reading; none where they are not documented"),
            lambda it: list(map(_DATASET.data, it.values)),
        ),
    },
    optional=("is_scaled",),
)
_DEVICE = Shape(
    "a type of sensor or motor",
    {
        "number": number("as in TYPE", 0),
        "title": text("what people call it"),
        "modes": (array(_MODE.schema, "by number, from 0"), lambda it: list(map(_MODE.data, it.modes))),
    },
)

# Sections

_FRAME = Shape(
    "sizes of what all frames have; numbers of more than one byte are little-endian",
    {
        "length_field": (number("bytes of the length field, which counts what follows it", 1), frame.LENGTH_FIELD),
        "header_size": (number("bytes of length, counter and type, which every frame starts with", 1), HEADER_SIZE),
        "command_header_size": (number("bytes before the operations of a direct command", 1), COMMAND_HEADER_SIZE),
        "most_bytes": (number("bytes of the largest frame, its length field included", 1), frame.MAX_FRAME),
        "global_bits": (number("lower bits of the memory field: bytes of global memory", 1), frame.GLOBAL_BITS),
        "local_bits": (number("upper bits of the memory field: bytes of local memory", 1), frame.LOCAL_BITS),
        "string_coding": (text("how strings are encoded"), STRING_CODING),
        "most_counted": (number("values in a list with a count of its own", 1), COUNTS.high),
        "sensor_data": (number("bytes of a sensor's data in a daisy reply", 1), daisy.SENSOR_DATA_SIZE),
    },
)

_PORT = {"low": 1, "high": 0xFFFF}
_CARRIERS = Shape(
    "what carries frames",
    {
        "usb": Shape(
            "how a brick shows itself on USB",
            {
                "vendor": (number("LEGO's number", 0, 0xFFFF), carriers.USB_VENDOR),
                "product": (number("the brick running its firmware", 0, 0xFFFF), carriers.USB_PRODUCT),
                "bootloader_product": (
                    number("the brick while its firmware is updated", 0, 0xFFFF),
                    carriers.USB_BOOTLOADER,
                ),
                "endpoint_out": (byte("interrupt endpoint of the reports to the brick"), carriers.USB_ENDPOINT_OUT),
                "endpoint_in": (byte("interrupt endpoint of the reports from the brick"), carriers.USB_ENDPOINT_IN),
                "report_sizes": (
                    array(number("bytes", 1, frame.MAX_FRAME), "bytes of a report: daisy chain, computer"),
                    list(frame.REPORT_SIZES),
                ),
            },
        ).nested,
        "bluetooth": Shape(
            "where it listens on Bluetooth",
            {"rfcomm_channel": (number("serial port of a brick", 1, 30), carriers.RFCOMM_CHANNEL)},
        ).nested,
        "wifi": Shape(
            "how it is found and unlocked on WiFi",
            {
                "beacon_port": (number("UDP port of the bricks' beacons", **_PORT), discovery.BEACON_PORT),
                "tcp_port": (number("TCP port on which a brick listens", **_PORT), discovery.TCP_PORT),
                "beacon_lines": (
                    array(text("a label"), "the lines of a beacon in their order"),
                    list(discovery.BEACON_LINES.values()),
                ),
                "unlock": (
                    text("what a host sends first, with SERIAL in the place of the brick's serial number"),
                    Unlock("SERIAL").build().decode("ascii"),
                ),
                "accept": (text("what the brick answers to that"), discovery.ACCEPT.decode("ascii")),
            },
        ).nested,
    },
)


def _document() -> Shape:
    """Returns the whole document."""
    areas = {area: array(ref("opcode"), f"the area {area}") for area in AREAS}
    return Shape(
        "Opcodes, enumerations, system commands and their frames, as ev3proto knows them.",
        {
            "$schema": (text("where this schema is"), SCHEMA_NAME),
            "version": (text("version of ev3proto that the tables are of"), VERSION),
            "dialects": (array(ref("dialect"), "the firmwares whose instruction sets differ"), list(DIALECTS)),
            "frame": _FRAME.nested,
            "message_types": (
                array(ref("message_type"), "the byte after the message counter"),
                list(map(_MESSAGE_TYPE.data, MessageType)),
            ),
            "types": (array(ref("type"), "what parameters hold"), list(map(_TYPE.data, _types()))),
            "encodings": (
                array(ref("encoding"), "what the first byte of an argument says; bytes omitted are undefined"),
                list(map(_ENCODING.data, IDENTIFICATIONS)),
            ),
            "areas": (
                Shape("the opcodes by the firmware's areas", areas).schema,
                {area: list(map(_OPCODE.data, opcodes)) for area, opcodes in AREAS.items()},
            ),
            "enumerations": (
                map_of(ref("enumeration"), "names of numbers, by the name that parameters refer to"),
                {enum.name: _ENUMERATION.data(enum) for enum in ENUMERATIONS},
            ),
            "format_types": (
                array(ref("format_type"), "the type of values that a number of DATA_FORMAT announces"),
                list(map(_FORMAT_TYPE.data, FORMAT_TYPES.items())),
            ),
            "system_commands": (
                array(ref("system_command"), "files, mailboxes, PINs, the bootloader"),
                list(map(_SYSTEM_COMMAND.data, SYSTEM)),
            ),
            "system_statuses": (
                array(ref("system_status"), "the byte that says how a system command went"),
                list(map(_SYSTEM_STATUS.data, SystemStatus)),
            ),
            "daisy_commands": (
                array(ref("daisy_command"), "what bricks say to each other when they are joined by USB"),
                list(map(_DAISY_COMMAND.data, daisy.DaisySubCommand)),
            ),
            "devices": (
                array(_DEVICE.schema, "what readings of sensors and motors are, by type and mode"),
                list(map(_DEVICE.data, DEVICE_TYPES.values())),
            ),
            "carriers": _CARRIERS.nested,
            "constants": (
                map_of({"type": ["integer", "string"]}, "plain numbers and names of the firmware"),
                dict(CONSTANTS),
            ),
        },
    )


def build_tables() -> str:
    """Returns the text of ev3-tables.json: section by section; unspecified properties are omitted."""
    return written(_document().data())


def build_schema() -> str:
    """Returns the text of ev3-tables.schema.json: the document, and its definitions."""
    definitions: JsonSchema = {
        "dialect": one_of(list(DIALECTS), "a firmware"),
        "type_name": one_of([each.name for each in _types()], "what a value is"),
        "direction": one_of([member.value for member in Direction], "to the operation, from it, or both"),
        "message_type": _MESSAGE_TYPE.schema,
        "type": _TYPE.schema,
        "encoding": _ENCODING.schema,
        "opcode": {**_OPCODE.schema, "oneOf": [{"required": ["parameters"]}, {"required": ["commands"]}]},
        "command": _COMMAND.schema,
        "parameter": _PARAMETER.schema,
        "enumeration": _ENUMERATION.schema,
        "format_type": _FORMAT_TYPE.schema,
        "system_command": _SYSTEM_COMMAND.schema,
        "field": _FIELD.schema,
        "system_status": _SYSTEM_STATUS.schema,
        "daisy_command": _DAISY_COMMAND.schema,
    }
    title = "The protocol of the LEGO MINDSTORMS EV3"
    return written({"$schema": DRAFT, "title": title, **_document().schema, "$defs": definitions})
