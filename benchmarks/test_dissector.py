"""How long tshark takes with the dissector, as a ratio to tshark without any, side by side in one run.

    pytest benchmarks -k dissector

The capture has 30,000 packets of one TCP connection: 15,000 random commands that want a reply, and their replies. Which
tshark is measured is a setting: EV3PROTO_TSHARK, as for the tests.
"""

from __future__ import annotations

import subprocess
import time
from pathlib import Path
from statistics import median

import pytest
from support.frames import tcp_capture
from support.wireshark import Tshark

from benchmarks.dialogue import dialogue

COMMANDS = 15_000
ROUNDS = 5
MOST = {"one line": 3.0, "-V": 3.5}
"""How many times tshark's own time each kind of output may take."""


@pytest.fixture(scope="module")
def capture(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A pcap file of the dialogue, a frame a packet, a millisecond from each to the next."""
    path = tmp_path_factory.mktemp("speed") / "commands.pcap"
    path.write_bytes(tcp_capture(dialogue(COMMANDS)))
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
