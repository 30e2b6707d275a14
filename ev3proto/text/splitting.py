"""The messages in pasted bytes: one frame, several, and what follows them: padding, left-over bytes of a report."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

from ev3proto.messages import Message
from ev3proto.schema.frame import frame_reader, parse
from ev3proto.schema.frame_buffer import FrameBuffer
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.semantics.mangled import mangled
from ev3proto.tables.frame import MESSAGE_TYPES, REPLY_TYPES, REPORT_SIZES


class Piece(NamedTuple):
    """A message out of pasted bytes, the offset of its frame, and the bytes behind it that have no meaning."""

    message: Message
    start: int = 0
    rest: bytes = b""


def split(data: bytes, *, dialect: str = "official") -> Iterator[Piece]:
    """Yields the messages in pasted bytes. Never raises; each message's fault says what is wrong with it."""
    ends = list(_ends(data)) or [len(data)]
    if ends[-1] < len(data) and not _is_left_over(data, ends, dialect):
        # The last length is too small.
        ends[-1] = len(data)
    for start, end in pairwise((0, *ends)):
        rest = data[end:] if end == ends[-1] else b""
        yield Piece(parse(data[start:end], strict=False, dialect=dialect), start, rest)


def _is_left_over(data: bytes, ends: list[int], dialect: str) -> bool:
    """Whether the bytes behind the last frame have no meaning: zeros, or what was in the buffer of a report before."""
    if not any(data[ends[-1] :]) or len(data) in REPORT_SIZES:
        return True
    start = ends[-2] if len(ends) > 1 else 0
    return data[start + HEADER_SIZE - 1] in REPLY_TYPES and mangled(data[start:], frame_reader(dialect)) is None


def frame_ends(data: bytes) -> list[int] | None:
    """Returns where the frames end of which data consists; None if it is one frame, or anything else is in it."""
    ends = list(_ends(data))
    return ends if len(ends) > 1 and ends[-1] == len(data) else None


def _ends(data: bytes) -> Iterator[int]:
    """Yields where the frames end when each starts where the one before ended."""
    buffer, at = FrameBuffer(data), 0
    while isinstance(end := buffer.look(at), int) and end <= len(data):
        yield end
        if len(data) >= end + HEADER_SIZE and data[end + HEADER_SIZE - 1] not in MESSAGE_TYPES:
            return
        at = end
