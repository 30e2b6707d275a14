"""btsnoop files: Bluetooth traffic as Android and BlueZ write it. The format is RFC 1761 with other numbers."""

from __future__ import annotations

import struct
from collections.abc import Iterator
from operator import itemgetter
from typing import BinaryIO

from ev3proto.capture.packets import Format, Interface, Packet, begins_with, records
from ev3proto.capture.record import CaptureError
from ev3proto.tables.carriers import Link

_MAGIC = b"btsnoop\0"

_header = struct.Struct(">8sII")
"""Magic, version, link type."""

_record = struct.Struct(">IIIIQ")
"""Size, captured length, flags, number of dropped packets, microseconds."""

# Times count from the year 0.
_EPOCH = 0x00DCDDB30F2F8000

_WITHOUT_TYPE = 1001

LINKS = {_WITHOUT_TYPE: Link.HCI, 1002: Link.HCI, 2001: Link.BLUETOOTH_MONITOR}
"""Link types by the format's own numbers: HCI without and with its packet type, and BlueZ's monitor."""

_TYPES = {0: b"\2", 1: b"\2", 2: b"\1", 3: b"\4"}
"""The packet type of HCI by the flags: 1 for a received packet, 2 for a command or an event."""


def packets(stream: BinaryIO) -> Iterator[Packet]:
    """Yields the packets of a file. Raises CaptureError for a damaged one, after everything readable."""
    head = stream.read(_header.size)
    if len(head) < _header.size:
        raise CaptureError("the file is cut off in its header")
    _, version, link = _header.unpack(head)
    if link not in LINKS:
        kinds = ", ".join(map(str, LINKS))
        raise CaptureError(
            f"unknown packet kind {link} of a btsnoop file of version {version}; expected one of {kinds}"
        )
    interface = Interface(LINKS[link])
    for number, (size, _, flags, _, microseconds), data in records(stream, _record, len(head), itemgetter(1)):
        kind = _TYPES[flags & 3] if link == _WITHOUT_TYPE else b""
        yield Packet(number, (microseconds - _EPOCH) * 1000, kind + data, len(kind) + size, interface, flags)


FORMAT = Format("btsnoop", (".btsnoop", ".cfa", ".log"), len(_MAGIC), begins_with(_MAGIC), packets)
