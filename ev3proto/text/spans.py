"""Lines made of pieces that each know what they are, so that a terminal can colour them and a pipe gets them plain."""

from __future__ import annotations

from collections.abc import Sequence
from enum import StrEnum
from operator import itemgetter


class Role(StrEnum):
    """What a piece of a line is."""

    PLAIN = "plain"
    HEADING = "heading"
    OPERATION = "operation"
    NAME = "name"
    VALUE = "value"
    MEANING = "meaning"
    ASIDE = "aside"
    FAULT = "fault"


Span = tuple[str, Role]
Line = list[Span]

_TEXT = itemgetter(0)


def plain_text(line: Sequence[Span]) -> str:
    """The line without its roles."""
    return "".join(map(_TEXT, line)).rstrip()
