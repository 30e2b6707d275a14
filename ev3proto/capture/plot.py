"""A picture of values over time: a panel for each unit, a line for each value."""

from __future__ import annotations

from typing import Any

from ev3proto.capture.series import Series
from ev3proto.capture.timeline.chart import VERSION
from ev3proto.capture.timeline.chart_files import MOST_TITLE, PNG_SCALE, require_library
from ev3proto.capture.timeline.wording import clean

WIDTH, HEIGHT = 760, 160
SUFFIXES = (".svg", ".png")
_TIME, _ORDER = "time (s)", "order"


def draw(found: Series, suffix: str, title: str) -> bytes:
    """Draws the numbers among values.

    Args:
        found: The values.
        suffix: `.svg` or `.png`.
        title: What stands above the picture.

    Returns:
        The contents of a file.

    Raises:
        ValueError: The suffix is another, or there is no number to draw.
        MissingLibraryError: The library that draws is not installed.
    """
    if suffix not in SUFFIXES:
        raise ValueError(f"a plot is written to a file that ends in .svg or .png, not in {suffix or 'nothing'}")
    require_library()
    import vl_convert  # an extra

    chart = specification(found, clean(title, MOST_TITLE))
    if suffix == ".svg":
        text: str = vl_convert.vegalite_to_svg(chart, vl_version=VERSION, allowed_base_urls=[])
        return text.encode()
    data: bytes = vl_convert.vegalite_to_png(chart, vl_version=VERSION, scale=PNG_SCALE, allowed_base_urls=[])
    return data


def specification(found: Series, title: str) -> dict[str, Any]:
    """The picture in Vega-Lite: one panel for each unit, with the time in seconds below all of them.

    Where a reply has no time, there is the order instead: the first reply is 1.
    """
    is_timed = all(row.is_timed for row in found.rows)
    start = min(row.time_ns for row in found.rows)
    panels: dict[str | None, list[dict[str, Any]]] = {}
    for number, row in enumerate(found.rows, 1):
        at = (row.time_ns - start) / 1e9 if is_timed else number
        for name, cell in row.cells.items():
            if not isinstance(cell, str):
                point = {"time": at, "value": float(cell), "name": name}
                panels.setdefault(found.units[name], []).append(point)
    if not panels:
        raise ValueError("there is no number to draw")
    return {
        "title": title,
        "resolve": {"scale": {"color": "independent", "x": "shared"}},
        "vconcat": [_panel(unit, points, _TIME if is_timed else _ORDER) for unit, points in panels.items()],
    }


def _panel(unit: str | None, points: list[dict[str, Any]], along: str) -> dict[str, Any]:
    values = [point["value"] for point in points]
    low, high = min(values), max(values)
    scale: dict[str, Any] = {"zero": False}
    if low == high:
        # An axis without a length would have a single number, rounded to none of its digits.
        around = abs(low) / 10 or 1
        scale["domain"] = [low - around, high + around]
    return {
        "width": WIDTH,
        "height": HEIGHT,
        "data": {"values": points},
        "mark": {"type": "line", "point": True, "interpolate": "step-after"},
        "encoding": {
            "x": {"field": "time", "type": "quantitative", "title": along},
            "y": {"field": "value", "type": "quantitative", "title": unit or "number", "scale": scale},
            "color": {"field": "name", "type": "nominal", "title": None},
        },
    }
