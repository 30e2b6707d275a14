"""Timers: waiting, and reading the elapsed time."""

from __future__ import annotations

from ev3proto.brick.exits import Busy
from ev3proto.brick.handlers import computes, handles
from ev3proto.brick.machine import Machine

_UNSIGNED = 0xFFFFFFFF

computes(
    {
        # The time in ms at which the wait will be over.
        "TIMER_WAIT": lambda vm, milliseconds: vm.milliseconds + milliseconds,
        # Milliseconds since the program, or this direct command, was started.
        "TIMER_READ": lambda vm: (vm.microseconds - vm.program.started) // 1000,
        # Microseconds since the brick was switched on.
        "TIMER_READ_US": lambda vm: vm.microseconds,
    }
)


@handles("TIMER_READY")
def timer_ready(vm: Machine, timer: int) -> None:
    """Waits for a time that TIMER_WAIT gave."""
    if vm.milliseconds & _UNSIGNED < timer & _UNSIGNED:
        raise Busy
