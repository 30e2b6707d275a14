"""`ev3proto decode`: frames in any form people have them, told in words, as a table, as assembly or as JSON."""

from __future__ import annotations

import codecs
import io
import json
import re
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

import click

from ev3proto.cli.output import Printer, complain
from ev3proto.dialogue import Dialogue, Exchange
from ev3proto.tables.declaration import DIALECTS
from ev3proto.text.assembly import assembly
from ev3proto.text.heading import Seen, heading
from ev3proto.text.notation import MAX_LINE, Pasted, read_argument, read_text
from ev3proto.text.records import record
from ev3proto.text.spans import plain_text
from ev3proto.text.split import Piece, split
from ev3proto.text.table import table
from ev3proto.text.tree import tree

FORMATS = ("tree", "table", "asm", "json")


_GROUP = re.compile(r"(0x)?([0-9a-f]{2}:?){1,4},?", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class Source:
    """One thing that was named on the command line: a file, standard input, or a frame itself."""

    name: str
    is_frame: bool

    def pasted(self) -> Iterator[Pasted]:
        """What stands in it. Raises OSError when it cannot be read."""
        if self.is_frame:
            yield read_argument(self.name)
        elif self.name == "-":
            if sys.stdin is None:
                raise OSError("standard input is closed")
            yield from read_text(_lines(sys.stdin.buffer))
        else:
            with Path(self.name).open("rb") as stream:
                yield from read_text(_lines(stream))

    def where(self, pasted: Pasted) -> str:
        """How a complaint about it starts."""
        if self.is_frame:
            return f"{self.name[:60]!r}" + ("" if pasted.data else " is no file and no frame")
        return f"{'standard input' if self.name == '-' else self.name}, line {pasted.line}"


def _lines(stream: BinaryIO) -> Iterator[str]:
    """The lines of a file, those that are too long only as far as it takes to see that.

    Text is UTF-8, or UTF-16 where the file starts with that mark, as PowerShell writes it.
    """
    start = stream.peek(2)[:2] if isinstance(stream, io.BufferedReader) else b""
    encoding = "utf-16" if start in (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE) else "utf-8-sig"
    text = io.TextIOWrapper(stream, encoding, "replace")
    while line := text.readline(MAX_LINE + 1):
        yield line
        while len(line) > MAX_LINE and not line.endswith("\n"):
            line = text.readline(MAX_LINE + 1)


def _sources(names: tuple[str, ...]) -> list[Source]:
    """What was named; bytes that were typed without quotes around them are one frame."""
    if len(names) > 1 and all(_GROUP.fullmatch(name) for name in names):
        return [Source(" ".join(names), is_frame=True)]
    return [Source(name, is_frame=name != "-" and (not name or not _exists(name))) for name in names or ("-",)]


def _exists(name: str) -> bool:
    try:
        return Path(name).exists()
    except (OSError, ValueError):
        return False


class Show:
    """Shows one message after the other in the format asked for, and remembers whether any was at fault."""

    def __init__(self, style: str, dialect: str) -> None:
        self._style = style
        self._dialect = dialect
        self._dialogue = Dialogue()
        self._printer = Printer()
        self._count = 0
        self.at_fault = False

    @property
    def count(self) -> int:
        """Messages shown so far."""
        return self._count

    def pasted(self, pasted: Pasted, where: str) -> None:
        """Everything in one piece of pasted text."""
        if pasted.problem is not None:
            complain(f"{where}: {pasted.problem}")
            self.at_fault = True
        if pasted.data:
            for piece in split(pasted.data, dialect=self._dialect):
                self._piece(piece, pasted, where)

    def _piece(self, piece: Piece, pasted: Pasted, where: str) -> None:
        exchange = self._dialogue.follow(piece.message)
        fault = piece.message.fault
        cut = pasted.cut and fault is not None and fault.truncated
        self._show(exchange, piece.padding, Seen(pasted.direction, pasted.time, cut))
        self._count += 1
        if fault is not None and not cut:
            self.at_fault = True
            complain(f"{where}: fault at {fault}")

    def _show(self, exchange: Exchange, padding: int, seen: Seen) -> None:
        if self._style == "json":
            self._printer.text(json.dumps(record(exchange, seen), ensure_ascii=False))
            return
        if self._style == "asm":
            for line in assembly(exchange, plain_text(heading(exchange, seen))):
                self._printer.text(line)
            return
        if self._count and self._style == "table":
            self._printer.text("")
        draw = table if self._style == "table" else tree
        self._printer.lines(draw(exchange, seen))
        if padding:
            self._printer.text(f"        {padding} bytes of padding follow the frame")


def _readable(source: Source) -> Iterator[Pasted]:
    """What stands in a source; a sentence and exit status 1 where it cannot be read."""
    try:
        yield from source.pasted()
    except OSError as error:
        complain(f"{source.name}: cannot be read: {error.strerror or error}")
        sys.exit(1)


@click.command()
@click.argument("sources", nargs=-1, metavar="[FRAME|FILE|-]...")
@click.option(
    "--format", "style", type=click.Choice(FORMATS), default="tree", show_default=True, help="How to show messages."
)
@click.option("--json", "as_json", is_flag=True, help="One JSON object a line: the same as --format json.")
@click.option(
    "--dialect", type=click.Choice(DIALECTS), default="official", show_default=True, help="Whose instruction set it is."
)
def decode(sources: tuple[str, ...], style: str, as_json: bool, dialect: str) -> None:
    """Tells what frames say.

    Give frames themselves, files that have them in their lines, or - (or nothing) for standard input. Any form will do:
    log lines with their times, hex with or without spaces and colons, C arrays, Python byte strings.

    \b
      ev3proto decode "0x|0E:00|2A:00|80|00:00|94|01|01|82:B8:01|82:E8:03|"
      ev3proto decode 0e 00 2a 00 80 00 00 94 01 01 82 b8 01 82 e8 03
      ev3proto decode --format table robot.log
      python3 my_program.py | ev3proto decode --json
    """  # noqa: D301 - the mark by which click leaves lines as they are
    show = Show("json" if as_json else style, dialect)
    for source in _sources(sources):
        for pasted in _readable(source):
            show.pasted(pasted, source.where(pasted))
    if not show.count:
        if not show.at_fault:
            complain("there is no frame in the input: frames are written in hex, such as 06:00|2A:00|80|00:00|01")
        show.at_fault = True
    sys.exit(1 if show.at_fault else 0)
