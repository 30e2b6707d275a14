"""What all readers of carriers share, and the byte streams that two of the carriers have."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from ev3proto.bounded import Budget
from ev3proto.capture.byte_account import Account
from ev3proto.capture.conversation import Conversation
from ev3proto.capture.finding import Finder
from ev3proto.capture.framing import Cutter, PartKind, StreamPart
from ev3proto.capture.packets import Packet
from ev3proto.capture.record import Announcement, Event, Route, Skipped, TextKind
from ev3proto.errors import counted
from ev3proto.schema.discovery import Unlock
from ev3proto.schema.frame import FrameSchema
from ev3proto.schema.header import HEADER_SIZE, frame_size

TOO_MUCH = "the rest of the frame was no longer waited for: too much waits"
"""Why bytes are given up where too much waits in the capture."""


class Piece(NamedTuple):
    """Bytes of a stream.

    data     the bytes
    number   the packet they came in
    time_ns  when that was captured
    missing  bytes that came after them in this packet and were not captured
    """

    data: bytes
    number: int
    time_ns: int
    missing: int = 0


class Context:
    """What the readers of one capture share.

    schema   reads frames
    account  counts all bytes
    ports    TCP ports on which bricks listen
    budget   limits the memory of all that waits
    late     events of what had to go because too much waits; they come after those of the packet that is read
    finder   finds frames in streams that are out of step
    """

    __slots__ = ("account", "budget", "finder", "late", "ports", "schema")

    def __init__(self, schema: FrameSchema, account: Account, ports: frozenset[int], budget: Budget) -> None:
        self.schema = schema
        self.account = account
        self.ports = ports
        self.budget = budget
        self.late: list[Event] = []
        self.finder = Finder(schema)

    def conversation(self) -> Conversation:
        """A new conversation."""
        return Conversation(self.schema, self.budget)


class Stream:
    """One direction of a connection: its pieces become events, its bytes stand in the account.

    packet  how far the capture was read: what is noticed from now on is noticed with this packet
    times   when the packets were captured whose bytes wait for more
    """

    __slots__ = ("_account", "_conversation", "cutter", "packet", "route", "times")

    def __init__(
        self, context: Context, conversation: Conversation, cutter: Cutter, route: Route, packet: Packet
    ) -> None:
        self._account = context.account
        self._conversation = conversation
        self.times: dict[int, int] = {}
        self.cutter = cutter
        self.route = route
        self.packet = packet

    def feed(self, piece: Piece) -> list[Event]:
        """The events that are complete with the next bytes."""
        data, number, time_ns, missing = piece
        if not missing and self.cutter.takes_whole(data):
            # Nearly every packet has one frame and nothing else: no pieces, no waiting.
            self._account.frames += len(data)
            return [self._conversation.record(data, (number,), time_ns, self.route)]
        self.times[number] = time_ns
        events = self._events(self.cutter.feed(data, number))
        self.times = {number: self.times[number] for number in self.cutter.waiting}
        return events + self._cut_off(missing) if missing else events

    @property
    def size(self) -> int:
        """Bytes of memory that what waits takes, about."""
        return self.cutter.size

    def give_up(self, reason: str = TOO_MUCH) -> list[Event]:
        """Waits no longer for the rest of what is there."""
        events = self._events(self.cutter.give_up(reason))
        self.times.clear()
        return events

    def _cut_off(self, missing: int) -> list[Event]:
        """Says that of the newest packet so many bytes were not captured. A frame that is cut says so by itself."""
        left = self.cutter.left
        lacking = frame_size(left) - len(left) if len(left) >= HEADER_SIZE else 0
        pieces = self.cutter.cut_off(missing)
        events = self._events(pieces)
        self.times.clear()
        if pieces and pieces[-1].kind is PartKind.FRAME and missing <= lacking:
            return events
        return self._with_missing(events, missing)

    def leave_hole(self, missing: int) -> list[Event]:
        """Says that bytes are missing here; 0 where their number is not known."""
        events = self._events(self.cutter.leave_hole(missing))
        self.times.clear()
        return self._with_missing(events, missing)

    def _with_missing(self, events: list[Event], missing: int) -> list[Event]:
        reason = (
            f"{counted(missing, 'byte')} {'is' if missing == 1 else 'are'} missing in the stream: not in the capture"
        )
        if not missing:
            reason = "the stream goes on at quite another place: what is in between is not in the capture"
        return [*events, Skipped(b"", missing, reason, self.packet.number, self.packet.time_ns, self.route)]

    def skip(self, data: bytes, reason: str) -> Skipped:
        """Bytes that belong to no place in the stream any more."""
        self._account.skipped += len(data)
        return Skipped(data, 0, reason, self.packet.number, self.packet.time_ns, self.route)

    def end(self) -> list[Event]:
        """Says that nothing more will come."""
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
                events.append(self._conversation.record(data, numbers, time_ns, route))
            elif kind is PartKind.POLL:
                account.padding += size
            elif kind is PartKind.LOST:
                account.skipped += size
                events.append(Skipped(data, 0, reason, self.packet.number, self.packet.time_ns, route))
            else:
                account.texts += size
                if kind is PartKind.UNLOCK:
                    events.append(Announcement(TextKind.UNLOCK, data, Unlock.parse(data), numbers, time_ns, route))
                elif kind is PartKind.ACCEPT:
                    events.append(Announcement(TextKind.ACCEPT, data, None, numbers, time_ns, route))
        return events
