"""pcapng files: blocks in either byte order, several sections, several interfaces with their own names and clocks.

dpkt's reader assumes one interface for all, so the blocks are described here, as far as packets need them.
https://www.ietf.org/archive/id/draft-ietf-opsawg-pcapng-02.html
"""

from __future__ import annotations

import struct
from collections.abc import Iterator
from dataclasses import dataclass
from typing import BinaryIO, NamedTuple

from ev3proto.capture.packets import MOST_PACKET, Format, Interface, Packet, begins_with
from ev3proto.capture.record import CaptureError

SECTION, INTERFACE, SIMPLE_PACKET, PACKET = 0x0A0D0D0A, 1, 3, 6
"""The blocks that are read; all others are skipped."""

_MAGIC = SECTION.to_bytes(4, "big")
_ORDER_MARK = 0x1A2B3C4D
_ORDERS = {_ORDER_MARK.to_bytes(4, "little"): "<", _ORDER_MARK.to_bytes(4, "big"): ">"}

END_OF_OPTIONS, NAME, RESOLUTION, TIME_OFFSET = 0, 2, 9, 14
"""Options of an interface."""

_PACKETS = (PACKET, SIMPLE_PACKET)

MOST_INTERFACES = 4096
"""Maximum number of interfaces of a section; a computer has a few dozen."""

MOST_NAME = 1024
"""Maximum length of an interface's name in bytes."""


@dataclass(slots=True)
class _InterfaceTime:
    interface: Interface
    most: int
    per_second: int = 1_000_000
    offset_ns: int = 0

    def time_ns(self, high: int, low: int) -> int:
        return (high << 32 | low) * 1_000_000_000 // self.per_second + self.offset_ns


class _Block(NamedTuple):
    """A block of a file.

    kind    its type
    body    its contents; if the file is cut off in it, the first ones
    at      its offset in the file
    is_cut  whether the file is cut off in it
    """

    kind: int
    body: bytes
    at: int
    is_cut: bool = False

    @property
    def too_short(self) -> CaptureError:
        """The error for a block that has less than its kind needs."""
        return CaptureError(f"the file is damaged at offset {self.at}: a block is too short for its kind")


class _Section:
    def __init__(self, order: str) -> None:
        self.order = order
        self.block = struct.Struct(order + "II")  # type, length
        self.interface = struct.Struct(order + "HHI")  # link type, reserved, largest packet
        self.packet = struct.Struct(order + "IIIII")  # interface, both halves of the time, captured length, size
        self.option = struct.Struct(order + "HH")  # code, length
        self.number = struct.Struct(order + "Q")
        self.size = struct.Struct(order + "I")
        self.clocks: list[_InterfaceTime] = []

    def add_interface(self, block: _Block) -> None:
        """Takes the description of an interface. Raises CaptureError."""
        if len(block.body) < self.interface.size:
            raise block.too_short
        if len(self.clocks) >= MOST_INTERFACES:
            raise CaptureError(f"a section has more than {MOST_INTERFACES} interfaces: the file is damaged")
        link, _, most = self.interface.unpack_from(block.body)
        clock = _InterfaceTime(Interface(link, None, self.order), most)
        for code, value in self._options(block.body, self.interface.size):
            self._set(clock, code, value)
        self.clocks.append(clock)

    def _set(self, clock: _InterfaceTime, code: int, value: bytes) -> None:
        if code == NAME:
            name = value.split(b"\0", 1)[0][:MOST_NAME].decode("utf-8", "replace")
            name += "..." if len(value) > MOST_NAME else ""
            clock.interface = Interface(clock.interface.link, name or None, self.order)
        elif code == RESOLUTION and value:
            power = value[0] & 0x7F
            clock.per_second = 1 << power if value[0] & 0x80 else 10**power
        elif code == TIME_OFFSET and len(value) == self.number.size:
            seconds = int(self.number.unpack(value)[0])
            clock.offset_ns = (seconds - (seconds >> 63 << 64)) * 1_000_000_000

    def _options(self, body: bytes, at: int) -> Iterator[tuple[int, bytes]]:
        while at + self.option.size <= len(body):
            code, length = self.option.unpack_from(body, at)
            at += self.option.size
            if code == END_OF_OPTIONS:
                return
            yield code, body[at : at + length]
            at += length + -length % 4

    def read(self, block: _Block, number: int) -> Packet:
        """Returns the packet in a block, as far as it is there. Raises CaptureError."""
        body, layout = block.body, self.size if block.kind == SIMPLE_PACKET else self.packet
        if len(body) < layout.size:
            raise block.too_short
        if block.kind == SIMPLE_PACKET:
            (size,) = layout.unpack_from(body)
            clock, time_ns = self._clock(0, number), 0
            captured = min(size, clock.most) if clock.most else size
        else:
            interface, high, low, captured, size = layout.unpack_from(body)
            clock = self._clock(interface, number)
            time_ns = clock.time_ns(high, low)
        room = len(body) - layout.size
        if captured > room and not block.is_cut:
            raise CaptureError(f"packet {number} would have {captured} bytes, but its block has room for {room}")
        return Packet(number, time_ns, body[layout.size : layout.size + captured], size, clock.interface)

    def _clock(self, interface: int, number: int) -> _InterfaceTime:
        if interface >= len(self.clocks):
            raise CaptureError(f"packet {number} is of interface {interface}, which the file does not describe")
        return self.clocks[interface]


def packets(stream: BinaryIO) -> Iterator[Packet]:
    """Yields the packets of a file. Raises CaptureError for a damaged one, after everything readable."""
    trouble: CaptureError | None = None
    number = 0
    for section, block in _blocks(stream):
        if block.kind == INTERFACE and not block.is_cut:
            section.add_interface(block)
        elif block.kind in _PACKETS:
            number += 1
            try:
                packet = section.read(block, number)
            except CaptureError as error:
                trouble = trouble or error
            else:
                yield packet
    if trouble is not None:
        # The blocks after it were read.
        raise trouble


def _blocks(stream: BinaryIO) -> Iterator[tuple[_Section, _Block]]:
    """Yields the blocks with their sections. Raises CaptureError where the file cannot be read on."""
    section: _Section | None = None
    at = 0
    while head := stream.read(8):
        is_section = head.startswith(_MAGIC)
        mark = stream.read(4) if is_section else b""
        if len(head) < 8 or (is_section and len(mark) < 4):
            raise CaptureError(f"the file is cut off in a block's header, at offset {at}")
        if is_section:
            section = _section(mark, at)
        assert section is not None, "a file is sniffed by its first section"
        kind, length = section.block.unpack(head)
        got = len(head) + len(mark)
        if not got + 4 <= length <= MOST_PACKET or length % 4:
            raise CaptureError(
                f"the file is damaged at offset {at}: a block would have {length} bytes; what follows cannot be read"
            )
        body = stream.read(length - got)
        got += len(body)
        if got < length:
            yield section, _Block(kind, body, at, is_cut=True)
            raise CaptureError(f"the file is cut off in a block at offset {at}: {got} of its {length} bytes")
        if body[-4:] != head[4:]:
            raise CaptureError(f"the file is damaged at offset {at}: a block does not end with its length")
        yield section, _Block(kind, body[:-4], at)
        at += length


def _section(mark: bytes, at: int) -> _Section:
    if mark not in _ORDERS:
        raise CaptureError(f"the file is damaged at offset {at + 8}: a section has no byte order mark")
    return _Section(_ORDERS[mark])


FORMAT = Format("pcapng", (".pcapng",), len(_MAGIC), begins_with(_MAGIC), packets)
