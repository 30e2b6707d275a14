"""Lines made of pieces that each know what they are, so that a terminal can colour them and a pipe gets them plain."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

from ev3proto.text.visible import visible


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
