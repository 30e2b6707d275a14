"""Everything that a virtual brick keeps, for comparing two of them."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from enum import Enum
from pathlib import Path

from ev3proto.brick import Brick

_LEFT_OUT = ("code", "end", "ip", "local_size", "_deadline", "spent")
"""The command's own bytes, the memory that it requests, and the processor's time."""
_PLAIN = (bytes, bytearray, str, int, float, type(None), Enum, Path)


def state_of(brick: Brick) -> dict[str, str]:
    """Returns the values in a brick by the attributes that lead to them."""
    found: dict[str, str] = {}
    _collect("brick", brick, found, set())
    return found


def _collect(name: str, value: object, found: dict[str, str], seen: set[int]) -> None:
    if isinstance(value, _PLAIN):
        found[name] = repr(value)
    elif id(value) not in seen:
        seen.add(id(value))
        for key, each in _parts(value):
            if key not in _LEFT_OUT:
                _collect(f"{name}.{key}", each, found, seen)


def _parts(value: object) -> list[tuple[object, object]]:
    if isinstance(value, Mapping):
        return [*value.items()]
    if isinstance(value, list | tuple | deque | set | frozenset):
        return [*enumerate(value)]
    slots = [name for each in type(value).__mro__ for name in getattr(each, "__slots__", ())]
    return [*getattr(value, "__dict__", {}).items(), *((name, getattr(value, name, None)) for name in slots)]
