"""WiFi: TCP connections to bricks, and the datagrams that announce bricks."""

from __future__ import annotations

from collections.abc import Iterable

from ev3proto.bounded import Bounded
from ev3proto.capture.carriers.claims import StreamClaim
from ev3proto.capture.carriers.streams import Context, Piece, Stream
from ev3proto.capture.carriers.wifi import layers
from ev3proto.capture.carriers.wifi.internet import (
    ACK,
    PORT_SIZE,
    PORTS,
    RST,
    SYN,
    Endpoint,
    Ends,
    Transport,
    port_bytes,
    reversed_ends,
    shown,
    source_of,
    source_port,
    target_of,
    target_port,
    usual_transport,
)
from ev3proto.capture.carriers.wifi.tcp import Hole, Late, Reassembly
from ev3proto.capture.evidence import is_plausible
from ev3proto.capture.framing import Cutter
from ev3proto.capture.packets import Interface, Packet
from ev3proto.capture.record import Announcement, Direction, Event, Route, TextKind
from ev3proto.errors import DecodeError, counted
from ev3proto.schema.discovery import Beacon, is_beacon
from ev3proto.schema.header import HEADER_SIZE, frame_end, unpack_header
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.discovery import ACCEPT, BEACON_PORT, TCP_PORT, UNLOCK_REQUEST
from ev3proto.tables.frame import MessageType

MOST_CONNECTIONS = 1024
"""Maximum number of connections; the least recently used are evicted."""

MOST_BRICKS = 1024
"""Maximum number of bricks whose beacons are remembered."""

_UNLOCK_START = UNLOCK_REQUEST.encode()
_BEACON_PORT = port_bytes(BEACON_PORT)

_MOST_IP = 1 << 16
"""An upper bound of the size of an IP packet, in bytes."""


def _may_go_to_brick(member: MessageType) -> bool:
    """Returns whether messages of a type go to the brick. Bricks in a chain send commands both ways."""
    return member.is_command or member.carries == "daisy"


def _may_come_from_brick(member: MessageType) -> bool:
    return not member.is_command or member.carries == "daisy"


_REPLIES = frozenset(int(member) for member in MessageType if not _may_go_to_brick(member))


def _transport(link: int, data: bytes) -> Transport | None:
    found = usual_transport(link, data)
    return layers.dissected(link, data) if found is None else found


class _Connection:
    """A TCP connection: its conversation, its claim, and the directions seen so far."""

    __slots__ = ("claim", "conversation", "ends", "halves")

    def __init__(self, ends: Ends, port: bytes, context: Context, *, is_sure: bool) -> None:
        self.ends = ends
        self.conversation = context.conversation()
        place = f"on TCP port {int.from_bytes(port, 'big')}"
        self.claim = StreamClaim(
            context, _may_go_to_brick, _may_come_from_brick, is_sure=is_sure, has_texts=True, place=place
        )
        self.halves: dict[Ends, _Half] = {}


class _Half:
    """One direction of a TCP connection; `back` is the other one, None if it was not seen yet."""

    __slots__ = (
        "back",
        "claim",
        "connection",
        "interface",
        "is_from_host",
        "reassembly",
        "repeated",
        "size",
        "start",
        "stream",
    )

    def __init__(
        self, stream: Stream, connection: _Connection, interface: Interface, is_from_host: bool, start: int | None
    ) -> None:
        self.stream = stream
        self.connection = connection
        self.claim = connection.claim
        self.interface = interface
        self.is_from_host = is_from_host
        self.reassembly = Reassembly(start)
        self.repeated = 0
        self.size = 0  # memory of the pending bytes, as in the budget
        self.start = start
        self.back: _Half | None = None

    @property
    def side(self) -> Direction:
        """The direction, as records have it."""
        return Direction.SENT if self.is_from_host else Direction.RECEIVED


class Connections:
    """A reader of the connections to ports on which bricks listen, and of beacons."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._account = context.account
        self._ports = {port_bytes(port) for port in context.ports or (TCP_PORT,) if 0 <= port < PORTS}
        self._is_said = bool(context.ports) or context.is_all
        self._budget = context.budget
        self._connections: Bounded[Ends, _Connection] = Bounded(MOST_CONNECTIONS)
        self._halves: dict[Ends, _Half] = {}
        # Where beacons are answered, where bricks listen according to their beacons, and the bricks' ends of
        # connections on other ports.
        self._answered: Bounded[Endpoint, None] = Bounded(MOST_BRICKS)
        self._named: Bounded[Endpoint, None] = Bounded(MOST_BRICKS)
        self._elsewhere: Bounded[Ends, Endpoint] = Bounded(MOST_CONNECTIONS)

    def feed(self, packet: Packet) -> Iterable[Event]:
        """Returns the events that a packet completes."""
        found = _transport(packet.interface.link, packet.data)
        if found is None:
            self._account.other += len(packet.data)
            return ()
        ends, carried, *_, flags = found
        if flags is None:
            return self._datagram(packet, ends, carried)
        return self._segment(packet, found, self._halves.get(ends))

    def end(self) -> Iterable[Event]:
        """Returns the events of the pending bytes."""
        for half in self._halves.values():
            yield from self._end_half(half)
        self._connections.clear()
        self._halves.clear()

    # TCP

    def _is_ours(self, ends: Ends, data: bytes) -> bool:
        return target_port(ends) in self._ports or source_port(ends) in self._ports or self._is_elsewhere(ends, data)

    def _is_elsewhere(self, ends: Ends, data: bytes) -> bool:
        """Returns whether a connection on another port is a brick's, by the unlock text or a beacon."""
        both, target = _both_ways(ends), target_of(ends)
        if both in self._elsewhere:
            return True
        if not data.startswith(_UNLOCK_START) and target not in self._named:
            return False
        self._elsewhere.add(both, target)
        return True

    def _is_command(self, data: bytes) -> bool:
        """Returns whether a segment is a command that a program would send to a brick."""
        if len(data) <= HEADER_SIZE or frame_end(data) != len(data):
            return False
        return is_plausible(self._context.schema.read_frame(data, strict=False), self._context.schema)

    def _is_to_brick(self, ends: Ends, data: bytes, flags: int) -> bool:
        """Returns whether the first captured segment of a connection goes to the brick, which never opens one."""
        is_target, is_source = target_port(ends) in self._ports, source_port(ends) in self._ports
        if flags & SYN and (is_target or is_source):
            return not flags & ACK
        if data.startswith((_UNLOCK_START, ACCEPT)):
            return data.startswith(_UNLOCK_START)
        if is_target:
            return not is_source or len(data) < HEADER_SIZE or unpack_header(data, 0)[2] not in _REPLIES
        return not is_source and self._elsewhere.get(_both_ways(ends)) == target_of(ends)

    def _segment(self, packet: Packet, segment: Transport, half: _Half | None) -> Iterable[Event]:
        ends, data, sequence, acknowledged, flags = segment
        assert flags is not None
        if half is None and not self._is_ours(ends, data):
            self._account.other += len(packet.data)
            if self._is_command(data):
                self._account.count_elsewhere(int.from_bytes(target_port(ends), "big"))
            return ()
        self._account.headers += len(packet.data) - len(data)
        events: list[Event] = []
        if half is not None and not flags & SYN:
            self._connections.move_to_end(half.connection.ends)
        elif flags & SYN:
            sequence = (sequence + 1) & 0xFFFFFFFF
            half = self._started(packet, segment, sequence, half, events, is_answer=bool(flags & ACK))
        elif data:
            half = self._open(packet, segment, None, events)
        else:
            return self._acknowledge(self._halves.get(reversed_ends(ends)), acknowledged) if flags & ACK else events
        if half.interface is not packet.interface:
            half.interface = packet.interface
            half.stream.route = self._route(packet, ends, half.is_from_host)
        if data:
            missing = _missing(packet) if packet.missing else 0
            events += self._taken(half, sequence, Piece(data, packet.number, packet.time_ns, missing), packet)
        if flags & ACK and half.back is not None:
            events += self._acknowledge(half.back, acknowledged)
        if flags & RST:
            events += self._end_half(half)
        return events

    def _started(
        self,
        packet: Packet,
        segment: Transport,
        start: int,
        half: _Half | None,
        ended: list[Event],
        *,
        is_answer: bool,
    ) -> _Half:
        """Returns the direction that a SYN begins, and ends the one of an earlier connection between the same ends."""
        if half is not None:
            if half.start == start:
                return half
            ended += self._end_half(half)
            if not is_answer:
                # The new connection has no replies to commands of the old one.
                half.connection.conversation = self._context.conversation()
        begun = self._open(packet, segment, start, ended)
        begun.connection.conversation.is_locked |= not is_answer
        return begun

    def _taken(self, half: _Half, sequence: int, piece: Piece, packet: Packet) -> list[Event]:
        stream, reassembly = half.stream, half.reassembly
        stream.packet = packet
        if reassembly.takes_next(sequence, piece):
            events = half.claim.feed(stream, piece)
            is_waiting = not half.claim.is_claimed or bool(stream.times)
        else:
            events = self._given(half, reassembly.add(sequence, piece))
            is_waiting = True
        if not half.claim.is_claimed:
            self._account.count_strange(half.claim.place)
        if is_waiting or half.size:
            self._weigh(half)
        return events

    def _weigh(self, half: _Half) -> None:
        size = half.reassembly.waiting + half.stream.size + half.claim.waiting(half.side)
        if size != half.size:
            half.size = size
            self._budget.update(half, size, lambda _: self._give_up(half))

    def _give_up(self, half: _Half) -> None:
        self._context.late += self._given(half, half.reassembly.end()) + half.claim.give_up(half.stream)
        half.size = 0

    def _acknowledge(self, back: _Half | None, acknowledged: int) -> list[Event]:
        """Returns the events after the receiver of a direction acknowledged everything before a number."""
        pieces = [] if back is None else back.reassembly.acknowledge(acknowledged)
        if back is None or not pieces:
            return []
        events = self._given(back, pieces)
        self._weigh(back)
        return events

    def _given(self, half: _Half, pieces: list[Piece | Hole | Late]) -> list[Event]:
        repeated = half.reassembly.repeated
        self._account.repeated += repeated - half.repeated
        half.repeated = repeated
        return [event for piece in pieces for event in self._piece(half, piece)]

    def _piece(self, half: _Half, piece: Piece | Hole | Late) -> list[Event]:
        stream, claim = half.stream, half.claim
        if isinstance(piece, Piece):
            return claim.feed(stream, piece)
        if isinstance(piece, Hole):
            return claim.leave_hole(stream, piece.missing)
        reason = f"{counted(len(piece.data), 'byte')} came too late to be put in order"
        return claim.take(stream.skip(piece.data, reason))

    def _open(self, packet: Packet, segment: Transport, start: int | None, events: list[Event]) -> _Half:
        ends, data, _, _, flags = segment
        back = self._halves.get(reversed_ends(ends))
        is_from_host = self._is_to_brick(ends, data, flags or 0) if back is None else not back.is_from_host
        connection = self._connection(ends, is_from_host, events)
        cutter = Cutter(self._context.schema, in_step=start is not None)
        route = self._route(packet, ends, is_from_host)
        stream = Stream(self._context, connection.conversation, cutter, route, packet)
        half = _Half(stream, connection, packet.interface, is_from_host, start)
        half.back = back
        if back is not None:
            back.back = half
        connection.halves[ends] = self._halves[ends] = half
        return half

    def _connection(self, ends: Ends, is_from_host: bool, events: list[Event]) -> _Connection:
        """Returns the connection between two ends. Ends the least recently used one if there are too many."""
        both, brick = _both_ways(ends), target_of(ends) if is_from_host else source_of(ends)
        is_sure = brick in self._named or (self._is_said and brick[-PORT_SIZE:] in self._ports)
        connection, oldest = self._connections.use(
            both, lambda: _Connection(both, brick[-PORT_SIZE:], self._context, is_sure=is_sure)
        )
        if oldest is not None:
            for way, half in oldest.halves.items():
                del self._halves[way]
                events += self._end_half(half)
                half.back = None
            oldest.halves.clear()  # breaks reference cycles, which Python collects only occasionally
        return connection

    def _end_half(self, half: _Half) -> list[Event]:
        half.size = 0
        self._budget.remove(half)
        return self._given(half, half.reassembly.end()) + half.claim.end_side(half.stream)

    def _route(self, packet: Packet, ends: Ends, is_from_host: bool) -> Route:
        source, target = shown(source_of(ends)), shown(target_of(ends))
        direction = Direction.SENT if is_from_host else Direction.RECEIVED
        return Route(Carrier.WIFI, source, target, direction, packet.interface.name, target if is_from_host else source)

    # UDP

    def _datagram(self, packet: Packet, ends: Ends, data: bytes) -> Iterable[Event]:
        is_for_beacons = _BEACON_PORT in (source_port(ends), target_port(ends))
        is_announced = is_for_beacons and is_beacon(data, is_cut=packet.missing > 0)
        if not data or not (is_announced or target_of(ends) in self._answered):
            self._account.other += len(packet.data)
            return
        self._account.headers += len(packet.data) - len(data)
        self._account.texts += len(data)
        route = self._route(packet, ends, is_from_host=not is_announced)
        if not is_announced:
            yield Announcement(TextKind.ANSWER, data, None, (packet.number,), packet.time_ns, route)
            return
        try:
            beacon = Beacon.parse(data)
        except DecodeError:
            beacon = None
        self._remember_brick(source_of(ends), beacon)
        yield Announcement(TextKind.BEACON, data, beacon, (packet.number,), packet.time_ns, route)

    def _remember_brick(self, place: Endpoint, beacon: Beacon | None) -> None:
        """Remembers where a beacon may be answered: its source port, the port for beacons, the port that it names."""
        address = place[:-PORT_SIZE]
        self._answered.add(place, None)
        self._answered.add(address + _BEACON_PORT, None)
        named = None if beacon is None else beacon.tcp_port
        if named is not None:
            place = address + port_bytes(named)
            self._answered.add(place, None)
            self._named.add(place, None)


def _missing(packet: Packet) -> int:
    """Returns how many bytes of a packet's contents were not captured."""
    link, data = packet.interface.link, packet.data
    captured = _transport(link, data)
    # Padded to its size on the wire, it is as long as its headers tell.
    filled = _transport(link, data.ljust(min(packet.size, len(data) + _MOST_IP), b"\0"))
    return 0 if captured is None or filled is None else len(filled[1]) - len(captured[1])


def _both_ways(ends: Ends) -> Ends:
    """Returns both ends of a connection, the same in both directions."""
    return min(ends, reversed_ends(ends))
