"""Packets of capture files, whatever they carry: number, time, interface, bytes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple


@dataclass(frozen=True, slots=True)
class Interface:
    """An interface on which packets were captured.

    link    the number of its link type
    name    its name in the file, if any
    order   "<" or ">": the byte order of the machine, which some headers have
    """

    link: int
    name: str | None = None
    order: str = "<"


class Packet(NamedTuple):
    """A packet.

    number     in the file, from 1
    time_ns    nanoseconds since 1970-01-01 UTC
    data       the captured bytes
    size       its size on the wire in bytes, which is larger than `data` if it was cut
    interface  its interface
    flags      the flags beside a packet in btsnoop files; None in other files
    """

    number: int
    time_ns: int
    data: bytes
    size: int
    interface: Interface
    flags: int | None = None


MOST_PACKET = 1 << 24
"""Maximum size of a packet in bytes; a larger length field is damaged."""
