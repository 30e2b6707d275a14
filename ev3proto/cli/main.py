"""`ev3proto`: the group of all subcommands, and where the script on the path starts."""

from __future__ import annotations

import errno
import gc
import os
import sys
from collections.abc import Sequence
from contextlib import suppress
from importlib import import_module
from pathlib import Path
from typing import Any, NoReturn

import click

from ev3proto.cli.groups import Group
from ev3proto.cli.output import OutputError, complain, flush
from ev3proto.text.visible import visible_lines
from ev3proto.version import VERSION

SUBCOMMANDS = (
    "brick",
    "check",
    "copy",
    "decode",
    "dissector",
    "encode",
    "export",
    "files",
    "help",
    "live",
    "ops",
    "proxy",
    "replay",
    "run",
    "sample",
    "send",
    "stats",
    "timeline",
    "values",
)
"""The subcommands. Each is a module of its own, which is imported when its command is used: commands start sooner."""

INTERNAL_ERROR = 70
"""Exit status where ev3proto itself is at fault, as sysexits.h has it."""

DEBUG = "EV3PROTO_DEBUG"
"""The environment variable that shows where an internal error comes from."""

_OBJECTS = 50_000
"""New objects after which Python looks for circles of objects that nobody refers to any more. A long capture makes
millions of tuples, and none of them is in a circle. Reading one takes twice as long with Python's usual 700."""


class Commands(Group):
    """The subcommands, and how everything ends: with an exit status, and never with a traceback."""

    def list_commands(self, _context: click.Context) -> list[str]:
        """The names of all, in order."""
        return list(SUBCOMMANDS)

    def get_command(self, _context: click.Context, name: str) -> click.Command | None:
        """The command of that name, None where there is none."""
        if name not in SUBCOMMANDS:
            return None
        command: click.Command = getattr(import_module(f"ev3proto.cli.{name}"), name)
        return command

    def main(  # type: ignore[override]
        self, args: Sequence[str] | None = None, prog_name: str | None = None, **extra: Any
    ) -> NoReturn:
        """Runs a command, and exits with 0 (fine), 1 (the input is at fault), 2 (the call is) or 70 (ev3proto is)."""
        extra["standalone_mode"] = False
        try:
            status = super().main(args, prog_name, **extra)
        except click.ClickException as error:
            error.message = visible_lines(error.message)
            error.show()
            status = error.exit_code
        except click.Abort:
            _say_last("interrupted")
            status = 1
        except OutputError as error:
            _forget_output()
            if error.number != errno.EPIPE:
                complain(str(error))
            status = 1
        except OSError as error:
            _say_last(f"the output cannot be written: {error.strerror or error}")
            status = 1
        except (Exception, RecursionError) as error:
            if os.environ.get(DEBUG):
                raise
            _say_last(
                f"ev3proto: internal error, please report it: {type(error).__name__}: {error}"
                f" (with {DEBUG}=1 in the environment it says where)"
            )
            status = INTERNAL_ERROR
        sys.exit(status if isinstance(status, int) else 0)


def _forget_output() -> None:
    """Lets what could not be written go: Python would try once more at its end, and report that it cannot."""
    if sys.stdout is None:
        return
    with suppress(OSError, ValueError), Path(os.devnull).open("wb") as nowhere:
        os.dup2(nowhere.fileno(), sys.stdout.fileno())


def _say_last(sentence: str) -> None:
    with suppress(OutputError):  # standard error may still work
        flush()
    complain(sentence)


@click.group(cls=Commands, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100})
@click.version_option(VERSION, "-V", "--version", prog_name="ev3proto")
def cli() -> None:
    """The wire protocol of the LEGO MINDSTORMS EV3: read frames and captures, look operations up.

    Exit status: 0 fine, 1 the input is at fault, 2 the call is, 70 ev3proto itself is.
    """


def main() -> None:
    """Runs the command line."""
    gc.set_threshold(_OBJECTS)
    cli(prog_name="ev3proto")
