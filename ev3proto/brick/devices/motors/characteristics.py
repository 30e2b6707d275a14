"""What the driver assumes of large and medium motors."""

from __future__ import annotations

from typing import NamedTuple

from ev3proto.tables.enumerations import TYPE

LARGE_TYPE, MEDIUM_TYPE = TYPE.members["TYPE_TACHO"], TYPE.members["TYPE_MINITACHO"]

MOST_POWER = 10_000
"""Full power, in hundredths of a percent. Duties have the same unit."""


class Duty(NamedTuple):
    """The duty of the smallest power, and how much full power adds to it."""

    least: int
    share: int


class Characteristics(NamedTuple):
    """Constants of a type of motor.

    degree_time  counts between two degrees at 1 percent, of the counter that times them
    samples      numbers of degrees over which speed is measured, each with the speed in percent above which it is used
    """

    degree_time: int
    samples: tuple[tuple[int, int], ...]
    proportional: int
    integral_divisor: int
    plain: Duty
    regulated: Duty


LARGE = Characteristics(
    degree_time=12_800,
    samples=((80, 64), (60, 32), (40, 16), (0, 4)),
    proportional=2,
    integral_divisor=4,
    plain=Duty(500, 9_500),
    regulated=Duty(0, 10_000),
)

MEDIUM = Characteristics(
    degree_time=8_100,
    samples=((80, 16), (60, 8), (40, 4), (0, 2)),
    proportional=4,
    integral_divisor=3,
    plain=Duty(2_000, 8_000),
    regulated=Duty(1_000, 9_000),
)
