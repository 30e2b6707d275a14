"""A piece of text that stands for bytes: as a form finds it in a line, and as it is reported.

All forms share this, so that each has to say only where the bytes are, what they are and what is wrong with them.
"""

from __future__ import annotations

from typing import NamedTuple

from ev3proto.text.paste.head import Direction, Head

LEAST = 5
"""Bytes of the shortest frame. Fewer, in the midst of other text, are not worth the risk of reading prose as hex."""

MAX_LINE = 1 << 20
"""Characters of the longest line that is read."""

MAX_TEXT = 200
"""Characters of a piece that are shown of it."""

MOST_SHORT = 24
"""Characters of a piece that a sentence quotes."""

MAX_COLLECTED = 1 << 16
"""Bytes (of an array: characters) of the longest piece that is collected over several lines."""


class Pasted(NamedTuple):
    """One piece of pasted text and the bytes it stands for.

    data       the bytes; where `problem` is set, those in front of it
    line       where the piece starts in its source, the first line is 1
    text       the piece, stripped, at most 200 characters of it
    direction  "sent" or "received" (as the host sees it) where the text says so, else None
    time       as printed, such as "09:12:31.011558" or "2024-01-31T09:12:31Z"; None where the text has none
    cut        True where the text says that more bytes existed, by an ellipsis at its end
    problem    None, or a sentence that tells (with the column) why the piece could not be read whole
    column     where it starts in its line, the first column is 1
    unread     True for what looks like a frame and is none: `data` is empty, and `problem` tells why
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


class Found(NamedTuple):
    """Bytes in line[start:end]; with `is_marked` they stand where only a frame can, however short they are."""

    start: int
    end: int
    head: Head
    data: bytes
    cut: bool
    problem: str | None
    is_marked: bool = False

    def pasted(self, number: int, line: str) -> Pasted:
        """The same for those who do not have the line at hand."""
        text = short(line[self.start : self.end], MAX_TEXT)
        head, column = self.head, self.start + 1
        return Pasted(self.data, number, text, head.direction, head.time, self.cut, self.problem, column)


class Wants(NamedTuple):
    """What is worth reporting: the fewest bytes, and whether the text is known to be meant as bytes."""

    least: int
    is_sure: bool

    def takes(self, size: int, problem: str | None, head: Head, *, is_marked: bool = False) -> bool:
        """Whether so many bytes are worth reporting.

        After a word for the direction, and where marked, two are: the length field of a frame that lost the rest.
        """
        if problem is None:
            is_meant = is_marked or (head.is_log and head.direction is not None)
            return size >= (min(self.least, 2) if is_meant else self.least)
        return self.is_sure or is_marked or head.is_log or size >= LEAST


def check_text(text: str) -> None:
    """Raises TypeError for what is no text."""
    if not isinstance(text, str):
        raise TypeError(f"what was pasted is a text, not {type(text).__name__}")


def short(text: str, limit: int = MOST_SHORT) -> str:
    """The text stripped, for showing it; where it is longer than that, it ends in an ellipsis in place of the rest."""
    # Sliced first: the text may be a megabyte, of which nobody wants a copy.
    head = text[: limit * 4].strip()
    return head if len(head) <= limit else head[: limit - 1].rstrip() + "…"
