"""Programs on the command line: reading and assembling images (.rbf) and sources (.lms)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

import click

from ev3proto.capture.files import RecoveredFile, recover
from ev3proto.cli.output import complain, put, refuse_terminal
from ev3proto.cli.reading import Captured, Problems
from ev3proto.errors import DecodeError, counted
from ev3proto.program import Assembled, Program, assemble, parse
from ev3proto.program.sources import MAX_SOURCE
from ev3proto.reading.given import Given
from ev3proto.reading.items import Problem
from ev3proto.reading.kinds import is_image
from ev3proto.reading.parts import Part
from ev3proto.temporary import temporary_folder
from ev3proto.text.assembly.errors import AssemblyError, SourceWarning
from ev3proto.text.spans import visible

_MOST_WARNINGS = 20
_MOST_OF_A_NAME = 200


def read_program(label: str, image: bytes, dialect: str) -> Program | None:
    """Reads a program as far as possible; reports a missing header, and returns None."""
    try:
        return parse(image, strict=False, dialect=dialect)
    except DecodeError as error:
        complain(f"{label}: {error}")
        return None


def moved_programs(events: Iterable[Captured], part: Part, problems: Problems) -> Iterator[tuple[str, bytes]]:
    """Yields the origins and images of the programs that a capture transfers, as far as they were captured."""
    with temporary_folder() as folder:
        found: list[RecoveredFile] = []
        try:
            # One by one, so that earlier files are kept if the capture ends early.
            found += recover(events, folder)
        except OSError as error:
            problems.wrong(f"the programs cannot be written to {folder}: {error.strerror or error}")
        for file in found:
            image = b"" if file.file is None else file.file.read_bytes()
            if is_image(image):
                yield f"{part.where(file.packets[0])}: {visible(file.path)}", image


def complain_of_source(label: str, found: Sequence[AssemblyError | SourceWarning]) -> None:
    """Prints the errors of a source, or its first warnings and the number of the others."""
    problems = Problems()
    warnings = [one for one in found if isinstance(one, SourceWarning)]
    for error in found:
        if isinstance(error, AssemblyError):
            problems.show(Problem.in_source(label, error))
    for warning in warnings[:_MOST_WARNINGS]:
        complain(f"{label}, {warning} (warning)")
    if len(warnings) > _MOST_WARNINGS:
        complain(f"{label}: and {len(warnings) - _MOST_WARNINGS} more warnings")


def assembled(
    text: str | bytes, label: str, *, dialect: str | None = None, version: int | None = None, shortest: bool = False
) -> Assembled | None:
    """Assembles a source, and prints its errors and warnings; None if it has errors."""
    try:
        made = assemble(text, dialect=dialect, version=version, shortest=shortest)
    except AssemblyError as error:
        complain_of_source(label, (error, *error.others))
        return None
    complain_of_source(label, made.warnings)
    return made


def encode_program(
    found: list[Given], path: Path | None, *, source_dialect: str | None, version: int | None, shortest: bool
) -> int:
    """Assembles one source and writes its image. Returns the exit status."""
    if len(found) != 1:
        raise click.UsageError(f"expected one source of a program, not {len(found)}")
    source = found[0]
    refuse_terminal(path, "an image")
    text = _text_of(source)
    if text is None:
        return 1
    label = "the source" if source.word is not None else source.label
    made = assembled(text, label, dialect=source_dialect, version=version, shortest=shortest)
    if made is None or not put(made.image, path):
        return 1
    written = {"strict": "the strict dialect", "lego": "LEGO's dialect"}.get(made.dialect, "EV3 Basic's dialect")
    size, objects = counted(len(made.image), "byte"), counted(len(made.program.objects), "object")
    complain(f"{path or 'the image'}: {size}, {objects}, from a source in {written}")
    return 0


def _text_of(source: Given) -> str | bytes | None:
    """Returns the text to assemble; reports anything else, and returns None."""
    word = source.word
    if word is not None and ("{" in word or any(character.isspace() for character in word.strip())):
        return word
    try:
        with Path(word).open("rb") if word is not None else source.opened() as stream:
            text = stream.read(MAX_SOURCE + 1)
    except OSError as error:
        complain(f"{source.label[:_MOST_OF_A_NAME]}: cannot be read: {error.strerror or error}")
        return None
    if is_image(text):
        complain(f"{source.label}: this is an image already; `ev3proto decode --format lego` shows its source")
        return None
    return text
