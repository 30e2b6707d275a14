"""A piece of text that represents bytes, as it is reported, and the limits of what is read."""

from __future__ import annotations

from typing import NamedTuple

from ev3proto.text.paste.head import Direction

LEAST = 5
"""Bytes of the shortest frame."""

MAX_LINE = 1 << 20
"""Characters of the longest line that is read."""

MAX_TEXT = 200
"""Characters of a piece that are shown of it."""

MOST_SHORT = 24
"""Characters of a piece that a sentence quotes."""

MAX_COLLECTED = 1 << 16
"""Characters of the longest piece that is collected over several lines."""


class Pasted(NamedTuple):
    """One piece of pasted text and the bytes it represents.

    data       the bytes; where `problem` is set, those in front of it
    line       where the piece starts in its source, the first line is 1
    text       the piece, stripped, at most 200 characters of it
    direction  "sent" or "received" (as the host sees it) where the text says so, else None
    time       as printed, such as "09:12:31.011558" or "2024-01-31T09:12:31Z"; None where the text has none
    cut        True where the text says that more bytes existed, by an ellipsis at its end
    problem    None, or a sentence that tells (with the column) why the piece could not be read whole
    column     where it starts in its line, the first column is 1
    unread     True for bytes that look like a frame without being one: `data` is empty, `problem` tells why
    """

    data: bytes
    line: int
    text: str
    direction: Direction | None = None
    time: str | None = None
    cut: bool = False
    problem: str | None = None
    column: int = 1
    unread: bool = False


def check_text(text: str) -> None:
    """Raises TypeError for anything but a text."""
    if not isinstance(text, str):
        raise TypeError(f"what was pasted is a text, not {type(text).__name__}")


def short(text: str, limit: int = MOST_SHORT) -> str:
    """Returns the text stripped, cut with an ellipsis where it is longer than the limit."""
    # Sliced first: the text may be a megabyte.
    head = text[: limit * 4].strip()
    return head if len(head) <= limit else head[: limit - 1].rstrip() + "…"
