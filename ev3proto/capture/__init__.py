"""Captured traffic: frames in capture files, with time, carrier and direction. Start with `read`."""

from ev3proto.capture.byte_account import Account
from ev3proto.capture.reading import Capture, read
from ev3proto.capture.record import Announcement, CaptureError, Direction, Event, Record, Route, Skipped, TextKind
from ev3proto.tables.carriers import Carrier

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
