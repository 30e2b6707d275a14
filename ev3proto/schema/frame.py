"""The frame: length, message counter, type, and a body that the type decides. Parsing and building start here."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache, partial
from typing import NamedTuple, TypeVar, overload

from construct import Bytes, GreedyBytes, Int8ul, Struct
from construct.core import ConstructError

from ev3proto.errors import DecodeError, Fault, as_bytes
from ev3proto.messages import (
    NO_FLAW,
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
    set_operations,
)
from ev3proto.schema.bytewise import Bytewise
from ev3proto.schema.fields import REPLIES, REQUESTS
from ev3proto.schema.header import (
    COMMAND_HEADER_SIZE,
    HEADER_SIZE,
    frame_size,
    may_be_long,
    unpack_command_header,
    unpack_header,
    unpack_memory,
)
from ev3proto.schema.instructions import InstructionSet, instruction_set
from ev3proto.tables import daisy, system
from ev3proto.tables.frame import (
    GLOBAL_BITS,
    LENGTH_FIELD,
    MAX_FRAME,
    MAX_GLOBALS,
    MAX_LENGTH,
    MIN_LENGTH,
    MessageType,
)

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


Body = tuple[Message | None, bytes, DecodeError | None]
"""A message, the bytes at its end that could not be read, and why not; no message where its fixed part is cut."""

BodyReader = Callable[[bytes, int, int, MessageType], Body]


_set_type, _set_counter, _set_flaw, _set_globals, _set_locals = (
    getattr(DirectCommand, name).__set__ for name in ("type", "counter", "flaw", "global_size", "local_size")
)
_set_reply_type, _set_reply_counter, _set_reply_flaw, _set_memory = (
    getattr(DirectReply, name).__set__ for name in ("type", "counter", "flaw", "memory")
)
_new = object.__new__
# The slots of the two messages that nearly every frame is. With the constructor of the frozen class, which takes 1.3 us
# where filling the slots takes 0.5 us, parsing takes 1.66 times the plain decoder's time instead of 1.52.


def new_direct_command(
    member: MessageType,
    counter: int,
    global_size: int,
    local_size: int,
    operations: tuple[Operation, ...] | partial[tuple[Operation, ...]],
) -> DirectCommand:
    """Makes a direct command faster than its class does. Nothing is checked.

    Args:
        member: The type.
        counter: The message counter, 0 to 65535.
        global_size: Bytes of global memory, 0 to 1023.
        local_size: Bytes of local memory, 0 to 63.
        operations: The operations, where they stand in the frame, or what makes them when somebody asks for them.

    Returns:
        The command.

    """
    message = _new(DirectCommand)
    _set_type(message, member)
    _set_counter(message, counter)
    _set_flaw(message, NO_FLAW)
    _set_globals(message, global_size)
    _set_locals(message, local_size)
    set_operations(message, operations)
    return message


def _direct_reply(member: MessageType, counter: int, memory: bytes) -> DirectReply:
    message = _new(DirectReply)
    _set_reply_type(message, member)
    _set_reply_counter(message, counter)
    _set_reply_flaw(message, NO_FLAW)
    _set_memory(message, memory)
    return message


_DIRECT_COMMANDS = {member.value: member for member in MessageType if member.kind == "direct-command"}
_DIRECT_REPLIES = {member.value: member for member in MessageType if member.kind == "direct-reply"}


class CommandHead(NamedTuple):
    """What stands before the operations of a direct command.

    type         the message type
    counter      the message counter
    global_size  bytes of global memory asked for
    local_size   bytes of local memory asked for
    """

    type: MessageType
    counter: int
    global_size: int
    local_size: int


def command_head(frame: bytes) -> CommandHead | None:
    """What stands before the operations where a frame is a direct command of the size that it says, else None."""
    size = len(frame)
    if not COMMAND_HEADER_SIZE <= size <= MAX_FRAME:
        return None
    length, counter, code, memory = unpack_command_header(frame)
    if length + LENGTH_FIELD != size or code not in _DIRECT_COMMANDS:
        return None
    return CommandHead(_DIRECT_COMMANDS[code], counter, memory & MAX_GLOBALS, memory >> GLOBAL_BITS)


class FrameSchema(Bytewise):
    """The schema of one frame, for one dialect."""

    def __init__(self, dialect: str) -> None:
        super().__init__()
        self._dialect = dialect
        self.instructions: InstructionSet = instruction_set(dialect)
        self._operations = self.instructions.operations
        bodies: dict[str, tuple[type[Message], BodyReader]] = {
            "direct-command": (DirectCommand, self._direct_command),
            "direct-reply": (DirectReply, self._direct_reply),
            "system-command": (SystemCommand, self._system_command),
            "system-reply": (SystemReply, self._system_reply),
            "daisy-command": (DaisyCommand, self._daisy_command),
            "daisy-reply": (DaisyReply, self._daisy_reply),
        }
        # The keys are plain numbers: to look up a member of an enumeration takes three times as long.
        self._types = {member.value: (member, *bodies[member.kind]) for member in MessageType}

    def __reduce__(self) -> tuple[Callable[[str], FrameSchema], tuple[str]]:
        """There is one for each dialect, in every process; what was read by it can be pickled."""
        return frame_schema, (self._dialect,)

    # Reading

    def read(self, data: bytes, at: int) -> tuple[Message, int]:
        """Reads the frame at an offset.

        Args:
            data: The bytes that the frame is in. More frames may follow it.
            at: The offset of its length field.

        Returns:
            The message, and the offset after the frame.

        Raises:
            DecodeError: The frame is faulty.

        """
        if len(data) - at < LENGTH_FIELD:
            raise DecodeError(at, "a frame starts with two bytes of length", truncated=True)
        end = at + frame_size(data, at)
        return self.read_frame(data[at:end]), end

    def read_frame(self, frame: bytes, *, strict: bool = True) -> Message:
        """Reads exactly one frame.

        Args:
            frame: From its length field to its last byte.
            strict: False: any bytes give a message, whose `fault` says what is wrong with them.

        Returns:
            The message, with everything that can be read.

        Raises:
            DecodeError: The frame is faulty, and `strict` is true. The error names the offset and the reason.

        """
        size = len(frame)
        if HEADER_SIZE <= size <= MAX_FRAME or may_be_long(frame):
            length, counter, code = unpack_header(frame)
            known = self._types.get(code)
            if known is not None and length + LENGTH_FIELD == size:
                member, _, read_body = known
                message, _, fault = read_body(frame, size, counter, member)
                if fault is None and message is not None:
                    return message
                if fault is not None and strict:
                    raise fault
        if strict:
            raise self._envelope_error(frame)
        return self._read_faulty(frame)

    def read_for_later(self, frame: bytes, *, strict: bool = True) -> Message:
        """Reads exactly one frame, but makes the operations of a direct command only when somebody asks for them.

        That is for streams and captures, where many messages are only counted or paired. It takes a third of the time;
        with all arguments looked at in the end it takes a quarter longer: `pytest benchmarks -k ratios`.

        Args:
            frame: From its length field to its last byte.
            strict: As for `read_frame`.

        Returns:
            The message that `read_frame` gives.

        Raises:
            DecodeError: As `read_frame` does.

        """
        size = len(frame)
        if COMMAND_HEADER_SIZE <= size <= MAX_FRAME:
            length, counter, code, memory = unpack_command_header(frame)
            if length + LENGTH_FIELD == size:
                member = _DIRECT_COMMANDS.get(code)
                if member is not None:
                    instructions = self.instructions
                    if instructions.is_usual(frame, COMMAND_HEADER_SIZE, size) or instructions.is_flawless(
                        frame, COMMAND_HEADER_SIZE, size
                    ):
                        read = partial(InstructionSet.operations, instructions, frame, COMMAND_HEADER_SIZE)
                        return new_direct_command(member, counter, memory & MAX_GLOBALS, memory >> GLOBAL_BITS, read)
                elif code in _DIRECT_REPLIES:
                    return _direct_reply(_DIRECT_REPLIES[code], counter, frame[HEADER_SIZE:])
        return self.read_frame(frame, strict=strict)

    def is_flawless(self, data: bytes, at: int, end: int) -> bool:
        """Says whether one frame without a fault stands between two offsets, without making a message where it can.

        Args:
            data: The bytes that the frame may be in.
            at: The offset of its length field.
            end: The offset after its last byte.

        Returns:
            True where `read_frame` would raise nothing.

        """
        size = end - at
        if COMMAND_HEADER_SIZE <= size <= MAX_FRAME:
            length, _, code = unpack_header(data, at)
            if length + LENGTH_FIELD != size:
                return False
            if code in _DIRECT_COMMANDS:
                return self.instructions.is_flawless(data, at + COMMAND_HEADER_SIZE, end)
        try:
            self.read_frame(data[at:end])
        except DecodeError:
            return False
        return True

    def _envelope_error(self, frame: bytes) -> DecodeError:
        """What is wrong around the body; the body itself is not looked at."""
        size = len(frame)
        if size < HEADER_SIZE:
            return DecodeError(
                size,
                f"a frame has at least {HEADER_SIZE} bytes (length, counter, type), here are {size}",
                truncated=True,
            )
        length, _, code = unpack_header(frame)
        if not MIN_LENGTH <= length <= MAX_LENGTH:
            return DecodeError(
                0, f"the length field says {length}; a frame can have {MIN_LENGTH} to {MAX_LENGTH} bytes after it"
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

    def _read_faulty(self, frame: bytes) -> Message:
        size = len(frame)
        if size < HEADER_SIZE:
            return Message(flaw=Flaw(self._envelope_error(frame).fault, frame))
        length, counter, code = unpack_header(frame)
        stated = None if length == size - LENGTH_FIELD else length
        envelope = None
        is_too_long = size > MAX_FRAME and not may_be_long(frame)
        if stated is not None or is_too_long or code not in self._types:
            envelope = _too_long(size) if is_too_long and stated is None else self._envelope_error(frame)
        if code not in self._types:
            assert envelope is not None
            return Message(counter=counter, flaw=Flaw(envelope.fault, frame, stated))
        end = min(size, max(length + LENGTH_FIELD, HEADER_SIZE))
        member, kind, read_body = self._types[code]
        message, rest, error = read_body(frame[:end], end, counter, member)
        flaw = Flaw(_worse(envelope, error), rest + frame[end:], stated, headless=message is None)
        return replace(kind(type=member, counter=counter) if message is None else message, flaw=flaw)

    def _direct_command(self, frame: bytes, end: int, counter: int, member: MessageType) -> Body:
        start = COMMAND_HEADER_SIZE
        if end < start:
            error = DecodeError(end, "a direct command starts with two bytes that ask for memory", truncated=True)
            return None, frame[HEADER_SIZE:], error
        operations, fault = self.instructions.scan(frame, start, end)
        (memory,) = unpack_memory(frame, HEADER_SIZE)
        message = new_direct_command(member, counter, memory & MAX_GLOBALS, memory >> GLOBAL_BITS, tuple(operations))
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
        operations, fault = self.instructions.scan(frame, at, end)
        return () if fault else tuple(operations)

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

    def write(self, value: Message) -> bytes:
        """Builds the frame of a message.

        Args:
            value: The message.

        Returns:
            The frame.

        Raises:
            BuildError: No frame can carry it.

        """
        return value.build()


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


_SCHEMAS: dict[str, FrameSchema] = {}


def frame_schema(dialect: str = "official") -> FrameSchema:
    """Finds the schema of frames for a dialect, which is made once.

    Args:
        dialect: "official", "xtended" or "compat".

    Returns:
        The schema.

    Raises:
        ValueError: There is no such dialect.
    """
    if dialect not in _SCHEMAS:
        _SCHEMAS[dialect] = FrameSchema(dialect)
    return _SCHEMAS[dialect]


# What checks a frame and what shows it afterwards read the same one; one more is for the frame that becomes of a fix.
@lru_cache(2)
def read_last(frame: bytes, dialect: str) -> Message:
    """Reads a frame, or gives the message again where it is one of the last that were read here.

    Args:
        frame: From its length field to its last byte. Nothing in it raises.
        dialect: "official", "xtended" or "compat": the firmware whose instruction set to read by.

    Returns:
        The message.

    Raises:
        ValueError: There is no such dialect.
    """
    return frame_schema(dialect).read_frame(frame, strict=False)


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
        frame: From its length field to its last byte, and nothing after it.
        expect: The class of the message, such as `DirectReply`: type checkers know what is returned, and another
            message is an error. When omitted, any message will do.
        strict: False: nothing in the frame's contents raises. `message.fault` says what is wrong and where.
        dialect: "official", "xtended" or "compat": the firmware whose instruction set to read by.

    Returns:
        The message. `message.build()` gives the same bytes again.

    Raises:
        DecodeError: The frame is faulty, and `strict` is true. It is a ValueError with `offset` and `reason`.
        DecodeError: The message is not of the class that is expected.
        ValueError: There is no such dialect.
        TypeError: The frame is not bytes.
    """
    if type(frame) is not bytes:
        frame = as_bytes(frame, "a frame")
    schema = _SCHEMAS.get(dialect) or frame_schema(dialect)
    message = schema.read_frame(frame, strict=strict)
    if expect is not Message and not isinstance(message, expect):
        raise DecodeError(HEADER_SIZE - 1, f"this is a {type(message).__name__}, and a {expect.__name__} is expected")
    return message
