"""One motor port of the driver: its counters, its regulator, and what it does from tick to tick."""

from __future__ import annotations

from typing import NamedTuple

from ev3proto.brick.devices.motors.characteristics import LARGE, LARGE_TYPE, MEDIUM, MEDIUM_TYPE, MOST_POWER, Duty
from ev3proto.brick.devices.motors.rotor import DEGREE, Rotor
from ev3proto.brick.devices.motors.tachometer import Tachometer
from ev3proto.tables.enumerations import TYPE

PERCENT = 100
"""Hundredths of a percent in a percent; powers are counted in them."""

_HOLDING = -400
"""Power for each degree that a held motor is away from its place."""

_DAMPING = 80
_RELEASE_TICKS = 50


def clamp(value: int, most: int) -> int:
    """Returns the nearest number from -most to most."""
    return max(-most, min(value, most))


def divide(dividend: int, divisor: int) -> int:
    """Divides integers toward zero, as C does; exact for products of the driver's 32 bits."""
    return abs(dividend) // abs(divisor) * (1 if (dividend < 0) == (divisor < 0) else -1)


def signed(value: int, bits: int) -> int:
    """Returns what a signed integer of a number of bits makes of a larger one."""
    half = 1 << bits - 1
    return (value + half) % (2 * half) - half


class Activity:
    """What a motor does in each tick."""

    is_rest = False
    """Whether START begins something."""

    def act(self, motor: Motor) -> None:
        """Does the work of a tick."""


class _Idle(Activity):
    is_rest = True


class _Held(Activity):
    """Drives the motor back to its place."""

    is_rest = True

    def act(self, motor: Motor) -> None:
        motor.power = clamp(_HOLDING * motor.tacho, MOST_POWER)
        motor.output(motor.power, motor.characteristics.regulated)


class _Powered(Activity):
    """Runs by power, without end."""

    def act(self, motor: Motor) -> None:
        if motor.goal != motor.power:
            motor.power = motor.goal
            motor.output(motor.power, motor.characteristics.plain)
        motor.tacho = motor.clock = 0


class _Regulated(Activity):
    """Runs at a speed, without end."""

    def act(self, motor: Motor) -> None:
        motor.regulate()
        motor.tacho = motor.clock = 0


class _Releasing(Activity):
    """Brakes for a moment after the end of a program, then coasts."""

    def __init__(self) -> None:
        self._left = _RELEASE_TICKS

    def act(self, motor: Motor) -> None:
        if self._left:
            self._left -= 1
        else:
            motor.coast()


IDLE, HELD, POWERED, REGULATED = _Idle(), _Held(), _Powered(), _Regulated()


class Reading(NamedTuple):
    """What clients see of a motor."""

    tacho: int  # degrees of the current move, or since it ended
    speed: int  # percent
    sensor: int  # degrees as a sensor


class Motor:
    """A port of the driver, and the motor that is plugged into it.

    type      of the device that is plugged in
    tacho     degrees of the current move or phase
    sensor    degrees since they were cleared
    clock     milliseconds of the current move
    goal      what was asked for: power, or the speed of a move in percent
    aim       the speed that the regulator seeks, in percent
    starts    what START begins
    is_busy   whether a move with an end is in progress
    owner     object that began the last move
    fixed     what clients see instead of its state, until a command moves it
    """

    def __init__(self) -> None:
        self.type = self._driver_type = TYPE.members["TYPE_NONE"]
        self.characteristics = LARGE
        self.rotor = Rotor(self.type)
        self.tachometer = Tachometer()
        self.tacho = self.sensor = self.clock = self.rate = 0
        self.power = self.goal = self.aim = 0
        self.polarity = 1
        self.starts: Activity = POWERED
        self.activity: Activity = IDLE
        self.is_busy = False
        self.owner = 0
        self.fixed: Reading | None = None
        self.tick = 0
        self._integral = self._last_error = 0
        self._degrees = 0
        self._seen = Reading(0, 0, 0)

    # Readings

    @property
    def reading(self) -> Reading:
        """What clients see, as of the last tick."""
        return self.fixed or self._seen

    @property
    def angle(self) -> float:
        """Degrees since the motor was plugged in, for drawing it."""
        return self.rotor.place / DEGREE

    # Plugging

    def plug(self, type: int, fixed: Reading | None) -> None:
        """Plugs in another motor at rest, or fixes what clients see of the one that is there."""
        if type != self.type:
            self.type = type
            self.set_type(TYPE.members["TYPE_NONE"])
            self.set_type(type)
            self.rotor = Rotor(type)
        self.fixed = fixed

    def set_type(self, type: int) -> None:
        """Learns which type the sensor layer takes the device for; anything but a motor floats."""
        if type == self._driver_type:
            return
        self._driver_type = type
        self.characteristics = MEDIUM if type == MEDIUM_TYPE else LARGE
        if type in (LARGE_TYPE, MEDIUM_TYPE):
            self.tachometer.clear()
            self.tachometer.characteristics = self.characteristics
        else:
            self.coast()
        self.tacho = self.sensor = self.clock = 0
        self._seen = Reading(0, self._seen.speed, 0)

    @property
    def is_there(self) -> bool:
        """Whether a motor is plugged in."""
        return self.type in (LARGE_TYPE, MEDIUM_TYPE)

    @property
    def is_large(self) -> bool:
        """Whether the driver takes it for a large motor."""
        return self._driver_type == LARGE_TYPE

    def set_reading(self, value: int, *, is_speed: bool) -> None:
        """Sets the value that the motor reports as a sensor, its speed or its count."""
        if self.fixed is not None:
            self.fixed = self.fixed._replace(speed=value) if is_speed else self.fixed._replace(sensor=value)
        elif not is_speed:
            self.sensor = value
            self._seen = self._seen._replace(sensor=value)

    def _let_go(self) -> None:
        """Ends fixed readings: a command moves the motor. It goes on counting as a sensor."""
        if self.fixed is not None:
            self.sensor = self.fixed.sensor
            self._seen, self.fixed = self.fixed, None

    # Commands

    def set_power(self, percent: int) -> None:
        """Sets power for START and for a motor that runs by it."""
        self.goal = clamp(percent, PERCENT) * self.polarity * PERCENT
        if self.activity.is_rest:
            self.starts = POWERED

    def set_speed(self, percent: int) -> None:
        """Sets speed for START and for a motor that is regulated."""
        self.aim = signed(clamp(percent, PERCENT) * self.polarity, 8)
        if self.activity.is_rest:
            self.starts = REGULATED

    def start(self, owner: int) -> None:
        """Runs until it is stopped, unless it is moving already."""
        self.owner = owner
        if self.activity.is_rest:
            self._let_go()
            self.activity = self.starts

    def stop(self, brake: int) -> None:
        """Stops, and is held in its place with a brake other than 0, else coasts."""
        self.is_busy = False
        self.power = self.tacho = self.tachometer.speed = 0
        self.tachometer.clear()
        if brake:
            self.activity = HELD
            self.rotor.brake()
        else:
            self.coast()

    def coast(self) -> None:
        """Floats."""
        self.activity = IDLE
        self.rotor.coast()

    def set_polarity(self, polarity: int) -> None:
        """Sets the polarity, 0 for the opposite. The goal is put out at once, even if the motor was not started."""
        if polarity != self.polarity:
            self.goal, self.aim = -self.goal, signed(-self.aim, 8)
            self.polarity = polarity or (-1 if self.polarity == 1 else 1)
        if self.goal:
            self._let_go()
        self.output(self.goal, self.characteristics.plain)

    def reset(self) -> None:
        """Makes the current place 0 of a move; the current phase of one starts over."""
        self.tacho = self.clock = 0
        self._seen = self._seen._replace(tacho=0)

    def clear_count(self) -> None:
        """Makes the current place 0 of the count as a sensor."""
        self.sensor = 0
        self._seen = self._seen._replace(sensor=0)
        if self.fixed is not None:
            self.fixed = self.fixed._replace(sensor=0)

    def end_program(self) -> None:
        """Floats, after a moment if it is held; polarity is 1 again."""
        is_held = self.activity is HELD or (self.activity is IDLE and self.rotor.is_braked)
        self.is_busy = False
        self.power = self.aim = self.tachometer.speed = 0
        if is_held:
            self.activity = _Releasing()
            self.rotor.brake()
        else:
            self.coast()
        self.starts = POWERED
        self.polarity = 1

    # Moves

    def begin(self, activity: Activity, owner: int) -> None:
        """Begins a move with an end."""
        self._let_go()
        self.activity = activity
        self.is_busy = True
        self.owner = owner
        self.tachometer.restart(self.tick)

    def count(self, is_timed: bool) -> int:
        """Returns the counter of a move by time or by angle."""
        return self.clock if is_timed else self.tacho

    def subtract(self, length: int, is_timed: bool) -> None:
        """Sets the counter of a move back by the length of a phase that has ended."""
        if is_timed:
            self.clock -= length
        else:
            self.tacho -= length

    def clear_other(self, is_timed: bool) -> None:
        """Keeps the counter at 0 that a move does not use."""
        if is_timed:
            self.tacho = 0
        else:
            self.clock = 0

    def end(self, length: int, brake: int, is_timed: bool) -> None:
        """Ends a move whose last phase had a length."""
        self.subtract(length, is_timed)
        self.rotor.release()
        if brake:
            self.activity = HELD
            if is_timed:
                self.tacho = 0
        else:
            self.coast()
        self.starts = POWERED
        self.is_busy = False

    def approach(self, distance: int, direction: int) -> bool:
        """Regulates toward an end at a distance in degrees or milliseconds. Returns whether it is reached."""
        if distance * direction <= 0:
            return True
        self.aim = signed(distance, 8)
        if abs(self.aim) > 5 and self.aim * direction < self.tachometer.speed * direction:
            self.aim = direction
        self.regulate()
        return False

    # The regulator

    def forget(self) -> None:
        """Clears the regulator's memory."""
        self._integral = self._last_error = 0

    def output(self, power: int, duty: Duty) -> None:
        """Drives the motor with a power in hundredths of a percent."""
        if not -MOST_POWER <= power <= MOST_POWER:
            power = self.power = clamp(power, MOST_POWER)
        if power:
            self.rotor.drive(1 if power > 0 else -1, abs(power) * duty.share // MOST_POWER + duty.least)
        else:
            self.rotor.release()

    def regulate(self) -> None:
        """Drives the motor toward the speed `aim`, never against it."""
        self.power, self._integral, self._last_error = self._correction()
        self.output(self.power, self.characteristics.regulated)

    def _correction(self) -> tuple[int, int, int]:
        """Returns power, integral and error of the next tick; dividing as floats is exact for such small numbers."""
        constants = self.characteristics
        error = self.aim - self.tachometer.speed
        integral = int(self._integral * 9 / 10) + int(error / constants.integral_divisor)
        change = constants.proportional * error + integral + _DAMPING * (error - self._last_error)
        power = max(-MOST_POWER, min(self.power + change, MOST_POWER))
        return (0 if power * self.aim < 0 else power), integral, error

    # Time

    def turn(self) -> None:
        """Turns for the next tick."""
        self.tick += 1
        place = self.rotor.place
        step = self.rotor.turn()
        if step:
            self._degrees = self.tachometer.pass_degrees(place, step, self.tick)

    def act(self) -> None:
        """Counts what has passed in a tick, and acts on it."""
        degrees, self._degrees = self._degrees, 0
        self.tacho += degrees
        self.sensor += degrees
        self._seen = Reading(self.tacho, self.tachometer.speed, self.sensor)
        self.clock += self.rate
        self.tachometer.measure(self.tick)
        self.activity.act(self)

    @property
    def is_still(self) -> bool:
        """Whether all further ticks are like the last one, so that they can be skipped."""
        is_left_alone = self.activity is IDLE or (self.activity is HELD and not (self.tacho or self.power))
        is_seen = self._seen == (self.tacho, 0, self.sensor)
        return is_left_alone and is_seen and self.rotor.is_still and self.tachometer.is_still

    def skip(self, ticks: int) -> None:
        """Skips ticks of a motor that is still."""
        self.tick += ticks
        self.clock += self.rate * ticks
        self.tachometer.skip(self.tick)
