"""USB: requests as operating systems record them, and the reports in them."""

from ev3proto.capture.carriers.usb.reports import Reports as Reader

__all__ = ["Reader"]
