"""Paths on the brick: their parts, maximum lengths (each including the zero), and allowed characters."""

from __future__ import annotations

import string
from typing import NamedTuple

from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.encoding import STRING_CODING

HOME = (b"home", b"root", b"lms2012")
"""The folder of the brick's own files."""

CURRENT = (*HOME, b"sys")
"""Where relative paths start."""

WHOLE = int(CONSTANTS["FILENAMESIZE"])
"""Bytes of a whole path."""

FOLDER = int(CONSTANTS["PATHSIZE"])
"""Bytes before the name, including the slash."""

NAME = int(CONSTANTS["NAMESIZE"])
"""Bytes of the name, up to its first dot."""

EXTENSION = int(CONSTANTS["EXTSIZE"])
"""Bytes of the extension, including the dot."""

USUAL_FOLDERS = (
    *(f"apps/{name}" for name in ("Brick Datalog", "Brick Program", "IR Control", "Motor Control", "Port View")),
    *(f"prjs/{name}" for name in ("BrkDL_SAVE", "BrkProg_SAVE")),
    *(f"sys/{name}" for name in ("lib", "mod", "settings", "ui")),
    *(f"tools/{name}" for name in ("Bluetooth", "Brick Info", "Sleep", "Volume", "WiFi")),
)
"""Folders of a brick as LEGO delivers it, below /home/root/lms2012."""

_LETTERS = (string.ascii_letters + string.digits + "_-./~ ").encode(STRING_CODING)

ALLOWED = frozenset(_LETTERS)
"""Characters of file names."""


MOST_PATH = 4096
"""Bytes of the longest path that the brick's system takes."""


class FileName(NamedTuple):
    """A file's name in its parts.

    folder     with its closing slash; may be empty
    name       up to the first point after the last slash
    extension  with its point; may be empty
    """

    folder: bytes
    name: bytes
    extension: bytes


def split(path: bytes) -> FileName:
    """Splits a path: the extension begins at the first point, so `a.b.c` is `a` and `.b.c`."""
    slash = path.rfind(b"/") + 1
    point = path.find(b".", slash)
    end = point if point >= 0 else len(path)
    return FileName(path[:slash], path[slash:end], path[end:])


def has_room(path: bytes) -> bool:
    """Returns whether a path and its parts are short enough for the firmware."""
    parts = split(path)
    return (
        len(path) < WHOLE and len(parts.folder) < FOLDER and len(parts.name) < NAME and len(parts.extension) < EXTENSION
    )


def is_allowed(path: bytes) -> bool:
    """Returns whether all characters are allowed and nothing is too long."""
    return has_room(path) and is_spelled(path)


def is_spelled(text: bytes) -> bool:
    """Returns whether all characters are allowed in names of files."""
    return not text.translate(None, _LETTERS)


def parts(path: bytes) -> list[bytes]:
    """Returns the names in a path from the root folder, without `.` and `..`; none for an impossible path."""
    found = [] if path.startswith(b"/") else list(CURRENT)
    if len(path) > MOST_PATH:
        return []
    for part in path.split(b"/") if b"\0" not in path else ():
        if part == b"..":
            del found[-1:]
        elif part not in (b"", b"."):
            found.append(part)
    return found if path else []
