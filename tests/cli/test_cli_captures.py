"""`ev3proto decode` on captures, as a user types it: output, errors, exit status."""

from __future__ import annotations

import gzip
import json
import os
import pty
import select
import shutil
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest
from support.cli import run_ev3proto, run_ev3proto_text
from support.packets import (
    HCI_WITH_DIRECTION,
    RAW_IP,
    USBMON,
    Capture,
    Connection,
    Device,
    SerialPort,
    cut,
)
from support.wireshark import Tshark

ROOT = Path(__file__).parents[2]
CAPTURES = ROOT / "captures"
EVERY = sorted(
    path for path in CAPTURES.iterdir() if path.suffix in (".pcap", ".pcapng") or path.name == "bluetooth.log"
)
TONE = bytes.fromhex("0e002a0080000094010182b80182e803")
VOLTAGE = bytes.fromhex("08000100000400810160")
VOLTS = bytes.fromhex("0700010002a470fd40")


def run(*words: str, stdin: bytes = b"") -> subprocess.CompletedProcess[bytes]:
    return run_ev3proto(*words, stdin=stdin)


def entries(*words: str, stdin: bytes = b"") -> list[dict[str, Any]]:
    """Returns the output of `decode --json`, which must not report errors."""
    done = run("decode", "--json", *words, stdin=stdin)
    assert (done.returncode, done.stderr.decode()) == (0, "")
    return [json.loads(line) for line in done.stdout.splitlines()]


def dialogue() -> bytes:
    """A capture: a tone, then a question, and its answer a millisecond later."""
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(TONE)
    connection.send(VOLTAGE)
    connection.receive(VOLTS)
    return capture.data()


def test_a_tree_with_time_place_and_direction(tmp_path: Path) -> None:
    path = tmp_path / "robot.pcap"
    path.write_bytes(dialogue())
    done = run("decode", str(path))
    assert (done.returncode, done.stderr) == (0, b"")
    assert done.stdout.decode() == (
        "0.000000 #1 wifi 192.0.2.10:5555 sent DIRECT_COMMAND_NO_REPLY, counter 42, 16 bytes\n"
        "     7  SOUND.TONE  Plays one tone and returns at once\n"
        "     9    VOLUME    = 1 %  LC0: volume\n"
        "    10    FREQUENCY = 440 Hz  LC2: pitch; the driver clamps it to the range\n"
        "    13    DURATION  = 1000 ms  LC2: duration, read unsigned (-1 is 65535)\n"
        "0.001000 #2 wifi 192.0.2.10:5555 sent DIRECT_COMMAND_REPLY, counter 1, 10 bytes\n"
        "  memory: 4 bytes global, 0 bytes local\n"
        "     7  UI_READ.GET_VBATT  Reads the battery voltage\n"
        "     9    VALUE = GV(0)  GV0: voltage\n"
        "0.002000 #3 wifi 192.0.2.10:5555 received DIRECT_REPLY, counter 1, 9 bytes: ok (1.000 ms after #2)\n"
        "     5  UI_READ.GET_VBATT VALUE = 7.92 V  DATAF\n"
    )


def test_json_with_time_place_and_direction() -> None:
    _, asked, answered = entries(stdin=dialogue())
    assert asked["hex"] == VOLTAGE.hex()
    assert (asked["time"], asked["packets"], asked["direction"]) == ("0.001000", [2], "sent")
    assert (asked["carrier"], asked["source"], asked["target"]) == ("wifi", "192.0.2.1:49152", "192.0.2.10:5555")
    assert (answered["peer"], answered["direction"]) == ("192.0.2.10:5555", "received")
    assert (answered["answers"], answered["latency"]) == (2, 0.001)
    assert [(value["op"], value["name"], value["unit"]) for value in answered["values"]] == [("UI_READ", "VALUE", "V")]


def test_a_line_for_each_dialogue() -> None:
    done = run("decode", "--dialogues", stdin=dialogue())
    assert done.stdout.decode() == (
        "wifi 192.0.2.10:5555\n"
        "    0.000000     #1 SOUND.TONE(VOLUME=1, FREQUENCY=440, DURATION=1000)\n"
        "    0.001000     #2 UI_READ.GET_VBATT(VALUE=GV(0)) -> VALUE=7.92 V  1.000 ms\n"
    )


def test_dialogues_of_two_bricks_name_each_where_it_changes() -> None:
    capture = Capture(RAW_IP)
    first, second = Connection(capture), Connection(capture, ends=(bytes((192, 0, 2, 1)), bytes((192, 0, 2, 11))))
    for connection in (first, first, second, first):
        connection.send(TONE)
    lines = run("decode", "--dialogues", stdin=capture.data()).stdout.decode().splitlines()
    assert [line if line.startswith("wifi") else line.split()[1] for line in lines] == [
        *("wifi 192.0.2.10:5555", "#1", "#2", "wifi 192.0.2.11:5555", "#3", "wifi 192.0.2.10:5555", "#4"),
    ]


def test_dialogues_that_fail() -> None:
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(VOLTAGE)
    connection.receive(bytes.fromhex("0300010004"))  # an error
    connection.receive(VOLTS)  # a reply without a command
    connection.send(VOLTAGE)  # and a command without a reply
    lines = run("decode", "--dialogues", stdin=capture.data()).stdout.decode().splitlines()
    assert lines[0] == "wifi 192.0.2.10:5555"
    assert [line[20:] for line in lines[1:]] == [
        "UI_READ.GET_VBATT(VALUE=GV(0)) -> error  1.000 ms",
        "(a command that was not seen) -> ok  (counter 1)",
        "UI_READ.GET_VBATT(VALUE=GV(0)) -> no reply  (counter 1)",
    ]


def test_dialogues_as_json() -> None:
    done = run("decode", "--dialogues", "--json", stdin=dialogue())
    tone, voltage = (json.loads(line) for line in done.stdout.splitlines())
    assert (tone["command"]["hex"], tone["latency"], "reply" in tone) == (TONE.hex(), None, False)
    assert (voltage["command"]["hex"], voltage["reply"]["hex"], voltage["latency"]) == (
        VOLTAGE.hex(),
        VOLTS.hex(),
        0.001,
    )


@pytest.mark.parametrize(
    ("name", "frames"),
    [
        ("wifi.pcapng", 42),
        ("wifi-reordered.pcap", 14),
        ("usb.pcapng", 25),
        ("usb-plugged.pcap", 9),
        ("usb-windows.pcap", 15),
        ("usb-bootloader.pcapng", 16),
        ("daisy.pcap", 8),
        ("bluetooth.log", 24),
        ("bluetooth.pcapng", 13),
    ],
)
def test_every_capture_of_the_repository(name: str, frames: int) -> None:
    found = entries(str(CAPTURES / name))
    assert len([entry for entry in found if "type" in entry]) == frames
    assert not [entry for entry in found if "fault" in entry]


def test_only_one_capture_is_accepted() -> None:
    assert len(EVERY) == 13


def test_beacons_and_unlocking() -> None:
    found = entries(str(CAPTURES / "wifi.pcapng"))
    assert [(entry["kind"], entry["direction"], entry["packets"]) for entry in found[:5]] == [
        ("beacon", "received", [1]),
        ("beacon", "received", [2]),
        ("answer", "sent", [3]),
        ("unlock", "sent", [7]),
        ("accept", "received", [9]),
    ]
    assert found[0]["text"] == {"serial": "06165300000a", "port": "5555", "name": "myEV3", "protocol": "EV3"}
    assert found[3]["text"] == {"serial": "06165300000a"}


def test_the_name_of_a_file_does_not_matter(tmp_path: Path) -> None:
    source = CAPTURES / "usb.pcapng"
    plain = run("decode", str(source)).stdout
    disguised = tmp_path / "notes.txt"
    shutil.copy(source, disguised)
    packed = tmp_path / "packed"
    packed.write_bytes(gzip.compress(source.read_bytes()))
    assert run("decode", str(disguised)).stdout == plain
    assert run("decode", str(packed)).stdout == plain
    assert run("decode", stdin=source.read_bytes()).stdout == plain
    assert run("decode", "-", stdin=packed.read_bytes()).stdout == plain


def test_text_that_gzip_packed() -> None:
    done = run("decode", "--json", stdin=gzip.compress(TONE.hex().encode()))
    assert json.loads(done.stdout)["hex"] == TONE.hex()


def test_captures_and_frames_in_one_call() -> None:
    found = entries(TONE.hex(), str(CAPTURES / "usb-plugged.pcap"))
    assert len(found) == 10
    assert found[0]["hex"] == TONE.hex()


def test_another_port() -> None:
    capture = Capture(RAW_IP)
    Connection(capture, brick_port=5556).send(TONE)
    assert run("decode", stdin=capture.data()).returncode == 1
    assert entries("--port", "5556", "--port", "5555", stdin=capture.data())[0]["hex"] == TONE.hex()


def test_another_dialect() -> None:
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(TONE)
    connection.send(bytes.fromhex("09000100800000E6606162"))
    done = run("decode", stdin=capture.data())
    assert done.returncode == 1
    assert b"standard input, packet 2: fault at offset 7: " in done.stderr
    assert entries("--dialect", "xtended", stdin=capture.data())[1]["operations"][0]["op"] == "FILE_MD5SUM"


# Bad input: everything readable is printed, an error names the rest, the exit status is 1.


def test_a_file_cut_off_in_the_middle() -> None:
    done = run("decode", "--json", stdin=dialogue()[:-3])
    assert [json.loads(line)["hex"] for line in done.stdout.splitlines()][:2] == [TONE.hex(), VOLTAGE.hex()]
    assert done.returncode == 1
    assert b"standard input: the file is cut off in packet 3: 46 of its 49 bytes are there\n" in done.stderr


def test_a_length_that_lies() -> None:
    data = bytearray(dialogue())
    # The second packet: after the file's header, the first packet's header, and the first packet.
    second = 24 + 16 + 56
    data[second + 8 : second + 12] = (0x7FFFFFFF).to_bytes(4, "little")
    done = run("decode", "--json", stdin=bytes(data))
    assert [json.loads(line)["hex"] for line in done.stdout.splitlines()] == [TONE.hex()]
    assert (done.returncode, done.stderr.decode()) == (
        1,
        "standard input: the file is damaged at offset 96: packet 2 would have 2147483647 bytes; what follows cannot be"
        " read\n",
    )


def test_garbage_in_a_stream() -> None:
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(TONE)
    connection.send(b"\xff\xff\xff" + VOLTAGE)
    connection.receive(VOLTS)
    done = run("decode", "--json", stdin=capture.data())
    found = [json.loads(line) for line in done.stdout.splitlines()]
    assert [entry["hex"] for entry in found] == [TONE.hex(), VOLTAGE.hex(), VOLTS.hex()]
    assert found[2]["answers"] == 2
    assert done.returncode == 1
    assert done.stderr.decode().startswith("standard input, packet 2: 192.0.2.1:49152 to 192.0.2.10:5555: ")


def test_complaints_have_a_limit() -> None:
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    for _ in range(30):
        connection.send(TONE)
        connection.send(b"\xff\xff\xff")
    connection.send(TONE)
    done = run("decode", "--json", stdin=capture.data())
    assert len(done.stdout.splitlines()) == 31
    assert len(done.stderr.splitlines()) == 11
    assert done.stderr.decode().splitlines()[-1] == (
        "standard input: and 20 more places; 90 bytes in all could not be read"
    )


def test_a_capture_without_any_frame() -> None:
    done = run("decode", stdin=Capture(RAW_IP).data())
    assert (done.returncode, done.stdout, done.stderr.decode()) == (
        1,
        b"",
        "standard input: no frame in 0 packets\n",
    )


FAULTY = bytes.fromhex("0700 0100 00 0000 94 77")
"""A command with an unknown CMD, which does not show that it is a brick's."""


@pytest.mark.parametrize(
    ("words", "nothing"),
    [
        (("decode",), "no frame in 2 packets"),
        (("decode", "--dialogues"), "no frame in 2 packets"),
        (("check",), "no command in 2 packets"),
        (("files",), "no frame in 2 packets"),
        (("values",), "no frame in 2 packets"),
        (("timeline", "-o", "x.svg"), "no frame in 2 packets"),
    ],
)
def test_packets_that_are_not_recognised_are_counted(words: tuple[str, ...], nothing: str, tmp_path: Path) -> None:
    capture = Capture(RAW_IP)
    for _ in range(2):
        Connection(capture).send(FAULTY)
    path = tmp_path / "faulty.pcap"
    path.write_bytes(capture.data())
    words = tuple(str(tmp_path / word) if word.endswith("svg") else word for word in words)
    done = run(*words, str(path))
    assert done.returncode == 1
    advice = "2 packets on TCP port 5555 were not recognised; --port 5555 shows them as they are"
    assert done.stderr.decode() == f"{path}: {nothing}; {advice}\n"


CARRIERS = {
    "on TCP port 5555": (RAW_IP, Connection, "--port 5555"),
    "on RFCOMM channel 1": (HCI_WITH_DIRECTION, SerialPort, "--all"),
    "with a USB report of 1024 bytes": (USBMON, Device, "--all"),
}


@pytest.mark.parametrize("place", CARRIERS)
def test_the_option_that_shows_packets_which_are_not_recognised(place: str) -> None:
    link, make, option = CARRIERS[place]
    capture = Capture(link)
    make(capture).send(FAULTY)
    done = run("decode", stdin=capture.data())
    assert (done.returncode, done.stdout) == (1, b"")
    assert done.stderr.decode().endswith(f"; 1 packet {place} was not recognised; {option} shows it as it is\n")
    for words in (option.split(), ["--all"]):
        shown = run("decode", "--json", *words, stdin=capture.data())
        assert [json.loads(line)["hex"] for line in shown.stdout.splitlines()] == [FAULTY.hex()]


def test_packets_are_not_called_unrecognised_when_some_frames_are_shown() -> None:
    capture = Capture(RAW_IP)
    Connection(capture).send(TONE)
    Connection(capture, 40_000).send(FAULTY)
    done = run("decode", "--filter", "counter == 77", stdin=capture.data())
    assert done.stderr.decode() == "standard input: no frame in 2 packets matches the filter\n"


def test_packets_that_were_cut_are_counted_where_no_frame_is_found() -> None:
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    for _ in range(3):
        connection.send(TONE)
    done = run("decode", stdin=cut(capture.data(), 30))
    assert (done.returncode, done.stdout) == (1, b"")
    assert done.stderr.decode() == (
        "standard input: no frame in 3 packets; of 3 packets only the first bytes were captured (snap length)\n"
    )


def test_an_unknown_link_type() -> None:
    capture = Capture(147)
    capture.add(TONE)
    done = run("decode", stdin=capture.data())
    assert done.returncode == 1
    assert "packets of link type 147 were not read" in done.stderr.decode()


@pytest.mark.parametrize(
    ("data", "sentence"),
    [
        (b"PK\x03\x04 a zip archive", "a zip archive; unpack it, and give the files in it"),
        (b"\x7fELF\x02\x01\x01\x00", "neither text nor a capture: it starts with 7F 45 4C 46 02 01 01 00"),
        (b"\x1f\x8b\x08\x00cut", "the gzip stream is cut off or damaged: "),
    ],
)
def test_a_foreign_format(data: bytes, sentence: str) -> None:
    done = run("decode", stdin=data)
    assert (done.returncode, done.stdout) == (1, b"")
    assert done.stderr.decode().startswith(f"standard input: {sentence}")
    assert len(done.stderr.splitlines()) == 1


KINDS = {
    "robot.ev3": (b"PK\x03\x04\x14\0\0\0", "copy the program's .rbf from there"),
    "logs.zip": (b"PK\x03\x04\x14\0\0\0", "a zip archive; unpack it"),
    "pybricks.uf2": (b"UF2\n\x57\x51\x5d\x9e", "a UF2 image"),
    "renamed": (b"UF2\n\x57\x51\x5d\x9e", "a UF2 image"),
    "smile.rgf": (b"\x2c\x2e\x40\x40\x40\x40\x40\x40", "an image of 44 x 46 pixels by its first two bytes"),
    "hello.rsf": (b"\x01\x00\x1d\x20\x1f\x40\0\0", "whose header says 7456 bytes of sound, but 1048568 follow"),
    "renamed.rsf": (b"RIFF\x24\x80\0\0", "a WAV file with the suffix .rsf"),
    "other.rsf": (b"\0\0\1\1\0\0\0\0", "not a sound file of the brick: it starts with 00 00"),
    "game.rxe": (b"MindstormsNXT\0\0\5", "a program for an NXT (.rxe)"),
    "EV3 Firmware V1.09H.bin": (b"\x14\x00\x9f\xe5\x14\xf0\x9f\xe5", "a firmware image"),
}


@pytest.mark.parametrize("name", KINDS)
def test_files_around_the_ev3_are_named(name: str, tmp_path: Path) -> None:
    contents, sentence = KINDS[name]
    path = tmp_path / name
    path.write_bytes(contents * (1 << 17))
    for command in ("decode", "stats", "values"):
        done = run(command, str(path))
        assert (command, done.returncode) == (command, 1)
        assert sentence in done.stderr.decode()
        assert len(done.stderr.splitlines()) == 1


@pytest.mark.parametrize(
    ("name", "contents", "sentence"),
    [
        ("good.rgf", b"\x10\x02" + bytes(4), "UI_DRAW.BMPFILE shows it"),
        ("short.rgf", b"\xb0\x80" + bytes(40), "needs 2816 bytes after them (22 a row), but 40 follow"),
        ("large.rgf", b"\xff\x01" + bytes(32), "255 x 1 pixels, but the brick's display has 178 x 128"),
        ("good.rsf", b"\x01\x00\x00\x02\x1f\x40\0\0" + bytes(2), "SOUND.PLAY plays it"),
        ("short.rsf", b"\x01\x00", "too short: its header has 8 bytes, the file has 2"),
        ("mute.rsf", b"\x01\x00\x00\x02\x00\x00\0\0" + bytes(2), "whose header says 0 Hz"),
    ],
)
def test_what_is_wrong_in_the_header_of_a_file_is_said(
    name: str, contents: bytes, sentence: str, tmp_path: Path
) -> None:
    (tmp_path / name).write_bytes(contents)
    done = run("decode", str(tmp_path / name))
    assert (done.returncode, done.stdout) == (1, b"")
    assert sentence in done.stderr.decode()


# Filters


def test_a_filter() -> None:
    done = run("decode", "--dialogues", "--filter", "op==SOUND.TONE && FREQUENCY>400", stdin=dialogue())
    assert done.stdout.decode().splitlines() == [
        "wifi 192.0.2.10:5555",
        "    0.000000     #1 SOUND.TONE(VOLUME=1, FREQUENCY=440, DURATION=1000)",
    ]
    done = run("decode", "--filter", "FREQUENCY>440", stdin=dialogue())
    assert (done.returncode, done.stderr.decode()) == (
        1,
        "standard input: no frame in 3 packets matches the filter\n",
    )


def test_wireshark_reads_standard_input_from_its_first_byte(tshark: Tshark, tmp_path: Path) -> None:
    """As root, newer versions load no dissector; so a program around tshark keeps what it is to read."""
    capture, kept, program = CAPTURES / "usb.pcapng", tmp_path / "kept", tmp_path / "tshark"
    keep = f'for word; do [ "$last" = -r ] && cp "$word" {kept}; last=$word; done'
    program.write_text(f'#!/bin/sh\n{keep}\nexec {tshark.program} "$@"\n')
    program.chmod(0o755)
    run("decode", "--engine", "wireshark", "--tshark", str(program), stdin=capture.read_bytes())
    assert kept.read_bytes() == capture.read_bytes()


# The progress bar


PROGRAM = "from ev3proto.cli import main, output; output.PATIENCE = {}; main.main()"
"""`ev3proto` as a program with another threshold for long reading."""

AT_ONCE, LATER = 0, 600
"""Thresholds, in seconds: any reading is long, and none is, however fast the computer is."""


def on_a_terminal(patience: int, path: Path, *words: str) -> str:
    """Returns what goes to a terminal on standard error while standard output goes elsewhere."""
    ours, theirs = pty.openpty()
    with subprocess.Popen(
        [sys.executable, "-c", PROGRAM.format(patience), *words, str(path)],
        stdout=subprocess.DEVNULL,
        stderr=theirs,
        cwd=ROOT,
        env={**os.environ, "TERM": "xterm-256color", "COLUMNS": "100"},
    ) as process:
        os.close(theirs)
        shown = b""
        end = time.monotonic() + 60
        while time.monotonic() < end and select.select([ours], [], [], 30)[0]:
            try:
                piece = os.read(ours, 4096)
            except OSError:
                break
            shown += piece
        process.wait(30)
        os.close(ours)
    return shown.decode()


def test_a_progress_bar_on_long_files_only() -> None:
    assert "%" in on_a_terminal(AT_ONCE, CAPTURES / "usb.pcapng", "decode", "--json")
    assert on_a_terminal(LATER, CAPTURES / "usb.pcapng", "decode", "--json") == ""


@pytest.mark.parametrize("words", [("check", "--json"), ("stats",)])
def test_a_progress_bar_on_long_texts_too(tmp_path: Path, words: tuple[str, ...]) -> None:
    path = tmp_path / "long.log"
    lines = (f"12 of the {number} words here are not a frame\n" for number in range(2000))
    path.write_text("".join(lines) + TONE.hex())
    assert "%" in on_a_terminal(AT_ONCE, path, *words)


# Files without a frame


@pytest.mark.parametrize("words", ["decode", "check", "stats", "timeline -o t.html", "export pcapng -o t.pcapng"])
def test_each_of_several_files_that_has_no_frame_is_named(tmp_path: Path, words: str) -> None:
    (tmp_path / "frame.log").write_text("06:00|2A:00|80|00:00|01\n")
    (tmp_path / "words.log").write_text("hello world\n")
    (tmp_path / "empty.log").write_text("")
    (tmp_path / "foreign.pcap").write_bytes(Capture(RAW_IP).data())
    done = run_ev3proto_text(*words.split(), "words.log", "frame.log", "empty.log", "foreign.pcap", cwd=tmp_path)
    assert done.returncode == 1
    named = [line.partition(": no ") for line in done.stderr.splitlines()]
    assert [name for name, _, _ in named] == ["words.log", "empty.log", "foreign.pcap"]
    assert all(rest.startswith(("frame found", "frame in ", "command in ")) for _, _, rest in named)
    assert run_ev3proto_text(*words.split(), "frame.log", cwd=tmp_path).returncode == 0


def test_files_names_a_file_without_frames(tmp_path: Path) -> None:
    (tmp_path / "frame.log").write_text("06:00|2A:00|80|00:00|01\n")
    (tmp_path / "words.log").write_text("hello world\n")
    done = run_ev3proto_text("files", "words.log", "frame.log", cwd=tmp_path)
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.splitlines() == [
        "words.log: no frame found; frames are written in hex, such as 06:00|2A:00|80|00:00|01",
        "frame.log: no file is moved",
    ]
    assert run_ev3proto_text("files", "frame.log", cwd=tmp_path).returncode == 0


def test_a_request_in_place_of_a_reply_is_a_fault_and_no_command() -> None:
    """The fault of the brick's bootloader on USB 3 ports, in packet 24."""
    path = str(CAPTURES / "usb-bootloader.pcapng")
    lines = run("decode", "--dialogues", path).stdout.decode().splitlines()
    _, _, said = lines[1].partition("-> ")
    assert said.startswith("fault: the request came back in place of a reply  4.000 ms  (a known fault of the EV3's")
    counted = json.loads(run("stats", "--json", path).stdout.splitlines()[0])
    assert counted["whole"]["kinds"]["system-command"]["messages"] == 8
