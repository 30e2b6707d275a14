"""How the command line ends early: Ctrl-C, a request to terminate, a reader that has gone.

All of that is silent. A signal unwinds the program like any other end, so that temporary folders are removed and child
processes stopped; the exit status is 128 plus the number of the signal, as in shells: 130 for Ctrl-C.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress

_NAMES = ("SIGINT", "SIGTERM", "SIGHUP")

_SIGNALLED = 128
"""Added to a signal's number for the exit status."""

_SAME = 1.0
"""Seconds within which signals count as one: the terminal and the parent process may both send it."""

_SOON = 0.01

PATIENCE = 5.0
"""Shutdown grace period, in seconds: the program may have much left to print, or no reader."""

Handler = Callable[[int, object], object]


class Ended(SystemExit):
    """A signal ends the program."""

    def __init__(self, number: int) -> None:
        super().__init__(_SIGNALLED + number)
        self.number = number


def ended_behind(error: BaseException | None) -> Ended | None:
    """Returns whether an error is the end by a signal.

    Args:
        error: Any, or None. While a class is created, Python 3.11 turns every exception into a RuntimeError.

    Returns:
        The end that caused the error, or None.

    """
    cause = error
    while cause is not None and not isinstance(cause, Ended):
        cause = cause.__cause__
    return cause


def _numbers(*, also_ignored: bool = False) -> list[signal.Signals]:
    """Returns the signals that end the program, without those that were ignored when it started.

    Args:
        also_ignored: Include Ctrl-C even then. Shells ignore it in programs that scripts start with `&`, but servers
            have no other way to end cleanly. Hanging up stays ignored, as `nohup` wants it.
    """
    numbers = [signal.Signals[name] for name in _NAMES if hasattr(signal, name)]
    counts = {signal.SIGINT} if also_ignored else set()
    return [number for number in numbers if number in counts or signal.getsignal(number) is not signal.SIG_IGN]


@contextmanager
def _handled_by(handler: Handler, numbers: list[signal.Signals]) -> Iterator[None]:
    """In this block, a function is called instead of the usual effect of signals."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = {number: signal.signal(number, handler) for number in numbers}
    try:
        yield
    finally:
        for number, former in before.items():
            signal.signal(number, former)


@contextmanager
def stopped_by_signals(stop: Callable[[], object]) -> Iterator[None]:
    """In this block, the first signal stops something cleanly; the next one has its earlier effect.

    If stopping takes longer than PATIENCE, the signal is sent again, until everything has ended.

    Args:
        stop: Called once, between any two steps of the program.
    """
    numbers = _numbers(also_ignored=True)
    before = {number: signal.getsignal(number) for number in numbers}
    over = threading.Event()

    def handle(number: int, _frame: object) -> None:
        for each, former in before.items():
            signal.signal(each, former)
        if before[signal.Signals(number)] is signal.SIG_IGN:
            number = signal.SIGTERM
        threading.Thread(target=_insist, args=(number, over), daemon=True).start()
        stop()

    try:
        with _handled_by(handle, numbers):
            yield
    finally:
        over.set()


def _insist(number: int, over: threading.Event) -> None:
    while not over.wait(PATIENCE):
        os.kill(os.getpid(), number)


def _let_go_of_output() -> None:
    """Writes the remaining output if that is possible at once. At its end, Python would wait for a stuck reader."""
    for stream in (sys.stdout, sys.stderr):
        if stream is None:
            continue
        with suppress(OSError, ValueError):
            number = stream.fileno()
            os.set_blocking(number, False)
            try:
                stream.flush()
            except OSError:
                os.dup2(os.open(os.devnull, os.O_WRONLY), number)
            finally:
                os.set_blocking(number, True)


@contextmanager
def ended_by_signals() -> Iterator[None]:
    """In this block, a signal ends the program by an exception, and a later second one ends it at once."""
    first: float | None = None

    def end(number: int, _frame: object) -> None:
        nonlocal first
        now = time.monotonic()
        if first is None:
            first = now
            raise Ended(number)
        if now - first > _SAME:
            os._exit(_SIGNALLED + number)

    def unraisable(lost: sys.UnraisableHookArgs) -> None:
        nonlocal first
        if isinstance(lost.exc_value, Ended):
            # It came while Python finalised an object, where exceptions are lost: send it again soon.
            first = None
            again = threading.Timer(_SOON, os.kill, (os.getpid(), lost.exc_value.number))
            again.daemon = True
            again.start()
        else:
            before(lost)

    before = sys.unraisablehook
    sys.unraisablehook = unraisable
    try:
        with _handled_by(end, _numbers()):
            yield
    except BaseException as error:
        ended = ended_behind(error)
        if ended is None:
            raise
        _let_go_of_output()
        raise ended from None
    finally:
        sys.unraisablehook = before
