"""What the values of a name can be compared with: numbers, texts, bytes, or names from a list."""

from __future__ import annotations

import fnmatch
import operator
import re
import struct
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from decimal import Decimal
from typing import Any, NamedTuple

from ev3proto.capture.filter.pattern import PatternError, compile_pattern
from ev3proto.capture.record import Record
from ev3proto.errors import near_misses
from ev3proto.tables.declaration import Enumeration
from ev3proto.tables.encoding import STRING_CODING

TIME_UNITS = {"ns": 1, "us": 10**3, "µs": 10**3, "ms": 10**6, "s": 10**9, "min": 60 * 10**9}
"""Nanoseconds in each unit that a time can have."""

_MOST_LISTED = 16
"""An error lists this many names in full."""

_DECIMAL = r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?"
_QUANTITY = re.compile(rf"({_DECIMAL})([^\W\d_]+(?:/s)?|%|°C)")


class FilterError(ValueError):
    """A text that is not a filter.

    column  where the error begins, from 1
    reason  what is wrong, in one sentence
    length  of the error in characters, at least 1
    """

    def __init__(self, column: int, reason: str, length: int = 1) -> None:
        self.column = column
        self.reason = reason
        self.length = max(length, 1)
        super().__init__(f"column {column}: {reason}")

    def __reduce__(self) -> tuple[type[FilterError], tuple[int, str, int]]:
        return (type(self), (self.column, self.reason, self.length))


ORDER: dict[str, Callable[[Any, Any], bool]] = {
    "==": operator.eq,
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
}
"""The relations of numbers. != is about all values of a name, not about one, and is not made here."""


@dataclass(frozen=True, slots=True)
class Word:
    """A name or a value as it was written.

    text     without quotes, escapes resolved
    column   of its first character, from 1
    opening  characters before the text: 1 for a quote, 2 for r and a quote, 0 where it has no quotes
    length   characters in all; 0 for the length of the text
    """

    text: str
    column: int
    opening: int = 0
    length: int = 0

    def error(self, reason: str, position: int | None = None) -> FilterError:
        """Returns the error that underlines the word, or its text from a position on."""
        length = self.length or len(self.text)
        start = 0 if position is None else min(position + self.opening, length - 1)
        return FilterError(self.column + start, reason, length - start)

    @property
    def is_quoted(self) -> bool:
        """True for a text in quotes, which is never a number."""
        return self.opening > 0

    @property
    def number(self) -> int | float | None:
        """440, -1, 0x94, 7.92, 1e-3; None for anything else."""
        if self.is_quoted:
            return None
        if re.fullmatch(r"[+-]?0[xX][0-9a-fA-F]+", self.text):
            return int(self.text, 16)
        if re.fullmatch(r"[+-]?[0-9]+", self.text):
            return int(self.text)
        return float(self.text) if re.fullmatch(_DECIMAL, self.text) else None

    @property
    def quantity(self) -> tuple[float, str] | None:
        """4ms, 7.9V, 50%: a number and its unit; None for anything else."""
        found = None if self.is_quoted else _QUANTITY.fullmatch(self.text)
        return None if found is None else (float(found[1]), found[2])

    @property
    def data(self) -> bytes | None:
        """4c:45:47:4f or 4c45474f, or the characters in quotes; None for anything else."""
        if self.is_quoted:
            return self.text.encode(STRING_CODING) if max(self.text, default="") <= "\xff" else None
        is_hex = re.fullmatch(r"[0-9a-fA-F]{2}(:?[0-9a-fA-F]{2})*", self.text)
        return bytes.fromhex(self.text.replace(":", "")) if is_hex else None


class Held(NamedTuple):
    """A value that a frame has for a name.

    value  None for an argument that is a variable, whose value is not known
    enum   the names of its numbers, None where they have none
    unit   what it is measured in, None where it has no unit
    """

    value: int | float | str | bytes | None
    enum: Enumeration | None = None
    unit: str | None = None


Test = Callable[[Held], bool]
"""Whether one value compares true."""


@dataclass(frozen=True, slots=True)
class Kind:
    """What the values of a name can be compared with.

    what      what it is, for errors: `a number`, or `operation` where it is one of a list of names
    number    it can be a number
    text      it can be a text
    data      it can be bytes
    is_bare   its texts need no quotes
    names     the only texts that it can be, in any case of their letters; empty where it can be any
    hint      for a word that is none of these names: what to say to it, or nothing
    enums     the names that its numbers can have
    units     what it is measured in
    is_exact  its numbers are not those of a frame, where four bytes hold 7.92 as 7.9200000762939453
    is_flag   it is true or false, and has no patterns
    """

    what: str
    number: bool = False
    text: bool = False
    data: bool = False
    is_bare: bool = False
    names: tuple[str, ...] = ()
    hint: Callable[[str], str] = lambda _: ""
    enums: tuple[Enumeration, ...] = ()
    units: tuple[str, ...] = ()
    is_exact: bool = False
    is_flag: bool = False

    def test(self, name: str, relation: str, word: Word) -> Test:
        """Makes the test whether a value is in a relation (any but !=) to a word.

        Raises:
            FilterError: They cannot be compared.
        """
        tests = [*self._numbers(relation, word), *self._texts(relation, word), *self._bytes(relation, word)]
        if not tests or (self.is_flag and relation != "=="):
            raise word.error(self._error(name, relation, word))
        return tests[0] if len(tests) == 1 else lambda held: any(test(held) for test in tests)

    def _numbers(self, relation: str, word: Word) -> Iterator[Test]:
        if not self.number or relation not in ORDER or (self.names and relation != "=="):
            return
        number, quantity = word.number, word.quantity
        if number is not None:
            yield self._compared(relation, number)
        elif quantity is not None:
            for unit in self.units:
                number = _converted(*quantity, unit)
                if number is not None:
                    yield self._compared(relation, number, unit=unit)
        for enum in self.enums:
            number = enum.members.get(word.text.upper())
            if number is not None:
                yield self._compared(relation, number, enum=enum)

    def _compared(self, relation: str, number: float, unit: str | None = None, enum: Enumeration | None = None) -> Test:
        """Compares numbers; given a unit or an enumeration, only those that have it."""
        compare, single = ORDER[relation], number if self.is_exact else _single(number)

        def holds(held: Held) -> bool:
            value = held.value
            if not isinstance(value, int | float) or (unit is not None and held.unit != unit):
                return False
            if enum is not None and (held.enum is None or held.enum.name != enum.name):
                return False
            return compare(value, single if isinstance(value, float) else number)

        return holds

    def _texts(self, relation: str, word: Word) -> Iterator[Test]:
        if not self.text or not (word.is_quoted or self.is_bare):
            return
        if self.names and relation == "==" and word.text.upper() not in map(str.upper, self.names):
            return
        find = _text_test(relation, word, change := str.upper if self.names else str)
        if find is not None:
            yield lambda held: isinstance(held.value, str) and find(change(held.value))

    def _bytes(self, relation: str, word: Word) -> Iterator[Test]:
        data = word.data
        if not self.data:
            return
        if relation == "matches" and word.is_quoted:
            find = _pattern(word)
            yield lambda held: isinstance(held.value, bytes) and find(held.value.decode(STRING_CODING))
        elif relation == "==" and data is not None:
            yield lambda held: held.value == data
        elif relation == "contains" and data is not None:
            yield lambda held: isinstance(held.value, bytes) and data in held.value

    def _error(self, name: str, relation: str, word: Word) -> str:
        """Says why the name and the word cannot be compared."""
        text, written = word.text, f'"{word.text}"' if word.is_quoted else word.text
        members = self.names or tuple(member for enum in self.enums for member in enum.members)
        if relation == "==" and members and (self.names or not (word.is_quoted or word.number is not None)):
            unknown = f"unknown {self.what} {text}" if self.names else f"{name} has no value {text}"
            if "*" in text:
                return f"{unknown}; use like for patterns"
            known = f": known are {', '.join(members)}" if len(members) <= _MOST_LISTED else "; see --help-filter"
            return unknown + (self.hint(text) or near_misses(text, members) or known)
        if self.is_bare:
            return f"{name} cannot be compared by {relation}; use == or !="
        if word.quantity is not None and self.units:
            return f"{name} is measured in {' or '.join(self.units)}, not in {word.quantity[1]}"
        if self.text and not word.is_quoted and word.number is None:
            return f'texts need quotes: {name} {relation} "{text}"'
        return f"{name} is {self.what}; it cannot be compared by {relation} with {written}"


class Name(NamedTuple):
    """What a name means in a filter.

    kind         what its values can be compared with
    read         the values that a record has; unknown ones are None
    text         what it is, for people, where it can be asked about every frame
    example      a filter that uses it
    looks_ahead  of a command, it is only known when its reply was seen, or can no longer come
    """

    kind: Kind
    read: Callable[[Record], Iterable[Held]]
    text: str = ""
    example: str = ""
    looks_ahead: bool = False


def _text_test(relation: str, word: Word, change: Callable[[str], str]) -> Callable[[str], bool] | None:
    """Makes the test whether a text is a word, contains it or fits it as a pattern; None for other relations."""
    text = change(word.text)
    if relation == "==":
        return text.__eq__
    if relation == "contains":
        return lambda held: text in held
    if relation == "like":
        # Linear in the length of the text, times the stars.
        fits = re.compile(fnmatch.translate(word.text), re.IGNORECASE).match
        return lambda held: fits(held) is not None
    return _pattern(word) if relation == "matches" else None


def _pattern(word: Word) -> Callable[[str], bool]:
    try:
        return compile_pattern(word.text)
    except PatternError as error:
        raise word.error(str(error), error.position) from None


def _converted(number: float, unit: str, wanted: str) -> float | None:
    """A number of a unit in another unit; None where they measure different things."""
    if unit.lower() == wanted.lower():
        return number
    if unit not in TIME_UNITS or wanted not in TIME_UNITS:
        return None
    # In decimals, so that 4.1ms is the same float as 0.0041.
    return float(Decimal(repr(number)) * TIME_UNITS[unit] / TIME_UNITS[wanted])


def _single(number: float) -> float:
    """The number as a frame's four bytes hold it."""
    try:
        rounded: float = struct.unpack("<f", struct.pack("<f", number))[0]
    except (OverflowError, struct.error):
        return number
    return rounded
