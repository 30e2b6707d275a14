"""Opcodes without a CMD in the firmware's area `timer`; `ops` has each under its name.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import Number, Output
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = ["timer_read", "timer_read_us", "timer_ready", "timer_wait"]

_OPERATIONS = drafts("official")


def timer_wait(time: Number, timer: Output = None, *, unchecked: bool = False) -> Draft:
    """Notes when a wait will be over and returns at once; TIMER_READY does the waiting.

    Args:
        time: How long to wait; 0 to 2147483647 ms; DATA32.
        timer: Variable that gets the end of the wait, on the brick's millisecond clock; DATA32; an output, in global
            memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["TIMER_WAIT"].draft((time, timer), unchecked)


def timer_ready(timer: Number, *, unchecked: bool = False) -> Draft:
    """Waits until the time that TIMER_WAIT noted has come.

    Args:
        timer: Variable that TIMER_WAIT has set; DATA32.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["TIMER_READY"].draft((timer,), unchecked)


def timer_read(time: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the time since the program or direct command that asks was started.

    Args:
        time: Time since the start; ms; DATA32; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["TIMER_READ"].draft((time,), unchecked)


def timer_read_us(time: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the free-running microsecond clock, for differences only.

    Args:
        time: Low 32 bits of the clock, back to 0 every 71.6 minutes; us; DATA32; an output, in global memory when
            omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["TIMER_READ_US"].draft((time,), unchecked)
