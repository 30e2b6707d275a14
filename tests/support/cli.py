"""Runs the command line as a user types it, in this process: what it reads, what it prints, its exit status.

A process of its own takes a third of a second to start. A test starts one where the process is the point: a terminal, a
pipe that is closed early, a signal, what is imported.
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
    """`ev3proto WORDS`, in the folder of the project unless another is given.

    Args:
        words: The arguments.
        stdin: What comes on standard input.
        env: The whole environment; that of the tests where it is not given.
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
    """The same with texts in place of bytes."""
    done = run_ev3proto(*words, stdin=stdin.encode() if isinstance(stdin, str) else stdin, env=env, cwd=cwd)
    return subprocess.CompletedProcess(done.args, done.returncode, done.stdout.decode(), done.stderr.decode())


def _status() -> int:
    try:
        main()
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else int(end.code is not None)
    return 0
