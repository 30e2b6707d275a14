"""Files that are written whole or not at all: created under a temporary name beside their place, renamed at the end.

After a full disk, a signal or an error in the middle, the old file remains, and no partial file looks complete.
Files that are read while they grow, such as recordings, grow by whole pieces.
"""

from __future__ import annotations

import errno
import io
import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, BinaryIO

if TYPE_CHECKING:
    from _typeshed import ReadableBuffer

_MOST_NAME = 100
"""Characters of a file's name that its temporary name contains, which must not become too long."""


def private(path: str, flags: int) -> int:
    """Opens a file, as an `opener`; only its owner can read a new one. Recordings and bricks' files contain PINs."""
    return os.open(path, flags, 0o600)


@contextmanager
def whole_file(path: Path, *, is_private: bool = False) -> Iterator[BinaryIO]:
    """Opens a file for writing; it gets its place when the `with` ends without an exception. Raises OSError.

    The file keeps the permissions of the one it replaces. A symbolic link is kept, and its target is replaced.
    Devices and pipes are written to directly.
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
        # The user knows the given path, not the temporary one.
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
    """A recording that grows from flush to flush: bytes written between two of them are all in the file or not at all.

    Only its owner can read a new one. An existing one with contents is written over only with `force`, and not before
    the first flush.
    """

    def __init__(self, path: Path, *, force: bool = False) -> None:
        """Opens the file. Raises OSError if it cannot be written, FileExistsError if it would be lost."""
        is_file = path.is_file()
        if is_file and path.stat().st_size and not force:
            raise FileExistsError(errno.EEXIST, "it exists, and has contents (--force overwrites it)", str(path))
        self._path, self._is_new, self._is_old = path, not path.exists(), is_file
        # A new file is created exclusively; one that exists keeps its contents for now.
        self._file = io.FileIO(path, "xb" if self._is_new else "ab" if is_file else "wb", opener=private)
        self._waiting: list[bytes] = []
        self._size = 0

    def write(self, data: ReadableBuffer, /) -> int:
        """Buffers bytes, which are in the file after the next flush."""
        self._waiting.append(bytes(data))
        return len(self._waiting[-1])

    def flush(self) -> None:
        """Writes the buffered bytes. Raises OSError; the file then has none of them, and the buffer is discarded."""
        data, self._waiting = b"".join(self._waiting), []
        if data and self._is_old:
            self._is_old = False
            self._file.truncate(0)
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
        """Writes the buffered bytes, unless nothing was ever flushed, and closes the file."""
        if not self._file.closed:
            try:
                if self._size:
                    self.flush()
            finally:
                self._file.close()
                if self._is_new and not self._size:
                    _remove(self._path)
