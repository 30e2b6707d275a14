"""Assembly text cut into tokens: names, numbers, texts, marks. Lines count where a statement ends with its line."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum

from ev3proto.text.late_pattern import late_pattern

MAX_NAME = 200
"""Characters of a name."""


class TokenKind(StrEnum):
    """What a token is. A word starts like a number and is none: hex, where bytes are written."""

    NAME = "name"
    NUMBER = "number"
    WORD = "word"
    TEXT = "text"
    MARK = "mark"
    BAD = "bad"
    END = "end"


@dataclass(frozen=True, slots=True)
class Token:
    """A piece of the text.

    kind      what it is
    text      as it was written; of a bad one, the sentence that says what is wrong
    line      counted from 1
    column    of its first character, counted from 1
    is_first  it is the first of its line
    """

    kind: TokenKind
    text: str
    line: int
    column: int
    is_first: bool

    def is_mark(self, *marks: str) -> bool:
        """Whether it is one of these marks."""
        return self.kind is TokenKind.MARK and self.text in marks


_TOKEN = late_pattern(
    r"""(?P<blank>[ \t\r\f\v\ufeff]+ | //[^\n]*)
      | (?P<newline>\n)
      | (?P<comment>/\*)
      | (?P<number>(?:0[xX][0-9a-fA-F]+ | 0[bB][01]+ | (?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?[fF]?)(?![\w.]))
      | (?P<name>[A-Za-z_]\w*(?:\.[A-Za-z_]\w*)*)
      | (?P<word>\w+)
      | (?P<text>"(?:[^"\\\n]|\\[^\n])*" | '(?:[^'\\\n]|\\[^\n])*')
      | (?P<mark>\.\.\. | [-+*/|()\[\]{},:;=@&#])""",
    re.VERBOSE | re.ASCII,
)


def tokens(text: str) -> Iterator[Token]:
    """The tokens of a text, and one for its end. What is none is a bad token; nothing is raised."""
    at = line_start = 0
    line = 1
    is_first = True
    while at < len(text):
        found = _TOKEN.match(text, at)
        kind = found.lastgroup if found else None
        if found and kind == "newline":
            at = line_start = found.end()
            line, is_first = line + 1, True
            continue
        if found and kind == "blank":
            at = found.end()
            continue
        if found and kind == "comment":
            end = text.find("*/", found.end())
            if end < 0:
                yield Token(
                    TokenKind.BAD, "the comment that starts here has no */", line, at - line_start + 1, is_first
                )
                break
            line += text.count("\n", at, end)
            line_start = max(line_start, text.rfind("\n", at, end) + 1)
            at = end + 2
            continue
        column = at - line_start + 1
        if found and kind == "name" and found.end() - at > MAX_NAME:
            yield Token(TokenKind.BAD, f"a name has at most {MAX_NAME} characters", line, column, is_first)
            at = found.end()
        elif found:
            yield Token(TokenKind(kind or ""), found[0], line, column, is_first)
            at = found.end()
        else:
            reason, at = _bad(text, at)
            yield Token(TokenKind.BAD, reason, line, column, is_first)
        is_first = False
    yield Token(TokenKind.END, "", line, len(text) - line_start + 1, True)


def _bad(text: str, at: int) -> tuple[str, int]:
    """What is wrong with a character that starts no token, and where to read on."""
    character = text[at]
    if character in "\"'":
        end = text.find("\n", at)
        return f"the text that starts here has no {character} at its end", len(text) if end < 0 else end
    return f"{character!r} cannot stand here", at + 1


_ESCAPE = late_pattern(r"\\(x[0-9a-fA-F]{2}|u[0-9a-fA-F]{4}|.)", re.DOTALL)
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
ESCAPES = r"\n \r \t \b \f \q (an apostrophe) \0 \" \' \\ \/ \x41 \u0041"
"""The escapes in texts, for people."""


def unescaped(token: Token) -> tuple[str, int | None]:
    """What stands between a text's quotes, and where in the token its first unknown escape is, None without one.

    A backslash before a blank is none: LEGO's assembler leaves it as it is, which names of files need.
    """
    body = token.text[1:-1]
    if "\\" not in body:
        return body, None
    unknown: int | None = None

    def meant(found: re.Match[str]) -> str:
        nonlocal unknown
        escape = found[1]
        if len(escape) > 1:
            return chr(int(escape[1:], 16))
        if escape == " ":
            return found[0]
        if escape not in _ESCAPES and unknown is None:
            unknown = found.start() + 1
        return _ESCAPES.get(escape, "")

    return _ESCAPE.sub(meant, body), unknown
