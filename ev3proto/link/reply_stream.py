"""Splits the bytes from a brick into frames, and resyncs after other bytes by the counters of waiting commands.

Nothing in a stream marks the start of a frame. Some firmware answers some commands with zeros, a USB report may be
damaged, a radio may lose bytes. A reader of captures looks for the next faultless frame; a client has better evidence:
the counter of a frame that answers one of its commands.
"""

from __future__ import annotations

from collections.abc import Callable

from ev3proto.schema.frame_buffer import FrameBuffer, OutOfStep
from ev3proto.schema.header import HEADER_SIZE, Header
from ev3proto.tables.frame import GRANTED_GLOBALS, LENGTH_FIELD, MESSAGE_TYPES, MIN_LENGTH, REPLY_TYPES

LARGEST_REPLY = HEADER_SIZE + GRANTED_GLOBALS
"""Maximum size of a reply in bytes. The firmware grants more global memory than a frame of the usual size carries."""


class ReplyStream:
    """Splits a brick's bytes into frames. It keeps at most one incomplete frame."""

    def __init__(self, is_expected: Callable[[int], bool]) -> None:
        """Starts a stream; `is_expected` says whether a command with a counter waits for its reply."""
        self._is_expected = is_expected
        self._buffer = FrameBuffer(judge=_impossible, resync=self._resync, polls=False, least=HEADER_SIZE)

    @property
    def pending(self) -> bytes:
        """The bytes of the incomplete frame."""
        return self._buffer.pending

    @property
    def missing(self) -> int:
        """Missing bytes of the incomplete frame, as far as is known."""
        buffer = self._buffer
        if buffer.size is None:
            return HEADER_SIZE - len(buffer) if len(buffer) else 0
        return buffer.missing if HEADER_SIZE <= buffer.size <= LARGEST_REPLY else 0

    def feed(self, data: bytes) -> list[bytes | OutOfStep]:
        """Takes any number of bytes. Returns the frames that they complete, and the bytes between frames."""
        self._buffer.append(data)
        return list(iter(self._buffer.next, None))

    def _resync(self, data: bytearray, at: int) -> int:
        """Returns the offset of the next reply that a command waits for."""
        while len(data) - at >= HEADER_SIZE:
            _, counter, code = Header.read(data, at)
            if _impossible(data, at) is None and code in REPLY_TYPES and self._is_expected(counter):
                break
            at += 1
        return at


def _impossible(data: bytearray, at: int) -> str | None:
    length, _, code = Header.read(data, at)
    is_possible = MIN_LENGTH <= length <= LARGEST_REPLY - LENGTH_FIELD and code in MESSAGE_TYPES
    return None if is_possible else "no frame can start here"
