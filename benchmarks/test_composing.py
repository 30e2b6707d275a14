"""How long composing a command takes, as a ratio to a plain builder in the same run: `pytest benchmarks -k compos`.

The plain builder is what you would write for this one command: it knows the bytes and checks nothing.
"""

from __future__ import annotations

import struct
import time
from collections.abc import Callable
from random import Random
from statistics import median

import pytest
from pytest_benchmark.fixture import BenchmarkFixture

import ev3proto
from ev3proto import ops

Tone = tuple[int, int, int]

ROUNDS = 15


def _constant(value: int) -> bytes:
    if -32 <= value < 32:
        return bytes((value & 63,))
    if -128 < value < 128:
        return b"\x81" + struct.pack("<b", value)
    if -32768 < value < 32768:
        return b"\x82" + struct.pack("<h", value)
    return b"\x83" + struct.pack("<i", value)


def plain(volume: int, frequency: int, duration: int) -> bytes:
    body = b"".join((b"\x94\x01", _constant(volume), _constant(frequency), _constant(duration)))
    return struct.pack("<HHBH", len(body) + 5, 42, 0x80, 0) + body


def direct(volume: int, frequency: int, duration: int) -> bytes:
    tone = ev3proto.operation("SOUND.TONE", volume, frequency, duration)
    return ev3proto.direct_command(tone, counter=42).build()


def one(volume: int, frequency: int, duration: int) -> bytes:
    return ev3proto.command(ops.sound.tone(volume, frequency, duration), counter=42).build()


def two(volume: int, frequency: int, duration: int) -> bytes:
    return ev3proto.command(ops.sound.tone(volume, frequency, duration), ops.ui_read.get_vbatt(), counter=42).build()


WORKS: dict[str, tuple[Callable[[int, int, int], bytes], float]] = {
    "plain": (plain, 1),
    "direct_command(operation(...))": (direct, 10),
    "command of an operation": (one, 10),
    "command with an output": (two, 20),
}
"""Each builder, and its limit as a multiple of the plain builder's time."""


@pytest.mark.parametrize("name", WORKS)
def test_composing(benchmark: BenchmarkFixture, name: str) -> None:
    benchmark.group = "1,000 commands composed"
    work, _ = WORKS[name]
    calls = _same()
    assert len(benchmark(lambda: [work(*values) for values in calls])) == len(calls)


def _same() -> list[Tone]:
    return [(1, 440, 1000)] * 1000


def _others(random: Random) -> list[Tone]:
    """Values that hardly ever repeat."""
    return [(random.randint(0, 100), random.randint(250, 10000), random.randint(0, 32767)) for _ in range(1000)]


def _ratios(rounds: Callable[[], list[Tone]]) -> dict[str, float]:
    """Rounds alternate, the median round counts. Times are CPU times, so other programs do not matter."""
    times: dict[str, list[float]] = {name: [] for name in WORKS}
    for _ in range(ROUNDS):
        for name, (work, _) in WORKS.items():
            calls = rounds()
            start = time.process_time()
            for values in calls:
                work(*values)
            times[name].append(time.process_time() - start)
    base = median(times["plain"])
    return {name: median(spent) / base for name, spent in times.items()}


def test_composing_ratios(capsys: pytest.CaptureFixture[str]) -> None:
    """Prints the ratios that the README names."""
    assert plain(1, 440, 1000) == direct(1, 440, 1000) == one(1, 440, 1000)
    random = Random(11)
    assert all(plain(*values) == one(*values) for values in _others(random))
    same, others = _ratios(_same), _ratios(lambda: _others(random))
    with capsys.disabled():
        print()
        for name in list(WORKS)[1:]:
            print(f"{name:32} {same[name]:4.1f} x the plain builder's time, {others[name]:4.1f} x with new values")
    assert all(same[name] <= limit for name, (_, limit) in WORKS.items())
