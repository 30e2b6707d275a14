"""Input of the command line: words become sources, problems are printed, subcommands share the options for both."""

from __future__ import annotations

import functools
import io
import os
import re
import stat
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO, NoReturn, TypeAlias

import click

from ev3proto.bounded import DEFAULT_MEMORY
from ev3proto.capture.record import Announcement, Record, Skipped
from ev3proto.checking.report import Severity
from ev3proto.cli.options import F, Whole, dialect_option, exclusive, tshark_option
from ev3proto.cli.output import ProgressBar, complain, flush, say
from ev3proto.reading.given import Given, given_word, is_file
from ev3proto.reading.incoming import IncomingFile
from ev3proto.reading.items import Event, Image, Problem, Source
from ev3proto.reading.options import BUILTIN, ENGINES, MIB, Options, Sources
from ev3proto.reading.parts import Part, Reading
from ev3proto.semantics.identify import Kind
from ev3proto.tables.discovery import TCP_PORT
from ev3proto.text.paste import Missing
from ev3proto.text.spans import visible

if TYPE_CHECKING:
    from _typeshed import WriteableBuffer

    from ev3proto.capture.filter import Filter, FilterError


# Words

STANDARD_INPUT = "-"

_GROUP = re.compile(r"(0x)?([0-9a-f]{2}:?){1,4},?", re.IGNORECASE)
"""Whole bytes in hex, which are taken for bytes even if a file has that name."""
_NUMBER = re.compile(r"[\[{]?((0x)?[0-9a-f]{1,2}|[0-9]{3})[\]}]?[,;]?", re.IGNORECASE)
"""One byte as numbers are written, also at an end of an array."""


class _Awaited(IncomingFile):
    """Input that may come slowly: standard output is flushed, and the bar redrawn, before waiting for more."""

    def __init__(self, file: str | int, bar: ProgressBar) -> None:
        super().__init__(file, closefd=isinstance(file, str))
        self._bar = bar
        found = os.fstat(self.fileno())
        self._size = found.st_size if stat.S_ISREG(found.st_mode) else 0

    def readinto(self, buffer: WriteableBuffer, /) -> int | None:
        """Reads the available bytes, at least one, or none at the end."""
        flush()
        if self._size:
            self._bar.advance(lambda: min(self.tell() / self._size, 1.0))
        count = super().readinto(buffer)
        if not count:
            self._bar.end()
        return count

    def is_silent(self, count: int) -> bool:
        """Returns whether nothing more comes for half a second."""
        flush()
        return super().is_silent(count)

    def close(self) -> None:
        """Closes the file, and ends the bar."""
        self._bar.end()
        super().close()


def named(names: Sequence[str], *, is_quiet: bool = False) -> list[Given]:
    """Returns what the words name; bytes that were typed without quotes around them are one frame.

    `is_quiet`: nothing is printed while it is read, so that a progress bar may be drawn.
    """
    if len(names) > 1 and _are_bytes(names):
        return [given_word(" ".join(names))]
    return [
        file(name, is_quiet=is_quiet) if name == STANDARD_INPUT or is_file(name) else given_word(name)
        for name in names or (STANDARD_INPUT,)
    ]


def file(name: str, *, is_quiet: bool = True) -> Given:
    """Returns a file or standard input."""
    is_standard = name == STANDARD_INPUT
    label = "standard input" if is_standard else visible(name)

    def opened() -> BinaryIO:
        bar = ProgressBar(label, is_quiet=is_quiet)
        if not is_standard:
            return io.BufferedReader(_Awaited(name, bar))
        if sys.stdin is None:
            raise OSError("standard input is closed")
        raw = getattr(sys.stdin.buffer, "raw", None)
        return io.BufferedReader(_Awaited(raw.fileno(), bar)) if isinstance(raw, io.FileIO) else sys.stdin.buffer

    return Given(label, None if is_standard else Path(name), opened, is_lent=is_standard)


def files(names: Sequence[str]) -> list[Given]:
    """Returns the files that the words name, or standard input."""
    return [file(name) for name in names]


def _are_bytes(names: Sequence[str]) -> bool:
    if all(_GROUP.fullmatch(name) for name in names):
        return True
    return all(_NUMBER.fullmatch(name) for name in names) and not any(is_file(name) for name in names)


# Problems

Captured: TypeAlias = Record | Announcement | Skipped
Other: TypeAlias = Captured | Image | Source


_READS: dict[Kind | None, str] = {
    Kind.NO_LENGTH: ": --no-length reads it",
    Kind.OPERATIONS: ": --operations reads them",
}
"""The options that read bytes which lack a part of a frame."""


class Problems:
    """Prints problems, and remembers whether any of them was an error.

    errors  the number of errors
    """

    def __init__(self, heard: Callable[[str], object] = lambda _: None) -> None:
        """`heard` is called with the sentence of each error."""
        self.errors = 0
        self._heard = heard

    def beside(self, events: Iterable[Event]) -> Iterator[Other]:
        """Yields what is read, and prints the problems among it."""
        for event in events:
            if isinstance(event, Problem):
                self.show(event)
            else:
                yield event

    def captured(self, events: Iterable[Event]) -> Iterator[Captured]:
        """Yields what is in captures and logs, in the same way."""
        return (event for event in self.beside(events) if not isinstance(event, Image | Source))

    def show(self, problem: Problem) -> None:
        """Prints a problem, with the option that avoids it, or the line of a source that it is about."""
        said = f"{problem}{_READS.get(problem.lacks, '')}"
        complain(said)
        if problem.excerpt:
            complain("\n".join(f"  {line}" for line in problem.excerpt.split("\n")))
        if problem.severity is Severity.ERROR:
            self._heard(said)
            self.errors += 1

    def records(self, events: Iterable[Event]) -> Iterator[Record]:
        """Yields the records, in the same way."""
        return (event for event in self.beside(events) if isinstance(event, Record))

    def wrong(self, sentence: str) -> None:
        """Prints an error in what was read."""
        complain(sentence)
        self._heard(sentence)
        self.errors += 1

    def end_without(self, sentence: str) -> NoReturn:
        """Ends the program because nothing was found, and says so unless an error was printed."""
        if not self.errors:
            complain(sentence)
        sys.exit(1)

    @property
    def status(self) -> int:
        """The exit status."""
        return min(self.errors, 1)


# Reading


def captures_of(names: Sequence[str], reading: Options) -> Reading:
    """Returns the reading of the captures and logs that words name, for subcommands that take nothing else."""
    return Reading(files(names), replace(reading, sources=Sources.NO, images=False))


def parts_of(
    reading: Reading,
    problems: Problems,
    count: Callable[[], int],
    nothing: Callable[[Part], Problem | None] = Part.nothing,
) -> Iterator[Part]:
    """Yields the sources, to iterate each before the next, and prints in which of them nothing was found.

    Args:
        reading: The sources.
        problems: Prints that, unless there was an error in the source.
        count: Returns how many things were found so far.
        nothing: Returns the problem for a source, or None to print nothing.
    """
    for part in reading.each():
        before = count(), problems.errors
        yield part
        if before == (count(), problems.errors) and (problem := nothing(part)) is not None:
            problems.show(problem)


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


# Options


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
