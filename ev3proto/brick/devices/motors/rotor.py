"""A motor without load or friction: it turns toward the speed that its bridge asks for, with a lag.

Only the lags and full speeds are assumptions; a real motor's depend on load and battery.
"""

from __future__ import annotations

from typing import NamedTuple

from ev3proto.brick.devices.motors.characteristics import LARGE_TYPE, MEDIUM_TYPE, MOST_POWER

CONTROL_PERIOD = 2_000
"""Microseconds of a tick of the driver."""

TICK_MILLISECONDS = CONTROL_PERIOD // 1_000

DEGREE = 1_000_000
"""Parts of a degree in which places are counted, so that equal steps add up exactly."""

_FULL_SPEEDS = {LARGE_TYPE: 1020.0, MEDIUM_TYPE: 1500.0}
"""Degrees a second at full duty."""

_STICTION = 6.0
"""Degrees a second below which a motor stops that is not driven."""

_NEGLIGIBLE = 1e-6
"""Degrees a second of difference from the final speed below which that is reached."""

_PARTS = 40
"""Parts of a tick after each of which the speed follows."""


class _Response(NamedTuple):
    """How a motor follows its bridge in one tick: the rest of a difference in speed, and the seconds it acts for."""

    rest: float
    seconds: float


def _response(lag: float) -> _Response:
    """Returns the response for a lag in seconds."""
    part = CONTROL_PERIOD / 1_000_000 / _PARTS
    keep = 1 - part / lag
    rest = keep**_PARTS
    return _Response(rest, part * keep * (1 - rest) / (1 - keep))


_DRIVEN, _FREEWHEELING, _BRAKED, _COASTING = map(_response, (0.06, 0.02, 0.015, 0.15))


class Rotor:
    """A motor at rest; its place is in parts of a degree, its velocity in degrees a second."""

    def __init__(self, type: int) -> None:
        self.place = 0
        self.velocity = self._target = 0.0
        self._full_speed = _FULL_SPEEDS.get(type, 0.0)
        self._response = _COASTING

    def drive(self, direction: int, duty: int) -> None:
        """Drives forward (1) or backward (-1), with a duty of 1 to 10000."""
        self._target = self._full_speed * direction * duty / MOST_POWER
        self._response = _DRIVEN

    def release(self) -> None:
        """Sets the duty to 0; a brake stays on."""
        self._target = 0.0
        if self._response is _DRIVEN:
            self._response = _FREEWHEELING

    def brake(self) -> None:
        """Shorts the motor."""
        self._target, self._response = 0.0, _BRAKED

    def coast(self) -> None:
        """Disconnects the motor."""
        self._target, self._response = 0.0, _COASTING

    @property
    def is_braked(self) -> bool:
        """Whether the motor is shorted."""
        return self._response is _BRAKED

    @property
    def is_still(self) -> bool:
        """Whether it neither turns nor is driven."""
        return not self.velocity and not self._target

    def turn(self) -> int:
        """Turns for a tick. Returns how far, in parts of a degree."""
        target = self._target
        difference = self.velocity - target
        rest, seconds = self._response
        step = round(target * CONTROL_PERIOD + difference * seconds * DEGREE)
        difference *= rest
        limit = _NEGLIGIBLE if target else _STICTION
        self.velocity = target if -limit < difference < limit else target + difference
        self.place += step
        return step
