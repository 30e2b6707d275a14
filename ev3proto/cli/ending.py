"""How signals end the command line: Ctrl-C, SIGTERM, a terminal that is closed.

They end it silently. A signal raises an exception, so that temporary folders are removed and other programs are
stopped; the exit status is 128 plus the number of the signal, as in shells: 130 for Ctrl-C.
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
"""Shutdown grace period, in seconds."""

Handler = Callable[[int, object], object]


class Ended(SystemExit):
    """Raised when a signal ends the program."""

    def __init__(self, number: int) -> None:
        super().__init__(_SIGNALLED + number)
        self.number = number


def ended_behind(error: BaseException | None) -> Ended | None:
    """Returns the signal that caused an error, if any: Python 3.11 wraps exceptions while a class is made."""
    cause = error
    while cause is not None and not isinstance(cause, Ended):
        cause = cause.__cause__
    return cause


def _numbers(*, also_ignored: bool = False) -> list[signal.Signals]:
    """Returns the signals that end the program, without those that the parent process ignores.

    Args:
        also_ignored: Include an ignored Ctrl-C. Shells ignore it in processes that scripts start with `&`, and a
            server needs it for an orderly end. An ignored SIGHUP stays ignored, for `nohup`.
    """
    numbers = [signal.Signals[name] for name in _NAMES if hasattr(signal, name)]
    counts = {signal.SIGINT} if also_ignored else set()
    return [number for number in numbers if number in counts or signal.getsignal(number) is not signal.SIG_IGN]


@contextmanager
def _handled_by(handler: Handler, numbers: list[signal.Signals]) -> Iterator[None]:
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
    """Calls `stop` at the first signal; the next one acts as before, and after PATIENCE the first is sent again."""
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
    """Writes pending output without waiting. At exit, Python would wait for a reader that has stopped."""
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
    """Lets a signal raise an exception, and a later one end the program at once."""
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
            # It came during garbage collection, where exceptions are lost: send it again soon.
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
