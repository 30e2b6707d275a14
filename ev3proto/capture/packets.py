"""A packet as a capture file has it, whatever it carries: number, time, interface, bytes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple


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
    flags      the word of flags that btsnoop files keep beside a packet; None in other files
    """

    number: int
    time_ns: int
    data: bytes
    size: int
    interface: Interface
    flags: int | None = None


MOST_PACKET = 1 << 24
"""Bytes of the largest packet that is believed; a length above it is a lie or another format."""
