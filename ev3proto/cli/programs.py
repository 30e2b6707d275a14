"""Programs on the command line: what `decode`, `encode` and `check` do with images (.rbf) and sources (.lms)."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from ev3proto.cli.output import Printer, complain
from ev3proto.tables.program import SIGN

if TYPE_CHECKING:
    from ev3proto.cli.sources import Source
    from ev3proto.program import Program
    from ev3proto.text.assembly.errors import AssemblyError

SUFFIX, SOURCE_SUFFIX = ".rbf", ".lms"
RBF = "rbf"
"""The form of `encode` that makes images."""

LEGO = "lego"
"""The format of `decode` that makes sources."""

PROGRAM_FORMATS = ("listing", LEGO)
"""The formats of `decode` that there are for programs only."""

_MOST_WARNINGS = 20


def is_image(start: bytes) -> bool:
    """Whether a file that starts so is a program image."""
    return start.startswith(SIGN)


def read_program(label: str, image: bytes, dialect: str) -> Program | None:
    """A program, read as far as it goes; None, and a complaint, where there is not even a header."""
    from ev3proto.errors import DecodeError
    from ev3proto.program import parse

    try:
        return parse(image, strict=False, dialect=dialect)
    except DecodeError as error:
        complain(f"{label}: {error}")
        return None


def show_program(printer: Printer, program: Program, image: bytes, style: str | None) -> None:
    """Prints a program.

    style  listing, tree, json or lego; table is a listing, asm is lego, None the listing
    """
    if style == "json":
        from ev3proto.program.json_format import program_record

        printer.text(json.dumps(program_record(program, len(image)), ensure_ascii=False))
    elif style in (LEGO, "asm"):
        from ev3proto.program import source_of

        printer.text(source_of(program).rstrip("\n"))
    else:
        from ev3proto.program.listing import listing, program_tree

        printer.lines(program_tree(program) if style == "tree" else listing(program))


def complain_of(label: str, error: AssemblyError) -> None:
    """Prints every error of a source with its line and, below that, a mark at the place."""
    for one in (error, *error.others):
        complain(f"{label}, {one}")
        if one.text.strip():
            complain("\n".join(f"  {line}" for line in one.excerpt.split("\n")))


def encode_program(
    found: list[Source], path: str | None, *, dialect: str | None, version: int | None, shortest: bool
) -> int:
    """Makes an image of one source and writes it; the exit status."""
    from ev3proto.program import assemble
    from ev3proto.program.source.source import MAX_SOURCE
    from ev3proto.text.assembly.errors import AssemblyError

    if len(found) != 1:
        raise click.UsageError(f"a program is made of one source, and here are {len(found)}")
    source = found[0]
    if path is None and sys.stdout.isatty():
        raise click.UsageError("an image would garble the terminal: give -o FILE, or pipe it into another program")
    if source.is_frame:
        text: str | bytes = source.name
    else:
        try:
            with source.open() as stream:
                text = stream.read(MAX_SOURCE + 1)
        except OSError as error:
            complain(f"{source.label}: cannot be read: {error.strerror or error}")
            return 1
    label = "the source" if source.is_frame else source.label
    try:
        made = assemble(text, dialect=dialect, version=version, shortest=shortest)
    except AssemblyError as error:
        complain_of(label, error)
        return 1
    for warning in made.warnings[:_MOST_WARNINGS]:
        complain(f"{label}, {warning} (warning)")
    if len(made.warnings) > _MOST_WARNINGS:
        complain(f"{label}: and {len(made.warnings) - _MOST_WARNINGS} more warnings")
    if path is None:
        stdout = click.get_binary_stream("stdout")
        stdout.write(made.image)
        stdout.flush()
        return 0
    try:
        Path(path).write_bytes(made.image)
    except OSError as error:
        complain(f"{path}: cannot be written: {error.strerror or error}")
        return 1
    count = len(made.program.objects)
    told = "the strict dialect" if made.dialect == "strict" else "LEGO's dialect"
    click.echo(f"{path}: {len(made.image)} bytes, {count} object{'s' * (count != 1)}, from a source in {told}")
    return 0
