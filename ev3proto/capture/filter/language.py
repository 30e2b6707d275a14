"""The language of filters: from a text to a test of records."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from functools import cache
from typing import NamedTuple

from lark import Lark, Token, Transformer, v_args
from lark.exceptions import UnexpectedCharacters, UnexpectedInput, UnexpectedToken

from ev3proto.capture.dialogues import RequestReply
from ev3proto.capture.filter.names import Name, find_name
from ev3proto.capture.filter.values import TIME_UNITS, FilterError, Held, Relation, Test, Word
from ev3proto.capture.record import Record

MAX_LENGTH = 4096
"""Characters that a filter may have."""

MAX_DEPTH = 50
"""Maximum nesting depth of conditions."""

GRAMMAR = r"""
// "and" binds tighter than "or", "not" tighter than both; parentheses as everywhere.
?start: disjunction
?disjunction: conjunction (_OR conjunction)*
?conjunction: condition (_AND condition)*
?condition: _NOT condition -> negation
          | "(" disjunction ")"
          | NAME -> presence
          | NAME RELATION value -> comparison
          | NAME _IN "{" value ("," value)* "}" -> membership
          | NAME _NOT _IN "{" value ("," value)* "}" -> exclusion
value: WORD | TEXT | RAW

// The words of the language are not reserved: `in` can be a value, too.
_AND: "&&" | /and\b/i
_OR: "||" | /or\b/i
_NOT.2: /!(?!=)/ | /not\b/i
_IN.2: /in\b/i
RELATION.2: "==" | "!=" | "<=" | ">=" | "<" | ">" | /(eq|ne|lt|le|gt|ge|contains|like|matches)\b/i

// SOUND.TONE.FREQUENCY, VALUES[0]
NAME: /[A-Za-z_][A-Za-z0-9_]*(\.[A-Za-z0-9_]+)*(\[[0-9]+\])?/
// Anything that needs no quotes: 440, 4ms, 0x94, -1.5, 1..5, SOUND.TONE, direct-reply, 192.0.2.1:5555
WORD: /[^\s"'(){},!=<>&|]+/
TEXT: /"(\\.|[^"\\])*"/s | /'(\\.|[^'\\])*'/s
// Without escapes, as in Wireshark.
RAW.2: /r"[^"]*"/ | /r'[^']*'/

%ignore /\s+/
"""

_RELATIONS = {relation.value: relation for relation in Relation} | {
    relation.name.lower(): relation for relation in Relation
}
_RANGE = ".."
"""Between the ends of a range."""


class _Condition(NamedTuple):
    """A part of a filter.

    holds        whether it is true of some records together, of a capture that began at these nanoseconds
    looks_ahead  it asks for what a command's record does not know before its reply was seen
    depth        of the conditions in it
    """

    holds: Callable[[Sequence[Record], int], bool]
    looks_ahead: bool = False
    depth: int = 0


class Filter:
    """Whether a record is wanted, or a command together with its reply.

    A filter that asks for `time` counts it from what `begin` was given, or else from the first record that it is asked
    about: compile one for each capture, or call `begin` for each.

    text         as it was written
    looks_ahead  it asks for what a command's record does not know before its reply was seen (`unanswered`, `failed`,
                 `late`): ask it about records of a capture that was read to its end, or use `Choosing`
    """

    def __init__(self, text: str) -> None:
        """Reads a filter. Raises FilterError for a text that is not one."""
        condition = _parsed(text)
        self.text = text
        self.looks_ahead = condition.looks_ahead
        self._holds = condition.holds
        self._start_ns: int | None = None

    def __call__(self, record: Record) -> bool:
        """True for a record that is wanted."""
        return self._hold((record,))

    def begin(self, time_ns: int) -> None:
        """Begins a capture: `time` counts from here on, in nanoseconds since 1970-01-01 UTC."""
        self._start_ns = time_ns

    def of_dialogue(self, pair: RequestReply) -> bool:
        """True for a command with its reply that is wanted. Each condition may be true of the one or of the other.

        So `FREQUENCY > 400 && latency > 4ms` can hold, of which the command has the first and the reply the second.
        """
        return self._hold([record for record in pair if record is not None])

    def _hold(self, records: Sequence[Record]) -> bool:
        if self._start_ns is None:
            self.begin(records[0].time_ns)
        return self._holds(records, self._start_ns or 0)

    def __repr__(self) -> str:
        return f"compile_filter({self.text!r})"


def compile_filter(text: str) -> Filter:
    """Makes a filter.

    Args:
        text: The filter as it is written, such as `op==SOUND.TONE && FREQUENCY>400`.

    Returns:
        A function that says whether a record is wanted.

    Raises:
        FilterError: The text is not a filter. This ValueError says why, and in which column.
    """
    return Filter(text)


def _parsed(text: str) -> _Condition:
    if len(text) > MAX_LENGTH:
        raise FilterError(MAX_LENGTH + 1, f"the filter has {len(text)} characters; at most {MAX_LENGTH} are allowed")
    try:
        condition: _Condition = _parser().parse(text)  # type: ignore[assignment]
    except UnexpectedInput as error:
        raise _explained(text, error) from None
    return condition


@v_args(inline=True)
class _Builder(Transformer):  # type: ignore[type-arg]
    """Makes the conditions while the text is read, without recursion."""

    def value(self, token: Token) -> Word:
        if token.type == "WORD":
            return _word(token)
        if token.type == "RAW":
            return Word(token[2:-1], _column(token), 2, len(token))
        return Word(_unescaped(token[1:-1], _column(token) + 1), _column(token), 1, len(token))

    def presence(self, token: Token) -> _Condition:
        name = find_name(_word(token))
        if name.kind.is_flag:
            return _some(name, name.kind.test(token, Relation.EQ, Word("true", _column(token))))
        return _Condition(
            lambda records, start_ns: any(True for record in records for _ in name.read(record, start_ns)),
            name.looks_ahead,
        )

    def comparison(self, token: Token, operator: Token, value: Word) -> _Condition:
        name, relation = find_name(_word(token)), _RELATIONS[operator.lower()]
        if relation is not Relation.NE:
            return _some(name, name.kind.test(token, relation, value))
        test = name.kind.test(token, Relation.EQ, value)

        def holds(records: Sequence[Record], start_ns: int) -> bool:
            values = _values(name, records, start_ns)
            return bool(values) and not any(map(test, values))

        return _Condition(holds, name.looks_ahead)

    def membership(self, token: Token, *members: Word) -> _Condition:
        name = find_name(_word(token))
        tests = [_member_test(token, name, member) for member in members]
        return _some(name, lambda held: any(test(held) for test in tests))

    def exclusion(self, token: Token, *members: Word) -> _Condition:
        return self.negation(self.membership(token, *members))

    def negation(self, part: _Condition) -> _Condition:
        return _joined(lambda records, start_ns: not part.holds(records, start_ns), part)

    def conjunction(self, *parts: _Condition) -> _Condition:
        return _joined(lambda records, start_ns: all(part.holds(records, start_ns) for part in parts), *parts)

    def disjunction(self, *parts: _Condition) -> _Condition:
        return _joined(lambda records, start_ns: any(part.holds(records, start_ns) for part in parts), *parts)


@cache
def _parser() -> Lark:
    return Lark(GRAMMAR, parser="lalr", lexer="contextual", transformer=_Builder(), maybe_placeholders=False)


def _word(token: Token) -> Word:
    return Word(str(token), _column(token))


def _column(token: Token) -> int:
    return (token.start_pos or 0) + 1


def _values(name: Name, records: Iterable[Record], start_ns: int) -> list[Held]:
    """The values that are known."""
    return [held for record in records for held in name.read(record, start_ns) if held.value is not None]


def _some(name: Name, test: Test) -> _Condition:
    """Some value passes a test."""
    return _Condition(lambda records, start_ns: any(map(test, _values(name, records, start_ns))), name.looks_ahead)


def _joined(holds: Callable[[Sequence[Record], int], bool], *parts: _Condition) -> _Condition:
    depth = 1 + max(part.depth for part in parts)
    if depth > MAX_DEPTH:
        raise FilterError(1, f"conditions are nested more than {MAX_DEPTH} deep")
    return _Condition(holds, any(part.looks_ahead for part in parts), depth)


def _member_test(text: str, name: Name, member: Word) -> Test:
    """The test of one value or range in braces."""
    low, range_, high = member.text.partition(_RANGE)
    if member.is_quoted or not range_:
        return name.kind.test(text, Relation.EQ, member)
    if not low or not high:
        raise member.error(f"a range needs a number on each side of the dots, not {member.text}")
    start = name.kind.test(text, Relation.GE, Word(low, member.column))
    stop = name.kind.test(text, Relation.LE, Word(high, member.column + len(low) + len(_RANGE)))
    return lambda held: start(held) and stop(held)


_ESCAPE = re.compile(r"\\(x[0-9a-fA-F]{2}|.)", re.DOTALL)
_ESCAPES = {'"': '"', "'": "'", "\\": "\\", "n": "\n", "r": "\r", "t": "\t", "0": "\0"}


def _unescaped(text: str, column: int) -> str:
    def meant(found: re.Match[str]) -> str:
        escape = found[1]
        if len(escape) == 3:
            return chr(int(escape[1:], 16))
        if escape not in _ESCAPES:
            known = r'\" \' \\ \n \r \t \0 \x41, and none in r"..."'
            raise FilterError(column + found.start(), f"unknown escape \\{escape}: known are {known}", len(found[0]))
        return _ESCAPES[escape]

    return _ESCAPE.sub(meant, text)


# Errors of syntax

_PHRASES = {
    "NAME": "a name",
    "WORD": "a value",
    "RELATION": "a comparison",
    "LBRACE": "{",
    "COMMA": ",",
    "RBRACE": "}",
    "RPAR": ")",
    "_AND": "&&",
    "_OR": "||",
    "$END": "the end",
}
"""What people call the grammar's terminals, in the order in which they are listed."""

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
"""What is expected in place of words and signs of other languages."""

_PIECE = re.compile(r"[\w.:-]+|[=!<>&|~]+|.", re.DOTALL)


def _explained(text: str, error: UnexpectedInput) -> FilterError:
    if not text.strip():
        return FilterError(1, "empty filter; write a condition such as op==SOUND.TONE")
    at, terminals = len(text), set[str]()
    if isinstance(error, UnexpectedToken):
        terminals = error.accepts or error.expected
        if error.token.type != "$END":
            at = error.token.start_pos or 0
    elif isinstance(error, UnexpectedCharacters):
        at, terminals = error.pos_in_stream or 0, error.allowed or set()
    found = text[at:] and _PIECE.match(text, at)
    if not found:
        return FilterError(at + 1, f"the filter ends early: expected {_expected(terminals, text)}")
    if found[0] in "\"'" and "WORD" in terminals:
        return FilterError(at + 1, f"missing {found[0]} at the end of this text", len(text) - at)
    return FilterError(
        at + 1,
        f"expected {_OF_OTHER_LANGUAGES.get(found[0].lower()) or _expected(terminals, text[:at])}",
        len(found[0]),
    )


def _expected(terminals: Iterable[str], before: str) -> str:
    """`a comparison, && or ||`. The lexer does not count the parentheses that are open."""
    there = {*terminals} - ({"RPAR"} if before.count("(") <= before.count(")") else set())
    *most, last = [phrase for terminal, phrase in _PHRASES.items() if terminal in there] or ["the end"]
    return f"{', '.join(most)} or {last}" if most else last
