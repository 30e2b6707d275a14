"""What a client reads of the brick's files: in the proxy's own pieces, by handles that only the proxy uses.

Sizes and handles of the client never reach the brick: it may ask for any number of bytes, close, or go.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from typing import TypeAlias, TypeVar

from ev3proto.link.transfers import OpenTransfers, next_of
from ev3proto.link.whitelist import is_own
from ev3proto.messages import SystemCommand, SystemReply
from ev3proto.schema.fields import REPLIES
from ev3proto.schema.frame import parse
from ev3proto.schema.header import build_frame
from ev3proto.semantics.transfers import LISTINGS, is_complete, piece_of, read_listing, size_of
from ev3proto.system import begin_upload, continue_list_files, continue_upload, list_files
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.frame import MAX_FRAME, MessageType
from ev3proto.tables.system import SystemStatus

T = TypeVar("T")
Reading: TypeAlias = Generator[bytes, bytes | None, T]
"""Yields frames to send, and takes the reply to each; None if none came."""

FIRST_HANDLE, _HANDLES = 64, 128

MOST_KEPT = 1 << 20
"""Bytes of a file that are kept for a client while another one reads."""


class Reader:
    """Reads the file or folder of a client; at most one is open on the brick.

    The handles that the client gets are none that a brick has, and each is used once.
    """

    def __init__(self) -> None:
        self._transfers = OpenTransfers()
        self.handles: dict[int, str] = {}  # the handle that the client has, and the command that began it
        self._next = 0
        self._size, self._sent, self._rest = 0, 0, b""

    @property
    def is_open(self) -> bool:
        """Whether something is open on the brick."""
        return bool(self._transfers)

    def serve(self, command: SystemCommand) -> Reading[bytes]:
        """Returns the reply to a command that begins a transfer, or continues or closes one of `handles`."""
        name, path = str(command.command), command.fields.get("path")
        if path is not None:
            yield from self.leave()
            status = yield from self._begin(name, str(path))
            if status is not None:
                return _answer(command, status, -1, 0, b"")
        handle = next(iter(self.handles))
        if "max_bytes" not in command.fields:
            yield from self.leave()
            return _answer(command, SystemStatus.SUCCESS, handle, 0, b"")
        asked = min(int(command.fields["max_bytes"]), MAX_FRAME - len(_answer(command, None, handle, 0, b"")))
        had = -1
        while had < len(self._rest) <= asked and self._transfers:
            had = len(self._rest)
            yield from self._exchange_next()
        piece, self._rest = self._rest[:asked], self._rest[asked:]
        self._sent += len(piece)
        status = SystemStatus.SUCCESS
        if not self._rest and not self._transfers:
            self.handles.clear()
            is_whole = is_complete(self._sent, self._size)
            status = SystemStatus.END_OF_FILE if is_whole else SystemStatus.UNKNOWN_ERROR
        return _answer(command, status, handle, self._size, piece)

    def _begin(self, name: str, path: str) -> Reading[SystemStatus | None]:
        """Opens a file or folder. Returns what the brick has against it."""
        if name not in LISTINGS:
            # The firmware opens a folder as a file, too, so the folder above has to list it.
            status = yield from self._find(*path.rpartition("/")[::2])
            if status is not None:
                return status
        status = yield from self._open(list_files if name in LISTINGS else begin_upload, path)
        if status is None:
            self.handles[FIRST_HANDLE + self._next] = name
            self._next = (self._next + 1) % _HANDLES
        return status

    def _find(self, folder: str, file: str) -> Reading[SystemStatus | None]:
        """Looks for a file in the listing of its folder."""
        if not is_own(folder.encode(STRING_CODING)):
            return SystemStatus.ILLEGAL_PATH
        status = yield from self._open(list_files, folder)
        had = -1
        while self._transfers and had < len(self._rest) < self._size:
            had = len(self._rest)
            yield from self._exchange_next()
        listing = read_listing(self._rest)
        yield from self.leave()
        if status is None and file not in {one.name for one in listing.files}:
            return SystemStatus.ILLEGAL_FILENAME if file in listing.folders else SystemStatus.UNKNOWN_HANDLE
        return status

    def _open(self, begin: Callable[[str], SystemCommand], path: str) -> Reading[SystemStatus | None]:
        reply = yield from self._exchange(begin(path))
        if reply is None or reply.is_error:
            return SystemStatus.UNKNOWN_ERROR if reply is None else reply.status or SystemStatus.UNKNOWN_ERROR
        self._size, self._sent = size_of(reply) or 0, 0
        return None

    def read_on(self) -> Reading[None]:
        """Reads one more piece, and keeps it until it is asked for. Ends a file that gives none, or too much."""
        had = len(self._rest)
        yield from self._exchange_next()
        if not had < len(self._rest) <= MOST_KEPT:
            yield from self._end()

    def leave(self) -> Reading[None]:
        """Ends what is open on the brick, and forgets what was read of it."""
        yield from self._end()
        self.handles.clear()
        self._rest = b""

    def _end(self) -> Reading[None]:
        ending, reply, rest = self._transfers.ending(), None, self._rest
        while (command := next_of(ending, reply)) is not None:
            reply = yield from self._exchange(command)
        self._rest = rest

    def forget(self) -> None:
        """Forgets what is open: the connection is a new one."""
        self._transfers.clear()

    def _exchange_next(self) -> Reading[None]:
        ((handle, name),) = self._transfers.items()
        yield from self._exchange((continue_list_files if name in LISTINGS else continue_upload)(handle))

    def _exchange(self, command: SystemCommand) -> Reading[SystemReply | None]:
        data = yield command.build()
        reply = None if data is None else parse(data, strict=False)
        self._transfers.learn(command, reply)
        found = reply if isinstance(reply, SystemReply) and reply.number == command.number else None
        self._rest += b"" if found is None else piece_of(found)
        return found


def _answer(command: SystemCommand, status: SystemStatus | None, handle: int, size: int, data: bytes) -> bytes:
    listed = data.decode(STRING_CODING)
    values = {"handle": handle & 0xFF, "size": size, "list_size": size, "data": data, "list": listed}
    declared = REPLIES[command.number]
    is_fine = status in (SystemStatus.SUCCESS, SystemStatus.END_OF_FILE)
    fields = declared.write_present({one.name: values[one.name] for one in declared.fields})
    body = bytes((command.number, SystemStatus.UNKNOWN_ERROR if status is None else status)) + fields
    return build_frame(MessageType.SYSTEM_REPLY if is_fine else MessageType.SYSTEM_REPLY_ERROR, command.counter, body)
