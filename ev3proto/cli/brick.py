"""`ev3proto brick`: a virtual brick for programs to connect to."""

from __future__ import annotations

import asyncio
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from inspect import cleandoc
from pathlib import Path
from typing import Any, NoReturn

import click

from ev3proto.brick.declared import DeclarationError
from ev3proto.brick.dispatch import coverage as covered_operations
from ev3proto.brick.limits import DEVIATIONS
from ev3proto.brick.plugs import CORE_SET_SENTENCE
from ev3proto.brick.servers.host import ServerError
from ev3proto.brick.servers.reporting import Reporter
from ev3proto.brick.servers.script import Script, read_script
from ev3proto.brick.servers.server import Options, running
from ev3proto.cli.ending import stopped_by_signals
from ev3proto.cli.faults import fault_options
from ev3proto.cli.options import (
    FILE,
    FOLDER,
    PATH,
    PORT,
    SerialNumber,
    Whole,
    bare_option,
    dialect_option,
    exclusive,
)
from ev3proto.cli.output import Failure, Printer, complain, failing_on, failing_to, flush, say
from ev3proto.cli.unblocked import unblocked_output
from ev3proto.tables.discovery import TCP_PORT
from ev3proto.temporary import temporary_folder

_MOST_CLIENTS = 1000


page_option = click.option(
    "--http",
    "page",
    type=PORT,
    is_flag=False,
    flag_value=0,
    metavar="[PORT]",
    help="Show the brick on a web page; its link is printed.",
)
root_option = click.option(
    "--root", type=FOLDER, metavar="DIR", help="Folder to use as /home/root/lms2012; by default a temporary one."
)
script_option = click.option(
    "--script", type=PATH, metavar="TOML", help="File that describes what is plugged in and what happens."
)
screenshot_option = click.option(
    "--screenshot", type=FILE, metavar="PNG", help="Save the display as a picture at the end."
)


@click.command()
@click.option(
    "--address",
    default="127.0.0.1",
    metavar="ADDRESS",
    help="Address to listen on; by default only this computer's.",
)
@click.option(
    "--port", type=PORT, default=TCP_PORT, show_default=True, metavar="PORT", help="TCP port for WiFi; 0 for any."
)
@click.option("--beacon/--no-beacon", default=True, help="Announce the brick by UDP beacon.")
@click.option("--wifi/--no-wifi", default=True, help="Let programs connect by WiFi.")
@click.option(
    "--clients",
    type=Whole(1, _MOST_CLIENTS),
    default=1,
    show_default=True,
    metavar="NUMBER",
    help="Clients served at once; a real brick serves one, and others wait.",
)
@click.option("--serial", type=PATH, metavar="PATH", help="Also offer a serial port, linked to this path.")
@page_option
@root_option
@script_option
@bare_option
@click.option("--record", type=FILE, metavar="FILE", help="Record to this capture file (pcapng).")
@click.option("--force", is_flag=True, help="Overwrite the file of --record, if it exists.")
@click.option(
    "--report",
    is_flag=True,
    help="At the end, report what `check` finds in the clients' frames; exit status 1 if there are errors.",
)
@click.option("--errors-only", is_flag=True, help="Report errors only.")
@click.option("--json", "as_json", is_flag=True, help="Report one JSON object a line.")
@click.option(
    "--serial-number", type=SerialNumber(), metavar="HEX", help="Serial number of the brick, 12 hexadecimal digits."
)
@screenshot_option
@dialect_option
@click.option("--quiet", is_flag=True, help="Do not mention the equipment and the differences from a real brick.")
@click.option("--coverage", is_flag=True, help="List the operations that are not implemented, and exit.")
@fault_options
@exclusive("--no-wifi", "--port", "--beacon")
def brick(
    port: int,
    wifi: bool,
    root: Path | None,
    script: Path | None,
    bare: bool,
    errors_only: bool,
    as_json: bool,
    quiet: bool,
    coverage: bool,
    **same: Any,
) -> None:
    """Runs a virtual brick for programs to connect to.

    It answers as the firmware V1.04H does. Programs connect by WiFi on this computer, or on a serial port. The first
    line of its output says where it listens; Ctrl-C switches it off.

    The equipment of LEGO's core set is plugged in: a medium motor on A, large motors on B and C; a touch sensor on 1
    (not pressed), a gyro on 2 (0 degrees), a colour sensor on 3 (it sees nothing, ambient light 10 %), an ultrasonic
    sensor on 4 (255 cm). Any [ports] in a script replace all of it.

    \b
    A script describes what is plugged in, with raw readings, and what happens:
      name = "EV3"               # at most 12 characters
      voltage = 7.9              # volt
      current = 0.18             # ampere
      period = 4.0               # seconds after which the steps start again
      [ports.1]
      type = "TYPE_TOUCH"        # a name or number of TYPE
      readings.0 = [0]           # mode 0
      [ports.B]
      type = "TYPE_TACHO"
      [[steps]]
      at = 1.5                   # seconds
      ports.1.0 = 4000           # mode 0 of port 1
      press = "enter"            # or release = "enter"

    \b
      ev3proto brick
      ev3proto brick --http --script robot.toml
      ev3proto brick --serial /tmp/ev3 --record talk.pcapng --report
    """  # noqa: D301 - the mark by which click leaves lines as they are
    if coverage:
        _show_coverage(same["dialect"])
        return
    options = Options(port=port if wifi else None, script=read_script_file(script), core_set=not bare, **same)
    if (errors_only or as_json) and not options.report:
        raise click.UsageError("--errors-only and --json need --report")
    if {options.port, options.serial, options.page} == {None}:
        raise click.UsageError("--no-wifi needs --serial or --http; otherwise no client can reach the brick")
    if not quiet:
        if options.has_core_set:
            complain(CORE_SET_SENTENCE)
        complain(f"this brick differs from a real one in {len(DEVIATIONS)} ways: ev3proto brick --help lists them")
    with folder(root) as place, unblocked_output():
        reporter = asyncio.run(_serve(options, place))
    if reporter is not None:
        _report(reporter, as_json=as_json, errors_only=errors_only)


def _report(reporter: Reporter, *, as_json: bool, errors_only: bool) -> NoReturn:
    if as_json:
        for line in reporter.json_lines(errors_only=errors_only):
            say(line)
    else:
        Printer().lines(reporter.lines(errors_only=errors_only))
    sys.exit(1 if reporter.has_errors else 0)


def _with_differences(about: str) -> str:
    """Returns a help that also lists how the virtual brick differs from a real one on purpose."""
    listed = "\n\n".join(f"- {sentence}" for sentence in DEVIATIONS)
    text, examples_mark, examples = cleandoc(about).rpartition("\n\n\b\n")
    return f"{text}\n\nIt differs from a real brick on purpose:\n\n{listed}{examples_mark}{examples}"


brick.help = _with_differences(brick.help or "")


async def _serve(options: Options, root: Path) -> Reporter | None:
    """Runs the brick until it is interrupted. Returns the report on the clients' frames, if there is one."""
    with failing_on(ServerError):
        async with running(options, root, complain) as now:
            with interrupted() as ended:
                if now.port:
                    say(f"listening on {f'[{now.address}]' if ':' in now.address else now.address}:{now.port}")
                if options.serial is not None:
                    say(f"serial port at {options.serial}")
                if now.link:
                    say(f"page at {now.link}")
                flush()
                await ended.wait()
            return now.reporter


@contextmanager
def interrupted() -> Iterator[asyncio.Event]:
    """Yields an event that the first Ctrl-C or SIGTERM sets; the second one ends the program."""
    loop = asyncio.get_running_loop()
    ended = asyncio.Event()
    # asyncio's own signal handlers do not exist on Windows.
    with stopped_by_signals(lambda: loop.call_soon_threadsafe(ended.set)):
        yield ended


@contextmanager
def folder(root: Path | None) -> Iterator[Path]:
    """Yields the folder of the brick's files: the one named, created if missing, or a temporary one."""
    if root is None:
        with temporary_folder() as fresh:
            yield fresh
        return
    with failing_to("created", root):
        root.mkdir(parents=True, exist_ok=True)
    yield root


def read_script_file(path: Path | None) -> Script:
    """Returns the script in a file; an empty one without a file. Ends the program if it is unreadable or invalid."""
    if path is None:
        return Script()
    try:
        with failing_to("read", path):
            return read_script(path)
    except DeclarationError as error:
        raise Failure(f"{path}: {error}") from None


def _show_coverage(dialect: str) -> None:
    names = list(covered_operations(dialect))
    missing = [name for name, is_there in names if not is_there]
    for name in missing:
        say(name)
    complain(f"{len(names) - len(missing)} of {len(names)} operations are implemented")
