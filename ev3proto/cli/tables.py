"""Tables for people: as wide as they are into a pipe, as wide as the terminal at most on one."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from itertools import compress

from ev3proto.cli.output import Printer, say
from ev3proto.text.spans import Role
from ev3proto.text.visible import visible

TEXTS = {"kind", "operation", "text", "path", "direction", "state", "brick", "what", "part"}
"""The columns that have texts in them, which stand left and may be folded; the others have numbers."""

_UNLIMITED = 10_000
"""Columns of a pipe."""


class Tables:
    """Prints headings and tables, with an empty line between them.

    hidden  titles of columns that are omitted everywhere
    """

    def __init__(self, hidden: Collection[str] = ()) -> None:
        from rich.console import Console

        self._console = Console(highlight=False, markup=False, emoji=False)
        self._on_terminal = self._console.is_terminal
        if not self._on_terminal:
            self._console.width = _UNLIMITED
        self._hidden = hidden
        self._is_first = True

    def heading(self, text: str) -> None:
        """A line with an empty one above it."""
        if not self._is_first:
            say()
        self._is_first = False
        Printer().lines([[(text, Role.HEADING)]])

    def table(self, titles: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
        """A table. Its cells may come from the network: nothing in them is markup, nothing moves the cursor."""
        from rich.table import Table
        from rich.text import Text

        table = Table(box=None, pad_edge=False, header_style="dim")
        shown = [title not in self._hidden for title in titles]
        for title in compress(titles, shown):
            is_text = title in TEXTS
            table.add_column(title, justify="left" if is_text else "right", overflow="fold", no_wrap=not is_text)
        for row in rows:
            table.add_row(*(Text(visible(cell)) for cell in compress(row, shown)))
        with self._console.capture() as captured:
            self._console.print(table)
        say("\n".join(line.rstrip() for line in captured.get().splitlines()))
