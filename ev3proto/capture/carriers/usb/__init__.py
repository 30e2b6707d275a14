"""USB: how operating systems record requests, and the reports in them that hold frames."""

from ev3proto.capture.carriers.usb.reports import Reports as Reader

__all__ = ["Reader"]
