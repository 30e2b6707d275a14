"""The names of ports: motors A to D as bits and as numbers, sensors S1 to S4 as numbers.

Most operations on motors take a set of ports, NOS; a few take the number of one port, NO.
"""

from enum import IntEnum, IntFlag


class MotorPorts(IntFlag):
    """A set of motor ports, one bit each, for parameters such as NOS: `MotorPorts.A | MotorPorts.B`."""

    A = 1
    B = 2
    C = 4
    D = 8
    ALL = 15


class MotorPort(IntEnum):
    """One motor port, counted from 0, for parameters such as NO of the operations on motors."""

    A = 0
    B = 1
    C = 2
    D = 3


class SensorPort(IntEnum):
    """One sensor port, counted from 0, for parameters such as NO of the operations on sensors."""

    S1 = 0
    S2 = 1
    S3 = 2
    S4 = 3
