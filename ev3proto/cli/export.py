"""`ev3proto export`: the protocol and frames in the formats of other tools, always the same bytes."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from pathlib import Path

import click

from ev3proto.capture.record import Record
from ev3proto.capture.text_log import DAY_NS, Clock
from ev3proto.cli.commands import Group
from ev3proto.cli.options import FOLDER, FiniteRange, dialect_option, exclusive
from ev3proto.cli.output import (
    check_option,
    failing_to,
    output_option,
    output_options,
    output_to,
    put,
    refuse_terminal,
    write_text,
)
from ev3proto.cli.reading import Problems, named, reading_options
from ev3proto.errors import BuildError
from ev3proto.generate import output_schemas, vectors
from ev3proto.generate.captures import CaptureWriter, TimedFrame
from ev3proto.generate.cheader import build as header
from ev3proto.generate.exported import EXPORTED
from ev3proto.generate.kaitai import build as description
from ev3proto.generate.tables_json import build as tables
from ev3proto.reading.options import Options, Sources
from ev3proto.reading.parts import Reading
from ev3proto.tables.carriers import CARRIERS, DEFAULT_CARRIER

_MOST_INTERVAL = 3_600_000.0
_NANOSECONDS_EACH = 1_000_000


@click.group(cls=Group)
def export() -> None:
    """Writes the protocol, or frames, in the formats of other tools.

    Files that describe the protocol are the same every time; --check says whether one is up to date.

    \b
      ev3proto export all exports
      ev3proto export pcapng robot.log -o talk.pcapng
      ev3proto export c-header --help
    """  # noqa: D301 - the mark by which click leaves lines as they are


_FILES = {
    "c-header": (
        header.build,
        "Writes ev3proto.h: names, encoding macros and functions that fill a frame, for C99 and C++11.",
        "-o ev3proto.h",
    ),
    "json": (
        tables.build_tables,
        "Writes ev3-tables.json: opcodes, CMDs, parameters, enumerations, system commands of all dialects.",
        "| jq '.areas.sound[0].commands[].name'",
    ),
    "json-schema": (
        tables.build_schema,
        "Writes ev3-tables.schema.json: the JSON Schema (draft 2020-12) of ev3-tables.json.",
        "-o ev3-tables.schema.json",
    ),
    "output-schema": (
        output_schemas.build,
        "Writes ev3-output.schema.json: the JSON Schema of what decode, check, stats and values print with --json.",
        "-o ev3-output.schema.json",
    ),
    "vectors": (
        vectors.build,
        "Writes ev3-vectors.jsonl: frames and what each says, valid and faulty, to test decoders in any language.\n\n"
        "Each line is an object: `frame`, for replies the `request` that they answer, and the `message` of decode"
        " --json.",
        "| head -n 3 | jq .message",
    ),
}
"""The subcommands that have no options of their own: what each writes, its help, and an example of its use."""


def _add(name: str, build: Callable[[], str], about: str, example: str) -> None:
    @export.command(name, help=f"{about}\n\n\b\n  ev3proto export {name} {example}")
    @output_options
    def write(output: Path | None, check: bool) -> None:
        write_text(build(), output, check=check)


for _name, _file in _FILES.items():
    _add(_name, *_file)


@export.command()
@dialect_option
@output_options
def kaitai(dialect: str, output: Path | None, check: bool) -> None:
    """Writes ev3.ksy: frames for the Kaitai Struct compiler (0.11 and later), which makes parsers in many languages.

    \b
      ev3proto export kaitai -o ev3.ksy
      ev3proto export kaitai --dialect xtended -o ev3.ksy
    """  # noqa: D301
    write_text(description.build(dialect), output, check=check)


@export.command()
@click.option("--decoder", is_flag=True, help="Write ev3-decode.mjs, which reads frames, streams and dialogues.")
@click.option("--texts", is_flag=True, help="Write ev3-texts.mjs: operations and parameters in words.")
@click.option("--types", is_flag=True, help="Write the types of the module, .d.ts, for TypeScript.")
@output_options
@exclusive("--decoder", "--texts")
def javascript(decoder: bool, texts: bool, types: bool, output: Path | None, check: bool) -> None:
    """Writes ev3.mjs: names of numbers, and functions that make frames, for Node and browsers.

    \b
      ev3proto export javascript -o ev3.mjs
      ev3proto export javascript --types -o ev3.d.ts
      ev3proto export javascript --decoder -o ev3-decode.mjs
      ev3proto export javascript --decoder --types -o ev3-decode.d.ts
    """  # noqa: D301
    name = "ev3-decode" if decoder else "ev3-texts" if texts else "ev3"
    write_text(EXPORTED[f"{name}.d.ts" if types else f"{name}.mjs"](), output, check=check)


@export.command("all")
@click.argument("folder", type=FOLDER)
@check_option
def everything(folder: Path, check: bool) -> None:
    """Writes every file that describes the protocol into FOLDER, under its usual name.

    \b
      ev3proto export all exports
      ev3proto export all exports --check
    """  # noqa: D301
    if not check:
        with failing_to("created", folder):
            folder.mkdir(parents=True, exist_ok=True)
    outcomes = [put(make().encode(), folder / name, check=check) for name, make in EXPORTED.items()]
    sys.exit(0 if all(outcomes) else 1)


# Frames


def _timed_frames(records: Iterable[Record]) -> Iterator[tuple[bytes | TimedFrame, Record]]:
    """Yields the frames, at the times of captures or texts or after the frame before."""
    clock, has_times = Clock(DAY_NS), None
    for record in records:
        if record.written is None:
            yield TimedFrame(record.frame, record.time_ns), record
            continue
        time = record.written.time
        has_times = time is not None if has_times is None else has_times
        yield TimedFrame(record.frame, clock.at(time)) if has_times else record.frame, record


@export.command()
@click.argument("names", nargs=-1, metavar="[FRAME|FILE|-]...")
@output_option
@click.option(
    "--carrier",
    type=click.Choice(CARRIERS),
    default=DEFAULT_CARRIER.value,
    show_default=True,
    help="What carries the frames.",
)
@click.option(
    "--interval",
    type=FiniteRange(0, _MOST_INTERVAL),
    default=1.0,
    show_default=True,
    metavar="MS",
    help="Milliseconds from frame to frame; frames of captures keep their times.",
)
@reading_options
def pcapng(names: tuple[str, ...], output: Path | None, carrier: str, interval: float, reading: Options) -> None:
    """Writes frames as a capture for Wireshark: a complete conversation over WiFi, USB or Bluetooth.

    The input is the same as for decode. Commands go from the computer to the brick, and replies back.

    \b
      ev3proto export pcapng robot.log -o talk.pcapng
      ev3proto export pcapng 0e002a0080000094010182b80182e803 -o tone.pcapng
      ev3proto export pcapng --carrier usb robot.log | tshark -r -
    """  # noqa: D301
    refuse_terminal(output, "a capture")
    with failing_to("written", output), output_to(output) as stream:
        writer = CaptureWriter(stream, carrier=carrier, step_ns=round(interval * _NANOSECONDS_EACH))
        problems = Problems()
        found = Reading(named(names, is_quiet=True), replace(reading, sources=Sources.NO, images=False))
        for frame, record in _timed_frames(problems.records(found)):
            try:
                writer.add(frame)
            except BuildError as error:
                problems.wrong(f"{record.place}: {error}")
        if not writer.count:
            # Nothing was written yet, and an existing file stays.
            sys.exit(1)
        writer.close()
    sys.exit(problems.status)
