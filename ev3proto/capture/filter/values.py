"""Comparisons of values: numbers, texts, bytes, and names from a list."""

from __future__ import annotations

import fnmatch
import operator
import re
import struct
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from decimal import Decimal
from typing import Any, NamedTuple

from ev3proto.capture.filter.pattern import PatternError, compile_pattern
from ev3proto.capture.record import Record
from ev3proto.errors import Error, near_misses
from ev3proto.tables.declaration import Enumeration
from ev3proto.tables.encoding import STRING_CODING

TIME_UNITS = {"ns": 1, "us": 10**3, "µs": 10**3, "ms": 10**6, "s": 10**9, "min": 60 * 10**9}
"""Nanoseconds in each unit of time."""

SECONDS = ("s",)
"""The units of times."""

_MOST_LISTED = 16
"""Maximum number of names that an error lists in full."""

_DECIMAL = r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?"
_QUANTITY = re.compile(rf"({_DECIMAL})([^\W\d_]+(?:/s)?|%|°C)")


class FilterError(ValueError, Error):
    """An invalid filter."""

    def __init__(self, column: int, reason: str, length: int = 1) -> None:
        self.column = column  # column of the error, from 1
        self.reason = reason  # the error, in one sentence
        self.length = max(length, 1)  # length of the error in characters, at least 1
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
"""The relations of numbers. `!=` is missing, since it must hold for all values of a name, not for one."""


@dataclass(frozen=True, slots=True)
class Word:
    """A name or a value in the source text."""

    text: str  # without quotes, escapes resolved
    column: int  # of its first character, from 1
    opening: int = 0  # characters before the text: 1 for a quote, 2 for r and a quote, 0 without quotes
    length: int = 0  # of all its characters; 0 means the length of the text

    def error(self, reason: str, position: int | None = None) -> FilterError:
        """Returns the error that marks the word, or its text from a position on."""
        length = self.length or len(self.text)
        start = 0 if position is None else min(position + self.opening, length - 1)
        return FilterError(self.column + start, reason, length - start)

    @property
    def is_quoted(self) -> bool:
        """Whether it has quotes, and so is never a number."""
        return self.opening > 0

    @property
    def number(self) -> int | float | None:
        """Its number: 440, -1, 0x94, 7.92, 1e-3; None for anything else."""
        if self.is_quoted:
            return None
        if re.fullmatch(r"[+-]?0[xX][0-9a-fA-F]+", self.text):
            return int(self.text, 16)
        if re.fullmatch(r"[+-]?[0-9]+", self.text):
            return int(self.text)
        return float(self.text) if re.fullmatch(_DECIMAL, self.text) else None

    @property
    def quantity(self) -> tuple[float, str] | None:
        """Its number and unit: 4ms, 7.9V, 50%; None for anything else."""
        found = None if self.is_quoted else _QUANTITY.fullmatch(self.text)
        return None if found is None else (float(found[1]), found[2])

    @property
    def data(self) -> bytes | None:
        """Its bytes: 4c:45:47:4f, 4c45474f, or the characters in quotes; None for anything else."""
        if self.is_quoted:
            return self.text.encode(STRING_CODING) if max(self.text, default="") <= "\xff" else None
        is_hex = re.fullmatch(r"[0-9a-fA-F]{2}(:?[0-9a-fA-F]{2})*", self.text)
        return bytes.fromhex(self.text.replace(":", "")) if is_hex else None


class FilterValue(NamedTuple):
    """A value of a name in a frame."""

    value: int | float | str | bytes | None  # None for a variable, whose value is unknown
    enum: Enumeration | None = None  # the names of its numbers, if any
    unit: str | None = None  # its unit, if any


Test = Callable[[FilterValue], bool]
"""Tests one value."""


@dataclass(frozen=True, slots=True)
class Kind:
    """The type of a name's values, which decides what they can be compared with."""

    what: str  # description for errors: `a number`, or `operation` for a list of names
    number: bool = False  # values can be numbers
    text: bool = False  # values can be texts
    data: bool = False  # values can be bytes
    is_bare: bool = False  # texts need no quotes
    names: tuple[str, ...] = ()  # the only possible texts, in any case; empty if any text is possible
    hint: Callable[[str], str] = lambda _: ""  # returns a suggestion for an unknown name, or an empty text
    enums: tuple[Enumeration, ...] = ()  # enumerations that name the numbers
    units: tuple[str, ...] = ()  # units of the numbers
    is_exact: bool = False  # numbers do not come from a frame, whose four bytes hold 7.92 as 7.9200000762939453
    is_flag: bool = False  # values are true and false, and have no patterns

    def test(self, name: str, relation: str, word: Word) -> Test:
        """Makes the test of a value by a relation (any except !=) to a word. Raises FilterError."""
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
        """Makes the comparison of numbers, limited to those with the given unit or enumeration."""
        compare, single = ORDER[relation], number if self.is_exact else _single(number)

        def holds(held: FilterValue) -> bool:
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
        text, written = word.text, f'"{word.text}"' if word.is_quoted else word.text
        members = self.names or tuple(member for enum in self.enums for member in enum.members)
        is_plain = not word.is_quoted and word.number is None
        if relation == "==" and members and (self.names or is_plain):
            return self._unknown(name, text, members)
        if self.is_bare:
            return f"{name} cannot be compared by {relation}; use == or !="
        if word.quantity is not None and self.units:
            return f"{name} is measured in {' or '.join(self.units)}, not in {word.quantity[1]}"
        if self.text and is_plain:
            return f'texts need quotes: {name} {relation} "{text}"'
        return f"{name} is {self.what}; it cannot be compared by {relation} with {written}"

    def _unknown(self, name: str, text: str, members: Sequence[str]) -> str:
        unknown = f"unknown {self.what} {text}" if self.names else f"{name} has no value {text}"
        if "*" in text:
            return f"{unknown}; use like for patterns"
        known = f": known are {', '.join(members)}" if len(members) <= _MOST_LISTED else "; see --help-filter"
        return unknown + (self.hint(text) or near_misses(text, members) or known)


class Name(NamedTuple):
    """A name in a filter."""

    kind: Kind  # type of its values
    read: Callable[[Record], Iterable[FilterValue]]  # yields its values in a record; unknown ones are None
    text: str = ""  # description, for properties of every frame
    example: str = ""  # a filter that uses it
    looks_ahead: bool = False  # for a command, it is known only after the reply, or at the end of the capture


def _text_test(relation: str, word: Word, change: Callable[[str], str]) -> Callable[[str], bool] | None:
    """Makes the test of a text by a relation to a word. Returns None for relations that texts do not have."""
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
    """Converts a number to another unit. Returns None if the units measure different things."""
    if unit.lower() == wanted.lower():
        return number
    if unit not in TIME_UNITS or wanted not in TIME_UNITS:
        return None
    # In decimals, so that 4.1ms is the same float as 0.0041.
    return float(Decimal(repr(number)) * TIME_UNITS[unit] / TIME_UNITS[wanted])


def _single(number: float) -> float:
    """Rounds a number to the float of four bytes that a frame holds."""
    try:
        rounded: float = struct.unpack("<f", struct.pack("<f", number))[0]
    except (OverflowError, struct.error):
        return number
    return rounded
