"""Values between which the same words stand every time: `buf.put(0x0f); buf.put(0x00);`, `<td>0f</td><td>00</td>`.

What stands between two values is no gap that bytes usually have. That it comes again, and that the length field fits
what stands between, tells that the values belong together.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from itertools import islice

from ev3proto.tables.frame import MAX_FRAME
from ev3proto.text.late_pattern import late_pattern
from ev3proto.text.paste.pieces import LEAST
from ev3proto.text.paste.values import Run, Style, Value

_VALUE = late_pattern(r"(?<![0-9A-Za-z_.])(?P<mark>0[xX]|&[hH]|\$)?(?P<digits>[0-9a-fA-F]{1,3})(?![0-9A-Za-z_])")
_FOLLOWING = late_pattern(_VALUE.pattern.removeprefix("(?<![0-9A-Za-z_.])"))
_USUAL = late_pattern(r"[\s,;:|]*")
_MOST_STARTS = 12
_MOST_BETWEEN = 3
_MOST_GAP = 48
_MOST_TRIES = 2
_MOST_VALUES = 2 * MAX_FRAME


def rhythmic_runs(line: str) -> Iterator[Run]:
    """The runs that a line has if the same words between values are a gap, the longest gaps last.

    Args:
        line: A line that was cleaned.

    Yields:
        Runs of at least five values. They may overlap: the one that is a frame is meant.
    """
    first = list(islice(_VALUE.finditer(line), _MOST_STARTS))
    tried = Counter[str]()
    for index, start in enumerate(first):
        for following in first[index + 1 : index + 1 + _MOST_BETWEEN]:
            gap = line[start.end() : following.start()]
            tried[gap] += 1
            if len(gap) > _MOST_GAP or tried[gap] > _MOST_TRIES or _USUAL.fullmatch(gap) is not None:
                continue
            found = list(islice(_values(line, start.start(), gap), _MOST_VALUES))
            if len(found) >= LEAST:
                yield Run(found, ["", *["="] * (len(found) - 1)])


def _values(line: str, at: int, gap: str) -> Iterator[Value]:
    """The values from a column on, as long as the gap stands between them."""
    while (found := _FOLLOWING.match(line, at)) is not None:
        digits = found["digits"]
        if found["mark"]:
            yield Value(found.start(), found.end(), Style.MARKED, digits, bytes((int(digits, 16) & 0xFF,)))
        else:
            yield Value(found.start(), found.end(), Style.BARE, digits)
        if not line.startswith(gap, found.end()):
            return
        at = found.end() + len(gap)
