"""What subcommands that take frames are given: frames themselves, texts that have some, captures, standard input."""

from __future__ import annotations

import errno
import io
import os
import re
import sys
import zlib
from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from ev3proto.cli.output import Awaited, advancing, complain, progress_bar
from ev3proto.cli.reading import (
    BUILTIN,
    HOW_FRAMES_ARE_WRITTEN,
    SOURCE_SUFFIX,
    START,
    CaptureOptions,
    Piece,
    hex_lines,
    introduction,
    is_binary,
    is_image,
    kind_of,
    pieces,
    raw_frames,
    split,
    text_lines,
)
from ev3proto.tables.program import MAX_IMAGE
from ev3proto.text.paste import Pasted, read_argument
from ev3proto.text.spans import visible

if TYPE_CHECKING:
    from ev3proto.capture.formats import CaptureFile
    from ev3proto.cli.captures import CaptureSource

_GROUP = re.compile(r"(0x)?([0-9a-f]{2}:?){1,4},?", re.IGNORECASE)
"""Whole bytes in hex, which are taken for bytes even where a file has that name."""

_AT_START = "column 1: "

_NUMBER = re.compile(r"[\[{]?((0x)?[0-9a-f]{1,2}|[0-9]{3})[\]}]?[,;]?", re.IGNORECASE)
"""One byte as numbers are written, also at an end of an array."""


_SUFFIX = re.compile(r"\w\.[a-z]\w{0,9}$", re.IGNORECASE)


class Source(NamedTuple):
    """One thing that was named on the command line: a file, standard input, or a frame itself."""

    name: str
    is_frame: bool

    @property
    def label(self) -> str:
        """How people call it, on one line."""
        return "standard input" if self.name == "-" else visible(self.name)

    def open(self) -> io.BufferedReader:
        """The bytes of a file or of standard input. Raises OSError when there are none to read."""
        if self.name != "-":
            path = Path(self.name)
            if path.is_file():
                return path.open("rb")
            return io.BufferedReader(Awaited(path.open("rb", buffering=0), is_ours=True))
        if sys.stdin is None:
            raise OSError("standard input is closed")
        raw = getattr(sys.stdin.buffer, "raw", None)
        assert isinstance(raw, io.RawIOBase | io.BytesIO), "standard input is a file of Python's own"
        return io.BufferedReader(Awaited(raw))

    @property
    def looks_like_a_path(self) -> bool:
        """Whether its name has a folder or a suffix, as that of a file."""
        return "/" in self.name or _SUFFIX.search(self.name) is not None

    def where(self, pasted: Pasted) -> str:
        """How a complaint about it starts."""
        return f"{self.name[:60]!r}" if self.is_frame else f"{self.label}, line {pasted.line}"


def sources(names: tuple[str, ...]) -> list[Source]:
    """What was named; bytes that were typed without quotes around them are one frame."""
    if len(names) > 1 and _are_bytes(names):
        return [Source(" ".join(names), is_frame=True)]
    return [Source(name, is_frame=name != "-" and (not name or not _exists(name))) for name in names or ("-",)]


def _are_bytes(names: tuple[str, ...]) -> bool:
    """Whether no name says anything by itself: each is a byte or a few."""
    if all(_GROUP.fullmatch(name) for name in names):
        return True
    return all(_NUMBER.fullmatch(name) for name in names) and not any(_exists(name) for name in names)


def _exists(name: str) -> bool:
    try:
        return Path(name).exists()
    except (OSError, ValueError):
        return False


_HOW_FRAMES_ARE_MADE = "`ev3proto encode` makes frames of it"


def looks_like_assembly(line: str) -> bool:
    """Whether a line that has no frame is assembly; one with nothing but a label may as well be a heading."""
    from ev3proto.text.assembly.recognising import is_assembly  # takes 11 ms, which frames have no use for

    return not line.rstrip().endswith(":") and is_assembly(line)


class SourceReader(ABC):
    """Reads sources one after the other, and remembers whether any was at fault.

    A subclass says what becomes of the frames of a text and of a capture. What cannot be read is complained about.
    """

    wanted = "frame"
    """What is looked for in captures, as complaints call it."""

    arguments = "nor a frame"
    """What an argument may be besides a file, as complaints call it."""

    accepted = "captures are pcap, pcapng or btsnoop files, packed with gzip or not"
    """What can be read, for whoever gives something else."""

    is_quiet = False
    """Nothing is printed while a capture is read: a progress bar may be drawn."""

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
            How many there were of what is wanted.
        """

    @property
    def wants_records(self) -> bool:
        """Whether the frames of a text are to be read as those of a capture: with their replies and times."""
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
            self._pasted(pasted, source)

    def assembly(self, source: Source, lines: Iterator[str]) -> None:  # noqa: ARG002 - for those that read it
        """Takes assembly that was typed on the command line; unless overridden, suggests `encode`."""
        self.complain(f"{source.name[:60]!r} is assembly, not a frame; {_HOW_FRAMES_ARE_MADE}")

    def text(self, source: Source, lines: Iterator[str]) -> None:
        """Takes the lines of a text, and complains about those that look like frames and are none."""
        lines = self._noting_the_first(lines)
        for pasted in pieces(lines, self.reading.missing, lambda unread: self.complain(f"{source.label}: {unread}")):
            self._pasted(pasted, source)

    def read_all(self, found: Sequence[Source]) -> None:
        """Reads everything in all sources, and complains about each that has no frame."""
        for source in found:
            self._is_empty, self._first_line = True, ""
            self.read(source)
            if self._is_empty:
                self.complain(self._nothing_in(source))

    def _nothing_in(self, source: Source) -> str:
        """What to say of a source without a frame."""
        if source.name.lower().endswith(SOURCE_SUFFIX):
            more = ", but the source of a program; `ev3proto encode -o FILE.rbf` makes its image"
        elif looks_like_assembly(self._first_line):
            more = f", but assembly; {_HOW_FRAMES_ARE_MADE}"
        else:
            more = HOW_FRAMES_ARE_WRITTEN
        return f"{source.label}: no frame found{more}"

    def _noting_the_first(self, lines: Iterator[str]) -> Iterator[str]:
        """The same lines, of which the first that is neither empty nor a comment is kept."""
        for line in introduction(lines):
            self._first_line = line
            yield line
        yield from lines

    def read(self, source: Source) -> None:
        """Reads everything in a source, and complains where it cannot be read."""
        if source.is_frame:
            if self.wants_records:
                self._recorded(source, iter([source.name]))
            else:
                self.argument(source)
            return
        file = self._opened(source)
        if file is None:
            return
        with file:
            if self.reading.engine != BUILTIN or self._is_capture(source, file):
                self._recorded(source, file=file if self.reading.engine == BUILTIN else None)
                return
            start = file.contents.peek(START)[:START]
            if is_image(start):
                self._program(source, file)
                return
            kind = kind_of(source.name, start)
            if kind is not None or is_binary(start):
                if self._raw(source, file):
                    return
                other = f"neither text nor a capture: it starts with {start.hex(' ').upper()}; {self.accepted}"
                self.complain(f"{source.label}: {kind or other}")
                return
            lines = self._readable(source, text_lines(file.contents))
            if self.wants_records:
                self._recorded(source, lines, file)
            else:
                with progress_bar(lambda: file.progress, source.label, is_quiet=self.is_quiet) as advance:
                    self.text(source, advancing(lines, advance))

    def _raw(self, source: Source, file: CaptureFile) -> bool:
        """Takes frames that stand one after the other as they are; says whether they do."""
        try:
            found = raw_frames(file.contents, self.reading.dialect)
        except (OSError, EOFError, zlib.error):
            return False
        if found is None:
            return False
        if self.wants_records:
            self._recorded(source, hex_lines(found))
            return True
        pasted = Pasted(b"", 1, "")
        self._is_empty = False
        for piece in found:
            self.piece(piece, pasted, source)
        return True

    def program(self, source: Source, image: bytes) -> None:
        """Takes a program image (.rbf)."""
        self.complain(
            f"{source.label}: a program image of {len(image)} bytes, which `ev3proto decode` shows; {self.accepted}"
        )

    def _program(self, source: Source, file: CaptureFile) -> None:
        try:
            image = file.contents.read(MAX_IMAGE + 1)
        except (OSError, EOFError, zlib.error) as error:
            self._unreadable(source, error)
            return
        self._is_empty = False
        self.program(source, image)

    def complain(self, sentence: str) -> None:
        """Prints a sentence on standard error, about input that is at fault."""
        complain(sentence)
        self.at_fault = True
        self._is_empty = False

    def _opened(self, source: Source) -> CaptureFile | None:
        from ev3proto.capture.formats import CaptureFile  # takes 13 ms, which frames have no use for

        try:
            return CaptureFile(source.open(), is_ours=source.name != "-")
        except OSError as error:
            self._unreadable(source, error)
            return None

    def _is_capture(self, source: Source, file: CaptureFile) -> bool:
        """Whether it is a capture; a damaged gzip is reported as one."""
        try:
            return file.is_capture
        except ValueError:  # a CaptureError
            return True
        except OSError as error:
            self._unreadable(source, error)
            return False

    def _recorded(self, source: Source, lines: Iterator[str] | None = None, file: CaptureFile | None = None) -> None:
        """Takes a capture, or the frames in the lines of a text as those of one."""
        from ev3proto.cli.captures import CaptureSource  # takes 15 ms, which frames have no use for

        capture = CaptureSource(source.name, self.reading, file, lines, is_quiet=self.is_quiet)
        self._is_empty = False
        if not self.capture(capture) and not capture.status:
            matches = " matches the filter" if self.reading.filter else ""
            self.complain(f"{source.label}: no {self.wanted} in {capture.extent}{matches}{capture.passed_over}")
        self.at_fault |= bool(capture.status)

    def _readable(self, source: Source, lines: Iterator[str]) -> Iterator[str]:
        """The lines as far as they can be read. What goes wrong with them elsewhere is none of its concern."""
        try:
            yield from lines
        except (OSError, EOFError, zlib.error) as error:
            self._unreadable(source, error)

    def _wrong(self, pasted: Pasted, problem: str, source: Source) -> None:
        """Complains about a piece of text that is not, or not whole, a frame."""
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

    def _pasted(self, pasted: Pasted, source: Source) -> None:
        """Takes everything in one piece of pasted text."""
        if pasted.problem is not None:
            self._wrong(pasted, pasted.problem, source)
        if pasted.data:
            self._is_empty = False
            for piece in split(pasted.data, dialect=self.reading.dialect):
                self.piece(piece, pasted, source)
