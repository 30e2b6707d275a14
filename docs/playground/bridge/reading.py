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
from ev3proto.errors import DecodeError
from ev3proto.program import assemble, check_program
from ev3proto.program import parse as parse_program
from ev3proto.reading.assembling import assembled
from ev3proto.reading.given import Given
from ev3proto.reading.headline import Headline, Proposal
from ev3proto.reading.items import Event, Image, Problem, ProblemCode, Source, SourceKind
from ev3proto.reading.options import Options, Sources
from ev3proto.reading.parts import Reading
from ev3proto.text.assembly.errors import AssemblyError
from ev3proto.text.assembly.recognising import OBJECT
from ev3proto.text.paste import read_text

from .findings import Findings
from .headline import headline, label
from .notations import FEW, Frames
from .overview import Overview, is_reply
from .pages import Pages
from .proposals import bare, proposals

MOST_WARNINGS = 20
"""Maximum number of warnings about a program's source."""

MOST_BARE = 2000
"""Maximum number of characters of a text that may be one frame which lacks its header, or its length."""

TYPED = ""
"""The name of what was typed: its places are lines."""

MOST_MARKS = 4000
"""Maximum number of marks in the timeline, which the page draws at once; more are counted in bins of time."""

OFTEN = 0.05
"""Seconds between two steps."""

Steps = Iterator[dict[str, Any]]
"""What takes long, in steps: `part` and `count` of what was read so far, or an `answer`; the last one is final."""

FIRST = 0.3
"""Seconds until a first part of the answer; the next ones come after twice the time of the one before."""


class Input:
    """One input, and what is shown of it: its `pages`, and its `frames` in notations and for a brick."""

    def __init__(self, wanted: Filter | None = None) -> None:
        self._wanted = wanted
        self._overview = Overview(is_chosen=wanted is not None)
        self.pages = Pages()
        self._findings = Findings()
        self.frames = Frames()
        self._again: Callable[[], Given] = lambda: Given(TYPED, lines=())
        self._bare: tuple[Headline, Proposal] | None = None
        self._reading = Reading([], Options())
        self._done: Callable[[], float] = lambda: self._reading.progress or 0.0

    # Reading

    def type(self, text: str) -> Steps:
        """Reads what was typed or pasted."""
        self._overview.text = text
        self._again = lambda: Given(TYPED, lines=text.splitlines(keepends=True))
        is_short = len(text) <= MOST_BARE
        pieces = list(read_text(text.splitlines())) if is_short else []
        self._bare = bare(text, pieces) if is_short else None
        if OBJECT.search(text):
            self._program_of(text, TYPED)
        elif self._bare is None and text.strip():
            is_word = "\n" not in text.strip() and len(pieces) < 2
            word = Given(TYPED, word=text.strip(), is_name=False)
            yield from self._read(word if is_word else Given(TYPED, lines=self._counted(text)))
        yield {"answer": self.answer()}

    def open(self, path: Path) -> Steps:
        """Reads a file."""
        self._overview.name = path.name
        self._again = lambda: Given(path.name, path, lambda: path.open("rb"))
        yield from self._read(self._again())
        yield {"answer": self.answer()}

    def timeline(self) -> Steps:
        """Reads the input again. The answer is a chart of it as JSON, for Vega-Lite, or None."""
        reading = Reading([self._again()], Options(sources=Sources.NO, images=False, raises=False))
        events = (event for event in reading.events() if isinstance(event, Record | Announcement | Skipped))
        drawn: list[Timeline | None] = []

        def collecting() -> Iterator[object]:
            drawn.append((yield from collect_in_steps(events, most_marks=MOST_MARKS)))

        said = time.monotonic()
        for _ in collecting():
            if time.monotonic() - said > OFTEN:
                yield {"part": reading.progress or 0.0, "count": reading.part.account.frames}
                said = time.monotonic()
        (chart,) = drawn
        name = self._overview.name or "input"
        yield {"answer": None if chart is None else render(chart, Form.JSON, name).decode()}

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
            step: dict[str, Any] = {"part": self._done(), "count": self.pages.frames}
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
        choosing = Choosing(self._wanted)
        for event in self._reading.events():
            if isinstance(event, Record):
                if not self._overview.seen:
                    self._wanted.begin(self._reading.part.account.first_ns or event.time_ns)
                self._overview.seen += 1
                yield from choosing.take(event)
            yield None if isinstance(event, Announcement | Record) else event
        yield from choosing.end()
        if not self.pages.frames:
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
            self._overview.first = self._overview.first or item
        self.pages.start_ns = self._reading.part.account.first_ns or 0
        return self.pages.add(item)

    def _record(self, record: Record) -> None:
        written, number = record.written, self._show(record)
        if written is None:
            self._frame(record, number, str(record.place), 0, carrier=str(record.carrier))
        elif not record.missing and not (written.is_typed and self._overview.unread):
            self._frame(record, number, "" if written.is_typed else str(record.place), record.number)

    def _frame(self, record: Record, number: int, place: str, line: int, *, carrier: str | None = None) -> None:
        """Takes a frame, which has a number on the pages."""
        self.frames.add(record.message, record.frame)
        if is_reply(record):
            self._findings.reply(record, place)
        else:
            self._findings.frame(record.frame, number, place, line, carrier=carrier)

    def _source(self, source: Source) -> None:
        """Reads assembly, whose values are left to the check, or the source of a program."""
        if source.kind is SourceKind.PROGRAM:
            self._program_of(source.text, source.place.name)
            return
        made = list(assembled(source, unchecked=True))
        records = [item for item in made if isinstance(item, Record)]
        for number, record in enumerate(records, 1):
            self._frame(record, self._show(record), f"frame {number}" if len(records) > 1 else "", 0)
        for item in made:
            if isinstance(item, Problem):
                self._problem(item)

    def _program_of(self, text: str | bytes, name: str) -> None:
        """Reads the source of a program."""
        self._overview.is_source = True
        try:
            made = assemble(text)
        except AssemblyError as error:
            for one in (error, *error.others):
                self._problem(Problem.in_source(name, one))
            return
        for warning in made.warnings[:MOST_WARNINGS]:
            self._findings.say(str(Problem.in_source(name, warning)), Severity.WARNING)
        if (more := len(made.warnings) - MOST_WARNINGS) > 0:
            self._findings.say(f"... and {more} more warnings", Severity.WARNING)
        self._image(Image(made.image, Place(name)))

    def _image(self, image: Image) -> None:
        """Takes the image of a program."""
        self.frames.image = image.data
        with suppress(DecodeError):  # which is among the findings
            self._overview.objects = len(parse_program(image.data, strict=False).objects)
            self._show(image)
        self._findings.program = check_program(image.data)

    def _problem(self, problem: Problem) -> None:
        place = problem.place
        is_other = problem.code is ProblemCode.TEXT and place.column == 1 and place.line is None
        if problem.severity is not Severity.ERROR:
            self._findings.say(str(problem), problem.severity)
        elif self._overview.text is None or not (is_other or problem.code is ProblemCode.EMPTY):
            self._overview.complain(problem)  # else the headline says that the text has no frame

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
        overview, count = self._overview, self.pages.frames
        overview.frames, overview.is_text = count, self._reading.part.is_text
        is_program = self.frames.image is not None
        return {
            "headline": headline(self._bare[0] if self._bare else overview.headline(self._findings)),
            "error": overview.complaints(),
            "count": count,
            "isProgram": is_program,
            "findings": self._findings.answer(),
            "found": {each.number: each.report.frame.hex() for each in self._findings.frames},
            "made": self.frames.all(is_whole=is_whole and not is_program),
            "dialogues": 0 if count == 1 and overview.is_text else self.pages.dialogues,
            **self.pages.page(0),
        }

    def proposals(self) -> list[dict[str, str]]:
        """Returns what can be done about the input, for JSON: the label of each button, and the text that it makes."""
        text = self._overview.text
        if not text or self.frames.image is not None or self.pages.frames > FEW:
            return []
        problems = self._overview.problems if self._overview.first is None else []
        found = [self._bare[1]] if self._bare else proposals(text, self._wrong(), problems)
        has_lines = "\n" in text.strip()
        return [{"label": label(each, has_lines=has_lines), "text": each.text} for each in found]

    def _wrong(self) -> dict[int, bytes | None]:
        """Returns the lines of a text that are wrong, each with the frame in it, if there is one."""
        unread = [problem.place.line or 1 for problem in self._overview.problems if problem.code is ProblemCode.TEXT]
        found: dict[int, bytes | None] = {each.line or 1: each.report.frame for each in self._findings.frames}
        return found | dict.fromkeys(unread or ([] if self._overview.first is not None else [1]))
