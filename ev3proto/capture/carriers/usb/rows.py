"""USB in the rows of tshark: reports that each have one frame at their start."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.capture.carriers.usb.reports import OVERWRITTEN
from ev3proto.capture.record import HOST, Event
from ev3proto.capture.wireshark.common import Common, has_length
from ev3proto.capture.wireshark.row import Row
from ev3proto.tables.carriers import Carrier

FIELDS = (
    "usb.bus_id",
    "usb.device_address",
    "usb.endpoint_address.direction",
    "usb.data_len",
    "ev3.expert.bootloader_fault",
)
"""What tshark prints of its packets."""


class Rows:
    """Makes events of the rows of USB."""

    def __init__(self, common: Common) -> None:
        self._common = common

    def events(self, row: Row) -> Iterator[Event]:
        """The events in a packet."""
        for data in row.bytes("ev3.bytes"):
            device = f"{row.text('usb.bus_id')}.{row.text('usb.device_address')}"
            is_from_host = row.number("usb.endpoint_address.direction") == 0
            ends = (HOST, device) if is_from_host else (device, HOST)
            route = self._common.route(Carrier.USB, *ends, is_from_host, row.interface)
            if not has_length(data):
                yield self._common.unread(row, data, route)
                continue
            self._common.move("frames", len(data))
            self._common.move("padding", max((row.number("usb.data_len") or 0) - len(data), 0))
            talk = self._common.conversation(device)
            if not row.all("ev3.expert.bootloader_fault"):
                yield talk.record(data, (row.packet,), row.time_ns, route)
                continue
            record = talk.overwritten(data, (row.packet,), row.time_ns, route)
            record.note = OVERWRITTEN
            yield record

    def end(self) -> Iterator[Event]:
        """Nothing waits for more: a report is whole in its packet."""
        return iter(())
