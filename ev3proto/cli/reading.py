"""The options for reading input, which many subcommands share."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from ev3proto.bounded import DEFAULT_MEMORY
from ev3proto.capture.record import Record
from ev3proto.cli.options import Whole, dialect_option, exclusive, tshark_option
from ev3proto.cli.output import say
from ev3proto.cli.problems import Problems
from ev3proto.cli.words import files
from ev3proto.reading.items import Source
from ev3proto.reading.options import BUILTIN, ENGINES, MIB, Options, Sources
from ev3proto.reading.parts import Reading
from ev3proto.tables.discovery import TCP_PORT
from ev3proto.text.paste import Missing

if TYPE_CHECKING:
    from ev3proto.capture.filter import Filter, FilterError


def _compiled(_context: click.Context, _parameter: click.Parameter, text: str | None) -> Filter | None:
    if text is None:
        return None
    from ev3proto.capture.filter import FilterError, compile_filter  # takes 16 ms, which only filters need

    try:
        return compile_filter(text)
    except FilterError as error:
        raise click.BadParameter(f"{error}\n{_underlined(text, error)}") from None


_WINDOW = 60
"""Characters of a filter that are shown on either side of an error."""


def _underlined(text: str, error: FilterError) -> str:
    """Returns two lines: the filter, and a mark below the error."""
    at = error.column - 1
    start, end = max(at - _WINDOW, 0), at + _WINDOW
    shown = "".join(character if character.isprintable() else " " for character in text[start:end])
    before, after = "..." * (start > 0), "..." * (end < len(text))
    sign = "^" * min(error.length, max(len(shown) - (at - start), 1))
    return f"  {before}{shown}{after}\n  {' ' * (len(before) + at - start)}{sign}"


def _explain_filters(context: click.Context, _parameter: click.Parameter, is_wanted: bool) -> None:
    if not is_wanted or context.resilient_parsing:
        return
    from ev3proto.capture.filter.manual import manual  # takes 16 ms, too

    say("\n".join(manual()))
    context.exit()


def captures_of(names: Sequence[str], reading: Options) -> Reading:
    """Returns the reading of the captures and logs that words name, for subcommands that take nothing else."""
    return Reading(files(names), replace(reading, sources=Sources.NO, images=False))


def title_of(reading: Reading) -> str:
    """Returns the names of the files that are read, without their folders."""
    return ", ".join(Path(part.label).name for part in reading.parts)


def made_of(source: Source, reading: Reading, problems: Problems, **making: Any) -> Iterator[Record]:
    """Yields the frames of assembly, made as `assembled` does; prints what is wrong, also that there is none.

    Raises:
        click.UsageError: Frames are to be filtered.
    """
    from ev3proto.reading.assembling import assembled  # takes 8 ms, which frames do not need

    if reading.options.filter is not None:
        name = source.place.name or str(source.text)
        raise click.UsageError(f"--filter is for frames, but {name[:60]} has none yet")
    is_empty, errors = True, problems.errors
    for record in problems.records(assembled(source, dialect=reading.options.dialect, **making)):
        is_empty = False
        yield record
    if is_empty and problems.errors == errors:
        problems.show(reading.part.nothing())


F = TypeVar("F", bound=Callable[..., Any])

_OPTIONS = (
    dialect_option,
    click.option(
        "--port",
        "ports",
        type=Whole(1, 65535),
        multiple=True,
        metavar="PORT",
        help="TCP port of the brick, to show all its traffic, recognised or not; can be repeated."
        f" [default: {TCP_PORT}, if recognised]",
    ),
    click.option(
        "--all",
        "everything",
        is_flag=True,
        help="Show all traffic on a brick's TCP port, Bluetooth channel and USB reports, recognised or not.",
    ),
    click.option(
        "--engine",
        type=click.Choice(ENGINES),
        default=BUILTIN,
        show_default=True,
        help="Program that dissects packets: ev3proto itself, or tshark.",
    ),
    tshark_option,
    click.option(
        "--filter",
        callback=_compiled,
        metavar="EXPRESSION",
        help="Only frames that match this, such as 'op==SOUND.TONE && FREQUENCY>400'.",
    ),
    click.option(
        "--help-filter",
        is_flag=True,
        is_eager=True,
        expose_value=False,
        callback=_explain_filters,
        help="Explain filters and list their fields, with examples, and exit.",
    ),
    click.option(
        "--no-length",
        is_flag=True,
        help="Read each line of a text as a frame without the two bytes of its length field.",
    ),
    click.option(
        "--operations",
        "only_operations",
        is_flag=True,
        help="Read each line of a text as operations without the header of a frame.",
    ),
    click.option(
        "--memory",
        type=Whole(1, 1 << 16),
        default=DEFAULT_MEMORY // MIB,
        show_default=True,
        metavar="MIB",
        help="Memory limit for unfinished frames, transfers and unanswered commands; the oldest are dropped first.",
    ),
)


def reading_options(command: F) -> F:
    """Adds the options for reading to a command, which gets them as one argument, `reading`."""

    @functools.wraps(command)
    @exclusive("--no-length", "--operations")
    @exclusive("--all", "--engine!builtin")
    def called(*arguments: Any, no_length: bool, only_operations: bool, **others: Any) -> Any:
        names = ("dialect", "ports", "everything", "engine", "tshark", "filter")
        given = {name: others.pop(name) for name in names}
        missing: Missing | None = "length" if no_length else "header" if only_operations else None
        options = Options(missing=missing, memory=others.pop("memory") * MIB, raises=False, **given)
        return command(*arguments, reading=options, **others)

    for option in reversed(_OPTIONS):
        option(called)
    return called  # type: ignore[return-value]
