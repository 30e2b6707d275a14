"""CPU time that work takes, measured so that a slow or busy machine does not turn a test red.

Only the time of the calling thread counts, and Python's garbage collector does not run meanwhile: it looks through the
objects of all tests, at moments that have nothing to do with the work. What a measurement is compared with is measured
right beside it: the same work on a smaller input, or a loop of a known cost. Both are then slowed down alike. A
measurement that is over its limit is repeated, and the best one counts: chance makes work slower, never faster.
"""

from __future__ import annotations

import gc
import time
from collections.abc import Callable

FACTOR = 8
"""How much longer the long input of a test of growth is than the short one."""

MOST_GROWTH = 2.2**3
"""Times as long that work may take on an input FACTOR times as long: twice the input, 2.2 times the time.

Linear work takes 8 times as long, quadratic work 64 times."""

_LEAST = 0.012
"""Seconds that the work on the short input takes at least."""
_ROUNDS = 12
_ROUNDS_OF_A_MILLISECOND = 5_700

Work = Callable[[], object]


def seconds(work: Work) -> float:
    """The CPU time, in seconds, that some work takes in this thread."""
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
    """How many times as long the long work takes as the short one, which is done FACTOR times, half of them before it.

    So both are measured for the same time, and whatever else the machine does is as likely to hit the one as the other.
    """
    half = FACTOR // 2
    before = sum(seconds(short) for _ in range(half))
    whole = seconds(long)
    after = sum(seconds(short) for _ in range(half))
    return FACTOR * whole / (before + after)


def assert_linear(make: Callable[[int], Work], size: int, most_size: int | None = None) -> None:
    """Fails where work that is FACTOR times as much takes more than MOST_GROWTH times as long.

    Args:
        make: Gives the work for an input of a size.
        size: The size of the short input. It is doubled until the work takes long enough for what is the same with any
            input not to count.
        most_size: A size beyond which it is not doubled.
    """
    short = make(size)
    short()  # what is made once in a process
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
    """What some work takes, in milliseconds of the machine that the tests were written on.

    A millisecond there is some rounds of a loop. It is measured beside the work, so the result is about the same on a
    slower machine.

    Args:
        work: What is done, up to some times.
        most: What it may take. Once it has taken no more than that it is not repeated.
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
