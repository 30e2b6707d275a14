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

import dpkt
import pytest
from wireshark import Tshark

import ev3proto
from benchmarks.commands import commands
from ev3proto.tables.discovery import TCP_PORT

COMMANDS = 15_000
ROUNDS = 5
MOST = {"one line": 3.0, "-V": 3.5}
"""How many times tshark's own time each kind of output may take."""

HOST, BRICK = (bytes((192, 0, 2, 1)), 49152), (bytes((192, 0, 2, 10)), TCP_PORT)


def _dialogue() -> Iterator[tuple[bool, bytes]]:
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
        yield True, asked.build()
        yield False, ev3proto.direct_reply(rng.randbytes(command.global_size), counter=counter).build()


@pytest.fixture(scope="module")
def capture(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A pcap file of the dialogue, a frame a packet, a millisecond from each to the next."""
    path = tmp_path_factory.mktemp("speed") / "commands.pcap"
    sent = {True: 1, False: 1}
    with path.open("wb") as file:
        writer = dpkt.pcap.Writer(file)
        for number, (from_host, frame) in enumerate(_dialogue()):
            (source, port), (target, other) = (HOST, BRICK) if from_host else (BRICK, HOST)
            tcp = dpkt.tcp.TCP(sport=port, dport=other, seq=sent[from_host], ack=sent[not from_host], data=frame)
            tcp.flags = dpkt.tcp.TH_PUSH | dpkt.tcp.TH_ACK
            ip = dpkt.ip.IP(src=source, dst=target, p=dpkt.ip.IP_PROTO_TCP, data=tcp)
            writer.writepkt(bytes(dpkt.ethernet.Ethernet(data=ip)), ts=1_800_000_000 + number / 1000)
            sent[from_host] += len(frame)
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
