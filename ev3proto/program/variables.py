"""Variables for a program that was compiled: declarations that give every place that is used a name.

The declarations take exactly as much memory as the image asks for, and no alignment moves any of them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import pairwise

from ev3proto.tables.declaration import Type
from ev3proto.tables.program import ALIGNED_SIZES

_WORDS = {
    Type.DATA8: "DATA8",
    Type.DATA16: "DATA16",
    Type.DATA32: "DATA32",
    Type.DATAF: "DATAF",
    Type.HANDLE: "HANDLE",
}
MOST_DECLARED = 1 << 24
"""Bytes of a memory for which there are variables: more than the brick has. Memory beyond has no names."""

_BYTES, _STRING, _ONE = "ARRAY8", "DATAS", "DATA8"


@dataclass(frozen=True, slots=True)
class DeclaredVariable:
    """A declaration: its index, its word, the bytes of an array."""

    index: int
    word: str
    count: int | None


def declared(start: int, end: int, uses: Mapping[int, Type]) -> list[DeclaredVariable]:
    """Returns variables for the memory from `start` to `end`, one at every place that is used there.

    Args:
        start: Index of the first byte.
        end: Index after the last byte.
        uses: By the index of a place, the type as which it is used; STRING for a buffer of unknown size.
    """
    end = max(start, min(end, MOST_DECLARED))
    places = sorted(index for index in uses if start <= index < end)
    found: list[DeclaredVariable] = []
    at = start
    for index, following in pairwise((*places, end)):
        found += _filled(at, index)
        variable, at = _at(index, following, uses[index])
        found.append(variable)
    return [*found, *_filled(at, end)]


def _at(index: int, following: int, kind: Type) -> tuple[DeclaredVariable, int]:
    """Returns the variable at a place, and where the next one may start."""
    room = following - index
    width = kind.size
    if kind in _WORDS and 1 < width <= room and index % width == 0:
        return DeclaredVariable(index, _WORDS[kind], None), index + width
    if kind is Type.STRING and room > 1 and not (room in ALIGNED_SIZES and index % room):
        return DeclaredVariable(index, _STRING, room), following
    return DeclaredVariable(index, _ONE, None), index + 1


def _filled(start: int, end: int) -> Iterator[DeclaredVariable]:
    """Yields variables for memory that nothing names."""
    size = end - start
    if size > 1 and size in ALIGNED_SIZES and start % size:
        yield DeclaredVariable(start, _ONE, None)
        start, size = start + 1, size - 1
    if size == 1:
        yield DeclaredVariable(start, _ONE, None)
    elif size:
        yield DeclaredVariable(start, _BYTES, size)
