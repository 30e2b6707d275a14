"""Names of files as the firmware takes them apart and checks them."""

from __future__ import annotations

import string
from typing import NamedTuple

from ev3proto.brick.places import Place
from ev3proto.tables import paths
from ev3proto.tables.encoding import STRING_CODING

ALLOWED = frozenset((string.ascii_letters + string.digits + "_-./~ ").encode(STRING_CODING))
"""Characters of file names."""

REPLACEMENT = ord("_")
"""What the firmware puts in the place of any other character."""


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
    """Takes a path apart: the extension begins at the first point, so `a.b.c` is `a` and `.b.c`."""
    slash = path.rfind(b"/") + 1
    point = path.find(b".", slash)
    end = point if point >= 0 else len(path)
    return FileName(path[:slash], path[slash:end], path[end:])


def has_room(path: bytes) -> bool:
    """Returns whether a path and its parts are short enough for the firmware."""
    parts = split(path)
    return (
        len(path) < paths.WHOLE
        and len(parts.folder) < paths.FOLDER
        and len(parts.name) < paths.NAME
        and len(parts.extension) < paths.EXTENSION
    )


def is_allowed(path: bytes) -> bool:
    """Returns whether all characters are allowed and nothing is too long."""
    return has_room(path) and ALLOWED.issuperset(path)


def check(place: Place) -> bool:
    """Checks a name in memory; forbidden characters are replaced there, so that it passes the next time."""
    text = place.read_text()
    if not ALLOWED.issuperset(text):
        place.write_bytes(bytes(byte if byte in ALLOWED else REPLACEMENT for byte in text))
        return False
    return has_room(text)
