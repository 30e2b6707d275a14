"""Folders that are gone when whoever needs them is done, also when a signal's exception comes at a bad moment.

Between the making of a folder and whatever remembers to remove it, an exception may come. Here a folder has its name
before it is made, so that there is nothing in between.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

PREFIX = "ev3proto-"
"""What the names of all of them begin with."""


@contextmanager
def temporary_folder(parent: Path | None = None, prefix: str = PREFIX) -> Iterator[Path]:
    """A folder of one's own, which only this user can look into.

    Args:
        parent: Where it is made; without it, where the system has such things.
        prefix: What its name begins with.

    Yields:
        Its path.

    Raises:
        OSError: It cannot be made.
    """
    if parent is None:
        import tempfile  # takes 9 ms, which only folders of no parent need

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
