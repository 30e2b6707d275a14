"""The wire format in Construct's own words: from the identification byte of an argument to the whole frame.

Read from top to bottom, this describes the protocol; opcodes, CMDs, parameters and fields come from the tables.
`ev3proto.schema` has the result, as FRAME and OPERATIONS. Parsing keeps the encoding of each argument, so that building
gives the same bytes; a plain value is built in its shortest encoding. The readers beside this file are its fast form,
and tests hold the two together.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Mapping
from functools import cache
from typing import Any, NamedTuple

from construct import (
    Array,
    BitsInteger,
    BitStruct,
    Bitwise,
    Bytes,
    ByteSwapped,
    Check,
    Computed,
    Const,
    Construct,
    Default,
    Enum,
    ExprAdapter,
    FixedSized,
    Flag,
    FocusedSeq,
    GreedyBytes,
    GreedyRange,
    If,
    IfThenElse,
    Int8sl,
    Int8ul,
    Int16sl,
    Int16ul,
    Int32sl,
    Int32ul,
    NullTerminated,
    Pass,
    Prefixed,
    Select,
    StopIf,
    StringEncoded,
    Struct,
    Switch,
    Tell,
    Terminated,
    this,
)

from ev3proto.errors import BuildError, DecodeError
from ev3proto.tables import OPCODES, operations
from ev3proto.tables.daisy import SENSOR_DATA_SIZE, DaisySubCommand
from ev3proto.tables.declaration import DATA8, Declaration, Parameter, Type
from ev3proto.tables.encoding import COUNTS, STRING_CODING
from ev3proto.tables.enumerations import FORMAT_TYPES
from ev3proto.tables.frame import GLOBAL_BITS, LOCAL_BITS, MAX_LENGTH, SYSTEM_COMMAND_TYPES, MessageType
from ev3proto.tables.mailboxes import message_of
from ev3proto.tables.system import LONG_COMMANDS, SYSTEM, FieldKind, SystemField, SystemStatus

# Arguments: an identification byte, and the value that it announces

LONG_FORM = Struct(
    "selector" / Flag,  # a variable is global; a constant is a label
    "handle" / Flag,
    "address" / Flag,
    "width" / BitsInteger(3),
)
SHORT_VARIABLE = Struct("is_global" / Flag, "value" / BitsInteger(5))
SHORT_CONSTANT = Struct("value" / BitsInteger(6, signed=True))
_BITS = Struct(
    "is_long" / Flag,  # the value is in the bytes that follow
    "is_variable" / Flag,  # the value is an index in memory
    "form" / IfThenElse(this.is_long, LONG_FORM, IfThenElse(this.is_variable, SHORT_VARIABLE, SHORT_CONSTANT)),
)
IDENTIFICATION = FixedSized(1, Bitwise(_BITS))

TEXT = StringEncoded(NullTerminated(GreedyBytes), STRING_CODING)
UNDEFINED = Check(False)


def _encoded(four_bytes: Construct) -> Construct:
    width = this.identification.form.width  # 1, 2 and 3 announce 1, 2 and 4 bytes, 0 and 4 a text up to its zero
    indexes = Switch(width, {1: Int8ul, 2: Int16ul, 3: Int32ul}, UNDEFINED)
    texts = {0: TEXT, 4: TEXT}
    constants = Switch(width, {1: Int8sl, 2: Int16sl, 3: four_bytes, **texts}, UNDEFINED)
    labels_and_constants = IfThenElse(this.identification.form.selector, Int8sl, constants)
    long_value = IfThenElse(this.identification.is_variable, indexes, labels_and_constants)
    short_value = Computed(this.identification.form.value)
    return Struct(
        "offset" / Tell,
        "identification" / IDENTIFICATION,
        "value" / IfThenElse(this.identification.is_long, long_value, short_value),
    )


def _float_of(bits: int) -> float:
    if ~bits & 0x7F800000:
        return float(struct.unpack("<f", struct.pack("<I", bits))[0])
    double = (bits & 0x80000000) << 32 | 0x7FF << 52 | (bits & 0x7FFFFF) << 29
    return float(struct.unpack("<d", struct.pack("<Q", double))[0])


def _bits_of(value: float) -> int:
    double = int.from_bytes(struct.pack("<d", value), "little")
    if ~double & 0x7FF << 52:
        return int.from_bytes(struct.pack("<f", value), "little")
    return double >> 32 & 0x80000000 | 0xFF << 23 | double >> 29 & 0x7FFFFF


SINGLE = ExprAdapter(Int32ul, lambda bits, _: _float_of(bits), lambda value, _: _bits_of(value))
"""Float32l, but with all bits of a "not a number"."""

# What cannot be read becomes an error with offset and path, which Construct's own errors do not have together.
UNREADABLE = Struct("offset" / Tell, "rest" / GreedyBytes)
ENCODED, ENCODED_FLOAT = (Select(_encoded(four_bytes), UNREADABLE) for four_bytes in (Int32sl, SINGLE))

Shortest = Callable[[Parameter, Any], bytes]
"""Returns the shortest encoding of a plain value for a parameter. Raises BuildError if there is none."""


def _argument(parameter: Parameter, operation: str, shortest: Shortest) -> Construct:
    encoded, name = ENCODED_FLOAT if parameter.type is Type.DATAF else ENCODED, parameter.name

    def readable(found: Any, _: Any) -> Any:
        if "rest" in found:
            is_cut = "rest" not in encoded.parse(found.rest + bytes(4))
            what = "the bytes end before or in" if is_cut else f"undefined identification byte 0x{found.rest[0]:02X} of"
            raise _error(found.offset, f"{what} the argument {name}", operation, name, truncated=is_cut)
        return found

    def encode(given: Any, _: Any) -> Any:
        try:
            return given if isinstance(given, Mapping) else encoded.parse(shortest(parameter, given))
        except BuildError as error:
            raise BuildError(str(error), f"(building) -> {operation} -> {name}") from None

    return ExprAdapter(encoded, readable, encode)


def _error(offset: int, reason: str, *path: str, truncated: bool = False) -> DecodeError:
    return DecodeError(offset, reason, truncated, path=" -> ".join(("(parsing)", *path)))


def _constant(argument: Construct, given: Any) -> Any:
    """Returns the number in an argument, parsed or to be built; None for a variable, a label or a text."""
    found = given if isinstance(given, Mapping) else argument.parse(argument.build(given))
    first = found["identification"]
    is_constant = not first["is_variable"] and not (first["is_long"] and first["form"]["selector"])
    return found["value"] if is_constant and isinstance(found["value"], int) else None


# Lists at the end of an operation: a constant counts the arguments that follow it


def _count(parameter: Parameter, operation: str, counter: Construct) -> Construct:
    def checked(found: Any, context: Any) -> Any:
        if context._building:
            if _constant(counter, found) is None:
                raise BuildError(f"{parameter.name} must be a constant: it is the number of values that follow")
            return found
        room = _left(context._io)
        if parameter.counts:
            room = min(room, COUNTS.high)
        if _constant(counter, found) not in range(room + 1):
            reason = f"{parameter.name} must be a constant: there is room for 0 to {room} values"
            raise _error(found.offset, reason, operation, parameter.name)
        return found

    return ExprAdapter(counter, checked, checked)


def _left(stream: Any) -> int:
    """Returns the number of bytes that are left in a stream."""
    at = stream.tell()
    left = stream.seek(0, 2) - at
    stream.seek(at)
    return int(left)


def _arguments(entry: Declaration, shortest: Shortest) -> Construct:
    """Returns the arguments after opcode and CMD."""
    nodes = {each.name: _argument(each, entry.name, shortest) for each in entry.fixed}
    fields = [name / node for name, node in nodes.items()]
    tail = entry.tail
    if tail is None:
        return Struct(*fields)
    counting, element, typed_by = tail
    counted_by = f"{counting.name}_COUNT" if counting.counts else counting.name
    counter = nodes[counting.name]

    def listed(kind: Type) -> Construct:
        argument = _argument(element._replace(type=kind), entry.name, shortest)
        return Array(lambda each: _constant(counter, each[counted_by]), argument)

    elements = listed(element.type)
    if typed_by is not None:
        by_format = {number: listed(kind) for number, kind in FORMAT_TYPES.items()}
        elements = Switch(lambda each: _constant(nodes[typed_by], each[typed_by]), by_format, elements)
    count = Default(_count(counting, entry.name, counter), lambda each: len(each[element.name]))
    return Struct(*fields[:-1], counted_by / count, element.name / elements)


# Byte code: an opcode, the CMD of a family, the arguments; then the next operation, to the end of the bytes


def _number(field: Construct, given: Any) -> int:
    """Returns the number of a field of one byte, which may be given by its name."""
    return int(field.build(given)[0])


def _operation(dialect: str, pairs: Mapping[str, Construct], shortest: Shortest) -> Construct:
    opcodes = [opcode for opcode in OPCODES if dialect in opcode.dialects]
    code = Enum(Int8ul, **{opcode.name: opcode.number for opcode in opcodes})
    cmds, known = {}, {}
    for opcode in opcodes:
        if opcode.is_family:
            names = {command.name: command.number for command in opcode.commands if dialect in command.dialects}
            parameter = Parameter("CMD", DATA8, "the command of the family", names=names)
            cmds[opcode.number] = _argument(parameter, opcode.name, shortest)
    for name, entry in operations(dialect).items():
        known[entry.opcode.number, entry.command and entry.command.number] = pairs[name]

    def pair(each: Any) -> tuple[int, Any]:
        number = _number(code, each.opcode)
        return number, _constant(cmds[number], each.cmd) if number in cmds else None

    def unknown(each: Any) -> None:
        number, _ = pair(each)
        if each._building:
            raise BuildError(f"unknown operation: opcode {each.opcode}, CMD {each.cmd}")
        if number not in cmds:
            raise _error(each.offset, f"unknown opcode 0x{number:02X}")
        raise _error(each.cmd.offset, f"{each.opcode} has no CMD {each.cmd.value}", str(each.opcode), "CMD")

    return Struct(
        "offset" / Tell,
        "opcode" / code,
        "cmd" / Default(Switch(lambda each: _number(code, each.opcode), cmds, Pass), None),
        "arguments" / Default(Switch(pair, known, Computed(unknown)), {}),
    )


def _byte_code(operation: Construct) -> Construct:
    # GreedyRange ends where an operation cannot be read. Reading it once more raises the reason.
    refused = Computed(lambda each: operation.parse_stream(each._io) if _left(each._io) else None)
    return FocusedSeq("operations", "operations" / GreedyRange(operation), refused)


# System messages: a command with its fields; a reply with the command, the status, its fields

NUMBERS: dict[FieldKind, Construct] = {FieldKind.U8: Int8ul, FieldKind.U16: Int16ul, FieldKind.U32: Int32ul}
KINDS: dict[FieldKind, Construct] = {
    **NUMBERS,
    FieldKind.TEXT: TEXT,
    FieldKind.DATA: GreedyBytes,
    FieldKind.LISTING: StringEncoded(GreedyBytes, STRING_CODING),
}


def counted_text(counter: str) -> Construct:
    """Returns the Construct of a text whose length is in another field, with or without the zero at its end."""
    zero = If(lambda each: not each.text.endswith(b"\0"), Const(b"\0"))
    return ExprAdapter(
        FocusedSeq("text", "text" / Bytes(lambda each: each._[counter]), zero),
        lambda text, _: text.removesuffix(b"\0").decode(STRING_CODING),
        lambda text, each: text.encode(STRING_CODING).ljust(each[counter], b"\0"),
    )


def _counted_data(counter: str) -> Construct:
    data = FocusedSeq("data", "data" / Bytes(lambda each: each._[counter]), Terminated)
    return ExprAdapter(data, lambda data, _: data, lambda message, _: message_of(message))


def _length_of(name: str) -> Callable[[Any], int]:
    return lambda each: len(message_of(each[name]))


def _ends_before(field: SystemField, may_end: Callable[[Any], bool]) -> Callable[[Any], bool]:
    def ends(each: Any) -> bool:
        is_missing = each.keys().isdisjoint({field.name, field.counts}) if each._building else not _left(each._io)
        return is_missing and (field.optional or may_end(each))

    return ends


def fields_of(declared: tuple[SystemField, ...], may_end: Callable[[Any], bool] = lambda _: False) -> Struct:
    """Returns the fields of a system message, to the end of the bytes.

    Args:
        declared: Their entries in the tables.
        may_end: Whether the message may end before any field, by the context of the fields.
    """
    counters = {field.counts: field.name for field in declared}
    nodes = []
    for field in declared:
        if field.counts is not None:
            node = Default(NUMBERS[field.kind], _length_of(field.counts))
        elif field.name in counters:
            counted = counted_text if field.kind is FieldKind.COUNTED_TEXT else _counted_data
            node = counted(counters[field.name])
        else:
            node = KINDS[field.kind]
        nodes += [StopIf(_ends_before(field, may_end)), field.name / node]
    return Struct(*nodes, Terminated)


def _system_bodies() -> dict[str, Construct]:
    command = Enum(Int8ul, **{entry.name: entry.number for entry in reversed(SYSTEM)})
    status = Enum(Int8ul, SystemStatus)

    def failed(each: Any) -> bool:
        return bool(_number(status, each._.status)) or _number(TYPE, each._._.type) == MessageType.SYSTEM_REPLY_ERROR

    def chosen(fields: Mapping[int, Construct]) -> Construct:
        return Default(Switch(lambda each: _number(command, each.command), fields, UNDEFINED), {})

    requests = {entry.number: entry.name / fields_of(entry.request) for entry in SYSTEM}
    replies = {entry.number: entry.name / fields_of(entry.reply, failed) for entry in SYSTEM}
    return {
        "system-command": Struct("command" / command, "fields" / chosen(requests)),
        "system-reply": Struct("command" / command, "status" / Default(status, 0), "fields" / chosen(replies)),
    }


# Messages between the bricks of a daisy chain

SENSOR_REPORT = Struct(
    "layer" / Int8ul,
    "port" / Int8ul,
    "status" / Int8ul,
    "type" / Int8ul,
    "mode" / Int8ul,
    "data" / Bytes(SENSOR_DATA_SIZE),
    "checksum" / Int8ul,
    "busy" / GreedyBytes,
)
"""A sensor of another layer, in a daisy reply."""


def _daisy_bodies(byte_code: Construct) -> dict[str, Construct]:
    command = Enum(Int8ul, DaisySubCommand)
    layers = ("layer_from" / Int8ul, "layer_to" / Int8ul)
    operations_or_bytes = Select(byte_code, GreedyBytes)
    payloads = {each: operations_or_bytes if each.carries_operations else GreedyBytes for each in DaisySubCommand}
    payload = Switch(lambda each: _number(command, each.command), payloads, UNDEFINED)
    return {
        "daisy-command": Struct("command" / command, *layers, "payload" / payload),
        "daisy-reply": Struct(*layers, "payload" / Select(SENSOR_REPORT, GreedyBytes)),
    }


# Frames: length, counter, type, and a body that depends on the type

TYPE = Enum(Int8ul, MessageType)

MEMORY = ByteSwapped(
    BitStruct("locals" / Default(BitsInteger(LOCAL_BITS), 0), "globals" / Default(BitsInteger(GLOBAL_BITS), 0))
)
"""The bytes of memory that a direct command requests: the bits of two bytes, read as one little-endian number."""


def _direct_bodies(byte_code: Construct) -> dict[str, Construct]:
    return {
        "direct-command": Struct("memory" / Default(MEMORY, {}), "operations" / byte_code),
        "direct-reply": Struct("memory" / GreedyBytes),
    }


def _fits(each: Any) -> bool:
    contents = each._io.getvalue()
    is_long = contents[2] in SYSTEM_COMMAND_TYPES.values() and contents[3] in LONG_COMMANDS
    return is_long or len(contents) <= MAX_LENGTH


class WireFormat(NamedTuple):
    """The wire format of a dialect.

    FRAME       a frame of any type
    OPERATIONS  the arguments of each operation, by its name: `SOUND.TONE`
    """

    FRAME: Construct
    OPERATIONS: dict[str, Construct]


@cache
def wire_format(dialect: str, shortest: Shortest) -> WireFormat:
    """Returns the wire format of a dialect, created once.

    Args:
        dialect: "official", "xtended" or "compat".
        shortest: Chooses the encoding of plain values.
    """
    pairs = {name: name / _arguments(entry, shortest) for name, entry in operations(dialect).items()}
    byte_code = _byte_code(_operation(dialect, pairs, shortest))
    bodies = {**_direct_bodies(byte_code), **_system_bodies(), **_daisy_bodies(byte_code)}
    body = Switch(
        lambda each: _number(TYPE, each.type), {int(each): bodies[each.kind] for each in MessageType}, UNDEFINED
    )
    contents = Struct("counter" / Default(Int16ul, 0), "type" / TYPE, "body" / body, Check(_fits))
    return WireFormat(Prefixed(Int16ul, contents), pairs)
