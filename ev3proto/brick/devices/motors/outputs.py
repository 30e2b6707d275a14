"""The four motor ports of a brick, and time."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from ev3proto.brick.devices import Part
from ev3proto.brick.devices.motors.motor import PERCENT, Motor, Reading, clamp
from ev3proto.brick.devices.motors.move import Move, aligned
from ev3proto.brick.devices.motors.pair import Pair
from ev3proto.brick.devices.motors.rotor import CONTROL_PERIOD
from ev3proto.brick.running_programs import USER_SLOT, Program

PORT_LETTERS = ("A", "B", "C", "D")

_CHUNK = 256
"""Ticks after which it is seen whether motors are still, so that time can be skipped."""


class Outputs(Part):
    """The four motor ports of a brick."""

    def __init__(self) -> None:
        self.motors = tuple(Motor() for _ in PORT_LETTERS)
        self._pair: Pair | None = None
        self._tick = 0

    def plug(self, port: str, type: int, fixed: Reading | None) -> None:
        """Plugs a motor in, see Motor.plug; the port's name is one of PORTS."""
        self.motors[PORT_LETTERS.index(port.upper())].plug(type, fixed)

    def chosen(self, layer: int, nos: int) -> list[Motor]:
        """Returns the motors of a bit field; none on another brick of the daisy chain."""
        return [motor for bit, motor in enumerate(self.motors) if nos & 1 << bit] if layer == 0 else []

    def freed(self, layer: int, nos: int) -> list[Motor]:
        """Returns the motors of a bit field, after both of a pair were made to float if one of them is chosen."""
        motors = self.chosen(layer, nos)
        if any(motor in self.paired for motor in motors):
            self._dissolve()
        return motors

    def one(self, layer: int, number: int) -> Motor | None:
        """Returns the motor of a port; None for an unknown port."""
        return self.motors[number] if layer == 0 and 0 <= number < len(PORT_LETTERS) else None

    def missing(self, motors: Sequence[Motor]) -> list[str]:
        """Returns the ports without a motor on which a move is in progress, among some motors."""
        found = zip(PORT_LETTERS, self.motors, strict=True)
        return [port for port, motor in found if motor in motors and motor.is_busy and not motor.is_there]

    # Moves

    @property
    def paired(self) -> Sequence[Motor]:
        """The two motors that move in step, if any."""
        return () if self._pair is None or self._pair.is_over else self._pair.motors

    def _dissolve(self) -> None:
        if self._pair is not None and not self._pair.is_over:
            self._pair.dissolve()
        self._pair = None

    def move(
        self,
        motors: Iterable[Motor],
        percent: int,
        lengths: Sequence[int],
        brake: int,
        *,
        is_timed: bool,
        is_regulated: bool,
        owner: int,
    ) -> None:
        """Begins a move of each of some motors by itself; `Move` documents the arguments."""
        if is_regulated or not is_timed:
            percent = clamp(percent, PERCENT)
        for motor in motors:
            move = Move(aligned(percent, lengths), brake, is_timed=is_timed, is_regulated=is_regulated)
            move.begin(motor, percent, owner)

    def move_together(
        self, motors: Sequence[Motor], speed: int, turn: int, length: int, brake: int, *, is_timed: bool, owner: int
    ) -> None:
        """Moves two motors in step; other numbers of motors are ignored. `Pair` documents the arguments."""
        if len(motors) != 2:
            return
        if set(self.paired) != set(motors):
            self._dissolve()
        self._pair = Pair(motors[0], motors[1], turn, is_timed=is_timed)
        self._pair.begin(speed, length, brake, owner)

    def end_program(self) -> None:
        """Lets all motors float, held ones after a moment, and resets their polarity to 1."""
        self._pair = None
        for motor in self.motors:
            motor.end_program()

    def program_started(self, program: Program) -> None:
        """Stops all motors before a user program."""
        if program.slot == USER_SLOT:
            for motor in self.freed(0, (1 << len(PORT_LETTERS)) - 1):
                motor.stop(0)
                motor.polarity = 1

    # Time

    def advance(self, microseconds: int) -> None:
        """Advances to a time."""
        until = microseconds // CONTROL_PERIOD
        if until == self._tick:
            return
        self._tick = until
        paired = self.paired
        for motor in self.motors:
            if motor not in paired:
                _advance([motor], until)
        if paired:
            _advance([motor for motor in self.motors if motor in paired], until)


def _advance(motors: Sequence[Motor], until: int) -> None:
    """Advances motors that depend on each other, in the order of their ports."""
    while (left := until - motors[0].tick) > 0:
        if all(motor.is_still for motor in motors):
            for motor in motors:
                motor.skip(left)
            return
        for _ in range(min(left, _CHUNK)):
            for motor in motors:
                motor.turn()
            for motor in motors:
                motor.act()


def are_busy(motors: Iterable[Motor], owner: int | None = None) -> bool:
    """Returns whether one of the motors is in a move with an end, begun by any object or by a certain one."""
    return any(motor.is_busy and owner in (None, motor.owner) for motor in motors)
