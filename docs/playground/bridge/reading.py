"""What was typed or opened: read once, as far as it is shown kept as data."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from ev3proto.capture.dialogues import RequestReply, dialogues
from ev3proto.capture.filter import Filter
from ev3proto.capture.record import Announcement, Place, Record, Skipped, elapsed
from ev3proto.capture.timeline import Form, collect, render
from ev3proto.dialogue import Exchange
from ev3proto.errors import DecodeError
from ev3proto.messages import Message
from ev3proto.program import assemble, check_program
from ev3proto.program import parse as parse_program
from ev3proto.program.listing import listing
from ev3proto.reading.assembling import assembled
from ev3proto.reading.faults import Faults
from ev3proto.reading.given import Given, given_word
from ev3proto.reading.items import Event, Image, Problem, ProblemCode, Source, SourceKind
from ev3proto.reading.lines import announcement_line, message_lines, record_seen
from ev3proto.reading.options import Options, Sources
from ev3proto.reading.parts import Reading
from ev3proto.schema.frame import parse
from ev3proto.text.assembly.disassembly import assembly
from ev3proto.text.assembly.errors import AssemblyError
from ev3proto.text.assembly.recognising import OBJECT, is_assembly
from ev3proto.text.fixed_text import fix_text
from ev3proto.text.forms import as_c, as_hex, as_python
from ev3proto.text.phrases import LEGO, command_spans, reply_spans
from ev3proto.text.spans import plain_text, visible

from .findings import Findings
from .remedies import with_buttons
from .rows import Rows

MOST_SHOWN = 200_000
"""Maximum characters of each text of an answer."""

MOST_SENT = 100
"""Maximum number of frames sent to a brick at once."""

MOST_DIALOGUES = 1000

FEW = 200
"""Frames whose notations, and dialogues, are in the first answer; those of more are rendered when they are opened."""

MOST_COMPLAINTS = 12
"""Maximum lines of errors."""

MOST_WARNINGS = 20
"""Maximum number of warnings about a program's source."""

TYPED = "input"
"""The name of what was typed, in places."""

OFTEN, SOON, LATE = 0.25, 1.0, 1.5
"""Seconds between two reports of progress; until a first part of the answer if the tree is full, and if it is not."""

FEW_CHARACTERS = 4_000
"""A text up to this length is fixed to find out whether that changes it."""

LESSON = "lesson"
FORMS: dict[str, Callable[[Message, str], str]] = {
    LESSON: lambda message, _: as_hex(message),
    "c": as_c,
    "python": as_python,
    "operations": lambda message, _: "\n".join(list(assembly(Exchange(message), "", LEGO))[1:]),
}

Publish = Callable[[str], object]
"""Takes a report of progress, or a part of the answer, as JSON."""


class Input:
    """One input, and what is shown of it."""

    def __init__(self, publish: Publish = lambda _: None, wanted: Filter | None = None) -> None:
        self._wanted = wanted
        self.image: bytes | None = None
        self._publish = publish
        self._rows = Rows(MOST_SHOWN)
        self._number = -1
        self._shown: dict[int, bytes] = {}
        self._findings = Findings()
        self._faults = Faults()
        self._problems: list[Problem] = []
        self._problem_count = 0
        self._typed: str | None = None
        self._name = TYPED
        self._again: Callable[[], Given] = lambda: Given(TYPED, lines=())
        self._assembled = 0
        self._frames: list[bytes] = []
        self._lesson: list[str] = []
        self._lesson_size = 0
        self._commands: list[bytes] = []
        self._command_count = 0
        self._pairs: list[RequestReply] = []
        self._pair_count = 0
        self._start_ns = 0
        self._reading = Reading([], Options())
        self._done: Callable[[], float] = lambda: self._reading.progress or 0.0
        self._begun = self._said = time.monotonic()
        self._next = LATE

    # Reading

    def type(self, text: str) -> None:
        """Reads what was typed or pasted."""
        if not text.strip():
            return
        if OBJECT.search(text):
            self._program_of(text, TYPED)
            return
        self._typed = text
        # A single operation may look like bytes, too: INFO(GET_VOLUME, GV0(0)).
        is_long = "\n" in text.strip() or is_assembly(text.strip())
        self._again = lambda: Given(TYPED, lines=text.splitlines(keepends=True))
        self._read(Given(TYPED, lines=self._counted(text)) if is_long else given_word(text.strip()))

    def open(self, path: Path) -> None:
        """Reads a file."""
        self._name = path.name
        self._again = lambda: Given(path.name, path, lambda: path.open("rb"))
        self._read(self._again())

    def _read(self, given: Given) -> None:
        self._reading = Reading([given], Options(raises=False, filter=self._wanted))
        for pair in dialogues(self._records(self._reading.events())):
            self._pair_count += 1
            if len(self._pairs) < MOST_DIALOGUES:
                self._pairs.append(pair)

    def _counted(self, text: str) -> Iterator[str]:
        """Yields the lines of a text, and counts what was read of it."""
        done = 0
        self._done = lambda: done / len(text)
        for line in text.splitlines(keepends=True):
            done += len(line)
            yield line

    def _records(self, events: Iterator[Event]) -> Iterator[Record]:
        """Takes everything, and yields the records that may be a dialogue."""
        for event in events:
            if isinstance(event, Record):
                self._record(event)
                yield event
            elif isinstance(event, Announcement):
                self._rows.add([announcement_line(event, self._start())])
            elif isinstance(event, Image):
                self._image(event.data, event.place.name)
            elif isinstance(event, Source):
                self._source(event)
            elif isinstance(event, Problem):
                self._problem(event)

    def _start(self) -> int:
        self._start_ns = self._reading.part.account.first_ns or 0
        return self._start_ns

    def _record(self, record: Record) -> None:
        written, start_ns = record.written, self._start()
        self._show(record, start_ns)
        fault = self._faults.of(record, is_text=written is not None)
        if fault is not None:
            self._problem(fault)
        if written is None:
            self._take(record, str(record.place), 0, carrier=str(record.carrier))
        elif not record.is_cut:
            self._take(record, "" if written.is_typed else str(record.place), record.number)

    def _show(self, record: Record, start_ns: int) -> None:
        self._number += 1
        if not self._rows.is_full:
            self._shown[self._number] = record.frame
            seen = record.seen if record.written is not None else record_seen(record, start_ns)
            self._rows.add(message_lines(record.exchange, seen, record.rest), self._number)

    def _source(self, source: Source) -> None:
        """Reads assembly, or the source of a program."""
        if source.kind is SourceKind.PROGRAM:
            self._program_of(source.text, source.place.name)
            return
        made = list(assembled(source))
        records = [item for item in made if isinstance(item, Record)]
        self._assembled = len(records)
        for number, record in enumerate(records, 1):
            self._show(record, 0)
            self._take(record, f"frame {number}" if len(records) > 1 else "", 0)
        for item in made:
            if isinstance(item, Problem):
                self._problem(item)

    def _program_of(self, text: str | bytes, label: str) -> None:
        """Reads the source of a program."""
        try:
            made = assemble(text)
        except AssemblyError as error:
            for one in (error, *error.others):
                self._problem(Problem.in_source(label, one))
            return
        warnings = [f"{Problem.in_source(label, one)} (warning)" for one in made.warnings]
        more = len(warnings) - MOST_WARNINGS
        self._findings.warn([*warnings[:MOST_WARNINGS], *([f"... and {more} more warnings"] if more > 0 else [])])
        self._image(made.image, label)

    def _image(self, image: bytes, label: str) -> None:
        """Takes the image of a program."""
        self.image, place = image, Place(label)
        try:
            program = parse_program(image, strict=False)
        except DecodeError as error:
            self._problem(Problem(place, ProblemCode.DAMAGED, str(error)))
        else:
            self._number += 1
            self._shown[self._number] = image
            self._rows.add(listing(program), self._number)
            for fault in program.faults:
                self._problem(Problem(place, ProblemCode.FAULT, f"fault at {fault}"))
        self._findings.program(check_program(image))

    def _problem(self, problem: Problem) -> None:
        self._problem_count += 1
        if len(self._problems) < MOST_COMPLAINTS:
            self._problems.append(problem)

    def _take(self, record: Record, place: str, line: int, *, carrier: str | None = None) -> None:
        """Takes a frame, which was shown."""
        message, frame = record.message, record.frame
        if message.type is not None and message.type.is_command:
            self._command_count += 1
            if len(self._commands) < MOST_SENT:
                self._commands.append(frame)
        if self._lesson_size < MOST_SHOWN:
            self._frames.append(frame)
            self._lesson.append(as_hex(message))
            self._lesson_size += len(self._lesson[-1]) + 1
        if record.is_from_brick:
            self._findings.reply()
        else:
            self._findings.frame(frame, self._number, place, line, carrier=carrier)
        self._breathe()

    def _breathe(self) -> None:
        """Reports progress, and now and then a part of the answer."""
        now = time.monotonic()
        if now - self._said < OFTEN:
            return
        self._said = now
        self._publish(json.dumps({"part": self._done(), "count": self._number + 1}))
        is_first = self._rows.is_full and self._next == LATE
        if now - self._begun > (SOON if is_first else self._next):
            self._next *= 2
            self._publish(json.dumps({"answer": self.answer(is_whole=False)}))

    # The answer

    def answer(self, *, is_whole: bool = True) -> dict[str, Any]:
        """Returns what is shown, for JSON.

        error      sentences, with the lines of a source that they are about
        problems   the same as data: each with message, place, severity, code, line and column
        count      the number of frames
        isProgram  whether it is a program
        lines      of the tree, each with its pieces, the number of its frame (-1 for none), offset and number of bytes
        frames     in hex, by number
        findings   see `Findings.answer`
        isFixable  whether a fix would change the text
        made       the frames in the lesson's notation, and if they are few, in all
        dialogues  their number, and the first ones, each with time, command, reply, latency
        """
        findings = self._findings.answer()
        frames = self._shown | {each.number: each.report.frame for each in self._findings.frames}
        is_few = is_whole and len(self._frames) <= FEW and self.image is None
        return {
            "error": self._error(),
            "problems": [_problem_entry(problem) for problem in self._problems],
            "count": self._number + 1,
            "isProgram": self.image is not None,
            "lines": self._rows.answer(),
            "frames": {number: frame.hex() for number, frame in frames.items()},
            "findings": findings,
            "isFixable": is_whole and self._is_fixable(),
            "made": {form: self.made(form) for form in (FORMS if is_few else (LESSON,))},
            "dialogues": {"count": self._dialogue_count(), "rows": self.dialogue_rows(FEW)},
        }

    def _error(self) -> str:
        lines: list[str] = []
        for problem in self._problems:
            lines += [str(problem), *(f"  {line}" for line in problem.excerpt.split("\n") if problem.excerpt)]
        left = self._problem_count - len(self._problems) + max(len(lines) - MOST_COMPLAINTS, 0)
        shown = [*lines[:MOST_COMPLAINTS], *([f"... and {left} more lines"] if left else [])]
        return "".join(f"{with_buttons(visible(line))}\n" for line in shown)

    def made(self, form: str) -> str:
        """Returns the frames in a notation, as far as they are shown."""
        if form == LESSON:
            return _shortened(self._lesson, self._number + 1)
        found: list[str] = []
        size = 0
        for number, frame in enumerate(self._frames, 1):
            found.append(FORMS[form](parse(frame, strict=False), f"frame_{number}"))
            size += len(found[-1]) + 1
            if size > MOST_SHOWN:
                break
        return _shortened(found, self._number + 1)

    # Fixes

    def _is_fixable(self) -> bool:
        if self._typed is None or self._assembled or not self._findings.frames:
            return False
        if len(self._typed) <= FEW_CHARACTERS:
            return fix_text(self._typed).is_fixed
        return self._findings.is_fixable

    def fixed(self) -> str:
        """Returns the text with every certain fix in it."""
        return "" if self._typed is None else fix_text(self._typed).text

    # Dialogues

    def _dialogue_count(self) -> int:
        """Returns the number of dialogues; a text with one frame has none."""
        return self._pair_count if self._number or not self._reading.part.is_text else 0

    def dialogue_rows(self, most: int) -> list[list[str]]:
        """Returns dialogues: time, command, reply, latency of each."""
        return [self._dialogue_row(pair) for pair in self._pairs[:most]] if self._dialogue_count() else []

    def all_dialogue_rows(self) -> list[list[str]]:
        """Returns as many dialogues as are shown."""
        return self.dialogue_rows(MOST_DIALOGUES)

    def _dialogue_row(self, pair: RequestReply) -> list[str]:
        command, reply = pair
        first = command or pair.last
        latency = None if reply is None else reply.latency
        asks = command is not None and command.message.wants_reply
        return [
            elapsed(first.time_ns, self._start_ns) if first.route.is_timed else "",
            "(a command that was not seen)" if command is None else plain_text(command_spans(command.message)),
            ("no reply" if asks else "") if reply is None else plain_text(reply_spans(reply.exchange)),
            "" if latency is None else f"{latency * 1000:.3f} ms",
        ]

    # The timeline

    def timeline(self) -> str:
        """Returns the input over time as a Vega-Lite specification with its data; null if it is empty."""
        reading = Reading([self._again()], Options(sources=Sources.NO, images=False, raises=False))
        drawn = collect(event for event in reading.events() if isinstance(event, Record | Announcement | Skipped))
        return "null" if drawn is None else render(drawn, Form.JSON, self._name).decode()

    # Sending

    def to_send(self) -> dict[str, Any]:
        """Returns what is sent to a brick: frames in hex and their number, or a program; and an error."""
        if self.image is not None:
            return {"frames": [], "count": 0, "program": self.image.hex(), "error": ""}
        error = "" if self._commands else "The input has no command to send."
        return {
            "frames": [frame.hex() for frame in self._commands],
            "count": self._command_count,
            "program": None,
            "error": error,
        }


def _shortened(found: list[str], count: int) -> str:
    """Joins frames in a notation, with a last line if there are more."""
    if len(found) == count or not found:
        return "\n".join(found)
    return "\n".join([*found, f"... and {count - len(found)} more frames; ev3proto on the command line shows all"])


def _problem_entry(problem: Problem) -> dict[str, Any]:
    """Returns a problem for JSON."""
    place = problem.place
    return {
        "message": problem.message,
        "place": str(place),
        "severity": problem.severity,
        "code": problem.code,
        "line": place.line,
        "column": place.column,
    }
