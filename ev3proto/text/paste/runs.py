"""Runs of elements: which of those in a line, or in lines that look alike, may be bytes. Nothing here knows a notation.

A run is a hypothesis: all elements of a line, every second or third, those below each other. Each is tried in each
base; `judge` says what it is worth. Where the bytes begin in the first line, they begin in those that have the same in
front: so offsets, indexes, prefixes of logs and calls need no rule of their own.
"""

from __future__ import annotations

import re
from bisect import bisect_left, bisect_right
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from functools import cached_property, lru_cache
from itertools import accumulate, pairwise
from typing import NamedTuple

from ev3proto.schema.header import with_length
from ev3proto.tables.frame import LENGTH_FIELD
from ev3proto.text.paste.elements import BYTES, TextElement, elements_of, unknown_bytes, widened
from ev3proto.text.paste.frames import Edges, has_place, is_whole, may_begin, may_begin_wrong
from ev3proto.text.paste.pieces import LEAST, MAX_COLLECTED

AROUND = " \t\r\n\f\v,;:|+&/\\\"'`<>()[]{}_-=.*"
"""What may be around bytes that are alone in a line."""

_CALL = re.compile(r"[\w.]+\s?\(+|\)")
_SAYS = re.compile(r"(?<!\s):\s")
"""What is in front of a colon and a blank tells about what is behind them: `Length 8: 06 00`."""
_LITERAL = re.compile(r"(?:0[xX]|[xX]'|\\x)[0-9a-fA-F]{10}")
_BASE64 = re.compile(r"(?<![\w+/.-])[\w+/-][AQgw][A-P][\w+/-]{5,}={0,2}(?![\w+/=.-])", re.ASCII)
"""A word that begins with a length below 1024 in base64."""
_TEXT = re.compile(r"  |[.]| [|(]")
_NUMBER = re.compile(r"(?:0x)?[0-9a-fA-F]+|\w+(?=\s?\()")
_WORD = re.compile(r"[A-Za-z]{2}")
_WIDE = 4
"""Digits of an element that may be more than a byte."""
_FEW = 3
"""Elements of a line each of which may be the only byte in it."""
_COLUMN = 7
"""Blanks that separate columns, not elements."""
_MOST_PLACES = 8
"""Starts of a frame that are tried in a line: each costs as much as reading the lines."""
_MOST_IN_ROW = 34


@lru_cache(1024)
def shape(gap: str) -> str:
    """Returns what matters of a gap: not its few blanks, nor a call, nor which of its two signs the lesson uses."""
    plain = "".join(_CALL.sub("", _SAYS.sub("=", gap)).split()).replace("0x|", "")
    return re.sub(r"[:|+]", "", plain) + " " * (" " * _COLUMN in gap)


class Part(NamedTuple):
    """Consecutive elements of a run that have bytes in a base: the first's place, their bytes, where each begins."""

    first: int
    data: bytes
    offsets: list[int]

    @property
    def last(self) -> int:
        """The place after the last element."""
        return self.first + len(self.offsets) - 1

    def inside(self, places: list[int]) -> list[int]:
        """Returns the offsets of those of some places that are inside the part."""
        some = places[bisect_right(places, self.first) : bisect_left(places, self.last)]
        return [self.offsets[place - self.first] for place in some]


class Run:
    """Elements that may be bytes, with what the text says of their places.

    rows       the places of the elements that begin a line, but for the first
    is_guess   some elements of the lines are left out, so that only what is surely a frame counts
    widths     the digits of each element; 0 for those that say themselves what they are
    """

    def __init__(
        self,
        elements: Sequence[TextElement],
        rows: Sequence[int] = (),
        bases: Sequence[str] = (),
        *,
        is_guess: bool = False,
    ) -> None:
        self.elements, self.rows, self.is_guess = elements, [*rows], is_guess
        self.widths = [len(one.text) if one.kind == "digits" else 0 for one in elements]
        kinds = {one.kind for one in elements}
        self.has_unknown = "unknown" in kinds
        self.has_string = "string" in kinds
        self.bases = bases or _bases(elements, kinds)

    @cached_property
    def breaks(self) -> list[int]:
        """The places of the elements in front of which something changes: the usual gap, or how they are written."""
        shapes = [shape(one.gap) for one in self.elements]
        usual = self._usual(shapes)
        # What says itself what it is has no digits, but for a literal of many bytes.
        elements = zip(self.elements, self.widths, strict=True)
        lengths = [width or (len(one.text) if _LITERAL.match(one.text) else 0) for one, width in elements]
        is_uniform = not self.has_string and max(lengths) < _WIDE
        return [
            place
            for place in range(1, len(shapes))
            if (shapes[place] != usual or not (is_uniform or self._is_like(place, *lengths[place - 1 : place + 1])))
            and not has_place(self.rows, place)
        ]

    def _usual(self, shapes: list[str]) -> str:
        """Returns the usual gap; one that is there only once hardly is."""
        if len(shapes) < 2:
            return ""
        usual, count = Counter(shapes[1:]).most_common(1)[0]
        return usual if count > 1 or len(usual) < 2 else ""

    def _is_like(self, place: int, last: int, length: int) -> bool:
        """Returns whether an element may be of one kind with the one in front of it: no string, offset, or literal."""
        first, second = self.elements[place - 1 : place + 1]
        is_offset = place == 1 and last >= max(4, length + 1)
        is_literal = min(last, length) >= 2 * LEAST and re.search("[\"'`,]", second.gap) is not None
        is_longer = min(last, length) < LEAST <= max(last, length) // 2
        return (first.kind == "string") == (second.kind == "string") and not (is_offset or is_literal or is_longer)

    def parts(self, base: str) -> Iterator[Part]:
        """Yields the elements that have bytes in a base, from each that has none to the next."""
        table = BYTES[base]
        found = [table[one.text] for one in self.elements]
        ends = [place for place, data in enumerate(found) if data is None]
        for before, end in pairwise((-1, *ends, len(found))):
            values = found[before + 1 : end]
            data = b"".join(values)  # type: ignore[arg-type]
            if self.has_unknown and data:
                data = _of_unknown(data, [unknown_bytes(one) for one in self.elements[before + 1 : end]])
            if data:
                yield Part(before + 1, data, [0, *accumulate(map(len, values))])  # type: ignore[arg-type]

    def likely_parts(self) -> Iterator[Part]:
        """Yields the parts in the two likeliest bases."""
        return (part for base in self.bases[:2] for part in self.parts(base))

    def is_torn(self, part: Part) -> bool:
        """Returns whether elements before a part are written like those in it, but have no bytes."""
        return part.first > 0 and not has_place(self.breaks, part.first)

    def is_cut(self, part: Part) -> bool:
        """Returns whether the text says behind a part that more bytes existed."""
        return part.last < len(self.elements) and self.elements[part.last].kind == "cut"

    def edges(self, part: Part) -> Edges:
        """Returns where frames may begin and end in a part."""
        return Edges(part.inside(self.breaks), part.offsets)

    def between_breaks(self, part: Part) -> Iterator[tuple[int, int]]:
        """Yields where the bytes between two breaks begin and end."""
        return pairwise((0, *part.inside(self.breaks), len(part.data)))

    def span(self, part: Part, start: int, end: int) -> tuple[TextElement, TextElement]:
        """Returns the first and the last element of some bytes."""
        first, last = bisect_right(part.offsets, start) - 1, bisect_left(part.offsets, end) - 1
        return self.elements[part.first + first], self.elements[part.first + last]


def _of_unknown(data: bytes, unknown: list[list[bool]]) -> bytes:
    """Returns bytes of which some are unknown, none if all are; an unknown length is the one that fits."""
    if all(all(one) and one for one in unknown):
        return b""
    fitted = with_length(data[LENGTH_FIELD:])
    return fitted if unknown[0][:1] == [True] and fitted[1:] == data[1:] else data


class _Digits(NamedTuple):
    """Bare digits: the texts, their widths, whether nothing else is among them, and whether a number is negative."""

    texts: list[str]
    widths: set[int]
    are_all: bool
    are_signed: bool

    @property
    def are_padded(self) -> bool:
        """Whether one of two digits begins with a zero."""
        return any(len(text) == 2 and text[0] == "0" for text in self.texts)


_BY_DIGITS: tuple[tuple[str, Callable[[_Digits], bool], tuple[str, ...]], ...] = (
    ("00001111 00000000 00000010", lambda one: one.widths == {8} and {*"".join(one.texts)} <= {*"01"}, ("bits",)),
    ("06 00 -128", lambda one: one.are_signed, ("decimal", "hex")),
    ("0f 00 80", lambda one: one.widths == {2} and one.are_padded, ("hex",)),
    ("0f000000 8000, 0f 0 80", lambda one: max(one.widths) >= _WIDE or one.are_padded, ("hex", "decimal")),
    ("10 20 30", lambda one: one.widths == {2} and one.are_all, ("hex", "decimal")),
    ("15 0 128", lambda _: True, ("decimal", "hex")),
)
"""The bases of bare digits, the likeliest first: an example, what tells them; the first row that fits counts."""

_BY_WIDTH = (("006 000 052 000 200 000 000 001", "octal", 3), ("0006 002a 0080 0100", "words", 4))
"""An example, and the digits that one element must have to be read in a base that any digits may have."""


def _of_digits(digits: _Digits) -> tuple[str, ...]:
    bases = next(bases for _, is_so, bases in _BY_DIGITS if is_so(digits))
    others = (base for _, base, least in _BY_WIDTH if max(digits.widths) >= least)
    return bases if bases == ("bits",) else (*bases, *others)


def _bases(elements: Sequence[TextElement], kinds: set[str]) -> Sequence[str]:
    """Returns the bases that elements may have, the likeliest first; bare digits tell by their widths and zeros."""
    texts = [one.text for one in elements if one.kind == "digits"]
    if len(texts) > 1 and len(texts[0]) >= _WIDE > max(map(len, texts[1:])):
        texts = texts[1:]  # an offset
    bases: tuple[str, ...] = ("hex",)
    if texts:
        are_all = len(texts) == len(elements)
        is_signed = not are_all and any(one.text[0] == "-" for one in elements)
        bases = _of_digits(_Digits(texts, {*map(len, texts)}, are_all, is_signed))
    return (*bases, "unquoted") if "character" in kinds else bases


class Row:
    """A line and its elements."""

    def __init__(self, line: str, number: int, *, is_inside: bool = False) -> None:
        self.line, self.number, self._is_inside = line, number, is_inside
        elements, self.after = elements_of(line, number)
        self.elements = _without_text(line, elements) if elements and _TEXT.search(line, elements[0].end) else elements

    @cached_property
    def wide(self) -> Row | None:
        """The row with expressions and texts among its elements; None if there are none of these."""
        is_long = len(self.line) > MAX_COLLECTED
        found = None if is_long else widened(self.line, self.number, is_inside=self._is_inside)
        if found is None:
            return None
        row = Row.__new__(Row)
        row.line, row.number, (row.elements, row.after), row.wide = self.line, self.number, found, None
        return row

    @cached_property
    def runs(self) -> list[Run]:
        """The runs of its elements, which are tried with the rows above, alone, and for what is nearly a frame."""
        return list(_of_elements(self.elements)) if self.elements else []

    def of_line(self) -> Iterator[Run]:
        """Yields all runs in the line."""
        yield from self.runs
        for found in _BASE64.finditer(self.line):
            yield Run([TextElement("digits", found[0], *found.span(), "", self.number)], bases=("base64",))
        if self.wide is not None:
            yield from _of_elements(self.wide.elements, is_guess=True)

    @property
    def is_bare(self) -> bool:
        """Whether nothing is in front of the elements."""
        return not self.elements[0].gap.strip(AROUND + "x0b")

    @property
    def is_offset(self) -> bool:
        """Whether the row of a dump begins, with the offset zero."""
        text = self.elements[0].text.removeprefix("0x") if len(self.elements) > 1 else ""
        return len(text) >= 4 and not text.strip("0")

    def front(self, place: int) -> str:
        """Returns what is in front of an element, without the digits in it."""
        return "0".join(_NUMBER.sub("0", shape(one.gap)) for one in self.elements[: place + 1])

    def first(self, like: Row, place: int) -> int | None:
        """Returns the first element of the row that belongs to those of another one from a place on; None for none."""
        if self.front(place) == like.front(place):
            return place
        return 0 if self.is_bare and (place < len(self.elements) or self.front(0) != like.front(0)) else None

    @property
    def is_open(self) -> bool:
        """Whether a list goes on after the row: it ends with a comma, a plus, or a backslash."""
        return self.after.strip(" \t\"'")[:1] in (",", "+", "\\")

    @property
    def ends(self) -> list[int]:
        """Where its elements end."""
        return [one.end for one in self.elements]

    @property
    def widths(self) -> set[int]:
        """The digits of its bare elements."""
        return {len(one.text) for one in self.elements if one.kind == "digits"}

    def follows(self, last: Row, places: Sequence[int]) -> bool:
        """Whether the row is written as the one in front of it, or goes on with a list that this one does not end."""
        if self.is_offset:
            return False
        if self.is_bare and (last.is_bare or last.is_open):
            # Where all elements have two digits, one that has one is no more of them.
            return not (last.widths == {2} and 1 in self.widths and len(last.elements) >= LEAST)
        if self.ends == last.ends:
            return True  # columns, with a word in front of the first row
        fewest = min(len(self.elements), len(last.elements))
        return self.is_bare == last.is_bare and any(self.front(at) == last.front(at) for at in places if at < fewest)


def _without_text(line: str, elements: list[TextElement]) -> list[TextElement]:
    """Drops what is in the column of text: as many characters as there are bytes, each of them the byte's."""
    is_bits = len(elements) > 1 and len(elements[1].text) == 8
    for first in (1, 0):
        data = bytearray()
        for place in range(first, min(len(elements), _MOST_IN_ROW)):
            value = BYTES["bits" if is_bits else "hex"][elements[place].text]
            if value is None:
                break
            data += value
            if _shows(line[elements[place].end :].strip(), data):
                return elements[: place + 1]
    return elements


def _shows(text: str, data: bytearray) -> bool:
    """Returns whether a text has the characters of bytes."""
    shown = text[1:-1] if text[:1] in ("|", ">", "(") else text.rstrip("| ")
    shown = "".join(shown.split())
    known = [byte for byte in data if byte != 0x20]
    return len(shown) == len(known) and all(
        chr(byte) == character if 0x20 < byte < 0x7F else not (character.isascii() and character.isalnum())
        for byte, character in zip(known, shown, strict=True)
    )


def _of_elements(elements: list[TextElement], *, is_guess: bool = False) -> Iterator[Run]:
    """Yields the runs in elements that follow each other: all, and if these are not alike, every second or third."""
    run = Run(elements, is_guess=is_guess)
    if len(elements) >= 2 * LEAST and len(run.breaks) * 3 > len(elements):
        shapes = [shape(one.gap) for one in elements]
        for stride in (2, 3):
            gaps = ["#".join(shapes[max(0, at - stride + 1) : at + 1]) for at in range(len(elements))]
            for phase in range(stride):
                some = [elements[at]._replace(gap=gaps[at]) for at in range(phase, len(elements), stride)]
                each = Run(some, is_guess=True)
                if len(each.breaks) <= 4:  # alike but for what is behind them in an object
                    yield each
        run.is_guess = True
    yield run


def openings(row: Row) -> list[int]:
    """Returns the places in a line where a frame may begin that goes on in the next lines."""
    if row.is_offset:
        return [1]
    run = Run(row.elements)
    found = {place for place, one in enumerate(row.elements) if unknown_bytes(one)[:1] == [True]}
    # The bytes go on to the end of the line: no words are among them.
    start = max((place for place, one in enumerate(row.elements) if _WORD.search(one.gap)), default=0)
    parts = (part for base in run.bases for part in run.parts(base))
    breaks = {0, *run.breaks}
    found |= {place for part in parts for place in _openings_of(part, breaks)}
    end = len(row.elements) - (len(row.elements) > _FEW)
    return [place for place in sorted(found) if start <= place < max(end, 1)][:_MOST_PLACES]


def _openings_of(part: Part, breaks: set[int]) -> Iterator[int]:
    """Yields the places in a part where a frame may begin; one that is whole may have a length that is too small."""
    if may_begin_wrong(part.data):
        yield part.first
    for place, at in zip(range(part.first, part.last), part.offsets, strict=False):
        if may_begin(part.data, at) or (place in breaks and is_whole(part.data, at)):
            yield place


def of_rows(rows: list[Row], places: list[int]) -> Iterator[Run]:
    """Yields the runs in lines that follow each other, each from a place in the first where a frame may begin."""
    yield from _lined_up(rows, places)
    if any(row.wide is not None for row in rows):
        wide = [row.wide or row for row in rows]
        yield from _lined_up(wide, openings(wide[0]), is_guess=True)


def _lined_up(rows: list[Row], places: list[int], *, is_guess: bool = False) -> Iterator[Run]:
    first = rows[0]
    if {*map(len, (row.elements for row in rows))} in ({2}, {_FEW}):
        # Just one element of each row may be a byte.
        yield from (_joined([[row.elements[at]] for row in rows], is_guess=is_guess) for at in places)
    # Among elements that are written alike, only what is surely a frame counts.
    among = {at for at in places if at > 1} - {*Run(first.elements).breaks}
    for place in [0] * _is_carried(first, places) + places:
        some = [row.elements[start:] for row in rows if (start := row.first(first, place)) is not None]
        yield _joined(some, is_guess=is_guess or place != places[0] or place in among)


def _is_carried(first: Row, places: list[int]) -> bool:
    """Returns whether what carries a frame may be in front of it, written like it."""
    return (
        bool(places) and not first.is_offset and not any(one.gap.strip() for one in first.elements[1 : places[0] + 1])
    )


def _joined(rows: list[list[TextElement]], *, is_guess: bool = False) -> Run:
    starts = [0, *accumulate(map(len, rows))]
    return Run([one for row in rows for one in row], starts[1:-1], is_guess=is_guess)
