"""How fast captures are read, as a ratio to pyshark in the same run; memory and time on long ones.

    pytest benchmarks -k capture

The capture has 100,000 packets of one TCP connection: 50,000 random commands that want a reply, and their replies. Each
is read by a program of its own, from its start to its end, imports included. pyshark is in its fastest mode (EK), which
does not know the protocol by itself; so it is measured with our dissector loaded, and without for comparison.
"""

from __future__ import annotations

import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest
from support.frames import Segment, tcp_capture

from benchmarks.dialogue import dialogue

PACKETS = 100_000
MANY, FEW = 1_000_000, 10_000
LEAST_RATIO = 20
MOST_GROWTH = 60 << 20
MOST_BEND = 1.3

DISSECTOR = Path(__file__).parent.parent / "dissector" / "ev3.lua"

PYSHARK = """
import asyncio, sys, time, warnings
warnings.simplefilter("ignore")
start = time.perf_counter()
import pyshark
parameters = ["-X", "lua_script:" + sys.argv[2]] if len(sys.argv) > 2 else []
capture = pyshark.FileCapture(sys.argv[1], use_ek=True, keep_packets=False, custom_parameters=parameters)
count = sum(1 for packet in capture)
print(count, time.perf_counter() - start)
capture.close()
"""

OURS = r"""
import pathlib, re, sys, time
start = time.perf_counter()
import ev3proto
count = 0
for record in ev3proto.capture.read(sys.argv[1]):
    count += 1
    {look}
most = re.search(r"VmHWM:\s+(\d+)", pathlib.Path("/proc/self/status").read_text())
print(count, time.perf_counter() - start, int(most[1]) * 1024)
"""
LOOKS = {"messages": "record.message", "messages and values": "record.message, record.values"}


def capture(folder: Path, packets: int) -> Path:
    """A capture of so many packets; a long one repeats the dialogue."""
    path = folder / f"{packets}.pcap"
    path.write_bytes(
        tcp_capture(segment for _ in range(max(packets // PACKETS, 1)) for segment in _part(min(packets, PACKETS)))
    )
    return path


@cache
def _part(packets: int) -> list[Segment]:
    return list(dialogue(packets // 2))


def run(program: str, *words: str) -> list[float]:
    """What a program prints, as numbers."""
    done = subprocess.run([sys.executable, "-c", program, *words], check=True, capture_output=True, text=True)
    return [float(word) for word in done.stdout.split()]


def test_capture_ratios(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Prints packets per second and the ratios."""
    path = str(capture(tmp_path, PACKETS))
    count, seconds = run(PYSHARK, path, str(DISSECTOR))
    assert count == PACKETS
    theirs = count / seconds
    count, seconds = run(PYSHARK, path)
    bare = count / seconds
    ratios = {}
    with capsys.disabled():
        print(f"\npyshark, EK: {theirs:,.0f} packets/s with the dissector, {bare:,.0f} without", end="")
        for what, look in LOOKS.items():
            count, seconds, _ = run(OURS.format(look=look), path)
            assert count == PACKETS
            own = count / seconds
            ratios[what] = own / theirs
            print(f"\nev3proto, {what}: {own:,.0f} packets/s, {own / theirs:.1f} x and {own / bare:.1f} x", end="")
    assert ratios["messages"] >= LEAST_RATIO


def test_capture_memory_and_time(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A hundred times as many packets take a hundred times as long, and hardly more memory."""
    program = OURS.format(look=LOOKS["messages and values"])
    few, short, small = run(program, str(capture(tmp_path, FEW)))
    middle, seconds, _ = run(program, str(capture(tmp_path, PACKETS)))
    many, long, big = run(program, str(capture(tmp_path, MANY)))
    assert (few, middle, many) == (FEW, PACKETS, MANY)
    bend = (long / many) / (seconds / middle)
    with capsys.disabled():
        print(f"\n{MANY:,} packets: {(big - small) / (1 << 20):.0f} MiB more than {FEW:,}, ", end="")
        print(f"{bend:.2f} x the time a packet of {PACKETS:,}", end="")
    assert short < seconds < long
    assert big - small <= MOST_GROWTH
    assert bend <= MOST_BEND
