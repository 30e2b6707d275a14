"""What a page shows of a brick, as JSON; and what a page may do to it."""

from __future__ import annotations

import base64
import math
import os
from typing import Any

from ev3proto.brick.devices.buttons import BUTTONS
from ev3proto.brick.devices.motors import PORTS as MOTOR_PORTS
from ev3proto.brick.devices.sensors import PORTS
from ev3proto.brick.running_programs import RUNNING, USER_SLOT
from ev3proto.brick.servers.host import Host
from ev3proto.tables.devices import DEVICE_TYPES
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.enumerations import CONN, LEDPATTERN, TYPE

MOST_FILES = 500
"""Entries of a folder that are shown."""

_MOST_TERMINAL = 2000
_MOTOR = CONN.members["CONN_OUTPUT_TACHO"]
_NONE = TYPE.members["TYPE_NONE"]
_NAMES = {number: name.removeprefix("TYPE_") for name, number in TYPE.members.items()}


class ActionError(ValueError):
    """A page asked for something impossible."""


def facts() -> dict[str, Any]:
    """What never changes: the devices there are, the names of the light's patterns, the buttons."""
    types = [
        {
            "number": number,
            "name": _NAMES.get(number, str(number)),
            "motor": device.connection == _MOTOR,
            "modes": [
                {
                    "name": mode.name,
                    "datasets": mode.datasets,
                    "least": min(mode.raw),
                    "most": max(mode.raw),
                    "symbol": mode.symbol,
                }
                for mode in device.modes
            ],
        }
        for number, device in sorted(DEVICE_TYPES.items())
        if number != TYPE.members["TYPE_UNKNOWN"]
    ]
    leds = {number: name for name, number in LEDPATTERN.members.items()}
    return {"types": types, "none": _NONE, "leds": leds, "buttons": list(BUTTONS), "motors": list(MOTOR_PORTS)}


def state(host: Host) -> dict[str, Any]:
    """All that changes, by key; whatever is not JSON is omitted by its key's own form."""
    brick = host.brick
    playing = brick.sound.playing
    program = brick.machine.slots[USER_SLOT]
    return {
        "name": brick.settings.name,
        "display": base64.b64encode(b"".join(brick.display.rows)).decode(),
        "light": brick.leds,
        "down": [name for name, number in BUTTONS.items() if brick.buttons.is_down(number)],
        "motors": _motors(host),
        "sensors": _sensors(host),
        "tone": None
        if playing is None or not playing.frequency
        else {"volume": playing.volume, "frequency": playing.frequency, "began": playing.began},
        "terminal": (bytes(brick.console.printed) + bytes(brick.console.text))[-_MOST_TERMINAL:].decode(STRING_CODING),
        "clients": [connection.name for connection in host.connections],
        "program": program is not None and program.status == RUNNING,
        "battery": {"volt": round(brick.panel.battery.voltage, 2), "percent": brick.panel.battery.percent},
    }


def _motors(host: Host) -> list[dict[str, Any]]:
    return [
        {
            "port": port,
            "type": motor.type,
            "angle": round(motor.angle, 1),
            "speed": motor.speed_now,
            "busy": motor.is_busy,
        }
        for port, motor in zip(MOTOR_PORTS, host.brick.outputs.motors, strict=True)
    ]


def _sensors(host: Host) -> list[dict[str, Any]]:
    plugged = host.brick.inputs.plugged()
    found: list[dict[str, Any]] = []
    for port in range(1, PORTS + 1):
        device = plugged.get(port)
        if device is None:
            found.append({"port": port, "type": _NONE, "mode": 0, "values": []})
            continue
        values = [device.raw(dataset) for dataset in range(device.mode_data.datasets)]
        shown = [None if math.isnan(value) else value for value in values]
        found.append({"port": port, "type": device.type.number, "mode": device.mode, "values": shown})
    return found


def listing(host: Host, path: str) -> dict[str, Any]:
    """A folder of the brick. ActionError where there is none."""
    files = host.brick.files
    name = _path(path)
    place = files.locate(name)
    if place is None or not files.is_folder(name):
        raise ActionError(f"there is no folder {path}")
    entries = []
    for entry in files.shown(name)[:MOST_FILES]:
        below = name.rstrip(b"/") + b"/" + entry
        is_folder = files.is_folder(below)
        if is_folder or files.is_file(below):
            size = None if is_folder else (place / os.fsdecode(entry)).lstat().st_size
            entries.append({"name": entry.decode(STRING_CODING), "size": size})
    return {"path": path, "entries": entries}


def contents(host: Host, path: str) -> bytes:
    """A file of the brick. ActionError where there is none."""
    found = host.brick.files.read(_path(path))
    if found is None:
        raise ActionError(f"there is no file {path}")
    return found


def act(host: Host, action: Any) -> None:
    """Does what a page asks for.

    Args:
        host: What drives the brick.
        action: An object with `do`: press, release, plug, read.

    Raises:
        ActionError: It is none of these, or asks for what cannot be.
    """
    if not isinstance(action, dict):
        raise ActionError("an action is an object")
    brick = host.brick
    try:
        match action:
            case {"do": "press", "button": str(button)}:
                brick.press(button)
            case {"do": "release", "button": str(button)}:
                brick.release(button)
            case {"do": "plug", "port": int() | str() as port, "type": int(number)}:
                brick.plug(port, number)
            case {"do": "read", "port": int(port), "mode": int(mode), "values": list(values)}:
                device = brick.inputs.plugged().get(port)
                if device is not None:
                    brick.plug(port, device.type.number, {mode: _numbers(values, device.type.modes[mode].datasets)})
            case _:
                raise ActionError("there is no such action")
    except (ValueError, IndexError) as error:
        raise ActionError(str(error)) from None
    host.wake()


def _numbers(values: list[Any], most: int) -> tuple[float, ...]:
    numbers = [value for value in values if isinstance(value, int | float) and math.isfinite(value)]
    if len(numbers) != len(values) or len(numbers) > most:
        raise ActionError(f"readings are 1 to {most} numbers")
    return tuple(float(number) for number in numbers)


def _path(path: str) -> bytes:
    try:
        return path.encode(STRING_CODING)
    except UnicodeEncodeError:
        raise ActionError("no name on a brick has such characters") from None
