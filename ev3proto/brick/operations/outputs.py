"""OUTPUT: motors."""

from __future__ import annotations

from collections.abc import Callable

from ev3proto.brick.devices.motors import Motor, Phase, are_busy
from ev3proto.brick.handlers import computes, handles
from ev3proto.brick.machine import Machine
from ev3proto.brick.operation_exits import Busy

_MILLISECONDS = 1000


def _each(method: Callable[..., None]) -> Callable[..., None]:
    """Calls a method of every motor that the operation names."""

    def act(vm: Machine, layer: int, nos: int, *parameters: int) -> None:
        for motor in vm.brick.outputs.chosen(layer, nos):
            method(motor, *parameters)

    return act


def _moves(seconds: float | None) -> Callable[..., None]:
    """Begins a move of three phases by angle, or by time in a unit of `seconds`. The model always brakes."""

    def move(vm: Machine, layer: int, nos: int, percent: int, *parameters: int) -> None:
        amounts = [amount * (seconds or 1) for amount in parameters[:3]]
        for motor in vm.brick.outputs.chosen(layer, nos):
            motor.move(percent, amounts, seconds is not None, vm.object.number)

    return move


def _moves_together(is_time: bool) -> Callable[..., None]:
    """Moves two motors synchronously, by angle or by time."""

    def move(vm: Machine, layer: int, nos: int, speed: int, turn: int, amount: int, _: int) -> None:
        size = abs(amount / _MILLISECONDS if is_time else amount)
        phase = Phase(size, is_time, speed, speed) if amount else None
        vm.brick.outputs.synchronise(vm.brick.outputs.chosen(layer, nos), speed, turn, phase, vm.object.number)

    return move


def _chosen(vm: Machine, layer: int, nos: int) -> list[Motor]:
    return vm.brick.outputs.chosen(layer, nos)


computes(
    {
        "OUTPUT_RESET": _each(Motor.reset),
        "OUTPUT_STOP": _each(lambda motor, _: motor.stop()),
        # Power and speed are the same for the model: no load slows its motors.
        "OUTPUT_POWER": _each(Motor.want),
        "OUTPUT_SPEED": _each(Motor.want),
        "OUTPUT_START": _each(Motor.start),
        "OUTPUT_POLARITY": _each(Motor.set_polarity),
        "OUTPUT_CLR_COUNT": _each(Motor.clear_count),
        "OUTPUT_STEP_POWER": _moves(None),
        "OUTPUT_STEP_SPEED": _moves(None),
        "OUTPUT_TIME_POWER": _moves(1 / _MILLISECONDS),
        "OUTPUT_TIME_SPEED": _moves(1 / _MILLISECONDS),
        "OUTPUT_STEP_SYNC": _moves_together(False),
        "OUTPUT_TIME_SYNC": _moves_together(True),
        "OUTPUT_TEST": lambda vm, layer, nos: are_busy(_chosen(vm, layer, nos)),
        # Everything floats, as at the end of a program.
        "OUTPUT_PRG_STOP": lambda vm: vm.brick.outputs.stop_all(),
    }
)


@handles("OUTPUT_READY")
def ready(vm: Machine, layer: int, nos: int) -> None:
    """Waits for the end of the moves that this object began."""
    if are_busy(_chosen(vm, layer, nos), vm.object.number):
        raise Busy


@handles("OUTPUT_READ", computes=True)
def read(vm: Machine, layer: int, number: int) -> tuple[int, int]:
    """Returns the speed in percent and the angle of the current move in degrees."""
    motor = vm.brick.outputs.one(layer, number)
    return (0, 0) if motor is None else (motor.speed_now, motor.tacho)


@handles("OUTPUT_GET_COUNT", computes=True)
def get_count(vm: Machine, layer: int, number: int) -> int:
    """Returns the angle as a sensor, in degrees."""
    motor = vm.brick.outputs.one(layer, number)
    return 0 if motor is None else motor.sensor_count
