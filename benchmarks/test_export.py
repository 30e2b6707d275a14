"""How many frames per second become a capture: `pytest benchmarks -k export`.

`ev3proto export pcapng` reads lines of hex, or a capture, from the start of the program to its end. Times are
CPU times.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from support.frames import Segment, tcp_capture

from benchmarks.commands import commands

FRAMES = 50_000
LEAST = 5_000
"""Frames per second below which something is wrong."""


def _rate(source: Path, target: Path) -> float:
    """Frames per second in the better of two runs."""
    env = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    taken = []
    for _ in range(2):
        before = os.times()
        command = [sys.executable, "-m", "ev3proto", "export", "pcapng", "-o", str(target), str(source)]
        subprocess.run(command, check=True, env=env)
        taken.append(sum(os.times()[2:4]) - sum(before[2:4]))
    return FRAMES / min(taken)


def test_export_rates(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Prints the rates."""
    frames = list(commands(FRAMES))
    sources = {"lines of hex": tmp_path / "frames.txt", "a capture": tmp_path / "frames.pcap"}
    sources["lines of hex"].write_text("".join(f"{frame.hex()}\n" for frame in frames))
    sources["a capture"].write_bytes(tcp_capture(Segment(True, frame) for frame in frames))
    for name, source in sources.items():
        rate = _rate(source, tmp_path / "out.pcapng")
        with capsys.disabled():
            print(f"\nexport pcapng of {name}: {rate:,.0f} frames/s", end="")
        assert rate >= LEAST
