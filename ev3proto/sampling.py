"""Examples of hypothesis strategies by a seed: the same seed gives the same ones in every run and on every machine.

Hypothesis by itself looks at the program around it and at what it has tried before. That finds faults, but two people
would not get the same samples. So random bytes make all choices here, through the entry that hypothesis has for
fuzzers: `fuzz_one_input`.

Only `ev3proto sample` imports this: it needs hypothesis, which users of ev3proto need not have.
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
        f"samples are drawn with hypothesis, which is not installed or too old: {install_command('sample')}"
    ) from error

T = TypeVar("T")

BYTES_OF_AN_EXAMPLE = 8192
"""All choices of one example are made by so many random bytes; what needs more is no example."""

MOST_FAILURES = 1000
"""After so many times in a row without an example there is none."""


def samples(strategy: SearchStrategy[T], seed: int) -> Iterator[T]:
    """Examples of a strategy.

    Args:
        strategy: What to draw from.
        seed: Any whole number.

    Yields:
        Examples, without end unless the strategy has none.
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
