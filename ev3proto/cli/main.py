"""`ev3proto`: the group of all subcommands, and where the script on the path starts."""

from __future__ import annotations

import sys

import click

from ev3proto.cli.brick import brick
from ev3proto.cli.check import check
from ev3proto.cli.decode import decode
from ev3proto.cli.dissector import dissector
from ev3proto.cli.encode import encode
from ev3proto.cli.export import export
from ev3proto.cli.files import files
from ev3proto.cli.live import live
from ev3proto.cli.ops import ops
from ev3proto.cli.output import complain
from ev3proto.cli.proxy import proxy
from ev3proto.cli.replay import replay
from ev3proto.cli.run import run
from ev3proto.cli.sample import sample
from ev3proto.cli.send import send
from ev3proto.cli.stats import stats
from ev3proto.cli.timeline import timeline
from ev3proto.version import VERSION


@click.group(context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100})
@click.version_option(VERSION, prog_name="ev3proto")
def cli() -> None:
    """The wire protocol of the LEGO MINDSTORMS EV3: read frames and captures, look operations up.

    Exit status: 0 fine, 1 the input is at fault, 2 the call is.
    """


cli.add_command(brick)
cli.add_command(check)
cli.add_command(decode)
cli.add_command(dissector)
cli.add_command(encode)
cli.add_command(export)
cli.add_command(files)
cli.add_command(live)
cli.add_command(ops)
cli.add_command(proxy)
cli.add_command(replay)
cli.add_command(run)
cli.add_command(sample)
cli.add_command(send)
cli.add_command(stats)
cli.add_command(timeline)


def main() -> None:
    """Runs the command line. click ends it quietly when a reader goes away (`| head`) and on Ctrl-C."""
    try:
        cli(prog_name="ev3proto")
    except OSError as error:
        complain(f"the output cannot be written: {error.strerror or error}")
        sys.exit(1)
