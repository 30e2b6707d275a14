"""Packets of capture files, whatever they carry: number, time, interface, bytes. What each format says of itself."""

from __future__ import annotations

import io
import struct
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, BinaryIO, NamedTuple

from ev3proto.capture.record import CaptureError


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

    @property
    def missing(self) -> int:
        """The number of its bytes that were not captured."""
        return self.size - len(self.data)


MOST_PACKET = 1 << 24
"""Maximum size of a packet in bytes; a larger length field is damaged."""


class Format(NamedTuple):
    """A format of capture files.

    name      as people call it
    suffixes  of the names of such files
    needs     the number of first bytes that always tell whether a file has this format
    matches   tells it from the first bytes, fewer of them too: None if more are needed
    packets   yields the packets of a file; raises CaptureError for a damaged one, after everything readable
    """

    name: str
    suffixes: tuple[str, ...]
    needs: int
    matches: Callable[[bytes], bool | None]
    packets: Callable[[io.BufferedReader[Any]], Iterator[Packet]]


def begins_with(*starts: bytes) -> Callable[[bytes], bool | None]:
    """Returns the `matches` of a format whose files begin with one of these bytes."""

    def matches(head: bytes) -> bool | None:
        return head.startswith(starts) or (None if any(start.startswith(head) for start in starts) else False)

    return matches


def without_magic(needs: int, is_it: Callable[[bytes], bool]) -> Callable[[bytes], bool | None]:
    """Returns the `matches` of a format without a magic. Unlike texts, its files begin with zeros among others."""

    def matches(head: bytes) -> bool | None:
        if len(head) < needs:
            return None if not head or b"\0" in head else False
        return is_it(head)

    return matches


def records(
    stream: BinaryIO, head: struct.Struct, at: int, length_of: Callable[[tuple[int, ...]], int]
) -> Iterator[tuple[int, tuple[int, ...], bytes]]:
    """Yields number, head and data of each packet of a file that has one after the other.

    Args:
        stream: The file, after its own header.
        head: What is before the data of a packet.
        at: The offset of the first packet.
        length_of: Returns the number of bytes of data, given the head.

    Raises:
        CaptureError: The file is damaged or cut off; raised after everything readable.
    """
    number = 0
    while begin := stream.read(head.size):
        number += 1
        if len(begin) < head.size:
            raise CaptureError(f"the file is cut off in the header of packet {number}, at offset {at}")
        fields = head.unpack(begin)
        length = length_of(fields)
        if not 0 <= length <= MOST_PACKET:
            raise CaptureError(
                f"the file is damaged at offset {at}: packet {number} would have {length} bytes; what follows cannot be"
                " read"
            )
        data = stream.read(length)
        yield number, fields, data
        if len(data) < length:
            raise CaptureError(f"the file is cut off in packet {number}: {len(data)} of its {length} bytes are there")
        at += head.size + length
