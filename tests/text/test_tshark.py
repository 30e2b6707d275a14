"""The output of the real tshark can be pasted: payloads as fields, and its hex dumps."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from ev3proto import parse
from ev3proto.text.paste import read_text
from ev3proto.text.splitting import split

COMMAND = bytes.fromhex("08 00 01 00 00 04 00 81 01 60")
REPLY = bytes.fromhex("07 00 01 00 02 A4 70 FD 40")


@pytest.fixture
def capture(tmp_path: Path) -> Path:
    """A capture of one command and its reply in TCP segments to and from port 5555."""
    dump = "\n".join(f"{way} 0000 {frame.hex(' ')}" for way, frame in (("O", COMMAND), ("I", REPLY))) + "\n"
    path = tmp_path / "ev3.pcap"
    words = ["text2pcap", "-q", "-D", "-T", "40000,5555", "-", str(path)]
    subprocess.run(words, input=dump, text=True, check=True, capture_output=True, timeout=60)
    return path


def tshark(capture: Path, *words: str) -> list[str]:
    command = ["tshark", "-r", str(capture), *words]
    return subprocess.run(command, text=True, check=True, capture_output=True, timeout=120).stdout.splitlines()


def test_payloads_that_tshark_prints(capture: Path) -> None:
    found = [pasted.data for pasted in read_text(tshark(capture, "-T", "fields", "-e", "tcp.payload"))]
    assert found == [COMMAND, REPLY]


def test_hex_dumps_that_tshark_prints(capture: Path) -> None:
    found = [pasted.data for pasted in read_text(tshark(capture, "-x"))]
    # The dump also has the packet's headers of Ethernet, IP and TCP, 54 bytes in all.
    assert found == [COMMAND, REPLY]
    assert [piece.message for data in found for piece in split(data)] == [parse(COMMAND), parse(REPLY)]
