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
_SENT = r"sent|send|sending|sends|tx|write|writes|writing|wrote|written|request|command"
_RECEIVED = r"received|receive|receiving|receives|recv|rx|read|reads|reading|reply|response|answer"
_DIRECTION = (
    rf"(?P<sent>(?<![a-z])(?:{_SENT})(?![a-z])|(?<![<>=-])(?:->|-->|>>|→)(?![<>=-]))"
    rf"|(?P<received>(?<![a-z])(?:{_RECEIVED})(?![a-z])|(?<![<>=-])(?:<-|<--|<<|←)(?![<>=-]))"
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
    """

    direction: Direction | None
    time: str | None
    end: int
    said: int
    is_clean: bool

    @property
    def is_log(self) -> bool:
        """True for the beginning of a log line, behind which one may expect bytes."""
        return self.is_clean and (self.direction is not None or self.time is not None)


NO_HEAD = Head(None, None, 0, 0, is_clean=False)


def clean_head(line: str, start: int = 0) -> Head:
    """The time and the direction at the start, as far as there is nothing else."""
    direction: Direction | None = None
    time: str | None = None
    position = said = start
    while match := _PART.match(line, position):
        position = match.end()
        if match.lastgroup is None:
            continue
        said = position
        time = time or match["time"]
        direction = direction or _direction(match)
    return Head(direction, time, position, said, is_clean=True)


def head_before(line: str, start: int, end: int) -> Head:
    """What stands in line[start:end]."""
    clean = clean_head(line, start)
    if end <= clean.end:
        return clean
    time = _TIME_SEARCH.search(line, start, end)
    word = _DIRECTION_SEARCH.search(line, start, end)
    return Head(word and _direction(word), time and time[0], clean.end, clean.said, is_clean=False)


def time_before(line: str, end: int) -> str | None:
    """The time that stands in front of a column, as printed; None where there is none."""
    found = _TIME_SEARCH.search(line, 0, end) if ":" in line[:end] else None
    return found and found[0]


def _direction(match: re.Match[str]) -> Direction | None:
    """The direction that the matched word tells, if it is such a word."""
    if match["sent"]:
        return "sent"
    return "received" if match["received"] else None
