"""FILENAME: the parts of paths, whether they exist, sizes of folders, archives."""

from __future__ import annotations

import math

from ev3proto.brick import archives
from ev3proto.brick.handlers import computes, handles
from ev3proto.brick.locations import Location
from ev3proto.brick.machine import Machine
from ev3proto.brick.operations.files import checked_name, in_own_folder, write_or_cut
from ev3proto.tables import paths
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.encoding import STRING_CODING

ARCHIVE_EXTENSION = str(CONSTANTS["EXT_ARCHIVE"]).encode(STRING_CODING)

_AS_THEY_ARE = (b".", b"/", b"~", b'"')
"""First characters of names that are never looked up in the program's own folder."""


_MOST_PATH = 118
"""Maximum length in bytes of a path that is joined or looked up; longer ones are cut."""


def _looked_up(vm: Machine, name: bytes) -> bytes:
    folder = b"" if name.startswith(_AS_THEY_ARE) else vm.program.folder.encode(STRING_CODING)
    return (folder + name)[:_MOST_PATH]


def _exists(vm: Machine, name: bytes) -> bool:
    path = _looked_up(vm, name)
    return vm.brick.files.is_file(path) or vm.brick.files.is_folder(path)


def _total_size(vm: Machine, name: bytes) -> tuple[int, int]:
    """Entries of a folder, 0 for a file; KB, rounded up."""
    found = vm.brick.files.totals(_looked_up(vm, name))
    return found.entries, math.ceil(found.size / 1024)


computes({"FILENAME.EXIST": _exists, "FILENAME.TOTALSIZE": _total_size})


@handles("FILENAME.SPLIT")
def split(vm: Machine, path: bytes, length: int, folder: Location, name: Location, extension: Location) -> None:
    """Writes each part, cut to fit."""
    parts = paths.split(path)
    for place, text in zip((folder, name, extension), parts, strict=True):
        write_or_cut(vm, place, text, length)


@handles("FILENAME.MERGE")
def merge(vm: Machine, folder: bytes, name: bytes, extension: bytes, length: int, path: Location) -> None:
    """Writes a path; a slash always follows the folder."""
    write_or_cut(vm, path, (folder + b"/" + name + extension)[:_MOST_PATH], length)


@handles("FILENAME.CHECK", places=("FILENAME",))
def check(vm: Machine, place: Location, is_fine: Location) -> None:
    """Checks a name; forbidden characters are replaced in memory, so that it passes the next time."""
    is_fine.write8(checked_name(vm, place) is not None)


@handles("FILENAME.GET_FOLDERNAME")
def folder_name(vm: Machine, length: int, destination: Location) -> None:
    """Writes the program's own folder, without the last slash."""
    write_or_cut(vm, destination, vm.program.folder.encode(STRING_CODING).removesuffix(b"/"), length)


def _archive(path: bytes) -> bytes:
    parts = paths.split(path.rstrip(b"/"))
    return parts.folder + parts.name + ARCHIVE_EXTENSION


@handles("FILENAME.PACK")
def pack(vm: Machine, path: bytes) -> None:
    """Writes an archive beside the packed file or folder."""
    path = in_own_folder(vm, path)
    archives.pack(vm.brick.files, path, _archive(path))


@handles("FILENAME.UNPACK")
def unpack(vm: Machine, path: bytes) -> None:
    """Unpacks an archive into the folder that it is in."""
    archives.unpack(vm.brick.files, _archive(in_own_folder(vm, path)))
