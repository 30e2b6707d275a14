"""The CPU time of work, measured so that a slow or busy machine does not make a test fail.

Only the time of the calling thread counts, and Python's garbage collector is off: it would visit the
objects of all tests, at times that have nothing to do with the work. A measurement is compared with one made
right next to it: the same work on a smaller input, or a loop of known cost. A slow machine slows down both. A
measurement over its limit is repeated, and the best one counts: chance makes work slower, never faster.
"""

from __future__ import annotations

import gc
import time
from collections.abc import Callable

FACTOR = 8
"""The size of the long input of a test of growth, as a multiple of the short one."""

MOST_GROWTH = 2.2**3
"""The limit of the ratio of the times for the long and the short input: 2.2 times the time for twice the input.

Linear work takes 8 times as long, quadratic work 64 times."""

_LEAST = 0.012
"""The minimum seconds of the work on the short input."""
_ROUNDS = 12
_ROUNDS_OF_A_MILLISECOND = 5_700

Work = Callable[[], object]


def seconds(work: Work) -> float:
    """Returns the CPU time, in seconds, of some work in this thread."""
    collecting = gc.isenabled()
    gc.disable()
    try:
        begin = time.thread_time()
        work()
        return time.thread_time() - begin
    finally:
        if collecting:
            gc.enable()


def growth(short: Work, long: Work) -> float:
    """Returns the ratio of the times of long and short work. The short work runs FACTOR times, half of them first.

    So both are measured for the same time, and disturbances hit both alike.
    """
    half = FACTOR // 2
    before = sum(seconds(short) for _ in range(half))
    whole = seconds(long)
    after = sum(seconds(short) for _ in range(half))
    return FACTOR * whole / (before + after)


def assert_linear(make: Callable[[int], Work], size: int, most_size: int | None = None) -> None:
    """Fails if FACTOR times the input takes more than MOST_GROWTH times as long.

    Args:
        make: Returns the work for an input of a size.
        size: The size of the short input. It is doubled until the work takes so long that constant costs do not
            matter.
        most_size: The largest size.
    """
    short = make(size)
    short()  # what a process computes only once
    while seconds(short) < _LEAST and (most_size is None or 2 * size <= most_size):
        size *= 2
        short = make(size)
    long = make(FACTOR * size)
    found: list[float] = []
    while len(found) < _ROUNDS:
        found.append(growth(short, long))
        if found[-1] <= MOST_GROWTH:
            return
    best = min(found)
    raise AssertionError(f"{FACTOR} x {size} takes {best:.1f} times as long as {size}, not at most {MOST_GROWTH:.1f}")


def milliseconds(work: Work, most: float) -> float:
    """Returns the time of some work, in milliseconds of the machine on which the tests were written.

    A millisecond there is a number of rounds of a loop, which is measured next to the work. So the result is about the
    same on a slower machine.

    Args:
        work: The work, which may run several times.
        most: The limit. Work that has kept it is not repeated.
    """
    best = float("inf")
    for _ in range(_ROUNDS):
        best = min(best, seconds(work) / seconds(_millisecond))
        if best <= most:
            break
    return best


def _millisecond() -> None:
    texts = {}
    for number in range(_ROUNDS_OF_A_MILLISECOND):
        texts[number & 0xFF] = f"{number} {number}"
