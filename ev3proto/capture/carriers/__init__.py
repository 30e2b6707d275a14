"""The carriers of frames: a folder for each, named as in the tables.

Each folder has a `Reader` for the packets of its carrier's link types.
"""

from __future__ import annotations

from collections.abc import Iterable
from importlib import import_module
from typing import Protocol

from ev3proto.capture.carriers.streams import Context
from ev3proto.capture.packets import Packet
from ev3proto.capture.record import Event
from ev3proto.tables.carriers import Carrier


class CarrierReader(Protocol):
    """A reader of the packets of one carrier."""

    def feed(self, packet: Packet) -> Iterable[Event]:
        """Returns the events that a packet completes."""

    def end(self) -> Iterable[Event]:
        """Returns the remaining events after the last packet."""


def reader(carrier: Carrier, context: Context) -> CarrierReader:
    """Returns a new reader of a carrier; its modules are imported only for captures that have it."""
    made: CarrierReader = import_module(f"{__name__}.{carrier}").Reader(context)
    return made
