"""Which way a frame went: the words of the text say it, or its arrows, as far as the type of the frame agrees.

`EV3 <- 0f 00 ...` is sent to the EV3 by one and received from it by the other: a command is what is sent.
"""

from __future__ import annotations

from ev3proto.schema.header import HEADER_SIZE
from ev3proto.tables.frame import MessageType
from ev3proto.text.late_pattern import late_pattern
from ev3proto.text.paste.head import Direction, Head, way

_DIRECTIONS: dict[int, Direction] = {int(it): "sent" if it.is_command else "received" for it in MessageType}
# Arrows that also mean other things, and therefore count only right in front of a frame: not after a key or an index.
_ARROW = late_pattern(
    r"(?:(?<![\w\]\"'<>=-])(?<![\d\]\"']\s)(?:(?P<out>=>|>>>)|(?P<in><=|<<<))"
    r"|(?<!\S)(?:(?P<lone_out>>)|(?P<lone_in><))(?=\s))\s{0,4}(?:0[xX]\||[\[({\"'])?$"
)
_MOST_BLANKS = 8


def direction_of(data: bytes, line: str, start: int, head: Head, said: Head) -> Direction | None:
    """Which way a frame went.

    Args:
        data: The frame.
        line: The line in which it begins.
        start: The column where it begins.
        head: What stands in front of it.
        said: What the line above says.

    Returns:
        What a word says; where there is only an arrow, what the type of the frame says, if it has one. None where the
        text says nothing.
    """
    direction, is_arrow = head.direction, head.is_arrow
    if direction is None:
        direction = way(line)
    if direction is None:
        direction, is_arrow = said.direction, said.is_arrow
    if direction is None:
        direction, is_arrow = _arrow_before(line, start), True
    return _of_type(data) or direction if is_arrow and direction is not None else direction


def is_command(data: bytes) -> bool:
    """Whether the type of a frame is that of a command."""
    return _of_type(data) == "sent"


def _of_type(data: bytes) -> Direction | None:
    return _DIRECTIONS.get(data[HEADER_SIZE - 1]) if len(data) >= HEADER_SIZE else None


def _arrow_before(line: str, start: int) -> Direction | None:
    found = _ARROW.search(line, max(0, start - _MOST_BLANKS), start)
    if found is None:
        return None
    return "sent" if found["out"] or found["lone_out"] else "received"
