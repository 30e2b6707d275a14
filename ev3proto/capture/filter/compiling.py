"""From the text of a filter to a function of records: everything that can be found out beforehand is."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from ev3proto.capture.filter.comparisons import Test
from ev3proto.capture.filter.grammar import (
    Comparison,
    Condition,
    Every,
    FilterError,
    Membership,
    Negation,
    Presence,
    Relation,
    Some,
    Word,
    parse_filter,
)
from ev3proto.capture.filter.names import Clock, Name, Read, find_name
from ev3proto.capture.record import Record

Predicate = Callable[[Record], bool]

_RANGE = ".."
"""What stands between the ends of a range."""


class Filter:
    """Whether a record is wanted.

    A filter that asks for `time` counts it from the first record that it is asked about: compile one for each capture.
    """

    __slots__ = ("_clock", "_holds", "text")

    def __init__(self, text: str, holds: Predicate, clock: Clock) -> None:
        self.text = text
        self._holds = holds
        self._clock = clock

    def __call__(self, record: Record) -> bool:
        """True for a record that is wanted."""
        if self._clock.start_ns is None:
            self._clock.start_ns = record.time_ns
        return self._holds(record)

    def __repr__(self) -> str:
        return f"compile_filter({self.text!r})"


def compile_filter(text: str) -> Filter:
    """Makes a filter.

    Args:
        text: The filter as it is written, such as `op==SOUND.TONE && FREQUENCY>400`.

    Returns:
        What says whether a record is wanted.

    Raises:
        FilterError: The text is no filter. This ValueError says why, and in which column.
    """
    clock = Clock()
    return Filter(text, _predicate(parse_filter(text), clock), clock)


def _predicate(condition: Condition, clock: Clock) -> Predicate:
    # The parser sees to it that conditions do not stand in each other too deep for this.
    match condition:
        case Presence(name):
            return find_name(name, clock).there
        case Comparison(name, relation, value):
            return _comparison(find_name(name, clock), relation, value)
        case Membership(name, members):
            return _membership(find_name(name, clock), members)
        case Negation(part):
            wanted = _predicate(part, clock)
            return lambda record: not wanted(record)
        case Every(parts):
            return _all([_predicate(part, clock) for part in parts])
        case Some(parts):
            return _any([_predicate(part, clock) for part in parts])


def _all(parts: list[Predicate]) -> Predicate:
    if len(parts) == 2:
        first, second = parts
        return lambda record: first(record) and second(record)
    return lambda record: all(part(record) for part in parts)


def _any(parts: list[Predicate]) -> Predicate:
    if len(parts) == 2:
        first, second = parts
        return lambda record: first(record) or second(record)
    return lambda record: any(part(record) for part in parts)


def _comparison(name: Name, relation: Relation, value: Word) -> Predicate:
    read = name.read
    if relation is Relation.NE:
        return _none(read, name.kind.test(name.text, Relation.EQ, value))
    test = name.kind.test(name.text, relation, value)
    return lambda record: any(map(test, read(record)))


def _none(read: Read, test: Test) -> Predicate:
    """There are values, and none passes the test."""

    def holds(record: Record) -> bool:
        values: Iterable[Any] = tuple(read(record))
        return bool(values) and not any(map(test, values))

    return holds


def _membership(name: Name, members: tuple[Word, ...]) -> Predicate:
    read = name.read
    tests = [_member(name, member) for member in members]
    return lambda record: any(test(value) for value in read(record) for test in tests)


def _member(name: Name, member: Word) -> Test:
    low, range_, high = member.text.partition(_RANGE)
    if member.quoted or not range_:
        return name.kind.test(name.text, Relation.EQ, member)
    if not low or not high:
        raise FilterError(member.column, f"{member.text} is no range: there is no number on one side of the dots")
    start = name.kind.test(name.text, Relation.GE, Word(low, member.column))
    stop = name.kind.test(name.text, Relation.LE, Word(high, member.column + len(low) + len(_RANGE)))
    return lambda value: start(value) and stop(value)
