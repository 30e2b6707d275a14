"""`ev3proto files`: the files that a capture transfers to or from the brick, listed or written to disk."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path

import click

from ev3proto.capture.files import FileState, RecoveredFile, recover, survey
from ev3proto.cli.options import FOLDER, json_option
from ev3proto.cli.output import complain, say, say_json
from ev3proto.cli.reading import Problems, captures_of, reading_options
from ev3proto.cli.tables import Tables
from ev3proto.reading.options import Options
from ev3proto.reading.parts import Part
from ev3proto.text.spans import visible


@click.command()
@click.argument("names", nargs=-1, required=True, metavar="FILE...")
@reading_options
@click.option(
    "-o",
    "--output",
    "folder",
    type=FOLDER,
    help="Write the files into this folder, which is created if it is missing.",
)
@click.option("--listings", is_flag=True, help="Include listings of folders, as text.")
@click.option("--force", is_flag=True, help="Overwrite existing files.")
@json_option
def files(
    names: tuple[str, ...], reading: Options, folder: Path | None, listings: bool, force: bool, as_json: bool
) -> None:
    """Recovers the files that were transferred to or from the brick.

    Without -o, they are only listed. With -o, each is written under its path on the brick, always inside the folder; an
    incomplete file gets the suffix .part, and the exit status is 1.

    \b
      ev3proto files robot.pcapng
      ev3proto files robot.pcapng -o files
    """  # noqa: D301 - the mark by which click leaves lines as they are
    if force and folder is None:
        raise click.UsageError("--force needs -o")

    rows: list[tuple[str, ...]] = []
    captures, problems = captures_of(names, reading), Problems()
    for part in captures.each():
        errors, is_empty = problems.errors, True
        for recovered in _recovered(part, folder, problems, force=force, listings=listings):
            is_empty = False
            if as_json:
                say_json(_record(recovered))
            elif folder is None:
                rows.append(_row(recovered))
            elif recovered.file is not None:
                say(f"{recovered.file}: {recovered.bytes} bytes {recovered.direction}, {visible(recovered.path)}")
        if is_empty and problems.errors == errors:
            complain(f"{part.label}: no file is moved{part.passed_over}")
    _list(rows, f"{captures.unit}s")
    sys.exit(problems.status)


def _recovered(
    part: Part, folder: Path | None, problems: Problems, *, force: bool, listings: bool
) -> Iterator[RecoveredFile]:
    """Yields the files, and after each of those that are written what is wrong with it."""
    events = problems.captured(part)
    if folder is None:
        yield from survey(events, listings=listings)
        return
    try:
        for file in recover(events, folder, force=force, listings=listings):
            yield file
            if file.trouble is not None:
                complain(f"{part.where(file.packets[0])}: {visible(file.path)}: {file.trouble}")
                problems.errors += file.outcome is not FileState.REFUSED
    except OSError as error:
        problems.wrong(f"{error.filename2 or error.filename}: cannot be written: {error.strerror or error}")


_COLUMNS = ("path", "direction", "bytes", "of", "state", "packets", "brick")


def _row(file: RecoveredFile) -> tuple[str, ...]:
    size = "" if file.size is None else str(file.size)
    packets = "-".join(map(str, dict.fromkeys(file.packets)))
    return file.path, file.direction, str(file.bytes), size, file.outcome.value, packets, file.peer


def _list(rows: list[tuple[str, ...]], places: str) -> None:
    if not rows:
        return
    bricks = {row[_COLUMNS.index("brick")] for row in rows}
    titles = [places if name == "packets" else name for name in _COLUMNS]
    Tables(hidden=() if len(bricks) > 1 else ("brick",)).table(titles, rows)


def _record(file: RecoveredFile) -> dict[str, object]:
    return {**asdict(file), "file": None if file.file is None else str(file.file)}
