"""Regular expressions: what `matches` understands. They are Python's, but for those that can take ages."""

from __future__ import annotations

import re
import warnings
from collections.abc import Callable

MOST_EXAMINED = 256
"""Characters of a text in which a pattern is looked for: more than any name or path on a brick has."""

MOST_OPEN = 2
"""Repetitions without an end (`*`, `+`, `{2,}`) or nearly so (`{0,256}`) of a pattern: each multiplies the time by the
text's length."""

MOST_TIMES = 3
"""Times by which the ends of a repetition (`{2,5}`) may differ without counting as one that has no end."""

MOST_CHOICES = 4
"""Repetitions and groups of alternatives together that a pattern may have: each multiplies the time by its number."""

_PIECE = re.compile(
    r"""(?P<reference>\\[1-9] | \(\?P= | \(\?\()
      | (?P<begin>\(\??) | (?P<end>\)) | (?P<other>\|)
      | (?P<times>(?P<open>[*+] | \{\d*,\}) | \? | \{(?P<least>\d*),(?P<most>\d+)\} | (?P<fixed>\{\d+\})) [?+]?
      | \\. | \[\^?\]?(?:\\.|[^\]\\])*\] | .""",
    re.VERBOSE | re.DOTALL,
)
_EXACT = "(?-i)"


class PatternError(ValueError):
    """A text that is no pattern.

    position  of the character where the trouble starts; the first one is 0
    """

    def __init__(self, position: int, reason: str) -> None:
        self.position = position
        super().__init__(reason)


def compile_pattern(text: str) -> Callable[[str], bool]:
    """Makes the test whether a pattern is found in the first MOST_EXAMINED characters of a text, in any case.

    Args:
        text: A regular expression of Python's. `(?-i)` at its start makes the case of letters count.

    Raises:
        PatternError: The text is no pattern, or one that may take ages.
    """
    is_exact = text.startswith(_EXACT)
    begin = len(_EXACT) if is_exact else 0
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # sets such as [[a] may mean something else in a later Python
            search = re.compile(text[begin:], re.DOTALL | (re.NOFLAG if is_exact else re.IGNORECASE)).search
    except (re.error, ValueError, OverflowError, RecursionError) as error:
        position = getattr(error, "pos", None) or 0
        raise PatternError(begin + position, f"not a regular expression: {getattr(error, 'msg', error)}") from None
    _refuse_slow(text, begin)
    return lambda examined: search(examined[:MOST_EXAMINED]) is not None


def _refuse_slow(text: str, begin: int) -> None:
    """Raises PatternError for what makes Python try many ways through the same text."""
    groups = [False]  # whether each open group has something in it that can match in several ways
    repeats = False  # whether the group that ends just here has
    open_ended = choices = 0
    for found in _PIECE.finditer(text, begin):
        piece, after_many, repeats = found.lastgroup, repeats, False
        if piece == "reference":
            raise PatternError(found.start(), f"{found[0]} refers to a group, which may take ages: write it out")
        if piece == "begin":
            groups.append(False)
        elif piece == "end":
            repeats = groups.pop()
            groups[-1] |= repeats
        elif piece == "times" and after_many:
            reason = f"{found[0]} repeats a group with *, +, ?, {{ }} or | in it, which may take ages"
            raise PatternError(found.start(), reason)
        elif piece == "times" or (piece == "other" and not groups[-1]):
            more = int(found["most"] or 0) - int(found["least"] or 0)
            open_ended += found["open"] is not None or more > MOST_TIMES
            choices += found["fixed"] is None
        if open_ended > MOST_OPEN or choices > MOST_CHOICES:
            raise PatternError(
                found.start(),
                f"more than {MOST_OPEN} of * and +, or {MOST_CHOICES} of *, +, ?, {{ , }} and |, may take ages: like"
                " takes * for any characters",
            )
        groups[-1] |= piece in ("times", "other")
