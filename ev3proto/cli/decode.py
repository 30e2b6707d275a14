"""`ev3proto decode`: frames in any form, captures and programs, in every format."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import click

from ev3proto.capture.record import Announcement, Record
from ev3proto.cli.formats import OUTPUT_FORMATS, Format, made
from ev3proto.cli.options import exclusive
from ev3proto.cli.reading import Captured, Problems, named, parts_of, reading_options
from ev3proto.cli.show import Dialogues, matching
from ev3proto.reading.faults import Faults
from ev3proto.reading.items import Event, Image, Source
from ev3proto.reading.options import Options, Sources
from ev3proto.reading.parts import Part, Reading

if TYPE_CHECKING:
    from ev3proto.capture.filter import Filter


class _Decoding:
    def __init__(self, show: Format, reading: Reading) -> None:
        self._show = show
        self._reading = reading
        self._dialect = reading.options.dialect
        self._faults = Faults(self._dialect)
        self.problems = Problems()

    def messages(self) -> None:
        """Shows messages, the texts around them, and programs."""
        is_filtered = self._reading.options.filter is not None
        for event in self._beside_images(self._reading.events()):
            start_ns = self._reading.part.account.first_ns or 0
            if isinstance(event, Announcement):
                self._show.announcement(event, start_ns)
            elif isinstance(event, Record):
                is_text = event.written is not None and not is_filtered
                self._show.record(event, None if is_text else start_ns)
                self._complain_of(event, is_text=is_text)

    def dialogues(self, chosen: Filter | None) -> None:
        """Shows each command with its reply, if the two match the filter."""
        dialogues = Dialogues(self._show)
        for part in self._parts(chosen):
            for pair in matching(self._beside_images(part), chosen, part):
                dialogues.show(pair, part.account.first_ns or 0)
                for record in filter(None, pair):
                    self._complain_of(record)
            dialogues.end()

    def programs(self) -> None:
        """Shows the programs that captures transfer."""
        from ev3proto.cli.programs import moved_programs  # takes 58 ms, which frames do not need

        for part in self._parts():
            for origin, image in moved_programs(self._captured(part), part, self.problems):
                self._image(origin, image, origin)

    def _parts(self, chosen: Filter | None = None) -> Iterator[Part]:
        return parts_of(self._reading, self.problems, lambda: self._show.count, lambda part: part.nothing(chosen))

    def _beside_images(self, events: Iterable[Event]) -> Iterator[Event]:
        for event in self.problems.beside(events):
            if isinstance(event, Image):
                self._image(event.place.name, event.data)
            else:
                yield event

    def _captured(self, events: Iterable[Event]) -> Iterator[Captured]:
        """Yields what is in a capture, which must not be a program itself."""
        for event in self.problems.beside(events):
            if isinstance(event, Image):
                name = event.place.name[:60]
                raise click.UsageError(f"--programs is for captures, but {name} is a program itself")
            if not isinstance(event, Source):
                yield event

    def _image(self, label: str, image: bytes, origin: str | None = None) -> None:
        """Shows a program: its name in messages, its image, its origin if that is to be shown."""
        from ev3proto.cli.programs import read_program  # takes 58 ms, which frames do not need

        program = read_program(label, image, self._dialect)
        if program is None:
            self.problems.errors += 1
            return
        self._show.program(program, image, origin)
        for fault in program.faults:
            self.problems.wrong(f"{label}: fault at {fault}")

    def _complain_of(self, record: Record, *, is_text: bool = False) -> None:
        fault = self._faults.of(record, is_text=is_text)
        if fault is not None:
            self.problems.show(fault)


class _Decode(click.Command):
    """The command, with the formats of captures in its help."""

    def format_help_text(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Writes what it does."""
        from ev3proto.capture.formats import LISTED  # takes 9 ms, which frames do not need

        assert self.help is not None
        self.help = self.help.replace("{captures}", LISTED)
        super().format_help_text(ctx, formatter)


@click.command(cls=_Decode)
@click.argument("names", nargs=-1, metavar="[FRAME|FILE|-]...")
@click.option(
    "--format",
    "style",
    type=click.Choice(tuple(OUTPUT_FORMATS)),
    help="How to show messages (default: tree) and programs (default: listing); `encode` reads asm, lego and json.",
)
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object a line, as --format json.")
@click.option("--dialogues", "as_dialogues", is_flag=True, help="Print a line for each command with its reply.")
@click.option(
    "--programs", "as_programs", is_flag=True, help="Show the programs that a capture transfers, not its frames."
)
@reading_options
@exclusive("--dialogues", "--programs")
@exclusive("--json", "--format!json")
@exclusive("--dialogues", "--format!json")
def decode(
    names: tuple[str, ...],
    style: str | None,
    as_json: bool,
    as_dialogues: bool,
    as_programs: bool,
    reading: Options,
) -> None:
    """Shows the contents of frames, captures and programs.

    The input is frames, files with frames in their lines, captures ({captures}; gzipped or not), programs (.rbf), or -
    (or nothing) for standard input. Frames can be written in many forms: log lines with times, hex with or without
    spaces and colons, C arrays, Python byte strings.

    \b
      ev3proto decode "0x|0E:00|2A:00|80|00:00|94|01|01|82:B8:01|82:E8:03|"
      ev3proto decode 0e 00 2a 00 80 00 00 94 01 01 82 b8 01 82 e8 03
      ev3proto decode --format table robot.log
      ev3proto decode --format csv robot.pcapng > robot.csv
      ev3proto decode --format lego robot.log
      ev3proto decode --dialogues --filter 'op==SOUND && VOLUME>1' robot.pcapng
      ev3proto decode --format lego robot.rbf
      ev3proto decode --programs robot.pcapng
      python3 my_program.py | ev3proto decode --json
    """  # noqa: D301 - the mark by which click leaves lines as they are
    chosen, options = reading.filter, replace(reading, sources=Sources.NO)
    if as_dialogues:
        options = replace(options, filter=None)
    if as_programs:
        options = replace(options, wanted="program")
    decoding = _Decoding(made("json" if as_json else style), Reading(named(names), options))
    if as_programs:
        decoding.programs()
    elif as_dialogues:
        decoding.dialogues(chosen)
    else:
        decoding.messages()
    sys.exit(decoding.problems.status)
