"""What hypothesis tells tests apart by, worked out once for all functions that the same `def` makes."""

from __future__ import annotations

from collections.abc import Callable
from types import CodeType, FunctionType
from typing import Any


def digest_of(reckoned: Callable[[Any], bytes]) -> Callable[[Any], bytes]:
    """The same function, which reads the source of each `def` once: that takes longer than most of such tests."""
    known: dict[tuple[CodeType, bytes | None], bytes] = {}

    def digest(function: Any) -> bytes:
        # Where one function stands around another, the source is that of the other.
        if not isinstance(function, FunctionType) or hasattr(function, "__wrapped__"):
            return reckoned(function)
        key = function.__code__, getattr(function, "_hypothesis_internal_add_digest", None)
        if key not in known:
            known[key] = reckoned(function)
        return known[key]

    return digest
