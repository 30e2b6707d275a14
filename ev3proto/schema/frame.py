"""The frame: length, message counter, type, and a body that depends on the type. Parsing and building start here."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import lru_cache
from typing import TypeVar, overload

from construct.core import ConstructError

from ev3proto.errors import BuildError, DecodeError, Fault, as_bytes
from ev3proto.messages import (
    DaisyCommand,
    DaisyReply,
    DirectCommand,
    DirectReply,
    Flaw,
    Message,
    Operation,
    SensorReport,
    SystemCommand,
    SystemReply,
)
from ev3proto.schema.fields import REPLIES, REQUESTS, Fields
from ev3proto.schema.header import (
    COMMAND_HEADER_SIZE,
    HEADER_SIZE,
    build_frame,
    may_be_long,
    may_have_length,
    read_memory,
    unpack_header,
    write_memory,
)
from ev3proto.schema.instructions import InstructionSet, instruction_set
from ev3proto.schema.reasons import unreadable
from ev3proto.schema.wire_format import SENSOR_REPORT
from ev3proto.tables import daisy, system
from ev3proto.tables.frame import LENGTH_FIELD, MAX_FRAME, MESSAGE_TYPES, MessageType

Body = tuple[Message, bytes, DecodeError | None]
"""A message, the unreadable bytes at its end, and the reason."""

BodyReader = Callable[[bytes, int, MessageType], Body]


class FrameReader:
    """Reads the frames of one dialect."""

    def __init__(self, dialect: str) -> None:
        self._dialect = dialect
        self.instructions: InstructionSet = instruction_set(dialect)
        # The class of each kind of message, the reader of its body, and the fixed part that this begins with.
        bodies: dict[str, tuple[type[Message], BodyReader, int]] = {
            "direct-command": (DirectCommand, self._direct_command, 2),
            "direct-reply": (DirectReply, self._direct_reply, 0),
            "system-command": (SystemCommand, self._system_command, 1),
            "system-reply": (SystemReply, self._system_reply, 2),
            "daisy-command": (DaisyCommand, self._daisy_command, 3),
            "daisy-reply": (DaisyReply, self._daisy_reply, 2),
        }
        self._types = {number: (member, *bodies[member.kind]) for number, member in MESSAGE_TYPES.items()}

    def __reduce__(self) -> tuple[Callable[[str], FrameReader], tuple[str]]:
        """Pickles as the reader of its dialect, which is shared within a process."""
        return frame_reader, (self._dialect,)

    def read_frame(self, frame: bytes, *, strict: bool = True) -> Message:
        """Reads exactly one frame.

        Args:
            frame: The bytes from the length field to the last one.
            strict: If False, any bytes give a message, whose `fault` says what is wrong.

        Returns:
            The message, with everything that could be read.

        Raises:
            DecodeError: The frame is faulty, and `strict` is true. The error has the offset and the reason.
        """
        size = len(frame)
        if size < HEADER_SIZE:
            cut = unreadable(size, "no_header", True, size=size)
            if strict:
                raise cut
            return Message(flaw=Flaw(cut.fault, frame))
        length, counter, code = unpack_header(frame)
        known = self._types.get(code)
        envelope = stated = None
        contents = frame
        if length + LENGTH_FIELD != size or known is None or (size > MAX_FRAME and not may_be_long(frame)):
            envelope = _envelope_error(frame, length, code)
            if strict:
                raise envelope
            if length + LENGTH_FIELD != size:
                stated = length
                contents = frame[: max(length + LENGTH_FIELD, HEADER_SIZE)]
            elif size > MAX_FRAME and not may_be_long(frame):
                envelope = unreadable(0, "too_long", size=size)
            if known is None:
                return Message(counter=counter, flaw=Flaw(envelope.fault, frame, stated))
        member, kind, read_body, fixed = known
        is_headless = len(contents) < HEADER_SIZE + fixed
        if is_headless:
            cut = unreadable(len(contents), member.kind, True)
            body: Body = kind(type=member, counter=counter), contents[HEADER_SIZE:], cut
        else:
            body = read_body(contents, counter, member)
        message, rest, error = body
        if error is None and envelope is None:
            return message
        if strict:
            assert error is not None
            raise error
        flaw = Flaw(_worse(envelope, error), rest + frame[len(contents) :], stated, headless=is_headless)
        return replace(message, flaw=flaw)

    def _direct_command(self, frame: bytes, counter: int, member: MessageType) -> Body:
        start = COMMAND_HEADER_SIZE
        operations, fault = self.instructions.scan(frame, start, len(frame))
        global_size, local_size = read_memory(frame)
        message = DirectCommand(
            type=member,
            counter=counter,
            global_size=global_size,
            local_size=local_size,
            operations=tuple(operations),
        )
        if fault is None:
            return message, b"", None
        return message, frame[operations[-1].offset + operations[-1].length if operations else start :], fault

    def _direct_reply(self, frame: bytes, counter: int, member: MessageType) -> Body:
        return DirectReply(type=member, counter=counter, memory=frame[HEADER_SIZE:]), b"", None

    def _system_command(self, frame: bytes, counter: int, member: MessageType) -> Body:
        at = HEADER_SIZE
        number = frame[at]
        known = system.SYSTEM_BY_NUMBER.get(number)
        if known is None:
            message = SystemCommand(type=member, counter=counter, number=number)
            return message, frame[at + 1 :], unreadable(at, "no_system", byte=number)
        fields, at, fault = REQUESTS[number].read_leniently(frame, at + 1, complete=True)
        message = SystemCommand(type=member, counter=counter, number=number, command=known.name, fields=fields)
        return message, frame[at:], fault

    def _system_reply(self, frame: bytes, counter: int, member: MessageType) -> Body:
        at = HEADER_SIZE
        number, status = frame[at], frame[at + 1]
        known = system.SYSTEM_BY_NUMBER.get(number)
        if known is None:
            reply = SystemReply(type=member, counter=counter, number=number, status_code=status)
            return reply, frame[at + 2 :], unreadable(at, "no_system", byte=number)
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

    def _daisy_command(self, frame: bytes, counter: int, member: MessageType) -> Body:
        at = HEADER_SIZE
        number, layer_from, layer_to = frame[at : at + 3]
        name: str | None = None
        operations: tuple[Operation, ...] = ()
        fault: DecodeError | None = None
        try:
            command = daisy.DaisySubCommand(number)
        except ValueError:
            fault = unreadable(at, "no_daisy", byte=number)
        else:
            name = command.name
            found, wrong = (
                self.instructions.scan(frame, at + 3, len(frame)) if command.carries_operations else ([], None)
            )
            operations = tuple(found) if wrong is None else ()
        message = DaisyCommand(
            type=member,
            counter=counter,
            number=number,
            command=name,
            layer_from=layer_from,
            layer_to=layer_to,
            payload=frame[at + 3 :],
            operations=operations,
        )
        return message, b"", fault

    def _daisy_reply(self, frame: bytes, counter: int, member: MessageType) -> Body:
        at = HEADER_SIZE
        payload = frame[at + 2 :]
        try:
            found = SENSOR_REPORT.parse(payload)
            report = SensorReport(**{field.name: found[field.name] for field in SENSOR_REPORT.subcons})
        except ConstructError:
            report = None
        message = DaisyReply(
            type=member, counter=counter, layer_from=frame[at], layer_to=frame[at + 1], payload=payload, report=report
        )
        return message, b"", None


def build_message(message: Message) -> bytes:
    """Builds the frame of a message; a parsed message gives its original bytes."""
    flaw = message.flaw
    if message.type is None:
        return flaw.rest
    body = flaw.rest if flaw.headless else _body(message) + flaw.rest
    length = flaw.stated_length
    if length is None and flaw.fault is not None:
        length = HEADER_SIZE - LENGTH_FIELD + len(body)  # a faulty frame may be longer than the brick accepts
    return build_frame(message.type, message.counter, body, length)


def _body(message: Message) -> bytes:
    """Returns the body after the header, as far as it could be read."""
    match message:
        case DirectCommand():
            code = b"".join([operation.raw for operation in message.operations])
            return write_memory(message.global_size, message.local_size) + code
        case DirectReply():
            return message.memory
        case SystemCommand():
            return _byte("number", message.number) + _fields(REQUESTS, message)
        case SystemReply():
            head = _byte("number", message.number) + _byte("status", message.status_code)
            return head + _fields(REPLIES, message)
        case DaisyCommand():
            return _byte("number", message.number) + _layers(message) + message.payload
        case DaisyReply():
            return _layers(message) + message.payload
    return b""


def _byte(name: str, value: int) -> bytes:
    if isinstance(value, int) and 0 <= value <= 0xFF:
        return bytes((value,))
    raise BuildError(f"{name} cannot be {value!r}: it is a whole number from 0 to 255")


def _layers(message: DaisyCommand | DaisyReply) -> bytes:
    return _byte("layer_from", message.layer_from) + _byte("layer_to", message.layer_to)


def _fields(schemas: Mapping[int, Fields], message: SystemCommand | SystemReply) -> bytes:
    if not message.fields:
        return b""
    if message.number not in schemas:
        raise BuildError(f"unknown system command 0x{message.number:02X}: its fields are not known")
    return schemas[message.number].write_present(message.fields)


def _envelope_error(frame: bytes, length: int, code: int) -> DecodeError:
    """Returns what is wrong with the frame outside its body."""
    size = len(frame) - LENGTH_FIELD
    if not may_have_length(frame):
        return unreadable(0, "wrong_length", length=length)
    if size < length:
        return unreadable(0, "cut_off", True, length=length, size=size)
    if size == length:
        return unreadable(HEADER_SIZE - 1, "no_type", byte=code)
    longer = unreadable(length + LENGTH_FIELD, "longer", length=length, size=size)
    known = system.SYSTEM_BY_NUMBER.get(frame[HEADER_SIZE]) if len(frame) > HEADER_SIZE else None
    if code == MessageType.SYSTEM_COMMAND_REPLY and known is not None and known.bootloader:
        return unreadable(longer.offset, "bootloader", reason=longer.reason, name=known.name)
    return longer


def _worse(envelope: DecodeError | None, inner: DecodeError | None) -> Fault:
    """Joins the faults of a frame: the outer one first, then the inner one, unless the first explains it."""
    if envelope is None:
        assert inner is not None
        return inner.fault
    if inner is None or inner.truncated:
        return envelope.fault
    return unreadable(envelope.offset, "two", reason=envelope.reason, offset=inner.offset, inner=inner.reason).fault


_READERS: dict[str, FrameReader] = {}


def frame_reader(dialect: str = "official") -> FrameReader:
    """Returns the reader of frames of a dialect, created once.

    Args:
        dialect: "official", "xtended" or "compat".

    Returns:
        The reader.

    Raises:
        ValueError: The dialect is unknown.
    """
    if dialect not in _READERS:
        _READERS[dialect] = FrameReader(dialect)
    return _READERS[dialect]


# Checking and then showing a frame reads it twice; one more entry is for the fixed frame.
@lru_cache(2)
def read_last(frame: bytes, dialect: str) -> Message:
    """Reads a frame, or returns the cached message of one of the last frames. No content of it raises."""
    return frame_reader(dialect).read_frame(frame, strict=False)


M = TypeVar("M", bound=Message)


@overload
def parse(frame: bytes | bytearray | memoryview, *, strict: bool = True, dialect: str = "official") -> Message: ...


@overload
def parse(
    frame: bytes | bytearray | memoryview, *, expect: type[M], strict: bool = True, dialect: str = "official"
) -> M: ...


def parse(
    frame: bytes | bytearray | memoryview,
    *,
    expect: type[Message] = Message,
    strict: bool = True,
    dialect: str = "official",
) -> Message:
    """Reads exactly one frame.

    Args:
        frame: The bytes from the length field to the last one, and nothing after them.
        expect: The class of the message, such as `DirectReply`: type checkers then know the result, and another
            message is an error. When omitted, any message is accepted.
        strict: If False, no content raises; `message.fault` says what is wrong and where.
        dialect: "official", "xtended" or "compat": the firmware whose instruction set is used.

    Returns:
        The message. `message.build()` returns the same bytes.

    Raises:
        DecodeError: The frame is faulty, and `strict` is true. It is a ValueError with `offset` and `reason`.
        DecodeError: The message is not of the expected class.
        ValueError: The dialect is unknown.
        TypeError: The frame is not bytes.
    """
    if type(frame) is not bytes:
        frame = as_bytes(frame, "a frame")
    reader = _READERS.get(dialect) or frame_reader(dialect)
    message = reader.read_frame(frame, strict=strict)
    if expect is not Message and not isinstance(message, expect):
        raise DecodeError(HEADER_SIZE - 1, f"expected a {expect.__name__}, but this is a {type(message).__name__}")
    return message


def is_flawless(frame: bytes, reader: FrameReader | None = None) -> bool:
    """Returns whether a brick could read all of a frame, and knows its command.

    Args:
        frame: The bytes from the length field to the last one.
        reader: The reader of the dialect; None: of the official one.
    """
    message = (reader or frame_reader()).read_frame(frame, strict=False)
    if message.fault is not None:
        return False
    return not isinstance(message, SystemCommand | SystemReply) or message.command is not None
