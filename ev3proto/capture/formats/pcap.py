"""pcap files: both byte orders, times in micro- or nanoseconds.

https://www.ietf.org/archive/id/draft-ietf-opsawg-pcap-04.html
"""

from __future__ import annotations

import struct
from collections.abc import Iterator
from operator import itemgetter
from typing import BinaryIO

from ev3proto.capture.packets import Format, Interface, Packet, begins_with, records
from ev3proto.capture.record import CaptureError

MICROSECONDS, NANOSECONDS = 0xA1B2C3D4, 0xA1B23C4D
"""The first four bytes in the byte order of the file, which tell the unit of times."""

HEADER = "IHHIIII"
"""The header of the file: magic, version in two parts, time zone, accuracy, largest packet, link type."""

PACKET_HEAD = "IIII"
"""The header of a packet: seconds, fraction, captured length, size."""

# The upper bits of the field tell whether Ethernet packets have their checksum.
_LINK_MASK = 0xFFFF


def packets(stream: BinaryIO) -> Iterator[Packet]:
    """Yields the packets of a file. Raises CaptureError for a damaged one, after everything readable."""
    size = struct.calcsize("<" + HEADER)
    head = stream.read(size)
    if len(head) < size:
        raise CaptureError("the file is cut off in its header")
    order = "<" if int.from_bytes(head[:4], "little") in (MICROSECONDS, NANOSECONDS) else ">"
    magic, *_, link = struct.unpack(order + HEADER, head)
    unit = 1 if magic == NANOSECONDS else 1000
    interface = Interface(link & _LINK_MASK, None, order)
    for number, (seconds, fraction, _, on_wire), data in records(
        stream, struct.Struct(order + PACKET_HEAD), len(head), itemgetter(2)
    ):
        yield Packet(number, seconds * 1_000_000_000 + fraction * unit, data, on_wire, interface)


FORMAT = Format(
    "pcap",
    (".pcap", ".cap"),
    4,
    begins_with(*(magic.to_bytes(4, order) for magic in (MICROSECONDS, NANOSECONDS) for order in ("big", "little"))),
    packets,
)
