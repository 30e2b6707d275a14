"""Programs and their objects: starting, stopping, calling, waiting for each other."""

from __future__ import annotations

from ev3proto.brick.handlers import handles
from ev3proto.brick.machine import Machine
from ev3proto.brick.outcomes import Leave
from ev3proto.brick.programs import OK, STOPPED


@handles("NOP", "LABEL", "BP_SET", "BP3", "PROBE")
def nothing(_: Machine, *__: object) -> None:
    """No effect that a program could see."""


@handles("OBJECT_END", raw=True)
def object_end(vm: Machine) -> None:
    """The object has ended; the program has when no object of it runs any more."""
    vm.object.status = STOPPED
    vm.object.reset()
    if vm.program.next_object() is None:
        vm.end_program(vm.program, OK)
    raise Leave
