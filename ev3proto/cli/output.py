"""Standard output and standard error: everything that is printed goes through here.

Standard output is flushed before anything is written to standard error, and before waiting for more input. Control
characters are escaped, whatever their origin. Both streams may be closed, full, or a pipe without a reader.
"""

from __future__ import annotations

import csv
import json
import os
import re
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from itertools import chain, islice
from pathlib import Path
from typing import Any, BinaryIO, TextIO, cast

import click

from ev3proto.cli.options import FILE, F
from ev3proto.text.spans import Role, Spans, plain_text, visible, visible_lines
from ev3proto.whole_files import whole_file

COLOURS: dict[str, dict[str, Any]] = {
    Role.HEADING: {"bold": True},
    Role.OPERATION: {"fg": "cyan", "bold": True},
    Role.NAME: {"fg": "green"},
    Role.VALUE: {"fg": "yellow"},
    Role.MEANING: {"fg": "magenta"},
    Role.ASIDE: {"dim": True},
    Role.GUTTER: {"dim": True},
    Role.FAULT: {"fg": "red", "bold": True},
}


class OutputError(Exception):
    """Standard output cannot be written. It is not an OSError, so it is never mistaken for one of reading.

    number  the number of the error (errno), if it has one
    reason  a few words
    """

    def __init__(self, number: int | None, reason: str) -> None:
        super().__init__(f"the output cannot be written: {reason}")
        self.number = number

    @classmethod
    def of(cls, error: OSError) -> OutputError:
        """Returns the OutputError for an OSError of standard output."""
        return cls(error.errno, error.strerror or str(error))


@contextmanager
def writing_output() -> Iterator[TextIO]:
    """Yields standard output. Raises OutputError for its errors."""
    if sys.stdout is None:
        raise OutputError(None, "standard output is closed")
    try:
        yield sys.stdout
    except OSError as error:
        raise OutputError.of(error) from None


def _write(text: str, *, at_once: bool = False) -> None:
    with writing_output() as stream:
        stream.write(text)
        if at_once:
            stream.flush()


def flush() -> None:
    """Flushes standard output. Raises OutputError."""
    if sys.stdout is not None:
        with writing_output() as stream:
            stream.flush()


_AT_A_TIME = 1000
"""Lines or pieces that are written at a time."""


class Printer:
    """Prints lines: coloured on a terminal, plain into a pipe or if NO_COLOR is set.

    at_once  flush after every call, because the next one may take long
    """

    def __init__(self, *, at_once: bool = False) -> None:
        self._at_once = at_once
        is_coloured = is_terminal() and not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"
        self._text: Callable[[Spans], str] = _painted if is_coloured else plain_text

    def lines(self, lines: Iterable[Spans]) -> None:
        """Prints lines that consist of styled pieces, many at a time."""
        self._written(f"{self._text(line)}\n" for line in lines)

    def joined(self, pieces: Iterable[str]) -> None:
        """Prints one line that is made of pieces."""
        self._written(chain(map(visible, pieces), ("\n",)))

    def _written(self, pieces: Iterable[str]) -> None:
        rest = iter(pieces)
        while some := list(islice(rest, _AT_A_TIME)):
            _write("".join(some), at_once=self._at_once)

    def text(self, text: str) -> None:
        """Prints one line."""
        _write(f"{visible(text)}\n", at_once=self._at_once)


def _painted(line: Spans) -> str:
    return "".join(
        click.style(visible(text), **COLOURS[role]) if role in COLOURS else visible(text) for text, role in line
    )


def say(text: str = "") -> None:
    """Prints lines to standard output."""
    _write(f"{visible_lines(text)}\n")


def say_json(entry: Mapping[str, Any]) -> None:
    """Prints an object for other tools on one line."""
    say(json.dumps(entry, ensure_ascii=False))


_FORMULA = re.compile(r"(?![+-][0-9.]+$)[=+\-@]")
"""The beginning of a formula, but not of a number; the control characters that also count are escaped."""


class _Line:
    """A file for csv.writer, whose `writerow` returns what `write` returns."""

    def write(self, line: str) -> str:
        return line


_csv = csv.writer(_Line(), lineterminator="")


def csv_line(cells: Iterable[object]) -> str:
    """Returns one line of comma-separated values; None is an empty cell, and a float has seven digits.

    A text that a spreadsheet would take for a formula gets an apostrophe in front: it may come from a brick or a
    capture. Numbers are what they are.
    """
    line: str = _csv.writerow(map(_cell, cells))
    return line


def _cell(cell: object) -> object:
    if isinstance(cell, float):
        return f"{cell:.7g}"
    if not isinstance(cell, str):
        return cell
    text = visible(cell)
    return f"'{text}" if _FORMULA.match(text) else text


def draw(lines: Iterable[str]) -> None:
    """Prints lines without escaping: they have our own colours, and texts that went through `visible`."""
    _write("".join(f"{line}\n" for line in lines))


def complain(sentence: str) -> None:
    """Prints a message to standard error, after all earlier output.

    Errors of standard error itself are ignored; the exit status remains.
    """
    flush()
    if sys.stderr is not None:
        with suppress(OSError):
            sys.stderr.write(visible_lines(sentence) + "\n")
            sys.stderr.flush()


class Failure(click.ClickException):
    """The end of the program with a message about the input, and exit status 1."""

    def show(self, file: object = None) -> None:  # noqa: ARG002 - click's signature
        """Prints the message."""
        complain(self.message)


@contextmanager
def failing_on(*kinds: type[Exception]) -> Iterator[None]:
    """Ends the program with the message of an error of these kinds."""
    try:
        yield
    except kinds as error:
        raise Failure(str(error)) from None


@contextmanager
def failing_to(do: str, path: object) -> Iterator[None]:
    """Ends the program with `PATH: cannot be DONE: REASON` for an OSError, which may name another path."""
    try:
        yield
    except OSError as error:
        raise Failure(f"{error.filename or path}: cannot be {do}: {error.strerror or error}") from None


def is_terminal() -> bool:
    """Whether standard output is a terminal."""
    return sys.stdout is not None and sys.stdout.isatty()


class _Bytes:
    def write(self, data: bytes) -> int:
        """Writes bytes to the buffer. Raises OutputError."""
        with writing_output() as stream:
            return stream.buffer.write(data)

    def flush(self) -> None:
        """Flushes the buffer. Raises OutputError."""
        flush()


@contextmanager
def output_to(path: Path | None) -> Iterator[BinaryIO]:
    """Yields a file that appears whole at the end, or standard output. Raises OSError, or OutputError."""
    if path is None:
        with writing_output() as stdout:
            stdout.flush()
        yield cast(BinaryIO, _Bytes())
        flush()
        return
    with whole_file(path) as stream:
        yield stream


def refuse_terminal(path: object, what: str, pipe: str = "it", option: str = "-o") -> None:
    """Raises click.UsageError if there is no path, and bytes would be written to a terminal."""
    if path is None and is_terminal():
        raise click.UsageError(
            f"refusing to write {what} to a terminal; give {option} FILE, or pipe {pipe} into a program"
        )


def put(data: bytes, path: Path | None, *, check: bool = False) -> bool:
    """Writes a file, or standard output, or with `check` only compares; reports failures, and returns the success."""
    try:
        if check and path is not None and path.read_bytes() != data:
            complain(f"{path} is out of date; run this without --check to write it again")
            return False
        if not check:
            with output_to(path) as stream:
                stream.write(data)
    except OSError as error:
        complain(f"{path}: cannot be {'read' if check else 'written'}: {error.strerror or error}")
        return False
    return True


output_option = click.option("-o", "--output", type=FILE, help="Write to this file, not standard output.")

check_option = click.option("--check", is_flag=True, help="Write nothing; exit status 1 if a file is out of date.")


def output_options(command: F) -> F:
    """Adds the options -o and --check to a command."""
    return output_option(check_option(command))


def write_text(text: str, output: Path | None, *, check: bool) -> None:
    """Writes a file, or checks whether it has this text. Ends the program with status 1 if that fails."""
    if check and output is None:
        raise click.UsageError("--check needs -o")
    if not put(text.encode(), output, check=check):
        sys.exit(1)


PATIENCE = 1.0
"""Seconds of reading after which the bar appears."""

_STEPS = 1000
"""Number of steps of the bar."""


class ProgressBar:
    """A bar on a terminal once reading takes long, if nothing is printed or another place has what is printed."""

    def __init__(self, name: str, *, is_quiet: bool) -> None:
        is_seen = sys.stderr is not None and sys.stderr.isatty() and (is_quiet or not is_terminal())
        self._bar = click.progressbar(range(_STEPS), label=name, file=sys.stderr) if is_seen else None
        self._begin = time.monotonic()
        self._at = 0

    def advance(self, done: Callable[[], float]) -> None:
        """Redraws the bar; `done` returns the part that was read, 0 to 1."""
        if self._bar is not None and time.monotonic() - self._begin >= PATIENCE:
            step = int(done() * _STEPS)
            self._bar.update(step - self._at)
            self._at = step

    def end(self) -> None:
        """Ends the bar, if it was drawn."""
        if self._bar is not None and self._at:
            self._bar.render_finish()
            self._at = 0
