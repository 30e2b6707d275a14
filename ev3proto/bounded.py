"""The one place where what is kept of a long input has a limit.

`Bounded` is a mapping that drops its oldest entries. `Budget` limits the bytes of all that waits, wherever it waits.
"""

from __future__ import annotations

import weakref
from collections import OrderedDict
from collections.abc import Callable
from typing import Protocol, TypeVar

K = TypeVar("K")
V = TypeVar("V")


DEFAULT_MEMORY = 64 << 20
"""Bytes that all that waits in one capture may take, unless somebody says otherwise."""


class Budget:
    """A limit on the bytes of all that waits in one input, in however many places. The oldest goes first.

    most     bytes in all
    dropped  how many things had to go, so far
    """

    def __init__(self, most: int = DEFAULT_MEMORY) -> None:
        self.most = most
        self.dropped = 0
        self._used = 0
        # By the identity of what waits: its size, what drops it, and the number that this knows it by.
        self._held: OrderedDict[int, tuple[int, Callable[[int], object], int]] = OrderedDict()

    def add(self, thing: object, size: int, drop: Callable[[int], object], number: int) -> None:
        """Something waits from now on.

        Args:
            thing: What waits; whoever calls this keeps it.
            size: About how many bytes it takes.
            drop: Is called with the number when it has to go.
            number: What `drop` knows it by.

        """
        self._held[id(thing)] = size, drop, number
        self._used += size
        while self._used > self.most and self._held:
            _, (size, drop, number) = self._held.popitem(last=False)
            self._used -= size
            self.dropped += 1
            drop(number)

    def update(self, thing: object, size: int, drop: Callable[[int], object], number: int = 0) -> None:
        """Something takes another size from now on, and counts as the newest of all that waits.

        Args:
            thing: What waits; whoever calls this keeps it.
            size: About how many bytes it takes; 0 where it waits no longer.
            drop: Is called with the number when it has to go.
            number: What `drop` knows it by.

        """
        self.remove(thing)
        if size:
            self.add(thing, size, drop, number)

    def remove(self, thing: object) -> None:
        """Something waits no longer. Nothing happens where it did not."""
        held = self._held.pop(id(thing), None)
        if held is not None:
            self._used -= held[0]


class Forgetful(Protocol):
    """What has things that wait, each with a number."""

    def forget(self, number: int) -> None:
        """Keeps the thing of a number no longer, if it still does."""


def dropper(owner: Forgetful) -> Callable[[int], None]:
    """What a budget calls. It does not keep the owner, whose things no longer count once nobody refers to it."""
    found = weakref.ref(owner)

    def drop(number: int) -> None:
        owner = found()
        if owner is not None:
            owner.forget(number)

    return drop


class Bounded(OrderedDict[K, V]):
    """A mapping of at most so many entries. Entries are in the order in which they were added or last used.

    most  how many entries it keeps
    """

    def __init__(self, most: int) -> None:
        super().__init__()
        self.most = most

    def add(self, key: K, value: V) -> V | None:
        """Adds an entry as the newest one.

        Returns:
            The value of the oldest entry, where that had to go for it; else None.

        """
        self[key] = value
        self.move_to_end(key)
        return self.pop_oldest() if len(self) > self.most else None

    def use(self, key: K, make: Callable[[], V]) -> tuple[V, V | None]:
        """An entry, which becomes the newest one; it is made where there is none.

        Returns:
            Its value, and the value of the oldest entry, where that had to go for it.

        """
        if key in self:
            self.move_to_end(key)
            return self[key], None
        value = make()
        return value, self.add(key, value)

    def pop_oldest(self) -> V:
        """Removes the oldest entry.

        Returns:
            Its value.

        Raises:
            KeyError: There is none.

        """
        return self.popitem(last=False)[1]
