"""Cuts assembly text into tokens: names, numbers, texts, marks. The notation defines their syntax."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from typing import NamedTuple

from ev3proto.tables.encoding import STRING_CODING
from ev3proto.text.assembly.errors import NEWLINE, SourceError
from ev3proto.text.assembly.notations import NUMBER_PATTERN, Notation

NAME, NUMBER, WORD, TEXT, MARK, BAD, END = "name", "number", "word", "text", "mark", "bad", "end"
"""Kinds of tokens. A word starts like a number but is not one, such as bytes in hex."""


class Lexeme(NamedTuple):
    """A token of a source."""

    kind: str
    text: str  # as written; for a bad token, the error message
    at: int  # offset of its first character
    is_first: bool  # whether it is the first of its line

    @property
    def end(self) -> int:
        """The offset after it."""
        return self.at + len(self.text)

    def is_mark(self, *marks: str) -> bool:
        """Returns whether it is one of these marks."""
        return self.kind == MARK and self.text in marks


@cache
def _pattern(notation: Notation) -> re.Pattern[str]:
    """Returns the pattern of a token. It matches any text, in linear time."""
    pieces = {
        "blank": rf"(?>(?:{notation.blank})+)",
        "newline": NEWLINE,
        "comment": r"/\*[\s\S]*?\*/",
        NUMBER: rf"(?:{NUMBER_PATTERN})(?![\w.])",
        NAME: r"[A-Za-z_]\w*+(?>(?:\.[A-Za-z_]\w*+)*)",
        WORD: r"\.?\w[\w.]*+",
        TEXT: rf'"(?>(?:[^"\\\r\n]|\\[^\r\n])*)"|{notation.text}',
        "open": r"""["'][^\r\n]*+|/\*[\s\S]*+""",
        MARK: notation.marks,
        BAD: r"[\s\S]",
    }
    return re.compile("|".join(f"(?P<{kind}>{pattern})" for kind, pattern in pieces.items()), re.ASCII)


def tokens(text: str, notation: Notation) -> Iterator[Lexeme]:
    """Yields the tokens of a text, and one for its end. Anything else is a bad token; nothing is raised."""
    is_first = True
    for found in _pattern(notation).finditer(text):
        kind, written, at = found.lastgroup, found[0], found.start()
        match kind:
            case "blank":
                continue
            case "newline":
                is_first = True
                continue
            case "comment":
                is_first |= "\n" in written or "\r" in written
                continue
            case "open" if written[0] == "/":
                yield Lexeme(BAD, "the comment that starts here has no */", at, is_first)
            case "open":
                yield Lexeme(BAD, f"the text that starts here has no {written[0]} at its end", at, is_first)
            case "bad":
                yield Lexeme(BAD, f"unexpected {written!r}", at, is_first)
            case "name" if notation.folds:
                yield Lexeme(NAME, written.upper(), at, is_first)
            case _:
                yield Lexeme(str(kind), written, at, is_first)
        is_first = False
    yield Lexeme(END, "", len(text), True)


_ESCAPE = re.compile(r"\\(x[0-9a-fA-F]{2}|u[0-9a-fA-F]{4}|.)", re.DOTALL)
_ESCAPES = {
    "n": "\n",
    "r": "\r",
    "t": "\t",
    "b": "\b",
    "f": "\f",
    "q": "'",
    "0": "\0",
    '"': '"',
    "'": "'",
    "\\": "\\",
    "/": "/",
}
_KNOWN_ESCAPES = r"\n \r \t \b \f \q (an apostrophe) \0 \" \' \\ \/ \x41 \u0041"


def text_of(token: Lexeme, notation: Notation, coding: str, warnings: list[tuple[int, str]]) -> str:
    """Returns the text between quotes, each byte of its coding a character. Raises SourceError."""
    body = token.text[1:-1]
    if notation.escapes is None or token.text[0] == '"':
        return _unescaped(token, body)
    if "\\" in body or "''" in body:
        body = _replaced(token, body, notation, warnings)
    try:
        return body.encode(coding).decode(STRING_CODING)
    except UnicodeEncodeError:
        # LEGO's assembler writes the low byte of each character.
        return bytes(ord(character) & 0xFF for character in body).decode(STRING_CODING)


def _unescaped(token: Lexeme, body: str) -> str:
    """Replaces escapes as in C. A backslash before a blank stays: file names need it."""

    def meant(found: re.Match[str]) -> str:
        escape = found[1]
        if len(escape) > 1:
            return chr(int(escape[1:], 16))
        if escape == " ":
            return found[0]
        if escape not in _ESCAPES:
            raise SourceError(token.at + 1 + found.start(), rf"unknown escape \{escape}: there are {_KNOWN_ESCAPES}")
        return _ESCAPES[escape]

    return _ESCAPE.sub(meant, body) if "\\" in body else body


def _replaced(token: Lexeme, body: str, notation: Notation, warnings: list[tuple[int, str]]) -> str:
    """Replaces the escapes of a program's notation, kind after kind."""
    escapes = notation.escapes or ()
    if not notation.by_line:
        known = {escape[1] for escape, _ in escapes}
        for found in _ESCAPE.finditer(body):
            if found[1][0] not in known:
                listed = ", ".join(escape for escape, _ in escapes)
                raise SourceError(token.at + 1 + found.start(), rf"unknown escape \{found[1][0]}: there are {listed}")
        if re.search(r"\\\\[nqrt]", body):
            warnings.append(
                (token.at, r"escapes are replaced kind after kind: of \\n stays a backslash with the line end after it")
            )
    for escape, character in escapes:
        body = body.replace(escape, character)
    return body
