"""Programs with pyshark: they pass our parameters, and get the messages of each packet, in XML and in EK."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from support.cli import run_program
from support.wireshark import Tshark

CAPTURES = Path(__file__).parents[2] / "captures"
PROGRAM = """\
import asyncio, contextlib, sys
import pyshark
from pyshark.capture.capture import TSharkCrashException
import ev3proto.pyshark
from ev3proto.capture import read

tshark, *names = sys.argv[1:]
asyncio.set_event_loop(asyncio.new_event_loop())
for use_ek in (False, True):
    parameters = ev3proto.pyshark.parameters(tshark=tshark, use_ek=use_ek)
    for name in names:
        packets = pyshark.FileCapture(name, tshark_path=tshark, custom_parameters=parameters, use_ek=use_ek)
        found = [record for packet in packets for record in ev3proto.pyshark.messages(packet)]
        # pyshark kills tshark at the end of its output: one that was just ending loses its status, as if it crashed.
        with contextlib.suppress(TSharkCrashException):
            packets.close()
        expected = list(read(name))
        assert [record.frame for record in found] == [record.frame for record in expected], (use_ek, name)
        assert [record.time_ns for record in found] == [record.time_ns for record in expected], (use_ek, name)
        assert [record.number for record in found] == [record.number for record in expected], (use_ek, name)
        assert [record.connection for record in found] == [record.connection for record in expected], (use_ek, name)
        linked = [record.request and record.request.number for record in found]
        assert linked == [record.request and record.request.number for record in expected], (use_ek, name)
        assert [str(record.values) for record in found] == [str(record.values) for record in expected]
        print(name.rpartition("/")[2], use_ek, len(found), sum(number is not None for number in linked))
"""


def test_the_messages_of_each_packet(tshark: Tshark) -> None:
    names = [str(tshark.place(CAPTURES / name)) for name in ("wifi.pcapng", "usb-plugged.pcap", "bluetooth.pcapng")]
    # A tshark with a root of its own sees the dissector in its work folder only.
    places = {"TMPDIR": str(tshark.folder)}
    done = run_program(sys.executable, "-c", PROGRAM, tshark.path, *names, env=places)
    assert done.returncode == 0, done.stderr
    counts = [line.split() for line in done.stdout.splitlines()]
    assert [line[:2] for line in counts] == [
        [name, mode] for mode in ("False", "True") for name in ("wifi.pcapng", "usb-plugged.pcap", "bluetooth.pcapng")
    ]
    assert counts[0][2:] == counts[3][2:] == ["42", "18"]


def test_an_unknown_dialect() -> None:
    import ev3proto.pyshark

    with pytest.raises(ValueError, match="dialect must be one of"):
        ev3proto.pyshark.Messages(dialect="nxt")
