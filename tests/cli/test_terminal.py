"""No input reaches a terminal unchanged: every subcommand, with every character that controls a terminal.

The only control sequences are the program's colours, and those that move the cursor for a progress bar or a display.
"""

from __future__ import annotations

import json
import os
import re
import struct
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import pytest
from support.cli import ROOT
from support.packets import RAW_IP, Capture, Connection, datagram
from support.stub_brick import HangUp, reply, stub_brick
from support.terminal import OURS, on_a_terminal, steering
from support.wireshark import Tshark

import ev3proto
from ev3proto.cli.formats import formats_of

READS = """#!{python}
import os, sys
words = sys.argv[1:]
if "-i" in words:
    at = words.index("-i")
    words[at : at + 2] = ["-r", "{capture}"]
os.execv("{tshark}", ["tshark", *words])
"""
"""A tshark that reads a file instead of capturing."""

C0 = "".join(map(chr, range(1, 0x20)))
C1 = "".join(map(chr, range(0x7F, 0xA0)))
DIRECTIONS = "\u061c\u200e\u200f\u2028\u2029\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069\ufeff"
SEQUENCES = "\x1b]52;c;Zm9v\x07\x1b[2J\x9b2J\x1b[38;5;201m\x1b]0;title\x1b\\"

HARMFUL = f"a{SEQUENCES}{C0}{C1}{DIRECTIONS}z"
"""A text, as an argument or in a file."""

IN_FRAMES = (
    b"a" + SEQUENCES.encode("latin-1") + bytes([*range(1, 0x20), *range(0x7F, 0x100)]) + DIRECTIONS.encode() + b"z"
)
"""The same as a brick sends it: bytes that are not UTF-8."""

IN_PATHS = b"a" + HARMFUL.encode()[1:-1].replace(b"\n", b"")[:150] + b"\xff\xed\xa0\x80z"
"""The name of a file, with bytes that become lone surrogates."""

NEW_LINE = b"\n\n06:00|2A:00|80|00:00|01\nSOUND(BREAK)\n"
"""An early end of a comment would make the rest look like frames."""


def harmless(*words: str | bytes | Path, status: int | tuple[int, ...] = 0, draws: bool = False) -> str:
    """Runs a subcommand, which must end with that status and not control the terminal; returns its output."""
    found, shown = on_a_terminal(*words)
    assert not steering(shown, draws=draws), shown
    assert "Traceback" not in shown
    assert found in (status if isinstance(status, tuple) else (status,)), shown
    assert shown
    return shown


def text_of(name: bytes) -> str:
    return name.decode("latin-1")


ASKS = ev3proto.direct_command(
    ev3proto.operation("COM_GET.GET_BRICKNAME", 127, ev3proto.GV(0)), counter=1, reply=True, global_size=127
).build()
ANSWERS = ev3proto.direct_reply(IN_FRAMES[:126].ljust(127, b"\0"), counter=1).build()
DRAWS = ev3proto.direct_command(ev3proto.operation("UI_DRAW.TEXT", 1, 0, 0, text_of(IN_FRAMES))).build()
BEGINS = ev3proto.system_command("BEGIN_DOWNLOAD", counter=2, size=3, path=text_of(b"../prjs/" + IN_FRAMES + b"/x.rbf"))
LISTS = ev3proto.system_command("LIST_FILES", counter=3, max_bytes=1000, path=text_of(IN_FRAMES)).build()
BEACON = b"Serial-Number: %b\r\nPort: 5555\r\nName: %b\r\nProtocol: EV3\r\n"


def program() -> bytes:
    """An image whose only string controls a terminal."""
    code = b"\x84\x05\x01\x00\x00\x84" + IN_FRAMES.replace(b"\0", b"") + b"\0\x0a"
    head = struct.pack("<4sIHHI", b"LEGO", 28 + len(code), 0x6D, 1, 0)
    return head + struct.pack("<IHHI", 28, 0, 0, 0) + code


def frames() -> list[tuple[bool, bytes]]:
    """A dialogue: whether the computer sends it, and the frame."""
    image = program()
    begin = ev3proto.system_command(
        "BEGIN_DOWNLOAD", counter=4, size=len(image), path=text_of(b"../prjs/" + IN_FRAMES + b".rbf")
    )
    go_on = ev3proto.system_command("CONTINUE_DOWNLOAD", counter=5, handle=0, data=image)
    listing = b"0" * 32 + b" 00000003 " + IN_FRAMES.replace(b"\n", b"") + b"\n" + IN_FRAMES + b"/\n"
    return [
        (True, ASKS),
        (False, ANSWERS),
        (True, DRAWS),
        (True, BEGINS.build()),
        (False, bytes.fromhex("0600 0200 05 92 04 00".replace(" ", ""))),
        (True, begin.build()),
        (False, bytes.fromhex("0600 0400 03 92 00 00".replace(" ", ""))),
        (True, go_on.build()),
        (False, bytes.fromhex("0600 0500 03 93 08 00".replace(" ", ""))),
        (True, LISTS),
        (False, struct.pack("<HHBBBIB", 10 + len(listing), 3, 3, 0x99, 8, len(listing), 0) + listing),
        (False, b"\x05\x00" + IN_FRAMES[:5]),
    ]


@pytest.fixture
def capture(tmp_path: Path) -> bytes:
    """The path of a capture: beacon, unlock, frames and other bytes."""
    found = Capture(RAW_IP)
    one_line = IN_FRAMES.replace(b"\r", b"").replace(b"\n", b"")
    for text in (BEACON % (one_line[:60], one_line), BEACON % (b"00", NEW_LINE), IN_FRAMES, b"Name: " + IN_FRAMES):
        found.add(datagram(text))
    connection = Connection(found)
    connection.send(b"GET /target?sn=" + IN_FRAMES.replace(b"\r", b"") + b" VMTP1.0\r\nProtocol: EV3\r\n\r\n")
    connection.receive(b"Accept:EV340\r\n\r\n")
    for is_from_host, frame in frames():
        (connection.send if is_from_host else connection.receive)(frame)
    path = os.fsencode(tmp_path) + b"/" + IN_PATHS
    Path(os.fsdecode(path)).write_bytes(found.data())
    return path


@pytest.fixture
def place(tmp_path: Path) -> bytes:
    """A path that can be made, in a folder of the test."""
    return os.fsencode(tmp_path) + b"/new-" + IN_PATHS


@pytest.mark.parametrize("style", formats_of("message"))
def test_frames(style: str, tmp_path: Path) -> None:
    path = tmp_path / "frames.txt"
    path.write_text("\n".join(frame.hex(":") for _, frame in frames()))
    harmless("decode", "--format", style, path, status=(0, 1))
    harmless("decode", "--format", style, DRAWS.hex())


@pytest.mark.parametrize(
    "words",
    [
        ("decode",),
        ("decode", "--format", "table"),
        ("decode", "--format", "asm"),
        ("decode", "--json"),
        ("decode", "--dialogues"),
        ("decode", "--programs"),
        ("decode", "--programs", "--format", "lego"),
        ("decode", "--programs", "--json"),
        ("check",),
        ("check", "--json"),
        ("check", "--fix"),
        ("check", "--format", "sarif"),
        ("check", "--format", "github"),
        ("encode",),
        ("encode", "--to", "asm"),
        ("encode", "--to", "json"),
        ("encode", "--to", "python"),
        ("encode", "--to", "c"),
        ("stats",),
        ("stats", "--json"),
        ("files",),
        ("files", "--json", "--listings"),
        ("values",),
        ("values", "--csv"),
        ("values", "--json"),
        ("replay", "--to", "virtual", "--dry-run"),
        ("replay", "--to", "virtual", "--fast"),
    ],
)
def test_a_capture(words: tuple[str, ...], capture: bytes) -> None:
    harmless(words[0], capture, *words[1:], status=(0, 1))


def test_files_that_are_written(capture: bytes, place: bytes) -> None:
    harmless("files", capture, "-o", place, status=1)
    harmless("export", "pcapng", capture, "-o", place + b"1", status=1)
    harmless("export", "json", "-o", place + b"/no/such/folder", status=1)
    harmless("export", "json", "--check", "-o", place + b"2", status=1)
    harmless("encode", capture, "-o", place + b"3", status=1)
    harmless("encode", capture, "-o", place + b"/no/such/folder", status=1)
    harmless("timeline", capture, "-o", place + b".svg", status=1)
    harmless("timeline", capture, "-o", place + b".gif", status=2)
    harmless("values", capture, "--plot", place + b".svg", status=(1, 2))
    harmless("dissector", "install", "--dir", place + b"4")
    harmless("dissector", "uninstall", "--dir", place + b"4")
    harmless("dissector", "build", "-o", place + b"/no/such/folder", status=1)


def test_what_assembly_says_comes_back_and_nothing_more(capture: bytes, tmp_path: Path) -> None:
    from support.cli import run_ev3proto

    said = run_ev3proto("decode", "--format", "asm", os.fsdecode(capture)).stdout
    built = run_ev3proto("encode", "--to", "raw", stdin=said).stdout
    assert built == b"".join(frame for _, frame in frames())


def test_a_program(tmp_path: Path) -> None:
    path = os.fsencode(tmp_path) + b"/" + IN_PATHS + b".rbf"
    Path(os.fsdecode(path)).write_bytes(program())
    for style in formats_of("program"):
        harmless("decode", path, "--format", style, status=(0, 1))
    for words in ((), ("--json",), ("--format", "sarif")):
        harmless("check", path, *words, status=(0, 1))
    cut = os.fsencode(tmp_path) + b"/cut " + IN_PATHS + b".rbf"
    Path(os.fsdecode(cut)).write_bytes(program()[:-1])
    harmless("check", cut, "--format", "github", status=1)
    harmless("run", path, "--limit", "1", status=(0, 1), draws=True)


SOURCES = (
    f"SOUND({HARMFUL})",
    f"{HARMFUL}",
    f"SOUND(TONE, 1, 440, 1000) {HARMFUL}",
    f"JR({HARMFUL})",
    f"UI_DRAW(TEXT, 1, 0, 0, '{HARMFUL}'",
    f'message DIRECT_COMMAND_NO_REPLY "{HARMFUL}"',
    f"vmthread {HARMFUL} {{}}",
    f"define {HARMFUL} {HARMFUL}\nvmthread MAIN {{ SOUND({HARMFUL}) }}",
    '{"type": "' + HARMFUL + '"}',
    json.dumps({"kind": HARMFUL, "hex": HARMFUL}),
    json.dumps({"kind": "direct-command", HARMFUL: "\ud800", "operations": [{"op": f"\ud800{HARMFUL}"}]}),
    json.dumps({"kind": "system-command", "command": HARMFUL, "fields": {HARMFUL: 1}}),
    f"06:00|2A:00|80|00:00|01|{HARMFUL}",
    f"{HARMFUL} 06:00|2A:00|80|00:00",
    f"0x|06:00|2A:00|80|00:00|01|  # {HARMFUL}",
)
"""Texts that are faulty, or that have control characters around their frames."""


@pytest.mark.parametrize("number", range(len(SOURCES)))
def test_texts(number: int, tmp_path: Path) -> None:
    text = SOURCES[number]
    path = os.fsencode(tmp_path) + b"/" + IN_PATHS
    Path(os.fsdecode(path)).write_bytes(text.encode("utf-8", "surrogatepass") + b"\xff\xfe")
    for words in (("decode",), ("encode",), ("encode", "--to", "rbf"), ("send", "virtual")):
        harmless(*words, path, status=(0, 1, 2))
    harmless("check", text.replace("\ud800", ""), status=(0, 1, 2))
    harmless("encode", text.replace("\ud800", ""), status=(0, 1, 2))


@pytest.mark.parametrize(
    "words",
    [
        (HARMFUL,),
        ("decode", "--format", HARMFUL),
        ("decode", "--filter", HARMFUL, "x"),
        ("decode", "--filter", f"op == '{HARMFUL}' &&", "x"),
        ("decode", "--engine", "wireshark", "--tshark", HARMFUL, "captures/wifi.pcapng"),
        ("decode", HARMFUL),
        ("check", "--explain", HARMFUL),
        ("ops", HARMFUL),
        ("help", HARMFUL),
        ("sample", "--op", HARMFUL),
        ("sample", "--type", HARMFUL),
        ("stats", HARMFUL),
        ("timeline", HARMFUL, "-o", "x.svg"),
        ("live", "-i", HARMFUL),
        ("live", "-i", "lo", "--tshark", HARMFUL),
        ("send", HARMFUL),
        ("send", f"wifi:{HARMFUL}", "SOUND(BREAK)"),
        ("send", f"serial:{HARMFUL}", "SOUND(BREAK)"),
        ("send", f"usb:{HARMFUL}", "SOUND(BREAK)"),
        ("copy", "virtual", HARMFUL, f"brick:{HARMFUL}"),
        ("copy", "virtual", f"brick:{HARMFUL}", HARMFUL),
        ("replay", HARMFUL, "--to", "virtual"),
        ("replay", "captures/wifi.pcapng", "--to", "virtual", "--allow", HARMFUL),
        ("proxy", "--to", f"serial:{HARMFUL}"),
        ("proxy", "--to", "virtual", "--listen", f"wifi:{HARMFUL}"),
        ("proxy", "--to", "virtual", "--from", HARMFUL),
        ("proxy", "--to", "virtual", "--record", f"/no/{HARMFUL}"),
        ("brick", "--address", HARMFUL),
        ("brick", "--script", HARMFUL),
        ("brick", "--no-wifi", "--http", "--record", f"/no/{HARMFUL}"),
        ("brick", "--no-wifi", "--serial", f"/no/{HARMFUL}"),
        ("brick", "--root", f"/dev/null/{HARMFUL}"),
        ("run", HARMFUL),
        ("export", "all", f"/dev/null/{HARMFUL}"),
        ("dissector", "install", "--dir", f"/dev/null/{HARMFUL}"),
        ("dissector", "install", "--tshark", HARMFUL),
    ],
)
def test_what_was_typed(words: tuple[str, ...]) -> None:
    harmless(*words, status=(1, 2), draws=words[0] == "copy")
    if words[0] not in ("live", "brick", "proxy"):
        no_utf8 = (os.fsencode(word.replace("z", "\udcff\udced\udca0\udc80")) for word in words)
        harmless(*no_utf8, status=(1, 2), draws=words[0] == "copy")


def test_a_script_of_a_brick(tmp_path: Path) -> None:
    path = tmp_path / "script.toml"
    for text in (HARMFUL, f'[ports."{json.dumps(HARMFUL)[1:-1]}"]', f"period = {json.dumps(HARMFUL)}"):
        path.write_text(text)
        harmless("brick", "--script", path, status=1)


def hostile_replies(frame: bytes, send: Callable[[bytes], None]) -> None:
    """Answers with characters that control a terminal."""
    if frame[4] == 0x00:
        send(reply(frame, IN_FRAMES[:126].ljust(127, b"\0")))
    elif frame[5] == 0x99:
        listing = b"0" * 32 + b" 00000003 " + IN_FRAMES.replace(b"\n", b"") + b"\n"
        send(
            struct.pack("<H", 10 + len(listing))
            + frame[2:4]
            + struct.pack("<BBBIB", 3, 0x99, 8, len(listing), 0)
            + listing
        )
    else:
        send(IN_FRAMES)
        raise HangUp


def test_what_a_brick_answers(tmp_path: Path, capture: bytes) -> None:
    with stub_brick(hostile_replies) as port:
        brick = f"wifi:127.0.0.1:{port}"
        harmless("send", brick, ASKS.hex())
        harmless("send", brick, "--json", "--force", ASKS.hex(), LISTS.hex(), status=(0, 1))
        harmless("send", brick, BEGINS.build().hex(), "--timeout", "1", status=1)
        harmless("copy", brick, "brick:x", tmp_path / "x", status=1, draws=True)
        harmless("replay", capture, "--to", brick, "--fast", "--timeout", "0.2", status=1)
    with stub_brick(hostile_replies, accept=IN_FRAMES) as port:
        harmless("send", f"wifi:127.0.0.1:{port}", ASKS.hex(), status=1)


def test_what_tshark_says(tmp_path: Path, tshark: Tshark, capture: bytes, monkeypatch: pytest.MonkeyPatch) -> None:
    """A tshark that reads a file instead of an interface, and one that only reports errors."""
    # This tshark finds the dissector there. The subcommand may run in a copy of this process, or in another one.
    monkeypatch.setattr(tempfile, "tempdir", str(tshark.folder))
    monkeypatch.setenv("TMPDIR", str(tshark.folder))
    copy = tshark.folder / "steering.pcap"
    copy.write_bytes(Path(os.fsdecode(capture)).read_bytes())
    reading, complaining = tmp_path / "reading", tmp_path / "complaining"
    reading.write_text(READS.format(python=sys.executable, tshark=tshark.path, capture=copy))
    said = IN_FRAMES.replace(b"'", b"").replace(b"\n", b"")
    version = b"case $1 in -v) echo 'TShark (Wireshark) 4.2.5.'; exit;; esac"
    complaining.write_bytes(b"#!/bin/sh\n%b\nprintf '%%s\\n' 'tshark: %b' >&2\nexit 2\n" % (version, said))
    for program in (reading, complaining):
        program.chmod(0o755)
    shown = harmless("live", "-i", "any", "--tshark", reading)
    assert "port 5555, name" in shown
    assert "GET_BRICKNAME" in shown
    harmless("live", "-i", "any", "--tshark", complaining, status=1)
    harmless("decode", copy, "--engine", "wireshark", "--tshark", complaining, status=1)


@pytest.mark.parametrize("name", ["stats", "values", "files"])
def test_the_headings_of_tables_have_colours(name: str) -> None:
    shown = harmless(name, "captures/wifi.pcapng")
    assert "\x1b[2m" in shown
    # The listing in this capture contains line feeds.
    assert "\\u" not in shown.replace("\\u000a", "")


@pytest.mark.parametrize("kind", ["dumb", "xterm"])
def test_a_narrow_terminal_cuts_no_number(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    for name, value in {"TERM": kind, "COLUMNS": "20", "LINES": "25", "NO_COLOR": "1"}.items():
        monkeypatch.setenv(name, value)
    shown = harmless("values", ROOT / "captures" / "usb-plugged.pcap", "--filter", "op == UI_READ.GET_VBATT")
    for word in ("time [s]", "0.076790", "0.004", "7.92"):
        assert word in OURS.sub("", shown)


def test_only_one_module_prints() -> None:
    """It escapes everything; the other is a tool of developers."""
    printing = re.compile(r"(?<![.\w])print\(|click\.s?echo\(|std(?:out|err)\.write\(")
    found = {path.name for path in (ROOT / "ev3proto" / "cli").glob("*.py") if printing.search(path.read_text())}
    assert found == {"output.py", "generate.py"}
