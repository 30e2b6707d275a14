"""Options that several subcommands have, and the errors of options that do not fit together."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Any

import click
from click.core import ParameterSource

from ev3proto.tables import AREAS
from ev3proto.tables.declaration import DIALECTS


class FiniteRange(click.FloatRange):
    """A finite number in a range."""

    name = "number"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        """Returns the number."""
        number = float(super().convert(value, param, ctx))
        if not math.isfinite(number):
            self.fail(f"{number} is not a finite number", param, ctx)
        return number


class Whole(click.IntRange):
    """A whole number in a range."""

    name = "integer"


class SerialNumber(click.ParamType):
    """A brick's serial number."""

    name = "hex"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """Returns the number as the brick shows it, in lower case."""
        text = str(value)
        if not re.fullmatch("[0-9A-Fa-f]{12}", text):
            self.fail(f"invalid serial number {text[:60]!r}; expected 12 hexadecimal digits", param, ctx)
        return text.lower()


FILE = click.Path(dir_okay=False, path_type=Path)
FOLDER = click.Path(file_okay=False, path_type=Path)
PATH = click.Path(path_type=Path)
PORT = Whole(0, 65535)
"""Types of options: a file, a folder, a path of any kind, a TCP port where 0 means a free one."""


dialect_option = click.option(
    "--dialect",
    type=click.Choice(DIALECTS),
    default=DIALECTS[0],
    show_default=True,
    help="Firmware whose instruction set to use.",
)

json_option = click.option("--json", "as_json", is_flag=True, help="Print one JSON object a line.")

bare_option = click.option(
    "--bare", is_flag=True, help="Plug nothing into the virtual brick, instead of LEGO's core set."
)

reply_option = click.option(
    "--reply/--no-reply",
    default=None,
    help="Whether assembly without a header wants a reply; by default if its operations return values.",
)

tshark_option = click.option("--tshark", metavar="PATH", help="Path of tshark, if it is not on the PATH.")

AREA = click.Choice([*AREAS, "system"])
AREAS_HELP = f"of this area of the firmware: {', '.join(AREAS)}, system."


def incompatible(first: str, second: str, reason: str = "") -> click.UsageError:
    """Returns the error for two options that exclude each other, with a reason where it is not obvious."""
    return click.UsageError(f"{first} and {second} cannot be used together{reason and ': '}{reason}")


def given_options(*names: str) -> list[str]:
    """Returns those of some options that were typed, as they are written; of two opposite ones, the one given."""
    context = click.get_current_context()
    typed = [name for name in names if context.get_parameter_source(name) is ParameterSource.COMMANDLINE]
    options = {str(option.name): option for option in context.command.params}
    return [
        (options[name].secondary_opts or options[name].opts)[-1]
        if context.params.get(name) is False
        else options[name].opts[-1]
        for name in typed
    ]
