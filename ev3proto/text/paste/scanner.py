"""Text to frames, by one rule: a run of byte values whose length field fits it is a frame, wherever it stands.

Lines are looked at one by one. A run that reaches to the end of its line and is no frame yet is kept: the next
lines may go on with it. What is no frame in the end is said to look like one, or left to the forms.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from ev3proto.schema.header import frame_size, is_frame_size
from ev3proto.tables.frame import MAX_FRAME
from ev3proto.text.late_pattern import late_pattern
from ev3proto.text.paste.blanking import (
    clean,
    without_indexes,
    without_marks,
    without_number,
    without_remarks,
)
from ev3proto.text.paste.columns import repeated_rows, without_columns
from ev3proto.text.paste.direction import direction_of
from ev3proto.text.paste.fitting import HASHES, bare_reason, is_flawless, is_something, may_begin, reason
from ev3proto.text.paste.head import NO_HEAD, Direction, Head, announced, head_before
from ev3proto.text.paste.pieces import LEAST, MAX_COLLECTED, MAX_TEXT, Pasted, short
from ev3proto.text.paste.readings import (
    Stretch,
    best_reading,
    boundaries,
    changes_in,
    mixed_bytes,
    plain_bytes,
    stretches,
)
from ev3proto.text.paste.rhythm import rhythmic_runs
from ev3proto.text.paste.values import BASES, Run, Style, Value, character_cells, readings, runs, says_the_same

_MAY_HAVE = late_pattern(r"^\s*[a-fA-F]\s*$|[0-9\\]|[A-Za-z0-9+/]{8}|\b[a-fA-F]{2}\b")
# What `check` prints under a finding: the frame itself stands above it.
_EXCERPT = late_pattern(r"\s*\+\d+ \| ")
_INDEX_ALONE = late_pattern(r"\s*\[\d{1,5}\]\s?=>\s*")
_CHECK_SUM = late_pattern(r"^\s+FCS: 0x([0-9a-fA-F]{2})\b")
_DIGITS = late_pattern(r"[0-9]+|0x[0-9a-fA-F]+")


@dataclass(frozen=True, slots=True)
class Row:
    """A line that may be a part of a frame.

    number  its number in the text
    line    the line
    run     the part of it that may belong to a frame over several lines
    looks   why it looks like a frame if it is none
    said    what the line above says of its bytes
    index   the number of the byte in the next line, where it has its number in front
    """

    number: int
    line: str
    run: Run | None
    looks: Pasted | None = None
    said: Head = NO_HEAD
    index: int | None = None


@dataclass(slots=True)
class Pending:
    """Rows that may go on in the next line.

    data        their bytes by reading; a reading that does not fit a value is no more among them
    has_commas  a comma ends each row but the last
    has_gap     a `*` stands for rows like the one before it, as many as the next offset says
    left_empty  empty lines since the last row
    """

    rows: list[Row]
    data: dict[str, bytearray]
    depth: int
    was_opened: bool
    size: int
    in_comment: bool = False
    index: int = 0
    has_commas: bool = True
    has_gap: bool = False
    left_empty: int = 0

    @property
    def is_array(self) -> bool:
        """Whether the rows are one list in brackets, separated by commas."""
        return self.was_opened and self.has_commas

    def add(self, row: Row) -> None:
        """Takes another row."""
        last = self.rows[-1].run
        self.has_commas = self.has_commas and (last is None or last.has_comma)
        self.rows.append(row)

    def is_complete(self) -> bool:
        """Whether some reading has as many bytes as its length field says."""
        begun = [data for data in self.data.values() if len(data) >= LEAST and is_frame_size(frame_size(data))]
        if any(frame_size(data) == len(data) for data in begun):
            return True
        # Zeros after a frame are padding, unless another reading takes them for a part of its frame.
        return bool(begun) and all(_ends_within(data, 0) for data in begun)


class Scanner:
    """Finds frames in lines of text, and what looks like one."""

    def __init__(self) -> None:
        self._pending: Pending | None = None
        self._opens = self._was_opened = False
        self._last: tuple[str, list[Run]] = ("", [])
        self._said = NO_HEAD
        self._check_sum: int | None = None

    @property
    def is_open(self) -> bool:
        """Whether the next line may go on with one before, or was announced by it."""
        return self._pending is not None or self._said is not NO_HEAD

    def skip(self) -> None:
        """Takes notice of a line that was read elsewhere."""
        self._opens = False
        self._said, self._check_sum = NO_HEAD, None

    def feed(self, line: str, number: int) -> Iterator[Pasted | Row]:
        """Takes a line.

        Returns:
            An iterator over frames, over what looks like one (`unread`), and over lines that have neither.
        """
        if self._pending is not None:
            if self._goes_on(line, number):
                yield from self._finished()
                return
            yield from self.close()
        said = self._said
        yield from self._new_line(line, number)
        if self._said is said and line[:1].strip():
            # What was said of the bytes holds for the line after it, and for those that are indented.
            self._said, self._check_sum = NO_HEAD, None

    def _new_line(self, line: str, number: int) -> Iterator[Pasted | Row]:
        """Reads a line that goes on with nothing."""
        self._was_opened, self._opens = self._opens, line.rstrip().endswith(("[", "{", "("))
        if _MAY_HAVE.search(line) is None or _EXCERPT.match(line):
            self._listen(line)
            yield Row(number, line, None)
            return
        whole = clean(line)
        cells = character_cells(line)
        plain = self._plain(whole) if cells is None else [cells]
        found = list(self._frames(line, number, plain, self._said))
        if any(piece.data for piece in found):
            yield from found
            return
        row, index, in_comment = self._row(line, number, whole, 0, is_inside=False)
        is_other = row.run is not None and not any(run.values == row.run.values for run in plain)
        if is_other and row.run is not None:
            # Comments and offsets among the values hide a frame from the plain reading.
            stripped = list(self._frames(line, number, [row.run], self._said))
            if any(piece.data for piece in stripped):
                found = stripped
        if not any(piece.data for piece in found):
            found = self._rhythmic(line, number, whole, plain) or found
        if any(piece.data for piece in found):
            yield from found
        elif row.run is not None and _is_heading(row.run):
            yield Row(number, line, None)
        elif row.run is not None and row.run.is_tail and self._may_go_on(row.run):
            depth = row.run.depth + self._was_opened
            is_opened = row.run.opened > 0 or self._was_opened
            said = self._said
            self._listen(line)
            self._pending = Pending([replace(row, said=said)], {}, depth, is_opened, len(line), in_comment, index)
            self._take(row.run)
        else:
            said = self._said
            self._listen(line)
            yield replace(row, looks=found[0] if found else None, said=said)

    def _listen(self, line: str) -> None:
        """Remembers what a line without frames says of the frames that follow."""
        check_sum = _CHECK_SUM.search(line)
        if check_sum is not None:
            self._check_sum = int(check_sum[1], 16)
        self._said = announced(line) or self._said

    def _rhythmic(self, line: str, number: int, whole: str, found: list[Run]) -> list[Pasted]:
        """The frame in a line whose values have words between them: always the same, or what each part is."""
        for run in rhythmic_runs(whole):
            if best_reading(run)[0].is_whole:
                return list(self._pieces([Row(number, line, run, said=self._said)], run))
        for index in range(min(len(found) - 1, _MOST_BEFORE)):
            parts = [mixed_bytes(run) for run in found[index : index + _MOST_PARTS]]
            data = b"".join(part for part in parts if part is not None)
            is_frame = len(data) >= LEAST and frame_size(data) == len(data) and is_something(data)
            if is_frame and None not in parts and is_flawless(data):
                first, last = found[index].start, found[-1].end
                head = head_before(line, 0, first)
                direction = direction_of(data, line, first, head, self._said)
                time = head.time or self._said.time
                return [Pasted(data, number, short(line[first:last], MAX_TEXT), direction, time, column=first + 1)]
        return []

    def close(self) -> Iterator[Pasted | Row]:
        """Ends what was kept."""
        pending, self._pending = self._pending, None
        if pending is None:
            return
        rows = [row for row in pending.rows if row.run is not None]
        if pending.size > MAX_COLLECTED:
            if not any(may_begin(data) for data in pending.data.values()):
                return
            problem = f"the bytes that start here go on after {MAX_COLLECTED // 1024} KiB of text, which is too much"
            yield Pasted(b"", rows[0].number, short(rows[0].line, MAX_TEXT), problem=problem)
            return
        found: list[Pasted | Row] = []
        if len(rows) > 1:
            joined = _joined(rows, is_array=pending.is_array)
            found += self._pieces(pending.rows, joined)
            if found:
                yield from found
                return
        for row in pending.rows:
            pieces = (
                []
                if row.run is None
                else list(self._frames(row.line, row.number, self._plain(clean(row.line)), row.said))
            )
            if any(piece.data for piece in pieces):
                found += pieces
            else:
                found.append(replace(row, looks=pieces[0] if pieces else None))
        if len(rows) > 1 and all(isinstance(one, Row) and one.looks is None for one in found):
            looks = self._looks(pending.rows, joined)
            found[0] = replace(pending.rows[0], looks=looks)
        yield from found

    def _plain(self, whole: str) -> list[Run]:
        """The runs of a line that was cleaned, whatever else stands in it."""
        listed, count = without_indexes(whole, 0)
        return self._runs(without_columns(listed if count >= LEAST else whole))

    def _runs(self, line: str, *, is_text: bool = False) -> list[Run]:
        """The runs of a line; those of the last line are remembered."""
        if is_text:
            return runs(line, is_text=True)
        if line != self._last[0]:
            self._last = line, runs(line)
        return self._last[1]

    # Lines that belong together

    def _row(self, line: str, number: int, whole: str, index: int, *, is_inside: bool) -> tuple[Row, int, bool]:
        """A line as a part of a frame over several lines."""
        bare, in_comment = without_remarks(without_marks(whole) if not is_inside else whole, is_inside=is_inside)
        following = None if self._pending is None else self._pending.rows[-1].index
        if self._pending is None or following is not None:
            bare, following = without_number(bare, following)
        bare, index = without_indexes(bare, index)
        bare = without_columns(bare, self._counts())
        goes_on = self._pending is not None and character_cells(self._pending.rows[0].line) is not None
        cells = character_cells(line, goes_on=goes_on)
        found = [cells] if cells is not None else self._runs(bare, is_text=self._is_text())
        if not found and not bare.strip():
            return Row(number, line, None), index, in_comment
        run = _without_prefix(found[-1], bare) if found else None
        if run is not None and run.check_sum != self._check_sum:
            run.check_sum, run.known = self._check_sum, None
        is_call = run is not None and (len(run.values) == 1 or (not run.is_head and len(run.values) < LEAST))
        if run is not None and is_call and run.opened > 0 >= run.depth:
            # The brackets of a call that has one part of the bytes, as in `data.Add(0x0F);`.
            run = replace(run, opened=0, depth=0)
        return Row(number, line, run, index=following), index, in_comment

    def _counts(self) -> set[int]:
        """How many bytes were kept, in each reading."""
        return set() if self._pending is None else {len(data) for data in self._pending.data.values()}

    def _is_text(self) -> bool:
        """Whether string literals were kept."""
        first = None if self._pending is None else self._pending.rows[0].run
        return first is not None and first.is_text

    def _may_go_on(self, run: Run) -> bool:
        """Whether the next line may go on with a run."""
        if run.opened > 0 and run.depth <= 0:
            return False
        return run.values[0].style is not Style.BASE64 or len(run.values[0].text) % 4 == 0

    def _take(self, run: Run) -> None:
        """Adds the bytes of a run to every reading that still fits."""
        pending = self._pending
        assert pending is not None
        names = readings(run)
        if not pending.data:
            pending.data = {name: bytearray() for name in names}
        for name in list(pending.data):
            parts = stretches(run, name)
            if len(parts) == 1 and len({*parts[0].places}) == len(run.values):
                pending.data[name] += parts[0].data
            elif name in BASES:
                pending.data[name] += parts[0].data if parts else b""
            else:
                del pending.data[name]

    def _goes_on(self, line: str, number: int) -> bool:
        """Takes a line that goes on with the rows; tells whether it did."""
        pending = self._pending
        assert pending is not None
        last = next(row for row in reversed(pending.rows) if row.run is not None)
        assert last.run is not None
        if line.strip() == "*" and not pending.has_gap:
            pending.has_gap = True
            pending.add(Row(number, line, None))
            return True
        if pending.has_gap and not self._filled(last, line):
            return False
        if _INDEX_ALONE.fullmatch(line) or says_the_same(line, plain_bytes(last.run)):
            pending.add(Row(number, line, None))
            return True
        whole = clean(line)
        row, index, in_comment = self._row(line, number, whole, pending.index, is_inside=pending.in_comment)
        if row.run is None:
            # Only a list with commas goes on after a comment, and after more than some empty lines.
            pending.left_empty += 1
            has_begun = any(len(data) >= LEAST for data in pending.data.values())
            is_empty = has_begun and not whole.strip() and pending.left_empty <= _MOST_EMPTY
            if not pending.in_comment and not last.run.has_comma and not is_empty:
                return False
            bare = without_remarks(without_marks(whole), is_inside=pending.in_comment)[0]
            if bare.strip():
                return False
        elif not self._follows(last, row) or not pending.data or self._stands_alone(row.run):
            return False
        pending.size += len(line) + 1
        if pending.size > MAX_COLLECTED:
            # What goes on and on is read to its end all the same: its rows are no frames of their own.
            return True
        pending.add(replace(row, said=self._said))
        pending.in_comment, pending.index = in_comment, index
        if row.run is not None:
            pending.left_empty = 0
            self._take(row.run)
            pending.depth += row.run.depth
        return True

    def _filled(self, last: Row, line: str) -> bool:
        """Puts the rows in that a `*` stands for; tells whether the offset in the line says how many they are."""
        pending = self._pending
        assert pending is not None
        assert last.run is not None
        pending.has_gap = False
        for name, data in pending.data.items():
            size = sum(len(stretch.data) for stretch in stretches(last.run, name))
            count = repeated_rows(last.line, line, size, len(data))
            if count is not None and len(data) + count * size <= MAX_FRAME + size:
                pending.rows += [last] * count
                for _ in range(count):
                    self._take(last.run)
                return True
        return False

    def _follows(self, last: Row, row: Row) -> bool:
        """Whether a row is written as the one before it, and goes on where that ended."""
        assert last.run is not None
        assert row.run is not None
        if last.run.is_text != row.run.is_text or (Style.BASE64 in _styles(last.run)) != (
            Style.BASE64 in _styles(row.run)
        ):
            return False
        if row.run.is_head:
            return True
        before, after = last.line[: last.run.start], row.line[: row.run.start]
        return _shape(before) == _shape(after)

    def _stands_alone(self, run: Run) -> bool:
        """Whether a row is a frame of its own, which does not end the frame in front of it."""
        pending = self._pending
        assert pending is not None
        if not best_reading(run)[0].is_natural:
            return False
        for name, data in pending.data.items():
            part = b"".join(stretch.data for stretch in stretches(run, name))
            is_exact = len(data) >= 2 and frame_size(data) == len(data) + len(part)
            if is_exact or (len(data) >= LEAST and _ends_within(data + part, len(data))):
                return False
        return True

    def _finished(self) -> Iterator[Pasted | Row]:
        """The frame that the rows make, when the last of them ended it."""
        pending = self._pending
        assert pending is not None
        last = pending.rows[-1].run
        if last is None:
            return
        is_array = pending.is_array
        if pending.is_complete() and not (is_array and pending.depth > 0):
            joined = _joined([row for row in pending.rows if row.run is not None], is_array=is_array)
            best = best_reading(joined)[0]
            if best.is_whole:
                self._pending = None
                yield from self._pieces(pending.rows, joined)
                return
        if not last.is_tail or (pending.was_opened and pending.depth <= 0):
            yield from self.close()

    # Frames and what looks like one

    def _frames(self, line: str, number: int, found: list[Run], said: Head) -> Iterator[Pasted]:
        """The frames in the runs of a line, and what looks like one."""
        position = 0
        seen: set[tuple[bytes, Direction | None]] = set()
        for run in found:
            if run.most_bytes < LEAST:
                continue
            row = Row(number, line, run, said=said)
            pieces = list(self._pieces([row], run, position))
            # A line that shows the same frame in several notations has it once.
            yield from (piece for piece in pieces if (piece.data, piece.direction) not in seen)
            seen.update((piece.data, piece.direction) for piece in pieces)
            if any(piece.data for piece in pieces):
                position = run.end
                continue
            looks = self._looks([row], run)
            if looks is not None:
                yield looks

    def _pieces(self, rows: list[Row], run: Run, position: int = 0) -> Iterator[Pasted]:
        """The frames in a run."""
        best, _ = best_reading(run)
        shown = "\n".join(row.line for row in rows[:_MOST_SHOWN])
        heads: dict[int, Head] = {}
        for stretch, spans in best.spans:
            # Padding belongs to the frame in front of it, which is how it is reported.
            is_padded = len(spans) == 1 and not any(stretch.data[spans[0].end :])
            for start, end, _ in spans:
                value, last = run.values[stretch.places[start]], run.values[stretch.places[end - 1]]
                row = _row_of(rows, run, stretch.places[start])
                head = heads.get(row.number)
                until = row.run.start if len(rows) > 1 and row.run is not None else value.start
                if head is None:
                    head = heads[row.number] = head_before(row.line, position, until)
                yield Pasted(
                    stretch.data[start:] if is_padded else stretch.data[start:end],
                    row.number,
                    short(row.line[value.start : last.end] if len(rows) == 1 else shown, MAX_TEXT),
                    direction_of(stretch.data[start:end], row.line, until, head, row.said),
                    head.time or row.said.time,
                    column=value.start + 1,
                )

    def _looks(self, rows: list[Row], run: Run | None) -> Pasted | None:
        """What a run that is no frame is reported as; None where it does not look like one."""
        if (
            run is None
            or run.values[0].style is Style.NAME
            or (len(run.values) < 2 and run.values[0].style not in (Style.BARE, Style.LONG, Style.STRING))
        ):
            return None
        _, tried = best_reading(run)
        for one in tried:
            for stretch in one.stretches:
                if stretch.name not in ("hex", "decimal", "string", "number", "octal"):
                    continue
                starts = sorted(boundaries(run, stretch)[0])
                for start in starts[:_MOST_STARTS]:
                    is_alone = start == 0 and run.is_head and run.is_tail and stretch.name == "hex"
                    bare = self._bare(run, stretch) if is_alone else None
                    problem = bare or self._why(run, stretch, start)
                    if problem is None:
                        continue
                    value = run.values[stretch.places[start]]
                    first = next(row for row in rows if row.run is not None)
                    row = _row_of(rows, run, stretch.places[start])
                    head = head_before(first.line, 0, first.run.start if first.run else 0)
                    return Pasted(
                        b"",
                        row.number,
                        short(row.line[value.start :], MAX_TEXT),
                        head.direction,
                        head.time,
                        problem=problem,
                        column=value.start + 1,
                        unread=True,
                    )
        return None

    def _bare(self, run: Run, stretch: Stretch) -> str | None:
        """What a whole line of bytes is that are no frame, if the header of one is all that is missing."""
        is_hash = stretch.name == "hex" and len(run.values) == 1 and len(stretch.data) in HASHES
        is_address = len(stretch.data) == 6 and {*run.gaps[1:]} <= {":", "-"}
        is_padded = all(len(value.text) != 1 for value in run.values)
        if is_hash or is_address or not is_padded or len({*stretch.data}) < LEAST - 1:
            return None
        return bare_reason(stretch.data)

    def _why(self, run: Run, stretch: Stretch, start: int) -> str | None:
        """Why the bytes from there on look like a frame: up to where the way of writing changes."""
        places = stretch.places
        changes = changes_in(run)
        end = start + 1
        while end < len(places) and (places[end] == places[end - 1] or places[end] not in changes):
            end += 1
        classes = {run.gaps[place] for place in places[start + 1 : end]} - {""}
        data = stretch.data[start:end]
        if len(data) == 6 and classes <= {":", "-"}:
            return None
        is_dense = not classes or classes <= {":", "-"}
        texts = [run.values[place].text for place in places[start:end]]
        is_decimal = (
            stretch.name == "decimal" or (min(map(len, texts)) == 1 and all(map(str.isdecimal, texts)))
        ) and all(run.values[place].style is Style.BARE for place in places[start:end])
        return reason(data, is_dense=is_dense, is_decimal=is_decimal)


_MOST_STARTS = 8
_MOST_EMPTY = 3
_MOST_BEFORE = 4
_MOST_PARTS = 64
_HEADING = [*"01234567"]
_MOST_SHOWN = 20
_MOST_PREFIX = 3
_PREFIX_ENDS = late_pattern(r"(?:[)\]>]+:?|:)\s+")


def _without_prefix(run: Run, line: str) -> Run:
    """The run without the numbers of a log line in front of it, as in `D/EV3 ( 1234): 0f 00`."""
    for place in range(min(_MOST_PREFIX, len(run.values) - 1), 0, -1):
        gap = line[run.values[place - 1].end : run.values[place].start]
        if _PREFIX_ENDS.fullmatch(gap) and run.gaps[place] != [*run.gaps, ""][place + 1]:
            depth = run.depth - run.opened
            return replace(
                run,
                values=run.values[place:],
                gaps=["", *run.gaps[place + 1 :]],
                changes=None,
                known=None,
                is_head=False,
                opened=0,
                depth=depth,
            )
    return run


def _is_heading(run: Run) -> bool:
    """Whether the values number the columns of a dump."""
    digits = [value.text for value in run.values[: len(_HEADING)] if value.style is Style.BARE]
    return [text.lstrip("0") or "0" for text in digits] == _HEADING


def _ends_within(data: bytes | bytearray, start: int) -> bool:
    """Whether the frame that begins the data ends after that offset, with nothing but zeros after it."""
    end = frame_size(data)
    return is_frame_size(end) and start < end <= len(data) and not any(data[end:])


def _styles(run: Run) -> set[Style]:
    return {run.values[0].style}


def _shape(text: str) -> str:
    """What stands in front of a row, whatever numbers it has."""
    return _DIGITS.sub("0", text).strip()


def _joined(rows: list[Row], *, is_array: bool) -> Run:
    """Rows as one run."""
    values: list[Value] = []
    gaps: list[str] = []
    lines: list[int] = []
    for row in rows:
        assert row.run is not None
        values += row.run.values
        gaps += ["\n", *row.run.gaps[1:]]
        lines += [row.number] * len(row.run.values)
    gaps[0] = ""
    check_sum = rows[-1].run.check_sum if rows[-1].run is not None else None
    return Run(values, gaps, lines=lines, is_array=is_array, check_sum=check_sum)


def _row_of(rows: list[Row], run: Run, place: int) -> Row:
    """The row in which a value of a joined run stands."""
    if not run.lines:
        return rows[0]
    return next(row for row in rows if row.number == run.lines[place])


def bytes_in(line: str) -> bytes:
    """The bytes of the longest run in a line, in its likeliest reading, whether they are a frame or not."""
    bare, _ = without_remarks(without_marks(clean(line)))
    found = runs(without_columns(bare))
    longest = b""
    for run in found:
        for name in readings(run):
            parts = stretches(run, name)
            if len(parts) == 1 and len({*parts[0].places}) == len(run.values):
                longest = max(longest, parts[0].data, key=len)
                break
    return longest
