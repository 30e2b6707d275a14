"""Lines of text to frames, and to what looks like one.

A line is first searched for what every frame has: a value from 0 to 3 after another value, or that many hex digits.
What has none costs that search and nothing else. A row that ends a line and may begin a frame opens a group: the next
lines may continue it, and are read as if they were joined.
"""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from ev3proto.schema.header import frame_size, may_have_length
from ev3proto.tables.frame import MAX_FRAME
from ev3proto.text.paste.frames import bare_reason, is_one_frame, may_begin, reason
from ev3proto.text.paste.notations import (
    ANY_STRING,
    BASE64,
    EACH,
    NUMBERS,
    STRINGS,
    WIDTH,
)
from ev3proto.text.paste.pieces import (
    LEAST,
    MAX_COLLECTED,
    MAX_LINE,
    MAX_TEXT,
    NO_HEAD,
    Head,
    Pasted,
    announced,
    check_text,
    direction_of,
    head_before,
    short,
)
from ev3proto.text.paste.readings import Reading, Rows, Run, starts_of, tried, whole
from ev3proto.text.paste.rows import clean, repeated_rows, without_columns, without_indexes, without_remarks

_H = "[0-9a-fA-F]"
_WORD = "[1-9ac-gi-wyzAC-GI-WYZ.]"
_MAY_HAVE = re.compile(
    r"[0-3AQgw\\|.\u2026](?:"
    # The second byte of a frame is 0 to 3: a value of its own, or the second of a group of hex digits.
    rf"(?<=[0-3])(?:(?<!{_WORD}.)(?<!{_WORD}0.)(?<!{_WORD}00.)(?<!{_WORD}000.)(?:(?![0-9a-gi-tv-zA-Z.])|(?=0x))"
    rf"|(?<={_H}{{2}}0.)(?:(?=\W?{_H}{{2}}\W?{_H}{{2}}\W?[08][0-589aA])|(?<!\w{_H}{{2}}0.)(?!\w))|(?<=\.0.)(?=\.{_H}{{2}}))"
    # A small byte is an escape in a string. The lesson's mark and an ellipsis are worth a report.
    r"|(?<=\\)(?:[xX][0-9a-fA-F]|u00|u\{|[0-3])|(?<=0[xX]\|)|(?<=\.)\.\.|(?<=\u2026)"
    r"|(?<=[AQgw])[A-P][A-Za-z0-9+/_-]{2}[AQgwIYo4][A-Xg-r])"
)
_TIME_FIRST = re.compile(
    r"(?:\[?(?:(?:\d{4}-)?\d\d[-/]\d\d[T ])?\d\d:\d\d:\d\d(?:[.,]\d+)?(?:Z|[+-]\d\d:?\d\d)?\]?(?=\s)"
    r"(?:\s+\d{3,5}\s+\d{3,5}\s)?)?"
)
"""The date and the time at the start of a line, and the numbers of a process and a thread after them."""
# A row with one value, its name or index in front of it.
_ONE = re.compile(
    rf"[^\w\\]*(?:[A-Za-z_][\w.]*[^\w]{{1,6}})?(?:0[^\w.]{{1,8}}(?=\S))?(?:0[xX]|[$&][hH]?)?{_H}{{1,3}}[hu]?(?!\w)"
    r"(?:[^\w]*|[^\w]*(?:#|//|;|/\*).*|\s*\(.{1,4}\)\s*|</\w+>\s*|\s+byte\s*)$"
)
# What `check` prints under a finding: the frame itself is above it.
_EXCERPT = re.compile(r"\s*\+\d+ \| ")
_INDEX_ALONE = re.compile(r"\s*\[\d{1,5}\]\s?=>\s*")
_CHECK_SUM = re.compile(r"\s+FCS: 0x([0-9a-fA-F]{2})\b")
_DIGITS = re.compile(r"[0-9]+|0x[0-9a-fA-F]+")
_PREFIX = re.compile(r"(?:.{0,60}?(?:[)\]>]+:?|:)\s+)?(?:[A-Za-z ]*[g-zG-Z][A-Za-z]*:?\s+)?(?=\S)")
_LABEL = re.compile(r"\s+[A-Za-z][a-z]*(?:\s[a-z]+)*\s*")
# A row of what `strace -e write` prints below a call which has the same bytes as a string.
_STRACE_DUMP = re.compile(r" \| 0[0-9a-f]{4}  ")
_AROUND = " \t\r\n\f\v,;:|+&/\\\"'`<>()[]{}_-="
_ENDS = ("", "u", "U", "u8", "U8")
_MOST_STARTS = 8
_MOST_EMPTY = 3
_MOST_BEFORE = 4
_MOST_SHOWN = 20
_MOST_SAID = 16
_MOST_ONE = 80
_MOST_WORDS = MAX_COLLECTED
"""Characters of a line in which a frame may be among words, and which is explained."""


class Row(NamedTuple):
    """A line that may be a part of a frame.

    number      its number in the text
    line        the line
    runs        the values that may belong to a frame over several lines; those with an index or a mark only
    is_head     nothing is in front of them
    is_tail     nothing follows them
    has_comma   a comma follows
    depth       brackets that the line opens and does not close
    is_labelled words follow
    said        what the lines above say of its bytes
    """

    number: int
    line: str
    runs: tuple[Run | None, Run | None] = (None, None)
    is_head: bool = False
    is_tail: bool = False
    has_comma: bool = False
    depth: int = 0
    is_labelled: bool = False
    has_offset: bool = False


@dataclass(slots=True)
class Track:
    """The runs of consecutive rows, and their bytes by reading: those that fit all of the values."""

    runs: list[Run] = field(default_factory=list)
    data: dict[str, bytearray] | None = None
    was_padded: bool = False

    def take(self, run: Run | None) -> None:
        """Adds a run; without one no reading fits any more."""
        if self.data is None:
            self.data = {} if run is None else {name: bytearray() for name in run.names}
        for name in list(self.data):
            part = None if run is None else run.data(name)
            if part is None:
                del self.data[name]
            else:
                self.data[name] += part
        if run is not None:
            self.runs.append(run)

    def is_complete(self) -> bool:
        """Whether some reading has as many bytes as its length field says."""
        begun = [data for data in (self.data or {}).values() if len(data) >= LEAST and may_have_length(data)]
        if any(frame_size(data) == len(data) for data in begun):
            return True
        # Zeros after a frame are padding, unless another reading takes them for a part of its frame.
        ends = [(frame_size(data), data) for data in begun]
        is_padded = bool(ends) and all(end <= len(data) and not any(data[end:]) for end, data in ends)
        is_second, self.was_padded = is_padded and self.was_padded, self.was_padded or is_padded
        return is_padded and not is_second


@dataclass(slots=True)
class Group:
    """Rows that the next line may continue.

    tracks      their runs, as they are and without indexes
    looks       what the first of them looks like by itself
    has_commas  a comma ends each row but the last
    has_gap     a `*` replaces rows like the one before it, as many as the next offset says
    """

    was_opened: bool
    looks: Pasted | None
    in_comment: bool
    size: int
    said: Head
    depth: int = 0
    rows: list[Row] = field(default_factory=list)
    tracks: tuple[Track, Track] = field(default_factory=lambda: (Track(), Track()))
    last: Row = field(default_factory=lambda: Row(0, ""))
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
        self.depth += row.depth
        if row.runs[0] is not None:
            self.has_commas = self.has_commas and (not self.last.number or self.last.has_comma)
            self.last, self.empty = row, 0
            for track, run in zip(self.tracks, row.runs, strict=True):
                track.take(run)

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
        last, run = self.last, self.last.runs[0]
        for name, data in (self.tracks[0].data or {}).items():
            size = len(run.data(name) or b"") if run is not None else 0
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
        self._before: deque[str] = deque(maxlen=_MOST_SAID)
        self._has_frame = False
        self._found: list[Pasted] = []

    def read(self, lines: Iterable[str]) -> Iterator[Pasted]:
        """Yields all pieces in the lines, in their order."""
        for number, line in enumerate(lines, 1):
            check_text(line)
            if len(line) > MAX_LINE:
                self._close()
                problem = f"the line has more than {MAX_LINE} characters and was not read"
                self._found.append(Pasted(b"", number, short(line, MAX_TEXT), problem=problem))
            elif self._group is not None or _may_have(line):
                self._take(line, number)
            else:
                self._has_frame = False
                self._before.append(line)
            if self._found:
                yield from self._found
                self._found.clear()
        self._close()
        yield from self._found

    def _take(self, line: str, number: int) -> None:
        if self._group is not None:
            line = line.rstrip("\r\n")
            if self._continues(self._group, line, number):
                self._finish(self._group)
                return
            self._close()
            if not _may_have(line):
                self._has_frame = False
                self._before.append(line)
                return
        is_shown_again = _EXCERPT.match(line) or (self._has_frame and _STRACE_DUMP.match(line))
        self._has_frame = False
        if not is_shown_again:
            self._first(line.rstrip("\r\n"), number)
        if not self._has_frame:
            self._before.append(line)
        elif line[:1].strip():
            # What was said above is true for a line and for those below it that are indented.
            self._before.clear()

    def _said(self) -> Head:
        """Returns what the lines above say: the last one, or those above it where these are indented."""
        for line in reversed(self._before):
            said = announced(line)
            if said is not None:
                return said
            if line[:1].strip():
                break
        return NO_HEAD

    def _emit(self, pieces: list[Pasted]) -> bool:
        """Adds frames to what was found; tells whether there are any."""
        self._found += pieces
        self._has_frame = self._has_frame or bool(pieces)
        return bool(pieces)

    def _first(self, line: str, number: int) -> None:
        """Reads a line that does not continue others."""
        text = clean(line)
        looks = None
        for runs in self._attempts(text, number):
            pieces, why = self._frames(runs, line)
            looks = looks or why
            if self._emit(pieces):
                return
        row, in_comment = (
            self._row(line, number, text, None) if len(line) <= _MOST_WORDS else (Row(number, line), False)
        )
        if row.runs[0] is not None and row.is_tail and _may_open(row):
            was_opened = bool(self._before) and self._before[-1].rstrip().endswith(("[", "{", "("))
            is_open = was_opened or row.depth > 0
            self._group = Group(is_open, looks, in_comment, len(line), self._said(), int(was_opened))
            self._group.add(row)
        else:
            self._left([row], {number: looks})

    def _attempts(self, text: str, number: int) -> Iterator[list[Run]]:
        """Yields the runs of a line in each notation, then all its numbers, whatever is between them."""
        line = without_columns(text)
        for notation in (STRINGS, NUMBERS, BASE64) if "\\" in line else (NUMBERS, BASE64):
            found = [
                Run(notation, line, *match.span("run"), number)
                for match in notation.run.finditer(line)
                if match["run"] and match.end() - match.start() >= 2 * LEAST - 1
            ]
            yield [_without_indexes(run) for run in found]
        if len(text) > _MOST_WORDS:
            return
        # Zeros after a word may be an offset, or the bytes that ask for no memory.
        every = _every(text, number)
        places = without_indexes(every.tokens, 0, LEAST)
        if places is not None:
            yield [every.only(places)]
        marked = [place for place, token in enumerate(every.tokens) if WIDTH[token] == 0]
        for some in (marked, *(range(start, len(every.tokens)) for start in range(_MOST_BEFORE))):
            if len(some) >= LEAST - 1 and (one := whole(run := every.only(some))) and is_one_frame(one.data):
                yield [run]

    def _frames(self, runs: list[Run], line: str) -> tuple[list[Pasted], Pasted | None]:
        """Returns the frames in the runs of a line, and what looks like one where there is none."""
        pieces: list[Pasted] = []
        looks: Pasted | None = None
        position = 0
        for run in runs:
            if not run.is_long:
                continue
            lines = {run.number: line}
            readings = tried(run)
            here = self._pieces(run, readings[0], lines, position)
            if here and pieces:
                # A line that shows the same frame in several notations has it once.
                seen = {(piece.data, piece.direction) for piece in pieces}
                here = [piece for piece in here if (piece.data, piece.direction) not in seen]
            pieces += here
            if readings[0].has_frames:
                position = run.end
            elif looks is None and not pieces and len(line) <= _MOST_WORDS:
                looks = _looks(run, readings, lines)
        return pieces, looks

    def _pieces(
        self, run: Run, reading: Reading, lines: dict[int, str], position: int = 0, said: Head | None = None
    ) -> list[Pasted]:
        """Returns the frames in a run."""
        found: list[Pasted] = []
        heads: dict[int, Head] = {}
        for part in reading.parts:
            owners: Sequence[int] = ()
            for frame in part.frames:
                # Padding belongs to the frame in front of it, which is how it is reported.
                is_padded = len(part.frames) == 1 and part.last == len(run.tokens) and not any(part.data[frame.end :])
                data = part.data[frame.start : None if is_padded else frame.end]
                if len(run.tokens) == 1 or (len(data) == len(part.data) and reading.is_complete and len(lines) == 1):
                    number, start, stop = run.number, run.start, run.end
                else:
                    owners = owners or part.owners(run)
                    number, start, _ = run.place(owners[frame.start])
                    stop = run.place(owners[frame.end - 1])[2]
                line = lines[number]
                if (head := heads.get(number)) is None:
                    head = heads[number] = head_before(line, position, start)
                above = said or (self._said() if head.direction is None or head.time is None else NO_HEAD)
                text = line[start:stop] if len(lines) == 1 else "\n".join([*lines.values()][:_MOST_SHOWN])
                direction, time = direction_of(data, line, start, head, above), head.time or above.time
                found.append(Pasted(data, number, short(text, MAX_TEXT), direction, time, column=start + 1))
        return found

    # Lines that belong together

    def _row(self, line: str, number: int, text: str, group: Group | None) -> tuple[Row, bool]:
        """Returns a line as a part of a frame over several lines, and whether a comment continues."""
        bare, in_comment = without_remarks(text, is_inside=group is not None and group.in_comment)
        with_offset = bare
        bare = without_columns(bare, {len(data) for data in group.data()} if group is not None else ())
        first = group.last.runs[0] if group is not None else None
        notation, pattern = NUMBERS, NUMBERS.run
        if first is not None:
            notation = first.notation
            pattern = ANY_STRING if notation is STRINGS else notation.run if notation is NUMBERS else _BASE64_ROW
        elif "\\" in bare and STRINGS.run.search(bare):
            notation, pattern = STRINGS, STRINGS.run
        prefix = _PREFIX.match(bare) if notation is NUMBERS else None
        spans = [found.span("run") for found in pattern.finditer(bare, prefix.end() if prefix else 0) if found["run"]]
        if not spans:
            return Row(number, line), in_comment
        run = Run(notation, bare, *spans[-1], number)
        rest = bare[run.end :]
        label = _LABEL.fullmatch(rest) if notation is NUMBERS else None
        is_tail = label is not None or rest.strip(_AROUND + ".!?$") in _ENDS
        run.check_sum = self._check_sum()
        every: Run | None = run
        if notation is NUMBERS:
            every = _every(bare, number)
            marked = [place for place, token in enumerate(every.tokens) if WIDTH[token] == 0]
            index = 0 if group is None else len(group.tracks[1].runs)
            is_mixed = 0 < len(marked) < len(every.tokens)
            places = marked if is_mixed else without_indexes(every.tokens, index, 1)
            every = None if places is None else every.only(places)
        else:
            every = None
        is_head = not bare[: run.start].strip(_AROUND + "*b")
        depth = sum(map(bare.count, "([{")) - sum(map(bare.count, ")]}"))
        has_comma = rest.lstrip("'\" )").startswith(",")
        has_offset = with_offset is not bare and with_offset[: run.start] != bare[: run.start]
        return Row(
            number, line, (run, every), is_head, is_tail, has_comma, depth, label is not None, has_offset
        ), in_comment

    def _check_sum(self) -> int | None:
        sums = (_CHECK_SUM.match(line) for line in self._before)
        return next((int(found[1], 16) for found in sums if found), None)

    def _continues(self, group: Group, line: str, number: int) -> bool:
        """Takes a line that continues the rows; tells whether it did."""
        last = group.last
        assert last.runs[0] is not None
        if line.strip() == "*" and not group.has_gap:
            group.has_gap = True
            group.add(Row(number, line))
            return True
        if group.has_gap and not group.fill(line):
            return False
        if _INDEX_ALONE.fullmatch(line):
            group.add(Row(number, line))
            return True
        text = clean(line, has_cells=last.runs[0].notation is STRINGS)
        row, in_comment = self._row(line, number, text, group)
        if row.runs[0] is None:
            # Only a list with commas continues after a comment, and after more than some empty lines.
            group.empty += 1
            has_begun = any(len(data) >= LEAST for data in group.data())
            is_empty = has_begun and not text.strip() and group.empty <= _MOST_EMPTY
            if not group.in_comment and not last.has_comma and not is_empty:
                return False
            if without_columns(without_remarks(text, is_inside=group.in_comment)[0], {0}).strip():
                return False
        elif not _follows(last, row) or not group.data() or _stands_alone(group, row.runs[0]):
            return False
        group.size += len(line) + 1
        if group.size <= MAX_COLLECTED:
            # Longer ones are read to their end all the same: their rows are not frames of their own.
            group.in_comment = in_comment
            group.add(row)
        return True

    def _finish(self, group: Group) -> None:
        """Emits the frame that the rows make, when the last of them ended it."""
        last = group.rows[-1]
        if last.runs[0] is None:
            return
        # What has an index or a mark in each row is meant without the rest.
        for track in group.live[:1] if not (group.is_array and group.depth > 0) else ():
            if track.is_complete():
                run = Rows(track.runs, is_array=group.is_array)
                best = tried(run)[0]
                if best.is_whole and self._emit(self._joined(group, run, best)):
                    self._end()
                    return
        if not last.is_tail or (group.was_opened and group.depth <= 0):
            self._close()

    def _joined(self, group: Group, run: Run, reading: Reading) -> list[Pasted]:
        """Returns the frames in the rows."""
        lines = {row.number: row.line for row in group.rows}
        if any(row.is_labelled for row in group.rows) and not (reading.is_whole and reading.is_flawless):
            return []
        return self._pieces(run, reading, lines, said=group.said)

    def _end(self) -> None:
        """Forgets the rows."""
        assert self._group is not None
        self._before += [row.line for row in self._group.rows[:_MOST_SAID]]
        self._group = None

    def _close(self) -> None:
        """Emits what is in the rows that are not continued."""
        group = self._group
        if group is None:
            return
        rows, looks = group.rows, group.looks
        lines = {row.number: row.line for row in rows}
        self._end()
        if group.size > MAX_COLLECTED:
            if any(may_begin(data) for data in group.data()):
                problem = f"the bytes that start here have more than {MAX_COLLECTED // 1024} KiB of text"
                self._found.append(Pasted(b"", rows[0].number, short(rows[0].line, MAX_TEXT), problem=problem))
            return
        for track in group.live if len(rows) > 1 else ():
            run = Rows(track.runs, is_array=group.is_array)
            readings = tried(run)
            pieces = self._joined(group, run, readings[0])
            # A first row that looks like a frame is not dropped for one that begins after it.
            is_later = group.looks is not None and bool(pieces) and pieces[0].line != rows[0].number
            if not is_later and self._emit(pieces):
                return
            looks = looks or _looks(run, readings, lines)
        left: list[Row] = []
        reasons: dict[int, Pasted | None] = {}
        for row in rows:
            why, pieces = None, []
            for runs in self._attempts(clean(row.line), row.number) if len(rows) > 1 else ():
                pieces, one = self._frames(runs, row.line)
                why = why or one
                if pieces:
                    break
            if pieces:
                self._left(left, reasons)
                left = []
                self._emit(pieces)
            else:
                left.append(row)
                reasons[row.number] = why
        if len(left) == len(rows) and not any(reasons.values()):
            reasons[rows[0].number] = looks
        self._left(left, reasons, is_array=group.was_opened and len(rows) > 1 and rows[0].depth <= 0)

    def _left(self, rows: list[Row], looks: dict[int, Pasted | None], *, is_array: bool = False) -> None:
        """Emits what there is in rows without a frame: where one breaks off, or what looks like one."""
        if not rows or len(rows[0].line) > _MOST_WORDS:
            return
        from ev3proto.text.paste.mistakes import broken  # takes 4 ms, which texts of nothing but frames have no use for

        first = rows[0]
        found = broken([row.line for row in rows], first.number, is_sure=False, is_array=is_array)
        gap = next((row.number for row in rows if row.line.strip() == "*"), None)
        plain = first.runs[0].likely_data() if first.runs[0] is not None else None
        if gap is not None and plain is not None and may_begin(plain):
            problem = f"line {gap}: the dump leaves lines out here, as the * tells"
            found = [Pasted(plain, first.number, short(first.line, MAX_TEXT), problem=problem)]
        for piece in found:
            # What lacks only its header is reported as such.
            why = looks.get(piece.line)
            if piece.problem is not None or piece.cut or why is None or why.problem != bare_reason(piece.data):
                looks = {}
                self._found.append(piece)
        self._found += [why for row in rows if (why := looks.get(row.number)) is not None]


def _may_have(line: str) -> bool:
    """Whether a frame may be in a line, or the first row of one."""
    time = _TIME_FIRST.match(line)
    found = _MAY_HAVE.search(line, time.end() if time else 0)
    return found is not None or (len(line) < _MOST_ONE and _ONE.match(line) is not None)


def _every(line: str, number: int) -> Run:
    """Returns all numbers of a line."""
    run = Run(NUMBERS, line, 0, 0, number)
    run.spans = [found.span(1) for found in EACH.finditer(line) if found[1]]
    run.take([line[start:end] for start, end in run.spans])
    return run


def _without_indexes(run: Run) -> Run:
    places = without_indexes(run.tokens, 0, LEAST) if "0" in run.tokens[:3] else None
    return run if places is None else run.only(places)


_BASE64_ROW = re.compile(r"\s*(?P<run>[A-Za-z0-9+/_-]+={0,3})\s*$")


def bytes_in(line: str) -> bytes:
    """Returns the bytes of the longest run in a line, in its likeliest reading, whether they are a frame or not."""
    bare = without_columns(without_remarks(clean(line))[0])
    found = (
        Run(notation, bare, *match.span("run")).likely_data() or b""
        for notation in ((STRINGS, NUMBERS) if "\\" in bare else (NUMBERS, BASE64))
        for match in notation.run.finditer(bare)
        if match["run"]
    )
    return max(found, key=len, default=b"")


def _looks(run: Run, readings: list[Reading], lines: dict[int, str]) -> Pasted | None:
    """Returns as what a run that is not a frame is reported; None where it does not look like one."""
    is_name = run.notation is NUMBERS and run.tokens[0][:1].isalpha() and WIDTH[run.tokens[0]] == 0
    if run.notation is BASE64 or is_name or (len(run.tokens) == 1 and len(run.tokens[0]) <= 3):
        return None
    for part in (
        part for one in readings for part in one.parts if len(part.data) >= LEAST and "words" not in part.name
    ):
        for start in [at for at in starts_of(run, part) if at < len(part.data)][:_MOST_STARTS]:
            problem = _why(run, part.name, part.data, part.owners(run), start, lines)
            if problem is not None:
                number, column, _ = run.place(part.owners(run)[start])
                text = short(lines[number][column:], MAX_TEXT)
                return Pasted(b"", number, text, problem=problem, column=column + 1, unread=True)
    return None


def _why(run: Run, name: str, data: bytes, owners: Sequence[int], start: int, lines: dict[int, str]) -> str | None:
    """Returns why the bytes from there on look like a frame: up to the next edge."""
    end = start + 1
    while end < len(data) and (owners[end] == owners[end - 1] or owners[end] not in run.edges):
        end += 1
    tokens = [run.tokens[place] for place in sorted({*owners[start:end]})]
    data, is_all = data[start:end], start == 0 and end == len(data)
    is_dense = len(lines) == 1 and not {*run.line[run.start : run.end]} & {*" ,;"}
    widths = set(map(WIDTH.__getitem__, tokens))
    if is_all and name == "hex" and 1 not in widths and len({*data}) >= LEAST - 1 and len(lines) == 1:
        around = run.line[: run.start] + run.line[run.end :]
        is_hash = is_dense and (len(data) == 6 or (len(tokens) == 1 and len(data) in (16, 20, 28, 32, 48, 64)))
        if not around.strip(_AROUND) and not is_hash and (why := bare_reason(data)):
            return why
    is_decimal = 0 not in widths and (name == "decimal" or (1 in widths and all(token.isdecimal() for token in tokens)))
    return reason(data, is_dense=is_dense, is_decimal=is_decimal)


def _may_open(row: Row) -> bool:
    """Whether a frame may begin with a row: by its first bytes, or because it is one of a dump."""
    run = row.runs[0]
    assert run is not None
    is_closed = row.depth <= 0 and len(run.tokens) >= LEAST and row.line[: run.start].rstrip(" \"'b")[-1:] in {*"[{("}
    counts = [token.lstrip("0") or "0" for token in run.tokens[:8]]
    if (is_closed and run.notation is NUMBERS) or counts == [*"01234567"]:
        return False
    for one in row.runs:
        for name in one.names if one is not None else ():
            data = one.data(name) if one is not None else None
            if data and (row.has_offset or len(data) >= 16 or len(data) < 2 or may_have_length(data)):
                return True
    return False


def _follows(last: Row, row: Row) -> bool:
    """Whether a row is written as the one before it, and begins where that ended."""
    one, other = last.runs[0], row.runs[0]
    assert one is not None
    assert other is not None
    if row.is_head or row.is_labelled:
        return True
    return _DIGITS.sub("0", last.line[: one.start]).strip() == _DIGITS.sub("0", row.line[: other.start]).strip()


def _stands_alone(group: Group, run: Run) -> bool:
    """Whether a row is a frame of its own, which does not end the frame in front of it."""
    return tried(run)[0].is_whole and not any(
        len(data) > 1 and len(data) < frame_size(data) <= len(data) + len(run.data(name) or b"")
        for name, data in (group.tracks[0].data or {}).items()
    )
