"""The contents of a timeline: marks in lanes, or counts if there are too many, and totals of each brick."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from enum import StrEnum
from itertools import cycle
from typing import NamedTuple

from ev3proto.capture.latencies import Latencies
from ev3proto.capture.record import NANOSECONDS

MOST_BINS = 600
"""Maximum number of bins from the first mark to the last: a bin is one or two pixels wide."""

_FIRST_WIDTH_NS = 1_000_000


class LaneKind(StrEnum):
    """Kinds of lanes, in the order in which they are drawn."""

    ANNOUNCEMENTS = "announcements"
    DIRECT = "direct commands"
    SYSTEM = "system commands"
    FILES = "files"
    DAISY = "daisy chain"
    TROUBLE = "trouble"


class MarkState(StrEnum):
    """Outcomes, with the texts and in the order of the legend."""

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
"""Outcomes that readers look for: they keep their own marks when the rest is only counted."""

OTHERS = "others"
"""The name that subjects or bricks beyond the limits share."""


class Lane(NamedTuple):
    """The place of a mark: `USB 1.7`, direct commands, `SOUND.TONE`."""

    brick: str
    kind: LaneKind
    subject: str


@dataclass(slots=True)
class Mark:
    """One event: a command with its reply, a file that was moved, a beacon, skipped bytes."""

    lane: Lane
    outcome: MarkState
    begin: float  # seconds from the first event of the capture to the command
    end: float | None  # the same to the reply; None for marks without an end
    label: str  # a text beside it: the values of a reply, the path of a file; "" for nothing
    tip: dict[str, str]  # details by name
    number: int  # number of its packet
    latency: float | None = None  # seconds from command to reply; None without a reply or without times


@dataclass(slots=True)
class Cell:
    """The counts of one lane in one bin of time; `slowest` is the packet of the command with the longest latency."""

    count: int = 0
    troubles: Counter[MarkState] = field(default_factory=Counter)
    latencies: tuple[float, float] | None = None
    slowest: int = 0

    def merge(self, other: Cell) -> None:
        """Adds the counts of another cell."""
        self.count += other.count
        self.troubles += other.troubles
        if other.latencies is not None:
            low, high = self.latencies or other.latencies
            if self.latencies is None or other.latencies[1] > high:
                self.slowest = other.slowest
            self.latencies = min(low, other.latencies[0]), max(high, other.latencies[1])


class Bins:
    """Counts by lane and bin. Bins are widened as time passes, so that each lane has at most MOST_BINS."""

    def __init__(self) -> None:
        self.width_ns = _FIRST_WIDTH_NS
        # 1, 5, 10, 50, 100 milliseconds and so on: round numbers, each a multiple of the one before.
        self._factors = cycle((5, 2))
        self._cells: dict[tuple[Lane, int], Cell] = {}
        self._first = self._last = 0.0

    @property
    def cells(self) -> dict[tuple[Lane, float], Cell]:
        """The cells by lane and start of the bin in seconds, in the order of time."""
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
    """The totals of one brick: messages, outcomes, latencies."""

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
    """A timeline to draw."""

    origin_ns: int  # time of the capture's first event, in nanoseconds since 1970-01-01 UTC: 0 on the axis
    begin: float  # start of the picture, in seconds since then
    end: float  # end of the picture
    marks: list[Mark]  # all marks in the order of time; if there are too many, only those of problems and files
    cells: dict[tuple[Lane, float], Cell]  # if there are too many marks: counts by lane and start of the bin
    bin_width: float  # width of a bin in seconds, 0 without bins
    bricks: dict[str, Tally]  # totals of each brick by name, in the order of their first events
    unshown: int  # problems and files that were counted, but not drawn
    is_timed: bool = True  # the capture has times; otherwise a second is a line of the text

    @property
    def messages(self) -> int:
        """Number of messages of all bricks."""
        return sum(tally.messages for tally in self.bricks.values())

    @property
    def outcomes(self) -> Counter[MarkState]:
        """Outcomes of all bricks."""
        return sum((tally.outcomes for tally in self.bricks.values()), Counter())
