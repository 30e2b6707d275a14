"""The promises of SECURITY.md and the limits of docs/limits.md: each line has a test, here or in the file it names."""

from __future__ import annotations

import math
import re
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest

from ev3proto import bounded, dialogue
from ev3proto.brick import clock
from ev3proto.brick.servers import limits
from ev3proto.capture import conversation, files, packets, record, series, statistics
from ev3proto.capture.carriers.bluetooth import adapters
from ev3proto.capture.carriers.usb import reports
from ev3proto.capture.carriers.wifi import connections, tcp
from ev3proto.capture.filter import language
from ev3proto.capture.finding import MOST_TRIALS
from ev3proto.capture.formats import pcapng
from ev3proto.capture.timeline import collecting
from ev3proto.cli import inputs, live, values
from ev3proto.cli.annotations import MOST_COMPLAINTS
from ev3proto.link import file_moves
from ev3proto.program.checking import MOST_OF_A_CODE
from ev3proto.tables.claims import MOST_HELD, STRANGE_PACKETS
from ev3proto.tables.frame import MAX_FRAME
from ev3proto.tables.memory import ARRAY_ROOM
from ev3proto.tables.program import MAX_IMAGE
from ev3proto.text.paste.pieces import MAX_COLLECTED, MAX_LINE

ROOT = Path(__file__).parents[2]
MIB, KIB = 1 << 20, 1 << 10

LIMITS = {
    "Commands of one connection that wait for a reply": f"{conversation.MOST_PENDING}",
    "Commands with the same counter": f"{dialogue.MOST_PER_KEY}",
    "Files of one connection that wait for the reply to their first command": f"{dialogue.MOST_BEGUN}",
    "Segments of one direction of TCP": f"{tcp.MOST_AHEAD // MIB} MiB, {tcp.MOST_SEGMENTS_AHEAD} segments",
    "TCP connections": f"{connections.MOST_CONNECTIONS}",
    "Consecutive packets without a readable frame, before the first reply to a command": f"{STRANGE_PACKETS}",
    "Bytes of each side of a conversation before it is recognised as a brick's": f"{MAX_FRAME:,}",
    "Packets of one conversation with commands that only their replies would show to be a brick's": f"{MOST_HELD}",
    "Bricks whose beacons are remembered": f"{connections.MOST_BRICKS} addresses and ports",
    "USB devices": f"{reports.MOST_DEVICES}, about 12 MiB",
    "Bluetooth connections, of all adapters": f"{adapters.MOST_CONNECTIONS}, about 8 MiB",
    "Channels of one Bluetooth connection": f"{adapters.MOST_CHANNELS}",
    "Adapters whose own address is remembered": f"{adapters.MOST_ADAPTERS}",
    "Interfaces of a section of a pcapng file": f"{pcapng.MOST_INTERFACES}, names of {pcapng.MOST_NAME:,} bytes",
    "One packet": f"{packets.MOST_PACKET // MIB} MiB",
    "Messages that records keep after they were read": f"{record.MOST_READ}, up to 6 MiB",
    "A line of text": f"{MAX_LINE // MIB} MiB",
    "An array or a dump over several lines": f"{MAX_COLLECTED // KIB} KiB",
    "A file that has only frames": f"{inputs.MOST_RAW // MIB} MiB",
    "A program image": f"{MAX_IMAGE // MIB} MiB, 60 bytes of memory a byte to show or check it",
    "Findings of one code in a program": f"{MOST_OF_A_CODE:,}",
    "A file that `copy` moves, a listing of a folder": f"{file_moves.MOST_FILE // MIB} MiB",
    "Files in a capture": f"{files.MOST_FILES:,}",
    "`stats`: bricks; files; unanswered commands, faults and skipped bytes listed": (
        f"{statistics.MOST_PEERS}; {statistics.MOST_TRANSFERS}; {statistics.MOST_LISTED}"
    ),
    "`timeline`: separate marks": (
        f"{collecting.MOST_MARKS:,}, about 150 MiB with the library that draws them, "
        "400 where all their texts are as long as texts may be"
    ),
    "`check --format sarif`: unreadable places listed": f"{MOST_COMPLAINTS:,}",
    "`values`: rows and values together": f"{series.MOST_CELLS:,}, about 160 MiB",
    "`values`: columns of a table, and with `--csv`": f"{values.MOST_SHOWN}, {values.MOST_COLUMNS['csv']:,}",
    "`values`: cells of a table": f"{values.MOST_PRINTED:,}, about 100 MiB",
    "`live`: beacons that are shown only once": f"{live.MOST_BEACONS}",
    "To show a frame": "10 ms of CPU time; the slowest known one takes 7 ms",
    "To check or fix a frame": "15 ms and 30 ms; the slowest known ones take 10 ms and 22 ms",
    "A frame": f"{MAX_FRAME:,} bytes; a longer one is refused without being read",
    "Empty packets (300 kB of gzip can hold ten million)": ("a million in 0.7 s from pcap, in 2.3 s from pcapng"),
    "Places in one chunk of a stream where a frame is tried": (
        f"{MOST_TRIALS}, as in the dissector; then the chunk is skipped, and reported"
    ),
    "A filter": f"{language.MAX_LENGTH:,} characters, {language.MAX_DEPTH} levels deep",
    "A text for `check --fix`": "64 MiB",
    "Operations of a direct command": f"{clock.MOST_OPERATIONS:,}, and {clock.MOST_PROCESSOR_SECONDS:g} s of CPU time",
    "A direct command that waits": f"{clock.MOST_SECONDS} s; {limits.PATIENCE:g} s if another client waits",
    "Programs and direct commands, before other clients are served": (
        f"{limits.STRETCH * 1000:g} ms of CPU time, and one operation"
    ),
    "An operation that draws": "20 ms of CPU time: shapes are clipped before they are drawn",
    "Clients that have not sent the unlock text; that wait for others; connections to the page": (
        f"{limits.MOST_QUEUED} each"
    ),
    "Open files of the process": "as many as `ulimit -n` says",
    "Frames of all clients that wait for a direct command": f"{clock.MOST_WAITING // MIB} MiB",
    "Arrays of all programs": f"{ARRAY_ROOM:,} bytes",
}


def test_the_limits_are_those_of_the_code() -> None:
    rows = re.findall(r"^\| (.+?) \| (.+?) \|", (ROOT / "docs" / "limits.md").read_text(), re.MULTILINE)
    said = {what: limit for what, limit in rows if what != "What" and not what.startswith("---")}
    assert said == LIMITS
    assert f"{bounded.DEFAULT_MEMORY // MIB} MiB (`--memory`)" in (ROOT / "docs" / "limits.md").read_text()


def test_the_limits_of_the_dissector_are_those_of_its_code() -> None:
    script = (ROOT / "dissector" / "ev3.lua").read_text()

    def limit(name: str) -> int:
        """The value of a constant, also if several are set in one line."""
        found = re.search(rf"local ((?:MOST_\w+, )*{name}(?:, MOST_\w+)*) = ([\d, *]+)$", script, re.MULTILINE)
        assert found, name
        value = found[2].split(",")[found[1].split(", ").index(name)]
        return math.prod(map(int, value.split("*")))

    said = (ROOT / "dissector" / "README.md").read_text().split("## Limits", 1)[1].split("## ", 1)[0]
    assert re.findall(r"^\| [^|]+ \| (.*\d.*?) \|", said, re.MULTILINE) == [
        f"{limit('MOST_PER_COUNTER')}",
        "4,095 bytes",  # a limit of Wireshark
    ]


WATCHED = """
import sys
seen = []
def watch(event, words):
    if event in ("subprocess.Popen", "os.system", "os.exec", "socket.connect", "socket.sendto", "socket.bind"):
        seen.append(f"{event} {words}")
sys.addaudithook(watch)
sys.argv[0] = "ev3proto"
from ev3proto.cli.main import main
try:
    main()
finally:
    print(*seen, sep="\\n", file=sys.stderr)
"""
"""Runs a subcommand, and prints last which programs it started and to whom it sent something."""


@pytest.mark.parametrize(
    "words",
    [
        ("decode", "captures/wifi.pcapng"),
        ("check", "captures/wifi.pcapng"),
        ("stats", "captures/wifi.pcapng"),
        ("files", "captures/usb.pcapng", "-o", "{out}"),
        ("decode", "--programs", "captures/usb.pcapng"),
        ("encode", "DATA32 r SYSTEM('echo hello', r)"),
        ("check", "0b002a0000040060846563686f00"),
    ],
    ids=" ".join,
)
def test_nothing_that_is_read_is_run_and_nothing_is_sent(words: Sequence[str], tmp_path: Path) -> None:
    call = [sys.executable, "-c", WATCHED, *(word.format(out=tmp_path) for word in words)]
    done = subprocess.run(call, capture_output=True, text=True, check=False, cwd=ROOT)
    assert done.returncode in (0, 1), done.stderr
    assert not re.search(r"^(subprocess|os|socket)\.", done.stderr, re.MULTILINE), done.stderr


def test_every_promise_names_where_it_is_tested() -> None:
    promised = (ROOT / "SECURITY.md").read_text().partition("## What is promised")[2].partition("\n## ")[0]
    for promise in re.split(r"^- ", promised, flags=re.MULTILINE)[1:]:
        named = re.findall(r"tests/(\w+/\w+\.py)", promise)
        assert named, promise
        assert all((ROOT / "tests" / name).exists() for name in named), promise
