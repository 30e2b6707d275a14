"""FILENAME.PACK and UNPACK: archives of one file or folder. Members never leave the folder of the archive."""

from __future__ import annotations

import gzip
import io
import tarfile
import zlib

from ev3proto.brick.storage import MOST_DEPTH, MOST_ENTRIES, Storage

_MOST_NAME = 255
"""Bytes of a member's name, with its folders; the firmware's own paths end at 119."""

_MOST_MEMBER_DEPTH = 16
"""Maximum nesting depth of a member."""

_HEADS = 2 * MOST_ENTRIES * tarfile.BLOCKSIZE
"""Largest overhead of an archive, in bytes."""

_GZIP = zlib.MAX_WBITS | 16
"""For zlib: the data has the head of a gzip file."""

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
        if len(whole) > most:
            return False
        with tarfile.open(fileobj=io.BytesIO(whole), mode="r:") as members:
            return all(_unpack_member(storage, folder + slash, members, entry) for entry in members)
    except (zlib.error, tarfile.TarError):
        return False


def _unpack_member(storage: Storage, folder: bytes, members: tarfile.TarFile, entry: tarfile.TarInfo) -> bool:
    name = entry.name.encode(*_CODING)
    parts = name.split(b"/")
    if name.startswith(b"/") or b".." in parts or len(name) > _MOST_NAME or len(parts) > _MOST_MEMBER_DEPTH:
        return False
    if entry.isdir():
        return storage.is_folder(folder + name) or storage.make_folder(folder + name)
    # A sparse file takes less of the archive than of the disk.
    contents = members.extractfile(entry) if entry.isreg() and 0 <= entry.size <= storage.free else None
    if contents is None:
        return False
    storage.make_folders(folder + name)
    return _write(storage, folder + name, contents.read())


def _write(storage: Storage, path: bytes, data: bytes) -> bool:
    if len(data) > storage.free:
        return False
    file = storage.open_to_write(path)
    if file is None:
        return False
    with file:
        return file.put(data)
