"""The messages of the service discovery protocol, SDP, by which a host finds the serial port."""

from __future__ import annotations

from scapy.fields import LenField, ShortField, XByteField
from scapy.packet import Packet

from ev3proto.tables.carriers import RFCOMM_CHANNEL

SERIAL_PORT = 0x1101


class Sdp(Packet):
    """The header of a message to or from a service directory."""

    name = "SDP"
    fields_desc = [XByteField("kind", 0), ShortField("transaction", 0), LenField("length", None)]  # noqa: RUF012


def number(value: int, size: int) -> bytes:
    """A data element: an unsigned number of 1, 2 or 4 bytes."""
    return bytes((1 << 3 | size.bit_length() - 1,)) + value.to_bytes(size, "big")


def uuid(value: int) -> bytes:
    """A data element: a short UUID."""
    return bytes((3 << 3 | 1,)) + value.to_bytes(2, "big")


def text(value: str) -> bytes:
    """A data element: a text."""
    return bytes((4 << 3 | 5, len(value))) + value.encode()


def sequence(*elements: bytes) -> bytes:
    """A data element: others, one after the other."""
    data = b"".join(elements)
    return bytes((6 << 3 | 5, len(data))) + data


SEARCH = sequence(uuid(SERIAL_PORT)) + b"\x02\x00" + sequence(number(0x0000FFFF, 4)) + b"\0"
"""The search for a serial port: pattern, maximum size, all attributes, no continuation."""

FOUND = sequence(
    sequence(
        *(number(0x0000, 2), number(0x00010001, 4)),
        *(number(0x0001, 2), sequence(uuid(SERIAL_PORT))),
        *(number(0x0004, 2), sequence(sequence(uuid(0x0100)), sequence(uuid(0x0003), number(RFCOMM_CHANNEL, 1)))),
        *(number(0x0005, 2), sequence(uuid(0x1002))),
        *(number(0x0100, 2), text("Serial Port")),
    )
)
"""The record in the directory: handle, classes, protocols (L2CAP, RFCOMM channel 1), browse group, name."""
