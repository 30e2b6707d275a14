"""What carries frames: a folder for each carrier, named as in the tables, with all that reads it.

Each folder has a `Reader`, which the built-in engine gives the packets of the carrier's links.
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
    """Reads the packets of one carrier."""

    def feed(self, packet: Packet) -> Iterable[Event]:
        """The events that are complete with a packet."""

    def end(self) -> Iterable[Event]:
        """The events that are left once there are no more packets."""


def reader(carrier: Carrier, context: Context) -> CarrierReader:
    """A new reader of a carrier, whose modules are imported only when a capture has it."""
    made: CarrierReader = import_module(f"{__name__}.{carrier}").Reader(context)
    return made
