"""TCP segments and UDP datagrams in packets of every link that carries IP. dpkt knows the headers."""

from __future__ import annotations

import struct
from collections.abc import Callable
from typing import Any, NamedTuple

from dpkt import UnpackError, ip, ip6, loopback, sll, sll2, tcp, udp
from dpkt.ethernet import ETH_TYPE_IP, Ethernet
from dpkt.utils import inet_to_str

from ev3proto.capture.packets import Link


def _raw(data: bytes) -> Any:
    return (ip6.IP6 if data[:1] and data[0] >> 4 == 6 else ip.IP)(data)


LINKS: dict[int, Callable[[bytes], Any]] = {
    Link.ETHERNET: Ethernet,
    Link.LOOPBACK: loopback.Loopback,
    Link.LOOPBACK_OPENBSD: loopback.Loopback,
    Link.LINUX_COOKED: sll.SLL,
    Link.LINUX_COOKED_2: sll2.SLL2,
    Link.RAW_BSD: _raw,
    Link.RAW_OPENBSD: _raw,
    Link.RAW_IP: _raw,
    Link.IPV4: ip.IP,
    Link.IPV6: ip6.IP6,
}
"""What reads the packets of each link."""

_INTERNET = (ip.IP, ip6.IP6)
_plain = struct.Struct(ip.IP.__hdr_fmt__ + tcp.TCP.__hdr_fmt__[1:])
_PLAIN: dict[int, int] = {Link.ETHERNET: Ethernet.__hdr_len__, Link.RAW_IP: 0, Link.IPV4: 0}
_IS_IP = ETH_TYPE_IP.to_bytes(2, "big")
_IP_SIZE = ip.IP.__hdr_len__
_NO_OPTIONS = 0x45
_FRAGMENT = ip.IP_MF | ip.IP_OFFMASK
_FLAGS = 0x1FF

# dpkt raises these for packets cut short or made to confuse, which a capture may well have.
_TROUBLE = (UnpackError, struct.error, IndexError, ValueError, KeyError, AttributeError, TypeError, RecursionError)
_MOST_LAYERS = 16


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


def transport(link: int, data: bytes) -> Transport | None:
    """What a packet of one of the links carries; None where there is none that can be read."""
    start = _PLAIN.get(link)
    if start is not None and len(data) >= start + _plain.size:
        # Nearly every packet of a capture of TCP: no options in IP, no fragment, nothing between Ethernet and IP.
        # With dpkt's structs but without its objects it takes a seventh of the time: `pytest benchmarks -k capture`.
        version, _, length, _, fragment, _, protocol, _, source, target, *rest = _plain.unpack_from(data, start)
        is_tcp = version == _NO_OPTIONS and protocol == ip.IP_PROTO_TCP and not fragment & _FRAGMENT
        if is_tcp and (start == 0 or data[start - 2 : start] == _IS_IP):
            source_port, target_port, sequence, acknowledged, flags, *_ = rest
            head = _IP_SIZE + (flags >> 12 << 2)
            if _plain.size <= head <= length:
                carried = data[start + head : start + length]
                return Transport(
                    source, target, source_port, target_port, carried, sequence, acknowledged, flags & _FLAGS
                )
    return _dissected(LINKS[link], data)


def _dissected(read: Callable[[bytes], Any], data: bytes) -> Transport | None:
    """The same with dpkt, which knows everything that can stand there."""
    try:
        layer = read(data)
    except _TROUBLE:
        return None
    for _ in range(_MOST_LAYERS):
        inner = getattr(layer, "data", None)
        if isinstance(layer, _INTERNET):
            if isinstance(inner, tcp.TCP):
                flags = inner._off_flags & _FLAGS
                return Transport(
                    layer.src, layer.dst, inner.sport, inner.dport, bytes(inner.data), inner.seq, inner.ack, flags
                )
            if isinstance(inner, udp.UDP):
                return Transport(layer.src, layer.dst, inner.sport, inner.dport, bytes(inner.data))
        if isinstance(inner, bytes) or inner is None:
            return None
        layer = inner
    return None


def place(address: bytes, port: int) -> str:
    """`192.0.2.1:49152`, `[2001:db8::1]:49152`."""
    text = inet_to_str(address)
    return f"[{text}]:{port}" if len(address) > 4 else f"{text}:{port}"
