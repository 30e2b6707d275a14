"""Devices of one's own: declared by a script or a program, and checked key by key.

brick.plug(2, {"type": 60, "modes": [{"name": "COMPASS", "format": "DATA_16", "raw": (0, 359), "symbol": "deg"}]})
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeVar

from ev3proto.errors import near_misses
from ev3proto.tables.devices import DEVICE_TYPES, PERCENT, UNITS, Dataset, DeviceType, Mode, Range
from ev3proto.tables.enumerations import CONN, DATA_FORMAT, TYPE

T = TypeVar("T")

CONNECTIONS = ("CONN_INPUT_UART", "CONN_NXT_IIC", "CONN_INPUT_DUMB", "CONN_NXT_DUMB", "CONN_NXT_COLOR")
"""How a sensor can be connected; the first one is the default."""

FORMATS = ("DATA_8", "DATA_16", "DATA_32", "DATA_F")
"""The formats of raw values."""

MOST_NUMBER = 124
MOST_MODES = MOST_DATASETS = 8
MOST_NAME, MOST_SYMBOL, MOST_TITLE = 11, 4, 40
MOST_FIGURES, MOST_SETTLING = 15, 5000


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
    known_keys(where, entry, ("type", "title", "connection", "settling", "modes", "readings"), ("type", "modes"))
    if isinstance(port, str):
        raise DeclarationError(f"{where}.modes: only sensors can be declared, on the ports 1 to 4")
    modes = entry["modes"]
    if not isinstance(modes, Sequence) or not 1 <= len(modes) <= MOST_MODES:
        raise DeclarationError(f"{where}.modes must be a list of 1 to {MOST_MODES} tables")
    kind = _type(f"{where}.type", entry["type"])
    return DeviceType(
        kind,
        _optional(where, entry, "title", _text(MOST_TITLE), f"declared type {kind}"),
        CONN.members[_optional(where, entry, "connection", _one_of(CONNECTIONS), CONNECTIONS[0])],
        len(modes),
        tuple(_mode(f"{where}.modes.{at}", table(f"{where}.modes.{at}", mode)) for at, mode in enumerate(modes)),
        _optional(where, entry, "settling", _whole(0, MOST_SETTLING), 0),
    )


def _optional(where: str, entry: Mapping[str, Any], key: str, read: Callable[[str, Any], T], default: T) -> T:
    return read(f"{where}.{key}", entry[key]) if key in entry else default


_MODE_KEYS = ("name", "format", "raw", "si", "percent", "symbol", "values", "datasets", "figures", "decimals")


def _mode(where: str, entry: Mapping[str, Any]) -> Mode:
    known_keys(where, entry, _MODE_KEYS, ("name", "format", "raw"))
    raw = _range(f"{where}.raw", entry["raw"])
    symbol = _optional(where, entry, "symbol", _text(MOST_SYMBOL), "")
    names: tuple[str, ...] = _optional(where, entry, "values", _names, ())
    values = tuple(Dataset(name, UNITS.get(symbol, symbol)) for name in names)
    count = _optional(where, entry, "datasets", _whole(1, MOST_DATASETS), len(values) or 1)
    if values and count != len(values):
        raise DeclarationError(f"{where}.datasets is {count}, but values has {len(values)} names")
    return Mode(
        _text(MOST_NAME)(f"{where}.name", entry["name"]),
        count,
        DATA_FORMAT.members[_one_of(FORMATS)(f"{where}.format", entry["format"])],
        _optional(where, entry, "figures", _whole(1, MOST_FIGURES), 4),
        _optional(where, entry, "decimals", _whole(0, MOST_FIGURES), 0),
        raw,
        _optional(where, entry, "si", _range, raw),
        symbol,
        _optional(where, entry, "percent", _range, PERCENT),
        values,
    )


def _type(where: str, value: Any) -> int:
    found = TYPE.members.get(value) if isinstance(value, str) else value
    if isinstance(found, bool) or not isinstance(found, int) or not 1 <= found <= MOST_NUMBER:
        raise DeclarationError(f"{where}: unknown type {value!r}; expected 1 to {MOST_NUMBER}, or a name of TYPE")
    table_entry = DEVICE_TYPES.get(found)
    if table_entry is not None and table_entry.is_output:
        raise DeclarationError(f"{where}: {found} is the type of a motor: {table_entry.title}")
    return found


def _text(most: int) -> Callable[[str, Any], str]:
    def read(where: str, value: Any) -> str:
        if isinstance(value, str) and 0 < len(value) <= most and value.isprintable() and max(value) <= "\xff":
            return value
        raise DeclarationError(f"{where} must be a text of 1 to {most} characters of ISO-8859-1")

    return read


def _whole(least: int, most: int) -> Callable[[str, Any], int]:
    def read(where: str, value: Any) -> int:
        if isinstance(value, int) and not isinstance(value, bool) and least <= value <= most:
            return value
        raise DeclarationError(f"{where} must be a whole number from {least} to {most}")

    return read


def _one_of(names: Sequence[str]) -> Callable[[str, Any], str]:
    def read(where: str, value: Any) -> str:
        if value in names:
            return str(value)
        hint = near_misses(value, names) if isinstance(value, str) else ""
        expected = f"; expected one of {', '.join(names)}"
        raise DeclarationError(f"{where}: unknown name {value!r}{hint or expected}")

    return read


def _names(where: str, value: Any) -> tuple[str, ...]:
    if not isinstance(value, list | tuple) or not 1 <= len(value) <= MOST_DATASETS:
        raise DeclarationError(f"{where} must be a list of 1 to {MOST_DATASETS} names")
    return tuple(_text(MOST_TITLE)(f"{where}.{at}", name) for at, name in enumerate(value))


def _range(where: str, value: Any) -> Range:
    if not isinstance(value, list | tuple) or len(value) != len(Range._fields):
        raise DeclarationError(f"{where} must be two numbers: [least, most]")
    least, most = (number(where, end) for end in value)
    if least == most:
        raise DeclarationError(f"{where} must be two different numbers")
    return Range(least, most)
