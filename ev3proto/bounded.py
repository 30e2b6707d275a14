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
    given    how many numbers were given, so far: whoever calls `hold` takes the next one
    """

    def __init__(self, most: int = DEFAULT_MEMORY) -> None:
        self.most = most
        self.dropped = 0
        self.given = 0
        self._used = 0
        # By a number that grows: the size of what waits, what drops it, the number that this knows it by, its identity.
        # A plain dictionary, as nearly every command of a capture is in it for a while: `pytest benchmarks -k capture`.
        self._held: dict[int, tuple[int, Callable[[int], object], int, int | None]] = {}
        self._oldest = 0  # nothing with a lower number waits
        self._numbers: dict[int, int] = {}  # by the identity of what waits

    def hold(self, given: int, size: int, drop: Callable[[int], object], number: int) -> None:
        """Something waits from now on, like `add`, but its owner keeps the number that is given to it.

        Args:
            given: The number: `given` and one, which `given` is from now on.
            size: About how many bytes it takes.
            drop: Is called with the other number when it has to go.
            number: What `drop` knows it by.

        """
        self._held[given] = size, drop, number, None
        self._used += size
        if self._used > self.most:
            self._make_room()

    def release(self, given: int) -> None:
        """Something that was held waits no longer. Nothing happens where it did not."""
        held = self._held.pop(given, None)
        if held is not None:
            self._used -= held[0]

    def add(self, thing: object, size: int, drop: Callable[[int], object], number: int) -> None:
        """Something waits from now on.

        Args:
            thing: What waits; whoever calls this keeps it.
            size: About how many bytes it takes.
            drop: Is called with the number when it has to go.
            number: What `drop` knows it by.

        """
        self.given += 1
        self._numbers[id(thing)] = self.given
        self._held[self.given] = size, drop, number, id(thing)
        self._used += size
        if self._used > self.most:
            self._make_room()

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
        number = self._numbers.pop(id(thing), None)
        if number is not None:
            self.release(number)

    def _make_room(self) -> None:
        held = self._held
        while self._used > self.most and held:
            while self._oldest not in held:
                self._oldest += 1
            size, drop, number, identity = held.pop(self._oldest)
            if identity is not None:
                del self._numbers[identity]
            self._used -= size
            self.dropped += 1
            drop(number)


class Evictable(Protocol):
    """What has things that wait, each with a number."""

    def forget(self, number: int) -> None:
        """Keeps the thing of a number no longer, if it still does."""


def dropper(owner: Evictable) -> Callable[[int], None]:
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
