"""The options for reading input, which many subcommands share."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar

import click

from ev3proto.bounded import DEFAULT_MEMORY
from ev3proto.cli.options import Whole, dialect_option, incompatible, tshark_option
from ev3proto.cli.output import say
from ev3proto.tables.declaration import DIALECTS
from ev3proto.tables.discovery import TCP_PORT
from ev3proto.text.paste import Missing, Pasted, read_bare, read_text

if TYPE_CHECKING:
    from ev3proto.capture.filter import Filter, FilterError


BUILTIN = "builtin"
"""The engine that is part of ev3proto."""

HOW_FRAMES_ARE_WRITTEN = "; frames are written in hex, such as 06:00|2A:00|80|00:00|01"

MIB = 1 << 20
"""The unit of --memory, in bytes."""


@dataclass
class CaptureOptions:
    """How input is read.

    dialect  the firmware whose instruction set to use
    ports    TCP ports on which bricks listen; none for 5555, if its traffic is recognised
    is_all   unrecognised traffic is read, too
    engine   builtin or wireshark
    tshark   path of the tshark for that engine
    filter   which records to show; None for all
    missing  what frames in a text lack at their start
    memory   memory limit for incomplete and unanswered messages, in MiB
    """

    dialect: str = DIALECTS[0]
    ports: tuple[int, ...] = ()
    is_all: bool = False
    engine: str = BUILTIN
    tshark: str | None = None
    filter: Filter | None = None
    missing: Missing | None = None
    memory: int = DEFAULT_MEMORY // MIB


def pieces(lines: Iterable[str], missing: Missing | None) -> Iterator[Pasted]:
    """Returns the pieces of a text, whose frames may lack a part."""
    return read_text(lines) if missing is None else read_bare(lines, missing)


def given_up(label: str, count: int, memory: int) -> str:
    """Returns the message about the number of things that were dropped at the memory limit, in MiB."""
    return (
        f"{label}: {count} unfinished frames, transfers and unanswered commands were dropped: the memory limit is"
        f" {memory} MiB (--memory)"
    )


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
        "is_all",
        is_flag=True,
        help="Show all traffic on a brick's TCP port, Bluetooth channel and USB reports, recognised or not.",
    ),
    click.option(
        "--engine",
        type=click.Choice((BUILTIN, "wireshark")),
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
    def called(*arguments: Any, no_length: bool, only_operations: bool, **others: Any) -> Any:
        if no_length and only_operations:
            raise incompatible("--no-length", "--operations")
        names = ("dialect", "ports", "is_all", "engine", "tshark", "filter", "memory")
        given = {name: others.pop(name) for name in names}
        if given["is_all"] and given["engine"] != BUILTIN:
            raise incompatible("--all", f"--engine {given['engine']}")
        missing: Missing | None = "length" if no_length else "header" if only_operations else None
        return command(*arguments, reading=CaptureOptions(missing=missing, **given), **others)

    for option in reversed(_OPTIONS):
        option(called)
    return called  # type: ignore[return-value]
