"""Conversations of a computer and a brick: records of their frames, replies linked to their commands."""

from __future__ import annotations

from ev3proto.bounded import Budget
from ev3proto.capture.record import Answered, Record, Route
from ev3proto.dialogue import Pairing, Transfers
from ev3proto.messages import Message, SystemCommand, SystemReply
from ev3proto.schema.frame import FrameReader
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, Header, read_memory, unpack_header
from ev3proto.tables.frame import COUNTERS, MessageType

MOST_PENDING = 4096
"""Maximum number of pending commands of a conversation; a long capture may have a million unanswered ones."""

_DIRECT, _SYSTEM = MessageType.DIRECT_COMMAND_REPLY.carries, MessageType.SYSTEM_COMMAND_REPLY.carries

_CARRIES = tuple(dict.fromkeys(member.carries for member in MessageType))
_CARRIED = {carries: kind * COUNTERS for kind, carries in enumerate(_CARRIES)}
_NUMBERS = len(_CARRIES) * COUNTERS

# By the number of a type: its part of the key; whether it is a system message, a command, requests a reply, is an
# error; and whether the size of a reply tells which command it answers.
_TYPES = {
    int(member): (
        _CARRIED[member.carries],
        member.carries == _SYSTEM,
        member.is_command,
        member.wants_reply,
        member.is_error,
        member.carries == _DIRECT and not member.is_error,
    )
    for member in MessageType
}


def _number(frame: bytes) -> int:
    """Returns the command of a system message, as a part of the key in `record`."""
    return (1 + frame[HEADER_SIZE]) * _NUMBERS


_RECORD_SIZE = 700
"""Approximate memory of a pending record besides its frame, in bytes."""


def _size_of(record: Record) -> int:
    return _RECORD_SIZE + len(record.frame)


def _is_failure(message: Message) -> bool:
    """Returns whether a system reply reports a failure; uploads end with END_OF_FILE."""
    return isinstance(message, SystemReply) and message.is_error


class Conversation:
    """A conversation: pairs replies with commands by their headers, so that messages are parsed only on request."""

    def __init__(self, schema: FrameReader, budget: Budget | None = None) -> None:
        self._schema = schema
        self._pairing: Pairing[Record] = Pairing(MOST_PENDING, budget, _size_of)
        self._budget = budget
        self._transfers: Transfers | None = None  # made for the first system message

    @property
    def unanswered(self) -> list[Record]:
        """The pending commands, oldest first."""
        return self._pairing.unanswered

    def record(self, frame: bytes, numbers: tuple[int, ...], time_ns: int, route: Route) -> Record:
        """Returns the record of a frame. Pass every frame of the conversation once, in order, in both directions."""
        record = Record(frame, numbers, time_ns, route, self._schema)
        if len(frame) < HEADER_SIZE:
            return record
        _, counter, code = unpack_header(frame)
        known = _TYPES.get(code)
        if known is None:
            return record
        kind, is_system, is_command, wants_reply, is_error, has_memory = known
        # The key that a reply shares with its command. A plain number, as one is made for each frame.
        key = kind + counter
        if is_system and len(frame) > HEADER_SIZE:
            key += _number(frame)
        if not is_command:
            request = record.request = self._pairing.answered(key, len(frame) - HEADER_SIZE if has_memory else None)
            if request is not None:
                failed = is_error if not is_system else _is_failure(record.message)
                request.answered = Answered(time_ns, failed)
        elif wants_reply:
            has_memory = has_memory and len(frame) >= COMMAND_HEADER_SIZE
            asked = read_memory(frame)[0] if has_memory else 0
            self._pairing.remember(key, asked, record)
        if is_system:
            self._follow_transfer(record)
        return record

    def overwritten(self, frame: bytes, numbers: tuple[int, ...], time_ns: int, route: Route) -> Record:
        """Returns the record of a reply whose first bytes, including the type, are overwritten by its command's."""
        record = Record(frame, numbers, time_ns, route, self._schema)
        key = _CARRIED[_SYSTEM] + Header.read(frame).counter + _number(frame)
        request = record.request = self._pairing.answered(key, None)
        if request is not None:
            request.answered = Answered(time_ns, _is_failure(record.message))
        return record

    def _follow_transfer(self, record: Record) -> None:
        transfers = self._transfers
        if transfers is None:
            transfers = self._transfers = Transfers(self._budget)
        message = record.message
        if isinstance(message, SystemCommand):
            record.transfer = transfers.requested(message)
        elif isinstance(message, SystemReply):
            request = None if record.request is None else record.request.message
            record.transfer = transfers.progress(message, request)
