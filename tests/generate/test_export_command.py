"""`ev3proto export` as a user types it, and the files in exports/."""

from __future__ import annotations

import subprocess
from itertools import pairwise
from pathlib import Path

import pytest
from support.cli import run_ev3proto

from ev3proto import capture
from ev3proto.capture import Record
from ev3proto.tables.carriers import CARRIERS

ROOT = Path(__file__).parents[2]
TONE = "0e002a0080000094010182b80182e803"

COMMANDS = {
    "ev3proto.h": "c-header",
    "ev3.ksy": "kaitai",
    "ev3.mjs": "javascript",
    "ev3.d.ts": "javascript --types",
    "ev3-decode.mjs": "javascript --decoder",
    "ev3-decode.d.ts": "javascript --decoder --types",
    "ev3-texts.mjs": "javascript --texts",
    "ev3-texts.d.ts": "javascript --texts --types",
    "ev3-tables.json": "json",
    "ev3-tables.schema.json": "json-schema",
    "ev3-output.schema.json": "output-schema",
    "ev3-vectors.jsonl": "vectors",
}
FILES = {name: (command, (ROOT / "exports" / name).read_text()) for name, command in COMMANDS.items()}

# The group by itself, not as part of another word.


def run(*words: str, stdin: bytes = b"") -> subprocess.CompletedProcess[bytes]:
    return run_ev3proto("export", *words, stdin=stdin)


def frames(path: Path) -> list[str]:
    return [event.frame.hex() for event in capture.read(path).events() if isinstance(event, Record)]


@pytest.mark.parametrize("name", FILES)
def test_every_file_to_standard_output_and_to_a_file(name: str, tmp_path: Path) -> None:
    command, text = FILES[name]
    done = run(*command.split())
    assert (done.returncode, done.stdout, done.stderr) == (0, text.encode(), b"")
    path = tmp_path / name
    assert run(*command.split(), "-o", str(path)).returncode == 0
    assert path.read_bytes() == text.encode()
    done = run(*command.split(), "-o", str(path), "--check")
    assert (done.returncode, done.stdout, done.stderr) == (0, b"", b"")
    path.write_text("old\n")
    done = run(*command.split(), "-o", str(path), "--check")
    assert (done.returncode, done.stdout) == (1, b"")
    assert done.stderr.decode() == f"{path} is out of date; run this without --check to write it again\n"
    assert path.read_text() == "old\n"


def test_all_files_at_once(tmp_path: Path) -> None:
    folder = tmp_path / "new" / "exports"
    assert run("all", str(folder)).returncode == 0
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == {
        path.name: path.read_bytes() for path in (ROOT / "exports").glob("ev3*")
    }
    (folder / "ev3.ksy").unlink()
    (folder / "ev3proto.h").write_text("old\n")
    done = run("all", str(folder), "--check")
    assert done.returncode == 1
    assert done.stderr.decode().splitlines() == [
        f"{folder}/ev3proto.h is out of date; run this without --check to write it again",
        f"{folder}/ev3.ksy: cannot be read: No such file or directory",
    ]


def test_wrong_usage(tmp_path: Path) -> None:
    done = run("json", "--check")
    assert done.returncode == 2
    assert "--check needs -o" in done.stderr.decode()
    done = run("json", "-o", str(tmp_path / "none" / "tables.json"))
    assert done.returncode == 1
    assert done.stderr.decode().endswith("tables.json: cannot be written: No such file or directory\n")
    (tmp_path / "file").write_text("")
    done = run("all", str(tmp_path / "file" / "exports"))
    assert (done.returncode, b"Traceback" in done.stderr) == (1, False)


# Captures


@pytest.mark.parametrize("carrier", CARRIERS)
def test_a_frame_becomes_a_capture(carrier: str, tmp_path: Path) -> None:
    path = tmp_path / "tone.pcapng"
    done = run("pcapng", "--carrier", carrier, TONE, "-o", str(path))
    assert (done.returncode, done.stdout, done.stderr) == (0, b"", b"")
    (record,) = [event for event in capture.read(path).events() if isinstance(event, Record)]
    assert (record.frame.hex(), str(record.carrier), record.direction) == (TONE, carrier, "sent")
    assert list(tmp_path.iterdir()) == [path]


def test_frames_of_a_log_and_of_standard_input(tmp_path: Path) -> None:
    path = tmp_path / "lesson.pcapng"
    assert run("pcapng", "captures/lesson-02.log", "--interval", "2.5", "-o", str(path)).returncode == 0
    found = [event for event in capture.read(path).events() if isinstance(event, Record)]
    assert len(found) == 20
    assert {later.time_ns - sooner.time_ns for sooner, later in pairwise(found)} == {2_500_000}
    done = run("pcapng", stdin=f"{TONE}\n{TONE}\n".encode())
    assert (done.returncode, done.stderr) == (0, b"")
    path.write_bytes(done.stdout)
    assert frames(path) == [TONE, TONE]


def test_a_capture_on_another_carrier(tmp_path: Path) -> None:
    path = tmp_path / "other.pcapng"
    assert run("pcapng", "captures/bluetooth.pcapng", "--carrier", "usb", "-o", str(path)).returncode == 0
    assert frames(path) == frames(ROOT / "captures" / "bluetooth.pcapng")
    times = [
        [event.time_ns for event in capture.read(one).events() if isinstance(event, Record)]
        for one in (path, ROOT / "captures" / "bluetooth.pcapng")
    ]
    assert times[0] == times[1]


def test_the_input_can_be_the_output(tmp_path: Path) -> None:
    path = tmp_path / "same.pcapng"
    path.write_bytes((ROOT / "captures" / "wifi.pcapng").read_bytes())
    before = frames(path)
    assert run("pcapng", str(path), "--carrier", "bluetooth", "-o", str(path)).returncode == 0
    assert frames(path) == before


def test_a_filter_selects_frames(tmp_path: Path) -> None:
    path = tmp_path / "tones.pcapng"
    done = run("pcapng", "captures/wifi.pcapng", "--filter", "op == SOUND.TONE", "-o", str(path))
    assert (done.returncode, len(frames(path))) == (0, 1)
    done = run("pcapng", TONE, "--filter", "op == SOUND.TONE", "-o", str(path))
    assert (done.returncode, len(frames(path))) == (0, 1)


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        ("hello", "'hello' is neither a file nor a frame: 'hello' is not hex"),
        (TONE[:-2], f"'{TONE[:-2]}': it cannot be carried: its length field says that 14 bytes follow, but 13 do"),
        (TONE + "0001", f"'{TONE}0001': it cannot be carried: its length field says that 14 bytes follow, but 16 do"),
    ],
)
def test_frames_that_a_carrier_cannot_carry(given: str, sentence: str, tmp_path: Path) -> None:
    path = tmp_path / "none.pcapng"
    done = run("pcapng", given, "-o", str(path))
    assert (done.returncode, done.stderr.decode()) == (1, f"{sentence}\n")
    assert list(tmp_path.iterdir()) == []


def test_the_other_frames_are_written(tmp_path: Path) -> None:
    path = tmp_path / "some.pcapng"
    done = run("pcapng", TONE, TONE[:-2], TONE, "-o", str(path))
    assert done.returncode == 1
    assert frames(path) == [TONE, TONE]


def test_input_without_frames(tmp_path: Path) -> None:
    path = tmp_path / "kept.pcapng"
    path.write_bytes(b"kept")
    done = run("pcapng", "-o", str(path), stdin=b"nothing but prose\n")
    assert done.returncode == 1
    assert done.stderr.decode().startswith("standard input: no frame found; frames are written in hex")
    assert path.read_bytes() == b"kept"
    done = run("pcapng", stdin=b"")
    assert (done.returncode, done.stdout) == (1, b"")
