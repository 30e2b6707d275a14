"""Examples of hypothesis strategies by a seed: the same seed gives the same ones in every run and on every machine.

Hypothesis left to itself looks at the program around it and at what it has tried before. That is good for finding
faults, and no good for samples that two people are to have alike. Here a generator of random numbers makes its choices.

Only `ev3proto sample` imports this: it needs hypothesis, which users of ev3proto need not have.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Iterator
from contextlib import contextmanager
from random import Random
from typing import Any, ClassVar, TypeVar

try:
    from hypothesis import HealthCheck, Phase, given, settings
    from hypothesis.internal.conjecture.providers import AVAILABLE_PROVIDERS, PrimitiveProvider
    from hypothesis.strategies import SearchStrategy
except ImportError as error:
    raise ImportError(
        "samples are drawn with hypothesis, which is not installed or too old: pip install -U hypothesis"
    ) from error

T = TypeVar("T")

_ROUND = 100
"""Examples drawn at a time: many need no more memory than few, and the first ones are the same for any number."""

_BACKEND = "ev3proto-seeded"

_SMALL = 1 << 16
"""Where more numbers than these are possible, half of those drawn are small."""

_MOST_CHARACTERS = 64


def samples(strategy: SearchStrategy[T], seed: int) -> Iterator[T]:
    """Examples of a strategy, without end unless it has only a few.

    seed  any whole number
    """
    number = 0
    while found := _drawn(strategy, Random(f"{seed}.{number}")):
        # Whatever the choices are, hypothesis begins with the simplest example of all.
        yield from found[1:] or found
        number += 1


def _drawn(strategy: SearchStrategy[T], random: Random) -> list[T]:
    found: list[T] = []
    with _choices_by(random):

        @settings(
            backend=_BACKEND,
            max_examples=_ROUND + 1,
            database=None,
            deadline=None,
            phases=[Phase.generate],
            suppress_health_check=list(HealthCheck),
        )
        @given(strategy)
        def collect(example: T) -> None:
            found.append(example)

        collect()
    return found


@contextmanager
def _choices_by(random: Random) -> Iterator[None]:
    """Lets hypothesis make its choices by a generator of random numbers."""

    class Provider(_Seeded):
        random_numbers = random

    AVAILABLE_PROVIDERS[_BACKEND] = Provider
    try:
        yield
    finally:
        del AVAILABLE_PROVIDERS[_BACKEND]


class _Seeded(PrimitiveProvider):
    """The choices of which all strategies are made. Their signatures are hypothesis's."""

    random_numbers: ClassVar[Random]

    def draw_boolean(self, p: float = 0.5) -> bool:
        return self.random_numbers.random() < p

    def draw_integer(
        self,
        min_value: int | None = None,
        max_value: int | None = None,
        *,
        weights: dict[int, float] | None = None,
        shrink_towards: int = 0,  # noqa: ARG002
    ) -> int:
        random = self.random_numbers
        low = -(1 << 64) if min_value is None else min_value
        high = 1 << 64 if max_value is None else max_value
        if weights:
            at = random.random()
            for number, weight in weights.items():
                at -= weight
                if at < 0:
                    return number
        if high - low >= _SMALL and random.random() < 0.5:
            size = 1 << random.randrange(1, (high - low).bit_length())
            middle = min(max(0, low), high)
            low, high = max(low, middle - size), min(high, middle + size)
        return random.randint(low, high)

    def draw_float(
        self,
        *,
        min_value: float = -math.inf,
        max_value: float = math.inf,
        allow_nan: bool = True,
        smallest_nonzero_magnitude: float = 5e-324,
    ) -> float:
        random = self.random_numbers
        if random.random() < 0.5:
            number = random.randint(-10000, 10000) / random.choice((1, 4, 10, 100))
        else:
            (number,) = struct.unpack("<f", random.randbytes(4))
        if math.isnan(number):
            number = number if allow_nan else 0.0
        elif 0 < abs(number) < smallest_nonzero_magnitude:
            number = 0.0
        return float(number) if math.isnan(number) else float(min(max(number, min_value), max_value))

    def draw_string(self, intervals: Any, *, min_size: int = 0, max_size: int = _MOST_CHARACTERS) -> str:
        random = self.random_numbers
        size = random.randint(min_size, max(min_size, min(max_size, _MOST_CHARACTERS)))
        return "".join(chr(intervals[random.randrange(len(intervals))]) for _ in range(size))

    def draw_bytes(self, min_size: int = 0, max_size: int = _MOST_CHARACTERS) -> bytes:
        random = self.random_numbers
        return random.randbytes(random.randint(min_size, max(min_size, min(max_size, _MOST_CHARACTERS))))
