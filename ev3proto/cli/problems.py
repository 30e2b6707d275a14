"""What cannot be read, on standard error, and the exit status that follows from it."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator
from typing import NoReturn, TypeAlias

from ev3proto.capture.record import Announcement, Record, Skipped
from ev3proto.checking.report import Severity
from ev3proto.cli.output import complain
from ev3proto.reading.items import Event, Image, Problem, ProblemCode, Source

Captured: TypeAlias = Record | Announcement | Skipped
Other: TypeAlias = Captured | Image | Source


class Problems:
    """Prints problems, and remembers whether any of them was an error.

    errors   the number of errors
    ignored  codes that are neither printed nor count
    """

    def __init__(self, *ignored: ProblemCode, heard: Callable[[str], object] = lambda _: None) -> None:
        """`heard` is called with the sentence of each error."""
        self.errors = 0
        self._ignored = ignored
        self._heard = heard

    def beside(self, events: Iterable[Event]) -> Iterator[Other]:
        """Yields what is read, and prints the problems among it."""
        for event in events:
            if isinstance(event, Problem):
                self.show(event)
            else:
                yield event

    def captured(self, events: Iterable[Event]) -> Iterator[Captured]:
        """Yields what is in captures and logs, in the same way."""
        return (event for event in self.beside(events) if not isinstance(event, Image | Source))

    def show(self, problem: Problem) -> None:
        """Prints a problem, with the line of a source that it is about."""
        if problem.code in self._ignored:
            return
        complain(str(problem))
        if problem.excerpt:
            complain("\n".join(f"  {line}" for line in problem.excerpt.split("\n")))
        if problem.severity is Severity.ERROR:
            self._heard(str(problem))
            self.errors += 1

    def records(self, events: Iterable[Event]) -> Iterator[Record]:
        """Yields the records, in the same way."""
        return (event for event in self.beside(events) if isinstance(event, Record))

    def wrong(self, sentence: str) -> None:
        """Prints an error in what was read."""
        complain(sentence)
        self._heard(sentence)
        self.errors += 1

    def end_without(self, sentence: str) -> NoReturn:
        """Ends the program because nothing was found, and says so unless an error was printed."""
        if not self.errors:
            complain(sentence)
        sys.exit(1)

    @property
    def status(self) -> int:
        """The exit status."""
        return min(self.errors, 1)
