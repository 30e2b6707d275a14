"""The options of servers that answer badly on purpose: replies that come late, wrong or never."""

from __future__ import annotations

from random import Random

import click

from ev3proto.brick.servers.host import Faults
from ev3proto.cli.options import FiniteRange, gathered

_SHARE = FiniteRange(0, 1)
_MOST_DELAY = 60

fault_options = gathered(
    Faults,
    "faults",
    click.option(
        "--delay", type=FiniteRange(0, _MOST_DELAY), default=0.0, metavar="SECONDS", help="Delay every reply."
    ),
    click.option("--drop", type=_SHARE, default=0.0, metavar="SHARE", help="Share of replies to lose."),
    click.option("--corrupt", type=_SHARE, default=0.0, metavar="SHARE", help="Share of replies with a wrong byte."),
    click.option(
        "--seed",
        "random",
        type=int,
        callback=lambda _context, _parameter, seed: Random(seed),
        metavar="NUMBER",
        help="Lose and change the same replies in every run.",
    ),
)
"""The options, which a command gets as one argument, `faults`."""
