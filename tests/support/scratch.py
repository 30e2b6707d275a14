"""The folder for temporary files that a session of tests has to itself: what the program leaves behind is seen there.

Processes that tests start have it, too. The folders of pytest's own stay where they always are.
"""

from __future__ import annotations

import os
import shutil
import tempfile
from pathlib import Path

USUAL = "PYTEST_DEBUG_TEMPROOT"
"""Where pytest puts its folders, and where what all sessions on this computer share is."""

_VARIABLE = "TMPDIR"
_OURS = ("ev3proto", ".ev3proto", "tmp", "home-")


def usual_folder() -> Path:
    """Where temporary files would be without this."""
    return Path(os.environ.get(USUAL) or tempfile.gettempdir())


def begin() -> None:
    """Makes the folder, which everybody may use: tshark may run as another user."""
    os.environ.setdefault(USUAL, tempfile.gettempdir())
    folder = tempfile.mkdtemp(prefix="ev3proto-tests-")
    Path(folder).chmod(0o1777)
    os.environ[_VARIABLE] = folder
    tempfile.tempdir = None


def end() -> list[str]:
    """Removes the folder. Returns what was left in it by us; other programs have their own ways."""
    folder = Path(os.environ.pop(_VARIABLE))
    tempfile.tempdir = None
    left = sorted(path.name for path in folder.iterdir() if path.name.startswith(_OURS))
    shutil.rmtree(folder, ignore_errors=True)
    return left
