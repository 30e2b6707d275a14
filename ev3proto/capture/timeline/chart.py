"""The chart: one Vega-Lite specification, from which page, SVG and PNG are made.

It is written as the JSON that it is. Libraries that write it name and share views in ways of their own, which is in the
way of one time axis for all of them.
"""

from __future__ import annotations

from typing import Any

from ev3proto.capture.timeline.layout import KINDS_WIDTH, LATENCY_MARGIN, SHADES, WIDTH, Drawing
from ev3proto.capture.timeline.marks import MarkState

VERSION = "6.1"
"""The version of Vega-Lite that it is written in."""

# Colours of Okabe and Ito, which everybody can distinguish, darker where they are thin lines on white. The
# symbols differ, too.
COLOURS = {
    MarkState.ANSWERED: "#0072B2",
    MarkState.SILENT: "#3A9BD9",
    MarkState.ERROR: "#D00000",
    MarkState.UNANSWERED: "#C77700",
    MarkState.ORPHAN: "#B0578D",
    MarkState.MOVED: "#009E73",
    MarkState.CUT_SHORT: "#C77700",
    MarkState.ANNOUNCED: "#777777",
    MarkState.FAULTY: "#000000",
    MarkState.SKIPPED: "#000000",
}

_RING = "M0,-1L1,0L0,1L-1,0ZM0,-.5L-.5,0L0,.5L.5,0Z"
_CROSS = "M-.9,-.55L-.55,-.9L0,-.35L.55,-.9L.9,-.55L.35,0L.9,.55L.55,.9L0,.35L-.55,.9L-.9,.55L-.35,0Z"
_TICK = "M-.22,-1L.22,-1L.22,1L-.22,1Z"
_FRAME = "M-1,-.7L1,-.7L1,.7L-1,.7ZM-.7,-.4L-.7,.4L.7,.4L.7,-.4Z"

SYMBOLS = {
    MarkState.ANSWERED: "circle",
    MarkState.SILENT: _TICK,
    MarkState.ERROR: _CROSS,
    MarkState.UNANSWERED: _RING,
    MarkState.ORPHAN: "triangle-left",
    MarkState.MOVED: "square",
    MarkState.CUT_SHORT: _FRAME,
    MarkState.ANNOUNCED: "diamond",
    MarkState.FAULTY: "triangle-up",
    MarkState.SKIPPED: "cross",
}

SHADE_COLOURS = ("#C6DBEF", "#9ECAE1", "#6BAED6", "#3182BD", "#08519C")

ROW_HEIGHT = 21
LATENCY_HEIGHT = 170
TROUBLE_SIZE = 140

Json = dict[str, Any]

_FONT = "Helvetica, Arial, 'Liberation Sans', sans-serif"
_TIP = {"expr": "datum.tip"}
_MARGIN = {"expr": "margin"}


def specification(picture: Drawing) -> Json:
    """The specification of a picture, with all of its data."""
    panels = [_Panel(picture, number) for number in range(len(picture.panels))]
    views = [_legend(picture), *(panel.view() for panel in panels)]
    timed = [panel.name for panel in panels]
    if picture.latency_ms is not None:
        views.append(_latency(picture))
        timed.append("latency")
    return {
        "$schema": f"https://vega.github.io/schema/vega-lite/v{VERSION}.json",
        "title": {
            "text": picture.title,
            "subtitle": picture.lines,
            "anchor": "start",
            "frame": "bounds",
            "offset": 14,
            "subtitlePadding": 5,
        },
        "params": [
            # One time for all views, whichever is dragged.
            {"name": "time", "select": {"type": "interval", "encodings": ["x"]}, "bind": "scales", "views": timed},
            {
                "name": "picked",
                "select": {"type": "point", "fields": ["o"], "toggle": "true"},
                "views": ["legend"],
            },
            # Pixels, which the page sets to what the window has room for: left of the rows, of that for the names of
            # kinds, and for what is drawn over time.
            {"name": "margin", "value": picture.margin},
            {"name": "kinds", "value": KINDS_WIDTH},
            {"name": "room", "value": WIDTH},
        ],
        "vconcat": views,
        "spacing": 20,
        "padding": 16,
        "background": "white",
        "config": {
            "font": _FONT,
            "aria": False,
            "view": {"stroke": "#BBBBBB"},
            "title": {"fontSize": 17, "subtitleFontSize": 12, "subtitleColor": "#444444", "subtitleLineHeight": 17},
            "axis": {"labelFontSize": 11, "titleFontSize": 11, "titleFontWeight": "normal", "gridColor": "#E3E3E3"},
        },
        "datasets": _datasets(picture),
    }


def _datasets(picture: Drawing) -> Json:
    found: Json = {
        "marks": picture.marks,
        "cells": picture.cells,
        "latencies": picture.latencies,
        "legend": picture.legend,
    }
    for number, panel in enumerate(picture.panels):
        found |= {f"bands{number}": panel.bands, f"kinds{number}": panel.kinds}
    return found


def _layer(data: str, mark: Json, encoding: Json, where: str | None = None, name: str | None = None) -> Json:
    layer: Json = {"data": {"name": data}, "mark": mark, "encoding": encoding}
    if where is not None:
        layer["transform"] = [{"filter": where}]
    return layer | ({} if name is None else {"name": name})


def _heading(text: str, aside: str) -> Json:
    style = {"anchor": "start", "frame": "bounds", "fontSize": 14, "subtitleFontSize": 12}
    return {"text": text, "subtitle": aside, **style}


def _by_outcome(values: dict[MarkState, str]) -> Json:
    scale = {"domain": [outcome.value for outcome in MarkState], "range": [values[outcome] for outcome in MarkState]}
    return {"field": "o", "type": "nominal", "scale": scale, "legend": None}


_COLOUR = _by_outcome(COLOURS)
_SHAPE = _by_outcome(SYMBOLS)
_SHADE = {
    "field": "s",
    "type": "ordinal",
    "scale": {"domain": list(range(1, SHADES + 1)), "range": list(SHADE_COLOURS)},
    "legend": None,
}
_INDEPENDENT = {"scale": {"color": "independent"}}


def _faded(full: float = 1.0) -> Json:
    """Opaque, unless words in the legend were clicked that are not about it."""
    return {"condition": {"param": "picked", "value": full}, "value": 0.1}


_SYMBOL = {"type": "point", "filled": True, "clip": True, "tooltip": _TIP}


def _symbol(picture: Drawing) -> Json:
    """How symbols look. Trouble is never small, and has a white rim that lifts it from what is around it."""
    return {
        "color": _COLOUR,
        "shape": _SHAPE,
        "opacity": _faded(0.9),
        "size": {"condition": {"test": "datum.bad", "value": TROUBLE_SIZE}, "value": picture.symbol_size},
        "stroke": {"condition": {"test": "datum.bad", "value": "white"}, "value": None},
        "strokeWidth": {"condition": {"test": "datum.bad", "value": 1.2}, "value": 0},
    }


def _time(picture: Drawing, field: str, *, is_titled: bool) -> Json:
    title, label = (_SECONDS, "datum.label + ' s'") if picture.is_timed else (_LINES, "datum.label")
    return {
        "field": field,
        "type": "quantitative",
        "scale": {"domain": list(picture.domain), "nice": False, "zero": False},
        "axis": {
            "title": title if is_titled else None,
            "tickCount": 10,
            "labelExpr": label,
            "labelOverlap": True,
        },
    }


_SECONDS = "seconds since the first message"
_LINES = "order: the lines of the text, which has no times"


def _legend(picture: Drawing) -> Json:
    x, y = ({"field": name, "type": "quantitative", "scale": None, "axis": None} for name in ("x", "y"))
    layers = [
        _layer(
            "legend",
            {"type": "point", "filled": True, "size": 75, "opacity": 1},
            {"x": x, "y": y, "color": _COLOUR, "shape": _SHAPE},
            "isValid(datum.o)",
        ),
        _layer(
            "legend",
            {"type": "text", "align": "left", "dx": 10, "fontSize": 12},
            {"x": x, "y": y, "text": {"field": "text"}, "opacity": _faded()},
        ),
        # What is clicked: symbol and words together.
        _layer(
            "legend",
            {"type": "rect", "opacity": 0, "height": 20, "cursor": "pointer"},
            {"x": x, "x2": {"field": "x2"}, "y": y},
            "isValid(datum.o)",
            "legend",
        ),
    ]
    if picture.cells:
        square = {"type": "point", "shape": "square", "filled": True, "size": 130, "opacity": 1}
        layers.append(_layer("legend", square, {"x": x, "y": y, "color": _SHADE}, "isValid(datum.s)"))
    return {
        "layer": layers,
        "width": WIDTH,
        "height": picture.legend_height,
        "view": {"stroke": None},
        "resolve": _INDEPENDENT,
    }


class _Panel:
    """The rows of one brick."""

    def __init__(self, picture: Drawing, number: int) -> None:
        self.name = f"rows{number}"
        self._picture = picture
        self._number = number
        self._panel = picture.panels[number]
        is_last = picture.latency_ms is None and number == len(picture.panels) - 1
        self._x, self._x_of_words = (_time(picture, field, is_titled=is_last) for field in ("t", "x"))
        self._y = {
            "field": "row",
            "type": "nominal",
            "scale": {"domain": self._panel.rows, "padding": 0},
            "axis": {
                "title": None,
                "ticks": False,
                "domain": False,
                "labelExpr": "slice(datum.value, indexof(datum.value, '/') + 1)",
                "labelLimit": {"expr": "margin - kinds"},
                "labelPadding": 8,
                "minExtent": _MARGIN,
                "maxExtent": _MARGIN,
            },
        }

    def view(self) -> Json:
        """The view, the time of which can be dragged."""
        layers = [*self._background(), *self._cells(), self._bars(), *self._words(), self._symbols()]
        return {
            "title": _heading(self._panel.title, self._panel.aside),
            "layer": layers,
            "width": WIDTH,
            "height": ROW_HEIGHT * len(self._panel.rows),
            "resolve": _INDEPENDENT,
        }

    def _background(self) -> list[Json]:
        # See-through, because the grid is behind it.
        yes_or_no = {"condition": {"test": "datum.shaded", "value": 0.04}, "value": 0}
        return [
            _layer(
                f"bands{self._number}",
                {"type": "rect", "color": "black"},
                {"y": self._y, "opacity": yes_or_no},
            ),
            _layer(
                f"kinds{self._number}",
                # Left of the view, where it would be clipped off with everything that can be dragged.
                {
                    "type": "text",
                    "align": "left",
                    "fontSize": 12,
                    "fontWeight": "bold",
                    "color": "#444444",
                    "clip": False,
                },
                {
                    "x": {"value": {"expr": "-margin"}},
                    "y": self._y,
                    "text": {"field": "kind"},
                    "opacity": {"value": {"expr": "kinds ? 1 : 0"}},
                },
            ),
        ]

    def _cells(self) -> list[Json]:
        if not self._picture.cells:
            return []
        mark = {"type": "rect", "clip": True, "height": {"band": 0.84}, "tooltip": _TIP}
        encoding = {"x": self._x, "x2": {"field": "e"}, "y": self._y, "color": _SHADE, "opacity": _faded()}
        return [_layer("cells", mark, encoding, self._ours())]

    def _bars(self) -> Json:
        # The outline keeps a bar visible where it is less than a pixel wide.
        mark = {
            "type": "bar",
            "clip": True,
            "height": {"band": 0.7},
            "strokeWidth": 1,
            "fillOpacity": 0.25,
            "tooltip": _TIP,
        }
        encoding = {
            "x": self._x,
            "x2": {"field": "e"},
            "y": self._y,
            "fill": _COLOUR,
            "stroke": _COLOUR,
            "opacity": _faded(),
        }
        # The name is of a layer that has times, or time cannot be dragged.
        return _layer("marks", mark, encoding, self._ours("isValid(datum.e)"), self.name)

    def _words(self) -> list[Json]:
        style = {"type": "text", "fontSize": 11, "color": "#222222", "clip": True, "tooltip": _TIP}
        encoding = {"x": self._x_of_words, "y": self._y, "text": {"field": "l"}, "opacity": _faded()}
        return [
            _layer("marks", style | place, encoding, self._ours("isValid(datum.l)", "datum.w <= room", where))
            for place, where in (
                ({"align": "left", "dx": 8}, "!datum.back"),
                ({"align": "right", "dx": -8}, "datum.back"),
            )
        ]

    def _symbols(self) -> Json:
        encoding = {"x": self._x, "y": self._y, **_symbol(self._picture)}
        return _layer("marks", _SYMBOL, encoding, self._ours("!datum.f"))

    def _ours(self, *conditions: str) -> str:
        return " && ".join((f"datum.p === {self._number}", *conditions))


def _milliseconds(picture: Drawing) -> Json:
    """The axis of the latencies, which are there."""
    assert picture.latency_ms is not None
    low, high = picture.latency_ms
    scale: Json = {"domain": [0, high * 1.1]}
    axis: Json = {
        "title": None,
        "labelOverlap": False,
        "tickCount": 6,
        "format": "~g",
        "labelExpr": "datum.label ? datum.label + ' ms' : ''",
        "minExtent": _MARGIN,
        "maxExtent": _MARGIN,
    }
    if picture.is_logarithmic:
        scale = {"type": "log", "domain": [low / LATENCY_MARGIN, high * LATENCY_MARGIN], "nice": False}
        axis["values"] = picture.latency_ticks
    return {"field": "ms", "type": "quantitative", "scale": scale, "axis": axis}


def _latency(picture: Drawing) -> Json:
    y = _milliseconds(picture)
    x = _time(picture, "t", is_titled=True)
    layers = [
        _layer(
            "marks",
            _SYMBOL,
            {"x": x, "y": y, **_symbol(picture)},
            "isValid(datum.ms)",
            "latency",
        )
    ]
    if picture.latencies:
        span = {"type": "rule", "clip": True, "color": SHADE_COLOURS[1], "strokeWidth": 1.5}
        slowest = _SYMBOL | {"size": 22, "color": SHADE_COLOURS[-1], "opacity": 1}
        layers[:0] = [
            _layer("latencies", span, {"x": x, "y": y, "y2": {"field": "low"}}),
            _layer("latencies", slowest, {"x": x, "y": y}),
        ]
    scaled = "logarithmic scale" if picture.is_logarithmic else "linear scale"
    return {
        "title": _heading("How long a brick took to answer", f"milliseconds from command to reply, {scaled}"),
        "layer": layers,
        "width": WIDTH,
        "height": LATENCY_HEIGHT,
        "resolve": _INDEPENDENT,
    }
