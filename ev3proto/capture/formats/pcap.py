"""pcap files: both byte orders, times in micro- or nanoseconds. dpkt knows the headers."""

from __future__ import annotations

import struct
from collections.abc import Iterator
from typing import BinaryIO

from dpkt import pcap

from ev3proto.capture.packets import MOST_PACKET, Interface, Packet
from ev3proto.capture.record import CaptureError

_NANO = (pcap.TCPDUMP_MAGIC_NANO, pcap.PMUDPCT_MAGIC_NANO)
_SWAPPED = (pcap.PMUDPCT_MAGIC, pcap.PMUDPCT_MAGIC_NANO, pcap.PACPDOM_MAGIC)

# The upper bits of the field say whether Ethernet packets have their check sum.
_LINK_MASK = 0xFFFF


def packets(stream: BinaryIO) -> Iterator[Packet]:
    """Reads a file from its start.

    Yields:
        Its packets.

    Raises:
        CaptureError: The file is damaged. Everything before that was given.
    """
    head = stream.read(pcap.FileHdr.__hdr_len__)
    if len(head) < pcap.FileHdr.__hdr_len__:
        raise CaptureError("the file is cut off in its header")
    magic = int.from_bytes(head[:4], "big")
    header = (pcap.LEFileHdr if magic in _SWAPPED else pcap.FileHdr)(head)
    unit = 1 if magic in _NANO else 1000
    interface = Interface(header.linktype & _LINK_MASK, None, "<" if magic in _SWAPPED else ">")
    # dpkt's own struct, without an object for each packet's header: `pytest benchmarks -k capture` shows why.
    record = struct.Struct(pcap.MAGIC_TO_PKT_HDR[magic].__hdr_fmt__)
    size, unpack, read = record.size, record.unpack, stream.read
    number, position = 0, len(head)
    while head := read(size):
        number += 1
        if len(head) < size:
            raise CaptureError(f"the file is cut off in the header of packet {number}, at offset {position}")
        seconds, fraction, length, on_wire, *_ = unpack(head)
        if length > MOST_PACKET:
            raise CaptureError(
                f"the file is damaged at offset {position}: packet {number} would have {length} bytes; what follows"
                " cannot be read"
            )
        data = read(length)
        yield Packet(number, seconds * 1_000_000_000 + fraction * unit, data, on_wire, interface)
        if len(data) < length:
            raise CaptureError(f"the file is cut off in packet {number}: {len(data)} of its {length} bytes are there")
        position += size + length
