"""Bluetooth: the serial port of a brick, a byte stream each way."""

from __future__ import annotations

from collections.abc import Iterable

from ev3proto.capture.carriers.bluetooth.adapters import Bluetooth, Carried, Closed
from ev3proto.capture.carriers.claims import SerialPortClaim, begins_a_serial_port
from ev3proto.capture.carriers.streams import Context, Stream
from ev3proto.capture.conversation import Conversation
from ev3proto.capture.framing import Cutter
from ev3proto.capture.packets import Packet
from ev3proto.capture.record import Direction, Event, Route
from ev3proto.tables.carriers import RFCOMM_CHANNEL, Carrier


class _Port(SerialPortClaim):
    """Whether a serial port is ours."""

    __slots__ = ("_is_from_host", "_turn")

    def __init__(self, context: Context) -> None:
        super().__init__(context, lambda event: begins_a_serial_port(event, self._turn))
        self._is_from_host: bool | None = None
        self._turn = 0

    def reach(self, is_from_host: bool, number: int) -> None:
        """Says which side speaks in a packet."""
        if is_from_host is not self._is_from_host:
            self._is_from_host, self._turn = is_from_host, number


class SerialPorts:
    """Follows the serial ports of all connections on the channel that bricks use."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._account = context.account
        self._bluetooth = Bluetooth(context.budget)
        self._streams: dict[tuple[object, bool], Stream] = {}
        self._conversations: dict[object, Conversation] = {}
        self._claims: dict[object, _Port] = {}

    def feed(self, packet: Packet) -> Iterable[Event]:
        """The events that are complete with a packet."""
        for found in self._bluetooth.feed(packet):
            if isinstance(found, int):
                self._account.other += found
            elif isinstance(found, Closed):
                self._conversations.pop(found.key, None)
                yield from self._end(found.key)
                closed = self._claims.pop(found.key, None)
                yield from () if closed is None else closed.end()
            elif found.serial is None or found.serial.channel != RFCOMM_CHANNEL:
                self._account.other += found.weight
            else:
                yield from self._serial(packet, found)

    def end(self) -> Iterable[Event]:
        """What was waiting for more."""
        self._account.other += self._bluetooth.pending()
        for (connection, _), stream in self._streams.items():
            yield from self._claims[connection].take(stream.end())
        for claim in self._claims.values():
            yield from claim.end()
        self._streams.clear()

    def _end(self, connection: object) -> Iterable[Event]:
        """Both streams of a connection come to their end."""
        for way in (True, False):
            stream = self._streams.pop((connection, way), None)
            if stream is not None:
                self._context.budget.remove(stream)
                yield from self._claims[connection].take(stream.end())

    def _serial(self, packet: Packet, found: Carried) -> Iterable[Event]:
        serial = found.serial
        assert serial is not None
        self._account.headers += found.weight - len(serial.data)
        if serial.is_turn:
            yield from self._end(found.key)
        if not serial.data:
            return
        key = found.key, serial.is_from_host
        if key not in self._streams:
            conversation = self._conversations.setdefault(found.key, self._context.conversation())
            if found.key not in self._claims:
                self._claims[found.key] = _Port(self._context)
            # Other programs use the same channel: something like a frame must start with a packet.
            cutter = Cutter(self._context.schema, in_step=False, is_claimed=False, may_gap=True)
            route = _route(packet, found, serial.is_from_host)
            self._streams[key] = Stream(self._context, conversation, cutter, route, packet)
        stream = self._streams[key]
        stream.packet = packet
        claim = self._claims[found.key]
        claim.reach(serial.is_from_host, packet.number)
        before = self._account.other
        events = stream.feed(serial.data, packet.number, packet.time_ns)
        if self._account.other > before:
            claim.meet_stranger()
        yield from claim.take(events)
        if serial.missing:
            yield from claim.take(stream.leave_hole(serial.missing))
        self._context.budget.update(stream, stream.size, lambda _: self._give_up(stream, claim))

    def _give_up(self, stream: Stream, claim: _Port) -> None:
        self._context.late.extend(claim.take(stream.give_up()))


def _route(packet: Packet, found: Carried, is_from_host: bool) -> Route:
    host, device = found.ends
    ends = (host, device) if is_from_host else (device, host)
    direction = Direction.SENT if is_from_host else Direction.RECEIVED
    return Route(Carrier.BLUETOOTH, *ends, direction, packet.interface.name, device)
