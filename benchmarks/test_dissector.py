"""How long tshark takes with the dissector, as a ratio to tshark without any, side by side in one run.

    pytest benchmarks -k dissector

The capture has 30,000 packets of one TCP connection: 15,000 random commands that want a reply, and their replies. Which
tshark is measured is a setting: EV3PROTO_TSHARK, as for the tests.
"""

from __future__ import annotations

import random
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path
from statistics import median

import pytest
from frames import Segment, tcp_capture
from wireshark import Tshark

import ev3proto
from benchmarks.commands import commands

COMMANDS = 15_000
ROUNDS = 5
MOST = {"one line": 3.0, "-V": 3.5}
"""How many times tshark's own time each kind of output may take."""


def _dialogue() -> Iterator[Segment]:
    """Each command and its reply, and whether it comes from the host."""
    rng = random.Random(1)
    for counter, frame in enumerate(commands(COMMANDS)):
        command = ev3proto.parse(frame)
        assert isinstance(command, ev3proto.DirectCommand)
        asked = ev3proto.direct_command(
            *command.operations,
            counter=counter,
            reply=True,
            global_size=command.global_size,
            local_size=command.local_size,
        )
        yield Segment(True, asked.build())
        yield Segment(False, ev3proto.direct_reply(rng.randbytes(command.global_size), counter=counter).build())


@pytest.fixture(scope="module")
def capture(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A pcap file of the dialogue, a frame a packet, a millisecond from each to the next."""
    path = tmp_path_factory.mktemp("speed") / "commands.pcap"
    path.write_bytes(tcp_capture(_dialogue()))
    return path


def test_dissector_ratios(capture: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Prints the ratios; rounds alternate, the median round counts."""
    times: dict[tuple[str, bool], list[float]] = {}
    with Tshark.from_setting() as tshark:
        placed = tshark.place(capture)
        for _ in range(ROUNDS):
            for output, words in (("one line", ()), ("-V", ("-V",))):
                for loaded in (False, True):
                    command = [str(tshark.path), *(tshark.words if loaded else ["-n"]), "-r", str(placed), *words]
                    start = time.perf_counter()
                    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                    times.setdefault((output, loaded), []).append(time.perf_counter() - start)
        version = ".".join(map(str, tshark.version))
    for output, most in MOST.items():
        bare, own = (median(times[output, loaded]) for loaded in (False, True))
        with capsys.disabled():
            print(f"\ntshark {version}, {output}: {own / bare:.2f} x ({bare:.2f} s without, {own:.2f} s with)", end="")
        assert own / bare <= most
