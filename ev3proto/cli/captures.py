"""Reading a capture for any subcommand: what it is, messages about it, a progress bar."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager

from ev3proto.capture import Account, Capture, CaptureError, Event, Record, Skipped, read
from ev3proto.capture.dialogues import RequestReply, dialogues
from ev3proto.capture.formats import CaptureFile
from ev3proto.capture.text_log import read_log
from ev3proto.cli.inputs import (
    HOW_FRAMES_ARE_WRITTEN,
    NOT_A_CAPTURE,
    Input,
    Kind,
    Source,
    pieces,
    recognized,
)
from ev3proto.cli.output import EVERY, advancing, complain, progress_bar
from ev3proto.cli.reading import BUILTIN, MIB, CaptureOptions, given_up
from ev3proto.errors import counted
from ev3proto.text.paste import Pasted

MOST_COMPLAINTS = 10
"""Maximum number of unreadable places in a capture that are reported one by one."""


class CaptureSource:
    """A capture, or a text read as one, that was named on the command line. Reading it reports what is unreadable.

    label   its name in messages
    status  exit status so far: 1 after any error
    """

    def __init__(
        self,
        name: str,
        options: CaptureOptions,
        file: CaptureFile | None = None,
        found: Input | None = None,
        *,
        is_quiet: bool = True,
    ) -> None:
        """Does not read anything yet.

        Args:
            name: Path, or - for standard input.
            options: How to read it.
            file: The file, if it is open already.
            found: The kind of the file, if that is known already.
            is_quiet: Nothing is printed while it is read, so that a progress bar may be drawn.
        """
        self._source = Source(name)
        self.label = self._source.label
        self.status = 0
        self._options = options
        self._file = file
        self._found = found
        self._is_quiet = is_quiet
        self._capture: Capture | None = None
        self._advance: Callable[[], None] = lambda: None

    @property
    def account(self) -> Account:
        """What the captured bytes read so far are."""
        if self._capture is not None:
            return self._capture.account
        return Account()

    def events(self) -> Iterator[Event]:
        """Reads the capture. Reports what is unreadable, and raises nothing.

        Yields:
            All events; with a filter, only frames that match it.
        """
        chosen = self._options.filter
        if chosen is None:
            yield from self._all_events()
            return
        from ev3proto.capture.filter import Choosing  # loaded already if there is a filter

        choosing = Choosing(chosen, self._options.memory * MIB)
        yield from choosing.chosen(self._all_events())
        if choosing.given_up:
            complain(
                f"{self.label}: {choosing.given_up} commands count as unanswered before the end of the capture: the"
                f" memory limit is {self._options.memory} MiB (--memory)"
            )

    def records(self) -> Iterator[Record]:
        """Reads the capture in the same way, and yields its frames."""
        return (event for event in self.events() if isinstance(event, Record))

    def dialogues(self) -> Iterator[RequestReply]:
        """Reads the capture in the same way.

        Yields:
            Each command with its reply, if the two match the filter.
        """
        chosen = self._options.filter
        for pair in dialogues(self._all_events()):
            if chosen is None or chosen.of_dialogue(pair):
                yield pair

    def expect_frames(self) -> None:
        """Reports a capture in which there was no frame or text of a brick, whatever the filter."""
        account = self.account
        if self._capture is not None and not (self.status or account.frames or account.texts):
            self._complain(
                f"no frame found{HOW_FRAMES_ARE_WRITTEN}"
                if self._is_text
                else f"no frame in {self.extent}{self.passed_over}"
            )

    def _all_events(self) -> Iterator[Event]:
        try:
            with self._opened() as capture, self._bar(capture) as self._advance:
                for count, event in enumerate(self._read(capture)):
                    if count % EVERY == 0:
                        self._advance()
                    yield event
        except CaptureError as error:
            self._complain(str(error))
        except OSError as error:
            self._complain(f"cannot be read: {error.strerror or error}")

    def _bar(self, capture: Capture) -> AbstractContextManager[Callable[[], None]]:
        """Returns the progress bar; for a text, it counts bytes of the file."""
        file = self._file if self._is_text else None
        return progress_bar(
            lambda: capture.progress if file is None else file.progress, self.label, is_quiet=self._is_quiet
        )

    def _complain(self, sentence: str) -> None:
        complain(f"{self.label}: {sentence}")
        self.status = 1

    def _opened(self) -> Capture:
        options, memory = self._options, self._options.memory * MIB
        if options.engine != BUILTIN and self._found is None:
            self._found = Input(Kind.CAPTURE)
        if self._found is None:
            self._file = self._source.open_capture()
            self._found = recognized(self._file, self._source.name, options.dialect)
        if self._found.kind in (Kind.PROGRAM, Kind.OTHER):
            raise CaptureError(self._found.reason or NOT_A_CAPTURE)
        if self._found.kind is not Kind.CAPTURE:
            self._capture = read_log(self._pieces(self._found), dialect=options.dialect, memory=memory)
        elif options.engine == BUILTIN:
            assert self._file is not None
            self._capture = read(
                self._file, dialect=options.dialect, ports=options.ports, everything=options.is_all, memory=memory
            )
        else:
            from ev3proto import pyshark  # takes 50 ms, which only this engine needs

            stream = sys.stdin.buffer if self._source.name == "-" else self._source.name
            self._capture = pyshark.read(
                stream, dialect=options.dialect, ports=options.ports, tshark=options.tshark, memory=memory
            )
        return self._capture

    def _pieces(self, found: Input) -> Iterator[Pasted]:
        """Yields the pieces of a text, and reports those that are unreadable."""
        yield from found.frames
        lines = advancing(found.lines, lambda: self._advance())
        for pasted in pieces(lines, self._options.missing):
            if pasted.problem is not None:
                self._complain(f"line {pasted.line}: {pasted.problem}")
            yield pasted

    @property
    def _is_text(self) -> bool:
        return self._found is not None and self._found.kind is not Kind.CAPTURE

    @property
    def unit(self) -> str:
        """What the numbers of its records count: packets, or lines of a text."""
        return "line" if self._is_text else "packet"

    def carrier(self, record: Record) -> str | None:
        """Returns what carried a frame; None for a text."""
        return str(record.carrier) if not self._is_text else None

    @property
    def extent(self) -> str:
        """The part of it that was read, for messages."""
        return counted(self.account.packets, "frame" if self._is_text else "packet")

    @property
    def passed_over(self) -> str:
        """Why packets may have frames although none was found, for messages; empty if they have none."""
        account = self.account
        said = ""
        for place, count in account.strange.items() if not account.frames else ():
            option = f"--port {place.rpartition(' ')[2]}" if "TCP" in place else "--all"
            was, them = ("was", "it as it is") if count == 1 else ("were", "them as they are")
            said += f"; {counted(count, 'packet')} {place} {was} not recognised; {option} shows {them}"
        if account.cut:
            said += f"; of {counted(account.cut, 'packet')} only the first bytes were captured (snap length)"
        return said

    def _read(self, capture: Capture) -> Iterator[Event]:
        """Yields the events, and reports skipped bytes."""
        chosen = self._options.filter
        is_begun = False
        places = lost = 0
        for event in capture.events():
            if chosen is not None and not is_begun:
                # Times count from the first packet, as those that are shown.
                chosen.begin(event.time_ns if capture.account.first_ns is None else capture.account.first_ns)
                is_begun = True
            if isinstance(event, Skipped):
                places += 1
                lost += len(event.data)
                if places <= MOST_COMPLAINTS:
                    self._complain(str(event))
            yield event
        if capture.account.forgotten:
            complain(given_up(self.label, capture.account.forgotten, self._options.memory))
        if places > MOST_COMPLAINTS:
            self._complain(f"and {places - MOST_COMPLAINTS} more places; {lost} bytes in all could not be read")
