"""`ev3proto`: the group of all subcommands, and how a command ends."""

from __future__ import annotations

import errno
import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from difflib import get_close_matches
from importlib import import_module
from io import TextIOWrapper
from pathlib import Path
from traceback import walk_tb
from typing import Any, NoReturn, TextIO

import click

from ev3proto.cli.ending import ended_behind
from ev3proto.cli.output import OutputError, complain, flush
from ev3proto.text.spans import visible_lines
from ev3proto.version import REPORT_IT, VERSION


class Group(click.Group):
    """A group that shows the first sentence of each subcommand in full, and suggests one for a misspelt name."""

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Finds a subcommand. Raises click.UsageError for an unknown one."""
        if self.get_command(ctx, args[0]) is None and not args[0].startswith("-"):
            close = self.closest_to(ctx, args[0])
            ctx.fail(f"No such command {args[0]!r}." + (f" Did you mean {close!r}?" if close else ""))
        return super().resolve_command(ctx, args)

    def closest_to(self, ctx: click.Context, name: str) -> str | None:
        """Returns the subcommand that a misspelt name may mean."""
        return next(iter(get_close_matches(name, self.list_commands(ctx), 1)), None)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Lists the subcommands, each with the first sentence of its help."""
        rows = []
        for name in self.list_commands(ctx):
            command = self.get_command(ctx, name)
            if command is not None and not command.hidden:
                rows.append((name, first_sentence(command)))
        if rows:
            with formatter.section("Commands"):
                formatter.write_dl(rows)


def first_sentence(command: click.Command) -> str:
    """Returns the first sentence of a command's help, without its full stop."""
    paragraph = " ".join((command.help or "").partition("\n\n")[0].split())
    return paragraph.partition(". ")[0].removesuffix(".")


SUBCOMMANDS = {
    "brick": "Runs a virtual brick for programs to connect to",
    "check": "Checks whether the brick accepts a frame, which byte is wrong if not, and how to fix it",
    "copy": "Copies a file to or from a brick",
    "decode": "Shows the contents of frames, captures and programs",
    "dissector": "Builds, installs or removes the dissector for Wireshark",
    "encode": "Builds frames from assembly, JSON or other notations, and programs from their sources",
    "export": "Writes the protocol, or frames, in the formats of other tools",
    "extcap": "Captures for Wireshark through `ev3proto proxy`; Wireshark runs this, users do not",
    "files": "Recovers the files that were transferred to or from the brick",
    "help": "Shows the help of a subcommand, or explains an operation, a code, an encoding, a number",
    "live": "Shows dialogues live, one a line, with values and latency",
    "ops": "Lists or searches the operations, or shows one in full",
    "proxy": "Relays between a program and a brick, shows the dialogues and records them",
    "replay": "Sends the commands of a capture again, and compares the replies with the recorded ones",
    "run": "Runs a program (.rbf or .lms) on a virtual brick until it ends",
    "sample": "Generates random frames for testing other programs",
    "send": "Sends frames to a brick and shows the replies",
    "stats": "Counts the messages, errors and files in captures and logs",
    "timeline": "Draws a timeline of messages, latencies, files and faults",
    "values": "Shows values over time: battery, sensors, motors, latencies, mailbox messages",
}
"""The subcommands, each with the first sentence of its help. Each is a module that is imported when it is used:
importing all of them takes 300 ms."""

INTERNAL_ERROR = 70
"""Exit status for a defect of ev3proto, as in sysexits.h."""

DEBUG = "EV3PROTO_DEBUG"
"""The environment variable that makes an internal error show its traceback."""


class Commands(Group):
    """The group of subcommands. It ends with an exit status, never with a traceback."""

    def list_commands(self, _context: click.Context) -> list[str]:
        """Returns the names of all subcommands, in order."""
        return list(SUBCOMMANDS)

    def get_command(self, _context: click.Context, name: str) -> click.Command | None:
        """Returns the subcommand of this name; None for an unknown one."""
        if name not in SUBCOMMANDS:
            return None
        command: click.Command = getattr(import_module(f"ev3proto.cli.{name}"), name)
        return command

    def format_commands(self, _context: click.Context, formatter: click.HelpFormatter) -> None:
        """Lists the subcommands, without importing them."""
        with formatter.section("Commands"):
            formatter.write_dl(list(SUBCOMMANDS.items()))

    def make_context(self, *args: Any, **extra: Any) -> click.Context:
        """Reads the arguments."""
        with _printing_help():
            return super().make_context(*args, **extra)

    def invoke(self, context: click.Context) -> Any:
        """Runs the subcommand, and flushes its output unless a signal ended it: the reader may have stopped."""
        with _printing_help():
            try:
                return super().invoke(context)
            finally:
                if ended_behind(sys.exception()) is None:
                    flush()

    def main(  # type: ignore[override]
        self, args: Sequence[str] | None = None, prog_name: str | None = None, **extra: Any
    ) -> NoReturn:
        """Runs a command, and exits with 0 (fine), 1 (input), 2 (usage), 70 (a defect) or 128 and a signal."""
        extra["standalone_mode"] = False
        if isinstance(sys.stdout, TextIOWrapper):
            # Characters that the terminal cannot show are written as escapes.
            sys.stdout.reconfigure(errors="backslashreplace")
        try:
            status = super().main(args, prog_name, **extra)
        except Exception as error:
            status = _status_after(error)
        _forget_unwritten()
        sys.exit(status if isinstance(status, int) else 0)


def _status_after(error: Exception) -> int:
    """Prints why the program ends, and returns its exit status. Raises what a signal or DEBUG is behind again."""
    if isinstance(error, click.ClickException):
        error.message = visible_lines(error.message)
        with suppress(OSError):
            error.show()
        return error.exit_code
    if isinstance(error, click.Abort):
        return 1
    if isinstance(error, OutputError):
        _forget(sys.stdout)
        if error.number == errno.EPIPE:
            return 0
        complain(str(error))
        return 1
    if isinstance(error, OSError):
        place = "reading or writing failed" if error.filename is None else error.filename
        _say_last(f"{place}: {error.strerror or error}")
        return 1
    if ended_behind(error) is not None or os.environ.get(DEBUG):
        raise error
    _say_last(
        f"ev3proto: internal error, {REPORT_IT}: {type(error).__name__}: {error}"
        f" (with {DEBUG}=1 in the environment it says where)"
    )
    return INTERNAL_ERROR


@contextmanager
def _printing_help() -> Iterator[None]:
    """Raises OutputError for errors of standard output while click prints help or the version."""
    try:
        yield
    except click.exceptions.Exit:
        # Click silently prints nothing to a closed stream.
        if sys.stdout is None:
            raise OutputError(None, "standard output is closed") from None
        raise
    except OSError as error:
        # Whether it comes from printing by click, not from reading.
        is_of_click = any(frame.f_code is click.echo.__code__ for frame, _ in walk_tb(error.__traceback__))
        if isinstance(error, BrokenPipeError) or is_of_click:
            raise OutputError.of(error) from None
        raise


def _forget_unwritten() -> None:
    """Discards what could not be written to the standard streams; it has been reported."""
    for stream in (sys.stdout, sys.stderr):
        if stream is not None:
            try:
                stream.flush()
            except OSError:
                _forget(stream)


def _forget(stream: TextIO | None) -> None:
    """Discards unwritten output: Python would try to write it at exit, and report that error."""
    if stream is None:
        return
    with suppress(OSError, ValueError), Path(os.devnull).open("wb") as nowhere:
        os.dup2(nowhere.fileno(), stream.fileno())


def _say_last(sentence: str) -> None:
    with suppress(OutputError):  # standard error may still work
        flush()
    complain(sentence)


@click.group(cls=Commands, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100})
@click.version_option(VERSION, "-V", "--version", prog_name="ev3proto")
def cli() -> None:
    """Decodes, checks, builds and sends messages of the LEGO MINDSTORMS EV3's wire protocol.

    Exit status: 0 success, 1 wrong input, 2 wrong use of the command, 70 a bug in ev3proto, 130 Ctrl-C.

    \b
      ev3proto decode robot.pcapng
      ev3proto check 08000100000500810161
      ev3proto help encode
      ev3proto help sound.tone
    """  # noqa: D301 - the mark by which click leaves lines as they are
