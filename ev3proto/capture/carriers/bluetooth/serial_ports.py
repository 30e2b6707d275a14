"""Bluetooth: the serial port of a brick, a byte stream each way."""

from __future__ import annotations

from collections.abc import Iterable

from ev3proto.capture.carriers.bluetooth.adapters import Bluetooth, Carried, Closed
from ev3proto.capture.carriers.bluetooth.claim import Piece, PortClaim
from ev3proto.capture.carriers.streams import Context, Stream
from ev3proto.capture.conversation import Conversation
from ev3proto.capture.framing import Cutter
from ev3proto.capture.packets import Packet
from ev3proto.capture.record import Direction, Event, Route
from ev3proto.tables.carriers import RFCOMM_CHANNEL, Carrier


class SerialPorts:
    """Follows the serial ports of all connections on the channel that bricks use."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._account = context.account
        self._bluetooth = Bluetooth(context.budget)
        self._streams: dict[tuple[object, bool], Stream] = {}
        self._conversations: dict[object, Conversation] = {}
        self._claims: dict[object, PortClaim] = {}

    def feed(self, packet: Packet) -> Iterable[Event]:
        """The events that are complete with a packet."""
        for found in self._bluetooth.feed(packet):
            if isinstance(found, int):
                self._account.other += found
            elif isinstance(found, Closed):
                self._conversations.pop(found.key, None)
                yield from self._end(found.key)
                closed = self._claims.pop(found.key, None)
                if closed is not None:
                    closed.forget()
            elif found.serial is None or found.serial.channel != RFCOMM_CHANNEL:
                self._account.other += found.weight
            else:
                yield from self._serial(packet, found)

    def end(self) -> Iterable[Event]:
        """What was waiting for more."""
        self._account.other += self._bluetooth.pending()
        for stream in self._streams.values():
            yield from stream.end()
        for claim in self._claims.values():
            claim.forget()
        self._streams.clear()

    def _end(self, connection: object) -> list[Event]:
        """Both streams of a connection come to their end."""
        events: list[Event] = []
        for way in (True, False):
            stream = self._streams.pop((connection, way), None)
            if stream is not None:
                self._context.budget.remove(stream)
                events += stream.end()
        return events

    def _serial(self, packet: Packet, found: Carried) -> Iterable[Event]:
        serial = found.serial
        assert serial is not None
        self._account.headers += found.weight - len(serial.data)
        claim = self._claims.get(found.key)
        if claim is None:
            claim = self._claims[found.key] = PortClaim(self._context)
        if serial.is_turn:
            yield from self._end(found.key)
            claim.forget()
        if not serial.data:
            return
        piece = Piece(serial.data, packet.number, packet.time_ns, packet, found)
        if claim.is_claimed:
            yield from self._take(packet, found, claim, piece)
        else:
            for begun in claim.begin(_side(found), piece):
                yield from self._stream(begun.packet, begun.found).feed(begun.data, begun.number, begun.time_ns)
        stream = self._streams.get((found.key, serial.is_from_host))
        if stream is None:
            return
        if serial.missing:
            yield from stream.leave_hole(serial.missing)
        self._context.budget.update(stream, stream.size, lambda _: self._give_up(stream))

    def _take(self, packet: Packet, found: Carried, claim: PortClaim, piece: Piece) -> list[Event]:
        """What is complete with a packet of a port that is ours."""
        stream = self._stream(packet, found)
        text = piece.data if claim.is_proven else stream.cutter.left + piece.data
        is_in_step = stream.cutter.is_in_step or not stream.cutter.is_claimed
        events = stream.feed(piece.data, piece.number, piece.time_ns)
        if claim.take(_side(found), events, text, len(piece.data), is_in_step=is_in_step):
            if not claim.is_claimed:
                events += self._end(found.key)
            return events
        claim.end(self._end(found.key))
        return []

    def _stream(self, packet: Packet, found: Carried) -> Stream:
        serial = found.serial
        assert serial is not None
        key = found.key, serial.is_from_host
        stream = self._streams.get(key)
        if stream is None:
            conversation = self._conversations.setdefault(found.key, self._context.conversation())
            # The other side may have begun in the middle of a frame.
            cutter = Cutter(self._context.schema, in_step=False, is_claimed=False, may_gap=True)
            route = _route(packet, found)
            stream = self._streams[key] = Stream(self._context, conversation, cutter, route, packet)
        stream.packet = packet
        return stream

    def _give_up(self, stream: Stream) -> None:
        self._context.late.extend(stream.give_up())


def _side(found: Carried) -> Direction:
    assert found.serial is not None
    return Direction.SENT if found.serial.is_from_host else Direction.RECEIVED


def _route(packet: Packet, found: Carried) -> Route:
    host, device = found.ends
    side = _side(found)
    ends = (host, device) if side is Direction.SENT else (device, host)
    return Route(Carrier.BLUETOOTH, *ends, side, packet.interface.name, device)
