"""`ev3proto help`: the help of a subcommand, or what is known of a name, a number or a code of the checker."""

from __future__ import annotations

import re

import click

from ev3proto.cli.check import check
from ev3proto.cli.commands import Group
from ev3proto.cli.ops import ops
from ev3proto.cli.output import Failure, say


@click.command()
@click.argument("words", nargs=-1)
@click.pass_context
def help(context: click.Context, words: tuple[str, ...]) -> None:  # noqa: A001 - what it is called
    """Shows the help of a subcommand, or explains an operation, a code, an encoding, a number.

    It knows the encodings of arguments (LC1), the modes of sensors (COL-COLOR), statuses, errors, and all meanings of a
    number.

    \b
      ev3proto help decode
      ev3proto help export pcapng
      ev3proto help sound.tone
      ev3proto help E205
      ev3proto help LC1
      ev3proto help COL-COLOR
      ev3proto help 0x81
    """  # noqa: D301 - the mark by which click leaves lines as they are
    parent = context.parent
    assert parent is not None
    command, found = parent.command, parent
    for number, word in enumerate(words):
        if not isinstance(command, Group):
            raise click.UsageError(f"{found.command_path} has no subcommands")
        below = command.get_command(found, word)
        if below is None and not number:
            try:
                _look_up(words)
                return
            except Failure:
                if not command.closest_to(found, word):
                    raise
        _, below, _ = command.resolve_command(found, [word])
        assert below is not None
        command, found = below, click.Context(below, info_name=word, parent=found)
    say(command.get_help(found))


def _look_up(words: tuple[str, ...]) -> None:
    if not re.fullmatch(r"[EWHewh]\d{3}", words[0]):
        ops.main(args=list(words), prog_name="ev3proto ops", standalone_mode=False)
        return
    try:
        check.main(args=["--explain", words[0].upper()], prog_name="ev3proto check", standalone_mode=False)
    except click.BadParameter as error:
        raise Failure(error.message) from None
