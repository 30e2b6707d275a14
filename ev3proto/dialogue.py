"""Dialogues: the meaning of each reply, and the progress of file transfers.

A reply to a direct command is only memory. The command's output parameters that are global variables
tell what it contains and where, so a `Dialogue` remembers commands. Replies to system commands have fields
of their own; for these it remembers which file belongs to each handle.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from ev3proto.bounded import DEFAULT_MEMORY, Budget, dropper
from ev3proto.messages import FieldValue, Message, SystemCommand, SystemReply
from ev3proto.semantics.pairing import MOST_PENDING, MOST_PER_KEY, Pairing, pairing_key
from ev3proto.semantics.replies import Value, ValueType, reply_values, values_of
from ev3proto.semantics.transfers import ends, is_complete, piece_of, size_of
from ev3proto.tables.system import SYSTEM_BY_NUMBER

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
        return is_complete(self.transferred, self.size)


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
            transfer = Transfer(entry.name, path, size_of(message))
            self._remove(self._begun.pop(message.counter, None))
            self._begun[message.counter] = transfer
            self._add(transfer, message.counter)
            if len(self._begun) > MOST_BEGUN:
                self._remove(self._begun.pop(next(iter(self._begun))))
            transfer.transferred = len(piece_of(message))
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
            if ends(reply):
                self._remove(self._open.pop(number, None))
        if transfer is not None:
            size = size_of(reply)
            transfer.size = transfer.size if size is None else size
        return self._moved(transfer, number, reply)

    def _moved(self, transfer: Transfer | None, number: int, message: SystemCommand | SystemReply) -> Transfer | None:
        """Returns the transfer of a handle, including the data of a message.

        A complete transfer takes no more data, since the brick has closed it. The handle then belongs to another one,
        whose beginning was not seen.
        """
        size = len(piece_of(message))
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


__all__ = [
    "MOST_PENDING",
    "MOST_PER_KEY",
    "Dialogue",
    "Exchange",
    "Transfer",
    "Value",
    "ValueType",
    "reply_values",
    "values_of",
]


_BYTES_EACH = 130
"""Approximate memory of a message per byte of its frame, if each byte is an operation."""

_LEAST = 600
"""Further memory of a message, in bytes."""

_NANOSECONDS = 1_000_000_000


@dataclass(frozen=True, slots=True)
class Exchange:
    """One message of a dialogue with everything known about it.

    message   the message itself
    request   for a reply: the command it answers, None if it was not seen
    values    for a reply: its values by name
    transfer  the file transfer of the message, or None
    note      a sentence about a peculiarity besides its contents, such as an unsure pairing, or None
    """

    message: Message
    request: Message | None = None
    values: list[Value] = field(default_factory=list)
    transfer: Transfer | None = None
    note: str | None = None

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

    def feed(self, message: Message, time: float | None = None) -> list[Value]:
        """Returns the values of a reply by name. Feed or follow each message once, in order, both directions.

        Args:
            message: The next message.
            time: Its time in seconds, if known. After a lost reply, times tell which of several commands with the same
                counter is answered.

        Returns:
            The values of a reply; an empty list for commands and for replies to commands that were not seen.
        """
        return self.follow(message, time).values

    def follow(self, message: Message, time: float | None = None) -> Exchange:
        """Returns everything known about a message: the command it answers, the values, the file transfer.

        Args:
            message: The next message.
            time: Its time in seconds, if known.

        Returns:
            The exchange.
        """
        if not isinstance(message, Message):
            raise TypeError(f"a dialogue takes messages, not {type(message).__name__}: use ev3proto.parse(frame)")
        if message.type is None:
            return Exchange(message)
        key, size = pairing_key(message.build())
        time_ns = None if time is None else round(time * _NANOSECONDS)
        if message.type.is_command:
            if message.wants_reply:
                self._pairing.remember(key, size, message, time_ns)
            transfer = self._transfers.requested(message) if isinstance(message, SystemCommand) else None
            return Exchange(message, transfer=transfer)
        answer = self._pairing.answered(key, size, time_ns)
        request, note = (None, None) if answer is None else (answer.command, answer.note)
        transfer = self._transfers.progress(message, request) if isinstance(message, SystemReply) else None
        return Exchange(message, request, values_of(message, request), transfer, note)


def _size_of(message: Message) -> int:
    return _LEAST + _BYTES_EACH * message.length
