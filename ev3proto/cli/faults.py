"""The options of servers that answer badly on purpose: replies that come late, wrong or never."""

from __future__ import annotations

import functools
from random import Random
from typing import Any

import click

from ev3proto.brick.servers.host import Faults
from ev3proto.cli.options import F, FiniteRange

_SHARE = FiniteRange(0, 1)
_MOST_DELAY = 60

_OPTIONS = (
    click.option(
        "--delay", type=FiniteRange(0, _MOST_DELAY), default=0.0, metavar="SECONDS", help="Delay every reply."
    ),
    click.option("--drop", type=_SHARE, default=0.0, metavar="SHARE", help="Share of replies to lose."),
    click.option("--corrupt", type=_SHARE, default=0.0, metavar="SHARE", help="Share of replies with a wrong byte."),
    click.option("--seed", type=int, metavar="NUMBER", help="Lose and change the same replies in every run."),
)


def fault_options(command: F) -> F:
    """Adds the options to a command, which gets them as one argument, `faults`."""

    @functools.wraps(command)
    def called(*, delay: float, drop: float, corrupt: float, seed: int | None, **others: Any) -> Any:
        return command(faults=Faults(delay, drop, corrupt, Random(seed)), **others)

    for option in reversed(_OPTIONS):
        option(called)
    return called  # type: ignore[return-value]
