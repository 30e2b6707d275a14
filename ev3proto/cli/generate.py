"""`python -m ev3proto.generate` writes all files that are generated and checked in.

With `--check` it writes nothing and exits with status 1 if a file is not what would be written.
"""

from __future__ import annotations

import sys
from pathlib import Path

import click

from ev3proto.cli.reference_page import reference_page
from ev3proto.generate.everything import COMMAND, outdated, write

_OF_THE_PROJECT = ("pyproject.toml", "dissector", "exports")
"""What is beside the package in the project's folder, and not where the package is installed by itself."""


@click.command(help=__doc__)
@click.option("--check", is_flag=True, help="Write nothing; exit status 1 if a file is not what would be written.")
@click.option(
    "--root",
    type=click.Path(path_type=Path, exists=True, file_okay=False),
    help="The project's folder; when omitted, the one that this package is in.",
)
def main(check: bool, root: Path | None) -> None:
    """Writes or checks the files."""
    if root is None:
        root = Path(__file__).parents[2]
        if not any((root / name).exists() for name in _OF_THE_PROJECT):
            raise click.UsageError("this ev3proto is installed without its project: give --root, the project's folder")
    if not check:
        try:
            for path in write(root, reference_page()):
                click.echo(path)
        except OSError as error:
            click.echo(f"{error.filename}: cannot be written: {error.strerror}", err=True)
            sys.exit(1)
        return
    found = list(outdated(root, reference_page()))
    for path in found:
        click.echo(f"{path} is out of date: run {COMMAND}", err=True)
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main(prog_name=COMMAND)
