"""Where everything stands: rows and panels, symbols, bars, labels that fit, the legend. No drawing yet."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass, field
from typing import Any

from ev3proto.capture.timeline.marks import EXCHANGES, OTHERS, TROUBLES, Cell, Lane, LaneKind, Mark, MarkState, Timeline
from ev3proto.capture.timeline.phrases import brick_summary, clock, count, exact, extent, summary

WIDTH = 960
"""Pixels from the begin of the capture to its end."""

MOST_ROWS = 10
"""Rows of one kind of one brick; the rarest subjects beyond that share a row."""

MOST_FILE_ROWS = 5
"""Rows for files that are moved at the same time, or whose paths would stand on each other."""

SHADES = 5
"""How many shades show how much was counted."""

FIRST_MS = 0.001
"""The shortest latency that is drawn, in milliseconds: on a logarithmic axis, nothing is at 0."""

_LETTER = 6.0
"""Pixels that a letter of a label takes, on the average; capitals take more."""

_CAPITAL = 7.8
_LEGEND_LETTER = 6.1
LEGEND_HEIGHT = 20
"""Pixels from one row of the legend to the next."""

KINDS_WIDTH = 124
"""Pixels for the names of kinds, at the left edge."""

_MOST_LABEL_WIDTH = 300
_SYMBOL = 12
_SYMBOL_SIZES = ((300, 75.0), (3000, 40.0))
_SMALLEST_SYMBOL = 20.0
_MARGIN = 0.015
"""Of the time, on each side."""

LATENCY_MARGIN = 1.5
"""How many times the longest latency the end of a logarithmic axis is, and the shortest its beginning."""

_LOGARITHMIC = 20
"""How many times the shortest latency the longest must be for a logarithmic axis."""

_MANY_TIMES = 500
"""How many times it must be for an axis on which only powers of ten have room."""

Datum = dict[str, Any]
"""One thing to draw: short names, for there may be many thousands."""


@dataclass(slots=True)
class BrickRows:
    """The rows of one brick.

    title   its name
    aside   how it did
    rows    identifiers of the rows in their order: `3/SOUND.TONE`, a number and what stands beside the row
    bands   the rows again, with what their background needs
    kinds   where the name of a kind stands: at its first row
    """

    title: str
    aside: str
    rows: list[str] = field(default_factory=list)
    bands: list[Datum] = field(default_factory=list)
    kinds: list[Datum] = field(default_factory=list)


@dataclass(slots=True)
class Drawing:
    """All that is drawn, with its place.

    title        name of the capture
    lines        what stands under the title
    domain       seconds at the left and the right edge
    panels       one a brick, one below the other
    marks        symbols, bars and labels: `p` panel, `row`, `t` and `e` begin and end in seconds, `o` outcome, `bad`
                 for trouble, `f` for files, `ms` latency, `l` label, `x` where in time it stands, `back` whether to the
                 left of that, `w` the least width of the picture in which it has room, `tip` what is said of it
    cells        counts in bins: `p`, `row`, `t`, `e`, `s` shade from 1 to SHADES, `tip`
    latencies    in bins: `t`, `ms` the slowest and `low` the fastest answer, `tip`
    legend       symbols with their words: `o`, `text`, `x`, `x2`, `y` in pixels, `s` instead of `o` for shades,
                 `breaks` where a row must begin
    latency_ms   shortest and longest latency, None where nothing was answered
    is_timed     the axis has seconds; else the lines of a text without times
    """

    title: str
    lines: list[str]
    domain: tuple[float, float]
    panels: list[BrickRows] = field(default_factory=list)
    marks: list[Datum] = field(default_factory=list)
    cells: list[Datum] = field(default_factory=list)
    latencies: list[Datum] = field(default_factory=list)
    legend: list[Datum] = field(default_factory=list)
    latency_ms: tuple[float, float] | None = None
    is_timed: bool = True

    @property
    def label_width(self) -> float:
        """Pixels for what stands beside the rows."""
        longest = max((len(row.partition("/")[2]) for panel in self.panels for row in panel.rows), default=0)
        return min(_CAPITAL * longest, _MOST_LABEL_WIDTH)

    @property
    def margin(self) -> float:
        """Pixels left of the rows: names of kinds, and what stands beside the rows."""
        return KINDS_WIDTH + self.label_width

    @property
    def symbol_size(self) -> float:
        """Square pixels of a symbol: where there are many, they are smaller."""
        return next((size for most, size in _SYMBOL_SIZES if len(self.marks) <= most), _SMALLEST_SYMBOL)

    @property
    def latency_ticks(self) -> list[float]:
        """Where a logarithmic axis has a line: at 1, 2, 5, 10, 20, 50 and so on, or at 1, 10, 100 where it is long."""
        if self.latency_ms is None:
            return []
        low, high = self.latency_ms
        digits = (1, 2, 5) if high < _MANY_TIMES * low else (1,)
        decades = range(math.floor(math.log10(low)) - 1, math.ceil(math.log10(high)) + 1)
        ticks = (float(f"{digit}e{decade}") for decade in decades for digit in digits)
        return [tick for tick in ticks if low / LATENCY_MARGIN <= tick <= high * LATENCY_MARGIN]

    @property
    def is_logarithmic(self) -> bool:
        """Whether latencies are so different that small ones would lie flat on the axis."""
        return self.latency_ms is not None and self.latency_ms[1] >= _LOGARITHMIC * self.latency_ms[0]

    @property
    def legend_height(self) -> float:
        """Pixels of the legend's rows."""
        return float(max((entry["y"] for entry in self.legend), default=0)) + LEGEND_HEIGHT / 2


def _dialogue_begin(timeline: Timeline) -> int:
    """Where the picture begins: a beacon long before the first message would leave the picture empty."""
    said = [mark.begin_ns for mark in timeline.marks if mark.outcome is not MarkState.ANNOUNCED]
    return max(timeline.begin_ns, min(said)) if said else timeline.begin_ns


def lay_out(timeline: Timeline, title: str) -> Drawing:
    """The places of all that a timeline has."""
    begin, end = timeline.seconds(_dialogue_begin(timeline)), timeline.seconds(timeline.end_ns)
    margin = _MARGIN * (end - begin) or 0.5
    picture = Drawing(
        title, summary(timeline), (_rounded(begin - margin), _rounded(end + margin)), is_timed=timeline.is_timed
    )
    homes = _homes(timeline)
    for brick, tally in timeline.bricks.items():
        if homes[brick] == brick:
            panel = BrickRows(brick, brick_summary(tally))
            picture.panels.append(panel)
            _Rows(timeline, picture, panel, {name for name, home in homes.items() if home == brick}).fill()
    _least_widths(picture)
    # What went wrong stands on top of the rest.
    picture.marks.sort(key=lambda datum: "bad" in datum)
    _latencies(timeline, picture)
    picture.legend = _legend(picture, timeline)
    return picture


def _least_widths(picture: Drawing) -> None:
    """How wide the picture must be for each label: a narrow window has no room for some of them."""
    low, high = picture.domain
    rows: dict[tuple[int, str], list[Datum]] = {}
    for datum in picture.marks:
        rows.setdefault((datum["p"], datum["row"]), []).append(datum)
    for row in rows.values():
        row.sort(key=lambda datum: float(datum["t"]))
        # Beside each mark, the one before it and the one after it, where there is one.
        for datum, before, after in zip(row, [None, *row], [*row[1:], None], strict=False):
            if "l" not in datum:
                continue
            if datum["back"]:
                width = _words_width(datum["l"]) + (_words_width(before.get("l", "")) if before else 0)
                room = datum["x"] - (before.get("e", before["t"]) if before else low)
            else:
                width = _words_width(datum["l"])
                room = (after["t"] if after else high) - datum["x"]
            # What had room in the whole picture is shown there, however it was rounded.
            datum["w"] = min(round(width * (high - low) / room), WIDTH) if room > 0 else WIDTH


def _words_width(words: str) -> float:
    """Pixels of a label, and of the space around it."""
    return 1.5 * _SYMBOL + _LETTER * len(words)


def _homes(timeline: Timeline) -> dict[str, str]:
    """In whose panel a brick is drawn: a beacon comes from another port than the dialogue, but from the same brick."""
    homes = {brick: brick for brick in timeline.bricks}
    speaking = [brick for brick, tally in timeline.bricks.items() if tally.messages]
    for brick, tally in timeline.bricks.items():
        same = [other for other in speaking if _host(other) == _host(brick)]
        if not tally.messages and len(same) == 1:
            homes[brick] = same[0]
    return homes


def _host(brick: str) -> str:
    host, colon, port = brick.rpartition(":")
    return host if colon and port.isdecimal() and brick.startswith("WiFi") else brick


class _Rows:
    """Fills a panel with its rows, and the picture with what stands in them."""

    def __init__(self, timeline: Timeline, picture: Drawing, panel: BrickRows, bricks: set[str]) -> None:
        self._timeline = timeline
        self._picture = picture
        self._panel = panel
        self._index = len(picture.panels) - 1
        self._bricks = bricks
        self._by_lane: dict[Lane, str] = {}

    def fill(self) -> None:
        """All rows, kind by kind."""
        lanes = Counter({lane: n for lane, n in self._timeline.lanes().items() if lane.brick in self._bricks})
        for kind in LaneKind:
            first = len(self._panel.rows)
            if kind is LaneKind.FILES:
                self._files()
            else:
                self._subjects(Counter({lane: n for lane, n in lanes.items() if lane.kind is kind}))
            added = self._panel.rows[first:]
            if added:
                shaded = len(self._panel.kinds) % 2 == 0
                self._panel.bands += [{"row": row, "shaded": shaded} for row in added]
                self._panel.kinds.append({"row": added[0], "kind": kind.value})
        self._marks()
        self._cells()

    def _row(self, label: str) -> str:
        row = f"{len(self._panel.rows)}/{label}"
        self._panel.rows.append(row)
        return row

    def _subjects(self, lanes: Counter[Lane]) -> None:
        shares = Counter[str]()
        for lane, number in lanes.items():
            shares[lane.subject] += number
        own = {about for about, _ in shares.most_common(MOST_ROWS if len(shares) <= MOST_ROWS else MOST_ROWS - 1)}
        rest = [about for about in shares if about not in own or about == OTHERS]
        rows = {about: self._row(about) for about in shares if about in own and about != OTHERS}
        if rest:
            others = self._row(f"{len(rest)} others" if len(rest) > 1 or OTHERS not in rest else OTHERS)
            rows |= dict.fromkeys(rest, others)
        self._by_lane |= {lane: rows[lane.subject] for lane in lanes}

    def _files(self) -> None:
        ends: list[float] = []
        rows: list[str] = []
        for mark in self._timeline.files:
            if mark.lane.brick not in self._bricks:
                continue
            left, right = self._pixel(mark.begin_ns), self._pixel(mark.end_ns or mark.begin_ns)
            width = _words_width(mark.label)
            # In the bar, or after it where it is too short, or before it where the picture ends.
            after = left + width > right
            words = right if after else max(left, 0.0)
            backwards = words + width > WIDTH
            begin, end = (left - width, right) if backwards else (left, max(right, words + width))
            free = [number for number, taken in enumerate(ends) if taken <= begin]
            if not free and len(ends) < MOST_FILE_ROWS:
                ends.append(end)
                rows.append(self._row(""))
                free = [len(ends) - 1]
            number = free[0] if free else min(range(len(ends)), key=ends.__getitem__)
            ends[number] = max(ends[number], end)
            datum = self._datum(mark, rows[number])
            datum["f"] = True
            if free:
                place = datum["e"] if after and not backwards else max(datum["t"], self._picture.domain[0])
                datum |= {"l": mark.label, "x": place, "back": backwards}
            self._picture.marks.append(datum)

    def _marks(self) -> None:
        by_row: dict[str, list[tuple[Mark, Datum]]] = {}
        for mark in self._timeline.marks:
            if mark.lane.brick in self._bricks:
                row = self._by_lane[mark.lane]
                by_row.setdefault(row, []).append((mark, self._datum(mark, row)))
        for found in by_row.values():
            # Words on shades cannot be read.
            if not self._timeline.bin_ns:
                self._label(found)
            self._picture.marks += [datum for _, datum in found]

    def _label(self, found: list[tuple[Mark, Datum]]) -> None:
        """Labels that have room up to the next symbol of the row or, at the right edge, down to the one before."""
        taken = 0.0
        for index, (mark, datum) in enumerate(found):
            left = self._pixel(mark.begin_ns)
            right = left if mark.end_ns is None else self._pixel(mark.end_ns)
            width = _words_width(mark.label)
            is_last = index + 1 == len(found)
            limit = WIDTH if is_last else self._pixel(found[index + 1][0].begin_ns) - _SYMBOL / 2
            # In the bar, or after it where it is too short.
            after = left + width > right
            end = (right if after else left) + width
            taken, before = max(right, left + _SYMBOL / 2), taken
            if mark.label and end <= limit:
                datum |= {"l": mark.label, "x": datum.get("e", datum["t"]) if after else datum["t"], "back": False}
                taken = end
            elif mark.label and end > WIDTH and left - width >= before:
                datum |= {"l": mark.label, "x": datum["t"], "back": True}

    def _cells(self) -> None:
        cells = {
            key: cell for key, cell in _merged(self._timeline, self._by_lane).items() if key[0] in self._panel.rows
        }
        most = max((cell.count for cell in self._timeline.cells.values()), default=0)
        for (row, begin), cell in cells.items():
            since = self._timeline.seconds(begin)
            self._picture.cells.append(
                {
                    "p": self._index,
                    "row": row,
                    "t": _rounded(since),
                    "e": _rounded(self._timeline.seconds(begin + self._timeline.bin_ns)),
                    "s": shade(cell.count, most),
                    "tip": _cell_tip(self._timeline, begin, cell),
                }
            )

    def _datum(self, mark: Mark, row: str) -> Datum:
        datum: Datum = {
            "p": self._index,
            "row": row,
            "t": _rounded(self._timeline.seconds(mark.begin_ns)),
            "o": mark.outcome.value,
            "tip": _tip(self._timeline, mark),
        }
        if mark.outcome in TROUBLES:
            datum["bad"] = True
        if mark.end_ns is not None:
            datum["e"] = _rounded(self._timeline.seconds(mark.end_ns))
        if mark.latency_ns is not None:
            datum["ms"] = _milliseconds(mark.latency_ns)
        return datum

    def _pixel(self, time_ns: int) -> float:
        low, high = self._picture.domain
        return WIDTH * (self._timeline.seconds(time_ns) - low) / (high - low)


def _merged(timeline: Timeline, rows: dict[Lane, str]) -> dict[tuple[str, int], Cell]:
    """The cells by row: several subjects may share one."""
    found: dict[tuple[str, int], Cell] = {}
    for (lane, begin), cell in timeline.cells.items():
        if lane in rows:
            found.setdefault((rows[lane], begin), Cell()).merge(cell)
    return found


def shade(number: int, most: int) -> int:
    """How dark a count is, 1 to SHADES: each shade stands for as many times more than the one before."""
    return min(SHADES, 1 + int(SHADES * math.log(number) / math.log(most + 1)))


def shade_starts(most: int) -> list[int]:
    """The smallest count of each shade that occurs up to `most`."""
    starts: dict[int, int] = {}
    for step in range(SHADES):
        number = math.ceil((most + 1) ** (step / SHADES) - 1e-9)
        if number <= most:
            starts.setdefault(shade(number, most), number)
    return list(starts.values())


def _latencies(timeline: Timeline, picture: Drawing) -> None:
    found = [datum["ms"] for datum in picture.marks if "ms" in datum]
    bins: dict[int, Cell] = {}
    for (lane, begin), cell in timeline.cells.items():
        if lane.kind in EXCHANGES and cell.answers:
            bins.setdefault(begin, Cell()).merge(cell)
    for begin, cell in bins.items():
        assert cell.fastest_ns is not None
        assert cell.slowest_ns is not None
        low, high = _milliseconds(cell.fastest_ns), _milliseconds(cell.slowest_ns)
        found += [low, high]
        picture.latencies.append(
            {
                "t": _rounded(timeline.seconds(begin + timeline.bin_ns // 2)),
                "low": low,
                "ms": high,
                "tip": _cell_tip(timeline, begin, cell),
            }
        )
    if found:
        picture.latency_ms = min(found), max(found)


def _legend(picture: Drawing, timeline: Timeline) -> list[Datum]:
    """What occurs, in the order of the outcomes, in as many rows as it takes."""
    entries: list[Datum] = []
    outcomes = timeline.outcomes
    for outcome in MarkState:
        if outcomes[outcome]:
            entries.append({"o": outcome.value, "text": f"{outcome.value}: {outcomes[outcome]:,}"})
    if picture.cells:
        most = max(cell.count for cell in timeline.cells.values())
        for number in shade_starts(most):
            text = f"{number:,} or more in {extent(timeline, timeline.bin_ns)}"
            entries.append({"s": shade(number, most), "text": text, "breaks": number == 1})
    x, y = 0.0, LEGEND_HEIGHT / 2
    for entry in entries:
        width = _SYMBOL + _LEGEND_LETTER * len(entry["text"])
        if entry.get("breaks") or (x and x + width > WIDTH):
            x, y = 0.0, y + LEGEND_HEIGHT
        entry |= {"x": x + _SYMBOL / 2, "x2": x + width, "y": y}
        x += width + 2 * _SYMBOL
    return entries


def _tip(timeline: Timeline, mark: Mark) -> dict[str, str]:
    tip = {"title": mark.heading, "outcome": mark.outcome.value}
    if timeline.is_timed and mark.is_timed:
        tip["at"] = f"{timeline.seconds(mark.begin_ns):.6f} s"
        tip["clock"] = clock(mark.begin_ns)
        if mark.end_ns is not None:
            name = "took" if mark.lane.kind is LaneKind.FILES else "answer after"
            tip[name] = exact(mark.end_ns - mark.begin_ns)
    return tip | {"brick": mark.lane.brick} | mark.details


def _cell_tip(timeline: Timeline, begin: int, cell: Cell) -> dict[str, str]:
    since = timeline.seconds(begin)
    tip = {"title": count(cell.count, "mark"), "from": f"{since:.3f} s" if timeline.is_timed else f"line {since:.0f}"}
    tip["during"] = extent(timeline, timeline.bin_ns)
    tip |= {outcome.value: str(number) for outcome, number in cell.troubles.items()}
    if cell.fastest_ns is not None and cell.slowest_ns is not None:
        tip["fastest answer"] = exact(cell.fastest_ns)
        tip["slowest answer"] = f"{exact(cell.slowest_ns)}, to the command in packet {cell.slowest}"
    return tip


def _milliseconds(nanoseconds: int) -> float:
    return max(round(nanoseconds / 1e6, 6), FIRST_MS)


def _rounded(seconds: float) -> float:
    return round(seconds, 9)
