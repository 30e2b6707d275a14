"""What the values of a name can be compared with: numbers, texts, names from a list, or nothing at all."""

from __future__ import annotations

import fnmatch
import operator
import re
import struct
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from decimal import Decimal
from typing import Any, NamedTuple, Protocol

from ev3proto.capture.filter.grammar import TIME_UNITS, FilterError, Relation, Word
from ev3proto.capture.filter.pattern import PatternError, compile_pattern
from ev3proto.errors import near_misses
from ev3proto.tables.declaration import Enumeration
from ev3proto.tables.encoding import STRING_CODING

Test = Callable[[Any], bool]
"""Whether one value compares true."""

Number = int | float

_ORDER: dict[Relation, Callable[[Any, Any], bool]] = {
    Relation.EQ: operator.eq,
    Relation.LT: operator.lt,
    Relation.LE: operator.le,
    Relation.GT: operator.gt,
    Relation.GE: operator.ge,
}
"""The relations of numbers. != is none of them: it is about all values of a name, not about one."""

_SINGLE = struct.Struct("<f")


class ValueType(Protocol):
    """What kind of values a name has."""

    def test(self, name: str, relation: Relation, value: Word) -> Test:
        """Makes the test whether a value stands in a relation (any but NE) to the one that was written.

        Raises:
            FilterError: The values of the name cannot stand in that relation to it.
        """


# The values as they are written


def number_in(word: Word) -> Number | None:
    """440, -1, 0x94, 7.92, 1e-3; None for what is no number or stands in quotes."""
    if word.quoted:
        return None
    if re.fullmatch(r"[+-]?0[xX][0-9a-fA-F]+", word.text):
        return int(word.text, 16)
    if re.fullmatch(r"[+-]?[0-9]+", word.text):
        return int(word.text)
    if re.fullmatch(_DECIMAL, word.text):
        return float(word.text)
    return None


_DECIMAL = r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?"
_QUANTITY = re.compile(rf"({_DECIMAL})([^\W\d_]+(?:/s)?|%|°C)")


def quantity_in(word: Word) -> tuple[float, str] | None:
    """4ms, 7.9V, 50%: a number and its unit; None for anything else."""
    found = None if word.quoted else _QUANTITY.fullmatch(word.text)
    return None if found is None else (float(found[1]), found[2])


def converted(number: float, unit: str, wanted: str) -> float | None:
    """A number of a unit in another unit; None where they measure different things."""
    if unit.lower() == wanted.lower():
        return number
    if unit not in TIME_UNITS or wanted not in TIME_UNITS:
        return None
    # In decimals, so that 4.1ms is the same float as 0.0041.
    return float(Decimal(repr(number)) * TIME_UNITS[unit] / TIME_UNITS[wanted])


def bytes_in(word: Word) -> bytes | None:
    """4c:45:47:4f or 4c45474f, or the characters in quotes; None for what is neither."""
    if word.quoted:
        try:
            return word.text.encode(STRING_CODING)
        except UnicodeEncodeError:
            return None
    if re.fullmatch(r"[0-9a-fA-F]{2}(:?[0-9a-fA-F]{2})*", word.text):
        return bytes.fromhex(word.text.replace(":", ""))
    return None


def _refused(name: str, relation: Relation, value: Word, what: str) -> FilterError:
    return value.trouble(f"{name} cannot be compared by {relation.value} with {_written(value)}: {name} is {what}")


def _written(value: Word) -> str:
    return f'"{value.text}"' if value.quoted else value.text


def text_test(relation: Relation, value: Word) -> Test | None:
    """Whether a text is another, has it in it, or fits it as a pattern; None for relations that texts do not have.

    Raises:
        FilterError: The value is to be a regular expression, and is none.
    """
    text = value.text
    if relation is Relation.EQ:
        return text.__eq__
    if relation is Relation.MATCHES:
        try:
            return compile_pattern(text)
        except PatternError as error:
            raise value.trouble(str(error), error.position) from None
    if relation is Relation.CONTAINS:
        return lambda value: text in value
    if relation is Relation.LIKE:
        # A pattern of fnmatch takes no more time than the text is long, times the stars; other patterns can take ages.
        fits = re.compile(fnmatch.translate(text), re.IGNORECASE).match
        return lambda value: fits(value) is not None
    return None


# The kinds


class Flags:
    """True or false."""

    def test(self, name: str, relation: Relation, value: Word) -> Test:
        """`error == true`, for those who are used to it."""
        meant = {"true": True, "1": True, "false": False, "0": False}.get(value.text.lower())
        if meant is None or relation is not Relation.EQ:
            raise value.trouble(f"{name} is true or false: write {name} or not {name}")
        return lambda held: held is meant


class Numbers:
    """Whole numbers."""

    def test(self, name: str, relation: Relation, value: Word) -> Test:
        """`size > 100`."""
        compare = _ORDER.get(relation)
        if compare is None:
            raise _refused(name, relation, value, "a number")
        number = number_in(value)
        if number is None:
            raise value.trouble(f"{name} is a number, {_written(value)} is none")
        return lambda held: compare(held, number)


class Durations:
    """Times in seconds."""

    def test(self, name: str, relation: Relation, value: Word) -> Test:
        """`latency > 4ms`, `time < 1.5s`, `time < 90`."""
        compare = _ORDER.get(relation)
        if compare is None:
            raise _refused(name, relation, value, "a time")
        number = number_in(value)
        quantity = quantity_in(value)
        if quantity is not None:
            number = converted(*quantity, "s")
        if number is None:
            units = ", ".join(unit for unit in TIME_UNITS if unit.isascii())
            raise value.trouble(
                f"{name} is a time in seconds, {_written(value)} is none: write 4ms or 0.004; the units are {units}"
            )
        return lambda held: compare(held, number)


class Texts:
    """Texts; with `bare` they need no quotes."""

    def __init__(self, *, bare: bool = False) -> None:
        self._bare = bare

    def test(self, name: str, relation: Relation, value: Word) -> Test:
        """`peer == 192.0.2.10`."""
        if not value.quoted and not self._bare:
            raise value.trouble(f'{name} is a text, and texts stand in quotes: "{value.text}"')
        test = text_test(relation, value)
        if test is None:
            raise _refused(name, relation, value, "a text, which has no order: use ==, !=, contains, like or matches")
        return test


class Choice:
    """One of a list of names, in any case.

    what     what they are the names of, with its article
    known    what each name stands for: the values that it matches
    numbers  the values that a number matches; None where they have no numbers
    hint     for a word that is none of the names: what to say to it, or nothing
    """

    def __init__(
        self,
        what: str,
        known: Mapping[str, Iterable[Any]],
        numbers: Callable[[int], Iterable[Any]] | None = None,
        hint: Callable[[str], str] = lambda _: "",
    ) -> None:
        self._what = what
        self._known = known
        self._by_upper = {name.upper(): name for name in known}
        self._numbers = numbers
        self._hint = hint

    def test(self, name: str, relation: Relation, value: Word) -> Test:
        """`op == SOUND.TONE`, `status == END_OF_FILE`."""
        if relation is Relation.EQ:
            return frozenset(self._meant(value)).__contains__
        test = _caseless(relation, value)
        if test is None:
            raise _refused(name, relation, value, f"{self._what}, which has no order: use == or !=")
        fitting = (values for known, values in self._known.items() if test(known))
        return frozenset(held for values in fitting for held in values).__contains__

    def _meant(self, value: Word) -> Iterable[Any]:
        number = None if self._numbers is None else number_in(value)
        if self._numbers is not None and isinstance(number, int):
            return self._numbers(number)
        found = self._by_upper.get(value.text.upper())
        if found is not None:
            return self._known[found]
        hint = self._hint(value.text) or near_misses(value.text, self._known)
        if "*" in value.text:
            hint = "; like takes patterns"
        if not hint and len(self._known) <= MOST_LISTED:
            hint = f": there are {', '.join(self._known)}"
        raise value.trouble(f"{value.text} is no {self._what.partition(' ')[2]}{hint}")


def _caseless(relation: Relation, value: Word) -> Test | None:
    """A test of texts in which the case of letters does not count; None for relations that texts do not have."""
    if relation is Relation.CONTAINS:
        wanted = value.text.upper()
        return lambda known: wanted in known.upper()
    return text_test(relation, value)


MOST_LISTED = 16
"""So many names an error lists in full."""


class Held(NamedTuple):
    """A value of a parameter or field in a frame, with what the tables say of the parameter.

    value  None for an argument that is a variable, whose value is not known
    enum   the names of its numbers, None where they have none
    unit   what it is measured in, None where the tables do not say
    """

    value: int | float | str | bytes | None
    enum: Enumeration | None = None
    unit: str | None = None


@dataclass(frozen=True, slots=True)
class Arguments:
    """What a parameter's arguments, a reply's values and a message's fields hold.

    enums   the enumerations that the parameter has in one operation or the other
    number  it can be a number
    text    it can be a text
    data    it can be bytes
    units   what it is measured in, in one operation or the other
    """

    enums: tuple[Enumeration, ...]
    number: bool
    text: bool
    data: bool
    units: tuple[str, ...] = ()

    def test(self, name: str, relation: Relation, value: Word) -> Test:
        """`FREQUENCY > 400`, `PATTERN == LED_RED`, `path contains "prjs"`, `data contains 4c:45:47:4f`."""
        tests = [
            *self._of_numbers(relation, value),
            *self._of_texts(relation, value),
            *self._of_bytes(relation, value),
        ]
        if not tests:
            raise self._trouble(name, relation, value)
        if len(tests) == 1:
            return tests[0]
        return lambda held: any(test(held) for test in tests)

    def _of_numbers(self, relation: Relation, value: Word) -> Iterable[Test]:
        compare = _ORDER.get(relation)
        if compare is None or not self.number:
            return
        number = number_in(value)
        if number is not None:
            single = _single(number)
            yield (
                lambda held: (
                    isinstance(held.value, int | float)
                    and compare(held.value, single if isinstance(held.value, float) else number)
                )
            )
            return
        quantity = quantity_in(value)
        if quantity is not None:
            numbers = {unit: converted(*quantity, unit) for unit in self.units}
            if any(number is not None for number in numbers.values()):
                yield _quantity_test(compare, {unit: it for unit, it in numbers.items() if it is not None})
                return
        members = {enum.name: _member(enum, value.text) for enum in self.enums}
        symbols = {enum: number for enum, number in members.items() if number is not None}
        if symbols:
            yield (
                lambda held: (
                    held.enum is not None
                    and held.enum.name in symbols
                    and isinstance(held.value, int)
                    and compare(held.value, symbols[held.enum.name])
                )
            )

    def _of_texts(self, relation: Relation, value: Word) -> Iterable[Test]:
        if not (self.text and value.quoted):
            return
        test = text_test(relation, value)
        if test is not None:
            yield lambda held: isinstance(held.value, str) and test(held.value)

    def _of_bytes(self, relation: Relation, value: Word) -> Iterable[Test]:
        if not self.data:
            return
        if relation is Relation.MATCHES and value.quoted:
            found = text_test(relation, value)
            assert found is not None
            yield lambda held: isinstance(held.value, bytes) and found(held.value.decode(STRING_CODING))
            return
        data = bytes_in(value)
        if data is None:
            return
        if relation is Relation.EQ:
            yield lambda held: held.value == data
        elif relation is Relation.CONTAINS:
            yield lambda held: isinstance(held.value, bytes) and data in held.value

    def _trouble(self, name: str, relation: Relation, value: Word) -> FilterError:
        """Why the value cannot be compared with the parameter."""
        named = [enum for enum in self.enums if enum.members]
        quantity = quantity_in(value)
        if relation not in _ORDER and not (self.text or self.data):
            return _refused(name, relation, value, "a number")
        if quantity is not None and self.units:
            units = " or ".join(self.units)
            return value.trouble(
                f"{name} is measured in {units}, which {value.text} is not: write {name} > 5{self.units[0]}"
            )
        if value.quoted or number_in(value) is not None or (relation in _ORDER and relation is not Relation.EQ):
            return _refused(name, relation, value, self._what)
        if named:
            members = [member for enum in named for member in enum.members]
            hint = near_misses(value.text, members) or f": there are {', '.join(members[:4])}, ..."
            return value.trouble(f"{value.text} is no name that {name} has{hint}")
        if self.text:
            return value.trouble(f'texts stand in quotes: {name} {relation.value} "{value.text}"')
        if self.data:
            return value.trouble(f"{name} has bytes, which are written so: 4c:45:47:4f")
        return value.trouble(f"{name} is a number, {value.text} is none")

    @property
    def _what(self) -> str:
        """`a number or a text in quotes`."""
        return " or ".join(
            text
            for there, text in (
                (self.number, "a number"),
                (self.text, "a text in quotes"),
                (self.data, "bytes such as 4c:45:47:4f"),
            )
            if there
        )


def _quantity_test(compare: Callable[[Any, Any], bool], numbers: Mapping[str, float]) -> Test:
    """Compares what is measured in one of these units with the number in it."""
    singles = {unit: _single(number) for unit, number in numbers.items()}

    def holds(held: Held) -> bool:
        if held.unit is None or held.unit not in numbers or not isinstance(held.value, int | float):
            return False
        return compare(held.value, (singles if isinstance(held.value, float) else numbers)[held.unit])

    return holds


def _member(enum: Enumeration, word: str) -> int | None:
    return next((number for name, number in enum.members.items() if name == word.upper()), None)


def _single(number: Number) -> Number:
    """The number as a frame's four bytes hold it: 7.92 is not the same in them."""
    try:
        rounded: float = _SINGLE.unpack(_SINGLE.pack(number))[0]
    except (OverflowError, struct.error):
        return number
    return rounded
