"""Two motors in step: a master, and a slave that runs at a share of the master's speed."""

from __future__ import annotations

from ev3proto.brick.devices.motors.characteristics import MOST_POWER
from ev3proto.brick.devices.motors.motor import PERCENT, Activity, Motor, clamp, divide, signed
from ev3proto.brick.devices.motors.rotor import TICK_MILLISECONDS

_SATURATED = MOST_POWER - 100
"""Power above which a motor is assumed not to get any faster."""


class Pair(Activity):
    """A move of two motors, which the master regulates for both.

    motors     master and slave
    is_over    whether the move has ended
    """

    def __init__(self, first: Motor, second: Motor, turn: int, *, is_timed: bool) -> None:
        """Creates it; the first motor, the one nearer to port A, is the master unless the turn is negative."""
        self.motors = (first, second) if turn >= 0 else (second, first)
        self.is_over = False
        self._is_timed = is_timed
        self._is_turning = turn != 0
        size = abs(turn)
        # Only the slave's share matters; straight on, the driver compares the motors as they are.
        self._share = size - PERCENT if size >= PERCENT else PERCENT - size
        self._opposite = -1 if size >= PERCENT else 1
        self._length = self._slave_length = 0
        self._direction = self._slave_direction = 1
        self._brake = 0
        self._speed = 0  # of the master, as fast as both can follow
        self._is_closing = False

    def begin(self, speed: int, length: int, brake: int, owner: int) -> None:
        """Begins the move: percent of the master; degrees or milliseconds, 0: without end; a brake of 0: coast.

        The length is reversed if its sign is not that of the speed.
        """
        master, slave = self.motors
        self._speed = speed = clamp(speed, PERCENT)
        self._length = length = -length if speed * length < 0 else length
        self._brake = brake
        for motor in self.motors:
            motor.begin(self, owner)
            if self._is_timed:
                motor.rate = TICK_MILLISECONDS * (1 if length > 0 else -1)
                motor.clock = 0
            elif not length:
                motor.tacho = 0
        master.goal = slave.goal = speed
        self._slave_length = length
        self._direction = 1 if speed > 0 or (speed == 0 and not self._is_turning) else -1
        self._slave_direction = self._direction
        if self._is_turning:
            self._share_out(slave)

    def _share_out(self, slave: Motor) -> None:
        """Gives the slave its share of speed and length."""
        self._slave_direction *= self._opposite
        slave.goal = divide(self._speed * self._share, PERCENT * self._opposite)
        if self._is_timed:
            self._slave_length *= self._opposite
            slave.rate *= self._opposite
        else:
            self._slave_length = divide(self._length * self._share, PERCENT) * self._opposite

    def dissolve(self) -> None:
        """Lets both motors float."""
        for motor in self.motors:
            motor.stop(0)
            motor.aim = 0

    def act(self, motor: Motor) -> None:
        """Does the work of a tick; that of the slave is done in the master's."""
        motor.clear_other(self._is_timed)
        if motor is not self.motors[0]:
            return
        if self._is_closing:
            self._close()
        else:
            self._regulate()

    def _regulate(self) -> None:
        master, slave = self.motors
        self._limit_speed()
        master.aim = self._speed
        slave.aim = self._aim_of_slave()
        self._balance()
        master.regulate()
        slave.regulate()
        lead = master.tachometer.speed if self._is_timed else divide(master.tachometer.speed, 2)
        reached = master.count(self._is_timed) + lead
        self._is_closing = self._length != 0 and reached * self._direction >= self._length * self._direction

    def _limit_speed(self) -> None:
        """Slows both down if one cannot follow, else speeds them up toward what was asked for."""
        master, slave = self.motors
        is_limited = [abs(motor.power) > _SATURATED for motor in self.motors]
        if is_limited[0]:
            self._follow(master, self._direction)
        if is_limited[1]:
            if self._is_turning:
                self._follow_share(slave)
            else:
                self._follow(slave, self._slave_direction)
        if not any(is_limited) and self._speed * self._direction < master.goal * self._direction:
            self._speed = clamp(self._speed + self._direction, PERCENT)

    def _follow(self, motor: Motor, direction: int) -> None:
        """Makes the speed of a motor that cannot reach its aim that of both."""
        speed = motor.tachometer.speed
        if speed * direction < min(motor.aim * direction, self._speed * direction) and _agree(speed, motor.aim):
            self._speed = speed

    def _follow_share(self, slave: Motor) -> None:
        """Makes the speed of a slave that cannot reach its aim its share of the master's."""
        speed, opposite = slave.tachometer.speed, self._opposite
        if speed * self._slave_direction >= slave.aim * self._slave_direction:
            return
        if not self._share:
            # The firmware divides by zero here.
            self._speed = 0
            return
        wanted = divide(speed * PERCENT, self._share * opposite)
        if wanted * self._direction >= self._speed * self._direction:
            return
        if not speed:
            self._speed = 0
        elif _agree(speed, slave.aim):
            self._speed = signed(divide(speed * PERCENT, self._share) * opposite, 8)

    def _aim_of_slave(self) -> int:
        if not self._is_turning:
            return self._speed
        return signed(divide(self._speed * self._share, PERCENT) * self._opposite, 8)

    def _balance(self) -> None:
        """Slows down the motor that is ahead."""
        master, slave = self.motors
        place = slave.tacho
        if self._is_turning:
            if not self._share:
                return
            place = divide(slave.tacho * PERCENT, self._share) * self._opposite
        lag = (master.tacho - place) * self._direction
        if lag > 0:
            _slow_down(master, self._direction)
        elif lag < 0:
            _slow_down(slave, self._slave_direction)

    def _close(self) -> None:
        """Approaches the end, and ends the move when the master has reached it."""
        master, slave = self.motors
        distance = self._length - master.count(self._is_timed)
        if distance * self._direction > 0:
            master.approach(distance, self._direction)
            slave.approach(self._distance_of_slave(), self._slave_direction)
            return
        self.is_over = True
        for motor, length in ((master, self._length), (slave, self._slave_length)):
            motor.aim = 0
            motor.end(length, self._brake, self._is_timed)

    def _distance_of_slave(self) -> int:
        slave = self.motors[1]
        if not self._is_timed:
            return self._slave_length - slave.tacho
        share = self._share if self._is_turning else PERCENT
        return divide(self._slave_length * share, PERCENT) - divide(slave.clock * share, PERCENT)


def _agree(speed: int, aim: int) -> bool:
    """Returns whether neither of two speeds is against the other."""
    return speed * aim >= 0


def _slow_down(motor: Motor, direction: int) -> None:
    """Moves the aim of a motor one step toward 0, unless it is against its direction."""
    if motor.aim * direction > 0:
        motor.aim -= direction
