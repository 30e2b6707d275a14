"""Inputs: the sensors on the four ports, and the motors as far as they are read as sensors.

A sensor is a model with raw readings for each mode, which stay as they are until a script or a person changes them.
What programs see of it is what the firmware makes of raw readings: percent, values in a unit, edges counted.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from ev3proto.brick.conversions import single
from ev3proto.brick.outputs import PORTS as MOTOR_PORTS
from ev3proto.brick.outputs import Motor, Outputs
from ev3proto.brick.parts import Part
from ev3proto.tables.declaration import DATA8, DATA16, DATA32
from ev3proto.tables.devices import DEVICE_TYPES, NO_DEVICE, DeviceType, Mode, Range
from ev3proto.tables.encoding import RANGES
from ev3proto.tables.enumerations import CONN, FORMAT_TYPES, SLOT, TYPE

PORTS = 4
FIRST_MOTOR = 16
"""Number of motor port A as an input."""

DEVICES = 32
"""Inputs of the whole daisy chain: sensors of four bricks, then motors of four bricks."""

LAYERS = 4

_TOUCH = TYPE.members["TYPE_TOUCH"]
_NXT_TOUCH = TYPE.members["TYPE_NXT_TOUCH"]
_INFRARED = TYPE.members["TYPE_IR"]
_UART, _MOTOR = CONN.members["CONN_INPUT_UART"], CONN.members["CONN_OUTPUT_TACHO"]
_IIC = CONN.members["CONN_NXT_IIC"]
_ANALOG = (CONN.members["CONN_INPUT_DUMB"], CONN.members["CONN_NXT_DUMB"], _MOTOR)
_COUNTING_MODE = 1
_SPEED_MODE = 2
_EDGE = 500
_ANSWER_TIME = 20_000

_CHANGE_TIMES = {_UART: 22_000}
_CHANGE_TIME, _INFRARED_CHANGE_TIME = 10_000, 1_100_000
"""Microseconds that a device is busy after a change of its mode."""


_NANS = {number: RANGES[kind].nan for number, kind in FORMAT_TYPES.items() if kind in (DATA8, DATA16, DATA32)}
"""By DATA_FORMAT: the raw value with which a sensor says that it has none."""


@dataclass
class Device:
    """What the firmware knows of the device on a port.

    type       its type; an empty port has one, too
    readings   raw readings by mode
    mode       the selected mode
    motor      the motor, where it is one
    busy_until microseconds of the clock
    falls      falling edges of the raw reading of a touch sensor
    rises      rising edges
    """

    type: DeviceType = NO_DEVICE
    readings: dict[int, tuple[float, ...]] = field(default_factory=dict)
    mode: int = 0
    motor: Motor | None = None
    busy_until: int = 0
    falls: int = 0
    rises: int = 0
    last: float = 0.0

    @property
    def is_empty(self) -> bool:
        """Whether nothing is plugged in."""
        return self.type is NO_DEVICE

    @property
    def mode_data(self) -> Mode:
        """What the selected mode is like."""
        return self.type.modes[self.mode]

    def set_readings(self, readings: Mapping[int, Sequence[float]]) -> None:
        """New raw readings of some modes; a touch sensor counts the edges."""
        self.readings.update({mode: tuple(values) for mode, values in readings.items()})
        if self.type.number in (_TOUCH, _NXT_TOUCH) and readings.get(0):
            step = readings[0][0] - self.last
            self.rises += step >= _EDGE
            self.falls += step <= -_EDGE
            self.last = readings[0][0]

    @property
    def changes(self) -> int:
        """Releases of a touch sensor: an EV3 sensor's reading falls then, that of an NXT sensor rises."""
        return self.rises if self.type.number == _NXT_TOUCH else self.falls

    @property
    def bumps(self) -> int:
        """Presses of a touch sensor."""
        return self.falls if self.type.number == _NXT_TOUCH else self.rises

    def clear_counts(self) -> None:
        """Forgets the edges counted."""
        self.falls = self.rises = 0

    def raw(self, dataset: int = 0) -> float:
        """A raw reading in the selected mode; NaN where there is none."""
        if dataset >= self.mode_data.datasets:
            return math.nan
        if self.motor is not None:
            return self.motor.speed_now if self.mode == _SPEED_MODE else self.motor.sensor_count
        if self.mode == _COUNTING_MODE and self.mode not in self.readings:
            if self.type.number == _TOUCH:
                return self.changes
            if self.type.number == _NXT_TOUCH:
                return self.bumps
        values = self.readings.get(self.mode, (0.0,) * self.mode_data.datasets)
        if dataset >= len(values) or values[dataset] == _NANS.get(self.mode_data.format):
            return math.nan
        return values[dataset]


class Inputs(Part):
    """The inputs of a brick to which nothing is plugged in but the motors of its outputs."""

    def __init__(self, outputs: Outputs) -> None:
        self._outputs = outputs
        self._devices = {number: Device() for number in (*range(PORTS), *range(FIRST_MOTOR, FIRST_MOTOR + PORTS))}
        self._calibrated: dict[tuple[int, int], Range] = {}
        self._changed = dict.fromkeys(SLOT.members.values(), 0)
        self._now = 0

    # Plugging

    def plug(self, port: int | str, type: int, readings: Mapping[int, Sequence[float]] | None = None) -> None:
        """Plugs a sensor or motor in; the type TYPE_NONE unplugs it. The same type again gets new readings.

        Args:
            port: 1 to 4, or "A" to "D".
            type: the type's number; one that the tables do not have counts as unknown.
            readings: raw readings by mode; what is not given is 0.

        Raises:
            ValueError: there is no such port, or the type has no such mode.
        """
        number = self._port(port)
        device = self._devices[number]
        found = DEVICE_TYPES.get(type, DEVICE_TYPES[TYPE.members["TYPE_UNKNOWN"]])
        for mode in readings or {}:
            if not 0 <= mode < len(found.modes):
                raise ValueError(f"type {type} has no mode {mode}; it must be 0 to {len(found.modes) - 1}")
        if device.type is not found:
            motor = self._outputs.motors[number - FIRST_MOTOR] if number >= FIRST_MOTOR else None
            device = Device(found, motor=motor)
            self._devices[number] = device
            for slot in self._changed:
                self._changed[slot] += 1
        device.set_readings(readings or {})

    @staticmethod
    def _port(port: int | str) -> int:
        if isinstance(port, int) and 1 <= port <= PORTS:
            return port - 1
        if isinstance(port, str) and port.upper() in MOTOR_PORTS:
            return FIRST_MOTOR + MOTOR_PORTS.index(port.upper())
        raise ValueError(f"there is no port {port!r}; it must be one of 1, 2, 3, 4, {', '.join(MOTOR_PORTS)}")

    def plugged(self) -> dict[int | str, Device]:
        """What is plugged in, by port: 1 to 4, "A" to "D"."""
        names: list[int | str] = [*range(1, PORTS + 1), *MOTOR_PORTS]
        found = zip(names, self._devices.values(), strict=True)
        return {name: device for name, device in found if not device.is_empty}

    def advance(self, microseconds: int) -> None:
        """Time has passed."""
        self._now = microseconds

    # What operations ask

    def device(self, layer: int, number: int) -> Device | None:
        """The device on a port, empty on other bricks of the daisy chain; None where there is no such port."""
        number += layer * LAYERS
        return self._devices.get(number, _NOTHING) if 0 <= number < DEVICES else None

    def is_busy(self, device: Device) -> bool:
        """Whether a device is not ready; an empty port never is."""
        return device.is_empty or self._now < device.busy_until

    def keep_busy(self, device: Device) -> None:
        """A device has been written to and answers later. Only those that can answer."""
        if device.type.connection in (_UART, _IIC):
            device.busy_until = self._now + _ANSWER_TIME

    def select(self, device: Device, type: int, mode: int) -> None:
        """Changes the mode of a device that is ready.

        Args:
            device: which one.
            type: the type that it must have; TYPE_KEEP: any.
            mode: the mode; MODE_KEEP: the one it has.
        """
        if device.is_empty or self.is_busy(device) or mode == TYPE.members["MODE_KEEP"] or mode == device.mode:
            return
        if type not in (TYPE.members["TYPE_KEEP"], device.type.number) or not 0 <= mode < len(device.type.modes):
            return
        device.mode = mode
        if device.type.number == _INFRARED:
            pause = _INFRARED_CHANGE_TIME
        else:
            pause = _CHANGE_TIMES.get(device.type.connection, _CHANGE_TIME)
        device.busy_until = self._now + pause

    def raw(self, device: Device, dataset: int) -> float:
        """A raw reading; NaN while the device is not ready."""
        return math.nan if self.is_busy(device) else device.raw(dataset)

    def si(self, device: Device, dataset: int) -> float:
        """A reading in the unit of the mode; NaN while the device is not ready."""
        raw = self.raw(device, dataset)
        mode = device.mode_data
        value = _scaled(raw, self._raw_range(device), mode.si)
        is_clamped = device.type.connection in _ANALOG and (not mode.symbol.strip() or mode.symbol.startswith("p"))
        return _clamped(value, mode.si) if is_clamped else value

    def percent(self, device: Device, dataset: int) -> float:
        """A reading in percent, cut to a whole number; NaN while the device is not ready."""
        percent = device.mode_data.percent
        value = _clamped(_scaled(self.raw(device, dataset), self._raw_range(device), percent), percent)
        return value if math.isnan(value) else math.trunc(value)

    def changed(self, slot: int) -> int:
        """How many devices were plugged in or out since a slot last asked."""
        count, self._changed[slot] = self._changed[slot], 0
        return count

    def types(self) -> list[int]:
        """The types on all ports of the daisy chain."""
        return [self._devices.get(number, _NOTHING).type.number for number in range(DEVICES)]

    def clear(self) -> None:
        """Clears the counts of all devices."""
        for device in self._devices.values():
            device.clear_counts()

    # Calibration

    def _raw_range(self, device: Device) -> Range:
        return self._calibrated.get((device.type.number, device.mode), device.mode_data.raw)

    def calibrate(self, type: int, mode: int, least: int | None = None, most: int | None = None) -> None:
        """Sets ends of the raw range of a type's mode; unknown types and modes are ignored."""
        if type not in DEVICE_TYPES or not 0 <= mode < len(DEVICE_TYPES[type].modes):
            return
        now = self._calibrated.get((type, mode), DEVICE_TYPES[type].modes[mode].raw)
        self._calibrated[type, mode] = Range(now.least if least is None else least, now.most if most is None else most)

    def uncalibrate(self, type: int, mode: int) -> None:
        """Brings back the raw range of a type's mode as the tables have it."""
        self._calibrated.pop((type, mode), None)


_NOTHING = Device()
"""What is on the ports of bricks that are not there."""


def _scaled(raw: float, source: Range, target: Range) -> float:
    """A raw reading on another scale, computed in single precision step by step as the firmware does."""
    if math.isnan(raw):
        return raw
    distance = single(single(raw) - single(source.least))
    rise = single(single(target.most) - single(target.least))
    run = single(single(source.most) - single(source.least))
    if not run:
        return math.nan
    return single(single(single(distance * rise) / run) + single(target.least))


def _clamped(value: float, limits: Range) -> float:
    return value if math.isnan(value) else min(max(value, min(limits)), max(limits))
