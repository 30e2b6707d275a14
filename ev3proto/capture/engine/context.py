"""What all parts of the built-in engine share, and the streams that two of the carriers have."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from ev3proto.capture.account import Account
from ev3proto.capture.conversation import Conversation
from ev3proto.capture.cutting import Cutter, Kind, Piece
from ev3proto.capture.record import Announcement, Event, Route, Said, Skipped
from ev3proto.schema.discovery import Unlock
from ev3proto.schema.frame import FrameSchema


@dataclass(frozen=True, slots=True)
class Context:
    """The schema that reads frames, and the account of all bytes."""

    schema: FrameSchema
    account: Account


class Stream:
    """One direction of a connection: its pieces become events, its bytes stand in the account."""

    __slots__ = ("_account", "_conversation", "cutter", "number", "route", "time_ns")

    def __init__(self, context: Context, conversation: Conversation, cutter: Cutter, route: Route) -> None:
        self._account = context.account
        self._conversation = conversation
        self.cutter = cutter
        self.route = route
        self.number = 0
        self.time_ns = 0

    def feed(self, data: bytes, number: int, time_ns: int) -> list[Event]:
        """The events that are complete with the next bytes, which came in that packet, at the time of the last one."""
        self.time_ns = time_ns
        self.number = number
        return self._events(self.cutter.feed(data, number))

    def leave_hole(self, missing: int) -> list[Event]:
        """Says that bytes are missing here."""
        reason = f"{missing} byte{'s are' if missing != 1 else ' is'} missing in the stream: not in the capture"
        events = self._events(self.cutter.leave_hole(missing))
        return [*events, Skipped(b"", missing, reason, self.number, self.time_ns, self.route)]

    def skip(self, data: bytes, reason: str) -> Event:
        """Bytes that belong to no place in the stream any more."""
        self._account.skipped += len(data)
        return Skipped(data, 0, reason, self.number, self.time_ns, self.route)

    def end(self) -> list[Event]:
        """Says that nothing more will come."""
        return self._events(self.cutter.end())

    def _events(self, pieces: Iterable[Piece]) -> list[Event]:
        events: list[Event] = []
        account, route, time_ns = self._account, self.route, self.time_ns
        for kind, data, numbers, reason in pieces:
            size = len(data)
            if kind is Kind.FRAME:
                account.frames += size
                events.append(self._conversation.record(data, numbers, time_ns, route))
            elif kind is Kind.OTHER:
                account.other += size
            elif kind is Kind.LOST:
                account.skipped += size
                events.append(Skipped(data, 0, reason, self.number, time_ns, route))
            else:
                account.texts += size
                if kind is Kind.UNLOCK:
                    events.append(Announcement(Said.UNLOCK, data, Unlock.parse(data), numbers, time_ns, route))
                elif kind is Kind.ACCEPT:
                    events.append(Announcement(Said.ACCEPT, data, None, numbers, time_ns, route))
        return events
