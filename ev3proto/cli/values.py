"""`ev3proto values`: the values in replies over time, as a table, CSV, JSON or a chart."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import click

from ev3proto.capture.plot import draw
from ev3proto.capture.series import MOST_CELLS, Cell, Series, series_of
from ev3proto.capture.timeline import MissingLibraryError
from ev3proto.cli.options import FILE, exclusive
from ev3proto.cli.output import Failure, complain, csv_line, put, say, say_json
from ev3proto.cli.reading import Problems, captures_of, reading_options, title_of
from ev3proto.cli.tables import Tables
from ev3proto.errors import counted
from ev3proto.reading.options import Options
from ev3proto.reading.parts import Reading
from ev3proto.text.spans import visible

MOST_SHOWN = 50
"""Maximum number of columns of a table, and of lines of a chart."""

MOST_PRINTED = 100_000
"""Maximum cells of a table, each of which takes a kilobyte until all are printed."""

_CELL = 150
"""Characters that take as much memory as a cell."""

MOST_COLUMNS = {"csv": 1_000, "json": sys.maxsize}
"""Columns by format, MOST_SHOWN for others. JSON has only existing values, so it needs no limit."""


@click.command()
@click.argument("files", nargs=-1, required=True, metavar="FILE...")
@reading_options
@click.option("--csv", "as_csv", is_flag=True, help="Print comma-separated values.")
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object a line, for each reply.")
@click.option(
    "--plot",
    type=FILE,
    metavar="FILE",
    help="Draw numbers over time into this file: .svg or .png.",
)
@exclusive("--csv", "--json")
@exclusive("--plot", "--csv", "--json")
def values(files: tuple[str, ...], reading: Options, as_csv: bool, as_json: bool, plot: Path | None) -> None:
    """Shows values over time: battery, sensors, motors, latencies, mailbox messages.

    Each value has a column, named after its operation, that operation's arguments such as the port, and the parameter.
    --filter selects replies. A mailbox message has a column for each reading that fits: text, number, logic (1 is
    true). With several files, each row names its file.

    \b
      ev3proto values robot.pcapng
      ev3proto values robot.pcapng --filter 'op == UI_READ.GET_VBATT' --csv
      ev3proto values robot.pcapng --filter 'op == INPUT_READ' --plot light.svg
    """  # noqa: D301 - the mark by which click leaves lines as they are
    captures, problems, found = captures_of(files, reading), Problems(), Series()
    for part in captures.each():
        found.extend(series_of(problems.captured(part), part.label, MOST_CELLS - found.size))
    if found.omitted:
        kept = f"{MOST_CELLS:,} cells are kept; --filter chooses others"
        problems.wrong(f"{counted(found.omitted, 'row')} omitted: {kept}")
    if not found.rows:
        problems.end_without(f"{captures.label}: no reply with its command found{captures.passed_over}")
    if found.unsure:
        complain(f"{counted(found.unsure, 'row')} may answer another command: several with its counter waited")
    form = "csv" if as_csv else "json" if as_json else ""
    _show(_narrowed(found, form), form, plot, captures)
    sys.exit(problems.status)


def _show(found: Series, form: str, plot: Path | None, captures: Reading) -> None:
    start = captures.account.first_ns or 0
    if plot is not None:
        _draw(found, plot, title_of(captures), start)
    elif form == "csv":
        _print_csv(found)
    elif form == "json":
        for record in _records(found):
            say_json(record)
    else:
        _print_table(found, captures.unit, start)


def _narrowed(found: Series, form: str) -> Series:
    most = MOST_COLUMNS.get(form, MOST_SHOWN)
    if len(found.units) <= most:
        return found
    complain(
        f"there are {len(found.units):,} columns: the {most:,} with the most values are shown; --filter chooses"
        " replies, and --json prints all values"
    )
    return found.narrowed(most)


def _titles(found: Series) -> list[str]:
    named = {name: f"{name} {found.quantities.get(name, '')}".rstrip() for name in found.units}
    return [f"{named[name]} [{unit}]" if unit else named[name] for name, unit in found.units.items()]


def _text(cell: Cell | None) -> str:
    if isinstance(cell, float):
        return f"{cell:.7g}"
    return "" if cell is None else visible(str(cell))


def _print_table(found: Series, unit: str, start_ns: int) -> None:
    leading = ["file"] if _is_of_several(found) else []
    rows: list[list[str]] = []
    left = MOST_PRINTED
    for row in found.rows:
        cells = [
            *([row.file or ""] if leading else []),
            f"{(row.time_ns - start_ns) / 1e9:.6f}" if row.is_timed else "",
            str(row.packet),
            *(_text(row.cells.get(name)) for name in found.units),
        ]
        left -= len(cells) + sum(map(len, cells)) // _CELL
        if left < 0 and rows:
            break
        rows.append(cells)
    Tables().table([*leading, "time [s]", unit, *_titles(found)], rows)
    if len(found.rows) > len(rows):
        complain(f"and {counted(len(found.rows) - len(rows), 'row')} more: --csv and --json print all of them")


def _is_of_several(found: Series) -> bool:
    return len({row.file for row in found.rows}) > 1


def _print_csv(found: Series) -> None:
    for number, record in enumerate(_records(found)):
        cells = record.pop("values")
        if number == 0:
            say(csv_line([*record, *_titles(found)]))
        say(csv_line([*record.values(), *map(cells.get, found.units)]))


def _records(found: Series) -> Iterator[dict[str, Any]]:
    """The rows for other programs. With several files, a row has the name of its file."""
    is_of_several = _is_of_several(found)
    for row in found.rows:
        file = {"file": row.file} if is_of_several else {}
        yield file | {"time": row.time, "packet": row.packet, "peer": row.peer, "values": row.cells}


def _draw(found: Series, path: Path, title: str, start_ns: int) -> None:
    try:
        data = draw(found, path.suffix, title, start_ns)
    except MissingLibraryError as error:
        raise Failure(str(error)) from None
    except ValueError as error:
        raise click.UsageError(str(error)) from None
    if not put(data, path):
        sys.exit(1)
    say(f"{path}: written")
