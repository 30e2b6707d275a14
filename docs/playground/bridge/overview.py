"""What an input is, in the facts that its headline says, and what cannot be read of it."""

from __future__ import annotations

from ev3proto.capture.record import Record
from ev3proto.checking.report import Severity
from ev3proto.messages import Message
from ev3proto.reading.headline import NOTHING, Headline, Subject
from ev3proto.reading.items import Problem, ProblemCode
from ev3proto.text.spans import visible

from .findings import Findings

MOST_COMPLAINTS = 12
"""Maximum lines of errors."""


class Overview:
    """The facts about an input, as it is read.

    text       what was typed; None for a file
    name       of the file
    is_chosen  whether a filter chooses frames
    is_text    whether it is a text, and not a capture
    is_source  whether it is the source of a program
    frames     the number of frames, or of programs
    seen       the frames among which a filter chose
    objects    the number of those of a program
    first      the first frame
    unread     the number of problems, each of which kept a piece from being read
    problems   the first ones
    """

    def __init__(self, *, is_chosen: bool) -> None:
        self.text: str | None = None
        self.name = ""
        self.is_chosen = is_chosen
        self.is_text, self.is_source = True, False
        self.frames = self.seen = self.objects = 0
        self.first: Record | None = None
        self.unread = 0
        self.problems: list[Problem] = []

    def complain(self, problem: Problem) -> None:
        """Takes what cannot be read."""
        self.unread += 1
        if len(self.problems) < MOST_COMPLAINTS:
            self.problems.append(problem)

    def complaints(self) -> str:
        """Returns what cannot be read in sentences, with the lines of a source that they are about."""
        lines: list[str] = []
        for problem in self.problems:
            lines += [str(problem), *(f"  {line}" for line in problem.excerpt.split("\n") if problem.excerpt)]
        left = self.unread - len(self.problems) + max(len(lines) - MOST_COMPLAINTS, 0)
        shown = [*lines[:MOST_COMPLAINTS], *([f"... and {left} more lines"] if left else [])]
        return "".join(f"{visible(line)}\n" for line in shown)

    def headline(self, findings: Findings) -> Headline:
        """Returns what is said first, with what was found."""
        first, report = self.first, findings.program
        if report is not None:
            return Headline(Subject.PROGRAM, self.objects, unread=self.unread, read=len(report.frame), worst=report)
        worst = min(findings.frames, key=lambda each: each.report.accepted, default=None)
        return Headline(
            self._without_frame() if first is None else self._subject(first),
            self.frames,
            findings.checked,
            findings.refused,
            findings.count[Severity.ERROR] - findings.refused,
            findings.count[Severity.WARNING],
            findings.failed,
            findings.faulty,
            self.unread,
            self.seen,
            first.exchange if first is not None and self.frames == 1 else NOTHING,
            0 if first is None else first.missing,
            0 if first is None else len(first.rest),
            None if worst is None else worst.report,
            "" if worst is None else worst.place.removeprefix(f"{self.name}, "),
        )

    def _without_frame(self) -> Subject:
        if any(problem.code is ProblemCode.SOURCE for problem in self.problems):
            return Subject.SOURCE if self.is_source else Subject.MISTAKEN
        if self.text is None:
            return Subject.FILE
        return Subject.TEXT if self.text.strip() else Subject.EMPTY

    def _subject(self, first: Record) -> Subject:
        """Returns what an input with frames is; a frame is one if it is the only one."""
        if self.frames == 1 and self.unread and first.written is not None and first.written.is_typed:
            return Subject.PART
        if self.frames == 1 and not self.is_chosen:
            return Subject.REPLY if is_reply(first) else Subject.FRAME
        if not self.is_text:
            return Subject.CAPTURE
        return Subject.FRAMES if first.place.frame else Subject.LOG


def is_reply(record: Record) -> bool:
    """Returns whether a frame is from the brick: one whose direction the text does not say is what its type says."""
    is_silent = record.written is not None and record.written.direction is None
    return is_answer(record.message) if is_silent else record.is_from_brick


def is_answer(message: Message) -> bool:
    """Returns whether a message is a reply by its type."""
    return message.type is not None and not message.type.is_command
