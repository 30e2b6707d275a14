"""Files are complete or do not exist: on a full disk, after a signal, and if they existed before."""

from __future__ import annotations

import contextlib
import gc
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

import pytest
from support.cli import run_ev3proto_text as run
from support.full_disk import full_disk

import ev3proto
from ev3proto.whole_files import GrowingFile, whole_file, write_whole

TONE = "0e002a0080000094010182b80182e803"
FULL = "cannot be written: File too large\n"
WITHIN = 240
"""Seconds in which a process starts, and ends: a machine with many busy programs takes more than 30."""


def contents(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@pytest.mark.parametrize(
    "words",
    [
        ("encode", TONE, "--to", "raw", "-o"),
        ("encode", "vmthread MAIN { SOUND(BREAK) }", "--to", "rbf", "-o"),
        ("export", "json", "-o"),
        ("export", "pcapng", TONE, "-o"),
        ("dissector", "build", "-o"),
        ("timeline", "captures/wifi.pcapng", "-o"),
        ("values", "captures/wifi.pcapng", "--filter", "op==UI_READ.GET_VBATT", "--plot"),
    ],
)
@pytest.mark.parametrize("before", [{}, {"x.svg": b"before"}])
def test_a_full_disk_changes_nothing(words: tuple[str, ...], before: dict[str, bytes], tmp_path: Path) -> None:
    for name, data in before.items():
        (tmp_path / name).write_bytes(data)
    with full_disk(10):
        done = run(*words, tmp_path / "x.svg")
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.endswith(f"{tmp_path}/x.svg: {FULL}")
    assert contents(tmp_path) == before


def moved(*files: tuple[str, bytes]) -> str:
    """Frames that transfer files to a brick, as a log."""
    lines = []
    for handle, (path, data) in enumerate(files):
        begin = ev3proto.system_command("BEGIN_DOWNLOAD", counter=1, size=len(data), path=path, reply=True)
        go_on = ev3proto.system_command("CONTINUE_DOWNLOAD", counter=2, handle=handle, data=data, reply=True)
        answers = b"\x06\x00\x01\x00\x03\x92\x00%c" % handle, b"\x06\x00\x02\x00\x03\x93\x08%c" % handle
        lines += [begin.build(), answers[0], go_on.build(), answers[1]]
    return "\n".join(line.hex(":") for line in lines)


def test_what_came_whole_stays_on_a_full_disk(tmp_path: Path) -> None:
    (tmp_path / "log").write_text(
        moved(("../prjs/a.rbf", b"aa"), ("../prjs/b.rbf", b"b" * 900), ("../prjs/c.rbf", b"cc"))
    )
    with full_disk(100):
        done = run("files", tmp_path / "log", "-o", tmp_path / "out")
    assert done.returncode == 1
    assert done.stderr == f"{tmp_path}/log, line 5: ../prjs/b.rbf: it {FULL}"
    assert contents(tmp_path / "out") == {"prjs/a.rbf": b"aa", "prjs/c.rbf": b"cc"}


def test_the_same_files_once_more_change_nothing(tmp_path: Path) -> None:
    (tmp_path / "log").write_text(moved(("../prjs/a.rbf", b"aa"), ("../prjs/a.rbf", b"other"), ("../prjs/b.rbf", b"b")))
    first = run("files", tmp_path / "log", "-o", tmp_path / "out")
    expected = {"prjs/a.rbf": b"aa", "prjs/a (2).rbf": b"other", "prjs/b.rbf": b"b"}
    assert (first.returncode, contents(tmp_path / "out")) == (0, expected)
    for path in (tmp_path / "out").rglob("*.rbf"):
        os.utime(path, (1, 1))
    again = run("files", tmp_path / "log", "-o", tmp_path / "out")
    assert (again.returncode, again.stdout, contents(tmp_path / "out")) == (0, first.stdout, expected)
    assert {path.stat().st_mtime for path in (tmp_path / "out").rglob("*.rbf")} == {1}


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT, signal.SIGHUP])
@pytest.mark.parametrize("words", [("encode", "--to", "raw", "-o"), ("export", "pcapng", "-o"), ("files", "-", "-o")])
def test_a_signal_in_the_middle(words: tuple[str, ...], number: signal.Signals, tmp_path: Path) -> None:
    target = tmp_path / "out"
    if words[0] == "files":
        target.mkdir()
        (target / "x").write_bytes(b"before")
        data = moved(("../prjs/a.rbf", b"aa"))
    else:
        target.write_bytes(b"before")
        data = f"{TONE}\n" * 5000
    before = contents(tmp_path)
    call = [sys.executable, "-m", "ev3proto", *words, str(target)]
    with subprocess.Popen(call, stdin=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        assert process.stdin is not None
        process.stdin.write(data.encode() + b"\n")
        process.stdin.flush()
        until = time.monotonic() + WITHIN
        while time.monotonic() < until and not list(tmp_path.rglob(".*")):
            time.sleep(0.01)
        assert list(tmp_path.rglob(".*")), "it is writing"
        process.send_signal(number)
        _, said = process.communicate(timeout=WITHIN)
    assert (process.returncode, said) == (128 + number, b"")
    assert contents(tmp_path) == before
    assert not list(tmp_path.rglob(".*"))


def test_a_link_stays_one_and_rights_stay(tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes(b"before")
    (tmp_path / "file").chmod(0o640)
    (tmp_path / "link").symlink_to("file")
    write_whole(tmp_path / "link", b"after")
    assert (tmp_path / "link").is_symlink()
    assert contents(tmp_path) == {"file": b"after", "link": b"after"}
    assert (tmp_path / "file").stat().st_mode & 0o777 == 0o640


def test_a_name_as_long_as_can_be(tmp_path: Path) -> None:
    for name in ("x" * 255, "ä" * 127):
        write_whole(tmp_path / name, b"data")
        assert (tmp_path / name).read_bytes() == b"data"


def test_a_writer_may_fail(tmp_path: Path) -> None:
    def fail(stream: BinaryIO) -> None:
        stream.write(b"half")
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError), whole_file(tmp_path / "x") as stream:
        fail(stream)
    assert contents(tmp_path) == {}


def test_a_recording_grows_by_whole_pieces(tmp_path: Path) -> None:
    file = GrowingFile(tmp_path / "x")
    with full_disk(10):
        file.write(b"12345")
        file.write(b"678")
        file.flush()
        file.write(b"90123")
        with pytest.raises(OSError, match="File too large"):
            file.flush()
        assert contents(tmp_path) == {"x": b"12345678"}
        file.write(b"9")
        file.close()
    assert contents(tmp_path) == {"x": b"123456789"}


@pytest.mark.filterwarnings("error::pytest.PytestUnraisableExceptionWarning")
def test_a_recording_that_cannot_be_opened(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        GrowingFile(tmp_path / "none" / "x")
    gc.collect()


# Rights


def mode(path: Path) -> int:
    return path.stat().st_mode & 0o777


@pytest.fixture
def usual_umask() -> Iterator[None]:
    before = os.umask(0o022)
    yield
    os.umask(before)


@pytest.mark.usefixtures("usual_umask")
def test_what_may_hold_a_pin_can_be_read_by_its_owner_only(tmp_path: Path) -> None:
    (tmp_path / "brick").mkdir()
    with ev3proto.EV3(target=f"virtual:{tmp_path / 'brick'}") as brick:
        brick.download(b"1234", "../prjs/pin.rtf")
        brick.upload("../prjs/pin.rtf", tmp_path / "pin.rtf")
    with contextlib.closing(GrowingFile(tmp_path / "talk.pcapng")) as recording:
        recording.write(b"1234")
        recording.flush()
    (tmp_path / "log").write_text(moved(("../prjs/a.rtf", b"1234")))
    assert run("files", tmp_path / "log", "-o", tmp_path / "files").returncode == 0
    (recovered,) = (path for path in (tmp_path / "files").rglob("*") if path.is_file())
    for path in (tmp_path / "brick/prjs/pin.rtf", tmp_path / "pin.rtf", tmp_path / "talk.pcapng", recovered):
        assert (path.name, mode(path)) == (path.name, 0o600)


@pytest.mark.usefixtures("usual_umask")
def test_a_file_that_is_there_keeps_its_rights(tmp_path: Path) -> None:
    path = tmp_path / "talk.pcapng"
    path.touch(0o640)
    GrowingFile(path).close()
    write_whole(path, b"", is_private=True)
    assert mode(path) == 0o640
    write_whole(tmp_path / "frame.bin", b"")
    assert mode(tmp_path / "frame.bin") == 0o644


def test_a_recording_is_not_emptied_before_there_is_something_to_write(tmp_path: Path) -> None:
    old, new, fifo = tmp_path / "old.pcapng", tmp_path / "new.pcapng", tmp_path / "fifo"
    old.write_bytes(b"old")
    for words in (("proxy", "--to", "wifi:127.0.0.1:1"), ("brick", "--port", "0", "--no-beacon", "--script", "none")):
        for path, more in ((old, ()), (old, ("--force",)), (new, ())):
            done = run(*words, "--record", path, *more)
            assert done.returncode != 0
            assert ("(--force overwrites it)" in done.stderr) == (path is old and not more and words[0] == "proxy")
            assert (old.read_bytes(), new.exists()) == (b"old", False)
    with pytest.raises(FileExistsError):
        GrowingFile(old)
    growing = GrowingFile(old, force=True)
    growing.write(b"new contents")
    assert old.read_bytes() == b"old"
    growing.flush()
    growing.close()
    assert old.read_bytes() == b"new contents"
    GrowingFile(new).close()
    assert not new.exists()
    fifo.write_bytes(b"a file")
    done = run("extcap", "--extcap-interface", "ev3proxy", "--capture", "--fifo", fifo)
    assert (done.returncode, fifo.read_bytes()) == (1, b"a file")
