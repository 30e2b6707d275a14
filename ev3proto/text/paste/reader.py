"""Lines of text -> the pieces in them.

A line whose values are whole frames is done. One that may be the first of several opens a block, which takes the lines
that look like it; at its end the frames in all of them are looked for, and otherwise in each.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import chain

from ev3proto.schema.frame import parse
from ev3proto.schema.header import frame_end
from ev3proto.semantics.identify import identify
from ev3proto.text.paste.frames import is_carried, is_whole
from ev3proto.text.paste.heads import NO_HEAD, Head, announced, direction_of, head_of
from ev3proto.text.paste.near import Near, near, spelt, told
from ev3proto.text.paste.pieces import LEAST, MAX_COLLECTED, MAX_LINE, MAX_TEXT, Pasted, Unknown, check_text, short
from ev3proto.text.paste.rows import AROUND, Row, of_line, of_rows, openings
from ev3proto.text.paste.sequences import Part, Reading, Values, best
from ev3proto.text.paste.strangers import strange_text
from ev3proto.text.paste.tokens import EXPRESSION, Token, clean, unknown_bytes

_GATE = re.compile(
    r"""
    # A value from 0 to 3, the second byte of every frame; or a group of digits with it, or that begins with it.
    (?<![a-zA-Z\d])(?<!\d\.)(?:0[xX]|&[hH]|\$)?0{0,3}[0-3](?![\da-fA-FxX]|\.\d) | (?<!\w)(?:0[xX])?[\da-fA-F]{2}0[0-3]
    (?=(?:[\da-fA-F]{4})?(?!\w)|[\da-fA-F]{6}|[xXmM]{2}) | (?<!\w)(?:0[xX])?0[0-3][\da-fA-F]{8}
  | 0x0[0-3]0x | [\da-fA-F]{2}\.0[0-3]\.
    # A download, which may be longer than other frames: its type and its command.
  | [\da-fA-F]{2}[\W_]?[08]1[\W_]?9[\da-fA-F]
    # The characters of digits, in hex and decimal.
  | (?:[2-7][\da-fA-F][\W_]{0,2}(?:0x)?){8} | (?:(?:3[2-9]|[4-9]\d|1[01]\d|12[0-6])[\s,]{1,2}){8}
    # An escape, the lesson's mark, an unknown byte, base64.
  | \\ | 0[xX]\| | (?<!\w)(?:[xX]{2}|MM) | (?<![\w+/-])[\w+/-][AQgw][A-P][\w+/-]{5}
    """,
    re.VERBOSE,
)
"""What a line with a frame, or with its start, has."""

_TIME_FIRST = re.compile(r"(?:\W?(?:[\d/-]+[T ])?\d\d:\d\d:\d\d(?!:)\S*\s+(?:\d{3,5}\s+\d{3,5}\s)?)?")
"""The date and the time at the start of a line, and the numbers of a process and a thread after them."""
_SHORT = 40
"""Characters of a line that may have just one of the bytes of a frame."""
_CHECK_SUM = re.compile(r"\s+(?:FCS: 0x|RFCOMM.* fcs 0x)([0-9a-fA-F]{2})\b")
_AGAIN = re.compile(r"\s*\+\d+ \| | \| 0[0-9a-f]{4}  ")
"""Lines that show the frame above them again: `check` under a finding, `strace -e write` below a call."""
_MOST_AROUND = 2000
_MOST_EMPTY = 3
_MOST_GAP = 40
_MOST_BEFORE = 16
_MOST_SHOWN = 20
_MOST_STRANGE = 1000
"""Lines in which something else than a frame is looked for, as long as there is none."""
_FULL_ROW = 16
_MOST_MISSING = 8


class Block:
    """Lines that look alike, and may have a frame together."""

    def __init__(self, row: Row, places: list[int], above: Head) -> None:
        self.rows, self.places, self.above = [row], places, above
        self.size, self.empty, self.in_comment = 0, 0, _is_open_comment(row.line)
        self.data = bytearray(_data_of(row, row, places[0]))
        self.shown = 0  # rows of a frame that was complete before the next line came
        self._was_full = False

    def values_of(self, row: Row) -> list[Token]:
        """Returns the values of a row that may be bytes; the last row of a dump has only its offset."""
        place = self.places[0]
        return row.tokens[place if self.is_dump else row.first(self.rows[0], place) or 0 :]

    def is_full(self) -> bool:
        """Returns whether the last row completed a frame, once."""
        is_full = is_whole(self.data) and not self.rows[-1].is_open
        was_full, self._was_full = self._was_full, self._was_full or is_full
        return is_full and not was_full

    @property
    def is_dump(self) -> bool:
        """Whether an offset is in front of the rows."""
        return self.rows[0].is_offset

    @property
    def _has_index(self) -> bool:
        """Whether rows count from zero."""
        first, *others = (row.tokens[0].text for row in self.rows[:2])
        return first == "0" and others == ["1"] and len(self.rows[0].tokens) > 1

    @property
    def waits(self) -> bool:
        """Whether something in it was not shown yet; a list or a comment that is open is not complete in any case."""
        return self.shown < len(self.rows) and not self.in_comment and not self.rows[-1].is_open

    def take(self, line: str, number: int) -> bool:
        """Adds a line. Returns whether it belongs to the block."""
        text = clean(line)
        if self.in_comment:
            end = text.find("*/") + 2
            text = " " * end + text[end:] if end > 1 else ""
            self.in_comment = end < 2
        last = self.rows[-1]
        row = Row(text, number, is_inside=last.is_open)
        if row.wide is not None and any(token.kind == "string" for token in row.wide.tokens):
            row = row.wide
        if not row.tokens:
            self.empty += 1
            is_empty = not row.after.strip() and (self.empty <= _MOST_EMPTY or last.is_open)
            return self.in_comment or is_empty or (last.is_open and text.lstrip()[:1] in ("#", "*", ";"))
        data = _data_of(row, self.rows[0], self.places[0])
        if self.is_dump and len(row.tokens[0].text) != len(self.rows[0].tokens[0].text):
            return False
        if not row.follows(last, self.places) or self._begins_anew(row, data):
            return False
        self.data += data
        self.size += len(line)
        if self.size <= MAX_COLLECTED:
            self.rows.append(row)
        self.empty, self.in_comment = 0, _is_open_comment(text)
        return True

    def _begins_anew(self, row: Row, data: bytes) -> bool:
        """Returns whether a row is a frame by itself, right or wrong, that the rows so far do not need."""
        if self._has_index and row.tokens[0].text == self.rows[0].tokens[0].text:
            return True
        if self.is_dump or row.tokens[-1].end - row.tokens[0].start < 2 * LEAST:
            return False
        if row.front(0) == self.rows[0].front(0) != self.rows[-1].front(0):
            return True
        size = len(self.data) + len(data)
        is_needed = size <= (frame_end(self.data) or 0)
        alone = best(row.sequences)
        if alone is not None and alone.worth.is_whole:
            return not is_needed or not row.is_bare or len(data) != size // (len(self.rows) + 1)
        return not is_needed and frame_end(data) is not None and identify(data, missing=False).is_meant


def _data_of(row: Row, first: Row, place: int) -> bytes:
    """Returns the bytes of a row of a block, in its likeliest base."""
    start = row.first(first, place)
    values = Values(row.tokens[start or 0 :])
    return next((part.data for part in values.parts(values.bases[0])), b"")


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
                self._strange = Pasted(b"", number, short(line, MAX_TEXT), problem=said)
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
        if len(line) > MAX_LINE:
            yield from self._close()
            problem = f"the line has more than {MAX_LINE} characters and was not read"
            yield Pasted(b"", number, short(line, MAX_TEXT), problem=problem)
            return
        if self._block is not None:
            if line.strip() == "*" and self._block.is_dump:
                yield from self._left_out(number)
                return
            if self._block.take(line, number):
                yield from self._show(self._block)
                return
            yield from self._close()
        is_again = _AGAIN.match(line) is not None and (self._has_frame or line.lstrip()[:1] == "+")
        is_long = len(line) > _SHORT and self._ended is None  # bytes that are too many may be any
        if is_again or (is_long and _GATE.search(line, _end_of_time(line)) is None):
            self._has_frame = False
            self._before.append(line)
            return
        row = Row(clean(line), number)
        reading = row.reading
        is_done = not row.tokens or len(line) > MAX_COLLECTED or _is_done(reading, row)
        if not is_done and (places := openings(row)):
            self._block = Block(row, places, self._said())
        else:
            yield from self._line(row, reading, self._said())

    def _said(self) -> Head:
        """Returns what the lines above say: the last one, or those above it where these are indented."""
        for line in reversed(self._before):
            said = announced(line)
            if said != NO_HEAD:
                return said
            if line[:1].strip():
                break
        return NO_HEAD

    def _check_sum(self) -> bytes:
        """Returns the check sum behind the bytes of RFCOMM, which the lines above tell."""
        found = next((found for line in self._before if (found := _CHECK_SUM.match(line))), None)
        return b"" if found is None else bytes.fromhex(found[1])

    def _left_out(self, number: int) -> Iterator[Pasted]:
        """Yields the rows of a dump in front of a `*`."""
        block, self._block = self._block, None
        assert block is not None
        first = block.rows[0]
        data = b"".join(part.data for values in of_rows(block.rows, [1]) for part in values.parts("hex"))
        problem = f"line {number}: the dump leaves lines out here, as the * tells; hexdump -v and od -v show all"
        yield Pasted(data, first.number, short(first.line, MAX_TEXT), problem=problem)

    def _show(self, block: Block) -> Iterator[Pasted]:
        """Yields the frame in the rows so far, as soon as it is complete."""
        reading = best(of_rows(block.rows, block.places)) if block.is_full() else None
        if reading is not None and reading.worth.is_whole and _is_sound(reading):
            block.shown = len(block.rows)
            yield from self._emit(block.rows, reading, None, block.above)

    def _close(self) -> Iterator[Pasted]:
        """Yields what the lines of the block have that was not shown yet."""
        block, self._block = self._block, None
        if block is None or block.shown == len(block.rows):
            return
        rows, above = block.rows[block.shown :], block.above
        if block.size > MAX_COLLECTED and _is_long(block):
            problem = f"the bytes that start here have more than {MAX_COLLECTED // 1024} KiB of text"
            yield Pasted(b"", rows[0].number, short(rows[0].line, MAX_TEXT), problem=problem)
            return
        found = _together(rows, block.places) if len(rows) > 1 else None
        if found is None and len(rows) > LEAST and rows[0].after != rows[1].after and (places := openings(rows[1])):
            # The first row may be a heading with a number in it.
            found = _together(rows[1:], places)
            yield from self._line(rows.pop(0), None, above) if found is not None else ()
        if found is not None:
            yield from self._emit(rows, *found, above)
            return
        if len(rows) > 1 and (said := spelt(of_rows(rows, block.places))) is not None:
            self._strange = self._strange or Pasted(b"", rows[0].number, short(rows[0].line, MAX_TEXT), problem=said)
            return
        if block.shown:
            tokens = [token for row in rows for token in block.values_of(row)]
            if any(token.text.strip("0x") for token in tokens):
                yield _follows(tokens)
            return
        for row in rows:
            yield from self._line(row, row.reading, above)

    def _line(self, row: Row, reading: Reading | None, above: Head) -> Iterator[Pasted]:
        """Yields what a line has by itself."""
        ended, self._ended = self._ended, None
        said = spelt(of_line(row)) if reading is None and row.tokens else None
        one = near(of_line(row), [row]) if reading is None and said is None else None
        if reading is None and one is None and ended is not None and (rest := _below(row, *ended)) is not None:
            yield rest
            return
        if reading is None and one is None and row.tokens and (said := said or told(row)) is not None:
            self._strange = self._strange or Pasted(b"", row.number, short(row.line, MAX_TEXT), problem=said)
        yield from self._emit([row], reading, one, above)

    def _emit(self, rows: list[Row], reading: Reading | None, one: Near | None, above: Head) -> Iterator[Pasted]:
        """Yields the frames of a reading, or what was meant as one."""
        lines = {row.number: row.line for row in rows}
        found: list[Pasted] = []
        if reading is not None:
            found = list(self._pieces(reading, lines, above))
            self._ended = (reading, rows) if reading.worth.is_whole else None
        if one is not None:
            one = _without_sum(one, self._check_sum())
            piece = self._piece(one.values, one.part, one.start, one.end, lines, above)
            found.append(
                piece._replace(cut=one.cut, problem=one.problem, slip=one.slip, notes=one.notes, data=one.data)
            )
        yield from _once(found, rows[0].line) if len(found) > 1 and len(rows) == 1 else found
        self._has_frame = bool(found)
        if not found:
            self._before += [row.line for row in rows]
        elif rows[0].line[:1].strip():
            # What was said above is true for a line and for those below it that are indented.
            self._before.clear()

    def _pieces(self, reading: Reading, lines: dict[int, str], above: Head) -> Iterator[Pasted]:
        """Yields the frames of a reading, and what follows them in the lines below."""
        position = 0
        for part in reading.parts:
            end = 0
            for start, end in _extents(reading, part, self._check_sum(), lines):
                yield self._piece(reading.values, part, start, end, lines, above, position)
                position = reading.values.span(part, start, end)[1].end if len(lines) == 1 else 0
            if rest := _rest(reading.values, part, end):
                yield rest

    def _piece(
        self, values: Values, part: Part, start: int, end: int, lines: dict[int, str], above: Head, position: int = 0
    ) -> Pasted:
        """Returns bytes with what the text says of them from a position on."""
        first, last = values.span(part, start, end)
        data, line = part.data[start:end], lines[first.line]
        head = head_of(line[max(position, first.start - _MOST_AROUND) : first.start])
        is_one = first.line == last.line
        text = line[first.start : last.end] if is_one else "\n".join([*lines.values()][:_MOST_SHOWN])
        direction = direction_of(data, head) or direction_of(data, above)
        unknown = tuple(_unknown(values, part, start, end, lines)) if values.has_unknown else ()
        return Pasted(
            data,
            first.line,
            short(text, MAX_TEXT),
            direction,
            head.time or above.time,
            column=first.start + 1,
            unknown=unknown,
            label=head.label or above.label,
        )


def _end_of_time(line: str) -> int:
    found = _TIME_FIRST.match(line)
    return found.end() if found else 0


def _without_sum(one: Near, check_sum: bytes) -> Near:
    """Returns bytes without the check sum of RFCOMM behind them."""
    has_sum = bool(check_sum) and one.data.endswith(check_sum) and one.problem is None
    return one._replace(data=one.data[:-1], end=one.end - 1) if has_sum else one


def _is_done(reading: Reading | None, row: Row) -> bool:
    """Returns whether no line below can belong to the frames of a line."""
    if reading is None or not reading.worth.is_whole or row.is_offset or (row.tokens and row.is_open):
        return False
    if len(row.tokens) < LEAST or not row.is_bare:
        return True
    return _is_sound(reading)


def _is_sound(reading: Reading) -> bool:
    """Returns whether the last frame of a reading is not one that lacks bytes, whatever its length says."""
    part = reading.parts[-1]
    fault = parse(part.data[part.frames[-1].start : part.frames[-1].end], strict=False).fault
    return fault is None or not fault.truncated


def _together(rows: list[Row], places: list[int]) -> tuple[Reading | None, Near | None] | None:
    """Returns the frames of several rows, or what was meant as one; None if each row is to be read by itself."""
    reading, are_one = best(of_rows(rows, places)), _are_one(rows, places[0])
    if reading is not None and (reading.worth.is_whole or (are_one and _spans_rows(reading, rows))):
        return reading, None
    one = near(of_rows(rows, places), rows) if are_one else None
    if one is None or rows[0].is_offset:
        return None if one is None else (None, one)
    first, last = one.values.span(one.part, one.start, one.end)
    is_row = first.line == last.line and one.problem is None and not one.cut
    is_each = is_row or any(row.reading is not None and row.reading.worth.natural for row in rows)
    return None if is_each else (None, one)


def _spans_rows(reading: Reading, rows: list[Row]) -> bool:
    """Returns whether a frame is in more than one of some rows, which are not a dump."""
    spans = (reading.values.span(part, *frame[:2]) for part in reading.parts for frame in part.frames)
    return rows[0].is_offset or any(first.line != last.line for first, last in spans)


def _are_one(rows: list[Row], place: int) -> bool:
    """Returns whether rows are the bytes of one thing: a dump, a list, a byte in each, or rows of the same length."""
    first = rows[0]
    if first.is_offset or first.is_open or all(len(row.tokens) == len(first.tokens) <= 3 for row in rows):
        return True
    starts = [row.first(first, place) for row in rows]
    is_literal = any(len(row.tokens) == 1 for row in rows[:-1])
    sizes = [len(row.tokens[-1].text if is_literal else row.tokens) for row in rows]
    return None not in starts and len({*sizes[:-1]}) == 1 and sizes[-1] <= sizes[0]


def _is_long(block: Block) -> bool:
    """Returns whether a frame may begin in rows of which there are too many."""
    return any(
        0 < (frame_end(part.data) or 0) <= _MOST_MISSING * len(part.data)
        for values in of_rows(block.rows, block.places)
        for base in values.bases[:2]
        for part in values.parts(base)
        if part.first == 0 and len(part.data) >= LEAST
    )


def _extents(reading: Reading, part: Part, check_sum: bytes, lines: dict[int, str]) -> Iterator[tuple[int, int]]:
    """Yields where the bytes of frames begin and end, and of what was meant as one between them.

    What follows a frame up to an edge or the next frame belongs to it: it is left over from a report, or too much.
    """
    data, at = part.data, 0
    breaks = (
        reading.values.edges(part).breaks if data[part.frames[-1].end :].strip(b"\0") or len(part.frames) > 1 else []
    )
    starts = reading.values.row_offsets(part)
    for number, frame in enumerate(part.frames):
        if identify(data[at : frame.start], whole=number > 0, missing=False).is_meant:
            yield at, frame.start
        follows = part.frames[number + 1].start if number + 1 < len(part.frames) else len(data)
        at = frame.end
        if frame.is_natural and not identify(data[at:follows], whole=number + 1 < len(part.frames)).is_meant:
            if not at < follows == len(data) or not _is_rest(reading, part, at, lines):
                at = min([*breaks[(place := bisect_left(breaks, at)) : place + 1], follows])
            else:
                at = follows
            is_padding = reading.base == "words" and not any(data[frame.end : at])
            is_sum = data[frame.end : at] == check_sum or is_carried(data, frame.start, frame.end)
            at = frame.end if is_padding or is_sum else at
            at = frame.end if frame.end in starts else at
        yield frame.start, at
    if identify(data[at:], whole=False, missing=False).is_meant:
        yield at, len(data)


def _is_rest(reading: Reading, part: Part, start: int, lines: dict[int, str]) -> bool:
    """Returns whether the values from some byte on are all that follows in the last line."""
    last = reading.values.tokens[part.last - 1]
    return reading.values.is_rest(part, start) and not lines[last.line][last.end :].strip(AROUND)


def _rest(values: Values, part: Part, end: int) -> Pasted | None:
    """Returns the bytes in the rows below a frame over several lines, which is complete without them."""
    tokens = values.tokens[part.first + bisect_left(part.offsets, end) : part.last]
    if end not in values.row_offsets(part) or not any(part.data[end:]):
        return None
    return _follows(tokens)


def _follows(tokens: Sequence[Token]) -> Pasted:
    """Returns what is said of bytes below a frame."""
    count = sum(len(token.text.removeprefix("0x")) // 2 or 1 for token in tokens)
    follow = "1 byte follows" if count == 1 else f"{count} bytes follow"
    shown = " ".join(token.text for token in tokens[:_MOST_SHOWN])
    problem = f"{follow} the frame that ends in line {tokens[0].line - 1}: {short(shown)}"
    return Pasted(b"", tokens[0].line, short(shown, MAX_TEXT), problem=problem)


def _below(row: Row, reading: Reading, rows: list[Row]) -> Pasted | None:
    """Returns the bytes in a row below a frame that is complete without them, but is written like them."""
    ended = rows[-1]
    first = reading.values.tokens[reading.parts[0].first]
    starts = [token.start >= first.start for token in ended.tokens] if len(rows) == 1 else []
    place = starts.index(True) if True in starts else 0
    if row.number != ended.number + 1 or len(row.tokens) <= place or row.front(place) != ended.front(place):
        return None
    is_dump = (row.is_bare or row.front(place).endswith((":", ">"))) and not row.after.strip(AROUND)
    return _follows(row.tokens[place:]) if is_dump and _are_like(row.tokens[place:], ended.tokens[place:]) else None


def _are_like(tokens: Sequence[Token], others: Sequence[Token]) -> bool:
    """Returns whether values are written like others, and are hardly a word or zeros."""
    widths, usual = ({len(token.text) for token in some} for some in (tokens, others))
    is_zero = not "".join(token.text for token in tokens).strip("0x, ")
    if is_zero or len(tokens) > len(others) or any(token.text.isupper() and len(token.text) > 4 for token in tokens):
        return False
    return widths <= usual or (1 in usual and max(widths) <= max(usual))


_INTRODUCED = re.compile(r"[\"'`(<=\[]\s*$|[^\W\d]:?\s+$")
"""What is in front of bytes that are not the rest of those before them."""


def _once(found: list[Pasted], line: str) -> list[Pasted]:
    """Returns the pieces of a line without those that show one in front of them in other letters, which gets a note."""
    kept: dict[tuple[bytes, str | None], int] = {}
    pieces: list[Pasted] = []
    for piece in found:
        place = kept.setdefault((piece.data, piece.direction), len(pieces))
        is_new = place == len(pieces) or (pieces[place].text == piece.text and not pieces[place].notes)
        if is_new or _INTRODUCED.search(line[max(0, piece.column - _MOST_GAP) : piece.column - 1]) is None:
            pieces.append(piece)
        else:
            pieces[place] = pieces[place]._replace(notes=("the line shows this frame in several notations",))
    return pieces


def _unknown(values: Values, part: Part, start: int, end: int, lines: dict[int, str]) -> Iterator[Unknown]:
    """Yields the unknown bytes of a frame, with the expressions in their places."""
    for token, offset in zip(values.tokens[part.first : part.last], part.offsets, strict=False):
        if token.kind != "unknown" or not start <= offset < end:
            continue
        is_expression = token.text[0] == EXPRESSION
        text = short(lines[token.line][token.start : token.end]) if is_expression else ""
        for at, is_unknown in enumerate(unknown_bytes(token)):
            if is_unknown:
                yield Unknown(offset + at - start, token.line, token.start + 1, text)
