"""Which packets carried which bytes of a TCP stream that Wireshark has put in order, and which bytes were in vain.

Wireshark names for each packet the pieces of which it made reassembled buffers, and how long those are. Frames and
texts stand in these one after the other, then in what is left of the packet itself.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from ev3proto.capture.wireshark.row import Row

MOST_WAITING = 4096
"""Packets of one direction whose bytes are waited for; a stream of which a packet is missing never gets further."""

WAITING_SIZE = 250
"""Bytes of memory that such a packet takes, about."""

_WRAP = 1 << 32


@dataclass(slots=True)
class Waiting:
    """A packet of which bytes stand in no frame so far.

    number   the packet's number
    start    sequence number of the first of these bytes
    stop     sequence number after the last one
    time_ns  when it was captured
    """

    number: int
    start: int
    stop: int
    time_ns: int


@dataclass(slots=True)
class _Buffer:
    """A buffer that is being read.

    numbers  the packets of which it is made, in the order of their bytes; some may have the same bytes
    start    sequence number of its first byte, None where it is not known
    size     bytes in it
    at       where the next frame starts
    """

    numbers: list[int]
    start: int | None
    size: int
    at: int = 0


class Origin(NamedTuple):
    """Where a frame or text comes from.

    numbers  the packets that carried it, in the order of its bytes
    time_ns  when the last of them was captured
    """

    numbers: tuple[int, ...]
    time_ns: int


class Segments:
    """One direction of a connection: the packets whose bytes wait for the frame to be whole that they belong to."""

    __slots__ = ("_done", "waiting")

    def __init__(self) -> None:
        self._done = 0  # sequence number after the last byte of a frame
        self.waiting: dict[int, Waiting] = {}

    def origins(self, row: Row, sizes: list[int]) -> list[Origin]:
        """Where frames and texts of those sizes, in their order, come from."""
        self._remember(row)
        buffers = self._buffers(row)
        found: list[Origin] = []
        for size in sizes:
            while buffers and buffers[0].at + size > buffers[0].size:
                buffers.pop(0)
            if buffers:
                found.append(self._take(buffers[0], size, row.time_ns))
            else:
                found.append(Origin((row.packet,), row.time_ns))
                entry = self.waiting.get(row.packet)
                if entry is not None:
                    self._done = max(entry.start, self._done) + size
                    self._forget(row.packet)
        return found

    def lost(self) -> tuple[int, list[int], int]:
        """How many bytes stand in no frame, the packets they are in, and when the first of those was captured.

        What came again after it stood in a frame is not lost.
        """
        size, numbers, time_ns, reached = 0, [], 0, self._done
        for entry in sorted(self.waiting.values(), key=lambda entry: entry.start):
            new = entry.stop - max(reached, entry.start)
            if new > 0:
                reached = entry.stop
                size += new
                numbers.append(entry.number)
                time_ns = min(time_ns or entry.time_ns, entry.time_ns)
        return size, sorted(numbers), time_ns

    def _remember(self, row: Row) -> None:
        length = (row.number("tcp.len") or 0) - row.missing
        start = row.number("tcp.seq") or 0
        # Wireshark counts from the start of the connection, yet in 32 bits.
        start += round((self._done - start) / _WRAP) * _WRAP
        if start + length > self._done:
            self.waiting[row.packet] = Waiting(row.packet, start, start + length, row.time_ns)

    def _buffers(self, row: Row) -> list[_Buffer]:
        segments = row.numbers("tcp.segment")
        if not segments:
            return []
        lengths = row.numbers("tcp.reassembled.length")
        counts = row.numbers("tcp.segment.count")
        if len(counts) != len(lengths) or sum(counts) != len(segments):
            return [_Buffer(segments, None, sum(lengths))]
        found = []
        for count, length in zip(counts, lengths, strict=True):
            numbers, segments = segments[:count], segments[count:]
            first = self.waiting.get(numbers[0])
            found.append(_Buffer(numbers, None if first is None else max(first.start, self._done), length))
        return found

    def _take(self, buffer: _Buffer, size: int, now_ns: int) -> Origin:
        """Where the next bytes of a buffer come from, which is read now."""
        if buffer.start is None:
            buffer.at += size
            return Origin(tuple(buffer.numbers), now_ns)
        at, stop = buffer.start + buffer.at, buffer.start + buffer.at + size
        buffer.at += size
        used = []
        for number in buffer.numbers:
            entry = self.waiting.get(number)
            if entry is not None and entry.start <= at < min(entry.stop, stop):
                used.append(entry)
                at = entry.stop
        self._done = max(self._done, stop)
        for number in buffer.numbers:
            self._forget(number)
        if not used:
            return Origin(tuple(buffer.numbers), now_ns)
        return Origin(tuple(entry.number for entry in used), max(entry.time_ns for entry in used))

    def _forget(self, number: int) -> None:
        """Forgets what stands in frames now."""
        entry = self.waiting.get(number)
        if entry is None:
            return
        entry.start = max(entry.start, self._done)
        if entry.start >= entry.stop:
            del self.waiting[number]
