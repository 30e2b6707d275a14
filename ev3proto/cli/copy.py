"""`ev3proto copy`: a file to or from a brick, with a progress bar."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import click

from ev3proto.cli.output import failing_on, failing_to, say
from ev3proto.cli.targets import TargetType
from ev3proto.errors import BuildError
from ev3proto.link.errors import LinkError
from ev3proto.link.ev3 import EV3
from ev3proto.link.file_moves import nothing_moved
from ev3proto.link.targets import Target

ON_BRICK = "brick:"
"""Prefix of a path on the brick."""


@click.command()
@click.argument("target", type=TargetType())
@click.argument("source")
@click.argument("destination")
def copy(target: Target, source: str, destination: str) -> None:
    """Copies a file to or from a brick.

    TARGET is the brick, as for `ev3proto send`. Either SOURCE or DESTINATION is a path on the brick, written
    brick:PATH, absolute or relative to /home/root/lms2012/sys; the other is a file of this computer. Missing folders on
    the brick are created. Afterwards, the MD5 sums of the two files are compared.

    \b
      ev3proto copy wifi tone.rbf brick:../prjs/tone/tone.rbf
      ev3proto copy usb brick:../prjs/tone/tone.rbf tone.rbf
    """  # noqa: D301 - the mark by which click leaves lines as they are
    is_from_brick = source.startswith(ON_BRICK)
    if is_from_brick and destination.startswith(ON_BRICK):
        raise click.UsageError("SOURCE and DESTINATION are both on the brick; one must be a file of this computer")
    if not is_from_brick and not destination.startswith(ON_BRICK):
        raise click.UsageError("neither SOURCE nor DESTINATION is on the brick; write its path there as brick:PATH")

    done = "written" if is_from_brick else "read"
    local = destination if is_from_brick else source
    with failing_on(LinkError, BuildError), failing_to(done, local), EV3(target=target) as brick, _bar() as moved:
        if is_from_brick:
            size = len(brick.upload(source.removeprefix(ON_BRICK), Path(local), moved))
        else:
            size = brick.download(Path(local), destination.removeprefix(ON_BRICK), moved).size
    say(f"{source} -> {destination}: {size} bytes, the same MD5")


@contextmanager
def _bar() -> Iterator[Callable[[int, int], None]]:
    """Yields a function that draws the bar: bytes copied so far, and in all. Without a terminal it does nothing."""
    if sys.stderr is None or not sys.stderr.isatty():
        yield nothing_moved
        return

    def shown(moved: tuple[int, int] | None) -> str | None:
        return None if moved is None else f"{moved[0]:,} of {moved[1]:,} bytes"

    with click.progressbar([(0, 0)], item_show_func=shown, file=sys.stderr) as bar:

        def moved(done: int, size: int) -> None:
            bar.length = size
            bar.update(done - bar.pos, (done, size))

        yield moved
