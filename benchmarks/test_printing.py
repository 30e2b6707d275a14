"""How long it takes to print messages, as a ratio to tshark with the dissector in the same run.

    pytest benchmarks -k printing

The capture has 10,000 packets of one TCP connection with a random command each. Each program reads it from start to
end, with imports; the result is CPU time. tshark loads the dissector of a fixed commit, so that a faster
dissector does not change the goal; without the repository's history it loads the present one, and the output says so.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from statistics import median

import pytest
from support.frames import Segment, tcp_capture
from support.wireshark import DISSECTOR, Tshark

from benchmarks.commands import commands

COMMANDS = 10_000
ROUNDS = 3
DISSECTOR_OF = "9d4ed06"
"""The commit of the dissector that sets the goal."""

PAIRS = {
    "decode / tshark -V": (("decode",), ("-V",)),
    "decode --json / tshark -T json": (("decode", "--json"), ("-T", "json")),
    "check / tshark -V": (("check",), ("-V",)),
}
MOST = {"decode / tshark -V": 1.2, "decode --json / tshark -T json": 0.7, "check / tshark -V": 4.5}
"""Ratios above which something is wrong: half as much again as they are."""


def _dissector(folder: Path) -> tuple[Path, str]:
    """The file to load, and a description of it."""
    asked = ["git", "-C", str(Path(__file__).parent), "show", f"{DISSECTOR_OF}:dissector/{DISSECTOR.name}"]
    done = subprocess.run(asked, check=False, capture_output=True)
    if done.returncode:
        return DISSECTOR, "the present dissector"
    path = folder / DISSECTOR.name
    path.write_bytes(done.stdout)
    return path, f"the dissector of commit {DISSECTOR_OF}"


def _spent(command: Sequence[str]) -> float:
    """CPU seconds of a program. Compiled modules are kept, as on a user's machine."""
    env = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    before = os.times()
    subprocess.run(command, check=False, env=env, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = os.times()
    return sum(after[2:4]) - sum(before[2:4])


def test_printing_ratios(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Prints the ratios that the README names: rounds alternate, the median round counts."""
    capture = tmp_path / "commands.pcap"
    capture.write_bytes(tcp_capture(Segment(True, frame) for frame in commands(COMMANDS)))
    script, which = _dissector(tmp_path)
    ratios: dict[str, list[float]] = {name: [] for name in PAIRS}
    with Tshark.from_setting(script) as tshark:
        theirs = [str(tshark.path), *tshark.words, "-r", str(tshark.place(capture))]
        for _ in range(ROUNDS):
            for name, (ours, output) in PAIRS.items():
                own = _spent([sys.executable, "-m", "ev3proto", *ours, str(capture)])
                ratios[name].append(own / _spent([*theirs, *output]))
        version = ".".join(map(str, tshark.version))
    with capsys.disabled():
        print(f"\ntshark {version} with {which}", end="")
        for name, found in ratios.items():
            print(f"\n{name}: {median(found):.2f} x", end="")
    for name, found in ratios.items():
        assert median(found) <= MOST[name]
