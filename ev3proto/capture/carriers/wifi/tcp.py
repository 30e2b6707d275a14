"""A byte stream out of TCP segments: lost, repeated, overlapping and reordered ones put in order.

No I/O and no packets: somebody else knows where segments come from.
"""

from __future__ import annotations

from bisect import insort
from operator import itemgetter
from typing import NamedTuple

from ev3proto.capture.carriers.streams import Piece

MOST_AHEAD = 1 << 20
"""Bytes that wait at most for what belongs before them: more than any brick's window."""

MOST_SEGMENTS_AHEAD = 4096
"""Segments that wait at most."""

MOST_AWAY = 1 << 24
"""Bytes that a segment is at most away from where the stream continues. Further away is another connection between the
same ports, whose beginning is not in the capture."""

SEGMENT_SIZE = 250
"""Bytes of memory that a segment takes while it waits, besides its data, about."""

_HALF, _MASK = 1 << 31, (1 << 32) - 1
_MOST_HOLES = 64
_offset_of = itemgetter(0)


class Hole(NamedTuple):
    """Bytes that are not in the capture: so many, before whatever comes next. 0 where their number is not known."""

    missing: int


class Late(NamedTuple):
    """Bytes that came when the stream had already continued without them."""

    data: bytes


class Reassembly:
    """One direction of a connection.

    `start` is the sequence number of its first byte, None for a capture that began in the middle of the connection:
    then the first bytes seen are the start.

    acknowledged  the number before which the other side has everything, None where it did not say so
    repeated      bytes that came again, so far
    """

    __slots__ = ("_ahead", "_holes", "_position", "_start", "_waiting", "acknowledged", "repeated")

    def __init__(self, start: int | None = None) -> None:
        self._start = start
        self._position = 0
        self.acknowledged: int | None = None
        self._ahead: list[tuple[int, Piece]] = []  # with their offsets in the stream
        self._waiting = 0
        self._holes: list[tuple[int, int]] = []
        self.repeated = 0

    def _offset(self, sequence: int) -> int:
        """Where in the stream a sequence number is: of all places that have it, the nearest to where it continues."""
        assert self._start is not None
        difference = (sequence - self._start - self._position) & _MASK
        return self._position + (difference - (1 << 32) if difference >= _HALF else difference)

    @property
    def waiting(self) -> int:
        """Bytes of memory that what waits takes, about."""
        return self._waiting + SEGMENT_SIZE * len(self._ahead)

    def takes_next(self, sequence: int, piece: Piece) -> bool:
        """Whether a segment is what comes next while nothing waits. If so, it is taken with this."""
        start = self._start
        if start is None or self._ahead or sequence != start + self._position & _MASK:
            return False
        self._position += len(piece.data) + piece.missing
        return True

    def add(self, sequence: int, piece: Piece) -> list[Piece | Hole | Late]:
        """What can be said of the stream with this segment, in order: its next bytes, holes in it, bytes too late."""
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
            # By the offset alone: of two that differ the one that was captured first is believed.
            insort(self._ahead, (at, piece._replace(data=data)), key=_offset_of)
            self._waiting += len(data)
            self._go_on(found)
        return found

    def acknowledge(self, sequence: int) -> list[Piece | Hole | Late]:
        """The other side has everything before this sequence number: what is missing of it will not come any more."""
        self.acknowledged = sequence
        found: list[Piece | Hole | Late] = []
        if self._ahead:
            self._go_on(found)
        return found

    def end(self) -> list[Piece | Hole | Late]:
        """Nothing more will come: all that waited, with the holes in it."""
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
        """Bytes that the stream is already past: they came again, or are from a hole or before the start."""
        end = at + len(data)
        for start, stop in ((min(at, 0), 0), *self._holes):
            first, last = max(start, at), min(stop, end)
            if first < last:
                found.append(Late(data[first - at : last - at]))
                self.repeated -= last - first
        self.repeated += len(data)

    def _go_on(self, found: list[Piece | Hole | Late]) -> None:
        """Gives what is in order now; a hole is left where what is missing cannot come any more."""
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
        """Whether what is missing before an offset will not come any more."""
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
