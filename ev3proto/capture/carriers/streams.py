"""The shared state of a capture's readers, and the byte streams of Bluetooth and WiFi."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import count
from typing import NamedTuple

from ev3proto.bounded import Budget
from ev3proto.capture.byte_account import Account
from ev3proto.capture.conversation import Conversation
from ev3proto.capture.framing import Cutter, PartKind, StreamPart
from ev3proto.capture.packets import Packet
from ev3proto.capture.record import Announcement, Event, Record, Route, Skipped, TextKind, missing_of
from ev3proto.errors import counted
from ev3proto.schema.discovery import Unlock
from ev3proto.schema.frame import FrameReader

TOO_MUCH = "the rest of the frame was given up: too much is pending"
"""The reason for bytes that are given up at the memory limit."""


class Piece(NamedTuple):
    """Consecutive bytes of a stream, from one packet."""

    data: bytes
    number: int  # the packet's number
    time_ns: int
    missing: int = 0  # number of bytes after these in the same packet that were not captured


class Context:
    """The shared state of the readers of one capture."""

    __slots__ = ("account", "budget", "is_all", "late", "numbers", "ports", "schema")

    def __init__(
        self, schema: FrameReader, account: Account, ports: frozenset[int], budget: Budget, *, is_all: bool = False
    ) -> None:
        self.schema = schema  # reads frames
        self.account = account  # counts all bytes
        # TCP ports whose traffic is a brick's, whatever it is; none for the usual one, if its traffic is recognised
        self.ports = ports
        self.is_all = is_all  # everything on a brick's port, channel and report size is a brick's
        self.budget = budget  # limits the memory of all pending bytes and commands
        self.numbers = count(1)  # of the conversations
        self.late: list[Event] = []  # events of what was evicted at that limit; they follow those of the current packet

    def conversation(self) -> Conversation:
        """Returns a new conversation."""
        return Conversation(self.schema, self.budget, self.numbers)


class Stream:
    """One direction of a connection: turns its bytes into events, and counts them in the account."""

    __slots__ = ("_account", "_conversation", "cutter", "packet", "route", "times")

    def __init__(
        self, context: Context, conversation: Conversation, cutter: Cutter, route: Route, packet: Packet
    ) -> None:
        self._account = context.account
        self._conversation = conversation
        self.times: dict[int, int] = {}  # the times of the packets whose bytes are pending
        self.cutter = cutter
        self.route = route
        self.packet = packet  # the current packet, in which faults are noticed

    def feed(self, piece: Piece) -> list[Event]:
        """Returns the events that the next bytes complete."""
        data, number, time_ns, missing = piece
        if not missing and self.cutter.takes_whole(data):
            # Nearly every packet is exactly one frame.
            self._account.frames += len(data)
            return [self._conversation.record(data, (number,), time_ns, self.route)]
        self.times[number] = time_ns
        events = self._events(self.cutter.feed(data, number))
        self.times = {number: self.times[number] for number in self.cutter.waiting}
        return events + self._cut_off(missing) if missing else events

    @property
    def size(self) -> int:
        """Approximate memory of the pending bytes."""
        return self.cutter.size

    def answered(self) -> list[Event]:
        """Returns the events of a pending command with a wrong length, when the other side sends."""
        return self._events(self.cutter.answered())

    def give_up(self, reason: str = TOO_MUCH) -> list[Event]:
        """Gives up the pending bytes."""
        events = self._events(self.cutter.give_up(reason))
        self.times.clear()
        return events

    def _cut_off(self, missing: int) -> list[Event]:
        """Ends a packet that the capture has cut, and reports the missing bytes after those of the cut frame."""
        events = self._events(self.cutter.cut_off(missing))
        self.times.clear()
        last = events[-1] if events else None
        if isinstance(last, Record):
            last.missing = missing_of(last.frame)
            missing -= last.missing
        return self._with_missing(events, missing) if missing > 0 else events

    def leave_hole(self, missing: int) -> list[Event]:
        """Reports missing bytes at this place; 0 if their number is unknown. They may be the unlock text."""
        self._conversation.is_locked = False
        events = self._events(self.cutter.leave_hole(missing))
        self.times.clear()
        return self._with_missing(events, missing)

    def _with_missing(self, events: list[Event], missing: int) -> list[Event]:
        reason = (
            f"{counted(missing, 'byte')} {'is' if missing == 1 else 'are'} missing in the stream: not in the capture"
        )
        if not missing:
            reason = "the stream continues elsewhere: what is in between is not in the capture"
        return [*events, Skipped(b"", missing, reason, self.packet.number, self.packet.time_ns, self.route)]

    def skip(self, data: bytes, reason: str) -> Skipped:
        """Returns the event for bytes that no longer fit into the stream."""
        self._account.skipped += len(data)
        return Skipped(data, 0, reason, self.packet.number, self.packet.time_ns, self.route)

    def end(self) -> list[Event]:
        """Ends the stream. Returns the events of the pending bytes."""
        events = self._events(self.cutter.end())
        self.times.clear()
        return events

    def _events(self, pieces: Iterable[StreamPart]) -> list[Event]:
        events: list[Event] = []
        account, route, times = self._account, self.route, self.times
        for kind, data, numbers, reason in pieces:
            size = len(data)
            time_ns = times[numbers[0] if len(numbers) == 1 else max(numbers)]
            if kind is PartKind.FRAME:
                account.frames += size
                record = self._conversation.record(data, numbers, time_ns, route)
                record.note, record.is_mended = reason or record.note, bool(reason)
                events.append(record)
            elif kind is PartKind.POLL:
                account.padding += size
            elif kind is PartKind.LOST:
                account.skipped += size
                events.append(Skipped(data, 0, reason, self.packet.number, self.packet.time_ns, route))
            else:
                account.texts += size
                self._conversation.is_locked = False
                if kind is PartKind.UNLOCK:
                    events.append(Announcement(TextKind.UNLOCK, data, Unlock.parse(data), numbers, time_ns, route))
                elif kind is PartKind.ACCEPT:
                    events.append(Announcement(TextKind.ACCEPT, data, None, numbers, time_ns, route))
        return events
