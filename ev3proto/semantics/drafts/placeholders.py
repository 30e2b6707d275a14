"""Variables whose place in memory is not chosen by the one who writes them down, but by `command`.

    speed = ev3proto.Local()
    ev3proto.command(ops.output_read(0, 0, speed=speed), ops.output_power(0, 2, speed), ops.output_start(0, 2))

The same object is the same variable in every operation of a command. Its size and alignment follow from what the
operations do with it; where the size does not follow from them (texts without a length), it must be given.
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
    """A variable without an index yet; made by `Local` and `Global`.

    scope    "local" or "global"
    size     bytes it takes, None where the operations tell
    handle   this use of it is marked: it holds a handle to a memory object
    address  this use of it is marked: it holds an absolute address
    origin   the variable that this is a marked use of; itself where it has no mark
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
        """The same variable where an operation is to take it as a handle to a memory object, as `HND(...)` does."""
        return Placeholder(self.scope, self.size, handle=True, origin=self.origin)

    def as_address(self) -> Placeholder:
        """The same variable where an operation is to take it as an absolute address, as `ADR(...)` does."""
        return Placeholder(self.scope, self.size, address=True, origin=self.origin)

    def __repr__(self) -> str:
        size = "" if self.size is None else str(self.size)
        mark = ".as_handle()" if self.handle else ".as_address()" if self.address else ""
        return f"{'Global' if self.scope == GLOBAL else 'Local'}({size}){mark}"


def Local(size: int | None = None) -> Placeholder:  # noqa: N802 - stands beside LV
    """A new local variable, for what one operation hands to another.

    Args:
        size: Bytes, 1 or more; omitted where the operations tell, as all do but those with texts without a length.

    Raises:
        BuildError: It is another size.
    """
    return Placeholder(LOCAL, size)


def Global(size: int | None = None) -> Placeholder:  # noqa: N802 - stands beside GV
    """A new global variable: the reply carries it.

    Args:
        size: Bytes, 1 or more; omitted where the operations tell, as all do but those with texts without a length.

    Raises:
        BuildError: It is another size.
    """
    return Placeholder(GLOBAL, size)


NO_DISTANCE = encode_integer(0)
"""What a draft has for the distance to a label: the shortest that there is."""

FORM_OF_SIZE = {1: "LC0", 2: "LC1", 3: "LC2", 5: "LC4"}
"""The encoding of a distance by its bytes."""

_MOST_PASSES = 1000


@dataclass(frozen=True, slots=True)
class Label:
    """A place in a command: what stands after it in the call of `command`, or the command's end.

    Labels of the same name are the same.

    Attributes:
        name: For messages.
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
    """Gives every jump as many bytes as the distance to its goal needs.

    A distance counts from the end of the jump, so it depends on all jumps between, and on itself. Jumps only grow, or
    only shrink, which comes to an end.

    Args:
        sizes: Bytes of every part of the code; those of jumps are changed.
        goals: By the number of the part that is a jump: the number of the part that it leads to.
        width: Bytes of a distance in its shortest encoding.
        is_shrinking: Jumps start long and become shorter, as EV3-G makes them.
    """
    for _ in range(_MOST_PASSES):
        starts = list(accumulate(sizes, initial=0))
        is_settled = True
        for place, goal in goals.items():
            if is_shrinking:
                # What it would be if it were as short: one that leads forwards brings its goal nearer.
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
    """Puts the distances to labels into operations.

    Args:
        encoded: The bytes of each operation, with NO_DISTANCE at the end of those that jump to a label.
        jumps: The label by the number of the operation.
        places: The number of the operation that a label precedes; for the end of the command, their number.

    Returns:
        The bytes of each operation.

    Raises:
        BuildError: A label has no place, or is further away than a frame is long.
    """
    for label in jumps.values():
        if label not in places:
            raise BuildError(f"{label!r} has no place: give it to command() in front of the operation to jump to")
    # Two parts an operation: what precedes the distance, and the distance.
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
