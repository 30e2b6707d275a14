"""`ev3proto decode`: frames in any form, or a capture, as words, table, assembly or JSON."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

import click

from ev3proto.cli.captures import MIB, CaptureOptions, CaptureSource, given_up, reading_options
from ev3proto.cli.output import complain
from ev3proto.cli.programs import PROGRAM_FORMATS, is_image, read_program
from ev3proto.cli.show import FORMATS, Show
from ev3proto.cli.sources import Source, SourceReader, sources
from ev3proto.dialogue import Dialogue
from ev3proto.text.heading import Seen
from ev3proto.text.paste import Pasted
from ev3proto.text.split import Piece
from ev3proto.text.visible import visible

if TYPE_CHECKING:
    from ev3proto.capture import Record
    from ev3proto.capture.files import RecoveredFile

_SIGN = 4
"""Bytes at the start of a file by which a program is recognized."""


class Decoding(SourceReader):
    """Shows what the sources have, one after the other, and remembers whether any was at fault."""

    def __init__(self, show: Show, reading: CaptureOptions, *, as_dialogues: bool, as_programs: bool) -> None:
        super().__init__(reading)
        self._show = show
        self._as_dialogues = as_dialogues
        self._as_programs = as_programs
        if as_programs:
            self.wanted = "program"
        self._dialogue = Dialogue(reading.memory * MIB)

    @property
    def wants_records(self) -> bool:
        """--dialogues and --programs read the frames of a text as a capture, too."""
        return self._as_dialogues or self._as_programs or super().wants_records

    def capture(self, capture: CaptureSource) -> int:
        """Its frames and texts, or its dialogues."""
        from ev3proto.capture import Announcement, Record

        before = self._show.count
        if self._as_programs:
            self._moved_programs(capture)
        elif self._as_dialogues:
            for pair in capture.dialogues():
                self._show.dialogue(pair, capture.account.first_ns or 0)
                for record in pair:
                    if record is not None:
                        self._fault(record, capture)
        else:
            show = self._show
            for event in capture.events():
                if isinstance(event, Record):
                    if show.record(event, capture.account.first_ns or 0) is not None:
                        self._fault(event, capture)
                elif isinstance(event, Announcement):
                    show.announcement(event, capture.account.first_ns or 0)
        return self._show.count - before

    def _moved_programs(self, capture: CaptureSource) -> None:
        """The programs that a capture moves to or from the brick, as far as they were captured."""
        from ev3proto.capture import CaptureError
        from ev3proto.capture.files import recover
        from ev3proto.temporary import temporary_folder

        with temporary_folder() as folder:
            found: list[RecoveredFile] = []
            try:
                # One by one, so that what was found stays when the capture comes to a bad end.
                found += recover(capture.events(), folder)
            except CaptureError as error:
                self.complain(f"{capture.label}: {error}")
            except OSError as error:
                self.complain(f"the programs cannot be written to {folder}: {error.strerror or error}")
            for file in found:
                image = b"" if file.file is None else file.file.read_bytes()
                if is_image(image[:_SIGN]):
                    origin = f"{capture.label}, {capture.unit} {file.packets[0]}: {visible(file.path)}"
                    self._shown(origin, origin, image)

    def _fault(self, record: Record, capture: CaptureSource) -> None:
        """Complains about a frame that is faulty."""
        if record.message.fault is not None:
            self.complain(f"{capture.label}, {capture.unit} {record.number}: fault at {record.message.fault}")

    def program(self, source: Source, image: bytes) -> None:
        """A program image, in the format that was asked for."""
        if self._as_programs:
            raise click.UsageError(f"--programs finds programs in captures, and {source.label[:60]} is one itself")
        self._shown(source.label, None, image)

    def _shown(self, label: str, origin: str | None, image: bytes) -> None:
        """A program: what complaints call it, and where it comes from if that is to be shown."""
        program = read_program(label, image, self.reading.dialect)
        if program is None:
            self.at_fault = True
            return
        self._show.program(program, image, origin)
        for fault in program.faults:
            self.complain(f"{label}: fault at {fault}")

    def piece(self, piece: Piece, pasted: Pasted, source: Source) -> None:
        """A frame of a text."""
        fault = piece.message.fault
        cut = pasted.cut and fault is not None and fault.truncated
        seen = Seen(pasted.direction, pasted.time, cut)
        self._show.exchange(self._dialogue.follow(piece.message), seen, piece.padding)
        if fault is not None and not cut:
            self.complain(f"{source.where(pasted)}: fault at {fault}")

    def say_what_was_given_up(self) -> None:
        """Complains where commands of a text waited for their replies no longer."""
        if self._dialogue.forgotten:
            complain(given_up("the input", self._dialogue.forgotten, self.reading.memory))


@click.command()
@click.argument("names", nargs=-1, metavar="[FRAME|FILE|-]...")
@click.option(
    "--format",
    "style",
    type=click.Choice((*FORMATS, *PROGRAM_FORMATS)),
    help="How to show messages (tree, unless you say otherwise) and programs (listing); encode reads asm, lego, json.",
)
@click.option("--json", "as_json", is_flag=True, help="One JSON object a line: the same as --format json.")
@click.option("--dialogues", "as_dialogues", is_flag=True, help="A line for each command, with its reply and time.")
@click.option(
    "--programs", "as_programs", is_flag=True, help="Of a capture: the programs that it moves, in place of its frames."
)
@reading_options
def decode(
    names: tuple[str, ...],
    style: str | None,
    as_json: bool,
    as_dialogues: bool,
    as_programs: bool,
    reading: CaptureOptions,
) -> None:
    """Shows what frames and programs say.

    Give frames themselves, files that have them in their lines, captures (pcap, pcapng, btsnoop, packed with gzip or
    not), programs (.rbf), or - (or nothing) for standard input. Any form of frames will do: log lines with their times,
    hex with or without spaces and colons, C arrays, Python byte strings.

    \b
      ev3proto decode "0x|0E:00|2A:00|80|00:00|94|01|01|82:B8:01|82:E8:03|"
      ev3proto decode 0e 00 2a 00 80 00 00 94 01 01 82 b8 01 82 e8 03
      ev3proto decode --format table robot.log
      ev3proto decode --format lego robot.log
      ev3proto decode --dialogues --filter 'op==SOUND && VOLUME>1' robot.pcapng
      ev3proto decode --format lego robot.rbf
      ev3proto decode --programs robot.pcapng
      python3 my_program.py | ev3proto decode --json
    """  # noqa: D301 - the mark by which click leaves lines as they are
    if as_dialogues and as_programs:
        raise click.UsageError("--dialogues shows frames and --programs what they move: give one or the other")
    if style not in (None, "json"):
        if as_json:
            raise click.UsageError(f"--json is one form of output and --format {style} another: give one or the other")
        if as_dialogues:
            raise click.UsageError(
                f"--dialogues has a line a command and --format {style} none: omit it, or give --json"
            )
    show = Show("json" if as_json else style, dialect=reading.dialect)
    decoding = Decoding(show, reading, as_dialogues=as_dialogues, as_programs=as_programs)
    decoding.read_all(sources(names))
    decoding.say_what_was_given_up()
    sys.exit(1 if decoding.at_fault else 0)
