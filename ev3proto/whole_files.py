"""Files that are written whole or not at all: made beside their place under another name, and put there at the end.

A full disk, a signal or a fault in the middle leaves what was there before, and nothing that looks whole and is not.
"""

from __future__ import annotations

import os
import secrets
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

_MOST_NAME = 100
"""Characters of a file's name that its stand-in has in its own, which must not become too long."""


@contextmanager
def whole_file(path: Path) -> Iterator[BinaryIO]:
    """Takes the bytes of a file, which is in its place once the `with` ends without an exception.

    The file keeps the rights of the one that it replaces. A symbolic link stays one, and what it leads to is replaced.
    What is no file, such as a device or a pipe, is written to as it is.

    Args:
        path: Where the file goes.

    Yields:
        What takes the bytes.

    Raises:
        OSError: It cannot be written. `filename` is the path, and what was there before is unchanged.
    """
    target = path.resolve()
    beside = target.with_name(f".{target.name[:_MOST_NAME]}.{secrets.token_hex(4)}")
    try:
        if path.exists() and not path.is_file():
            with path.open("wb") as stream:
                yield stream
            return
        try:
            with beside.open("xb") as stream:
                yield stream
            if target.exists():
                beside.chmod(target.stat().st_mode & 0o7777)
            beside.replace(target)
        finally:
            beside.unlink(missing_ok=True)
    except OSError as error:
        # The user knows the path that was named, and not the stand-in.
        if error.filename in (None, os.fspath(beside)):
            raise OSError(error.errno, error.strerror or str(error), os.fspath(path)) from error
        raise


def write_whole(path: Path, data: bytes) -> None:
    """Writes a file that appears only when it is complete; the arguments and errors are those of `whole_file`."""
    with whole_file(path) as stream:
        stream.write(data)
