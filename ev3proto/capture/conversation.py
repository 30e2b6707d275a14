"""Conversations of a computer and a brick: records of their frames, replies linked to their commands."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count

from ev3proto.bounded import Budget
from ev3proto.capture.record import Outcome, Record, Route
from ev3proto.dialogue import Transfers
from ev3proto.messages import SystemCommand, SystemReply
from ev3proto.schema.frame import FrameReader
from ev3proto.schema.header import HEADER_SIZE, unpack_header
from ev3proto.semantics.pairing import Pairing, pairing_key
from ev3proto.tables.frame import MessageType

MOST_PENDING = 4096
"""Maximum number of pending commands of a conversation; a long capture may have a million unanswered ones."""

_TYPES = {
    int(member): (
        member.is_command,
        member.wants_reply,
        member.is_error,
        member.carries == MessageType.SYSTEM_REPLY.carries,
    )
    for member in MessageType
}
"""By the number of a type: whether it is a command, requests a reply, is an error, and is a system message."""


_RECORD_SIZE = 700
"""Approximate memory of a pending record besides its frame, in bytes."""


def _size_of(record: Record) -> int:
    return _RECORD_SIZE + len(record.frame)


def _is_failure(record: Record) -> bool:
    """Returns whether a reply reports a failure; uploads end with END_OF_FILE. Only system replies are parsed."""
    _, _, is_error, is_system = _TYPES[record.frame[HEADER_SIZE - 1]]
    message = record.message if is_system else None
    return message.is_error if isinstance(message, SystemReply) else is_error


class Conversation:
    """A conversation: pairs replies with commands by their headers, so that messages are parsed only on request.

    number  as `Record.connection`, 0 before the first record; it may be set to that of an earlier conversation
    """

    def __init__(self, schema: FrameReader, budget: Budget | None = None, numbers: Iterator[int] | None = None) -> None:
        """Takes the numbers of conversations that are not given yet, which it shares with the others of its file."""
        self.number = 0
        self._numbers = count(1) if numbers is None else numbers
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
        record = self._new(frame, numbers, time_ns, route)
        if len(frame) < HEADER_SIZE:
            return record
        known = _TYPES.get(unpack_header(frame)[2])
        if known is None:
            return record
        is_command, wants_reply, _, is_system = known
        if not is_command:
            self._pair(record)
        elif wants_reply:
            self._pairing.remember(*pairing_key(frame), record, time_ns if route.is_timed else None)
        if is_system:
            self._follow_transfer(record)
        return record

    def overwritten(self, frame: bytes, numbers: tuple[int, ...], time_ns: int, route: Route) -> Record:
        """Returns the record of a reply whose first bytes, including the type, are overwritten by its command's."""
        record = self._new(frame, numbers, time_ns, route)
        self._pair(record)
        return record

    def _new(self, frame: bytes, numbers: tuple[int, ...], time_ns: int, route: Route) -> Record:
        record = Record(frame, numbers, time_ns, route, self._schema)
        if not self.number:
            self.number = next(self._numbers)
        record.connection = self.number
        return record

    def _pair(self, record: Record) -> None:
        """Finds the command that a reply answers."""
        answer = self._pairing.answered(*pairing_key(record.frame), record.time_ns if record.route.is_timed else None)
        if answer is not None:
            record.request, record.note = answer.command, answer.note
            answer.command.answered = Outcome(record.time_ns, _is_failure(record))

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
