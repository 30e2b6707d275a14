"""What a line says in front of its bytes: the time, and by words and arrows the direction.

`EV3 <- 0f 00 ...` is sent to the EV3 by one author and received from it by another: the type of a frame decides which.
"""

from __future__ import annotations

import re
from typing import Literal, NamedTuple

from ev3proto.schema.header import HEADER_SIZE
from ev3proto.tables.frame import MessageType

Direction = Literal["sent", "received"]

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
_TIME_SEARCH = re.compile(_TIME, re.ASCII)
_DIRECTION_SEARCH = re.compile(_DIRECTION, re.IGNORECASE)
_PART = re.compile(
    rf"(?P<time>{_TIME})|{_DIRECTION}|(?P<beside>{_BESIDE})|[\s\[({{\])}}\"'`:;,|]+|[<>=-]", re.IGNORECASE | re.ASCII
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
    while match := _PART.match(line, position):
        position = match.end()
        time = time or match["time"]
        if direction is None and (match["sent"] or match["received"]):
            direction, is_arrow = _direction(match)
    return Head(direction, time, position, True, is_arrow)


def head_before(line: str, start: int, end: int) -> Head:
    """Returns what line[start:end] says."""
    clean = clean_head(line, start)
    if end <= clean.end:
        return clean
    time = _TIME_SEARCH.search(line, start, end)
    word = _DIRECTION_SEARCH.search(line, start, end)
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
        time = _TIME_SEARCH.search(line)
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
