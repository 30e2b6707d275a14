"""A capture of any subcommand: its events, chosen by a filter, and messages about it."""

from __future__ import annotations

import sys
from collections.abc import Iterator

from ev3proto.capture import Account, Capture, CaptureError, Event, Record, Skipped, read
from ev3proto.capture.dialogues import RequestReply, dialogues
from ev3proto.capture.text_log import read_log
from ev3proto.cli.kinds import Contents, Kind
from ev3proto.cli.output import complain
from ev3proto.cli.reading import HOW_FRAMES_ARE_WRITTEN, MIB, CaptureOptions, given_up, pieces
from ev3proto.cli.words import Source
from ev3proto.errors import counted
from ev3proto.text.paste import Pasted

MOST_COMPLAINTS = 10
"""Maximum number of unreadable places in a capture that are reported one by one."""


class CaptureSource:
    """A capture, or a text that is read as one. Reading it reports what is unreadable.

    label   its name in messages
    unit    what the numbers of its records count: packets, or lines of a text
    status  exit status so far: 1 after any error
    taken   how much of what a subcommand looks for was in it
    """

    def __init__(self, source: Source, options: CaptureOptions, contents: Contents) -> None:
        """Does not read anything yet. Without a file in `contents`, Wireshark reads the source."""
        self.label = source.label
        self.is_text = contents.kind is not Kind.CAPTURE
        self.unit = "line" if self.is_text else "packet"
        self.status = 0
        self.taken = 0
        self._source = source
        self._options = options
        self._contents = contents
        self._capture: Capture | None = None

    @property
    def account(self) -> Account:
        """What the captured bytes read so far are."""
        if self._capture is not None:
            return self._capture.account
        return Account()

    def events(self) -> Iterator[Event]:
        """Yields all events, or with a filter the frames that match; reports what is unreadable, and raises nothing."""
        chosen = self._options.filter
        if chosen is None:
            yield from self._all_events()
            return
        from ev3proto.capture.filter import Choosing  # takes 10 ms, which only filters need

        choosing = Choosing(chosen, self._options.memory * MIB)
        yield from choosing.chosen(self._all_events())
        if choosing.given_up:
            complain(
                f"{self.label}: {choosing.given_up} commands count as unanswered before the end of the capture: the"
                f" memory limit is {self._options.memory} MiB (--memory)"
            )

    def records(self) -> Iterator[Record]:
        """Yields the frames; reports in the same way."""
        return (event for event in self.events() if isinstance(event, Record))

    def dialogues(self) -> Iterator[RequestReply]:
        """Yields each command with its reply, if the two match the filter; reports in the same way."""
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
                if self.is_text
                else f"no frame in {self.extent}{self.passed_over}"
            )

    def _all_events(self) -> Iterator[Event]:
        try:
            with self._opened() as self._capture:
                yield from self._read(self._capture)
        except CaptureError as error:
            self._complain(str(error))
        except OSError as error:
            self._complain(f"cannot be read: {error.strerror or error}")

    def _complain(self, sentence: str) -> None:
        complain(f"{self.label}: {sentence}")
        self.status = 1

    def _opened(self) -> Capture:
        options, file, memory = self._options, self._contents.file, self._options.memory * MIB
        if self.is_text:
            return read_log(self._pieces(), dialect=options.dialect, memory=memory)
        if file is not None:
            return read(file, dialect=options.dialect, ports=options.ports, everything=options.is_all, memory=memory)
        from ev3proto import pyshark  # takes 24 ms, which only this engine needs

        stream = sys.stdin.buffer if self._source.name == "-" else self._source.name
        return pyshark.read(stream, dialect=options.dialect, ports=options.ports, tshark=options.tshark, memory=memory)

    def _pieces(self) -> Iterator[Pasted]:
        """Yields the pieces of a text, and reports those that are unreadable."""
        yield from self._contents.frames
        for pasted in pieces(self._contents.lines, self._options.missing):
            if pasted.problem is not None:
                self._complain(f"line {pasted.line}: {pasted.problem}")
            yield pasted

    def where(self, number: int) -> str:
        """Returns the start of a message about a record."""
        return f"{self.label}, {self.unit} {number}"

    def carrier(self, record: Record) -> str | None:
        """Returns what carried a frame; None for a text."""
        return str(record.carrier) if not self.is_text else None

    @property
    def extent(self) -> str:
        """The part of it that was read, for messages."""
        return counted(self.account.packets, "frame" if self.is_text else "packet")

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
