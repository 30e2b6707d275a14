"""How fast captures are read, as a ratio to pyshark in the same run; memory and time on long ones.

    pytest benchmarks -k capture

Two captures of one TCP connection are read: 30,000 packets with a random command each, and 30,000 packets of a
dialogue, in which every command gets its reply. Each is read by its own program, from start to end,
with imports. The result is the CPU time of all its processes, for ev3proto the best of three runs. pyshark is in its
fastest mode (EK) and loads our dissector, as it does not know the protocol itself: the version of `OLD`, if this is
a git repository that has it, so that a faster dissector does not change the goal.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable, Iterable
from functools import cache
from pathlib import Path

import pytest
from support.frames import Segment, tcp_capture

from benchmarks.commands import commands
from benchmarks.dialogue import dialogue

COMPARED = 30_000
PACKETS = 100_000
MANY, FEW = 1_000_000, 10_000
LEAST_RATIO = 16
MOST_GROWTH = 60 << 20
MOST_BEND = 1.3

ROOT = Path(__file__).parent.parent
OLD = "9d4ed06:dissector/ev3.lua"

PYSHARK = """
import sys, warnings
warnings.simplefilter("ignore")
import pyshark
parameters = ["-X", "lua_script:" + sys.argv[2]]
capture = pyshark.FileCapture(sys.argv[1], use_ek=True, keep_packets=False, custom_parameters=parameters)
print(sum(1 for packet in capture))
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
COUNTED = """
import sys
import ev3proto
count = 0
for record in ev3proto.capture.read(sys.argv[1]):
    count += 1
    {look}
print(count)
"""
LOOKS = {"messages": "record.message", "messages and values": "record.message, record.values"}


def capture(folder: Path, packets: int) -> Path:
    """A capture with this number of packets; a long one repeats the dialogue."""
    path = folder / f"{packets}.pcap"
    path.write_bytes(
        tcp_capture(segment for _ in range(max(packets // PACKETS, 1)) for segment in _part(min(packets, PACKETS)))
    )
    return path


@cache
def _part(packets: int) -> list[Segment]:
    return list(dialogue(packets // 2))


def run(program: str, *words: str) -> list[float]:
    """Returns the numbers that a program prints."""
    done = subprocess.run([sys.executable, "-c", program, *words], check=True, capture_output=True, text=True)
    return [float(word) for word in done.stdout.split()]


def processor_seconds(program: str, *words: str) -> tuple[float, float]:
    """Returns the output of a program, and the CPU time of it and its child processes."""
    before = os.times()
    (count,) = run(program, *words)
    after = os.times()
    spent = after.children_user + after.children_system - before.children_user - before.children_system
    return count, spent


def dissector(folder: Path) -> Path:
    """The dissector for pyshark's tshark."""
    found = subprocess.run(["git", "show", OLD], cwd=ROOT, capture_output=True, check=False)
    if found.returncode:
        return ROOT / "dissector" / "ev3.lua"
    path = folder / "ev3.lua"
    path.write_bytes(found.stdout)
    return path


@pytest.mark.parametrize(
    ("what", "segments"),
    [
        ("commands", lambda: [Segment(True, frame) for frame in commands(COMPARED)]),
        ("a dialogue", lambda: dialogue(COMPARED // 2)),
    ],
    ids=["commands", "dialogue"],
)
def test_capture_ratios(
    what: str, segments: Callable[[], Iterable[Segment]], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Prints packets per second of CPU time, and the ratios."""
    path = tmp_path / "compared.pcap"
    path.write_bytes(tcp_capture(segments()))
    count, theirs = processor_seconds(PYSHARK, str(path), str(dissector(tmp_path)))
    assert count == COMPARED
    ratios = {}
    with capsys.disabled():
        print(f"\n{what}: pyshark, EK: {count / theirs:,.0f} packets for each second of CPU time", end="")
        for looked_at, look in LOOKS.items():
            found = [processor_seconds(COUNTED.format(look=look), str(path)) for _ in range(3)]
            # The first random commands may be too strange to claim the connection.
            assert all(COMPARED - 10 < count <= COMPARED for count, _ in found)
            ours = min(seconds for _, seconds in found)
            ratios[looked_at] = theirs / ours
            print(f"\n{what}: ev3proto, {looked_at}: {count / ours:,.0f}, {theirs / ours:.1f} x", end="")
    assert ratios["messages"] >= LEAST_RATIO


def test_a_capture_out_of_step(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Prints the rate for packets of 98 bytes with twelve possible starts of a frame each, none of which is one."""
    path = tmp_path / "lost.pcap"
    begin = bytes.fromhex("0e002a0080000094010182b80182e803")
    lost = b"\xff\xff" + bytes.fromhex("1400000080000082") * 12
    path.write_bytes(tcp_capture(Segment(True, data) for data in [begin, *[lost] * COMPARED]))
    _, spent = processor_seconds(COUNTED.format(look="record.message"), str(path))
    with capsys.disabled():
        print(f"\nout of step: {COMPARED / spent:,.0f} packets for each second of CPU time", end="")


def test_capture_memory_and_time(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A hundred times as many packets take a hundred times as long, with hardly more memory."""
    program = OURS.format(look=LOOKS["messages and values"])
    few, short, small = run(program, str(capture(tmp_path, FEW)))
    middle, seconds, _ = run(program, str(capture(tmp_path, PACKETS)))
    many, long, big = run(program, str(capture(tmp_path, MANY)))
    # The first random commands may be too strange to claim the connection.
    for found, packets in ((few, FEW), (middle, PACKETS), (many, MANY)):
        assert packets - 10 < found <= packets
    bend = (long / many) / (seconds / middle)
    with capsys.disabled():
        print(f"\n{MANY:,} packets: {(big - small) / (1 << 20):.0f} MiB more than {FEW:,}, ", end="")
        print(f"{bend:.2f} x the time a packet of {PACKETS:,}", end="")
    assert short < seconds < long
    assert big - small <= MOST_GROWTH
    assert bend <= MOST_BEND
