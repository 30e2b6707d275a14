"""What a timeline has: marks in lanes, counts where there are too many of them, and how each brick did."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from enum import StrEnum
from itertools import cycle
from typing import NamedTuple

from ev3proto.capture.latencies import Latencies
from ev3proto.capture.record import NANOSECONDS

MOST_BINS = 600
"""Bins from the first mark to the last: a bin is hardly wider than a pixel or two."""

_FIRST_WIDTH_NS = 1_000_000


class LaneKind(StrEnum):
    """What lanes are about, in the order in which they are drawn."""

    ANNOUNCEMENTS = "announcements"
    DIRECT = "direct commands"
    SYSTEM = "system commands"
    FILES = "files"
    DAISY = "daisy chain"
    TROUBLE = "trouble"


class MarkState(StrEnum):
    """How it went, in the words and the order of the legend."""

    ANSWERED = "answered"
    SILENT = "no reply asked for"
    ERROR = "answered with an error"
    UNANSWERED = "never answered"
    ORPHAN = "reply, command not seen"
    MOVED = "file moved"
    CUT_SHORT = "file not moved whole"
    ANNOUNCED = "announcement"
    FAULTY = "faulty frame"
    SKIPPED = "bytes skipped"


TROUBLES = frozenset({MarkState.ERROR, MarkState.UNANSWERED, MarkState.CUT_SHORT, MarkState.FAULTY, MarkState.SKIPPED})
"""What people look for: it is kept one by one where the rest is only counted."""

OTHERS = "others"
"""The subject, or the brick, of all those beyond the limits."""


class Lane(NamedTuple):
    """The place of a mark: `USB 1.7`, direct commands, `SOUND.TONE`."""

    brick: str
    kind: LaneKind
    subject: str


@dataclass(slots=True)
class Mark:
    """One thing that happened: a command with its reply, a file that was moved, a beacon, skipped bytes.

    outcome  how it went
    begin    seconds since the first event: of an exchange, when the command was captured
    end      the same for the reply; None for what has no end
    label    a text beside it: the values of a reply, the path of a file; "" for nothing
    tip      what else is known of it, by name
    number   the packet by which to find it
    latency  seconds from command to reply; None where there is none, or no time was recorded
    """

    lane: Lane
    outcome: MarkState
    begin: float
    end: float | None
    label: str
    tip: dict[str, str]
    number: int
    latency: float | None = None


@dataclass(slots=True)
class Cell:
    """The marks of one lane in one bin of time, counted; `slowest` is the packet of the command that waited longest."""

    count: int = 0
    troubles: Counter[MarkState] = field(default_factory=Counter)
    latencies: tuple[float, float] | None = None
    slowest: int = 0

    def merge(self, other: Cell) -> None:
        """Counts all that another cell counted."""
        self.count += other.count
        self.troubles += other.troubles
        if other.latencies is not None:
            low, high = self.latencies or other.latencies
            if self.latencies is None or other.latencies[1] > high:
                self.slowest = other.slowest
            self.latencies = min(low, other.latencies[0]), max(high, other.latencies[1])


class Bins:
    """Counts by lane and bin. The bins grow with the time that they cover: never more than MOST_BINS a lane."""

    def __init__(self) -> None:
        self.width_ns = _FIRST_WIDTH_NS
        # 1, 5, 10, 50, 100 milliseconds and so on: round numbers, each of which the one before divides.
        self._factors = cycle((5, 2))
        self._cells: dict[tuple[Lane, int], Cell] = {}
        self._first = self._last = 0.0

    @property
    def cells(self) -> dict[tuple[Lane, float], Cell]:
        """The cells by lane and begin of the bin in seconds, in the order of time."""
        ordered = sorted(self._cells.items(), key=lambda item: item[0][1])
        return {(lane, number * self.width_ns / NANOSECONDS): cell for (lane, number), cell in ordered}

    def add(self, mark: Mark) -> None:
        """Counts a mark in the bin in which it begins."""
        if not self._cells:
            self._first = self._last = mark.begin
        self._first, self._last = min(self._first, mark.begin), max(self._last, mark.begin)
        while self._number(self._last) - self._number(self._first) >= MOST_BINS:
            factor = next(self._factors)
            self.width_ns *= factor
            narrow, self._cells = self._cells, {}
            for (lane, number), cell in narrow.items():
                self._cells.setdefault((lane, number // factor), Cell()).merge(cell)
        troubles = Counter([mark.outcome] if mark.outcome in TROUBLES else ())
        latencies = None if mark.latency is None else (mark.latency, mark.latency)
        one = Cell(1, troubles, latencies, mark.number)
        self._cells.setdefault((mark.lane, self._number(mark.begin)), Cell()).merge(one)

    def _number(self, seconds: float) -> int:
        return round(seconds * NANOSECONDS) // self.width_ns


@dataclass(slots=True)
class Tally:
    """How often what happened at one brick, and how long its answers took."""

    messages: int = 0
    outcomes: Counter[MarkState] = field(default_factory=Counter)
    latencies: Latencies = field(default_factory=Latencies)

    def add(self, mark: Mark) -> None:
        """Counts a mark."""
        self.outcomes[mark.outcome] += 1
        if mark.latency is not None:
            self.latencies.add(mark.latency)


@dataclass(slots=True)
class Timeline:
    """All that is drawn.

    origin_ns  time of the capture's first event, in nanoseconds since 1970-01-01 UTC: 0 on the axis
    begin      where the picture begins, in seconds since then
    end        where it ends
    marks      what is drawn one by one, in the order of time: everything, or where that is too much, troubles and files
    cells      where it was too much: counts by lane and begin of the bin, else empty
    bin_width  seconds of a bin, 0 where nothing is binned
    bricks     how each brick did, by its name, in the order in which they appeared
    unshown    troubles and files that are counted, but too many to be shown one by one
    is_timed   the times are those of the capture; else there are none, and a second is a line of the text
    """

    origin_ns: int
    begin: float
    end: float
    marks: list[Mark]
    cells: dict[tuple[Lane, float], Cell]
    bin_width: float
    bricks: dict[str, Tally]
    unshown: int
    is_timed: bool = True

    @property
    def messages(self) -> int:
        """Messages of all bricks together."""
        return sum(tally.messages for tally in self.bricks.values())

    @property
    def outcomes(self) -> Counter[MarkState]:
        """How it went with all bricks together."""
        return sum((tally.outcomes for tally in self.bricks.values()), Counter())
