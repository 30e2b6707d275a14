"""FILENAME.PACK and UNPACK: archives of one file or folder. Members never leave the folder of the archive."""

from __future__ import annotations

import io
import tarfile
import zlib
from collections.abc import Iterator

from ev3proto.brick.storage import MOST_DEPTH, Storage

MOST_MEMBERS = 1000
"""Files and folders of one archive."""

_MOST_NAME = 255
"""Bytes of a member's name, with its folders; the firmware's own paths end at 119."""

_MOST_MEMBER_DEPTH = 16
"""Maximum nesting depth of a member."""

_HEADS = 2 * MOST_MEMBERS * tarfile.BLOCKSIZE
"""Largest overhead of an archive, in bytes."""

_GZIP = 16
"""For zlib: the data has the head of a gzip file."""


def pack(storage: Storage, path: bytes, archive: bytes) -> bool:
    """Writes an archive of a file or a folder with its contents. Returns False if that is impossible."""
    buffer = io.BytesIO()
    folder, _, name = path.rstrip(b"/").rpartition(b"/")
    with tarfile.open(fileobj=buffer, mode="w:gz") as tar:
        for member, data in _members(storage, folder + b"/" if folder else b"", name, MOST_DEPTH):
            entry = tarfile.TarInfo(member.decode("utf-8", "surrogateescape"))
            if data is None:
                entry.type = tarfile.DIRTYPE
                tar.addfile(entry)
            else:
                entry.size = len(data)
                tar.addfile(entry, io.BytesIO(data))
    return _write(storage, archive, buffer.getvalue())


def _members(storage: Storage, folder: bytes, name: bytes, depth: int) -> Iterator[tuple[bytes, bytes | None]]:
    """Yields names and contents; the contents of a folder are None."""
    if storage.is_folder(folder + name):
        yield name, None
        for entry in storage.shown(folder + name) if depth else ():
            yield from _members(storage, folder, name + b"/" + entry, depth - 1)
        return
    data = storage.read(folder + name)
    if data is not None:
        yield name, data


def unpack(storage: Storage, archive: bytes) -> bool:
    """Unpacks an archive beside it. Returns False for an invalid or too large one, or one that leads outside."""
    data = storage.read(archive)
    if data is None:
        return False
    folder = archive.rpartition(b"/")[0]
    folder = folder + b"/" if folder else b""
    try:
        # Never more than fits: a small archive can hold terabytes of zeros.
        whole = zlib.decompressobj(zlib.MAX_WBITS | _GZIP).decompress(data, storage.quota + _HEADS)
        with tarfile.open(fileobj=io.BytesIO(whole), mode="r:") as tar:
            for number, entry in enumerate(tar):
                if number >= MOST_MEMBERS or not _unpack_member(storage, folder, tar, entry):
                    return False
    except (tarfile.TarError, OSError, EOFError, zlib.error, ValueError):
        return False
    return True


def _unpack_member(storage: Storage, folder: bytes, tar: tarfile.TarFile, entry: tarfile.TarInfo) -> bool:
    name = entry.name.encode("utf-8", "surrogateescape")
    parts = name.split(b"/")
    if name.startswith(b"/") or b".." in parts or len(name) > _MOST_NAME or len(parts) > _MOST_MEMBER_DEPTH:
        return False
    if entry.isdir():
        return storage.is_folder(folder + name) or storage.make_folder(folder + name)
    if not entry.isreg() or entry.size > storage.free:
        return False
    file = tar.extractfile(entry)
    storage.make_folders(folder + name)
    return file is not None and _write(storage, folder + name, file.read(entry.size))


def _write(storage: Storage, path: bytes, data: bytes) -> bool:
    if len(data) > storage.free:
        return False
    file = storage.open_to_write(path)
    if file is None:
        return False
    with file:
        return file.put(data)
