"""What is to be said of a parameter in one line, in the comments of every generated file."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.tables.declaration import DIALECTS, Parameter, Type

MOST_SPECIAL = 5
"""So many special values are told; more than a handful are those of a mask, bit by bit."""


def described(parameter: Parameter) -> str:
    """`how loud (0 to 100 %; 0: silent)`."""
    facts = "; ".join(_facts(parameter))
    return parameter.text + (f" ({facts})" if facts else "")


def firmwares(dialects: tuple[str, ...]) -> str:
    """What follows the text of an entry that not every firmware has: ` (xtended and compat firmware only)`."""
    if dialects == DIALECTS:
        return ""
    return f" ({' and '.join(dialects)} firmware only)" if dialects else " (no firmware has it)"


def _facts(parameter: Parameter) -> Iterator[str]:
    unit = f" {parameter.unit}" if parameter.unit else ""
    if parameter.range is not None:
        yield f"{parameter.range[0]} to {parameter.range[1]}{unit}"
    elif unit:
        yield unit.lstrip()
    if parameter.enum is not None:
        yield parameter.enum.name
    if len(parameter.special) <= MOST_SPECIAL:
        yield from (f"{number}: {meaning}" for number, meaning in parameter.special.items())
    if isinstance(parameter.length, str):
        yield f"{parameter.length} tells how long"
    elif parameter.length is not None:
        yield f"{parameter.length} {'bytes' if parameter.type is Type.STRING else 'values'}"
    if isinstance(parameter.element, Type):
        yield f"each is {parameter.element.label}"
    elif parameter.element is not None:
        yield f"each is what {parameter.element} says"
