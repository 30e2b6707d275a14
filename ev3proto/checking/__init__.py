"""What the brick will say to a frame before anybody sends it, and what a careful sender would change in it."""

from ev3proto.checking.report import Finding, Report, Severity

__all__ = ["Finding", "Report", "Severity"]
