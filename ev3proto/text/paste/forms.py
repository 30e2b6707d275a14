"""The forms of pieces that are no whole frame: which is tried when, and what goes on over several lines.

They say at which column a piece breaks off, and read the few bytes that an argument of a command line may be.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from ev3proto.text.paste.arrays import Array, find_arrays
from ev3proto.text.paste.dumps import Dump, start_dump
from ev3proto.text.paste.hexadecimal import bare, fromhex, lesson
from ev3proto.text.paste.pieces import Found, Pasted, Wants
from ev3proto.text.paste.strings import escapes, strings

_FORMS: tuple[Callable[[str], Iterator[Found]], ...] = (fromhex, strings, escapes, lesson)


class Forms:
    """Reads line after line and keeps the array or the dump that is not yet at its end."""

    def __init__(self, wants: Wants) -> None:
        self._wants = wants
        self._open: Array | Dump | None = None

    @property
    def is_open(self) -> bool:
        """Whether a piece goes on in the next line."""
        return self._open is not None

    def close(self) -> Iterator[Pasted]:
        """What was being collected, as far as it came."""
        collected, self._open = self._open, None
        if collected is not None and collected.is_wanted(self._wants):
            yield collected.pasted()

    def feed(self, line: str, number: int) -> Iterator[Pasted]:
        """What ends with the line, and what is in the rest of it."""
        collected, position = self._open, 0
        if isinstance(collected, Dump) and collected.takes(line, number):
            return
        if isinstance(collected, Array):
            position = collected.feed(line, 0, number)
            if collected.state == "open":
                return
        yield from self.close()
        if isinstance(collected, Array) and collected.state == "closed":
            yield from self._keep(find_arrays(line, number, position, self._wants))
        else:
            yield from self._new_line(line, number)

    def _new_line(self, line: str, number: int) -> Iterator[Pasted]:
        """The pieces in a line that goes on with nothing: those of the first form that finds any."""
        if not line.strip() or line.lstrip().startswith(("#", "//")):
            return
        self._open = start_dump(line, number)
        if self._open is not None:
            return
        for form in _FORMS:
            found = [piece for piece in form(line) if self._takes(piece)]
            if found:
                yield from (piece.pasted(number, line) for piece in found)
                return
        arrays = find_arrays(line, number, 0, self._wants)
        # Hex in brackets without 0x breaks off as an array at its first letter.
        if all(array.state == "broken" for array in arrays):
            piece = bare(line, is_sure=self._wants.is_sure)
            if piece is not None and self._takes(piece) and (not arrays or piece.problem is None):
                yield piece.pasted(number, line)
                return
        yield from self._keep(arrays)

    def _takes(self, found: Found) -> bool:
        return self._wants.takes(len(found.data), found.problem, found.head, is_marked=found.is_marked)

    def _keep(self, arrays: list[Array]) -> Iterator[Pasted]:
        """Reports the arrays, and keeps the one that is still open."""
        if arrays and arrays[-1].state == "open":
            self._open = arrays.pop()
        yield from (array.pasted() for array in arrays)
