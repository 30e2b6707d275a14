"""What the subcommands that read captures share: options, complaints, progress bar."""

from __future__ import annotations

import functools
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from functools import partial
from typing import TYPE_CHECKING, Any, TypeVar

import click

from ev3proto.bounded import DEFAULT_MEMORY
from ev3proto.cli.output import complain, say
from ev3proto.cli.progress import EVERY, advancing, progress_bar
from ev3proto.errors import counted
from ev3proto.tables.declaration import DIALECTS
from ev3proto.tables.discovery import TCP_PORT
from ev3proto.text.visible import visible

if TYPE_CHECKING:
    from ev3proto.capture import Account, Capture, Event, Record
    from ev3proto.capture.dialogues import RequestReply
    from ev3proto.capture.filter import Filter, FilterError
    from ev3proto.capture.formats import CaptureFile
    from ev3proto.text.paste import Missing, Pasted

BUILTIN = "builtin"
"""The engine that needs no other program."""

MOST_COMPLAINTS = 10
"""Places in a capture that are complained about one by one; of the others, only their number is given."""

MIB = 1 << 20
"""Bytes in which --memory counts."""


@dataclass
class CaptureOptions:
    """How captures are to be read.

    dialect  the firmware whose instruction set to read by
    ports    TCP ports on which bricks listen
    engine   builtin or wireshark
    tshark   path of the tshark for that engine
    filter   which records to show, None for all
    missing  what the bytes in a text lack in front of them to be frames
    memory   MiB that all that waits may take
    """

    dialect: str = DIALECTS[0]
    ports: tuple[int, ...] = (TCP_PORT,)
    engine: str = BUILTIN
    tshark: str | None = None
    filter: Filter | None = None
    missing: Missing | None = None
    memory: int = DEFAULT_MEMORY // MIB


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
        from ev3proto.capture import Account

        return Account()

    @property
    def label(self) -> str:
        """What complaints call it."""
        return "standard input" if self.name == "-" else visible(self.name)

    def events(self, look: Callable[[Event], None] | None = None) -> Iterator[Event]:
        """Reads the capture. What cannot be read is complained about; nothing is raised.

        Args:
            look: With a filter it is called with each event before that is chosen, also with those that are not.

        Yields:
            All events, or with a filter the frames that it lets through and nothing else.
        """
        chosen = self.options.filter
        if chosen is None:
            yield from self._all_events()
            return
        from ev3proto.capture.filter import Choosing

        choosing = Choosing(chosen, self.options.memory * MIB)
        events = self._all_events()
        yield from choosing.chosen(events if look is None else _looked_at(events, look))
        if choosing.given_up:
            complain(
                f"{self.label}: {choosing.given_up} commands were taken for unanswered before the capture ended: what"
                f" waits may take {self.options.memory} MiB (--memory)"
            )

    def dialogues(self) -> Iterator[RequestReply]:
        """Reads the capture in the same way.

        Yields:
            Each command with its reply, as far as the filter lets the two of them through.
        """
        from ev3proto.capture.dialogues import dialogues

        chosen = self.options.filter
        for pair in dialogues(self._all_events()):
            if chosen is None or chosen.of_dialogue(pair):
                yield pair

    def expect_frames(self) -> None:
        """Complains of what was read to its end where nothing of a brick is in it, whatever the filter lets through."""
        account = self.account
        if self._capture is not None and not (self.status or account.frames or account.texts):
            self._complain(f"there is no frame in {'it' if self.lines is not None else self.extent}{self.passed_over}")

    def _all_events(self) -> Iterator[Event]:
        from ev3proto.capture import CaptureError

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
        from ev3proto.capture import read
        from ev3proto.capture.text_log import read_log
        from ev3proto.pyshark import read as read_by_tshark

        options = self.options
        if self.lines is None and options.engine == BUILTIN:
            self._look()
        if self.lines is not None:
            self._capture = read_log(self._pieces(self.lines), dialect=options.dialect, memory=options.memory * MIB)
            return self._capture
        opened = read if options.engine == BUILTIN else partial(read_by_tshark, tshark=options.tshark)
        self._capture = opened(
            self.file or _stream(self.name), dialect=options.dialect, ports=options.ports, memory=options.memory * MIB
        )
        return self._capture

    def _look(self) -> None:
        """Finds out whether the file is a text."""
        from ev3proto.capture.formats import CaptureFile
        from ev3proto.capture.record import CaptureError
        from ev3proto.cli.programs import is_image
        from ev3proto.cli.texts import START, hex_lines, is_text, raw_frames, text_lines

        if self.file is None:
            self.file = CaptureFile.at(self.name) if self.name != "-" else CaptureFile(_stream(self.name))
        if self.file.is_capture:
            return
        if is_image(self.file.contents.peek(START)[:START]):
            raise CaptureError("this is a program image (.rbf) and no capture: ev3proto decode shows it")
        if is_text(self.file):
            self.lines = text_lines(self.file.contents)
        else:
            raw = raw_frames(self.file.contents, self.options.dialect)
            self.lines = None if raw is None else hex_lines(raw)

    def _pieces(self, lines: Iterator[str]) -> Iterator[Pasted]:
        """What there is in the text; what cannot be read of it is complained about."""
        from ev3proto.cli.texts import pieces

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
        from ev3proto.capture import Skipped

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


def given_up(label: str, count: int, memory: int) -> str:
    """What to say where too much waited.

    Args:
        label: What was read.
        count: How many things had to go.
        memory: MiB that all that waits may take.
    """
    return (
        f"{label}: {count} parts of frames, transfers and commands without a reply were given up: what waits may take"
        f" {memory} MiB (--memory)"
    )


def _stream(name: str) -> Any:
    if name != "-":
        return name
    if sys.stdin is None:
        raise OSError("standard input is closed")
    return sys.stdin.buffer


def _compiled(_context: click.Context, _parameter: click.Parameter, text: str | None) -> Filter | None:
    if text is None:
        return None
    from ev3proto.capture.filter import FilterError, compile_filter

    try:
        return compile_filter(text)
    except FilterError as error:
        raise click.BadParameter(f"{error}\n{_underlined(text, error)}") from None


_WINDOW = 60
"""Characters of a filter that are shown on either side of what is wrong in it."""


def _underlined(text: str, error: FilterError) -> str:
    """Two lines: the filter, and below it what is wrong in it."""
    at = error.column - 1
    start, end = max(at - _WINDOW, 0), at + _WINDOW
    shown = "".join(character if character.isprintable() else " " for character in text[start:end])
    before, after = "..." * (start > 0), "..." * (end < len(text))
    sign = "^" * min(error.length, max(len(shown) - (at - start), 1))
    return f"  {before}{shown}{after}\n  {' ' * (len(before) + at - start)}{sign}"


def _explain_filters(context: click.Context, _parameter: click.Parameter, is_wanted: bool) -> None:
    if not is_wanted or context.resilient_parsing:
        return
    from ev3proto.capture.filter.manual import manual

    say("\n".join(manual()))
    context.exit()


F = TypeVar("F", bound=Callable[..., Any])

_OPTIONS = (
    click.option(
        "--dialect", type=click.Choice(DIALECTS), default=DIALECTS[0], show_default=True, help="Whose instruction set."
    ),
    click.option(
        "--port",
        "ports",
        type=click.IntRange(1, 65535),
        multiple=True,
        default=(TCP_PORT,),
        show_default=True,
        help="TCP port on which a brick listens; several are allowed.",
    ),
    click.option(
        "--engine",
        type=click.Choice((BUILTIN, "wireshark")),
        default=BUILTIN,
        show_default=True,
        help="What takes packets apart: ev3proto itself, or the tshark on this computer.",
    ),
    click.option("--tshark", metavar="PATH", help="The tshark to use, where it is not on the path."),
    click.option(
        "--filter",
        "chosen",
        callback=_compiled,
        metavar="EXPRESSION",
        help="Only frames for which this is true, such as 'op==SOUND.TONE && FREQUENCY>400'.",
    ),
    click.option(
        "--help-filter",
        is_flag=True,
        is_eager=True,
        expose_value=False,
        callback=_explain_filters,
        help="List all that a filter can ask for, with examples, and exit.",
    ),
    click.option(
        "--no-length",
        is_flag=True,
        help="Each line of a text is a frame without the two bytes of its length field.",
    ),
    click.option(
        "--operations",
        "only_operations",
        is_flag=True,
        help="Each line of a text is operations without the header of a frame.",
    ),
    click.option(
        "--memory",
        type=click.IntRange(1, 1 << 16),
        default=DEFAULT_MEMORY // MIB,
        show_default=True,
        metavar="MIB",
        help="What all that waits in a capture may take, such as commands without a reply; the oldest goes first.",
    ),
)


def reading_options(command: F) -> F:
    """Adds the options on how to read captures to a command, which gets them as one argument, `reading`."""

    @functools.wraps(command)
    def called(
        *arguments: Any,
        dialect: str,
        ports: tuple[int, ...],
        engine: str,
        tshark: str | None,
        chosen: Filter | None,
        no_length: bool,
        only_operations: bool,
        memory: int,
        **others: Any,
    ) -> Any:
        if no_length and only_operations:
            raise click.UsageError("--no-length has the rest of a header and --operations none: give one or the other")
        missing: Missing | None = "length" if no_length else "header" if only_operations else None
        reading = CaptureOptions(dialect, ports, engine, tshark, chosen, missing, memory)
        return command(*arguments, reading=reading, **others)

    for option in reversed(_OPTIONS):
        option(called)
    return called  # type: ignore[return-value]


def _looked_at(events: Iterable[Event], look: Callable[[Event], None]) -> Iterator[Event]:
    for event in events:
        look(event)
        yield event
