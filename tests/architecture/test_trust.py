"""Untrusted input never controls a terminal, exceeds the memory limits, or ends in a traceback."""

from __future__ import annotations

import io
import json
import re
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest
from support.cli import run_ev3proto, run_ev3proto_text
from support.cpu_time import milliseconds
from support.effort import effort
from support.files import Blocks
from support.packets import HCI_WITH_DIRECTION, RAW_IP, Capture, Connection, SerialPort, datagram, segment
from support.peak import PEAK
from support.wireshark import Tshark

import ev3proto
from ev3proto.capture import Record, read
from ev3proto.checking.checking import check
from ev3proto.pyshark import read as read_by_tshark
from ev3proto.text.spans import visible

HARMFUL = "\x1b]52;c;Zm9v\x07\x1b[2J\x9b31m\x85\x7f\u202e\u2066\u2028"


CONTROLS = [letter for letter in HARMFUL if not letter.isprintable()]


@pytest.mark.parametrize("text", CONTROLS)
def test_every_harmful_character_is_written_as_an_escape(text: str) -> None:
    assert visible(f"a{text}b") == f"a\\u{ord(text):04x}b"


def test_invisible_characters_are_written_as_in_json() -> None:
    for text, escaped in (
        ("\u206a", "\\u206a"),
        ("\ufff9", "\\ufff9"),
        ("\U000e0041", "\\udb40\\udc41"),
        ("\ud800", "\\ud800"),
    ):
        assert visible(f"a{text}b") == f"a{escaped}b"
        assert json.loads(f'"{escaped}"') == text


def test_json_stays_json() -> None:
    operation = ev3proto.operation("FILENAME.EXIST", "\x9b\x7f\x1b", ev3proto.GV(0))
    command = ev3proto.direct_command(operation, global_size=4).build()
    done = run_ev3proto_text("decode", "--json", command.hex())
    (entry,) = map(json.loads, done.stdout.splitlines())
    assert entry["operations"][0]["args"][0]["value"] == "\x9b\x7f\x1b"
    assert done.stdout.isascii()


def test_an_unforeseen_failure_is_one_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    import ev3proto.cli.ops

    def broken(*_: object, **__: object) -> None:
        raise ZeroDivisionError("something")

    monkeypatch.setattr(ev3proto.cli.ops.ops, "callback", broken)
    done = run_ev3proto_text("ops")
    assert done.returncode == 70
    assert done.stderr.count("\n") == 1
    assert "ZeroDivisionError: something" in done.stderr
    monkeypatch.setenv("EV3PROTO_DEBUG", "1")
    with pytest.raises(ZeroDivisionError):
        run_ev3proto_text("ops")


@pytest.mark.parametrize(
    ("operations", "shown"),
    [
        ("94 01 01 82 B8 01 82", "offset 13"),
        ("94 3F", "offset 8"),
        ("FF", "offset 8"),
        ("80 05 84 61 62", "offset 9"),
        ("80 05 86 61", "offset 9"),
        ("04 01 01 83 40 00 00 00 00", "offset 11"),
        ("94 81 01 01 01 01", "CMD = 1  LC1"),
    ],
)
def test_unusual_operations_are_shown_and_come_back(operations: str, shown: str) -> None:
    body = bytes.fromhex("2A00 00 0000" + operations)
    frame = len(body).to_bytes(2, "little") + body
    done = run_ev3proto_text("decode", frame.hex())
    assert shown in done.stdout + done.stderr
    entry = json.loads(run_ev3proto_text("decode", "--json", frame.hex()).stdout)
    for record in (entry, {key: value for key, value in entry.items() if key != "hex"}):
        made = run_ev3proto("encode", "--to", "raw", stdin=json.dumps(record).encode())
        assert made.stdout == frame


def commands(count: int) -> bytes:
    """A capture of commands whose replies never come, on 256 connections."""
    found = Capture(RAW_IP)
    for number in range(count):
        turn, frame = number // 256, frame_of(b"\x01" * 90, number // 256, 0, b"\0\0")
        found.add(segment(True, 1 + turn * len(frame), frame, port=1024 + number % 256, acknowledged=1))
    return found.data()


def test_commands_without_replies_share_a_budget() -> None:
    capture = read(io.BytesIO(commands(3000)), memory=1 << 20)
    assert sum(1 for _ in capture) == 3000
    # Each counts as about 800 bytes, so 1 MiB has room for 1,300.
    assert 1500 < capture.account.forgotten < 1900


def test_what_was_given_up_is_reported(tmp_path: Path) -> None:
    path = tmp_path / "many.pcap"
    path.write_bytes(commands(3000))
    done = run_ev3proto_text("stats", "--memory", "1", str(path))
    assert "unanswered commands were dropped: the memory limit is 1 MiB (--memory)" in done.stderr


def test_a_text_keeps_as_few_commands_without_replies(tmp_path: Path) -> None:
    path = tmp_path / "many.txt"
    reply = "03 00 CF 07 02"  # to the last of them
    path.write_text("\n".join([*(frame_of(b"\1", number, 0).hex() for number in range(2000)), reply]))
    done = run_ev3proto_text("decode", "--memory", "1", str(path))
    # Each counts as about 800 bytes, as in captures.
    assert re.search(r"many\.txt: [567]\d\d unfinished frames, .* were dropped", done.stderr)


def frame_of(body: bytes, counter: int = 1, code: int = 0x80, memory: bytes = b"\x40\0") -> bytes:
    head = struct.pack("<HB", counter & 0xFFFF, code) + memory + body
    return struct.pack("<H", len(head)) + head


def test_a_frame_longer_than_any_is_not_looked_into() -> None:
    frame = struct.pack("<HHBH", 65535, 1, 0x80, 0) + b"\x40\x05" * 32765
    assert not check(frame).accepted
    assert milliseconds(lambda: check(frame), 200) <= 200


def hostile(kind: str, count: int) -> bytes:
    """A capture in which every packet needs memory."""
    found = Capture(RAW_IP)
    one = Connection(found)
    waiting = struct.pack("<HHBH", 95, 1, 0, 0) + b"\x01" * 90
    for number in range(count):
        if kind == "pending commands":
            one.send(waiting[:2] + struct.pack("<H", number & 0xFFFF) + waiting[4:])
        elif kind == "half frames of many connections":
            found.add(segment(True, 1, waiting[:50], port=1024 + number, acknowledged=1))
        elif kind == "gaps":
            found.add(segment(True, 1 + 2000 * number, waiting * 2, port=1024 + number % 50, acknowledged=1))
        elif kind == "segments of one byte":
            one.send(waiting[number % 97 : number % 97 + 1])
        elif kind == "segments of one byte, backwards":
            found.add(segment(True, 1 + 2 * (count - number), b"\x01", acknowledged=1))
        elif kind == "files that begin":
            path = b"../prjs/%06d" % number + b"x" * 900 + b"\0"
            for again in range(2):
                one.send(frame_of(b"\x92" + struct.pack("<I", 1000) + path, 2 * number + again, 0x81, memory=b""))
        elif kind == "bricks":
            beacon = b"Serial-Number: %012x\r\nPort: 5555\r\nName: x\r\nProtocol: EV3\r\n" % number
            found.add(datagram(beacon, struct.pack(">I", 0x0A000000 + number)))
        else:
            one.send(struct.pack("<HHB", 600, number & 0xFFFF, 0x81) + b"\x03\0" * 50)
    return found.data()


def hostile_bluetooth(kind: str, count: int) -> bytes:
    """The same for Bluetooth."""
    found = Capture(HCI_WITH_DIRECTION)
    reply = frame_of(b"\0" * 100 + b"\xff" * 900, 1, 2, memory=b"")
    for number in range(count):
        if kind == "beginnings of packets":
            head = struct.pack("<IBHHHH", 0, 2, number % 4096, 6004, 60_000, 0x41)
            found.add(head + b"x" * 6000)
        else:
            port = SerialPort(found, connection=number % 500)
            for _ in range(3):
                port.receive(reply)
    return found.data()


def hostile_interfaces(kind: str, count: int) -> bytes:
    """A pcapng file with many facts about its interfaces, in one section or in many."""
    found = Blocks()
    own_address = struct.pack(">IB", 1, 4) + bytes((0x0E, 10, 1, 9, 0x10, 0)) + b"abcdef"
    for number in range(count):
        name = f"{number:06}".ljust(8000, "x")
        if kind == "names of interfaces":
            found.interface(RAW_IP, name=name)
        else:
            found.section("<")
            found.interface(HCI_WITH_DIRECTION, name=name)
            found.packet(0, own_address)
    return found.data()


MAKERS = {
    "beginnings of packets": hostile_bluetooth,
    "replies before any command": hostile_bluetooth,
    "names of interfaces": hostile_interfaces,
    "adapters": hostile_interfaces,
}


@pytest.mark.parametrize(
    "kind",
    [
        "pending commands",
        "half frames of many connections",
        "gaps",
        "segments of one byte",
        "segments of one byte, backwards",
        "bricks",
        "garbage that almost fits",
        "files that begin",
        *MAKERS,
    ],
)
def test_memory_has_a_limit(kind: str, tmp_path: Path) -> None:
    peaks = []
    for count in (effort(1500, 15_000), effort(6000, 45_000)):
        path = tmp_path / f"{count}.pcap"
        path.write_bytes(MAKERS.get(kind, hostile)(kind, count))
        call = [sys.executable, "-c", PEAK, "decode", "--dialogues", "--memory", "1", str(path)]
        done = subprocess.run(call, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
        peaks.append(int(done.stderr.splitlines()[-1]))
    assert peaks[1] - peaks[0] < 6 << 10, peaks
    assert peaks[1] < 100 << 10


def test_a_sarif_log_is_not_kept(tmp_path: Path) -> None:
    peaks = []
    for count in (500, 9000):
        path = tmp_path / f"{count}.log"
        path.write_text("\n".join(frame_of(b"\x94\x3f", number).hex() for number in range(count)))
        call = [sys.executable, "-c", PEAK, "check", "--format", "sarif", str(path)]
        done = subprocess.run(call, capture_output=True, text=True, check=False)
        assert len(json.loads(done.stdout)["runs"][0]["results"]) >= count
        peaks.append(int(done.stderr.splitlines()[-1]))
    assert peaks[1] - peaks[0] < 6 << 10, peaks


def test_tshark_shares_the_limit(tshark: Tshark, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tshark.folder))  # where this tshark finds the dissector
    path = tshark.folder / "pending.pcap"
    path.write_bytes(commands(3000))
    capture = read_by_tshark(path, tshark=str(tshark.path), memory=1 << 20)
    assert sum(1 for event in capture if isinstance(event, Record)) > 2900
    assert 1400 < capture.account.forgotten < 1900
