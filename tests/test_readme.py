"""Every command and every program in the README, run; what they print is compared."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
TEXT = (ROOT / "README.md").read_text(encoding="utf-8")
PROGRAMS = re.findall(r"```python\n(.*?)```", TEXT, re.DOTALL)
SESSIONS = re.findall(r"```console\n\$ (.*?)\n(.*?)```", TEXT, re.DOTALL)


def test_the_programs_run_one_after_the_other() -> None:
    assert len(PROGRAMS) == 10
    names: dict[str, object] = {}
    for program in PROGRAMS:
        exec(compile(program, "README.md", "exec"), names)


@pytest.mark.parametrize(("command", "output"), SESSIONS, ids=[command[:50] for command, _ in SESSIONS])
def test_the_commands_print_what_is_shown(command: str, output: str) -> None:
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    done = subprocess.run(
        ["bash", "-c", command],
        cwd=ROOT,
        env={**os.environ, "PATH": path},
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    assert done.stdout == output


def test_there_are_commands() -> None:
    assert len(SESSIONS) == 13


def test_the_files_it_names_are_there() -> None:
    for name in re.findall(r"`((?:bin|tests|captures|benchmarks)/[\w./-]*)", TEXT):
        assert (ROOT / name).exists(), name
