"""Dialogues: which reply answers which command, and what the reply therefore says.

A reply to a direct command is nothing but memory. Every output parameter of the command that names a global variable
says what stands in it and where, so a `Dialogue` remembers the commands it saw. Replies to system commands have fields
of their own; there it remembers which file each handle stands for.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Iterator
from dataclasses import dataclass, field

from ev3proto.messages import (
    Argument,
    DirectCommand,
    DirectReply,
    FieldValue,
    Message,
    Operation,
    SystemCommand,
    SystemReply,
)
from ev3proto.schema.frame import HEADER_SIZE
from ev3proto.tables.declaration import Enumeration, Parameter, Type
from ev3proto.tables.encoding import CONSTANT, GLOBAL, RANGES, STRING_CODING
from ev3proto.tables.system import SYSTEM_BY_NUMBER, Kind, SystemStatus

MOST_PENDING = 65536
"""Commands without a reply that a dialogue remembers: as many as there are counters."""

MOST_PER_COUNTER = 4
"""Commands with the same counter that it remembers, for senders who never change it."""

ValueType = int | float | str | bytes | list[int] | list[float]
"""What a value from a reply can be."""

_LAYOUTS = {Type.DATA8: "<b", Type.DATA16: "<h", Type.DATA32: "<i", Type.DATAF: "<f", Type.HANDLE: "<h"}
_BY_SIZE = {1: Type.DATA8, 2: Type.DATA16, 4: Type.DATA32}
_NAN = {str(kind): RANGES[kind].nan for kind in _BY_SIZE.values()}


@dataclass(frozen=True, slots=True)
class Value:
    """One value in a reply.

    op       opcode's name, or the system command's
    command  CMD's name, None where there is none
    name     the parameter's or field's name
    value    number, text, or list of numbers
    unit     as people write it, None where it has none
    type     what it is in memory: DATA8, DATAF, string, u32, ...
    symbol   name of the number in its enumeration, None where it has none
    offset   of its first byte in the reply's frame
    length   bytes in the reply's frame
    """

    op: str
    command: str | None
    name: str
    value: ValueType
    unit: str | None = None
    type: str = ""
    symbol: str | list[str | None] | None = None
    offset: int = 0
    length: int = 0

    @property
    def is_nan(self) -> bool:
        """True for the value by which the firmware says that there is none."""
        if isinstance(self.value, float):
            return math.isnan(self.value)
        return isinstance(self.value, int) and self.value == _NAN.get(self.type)


@dataclass(slots=True)
class Transfer:
    """A file or listing on its way, from its BEGIN_... to its end.

    command      the BEGIN_... command's name
    path         what is moved
    size         bytes of it all, None until known
    handle       the brick's handle, None until known
    transferred  bytes moved so far
    """

    command: str
    path: str
    size: int | None = None
    handle: int | None = None
    transferred: int = 0

    @property
    def is_complete(self) -> bool:
        """True when everything was moved."""
        return self.size is not None and self.transferred >= self.size


@dataclass(frozen=True, slots=True)
class Exchange:
    """What a dialogue makes of one message.

    message   the message itself
    request   for a reply: the command it answers; None when no such command was seen
    values    for a reply: what it says, by name
    transfer  the file that the message is about, None where it is about none
    """

    message: Message
    request: Message | None = None
    values: list[Value] = field(default_factory=list)
    transfer: Transfer | None = None

    @property
    def is_orphan(self) -> bool:
        """True for a reply to a command that was not seen."""
        return self.request is None and self.message.type is not None and not self.message.type.is_command


class Dialogue:
    """Follows the messages between one computer and one brick, in order, both directions.

    Commands whose reply never comes are forgotten when their counter is used again often enough or too many wait.
    """

    def __init__(self) -> None:
        self._pending: dict[tuple[str, int], list[int]] = {}
        self._waiting: dict[int, Message] = {}
        self._seen = 0
        self._transfers: dict[int, Transfer] = {}
        self._begun: dict[int, Transfer] = {}

    @property
    def unanswered(self) -> list[Message]:
        """The commands that wait for their reply, oldest first."""
        return list(self._waiting.values())

    def feed(self, message: Message) -> list[Value]:
        """What a reply says, by name; an empty list for commands and for replies to commands that were not seen."""
        return self.follow(message).values

    def follow(self, message: Message) -> Exchange:
        """The same with all that is known: command answered, values, file. Feed or follow each message once."""
        if message.type is None:
            return Exchange(message)
        if message.type.is_command:
            if message.wants_reply:
                self._remember(message)
            transfer = self._requested(message) if isinstance(message, SystemCommand) else None
            return Exchange(message, transfer=transfer)
        request = self._answered(message)
        if isinstance(message, SystemReply):
            transfer = self._progress(message, request)
            return Exchange(message, request, list(system_values(message)), transfer)
        if isinstance(message, DirectReply) and isinstance(request, DirectCommand):
            return Exchange(message, request, list(reply_values(request, message)))
        return Exchange(message, request)

    # Pairing

    def _remember(self, message: Message) -> None:
        waiting = self._pending.setdefault(_key(message), [])
        waiting.append(self._seen)
        self._waiting[self._seen] = message
        self._seen += 1
        if len(waiting) > MOST_PER_COUNTER:
            self._forget(message, waiting[0])
        if len(self._waiting) > MOST_PENDING:
            number, oldest = next(iter(self._waiting.items()))
            self._forget(oldest, number)

    def _forget(self, message: Message, number: int) -> None:
        del self._waiting[number]
        key = _key(message)
        self._pending[key].remove(number)
        if not self._pending[key]:
            del self._pending[key]

    def _answered(self, reply: Message) -> Message | None:
        """The command a reply answers: of those with its counter the newest of the right size, else the newest.

        The newest, because a sender comes back to a counter only after it gave up on the one before.
        """
        newest_first = reversed(self._pending.get(_key(reply), []))
        possible = [number for number in newest_first if _can_answer(reply, self._waiting[number])]
        if not possible:
            return None
        number = next((number for number in possible if _fits(reply, self._waiting[number])), possible[0])
        command = self._waiting[number]
        self._forget(command, number)
        return command

    # Files

    def _requested(self, message: SystemCommand) -> Transfer | None:
        entry = SYSTEM_BY_NUMBER.get(message.number)
        if entry is None or entry.transfer is None:
            return None
        if entry.transfer == "begin":
            path = str(message.fields.get("path", ""))
            size = message.fields.get("size")
            transfer = Transfer(entry.name, path, size if isinstance(size, int) else None)
            self._begun[message.counter] = transfer
            if len(self._begun) > MOST_PENDING:
                del self._begun[next(iter(self._begun))]
            return transfer
        transfer_or_none = self._transfers.get(_number(message.fields.get("handle")))
        data = message.fields.get("data")
        if transfer_or_none is not None and isinstance(data, bytes):
            transfer_or_none.transferred += len(data)
        return transfer_or_none

    def _progress(self, reply: SystemReply, request: Message | None) -> Transfer | None:
        entry = SYSTEM_BY_NUMBER.get(reply.number)
        if entry is None or entry.transfer is None:
            return None
        if entry.transfer == "begin":
            transfer = self._begun.pop(reply.counter, None)
            if reply.is_error or "handle" not in reply.fields:
                return transfer
            number = _number(reply.fields["handle"])
            if transfer is None:
                # The command was not seen: the handle stands for another file than before, nobody knows which.
                self._transfers.pop(number, None)
                return None
            transfer.handle = number
            self._transfers[number] = transfer
        else:
            handle = reply.fields.get("handle")
            if handle is None and isinstance(request, SystemCommand):
                handle = request.fields.get("handle")
            transfer = self._transfers.get(_number(handle))
            # The brick takes a handle back when a file is closed, complete or in trouble.
            if entry.transfer == "close" or reply.is_error or reply.status is SystemStatus.END_OF_FILE:
                self._transfers.pop(_number(handle), None)
        if transfer is not None:
            for name in ("size", "list_size"):
                if name in reply.fields:
                    transfer.size = _number(reply.fields[name])
            for name in ("data", "list"):
                transfer.transferred += len(reply.fields.get(name, b""))  # type: ignore[arg-type]
        return transfer


def _key(message: Message) -> tuple[str, int]:
    """What a reply has in common with the command it answers."""
    return ("" if message.type is None else message.type.carries, message.counter)


def _number(value: FieldValue | None) -> int:
    return value if isinstance(value, int) else -1


def _can_answer(reply: Message, command: Message) -> bool:
    """Whether a reply can be the answer to a command with the same counter."""
    if isinstance(reply, SystemReply) and isinstance(command, SystemCommand):
        return command.number == reply.number
    return True


def _fits(reply: Message, command: Message) -> bool:
    """Whether a reply has just the size that was asked for."""
    if isinstance(reply, DirectReply) and isinstance(command, DirectCommand):
        return reply.is_error or len(reply.memory) == command.global_size
    return True


def system_values(reply: SystemReply) -> Iterator[Value]:
    """The fields of a system reply as values."""
    entry = SYSTEM_BY_NUMBER.get(reply.number)
    if entry is None:
        return
    at = HEADER_SIZE + 2
    for declared in entry.reply:
        if declared.name not in reply.fields:
            continue
        value = reply.fields[declared.name]
        length = _LENGTHS.get(declared.kind, 0) or len(value) + (declared.kind in _TERMINATED)  # type: ignore[arg-type]
        yield Value(reply.command or "", None, declared.name, value, None, declared.kind.value, None, at, length)
        at += length


_LENGTHS = {Kind.U8: 1, Kind.U16: 2, Kind.U32: 4}
_TERMINATED = (Kind.TEXT, Kind.COUNTED_TEXT)


def reply_values(command: DirectCommand, reply: DirectReply) -> Iterator[Value]:
    """What the reply's memory holds, by the output parameters of the command it answers; nothing for an error."""
    if reply.is_error:
        return
    for operation in command.operations:
        for argument in operation.arguments:
            if argument.parameter.is_output and argument.kind == GLOBAL and not argument.form.address:
                value = _read(operation, argument, reply.memory)
                if value is not None:
                    yield value


def _read(operation: Operation, argument: Argument, memory: bytes) -> Value | None:
    parameter = argument.parameter
    start = int(argument.value)
    kind = Type.HANDLE if argument.form.handle else parameter.type
    symbol: str | list[str | None] | None = None
    value: ValueType
    if kind is Type.STRING:
        piece = memory[start : start + _length(operation, parameter, len(memory))].split(b"\0", 1)[0]
        if start >= len(memory):
            return None
        value, length = piece.decode(STRING_CODING), len(piece)
    elif kind is Type.ARRAY_TYPED:
        kind = _untyped(operation, start, len(memory))
        piece = memory[start : start + kind.size]
        if len(piece) < kind.size:
            return None
        (value,) = struct.unpack(_LAYOUTS[kind], piece)
        length = kind.size
    elif kind not in _LAYOUTS:
        return None
    else:
        count = 1 if parameter.length is None else _length(operation, parameter, len(memory) // kind.size)
        count = min(count, (len(memory) - start) // kind.size)
        if count < 1:
            return None
        length = count * kind.size
        numbers = [number for (number,) in struct.iter_unpack(_LAYOUTS[kind], memory[start : start + length])]
        if parameter.length is None:
            value, symbol = numbers[0], _name(parameter.enum, numbers[0])
        else:
            value = numbers
            symbol = [_name(parameter.enum, number) for number in numbers] if parameter.enum else None
    return Value(
        operation.name,
        operation.command,
        argument.name,
        value,
        None if argument.form.handle else parameter.unit,
        str(kind),
        symbol,
        HEADER_SIZE + start,
        length,
    )


def _name(enum: Enumeration | None, number: int | float) -> str | None:
    return enum.name_of(number) if enum else None


def _length(operation: Operation, parameter: Parameter, most: int) -> int:
    """How long an output is: what its length parameter says, or as much as there is where that does not say it.

    Some firmware lengths are negative: -1 for no limit, others for bytes in reverse order.
    """
    if isinstance(parameter.length, int):
        return parameter.length
    for argument in operation.arguments:
        if argument.name == parameter.length and argument.kind == CONSTANT:
            if argument.value == -1 and parameter.type is Type.STRING:
                return most
            return abs(int(argument.value))
    return most


def _untyped(operation: Operation, start: int, end: int) -> Type:
    """The type of an output that has that of the array it comes from: what fits before the next output."""
    for argument in operation.arguments:
        if argument.kind == GLOBAL and argument.parameter.is_output and start < int(argument.value) < end:
            end = int(argument.value)
    room = max((size for size in _BY_SIZE if size <= end - start), default=4)
    return _BY_SIZE[room]
