"""Packets of all link types that carry IP, dissected by dpkt, which knows the headers before TCP and UDP."""

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
    """IPv4, in which dpkt reads only TCP, UDP and IP: it recurses without limit in some of the others."""

    _protosw = _CARRIED

    def unpack(self, buf: bytes) -> None:
        self.raw = buf
        super().unpack(buf)

    @property
    def part(self) -> Fragment | None:
        """The fragment, if it is one; its data is empty if it was cut."""
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
        """The same, from one of the extension headers."""
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
"""Ethernet types of tunnels, which are not unpacked."""

_PACKED_PROTOCOLS = {ip.IP_PROTO_GRE: "GRE", ip.IP_PROTO_AH: "AH"}
"""IP protocols of tunnels, which are not unpacked."""


class _PackedError(KeyError):
    """A packet is a tunnel that is not unpacked; it has the tunnel's name."""


def _of_kind(kind: bytes, data: bytes) -> Any:
    """Dissects a packet by its Ethernet type, after any VLAN tags."""
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
    """Dissects what follows the MPLS labels. Only its first bits tell its type."""
    end = next(end for end in range(_LABEL_SIZE, len(data), _LABEL_SIZE) if data[end - 2] & _LAST_LABEL)
    if data[end] >> 4 not in _VERSIONS:
        raise _PackedError("MPLS")
    return _raw(data[end:])


def _in_session(data: bytes) -> Any:
    """Dissects what follows PPPoE's session number, length and PPP protocol."""
    return _SESSIONS[data[_PPPOE_SIZE - 2 : _PPPOE_SIZE]](data[_PPPOE_SIZE:])


_NETWORKS: dict[bytes, Callable[[bytes], Any]] = {
    ETH_TYPE_IP.to_bytes(2, "big"): _IPv4,
    ETH_TYPE_IP6.to_bytes(2, "big"): _IPv6,
    ETH_TYPE_MPLS.to_bytes(2, "big"): _after_labels,
    ETH_TYPE_MPLS_MCAST.to_bytes(2, "big"): _after_labels,
    ETH_TYPE_PPPoE.to_bytes(2, "big"): _in_session,
}


def _after_type(end: int) -> Callable[[bytes], Any]:
    """Returns the dissector of a link type whose header ends with the Ethernet type."""
    return lambda data: _of_kind(data[end - 2 : end], data[end:])


LINKS: dict[int, Callable[[bytes], Any]] = {
    Link.ETHERNET: _after_type(Ethernet.__hdr_len__),
    # Systems have different numbers for IPv6, in either byte order; the packet itself tells its version.
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
"""The dissectors of packets by link type."""

# dpkt's own errors, and those that its code runs into with cut or malformed packets.
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
"""Maximum nesting depth of IP packets."""


def dissected(link: int, data: bytes) -> Transport | None:
    """Returns the segment or datagram in a packet of one of `LINKS`, if it has one that can be read."""
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
    """Returns what a packet without a segment or datagram has: a fragment, or the name of a tunnel."""
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
    """Returns the innermost IP packet, or the first fragment; None beyond the maximum depth."""
    for _ in range(MOST_LAYERS):
        if not isinstance(layer.data, _IPv4 | _IPv6) or layer.part is not None:
            return layer
        layer = layer.data
    return None


def _ends(layer: Any, inner: Any) -> Ends:
    ends: Ends = layer.src + layer.dst + port_bytes(inner.sport) + port_bytes(inner.dport)
    return ends
