"""The picture in a file: a page, an SVG or a PNG, by the file's suffix; written whole, or not at all."""

from __future__ import annotations

import re
from enum import Enum
from functools import cache
from importlib.util import find_spec
from pathlib import Path

from ev3proto.capture.timeline.chart import VERSION, specification
from ev3proto.capture.timeline.layout import lay_out
from ev3proto.capture.timeline.marks import Timeline
from ev3proto.capture.timeline.page import page
from ev3proto.capture.timeline.wording import clean
from ev3proto.extras import install_command
from ev3proto.whole_files import write_whole

LIBRARY = "vl_convert"
"""What draws, and is not installed with everything else."""

MOST_TITLE = 100
"""Letters of the title: a long one would make the picture wider."""

PNG_SCALE = 2.0
"""Pixels of the PNG for one of the chart: letters stay sharp when it is printed or projected."""


_SNIPPET = "window.vegaEmbed = vegaEmbed;"
"""What the page needs of the libraries."""


class Form(Enum):
    """What a timeline can be written as, by the file's suffix."""

    HTML = ".html"
    SVG = ".svg"
    PNG = ".png"

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
    """Looks for the library that draws, and does not import it.

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
        form: What to draw it as.
        title: What stands above the picture: the name of the capture.

    Returns:
        The contents of a file: the same bytes for the same timeline and title.

    Raises:
        MissingLibraryError: The library that draws is not installed.
    """
    require_library()
    import vl_convert  # an extra

    title = clean(title, MOST_TITLE)
    picture = lay_out(timeline, title)
    chart = specification(picture)
    if form is Form.HTML:
        return page(chart, title, picture.margin, _javascript()).encode()
    # No address is allowed: a picture is made of nothing but the capture.
    if form is Form.SVG:
        return _renumbered(vl_convert.vegalite_to_svg(chart, vl_version=VERSION, allowed_base_urls=[])).encode()
    return vl_convert.vegalite_to_png(chart, vl_version=VERSION, scale=PNG_SCALE, allowed_base_urls=[])


@cache
def _javascript() -> str:
    """The libraries that the page needs, made into one script, which takes seconds."""
    import vl_convert  # an extra

    return vl_convert.javascript_bundle(_SNIPPET, vl_version=VERSION)


def _renumbered(svg: str) -> str:
    """An SVG whose clipping paths are numbered from 0 on: the library counts them on from picture to picture."""
    numbers: dict[str, int] = {}

    def numbered(found: re.Match[str]) -> str:
        return f"{found[1]}clip{numbers.setdefault(found[2], len(numbers))}{found[3]}"

    return re.sub(r'(<clipPath id="|clip-path="url\(#)clip(\d+)("|\)")', numbered, svg)


def write(timeline: Timeline, path: Path, title: str) -> None:
    """Writes the picture of a timeline to a file: whole, or not at all.

    Args:
        timeline: What to draw.
        path: The file, whose suffix is that of a Form.
        title: What stands above the picture: the name of the capture.

    Raises:
        ValueError: The suffix is that of no form.
        OSError: The file cannot be written.
        MissingLibraryError: The library that draws is not installed.
    """
    write_whole(path, render(timeline, Form.of(path), title))
