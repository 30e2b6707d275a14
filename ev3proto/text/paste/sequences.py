"""Sequences of values, and the frames in them: which of the values are bytes, in which base, and what is likeliest.

Nothing here knows a notation. The values of a line are tried in several ways, all of them, every second, every third;
those of consecutive lines are lined up. Each sequence is tried in each base. What has the frames wins (`Worth`).
"""

from __future__ import annotations

import re
from bisect import bisect_left, bisect_right
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cached_property, lru_cache, partial
from itertools import accumulate, pairwise
from typing import NamedTuple

from ev3proto.schema.frame import is_flawless
from ev3proto.schema.header import with_length
from ev3proto.semantics.identify import is_sure
from ev3proto.tables.frame import LENGTH_FIELD
from ev3proto.text.paste.frames import Edges, FrameSpan, frames_in, has_place, is_command
from ev3proto.text.paste.pieces import LEAST
from ev3proto.text.paste.tokens import BYTES, UNLIKELY, Token, unknown_bytes

_CALL = re.compile(r"[\w.]+\s?\(|\)")
_NO_MATTER = str.maketrans("", "", ":|+")
_SAYS = re.compile(r"(?<!\s):\s")
"""What is in front of a colon and a blank tells about what is behind them: `Length 8: 06 00`."""
_LITERAL = re.compile(r"(?:0[xX]|[xX]'|\\x)[0-9a-fA-F]{10}")
_QUOTES = re.compile(r"[\"'`,]")
_OPENING = re.compile(r"^[^+;]*[\[{(<]\W*$")
_BESIDE = re.compile(r"[ \t]|,[ \t]?")
"""What is between bytes in one line; more blanks are in front of a column of text."""
_DECIMAL_ESCAPE = re.compile(r"\\\d{0,2}[89]")
_FEW = 2
_LEAST_APART = 4
"""Digits that may be more than a byte."""
_WIDE = 7
"""Blanks that separate columns, not values."""


@lru_cache(1024)
def shape(gap: str) -> str:
    """Returns what matters of a gap: not its few blanks, nor a call, nor which of its two signs the lesson uses."""
    plain = "".join(_CALL.sub("", _SAYS.sub("=", gap)).split()).replace("0x|", "").translate(_NO_MATTER)
    return f"{plain} " if " " * _WIDE in gap else plain


def _length(token: Token) -> int:
    """Returns the digits of a value; 0 for what says itself what it is, but for a literal of many bytes."""
    return len(token.text) if token.kind == "digits" or _LITERAL.match(token.text) else 0


class Part(NamedTuple):
    """Values of a sequence that all have bytes in a base.

    first    the place of the first value
    data     their bytes
    offsets  where each value begins, and where the last one ends
    frames   the frames in them
    """

    first: int
    data: bytes
    offsets: list[int]
    frames: list[FrameSpan]

    @property
    def last(self) -> int:
        """The place after the last value."""
        return self.first + len(self.offsets) - 1


def within(places: list[int], part: Part) -> list[int]:
    """Returns those of some places that are inside a part."""
    return places[bisect_right(places, part.first) : bisect_left(places, part.last)]


class Values:
    """A sequence of values, with what the text says of their places.

    Attributes:
        tokens: The values.
        bases: The bases that they may have, the likeliest first.
        rows: The places of the values that begin a line, but for the first.
        is_guess: Some values of the lines are left out, so that only what is surely a frame counts.
        widths: The digits of each value; 0 for those that say themselves what they are.
        has_unknown: Some of their bytes are not given.
        is_mixed: Some are strings, and some bare digits, which hardly belong to them.
    """

    def __init__(
        self,
        tokens: Sequence[Token],
        *,
        bases: Sequence[str] | None = None,
        rows: frozenset[int] = frozenset(),
        is_guess: bool = False,
    ) -> None:
        self.tokens, self.rows, self.is_guess = tokens, rows, is_guess
        self.widths = [len(token.text) if token.kind == "digits" else 0 for token in tokens]
        kinds = {token.kind for token in tokens}
        self.has_unknown = "unknown" in kinds
        self.is_mixed = "string" in kinds and any(self.widths)
        self.bases = _bases(tokens, kinds) if bases is None else bases

    @cached_property
    def breaks(self) -> list[int]:
        """The places of the values in front of which something changes: the usual gap, or how values are written."""
        shapes = [shape(token.gap) for token in self.tokens]
        strings = [token.kind == "string" for token in self.tokens]
        usual, count = Counter(shapes[1:]).most_common(1)[0] if len(shapes) > 1 else ("", 0)
        if count == 1 and (len(shapes) > 2 or any(strings) or len(usual) > 1):
            usual = ""
        lengths = [*map(_length, self.tokens)]
        longest = max(lengths)
        is_uniform = not any(strings) and (longest < _LEAST_APART or (longest < 2 * LEAST and len({*lengths}) == 1))
        return [
            place
            for place in range(1, len(shapes))
            if place not in self.rows
            and (shapes[place] != usual or (not is_uniform and self._changes(place, *lengths[place - 1 : place + 1])))
        ]

    def _changes(self, place: int, last: int, width: int) -> bool:
        """Returns whether a value is hardly of one kind with the one in front of it: a string, an offset, a literal."""
        first, second = self.tokens[place - 1 : place + 1]
        if (first.kind == "string") != (second.kind == "string"):
            return True
        is_offset = place == 1 and last >= max(_LEAST_APART, width + 1) and width > 0
        is_literal = min(last, width) >= 2 * LEAST and _QUOTES.search(second.gap) is not None
        return is_offset or is_literal or min(last, width) < LEAST <= max(last, width) // 2

    @cached_property
    def opens(self) -> list[int]:
        """The places of the values in front of which a list opens, or something else behind a string."""
        return [
            place
            for place in self.breaks
            if _OPENING.search(_CALL.sub("", self.tokens[place].gap))
            or (self.is_mixed and self.tokens[place - 1].kind == "string" and "(" not in self.tokens[place].gap)
        ]

    def parts(self, base: str) -> Iterator[Part]:
        """Yields the values that have bytes in a base, from each that has none to the next."""
        table = BYTES[base]
        found = [table[token.text] for token in self.tokens]
        ends = [place for place, data in enumerate(found) if data is None] if None in found else []
        for before, end in pairwise((-1, *ends, len(found))):
            values = found[before + 1 : end]
            data = b"".join(values)  # type: ignore[arg-type]
            if self.has_unknown and len(data) > LENGTH_FIELD and unknown_bytes(self.tokens[before + 1])[:1] == [True]:
                data = with_length(data[LENGTH_FIELD:])  # an unknown length is the one that fits
            if not data:
                continue
            if not self.has_unknown or any(
                not all(unknown_bytes(token) or [False]) for token in self.tokens[before + 1 : end]
            ):
                yield Part(before + 1, data, [0, *accumulate(map(len, values))], [])  # type: ignore[arg-type]

    def is_torn(self, part: Part) -> tuple[bool, bool]:
        """Returns whether the values before and behind a part are written like those in it, but have no bytes."""
        before, after = part.first - 1, part.last
        return (
            before >= 0 and self.widths[before] > 0 and not has_place(self.breaks, part.first),
            after < len(self.tokens) and self.widths[after] > 0 and not has_place(self.breaks, after),
        )

    def edges(self, part: Part) -> Edges:
        """Returns where frames may begin and end in a part."""
        breaks, opens = (
            [part.offsets[place - part.first] for place in within(places, part)] for places in (self.breaks, self.opens)
        )
        return Edges(breaks, part.offsets, opens, self.is_torn(part))

    def is_rest(self, part: Part, start: int) -> bool:
        """Returns whether the values from some byte on are the last, with a blank or a comma in front of each."""
        rest = self.tokens[part.first + bisect_left(part.offsets, start) : part.last]
        is_bare = all(
            token.kind in ("digits", "marked") and _BESIDE.fullmatch(token.gap) and len(token.text) % 2 == 0
            for token in rest
        )
        return is_bare and part.last == len(self.tokens)

    def row_offsets(self, part: Part) -> set[int]:
        """Returns the offsets of the values that begin a line."""
        if not self.rows:
            return set()
        return {part.offsets[place - part.first] for place in self.rows if part.first < place < part.last}

    def between_breaks(self, part: Part) -> Iterator[tuple[int, int]]:
        """Yields where the bytes between two breaks begin and end."""
        places = pairwise((0, *self.edges(part).breaks, len(part.data)))
        return ((start, end) for start, end in places if start < end)

    def span(self, part: Part, start: int, end: int) -> tuple[Token, Token]:
        """Returns the first and the last value of some bytes."""
        first, last = bisect_right(part.offsets, start) - 1, bisect_left(part.offsets, end) - 1
        return self.tokens[part.first + first], self.tokens[part.first + last]


class _Digits(NamedTuple):
    """Bare digits: the groups, how long they are, and whether something else is among them."""

    texts: list[str]
    widths: set[int]
    are_all: bool
    are_signed: bool

    @property
    def have_zero(self) -> bool:
        """Whether a group of two is padded with a zero."""
        return any(len(text) == 2 and text[0] == "0" for text in self.texts)


_BY_DIGITS: tuple[tuple[str, Callable[[_Digits], bool], tuple[str, ...]], ...] = (
    ("00001111 00000000 00000010", lambda one: one.widths == {8} and {*"".join(one.texts)} <= {"0", "1"}, ("bits",)),
    ("0017, 0000, 0200", lambda one: one.widths == {4} and all(text[0] == "0" for text in one.texts), ("octal", "hex")),
    ("15, 0, -128", lambda one: one.are_signed, ("decimal", "hex")),
    ("0f 00 80", lambda one: one.widths == {2} and one.have_zero, ("hex",)),
    ("0f000000 8000, 0f 0 80", lambda one: max(one.widths) >= 4 or one.have_zero, ("hex", "decimal")),
    ("10 20 30", lambda one: one.widths == {2} and one.are_all, ("hex", "decimal")),
    ("15 0 128", lambda _: True, ("decimal", "hex")),
)
"""The bases of bare digits, the likeliest first: an example, what tells them; the first row that fits counts."""

_BY_WIDTH = (("bits", 8), ("octal", 3), ("words", 4), ("base64", 8))
"""The digits that one value must have to be read in a base that any digits may have."""


def _bases(tokens: Sequence[Token], kinds: set[str]) -> Sequence[str]:
    """Returns the bases that values of some kinds may have, the likeliest first."""
    texts = [token.text for token in tokens if token.kind == "digits"]
    if len(texts) > 1 and len(texts[0]) >= 4 > max(map(len, texts[1:])):
        texts = texts[1:]  # an offset
    if texts:
        are_all = len(texts) == len(tokens)
        are_signed = not are_all and any(one.text[0] == "-" for one in tokens)
        bare = _Digits(texts, {*map(len, texts)}, are_all, are_signed)
        most = max(bare.widths)
        bases = next(bases for _, test, bases in _BY_DIGITS if test(bare))
        if bases != ("bits",) or len(texts) <= _FEW:
            bases = (*bases, *(base for base, needed in _BY_WIDTH if most >= needed and base not in bases))
    elif "string" not in kinds:
        bases = ("hex",)
    else:
        is_decimal = any(token.kind == "string" and _DECIMAL_ESCAPE.search(token.text) for token in tokens)
        bases = ("decimal", "hex") if is_decimal else ("hex", "decimal")
    return (*bases, "unquoted") if "character" in kinds else bases


class Worth(NamedTuple):
    """What makes one reading likelier than another; the first that differs decides.

    is_whole  all frames begin where the text suggests it, and nothing is left but zeros: hardly by chance
    natural   the bytes of frames that begin where the text suggests it: others may be a part of something else
    size      the bytes of all frames: what explains more is likelier
    """

    is_whole: bool = False
    natural: int = 0
    size: int = 0


class Reading(NamedTuple):
    """A sequence in a base, and its parts that have frames."""

    worth: Worth
    values: Values
    base: str
    parts: list[Part]


def best(sequences: Iterable[Values]) -> Reading | None:
    """Returns the likeliest reading with frames; the first of those that are worth the same."""
    found: Reading | None = None
    for values in sequences:
        for base in values.bases:
            reading = _read(values, base)
            if reading.worth.size and (found is None or reading.worth > found.worth):
                found = reading
                if reading.worth.is_whole:
                    return found
    return found


def _is_likely(frame: bytes, values: Values, base: str, *, is_all: bool) -> bool:
    """Returns whether a frame is hardly one by chance, in values that may be anything."""
    if values.is_guess and values.has_unknown:
        known = sum(token.kind != "unknown" for token in values.tokens)
        return known * 2 > len(values.tokens) and is_command(frame) and is_sure(frame)
    if (is_all or not values.is_guess) and base != "base64":
        return is_flawless(frame)
    return is_sure(frame) and (is_all or is_command(frame))


def _read(values: Values, base: str) -> Reading:
    """Returns the frames in a sequence, in one base."""
    is_decimal = base == "decimal" and any(values.widths)
    is_trusted = 1 not in values.widths and not values.is_mixed and (not is_decimal or {*values.widths} == {3})
    parts = []
    for part in values.parts(base):
        is_given = is_trusted and not any(values.is_torn(part))
        frames = frames_in(part.data, partial(values.edges, part), is_trusted=is_given)
        if base in UNLIKELY or is_decimal:
            frames = [frame for frame in frames if frame.is_natural]
        if base in UNLIKELY or values.is_guess:
            is_all = part.last == len(values.tokens) and [one[:2] for one in frames] == [(0, len(part.data))]
            frames = [one for one in frames if _is_likely(part.data[one.start : one.end], values, base, is_all=is_all)]
        if frames:
            parts.append(part._replace(frames=frames))
    return Reading(_worth(values, parts), values, base, parts)


def _worth(values: Values, parts: list[Part]) -> Worth:
    """Returns what the frames in a sequence are worth."""
    if not parts:
        return Worth()
    frames, last = [frame for part in parts for frame in part.frames], parts[-1]
    natural = sum(frame.end - frame.start for frame in frames if frame.is_natural)
    size = sum(frame.end - frame.start for frame in frames)
    has_rest = last.last < len(values.tokens) or any(last.data[last.frames[-1].end :])
    return Worth(natural == size and not has_rest, natural, size)
