"""Latencies of replies: percentiles of any number of them in little memory."""

from __future__ import annotations

import math
from array import array
from bisect import insort
from collections import Counter
from dataclasses import dataclass

EXACT = 1000
"""Up to this number of latencies, percentiles are exact. More are counted in buckets."""

ACCURACY = 0.01
"""Maximum relative error of a percentile from buckets."""

SHORTEST = 1e-9
"""Seconds: the first bucket has all latencies up to this; captures have no shorter times."""

LONGEST = 1e5
"""Seconds: the last bucket has all longer latencies."""

_GROWTH = math.log((1 + ACCURACY) / (1 - ACCURACY))

_LAST_BUCKET = math.ceil(math.log(LONGEST / SHORTEST) / _GROWTH)


@dataclass(frozen=True, slots=True)
class Percentiles:
    """Latencies in seconds: how many, the shortest, the longest, and below which 50, 90 and 99 of 100 are.

    A percentile is the smallest latency that this share of all does not exceed. `exact`: none is from buckets.
    """

    count: int
    min: float
    median: float
    p90: float
    p99: float
    max: float
    exact: bool


class Latencies:
    """Takes latencies one by one. The shortest and the longest are always exact."""

    __slots__ = ("_buckets", "_first", "_longest", "_shortest", "count")

    def __init__(self) -> None:
        self.count = 0
        self._first = array("d")
        self._buckets: Counter[int] = Counter()
        self._shortest = math.inf
        self._longest = -math.inf

    def add(self, seconds: float) -> None:
        """Adds a latency; it is negative if the clock was set back in between."""
        self.count += 1
        self._shortest = min(self._shortest, seconds)
        self._longest = max(self._longest, seconds)
        if self.count <= EXACT:
            insort(self._first, seconds)
        else:
            self._buckets.update(map(_bucket, (*self._first, seconds)))
            del self._first[:]

    def percentiles(self) -> Percentiles | None:
        """Returns the percentiles so far; None without latencies."""
        if not self.count:
            return None
        median, p90, p99 = (self._percentile(percent) for percent in (50, 90, 99))
        return Percentiles(self.count, self._shortest, median, p90, p99, self._longest, not self._buckets)

    def _percentile(self, percent: int) -> float:
        rank = -(-self.count * percent // 100)
        if not self._buckets:
            return self._first[rank - 1]
        number = below = 0
        for number in sorted(self._buckets):
            below += self._buckets[number]
            if below >= rank:
                break
        # The value with the same relative distance to both ends of the bucket.
        middle = SHORTEST * math.exp(number * _GROWTH) * (1 - ACCURACY) if number else SHORTEST
        return min(max(middle, self._shortest), self._longest)


def _bucket(seconds: float) -> int:
    """Returns the bucket of a latency: k has those above GROWTH ** (k - 1) shortest times, up to GROWTH ** k."""
    number = math.ceil(math.log(seconds / SHORTEST) / _GROWTH) if seconds > SHORTEST else 0
    return min(number, _LAST_BUCKET)
