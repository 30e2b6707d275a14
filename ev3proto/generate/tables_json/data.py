"""The tables as plain values: numbers, texts, lists, objects. Unspecified properties are omitted."""

from __future__ import annotations

from itertools import groupby
from typing import Any

from ev3proto.schema.argument import ENCODINGS, SHORT_VALUES
from ev3proto.schema.discovery import Unlock
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE
from ev3proto.tables import AREAS, carriers, daisy, discovery, enumerations, frame
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.declaration import DIALECTS, Command, Direction, Enumeration, Opcode, Parameter, Type
from ev3proto.tables.encoding import NAN_FLOAT, RANGES, STRING_CODING, Encoding
from ev3proto.tables.enumerations import ENUMERATIONS
from ev3proto.tables.frame import MessageType
from ev3proto.tables.system import SYSTEM, Field, SystemCommand, SystemStatus
from ev3proto.version import VERSION

Object = dict[str, Any]


def tables() -> Object:
    """Returns everything, section by section."""
    return {
        "version": VERSION,
        "dialects": list(DIALECTS),
        "frame": _frame(),
        "message_types": [_message_type(member) for member in MessageType],
        "types": [_type(member) for member in Type],
        "encodings": _encodings(),
        "areas": {area: [_opcode(opcode) for opcode in opcodes] for area, opcodes in AREAS.items()},
        "enumerations": {enum.name: _enumeration(enum) for enum in ENUMERATIONS},
        "format_types": [{"format": number, "type": kind.label} for number, kind in enumerations.FORMAT_TYPES.items()],
        "system_commands": [_system_command(command) for command in SYSTEM],
        "system_statuses": [_status(status) for status in SystemStatus],
        "daisy_commands": [_daisy_command(command) for command in daisy.DaisyCommand],
        "carriers": _carriers(),
        "constants": dict(CONSTANTS),
    }


def _present(**facts: Any) -> Object:
    """Returns an object without its empty entries: None, empty texts, empty lists."""
    return {name: value for name, value in facts.items() if value is not None and value != "" and value != {}}


def _frame() -> Object:
    return {
        "length_field": frame.LENGTH_FIELD,
        "header_size": HEADER_SIZE,
        "command_header_size": COMMAND_HEADER_SIZE,
        "most_bytes": frame.MAX_FRAME,
        "global_bits": frame.GLOBAL_BITS,
        "local_bits": frame.LOCAL_BITS,
        "string_coding": STRING_CODING,
    }


def _message_type(member: MessageType) -> Object:
    return {
        "number": member.value,
        "name": member.name,
        "kind": member.kind,
        "wants_reply": member.wants_reply,
        "is_error": member.is_error,
    }


def _type(member: Type) -> Object:
    facts: Object = {"name": member.label}
    if member.size:
        facts["size"] = member.size
    if member in RANGES:
        low, high, nan = RANGES[member]
        facts |= {"range": [low, high], "nan": nan}
    elif member is Type.DATAF:
        facts["nan"] = NAN_FLOAT.hex()
    return facts


def _encodings() -> list[Object]:
    """Joins adjacent bytes with the same meaning, or with consecutive values, to one entry."""
    found = []
    for (encoding, _), run in groupby(range(len(ENCODINGS)), key=_run_of):
        if encoding is None:
            continue
        numbers = list(run)
        facts = {
            "name": encoding.name,
            "first": numbers[0],
            "last": numbers[-1],
            "kind": encoding.kind,
            "value": SHORT_VALUES[numbers[0]],
            "width": encoding.width,
            "handle": encoding.handle or None,
            "address": encoding.address or None,
        }
        found.append(_present(**facts))
    return found


def _run_of(byte: int) -> tuple[Encoding | None, int | None]:
    value = SHORT_VALUES[byte]
    return ENCODINGS[byte], None if value is None else value - byte


def _opcode(opcode: Opcode) -> Object:
    facts = {"number": opcode.number, "name": opcode.name, "text": opcode.text, **_dialects(opcode), **_effects(opcode)}
    if opcode.is_family:
        facts["commands"] = [_command(command) for command in opcode.commands]
    else:
        facts["parameters"] = [_parameter(parameter) for parameter in opcode.parameters]
    return facts


def _command(command: Command) -> Object:
    return {
        "number": command.number,
        "name": command.name,
        "text": command.text,
        **_dialects(command),
        **_effects(command),
        "parameters": [_parameter(parameter) for parameter in command.parameters],
    }


def _dialects(entry: Opcode | Command) -> Object:
    dialects = None if entry.dialects == DIALECTS else list(entry.dialects)
    return _present(dialects=dialects, note=entry.note)


def _effects(entry: Opcode | Command | SystemCommand) -> Object:
    return _present(effects=[effect.name for effect in entry.effects] or None)


def _parameter(parameter: Parameter) -> Object:
    element = parameter.element
    return _present(
        name=parameter.name,
        type=parameter.type.label,
        direction=parameter.direction.value,
        text=parameter.text,
        unit=parameter.unit,
        range=None if parameter.range is None else list(parameter.range),
        enum=None if parameter.enum is None else parameter.enum.name,
        special={str(value): text for value, text in parameter.special.items()},
        length=parameter.length if isinstance(parameter.length, int) else None,
        length_from=parameter.length if isinstance(parameter.length, str) else None,
        element=element.label if isinstance(element, Type) else None,
        element_from=element if isinstance(element, str) else None,
        elements=parameter.elements.value if parameter.elements is not Direction.IN else None,
        validated=None if parameter.validated is None else parameter.validated.label,
        role=None if parameter.role is None else parameter.role.name,
        note=parameter.note,
    )


def _enumeration(enum: Enumeration) -> Object:
    return _present(
        text=enum.text,
        members=dict(enum.members),
        end=None if enum.end is None else {"name": enum.end[0], "number": enum.end[1]},
        flags=enum.flags or None,
        dialects=None if enum.dialects == DIALECTS else list(enum.dialects),
    )


def _system_command(command: SystemCommand) -> Object:
    return _present(
        number=command.number,
        name=command.name,
        text=command.text,
        request=[_field(field) for field in command.request],
        reply=[_field(field) for field in command.reply],
        answered=command.answered,
        bootloader=command.bootloader or None,
        transfer=command.transfer,
        **_effects(command),
    )


def _field(field: Field) -> Object:
    return _present(
        name=field.name,
        kind=field.kind.value,
        text=field.text,
        counts=field.counts,
        optional=field.optional or None,
        most_bytes=field.most,
    )


def _status(status: SystemStatus) -> Object:
    return {"number": status.value, "name": status.name, "is_failure": status.is_failure}


def _daisy_command(command: daisy.DaisyCommand) -> Object:
    return {
        "number": command.value,
        "name": command.name,
        "text": daisy.TEXTS[command],
        "carries_operations": command.carries_operations,
    }


def _carriers() -> Object:
    return {
        "usb": {
            "vendor": carriers.USB_VENDOR,
            "product": carriers.USB_PRODUCT,
            "bootloader_product": carriers.USB_BOOTLOADER,
            "endpoint_out": carriers.USB_ENDPOINT_OUT,
            "endpoint_in": carriers.USB_ENDPOINT_IN,
            "report_sizes": list(frame.REPORT_SIZES),
        },
        "bluetooth": {"rfcomm_channel": carriers.RFCOMM_CHANNEL},
        "wifi": {
            "beacon_port": discovery.BEACON_PORT,
            "tcp_port": discovery.TCP_PORT,
            "beacon_lines": list(discovery.BEACON_LINES.values()),
            "unlock": Unlock("SERIAL").build().decode("ascii"),
            "accept": discovery.ACCEPT.decode("ascii"),
        },
    }
