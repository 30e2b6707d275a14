"""The bar on a terminal while a long input is read and nothing else is printed there."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, nullcontext

from ev3proto.cli.output import is_terminal

EVERY = 2048
"""Lines or frames after which the bar is drawn again."""

PATIENCE = 1.0
"""Seconds of reading after which there is a bar."""


def progress_bar(
    done: Callable[[], float | None], name: str, *, is_quiet: bool
) -> AbstractContextManager[Callable[[], None]]:
    """A bar, where a terminal watches and nothing else is printed on it.

    Args:
        done: How much of the input was read, 0 to 1; None where its size is not known.
        name: What is read.
        is_quiet: Nothing is printed on standard output while it is read.

    Returns:
        A context that gives what draws the bar when it is called.
    """
    watched = sys.stderr is not None and sys.stderr.isatty() and (is_quiet or not is_terminal())
    return _Bar(done, name) if watched else nullcontext(lambda: None)


def advancing(lines: Iterator[str], advance: Callable[[], None]) -> Iterator[str]:
    """The lines, with a call now and then that draws the bar."""
    for count, line in enumerate(lines):
        if count % EVERY == 0:
            advance()
        yield line


class _Bar:
    """A bar that is drawn once reading takes longer than people like to wait without a word."""

    def __init__(self, done: Callable[[], float | None], name: str) -> None:
        from rich.console import Console  # takes 30 ms, which only terminals have a use for
        from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeRemainingColumn

        self._done = done
        self._started = time.monotonic()
        console = Console(stderr=True)
        text = TextColumn("{task.description}", markup=False)
        columns = (text, BarColumn(), TaskProgressColumn(), TimeRemainingColumn())
        self._progress = Progress(*columns, console=console, transient=True)
        self._task = self._progress.add_task(name, total=None)
        self._is_drawn = False

    def __enter__(self) -> Callable[[], None]:
        return self._advance

    def __exit__(self, *_: object) -> None:
        if self._is_drawn:
            self._progress.stop()

    def _advance(self) -> None:
        if not self._is_drawn:
            if time.monotonic() - self._started < PATIENCE:
                return
            self._progress.start()
            self._is_drawn = True
        done = self._done()
        if done is not None:
            self._progress.update(self._task, total=1.0, completed=done)
