"""The one place where what is kept of a long input has a limit: a mapping that drops its oldest entries."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable
from typing import TypeVar

K = TypeVar("K")
V = TypeVar("V")


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
