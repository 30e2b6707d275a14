"""Dialogues: the pairing of replies with commands, and the meaning of each reply.

A reply to a direct command is only memory. The command's output parameters that are global variables
tell what it contains and where, so a `Dialogue` remembers commands. Replies to system commands have fields
of their own; for these it remembers which file belongs to each handle.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Hashable
from dataclasses import dataclass, field
from typing import Generic, TypeVar

from ev3proto.bounded import DEFAULT_MEMORY, Budget, dropper
from ev3proto.messages import DirectCommand, DirectReply, FieldValue, Message, SystemCommand, SystemReply
from ev3proto.semantics.replies import Value, ValueType, reply_values, values_of
from ev3proto.tables.system import SYSTEM_BY_NUMBER, SystemStatus

T = TypeVar("T")

MOST_PENDING = 65536
"""Maximum number of remembered commands without a reply: one per counter."""

MOST_PER_KEY = 4
"""Maximum number of remembered commands with the same counter, for senders that never change it."""


class Pairing(Generic[T]):
    """Commands, in any form, that are remembered until their replies come.

    Unanswered commands are forgotten when their counter was reused often enough, or too many are pending.

    key   the key that a reply shares with the command it answers
    size  the reply size that a direct command requests, or that a reply has

    A budget limits the memory of all pairings that share it; `size_of` returns the bytes of a command.
    """

    def __init__(
        self, most: int = MOST_PENDING, budget: Budget | None = None, size_of: Callable[[T], int] = sys.getsizeof
    ) -> None:
        self._most = most
        self._budget = Budget(sys.maxsize) if budget is None else budget
        self._size_of = size_of
        self._drop = dropper(self)
        self._newest: dict[Hashable, int] = {}
        self._older: dict[Hashable, list[int]] = {}  # if several have the same key, which is rare
        self._waiting: dict[int, tuple[Hashable, int, T, int]] = {}  # key, size, command, the budget's id
        self._seen = 0
        self._oldest = 0  # no command with a lower number is pending

    @property
    def unanswered(self) -> list[T]:
        """The commands still waiting for their reply, oldest first."""
        return [command for _, _, command, _ in self._waiting.values()]

    def remember(self, key: Hashable, size: int, command: T) -> T | None:
        """Adds a command that waits for its reply. Returns the command forgotten for it, if any."""
        budget = self._budget
        given = budget.given = budget.given + 1
        number = self._seen
        self._seen = number + 1
        before = self._newest.get(key)
        self._newest[key] = number
        self._waiting[number] = key, size, command, given
        budget.hold(given, self._size_of(command), self._drop, number)
        if before is not None:
            older = self._older.setdefault(key, [])
            older.append(before)
            if len(older) >= MOST_PER_KEY:
                return self._forget(older[0])
        if len(self._waiting) > self._most:
            while self._oldest not in self._waiting:
                self._oldest += 1
            return self._forget(self._oldest)
        return None

    def answered(self, key: Hashable, size: int | None) -> T | None:
        """Returns the command that a reply answers: the newest that requested this size, else the newest, else None.

        The newest, because a sender reuses a counter only after it gave up on the one before. `size` is None
        for a reply without a meaningful size.
        """
        newest = self._newest.get(key)
        if newest is None:
            return None
        if size is not None and key in self._older:
            for number in (newest, *reversed(self._older[key])):
                if self._waiting[number][1] == size:
                    return self._forget(number)
        return self._forget(newest)

    def __del__(self) -> None:
        for *_, given in self._waiting.values():
            self._budget.release(given)

    def forget(self, number: int) -> None:
        """Forgets the command with a number, if it is still pending."""
        if number in self._waiting:
            self._forget(number)

    def _forget(self, number: int) -> T:
        key, _, command, given = self._waiting.pop(number)
        self._budget.release(given)
        if key not in self._older:
            del self._newest[key]
            return command
        older = self._older[key]
        if number == self._newest[key]:
            self._newest[key] = older.pop()
        else:
            older.remove(number)
        if not older:
            del self._older[key]
        return command


MOST_BEGUN = 4096
"""Maximum number of unanswered BEGIN_... commands; the same as in a conversation."""

_SIZE = 400
"""Approximate memory of a transfer besides its path, in bytes."""

_HANDLES = 1 << 16
"""Added to a handle in a budget's numbers for transfers: lower numbers are counters."""


@dataclass(slots=True)
class Transfer:
    """A transfer of a file or listing, from its BEGIN_... to its end.

    command      the BEGIN_... command's name
    path         path of the file or folder
    size         total bytes, None until known
    handle       the brick's handle, None until known
    transferred  bytes transferred so far
    """

    command: str
    path: str
    size: int | None = None
    handle: int | None = None
    transferred: int = 0

    @property
    def is_complete(self) -> bool:
        """Whether everything was transferred."""
        return self.size is not None and self.transferred >= self.size


class Transfers:
    """The transfers between one computer and one brick, distinguished by the brick's handles.

    A budget limits the memory of all that share it; evicted transfers are forgotten.
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
        """Forgets a transfer; its number is the counter of its command, or derived from its handle."""
        if number < _HANDLES:
            self._begun.pop(number, None)
        else:
            self._open.pop(number - _HANDLES, None)

    def requested(self, message: SystemCommand) -> Transfer | None:
        """Returns the transfer of a command, including its own data; None if it has none that is known."""
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
            transfer.transferred = _moved_by(message)
            return transfer
        number = _number(message.fields.get("handle"))
        return self._moved(self._open.get(number), number, message)

    def progress(self, reply: SystemReply, request: Message | None) -> Transfer | None:
        """Returns the transfer of a reply to a command."""
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
                # The command was not seen: the handle now belongs to another, unknown file.
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
            # The brick frees a handle when its file is closed, complete or failed.
            if entry.transfer == "close" or reply.is_error or reply.status is SystemStatus.END_OF_FILE:
                self._remove(self._open.pop(number, None))
        if transfer is not None:
            for name in ("size", "list_size"):
                if name in reply.fields:
                    transfer.size = _number(reply.fields[name])
        return self._moved(transfer, number, reply)

    def _moved(self, transfer: Transfer | None, number: int, message: SystemCommand | SystemReply) -> Transfer | None:
        """Returns the transfer of a handle, including the data of a message.

        A complete transfer takes no more data, since the brick has closed it. The handle then belongs to another one,
        whose beginning was not seen.
        """
        size = _moved_by(message)
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


def _moved_by(message: SystemCommand | SystemReply) -> int:
    """Returns the number of bytes of a file or listing in a message."""
    pieces = [message.fields.get(name, b"") for name in ("data", "list")]
    return sum(len(piece) for piece in pieces if isinstance(piece, bytes | str))


def _number(value: FieldValue | None) -> int:
    return value if isinstance(value, int) else -1


__all__ = ["Dialogue", "Exchange", "Transfer", "Value", "ValueType", "reply_values", "values_of"]


_BYTES_EACH = 130
"""Approximate memory of a message per byte of its frame, if each byte is an operation."""

_LEAST = 600
"""Further memory of a message, in bytes."""


@dataclass(frozen=True, slots=True)
class Exchange:
    """One message of a dialogue with everything known about it.

    message   the message itself
    request   for a reply: the command it answers, None if it was not seen
    values    for a reply: its values by name
    transfer  the file transfer of the message, or None
    """

    message: Message
    request: Message | None = None
    values: list[Value] = field(default_factory=list)
    transfer: Transfer | None = None

    @property
    def is_orphan(self) -> bool:
        """Whether it is a reply to a command that was not seen."""
        return self.request is None and self.message.type is not None and not self.message.type.is_command


class Dialogue:
    """The conversation between one computer and one brick, followed message by message in both directions."""

    def __init__(self, memory: int = DEFAULT_MEMORY) -> None:
        """Starts a dialogue.

        Args:
            memory: Approximate limit for unanswered commands and transfers, in bytes; the oldest are dropped first.

        """
        self._budget = Budget(memory)
        self._pairing: Pairing[Message] = Pairing(budget=self._budget, size_of=_size_of)
        self._transfers = Transfers(self._budget)

    @property
    def forgotten(self) -> int:
        """The number of commands and files dropped because too much was pending."""
        return self._budget.dropped

    @property
    def unanswered(self) -> list[Message]:
        """The commands still waiting for their reply, oldest first."""
        return self._pairing.unanswered

    def feed(self, message: Message) -> list[Value]:
        """Returns the values of a reply by name. Feed or follow each message once, in order, both directions.

        Args:
            message: The next message.

        Returns:
            The values of a reply; an empty list for commands and for replies to commands that were not seen.
        """
        return self.follow(message).values

    def follow(self, message: Message) -> Exchange:
        """Returns everything known about a message: the command it answers, the values, the file transfer.

        Args:
            message: The next message.

        Returns:
            The exchange.
        """
        if not isinstance(message, Message):
            raise TypeError(f"a dialogue takes messages, not {type(message).__name__}: use ev3proto.parse(frame)")
        if message.type is None:
            return Exchange(message)
        key, size = _pairing(message)
        if message.type.is_command:
            if message.wants_reply:
                self._pairing.remember(key, size or 0, message)
            transfer = self._transfers.requested(message) if isinstance(message, SystemCommand) else None
            return Exchange(message, transfer=transfer)
        request = self._pairing.answered(key, size)
        transfer = self._transfers.progress(message, request) if isinstance(message, SystemReply) else None
        return Exchange(message, request, values_of(message, request), transfer)


def _size_of(message: Message) -> int:
    return _LEAST + _BYTES_EACH * message.length


def _pairing(message: Message) -> tuple[tuple[str, int, int], int | None]:
    """Returns a message's key for pairing, and the size of the reply."""
    carries = "" if message.type is None else message.type.carries
    if isinstance(message, SystemCommand | SystemReply):
        return (carries, message.counter, message.number), None
    size = None
    if isinstance(message, DirectCommand):
        size = message.global_size
    elif isinstance(message, DirectReply) and not message.is_error:
        size = len(message.memory)
    return (carries, message.counter, 0), size
