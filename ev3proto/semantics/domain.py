"""The legal values of a parameter, other facts about it, and their texts.

The tables have documented ranges, names of numbers, and single values with a meaning of their own. Without any of
these, all values of the type are legal.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cache

from ev3proto.tables.declaration import DIALECTS, Enumeration, Parameter, Type
from ev3proto.tables.encoding import BITS, RANGES, limits_of

_MOST_NAMES = 12
"""Maximum number of names of an enumeration listed in a sentence."""


class Domain:
    """The legal numbers of one parameter.

    Attributes:
        spans: Pairs of lowest and highest number.
        singles: Single numbers besides those.
        mask: Bits that may be set in any combination, or 0.
        is_documented: Whether the tables limit the numbers; False if only the type does.
        has_names: Whether the numbers have names.
        text: The text: `0 to 100 %`, `-127 to 127`, `0 LED_BLACK, 1 LED_GREEN, ...`.
        choice: The same for use after "must be" or "use": `0 to 100 %`, `one of 0 LED_BLACK, 1 LED_GREEN, ...`.
        outside: What is said after another number: ` %, outside of 0 to 100 %`.
    """

    __slots__ = ("choice", "has_names", "is_documented", "mask", "outside", "singles", "spans", "text")

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
            self.text = f"0 to {numbers[-1]} (or {numbers[0]} to -1, the same bits)"
        else:
            low, high, nan = limits_of(parameter) or RANGES[parameter.type]
            self.spans = ((low, high),)
            self.is_documented = False
            self.text = f'{low} to {high} ({nan} means "not a number")'
        self.choice, unit = self.text, f" {parameter.unit}" if parameter.unit else ""
        self.outside = f"{unit}, outside of {self.text}"
        if self.has_names and parameter.enum is not None:
            self.choice, self.outside = f"one of {self.text}", f", which is not in {parameter.enum.name}"

    def covers(self, value: float) -> bool:
        """Returns whether a number is legal."""
        if value in self.singles:
            return True
        for low, high in self.spans:
            if low <= value <= high:
                return True
        return bool(self.mask) and math.isfinite(value) and not int(value) & ~self.mask


@cache
def domain_of(parameter: Parameter) -> Domain | None:
    """Returns the legal numbers of a parameter; None if every encodable number is legal, and for texts."""
    if parameter.range is None and parameter.enum is None and parameter.type not in RANGES:
        return None
    if parameter.any_type and not parameter.counts:
        return None
    return None if parameter.type is Type.STRING else Domain(parameter)


def limits(parameter: Parameter) -> str:
    """Returns `0 to 100 %`, the unit alone without a range, or an empty text."""
    unit = f" {parameter.unit}" if parameter.unit else ""
    if parameter.range is None:
        return unit.strip()
    low, high = parameter.range
    return f"{low} to {high}{unit}"


def _spans(enum: Enumeration) -> Iterator[tuple[int, int]]:
    """Yields the spans between two members that name their ends: TYPE_THIRD_PARTY_START and ..._END."""
    for name, low in enum.members.items():
        if name.endswith("_START"):
            high = enum.members.get(f"{name.removesuffix('_START')}_END")
            if high is not None:
                yield low, high


def _names(enum: Enumeration) -> str:
    numbered = [f"{number} {name}" for name, number in enum.members.items()]
    return ", ".join(numbered[:_MOST_NAMES]) + (", ..." if len(numbered) > _MOST_NAMES else "")


MOST_SPECIAL = 5
"""Maximum number of special values listed in a comment; more than a handful are the bits of a mask."""


def facts(parameter: Parameter, *, most_special: int | None = None) -> Iterator[str]:
    """Yields legal values and length of a parameter: `0 to 100 %`, `0: silent`, `as many bytes as LENGTH says`.

    More special values than `most_special` are omitted.
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
    """Returns the type of a list's values: `DATA8`, or `what FORMAT says`; None if it is not a list."""
    if isinstance(parameter.element, Type):
        return parameter.element.label
    return None if parameter.element is None else f"what {parameter.element} says"


def comment(parameter: Parameter) -> str:
    """Returns the text of a comment: `volume (0 to 100 %; 0: silent)`."""
    pieces = list(facts(parameter, most_special=MOST_SPECIAL))
    each = element(parameter)
    if each is not None:
        pieces.append(f"each is {each}")
    return parameter.text + (f" ({'; '.join(pieces)})" if pieces else "")


def firmwares(dialects: tuple[str, ...]) -> str:
    """Returns the suffix for an entry that some firmwares lack: ` (xtended and compat firmware only)`."""
    if dialects == DIALECTS:
        return ""
    return f" ({' and '.join(dialects)} firmware only)" if dialects else " (not in any firmware)"
