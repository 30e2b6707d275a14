"""What a line says in front of its bytes: the time, and the words and arrows that tell the direction.

Logs give both, and a line that begins like a log line may be expected to hold bytes where prose may not.
"""

from __future__ import annotations

import re
from typing import Literal, NamedTuple

from ev3proto.text.late_pattern import late_pattern

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
    rf"|(?P<received>(?<![a-z])(?:{_RECEIVED})(?![a-z])|(?<![<>=-])(?:(?:<-|<--|<<|←)|(?:->|-->|>>|→){_TO_COMPUTER})(?![<>=-]))"
)
# Words that loggers put beside the direction, and that therefore do not make a line prose.
_BESIDE = (
    r"(?P<beside>\b(?:debug|info|notice|warning|error|trace|data|raw|hex|frame|packet|payload|message"
    r"|bytearray|(?:\d{1,7}\s{1,4})?bytes?)\b)"
)

_TIME_SEARCH = late_pattern(_TIME, re.ASCII)
_DIRECTION_SEARCH = late_pattern(_DIRECTION, re.IGNORECASE)
_PART = late_pattern(
    rf"(?P<time>{_TIME})|{_DIRECTION}|{_BESIDE}|[\s\[({{\])}}\"'`:;,|]++|[<>=-]{{4,}}+|[<>=-]", re.IGNORECASE | re.ASCII
)


class Head(NamedTuple):
    """What a line says in front of its bytes.

    end       the column (from 0) where the time and the words about the direction end
    said      the column where the last of these words ends; only brackets, quotes and the like follow up to `end`
    is_clean  True when nothing else stands in front of the bytes
    is_arrow  the direction is that of an arrow; people draw arrows either way
    """

    direction: Direction | None
    time: str | None
    end: int
    said: int
    is_clean: bool
    is_arrow: bool = False

    @property
    def is_log(self) -> bool:
        """True for the beginning of a log line, after which one may expect bytes."""
        return self.is_clean and (self.direction is not None or self.time is not None)


# What socat, hcidump and btmon print above the bytes, and nc in front of the offset.
_WAY = late_pattern(r"(?P<mark>[<>])\s(?:\d{4}/\d\d/\d\d\s|(?P<adapter>ACL\b)|[0-9a-fA-F]{8}\s[0-9a-fA-F]{2}\s)")
_MOST_SAID = 200
_MOST_DATE = 16
"""Columns that a date takes which is written in another way than those that a time has."""

NO_HEAD = Head(None, None, 0, 0, is_clean=False)


def clean_head(line: str, start: int = 0) -> Head:
    """The time and the direction at the start, as far as there is nothing else."""
    direction: Direction | None = None
    time: str | None = None
    is_arrow = False
    position = said = start
    while match := _PART.match(line, position):
        position = match.end()
        if match.lastgroup is None:
            continue
        said = position
        time = time or match["time"]
        if direction is None:
            direction, is_arrow = _direction(match), _is_arrow(match)
    return Head(direction, time, position, said, is_clean=True, is_arrow=is_arrow)


def head_before(line: str, start: int, end: int) -> Head:
    """What stands in line[start:end]."""
    clean = clean_head(line, start)
    if end <= clean.end:
        return clean
    time = _TIME_SEARCH.search(line, start, end)
    word = _DIRECTION_SEARCH.search(line, start, end)
    direction, is_arrow = (None, False) if word is None else (_direction(word), _is_arrow(word))
    return Head(direction, time and time[0], clean.end, clean.said, is_clean=False, is_arrow=is_arrow)


def way(line: str) -> Direction | None:
    """The direction that the mark at the start of a line tells, as some programs print it."""
    found = _WAY.match(line)
    if found is None:
        return None
    # A Bluetooth adapter receives what the computer sends.
    return "sent" if (found["mark"] == ">") != bool(found["adapter"]) else "received"


def announced(line: str) -> Head | None:
    """What a line without bytes says of those in the next lines, as in `12:30:45 Sending:`; None where it says nothing.

    Args:
        line: The line, without the mark of its end.
    """
    if not line.strip() or len(line) > _MOST_SAID:
        return None
    direction = way(line)
    if direction is not None:
        time = _TIME_SEARCH.search(line)
        return Head(direction, time and time[0], len(line), len(line), is_clean=True)
    head = head_before(line, 0, len(line))
    is_time_first = head.time is not None and line.find(head.time) < _MOST_DATE
    if head.is_clean or is_time_first or line.rstrip().endswith(":"):
        return head if head.direction is not None or is_time_first else None
    return None


def time_before(line: str, end: int) -> str | None:
    """The time that stands in front of a column, as printed; None where there is none."""
    found = _TIME_SEARCH.search(line, 0, end) if ":" in line[:end] else None
    return found and found[0]


def _direction(match: re.Match[str]) -> Direction | None:
    """The direction that the matched word tells, if it is such a word."""
    if match["sent"]:
        return "sent"
    return "received" if match["received"] else None


def _is_arrow(match: re.Match[str]) -> bool:
    """Whether what tells the direction has no letters."""
    return not match[0][:1].isalpha()
