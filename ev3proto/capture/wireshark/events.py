"""From what tshark prints of packets to the events of a capture. Each row goes to the carrier that it is of."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from importlib import import_module
from typing import Any, Protocol

from ev3proto.bounded import DEFAULT_MEMORY
from ev3proto.capture.byte_account import Account
from ev3proto.capture.record import Event
from ev3proto.capture.wireshark.common import Common
from ev3proto.capture.wireshark.row import FIELDS, Row
from ev3proto.tables.carriers import Carrier


class CarrierRows(Protocol):
    """Makes events of the rows of one carrier."""

    def events(self, row: Row) -> Iterator[Event]:
        """The events that are complete with a packet."""

    def end(self) -> Iterator[Event]:
        """The events that are left once there are no more packets."""


_CARRIERS = {protocol: carrier for carrier in Carrier for protocol in carrier.facts.protocols}


def _module(carrier: Carrier) -> Any:
    # Imported late: those modules use this package, too.
    return import_module(f"ev3proto.capture.carriers.{carrier}.rows")


def fields() -> tuple[str, ...]:
    """The fields that tshark is to make and print: five times as fast as all of what it knows of a packet."""
    return tuple(dict.fromkeys((*FIELDS, *(field for carrier in Carrier for field in _module(carrier).FIELDS))))


class Events:
    """Makes events of rows, in their order."""

    def __init__(self, account: Account, dialect: str, ports: Collection[int], memory: int = DEFAULT_MEMORY) -> None:
        common = Common(account, dialect, ports, memory)
        self._common = common
        self._account = account
        self._carriers: dict[Carrier, CarrierRows] = {carrier: _module(carrier).Rows(common) for carrier in Carrier}

    def events(self, row: Row) -> Iterator[Event]:
        """The events that are complete with a packet."""
        self._count(row)
        # The innermost one: Bluetooth goes through USB adapters.
        carrier = next((_CARRIERS[name] for name in reversed(row.protocols) if name in _CARRIERS), None)
        if carrier is not None:
            yield from self._carriers[carrier].events(row)

    def end(self) -> Iterator[Event]:
        """What was waiting for more."""
        for carrier in self._carriers.values():
            yield from carrier.end()
        self._account.forgotten = self._common.forgotten

    def _count(self, row: Row) -> None:
        account, captured = self._account, row.captured
        account.packets += 1
        account.captured += captured
        account.other += captured
        account.cut += row.missing > 0
        account.last_ns = row.time_ns
        if account.first_ns is None:
            account.first_ns = account.last_ns
