"""The messages in pasted bytes: one frame, several, or one with padding after it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from ev3proto.messages import Message
from ev3proto.schema.frame import parse
from ev3proto.schema.header import frame_size, may_have_length
from ev3proto.tables.frame import LENGTH_FIELD, REPORT_SIZES


class Piece(NamedTuple):
    """A message out of pasted bytes; `padding` bytes without meaning followed it."""

    message: Message
    padding: int = 0


def split(data: bytes, *, dialect: str = "official") -> Iterator[Piece]:
    """Yields the messages in pasted bytes. Never raises; each message's fault says what is wrong with it."""
    ends = frame_ends(data)
    first = next(_ends(data), 0)
    if ends is not None:
        start = 0
        for end in ends:
            yield Piece(parse(data[start:end], strict=False, dialect=dialect))
            start = end
    elif 0 < first < len(data) and (len(data) in REPORT_SIZES or not any(data[first:])):
        yield Piece(parse(data[:first], strict=False, dialect=dialect), len(data) - first)
    else:
        yield Piece(parse(data, strict=False, dialect=dialect))


def frame_ends(data: bytes) -> Iterator[int] | None:
    """Returns where the frames end of which data consists; None if it is one frame, or anything else is in it."""
    return _ends(data) if next(_ends(data), 0) < max(_ends(data), default=0) == len(data) else None


def _ends(data: bytes) -> Iterator[int]:
    """Yields where the frames end when each starts where the one before ended."""
    at = 0
    while at + LENGTH_FIELD <= len(data):
        is_frame = may_have_length(data, at)
        at += frame_size(data, at)
        if not is_frame or at > len(data):
            return
        yield at
