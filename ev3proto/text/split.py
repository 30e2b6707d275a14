"""What was pasted, cut into frames: usually one, sometimes several, sometimes one with padding after it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from ev3proto.messages import Message
from ev3proto.schema.frame import parse
from ev3proto.schema.header import frame_size, is_frame_size
from ev3proto.tables.frame import LENGTH_FIELD, REPORT_SIZES


class Piece(NamedTuple):
    """A message out of pasted bytes; `padding` bytes without meaning followed it."""

    message: Message
    padding: int = 0


def split(data: bytes, *, dialect: str = "official") -> Iterator[Piece]:
    """The messages in pasted bytes. Never raises; what is wrong stands in each message's fault."""
    first = next(_ends(data), 0)
    if first < max(_ends(data), default=0) == len(data):
        start = 0
        for end in _ends(data):
            yield Piece(parse(data[start:end], strict=False, dialect=dialect))
            start = end
        return
    if 0 < first < len(data) and (len(data) in REPORT_SIZES or not any(data[first:])):
        yield Piece(parse(data[:first], strict=False, dialect=dialect), len(data) - first)
        return
    yield Piece(parse(data, strict=False, dialect=dialect))


def _ends(data: bytes) -> Iterator[int]:
    """Where the frames end when each starts where the one before ended."""
    at = 0
    while at + LENGTH_FIELD <= len(data):
        size = frame_size(data, at)
        at += size
        if not is_frame_size(size) or at > len(data):
            return
        yield at
