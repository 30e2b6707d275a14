"""What is wrong with an assembly text: where, what stands there, what was expected."""

from __future__ import annotations

MOST_ERRORS = 20
"""Errors of one text that are reported; what follows the twentieth mostly follows from the others."""

MOST_SAID = 500
"""Characters of a sentence: what is cited in it may be as long as the text."""

_MOST_SHOWN = 100
"""Characters of a line that are shown around an error."""


class AssemblyError(ValueError):
    """A text that is no assembly.

    line    where the trouble starts, counted from 1
    column  the same, counted from 1
    reason  one sentence: what stands there, what was expected, the near miss
    text    the line, as it was written
    others  what else is wrong with the text, in its order
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
        # A tab stays one, so that the mark stands below its character whatever a tab's width is.
        padding = "".join("\t" if character == "\t" else " " for character in before)
        return f"{shown}\n{padding}^"
