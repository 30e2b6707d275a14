"""Frames from a text as records, with the times in the text, or else one each millisecond."""

from __future__ import annotations

import re
from collections.abc import Iterator
from datetime import UTC, datetime
from functools import lru_cache

from ev3proto.bounded import DEFAULT_MEMORY, Budget
from ev3proto.capture.byte_account import Account
from ev3proto.capture.conversation import LoggedConversations
from ev3proto.capture.record import HOST, NANOSECONDS, Direction, Place, Record, Route, Written, missing_of
from ev3proto.messages import Message
from ev3proto.schema.frame import frame_reader
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.tables.carriers import DEFAULT_CARRIER
from ev3proto.text.paste.pieces import Pasted
from ev3proto.text.splitting import split

DAY_NS = 1_767_225_600 * NANOSECONDS
"""The day of times without dates in a capture that is made: 2026-01-01."""

STEP_NS = NANOSECONDS // 1000
"""Time between frames without times, in nanoseconds."""

BRICK = "brick"
"""The brick's end of a route: a text seldom has its address."""

_DAY_NS = 86_400 * NANOSECONDS
_TIME = re.compile(
    r"(?:(?P<date>\d{4}[-/]\d\d[-/]\d\d)[T ]\s?)?(?P<clock>\d\d:\d\d:\d\d)(?:[.,](?P<part>\d{1,9}))?"
    r"(?P<zone>Z|\s?[+-]\d\d:?\d\d)?"
)


class Clock:
    """A clock for the frames of a text, which never goes back."""

    def __init__(self, day_ns: int | None = None) -> None:
        """Takes the day of times without dates, in nanoseconds since 1970-01-01 UTC; None: the first of them is 0."""
        self._begin_ns = day_ns
        self._days_ns = 0
        self._last_ns: int | None = None

    def at(self, time: str | None) -> int:
        """Returns the time of a frame in nanoseconds since 1970-01-01 UTC, by the time in the text, if any.

        A time that goes back by more than half a day has passed midnight; by less, it counts as that of the last frame.
        """
        last_ns = self._last_ns
        found = None if time is None else _nanoseconds(time)
        if found is None:
            now_ns = self._begin_ns or 0 if last_ns is None else last_ns + STEP_NS
        else:
            now_ns, has_date = found
            now_ns = now_ns if has_date else self._on_its_day(now_ns)
        self._last_ns = now_ns if last_ns is None else max(now_ns, last_ns)
        return self._last_ns

    def _on_its_day(self, clock_ns: int) -> int:
        if self._begin_ns is None:
            self._begin_ns = -clock_ns
        now_ns = clock_ns + self._begin_ns + self._days_ns
        if self._last_ns is not None and self._last_ns - now_ns > _DAY_NS // 2:
            self._days_ns += _DAY_NS
            now_ns += _DAY_NS
        return now_ns


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
    return since, date is not None


@lru_cache
def _route(direction: Direction, label: str, *, is_timed: bool) -> Route:
    ends = (HOST, BRICK) if direction is Direction.SENT else (BRICK, HOST)
    return Route(DEFAULT_CARRIER, *ends, direction, None, BRICK, is_text=True, is_timed=is_timed, label=label)


class TextLog:
    """A dialogue in texts, whose records are numbered by lines.

    account      of the text that is read now; its packets are pieces of the text
    budget       limits the pending commands
    has_replies  whether a reply was read; else all commands stay unanswered, and dropping one loses nothing
    """

    def __init__(self, dialect: str, memory: int = DEFAULT_MEMORY) -> None:
        """Takes a memory limit in bytes."""
        self.account = Account()
        self.budget = Budget(memory)
        self.has_replies = False
        self._dialect = dialect
        self._conversation = LoggedConversations(frame_reader(dialect), self.budget)
        self._clock = Clock()

    def begin(self) -> Account:
        """Begins another text of the same dialogue. Returns its account."""
        self.account, self._clock = Account(), Clock()
        return self.account

    def records(self, pasted: Pasted, place: Place, *, is_typed: bool = False) -> Iterator[Record]:
        """Yields the records of the frames in a piece of the text."""
        account = self.account
        time_ns = self._time(pasted.time, len(pasted.data))
        for message, start, rest in split(pasted.data, dialect=self._dialect) if pasted.data else ():
            unknown = frozenset([one.offset - start for one in pasted.unknown])
            written = Written(place, pasted.direction, pasted.time, is_typed, pasted.column, unknown, rest)
            record = self._record(message, written, pasted.line, time_ns, pasted.label or "")
            if pasted.cut and message.fault is not None and message.fault.truncated:
                record.missing = missing_of(record.frame)
            yield record
        account.padding = account.captured - account.frames

    def made(self, message: Message, place: Place, number: int) -> Record:
        """Returns the record of a message that was made from a text without bytes."""
        frame = message.build()
        return self._record(message, Written(place), number, self._time(None, len(frame)))

    def _time(self, time: str | None, size: int) -> int:
        time_ns = self._clock.at(time)
        self.account.count_packet(time_ns, size, size)
        return time_ns

    def _record(self, message: Message, written: Written, number: int, time_ns: int, label: str = "") -> Record:
        frame = message.build()
        route = _route(_direction(written, message, len(frame)), label, is_timed=written.time is not None)
        record = self._conversation.record(frame, (number,), time_ns, route)
        record.written = written
        record.keep(message)
        self.has_replies = self.has_replies or (message.type is not None and not message.type.is_command)
        self.account.frames += len(frame)
        self.account.forgotten = self.budget.dropped
        return record


def _direction(written: Written, message: Message, size: int) -> Direction:
    if written.direction is not None:
        return Direction(written.direction)
    is_command = size < HEADER_SIZE if message.type is None else message.type.is_command
    return Direction.SENT if is_command else Direction.RECEIVED
