"""One of the two memories of a command: which bytes are taken, where the next variable goes, how much is needed."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from ev3proto.errors import BuildError
from ev3proto.messages import Variable


class Need(NamedTuple):
    """What a variable without a place needs.

    name       who needs it, for messages: `VALUE of UI_READ.GET_VBATT`
    size       bytes
    alignment  what its index must be a multiple of
    """

    name: str
    size: int
    alignment: int


class Allocator:
    """The bytes of local or of global memory, given out from the lowest on.

    scope  "local" or "global"
    limit  bytes that there are
    size   bytes up to the last that is used
    """

    def __init__(self, scope: str, limit: int) -> None:
        self.scope = scope
        self.limit = limit
        self.size = 0
        self._next = 0
        self._taken: list[tuple[int, int, str]] = []

    def take(self, index: int, size: int, name: str, *, is_open: bool) -> None:
        """Bytes that were given to a variable by hand.

        Args:
            index: The first of them.
            size: How many they are.
            name: What sentences call the variable.
            is_open: Whether it may take more than these, as far as the next variable that was given a place by hand.
        """
        self._taken.append((index, index + size, name if is_open else ""))
        self.size = max(self.size, index + size)

    def give(self, need: Need) -> Variable:
        """The next place that is free and aligned. BuildError where there is none."""
        index = aligned(self._next, need.alignment)
        for start, end, who in sorted(self._taken):
            if who:
                end = self._end(start, who, index, need)
            if start < index + need.size and index < end:
                index = aligned(end, need.alignment)
        self._next = index + need.size
        if self._next > self.limit:
            raise BuildError(
                f"there is no room for the {need.size} bytes of {need.name}: {self.scope} memory has {self.limit}, of"
                f" which {index} are taken"
            )
        self.size = max(self.size, self._next)
        return Variable(self.scope, index)

    def _end(self, start: int, who: str, index: int, need: Need) -> int:
        """Where a variable ends that may take more bytes than it says. BuildError where that is in the way."""
        following = [other for other, _, _ in self._taken if other > start]
        if following:
            return min(following)
        if index + need.size > start:
            raise BuildError(
                f"it is not known how many bytes {who} takes from {Variable(self.scope, start)} on, so there is no safe"
                f" place for {need.name}: give it one by hand, too"
            )
        return start


def joined(needs: Iterable[Need]) -> Need:
    """What one variable needs that is used in several places: the most of each."""
    found = list(needs)
    widest = max(found, key=lambda need: need.size)
    return Need(widest.name, widest.size, max(need.alignment for need in found))


def aligned(index: int, alignment: int) -> int:
    """The next multiple of the alignment, from the index on."""
    return -(-index // alignment) * alignment
