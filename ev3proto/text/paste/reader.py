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

from ev3proto.schema.header import frame_size, is_frame_size
from ev3proto.tables.frame import MAX_FRAME
from ev3proto.text.paste.cleaning import clean, without_marks, without_remarks
from ev3proto.text.paste.columns import repeated_rows, without_columns
from ev3proto.text.paste.fitting import HASHES, bare_reason, is_flawless, is_something, may_begin, reason
from ev3proto.text.paste.head import NO_HEAD, Direction, Head, announced, direction_of, head_before
from ev3proto.text.paste.mistakes import broken
from ev3proto.text.paste.pieces import LEAST, MAX_COLLECTED, MAX_LINE, MAX_TEXT, Pasted, check_text, short
from ev3proto.text.paste.readings import (
    Stretch,
    best_reading,
    boundaries,
    changes_in,
    likely_bytes,
    plain_bytes,
    readings,
    whole_bytes,
)
from ev3proto.text.paste.values import Run, Style, all_values, character_cells, listed, runs, without_indexes

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
    looks   why it looks like a frame if it is not one
    said    what the line above says of its bytes
    """

    number: int
    line: str
    run: Run | None = None
    listed: Run | None = None
    looks: Pasted | None = None
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
        begun = [data for data in (self.data or {}).values() if len(data) >= LEAST and is_frame_size(frame_size(data))]
        if any(frame_size(data) == len(data) for data in begun):
            return True
        # Zeros after a frame are padding, unless another reading takes them for a part of its frame.
        is_padded = bool(begun) and not self.was_padded and all(_ends_within(data, 0) for data in begun)
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


@dataclass(slots=True)
class Group:
    """Rows that the next line may continue.

    tracks      their runs, as they are and without indexes
    has_commas  a comma ends each row but the last
    has_gap     a `*` replaces rows like the one before it, as many as the next offset says
    """

    was_opened: bool
    depth: int
    rows: list[Row] = field(default_factory=list)
    tracks: tuple[Track, Track] = field(default_factory=lambda: (Track(), Track()))
    last: Row = field(default_factory=lambda: Row(0, ""))
    size: int = 0
    in_comment: bool = False
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


class Reader:
    """Reads the frames of a text, and says of the rest what looks like one."""

    def __init__(self) -> None:
        self._group: Group | None = None
        self._opens = self._was_opened = False
        self._said = NO_HEAD
        self._check_sum: int | None = None
        self._parts: deque[tuple[Row, bytes]] = deque(maxlen=_MOST_PARTS)

    def read(self, lines: Iterable[str]) -> Iterator[Pasted]:
        """Yields all pieces in the lines, in their order."""
        before: list[bytes] = []
        number = 0
        for piece, line in self._all(lines):
            if _STRACE_DUMP.match(line) and piece.line == number + 1 and piece.data in before:
                continue
            before = [*(before if piece.line == number else []), piece.data]
            number = piece.line
            yield piece

    def _all(self, lines: Iterable[str]) -> Iterator[tuple[Pasted, str]]:
        for number, line in enumerate(lines, 1):
            check_text(line)
            if len(line) > MAX_LINE:
                yield from self._close()
                problem = f"the line has more than {MAX_LINE} characters and was not read"
                yield Pasted(b"", number, short(line, MAX_TEXT), problem=problem), line
                continue
            line = line.rstrip("\r\n")
            if self._group is not None:
                if self._continues(self._group, line, number):
                    yield from self._finished(self._group)
                    continue
                yield from self._close()
            said = self._said
            yield from self._new_line(line, number)
            if self._said is said and line[:1].strip():
                # What was said of the bytes is true for the line after it, and for those that are indented.
                self._said, self._check_sum = NO_HEAD, None
        yield from self._close()

    def _new_line(self, line: str, number: int) -> Iterator[tuple[Pasted, str]]:
        """Reads a line that does not continue others."""
        self._was_opened, self._opens = self._opens, line.rstrip().endswith(("[", "{", "("))
        if _MAY_HAVE.search(line) is None or _EXCERPT.match(line):
            self._listen(line)
            if line.strip():
                self._parts.clear()
            return
        whole = clean(line)
        row, in_comment, found = self._row(line, number, whole, 0)
        looks = None
        for attempt in self._attempts(row, line, whole, found):
            pieces, why = _frames(row, attempt)
            looks = looks or why
            if pieces:
                self._parts.clear()
                yield from ((piece, line) for piece in pieces)
                return
        self._listen(line)
        row = row._replace(looks=looks)
        if row.run is not None and row.run.is_tail and _may_continue(row.run) and not _is_heading(row.run):
            self._group = Group(row.run.opened > 0 or self._was_opened, row.run.depth + self._was_opened)
            self._group.in_comment, self._group.size = in_comment, len(line)
            self._group.add(row)
        else:
            yield from self._left([row])

    def _attempts(self, row: Row, line: str, whole: str, found: list[Run]) -> Iterator[list[Run]]:
        """Yields the runs of a line as they are, without its remarks, and whatever is between its values."""
        cells = character_cells(line)
        plain = runs(without_columns(whole)) if cells is None else [cells]
        for run in plain:
            run.check_sum = self._check_sum
        numbered = without_indexes(all_values(plain), 0, LEAST)
        yield [listed(numbered)] if numbered is not None else plain
        if row.run is not None and not any(run.values == row.run.values for run in plain):
            yield [row.run] if len(row.run.values) == len(all_values(found)) else [*found[:-1], row.run]
        # The same words between the values, or the name of each part in front of it or after it.
        values = all_values(plain)
        marked = [value for value in values if value.style is Style.MARKED]
        if len(plain) < 2 and len(marked) in (0, len(values)):
            return
        for some in (marked, *(values[start:] for start in range(_MOST_BEFORE))):
            if len(some) >= LEAST and Style.STRING not in {value.style for value in some}:
                best = best_reading(run := listed(some))[0]
                if best.is_whole and _is_frame(best.spans[0][0].data):
                    yield [run]
        parts = [likely_bytes(run) for run in plain]
        for start in range(min(len(parts), _MOST_BEFORE)):
            rest = parts[start:]
            if None not in rest and _is_frame(b"".join(part or b"" for part in rest)):
                yield [_of_parts(plain[start:], rest)]

    def _listen(self, line: str) -> None:
        """Remembers what a line without frames says of the frames that follow."""
        check_sum = _CHECK_SUM.match(line)
        if check_sum is not None:
            self._check_sum = int(check_sum[1], 16)
        self._said = announced(line) or self._said

    def _row(self, line: str, number: int, whole: str, index: int) -> tuple[Row, bool, list[Run]]:
        """Returns a line as a part of a frame over several lines, whether a comment continues, and its runs."""
        group = self._group
        is_inside = group is not None and group.in_comment
        bare, in_comment = without_remarks(whole if is_inside else without_marks(whole), is_inside=is_inside)
        counts = set() if group is None else {len(data) for data in group.data()}
        bare = without_columns(bare, counts)
        continues = group is not None and character_cells(group.rows[0].line) is not None
        cells = character_cells(line, continues=continues)
        is_text = group is not None and group.last.run is not None and group.last.run.is_text
        found = [cells] if cells is not None else runs(bare, is_text=is_text)
        if not found:
            return Row(number, line), in_comment, found
        every = all_values(found)
        marked = [value for value in every if value.style is Style.MARKED]
        values = marked if 0 < len(marked) < len(every) else without_indexes(every, index, 1)
        run = _without_prefix(found[-1], bare)
        run.check_sum = self._check_sum
        is_call = len(run.values) == 1 or (not run.is_head and len(run.values) < LEAST)
        if is_call and run.opened > 0 >= run.depth:
            # The brackets of a call that has one part of the bytes, as in `data.Add(0x0F);`.
            run = replace(run, opened=0, depth=0)
        row = Row(number, line, run, None if values is None else listed(values), said=self._said)
        return row, in_comment, found

    # Lines that belong together

    def _continues(self, group: Group, line: str, number: int) -> bool:
        """Takes a line that continues the rows; tells whether it did."""
        last = group.last
        assert last.run is not None
        if line.strip() == "*" and not group.has_gap:
            group.has_gap = True
            group.add(Row(number, line))
            return True
        if group.has_gap and not _filled(group, line):
            return False
        if _INDEX_ALONE.fullmatch(line):
            group.add(Row(number, line))
            return True
        whole = clean(line)
        index = len(group.tracks[1].runs)
        row, in_comment, _ = self._row(line, number, whole, index)
        if row.run is None:
            # Only a list with commas continues after a comment, and after more than some empty lines.
            group.empty += 1
            has_begun = any(len(data) >= LEAST for data in group.data())
            is_empty = has_begun and not whole.strip() and group.empty <= _MOST_EMPTY
            if not group.in_comment and not last.run.has_comma and not is_empty:
                return False
            if without_columns(without_remarks(without_marks(whole), is_inside=group.in_comment)[0], {0}).strip():
                return False
        elif not _follows(last, row) or not group.data() or _stands_alone(group, row.run):
            return False
        group.size += len(line) + 1
        if group.size <= MAX_COLLECTED:
            # Longer ones are read to their end all the same: their rows are not frames of their own.
            group.in_comment = in_comment
            group.depth += row.run.depth if row.run is not None else 0
            group.add(row)
        return True

    def _finished(self, group: Group) -> Iterator[tuple[Pasted, str]]:
        """Yields the frame that the rows make, when the last of them ended it."""
        last = group.rows[-1].run
        if last is None:
            return
        if not (group.is_array and group.depth > 0):
            # What has an index or a mark in each row is meant without the rest.
            for track in group.live[:1]:
                if track.is_complete():
                    joined = track.joined(is_array=group.is_array)
                    if best_reading(joined)[0].is_whole:
                        self._group = None
                        self._parts.clear()
                        yield from ((piece, group.rows[0].line) for piece in _pieces(group.rows, joined))
                        return
        if not last.is_tail or (group.was_opened and group.depth <= 0):
            yield from self._close()

    def _close(self) -> Iterator[tuple[Pasted, str]]:
        """Yields what is in the rows that are not continued."""
        group, self._group = self._group, None
        if group is None:
            return
        rows = group.rows
        if group.size > MAX_COLLECTED:
            if any(may_begin(data) for data in group.data()):
                problem = f"the bytes that start here have more than {MAX_COLLECTED // 1024} KiB of text"
                yield Pasted(b"", rows[0].number, short(rows[0].line, MAX_TEXT), problem=problem), rows[0].line
            return
        looks = None
        for track in group.live:
            if len(track.runs) > 1:
                joined = track.joined(is_array=group.is_array)
                pieces = _pieces(rows, joined)
                looks = looks or _looks(rows, joined)
                if pieces:
                    self._parts.clear()
                    yield from ((piece, rows[0].line) for piece in pieces)
                    return
        if len(rows) == 1:
            yield from self._left(rows)
            return
        found = [_frames(row, runs(without_columns(clean(row.line)))) for row in rows]
        if any(pieces for pieces, _ in found):
            for row, (pieces, why) in zip(rows, found, strict=True):
                yield from ((piece, row.line) for piece in pieces)
                if not pieces:
                    yield from self._left([row._replace(looks=why)])
            return
        looked = [row._replace(looks=why) for row, (_, why) in zip(rows, found, strict=True)]
        if all(row.looks is None for row in looked):
            looked[0] = looked[0]._replace(looks=looks)
        yield from self._left(looked, is_array=group.was_opened and rows[0].run is not None and not rows[0].run.opened)

    def _left(self, rows: list[Row], *, is_array: bool = False) -> Iterator[tuple[Pasted, str]]:
        """Yields what there is in rows without a frame: one with words between the rows, or where one breaks off."""
        for row in rows:
            piece = self._labelled(row)
            if piece is not None:
                yield piece, row.line
                return
        gap = next((row.number for row in rows if row.line.strip() == "*"), None)
        found = broken([row.line for row in rows], rows[0].number, is_sure=False, is_array=is_array)
        if gap is not None and rows[0].run is not None and may_begin(plain := plain_bytes(rows[0].run) or b""):
            problem = f"line {gap}: the dump leaves lines out here, as the * tells"
            found = [Pasted(plain, rows[0].number, short(rows[0].line, MAX_TEXT), problem=problem)]
        looks = {row.number: row.looks for row in rows if row.looks is not None}
        for piece in found:
            # What lacks only its header is reported as such.
            why = looks.get(piece.line)
            if piece.problem is not None or piece.cut or why is None or why.problem != bare_reason(piece.data):
                looks.clear()
                yield piece, rows[0].line
        yield from ((piece, rows[0].line) for piece in looks.values())

    def _labelled(self, row: Row) -> Pasted | None:
        """Returns the frame that ends with a line, of lines that have a part of it each, with any words beside it.

        Such lines have nothing in common, so the frame must not have a flaw.
        """
        data = None if row.run is None else plain_bytes(row.run)
        if data is None:
            if row.line.strip():
                self._parts.clear()
            return None
        self._parts.append((row, data))
        parts = [*self._parts]
        after = b""
        for index in range(len(parts) - 1, -1, -1):
            after = parts[index][1] + after
            # A column of numbers has parts of one size, those of a frame differ.
            is_column = len({len(part) for _, part in parts[index:]}) == 1 and index < len(parts) - 1
            if not is_column and _is_frame(after):
                self._parts.clear()
                first = parts[index][0]
                start = first.run.start if first.run is not None else 0
                text = short("\n".join(part.line for part, _ in parts[index:]), MAX_TEXT)
                said = first.said
                return Pasted(after, first.number, text, said.direction, said.time, column=start + 1)
        return None


def bytes_in(line: str) -> bytes:
    """Returns the bytes of the longest run in a line, in its likeliest reading, whether they are a frame or not."""
    bare, _ = without_remarks(without_marks(clean(line)))
    return max((likely_bytes(run) or b"" for run in runs(without_columns(bare))), key=len, default=b"")


def _is_frame(data: bytes) -> bool:
    """Whether bytes that were gathered among words are one frame, without a flaw and not by chance."""
    return len(data) >= LEAST and frame_size(data) == len(data) and is_something(data) and is_flawless(data)


def _of_parts(found: list[Run], parts: list[bytes | None]) -> Run:
    """Returns runs with their bytes as one run."""
    values = [
        run.values[0]._replace(end=run.end, style=Style.MARKED, data=data or b"")
        for run, data in zip(found, parts, strict=True)
    ]
    return listed(values)


def _frames(row: Row, found: list[Run]) -> tuple[list[Pasted], Pasted | None]:
    """Returns the frames in the runs of a line, and what looks like one where there is none."""
    pieces: list[Pasted] = []
    looks: Pasted | None = None
    position = 0
    seen: set[tuple[bytes, Direction | None]] = set()
    for run in found:
        if run.most_bytes < LEAST:
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
    for stretch, spans in best_reading(run)[0].spans:
        # Padding belongs to the frame in front of it, which is how it is reported.
        is_padded = len(spans) == 1 and not any(stretch.data[spans[0].end :])
        for start, end, _ in spans:
            value, last = run.values[stretch.places[start]], run.values[stretch.places[end - 1]]
            row = by_number[run.lines[stretch.places[start]]] if run.lines else rows[0]
            until = row.run.start if len(rows) > 1 and row.run is not None else value.start
            head = heads.get(row.number)
            if head is None:
                head = heads[row.number] = head_before(row.line, position, until)
            data = stretch.data[start:end]
            found.append(
                Pasted(
                    stretch.data[start:] if is_padded else data,
                    row.number,
                    short(row.line[value.start : last.end] if len(rows) == 1 else shown, MAX_TEXT),
                    direction_of(data, row.line, until, head, row.said),
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
    for one in best_reading(run)[1]:
        for stretch in one.stretches:
            if stretch.name not in ("hex", "decimal", "string", "number", "octal"):
                continue
            for start in sorted(boundaries(run, stretch)[0])[:_MOST_STARTS]:
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
    classes = {run.gaps[place] for place in places[start + 1 : end]} - {""}
    data = stretch.data[start:end]
    is_dense = classes <= {":", "-"}
    if len(data) == 6 and is_dense:
        return None
    texts = [run.values[place].text for place in places[start:end]]
    is_decimal = stretch.name == "decimal" or (min(map(len, texts)) == 1 and all(map(str.isdecimal, texts)))
    is_decimal = is_decimal and all(run.values[place].style is Style.BARE for place in places[start:end])
    return reason(data, is_dense=is_dense, is_decimal=is_decimal)


def _may_continue(run: Run) -> bool:
    """Whether the next line may continue a run."""
    if run.opened > 0 and run.depth <= 0:
        return False
    return run.values[0].style is not Style.BASE64 or len(run.values[0].text) % 4 == 0


def _is_heading(run: Run) -> bool:
    """Whether the values number the columns of a dump."""
    digits = [value.text for value in run.values[:8] if value.style is Style.BARE]
    return [text.lstrip("0") or "0" for text in digits] == [*"01234567"]


def _follows(last: Row, row: Row) -> bool:
    """Whether a row is written as the one before it, and begins where that ended."""
    assert last.run is not None
    assert row.run is not None
    first, second = last.run.values[0].style, row.run.values[0].style
    if last.run.is_text != row.run.is_text or (first is Style.BASE64) != (second is Style.BASE64):
        return False
    return row.run.is_head or _shape(last.line[: last.run.start]) == _shape(row.line[: row.run.start])


def _shape(text: str) -> str:
    """Returns what is in front of a row, whatever numbers it has."""
    return _DIGITS.sub("0", text).strip()


def _stands_alone(group: Group, run: Run) -> bool:
    """Whether a row is a frame of its own, which does not end the frame in front of it."""
    if not best_reading(run)[0].is_natural:
        return False
    for name, data in (group.tracks[0].data or {}).items():
        part = whole_bytes(run, name) or b""
        is_exact = len(data) >= 2 and frame_size(data) == len(data) + len(part)
        if is_exact or (len(data) >= LEAST and _ends_within(data + part, len(data))):
            return False
    return True


def _filled(group: Group, line: str) -> bool:
    """Adds the rows that a `*` replaces; tells whether the offset in the line says how many they are."""
    group.has_gap = False
    last = group.last
    assert last.run is not None
    for name, data in (group.tracks[0].data or {}).items():
        size = len(whole_bytes(last.run, name) or b"")
        count = repeated_rows(last.line, line, size, len(data))
        if count is not None and len(data) + count * size <= MAX_FRAME + size:
            for _ in range(count):
                group.add(last)
            return True
    return False


def _ends_within(data: bytes | bytearray, start: int) -> bool:
    """Whether the frame that begins the data ends after that offset, with nothing but zeros after it."""
    end = frame_size(data)
    return is_frame_size(end) and start < end <= len(data) and len(data.rstrip(b"\0")) <= end


def _without_prefix(run: Run, line: str) -> Run:
    """Returns the run without the numbers of a log line in front of it, as in `D/EV3 ( 1234): 0f 00`."""
    for place in range(min(_MOST_PREFIX, len(run.values) - 1), 0, -1):
        gap = line[run.values[place - 1].end : run.values[place].start]
        if _PREFIX_ENDS.fullmatch(gap) and run.gaps[place] != [*run.gaps, ""][place + 1]:
            values, gaps, depth = run.values[place:], ["", *run.gaps[place + 1 :]], run.depth - run.opened
            return replace(
                run, values=values, gaps=gaps, changes=None, tried=None, is_head=False, opened=0, depth=depth
            )
    return run
