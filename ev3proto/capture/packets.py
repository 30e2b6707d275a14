"""A packet as a capture file has it, whatever it carries: number, time, interface, bytes."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple


class Link(IntEnum):
    """What a packet starts with, by the numbers of https://www.tcpdump.org/linktypes.html."""

    LOOPBACK = 0
    ETHERNET = 1
    RAW_BSD = 12
    RAW_OPENBSD = 14
    RAW_IP = 101
    LOOPBACK_OPENBSD = 108
    LINUX_COOKED = 113
    HCI = 187
    USBMON = 189
    HCI_WITH_DIRECTION = 201
    USBMON_PADDED = 220
    IPV4 = 228
    IPV6 = 229
    USBPCAP = 249
    BLUETOOTH_MONITOR = 254
    LINUX_COOKED_2 = 276


@dataclass(frozen=True, slots=True)
class Interface:
    """Where packets were captured.

    link    what they start with, by its number
    name    as the file has it; None where it has none
    order   "<" or ">": byte order of the machine, in which some headers are
    """

    link: int
    name: str | None = None
    order: str = "<"


class Packet(NamedTuple):
    """A packet.

    number     in the file, the first is 1
    time_ns    nanoseconds since 1970-01-01 UTC
    data       what was captured
    size       bytes that it had on the wire; more than `data` has where it was cut
    interface  where it was captured
    direction  the word of flags that btsnoop files keep beside a packet; None in other files
    """

    number: int
    time_ns: int
    data: bytes
    size: int
    interface: Interface
    flags: int | None = None


MOST_PACKET = 1 << 24
"""Bytes of the largest packet that is believed; a length above it is a lie or another format."""
