"""The chart: a Vega-Lite specification with its data, from which page, SVG and PNG are made."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from typing import Any

from ev3proto.capture.record import NANOSECONDS
from ev3proto.capture.timeline.collecting import clock
from ev3proto.capture.timeline.marks import OTHERS, TROUBLES, Cell, Lane, LaneKind, Mark, MarkState, Tally, Timeline

VERSION = "6.1"
"""The version of Vega-Lite."""

WIDTH = 960
"""Default width of the time axis, in pixels."""

KINDS_WIDTH = 124
"""Pixels for the names of kinds, at the left edge."""

MOST_ROWS = 10
"""Maximum number of rows for one kind of one brick; the rarest subjects share the last one."""

MOST_FILE_ROWS = 5
"""Maximum number of rows for files that overlap in time, or whose paths would."""

FIRST_MS = 0.001
"""The shortest latency that is drawn, in milliseconds: a logarithmic axis has no 0."""

_LETTER, _CAPITAL, _SYMBOL = 6.0, 7.8, 12
"""Pixels of a letter, of a capital, of a symbol with the space after it."""

_LOGARITHMIC = 20
"""The axis is logarithmic if the longest latency is at least this multiple of the shortest."""

# Colours of Okabe and Ito, which all readers can distinguish, darker for thin lines on white; and symbols.
_LOOKS = {
    MarkState.ANSWERED: ("#0072B2", "circle"),
    MarkState.SILENT: ("#3A9BD9", "M-.22,-1L.22,-1L.22,1L-.22,1Z"),
    MarkState.ERROR: (
        "#D00000",
        "M-.9,-.55L-.55,-.9L0,-.35L.55,-.9L.9,-.55L.35,0L.9,.55L.55,.9L0,.35L-.55,.9L-.9,.55L-.35,0Z",
    ),
    MarkState.UNANSWERED: ("#C77700", "M0,-1L1,0L0,1L-1,0ZM0,-.5L-.5,0L0,.5L.5,0Z"),
    MarkState.ORPHAN: ("#B0578D", "triangle-left"),
    MarkState.MOVED: ("#009E73", "square"),
    MarkState.CUT_SHORT: ("#C77700", "M-1,-.7L1,-.7L1,.7L-1,.7ZM-.7,-.4L-.7,.4L.7,.4L.7,-.4Z"),
    MarkState.ANNOUNCED: ("#777777", "diamond"),
    MarkState.FAULTY: ("#000000", "triangle-up"),
    MarkState.SKIPPED: ("#000000", "cross"),
}

Json = dict[str, Any]


def specification(timeline: Timeline, title: str = "") -> Json:
    """Returns the specification of a picture with all of its data.

    Its parameters are widths in pixels that a page fits to its window: `room` of the time axis, `margin` of everything
    left of it, `kinds` of the names of kinds within the margin.
    """
    chart = _Chart(timeline)
    heading = {"title": _heading(title, summary(timeline), 17)} if title else {}
    dragged, clicked = {"type": "interval", "encodings": ["x"]}, {"type": "point", "fields": ["o"]}
    return heading | {
        "$schema": f"https://vega.github.io/schema/vega-lite/v{VERSION}.json",
        "params": [
            # All views show the same time, whichever is dragged.
            {"name": "time", "select": dragged, "bind": "scales", "views": chart.timed},
            {"name": "picked", "select": clicked, "bind": "legend", "views": chart.timed[:1]},
            {"name": "margin", "value": round(chart.margin)},
            {"name": "kinds", "value": KINDS_WIDTH},
            {"name": "room", "value": WIDTH},
        ],
        "vconcat": chart.views,
        "resolve": {"scale": {"color": "shared", "shape": "shared"}},
        "spacing": 20,
        "padding": 16,
        "background": "white",
        "config": {
            "font": "Helvetica, Arial, 'Liberation Sans', sans-serif",
            "aria": False,
            "view": {"stroke": "#BBBBBB"},
            "axis": {"labelFontSize": 11, "titleFontSize": 11, "titleFontWeight": "normal", "gridColor": "#E3E3E3"},
            "axisY": {"minExtent": {"expr": "margin"}, "maxExtent": {"expr": "margin"}},
        },
        "datasets": chart.datasets,
    }


def summary(timeline: Timeline) -> list[str]:
    """Returns the lines under the title: time, duration, counts of messages and problems, and what is not drawn."""
    begin, length = timeline.origin_ns + round(timeline.begin * NANOSECONDS), timeline.end - timeline.begin
    when = f"from {clock(begin)}, {duration(length)}" if timeline.is_timed else "in their order, without times"
    troubles = (
        (MarkState.ERROR, "answered with an error", "answered with an error"),
        (MarkState.UNANSWERED, "never answered", "never answered"),
        (MarkState.FAULTY, "faulty frame", "faulty frames"),
        (MarkState.SKIPPED, "gap with bytes skipped", "gaps with bytes skipped"),
        (MarkState.CUT_SHORT, "file not moved whole", "files not moved whole"),
    )
    how = [_count(n, one, many) for outcome, one, many in troubles if (n := timeline.outcomes[outcome])]
    lines = [f"{when}: {', '.join((_count(timeline.messages, 'message'), *how))}"]
    if timeline.bin_width:
        lines.append(
            f"Too many messages to mark individually; darker means more in {_extent(timeline, timeline.bin_width)}."
            f" Problems are marked{'; the slowest answer of each interval is below' if timeline.is_timed else ''}."
        )
    else:
        lines.append("A mark shows when a command was sent, and its bar reaches to the reply.")
    if timeline.unshown:
        lines.append(f"{_count(timeline.unshown, 'mark')} of errors and files omitted: there are too many.")
    return lines


def duration(seconds: float) -> str:
    """Returns `0.35 ms`, `41 ms`, `1.23 s`: three digits."""
    number, unit = (seconds * 1000, "ms") if seconds < 1 else (seconds, "s")
    return f"{number:,.0f} {unit}" if number >= 100 else f"{number:.3g} {unit}"


def _extent(timeline: Timeline, seconds: float) -> str:
    return duration(seconds) if timeline.is_timed else _count(-int(-seconds // 1), "line")


def _count(number: int, one: str, many: str | None = None) -> str:
    return f"{number:,} {one if number == 1 else many or f'{one}s'}"


class _Chart:
    """The views and their data: `p` panel, `row`, `t` and `e` begin and end, `o` outcome, `l` label and its place."""

    def __init__(self, timeline: Timeline) -> None:
        self._timeline = timeline
        # A beacon long before the first message would leave the picture empty.
        said = [mark.begin for mark in timeline.marks if mark.outcome is not MarkState.ANNOUNCED]
        begin = max(timeline.begin, min(said, default=timeline.begin))
        around = 0.015 * (timeline.end - begin) or 0.5
        self.domain = round(begin - around, 9), round(timeline.end + around, 9)
        self._second = WIDTH / (self.domain[1] - self.domain[0])  # in pixels
        self.datasets: dict[str, list[Json]] = {"marks": [], "cells": []}
        self.views: list[Json] = []
        self.timed: list[str] = []
        self.margin: float = KINDS_WIDTH
        homes = _homes(timeline.bricks)
        for brick, tally in timeline.bricks.items():
            if homes[brick] == brick:
                self._panel(brick, tally, {name for name, home in homes.items() if home == brick})
        # Problems are drawn over the rest.
        self.datasets["marks"].sort(key=lambda datum: "bad" in datum)
        self.views += self._latency()
        title = (
            "seconds since the first message"
            if timeline.is_timed
            else "order: the lines of the text, which has no times"
        )
        for layer in self.views[-1]["layer"]:
            if "axis" in layer["encoding"].get("x", {}):
                layer["encoding"]["x"]["axis"]["title"] = title

    # Rows

    def _panel(self, brick: str, tally: Tally, bricks: set[str]) -> None:
        number = len(self.views)
        marks = [mark for mark in self._timeline.marks if mark.lane.brick in bricks]
        lanes = self._counted(bricks) or Counter(mark.lane for mark in marks)
        rows: list[str] = []
        bands: list[Json] = []
        data: dict[str, list[Json]] = {}
        row_of: dict[Lane, str] = {}
        files = [mark for mark in marks if mark.lane.kind is LaneKind.FILES]
        for kind in LaneKind:
            start = len(rows)
            if kind is LaneKind.FILES:
                data |= self._files(files, number, rows)
            else:
                self._rows({lane: n for lane, n in lanes.items() if lane.kind is kind}, rows, row_of)
            shaded = len({band["kind"] for band in bands}) % 2 == 0
            bands += [
                {"row": row, "kind": kind.value, "first": row == rows[start], "shaded": shaded} for row in rows[start:]
            ]
        for mark in marks:
            if mark.lane.kind is not LaneKind.FILES:
                data.setdefault(row_of[mark.lane], []).append(self._datum(mark, number, row_of[mark.lane]))
        for row in data.values():
            self._place_labels(row)
            self.datasets["marks"] += row
        self._cells(number, row_of)
        self.datasets[f"bands{number}"] = bands
        longest = max((len(row.partition("/")[2]) for row in rows), default=0)
        self.margin = max(self.margin, KINDS_WIDTH + min(_CAPITAL * longest, 300))
        self.views.append(self._view(number, rows) | {"title": _heading(brick, [_aside(tally)])})

    def _counted(self, bricks: set[str]) -> Counter[Lane]:
        """Returns the numbers of marks that are only counted, by lane."""
        counts: Counter[Lane] = Counter()
        for (lane, _), cell in self._timeline.cells.items():
            if lane.brick in bricks:
                counts[lane] += cell.count
        return counts

    def _rows(self, lanes: Mapping[Lane, int], rows: list[str], row_of: dict[Lane, str]) -> None:
        subjects: Counter[str] = Counter()
        for lane, number in lanes.items():
            subjects[lane.subject] += number
        most = MOST_ROWS if len(subjects) <= MOST_ROWS else MOST_ROWS - 1
        own = {subject for subject, _ in subjects.most_common(most)} - {OTHERS}
        rest = len(subjects) - len(own)
        names = [subject for subject in subjects if subject in own]
        if rest:
            names.append(f"{rest} others" if rest > 1 else OTHERS)
        found = {name: f"{number}/{name}" for number, name in enumerate(names, len(rows))}
        rows += found.values()
        row_of |= {lane: found[lane.subject if lane.subject in own else names[-1]] for lane in lanes}

    def _files(self, marks: Iterable[Mark], panel: int, rows: list[str]) -> dict[str, list[Json]]:
        """Distributes files over rows, so that neither they nor their paths overlap while there are rows."""
        found: dict[str, list[Json]] = {}
        ends: dict[str, float] = {}
        for mark in marks:
            width = self._width(mark.label)
            begin, end = mark.begin, mark.end or mark.begin
            if end + width > self.domain[1]:
                begin -= width
            elif begin + width > end:
                end += width
            row = next((row for row in ends if ends[row] <= begin), None)
            if row is None and len(ends) < MOST_FILE_ROWS:
                row = f"{len(rows)}/"
                rows.append(row)
            row = row or min(ends, key=ends.__getitem__)
            ends[row] = max(ends.get(row, end), end)
            found.setdefault(row, []).append(self._datum(mark, panel, row) | {"f": True})
        return found

    def _datum(self, mark: Mark, panel: int, row: str) -> Json:
        datum: Json = {"p": panel, "row": row, "t": round(mark.begin, 9), "o": mark.outcome.value, "tip": mark.tip}
        if mark.outcome in TROUBLES:
            datum["bad"] = True
        if mark.end is not None:
            datum["e"] = round(mark.end, 9)
        if mark.latency is not None:
            datum["ms"] = _milliseconds(mark.latency)
        # Labels on the shaded counts would be illegible.
        return datum | ({"l": mark.label} if mark.label and not self._timeline.cells else {})

    def _width(self, words: str) -> float:
        """Returns the width of a label with the space around it, in seconds of a picture of WIDTH pixels."""
        return (1.5 * _SYMBOL + _LETTER * len(words)) / self._second

    def _place_labels(self, row: list[Json]) -> None:
        """Places labels in the bar, after it, or at the right edge before it; drops those without room.

        `x` is the position, `back` means that the text ends there, `w` is the minimum width of the time axis that
        leaves room for it: a narrow window omits some labels.
        """
        low, high = self.domain
        before = taken = low
        beside = 0.0
        for datum, after in zip(row, [*(each["t"] for each in row[1:]), high], strict=True):
            begin = float(datum["t"])
            end = float(datum.get("e", begin))
            words = datum.pop("l", "")
            width = self._width(words)
            x = begin if begin + width <= end else end
            is_back = x + width > high
            place, room, needed = (begin, begin - before, width + beside) if is_back else (x, after - x, width)
            is_placed = bool(words) and room >= width and (not is_back or begin - width >= taken)
            before, beside = max(before, end), 0.0
            if is_placed:
                beside = 0.0 if is_back else width
                least = min(round(WIDTH * needed / room), WIDTH)
                datum |= {"l": words, "x": place, "back": is_back, "w": least}
            taken = max(taken, end + _SYMBOL / 2 / self._second, x + beside)

    def _cells(self, panel: int, row_of: dict[Lane, str]) -> None:
        timeline = self._timeline
        merged: dict[tuple[str, float], Cell] = {}
        for (lane, begin), cell in timeline.cells.items():
            if lane in row_of:
                merged.setdefault((row_of[lane], begin), Cell()).merge(cell)
        for (row, begin), cell in merged.items():
            end = round(begin + timeline.bin_width, 9)
            tip = {"title": _count(cell.count, "mark")}
            tip["from"] = f"{begin:.3f} s" if timeline.is_timed else f"line {begin:.0f}"
            tip["during"] = _extent(timeline, timeline.bin_width)
            tip |= {outcome.value: str(number) for outcome, number in cell.troubles.items()}
            datum: Json = {"p": panel, "row": row, "t": begin, "e": end, "n": cell.count, "tip": tip}
            if cell.latencies is not None:
                low, high = cell.latencies
                tip["fastest answer"] = f"{low * 1000:,.3f} ms"
                tip["slowest answer"] = f"{high * 1000:,.3f} ms, to the command in packet {cell.slowest}"
                datum |= {"low": _milliseconds(low), "ms": _milliseconds(high)}
            self.datasets["cells"].append(datum)

    # Views

    def _view(self, number: int, rows: list[str]) -> Json:
        self.timed.append(f"rows{number}")
        label = "slice(datum.value, indexof(datum.value, '/') + 1)"
        axis: Json = {"title": None, "ticks": False, "domain": False, "labelExpr": label, "labelPadding": 8}
        axis["labelLimit"] = {"expr": "margin - kinds"}
        y = {"field": "row", "type": "nominal", "scale": {"domain": rows, "padding": 0}, "axis": axis}
        x, bands, ours = self._x("t"), f"bands{number}", f"datum.p === {number}"
        band = {"type": "rect", "color": "black"}  # see-through, because the grid is behind it
        shaded = {"condition": {"test": "datum.shaded", "value": 0.04}, "value": 0}
        # It is left of the view, so it must not be clipped like everything that can be dragged.
        kind = {
            "type": "text",
            "align": "left",
            "fontSize": 12,
            "fontWeight": "bold",
            "color": "#444444",
            "clip": False,
        }
        shown = {"value": {"expr": "kinds ? 1 : 0"}}
        kinds = {"x": {"value": {"expr": "-margin"}}, "text": {"field": "kind"}, "opacity": shown}
        # The outline keeps a bar visible where it is less than a pixel wide.
        bar = {"type": "bar", "height": {"band": 0.7}, "strokeWidth": 1, "fillOpacity": 0.25}
        bar["stroke"] = {"expr": "scale('color', datum.o)"}
        symbol = self._symbol()
        bars = {"x": x, "x2": {"field": "e"}, "y": y, "color": symbol["color"]}
        words = {
            "type": "text",
            "align": {"expr": "datum.back ? 'right' : 'left'"},
            "dx": {"expr": f"datum.back ? {-_SYMBOL + 3} : {_SYMBOL - 3}"},
            "fontSize": 11,
            "color": "#222222",
        }
        layers = [
            _layer(bands, band, {"y": y, "opacity": shaded}),
            _layer(bands, kind, {"y": y, **kinds}, "datum.first"),
            *([self._heat(x, y, ours)] if self._timeline.cells else []),
            # The parameters refer to the first layer with times and colours by its name.
            _timed("marks", bar, bars, f"{ours} && isValid(datum.e)") | {"name": f"rows{number}"},
            _timed("marks", words, {"x": self._x("x"), "y": y, "text": {"field": "l"}}, f"{ours} && datum.w <= room"),
            _timed("marks", _POINT, {"x": x, "y": y, **symbol}, f"{ours} && !datum.f"),
        ]
        return {"layer": layers, "width": WIDTH, "height": 21 * len(rows)}

    def _heat(self, x: Json, y: Json, where: str) -> Json:
        most = max(cell["n"] for cell in self.datasets["cells"])
        scale = {"type": "log", "scheme": "blues", "domain": [1, max(most, 2)]}
        title = f"marks in {_extent(self._timeline, self._timeline.bin_width)}"
        fill = {"field": "n", "type": "quantitative", "scale": scale, "legend": {"orient": "top", "title": title}}
        rect = {"type": "rect", "height": {"band": 0.84}}
        return _timed("cells", rect, {"x": x, "x2": {"field": "e"}, "y": y, "fill": fill}, where)

    def _latency(self) -> list[Json]:
        data = (datum for data in self.datasets.values() for datum in data)
        found = [datum[name] for datum in data for name in ("low", "ms") if name in datum]
        if not found:
            return []
        self.timed.append("latency")
        is_logarithmic = max(found) >= _LOGARITHMIC * min(found)
        scale = (
            {"type": "log", "domain": [min(found) / 1.5, max(found) * 1.5]}
            if is_logarithmic
            else {"domainMax": max(found) * 1.1}
        )
        axis: Json = {
            "title": None,
            "tickCount": 6,
            "labelExpr": "datum.label ? datum.label + ' ms' : ''",
            "format": "~g",
        }
        # A logarithmic axis has ticks between those that have a label.
        where_labelled = {"condition": {"test": "datum.label", "value": 1}, "value": 0}
        axis |= {"gridOpacity": where_labelled, "tickOpacity": where_labelled}
        y = {"field": "ms", "type": "quantitative", "scale": scale, "axis": axis}
        x = self._x("t")
        rule = {"type": "rule", "color": "#9ECAE1", "strokeWidth": 1.5}
        slowest = _POINT | {"size": 22, "color": "#08519C"}
        layers = [
            _timed("cells", rule, {"x": x, "y": y, "y2": {"field": "low"}}, "isValid(datum.ms)"),
            _timed("cells", slowest, {"x": x, "y": y}, "isValid(datum.ms)"),
            _timed("marks", _POINT, {"x": x, "y": y, **self._symbol()}, "isValid(datum.ms)") | {"name": "latency"},
        ]
        aside = f"milliseconds from command to reply, {'logarithmic' if is_logarithmic else 'linear'} scale"
        heading = _heading("How long a brick took to answer", [aside])
        return [{"title": heading, "layer": layers, "width": WIDTH, "height": 170}]

    def _x(self, field: str) -> Json:
        axis: Json = {"title": None, "tickCount": 10, "labelOverlap": True}
        if self._timeline.is_timed:
            axis["labelExpr"] = "datum.label + ' s'"
        scale = {"domain": list(self.domain), "nice": False, "zero": False}
        return {"field": field, "type": "quantitative", "scale": scale, "axis": axis}

    def _symbol(self) -> Json:
        """Returns the look of symbols: smaller if there are many; problems stay large and have a white rim."""
        many = len(self.datasets["marks"])
        outcomes = self._timeline.outcomes
        words = {outcome.value: f"{outcome.value}: {outcomes[outcome]:,}" for outcome in MarkState}
        shown = [outcome.value for outcome in MarkState if outcomes[outcome]]
        legend = {"values": shown, "labelExpr": f"({words})[datum.label]", **_LEGEND}
        return {
            "color": _by_outcome(0) | {"legend": legend},
            "shape": _by_outcome(1),
            "size": {
                "condition": {"test": "datum.bad", "value": 140},
                "value": 75 if many <= 300 else 40 if many <= 3000 else 20,
            },
            "stroke": {"condition": {"test": "datum.bad", "value": "white"}, "value": None},
            "strokeWidth": {"condition": {"test": "datum.bad", "value": 1.2}, "value": 0},
        }


def _by_outcome(look: int) -> Json:
    scale = {"domain": [outcome.value for outcome in _LOOKS], "range": [looks[look] for looks in _LOOKS.values()]}
    return {"field": "o", "type": "nominal", "scale": scale, "legend": None}


_POINT = {"type": "point", "filled": True}
_LEGEND = {
    "orient": "top",
    "title": None,
    "symbolSize": 75,
    "labelFontSize": 12,
    "labelLimit": 0,
    "columns": {"expr": "max(1, floor(room / 190))"},
}


def _aside(tally: Tally) -> str:
    said = [_count(tally.messages, "message")]
    latency = tally.latencies.percentiles()
    if latency is not None:
        said += [f"median answer {duration(latency.median)}", f"slowest {duration(latency.max)}"]
    return ", ".join(said)


def _layer(data: str, mark: Json, encoding: Json, where: str | None = None) -> Json:
    layer: Json = {"data": {"name": data}, "mark": mark, "encoding": encoding}
    return layer | ({"transform": [{"filter": where}]} if where else {})


def _timed(data: str, mark: Json, encoding: Json, where: str) -> Json:
    """Returns a layer that moves with the time, has tooltips, and fades when others are selected in the legend."""
    opacity = {"opacity": {"condition": {"param": "picked", "value": 1.0}, "value": 0.1}}
    return _layer(data, mark | {"clip": True, "tooltip": {"expr": "datum.tip"}}, encoding | opacity, where)


def _heading(text: str, lines: list[str], size: int = 14) -> Json:
    return {
        "text": text,
        "subtitle": lines,
        "anchor": "start",
        "frame": "bounds",
        "fontSize": size,
        "subtitleFontSize": 12,
        "subtitleColor": "#444444",
        "subtitleLineHeight": 17,
        "limit": {"expr": "room + margin"},
        "offset": 14 if size > 14 else 4,
    }


def _homes(bricks: dict[str, Tally]) -> dict[str, str]:
    """Returns the panel of each brick: a beacon has another port than the dialogue, but is from the same brick."""
    homes = {brick: brick for brick in bricks}
    for brick, tally in bricks.items():
        same = [other for other in bricks if bricks[other].messages and _host(other) == _host(brick)]
        if not tally.messages and len(same) == 1:
            homes[brick] = same[0]
    return homes


def _host(brick: str) -> str:
    host, colon, port = brick.rpartition(":")
    return host if colon and port.isdecimal() and brick.startswith("WiFi") else brick


def _milliseconds(seconds: float) -> float:
    return max(round(seconds * 1000, 6), FIRST_MS)
