"""Labels: places in a command that its operations jump to.

    again = ev3proto.Label("again")
    ev3proto.command(again, ops.add8(i, 1, i), ops.jr_lt8(i, 10, again))

How far a jump is, and so how many bytes it takes, `command` works out.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate

from ev3proto.errors import BuildError
from ev3proto.schema.argument import encode_as, encode_integer

NO_DISTANCE = encode_integer(0)
"""What stands in a draft for the distance to a label: the shortest that there is."""

_BY_SIZE = {2: "LC1", 3: "LC2", 5: "LC4"}


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


def with_jumps(encoded: Sequence[bytes], jumps: Mapping[int, Label], places: Mapping[Label, int]) -> list[bytes]:
    """Puts the distances to labels into operations.

    A jump counts from the end of its operation, so how long it is depends on itself. It starts as short as can be and
    only ever becomes longer, which comes to an end.

    Args:
        encoded: The bytes of each operation, with NO_DISTANCE at the end of those that jump to a label.
        jumps: The label by the number of the operation.
        places: The number of the operation that a label stands in front of; for the end of the command, their number.

    Returns:
        The bytes of each operation.

    Raises:
        BuildError: A label has no place, or is further away than a frame is long.
    """
    for label in jumps.values():
        if label not in places:
            raise BuildError(f"{label!r} has no place: give it to command() in front of the operation to jump to")
    pieces = list(encoded)
    heads = {number: encoded[number].removesuffix(NO_DISTANCE) for number in jumps}
    is_settled = not jumps
    while not is_settled:
        ends = list(accumulate(map(len, pieces), initial=0))
        is_settled = True
        for number, head in heads.items():
            distance = ends[places[jumps[number]]] - ends[number + 1]
            least = len(pieces[number]) - len(head)
            shortest = encode_integer(distance)
            argument = shortest if len(shortest) >= least else encode_as(_BY_SIZE[least], distance)
            is_settled &= len(argument) == least
            pieces[number] = head + argument
    return pieces
