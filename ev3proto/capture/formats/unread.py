"""Formats that are recognised and not read: what such a file is, and what to do with it."""

from __future__ import annotations

import struct
from collections.abc import Callable, Iterator
from typing import BinaryIO

from ev3proto.capture.packets import Format, Packet, begins_with, without_magic
from ev3proto.capture.record import CaptureError

BTSNOOZ = (
    "Android's compressed log of Bluetooth (btsnooz), which is not read here; btsnooz.py of Android's sources makes"
    " btsnoop of it, with the first bytes of each packet; a whole log is data/misc/bluetooth/logs/btsnoop_hci.log in"
    " the zip file of a bug report"
)

_record = struct.Struct("<HBBIIB")
"""A record of hcidump: length, 1 for a received packet, zero, seconds, microseconds, packet type of HCI."""

_OLDEST, _SECOND, _TYPES = 978_307_200, 1_000_000, (1, 2, 3, 4)

_summary = struct.Struct("<BQ")
"""The header of btsnooz: version, milliseconds since 1970. A stream of zlib follows."""

_VERSIONS, _ZLIB = (1, 2), b"\x78"
_YEARS = range(1_000_000_000_000, 10_000_000_000_000)


def _is_hcidump(head: bytes) -> bool:
    length, is_received, zero, seconds, microseconds, kind = _record.unpack_from(head)
    is_time = seconds >= _OLDEST and microseconds < _SECOND
    return length > 0 and is_received < 2 and not zero and is_time and kind in _TYPES


def _is_btsnooz(head: bytes) -> bool:
    version, milliseconds = _summary.unpack_from(head)
    return version in _VERSIONS and milliseconds in _YEARS and head[_summary.size :].startswith(_ZLIB)


def _unread(name: str, needs: int, matches: Callable[[bytes], bool | None], sentence: str) -> Format:
    """Returns a format whose files are refused with a sentence."""

    def packets(_stream: BinaryIO) -> Iterator[Packet]:
        raise CaptureError(sentence)
        yield

    return Format(name, (), needs, matches, packets)


_NETLOG = b'{"constants":'

FORMATS = (
    _unread(
        "hcidump -w",
        _record.size,
        without_magic(_record.size, _is_hcidump),
        "a file of hcidump -w, which is not read here; --engine wireshark reads it",
    ),
    _unread("btsnooz", _summary.size + 1, without_magic(_summary.size + 1, _is_btsnooz), BTSNOOZ),
    _unread(
        "NetLog",
        len(_NETLOG),
        begins_with(_NETLOG),
        "a NetLog of Chrome, which has requests of pages, not what Web Serial or Web Bluetooth carry; record USB or"
        " Bluetooth of the computer, or connect through `ev3proto proxy`",
    ),
)
