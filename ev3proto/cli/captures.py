"""What the subcommands that read captures share: options, complaints, progress bar."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from typing import Any

from ev3proto.capture import Account, Capture, CaptureError, Event, Record, Skipped, read
from ev3proto.capture.dialogues import RequestReply, dialogues
from ev3proto.capture.formats import CaptureFile
from ev3proto.capture.text_log import read_log
from ev3proto.cli.output import EVERY, advancing, complain, progress_bar
from ev3proto.cli.reading import (
    BUILTIN,
    HOW_FRAMES_ARE_WRITTEN,
    MIB,
    START,
    CaptureOptions,
    given_up,
    hex_lines,
    is_binary,
    is_image,
    kind_of,
    pieces,
    raw_frames,
    text_lines,
)
from ev3proto.errors import counted
from ev3proto.text.paste import Pasted
from ev3proto.text.spans import visible

MOST_COMPLAINTS = 10
"""Places in a capture that are complained about one by one; of the others, only their number is given."""


@dataclass
class CaptureSource:
    """A capture that was named on the command line.

    name      path, or - for standard input
    options   how to read it
    file      its bytes, where they were looked at before
    lines     its lines, where it is a text
    is_quiet  nothing is printed while it is read: a progress bar may be drawn
    status    exit status so far: 1 once anything was at fault
    """

    name: str
    options: CaptureOptions
    file: CaptureFile | None = None
    lines: Iterator[str] | None = None
    is_quiet: bool = field(default=True, kw_only=True)
    status: int = field(default=0, kw_only=True)
    _capture: Capture | None = field(default=None, repr=False)
    _advance: Callable[[], None] = field(default=lambda: None, repr=False)

    @property
    def account(self) -> Account:
        """Where the captured bytes went, so far."""
        if self._capture is not None:
            return self._capture.account
        return Account()

    @property
    def label(self) -> str:
        """What complaints call it."""
        return "standard input" if self.name == "-" else visible(self.name)

    def events(self) -> Iterator[Event]:
        """Reads the capture. What cannot be read is complained about; nothing is raised.

        Yields:
            All events, or with a filter the frames that it lets through and nothing else.
        """
        chosen = self.options.filter
        if chosen is None:
            yield from self._all_events()
            return
        from ev3proto.capture.filter import Choosing  # loaded already where there is a filter

        choosing = Choosing(chosen, self.options.memory * MIB)
        yield from choosing.chosen(self._all_events())
        if choosing.given_up:
            complain(
                f"{self.label}: {choosing.given_up} commands were taken for unanswered before the capture ended: what"
                f" waits may take {self.options.memory} MiB (--memory)"
            )

    def records(self) -> Iterator[Record]:
        """Reads the capture in the same way. Yields its frames."""
        return (event for event in self.events() if isinstance(event, Record))

    def dialogues(self) -> Iterator[RequestReply]:
        """Reads the capture in the same way.

        Yields:
            Each command with its reply, as far as the filter lets the two of them through.
        """
        chosen = self.options.filter
        for pair in dialogues(self._all_events()):
            if chosen is None or chosen.of_dialogue(pair):
                yield pair

    def expect_frames(self) -> None:
        """Complains of what was read to its end where nothing of a brick is in it, whatever the filter lets through."""
        account = self.account
        if self._capture is not None and not (self.status or account.frames or account.texts):
            self._complain(
                f"no frame found{HOW_FRAMES_ARE_WRITTEN}"
                if self.lines is not None
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
        """What shows how far reading is; of a text, how many of its lines were read."""
        file = self.file if self.lines is not None else None
        return progress_bar(
            lambda: capture.progress if file is None else file.progress, self.label, is_quiet=self.is_quiet
        )

    def _complain(self, sentence: str) -> None:
        complain(f"{self.label}: {sentence}")
        self.status = 1

    def _opened(self) -> Capture:
        options = self.options
        if self.lines is None and options.engine == BUILTIN:
            self._look()
        if self.lines is not None:
            self._capture = read_log(self._pieces(self.lines), dialect=options.dialect, memory=options.memory * MIB)
            return self._capture
        source, memory = self.file or _stream(self.name), options.memory * MIB
        if options.engine == BUILTIN:
            self._capture = read(source, dialect=options.dialect, ports=options.ports, memory=memory)
        else:
            from ev3proto import pyshark  # takes 50 ms, which only this engine needs

            self._capture = pyshark.read(
                source, dialect=options.dialect, ports=options.ports, tshark=options.tshark, memory=memory
            )
        return self._capture

    def _look(self) -> None:
        """Finds out whether the file is a text."""
        if self.file is None:
            self.file = CaptureFile.at(self.name) if self.name != "-" else CaptureFile(_stream(self.name))
        if self.file.is_capture:
            return
        start = self.file.contents.peek(START)[:START]
        if is_image(start):
            raise CaptureError("this is a program image (.rbf), not a capture; `ev3proto decode` shows it")
        kind = kind_of(self.name, start)
        if kind is None and not is_binary(start):
            self.lines = text_lines(self.file.contents)
            return
        raw = raw_frames(self.file.contents, self.options.dialect)
        if raw is None and kind is not None:
            raise CaptureError(kind)
        self.lines = None if raw is None else hex_lines(raw)

    def _pieces(self, lines: Iterator[str]) -> Iterator[Pasted]:
        """What there is in the text; what cannot be read of it is complained about."""
        for pasted in pieces(advancing(lines, lambda: self._advance()), self.options.missing, self._complain):
            if pasted.problem is not None:
                self._complain(f"line {pasted.line}: {pasted.problem}")
            yield pasted

    @property
    def unit(self) -> str:
        """What the numbers of its records count: packets, or the lines of a text."""
        return "packet" if self.lines is None else "line"

    def carrier(self, record: Record) -> str | None:
        """What carried a frame; nobody knows that of a text."""
        return str(record.carrier) if self.lines is None else None

    @property
    def extent(self) -> str:
        """How much there is of it, as complaints call it."""
        return counted(self.account.packets, "packet" if self.lines is None else "frame")

    @property
    def passed_over(self) -> str:
        """What to say besides where nothing was found: why packets may have frames all the same, empty if none may."""
        account = self.account
        said = ""
        if account.packed:
            packets = counted(sum(account.packed.values()), "packet")
            names = ", ".join(f"{name} {count}" for name, count in account.packed.items())
            said += (
                f"; {packets} may have others packed into them ({names}), which are not read here:"
                " --engine wireshark reads them"
            )
        if account.cut:
            said += f"; of {counted(account.cut, 'packet')} only the first bytes were captured (snap length)"
        return said

    def _read(self, capture: Capture) -> Iterator[Event]:
        """The events; skipped bytes are complained about."""
        chosen = self.options.filter
        is_begun = False
        places = lost = 0
        for event in capture.events():
            if chosen is not None and not is_begun:
                # From the first packet on, as the times that are shown.
                chosen.begin(event.time_ns if capture.account.first_ns is None else capture.account.first_ns)
                is_begun = True
            if isinstance(event, Skipped):
                places += 1
                lost += len(event.data)
                if places <= MOST_COMPLAINTS:
                    self._complain(str(event))
            yield event
        if capture.account.forgotten:
            complain(given_up(self.label, capture.account.forgotten, self.options.memory))
        if places > MOST_COMPLAINTS:
            self._complain(f"and {places - MOST_COMPLAINTS} more places; {lost} bytes in all could not be read")


def _stream(name: str) -> Any:
    if name != "-":
        return name
    if sys.stdin is None:
        raise OSError("standard input is closed")
    return sys.stdin.buffer
