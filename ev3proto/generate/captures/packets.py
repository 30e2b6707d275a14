"""pcapng files of one section and one interface, with times in nanoseconds.

dpkt builds the blocks at the start. Those of packets, which may be millions, are packed here, in a tenth of the time.
"""

from __future__ import annotations

import struct
from collections.abc import Iterable
from importlib import import_module
from typing import BinaryIO

from dpkt.pcapng import (
    PCAPNG_BT_EPB,
    PCAPNG_OPT_ENDOFOPT,
    PCAPNG_OPT_IF_NAME,
    PCAPNG_OPT_IF_TSRESOL,
    PCAPNG_OPT_SHB_USERAPPL,
    InterfaceDescriptionBlockLE,
    PcapngOptionLE,
    SectionHeaderBlockLE,
)

from ev3proto.capture.record import NANOSECONDS
from ev3proto.errors import BuildError
from ev3proto.generate.captures.carrier_writer import CarrierWriter, TimedFrame, check_frame, goes_to_brick
from ev3proto.messages import Message
from ev3proto.tables.carriers import CARRIERS, DEFAULT_CARRIER, Carrier
from ev3proto.version import VERSION

MILLISECOND = NANOSECONDS // 1000

BEGIN_NS = 1_767_261_600 * NANOSECONDS
"""Default start of a conversation: 2026-01-01 10:00 UTC, so that the same frames make the same file."""

_PACKET, _SIZE = struct.Struct("<IIIIIII"), struct.Struct("<I")
"""Header of a packet block (type and size of the block, interface, time in two halves, bytes captured and sent), and
the size of the block again, which ends it."""

_ALIGNED = 4
_NANOSECONDS_DIGITS = 9
_MOST_CAPTURED = 1 << 18


class PacketFile:
    """A pcapng file with one section: interfaces as they are needed, then packets with times in nanoseconds."""

    def __init__(self, stream: BinaryIO) -> None:
        """Takes a binary stream; nothing is written before the first interface."""
        self._stream = stream
        self._interfaces: dict[Carrier, int] = {}

    def interface(self, carrier: Carrier) -> int:
        """Returns the number of a carrier's interface, which is written on first use."""
        if carrier not in self._interfaces:
            if not self._interfaces:
                self._stream.write(bytes(_section()))
            self._stream.write(bytes(_interface(carrier)))
            self._interfaces[carrier] = len(self._interfaces)
        return self._interfaces[carrier]

    def write(self, packet: bytes, time_ns: int, interface: int) -> None:
        """Writes a packet, whose time is in nanoseconds since 1970-01-01 UTC, of a number from `interface`."""
        high, low = divmod(time_ns, 1 << 32)
        size = len(packet)
        filler = bytes(-size % _ALIGNED)
        whole = _PACKET.size + size + len(filler) + _SIZE.size
        head = _PACKET.pack(PCAPNG_BT_EPB, whole, interface, high, low, size, size)
        self._stream.write(b"".join((head, packet, filler, _SIZE.pack(whole))))


class CaptureWriter:
    """Writes a capture of a computer and a brick that exchange frames one after the other.

    Nothing is written before the first frame, or before `close` if there are no frames.
    """

    def __init__(
        self, stream: BinaryIO, *, carrier: str = DEFAULT_CARRIER, begin_ns: int = BEGIN_NS, step_ns: int = MILLISECOND
    ) -> None:
        """The arguments are those of `write_pcapng`."""
        self.count = 0  # how many frames were added
        self._file = PacketFile(stream)
        self._carrier = _known(carrier)
        self._writer = carrier_writer(self._carrier)
        self._begin_ns = begin_ns
        self._step_ns = step_ns
        self._last_ns: int | None = None
        self._interface = 0

    def add(self, given: Message | bytes | TimedFrame) -> None:
        """Writes a message, its bytes, or bytes with a time. Raises BuildError, and writes nothing of it then."""
        last_ns = self._last_ns
        frame, time_ns = given if isinstance(given, TimedFrame) else (_bytes(given), None)
        if time_ns is None:
            time_ns = self._begin_ns if last_ns is None else last_ns + self._step_ns
        check_frame(frame)
        if time_ns < (last_ns or 0):
            raise BuildError(f"the frame has the time {time_ns} ns, but the one before it has {last_ns or 0} ns")
        is_from_host = goes_to_brick(frame)
        if last_ns is None:
            self._open(time_ns)
        else:
            self._spread(self._writer.between(is_from_host), last_ns, time_ns - last_ns)
        for packet in self._writer.frame(frame, is_from_host):
            self._write(packet, time_ns)
        self._last_ns = time_ns
        self.count += 1

    def close(self) -> None:
        """Writes the packets after the last frame. The stream stays open."""
        if self._last_ns is None:
            self._last_ns = self._begin_ns
            self._open(self._begin_ns)
        closing = self._writer.closing()
        self._spread(closing, self._last_ns, MILLISECOND * (len(closing) + 1))

    def _open(self, time_ns: int) -> None:
        self._interface = self._file.interface(self._carrier)
        opening = self._writer.opening()
        span_ns = MILLISECOND * (len(opening) + 1)
        self._spread(opening, max(time_ns - span_ns, 0), min(span_ns, time_ns))

    def _spread(self, packets: list[bytes], begin_ns: int, span_ns: int) -> None:
        """Writes packets at equal distances within a span of time."""
        for number, packet in enumerate(packets, 1):
            self._write(packet, begin_ns + span_ns * number // (len(packets) + 1))

    def _write(self, packet: bytes, time_ns: int) -> None:
        self._file.write(self._writer.stamped(packet, time_ns), time_ns, self._interface)


def write_pcapng(
    frames: Iterable[Message | bytes | TimedFrame],
    stream: BinaryIO,
    *,
    carrier: str = DEFAULT_CARRIER,
    begin_ns: int = BEGIN_NS,
    step_ns: int = MILLISECOND,
) -> int:
    """Writes a capture of a computer and a brick that exchange these frames.

    Args:
        frames: Messages, their bytes, or bytes with a time. Commands go to the brick, replies come from it. They are
            taken one by one: there may be millions.
        stream: Takes the bytes of a pcapng file.
        carrier: "wifi", "usb" or "bluetooth".
        begin_ns: Time of the first frame, in nanoseconds since 1970-01-01 UTC, unless it has one.
        step_ns: Nanoseconds from each frame to the next, unless that has a time.

    Returns:
        How many frames were written.

    Raises:
        ValueError: The carrier is not known.
        BuildError: A frame is too long, its length field is wrong, or its time is before the last one.
    """
    writer = CaptureWriter(stream, carrier=carrier, begin_ns=begin_ns, step_ns=step_ns)
    for frame in frames:
        try:
            writer.add(frame)
        except BuildError as error:
            raise BuildError(f"frame {writer.count + 1}: {error}") from None
    writer.close()
    return writer.count


def _bytes(given: Message | bytes) -> bytes:
    return given.build() if isinstance(given, Message) else given


def _known(carrier: str) -> Carrier:
    try:
        return Carrier(carrier)
    except ValueError:
        raise ValueError(f"carrier {carrier!r} is not known: it must be one of {', '.join(CARRIERS)}") from None


def carrier_writer(carrier: Carrier) -> CarrierWriter:
    """Creates the writer of a carrier, from the module with its name."""
    made: CarrierWriter = import_module(f"{__package__}.{carrier}").Writer()
    return made


def _section() -> SectionHeaderBlockLE:
    return SectionHeaderBlockLE(opts=_options((PCAPNG_OPT_SHB_USERAPPL, f"ev3proto {VERSION}".encode())))


def _interface(carrier: Carrier) -> InterfaceDescriptionBlockLE:
    options = _options(
        (PCAPNG_OPT_IF_NAME, carrier.facts.interface.encode()),
        (PCAPNG_OPT_IF_TSRESOL, bytes((_NANOSECONDS_DIGITS,))),
    )
    return InterfaceDescriptionBlockLE(linktype=int(carrier.facts.export), snaplen=_MOST_CAPTURED, opts=options)


def _options(*values: tuple[int, bytes]) -> list[PcapngOptionLE]:
    return [PcapngOptionLE(code=code, data=data) for code, data in (*values, (PCAPNG_OPT_ENDOFOPT, b""))]
