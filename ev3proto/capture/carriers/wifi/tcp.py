"""Reassembly of a byte stream from TCP segments: lost, repeated, overlapping and reordered ones. Without I/O."""

from __future__ import annotations

from bisect import insort
from operator import itemgetter
from typing import NamedTuple

from ev3proto.capture.carriers.streams import Piece

MOST_AHEAD = 1 << 20
"""Maximum number of bytes that wait for earlier ones: more than any brick's window."""

MOST_SEGMENTS_AHEAD = 4096
"""Maximum number of waiting segments."""

MOST_AWAY = 1 << 24
"""Maximum distance of a segment from the stream's position, in bytes. Farther segments belong to another connection
between the same ports, whose beginning was not captured."""

SEGMENT_SIZE = 250
"""Approximate memory of a waiting segment besides its data, in bytes."""

_HALF, _MASK = 1 << 31, (1 << 32) - 1
_MOST_HOLES = 64
_offset_of = itemgetter(0)


class Hole(NamedTuple):
    """A number of bytes that are not in the capture; 0 if it is unknown."""

    missing: int


class Late(NamedTuple):
    """Bytes that came after the stream had continued without them."""

    data: bytes


class Reassembly:
    """One direction of a connection.

    `start` is the sequence number of its first byte; None if the capture begins later, and the first bytes seen are the
    start.
    """

    __slots__ = ("_ahead", "_holes", "_position", "_start", "_waiting", "acknowledged", "repeated")

    def __init__(self, start: int | None = None) -> None:
        self._start = start
        self._position = 0
        self.acknowledged: int | None = None  # the number before which the receiver has everything; None if unknown
        self._ahead: list[tuple[int, Piece]] = []  # with their offsets in the stream
        self._waiting = 0
        self._holes: list[tuple[int, int]] = []
        self.repeated = 0  # number of repeated bytes so far

    def _offset(self, sequence: int) -> int:
        """Returns the offset of a sequence number, the nearest one to the position."""
        assert self._start is not None
        difference = (sequence - self._start - self._position) & _MASK
        return self._position + (difference - (1 << 32) if difference >= _HALF else difference)

    @property
    def waiting(self) -> int:
        """Approximate memory of the waiting segments."""
        return self._waiting + SEGMENT_SIZE * len(self._ahead)

    def takes_next(self, sequence: int, piece: Piece) -> bool:
        """Takes a segment if it comes next and none waits. Returns whether it was taken."""
        start = self._start
        if start is None or self._ahead or sequence != start + self._position & _MASK:
            return False
        self._position += len(piece.data) + piece.missing
        return True

    def add(self, sequence: int, piece: Piece) -> list[Piece | Hole | Late]:
        """Takes a segment. Returns what follows in the stream: bytes, holes, and bytes that came too late."""
        if self._start is None:
            self._start = sequence
        at, data = self._offset(sequence), piece.data
        if self.takes_next(sequence, piece):
            return [piece]
        if abs(at - self._position) > MOST_AWAY:
            return [*self.end(), *self._start_again(sequence), *self.add(sequence, piece)]
        found: list[Piece | Hole | Late] = []
        if at < self._position:
            self._look_back(at, data[: self._position - at], found)
            data = data[self._position - at :]
            at = self._position
        if data:
            # Sorted by offset only: if two segments differ, the one captured first counts.
            insort(self._ahead, (at, piece._replace(data=data)), key=_offset_of)
            self._waiting += len(data)
            self._go_on(found)
        return found

    def acknowledge(self, sequence: int) -> list[Piece | Hole | Late]:
        """Takes an acknowledgement: missing bytes before it will not come any more."""
        self.acknowledged = sequence
        found: list[Piece | Hole | Late] = []
        if self._ahead:
            self._go_on(found)
        return found

    def end(self) -> list[Piece | Hole | Late]:
        """Ends the stream. Returns the waiting bytes, with holes."""
        found: list[Piece | Hole | Late] = []
        while self._ahead:
            self._leave_hole(found)
            self._go_on(found)
        return found

    def _start_again(self, sequence: int) -> list[Piece | Hole | Late]:
        self._start, self._position, self.acknowledged = sequence, 0, None
        self._holes.clear()
        return [Hole(0)]

    def _look_back(self, at: int, data: bytes, found: list[Piece | Hole | Late]) -> None:
        """Takes bytes before the position: repeated ones, or late ones that fill a hole or precede the start."""
        end = at + len(data)
        for start, stop in ((min(at, 0), 0), *self._holes):
            first, last = max(start, at), min(stop, end)
            if first < last:
                found.append(Late(data[first - at : last - at]))
                self.repeated -= last - first
        self.repeated += len(data)

    def _go_on(self, found: list[Piece | Hole | Late]) -> None:
        """Appends what is in order now, and holes where missing bytes cannot come any more."""
        ahead = self._ahead
        while ahead:
            at, piece = ahead[0]
            if at > self._position:
                if not self._is_lost(at):
                    return
                self._leave_hole(found)
            del ahead[0]
            self._waiting -= len(piece.data)
            data = piece.data[self._position - at :]
            self.repeated += len(piece.data) - len(data)
            if data:
                found.append(piece._replace(data=data))
                self._position += len(data) + piece.missing

    def _is_lost(self, at: int) -> bool:
        """Returns whether the missing bytes before an offset cannot come any more."""
        if self._waiting > MOST_AHEAD or len(self._ahead) > MOST_SEGMENTS_AHEAD:
            return True
        return self.acknowledged is not None and self._offset(self.acknowledged) >= at

    def _leave_hole(self, found: list[Piece | Hole | Late]) -> None:
        at, _ = self._ahead[0]
        if at > self._position:
            found.append(Hole(at - self._position))
            self._holes.append((self._position, at))
            del self._holes[:-_MOST_HOLES]
            self._position = at
