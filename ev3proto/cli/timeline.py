"""`ev3proto timeline`: a picture of a dialogue over time, as a page, an SVG or a PNG."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import replace
from itertools import chain
from pathlib import Path

import click

from ev3proto.capture import Event
from ev3proto.capture.timeline import Form, MissingLibraryError, Window, collect, render, require_library
from ev3proto.cli.options import FILE, FiniteRange
from ev3proto.cli.output import Failure, complain, put, say
from ev3proto.cli.reading import Problems, captures_of, reading_options, title_of
from ev3proto.reading.options import Options

MOST_SECONDS = 1e9
"""Longest time that can be asked for: thirty years."""


_SECONDS = FiniteRange(0, MOST_SECONDS)


@click.command()
@click.argument("files", nargs=-1, required=True, metavar="FILE...")
@reading_options
@click.option(
    "-o",
    "--output",
    type=FILE,
    required=True,
    help="Write to this file: .html, .svg, .png or .json.",
)
@click.option("--from", "first", type=_SECONDS, metavar="SECONDS", help="Begin this long after the first message.")
@click.option("--to", "last", type=_SECONDS, metavar="SECONDS", help="End this long after the first message.")
def timeline(files: tuple[str, ...], reading: Options, output: Path, first: float | None, last: float | None) -> None:
    """Draws a timeline of messages, latencies, files and faults.

    The suffix of the file decides the format: .html is an interactive page that needs no network; .svg and .png are
    pictures; .json is the Vega-Lite chart with its data, for other tools. With --filter, a command is drawn with its
    reply if either of them matches. A log without times is drawn in its order, and --from and --to count its lines.

    \b
      ev3proto timeline robot.pcapng -o robot.html
      ev3proto timeline robot.pcapng -o start.png --from 5 --to 5.5
    """  # noqa: D301 - the mark by which click leaves lines as they are
    form = _form(output)
    if first is not None and last is not None and first >= last:
        raise click.UsageError(f"--from {first:g} must be less than --to {last:g}")
    if not output.parent.is_dir():
        raise Failure(f"{output}: cannot be written: there is no folder {output.parent}")
    # The timeline filters by itself: a reply that is kept back must not look as if it never came.
    captures, problems = captures_of(files, replace(reading, filter=None)), Problems()
    events, is_timed = _begun(problems.captured(captures.events()))
    limits = _limits(first, last, is_timed=is_timed)
    if limits and not is_timed:
        complain(f"{captures.label}: has no times: --from and --to count its lines")
    drawn = collect(events, reading.filter, Window(first, last))
    if drawn is None:
        if limits or problems.errors:
            problems.end_without(f"{captures.label}: no frame found{limits}{captures.passed_over}")
        for part in captures.parts:
            problems.show(part.nothing(reading.filter))
        sys.exit(1)
    if not put(render(drawn, form, title_of(captures)), output):
        sys.exit(1)
    say(f"{output}: written")
    sys.exit(problems.status)


def _form(output: Path) -> Form:
    """Returns the format of a file by its suffix. Ends the program if it is unknown, or its library is missing."""
    try:
        form = Form.of(output)
        if form is not Form.JSON:
            require_library()
    except MissingLibraryError as error:
        raise Failure(str(error)) from None
    except ValueError as error:
        raise click.UsageError(str(error)) from None
    return form


def _begun(events: Iterator[Event]) -> tuple[Iterator[Event], bool]:
    """The same events, and whether the first one has a time: else all of them are drawn in their order."""
    begin = next(events, None)
    return (events, True) if begin is None else (chain([begin], events), begin.route.is_timed)


def _limits(first: float | None, last: float | None, *, is_timed: bool) -> str:
    limits = [
        f"{name} {value:g} s" if is_timed else f"{name} line {value:g}"
        for name, value in (("from", first), ("to", last))
        if value is not None
    ]
    return "".join(f" {limit}" for limit in limits)
