"""The state of a brick that a page shows, and the actions of a page, both as JSON, for a socket or a worker."""

from __future__ import annotations

import base64
import json
import math
import os
from collections.abc import Callable, Sequence
from typing import Any

from ev3proto.brick.brick import Brick
from ev3proto.brick.devices.buttons import BUTTONS
from ev3proto.brick.devices.motors import PORT_LETTERS
from ev3proto.brick.devices.sensors import SENSOR_COUNT
from ev3proto.brick.limits import DEVIATIONS
from ev3proto.brick.running_programs import RUNNING, USER_SLOT
from ev3proto.brick.servers.page.watcher import Unshown
from ev3proto.tables.devices import DEVICE_TYPES, NO_DEVICE, DeviceType
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.enumerations import LEDPATTERN

MOST_FILES = 500
"""Entries of a folder that are shown."""

_MOST_TERMINAL = 2000
_MOST_TALKS = 25
"""Dialogues that are decoded per update."""


_OFFERED = {number: device for number, device in DEVICE_TYPES.items() if device.is_sold or device is NO_DEVICE}


def _facts() -> dict[str, Any]:
    """Returns the constant part of the state: known devices, names of the light's patterns, deviations."""
    types = [_type(device) for device in _OFFERED.values()]
    leds = {number: name for name, number in LEDPATTERN.members.items()}
    return {"types": types, "none": NO_DEVICE.number, "leds": leds, "deviations": DEVIATIONS}


def _type(device: DeviceType) -> dict[str, Any]:
    return {
        "number": device.number,
        "title": device.title,
        "motor": device.is_motor,
        "modes": [
            {"name": mode.name, "values": mode.labels, "raw": mode.raw, "si": mode.si, "decimals": mode.decimals}
            for mode in device.modes
        ],
    }


class Changes:
    """The updates for one page: first the constant part of the state, then the changes since the last update."""

    def __init__(self, brick: Brick, unshown: Unshown, clients: Callable[[], Sequence[str]]) -> None:
        self._brick = brick
        self._unshown = unshown
        self._clients = clients
        self._last: dict[str, Any] = {}

    def take(self) -> dict[str, Any]:
        """Returns the changed parts by key; an empty dict without changes."""
        now = _state(self._brick) | {"clients": list(self._clients())}
        last, self._last = self._last, now
        new: dict[str, Any] = {} if last else {"facts": _facts()}
        new |= {key: value for key, value in now.items() if last.get(key, _UNSEEN) != value}
        talks = [talk.entry(self._brick.equipment.dialect) for talk in self._unshown.take(_MOST_TALKS)]
        if talks:
            new |= {"talks": talks, "left_out": self._unshown.left_out}
        return new


_UNSEEN = object()


def _state(brick: Brick) -> dict[str, Any]:
    """The state that may change, by key."""
    playing, console, battery = brick.equipment.sound.playing, brick.equipment.console, brick.equipment.panel.battery
    program = brick.machine.slots[USER_SLOT]
    return {
        "name": brick.equipment.settings.name,
        "display": base64.b64encode(b"".join(brick.display.rows)).decode(),
        "light": brick.leds,
        "down": [name for name, number in BUTTONS.items() if brick.equipment.buttons.is_down(number)],
        "others": _others(brick),
        "motors": _motors(brick),
        "waiting": brick.waits_for or _endless(brick),
        "sensors": _sensors(brick),
        "tone": None
        if playing is None or not playing.frequency
        else {"volume": playing.volume, "frequency": playing.frequency, "began": playing.began},
        "terminal": bytes(console.printed + console.text)[-_MOST_TERMINAL:].decode(STRING_CODING),
        "program": program is not None and program.status == RUNNING,
        "battery": {"volt": round(battery.voltage, 2), "percent": battery.percent},
    }


def _others(brick: Brick) -> list[dict[str, Any]]:
    """Returns the types of devices that are declared, or on a port, and that are not among the facts."""
    inputs = brick.equipment.inputs
    found = {device.type.number: device.type for device in inputs.plugged().values()}
    found |= {device.number: device for device in inputs.declared}
    return [_type(device) for number, device in found.items() if device is not _OFFERED.get(number)]


def _motors(brick: Brick) -> list[dict[str, Any]]:
    return [
        {
            "port": port,
            "type": motor.type,
            "angle": round(motor.angle, 1),
            "speed": motor.reading.speed,
            "busy": motor.is_busy,
        }
        for port, motor in zip(PORT_LETTERS, brick.equipment.outputs.motors, strict=True)
    ]


def _endless(brick: Brick) -> str:
    """Returns which moves never end because no motor is there; empty without any."""
    missing = brick.equipment.outputs.missing(brick.equipment.outputs.motors)
    return f"a move on {' and '.join(missing)} does not end: no motor is plugged in there" if missing else ""


def _sensors(brick: Brick) -> list[dict[str, Any]]:
    plugged = brick.equipment.inputs.plugged()
    found: list[dict[str, Any]] = []
    for port in range(1, SENSOR_COUNT + 1):
        device = plugged.get(port)
        if device is None:
            found.append({"port": port, "type": NO_DEVICE.number, "mode": 0, "values": []})
            continue
        values = [device.raw(dataset) for dataset in range(device.mode_data.datasets)]
        shown = [None if math.isnan(value) else value for value in values]
        found.append({"port": port, "type": device.type.number, "mode": device.mode, "values": shown})
    return found


def answer(brick: Brick, text: str) -> dict[str, Any] | None:
    """Runs an action of a page, a JSON object. Returns the answer, an `error` if it is impossible."""
    try:
        return _act(brick, json.loads(text))
    except (json.JSONDecodeError, RecursionError):
        return {"error": "the action is not valid JSON"}
    except (ValueError, IndexError, OSError) as error:
        return {"error": str(error)}


def _act(brick: Brick, action: Any) -> dict[str, Any] | None:
    match action:
        case {"do": "press", "button": str(button)}:
            brick.press(button)
        case {"do": "release", "button": str(button)}:
            brick.release(button)
        case {"do": "stop"}:
            brick.stop()
        case {"do": "plug", "port": int() | str() as port, "type": int(number)}:
            brick.plug(port, number)
        case {"do": "read", "port": int(port), "mode": int(mode), "values": list(values)}:
            _set_readings(brick, port, mode, values)
        case {"do": "list", "path": str(path)}:
            return {"folder": _listing(brick, path)}
        case {"do": "fetch", "path": str(path)}:
            return {"file": _contents(brick, path)}
        case _:
            raise ValueError("unknown action")
    return None


def _set_readings(brick: Brick, port: int, mode: int, values: list[Any]) -> None:
    device = brick.equipment.inputs.plugged().get(port)
    if device is not None:
        brick.plug(port, device.type.number, {mode: _numbers(values, device.type.modes[mode].datasets)})


def _contents(brick: Brick, path: str) -> dict[str, Any]:
    found = brick.equipment.files.read(_path(path))
    if found is None:
        raise ValueError(f"no such file: {path}")
    return {"path": path, "contents": base64.b64encode(found).decode()}


def _listing(brick: Brick, path: str) -> dict[str, Any]:
    """Returns a folder of the brick; raises ValueError if it does not exist."""
    files = brick.equipment.files
    name = _path(path)
    place = files.locate(name)
    if place is None or not files.is_folder(name):
        raise ValueError(f"no such folder: {path}")
    entries = []
    for entry in files.shown(name)[:MOST_FILES]:
        below = name.rstrip(b"/") + b"/" + entry
        is_folder = files.is_folder(below)
        if is_folder or files.is_file(below):
            size = None if is_folder else (place / os.fsdecode(entry)).lstat().st_size
            entries.append({"name": entry.decode(STRING_CODING), "size": size})
    return {"path": path, "entries": entries}


def _numbers(values: list[Any], most: int) -> tuple[float, ...]:
    numbers = [value for value in values if isinstance(value, int | float) and math.isfinite(value)]
    if len(numbers) != len(values) or len(numbers) > most:
        raise ValueError(f"expected 1 to {most} numbers")
    return tuple(float(number) for number in numbers)


def _path(path: str) -> bytes:
    try:
        return path.encode(STRING_CODING)
    except UnicodeEncodeError:
        raise ValueError("names on a brick have characters of ISO-8859-1 only") from None
