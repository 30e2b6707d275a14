"""USB requests as Linux and Windows record them: device, endpoint and data."""

from __future__ import annotations

import struct
from typing import NamedTuple

from ev3proto.capture.packets import Packet
from ev3proto.schema.header import frame_size
from ev3proto.tables.carriers import Link

USBMON = {order: struct.Struct(order + "QBBBBHBBQIIII8s") for order in "<>"}
"""Linux's header of each packet (Documentation/usb/usbmon), in the byte order of the machine.

Identifier, event, transfer type, endpoint, device, bus, whether setup and data are missing, seconds, microseconds,
status, size, captured length, setup.
"""

USBMON_MORE = 16
"""Size of the part that newer kernels add, in bytes."""

_USBPCAP = struct.Struct("<HQIHBHHBBI")
"""USBPcap's header of each packet (https://desowin.org/usbpcap/captureformat.html).

Size of the header, identifier, status, function, direction, bus, device, endpoint, transfer type, captured length.
"""

CONTROL, INTERRUPT = 2, 1
"""Transfer types."""

IN = 0x80
"""The bit of endpoints that send to the host."""

_DEVICE_DESCRIPTOR = bytes((18, 1))


class Urb(NamedTuple):
    """A USB request, on its submission or its completion."""

    device: str  # bus and number: `1.7`
    endpoint: int  # with the direction bit
    transfer: int  # transfer type
    data: bytes  # the data in this packet; empty in the other half of a request

    @property
    def is_from_host(self) -> bool:
        """Whether the computer sends it."""
        return not self.endpoint & IN

    @property
    def frame(self) -> bytes:
        """The data as far as their length field tells."""
        return self.data[: frame_size(self.data)]

    @property
    def product(self) -> tuple[int, int] | None:
        """Vendor and product, if it is a device descriptor."""
        if self.transfer != CONTROL or len(self.data) < 12 or not self.data.startswith(_DEVICE_DESCRIPTOR):
            return None
        return int.from_bytes(self.data[8:10], "little"), int.from_bytes(self.data[10:12], "little")


def urb(packet: Packet) -> Urb | None:
    """Returns the request in a packet of one of the three link types; None if it is too short for its header."""
    data = packet.data
    link = packet.interface.link
    if link == Link.USBPCAP:
        if len(data) < _USBPCAP.size:
            return None
        head, _, _, _, _, bus, device, endpoint, transfer, _ = _USBPCAP.unpack_from(data)
        return Urb(f"{bus}.{device}", endpoint, transfer, data[head:])
    header = USBMON[packet.interface.order]
    size = header.size + (USBMON_MORE if link == Link.USBMON_PADDED else 0)
    if len(data) < size:
        return None
    _, _, transfer, endpoint, device, bus, *_ = header.unpack_from(data)
    return Urb(f"{bus}.{device}", endpoint, transfer, data[size:])
