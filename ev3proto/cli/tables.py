"""Tables: folded to the width of a terminal as far as their numbers allow, unfolded into a pipe."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from itertools import compress

from ev3proto.cli.output import Printer, draw, say
from ev3proto.text.spans import Role, visible

TEXTS = {"kind", "operation", "text", "path", "direction", "state", "brick", "what", "part"}
"""The columns with texts, which are left-aligned and may be folded; the others have numbers."""

LEAST_TEXT = 12
"""Minimum width of a column of texts."""

GAP = "  "
"""The space between two columns."""


class Tables:
    """Prints headings and tables, with an empty line between them.

    hidden  titles of columns that are omitted everywhere
    """

    def __init__(self, hidden: Collection[str] = ()) -> None:
        from rich.console import Console  # takes 13 ms, which JSON does not need

        self._console = Console(highlight=False, markup=False, emoji=False)
        self._size = self._console.size
        self._on_terminal = self._console.is_terminal
        self._hidden = hidden
        self._is_first = True

    def heading(self, text: str) -> None:
        """Prints a line, with an empty one above it."""
        if not self._is_first:
            say()
        self._is_first = False
        Printer().lines([[(text, Role.HEADING)]])

    def table(self, titles: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
        """Prints a table. Its cells may come from the network: they are escaped, and not read as markup."""
        shown = [title not in self._hidden for title in titles]
        # Cells are escaped before colours are added.
        cells = [[visible(cell) for cell in compress(row, shown)] for row in (titles, *rows)]
        draw(self._on_screen(*cells) if self._on_terminal else _plain(cells))

    def _on_screen(self, titles: list[str], *rows: list[str]) -> list[str]:
        """Returns the lines of a table in colours, folded to the width of the terminal."""
        from rich.console import ConsoleDimensions  # with the next two, takes 26 ms, which only terminals need
        from rich.table import Table
        from rich.text import Text

        table = Table(box=None, pad_edge=False, header_style="dim")
        for title in titles:
            is_text = title in TEXTS
            table.add_column(title, justify="left" if is_text else "right", overflow="fold", no_wrap=not is_text)
        for row in rows:
            table.add_row(*map(Text, row))
        # Rich would cut numbers and omit columns; a wider line continues in the next line of the terminal.
        width, height = self._size
        # For an unknown terminal, Rich accepts a width only with a height.
        self._console.size = ConsoleDimensions(max(width, _least_width([titles, *rows])), height)
        with self._console.capture() as captured:
            self._console.print(table)
        return [line.rstrip() for line in captured.get().splitlines()]


def _widths(rows: list[list[str]]) -> list[int]:
    from rich.cells import cell_len  # takes 1 ms, and is a part of the console

    return [max(map(cell_len, column)) for column in zip(*rows, strict=True)]


def _least_width(rows: list[list[str]]) -> int:
    """Returns the minimum width of a table: its numbers unfolded, its texts folded."""
    widths = [
        min(width, LEAST_TEXT) if title in TEXTS else width for title, width in zip(rows[0], _widths(rows), strict=True)
    ]
    return sum(widths) + len(GAP) * (len(widths) - 1)


def _plain(rows: list[list[str]]) -> list[str]:
    """Returns the lines unfolded, without colours. Rich would take a kilobyte or more for each cell."""
    from rich.cells import cell_len  # takes 1 ms, and is a part of the console

    widths = _widths(rows)
    lines = []
    for row in rows:
        columns = []
        for title, cell, width in zip(rows[0], row, widths, strict=True):
            space = " " * (width - cell_len(cell))
            columns.append(cell + space if title in TEXTS else space + cell)
        lines.append(GAP.join(columns).rstrip())
    return lines
