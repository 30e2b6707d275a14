"""How long jumps are where labels are as short as they can be: the rule of EV3-G."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ev3proto.program.source.encoding import JUMP_SIZES, shortest_jump

_MOST_PASSES = 1000
_SIZES = sorted(set(JUMP_SIZES.values()))


def starts(sizes: Sequence[int]) -> list[int]:
    """Where each part starts, and where the last one ends."""
    found = [0]
    at = 0
    for size in sizes:
        at += size
        found.append(at)
    return found


def shrink(sizes: list[int], goals: Mapping[int, int]) -> None:
    """Makes every jump as short as it can be. They only shrink, so this comes to an end.

    Args:
        sizes: Bytes of every part of the code; those of jumps are changed.
        goals: By the number of the part that is a jump: the number of the part that it leads to.
    """
    for _ in range(_MOST_PASSES):
        at = starts(sizes)
        is_changed = False
        for place, goal in goals.items():
            for size in _SIZES:
                if size >= sizes[place]:
                    break
                target = at[goal] - (sizes[place] - size if goal > place else 0)
                if shortest_jump(target - at[place] - size) <= size:
                    sizes[place] = size
                    is_changed = True
                    break
        if not is_changed:
            return
