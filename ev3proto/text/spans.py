r"""Lines made of pieces that each know what they are, so that a terminal can colour them and a pipe gets them plain.

What comes from outside is made fit to be shown: a character that would steer a terminal is written as `\u001b`. This is
the border that everything printed passes. Control characters (C0, DEL, C1), line and paragraph separators, and the
marks that turn the direction of writing can hide what a line says, or make a terminal do things. Tags and other formats
that nobody sees can hide a text in another one. Halves of a character and numbers that are none cannot stand in files
of many kinds, SVG among them.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Final

_HARMFUL = re.compile(
    "[\x00-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2060-\u206f\ufeff\ud800-\udfff\ufff9-\ufffb\ufffe\uffff"
    "\U000e0000-\U000e007f]"
)


def visible(text: str) -> str:
    r"""A text as it can be shown on one line.

    Args:
        text: Any text, also from the network.

    Returns:
        The same without characters that steer a terminal: each is written as `\u` and four hexadecimal digits, as JSON
        and assembly write it in a string.

    """
    # Most texts are harmless, and this test takes a tenth of the time of the other.
    return text if text.isprintable() else _HARMFUL.sub(_escaped, text)


def visible_lines(text: str) -> str:
    """The same for a text of several lines, which stay."""
    return text if text.isprintable() else "\n".join(map(visible, text.split("\n")))


def _escaped(match: re.Match[str]) -> str:
    units = match[0].encode("utf-16-be", "surrogatepass").hex()
    return "".join(f"\\u{units[at : at + 4]}" for at in range(0, len(units), 4))


class Role:
    """What a piece of a line is. Plain texts, since members of an enumeration take four times as long to look up."""

    PLAIN: Final = "plain"
    HEADING: Final = "heading"
    OPERATION: Final = "operation"
    NAME: Final = "name"
    VALUE: Final = "value"
    MEANING: Final = "meaning"
    ASIDE: Final = "aside"
    FAULT: Final = "fault"


Span = tuple[str, str]
Line = list[Span]


def plain_text(line: Iterable[Span]) -> str:
    """The line without its roles, fit to be shown."""
    return visible("".join([text for text, _ in line]).rstrip())
