"""`ev3proto encode`: assembly, JSON or frames in any form, to frames in the format of another program."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, BinaryIO

import click

from ev3proto.capture.record import Record
from ev3proto.checking.checking import check
from ev3proto.checking.codes import NOT_TWO_MOTORS
from ev3proto.cli.options import PATH, Whole, gathered, given_options, incompatible, reply_option
from ev3proto.cli.output import complain, failing_to, output_to, refuse_terminal, say
from ev3proto.cli.reading import Problems, made_of, named, reading_options
from ev3proto.dialogue import Dialogue
from ev3proto.messages import DirectCommand, Message
from ev3proto.reading.items import Source
from ev3proto.reading.options import Options, Sources
from ev3proto.reading.parts import Reading
from ev3proto.tables.declaration import Effect
from ev3proto.tables.frame import COUNTERS
from ev3proto.text.assembly.disassembly import assembly
from ev3proto.text.forms import as_c, as_hex, as_python
from ev3proto.text.json_format.from_messages import record
from ev3proto.text.phrases import Seen, heading
from ev3proto.text.spans import plain_text

RBF, SUFFIX = "rbf", ".rbf"
"""The format of programs: their images."""


def _assembly(message: Message, dialogue: Dialogue, notation: str) -> str:
    exchange = dialogue.follow(message)
    return "\n".join(assembly(exchange, plain_text(heading(exchange, Seen())), notation))


RAW = "raw"
FORMS: dict[str, Callable[[Message, int, Dialogue], str | bytes]] = {
    "hex": lambda message, _number, _dialogue: as_hex(message),
    RAW: lambda message, _number, _dialogue: message.build(),
    "c": lambda message, number, _dialogue: as_c(message, f"frame_{number}"),
    "python": lambda message, number, _dialogue: as_python(message, f"frame_{number}"),
    "json": lambda message, _, dialogue: json.dumps(record(dialogue.follow(message), Seen()), ensure_ascii=False),
    "asm": lambda message, _number, dialogue: _assembly(message, dialogue, "asm"),
    "lego": lambda message, _number, dialogue: _assembly(message, dialogue, "lego"),
}
"""The formats of frames: functions of the message, its number from 1 on, and the dialogue so far."""


@dataclass(frozen=True, slots=True)
class Making:
    """How messages are made of assembly; without `reply`, those want one whose operations return values."""

    counter: int = 0
    reply: bool | None = None
    unchecked: bool = False


@dataclass(frozen=True, slots=True)
class Building:
    """How the image of a program is made of its source: without a dialect all are tried."""

    source_dialect: str | None = None
    version: int | None = None
    shortest: bool = False

    @property
    def is_given(self) -> bool:
        """Whether any of these was asked for."""
        return self != Building()


def encoded(
    names: Sequence[str], options: Options, making: Making, problems: Problems, *, faults: bool = True
) -> Iterator[Message]:
    """Yields the messages that words name, also assembly and JSON, and faulty ones unless they are cut off."""
    counter = making.counter
    reading = Reading(named(names), replace(options, sources=Sources.FIRST, images=False))
    for event in problems.beside(reading):
        if isinstance(event, Source):
            for record in made_of(event, reading, problems, **asdict(replace(making, counter=counter))):
                yield record.message
                counter = (record.message.counter + 1) % COUNTERS
        elif isinstance(event, Record) and event.missing:
            problems.wrong(f"{event.place}: cannot encode a frame that is cut off after {len(event.frame)} bytes")
        elif isinstance(event, Record):
            yield event.message
            if faults and event.is_pasted and event.message.fault is not None:
                problems.wrong(f"{event.place}: fault at {event.message.fault}")


class _Version(click.ParamType):
    """The version of an image: a 16-bit number, decimal or hexadecimal."""

    name = "number"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> int:
        """Returns the number."""
        try:
            number = int(str(value)[:20], 0)
        except ValueError:
            number = -1
        if not 0 <= number <= 0xFFFF:
            expected = "expected a whole number from 0 to 65535, such as 0x6D"
            self.fail(f"invalid version {str(value)[:20]}; {expected}", param, ctx)
        return number


@click.command()
@click.argument("names", nargs=-1, metavar="[TEXT|FILE|-]...")
@click.option(
    "--to",
    "form",
    type=click.Choice((*FORMS, RBF)),
    help="Format of the output (default: hex); rbf is the image of a program, as for -o FILE.rbf.",
)
@click.option("-o", "--output", "path", type=PATH, metavar="FILE", help="Write to this file, not standard output.")
@gathered(
    Making,
    "making",
    click.option(
        "--counter",
        type=Whole(0, COUNTERS - 1),
        default=0,
        show_default=True,
        metavar="NUMBER",
        help="Message counter of the first assembled message that states none.",
    ),
    reply_option,
    click.option(
        "--unchecked", is_flag=True, help="Accept values that mean nothing to the brick, such as motor port 16."
    ),
)
@gathered(
    Building,
    "building",
    click.option(
        "--source",
        "source_dialect",
        type=click.Choice(("strict", "lego", "basic")),
        help="Dialect of a program's source; by default strict, LEGO's own and EV3 Basic's are tried.",
    ),
    click.option("--version", "version", type=_Version(), metavar="NUMBER", help="Version of a program's image."),
    click.option("--shortest", is_flag=True, help="Shorten a program's labels, and share the code of equal objects."),
)
@reading_options
def encode(
    names: tuple[str, ...], form: str | None, path: Path | None, making: Making, building: Building, reading: Options
) -> None:
    """Builds frames from assembly, JSON or other notations, and programs from their sources.

    The input is assembly, objects as `decode --json` prints them, frames in any form that decode reads, captures, files
    with any of these, or - (or nothing) for standard input. The first line of a text decides what it is.

    \b
      ev3proto encode 'SOUND(TONE, 1, 440, 1000)'
      ev3proto encode 'opSOUND, LC0(TONE), LC0(1), LC2(440), LC2(1000)' --to c
      ev3proto encode 'OUTPUT_POWER(0, A+B, 50)' 'OUTPUT_START(0, A+B)'
      ev3proto encode robot.lms -o robot.rbf
      ev3proto encode --counter 42 --to raw -o tone.bin tone.lms
      ev3proto decode --json robot.log | jq -c '.counter = 7' | ev3proto encode
      ev3proto decode --format asm robot.pcapng > robot.asm
      ev3proto encode robot.asm
    """  # noqa: D301 - the mark by which click leaves lines as they are
    if form == RBF or (form is None and (building.is_given or (path is not None and path.suffix.lower() == SUFFIX))):
        sys.exit(_program(names, path, building))
    if building.is_given:
        raise click.UsageError("--source, --version and --shortest are for programs; add --to rbf or -o FILE.rbf")
    if form == RAW:
        refuse_terminal(path, "raw bytes", "them")
    problems = Problems()
    with failing_to("written", path), output_to(path) as stream:
        _write(encoded(names, reading, making, problems), form or "hex", stream, is_printed=path is None)
    sys.exit(problems.status)


def _write(messages: Iterator[Message], form: str, stream: BinaryIO, *, is_printed: bool) -> None:
    """Writes messages in a format to a file or standard output. Ends the program without any; a file stays then."""
    dialogue, number = Dialogue(), 0
    for number, message in enumerate(messages, 1):
        _tell_of_pairs(message)
        data = FORMS[form](message, number, dialogue)
        if is_printed and isinstance(data, str):
            say(data)
        else:
            stream.write(data if isinstance(data, bytes) else f"{data}\n".encode())
    if not number:
        sys.exit(1)


def _tell_of_pairs(message: Message) -> None:
    """Tells that two motors are turned in step, if other numbers are named: nothing else that is built is unknown."""
    operations = message.operations if isinstance(message, DirectCommand) else ()
    if any(Effect.SYNCHRONIZES in one.declaration.effects for one in operations):
        for finding in check(message.build()).findings:
            if finding.code == NOT_TWO_MOTORS.code:
                complain(f"note: {finding.message}; {finding.help}")


def _program(names: Sequence[str], path: Path | None, building: Building) -> int:
    from ev3proto.cli.programs import encode_program  # takes 38 ms, which frames do not need

    names_of_frames = ("--counter", "--reply", "--no-reply", "--unchecked", "--filter", "--no-length", "--operations")
    about_frames = given_options(*names_of_frames)
    if about_frames:
        raise incompatible(", ".join(about_frames), "--to rbf or -o FILE.rbf")
    return encode_program(named(names), path, **asdict(building))
