"""Temporary folders that are removed after use, even if a signal's exception comes at a bad moment.

An exception may come between the creation of a folder and the code that remembers to remove it. Here the name is
chosen before the folder is created, so there is no such gap.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

PREFIX = "ev3proto-"
"""The prefix of all their names."""


@contextmanager
def temporary_folder(parent: Path | None = None, prefix: str = PREFIX) -> Iterator[Path]:
    """Yields a folder that only this user can read, and removes it at the end of the `with`. Raises OSError."""
    if parent is None:
        import tempfile  # takes 9 ms, needed only without a parent

        parent = Path(tempfile.gettempdir())
    folder = parent / f"{prefix}{os.urandom(8).hex()}"
    is_ours = True
    try:
        try:
            folder.mkdir(mode=0o700)
        except OSError:
            is_ours = False
            raise
        yield folder
    finally:
        if is_ours:
            _remove(folder)


def _remove(folder: Path) -> None:
    try:
        shutil.rmtree(folder, ignore_errors=True)
    except BaseException:
        shutil.rmtree(folder, ignore_errors=True)
        raise
