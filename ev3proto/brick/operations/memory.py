"""MEMORY: the variables of a running program, and how much of the flash memory is in use."""

from __future__ import annotations

from ev3proto.brick.handlers import handles
from ev3proto.brick.machine import Machine
from ev3proto.brick.places import Place
from ev3proto.brick.running_programs import GUI_SLOT, STOPPED

MEMORY_KB = 6000
"""Of the flash memory for users' files."""


def _variables(vm: Machine, slot: int, number: int) -> tuple[bytearray, int] | None:
    """The memory of a running program's object (0: its global one), and how much of it its header asks for."""
    if slot == GUI_SLOT:
        # The firmware's own program: its variables cannot be seen here.
        return bytearray(), 0
    program = vm.program_in(slot)
    if program is None or program.status == STOPPED:
        return None
    if number == 0:
        return program.global_memory, program.global_size
    entry = program.objects.get(number)
    return None if entry is None else (entry.local_memory, entry.local_size)


@handles("MEMORY_READ")
def memory_read(vm: Machine, slot: int, number: int, offset: int, count: int, destination: Place) -> None:
    """Zeros for bytes outside; nothing is written where there is no such memory."""
    found = _variables(vm, slot, number)
    if found is None or count <= 0:
        return
    destination.check(count)
    memory, size = found
    if destination.buffer is memory:
        # One byte after the other: what was just written may be read.
        for number in range(count):
            at = offset + number
            destination.buffer[destination.at + number] = memory[at] if 0 <= at < size else 0
        return
    data = bytearray(count)
    begin, end = max(0, offset), min(size, offset + count)
    if begin < end:
        data[begin - offset : end - offset] = memory[begin:end]
    destination.write_bytes(bytes(data))


@handles("MEMORY_WRITE")
def memory_write(vm: Machine, slot: int, number: int, offset: int, count: int, source: Place) -> None:
    """Bytes outside are omitted."""
    found = _variables(vm, slot, number)
    if found is None or count <= 0:
        return
    memory, size = found
    if source.buffer is memory:
        # One byte after the other: what was just written may be read.
        source.check(count)
        for number in range(count):
            if 0 <= offset + number < size:
                memory[offset + number] = source.buffer[source.at + number]
        return
    data = source.read_bytes(count)
    begin, end = max(0, offset), min(size, offset + count)
    if begin < end:
        memory[begin:end] = data[begin - offset : end - offset]


@handles("MEMORY_USAGE")
def memory_usage(vm: Machine, total: Place, free: Place) -> None:
    """In KB."""
    total.write32(MEMORY_KB)
    free.write32(max(0, MEMORY_KB - vm.brick.used_kilobytes()))
