r"""Lines of pieces with roles, so that a terminal can colour them and a pipe gets plain text.

A line also knows what it is about: the bytes of the frame, the code of a finding, the entry of the reference.

Everything printed passes here. Characters from outside that could steer a terminal are written as `\u001b`: control
characters (C0, DEL, C1), line and paragraph separators, and marks that change the direction of writing can hide text or
make a terminal act. Tags and other invisible format characters can hide a text within another. Lone surrogates and
noncharacters are invalid in many file formats, SVG among them.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from operator import itemgetter
from typing import Final

_HARMFUL = re.compile(
    "[\x00-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2060-\u206f\ufeff\ud800-\udfff\ufff9-\ufffb\ufffe\uffff"
    "\U000e0000-\U000e007f]"
)


def visible(text: str) -> str:
    r"""Returns a text whose characters that steer a terminal are written as `\u` and four hexadecimal digits."""
    # Most texts are harmless, and this test takes a tenth of the time of the other.
    return text if text.isprintable() else _HARMFUL.sub(_escaped, text)


def visible_lines(text: str) -> str:
    """Returns the same for a text of several lines; line ends stay."""
    return text if text.isprintable() else "\n".join(map(visible, text.split("\n")))


def _escaped(match: re.Match[str]) -> str:
    above, below = divmod(ord(match[0]) - 0x10000, 0x400)
    return f"\\u{ord(match[0]):04x}" if above < 0 else f"\\u{0xD800 + above:04x}\\u{0xDC00 + below:04x}"


class Role:
    """The role of a piece of a line. Plain texts: looking up members of an enumeration takes four times as long."""

    PLAIN: Final = "plain"
    HEADING: Final = "heading"
    OPERATION: Final = "operation"
    NAME: Final = "name"
    VALUE: Final = "value"
    MEANING: Final = "meaning"
    ASIDE: Final = "aside"
    FAULT: Final = "fault"
    GUTTER: Final = "gutter"  # in front of bytes of a frame, and of marks under them


Span = tuple[str, str]
Spans = list[Span]


class Line(Spans):
    """The pieces of a line, and what it is about.

    offset  of the first byte in the frame or program; None for a line about no bytes
    length  number of bytes
    code    of the finding, such as `E301`
    target  the operation that the reference explains, such as `SOUND.TONE`
    """

    __slots__ = ("code", "length", "offset", "target")

    def __init__(
        self, spans: Iterable[Span] = (), offset: int | None = None, length: int = 0, code: str = "", target: str = ""
    ) -> None:
        super().__init__(spans)
        self.offset = offset
        self.length = length
        self.code = code
        self.target = target


_TEXT = itemgetter(0)


def plain_text(line: Iterable[Span]) -> str:
    """Returns the line without its roles, safe to show."""
    return visible("".join(map(_TEXT, line)).rstrip())
