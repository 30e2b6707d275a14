"""The page of the documentation on the command line: what `--help` prints of every subcommand."""

from __future__ import annotations

from collections.abc import Iterator

import click

from ev3proto.cli.commands import cli
from ev3proto.generate.pages.build import FOLDER
from ev3proto.generate.pages.markdown import block, page, table

_WIDTH = 100
_NAME = "ev3proto"


def reference_page() -> dict[str, str]:
    """The page by its path in the project's folder."""
    return {f"{FOLDER}/command-line.md": page("The command line", _lines())}


def _lines() -> Iterator[str]:
    context = click.Context(cli, info_name=_NAME, max_content_width=_WIDTH, terminal_width=_WIDTH)
    found = list(_commands(cli, context))
    yield "Exit status: 0 fine, 1 the input is at fault, 2 the call is."
    yield ""
    yield from table(
        ("command", "what it does"),
        (
            (f"[{context.command_path}](#{context.command_path.replace(' ', '-')})", command.get_short_help_str(200))
            for command, context in found
        ),
    )
    for command, context in found:
        yield f"## {context.command_path}"
        yield ""
        yield from block("text", (line.rstrip() for line in command.get_help(context).splitlines()))


def _commands(command: click.Command, context: click.Context) -> Iterator[tuple[click.Command, click.Context]]:
    """A command and all below it, each with the context in which it describes itself."""
    yield command, context
    if isinstance(command, click.Group):
        for name in command.list_commands(context):
            below = command.get_command(context, name)
            if below is not None and not below.hidden:
                inner = click.Context(
                    below, parent=context, info_name=name, max_content_width=_WIDTH, terminal_width=_WIDTH
                )
                yield from _commands(below, inner)
