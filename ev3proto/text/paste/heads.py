"""What a text says in front of bytes: the time, and by words and arrows the direction.

`EV3 <- 0f 00 ...` is sent to the EV3 by one author and received from it by another: after an arrow, the type of the
frame decides.
"""

from __future__ import annotations

import re
from functools import cache, lru_cache
from typing import NamedTuple

from ev3proto.schema.header import HEADER_SIZE
from ev3proto.tables.frame import COMMAND_TYPES, MESSAGE_TYPES
from ev3proto.text.paste.pieces import Direction

CLOCK = r"(?:[01]?\d|2[0-3]):[0-5]\d:[0-6]\d(?:[.,]\d{1,9})?(?:Z|\s?[+-]\d\d:?\d\d)?"
"""A time of day: `12:30:45.123`, `09:12:31+01:00`."""

_TIME = rf"(?<![\w:.])(?:\d{{4}}[-/]\d\d[-/]\d\d[T ]\s?)?(?=\d\d:){CLOCK}(?=[\])>:;,]?(?:\s|$))"
_SENT = (
    r"sent|send|sending|sends|sendto|sendmsg|tx|write|writes|writing|wrote|written|request|command"
    r"|transmit(?:s|ted|ting)?|outgoing|outbound|out(?=\s?[:>\]])|to\s(?:the\s)?(?:ev3|brick|robot)"
)
_RECEIVED = (
    r"received|receive|receiving|receives|recv|recvfrom|recvmsg|rx|read|reads|reading|reply|response|answer"
    r"|got|incoming|inbound|in(?=\s?[:\]])|from\s(?:the\s)?(?:ev3|brick|robot)"
)
# Arrows also compare, shift and map: `=>` counts right in front of bytes only, `<` at the start of a line.
_ARROW = (
    r"(?<![<>=-])(?:->|-->|→|<-|<--|←|(?:>>>?|<<<?)(?=\s))(?![<>=-])"
    r"|(?<![\w\]\"'<>=-])(?<![\d\]\"']\s)(?:=>|<=)(?=\W{0,4}(?:0[xX]\|)?$)|^\s*[<>](?=\s)"
)
# socat, hcidump and btmon mark the lines above the bytes; a Bluetooth adapter receives what the computer sends.
_MARK = r"^\s{0,3}[<>]\s(?P<adapter>ACL\b)"
_BESIDE = (
    r"\b(?:debug|info|notice|warning|error|trace|data|raw|hex|frame|packet|payload|message"
    r"|bytearray|(?:\d{1,7}\s{1,4})?bytes?)\b"
)
_LABEL = re.compile(
    r"(?<![\w.])(?:\d{1,3}(?:\.\d{1,3}){3}(?::\d+)?|[\da-f]{2}(?:[:-][\da-f]{2}){5}|(?<=\()\d{1,5}(?=,)"
    r"|/?[^\W\d](?<!\d\s[vdiwef])[\w./@-]*+(?<=\w)(?>(?:[ #:]\d{1,3}(?![\w.]|:\d))?)(?!\((?!\s*\d)))",
    re.IGNORECASE,
)
"""A part of a label: an address, a file number in a call of C, a word with a number; no level of logcat."""
_LEVEL = re.compile("^[VDIWEF]/")
_NO_LABEL = re.compile(
    r"(?i:to|from|by|via|on|at|for|with|the|log|debug|info|notice|warn(?:ing)?|error|trace|verbose|data|raw|hex|bytes?"
    r"|bytearray|buffer|uint8array|len(?:gth)?|size|frame|packet|payload|message)"
)
_MOST_LABEL = 4
"""Words of a label; prose has more."""
_MOST_HEAD = 200
"""Characters of a line without bytes that speaks of the next lines."""
_MOST_DATE = 16
"""Columns of a date in front of a time, in any format."""


class _Patterns(NamedTuple):
    time: re.Pattern[str]
    direction: re.Pattern[str]
    beside: re.Pattern[str]


@cache
def _patterns() -> _Patterns:
    # Compiled for the first line that has more than bytes.
    return _Patterns(
        re.compile(_TIME, re.ASCII),
        re.compile(
            rf"{_MARK}|(?P<sent>(?<![a-z])(?:{_SENT})(?![a-z]))|(?P<received>(?<![a-z])(?:{_RECEIVED})(?![a-z]))"
            rf"|(?P<arrow>{_ARROW})",
            re.IGNORECASE,
        ),
        re.compile(_BESIDE, re.IGNORECASE),
    )


class Head(NamedTuple):
    """What is said of bytes. An arrow says only that it is the one or the other; a label names the connection."""

    direction: Direction | None = None
    time: str | None = None
    arrow: str = ""
    label: str | None = None


NO_HEAD = Head()


@lru_cache(64)
def head_of(text: str) -> Head:
    """Returns what a text in front of bytes says; it is asked several times for those that are nearly a frame."""
    if not text.strip():
        return NO_HEAD
    patterns = _patterns()
    time, word = patterns.time.search(text), patterns.direction.search(text)
    direction: Direction | None = None
    arrow = ""
    if word is not None and word["adapter"]:
        direction = "sent" if word[0].lstrip()[0] == "<" else "received"
    elif word is not None and word["arrow"]:
        arrow = word[0].strip()
    elif word is not None:
        direction = "sent" if word["sent"] else "received"
    return Head(direction, time and time[0], arrow, _label_in(text, time, word))


def _label_in(text: str, time: re.Match[str] | None, word: re.Match[str] | None) -> str | None:
    """Returns what a text names beside the direction, such as `leader` or `/dev/rfcomm0`, without times and levels."""
    if word is None:
        return None
    for found in (time, word):
        text = text if found is None else text[: found.start()] + "\n" * len(found[0]) + text[found.end() :]
    parts = [_LEVEL.sub("", part) for part in _LABEL.findall(text) if not _NO_LABEL.fullmatch(part)]
    if word["arrow"]:
        parts.sort()  # `PC -> A` and `A -> PC`
    return " ".join(parts) if 0 < len(parts) <= _MOST_LABEL else None


def announced(line: str) -> Head:
    """Returns what a line without bytes says of the next lines, as in `12:30:45 Sending:`."""
    if len(line) > _MOST_HEAD:
        return NO_HEAD
    head = head_of(line)
    if head == NO_HEAD or line.rstrip().endswith(":"):
        return head
    if head.time is not None and line.find(head.time) < _MOST_DATE:
        return head
    return head if is_head(line) or line.lstrip()[:1] in "<>" else NO_HEAD


def is_head(text: str) -> bool:
    """Returns whether a text says a time or a direction and hardly more, as loggers do in front of bytes."""
    patterns = _patterns()
    rest = text
    for pattern in patterns:
        rest = pattern.sub(" ", rest)
    return not rest.strip(" \t[({])}\"'`:;,|<>=-0xX")


def direction_of(data: bytes, head: Head) -> Direction | None:
    """Returns which way a frame went; None where the text does not say."""
    if head.direction is not None or not head.arrow:
        return head.direction
    code = data[HEADER_SIZE - 1] if len(data) >= HEADER_SIZE else -1
    if code in MESSAGE_TYPES:
        return "sent" if code in COMMAND_TYPES else "received"
    return "sent" if ">" in head.arrow else "received"
