"""`--script`: the devices of a brick, and events over time, as TOML.

name = "EV3"
voltage = 7.9               # volt
period = 4.0                # the steps begin again every 4 seconds

[ports.1]
type = "TYPE_TOUCH"         # a name or number of TYPE
readings.0 = [0]            # raw readings by mode

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

import math
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ev3proto.brick.brick import Brick
from ev3proto.brick.devices.buttons import BUTTONS
from ev3proto.brick.plugs import Plug, Readings, port_name
from ev3proto.errors import near_misses
from ev3proto.tables.devices import DEVICE_TYPES
from ev3proto.tables.enumerations import TYPE

MOST_SCRIPT = 1 << 20
"""Bytes of a script."""

LEAST_PERIOD = 0.01
"""Seconds."""

_MOST_NAME = 12


class ScriptError(ValueError):
    """An invalid script; the text names the key."""


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
    """Reads a script. Raises OSError, and ScriptError with the place and what is possible there."""
    with path.open("rb") as stream:
        text = stream.read(MOST_SCRIPT + 1)
    if len(text) > MOST_SCRIPT:
        raise ScriptError(f"it has more than {MOST_SCRIPT} bytes")
    try:
        found = tomllib.loads(text.decode())
    except (ValueError, RecursionError) as error:
        raise ScriptError(f"invalid TOML: {error}") from None
    return _Reading().script(found)


@dataclass
class _Reading:
    """Parses a script; keeps the types of the ports, which determine the valid readings."""

    types: dict[int | str, int] = field(default_factory=dict)

    def script(self, found: dict[str, Any]) -> Script:
        _known("the script", found, ("name", "voltage", "current", "period", "ports", "steps"))
        name = found.get("name")
        if name is not None and not (isinstance(name, str) and 0 < len(name) <= _MOST_NAME and name.isprintable()):
            raise ScriptError(f"name must be a text of 1 to {_MOST_NAME} characters")
        plugs = tuple(self._plug(port, entry) for port, entry in _table("ports", found.get("ports", {})).items())
        entries = found.get("steps", [])
        if not isinstance(entries, list):
            raise ScriptError("steps must be a list of tables: [[steps]]")
        steps = tuple(self._step(f"steps, the {number}.", entry) for number, entry in enumerate(entries, 1))
        period = _seconds("period", found["period"]) if "period" in found else None
        last = max((step.at for step in steps), default=0.0)
        if period is not None and period < max(last, LEAST_PERIOD):
            raise ScriptError(f"period must be {max(last, LEAST_PERIOD):g} s at least, the time of the last step")
        volt, ampere = (_number(key, found[key]) if key in found else None for key in ("voltage", "current"))
        return Script(plugs, steps, period, name, volt, ampere)

    def _plug(self, name: str, found: Any) -> Plug:
        where = f"ports.{name}"
        port = _port(where, name)
        entry = _table(where, found)
        _known(where, entry, ("type", "readings"))
        if "type" not in entry:
            raise ScriptError(f"{where} needs a type, a name or number of TYPE")
        self.types[port] = _type(f"{where}.type", entry["type"])
        return Plug(port, self.types[port], self._readings(f"{where}.readings", port, entry.get("readings", {})))

    def _readings(self, where: str, port: int | str, found: Any) -> Readings:
        modes = len(DEVICE_TYPES[self.types[port]].modes)
        readings: Readings = {}
        for key, values in _table(where, found).items():
            if not key.isascii() or not key.isdigit() or int(key) >= modes:
                raise ScriptError(f"{where}.{key}: unknown mode; this type has modes 0 to {modes - 1}")
            listed = values if isinstance(values, list) else [values]
            readings[int(key)] = tuple(_number(f"{where}.{key}", value) for value in listed)
        return readings

    def _step(self, where: str, found: Any) -> Step:
        entry = _table(where, found)
        _known(where, entry, ("at", "ports", "press", "release"))
        if "at" not in entry:
            raise ScriptError(f"{where} needs its time: at = seconds")
        readings: dict[int | str, Readings] = {}
        for name, values in _table(f"{where} ports", entry.get("ports", {})).items():
            port = _port(f"{where} ports.{name}", name)
            if port not in self.types:
                raise ScriptError(f"{where} ports.{name}: nothing is plugged in there; give [ports.{name}] a type")
            readings[port] = self._readings(f"{where} ports.{name}", port, values)
        press, release = (_button(f"{where} {key}", entry.get(key)) for key in ("press", "release"))
        return Step(_seconds(f"{where} at", entry["at"]), readings, press, release)


def _known(where: str, entry: Mapping[str, Any], names: tuple[str, ...]) -> None:
    for key in entry:
        if key not in names:
            raise ScriptError(f"{where}: unknown key {key!r}; expected one of {', '.join(names)}")


def _table(where: str, value: Any) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise ScriptError(f"{where} must be a table")
    return value


def _number(where: str, value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise ScriptError(f"{where} must be a number")
    return float(value)


def _seconds(where: str, value: Any) -> float:
    number = _number(where, value)
    if number < 0:
        raise ScriptError(f"{where} must be 0 seconds or more")
    return number


def _port(where: str, name: str) -> int | str:
    try:
        return port_name(int(name) if name.isdecimal() else name)
    except ValueError as error:
        raise ScriptError(f"{where}: {error}") from None


def _type(where: str, value: Any) -> int:
    number = TYPE.members.get(value) if isinstance(value, str) else value
    if isinstance(number, bool) or not isinstance(number, int) or number not in DEVICE_TYPES:
        names = [name for name, member in TYPE.members.items() if member in DEVICE_TYPES]
        meant = near_misses(value, names) if isinstance(value, str) else ""
        hint = meant or f"; expected one of {', '.join(names)}, or its number"
        raise ScriptError(f"{where}: unknown type {value!r}{hint}")
    return number


def _button(where: str, value: Any) -> str | None:
    if value is not None and value not in BUTTONS:
        raise ScriptError(f"{where}: unknown button {value!r}; expected one of {', '.join(BUTTONS)}")
    return None if value is None else str(value)
