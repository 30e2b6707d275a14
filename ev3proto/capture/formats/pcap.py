"""pcap files: both byte orders, times in micro- or nanoseconds.

https://www.ietf.org/archive/id/draft-ietf-opsawg-pcap-04.html
"""

from __future__ import annotations

import io
import struct
from collections.abc import Iterator

from ev3proto.capture.packets import MOST_PACKET, Format, Interface, Packet, begins_with
from ev3proto.capture.record import CaptureError

MICROSECONDS, NANOSECONDS = 0xA1B2C3D4, 0xA1B23C4D
"""The first four bytes in the byte order of the file, which tell the unit of times."""

HEADER = "IHHIIII"
"""The header of the file: magic, version in two parts, time zone, accuracy, largest packet, link type."""

PACKET_HEAD = "IIII"
"""The header of a packet: seconds, fraction, captured length, size."""

# The upper bits of the field tell whether Ethernet packets have their checksum.
_LINK_MASK = 0xFFFF

_PIECE = 1 << 16


def packets(stream: io.BufferedIOBase) -> Iterator[Packet]:
    """Yields the packets of a file. Raises CaptureError for a damaged one, after everything readable."""
    size = struct.calcsize("<" + HEADER)
    head = stream.read(size)
    if len(head) < size:
        raise CaptureError("the file is cut off in its header")
    order = "<" if int.from_bytes(head[:4], "little") in (MICROSECONDS, NANOSECONDS) else ">"
    magic, *_, link = struct.unpack(order + HEADER, head)
    unit = 1 if magic == NANOSECONDS else 1000
    interface = Interface(link & _LINK_MASK, None, order)
    head_layout = struct.Struct(order + PACKET_HEAD)
    size, unpack_from = head_layout.size, head_layout.unpack_from
    # Packets are cut out of large chunks: a read for each packet and each header takes twice as long.
    number, offset, piece, at = 0, len(head), b"", 0
    while True:
        start = at + size
        if start > len(piece):
            offset += at
            piece, at, start = _continued(stream, piece[at:], size), 0, size
            if not piece:
                return
            if start > len(piece):
                raise CaptureError(f"the file is cut off in the header of packet {number + 1}, at offset {offset}")
        number += 1
        seconds, fraction, length, on_wire = unpack_from(piece, at)
        time_ns = seconds * 1_000_000_000 + fraction * unit
        end = start + length
        if end > len(piece):
            if length > MOST_PACKET:
                raise CaptureError(
                    f"the file is damaged at offset {offset + at}: packet {number} would have {length} bytes; what"
                    " follows cannot be read"
                )
            offset += start
            piece, start, end = _continued(stream, piece[start:], length), 0, length
            if end > len(piece):
                yield Packet(number, time_ns, piece, on_wire, interface)
                raise CaptureError(
                    f"the file is cut off in packet {number}: {len(piece)} of its {length} bytes are there"
                )
        yield Packet(number, time_ns, piece[start:end], on_wire, interface)
        at = end


def _continued(stream: io.BufferedIOBase, rest: bytes, needed: int) -> bytes:
    """Returns the rest of a chunk with the next bytes: at least the needed number, unless the file ends."""
    piece = rest + stream.read1(_PIECE)
    return piece if len(piece) >= needed else piece + stream.read(needed - len(piece))


FORMAT = Format(
    "pcap",
    (".pcap", ".cap"),
    4,
    begins_with(*(magic.to_bytes(4, order) for magic in (MICROSECONDS, NANOSECONDS) for order in ("big", "little"))),
    packets,
)
