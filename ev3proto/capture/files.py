"""Recovery of the files that are transferred to or from the brick in a capture.

    for found in recover(capture.events(), Path("files")):
        print(found.file, found.outcome)

Pieces are written as they come, into a temporary folder inside the output folder. Files get their names at the end,
when it is known whether they are complete, and whether there are several bricks.
"""

from __future__ import annotations

import filecmp
import hashlib
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from enum import StrEnum
from pathlib import Path

from ev3proto.capture.dialogues import is_error
from ev3proto.capture.moving import unanswered_after
from ev3proto.capture.record import CaptureError, Event, Record
from ev3proto.capture.safe_paths import Shelf, parts_of, safe_name
from ev3proto.dialogue import Transfer
from ev3proto.errors import counted
from ev3proto.messages import SystemCommand, SystemReply
from ev3proto.semantics.transfers import (
    LISTINGS,
    UPLOADS,
    ends,
    entry_of,
    handle_of,
    piece_of,
    read_listing,
    shortage,
    size_of,
)
from ev3proto.tables.system import FieldKind, SystemDeclaration
from ev3proto.temporary import PREFIX, temporary_folder
from ev3proto.text.phrases import status_name

MOST_FILES = 10_000
"""Maximum number of files from a capture."""

PART = ".part"
"""Suffix of the name of an incomplete file."""

LISTING = "listing.txt"
"""Name of the listing of a folder, inside that folder."""


class FileState(StrEnum):
    """The outcome of a transfer."""

    COMPLETE = "complete"
    SENT = "sent, no reply wanted"
    UNANSWERED = "last piece never answered"
    INCOMPLETE = "incomplete"
    REFUSED = "refused"


@dataclass(frozen=True, slots=True)
class RecoveredFile:
    """A transferred file."""

    path: str  # its path on the brick; for pieces whose beginning was not captured, what is known of them
    command: str | None  # the command that began the transfer, None if it was not captured
    direction: str  # `to brick` or `from brick`
    peer: str  # the brick's address, in a text its label if it has one
    bytes: int  # number of transferred bytes
    size: int | None  # size of the whole file in bytes, None if unknown
    outcome: FileState  # complete if the brick answered the last piece, or lists the file; refused before any byte
    trouble: str | None  # why it is not complete, or cannot be written, as a sentence
    packets: tuple[int, int]  # its first and its last packet
    file: Path | None = None  # its path on this computer, None if it was not written


def survey(events: Iterable[Event], *, listings: bool = False) -> Iterator[RecoveredFile]:
    """Finds the transferred files without writing them.

    Args:
        events: The events of a capture.
        listings: Include the listings of folders.

    Yields:
        The files, in the order in which they began.

    Raises:
        CaptureError: The capture is damaged, or has more than MOST_FILES files. The others were yielded before.
    """
    found = _Files(lambda _number, _piece: None, listings=listings)
    trouble = found.take(events)
    for moving in found.all:
        yield moving.result(None)
    if trouble is not None:
        raise trouble


def recover(
    events: Iterable[Event], folder: Path, *, force: bool = False, listings: bool = False
) -> Iterator[RecoveredFile]:
    """Writes the transferred files into a folder, which is created if it is missing.

    Nothing outside the folder is touched, whatever the paths in the capture are. With several bricks, each gets a
    folder in it. An incomplete file gets the suffix `.part`, and is not written if it is empty. A name that is taken
    gets a number, `hello (2).rbf`, unless the existing file is the same, which is then kept.

    A file that cannot be written, such as on a full disk, has no `file` and a `trouble`. The others are written.

    Args:
        events: The events of a capture.
        folder: The output folder.
        force: Overwrite existing files.
        listings: Also write the listings of folders, as `listing.txt` in the folder's place.

    Yields:
        The files, in the order in which they began.

    Raises:
        OSError: Nothing can be written into the folder.
        CaptureError: The capture is damaged, or has more than MOST_FILES files. The others were yielded before.
    """
    folder.mkdir(parents=True, exist_ok=True)
    with temporary_folder(folder, f".{PREFIX}") as beside:
        pieces = _Pieces(beside)
        found = _Files(pieces.append, listings=listings)
        trouble = found.take(events)
        shelf = Shelf(folder, force=force)
        several = len({moving.peer for moving in found.all}) > 1
        for moving in found.all:
            file = None
            try:
                file = _written(moving, pieces, shelf, several=several)
            except OSError as error:
                moving.unwritten = error.strerror or str(error)
            yield moving.result(file)
    if trouble is not None:
        raise trouble


def _written(moving: _Moving, pieces: _Pieces, shelf: Shelf, *, several: bool) -> Path | None:
    is_whole = moving.outcome not in (FileState.INCOMPLETE, FileState.REFUSED)
    if not is_whole and not moving.bytes:
        return None
    parts = (safe_name(moving.peer), *moving.parts) if several else moving.parts
    found = pieces.path(moving.number)
    place = shelf.place(parts, "" if is_whole else PART, lambda path: _is_same(path, found))
    if not _is_same(place, found):
        found.replace(place)
    return place


def _is_same(path: Path, other: Path) -> bool:
    return path.is_file() and filecmp.cmp(path, other, shallow=False)


# Files in transfer


@dataclass(slots=True)
class _Moving:
    number: int
    path: str
    parts: tuple[str, ...]  # names of folders and file under which it is written
    command: str | None
    direction: str
    peer: str
    first: int
    last: int
    transfer: Transfer | None = None  # its transfer in the dialogue, None if the dialogue does not follow it
    stated: int | None = None  # its size in bytes, if there is no transfer
    bytes: int = 0
    unanswered: Record | None = None  # the command with the last piece, or that began it, until its reply comes
    digest: hashlib._Hash = field(default_factory=lambda: hashlib.md5(usedforsecurity=False))
    is_listed: bool = False  # a later listing of its folder has its size and MD5
    failure: str | None = None  # the brick's error
    unwritten: str | None = None  # why it is not on this computer's disk

    @property
    def size(self) -> int | None:
        return self.stated if self.transfer is None else self.transfer.size

    @property
    def outcome(self) -> FileState:
        if self.failure is not None:
            return FileState.INCOMPLETE if self.bytes else FileState.REFUSED
        if shortage(self.bytes, self.size) is not None:
            return FileState.INCOMPLETE
        if self.direction == FROM_BRICK or self.unanswered is None or self.is_listed:
            return FileState.COMPLETE
        return FileState.UNANSWERED if self.unanswered.message.wants_reply else FileState.SENT

    @property
    def trouble(self) -> str | None:
        if self.unwritten is not None:
            return f"it cannot be written: {self.unwritten}"
        if self.outcome in (FileState.COMPLETE, FileState.SENT):
            return None
        if self.outcome is FileState.UNANSWERED:
            return f"{counted(self.bytes, 'byte')} sent, the last piece never answered"
        if self.outcome is FileState.REFUSED:
            return f"the brick refused it: {self.failure}"
        if self.failure is None:
            return shortage(self.bytes, self.size)
        moved = f"{self.bytes} of {self.size} bytes" if self.size is not None else f"{self.bytes} bytes of it"
        return f"{moved} were moved, then the brick said {self.failure}"

    def result(self, file: Path | None) -> RecoveredFile:
        return RecoveredFile(
            self.path,
            self.command,
            self.direction,
            self.peer,
            self.bytes,
            self.size,
            self.outcome,
            self.trouble,
            (self.first, self.last),
            file,
        )


TO_BRICK, FROM_BRICK = "to brick", "from brick"

MOST_LISTED = 1 << 20
"""Maximum number of bytes of listings that are kept to find out whether files have arrived."""


class _Folders:
    """Listings of folders, which prove that files have arrived on the brick."""

    def __init__(self) -> None:
        self._listed: dict[int, tuple[Transfer, int, bytearray]] = {}
        self._size = 0

    def add(self, record: Record) -> None:
        """Takes the next message, if it is of a listing."""
        transfer = record.transfer
        if transfer is not None and transfer.command in LISTINGS and self._size < MOST_LISTED:
            piece = piece_of(record.message)
            self._size += len(piece)
            self._listed.setdefault(id(transfer), (transfer, record.number, bytearray()))[2].extend(piece)

    def have(self, moving: _Moving) -> bool:
        """Returns whether a listing after the last message of a file has it, with its size and MD5."""
        wanted = moving.bytes, moving.digest.hexdigest()
        return any(
            (file.size, file.md5) == wanted and parts_of(f"{transfer.path}/{file.name}") == moving.parts
            for transfer, number, text in self._listed.values()
            if number > moving.last
            for file in read_listing(bytes(text)).files
        )


_Loose = tuple[tuple[str, int], str, int]
"""The key of pieces without a known file: brick, direction and handle."""


class _Files:
    """Assigns the messages of a capture to files, and passes on each piece with the number of its file."""

    def __init__(self, write: Callable[[int, bytes], None], *, listings: bool) -> None:
        self.all: list[_Moving] = []
        self._write = write
        self._listings = listings
        self._known: dict[int, _Moving] = {}
        self._loose: dict[_Loose, _Moving] = {}
        self._images: dict[tuple[str, int], _Moving] = {}
        self._is_full = False
        self._folders = _Folders()

    def take(self, events: Iterable[Event]) -> CaptureError | None:
        """Takes all events. Returns the fault of the capture after everything readable, if any."""
        try:
            for event in events:
                if isinstance(event, Record):
                    self._folders.add(event)
                    self._record(event)
        except CaptureError as error:
            return error
        finally:
            for moving in self.all:
                moving.is_listed = moving.unanswered is not None and self._folders.have(moving)
        return CaptureError(f"more than {MOST_FILES} files: the rest is omitted") if self._is_full else None

    def _record(self, record: Record) -> None:
        message = record.message
        entry = entry_of(message)
        if entry is None or not isinstance(message, SystemCommand | SystemReply):
            return
        moving = self._moving(record, message, entry)
        if moving is None:
            return
        moving.last = record.number
        if isinstance(message, SystemReply):
            if is_error(message):
                # Closing a file twice does no harm.
                moving.failure = moving.failure if entry.transfer == "close" else status_name(message)
                return
            if moving.direction == FROM_BRICK:
                # A retry.
                moving.failure = None
        moving.unanswered = unanswered_after(record, moving.unanswered)
        piece = piece_of(message)
        if piece:
            self._write(moving.number, piece)
            moving.digest.update(piece)
            moving.bytes += len(piece)

    def _moving(self, record: Record, message: SystemCommand | SystemReply, entry: SystemDeclaration) -> _Moving | None:
        if entry.name in LISTINGS and not self._listings:
            return None
        if record.transfer is not None:
            return self._of_transfer(record, record.transfer)
        if entry.bootloader:
            return self._of_image(record, message, entry)
        if entry.transfer is not None:
            return self._of_handle(record, message, entry)
        return None

    def _of_transfer(self, record: Record, transfer: Transfer) -> _Moving | None:
        moving = self._known.get(id(transfer))
        if moving is None:
            path = f"{transfer.path}/{LISTING}" if transfer.command in LISTINGS else transfer.path
            direction = FROM_BRICK if transfer.command in UPLOADS else TO_BRICK
            moving = self._new(record, transfer.path, parts_of(path), direction, transfer.command)
            if moving is not None:
                moving.transfer = transfer
                # Kept while its id is in use, so that no other transfer can get the same id.
                self._known[id(transfer)] = moving
        return moving

    def _of_image(
        self, record: Record, message: SystemCommand | SystemReply, entry: SystemDeclaration
    ) -> _Moving | None:
        """Returns the firmware image in transfer to the flash memory, which has no path and no handle."""
        begins = _begins_image(entry)
        is_command = isinstance(message, SystemCommand)
        if not begins and not any(field.kind is FieldKind.DATA for field in entry.request):
            return None
        if is_command and (begins or record.end not in self._images):
            address, size = message.fields.get("address"), message.fields.get("image_size")
            self._images.pop(record.end, None)
            path, name = "flash memory, its address was not captured", "flash.bin"
            if isinstance(address, int):
                path, name = f"flash memory from 0x{address:08X}", f"flash-0x{address:08x}.bin"
            begun = self._new(record, path, (name,), TO_BRICK, entry.name if begins else None)
            if begun is not None:
                begun.stated = size if isinstance(size, int) else None
                self._images[record.end] = begun
        return self._images.get(record.end)

    def _of_handle(
        self, record: Record, message: SystemCommand | SystemReply, entry: SystemDeclaration
    ) -> _Moving | None:
        """Returns the pieces of a file whose beginning was not captured, so that its path is unknown."""
        handle = handle_of(message)
        if handle is None:
            return None
        direction = FROM_BRICK if entry.name in UPLOADS else TO_BRICK
        key = (record.end, direction, handle)
        if entry.transfer != "continue":
            # From now on the handle belongs to another file.
            self._loose.pop((record.end, TO_BRICK, handle), None)
            self._loose.pop((record.end, FROM_BRICK, handle), None)
        moving = self._loose.get(key)
        if moving is None and piece_of(message):
            path = f"handle {handle}, its path was not captured"
            moving = self._new(record, path, (f"handle-{handle}",), direction)
            if moving is not None:
                moving.stated = size_of(message)
                self._loose[key] = moving
        if isinstance(message, SystemReply) and ends(message):
            self._loose.pop(key, None)
        return moving

    def _new(
        self, record: Record, path: str, parts: tuple[str, ...], direction: str, command: str | None = None
    ) -> _Moving | None:
        number = len(self.all)
        if number >= MOST_FILES:
            self._is_full = True
            return None
        peer = record.label or record.peer
        moving = _Moving(number, path, parts, command, direction, peer, record.number, record.number)
        self.all.append(moving)
        return moving


def _begins_image(entry: SystemDeclaration) -> bool:
    # The command that requests a checksum has the same field, but also a reply.
    return not entry.reply and any(field.name == "image_size" for field in entry.request)


class _Pieces:
    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._failed: dict[int, OSError] = {}

    def path(self, number: int) -> Path:
        """Returns the path of a file, created if nothing was written. Raises OSError if it could not be written."""
        if number in self._failed:
            raise self._failed[number]
        path = self._folder / str(number)
        path.touch(0o600)  # files hold PINs
        return path

    def append(self, number: int, piece: bytes) -> None:
        """Appends a piece. A file that cannot be written is removed."""
        if number in self._failed:
            return
        try:
            with self.path(number).open("ab") as file:
                file.write(piece)
        except OSError as error:
            self._failed[number] = error
            with suppress(OSError):
                (self._folder / str(number)).unlink()
