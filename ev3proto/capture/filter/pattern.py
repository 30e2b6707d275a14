r"""Regular expressions that take no ages: what `matches` understands.

Python's own engine tries one way through a pattern after the other, and `(a+)+$` makes it try for years. This one goes
all ways at the same time, one character of the text after the other, so its time is the product of the two lengths.
What stands for a single character (`x`, `.`, `[a-f]`, `\d`) is still left to Python.
"""

from __future__ import annotations

import re
import warnings
from collections.abc import Callable
from functools import lru_cache
from typing import NamedTuple

MOST_STEPS = 500
"""Steps that a pattern may have; `x{9}` has nine."""

MAX_DEPTH = 30
"""How deep groups may stand in each other."""

_REMEMBERED = 1024
"""Texts whose answer is remembered: addresses and names come again and again."""


class PatternError(ValueError):
    """A text that is no pattern.

    position  of the character where the trouble starts; the first one is 0
    """

    def __init__(self, position: int, reason: str) -> None:
        self.position = position
        super().__init__(reason)


def compile_pattern(text: str) -> Callable[[str], bool]:
    r"""Makes the test whether a pattern is found anywhere in a text, in any case of its letters.

    Args:
        text: A regular expression: `.` `[a-z]` `[^a]` `\d \w \s \D \W \S` `\.` `\x41`, `^ $ \b \B`, `( | )`, `(?: )`,
            `* + ? {2} {2,} {2,5}`. `(?-i)` at its start makes the case of letters count.

    Returns:
        The test.

    Raises:
        PatternError: The text is no pattern, or has what makes other engines slow.
    """
    ignores_case = not text.startswith(_EXACT)
    start = 0 if ignores_case else len(_EXACT)
    program = _Compiler(text, re.IGNORECASE if ignores_case else re.NOFLAG).program(start)

    @lru_cache(_REMEMBERED)
    def found(examined: str) -> bool:
        return _found(program, examined)

    return found


_EXACT = "(?-i)"


class _Step(NamedTuple):
    """One step of a pattern.

    character  the test of the character that has to come next, or None
    place      the test of the place between two characters, or None
    next       the numbers of the steps that may follow; none: the pattern was found
    """

    character: Callable[[str], object] | None
    place: Callable[[str, int], bool] | None
    next: tuple[int, ...]


def _found(program: list[_Step], text: str) -> bool:
    alive: set[int] = set()
    for at in range(len(text) + 1):
        reached: set[int] = set()
        waiting = [0, *alive]
        while waiting:
            number = waiting.pop()
            if number in reached:
                continue
            reached.add(number)
            step = program[number]
            if step.character is None and (step.place is None or step.place(text, at)):
                if not step.next:
                    return True
                waiting += step.next
        character = text[at : at + 1]
        alive = {
            program[number].next[0]
            for number in reached
            if (test := program[number].character) is not None and character and test(character)
        }
    return False


# Places


def _is_word(character: str) -> bool:
    return character.isalnum() or character == "_"


def _is_border(text: str, at: int) -> bool:
    before, after = text[at - 1 : at] if at else "", text[at : at + 1]
    return _is_word(before) != _is_word(after)


_PLACES: dict[str, Callable[[str, int], bool]] = {
    "^": lambda _, at: at == 0,
    "$": lambda text, at: at == len(text),
    "\\b": _is_border,
    "\\B": lambda text, at: not _is_border(text, at),
}

# From the text to the steps

_CHARACTER = re.compile(
    r"\\x[0-9A-Fa-f]{2}|\\[dwsDWSnrtfv]|\\[^A-Za-z0-9]|\[\^?\]?(?:\\.|[^\]\\])*\]|[^\\\[(){}|*+?]", re.DOTALL
)
_TIMES = re.compile(r"([*+?])|\{(\d{1,3})(?:(,)(\d{0,3}))?\}")

_Build = Callable[[int], int]
"""Adds a part of the pattern to the steps, given the number of what follows it; returns where it starts."""


class _Compiler:
    """Reads a pattern from its start to its end. Steps are added from the end to the start."""

    def __init__(self, text: str, flags: re.RegexFlag) -> None:
        self._text = text
        self._flags = flags
        self._at = 0
        self._steps: list[_Step] = []

    def program(self, start: int) -> list[_Step]:
        """The steps, the first of which is number 0."""
        self._at = start
        build = self._choice(0)
        if self._at < len(self._text):
            raise PatternError(self._at, ") stands here, and there is no ( for it")
        self._steps = [_Step(None, None, ())]
        end = self._add(_Step(None, None, ()))
        self._steps[0] = _Step(None, None, (build(end),))
        return self._steps

    def _add(self, step: _Step) -> int:
        if len(self._steps) > MOST_STEPS:
            raise PatternError(
                0, f"the pattern has more than {MOST_STEPS} steps: use a shorter one, or smaller numbers in {{ }}"
            )
        self._steps.append(step)
        return len(self._steps) - 1

    def _choice(self, depth: int) -> _Build:
        if depth > MAX_DEPTH:
            raise PatternError(self._at, f"the groups stand in each other more than {MAX_DEPTH} deep")
        runs = [self._run(depth)]
        while self._text.startswith("|", self._at):
            self._at += 1
            runs.append(self._run(depth))
        if len(runs) == 1:
            return runs[0]
        return lambda after: self._add(_Step(None, None, tuple(run(after) for run in runs)))

    def _run(self, depth: int) -> _Build:
        parts: list[_Build] = []
        while self._at < len(self._text) and self._text[self._at] not in "|)":
            part = self._part(depth)
            parts.append(self._repeated(part))

        def build(after: int) -> int:
            for part in reversed(parts):
                after = part(after)
            return after

        return build

    def _part(self, depth: int) -> _Build:
        start = self._at
        for written, place in _PLACES.items():
            if self._text.startswith(written, start):
                self._at += len(written)
                return lambda after: self._add(_Step(None, place, (after,)))
        if self._text[start] == "(":
            return self._group(depth)
        found = _CHARACTER.match(self._text, start)
        if found is None:
            raise PatternError(start, self._trouble(start))
        self._at = found.end()
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # sets such as [[a] may mean something else in a later Python
                test = re.compile(found[0], self._flags | re.DOTALL).fullmatch
        except re.error as error:
            raise PatternError(start, f"{found[0]} is no set of characters: {error.msg}") from None
        return lambda after: self._add(_Step(test, None, (after,)))

    def _group(self, depth: int) -> _Build:
        start = self._at
        self._at += 3 if self._text.startswith("(?:", start) else 1
        if self._text.startswith("?", self._at):
            raise PatternError(start, "groups must be ( ) or (?: ), and (?-i) can stand at the start only")
        build = self._choice(depth + 1)
        if not self._text.startswith(")", self._at):
            raise PatternError(start, "the group that starts here has no ) at its end")
        self._at += 1
        return build

    def _repeated(self, part: _Build) -> _Build:
        found = _TIMES.match(self._text, self._at)
        if found is None:
            return part
        start, self._at = self._at, found.end()
        least, most = _limits(found)
        if most is not None and most < least:
            raise PatternError(start, f"{found[0]} has its larger number first")
        if _TIMES.match(self._text, self._at) is not None and self._text[self._at] != "?":
            raise PatternError(self._at, "two numbers of repetitions stand side by side: put ( ) around the first")
        if self._text.startswith("?", self._at):
            self._at += 1  # as few as possible: which is found all the same
        return lambda after: self._copies(part, least, most, after)

    def _copies(self, part: _Build, least: int, most: int | None, after: int) -> int:
        if most is None:
            loop = self._add(_Step(None, None, (after,)))
            self._steps[loop] = _Step(None, None, (part(loop), after))
            after = loop
        else:
            end = after
            for _ in range(most - least):
                after = self._add(_Step(None, None, (part(after), end)))
        for _ in range(least):
            before, after = after, part(after)
            if after == before:
                break  # the part is empty, and so are all of its copies
        return after

    def _trouble(self, at: int) -> str:
        sign = self._text[at]
        if sign == "[":
            return "the set that starts here has no ] at its end"
        if sign == "\\":
            written = self._text[at : at + 2]
            return f"{written} must be one of \\d \\w \\s \\b \\D \\W \\S \\B, \\x41, or a sign such as \\. for itself"
        return f"{sign} repeats what stands before it, and nothing does; \\{sign} is the sign itself"


def _limits(found: re.Match[str]) -> tuple[int, int | None]:
    """How often something stands there: at least, and at most (None: any number of times)."""
    if found[1]:
        return {"*": (0, None), "+": (1, None), "?": (0, 1)}[found[1]]
    least = int(found[2])
    if not found[3]:
        return least, least
    return least, int(found[4]) if found[4] else None
