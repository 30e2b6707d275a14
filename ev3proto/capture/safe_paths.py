"""Safe places for files from a capture: always inside one folder, whatever their paths are."""

from __future__ import annotations

import os
import re
import stat
from collections.abc import Callable
from pathlib import Path

MOST_BYTES = 120
"""Maximum length of a name in bytes; file systems allow at least 143, and a suffix may be added."""

MOST_FOLDERS = 16
"""Maximum depth of a path; of a deeper one, the innermost folders are kept."""

_HOME = ("home", "root", "lms2012")
"""The folder of LEGO's files on the brick. Its programs use paths relative to one in it: ../prjs, ../apps."""

_FORBIDDEN = re.compile(r'[\x00-\x1f\x7f-\x9f<>:"|?*\ud800-\udfff]')
_SEPARATOR = re.compile(r"[/\\]")
_RESERVED = re.compile(r"(con|prn|aux|nul|conin\$|conout\$|com[0-9¹²³]|lpt[0-9¹²³])[ ]*(\.|$)", re.IGNORECASE)
"""Names that Windows reserves for devices, with any extension."""

UNNAMED = "unnamed"
"""The name of a file whose path has no name."""


def parts_of(path: str) -> tuple[str, ...]:
    """Returns a path of the brick as names of folders and a file, at least one, each valid on any computer.

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
    """Returns a name for a file or folder that is valid on any computer."""
    name = _shortened(_FORBIDDEN.sub("_", _SEPARATOR.sub("_", name)).lstrip(" "))
    # Windows drops trailing dots and spaces: different names would become the same.
    kept = name.rstrip(". ")
    name = kept + "_" * (len(name) - len(kept))
    return f"_{name}" if not name or _RESERVED.match(name) else name


def _shortened(name: str) -> str:
    if len(name.encode()) <= MOST_BYTES:
        return name
    stem, dot, extension = name.rpartition(".")
    if not stem or len(extension.encode()) > MOST_BYTES // 4:
        stem, dot, extension = name, "", ""
    room = MOST_BYTES - len((dot + extension).encode())
    return stem.encode()[:room].decode(errors="ignore") + dot + extension


def numbered(name: str, number: int) -> str:
    """Returns a name with a number, `hello (2).rbf`, from the second on."""
    if number == 1:
        return name
    stem, dot, extension = name.rpartition(".")
    return f"{stem} ({number}){dot}{extension}" if stem else f"{name} ({number})"


class Shelf:
    """A folder in which each file gets a path of its own.

    No path is used twice. An existing one is used only with `force`, and only a file's; a symbolic link is never
    followed. Names that differ only in case, such as `A` and `a`, are the same name.
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
        """Returns a path that no other file has, or that of a file that `is_same`, and creates its folder."""
        folder = self._folder
        for part in parts[:-1]:
            folder = self._subfolder(folder, part)
        number = self._numbers.get((folder, _key(parts[-1] + suffix)), 1)
        while True:
            name = numbered(parts[-1], number) + suffix
            path = folder / name
            is_taken = (folder, _key(name)) in self._taken
            # Not a link to a file.
            if not is_taken and (self._is_free(path) or (stat.S_ISREG(path.lstat().st_mode) and is_same(path))):
                break
            number += 1
        self._numbers[folder, _key(parts[-1] + suffix)] = number + 1
        self._taken.add((folder, _key(name)))
        return folder / name

    def _subfolder(self, folder: Path, name: str) -> Path:
        """Returns a folder in another one, created if it is missing; under another name if a file has this one."""
        known = self._folders.get((folder, _key(name)))
        if known is not None:
            return known
        number = 1
        while (found := self._folder_at(folder / numbered(name, number))) is None:
            number += 1
        self._folders[folder, _key(name)] = found
        # It may exist under a name that differs in case; no file can have that name either.
        self._taken.add((folder, _key(found.name)))
        return found

    def _folder_at(self, path: Path) -> Path | None:
        if (path.parent, _key(path.name)) in self._taken:
            return None
        try:
            path.mkdir()
        except FileExistsError:
            # Not through a symbolic link, which may lead anywhere.
            return path if stat.S_ISDIR(path.lstat().st_mode) else None
        return path

    def _is_free(self, path: Path) -> bool:
        try:
            mode = path.lstat().st_mode
        except FileNotFoundError:
            return True
        return self._force and not stat.S_ISDIR(mode)


def _key(name: str) -> str:
    """Returns the same key for names that some file systems do not distinguish."""
    return os.path.normcase(name).casefold()
