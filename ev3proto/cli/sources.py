"""Reading the sources of subcommands that take frames: arguments, texts, captures, standard input."""

from __future__ import annotations

import errno
import os
import re
import zlib
from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from ev3proto.cli.inputs import (
    CAPTURES,
    HOW_FRAMES_ARE_WRITTEN,
    NOT_A_CAPTURE,
    SOURCE_SUFFIX,
    Input,
    Kind,
    Source,
    introduction,
    pieces,
    recognized,
)
from ev3proto.cli.output import advancing, complain, progress_bar
from ev3proto.cli.reading import BUILTIN, CaptureOptions
from ev3proto.tables.program import MAX_IMAGE
from ev3proto.text.paste import Pasted, read_argument
from ev3proto.text.splitting import Piece, split

if TYPE_CHECKING:
    from ev3proto.capture.formats import CaptureFile
    from ev3proto.cli.captures import CaptureSource

_AT_START = "column 1: "
_HAS_BYTES = re.compile(r"(?:(?<!\w)(?:0x|\\x)?[0-9a-fA-F]{2,8}[\s:,-]{1,3}){4}")
"""Bytes in hex, which need no advice on how to write frames."""
_HOW_FRAMES_ARE_MADE = "`ev3proto encode` makes frames of it"


def looks_like_assembly(line: str) -> bool:
    """Whether a line without a frame is assembly; one with only a label may be a heading."""
    from ev3proto.text.assembly.recognising import is_assembly  # takes 11 ms, which frames do not need

    return not line.rstrip().endswith(":") and is_assembly(line)


class SourceReader(ABC):
    """Reads sources one by one, reports what is unreadable, and remembers whether any source was at fault.

    A subclass decides what to do with the frames of texts and captures.
    """

    wanted = "frame"
    """The name of what is looked for in captures, for messages."""

    arguments = "nor a frame"
    """What an argument can be besides a file, for messages."""

    accepted = CAPTURES
    """What can be read, for messages about anything else."""

    is_quiet = False
    """Whether nothing is printed while a capture is read, so that a progress bar may be drawn."""

    def __init__(self, reading: CaptureOptions) -> None:
        self.reading = reading
        self.at_fault = False
        self._is_empty = True
        self._first_line = ""

    @abstractmethod
    def piece(self, piece: Piece, pasted: Pasted, source: Source) -> None:
        """Takes one frame of a text."""

    @abstractmethod
    def capture(self, capture: CaptureSource) -> int:
        """Takes the events of a capture.

        Returns:
            The number of events of the wanted kind.
        """

    @property
    def wants_records(self) -> bool:
        """Whether the frames of a text are read as a capture, with their replies and times."""
        return self.reading.filter is not None

    def argument(self, source: Source) -> None:
        """Takes a frame that was typed on the command line."""
        if self.reading.missing is not None:
            self.text(source, iter([source.name]))
            return
        pasted = read_argument(source.name)
        if not pasted.data and looks_like_assembly(source.name):
            self.assembly(source, iter(source.name.split("\n")))
        else:
            self.pasted(pasted, source)

    def assembly(self, source: Source, lines: Iterator[str]) -> None:  # noqa: ARG002 - for those that read it
        """Takes assembly that was typed on the command line; unless overridden, suggests `encode`."""
        self.complain(f"{source.name[:60]!r} is assembly, not a frame; {_HOW_FRAMES_ARE_MADE}")

    def text(self, source: Source, lines: Iterator[str]) -> None:
        """Takes the lines of a text."""
        for pasted in pieces(self._noting_the_first(lines), self.reading.missing):
            self.pasted(pasted, source)

    def read_all(self, found: Sequence[Source]) -> None:
        """Reads everything in all sources, and reports each without a frame."""
        for source in found:
            self._is_empty, self._first_line = True, ""
            self.read(source)
            if self._is_empty:
                self.complain(self._nothing_in(source))

    def _nothing_in(self, source: Source) -> str:
        """Returns the message about a source without a frame."""
        if source.name.lower().endswith(SOURCE_SUFFIX):
            more = ", but the source of a program; `ev3proto encode -o FILE.rbf` makes its image"
        elif looks_like_assembly(self._first_line):
            more = f", but assembly; {_HOW_FRAMES_ARE_MADE}"
        elif _HAS_BYTES.search(self._first_line):
            more = ""
        else:
            more = HOW_FRAMES_ARE_WRITTEN
        return f"{source.label}: no frame found{more}"

    def _noting_the_first(self, lines: Iterator[str]) -> Iterator[str]:
        """Yields the lines, and keeps the first that is neither empty nor a comment."""
        for line in introduction(lines):
            self._first_line = line
            yield line
        yield from lines

    def read(self, source: Source) -> None:
        """Reads everything in a source, and reports an unreadable one."""
        is_recorded = self.wants_records and (self.reading.missing is not None or read_argument(source.name).data)
        if source.is_frame and is_recorded:
            self._recorded(source, Input(Kind.TEXT, lines=[source.name]))
        elif source.is_frame:
            self.argument(source)
        else:
            try:
                with source.open_capture() as file:
                    if self.reading.engine != BUILTIN:
                        self._recorded(source, Input(Kind.CAPTURE))
                    else:
                        self._file(source, file)
            except (OSError, EOFError, zlib.error) as error:
                self._unreadable(source, error)

    def _file(self, source: Source, file: CaptureFile) -> None:
        """Reads a file. Raises OSError, EOFError or zlib.error."""
        found = recognized(file, source.name, self.reading.dialect, self.accepted)
        if found.kind is Kind.OTHER:
            self.complain(f"{source.label}: {found.reason}")
        elif found.kind is Kind.PROGRAM:
            self._is_empty = False
            self.program(source, file.contents.read(MAX_IMAGE + 1))
        elif found.kind is Kind.CAPTURE or self.wants_records:
            self._recorded(source, found, file)
        elif found.kind is Kind.FRAMES:
            for pasted in found.frames:
                self.pasted(pasted, source)
        else:
            self.text_file(source, file, found.lines)

    def text_file(self, source: Source, file: CaptureFile, lines: Iterable[str]) -> None:
        """Takes a file that is a text. `lines` reads it."""
        with progress_bar(lambda: file.progress, source.label, is_quiet=self.is_quiet) as advance:
            self.text(source, advancing(lines, advance))

    def program(self, source: Source, image: bytes) -> None:  # noqa: ARG002 - for those that read it
        """Takes a program image (.rbf)."""
        self.complain(f"{source.label}: {NOT_A_CAPTURE}")

    def complain(self, sentence: str) -> None:
        """Prints a message about wrong input on standard error."""
        complain(sentence)
        self.at_fault = True
        self._is_empty = False

    def _recorded(self, source: Source, found: Input, file: CaptureFile | None = None) -> None:
        """Takes a capture, or the frames of a text as those of one."""
        from ev3proto.cli.captures import CaptureSource  # takes 15 ms, which frames do not need

        capture = CaptureSource(source.name, self.reading, file, found, is_quiet=self.is_quiet)
        self._is_empty = False
        if not self.capture(capture) and not capture.status:
            if found.kind is not Kind.CAPTURE and self.reading.filter is None:
                self.complain(self._nothing_in(source))
                return
            matches = " matches the filter" if self.reading.filter else ""
            self.complain(f"{source.label}: no {self.wanted} in {capture.extent}{matches}{capture.passed_over}")
        self.at_fault |= bool(capture.status)

    def _wrong(self, pasted: Pasted, problem: str, source: Source) -> None:
        """Reports a piece of text that is not a complete frame."""
        if not source.is_frame:
            self.complain(f"{source.where(pasted)}: {problem}")
        elif not pasted.data and source.looks_like_a_path:
            self._unreadable(source, FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT)))
        elif not pasted.data:
            self.complain(
                f"{source.where(pasted)} is neither a file {self.arguments}: {problem.removeprefix(_AT_START)}"
            )
        elif problem.startswith(_AT_START):
            self.complain(problem.removeprefix(_AT_START))
        else:
            self.complain(f"{source.where(pasted)}: {problem}")

    def _unreadable(self, source: Source, error: Exception) -> None:
        self.complain(f"{source.label}: cannot be read: {getattr(error, 'strerror', None) or error}")

    def pasted(self, pasted: Pasted, source: Source) -> None:
        """Takes everything in one piece of pasted text."""
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
            for piece in split(pasted.data, dialect=self.reading.dialect):
                self.piece(piece, pasted, source)
