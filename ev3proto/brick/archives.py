"""FILENAME.PACK and UNPACK: archives of one file or folder. Members never leave the folder of the archive."""

from __future__ import annotations

import re
import tarfile
import zlib

from ev3proto.brick.steps import Steps
from ev3proto.brick.storage import MOST_DEPTH, MOST_ENTRIES, Storage

_MOST_NAME = 255
"""Bytes of a member's name, with its folders; the firmware's own paths end at 119."""

_MOST_MEMBER_DEPTH = 16
"""Maximum nesting depth of a member."""

_MOST_EXTENSION = 4096
"""Bytes of a header that holds a long name."""

_HEADS = 2 * MOST_ENTRIES * tarfile.BLOCKSIZE
"""Largest overhead of an archive, in bytes."""

_PIECE = 1 << 16
"""Bytes that are compressed or expanded in one step."""

_GZIP = zlib.MAX_WBITS | 16
"""For zlib: the data has the head of a gzip file."""

_NAMES = (tarfile.GNUTYPE_LONGNAME, tarfile.XHDTYPE)
"""Types of headers that hold the name of the next member."""

_END = bytes(2 * tarfile.BLOCKSIZE)
_PAX_PATH = re.compile(rb"(?:^|\n)\d+ path=([^\n]*)\n")
_CODING = "utf-8", "surrogateescape"


# Packing


def pack(storage: Storage, path: bytes, archive: bytes) -> Steps[bool]:
    """Writes an archive of a file or a folder with its contents. Returns False if that is impossible."""
    folder, _, name = path.rstrip(b"/").rpartition(b"/")
    compressor = zlib.compressobj(wbits=_GZIP)
    packed = bytearray()
    names = [(name, MOST_DEPTH)]
    folder = folder + b"/" if folder else b""
    while names:
        name, depth = names.pop()
        data = None
        if not storage.is_folder(folder + name):
            data = storage.read(folder + name)
            if data is None:
                continue
        elif depth:
            names += [(name + b"/" + entry, depth - 1) for entry in reversed(storage.shown(folder + name))]
        member = _member(name, data)
        for at in range(0, len(member), _PIECE):
            packed += compressor.compress(member[at : at + _PIECE])
            yield
    packed += compressor.compress(_END) + compressor.flush()
    return _write(storage, archive, bytes(packed))


def _member(name: bytes, data: bytes | None) -> memoryview:
    """Returns a member of an archive; the contents of a folder are None."""
    entry = tarfile.TarInfo(name.decode(*_CODING))
    if data is None:
        entry.type, data = tarfile.DIRTYPE, b""
    entry.size = len(data)
    return memoryview(entry.tobuf(tarfile.GNU_FORMAT, *_CODING) + data + bytes(-len(data) % tarfile.BLOCKSIZE))


# Unpacking


def unpack(storage: Storage, archive: bytes) -> Steps[bool]:
    """Unpacks an archive beside it. Returns False for an invalid or too large one, or one that leads outside."""
    data = storage.read(archive)
    if data is None:
        return False
    # Never more than fits: a small archive can hold terabytes of zeros.
    whole = yield from _expanded(data, storage.quota + _HEADS)
    if whole is None:
        return False
    folder = archive.rpartition(b"/")[0]
    folder = folder + b"/" if folder else b""
    at, long_name = 0, None
    while at + tarfile.BLOCKSIZE <= len(whole):
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
        yield
    return True


def _expanded(data: bytes, most: int) -> Steps[bytes | None]:
    """Returns the contents of a gzip file; None for an invalid one, or more than `most` bytes."""
    expander = zlib.decompressobj(_GZIP)
    whole = bytearray()
    while data and len(whole) <= most:
        try:
            whole += expander.decompress(data, _PIECE)
        except zlib.error:
            return None
        data = expander.unconsumed_tail
        yield
    return bytes(whole) if len(whole) <= most else None


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
