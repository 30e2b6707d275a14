"""The files and listings that one client has open on a brick, according to the replies to its own commands."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from ev3proto.messages import Message, SystemCommand, SystemReply
from ev3proto.tables.system import SYSTEM_BY_NUMBER, SystemDeclaration, SystemStatus

NO_TRANSFERS: Mapping[int, str] = MappingProxyType({})

_HANDLES = range(64)
_LIST = "LIST_FILES"


def is_listing(name: str) -> bool:
    """Returns whether a system command begins or continues the listing of a folder."""
    return name.endswith(_LIST)


def _kind(name: str) -> str:
    """Returns what is transferred: BEGIN_UPLOAD and CONTINUE_UPLOAD are both UPLOAD."""
    return name.removeprefix("BEGIN_").removeprefix("CONTINUE_")


def is_of(entry: SystemDeclaration, handle: object, transfers: Mapping[int, str]) -> bool:
    """Returns whether a command continues a transfer of its own kind, or closes one that is not a listing."""
    begun = transfers.get(handle) if isinstance(handle, int) else None
    if begun is None:
        return False
    return not is_listing(begun) if entry.transfer == "close" else _kind(entry.name) == _kind(begun)


class OpenTransfers(dict[int, str]):
    """The open transfers: for each handle the name of the command that began it."""

    def learn(self, command: Message, reply: Message | None) -> None:
        """Takes a command and its reply: the brick ends a transfer with its last piece, and after an error.

        Without a reply it may have been the last piece, after which the handle is another client's.
        """
        entry = SYSTEM_BY_NUMBER.get(command.number) if isinstance(command, SystemCommand) else None
        if entry is None or entry.transfer is None:
            return
        assert isinstance(command, SystemCommand)
        is_open = _is_success(command, reply)
        named = reply.fields if entry.transfer == "begin" and isinstance(reply, SystemReply) else command.fields
        handle = named.get("handle")
        if not isinstance(handle, int) or handle not in _HANDLES:
            return
        if is_open and entry.transfer == "begin":
            self[handle] = entry.name
        elif not is_open or entry.transfer == "close":
            self.pop(handle, None)


def _is_success(command: SystemCommand, reply: Message | None) -> bool:
    if not isinstance(reply, SystemReply):
        return False
    return reply.number == command.number and reply.status is SystemStatus.SUCCESS
