"""Special files, numbers that are too large, full disks: each gives an error message, never a traceback.

The cause is the caller or the network, so the status is 1 or 2, and no file is left half written.
"""

from __future__ import annotations

import os
import subprocess
import sys
import threading
from collections.abc import Sequence
from pathlib import Path

import pytest
from support.cli import run_ev3proto_text as run
from support.full_disk import full_disk
from support.peak import PEAK

TONE = "0e002a0080000094010182b80182e803"
CAPTURE = "captures/wifi.pcapng"
UNREADABLE = "/proc/self/mem"
"""A file whose first bytes cannot be read, even by root."""

READERS = (
    ("decode",),
    ("check",),
    ("stats",),
    ("values",),
    ("files", "-o", "out"),
    ("timeline", "-o", "out.html"),
    ("encode", "-o", "out"),
    ("export", "pcapng", "-o", "out"),
)


def files_in(folder: Path) -> list[str]:
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*"))


@pytest.mark.parametrize("words", READERS, ids=lambda words: words[0])
def test_a_folder_is_refused_as_input(words: Sequence[str], tmp_path: Path) -> None:
    (tmp_path / "folder").mkdir()
    done = run(*words, "folder", cwd=tmp_path)
    assert (done.returncode, done.stdout) == (1, "")
    assert "folder: cannot be read: Is a directory\n" in done.stderr
    assert "out" not in [name for name in files_in(tmp_path) if (tmp_path / name).is_file()]


@pytest.mark.parametrize("words", READERS, ids=lambda words: words[0])
@pytest.mark.skipif(sys.platform != "linux", reason="only Linux has such a file")
def test_a_file_that_cannot_be_read(words: Sequence[str], tmp_path: Path) -> None:
    done = run(*words, UNREADABLE, cwd=tmp_path)
    assert (done.returncode, done.stdout) == (1, "")
    assert f"{UNREADABLE}: cannot be read: Input/output error\n" in done.stderr
    assert not [name for name in files_in(tmp_path) if (tmp_path / name).is_file()]


@pytest.mark.parametrize("content", [TONE.encode() + b"\n", Path(__file__).parents[2].joinpath(CAPTURE).read_bytes()])
@pytest.mark.parametrize("words", [("decode",), ("check",), ("stats",), ("timeline", "-o", "out.html")], ids=" ".join)
def test_a_named_pipe_is_read_like_a_file(words: Sequence[str], content: bytes, tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes(content)
    os.mkfifo(tmp_path / "pipe")
    expected = run(*words, "file", cwd=tmp_path)
    writer = threading.Thread(target=(tmp_path / "pipe").write_bytes, args=(content,))
    writer.start()
    done = run(*words, "pipe", cwd=tmp_path)
    writer.join(timeout=30)
    assert (done.returncode, done.stdout) == (expected.returncode, expected.stdout.replace("file, ", "pipe, "))
    assert done.stderr == expected.stderr.replace("file", "pipe")


DIGITS = "9" * 400


@pytest.mark.parametrize(
    "text",
    [
        f'{{"type": "DIRECT_COMMAND_NO_REPLY", "counter": {DIGITS}, "operations": []}}',
        f'{{"type": "DIRECT_COMMAND_NO_REPLY", "counter": 1, "globals": {DIGITS}, "operations": []}}',
        f'{{"type": "DIRECT_COMMAND_NO_REPLY", "counter": 1, "operations": [{{"op": "SOUND", "command": "TONE", '
        f'"args": [{{"value": {DIGITS}}}, {{"value": 440}}, {{"value": 1}}]}}]}}',
        f'{{"type": "DIRECT_COMMAND_NO_REPLY", "counter": 1, "operations": [{{"op": "MOVEF_F", "args": '
        f'[{{"value": {DIGITS}}}, {{"kind": "global", "value": 0}}]}}]}}',
        f'{{"type": "DIRECT_COMMAND_NO_REPLY", "counter": 1e{DIGITS}, "operations": []}}',
    ],
    ids=["counter", "globals", "argument", "float", "exponent"],
)
def test_a_number_of_json_with_400_digits(text: str, tmp_path: Path) -> None:
    (tmp_path / "frame.json").write_text(text + "\n")
    done = run("encode", "frame.json", cwd=tmp_path)
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.startswith("frame.json, line 1")
    assert len(done.stderr) < 1000


@pytest.mark.parametrize("number", ["1e60", "1" + "0" * 60, "1" + "0" * 400])
def test_a_filter_with_a_number_beyond_all_values(number: str) -> None:
    above = run("decode", CAPTURE, "--filter", f"FREQUENCY>{number}")
    assert (above.returncode, above.stdout) == (1, "")
    assert above.stderr == f"{CAPTURE}: no frame in 58 packets matches the filter\n"
    below = run("decode", CAPTURE, "--filter", f"FREQUENCY>-{number}")
    assert (below.returncode, below.stderr) == (0, "")
    assert below.stdout.count("SOUND.TONE") == run("decode", CAPTURE).stdout.count("SOUND.TONE")
    assert run("stats", CAPTURE, "--filter", f"FREQUENCY>{number}").stderr == above.stderr


@pytest.mark.parametrize("number", ["0x" + "F" * 5000, "9" * 5000, "-" + "9" * 5000], ids=["hex", "decimal", "minus"])
def test_a_number_of_a_source_with_5000_digits_is_refused(number: str, tmp_path: Path) -> None:
    (tmp_path / "big.lms").write_text(f"vmthread MAIN\n{{\nDATA32 x\nMOVE32_32({number}, x)\n}}\n")
    done = run("encode", "--to", "rbf", "-o", "big.rbf", "big.lms", cwd=tmp_path)
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.startswith("big.lms, line 4, column ")
    assert "has more than 32 bits" in done.stderr
    assert files_in(tmp_path) == ["big.lms"]


@pytest.mark.parametrize(
    ("words", "target"),
    [
        (("export", "all"), "exports"),
        (("export", "c-header", "-o"), "ev3proto.h"),
        (("export", "kaitai", "-o"), "ev3.ksy"),
        (("dissector", "install", "--profile", "--dir"), "plugins"),
    ],
    ids=["all", "c-header", "kaitai", "install"],
)
def test_a_full_disk_leaves_nothing_half(words: Sequence[str], target: str, tmp_path: Path) -> None:
    whole = tmp_path / "whole"
    whole.mkdir()
    assert run(*words, target, cwd=whole).returncode == 0
    full = tmp_path / "full"
    full.mkdir()
    with full_disk(1000):
        done = run(*words, target, cwd=full)
    assert done.returncode == 1
    assert "File too large\n" in done.stderr
    for name in files_in(full):
        if (full / name).is_file():
            assert (full / name).read_bytes() == (whole / name).read_bytes()
    assert len([name for name in files_in(full) if (full / name).is_file()]) < len(files_in(whole))


@pytest.mark.parametrize("words", [("decode",), ("stats",)], ids=" ".join)
def test_raw_frames_are_not_all_kept(words: Sequence[str], tmp_path: Path) -> None:
    """Frames of eight bytes: reading all before showing the first took 350 bytes of memory for each."""
    peaks = []
    for count in (10_000, 40_000):
        (tmp_path / "frames.bin").write_bytes(bytes.fromhex("06002a0080000001") * count)
        call = [sys.executable, "-c", PEAK, *words, "frames.bin"]
        done = subprocess.run(
            call, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=True, cwd=tmp_path
        )
        peaks.append(int(done.stderr.splitlines()[-1]))
    assert peaks[1] - peaks[0] < 5 << 10
