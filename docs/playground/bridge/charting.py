"""What takes long, and is done in steps; and the timeline of an input, which is read again for it."""

from __future__ import annotations

import time
from collections.abc import Iterator
from typing import Any

from ev3proto.capture.record import Announcement, Record, Skipped
from ev3proto.capture.timeline import Form, Timeline, collect_in_steps, render
from ev3proto.reading.given import Given
from ev3proto.reading.options import Options, Sources
from ev3proto.reading.parts import Reading

OFTEN = 0.05
"""Seconds between two steps."""

Steps = Iterator[dict[str, Any]]
"""The steps: `part` and `count` of what was read so far, or an `answer`; the last one is final."""

MOST_MARKS = 4000
"""Maximum number of marks in the timeline, which the page draws at once; more are counted in bins of time."""


def timeline(given: Given, name: str) -> Steps:
    """Reads an input. The answer is a chart of it as JSON, for Vega-Lite, or None."""
    reading = Reading([given], Options(sources=Sources.NO, images=False, raises=False))
    events = (event for event in reading.events() if isinstance(event, Record | Announcement | Skipped))
    collecting = collect_in_steps(events, most_marks=MOST_MARKS)
    said = time.monotonic()
    while True:
        try:
            next(collecting)
        except StopIteration as end:
            drawn: Timeline | None = end.value
            break
        if time.monotonic() - said > OFTEN:
            yield {"part": reading.progress or 0.0, "count": reading.part.account.frames}
            said = time.monotonic()
    yield {"answer": None if drawn is None else render(drawn, Form.JSON, name).decode()}
