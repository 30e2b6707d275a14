"""The built-in engine: packets into events without any other program, each by the reader of its carrier."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from ev3proto.capture.byte_account import Account
from ev3proto.capture.carriers import CarrierReader, reader
from ev3proto.capture.carriers.streams import Context
from ev3proto.capture.packets import Packet
from ev3proto.capture.record import CaptureError, Event
from ev3proto.schema.frame import frame_schema
from ev3proto.tables.carriers import Carrier

_CARRIERS = {int(link): carrier for carrier in Carrier for link in carrier.facts.links}


class _Packets:
    """Reads packets of any link, each with the reader of its carrier, which is made for the first of them."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._carriers: dict[Carrier, CarrierReader] = {}
        self._links: dict[int, CarrierReader] = {}
        self.unknown: set[int] = set()

    def feed(self, packet: Packet) -> Iterable[Event]:
        """The events that are complete with a packet."""
        link = packet.interface.link
        found = self._links.get(link)
        if found is None:
            carrier = _CARRIERS.get(link)
            if carrier is None:
                self.unknown.add(link)
                self._context.account.other += len(packet.data)
                return ()
            if carrier not in self._carriers:
                self._carriers[carrier] = reader(carrier, self._context)
            found = self._links[link] = self._carriers[carrier]
        return found.feed(packet)

    def end(self) -> Iterator[Event]:
        """The events that are left once there are no more packets."""
        for each in self._carriers.values():
            yield from each.end()


def events(packets: Iterator[Packet], account: Account, *, dialect: str, ports: Collection[int]) -> Iterator[Event]:
    """Everything in the packets, in their order.

    Args:
        packets: The packets of a capture.
        account: Counts all captured bytes.
        dialect: The firmware whose instruction set to read by.
        ports: TCP ports on which bricks listen.

    Yields:
        Records, announcements and skipped bytes.

    Raises:
        CaptureError: After everything readable, where the packets raised it or have links that nothing here knows.

    """
    reading = _Packets(Context(frame_schema(dialect), account, frozenset(ports)))
    trouble: CaptureError | None = None
    try:
        for packet in packets:
            if account.first_ns is None:
                account.first_ns = packet.time_ns
            account.last_ns = packet.time_ns
            account.packets += 1
            account.captured += len(packet.data)
            yield from reading.feed(packet)
    except CaptureError as error:
        trouble = error
    yield from reading.end()
    if trouble is not None:
        raise trouble
    if reading.unknown:
        raise CaptureError(
            f"packets of link type {', '.join(map(str, sorted(reading.unknown)))} were passed over, which is none of"
            " those that are known here; --engine wireshark reads all that Wireshark knows"
        )
