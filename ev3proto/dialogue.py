"""Dialogues: which reply answers which command, and what the reply therefore says.

A reply to a direct command is nothing but memory. Every output parameter of the command that names a global variable
says what stands in it and where, so a `Dialogue` remembers the commands it saw. Replies to system commands have fields
of their own; there it remembers which file each handle stands for.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from ev3proto.bounded import DEFAULT_MEMORY, Budget
from ev3proto.messages import DirectCommand, DirectReply, Message, SystemCommand, SystemReply
from ev3proto.semantics.pairing import Pairing
from ev3proto.semantics.replies import Value, ValueType, reply_values, values_of
from ev3proto.semantics.transfers import Transfer, Transfers

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
