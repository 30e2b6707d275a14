"""What was typed or opened: read once, as far as it is shown kept as data."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

from ev3proto.capture.filter import Choosing, Filter
from ev3proto.capture.record import Announcement, Place, Record, Skipped
from ev3proto.capture.timeline import Form, Timeline, collect_in_steps, render
from ev3proto.checking.report import Severity
from ev3proto.dialogue import Exchange
from ev3proto.errors import DecodeError
from ev3proto.messages import Message
from ev3proto.program import assemble, check_program
from ev3proto.program import parse as parse_program
from ev3proto.reading.assembling import assembled
from ev3proto.reading.given import Given
from ev3proto.reading.headline import Headline, Proposal, Subject
from ev3proto.reading.items import Event, Image, Problem, ProblemCode, Source, SourceKind
from ev3proto.reading.options import Options, Sources
from ev3proto.reading.parts import Reading
from ev3proto.schema.frame import parse
from ev3proto.text.assembly.disassembly import assembly
from ev3proto.text.assembly.errors import AssemblyError
from ev3proto.text.assembly.recognising import OBJECT, is_assembly
from ev3proto.text.forms import as_c, as_hex, as_python
from ev3proto.text.paste import read_text
from ev3proto.text.phrases import LEGO, spaced_hex
from ev3proto.text.spans import visible

from .findings import Findings
from .headline import headline, label
from .pages import Pages
from .proposals import bare, proposals

MOST_SHOWN = 200_000
"""Maximum characters of the frames in a notation."""

MOST_SENT = 100
"""Maximum number of frames sent to a brick at once."""

FEW = 200
"""Frames whose notations are in the answer; those of more are rendered when they are opened."""

MOST_MARKS = 4000
"""Maximum number of marks in the timeline, which the page draws at once; more are counted in bins of time."""

MOST_COMPLAINTS = 12
"""Maximum lines of errors."""

MOST_WARNINGS = 20
"""Maximum number of warnings about a program's source."""

TYPED = ""
"""The name of what was typed: its places are lines."""

MOST_BARE = 2000
"""Maximum number of characters of a text that may be one frame which lacks its header, or its length."""

OFTEN = 0.05
"""Seconds between two steps of what takes long."""

FIRST = 0.3
"""Seconds until a first part of the answer; the next ones come after twice the time of the one before."""

LESSON = "lesson"
FORMS: dict[str, Callable[[Message, str], str]] = {
    LESSON: lambda message, _: as_hex(message),
    "hex": lambda message, _: spaced_hex(message.build()),
    "javascript": lambda message, name: (
        f"const {name} = new Uint8Array([{', '.join(f'0x{byte:02x}' for byte in message.build())}]);"
    ),
    "c": as_c,
    "python": as_python,
    "operations": lambda message, _: "\n".join(list(assembly(Exchange(message), "", LEGO))[1:]),
}

Steps = Iterator[dict[str, Any]]
"""What takes long, step by step: `part` and `count` of what was read so far, or an `answer`; the last one is final."""


class Input:
    """One input, and what is shown of it."""

    def __init__(self, wanted: Filter | None = None) -> None:
        self._wanted = wanted
        self.image: bytes | None = None
        self._pages = Pages()
        self._findings = Findings()
        self._problems: list[Problem] = []
        self._problem_count = 0
        self._typed: str | None = None
        self._name = TYPED
        self._again: Callable[[], Given] = lambda: Given(TYPED, lines=())
        self._bare: Headline | None = None
        self._mended: Proposal | None = None
        self._first: Record | None = None
        self._seen = self._objects = 0
        self._is_program = False
        self._frames: list[bytes] = []
        self._lesson: list[str] = []
        self._lesson_size = 0
        self._commands: list[bytes] = []
        self._command_count = 0
        self._reading = Reading([], Options())
        self._done: Callable[[], float] = lambda: self._reading.progress or 0.0

    # Reading

    def type(self, text: str) -> Steps:
        """Reads what was typed or pasted."""
        self._typed = text
        self._again = lambda: Given(TYPED, lines=text.splitlines(keepends=True))
        # A single operation may look like bytes, too: INFO(GET_VOLUME, GV0(0)).
        is_source = is_assembly(text.strip())
        pieces = [] if is_source or len(text) > MOST_BARE else list(read_text(text.splitlines()))
        if OBJECT.search(text):
            self._program_of(text, TYPED)
        elif len(text) <= MOST_BARE and (found := bare(text, pieces)) is not None:
            self._bare, self._mended = found
        elif text.strip():
            is_word = "\n" not in text.strip() and not is_source and len(pieces) < 2
            word = Given(TYPED, word=text.strip(), is_name=False)
            yield from self._read(word if is_word else Given(TYPED, lines=self._counted(text)))
        yield {"answer": self.answer()}

    def open(self, path: Path) -> Steps:
        """Reads a file."""
        self._name = path.name
        self._again = lambda: Given(path.name, path, lambda: path.open("rb"))
        yield from self._read(self._again())
        yield {"answer": self.answer()}

    def _read(self, given: Given) -> Steps:
        """Reads, and tells now and then how far it is and what was found."""
        self._reading = Reading([given], Options(raises=False))
        begun = said = time.monotonic()
        due = FIRST
        for event in self._matching():
            if event is not None:
                self._take(event)
            now = time.monotonic()
            if now - said < OFTEN:
                continue
            step: dict[str, Any] = {"part": self._done(), "count": self._pages.frames}
            if now - begun > due:
                due *= 2
                step["answer"] = self.answer(is_whole=False)
            yield step
            said = time.monotonic()

    def _counted(self, text: str) -> Iterator[str]:
        """Yields the lines of a text, and counts what was read of it."""
        done = 0
        self._done = lambda: done / len(text)
        for line in text.splitlines(keepends=True):
            done += len(line)
            yield line

    def _matching(self) -> Iterator[Event | None]:
        """Yields what is read; with a filter matching records, and None for others, so that time can be measured."""
        if self._wanted is None:
            yield from self._reading.events()
            return
        choosing, is_begun, is_empty = Choosing(self._wanted), False, True
        for event in self._reading.events():
            if not isinstance(event, Record):
                yield None if isinstance(event, Announcement) else event
                continue
            self._seen += 1
            if not is_begun:
                is_begun = True
                self._wanted.begin(self._reading.part.account.first_ns or event.time_ns)
            for record in choosing.take(event):
                is_empty = False
                yield record
            yield None
        for record in choosing.end():
            is_empty = False
            yield record
        if is_empty:
            yield self._reading.part.nothing(self._wanted)

    def _take(self, event: Event) -> None:
        """Takes something that was read."""
        if isinstance(event, Record):
            self._record(event)
        elif isinstance(event, Announcement):
            self._show(event)
        elif isinstance(event, Image):
            self._image(event)
        elif isinstance(event, Source):
            self._source(event)
        elif isinstance(event, Problem):
            self._problem(event)

    def _show(self, item: Record | Announcement | Image) -> int:
        """Takes what has lines. Returns its number."""
        if isinstance(item, Record):
            self._first = self._first or item
        self._pages.start_ns = self._reading.part.account.first_ns or 0
        return self._pages.add(item)

    def _record(self, record: Record) -> None:
        written, number = record.written, self._show(record)
        if written is None:
            self._frame(record, number, str(record.place), 0, carrier=str(record.carrier))
        elif not record.missing and not (written.is_typed and self._problems):
            self._frame(record, number, "" if written.is_typed else str(record.place), record.number)

    def _source(self, source: Source) -> None:
        """Reads assembly, or the source of a program."""
        if source.kind is SourceKind.PROGRAM:
            self._program_of(source.text, source.place.name)
            return
        made = list(assembled(source))
        records = [item for item in made if isinstance(item, Record)]
        for number, record in enumerate(records, 1):
            self._frame(record, self._show(record), f"frame {number}" if len(records) > 1 else "", 0)
        for item in made:
            if isinstance(item, Problem):
                self._problem(item)

    def _program_of(self, text: str | bytes, label: str) -> None:
        """Reads the source of a program."""
        self._is_program = True
        try:
            made = assemble(text)
        except AssemblyError as error:
            for one in (error, *error.others):
                self._problem(Problem.in_source(label, one))
            return
        warnings = [str(Problem.in_source(label, one)) for one in made.warnings[:MOST_WARNINGS]]
        more = len(made.warnings) - len(warnings)
        for said in [*warnings, *([f"... and {more} more warnings"] if more else [])]:
            self._findings.say(said, Severity.WARNING)
        self._image(Image(made.image, Place(label)))

    def _image(self, image: Image) -> None:
        """Takes the image of a program."""
        self.image = image.data
        with suppress(DecodeError):  # which is among the findings
            self._objects = len(parse_program(image.data, strict=False).objects)
            self._show(image)
        self._findings.programs.append(check_program(image.data))

    def _problem(self, problem: Problem) -> None:
        if problem.severity is not Severity.ERROR:
            self._findings.say(str(problem), problem.severity)
            return
        place = problem.place
        is_other = problem.code is ProblemCode.TEXT and place.column == 1 and place.line is None
        if self._typed is not None and (is_other or problem.code is ProblemCode.EMPTY):
            return  # the headline says that the text has no frame
        self._problem_count += 1
        if len(self._problems) < MOST_COMPLAINTS:
            self._problems.append(problem)

    def _frame(self, record: Record, number: int, place: str, line: int, *, carrier: str | None = None) -> None:
        """Takes a frame, which has a number on the pages."""
        message, frame = record.message, record.frame
        if message.type is not None and message.type.is_command:
            self._command_count += 1
            if len(self._commands) < MOST_SENT:
                self._commands.append(frame)
        if self._lesson_size < MOST_SHOWN:
            self._frames.append(frame)
            self._lesson.append(as_hex(message))
            self._lesson_size += len(self._lesson[-1]) + 1
        if _is_reply(record):
            self._findings.reply(record, f"{place}: " if place else "")
        else:
            self._findings.frame(frame, number, place, line, carrier=carrier)

    # The answer

    def answer(self, *, is_whole: bool = True) -> dict[str, Any]:
        """Returns what is shown, for JSON.

        headline   see `headline`
        error      sentences about what cannot be read, with the lines of a source that they are about
        count      the number of frames
        isProgram  whether it is a program
        findings   see `Findings.answer`
        found      the frames with findings, in hex, by number
        made       the frames in the lesson's notation, and if they are few, in all
        dialogues  their number
        lines, frames, rows, page  the first page: see `Pages.page`
        """
        is_few = is_whole and len(self._frames) <= FEW and self.image is None
        return {
            "headline": headline(self._headline()),
            "error": self._error(),
            "count": self._pages.frames,
            "isProgram": self.image is not None,
            "findings": self._findings.answer(),
            "found": {each.number: each.report.frame.hex() for each in self._findings.frames},
            "made": {form: self.made(form) for form in (FORMS if is_few else (LESSON,))},
            "dialogues": 0 if self._pages.frames == 1 and self._reading.part.is_text else self._pages.dialogues,
            **self.page(0),
        }

    def _headline(self) -> Headline:
        findings, count, unread, first = self._findings, self._pages.frames, self._problem_count, self._first
        if self._bare is not None:
            return self._bare
        if self.image is not None:
            (report,) = findings.programs
            return Headline(Subject.PROGRAM, self._objects, unread=unread, read=len(self.image), worst=report)
        worst = min(findings.frames, key=lambda each: each.report.accepted, default=None)
        errors = findings.count(Severity.ERROR)
        return Headline(
            self._subject(),
            count,
            findings.checked,
            findings.refused,
            errors - findings.refused,
            findings.count(Severity.WARNING),
            findings.failed,
            findings.faulty,
            unread,
            self._seen,
            first.exchange if first is not None and count == 1 else None,
            first.missing if first is not None else 0,
            len(first.rest) if first is not None else 0,
            None if worst is None else worst.report,
            "" if worst is None else worst.place.removeprefix(f"{self._name}, "),
        )

    def _subject(self) -> Subject:
        """Returns what an input is that is not a program."""
        first = self._first
        if first is None and any(problem.code is ProblemCode.SOURCE for problem in self._problems):
            return Subject.SOURCE if self._is_program else Subject.MISTAKEN
        if first is None:
            return Subject.FILE if self._typed is None else Subject.TEXT if self._typed.strip() else Subject.EMPTY
        if self._pages.frames == 1 and first.written is not None and first.written.is_typed and self._problems:
            return Subject.PART
        if self._pages.frames == 1 and self._wanted is None:
            return Subject.REPLY if _is_reply(first) else Subject.FRAME
        if not self._reading.part.is_text:
            return Subject.CAPTURE
        return Subject.FRAMES if first.place.frame else Subject.LOG

    def page(self, number: int) -> dict[str, Any]:
        """Returns the page that has a frame, by its number: see `Pages.page`."""
        return self._pages.page(number)

    def _error(self) -> str:
        lines: list[str] = []
        for problem in self._problems:
            lines += [str(problem), *(f"  {line}" for line in problem.excerpt.split("\n") if problem.excerpt)]
        left = self._problem_count - len(self._problems) + max(len(lines) - MOST_COMPLAINTS, 0)
        shown = [*lines[:MOST_COMPLAINTS], *([f"... and {left} more lines"] if left else [])]
        return "".join(f"{visible(line)}\n" for line in shown)

    def made(self, form: str) -> str:
        """Returns the frames in a notation, as far as they are shown."""
        if form == LESSON:
            return _shortened(self._lesson, self._pages.frames)
        found: list[str] = []
        size = 0
        for number, frame in enumerate(self._frames, 1):
            name = f"frame_{number}" if self._pages.frames > 1 else "frame"
            found.append(FORMS[form](parse(frame, strict=False), name))
            size += len(found[-1]) + 1
            if size > MOST_SHOWN:
                break
        return _shortened(found, self._pages.frames)

    # What was meant

    def proposals(self) -> list[dict[str, str]]:
        """Returns what can be done about the input, for JSON: the label of each button, and the text that it makes."""
        text = self._typed
        if not text or self.image is not None or self._pages.frames > FEW:
            return []
        if self._mended is not None:
            found = [self._mended]
        else:
            found = proposals(text, self._wrong(), [] if self._first is not None else self._problems)
        has_lines = "\n" in text.strip()
        return [{"label": label(each, has_lines=has_lines), "text": each.text} for each in found]

    def _wrong(self) -> dict[int, bytes | None]:
        """Returns the lines of a text that are wrong, each with the frame in it, if there is one."""
        unread = [problem.place.line or 1 for problem in self._problems if problem.code is ProblemCode.TEXT]
        found: dict[int, bytes | None] = {each.line or 1: each.report.frame for each in self._findings.frames}
        return found | dict.fromkeys(unread or ([] if self._first is not None else [1]))

    # The timeline

    def timeline(self) -> Steps:
        """Reads the input again. The answer is a chart of it as JSON, for Vega-Lite, or None."""
        reading = Reading([self._again()], Options(sources=Sources.NO, images=False, raises=False))
        events = (event for event in reading.events() if isinstance(event, Record | Announcement | Skipped))
        collecting = collect_in_steps(events, most_marks=MOST_MARKS)
        said = time.monotonic()
        while True:
            try:
                next(collecting)
            except StopIteration as end:
                drawn: Timeline | None = end.value
                break
            if time.monotonic() - said > OFTEN:
                yield {"part": reading.progress or 0.0, "count": reading.part.account.frames}
                said = time.monotonic()
        yield {"answer": None if drawn is None else render(drawn, Form.JSON, self._name).decode()}

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


def _is_reply(record: Record) -> bool:
    """Returns whether a frame is from the brick: one whose direction the text does not say is what its type says."""
    kind = record.message.type
    is_silent = record.written is not None and record.written.direction is None
    return kind is not None and not kind.is_command if is_silent else record.is_from_brick


def _shortened(found: list[str], count: int) -> str:
    """Joins frames in a notation, with a last line if there are more."""
    if len(found) == count or not found:
        return "\n".join(found)
    return "\n".join([*found, f"... and {count - len(found)} more frames; ev3proto on the command line shows all"])
