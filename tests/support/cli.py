"""Runs the command line in this process, with its input, output and exit status.

Starting another process takes a third of a second. A test does so only if it is about the process: a terminal, a
pipe that is closed early, a signal, imports.
"""

from __future__ import annotations

import contextlib
import io
import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from unittest import mock

from ev3proto.cli.main import main

ROOT = Path(__file__).parents[2]


def run_ev3proto(
    *words: str | Path, stdin: bytes = b"", env: Mapping[str, str] | None = None, cwd: Path = ROOT
) -> subprocess.CompletedProcess[bytes]:
    """Runs `ev3proto WORDS`, by default in the folder of the project.

    Args:
        words: The arguments.
        stdin: The standard input.
        env: The whole environment; by default that of the tests.
        cwd: The folder in which it runs.

    Returns:
        Exit status and output. An exception that would end the program with a traceback is raised.
    """
    arguments = ["ev3proto", *map(str, words)]
    read = io.TextIOWrapper(io.BufferedReader(io.BytesIO(stdin)), "utf-8")
    out, err = (io.TextIOWrapper(io.BytesIO(), "utf-8", write_through=True) for _ in range(2))
    with (
        contextlib.chdir(cwd),
        mock.patch.dict(os.environ, env or {}, clear=env is not None),
        mock.patch.multiple(sys, argv=arguments, stdin=read, stdout=out, stderr=err),
    ):
        status = _status()
    return subprocess.CompletedProcess(arguments, status, out.buffer.getvalue(), err.buffer.getvalue())


def run_ev3proto_text(
    *words: str | Path, stdin: str | bytes = "", env: Mapping[str, str] | None = None, cwd: Path = ROOT
) -> subprocess.CompletedProcess[str]:
    """Does the same with texts instead of bytes."""
    done = run_ev3proto(*words, stdin=stdin.encode() if isinstance(stdin, str) else stdin, env=env, cwd=cwd)
    return subprocess.CompletedProcess(done.args, done.returncode, done.stdout.decode(), done.stderr.decode())


def run_program(
    *words: object, env: Mapping[str, str] | None = None, cwd: Path = ROOT
) -> subprocess.CompletedProcess[str]:
    """Runs a program in a process of its own. The variables are added to those of the tests."""
    environment = {**os.environ, **(env or {})}
    return subprocess.run(
        [str(word) for word in words], cwd=cwd, env=environment, capture_output=True, encoding="utf-8", timeout=120
    )


def _status() -> int:
    try:
        main()
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else int(end.code is not None)
    return 0
