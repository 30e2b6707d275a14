"""The words of assembly that both who writes it and who reads it need."""

from __future__ import annotations

from ev3proto.tables.declaration import DATAF
from ev3proto.tables.system import SystemCommand

MESSAGE = "message"
"""Begins a message whose header it tells."""

FRAME = "frame"
"""Begins a message that is nothing but bytes."""

FORMS = (
    *("LC0", "LC1", "LC2", "LC4", "LCX", "LCF", "LCS", "LCS_OLD", "LAB1"),
    *("LV0", "LV1", "LV2", "LV4", "LVX", "LV", "GV0", "GV1", "GV2", "GV4", "GVX", "GV"),
)
"""The macros that fix how a value is encoded."""

SHORTEST = ("LCX", "LVX", "LV", "GVX", "GV")
"""Those of them that leave it to us."""

MARKS = ("HND", "ADR")
"""The macros that set a bit of what they enclose."""

CUT = "..."
"""Ends an operation or a system command that is cut short."""

STATUS = "status"
"""The name by which a system reply's status is given."""

LABEL = "Label"
"""Begins the name of a place that is jumped to, where the message itself has no name for it."""

NOT_A_FLOAT = f"{DATAF.label}_NAN"
"""The firmware's name for the float that is no number."""

BOOTLOADER = "BOOTLOADER."
"""What stands in front of the bootloader's commands: BEGIN_DOWNLOAD is the firmware's too."""


def command_name(entry: SystemCommand) -> str:
    """How a system command is called."""
    return f"{BOOTLOADER}{entry.name}" if entry.bootloader else entry.name
