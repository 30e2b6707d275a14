"""pcapng files: blocks in either byte order, several sections, several interfaces with their own names and clocks.

dpkt's reader assumes one interface for all, so the blocks are described here, as far as packets need them.
https://www.ietf.org/archive/id/draft-ietf-opsawg-pcapng-02.html
"""

from __future__ import annotations

import struct
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from typing import BinaryIO

from ev3proto.capture.packets import MOST_PACKET, Interface, Packet
from ev3proto.capture.record import CaptureError

SECTION, INTERFACE, SIMPLE_PACKET, PACKET = 0x0A0D0D0A, 1, 3, 6
"""The blocks that are read; all others are skipped."""

_MAGIC = SECTION.to_bytes(4, "big")
_ORDER_MARK = 0x1A2B3C4D
_ORDERS = {_ORDER_MARK.to_bytes(4, "little"): "<", _ORDER_MARK.to_bytes(4, "big"): ">"}

END_OF_OPTIONS, NAME, RESOLUTION, TIME_OFFSET = 0, 2, 9, 14
"""Options of an interface."""

_PACKETS = (PACKET, SIMPLE_PACKET)
_LEAST_BLOCK = 12

MOST_INTERFACES = 4096
"""Maximum number of interfaces of a section; a computer has a few dozen."""

MOST_NAME = 1024
"""Maximum length of an interface's name in bytes."""


@dataclass(slots=True)
class _InterfaceTime:
    """The clock of an interface."""

    interface: Interface
    most: int
    per_second: int = 1_000_000
    offset_ns: int = 0

    def time_ns(self, high: int, low: int) -> int:
        return (high << 32 | low) * 1_000_000_000 // self.per_second + self.offset_ns


class _Section:
    """A section: its byte order and its interfaces."""

    def __init__(self, order: str) -> None:
        self.order = order
        self.block = struct.Struct(order + "II")  # type, length
        self.interface = struct.Struct(order + "HHI")  # link type, reserved, largest packet
        self.packet = struct.Struct(order + "IIIII")  # interface, both halves of the time, captured length, size
        self.option = struct.Struct(order + "HH")  # code, length
        self.number = struct.Struct(order + "Q")
        self.size = struct.Struct(order + "I")
        self.clocks: list[_InterfaceTime] = []

    def add_interface(self, body: bytes) -> None:
        link, _, most = self.interface.unpack_from(body)
        clock = _InterfaceTime(Interface(link, None, self.order), most)
        for code, value in self._options(body, self.interface.size):
            if code == NAME:
                name = value.split(b"\0", 1)[0][:MOST_NAME].decode("utf-8", "replace")
                name += "..." if len(value) > MOST_NAME else ""
                clock.interface = Interface(link, name or None, self.order)
            elif code == RESOLUTION and value:
                power = value[0] & 0x7F
                clock.per_second = 1 << power if value[0] & 0x80 else 10**power
            elif code == TIME_OFFSET and len(value) == self.number.size:
                seconds = int(self.number.unpack(value)[0])
                clock.offset_ns = (seconds - (seconds >> 63 << 64)) * 1_000_000_000
        if len(self.clocks) >= MOST_INTERFACES:
            raise CaptureError(f"a section has more than {MOST_INTERFACES} interfaces: the file is damaged")
        self.clocks.append(clock)

    def _options(self, body: bytes, at: int) -> Iterator[tuple[int, bytes]]:
        while at + self.option.size <= len(body):
            code, length = self.option.unpack_from(body, at)
            at += self.option.size
            if code == END_OF_OPTIONS:
                return
            yield code, body[at : at + length]
            at += length + -length % 4

    def read(self, kind: int, body: bytes, number: int, *, is_cut: bool = False) -> Packet:
        """Returns the packet in a block, with `is_cut` as far as it is there. Raises CaptureError."""
        if kind == SIMPLE_PACKET:
            (size,) = self.size.unpack_from(body)
            clock = self._clock(0, number)
            captured = min(size, clock.most) if clock.most else size
            return Packet(number, 0, self._data(body, self.size.size, captured, number, is_cut), size, clock.interface)
        interface, high, low, captured, size = self.packet.unpack_from(body)
        clock = self._clock(interface, number)
        data = self._data(body, self.packet.size, captured, number, is_cut)
        return Packet(number, clock.time_ns(high, low), data, size, clock.interface)

    def _clock(self, interface: int, number: int) -> _InterfaceTime:
        if interface >= len(self.clocks):
            raise CaptureError(f"packet {number} is of interface {interface}, which the file does not describe")
        return self.clocks[interface]

    def _data(self, body: bytes, start: int, captured: int, number: int, is_cut: bool) -> bytes:
        if captured > len(body) - start and not is_cut:
            raise CaptureError(
                f"packet {number} would have {captured} bytes, but its block has room for {len(body) - start}"
            )
        return body[start : start + captured]


def packets(stream: BinaryIO) -> Iterator[Packet]:
    """Yields the packets of a file. Raises CaptureError for a damaged one, after everything readable."""
    section: _Section | None = None
    trouble: CaptureError | None = None
    number, position = 0, 0
    while head := stream.read(8):
        is_section = head.startswith(_MAGIC)
        mark = stream.read(4) if is_section else b""
        if len(head) < 8 or (is_section and len(mark) < 4):
            raise CaptureError(f"the file is cut off in a block's header, at offset {position}")
        if is_section:
            if mark not in _ORDERS:
                raise CaptureError(f"the file is damaged at offset {position + 8}: a section has no byte order mark")
            section = _Section(_ORDERS[mark])
        assert section is not None, "a file is sniffed by its first section"
        kind, length = section.block.unpack(head)
        if length < _LEAST_BLOCK + len(mark) or length % 4 or length > MOST_PACKET:
            raise CaptureError(
                f"the file is damaged at offset {position}: a block would have {length} bytes; what follows cannot be"
                " read"
            )
        rest = length - len(head) - len(mark)
        body = stream.read(rest)
        if len(body) < rest:
            if kind in _PACKETS:
                with suppress(struct.error, CaptureError):
                    yield section.read(kind, body, number + 1, is_cut=True)
            got = len(head) + len(mark) + len(body)
            raise CaptureError(f"the file is cut off in a block at offset {position}: {got} of its {length} bytes")
        if body[-4:] != head[4:]:
            raise CaptureError(f"the file is damaged at offset {position}: a block does not end with its length")
        too_short = f"the file is damaged at offset {position}: a block is too short for its kind"
        if kind == INTERFACE:
            try:
                section.add_interface(body[:-4])
            except struct.error:
                raise CaptureError(too_short) from None
        elif kind in _PACKETS:
            number += 1
            packet = None
            try:
                packet = section.read(kind, body[:-4], number)
            except struct.error:
                trouble = trouble or CaptureError(too_short)
            except CaptureError as error:
                trouble = trouble or error
            if packet is not None:
                yield packet
        position += length
    if trouble is not None:
        # The blocks after it were read.
        raise trouble
