"""Counts by lane and bin of time, for captures of any length: the bins grow with the time that they must cover."""

from __future__ import annotations

from itertools import cycle

from ev3proto.capture.timeline.marks import Cell, Lane, Mark

MOST_BINS = 600
"""Bins from the first mark to the last: a bin is hardly wider than a pixel or two."""

FIRST_WIDTH_NS = 1_000_000
"""Width of the bins while the capture is short: a millisecond."""


class Bins:
    """Counts marks. Never keeps more than MOST_BINS cells a lane."""

    def __init__(self) -> None:
        self._width = FIRST_WIDTH_NS
        # 1, 5, 10, 50, 100 milliseconds and so on: round numbers, each of which the one before divides.
        self._factors = cycle((5, 2))
        self._cells: dict[tuple[Lane, int], Cell] = {}
        self._span: tuple[int, int] | None = None

    @property
    def width_ns(self) -> int:
        """Nanoseconds of a bin."""
        return self._width

    @property
    def cells(self) -> dict[tuple[Lane, int], Cell]:
        """The cells by lane and begin of the bin in nanoseconds, in the order of time."""
        begun = {(lane, index * self._width): cell for (lane, index), cell in self._cells.items()}
        return dict(sorted(begun.items(), key=lambda item: item[0][1]))

    def add(self, mark: Mark) -> None:
        """Counts a mark in the bin in which it begins."""
        first, last = self._span or (mark.begin_ns, mark.begin_ns)
        first, last = self._span = min(first, mark.begin_ns), max(last, mark.begin_ns)
        while last // self._width - first // self._width >= MOST_BINS:
            self._widen(next(self._factors))
        self._cell(mark.lane, mark.begin_ns // self._width).add(mark)

    def _widen(self, factor: int) -> None:
        self._width *= factor
        narrow, self._cells = self._cells, {}
        for (lane, index), cell in narrow.items():
            self._cell(lane, index // factor).merge(cell)

    def _cell(self, lane: Lane, index: int) -> Cell:
        cell = self._cells.get((lane, index))
        if cell is None:
            cell = self._cells[lane, index] = Cell()
        return cell
