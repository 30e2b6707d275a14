"""OUTPUT: motors."""

from __future__ import annotations

from collections.abc import Callable

from ev3proto.brick.devices.motors import Motor, are_busy
from ev3proto.brick.exits import Busy
from ev3proto.brick.handlers import computes, handles
from ev3proto.brick.machine import Machine


def _each(method: Callable[..., None]) -> Callable[..., None]:
    """Calls a method of every motor that the operation names; both motors of a synchronous move float first."""

    def act(vm: Machine, layer: int, nos: int, *parameters: int) -> None:
        for motor in vm.brick.outputs.freed(layer, nos):
            method(motor, *parameters)

    return act


def _moves(*, is_timed: bool, is_regulated: bool) -> Callable[..., None]:
    """Begins a move of three phases."""

    def move(vm: Machine, layer: int, nos: int, percent: int, *parameters: int) -> None:
        outputs = vm.brick.outputs
        outputs.move(
            outputs.freed(layer, nos),
            percent,
            parameters[:3],
            parameters[3],
            is_timed=is_timed,
            is_regulated=is_regulated,
            owner=vm.object.number,
        )

    return move


def _moves_together(*, is_timed: bool) -> Callable[..., None]:
    """Moves two motors synchronously, by angle or by time."""

    def move(vm: Machine, layer: int, nos: int, *parameters: int) -> None:
        outputs = vm.brick.outputs
        outputs.move_together(outputs.chosen(layer, nos), *parameters, is_timed=is_timed, owner=vm.object.number)

    return move


def _start(vm: Machine, layer: int, nos: int) -> None:
    for motor in _chosen(vm, layer, nos):
        motor.start(vm.object.number)


def _clear_count(vm: Machine, layer: int, nos: int) -> None:
    for motor in _chosen(vm, layer, nos):
        motor.clear_count()


def _chosen(vm: Machine, layer: int, nos: int) -> list[Motor]:
    return vm.brick.outputs.chosen(layer, nos)


computes(
    {
        "OUTPUT_RESET": _each(Motor.reset),
        "OUTPUT_STOP": _each(Motor.stop),
        "OUTPUT_POWER": _each(Motor.set_power),
        "OUTPUT_SPEED": _each(Motor.set_speed),
        "OUTPUT_START": _start,
        "OUTPUT_POLARITY": _each(Motor.set_polarity),
        "OUTPUT_CLR_COUNT": _clear_count,
        "OUTPUT_STEP_POWER": _moves(is_timed=False, is_regulated=False),
        "OUTPUT_STEP_SPEED": _moves(is_timed=False, is_regulated=True),
        "OUTPUT_TIME_POWER": _moves(is_timed=True, is_regulated=False),
        "OUTPUT_TIME_SPEED": _moves(is_timed=True, is_regulated=True),
        "OUTPUT_STEP_SYNC": _moves_together(is_timed=False),
        "OUTPUT_TIME_SYNC": _moves_together(is_timed=True),
        "OUTPUT_TEST": lambda vm, layer, nos: are_busy(_chosen(vm, layer, nos)),
        # Everything floats, as at the end of a program.
        "OUTPUT_PRG_STOP": lambda vm: vm.brick.outputs.end_program(),
    }
)


@handles("OUTPUT_READY")
def ready(vm: Machine, layer: int, nos: int) -> None:
    """Waits for the end of the moves that this object began."""
    motors = _chosen(vm, layer, nos)
    if are_busy(motors, vm.object.number):
        missing = vm.brick.outputs.missing(motors)
        if missing:
            raise Busy(f"OUTPUT_READY waits for a motor on {' and '.join(missing)}, but none is plugged in there")
        raise Busy


@handles("OUTPUT_READ", computes=True)
def read(vm: Machine, layer: int, number: int) -> tuple[int, int]:
    """Returns the speed in percent and the angle of the current move in degrees."""
    motor = vm.brick.outputs.one(layer, number)
    return (0, 0) if motor is None else (motor.reading.speed, motor.reading.tacho)


@handles("OUTPUT_GET_COUNT", computes=True)
def get_count(vm: Machine, layer: int, number: int) -> int:
    """Returns the angle as a sensor, in degrees."""
    motor = vm.brick.outputs.one(layer, number)
    return 0 if motor is None else motor.reading.sensor
