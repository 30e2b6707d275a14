"""The file handles that a brick has given to one client, as its replies tell."""

from __future__ import annotations

from ev3proto.messages import Message, SystemReply
from ev3proto.tables.system import SYSTEM_BY_NUMBER, SystemStatus


class OpenHandles:
    """Handles of files and listings that are open."""

    def __init__(self) -> None:
        """Starts without any."""
        self._handles: set[int] = set()

    def __contains__(self, handle: object) -> bool:
        return handle in self._handles

    def take(self) -> list[int]:
        """Returns all handles, and forgets them."""
        found = sorted(self._handles)
        self._handles.clear()
        return found

    def learn(self, reply: Message) -> None:
        """Takes a reply: the brick closes a file at its end and after an error."""
        if not isinstance(reply, SystemReply):
            return
        entry, handle = SYSTEM_BY_NUMBER.get(reply.number), reply.fields.get("handle")
        if entry is None or entry.transfer is None or not isinstance(handle, int):
            return
        if entry.transfer == "begin":
            if reply.status is SystemStatus.SUCCESS:
                self._handles.add(handle)
        elif entry.transfer == "close" or reply.status is not SystemStatus.SUCCESS:
            self._handles.discard(handle)
