"""Frames from a text as a capture, with the times in the text, or else one each millisecond."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from datetime import UTC, datetime

from ev3proto.bounded import DEFAULT_MEMORY, Budget
from ev3proto.capture.byte_account import Account
from ev3proto.capture.conversation import Conversation
from ev3proto.capture.reading import Capture
from ev3proto.capture.record import HOST, NANOSECONDS, Direction, Event, Route
from ev3proto.schema.frame import frame_reader
from ev3proto.schema.header import HEADER_SIZE, unpack_header
from ev3proto.tables.carriers import DEFAULT_CARRIER
from ev3proto.tables.frame import MessageType
from ev3proto.text.paste.pieces import Pasted
from ev3proto.text.splitting import split

BEGIN_NS = 1_767_225_600 * NANOSECONDS
"""The day of times without dates: 2026-01-01, so that the same text makes the same capture."""

STEP_NS = NANOSECONDS // 1000
"""Time between frames without times, in nanoseconds."""

BRICK = "brick"
"""The brick's end of a route: a text seldom has its address."""

_DAY_NS = 86_400 * NANOSECONDS
_TIME = re.compile(
    r"(?:(?P<date>\d{4}[-/]\d\d[-/]\d\d)[T ]\s?)?(?P<clock>\d\d:\d\d:\d\d)(?:[.,](?P<part>\d{1,9}))?"
    r"(?P<zone>Z|\s?[+-]\d\d:?\d\d)?"
)
_COMMANDS = frozenset(int(member) for member in MessageType if member.is_command)


class Clock:
    """A clock for the frames of a text, which never goes back."""

    def __init__(self) -> None:
        self._days_ns = 0
        self._last_ns: int | None = None

    def at(self, time: str | None) -> int:
        """Returns the time of a frame in nanoseconds since 1970-01-01 UTC, by the time in the text, if any.

        A time that goes back by more than half a day has passed midnight; by less, it counts as that of the last frame.
        """
        last_ns = self._last_ns
        found = None if time is None else _nanoseconds(time)
        if found is None:
            now_ns = BEGIN_NS if last_ns is None else last_ns + STEP_NS
        else:
            now_ns, has_date = found
            now_ns += 0 if has_date else self._days_ns
            if last_ns is not None and not has_date and last_ns - now_ns > _DAY_NS // 2:
                self._days_ns += _DAY_NS
                now_ns += _DAY_NS
        self._last_ns = now_ns if last_ns is None else max(now_ns, last_ns)
        return self._last_ns


def _nanoseconds(text: str) -> tuple[int, bool] | None:
    """Returns a printed time in nanoseconds since 1970-01-01 UTC, and whether it has a date; None for other text."""
    found = _TIME.fullmatch(text.strip())
    if found is None:
        return None
    date = found["date"]
    zone = (found["zone"] or "").strip().replace("Z", "+00:00")
    day = date.replace("/", "-") if date else "1970-01-01"
    try:
        when = datetime.fromisoformat(f"{day}T{found['clock']}{zone if date else ''}")
    except ValueError:
        return None
    if when.tzinfo is None:
        when = when.replace(tzinfo=UTC)
    part_ns = int((found["part"] or "0").ljust(9, "0"))
    since = int(when.timestamp()) * NANOSECONDS + part_ns
    return (since, True) if date else (BEGIN_NS + since, False)


def read_log(pieces: Iterable[Pasted], *, dialect: str = "official", memory: int = DEFAULT_MEMORY) -> Capture:
    """Returns the frames of a text as a capture, whose records are numbered by lines."""
    account = Account()
    return Capture(_events(pieces, account, dialect, Budget(memory)), account)


def _events(pieces: Iterable[Pasted], account: Account, dialect: str, budget: Budget) -> Iterator[Event]:
    conversation = Conversation(frame_reader(dialect), budget)
    clock = Clock()
    routes = {
        (direction, is_timed): Route(DEFAULT_CARRIER, *ends, direction, None, BRICK, is_text=True, is_timed=is_timed)
        for direction, ends in ((Direction.SENT, (HOST, BRICK)), (Direction.RECEIVED, (BRICK, HOST)))
        for is_timed in (True, False)
    }
    for piece in pieces:
        if not piece.data:
            continue
        time_ns = clock.at(piece.time)
        account.packets += 1
        account.captured += len(piece.data)
        account.first_ns = time_ns if account.first_ns is None else account.first_ns
        account.last_ns = time_ns
        for frame in (one.message.build() for one in split(piece.data, dialect=dialect)):
            account.frames += len(frame)
            route = routes[_direction(piece, frame), piece.time is not None]
            yield conversation.record(frame, (piece.line,), time_ns, route)
        account.padding = account.captured - account.frames
        account.forgotten = budget.dropped


def _direction(piece: Pasted, frame: bytes) -> Direction:
    """Returns a frame's direction, from the text or else its type."""
    if piece.direction is not None:
        return Direction(piece.direction)
    is_command = len(frame) < HEADER_SIZE or unpack_header(frame)[2] in _COMMANDS
    return Direction.SENT if is_command else Direction.RECEIVED
