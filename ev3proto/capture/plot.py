"""A chart of values over time: a panel for each unit, a line for each value."""

from __future__ import annotations

from typing import Any

from ev3proto.capture.series import Series
from ev3proto.capture.timeline.chart_files import MOST_TITLE, Form, picture
from ev3proto.capture.timeline.collecting import clean

# Okabe and Ito's, the yellow darker, and three more.
_COLOURS = [
    "#0072B2",
    "#D55E00",
    "#009E73",
    "#CC79A7",
    "#56B4E9",
    "#A58A00",
    "#7B4FB5",
    "#8C564B",
    "#4D4D4D",
    "#E69F00",
]
_DASHES = ([1, 0], [6, 3], [2, 2], [8, 3, 2, 3], [12, 4])
"""Ten colours, and then the same ones dashed."""


def draw(found: Series, suffix: str, title: str, start_ns: int) -> bytes:
    """Returns an SVG or PNG of the numbers among values. Raises ValueError and MissingLibraryError."""
    if suffix not in (".svg", ".png"):
        raise ValueError(f"unknown suffix of a plot: {suffix or 'none'}; expected .svg or .png")
    return picture(specification(found, clean(title, MOST_TITLE), start_ns), Form(suffix))


def specification(found: Series, title: str, start_ns: int) -> dict[str, Any]:
    """Returns the picture in Vega-Lite: one panel for each unit, over the time in seconds.

    If a reply has no time, all are drawn over their order instead: the first reply is 1.
    """
    is_timed = all(row.is_timed for row in found.rows)
    along = "seconds since the first message" if is_timed else "order"
    panels: dict[str | None, list[dict[str, Any]]] = {}
    for number, row in enumerate(found.rows, 1):
        at = (row.time_ns - start_ns) / 1e9 if is_timed else number
        for name, cell in row.cells.items():
            if not isinstance(cell, str):
                point = {"time": at, "value": float(cell), "name": clean(name)}
                panels.setdefault(found.units[name], []).append(point)
    if not panels:
        raise ValueError("no numbers to draw")
    return {
        "title": {"text": title, "fontSize": 15, "offset": 14},
        "padding": 12,
        "resolve": {"scale": {"color": "independent", "strokeDash": "independent", "x": "shared"}},
        "vconcat": [_panel(unit, points, along) for unit, points in panels.items()],
        "config": {
            "legend": {"labelLimit": 0, "symbolLimit": 0, "title": None, "symbolType": "stroke", "symbolSize": 400}
        },
    }


def _panel(unit: str | None, points: list[dict[str, Any]], along: str) -> dict[str, Any]:
    names = list(dict.fromkeys(point["name"] for point in points))
    values = [point["value"] for point in points]
    low, high = min(values), max(values)
    scale: dict[str, Any] = {"zero": False}
    if low == high:
        # An axis of a single value would have one label, with all digits rounded away.
        around = abs(low) / 10 or 1
        scale["domain"] = [low - around, high + around]
    colours = [_COLOURS[number % len(_COLOURS)] for number in range(len(names))]
    dashes = [_DASHES[number // len(_COLOURS) % len(_DASHES)] for number in range(len(names))]
    series = {"field": "name", "type": "nominal"}
    return {
        "width": 760,
        "height": max(160, 17 * len(names)),  # as high as its legend
        "data": {"values": points},
        "mark": {"type": "line", "point": True, "interpolate": "step-after"},
        "encoding": {
            "x": {"field": "time", "type": "quantitative", "title": along},
            "y": {"field": "value", "type": "quantitative", "title": unit or "number", "scale": scale},
            "color": series | {"scale": {"domain": names, "range": colours}},
            "strokeDash": series | {"scale": {"domain": names, "range": dashes}},
        },
    }
