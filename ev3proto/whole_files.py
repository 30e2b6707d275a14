"""Files that are written whole or not at all: made beside their place under another name, and put there at the end.

A full disk, a signal or a fault in the middle leaves what was there before, and nothing that looks whole and is not.
Files that others read while they grow, such as recordings, grow by whole pieces.
"""

from __future__ import annotations

import io
import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, BinaryIO

if TYPE_CHECKING:
    from _typeshed import ReadableBuffer

_MOST_NAME = 100
"""Characters of a file's name that its stand-in has in its own, which must not become too long."""


def private(path: str, flags: int) -> int:
    """Opens a file, as an `opener`; a new one can be read by its owner only. Recordings and bricks' files hold PINs."""
    return os.open(path, flags, 0o600)


@contextmanager
def whole_file(path: Path, *, is_private: bool = False) -> Iterator[BinaryIO]:
    """Takes the bytes of a file, which is in its place once the `with` ends without an exception.

    The file keeps the rights of the one that it replaces. A symbolic link stays one, and what it leads to is replaced.
    What is no file, such as a device or a pipe, is written to as it is.

    Args:
        path: Where the file goes.
        is_private: A new file can be read by its owner only.

    Yields:
        What takes the bytes.

    Raises:
        OSError: It cannot be written. `filename` is the path, and what was there before is unchanged.
    """
    target = path.resolve()
    beside = target.with_name(f".{target.name[:_MOST_NAME]}.{os.urandom(4).hex()}")
    try:
        if path.exists() and not path.is_file():
            with path.open("wb") as stream:
                yield stream
            return
        try:
            with open(beside, "xb", opener=private if is_private else None) as stream:
                yield stream
            if target.exists():
                beside.chmod(target.stat().st_mode & 0o7777)
            beside.replace(target)
        finally:
            _remove(beside)
    except OSError as error:
        # The user knows the path that was named, and not the stand-in.
        if error.filename in (None, os.fspath(beside)):
            raise OSError(error.errno, error.strerror or str(error), os.fspath(path)) from error
        raise


def _remove(path: Path) -> None:
    try:
        path.unlink(missing_ok=True)
    except BaseException:  # such as a signal's
        path.unlink(missing_ok=True)
        raise


def write_whole(path: Path, data: bytes, *, is_private: bool = False) -> None:
    """Writes a file that appears only when it is complete; the arguments and errors are those of `whole_file`."""
    with whole_file(path, is_private=is_private) as stream:
        stream.write(data)


class GrowingFile:
    """A recording that grows from flush to flush: what was written between two of them is in it whole, or not at all.

    A new one can be read by its owner only.
    """

    def __init__(self, path: Path) -> None:
        """Opens the file, and empties it. Raises OSError where it cannot be written."""
        self._file = io.FileIO(path, "wb", opener=private)
        self._waiting: list[bytes] = []
        self._size = 0

    def write(self, data: ReadableBuffer, /) -> int:
        """Takes bytes, which are in the file after the next flush."""
        self._waiting.append(bytes(data))
        return len(self._waiting[-1])

    def flush(self) -> None:
        """Writes what waits.

        Raises:
            OSError: Not all of it can be written. The file has none of it then, and it waits no longer.
        """
        data, self._waiting = b"".join(self._waiting), []
        written = 0
        try:
            while written < len(data):
                written += self._file.write(data[written:]) or 0
        except OSError:
            with suppress(OSError):
                self._file.truncate(self._size)
                self._file.seek(self._size)
            raise
        self._size += written

    def close(self) -> None:
        """Writes what waits, and closes the file."""
        if not self._file.closed:
            try:
                self.flush()
            finally:
                self._file.close()
