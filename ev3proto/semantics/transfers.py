"""Transfers of files and listings: what a message carries of one, which is the last, and whether all of it came."""

from __future__ import annotations

import re
from typing import NamedTuple

from ev3proto.messages import Message, SystemCommand, SystemReply
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.system import SYSTEM, SYSTEM_BY_NUMBER, FieldKind, SystemDeclaration, SystemStatus

LONGER = "it has {size} bytes, but {done} were moved"
INCOMPLETE = "{done} of {size} bytes were captured"
"""What is said of a file in a capture with another size than announced."""


def _answers_with(kind: FieldKind) -> frozenset[str]:
    return frozenset(
        entry.name
        for entry in SYSTEM
        if entry.transfer is not None and any(field.kind is kind for field in entry.reply)
    )


LISTINGS = _answers_with(FieldKind.LISTING)
"""The commands that move listings of folders."""

UPLOADS = _answers_with(FieldKind.DATA) | LISTINGS
"""The commands that move data from the brick; the others move files to it."""

_FILE = re.compile(r"([0-9A-Fa-f]{32}) ([0-9A-Fa-f]{8}) (.+)")
"""A file in a listing: MD5, size, name."""


class File(NamedTuple):
    """A file in a listing: its name, its bytes, and the MD5 of its contents in lower-case hex."""

    name: str
    size: int
    md5: str


class Listing(NamedTuple):
    """The contents of a folder, in the brick's order; `.` and `..` are omitted."""

    folders: tuple[str, ...]
    files: tuple[File, ...]


def read_listing(data: bytes) -> Listing:
    """Reads a listing as the brick sends it. Lines that make no sense are omitted."""
    lines = data.decode(STRING_CODING).split("\n")
    folders = (line[:-1] for line in lines if line.endswith("/") and line not in ("./", "../"))
    found = (_FILE.fullmatch(line) for line in lines if not line.endswith("/"))
    files = (File(one[3], int(one[2], 16), one[1].lower()) for one in found if one is not None)
    return Listing(tuple(folders), tuple(files))


def entry_of(message: Message) -> SystemDeclaration | None:
    """Returns the tables' entry of a system message's command; None for other messages and unknown commands."""
    return SYSTEM_BY_NUMBER.get(message.number) if isinstance(message, SystemCommand | SystemReply) else None


def step_of(message: Message) -> str | None:
    """Returns what a command of a transfer does: `begin`, `continue` or `close`; None for other messages."""
    entry = entry_of(message)
    return None if entry is None or not isinstance(message, SystemCommand) else entry.transfer


def piece_of(message: Message) -> bytes:
    """Returns the bytes of a file or listing in a message, often none."""
    entry = entry_of(message)
    if entry is None or not isinstance(message, SystemCommand | SystemReply):
        return b""
    declared = entry.request if isinstance(message, SystemCommand) else entry.reply
    for field in declared:
        value = message.fields.get(field.name)
        if field.kind is FieldKind.LISTING and isinstance(value, str):
            return value.encode(STRING_CODING)
        # The command that closes a file has data, too: its hash.
        if field.kind is FieldKind.DATA and isinstance(value, bytes) and entry.transfer != "close":
            return value
    return b""


def handle_of(message: Message | None) -> int | None:
    """Returns the handle in a system message; None for other messages, and without one."""
    handle = message.fields.get("handle") if isinstance(message, SystemCommand | SystemReply) else None
    return handle if isinstance(handle, int) else None


def size_of(message: SystemCommand | SystemReply) -> int | None:
    """Returns the size in bytes that a message announces of a file or listing; None if it announces none."""
    size = message.fields.get("size", message.fields.get("list_size"))
    return size if isinstance(size, int) else None


def ends(reply: SystemReply) -> bool:
    """Returns whether the brick has freed the handle of a transfer with a reply: it closed the file, or failed."""
    entry = entry_of(reply)
    is_closed = entry is not None and entry.transfer == "close"
    return is_closed or reply.is_error or reply.status is SystemStatus.END_OF_FILE


def is_complete(done: int, size: int | None) -> bool:
    """Returns whether all bytes of a file or listing were moved, as far as its size is known."""
    return size is not None and done >= size


def shortage(done: int, size: int | None) -> str | None:
    """Returns what is wrong with the size of a captured file, as a sentence; None if all of it was captured."""
    if size is None:
        return f"{done} bytes of it were captured"
    return None if done == size else (LONGER if is_complete(done, size) else INCOMPLETE).format(size=size, done=done)
