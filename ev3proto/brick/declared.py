"""Devices of one's own: declared by a script or a program, and checked key by key.

brick.plug(2, {"type": 60, "modes": [{"name": "COMPASS", "format": "DATA_16", "raw": (0, 359), "symbol": "deg"}]})
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from ev3proto.errors import near_misses
from ev3proto.tables.declaration import Enumeration
from ev3proto.tables.devices import DEVICE_TYPES, UNITS, Dataset, DeviceType, Mode, Range
from ev3proto.tables.enumerations import CONN, DATA_FORMAT, TYPE

Read = Callable[[str, Any], Any]
"""Returns what a value means, given its key for messages. Raises DeclarationError."""

_CONNECTIONS = ("CONN_INPUT_UART", "CONN_NXT_IIC", "CONN_INPUT_DUMB", "CONN_NXT_DUMB", "CONN_NXT_COLOR")
_FORMATS = ("DATA_8", "DATA_16", "DATA_32", "DATA_F")
_MOST_NUMBER = 124
_MOST_MODES = _MOST_DATASETS = 8
_MOST_NAME, _MOST_SYMBOL, _MOST_TITLE = 11, 4, 40
_MOST_FIGURES, _MOST_SETTLING = 15, 5000


class DeclarationError(ValueError):
    """A declaration with a key that is missing, unknown or wrong; the text names the key."""


def known_keys(where: str, entry: Mapping[str, Any], names: Sequence[str], needed: Sequence[str] = ()) -> None:
    """Checks the keys of a table. Raises DeclarationError for one that is unknown or missing."""
    for key in entry:
        if key not in names:
            raise DeclarationError(f"{where}: unknown key {key!r}; expected one of {', '.join(names)}")
    for key in needed:
        if key not in entry:
            raise DeclarationError(f"{where}.{key} is missing")


def table(where: str, value: Any) -> Mapping[str, Any]:
    """Returns a table. Raises DeclarationError for anything else."""
    if not isinstance(value, Mapping):
        raise DeclarationError(f"{where} must be a table")
    return value


def number(where: str, value: Any) -> float:
    """Returns a finite number. Raises DeclarationError for anything else."""
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise DeclarationError(f"{where} must be a number")
    return float(value)


def declared_device(where: str, entry: Mapping[str, Any], port: int | str) -> DeviceType:
    """Returns a device of one's own.

    Args:
        where: What is in front of a key in messages, such as `ports.2`.
        entry: `type`, a number or a name of TYPE, and `modes`, a list; also `title`, `connection`, a name of CONN, and
            `settling`, in milliseconds. A mode has `name`, `format`, a name of DATA_FORMAT, and `raw`, the range of raw
            values; also `si` and `percent`, the ranges to which they are scaled, `symbol`, `values`, the names of its
            values, or their number, `datasets`, `figures` and `decimals`.
        port: The port, 1 to 4.

    Raises:
        DeclarationError: A key is missing, unknown or wrong.
    """
    if isinstance(port, str):
        raise DeclarationError(f"{where}.modes: only sensors can be declared, on the ports 1 to 4")
    found = _checked(where, entry, _DEVICE, ("type", "modes"))
    kind = found.pop("type")
    usual: dict[str, Any] = {"title": f"declared type {kind}", "connection": CONN.members[_CONNECTIONS[0]]}
    return DeviceType(**usual | found, number=kind, views=len(found["modes"]))


def _checked(where: str, entry: Any, readers: Mapping[str, Read], needed: Sequence[str]) -> dict[str, Any]:
    """Returns the values of a table as they are meant, by key."""
    known_keys(where, table(where, entry), tuple(readers), needed)
    return {key: readers[key](f"{where}.{key}", value) for key, value in entry.items()}


def _mode(where: str, entry: Any) -> Mode:
    found = _checked(where, entry, _MODE, ("name", "format", "raw"))
    symbol, names = found.get("symbol", ""), found.get("values", ())
    count = found.setdefault("datasets", len(names) or 1)
    if names and count != len(names):
        raise DeclarationError(f"{where}.datasets is {count}, but values has {len(names)} names")
    values = tuple(Dataset(name, UNITS.get(symbol, symbol)) for name in names)
    return Mode(**{"figures": 4, "decimals": 0, "si": found["raw"]} | found | {"values": values})


def _type(where: str, value: Any) -> int:
    found = TYPE.members.get(value) if isinstance(value, str) else value
    if isinstance(found, bool) or not isinstance(found, int) or not 1 <= found <= _MOST_NUMBER:
        raise DeclarationError(f"{where}: unknown type {value!r}; expected 1 to {_MOST_NUMBER}, or a name of TYPE")
    known = DEVICE_TYPES.get(found)
    if known is not None and known.is_output:
        raise DeclarationError(f"{where}: {found} is the type of a motor: {known.title}")
    return found


def _text(most: int) -> Read:
    def read(where: str, value: Any) -> str:
        if isinstance(value, str) and 0 < len(value) <= most and value.isprintable() and max(value) <= "\xff":
            return value
        raise DeclarationError(f"{where} must be a text of 1 to {most} characters of ISO-8859-1")

    return read


def _whole(least: int, most: int) -> Read:
    def read(where: str, value: Any) -> int:
        if isinstance(value, int) and not isinstance(value, bool) and least <= value <= most:
            return value
        raise DeclarationError(f"{where} must be a whole number from {least} to {most}")

    return read


def _member(enumeration: Enumeration, names: Sequence[str]) -> Read:
    def read(where: str, value: Any) -> int:
        if value in names:
            return enumeration.members[value]
        hint = near_misses(value, names) if isinstance(value, str) else ""
        expected = f"; expected one of {', '.join(names)}"
        raise DeclarationError(f"{where}: unknown name {value!r}{hint or expected}")

    return read


def _listed(most: int, what: str, each: Read) -> Read:
    def read(where: str, value: Any) -> tuple[Any, ...]:
        if not isinstance(value, list | tuple) or not 1 <= len(value) <= most:
            raise DeclarationError(f"{where} must be a list of 1 to {most} {what}")
        return tuple(each(f"{where}.{at}", one) for at, one in enumerate(value))

    return read


def _range(where: str, value: Any) -> Range:
    if not isinstance(value, list | tuple) or len(value) != len(Range._fields):
        raise DeclarationError(f"{where} must be two numbers: [least, most]")
    least, most = (number(where, end) for end in value)
    if least == most:
        raise DeclarationError(f"{where} must be two different numbers")
    return Range(least, most)


_MODE: dict[str, Read] = {
    "name": _text(_MOST_NAME),
    "format": _member(DATA_FORMAT, _FORMATS),
    "raw": _range,
    "si": _range,
    "percent": _range,
    "symbol": _text(_MOST_SYMBOL),
    "values": _listed(_MOST_DATASETS, "names", _text(_MOST_TITLE)),
    "datasets": _whole(1, _MOST_DATASETS),
    "figures": _whole(1, _MOST_FIGURES),
    "decimals": _whole(0, _MOST_FIGURES),
}
_DEVICE: dict[str, Read] = {
    "type": _type,
    "title": _text(_MOST_TITLE),
    "connection": _member(CONN, _CONNECTIONS),
    "settling": _whole(0, _MOST_SETTLING),
    "modes": _listed(_MOST_MODES, "tables", _mode),
}
"""The keys of a mode and of a device, which are the names of their fields but for `type`."""
