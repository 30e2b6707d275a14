"""What is plugged into a brick, and the equipment of LEGO's core set."""

from __future__ import annotations

from dataclasses import dataclass, field

from ev3proto.tables.devices import DeviceType
from ev3proto.tables.enumerations import TYPE
from ev3proto.tables.ports import MotorPort, MotorPorts, SensorPort

PORT_NAMES: tuple[int | str, ...] = (*range(1, len(SensorPort) + 1), *(port.name for port in MotorPort))
"""The sensor ports, then the motor ports."""

Readings = dict[int, tuple[float, ...]]
"""Raw readings by mode."""


@dataclass(frozen=True)
class Plug:
    """A device on a port, by its number or declared, and its raw readings by mode."""

    port: int | str
    type: int | DeviceType
    readings: Readings = field(default_factory=dict)


def port_name(port: int | str) -> int | str:
    """Returns a port as 1 to 4 or "A" to "D".

    Args:
        port: 1 to 4, "A" to "D" in either case, or a member of SensorPort or MotorPort.

    Raises:
        ValueError: Anything else, also MotorPorts, which is a set.
    """
    if isinstance(port, SensorPort):
        return port + 1
    if isinstance(port, MotorPort):
        return port.name
    if isinstance(port, MotorPorts):
        meant = "" if port.name not in MotorPort.__members__ else f": MotorPort.{port.name}"
        raise ValueError(f"{port!r} is a set of ports; expected one port{meant}")
    name = port.upper() if isinstance(port, str) else port
    if isinstance(port, bool) or name not in PORT_NAMES:
        raise ValueError(f"unknown port {port!r}; expected one of {', '.join(map(str, PORT_NAMES))}")
    return name


_CENTIMETRES, _INCHES = (2550.0,), (1000.0,)

CORE_SET = (
    Plug("A", TYPE.members["TYPE_MINITACHO"]),
    Plug("B", TYPE.members["TYPE_TACHO"]),
    Plug("C", TYPE.members["TYPE_TACHO"]),
    # Not pressed; at an angle of 0; nothing but the light of a room before it; nothing within 255 cm.
    Plug(1, TYPE.members["TYPE_TOUCH"], {0: (0.0,)}),
    Plug(2, TYPE.members["TYPE_GYRO"], {0: (0.0,), 1: (0.0,)}),
    Plug(3, TYPE.members["TYPE_COLOR"], {0: (0.0,), 1: (10.0,), 2: (0.0,)}),
    Plug(
        4,
        TYPE.members["TYPE_ULTRASONIC"],
        {0: _CENTIMETRES, 1: _INCHES, 3: _CENTIMETRES, 4: _INCHES, 5: _CENTIMETRES, 6: _INCHES},
    ),
)
"""The robot that LEGO's instructions build, at rest."""

CORE_SET_SENTENCE = (
    "plugged in: medium motor on A, large motors on B and C; sensors: touch on 1, gyro on 2, colour on 3,"
    " ultrasonic on 4 (--bare: nothing)"
)
