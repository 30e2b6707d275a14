"""A move that ends by itself: ramp up, constant drive, ramp down, by angle or by time, by power or by speed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from enum import IntEnum

from ev3proto.brick.devices.motors.motor import PERCENT, Activity, Motor, divide, signed
from ev3proto.brick.devices.motors.rotor import TICK_MILLISECONDS

_RATE = 1000
"""Slopes of ramps are in thousandths of a percent for each degree or millisecond."""

_LEAST_UP, _LEAST_DOWN, _CRAWL = 6, 4, 2
"""Percent: the least speeds of ramps, and the one that a ramp of power down falls back on."""

_PUSH = 20
"""Power that a ramp up adds in each tick until the motor turns."""


class Phase(IntEnum):
    """A part of a move."""

    UP = 0
    FLAT = 1
    DOWN = 2


class Move(Activity):
    """A move of one motor.

    lengths       signed degrees or milliseconds of the phases; those of 0 are left out
    is_timed      whether they are milliseconds
    is_regulated  whether it is by speed, not by power
    """

    def __init__(self, lengths: Sequence[int], brake: int, *, is_timed: bool, is_regulated: bool) -> None:
        self._lengths = lengths
        self._brake = brake
        self._is_timed = is_timed
        self._is_regulated = is_regulated
        self._phase = Phase.UP
        self._direction = 1
        self._is_soft = False  # whether the phase ends by an approach
        self._is_near = False  # whether the approach has begun
        self._is_crawling = False  # whether a ramp of power down has fallen back on the regulator
        self._up_rate = self._up_base = self._down_rate = 0

    def begin(self, motor: Motor, percent: int, owner: int) -> None:
        """Begins the move with a power or speed in percent."""
        if self._is_timed:
            motor.rate = TICK_MILLISECONDS * (1 if max(self._lengths) > 0 else -1) * motor.polarity
            motor.clock = 0
        motor.goal = percent * motor.polarity * (1 if self._is_regulated else PERCENT)
        self._lengths = [length * motor.polarity for length in self._lengths]
        self._direction = 1 if motor.goal >= 0 else -1
        motor.begin(self, owner)
        self._enter(motor, Phase.UP, 0)
        if self._is_regulated:
            motor.aim = signed(motor.goal, 8)

    def _enter(self, motor: Motor, first: int, done: int) -> None:
        """Begins the first phase from a certain one on that has a length; `done` is that of the one before."""
        found = next((phase for phase in Phase if phase >= first and self._lengths[phase]), None)
        if found is None:
            motor.end(done, self._brake, self._is_timed)
            return
        motor.subtract(done, self._is_timed)
        self._phase = found
        if found is not Phase.UP or not self._is_regulated or not motor.tachometer.speed:
            motor.forget()
        if found is Phase.UP:
            self._begin_ramp_up(motor)
        elif found is Phase.DOWN:
            self._down_rate = _rate(motor.goal, self._lengths[found])
            self._is_crawling = False
            return
        elif self._is_regulated:
            motor.aim = signed(motor.goal, 8)
        else:
            motor.power = motor.goal
            motor.output(motor.power, motor.characteristics.plain)
        self._is_near = False
        self._is_soft = self._brake == 1 and not any(self._lengths[found + 1 :])

    def _begin_ramp_up(self, motor: Motor) -> None:
        base = motor.tachometer.speed if self._is_regulated else 0
        self._up_base = motor.tachometer.speed
        self._up_rate = _rate(motor.goal - base, self._lengths[Phase.UP])
        if self._is_regulated and not self._up_rate:
            self._up_rate = 1

    # Ticks

    def act(self, motor: Motor) -> None:
        """Does the work of a tick."""
        count = motor.count(self._is_timed)
        motor.clear_other(self._is_timed)
        length = self._lengths[self._phase]
        if self._phase is Phase.DOWN:
            if count * self._direction < length * self._direction:
                self._ramp_down(motor, count)
            else:
                motor.end(length, self._brake, self._is_timed)
            return
        if not self._is_near and (count + self._lead(motor)) * self._direction < length * self._direction:
            _DRIVES[self._phase, self._is_regulated](self, motor, count)
            return
        self._is_near = True
        if not self._is_soft or motor.approach(length - count, self._direction):
            self._enter(motor, self._phase + 1, length)

    def _lead(self, motor: Motor) -> int:
        """Returns how far before the end of a phase the approach begins."""
        if not self._is_soft:
            return 0
        speed = motor.tachometer.speed
        return speed if self._is_timed else divide(speed, 2 if motor.is_large else 3)

    def _ramp_up_speed(self, motor: Motor, count: int) -> None:
        aim = signed(divide(signed(count * self._up_rate, 32), _RATE) + self._up_base, 8)
        motor.aim = self._direction * max(aim * self._direction, _LEAST_UP)
        motor.regulate()

    def _ramp_up_power(self, motor: Motor, count: int) -> None:
        if motor.tachometer.speed:
            wanted = signed(count * self._up_rate, 32)
            # As in the driver, whose limit is a thousand times what it sets.
            if motor.power * self._direction < wanted * self._direction:
                motor.power = divide(wanted, _RATE)
            if motor.power * self._direction < 0:
                motor.power = -motor.power
        else:
            motor.power += _PUSH * self._direction
        motor.output(motor.power, motor.characteristics.plain)

    def _keep_speed(self, motor: Motor, _: int) -> None:
        motor.regulate()

    def _keep_power(self, motor: Motor, _: int) -> None:
        """Does nothing: the power was put out when the phase began."""

    def _ramp_down(self, motor: Motor, count: int) -> None:
        wanted = motor.goal - divide(signed(count * self._down_rate, 32), _RATE)
        if self._is_regulated:
            wanted = signed(wanted, 8)
            if wanted * self._direction > _LEAST_DOWN:
                motor.aim = wanted
            motor.regulate()
        elif motor.tachometer.speed * self._direction > _CRAWL and not self._is_crawling:
            if wanted * self._direction > _LEAST_DOWN:
                motor.power = wanted
            motor.output(motor.power, motor.characteristics.plain)
        else:
            self._is_crawling = True
            motor.aim = _CRAWL * self._direction
            motor.regulate()


_DRIVES: dict[tuple[Phase, bool], Callable[[Move, Motor, int], None]] = {
    (Phase.UP, True): Move._ramp_up_speed,
    (Phase.UP, False): Move._ramp_up_power,
    (Phase.FLAT, True): Move._keep_speed,
    (Phase.FLAT, False): Move._keep_power,
}
"""What a motor does before the end of a phase, by whether it is regulated."""


def _rate(change: int, length: int) -> int:
    """Returns the slope of a ramp, rounded as the driver does."""
    return divide(change * _RATE + divide(length, 2), length)


def aligned(percent: int, lengths: Sequence[int]) -> list[int]:
    """Returns the lengths of a move, all reversed if the sign of one of them is not that of its power or speed."""
    is_reversed = any(length * percent < 0 for length in lengths)
    return [-length if is_reversed else length for length in lengths]
