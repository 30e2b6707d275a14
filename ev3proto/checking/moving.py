"""Where misaligned variables can move: what has to stay together, and the nearest room for it.

A frame may have hundreds of variables that all have to move. So the bytes of a memory are the bits of one number, by
which all places for a block are found at once, and no block is compared with each other one.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from itertools import accumulate, pairwise
from typing import NamedTuple

from ev3proto.semantics.footprint import Footprint
from ev3proto.tables.encoding import INDEX_RANGES

WIDEST = 4
"""The largest alignment; all others divide it."""


def multiple(place: Footprint) -> int:
    """What the index of a variable must be a multiple of: 1, 2 or 4."""
    return max(place.validator_alignment, place.cpu_alignment)


def is_misaligned(place: Footprint) -> bool:
    """Whether its index is none of these."""
    return place.start % place.validator_alignment != 0 or place.start % place.cpu_alignment != 0


# For each index within the widest alignment and what it must be a multiple of, the ways that make it one, as bits.
_FITTING = {
    (start, many): sum(1 << way for way in range(WIDEST) if (start + way) % many == 0)
    for start in range(WIDEST)
    for many in range(1, WIDEST + 1)
}


@dataclass(slots=True, eq=False)
class Block:
    """Variables that have to stay together: the bytes from `start` to `end`, and all that is used of them."""

    start: int
    end: int
    places: tuple[Footprint, ...]

    @property
    def is_open(self) -> bool:
        """Whether nobody can tell where it ends."""
        return any(not place.is_exact for place in self.places)

    @property
    def is_shared(self) -> bool:
        """Whether other variables may lie within it on purpose: it is an array, or something is read from it."""
        return any(place.is_array or place.is_read for place in self.places)

    @property
    def is_aligned(self) -> bool:
        """Whether it may stay where it is."""
        return not any(map(is_misaligned, self.places))

    def belongs_to(self, other: Block) -> bool:
        """Whether one lies within the other on purpose. Results that share bytes do so by mistake, and may part."""
        is_within = self.start >= other.start and self.end <= other.end
        is_around = other.start >= self.start and other.end <= self.end
        return (is_within or is_around) and (self.start == other.start or self.is_shared or other.is_shared)

    def ways(self) -> int:
        """By how many bytes, fewer than the widest has, it may move for all of it to be aligned: a bit for each."""
        fitting = (1 << WIDEST) - 1
        for place in self.places:
            fitting &= _FITTING[place.start % WIDEST, multiple(place)]
        return fitting


class Layout:
    """The variables of one memory, and how to move those that are misaligned.

    left  blocks that cannot be moved, and why not
    """

    def __init__(
        self, found: list[Footprint], misaligned: list[Footprint], stated: int, most: int, rigid: bytearray
    ) -> None:
        """Looks at all variables of a memory.

        Args:
            found: The variables.
            misaligned: Those of them that are misaligned.
            stated: Bytes of memory that the command asks for.
            most: Bytes of memory that a command can have.
            rigid: Whether an argument must keep its length.
        """
        self.left: list[tuple[tuple[Footprint, ...], str]] = []
        self._most = most
        self._rigid = rigid
        self._has_rigid = any(rigid)
        self._blocks: list[Block] = []
        for place in misaligned:
            if place.end > most:
                self.left.append(((place,), f"it reaches beyond the {most} bytes that there are"))
        if len(misaligned) > len(self.left):
            within = [place for place in found if place.start + place.size <= most]
            self._blocks = _blocks(within, min(stated, most))

    def moves(self) -> Iterator[tuple[tuple[Footprint, ...], int]]:
        """Blocks of variables that have to move, and by how many bytes; all others stay where they are."""
        misaligned = [block for block in self._blocks if not block.is_aligned]
        waiting = [
            _Waiting(block, ways, self._last_start(block))
            for block in misaligned
            if (ways := block.ways()) and not block.is_open
        ]
        moved: set[Block] = set()
        room = _Room(self._blocks, self._most)
        before = -1
        while waiting and len(waiting) != before:
            before = len(waiting)
            stuck: list[_Waiting] = []
            for one in waiting:
                shift = room.shift(one)
                if shift is None:
                    stuck.append(one)
                else:
                    moved.add(one.block)
                    yield one.block.places, shift
            # A block that moves may make room for its neighbour, and that one for the next: now the other way.
            waiting = stuck[::-1]
        self.left += [(block.places, self._obstacle(block)) for block in misaligned if block not in moved]

    def _last_start(self, block: Block) -> int:
        """The greatest index that a block can have, because some of its arguments keep their length."""
        last = self._most
        if not self._has_rigid:
            return last
        for place in block.places:
            width = place.argument.form.width
            if width is not None and self._rigid[place.argument.offset]:
                last = min(last, block.start + INDEX_RANGES[width][-1] - place.start)
        return last

    def _obstacle(self, block: Block) -> str:
        """Why a block has no other place."""
        if not block.ways():
            return "what shares its bytes wants another place"
        if block.is_open:
            return "it is not known how many bytes it takes"
        if any(self._rigid[place.argument.offset] for place in block.places):
            return "elsewhere it would need a longer encoding, and a jump counts these bytes"
        return "there is no room elsewhere"


class _Waiting(NamedTuple):
    """A block that has to move.

    block  the block
    ways   by how many bytes it may move, as `Block.ways` says it
    last   the greatest index that it can have
    """

    block: Block
    ways: int
    last: int


class _Room:
    """Which bytes of a memory are taken."""

    def __init__(self, blocks: list[Block], most: int) -> None:
        self._most = most
        self._all = _mask(0, most)
        steps = [0] * (most + 1)
        for block in blocks:
            steps[block.start] += 1
            steps[block.end] -= 1
        # How many blocks take each byte. By mistake it may be several.
        self._counts = list(accumulate(steps))
        self._taken = _bits([count > 0 for count in self._counts])
        self._contested = _bits([count > 1 for count in self._counts])

    def shift(self, waiting: _Waiting) -> int | None:
        """Moves a block the shortest way to a place that is free and aligned; up rather than down.

        Args:
            waiting: What to move.

        Returns:
            By how many bytes it was moved, None where there is no such place.
        """
        block, ways, last = waiting
        start, size = block.start, block.end - block.start
        own = _mask(start, block.end)
        places = self._all & ~(self._taken & ~own | self._contested & own)
        # The offsets from which on one byte is free, then two, four, ..., and in the end as many as it has.
        known = 1
        while known < size:
            step = min(known, size - known)
            places &= places >> step
            known += step
        places &= _starts(start % WIDEST, ways) & _mask(0, last + 1) & ~(1 << start)
        if not places:
            return None
        above, below = places >> start, places & _mask(0, start)
        up = (above & -above).bit_length() - 1 if above else self._most
        down = start - below.bit_length() + 1 if below else self._most
        shift = up if up <= down else -down
        self._move(block, start + shift)
        return shift

    def _move(self, block: Block, start: int) -> None:
        for at in range(block.start, block.end):
            self._counts[at] -= 1
            if self._counts[at] == 0:
                self._taken &= ~(1 << at)
            elif self._counts[at] == 1:
                self._contested &= ~(1 << at)
        end = start + block.end - block.start
        self._taken |= _mask(start, end)
        self._counts[start:end] = [1] * (end - start)


def _blocks(found: list[Footprint], stated: int) -> list[Block]:
    """What has to stay together, in the order of the first bytes."""
    starts = sorted({place.start for place in found})
    following = dict(pairwise([*starts, stated]))
    together: dict[tuple[int, int], list[Footprint]] = {}
    for place in found:
        start, size = place.start, place.size
        end = start + size
        # Of an array of unknown length it is assumed that the sender left room for it, up to the next variable.
        if place.most != size and following[start] > end:
            end = following[start]
        together.setdefault((start, end), []).append(place)
    joined = _Joined()
    for (start, end), places in sorted(together.items()):
        joined.add(Block(start, end, tuple(places)))
    return joined.blocks


class _Joined:
    """Blocks, of which those that belong together are one. They come in the order of their first bytes."""

    def __init__(self) -> None:
        self.blocks: list[Block] = []
        # For each block, where the last one up to it starts, and where the one that reaches furthest ends.
        self._reach: list[tuple[int, int]] = []

    def add(self, block: Block) -> None:
        """Adds a block to those that it belongs to."""
        while numbers := self._parts(block):
            for part in [self.blocks[number] for number in numbers]:
                block = Block(min(part.start, block.start), max(part.end, block.end), part.places + block.places)
            first = numbers[0]
            kept = [other for number, other in enumerate(self.blocks[first:], first) if number not in numbers]
            del self.blocks[first:], self._reach[first:]
            for other in kept:
                self._append(other)
        self._append(block)

    def _append(self, block: Block) -> None:
        start, end = self._reach[-1] if self._reach else (0, 0)
        self.blocks.append(block)
        self._reach.append((max(start, block.start), max(end, block.end)))

    def _parts(self, block: Block) -> list[int]:
        """The numbers of the blocks that belong to one; most others end before it begins, and are not asked."""
        found = []
        for number in range(len(self.blocks) - 1, -1, -1):
            start, end = self._reach[number]
            if start < block.start and end < block.end:
                break
            if block.belongs_to(self.blocks[number]):
                found.append(number)
        return found[::-1]


def _bits(flags: list[bool]) -> int:
    """A number with a bit for each, the first one the lowest."""
    return int("".join("1" if flag else "0" for flag in reversed(flags)), 2)


def _mask(start: int, end: int) -> int:
    """Bytes of memory as the bits of a number."""
    return ((1 << end - start) - 1) << start


_EVERY_WIDEST = _bits([at % WIDEST == 0 for at in range(1 << 10)])
"""Bits at the multiples of that."""


@cache
def _starts(start: int, ways: int) -> int:
    """Bits at the offsets where a block may start that may move by some numbers of bytes.

    Args:
        start: Where it starts within the widest alignment.
        ways: A bit for each number of bytes that it may move by.
    """
    found = 0
    for way in range(WIDEST):
        if ways >> way & 1:
            found |= _EVERY_WIDEST << (start + way) % WIDEST
    return found
