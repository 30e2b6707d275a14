"""Calls of functions that are made from tables: names as Python writes them, values by position or by name."""

from __future__ import annotations

import keyword
from collections.abc import Mapping, Sequence
from typing import Any

from ev3proto.errors import near_misses


def python_name(name: str) -> str:
    """A firmware's name as Python writes it: in lower case, with a `_` behind it where it is a word of Python."""
    lowered = name.lower()
    return f"{lowered}_" if keyword.iskeyword(lowered) else lowered


def bound(
    name: str, names: Sequence[str], required: Sequence[str], values: Sequence[Any], named: Mapping[str, Any]
) -> list[Any]:
    """The values of a call in the order of the parameters, None for those that were left away. Raises TypeError."""
    if len(values) > len(names):
        known = ", ".join(names) or "none"
        raise TypeError(f"{name}() takes at most {len(names)} values ({known}), not {len(values)}")
    found = dict(zip(names, values, strict=False))
    for parameter, value in named.items():
        if parameter not in names:
            hint = near_misses(parameter, [other.upper() for other in names]).lower()
            known = f": it has {', '.join(names) or 'none'}"
            raise TypeError(f"{name}() has no parameter {parameter}{hint or known}")
        if parameter in found:
            raise TypeError(f"{name}() has two values for {parameter}")
        found[parameter] = value
    missing = [parameter for parameter in required if found.get(parameter) is None]
    if missing:
        raise TypeError(f"{name}() needs {' and '.join(missing)}, too")
    return [found.get(parameter) for parameter in names]
