"""Pictures as files, by suffix: a page, an SVG, a PNG, or the Vega-Lite specification."""

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
"""The library that draws, an optional dependency."""

MOST_TITLE = 100
"""Maximum length of the title in letters: a long one would make the picture wider."""

PNG_SCALE = 2.0
"""Pixels of the PNG per pixel of the chart, so that letters are sharp in print."""


class Form(Enum):
    """The formats of a timeline, by the suffix of the file."""

    HTML = ".html"
    SVG = ".svg"
    PNG = ".png"
    JSON = ".json"

    @classmethod
    def of(cls, path: Path) -> Form:
        """Returns the format for the suffix of a file. Raises ValueError."""
        try:
            return cls(path.suffix.lower())
        except ValueError:
            known = ", ".join(form.value for form in cls)
            raise ValueError(f"{path}: unknown suffix; expected one of {known}") from None


class MissingLibraryError(ImportError):
    """The drawing library is not installed."""


def require_library() -> None:
    """Checks that the library that draws is installed, without importing it. Raises MissingLibraryError."""
    if find_spec(LIBRARY) is None:
        raise MissingLibraryError(
            f"drawing needs the package vl-convert-python, which is not installed: {install_command('plot')}"
        )


def render(timeline: Timeline, form: Form, title: str) -> bytes:
    """Returns the contents of a file, the same for the same timeline and title. Raises MissingLibraryError."""
    title = clean(title, MOST_TITLE)
    if form is not Form.HTML:
        return picture(specification(timeline, title), form)
    require_library()
    return page(specification(timeline), title, summary(timeline), _javascript()).encode()


def picture(chart: dict[str, Any], form: Form) -> bytes:
    """Draws a Vega-Lite chart as SVG or PNG, or returns it as JSON. Raises MissingLibraryError."""
    if form is Form.JSON:
        return json.dumps(chart, ensure_ascii=False, separators=(",", ":")).encode()
    require_library()
    import vl_convert  # an extra

    if form is Form.PNG:
        png: bytes = vl_convert.vegalite_to_png(chart, vl_version=VERSION, scale=PNG_SCALE, allowed_base_urls=[])
        return png
    svg: str = vl_convert.vegalite_to_svg(chart, vl_version=VERSION, allowed_base_urls=[])
    # The library continues to number clipping paths and gradients from one picture to the next.
    numbers: dict[str, str] = {}
    return re.sub(
        r'((?:id="|url\(#)(?:clip|gradient_))(\d+)',
        lambda it: it[1] + numbers.setdefault(it[0], str(len(numbers))),
        svg,
    ).encode()


@cache
def _javascript() -> str:
    """Returns the libraries of the page bundled into one script, which takes seconds."""
    import vl_convert  # an extra

    script: str = vl_convert.javascript_bundle("window.vegaEmbed = vegaEmbed;", vl_version=VERSION)
    return script
