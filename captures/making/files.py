"""Packets with their times, and the formats of capture files."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from scapy.fields import IntField, LongField, StrFixedLenField
from scapy.packet import Packet
from scapy.utils import PcapNgWriter, PcapWriter

SECOND = 1_000_000
"""Times are whole microseconds since 1970."""

START = 1_767_261_600 * SECOND
"""The time when every capture begins: 1 January 2026, 10:00 UTC."""

BTSNOOP_EPOCH = 0x00DCDDB30F2F8000
"""1970 in btsnoop files: microseconds since the year 0."""

BTSNOOP_H4 = 1002
"""The link type of Android's Bluetooth logs: HCI packets after their type, as on a UART."""


class Record(NamedTuple):
    """One packet: time, bytes, and for carriers that record it, whether this end received it."""

    time: int
    packet: Packet | bytes
    received: bool = False


class Wire:
    """The packets captured so far. The clock advances only by `wait`."""

    def __init__(self, now: int = START) -> None:
        self.now = now
        self.records: list[Record] = []

    def wait(self, microseconds: int) -> None:
        """Advances the clock."""
        self.now += microseconds

    def add(self, packet: Packet | bytes, received: bool = False) -> None:
        """Adds a packet at the current time."""
        self.records.append(Record(self.now, packet, received))


def write_pcap(path: Path, wire: Wire, link: int, nano: bool = False) -> None:
    """A classic pcap file, little endian, with times in microseconds or nanoseconds."""
    with PcapWriter(str(path), linktype=link, endianness="<", nano=nano) as writer:
        writer.write_header(None)
        for time, packet, _ in wire.records:
            fraction = time % SECOND * (1000 if nano else 1)
            writer.write_packet(bytes(packet), sec=time // SECOND, usec=fraction)


def write_pcapng(path: Path, wire: Wire, link: int) -> None:
    """A pcapng file."""
    with PcapNgWriter(str(path)) as writer:
        writer.linktype = link
        writer.write_header(None)
        for time, packet, _ in wire.records:
            # The writer truncates to microseconds; adding half of one compensates for the precision of floats.
            writer.write_packet(bytes(packet), sec=(time + 0.5) / SECOND)


class BtsnoopHeader(Packet):
    """The start of a btsnoop file."""

    name = "btsnoop"
    fields_desc = [  # noqa: RUF012 - scapy's way to declare a packet, here and below
        StrFixedLenField("magic", b"btsnoop\0", 8),
        IntField("version", 1),
        IntField("datalink", BTSNOOP_H4),
    ]


class BtsnoopRecord(Packet):
    """The header of a packet in a btsnoop file."""

    name = "btsnoop record"
    fields_desc = [  # noqa: RUF012
        IntField("original_length", None),
        IntField("included_length", None),
        IntField("flags", 0),
        IntField("drops", 0),
        LongField("time", 0),
    ]


def write_btsnoop(path: Path, wire: Wire) -> None:
    """A btsnoop file of HCI packets, each after its H4 type. Flags: 1 received, 2 command or event."""
    with path.open("wb") as file:
        file.write(bytes(BtsnoopHeader()))
        for time, packet, received in wire.records:
            data = bytes(packet)
            flags = received | (data[0] != H4_ACL) << 1
            size = len(data)
            head = BtsnoopRecord(original_length=size, included_length=size, flags=flags, time=time + BTSNOOP_EPOCH)
            file.write(bytes(head) + data)


H4_ACL = 2
"""The H4 type of data; the others here are commands and events."""
