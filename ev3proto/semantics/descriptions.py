"""What the tables tell of a parameter, in words: for comments, docstrings, documentation and `ops`.

All of them say the same facts in the same words and order; each puts them into a form of its own.
"""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.semantics.domain import limits
from ev3proto.tables.declaration import DIALECTS, Parameter, Type

MOST_SPECIAL = 5
"""So many special values are listed in a comment; more than a handful are those of a mask, bit by bit."""


def facts(parameter: Parameter, *, most_special: int | None = None) -> Iterator[str]:
    """Legal values and length of a parameter: `0 to 100 %`, `0: silent`, `as many bytes as LENGTH says`.

    Args:
        parameter: The parameter.
        most_special: If it has more special values than this, they are omitted; None for no limit.
    """
    span = limits(parameter)
    if span:
        yield span
    if parameter.most is not None:
        yield f"at most {parameter.most - 1} characters"
    if most_special is None or len(parameter.special) <= most_special:
        yield from (f"{number}: {meaning}" for number, meaning in parameter.special.items())
    if parameter.enum is not None:
        yield f"a member of {parameter.enum.name}"
    if parameter.length is not None:
        unit = "bytes" if parameter.type is Type.STRING else "values"
        is_fixed = isinstance(parameter.length, int)
        yield f"{parameter.length} {unit}" if is_fixed else f"as many {unit} as {parameter.length} says"


def element(parameter: Parameter) -> str | None:
    """What each value of a list is: `DATA8`, or `what FORMAT says`; None where there is no list."""
    if isinstance(parameter.element, Type):
        return parameter.element.label
    return None if parameter.element is None else f"what {parameter.element} says"


def comment(parameter: Parameter) -> str:
    """`how loud (0 to 100 %; 0: silent)`."""
    pieces = list(facts(parameter, most_special=MOST_SPECIAL))
    each = element(parameter)
    if each is not None:
        pieces.append(f"each is {each}")
    return parameter.text + (f" ({'; '.join(pieces)})" if pieces else "")


def firmwares(dialects: tuple[str, ...]) -> str:
    """What follows the text of an entry that not every firmware has: ` (xtended and compat firmware only)`."""
    if dialects == DIALECTS:
        return ""
    return f" ({' and '.join(dialects)} firmware only)" if dialects else " (no firmware has it)"
