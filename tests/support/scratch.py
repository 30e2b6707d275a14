"""A temporary folder for each session of tests, in which files that the program leaves behind are found.

Processes that tests start use it, too. The folders of pytest itself are elsewhere.
"""

from __future__ import annotations

import os
import shutil
import tempfile
from pathlib import Path

USUAL = "PYTEST_DEBUG_TEMPROOT"
"""The folder of pytest, and of what all sessions on this computer share."""

_VARIABLE = "TMPDIR"
_OURS = ("ev3proto", ".ev3proto", "tmp", "home-")


def usual_folder() -> Path:
    """The folder of temporary files without this module."""
    return Path(os.environ.get(USUAL) or tempfile.gettempdir())


def begin() -> None:
    """Creates the folder, with access for all users: tshark may run as another one."""
    os.environ.setdefault(USUAL, tempfile.gettempdir())
    folder = tempfile.mkdtemp(prefix="ev3proto-tests-")
    Path(folder).chmod(0o1777)
    os.environ[_VARIABLE] = folder
    tempfile.tempdir = None


def end() -> list[str]:
    """Removes the folder. Returns what we left in it; files of other programs are ignored."""
    folder = Path(os.environ.pop(_VARIABLE))
    tempfile.tempdir = None
    left = sorted(path.name for path in folder.iterdir() if path.name.startswith(_OURS))
    shutil.rmtree(folder, ignore_errors=True)
    return left
