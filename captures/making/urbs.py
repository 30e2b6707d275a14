"""The formats in which operating systems record USB: Linux by usbmon, Windows by USBPcap."""

from __future__ import annotations

import struct
from typing import Protocol

from scapy.layers.usb import USBpcap
from scapy.packet import Raw

from ev3proto.capture.carriers.usb.requests import IN, INTERRUPT
from ev3proto.generate.captures.usb import DONE, SUBMITTED, record, stamped
from ev3proto.tables.frame import MAX_FRAME
from making.files import Wire

ESHUTDOWN = 108
"""Linux' number of an error, on any system."""

DIRECTION_IN = 0x200
"""Linux' flag of a request whose data goes to the host."""

NANOSECONDS_EACH = 1000
"""In a microsecond."""

BULK_OR_INTERRUPT = 0x0009
"""Windows' number for the function of an URB on an interrupt endpoint."""


class Urbs(Protocol):
    """The records of an operating system about the interrupt endpoints of one device."""

    wire: Wire

    def out(self, endpoint: int, data: bytes) -> None:
        """Data for the device: submitted, and completed a little later."""

    def listen(self, endpoint: int) -> None:
        """Asks the device for a report."""

    def heard(self, endpoint: int, data: bytes) -> None:
        """The device sends the report."""


class Linux:
    """usbmon's records of one device, whose reports have at most `size` bytes."""

    def __init__(self, wire: Wire, device: int, bus: int = 1, mapped: bool = True, size: int = MAX_FRAME) -> None:
        self.wire = wire
        self.device = device
        self.bus = bus
        self.size = size
        self.mapped = mapped

    def _add(self, event: int, endpoint: int, data: bytes, size: int, status: int = 0, setup: bytes = b"") -> None:
        packet = record(
            event,
            endpoint,
            data,
            device=self.device,
            bus=self.bus,
            status=status,
            setup=setup,
            size=size,
            flags=DIRECTION_IN if endpoint & IN else 0,
            is_padded=self.mapped,
        )
        self.wire.add(stamped(packet, self.wire.now * NANOSECONDS_EACH))

    def out(self, endpoint: int, data: bytes) -> None:
        """Data for the device: submitted, and completed a little later."""
        self._add(SUBMITTED, endpoint, data, len(data))
        self.wire.wait(900)
        self._add(DONE, endpoint, b"", len(data))

    def listen(self, endpoint: int) -> None:
        """Asks the device for a report."""
        self._add(SUBMITTED, endpoint, b"", self.size)

    def heard(self, endpoint: int, data: bytes, failure: int = 0) -> None:
        """The device sends the report."""
        self._add(DONE, endpoint, data, len(data), -failure)

    def control(self, kind: int, request: int, value: int, index: int, length: int, data: bytes = b"") -> None:
        """A request on endpoint 0; `data` is the answer of the device."""
        endpoint = kind & 0x80
        setup = struct.pack("<BBHHH", kind, request, value, index, length)
        self._add(SUBMITTED, endpoint, b"", length, setup=setup)
        self.wire.wait(250)
        self._add(DONE, endpoint, data[:length], len(data[:length]))
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
        """Data for the device: submitted, and completed a little later."""
        self._add(endpoint, data, done=False)
        self.wire.wait(900)
        self._add(endpoint, b"", done=True)

    def listen(self, endpoint: int) -> None:
        """Asks the device for a report; USBPcap does not record its size."""
        self._add(endpoint, b"", done=False)

    def heard(self, endpoint: int, data: bytes) -> None:
        """The device sends the report."""
        self._add(endpoint, data, done=True)
