"""How fast the codec is, as a ratio to a plain decoder in the same run: `pytest benchmarks`.

The benchmarks use the same 2,000 random direct commands. The table of pytest-benchmark has the times,
the lines above it the ratios.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Callable
from statistics import median

import pytest
from pytest_benchmark.fixture import BenchmarkFixture

import ev3proto
from benchmarks import plain
from benchmarks.commands import commands
from ev3proto.schema import FRAME

FRAMES = list(commands(2000))


def test_plain(benchmark: BenchmarkFixture) -> None:
    benchmark.group = "2,000 commands"
    found = benchmark(lambda: [plain.decode(frame) for frame in FRAMES])
    assert len(found) == len(FRAMES)


def test_parse(benchmark: BenchmarkFixture) -> None:
    """Parses frames and reads the value of every argument."""
    benchmark.group = "2,000 commands"
    found = benchmark(lambda: [_values(frame) for frame in FRAMES])
    assert len(found) == len(FRAMES)


def _values(frame: bytes) -> list[list[object]]:
    message = ev3proto.parse(frame)
    assert isinstance(message, ev3proto.DirectCommand)
    return [[argument.value for argument in operation.arguments] for operation in message.operations]


def test_build(benchmark: BenchmarkFixture) -> None:
    benchmark.group = "2,000 commands"
    messages = [ev3proto.parse(frame) for frame in FRAMES]
    assert benchmark(lambda: [message.build() for message in messages]) == FRAMES


def test_stream(benchmark: BenchmarkFixture) -> None:
    """The same frames as one stream in chunks of 1,000 bytes."""
    benchmark.group = "2,000 commands"
    stream = b"".join(FRAMES)
    assert benchmark(lambda: _counted(stream)) == len(FRAMES)


def _counted(stream: bytes) -> int:
    decoder = ev3proto.Decoder()
    return sum(1 for at in range(0, len(stream), 1000) for _ in decoder.feed(stream[at : at + 1000]))


def test_ratios(capsys: pytest.CaptureFixture[str]) -> None:
    """Prints the ratios that the README names: rounds alternate, the median round counts."""
    messages = [ev3proto.parse(frame) for frame in FRAMES]
    stream = b"".join(FRAMES)
    works: dict[str, Callable[[], object]] = {
        "plain": lambda: [plain.decode(frame) for frame in FRAMES],
        "parse": lambda: [_values(frame) for frame in FRAMES],
        "stream": lambda: _counted(stream),
        "build": lambda: [message.build() for message in messages],
        "declaration": lambda: [FRAME.parse(frame) for frame in FRAMES[:: len(FRAMES) // 100]],
    }
    times: dict[str, list[float]] = {name: [] for name in works}
    for _ in range(11):
        for name, work in works.items():
            start = time.perf_counter()
            work()
            times[name].append(time.perf_counter() - start)
    base = median(times["plain"])
    codes = ("import construct", "import ev3proto; ev3proto.parse(bytes.fromhex('0600000080000001'))")
    construct, own = (_start(code) for code in codes)
    with capsys.disabled():
        print(f"\nparse  {median(times['parse']) / base:.2f} x the plain decoder's time")
        print(f"stream cut into messages without reading them  {median(times['stream']) / base:.2f} x")
        print(f"build  {median(times['build']) / base:.2f} x the plain decoder's time")
        declared = median(times["declaration"]) * len(FRAMES) / 100
        print(f"FRAME.parse of Construct  {declared / median(times['parse']):.0f} x the time of parse")
        print(f"import and first frame  {1000 * (own - construct):.0f} ms more than importing construct alone")


def _start(code: str) -> float:
    """Seconds of a Python process that runs this code, with compiled modules kept as on a user's machine."""
    env = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    times = []
    for _ in range(9):
        start = time.perf_counter()
        subprocess.run([sys.executable, "-c", code], check=True, env=env)
        times.append(time.perf_counter() - start)
    return median(times)
