"""Options and functions of the subcommands that talk to a brick: target, connection, check before sending."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import closing, contextmanager
from typing import Any

import click

from ev3proto.checking.checking import check
from ev3proto.checking.codes import CODES
from ev3proto.cli.options import FiniteRange
from ev3proto.cli.output import complain, failing_on
from ev3proto.link.carriers import open_wire
from ev3proto.link.channel import Channel
from ev3proto.link.errors import LinkError
from ev3proto.link.targets import Target
from ev3proto.text.diagnostics import diagnostics
from ev3proto.text.spans import plain_text

REPLY_TIMEOUT = 30.0
"""Seconds to wait for a reply by default."""

timeout_option = click.option(
    "--timeout",
    type=FiniteRange(0, min_open=True),
    default=REPLY_TIMEOUT,
    show_default=True,
    metavar="SECONDS",
    help="Time to wait for each reply.",
)


class TargetType(click.ParamType):
    """The name of a brick."""

    name = "target"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Target:
        """Returns the brick."""
        if isinstance(value, Target):
            return value
        try:
            return Target.parse(str(value)[:200])
        except ValueError as error:
            self.fail(str(error), param, ctx)


target_option = click.option("--to", "target", type=TargetType(), required=True, help="Brick, as for `ev3proto send`.")


@contextmanager
def channel_to(target: Target) -> Iterator[Channel]:
    """Connects to a brick for the length of the context. Ends the program if that fails."""
    with failing_on(LinkError):
        channel = Channel(open_wire(target))
    with closing(channel):
        yield channel


def is_refused(frame: bytes, place: str, *, dialect: str, carrier: str, alone: bool) -> bool:
    """Returns whether the brick would refuse a frame, and prints on standard error what is wrong with it.

    For one that is sent alone, this includes the hints that it will not do what is expected, such as turn a motor.
    """
    report = check(frame, dialect=dialect, carrier=carrier, alone=alone)
    told = [one for one in report.findings if one in report.errors or CODES[one.code].alone]
    if report.accepted and not told:
        return False
    for line in diagnostics(report, told, place=place, dialect=dialect):
        complain(plain_text(line))
    return not report.accepted
