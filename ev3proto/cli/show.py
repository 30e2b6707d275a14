"""Messages to standard output, in the format asked for: from pasted text, or with all that a capture knows of them."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

from ev3proto.cli.output import Printer
from ev3proto.dialogue import Exchange
from ev3proto.errors import Fault, counted
from ev3proto.text.heading import Seen, heading, origin
from ev3proto.text.notations import NOTATIONS
from ev3proto.text.spans import Line, Role, plain_text
from ev3proto.text.tree import tree, tree_texts

if TYPE_CHECKING:
    from ev3proto.capture import Announcement, Record
    from ev3proto.capture.dialogues import RequestReply
    from ev3proto.cli.straight import Straight
    from ev3proto.program import Program

FORMATS = ("tree", "table", *NOTATIONS, "json")


class Show:
    """Shows one message after the other.

    style    one of FORMATS, or of those that there are for programs only; None for the usual one
    at_once  what is shown is to be seen at once, because nobody knows when more will come
    dialect  the firmware whose instruction set the records that are shown are read by, where there will be any
    """

    def __init__(self, style: str | None, *, at_once: bool = False, dialect: str | None = None) -> None:
        self._program_style = style
        self._style = style if style in FORMATS else FORMATS[0]
        self._printer = Printer(at_once=at_once)
        self._dialect = dialect
        self.count = 0

    @cached_property
    def _straight(self) -> Straight | None:
        """What writes direct commands of captures straight from their bytes; None where nothing does."""
        from ev3proto.cli.straight import StraightJson, StraightTree

        if self._dialect is None:
            return None
        if self._style == "json":
            return StraightJson(self._dialect)
        return StraightTree(self._dialect) if self._style == FORMATS[0] and self._printer.is_plain else None

    def exchange(self, exchange: Exchange, seen: Seen, padding: int = 0) -> None:
        """A message, and how many bytes of padding followed it."""
        self._count()
        if self._style == "json":
            from ev3proto.text.json_format.from_messages import record_text

            self._printer.text(record_text(exchange, seen))
        elif self._style in NOTATIONS:
            from ev3proto.text.assembly.disassembly import assembly

            self._printer.texts(list(assembly(exchange, plain_text(heading(exchange, seen)), self._style)))
        else:
            if self._style == "table":
                from ev3proto.text.table import table

                self._printer.lines(table(exchange, seen))
            elif self._printer.is_plain:
                self._printer.texts(tree_texts(exchange, seen))
            else:
                self._printer.lines(tree(exchange, seen))
            if padding:
                follow = "follows" if padding == 1 else "follow"
                self._printer.text(f"        {counted(padding, 'byte')} of padding {follow} the frame")

    def program(self, program: Program, image: bytes, origin: str | None = None) -> None:
        """A program and its image, and where it comes from if that is not plain."""
        from ev3proto.cli.programs import show_program

        if self.count and self._program_style != "json":
            self._printer.text("")
        self.count += 1
        show_program(self._printer, program, image, self._program_style, origin)

    def record(self, record: Record, start_ns: int) -> Fault | None:
        """A frame of a capture that began then.

        Returns:
            What is wrong with the frame, None where nothing is.
        """
        straight = self._straight
        if straight is not None and record.note is None:
            texts = straight.texts(record, start_ns)
            if texts is not None:
                self.count += 1
                self._printer.texts(texts)
                return None
        self._record(record, start_ns)
        return record.message.fault

    def _record(self, record: Record, start_ns: int) -> None:
        if self._style == "json":
            from ev3proto.text.json_format.from_messages import record_text

            self._count()
            seen = Seen(direction=record.direction, frame=record.frame)
            self._printer.text(record_text(record.exchange, seen, _of_capture(record)))
            return
        answers = None if record.request is None else record.request.number
        self.exchange(record.exchange, _seen(record, start_ns, answers))
        if record.note is not None:
            self._aside([(f"  note: {record.note}", Role.MEANING)])

    def announcement(self, announcement: Announcement, start_ns: int) -> None:
        """A text of a capture that began then."""
        self._count()
        facts = announcement.facts
        if self._style == "json":
            route = announcement.route
            entry = {
                "kind": announcement.said.name.lower(),
                "direction": route.direction,
                **_place(announcement),
                "text": facts,
                "hex": announcement.data.hex(),
            }
            self._printer.text(_json_text(entry))
            return
        line = origin(_seen(announcement, start_ns))
        line.append((str(announcement.said), Role.HEADING))
        listed = ", ".join(f"{name} {value}" for name, value in facts.items())
        self._aside([*line, (f": {listed}" if listed else "", Role.VALUE)])

    def dialogue(self, pair: RequestReply, start_ns: int) -> None:
        """A command with its reply, on one line."""
        from ev3proto.capture.record import elapsed
        from ev3proto.text.dialogues import dialogue_line

        self.count += 1
        if self._style == "json":
            entry: dict[str, Any] = {
                name: _json(record) for name, record in pair._asdict().items() if record is not None
            }
            entry["latency"] = None if pair.reply is None else pair.reply.latency
            self._printer.text(_json_text(entry))
            return
        first = pair.command or pair.last
        reply = pair.reply
        route = first.route
        time = elapsed(first.time_ns, start_ns) if route.is_timed else ""
        line: Line = [
            (f"{time:>12} ", Role.ASIDE),
            (f"#{first.number} ".rjust(7), Role.ASIDE),
            ("" if route.is_text else f"{first.carrier} {first.peer}  ", Role.PLAIN),
        ]
        line += dialogue_line(
            None if pair.command is None else pair.command.message,
            None if reply is None else reply.exchange,
            None if reply is None else reply.latency,
        )
        self._printer.lines([line])

    def _aside(self, line: Line) -> None:
        """A line that is no message: in assembly, which can be read back, a comment."""
        if self._style in NOTATIONS:
            self._printer.text(f"// {plain_text(line).lstrip()}")
        else:
            self._printer.lines([line])

    def _count(self) -> None:
        if self.count and self._style == "table":
            self._printer.text("")
        self.count += 1


def _seen(event: Record | Announcement, start_ns: int, answers: int | None = None) -> Seen:
    from ev3proto.capture.record import Record, elapsed
    from ev3proto.cli.straight import place

    return Seen(
        direction=event.route.direction,
        time=elapsed(event.time_ns, start_ns) if event.route.is_timed else None,
        packets=event.numbers,
        place=place(event.route),
        answers=answers,
        latency=event.latency if isinstance(event, Record) else None,
        frame=event.frame if isinstance(event, Record) else None,
    )


def _place(event: Record | Announcement) -> dict[str, Any]:
    """Where and when, for other tools; no `time` where nobody wrote that down."""
    from ev3proto.capture.record import utc
    from ev3proto.cli.straight import ends

    time = {"time": utc(event.time_ns)} if event.route.is_timed else {}
    return time | {"packets": list(event.numbers), **ends(event.route)}


def _json_text(entry: dict[str, Any]) -> str:
    import json

    return json.dumps(entry, ensure_ascii=False)


def _json(record: Record) -> dict[str, Any]:
    from ev3proto.text.json_format.from_messages import record as json_record

    return json_record(record.exchange, Seen(direction=record.direction, frame=record.frame)) | _of_capture(record)


def _of_capture(record: Record) -> dict[str, Any]:
    """What a capture knows of a frame, for other tools."""
    entry = _place(record)
    if record.request is not None:
        entry |= {"answers": record.request.number, "latency": record.latency}
    if record.note is not None:
        entry["note"] = record.note
    return entry
