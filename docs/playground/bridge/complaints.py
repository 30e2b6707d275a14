"""What cannot be read of an input, in sentences."""

from __future__ import annotations

from ev3proto.reading.items import Problem, ProblemCode
from ev3proto.text.spans import visible

MOST_COMPLAINTS = 12
"""Maximum lines of errors."""


class Complaints:
    """The problems of an input; the first ones are shown.

    count  the number of all
    shown  the first ones
    """

    def __init__(self) -> None:
        self.count = 0
        self.shown: list[Problem] = []

    def add(self, problem: Problem) -> None:
        """Takes a problem."""
        self.count += 1
        if len(self.shown) < MOST_COMPLAINTS:
            self.shown.append(problem)

    @property
    def is_of_source(self) -> bool:
        """Whether the input is a source with mistakes."""
        return any(problem.code is ProblemCode.SOURCE for problem in self.shown)

    def text(self) -> str:
        """Returns the sentences, with the lines of a source that they are about."""
        lines: list[str] = []
        for problem in self.shown:
            lines += [str(problem), *(f"  {line}" for line in problem.excerpt.split("\n") if problem.excerpt)]
        left = self.count - len(self.shown) + max(len(lines) - MOST_COMPLAINTS, 0)
        shown = [*lines[:MOST_COMPLAINTS], *([f"... and {left} more lines"] if left else [])]
        return "".join(f"{visible(line)}\n" for line in shown)
