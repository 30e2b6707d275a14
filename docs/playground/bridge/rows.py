"""Lines as rows for the page: they know their bytes, and operations their place in the reference."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Any, NamedTuple

from ev3proto.tables import AREAS
from ev3proto.tables.declaration import declarations
from ev3proto.text.spans import Line, Role, Spans, visible

MORE = "... and many more lines; ev3proto on the command line shows all"


def _links() -> dict[str, str]:
    """Returns the place of each operation in the reference, as Sphinx names headings."""
    names = {
        name: area
        for area, opcodes in AREAS.items()
        for each in declarations(opcodes)
        for name in (each.name, each.opcode.name)
    }
    return {name: f"{area}.html#{re.sub(r'[^a-z0-9]+', '-', name.lower()).strip('-')}" for name, area in names.items()}


_LINKS = _links()


def pieces(line: Spans) -> list[list[str]]:
    """Returns the pieces of a line with a role each, and for an operation its place in the reference."""
    found = [[visible(text), role] for text, role in line if text]
    while found and not found[-1][0].rstrip():
        found.pop()
    if found:
        found[-1][0] = found[-1][0].rstrip()
    target = line.target if isinstance(line, Line) else ""
    for piece in found:
        if target and piece[1] == Role.OPERATION:
            piece.append(_LINKS[target])
    return found


class Row(NamedTuple):
    """A line of the tree.

    pieces  see `pieces`
    frame   the number of the frame that it is about, -1 for none
    offset  of its first byte in the frame
    length  how many bytes
    """

    pieces: list[list[str]]
    frame: int = -1
    offset: int = 0
    length: int = 0


class Rows:
    """The lines that are shown, up to a number of characters."""

    def __init__(self, most: int) -> None:
        """Takes the maximum number of characters."""
        self._kept: list[Row] = []
        self._left = most

    @property
    def is_full(self) -> bool:
        """Whether further lines are not kept."""
        return self._left <= 0

    def add(self, lines: Iterable[Line], frame: int = -1) -> None:
        """Adds lines that are about a frame, by its number; -1: about none."""
        for line in lines if not self.is_full else ():
            found = pieces(line)
            is_about = frame >= 0 and line.offset is not None
            self._kept.append(Row(found, frame, line.offset or 0, line.length) if is_about else Row(found))
            self._left -= sum(len(piece[0]) for piece in found) + 1

    def answer(self) -> list[list[Any]]:
        """Returns the rows for JSON, and a last one if there are more lines."""
        more = [Row([[MORE, Role.ASIDE]])] if self.is_full else []
        return [list(row) for row in (*self._kept, *more)]
