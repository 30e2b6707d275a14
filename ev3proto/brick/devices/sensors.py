"""Inputs: the sensors on the four ports, and the motors, which can be read as sensors.

A sensor is a model with raw readings for each mode, which stay the same until a script or a person changes them.
Programs see what the firmware computes from raw readings: percent, values in a unit, counted edges.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from ev3proto.brick.conversions import single
from ev3proto.brick.declared import declared_device
from ev3proto.brick.devices import Part
from ev3proto.brick.devices.motors import Motor, Outputs
from ev3proto.brick.plugs import PORT_NAMES, port_name
from ev3proto.tables.declaration import DATA8, DATA16, DATA32
from ev3proto.tables.devices import DEVICE_TYPES, NO_DEVICE, DeviceType, Mode, Range
from ev3proto.tables.encoding import RANGES
from ev3proto.tables.enumerations import CONN, DATA_FORMAT, FORMAT_TYPES, SLOT, TYPE

SENSOR_COUNT = 4
FIRST_MOTOR = 16
"""Number of motor port A as an input."""

DEVICES = 32
"""Inputs of the whole daisy chain: sensors of four bricks, then motors of four bricks."""

LAYERS = 4

_TOUCH = TYPE.members["TYPE_TOUCH"]
_NXT_TOUCH = TYPE.members["TYPE_NXT_TOUCH"]
_UART, _MOTOR = CONN.members["CONN_INPUT_UART"], CONN.members["CONN_OUTPUT_TACHO"]
_IIC, _DUMB = CONN.members["CONN_NXT_IIC"], CONN.members["CONN_INPUT_DUMB"]
ANALOG = (_DUMB, CONN.members["CONN_NXT_DUMB"], _MOTOR)
_COUNTING_MODE = 1
_COUNTERS = {_TOUCH: "changes", _NXT_TOUCH: "bumps"}
"""The reading of the second mode of touch sensors."""

_NOT_A_NUMBER = {number: RANGES[kind].nan for number, kind in FORMAT_TYPES.items() if kind in (DATA8, DATA16, DATA32)}
"""By DATA_FORMAT: the raw value by which a sensor reports that it has no value."""
_FLOAT = DATA_FORMAT.members["DATA_F"]
_CODES = dict(zip((DATA_FORMAT.members[f"DATA_{name}"] for name in ("8", "16", "32", "F")), "bhif", strict=True))
"""By DATA_FORMAT: the code of `struct` for a raw value."""

SPEED_MODE = 2
_EDGE = 500

_UNKNOWN = DEVICE_TYPES[TYPE.members["TYPE_UNKNOWN"]]

_MILLISECOND = 1_000

_UPDATE = 10_000
"""Microseconds between two looks of the firmware at its devices; on average one is found ready after half of it."""

_ANSWER_TIME = 20_000
"""Microseconds until a UART sensor sends in a new mode, or again."""


@dataclass
class Device:
    """The firmware's state of the device on a port.

    type       its type, or the one that a program selected; an empty port also has one
    plugged    its real type
    readings   raw readings by mode
    mode       the selected mode
    motor      the motor, where it is one
    busy_until microseconds of the clock
    changes    falling edges of a touch sensor's raw reading: releases of an EV3 sensor, presses of an NXT sensor
    bumps      rising edges
    """

    type: DeviceType = NO_DEVICE
    plugged: DeviceType = NO_DEVICE
    readings: dict[int, tuple[float, ...]] = field(default_factory=dict)
    mode: int = 0
    motor: Motor | None = None
    busy_until: int = 0
    changes: int = 0
    bumps: int = 0
    last: float = 0.0

    @property
    def is_empty(self) -> bool:
        """Whether nothing is plugged in."""
        return self.plugged is NO_DEVICE

    @property
    def connection(self) -> int:
        """How it is connected, see CONN."""
        return self.plugged.connection

    @property
    def mode_data(self) -> Mode:
        """The properties of the selected mode."""
        return self.type.modes[self.mode]

    def set_readings(self, readings: Mapping[int, Sequence[float]]) -> None:
        """Sets raw readings of some modes; a touch sensor counts the edges, and its second mode is such a count."""
        self.readings.update({mode: tuple(values) for mode, values in readings.items()})
        if self.plugged.number not in _COUNTERS:
            return
        if readings.get(0):
            step = readings[0][0] - self.last
            self.bumps += step >= _EDGE
            self.changes += step <= -_EDGE
            self.last = readings[0][0]
        counted = self.readings.pop(_COUNTING_MODE, None)
        if counted:
            setattr(self, _COUNTERS[self.plugged.number], int(counted[0]))

    def clear_counts(self) -> None:
        """Forgets the edges counted."""
        self.changes = self.bumps = 0

    def raw(self, dataset: int = 0) -> float:
        """Returns a raw reading in the selected mode; NaN if there is none, or if it is the format's NaN."""
        mode = self.mode_data
        if dataset >= mode.datasets:
            return math.nan
        value = self._reading(dataset)
        return math.nan if value == _NOT_A_NUMBER.get(mode.format) else value

    def _reading(self, dataset: int) -> float:
        if self.motor is not None:
            return self.motor.reading.speed if self.mode == SPEED_MODE else self.motor.reading.sensor
        if self.mode == _COUNTING_MODE and self.plugged.number in _COUNTERS:
            return float(getattr(self, _COUNTERS[self.plugged.number]))
        values = self.readings.get(self.mode, (0.0,) * self.mode_data.datasets)
        if self.type is not self.plugged and self.mode < len(self.plugged.modes):
            values = _reread(values, self.plugged.modes[self.mode].format, self.mode_data)
        return values[dataset] if dataset < len(values) else math.nan


def _reread(values: Sequence[float], format: int, mode: Mode) -> tuple[float, ...]:
    """Returns what a mode of another type makes of the bytes of raw readings, which have a format."""
    code = _CODES[format]
    whole = code != _CODES[_FLOAT]
    size = struct.calcsize(code)
    data = b"".join(
        (int(value) & ((1 << 8 * size) - 1)).to_bytes(size, "little") if whole else struct.pack(code, value)
        for value in values
    )
    other = f"<{mode.datasets}{_CODES[mode.format]}"
    return tuple(map(float, struct.unpack_from(other, data.ljust(struct.calcsize(other), b"\0"))))


@dataclass
class Calibration:
    """A program's raw range for a mode. CAL_MINMAX sets it, but only CAL_MIN and CAL_MAX activate it."""

    least: float = 0.0
    most: float = 0.0
    is_used: bool = False


def _are_readings(readings: object) -> bool:
    return isinstance(readings, Mapping) and all(
        isinstance(mode, int)
        and isinstance(values, Sequence)
        and all(isinstance(value, int | float) for value in values)
        for mode, values in readings.items()
    )


class Inputs(Part):
    """The inputs of a brick; at first only the motors of its outputs are plugged in."""

    def __init__(self, outputs: Outputs) -> None:
        self._outputs = outputs
        self._devices = {
            number: Device() for number in (*range(SENSOR_COUNT), *range(FIRST_MOTOR, FIRST_MOTOR + SENSOR_COUNT))
        }
        self._types = dict(DEVICE_TYPES)
        self._calibrations: dict[tuple[int, int], Calibration] = {}
        self._brought: set[int] = set()  # types of UART sensors that were plugged in: they bring what is known of them
        self._changed = dict.fromkeys(SLOT.members.values(), 0)
        self._now = 0

    # Plugging

    def device_type(self, port: int | str, type: int | Mapping[str, Any] | DeviceType) -> DeviceType:
        """Returns a type by its number, or one that is declared, as it is known from now on. Raises ValueError."""
        if isinstance(type, int):
            return self._types.get(type, _UNKNOWN)
        if not isinstance(type, Mapping | DeviceType):
            raise ValueError(f"a type is a number, or a table that declares a device, not {type!r}")
        found = type if isinstance(type, DeviceType) else declared_device("device", type, port)
        self._types[found.number] = found
        return found

    @property
    def declared(self) -> list[DeviceType]:
        """The types that are not in the tables."""
        return [found for number, found in self._types.items() if found is not DEVICE_TYPES.get(number)]

    def plug(self, port: int | str, found: DeviceType, readings: Mapping[int, Sequence[float]] | None = None) -> None:
        """Plugs a device in, or gives it new readings by mode; NO_DEVICE unplugs it. Raises ValueError."""
        if not _are_readings(readings or {}):
            raise ValueError(f"readings are numbers by mode, such as {{0: (1900,)}}, not {readings!r}")
        number = self._port(port)
        device = self._devices[number]
        if found.connection == _UART:
            self._brought.add(found.number)
        for mode in readings or {}:
            if not 0 <= mode < len(found.modes):
                raise ValueError(f"type {found.number} has no mode {mode}; it must be 0 to {len(found.modes) - 1}")
        if device.plugged != found:
            motor = self._outputs.motors[number - FIRST_MOTOR] if number >= FIRST_MOTOR else None
            device = Device(found, found, motor=motor)
            self._devices[number] = device
            self._count_change(found)
        device.set_readings(readings or {})

    def has_new(self, port: int | str, found: DeviceType) -> bool:
        """Returns whether a type is a device, and not the one that is plugged into a port. Raises ValueError."""
        return found is not NO_DEVICE and found != self._devices[self._port(port)].plugged

    def _count_change(self, type: DeviceType) -> None:
        """Counts a change of type or mode, for each slot to ask for."""
        if type is not _UNKNOWN:
            for slot in self._changed:
                self._changed[slot] += 1

    @staticmethod
    def _port(port: int | str) -> int:
        index = PORT_NAMES.index(port_name(port))
        return index if index < SENSOR_COUNT else FIRST_MOTOR + index - SENSOR_COUNT

    def plugged(self) -> dict[int | str, Device]:
        """Returns the devices that are plugged in, by port: 1 to 4, "A" to "D"."""
        found = zip(PORT_NAMES, self._devices.values(), strict=True)
        return {name: device for name, device in found if not device.is_empty}

    def advance(self, microseconds: int) -> None:
        """Advances to a time."""
        self._now = microseconds

    # Readings for operations

    def device(self, layer: int, number: int) -> Device | None:
        """Returns the device on a port, empty on other bricks of the daisy chain; None for an unknown port."""
        number += layer * LAYERS
        return self._devices.get(number, _NOTHING) if 0 <= number < DEVICES else None

    def is_busy(self, device: Device) -> bool:
        """Returns whether a device is not ready; an empty port never is."""
        return device.is_empty or self._now < device.busy_until

    def keep_busy(self, device: Device) -> None:
        """Keeps a device that can answer busy after it was written to, an IIC sensor until it is asked again."""
        if device.connection == _UART:
            device.busy_until = self._now + _ANSWER_TIME
        elif device.connection == _IIC:
            device.busy_until = self._now + device.plugged.settling * _MILLISECOND

    def reset(self) -> None:
        """Clears the counts of the sensors, and resets those that can be written to."""
        for number in range(SENSOR_COUNT):
            self._devices[number].clear_counts()
            self.keep_busy(self._devices[number])

    def select(self, device: Device, type: int, mode: int, *, always: bool = False) -> None:
        """Changes type and mode of a device, `always` also of a busy one; TYPE_KEEP and MODE_KEEP leave them.

        An EV3 sensor that is known by its resistor keeps its type; an unknown mode selects the type's last one.
        """
        if device.is_empty or (self.is_busy(device) and not always):
            return
        mode = device.mode if mode == TYPE.members["MODE_KEEP"] else mode
        found = device.type if type == TYPE.members["TYPE_KEEP"] else self._known(type)
        if device.connection == _DUMB and 0 <= mode < len(device.plugged.modes):
            found = device.plugged
        mode = mode if 0 <= mode < len(found.modes) else len(found.modes) - 1
        if (found, mode) == (device.type, device.mode):
            return
        device.type, device.mode = found, mode
        if device.motor is not None:
            device.motor.set_type(found.number)
        self._count_change(found)
        pause = found.settling * _MILLISECOND + _UPDATE // 2
        device.busy_until = self._now + max(pause, _UPDATE, _ANSWER_TIME if device.connection == _UART else 0)

    def _known(self, number: int) -> DeviceType:
        """Returns a type that the firmware knows; that of a UART sensor only if one was plugged in."""
        found = self._types.get(number, _UNKNOWN)
        return _UNKNOWN if found.connection == _UART and number not in self._brought else found

    def raw(self, device: Device, dataset: int) -> float:
        """Returns a raw reading; NaN while the device is not ready, which a motor is as soon as it is read."""
        if device.is_empty or (self.is_busy(device) and device.motor is None):
            return math.nan
        return device.raw(dataset)

    def si(self, device: Device, dataset: int) -> float:
        """Returns a reading in the unit of the mode; NaN while the device is not ready."""
        raw = self.raw(device, dataset)
        mode = device.mode_data
        value = _scaled(raw, self._raw_range(device), mode.si)
        is_clamped = device.type.connection in ANALOG and (not mode.symbol.strip() or mode.symbol.startswith("p"))
        return _clamped(value, mode.si) if is_clamped else value

    def percent(self, device: Device, dataset: int) -> float:
        """Returns a reading in percent, cut to a whole number; NaN while the device is not ready."""
        percent = device.mode_data.percent
        value = _clamped(_scaled(self.raw(device, dataset), self._raw_range(device), percent), percent)
        return value if math.isnan(value) else math.trunc(value)

    def changed(self, slot: int) -> int:
        """Returns how often type or mode of a device changed since a slot last asked."""
        count, self._changed[slot] = self._changed[slot], 0
        return count

    def types(self) -> list[int]:
        """Returns the types on all ports of the daisy chain."""
        return [self._devices.get(number, _NOTHING).type.number for number in range(DEVICES)]

    # Calibration

    def _raw_range(self, device: Device) -> Range:
        calibration = self._calibrations.get((device.type.number, device.mode))
        if calibration is None or not calibration.is_used:
            return device.mode_data.raw
        return Range(calibration.least, calibration.most)

    def _calibration(self, type: int, mode: int) -> tuple[Calibration, Mode] | None:
        """Returns the calibration of a type's mode, and the mode; None for an unknown type or mode."""
        if type not in self._types or not 0 <= mode < len(self._types[type].modes):
            return None
        return self._calibrations.setdefault((type, mode), Calibration()), self._types[type].modes[mode]

    def calibrate_both(self, type: int, mode: int, least: int, most: int) -> None:
        """Sets both ends of a raw range, without activating it."""
        found = self._calibration(type, mode)
        if found is not None:
            found[0].least, found[0].most = float(least), float(most)

    def calibrate(self, type: int, mode: int, value: int, *, is_least: bool) -> None:
        """Moves one end of a raw range; `value` is in the mode's unit once a calibration is used."""
        found = self._calibration(type, mode)
        if found is None:
            return
        calibration, data = found
        raw = float(value)
        if calibration.is_used:
            raw = _scaled(raw, data.si, Range(calibration.least, calibration.most))
        else:
            calibration.least, calibration.most = data.raw
            calibration.is_used = True
        if is_least:
            calibration.least = raw
        else:
            calibration.most = raw

    def uncalibrate(self, type: int, mode: int) -> None:
        """Restores the raw range of a type's mode from the tables."""
        found = self._calibration(type, mode)
        if found is not None:
            found[0].is_used = False


_NOTHING = Device()
"""The empty ports of missing bricks of the daisy chain."""


def _scaled(raw: float, source: Range, target: Range) -> float:
    """Returns a raw reading on another scale, computed in single precision step by step as the firmware does."""
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
