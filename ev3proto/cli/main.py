"""Where the script on the path starts: signals end it silently before anything is loaded that takes time."""

from __future__ import annotations

import atexit
import gc
import os

from ev3proto.cli.ending import ended_by_signals

_OBJECTS = 50_000
"""New objects after which Python collects cyclic garbage. A long capture makes millions of tuples, none of them in a
cycle. Reading one takes twice as long with Python's default of 700."""


def main() -> None:
    """Runs the command line."""
    _open_what_is_closed()
    gc.set_threshold(_OBJECTS)
    atexit.register(gc.freeze)  # ends 18 ms of 115 sooner: Python would look for garbage in all that was loaded
    with ended_by_signals():
        from ev3proto.cli.commands import cli  # takes 70 ms, in which Ctrl-C is to be as silent as later

        cli(prog_name="ev3proto")


def _open_what_is_closed() -> None:
    """Opens nothing in the place of a closed standard stream: the next file would get its number, and its output."""
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)
