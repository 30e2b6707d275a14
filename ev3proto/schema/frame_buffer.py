"""The buffer that yields frames: bytes of a stream go in, in any chunks; whole frames come out. No I/O.

Every reader of a stream uses it: the decoder, the client of a brick, the virtual brick, the reader of captures, Scapy.
They differ in which headers they believe (`judge`) and in how they find the next frame after other bytes (`resync`).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import NamedTuple

from ev3proto.schema.header import frame_size, out_of_step
from ev3proto.tables.frame import LENGTH_FIELD

_POLL = bytes(LENGTH_FIELD)
_POLLS = re.compile(b"(?:%b)*" % re.escape(_POLL))

Judge = Callable[[bytearray, int], str | None]
"""Returns why no frame starts at an offset, as a sentence; None if one may. It gets at least `least` bytes."""

Resync = Callable[[bytearray, int], int]
"""Returns the first offset, from the given one on, at which a frame may start, or may once more bytes have come."""


class OutOfStep(NamedTuple):
    """What is at the front of a buffer instead of a frame.

    reason  one sentence
    data    the bytes that were skipped to the next possible frame; empty without `resync`
    """

    reason: str
    data: bytes = b""


class FrameBuffer:
    """The bytes of a stream that are not yet part of a frame.

    A poll, a length of 0 between frames, is skipped as the brick skips it. The buffer has no limit of its own: what
    `judge` believes bounds the unfinished frame, and the caller decides how much it appends.

    Attributes:
        position: The offset in the stream of the first byte.
    """

    def __init__(
        self,
        data: bytes = b"",
        *,
        judge: Judge = out_of_step,
        resync: Resync | None = None,
        polls: bool = True,
        least: int = LENGTH_FIELD,
    ) -> None:
        """Creates a buffer.

        Args:
            data: The first bytes.
            judge: The limits of a frame. By default its length: 5 to 1024 bytes, 65537 for downloads.
            resync: The way back into step. None: the buffer stays out of step until `skip` is called.
            polls: Whether polls are skipped; else `judge` decides about them.
            least: Number of bytes that `judge` needs.
        """
        self.position = 0
        self._data = bytearray(data)
        self._judge = judge
        self._resync = resync
        self._polls = polls
        self._least = least
        self._reason: str | None = None  # why it is out of step

    def __len__(self) -> int:
        return len(self._data)

    def __iter__(self) -> Iterator[bytes]:
        """Yields whole frames, up to the first bytes that are not one."""
        while isinstance(frame := self.next(), bytes):
            yield frame

    @property
    def pending(self) -> bytes:
        """The bytes that are left."""
        return bytes(self._data)

    @property
    def size(self) -> int | None:
        """The size of the frame at the front by its length field, 2 to 65537 bytes; None if that has not come."""
        return frame_size(self._data) if len(self._data) >= LENGTH_FIELD else None

    @property
    def missing(self) -> int:
        """The number of bytes that the frame at the front still needs, as far as is known."""
        return 0 if self.size is None else max(self.size - len(self._data), 0)

    @property
    def is_padding(self) -> bool:
        """Whether all that is left are zeros, such as those after the frame in a USB report."""
        return not any(self._data)

    def append(self, data: bytes) -> None:
        """Adds the next bytes of the stream."""
        self._data += data

    def skip(self, size: int) -> bytes:
        """Removes a number of bytes from the front, and returns them. A frame may start after them."""
        skipped = bytes(self._data[:size])
        del self._data[:size]
        self.position += len(skipped)
        self._reason = None
        return skipped

    def next(self) -> bytes | OutOfStep | None:
        """Removes the next frame from the buffer.

        Returns:
            A whole frame; what is there instead of one; None if more bytes are needed.
        """
        data, first = self._data, 0
        if self._reason is None:
            if self._polls and data.startswith(_POLL):
                self.skip(polls_end(data))
            if len(data) < self._least:
                return None
            self._reason = self._judge(data, 0)
            if self._reason is None:
                return self._whole()
            first = 1
        if self._resync is None:
            return OutOfStep(self._reason)
        reason, at = self._reason, self._resync(data, first)
        if at:
            lost = OutOfStep(reason, self.skip(at))
            self._reason = reason
            return lost
        return self._whole() if len(data) >= self._least else None

    def _whole(self) -> bytes | None:
        size = frame_size(self._data)
        return self.skip(size) if len(self._data) >= size else None


def polls_end(data: bytes | bytearray, at: int = 0) -> int:
    """Returns the offset after the polls at an offset: lengths of 0, which the brick skips."""
    found = _POLLS.match(data, at)
    assert found is not None
    return found.end()
