"""Lines of text to frames, and to what looks like one.

Lines are looked at one by one. A run that reaches to the end of its line and is not a frame yet is kept: the next
lines may continue it, and are read as if they were joined.
"""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from typing import NamedTuple

from ev3proto.schema.header import frame_size, may_have_length
from ev3proto.tables.frame import MAX_FRAME
from ev3proto.text.paste.cleaning import clean, repeated_rows, without_columns, without_marks, without_remarks
from ev3proto.text.paste.pieces import (
    LEAST,
    MAX_COLLECTED,
    MAX_LINE,
    MAX_TEXT,
    NO_HEAD,
    Direction,
    Head,
    Pasted,
    announced,
    check_text,
    direction_of,
    head_before,
    short,
)
from ev3proto.text.paste.readings import (
    HASHES,
    Stretch,
    bare_reason,
    boundaries,
    changes_in,
    is_one_frame,
    likely_bytes,
    may_begin,
    readings,
    reason,
    tried,
    whole_bytes,
)
from ev3proto.text.paste.values import Run, Style, Value, listed, runs, without_indexes

_MAY_HAVE = re.compile(r"^\s*[a-fA-F]\s*$|[0-9\\]|[A-Za-z0-9+/]{8}|\b[a-fA-F]{2}\b")
# What `check` prints under a finding: the frame itself is above it.
_EXCERPT = re.compile(r"\s*\+\d+ \| ")
_INDEX_ALONE = re.compile(r"\s*\[\d{1,5}\]\s?=>\s*")
_CHECK_SUM = re.compile(r"^\s+FCS: 0x([0-9a-fA-F]{2})\b")
_DIGITS = re.compile(r"[0-9]+|0x[0-9a-fA-F]+")
_PREFIX_ENDS = re.compile(r"(?:[)\]>]+:?|:)\s+")
_STRACE_DUMP = re.compile(r" \| 0[0-9a-f]{4}  ")
"""A row of what `strace -e write` prints below a call which has the same bytes as a string."""
_MOST_STARTS = 8
_MOST_EMPTY = 3
_MOST_BEFORE = 4
_MOST_SHOWN = 20
_MOST_PREFIX = 3
_MOST_PARTS = 32


class Row(NamedTuple):
    """A line that may be a part of a frame.

    number  its number in the text
    line    the line
    run     the part of it that may belong to a frame over several lines
    listed  the same without an index
    said    what the line above says of its bytes
    """

    number: int
    line: str
    run: Run | None = None
    listed: Run | None = None
    said: Head = NO_HEAD


@dataclass(slots=True)
class Track:
    """The runs of consecutive rows, and their bytes by reading: those that fit all of the values."""

    runs: list[Run] = field(default_factory=list)
    numbers: list[int] = field(default_factory=list)
    data: dict[str, bytearray] | None = None
    was_padded: bool = False

    def take(self, run: Run | None, number: int) -> None:
        """Adds a run; without one no reading fits any more."""
        if self.data is None:
            self.data = {name: bytearray() for name in (readings(run) if run is not None else ())}
        for name in list(self.data):
            part = None if run is None else whole_bytes(run, name)
            if part is None:
                del self.data[name]
            else:
                self.data[name] += part
        if run is not None:
            self.runs.append(run)
            self.numbers.append(number)

    def is_complete(self) -> bool:
        """Whether some reading has as many bytes as its length field says."""
        begun = [data for data in (self.data or {}).values() if len(data) >= LEAST and may_have_length(data)]
        if any(frame_size(data) == len(data) for data in begun):
            return True
        # Zeros after a frame are padding, unless another reading takes them for a part of its frame.
        is_padded = bool(begun) and not self.was_padded and all(_is_padded(data) for data in begun)
        self.was_padded = self.was_padded or is_padded
        return is_padded

    def joined(self, *, is_array: bool) -> Run:
        """Returns the rows as one run."""
        run = Run([], [], is_array=is_array, check_sum=self.runs[-1].check_sum)
        for number, row in zip(self.numbers, self.runs, strict=True):
            run.values += row.values
            run.gaps += ["\n" if run.gaps else "", *row.gaps[1:]]
            run.lines += [number] * len(row.values)
        return run


def _is_padded(data: bytearray) -> bool:
    end = frame_size(data)
    return may_have_length(data) and end <= len(data) and not any(data[end:])


@dataclass(slots=True)
class Group:
    """Rows that the next line may continue.

    tracks      their runs, as they are and without indexes
    looks       what the first of them looks like by itself
    has_commas  a comma ends each row but the last
    has_gap     a `*` replaces rows like the one before it, as many as the next offset says
    """

    was_opened: bool
    depth: int
    looks: Pasted | None
    in_comment: bool
    rows: list[Row] = field(default_factory=list)
    tracks: tuple[Track, Track] = field(default_factory=lambda: (Track(), Track()))
    last: Row = field(default_factory=lambda: Row(0, ""))
    size: int = 0
    has_commas: bool = True
    has_gap: bool = False
    empty: int = 0

    @property
    def is_array(self) -> bool:
        """Whether the rows are one list in brackets, separated by commas."""
        return self.was_opened and self.has_commas

    def add(self, row: Row) -> None:
        """Adds another row."""
        self.rows.append(row)
        if row.run is not None:
            self.has_commas = self.has_commas and (self.last.run is None or self.last.run.has_comma)
            self.last, self.empty = row, 0
            self.tracks[0].take(row.run, row.number)
            self.tracks[1].take(row.listed, row.number)

    @property
    def live(self) -> list[Track]:
        """The tracks that some reading fits, the likelier first."""
        return [track for track in self.tracks[::-1] if track.data]

    def data(self) -> list[bytearray]:
        """Returns the bytes of all readings."""
        return [data for track in self.live for data in (track.data or {}).values()]

    def fill(self, line: str) -> bool:
        """Adds the rows that a `*` replaces; tells whether the offset in the line says how many they are."""
        self.has_gap = False
        last = self.last
        assert last.run is not None
        for name, data in (self.tracks[0].data or {}).items():
            size = len(whole_bytes(last.run, name) or b"")
            count = repeated_rows(last.line, line, size, len(data))
            if count is not None and len(data) + count * size <= MAX_FRAME + size:
                for _ in range(count):
                    self.add(last)
                return True
        return False


class Reader:
    """Reads the frames of a text, and says of the rest what looks like one."""

    def __init__(self) -> None:
        self._group: Group | None = None
        self._opens = self._was_opened = self._has_frame = False
        self._said = NO_HEAD
        self._check_sum: int | None = None
        self._parts: deque[tuple[Row, bytes]] = deque(maxlen=_MOST_PARTS)
        self._found: list[Pasted] = []

    def read(self, lines: Iterable[str]) -> Iterator[Pasted]:
        """Yields all pieces in the lines, in their order."""
        for number, line in enumerate(lines, 1):
            check_text(line)
            if len(line) > MAX_LINE:
                self._close()
                problem = f"the line has more than {MAX_LINE} characters and was not read"
                self._found.append(Pasted(b"", number, short(line, MAX_TEXT), problem=problem))
            else:
                self._take(line.rstrip("\r\n"), number)
            yield from self._found
            self._found.clear()
        self._close()
        yield from self._found

    def _take(self, line: str, number: int) -> None:
        if self._group is not None:
            if self._continues(self._group, line, number):
                self._finish(self._group)
                return
            self._close()
        if self._has_frame and _STRACE_DUMP.match(line):
            return
        self._has_frame = False
        said = self._said
        self._was_opened, self._opens = self._opens, line.rstrip().endswith(("[", "{", "("))
        if _MAY_HAVE.search(line) is not None and _EXCERPT.match(line) is None:
            self._first(line, number)
        else:
            self._listen(line)
            if line.strip():
                self._parts.clear()
        if self._said is said and line[:1].strip():
            # What was said of the bytes is true for the line after it, and for those that are indented.
            self._said, self._check_sum = NO_HEAD, None

    def _emit(self, pieces: list[Pasted]) -> bool:
        """Adds frames to what was found; tells whether there are any."""
        if pieces:
            self._parts.clear()
            self._found += pieces
            self._has_frame = True
        return bool(pieces)

    def _first(self, line: str, number: int) -> None:
        """Reads a line that does not continue others."""
        whole = clean(line)
        row, in_comment, found = self._row(line, number, whole, None)
        looks = None
        for attempt in self._attempts(row, whole, found):
            pieces, why = _frames(row, attempt)
            looks = looks or why
            if self._emit(pieces):
                return
        self._listen(line)
        run = row.run
        if run is not None and run.is_tail and _may_continue(run):
            depth = run.depth + self._was_opened
            self._group = Group(run.opened > 0 or self._was_opened, depth, looks, in_comment, size=len(line))
            self._group.add(row)
        else:
            self._left([row], {number: looks})

    def _attempts(self, row: Row, whole: str, found: list[Run]) -> Iterator[list[Run]]:
        """Yields the runs of a line as they are, without its remarks, and whatever is between its values."""
        plain = runs(without_columns(whole))
        for run in plain:
            run.check_sum = self._check_sum
        values = _all(plain)
        numbered = without_indexes(values, 0, LEAST)
        yield [listed(numbered)] if numbered is not None else plain
        if row.run is not None and not any(run.values == row.run.values for run in plain):
            yield [row.run] if len(row.run.values) == len(_all(found)) else [*found[:-1], row.run]
        # The same words between the values, or the name of each part in front of it or after it.
        marked = [value for value in values if value.style is Style.MARKED]
        if len(plain) > 1 or len(marked) not in (0, len(values)):
            # Zeros after a word may be an offset, or the bytes that ask for no memory.
            every = _all(runs(whole))
            starts = [group[start:] for group in (values, every) for start in range(_MOST_BEFORE)]
            for some in (marked, *starts):
                if len(some) >= LEAST - 1 and Style.STRING not in {value.style for value in some}:
                    best = tried(run := listed(some))[0]
                    if best.is_whole and is_one_frame(best.stretches[0].data):
                        yield [run]

    def _listen(self, line: str) -> None:
        """Remembers what a line without frames says of the frames that follow."""
        check_sum = _CHECK_SUM.match(line)
        if check_sum is not None:
            self._check_sum = int(check_sum[1], 16)
        self._said = announced(line) or self._said

    def _row(self, line: str, number: int, whole: str, group: Group | None) -> tuple[Row, bool, list[Run]]:
        """Returns a line as a part of a frame over several lines, whether a comment continues, and its runs."""
        is_inside = group is not None and group.in_comment
        bare, in_comment = without_remarks(whole if is_inside else without_marks(whole), is_inside=is_inside)
        bare = without_columns(bare, {len(data) for data in group.data()} if group is not None else ())
        is_text = group is not None and group.last.run is not None and group.last.run.is_text
        found = runs(bare, is_text=is_text)
        if not found:
            return Row(number, line), in_comment, found
        every = _all(found)
        marked = [value for value in every if value.style is Style.MARKED]
        index = 0 if group is None else len(group.tracks[1].runs)
        values = marked if 0 < len(marked) < len(every) else without_indexes(every, index, 1)
        run = _without_prefix(found[-1], bare)
        run.check_sum = self._check_sum
        is_call = len(run.values) == 1 or (not run.is_head and len(run.values) < LEAST)
        if is_call and run.opened > 0 >= run.depth:
            # The brackets of a call that has one part of the bytes, as in `data.Add(0x0F);`.
            run = replace(run, opened=0, depth=0)
        return Row(number, line, run, None if values is None else listed(values), self._said), in_comment, found

    # Lines that belong together

    def _continues(self, group: Group, line: str, number: int) -> bool:
        """Takes a line that continues the rows; tells whether it did."""
        last = group.last.run
        assert last is not None
        if line.strip() == "*" and not group.has_gap:
            group.has_gap = True
            group.add(Row(number, line))
            return True
        if group.has_gap and not group.fill(line):
            return False
        if _INDEX_ALONE.fullmatch(line):
            group.add(Row(number, line))
            return True
        whole = clean(line, has_cells=last.is_text)
        row, in_comment, _ = self._row(line, number, whole, group)
        if row.run is None:
            # Only a list with commas continues after a comment, and after more than some empty lines.
            group.empty += 1
            has_begun = any(len(data) >= LEAST for data in group.data())
            is_empty = has_begun and not whole.strip() and group.empty <= _MOST_EMPTY
            if not group.in_comment and not last.has_comma and not is_empty:
                return False
            if without_columns(without_remarks(without_marks(whole), is_inside=group.in_comment)[0], {0}).strip():
                return False
        elif not _follows(group.last, row) or not group.data() or _stands_alone(group, row.run):
            return False
        group.size += len(line) + 1
        if group.size <= MAX_COLLECTED:
            # Longer ones are read to their end all the same: their rows are not frames of their own.
            group.in_comment = in_comment
            group.depth += row.run.depth if row.run is not None else 0
            group.add(row)
        return True

    def _finish(self, group: Group) -> None:
        """Emits the frame that the rows make, when the last of them ended it."""
        last = group.rows[-1].run
        if last is None:
            return
        # What has an index or a mark in each row is meant without the rest.
        for track in group.live[:1] if not (group.is_array and group.depth > 0) else ():
            if track.is_complete():
                joined = track.joined(is_array=group.is_array)
                if tried(joined)[0].is_whole and self._emit(_pieces(group.rows, joined)):
                    self._group = None
                    return
        if not last.is_tail or (group.was_opened and group.depth <= 0):
            self._close()

    def _close(self) -> None:
        """Emits what is in the rows that are not continued."""
        group, self._group = self._group, None
        if group is None:
            return
        rows, looks = group.rows, group.looks
        if group.size > MAX_COLLECTED:
            if any(may_begin(data) for data in group.data()):
                problem = f"the bytes that start here have more than {MAX_COLLECTED // 1024} KiB of text"
                self._found.append(Pasted(b"", rows[0].number, short(rows[0].line, MAX_TEXT), problem=problem))
            return
        for track in group.live if len(rows) > 1 else ():
            joined = track.joined(is_array=group.is_array)
            pieces = _pieces(rows, joined)
            # A first row that looks like a frame is not dropped for one that begins after it.
            is_later = group.looks is not None and bool(pieces) and pieces[0].line != rows[0].number
            if not is_later and self._emit(pieces):
                return
            looks = looks or _looks(rows, joined)
        left: list[Row] = []
        reasons: dict[int, Pasted | None] = {}
        for row in rows:
            pieces, why = _frames(row, runs(without_columns(clean(row.line)))) if len(rows) > 1 else ([], None)
            if pieces:
                self._left(left, reasons)
                left = []
                self._emit(pieces)
            else:
                left.append(row)
                reasons[row.number] = why
        if len(left) == len(rows) and not any(reasons.values()):
            reasons[rows[0].number] = looks
        is_array = group.was_opened and len(rows) > 1 and rows[0].run is not None and not rows[0].run.opened
        self._left(left, reasons, is_array=is_array)

    def _left(self, rows: list[Row], looks: dict[int, Pasted | None], *, is_array: bool = False) -> None:
        """Emits what there is in rows without a frame: one with words between the rows, or where one breaks off."""
        for row in rows:
            if self._labelled(row):
                return
        if not rows:
            return
        from ev3proto.text.paste.mistakes import broken  # takes 4 ms, which texts of nothing but frames have no use for

        first = rows[0]
        found = broken([row.line for row in rows], first.number, is_sure=False, is_array=is_array)
        gap = next((row.number for row in rows if row.line.strip() == "*"), None)
        if gap is not None and first.run is not None and may_begin(plain := _plain(first.run) or b""):
            problem = f"line {gap}: the dump leaves lines out here, as the * tells"
            found = [Pasted(plain, first.number, short(first.line, MAX_TEXT), problem=problem)]
        for piece in found:
            # What lacks only its header is reported as such.
            why = looks.get(piece.line)
            if piece.problem is not None or piece.cut or why is None or why.problem != bare_reason(piece.data):
                looks = {}
                self._found.append(piece)
        self._found += [why for row in rows if (why := looks.get(row.number)) is not None]

    def _labelled(self, row: Row) -> bool:
        """Emits the frame that ends with a line, of lines that have a part of it each, with any words beside it.

        Such lines have nothing in common, so the frame must not have a flaw.
        """
        data = None if row.run is None else _plain(row.run)
        if data is None:
            if row.line.strip():
                self._parts.clear()
            return False
        self._parts.append((row, data))
        parts = [*self._parts]
        after = b""
        for index in range(len(parts) - 1, -1, -1):
            after = parts[index][1] + after
            # A column of numbers has parts of one size, those of a frame differ.
            is_column = len({len(part) for _, part in parts[index:]}) == 1 and index < len(parts) - 1
            if not is_column and is_one_frame(after):
                first = parts[index][0]
                text = short("\n".join(part.line for part, _ in parts[index:]), MAX_TEXT)
                column = first.run.start + 1 if first.run is not None else 1
                said = first.said
                return self._emit([Pasted(after, first.number, text, said.direction, said.time, column=column)])
        return False


def bytes_in(line: str) -> bytes:
    """Returns the bytes of the longest run in a line, in its likeliest reading, whether they are a frame or not."""
    bare, _ = without_remarks(without_marks(clean(line)))
    return max((likely_bytes(run) or b"" for run in runs(without_columns(bare))), key=len, default=b"")


def _all(found: list[Run]) -> list[Value]:
    return [value for run in found for value in run.values]


def _plain(run: Run) -> bytes | None:
    """Returns the bytes of a run that has padded hex or marked numbers only; None for any other."""
    is_plain = all(
        value.style is Style.MARKED or (value.style is Style.BARE and len(value.text) % 2 == 0) for value in run.values
    )
    return whole_bytes(run, "hex") if is_plain else None


def _frames(row: Row, found: list[Run]) -> tuple[list[Pasted], Pasted | None]:
    """Returns the frames in the runs of a line, and what looks like one where there is none."""
    pieces: list[Pasted] = []
    looks: Pasted | None = None
    position = 0
    seen: set[tuple[bytes, Direction | None]] = set()
    for run in found:
        if sum(len(value.text if value.data is None else value.data) for value in run.values) < LEAST:
            continue
        here = _pieces([row], run, position)
        # A line that shows the same frame in several notations has it once.
        pieces += [piece for piece in here if (piece.data, piece.direction) not in seen]
        seen.update((piece.data, piece.direction) for piece in here)
        if here:
            position = run.end
        elif looks is None and not pieces:
            looks = _looks([row], run)
    return pieces, looks


def _pieces(rows: list[Row], run: Run, position: int = 0) -> list[Pasted]:
    """Returns the frames in a run."""
    found: list[Pasted] = []
    shown = "\n".join(row.line for row in rows[:_MOST_SHOWN])
    by_number = {row.number: row for row in rows}
    heads: dict[int, Head] = {}
    for frame in tried(run)[0].frames:
        value, last = run.values[frame.first], run.values[frame.last]
        row = by_number[run.lines[frame.first]] if run.lines else rows[0]
        until = row.run.start if len(rows) > 1 and row.run is not None else value.start
        head = heads.get(row.number)
        if head is None:
            head = heads[row.number] = head_before(row.line, position, until)
        found.append(
            Pasted(
                frame.data + frame.padding,
                row.number,
                short(row.line[value.start : last.end] if len(rows) == 1 else shown, MAX_TEXT),
                direction_of(frame.data, row.line, until, head, row.said),
                head.time or row.said.time,
                column=value.start + 1,
            )
        )
    return found


def _looks(rows: list[Row], run: Run) -> Pasted | None:
    """Returns as what a run that is not a frame is reported; None where it does not look like one."""
    is_long = len(run.values) > 1 or len(run.values[0].text) > 3
    if not is_long or run.values[0].style in (Style.NAME, Style.BASE64):
        return None
    for stretch in (stretch for one in tried(run) for stretch in one.stretches):
        for start in sorted(boundaries(run, stretch)[0])[:_MOST_STARTS] if "words" not in stretch.name else ():
            is_alone = start == 0 and run.is_head and run.is_tail and stretch.name == "hex"
            problem = (_bare(run, stretch) if is_alone else None) or _why(run, stretch, start)
            if problem is not None:
                place = stretch.places[start]
                number = run.lines[place] if run.lines else rows[0].number
                row = next(row for row in rows if row.number == number)
                column = run.values[place].start
                text = short(row.line[column:], MAX_TEXT)
                return Pasted(b"", number, text, problem=problem, column=column + 1, unread=True)
    return None


def _bare(run: Run, stretch: Stretch) -> str | None:
    """Returns what a whole line of bytes is that are not a frame, if only the header of one is missing."""
    is_hash = len(run.values) == 1 and len(stretch.data) in HASHES
    is_address = len(stretch.data) == 6 and {*run.gaps[1:]} <= {":", "-"}
    is_padded = all(len(value.text) != 1 for value in run.values)
    if is_hash or is_address or not is_padded or len({*stretch.data}) < LEAST - 1:
        return None
    return bare_reason(stretch.data)


def _why(run: Run, stretch: Stretch, start: int) -> str | None:
    """Returns why the bytes from there on look like a frame: up to where the way of writing changes."""
    places, changes = stretch.places, changes_in(run)
    end = start + 1
    while end < len(places) and (places[end] == places[end - 1] or places[end] not in changes):
        end += 1
    data, values = stretch.data[start:end], [run.values[place] for place in places[start:end]]
    is_dense = {run.gaps[place] for place in places[start + 1 : end]} <= {"", ":", "-"}
    if len(data) == 6 and is_dense:
        return None
    is_short = min(len(value.text) for value in values) == 1 and all(value.text.isdecimal() for value in values)
    is_bare = all(value.style is Style.BARE for value in values)
    return reason(data, is_dense=is_dense, is_decimal=is_bare and (stretch.name == "decimal" or is_short))


def _may_continue(run: Run) -> bool:
    """Whether the next line may continue a run; not what numbers the columns of a dump."""
    if run.opened > 0 and run.depth <= 0:
        return False
    digits = [value.text.lstrip("0") or "0" for value in run.values[:8] if value.style is Style.BARE]
    is_base64 = run.values[0].style is Style.BASE64
    return digits != [*"01234567"] and (not is_base64 or len(run.values[0].text) % 4 == 0)


def _follows(last: Row, row: Row) -> bool:
    """Whether a row is written as the one before it, and begins where that ended."""
    assert last.run is not None
    assert row.run is not None
    styles = [
        style if style in (Style.STRING, Style.BASE64) else None
        for style in (last.run.values[0].style, row.run.values[0].style)
    ]
    if styles[0] is not styles[1]:
        return False
    return row.run.is_head or _shape(last.line[: last.run.start]) == _shape(row.line[: row.run.start])


def _stands_alone(group: Group, run: Run) -> bool:
    """Whether a row is a frame of its own, which does not end the frame in front of it."""
    return tried(run)[0].is_whole and not any(
        len(data) > 1 and len(data) < frame_size(data) <= len(data) + len(whole_bytes(run, name) or b"")
        for name, data in (group.tracks[0].data or {}).items()
    )


def _shape(text: str) -> str:
    """Returns what is in front of a row, whatever numbers it has."""
    return _DIGITS.sub("0", text).strip()


def _without_prefix(run: Run, line: str) -> Run:
    """Returns the run without the numbers of a log line in front of it, as in `D/EV3 ( 1234): 0f 00`."""
    for place in range(min(_MOST_PREFIX, len(run.values) - 1), 0, -1):
        gap = line[run.values[place - 1].end : run.values[place].start]
        if _PREFIX_ENDS.fullmatch(gap) and run.gaps[place] != [*run.gaps, ""][place + 1]:
            return Run(
                run.values[place:],
                ["", *run.gaps[place + 1 :]],
                is_tail=run.is_tail,
                depth=run.depth - run.opened,
                has_comma=run.has_comma,
            )
    return run
