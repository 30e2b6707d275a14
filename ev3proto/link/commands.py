"""The commands of a program, as type and body of a message, and the results that it gets from replies.

The result of joined bytes is bytes, as in the lessons: a reply's memory, or the counter. The result of operations of
`ev3proto.ops`, and of messages, is the named values of the reply.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum

from ev3proto.checking.checking import check
from ev3proto.compose import Draft, Label, command
from ev3proto.errors import BuildError
from ev3proto.link.errors import DirectCommandError, SystemCommandError
from ev3proto.messages import DirectCommand, Message, Operation, SystemCommand, SystemReply
from ev3proto.schema.frame import parse
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, frame_size, write_memory
from ev3proto.semantics.replies import Value, values_of
from ev3proto.tables.frame import DIRECT_COMMAND_TYPES, LENGTH_FIELD, SYSTEM_COMMAND_TYPES, MessageType
from ev3proto.tables.system import SystemStatus

Operations = bytes | bytearray | Draft | Operation | DirectCommand | Iterable[Draft | Operation | Label]
"""The contents of a direct command."""

Result = bytes | list[Value]
"""The result of sending: bytes for bytes, the values of the reply for operations and messages."""


class SyncMode(StrEnum):
    """Whether commands request a reply, and who waits for it."""

    STD = "STD"  # requests a reply if there is global memory, and waits for it
    # requests a reply if there is global memory, and waits only when the program calls `wait_for_reply`
    ASYNC = "ASYNC"
    SYNC = "SYNC"  # always requests a reply, and waits for it: when the program continues, the brick is done

    @classmethod
    def of(cls, name: str) -> SyncMode:
        """Returns the mode of that name. Raises ValueError for any other."""
        try:
            return cls(name)
        except ValueError:
            raise ValueError(f"sync_mode must be one of {', '.join(cls)}, not {name!r}") from None


@dataclass(frozen=True, slots=True)
class Prepared:
    """A command before it is sent."""

    kind: MessageType  # its message type
    body: bytes  # the bytes after the header
    waits: bool  # whether the program waits for the reply
    is_named: bool  # whether the result is values; else it is bytes
    dialect: str = "official"  # the firmware whose instruction set it is read by

    def result(self, request: bytes, reply: bytes) -> Result:
        """Returns the program's result for a reply. Raises DirectCommandError and SystemCommandError."""
        message = parse(reply, strict=False, dialect=self.dialect)
        if isinstance(message, SystemReply):
            self._check_status(message)
        elif message.type is MessageType.DIRECT_REPLY_ERROR:
            raise DirectCommandError(request, reply[HEADER_SIZE:], check(request, dialect=self.dialect))
        if self.is_named:
            return values_of(message, parse(request, strict=False, dialect=self.dialect))
        # The sender knows the number of the system command, but not its status.
        return reply[HEADER_SIZE + isinstance(message, SystemReply) :]

    def _check_status(self, reply: SystemReply) -> None:
        is_refused = reply.type is MessageType.SYSTEM_REPLY_ERROR and reply.status is not SystemStatus.END_OF_FILE
        if is_refused or (self.is_named and reply.is_error):
            raise SystemCommandError(reply)


def counter_bytes(request: bytes) -> bytes:
    """Returns the counter of a command as its two bytes: the result of sending without waiting for a reply."""
    return request[LENGTH_FIELD : 2 * LENGTH_FIELD]


def counter_of(given: bytes | int) -> int:
    """Returns a counter, given as a number or as its two bytes. Raises ValueError for anything else."""
    if isinstance(given, int) and not isinstance(given, bool):
        return given
    if isinstance(given, bytes) and len(given) == LENGTH_FIELD:
        return int.from_bytes(given, "little")
    raise ValueError(f"a counter must be what send_direct_cmd gave, two bytes or a number, not {given!r}")


def direct(operations: Operations, local_mem: int, global_mem: int, mode: SyncMode, dialect: str) -> Prepared:
    """Prepares a direct command; operations request the memory they need if it is 0. Raises BuildError."""
    if isinstance(operations, bytes | bytearray):
        if _is_whole_frame(bytes(operations), dialect):
            raise BuildError(
                "these bytes are a whole frame, with length and counter; expected only its operations, or"
                " ev3proto.parse(frame)"
            )
        body = write_memory(global_mem, local_mem) + bytes(operations)
        return _direct(body, bool(global_mem), mode, is_named=False, dialect=dialect)
    if isinstance(operations, DirectCommand):
        message = operations
    else:
        drafts = (operations,) if isinstance(operations, Draft | Operation) else _listed(operations)
        message = command(
            *drafts,
            reply=True if mode is SyncMode.SYNC else None,
            global_size=global_mem or None,
            local_size=local_mem or None,
        )
    return _direct(message.build()[HEADER_SIZE:], message.wants_reply, mode, is_named=True, dialect=dialect)


def _direct(body: bytes, asks: bool, mode: SyncMode, *, is_named: bool, dialect: str) -> Prepared:
    if len(body) == COMMAND_HEADER_SIZE - HEADER_SIZE:
        raise BuildError("a command needs at least one operation: the brick refuses an empty one")
    asks |= mode is SyncMode.SYNC
    return Prepared(DIRECT_COMMAND_TYPES[asks], body, asks and mode is not SyncMode.ASYNC, is_named, dialect)


def _is_whole_frame(data: bytes, dialect: str) -> bool:
    """Returns whether bytes are exactly one direct command in which `check` finds no error."""
    if len(data) < HEADER_SIZE or frame_size(data) != len(data):
        return False
    message = parse(data, strict=False, dialect=dialect)
    return isinstance(message, DirectCommand) and not check(data, dialect=dialect).errors


def _listed(operations: object) -> tuple[Draft | Operation | Label, ...]:
    if isinstance(operations, str | Message) or not isinstance(operations, Iterable):
        raise BuildError(
            f"not a direct command: {operations!r:.60}; expected bytes, or operations such as"
            " ops.sound.tone(1, 440, 1000)"
        )
    return tuple(operations)


def system(given: bytes | bytearray | SystemCommand, reply: bool) -> Prepared:
    """Prepares a system command; a message itself says whether it wants a reply. Raises BuildError."""
    if isinstance(given, SystemCommand):
        wants_reply, body = given.wants_reply and reply, given.build()[HEADER_SIZE:]
    elif isinstance(given, bytes | bytearray) and given:
        wants_reply, body = reply, bytes(given)
    else:
        raise BuildError(
            f"not a system command: {given!r:.60}; expected bytes, beginning with the command's number, or"
            " a message such as ev3proto.system.list_files('.')"
        )
    kind = SYSTEM_COMMAND_TYPES[bool(wants_reply)]
    return Prepared(kind, body, wants_reply, isinstance(given, SystemCommand))
