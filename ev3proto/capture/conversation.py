"""A computer and a brick in a capture: their frames become records, each reply with the command that it answers."""

from __future__ import annotations

from ev3proto.bounded import Budget
from ev3proto.capture.record import Answered, Record, Route
from ev3proto.messages import Message, SystemCommand, SystemReply
from ev3proto.schema.frame import FrameSchema
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, Header, unpack_header, unpack_memory
from ev3proto.semantics.pairing import Pairing
from ev3proto.semantics.transfers import Transfers
from ev3proto.tables.frame import MAX_GLOBALS, MessageType

MOST_PENDING = 4096
"""Commands of one conversation whose reply is awaited; a long capture may have a million that are never answered."""

_DIRECT, _SYSTEM = MessageType.DIRECT_COMMAND_REPLY.carries, MessageType.SYSTEM_COMMAND_REPLY.carries

# Looked up by the plain number: what the type is about, whether it is a command, wants a reply, is an error.
_TYPES = {
    int(member): (member.carries, member.is_command, member.wants_reply, member.is_error) for member in MessageType
}


_RECORD_SIZE = 700
"""Bytes of memory that a record takes while it waits, besides its frame, about."""


def _size_of(record: Record) -> int:
    return _RECORD_SIZE + len(record.frame)


def _is_failure(message: Message) -> bool:
    """Whether a system reply says that its command failed; END_OF_FILE is how an upload ends."""
    return isinstance(message, SystemReply) and message.is_error


class Conversation:
    """Pairs replies with commands by their headers alone, so that messages are read only when they are asked for."""

    def __init__(self, schema: FrameSchema, budget: Budget | None = None) -> None:
        self._schema = schema
        self._pairing: Pairing[Record] = Pairing(MOST_PENDING, budget, _size_of)
        self._budget = budget
        self._transfers: Transfers | None = None  # made for the first system message

    @property
    def unanswered(self) -> list[Record]:
        """The commands that wait for their reply, oldest first."""
        return self._pairing.unanswered

    def record(self, frame: bytes, numbers: tuple[int, ...], time_ns: int, route: Route) -> Record:
        """The record of a frame. Give each frame of the conversation once, in order, both directions."""
        record = Record(frame, numbers, time_ns, route, self._schema)
        size = len(frame)
        if size < HEADER_SIZE:
            return record
        _, counter, code = unpack_header(frame)
        known = _TYPES.get(code)
        if known is None:
            return record
        carries, is_command, wants_reply, is_error = known
        number = 0
        if carries == _SYSTEM:
            number = frame[HEADER_SIZE] if size > HEADER_SIZE else -1
        if not is_command:
            carried = size - HEADER_SIZE if carries == _DIRECT and not is_error else None
            request = record.request = self._pairing.answered((carries, counter, number), carried)
            if request is not None:
                failed = is_error if carries != _SYSTEM else _is_failure(record.message)
                request.answered = Answered(time_ns, failed)
        elif wants_reply:
            has_memory = carries == _DIRECT and size >= COMMAND_HEADER_SIZE
            asked = unpack_memory(frame, HEADER_SIZE)[0] & MAX_GLOBALS if has_memory else 0
            self._pairing.remember((carries, counter, number), asked, record)
        if carries == _SYSTEM:
            self._follow_transfer(record)
        return record

    def overwritten(self, frame: bytes, numbers: tuple[int, ...], time_ns: int, route: Route) -> Record:
        """The record of a reply whose first bytes are those of the command that it answers, its type included."""
        record = Record(frame, numbers, time_ns, route, self._schema)
        key = (_SYSTEM, Header.read(frame).counter, frame[HEADER_SIZE])
        request = record.request = self._pairing.answered(key, None)
        if request is not None:
            request.answered = Answered(time_ns, failed=_is_failure(record.message))
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
