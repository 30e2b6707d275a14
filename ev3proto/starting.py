"""The first things that the command line does: Ctrl-C ends it silently from now on, also while modules are loaded, and
Python looks for garbage less often, and never in what was loaded.

Loading this module does the first two, because the package's own modules are loaded before any function of the command
line can run. Whoever uses the package in a program of their own keeps their signals as they are.
"""

from __future__ import annotations

import _signal  # type: ignore[import-not-found]  # what `signal` is made of, which takes a while to load
import gc
import os
import sys

_INTERRUPTED = 130

_OBJECTS = 50_000
"""New objects after which Python looks for circles of objects that nobody refers to any more. A long capture makes
millions of tuples, and none of them is in a circle. Reading one takes twice as long with Python's usual 700."""

_SCRIPTS = ("ev3proto", "ev3proto.exe", "ev3proto-script.py")


def is_command_line() -> bool:
    """Whether this process is `ev3proto` or `python -m ev3proto`, and no other program that uses the package."""
    name = sys.argv[0] if getattr(sys, "argv", None) else ""
    if name == "-m":  # what Python has there while it looks for the module that it is to run
        words = sys.orig_argv
        return "-m" in words[:-1] and words[words.index("-m") + 1] == "ev3proto"
    return os.path.basename(name) in _SCRIPTS  # noqa: PTH119 - pathlib takes long to load


def end_silently() -> None:
    """Ends the process without a word when Ctrl-C is pressed. There is nothing yet that would have to be cleaned up."""
    if _signal.getsignal(_signal.SIGINT) is _signal.default_int_handler:
        _signal.signal(_signal.SIGINT, lambda *_: os._exit(_INTERRUPTED))


def keep_what_is_loaded() -> None:
    """Leaves what is loaded out of all further searches for garbage. It stays until the process ends, and the search
    at the end would take a tenth of the time of `ev3proto decode FRAME`.
    """
    if _IS_COMMAND_LINE:
        gc.freeze()


_IS_COMMAND_LINE = is_command_line()  # asked now: Python changes what it has there of `-m` before it runs the module

if _IS_COMMAND_LINE:
    end_silently()
    gc.set_threshold(_OBJECTS)
