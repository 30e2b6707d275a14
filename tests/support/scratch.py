"""A temporary folder for each session of tests, in which files that the program leaves behind are found.

Processes that tests start use it, too. The folders of pytest itself are elsewhere.
"""

from __future__ import annotations

import os
import shutil
import tempfile
from pathlib import Path

_FOLDER_OF_PYTEST = "PYTEST_DEBUG_TEMPROOT"
_VARIABLE = "TMPDIR"
_OURS = ("ev3proto", ".ev3proto", "tmp", "home-")


def begin() -> None:
    """Creates the folder, with access for all users: tshark may run as another one."""
    os.environ.setdefault(_FOLDER_OF_PYTEST, tempfile.gettempdir())
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
