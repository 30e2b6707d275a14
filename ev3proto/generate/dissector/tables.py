"""The tables as Lua: messages, encodings, enumerations, operations, system commands, and the texts before frames."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from construct.core import SizeofError

from ev3proto.checking import codes
from ev3proto.checking.codes import CODES, MAILBOX_CONTENT, MAILBOX_NAME, NEVER_RUNS, NO_PORTS, OF_VALUES
from ev3proto.generate.dissector.fields import EXPERTS, FIELDS, HEXADECIMAL, filter_name
from ev3proto.generate.dissector.lua import Name, Rows, Table, hexadecimal, literal
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE
from ev3proto.schema.reasons import REASONS
from ev3proto.schema.wire_format import SENSOR_REPORT
from ev3proto.semantics import pairing, transfers
from ev3proto.semantics.advice import LEFT_OVER, SENT_WITH
from ev3proto.semantics.domain import Domain, domain_of
from ev3proto.semantics.judgement import Wrong
from ev3proto.tables import OPCODES, carriers, claims, daisy, discovery, enumerations, frame, mailboxes
from ev3proto.tables.declaration import DIALECTS, Command, Direction, Enumeration, Opcode, Parameter, Role, Type
from ev3proto.tables.devices import DEVICE_TYPES
from ev3proto.tables.encoding import CONSTANT, COUNTS, GLOBAL, IDENTIFICATIONS, JUMP, LOCAL, RANGES, TEXT
from ev3proto.tables.frame import MessageType
from ev3proto.tables.output import PORT_SETS
from ev3proto.tables.system import SYSTEM, FieldKind, SystemDeclaration, SystemField, SystemStatus
from ev3proto.tables.validation import LABELS, SPINNING

TYPES = {member: Name(member.name) for member in Type}
DIRECTIONS = {member: Name(member.name) for member in Direction}
ENCODING_KINDS = {
    CONSTANT: Name("CONSTANT"),
    TEXT: Name("CONSTANT_TEXT"),
    LOCAL: Name("LOCAL"),
    GLOBAL: Name("GLOBAL"),
    JUMP: Name("JUMP"),
}
FIELD_KINDS = {member: Name("BYTES" if member is FieldKind.DATA else member.name) for member in FieldKind}
"""The Lua names of types, directions, kinds of arguments and fields."""


def data() -> str:
    """Returns all the data, section by section."""
    sections = (f"{_heading(title, text)}{''.join(lines).rstrip()}\n" for title, text, lines in _sections())
    return "\n".join(sections)


def _sections() -> Iterator[tuple[str, str, Iterator[str]]]:
    yield "Words", "The vocabulary of the tables below.", _words()
    yield "Frames", "The header, the types of messages, and limits.", _frames()
    yield (
        "Arguments",
        "Identification bytes: first and last byte, encoding, kind, number of bytes that follow.",
        (_encodings()),
    )
    yield "Enumerations", "Names of numbers.", _enumerations()
    yield (
        "Operations",
        "Opcode, name, description; then parameters or, for a family, its commands, which have the same. A parameter\n"
        "-- is a name, direction, type and description.",
        _operations(),
    )
    yield (
        "Readings",
        "What devices measure, by type and mode: name and unit of each value. Raw values are in the unit where this\n"
        "-- `agrees`.",
        _readings(),
    )
    yield (
        "System commands",
        "Request and reply have fields; statuses are the meanings of those other than SUCCESS.",
        _system(),
    )
    yield "Daisy chain", "Messages between bricks that are connected by USB.", _daisy()
    yield "Pairing", "When a reply answers a command; times are in nanoseconds.", _pairing()
    yield "Claims", "When traffic is claimed as this protocol.", _claims()
    yield (
        "Findings",
        "What is said of constants: code and words. The brick refuses those of REFUSED.",
        _findings(),
    )
    yield "USB and Bluetooth", "How a brick is recognised.", _carriers()
    yield "WiFi", "The texts before the first frame.", _unlock()
    yield (
        "Names for filters",
        "Fields, besides those of parameters and system messages, and expert information.",
        _fields(),
    )


def _fields() -> Iterator[str]:
    made: dict[Any, object] = {}
    for field in FIELDS:
        rest = f", {field.rest}" if field.rest else ""
        made[field.key] = Name(f'ProtoField.{field.kind}("ev3.{field.name}", "{field.title}"{rest})')
    yield _assign("field", Rows(named=made))
    experts: dict[Any, object] = {}
    for each in EXPERTS:
        place = f"expert.group.{each.group}, expert.severity.{each.severity}"
        experts[each.name] = Name(f'ProtoExpert.new("ev3.expert.{each.name}", "{each.title}", {place})')
    yield _assign("experts", Rows(named=experts))


def _heading(title: str, text: str) -> str:
    return f"-- {title} {'-' * (115 - len(title))}\n--\n-- {text}\n\n"


def _assign(name: str, value: object) -> str:
    head = f"local {name} = "
    return f"{head}{literal(value, head=len(head))}\n"


def _words() -> Iterator[str]:
    for members in (DIRECTIONS, TYPES, ENCODING_KINDS, FIELD_KINDS):
        yield _names([str(name) for name in members.values()] + (["COUNT", "VALUES"] if members is TYPES else []))
    labels = {member.name: member.label for member in Type} | {"COUNT": "count", "VALUES": "values"}
    yield _assign("TYPE_NAMES", Table(named=labels))
    sizes = {member.name: member.size for member in Type if member.size and member is not Type.LABEL}
    yield "-- Bytes of a value in memory, for the types that have one.\n"
    yield _assign("SIZE_OF", Table(named=sizes))
    yield _assign("DIALECTS", Table(DIALECTS))
    yield "\n"


def _names(names: list[str]) -> str:
    """Emits words as Lua variables with their own name as value."""
    quoted = ", ".join(f'"{name}"' for name in names)
    return f"local {', '.join(names)} =\n    {quoted}\n"


def _frames() -> Iterator[str]:
    numbers = {
        "LENGTH_FIELD": frame.LENGTH_FIELD,
        "HEADER_SIZE": HEADER_SIZE,
        "COMMAND_HEADER_SIZE": COMMAND_HEADER_SIZE,
        "MIN_LENGTH": frame.MIN_LENGTH,
        "MAX_LENGTH": frame.MAX_LENGTH,
        "MOST_COUNTED": COUNTS.high,
        "SPINNING": SPINNING,
    }
    for name, number in numbers.items():
        yield _assign(name, number)
    yield _assign("GLOBAL_MASK", Name(f"0x{frame.MAX_GLOBALS:04X}"))
    yield _assign("LOCAL_MASK", Name(f"0x{frame.MAX_LOCALS << frame.GLOBAL_BITS:04X}"))
    yield _assign("REPORT_SIZES", Table(named=dict(zip(frame.REPORT_SIZES, ("daisy", "computer"), strict=True))))
    yield "\n"
    types: dict[Any, object] = {}
    for member in MessageType:
        facts: dict[Any, object] = {"name": member.name, "carries": member.carries}
        facts |= {name: True for name in ("is_command", "wants_reply", "is_error") if getattr(member, name)}
        types[hexadecimal(member)] = Table(named=facts)
    yield _assign("MESSAGE_TYPES", Rows(named=types))
    yield "-- Bytes 1 to 4 of a header. No message type is a special character of patterns.\n"
    codes_of_types = "".join(f"\\{member}" for member in MessageType)
    yield _assign("HEADER_PATTERN", Name(f'"[\\0-\\{frame.MAX_LENGTH >> 8}]..[{codes_of_types}]"'))
    yield "local NAMES = { message_types = {}, opcodes = {}, system_commands = {} }\n"
    yield "for number, declared in pairs(MESSAGE_TYPES) do\n    NAMES.message_types[number] = declared.name\nend\n\n"


def _encodings() -> Iterator[str]:
    rows = []
    for first, last, encoding, value in IDENTIFICATIONS:
        named: dict[Any, object] = {name: True for name in ("handle", "address") if getattr(encoding, name)}
        if value is not None:
            named["value"] = value
        row = [hexadecimal(first), hexadecimal(last), encoding.name, ENCODING_KINDS[encoding.kind]]
        if encoding.width is not None:
            row.append(Name(encoding.width))
        rows.append(Table(row, named))
    yield f"{_assign('ENCODING_ROWS', Rows(rows))}\n"


def _enumerations() -> Iterator[str]:
    listed: dict[Any, object] = {}
    for enum in _used_enumerations():
        names: dict[Any, object] = {}
        for name, number in enum.members.items():
            names.setdefault(number, name)
        facts: dict[Any, object] = {"is_flags": True} if enum.flags else {}
        facts["names"] = Table(named=names)
        listed[enum.name] = Table(named=facts)
    yield f"{_assign('ENUMERATIONS', Rows(named=listed))}\n"
    yield "-- The types of values by DATA_FORMAT.\n"
    yield _assign("FORMAT_TYPES", Table(named={code: TYPES[kind] for code, kind in enumerations.FORMAT_TYPES.items()}))
    yield "\n"


def _used_enumerations() -> list[Enumeration]:
    found: dict[str, Enumeration] = {}
    for opcode in OPCODES:
        for parameters in (opcode.parameters, *(command.parameters for command in opcode.commands)):
            for parameter in parameters:
                if parameter.enum is not None:
                    found.setdefault(parameter.enum.name, parameter.enum)
    return sorted(found.values(), key=lambda enum: enum.name)


def _operations() -> Iterator[str]:
    yield _assign("OPERATIONS", Rows([_opcode(opcode) for opcode in OPCODES]))
    yield "for _, row in ipairs(OPERATIONS) do\n    NAMES.opcodes[row[1]] = NAMES.opcodes[row[1]] or row[2]\nend\n\n"


def _opcode(opcode: Opcode) -> Table:
    named = _dialects(opcode)
    row: list[object] = [hexadecimal(opcode.number), opcode.name, opcode.text]
    if opcode.is_family:
        named["commands"] = Rows([_command(command) for command in opcode.commands])
    else:
        row.append(_parameters(opcode))
    return Table(row, named)


def _command(command: Command) -> Table:
    return Table([command.number, command.name, command.text, _parameters(command)], _dialects(command))


def _parameters(entry: Opcode | Command) -> Table:
    return Table([_parameter(parameter) for parameter in entry.parameters])


def _dialects(entry: Opcode | Command) -> dict[Any, object]:
    return {} if entry.dialects == DIALECTS else {"dialects": Table(named=dict.fromkeys(entry.dialects, True))}


ROLE_LABELS = {Role.LAYER: "Daisy chain", Role.PORT: "Port", Role.MOTOR: "Port", Role.MOTORS: "Ports"}
"""Prefixes of firmware names that say little by themselves: `Port NO`."""
SHORT_NAMES = ("LAYER", "NO", "NOS")

MOTORS = {Role.MOTOR: "is_motor", Role.MOTORS: "is_set"}
"""The marks of parameters that name a motor, or a set of them."""


READINGS = {Role.SI_READING: "si", Role.RAW_READING: "raw"}
"""The marks of parameters that receive a reading of a device."""


def _parameter(parameter: Parameter) -> Table:
    facts = _presentation(parameter) | _numbers(parameter) | _contents(parameter)
    named = {name: fact for name, fact in facts.items() if fact is not None}
    return Table([parameter.name, DIRECTIONS[parameter.direction], _type(parameter), parameter.text], named)


def _presentation(parameter: Parameter) -> dict[Any, object]:
    """Returns what the values of a parameter are shown with."""
    return {
        "label": ROLE_LABELS.get(parameter.role) if parameter.role and parameter.name in SHORT_NAMES else None,
        "unit": parameter.unit or None,
        "enum": None if parameter.enum is None else Name(f"ENUMERATIONS.{parameter.enum.name}"),
        "special": Table(named=dict(parameter.special)) if parameter.special else None,
        "reading": READINGS.get(parameter.role) if parameter.role else None,
    } | ({MOTORS[parameter.role]: True} if parameter.role in MOTORS else {})


def _numbers(parameter: Parameter) -> dict[Any, object]:
    """Returns which numbers are legal, and what `ev3proto check` says of others."""
    domain = domain_of(parameter)
    if domain is None:
        return {"any": True} if parameter.type in RANGES else {}
    is_checked = domain.is_documented and parameter.direction is Direction.IN and parameter.type is not Type.LABEL
    return {
        "range": _range(parameter, domain),
        "is_ranged": True if parameter.range is not None and parameter.enum is not None else None,
        "outside": Table([domain.outside, (Wrong.NO_MEMBER if domain.has_names else Wrong.OUTSIDE).name])
        if is_checked
        else None,
        "unsigned": parameter.unsigned or None,
        "any": parameter.any_type or None,
        "is_label": True if parameter.role is Role.LABEL else None,
    }


def _range(parameter: Parameter, domain: Domain) -> Table | None:
    if not domain.spans or not (parameter.range or parameter.enum or parameter.unsigned):
        return None
    ((low, high),) = domain.spans
    # A set of no motors is allowed, and means nothing; so is a value that means "not a number".
    least = 1 if parameter.role is Role.MOTORS else RANGES[parameter.type].low if parameter.unsigned else low
    return Table([max(low, least), high])


def _contents(parameter: Parameter) -> dict[Any, object]:
    """Returns how much a parameter holds, and of what type."""
    element, validated = parameter.element, parameter.validated
    return {
        "length": parameter.length,
        "element": TYPES[element] if isinstance(element, Type) else element,
        "elements": DIRECTIONS[parameter.elements] if parameter.counts else None,
        "validated": None if validated is None else TYPES[validated],
        "most": None if parameter.most is None else parameter.most - 1,
    }


def _readings() -> Iterator[str]:
    types: dict[Any, object] = {}
    for device in DEVICE_TYPES.values():
        modes: dict[Any, object] = {}
        for number, mode in enumerate(device.modes):
            named = {"agrees": True} if mode.raw == mode.si else {}
            if mode.values:
                modes[number] = Table(
                    [Table([value.name, *filter(None, [value.unit])]) for value in mode.values], named
                )
        if modes:
            types[device.number] = Table(named=modes)
    yield f"{_assign('READINGS', Rows(named=types))}\n"


def _type(parameter: Parameter) -> Name:
    """Returns the Lua name of a parameter's type; a list is named by the way it is counted."""
    return Name(parameter.label.upper()) if parameter.is_list else TYPES[parameter.type]


def _system() -> Iterator[str]:
    commands: dict[Any, object] = {hexadecimal(command.number): _system_command(command) for command in SYSTEM}
    yield _assign("SYSTEM_COMMANDS", Rows(named=commands))
    yield "for number, command in pairs(SYSTEM_COMMANDS) do\n    NAMES.system_commands[number] = command.name\nend\n\n"
    statuses: dict[Any, object] = {
        "names": Table(named={status.value: status.name for status in SystemStatus}),
        "fails": Table(named={status.value: status.is_failure for status in SystemStatus}),
        "success": SystemStatus.SUCCESS.value,
        "end_of_file": SystemStatus.END_OF_FILE.value,
    }
    yield _assign("STATUS", Table(named=statuses))
    yield "\n"


def _system_command(command: SystemDeclaration) -> Table:
    named: dict[Any, object] = {"name": command.name, "text": command.text}
    for side in ("request", "reply"):
        fields: tuple[SystemField, ...] = getattr(command, side)
        named[side] = Table([_system_field(command, field) for field in fields])
    if command.transfer:
        named["transfer"] = command.transfer
    flags = {
        "is_bootloader": command.bootloader,
        "is_long": command.is_long,
        "has_data": any(field.kind is FieldKind.DATA for field in command.request),
        "has_message": any(field.is_message for field in command.request),
    }
    named |= {name: True for name, is_set in flags.items() if is_set}
    named["statuses"] = Table(named={status.value: text for status, text in command.statuses})
    return Table(named=named)


def _system_field(command: SystemDeclaration, field: SystemField) -> Table:
    named: dict[Any, object] = {
        "name": field.name,
        "kind": FIELD_KINDS[field.kind],
        "filter": filter_name(command, field),
    }
    if field.counts:
        named["counts"] = field.counts
    if field.optional:
        named["optional"] = True
    if field.name in HEXADECIMAL:
        named["hexadecimal"] = True
    if field.is_message:
        named["is_message"] = True
    return Table(named=named)


def _daisy() -> Iterator[str]:
    # A daisy reply carries a sensor's data part by part; the last part takes the remaining bytes.
    rows = []
    for part in SENSOR_REPORT.subcons:
        size = _size_of(part)
        rows.append(Table(named={"name": part.name} | ({} if size is None else {"size": size})))
    chain: dict[Any, object] = {
        "names": Table(named={member.value: member.name for member in daisy.DaisySubCommand}),
        "carries_operations": Table(
            named={member.value: True for member in daisy.DaisySubCommand if member.carries_operations}
        ),
        "most_layers": daisy.MOST_LAYERS,
        "sensor_report": Table(rows),
        "sensor_report_size": sum(_size_of(part) or 0 for part in SENSOR_REPORT.subcons),
    }
    yield _assign("DAISY", Table(named=chain))
    yield "\n"


def _size_of(part: object) -> int | None:
    """Returns the size in bytes of a part of a Struct; None if it takes the remaining bytes."""
    try:
        return int(part.sizeof())  # type: ignore[attr-defined]
    except SizeofError:
        return None


def _carriers() -> Iterator[str]:
    products = (carriers.USB_PRODUCT, carriers.USB_BOOTLOADER)
    lines = [Table(named={"name": name, "label": label}) for name, label in discovery.BEACON_LINES.items()]
    places: dict[Any, object] = {
        "usb_products": Table([Name(f"0x{carriers.USB_VENDOR:04X}{product:04X}") for product in products]),
        "rfcomm_channel": carriers.RFCOMM_CHANNEL,
        "tcp_port": discovery.TCP_PORT,
        "beacon_port": discovery.BEACON_PORT,
        "beacon_lines": Table(lines),
        "protocol": discovery.PROTOCOL,
    }
    yield "-- USB products are vendor and product in one number: the brick, and its bootloader.\n"
    yield _assign("CARRIERS", Table(named=places))


def _pairing() -> Iterator[str]:
    rule = {
        "patience": pairing.PATIENCE,
        "least": pairing.LEAST_PATIENCE_NS,
        "first": pairing.FIRST_PATIENCE_NS,
        "unsure": pairing.UNSURE,
        "other_size": pairing.OTHER_SIZE,
    }
    yield _assign("MOST_PER_COUNTER", pairing.MOST_PER_KEY)
    yield _assign("PAIRING", Table(named=rule))


def _claims() -> Iterator[str]:
    numbers = {opcode.name: opcode.number for opcode in OPCODES}
    rule = {
        "strange_packets": claims.STRANGE_PACKETS,
        "replies": claims.REPLIES,
        "most_held": claims.MOST_HELD,
        "never_sent": numbers[claims.NEVER_SENT],
        "not_telling": Table(named={numbers[name]: True for name in claims.NOT_TELLING}),
        "only_in_programs": Table(named={numbers[name]: True for name in claims.ONLY_IN_PROGRAMS}),
        "nxt_write": claims.NXT_WRITE,
        "nxt_flag": 0xFFFF - claims.NXT_MASK,
        "still_sent": Table(named=dict.fromkeys(claims.STILL_SENT, True)),
    }
    yield _assign("CLAIMS", Table(named=rule))
    yield "-- The range of each type.\n"
    limits: dict[Any, object] = {
        kind.name: Table(
            [limit.low, limit.high],
            {"text": f"{kind}, {limit.low} to {limit.high}", "named": f"{limit.low} to {limit.high} as {kind}"},
        )
        for kind, limit in RANGES.items()
    }
    yield _assign("TYPE_RANGES", Table(named=limits))
    yield "-- The motors of each bit mask.\n"
    yield _assign("PORT_SETS", Table(named=dict(PORT_SETS)))
    yield "-- The numbers of labels for jumps; those of a LABEL include 0.\n"
    yield _assign("LABELS", Table([1, LABELS - 1]))


_FAULTS = {
    "MISALIGNED": (codes.MISALIGNED, ""),
    "BEYOND_global": (codes.BEYOND_GLOBALS, ""),
    "BEYOND_local": (codes.BEYOND_LOCALS, ""),
    "UNKNOWN_TYPE": (codes.UNKNOWN_TYPE, ""),
    "CUT_FRAME": (codes.INCOMPLETE, ""),
    "EMPTY": (codes.EMPTY, ""),
    "NO_MEMORY": (codes.EMPTY, "no memory"),
    "UNKNOWN_OPCODE": (codes.UNKNOWN_OPCODE, ""),
    "OTHER_DIALECT": (codes.UNKNOWN_OPCODE, "dialect"),
    "UNRELEASED": (codes.UNKNOWN_OPCODE, "unreleased"),
    "AFTER_END": (codes.AFTER_END, ""),
    "CUT_OFF": (codes.CUT_OFF, ""),
    "CUT_LIST": (codes.CUT_OFF, "count"),
    "SPINS": (codes.SPINS, ""),
    "UNKNOWN_CMD": (codes.UNKNOWN_CMD, ""),
    "VARIABLE_CMD": (codes.VARIABLE_CMD, ""),
    "UNDEFINED_FORM": (codes.UNDEFINED_FORM, ""),
    "BAD_COUNT": (codes.BAD_COUNT, ""),
    "UNKNOWN_SYSTEM": (codes.UNKNOWN_SYSTEM, ""),
    "NO_SYSTEM": (codes.UNKNOWN_SYSTEM, "cut off"),
    "WRONG_FIELDS": (codes.WRONG_FIELDS, ""),
    "UNKNOWN_DAISY": (codes.UNKNOWN_DAISY, ""),
}
"""The findings about faults of frames: their names in the dissector, and the keys of their words."""


def _findings() -> Iterator[str]:
    words: dict[Any, object] = {
        wrong.name if isinstance(wrong, Wrong) else wrong: Table([entry.code, text.message])
        for entry in CODES.values()
        for wrong, text in entry.words.items()
        if isinstance(wrong, Wrong) or wrong in (NO_PORTS, NEVER_RUNS, MAILBOX_NAME, MAILBOX_CONTENT)
    }
    words |= {
        name: Table([entry.code, re.sub(r"(0x)?\{(\w+):02X\}", r"{\2}", entry.words[key].message)])
        for name, (entry, key) in _FAULTS.items()
    }
    yield _assign("FINDINGS", Rows(named=words))
    yield _assign("FILES", Table(named={"longer": transfers.LONGER, "incomplete": transfers.INCOMPLETE}))
    most: dict[Any, object] = {MAILBOX_NAME: mailboxes.MOST_NAME, MAILBOX_CONTENT: mailboxes.MOST_CONTENT}
    yield _assign("MOST_IN_MAILBOX", Table(named=most))
    slips: dict[Any, object] = {name.replace("-", "_"): said for name, said in SENT_WITH.items()}
    yield _assign("SLIPS", Rows(named=slips | {"left_over": LEFT_OVER}))
    yield "-- Why frames cannot be read.\n"
    yield _assign("REASONS", Rows(named={key.replace("-", "_"): said for key, said in REASONS.items()}))
    refused: dict[Any, object] = {OF_VALUES[wrong].code: True for wrong in (Wrong.REFUSED, Wrong.LABEL_NUMBER)}
    yield _assign("REFUSED", Table(named=refused))


def _unlock() -> Iterator[str]:
    # Lua's patterns lack optional groups: one pattern with the version, one without it.
    patterns = [
        f"^{_plain(discovery.UNLOCK_REQUEST)}([%w_:]*) ?{version}(\r?\n)"
        f"{_plain(discovery.UNLOCK_PROTOCOL)} ?{discovery.PROTOCOL}()"
        for version in (_plain(discovery.UNLOCK_VERSION), "")
    ]
    first = {ord(discovery.UNLOCK_REQUEST[0]): True, discovery.ACCEPT[0]: True}
    texts: dict[Any, object] = {
        "patterns": Table(patterns),
        "request": discovery.UNLOCK_REQUEST,
        "most_bytes": discovery.MOST_UNLOCK,
        "endings": discovery.UNLOCK_ENDINGS,
        "answer": discovery.ACCEPT.decode("ascii"),
        "starts": Table(named=first),
        "missing": discovery.NOT_UNLOCKED,
    }
    yield "-- The text that unlocks the brick over WiFi, and its answer. By their lengths, frames start differently.\n"
    yield _assign("UNLOCK", Table(named=texts))
    yield "\n"


def _plain(text: str) -> str:
    """Returns a Lua pattern that matches exactly this text."""
    return re.sub(r"([^\w\s/:=])", r"%\1", text)
