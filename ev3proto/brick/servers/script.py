"""`--script`: the devices of a brick, and events over time, as TOML.

name = "EV3"
voltage = 7.9               # volt
period = 4.0                # the steps begin again every 4 seconds

[ports.1]
type = "TYPE_TOUCH"         # a name or number of TYPE
readings.0 = [0]            # raw readings by mode

[ports.2]                   # a sensor of one's own: see ev3proto.brick.declared
type = 60
modes = [{ name = "COMPASS", format = "DATA_16", raw = [0, 359], symbol = "deg" }]

[ports.B]
type = "TYPE_TACHO"

[[steps]]
at = 1.5                    # seconds
ports.1.0 = [4000]          # other readings
press = "enter"

[[steps]]
at = 2.0
release = "enter"
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ev3proto.brick.brick import Brick
from ev3proto.brick.declared import DeclarationError, declared_device, known_keys, number, table
from ev3proto.brick.devices.buttons import BUTTONS
from ev3proto.brick.plugs import Plug, Readings, port_name
from ev3proto.errors import counted, near_misses
from ev3proto.tables.devices import DEVICE_TYPES, DeviceType
from ev3proto.tables.enumerations import TYPE

MOST_SCRIPT = 1 << 20
"""Bytes of a script."""

LEAST_PERIOD = 0.01
"""Seconds."""

_MOST_NAME = 12


@dataclass(frozen=True)
class Step:
    """An event at a time in seconds: new readings of ports, a button pressed or released."""

    at: float
    readings: Mapping[int | str, Readings]
    press: str | None = None
    release: str | None = None


@dataclass(frozen=True)
class Script:
    """A robot and its events."""

    plugs: tuple[Plug, ...] = ()
    steps: tuple[Step, ...] = ()
    period: float | None = None  # seconds after which the steps begin again; None: they happen once
    name: str | None = None
    voltage: float | None = None
    current: float | None = None

    def set_up(self, brick: Brick) -> None:
        """Plugs everything in."""
        for plug in self.plugs:
            brick.plug(plug.port, plug.type, plug.readings)
        if self.name is not None:
            brick.equipment.settings.name = self.name
        if self.voltage is not None:
            brick.equipment.panel.battery.voltage = self.voltage
        if self.current is not None:
            brick.equipment.panel.battery.current = self.current

    def do(self, step: Step, brick: Brick) -> None:
        """Does one step."""
        types = {port: device.type.number for port, device in brick.equipment.inputs.plugged().items()}
        for port, readings in step.readings.items():
            if port in types:
                brick.plug(port, types[port], readings)
        if step.press is not None:
            brick.press(step.press)
        if step.release is not None:
            brick.release(step.release)

    def times(self) -> Iterator[tuple[float, Step]]:
        """Yields the steps in the order of their times, repeatedly if there is a period."""
        steps = sorted(self.steps, key=lambda step: step.at)
        begin = 0.0
        while steps:
            for step in steps:
                yield begin + step.at, step
            if self.period is None:
                return
            begin += self.period


def read_script(path: Path) -> Script:
    """Reads a script. Raises OSError, and DeclarationError with the place and what is possible there."""
    with path.open("rb") as stream:
        text = stream.read(MOST_SCRIPT + 1)
    if len(text) > MOST_SCRIPT:
        raise DeclarationError(f"it has more than {MOST_SCRIPT} bytes")
    try:
        found = tomllib.loads(text.decode())
    except (ValueError, RecursionError) as error:
        raise DeclarationError(f"invalid TOML: {error}") from None
    return _Reading().script(found)


@dataclass
class _Reading:
    """Parses a script; keeps the types of the ports, which determine the valid readings."""

    types: dict[int | str, DeviceType] = field(default_factory=dict)

    def script(self, found: dict[str, Any]) -> Script:
        known_keys("the script", found, ("name", "voltage", "current", "period", "ports", "steps"))
        name = found.get("name")
        if name is not None and not (isinstance(name, str) and 0 < len(name) <= _MOST_NAME and name.isprintable()):
            raise DeclarationError(f"name must be a text of 1 to {_MOST_NAME} characters")
        plugs = tuple(self._plug(port, entry) for port, entry in table("ports", found.get("ports", {})).items())
        entries = found.get("steps", [])
        if not isinstance(entries, list):
            raise DeclarationError("steps must be a list of tables: [[steps]]")
        steps = tuple(self._step(f"steps, the {count}.", entry) for count, entry in enumerate(entries, 1))
        period = _seconds("period", found["period"]) if "period" in found else None
        last = max((step.at for step in steps), default=0.0)
        if period is not None and period < max(last, LEAST_PERIOD):
            raise DeclarationError(f"period must be {max(last, LEAST_PERIOD):g} s at least, the time of the last step")
        volt, ampere = (number(key, found[key]) if key in found else None for key in ("voltage", "current"))
        return Script(plugs, steps, period, name, volt, ampere)

    def _plug(self, name: str, found: Any) -> Plug:
        where = f"ports.{name}"
        port = _port(where, name)
        entry = table(where, found)
        if "modes" in entry:
            self.types[port] = declared_device(where, {key: entry[key] for key in entry if key != "readings"}, port)
        else:
            known_keys(where, entry, ("type", "readings", "modes"), ("type",))
            self.types[port] = _type(f"{where}.type", entry["type"])
        return Plug(port, self.types[port], self._readings(f"{where}.readings", port, entry.get("readings", {})))

    def _readings(self, where: str, port: int | str, found: Any) -> Readings:
        modes = self.types[port].modes
        readings: Readings = {}
        for key, values in table(where, found).items():
            if not key.isascii() or not key.isdigit() or int(key) >= len(modes):
                raise DeclarationError(f"{where}.{key}: unknown mode; this type has modes 0 to {len(modes) - 1}")
            listed = values if isinstance(values, list) else [values]
            if len(listed) > modes[int(key)].datasets:
                most = counted(modes[int(key)].datasets, "value")
                raise DeclarationError(f"{where}.{key} has {len(listed)} values; this mode has {most}")
            readings[int(key)] = tuple(number(f"{where}.{key}", value) for value in listed)
        return readings

    def _step(self, where: str, found: Any) -> Step:
        entry = table(where, found)
        known_keys(where, entry, ("at", "ports", "press", "release"))
        if "at" not in entry:
            raise DeclarationError(f"{where} needs its time: at = seconds")
        readings: dict[int | str, Readings] = {}
        for name, values in table(f"{where} ports", entry.get("ports", {})).items():
            port = _port(f"{where} ports.{name}", name)
            if port not in self.types:
                raise DeclarationError(f"{where} ports.{name}: nothing is plugged in there; give [ports.{name}] a type")
            readings[port] = self._readings(f"{where} ports.{name}", port, values)
        press, release = (_button(f"{where} {key}", entry.get(key)) for key in ("press", "release"))
        return Step(_seconds(f"{where} at", entry["at"]), readings, press, release)


def _seconds(where: str, value: Any) -> float:
    seconds = number(where, value)
    if seconds < 0:
        raise DeclarationError(f"{where} must be 0 seconds or more")
    return seconds


def _port(where: str, name: str) -> int | str:
    try:
        return port_name(int(name) if name.isdecimal() else name)
    except ValueError as error:
        raise DeclarationError(f"{where}: {error}") from None


def _type(where: str, value: Any) -> DeviceType:
    kind = TYPE.members.get(value) if isinstance(value, str) else value
    if isinstance(kind, bool) or not isinstance(kind, int) or kind not in DEVICE_TYPES:
        names = [device.name for device in DEVICE_TYPES.values() if device.name in TYPE.members]
        meant = near_misses(value, names) if isinstance(value, str) else ""
        hint = meant or f"; expected one of {', '.join(names)}, or its number; modes declare another one"
        raise DeclarationError(f"{where}: unknown type {value!r}{hint}")
    return DEVICE_TYPES[kind]


def _button(where: str, value: Any) -> str | None:
    if value is not None and value not in BUTTONS:
        raise DeclarationError(f"{where}: unknown button {value!r}; expected one of {', '.join(BUTTONS)}")
    return None if value is None else str(value)
