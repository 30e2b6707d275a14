"""The programs of the lessons, with only their import changed, against a virtual brick on a socket.

Each ends with the lines of the lesson, as comments. Except for times they must be the same; those that the
lesson cuts off are compared up to there.
"""

from __future__ import annotations

import re
import runpy
import time
from pathlib import Path

import pytest
from support.server import served

from ev3proto.brick.servers.server import Options

FOLDER = Path(__file__).parent / "lesson"
PROGRAMS = sorted(FOLDER.glob("*.py"))
TIME = re.compile(r"\d\d:\d\d:\d\d\.\d{6} ")
CUT = "..."


def shown(program: Path) -> list[str]:
    """The lines that the lesson prints, without their times."""
    return [TIME.sub("", line[2:]) for line in program.read_text().splitlines() if line.startswith("# ")]


@pytest.mark.parametrize("program", PROGRAMS, ids=[path.stem for path in PROGRAMS])
def test_a_program_of_the_lesson(
    program: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    with served(tmp_path, Options(port=0, beacon=False)) as brick:
        monkeypatch.setenv("EV3PROTO_TARGET", f"wifi:127.0.0.1:{brick.port}")
        monkeypatch.setattr(time, "sleep", lambda _: None)
        runpy.run_path(str(program))["my_ev3"].close()
    compare(capsys.readouterr().out, program)


def compare(printed: str, program: Path) -> None:
    lines = printed.splitlines()
    assert all(TIME.match(line) for line in lines)
    found = [TIME.sub("", line) for line in lines]
    expected = shown(program)
    assert len(found) == len(expected)
    for line, wanted in zip(found, expected, strict=True):
        if wanted.endswith(CUT):
            assert line.startswith(wanted.removesuffix(CUT))
        else:
            assert line == wanted
