"""Opcodes without a CMD in the firmware's area `ui`; `ops` has each under its name.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import Output
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = ["keep_alive", "ui_flush"]

_OPERATIONS = drafts("official")


def ui_flush(*, unchecked: bool = False) -> Draft:
    """Sends what was written for the terminal and is still in its buffer."""
    return _OPERATIONS["UI_FLUSH"].draft((), unchecked)


def keep_alive(minutes: Output = None, *, unchecked: bool = False) -> Draft:
    """Restarts the time after which the idle brick switches off, and reads it.

    Args:
        minutes: Idle time before switching off; min; 0: never; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["KEEP_ALIVE"].draft((minutes,), unchecked)
