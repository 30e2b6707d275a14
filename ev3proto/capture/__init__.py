"""Captured traffic: files of packets read into frames with time, carrier and direction. `read` is where to start."""

from ev3proto.capture.byte_account import Account
from ev3proto.capture.errors import CaptureError
from ev3proto.capture.reading import Capture, read
from ev3proto.capture.record import Announcement, Carrier, Direction, Event, Record, Route, Said, Skipped

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
    "Said",
    "Skipped",
    "read",
]
