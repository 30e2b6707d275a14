"""Memory limits for long inputs.

`Bounded` is a mapping that drops its oldest entries. `Budget` limits the bytes of all pending things together.
"""

from __future__ import annotations

import weakref
from collections import OrderedDict
from collections.abc import Callable
from typing import Protocol, TypeVar

K = TypeVar("K")
V = TypeVar("V")


DEFAULT_MEMORY = 64 << 20
"""Default limit for the bytes of all pending things in one capture."""


class Budget:
    """A limit on the total bytes of all pending things of one input. The oldest are evicted first."""

    def __init__(self, most: int = DEFAULT_MEMORY) -> None:
        self.most = most  # total bytes
        self.dropped = 0  # number of evicted things so far
        self.given = 0  # number of ids given out so far: callers of `hold` take the next one
        self._used = 0
        # By an increasing id: the size, the function that drops it, the owner's number for it, its identity.
        # A plain dictionary for speed: nearly every command of a capture is in it for a while.
        self._held: dict[int, tuple[int, Callable[[int], object], int, int | None]] = {}
        self._oldest = 0  # nothing with a lower id is pending
        self._numbers: dict[int, int] = {}  # by the identity of the pending thing

    def hold(self, given: int, size: int, drop: Callable[[int], object], number: int) -> None:
        """Adds a pending thing like `add`, but its owner keeps the id: `given` plus one."""
        self._held[given] = size, drop, number, None
        self._used += size
        if self._used > self.most:
            self._make_room()

    def release(self, given: int) -> None:
        """Removes a held thing; does nothing if it is not pending."""
        held = self._held.pop(given, None)
        if held is not None:
            self._used -= held[0]

    def add(self, thing: object, size: int, drop: Callable[[int], object], number: int) -> None:
        """Adds a pending thing of about this size in bytes, which the caller keeps alive.

        `drop` is called with `number` when it is evicted.
        """
        self.given += 1
        self._numbers[id(thing)] = self.given
        self._held[self.given] = size, drop, number, id(thing)
        self._used += size
        if self._used > self.most:
            self._make_room()

    def update(self, thing: object, size: int, drop: Callable[[int], object], number: int = 0) -> None:
        """Changes the size in bytes of a pending thing, which becomes the newest; 0: it is no longer pending."""
        self.remove(thing)
        if size:
            self.add(thing, size, drop, number)

    def remove(self, thing: object) -> None:
        """Removes a pending thing; does nothing if it is not pending."""
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
    """An owner of pending things, each with a number."""

    def forget(self, number: int) -> None:
        """Drops the thing with a number, if it still exists."""


def dropper(owner: Evictable) -> Callable[[int], None]:
    """Returns the `drop` function of an owner. It holds only a weak reference to the owner."""
    found = weakref.ref(owner)

    def drop(number: int) -> None:
        owner = found()
        if owner is not None:
            owner.forget(number)

    return drop


class Bounded(OrderedDict[K, V]):
    """A mapping with a maximum number of entries, in the order in which they were added or last used."""

    def __init__(self, most: int) -> None:
        super().__init__()
        self.most = most  # maximum number of entries

    def add(self, key: K, value: V) -> V | None:
        """Adds an entry as the newest one. Returns the value of the oldest entry if it was evicted, else None."""
        self[key] = value
        self.move_to_end(key)
        return self.pop_oldest() if len(self) > self.most else None

    def use(self, key: K, make: Callable[[], V]) -> tuple[V, V | None]:
        """Returns an entry, created if missing, which becomes the newest, and the oldest value if that was evicted."""
        if key in self:
            self.move_to_end(key)
            return self[key], None
        value = make()
        return value, self.add(key, value)

    def pop_oldest(self) -> V:
        """Removes the oldest entry, and returns its value. Raises KeyError if there is none."""
        return self.popitem(last=False)[1]
