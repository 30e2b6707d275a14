"""Files and listings on their way: which of them a system message is about, and how much of it was moved."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from ev3proto.bounded import Budget, dropper
from ev3proto.messages import FieldValue, Message, SystemCommand, SystemReply
from ev3proto.tables.system import SYSTEM_BY_NUMBER, SystemStatus

MOST_BEGUN = 4096
"""BEGIN_... commands whose reply is awaited; as many as wait in a conversation."""

_SIZE = 400
"""Bytes of memory that a transfer takes besides its path, about."""

_HANDLES = 1 << 16
"""What is added to a handle in the numbers by which a budget knows transfers: below are counters."""


@dataclass(slots=True)
class Transfer:
    """A file or listing on its way, from its BEGIN_... to its end.

    command      the BEGIN_... command's name
    path         what is moved
    size         bytes of it all, None until known
    handle       the brick's handle, None until known
    transferred  bytes moved so far
    """

    command: str
    path: str
    size: int | None = None
    handle: int | None = None
    transferred: int = 0

    @property
    def is_complete(self) -> bool:
        """True when everything was moved."""
        return self.size is not None and self.transferred >= self.size


class Transfers:
    """The files and listings between one computer and one brick, kept apart by the handles that the brick gives.

    A budget limits the memory of all that share it; a transfer that had to go is not known any more.
    """

    def __init__(self, budget: Budget | None = None) -> None:
        self._budget = budget
        self._drop: Callable[[int], None] | None = None
        self._begun: dict[int, Transfer] = {}
        self._open: dict[int, Transfer] = {}

    def __del__(self) -> None:
        for begun in (*self._begun.values(), *self._open.values()):
            self._remove(begun)

    def forget(self, number: int) -> None:
        """Follows a transfer no longer; its number is the counter of its command, or comes from its handle."""
        if number < _HANDLES:
            self._begun.pop(number, None)
        else:
            self._open.pop(number - _HANDLES, None)

    def requested(self, message: SystemCommand) -> Transfer | None:
        """What a command moves, its own data counted in; None for a command that moves nothing that is known."""
        entry = SYSTEM_BY_NUMBER.get(message.number)
        if entry is None or entry.transfer is None:
            return None
        if entry.transfer == "begin":
            path = str(message.fields.get("path", ""))
            size = message.fields.get("size")
            transfer = Transfer(entry.name, path, size if isinstance(size, int) else None)
            self._remove(self._begun.pop(message.counter, None))
            self._begun[message.counter] = transfer
            self._add(transfer, message.counter)
            if len(self._begun) > MOST_BEGUN:
                self._remove(self._begun.pop(next(iter(self._begun))))
            return transfer
        number = _number(message.fields.get("handle"))
        return self._moved(self._open.get(number), number, message)

    def progress(self, reply: SystemReply, request: Message | None) -> Transfer | None:
        """The same for a reply, with the command that it answers."""
        entry = SYSTEM_BY_NUMBER.get(reply.number)
        if entry is None or entry.transfer is None:
            return None
        if entry.transfer == "begin":
            transfer = self._begun.pop(reply.counter, None)
            self._remove(transfer)
            if reply.is_error or "handle" not in reply.fields:
                return transfer
            number = _number(reply.fields["handle"])
            self._remove(self._open.pop(number, None))
            if transfer is None:
                # The command was not seen: the handle stands for another file than before, nobody knows which.
                return None
            transfer.handle = number
            self._open[number] = transfer
            self._add(transfer, _HANDLES + number)
        else:
            handle = reply.fields.get("handle")
            if handle is None and isinstance(request, SystemCommand):
                handle = request.fields.get("handle")
            number = _number(handle)
            transfer = self._open.get(number)
            # The brick takes a handle back when a file is closed, complete or in trouble.
            if entry.transfer == "close" or reply.is_error or reply.status is SystemStatus.END_OF_FILE:
                self._remove(self._open.pop(number, None))
        if transfer is not None:
            for name in ("size", "list_size"):
                if name in reply.fields:
                    transfer.size = _number(reply.fields[name])
        return self._moved(transfer, number, reply)

    def _moved(self, transfer: Transfer | None, number: int, message: SystemCommand | SystemReply) -> Transfer | None:
        """The transfer under a handle, with what a message has of it counted in.

        One that is complete takes no more, as the brick has closed it. Then the handle stands for another one, whose
        beginning was not seen, and nothing is known of that.
        """
        pieces = [message.fields.get(name, b"") for name in ("data", "list")]
        size = sum(len(piece) for piece in pieces if isinstance(piece, bytes | str))
        if transfer is None or not size:
            return transfer
        if transfer.is_complete:
            self._remove(self._open.pop(number, None))
            return None
        transfer.transferred += size
        return transfer

    def _add(self, transfer: Transfer, number: int) -> None:
        if self._budget is not None:
            if self._drop is None:
                self._drop = dropper(self)
            self._budget.add(transfer, _SIZE + len(transfer.path), self._drop, number)

    def _remove(self, transfer: Transfer | None) -> None:
        if self._budget is not None and transfer is not None:
            self._budget.remove(transfer)


def _number(value: FieldValue | None) -> int:
    return value if isinstance(value, int) else -1
