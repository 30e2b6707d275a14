"""What was typed or opened: read once, by the reader of `ev3proto decode`, and rendered as far as it is shown."""

from __future__ import annotations

import io
import json
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import redirect_stderr
from pathlib import Path
from typing import Any

from ev3proto.capture.dialogues import RequestReply, dialogues
from ev3proto.capture.record import Event, elapsed
from ev3proto.capture.text_log import read_log
from ev3proto.cli.assembly import assembled_messages
from ev3proto.cli.captures import CaptureSource
from ev3proto.cli.check import is_reply
from ev3proto.cli.decode import Decoding
from ev3proto.cli.inputs import (
    Content,
    Frame,
    Inputs,
    Making,
    Takes,
    Whole,
    looks_like_assembly,
)
from ev3proto.cli.kinds import Kind
from ev3proto.cli.programs import complain_of_source
from ev3proto.cli.reading import CaptureOptions
from ev3proto.cli.recorded import show_capture
from ev3proto.cli.words import Source
from ev3proto.messages import Message
from ev3proto.program import assemble, check_program
from ev3proto.schema.frame import parse
from ev3proto.text.assembly.errors import AssemblyError
from ev3proto.text.assembly.recognising import OBJECT
from ev3proto.text.fixed_text import fix_text
from ev3proto.text.forms import as_c, as_hex, as_python
from ev3proto.text.paste import Pasted, read_argument
from ev3proto.text.phrases import command_spans, reply_spans
from ev3proto.text.spans import plain_text

from .findings import Findings
from .rows import Rows, Showing, shown

MOST_SHOWN = 200_000
"""Maximum characters of each text of an answer."""

MOST_SENT = 100
"""Maximum number of frames sent to a brick at once."""

MOST_DIALOGUES = 1000

FEW = 200
"""Frames whose notations, and dialogues, are in the first answer; those of more are rendered when they are opened."""

MOST_COMPLAINTS = 12
"""Maximum lines of errors."""

OFTEN, SOON, LATE = 0.25, 1.0, 5.0
"""Seconds between two reports of progress; until a first part of the answer if the tree is full, and if it is not."""

FEW_CHARACTERS = 4_000
"""A text up to this length is fixed to find out whether that changes it."""

LESSON = "lesson"
FORMS: dict[str, Callable[[Message, str], str]] = {
    LESSON: lambda message, _: as_hex(message),
    "c": as_c,
    "python": as_python,
}

Publish = Callable[[str], object]
"""Takes a report of progress, or a part of the answer, as JSON."""


class Reading(Decoding):
    """One input, and what is shown of it."""

    def __init__(self, publish: Publish = lambda _: None) -> None:
        self._rows = Rows(MOST_SHOWN)
        self._showing = Showing(self._rows)
        super().__init__(self._showing, Inputs([], CaptureOptions(), Takes()))
        self.image: bytes | None = None
        self._publish = publish
        self._findings = Findings()
        self._errors = io.StringIO()
        self._typed: str | None = None
        self._folder = ""
        self._assembled = 0
        self._frames: list[bytes] = []
        self._lesson: list[str] = []
        self._lesson_size = 0
        self._commands: list[bytes] = []
        self._command_count = 0
        self._log: list[Pasted] = []
        self._pairs: list[RequestReply] = []
        self._pair_count = 0
        self._start_ns = 0
        self._done: Callable[[], float] = lambda: 0.0
        self._begun = self._said = time.monotonic()
        self._next = LATE

    # Reading

    def type(self, text: str) -> None:
        """Reads what was typed or pasted."""
        if not text.strip():
            return
        if OBJECT.search(text):
            self._run(lambda: self._program_of(text, "input"))
            return
        self._typed = text
        if "\n" in text.strip():
            self._read(Source("input", lines=self._counted(text)))
        else:
            self._read(Source(text.strip(), is_frame=True))

    def open(self, path: Path) -> None:
        """Reads a file."""
        self._folder = f"{path.parent}/"
        self._read(Source(str(path)))

    def _read(self, source: Source) -> None:
        takes = Takes(making=self._making, programs=True, sources=True)
        self.inputs = Inputs([source], CaptureOptions(), takes)
        if source.lines is None:
            self._done = lambda: self.inputs.progress() or 0.0
        self._run(self.run)

    def _run(self, read: Callable[[], object]) -> None:
        with redirect_stderr(self._errors):
            read()

    def _counted(self, text: str) -> Iterator[str]:
        """Yields the lines of a text, and counts what was read of it."""
        done = 0
        self._done = lambda: done / len(text)
        for line in text.splitlines(keepends=True):
            done += len(line)
            yield line

    def _making(self, line: str) -> Making | None:
        """Returns what makes messages of a text by its first line: assembly, unless the line has bytes."""
        return self._assembly if looks_like_assembly(line) and not read_argument(line).data else None

    def _assembly(self, inputs: Inputs, source: Source, lines: Iterable[str]) -> Iterator[Message]:
        messages = list(assembled_messages(source, lines, inputs.complain, dialect=inputs.reading.dialect))
        self._assembled = len(messages)
        return iter(messages)

    def take(self, content: Content) -> None:
        """Takes one thing."""
        if isinstance(content, Whole) and content.kind is Kind.SOURCE:
            self._program_of(content.data, content.source.label)
        else:
            super().take(content)

    def _program_of(self, text: str | bytes, label: str) -> None:
        """Reads the source of a program."""
        try:
            made = assemble(text)
        except AssemblyError as error:
            complain_of_source(label, (error, *error.others))
            return
        with redirect_stderr(io.StringIO()) as warnings:
            complain_of_source(label, made.warnings)
        self._findings.warn(warnings.getvalue())
        self.program(Source(label), made.image)

    def program(self, source: Source, image: bytes) -> None:
        """Takes the image of a program."""
        super().program(source, image)
        self.image = image
        self._findings.program(check_program(image))

    def frame(self, frame: Frame) -> None:
        """Takes a frame of a text, or of assembly."""
        super().frame(frame)
        pasted, message = frame.pasted, frame.message
        if pasted is None:
            self._take(message, message.build(), f"frame {frame.number}" if self._assembled > 1 else "", 0)
            return
        if len(self._log) < MOST_DIALOGUES * 2 and (not self._log or self._log[-1] is not pasted):
            self._log.append(pasted)
        if frame.is_cut:
            return
        place = "" if frame.source.is_frame else frame.place
        self._take(message, message.build(), place, pasted.line, is_reply=frame.is_from_brick)

    def capture(self, capture: CaptureSource) -> None:
        """Takes the frames of a capture."""
        before = self._showing.count
        for pair in dialogues(self._records(capture)):
            self._pair_count += 1
            if len(self._pairs) < MOST_DIALOGUES:
                self._pairs.append(pair)
        capture.taken = self._showing.count - before

    def _records(self, capture: CaptureSource) -> Iterator[Event]:
        for record in show_capture(self._showing, capture, as_dialogues=False):
            self._start_ns = capture.account.first_ns or 0
            place = capture.where(record.number)
            message = record.message
            if message.fault is not None:
                self.inputs.complain(f"{place}: fault at {message.fault}")
            self._take(message, record.frame, place, 0, is_reply=is_reply(record), carrier=capture.carrier(record))
            yield record

    def _take(
        self,
        message: Message,
        frame: bytes,
        place: str,
        line: int,
        *,
        is_reply: bool = False,
        carrier: str | None = None,
    ) -> None:
        """Takes a frame, which was shown."""
        if message.type is not None and message.type.is_command:
            self._command_count += 1
            if len(self._commands) < MOST_SENT:
                self._commands.append(frame)
        if self._lesson_size < MOST_SHOWN:
            self._frames.append(frame)
            self._lesson.append(as_hex(message))
            self._lesson_size += len(self._lesson[-1]) + 1
        if is_reply:
            self._findings.reply()
        else:
            self._findings.frame(frame, self._showing.number, place, line, carrier=carrier)
        self._breathe()

    def _breathe(self) -> None:
        """Reports progress, and now and then a part of the answer."""
        now = time.monotonic()
        if now - self._said < OFTEN:
            return
        self._said = now
        self._publish(json.dumps({"part": self._done(), "count": self._showing.number + 1}))
        is_first = self._rows.is_full and self._next == LATE
        if now - self._begun > (SOON if is_first else self._next):
            self._next *= 2
            self._publish(json.dumps({"answer": self.answer(is_whole=False)}))

    # The answer

    def answer(self, *, is_whole: bool = True) -> dict[str, Any]:
        """Returns what is shown, for JSON.

        error      sentences
        count      the number of frames
        isProgram  whether it is a program
        lines      of the tree, each with its pieces, the number of its frame (-1 for none), offset and number of bytes
        frames     in hex, by number
        findings   see `Findings.answer`
        isFixable  whether a fix would change the text
        made       the frames in the lesson's notation, and if they are few, in all
        dialogues  their number, and the first ones, each with time, command, reply, latency
        """
        rows, findings = shown(self._rows), self._findings.answer()
        frames = self._showing.frames | {each.number: each.report.frame for each in self._findings.frames}
        is_few = is_whole and len(self._frames) <= FEW and self.image is None
        if is_whole and self._log and len(self._log) <= FEW:
            self._pair()
        return {
            "error": self._error(),
            "count": self._showing.number + 1,
            "isProgram": self.image is not None,
            "lines": rows,
            "frames": {number: frame.hex() for number, frame in frames.items()},
            "findings": findings,
            "isFixable": is_whole and self._is_fixable(),
            "made": {form: self.made(form) for form in (FORMS if is_few else (LESSON,))},
            "dialogues": {"count": self._dialogue_count(), "rows": self.dialogue_rows(FEW)},
        }

    def _error(self) -> str:
        text = self._errors.getvalue()
        lines = (text.replace(self._folder, "") if self._folder else text).splitlines(keepends=True)
        left = len(lines) - MOST_COMPLAINTS
        return "".join([*lines[:MOST_COMPLAINTS], *([f"... and {left} more lines\n"] if left > 0 else [])])

    def made(self, form: str) -> str:
        """Returns the frames in a notation, as far as they are shown."""
        if form == LESSON:
            return _shortened(self._lesson, self._showing.number + 1)
        found: list[str] = []
        size = 0
        for number, frame in enumerate(self._frames, 1):
            found.append(FORMS[form](parse(frame, strict=False), f"frame_{number}"))
            size += len(found[-1]) + 1
            if size > MOST_SHOWN:
                break
        return _shortened(found, self._showing.number + 1)

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
        """Returns the number of dialogues; for a text that is not paired yet, about that many."""
        return self._pair_count or (len(self._log) if len(self._log) > 1 else 0)

    def _pair(self) -> None:
        """Pairs the frames of a text."""
        if self._pairs or len(self._log) < 2:
            return
        log = read_log(self._log)
        self._pairs = list(dialogues(log.events()))[:MOST_DIALOGUES]
        self._pair_count, self._start_ns = len(self._pairs), log.account.first_ns or 0

    def dialogue_rows(self, most: int) -> list[list[str]]:
        """Returns dialogues that are paired: time, command, reply, latency of each."""
        return [self._dialogue_row(pair) for pair in self._pairs[:most]]

    def all_dialogue_rows(self) -> list[list[str]]:
        """Returns as many dialogues as are shown."""
        self._pair()
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
