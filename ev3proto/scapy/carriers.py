"""EV3 frames on USB and Bluetooth: the headers that scapy lacks, and a session that joins the parts of a frame.

A report of USB, or a piece of a serial port, is only taken for a frame if it begins with a whole one.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from scapy.config import conf
from scapy.fields import (
    BitField,
    ByteEnumField,
    ByteField,
    ConditionalField,
    LEIntField,
    LELongField,
    LEShortField,
    LESignedIntField,
    XByteField,
    XStrFixedLenField,
)
from scapy.layers.bluetooth import HCI_ACL_Hdr, L2CAP_Hdr
from scapy.layers.usb import USBpcap
from scapy.packet import Packet, Raw, bind_bottom_up
from scapy.sessions import TCPSession

from ev3proto.scapy.frames import EV3
from ev3proto.schema.frame_buffer import FrameBuffer
from ev3proto.schema.header import HEADER_SIZE, frame_size
from ev3proto.tables.carriers import RFCOMM_CHANNEL, RFCOMM_DATA, RFCOMM_POLL, Link
from ev3proto.tables.frame import MAX_FRAME, MESSAGE_TYPES, REPORT_SIZES, MessageType

_INTERRUPT = 1
_CONTINUES = 1
_L2CAP_HEADER = 4


def _first(data: bytes) -> MessageType | None:
    """Returns the type of the whole frame at the start of data; None if there is none."""
    is_whole = HEADER_SIZE <= len(data) >= frame_size(data)
    return MESSAGE_TYPES.get(data[HEADER_SIZE - 1]) if is_whole else None


class EV3Report(Packet):
    """A report of USB: dissected as a frame with padding, or as raw bytes."""

    @classmethod
    def dispatch_hook(cls, _pkt: bytes = b"", *args: Any, **kwargs: Any) -> type[Packet]:  # noqa: ARG003
        """Returns the layer of a report. Bricks in a chain send smaller ones, only with messages between bricks."""
        member = _first(_pkt) if len(_pkt) in REPORT_SIZES else None
        is_frame = member is not None and (len(_pkt) == MAX_FRAME or member.carries == "daisy")
        return EV3 if is_frame else Raw


class EV3Piece(Packet):
    """A piece of a brick's serial port: dissected as a frame, or as raw bytes, which `EV3Session` joins."""

    @classmethod
    def dispatch_hook(cls, _pkt: bytes = b"", *args: Any, **kwargs: Any) -> type[Packet]:  # noqa: ARG003
        """Returns the layer of a piece."""
        return EV3 if _first(_pkt) is not None else Raw


class USBmon(Packet):
    """The header of a USB request under Linux (Documentation/usb/usbmon), of 48 bytes, little-endian."""

    name = "USBmon"
    fields_desc = [  # noqa: RUF012 - scapy's way to declare a packet, here and below
        LELongField("id", 0),
        ByteEnumField("event", ord("S"), {ord("S"): "submit", ord("C"): "complete", ord("E"): "error"}),
        ByteEnumField("transfer", _INTERRUPT, {0: "isochronous", 1: "interrupt", 2: "control", 3: "bulk"}),
        XByteField("endpoint", 0),
        ByteField("device", 0),
        LEShortField("bus", 0),
        ByteField("setup_flag", 0),
        ByteField("data_flag", 0),
        LELongField("seconds", 0),
        LEIntField("microseconds", 0),
        LESignedIntField("status", 0),
        LEIntField("size", 0),
        LEIntField("captured", 0),
        XStrFixedLenField("setup", bytes(8), 8),
    ]


class USBmonPadded(Packet):
    """The same with the 16 bytes that newer kernels add."""

    name = "USBmon"
    fields_desc = [  # noqa: RUF012
        *USBmon.fields_desc,
        LEIntField("interval", 0),
        LEIntField("start_frame", 0),
        LEIntField("flags", 0),
        LEIntField("descriptors", 0),
    ]


class RFCOMM(Packet):
    """A frame of Bluetooth's serial ports (TS 07.10), for reading: its checksum is the padding behind the data."""

    name = "RFCOMM"
    fields_desc = [  # noqa: RUF012
        BitField("channel", RFCOMM_CHANNEL, 5),
        BitField("d", 0, 1),
        BitField("cr", 1, 1),
        BitField("ea", 1, 1),
        XByteField("control", RFCOMM_DATA),
        BitField("length", 0, 7),
        BitField("is_short", 1, 1),
        ConditionalField(ByteField("length_high", 0), lambda packet: not packet.is_short),
        ConditionalField(
            ByteField("credits", 0), lambda packet: packet.channel and packet.control == RFCOMM_DATA | RFCOMM_POLL
        ),
    ]

    @property
    def data_size(self) -> int:
        """Number of bytes between header and checksum."""
        return int(self.length) + (int(self.length_high or 0) << 7)

    @classmethod
    def dispatch_hook(cls, _pkt: bytes = b"", *args: Any, **kwargs: Any) -> type[Packet]:  # noqa: ARG003
        """Returns this layer for data frames whose length is right: L2CAP's channels do not say what they carry."""
        if len(_pkt) < 4 or not _pkt[0] & 1 or _pkt[1] & ~RFCOMM_POLL != RFCOMM_DATA:
            return Raw
        head, length = (3, _pkt[2] >> 1) if _pkt[2] & 1 else (4, _pkt[2] >> 1 | _pkt[3] << 7)
        has_credits = _pkt[0] >> 3 and _pkt[1] & RFCOMM_POLL
        return cls if len(_pkt) == head + bool(has_credits) + length + 1 else Raw

    def extract_padding(self, s: bytes) -> tuple[bytes, bytes]:
        """Returns the data, and the checksum."""
        return s[: self.data_size], s[self.data_size :]


for _header in (USBmon, USBmonPadded):
    bind_bottom_up(_header, EV3Report, transfer=_INTERRUPT)
bind_bottom_up(USBpcap, EV3Report, transfer=_INTERRUPT)
bind_bottom_up(L2CAP_Hdr, RFCOMM)
bind_bottom_up(RFCOMM, EV3Piece, channel=RFCOMM_CHANNEL)
conf.l2types.register(Link.USBMON, USBmon)
conf.l2types.register(Link.USBMON_PADDED, USBmonPadded)


class EV3Session(TCPSession):
    """A session for `sniff` that joins frames split over TCP segments or Bluetooth packets. USB needs no joining."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Creates a session without pending parts."""
        super().__init__(*args, **kwargs)
        self._parts: dict[Any, bytes] = {}
        self._ports: dict[Any, FrameBuffer] = {}

    def process(self, pkt: Packet, cls: type[Packet] | None = None) -> Packet | None:
        """Returns a packet with its frames as layers; None for one that has only the part of a frame."""
        return self._bluetooth(pkt) if HCI_ACL_Hdr in pkt else super().process(pkt, cls)

    def _bluetooth(self, packet: Packet) -> Packet | None:
        link = packet[HCI_ACL_Hdr]
        way = link.connection_handle, packet.fields.get("direction")  # every packet has an attribute of that name
        earlier = self._parts.pop(way, b"")
        data = (earlier if link.PB == _CONTINUES else b"") + link.payload.original
        if len(data) < _L2CAP_HEADER or len(data) < _L2CAP_HEADER + int.from_bytes(data[:2], "little"):
            self._parts[way] = data
            return None
        link.remove_payload()
        link.add_payload(L2CAP_Hdr(data))
        if RFCOMM not in packet or packet[RFCOMM].channel != RFCOMM_CHANNEL or not packet[RFCOMM].data_size:
            return packet
        serial = packet[RFCOMM]
        port = *way, packet[L2CAP_Hdr].cid, serial.d, serial.cr
        buffer = self._ports.setdefault(port, FrameBuffer())
        buffer.append(serial.payload.original[: serial.data_size])
        frames = list(_layers(buffer))
        if not frames:
            return None
        serial.remove_payload()
        for frame in frames:
            packet.add_payload(frame)
        return packet


def _layers(buffer: FrameBuffer) -> Iterator[Packet]:
    """Yields the whole frames in a buffer, and the bytes that cannot start one."""
    yield from map(EV3, buffer)
    found = buffer.next()
    if found is not None:
        yield Raw(buffer.skip(len(buffer)))
