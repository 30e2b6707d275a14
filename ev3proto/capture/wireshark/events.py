"""From what tshark prints of packets to the events of a capture."""

from __future__ import annotations

from collections.abc import Callable, Collection, Hashable, Iterator
from dataclasses import dataclass, field
from typing import TypeVar

from ev3proto.bounded import Bounded
from ev3proto.capture.byte_account import Account
from ev3proto.capture.carriers.usb.reports import HOST, OVERWRITTEN
from ev3proto.capture.conversation import Conversation
from ev3proto.capture.record import Announcement, Direction, Event, Route, Said, Skipped
from ev3proto.capture.wireshark.row import Row
from ev3proto.capture.wireshark.segments import MOST_WAITING, Origin, Segments
from ev3proto.errors import DecodeError, counted
from ev3proto.schema.discovery import Beacon, Unlock
from ev3proto.schema.frame import frame_schema
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.discovery import ACCEPT, BEACON_LINES, UNLOCK_REQUEST
from ev3proto.tables.frame import LENGTH_FIELD, MAX_LENGTH, MIN_LENGTH

MOST_CONNECTIONS = 1024
"""Connections, and directions of them, that are remembered; those unused for longest are given up."""

_BEACON_START = f"{next(iter(BEACON_LINES.values()))}: ".encode()
_REQUEST = UNLOCK_REQUEST.encode()
_TEXT_ENDS = b"\r\n\0"
_MOST_NAMED = 5
_QUOTING = {"icmp", "icmpv6"}
_NO_ADDRESS = "00:00:00:00:00:00"
_MONITOR_DIRECTIONS = {4: True, 5: False}

V = TypeVar("V")


@dataclass(slots=True)
class _Half:
    """One direction of a TCP connection."""

    route: Route
    segments: Segments = field(default_factory=Segments)


@dataclass(slots=True)
class _Parts:
    """The start of a frame on Bluetooth that waits for its rest."""

    data: bytes
    number: int
    time_ns: int
    route: Route


class Events:
    """Makes events of rows, in their order."""

    def __init__(self, account: Account, dialect: str, ports: Collection[int]) -> None:
        self._account = account
        self._ports = frozenset(ports)
        self._schema = frame_schema(dialect)
        self._conversations: Bounded[Hashable, Conversation] = Bounded(MOST_CONNECTIONS)
        self._halves: Bounded[Hashable, _Half] = Bounded(MOST_CONNECTIONS)
        self._parts: Bounded[Route, _Parts] = Bounded(MOST_CONNECTIONS)
        self._routes: Bounded[tuple[object, ...], Route] = Bounded(MOST_CONNECTIONS)

    def events(self, row: Row) -> Iterator[Event]:
        """The events that are complete with a packet."""
        self._count(row)
        protocols = row.protocols
        if "tcp" in protocols:
            if not _QUOTING.intersection(protocols):
                yield from self._tcp(row)
        elif "ev3" not in protocols:
            return
        elif "udp" in protocols:
            yield from self._udp(row)
        elif "btrfcomm" in protocols:
            yield from self._bluetooth(row)
        else:
            yield from self._usb(row)

    def end(self) -> Iterator[Event]:
        """What was waiting for more."""
        for half in self._halves.values():
            yield from self._lost(half)
        for parts in self._parts.values():
            yield self._unfinished(parts)
        self._halves.clear()
        self._parts.clear()

    def _unfinished(self, parts: _Parts) -> Skipped:
        """The start of a frame whose rest will not come any more."""
        self._move("skipped", len(parts.data))
        reason = f"the stream ends inside a frame, of which {counted(len(parts.data), 'byte')} came"
        return Skipped(parts.data, 0, reason, parts.number, parts.time_ns, parts.route)

    def _count(self, row: Row) -> None:
        account, captured = self._account, row.captured
        account.packets += 1
        account.captured += captured
        account.other += captured
        account.last_ns = row.time_ns
        if account.first_ns is None:
            account.first_ns = account.last_ns

    # WiFi

    def _tcp(self, row: Row) -> Iterator[Event]:
        source_port, target_port = row.number("tcp.srcport"), row.number("tcp.dstport")
        found = row.bytes("ev3.bytes")
        is_ours = source_port in self._ports or target_port in self._ports
        if not (found or (is_ours and row.number("tcp.len"))):
            return
        is_from_host = target_port in self._ports
        key = row.number("tcp.stream"), source_port, row.text("ip.src") or row.text("ipv6.src")
        half, oldest = self._halves.use(key, lambda: _Half(self._wifi_route(row, "tcp", is_from_host)))
        if oldest is not None:
            yield from self._lost(oldest)
        if half.route.interface != row.interface:
            half.route = self._wifi_route(row, "tcp", is_from_host)
        route = half.route
        talk = self._conversation(frozenset((route.source, route.target)))
        origins = half.segments.origins(row, [len(data) for data in found])
        for data, origin in zip(found, origins, strict=True):
            yield from self._piece(row, data, origin, route, talk)
        if len(half.segments.waiting) > MOST_WAITING:
            yield from self._lost(half)

    def _lost(self, half: _Half) -> Iterator[Event]:
        size, numbers, time_ns = half.segments.lost()
        half.segments.waiting.clear()
        if not size:
            return
        self._move("skipped", size)
        named = ", ".join(map(str, numbers[:_MOST_NAMED])) + ", ..." * (len(numbers) > _MOST_NAMED)
        reason = (
            f"{counted(size, 'byte')} in packet{'s' * (len(numbers) != 1)} {named} are in no frame: the rest of a"
            " frame is missing, or what came before them"
        )
        yield Skipped(b"", 0, reason, numbers[0], time_ns, half.route)

    def _udp(self, row: Row) -> Iterator[Event]:
        for data in row.bytes("ev3.bytes"):
            self._move("texts", len(data))
            is_beacon = data.startswith(_BEACON_START)
            route = self._wifi_route(row, "udp", is_from_host=not is_beacon)
            said = Said.BEACON if is_beacon else Said.ANSWER
            beacon = _parsed(Beacon.parse, data) if is_beacon else None
            yield Announcement(said, data, beacon, (row.packet,), row.time_ns, route)

    def _wifi_route(self, row: Row, transport: str, is_from_host: bool) -> Route:
        version = next((name for name in reversed(row.protocols) if name in ("ip", "ipv6")), "ip")
        source = _place(row.text(f"{version}.src"), row.text(f"{transport}.srcport"))
        target = _place(row.text(f"{version}.dst"), row.text(f"{transport}.dstport"))
        return self._route(Carrier.WIFI, source, target, is_from_host, row.interface)

    # USB

    def _usb(self, row: Row) -> Iterator[Event]:
        for data in row.bytes("ev3.bytes"):
            device = f"{row.text('usb.bus_id')}.{row.text('usb.device_address')}"
            is_from_host = row.number("usb.endpoint_address.direction") == 0
            ends = (HOST, device) if is_from_host else (device, HOST)
            route = self._route(Carrier.USB, *ends, is_from_host, row.interface)
            if not _has_length(data):
                yield self._unread(row, data, route)
                continue
            self._move("frames", len(data))
            self._move("padding", max((row.number("usb.data_len") or 0) - len(data), 0))
            talk = self._conversation(device)
            if not row.all("ev3.expert.bootloader_fault"):
                yield talk.record(data, (row.packet,), row.time_ns, route)
                continue
            record = talk.overwritten(data, (row.packet,), row.time_ns, route)
            record.note = OVERWRITTEN
            yield record

    # Bluetooth

    def _bluetooth(self, row: Row) -> Iterator[Event]:
        route = self._bluetooth_route(row)
        earlier = tuple(row.numbers("ev3.fragments"))
        talk = self._conversation((frozenset((route.source, route.target)), (row.number("btrfcomm.dlci") or 0) >> 1))
        found = row.bytes("ev3.bytes")
        for data in found:
            yield from self._piece(row, data, Origin((*earlier, row.packet), row.time_ns), route, talk)
            earlier = ()
        waiting = self._parts.pop(route, None)
        part = b"".join(row.bytes("ev3.fragment"))
        if part:
            before = b"" if found or waiting is None else waiting.data
            oldest = self._parts.add(route, _Parts(before + part, row.packet, row.time_ns, route))
            if oldest is not None:
                yield self._unfinished(oldest)

    def _bluetooth_route(self, row: Row) -> Route:
        is_from_host = _is_from_host(row)
        source, target = row.text("bthci_acl.src.bd_addr"), row.text("bthci_acl.dst.bd_addr")
        host, device = (target, source) if is_from_host is False else (source, target)
        host = HOST if host in (None, _NO_ADDRESS) else host
        if device in (None, _NO_ADDRESS):
            device = f"handle 0x{row.number('bthci_acl.chandle') or 0:04x}"
        ends = (device, host) if is_from_host is False else (host, device)
        return self._route(Carrier.BLUETOOTH, *ends, is_from_host, row.interface)

    # All carriers

    def _piece(self, row: Row, data: bytes, origin: Origin, route: Route, talk: Conversation) -> Iterator[Event]:
        """What the dissector has taken from a stream in one piece: a text, a frame, or what is neither."""
        if data.startswith((ACCEPT, _REQUEST)) or not data.strip(_TEXT_ENDS):
            self._move("texts", len(data))
            if data.startswith(ACCEPT):
                yield Announcement(Said.ACCEPT, data, None, *origin, route)
            elif data.startswith(_REQUEST):
                yield Announcement(Said.UNLOCK, data, _parsed(Unlock.parse, data), *origin, route)
        elif _has_length(data) and len(data) == _size(data):
            self._move("frames", len(data))
            yield talk.record(data, *origin, route)
        else:
            yield self._unread(row, data, route)

    def _unread(self, row: Row, data: bytes, route: Route) -> Skipped:
        self._move("skipped", len(data))
        missing = 0
        if len(data) < LENGTH_FIELD or _has_length(data):
            missing = max(_size(data) - len(data), 0) if len(data) >= LENGTH_FIELD else 0
            reason = f"a frame is cut off: {counted(len(data), 'byte')} of it were captured"
        else:
            reason = (
                f"no frame can start here: its length field would say {_size(data) - LENGTH_FIELD}, a frame has"
                f" {MIN_LENGTH} to {MAX_LENGTH} bytes behind it"
            )
        return Skipped(data, missing, reason, row.packet, row.time_ns, route)

    def _route(
        self, carrier: Carrier, source: str, target: str, is_from_host: bool | None, interface: str | None
    ) -> Route:
        peer = source if is_from_host is False else target
        direction = None if is_from_host is None else Direction.SENT if is_from_host else Direction.RECEIVED
        key = carrier, source, target, direction, interface
        return self._routes.use(key, lambda: Route(carrier, source, target, direction, interface, peer))[0]

    def _conversation(self, key: Hashable) -> Conversation:
        return self._conversations.use(key, lambda: Conversation(self._schema))[0]

    def _move(self, part: str, size: int) -> None:
        """Says what some of the bytes are that counted as others."""
        setattr(self._account, part, getattr(self._account, part) + size)
        self._account.other -= size


def _size(data: bytes) -> int:
    return int.from_bytes(data[:LENGTH_FIELD], "little") + LENGTH_FIELD


def _has_length(data: bytes) -> bool:
    """Whether a frame starts here, by its length field."""
    return len(data) >= HEADER_SIZE and MIN_LENGTH <= _size(data) - LENGTH_FIELD <= MAX_LENGTH


def _parsed(parse: Callable[[bytes], V], data: bytes) -> V | None:
    try:
        return parse(data)
    except DecodeError:
        return None


def _place(address: str | None, port: str | None) -> str:
    return f"[{address}]:{port}" if address and ":" in address else f"{address}:{port}"


def _is_from_host(row: Row) -> bool | None:
    """Which way a Bluetooth packet goes, by whichever header tells: of HCI, of Linux's monitor, of a USB adapter."""
    sent = row.number("frame.p2p_dir")
    if sent is not None:
        return sent == 0
    kind = row.number("hci_mon.opcode")
    if kind is not None:
        return _MONITOR_DIRECTIONS.get(kind)
    direction = row.number("usb.endpoint_address.direction")
    return None if direction is None else direction == 0
