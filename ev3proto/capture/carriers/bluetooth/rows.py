"""Bluetooth in the rows of tshark: what RFCOMM hands over, of which the dissector makes frames."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from ev3proto.bounded import Bounded
from ev3proto.capture.record import HOST, Event, Route, Skipped
from ev3proto.capture.wireshark.common import MOST_CONNECTIONS, Common
from ev3proto.capture.wireshark.row import Row
from ev3proto.capture.wireshark.segments import Origin
from ev3proto.errors import counted
from ev3proto.tables.carriers import Carrier

FIELDS = (
    "frame.p2p_dir",
    "bthci_acl.chandle",
    "bthci_acl.src.bd_addr",
    "bthci_acl.dst.bd_addr",
    "hci_mon.opcode",
    "btrfcomm.dlci",
    "ev3.fragment",
    "ev3.fragments",
)
"""What tshark prints of its packets."""

_NO_ADDRESS = "00:00:00:00:00:00"
_MONITOR_DIRECTIONS = {4: True, 5: False}


@dataclass(slots=True)
class _Parts:
    """The start of a frame on Bluetooth that waits for its rest."""

    data: bytes
    number: int
    time_ns: int
    route: Route


class Rows:
    """Makes events of the rows of Bluetooth."""

    def __init__(self, common: Common) -> None:
        self._common = common
        self._parts: Bounded[Route, _Parts] = Bounded(MOST_CONNECTIONS)

    def events(self, row: Row) -> Iterator[Event]:
        """The events that are complete with a packet."""
        if "ev3" not in row.protocols:
            return
        route = self._route(row)
        earlier = tuple(row.numbers("ev3.fragments"))
        talk = self._common.conversation(
            (frozenset((route.source, route.target)), (row.number("btrfcomm.dlci") or 0) >> 1)
        )
        found = row.bytes("ev3.bytes")
        for data in found:
            yield from self._common.piece(row, data, Origin((*earlier, row.packet), row.time_ns), route, talk)
            earlier = ()
        waiting = self._parts.pop(route, None)
        part = b"".join(row.bytes("ev3.fragment"))
        if part:
            before = b"" if found or waiting is None else waiting.data
            oldest = self._parts.add(route, _Parts(before + part, row.packet, row.time_ns, route))
            if oldest is not None:
                yield self._unfinished(oldest)

    def _route(self, row: Row) -> Route:
        is_from_host = _is_from_host(row)
        source, target = row.text("bthci_acl.src.bd_addr"), row.text("bthci_acl.dst.bd_addr")
        host, device = (target, source) if is_from_host is False else (source, target)
        host = HOST if host in (None, _NO_ADDRESS) else host
        if device in (None, _NO_ADDRESS):
            device = f"handle 0x{row.number('bthci_acl.chandle') or 0:04x}"
        ends = (device, host) if is_from_host is False else (host, device)
        return self._common.route(Carrier.BLUETOOTH, *ends, is_from_host, row.interface)

    def end(self) -> Iterator[Event]:
        """What was waiting for more."""
        for parts in self._parts.values():
            yield self._unfinished(parts)
        self._parts.clear()

    def _unfinished(self, parts: _Parts) -> Skipped:
        """The start of a frame whose rest will not come any more."""
        self._common.move("skipped", len(parts.data))
        reason = f"the stream ends inside a frame, of which {counted(len(parts.data), 'byte')} came"
        return Skipped(parts.data, 0, reason, parts.number, parts.time_ns, parts.route)


def _is_from_host(row: Row) -> bool | None:
    """Which way a Bluetooth packet goes, by whichever header says so: of HCI, of Linux's monitor, of a USB adapter."""
    sent = row.number("frame.p2p_dir")
    if sent is not None:
        return sent == 0
    kind = row.number("hci_mon.opcode")
    if kind is not None:
        return _MONITOR_DIRECTIONS.get(kind)
    direction = row.number("usb.endpoint_address.direction")
    return None if direction is None else direction == 0
