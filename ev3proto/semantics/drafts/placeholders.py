"""Variables whose place in memory is chosen by `command`.

    speed = ev3proto.Local()
    ev3proto.command(ops.output_read(0, 0, speed=speed), ops.output_power(0, 2, speed), ops.output_start(0, 2))

The same object is the same variable in every operation of a command. Its size and alignment follow from the
operations that use it; if the size does not (texts without a length), it must be given.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate
from typing import NamedTuple

from ev3proto.errors import BuildError
from ev3proto.messages import Variable
from ev3proto.schema.argument import encode_as, encode_integer
from ev3proto.tables.encoding import GLOBAL, LOCAL


class Placeholder:
    """A variable without an index, created by `Local` and `Global`.

    scope    "local" or "global"
    size     its size in bytes, None if the operations tell
    handle   this use is marked as a handle to a memory object
    address  this use is marked as an absolute address
    origin   the variable of this marked use; itself if unmarked
    """

    __slots__ = ("address", "handle", "origin", "scope", "size")

    def __init__(
        self,
        scope: str,
        size: int | None = None,
        *,
        handle: bool = False,
        address: bool = False,
        origin: Placeholder | None = None,
    ) -> None:
        if size is not None and (isinstance(size, bool) or not isinstance(size, int) or size < 1):
            raise BuildError(f"the size of a variable must be a number of bytes, 1 or more, not {size!r}")
        self.scope = scope
        self.size = size
        self.handle = handle
        self.address = address
        self.origin = self if origin is None else origin

    def as_handle(self) -> Placeholder:
        """Returns the variable marked as a handle to a memory object, like `HND(...)`."""
        return Placeholder(self.scope, self.size, handle=True, origin=self.origin)

    def as_address(self) -> Placeholder:
        """Returns the variable marked as an absolute address, like `ADR(...)`."""
        return Placeholder(self.scope, self.size, address=True, origin=self.origin)

    def __repr__(self) -> str:
        size = "" if self.size is None else str(self.size)
        mark = ".as_handle()" if self.handle else ".as_address()" if self.address else ""
        return f"{'Global' if self.scope == GLOBAL else 'Local'}({size}){mark}"


def Local(size: int | None = None) -> Placeholder:  # noqa: N802 - named like LV
    """Returns a new local variable, to pass a value from one operation to another.

    Args:
        size: Bytes, 1 or more; needed only for texts without a length.

    Raises:
        BuildError: The size is not a number of 1 or more.
    """
    return Placeholder(LOCAL, size)


def Global(size: int | None = None) -> Placeholder:  # noqa: N802 - named like GV
    """Returns a new global variable, which the reply carries.

    Args:
        size: Bytes, 1 or more; needed only for texts without a length.

    Raises:
        BuildError: The size is not a number of 1 or more.
    """
    return Placeholder(GLOBAL, size)


NO_DISTANCE = encode_integer(0)
"""The stand-in for the distance to a label in a draft: the shortest."""

FORM_OF_SIZE = {1: "LC0", 2: "LC1", 3: "LC2", 5: "LC4"}
"""The encoding of a distance by its size."""

_MOST_PASSES = 1000


@dataclass(frozen=True, slots=True)
class Label:
    """A place in a command: before the next argument of `command`, or at the command's end.

    Labels of the same name are the same.

    Attributes:
        name: Its name in messages.
    """

    name: str

    def __post_init__(self) -> None:
        if not isinstance(self.name, str) or not self.name:
            raise BuildError(f"the name of a label must be a text, such as Label('again'), not {self.name!r}")

    def __repr__(self) -> str:
        return f"Label({self.name!r})"


def settle(
    sizes: list[int], goals: Mapping[int, int], width: Callable[[int], int], *, is_shrinking: bool = False
) -> None:
    """Gives every jump in `sizes` the number of bytes that its distance to its goal needs.

    A distance counts from the end of the jump, so it depends on all jumps between, and on itself. Jumps only grow or
    only shrink, as in EV3-G, so this ends.
    """
    for _ in range(_MOST_PASSES):
        starts = list(accumulate(sizes, initial=0))
        is_settled = True
        for place, goal in goals.items():
            if is_shrinking:
                # The distance if the jump were that short: a shorter jump forwards brings its target nearer.
                size = next(
                    size
                    for size in (*(size for size in FORM_OF_SIZE if size < sizes[place]), sizes[place])
                    if size == sizes[place]
                    or width(starts[goal] - (sizes[place] - size if goal > place else 0) - starts[place] - size) <= size
                )
            else:
                size = max(sizes[place], width(starts[goal] - starts[place + 1]))
            is_settled &= size == sizes[place]
            sizes[place] = size
        if is_settled:
            return


def with_jumps(encoded: Sequence[bytes], jumps: Mapping[int, Label], places: Mapping[Label, int]) -> list[bytes]:
    """Returns operations with the distances to their labels filled in for NO_DISTANCE. Raises BuildError.

    A label is by the number of the operation that it precedes; at the end of the command, by their number.
    """
    for label in jumps.values():
        if label not in places:
            raise BuildError(f"{label!r} has no place: pass it to command() before the operation to jump to")
    # Two parts per operation: the bytes before the distance, and the distance.
    sizes = [
        size
        for number, code in enumerate(encoded)
        for size in ((len(code) - 1, 1) if number in jumps else (len(code), 0))
    ]
    settle(sizes, {2 * n + 1: 2 * places[label] for n, label in jumps.items()}, lambda far: len(encode_integer(far)))
    starts = list(accumulate(sizes, initial=0))
    return [
        code.removesuffix(NO_DISTANCE)
        + encode_as(FORM_OF_SIZE[sizes[2 * number + 1]], starts[2 * places[jumps[number]]] - starts[2 * number + 2])
        if number in jumps
        else code
        for number, code in enumerate(encoded)
    ]


class Need(NamedTuple):
    """The requirements of a variable without a place."""

    name: str  # its user, for messages: `VALUE of UI_READ.GET_VBATT`
    size: int  # in bytes
    alignment: int  # its index must be a multiple of this


class Allocator:
    """An allocator of local or global memory, from the lowest byte on."""

    def __init__(self, scope: str, limit: int) -> None:
        self.scope = scope  # "local" or "global"
        self.limit = limit  # total bytes
        self.size = 0  # bytes up to the last used one
        self._next = 0
        self._taken: list[tuple[int, int, str]] = []

    def take(self, index: int, size: int, name: str, *, is_open: bool) -> None:
        """Reserves bytes for a variable with an explicit place; an open one may take more, up to the next."""
        self._taken.append((index, index + size, name if is_open else ""))
        self.size = max(self.size, index + size)

    def give(self, need: Need) -> Variable:
        """Returns the next free and aligned place. Raises BuildError if there is none."""
        index = aligned(self._next, need.alignment)
        for start, end, who in sorted(self._taken):
            if who:
                end = self._end(start, who, index, need)
            if start < index + need.size and index < end:
                index = aligned(end, need.alignment)
        self._next = index + need.size
        if self._next > self.limit:
            raise BuildError(
                f"no room for the {need.size} bytes of {need.name}: {self.scope} memory has {self.limit}, of"
                f" which {index} are taken"
            )
        self.size = max(self.size, self._next)
        return Variable(self.scope, index)

    def _end(self, start: int, who: str, index: int, need: Need) -> int:
        """Returns the end of a variable that may take more bytes."""
        following = [other for other, _, _ in self._taken if other > start]
        if following:
            return min(following)
        if index + need.size > start:
            raise BuildError(
                f"the size of {who} from {Variable(self.scope, start)} on is unknown, so there is no safe"
                f" place for {need.name}: give it an explicit place, too"
            )
        return start


def joined(needs: Iterable[Need]) -> Need:
    """Returns the requirements of a variable with several uses: the maximum of each."""
    found = list(needs)
    widest = max(found, key=lambda need: need.size)
    return Need(widest.name, widest.size, max(need.alignment for need in found))


def aligned(index: int, alignment: int) -> int:
    """Returns the first multiple of the alignment from the index on."""
    return -(-index // alignment) * alignment
