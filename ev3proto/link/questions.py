"""Properties read from a brick: the operations that read them, and the types of their values."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Generic, NamedTuple, TypeVar

from ev3proto.compose import Draft
from ev3proto.ops import com_get, info, input_device, memory_usage, ui_read
from ev3proto.semantics.replies import Value
from ev3proto.tables.enumerations import HWTYPE, TYPE
from ev3proto.tables.input import MOTOR_PORTS, SENSOR_PORTS

T = TypeVar("T")

_NAME_LENGTH = 120
_TEXT_LENGTH = 64
_ADDRESS_LENGTH = 48


class Battery(NamedTuple):
    """The state of the battery: voltage in V, current in A, charge in percent."""

    voltage: float
    current: float
    percentage: int


class Memory(NamedTuple):
    """The memory for users' files in KiB: total and free."""

    total: int
    free: int


class System(NamedTuple):
    """The versions of operating system, firmware and hardware, and when the first two were built."""

    os_version: str
    os_build: str
    fw_version: str
    fw_build: str
    hw_version: str


class Network(NamedTuple):
    """The WiFi network that the brick is in: its name, the brick's address in it, and that of the brick's adapter."""

    name: str
    ip_adr: str
    mac_adr: str


class Sensors(NamedTuple):
    """The types of the devices at all ports; None for an empty port."""

    Port_1: int | None
    Port_2: int | None
    Port_3: int | None
    Port_4: int | None
    Port_A: int | None
    Port_B: int | None
    Port_C: int | None
    Port_D: int | None


@dataclass(frozen=True, slots=True)
class Question(Generic[T]):
    """A property: the operations that read it, and the function that makes it from their values."""

    operations: tuple[Draft, ...]
    answer: Callable[[list[Any]], T]

    def read(self, values: list[Value]) -> T:
        """Returns the answer in the values of the reply."""
        return self.answer([value.value for value in values])


NAME = Question((com_get.get_brickname(_NAME_LENGTH),), lambda values: str(values[0]))

VOLUME = Question((info.get_volume(),), lambda values: int(values[0]))
"""In percent."""

SLEEP = Question((info.get_minutes(),), lambda values: int(values[0]))
"""Minutes without use after which the brick powers off; 0 for never."""

BATTERY = Question((ui_read.get_vbatt(), ui_read.get_ibatt(), ui_read.get_lbatt()), lambda values: Battery(*values))

MEMORY = Question((memory_usage(),), lambda values: Memory(*values))

SYSTEM = Question(
    (
        ui_read.get_os_vers(_TEXT_LENGTH),
        ui_read.get_os_build(_TEXT_LENGTH),
        ui_read.get_fw_vers(_TEXT_LENGTH),
        ui_read.get_fw_build(_TEXT_LENGTH),
        ui_read.get_hw_vers(_TEXT_LENGTH),
    ),
    lambda values: System(*values),
)

_NOTHING = TYPE.members["TYPE_NONE"]

SENSORS = Question(
    tuple(input_device.get_typemode(0, port) for port in (*SENSOR_PORTS, *MOTOR_PORTS)),
    lambda values: Sensors(*(None if each == _NOTHING else int(each) for each in values[::2])),
)

NETWORK = Question(
    (com_get.get_network(HWTYPE.members["HW_WIFI"], _ADDRESS_LENGTH),),
    lambda values: Network(values[0], *values[:0:-1]),
)
