"""Reproducible examples of hypothesis strategies: a seed gives the same examples in every run on every machine.

Hypothesis takes the surrounding program and earlier examples into account. That finds faults, but two users
would not get the same samples. So random bytes make all choices here, through hypothesis's entry for
fuzzers, `fuzz_one_input`.

Only `ev3proto sample` imports this, since it needs hypothesis, an optional package.
"""

from __future__ import annotations

from collections.abc import Iterator
from random import Random
from typing import Any, TypeVar

try:
    from hypothesis import HealthCheck, given, settings
    from hypothesis.strategies import SearchStrategy
except ImportError as error:
    from ev3proto.extras import install_command

    raise ImportError(
        f"samples need hypothesis, which is not installed or too old: {install_command('sample')}"
    ) from error

T = TypeVar("T")

BYTES_OF_AN_EXAMPLE = 8192
"""Number of random bytes for the choices of one example; a draw that needs more fails."""

MOST_FAILURES = 1000
"""Give up after this many consecutive failed draws."""


def samples(strategy: SearchStrategy[T], seed: int) -> Iterator[T]:
    """Yields examples of a strategy.

    Args:
        strategy: The strategy.
        seed: Any whole number.

    Yields:
        Examples, endlessly unless the strategy has none.
    """
    drawn: list[T] = []

    @settings(database=None, deadline=None, suppress_health_check=list(HealthCheck))
    @given(strategy)
    def collect(example: T) -> None:
        drawn.append(example)

    test: Any = collect
    random = Random(seed)
    failures = 0
    while failures < MOST_FAILURES:
        test.hypothesis.fuzz_one_input(random.randbytes(BYTES_OF_AN_EXAMPLE))
        failures = 0 if drawn else failures + 1
        yield from drawn
        drawn.clear()
