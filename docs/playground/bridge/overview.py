"""What an input is, in the facts that its headline says."""

from __future__ import annotations

from ev3proto.capture.record import Record
from ev3proto.checking.report import Severity
from ev3proto.reading.headline import Headline, Subject

from .complaints import Complaints
from .findings import Findings


class Overview:
    """The facts about an input, as it is read.

    text       what was typed; None for a file
    name       of the file
    is_chosen  whether a filter chooses frames
    is_text    whether it is a text, and not a capture
    is_source  whether it is the source of a program
    frames     the number of frames, or of programs
    seen       the frames among which a filter chose
    image      of the program
    objects    the number of those of the program
    first      the first frame
    """

    def __init__(self, *, is_chosen: bool) -> None:
        self.text: str | None = None
        self.name = ""
        self.is_chosen = is_chosen
        self.is_text, self.is_source = True, False
        self.frames = self.seen = self.objects = 0
        self.image: bytes | None = None
        self.first: Record | None = None

    def headline(self, findings: Findings, complaints: Complaints) -> Headline:
        """Returns what is said first, with what was found and cannot be read."""
        first, unread = self.first, complaints.count
        if self.image is not None:
            (report,) = findings.programs
            return Headline(Subject.PROGRAM, self.objects, unread=unread, read=len(self.image), worst=report)
        worst = min(findings.frames, key=lambda each: each.report.accepted, default=None)
        return Headline(
            self._without_frame(complaints) if first is None else self._subject(first, unread),
            self.frames,
            findings.checked,
            findings.refused,
            findings.count(Severity.ERROR) - findings.refused,
            findings.count(Severity.WARNING),
            findings.failed,
            findings.faulty,
            unread,
            self.seen,
            first.exchange if first is not None and self.frames == 1 else None,
            0 if first is None else first.missing,
            0 if first is None else len(first.rest),
            None if worst is None else worst.report,
            "" if worst is None else worst.place.removeprefix(f"{self.name}, "),
        )

    def _without_frame(self, complaints: Complaints) -> Subject:
        if complaints.is_of_source:
            return Subject.SOURCE if self.is_source else Subject.MISTAKEN
        if self.text is None:
            return Subject.FILE
        return Subject.TEXT if self.text.strip() else Subject.EMPTY

    def _subject(self, first: Record, unread: int) -> Subject:
        """Returns what an input with frames is; a frame is one if it is the only one."""
        if self.frames == 1 and unread and first.written is not None and first.written.is_typed:
            return Subject.PART
        if self.frames == 1 and not self.is_chosen:
            return Subject.REPLY if is_reply(first) else Subject.FRAME
        if not self.is_text:
            return Subject.CAPTURE
        return Subject.FRAMES if first.place.frame else Subject.LOG


def is_reply(record: Record) -> bool:
    """Returns whether a frame is from the brick: one whose direction the text does not say is what its type says."""
    kind = record.message.type
    is_silent = record.written is not None and record.written.direction is None
    return kind is not None and not kind.is_command if is_silent else record.is_from_brick
