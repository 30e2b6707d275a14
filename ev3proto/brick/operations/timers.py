"""The clocks: waiting, and reading the time that has passed."""

from __future__ import annotations

from ev3proto.brick.handlers import handles
from ev3proto.brick.machine import Machine
from ev3proto.brick.operation_exits import Busy
from ev3proto.brick.places import Place

_UNSIGNED = 0xFFFFFFFF


@handles("TIMER_WAIT")
def timer_wait(vm: Machine, milliseconds: int, timer: Place) -> None:
    """The time at which the wait will be over."""
    timer.write32(vm.milliseconds + milliseconds)


@handles("TIMER_READY")
def timer_ready(vm: Machine, timer: int) -> None:
    """Waits for that time."""
    if vm.milliseconds & _UNSIGNED < timer & _UNSIGNED:
        raise Busy


@handles("TIMER_READ")
def timer_read(vm: Machine, time: Place) -> None:
    """Milliseconds since the program, or this direct command, was started."""
    time.write32((vm.microseconds - vm.program.started) // 1000)


@handles("TIMER_READ_US")
def timer_read_us(vm: Machine, time: Place) -> None:
    """Microseconds of the clock that nobody sets."""
    time.write32(vm.microseconds)
