"""The operations of a code, stored as offsets (four bytes each) and read again on access.

An image may have millions of operations; objects for all of them would take 500 times its size.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import overload

from ev3proto.errors import Fault
from ev3proto.messages import Operation
from ev3proto.program.retyped import Types
from ev3proto.schema.instructions import InstructionSet, instruction_set

_WINDOW = 256
"""Operations that are read at once when iterating."""

_FIRST_BYTES = 2048
_GROWTH = 16
"""Size of the window that is scanned, in bytes, and the factor by which it grows if not one operation fits."""


def scanned(data: bytes, at: int, end: int, instructions: InstructionSet) -> Iterator[Operation | Fault]:
    """Yields the operations from one offset to another, then the fault of the bytes after them, if any."""
    size = _FIRST_BYTES
    while at < end:
        stop = min(at + size, end)
        found, fault = instructions.scan(data, at, stop)
        if fault is not None and stop < end:
            # Perhaps only the window cuts this operation off, so the next window starts with it.
            if found and not found[-1].is_complete:
                found.pop()
            fault = None
        yield from found
        if fault is not None:
            yield fault.fault
            return
        if found:
            at, size = found[-1].offset + found[-1].length, _FIRST_BYTES
        else:
            size *= _GROWTH


class Code(Sequence[Operation]):
    """The operations of one code of an image. Slices are views of it."""

    __slots__ = ("_ahead", "_data", "_limit", "_starts", "_types")

    def __init__(self, data: bytes, starts: Sequence[int], limit: int, types: Types) -> None:
        """Creates a view of consecutive operations; `limit` is the end of the bytes to read the last one from."""
        self._data = data
        self._starts = starts
        self._limit = limit
        self._types = types
        self._ahead: tuple[int, list[Operation]] = (0, [])

    def __len__(self) -> int:
        return len(self._starts)

    @overload
    def __getitem__(self, index: int) -> Operation: ...

    @overload
    def __getitem__(self, index: slice) -> Sequence[Operation]: ...

    def __getitem__(self, index: int | slice) -> Operation | Sequence[Operation]:
        starts = self._starts
        if isinstance(index, slice):
            first, stop, step = index.indices(len(starts))
            if step != 1:
                return tuple(self)[index]
            limit = self._limit if stop >= len(starts) else starts[stop]
            return Code(self._data, starts[first:stop], limit, self._types)
        place = range(len(starts))[index]
        first, read = self._ahead
        if not first <= place < first + len(read):
            # Sequential access reads ahead, more each time.
            is_next = place == first + len(read)
            read = self._window(place, min(_WINDOW, 2 * len(read)) if is_next and read else 1)
            self._ahead = first, read = place, read
        return read[place - first]

    def __iter__(self) -> Iterator[Operation]:
        for place in range(0, len(self._starts), _WINDOW):
            yield from self._window(place, _WINDOW)

    def _window(self, place: int, count: int) -> list[Operation]:
        after = place + count
        stop = self._starts[after] if after < len(self._starts) else self._limit
        found, _ = instruction_set(self._types.dialect).scan(self._data, self._starts[place], stop)
        return [self._types.typed(operation) for operation in found]

    @property
    def starts(self) -> Sequence[int]:
        """The offsets of the operations."""
        return self._starts

    @property
    def raw(self) -> bytes:
        """The bytes of all of them."""
        return self._data[self._starts[0] : self[-1].offset + self[-1].length] if self else b""

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, (Code, tuple)):
            return NotImplemented
        return len(self) == len(other) and all(map(Operation.__eq__, self, other))

    def __hash__(self) -> int:
        return hash(tuple(self))

    def __repr__(self) -> str:
        return repr(tuple(self))

    def __reduce__(self) -> tuple[object, ...]:
        """Copies and pickles keep the offsets."""
        return Code, (self._data, self._starts, self._limit, self._types)
