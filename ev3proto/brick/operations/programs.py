"""Programs and their objects: starting, stopping, waiting for each other; what slots do."""

from __future__ import annotations

from collections.abc import Callable

from ev3proto.brick.exits import Busy, Failure, Leave, Sleep, WildAccess
from ev3proto.brick.handlers import computes, handles
from ev3proto.brick.locations import Location
from ev3proto.brick.machine import Machine
from ev3proto.brick.running_programs import (
    BUSY,
    CMD_SLOT,
    CURRENT_SLOT,
    DEBUG_SLOT,
    GUI_SLOT,
    OK,
    RUNNING,
    SLOTS,
    STOPPED,
    TERM_SLOT,
    USER_SLOT,
    WAITING,
    Program,
    ProgramObject,
    Result,
)
from ev3proto.program import ProgramParameter
from ev3proto.tables.declaration import Direction, Type
from ev3proto.tables.program import aligned

LOAD_ONLY = 2
"""The flag of PROGRAM_START that keeps the program from running."""


@handles("SLEEP", raw=True)
def sleep(_: Machine) -> None:
    """Ends only the current turn."""
    raise Sleep


# Objects


def _end_object(vm: Machine) -> None:
    """Ends the running object, and the program when no object of it runs any more."""
    vm.object.status = STOPPED
    vm.object.reset()
    if vm.program.next_object() is None:
        vm.end_program(vm.program, OK)
    raise Leave


@handles("OBJECT_END", raw=True)
def object_end(vm: Machine) -> None:
    """Ends the running object."""
    _end_object(vm)


def stop_object(vm: Machine, program: Program, number: int) -> None:
    """Stops an object of a program; an unknown one is ignored."""
    entry = program.objects.get(number)
    if entry is None:
        return
    if entry is vm.object:
        _end_object(vm)
    entry.status = STOPPED
    entry.reset()
    if program.next_object() is None:
        vm.end_program(program, OK)


def start_object(_: Machine, program: Program, number: int) -> None:
    """Starts an object of a program from its beginning; a running or unknown one is ignored."""
    entry = program.objects.get(number)
    if entry is not None and entry.status == STOPPED:
        entry.start()


def _of_slot(function: Callable[[Machine, Program, int], None]) -> Callable[[Machine, int, int], None]:
    """Changes an object of the program in a slot, if that runs."""

    def change(vm: Machine, slot: int, number: int) -> None:
        program = vm.program_in(slot)
        if program is not None and program.status == RUNNING:
            function(vm, program, number)

    return change


computes(
    {
        "OBJECT_STOP": lambda vm, number: stop_object(vm, vm.program, number),
        "OBJECT_START": lambda vm, number: start_object(vm, vm.program, number),
        "PROGRAM_INFO.OBJ_STOP": _of_slot(stop_object),
        "PROGRAM_INFO.OBJ_START": _of_slot(start_object),
    }
)


def _object(vm: Machine, number: int) -> ProgramObject:
    """Returns an object of the running program. WildAccess for an unknown one."""
    entry = vm.program.objects.get(number)
    if entry is None:
        raise WildAccess
    return entry


@handles("OBJECT_TRIG")
def object_trigger(vm: Machine, number: int) -> None:
    """Triggers an object, which starts with the last trigger that it needs."""
    entry = _object(vm, number)
    if entry.status == STOPPED:
        entry.pending -= 1
        if entry.pending <= 0:
            entry.start()


@handles("OBJECT_WAIT")
def object_wait(vm: Machine, number: int) -> None:
    """Waits until an object has ended."""
    if _object(vm, number).status != STOPPED:
        raise Busy


# Slots


@handles("PROGRAM_STOP")
def program_stop(vm: Machine, slot: int) -> None:
    """Ends a slot's program; that of slot 0 is the firmware's own, and every other ends with it."""
    if slot == GUI_SLOT:
        for program in vm.slots:
            if program is not None:
                vm.end_program(program, OK)
        vm.brick.is_dead = True
        raise Leave
    stopped = vm.program_in(slot)
    if stopped is not None:
        vm.end_program(stopped, OK)
        if stopped is vm.program:
            raise Leave


def _state(vm: Machine, slot: int) -> tuple[int, int]:
    """Status and result of a slot. The firmware's own program always runs."""
    if not 0 <= slot < SLOTS and slot != CURRENT_SLOT:
        raise WildAccess
    if slot == GUI_SLOT:
        return RUNNING, BUSY
    program = vm.program_in(slot)
    return (STOPPED, OK) if program is None else (program.status, program.result)


computes(
    {
        "PROGRAM_INFO.GET_STATUS": lambda vm, slot: _state(vm, slot)[0],
        "PROGRAM_INFO.GET_PRGRESULT": lambda vm, slot: _state(vm, slot)[1],
        # The firmware reads a number that the tables do not have, where the next operation should be.
        "PROGRAM_INFO.SET_INSTR": lambda vm, _: vm.int16(),
    }
)


@handles("PROGRAM_INFO.GET_SPEED", computes=True)
def get_speed(vm: Machine, slot: int) -> int:
    """Returns the operations a second of the slot's last run."""
    _state(vm, slot)
    program = vm.program_in(slot)
    if program is None:
        return 0
    passed = (vm.microseconds if program.ended is None else program.ended) - program.started
    return program.executed * 1_000_000 // passed if passed > 0 else 0


# Starting programs


@handles("PROGRAM_START")
def program_start(
    vm: Machine,
    slot: int,
    size: int,  # noqa: ARG001 - as the firmware
    address: int,
    mode: int,
) -> None:
    """Starts a loaded program; from a direct command only while neither a user's nor a debugged program runs."""
    image = vm.images.get(address)
    if image is None or mode == LOAD_ONLY or slot not in (USER_SLOT, TERM_SLOT, DEBUG_SLOT):
        return
    watched = (USER_SLOT, DEBUG_SLOT) if vm.program.slot == CMD_SLOT else (slot,)
    if any(other is not None and other.status == RUNNING for other in (vm.program_in(number) for number in watched)):
        return
    vm.start_program(slot, image)


# Subroutines


@handles("CALL", raw=True)
def call(vm: Machine) -> None:
    """Copies the inputs into the subroutine's memory and starts it; waits while another object is in it."""
    callee = _object(vm, vm.int16())
    if callee.status != STOPPED:
        raise Busy
    offset = 0
    results: list[Result] = []
    # Each input is copied at once: all constants share one place.
    for number in range(vm.int8()):
        place = vm.place()
        if number >= len(callee.parameters):
            continue
        parameter = callee.parameters[number]
        offset = aligned(offset, parameter.bytes)
        own = Location(callee.local_memory, offset)
        if parameter.direction is not Direction.OUT:
            _copy_input(parameter, place, own)
        if parameter.direction is not Direction.IN:
            results.append(Result(parameter, own, place))
        offset += parameter.bytes
    vm.object.ip = vm.ip
    vm.object.status = WAITING
    callee.start()
    callee.caller = vm.object
    callee.results = results
    raise Leave


def _copy_input(parameter: ProgramParameter, source: Location, own: Location) -> None:
    if parameter.type is not Type.STRING:
        own.write_bytes(source.read_bytes(parameter.bytes))
    elif parameter.bytes:
        own.write_text(source.read_text(parameter.bytes - 1))


@handles("RETURN", raw=True)
def return_to_caller(vm: Machine) -> None:
    """Copies the outputs to the caller, which continues. A direct command has no caller: it fails."""
    callee = vm.object
    caller = callee.caller
    if caller is None:
        raise Failure
    for parameter, own, place in callee.results:
        if parameter.type is Type.STRING:
            vm.write_text(place, own.read_text(parameter.bytes))
        else:
            place.write_bytes(own.read_bytes(parameter.bytes))
    callee.caller, callee.results = None, []
    callee.status = STOPPED
    callee.reset()
    caller.status = RUNNING
    raise Leave
