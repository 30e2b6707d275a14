"""System commands: files to and from the brick, folders, mailboxes; what each of them answers.

A transfer keeps its handle from BEGIN to its end, to CLOSE_FILEHANDLE or to an error. There are 64 handles for all
connections; those of a connection that ends are freed.
"""

from __future__ import annotations

import io
import os
from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from ev3proto.brick.equipment import Equipment
from ev3proto.brick.machine import Machine
from ev3proto.brick.open_files import OpenFile
from ev3proto.brick.path_names import is_allowed
from ev3proto.brick.running_programs import USER_SLOT
from ev3proto.brick.storage import StoredFile
from ev3proto.schema.fields import REPLIES, REQUESTS
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.frame import MAX_FRAME
from ev3proto.tables.system import SYSTEM_BY_NUMBER, Kind, SystemStatus

HANDLES = 64
NO_HANDLE = 0xFF
"""In replies that say why there is none."""

CUT_PATH = 59
"""Bytes to which CREATE_DIR and DELETE_FILE cut a path."""

RESERVE = 300 * 1024
"""Bytes that a download must leave free."""

_REPLY_HEAD = HEADER_SIZE + 2
_ROOM_FIRST = MAX_FRAME - _REPLY_HEAD - 5
"""Bytes of contents that fit a reply with a size and a handle."""

_ROOM_NEXT = MAX_FRAME - _REPLY_HEAD - 1
"""Bytes of contents that fit a reply with a handle."""

_OPEN_HANDLES = bytes(HANDLES // 8 + 1)
"""LIST_OPEN_HANDLES answers this, whatever is open."""

_MOST_PIN = 0xFE
"""Bytes of a PIN that its length field counts with the zero after it."""

_ADDRESS_ROOM = int(CONSTANTS["BTADRSIZE"])


class Answer(NamedTuple):
    """What a system command answers.

    status    how it went
    fields    the reply's other fields by name
    is_error  whether a status that is a failure makes it an error reply
    """

    status: SystemStatus
    fields: Mapping[str, Any]
    is_error: bool = True


class Request(NamedTuple):
    """A system command that came.

    channel  the connection
    fields   those that are there, by name; texts as bytes
    rest     the bytes after them
    """

    channel: Hashable
    fields: Mapping[str, Any]
    rest: bytes

    def number(self, name: str) -> int:
        """A field that is a number; 0 where the frame ended before it, as the firmware's buffer would say."""
        return int(self.fields.get(name, 0))

    def text(self, name: str) -> bytes:
        """A field that is a text, up to its zero or the end of the frame."""
        return bytes(self.fields.get(name, self.rest.partition(b"\0")[0]))


@dataclass
class Transfer:
    """A file or a list on its way.

    channel  the connection that began it
    command  the command that began it
    place    of the file, to see who else has it open
    file     where it is written to or read from; a list has none
    size     bytes of all of it
    done     bytes that have been moved
    listing  the list
    """

    channel: Hashable
    command: str
    place: Path | None
    file: StoredFile | None
    size: int
    done: int = 0
    listing: bytes = b""


Function = Callable[["SystemCommands", Request], Answer | None]

_FUNCTIONS: dict[str, Function] = {}


def _answers(name: str) -> Callable[[Function], Function]:
    """Registers the method that answers a system command, by its name."""

    def register(function: Function) -> Function:
        _FUNCTIONS[name] = function
        return function

    return register


class SystemCommands:
    """The transfers under way, and a method for each system command."""

    def __init__(self, brick: Equipment, machine: Machine) -> None:
        self._brick = brick
        self._machine = machine
        self._transfers: dict[int, Transfer] = {}

    def answer(self, channel: Hashable, frame: bytes) -> tuple[bool, bytes] | None:
        """Does a system command.

        Returns whether it is an error reply, and what follows the header in the reply; None for commands that have no
        reply and for those that the firmware does not know.
        """
        if len(frame) <= HEADER_SIZE:
            return None
        number = frame[HEADER_SIZE]
        entry = SYSTEM_BY_NUMBER.get(number)
        function = _FUNCTIONS.get(entry.name) if entry is not None and not entry.bootloader else None
        if function is None:
            return None
        fields, at, _ = REQUESTS[number].read_leniently(frame, HEADER_SIZE + 1, complete=False)
        texts = {Kind.TEXT, Kind.COUNTED_TEXT}
        known = {field.name: field for field in REQUESTS[number].fields}
        values = {
            name: str(value).encode(STRING_CODING) if known[name].kind in texts else value
            for name, value in fields.items()
        }
        found = function(self, Request(channel, values, frame[at:]))
        if found is None:
            return None
        is_error = found.is_error and found.status.is_failure
        return is_error, bytes((number, found.status)) + REPLIES[number].write_present(found.fields)

    def disconnect(self, channel: Hashable) -> None:
        """Frees the handles of a connection that has ended."""
        for handle, transfer in list(self._transfers.items()):
            if transfer.channel == channel:
                self._release(handle)

    # Handles

    def _add(self, transfer: Transfer) -> int | None:
        handle = next((number for number in range(HANDLES) if number not in self._transfers), None)
        if handle is not None:
            self._transfers[handle] = transfer
        return handle

    def _release(self, handle: int) -> None:
        transfer = self._transfers.pop(handle)
        if transfer.file is not None:
            transfer.file.close()

    def _find(self, request: Request, *commands: str) -> Transfer | None:
        transfer = self._transfers.get(request.number("handle"))
        return transfer if transfer is not None and transfer.command in commands else None

    def _is_name(self, path: bytes) -> bool:
        """Whether a file may have this name. One that it may not have is an error in the log."""
        is_name = is_allowed(path)
        if not is_name:
            self._brick.settings.log_once("FILE_NAME_ERROR")
        return is_name

    # To the brick

    @_answers("BEGIN_DOWNLOAD")
    def begin_download(self, request: Request) -> Answer:
        """Makes the file and the folders that it needs."""
        path, size = request.text("path"), request.number("size")
        files = self._brick.files
        if not self._is_name(path) or len(self._transfers) >= HANDLES:
            return _refused(SystemStatus.NO_HANDLES_AVAILABLE)
        if size > files.free - RESERVE:
            return _refused(SystemStatus.SIZE_ERROR)
        files.make_folders(path)
        file = files.open_to_write(path)
        if file is None:
            return _refused(SystemStatus.UNKNOWN_HANDLE)
        handle = self._add(Transfer(request.channel, "BEGIN_DOWNLOAD", files.locate(path), file, size))
        assert handle is not None
        return self._download(handle, bytes(request.fields.get("data", b"")))

    @_answers("CONTINUE_DOWNLOAD")
    def continue_download(self, request: Request) -> Answer:
        """Writes as much as the size said at first leaves open."""
        if self._find(request, "BEGIN_DOWNLOAD") is None:
            return _refused(SystemStatus.UNKNOWN_HANDLE)
        return self._download(request.number("handle"), bytes(request.fields.get("data", b"")))

    def _download(self, handle: int, data: bytes) -> Answer:
        transfer = self._transfers[handle]
        data = data[: transfer.size - transfer.done]
        if not self._write(transfer, data):
            self._release(handle)
            return _refused(SystemStatus.SIZE_ERROR)
        transfer.done += len(data)
        if transfer.done < transfer.size:
            return Answer(SystemStatus.SUCCESS, {"handle": handle})
        self._release(handle)
        return Answer(SystemStatus.END_OF_FILE, {"handle": handle})

    def _write(self, transfer: Transfer, data: bytes) -> bool:
        return transfer.file is not None and transfer.file.put(data)

    # From the brick

    @_answers("BEGIN_UPLOAD")
    def begin_upload(self, request: Request) -> Answer:
        """Opens a file and sends its first piece."""
        return self._begin_reading(
            request, "BEGIN_UPLOAD", SystemStatus.NO_HANDLES_AVAILABLE, SystemStatus.UNKNOWN_HANDLE
        )

    @_answers("BEGIN_GETFILE")
    def begin_getfile(self, request: Request) -> Answer:
        """The same for a file that may still grow."""
        return self._begin_reading(request, "BEGIN_GETFILE", SystemStatus.UNKNOWN_HANDLE, SystemStatus.HANDLE_NOT_READY)

    def _begin_reading(self, request: Request, command: str, bad_name: SystemStatus, missing: SystemStatus) -> Answer:
        path = request.text("path")
        nothing = {"size": 0, "handle": NO_HANDLE, "data": b""}
        if not self._is_name(path) or len(self._transfers) >= HANDLES:
            return Answer(bad_name, nothing)
        file = self._brick.files.open_to_read(path)
        if file is None:
            return Answer(missing, nothing)
        transfer = Transfer(request.channel, command, self._brick.files.locate(path), file, _size(file))
        handle = self._add(transfer)
        assert handle is not None
        status, data = self._read(handle, request.number("max_bytes"), _ROOM_FIRST)
        return Answer(status, {"size": transfer.size, "handle": handle, "data": data})

    @_answers("CONTINUE_UPLOAD")
    def continue_upload(self, request: Request) -> Answer:
        """The next piece."""
        if self._find(request, "BEGIN_UPLOAD") is None:
            return Answer(SystemStatus.UNKNOWN_HANDLE, {"handle": NO_HANDLE, "data": b""})
        handle = request.number("handle")
        status, data = self._read(handle, request.number("max_bytes"), _ROOM_NEXT)
        return Answer(status, {"handle": handle, "data": data})

    @_answers("CONTINUE_GETFILE")
    def continue_getfile(self, request: Request) -> Answer:
        """The next piece, and the size that the file has now."""
        transfer = self._find(request, "BEGIN_GETFILE")
        if transfer is None or transfer.file is None:
            return Answer(SystemStatus.UNKNOWN_HANDLE, {"size": 0, "handle": NO_HANDLE, "data": b""})
        transfer.size = _size(transfer.file)
        handle = request.number("handle")
        status, data = self._read(handle, request.number("max_bytes"), _ROOM_FIRST)
        return Answer(status, {"size": transfer.size, "handle": handle, "data": data})

    def _read(self, handle: int, most: int, room: int) -> tuple[SystemStatus, bytes]:
        transfer = self._transfers[handle]
        assert transfer.file is not None
        data = transfer.file.read(min(most, room, max(0, transfer.size - transfer.done))) or b""
        transfer.done += len(data)
        if transfer.done < transfer.size or self._is_growing(transfer):
            return SystemStatus.SUCCESS, data
        self._release(handle)
        return SystemStatus.END_OF_FILE, data

    def _is_growing(self, transfer: Transfer) -> bool:
        """Whether a user's program still has the file open to write, which only GETFILE minds."""
        program = self._machine.slots[USER_SLOT]
        if transfer.command != "BEGIN_GETFILE" or program is None:
            return False
        files = (entry for entry in program.handles.entries() if isinstance(entry, OpenFile))
        return any(file.for_writing and file.place == transfer.place for file in files)

    @_answers("LIST_FILES")
    def list_files(self, request: Request) -> Answer:
        """A folder's list, and its first piece."""
        listing = self._brick.files.listing(request.text("path"))
        handle = None
        if listing is not None:
            transfer = Transfer(request.channel, "LIST_FILES", None, None, len(listing), listing=listing)
            handle = self._add(transfer)
        if listing is None or handle is None:
            return Answer(SystemStatus.UNKNOWN_ERROR, {"list_size": 0, "handle": NO_HANDLE, "list": ""})
        status, piece = self._list(handle, request.number("max_bytes"), _ROOM_FIRST)
        return Answer(status, {"list_size": len(listing), "handle": handle, "list": piece})

    @_answers("CONTINUE_LIST_FILES")
    def continue_list_files(self, request: Request) -> Answer:
        """The next piece."""
        if self._find(request, "LIST_FILES") is None:
            return Answer(SystemStatus.UNKNOWN_ERROR, {"handle": NO_HANDLE, "list": ""})
        handle = request.number("handle")
        status, piece = self._list(handle, request.number("max_bytes"), _ROOM_NEXT)
        return Answer(status, {"handle": handle, "list": piece})

    def _list(self, handle: int, most: int, room: int) -> tuple[SystemStatus, str]:
        """A piece of a list, cut wherever it is full."""
        transfer = self._transfers[handle]
        piece = transfer.listing[transfer.done : transfer.done + min(most, room)]
        transfer.done += len(piece)
        if transfer.done < transfer.size:
            return SystemStatus.SUCCESS, piece.decode(STRING_CODING)
        self._release(handle)
        return SystemStatus.END_OF_FILE, piece.decode(STRING_CODING)

    # The rest

    @_answers("CLOSE_FILEHANDLE")
    def close_filehandle(self, request: Request) -> Answer:
        """Whatever it names."""
        handle = request.number("handle")
        if handle not in self._transfers:
            # The one error that echoes the handle.
            return Answer(SystemStatus.UNKNOWN_HANDLE, {"handle": handle})
        self._release(handle)
        return Answer(SystemStatus.SUCCESS, {"handle": handle})

    @_answers("CREATE_DIR")
    def create_dir(self, request: Request) -> Answer:
        """One folder, in one that is there."""
        return _permitted(self._brick.files.make_folder(request.text("path")[:CUT_PATH]))

    @_answers("DELETE_FILE")
    def delete_file(self, request: Request) -> Answer:
        """A file or an empty folder."""
        return _permitted(self._brick.files.delete(request.text("path")[:CUT_PATH]))

    @_answers("LIST_OPEN_HANDLES")
    def list_open_handles(self, _: Request) -> Answer:
        """Nothing but zeros."""
        return Answer(SystemStatus.SUCCESS, {"handles": _OPEN_HANDLES})

    @_answers("WRITEMAILBOX")
    def write_mailbox(self, request: Request) -> None:
        """The first box of that name gets it."""
        if "payload" in request.fields:
            self._brick.mailboxes.deliver(request.text("name"), bytes(request.fields["payload"]))

    @_answers("BLUETOOTHPIN")
    def bluetooth_pin(self, request: Request) -> Answer:
        """Only by USB, which this brick has not; its status says so, the type of the reply does not."""
        address = self._brick.settings.bluetooth_address
        pin = request.text("pin")[:_MOST_PIN].decode(STRING_CODING)
        fields = {"mac_length": _ADDRESS_ROOM, "mac": address, "pin_length": len(pin) + 1, "pin": pin}
        return Answer(SystemStatus.ILLEGAL_CONNECTION, fields, is_error=False)

    @_answers("SETBUNDLEID")
    def set_bundle_id(self, request: Request) -> Answer:
        """As long as there is room for."""
        return self._set_bundle("SETBUNDLEID", request)

    @_answers("SETBUNDLESEEDID")
    def set_bundle_seed_id(self, request: Request) -> Answer:
        """As long as there is room for."""
        return self._set_bundle("SETBUNDLESEEDID", request)

    @staticmethod
    def _set_bundle(command: str, request: Request) -> Answer:
        entry = next(entry for entry in SYSTEM_BY_NUMBER.values() if entry.name == command)
        most = entry.request[0].most
        fits = most is None or len(request.text("id")) < most
        return Answer(SystemStatus.SUCCESS if fits else SystemStatus.SIZE_ERROR, {})


def _refused(status: SystemStatus) -> Answer:
    return Answer(status, {"handle": NO_HANDLE})


def _permitted(is_done: bool) -> Answer:
    return Answer(SystemStatus.SUCCESS if is_done else SystemStatus.NO_PERMISSION, {})


def _size(file: io.FileIO) -> int:
    """Bytes of an open file."""
    return os.fstat(file.fileno()).st_size
