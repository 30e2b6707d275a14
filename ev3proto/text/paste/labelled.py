"""Frames whose parts stand on lines of their own, each with words beside it, as people explain them.

    0F 00 length
    2A 00 counter
    80    type

Such lines have nothing in common, so that they must be a frame without a flaw to be taken for one.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

from ev3proto.schema.header import frame_size
from ev3proto.text.paste.fitting import is_flawless, is_something
from ev3proto.text.paste.pieces import LEAST, MAX_TEXT, Pasted, short
from ev3proto.text.paste.readings import plain_bytes
from ev3proto.text.paste.scanner import Row

_MOST_LINES = 32


@dataclass(frozen=True, slots=True)
class _Part:
    row: Row
    data: bytes


class Labelled:
    """Collects lines that have some bytes each, until they are a frame."""

    def __init__(self) -> None:
        self._parts: deque[_Part] = deque(maxlen=_MOST_LINES)

    def clear(self) -> None:
        """Forgets the lines: a frame stands after them."""
        self._parts.clear()

    def take(self, row: Row) -> Pasted | None:
        """Takes a line that is no frame; the frame that ends with it, if one does."""
        data = None if row.run is None else plain_bytes(row.run)
        if data is None:
            if row.line.strip():
                self._parts.clear()
            return None
        self._parts.append(_Part(row, data))
        parts = [*self._parts]
        after = b""
        for index in range(len(parts) - 1, -1, -1):
            after = parts[index].data + after
            if len(after) < LEAST or frame_size(after) != len(after) or not is_something(after):
                continue
            # A column of numbers has parts of one size, those of a frame differ.
            is_column = len({len(part.data) for part in parts[index:]}) == 1 and index < len(parts) - 1
            if not is_column and is_flawless(after):
                self._parts.clear()
                return _pasted(parts[index:], after)
        return None


def _pasted(parts: list[_Part], data: bytes) -> Pasted:
    first = parts[0].row
    assert first.run is not None
    text = "\n".join(part.row.line for part in parts)
    said = first.said
    return Pasted(data, first.number, short(text, MAX_TEXT), said.direction, said.time, column=first.run.start + 1)
