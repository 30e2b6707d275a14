"""The digests by which hypothesis tells tests apart, computed once for all functions of the same `def`."""

from __future__ import annotations

from collections.abc import Callable
from types import CodeType, FunctionType
from typing import Any


def digest_of(reckoned: Callable[[Any], bytes]) -> Callable[[Any], bytes]:
    """Returns the same function, but reads the source of each `def` once: reading takes longer than most such tests."""
    known: dict[tuple[CodeType, bytes | None], bytes] = {}

    def digest(function: Any) -> bytes:
        # The source of an inner function is that of the outer one.
        if not isinstance(function, FunctionType) or hasattr(function, "__wrapped__"):
            return reckoned(function)
        key = function.__code__, getattr(function, "_hypothesis_internal_add_digest", None)
        if key not in known:
            known[key] = reckoned(function)
        return known[key]

    return digest
