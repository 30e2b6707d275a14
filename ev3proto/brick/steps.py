"""Long work in steps: a generator yields wherever it may pause, so that others are served meanwhile."""

from __future__ import annotations

from collections.abc import Generator
from typing import TypeAlias, TypeVar

T = TypeVar("T")

Steps: TypeAlias = Generator[None, None, T]
"""Yields at least every few milliseconds, and returns its result."""


def finish(steps: Steps[T]) -> T:
    """Does all steps at once. Returns the result."""
    while True:
        try:
            next(steps)
        except StopIteration as end:
            result: T = end.value
            return result
