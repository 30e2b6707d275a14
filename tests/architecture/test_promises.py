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
from ev3proto.brick import images, limits, storage
from ev3proto.brick.operations.strings import MOST_CHARACTERS
from ev3proto.capture import conversation, files, packets, record, series, statistics
from ev3proto.capture.carriers.bluetooth import adapters
from ev3proto.capture.carriers.usb import reports
from ev3proto.capture.carriers.wifi import connections, tcp
from ev3proto.capture.filter import language
from ev3proto.capture.finding import MOST_TRIALS
from ev3proto.capture.formats import pcapng
from ev3proto.capture.timeline import collecting
from ev3proto.cli import live, unblocked, values
from ev3proto.cli.annotations import MOST_COMPLAINTS
from ev3proto.link import file_moves, proxy, reader
from ev3proto.program.checking import MOST_OF_A_CODE
from ev3proto.reading import kinds
from ev3proto.tables.claims import MOST_HELD, STRANGE_PACKETS
from ev3proto.tables.frame import MAX_FRAME
from ev3proto.tables.memory import ARRAY_ROOM
from ev3proto.tables.paths import MOST_PATH
from ev3proto.tables.program import MAX_IMAGE
from ev3proto.text.paste.pieces import MAX_COLLECTED, MAX_LINE

ROOT = Path(__file__).parents[2]
MIB, KIB = 1 << 20, 1 << 10

LIMITS = [
    conversation.MOST_PENDING,
    dialogue.MOST_PER_KEY,
    dialogue.MOST_BEGUN,
    f"{tcp.MOST_AHEAD // MIB} MiB, {tcp.MOST_SEGMENTS_AHEAD} segments",
    connections.MOST_CONNECTIONS,
    STRANGE_PACKETS,
    f"{MAX_FRAME:,}",
    MOST_HELD,
    f"{connections.MOST_BRICKS} addresses and ports",
    f"{reports.MOST_DEVICES}, about 12 MiB",
    f"{adapters.MOST_CONNECTIONS}, about 8 MiB",
    adapters.MOST_CHANNELS,
    adapters.MOST_ADAPTERS,
    f"{pcapng.MOST_INTERFACES}, names of {pcapng.MOST_NAME:,} bytes",
    f"{packets.MOST_PACKET // MIB} MiB",
    f"{record.MOST_READ}, up to 6 MiB",
    f"{MAX_LINE // MIB} MiB",
    f"{MAX_COLLECTED // KIB} KiB",
    f"{kinds.MOST_RAW // MIB} MiB",
    f"{MAX_IMAGE // MIB} MiB, 60 bytes of memory a byte to show or check it",
    f"{MOST_OF_A_CODE:,}",
    f"{file_moves.MOST_FILE // MIB} MiB; {file_moves.MOST_LISTING // MIB} MiB",
    f"{files.MOST_FILES:,}",
    f"{statistics.MOST_PEERS}; {statistics.MOST_TRANSFERS}; {statistics.MOST_LISTED}",
    f"{collecting.MOST_MARKS:,}, about 150 MiB",
    f"{unblocked.MOST_UNREAD // MIB} MiB",
    proxy.MOST_CLIENTS,
    f"{reader.MOST_KEPT // MIB} MiB for each client",
    f"{MOST_COMPLAINTS:,}",
    f"{series.MOST_CELLS:,}, about 160 MiB",
    f"{values.MOST_SHOWN}, {values.MOST_COLUMNS['csv']:,}",
    f"{values.MOST_PRINTED:,}, about 100 MiB",
    live.MOST_BEACONS,
    f"{MAX_FRAME:,} bytes; a longer one is refused without being read",
    f"{MOST_TRIALS}, as in the dissector; then the chunk is skipped, and reported",
    f"{language.MAX_LENGTH:,} characters, {language.MAX_DEPTH} levels deep",
    f"{limits.MOST_OPERATIONS:,}, and {limits.MOST_PROCESSOR_SECONDS:g} s of CPU time"
    f"; {limits.MOST_SPENT:g} s if another client waits",
    f"{limits.MOST_SECONDS} s; {limits.PATIENCE:g} s if another client waits",
    f"{limits.STRETCH * 1000:g} ms of CPU time, and one operation",
    f"{storage.MOST_ENTRIES:,}",
    f"{MOST_CHARACTERS:,} bytes, as in the firmware",
    f"{images.MOST_IMAGES}, and {images.MOST_BYTES:,} bytes",
    f"{MOST_PATH:,} bytes",
    f"{limits.MOST_QUEUED} each",
    f"{limits.MOST_WAITING // MIB} MiB",
    f"{ARRAY_ROOM:,} bytes",
]
"""What the code limits, in the order of the page."""


def test_the_limits_are_those_of_the_code() -> None:
    page = (ROOT / "docs" / "limits.md").read_text()
    rows = iter(re.findall(r"^\| .+? \| (.+?) \|", page, re.MULTILINE))
    for limit in map(str, LIMITS):
        assert any(row.startswith(limit) for row in rows), limit
    assert f"{bounded.DEFAULT_MEMORY // MIB} MiB (`--memory`)" in page


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
