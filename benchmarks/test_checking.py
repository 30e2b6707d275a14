"""How many frames per second are checked, with verdict and findings: `pytest benchmarks -k checking`.

The frames are random: almost every value has a finding, and writing those takes half of the time.
"""

from __future__ import annotations

import time
from collections.abc import Callable

import pytest
from pytest_benchmark.fixture import BenchmarkFixture

import ev3proto
from benchmarks.commands import commands
from ev3proto.checking.verdict import verdict

FRAMES = list(commands(2000))
TRIAD = bytes.fromhex(
    "2C002A0080000094010182060182F4019694010182" + "4A0182F4019694010182880182F40196" + "940102820B0282E803"
)
LEAST = 5_000
"""Frames per second, on one core."""


def test_verdict(benchmark: BenchmarkFixture) -> None:
    benchmark.group = "2,000 commands"
    assert len(benchmark(lambda: [verdict(frame) for frame in FRAMES])) == len(FRAMES)


def test_check(benchmark: BenchmarkFixture) -> None:
    benchmark.group = "2,000 commands"
    assert len(benchmark(lambda: [ev3proto.check(frame) for frame in FRAMES])) == len(FRAMES)


def _rate(work: Callable[[bytes], object], frames: list[bytes]) -> float:
    """Frames per second in the best round."""
    best = 0.0
    for _ in range(7):
        start = time.perf_counter()
        for frame in frames:
            work(frame)
        best = max(best, len(frames) / (time.perf_counter() - start))
    return best


def test_checking_rates(capsys: pytest.CaptureFixture[str]) -> None:
    """Prints the rates that the README names."""
    findings = sum(len(ev3proto.check(frame).findings) for frame in FRAMES) / len(FRAMES)
    random, right = _rate(ev3proto.check, FRAMES), _rate(ev3proto.check, [TRIAD] * 2000)
    with capsys.disabled():
        print(f"\nverdict  {_rate(verdict, FRAMES):,.0f} frames/s")
        print(f"check    {random:,.0f} frames/s with {findings:.1f} findings each")
        print(f"         {right:,.0f} frames/s of seven operations with none")
    assert ev3proto.check(TRIAD).findings == ()
    assert random >= LEAST
