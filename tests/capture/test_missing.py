"""Frames of which a capture or a text has only the beginning: `Record.missing`, in every format and both engines."""

from __future__ import annotations

import io
import json
from pathlib import Path

import pytest
from support.cli import run_ev3proto_text
from support.messages import tone, voltage, volts
from support.packets import HCI_WITH_DIRECTION, RAW_IP, USBMON, Connection, Device, SerialPort, cut
from support.packets import Capture as Packets
from support.reading import opened, records

from ev3proto import pyshark
from ev3proto.capture import Record, read

LONG = bytes.fromhex("2100 0500 01 92 05000000") + b"../prjs/hello/hello.rbf\0".ljust(25, b"x")
"""BEGIN_DOWNLOAD, 35 bytes."""
LISTED = bytes.fromhex("2a00 0600 03 99 00 20000000 00") + b"0123456789abcdef0123456789abcde\n"
"""A reply to LIST_FILES, 44 bytes."""

SAID = [(True, voltage(1)), (False, volts(1)), (True, LONG), (False, LISTED), (True, tone(7)), (True, voltage(8))]

HEADS = {RAW_IP: 40, HCI_WITH_DIRECTION: 16, USBMON: 64}
"""Bytes of a packet before the frame."""


def captured(link: int) -> bytes:
    packets = Packets(link)
    carrier = {RAW_IP: Connection, HCI_WITH_DIRECTION: SerialPort, USBMON: Device}[link](packets)
    for from_host, frame in SAID:
        (carrier.send if from_host else carrier.receive)(frame)
    return packets.data()


@pytest.mark.parametrize("link", HEADS)
def test_both_engines_tell_what_is_missing(link: int, tmp_path: Path) -> None:
    """The 16 bytes of the tone are whole in a report of 1,024 bytes that was cut after 20."""
    path = tmp_path / "cut.pcap"
    path.write_bytes(cut(captured(link), HEADS[link] + 20))
    expected = [(frame[:20].hex(), max(len(frame) - 20, 0)) for _, frame in SAID]
    for engine in (read, pyshark.read):
        found = [(each.frame.hex(), each.missing) for each in engine(path)]
        assert found == expected, engine


@pytest.mark.parametrize("size", [32, 64, 96])
def test_usual_snap_lengths(size: int) -> None:
    for link, head in HEADS.items():
        left = size - head
        found = [(each.frame, each.missing) for each in records(cut(captured(link), size))]
        expected = [(frame[:left], max(len(frame) - left, 0)) for _, frame in SAID] if left >= 9 else []
        assert found == expected, (link, size)


TEXT = "sent 21 00 05 00 01 92 05 00 00 00 2E 2E 2F ...\n"
CUT = cut(captured(RAW_IP), 40 + 13)


@pytest.mark.parametrize(
    ("style", "expected"),
    [
        ("tree", "SYSTEM_COMMAND_REPLY, counter 5, 13 bytes of 35: the {} is cut here: BEGIN_DOWNLOAD"),
        ("table", "SYSTEM_COMMAND_REPLY, counter 5, 13 bytes of 35: the {} is cut here: BEGIN_DOWNLOAD"),
        ("sentence", "; its last 22 bytes are missing."),
        ("asm", ", counter 5, 13 bytes of 35: the {} is cut here: BEGIN_DOWNLOAD"),
        ("csv", ",missing,22,bytes"),
    ],
)
def test_every_format_shows_it(style: str, expected: str) -> None:
    for source, data in (("text", TEXT.encode()), ("capture", CUT)):
        shown = run_ev3proto_text("decode", "--format", style, "-", stdin=data)
        assert expected.format(source) in shown.stdout
        assert "fault" not in shown.stdout.replace("// fault at", "")
        assert (shown.returncode, shown.stderr) == (0, "")


def test_json_and_dialogues_show_it() -> None:
    for data in (TEXT.encode(), CUT):
        entries = map(json.loads, run_ev3proto_text("decode", "--json", "-", stdin=data).stdout.splitlines())
        assert [(each["cut"], each["missing"]) for each in entries if "missing" in each][:1] == [(True, 22)]
        shown = run_ev3proto_text("decode", "--dialogues", "-", stdin=data).stdout
        assert "BEGIN_DOWNLOAD size=5 (the last 22 bytes are missing)" in shown
        filtered = run_ev3proto_text("decode", "--format", "sentence", "--filter", "missing > 22", "-", stdin=data)
        assert filtered.stdout.count("are missing.") == (data is CUT)


def test_check_does_not_blame_the_sender() -> None:
    shown = run_ev3proto_text("check", "-", stdin=CUT)
    assert (shown.returncode, shown.stderr) == (0, "")
    assert "E102" not in shown.stdout
    assert shown.stdout.splitlines()[-1] == (
        "2 frames: 0 errors, 0 warnings, 0 hints; 2 frames from the brick not checked; 2 frames cut by the capture not"
        " checked"
    )


def test_statistics_count_it() -> None:
    summary = json.loads(run_ev3proto_text("stats", "--json", "-", stdin=CUT).stdout)
    assert (summary["whole"]["faults"], summary["whole"]["cut"], summary["missing_bytes"]) == (0, 3, 22 + 31 + 3)


# What looks like an EV3's and is not shown


def test_packets_that_were_not_recognised_are_counted_beside_frames() -> None:
    packets = Packets(RAW_IP)
    first, second = Connection(packets, 50001), Connection(packets, 50002)
    first.send(voltage(1))
    second.send(b"\xff\xff\xff")
    second.send(b"\xff\xff\xff")
    shown = run_ev3proto_text("decode", "--format", "sentence", "-", stdin=packets.data())
    assert (shown.returncode, shown.stdout.count("\n")) == (0, 1)
    assert shown.stderr == (
        "standard input: not all of it was read; 2 packets on TCP port 5555 were not recognised; --port 5555 shows them"
        " as they are\n"
    )


def test_what_a_reply_proves_later_is_not_counted() -> None:
    """A command by itself that no program would send, in pieces, and the reply that proves it."""
    wrong = bytes.fromhex("0800 0100 00 0400 ff 01 60")
    for link in HEADS:
        packets = Packets(link)
        carrier = {RAW_IP: Connection, HCI_WITH_DIRECTION: SerialPort, USBMON: Device}[link](packets)
        carrier.send(wrong)
        carrier.receive(volts(1))
        events, capture = opened(packets.data())
        assert len([each for each in events if isinstance(each, Record)]) == 2
        assert capture.account.strange == {}


def test_frames_on_another_port_are_named() -> None:
    packets = Packets(RAW_IP)
    bridge, web = Connection(packets, 50001, 8000), Connection(packets, 50002, 80)
    web.send(b"GET / HTTP/1.1\r\n\r\n")
    bridge.send(voltage(1))
    sentence = "TCP port 8000 has frames of an EV3; --port 8000 shows them"
    assert run_ev3proto_text("decode", "-", stdin=packets.data()).stderr == "standard input: no frame in 2 packets\n"
    bridge.receive(volts(1))
    bridge.send(tone(2))
    shown = run_ev3proto_text("decode", "-", stdin=packets.data())
    assert (shown.returncode, shown.stderr) == (1, f"standard input: no frame in 4 packets; {sentence}\n")
    assert len(records(packets.data(), ports=[8000])) == 3
    assert read(io.BytesIO(packets.data()), ports=[8000]).account.elsewhere == {}
