"""Texts on the command line: they work like captures, and everything in them is read or reported."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import pytest
from support.cli import run_ev3proto, run_ev3proto_text

LOG = """09:12:31.000 sent 08 00 01 00 00 04 00 81 01 60
09:12:31.010 recv 07 00 01 00 02 a4 70 fd 40
09:12:32.000 Sent 0x|0E:00|2A:00|80|00:00|94|01|01|82:B8:01|82:E8:03|
09:12:33.000 sent 08 00 02 00 00 04 00 81 01 60
"""
TONE = "0e002a0080000094010182b80182e803"


def run(*words: str, stdin: str | bytes = "") -> subprocess.CompletedProcess[bytes]:
    return run_ev3proto(*words, stdin=stdin.encode() if isinstance(stdin, str) else stdin)


def out(*words: str, stdin: str | bytes = "") -> str:
    done = run(*words, stdin=stdin)
    assert done.returncode == 0, done.stderr
    return done.stdout.decode()


@pytest.fixture
def log(tmp_path: Path) -> Path:
    path = tmp_path / "robot.log"
    path.write_text(LOG)
    return path


def test_what_looks_like_a_frame_and_was_not_read_is_reported() -> None:
    text = (
        f"one: {TONE}\ntwo: {TONE[:-2]}\nid d41d8cd98f00b204e9800998ecf8427e 00:16:53:42:2B:99\nthree: {TONE}0000ff\n"
    )
    for command in ("decode", "check"):
        done = run(command, "-", stdin=text)
        assert done.returncode == 1
        assert b"2 lines look like frames and were not read: line 2, column 6: 15 bytes begin a frame" in done.stderr
        assert b"line 4, column 8" in done.stderr
        assert b"line 3" not in done.stderr
    assert b"look like frames" in run("encode", "-", "--to", "hex", stdin=text).stderr
    assert b"look like frames" in run("stats", "-", stdin=text).stderr
    assert b"look like frames" in run("decode", "--dialogues", "-", stdin=text).stderr


def test_dialogues_of_a_text(log: Path) -> None:
    lines = out("decode", "--dialogues", str(log)).splitlines()
    assert lines[0].endswith("VALUE=7.92 V  10.000 ms")
    assert len(lines) == 3
    assert lines[2].endswith("no reply")


def test_a_filter_on_a_text(log: Path) -> None:
    found = out("decode", "--json", "--filter", "op==SOUND.TONE", str(log)).splitlines()
    assert [json.loads(line)["hex"] for line in found] == [TONE]
    assert b"1 frame: " not in run("check", "--filter", "op==UI_READ", str(log)).stderr
    assert run("decode", "--filter", "op==SOUND.PLAY", str(log)).returncode == 1


def test_stats_of_texts_and_captures_together(log: Path, tmp_path: Path) -> None:
    capture = tmp_path / "robot.pcapng"
    out("export", "pcapng", str(log), "-o", str(capture))
    whole = json.loads(out("stats", "--json", str(log), str(capture)))["whole"]
    assert whole["kinds"]["direct-command"]["messages"] == 6
    assert json.loads(out("stats", "--json", str(log)))["whole"]["seconds"] == 2.0


def test_times_survive_the_way_into_a_capture(log: Path, tmp_path: Path) -> None:
    capture = tmp_path / "robot.pcapng"
    out("export", "pcapng", str(log), "-o", str(capture))
    times = [json.loads(line)["time"] for line in out("decode", "--json", str(capture)).splitlines()]
    found = [time for time in times if time]
    assert "2026-01-01T09:12:31.000000" in found[-4]
    assert "2026-01-01T09:12:31.010000" in found[-3]
    assert "2026-01-01T09:12:33.000000" in found[-1]


def test_a_timeline_and_the_files_of_a_text(log: Path, tmp_path: Path) -> None:
    picture = tmp_path / "robot.svg"
    out("timeline", str(log), "-o", str(picture))
    assert "<svg" in picture.read_text()
    moved = "sent 0f 00 01 00 01 92 03 00 00 00 2f 61 2e 74 78 74 00\n"
    assert "/a.txt" in out("files", "-", stdin=moved)


def test_frames_as_raw_bytes() -> None:
    frames = bytes.fromhex(TONE) + bytes.fromhex("0800010000040081 0160")
    shown = [json.loads(line)["hex"] for line in out("decode", "--json", "-", stdin=frames).splitlines()]
    assert shown == [TONE, "08000100000400810160"]
    raw = run("encode", "SOUND(TONE, 1, 440, 1000)", "--to", "raw").stdout
    assert json.loads(out("decode", "--json", "-", stdin=raw))["counter"] == 0
    assert run("decode", "-", stdin=b"\x00\x01\x02garbage").returncode == 1
    assert json.loads(out("stats", "--json", "-", stdin=frames))["whole"]["messages"]["messages"] == 2
    assert len(out("decode", "--dialogues", "-", stdin=frames).splitlines()) == 2


def test_frames_without_their_length_and_operations_alone() -> None:
    content, operations = TONE[4:], TONE[14:]
    assert json.loads(out("decode", "--json", "--no-length", content))["hex"] == TONE
    shown = json.loads(out("decode", "--json", "--operations", operations))
    assert [one["command"] for one in shown["operations"]] == ["TONE"]
    assert json.loads(out("decode", "--json", "--operations", "81 01 60"))["globals"] == 4
    assert b"--no-length" in run("decode", content).stderr
    assert b"--operations" in run("decode", operations).stderr
    assert b"--operations" in run("decode", "-", stdin=f"{operations}\n").stderr


def test_a_program_image_is_called_what_it_is(tmp_path: Path) -> None:
    image = tmp_path / "x.rbf"
    image.write_bytes(b"LEGO" + bytes(40))
    for command in (("stats",), ("files",), ("encode", "--to", "hex")):
        assert b"program image" in run(*command, str(image)).stderr, command


WITHOUT_TIMES = (
    "sent 08 00 01 00 00 04 00 81 01 60\nrecv 07 00 01 00 02 a4 70 fd 40\nsent 08 00 02 00 00 04 00 81 01 60\n"
)


def test_a_text_without_times_has_no_latencies() -> None:
    dialogues = out("decode", "--dialogues", "-", stdin=WITHOUT_TIMES).splitlines()
    assert dialogues[0].endswith("VALUE=7.92 V")
    assert "ms" not in dialogues[0]
    pairs = [json.loads(line) for line in out("decode", "--dialogues", "--json", "-", stdin=WITHOUT_TIMES).splitlines()]
    assert [pair["latency"] for pair in pairs] == [None, None]
    counted = out("stats", "-", stdin=WITHOUT_TIMES)
    assert "Milliseconds" not in counted
    assert "Time" not in counted
    assert json.loads(out("stats", "--json", "-", stdin=WITHOUT_TIMES))["whole"]["latency"] is None
    assert "latency" not in out("values", "-", stdin=WITHOUT_TIMES)


def test_places_in_a_text_are_lines(log: Path, tmp_path: Path) -> None:
    assert "line  what\n   4  UI_READ.GET_VBATT" in out("stats", str(log))
    assert "in 4 frames" in out("stats", str(log))
    assert "line" in out("values", str(log)).splitlines()[0]
    capture = tmp_path / "robot.pcapng"
    out("export", "pcapng", str(log), "-o", str(capture))
    assert "packet  what" in out("stats", str(capture))


def test_what_a_text_says_above_the_bytes_counts_for_them() -> None:
    text = (
        "> 2024/01/31 12:00:00.123456  length=10 from=0 to=9\n 08 00 01 00 00 04 00 81 01 60\n"
        "< 2024/01/31 12:00:00.133456  length=9 from=0 to=8\n 07 00 01 00 02 a4 70 fd 40\n"
    )
    (line,) = out("decode", "--dialogues", "-", stdin=text).splitlines()
    assert line.endswith("VALUE=7.92 V  10.000 ms")


def test_commands_of_a_text_wait_within_the_memory_that_is_given(tmp_path: Path) -> None:
    path = tmp_path / "long.log"
    wide = "fe 03 {:02x} {:02x} 00 04 00" + " 01" * 1017
    path.write_text("".join(wide.format(number & 255, number >> 8) + "\n" for number in range(1200)))
    done = run("stats", "--memory", "1", str(path))
    assert b"unanswered commands were dropped: the memory limit is 1 MiB" in done.stderr


@pytest.mark.parametrize("command", ["stats", "values", "decode", "check"])
def test_what_is_neither_text_nor_capture_is_named_by_its_first_bytes(command: str, tmp_path: Path) -> None:
    path = tmp_path / "junk.bin"
    path.write_bytes(b"abc\x01\x02 that is something else")
    done = run(command, str(path))
    assert done.returncode == 1
    assert b"it starts with 61 62 63 01 02 20 74 68;" in done.stderr


@pytest.mark.parametrize(("count", "sentence"), [(1, "1 byte of padding follows"), (3, "3 bytes of padding follow")])
def test_padding_is_counted(count: int, sentence: str) -> None:
    done = run_ev3proto_text("decode", "06002A0080000001" + "00" * count)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines()[-1] == f"        {sentence} the frame"


def test_a_status_is_explained() -> None:
    """A folder that cannot be created, in the output of decode and of --dialogues."""
    talk = b"Sent 08:00:01:00:01:9b:2f:70:2f:00\nRecv 05:00:01:00:05:9b:05\n"
    meaning = "it cannot be created: it exists, its parent does not, or permission is denied"
    tree = run_ev3proto("decode", stdin=talk).stdout.decode().splitlines()
    at = tree.index("received SYSTEM_REPLY_ERROR, counter 1, 7 bytes: CREATE_DIR NO_PERMISSION")
    assert tree[at + 1] == f"        {meaning}"
    line = run_ev3proto("decode", "--dialogues", stdin=talk).stdout.decode().strip()
    assert line.endswith(f'CREATE_DIR path="/p/" -> NO_PERMISSION ({meaning})')
    reply = json.loads(run_ev3proto("decode", "--json", stdin=talk).stdout.splitlines()[-1])
    assert reply["status_meaning"] == meaning
