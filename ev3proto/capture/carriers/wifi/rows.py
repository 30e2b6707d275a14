"""WiFi in the rows of tshark: TCP streams that Wireshark has put in order, beacons and the answers to them."""

from __future__ import annotations

from collections.abc import Hashable, Iterator
from dataclasses import dataclass, field

from ev3proto.bounded import Bounded
from ev3proto.capture.carriers.wifi.ways import frame_goes_to_brick, text_goes_to_brick
from ev3proto.capture.record import Announcement, Direction, Event, Route, Skipped, TextKind
from ev3proto.capture.wireshark.common import MOST_CONNECTIONS, Common, parsed
from ev3proto.capture.wireshark.row import Row
from ev3proto.capture.wireshark.segments import MOST_WAITING, WAITING_SIZE, Segments
from ev3proto.errors import counted
from ev3proto.schema.discovery import Beacon
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.discovery import BEACON_LINES

FIELDS = (
    "ip.src",
    "ip.dst",
    "ipv6.src",
    "ipv6.dst",
    "udp.srcport",
    "udp.dstport",
    "tcp.srcport",
    "tcp.dstport",
    "tcp.stream",
    "tcp.seq",
    "tcp.len",
    "tcp.segment",
    "tcp.segment.count",
    "tcp.reassembled.length",
)
"""What tshark prints of its packets."""

_BEACON_START = f"{next(iter(BEACON_LINES.values()))}: ".encode()
_MOST_NAMED = 5
_QUOTING = {"icmp", "icmpv6"}


@dataclass(slots=True)
class _Half:
    """One direction of a TCP connection."""

    route: Route
    key: object
    segments: Segments = field(default_factory=Segments)


class Rows:
    """Makes events of the rows of WiFi."""

    def __init__(self, common: Common) -> None:
        self._common = common
        self._late: list[Event] = []  # what was given up, as too much waits
        self._halves: Bounded[Hashable, _Half] = Bounded(MOST_CONNECTIONS)
        self._claimed: Bounded[object, None] = Bounded(MOST_CONNECTIONS)

    def events(self, row: Row) -> Iterator[Event]:
        """The events that are complete with a packet."""
        if _QUOTING.intersection(row.protocols):
            return
        if "tcp" in row.protocols:
            yield from self._tcp(row)
        else:
            yield from self._udp(row)

    def end(self) -> Iterator[Event]:
        """What was waiting for more."""
        for half in self._halves.values():
            yield from self._lost(half)
        self._halves.clear()

    def _tcp(self, row: Row) -> Iterator[Event]:
        source_port, target_port = row.number("tcp.srcport"), row.number("tcp.dstport")
        found = row.bytes("ev3.bytes")
        is_ours = source_port in self._common.ports or target_port in self._common.ports
        if not (found or (is_ours and row.number("tcp.len"))):
            return
        version = "ip" if row.text("ip.src") else "ipv6"
        key = row.number("tcp.stream"), source_port, row.text(f"{version}.src")
        back = self._halves.get((key[0], target_port, row.text(f"{version}.dst")))
        is_from_host = self._is_from_host(source_port, target_port, found, back)
        half, oldest = self._halves.use(key, lambda: _Half(self._wifi_route(row, "tcp", is_from_host), key[0]))
        if found:
            self._claimed.add(key[0], None)
        if oldest is not None:
            self._common.weigh(oldest, 0, lambda _: None)
            yield from self._lost(oldest)
        if half.route.interface != row.interface:
            half.route = self._wifi_route(row, "tcp", is_from_host)
        route = half.route
        talk = self._common.conversation(frozenset((route.source, route.target)))
        origins = half.segments.origins(row, [len(data) for data in found])
        for data, origin in zip(found, origins, strict=True):
            yield from self._common.piece(row, data, origin, route, talk)
        if len(half.segments.waiting) > MOST_WAITING:
            yield from self._lost(half)
        self._common.weigh(
            half, WAITING_SIZE * len(half.segments.waiting), lambda _: self._late.extend(self._lost(half))
        )
        if self._late:
            yield from self._late
            self._late.clear()

    def _is_from_host(
        self, source_port: int | None, target_port: int | None, found: list[bytes], back: _Half | None
    ) -> bool:
        """Whether a row goes to the brick. The first one of a connection tells, by its ports or by what it has."""
        if back is not None:
            return back.route.direction is Direction.RECEIVED
        told = text_goes_to_brick(found[0]) if found else None
        if told is not None:
            return told
        is_source, is_target = source_port in self._common.ports, target_port in self._common.ports
        return is_target if is_source != is_target or not found else frame_goes_to_brick(found[0])

    def _lost(self, half: _Half) -> Iterator[Event]:
        size, numbers, time_ns = half.segments.lost()
        half.segments.waiting.clear()
        if not size or half.key not in self._claimed:
            return
        self._common.move("skipped", size)
        named = ", ".join(map(str, numbers[:_MOST_NAMED])) + ", ..." * (len(numbers) > _MOST_NAMED)
        reason = (
            f"{counted(size, 'byte')} in packet{'s' * (len(numbers) != 1)} {named} are in no frame: the rest of a"
            " frame is missing, or what came before them"
        )
        yield Skipped(b"", 0, reason, numbers[0], time_ns, half.route)

    def _udp(self, row: Row) -> Iterator[Event]:
        for data in row.bytes("ev3.bytes"):
            self._common.move("texts", len(data))
            is_beacon = data.startswith(_BEACON_START)
            route = self._wifi_route(row, "udp", is_from_host=not is_beacon)
            said = TextKind.BEACON if is_beacon else TextKind.ANSWER
            beacon = parsed(Beacon.parse, data) if is_beacon else None
            yield Announcement(said, data, beacon, (row.packet,), row.time_ns, route)

    def _wifi_route(self, row: Row, transport: str, is_from_host: bool) -> Route:
        version = next((name for name in reversed(row.protocols) if name in ("ip", "ipv6")), "ip")
        source = _place(row.text(f"{version}.src"), row.text(f"{transport}.srcport"))
        target = _place(row.text(f"{version}.dst"), row.text(f"{transport}.dstport"))
        return self._common.route(Carrier.WIFI, source, target, is_from_host, row.interface)


def _place(address: str | None, port: str | None) -> str:
    return f"[{address}]:{port}" if address and ":" in address else f"{address}:{port}"
