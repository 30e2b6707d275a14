"""What `ev3proto decode` prints, as rows that know their bytes, and operations their page in the reference."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Any, NamedTuple

from ev3proto.cli.output import Printer
from ev3proto.cli.show import Show
from ev3proto.dialogue import Exchange
from ev3proto.program import Program
from ev3proto.tables import AREAS
from ev3proto.tables.declaration import declarations
from ev3proto.text.phrases import Seen
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


class Rows(Printer):
    """Lines that are not printed but kept, up to a number of characters."""

    def __init__(self, most: int) -> None:
        """Takes the maximum number of characters."""
        super().__init__()
        self.kept: list[Row] = []
        self._left = most
        self._frame = -1

    @property
    def is_full(self) -> bool:
        """Whether further lines are not kept."""
        return self._left <= 0

    def begin(self, frame: int) -> None:
        """Begins the lines of a frame: its number, -1 for lines that are about none."""
        self._frame = frame

    def lines(self, lines: Iterable[Spans]) -> None:
        """Takes lines."""
        for line in lines:
            found = pieces(line)
            if self._frame >= 0 and isinstance(line, Line) and line.offset is not None:
                self.kept.append(Row(found, self._frame, line.offset, line.length))
            else:
                self.kept.append(Row(found))
            self._left -= sum(len(piece[0]) for piece in found) + 1

    def text(self, text: str) -> None:
        """Takes one line."""
        self.lines([[(text, Role.PLAIN)]])


class Showing(Show):
    """Shows messages as rows, as long as there is room.

    number  that of the newest frame; the first is 0
    frames  the bytes of those that are shown, by number
    """

    def __init__(self, rows: Rows) -> None:
        """Shows messages in these rows."""
        super().__init__(None, printer=rows)
        self.number = -1
        self.frames: dict[int, bytes] = {}
        self._rows = rows

    def exchange(self, exchange: Exchange, seen: Seen, padding: bytes = b"") -> None:
        """Shows a message."""
        self.number += 1
        if self._rows.is_full:
            self.count += 1
            return
        frame = seen.frame if seen.frame is not None else exchange.message.build()
        self.frames[self.number] = frame
        self._rows.begin(self.number)
        super().exchange(exchange, seen, padding)

    def aside(self, line: Spans) -> None:
        """Shows a line between messages."""
        if not self._rows.is_full:
            self._rows.begin(-1)
            super().aside(line)

    def program(self, program: Program, image: bytes, origin: str | None = None) -> None:
        """Shows a program."""
        self.number += 1
        self.frames[self.number] = image
        self._rows.begin(self.number)
        super().program(program, image, origin)


def shown(rows: Rows) -> list[list[Any]]:
    """Returns the rows for JSON, and a last one if there are more lines."""
    return [list(row) for row in rows.kept] + ([[[[MORE, Role.ASIDE]], -1, 0, 0]] if rows.is_full else [])
