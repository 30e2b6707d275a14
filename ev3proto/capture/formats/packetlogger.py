"""PacketLogger files (.pklg): Bluetooth traffic as a Mac records it, and an iPhone or iPad through it."""

from __future__ import annotations

import struct
from collections.abc import Callable, Iterator
from io import BufferedReader
from typing import Any

from ev3proto.capture.packets import Format, Interface, Packet, records, without_magic
from ev3proto.tables.carriers import Link

_RECORDS = {order: struct.Struct(f"{order}IIIB") for order in "><"}
"""A record in both byte orders: the number of bytes that follow the length, seconds, microseconds, kind."""

_SIZE = _RECORDS[">"].size

_NEEDED = _SIZE + 4
"""Bytes that tell whether a file has this format: the first record, and the header of the packet in it."""

_LENGTH, _SECOND = 4, 1_000_000
_LEAST, _MOST = _SIZE - _LENGTH, 0xFFFF
_OLDEST = 978_307_200
"""Seconds since 1970 of the beginning of 2001: the program is younger."""

_COMMAND, _DATA, _EVENT = 1, 2, 4
_KINDS = {0: (_COMMAND, 0), 1: (_EVENT, 1), 2: (_DATA, 0), 3: (_DATA, 1)}
"""By kind: the packet type of HCI, and 1 for a received packet."""

_OTHERS = {8, 9, 10, 11, *range(0xF7, 0xFF)}
"""Kinds of other records: sound, link management, texts, notes."""

# The size of a packet by its first bytes, for each kind.
_SIZES: dict[int, Callable[[bytes], int]] = {
    0: lambda head: 3 + head[2],
    1: lambda head: 2 + head[1],
    2: lambda head: 4 + head[2] + 256 * head[3],
}
_SIZES[3] = _SIZES[2]

_direction = struct.Struct(">IB")


def _order_of(head: bytes) -> str | None:
    """Returns the byte order of a file by the head of its first record; None for other files."""
    for order, record in _RECORDS.items() if len(head) >= _NEEDED else ():
        length, seconds, microseconds, kind = record.unpack_from(head)
        is_time = seconds >= _OLDEST and microseconds < _SECOND
        size = _SIZES[kind](head[_SIZE:]) if kind in _SIZES else length - _LEAST
        # A file of hcidump begins like this, but for the lengths.
        is_size = _LEAST <= length <= _MOST and length - _LEAST == size
        if is_size and is_time and (kind in _KINDS or kind in _OTHERS):
            return order
    return None


def packets(stream: BufferedReader[Any]) -> Iterator[Packet]:
    """Yields the packets of a file. Raises CaptureError for a damaged one, after everything readable."""
    interface = Interface(Link.HCI_WITH_DIRECTION)
    record = _RECORDS[_order_of(stream.peek(_NEEDED)) or ">"]
    for number, (size, seconds, microseconds, kind), data in records(stream, record, 0, lambda head: head[0] - _LEAST):
        kind_of_packet, is_received = _KINDS.get(kind, (0, 0))
        head = _direction.pack(is_received, kind_of_packet)
        time_ns = (seconds * _SECOND + microseconds) * 1000
        yield Packet(number, time_ns, head + data, len(head) + size - _LEAST, interface)


FORMAT = Format("pklg", (".pklg",), _NEEDED, without_magic(_NEEDED, lambda head: _order_of(head) is not None), packets)
