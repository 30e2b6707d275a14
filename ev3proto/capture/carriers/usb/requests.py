"""USB requests as Linux and Windows record them: which device and endpoint, and the bytes that went over."""

from __future__ import annotations

from typing import NamedTuple

from construct import Bytes, Int8ul, Int16ul, Int32ul, Int64ul, Struct

from ev3proto.capture.packets import Packet
from ev3proto.schema.bytewise import packed
from ev3proto.tables.carriers import Link

USBMON = Struct(
    "id" / Int64ul,
    "event" / Int8ul,
    "transfer" / Int8ul,
    "endpoint" / Int8ul,
    "device" / Int8ul,
    "bus" / Int16ul,
    "has_no_setup" / Int8ul,
    "has_no_data" / Int8ul,
    "seconds" / Int64ul,
    "microseconds" / Int32ul,
    "status" / Int32ul,
    "size" / Int32ul,
    "captured" / Int32ul,
    "setup" / Bytes(8),
)
"""What Linux writes before each packet (Documentation/usb/usbmon), in the byte order of the machine."""

USBMON_MORE = 16
"""Bytes that newer kernels add to it."""

USBPCAP = Struct(
    "header" / Int16ul,
    "id" / Int64ul,
    "status" / Int32ul,
    "function" / Int16ul,
    "info" / Int8ul,
    "bus" / Int16ul,
    "device" / Int16ul,
    "endpoint" / Int8ul,
    "transfer" / Int8ul,
    "captured" / Int32ul,
)
"""What USBPcap writes before each packet (https://desowin.org/usbpcap/captureformat.html)."""

_usbmon = {order: packed(USBMON, order) for order in "<>"}
_usbpcap = packed(USBPCAP)

CONTROL, INTERRUPT = 2, 1
"""Kinds of transfers."""

IN = 0x80
"""The bit of an endpoint whose data goes to the host."""

_DEVICE_DESCRIPTOR = bytes((18, 1))


class Urb(NamedTuple):
    """A USB request, when it is handed in or when it is done.

    device    bus and number: `1.7`
    endpoint  with the bit for the direction
    transfer  kind of transfer
    data      what went over with this packet; nothing for the half of a request that has no data
    """

    device: str
    endpoint: int
    transfer: int
    data: bytes

    @property
    def product(self) -> tuple[int, int] | None:
        """Vendor and product, where it is a device descriptor."""
        if self.transfer != CONTROL or len(self.data) < 12 or not self.data.startswith(_DEVICE_DESCRIPTOR):
            return None
        return int.from_bytes(self.data[8:10], "little"), int.from_bytes(self.data[10:12], "little")


def urb(packet: Packet) -> Urb | None:
    """The request in a packet of one of the three links; None for a packet that is too short for its header."""
    data = packet.data
    link = packet.interface.link
    if link == Link.USBPCAP:
        if len(data) < _usbpcap.size:
            return None
        head, _, _, _, _, bus, device, endpoint, transfer, _ = _usbpcap.unpack_from(data)
        return Urb(f"{bus}.{device}", endpoint, transfer, data[head:])
    header = _usbmon[packet.interface.order]
    size = header.size + (USBMON_MORE if link == Link.USBMON_PADDED else 0)
    if len(data) < size:
        return None
    _, _, transfer, endpoint, device, bus, *_ = header.unpack_from(data)
    return Urb(f"{bus}.{device}", endpoint, transfer, data[size:])
