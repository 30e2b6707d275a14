"""How long replies took: percentiles of any number of latencies in little memory."""

from __future__ import annotations

import math
from array import array
from bisect import insort
from dataclasses import dataclass
from itertools import accumulate

EXACT = 1000
"""So many latencies are kept, and their percentiles are exact. Beyond, they are counted in buckets."""

ACCURACY = 0.01
"""How far a percentile from buckets can be from the exact one, relative to it."""

SHORTEST = 1e-9
"""Seconds: what is shorter is in one bucket; captures have no shorter times."""

LONGEST = 1e5
"""Seconds: what is longer is in one bucket."""

_GROWTH = math.log((1 + ACCURACY) / (1 - ACCURACY))

_BUCKETS = math.ceil(math.log(LONGEST / SHORTEST) / _GROWTH) + 1


@dataclass(frozen=True, slots=True)
class Percentiles:
    """Latencies in seconds: how many, the shortest, the longest, and below which 50, 90 and 99 of 100 are.

    A percentile is the smallest latency that so many are not above. `exact` says that they are none from buckets.
    """

    count: int
    min: float
    median: float
    p90: float
    p99: float
    max: float
    exact: bool


class Latencies:
    """Takes latencies one by one. Shortest and longest are exact however many there are."""

    __slots__ = ("_buckets", "_first", "_longest", "_shortest", "count")

    def __init__(self) -> None:
        self.count = 0
        self._first = array("d")
        self._buckets = array("L")
        self._shortest = math.inf
        self._longest = -math.inf

    def add(self, seconds: float) -> None:
        """Another one; below 0 where the clock was set back in between."""
        self.count += 1
        self._shortest = min(self._shortest, seconds)
        self._longest = max(self._longest, seconds)
        if self.count <= EXACT:
            insort(self._first, seconds)
        else:
            if not self._buckets:
                self._buckets = array("L", bytes(_BUCKETS * self._buckets.itemsize))
                for early in self._first:
                    self._count(early)
            self._count(seconds)

    def _count(self, seconds: float) -> None:
        # Bucket k holds what is above GROWTH ** (k - 1) and not above GROWTH ** k shortest times.
        number = math.ceil(math.log(seconds / SHORTEST) / _GROWTH) if seconds > SHORTEST else 0
        self._buckets[min(number, _BUCKETS - 1)] += 1

    def percentiles(self) -> Percentiles | None:
        """What is known so far; None where nothing is."""
        if not self.count:
            return None
        median, p90, p99 = (self._percentile(percent) for percent in (50, 90, 99))
        return Percentiles(self.count, self._shortest, median, p90, p99, self._longest, not self._buckets)

    def _percentile(self, percent: int) -> float:
        rank = -(-self.count * percent // 100)
        if not self._buckets:
            return self._first[rank - 1]
        number = next(number for number, below in enumerate(accumulate(self._buckets)) if below >= rank)
        # The value that is as near to one end of the bucket as to the other, relative to both.
        middle = SHORTEST * math.exp(number * _GROWTH) * (1 - ACCURACY) if number else SHORTEST
        return min(max(middle, self._shortest), self._longest)
