"""`ev3proto sample`: random frames, valid or nearly valid, for testing other programs."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from functools import partial
from itertools import islice
from random import Random

import click

from ev3proto.cli.formats import formats_of, made
from ev3proto.cli.options import AREA, AREAS_HELP, Whole, dialect_option, exclusive
from ev3proto.cli.output import Failure, complain, put, say
from ev3proto.dialogue import Exchange, values_of
from ev3proto.extras import install_command
from ev3proto.messages import DirectCommand, Message
from ev3proto.schema.constructors import direct_reply
from ev3proto.schema.frame import parse
from ev3proto.schema.header import MOST_IN_REPLY
from ev3proto.tables.carriers import CARRIERS
from ev3proto.text.forms import as_hex
from ev3proto.text.phrases import Seen

MOST_SEEDS = 1 << 64


@click.command()
@click.option("-n", "--count", type=Whole(1), default=10, show_default=True, metavar="NUMBER", help="Number of frames.")
@click.option(
    "--seed",
    type=Whole(0, MOST_SEEDS - 1),
    default=0,
    show_default=True,
    metavar="NUMBER",
    help="Start of the random numbers: the same seed gives the same frames.",
)
@click.option("--op", "names", multiple=True, metavar="NAME", help="Only SOUND.TONE, all of SOUND, or LIST_FILES.")
@click.option("--area", "areas", multiple=True, type=AREA, metavar="AREA", help=f"Only operations {AREAS_HELP}")
@click.option("--type", "types", multiple=True, metavar="TYPE", help="Only DIRECT_REPLY, or the kind direct-reply.")
@click.option("--accepted", is_flag=True, help="Only commands in which `check` finds no errors.")
@click.option(
    "--carrier",
    type=click.Choice(CARRIERS),
    help="With --accepted, what carries the frames; by default, each carrier can.",
)
@click.option("--mutate", is_flag=True, help="Change, cut or lengthen the frames.")
@click.option(
    "--replies", is_flag=True, help="Write a reply of random memory after each direct command that wants one."
)
@click.option(
    "--format",
    "style",
    type=click.Choice(("hex", "raw", *formats_of("message"))),
    default="hex",
    show_default=True,
    help="Format of the output.",
)
@dialect_option
@exclusive("--accepted", "--mutate")
def sample(
    count: int,
    seed: int,
    names: tuple[str, ...],
    areas: tuple[str, ...],
    types: tuple[str, ...],
    accepted: bool,
    carrier: str | None,
    mutate: bool,
    replies: bool,
    style: str,
    dialect: str,
) -> None:
    """Generates random frames for testing other programs.

    They can be decoded, but a brick refuses many of them; with --accepted, it accepts all. --op, --area and --type can
    be repeated; together, all of them must match. --format raw writes the bytes of one frame after the other.

    \b
      ev3proto sample --count 100 --seed 7 > frames.txt
      ev3proto sample --accepted --area sound | ev3proto send virtual
      ev3proto sample --op SOUND --op UI_DRAW.LINE --format asm
      ev3proto sample --type system-reply --mutate --format raw | my_decoder
      ev3proto sample --op INPUT_DEVICE --replies --format json
    """  # noqa: D301 - the mark by which click leaves lines as they are
    # Hypothesis would write a database, which samples do not need.
    os.environ.setdefault("HYPOTHESIS_STORAGE_DIRECTORY", os.devnull)
    try:
        from ev3proto.sampling import samples  # hypothesis is an extra
        from ev3proto.testing import accepted_frames, choice, frames, mutated_frames
    except ImportError:
        raise Failure(
            "samples need hypothesis, which is not installed or too old: " + install_command("sample")
        ) from None
    if carrier is not None and not accepted:
        raise click.UsageError("--carrier belongs to --accepted")
    strategy = mutated_frames if mutate else partial(accepted_frames, carrier=carrier) if accepted else frames
    try:
        found = samples(strategy(dialect, choice(names=names, areas=areas, types=types, dialect=dialect)), seed)
    except ValueError as error:
        raise click.UsageError(str(error)) from None
    write, random = _writer(style, dialect), Random(seed)
    written = 0
    for frame in islice(found, min(count, sys.maxsize)):
        write(frame, None)
        if replies and (reply := _reply(parse(frame, strict=False, dialect=dialect), random)) is not None:
            write(reply, frame)
        written += 1
    if written < count:
        complain(f"found only {written} different frames of this kind")


def _reply(command: Message, random: Random) -> bytes | None:
    """Returns a reply to a direct command; None to other frames."""
    if not isinstance(command, DirectCommand) or not command.wants_reply:
        return None
    memory = random.randbytes(min(command.global_size, MOST_IN_REPLY))
    return direct_reply(memory, counter=command.counter).build()


def _writer(style: str, dialect: str) -> Callable[[bytes, bytes | None], object]:
    """Returns a function that writes one frame to standard output, and knows the command that it answers."""
    if style == "raw":
        return lambda frame, _: put(frame, None)
    show = None if style == "hex" else made(style)

    def write(frame: bytes, request: bytes | None) -> None:
        message = parse(frame, strict=False, dialect=dialect)
        asked = None if request is None else parse(request, strict=False, dialect=dialect)
        if show is None:
            say(as_hex(message))
        else:
            show.message(Exchange(message, asked, values_of(message, asked)), Seen())

    return write
