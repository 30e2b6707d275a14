"""Lines of repeated units, together or as separate lines: eight times the text takes about eight times the time."""

from __future__ import annotations

import time

from ev3proto.text.paste import read_text

_SHORT = 1 << 11
_FACTOR = 8
_MOST_GROWTH = 16
"""Linear work takes 8 times as long, quadratic work 64 times."""
_SEPARATORS = (" ", " x ", "\n")
_LEAST = 0.003
"""Measurements below these seconds are ignored."""
_ROUNDS = 3


def one_input(data: bytes) -> None:
    """Takes a unit."""
    unit = data.decode("utf-8", "replace")[:_SHORT]
    unit += _SEPARATORS[len(unit) % len(_SEPARATORS)]
    short = unit * (_SHORT // len(unit) + 1)
    # From some length on, another reading may be likelier, which takes longer: the next step is linear again.
    found = [_growth(short)]
    while found[-1] > _MOST_GROWTH and len(found) < _ROUNDS:
        found.append(_growth(short * _FACTOR))
    assert min(found) <= _MOST_GROWTH, f"{_FACTOR} times the text takes {min(found):.1f} times as long"


def _growth(text: str) -> float:
    short = min(_seconds(text) for _ in range(2))
    long = _seconds(text * _FACTOR)
    return long / max(short, _LEAST)


def _seconds(text: str) -> float:
    lines = text.splitlines(keepends=True)
    begin = time.thread_time()
    for _ in read_text(lines):
        pass
    return time.thread_time() - begin
