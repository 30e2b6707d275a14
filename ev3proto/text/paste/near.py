"""Bytes that are not a frame and were meant as one: a wrong length or type, a slip such as `G8`, what was cut.

A wrong frame is given out as its bytes, so that `decode` and `check` name its fault. A slip is named with its column,
and the bytes in front of it are given out.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterable, Iterator, Sequence
from itertools import islice
from typing import NamedTuple

from ev3proto.schema.header import frame_end, frame_size, may_start
from ev3proto.semantics.advice import BARE
from ev3proto.semantics.identify import LOOKS, Kind, identify
from ev3proto.tables.frame import LENGTH_FIELD
from ev3proto.text.paste.elements import BYTES, TextElement, clean, string_bytes
from ev3proto.text.paste.frames import HASHES, is_swapped, lacking, may_begin
from ev3proto.text.paste.heads import head_of, is_head
from ev3proto.text.paste.pieces import LEAST, MAX_TEXT, MOST_SHORT, Pasted, SlipPlace, short
from ev3proto.text.paste.repairs import slip_in
from ev3proto.text.paste.runs import AROUND, Part, Row, Run
from ev3proto.text.paste.strangers import strange_bytes

_MOST_STARTS = 8
_LEAST_TOLD = 3
"""Bytes from which on the start of a frame is one where the text says which way it went."""
_LISTS = re.compile(r"^$|[\[{(]$|<<$")
"""What is in front of a list of bytes."""
_MOST_LOW = 0x7F
"""Lists of numbers that are all this low are often something else."""
_OF_NUMPY = 3
"""Numbers that numpy shows of a long array, at each end."""
_MOST_BEFORE = 400
"""Characters in front of bytes in which a word may say which way they went."""
_WORD = re.compile(r"[\s,:;|\"'`-]{0,2}+(\\?\w[^\s,:;|\"'`\[\](){}<>#/]*)")
_LESSON = re.compile(r"\s*0[xX]\|")
_WHO_CUTS = (
    (re.compile(r"\b(?:write|send|sendto|read|recv|recvfrom)\(\d"), "strace cut the string; -s 1024 shows all of it"),
    (
        re.compile(r"\{length = \d+, bytes = |(?<![\w<])<[0-9a-f]{8} "),
        "the description of NSData is cut in the middle; print each byte",
    ),
)
_ENDLESS = re.compile(r"\\(?:[xXu](?:[0-9a-fA-F]?|\{[0-9a-fA-F]*))?$")
"""A part of an escape, at which a string is cut."""


class Near(NamedTuple):
    """Bytes of a run that are not a frame: where they begin and end in a part of it, and what is wrong behind them."""

    data: bytes
    run: Run
    part: Part
    start: int
    end: int
    problem: str | None = None
    cut: bool = False
    notes: tuple[str, ...] = ()
    slip: SlipPlace | None = None

    @property
    def is_stopped(self) -> bool:
        """Whether they break off at a slip or an ellipsis."""
        return self.cut or self.problem is not None

    def stopped(self, line: int, column: int, reason: str, first: int) -> Near:
        """Returns it with a slip behind it, in a line and at a column from 0; rows begin with a line."""
        where = f"line {line - first + 1}, " if line > first else ""
        return self._replace(problem=f"{where}column {column + 1}: {reason}", slip=SlipPlace(line, column + 1))


def near(runs: Iterable[Run], rows: Sequence[Row]) -> Near | None:
    """Returns the bytes of some lines that were meant as a frame; None if there are none."""
    # With expressions among the elements, or from any place of several lines, a wrong frame is too much of a guess.
    if len(rows) > 1 and any(row.wide is not None and Run(row.wide.elements).has_unknown for row in rows):
        return None
    tried = [run for run in runs if not (run.is_guess and (run.has_unknown or len(rows) > 1))]
    return next(_wrong(tried, rows), None) or next(_begun(tried, rows), None)


def _wrong(runs: list[Run], rows: Sequence[Row]) -> Iterator[Near]:
    """Yields bytes that are a frame but for their header, or of which the end is missing."""
    parts = ((run, base, part) for run in runs for base in run.bases for part in run.parts(base))
    for run, base, part in parts:
        for start, end in islice(run.between_breaks(part), _MOST_STARTS):
            end = len(part.data) if run.is_cut(part) else end
            data = part.data[start:end]
            is_possible = len(data) >= LOOKS and not _is_digest(part, data)
            if is_possible and identify(data, missing=False).is_meant:
                yield _with_stop(Near(data, run, part, start, end), base, rows)


def _is_digest(part: Part, data: bytes) -> bool:
    """Returns whether one element has as many bytes as a digest, and not nearly as many as its length says."""
    if len(part.offsets) != 2 or len(data) not in HASHES:
        return False
    return abs(frame_size(data) - len(data)) > LENGTH_FIELD and not is_swapped(data)


def _begun(runs: list[Run], rows: Sequence[Row]) -> Iterator[Near]:
    """Yields bytes that break off at a slip, an ellipsis, or the end of the line."""
    for run in runs:
        for base in run.bases[:2]:
            for part in islice(_parts(run, base), _MOST_STARTS):
                yield from _begun_in(run, base, part, rows)
    first = rows[0]
    lesson = _LESSON.match(first.line)
    word = _WORD.match(first.line, lesson.end()) if lesson else None
    if word is not None and BYTES["hex"][word[1]] is None and first.elements:
        nothing = Near(b"", Run(first.elements[:1]), Part(0, b"\0", [0, 1]), 0, 1)
        yield nothing.stopped(first.number, word.start(1), slip_in(word[1])[2], first.number)


def _begun_in(run: Run, base: str, part: Part, rows: Sequence[Row]) -> Iterator[Near]:
    """Yields bytes in a part of a run that break off."""
    for start, end in islice(run.between_breaks(part), _MOST_STARTS):
        data, (first, last) = part.data[start:end], run.span(part, start, end)
        before = rows[0].line[max(0, first.start - _MOST_BEFORE) : first.start]
        is_end = not rows[-1].line[last.end :].strip(AROUND)
        found = _with_stop(Near(data, run, part, start, end), base, rows)
        if not _is_digest(part, data) and _is_meant(found, before, is_end=is_end) and strange_bytes(data) is None:
            yield found


def _parts(run: Run, base: str) -> Iterator[Part]:
    """Yields the parts of a run, and the elements that have bytes only in front of a slip."""
    found = list(run.parts(base))
    yield from found
    begun = {part.last for part in found}
    for place, element in enumerate(run.elements):
        if place not in begun and (data := _partial(element)[0]):
            yield Part(place, data, [0, len(data)])


def _is_meant(found: Near, before: str, *, is_end: bool) -> bool:
    """Returns whether bytes in front of a slip or an end, which may be that of the text, were meant as a frame."""
    is_lesson = before.endswith(("0x|", "0X|"))
    first, last = (found.part.first + bisect_left(found.part.offsets, at) for at in (found.start, found.end))
    widths = {*found.run.widths[first:last]}
    is_open = re.search(r"[\[{(]$|<<$", before.rstrip()) is not None
    is_counted = bool({1, 3} & widths)
    if _is_proved(found, before) or _is_begun(found, is_open, is_counted, is_lesson):
        return True
    is_listed = is_lesson or (len(found.data) > 1 and (is_open or not is_counted))
    is_like_one = is_listed if found.is_stopped else is_end and _begins_one(found.data, widths)
    return is_like_one and _tells_direction(before)


def _tells_direction(before: str) -> bool:
    return is_head(before) and head_of(before).direction is not None


def _begins_one(data: bytes, widths: set[int]) -> bool:
    """Returns whether bytes of these widths begin a frame: `Recv 03 00 2A 00`, but not `sent 3 of 10`."""
    return len(data) >= _LEAST_TOLD and widths == {2} and may_begin(data)


def _is_begun(found: Near, is_open: bool, is_counted: bool, is_lesson: bool) -> bool:
    """Returns whether bytes are the start of a frame; numbers of one or three digits may be any."""
    data = found.data
    is_cut = found.cut and may_start(data)  # the text says itself that more follows
    is_any = is_counted and not (is_cut and is_open) and data[LEAST - 1 :] < b"\x80"
    is_whole = frame_end(data) == len(data)
    return len(data) >= (LEAST, 2)[is_lesson] and not is_any and (is_cut or is_whole or may_begin(data))


_LEFT_OUT = re.compile(r"\D+(\d+) ")
_NUMPY = re.compile(r"\barray\(|\buint8\b")


def _is_proved(found: Near, before: str) -> bool:
    """Returns whether a mark says how many bytes are left out, and these are missing; or numpy shows three numbers."""
    rest = found.run.elements[found.part.last :] if found.cut else []
    left_out = _LEFT_OUT.match(rest[0].text) if rest else None
    if left_out is not None:
        return len(found.data) > 1 and frame_size(found.data) == len(found.data) + int(left_out[1])
    is_array = len(found.data) == _OF_NUMPY == len(rest) - 1
    is_said = _NUMPY.search(before) is not None or head_of(before).direction is not None
    return is_array and is_said


def _with_stop(found: Near, base: str, rows: Sequence[Row]) -> Near:
    """Returns bytes with what is wrong behind them: a slip, or an ellipsis."""
    elements, part, top = found.run.elements, found.part, rows[0].number
    _, last = found.run.span(part, found.start, found.end)
    if BYTES[base][last.text] is None:
        return _at(found, last, top)
    if len(found.data) > 1 and frame_size(found.data) <= len(found.data):
        return found
    place = part.first + bisect_left(part.offsets, found.end)
    line = next(row.line for row in rows if row.number == last.line)
    follows = elements[place] if place < len(elements) else last._replace(start=len(line))
    if follows.kind == "cut":
        return _cut(found, last, elements[: place - 1], line)
    if BYTES[base][follows.text] is None:
        return _at(found._replace(data=found.data + _partial(follows)[0]), follows, top)
    word = _WORD.match(line, last.end)
    return found if word is None else _at_word(found, last, word, top)


def _cut(found: Near, last: TextElement, before: Sequence[TextElement], line: str) -> Near:
    """Returns bytes with an ellipsis behind them; half a byte in front of it is left out."""
    if len(last.text) == 1 and before and len(before[-1].text) == 2:
        found = found._replace(data=found.data[:-1], end=found.end - 1)
    return found._replace(cut=True, notes=tuple(note for who, note in _WHO_CUTS if who.search(line)))


def _at_word(found: Near, last: TextElement, word: re.Match[str], top: int) -> Near:
    """Returns bytes with a word behind them that was meant as an element like the last one."""
    is_slip = len(word[1]) == len(last.text) or word[1][:2] in ("0x", "\\x")
    if not is_slip or BYTES["hex"][word[1]] is not None:
        return found
    return found.stopped(last.line, word.start(1), slip_in(word[1], is_hex=last.kind == "digits")[2], top)


def _at(found: Near, element: TextElement, top: int) -> Near:
    """Returns bytes that end in an element with a slip, or cut there."""
    _, column, reason = _partial(element)
    return found._replace(cut=True) if not reason else found.stopped(element.line, column, reason, top)


def _partial(element: TextElement) -> tuple[bytes, int, str]:
    """Returns the bytes in front of a slip in an element that has none, its column, and what it is; "" if it is cut."""
    text = element.text
    if element.kind == "open":
        is_cut = text.rstrip().endswith(("...", "\u2026"))
        body = _ENDLESS.sub("", text.rstrip(". \u2026") if is_cut else text)
        data = string_bytes(body[1 + (body[0] == "b") :]) or b""
        return data, element.start, "" if is_cut else "the string that starts here never ends"
    data, at, reason = slip_in(text)
    return data, element.start + at, reason


def spelt(runs: Iterable[Run]) -> str | None:
    """Returns what elements are that are the characters of a frame's digits; None for any other."""
    parts = ((run, part) for run in runs for part in run.likely_parts())
    between = (part.data[start:end] for run, part in parts for start, end in run.between_breaks(part))
    return next((said for data in between if (said := strange_bytes(data, Kind.DIGITS))), None)


def told(row: Row) -> Pasted | None:
    """Returns a line of nothing but bytes with what it is instead of a frame, such as one without its header."""
    run = row.runs[-1]
    part = next(run.likely_parts(), None)
    is_all = part is not None and part.last - part.first == len(run.elements) and not row.after.strip(AROUND)
    if part is None or not is_all or not _is_data(row, run, part.data):
        return None
    said = strange_bytes(part.data)
    lacks = None if said or _is_dull(run, part) else lacking(part.data)
    problem = BARE[lacks] if lacks else said
    return Pasted(b"", row.number, short(row.line, MAX_TEXT), problem=problem, lacks=lacks) if problem else None


def _is_dull(run: Run, part: Part) -> bool:
    """Returns whether bytes are a text, a digest, or too much alike for operations."""
    is_text = run.elements[0].kind == "string" and max(part.data) <= _MOST_LOW
    return is_text or (len(run.elements) > 1 and len({*part.data}) < LEAST - 1) or _is_digest(part, part.data)


def _is_data(row: Row, run: Run, data: bytes) -> bool:
    """Returns whether the elements of a line were meant as bytes: nothing, a list or a direction introduces them."""
    first = run.elements[0]
    before = row.line[: first.start]
    plain = before.rstrip().removesuffix("(byte)").rstrip()
    if max(data) > _MOST_LOW and _LISTS.search(plain):
        return True
    # Operations by their names are assembly, if they are not joined.
    is_assembly = first.kind == "marked" and first.text[0].isalpha() and ".join(" not in row.line
    is_decimal = {*run.widths} != {2} and all(one.text.isdecimal() for one in run.elements)
    if is_assembly or 1 in run.widths or is_decimal:
        return False
    is_alone = not before.strip(AROUND + "xb") or before.rstrip("([").endswith(".join")
    return is_alone or head_of(before).direction is not None


# Bytes that are known to be meant as such


def bytes_in(line: str) -> bytes:
    """Returns the bytes of the elements in a line, in their likeliest base, whether they are a frame or not."""
    runs = Row(clean(line), 0).of_line()
    return max((part.data for run in runs for part in run.likely_parts()), key=len, default=b"")


_NO_DIGIT = re.compile(r"(?!^0[xX])(?<!^0)[^0-9a-fA-F]")


def as_given(line: str) -> Pasted:
    """Returns the bytes of a line that has no frame, but is known to be meant as bytes, however few."""
    row = Row(clean(line), 1)
    run = Run(row.elements)
    for base in run.bases[:2]:
        for part in islice(_parts(run, base), 1):
            before = row.line[: run.elements[part.first].start]
            if part.first or (before.strip(AROUND + "x0b") and not is_head(before)):
                continue
            found = _with_stop(Near(part.data, run, part, 0, len(part.data)), base, [row])
            return Pasted(found.data, 1, short(line, MAX_TEXT), cut=found.cut, problem=found.problem, slip=found.slip)
    if not line.strip():
        return Pasted(b"", 1, "", problem="it is empty")
    column, reason = _unread(row, line)
    problem, slip = f"column {column + 1}: {reason}", SlipPlace(1, column + 1)
    return Pasted(b"", 1, short(line, MAX_TEXT), problem=problem, slip=slip)


def _unread(row: Row, line: str) -> tuple[int, str]:
    """Returns the column of what cannot be read in a line, from 0, and what is wrong with it."""
    word = line.split()[0].rstrip("\"'`)]}>;,")
    if row.elements and row.is_bare:
        return _partial(row.elements[0])[1:]
    if len(word) > MOST_SHORT and (strange := _NO_DIGIT.search(word)):
        return strange.start(), f"{strange[0]!r} is not a hex digit"
    return 0, f"{short(word)!r} is not hex" if word.strip("-") else "it contains no readable bytes"
