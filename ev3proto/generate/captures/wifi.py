"""WiFi: the beacon and its answer, then a TCP connection with sequence numbers and acknowledgements.

dpkt builds the packets around the connection. Those inside it differ in a few numbers only, so one template with its
own checksums makes them: exporting is ten times as fast that way.
"""

from __future__ import annotations

import struct
from dataclasses import dataclass
from ipaddress import ip_address

from dpkt.ethernet import ETH_TYPE_IP, ETH_TYPE_IP6, Ethernet
from dpkt.ip import IP, IP_PROTO_TCP, IP_PROTO_UDP
from dpkt.ip6 import IP6
from dpkt.tcp import TCP, TH_ACK, TH_FIN, TH_PUSH, TH_SYN
from dpkt.udp import UDP

from ev3proto.schema.discovery import Beacon, Unlock
from ev3proto.tables.discovery import ACCEPT, BEACON_PORT, TCP_PORT

SERIAL = "06165300000a"
"""Serial number of the brick: a MAC address from a range assigned to no vendor."""

BEACON_SOURCE = 3016
"""Port that the brick sends its beacon from."""

EVERYBODY_MAC, EVERYBODY = b"\xff" * 6, bytes((192, 0, 2, 255))

_OPTIONS = struct.pack(">BBHBBBBBBBB", 2, 4, 1460, 1, 1, 4, 2, 1, 3, 3, 7)
"""TCP options of both ends: segments of at most 1460 bytes, selective acknowledgements, windows in units of 128."""

_FIRST_WINDOW, _WINDOW = 64240, 502


Address = tuple[str, int]
"""An IP address, version 4 or 6, and a TCP port."""

_IPV4 = 4
"""Bytes of an IPv4 address."""


@dataclass(slots=True)
class _End:
    """One end of the connection."""

    mac: bytes
    address: bytes
    port: int
    number: int  # sequence number of its next byte
    packets: int  # number of its next packet


_SEGMENT = struct.Struct(">6s6sH BBHHHBBH4s4s HHIIHHHH")
"""Ethernet, IP and TCP without options."""

_IP_SIZE = _TCP_SIZE = 20
_PLAIN_IP, _DO_NOT_FRAGMENT, _TIME_TO_LIVE = 0x45, 0x4000, 64
_PLAIN_TCP = _TCP_SIZE // 4 << 12
_ONES = 0xFFFF


class Writer:
    """A computer and a brick on a network."""

    def __init__(self, host: Address = ("192.0.2.1", 49152), brick: Address = ("192.0.2.10", TCP_PORT)) -> None:
        """Sets up both ends, IP address and TCP port; the computer's port is another one for each connection."""
        self._host = _End(bytes.fromhex("020000000001"), _packed(host), host[1], 0x10000000, 0x1000)
        self._brick = _End(bytes.fromhex("02000000000a"), _packed(brick), brick[1], 0x20000000, 1)
        self._last: _End | None = None

    def opening(self) -> list[bytes]:
        """Returns beacon, answer, handshake, unlock text and the brick's answer to it."""
        host, brick = self._host, self._brick
        beacon = UDP(sport=BEACON_SOURCE, dport=BEACON_PORT, data=Beacon(SERIAL).build())
        answer = UDP(sport=BEACON_PORT, dport=BEACON_SOURCE, data=b"\0")
        return [
            _datagram(brick, EVERYBODY_MAC, EVERYBODY, beacon),
            _datagram(host, brick.mac, brick.address, answer),
            *self.handshake(),
            self._segment(host, Unlock(SERIAL).build()),
            self._segment(brick),
            self._segment(brick, ACCEPT + b"\0"),
            self._segment(host),
        ]

    def handshake(self) -> list[bytes]:
        """Returns TCP's handshake."""
        host, brick = self._host, self._brick
        return [
            self._segment(host, flags=TH_SYN, options=_OPTIONS),
            self._segment(brick, flags=TH_SYN | TH_ACK, options=_OPTIONS),
            self._segment(host),
        ]

    def between(self, is_from_host: bool) -> list[bytes]:
        """Returns an acknowledgement, if the other end sends nothing that could include one."""
        sender, other = self._ends(is_from_host)
        return [self._segment(other)] if self._last is sender else []

    def frame(self, frame: bytes, is_from_host: bool) -> list[bytes]:
        """Returns one segment, which holds any frame."""
        self._last, _ = self._ends(is_from_host)
        return [self._segment(self._last, frame)]

    def closing(self) -> list[bytes]:
        """Returns the last acknowledgement and the closing of both ends."""
        host, brick = self._host, self._brick
        return [
            *([self._segment(brick if self._last is host else host)] if self._last else []),
            self._segment(host, flags=TH_FIN | TH_ACK),
            self._segment(brick, flags=TH_FIN | TH_ACK),
            self._segment(host),
        ]

    def stamped(self, packet: bytes, time_ns: int) -> bytes:  # noqa: ARG002 - these packets hold no time
        """Returns the packet unchanged."""
        return packet

    def _ends(self, is_from_host: bool) -> tuple[_End, _End]:
        """Returns sender and receiver."""
        return (self._host, self._brick) if is_from_host else (self._brick, self._host)

    def _segment(self, sender: _End, data: bytes = b"", *, flags: int = TH_ACK, options: bytes = b"") -> bytes:
        receiver = self._brick if sender is self._host else self._host
        if flags == TH_ACK and len(sender.address) == _IPV4:
            return _inside(sender, receiver, data)
        segment = TCP(
            sport=sender.port,
            dport=receiver.port,
            seq=sender.number,
            ack=receiver.number if flags & TH_ACK else 0,
            flags=flags | (TH_PUSH if data else 0),
            win=_FIRST_WINDOW if flags & TH_SYN else _WINDOW,
            opts=options,
            data=data,
        )
        segment.off = (segment.__hdr_len__ + len(options)) // 4
        sender.number = (sender.number + len(data) + bool(flags & (TH_SYN | TH_FIN))) % 2**32
        return _packet(sender, receiver.mac, receiver.address, IP_PROTO_TCP, segment)


def _inside(sender: _End, receiver: _End, data: bytes) -> bytes:
    """Builds a segment of an open connection."""
    size = _TCP_SIZE + len(data)
    flags = _PLAIN_TCP | TH_ACK | (TH_PUSH if data else 0)
    # Checksums add 16-bit words in ones' complement, which is the remainder of their number divided by 0xFFFF.
    ends = int.from_bytes(sender.address + receiver.address, "big") + IP_PROTO_TCP
    words = ends + (_PLAIN_IP << 8) + _IP_SIZE + size + sender.packets + _DO_NOT_FRAGMENT + (_TIME_TO_LIVE << 8)
    covered = ends + size + sender.port + receiver.port + sender.number + receiver.number + flags + _WINDOW
    covered += int.from_bytes(data if len(data) % 2 == 0 else data + b"\0", "big")
    head = _SEGMENT.pack(
        receiver.mac,
        sender.mac,
        ETH_TYPE_IP,
        _PLAIN_IP,
        0,
        _IP_SIZE + size,
        sender.packets,
        _DO_NOT_FRAGMENT,
        _TIME_TO_LIVE,
        IP_PROTO_TCP,
        -words % _ONES,
        sender.address,
        receiver.address,
        sender.port,
        receiver.port,
        sender.number,
        receiver.number,
        flags,
        _WINDOW,
        -covered % _ONES,
        0,
    )
    sender.number = (sender.number + len(data)) % 2**32
    sender.packets = (sender.packets + 1) % 2**16
    return head + data


def _datagram(sender: _End, mac: bytes, address: bytes, datagram: UDP) -> bytes:
    datagram.ulen = len(datagram)
    return _packet(sender, mac, address, IP_PROTO_UDP, datagram)


def _packet(sender: _End, mac: bytes, address: bytes, protocol: int, payload: TCP | UDP) -> bytes:
    if len(address) != _IPV4:
        size = len(payload)
        whole = IP6(src=sender.address, dst=address, nxt=protocol, hlim=_TIME_TO_LIVE, plen=size, data=payload)
        return bytes(Ethernet(src=sender.mac, dst=mac, type=ETH_TYPE_IP6, data=whole))
    packet = IP(src=sender.address, dst=address, p=protocol, ttl=_TIME_TO_LIVE, id=sender.packets, df=1, data=payload)
    sender.packets = (sender.packets + 1) % 2**16
    return bytes(Ethernet(src=sender.mac, dst=mac, type=ETH_TYPE_IP, data=packet))


def _packed(end: Address) -> bytes:
    """Returns the bytes of an IP address, 4 or 16. Raises ValueError if the address is invalid."""
    return ip_address(end[0]).packed
