"""`ev3proto run`: programs on a virtual brick, with the display in the terminal, in a picture or on the page."""

from __future__ import annotations

import contextlib
import os
import pty
import select
import signal
import subprocess
import sys
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from support.cli import run_ev3proto_text

from ev3proto.program import assemble

PATIENCE = 30
"""Seconds: the computer may have a lot else to do."""

SQUARE = """vmthread MAIN
{
  UI_DRAW(FILLRECT, 1, 0, 0, 4, 4)
  UI_DRAW(UPDATE)
}
"""
FOREVER = """vmthread MAIN
{
again:
  SLEEP()
  JR(again)
}
"""
FAILS = """vmthread MAIN
{
  HANDLE none
  ARRAY(RESIZE, none, 5)
}
"""
UNTIL_ENTER = """vmthread MAIN
{
  DATA8 pressed
again:
  UI_BUTTON(SHORTPRESS, ENTER_BUTTON, pressed)
  JR_FALSE(pressed, again)
}
"""


def test_source_and_image(tmp_path: Path) -> None:
    source, image, picture = tmp_path / "square.lms", tmp_path / "square.rbf", tmp_path / "x.png"
    source.write_text(SQUARE)
    image.write_bytes(assemble(SQUARE).image)
    for file in (source, image):
        done = run_ev3proto_text("run", file, "--screenshot", picture)
        assert done.returncode == 0, done.stderr
        lines = done.stdout.splitlines()
        assert len(lines) == 32
        assert lines[0] == "⣿⣿" + "⠀" * 87
        assert done.stderr == ""
    assert picture.read_bytes().startswith(b"\x89PNG")


SLOTS = """
vmthread MAIN
{
  DATA8 state
  PROGRAM_INFO(GET_STATUS, DEBUG_SLOT, state)
  JR_EQ8(state, 16, running)
  UI_DRAW(FILLRECT, FG_COLOR, 0, 64, 178, 64)
running:
  UI_DRAW(UPDATE)
}
"""


def test_a_program_runs_in_another_slot(tmp_path: Path) -> None:
    source = tmp_path / "slots.lms"
    source.write_text(SLOTS)
    black = {}
    for slot in ("user", "debug"):
        done = run_ev3proto_text("run", source, "--slot", slot)
        assert done.returncode == 0, done.stderr
        black[slot] = "⣿" * 89 in done.stdout
    assert black == {"user": True, "debug": False}
    assert run_ev3proto_text("run", source, "--slot", "gui").returncode == 2


def test_a_picture_that_cannot_be_written_is_an_error_before_the_program_runs(tmp_path: Path) -> None:
    source, picture = tmp_path / "square.lms", tmp_path / "nowhere" / "x.png"
    source.write_text(SQUARE)
    done = run_ev3proto_text("run", source, "--screenshot", picture)
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr == f"{picture}: cannot be written: No such file or directory\n"


def test_the_name_of_a_source_stays_on_its_line(tmp_path: Path) -> None:
    source = tmp_path / "a\nb.lms"
    source.write_text("vmthread MAIN {\n    FOO(1)\n}\n")
    done = run_ev3proto_text("run", source)
    assert done.returncode == 1
    assert "a\\u000ab.lms, line 2" in done.stderr.splitlines()[0]


def test_a_file_that_cannot_be_read(tmp_path: Path) -> None:
    missing = tmp_path / "missing"
    for file, reason in ((missing, "No such file or directory"), (tmp_path, "Is a directory")):
        done = run_ev3proto_text("run", file)
        assert (done.returncode, done.stdout, done.stderr) == (1, "", f"{file}: cannot be read: {reason}\n")
    source = tmp_path / "square.lms"
    source.write_text(SQUARE)
    done = run_ev3proto_text("run", source, "--script", missing)
    assert (done.returncode, done.stderr) == (1, f"{missing}: cannot be read: No such file or directory\n")


@pytest.mark.parametrize(
    ("source", "status", "expected"),
    [
        (FAILS, 1, "the program failed: VM_PROGRAM_FAIL_BREAK"),
        (FOREVER, 0, "the program was ended before its own end"),
        ("vmthread MAIN\n{\n  NOPE()\n}\n", 1, "NOPE"),
        ("LEGO", 1, "the brick refuses the program"),
    ],
)
def test_programs_that_do_not_end_well(tmp_path: Path, source: str, status: int, expected: str) -> None:
    file = tmp_path / "x.lms"
    file.write_text(source)
    done = run_ev3proto_text("run", file, "--limit", "0.1")
    assert done.returncode == status
    assert expected in done.stderr


@contextmanager
def started(*words: str | Path, **pipes: Any) -> Iterator[subprocess.Popen[str]]:
    """`ev3proto run` in a process of its own, which is gone afterwards."""
    process = subprocess.Popen([sys.executable, "-m", "ev3proto", "run", *words], text=True, **pipes)
    try:
        yield process
    finally:
        process.kill()
        process.communicate()


def test_keys_of_a_terminal_are_buttons(tmp_path: Path) -> None:
    file = tmp_path / "wait.lms"
    file.write_text(UNTIL_ENTER)
    master, slave = pty.openpty()
    with started(file, stdin=slave, stdout=slave, stderr=slave) as process:
        os.close(slave)
        shown = b""
        while b"LED_GREEN" not in shown:
            assert select.select([master], [], [], PATIENCE)[0], shown
            shown += os.read(master, 65536)
        os.write(master, b"\n")
        with contextlib.suppress(OSError):
            # Reading fails when the terminal has gone.
            while select.select([master], [], [], PATIENCE)[0]:
                shown += os.read(master, 65536)
        assert process.wait(PATIENCE) == 0
        assert b"Traceback" not in shown
    os.close(master)


def test_page_starts_the_program(tmp_path: Path) -> None:
    file = tmp_path / "square.lms"
    file.write_text(SQUARE)
    with started(file, "--http", stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        assert process.stdout is not None
        link = process.stdout.readline().removeprefix("page at ").strip()
        with urllib.request.urlopen(link, timeout=PATIENCE) as response:
            assert response.status == 200
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=PATIENCE)
        assert process.returncode == 0
        assert "Traceback" not in err
