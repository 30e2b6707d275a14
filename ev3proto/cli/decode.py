"""`ev3proto decode`: frames in any form people have them, or a capture, told in words, as table, assembly or JSON."""

from __future__ import annotations

import codecs
import io
import re
import sys
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ev3proto.cli.captures import BUILTIN, CaptureOptions, CaptureSource, reading_options
from ev3proto.cli.output import complain
from ev3proto.cli.show import FORMATS, Show
from ev3proto.dialogue import Dialogue
from ev3proto.text.heading import Seen
from ev3proto.text.notation import MAX_LINE, Pasted, read_argument, read_text
from ev3proto.text.split import Piece, split

if TYPE_CHECKING:
    from ev3proto.capture import Event
    from ev3proto.capture.formats import CaptureFile

_START = 8

_GROUP = re.compile(r"(0x)?([0-9a-f]{2}:?){1,4},?", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class Source:
    """One thing that was named on the command line: a file, standard input, or a frame itself."""

    name: str
    is_frame: bool

    @property
    def label(self) -> str:
        """How people call it."""
        return "standard input" if self.name == "-" else self.name

    def open(self) -> io.BufferedReader:
        """The bytes of a file or of standard input. Raises OSError when there are none to read."""
        if self.name != "-":
            return Path(self.name).open("rb")
        if sys.stdin is None:
            raise OSError("standard input is closed")
        assert isinstance(sys.stdin.buffer, io.BufferedReader)
        return sys.stdin.buffer

    def where(self, pasted: Pasted) -> str:
        """How a complaint about it starts."""
        if self.is_frame:
            return f"{self.name[:60]!r}" + ("" if pasted.data else " is no file and no frame")
        return f"{self.label}, line {pasted.line}"


def _lines(stream: io.BufferedReader[Any]) -> Iterator[str]:
    """The lines of a file, those that are too long only as far as it takes to see that.

    Text is UTF-8, or UTF-16 where the file starts with that mark, as PowerShell writes it.
    """
    start = stream.peek(2)[:2]
    encoding = "utf-16" if start in (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE) else "utf-8-sig"
    text = io.TextIOWrapper(stream, encoding, "replace")
    while line := text.readline(MAX_LINE + 1):
        yield line
        while len(line) > MAX_LINE and not line.endswith("\n"):
            line = text.readline(MAX_LINE + 1)


def _sources(names: tuple[str, ...]) -> list[Source]:
    """What was named; bytes that were typed without quotes around them are one frame."""
    if len(names) > 1 and all(_GROUP.fullmatch(name) for name in names):
        return [Source(" ".join(names), is_frame=True)]
    return [Source(name, is_frame=name != "-" and (not name or not _exists(name))) for name in names or ("-",)]


def _exists(name: str) -> bool:
    try:
        return Path(name).exists()
    except (OSError, ValueError):
        return False


class Decoding:
    """Shows what the sources have, one after the other, and remembers whether any was at fault."""

    def __init__(self, show: Show, reading: CaptureOptions, *, as_dialogues: bool) -> None:
        self._show = show
        self._reading = reading
        self._as_dialogues = as_dialogues
        self._dialogue = Dialogue()
        self.at_fault = False

    def source(self, source: Source) -> None:
        """Everything in a source; a sentence where it cannot be read."""
        if source.is_frame:
            self._refuse_for_text(source)
            self._pasted(read_argument(source.name), source)
            return
        file = self._opened(source)
        if file is None:
            return
        with file:
            if self._reading.engine != BUILTIN or self._is_capture(source, file):
                self._capture(source, file)
            else:
                self._refuse_for_text(source)
                start = file.contents.peek(_START)[:_START]
                if _is_binary(start):
                    self._complain(
                        f"{source.label}: neither text nor a capture: it starts with {start.hex(' ').upper()}; captures"
                        " are pcap, pcapng or btsnoop files, packed with gzip or not"
                    )
                    return
                for pasted in self._readable(source, read_text(_lines(file.contents))):
                    self._pasted(pasted, source)

    def _refuse_for_text(self, source: Source) -> None:
        if self._as_dialogues or self._reading.filter is not None:
            raise click.UsageError(f"--dialogues and --filter are for captures, and {source.label[:60]} is none")

    def _opened(self, source: Source) -> CaptureFile | None:
        from ev3proto.capture.formats import CaptureFile

        try:
            return CaptureFile(source.open(), is_ours=source.name != "-")
        except OSError as error:
            self._unreadable(source, error)
            return None

    def _is_capture(self, source: Source, file: CaptureFile) -> bool:
        """Whether it is a capture; a damaged gzip is told as one."""
        from ev3proto.capture import CaptureError

        try:
            return file.is_capture
        except CaptureError:
            return True
        except OSError as error:
            self._unreadable(source, error)
            return False

    def _readable(self, source: Source, pasted: Iterator[Pasted]) -> Iterator[Pasted]:
        try:
            yield from pasted
        except (OSError, EOFError, zlib.error) as error:
            self._unreadable(source, error)

    def _unreadable(self, source: Source, error: Exception) -> None:
        self._complain(f"{source.label}: cannot be read: {getattr(error, 'strerror', None) or error}")

    def _complain(self, sentence: str) -> None:
        complain(sentence)
        self.at_fault = True

    def _capture(self, source: Source, stream: CaptureFile) -> None:
        from ev3proto.capture import Announcement, Record
        from ev3proto.capture.dialogues import dialogues

        capture = CaptureSource(source.name, self._reading)
        events = capture.events(stream if self._reading.engine == BUILTIN else None, is_quiet=False)
        if self._as_dialogues:
            for spoken in dialogues(self._faults(source, events)):
                self._show.dialogue(spoken, capture.account.first_ns or 0)
        else:
            for event in self._faults(source, events):
                if isinstance(event, Announcement):
                    self._show.announcement(event, capture.account.first_ns or 0)
                elif isinstance(event, Record):
                    self._show.record(event, capture.account.first_ns or 0)
        if not capture.status and not self._show.count:
            what = "nothing that the filter lets through" if self._reading.filter else "no frame"
            self._complain(f"{source.label}: there is {what} in {_packets(capture.account.packets)}")
        self.at_fault |= bool(capture.status)

    def _faults(self, source: Source, events: Iterator[Event]) -> Iterator[Event]:
        """The same events; faulty frames are complained about."""
        from ev3proto.capture import Record

        for event in events:
            yield event
            if isinstance(event, Record) and event.message.fault is not None:
                self._complain(f"{source.label}, packet {event.number}: fault at {event.message.fault}")

    def _pasted(self, pasted: Pasted, source: Source) -> None:
        """Everything in one piece of pasted text."""
        where = source.where(pasted)
        if pasted.problem is not None:
            self._complain(f"{where}: {pasted.problem}")
        if pasted.data:
            for piece in split(pasted.data, dialect=self._reading.dialect):
                self._piece(piece, pasted, where)

    def _piece(self, piece: Piece, pasted: Pasted, where: str) -> None:
        fault = piece.message.fault
        cut = pasted.cut and fault is not None and fault.truncated
        seen = Seen(pasted.direction, pasted.time, cut)
        self._show.exchange(self._dialogue.follow(piece.message), seen, piece.padding)
        if fault is not None and not cut:
            self._complain(f"{where}: fault at {fault}")


def _is_binary(start: bytes) -> bool:
    """Whether bytes are no text: it has no control characters but those that break lines, or is UTF-16."""
    if start.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return False
    return any(byte < ord(" ") and byte not in b"\t\n\r\f\x1b" for byte in start)


def _packets(count: int) -> str:
    return f"{count} packet{'s' * (count != 1)}"


@click.command()
@click.argument("sources", nargs=-1, metavar="[FRAME|FILE|-]...")
@click.option(
    "--format", "style", type=click.Choice(FORMATS), default="tree", show_default=True, help="How to show messages."
)
@click.option("--json", "as_json", is_flag=True, help="One JSON object a line: the same as --format json.")
@click.option(
    "--dialogues", "as_dialogues", is_flag=True, help="Of a capture: a line for each command, with its reply and time."
)
@reading_options
def decode(sources: tuple[str, ...], style: str, as_json: bool, as_dialogues: bool, reading: CaptureOptions) -> None:
    """Tells what frames say.

    Give frames themselves, files that have them in their lines, captures (pcap, pcapng, btsnoop, packed with gzip or
    not), or - (or nothing) for standard input. Any form will do: log lines with their times, hex with or without spaces
    and colons, C arrays, Python byte strings.

    \b
      ev3proto decode "0x|0E:00|2A:00|80|00:00|94|01|01|82:B8:01|82:E8:03|"
      ev3proto decode 0e 00 2a 00 80 00 00 94 01 01 82 b8 01 82 e8 03
      ev3proto decode --format table robot.log
      ev3proto decode --dialogues --filter 'op==SOUND.TONE && FREQUENCY>400' robot.pcapng
      python3 my_program.py | ev3proto decode --json
    """  # noqa: D301 - the mark by which click leaves lines as they are
    show = Show("json" if as_json else style)
    decoding = Decoding(show, reading, as_dialogues=as_dialogues)
    for source in _sources(sources):
        decoding.source(source)
    if not show.count:
        if not decoding.at_fault:
            complain("there is no frame in the input: frames are written in hex, such as 06:00|2A:00|80|00:00|01")
        decoding.at_fault = True
    sys.exit(1 if decoding.at_fault else 0)
