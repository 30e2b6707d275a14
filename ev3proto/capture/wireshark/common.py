"""What the carriers share when rows of tshark become events: routes, conversations, the account, pieces of streams."""

from __future__ import annotations

from collections.abc import Callable, Collection, Hashable, Iterator
from typing import TypeVar

from ev3proto.bounded import Bounded, Budget
from ev3proto.capture.byte_account import Account
from ev3proto.capture.conversation import Conversation
from ev3proto.capture.record import Announcement, Direction, Event, Route, Skipped, TextKind
from ev3proto.capture.wireshark.row import Row
from ev3proto.capture.wireshark.segments import Origin
from ev3proto.errors import DecodeError, counted
from ev3proto.schema.discovery import Unlock
from ev3proto.schema.frame import frame_schema
from ev3proto.schema.header import HEADER_SIZE, frame_size, impossible_length, may_have_length
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.discovery import ACCEPT, UNLOCK_REQUEST
from ev3proto.tables.frame import LENGTH_FIELD

MOST_CONNECTIONS = 1024
"""Connections, and directions of them, that are remembered; those unused for longest are given up."""

_REQUEST = UNLOCK_REQUEST.encode()
_TEXT_ENDS = b"\r\n\0"

V = TypeVar("V")


class Common:
    """What is known of one capture, whatever carries its frames.

    account  counts the bytes
    ports    TCP ports on which bricks listen

    What waits may take so many bytes of memory together.
    """

    def __init__(self, account: Account, dialect: str, ports: Collection[int], memory: int) -> None:
        self.account = account
        self.ports = frozenset(ports)
        self._schema = frame_schema(dialect)
        self._budget = Budget(memory)
        self._conversations: Bounded[Hashable, Conversation] = Bounded(MOST_CONNECTIONS)
        self._routes: Bounded[tuple[object, ...], Route] = Bounded(MOST_CONNECTIONS)

    @property
    def forgotten(self) -> int:
        """How many commands are no longer waited for."""
        return self._budget.dropped

    def weigh(self, thing: object, size: int, drop: Callable[[int], object]) -> None:
        """Says how many bytes of memory something takes that waits; `drop` is called where it has to go."""
        self._budget.update(thing, size, drop)

    def piece(self, row: Row, data: bytes, origin: Origin, route: Route, talk: Conversation) -> Iterator[Event]:
        """What the dissector has taken from a stream in one piece: a text, a frame, or what is neither."""
        if data.startswith((ACCEPT, _REQUEST)) or not data.strip(_TEXT_ENDS):
            self.move("texts", len(data))
            if data.startswith(ACCEPT):
                yield Announcement(TextKind.ACCEPT, data, None, *origin, route)
            elif data.startswith(_REQUEST):
                yield Announcement(TextKind.UNLOCK, data, parsed(Unlock.parse, data), *origin, route)
        elif has_length(data) and (len(data) == frame_size(data) or (row.missing and len(data) < frame_size(data))):
            self.move("frames", len(data))
            yield talk.record(data, *origin, route)
        else:
            yield self.unread(row, data, route)

    def unread(self, row: Row, data: bytes, route: Route) -> Skipped:
        """Bytes that are no whole frame, and why."""
        self.move("skipped", len(data))
        missing = 0
        if len(data) < LENGTH_FIELD or has_length(data):
            missing = max(frame_size(data) - len(data), 0) if len(data) >= LENGTH_FIELD else 0
            reason = f"a frame is cut off: {counted(len(data), 'byte')} of it were captured"
        else:
            reason = impossible_length(frame_size(data) - LENGTH_FIELD)
        return Skipped(data, missing, reason, row.packet, row.time_ns, route)

    def route(
        self, carrier: Carrier, source: str, target: str, is_from_host: bool | None, interface: str | None
    ) -> Route:
        """The route between two ends; `is_from_host` is None where the direction is not known."""
        peer = source if is_from_host is False else target
        direction = None if is_from_host is None else Direction.SENT if is_from_host else Direction.RECEIVED
        key = carrier, source, target, direction, interface
        return self._routes.use(key, lambda: Route(carrier, source, target, direction, interface, peer))[0]

    def conversation(self, key: Hashable) -> Conversation:
        """The conversation of two ends, whichever sends."""
        return self._conversations.use(key, lambda: Conversation(self._schema, self._budget))[0]

    def move(self, part: str, size: int) -> None:
        """Says what some of the bytes are that counted as others."""
        setattr(self.account, part, getattr(self.account, part) + size)
        self.account.other -= size


def has_length(data: bytes) -> bool:
    """Whether a frame starts here, by its length field."""
    return len(data) >= HEADER_SIZE and may_have_length(data)


def parsed(parse: Callable[[bytes], V], data: bytes) -> V | None:
    """What a text says; None for one at fault."""
    try:
        return parse(data)
    except DecodeError:
        return None
