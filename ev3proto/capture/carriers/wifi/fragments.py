"""Reassembly of fragmented IP packets. Without I/O; contradictory lengths are ignored."""

from __future__ import annotations

import struct
from typing import NamedTuple

from ev3proto.bounded import Bounded, Budget

MOST_PACKETS = 1024
"""Maximum number of incomplete packets; the oldest are evicted."""

MOST_SECONDS = 60
"""Maximum time from the first fragment to the last, in seconds: identifications are reused."""

_NANOSECONDS = 1_000_000_000
_WAITING_SIZE = 2_000
"""Approximate memory of an incomplete packet besides its data, in bytes."""

_UNIT = 8
"""Fragments begin at multiples of this number of bytes."""

_HEAD_V4, _HEAD_V6 = struct.Struct(">BBHHHBBH"), struct.Struct(">IHBB")
_ADDRESSES_V4 = 8
_MOST_SIZE = 0xFFFF - _HEAD_V4.size - _ADDRESSES_V4
"""Maximum payload of a packet, in bytes."""


class Fragment(NamedTuple):
    """A fragment of a packet.

    addresses  the sender's and the receiver's
    identity   what all fragments of a packet have in common besides
    protocol   the number of the carried protocol
    at         offset of the data in the payload
    is_last    it is the last one
    data       the bytes
    """

    addresses: bytes
    identity: bytes
    protocol: int
    at: int
    is_last: bool
    data: bytes

    @property
    def end(self) -> int:
        """The offset after its last byte."""
        return self.at + len(self.data)

    @property
    def is_possible(self) -> bool:
        """Whether a packet can have such a fragment."""
        return bool(self.data) and self.end <= _MOST_SIZE and (self.is_last or self.end % _UNIT == 0)


class _Waiting:
    """The fragments of a packet so far."""

    __slots__ = ("_data", "_seen", "_size", "begin_ns", "protocol")

    def __init__(self, begin_ns: int) -> None:
        self.begin_ns = begin_ns
        self.protocol = 0
        self._data = bytearray()
        self._seen = 0  # a bit for each unit
        self._size: int | None = None

    @property
    def memory(self) -> int:
        """Its approximate memory in bytes."""
        return _WAITING_SIZE + len(self._data)

    def add(self, part: Fragment) -> None:
        """Takes a fragment, unless it contradicts the known end of the packet."""
        if self._size is not None and (part.end > self._size or (part.is_last and part.end < self._size)):
            return
        if part.is_last:
            if len(self._data) > part.end:
                return
            self._size = part.end
        if part.at == 0:
            self.protocol = part.protocol
        self._data.extend(bytes(max(part.end - len(self._data), 0)))
        first, count = part.at // _UNIT, -(-len(part.data) // _UNIT)
        for unit in range(first, first + count):
            # Of overlapping bytes, those captured first count.
            if not self._seen >> unit & 1:
                at = unit * _UNIT
                data = part.data[at - part.at : at - part.at + _UNIT]
                self._data[at : at + len(data)] = data
        self._seen |= ((1 << count) - 1) << first

    def whole(self) -> bytes | None:
        """Returns the payload, once it is complete."""
        if self._size is None or self._seen != (1 << -(-self._size // _UNIT)) - 1:
            return None
        return bytes(self._data)


class Fragments:
    """The incomplete packets of a capture."""

    def __init__(self, budget: Budget) -> None:
        """Starts without fragments. The budget limits their memory."""
        self._budget = budget
        self._waiting: Bounded[tuple[bytes, bytes], _Waiting] = Bounded(MOST_PACKETS)

    def add(self, part: Fragment, time_ns: int) -> bytes | None:
        """Takes a fragment and its capture time. Returns the packet that it completes, without IP options."""
        if not part.is_possible:
            return None
        key = part.addresses, part.identity
        waiting = self._waiting.get(key)
        if waiting is None or abs(time_ns - waiting.begin_ns) > MOST_SECONDS * _NANOSECONDS:
            waiting = self._begin(key, time_ns)
        waiting.add(part)
        data = waiting.whole()
        if data is None:
            self._budget.update(waiting, waiting.memory, lambda _: self._waiting.pop(key, None))
            return None
        self._forget(self._waiting.pop(key))
        return _headed(part.addresses, waiting.protocol, data)

    def _begin(self, key: tuple[bytes, bytes], time_ns: int) -> _Waiting:
        self._forget(self._waiting.pop(key, None))
        waiting = _Waiting(time_ns)
        self._forget(self._waiting.add(key, waiting))
        return waiting

    def _forget(self, waiting: _Waiting | None) -> None:
        if waiting is not None:
            self._budget.remove(waiting)


def _headed(addresses: bytes, protocol: int, data: bytes) -> bytes:
    """Returns a whole IP packet."""
    if len(addresses) == _ADDRESSES_V4:
        size = _HEAD_V4.size + _ADDRESSES_V4 + len(data)
        return _HEAD_V4.pack(0x45, 0, size, 0, 0, 64, protocol, 0) + addresses + data
    return _HEAD_V6.pack(6 << 28, len(data), protocol, 64) + addresses + data
