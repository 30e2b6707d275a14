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
