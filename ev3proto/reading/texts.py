"""The frames of a text, or the source that it is. The first line that is neither empty nor a comment decides."""

from __future__ import annotations

import errno
import os
import re
from collections.abc import Callable, Iterable, Iterator
from itertools import chain, islice

from ev3proto.capture.record import Place, Record
from ev3proto.capture.text_log import TextLog
from ev3proto.checking.report import Severity
from ev3proto.reading.given import PATH, Given
from ev3proto.reading.items import Problem, ProblemCode, Source
from ev3proto.reading.kinds import introduction
from ev3proto.reading.options import HOW_FRAMES_ARE_WRITTEN, Options, Sources
from ev3proto.schema.header import frame_size
from ev3proto.text.paste import Pasted, read_argument, read_bare, read_text

_MOST_LABEL = 60
_HOW_FRAMES_ARE_MADE = "`ev3proto encode` makes frames of it"
_HAS_BYTES = r"(?:(?<!\w)(?:0x|\\x)?[0-9a-fA-F]{2,8}[\s:,-]{1,3}){4}"
"""Bytes in hex, which need no advice on how to write frames."""

_OPENS = ("[", "(")
"""The end of a first line that says nothing of what follows: `ops = b''.join([`."""

_SUMMARY = "--- BEGIN:BTSNOOP_LOG_SUMMARY", "--- END:BTSNOOP_LOG_SUMMARY"
"""The lines around a compressed log in a bug report of Android."""

Found = Iterator[Record | Source | Problem]


def looks_like_assembly(line: str) -> bool:
    """Whether a line without a frame is assembly; one with only a label may be a heading."""
    from ev3proto.text.assembly.recognising import is_assembly  # takes 19 ms, which frames do not need

    return not line.rstrip().endswith(":") and is_assembly(line)


class TextReader:
    """Reads one text, of which the frames belong to a dialogue that may have begun in an earlier text."""

    def __init__(self, given: Given, options: Options, log: TextLog) -> None:
        self._given = given
        self._options = options
        self._log = log
        self._first_line = ""
        self._summary = 0  # the line of a bug report at which a compressed log begins

    def word(self, text: str) -> Found:
        """Yields what is in a text that is known to be meant as bytes or assembly.

        Raises:
            FileNotFoundError: It has no bytes, but looks like the name of a file.
        """
        lines, sources = text.split("\n"), self._options.sources
        if self._options.missing is not None:
            # For `decode` and `check`, a word is one frame, however many lines it has.
            yield from self.lines(lines if sources is Sources.FIRST else [text])
            return
        pasted = None if sources is Sources.FIRST else read_argument(text)
        if pasted is None or not _has_bytes(pasted, text):
            line = "".join([*introduction(iter(lines))][-1:]).strip()
            source = self._source(line)
            if source is not None:
                yield from source(lines)
                return
            if sources is Sources.NO and looks_like_assembly(line):
                sentence = f"{self._given.quoted} is assembly, not a frame; {_HOW_FRAMES_ARE_MADE}"
                yield Problem(Place(), ProblemCode.TEXT, sentence)
                return
        yield from self.pasted(pasted or read_argument(text))

    def lines(self, lines: Iterable[str], is_silent: Callable[[], bool] = lambda: False) -> Found:
        """Yields what is in the lines of a text; `is_silent` waits, and says whether no line comes."""
        noted = self._noted(self._without_summary(lines))
        if self._options.missing is None and self._options.sources is not Sources.NO:
            first = list(introduction(noted))
            if self._first_line.rstrip().endswith(_OPENS):
                first += islice(noted, 1)
                self._first_line += first[-1]
            noted = chain(first, noted)
            source = self._source(self._first_line.strip())
            if source is not None:
                yield from source(noted)
                return
        missing = self._options.missing
        bare = missing and read_bare(noted, missing, self._options.dialect)
        for pasted in bare or read_text(noted, is_silent):
            yield from self.pasted(pasted)
        if self._summary:
            from ev3proto.capture.formats.unread import BTSNOOZ  # takes 9 ms, which frames do not need

            yield Problem(Place(self._given.label, self._summary), ProblemCode.KIND, BTSNOOZ)

    def pasted(self, pasted: Pasted, place: Place | None = None) -> Found:
        """Yields the frames in one piece of the text, and what is wrong with it."""
        given = self._given
        is_typed = given.word is not None
        if place is None:
            place = Place(given.quoted) if is_typed else Place(given.label, pasted.line)
        if pasted.problem is not None:
            yield self._wrong(pasted, pasted.problem, place)
        for note in pasted.notes:
            yield Problem(place, ProblemCode.NOTE, note, Severity.HINT)
        for unknown in pasted.unknown:
            if unknown.text:
                at = Place("" if is_typed else given.label, unknown.line, unknown.column, offset=unknown.offset)
                yield Problem(at, ProblemCode.UNKNOWN, f"{unknown.text!r} is unknown, read as 0", Severity.WARNING)
        if pasted.data:
            yield from self._log.records(pasted, place, is_typed=is_typed)

    def nothing(self) -> Problem:
        """Returns the problem that nothing is in the text."""
        given, sentence = self._given, self._options.words.nothing
        if not sentence:
            sentence = f"no frame found{self._advice()}"
        return Problem(Place(given.label), ProblemCode.EMPTY, sentence)

    def _advice(self) -> str:
        if self._given.is_program_source:
            return ", but the source of a program; `ev3proto encode -o FILE.rbf` makes its image"
        if looks_like_assembly(self._first_line):
            return f", but assembly; {_HOW_FRAMES_ARE_MADE}"
        return "" if re.search(_HAS_BYTES, self._first_line) else HOW_FRAMES_ARE_WRITTEN

    def _wrong(self, pasted: Pasted, problem: str, place: Place) -> Problem:
        """Returns the problem for a piece of text that is not a complete frame."""
        given, slip = self._given, pasted.slip
        if slip is not None:
            line = slip.line if slip.line > 1 or given.word is None else None
            place = place._replace(line=line, column=slip.column)
        if given.name is None or pasted.data:
            return Problem(place, ProblemCode.TEXT, pasted.reason or problem, lacks=pasted.lacks)
        if PATH.fullmatch(given.name):
            raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), given.name)
        reason = pasted.reason if place.column == 1 else problem
        sentence = f"{given.quoted} is neither a file {self._options.words.argument}: {reason}"
        code = ProblemCode.TEXT if given.name.strip() else ProblemCode.EMPTY
        return Problem(place, code, sentence, lacks=pasted.lacks)

    def _without_summary(self, lines: Iterable[str]) -> Iterator[str]:
        """Yields the lines, but not those of the compressed log in a bug report of Android."""
        is_inside = False
        for number, line in enumerate(lines, 1):
            if line.startswith(_SUMMARY):
                is_inside = line.startswith(_SUMMARY[0])
                self._summary = self._summary or number
            elif not is_inside:
                yield line
                continue
            yield "\n"

    def _noted(self, lines: Iterator[str]) -> Iterator[str]:
        """Yields the lines, and keeps the first that is neither empty nor a comment."""
        for line in introduction(lines):
            self._first_line = line
            yield line
        yield from lines

    # Texts without bytes

    def _source(self, line: str) -> Callable[[Iterable[str]], Found] | None:
        """Returns what reads a text by its first line; None for one that has bytes."""
        wanted = self._options.sources
        if wanted is Sources.NO:
            return None
        if wanted is Sources.YES:
            return self._assembly if looks_like_assembly(line) else None
        if _is_record(line):
            return self._objects
        from ev3proto.text.assembly.recognising import OBJECT, is_assembly  # takes 19 ms, which frames do not need

        return self._assembly if is_assembly(line) or OBJECT.match(line) else None

    def _assembly(self, lines: Iterable[str]) -> Found:
        from ev3proto.text.assembly.assembling import MAX_SOURCE  # takes 8 ms, which frames do not need

        is_typed = self._given.word is not None
        text = _joined(lines, "\n" if is_typed else "", MAX_SOURCE + 1)
        yield Source(text, Place("" if is_typed else self._given.label), is_typed=is_typed)

    def _objects(self, lines: Iterable[str]) -> Found:
        """Yields the messages of JSON objects."""
        from ev3proto.schema.frame import parse
        from ev3proto.text.json_format.to_messages import RecordError, frames_of_json, read_records  # takes 5 ms, too

        label, dialect = self._given.label[:_MOST_LABEL], self._options.dialect
        try:
            for number, entry in read_records(lines):
                place = Place(label, number)
                try:
                    for frame in frames_of_json(entry, dialect=dialect):
                        yield self._log.made(parse(frame, strict=False, dialect=dialect), place, number)
                except RecordError as error:
                    yield Problem(place, ProblemCode.SOURCE, str(error))
        except RecordError as error:
            yield Problem(Place(label, error.line, error.column), ProblemCode.SOURCE, str(error))


def _has_bytes(pasted: Pasted, text: str) -> bool:
    """Whether the bytes of a text are meant; those of INFO(GET_VOLUME, GV0(0)) are letters of an operation."""
    data = pasted.data
    return bool(data) and (frame_size(data) == len(data) or not looks_like_assembly(text.strip()))


def _is_record(line: str) -> bool:
    """Whether a JSON object starts in a line; a brace alone counts, because C arrays have a name before it."""
    return line == "{" or (line.startswith("{") and line[1:].lstrip().startswith('"'))


def _joined(lines: Iterable[str], between: str, most: int) -> str:
    """Joins lines to one text, and stops reading once it has `most` characters."""
    kept: list[str] = []
    size = 0
    for line in lines:
        kept.append(line)
        size += len(line) + len(between)
        if size >= most:
            break
    return between.join(kept)
