"""`python -m ev3proto.generate` writes all generated files that are checked in.

With `--check` it writes nothing, and exits with status 1 if a file is out of date.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import click

from ev3proto.cli.commands import cli
from ev3proto.generate.everything import COMMAND, outdated, write, write_modules
from ev3proto.generate.pages import python_api
from ev3proto.generate.pages.build import FOLDER
from ev3proto.generate.pages.markdown import block, page, table
from ev3proto.generate.tables_json.build import TABLES_NAME
from ev3proto.tables import clashes

_OF_THE_PROJECT = ("pyproject.toml", "dissector", "exports")
"""Parts of the project's folder that an installed package does not have."""


_WIDTH = 100
_NAME = "ev3proto"


MODULES = (
    "ev3proto",
    "ev3proto.reading",
    "ev3proto.schema",
    "ev3proto.capture",
    "ev3proto.program",
    "ev3proto.system",
    "ev3proto.brick",
    "ev3proto.testing",
)
"""The public modules; each lists its names in `__all__`."""


def reference_pages() -> dict[str, str]:
    """Returns the pages about the package itself, by their path in the project's folder."""
    return {
        f"{FOLDER}/command-line.md": page("The command line", _lines()),
        f"{FOLDER}/python.md": page("The Python API", python_api.blocks(MODULES)),
    }


def _lines() -> Iterator[str]:
    context = click.Context(cli, info_name=_NAME, max_content_width=_WIDTH, terminal_width=_WIDTH)
    found = list(_commands(cli, context))
    yield "Exit status: 0 fine, 1 the input is at fault, 2 the call is."
    yield table(
        ("command", "what it does"),
        (
            (f"[{context.command_path}](#{context.command_path.replace(' ', '-')})", command.get_short_help_str(200))
            for command, context in found
        ),
    )
    for command, context in found:
        yield f"## {context.command_path}"
        yield block("text", (line.rstrip() for line in command.get_help(context).splitlines()))


def _commands(command: click.Command, context: click.Context) -> Iterator[tuple[click.Command, click.Context]]:
    """Yields a command and all below it, each with a context for its help."""
    yield command, context
    if isinstance(command, click.Group):
        for name in command.list_commands(context):
            below = command.get_command(context, name)
            if below is not None and not below.hidden:
                inner = click.Context(
                    below, parent=context, info_name=name, max_content_width=_WIDTH, terminal_width=_WIDTH
                )
                yield from _commands(below, inner)


def _used_twice(root: Path) -> Iterator[str]:
    """Yields a sentence for each number that is used twice; the tables that were exported last tell which is new."""
    exported = root / "exports" / TABLES_NAME
    before = exported.read_text(encoding="utf-8") if exported.is_file() else ""
    for number, names in clashes():
        old, new = sorted(names, key=lambda name: f'"{name.rpartition(".")[2]}"' not in before)
        yield f"{number} is already {old}: give {new} a number that is free"


def _own_root() -> Path:
    """Returns the folder of the project that this package is in. Raises click.UsageError if it is installed alone."""
    root = Path(__file__).parents[2]
    if not any((root / name).exists() for name in _OF_THE_PROJECT):
        raise click.UsageError("this ev3proto is installed without its project: give --root, the project's folder")
    return root


@click.command(help=__doc__)
@click.option("--check", is_flag=True, help="Write nothing; exit status 1 if a file is not what would be written.")
@click.option(
    "--root",
    type=click.Path(path_type=Path, exists=True, file_okay=False),
    help="The project's folder; when omitted, the one that this package is in.",
)
def main(check: bool, root: Path | None) -> None:
    """Writes or checks the files."""
    root = root or _own_root()
    if found := list(_used_twice(root)):
        click.echo("\n".join(found), err=True)
        sys.exit(1)
    if not check:
        try:
            # The pages and the command line import these modules, so they are written first.
            for path in write_modules(root):
                click.echo(path)
            for path in write(root, reference_pages()):
                click.echo(path)
        except OSError as error:
            click.echo(f"{error.filename}: cannot be written: {error.strerror}", err=True)
            sys.exit(1)
        return
    old = list(outdated(root, reference_pages()))
    for path in old:
        click.echo(f"{path} is out of date: run {COMMAND}", err=True)
    sys.exit(1 if old else 0)


if __name__ == "__main__":
    main(prog_name=COMMAND)
