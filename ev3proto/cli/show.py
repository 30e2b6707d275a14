"""Prints what is read to standard output, in any format: messages, the texts around them, dialogues, programs."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

from ev3proto.capture.dialogues import RequestReply, dialogues
from ev3proto.capture.record import Announcement, Record, place_record
from ev3proto.cli.output import Printer
from ev3proto.dialogue import Exchange
from ev3proto.reading.items import Event
from ev3proto.reading.lines import STYLES, announcement_line, message_lines, pair_line, record_seen
from ev3proto.reading.parts import Part
from ev3proto.text.json_format.from_messages import record as message_record
from ev3proto.text.phrases import NOTATIONS, Seen, heading
from ev3proto.text.spans import Role, Spans, plain_text

if TYPE_CHECKING:
    from ev3proto.capture.filter import Filter
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
            self.entry(message_record(exchange, seen))
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

    def record(self, record: Record, start_ns: int) -> None:
        """Shows a frame of a capture that starts at `start_ns`."""
        if self.is_json:
            self.entry(_entry(record))
        else:
            self.exchange(record.exchange, record_seen(record, start_ns))

    def announcement(self, announcement: Announcement, start_ns: int) -> None:
        """Shows a text of a capture that starts at `start_ns`."""
        if not self.is_json:
            self.line(announcement_line(announcement, start_ns))
            return
        self.entry(
            {
                "kind": announcement.said.name.lower(),
                "direction": announcement.route.direction,
                **place_record(announcement),
                "text": announcement.facts,
                "hex": announcement.data.hex(),
            }
        )

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


def matching(events: Iterable[Event], chosen: Filter | None, part: Part) -> Iterator[RequestReply]:
    """Yields each command in a part with its reply, if the two match the filter."""
    is_begun = False
    for pair in dialogues(event for event in events if isinstance(event, Record)):
        if chosen is not None and not is_begun:
            chosen.begin(part.account.first_ns or 0)
            is_begun = True
        if chosen is None or chosen.of_dialogue(pair):
            yield pair


class Dialogues:
    """Shows commands with their replies, one a line. Where the connection changes, a line names it.

    is_known  whether the user knows the only connection
    """

    def __init__(self, show: Show, *, is_known: bool = False) -> None:
        self._show = show
        self._is_known = is_known
        self._place = ""

    def show(self, pair: RequestReply, start_ns: int) -> None:
        """Shows a command with its reply."""
        first, reply = pair.command or pair.last, pair.reply
        if self._show.is_json:
            entry: dict[str, Any] = {name: _entry(one) for name, one in pair._asdict().items() if one is not None}
            self._show.entry(entry | {"latency": None if reply is None else reply.latency})
            return
        route = first.route
        place = "" if route.is_text or self._is_known else f"{first.carrier} {first.peer}"
        if place and place != self._place:
            self._place = place
            self._show.aside([(place, Role.HEADING)])
        self._show.line(pair_line(pair, start_ns))


def _entry(record: Record) -> dict[str, Any]:
    """Returns a frame with its place in the capture or the log, for other tools."""
    seen = Seen(direction=record.direction, frame=record.frame)
    return message_record(record.exchange, seen) | record.circumstances()
