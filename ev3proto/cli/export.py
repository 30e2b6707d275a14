"""`ev3proto export`: the protocol and frames in the formats of other tools, always the same bytes."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from ev3proto.capture.text_log import Clock
from ev3proto.cli.captures import CaptureSource
from ev3proto.cli.commands import Group
from ev3proto.cli.inputs import Source, sources
from ev3proto.cli.options import FOLDER, FiniteRange, dialect_option
from ev3proto.cli.output import (
    binary_output,
    check_option,
    failing_to,
    is_terminal,
    output_option,
    output_options,
    put,
    write_text,
)
from ev3proto.cli.reading import CaptureOptions, reading_options
from ev3proto.cli.sources import SourceReader
from ev3proto.errors import BuildError
from ev3proto.generate import output_schemas
from ev3proto.generate.captures import CaptureWriter, TimedFrame
from ev3proto.generate.cheader import build as header
from ev3proto.generate.kaitai import build as description
from ev3proto.generate.tables_json import build as tables
from ev3proto.tables.carriers import CARRIERS, DEFAULT_CARRIER
from ev3proto.text.paste import Pasted
from ev3proto.text.splitting import Piece
from ev3proto.whole_files import whole_file

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


@export.command("c-header")
@output_options
def c_header(output: Path | None, check: bool) -> None:
    """Writes ev3proto.h: names, encoding macros and functions that fill a frame, for C99 and C++11.

    \b
      ev3proto export c-header -o ev3proto.h
    """  # noqa: D301 - the mark by which click leaves lines as they are
    write_text(header.build(), output, check=check)


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


@export.command("json")
@output_options
def json_tables(output: Path | None, check: bool) -> None:
    """Writes ev3-tables.json: opcodes, CMDs, parameters, enumerations, system commands of all dialects.

    \b
      ev3proto export json | jq '.areas.sound[0].commands[].name'
    """  # noqa: D301
    write_text(tables.build_tables(), output, check=check)


@export.command("json-schema")
@output_options
def json_schema(output: Path | None, check: bool) -> None:
    """Writes ev3-tables.schema.json: the JSON Schema (draft 2020-12) of ev3-tables.json.

    \b
      ev3proto export json-schema -o ev3-tables.schema.json
    """  # noqa: D301
    write_text(tables.build_schema(), output, check=check)


@export.command("output-schema")
@output_options
def output_schema(output: Path | None, check: bool) -> None:
    """Writes ev3-output.schema.json: the JSON Schema of what decode, check, stats and values print with --json.

    \b
      ev3proto export output-schema -o ev3-output.schema.json
    """  # noqa: D301
    write_text(output_schemas.build(), output, check=check)


@export.command("all")
@click.argument("folder", type=FOLDER)
@check_option
def everything(folder: Path, check: bool) -> None:
    """Writes every file that describes the protocol into FOLDER, under its usual name.

    \b
      ev3proto export all exports
      ev3proto export all exports --check
    """  # noqa: D301
    texts = {
        header.FILE_NAME: header.build(),
        description.FILE_NAME: description.build(),
        tables.TABLES_NAME: tables.build_tables(),
        tables.SCHEMA_NAME: tables.build_schema(),
        output_schemas.FILE_NAME: output_schemas.build(),
    }
    if not check:
        with failing_to("created", folder):
            folder.mkdir(parents=True, exist_ok=True)
    outcomes = [put(text.encode(), folder / name, check=check) for name, text in texts.items()]
    sys.exit(0 if all(outcomes) else 1)


# Frames


class _Carrying(SourceReader):
    """Writes the frames of all sources to a capture, and reports those that cannot be carried."""

    is_quiet = True

    def __init__(self, writer: CaptureWriter, reading: CaptureOptions) -> None:
        super().__init__(reading)
        self._writer = writer
        self._clock = Clock()
        self._has_times: bool | None = None

    def piece(self, piece: Piece, pasted: Pasted, source: Source) -> None:
        """Writes a frame of a text, at its time or after the frame before."""
        frame = piece.message.build()
        if self._has_times is None:
            self._has_times = pasted.time is not None
        timed = TimedFrame(frame, self._clock.at(pasted.time)) if self._has_times else frame
        self._add(timed, source.where(pasted))

    def capture(self, capture: CaptureSource) -> int:
        """Writes the frames of a capture, at their times."""
        before = self._writer.count
        for record in capture.records():
            self._add(TimedFrame(record.frame, record.time_ns), f"{capture.label}, {capture.unit} {record.number}")
        return self._writer.count - before

    def _add(self, frame: bytes | TimedFrame, place: str) -> None:
        try:
            self._writer.add(frame)
        except BuildError as error:
            self.complain(f"{place}: {error}")


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
def pcapng(names: tuple[str, ...], output: Path | None, carrier: str, interval: float, reading: CaptureOptions) -> None:
    """Writes frames as a capture for Wireshark: a complete conversation over WiFi, USB or Bluetooth.

    The input is the same as for decode. Commands go from the computer to the brick, and replies back.

    \b
      ev3proto export pcapng robot.log -o talk.pcapng
      ev3proto export pcapng 0e002a0080000094010182b80182e803 -o tone.pcapng
      ev3proto export pcapng --carrier usb robot.log | tshark -r -
    """  # noqa: D301
    if output is None and is_terminal():
        raise click.UsageError("refusing to write a capture to a terminal; give -o FILE, or pipe it into a program")
    with failing_to("written", output), binary_output() if output is None else whole_file(output) as stream:
        writer = CaptureWriter(stream, carrier=carrier, step_ns=round(interval * _NANOSECONDS_EACH))
        carrying = _Carrying(writer, reading)
        carrying.read_all(sources(names))
        if not writer.count:
            # Nothing was written yet, and an existing file stays.
            sys.exit(1)
        writer.close()
    sys.exit(1 if carrying.at_fault else 0)
