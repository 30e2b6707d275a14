"""A terminal that records the output of a subcommand, and finds control characters in it."""

from __future__ import annotations

import os
import pty
import re
import select
import signal
import subprocess
import sys
import threading
import traceback
import warnings
from importlib import import_module
from pathlib import Path

from ev3proto.cli.commands import SUBCOMMANDS
from ev3proto.cli.main import main

for _name in (*(f"ev3proto.cli.{name}" for name in SUBCOMMANDS), "ev3proto.capture", "rich.console", "rich.table"):
    import_module(_name)  # once for all, and not in every process

_DRAWING = {"timeline", "--plot"}
_PATIENCE = 60
"""Seconds without any output."""

OURS = re.compile("\x1b\\[(0|[12]|(3|9)[0-7])(;(0|[12]|(3|9)[0-7]))*m")
"""The sequences of the colours that the command line uses."""

SCREEN = re.compile("\x1b\\[(\\?25[lh]|2K|1A|0?[JK])")
"""The sequences with which a progress bar, or the display of `run`, moves the cursor."""

_STEERS = re.compile(
    "[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2060-\u206f\ufeff\ud800-\udfff\ufff9-\ufffb]"
)


def on_a_terminal(*words: str | bytes | Path) -> tuple[int, str]:
    """Runs `ev3proto WORDS` in a process whose three standard streams are one terminal.

    Returns:
        The exit status, and all output to the terminal.
    """
    child, terminal = _started([os.fsdecode(word) for word in words])
    shown = b""
    try:
        while True:
            if not select.select([terminal], [], [], _PATIENCE)[0]:
                os.kill(child, signal.SIGKILL)
                raise AssertionError(f"nothing came for {_PATIENCE} s: {words}, {shown[-500:]!r}")
            part = os.read(terminal, 1 << 16)
            if not part:
                break
            shown += part
    except OSError:
        pass  # the other end is closed
    os.close(terminal)
    status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    # The terminal itself turns each new line into a carriage return and a new line.
    return status, shown.decode("utf-8", "surrogateescape").replace("\r\n", "\n")


def _started(words: list[str]) -> tuple[int, int]:
    """The number of the process, and the other end of the terminal."""
    if threading.active_count() == 1 and not _DRAWING & set(words):
        with warnings.catch_warnings():
            # Python 3.12 and later also count threads of libraries, which hold nothing that the child needs.
            warnings.filterwarnings("ignore", "This process .* is multi-threaded", DeprecationWarning)
            child, terminal = pty.fork()
        if child == 0:
            _become_ev3proto(words)
        return child, terminal
    # A process with threads cannot be forked safely, and starting a new one takes longer. The library that draws
    # charts has its own threads, which Python does not know of.
    terminal, end = pty.openpty()
    call = [sys.executable, "-m", "ev3proto", *words]
    child = subprocess.Popen(call, stdin=end, stdout=end, stderr=end, start_new_session=True).pid
    os.close(end)
    return child, terminal


def _become_ev3proto(words: list[str]) -> None:
    status: object = 99
    try:
        sys.argv = ["ev3proto", *words]
        sys.stdin, sys.stdout = open(0, closefd=False), open(1, "w", closefd=False)  # noqa: SIM115
        sys.stderr = open(2, "w", errors="backslashreplace", closefd=False)  # noqa: SIM115
        try:
            main()
        except SystemExit as end:
            status = end.code or 0
        sys.stdout.flush()
    except BaseException:
        traceback.print_exc()
    finally:
        os._exit(status if isinstance(status, int) else 1)


def steering(shown: str, *, draws: bool = False) -> set[str]:
    """Returns what in an output controls the terminal, except colours.

    Args:
        shown: The output to the terminal.
        draws: Whether the cursor may be moved.
    """
    left = OURS.sub("", shown)
    if draws:
        left = SCREEN.sub("", left).replace("\r", "")
    return set(_STEERS.findall(left))
