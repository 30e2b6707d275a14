"""System commands: files to and from the brick, folders, mailboxes, and their answers.

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
from ev3proto.brick.running_programs import USER_SLOT
from ev3proto.brick.storage import StoredFile
from ev3proto.schema.fields import REPLIES, REQUESTS
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.frame import MAX_FRAME
from ev3proto.tables.paths import is_allowed
from ev3proto.tables.system import SYSTEM_BY_NUMBER, SystemStatus

HANDLES = 64
NO_HANDLE = 0xFF
"""The handle in replies to refused commands."""

CUT_PATH = 59
"""Bytes to which CREATE_DIR and DELETE_FILE cut a path."""

RESERVE = 300 * 1024
"""Bytes that a download must leave free."""

_REPLY_HEAD = HEADER_SIZE + 2
_ROOM_WITH_SIZE = MAX_FRAME - _REPLY_HEAD - 5
"""Bytes of contents that fit a reply with a size and a handle."""

_ROOM = MAX_FRAME - _REPLY_HEAD - 1
"""Bytes of contents that fit a reply with a handle."""

_OPEN_HANDLES = bytes(HANDLES // 8 + 1)
"""The constant answer of LIST_OPEN_HANDLES."""

_EMPTY = {"size": 0, "list_size": 0, "handle": NO_HANDLE, "data": b"", "list": ""}
"""The fields of replies that read nothing."""

_ADDRESS_ROOM = int(CONSTANTS["BTADRSIZE"])


class Answer(NamedTuple):
    """The answer to a system command."""

    status: SystemStatus  # the status
    fields: Mapping[str, Any]  # by name: the reply's other fields, possibly more
    is_error: bool = True  # whether a status that is a failure makes it an error reply
    rest: bytes = b""  # bytes after the fields


class Request(NamedTuple):
    """A received system command."""

    channel: Hashable
    fields: Mapping[str, Any]  # the fields that are present, by name; texts as bytes
    rest: bytes  # the bytes after them

    def number(self, name: str) -> int:
        """Returns a number; 0 if the frame ends before it, as in the firmware's buffer."""
        return int(self.fields.get(name, 0))

    def text(self, name: str) -> bytes:
        """Returns a text, up to its zero or the end of the frame."""
        return bytes(self.fields.get(name, self.rest.partition(b"\0")[0]))


@dataclass
class OpenTransfer:
    """A file or a listing in transit."""

    channel: Hashable  # the connection that began it
    command: str  # the command that began it
    stream: StoredFile | io.BytesIO  # where it is written to or read from
    size: int  # its total size in bytes
    place: Path | None = None  # of the file, to see which program has it open; None for a listing
    done: int = 0  # bytes transferred so far


class SystemCommands:
    """The transfers in progress, and what answers system commands."""

    def __init__(self, brick: Equipment, machine: Machine) -> None:
        self._brick = brick
        self.files = brick.files
        self._machine = machine
        self._transfers: dict[int, OpenTransfer] = {}

    def answer(self, channel: Hashable, frame: bytes) -> tuple[bool, bytes] | None:
        """Executes a system command.

        Returns whether the reply is an error, and its bytes after the header; None for commands without a reply and
        for those that the firmware does not know.
        """
        if len(frame) <= HEADER_SIZE:
            return None
        number = frame[HEADER_SIZE]
        entry = SYSTEM_BY_NUMBER.get(number)
        function = _FUNCTIONS.get(entry.name) if entry is not None and not entry.bootloader else None
        if function is None:
            return None
        fields, at, _ = REQUESTS[number].read_leniently(frame, HEADER_SIZE + 1, complete=False)
        values = {
            name: value.encode(STRING_CODING) if isinstance(value, str) else value for name, value in fields.items()
        }
        found = function(self, Request(channel, values, frame[at:]))
        if found is None:
            return None
        is_error = found.is_error and found.status.is_failure
        reply = REPLIES[number]
        fields = {field.name: found.fields[field.name] for field in reply.fields if field.name in found.fields}
        return is_error, bytes((number, found.status)) + reply.write_present(fields) + found.rest

    def disconnect(self, channel: Hashable) -> None:
        """Frees the handles of a connection that has ended."""
        for handle, transfer in list(self._transfers.items()):
            if transfer.channel == channel:
                self._release(handle)

    # Handles

    def _add(self, transfer: OpenTransfer) -> int | None:
        handle = next((number for number in range(HANDLES) if number not in self._transfers), None)
        if handle is not None:
            self._transfers[handle] = transfer
        return handle

    def _release(self, handle: int) -> None:
        self._transfers.pop(handle).stream.close()

    def _find(self, request: Request, command: str) -> OpenTransfer | None:
        transfer = self._transfers.get(request.number("handle"))
        return transfer if transfer is not None and transfer.command == command else None

    def _is_name(self, path: bytes) -> bool:
        """Returns whether a file may have this name; if not, logs the error."""
        is_name = is_allowed(path)
        if not is_name:
            self._brick.settings.log_once("FILE_NAME_ERROR")
        return is_name

    # To the brick

    def begin_download(self, request: Request) -> Answer:
        """Creates the file and the missing folders."""
        path, size = request.text("path"), request.number("size")
        files = self.files
        if not self._is_name(path) or len(self._transfers) >= HANDLES:
            return _refused(SystemStatus.NO_HANDLES_AVAILABLE)
        if size > files.free - RESERVE:
            return _refused(SystemStatus.SIZE_ERROR)
        files.make_folders(path)
        file = files.open_to_write(path)
        if file is None:
            return _refused(SystemStatus.UNKNOWN_HANDLE)
        handle = self._add(OpenTransfer(request.channel, "BEGIN_DOWNLOAD", file, size, files.locate(path)))
        assert handle is not None
        return self._download(handle, bytes(request.fields.get("data", b"")))

    def continue_download(self, request: Request) -> Answer:
        """Writes up to the size that was announced."""
        if self._find(request, "BEGIN_DOWNLOAD") is None:
            return _refused(SystemStatus.UNKNOWN_HANDLE)
        return self._download(request.number("handle"), bytes(request.fields.get("data", b"")))

    def _download(self, handle: int, data: bytes) -> Answer:
        transfer = self._transfers[handle]
        data = data[: transfer.size - transfer.done]
        if not (isinstance(transfer.stream, StoredFile) and transfer.stream.put(data)):
            self._release(handle)
            return _refused(SystemStatus.SIZE_ERROR)
        transfer.done += len(data)
        if transfer.done < transfer.size:
            return Answer(SystemStatus.SUCCESS, {"handle": handle})
        self._release(handle)
        return Answer(SystemStatus.END_OF_FILE, {"handle": handle})

    # From the brick

    def open(self, request: Request, command: str, bad_name: SystemStatus, missing: SystemStatus) -> Answer:
        """Opens a file, which for GETFILE may still grow, and sends its first piece."""
        path = request.text("path")
        if not self._is_name(path) or len(self._transfers) >= HANDLES:
            return Answer(bad_name, _EMPTY)
        file = self.files.open_to_read(path)
        if file is None:
            return Answer(missing, _EMPTY)
        return self._begin(request, OpenTransfer(request.channel, command, file, 0, self.files.locate(path)), missing)

    def list_files(self, request: Request) -> Answer:
        """Makes the listing of a folder, and sends its first piece."""
        listing = self.files.listing(request.text("path"))
        if listing is None:
            return Answer(SystemStatus.UNKNOWN_ERROR, _EMPTY)
        transfer = OpenTransfer(request.channel, "LIST_FILES", io.BytesIO(listing), len(listing))
        return self._begin(request, transfer, SystemStatus.UNKNOWN_ERROR)

    def _begin(self, request: Request, transfer: OpenTransfer, no_handle: SystemStatus) -> Answer:
        handle = self._add(transfer)
        return Answer(no_handle, _EMPTY) if handle is None else self._piece(request, handle, has_size=True)

    def proceed(self, request: Request, command: str, unknown: SystemStatus) -> Answer:
        """Sends the next piece, cut wherever it is full; for GETFILE with the present size of the file."""
        if self._find(request, command) is None:
            return Answer(unknown, _EMPTY)
        return self._piece(request, request.number("handle"), has_size=command == "BEGIN_GETFILE")

    def _piece(self, request: Request, handle: int, *, has_size: bool) -> Answer:
        """Reads a piece, and ends the transfer with the last one."""
        transfer = self._transfers[handle]
        if has_size and isinstance(transfer.stream, StoredFile):
            transfer.size = os.fstat(transfer.stream.fileno()).st_size
        room = _ROOM_WITH_SIZE if has_size else _ROOM
        data = (
            transfer.stream.read(min(request.number("max_bytes"), room, max(0, transfer.size - transfer.done))) or b""
        )
        transfer.done += len(data)
        sizes = {"size": transfer.size, "list_size": transfer.size}
        fields = sizes | {"handle": handle, "data": data, "list": data.decode(STRING_CODING)}
        if transfer.done < transfer.size or self._is_growing(transfer):
            return Answer(SystemStatus.SUCCESS, fields)
        self._release(handle)
        return Answer(SystemStatus.END_OF_FILE, fields)

    def _is_growing(self, transfer: OpenTransfer) -> bool:
        """Returns whether a user's program still has the file open to write; only GETFILE asks."""
        program = self._machine.slots[USER_SLOT]
        if transfer.command != "BEGIN_GETFILE" or program is None:
            return False
        files = (entry for entry in program.handles.entries() if isinstance(entry, OpenFile))
        return any(file.for_writing and file.place == transfer.place for file in files)

    # The rest

    def close_filehandle(self, request: Request) -> Answer:
        """Closes any handle."""
        handle = request.number("handle")
        if handle not in self._transfers:
            # The one error that echoes the handle.
            return Answer(SystemStatus.UNKNOWN_HANDLE, {"handle": handle})
        self._release(handle)
        return Answer(SystemStatus.SUCCESS, {"handle": handle})

    def write_mailbox(self, request: Request) -> None:
        """Delivers a message to the first box of that name."""
        if "payload" in request.fields:
            self._brick.mailboxes.deliver(request.text("name"), bytes(request.fields["payload"]))

    def bluetooth_pin(self, request: Request) -> Answer:
        """Refuses by the status, not by the type of the reply: it works on USB only, which this brick lacks."""
        address = self._brick.settings.bluetooth_address
        length = request.number("pin_length")
        fields = {"mac_length": _ADDRESS_ROOM, "mac": address, "pin_length": length}
        # As many bytes as the request counts, which need not include a zero.
        pin = request.text("pin").ljust(length, b"\0")[:length]
        return Answer(SystemStatus.ILLEGAL_CONNECTION, fields, is_error=False, rest=pin)


def _set_bundle(command: str, request: Request) -> Answer:
    """Accepts any that fits."""
    entry = next(entry for entry in SYSTEM_BY_NUMBER.values() if entry.name == command)
    most = entry.request[0].most
    fits = most is None or len(request.text("id")) < most
    return Answer(SystemStatus.SUCCESS if fits else SystemStatus.SIZE_ERROR, {})


def _refused(status: SystemStatus) -> Answer:
    return Answer(status, {"handle": NO_HANDLE})


def _permitted(is_done: bool) -> Answer:
    return Answer(SystemStatus.SUCCESS if is_done else SystemStatus.NO_PERMISSION, {})


_NO_HANDLES, _UNKNOWN = SystemStatus.NO_HANDLES_AVAILABLE, SystemStatus.UNKNOWN_HANDLE
_NOT_READY, _ERROR = SystemStatus.HANDLE_NOT_READY, SystemStatus.UNKNOWN_ERROR

_FUNCTIONS: dict[str, Callable[[SystemCommands, Request], Answer | None]] = {
    "BEGIN_DOWNLOAD": SystemCommands.begin_download,
    "CONTINUE_DOWNLOAD": SystemCommands.continue_download,
    "BEGIN_UPLOAD": lambda commands, request: commands.open(request, "BEGIN_UPLOAD", _NO_HANDLES, _UNKNOWN),
    "CONTINUE_UPLOAD": lambda commands, request: commands.proceed(request, "BEGIN_UPLOAD", _UNKNOWN),
    "BEGIN_GETFILE": lambda commands, request: commands.open(request, "BEGIN_GETFILE", _UNKNOWN, _NOT_READY),
    "CONTINUE_GETFILE": lambda commands, request: commands.proceed(request, "BEGIN_GETFILE", _UNKNOWN),
    "LIST_FILES": SystemCommands.list_files,
    "CONTINUE_LIST_FILES": lambda commands, request: commands.proceed(request, "LIST_FILES", _ERROR),
    "CLOSE_FILEHANDLE": SystemCommands.close_filehandle,
    "CREATE_DIR": lambda commands, request: _permitted(commands.files.make_folder(request.text("path")[:CUT_PATH])),
    "DELETE_FILE": lambda commands, request: _permitted(commands.files.delete(request.text("path")[:CUT_PATH])),
    "LIST_OPEN_HANDLES": lambda *_: Answer(SystemStatus.SUCCESS, {"handles": _OPEN_HANDLES}),
    "WRITEMAILBOX": SystemCommands.write_mailbox,
    "BLUETOOTHPIN": SystemCommands.bluetooth_pin,
    "SETBUNDLEID": lambda _, request: _set_bundle("SETBUNDLEID", request),
    "SETBUNDLESEEDID": lambda _, request: _set_bundle("SETBUNDLESEEDID", request),
}
"""What answers each system command; it returns None for one that is not answered."""
