"""Lines to people: coloured on a terminal, plain into a pipe and where NO_COLOR is set."""

from __future__ import annotations

import sys
from collections.abc import Iterable

import click
from rich.console import Console
from rich.text import Text

from ev3proto.text.spans import Line, Role, plain_text

STYLES = {
    Role.PLAIN: "",
    Role.HEADING: "bold",
    Role.OPERATION: "bold cyan",
    Role.NAME: "green",
    Role.VALUE: "yellow",
    Role.MEANING: "magenta",
    Role.ASIDE: "dim",
    Role.FAULT: "bold red",
}


class Printer:
    """Prints lines, each as soon as it is there."""

    def __init__(self) -> None:
        self._console = Console(highlight=False, soft_wrap=True)
        self._coloured = sys.stdout.isatty() and self._console.is_terminal and not self._console.no_color

    def lines(self, lines: Iterable[Line]) -> None:
        """Prints lines that are made of pieces."""
        for line in lines:
            if self._coloured:
                self._console.print(Text.assemble(*((text, STYLES[role]) for text, role in line)))
            else:
                click.echo(plain_text(line))

    def text(self, text: str) -> None:
        """Prints text as it is."""
        click.echo(text)


def complain(sentence: str) -> None:
    """A sentence to standard error."""
    click.echo(sentence, err=True)
