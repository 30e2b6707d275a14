"""The legal values of a parameter and what else the tables tell of it, and the one way to say them.

The tables tell documented ranges, names of numbers, single values with a meaning of their own. Where they tell none of
these, what the type can hold is legal.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cache

from ev3proto.tables.declaration import DIALECTS, Enumeration, Parameter, Type
from ev3proto.tables.encoding import BITS, RANGES

_MOST_NAMES = 12
"""So many names of an enumeration are listed in a sentence."""


class Domain:
    """The numbers that are legal for one parameter.

    Attributes:
        spans: Pairs of lowest and highest number.
        singles: Single numbers besides those.
        mask: Bits that may be set in any combination, 0 where there are none.
        is_documented: True where the tables tell the numbers, False where the type alone limits them.
        has_names: True where the numbers have names.
        text: The numbers: `0 to 100 %`, `-127 to 127`, `0 LED_BLACK, 1 LED_GREEN, ...`.
    """

    __slots__ = ("has_names", "is_documented", "mask", "singles", "spans", "text")

    def __init__(self, parameter: Parameter) -> None:
        self.singles = frozenset(parameter.special)
        self.mask = 0
        self.has_names = False
        self.is_documented = True
        if parameter.range is not None:
            low, high = parameter.range
            self.spans: tuple[tuple[int, int], ...] = ((low, high),)
            beside = [f"{value} ({text})" for value, text in parameter.special.items() if not low <= value <= high]
            self.text = " or ".join((limits(parameter), *beside))
        elif parameter.enum is not None:
            members = parameter.enum.members
            self.spans = tuple(_spans(parameter.enum))
            self.singles |= frozenset(members.values())
            self.mask = sum(members.values()) if parameter.enum.flags else 0
            self.has_names = True
            self.text = _names(parameter.enum)
        elif parameter.unsigned:
            numbers = BITS[parameter.type]
            self.spans = ((numbers[0], numbers[-1]),)
            self.is_documented = False
            self.text = f"0 to {numbers[-1]} (or {numbers[0]} to -1, which are the same bits)"
        else:
            low, high, nan = RANGES[parameter.type]
            self.spans = ((low, high),)
            self.is_documented = False
            self.text = f'{low} to {high} ({nan} means "not a number")'

    @property
    def choice(self) -> str:
        """What is legal, after "must be" or "give": `0 to 100 %`, `one of 0 LED_BLACK, 1 LED_GREEN, ...`."""
        return f"one of {self.text}" if self.has_names else self.text

    def covers(self, value: float) -> bool:
        """Whether a number is legal."""
        if value in self.singles:
            return True
        for low, high in self.spans:
            if low <= value <= high:
                return True
        return bool(self.mask) and math.isfinite(value) and not int(value) & ~self.mask


@cache
def domain_of(parameter: Parameter) -> Domain | None:
    """The legal numbers of a parameter; None where every number that can be encoded is legal, and for texts."""
    if parameter.range is None and parameter.enum is None and parameter.type not in RANGES:
        return None
    if parameter.any_type and parameter.type is not Type.COUNT:
        return None
    return None if parameter.type is Type.STRING else Domain(parameter)


def limits(parameter: Parameter) -> str:
    """`0 to 100 %`, the unit alone where the tables tell no range, and nothing where they tell neither."""
    unit = f" {parameter.unit}" if parameter.unit else ""
    if parameter.range is None:
        return unit.strip()
    low, high = parameter.range
    return f"{low} to {high}{unit}"


def _spans(enum: Enumeration) -> Iterator[tuple[int, int]]:
    """Numbers between two members that name both ends of a span: TYPE_THIRD_PARTY_START and ..._END."""
    for name, low in enum.members.items():
        if name.endswith("_START"):
            high = enum.members.get(f"{name.removesuffix('_START')}_END")
            if high is not None:
                yield low, high


def _names(enum: Enumeration) -> str:
    numbered = [f"{number} {name}" for name, number in enum.members.items()]
    return ", ".join(numbered[:_MOST_NAMES]) + (", ..." if len(numbered) > _MOST_NAMES else "")


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
    """`volume (0 to 100 %; 0: silent)`."""
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
