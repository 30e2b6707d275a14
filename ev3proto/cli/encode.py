"""`ev3proto encode`: assembly, JSON or frames in any form, to frames in the format of another program."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

import click

from ev3proto.cli.assembly import assembled_messages
from ev3proto.cli.captures import CaptureSource
from ev3proto.cli.inputs import Frame, Inputs, Making, Takes
from ev3proto.cli.options import Whole, given_options, incompatible, reply_option
from ev3proto.cli.output import failing_to, output_to, refuse_terminal, say
from ev3proto.cli.reading import CaptureOptions, reading_options
from ev3proto.cli.words import Source, sources
from ev3proto.dialogue import Dialogue
from ev3proto.messages import Message
from ev3proto.schema.frame import parse
from ev3proto.tables.frame import COUNTERS
from ev3proto.text.assembly.disassembly import assembly
from ev3proto.text.assembly.recognising import OBJECT, is_assembly
from ev3proto.text.forms import as_c, as_hex, as_python
from ev3proto.text.json_format.from_messages import record
from ev3proto.text.json_format.to_messages import RecordError, frames_in, read_records
from ev3proto.text.phrases import Seen, heading
from ev3proto.text.spans import plain_text

_TAKES = Takes(
    nothing="nothing to encode; expected assembly such as SOUND(TONE, 1, 440, 1000), objects as `decode --json` prints"
    " them, or frames in hex such as 06:00|2A:00|80|00:00|01",
    argument="nor assembly nor a frame",
    accepted="what can be encoded is assembly, JSON, frames in hex, or a capture",
    makes_first=True,
)

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


def inputs_for(
    names: Sequence[str],
    reading: CaptureOptions,
    *,
    counter: int = 0,
    reply: bool | None = None,
    unchecked: bool = False,
) -> Inputs:
    """Returns the inputs that the words name, also assembly, with its options, and JSON."""

    def assembly(inputs: Inputs, source: Source, lines: Iterable[str]) -> Iterator[Message]:
        nonlocal counter
        for message in assembled_messages(
            source,
            lines,
            inputs.complain,
            dialect=reading.dialect,
            counter=counter,
            reply=reply,
            unchecked=unchecked,
        ):
            yield message
            counter = (message.counter + 1) % COUNTERS

    def making(line: str) -> Making | None:
        return _records if _is_record(line) else assembly if is_assembly(line) or OBJECT.match(line) else None

    return Inputs(sources(names), reading, _TAKES._replace(making=making))


def encoded(inputs: Inputs, *, faults: bool = True) -> Iterator[Message]:
    """Yields the messages of the inputs, also faulty ones, unless they are cut off; reports faults if wanted."""
    for content in inputs:
        if isinstance(content, CaptureSource):
            for record in content.records():
                content.taken += 1
                yield record.message
        elif isinstance(content, Frame) and content.is_cut:
            size = len(content.message.build())
            inputs.complain(f"{content.place}: cannot encode a frame that is cut off after {size} bytes")
        elif isinstance(content, Frame):
            yield content.message
            if faults and content.pasted is not None and content.message.fault is not None:
                inputs.complain(f"{content.place}: fault at {content.message.fault}")


def _records(inputs: Inputs, source: Source, lines: Iterable[str]) -> Iterator[Message]:
    """Yields the messages of JSON objects, and reports those that are wrong."""
    dialect = inputs.reading.dialect
    try:
        for number, entry in read_records(lines):
            try:
                for frame in frames_in(entry, dialect=dialect):
                    yield parse(frame, strict=False, dialect=dialect)
            except RecordError as error:
                inputs.complain(f"{source.label[:60]}, line {number}: {error}")
    except RecordError as error:
        inputs.complain(f"{source.label[:60]}, {error}")


def _is_record(line: str) -> bool:
    """Whether a JSON object starts in a line; a brace alone counts, because C arrays have a name before it."""
    return line == "{" or (line.startswith("{") and line[1:].lstrip().startswith('"'))


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
@click.option("-o", "--output", "path", metavar="FILE", help="Write to this file, not standard output.")
@click.option(
    "--counter",
    type=Whole(0, COUNTERS - 1),
    default=0,
    show_default=True,
    metavar="NUMBER",
    help="Message counter of the first assembled message that states none.",
)
@reply_option
@click.option("--unchecked", is_flag=True, help="Accept values that mean nothing to the brick, such as motor port 16.")
@click.option(
    "--source",
    "source_dialect",
    type=click.Choice(("strict", "lego", "basic")),
    help="Dialect of a program's source; by default strict, LEGO's own and EV3 Basic's are tried.",
)
@click.option("--version", "version", type=_Version(), metavar="NUMBER", help="Version of a program's image.")
@click.option("--shortest", is_flag=True, help="Shorten a program's labels, and share the code of equal objects.")
@reading_options
def encode(
    names: tuple[str, ...],
    form: str | None,
    path: str | None,
    counter: int,
    reply: bool | None,
    unchecked: bool,
    source_dialect: str | None,
    version: int | None,
    shortest: bool,
    reading: CaptureOptions,
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
    is_for_program = source_dialect is not None or version is not None or shortest
    if form == RBF or (form is None and (is_for_program or (path is not None and path.lower().endswith(SUFFIX)))):
        about_frames = given_options("counter", "reply", "unchecked", "filter", "no_length", "only_operations")
        if about_frames:
            raise incompatible(", ".join(about_frames), "--to rbf or -o FILE.rbf")
        found = sources(names)
        from ev3proto.cli.programs import encode_program  # takes 38 ms, which frames do not need

        sys.exit(encode_program(found, path, dialect=source_dialect, version=version, shortest=shortest))
    if is_for_program:
        raise click.UsageError("--source, --version and --shortest are for programs; add --to rbf or -o FILE.rbf")
    form = form or "hex"
    if form == RAW:
        refuse_terminal(path, "raw bytes", "them")
    inputs = inputs_for(names, reading, counter=counter, reply=reply, unchecked=unchecked)
    dialogue, number = Dialogue(), 0
    with failing_to("written", path), output_to(None if path is None else Path(path)) as stream:
        for number, message in enumerate(encoded(inputs), 1):
            data = FORMS[form](message, number, dialogue)
            if path is None and isinstance(data, str):
                say(data)
            else:
                stream.write(data if isinstance(data, bytes) else f"{data}\n".encode())
        if not number:
            # Nothing was written yet, and an existing file stays.
            sys.exit(1)
    sys.exit(1 if inputs.at_fault else 0)
