"""The formats of output: a class each, which prints messages, the texts around them, dialogues and programs.

Each is in FORMATS under its name, from which the choices of `--format` and the pages come.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import click

from ev3proto.capture.dialogues import RequestReply
from ev3proto.capture.record import Announcement, Record, place_record, utc
from ev3proto.cli.output import Printer, csv_line
from ev3proto.dialogue import Exchange
from ev3proto.reading.lines import announcement_line, message_lines, pair_line, record_seen
from ev3proto.tables.frame import COUNTER_SIZE, LENGTH_FIELD
from ev3proto.text.csv_rows import UNKNOWN, rows
from ev3proto.text.json_format.from_messages import record as message_record
from ev3proto.text.phrases import LEGO, MACROS, Seen, heading
from ev3proto.text.spans import Role, Spans, plain_text

if TYPE_CHECKING:
    from ev3proto.program import Program

_encode = json.JSONEncoder(ensure_ascii=False, check_circular=False).encode


class Format:
    """A format that shows nothing. Each class overrides what it shows; the rest is refused.

    name     under which users choose it
    count    number of messages, texts, dialogues and programs that were shown
    """

    has_gaps = False  # whether a blank line is between two messages

    def __init__(self, name: str, *, at_once: bool = False) -> None:
        """`at_once`: flush after every message, because the next one may take long."""
        self.name = name
        self.count = 0
        self._printer = Printer(at_once=at_once)

    def message(self, exchange: Exchange, seen: Seen, rest: bytes = b"") -> None:  # noqa: ARG002
        """Shows a message, and the bytes after it: padding, or what was in a report before."""
        raise click.UsageError(f"--format {self.name} is for programs; for messages there is {_named('message')}")

    def record(self, record: Record, start_ns: int | None) -> None:
        """Shows a frame of a capture or log that starts at `start_ns`; None: with what its text says of it."""
        if start_ns is None:
            self.message(record.exchange, record.seen, record.rest)
        else:
            self.message(record.exchange, record_seen(record, start_ns))

    def announcement(self, announcement: Announcement, start_ns: int) -> None:
        """Shows a text of a capture that starts at `start_ns`."""
        self._begin(is_apart=self.has_gaps)
        self.aside(announcement_line(announcement, start_ns))

    def pair(self, pair: RequestReply, start_ns: int) -> None:
        """Shows a command with its reply."""
        self._begin(is_apart=self.has_gaps)
        self.aside(pair_line(pair, start_ns))

    def aside(self, line: Spans) -> None:
        """Shows a line between messages."""
        self._printer.lines([line])

    def program(self, program: Program, image: bytes, origin: str | None = None) -> None:  # noqa: ARG002
        """Shows a program, with its origin if that is not obvious."""
        raise click.UsageError(f"--format {self.name} is for messages; for programs there is {_named('program')}")

    def _begin(self, *, is_apart: bool) -> None:
        if self.count and is_apart:
            self._printer.text("")
        self.count += 1


class Listing(Format):
    """Programs as lines: an operation each, unless a class overrides that."""

    def program(self, program: Program, image: bytes, origin: str | None = None) -> None:  # noqa: ARG002, D102
        self._begin(is_apart=True)
        if origin is not None:
            self.aside([(origin, Role.ASIDE)])
        self._printer.lines(self._lines_of(program))

    def _lines_of(self, program: Program) -> Iterable[Spans]:
        from ev3proto.program.listing import listing  # takes 52 ms, which frames do not need

        return listing(program)


class Lines(Format):
    """Messages as lines in the style of that name."""

    def message(self, exchange: Exchange, seen: Seen, rest: bytes = b"") -> None:  # noqa: D102
        self._begin(is_apart=self.has_gaps)
        self._printer.lines(message_lines(exchange, seen, rest, self.name))


class Default(Lines, Listing):
    """Messages as a tree, programs as a listing."""


class Tree(Default):
    """Messages and programs as trees."""

    def _lines_of(self, program: Program) -> Iterable[Spans]:
        from ev3proto.program.listing import program_tree  # takes 52 ms, which frames do not need

        return program_tree(program)


class Table(Lines):
    """Messages as bytes in groups, with labels above and meanings below."""

    has_gaps = True


class Assembly(Listing):
    """Messages and programs as assembly, which can be read back: everything else is a comment."""

    def message(self, exchange: Exchange, seen: Seen, rest: bytes = b"") -> None:  # noqa: D102, ARG002
        from ev3proto.text.assembly.disassembly import assembly  # takes 8 ms, which other formats do not need

        self._begin(is_apart=False)
        for line in assembly(exchange, plain_text(heading(exchange, seen)), self.name):
            self._printer.text(line)
        if exchange.note is not None:
            self._printer.text(f"// note: {exchange.note}")

    def aside(self, line: Spans) -> None:  # noqa: D102
        self._printer.text(f"// {plain_text(line).lstrip()}")

    def _lines_of(self, program: Program) -> Iterable[Spans]:
        from ev3proto.program.writing import source_lines  # takes 52 ms, which frames do not need

        if program.fault is None:
            return ([(line, Role.PLAIN)] for line in source_lines(program))
        # A source cannot be made from a part of a program.
        return ([("// ", Role.ASIDE), *line] for line in super()._lines_of(program))


class Json(Format):
    """Messages and programs as objects of JSON, one a line."""

    def message(self, exchange: Exchange, seen: Seen, rest: bytes = b"") -> None:  # noqa: D102, ARG002
        self._entry(message_record(exchange, seen))

    def record(self, record: Record, start_ns: int | None) -> None:  # noqa: D102
        if start_ns is None:
            super().record(record, start_ns)
        else:
            self._entry(_entry(record))

    def announcement(self, announcement: Announcement, start_ns: int) -> None:  # noqa: D102, ARG002
        told = {"kind": announcement.said.name.lower(), "direction": announcement.route.direction}
        contents = {"text": announcement.facts, "hex": announcement.data.hex()}
        self._entry(told | place_record(announcement) | contents)

    def pair(self, pair: RequestReply, start_ns: int) -> None:  # noqa: D102, ARG002
        entry: dict[str, Any] = {name: _entry(one) for name, one in pair._asdict().items() if one is not None}
        self._entry(entry | {"latency": None if pair.reply is None else pair.reply.latency})

    def aside(self, line: Spans) -> None:
        """Shows nothing: each object says where it belongs."""

    def program(self, program: Program, image: bytes, origin: str | None = None) -> None:  # noqa: D102
        from ev3proto.program.listing import program_json  # takes 52 ms, which frames do not need

        self._begin(is_apart=False)
        self._printer.joined(program_json(program, len(image), origin))

    def _entry(self, entry: dict[str, Any]) -> None:
        self._begin(is_apart=False)
        self._printer.text(_encode(entry))


def _entry(record: Record) -> dict[str, Any]:
    """Returns a frame with its place in the capture or the log, for other tools."""
    seen = Seen(direction=record.direction, missing=record.missing, frame=record.frame)
    return message_record(record.exchange, seen) | record.circumstances()


_COLUMNS = ("time", "direction", "connection", "counter", "offset", "operation", "name", "value", "unit")


class Csv(Format):
    """Messages as comma-separated values: a row for each argument, value, field and fault."""

    def message(self, exchange: Exchange, seen: Seen, rest: bytes = b"") -> None:  # noqa: D102, ARG002
        self._message(exchange, seen)

    def record(self, record: Record, start_ns: int | None) -> None:  # noqa: D102, ARG002
        seen = record.seen
        is_timed = record.written is None and record.route.is_timed
        time = utc(record.time_ns) if is_timed else seen.time
        self._message(record.exchange, seen._replace(time=time), record.connection)

    def _message(self, exchange: Exchange, seen: Seen, connection: int | None = None) -> None:
        is_counted = seen.unknown.isdisjoint(range(LENGTH_FIELD, LENGTH_FIELD + COUNTER_SIZE))
        counter = exchange.message.counter if is_counted else UNKNOWN
        self._rows((seen.time, seen.direction, connection, counter), rows(exchange, seen.unknown, seen.missing))

    def announcement(self, announcement: Announcement, start_ns: int) -> None:  # noqa: D102, ARG002
        told = utc(announcement.time_ns), announcement.route.direction, None, None
        facts = announcement.facts or {"": ""}
        self._rows(told, ((None, str(announcement.said), name, value, "") for name, value in facts.items()))

    def _rows(self, told: tuple[object, ...], found: Iterable[tuple[object, ...]]) -> None:
        if not self.count:
            self._printer.text(csv_line(_COLUMNS))
        self._begin(is_apart=False)
        for row in found:
            self._printer.text(csv_line((*told, *row)))


OUTPUT_FORMATS: dict[str, type[Format]] = {
    "tree": Tree,
    "table": Table,
    "sentence": Lines,
    MACROS: Assembly,
    LEGO: Assembly,
    "json": Json,
    "csv": Csv,
    "listing": Listing,
}
"""The formats by their names."""


def formats_of(what: str) -> tuple[str, ...]:
    """Returns the names of the formats for a `message` or a `program`."""
    return tuple(name for name, kind in OUTPUT_FORMATS.items() if getattr(kind, what) is not getattr(Format, what))


def _named(what: str) -> str:
    *others, last = formats_of(what)
    return f"{', '.join(others)} or {last}"


def made(name: str | None, *, at_once: bool = False) -> Format:
    """Returns a format by its name; without one, a tree for messages and a listing for programs."""
    return Default("tree", at_once=at_once) if name is None else OUTPUT_FORMATS[name](name, at_once=at_once)
