"""Lines of text -> the pieces in them.

A line whose elements are whole frames is done. One that may be the first of several opens a block, which takes the
lines that look like it; at its end the frames in all of them are looked for, and otherwise in each.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import chain

from ev3proto.schema.frame import parse
from ev3proto.schema.header import frame_end
from ev3proto.semantics.identify import LOOKS, identify
from ev3proto.text.paste.elements import BYTES, EXPRESSION, TextElement, clean, unknown_bytes
from ev3proto.text.paste.frames import FrameSpan, is_carried, is_whole
from ev3proto.text.paste.heads import NO_HEAD, Head, announced, direction_of, head_of
from ev3proto.text.paste.judge import Reading, best
from ev3proto.text.paste.near import Near, near, spelt, told
from ev3proto.text.paste.pieces import LEAST, MAX_COLLECTED, MAX_LINE, MAX_TEXT, Pasted, Unknown, check_text, short
from ev3proto.text.paste.repairs import Repaired, may_be_mended, repaired
from ev3proto.text.paste.runs import AROUND, Part, Row, Run, of_rows, openings, shape
from ev3proto.text.paste.strangers import strange_text

_GATE = re.compile(
    r"""
    # An element from 0 to 3, the second byte of every frame; or a group of digits with it, or that begins with it.
    (?<![a-zA-Z\d])(?<!\d\.)(?:0[xX]|&[hH]|\$)?0{0,3}[0-3](?![\da-fA-FxX]|\.\d) | (?<!\w)(?:0[xX])?[\da-fA-F]{2}0[0-3]
    (?=(?:[\da-fA-F]{4})?(?!\w)|[\da-fA-F]{6}|[xXmM]{2}) | (?<!\w)(?:0[xX])?0[0-3][\da-fA-F]{8}
  | 0x0?[0-3]0x | [\da-fA-F]{2}\.0[0-3]\.
    # A download, which may be longer than other frames: its type and its command.
  | [\da-fA-F]{2}[\W_]?[08]1[\W_]?9[\da-fA-F]
    # An escape, the lesson's mark, an unknown byte, base64.
  | \\ | 0[xX]\| | (?<!\w)(?:[xX]{2}|MM) | (?<![\w+/-])[\w+/-][AQgw][A-P][\w+/-]{5}
    """,
    re.VERBOSE,
)
"""What a line with a frame, or with its start, has."""
_SPELT = re.compile(
    r"3(?:0[\W_]{0,2}(?:0x)?(?:30|78|20|2[cC])|2[,\s]\s?48)|4(?:1[\W_]{0,2}(?:0x)?41|8[,\s]\s?(?:48|32|44|120))|65[,\s]\s?65"
    "|\uff10|\uff11|\uff12|\uff13"
)
"""What a line with the characters of digits has: two zeros in hex, decimal or base64; and full-width digits."""

_TIME_FIRST = re.compile(r"(?:\W?(?:[\d/-]+[T ])?\d\d:\d\d:\d\d(?!:)\S*\s+(?:\d{3,5}\s+\d{3,5}\s)?)?")
"""The date and the time at the start of a line, and the numbers of a process and a thread after them."""
_SHORT = 40
"""Characters of a line that may have just one of the bytes of a frame."""
_CHECK_SUM = re.compile(r"\s+(?:FCS: 0x|RFCOMM.* fcs 0x)([0-9a-fA-F]{2})\b")
_AGAIN = re.compile(r"\s*\+\d+ \| | \| 0[0-9a-f]{4}  ")
"""Lines that show the frame above them again: `check` under a finding, `strace -e write` below a call."""
_MOST_AROUND = 2000
_MOST_EMPTY = 3
_MOST_BEFORE = 16
_MOST_SHOWN = 20
_MOST_STRANGE = 1000
"""Lines in which something else than a frame is looked for, as long as there is none."""


class Block:
    """Lines that look alike, and may have a frame together."""

    def __init__(self, row: Row, places: list[int], above: Head) -> None:
        self.rows, self.places, self.above = [row], places, above
        self.size, self.empty, self.in_comment = 0, 0, _is_open_comment(row.line)
        self.data = bytearray(_data_of(row, row, places[0]))
        self.shown = 0  # rows of a frame that was complete before the next line came
        self._was_full = False

    def rest(self) -> list[TextElement]:
        """Returns the elements of the rows that were not shown; the last row of a dump has only its offset."""
        place, first = self.places[0], self.rows[0]
        starts = [place if first.is_offset else row.first(first, place) or 0 for row in self.rows]
        return [one for row, at in [*zip(self.rows, starts, strict=True)][self.shown :] for one in row.elements[at:]]

    def is_full(self) -> bool:
        """Returns whether the last row completed a frame, once."""
        is_full = is_whole(self.data) and not self.rows[-1].is_open
        was_full, self._was_full = self._was_full, self._was_full or is_full
        return is_full and not was_full

    @property
    def is_shown(self) -> bool:
        """Whether nothing in it is left to show."""
        return self.shown == len(self.rows)

    @property
    def is_too_long(self) -> bool:
        """Whether a frame has more text than is collected."""
        return self.size > MAX_COLLECTED and is_whole(self.data)

    @property
    def waits(self) -> bool:
        """Whether something in it was not shown yet; a list or a comment that is open is not complete in any case."""
        return not self.is_shown and not self.in_comment and not self.rows[-1].is_open

    def take(self, line: str, number: int) -> bool:
        """Adds a line. Returns whether it belongs to the block."""
        text = self._uncommented(clean(line))
        last, first = self.rows[-1], self.rows[0]
        row = self._row(text, number)
        if not row.elements:
            return self._takes_empty(row)
        data = _data_of(row, first, self.places[0])
        is_other = first.is_offset and len(row.elements[0].text) != len(first.elements[0].text)
        if is_other or not row.follows(last, self.places) or self._begins_anew(row, data):
            return False
        self.data += data
        self.size += len(line)
        if self.size <= MAX_COLLECTED:
            self.rows.append(row)
        self.empty, self.in_comment = 0, _is_open_comment(text)
        return True

    def _takes_empty(self, row: Row) -> bool:
        """Returns whether a line without elements belongs to the block."""
        self.empty += 1
        is_open = self.rows[-1].is_open
        is_empty = not row.after.strip() and self.empty <= _MOST_EMPTY
        return self.in_comment or is_empty or (is_open and row.line.lstrip()[:1] in ("#", "*", ";"))

    def _uncommented(self, text: str) -> str:
        """Returns a line without the rest of the comment that it begins in."""
        if self.in_comment:
            end = text.find("*/") + 2
            text, self.in_comment = " " * end + text[end:] if end > 1 else "", end < 2
        return text

    def _row(self, text: str, number: int) -> Row:
        """Returns a row; with expressions, where it has something else in the places of bytes."""
        last = self.rows[-1]
        row = Row(text, number, is_inside=last.is_open)
        wide = row.wide
        if wide is None:
            return row
        is_name = not row.elements and (not last.is_open or wide.front(0) == last.front(0))
        is_value = len(row.elements) < len(last.elements) == len(wide.elements)
        return wide if is_name or is_value or any(one.kind == "string" for one in wide.elements) else row

    def _begins_anew(self, row: Row, data: bytes) -> bool:
        """Returns whether a row is a frame by itself, right or wrong, that the rows so far do not need."""
        first = self.rows[0]
        if first.is_offset:
            return False
        if row.front(0) == first.front(0) != self.rows[-1].front(0):
            return True
        size = len(self.data) + len(data)
        is_needed = size <= (frame_end(self.data) or 0)
        alone = best(row.runs)
        if alone is not None and alone.worth.is_whole:
            return not is_needed or not row.is_bare or len(data) != size // (len(self.rows) + 1)
        return not is_needed and frame_end(data) is not None and identify(data, missing=False).is_meant


def _data_of(row: Row, first: Row, place: int) -> bytes:
    """Returns the bytes of a row of a block, in its likeliest base."""
    run = Run(row.elements[row.first(first, place) or 0 :])
    return next((part.data for part in run.parts(run.bases[0])), b"")


def _is_open_comment(line: str) -> bool:
    return line.rfind("/*") > line.rfind("*/")


class Reader:
    """Reads the frames of a text."""

    def __init__(self) -> None:
        self._block: Block | None = None
        self._before: deque[str] = deque(maxlen=_MOST_BEFORE)
        self._strange: Pasted | None = None
        self._has_frame = False
        self._ended: tuple[Reading, list[Row]] | None = None

    def read(self, lines: Iterable[str], is_silent: Callable[[], bool]) -> Iterator[Pasted]:
        """Yields all pieces in the lines, in their order; what the next line may continue waits for it or silence."""
        has_any = False
        for number, line in enumerate(lines, 1):
            check_text(line)
            for piece in chain(self._take(line.rstrip("\r\n"), number), self._waited(is_silent)):
                yield piece
                has_any = True
            if not has_any and self._strange is None and number <= _MOST_STRANGE and (said := strange_text(line)):
                self._strange = _said(number, line, said)
        for piece in self._close():
            yield piece
            has_any = True
        if not has_any and self._strange is not None:
            yield self._strange

    def _waited(self, is_silent: Callable[[], bool]) -> Iterator[Pasted]:
        """Yields what is in a block that the next line may continue, if that does not come."""
        if self._block is not None and self._block.waits and is_silent():
            yield from self._close()

    def _take(self, line: str, number: int) -> Iterator[Pasted]:
        block = self._block
        if len(line) > MAX_LINE:
            yield from self._close()
            yield _said(number, line, f"the line has more than {MAX_LINE} characters and was not read")
        elif block is not None and line.strip() == "*" and block.rows[0].is_offset:
            yield from self._left_out(block, number)
        elif block is not None and block.take(line, number):
            yield from self._show(block)
        else:
            yield from self._close()
            yield from self._begin(line, number)

    def _begin(self, line: str, number: int) -> Iterator[Pasted]:
        """Yields what is in a line that does not belong to those above it; it may begin a block."""
        is_again = _AGAIN.match(line) is not None and (self._has_frame or line.lstrip()[:1] == "+")
        is_long = len(line) > _SHORT and self._ended is None  # bytes that are too many may be any
        if is_again or (is_long and not _may_have_bytes(line)):
            self._has_frame = False
            self._before.append(line)
            return
        row = Row(clean(line), number)
        reading = best(row.of_line())
        is_done = not row.elements or len(line) > MAX_COLLECTED or _is_done(reading, row)
        if not is_done and (places := openings(row)):
            self._block = Block(row, places, self._said_above())
        else:
            yield from self._line(row, reading, self._said_above())

    def _said_above(self) -> Head:
        """Returns what the lines above say: the last one, or those above it where these are indented."""
        for line in reversed(self._before):
            said = announced(line)
            if said != NO_HEAD or line[:1].strip():
                return said
        return NO_HEAD

    def _check_sum(self) -> bytes:
        """Returns the check sum behind the bytes of RFCOMM, which the lines above tell."""
        found = next((found for line in self._before if (found := _CHECK_SUM.match(line))), None)
        return b"" if found is None else bytes.fromhex(found[1])

    def _left_out(self, block: Block, number: int) -> Iterator[Pasted]:
        """Yields the rows of a dump in front of a `*`."""
        self._block, first = None, block.rows[0]
        data = b"".join(part.data for run in of_rows(block.rows, [1]) for part in run.parts("hex"))
        problem = f"line {number}: the dump leaves lines out here, as the * tells; hexdump -v and od -v show all"
        yield _said(first.number, first.line, problem, data)

    def _show(self, block: Block) -> Iterator[Pasted]:
        """Yields the frame in the rows so far, as soon as it is complete."""
        reading = best(of_rows(block.rows, block.places)) if block.is_full() else None
        if reading is not None and reading.worth.is_whole and _is_sound(reading):
            block.shown = len(block.rows)
            yield from self._emit(block.rows, reading, None, block.above)

    def _close(self) -> Iterator[Pasted]:
        """Yields what the lines of the block have that was not shown yet."""
        block, self._block = self._block, None
        if block is None or block.is_shown:
            return
        rows, above = block.rows[block.shown :], block.above
        if block.is_too_long:
            problem = f"the bytes that start here have more than {MAX_COLLECTED // 1024} KiB of text"
            yield _said(rows[0].number, rows[0].line, problem)
            return
        found = _together(rows, block.places)
        if found is None and (found := _below_heading(rows)) is not None:
            yield from self._line(rows.pop(0), None, above)
        if found is not None:
            yield from self._emit(rows, *found, above)
        elif len(rows) > 1 and (said := spelt(of_rows(rows, block.places))) is not None:
            self._strange = self._strange or _said(rows[0].number, rows[0].line, said)
        elif block.shown:
            yield from _rest_of(block)
        else:
            for row in rows:
                yield from self._line(row, best(row.of_line()), above)

    def _line(self, row: Row, reading: Reading | None, above: Head) -> Iterator[Pasted]:
        """Yields what a line has by itself."""
        ended, self._ended = self._ended, None
        is_fine = reading is not None and reading.worth.is_whole and not may_be_mended(row.line)
        mended = None if is_fine else repaired(row)
        if mended is not None:
            yield self._mended(row, mended, above)
        elif reading is not None:
            yield from self._emit([row], reading, None, above)
        else:
            yield from self._unread(row, ended, above)

    def _unread(self, row: Row, ended: tuple[Reading, list[Row]] | None, above: Head) -> Iterator[Pasted]:
        """Yields what was meant as a frame in a line without one, or belongs to the frame that ended above."""
        said = spelt(row.of_line()) if _SPELT.search(row.line) else None
        one = near(row.of_line(), [row]) if said is None else None
        if one is None and ended is not None and (rest := _below(row, *ended)) is not None:
            yield rest
            return
        if one is None and row.elements and self._strange is None:
            self._strange = told(row) if said is None else _said(row.number, row.line, said)
        yield from self._emit([row], None, one, above)

    def _mended(self, row: Row, mended: Repaired, above: Head) -> Pasted:
        """Returns the frame of a line that something happened to: it is read with a note, or only told."""
        self._has_frame = True
        (part, frames), *_ = mended.reading.parts
        start, end = frames[0].start, frames[0].end
        piece = _piece(mended.reading.run, part, start, end, {row.number: mended.text}, above)
        if mended.is_read:
            return piece._replace(notes=(mended.says,), column=1, text=short(row.line, MAX_TEXT))
        slip = mended.slip
        first, known = mended.reading.run.elements[part.first :], b""
        if slip is not None:
            known = b"".join(BYTES[mended.reading.base][one.text] or b"" for one in first if one.end < slip.column)
        return piece._replace(problem=mended.says, slip=slip, data=known, text=short(row.line, MAX_TEXT))

    def _emit(self, rows: list[Row], reading: Reading | None, one: Near | None, above: Head) -> Iterator[Pasted]:
        """Yields the frames of a reading, or what was meant as one."""
        lines = {row.number: row.line for row in rows}
        found: list[Pasted] = []
        end = 0
        if reading is not None:
            pieces = [*self._pieces(reading, lines, above)]
            found = _once(pieces) if len(rows) == 1 < len(pieces) else [piece for piece, *_ in pieces]
            self._ended = (reading, rows) if reading.worth.is_whole else None
            *_, end = pieces[-1]
            one = _behind(rows, end, found)
        if one is not None:
            found = [*found, self._meant(one, lines, above, end)]
        yield from found
        self._has_frame = bool(found)
        if not found:
            self._before += [row.line for row in rows]
        elif rows[0].line[:1].strip():
            # What was said above is true for a line and for those below it that are indented.
            self._before.clear()

    def _meant(self, one: Near, lines: dict[int, str], above: Head, position: int) -> Pasted:
        """Returns what was meant as a frame, without the check sum that a program prints behind it."""
        check_sum = self._check_sum()
        is_sum = bool(check_sum) and one.data.endswith(check_sum) and one.problem is None
        piece = _piece(one.run, one.part, one.start, one.end - is_sum, lines, above, position)
        data = one.data[: len(one.data) - is_sum]
        return piece._replace(cut=one.cut, problem=one.problem, slip=one.slip, notes=one.notes, data=data)

    def _pieces(self, reading: Reading, lines: dict[int, str], above: Head) -> Iterator[tuple[Pasted, bool, int]]:
        """Yields the frames of a reading and what follows them below, each with more.

        That is whether a notation may begin there, and where the frame ends in its line.
        """
        run, position = reading.run, 0
        for part, frames in reading.parts:
            end, begins = 0, {0, *part.inside(run.breaks)}
            for start, end in _extents(reading, part, frames, self._check_sum(), lines):
                piece = _piece(run, part, start, end, lines, above, position)
                position = run.span(part, start, end)[1].end if len(lines) == 1 else 0
                yield piece, start in begins, position
            if end in part.inside(run.rows) and any(part.data[end:]):
                # A frame over several lines is complete without the rows below.
                yield _follows(run.elements[part.first + bisect_left(part.offsets, end) : part.last]), True, 0


def _may_have_bytes(line: str) -> bool:
    time = _TIME_FIRST.match(line)
    return _GATE.search(line, time.end() if time else 0) is not None or _SPELT.search(line) is not None


def _said(number: int, line: str, problem: str, data: bytes = b"") -> Pasted:
    return Pasted(data, number, short(line, MAX_TEXT), problem=problem)


def _piece(run: Run, part: Part, start: int, end: int, lines: dict[int, str], above: Head, position: int = 0) -> Pasted:
    """Returns bytes with what the text says of them from a position on."""
    first, last = run.span(part, start, end)
    data, line = part.data[start:end], lines[first.line]
    head = head_of(line[max(position, first.start - _MOST_AROUND) : first.start])
    text = line[first.start : last.end] if first.line == last.line else "\n".join([*lines.values()][:_MOST_SHOWN])
    direction = direction_of(data, head) or direction_of(data, above)
    unknown = tuple(_unknown(run, part, start, end, lines)) if run.has_unknown else ()
    time, column = head.time or above.time, first.start + 1
    return Pasted(
        data,
        first.line,
        short(text, MAX_TEXT),
        direction,
        time,
        column=column,
        unknown=unknown,
        label=head.label or above.label,
    )


def _unknown(run: Run, part: Part, start: int, end: int, lines: dict[int, str]) -> Iterator[Unknown]:
    """Yields the unknown bytes of a frame, with the expressions in their places."""
    for one, offset in zip(run.elements[part.first : part.last], part.offsets, strict=False):
        if one.kind == "unknown" and start <= offset < end:
            text = short(lines[one.line][one.start : one.end]) if one.text[0] == EXPRESSION else ""
            for at, is_unknown in enumerate(unknown_bytes(one)):
                if is_unknown:
                    yield Unknown(offset + at - start, one.line, one.start + 1, text)


def _behind(rows: list[Row], end: int, found: list[Pasted]) -> Near | None:
    """Returns what was meant as another frame behind those in a line; the line is read as if it began there."""
    row = rows[0]
    if len(rows) > 1 or not row.elements or row.elements[-1].start < end:
        return None
    rest = Row(" " * end + row.line[end:], row.number)
    one = near(rest.of_line(), [rest])
    return None if one is None or one.data in [piece.data for piece in found] else one


def _once(found: list[tuple[Pasted, bool, int]]) -> list[Pasted]:
    """Returns the pieces of a line without those that show one in front of them in another notation."""
    once: list[Pasted] = []
    places: dict[tuple[bytes, str | None], int] = {}
    for piece, may_be_other, _ in found:
        place = places.setdefault((piece.data, piece.direction), len(once))
        if place == len(once) or not may_be_other or (once[place].text == piece.text and not once[place].notes):
            once.append(piece)
        else:
            once[place] = once[place]._replace(notes=("the line shows this frame in several notations",))
    return once


def _is_done(reading: Reading | None, row: Row) -> bool:
    """Returns whether no line below can belong to the frames of a line."""
    if reading is None or not reading.worth.is_whole or row.is_offset:
        return False
    return not row.is_bare or _is_sound(reading)


def _is_sound(reading: Reading) -> bool:
    """Returns whether the last frame of a reading is not one that lacks bytes, whatever its length says."""
    part, frames = reading.parts[-1]
    fault = parse(part.data[frames[-1].start : frames[-1].end], strict=False).fault
    return fault is None or not fault.truncated


def _below_heading(rows: list[Row]) -> tuple[Reading | None, Near | None] | None:
    """Returns what the rows below the first have together, which may be a heading with a number in it."""
    is_heading = len(rows) > LEAST and rows[0].after != rows[1].after
    places = openings(rows[1]) if is_heading else []
    return _together(rows[1:], places) if places else None


def _together(rows: list[Row], places: list[int]) -> tuple[Reading | None, Near | None] | None:
    """Returns the frames of several rows, or what was meant as one; None if each row is to be read by itself."""
    reading = best(of_rows(rows, places)) if len(rows) > 1 else None
    if reading is not None and (reading.worth.is_whole or _spans_rows(reading, rows)):
        return reading, None
    one = near(of_rows(rows, places), rows) if len(rows) > 1 and _are_one(rows) else None
    return None if one is None or (not rows[0].is_offset and _is_each(rows)) else (None, one)


def _are_one(rows: list[Row]) -> bool:
    """Returns whether rows are a dump, or all as long."""
    return rows[0].is_offset or len({len(row.elements) for row in rows[:-1]}) == 1


def _is_each(rows: list[Row]) -> bool:
    """Returns whether some rows are frames by themselves."""
    readings = (best(row.of_line()) for row in rows)
    return any(reading is not None and reading.worth.natural for reading in readings)


def _spans_rows(reading: Reading, rows: list[Row]) -> bool:
    """Returns whether a frame is in more than one of some rows, or these are a dump."""
    spans = (reading.run.span(part, *frame[:2]) for part, frames in reading.parts for frame in frames)
    return rows[0].is_offset or any(first.line != last.line for first, last in spans)


def _is_meant(data: bytes) -> bool:
    return len(data) >= LOOKS and identify(data, missing=False).is_meant


def _extents(
    reading: Reading, part: Part, frames: list[FrameSpan], check_sum: bytes, lines: dict[int, str]
) -> Iterator[tuple[int, int]]:
    """Yields where the bytes of frames begin and end, and of what was meant as one between them.

    What follows a frame up to an edge or the next frame belongs to it: it is left over from a report, or too much.
    """
    data, at = part.data, 0
    for number, frame in enumerate(frames):
        if _is_meant(data[at : frame.start]):
            yield at, frame.start
        follows = len(data) if number + 1 == len(frames) else frames[number + 1].start
        at = frame.end
        if frame.is_natural and data[at:follows] and not _is_meant(data[at:follows]):
            at = _end_of_rest(reading, part, at, follows, lines)
            is_sum = data[frame.end : at] == check_sum or is_carried(data, frame.start, frame.end)
            at = frame.end if is_sum or frame.end in part.inside(reading.run.rows) else at
        yield frame.start, at


def _end_of_rest(reading: Reading, part: Part, at: int, follows: int, lines: dict[int, str]) -> int:
    """Returns where the bytes end that belong to the frame in front of them: at an edge, but for padding."""
    data, run = part.data, reading.run
    if reading.base == "words" and not any(data[at:follows]):
        return at
    if _is_rest(reading, part, at, lines):
        return follows
    place = bisect_left(run.breaks, part.first + bisect_left(part.offsets, at))
    ends = (part.offsets[place - part.first] for place in run.breaks[place : place + 1] if place < part.last)
    return min([*ends, follows])


_BESIDE = re.compile(r"[ \t]|,[ \t]?")
"""What is between bytes in one line; more blanks are in front of a column of text."""


def _is_rest(reading: Reading, part: Part, start: int, lines: dict[int, str]) -> bool:
    """Returns whether the elements from some byte on are all that follows in the last line, one blank or comma each."""
    rest = reading.run.elements[part.first + bisect_left(part.offsets, start) : part.last]
    is_bare = all(
        one.kind in ("digits", "marked") and _BESIDE.fullmatch(one.gap) and len(one.text) % 2 == 0 for one in rest
    )
    last = reading.run.elements[part.last - 1]
    return is_bare and not lines[last.line][last.end :].strip(AROUND)


def _follows(elements: Sequence[TextElement]) -> Pasted:
    """Returns what is said of bytes below a frame."""
    count = sum(len(one.text.removeprefix("0x")) // 2 or 1 for one in elements)
    follow = "1 byte follows" if count == 1 else f"{count} bytes follow"
    shown = " ".join(one.text for one in elements[:_MOST_SHOWN])
    problem = f"{follow} the frame that ends in line {elements[0].line - 1}: {short(shown)}"
    return _said(elements[0].line, shown, problem)


def _rest_of(block: Block) -> Iterator[Pasted]:
    """Yields what is said of the rows below the frame that was shown, but for zeros."""
    rest = block.rest()
    if any(one.text.strip("0x") for one in rest):
        yield _follows(rest)


def _below(row: Row, reading: Reading, rows: list[Row]) -> Pasted | None:
    """Returns the bytes in a row below a frame that is complete without them, but is written like them."""
    ended, first = rows[-1], reading.run.elements[reading.parts[0][0].first]
    place = next((at for at, one in enumerate(ended.elements) if one.start >= first.start), 0)
    if row.front(place) != ended.front(place):
        return None
    is_dump = not row.after.strip(AROUND)
    return (
        _follows(row.elements[place:]) if is_dump and _are_like(row.elements[place:], ended.elements[place:]) else None
    )


def _are_like(elements: Sequence[TextElement], others: Sequence[TextElement]) -> bool:
    """Returns whether elements are written like others, and are hardly a word or zeros."""
    (widths, gaps), (usual, between) = (
        ({len(one.text) for one in some}, {shape(one.gap) for one in some[1:]}) for some in (elements, others)
    )
    is_zero = not "".join(one.text for one in elements).strip("0x, ")
    return not is_zero and widths <= usual and gaps <= between
