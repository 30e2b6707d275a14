"""From the text of a filter to a function of records: everything that can be found out beforehand is."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from itertools import chain
from typing import Any

from ev3proto.capture.dialogues import RequestReply
from ev3proto.capture.filter.comparisons import Test
from ev3proto.capture.filter.grammar import (
    Comparison,
    Condition,
    Every,
    Membership,
    Negation,
    Presence,
    Relation,
    Some,
    Word,
    parse_filter,
)
from ev3proto.capture.filter.names import Clock, Name, Read, find_name, looks_ahead
from ev3proto.capture.record import Record

Predicate = Callable[[Any], bool]
"""Whether a condition holds: of a record, or of the records of a dialogue."""

Find = Callable[[Word], Name]
"""What a name means, of whatever a predicate is about."""

_RANGE = ".."
"""What stands between the ends of a range."""


class Filter:
    """Whether a record is wanted, or a command together with its reply.

    A filter that asks for `time` counts it from what `begin` was given, or else from the first record that it is asked
    about: compile one for each capture, or let each begin.

    text         as it was written
    looks_ahead  it asks for what a command's record does not know before its reply was seen (`unanswered`, `failed`,
                 `late`): ask it about records of a capture that was read to its end, or let `choose` wait for replies
    """

    __slots__ = ("_clock", "_condition", "_holds", "_holds_together", "looks_ahead", "text")

    def __init__(self, text: str) -> None:
        """Reads a filter. Raises FilterError for what is not one."""
        self.text = text
        self.looks_ahead = False
        self._clock = Clock()
        self._condition = parse_filter(text)
        self._holds = _predicate(self._condition, self._find)
        self._holds_together: Predicate | None = None

    def _find(self, word: Word) -> Name:
        self.looks_ahead |= looks_ahead(word)
        return find_name(word, self._clock)

    def __call__(self, record: Record) -> bool:
        """True for a record that is wanted."""
        if self._clock.start_ns is None:
            self.begin(record.time_ns)
        return self._holds(record)

    def begin(self, time_ns: int) -> None:
        """Begins a capture: `time` counts from here on, in nanoseconds since 1970-01-01 UTC."""
        self._clock.start_ns = time_ns

    def of_dialogue(self, pair: RequestReply) -> bool:
        """True for a command with its reply that is wanted: what is asked for may be in the one or in the other.

        So `FREQUENCY > 400 && latency > 4ms` can hold, of which the command has the first and the reply the second.
        """
        records = [record for record in pair if record is not None]
        if self._clock.start_ns is None:
            self.begin(records[0].time_ns)
        if self._holds_together is None:
            self._holds_together = _predicate(self._condition, lambda word: _together(self._find(word)))
        return self._holds_together(records)

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
    return Filter(text)


def _together(name: Name) -> Name:
    """A name of a record as one of several records."""
    read, there = name.read, name.there
    return replace(
        name,
        read=lambda records: chain.from_iterable(map(read, records)),
        there=lambda records: any(map(there, records)),
    )


def _predicate(condition: Condition, find: Find) -> Predicate:
    # The parser sees to it that conditions do not stand in each other too deep for this.
    match condition:
        case Presence(name):
            return find(name).there
        case Comparison(name, relation, value):
            return _comparison(find(name), relation, value)
        case Membership(name, members):
            return _membership(find(name), members)
        case Negation(part):
            wanted = _predicate(part, find)
            return lambda subject: not wanted(subject)
        case Every(parts):
            return _all([_predicate(part, find) for part in parts])
        case Some(parts):
            return _any([_predicate(part, find) for part in parts])


def _all(parts: list[Predicate]) -> Predicate:
    if len(parts) == 2:
        first, second = parts
        return lambda subject: first(subject) and second(subject)
    return lambda subject: all(part(subject) for part in parts)


def _any(parts: list[Predicate]) -> Predicate:
    if len(parts) == 2:
        first, second = parts
        return lambda subject: first(subject) or second(subject)
    return lambda subject: any(part(subject) for part in parts)


def _comparison(name: Name, relation: Relation, value: Word) -> Predicate:
    read = name.read
    if relation is Relation.NE:
        return _none(read, name.kind.test(name.text, Relation.EQ, value))
    test = name.kind.test(name.text, relation, value)
    return lambda subject: any(map(test, read(subject)))


def _none(read: Read, test: Test) -> Predicate:
    """There are values, and none passes the test."""

    def holds(subject: Any) -> bool:
        values: Iterable[Any] = tuple(read(subject))
        return bool(values) and not any(map(test, values))

    return holds


def _membership(name: Name, members: tuple[Word, ...]) -> Predicate:
    read = name.read
    tests = [_member(name, member) for member in members]
    return lambda subject: any(test(value) for value in read(subject) for test in tests)


def _member(name: Name, member: Word) -> Test:
    low, range_, high = member.text.partition(_RANGE)
    if member.quoted or not range_:
        return name.kind.test(name.text, Relation.EQ, member)
    if not low or not high:
        raise member.trouble(f"{member.text} is no range: there is no number on one side of the dots")
    start = name.kind.test(name.text, Relation.GE, Word(low, member.column))
    stop = name.kind.test(name.text, Relation.LE, Word(high, member.column + len(low) + len(_RANGE)))
    return lambda value: start(value) and stop(value)
