"""Outputs: four motors as models that follow commands in time.

A motor's speed follows its target at a fixed rate, its position is the integral of the speed, and a move that has
an end stops exactly there. Without a motor in the port nothing turns, so that moves by angle never end.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from ev3proto.brick.parts import Part
from ev3proto.brick.running_programs import USER_SLOT, Program
from ev3proto.tables.enumerations import TYPE

PORTS = ("A", "B", "C", "D")

FULL_SPEED = {TYPE.members["TYPE_TACHO"]: 1000.0, TYPE.members["TYPE_MINITACHO"]: 1590.0}
"""Degrees a second at 100 percent."""

ACCELERATION = 1000.0
"""Percent a second by which a motor's speed follows its target."""

LEAST_UP, LEAST_DOWN = 6.0, 4.0
"""Minimum ramp speed in percent on the way up and down, so that a ramp always makes progress."""

_MOST = 100
_MOST_TURN = 200
_STEP = 0.005
_RAMP_PARTS = 100
_NEARLY = 1e-6
_MICROSECONDS = 1_000_000.0


@dataclass
class Phase:
    """A phase of a move: a number of degrees or seconds, from one speed to another."""

    amount: float  # degrees or seconds, not negative
    is_time: bool  # which of the two
    start: float  # target at its beginning, in percent
    end: float  # target at its end

    @property
    def direction(self) -> int:
        """1 forward, -1 backward."""
        return -1 if (self.end or self.start) < 0 else 1

    def target(self, done: float) -> float:
        """Returns the target speed when a part of the phase is done."""
        if self.start == self.end or not self.amount:
            return self.end
        goal = self.start + (self.end - self.start) * min(done / self.amount, 1.0)
        least = LEAST_UP if abs(self.end) > abs(self.start) else LEAST_DOWN
        return math.copysign(max(abs(goal), least), self.end or self.start)


class Motor:
    """A motor on a port, or the empty port."""

    def __init__(self) -> None:
        self.type = TYPE.members["TYPE_NONE"]  # TYPE_NONE for an empty port
        self.wanted = 0  # the value of the last POWER or SPEED, -100 to 100, without polarity
        self.polarity = 1  # 1 or -1
        self.is_running = False  # whether START made it run without end
        self.is_held = False  # its values are as they were plugged in, until a command moves it
        self.is_moving_by_angle = False
        self.phases: list[Phase] = []  # the remaining phases of a move; the first is in progress
        self.owner = 0  # object that began the current move; 0 without one
        self.partner: Motor | None = None
        self._target = 0.0
        self._speed = 0.0
        self._position = 0.0
        self._count_from = 0.0
        self._move_from = 0.0
        self._phase_from = 0.0
        self._phase_time = 0.0
        self._held = (0, 0, 0)

    # Readings

    @property
    def speed_now(self) -> int:
        """Speed in percent."""
        return self._held[2] if self.is_held else round(self._speed)

    @property
    def tacho(self) -> int:
        """Degrees in the current move; 0 in a move without an angle."""
        if self.is_held:
            return self._held[0]
        return round(self._position - self._move_from) if self.is_moving_by_angle else 0

    @property
    def sensor_count(self) -> int:
        """Degrees that the motor reports as a sensor."""
        return self._held[1] if self.is_held else round(self._position - self._count_from)

    @property
    def angle(self) -> float:
        """Degrees since the brick was switched on, for drawing the motor."""
        return self._position

    @property
    def is_busy(self) -> bool:
        """Whether a move that has an end is in progress."""
        return bool(self.phases)

    # Commands

    def plug(self, type: int, tacho: int, count: int, speed: int, *, is_held: bool) -> None:
        """Plugs in another motor at rest, which shows the given values while it is held."""
        self.stop()
        self.type = type
        self.is_held = is_held
        self._held = (tacho, count, speed)
        self._position = self._count_from = self._move_from = 0.0

    def clear_count(self) -> None:
        """Makes the current position 0 of the count as a sensor."""
        self._count_from = self._position
        tacho, _, speed = self._held
        self._held = (tacho, 0, speed)

    def set_reading(self, value: int, *, is_speed: bool) -> None:
        """Sets the value that the motor reports as a sensor, its speed or its count."""
        tacho, count, speed = (self.tacho, self.sensor_count, self.speed_now)
        self._held = (tacho, count, value) if is_speed else (tacho, value, speed)
        self._count_from = self._position - self._held[1]

    def reset(self) -> None:
        """Makes the current position 0 of the count of the current move."""
        self._move_from = self._position

    def stop(self) -> None:
        """Stops at once, whether it brakes or floats."""
        self._leave()
        self._speed = 0.0

    def _leave(self) -> None:
        """Ends the current move; the other motor of a synchronous move floats."""
        partner, self.partner = self.partner, None
        if partner is not None:
            partner.partner = None
            partner.stop()
        self.phases = []
        self.is_running = self.is_moving_by_angle = False
        self.owner = 0
        self._target = 0.0

    def _begin(self) -> None:
        """Prepares for a move."""
        self._leave()
        if self.is_held:
            _, count, speed = self._held
            self.is_held = False
            self._count_from = self._position - count
            self._speed = float(speed)
        self._move_from = self._position
        self._begin_phase()

    def want(self, percent: int) -> None:
        """Sets power or speed for START; a running motor changes to it."""
        self.wanted = max(-_MOST, min(percent, _MOST))
        if self.is_running:
            self._target = float(self.wanted * self.polarity)

    def start(self) -> None:
        """Runs until it is stopped, unless it is already moving."""
        if self.is_running or self.is_busy:
            return
        self._begin()
        self.is_running = True
        self._target = float(self.wanted * self.polarity)

    def set_polarity(self, polarity: int) -> None:
        """Sets the polarity: 1, -1, or 0 for the opposite; a running motor reverses."""
        polarity = -self.polarity if polarity == 0 else 1 if polarity > 0 else -1
        if polarity == self.polarity:
            return
        self.polarity = polarity
        self._target = -self._target
        for phase in self.phases:
            phase.start, phase.end = -phase.start, -phase.end

    def move(self, percent: int, amounts: Sequence[float], is_time: bool, owner: int) -> None:
        """Begins a move of three phases in degrees or seconds, ramp up, constant, ramp down; those of 0 are omitted."""
        goal = max(-_MOST, min(percent, _MOST)) * self.polarity
        self._begin()
        speeds = ((self._speed, goal), (goal, goal), (goal, 0.0))
        self._follow(
            [Phase(abs(amount), is_time, *ends) for amount, ends in zip(amounts, speeds, strict=True) if amount],
            owner,
            is_angle=not is_time,
        )

    def _follow(self, phases: list[Phase], owner: int, *, is_angle: bool) -> None:
        self.phases = phases
        self.is_moving_by_angle = is_angle
        self.owner = owner
        if not phases:
            self.stop()

    def follow_together(self, other: Motor, share: float, percent: int, phase: Phase | None, owner: int) -> None:
        """Begins a synchronous move as master; `share`, -1 to 1, is the other's part of speed and angle."""
        goal = max(-_MOST, min(percent, _MOST))
        for motor, part in ((self, 1.0), (other, share)):
            motor._begin()
            speed = goal * part * motor.polarity
            if phase is None:
                motor.is_running = True
                motor._target = speed
                continue
            amount = phase.amount if phase.is_time else phase.amount * abs(part)
            own = Phase(amount, phase.is_time or not amount, speed, speed)
            motor._follow([own], owner, is_angle=not phase.is_time)
        self.partner, other.partner = other, self

    # Time

    def advance(self, seconds: float) -> None:
        """Advances the motor by a time in seconds."""
        while seconds > 0.0 and (self.phases or self.is_running):
            phase = self.phases[0] if self.phases else None
            if phase is not None:
                self._target = phase.target(self._done(phase))
            step = min(seconds, self._step(phase))
            self._turn(step)
            self._phase_time += step
            seconds -= step
            if phase is not None and phase.amount - self._done(phase) <= _NEARLY:
                self._finish(phase)

    def _done(self, phase: Phase) -> float:
        """Returns how much of a phase is done."""
        if phase.is_time:
            return self._phase_time
        return (self._position - self._phase_from) * phase.direction

    def _step(self, phase: Phase | None) -> float:
        """Returns the seconds in which the speed changes evenly, within the phase; never 0."""
        gap = abs(self._target - self._speed) / ACCELERATION or math.inf
        if phase is None:
            return gap
        left = phase.amount - self._done(phase)
        rate = 1.0 if phase.is_time else self._rate()
        until_end = left / rate if rate else math.inf
        step = gap if phase.start == phase.end else max(_STEP, until_end / _RAMP_PARTS)
        return max(min(step, until_end), _NEARLY)

    def _rate(self) -> float:
        """Returns the largest speed until the target is reached, in degrees a second."""
        return max(abs(self._speed), abs(self._target)) / _MOST * FULL_SPEED.get(self.type, 0.0)

    def _turn(self, seconds: float) -> None:
        """Turns for a while, toward the target speed."""
        before = self._speed
        change = ACCELERATION * seconds
        if abs(self._target - before) <= change:
            self._speed = self._target
        else:
            self._speed += math.copysign(change, self._target - before)
        self._position += (before + self._speed) / 2 / _MOST * FULL_SPEED.get(self.type, 0.0) * seconds

    def _finish(self, phase: Phase) -> None:
        """Ends a phase exactly at its end."""
        if not phase.is_time:
            self._position = self._phase_from + phase.amount * phase.direction
        self._begin_phase()
        del self.phases[0]
        if not self.phases:
            self._end_move()

    def _begin_phase(self) -> None:
        self._phase_from = self._position
        self._phase_time = 0.0

    def _end_move(self) -> None:
        """Stops and keeps its count; the other motor of a synchronous move ends by itself."""
        self.owner = 0
        self._target = self._speed = 0.0
        partner, self.partner = self.partner, None
        if partner is not None:
            partner.partner = None


class Outputs(Part):
    """The four motor ports of a brick."""

    def __init__(self) -> None:
        self.motors = tuple(Motor() for _ in PORTS)
        self._now = 0

    def plug(self, port: str, type: int, tacho: int, count: int, speed: int, *, is_held: bool) -> None:
        """Plugs a motor in, see Motor.plug; the port's name is one of PORTS."""
        self.motors[PORTS.index(port.upper())].plug(type, tacho, count, speed, is_held=is_held)

    def chosen(self, layer: int, nos: int) -> list[Motor]:
        """Returns the motors of a bit field; none on another brick of the daisy chain."""
        return [motor for bit, motor in enumerate(self.motors) if nos & 1 << bit] if layer == 0 else []

    def one(self, layer: int, number: int) -> Motor | None:
        """Returns the motor of a port; None for an unknown port."""
        return self.motors[number] if layer == 0 and 0 <= number < len(PORTS) else None

    def synchronise(self, motors: Sequence[Motor], percent: int, turn: int, phase: Phase | None, owner: int) -> None:
        """Moves two motors so that one runs at a share of the other's speed; other numbers are ignored.

        `turn` is -200 to 200: positive, the first is the faster one; beyond 100, the other one runs backward.
        """
        if len(motors) != 2:
            return
        turn = max(-_MOST_TURN, min(turn, _MOST_TURN))
        master, other = motors if turn >= 0 else motors[::-1]
        master.follow_together(other, (_MOST - abs(turn)) / _MOST, percent, phase, owner)

    def stop_all(self) -> None:
        """Stops all motors, and resets their polarity to 1."""
        for motor in self.motors:
            motor.stop()
            motor.polarity = 1

    def advance(self, microseconds: int) -> None:
        """Advances to a time."""
        seconds, self._now = (microseconds - self._now) / _MICROSECONDS, microseconds
        for motor in self.motors:
            motor.advance(seconds)

    def program_started(self, program: Program) -> None:
        """Stops all motors before a user program."""
        if program.slot == USER_SLOT:
            self.stop_all()


def are_busy(motors: Iterable[Motor], owner: int | None = None) -> bool:
    """Returns whether one of the motors is in a move with an end, begun by any object or by a certain one."""
    return any(motor.is_busy and owner in (None, motor.owner) for motor in motors)
