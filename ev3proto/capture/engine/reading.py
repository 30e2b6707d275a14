"""The packets of a file, each handed to what knows its link."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator

from ev3proto.capture.byte_account import Account
from ev3proto.capture.carriers.internet import LINKS
from ev3proto.capture.engine.context import Context
from ev3proto.capture.engine.reports import Reports
from ev3proto.capture.engine.serial import SerialPorts
from ev3proto.capture.engine.wifi import WiFi
from ev3proto.capture.errors import CaptureError
from ev3proto.capture.packets import Link, Packet
from ev3proto.capture.record import Event
from ev3proto.schema.frame import frame_schema

USB_LINKS = (Link.USBMON, Link.USBMON_PADDED, Link.USBPCAP)
BLUETOOTH_LINKS = (Link.HCI, Link.HCI_WITH_DIRECTION, Link.BLUETOOTH_MONITOR)

Reader = Callable[[Packet], Iterable[Event]]


def events(packets: Iterator[Packet], account: Account, *, dialect: str, ports: Collection[int]) -> Iterator[Event]:
    """Everything in the packets, in their order; all captured bytes stand in the account afterwards.

    Raises CaptureError where the packets did, or for links that nothing here knows, after everything readable.
    """
    context = Context(frame_schema(dialect), account)
    wifi, reports, serial = WiFi(context, ports), Reports(context), SerialPorts(context)
    readers: dict[int, Reader] = dict.fromkeys(LINKS, wifi.feed)
    readers |= dict.fromkeys(USB_LINKS, reports.feed)
    readers |= dict.fromkeys(BLUETOOTH_LINKS, serial.feed)
    unknown: set[int] = set()
    trouble: CaptureError | None = None
    try:
        for packet in packets:
            if account.first_ns is None:
                account.first_ns = packet.time_ns
            account.last_ns = packet.time_ns
            account.packets += 1
            account.captured += len(packet.data)
            reader = readers.get(packet.interface.link)
            if reader is not None:
                yield from reader(packet)
            else:
                unknown.add(packet.interface.link)
                account.other += len(packet.data)
    except CaptureError as error:
        trouble = error
    for carrier in (wifi, reports, serial):
        yield from carrier.end()
    if trouble is not None:
        raise trouble
    if unknown:
        raise CaptureError(
            f"packets of link type {', '.join(map(str, sorted(unknown)))} were passed over, which is none of those that"
            " are known here; --engine wireshark reads all that Wireshark knows"
        )
