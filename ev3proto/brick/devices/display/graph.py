"""Graphs: samples of some values over time, drawn as thick lines.

GRAPH_SETUP names the values' places in memory, GRAPH_SAMPLE stores them, GRAPH_DRAW draws what was stored.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import NamedTuple

from ev3proto.brick.conversions import single, wrap16
from ev3proto.brick.devices.display.canvas import WIDTH, Canvas

MOST_ITEMS = 8
"""Values that one graph can show."""

_MOST_WHOLE = 2**31 - 1
_NOTHING = math.nan


class Scale(NamedTuple):
    """Where one item is drawn, and its value now."""

    offset: int  # row of its top
    span: int  # its height in pixels
    least: float  # the value at the bottom
    most: float  # the value at the top
    value: float


class Summary(NamedTuple):
    """The result of GRAPH_DRAW for one item; NaN without samples."""

    actual: float
    lowest: float
    highest: float
    average: float


@dataclass
class Graph:
    """A graph as GRAPH_SETUP left it.

    `size` is the number of samples kept, at most one for each column of the display.
    `items` read the scale and value of each item from memory at every use.
    """

    x: int = 0
    size: int = 0
    items: tuple[Callable[[], Scale], ...] = ()
    samples: list[deque[float]] = field(init=False)

    def __post_init__(self) -> None:
        self.items = self.items[:MOST_ITEMS]
        self.samples = [deque(maxlen=max(min(self.size, WIDTH), 0)) for _ in self.items]

    def sample(self) -> None:
        """Stores the value of each item; the oldest is lost if there are already `size` of them."""
        for item, samples in zip(self.items, self.samples, strict=True):
            samples.append(item().value)

    def draw(self, canvas: Canvas, view: int) -> Summary:
        """Draws one item and returns its summary; an unknown number draws all, NaN at the bottom."""
        if 0 <= view < len(self.items):
            self._draw_item(canvas, view, self.x, skips=True)
            return _summary([sample for sample in self.samples[view] if not math.isnan(sample)])
        for item in range(len(self.items)):
            self._draw_item(canvas, item, self.x + 1, skips=False)
        return _summary([])

    def _draw_item(self, canvas: Canvas, item: int, x: int, *, skips: bool) -> None:
        """Draws the samples of one item; NaN is omitted if `skips` is set."""
        scale = self.items[item]()
        bottom = scale.offset + scale.span
        before = bottom
        for place, sample in enumerate(self.samples[item], x):
            if skips and math.isnan(sample):
                continue
            y = bottom - _height(sample, scale)
            if place < x + 2:
                canvas.pixel(1, place, y)
            else:
                _thick_line(canvas, place, before, y)
            before = y


def _summary(samples: list[float]) -> Summary:
    """Returns the summary of some samples, their mean in single precision."""
    if not samples:
        return Summary(_NOTHING, _NOTHING, _NOTHING, _NOTHING)
    total = 0.0
    for sample in samples:
        total = single(total + sample)
    return Summary(samples[-1], min(samples), max(samples), single(total / len(samples)))


def _height(sample: float, scale: Scale) -> int:
    """Returns how far above its bottom a sample is drawn, computed in single precision as on the brick."""
    rise = single(single(sample - scale.least) * scale.span)
    run = single(scale.most - scale.least)
    height = single(rise / run) if run else math.copysign(math.inf, rise) if rise else math.nan
    whole = 0 if math.isnan(height) else int(max(min(height, _MOST_WHOLE), -_MOST_WHOLE - 1))
    return max(min(wrap16(whole), scale.span), 0)


def _thick_line(canvas: Canvas, x: int, before: int, y: int) -> None:
    """Draws the three lines from one sample at (x - 1, before) to the next at (x, y)."""
    canvas.line(1, x - 1, before, x, y)
    if y > before:
        canvas.line(1, x - 2, before - 1, x - 1, y - 1)
        canvas.line(1, x, before + 1, x + 1, y + 1)
    elif y < before:
        canvas.line(1, x, before - 1, x + 1, y - 1)
        canvas.line(1, x - 2, before + 1, x - 1, y + 1)
    else:
        canvas.line(1, x - 1, before - 1, x, y - 1)
        canvas.line(1, x - 1, before + 1, x, y + 1)
