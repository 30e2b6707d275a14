"""The one way in: what the words of a command line name, as one stream of frames, captures and programs.

A frame on the command line needs no part that reads captures, so those are imported for the first file.
"""

from __future__ import annotations

import errno
import os
import re
import zlib
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import chain
from typing import TYPE_CHECKING, NamedTuple, TypeAlias, cast

import click

from ev3proto.cli.kinds import Contents, Kind, introduction, recognized
from ev3proto.cli.output import complain, progress_bar
from ev3proto.cli.reading import BUILTIN, HOW_FRAMES_ARE_WRITTEN, CaptureOptions, pieces
from ev3proto.cli.words import Source
from ev3proto.messages import Message
from ev3proto.tables.program import MAX_IMAGE
from ev3proto.text.paste import Pasted, read_argument
from ev3proto.text.splitting import split

if TYPE_CHECKING:
    from ev3proto.cli.captures import CaptureSource

SOURCE_SUFFIX = ".lms"
"""The suffix of the sources of programs."""

_HOW_FRAMES_ARE_MADE = "`ev3proto encode` makes frames of it"
_AN_IMAGE = "this is a program image (.rbf); `ev3proto decode` shows it"
_AT_START = "column 1: "
_HAS_BYTES = r"(?:(?<!\w)(?:0x|\\x)?[0-9a-fA-F]{2,8}[\s:,-]{1,3}){4}"
"""Bytes in hex, which need no advice on how to write frames."""

# What is read


class Frame(NamedTuple):
    """A message of a text.

    source  the word or file that it is in
    pasted  the piece of text that it is in; None for assembly and JSON
    number  its number in its text, if that is assembly or JSON
    start   the offset of its frame in the bytes of the piece
    rest    the bytes behind it that have no meaning
    """

    message: Message
    source: Source
    pasted: Pasted | None = None
    number: int = 0
    start: int = 0
    rest: bytes = b""

    @property
    def place(self) -> str:
        """The start of a message about it."""
        return f"{self.source.label}, frame {self.number}" if self.pasted is None else self.source.where(self.pasted)

    @property
    def is_from_brick(self) -> bool:
        """Whether it is a reply: by its text, or else, unless it was typed as bytes, by its type."""
        direction = None if self.pasted is None else self.pasted.direction
        if direction is not None or (self.pasted is not None and self.source.is_frame):
            return direction == "received"
        return self.message.type is not None and not self.message.type.is_command

    @property
    def is_cut(self) -> bool:
        """Whether the text says that the frame had more bytes."""
        if self.pasted is None or not self.pasted.cut:
            return False
        fault = self.message.fault
        return fault is not None and fault.truncated


class Whole(NamedTuple):
    """A file that is taken whole: the image of a program, its source, or a text that is printed with changes."""

    kind: Kind
    source: Source
    data: bytes


Content: TypeAlias = "Frame | CaptureSource | Whole"
Making = Callable[["Inputs", Source, Iterable[str]], Iterator[Message]]
"""Makes messages of a text that has no bytes yet: of assembly, of JSON."""


class Takes(NamedTuple):
    """What a subcommand takes besides frames and captures, and how it speaks of that.

    wanted       the name of what it looks for in captures; empty if it takes only captures, and says what is missing
    nothing      the message about a source in which it finds nothing; None for one with advice
    argument     what a word can be besides a file
    accepted     what can be read, for messages about anything else
    making       finds out from the first line of a text what makes messages of it; None: nothing does
    makes_first  a word is what `making` says before it is bytes
    programs     takes images of programs
    sources      takes sources of programs
    edits        takes texts whole, up to this number of bytes and one more; 0: line by line
    as_capture   reads the frames of a text as a capture, with their replies and times
    is_quiet     prints nothing while it reads, so that a progress bar may be drawn
    """

    wanted: str = "frame"
    nothing: str | None = None
    argument: str = "nor a frame"
    accepted: str = "captures are pcap, pcapng or btsnoop files, packed with gzip or not"
    making: Callable[[str], Making | None] | None = None
    makes_first: bool = False
    programs: bool = False
    sources: bool = False
    edits: int = 0
    as_capture: bool = False
    is_quiet: bool = False


ONLY_CAPTURES = Takes(wanted="", as_capture=True, is_quiet=True)
"""For subcommands that look at captures as a whole."""


def looks_like_assembly(line: str) -> bool:
    """Whether a line without a frame is assembly; one with only a label may be a heading."""
    from ev3proto.text.assembly.recognising import is_assembly  # takes 19 ms, which frames do not need

    return not line.rstrip().endswith(":") and is_assembly(line)


class Inputs:
    """Reads the words of a command line one by one, and reports what is unreadable.

    sources   what is read
    at_fault  whether anything was reported
    progress  returns the part of the current file that was read, 0 to 1; None if its size is unknown
    """

    def __init__(
        self,
        sources: Sequence[Source],
        reading: CaptureOptions,
        takes: Takes,
        heard: Callable[[str], object] = lambda _: None,
    ) -> None:
        """`heard` is called with each message about wrong input."""
        self._takes = takes
        self.sources = sources
        self.reading = reading
        self.at_fault = False
        self.progress: Callable[[], float | None] = lambda: None
        self._as_capture = self._takes.as_capture or reading.filter is not None
        self._heard = heard
        self._is_empty = True
        self._first_line = ""
        self._units: set[str] = set()

    def __iter__(self) -> Iterator[Content]:
        for source in self.sources:
            self._is_empty, self._first_line = True, ""
            for content in self._contents(source):
                self._is_empty &= isinstance(content, Whole) and content.kind is Kind.TEXT
                yield content
            if self._is_empty:
                self.complain(self._nothing_in(source))

    def captures(self) -> Iterator[CaptureSource]:
        """Yields the captures, for a subcommand that takes nothing else."""
        return cast("Iterator[CaptureSource]", iter(self))

    @property
    def unit(self) -> str:
        """What the numbers of records count: packets, or lines if only texts were read."""
        return "line" if self._units == {"line"} else "packet"

    def complain(self, sentence: str) -> None:
        """Prints a message about wrong input on standard error."""
        complain(sentence)
        self._heard(sentence)
        self.at_fault = True
        self._is_empty = False

    # Words and files

    def _contents(self, source: Source) -> Iterator[Content]:
        """Yields what is in a source, and reports an unreadable one."""
        try:
            if source.is_frame:
                yield from self._word(source)
            elif source.lines is not None:
                yield from self.text(source, source.lines)
            elif self._takes.sources and source.name.lower().endswith(SOURCE_SUFFIX):
                from ev3proto.program.sources import MAX_SOURCE  # takes 50 ms, which frames do not need

                yield Whole(Kind.SOURCE, source, source.read(MAX_SOURCE + 1))
            elif self.reading.engine != BUILTIN:
                yield from self._capture(source, Contents(Kind.CAPTURE))
            else:
                yield from self._file(source)
        except (OSError, EOFError, zlib.error) as error:
            self._unreadable(source, error)

    def _word(self, source: Source) -> Iterator[Content]:
        """Yields the frames in a word of the command line."""
        lines, takes = source.name.split("\n"), self._takes
        if self.reading.missing is not None:
            yield from self.text(source, lines if takes.makes_first else [source.name])
            return
        pasted = None if takes.makes_first else read_argument(source.name)
        if pasted is None or not pasted.data:
            line = "".join([*introduction(iter(lines))][-1:])
            making = None if takes.making is None else takes.making(line.strip())
            if making is not None:
                yield from self._made(making, source, lines)
                return
            if takes.making is None and looks_like_assembly(line):
                self.complain(f"{source.name[:60]!r} is assembly, not a frame; {_HOW_FRAMES_ARE_MADE}")
                return
        pasted = pasted or read_argument(source.name)
        if self._as_capture and pasted.data:
            yield from self._capture(source, Contents(Kind.TEXT, lines=lines))
        else:
            yield from self.pasted(source, pasted)

    def _file(self, source: Source) -> Iterator[Content]:
        """Yields what is in a file. Raises OSError, EOFError or zlib.error."""
        from ev3proto.capture.formats import CaptureFile  # takes 9 ms, which frames do not need

        takes, is_quiet, is_ours = self._takes, self._takes.is_quiet, source.name != "-"
        with (
            progress_bar(source.label, is_quiet=is_quiet) as advance,
            CaptureFile(source.open(advance), is_ours=is_ours) as file,
        ):
            self.progress = lambda: file.progress
            found = recognized(file, source.name, self.reading.dialect, takes.accepted)
            if found.kind is Kind.OTHER:
                self.complain(f"{source.label}: {found.reason}")
            elif found.kind is Kind.PROGRAM and takes.programs:
                yield Whole(Kind.PROGRAM, source, file.contents.read(MAX_IMAGE + 1))
            elif found.kind is Kind.PROGRAM:
                self.complain(f"{source.label}: {_AN_IMAGE}")
            elif found.kind is Kind.CAPTURE or (found.kind is Kind.FRAMES and self._as_capture):
                yield from self._capture(source, found)
            elif found.kind is Kind.FRAMES:
                for pasted in found.frames:
                    yield from self.pasted(source, pasted)
            elif takes.edits and self.reading.missing is None and not self._as_capture:
                yield Whole(Kind.TEXT, source, file.contents.read(takes.edits + 1))
            else:
                yield from self.text(source, found.lines)

    def _capture(self, source: Source, contents: Contents) -> Iterator[Content]:
        """Yields a capture, or a text that is read as one; then reports one in which nothing was found."""
        from ev3proto.cli.captures import CaptureSource  # takes 10 ms, which frames do not need

        capture = CaptureSource(source, self.reading, contents)
        self._units.add(capture.unit)
        yield capture
        if self._takes.wanted and not capture.taken and not capture.status:
            if capture.is_text and self.reading.filter is None and not capture.account.frames:
                self.complain(self._nothing_in(source))
            else:
                matches = " matches the filter" if self.reading.filter else ""
                where = f"{capture.extent}{matches}{capture.passed_over}"
                self.complain(f"{source.label}: no {self._takes.wanted} in {where}")
        self.at_fault |= bool(capture.status)

    # Texts

    def text(self, source: Source, lines: Iterable[str]) -> Iterator[Content]:
        """Yields the frames of a text. Its first line that is neither empty nor a comment decides what it is."""
        noted = self._noted(iter(lines))
        if self.reading.missing is None and self._takes.making is not None:
            first = list(introduction(noted))
            noted = chain(first, noted)
            making = self._takes.making(self._first_line.strip())
            if making is not None:
                yield from self._made(making, source, noted)
                return
        if self._as_capture:
            yield from self._capture(source, Contents(Kind.TEXT, lines=noted))
        else:
            for pasted in pieces(noted, self.reading.missing):
                yield from self.pasted(source, pasted)

    def _made(self, making: Making, source: Source, lines: Iterable[str]) -> Iterator[Frame]:
        """Yields the messages that are made of a text."""
        if self.reading.filter is not None:
            raise click.UsageError(f"--filter is for frames, but {source.label[:60]} has none yet")
        for number, message in enumerate(making(self, source, lines), 1):
            self._is_empty = False
            yield Frame(message, source, number=number)

    def pasted(self, source: Source, pasted: Pasted) -> Iterator[Frame]:
        """Yields the frames in one piece of a text, and reports what is wrong with it."""
        if pasted.problem is not None:
            self._wrong(pasted, pasted.problem, source)
        for note in pasted.notes:
            complain(f"{source.where(pasted)}: {note}")
        for unknown in pasted.unknown:
            if unknown.text:
                where = "" if source.is_frame else f"{source.label}, "
                complain(f"{where}line {unknown.line}, column {unknown.column}: {unknown.text!r} is unknown, read as 0")
        if pasted.data:
            self._is_empty = False
            for message, start, rest in split(pasted.data, dialect=self.reading.dialect):
                yield Frame(message, source, pasted, 0, start, rest)

    def _noted(self, lines: Iterator[str]) -> Iterator[str]:
        """Yields the lines, and keeps the first that is neither empty nor a comment."""
        for line in introduction(lines):
            self._first_line = line
            yield line
        yield from lines

    # Complaints

    def _nothing_in(self, source: Source) -> str:
        """Returns the message about a source without a frame."""
        if self._takes.nothing is not None:
            return f"{source.label}: {self._takes.nothing}"
        if source.name.lower().endswith(SOURCE_SUFFIX):
            more = ", but the source of a program; `ev3proto encode -o FILE.rbf` makes its image"
        elif looks_like_assembly(self._first_line):
            more = f", but assembly; {_HOW_FRAMES_ARE_MADE}"
        elif re.search(_HAS_BYTES, self._first_line):
            more = ""
        else:
            more = HOW_FRAMES_ARE_WRITTEN
        return f"{source.label}: no frame found{more}"

    def _wrong(self, pasted: Pasted, problem: str, source: Source) -> None:
        """Reports a piece of text that is not a complete frame."""
        if not source.is_frame:
            self.complain(f"{source.where(pasted)}: {problem}")
        elif not pasted.data and source.looks_like_a_path:
            self._unreadable(source, FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT)))
        elif not pasted.data:
            rest = problem.removeprefix(_AT_START)
            self.complain(f"{source.where(pasted)} is neither a file {self._takes.argument}: {rest}")
        elif problem.startswith(_AT_START):
            self.complain(problem.removeprefix(_AT_START))
        else:
            self.complain(f"{source.where(pasted)}: {problem}")

    def _unreadable(self, source: Source, error: Exception) -> None:
        self.complain(f"{source.label}: cannot be read: {getattr(error, 'strerror', None) or error}")
