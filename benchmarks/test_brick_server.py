"""How fast the virtual brick answers over loopback, server and client on one core: `pytest benchmarks -k server`.

The lines above the table of pytest-benchmark have the results: commands per second of one client, each reading
one value; of fifty clients at once, with every reply compared; a file of 1 MB in both directions; how long an honest
client waits beside 180 idle ones and twelve that send random frames, or four that connect for each slow command.
"""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from random import Random
from typing import Any

import pytest
from pytest_benchmark.fixture import BenchmarkFixture
from support.server import Client, command, download, upload

COMMANDS = 3000
CLIENTS = 50

VOLUME = command("DATA8 volume\nINFO(GET_VOLUME, volume)")

IDLE = 180
ANSWERS = 600
"""Answers to an honest client, one every 0.1 s."""


@pytest.fixture
def process(tmp_path: Path) -> Iterator[subprocess.Popen[str]]:
    """A brick in another process, on the same core as this one."""
    cores = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {min(cores)})
    words = ["brick", "--port", "0", "--no-beacon", "--quiet", "--clients", "250", "--root", str(tmp_path)]
    process = subprocess.Popen([sys.executable, "-m", "ev3proto", *words], stdout=subprocess.PIPE, text=True)
    try:
        assert process.stdout is not None
        yield process
    finally:
        process.terminate()
        process.communicate()
        os.sched_setaffinity(0, cores)


@pytest.fixture
def port(process: subprocess.Popen[str]) -> int:
    """The port of the brick."""
    assert process.stdout is not None
    return int(process.stdout.readline().rpartition(":")[2])


def _best(benchmark: BenchmarkFixture, work: Callable[[], None]) -> float:
    """Measures some work; returns the seconds of the fastest round."""
    times = []

    def timed() -> None:
        begin = time.perf_counter()
        work()
        times.append(time.perf_counter() - begin)

    measured: Any = benchmark
    measured.pedantic(timed, rounds=3, warmup_rounds=1)
    return min(times)


def test_one_client(port: int, benchmark: BenchmarkFixture, capsys: pytest.CaptureFixture[str]) -> None:
    """Each command reads a value; the next one is sent after its reply."""
    benchmark.group = "virtual brick over loopback"
    frame = command("DATA8 value\nINPUT_READ(0, 0, TYPE_KEEP, MODE_KEEP, value)")
    with Client(port) as client:
        expected = client.ask(frame)

        def ask() -> None:
            for _ in range(COMMANDS):
                assert client.ask(frame) == expected

        best = _best(benchmark, ask)
    with capsys.disabled():
        print(f"\none client: {COMMANDS / best:,.0f} commands a second")


def test_fifty_clients(port: int, benchmark: BenchmarkFixture, capsys: pytest.CaptureFixture[str]) -> None:
    """Every client always has a command in flight, and each gets its own replies."""
    benchmark.group = "virtual brick over loopback"
    clients = [Client(port) for _ in range(CLIENTS)]
    rounds = COMMANDS // CLIENTS
    frames = [
        [command(f"DATA8 value\nMOVE8_8({number}, value)", turn * CLIENTS + number) for number in range(CLIENTS)]
        for turn in range(rounds)
    ]

    def ask() -> None:
        for turn, sent in enumerate(frames):
            for client, frame in zip(clients, sent, strict=True):
                client.send(frame)
            for number, client in enumerate(clients):
                counter = (turn * CLIENTS + number).to_bytes(2, "little")
                assert client.reply() == b"\4\0" + counter + b"\2" + bytes((number,))

    best = _best(benchmark, ask)
    for client in clients:
        client.socket.close()
    with capsys.disabled():
        print(f"\n{CLIENTS} clients: {COMMANDS / best:,.0f} commands a second")


def test_file(port: int, benchmark: BenchmarkFixture, capsys: pytest.CaptureFixture[str]) -> None:
    """A file of 1 MB, intact in both directions."""
    benchmark.group = "virtual brick over loopback"
    data = Random(1).randbytes(1_000_000)
    times = []
    with Client(port) as client:

        def move() -> None:
            begin = time.perf_counter()
            assert upload(client, b"../prjs/big.bin", data) == 8
            middle = time.perf_counter()
            assert download(client, b"../prjs/big.bin") == data
            times.append((middle - begin, time.perf_counter() - middle))

        _best(benchmark, move)
    there, back = (min(column) for column in zip(*times, strict=True))
    with capsys.disabled():
        print(f"\n1 MB: to the brick {there:.2f} s, from it {back:.2f} s")


def _loaded(process: subprocess.Popen[str], port: int, attack: str, answers: int) -> tuple[list[float], list[float]]:
    """Returns the seconds by the clock, and of the brick's CPU time, in which an honest client gets its answers."""
    clock = ~process.pid << 3 | 2  # of the CPU time of a process, on Linux
    words = [sys.executable, "-m", "benchmarks.load", attack, str(port)]
    elapsed, spent = [], []
    with contextlib.ExitStack() as stack:
        attacker = stack.enter_context(subprocess.Popen(words, env={**os.environ, "PYTHONPATH": "tests"}))
        stack.callback(attacker.terminate)
        honest, *_ = [stack.enter_context(Client(port)) for _ in range(IDLE)]
        for _ in range(answers):
            begin, begun = time.monotonic(), time.clock_gettime(clock)
            honest.ask(VOLUME)
            elapsed.append(time.monotonic() - begin)
            spent.append(time.clock_gettime(clock) - begun)
            time.sleep(max(0.0, 0.1 - elapsed[-1]))
    return sorted(elapsed), sorted(spent)


def test_random_clients(process: subprocess.Popen[str], port: int, capsys: pytest.CaptureFixture[str]) -> None:
    """Twelve that send random frames."""
    elapsed, spent = _loaded(process, port, "random", ANSWERS)
    with capsys.disabled():
        print(f"\nrandom clients: {spent[-1]:.3f} s of CPU time at most, {elapsed[-1]:.3f} s by the clock")
    assert spent[-1 - ANSWERS // 1000] < 0.3
    assert spent[-1] < 1.0


def test_slow_clients(process: subprocess.Popen[str], port: int, capsys: pytest.CaptureFixture[str]) -> None:
    """Four that connect for each command of half a second."""
    elapsed, _ = _loaded(process, port, "slow", 30)
    with capsys.disabled():
        print(f"\nslow clients: {elapsed[len(elapsed) // 2]:.2f} s by the clock, {elapsed[-1]:.2f} s at most")
    assert elapsed[-1] < 2.5
