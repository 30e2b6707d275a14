"""Checks of frames: whether the brick will accept a frame, and what a careful sender would change in it.

`checking.check` returns a report: the firmware's verdict (`verdict`), and findings of the rules, whose codes are all
in one table (`codes`). `fixing` fixes what can be fixed with certainty.
"""

from ev3proto.checking.fixing import fix
from ev3proto.checking.report import Change, Finding, Fix, Report, Severity

__all__ = ["Change", "Finding", "Fix", "Report", "Severity", "fix"]
