"""Files of `hcidump -w`, which are recognised, but not read."""

from __future__ import annotations

import struct
from collections.abc import Iterator
from typing import BinaryIO

from ev3proto.capture.packets import Format, Packet
from ev3proto.capture.record import CaptureError

_record = struct.Struct("<HBBIIB")
"""Length, 1 for a received packet, zero, seconds, microseconds, packet type of HCI."""

_OLDEST, _SECOND, _TYPES = 978_307_200, 1_000_000, (1, 2, 3, 4)


def _is_start(head: bytes) -> bool | None:
    """Returns whether a file begins with such a record; None for too few bytes. Unlike texts, records have zeros."""
    if len(head) < _record.size:
        return None if not head or b"\0" in head else False
    length, is_received, zero, seconds, microseconds, kind = _record.unpack_from(head)
    is_time = seconds >= _OLDEST and microseconds < _SECOND
    return length > 0 and is_received < 2 and not zero and is_time and kind in _TYPES


def packets(_stream: BinaryIO) -> Iterator[Packet]:
    """Raises CaptureError."""
    raise CaptureError("a file of hcidump -w, which is not read here; --engine wireshark reads it")
    yield


FORMAT = Format("hcidump -w", (), _record.size, _is_start, packets, is_read=False)
