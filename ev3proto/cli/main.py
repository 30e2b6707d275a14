"""`ev3proto`: the group of all subcommands, and what happens to errors that reach it."""

from __future__ import annotations

import sys

import click

from ev3proto.cli.decode import decode
from ev3proto.cli.ops import ops
from ev3proto.version import VERSION

FINE, INPUT_AT_FAULT, CALL_AT_FAULT = 0, 1, 2
"""Exit statuses."""


@click.group(context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100})
@click.version_option(VERSION, prog_name="ev3proto")
def cli() -> None:
    """The wire protocol of the LEGO MINDSTORMS EV3: read frames, look operations up.

    Exit status: 0 fine, 1 the input is at fault, 2 the call is.
    """


cli.add_command(decode)
cli.add_command(ops)


def main() -> None:
    """Runs the command line. A reader that goes away (`| head`) and Ctrl-C end it quietly."""
    try:
        cli(prog_name="ev3proto")
    except BrokenPipeError:
        # Python would complain once more when it flushes at exit.
        sys.stdout = None
        sys.exit(FINE)
