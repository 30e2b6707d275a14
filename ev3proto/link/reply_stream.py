"""Splits the bytes from a brick into frames, and resyncs after other bytes by the counters of waiting commands.

Nothing in a stream marks the start of a frame. Some firmware answers some commands with zeros, a USB report may be
damaged, a radio may lose bytes. A reader of captures looks for the next faultless frame; a client has better evidence:
the counter of a frame that answers one of its commands.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from ev3proto.schema.header import HEADER_SIZE, Header, frame_size
from ev3proto.tables.frame import GRANTED_GLOBALS, LENGTH_FIELD, MIN_LENGTH, MessageType

LARGEST_REPLY = HEADER_SIZE + GRANTED_GLOBALS
"""Maximum size of a reply in bytes. The firmware grants more global memory than a frame of the usual size carries."""

_TYPES = frozenset(map(int, MessageType))
_REPLIES = frozenset(int(member) for member in MessageType if not member.is_command)


@dataclass(frozen=True, slots=True)
class Garbage:
    """Bytes from the brick that belong to no frame."""

    data: bytes


class ReplyStream:
    """Splits a brick's bytes into frames. It keeps at most one incomplete frame."""

    def __init__(self, is_expected: Callable[[int], bool]) -> None:
        """Starts a stream; `is_expected` says whether a command with a counter waits for its reply."""
        self._is_expected = is_expected
        self._buffer = bytearray()
        self._in_step = True

    @property
    def pending(self) -> bytes:
        """The bytes of the incomplete frame."""
        return bytes(self._buffer)

    @property
    def missing(self) -> int:
        """Missing bytes of the incomplete frame, as far as is known."""
        buffer = self._buffer
        if len(buffer) < LENGTH_FIELD:
            return HEADER_SIZE - len(buffer) if buffer else 0
        size = frame_size(buffer)
        return size - len(buffer) if HEADER_SIZE <= size <= LARGEST_REPLY else 0

    def feed(self, data: bytes) -> list[bytes | Garbage]:
        """Takes any number of bytes. Returns the frames that they complete, and the bytes between frames."""
        buffer = self._buffer
        buffer += data
        found: list[bytes | Garbage] = []
        skipped = at = 0
        while len(buffer) - at >= HEADER_SIZE:
            if not self._can_start(at):
                self._in_step = False
                at += 1
                continue
            size = frame_size(buffer, at)
            if len(buffer) - at < size:
                break
            if at > skipped:
                found.append(Garbage(bytes(buffer[skipped:at])))
            found.append(bytes(buffer[at : at + size]))
            self._in_step = True
            at = skipped = at + size
        if at > skipped:
            found.append(Garbage(bytes(buffer[skipped:at])))
        del buffer[:at]
        return found

    def _can_start(self, at: int) -> bool:
        length, counter, code = Header.read(self._buffer, at)
        if not MIN_LENGTH <= length <= LARGEST_REPLY - LENGTH_FIELD or code not in _TYPES:
            return False
        return self._in_step or (code in _REPLIES and self._is_expected(counter))
