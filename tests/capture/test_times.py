"""Times: of a frame in several packets that of the last one; of a source without dates seconds."""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from support.cli import run_ev3proto_text
from support.messages import voltage, volts
from support.packets import HCI_WITH_DIRECTION, RAW_IP, Connection, SerialPort, segment
from support.packets import Capture as Packets
from support.reading import records
from support.relays import Relay, relay
from support.server import Client
from support.stub_brick import stub_brick
from support.wireshark import Tshark

from ev3proto.capture.dialogues import RequestReply

MILLISECOND = 1_000_000

USBMON_TEXT = """\
ffff8ec5 4095999800 S Io:1:007:1 -115:4 1024 = 08000100 00040081 01600000 00000000 00000000 00000000 00000000 00000000
ffff8ec6 3000 C Ii:1:007:1 0:4 1024 = 07000100 02a470fd 40000000 00000000 00000000 00000000 00000000 00000000
"""


def in_pieces(link: int) -> bytes:
    """A command in two packets, and its reply in three; each packet comes a millisecond after the one before."""
    packets = Packets(link)
    carrier = {RAW_IP: Connection, HCI_WITH_DIRECTION: SerialPort}[link](packets)
    for piece in (voltage(1)[:5], voltage(1)[5:]):
        carrier.send(piece)
    for piece in (volts(1)[:3], volts(1)[3:6], volts(1)[6:]):
        carrier.receive(piece)
    return packets.data()


def reordered() -> bytes:
    """The middle of a reply comes last."""
    packets = Packets(RAW_IP)
    Connection(packets).send(voltage(1))
    for start, stop in ((0, 3), (6, 9), (3, 6)):
        packets.add(segment(False, 1 + start, volts(1)[start:stop]))
    return packets.data()


@pytest.mark.parametrize("link", [RAW_IP, HCI_WITH_DIRECTION])
def test_the_reader(link: int) -> None:
    command, reply = records(in_pieces(link))
    first = command.numbers[0] - 1
    assert [command.time_ns, reply.time_ns] == [(first + 1) * MILLISECOND, (first + 4) * MILLISECOND]
    assert reply.latency == 0.003


def test_the_reader_of_segments_in_another_order() -> None:
    _, reply = records(reordered())
    assert (reply.numbers, reply.time_ns, reply.latency) == ((2, 4, 3), 3 * MILLISECOND, 0.003)


@pytest.mark.parametrize("link", [RAW_IP, HCI_WITH_DIRECTION])
def test_the_dissector(link: int, tshark: Tshark) -> None:
    path = tshark.place(in_pieces(link), "pieces.pcap")
    fields = ("-e", "ev3.response_time", "-e", "ev3.request_in")
    shown = tshark.run(path, "-2", "-Y", "ev3.response_time", "-T", "fields", "-e", "frame.number", *fields)
    last = 7 if link == HCI_WITH_DIRECTION else 5
    assert shown.split() == [str(last), "0.003000000", str(last - 3)]


def test_the_proxy(monkeypatch: pytest.MonkeyPatch) -> None:
    pairs: list[RequestReply] = []
    monkeypatch.setattr(Relay, "_show", lambda _, pair: pairs.append(pair))

    def answer(_frame: bytes, send: Callable[[bytes], None]) -> None:
        send(volts(1)[:6])
        time.sleep(0.2)
        send(volts(1)[6:])

    with stub_brick(answer) as port, relay(f"wifi:127.0.0.1:{port}") as found, Client(found.proxy.port) as client:
        assert client.ask(voltage(1)) == volts(1)
    ((command, reply),) = pairs
    assert command is not None
    assert reply is not None
    assert 0.2 <= (reply.time_ns - command.time_ns) / 1e9 < 2


# Sources without dates


def test_a_source_without_dates_has_seconds_everywhere(tmp_path: Path) -> None:
    """usbmon's text, a capture that counts from 0, and a log with times of the day."""
    log = "10:00:00.5 sent 08 00 01 00 00 04 00 81 01 60\n10:00:00.6 received 07 00 01 00 02 A4 70 FD 40\n"
    sources = {
        "usbmon.txt": USBMON_TEXT.encode(),
        "zero.pcap": in_pieces(RAW_IP),
        "robot.log": log.encode(),
    }
    found = {}
    for name, data in sources.items():
        path = tmp_path / name
        path.write_bytes(data)
        printed = [
            run_ev3proto_text(*words, path).stdout
            for words in (
                ("decode", "--json"),
                ("stats", "--json"),
                ("stats",),
                ("values", "--json"),
                ("values", "--csv"),
            )
        ]
        assert not [text for text in printed if "1970" in text or "2026" in text], name
        entries = [json.loads(line) for line in printed[0].splitlines()]
        whole = json.loads(printed[1])["whole"]
        found[name] = [each["time"] for each in entries], whole["first"], whole["last"], round(whole["seconds"], 6)
    assert found == {
        "usbmon.txt": (["0.000000", "0.003200"], "0.000000", "0.003200", 0.0032),
        "zero.pcap": (["0.001000", "0.004000"], "0.001000", "0.004000", 0.003),
        "robot.log": (["10:00:00.5", "10:00:00.6"], "0.000000", "0.100000", 0.1),
    }
