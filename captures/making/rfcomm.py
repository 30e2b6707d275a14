"""RFCOMM's frames and the messages of the service directory, SDP."""

from __future__ import annotations

from scapy.fields import BitField, ByteField, ConditionalField, LenField, LEShortField, ShortField, XByteField
from scapy.packet import Packet

SERIAL_PORT = 0x1101
CHANNEL = 1
FRAME_SIZE = 250
CREDITS = 7
"""What both ends agree on: bytes in a frame, and frames that either may send before it gets more credits."""

# RFCOMM

SABM, UA, DISC, UIH, UIH_CREDITS = 0x3F, 0x73, 0x53, 0xEF, 0xFF


def frame_check(data: bytes) -> int:
    """RFCOMM's check sequence: a CRC with the polynomial x^8 + x^2 + x + 1, lowest bit first."""
    rest = 0xFF
    for byte in data:
        rest ^= byte
        for _ in range(8):
            rest = rest >> 1 ^ 0xE0 * (rest & 1)
    return 0xFF - rest


class Rfcomm(Packet):
    """An RFCOMM frame. The length and the check at its end are worked out."""

    name = "RFCOMM"
    fields_desc = [  # noqa: RUF012 - scapy's way to declare a packet, here and below
        BitField("dlci", 0, 6),
        BitField("command", 0, 1),
        BitField("last", 1, 1),
        XByteField("control", UIH),
        ConditionalField(ByteField("credits", 0), lambda packet: packet.control == UIH_CREDITS),
    ]

    def post_build(self, pkt: bytes, pay: bytes) -> bytes:
        """Puts the length behind the control field and the check behind all."""
        size = len(pay)
        length = bytes((size << 1 | 1,)) if size < 0x80 else (size << 1).to_bytes(2, "little")
        # Frames with data are checked without their length.
        checked = pkt[:2] if self.control in (UIH, UIH_CREDITS) else pkt[:2] + length
        return pkt[:2] + length + pkt[2:] + pay + bytes((frame_check(checked),))


class Multiplexer(Packet):
    """A command or response on DLCI 0."""

    name = "RFCOMM multiplexer"
    fields_desc = [  # noqa: RUF012
        BitField("kind", 0, 6),
        BitField("command", 1, 1),
        BitField("last_kind", 1, 1),
        BitField("length", 0, 7),
        BitField("last_length", 1, 1),
    ]


class Negotiation(Packet):
    """PN: what a DLCI is to be like."""

    name = "RFCOMM parameter negotiation"
    fields_desc = [  # noqa: RUF012
        ByteField("dlci", 0),
        XByteField("flow", 0xF0),
        ByteField("priority", 7),
        ByteField("acknowledgement_timer", 0),
        LEShortField("frame_size", FRAME_SIZE),
        ByteField("retransmissions", 0),
        ByteField("credits", CREDITS),
    ]


class ModemStatus(Packet):
    """MSC: the lines of a serial port."""

    name = "RFCOMM modem status"
    fields_desc = [  # noqa: RUF012
        BitField("dlci", 0, 6),
        BitField("one", 1, 1),
        BitField("last", 1, 1),
        XByteField("lines", 0x8D),
    ]


PN, MSC = 0x20, 0x38

# SDP


class Sdp(Packet):
    """The head of a message to or from a service directory."""

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
"""The search for a serial port: pattern, most bytes, all attributes, no continuation."""

FOUND = sequence(
    sequence(
        *(number(0x0000, 2), number(0x00010001, 4)),
        *(number(0x0001, 2), sequence(uuid(SERIAL_PORT))),
        *(number(0x0004, 2), sequence(sequence(uuid(0x0100)), sequence(uuid(0x0003), number(CHANNEL, 1)))),
        *(number(0x0005, 2), sequence(uuid(0x1002))),
        *(number(0x0100, 2), text("Serial Port")),
    )
)
"""What the directory knows: handle, classes, protocols (L2CAP, RFCOMM channel 1), where to browse it, name."""
