"""Dialogues: which reply answers which command, and what the reply therefore says.

A reply to a direct command is nothing but memory. Every output parameter of the command that names a global variable
says what stands in it and where, so a `Dialogue` remembers the commands it saw. Replies to system commands have fields
of their own; there it remembers which file each handle stands for.
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
"""Commands without a reply that are remembered: as many as there are counters."""

MOST_PER_KEY = 4
"""Commands with the same counter that are remembered, for senders who never change it."""


class Pairing(Generic[T]):
    """Remembers commands, in whatever form, until their replies come.

    Commands whose reply never comes are forgotten when their counter is used again often enough or too many wait.

    key   what a reply has in common with the command that it answers
    size  what a direct command asks for, and how much its reply carries

    A budget limits the memory of the commands of all pairings that share it; `size_of` says how many bytes one takes.
    """

    def __init__(
        self, most: int = MOST_PENDING, budget: Budget | None = None, size_of: Callable[[T], int] = sys.getsizeof
    ) -> None:
        self._most = most
        self._budget = Budget(sys.maxsize) if budget is None else budget
        self._size_of = size_of
        self._drop = dropper(self)
        self._newest: dict[Hashable, int] = {}
        self._older: dict[Hashable, list[int]] = {}  # where several have the same key, which is rare
        self._waiting: dict[int, tuple[Hashable, int, T, int]] = {}  # key, size, command, the budget's number
        self._seen = 0
        self._oldest = 0  # no command with a lower number waits

    @property
    def unanswered(self) -> list[T]:
        """The commands that wait for their reply, oldest first."""
        return [command for _, _, command, _ in self._waiting.values()]

    def remember(self, key: Hashable, size: int, command: T) -> T | None:
        """Waits for the command's reply. Returns the command that is forgotten for it, if any is."""
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
        """The command that a reply answers: the newest that asked for this size, else the newest; None if none waits.

        The newest, because a sender comes back to a counter only after it gave up on the one before. `size` is None
        for a reply that tells nothing by it.
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
        """Waits no longer for the reply to the command of a number, if it still does."""
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
            transfer.transferred = _moved_by(message)
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
    """Bytes of a file or listing that a message carries."""
    pieces = [message.fields.get(name, b"") for name in ("data", "list")]
    return sum(len(piece) for piece in pieces if isinstance(piece, bytes | str))


def _number(value: FieldValue | None) -> int:
    return value if isinstance(value, int) else -1


__all__ = ["Dialogue", "Exchange", "Transfer", "Value", "ValueType", "reply_values", "values_of"]


_BYTES_EACH = 130
"""Bytes of memory that a message takes for each byte of its frame, about: as many where each is an operation."""

_LEAST = 600
"""Bytes of memory that it takes besides."""


@dataclass(frozen=True, slots=True)
class Exchange:
    """What a dialogue makes of one message.

    message   the message itself
    request   for a reply: the command it answers; None when no such command was seen
    values    for a reply: what it says, by name
    transfer  the file that the message is about, None where it is about none
    """

    message: Message
    request: Message | None = None
    values: list[Value] = field(default_factory=list)
    transfer: Transfer | None = None

    @property
    def is_orphan(self) -> bool:
        """True for a reply to a command that was not seen."""
        return self.request is None and self.message.type is not None and not self.message.type.is_command


class Dialogue:
    """Follows the messages between one computer and one brick, in order, both directions."""

    def __init__(self, memory: int = DEFAULT_MEMORY) -> None:
        """Begins a dialogue.

        Args:
            memory: Bytes that commands without a reply and files on their way may take, about; the oldest goes first.

        """
        self._budget = Budget(memory)
        self._pairing: Pairing[Message] = Pairing(budget=self._budget, size_of=_size_of)
        self._transfers = Transfers(self._budget)

    @property
    def forgotten(self) -> int:
        """How many commands and files had to go, because too much waited."""
        return self._budget.dropped

    @property
    def unanswered(self) -> list[Message]:
        """The commands that wait for their reply, oldest first."""
        return self._pairing.unanswered

    def feed(self, message: Message) -> list[Value]:
        """What a reply says, by name. Feed or follow each message once, in order, both directions.

        Args:
            message: The next message.

        Returns:
            The values of a reply; an empty list for commands and for replies to commands that were not seen.
        """
        return self.follow(message).values

    def follow(self, message: Message) -> Exchange:
        """The same with all that is known: the command that is answered, the values, the file.

        Args:
            message: The next message.

        Returns:
            What the messages before make of it.
        """
        if not isinstance(message, Message):
            raise TypeError(f"a dialogue takes messages, not {type(message).__name__}: ev3proto.parse(frame) makes one")
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
    """What a pairing must know of a message: what command and reply have in common, and the size of the reply."""
    carries = "" if message.type is None else message.type.carries
    if isinstance(message, SystemCommand | SystemReply):
        return (carries, message.counter, message.number), None
    size = None
    if isinstance(message, DirectCommand):
        size = message.global_size
    elif isinstance(message, DirectReply) and not message.is_error:
        size = len(message.memory)
    return (carries, message.counter, 0), size
