"""Prints messages and programs to standard output, in any format."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

from ev3proto.cli.output import Printer
from ev3proto.dialogue import Exchange
from ev3proto.errors import counted
from ev3proto.text.json_format.from_messages import record
from ev3proto.text.phrases import NOTATIONS, Seen, heading, origin, spaced_hex
from ev3proto.text.sentence import sentence
from ev3proto.text.spans import Role, Spans, plain_text
from ev3proto.text.table import table
from ev3proto.text.tree import tree

if TYPE_CHECKING:
    from ev3proto.program import Program

_MOST_REST = 16

RENDERERS: dict[str, Callable[[Exchange, Seen], Iterable[Spans]]] = {
    "tree": tree,
    "table": table,
    "sentence": lambda exchange, seen: [[*origin(seen), (sentence(exchange), Role.PLAIN)]],
}
FORMATS = (*RENDERERS, *NOTATIONS, "json")

_encode = json.JSONEncoder(ensure_ascii=False, check_circular=False).encode


class Show:
    """Shows messages one by one.

    style    one of FORMATS, or a format for programs only; None for the default
    at_once  flush after every message, because the next one may take long
    printer  takes the lines; by default standard output
    """

    def __init__(self, style: str | None, *, at_once: bool = False, printer: Printer | None = None) -> None:
        self._program_style = style
        self._style = style if style in FORMATS else FORMATS[0]
        self._printer = Printer(at_once=at_once) if printer is None else printer
        self.is_json = self._style == "json"
        self.count = 0

    def exchange(self, exchange: Exchange, seen: Seen, rest: bytes = b"") -> None:
        """Shows a message, and the bytes after it: padding, or what was in a report before."""
        if self.is_json:
            self.entry(record(exchange, seen))
            return
        if self.count and self._style == "table":
            self._printer.text("")
        self.count += 1
        if self._style in NOTATIONS:
            from ev3proto.text.assembly.disassembly import assembly  # takes 8 ms, which other formats do not need

            for line in assembly(exchange, plain_text(heading(exchange, seen)), self._style):
                self._printer.text(line)
        else:
            self._printer.lines(RENDERERS[self._style](exchange, seen))
            if rest:
                follow = "follows" if len(rest) == 1 else "follow"
                shown = f": {spaced_hex(rest[:_MOST_REST])}{' ...' * (len(rest) > _MOST_REST)}" if any(rest) else ""
                count = counted(len(rest), "left-over byte") if shown else f"{counted(len(rest), 'byte')} of padding"
                self._printer.text(f"        {count} {follow} the frame{shown}")
        if exchange.note is not None:
            self.aside([(f"  note: {exchange.note}", Role.MEANING)])

    def entry(self, entry: dict[str, Any]) -> None:
        """Shows a message as one JSON object."""
        self.count += 1
        self._printer.text(_encode(entry))

    def line(self, line: Spans) -> None:
        """Shows a message on one line."""
        if self.count and self._style == "table":
            self._printer.text("")
        self.count += 1
        self.aside(line)

    def aside(self, line: Spans) -> None:
        """Shows a line between messages; in assembly, which can be read back, a comment."""
        if self._style in NOTATIONS:
            self._printer.text(f"// {plain_text(line).lstrip()}")
        else:
            self._printer.lines([line])

    def program(self, program: Program, image: bytes, origin: str | None = None) -> None:
        """Shows a program, with its origin if that is not obvious."""
        from ev3proto.cli.programs import show_program  # takes 52 ms, which frames do not need

        if self.count and self._program_style != "json":
            self._printer.text("")
        self.count += 1
        show_program(self._printer, program, image, self._program_style, origin)
