"""Timelines: a chart of a dialogue over time, with lanes by brick and kind, latencies, errors and files.

    with ev3proto.capture.read("robot.pcapng") as capture:
        timeline = collect(capture.events())
    if timeline is not None:
        page = render(timeline, Form.HTML, "robot.pcapng")

`marks` and `collecting` decide what is drawn, `chart`, `page` and `chart_files` how. The library that draws is imported
when something is drawn.
"""

from ev3proto.capture.timeline.chart_files import Form, MissingLibraryError, render, require_library
from ev3proto.capture.timeline.collecting import Window, collect, collect_in_steps
from ev3proto.capture.timeline.marks import Cell, Lane, LaneKind, Mark, MarkState, Tally, Timeline

__all__ = [
    "Cell",
    "Form",
    "Lane",
    "LaneKind",
    "Mark",
    "MarkState",
    "MissingLibraryError",
    "Tally",
    "Timeline",
    "Window",
    "collect",
    "collect_in_steps",
    "render",
    "require_library",
]
