"""Programs and their objects: starting, stopping, waiting for each other; what slots do."""

from __future__ import annotations

from ev3proto.brick.handlers import handles, handles_unknown
from ev3proto.brick.machine import Machine
from ev3proto.brick.operation_exits import Busy, Failure, Leave, Sleep, WildAccess
from ev3proto.brick.places import Place
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
    Result,
)
from ev3proto.program import ProgramParameter
from ev3proto.tables.declaration import Direction, Type
from ev3proto.tables.program import aligned

LOAD_ONLY = 2
"""Of PROGRAM_START: the program is not to run."""


@handles("NOP", "LABEL", "BP_SET", "BP3", "PROBE", "COM_WRITE.REPLY")
def nothing(_: Machine, *__: object) -> None:
    """No effect that a program could see."""


@handles("BP0", "BP1", "BP2", raw=True)
def breakpoint_hit(vm: Machine) -> None:
    """Waits for a debugger, which there is not."""
    vm.wait()


@handles("ERROR", "COM_READDATA", "COM_WRITEDATA", "DO", raw=True)
def fail(vm: Machine) -> None:
    """The machine has no code for it, or none that could work without real addresses."""
    vm.fail()


@handles("COM_READ.COMMAND")
def read_command(_: Machine, length: int, image: Place, memory: Place, flag: Place) -> None:  # noqa: ARG001
    """No direct command waits that a program could take."""
    image.write32(0)
    memory.write32(0)
    flag.write8(0)


@handles("SYSTEM")
def system(_: Machine, command: bytes, status: Place) -> None:  # noqa: ARG001 - commands are never run
    """Never runs a command: the status is that of a brick without a shell."""
    status.write32(-1)


@handles("SLEEP", raw=True)
def sleep(_: Machine) -> None:
    """Only this turn ends."""
    raise Sleep


# Objects


def _end_object(vm: Machine) -> None:
    """The running object has ended; so has the program when no object of it runs any more."""
    vm.object.status = STOPPED
    vm.object.reset()
    if vm.program.next_object() is None:
        vm.end_program(vm.program, OK)
    raise Leave


@handles("OBJECT_END", raw=True)
def object_end(vm: Machine) -> None:
    """Its end."""
    _end_object(vm)


@handles("OBJECT_STOP")
def object_stop(vm: Machine, number: int) -> None:
    """An object that there is not is no failure."""
    stop_object(vm, vm.program, number)


def stop_object(vm: Machine, program: Program, number: int) -> None:
    """Stops an object of a program."""
    entry = program.objects.get(number)
    if entry is None:
        return
    if entry is vm.object:
        _end_object(vm)
    entry.status = STOPPED
    entry.reset()
    if program.next_object() is None:
        vm.end_program(program, OK)


@handles("OBJECT_START")
def object_start(vm: Machine, number: int) -> None:
    """An object that runs, or that there is not, is no failure."""
    start_object(vm.program, number)


def start_object(program: Program, number: int) -> None:
    """Starts an object of a program from its beginning, unless it runs."""
    entry = program.objects.get(number)
    if entry is not None and entry.status == STOPPED:
        entry.reset()
        entry.status = RUNNING


@handles("OBJECT_TRIG")
def object_trigger(vm: Machine, number: int) -> None:
    """The last trigger that it needs starts an object."""
    entry = vm.program.objects.get(number)
    if entry is None:
        raise WildAccess
    if entry.status != STOPPED:
        return
    entry.pending -= 1
    if entry.pending <= 0:
        entry.reset()
        entry.status = RUNNING


@handles("OBJECT_WAIT")
def object_wait(vm: Machine, number: int) -> None:
    """Until it has ended."""
    entry = vm.program.objects.get(number)
    if entry is None:
        raise WildAccess
    if entry.status != STOPPED:
        raise Busy


# Slots


@handles("PROGRAM_STOP")
def program_stop(vm: Machine, slot: int) -> None:
    """A slot's program; that of slot 0 is the firmware's own, and every other ends with it."""
    if slot == CURRENT_SLOT:
        slot = vm.program.slot
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
    """Status and result of a slot."""
    if slot == CURRENT_SLOT:
        slot = vm.program.slot
    if not 0 <= slot < SLOTS:
        raise WildAccess
    if slot == GUI_SLOT:
        return RUNNING, BUSY
    program = vm.slots[slot]
    return (STOPPED, OK) if program is None else (program.status, program.result)


@handles_unknown("PROGRAM_INFO")
def unknown_information(_: Machine) -> None:
    """Fails."""
    raise Failure


@handles("PROGRAM_INFO.GET_STATUS")
def get_status(vm: Machine, slot: int, status: Place) -> None:
    """Whether it runs."""
    status.write8(_state(vm, slot)[0])


@handles("PROGRAM_INFO.GET_PRGRESULT")
def get_result(vm: Machine, slot: int, result: Place) -> None:
    """How it ended."""
    result.write8(_state(vm, slot)[1])


@handles("PROGRAM_INFO.GET_SPEED")
def get_speed(vm: Machine, slot: int, speed: Place) -> None:
    """Operations a second of the slot's last run."""
    _state(vm, slot)
    program = vm.program if slot == CURRENT_SLOT else vm.program_in(slot)
    if program is None:
        speed.write32(0)
        return
    end = vm.microseconds if program.ended is None else program.ended
    passed = end - program.started
    speed.write32(program.executed * 1_000_000 // passed if passed > 0 else 0)


@handles("PROGRAM_INFO.OBJ_STOP")
def stop_object_of(vm: Machine, slot: int, number: int) -> None:
    """Of a running program."""
    program = vm.program if slot == CURRENT_SLOT else vm.program_in(slot)
    if program is not None and program.status == RUNNING:
        stop_object(vm, program, number)


@handles("PROGRAM_INFO.OBJ_START")
def start_object_of(vm: Machine, slot: int, number: int) -> None:
    """Of a running program."""
    program = vm.program if slot == CURRENT_SLOT else vm.program_in(slot)
    if program is not None and program.status == RUNNING:
        start_object(program, number)


@handles("PROGRAM_INFO.SET_INSTR")
def set_instructions(vm: Machine, slot: int) -> None:  # noqa: ARG001 - turns are what they are
    """The machine reads a number that the tables do not have: it stands where the next operation should."""
    vm.int16()


# Starting programs


@handles("PROGRAM_START")
def program_start(vm: Machine, slot: int, size: int, address: int, mode: int) -> None:  # noqa: ARG001 - as the firmware
    """From a direct command only while no user's program and no debugged one runs. Address 0 does nothing."""
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
    callee = vm.program.objects.get(vm.int16())
    if callee is None:
        raise WildAccess
    if callee.status != STOPPED:
        raise Busy
    offset = 0
    results: list[Result] = []
    # Each input is copied at once: constants stand in one place until the next one is read.
    for number in range(vm.int8()):
        place = vm.place()
        if number >= len(callee.parameters):
            continue
        parameter = callee.parameters[number]
        offset = aligned(offset, parameter.bytes)
        own = Place(callee.local_memory, offset)
        if parameter.direction is not Direction.OUT:
            _copy_input(parameter, place, own)
        if parameter.direction is not Direction.IN:
            results.append(Result(parameter, own, place))
        offset += parameter.bytes
    vm.object.ip = vm.ip
    vm.object.status = WAITING
    callee.reset()
    callee.status = RUNNING
    callee.caller = vm.object
    callee.results = results
    raise Leave


def _copy_input(parameter: ProgramParameter, source: Place, own: Place) -> None:
    if parameter.type is not Type.STRING:
        own.write_bytes(source.read_bytes(parameter.bytes))
    elif parameter.bytes:
        own.write_text(source.read_text()[: parameter.bytes - 1])


@handles("RETURN", raw=True)
def return_to_caller(vm: Machine) -> None:
    """Copies the outputs to where the caller wants them, who goes on. A direct command has no caller: it fails."""
    callee = vm.object
    caller = callee.caller
    if caller is None:
        raise Failure
    for parameter, own, place in callee.results:
        if parameter.type is Type.STRING:
            vm.write_text(place, own.read_text()[: parameter.bytes])
        else:
            place.write_bytes(own.read_bytes(parameter.bytes))
    callee.caller, callee.results = None, []
    callee.status = STOPPED
    callee.reset()
    caller.status = RUNNING
    raise Leave
