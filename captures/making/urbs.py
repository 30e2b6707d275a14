"""How operating systems record USB: Linux by usbmon, Windows by USBPcap."""

from __future__ import annotations

import struct
from typing import Protocol

from scapy.fields import (
    ByteField,
    LEIntField,
    LELongField,
    LEShortField,
    LESignedIntField,
    LESignedLongField,
    StrFixedLenField,
)
from scapy.layers.usb import USBpcap
from scapy.packet import Packet, Raw

from ev3proto.tables.frame import MAX_FRAME
from making.files import SECOND, Wire

INTERRUPT, CONTROL = 1, 2
EINPROGRESS, ESHUTDOWN = 115, 108
"""Linux' numbers, whatever system this runs on."""

BULK_OR_INTERRUPT = 0x0009
"""Windows' number for what an URB on an interrupt endpoint does."""


class Usbmon(Packet):
    """What Linux puts in front of what an URB carries: 48 bytes."""

    name = "usbmon"
    fields_desc = [  # noqa: RUF012 - scapy's way to declare a packet, here and below
        LELongField("urb", 0),
        StrFixedLenField("event", b"S", 1),
        ByteField("transfer", INTERRUPT),
        ByteField("endpoint", 0),
        ByteField("device", 0),
        LEShortField("bus", 1),
        StrFixedLenField("no_setup", b"-", 1),
        StrFixedLenField("no_data", b"\0", 1),
        LESignedLongField("seconds", 0),
        LESignedIntField("microseconds", 0),
        LESignedIntField("status", 0),
        LEIntField("length", 0),
        LEIntField("captured", 0),
        StrFixedLenField("setup", b"", 8),
    ]


class UsbmonMapped(Packet):
    """The 16 bytes more that there are when it is read through a mapped buffer."""

    name = "usbmon, mapped"
    fields_desc = [  # noqa: RUF012
        LESignedIntField("interval", 0),
        LESignedIntField("start_frame", 0),
        LEIntField("flags", 0),
        LEIntField("descriptors", 0),
    ]


class Urbs(Protocol):
    """How an operating system records what goes to and from the interrupt endpoints of one device."""

    wire: Wire

    def out(self, endpoint: int, data: bytes) -> None:
        """Data for the device: submitted, and done a little later."""

    def listen(self, endpoint: int) -> None:
        """The device may send a report."""

    def heard(self, endpoint: int, data: bytes) -> None:
        """The device sent it."""


class Linux:
    """usbmon's records of one device, whose reports have at most `size` bytes."""

    def __init__(self, wire: Wire, device: int, bus: int = 1, mapped: bool = True, size: int = MAX_FRAME) -> None:
        self.wire = wire
        self.device = device
        self.bus = bus
        self.size = size
        self.mapped = mapped

    def _add(self, event: bytes, endpoint: int, data: bytes, length: int, status: int = 0, setup: bytes = b"") -> None:
        into = endpoint & 0x80
        carried = not into if event == b"S" else into
        head = Usbmon(
            urb=0xFFFF888000000000 | self.device << 16 | endpoint << 8,
            event=event,
            transfer=INTERRUPT if endpoint & 0x0F else CONTROL,
            endpoint=endpoint,
            device=self.device,
            bus=self.bus,
            no_setup=b"\0" if setup else b"-",
            no_data=b"\0" if carried else b"<" if into else b">",
            seconds=self.wire.now // SECOND,
            microseconds=self.wire.now % SECOND,
            status=status,
            length=length,
            captured=len(data),
            setup=setup,
        )
        if self.mapped:
            head /= UsbmonMapped(interval=8 if endpoint & 0x0F else 0, flags=0x200 if into else 0)
        self.wire.add(head / data if data else head)

    def out(self, endpoint: int, data: bytes) -> None:
        """Data for the device: submitted, and done a little later."""
        self._add(b"S", endpoint, data, len(data), -EINPROGRESS)
        self.wire.wait(900)
        self._add(b"C", endpoint, b"", len(data))

    def listen(self, endpoint: int) -> None:
        """The device may send a report."""
        self._add(b"S", endpoint, b"", self.size, -EINPROGRESS)

    def heard(self, endpoint: int, data: bytes, failure: int = 0) -> None:
        """The device sent it."""
        self._add(b"C", endpoint, data, len(data), -failure)

    def control(self, kind: int, request: int, value: int, index: int, length: int, data: bytes = b"") -> None:
        """A request on endpoint 0; `data` is what the device gives."""
        endpoint = kind & 0x80
        setup = struct.pack("<BBHHH", kind, request, value, index, length)
        self._add(b"S", endpoint, b"", length, -EINPROGRESS, setup)
        self.wire.wait(250)
        self._add(b"C", endpoint, data[:length], len(data[:length]))
        self.wire.wait(120)


class Windows:
    """USBPcap's records of one device."""

    def __init__(self, wire: Wire, device: int, bus: int = 1) -> None:
        self.wire = wire
        self.device = device
        self.bus = bus

    def _add(self, endpoint: int, data: bytes, done: bool) -> None:
        head = USBpcap(
            irpId=0xFFFFA50000000000 | self.device << 16 | endpoint << 8,
            function=BULK_OR_INTERRUPT,
            info=int(done),
            bus=self.bus,
            device=self.device,
            endpoint=endpoint,
            transfer=INTERRUPT,
            dataLength=len(data),
        )
        self.wire.add(head / Raw(data) if data else head)

    def out(self, endpoint: int, data: bytes) -> None:
        """Data for the device: submitted, and done a little later."""
        self._add(endpoint, data, done=False)
        self.wire.wait(900)
        self._add(endpoint, b"", done=True)

    def listen(self, endpoint: int) -> None:
        """The device may send a report; USBPcap does not record of what size."""
        self._add(endpoint, b"", done=False)

    def heard(self, endpoint: int, data: bytes) -> None:
        """The device sent it."""
        self._add(endpoint, data, done=True)
