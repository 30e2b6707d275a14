"""FILENAME.PACK and UNPACK: archives of one file or folder. Members never leave the folder of the archive."""

from __future__ import annotations

import gzip
import io
import re
import tarfile
import zlib

from ev3proto.brick.storage import MOST_DEPTH, MOST_ENTRIES, Storage

_MOST_NAME = 255
"""Bytes of a member's name, with its folders; the firmware's own paths end at 119."""

_MOST_MEMBER_DEPTH = 16
"""Maximum nesting depth of a member."""

_MOST_EXTENSION = 4096
"""Bytes of a header that holds a long name."""

_MOST_HEADERS = 4 * MOST_ENTRIES
"""Maximum number of headers that are read: entries may be there already, and have headers for their names."""

_HEADS = 2 * MOST_ENTRIES * tarfile.BLOCKSIZE
"""Largest overhead of an archive, in bytes."""

_GZIP = zlib.MAX_WBITS | 16
"""For zlib: the data has the head of a gzip file."""

_NAMES = (tarfile.GNUTYPE_LONGNAME, tarfile.XHDTYPE)
"""Types of headers that hold the name of the next member."""

_PAX_PATH = re.compile(rb"(?:^|\n)\d+ path=([^\n]*)\n")
_CODING = "utf-8", "surrogateescape"


def pack(storage: Storage, path: bytes, archive: bytes) -> bool:
    """Writes an archive of a file or a folder with its contents. Returns False if that is impossible."""
    folder, slash, name = path.rstrip(b"/").rpartition(b"/")
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w", format=tarfile.GNU_FORMAT) as members:
        _add(storage, members, folder + slash, name, MOST_DEPTH)
    return _write(storage, archive, gzip.compress(packed.getvalue(), mtime=0))


def _add(storage: Storage, members: tarfile.TarFile, folder: bytes, name: bytes, depth: int) -> None:
    """Adds a file, or a folder with its contents."""
    entry = tarfile.TarInfo(name.decode(*_CODING))
    if storage.is_folder(folder + name):
        entry.type = tarfile.DIRTYPE
        members.addfile(entry)
        for below in storage.shown(folder + name) if depth else ():
            _add(storage, members, folder, name + b"/" + below, depth - 1)
    elif (data := storage.read(folder + name)) is not None:
        entry.size = len(data)
        members.addfile(entry, io.BytesIO(data))


def unpack(storage: Storage, archive: bytes) -> bool:
    """Unpacks an archive beside it. Returns False for an invalid or too large one, or one that leads outside."""
    folder, slash, _ = archive.rpartition(b"/")
    # Never more than fits: a small archive can hold terabytes of zeros.
    most = storage.quota + _HEADS
    try:
        whole = zlib.decompressobj(_GZIP).decompress(storage.read(archive) or b"", most + 1)
    except zlib.error:
        return False
    return len(whole) <= most and _unpack_members(storage, folder + slash, whole)


def _unpack_members(storage: Storage, folder: bytes, whole: bytes) -> bool:
    # A TarFile would read the headers in times and depths that grow with hostile names.
    at, long_name = 0, None
    for _ in range(_MOST_HEADERS):
        try:
            entry = tarfile.TarInfo.frombuf(whole[at : at + tarfile.BLOCKSIZE], *_CODING)
        except tarfile.HeaderError:
            # Zeros end an archive.
            return not any(whole[at : at + tarfile.BLOCKSIZE])
        at += tarfile.BLOCKSIZE
        contents = whole[at : at + max(entry.size, 0)]
        at += len(contents) + -len(contents) % tarfile.BLOCKSIZE
        if entry.size != len(contents):
            return False
        if entry.type in _NAMES:
            long_name = _long_name(contents)
        elif entry.type != tarfile.XGLTYPE:
            name, long_name = long_name or entry.name.encode(*_CODING), None
            if not _unpack_member(storage, folder, name, entry, contents):
                return False
    return False


def _long_name(contents: bytes) -> bytes | None:
    """Returns the name in a header of GNU tar or pax; None if it has none."""
    found = _PAX_PATH.search(contents[:_MOST_EXTENSION])
    return found[1] if found is not None else contents.partition(b"\0")[0]


def _unpack_member(storage: Storage, folder: bytes, name: bytes, entry: tarfile.TarInfo, contents: bytes) -> bool:
    parts = name.split(b"/")
    if name.startswith(b"/") or b".." in parts or len(name) > _MOST_NAME or len(parts) > _MOST_MEMBER_DEPTH:
        return False
    if entry.isdir():
        name = name.rstrip(b"/")
        return storage.is_folder(folder + name) or storage.make_folder(folder + name)
    if entry.type not in (tarfile.REGTYPE, tarfile.AREGTYPE):
        return False
    storage.make_folders(folder + name)
    return _write(storage, folder + name, contents)


def _write(storage: Storage, path: bytes, data: bytes) -> bool:
    if len(data) > storage.free:
        return False
    file = storage.open_to_write(path)
    if file is None:
        return False
    with file:
        return file.put(data)
