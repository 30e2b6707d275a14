"""The language of filters: its grammar, and the tree that it makes of a text. What names mean is no matter here."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from enum import Enum
from functools import cache
from typing import Any

from lark import Lark, Token, Transformer, v_args
from lark.exceptions import UnexpectedCharacters, UnexpectedInput, UnexpectedToken

MAX_LENGTH = 4096
"""Characters that a filter may have."""

MAX_DEPTH = 50
"""How deep conditions may stand in each other."""

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

// Words that mean something here mean it only where they can stand: `in` may be a name's value all the same.
_AND: "&&" | /and\b/i
_OR: "||" | /or\b/i
_NOT.2: /!(?!=)/ | /not\b/i
_IN.2: /in\b/i
RELATION.2: "==" | "!=" | "<=" | ">=" | "<" | ">" | /(eq|ne|lt|le|gt|ge|contains|like|matches)\b/i

// SOUND.TONE.FREQUENCY, VALUES[0]
NAME: /[A-Za-z_][A-Za-z0-9_]*(\.[A-Za-z0-9_]+)*(\[[0-9]+\])?/
// Whatever needs no quotes: 440, 4ms, 0x94, -1.5, 1..5, SOUND.TONE, direct-reply, 192.0.2.1:5555, 00:16:53:00:00:0a
WORD: /[^\s"'(){},!=<>&|]+/
TEXT: /"(\\.|[^"\\])*"/s | /'(\\.|[^'\\])*'/s
// As Wireshark has it: no escapes in these.
RAW.2: /r"[^"]*"/ | /r'[^']*'/

%ignore /\s+/
"""


TIME_UNITS = {"ns": 1, "us": 10**3, "µs": 10**3, "ms": 10**6, "s": 10**9, "min": 60 * 10**9}
"""Nanoseconds in each unit that a time can have."""


class FilterError(ValueError):
    """A text that is no filter.

    column  of the character where the trouble starts; the first one is 1
    reason  one sentence: what stands there, what was expected
    length  how many characters are in trouble, at least 1
    """

    def __init__(self, column: int, reason: str, length: int = 1) -> None:
        self.column = column
        self.reason = reason
        self.length = max(length, 1)
        super().__init__(f"column {column}: {reason}")

    def __reduce__(self) -> tuple[type[FilterError], tuple[int, str, int]]:
        return (type(self), (self.column, self.reason, self.length))


class Relation(Enum):
    """How a value can stand to another; the value is how it is written first of all."""

    EQ = "=="
    NE = "!="
    LT = "<"
    LE = "<="
    GT = ">"
    GE = ">="
    CONTAINS = "contains"
    LIKE = "like"
    MATCHES = "matches"


_RELATIONS = {relation.value: relation for relation in Relation} | {
    relation.name.lower(): relation for relation in Relation
}


@dataclass(frozen=True, slots=True)
class Word:
    """A name or a value as it was written.

    text     without quotes, escapes resolved
    column   of its first character, from 1 on
    quoted   it stood in quotes, so it is a text and nothing else
    opening  how many characters stand before the text: a quote, or r and a quote
    length   how many characters were written in all, 0 for as many as the text has
    """

    text: str
    column: int
    quoted: bool = False
    opening: int = 0
    length: int = 0

    def trouble(self, reason: str, position: int | None = None) -> FilterError:
        """What is wrong with it, as a whole or from one of its characters on."""
        length = self.length or len(self.text)
        shift = 0 if position is None else min(position + self.opening, length - 1)
        return FilterError(self.column + shift, reason, length - shift)


@dataclass(frozen=True, slots=True)
class Presence:
    """A name alone."""

    name: Word


@dataclass(frozen=True, slots=True)
class Comparison:
    """A name, a relation, a value."""

    name: Word
    relation: Relation
    value: Word


@dataclass(frozen=True, slots=True)
class Membership:
    """A name in a set of values and ranges."""

    name: Word
    members: tuple[Word, ...]


@dataclass(frozen=True, slots=True)
class Negation:
    """What must not hold."""

    part: Condition
    depth: int


@dataclass(frozen=True, slots=True)
class Every:
    """Conditions that must all hold."""

    parts: tuple[Condition, ...]
    depth: int


@dataclass(frozen=True, slots=True)
class Some:
    """Conditions of which one must hold."""

    parts: tuple[Condition, ...]
    depth: int


Condition = Presence | Comparison | Membership | Negation | Every | Some


def parse_filter(text: str) -> Condition:
    """The tree of a filter.

    Raises:
        FilterError: The text is no filter.
    """
    if len(text) > MAX_LENGTH:
        raise FilterError(
            MAX_LENGTH + 1, f"the filter has {len(text)} characters, but it can have at most {MAX_LENGTH}"
        )

    try:
        tree: Any = _parser().parse(text)
    except UnexpectedInput as error:
        raise _explained(text, error) from None
    condition: Condition = tree
    return condition


@cache
def _parser() -> Lark:
    @v_args(inline=True)
    class Builder(Transformer):  # type: ignore[type-arg]
        """Makes the tree while the text is read, so that nothing here calls itself."""

        def value(self, token: Token) -> Word:
            if token.type == "WORD":
                return Word(str(token), _column(token))
            if token.type == "RAW":
                return Word(token[2:-1], _column(token), quoted=True, opening=2, length=len(token))
            text = _unescaped(token[1:-1], _column(token) + 1)
            return Word(text, _column(token), quoted=True, opening=1, length=len(token))

        def presence(self, name: Token) -> Presence:
            return Presence(_name(name))

        def comparison(self, name: Token, relation: Token, value: Word) -> Comparison:
            return Comparison(_name(name), _RELATIONS[relation.lower()], value)

        def membership(self, name: Token, *members: Word) -> Membership:
            return Membership(_name(name), members)

        def exclusion(self, name: Token, *members: Word) -> Negation:
            return Negation(self.membership(name, *members), 1)

        def negation(self, part: Condition) -> Negation:
            return Negation(part, _depth((part,)))

        def conjunction(self, *parts: Condition) -> Every:
            return Every(parts, _depth(parts))

        def disjunction(self, *parts: Condition) -> Some:
            return Some(parts, _depth(parts))

    return Lark(GRAMMAR, parser="lalr", lexer="contextual", transformer=Builder(), maybe_placeholders=False)


def _name(token: Token) -> Word:
    return Word(str(token), _column(token))


def _column(token: Token) -> int:
    return (token.start_pos or 0) + 1


def _depth(parts: Iterable[Condition]) -> int:
    depth = 1 + max(part.depth if isinstance(part, Negation | Every | Some) else 0 for part in parts)
    if depth > MAX_DEPTH:
        raise FilterError(1, f"the conditions stand in each other more than {MAX_DEPTH} deep")
    return depth


_ESCAPE = re.compile(r"\\(x[0-9a-fA-F]{2}|.)", re.DOTALL)
_ESCAPES = {'"': '"', "'": "'", "\\": "\\", "n": "\n", "r": "\r", "t": "\t", "0": "\0"}


def _unescaped(text: str, column: int) -> str:
    def meant(found: re.Match[str]) -> str:
        escape = found[1]
        if len(escape) == 3:
            return chr(int(escape[1:], 16))
        if escape not in _ESCAPES:
            raise FilterError(
                column + found.start(),
                f'\\{escape} is no escape: there are \\" \\\' \\\\ \\n \\r \\t \\0 \\x41, and none in r"..."',
                len(found[0]),
            )
        return _ESCAPES[escape]

    return _ESCAPE.sub(meant, text)


# What could not be read

_PHRASES = {
    "NAME": "a name",
    "_NOT": "",
    "LPAR": "(",
    "WORD": "a value",
    "RELATION": "a comparison such as ==",
    "_IN": "in",
    "LBRACE": "{",
    "COMMA": ",",
    "RBRACE": "}",
    "RPAR": ")",
    "_AND": "&&",
    "_OR": "||",
    "$END": "the end",
}
"""What people call the grammar's terminals, in the order in which they are listed."""

_HINTS = {
    "=": "; equal is ==",
    "&": "; and is &&",
    "|": "; or is ||",
    "~": "; matches takes a regular expression",
    "=~": "; matches takes a regular expression",
    "is": "; equal is ==",
    "xor": "; there are and, or, not",
    **dict.fromkeys(TIME_UNITS, "; a unit stands right after its number: 4ms"),
}
"""What people write who know other languages."""

_PIECE = re.compile(r"[\w.:-]+|[=!<>&|~]+|.", re.DOTALL)


def _explained(text: str, error: UnexpectedInput) -> FilterError:
    if isinstance(error, UnexpectedToken):
        at, terminals = error.token.start_pos, error.accepts or error.expected
        if error.token.type == "$END" or at is None:
            at = len(text)
    elif isinstance(error, UnexpectedCharacters):
        at, terminals = error.pos_in_stream or 0, error.allowed
    else:
        at, terminals = len(text), set()
    expected = _expected(terminals or set(), text[:at])
    if not text.strip():
        return FilterError(1, "the filter is empty: it is made of conditions such as op==SOUND.TONE")
    found = _PIECE.match(text, at)
    if found is None:
        return FilterError(len(text) + 1, f"the filter ends where {expected} should stand")
    if found[0] in "\"'" and "a value" in expected:
        return FilterError(at + 1, f"the text that starts here has no {found[0]} at its end", len(text) - at)
    hint = _HINTS.get(found[0].lower(), "")
    return FilterError(at + 1, f"{found[0]} stands where {expected} should{hint}", len(found[0]))


def _expected(terminals: Iterable[str], before: str) -> str:
    """`a name or (`."""
    there = set(terminals)
    # A parenthesis can only close one that is open; the grammar's lexer does not count them.
    if before.count("(") <= before.count(")"):
        there.discard("RPAR")
    phrases = [phrase for terminal, phrase in _PHRASES.items() if terminal in there and phrase]
    *most, last = phrases or ["the end"]
    return f"{', '.join(most)} or {last}" if most else last
