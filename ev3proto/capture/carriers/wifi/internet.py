"""TCP segments and UDP datagrams in packets, and the addresses of their ends."""

from __future__ import annotations

import socket
import struct
from collections.abc import Callable
from typing import Any

from ev3proto.tables.carriers import Link

SYN, RST, ACK = 0x002, 0x004, 0x010
"""Flags of TCP."""

FLAGS = 0x1FF
"""All flags, in the two bytes that also have the header's length."""

_IS_IP = b"\x08\0"
"""Ethernet's type."""

_NO_OPTIONS = b"\x45"
"""Version 4, and the minimum header length."""

_IP_SIZE, _LEAST = 20, 40
_REST = "xH2xHxB2x12sIIH"
"""IPv4: length, fragment, protocol, addresses. TCP: ports, right after these, sequence numbers, length with flags."""


def _layout(before: int, start: bytes) -> tuple[int, bytes, Callable[[bytes], tuple[Any, ...]]]:
    """Returns the bytes before IP, what the last of them and IP's first one must be, and the function that unpacks."""
    skipped = before + len(_NO_OPTIONS) - len(start)
    return before, start, struct.Struct(f">{skipped}x{len(start)}s{_REST}").unpack_from


_LAYOUTS = {
    int(Link.ETHERNET): _layout(14, _IS_IP + _NO_OPTIONS),
    int(Link.RAW_IP): _layout(0, _NO_OPTIONS),
    int(Link.IPV4): _layout(0, _NO_OPTIONS),
}
"""The usual layouts: no IP options, nothing between Ethernet and IP."""

_IS_TCP = 6
IS_FRAGMENT = 0x3FFF
"""The bits of IPv4 that are set in fragments."""

Ends = bytes
"""Sender and receiver: both addresses, then both ports, as in the headers of IPv4 and TCP."""

Endpoint = bytes
"""One end: address and port."""

PORT_SIZE = 2
PORTS = 1 << 8 * PORT_SIZE

Transport = tuple[Ends, bytes, int, int, int | None]
"""A TCP segment or a UDP datagram: ends, data, sequence number, acknowledgement number, flags; 0, 0 and None for UDP.

A plain tuple, as one is made for each packet: `pytest benchmarks -k capture`.
"""


def usual_transport(link: int, data: bytes) -> Transport | None:
    """Returns the segment in a packet of a usual layout, else None."""
    layout = _LAYOUTS.get(link)
    if layout is not None and len(data) >= layout[0] + _LEAST:
        # Takes a tenth of dpkt's time, which halves the time of reading a capture: `pytest benchmarks -k capture`.
        before, expected, unpack = layout
        start, length, fragment, protocol, ends, sequence, acknowledged, flags = unpack(data)
        if start == expected and protocol == _IS_TCP and not fragment & IS_FRAGMENT:
            head = _IP_SIZE + (flags >> 12 << 2)
            if _LEAST <= head <= length:
                return ends, data[before + head : before + length], sequence, acknowledged, flags & FLAGS
    return None


def source_of(ends: Ends) -> Endpoint:
    """Returns the sender."""
    size = len(ends) // 2 - PORT_SIZE
    return ends[:size] + ends[-2 * PORT_SIZE : -PORT_SIZE]


def target_of(ends: Ends) -> Endpoint:
    """Returns the receiver."""
    size = len(ends) // 2 - PORT_SIZE
    return ends[size : -2 * PORT_SIZE] + ends[-PORT_SIZE:]


def source_port(ends: Ends) -> bytes:
    """Returns the sender's port."""
    return ends[-2 * PORT_SIZE : -PORT_SIZE]


def target_port(ends: Ends) -> bytes:
    """Returns the receiver's port."""
    return ends[-PORT_SIZE:]


def port_bytes(port: int) -> bytes:
    """Returns a port's number as its two bytes."""
    return port.to_bytes(PORT_SIZE, "big")


def reversed_ends(ends: Ends) -> Ends:
    """Returns the ends with sender and receiver swapped."""
    size = len(ends) // 2 - PORT_SIZE
    return ends[size : -2 * PORT_SIZE] + ends[:size] + ends[-PORT_SIZE:] + ends[-2 * PORT_SIZE : -PORT_SIZE]


def shown(place: Endpoint) -> str:
    """Returns an end as text: `192.0.2.1:49152`, `[2001:db8::1]:49152`."""
    address, port = place[:-PORT_SIZE], int.from_bytes(place[-PORT_SIZE:], "big")
    if len(address) == 4:
        return f"{'.'.join(map(str, address))}:{port}"
    return f"[{socket.inet_ntop(socket.AF_INET6, address)}]:{port}"
