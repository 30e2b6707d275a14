"""Packets of all link types that carry IP, dissected by dpkt, which knows the headers before TCP and UDP."""

from __future__ import annotations

import struct
from collections.abc import Callable
from typing import Any

from dpkt import UnpackError, ip, ip6, loopback, sll, sll2, tcp, udp
from dpkt.ethernet import ETH_TYPE_8021AD, ETH_TYPE_8021Q, ETH_TYPE_IP, ETH_TYPE_IP6, ETH_TYPE_QINQ1, Ethernet

from ev3proto.capture.carriers.wifi.internet import FLAGS, IS_FRAGMENT, Ends, Transport, port_bytes
from ev3proto.tables.carriers import Link

_CARRIED: dict[int, type] = {ip.IP_PROTO_TCP: tcp.TCP, ip.IP_PROTO_UDP: udp.UDP}


class _IPv4(ip.IP):  # type: ignore[misc]
    """IPv4, in which dpkt reads only TCP and UDP: it recurses without limit in some of the others."""

    _protosw = _CARRIED

    @property
    def is_fragment(self) -> bool:
        """Whether it has a part of a packet."""
        return bool(self._flags_offset & IS_FRAGMENT)


class _IPv6(ip6.IP6):  # type: ignore[misc]
    _protosw = _CARRIED

    @property
    def is_fragment(self) -> bool:
        """The same, by one of the extension headers."""
        headers = (header for header in self.all_extension_headers if isinstance(header, ip6.IP6FragmentHeader))
        return any(header.m_flag or header.frag_off for header in headers)


_TAGS = {kind.to_bytes(2, "big") for kind in (ETH_TYPE_8021Q, ETH_TYPE_8021AD, ETH_TYPE_QINQ1)}
_TAG_SIZE = 4
_VERSIONS = {4: _IPv4, 6: _IPv6}
_NETWORKS = {ETH_TYPE_IP.to_bytes(2, "big"): _IPv4, ETH_TYPE_IP6.to_bytes(2, "big"): _IPv6}


def _of_kind(kind: bytes, data: bytes) -> Any:
    """Dissects a packet by its Ethernet type, after any VLAN tags."""
    at = 0
    while kind in _TAGS:
        kind = data[at + 2 : at + _TAG_SIZE]
        at += _TAG_SIZE
    return _NETWORKS[kind](data[at:])


def _raw(data: bytes) -> Any:
    return _VERSIONS[data[0] >> 4](data)


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


def dissected(link: int, data: bytes) -> Transport | None:
    """Returns the segment or datagram in a packet of one of `LINKS`; None if it has none, or only a fragment."""
    try:
        layer = LINKS[link](data)
        inner = None if layer.is_fragment else layer.data
    except _TROUBLE:
        return None
    if isinstance(inner, tcp.TCP):
        return _ends(layer, inner), bytes(inner.data), inner.seq, inner.ack, inner._off_flags & FLAGS
    if isinstance(inner, udp.UDP):
        return _ends(layer, inner), bytes(inner.data), 0, 0, None
    return None


def _ends(layer: Any, inner: Any) -> Ends:
    ends: Ends = layer.src + layer.dst + port_bytes(inner.sport) + port_bytes(inner.dport)
    return ends
