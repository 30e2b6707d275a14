"""MEMORY: the variables of a running program, and how much of the flash memory is in use."""

from __future__ import annotations

from ev3proto.brick.handlers import computes, handles
from ev3proto.brick.locations import Location
from ev3proto.brick.machine import Machine
from ev3proto.brick.running_programs import CURRENT_SLOT, GUI_SLOT, STOPPED

_KIB = 1024


def _variables(vm: Machine, slot: int, number: int) -> tuple[bytearray, int] | None:
    """Returns the memory of a running program's object (0: its global one), and how much of it its header asks for."""
    if slot == GUI_SLOT:
        # The firmware's own program: its variables cannot be seen here.
        return bytearray(), 0
    program = None if slot == CURRENT_SLOT else vm.program_in(slot)
    if program is None or program.status == STOPPED:
        return None
    if number == 0:
        return program.global_memory, program.global_size
    entry = program.objects.get(number)
    return None if entry is None else (entry.local_memory, entry.local_size)


# Both copy byte by byte: where the memories are the same, a byte that was just written may be read.


@handles("MEMORY_READ")
def memory_read(vm: Machine, slot: int, number: int, offset: int, count: int, destination: Location) -> None:
    """Writes zeros for bytes outside; nothing if the memory does not exist."""
    found = _variables(vm, slot, number)
    if found is None or count <= 0:
        return
    destination.check(count)
    memory, size = found
    for index in range(count):
        at = offset + index
        destination.buffer[destination.at + index] = memory[at] if 0 <= at < size else 0


@handles("MEMORY_WRITE")
def memory_write(vm: Machine, slot: int, number: int, offset: int, count: int, source: Location) -> None:
    """Writes a program's memory; bytes outside are omitted."""
    found = _variables(vm, slot, number)
    if found is None or count <= 0:
        return
    source.check(count)
    memory, size = found
    for index in range(count):
        if 0 <= offset + index < size:
            memory[offset + index] = source.buffer[source.at + index]


computes({"MEMORY_USAGE": lambda vm: (vm.brick.files.quota // _KIB, vm.brick.files.free // _KIB)})
