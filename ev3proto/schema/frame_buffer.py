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
        self._lost: OutOfStep | None = None  # why it is out of step

    def __len__(self) -> int:
        return len(self._data)

    def __getitem__(self, part: slice) -> bytes:
        return bytes(self._data[part])

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

    def append(self, data: bytes) -> None:
        """Adds the next bytes of the stream."""
        self._data += data

    def skip(self, size: int) -> bytes:
        """Removes a number of bytes from the front, and returns them. A frame may start after them."""
        skipped = bytes(self._data[:size])
        del self._data[:size]
        self.position += len(skipped)
        self._lost = None
        return skipped

    def look(self, at: int = 0) -> int | OutOfStep | None:
        """Looks at an offset, and removes nothing.

        Returns:
            The offset after the frame there, which may be more than there is; why it is not a frame; None if more bytes
            are needed to tell.
        """
        data = self._data
        if len(data) - at < self._least:
            return None
        reason = self._judge(data, at)
        return at + frame_size(data, at) if reason is None else OutOfStep(reason)

    def next(self) -> bytes | OutOfStep | None:
        """Removes the next frame from the buffer.

        Returns:
            A whole frame; what is there instead of one; None if more bytes are needed.
        """
        if self._lost is not None:
            return self._search(0)
        if self._polls and self._data.startswith(_POLL):
            self.skip(polls_end(self._data))
        end = self.look()
        if isinstance(end, OutOfStep):
            self._lost = end
            return self._search(1)
        return None if end is None or end > len(self._data) else self.skip(end)

    def _search(self, first: int) -> bytes | OutOfStep | None:
        """Removes the bytes before the next possible frame, or this frame if there are none."""
        lost = self._lost
        assert lost is not None
        if self._resync is None:
            return lost
        at = self._resync(self._data, first)
        if at:
            skipped = self.skip(at)
            self._lost = lost
            return lost._replace(data=skipped)
        whole = len(self._data) >= self._least and self.missing == 0
        return self.skip(frame_size(self._data)) if whole else None


def polls_end(data: bytes | bytearray, at: int = 0) -> int:
    """Returns the offset after the polls at an offset: lengths of 0, which the brick skips."""
    found = _POLLS.match(data, at)
    assert found is not None
    return found.end()
