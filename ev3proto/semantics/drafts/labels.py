"""Labels: places in a command that its operations jump to.

    again = ev3proto.Label("again")
    ev3proto.command(again, ops.add8(i, 1, i), ops.jr_lt8(i, 10, again))

How far a jump is, and so how many bytes it takes, `command` works out.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate

from ev3proto.errors import BuildError
from ev3proto.schema.argument import encode_as, encode_integer

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
