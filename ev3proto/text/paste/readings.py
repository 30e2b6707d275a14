"""Which bytes the values of a run are, in each reading that they may have, and the frames in these bytes.

A frame may begin and end where the run does, and where the way of separating its values changes: at its edges.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

from ev3proto.schema.header import with_length
from ev3proto.tables.frame import LENGTH_FIELD
from ev3proto.text.paste.frames import (
    HASHES,
    LOOKS,
    Frame,
    frame_end,
    frames_in,
    fronts,
    is_command,
    is_echo,
    is_fine_so_far,
    is_flawless,
    is_sure,
)
from ev3proto.text.paste.notations import NUMBERS, STRINGS, Notation, end_of_bytes, values_in
from ev3proto.text.paste.pieces import LEAST
from ev3proto.text.paste.values import EXPRESSION, READINGS, UNLIKELY, WIDTH, joined, unknown_bytes

_MANY_MARKS = 4
_ALPHANUMERIC = frozenset(filter(str.isalnum, map(chr, range(128))))


class Run:
    """Consecutive values in a line: their texts, and where they are."""

    check_sum: int | None = None

    def __init__(self, notation: Notation, line: str, start: int, end: int, number: int = 0) -> None:
        self.notation, self.line, self.start, self.number = notation, line, start, number
        self.end = end_of_bytes(line, start, end) if notation is NUMBERS else end
        self.take(values_in(notation, line, start, self.end))

    def take(self, tokens: list[str]) -> None:
        """Sets the values, and by them the readings they may have."""
        self.tokens = tokens
        self.widths = frozenset(map(WIDTH.__getitem__, tokens)) if self.notation is NUMBERS else frozenset()
        self.names = self.notation.readings(tokens, self.widths) if tokens else ()
        if self.unknown and sum(map(sum, map(unknown_bytes, tokens))) * 2 >= sum(map(len, tokens)) // 2:
            # Too little of it is known.
            self.names = ()
        self._data: dict[str, bytes | None] = {}
        self._readings: list[Reading] | None = None

    def data(self, name: str) -> bytes | None:
        """Returns the bytes of all values in a reading; None where one has none."""
        if name not in self._data:
            data = joined(self.tokens, name)
            if (
                data is not None
                and self.unknown
                and self.tokens[0] != EXPRESSION
                and any(unknown_bytes(self.tokens[0])[:1])
            ):
                # An unknown length is the one that fits.
                data = with_length(data[LENGTH_FIELD:])
            self._data[name] = data
        return self._data[name]

    def likely_data(self) -> bytes | None:
        """Returns the bytes in the likeliest reading that gives bytes for all values."""
        return next((data for name in self.names if (data := self.data(name)) is not None), None)

    @cached_property
    def spans(self) -> list[tuple[int, int]]:
        """The columns of each value."""
        return [found.span(1) for found in self.notation.value.finditer(self.line, self.start, self.end)]

    def only(self, places: Sequence[int]) -> Run:
        """Returns some of the values as a run, whatever is between them."""
        spans, run = self.spans, Run(self.notation, "", 0, 0, self.number)
        run.line = self.line
        run.take([self.tokens[place] for place in places])
        run.spans = [spans[place] for place in places]
        run.start, run.end, run.edges = run.spans[0][0], run.spans[-1][1], frozenset()
        return run

    @cached_property
    def edges(self) -> frozenset[int]:
        """The values in front of which a frame may begin: what separates them there is not what does elsewhere."""
        spans = self.spans
        gaps = [self.line[end:start] for (_, end), (start, _) in pairwise(spans)]
        if len({*gaps}) < 2 and len({*map(len, self.tokens)}) < 2 and self.notation is not STRINGS:
            return frozenset()
        if self.notation is STRINGS:
            return frozenset(place for place, gap in enumerate(gaps, 1) if "," in gap)
        kinds = ["".join(gap.replace("0x|", "|").split()).replace("|", ":") or " " * (gap != "") for gap in gaps]
        usual = Counter(kinds).most_common(1)[0][0] if kinds else ""
        widths = [WIDTH[token] for token in self.tokens]
        return frozenset(
            place
            for place, kind in enumerate(kinds, 1)
            if kind != usual
            or (widths[place - 1] > 0) != (widths[place] > 0)
            or (min(widths[place - 1 : place + 1]) < LEAST <= max(widths[place - 1 : place + 1]) // 2)
        )

    @property
    def readings(self) -> list[Reading]:
        """The readings, the one worth most first."""
        if self._readings is None:
            self._readings = _tried(self)
        return self._readings

    @property
    def unknown(self) -> bool:
        """Whether some of its bytes are unknown."""
        return -1 in self.widths

    @property
    def may_have_expressions(self) -> bool:
        """Whether its expressions may be bytes of a frame: few of them, and none in its length and its type."""
        is_header = EXPRESSION not in (*self.tokens[:2], *self.tokens[4:5])
        return is_header and 0 < self.tokens.count(EXPRESSION) * 2 < len(self.tokens)

    @property
    def starts_with_name(self) -> bool:
        """Whether its first value is a name such as `opSOUND`, with which no frame begins."""
        return self.notation is NUMBERS and self.tokens[0][:1].isalpha() and not WIDTH[self.tokens[0]]

    @property
    def is_row(self) -> bool:
        """Whether nothing else is in the line, as in the row of a dump."""
        return len(self.tokens) > 1 and not (self.line[: self.start] + self.line[self.end :]).strip()

    @property
    def is_long(self) -> bool:
        """Whether it may have as many bytes as a frame."""
        return len(self.tokens) >= LEAST or sum(map(len, self.tokens)) >= 2 * LEAST

    @cached_property
    def marks(self) -> int:
        """How many characters separate its values; a blank after a comma does not count."""
        return len({*self.line[self.start : self.end].replace(", ", ",")} - _ALPHANUMERIC)

    def place(self, index: int) -> tuple[int, int, int]:
        """Returns the line of a value, the column where it begins and that after it."""
        if index == 0 and len(self.tokens) == 1:
            return self.number, self.start, self.end
        return self.number, *self.spans[index]


class Rows(Run):
    """The values of several lines."""

    def __init__(self, runs: list[Run], *, is_array: bool) -> None:
        super().__init__(runs[0].notation, "", 0, 0)
        tokens, self._runs, starts = list[str](), runs, list[int]()
        for run in runs:
            starts.append(len(tokens))
            tokens += run.tokens
        self.take(tokens)
        self._starts, self.check_sum = starts, runs[-1].check_sum
        self.edges = frozenset() if is_array else frozenset(starts[1:])

    def place(self, index: int) -> tuple[int, int, int]:
        """Returns the line of a value, the column where it begins and that after it."""
        row = max(row for row, start in enumerate(self._starts) if start <= index)
        return self._runs[row].place(index - self._starts[row])


def runs_in(
    line: str, number: int = 0, notations: Sequence[Notation] = (STRINGS, NUMBERS), least: int = 1
) -> list[Run]:
    """Returns the runs in a line.

    Args:
        line: The line, without what is not a value.
        number: Its number.
        notations: The notations that are looked for; strings only where a backslash is.
        least: The fewest characters of a run.
    """
    return [
        Run(notation, line, *found.span("run"), number)
        for notation in notations
        if notation is not STRINGS or "\\" in line
        for found in notation.run.finditer(line)
        if found["run"] and found.end() - found.start() >= least
    ]


class Part(NamedTuple):
    """Values that a reading gives bytes for: the first, the one after the last, their bytes, the frames in these."""

    name: str
    first: int
    last: int
    data: bytes
    frames: list[Frame]

    def owners(self, run: Run) -> Sequence[int]:
        """Returns the value that each byte belongs to."""
        if len(self.data) == self.last - self.first:
            return range(self.first, self.last)
        if self.name == "base64":
            return [min(self.first + offset, self.last - 1) for offset in range(len(self.data))]
        table = READINGS[self.name]
        return [at for at in range(self.first, self.last) for _ in table[run.tokens[at]] or b""]


class Reading(NamedTuple):
    """A reading of a run.

    parts        its bytes, and the frames in them
    is_whole     frames are all of the run, but for padding
    is_complete  every value of the run has bytes
    """

    parts: list[Part]
    is_whole: bool
    is_complete: bool

    @property
    def frames(self) -> list[tuple[Part, Frame]]:
        """The frames of all parts."""
        return [(part, frame) for part in self.parts for frame in part.frames]

    @property
    def has_frames(self) -> bool:
        """Whether there are any."""
        return any(part.frames for part in self.parts)

    @property
    def has_rest(self) -> bool:
        """Whether other bytes than padding follow the last frame."""
        return any(any(part.data[frame.end : frame.stop]) for part, frame in self.frames)

    @property
    def ends_within(self) -> bool:
        """Whether other bytes than padding follow its only frame."""
        return len(self.frames) == 1 and any(any(part.data[frame.end :]) for part, frame in self.frames)

    @property
    def worth(self) -> tuple[bool, int, bool, int]:
        """What tells the likelier of two readings: whether its frames are all, their bytes, whether it is complete."""
        natural = sum(frame.end - frame.start for _, frame in self.frames if frame.is_natural)
        return self.is_whole, natural, self.is_complete, sum(frame.end - frame.start for _, frame in self.frames)

    @property
    def breaks_off(self) -> bool:
        """Whether the next lines may have the end of a frame, whose length is too small."""
        frames = (part.data[frame.start : frame.end] for part, frame in self.frames)
        return any(is_fine_so_far(frame) and not is_flawless(frame) for frame in frames)

    @property
    def is_flawless(self) -> bool:
        """Whether none of its frames has a flaw."""
        return all(is_flawless(part.data[frame.start : frame.end]) for part, frame in self.frames)


def _tried(run: Run) -> list[Reading]:
    """Returns the readings of a run that were tried, the one worth most first; among equals one without a flaw."""
    if (all_of_it := whole(run)) is not None:
        return [Reading([all_of_it], True, True)]
    found: list[Reading] = []
    for name in run.names:
        if name in UNLIKELY and run.data(name) is None:
            continue
        found.append(one := _reading(run, name))
        if one.is_whole and (name in ("hex", "string") or one.is_flawless):
            # No other reading is worth more.
            return [one, *found[:-1]]
    if not found:
        return [Reading([], False, False)]
    most = max(one.worth for one in found)
    equals = [one for one in found if one.worth == most]
    best = next((one for one in equals if len(equals) > 1 and most[3] and one.is_flawless), equals[0])
    return sorted(found, key=lambda one: one is not best)


def whole(run: Run) -> Part | None:
    """Returns all of a run as one frame, in the likeliest reading that makes it one; None where none does."""
    found: list[Part] = []
    for name in run.names:
        data = run.data(name)
        if data is not None and frame_end(data, 0) == len(data):
            part = Part(name, 0, len(run.tokens), data, [Frame(0, len(data), len(data), True)])
            if _is_likely(run, part, is_whole=True):
                found.append(part)
                if name in ("hex", "string"):
                    break
    sure = (part for part in found if len(found) == 1 or part.name in ("hex", "string") or is_flawless(part.data))
    return next(sure, found[0]) if found else None


def _reading(run: Run, name: str) -> Reading:
    data = run.data(name)
    spans = [(0, len(run.tokens), data)] if data is not None else _parts(run.tokens, name)
    parts: list[Part] = []
    is_whole = False
    for first, last, content in spans:
        part, is_all = _frames(run, Part(name, first, last, content, []), is_complete=data is not None)
        parts.append(part)
        is_whole = is_whole or is_all
    return Reading(parts, is_whole, data is not None)


def _parts(tokens: list[str], name: str) -> Iterator[tuple[int, int, bytes]]:
    """Yields the parts of a run between the values that a reading gives no bytes for."""
    found = list(map(READINGS[name].__getitem__, tokens))
    ends = [place for place, data in enumerate(found) if data is None]
    for first, last in pairwise((-1, *ends, len(tokens))):
        data = b"".join(found[first + 1 : last])  # type: ignore[arg-type]
        if len(data) >= LEAST:
            yield first + 1, last, data


def _edges(run: Run, part: Part) -> Callable[[], tuple[set[int], set[int]]]:
    """Returns a function for the offsets at which frames may naturally start and end in the bytes of a part."""

    def edges() -> tuple[set[int], set[int]]:
        places, size = part.owners(run), len(part.data)
        starts = (
            {at for at in range(1, size) if places[at] in run.edges and places[at] != places[at - 1]}
            if run.edges
            else set[int]()
        )
        ends = {*starts}
        # Where a value has no bytes in this reading, there is no edge.
        starts |= {0} if part.first == 0 or part.first in run.edges else set()
        ends |= {size} if part.last == len(run.tokens) or part.last in run.edges else set()
        if run.notation is STRINGS and run.tokens and run.tokens[0].lstrip("bu")[1:2] != "\\":
            starts.add(1)
        if part.name.endswith("words") or (run.check_sum is not None and part.data[-1:] == bytes((run.check_sum,))):
            # A dump in words has an even number of bytes; a check sum follows.
            ends.add(size - 1)
        return starts, ends

    return edges


def starts_of(run: Run, part: Part) -> list[int]:
    """Returns the offsets at which frames may naturally start."""
    starts = _edges(run, part)()[0]
    return sorted(starts | (fronts(part.data) if 0 in starts else set()))


def _frames(run: Run, part: Part, *, is_complete: bool) -> tuple[Part, bool]:
    """Returns a part with its frames, and whether they are all of the run."""
    name, data = part.name, part.data
    if len(data) < LEAST:
        return part, False
    found = frames_in(data, _edges(run, part), is_front=name != "base64")
    if not found:
        return part, False
    is_padded = not any(data[found[-1].end :])
    is_whole = is_complete and is_padded and sum(frame.end - frame.start for frame in found) == found[-1].end
    if not is_whole and name == "base64":
        return part, False
    found = [frame for frame in found if _is_likely(run, part._replace(frames=[frame]), is_whole=is_whole)]
    return part._replace(frames=found), is_whole and bool(found)


def _is_likely(run: Run, part: Part, *, is_whole: bool) -> bool:
    """Returns whether a frame is meant as one, be it all of a run or among other values."""
    (frame,), data, tokens = part.frames, part.data, run.tokens
    content = data[frame.start : frame.end]
    if part.name in UNLIKELY and not is_flawless(content):
        return False
    if not is_whole and any(data[frame.end : frame.stop]):
        # Numbers that happen to begin like a frame are many; a report has two digits for each byte.
        is_bare = run.notation is NUMBERS and 0 not in run.widths and (part.name != "hex" or bool({1, 3} & run.widths))
        if is_bare and not is_echo(content) and not (is_command(content) and is_sure(content)):
            return False
    if 0 in run.widths and any(data[frame.end :]) and frame_end(data, frame.end) is None and not is_flawless(content):
        # The rest of an array: the length is too small.
        return False
    if not is_whole and len(tokens) == 1 and len(data) in HASHES:
        return frame.start == 0 and is_command(content) and is_sure(content)
    if run.notation is not NUMBERS or len(tokens) == 1:
        return True
    if {1, 3} & run.widths and run.marks >= (_MANY_MARKS if is_whole else 2):
        # Unpadded numbers with all kinds of marks between them, as in expressions and drawings.
        return frame.end - frame.start >= LOOKS and is_sure(data[frame.start : frame.end])
    return True
