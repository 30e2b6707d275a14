"""What a timeline has: marks in lanes, counts where there are too many of them, and how each brick did."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from enum import StrEnum
from typing import NamedTuple

from ev3proto.capture.latencies import Latencies
from ev3proto.capture.record import NANOSECONDS


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

EXCHANGES = frozenset({LaneKind.DIRECT, LaneKind.SYSTEM, LaneKind.DAISY})
"""The kinds in which a brick answers, so that there is a latency."""

OTHERS = "others"
"""The subject, or the brick, of all those beyond the limits."""


class Lane(NamedTuple):
    """Where a mark stands: `USB 1.7`, direct commands, `SOUND.TONE`."""

    brick: str
    kind: LaneKind
    subject: str


@dataclass(slots=True)
class Mark:
    """One thing that happened: a command with its reply, a file that was moved, a beacon, bytes that were skipped.

    lane      where it stands
    outcome   how it went
    begin_ns  when it began, in nanoseconds since 1970-01-01 UTC: for an exchange, when the command was captured
    end_ns    when it ended: for an exchange, when the reply was captured; None for what has no end
    heading   what it is, in a few words
    label     what may stand beside it: the values of a reply, the path of a file; "" for nothing
    details   what else is known of it, by name
    number    the packet by which to find it
    is_timed  somebody wrote down when it was; else there is only an order
    """

    lane: Lane
    outcome: MarkState
    begin_ns: int
    end_ns: int | None
    heading: str
    label: str
    details: dict[str, str]
    number: int
    is_timed: bool = True

    @property
    def latency_ns(self) -> int | None:
        """Nanoseconds from command to reply, 0 where their times are the wrong way round; None for all else."""
        if not self.is_timed or self.end_ns is None or self.lane.kind not in EXCHANGES:
            return None
        return max(self.end_ns - self.begin_ns, 0)


@dataclass(slots=True)
class Cell:
    """The marks of one lane in one bin of time, counted.

    count       all of them
    troubles    those that are TROUBLES, by outcome
    answers     those that have a latency
    fastest_ns  the shortest latency, None where there is none
    slowest_ns  the longest
    slowest     the packet of the command that had to wait so long
    """

    count: int = 0
    troubles: Counter[MarkState] = field(default_factory=Counter)
    answers: int = 0
    fastest_ns: int | None = None
    slowest_ns: int | None = None
    slowest: int = 0

    def add(self, mark: Mark) -> None:
        """Counts a mark."""
        self.count += 1
        if mark.outcome in TROUBLES:
            self.troubles[mark.outcome] += 1
        latency = mark.latency_ns
        if latency is not None:
            self._answer(1, latency, latency, mark.number)

    def merge(self, other: Cell) -> None:
        """Counts all that another cell counted."""
        self.count += other.count
        self.troubles += other.troubles
        if other.fastest_ns is not None and other.slowest_ns is not None:
            self._answer(other.answers, other.fastest_ns, other.slowest_ns, other.slowest)

    def _answer(self, answers: int, fastest_ns: int, slowest_ns: int, number: int) -> None:
        self.answers += answers
        if self.fastest_ns is None or fastest_ns < self.fastest_ns:
            self.fastest_ns = fastest_ns
        if self.slowest_ns is None or slowest_ns > self.slowest_ns:
            self.slowest_ns, self.slowest = slowest_ns, number


@dataclass(slots=True)
class Tally:
    """How often what happened, and how long answers took. It stays small however long the capture is."""

    messages: int = 0
    outcomes: Counter[MarkState] = field(default_factory=Counter)
    latencies: Latencies = field(default_factory=Latencies)

    def add(self, mark: Mark) -> None:
        """Counts a mark."""
        self.outcomes[mark.outcome] += 1
        latency = mark.latency_ns
        if latency is not None:
            self.latencies.add(latency / NANOSECONDS)


@dataclass(slots=True)
class Timeline:
    """All that is drawn.

    origin_ns  time of the capture's first event, in nanoseconds since 1970-01-01 UTC: 0 on the axis
    begin_ns   where the picture begins, in nanoseconds since 1970-01-01 UTC
    end_ns     where it ends
    marks      what is drawn one by one, in the order of time: everything, or where that is too much, the troubles
    files      files that were moved, in the order of time
    cells      where it was too much: counts by lane and begin of the bin, else empty
    bin_ns     nanoseconds of a bin, 0 where nothing is binned
    bricks     how each brick did, by its name, in the order in which they appeared
    unshown    troubles and files that are counted, but too many to be shown one by one
    is_timed   the times are those of the capture; else there are none, and a second stands for a line of the text
    """

    origin_ns: int
    begin_ns: int
    end_ns: int
    marks: list[Mark]
    files: list[Mark]
    cells: dict[tuple[Lane, int], Cell]
    bin_ns: int
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

    def seconds(self, time_ns: int) -> float:
        """Seconds since the capture's first event."""
        return (time_ns - self.origin_ns) / NANOSECONDS

    def lanes(self) -> Counter[Lane]:
        """How often something stands in each lane but those of files, in the order in which they appeared."""
        found: Counter[Lane] = Counter()
        if self.cells:
            for (lane, _), cell in self.cells.items():
                found[lane] += cell.count
        else:
            found.update(mark.lane for mark in self.marks)
        return found
