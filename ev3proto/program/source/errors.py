"""What is wrong in a source, by its place in the text: errors that stop it, warnings that do not."""

from __future__ import annotations

from bisect import bisect_right
from typing import NamedTuple

from ev3proto.text.assembly.errors import MOST_ERRORS, MOST_SAID, AssemblyError


class SourceError(Exception):
    """One error, at an offset in the text."""

    def __init__(self, at: int, reason: str) -> None:
        self.at = at
        self.reason = reason
        super().__init__(reason)


class SourceWarning(NamedTuple):
    """Something that is assembled, and perhaps not meant.

    line    counted from 1
    column  counted from 1
    reason  one sentence
    """

    line: int
    column: int
    reason: str

    def __str__(self) -> str:
        return f"line {self.line}, column {self.column}: {self.reason}"


class Lines:
    """The lines of a text, for turning offsets into lines and columns. A line ends with LF, CRLF or CR."""

    def __init__(self, text: str) -> None:
        self._text = text
        self._starts = [0]
        at = 0
        for line in text.splitlines(keepends=True):
            at += len(line)
            if line.endswith(("\n", "\r")):
                self._starts.append(at)

    def place(self, at: int) -> tuple[int, int]:
        """Line and column of an offset, both counted from 1."""
        line = bisect_right(self._starts, at)
        return line, at - self._starts[line - 1] + 1

    def error(self, errors: list[SourceError]) -> AssemblyError:
        """All errors as one, in the order of the text."""
        first, *others = [self._one(error) for error in sorted(errors, key=lambda it: it.at)[:MOST_ERRORS]]
        return AssemblyError(first.line, first.column, first.reason, first.text, tuple(others))

    def warnings(self, found: list[tuple[int, str]]) -> tuple[SourceWarning, ...]:
        """Warnings with their places, in the order of the text."""
        return tuple(SourceWarning(*self.place(at), reason) for at, reason in sorted(set(found)))

    def _one(self, error: SourceError) -> AssemblyError:
        line, column = self.place(error.at)
        start = self._starts[line - 1]
        end = self._starts[line] if line < len(self._starts) else len(self._text)
        reason = error.reason if len(error.reason) <= MOST_SAID else f"{error.reason[:MOST_SAID]}..."
        return AssemblyError(line, column, reason, self._text[start:end].rstrip("\r\n"))
