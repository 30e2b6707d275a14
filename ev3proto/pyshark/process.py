"""A run of tshark: its output as rows of fields, and what became of it.

pyshark makes a packet of everything that tshark knows, and keeps tshark's complaints and exit status to itself. Here
tshark prints a few fields only, and whatever ended it is reported; so it is run without pyshark.
"""

from __future__ import annotations

import contextlib
import json
import shutil
import subprocess
from collections.abc import Callable, Iterator, Sequence
from functools import cache
from threading import Thread, current_thread, main_thread
from typing import IO

from ev3proto.capture.wireshark.events import fields
from ev3proto.capture.wireshark.row import Row
from ev3proto.pyshark.program import EngineError, Program

PATIENCE = 10
"""Seconds that tshark gets to end by itself, once it was asked to or its output has ended."""

_SOON = 1
"""Seconds until nobody waits any more for what it would still print."""

_CHUNK = 1 << 16
_MOST_SAID = 1 << 16
_INDEX = b'{"index"'


class Process:
    """One run of tshark.

    said  the end of what it said on standard error
    """

    def __init__(
        self, program: Program, words: Sequence[str], on_said: Callable[[bytes], None] = lambda _said: None
    ) -> None:
        """Nothing runs before the first of `batches`.

        Args:
            program: The tshark.
            words: Its arguments: how to read, and what.
            on_said: Is called with `said` when there is more of it, from another thread.

        """
        self.said = b""
        self._program = program
        self._words = [program.path, "-n", "-T", "ek", *words]
        for field in fields():
            self._words += ["-e", field]
        self._on_said = on_said
        self._process: subprocess.Popen[bytes] | None = None
        self._is_stopped = False
        self._status: int | None = None

    def batches(self) -> Iterator[list[Row]]:
        """Runs tshark, which has ended when this ends or is closed.

        Yields:
            The rows as they come, several at a time.

        Raises:
            EngineError: Tshark cannot be run.

        """
        try:
            process = subprocess.Popen(
                [*_ended_with_us(), *self._words],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
            )
        except OSError as error:
            raise EngineError(f"{self._program.path} cannot be run: {error.strerror or error}") from error
        with process:
            self._process = process
            assert process.stdout is not None
            assert process.stderr is not None
            listener = Thread(target=self._listen, args=(process.stderr,), daemon=True)
            listener.start()
            try:
                if self._is_stopped:
                    _terminate(process)
                yield from _rows(process.stdout)
                self._status = _wait(process)
            finally:
                _terminate(process)
                _end(process)
                listener.join(PATIENCE)

    def stop(self) -> None:
        """Asks tshark to stop: the rows end after those that came before. Signal handlers may call it."""
        self._is_stopped = True
        if self._process is not None:
            _terminate(self._process)

    def trouble(self) -> str | None:
        """Why tshark ended before all was read, in a sentence; None where all was read, or where it was stopped."""
        if not self._status or (self._is_stopped and self._status < 0):
            return None
        return self._program.complaint(self.said.decode("utf-8", "replace"), self._status)

    def _listen(self, stderr: IO[bytes]) -> None:
        while line := stderr.readline(_CHUNK):
            self.said = (self.said + line)[-_MOST_SAID:]
            self._on_said(self.said)


def _ended_with_us() -> Sequence[str]:
    """What a program is started by, so that it ends when this process is killed, which no process can handle.

    Linux does that when the thread ends that has started it, so it is done for the main thread only.
    """
    return _setpriv() if current_thread() is main_thread() else ()


@cache
def _setpriv() -> Sequence[str]:
    """The program of Linux that starts another one so; nothing where there is none that can."""
    path = shutil.which("setpriv")
    words = () if path is None else (path, "--pdeathsig", "TERM", "--")
    with contextlib.suppress(OSError, subprocess.TimeoutExpired):
        if words and subprocess.run([*words, "true"], capture_output=True, timeout=PATIENCE).returncode == 0:
            return words
    return ()


def _terminate(process: subprocess.Popen[bytes]) -> None:
    # tshark asks the program that captures for it to end, too; it cannot when it is killed.
    with contextlib.suppress(ProcessLookupError):
        process.terminate()


def _end(process: subprocess.Popen[bytes]) -> None:
    """Waits until it has ended, and no longer than that takes when it stops in order."""
    try:
        process.wait(_SOON)
    except subprocess.TimeoutExpired:
        # It has captured more than it has handed over, and ends when it finds out that nobody reads that any more. Its
        # output is not closed before: then it would end without asking the program that captures to end, too.
        assert process.stdout is not None
        process.stdout.close()
        _wait(process)


def _wait(process: subprocess.Popen[bytes]) -> int:
    """Its exit status, once it has ended; it is killed when that takes too long."""
    try:
        return process.wait(PATIENCE)
    except subprocess.TimeoutExpired:
        process.kill()
        return process.wait()


def _rows(stdout: IO[bytes]) -> Iterator[list[Row]]:
    """The rows in what tshark prints: one line of JSON for each packet, with lines for an index between them."""
    rest = b""
    while chunk := stdout.read1(_CHUNK):  # type: ignore[attr-defined]
        whole, _, rest = (rest + chunk).rpartition(b"\n")
        rows = [_row(line) for line in whole.splitlines() if line and not line.startswith(_INDEX)]
        if rows:
            yield rows


def _row(line: bytes) -> Row:
    return Row(json.loads(line.decode("utf-8", "replace"))["layers"])
