"""Prints messages and programs to standard output, in any format."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from ev3proto.cli.output import Printer
from ev3proto.dialogue import Exchange
from ev3proto.reading.lines import STYLES, message_lines
from ev3proto.text.json_format.from_messages import record
from ev3proto.text.phrases import NOTATIONS, Seen, heading
from ev3proto.text.spans import Spans, plain_text

if TYPE_CHECKING:
    from ev3proto.program import Program

FORMATS = (*STYLES, *NOTATIONS, "json")

_encode = json.JSONEncoder(ensure_ascii=False, check_circular=False).encode


class Show:
    """Prints messages one by one.

    style    one of FORMATS, or a format for programs only; None for the default
    at_once  flush after every message, because the next one may take long
    """

    def __init__(self, style: str | None, *, at_once: bool = False) -> None:
        self._program_style = style
        self._style = style if style in FORMATS else FORMATS[0]
        self._printer = Printer(at_once=at_once)
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
            if exchange.note is not None:
                self._printer.text(f"// note: {exchange.note}")
        else:
            self._printer.lines(message_lines(exchange, seen, rest, self._style))

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
