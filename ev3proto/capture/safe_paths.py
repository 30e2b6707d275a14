"""Where files from a capture are put on this computer: always inside one folder, whatever the capture calls them."""

from __future__ import annotations

import os
import re
import stat
from collections.abc import Callable
from pathlib import Path

MOST_BYTES = 120
"""Bytes of the name of one file or folder; file systems take 143 at least, and something may be added."""

MOST_FOLDERS = 16
"""Folders in each other; of a deeper path, the innermost are kept."""

_HOME = ("home", "root", "lms2012")
"""The brick's folder for all that is LEGO's. Its programs name files relative to one in it: ../prjs, ../apps."""

_FORBIDDEN = re.compile(r'[\x00-\x1f\x7f-\x9f<>:"|?*\ud800-\udfff]')
_SEPARATOR = re.compile(r"[/\\]")
_RESERVED = re.compile(r"(con|prn|aux|nul|conin\$|conout\$|com[0-9¹²³]|lpt[0-9¹²³])[ ]*(\.|$)", re.IGNORECASE)
"""Names that Windows keeps for devices, whatever extension they have."""

UNNAMED = "unnamed"
"""What a file is called whose path has no name in it."""


def parts_of(path: str) -> tuple[str, ...]:
    """A path of the brick as names of folders and a file, each of which any computer takes: at least one.

    `../prjs/hello/hello.rbf` and `/home/root/lms2012/prjs/hello/hello.rbf` both are prjs, hello, hello.rbf.
    """
    found: list[str] = []
    for part in _SEPARATOR.split(path):
        if part == "..":
            del found[-1:]
        elif part not in ("", "."):
            found.append(part)
    if tuple(found[: len(_HOME)]) == _HOME:
        del found[: len(_HOME)]
    return tuple(safe_name(part) for part in found[-MOST_FOLDERS:]) or (UNNAMED,)


def safe_name(name: str) -> str:
    """A name for a file or folder that is one everywhere, and nothing else."""
    name = _shortened(_FORBIDDEN.sub("_", _SEPARATOR.sub("_", name)).lstrip(" "))
    # Windows forgets dots and spaces at the end: another name would become the same.
    kept = name.rstrip(". ")
    name = kept + "_" * (len(name) - len(kept))
    return f"_{name}" if not name or _RESERVED.match(name) else name


def _shortened(name: str) -> str:
    """No longer than MOST_BYTES, its extension kept where it is a short one."""
    if len(name.encode()) <= MOST_BYTES:
        return name
    stem, dot, extension = name.rpartition(".")
    if not stem or len(extension.encode()) > MOST_BYTES // 4:
        stem, dot, extension = name, "", ""
    room = MOST_BYTES - len((dot + extension).encode())
    return stem.encode()[:room].decode(errors="ignore") + dot + extension


def numbered(name: str, number: int) -> str:
    """`hello (2).rbf`: the same name for the second, the third, ..."""
    if number == 1:
        return name
    stem, dot, extension = name.rpartition(".")
    return f"{stem} ({number}){dot}{extension}" if stem else f"{name} ({number})"


class Shelf:
    """A folder in which files get their places.

    No place is given twice, none that was there before (unless `force`, and then only that of a file), none through a
    symbolic link, and none that some file system takes for another one's: `A` is `a`.
    """

    def __init__(self, folder: Path, *, force: bool = False) -> None:
        self._folder = folder
        self._force = force
        self._folders: dict[tuple[Path, str], Path] = {}
        self._taken: set[tuple[Path, str]] = set()
        self._numbers: dict[tuple[Path, str], int] = {}

    def place(
        self, parts: tuple[str, ...], suffix: str = "", is_same: Callable[[Path], bool] = lambda _path: False
    ) -> Path:
        """Finds a place for a file, and makes its folder.

        Args:
            parts: Names of folders, and of the file.
            suffix: What to add to the file's name, for one that is not whole.
            is_same: Tells of a file that was there before whether it is the one to be written: that is its place.

        Returns:
            The path, which no other file has.

        Raises:
            OSError: The folder cannot be made.
        """
        folder = self._folder
        for part in parts[:-1]:
            folder = self._subfolder(folder, part)
        number = self._numbers.get((folder, _key(parts[-1] + suffix)), 1)
        while True:
            name = numbered(parts[-1], number) + suffix
            path = folder / name
            if (folder, _key(name)) not in self._taken and (self._is_free(path) or (_is_file(path) and is_same(path))):
                break
            number += 1
        self._numbers[folder, _key(parts[-1] + suffix)] = number + 1
        self._taken.add((folder, _key(name)))
        return folder / name

    def _subfolder(self, folder: Path, name: str) -> Path:
        """A folder in another one, made if it is not there; by another name where a file has this one."""
        known = self._folders.get((folder, _key(name)))
        if known is not None:
            return known
        number = 1
        while (found := self._folder_at(folder / numbered(name, number))) is None:
            number += 1
        self._folders[folder, _key(name)] = found
        # It may be there under a name that is the same to some file systems; no file can have it either.
        self._taken.add((folder, _key(found.name)))
        return found

    def _folder_at(self, path: Path) -> Path | None:
        if (path.parent, _key(path.name)) in self._taken:
            return None
        try:
            path.mkdir()
        except FileExistsError:
            # Not through a symbolic link: who knows where it goes.
            return path if stat.S_ISDIR(path.lstat().st_mode) else None
        return path

    def _is_free(self, path: Path) -> bool:
        try:
            mode = path.lstat().st_mode
        except FileNotFoundError:
            return True
        return self._force and not stat.S_ISDIR(mode)


def _is_file(path: Path) -> bool:
    """Whether it is a file, and no link to one."""
    return stat.S_ISREG(path.lstat().st_mode)


def _key(name: str) -> str:
    """The same for names that some file system takes for one."""
    return os.path.normcase(name).casefold()
