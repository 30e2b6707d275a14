"""Conversations of a computer and a brick: records of their frames, replies linked to their commands."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count

from ev3proto.bounded import Budget
from ev3proto.capture.record import Outcome, Record, Route
from ev3proto.dialogue import Transfers
from ev3proto.messages import SystemCommand, SystemReply
from ev3proto.schema.frame import FrameReader
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.semantics.pairing import MOST_LABELS, Pairing, pairing_key
from ev3proto.tables.discovery import NOT_UNLOCKED
from ev3proto.tables.frame import MESSAGE_TYPES

MOST_PENDING = 4096
"""Maximum number of pending commands of a conversation; a long capture may have a million unanswered ones."""

OVERWRITTEN = "a known fault of the EV3's bootloader on USB 3 ports: the reply with the request written over its start"

_RECORD_SIZE = 700
"""Approximate memory of a pending record besides its frame, in bytes."""


def _is_failure(record: Record) -> bool:
    """Returns whether a reply reports a failure; uploads end with END_OF_FILE. Only system replies are parsed."""
    member = MESSAGE_TYPES[record.frame[HEADER_SIZE - 1]]
    message = record.message if member.carries == "system" else None
    return message.is_error if isinstance(message, SystemReply) else member.is_error


class Conversation:
    """A conversation: pairs replies with commands by their headers, so that messages are parsed only on request.

    number     as `Record.connection`, 0 before the first record; it may be set to that of an earlier conversation
    is_locked  its beginning was captured, so far without the unlock text and without a reply
    """

    def __init__(
        self,
        schema: FrameReader,
        budget: Budget | None = None,
        numbers: Iterator[int] | None = None,
        *,
        is_ordered: bool = True,
    ) -> None:
        """Takes the numbers of conversations that are not given yet, which it shares with the others of its file."""
        self.number = 0
        self.is_locked = False
        self._numbers = count(1) if numbers is None else numbers
        self._schema = schema
        self._pairing: Pairing[Record] = Pairing(
            MOST_PENDING, budget, lambda record: _RECORD_SIZE + len(record.frame), is_ordered=is_ordered
        )
        self._budget = budget
        self._transfers: dict[int, Transfers] = {}  # by the number of the connection

    @property
    def unanswered(self) -> list[Record]:
        """The pending commands, oldest first."""
        return self._pairing.unanswered

    def record(self, frame: bytes, numbers: tuple[int, ...], time_ns: int, route: Route) -> Record:
        """Returns the record of a frame. Pass every frame of the conversation once, in order, in both directions."""
        record = Record(frame, numbers, time_ns, route, self._schema)
        member = MESSAGE_TYPES.get(frame[HEADER_SIZE - 1]) if len(frame) >= HEADER_SIZE else None
        is_command = member is None or member.is_command
        if not is_command:
            self.is_locked = False
            self._pair(record)
        elif member is not None and member.wants_reply:
            self._pairing.remember(*pairing_key(frame), record, time_ns if route.is_timed else None, route.label)
        if self.is_locked:
            record.note = NOT_UNLOCKED
        record.connection = self._number_of(record, is_command=is_command)
        if member is not None and member.carries == "system":
            self._follow_transfer(record)
        return record

    def overwritten(self, frame: bytes, numbers: tuple[int, ...], time_ns: int, route: Route) -> Record:
        """Returns the record of a reply whose first bytes, including the type, are overwritten by its command's."""
        record = Record(frame, numbers, time_ns, route, self._schema)
        self._pair(record)
        record.note, record.is_mended = OVERWRITTEN, True
        record.connection = self._number_of(record, is_command=False)
        return record

    def _number_of(self, record: Record, *, is_command: bool) -> int:  # noqa: ARG002
        """Returns the number of the connection of a record, whose command is known."""
        if not self.number:
            self.number = next(self._numbers)
        return self.number

    def _pair(self, record: Record) -> None:
        route = record.route
        time_ns = record.time_ns if route.is_timed else None
        answer = self._pairing.answered(*pairing_key(record.frame), time_ns, route.label)
        if answer is not None:
            record.request, record.note = answer.command, answer.note
            answer.command.answered = Outcome(record.time_ns, _is_failure(record))

    def _follow_transfer(self, record: Record) -> None:
        transfers = self._transfers.get(record.connection)
        if transfers is None:
            transfers = self._transfers[record.connection] = Transfers(self._budget)
        message = record.message
        if isinstance(message, SystemCommand):
            record.transfer = transfers.requested(message)
        elif isinstance(message, SystemReply):
            request = None if record.request is None else record.request.message
            record.transfer = transfers.progress(message, request)


class LoggedConversations(Conversation):
    """The conversations in a text, told apart by labels. The lines of several bricks may be mixed, in any order."""

    def __init__(self, schema: FrameReader, budget: Budget) -> None:
        super().__init__(schema, budget, is_ordered=False)
        self._by_label: dict[str, int] = {}

    def _number_of(self, record: Record, *, is_command: bool) -> int:
        if record.request is not None:
            return record.request.connection
        known = self._by_label
        if not self._pairing.has_labels:
            return 1
        if not known or (is_command and len(known) < MOST_LABELS):
            known.setdefault(record.label, len(known) + 1)
        return known.get(record.label, 1)
