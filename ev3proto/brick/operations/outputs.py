"""OUTPUT: motors."""

from __future__ import annotations

from ev3proto.brick.devices.motors import Motor, Phase, are_busy
from ev3proto.brick.handlers import handles
from ev3proto.brick.machine import Machine
from ev3proto.brick.places import Place

_MILLISECONDS = 1000


def _chosen(vm: Machine, layer: int, nos: int) -> list[Motor]:
    return vm.brick.outputs.chosen(layer, nos)


@handles("OUTPUT_SET_TYPE")
def set_type(vm: Machine, layer: int, number: int, type: int) -> None:
    """Remembered only."""
    motor = vm.brick.outputs.one(layer, number)
    if motor is not None:
        motor.declared_type = type


@handles("OUTPUT_RESET")
def reset(vm: Machine, layer: int, nos: int) -> None:
    """Counts of moves are 0."""
    for motor in _chosen(vm, layer, nos):
        motor.reset()


@handles("OUTPUT_STOP")
def stop(vm: Machine, layer: int, nos: int, brake: int) -> None:
    """Stand still."""
    for motor in _chosen(vm, layer, nos):
        motor.stop(is_braked=bool(brake))


@handles("OUTPUT_POWER", "OUTPUT_SPEED")
def want(vm: Machine, layer: int, nos: int, percent: int) -> None:
    """Power and speed are one thing for the model: nothing holds its motors back."""
    for motor in _chosen(vm, layer, nos):
        motor.want(percent)


@handles("OUTPUT_START")
def start(vm: Machine, layer: int, nos: int) -> None:
    """Run for ever."""
    for motor in _chosen(vm, layer, nos):
        motor.start()


@handles("OUTPUT_POLARITY")
def polarity(vm: Machine, layer: int, nos: int, direction: int) -> None:
    """Which way is forward."""
    for motor in _chosen(vm, layer, nos):
        motor.set_polarity(direction)


@handles("OUTPUT_STEP_POWER", "OUTPUT_STEP_SPEED")
def step(vm: Machine, layer: int, nos: int, percent: int, up: int, constant: int, down: int, brake: int) -> None:
    """Moves by angle."""
    for motor in _chosen(vm, layer, nos):
        motor.move(percent, (up, constant, down), False, bool(brake), vm.object.number)


@handles("OUTPUT_TIME_POWER", "OUTPUT_TIME_SPEED")
def time(vm: Machine, layer: int, nos: int, percent: int, up: int, constant: int, down: int, brake: int) -> None:
    """Moves by time."""
    seconds = [milliseconds / _MILLISECONDS for milliseconds in (up, constant, down)]
    for motor in _chosen(vm, layer, nos):
        motor.move(percent, seconds, True, bool(brake), vm.object.number)


def _synchronise(
    vm: Machine, layer: int, nos: int, speed: int, turn: int, amount: float, is_time: bool, brake: int
) -> None:
    motors = _chosen(vm, layer, nos)
    for motor in motors:
        motor.brakes_at_end = bool(brake)
    phase = Phase(abs(amount), is_time, speed, speed) if amount else None
    vm.brick.outputs.synchronise(motors, speed, turn, phase, vm.object.number)


@handles("OUTPUT_STEP_SYNC")
def step_sync(vm: Machine, layer: int, nos: int, speed: int, turn: int, step: int, brake: int) -> None:
    """Moves two motors by angle."""
    _synchronise(vm, layer, nos, speed, turn, step, False, brake)


@handles("OUTPUT_TIME_SYNC")
def time_sync(vm: Machine, layer: int, nos: int, speed: int, turn: int, time: int, brake: int) -> None:
    """Moves two motors by time."""
    _synchronise(vm, layer, nos, speed, turn, time / _MILLISECONDS, True, brake)


@handles("OUTPUT_TEST")
def test(vm: Machine, layer: int, nos: int, busy: Place) -> None:
    """Whether one of them is in a move that ends by itself."""
    busy.write8(are_busy(_chosen(vm, layer, nos)))


@handles("OUTPUT_READY")
def ready(vm: Machine, layer: int, nos: int) -> None:
    """Waits for the end of the moves that this object began."""
    if are_busy(_chosen(vm, layer, nos), vm.object.number):
        vm.wait()


@handles("OUTPUT_READ")
def read(vm: Machine, layer: int, number: int, speed: Place, tacho: Place) -> None:
    """Speed, and the angle of the present move."""
    motor = vm.brick.outputs.one(layer, number)
    speed.write8(0 if motor is None else motor.speed_now)
    tacho.write32(0 if motor is None else motor.tacho)


@handles("OUTPUT_GET_COUNT")
def get_count(vm: Machine, layer: int, number: int, count: Place) -> None:
    """The angle as a sensor."""
    motor = vm.brick.outputs.one(layer, number)
    count.write32(0 if motor is None else motor.sensor_count)


@handles("OUTPUT_CLR_COUNT")
def clear_count(vm: Machine, layer: int, nos: int) -> None:
    """The angle as a sensor is 0."""
    for motor in _chosen(vm, layer, nos):
        motor.clear_count()


@handles("OUTPUT_PRG_STOP")
def program_stop(vm: Machine) -> None:
    """Everything floats, as at the end of a program."""
    vm.brick.outputs.stop_all()
