"""Capture files of every format and byte order, built by hand.

A packet here is its time and its bytes; `packets.py` makes packets.
"""

from __future__ import annotations

import struct
from collections.abc import Sequence
from typing import NamedTuple

ETHERNET, RAW_IP = 1, 101

SECOND = 1_000_000_000
BEGIN_NS = 1_700_000_000 * SECOND
"""2023-11-14 22:13:20 UTC."""

_BTSNOOP_EPOCH = 0x00DCDDB30F2F8000


class Timed(NamedTuple):
    """A packet: nanoseconds since 1970, its captured bytes, and its original size if that is larger."""

    time_ns: int
    data: bytes
    size: int = 0


def timed(packets: Sequence[bytes]) -> list[Timed]:
    """Packets that are a millisecond apart."""
    return [Timed(BEGIN_NS + number * 1_000_000, data) for number, data in enumerate(packets)]


def pcap(link: int, packets: Sequence[Timed], *, order: str = "<", nano: bool = False) -> bytes:
    magic, unit = (0xA1B23C4D, 1) if nano else (0xA1B2C3D4, 1000)
    pieces = [struct.pack(order + "IHHiIII", magic, 2, 4, 0, 0, 0x40000, link)]
    for time_ns, data, size in packets:
        seconds, rest = divmod(time_ns, SECOND)
        pieces += [struct.pack(order + "IIII", seconds, rest // unit, len(data), size or len(data)), data]
    return b"".join(pieces)


def btsnoop(kind: int, packets: Sequence[Timed], flags: Sequence[int]) -> bytes:
    pieces = [b"btsnoop\0", struct.pack(">II", 1, kind)]
    for (time_ns, data, size), word in zip(packets, flags, strict=True):
        microseconds = time_ns // 1000 + _BTSNOOP_EPOCH
        pieces += [struct.pack(">IIIIQ", size or len(data), len(data), word, 0, microseconds), data]
    return b"".join(pieces)


_PACKETLOGGER = {(0, 1): 0, (1, 4): 1, (0, 2): 2, (1, 2): 3}
"""PacketLogger's kinds of packets by direction, 1 for a received one, and HCI's packet type."""


def packetlogger(packets: Sequence[Timed], order: str) -> bytes:
    """A Mac's file of packets that have their direction and type before them, as in captures of link type 201."""
    pieces = []
    for time_ns, packet, _ in packets:
        kind = _PACKETLOGGER[struct.unpack(">IB", packet[:5])]
        seconds, rest = divmod(time_ns, SECOND)
        pieces += [struct.pack(f"{order}IIIB", 4 + len(packet), seconds, rest // 1000, kind), packet[5:]]
    return b"".join(pieces)


def hcidump(packets: Sequence[Timed]) -> bytes:
    """The file of `hcidump -w` of such packets."""
    pieces = []
    for time_ns, packet, _ in packets:
        seconds, rest = divmod(time_ns, SECOND)
        pieces += [struct.pack("<HBBII", len(packet) - 4, packet[3], 0, seconds, rest // 1000), packet[4:]]
    return b"".join(pieces)


def darwin_usb(packets: Sequence[tuple[int, bytes]]) -> bytes:
    """A capture of macOS's USB: interrupt transfers of a device, by endpoint, of which the brick's begin at 0x80."""
    found = []
    for number, (endpoint, data) in enumerate(packets):
        is_done = endpoint >> 7
        head = struct.pack("<HBBIIIQIBBBB", 0x0100, 32, is_done, len(data), 0, 0, number, 0x14100000, 3, 5, endpoint, 3)
        found.append(head + data)
    return pcap(266, timed(found))


class Blocks:
    """A pcapng file, block by block, in one byte order from its section header on."""

    def __init__(self, order: str = "<") -> None:
        self.order = order
        self.pieces: list[bytes] = []
        self.section(order)

    def block(self, kind: int, body: bytes) -> None:
        body += bytes(-len(body) % 4)
        size = struct.pack(self.order + "I", 12 + len(body))
        self.pieces.append(struct.pack(self.order + "I", kind) + size + body + size)

    def options(self, options: Sequence[tuple[int, bytes]]) -> bytes:
        found = b""
        for code, value in options:
            found += struct.pack(self.order + "HH", code, len(value)) + value + bytes(-len(value) % 4)
        return found + bytes(4) if options else b""

    def section(self, order: str) -> None:
        self.order = order
        self.block(0x0A0D0D0A, struct.pack(order + "IHHq", 0x1A2B3C4D, 1, 0, -1))

    def interface(
        self,
        link: int,
        *,
        name: str | None = None,
        resolution: int | None = None,
        offset: int | None = None,
        most: int = 0,
    ) -> None:
        options: list[tuple[int, bytes]] = []
        if name is not None:
            options.append((2, name.encode()))
        if resolution is not None:
            options.append((9, bytes((resolution,))))
        if offset is not None:
            options.append((14, struct.pack(self.order + "q", offset)))
        self.block(1, struct.pack(self.order + "HHI", link, 0, most) + self.options(options))

    def packet(self, time: int, data: bytes, *, interface: int = 0, size: int = 0) -> None:
        """An enhanced packet; `time` is in the interface's units."""
        head = struct.pack(self.order + "IIIII", interface, time >> 32, time & 0xFFFFFFFF, len(data), size or len(data))
        self.block(6, head + data + bytes(-len(data) % 4) + self.options([(1, b"a comment")]))

    def simple_packet(self, data: bytes, size: int = 0) -> None:
        self.block(3, struct.pack(self.order + "I", size or len(data)) + data)

    def data(self) -> bytes:
        return b"".join(self.pieces)
