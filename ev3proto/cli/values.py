"""`ev3proto values`: the values in replies over time, as a table, CSV, JSON or a picture."""

from __future__ import annotations

import csv
import io
import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from ev3proto.cli.captures import CaptureOptions, CaptureSource, reading_options
from ev3proto.cli.output import complain, say
from ev3proto.cli.tables import Tables
from ev3proto.text.visible import visible
from ev3proto.whole_files import write_whole

if TYPE_CHECKING:
    from ev3proto.capture.series import Cell, Row, Series


@click.command()
@click.argument("file")
@reading_options
@click.option("--csv", "form", flag_value="csv", help="Comma-separated values, a column for each.")
@click.option("--json", "form", flag_value="json", help="One JSON object a line, for each reply.")
@click.option(
    "--plot",
    type=click.Path(path_type=Path, dir_okay=False),
    metavar="FILE",
    help="Draw numbers over time into this file: .svg or .png.",
)
def values(file: str, reading: CaptureOptions, form: str | None, plot: Path | None) -> None:
    """Prints the values in replies over time: battery, sensors, motors, latencies.

    Each value is a column, named after its operation, what that was asked with, and the parameter. --filter chooses the
    replies; a value that an operation gives for another port is another column.

    \b
      ev3proto values robot.pcapng
      ev3proto values robot.pcapng --filter 'op == UI_READ.GET_VBATT' --csv
      ev3proto values robot.pcapng --filter 'op == INPUT_READ' --plot light.svg
    """  # noqa: D301 - the mark by which click leaves lines as they are
    from ev3proto.capture.series import series_of

    source = CaptureSource(file, reading)
    found = series_of(source.events())
    if not found.rows:
        if not source.status:
            complain(f"{source.label}: no reply with its command was found")
        sys.exit(1)
    if plot is not None:
        _draw(found, plot, source.label)
    else:
        _PRINTERS[form](found, source.unit)
    sys.exit(source.status)


def _titles(found: Series) -> list[str]:
    return [f"{name} [{unit}]" if unit else name for name, unit in found.units.items()]


def _text(cell: Cell | None) -> str:
    if isinstance(cell, float):
        return f"{cell:.7g}"
    return "" if cell is None else visible(str(cell))


def _print_table(found: Series, unit: str) -> None:
    start = found.rows[0].time_ns
    rows = [
        [_seconds(row, start), str(row.packet), *(_text(row.cells.get(name)) for name in found.units)]
        for row in found.rows
    ]
    Tables().table(["time [s]", unit, *_titles(found)], rows)


def _seconds(row: Row, start_ns: int) -> str:
    return f"{(row.time_ns - start_ns) / 1e9:.6f}" if row.is_timed else ""


def _print_csv(found: Series, _unit: str) -> None:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["time", "packet", "peer", *_titles(found)])
    for row in found.rows:
        writer.writerow([row.time, row.packet, row.peer, *(_text(row.cells.get(name)) for name in found.units)])
    say(text.getvalue().removesuffix("\n"))


def _print_json(found: Series, _unit: str) -> None:
    for row in found.rows:
        record = {"time": row.time, "packet": row.packet, "peer": row.peer, "values": row.cells}
        say(json.dumps(record, ensure_ascii=False))


_PRINTERS = {None: _print_table, "csv": _print_csv, "json": _print_json}


def _draw(found: Series, path: Path, title: str) -> None:
    from ev3proto.capture.plot import draw
    from ev3proto.capture.timeline import MissingLibraryError

    try:
        write_whole(path, draw(found, path.suffix, Path(title).name))
    except (ValueError, MissingLibraryError) as error:
        raise click.UsageError(str(error)) from None
    except OSError as error:
        complain(f"{path}: cannot be written: {error.strerror or error}")
        sys.exit(1)
    say(f"{path}: written")
