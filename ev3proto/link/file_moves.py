"""Files to the brick and from it, without I/O: each task is a generator that yields commands and is sent the replies.

The words are the protocol's: a *download* writes a file to the brick, an *upload* reads one from it.
"""

from __future__ import annotations

import hashlib
import posixpath
import secrets
from collections.abc import Callable, Generator
from typing import Any, TypeVar

from ev3proto.compose import command
from ev3proto.link.errors import LinkError, SystemCommandError, TransferError
from ev3proto.messages import DirectCommand, SystemCommand, SystemReply
from ev3proto.ops import file, memory_usage
from ev3proto.semantics.replies import values_of
from ev3proto.semantics.transfers import File, Listing, handle_of, is_complete, piece_of, read_listing, size_of
from ev3proto.system import (
    begin_download,
    begin_upload,
    continue_list_files,
    continue_upload,
    create_dir,
    delete_file,
    list_files,
    pieces,
)
from ev3proto.tables.system import SystemStatus

T = TypeVar("T")
Task = Generator[SystemCommand | DirectCommand, Any, T]
"""Yields commands, receives the reply to each, and returns the result."""

Progress = Callable[[int, int], None]
"""Called with the bytes moved so far and their total."""

MOST_FILE = 1 << 28
"""Maximum size of a file in bytes: more than fits into any brick's RAM."""

MOST_LISTING = 1 << 24
"""Maximum size of a listing in bytes: a brick has fewer names."""

COPYING = 120.0
"""Seconds to wait at least for the reply to a direct command: the brick copies megabytes."""

_KIB = 1024


def nothing_moved(_done: int, _total: int) -> None:
    """Ignores the progress of a transfer."""


def download(data: bytes, path: str, progress: Progress = nothing_moved) -> Task[File]:
    """Writes a file to the brick, and compares the listed MD5. Raises SystemCommandError and TransferError.

    The old file stays until the new one is complete, under another name. The firmware cannot rename: FILE.MOVE deletes
    the old file, and copies the new one. An error names the temporary file if it is left.
    """
    part, is_moving = posixpath.join(posixpath.dirname(path), f"~{secrets.token_hex(4)}.tmp"), False
    try:
        yield from _written(data, part, path, progress)
        listing = yield from _listing_of(path)
        _compare(data, listing, part, path)
        yield from _find_room(len(data), listing, path)
        is_moving = True
        yield command(file.move(part, path), reply=True)
        found = _compare(data, (yield from _listing_of(path)), path, path)
    except GeneratorExit:
        raise
    except BaseException as error:
        whole = (yield from _whole(data, path)) if is_moving else None
        if is_moving and whole is None:
            _tell(error, f"{path}: the brick may not have all of it; the new file is complete in {part}")
            raise
        if whole is None or not isinstance(error, LinkError):
            yield from _cleared(part, error)
            raise
        found = whole  # only a reply was lost
    yield from _cleared(part)
    return found


def _cleared(part: str, error: BaseException | None = None) -> Task[None]:
    """Deletes the temporary file, or says that it may be left."""
    try:
        yield delete_file(part)
    except LinkError as lost:
        _tell(error or lost, f"{part}: this temporary file may be left on the brick")
        if error is None:
            raise


def _tell(error: BaseException, sentence: str) -> None:
    if isinstance(error, LinkError):
        error.args = (f"{error}; {sentence}",)
    else:
        error.add_note(sentence)


def _written(data: bytes, part: str, path: str, progress: Progress) -> Task[None]:
    reply = yield begin_download(part, len(data))
    handle, done = _begun(reply, path), 0
    progress(0, len(data))
    for piece in pieces(handle, data):
        reply = yield piece
        _check(reply, path)
        done += len(piece_of(piece))
        progress(done, len(data))


def _find_room(size: int, listing: Listing, path: str) -> Task[None]:
    """Raises TransferError if the brick has no room for a second copy in place of the old file."""
    asked = command(memory_usage(), reply=True)
    free = next((value.value for value in values_of((yield asked), asked) if value.name == "FREE"), None)
    old = _file_in(listing, path)
    room = int(free) * _KIB + (0 if old is None else old.size) if isinstance(free, int) else size
    if room < size:
        raise TransferError(
            f"{path}: the brick has no room for a second copy, which the firmware makes: {size} bytes are needed, and"
            f" {room} are free; delete files there"
        )


def _whole(data: bytes, path: str) -> Task[File | None]:
    """Returns a file if the brick has all of it."""
    try:
        return _compare(data, (yield from _listing_of(path)), path, path)
    except LinkError:
        return None


def upload(path: str, progress: Progress = nothing_moved) -> Task[bytes]:
    """Reads a file from the brick, and compares its MD5 with the listed one. Raises as `download` does."""
    data = yield from _read(begin_upload(path), continue_upload, MOST_FILE, path, progress)
    _compare(data, (yield from _listing_of(path)), path, path)
    return data


def list_dir(path: str) -> Task[Listing]:
    """Lists a folder. Raises SystemCommandError, and TransferError if the listing is not whole."""
    data = yield from _read(list_files(path), continue_list_files, MOST_LISTING, path, nothing_moved)
    return read_listing(data)


def delete(path: str) -> Task[None]:
    """Deletes a file or an empty folder. Raises SystemCommandError."""
    _check((yield delete_file(path)), path)


def mkdir(path: str) -> Task[None]:
    """Makes a folder. Raises SystemCommandError."""
    _check((yield create_dir(path)), path)


def _read(
    begin: SystemCommand, go_on: Callable[[int], SystemCommand], most: int, path: str, progress: Progress
) -> Task[bytes]:
    """Reads a file or a listing of at most some bytes in pieces. What is left open is ended by the caller."""
    reply = yield begin
    handle, size, data = _begun(reply, path), size_of(reply) or 0, bytearray(piece_of(reply))
    if size > most:
        raise TransferError(f"{path}: the brick reports {size} bytes, which is more than a brick can store")
    progress(min(len(data), size), size)
    while not is_complete(len(data), size):
        if reply.status is SystemStatus.END_OF_FILE:
            raise TransferError(f"{path}: the brick announced {size} bytes and sent {len(data)}; copy it again")
        reply = yield go_on(handle)
        _check(reply, path)
        piece = piece_of(reply)
        if not piece and reply.status is not SystemStatus.END_OF_FILE:
            raise TransferError(f"{path}: the brick stopped sending after {len(data)} of {size} bytes")
        data += piece
        progress(min(len(data), size), size)
    return bytes(data[:size])


def _listing_of(path: str) -> Task[Listing]:
    return (yield from list_dir(posixpath.dirname(path) or ("/" if path.startswith("/") else ".")))


def _file_in(listing: Listing, path: str) -> File | None:
    return next((file for file in listing.files if file.name == posixpath.basename(path)), None)


def _compare(data: bytes, listing: Listing, place: str, path: str) -> File:
    """Returns a file as the brick lists it. Raises TransferError if it differs from the data."""
    found = _file_in(listing, place)
    if found is None:
        raise TransferError(f"{path}: the brick does not list the file after it was copied without an error")
    digest = hashlib.md5(data, usedforsecurity=False).hexdigest()
    if (found.size, found.md5) != (len(data), digest):
        raise TransferError(
            f"{path}: {len(data)} bytes with the MD5 {digest} were copied, but the brick has {found.size} bytes with"
            f" {found.md5}; copy it again"
        )
    return found


def _begun(reply: SystemReply, path: str) -> int:
    """Returns the handle that the brick gave. Raises SystemCommandError if it gave none."""
    _check(reply, path)
    handle = handle_of(reply)
    if handle is None:
        raise SystemCommandError(reply, path)
    return handle


def _check(reply: SystemReply, path: str) -> None:
    if reply.is_error and reply.status is not SystemStatus.END_OF_FILE:
        raise SystemCommandError(reply, path)
