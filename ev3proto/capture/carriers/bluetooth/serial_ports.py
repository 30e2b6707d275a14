"""Bluetooth: the serial port of a brick, a byte stream each way."""

from __future__ import annotations

from collections.abc import Iterable

from ev3proto.bounded import Bounded
from ev3proto.capture.byte_account import ACCESSORY
from ev3proto.capture.carriers.bluetooth.adapters import Bluetooth, Carried, Closed, Ports
from ev3proto.capture.carriers.claims import StreamClaim
from ev3proto.capture.carriers.streams import Context, Piece, Stream
from ev3proto.capture.conversation import Conversation
from ev3proto.capture.framing import Cutter
from ev3proto.capture.packets import Packet
from ev3proto.capture.record import Direction, Event, Route
from ev3proto.tables.carriers import RFCOMM_CHANNEL, Carrier
from ev3proto.tables.frame import MessageType

_ACCESSORY = (b"\xff\x55", b"\xff\x5a")
"""The first bytes of packets of Apple's accessory protocol, in both versions. As a length they are impossible."""

MOST_NUMBERS = 1024
"""Maximum number of closed connections whose numbers are remembered."""


class SerialPorts:
    """A reader of the serial ports of all connections, on the channel that bricks use."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._account = context.account
        self._bluetooth = Bluetooth()
        self._streams: dict[tuple[object, bool], Stream] = {}
        self._conversations: dict[object, Conversation] = {}
        self._claims: dict[object, StreamClaim] = {}
        self._numbers: Bounded[Ports, int] = Bounded(MOST_NUMBERS)  # of the conversations of closed connections

    def feed(self, packet: Packet) -> Iterable[Event]:
        """Returns the events that a packet completes."""
        for found in self._bluetooth.feed(packet):
            if isinstance(found, int):
                self._account.other += found
            elif isinstance(found, Closed):
                closed = self._conversations.pop(found.key, None)
                if closed is not None and closed.number:
                    self._numbers.add(found.ends, closed.number)
                yield from self._end(found.key)
                self._claims.pop(found.key, None)
            elif found.serial is not None and found.serial.data.startswith(_ACCESSORY):
                self._account.count_strange(ACCESSORY)
                self._account.other += found.weight
            elif found.serial is None or found.serial.channel != RFCOMM_CHANNEL:
                self._account.other += found.weight
            else:
                yield from self._serial(packet, found)

    def end(self) -> Iterable[Event]:
        """Returns the events of the pending bytes."""
        self._account.other += self._bluetooth.pending()
        for connection in tuple(self._claims):
            yield from self._end(connection)

    def _end(self, connection: object) -> list[Event]:
        events: list[Event] = []
        for way in (True, False):
            stream = self._streams.pop((connection, way), None)
            if stream is not None:
                self._context.budget.remove(stream)
                events += self._claims[connection].end_side(stream)
        return events

    def _serial(self, packet: Packet, found: Carried) -> Iterable[Event]:
        serial = found.serial
        assert serial is not None
        self._account.headers += found.weight - len(serial.data)
        if serial.is_turn:
            yield from self._end(found.key)
        if not serial.data:
            return
        claim = self._claims.get(found.key)
        if claim is None:
            place, is_sure = f"on RFCOMM channel {RFCOMM_CHANNEL}", self._context.is_all
            claim = StreamClaim(
                self._context, lambda member: member.is_command, _is_from_brick, is_sure=is_sure, place=place
            )
            self._claims[found.key] = claim
        stream = self._stream(packet, found)
        yield from claim.feed(stream, Piece(serial.data, packet.number, packet.time_ns, serial.missing))
        if not claim.is_claimed:
            self._account.count_strange(claim.place)
        size = stream.size + claim.waiting(_side(found))
        self._context.budget.update(stream, size, lambda _: self._give_up(claim, stream))

    def _stream(self, packet: Packet, found: Carried) -> Stream:
        serial = found.serial
        assert serial is not None
        key = found.key, serial.is_from_host
        stream = self._streams.get(key)
        if stream is None:
            conversation = self._conversations.get(found.key)
            if conversation is None:
                conversation = self._conversations[found.key] = self._context.conversation()
                conversation.number = self._numbers.get(found.ends, 0)
            cutter = Cutter(self._context.schema, in_step=False, may_gap=True)
            route = _route(packet, found)
            stream = self._streams[key] = Stream(self._context, conversation, cutter, route, packet)
        stream.packet = packet
        return stream

    def _give_up(self, claim: StreamClaim, stream: Stream) -> None:
        self._context.late += claim.give_up(stream)


def _side(found: Carried) -> Direction:
    assert found.serial is not None
    return Direction.SENT if found.serial.is_from_host else Direction.RECEIVED


def _route(packet: Packet, found: Carried) -> Route:
    host, device = found.ends
    side = _side(found)
    ends = (host, device) if side is Direction.SENT else (device, host)
    return Route(Carrier.BLUETOOTH, *ends, side, packet.interface.name, device)


def _is_from_brick(member: MessageType) -> bool:
    """Returns whether a type comes from a brick: bricks also write into each other's mailboxes."""
    return not member.is_command or (member.carries == "system" and not member.wants_reply)
