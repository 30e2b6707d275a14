"""What reading yields besides records of frames: programs, sources, and problems with their places."""

from __future__ import annotations

from enum import StrEnum
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from ev3proto.capture.record import Announcement, Place, Record, Skipped
from ev3proto.checking.report import Severity
from ev3proto.semantics.identify import Kind

if TYPE_CHECKING:
    from ev3proto.text.assembly.errors import AssemblyError, SourceWarning


class Image(NamedTuple):
    """The image of a program (.rbf); `ev3proto.program.parse(image.data)` reads it.

    data   its bytes, at most `ev3proto.tables.program.MAX_IMAGE` and one more
    place  the file
    """

    data: bytes
    place: Place


class SourceKind(StrEnum):
    """What is made of a source."""

    FRAMES = "frames"
    PROGRAM = "program"
    TEXT = "text"


class Source(NamedTuple):
    """A text that something is made of.

    `ev3proto.reading.assembled` makes frames of it, or `ev3proto.program.assemble` a program.

    text      of a program's source (.lms) the bytes of the file, of assembly the characters
    place     the file
    kind      what is made of it: frames of assembly, a program; TEXT is any other text that is taken whole
    is_typed  it was given by itself, as on a command line
    """

    text: str | bytes
    place: Place
    kind: SourceKind = SourceKind.FRAMES
    is_typed: bool = False


class ProblemCode(StrEnum):
    """The codes of problems."""

    EMPTY = "empty"  # a source without anything in it
    NO_MATCH = "no-match"  # no frame matches the filter
    KIND = "kind"  # a file that cannot be read, such as a zip archive
    DAMAGED = "damaged"  # a file that cannot be read to its end
    TEXT = "text"  # a piece of a text that was meant as a frame
    UNKNOWN = "unknown-byte"  # a byte that the text does not give, read as zero
    NOTE = "note"  # a remark on how a piece of a text was read
    SKIPPED = "skipped"  # bytes among the frames of a capture
    MEMORY = "memory"  # messages that were dropped at the memory limit
    FAULT = "fault"  # a frame with a fault, as `Faults` says it; reading yields the record alone
    SOURCE = "source"  # an error or a warning in assembly, in a program's source, or in JSON


class Problem(NamedTuple):
    """Something that cannot be read, or is odd.

    place     where it is
    code      its kind
    message   one sentence
    severity  an error is something that was not read; a warning or a hint is read as the sentence says
    excerpt   the line of a source with a mark at the column below it; empty for other problems
    lacks     which part of a frame is missing in front of these bytes; None for other problems
    """

    place: Place
    code: ProblemCode
    message: str
    severity: Severity = Severity.ERROR
    excerpt: str = ""
    lacks: Kind | None = None

    def __str__(self) -> str:
        # A sentence may begin with the quoted text that it is about.
        place = "" if self.message.startswith(self.place.name) and self.place.name else str(self.place)
        return f"{place}: {self.message}" if place else self.message

    @classmethod
    def in_source(cls, name: str, error: AssemblyError | SourceWarning) -> Problem:
        """Returns the problem for an error or a warning of assembly in a file; `name` is empty for a text by itself."""
        place = Place(name, error.line, error.column)
        if not isinstance(error, Exception):
            return cls(place, ProblemCode.SOURCE, error.reason, Severity.WARNING)
        return cls(place, ProblemCode.SOURCE, error.reason, excerpt=error.excerpt if error.text.strip() else "")


Item: TypeAlias = Record | Image | Source | Problem
"""What `ev3proto.read` yields."""

Event: TypeAlias = Item | Announcement | Skipped
"""The same with what is around the frames of a capture."""
