"""`ev3proto decode`: frames in any form, captures and programs, as tree, table, assembly or JSON."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from typing import TYPE_CHECKING

import click

from ev3proto.cli.inputs import Content, Frame, Inputs, Takes, Whole
from ev3proto.cli.options import incompatible
from ev3proto.cli.output import complain
from ev3proto.cli.reading import MIB, CaptureOptions, given_up, reading_options
from ev3proto.cli.show import FORMATS, Show
from ev3proto.cli.words import Source, sources
from ev3proto.dialogue import Dialogue
from ev3proto.messages import DirectCommand, Message, Operation
from ev3proto.schema.frame import parse
from ev3proto.tables.declaration import Effect
from ev3proto.text.phrases import Seen, command_spans
from ev3proto.text.spans import plain_text

if TYPE_CHECKING:
    from ev3proto.checking.report import Suggestion
    from ev3proto.cli.captures import CaptureSource


PROGRAM_FORMATS = ("listing",)
"""Formats for programs only."""


class Decoding:
    """Shows what the inputs have."""

    def __init__(self, show: Show, inputs: Inputs, *, as_dialogues: bool = False, as_programs: bool = False) -> None:
        self.inputs = inputs
        self._show = show
        self._as_dialogues = as_dialogues
        self._as_programs = as_programs
        self._dialogue = Dialogue(inputs.reading.memory * MIB)

    def run(self) -> None:
        """Shows everything."""
        for content in self.inputs:
            self.take(content)
        if self._dialogue.forgotten:
            complain(given_up("the input", self._dialogue.forgotten, self.inputs.reading.memory))

    def take(self, content: Content) -> None:
        """Shows one thing."""
        if isinstance(content, Frame):
            self.frame(content)
        elif isinstance(content, Whole):
            self.program(content.source, content.data)
        else:
            self.capture(content)

    def capture(self, capture: CaptureSource) -> None:
        """Shows the frames and texts of a capture, its dialogues, or the programs that it transfers."""
        from ev3proto.cli.recorded import moved_programs, show_capture  # takes 13 ms, which frames do not need

        before = self._show.count
        if self._as_programs:
            for origin, image in moved_programs(capture, self.inputs.complain):
                self._shown(origin, origin, image)
        else:
            for record in show_capture(self._show, capture, as_dialogues=self._as_dialogues):
                fault = record.message.fault
                if fault is not None:
                    self.inputs.complain(f"{capture.where(record.number)}: fault at {fault}")
        capture.taken = self._show.count - before

    def program(self, source: Source, image: bytes) -> None:
        """Shows a program image."""
        if self._as_programs:
            raise click.UsageError(f"--programs is for captures, but {source.label[:60]} is a program itself")
        self._shown(source.label, None, image)

    def _shown(self, label: str, origin: str | None, image: bytes) -> None:
        """Shows a program: its name in messages, its origin if that is to be shown, its image."""
        from ev3proto.cli.programs import read_program  # takes 58 ms, which frames do not need

        program = read_program(label, image, self.inputs.reading.dialect)
        if program is None:
            self.inputs.at_fault = True
            return
        self._show.program(program, image, origin)
        for fault in program.faults:
            self.inputs.complain(f"{label}: fault at {fault}")

    def frame(self, frame: Frame) -> None:
        """Shows a frame of a text."""
        fault, pasted, is_cut, seen = frame.message.fault, frame.pasted, frame.is_cut, Seen()
        if pasted is not None:
            unknown = frozenset([one.offset - frame.start for one in pasted.unknown])
            seen = Seen(pasted.direction, pasted.time, is_cut, unknown=unknown)
        self._show.exchange(self._dialogue.follow(frame.message), seen, frame.rest)
        never, dialect = _never_run(frame.message), self.inputs.reading.dialect
        if fault is not None and not is_cut:
            meant = [f"; did you mean: {one.message}?" for one in _meant(frame.message, dialect)]
            self.inputs.complain(f"{frame.place}: fault at {fault}{''.join(meant)}")
        elif frame.is_from_brick and seen.direction is None:
            # A command without its counter is a reply by its type.
            for one in _meant(frame.message, dialect):
                content = plain_text(command_spans(parse(one.frame, strict=False, dialect=dialect)))
                complain(f"{frame.place}: did you mean {content}? {one.message}")
        elif never is not None:
            said = f"offset {never.offset}: opcode 0x{never.opcode:02X} is {never.name}, which the brick refuses"
            self.inputs.complain(f"{frame.place}: {said}; `ev3proto check` says more")


def _meant(message: Message, dialect: str) -> Iterator[Suggestion]:
    """Yields what was probably meant by a frame that has a fault, or is not the reply that it seems to be."""
    from ev3proto.checking.checking import check  # takes 15 ms, which right frames do not need

    yield from check(message, dialect=dialect, alone=True).nearest


def _never_run(message: Message) -> Operation | None:
    """Returns the first operation of a command that no brick runs: bytes of something else look like that."""
    operations = message.operations if isinstance(message, DirectCommand) else ()
    never = (each for each in operations if Effect.NEVER_RUNS in each.schema.declaration.effects)
    return next(never, None)


@click.command()
@click.argument("names", nargs=-1, metavar="[FRAME|FILE|-]...")
@click.option(
    "--format",
    "style",
    type=click.Choice((*FORMATS, *PROGRAM_FORMATS)),
    help="How to show messages (default: tree) and programs (default: listing); `encode` reads asm, lego and json.",
)
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object a line, as --format json.")
@click.option("--dialogues", "as_dialogues", is_flag=True, help="Print a line for each command with its reply.")
@click.option(
    "--programs", "as_programs", is_flag=True, help="Show the programs that a capture transfers, not its frames."
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
    """Shows the contents of frames, captures and programs.

    The input is frames, files with frames in their lines, captures (pcap, pcapng, btsnoop, also gzipped), programs
    (.rbf), or - (or nothing) for standard input. Frames can be written in many forms: log lines with times, hex with or
    without spaces and colons, C arrays, Python byte strings.

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
        raise incompatible("--dialogues", "--programs")
    if style not in (None, "json"):
        if as_json:
            raise incompatible("--json", f"--format {style}")
        if as_dialogues:
            raise incompatible("--dialogues", f"--format {style}")
    show = Show("json" if as_json else style)
    takes = Takes(wanted="program" if as_programs else "frame", programs=True, as_capture=as_dialogues or as_programs)
    inputs = Inputs(sources(names), reading, takes)
    Decoding(show, inputs, as_dialogues=as_dialogues, as_programs=as_programs).run()
    sys.exit(1 if inputs.at_fault else 0)
