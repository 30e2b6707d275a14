"""The brick's files: a folder of this computer serves as /home/root/lms2012, and nothing outside it is reached.

Paths are bytes, as on the brick. A relative one starts in `sys`. A path that leads out of the folder does not exist.
Only files and folders are opened; symbolic links, pipes and others can be listed and deleted.
"""

from __future__ import annotations

import hashlib
import io
import os
import stat
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

from ev3proto.tables.paths import HOME, MOST_PATH, parts

FOLDERS = ("apps", "prjs", "sys", "tools")
"""The folders of a new brick."""

QUOTA = 6000 * 1024
"""Bytes that files may take, as much as the real brick has for its user."""

MOST_ENTRIES = 1_000
"""Files and folders that may be created; existing ones are kept in any case."""

MOST_DEPTH = 32
"""Maximum nesting depth of folders for copying, counting and packing."""

_HIDDEN = (b".", b"CVS")
"""Prefixes of the names that the firmware does not show."""

_OPEN_FLAGS = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)


class Totals(NamedTuple):
    """The totals of a folder."""

    entries: int  # as the directory has them, with . and ..; 0 for a file
    size: int  # bytes of the files


class Storage:
    """The files."""

    def __init__(self, root: str | os.PathLike[str] | None, quota: int = QUOTA) -> None:
        # the folder, in which the firmware's folders are created; None: there are no files
        self.root = None if root is None else Path(root).resolve()
        self.quota = quota  # bytes that all files may take
        self.used = 0
        self._entries = 0
        self._open_inodes: Counter[tuple[int, int]] = Counter()
        if self.root is not None:
            for name in FOLDERS:
                (self.root / name).mkdir(parents=True, exist_ok=True)
            for status in _walk(self.root, MOST_DEPTH):
                self._entries += 1
                if stat.S_ISREG(status.st_mode):
                    self.used += status.st_size

    # Places

    def locate(self, path: bytes) -> Path | None:
        """Returns the path on this computer; None if it leads outside or through something other than a folder."""
        names = parts(path)
        if self.root is None or tuple(names[: len(HOME)]) != HOME:
            return None
        place = self.root
        for part in names[len(HOME) :]:
            if place != self.root and not _is_folder(place):
                return None
            # The brick's name must be a single name here, too, without separators or drives of this system.
            name = os.fsdecode(part)
            if Path(name).name != name:
                return None
            place = place / name
        return place

    def _above(self, path: bytes) -> bytes | None:
        """Returns the only entry of a folder above the brick's files, `/`, `/home` or `/home/root`; None for others."""
        names = parts(path)
        is_above = len(names) < len(HOME) and HOME[: len(names)] == tuple(names)
        return HOME[len(names)] if is_above and self.root is not None and 0 < len(path) <= MOST_PATH else None

    def _place(self, path: bytes, is_meant: Callable[[Path], bool]) -> Path | None:
        """Returns the path on this computer of a file or a folder; None for anything else."""
        place = self.locate(path)
        return place if place is not None and is_meant(place) else None

    def is_file(self, path: bytes) -> bool:
        """Returns whether a path names a file."""
        return self._place(path, _is_file) is not None

    def is_folder(self, path: bytes) -> bool:
        """Returns whether a path names a folder."""
        return self._place(path, _is_folder) is not None or self._above(path) is not None

    # Reading

    def open_to_read(self, path: bytes) -> StoredFile | None:
        """Opens a file to read; None if it does not exist."""
        place = self._place(path, _is_file)
        return None if place is None else self._open(place, os.O_RDONLY, "rb")

    def read(self, path: bytes) -> bytes | None:
        """Reads a whole file; None if it does not exist."""
        return self._contents(self.open_to_read(path))

    @staticmethod
    def _contents(file: StoredFile | None) -> bytes | None:
        if file is None:
            return None
        with file:
            return file.readall()

    def listing(self, path: bytes) -> bytes | None:
        """Returns a folder as LIST_FILES shows it: in reverse order, one line an entry.

        None for an unknown folder. Anything but files, folders and links is omitted.
        """
        place, above = self._place(path, _is_folder), self._above(path)
        if above is not None:
            return above + b"/\n../\n./\n"
        if place is None:
            return None
        lines = []
        for name, status in _entries(place):
            if stat.S_ISDIR(status.st_mode) or stat.S_ISLNK(status.st_mode):
                lines.append(os.fsencode(name) + b"/\n")
            elif stat.S_ISREG(status.st_mode):
                digest = self._digest(place / name)
                lines.append(b"%s %08X %s\n" % (digest, status.st_size & 0xFFFFFFFF, os.fsencode(name)))
        # The folder itself and the one above come first in a folder, so they come last here.
        return b"".join((*reversed(lines), b"../\n", b"./\n"))

    def _digest(self, place: Path) -> bytes:
        """Returns the MD5 in upper case; for an unreadable file that of an empty one."""
        contents = self._contents(self._open(place, os.O_RDONLY, "rb")) or b""
        return hashlib.md5(contents, usedforsecurity=False).hexdigest().upper().encode("ascii")

    def shown(self, path: bytes) -> list[bytes]:
        """Returns the entries that the firmware shows of a folder, in its order; none for anything else."""
        return sorted((name for name in self.entries(path) if not name.startswith(_HIDDEN)), key=_sort_key)

    def entries(self, path: bytes) -> list[bytes]:
        """Returns the names in a folder, without . and ..; none for anything else."""
        place, above = self._place(path, _is_folder), self._above(path)
        if above is not None:
            return [above]
        if place is None:
            return []
        with suppress(OSError), os.scandir(place) as found:
            return [os.fsencode(entry.name) for entry in found]
        return []

    def totals(self, path: bytes) -> Totals:
        """Returns the totals of a folder or file; zeros if it does not exist."""
        place = self.locate(path)
        if place is None:
            return Totals(0, 0)
        if not _is_folder(place):
            return Totals(0, place.lstat().st_size if _is_file(place) else 0)
        found = [status for _, status in _entries(place)]
        return Totals(len(found) + 2, sum(status.st_size for status in found if stat.S_ISREG(status.st_mode)))

    # Writing

    def open_to_write(self, path: bytes, *, append: bool = False) -> StoredFile | None:
        """Opens a file to write: creates a missing one, empties it unless `append`. None if that is impossible."""
        place = self.locate(path)
        if place is None or path.endswith(b"/"):
            return None
        there = _status(place)
        if not (self._may_make() if there is None else stat.S_ISREG(there.st_mode)):
            return None
        flags = os.O_WRONLY | os.O_CREAT | (os.O_APPEND if append else os.O_TRUNC)
        file = self._open(place, flags, "ab" if append else "wb")
        if file is not None:
            if there is None:
                self._entries += 1
            elif not append:
                self.used -= there.st_size
        return file

    @property
    def free(self) -> int:
        """Bytes that are left."""
        return max(0, self.quota - self.used)

    def make_folder(self, path: bytes) -> bool:
        """Creates one folder in an existing one. Returns False if it already exists, or that is impossible."""
        place = self.locate(path)
        if place is None or _status(place) is not None or not self._may_make():
            return False
        try:
            place.mkdir()
        except OSError:
            return False
        self._entries += 1
        return True

    def make_folders(self, path: bytes) -> None:
        """Makes the missing folders of a path that ends in a slash or in a file's name."""
        at = path.find(b"/", 1)
        while at > 0:
            self.make_folder(path[:at])
            at = path.find(b"/", at + 1)

    def delete(self, path: bytes) -> bool:
        """Deletes a file, a link or an empty folder. Returns False if that is impossible."""
        place = self.locate(path)
        status = None if place is None else _status(place)
        if place is None or status is None or place == self.root:
            return False
        try:
            if stat.S_ISDIR(status.st_mode):
                place.rmdir()
            else:
                place.unlink()
        except OSError:
            return False
        self._entries -= 1
        if stat.S_ISREG(status.st_mode) and _inode(status) not in self._open_inodes:
            self.used -= status.st_size
        return True

    def remove(self, path: bytes) -> bool:
        """Deletes a file, or a folder with its files; a folder that contains folders stays, with these."""
        path = path.rstrip(b"/")
        place = self._place(path, _is_folder)
        if place is not None:
            for name, status in _entries(place):
                if not stat.S_ISDIR(status.st_mode):
                    self.delete(path + b"/" + os.fsencode(name))
        return self.delete(path)

    def copy(self, source: bytes, target: bytes, depth: int = MOST_DEPTH) -> bool:
        """Copies a file, or a folder and all that is in it, over the target. Returns False if that is impossible."""
        source, target = source.rstrip(b"/"), target.rstrip(b"/")
        origin, goal = self.locate(source), self.locate(target)
        if origin is None or goal is None or goal.is_relative_to(origin):
            return False
        if _is_file(origin):
            return self._copy_file(source, target)
        if not _is_folder(origin) or depth == 0 or origin.is_relative_to(goal):
            return False
        self._delete_tree(target, depth)
        if not self.make_folder(target):
            return False
        is_whole = True
        for name, _ in _entries(origin):
            below = b"/" + os.fsencode(name)
            is_whole &= self.copy(source + below, target + below, depth - 1)
        return is_whole

    def _copy_file(self, source: bytes, target: bytes) -> bool:
        reader = self.open_to_read(source)
        if reader is None:
            return False
        with reader:
            if self._place(target, _is_folder) is not None:
                self._delete_tree(target, MOST_DEPTH)
            if os.fstat(reader.fileno()).st_size > self.free:
                return False
            writer = self.open_to_write(target)
            if writer is None:
                return False
            with writer:
                return writer.put(reader.readall())

    def _delete_tree(self, path: bytes, depth: int) -> None:
        place = self._place(path, _is_folder) if depth else None
        if place is not None:
            for name, _ in _entries(place):
                self._delete_tree(path + b"/" + os.fsencode(name), depth - 1)
        self.delete(path)

    def _may_make(self) -> bool:
        return self._entries < MOST_ENTRIES

    def _open(self, place: Path, flags: int, mode: str) -> StoredFile | None:
        """Opens a regular file; None for anything else."""
        try:
            descriptor = os.open(place, flags | _OPEN_FLAGS, 0o600)
        except OSError:
            return None
        if not stat.S_ISREG(os.fstat(descriptor).st_mode):
            os.close(descriptor)
            return None
        return StoredFile(self, descriptor, mode)

    def opened(self, inode: tuple[int, int]) -> None:
        """Counts a file that was opened."""
        self._open_inodes[inode] += 1

    def closed(self, inode: tuple[int, int], status: os.stat_result) -> None:
        """Counts a file that is closed; a deleted one takes no room once every user has closed it."""
        self._open_inodes[inode] -= 1
        if not self._open_inodes[inode]:
            del self._open_inodes[inode]
            if not status.st_nlink:
                self.used -= status.st_size


class StoredFile(io.FileIO):
    """An open file, whose bytes count for the quota while they are on the disk."""

    def __init__(self, storage: Storage, descriptor: int, mode: str) -> None:
        """Takes over a descriptor."""
        super().__init__(descriptor, mode)
        self._storage = storage
        self._is_appended = mode == "ab"
        self._inode = _inode(os.fstat(descriptor))
        storage.opened(self._inode)

    def put(self, data: bytes) -> bool:
        """Writes data. Returns False if the quota or the disk is full; a part may have been written."""
        storage, before = self._storage, self._size()
        end = len(data) + (before if self._is_appended else self.tell())
        if storage.used + max(0, end - before) > storage.quota:
            return False
        try:
            return self.write(data) == len(data)
        except OSError:
            return False
        finally:
            storage.used += self._size() - before

    def close(self) -> None:
        """Closes it; a second call does nothing."""
        if not self.closed:
            self._storage.closed(self._inode, os.fstat(self.fileno()))
        super().close()

    def _size(self) -> int:
        return os.fstat(self.fileno()).st_size


def _inode(status: os.stat_result) -> tuple[int, int]:
    return status.st_dev, status.st_ino


def _sort_key(name: bytes) -> tuple[bool, bytes, bytes]:
    """Sorts by extension, which begins at the last point, then by name; names without one come last."""
    point = name.rfind(b".")
    return point < 0, name[point:] if point >= 0 else b"", name


def _walk(place: Path, depth: int) -> Iterator[os.stat_result]:
    """Yields the status of everything in a folder, at any depth."""
    for name, status in _entries(place):
        yield status
        if stat.S_ISDIR(status.st_mode) and depth:
            yield from _walk(place / name, depth - 1)


def _entries(place: Path) -> list[tuple[str, os.stat_result]]:
    """Returns the entries of a folder in its own order, without following links; none if it cannot be read."""
    found = []
    with suppress(OSError), os.scandir(place) as entries:
        for entry in entries:
            with suppress(OSError):
                found.append((entry.name, entry.stat(follow_symlinks=False)))
    return found


def _status(place: Path) -> os.stat_result | None:
    try:
        return place.lstat()
    except (OSError, ValueError):
        return None


def _is_file(place: Path) -> bool:
    status = _status(place)
    return status is not None and stat.S_ISREG(status.st_mode)


def _is_folder(place: Path) -> bool:
    status = _status(place)
    return status is not None and stat.S_ISDIR(status.st_mode)
