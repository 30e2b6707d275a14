"""Packets of capture files, whatever they carry: number, time, interface, bytes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple


@dataclass(frozen=True, slots=True)
class Interface:
    """An interface on which packets were captured."""

    link: int  # the number of its link type
    name: str | None = None  # its name in the file, if any
    order: str = "<"  # "<" or ">": the byte order of the machine, which some headers have


class Packet(NamedTuple):
    """A packet."""

    number: int  # in the file, from 1
    time_ns: int  # nanoseconds since 1970-01-01 UTC
    data: bytes  # the captured bytes
    size: int  # its size on the wire in bytes, which is larger than `data` if it was cut
    interface: Interface
    flags: int | None = None  # the flags beside a packet in btsnoop files; None in other files


MOST_PACKET = 1 << 24
"""Maximum size of a packet in bytes; a larger length field is damaged."""
