"""Packets of every link that carries IP, taken apart by dpkt: it knows all that can stand before TCP and UDP."""

from __future__ import annotations

import struct
from collections.abc import Callable
from typing import Any

from dpkt import UnpackError, ip, ip6, loopback, sll, sll2, tcp, udp
from dpkt.ethernet import (
    ETH_TYPE_8021AD,
    ETH_TYPE_8021Q,
    ETH_TYPE_IP,
    ETH_TYPE_IP6,
    ETH_TYPE_MPLS,
    ETH_TYPE_MPLS_MCAST,
    ETH_TYPE_QINQ1,
    ETH_TYPE_PPPoE,
    Ethernet,
)

from ev3proto.capture.carriers.wifi.fragments import Fragment
from ev3proto.capture.carriers.wifi.internet import FLAGS, Ends, Transport, port_bytes
from ev3proto.tables.carriers import Link

_CARRIED: dict[int, type] = {ip.IP_PROTO_TCP: tcp.TCP, ip.IP_PROTO_UDP: udp.UDP}


class _IPv4(ip.IP):  # type: ignore[misc]
    """IP of which dpkt reads only what leads to TCP and UDP: it knows much more, and some of that without an end."""

    _protosw = _CARRIED

    def unpack(self, buf: bytes) -> None:
        self.raw = buf
        super().unpack(buf)

    @property
    def part(self) -> Fragment | None:
        """Which part of a packet it is; None where it is all of it, or was not captured as a whole."""
        if not self.mf and not self.offset:
            return None
        identity = self.id.to_bytes(2, "big") + bytes((self.p,))
        data = self.raw[4 * self.hl : self.len] if len(self.raw) >= self.len else b""
        return Fragment(self.src + self.dst, identity, self.p, self.offset * 8, not self.mf, data)


class _IPv6(ip6.IP6):  # type: ignore[misc]
    _protosw = _CARRIED

    def unpack(self, buf: bytes) -> None:
        self.raw = buf
        super().unpack(buf)

    @property
    def part(self) -> Fragment | None:
        """The same, which one of the headers after the first says."""
        at, end = self.__hdr_len__, self.__hdr_len__ + self.plen
        for header in self.all_extension_headers:
            at += header.length
            if isinstance(header, ip6.IP6FragmentHeader) and (header.m_flag or header.frag_off):
                data = self.raw[at:end] if len(self.raw) >= end else b""
                identity = header.id.to_bytes(4, "big")
                return Fragment(self.src + self.dst, identity, header.nxt, header.frag_off * 8, not header.m_flag, data)
        return None


_CARRIED |= {ip.IP_PROTO_IPIP: _IPv4, ip.IP_PROTO_IP6: _IPv6}

_TAGS = {kind.to_bytes(2, "big") for kind in (ETH_TYPE_8021Q, ETH_TYPE_8021AD, ETH_TYPE_QINQ1)}
_TAG_SIZE = 4
_LABEL_SIZE, _LAST_LABEL = 4, 0x01
_PPPOE_SIZE = 8
_VERSIONS = {4: _IPv4, 6: _IPv6}
_SESSIONS = {b"\0\x21": _IPv4, b"\0\x57": _IPv6}

_PACKED_KINDS = {b"\x88\xe7": "802.1ah"}
"""Ethernet's types of packets that have others in them, which are not taken apart here."""

_PACKED_PROTOCOLS = {ip.IP_PROTO_GRE: "GRE", ip.IP_PROTO_AH: "AH"}
"""The same of IP's protocols."""


class _PackedError(KeyError):
    """A packet has others in it, which are not taken apart here; it is named."""


def _of_kind(kind: bytes, data: bytes) -> Any:
    """What Ethernet's type says, after any tags of virtual networks."""
    at = 0
    while kind in _TAGS:
        kind = data[at + 2 : at + _TAG_SIZE]
        at += _TAG_SIZE
    if kind in _PACKED_KINDS:
        raise _PackedError(_PACKED_KINDS[kind])
    return _NETWORKS[kind](data[at:])


def _raw(data: bytes) -> Any:
    return _VERSIONS[data[0] >> 4](data)


def _after_labels(data: bytes) -> Any:
    """What comes after the labels of MPLS, the last of which says so. What it is, only its first bits tell."""
    end = next(end for end in range(_LABEL_SIZE, len(data), _LABEL_SIZE) if data[end - 2] & _LAST_LABEL)
    if data[end] >> 4 not in _VERSIONS:
        raise _PackedError("MPLS")
    return _raw(data[end:])


def _in_session(data: bytes) -> Any:
    """What PPPoE carries: before it come the number of the session, a length, and PPP's protocol."""
    return _SESSIONS[data[_PPPOE_SIZE - 2 : _PPPOE_SIZE]](data[_PPPOE_SIZE:])


_NETWORKS: dict[bytes, Callable[[bytes], Any]] = {
    ETH_TYPE_IP.to_bytes(2, "big"): _IPv4,
    ETH_TYPE_IP6.to_bytes(2, "big"): _IPv6,
    ETH_TYPE_MPLS.to_bytes(2, "big"): _after_labels,
    ETH_TYPE_MPLS_MCAST.to_bytes(2, "big"): _after_labels,
    ETH_TYPE_PPPoE.to_bytes(2, "big"): _in_session,
}


def _after_type(end: int) -> Callable[[bytes], Any]:
    """For links whose header ends with Ethernet's type."""
    return lambda data: _of_kind(data[end - 2 : end], data[end:])


LINKS: dict[int, Callable[[bytes], Any]] = {
    Link.ETHERNET: _after_type(Ethernet.__hdr_len__),
    # Systems have different numbers for IPv6 there, in either byte order: the packet itself says which it is.
    Link.LOOPBACK: lambda data: _raw(data[loopback.Loopback.__hdr_len__ :]),
    Link.LOOPBACK_OPENBSD: lambda data: _raw(data[loopback.Loopback.__hdr_len__ :]),
    Link.LINUX_COOKED: _after_type(sll.SLL.__hdr_len__),
    Link.LINUX_COOKED_2: lambda data: _of_kind(data[:2], data[sll2.SLL2.__hdr_len__ :]),
    Link.RAW_BSD: _raw,
    Link.RAW_OPENBSD: _raw,
    Link.RAW_IP: _raw,
    Link.IPV4: _IPv4,
    Link.IPV6: _IPv6,
}
"""What reads the packets of each link."""

# For packets cut short or made to confuse, which a capture may well have: dpkt's own, and what its code comes to.
_TROUBLE = (
    UnpackError,
    struct.error,
    StopIteration,
    IndexError,
    ValueError,
    KeyError,
    AttributeError,
    TypeError,
    RuntimeError,
)
MOST_LAYERS = 16
"""Packets of IP that are one in the other, at most."""


def dissected(link: int, data: bytes) -> Transport | None:
    """Takes a packet apart.

    Args:
        link: One of `LINKS`: what the packet starts with.
        data: The packet.

    Returns:
        The segment or datagram. None where there is none that can be read.

    """
    try:
        layer = _innermost(LINKS[link](data))
    except _TROUBLE:
        return None
    inner = None if layer is None or layer.part is not None else layer.data
    if isinstance(inner, tcp.TCP):
        return _ends(layer, inner), bytes(inner.data), inner.seq, inner.ack, inner._off_flags & FLAGS
    if isinstance(inner, udp.UDP):
        return _ends(layer, inner), bytes(inner.data), 0, 0, None
    return None


def left_in(link: int, data: bytes) -> Fragment | str | None:
    """Says what there is in a packet in which no segment and no datagram was read.

    Args:
        link: One of `LINKS`: what the packet starts with.
        data: The packet.

    Returns:
        The part of a packet that it carries, or the name of what other packets are packed into, which is not taken
        apart here. None where there is nothing like it.

    """
    try:
        layer = _innermost(LINKS[link](data))
    except _PackedError as error:
        return str(error.args[0])
    except _TROUBLE:
        return None
    if layer is None:
        return None
    return layer.part or _PACKED_PROTOCOLS.get(getattr(layer, "p", 0))


def _innermost(layer: Any) -> Any:
    """The last of packets of IP that are one in the other, or a part of one; None where there are too many."""
    for _ in range(MOST_LAYERS):
        if not isinstance(layer.data, _IPv4 | _IPv6) or layer.part is not None:
            return layer
        layer = layer.data
    return None


def _ends(layer: Any, inner: Any) -> Ends:
    ends: Ends = layer.src + layer.dst + port_bytes(inner.sport) + port_bytes(inner.dport)
    return ends
