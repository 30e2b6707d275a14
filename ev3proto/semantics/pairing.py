"""The pairing of replies with commands.

A reply has the counter of its command, but some programs never change theirs, and send commands before the last one is
answered. A brick answers in order, so a reply answers the oldest command with its counter that it fits. Replies get
lost, too: a command that waits for much longer than this brick takes is given up.

A text may have the lines of several bricks. Labels beside the directions may tell them apart: a reply answers a command
with its own label, unless more replies were found to answer commands with another one, as where a label names a thread.
"""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable, Collection, Hashable
from typing import Generic, NamedTuple, TypeVar

from ev3proto.bounded import Budget, dropper
from ev3proto.errors import counted
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, read_memory, unpack_header
from ev3proto.tables.frame import COUNTERS, LENGTH_FIELD, MessageType

T = TypeVar("T")

MOST_PENDING = 65536
"""Maximum number of remembered commands without a reply: one per counter."""

MOST_PER_KEY = 256
"""Maximum number of remembered commands with the same counter, for senders that never change it."""

MOST_LABELS = 64
"""Maximum number of labels that tell connections apart."""

PATIENCE = 3
"""A command is given up when it has waited this many times as long as the longest answer that was certain."""

LEAST_PATIENCE_NS = 50_000_000
"""Nanoseconds for which a command waits at least."""

FIRST_PATIENCE_NS = 10_000_000_000
"""Nanoseconds for which a command waits while no answer was certain."""

UNSURE = "the pairing is unsure: several commands with its counter waited"
"""The note of a reply that several commands may have."""

OTHER_SIZE = "the command requests {asked} of memory, but this reply has {size}"
"""The note of a reply that does not have the memory which its command requests."""

_CARRIES = tuple(dict.fromkeys(member.carries for member in MessageType))
_NUMBERS = len(_CARRIES) * COUNTERS

# By the number of a type: its part of the key, whether it is a system message, whether it is a direct command, and
# whether its size is that of the memory which its command requested.
_TYPES = {
    int(member): (
        _CARRIES.index(member.carries) * COUNTERS,
        member.carries == MessageType.SYSTEM_REPLY.carries,
        member.carries == MessageType.DIRECT_REPLY.carries and member.is_command,
        member is MessageType.DIRECT_REPLY,
    )
    for member in MessageType
}


def pairing_key(frame: bytes) -> tuple[int, int | None]:
    """Returns what a frame of a known type and its reply or command have in common.

    Returns:
        A key, made of the kind of message, the counter and the system command; and the size in bytes of the memory that
        a direct command requests or a direct reply has, None if any fits.
    """
    length, counter, code = unpack_header(frame)
    kind, is_system, requests_memory, has_memory = _TYPES[code]
    key = kind + counter
    if is_system and len(frame) > HEADER_SIZE:
        # A plain number, as one is made for each frame.
        key += (1 + frame[HEADER_SIZE]) * _NUMBERS
    if has_memory:
        # A frame that was cut has its length, too.
        return key, max(len(frame), LENGTH_FIELD + length) - HEADER_SIZE
    if requests_memory and len(frame) >= COMMAND_HEADER_SIZE:
        return key, read_memory(frame)[0]
    return key, None


_SLIPS: dict[str, Callable[[int], int]] = {
    "one higher than the commands'": lambda counter: (counter + 1) % COUNTERS,
    "one lower than the commands'": lambda counter: (counter - 1) % COUNTERS,
    "0, whatever the commands' are": lambda _: 0,
    "the commands' with their two bytes swapped": lambda counter: counter >> 8 | (counter & 0xFF) << 8,
}
"""What a brick or a program between may do to counters, each with the counter of the reply to a command."""


def counters_slip(commands: Collection[bytes], replies: Collection[bytes]) -> str | None:
    """Returns what is wrong with the counters of replies that answer no command; None if nothing explains all of them.

    Args:
        commands: The frames of commands that wait for a reply.
        replies: The frames of replies to none of them.
    """
    given = _wanted(replies, lambda counter: counter)
    for name, slip in _SLIPS.items():
        if given and given <= _wanted(commands, slip):
            return f"the replies' counters are {name}"
    return None


def _wanted(frames: Collection[bytes], slip: Callable[[int], int]) -> Counter[tuple[int, int | None]]:
    """Returns how many frames have each key after a slip of the counter, by itself and with each size."""
    found: Counter[tuple[int, int | None]] = Counter()
    for frame in frames:
        key, size = pairing_key(frame)
        counter = unpack_header(frame)[1]
        key += slip(counter) - counter
        found.update({(key, None), (key, size)})
    return found


class Answer(NamedTuple, Generic[T]):
    """What a reply answers."""

    command: T
    is_sure: bool  # no other command may be the one that it answers
    asked: int | None = None  # the bytes of memory that the command requests, if it is a direct one
    size: int | None = None  # those in the reply, if it is a direct one and no error

    @property
    def note(self) -> str | None:
        """The note of the reply, if it has another size than requested or the pairing is unsure."""
        if self.asked is not None and self.size is not None and self.asked != self.size:
            return OTHER_SIZE.format(asked=counted(self.asked, "byte"), size=self.size)
        return None if self.is_sure else UNSURE


class _Waiting(NamedTuple, Generic[T]):
    key: Hashable
    size: int | None
    time_ns: int | None
    command: T
    given: int  # the budget's id
    label: str


class Pairing(Generic[T]):
    """Commands of one conversation, in any form, that are remembered until their replies come.

    A budget limits the memory of all pairings that share it; `size_of` returns the bytes of a command. `give_up` is
    called with each command that is forgotten because it was not answered when it should have been.

    In a text, several bricks may answer (`is_ordered` is false). Then no reply answers a command that it does not fit,
    and where several commands fit, the pairing of each of them is unsure, also that of the last one that remains.
    """

    def __init__(
        self,
        most: int = MOST_PENDING,
        budget: Budget | None = None,
        size_of: Callable[[T], int] = sys.getsizeof,
        give_up: Callable[[T], object] | None = None,
        *,
        is_ordered: bool = True,
    ) -> None:
        self._most = most
        self._is_ordered = is_ordered
        self._unsure: set[int] = set()  # the commands that a reply fitted which was taken for that of another
        self._labels: set[str] = set()  # those of commands
        self._alike = self._apart = 0  # replies whose command has their label, and those whose command has another one
        self._budget = Budget(sys.maxsize) if budget is None else budget
        self._size_of = size_of
        self._give_up = give_up
        self._drop = dropper(self)
        self._waiting: dict[int, _Waiting[T]] = {}  # by the number of the command
        self._numbers: dict[Hashable, list[int]] = {}  # of the commands that wait, by key, oldest first
        self._seen = 0
        self._oldest = 0  # no command with a lower number is pending
        self._longest_ns = -1  # the longest answer that was certain, -1 without one

    @property
    def unanswered(self) -> list[T]:
        """The commands still waiting for their reply, oldest first."""
        return [waiting.command for waiting in self._waiting.values()]

    @property
    def has_labels(self) -> bool:
        """Whether labels tell connections apart, as far as replies have shown."""
        return self._alike >= self._apart

    def remember(
        self, key: Hashable, size: int | None, command: T, time_ns: int | None = None, label: str = ""
    ) -> None:
        """Adds a command that waits for its reply; one too many is given up.

        Args:
            key: What it shares with its reply, and
            size: the size of that reply's memory in bytes, as from `pairing_key`.
            command: The command.
            time_ns: When it was sent, in nanoseconds; None if unknown.
            label: What a text says of its connection; empty if nothing.
        """
        budget = self._budget
        given = budget.given = budget.given + 1
        number = self._seen
        self._seen = number + 1
        self._waiting[number] = _Waiting(key, size, time_ns, command, given, label)
        if label and len(self._labels) < MOST_LABELS:
            self._labels.add(label)
        budget.hold(given, self._size_of(command), self._drop, number)
        numbers = self._numbers.setdefault(key, [])
        numbers.append(number)
        if len(numbers) > MOST_PER_KEY:
            self._lose(numbers[0])
        elif len(self._waiting) > self._most:
            while self._oldest not in self._waiting:
                self._oldest += 1
            self._lose(self._oldest)

    def answered(
        self, key: Hashable, size: int | None, time_ns: int | None = None, label: str = ""
    ) -> Answer[T] | None:
        """Returns the command that a reply answers, None if it was not seen. Earlier ones with its key are given up.

        It is the oldest that the reply fits and that was not sent too long ago. If all were, the brick was slow: it is
        the oldest of them. If it fits none, it is the newest of an ordered conversation.
        """
        numbers = self._numbers.get(key, [])
        waiting = self._waiting
        fitting = [number for number in numbers if size is None or waiting[number].size in (size, None)]
        if not self._is_ordered:
            numbers = fitting = self._labelled(fitting, label)
        if not numbers:
            return None
        number = fitting[0] if fitting else numbers[-1]
        is_sure = len(fitting or numbers) == 1
        if is_sure:
            self._longest_ns = max(self._longest_ns, self._age_ns(number, time_ns))
        else:
            number = self._in_time(fitting, time_ns, number)
        for earlier in numbers[: numbers.index(number)]:
            self._lose(earlier)
        if not self._is_ordered:
            is_sure &= number not in self._unsure
            self._unsure.update(fitting)
        asked = waiting[number].size
        return Answer(self._forget(number), is_sure, asked, size)

    def _in_time(self, fitting: list[int], time_ns: int | None, late: int) -> int:
        """Returns the oldest of some commands that was not sent too long ago, `late` if all were."""
        longest_ns = self._longest_ns
        patience_ns = FIRST_PATIENCE_NS if longest_ns < 0 else max(PATIENCE * longest_ns, LEAST_PATIENCE_NS)
        return next((number for number in fitting if self._age_ns(number, time_ns) <= patience_ns), late)

    def _labelled(self, fitting: list[int], label: str) -> list[int]:
        """Returns those of the commands that a reply with a label may answer."""
        own = [number for number in fitting if self._waiting[number].label == label]
        if not label or not fitting:
            return fitting
        if own:
            self._alike += 1
        elif label in self._labels and self._alike > self._apart:
            return []
        else:
            self._apart += 1
        return own if own and self.has_labels else fitting

    def __del__(self) -> None:
        for waiting in self._waiting.values():
            self._budget.release(waiting.given)

    def forget(self, number: int) -> None:
        """Forgets the command with a number, if it is still pending."""
        if number in self._waiting:
            self._forget(number)

    def _age_ns(self, number: int, now_ns: int | None) -> int:
        """Returns for how many nanoseconds a command has waited; -1 if times are unknown."""
        time_ns = self._waiting[number].time_ns
        return -1 if now_ns is None or time_ns is None else now_ns - time_ns

    def _lose(self, number: int) -> None:
        command = self._forget(number)
        if self._give_up is not None:
            self._give_up(command)

    def _forget(self, number: int) -> T:
        waiting = self._waiting.pop(number)
        self._unsure.discard(number)
        self._budget.release(waiting.given)
        numbers = self._numbers[waiting.key]
        numbers.remove(number)
        if not numbers:
            del self._numbers[waiting.key]
        return waiting.command
