"""Pictures as files: a page, an SVG, a PNG or what Vega-Lite draws, by the file's suffix; whole, or not at all."""

from __future__ import annotations

import json
import re
from enum import Enum
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from ev3proto.capture.timeline.chart import VERSION, specification, summary
from ev3proto.capture.timeline.collecting import clean
from ev3proto.capture.timeline.marks import Timeline
from ev3proto.capture.timeline.page import page
from ev3proto.extras import install_command

LIBRARY = "vl_convert"
"""The library that draws; an extra."""

MOST_TITLE = 100
"""Letters of the title: a long one would make the picture wider."""

PNG_SCALE = 2.0
"""Pixels of the PNG for one of the chart: letters stay sharp when it is printed or projected."""


class Form(Enum):
    """What a timeline can be written as, by the file's suffix."""

    HTML = ".html"
    SVG = ".svg"
    PNG = ".png"
    JSON = ".json"

    @classmethod
    def of(cls, path: Path) -> Form:
        """The form that a file's suffix asks for.

        Raises:
            ValueError: The suffix is that of no form.
        """
        try:
            return cls(path.suffix.lower())
        except ValueError:
            known = ", ".join(form.value for form in cls)
            raise ValueError(f"{path}: a timeline is written as one of {known}, by the file's suffix") from None


class MissingLibraryError(ImportError):
    """The library that draws is not installed."""


def require_library() -> None:
    """Looks for the library that draws, without importing it.

    Raises:
        MissingLibraryError: It is not installed.
    """
    if find_spec(LIBRARY) is None:
        raise MissingLibraryError(
            f"drawing needs the package vl-convert-python, which is not installed: {install_command('plot')}"
        )


def render(timeline: Timeline, form: Form, title: str) -> bytes:
    """Draws a timeline.

    Args:
        timeline: What to draw.
        form: The form of the file.
        title: Text above the picture: the name of the capture.

    Returns:
        The contents of a file: the same bytes for the same timeline and title.

    Raises:
        MissingLibraryError: The library that draws is not installed.
    """
    title = clean(title, MOST_TITLE)
    if form is not Form.HTML:
        return picture(specification(timeline, title), form)
    require_library()
    return page(specification(timeline), title, summary(timeline), _javascript()).encode()


def picture(chart: dict[str, Any], form: Form) -> bytes:
    """Draws a chart of Vega-Lite as SVG or PNG, from nothing but what is in it; as JSON it is the chart itself.

    Raises:
        MissingLibraryError: The library that draws is not installed.
    """
    if form is Form.JSON:
        return json.dumps(chart, ensure_ascii=False, separators=(",", ":")).encode()
    require_library()
    import vl_convert  # an extra

    if form is Form.PNG:
        png: bytes = vl_convert.vegalite_to_png(chart, vl_version=VERSION, scale=PNG_SCALE, allowed_base_urls=[])
        return png
    svg: str = vl_convert.vegalite_to_svg(chart, vl_version=VERSION, allowed_base_urls=[])
    # The library counts clipping paths and gradients on from picture to picture.
    numbers: dict[str, str] = {}
    return re.sub(
        r'((?:id="|url\(#)(?:clip|gradient_))(\d+)',
        lambda it: it[1] + numbers.setdefault(it[0], str(len(numbers))),
        svg,
    ).encode()


@cache
def _javascript() -> str:
    """The libraries that the page needs, made into one script, which takes seconds."""
    import vl_convert  # an extra

    script: str = vl_convert.javascript_bundle("window.vegaEmbed = vegaEmbed;", vl_version=VERSION)
    return script
