"""Which reply answers which command: by message counter, and where that does not tell, by the size of the answer."""

from __future__ import annotations

import sys
from collections.abc import Callable, Hashable
from typing import Generic, TypeVar

from ev3proto.bounded import Budget, dropper

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
        self._budget = budget
        self._size_of = size_of
        self._drop = dropper(self)
        self._by_key: dict[Hashable, list[int]] = {}
        self._waiting: dict[int, tuple[Hashable, int, T]] = {}  # key, size, command
        self._seen = 0
        self._oldest = 0  # no command with a lower number waits

    @property
    def unanswered(self) -> list[T]:
        """The commands that wait for their reply, oldest first."""
        return [command for _, _, command in self._waiting.values()]

    def remember(self, key: Hashable, size: int, command: T) -> T | None:
        """Waits for the command's reply. Returns the command that is forgotten for it, if any is."""
        number = self._seen
        self._seen = number + 1
        same = self._by_key.get(key)
        if same is None:
            same = self._by_key[key] = [number]
        else:
            same.append(number)
        self._waiting[number] = key, size, command
        if self._budget is not None:
            self._budget.add(command, self._size_of(command), self._drop, number)
        if len(same) > MOST_PER_KEY:
            return self._forget(same[0])
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
        same = self._by_key.get(key)
        if same is None:
            return None
        if size is not None and len(same) > 1:
            for number in reversed(same):
                if self._waiting[number][1] == size:
                    return self._forget(number)
        return self._forget(same[-1])

    def __del__(self) -> None:
        if self._budget is not None:
            for command in self.unanswered:
                self._budget.remove(command)

    def forget(self, number: int) -> None:
        """Waits no longer for the reply to the command of a number, if it still does."""
        if number in self._waiting:
            self._forget(number)

    def _forget(self, number: int) -> T:
        key, _, command = self._waiting.pop(number)
        if self._budget is not None:
            self._budget.remove(command)
        same = self._by_key[key]
        same.remove(number)
        if not same:
            del self._by_key[key]
        return command
