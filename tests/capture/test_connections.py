"""Whose message it is: numbers of conversations, in the order of their first messages; in texts, labels."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from support.cli import run_ev3proto_text
from support.messages import tone, voltage, volts
from support.packets import HCI_WITH_DIRECTION, RAW_IP, SYN, USBMON, Connection, Device, SerialPort, segment
from support.packets import Capture as Packets
from support.reading import records

import ev3proto

A, B = bytes.fromhex("0a0000531600"), bytes.fromhex("0b0000531600")


def test_tcp_connections_count_from_their_first_message_and_from_a_syn() -> None:
    packets = Packets(RAW_IP)
    first, second, other = (Connection(packets, port) for port in (50001, 50002, 50003))
    other.send(b"GET / HTTP/1.1\r\n\r\n")
    first.send(voltage(1)[:6])
    second.send(voltage(2))
    first.send(voltage(1)[6:])
    second.receive(volts(2))
    packets.add(segment(True, 70_000, flags=SYN, port=50002))
    packets.add(segment(True, 70_001, tone(3), port=50002))
    first.receive(volts(1))
    found = [(each.frame, each.connection) for each in records(packets.data())]
    assert found == [(voltage(2), 1), (voltage(1), 2), (volts(2), 1), (tone(3), 3), (volts(1), 2)]


def test_usb_devices() -> None:
    packets = Packets(USBMON)
    mouse, first, second = Device(packets, 3, size=8), Device(packets, 9), Device(packets, 7)
    mouse.receive(b"\0\1\2\3")
    for device in (first, second, first):
        device.send(voltage(1))
        device.receive(volts(1))
    assert [each.connection for each in records(packets.data())] == [1, 1, 2, 2, 1, 1]


def test_the_serial_port_between_two_addresses_keeps_its_number() -> None:
    packets = Packets(HCI_WITH_DIRECTION)
    for handle, address in ((0x00B, A), (0x00C, B), (0x00C, A)):
        port = SerialPort(packets, connection=handle, address=address)
        port.send(voltage(1))
        port.receive(volts(1))
        packets.add(bytes.fromhex("00000001 04 05 04 00") + handle.to_bytes(2, "little") + b"\x13")
    found = [(each.peer, each.connection) for each in records(packets.data())]
    first, second = ("00:16:53:00:00:0a", 1), ("00:16:53:00:00:0b", 2)
    assert found == [first, first, second, second, first, first]


# Texts

ANGLE, VOLTS, PERCENT = "99:1D:00:00:00:00:01:60", "81:01:60", "81:12:60"
LABELLED = f"""\
[A] Sent 0x|0D:00|2A:00|00|04:00|{ANGLE}|
[B] Sent 0x|08:00|2A:00|00|04:00|{VOLTS}|
[B] Recv 0x|07:00|2A:00|02|A4:70:FD:40|
[A] Recv 0x|07:00|2A:00|02|00:00:48:42|
[B] Sent 0x|08:00|2B:00|00|01:00|{PERCENT}|
[A] Recv 0x|07:00|2B:00|02|00:00:80:3F|
[B] Recv 0x|04:00|2B:00|02|64|
"""


def test_labels_tell_two_bricks_apart() -> None:
    ready = "INPUT_DEVICE.READY_SI(LAYER=0, NO=0, TYPE=TYPE_KEEP, MODE=0, VALUES=1, VALUES[0]=GV(0)) -> VALUES[0]=50.0"
    shown = run_ev3proto_text("decode", "--dialogues", "-", stdin=LABELLED).stdout.splitlines()
    assert shown == [
        "B",
        "                 #2 UI_READ.GET_VBATT(VALUE=GV(0)) -> VALUE=7.92 V",
        "A",
        f"                 #1 {ready}",
        "                 #6 (a command that was not seen) -> ok  (counter 43)",
        "B",
        "                 #5 UI_READ.GET_LBATT(PCT=GV(0)) -> PCT=100 %",
    ]
    for wanted in ('connection == "B"', "connection == 2"):
        assert run_ev3proto_text(
            "decode", "--dialogues", "--filter", wanted, "-", stdin=LABELLED
        ).stdout.splitlines() == [
            shown[0],
            shown[1],
            shown[-1],
        ]
    labels = [(each.label, each.connection) for each in ev3proto.read(LABELLED) if isinstance(each, ev3proto.Record)]
    assert labels == [("A", 1), ("B", 2), ("B", 2), ("A", 1), ("B", 2), ("A", 1), ("B", 2)]


def test_files_of_two_bricks() -> None:
    begun = "12 00 05 00 01 92 05 00 00 00 2E 2E 2F 70 72 6A 73 2F"
    text = (
        f"A send {begun} 61 00\nB send {begun} 62 00\nB recv 06 00 05 00 03 92 00 01\nA recv 06 00 05 00 03 92 00 00\n"
    )
    text += "A send 0A 00 06 00 81 93 00 31 32 33 34 35\nB send 0A 00 06 00 81 93 01 36 37 38 39 30\n"
    listed = run_ev3proto_text("files", "--json", "-", stdin=text).stdout
    found = [(each["path"], each["bytes"]) for each in map(json.loads, listed.splitlines())]
    assert found == [("../prjs/a", 5), ("../prjs/b", 5)]


@pytest.mark.parametrize(
    ("labels", "connections"),
    [
        # The name of a module or a thread, which command and reply do not share.
        (["Sender: sent", "Parser: received", "Sender: sent", "Parser: received"], [1, 1, 1, 1]),
        (["T1 sent", "T2 received", "T2 sent", "T1 received", "T1 sent", "T1 received"], [1, 1, 1, 1, 1, 1]),
        # Only the commands have one.
        (["COM3 sent", "received", "COM4 sent", "received"], [1, 1, 2, 2]),
    ],
)
def test_labels_that_do_not_tell_bricks_apart(labels: list[str], connections: list[int]) -> None:
    frames = [frame for counter in range(len(labels) // 2) for frame in (voltage(counter), volts(counter))]
    text = "".join(f"{label} {frame.hex(' ')}\n" for label, frame in zip(labels, frames, strict=True))
    found = [each for each in ev3proto.read(text) if isinstance(each, ev3proto.Record)]
    assert [each.connection for each in found] == connections
    assert [value.value for each in found for value in each.values] == [7.5] * (len(labels) // 2)


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        # Two commands fit both replies: none of the pairings is sure.
        (
            [ANGLE, VOLTS, "0700 2a00 02 a470fd40", "0700 2a00 02 00004842"],
            ["VALUES[0]=7.92  (the pairing is unsure)", "VALUE=50.0 V  (the pairing is unsure)"],
        ),
        # The length tells.
        ([ANGLE, PERCENT, "0400 2a00 02 64", "0700 2a00 02 00004842"], ["PCT=100 %", "VALUES[0]=50.0"]),
        # An error fits both, and what then fits none of the rest is not given the value of another.
        (
            [ANGLE, PERCENT, "0300 2a00 04", "0700 2a00 02 00004842"],
            ["error  (the pairing is unsure)", "ok  (counter 42)", "no reply  (counter 42)"],
        ),
    ],
)
def test_without_labels_only_one_that_fits_is_sure(lines: list[str], expected: list[str]) -> None:
    text = ""
    for line in lines:
        sizes = {ANGLE: "0d00 2a00 00 0400", VOLTS: "0800 2a00 00 0400", PERCENT: "0800 2a00 00 0100"}
        text += f"sent {sizes[line]} {line.replace(':', ' ')}\n" if line in sizes else f"received {line}\n"
    shown = run_ev3proto_text("decode", "--dialogues", "-", stdin=text).stdout.splitlines()
    assert [line.partition(" -> ")[2] for line in shown] == expected
    unsure = sum("unsure" in line for line in expected)
    for words in (("decode", "--format", "csv"), ("decode", "--json"), ("decode", "--format", "sentence")):
        assert run_ev3proto_text(*words, "-", stdin=text).stdout.count("the pairing is unsure") == unsure
    told = run_ev3proto_text("values", "-", stdin=text).stderr
    assert ("may answer another command" in told) == (unsure > 0)


def test_what_is_counted_and_written_for_each_label(tmp_path: Path) -> None:
    text = LABELLED
    for label, handle, data in (("A", "00", "31 32 33"), ("B", "01", "34 35 36")):
        text += f"[{label}] Sent 12 00 05 00 01 92 03 00 00 00 2E 2E 2F 70 72 6A 73 2F 61 00\n"
        text += f"[{label}] Recv 06 00 05 00 03 92 00 {handle}\n[{label}] Sent 08 00 06 00 81 93 {handle} {data}\n"
    summary = json.loads(run_ev3proto_text("stats", "--json", "-", stdin=text).stdout)
    assert [(each["name"], each["messages"]["messages"]) for each in summary["peers"]] == [("A", 6), ("B", 7)]
    run_ev3proto_text("files", "-o", tmp_path, "-", stdin=text)
    assert [(tmp_path / name / "prjs/a").read_text() for name in "AB"] == ["123", "456"]
    (first, *_) = (
        json.loads(line) for line in run_ev3proto_text("decode", "--json", "-", stdin=text).stdout.splitlines()
    )
    assert first["label"] == "A"
    filtered = run_ev3proto_text("decode", "--json", "--filter", "connection == B", "-", stdin=text).stdout.splitlines()
    assert {(each["label"], each["connection"]) for each in map(json.loads, filtered)} == {("B", 2)}
