"""The file handles that a brick has given to one client, according to its replies."""

from __future__ import annotations

from ev3proto.messages import Message, SystemCommand, SystemReply
from ev3proto.tables.system import SYSTEM_BY_NUMBER, SystemStatus


class OpenHandles:
    """Handles of open files and listings."""

    def __init__(self) -> None:
        """Starts without handles."""
        self._handles: set[int] = set()

    def __contains__(self, handle: object) -> bool:
        return handle in self._handles

    def take(self) -> list[int]:
        """Returns all handles, and forgets them."""
        found = sorted(self._handles)
        self._handles.clear()
        return found

    def __len__(self) -> int:
        return len(self._handles)

    def lend(self, command: Message) -> None:
        """Forgets the handle of a command until its reply: the brick may close it, and give it to another client."""
        handle = command.fields.get("handle") if isinstance(command, SystemCommand) else None
        if isinstance(handle, int):
            self._handles.discard(handle)

    def learn(self, reply: Message) -> None:
        """Takes a reply: the brick closes a file at its end and after an error."""
        if not isinstance(reply, SystemReply):
            return
        entry, handle = SYSTEM_BY_NUMBER.get(reply.number), reply.fields.get("handle")
        if entry is None or entry.transfer is None or not isinstance(handle, int):
            return
        if entry.transfer != "close" and reply.status is SystemStatus.SUCCESS:
            self._handles.add(handle)
        elif entry.transfer != "begin":
            self._handles.discard(handle)
