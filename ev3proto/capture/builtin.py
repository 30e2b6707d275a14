"""The built-in engine: packets into events without any other program, each by the reader of its carrier."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator

from ev3proto.bounded import DEFAULT_MEMORY, Budget
from ev3proto.capture.byte_account import Account
from ev3proto.capture.carriers import CarrierReader, reader
from ev3proto.capture.carriers.streams import Context
from ev3proto.capture.packets import Packet
from ev3proto.capture.record import CaptureError, Event
from ev3proto.schema.frame import frame_schema
from ev3proto.tables.carriers import Carrier

_CARRIERS = {int(link): carrier for carrier in Carrier for link in carrier.facts.links}


class _Readers(dict[int, Callable[[Packet], Iterable[Event]]]):
    """What reads packets, by their link. The reader of a carrier is made for the first of its packets."""

    def __init__(self, context: Context) -> None:
        super().__init__()
        self._context = context
        self._carriers: dict[Carrier, CarrierReader] = {}
        self.unknown: set[int] = set()

    def __missing__(self, link: int) -> Callable[[Packet], Iterable[Event]]:
        carrier = _CARRIERS.get(link)
        if carrier is None:
            self.unknown.add(link)
            self[link] = self._pass_over
        else:
            if carrier not in self._carriers:
                self._carriers[carrier] = reader(carrier, self._context)
            self[link] = self._carriers[carrier].feed
        return self[link]

    def end(self) -> Iterator[Event]:
        """The events that are left once there are no more packets."""
        for each in self._carriers.values():
            yield from each.end()

    def _pass_over(self, packet: Packet) -> Iterable[Event]:
        self._context.account.other += len(packet.data)
        return ()


def events(
    packets: Iterator[Packet], account: Account, *, dialect: str, ports: Collection[int], memory: int = DEFAULT_MEMORY
) -> Iterator[Event]:
    """Everything in the packets, in their order.

    Args:
        packets: The packets of a capture.
        account: Counts all captured bytes.
        dialect: The firmware whose instruction set to read by.
        ports: TCP ports on which bricks listen.
        memory: Bytes that all that waits may take together.

    Yields:
        Records, announcements and skipped bytes.

    Raises:
        CaptureError: After everything readable, where the packets raised it or have links that nothing here knows.

    """
    budget = Budget(memory)
    context = Context(frame_schema(dialect), account, frozenset(ports), budget)
    readers, late = _Readers(context), context.late
    trouble: CaptureError | None = None
    try:
        for packet in packets:
            _, time_ns, data, size, interface, _ = packet
            captured = len(data)
            if account.first_ns is None:
                account.first_ns = time_ns
            account.last_ns = time_ns
            account.packets += 1
            account.captured += captured
            if captured < size:
                account.cut += 1
            yield from readers[interface.link](packet)
            if late:
                yield from late
                late.clear()
    except CaptureError as error:
        trouble = error
    yield from readers.end()
    account.forgotten = budget.dropped
    if trouble is not None:
        raise trouble
    if readers.unknown:
        raise CaptureError(
            f"packets of link type {', '.join(map(str, sorted(readers.unknown)))} were not read: none of them is one of"
            " those that are known here; --engine wireshark reads all that Wireshark knows"
        )
