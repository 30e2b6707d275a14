"""The frame: length, message counter, type, and a body that the type decides. Parsing and building start here."""

from __future__ import annotations

import struct
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

from construct import BitsInteger, BitStruct, Bytes, ByteSwapped, GreedyBytes, Int8ul, Int16ul, Struct
from construct.core import ConstructError

from ev3proto.errors import BuildError, DecodeError, Fault
from ev3proto.messages import (
    NO_FLAW,
    DaisyCommand,
    DaisyReply,
    DirectCommand,
    DirectReply,
    FieldValue,
    Flaw,
    Message,
    Operation,
    SensorReport,
    SystemCommand,
    SystemReply,
)
from ev3proto.schema.bytewise import Bytewise
from ev3proto.schema.fields import Fields
from ev3proto.schema.instructions import InstructionSet, instruction_set
from ev3proto.schema.packed import packed
from ev3proto.tables import daisy, system
from ev3proto.tables.frame import (
    COUNTERS,
    GLOBAL_BITS,
    LENGTH_FIELD,
    LOCAL_BITS,
    MAX_FRAME,
    MAX_GLOBALS,
    MAX_LENGTH,
    MAX_LOCALS,
    MIN_LENGTH,
    MessageType,
)

HEADER = Struct("length" / Int16ul, "counter" / Int16ul, "type" / Int8ul)
"""What every frame starts with."""

MEMORY = ByteSwapped(BitStruct("locals" / BitsInteger(LOCAL_BITS), "globals" / BitsInteger(GLOBAL_BITS)))
"""The two bytes of a direct command that ask for memory, as bits of one little-endian number."""

SENSOR_REPORT = Struct(
    "layer" / Int8ul,
    "port" / Int8ul,
    "status" / Int8ul,
    "type" / Int8ul,
    "mode" / Int8ul,
    "data" / Bytes(daisy.SENSOR_DATA_SIZE),
    "checksum" / Int8ul,
    "busy" / GreedyBytes,
)
"""A sensor of another layer in a daisy reply."""


_header = packed(HEADER)
_unpack_header = _header.unpack_from
_memory = struct.Struct("<H")
_command_header = struct.Struct(_header.format + "H").unpack_from
HEADER_SIZE = HEADER.sizeof()
MEMORY_SIZE = MEMORY.sizeof()
COMMAND_HEADER_SIZE = HEADER_SIZE + MEMORY_SIZE
_DIRECT_COMMANDS = {member.value: member for member in MessageType if member.kind == "direct-command"}
_DIRECT_REPLIES = {member.value: member for member in MessageType if member.kind == "direct-reply"}

REQUESTS = {command.number: Fields(command.request) for command in system.SYSTEM}
REPLIES = {command.number: Fields(command.reply) for command in system.SYSTEM}

Body = tuple[Message | None, bytes, DecodeError | None]
"""A message, the bytes at its end that could not be read, and why not; no message where its fixed part is cut."""

BodyReader = Callable[[bytes, int, int, MessageType], Body]


_set_type, _set_counter, _set_flaw, _set_globals, _set_locals, _set_operations = (
    getattr(DirectCommand, name).__set__
    for name in ("type", "counter", "flaw", "global_size", "local_size", "operations")
)
"""The slots of a direct command. Filling them takes a third of the time of the frozen class's own constructor."""

_set_reply_type, _set_reply_counter, _set_reply_flaw, _set_memory = (
    getattr(DirectReply, name).__set__ for name in ("type", "counter", "flaw", "memory")
)
"""Those of a direct reply."""

_new = object.__new__


def _direct_command(member: MessageType, counter: int, memory: int, operations: tuple[Operation, ...]) -> DirectCommand:
    message = _new(DirectCommand)
    _set_type(message, member)
    _set_counter(message, counter)
    _set_flaw(message, NO_FLAW)
    _set_globals(message, memory & MAX_GLOBALS)
    _set_locals(message, memory >> GLOBAL_BITS)
    _set_operations(message, operations)
    return message


def _direct_reply(member: MessageType, counter: int, memory: bytes) -> DirectReply:
    message = _new(DirectReply)
    _set_reply_type(message, member)
    _set_reply_counter(message, counter)
    _set_reply_flaw(message, NO_FLAW)
    _set_memory(message, memory)
    return message


class FrameSchema(Bytewise):
    """The schema of one frame, for one dialect."""

    def __init__(self, dialect: str) -> None:
        super().__init__()
        self.instructions: InstructionSet = instruction_set(dialect)
        self._read_operations = self.instructions.read_quickly
        bodies = {
            "direct-command": self._direct_command,
            "direct-reply": self._direct_reply,
            "system-command": self._system_command,
            "system-reply": self._system_reply,
            "daisy-command": self._daisy_command,
            "daisy-reply": self._daisy_reply,
        }
        self._empty: dict[str, type[Message]] = {
            "direct-command": DirectCommand,
            "system-command": SystemCommand,
            "system-reply": SystemReply,
            "daisy-command": DaisyCommand,
            "daisy-reply": DaisyReply,
        }
        # Keyed by plain numbers: looking a member of an enumeration up takes three times as long.
        self._types: dict[int, tuple[MessageType, BodyReader]] = {
            member.value: (member, bodies[member.kind]) for member in MessageType
        }

    # Reading

    def read(self, data: bytes, at: int) -> tuple[Message, int]:
        """The frame at an offset, and the offset behind it. Raises DecodeError."""
        if len(data) - at < LENGTH_FIELD:
            raise DecodeError(at, "a frame starts with two bytes of length", truncated=True)
        end = at + LENGTH_FIELD + int(Int16ul.parse(data[at : at + LENGTH_FIELD]))
        return self.read_frame(data[at:end]), end

    def read_frame(self, frame: bytes) -> Message:
        """Exactly one frame. DecodeError names the offset and the reason."""
        size = len(frame)
        message = self._read_quickly(frame, size)
        if message is not None:
            return message
        if HEADER_SIZE <= size <= MAX_FRAME:
            length, counter, code = _header.unpack_from(frame)
            found = self._types.get(code)
            if found is not None and length + LENGTH_FIELD == size:
                member, read_body = found
                message, _, error = read_body(frame, size, counter, member)
                if error is None:
                    assert message is not None
                    return message
                raise error
        raise self._envelope_error(frame)

    def _read_quickly(self, frame: bytes, size: int) -> Message | None:
        """The message of nearly every frame: a direct command or reply with nothing wrong. None for all others."""
        if not HEADER_SIZE <= size <= MAX_FRAME:
            return None
        length, counter, code = _unpack_header(frame)
        if length + LENGTH_FIELD != size:
            return None
        reply = _DIRECT_REPLIES.get(code)
        if reply is not None:
            return _direct_reply(reply, counter, frame[HEADER_SIZE:])
        command = _DIRECT_COMMANDS.get(code)
        if command is None or size < COMMAND_HEADER_SIZE:
            return None
        operations = self._read_operations(frame, COMMAND_HEADER_SIZE, size)
        if operations is None:
            return None
        return _direct_command(command, counter, frame[HEADER_SIZE] | frame[HEADER_SIZE + 1] << 8, operations)

    def _envelope_error(self, frame: bytes) -> DecodeError:
        """What is wrong around the body; the body itself is not looked at."""
        size = len(frame)
        if size < HEADER_SIZE:
            return DecodeError(
                size,
                f"a frame has at least {HEADER_SIZE} bytes (length, counter, type), here are {size}",
                truncated=True,
            )
        length, _, code = _header.unpack_from(frame)
        if not MIN_LENGTH <= length <= MAX_LENGTH:
            return DecodeError(
                0, f"the length field says {length}; a frame can have {MIN_LENGTH} to {MAX_LENGTH} bytes behind it"
            )
        end = length + LENGTH_FIELD
        if size < end:
            return DecodeError(
                0, f"the frame is cut off: its length field says {length} bytes follow, {size - LENGTH_FIELD} do", True
            )
        if size > end:
            return DecodeError(
                end,
                f"the frame is longer than its length field says: {length} bytes should follow it,"
                f" {size - LENGTH_FIELD} do{_bootloader_hint(frame, code)}",
            )
        return DecodeError(4, f"0x{code:02X} is no message type")

    def read_leniently(self, frame: bytes) -> Message:
        """A message for any bytes at all: what can be read is there, `fault` says what is wrong."""
        size = len(frame)
        message = self._read_quickly(frame, size)
        if message is not None:
            return message
        if size < HEADER_SIZE:
            return Message(flaw=Flaw(self._envelope_error(frame).fault, frame))
        length, counter, code = _header.unpack_from(frame)
        stated = None if length == size - LENGTH_FIELD else length
        envelope = None
        if stated is not None or size > MAX_FRAME or code not in self._types:
            envelope = self._envelope_error(frame) if size <= MAX_FRAME or stated is not None else _too_long(size)
        if code not in self._types:
            assert envelope is not None
            return Message(counter=counter, flaw=Flaw(envelope.fault, frame, stated))
        end = min(size, max(length + LENGTH_FIELD, HEADER_SIZE))
        member, read_body = self._types[code]
        message, rest, error = read_body(frame[:end], end, counter, member)
        if error is None and envelope is None:
            assert message is not None
            return message
        fault = _worse(envelope, error)
        if message is None:
            message = self._empty[member.kind](type=member, counter=counter)
            return replace(message, flaw=Flaw(fault, rest + frame[end:], stated, headless=True))
        return replace(message, flaw=Flaw(fault, rest + frame[end:], stated))

    def _direct_command(self, frame: bytes, end: int, counter: int, member: MessageType) -> Body:
        start = COMMAND_HEADER_SIZE
        if end < start:
            error = DecodeError(end, "a direct command starts with two bytes that ask for memory", truncated=True)
            return None, frame[HEADER_SIZE:], error
        memory = _command_header(frame)[3]
        operations, fault = self.instructions.read_between(frame, start, end)
        message = _direct_command(member, counter, memory, operations)
        if fault is None:
            return message, b"", None
        return message, frame[operations[-1].offset + operations[-1].length if operations else start :], fault

    def _direct_reply(self, frame: bytes, end: int, counter: int, member: MessageType) -> Body:
        return _direct_reply(member, counter, frame[HEADER_SIZE:end]), b"", None

    def _system_command(self, frame: bytes, end: int, counter: int, member: MessageType) -> Body:
        at = HEADER_SIZE
        if end <= at:
            error = DecodeError(end, "the frame ends where the system command should stand", truncated=True)
            return None, b"", error
        number = frame[at]
        known = system.SYSTEM_BY_NUMBER.get(number)
        if known is None:
            error = DecodeError(at, f"0x{number:02X} is no system command")
            return SystemCommand(type=member, counter=counter, number=number), frame[at + 1 :], error
        fields, at, fault = REQUESTS[number].read_leniently(frame, at + 1, complete=True)
        message = SystemCommand(type=member, counter=counter, number=number, command=known.name, fields=fields)
        return message, frame[at:], fault

    def _system_reply(self, frame: bytes, end: int, counter: int, member: MessageType) -> Body:
        at = HEADER_SIZE
        if end < at + 2:
            error = DecodeError(end, "a system reply starts with the command answered and a status", truncated=True)
            return None, frame[at:], error
        number, status = frame[at], frame[at + 1]
        known = system.SYSTEM_BY_NUMBER.get(number)
        if known is None:
            error = DecodeError(at, f"0x{number:02X} is no system command")
            reply = SystemReply(type=member, counter=counter, number=number, status_code=status)
            return reply, frame[at + 2 :], error
        failed = status != system.SystemStatus.SUCCESS or member.is_error
        fields, at, fault = REPLIES[number].read_leniently(frame, at + 2, complete=not failed)
        reply = SystemReply(
            type=member,
            counter=counter,
            number=number,
            command=known.name,
            status_code=status,
            fields=fields,
        )
        return reply, frame[at:], fault

    def _daisy_command(self, frame: bytes, end: int, counter: int, member: MessageType) -> Body:
        at = HEADER_SIZE
        if end < at + 3:
            error = DecodeError(end, "a daisy command starts with a sub-command and two layers", truncated=True)
            return None, frame[at:], error
        number, layer_from, layer_to = frame[at : at + 3]
        name: str | None = None
        operations: tuple[Operation, ...] = ()
        fault: DecodeError | None = None
        try:
            command = daisy.DaisyCommand(number)
        except ValueError:
            fault = DecodeError(at, f"0x{number:02X} is no daisy sub-command")
        else:
            name = command.name
            if command.carries_operations:
                operations = self._operations_if_whole(frame, at + 3, end)
        message = DaisyCommand(
            type=member,
            counter=counter,
            number=number,
            command=name,
            layer_from=layer_from,
            layer_to=layer_to,
            payload=frame[at + 3 : end],
            operations=operations,
        )
        return message, b"", fault

    def _operations_if_whole(self, frame: bytes, at: int, end: int) -> tuple[Operation, ...]:
        operations, fault = self.instructions.read_between(frame, at, end)
        return () if fault else operations

    def _daisy_reply(self, frame: bytes, end: int, counter: int, member: MessageType) -> Body:
        at = HEADER_SIZE
        if end < at + 2:
            error = DecodeError(end, "a daisy reply starts with two layers", truncated=True)
            return None, frame[at:], error
        payload = frame[at + 2 : end]
        try:
            found = SENSOR_REPORT.parse(payload)
            report = SensorReport(**{field.name: found[field.name] for field in SENSOR_REPORT.subcons})
        except ConstructError:
            report = None
        message = DaisyReply(
            type=member, counter=counter, layer_from=frame[at], layer_to=frame[at + 1], payload=payload, report=report
        )
        return message, b"", None

    # Building

    def write(self, message: Message) -> bytes:
        """The frame of a message. BuildError names what no frame can carry."""
        if message.type is None:
            return message.rest
        flaw = message.flaw
        body = flaw.rest if flaw.headless else _BODIES[type(message)](message) + flaw.rest
        length = HEADER_SIZE - LENGTH_FIELD + len(body)
        if flaw.stated_length is not None:
            length = flaw.stated_length
        elif length > MAX_LENGTH and flaw.fault is None:
            raise BuildError(
                f"the frame would have {length + LENGTH_FIELD} bytes; the brick takes at most {MAX_FRAME} in one frame"
            )
        return self._head(length, message.counter, message.type) + body

    def _head(self, length: int, counter: int, code: int) -> bytes:
        try:
            return _header.pack(length, counter, code)
        except struct.error:
            raise BuildError(f"counter cannot be {counter!r}: it is a whole number from 0 to {COUNTERS - 1}") from None


def _bootloader_hint(frame: bytes, code: int) -> str:
    """Names the known fault of the brick's bootloader where the bytes look like it."""
    known = system.SYSTEM_BY_NUMBER.get(frame[HEADER_SIZE]) if len(frame) > HEADER_SIZE else None
    if code == MessageType.SYSTEM_COMMAND_REPLY and known is not None and known.bootloader:
        return (
            ". From a brick on a USB 3 port this is a known fault of its bootloader: the reply to"
            f" {known.name} with the request written over its first bytes"
        )
    return ""


def _worse(envelope: DecodeError | None, inner: DecodeError | None) -> Fault:
    """What is wrong with a frame: first what is wrong around it, then what is in it, unless that explains it."""
    if envelope is None:
        assert inner is not None
        return inner.fault
    if inner is None or inner.truncated:
        return envelope.fault
    return Fault(envelope.offset, f"{envelope.reason}; and at offset {inner.offset}: {inner.reason}")


def _too_long(size: int) -> DecodeError:
    return DecodeError(0, f"the frame has {size} bytes; no frame has more than {MAX_FRAME}")


def _direct_command_body(message: DirectCommand) -> bytes:
    for name, value, most in (
        ("global_size", message.global_size, MAX_GLOBALS),
        ("local_size", message.local_size, MAX_LOCALS),
    ):
        if not isinstance(value, int) or not 0 <= value <= most:
            raise BuildError(f"{name} cannot be {value!r}: a header can ask for 0 to {most} bytes")
    memory = _memory.pack(message.local_size << GLOBAL_BITS | message.global_size)
    return memory + b"".join([operation.raw for operation in message.operations])


def _direct_reply_body(message: DirectReply) -> bytes:
    return message.memory


def _system_command_body(message: SystemCommand) -> bytes:
    return _byte("number", message.number) + _present(REQUESTS, message.number, message.fields)


def _system_reply_body(message: SystemReply) -> bytes:
    head = _byte("number", message.number) + _byte("status", message.status_code)
    return head + _present(REPLIES, message.number, message.fields)


def _present(schemas: Mapping[int, Fields], number: int, fields: Mapping[str, FieldValue]) -> bytes:
    if not fields:
        return b""
    if number not in schemas:
        raise BuildError(f"0x{number:02X} is no system command, so nobody knows its fields")
    return schemas[number].write_present(fields)


def _byte(name: str, value: int) -> bytes:
    if isinstance(value, int) and 0 <= value <= 0xFF:
        return bytes((value,))
    raise BuildError(f"{name} cannot be {value!r}: it is a whole number from 0 to 255")


def _daisy_command_body(message: DaisyCommand) -> bytes:
    return _byte("number", message.number) + _layers(message) + message.payload


def _daisy_reply_body(message: DaisyReply) -> bytes:
    return _layers(message) + message.payload


def _layers(message: DaisyCommand | DaisyReply) -> bytes:
    return _byte("layer_from", message.layer_from) + _byte("layer_to", message.layer_to)


_BODIES: dict[type[Message], Callable[[Any], bytes]] = {
    DirectCommand: _direct_command_body,
    DirectReply: _direct_reply_body,
    SystemCommand: _system_command_body,
    SystemReply: _system_reply_body,
    DaisyCommand: _daisy_command_body,
    DaisyReply: _daisy_reply_body,
}


_SCHEMAS: dict[str, FrameSchema] = {}


def frame_schema(dialect: str = "official") -> FrameSchema:
    """The schema of frames for a dialect, made once. ValueError for an unknown dialect."""
    if dialect not in _SCHEMAS:
        _SCHEMAS[dialect] = FrameSchema(dialect)
    return _SCHEMAS[dialect]


class _Builder:
    """Building needs no dialect: operations know their bytes."""

    def write(self, message: Message) -> bytes:
        """The frame."""
        return frame_schema().write(message)


Message.frames = _Builder()


def parse(frame: bytes | bytearray | memoryview, *, strict: bool = True, dialect: str = "official") -> Message:
    """Exactly one frame.

    frame    from its length field to its last byte, and nothing behind it
    strict   False: nothing in the frame's contents raises; `message.fault` says what is wrong and where
    dialect  "official", "xtended" or "compat": the firmware whose instruction set to read by

    `message.build()` gives the same bytes again. Raises DecodeError, a ValueError with `offset` and `reason`.
    """
    if type(frame) is not bytes:
        frame = bytes(memoryview(frame))
    schema = _SCHEMAS.get(dialect) or frame_schema(dialect)
    return schema.read_frame(frame) if strict else schema.read_leniently(frame)
