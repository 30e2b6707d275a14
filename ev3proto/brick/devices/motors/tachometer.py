"""Speed in percent from the times at which the last degrees passed, as the driver measures it."""

from __future__ import annotations

from ev3proto.brick.devices.motors.characteristics import LARGE, Characteristics
from ev3proto.brick.devices.motors.rotor import DEGREE

_COUNTS, _TICKS = 4_125, 16
"""The counter of 128,906.25 Hz that times degrees makes this number of counts in this number of ticks."""

_COUNTER = 0xFFFFFF
"""The counter's bits."""

_RING = 128
_TRUSTED = 35
"""Percent above which the driver counts every degree in the direction that it knows."""

_MOST = 100


def counter(tick: int) -> int:
    """Returns the counter at the end of a tick."""
    return tick * _COUNTS // _TICKS


class Tachometer:
    """Counts degrees and measures speed; `speed` is in percent."""

    def __init__(self) -> None:
        self.speed = 0
        self._direction = 1
        self._still_since = 0
        self.characteristics = LARGE
        self.clear()
        self._samples = self._smallest

    @property
    def characteristics(self) -> Characteristics:
        """The constants of the motor's type."""
        return self._characteristics

    @characteristics.setter
    def characteristics(self, constants: Characteristics) -> None:
        self._characteristics = constants
        self._most_run = constants.samples[0][1]
        self._samples = self._smallest = constants.samples[-1][1]

    def clear(self) -> None:
        """Forgets the times of degrees."""
        self._ring = [0] * _RING
        self._newest = self._measured = 0
        self._run = 0  # degrees in the same direction, at most as many as speed is measured over

    def restart(self, tick: int) -> None:
        """Gives a motor that is about to move time for its first degrees."""
        self._still_since = counter(tick)

    def pass_degrees(self, place: int, step: int, tick: int) -> int:
        """Notes the degrees that pass in a tick, from a place on. Returns those that the driver counts."""
        first, last = place // DEGREE, (place + step) // DEGREE
        if first == last:
            return 0
        direction = 1 if step > 0 else -1
        if direction != self._direction and -_TRUSTED <= self.speed <= _TRUSTED:
            self._direction, self._run = direction, -1
        passed = range(first + 1, last + 1) if step > 0 else range(first, last, -1)
        start = (tick - 1) * step - place
        for degree in passed:
            self._newest = (self._newest + 1) % _RING
            self._ring[self._newest] = (start + degree * DEGREE) * _COUNTS // (_TICKS * step)
        self._run = min(self._run + len(passed), self._most_run)
        return self._direction * len(passed)

    def measure(self, tick: int) -> None:
        """Measures the speed at the end of a tick."""
        ring, newest = self._ring, self._newest
        last = ring[newest]
        if self._run >= 1:
            self._samples = self._samples_for(last - ring[newest - 1] & _COUNTER)
        if newest != self._measured and self._run >= self._samples:
            self._measured = newest
            self._still_since = last
            self.speed = self._direction * self._speed(last - ring[newest - self._samples] & _COUNTER, self._samples)
            return
        now = counter(tick)
        if now - self._still_since > self._characteristics.degree_time:
            self._still_since = now
            self.speed = self._run = 0

    def _samples_for(self, gap: int) -> int:
        """Returns the number of degrees to measure over, from the counts between the last two."""
        speed = self._characteristics.degree_time // gap if gap else 1
        for above, samples in self._characteristics.samples:
            if speed > above:
                return samples
        return self._smallest

    def _speed(self, gap: int, samples: int) -> int:
        """Returns a speed without sign, from the counts that a number of degrees took."""
        return min(samples * self._characteristics.degree_time // gap, _MOST) if gap else 1

    # Skipped time

    @property
    def is_still(self) -> bool:
        """Whether nothing has turned for some time, so that the speed remains 0."""
        return not self.speed and not self._run and self._still_since == counter(self._still_tick)

    @property
    def _still_tick(self) -> int:
        """The first tick at or after the time since which the motor is still."""
        return -(-self._still_since * _TICKS // _COUNTS)

    def skip(self, tick: int) -> None:
        """Continues at a later tick, without degrees meanwhile."""
        period = self._characteristics.degree_time * _TICKS // _COUNTS + 1
        self._still_since = counter(tick - (tick - self._still_tick) % period)
