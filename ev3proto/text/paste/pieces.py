"""A piece of text that represents bytes, as it is reported: what it holds, and what its line says in front of it.

That is the time, and by words and arrows the direction. `EV3 <- 0f 00 ...` is sent to the EV3 by one author and
received from it by another: the type of a frame decides which.
"""

from __future__ import annotations

import re
from functools import cache
from typing import Literal, NamedTuple

from ev3proto.schema.header import HEADER_SIZE
from ev3proto.tables.frame import MessageType

Direction = Literal["sent", "received"]

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


_CLOCK = r"(?:[01]\d|2[0-3]):[0-5]\d:[0-6]\d(?:[.,]\d{1,9})?"
_TIME = rf"(?<![\w:.])(?:\d{{4}}[-/]\d\d[-/]\d\d[T ]\s?)?{_CLOCK}(?:Z|\s?[+-]\d\d:?\d\d)?(?=[\])>:;,]?(?:\s|$))"
_SENT = (
    r"sent|send|sending|sends|sendto|sendmsg|tx|write|writes|writing|wrote|written|request|command"
    r"|transmit(?:s|ted|ting)?|outgoing|outbound|out(?=\s?[:>\]])|to\s(?:the\s)?(?:ev3|brick|robot)"
)
_RECEIVED = (
    r"received|receive|receiving|receives|recv|recvfrom|recvmsg|rx|read|reads|reading|reply|response|answer"
    r"|got|incoming|inbound|in(?=\s?[:\]])|from\s(?:the\s)?(?:ev3|brick|robot)"
)
# Arrows point to where a frame goes, unless that is the computer.
_TO_COMPUTER = r"(?=\s?(?:the\s)?(?:pc|host|computer|laptop|phone|client)\b)"
_DIRECTION = (
    rf"(?P<sent>(?<![a-z])(?:{_SENT})(?![a-z])|(?<![<>=-])(?:->|-->|>>|→)(?![<>=-])(?!{_TO_COMPUTER}))"
    rf"|(?P<received>(?<![a-z])(?:{_RECEIVED})(?![a-z])"
    rf"|(?<![<>=-])(?:(?:<-|<--|<<|←)|(?:->|-->|>>|→){_TO_COMPUTER})(?![<>=-]))"
)
# Words that loggers put beside the direction, and that therefore do not make a line prose.
_BESIDE = (
    r"\b(?:debug|info|notice|warning|error|trace|data|raw|hex|frame|packet|payload|message"
    r"|bytearray|(?:\d{1,7}\s{1,4})?bytes?)\b"
)
_MARKS = r"[\s\[({\])}\"'`:;,|]+|[<>=-]"


class _Patterns(NamedTuple):
    """What is looked for in front of bytes."""

    time: re.Pattern[str]
    direction: re.Pattern[str]
    part: re.Pattern[str]


@cache
def _patterns() -> _Patterns:
    # Compiled for the first line that has more than bytes: a frame alone is decoded 3 ms of 100 sooner.
    return _Patterns(
        re.compile(_TIME, re.ASCII),
        re.compile(_DIRECTION, re.IGNORECASE),
        re.compile(rf"(?P<time>{_TIME})|{_DIRECTION}|(?P<beside>{_BESIDE})|{_MARKS}", re.IGNORECASE | re.ASCII),
    )


# Arrows that also mean other things count only right in front of a frame: not after a key or an index.
_ARROW = re.compile(
    r"(?:(?<![\w\]\"'<>=-])(?<![\d\]\"']\s)(?:(?P<out>=>|>>>)|(?:<=|<<<))"
    r"|(?<!\S)(?:(?P<lone>>)|<)(?=\s))\s{0,4}(?:0[xX]\||[\[({\"'])?$"
)
# What socat, hcidump and btmon print above the bytes, and nc in front of the offset.
_WAY = re.compile(r"(?P<mark>[<>])\s(?:\d{4}/\d\d/\d\d\s|(?P<adapter>ACL\b)|[0-9a-fA-F]{8}\s[0-9a-fA-F]{2}\s)")
_MOST_SAID = 200
_MOST_DATE = 16
"""Columns of a date in front of a time, in any format."""
_COMMANDS = frozenset(int(member) for member in MessageType if member.is_command)
_REPLIES = frozenset(int(member) for member in MessageType if not member.is_command)


class Head(NamedTuple):
    """What a line says in front of its bytes.

    end       the column (from 0) after the time, the words about the direction and the brackets and quotes after them
    is_clean  nothing else is in front of the bytes
    is_arrow  the direction is that of an arrow; people draw arrows either way
    """

    direction: Direction | None = None
    time: str | None = None
    end: int = 0
    is_clean: bool = False
    is_arrow: bool = False

    @property
    def is_log(self) -> bool:
        """Whether a log line begins so, after which bytes may be expected."""
        return self.is_clean and (self.direction is not None or self.time is not None)


NO_HEAD = Head()


def clean_head(line: str, start: int = 0) -> Head:
    """Returns the time and the direction at the start, as far as nothing else is there."""
    direction, time, is_arrow, position = None, None, False, start
    while match := _patterns().part.match(line, position):
        position = match.end()
        time = time or match["time"]
        if direction is None and (match["sent"] or match["received"]):
            direction, is_arrow = _direction(match)
    return Head(direction, time, position, True, is_arrow)


def head_before(line: str, start: int, end: int) -> Head:
    """Returns what line[start:end] says."""
    if not line[start:end].strip():
        return Head(end=end, is_clean=True)
    clean = clean_head(line, start)
    if end <= clean.end:
        return clean
    time = _patterns().time.search(line, start, end)
    word = _patterns().direction.search(line, start, end)
    direction, is_arrow = (None, False) if word is None else _direction(word)
    return Head(direction, time and time[0], clean.end, False, is_arrow)


def _direction(match: re.Match[str]) -> tuple[Direction, bool]:
    return "sent" if match["sent"] else "received", not match[0][:1].isalpha()


def _way(line: str) -> Direction | None:
    """Returns the direction by the mark at the start of a line, as some programs print it."""
    found = _WAY.match(line)
    if found is None:
        return None
    # A Bluetooth adapter receives what the computer sends.
    return "sent" if (found["mark"] == ">") != bool(found["adapter"]) else "received"


def announced(line: str) -> Head | None:
    """Returns what a line without bytes says of the next lines, as in `12:30:45 Sending:`; None for nothing."""
    if not line.strip() or len(line) > _MOST_SAID:
        return None
    direction = _way(line)
    if direction is not None:
        time = _patterns().time.search(line)
        return Head(direction, time and time[0], is_clean=True)
    head = head_before(line, 0, len(line))
    is_time_first = head.time is not None and line.find(head.time) < _MOST_DATE
    if head.is_clean or is_time_first or line.rstrip().endswith(":"):
        return head if head.direction is not None or is_time_first else None
    return None


def direction_of(data: bytes, line: str, start: int, head: Head, said: Head) -> Direction | None:
    """Returns which way a frame went; None where the text does not say.

    Args:
        data: The frame.
        line: The line in which it begins.
        start: The column where it begins.
        head: What is in front of it.
        said: What the line above says.
    """
    direction, is_arrow = head.direction, head.is_arrow
    if direction is None:
        direction = _way(line)
    if direction is None:
        direction, is_arrow = said.direction, said.is_arrow
    if direction is None and (found := _ARROW.search(line, max(0, start - 8), start)):
        direction, is_arrow = "sent" if found["out"] or found["lone"] else "received", True
    if direction is None or not is_arrow or len(data) < HEADER_SIZE:
        return direction
    code = data[HEADER_SIZE - 1]
    return "sent" if code in _COMMANDS else "received" if code in _REPLIES else direction
