"""Captured traffic: frames in capture files, with time, carrier and direction. Start with `read`."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from ev3proto.capture.byte_account import Account
from ev3proto.capture.record import Announcement, CaptureError, Direction, Event, Record, Route, Skipped, TextKind
from ev3proto.tables.carriers import Carrier

if TYPE_CHECKING:
    from ev3proto.capture.reading import Capture as Capture
    from ev3proto.capture.reading import read as read

__all__ = [
    "Account",
    "Announcement",
    "Capture",
    "CaptureError",
    "Carrier",
    "Direction",
    "Event",
    "Record",
    "Route",
    "Skipped",
    "TextKind",
    "read",
]


def __getattr__(name: str) -> Any:
    """Imports the readers of captures on first use: they take 15 ms, which frames in texts do not need."""
    if name not in ("Capture", "read"):
        raise AttributeError(f"module 'ev3proto.capture' has no attribute {name!r}")
    value = globals()[name] = getattr(import_module("ev3proto.capture.reading"), name)
    return value
