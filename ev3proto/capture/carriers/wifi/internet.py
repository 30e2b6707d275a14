"""TCP segments and UDP datagrams in packets of every link that carries IP."""

from __future__ import annotations

import struct
from functools import partial
from typing import NamedTuple

from ev3proto.tables.carriers import Link

SYN, RST, ACK = 0x002, 0x004, 0x010
"""Flags of TCP."""

FLAGS = 0x1FF
"""All of them, in the two bytes that also have the length of the header."""

_plain = struct.Struct(">BxH2xHxB2x4s4s HHIIH6x")
"""Of IPv4: version, length, fragment, protocol, addresses. Of TCP: ports, numbers, length with flags."""

_STARTS = {int(Link.ETHERNET): 14, int(Link.RAW_IP): 0, int(Link.IPV4): 0}
"""Where IP starts in the packets of some links."""

_IS_IP = b"\x08\0"  # Ethernet's type
_NO_OPTIONS = 0x45  # version 4, and the least length that its header can have
_IP_SIZE = 20
_IS_TCP = 6
_IS_FRAGMENT = 0x3FFF


class Transport(NamedTuple):
    """A TCP segment or a UDP datagram.

    source, target            addresses, 4 or 16 bytes
    source_port, target_port  ports
    data                      what it carries
    sequence, acknowledged    TCP's numbers, 0 for UDP
    flags                     TCP's flags; None for UDP
    """

    source: bytes
    target: bytes
    source_port: int
    target_port: int
    data: bytes
    sequence: int = 0
    acknowledged: int = 0
    flags: int | None = None


_made = partial(tuple.__new__, Transport)
"""Makes one of a tuple of all its fields, in half the time that `Transport` takes: `pytest benchmarks -k capture`."""


def transport(link: int, data: bytes) -> Transport | None:
    """What a packet of one of the links carries; None where there is none that can be read."""
    start = _STARTS.get(link)
    if start is not None and len(data) >= start + _plain.size:
        # Nearly every packet of a capture of TCP: no options in IP, no fragment, nothing between Ethernet and IP.
        # Without dpkt's objects it takes a tenth of the time: `pytest benchmarks -k capture`.
        version, length, fragment, protocol, source, target, source_port, target_port, sequence, acknowledged, flags = (
            _plain.unpack_from(data, start)
        )
        is_tcp = version == _NO_OPTIONS and protocol == _IS_TCP and not fragment & _IS_FRAGMENT
        if is_tcp and (start == 0 or data[start - 2 : start] == _IS_IP):
            head = _IP_SIZE + (flags >> 12 << 2)
            if _plain.size <= head <= length:
                carried = data[start + head : start + length]
                return _made((source, target, source_port, target_port, carried, sequence, acknowledged, flags & FLAGS))
    # All others are taken apart by dpkt, which takes a while to import.
    from ev3proto.capture.carriers.wifi.layers import dissected

    return dissected(link, data)


def place(address: bytes, port: int) -> str:
    """`192.0.2.1:49152`, `[2001:db8::1]:49152`."""
    if len(address) == 4:
        return f"{'.'.join(map(str, address))}:{port}"
    import socket

    return f"[{socket.inet_ntop(socket.AF_INET6, address)}]:{port}"
