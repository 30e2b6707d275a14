"""Options that several subcommands have, and the errors of options that do not fit together."""

from __future__ import annotations

import functools
import math
import re
from collections.abc import Callable
from dataclasses import fields
from pathlib import Path
from typing import Any, TypeVar

import click
from click.core import ParameterSource

from ev3proto.tables import AREAS
from ev3proto.tables.declaration import DIALECTS

F = TypeVar("F", bound=Callable[..., Any])


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


def gathered(kind: type[Any], name: str, *options: Callable[[F], F]) -> Callable[[F], F]:
    """Returns a decorator that adds options to a command, which gets them as one object.

    Args:
        kind: A dataclass with a field for each option.
        name: The argument of the command that is the object.
        options: Decorators that add one option each, in the order of the help.
    """
    names = [field.name for field in fields(kind)]

    def added(command: F) -> F:
        @functools.wraps(command)
        def called(*arguments: Any, **others: Any) -> Any:
            found = kind(**{each: others.pop(each) for each in names})
            return command(*arguments, **{name: found}, **others)

        for option in reversed(options):
            option(called)
        return called  # type: ignore[return-value]

    return added


def exclusive(first: str, *others: str, reason: str = "") -> Callable[[F], F]:
    """Returns a decorator that refuses an option together with others, with a reason where it is not obvious.

    Options are named as they are typed, `--json`; `--format=sarif` means it with this value, and `--format!json` with
    any other.
    """

    def added(command: F) -> F:
        @functools.wraps(command)
        def called(*arguments: Any, **given: Any) -> Any:
            for one in given_options(first):
                if wrong := given_options(*others):
                    raise incompatible(one, ", ".join(wrong), reason)
            return command(*arguments, **given)

        return called  # type: ignore[return-value]

    return added


_OPTION = re.compile(r"(?P<name>[\w-]+)(?:(?P<sign>[=!])(?P<value>.*))?")


def _typed(wanted: str) -> str | None:
    """Returns an option as it was typed on the command line; None if it was not, or with another value."""
    context, found = click.get_current_context(), _OPTION.fullmatch(wanted)
    assert found is not None
    option = next(each for each in context.command.params if found["name"] in (*each.opts, *each.secondary_opts))
    if context.get_parameter_source(str(option.name)) is not ParameterSource.COMMANDLINE:
        return None
    value = context.params.get(str(option.name))
    if isinstance(value, bool):
        return found["name"] if value is (found["name"] in option.opts) else None
    if found["sign"] is None:
        return found["name"]
    return f"{found['name']} {value}" if (value == found["value"]) is (found["sign"] == "=") else None


def incompatible(first: str, second: str, reason: str = "") -> click.UsageError:
    """Returns the error for two options that exclude each other, with a reason where it is not obvious."""
    return click.UsageError(f"{first} and {second} cannot be used together{reason and ': '}{reason}")


def given_options(*names: str) -> list[str]:
    """Returns those of some options, named as for `exclusive`, that were typed on the command line."""
    return [typed for typed in map(_typed, names) if typed is not None]
