"""The filter language: compiles an expression to a test of records.

    filter      conditions joined by && and ||; && binds tighter
    condition   !condition, (filter), NAME, NAME RELATION value, NAME in {value or range, ...}, NAME not in {...}

Keywords are not reserved: each is recognised only where the grammar allows it, so `in` can also be a value.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from typing import NoReturn

from ev3proto.capture.dialogues import RequestReply
from ev3proto.capture.filter.names import find_name
from ev3proto.capture.filter.values import SECONDS, TIME_UNITS, FilterError, FilterValue, Name, Test, Word
from ev3proto.capture.record import NANOSECONDS, Record

MAX_LENGTH = 4096
"""Maximum length of a filter, in characters."""

MAX_DEPTH = 50
"""Maximum nesting depth of conditions; each `!` and each pair of parentheses is a level."""

_WORDS = {"eq": "==", "ne": "!=", "lt": "<", "le": "<=", "gt": ">", "ge": ">="}

_AND = re.compile(r"&&|and\b", re.IGNORECASE)
_OR = re.compile(r"\|\||or\b", re.IGNORECASE)
_NOT = re.compile(r"!(?!=)|not\b", re.IGNORECASE)
_IN = re.compile(r"in\b", re.IGNORECASE)
_NOT_IN = re.compile(r"not\s+in\b", re.IGNORECASE)
_RELATION = re.compile(rf"[=!<>]=|[<>]|(?:{'|'.join(_WORDS)}|contains|like|matches)\b", re.IGNORECASE)
# SOUND.TONE.FREQUENCY, VALUES[0]
_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*(?:\.[A-Za-z0-9_]+)*(?:\[[0-9]+\])?")
# A text in quotes; a prefix r turns escapes off, as in Wireshark. Other values need no quotes: 440, 4ms, -1.5, 1..5,
# SOUND.TONE, 192.0.2.1:5555.
_VALUE = re.compile(
    r"""(?P<raw>r"[^"]*"|r'[^']*') | (?P<text>"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*') | [^\s"'(){},!=<>&|]+""",
    re.VERBOSE | re.DOTALL,
)
_OPEN, _CLOSE, _BRACE, _COMMA, _END_BRACE = map(re.compile, (r"\(", r"\)", r"\{", ",", r"\}"))
_SPACE = re.compile(r"\s*")
_END = re.compile(r"\Z")
_PIECE = re.compile(r"[\w.:-]+|[=!<>&|~]+|.", re.DOTALL)
"""The part of the text that an error underlines."""

_OF_OTHER_LANGUAGES = {
    "=": "a comparison; did you mean ==?",
    "is": "a comparison; did you mean ==?",
    "~": "a comparison; did you mean matches?",
    "=~": "a comparison; did you mean matches?",
    "&": "a comparison; did you mean &&?",
    "|": "a comparison; did you mean ||?",
    "xor": "and, or, not",
    **dict.fromkeys(TIME_UNITS, "no space between a number and its unit: 4ms"),
}
"""Suggestions for words and signs of other languages."""

_ESCAPE = re.compile(r"\\(x[0-9a-fA-F]{2}|.)", re.DOTALL)
_ESCAPES = {'"': '"', "'": "'", "\\": "\\", "n": "\n", "r": "\r", "t": "\t", "0": "\0"}

Condition = Callable[[Sequence[Record]], bool]
"""Tests a record, or a command together with its reply."""


class Filter:
    """A compiled filter: tests a record, or a command together with its reply.

    `time` is counted from the time given to `begin`, or else from the first record tested: compile one filter for each
    capture, or call `begin` for each.
    """

    def __init__(self, text: str) -> None:
        """Compiles a filter. Raises FilterError if its syntax or a name is wrong."""
        self.text = text  # source text
        self._start_ns: int | None = None
        parser = _Parser(text, self._time)
        self._holds = parser.filter()
        # it uses names that are known only after a command's reply (`unanswered`, `failed`, `late`): test records of a
        # capture that was read to its end, or use `Choosing`
        self.looks_ahead = parser.looks_ahead
        # why nothing may match, as the end of a sentence; often empty
        self.hint = parser.hint

    def __call__(self, record: Record) -> bool:
        """Tells whether a record matches."""
        return self._hold((record,))

    def begin(self, time_ns: int) -> None:
        """Begins a capture: sets the zero of `time`, in nanoseconds since 1970-01-01 UTC."""
        self._start_ns = time_ns

    def of_dialogue(self, pair: RequestReply) -> bool:
        """Tells whether a command together with its reply matches. Each condition may hold for either of them.

        `FREQUENCY > 400 && latency > 4ms` can match: the frequency is in the command, the latency in the reply.
        """
        return self._hold([record for record in pair if record is not None])

    def _hold(self, records: Sequence[Record]) -> bool:
        if self._start_ns is None:
            self.begin(records[0].time_ns)
        return self._holds(records)

    def _time(self, record: Record) -> float:
        return (record.time_ns - (self._start_ns or 0)) / NANOSECONDS

    def __repr__(self) -> str:
        return f"compile_filter({self.text!r})"


def compile_filter(text: str) -> Filter:
    """Compiles a filter.

    Args:
        text: An expression such as `op==SOUND.TONE && FREQUENCY>400`.

    Returns:
        A function that tells whether a record matches.

    Raises:
        FilterError: The syntax or a name is wrong. This ValueError has the reason and the column.
    """
    return Filter(text)


class _Parser:
    def __init__(self, text: str, time: Callable[[Record], float]) -> None:
        self.looks_ahead = False  # a name was used that is known only after the reply
        self.hint = ""
        self._text = text
        self._time = time
        self._at = 0
        self._depth = 0
        self._name_end = -1

    def filter(self) -> Condition:
        if len(self._text) > MAX_LENGTH:
            raise FilterError(
                MAX_LENGTH + 1, f"the filter has {len(self._text)} characters; at most {MAX_LENGTH} are allowed"
            )
        if not self._text.strip():
            raise FilterError(1, "empty filter; write a condition such as op==SOUND.TONE")
        found = self._disjunction()
        if not self._take(_END):
            self._fail_after_condition("the end")
        return found

    def _take(self, pattern: re.Pattern[str]) -> re.Match[str] | None:
        """Skips spaces, then consumes a match of the pattern. Returns None without one."""
        spaces = _SPACE.match(self._text, self._at)
        found = pattern.match(self._text, spaces.end() if spaces else self._at)
        if found:
            self._at = found.end()
        return found

    def _disjunction(self) -> Condition:
        return self._joined(_OR, lambda: self._joined(_AND, self._condition, all), any)

    def _joined(
        self, sign: re.Pattern[str], part: Callable[[], Condition], join: Callable[[Iterable[bool]], bool]
    ) -> Condition:
        parts = [part()]
        while self._take(sign):
            parts.append(part())
        return parts[0] if len(parts) == 1 else lambda records: join(holds(records) for holds in parts)

    def _condition(self) -> Condition:
        self._depth += 1
        if self._depth > MAX_DEPTH:
            raise FilterError(self._at + 1, f"conditions are nested more than {MAX_DEPTH} deep")
        if self._take(_NOT):
            found = _negated(self._condition())
        elif self._take(_OPEN):
            found = self._disjunction()
            if not self._take(_CLOSE):
                self._fail_after_condition(")")
        else:
            found = self._comparison()
        self._depth -= 1
        return found

    def _comparison(self) -> Condition:
        written = self._take(_NAME) or self._fail("a name")
        word = Word(written[0], written.start() + 1)
        name = find_name(word, self._time)
        self.looks_ahead |= name.looks_ahead
        relation = self._take(_RELATION)
        if relation:
            sign, value = _WORDS.get(relation[0].lower(), relation[0].lower()), self._value()
            if sign != "!=":
                return _some(name, self._test(word.text, name, sign, value))
            equal = self._test(word.text, name, "==", value)
            return lambda records: bool(values := _values(name, records)) and not any(map(equal, values))
        if self._take(_IN):
            return self._membership(word.text, name)
        if self._take(_NOT_IN):
            return _negated(self._membership(word.text, name))
        self._name_end = self._at
        if name.kind.is_flag:
            return _some(name, name.kind.test(word.text, "==", Word("true", word.column)))
        return lambda records: any(True for record in records for _ in name.read(record))

    def _membership(self, text: str, name: Name) -> Condition:
        if not self._take(_BRACE):
            self._fail("{")
        tests = [self._member(text, name)]
        while self._take(_COMMA):
            tests.append(self._member(text, name))
        if not self._take(_END_BRACE):
            self._fail(",", "}")
        return _some(name, lambda held: any(test(held) for test in tests))

    def _member(self, text: str, name: Name) -> Test:
        word = self._value()
        low, dots, high = word.text.partition("..")
        if word.is_quoted or not dots:
            return self._test(text, name, "==", word)
        if not low or not high:
            raise word.error(f"a range needs a number on each side of the dots, not {word.text}")
        start = self._test(text, name, ">=", Word(low, word.column))
        stop = self._test(text, name, "<=", Word(high, word.column + len(low) + len(dots)))
        return lambda held: start(held) and stop(held)

    def _test(self, text: str, name: Name, sign: str, word: Word) -> Test:
        """Makes a test; a time without a unit is a likely reason for finding nothing, as milliseconds are shown."""
        if name.kind.units == SECONDS and word.number:
            self.hint = f"; a number without a unit is in seconds: {word.text}ms"
        return name.kind.test(text, sign, word)

    def _value(self) -> Word:
        found = self._take(_VALUE) or self._fail("a value")
        written, column = found[0], found.start() + 1
        if found["raw"]:
            return Word(written[2:-1], column, 2, len(written))
        if not found["text"]:
            return Word(written, column)

        def meant(escape: re.Match[str]) -> str:
            if len(escape[1]) == 3:
                return chr(int(escape[1][1:], 16))
            if escape[1] not in _ESCAPES:
                known = r'\" \' \\ \n \r \t \0 \x41, and none in r"..."'
                reason = f"unknown escape {escape[0]}: known are {known}"
                raise FilterError(column + 1 + escape.start(), reason, len(escape[0]))
            return _ESCAPES[escape[1]]

        return Word(_ESCAPE.sub(meant, written[1:-1]), column, 1, len(written))

    def _fail_after_condition(self, last: str) -> NoReturn:
        self._fail(*(["a comparison"] if self._at == self._name_end else []), "&&", "||", last)

    def _fail(self, *expected: str) -> NoReturn:
        self._take(_SPACE)
        *most, last = expected
        wanted = f"{', '.join(most)} or {last}" if most else last
        found = _PIECE.match(self._text, self._at)
        if not found:
            raise FilterError(self._at + 1, f"the filter ends early: expected {wanted}")
        if found[0] in "\"'" and wanted == "a value":
            reason = f"missing {found[0]} at the end of this text"
            raise FilterError(self._at + 1, reason, len(self._text) - self._at)
        wanted = _OF_OTHER_LANGUAGES.get(found[0].lower(), wanted)
        raise FilterError(self._at + 1, f"expected {wanted}", len(found[0]))


def _negated(part: Condition) -> Condition:
    return lambda records: not part(records)


def _values(name: Name, records: Sequence[Record]) -> list[FilterValue]:
    return [held for record in records for held in name.read(record) if held.value is not None]


def _some(name: Name, test: Test) -> Condition:
    return lambda records: any(map(test, _values(name, records)))
