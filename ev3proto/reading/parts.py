"""Each source, read once: what it is, and what is in it, in order.

A frame by itself needs no part that reads captures, so those are imported for the first file.
"""

from __future__ import annotations

import io
import zlib
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain
from typing import TYPE_CHECKING, BinaryIO

from ev3proto.capture.byte_account import Account
from ev3proto.capture.record import Announcement, CaptureError, Place, Record, Skipped
from ev3proto.capture.text_log import TextLog
from ev3proto.checking.report import Severity
from ev3proto.errors import counted
from ev3proto.reading.given import Given
from ev3proto.reading.incoming import IncomingFile, IncomingLines
from ev3proto.reading.items import Event, Image, Item, Problem, ProblemCode, Source, SourceKind
from ev3proto.reading.kinds import Kind, recognized
from ev3proto.reading.options import BUILTIN, MIB, Options, Sources
from ev3proto.reading.texts import TextReader
from ev3proto.semantics.advice import other_reading
from ev3proto.semantics.identify import identify
from ev3proto.tables import check_dialect
from ev3proto.tables.program import MAX_IMAGE
from ev3proto.text.paste import Pasted

if TYPE_CHECKING:
    from ev3proto.capture import Capture
    from ev3proto.capture.filter import Filter
    from ev3proto.capture.formats import CaptureFile

MOST_SKIPPED = 10
"""Maximum number of unreadable places in a capture that are yielded one by one."""


class Part:
    """One source, which is read by iterating once.

    label    its name in problems
    account  what the bytes read so far are
    is_text  whether its records are numbered by lines, not by packets
    """

    def __init__(self, given: Given, options: Options, log: TextLog, *, is_only: bool = False) -> None:
        self._is_only = is_only
        self.label = given.label
        self.account = Account()
        self.is_text = True
        self._given = given
        self._options = options
        self._place = Place(given.label)
        self._log = log
        self._texts = TextReader(given, options, log)
        self._file: CaptureFile | None = None

    @property
    def progress(self) -> float | None:
        """The part of its file that was read, 0 to 1; None if its size is unknown."""
        return None if self._file is None else self._file.progress

    def __iter__(self) -> Iterator[Event]:
        is_empty, dropped = True, self._log.budget.dropped
        for event in self._both_readings() if self._options.filter is None else self._matching():
            is_empty = is_empty and isinstance(event, Problem) and event.severity is not Severity.ERROR
            yield event
        if is_empty:
            yield self.nothing()
        elif self.account.strange:
            sentence = f"not all of it was read{self.passed_over}"
            yield Problem(self._place, ProblemCode.SKIPPED, sentence, Severity.WARNING)
        forgotten = self.account.forgotten - dropped * self.is_text
        if forgotten and self._can_answer:
            sentence = self._options.given_up(forgotten)
            yield Problem(self._place, ProblemCode.MEMORY, sentence, Severity.WARNING)

    # What is missing

    def where(self, number: int) -> Place:
        """Returns the place of a record by its number."""
        return Place(self.label, line=number) if self.is_text else Place(self.label, packet=number)

    def nothing(self, chosen: Filter | None = None) -> Problem:
        """Returns the problem that nothing that is wanted is in the source, or that nothing matches a filter."""
        chosen, account = chosen or self._options.filter, self.account
        if self.is_text and not account.frames:
            return self._texts.nothing()
        matches = f" matches the filter{chosen.hint}" if chosen is not None else ""
        code = ProblemCode.NO_MATCH if chosen is not None and account.frames + account.texts else ProblemCode.EMPTY
        passed_over = "" if code is ProblemCode.NO_MATCH else self.passed_over
        return Problem(self._place, code, f"no {self._options.wanted} in {self.extent}{matches}{passed_over}")

    @property
    def extent(self) -> str:
        """The part of it that was read: `12 packets`."""
        return counted(self.account.packets, "frame" if self.is_text else "packet")

    @property
    def passed_over(self) -> str:
        """Why packets may have frames although none was found, for problems; empty if they have none."""
        return self.account.passed_over

    def pieces(self, found: Iterable[Pasted]) -> Iterator[Record | Source | Problem]:
        """Yields what is in pieces of its text, which was yielded whole; or that there is nothing."""
        is_empty = True
        for pasted in found:
            for event in self._texts.pasted(pasted):
                is_empty = False
                yield event
        if is_empty:
            yield self.nothing()

    # What is there

    @property
    def _can_answer(self) -> bool:
        """Whether a command could have been answered: programs also log only what they send."""
        return not self.is_text or self._log.has_replies

    def _matching(self) -> Iterator[Event]:
        """Yields the records that match the filter, and everything that has no frames."""
        from ev3proto.capture.filter import Choosing  # takes 10 ms, which only filters need

        options = self._options
        assert options.filter is not None
        choosing = Choosing(options.filter, options.memory)
        is_begun = False
        for event in self._all():
            if isinstance(event, Announcement | Skipped):
                continue
            if not isinstance(event, Record):
                yield event
                continue
            if not is_begun:
                # Times count from the first packet, as those that are shown.
                options.filter.begin(event.time_ns if self.account.first_ns is None else self.account.first_ns)
                is_begun = True
            yield from choosing.take(event)
        yield from choosing.end()
        if choosing.given_up and self._can_answer:
            sentence = (
                f"{choosing.given_up} commands count as unanswered before the end of the capture: the"
                f" memory limit is {options.memory // MIB} MiB (--memory)"
            )
            yield Problem(self._place, ProblemCode.MEMORY, sentence, Severity.WARNING)

    def _both_readings(self) -> Iterator[Event]:
        """Yields everything, with a note in front of an only frame without a direction that an NXT has, too."""
        held: tuple[Record, str] | None = None
        count = 0
        for event in self._all():
            if isinstance(event, Record):
                count += 1
                if held is not None:
                    yield held[0]
                    held = None
                is_open = count == 1 and self._is_only and event.written is not None and event.seen.direction is None
                if is_open and (said := other_reading(identify(event.frame, missing=False))) is not None:
                    held = event, said
                    continue
            yield event
        if held is not None:
            yield Problem(held[0].place, ProblemCode.NOTE, held[1], Severity.HINT)
            yield held[0]

    def _all(self) -> Iterator[Event]:
        """Yields everything. Raises OSError if the file cannot be opened, unless that is to be a problem."""
        self.account, stream = self._log.begin(), None
        is_open = False
        try:
            stream = self._stream()
            # A word that looks like a path is a file that cannot be opened, too.
            is_open = self._given.word is None
            yield from self._opened(stream)
        except (OSError, EOFError, zlib.error) as error:
            if self._options.raises and not is_open:
                raise
            yield self._unreadable(error)
        finally:
            if stream is not None and not self._given.is_lent:
                stream.close()

    def _stream(self) -> BinaryIO | None:
        """Opens the file; tshark opens those with a name by itself. Raises OSError."""
        given = self._given
        return None if given.open is None or (self._is_for_wireshark and given.path is not None) else given.open()

    def _unreadable(self, error: Exception) -> Problem:
        return Problem(self._place, ProblemCode.DAMAGED, f"cannot be read: {getattr(error, 'strerror', None) or error}")

    @property
    def _is_for_wireshark(self) -> bool:
        return self._options.engine != BUILTIN

    def _opened(self, stream: BinaryIO | None) -> Iterator[Event]:
        given, options = self._given, self._options
        if given.word is not None:
            yield from self._texts.word(given.word)
        elif given.lines is not None:
            yield from self._texts.lines(given.lines)
        elif given.frame is not None:
            yield from self._contents(io.BytesIO(given.frame))
        elif given.is_program_source and options.sources is Sources.YES:
            from ev3proto.program.sources import MAX_SOURCE  # takes 50 ms, which frames do not need

            assert stream is not None
            yield Source(stream.read(MAX_SOURCE + 1), self._place, SourceKind.PROGRAM)
        elif self._is_for_wireshark:
            yield from self._captured(None, stream)
        elif stream is not None:
            yield from self._contents(stream)

    def _contents(self, stream: BinaryIO) -> Iterator[Event]:
        """Yields what is in a file. Raises OSError, EOFError or zlib.error."""
        from ev3proto.capture.formats import LISTED, CaptureFile  # takes 9 ms, which frames do not need

        options, given = self._options, self._given
        self._file = file = CaptureFile(stream)
        found = recognized(file, given.path, options.dialect, options.words.accepted.format(captures=LISTED))
        if found.kind is Kind.CAPTURE:
            yield from self._captured(file, None)
        elif found.kind is Kind.PROGRAM:
            yield self._image(file)
        elif found.kind is Kind.TEXT:
            yield from self._text(file, stream)
        elif found.kind is Kind.FRAMES:
            yield from chain.from_iterable(map(self._frame, found.frames))
        elif given.frame is not None:
            yield from self._frame(Pasted(given.frame, 1, ""))
        else:
            yield Problem(self._place, ProblemCode.KIND, found.reason)

    def _frame(self, frame: Pasted) -> Iterator[Event]:
        return self._texts.pasted(frame, Place(self.label, frame=frame.line))

    def _image(self, file: CaptureFile) -> Image | Problem:
        if self._options.images:
            return Image(file.contents.read(MAX_IMAGE + 1), self._place)
        return Problem(self._place, ProblemCode.KIND, "this is a program image (.rbf); `ev3proto decode` shows it")

    def _text(self, file: CaptureFile, stream: BinaryIO) -> Iterator[Event]:
        most = self._options.whole
        if most:
            yield Source(file.contents.read(most + 1), self._place, SourceKind.TEXT)
        else:
            raw = getattr(stream, "raw", None)
            lines = IncomingLines(file.contents, *([raw.is_silent] if isinstance(raw, IncomingFile) else []))
            yield from self._texts.lines(lines, lines.is_silent)

    def _captured(self, file: CaptureFile | None, stream: BinaryIO | None) -> Iterator[Event]:
        """Yields the events of a capture, and what cannot be read of it. Raises OSError."""
        self.is_text = False
        places = lost = 0
        try:
            with self._capture(file, stream) as capture:
                self.account = capture.account
                for event in capture.events():
                    if isinstance(event, Record):
                        event.name = self.label
                    elif isinstance(event, Skipped):
                        places += 1
                        lost += len(event.data)
                        if places <= MOST_SKIPPED:
                            yield _skipped(event, self.label)
                    yield event
        except CaptureError as error:
            yield Problem(self._place, ProblemCode.DAMAGED, str(error))
        if places > MOST_SKIPPED:
            sentence = f"and {places - MOST_SKIPPED} more places; {lost} bytes in all could not be read"
            yield Problem(self._place, ProblemCode.SKIPPED, sentence)

    def _capture(self, file: CaptureFile | None, stream: BinaryIO | None) -> Capture:
        """Opens a capture: a file, or with tshark a stream or the file that was named."""
        from ev3proto.capture import read  # takes 10 ms, which frames do not need

        options = self._options
        dialect, ports, memory = options.dialect, options.ports, options.memory
        if file is not None:
            return read(file, dialect=dialect, ports=ports, everything=options.everything, memory=memory)
        from ev3proto import pyshark  # takes 24 ms, which only this engine needs

        source = stream or self._given.path
        assert source is not None
        return pyshark.read(source, dialect=dialect, ports=ports, tshark=options.tshark, memory=memory)


def _skipped(event: Skipped, label: str) -> Problem:
    route = event.route
    sentence = f"{route.source} to {route.target}: {event.reason}"
    return Problem(Place(label, packet=event.number), ProblemCode.SKIPPED, sentence)


class Reading:
    """What is read of several sources, in order, by iterating once.

    parts  the sources
    part   the one that is read now, or the last
    """

    def __init__(self, sources: Sequence[Given], options: Options) -> None:
        check_dialect(options.dialect)
        self.options = options
        self._log = TextLog(options.dialect, options.memory)
        self.parts = [Part(given, options, self._log, is_only=len(sources) == 1) for given in sources]
        self.part = Part(Given(""), options, self._log)

    def __iter__(self) -> Iterator[Item]:
        """Yields records, images, sources and problems. Raises OSError for a file that cannot be opened."""
        for event in self.events():
            if not isinstance(event, Announcement | Skipped):
                yield event

    def events(self) -> Iterator[Event]:
        """Yields the same, and the texts around frames and the bytes between them."""
        for part in self.each():
            yield from part

    def each(self) -> Iterator[Part]:
        """Yields the sources, to iterate each before the next."""
        for part in self.parts:
            self.part = part
            yield part

    @property
    def label(self) -> str:
        """The names of the sources in problems."""
        return ", ".join(part.label for part in self.parts)

    @property
    def account(self) -> Account:
        """What all bytes read so far are."""
        account = Account()
        for part in self.parts:
            account.add(part.account)
        return account

    @property
    def passed_over(self) -> str:
        """Why packets may have frames although none was found, for problems; empty if they have none."""
        return "".join(part.passed_over for part in self.parts)

    @property
    def unit(self) -> str:
        """What the numbers of records count: packets, or lines if only texts were read."""
        return "line" if all(part.is_text for part in self.parts) else "packet"

    @property
    def progress(self) -> float | None:
        """The part of the current file that was read, 0 to 1; None if its size is unknown."""
        return self.part.progress
