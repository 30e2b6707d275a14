"""Regular expressions for `matches`: Python's, without those that can take very long."""

from __future__ import annotations

import re
import warnings
from collections.abc import Callable

MOST_EXAMINED = 256
"""Number of characters of a text that are searched: more than any name or path on a brick has."""

MOST_OPEN = 2
"""Maximum number of unbounded repetitions (`*`, `+`, `{2,}`) and wide ones (`{0,256}`): each multiplies the time by
the length of the text."""

MOST_TIMES = 3
"""Maximum width of a range such as `{2,5}` that does not count as unbounded."""

MOST_CHOICES = 4
"""Maximum number of repetitions and groups of alternatives: each multiplies the time by its number of choices."""

_PIECE = re.compile(
    r"""(?P<reference>\\[1-9] | \(\?P= | \(\?\()
      | (?P<begin>\(\??) | (?P<end>\)) | (?P<other>\|)
      | (?P<times>(?P<open>[*+] | \{\d*,\}) | \? | \{(?P<least>\d*),(?P<most>\d+)\} | (?P<fixed>\{\d+\})) [?+]?
      | \\. | \[\^?\]?(?:\\.|[^\]\\])*\] | .""",
    re.VERBOSE | re.DOTALL,
)
_EXACT = "(?-i)"


class PatternError(ValueError):
    """An invalid pattern, or one that could take very long."""

    def __init__(self, position: int, reason: str) -> None:
        self.position = position  # index of the character where the error begins, from 0
        super().__init__(reason)


def compile_pattern(text: str) -> Callable[[str], bool]:
    """Compiles a pattern, which ignores case without `(?-i)`, to a search. Raises PatternError."""
    is_exact = text.startswith(_EXACT)
    begin = len(_EXACT) if is_exact else 0
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # FutureWarning for sets such as [[a]
            search = re.compile(text[begin:], re.DOTALL | (re.NOFLAG if is_exact else re.IGNORECASE)).search
    except (re.error, ValueError, OverflowError, RecursionError) as error:
        position = getattr(error, "pos", None) or 0
        raise PatternError(begin + position, f"not a regular expression: {getattr(error, 'msg', error)}") from None
    _refuse_slow(text, begin)
    return lambda examined: search(examined[:MOST_EXAMINED]) is not None


def _refuse_slow(text: str, begin: int) -> None:
    """Raises PatternError for a pattern that can match the same text in very many ways."""
    groups = [False]  # whether each open group can match in several ways
    repeats = False  # whether the group that has just ended can
    open_ended = choices = 0
    for found in _PIECE.finditer(text, begin):
        piece, after_many, repeats = found.lastgroup, repeats, False
        if piece == "reference":
            raise PatternError(
                found.start(), f"{found[0]} refers to a group, which can take very long; write the text out"
            )
        if piece == "begin":
            groups.append(False)
        elif piece == "end":
            repeats = groups.pop()
            groups[-1] |= repeats
        elif piece == "times" and after_many:
            reason = f"{found[0]} repeats a group with *, +, ?, {{ }} or | in it, which can take very long"
            raise PatternError(found.start(), reason)
        elif piece == "times" or (piece == "other" and not groups[-1]):
            more = int(found["most"] or 0) - int(found["least"] or 0)
            open_ended += found["open"] is not None or more > MOST_TIMES
            choices += found["fixed"] is None
        if open_ended > MOST_OPEN or choices > MOST_CHOICES:
            raise PatternError(
                found.start(),
                f"more than {MOST_OPEN} of * and +, or {MOST_CHOICES} of *, +, ?, {{ , }} and | can take very long;"
                " use like with * for any characters",
            )
        groups[-1] |= piece in ("times", "other")
