"""Errors in assembly text, of frames and of programs: the place, what is there, what was expected."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterable
from typing import NamedTuple

from ev3proto.errors import Error

NEWLINE = r"\r\n|\r|\n"
"""Pattern of what ends a line."""

MOST_ERRORS = 20
"""Maximum number of errors that are reported: later ones mostly follow from the first."""

_MOST_SAID = 500
"""Maximum length of a message: what it quotes may be as long as the text."""

_MOST_SHOWN = 100
"""Maximum number of characters of a line that are shown around an error."""

_MOST_CITED = 40


class AssemblyError(ValueError, Error):
    """An error in assembly text.

    line    its line, counted from 1
    column  its column, counted from 1
    reason  one sentence: what is there, what was expected, the nearest name
    text    the line, as written
    others  the other errors, in the order of the text
    """

    def __init__(
        self, line: int, column: int, reason: str, text: str = "", others: tuple[AssemblyError, ...] = ()
    ) -> None:
        self.line = line
        self.column = column
        self.reason = reason
        self.text = text
        self.others = others
        super().__init__(f"line {line}, column {column}: {reason}")

    def __reduce__(self) -> tuple[type[AssemblyError], tuple[int, int, str, str, tuple[AssemblyError, ...]]]:
        return (type(self), (self.line, self.column, self.reason, self.text, self.others))

    @property
    def excerpt(self) -> str:
        """The line and, below it, a mark at the column: two lines of at most a hundred characters."""
        start = max(0, min(self.column - 1 - _MOST_SHOWN // 2, len(self.text) - _MOST_SHOWN))
        shown = self.text[start : start + _MOST_SHOWN]
        before = shown[: self.column - 1 - start]
        # Tabs stay, so that the mark is below its character for any tab width.
        padding = "".join("\t" if character == "\t" else " " for character in before)
        return f"{shown}\n{padding}^"


class SourceError(Exception):
    """One error, at an offset in the text; users get it as an AssemblyError."""

    def __init__(self, at: int, reason: str) -> None:
        self.at = at
        self.reason = reason
        super().__init__(reason)


class SourceWarning(NamedTuple):
    """A warning about valid but probably unintended code."""

    line: int  # counted from 1
    column: int  # counted from 1
    reason: str  # one sentence

    def __str__(self) -> str:
        return f"line {self.line}, column {self.column}: {self.reason}"


class Lines:
    """The lines of a text, for turning offsets into lines and columns."""

    def __init__(self, text: str) -> None:
        self._text = text
        self._starts = [0, *(found.end() for found in re.finditer(NEWLINE, text))]

    def place(self, at: int) -> tuple[int, int]:
        """Returns line and column of an offset, both counted from 1."""
        line = bisect_right(self._starts, at)
        return line, at - self._starts[line - 1] + 1

    def error(self, errors: Iterable[SourceError]) -> AssemblyError:
        """Returns all errors as one, in the order of the text."""
        first, *others = map(self._one, sorted(errors, key=lambda error: error.at)[:MOST_ERRORS])
        return AssemblyError(first.line, first.column, first.reason, first.text, tuple(others))

    def warnings(self, found: Iterable[tuple[int, str]]) -> tuple[SourceWarning, ...]:
        """Returns the warnings with their places, in the order of the text."""
        return tuple(SourceWarning(*self.place(at), reason) for at, reason in sorted(set(found)))

    def _one(self, error: SourceError) -> AssemblyError:
        line, column = self.place(error.at)
        end = self._starts[line] if line < len(self._starts) else len(self._text)
        reason = error.reason if len(error.reason) <= _MOST_SAID else f"{error.reason[:_MOST_SAID]}..."
        return AssemblyError(line, column, reason, self._text[self._starts[line - 1] : end].rstrip("\r\n"))


def cited(text: str) -> str:
    """Returns quoted text, truncated if it is long."""
    return text if len(text) <= _MOST_CITED else f"{text[:_MOST_CITED]}..."
