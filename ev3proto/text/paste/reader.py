"""Finds frames, and what was meant as one, in lines of text.

A line is first searched for what every frame has: a value from 0 to 3 after another value, or that many hex digits.
What has none costs that search and nothing else. A row that ends a line and may begin a frame opens a group: the next
lines may continue it, and are read as if they were joined.
"""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from ev3proto.text.paste.frames import bare_reason, is_one_frame, may_begin
from ev3proto.text.paste.groups import Group, Row
from ev3proto.text.paste.near import AROUND, Near, bare, broken, unclosed, wrong_frame
from ev3proto.text.paste.notations import BASE64, EACH, NUMBERS, STRINGS, expression_at, without_expressions
from ev3proto.text.paste.pieces import (
    LEAST,
    MAX_COLLECTED,
    MAX_LINE,
    MAX_TEXT,
    NO_HEAD,
    Head,
    Pasted,
    Unknown,
    announced,
    check_text,
    direction_of,
    head_before,
    short,
)
from ev3proto.text.paste.readings import Part, Reading, Rows, Run, runs_in, whole
from ev3proto.text.paste.rows import clean, without_columns, without_indexes, without_remarks
from ev3proto.text.paste.strangers import strange_text
from ev3proto.text.paste.values import EXPRESSION, WIDTH, unknown_bytes

_MAY_HAVE = re.compile(
    r"""
    [0-3AQgwxXmM\\|.\u2026\]](?:
    # The second byte of a frame is 0 to 3: a value of its own (0f 00), ...
    (?<=[0-3])(?:
        (?<![1-9ac-gi-wyzAC-GI-WYZ.].)(?<![1-9ac-gi-wyzAC-GI-WYZ.]0.)(?<![1-9ac-gi-wyzAC-GI-WYZ.]00.)
        (?<![1-9ac-gi-wyzAC-GI-WYZ.]000.)(?:(?![0-9a-gi-tv-zA-Z.])|(?=0x))
    # ... or the second of a group of hex digits (0f00xxxx, 0f000000800000, 0f00, 0f.00.00).
      | (?<=[0-9a-fA-F]{2}0.)(?:
            (?=\W?[0-9a-fA-F]{2}\W?[0-9a-fA-F]{2}\W?[08][0-589aA]) | (?=[xX]{4}|[mM]{4})
          # All hex digits of a word, if its type may be wrong.
          | (?<!\w[0-9a-fA-F]{2}0.)(?!\w)
          | (?:(?<!\w[0-9a-fA-F]{2}0.)|(?<=0[xX][0-9a-fA-F]{2}0.))(?=(?:[0-9a-fA-F]{2}){5,}(?!\w)))
      | (?<=\.0.)(?=\.[0-9a-fA-F]{2})
    )
    # A small byte is an escape in a string: \x0f, \u000f, \u{f}, \17.
  | (?<=\\)(?:[xX][0-9a-fA-F]|u00|u\{|[0-3])
    # The lesson's mark, an ellipsis, a length that is unknown.
  | (?<=0[xX]\|) | (?<=\.)\.\. | (?<=\u2026) | (?<=[xXmM])(?<!\w.)[xXmM](?=[\s,:|])
    # Base64, of which the type may be wrong only at the start of a word.
  | (?<=[AQgw])[A-P](?:
        [A-Za-z0-9+/_-]{2}[AQgwIYo4][A-Xg-r]
      | (?:(?<=^..[A-P])|(?<=[^\w+/.-]..[A-P]))[A-Za-z0-9+/_-]{8,}=*(?![\w+/=.]))
    )
    """,
    re.VERBOSE,
)
_TIME_FIRST = re.compile(
    r"""
    (?: \[? (?: (?:\d{4}-)? \d\d[-/]\d\d[T\ ] )? \d\d:\d\d:\d\d (?:[.,]\d+)? (?:Z|[+-]\d\d:?\d\d)? \]? (?=\s)
        (?: \s+ \d{3,5} \s+ \d{3,5} \s )?
    )?
    """,
    re.VERBOSE,
)
"""The date and the time at the start of a line, and the numbers of a process and a thread after them."""

_ONE = re.compile(
    r"""
    [^\w\\]* (?:[A-Za-z_][\w.]*[^\w]{1,6})? (?:0[^\w.]{1,8}(?=\S))? (?:0[xX]|[$&][hH]?)? [0-9a-fA-F]{1,3}[hu]?(?!\w)
    (?: [^\w]* | [^\w]*(?:\#|//|;|/\*).* | \s*\(.{1,4}\)\s* | </\w+>\s* | \s+byte\s* )$
    """,
    re.VERBOSE,
)
"""A row with one value, its name or index in front of it."""

_JOINED = re.compile(r"\.join\(.{0,20}\bop[A-Z].{0,500}\)\s*$")
"""Operations that are joined, as programs for ev3_dc do it."""
_EXCERPT = re.compile(r"\s*\+\d+ \| ")
"""What `check` prints under a finding: the frame itself is above it."""
_STRACE_DUMP = re.compile(r" \| 0[0-9a-f]{4}  ")
"""What `strace -e write` prints below a call that has the same bytes as a string."""
_INDEX_ALONE = re.compile(r"\s*\[\d{1,5}\]\s?=>\s*")
_CHECK_SUM = re.compile(r"\s+FCS: 0x([0-9a-fA-F]{2})\b")
_PREFIX = re.compile(r"(?:.{0,60}?(?:[)\]>]{1,9}:?|:)\s+)?(?:[A-Za-z ]{0,60}[g-zG-Z][A-Za-z]{0,30}:?\s+)?(?=\S)")
_LABEL = re.compile(r"\s+[A-Za-z][a-z]*(?:\s[a-z]+)*\s*")
_SUFFIXES = ("", "u", "U", "u8", "U8")
_MOST_EMPTY = 3
_MOST_BEFORE = 4
_MOST_SHOWN = 20
_MOST_SAID = 16
_MOST_ONE = 80
_MOST_STRANGE = 1000
"""Lines in which something else than a frame is looked for, as long as there is none."""
_MOST_WORDS = MAX_COLLECTED
"""Characters of a line in which a frame may be among words, and which is explained."""


class Ended(NamedTuple):
    """A frame over several lines that is complete: its last row, and how many rows it had."""

    row: Row
    rows: int


class Reader:
    """Reads the frames of a text."""

    def __init__(self) -> None:
        self._group: Group | None = None
        self._before: deque[str] = deque(maxlen=_MOST_SAID)
        self._has_frame = False
        self._has_any = False
        self._found: list[Pasted] = []
        self._strange: Pasted | None = None
        self._ended: Ended | None = None

    def read(self, lines: Iterable[str]) -> Iterator[Pasted]:
        """Yields all pieces in the lines, in their order."""
        for number, line in enumerate(lines, 1):
            check_text(line)
            if len(line) > MAX_LINE:
                self._close()
                problem = f"the line has more than {MAX_LINE} characters and was not read"
                self._found.append(Pasted(b"", number, short(line, MAX_TEXT), problem=problem))
            elif self._group is not None or self._rows_before(number) or _may_have(line):
                self._take(line, number)
            else:
                self._pass(line)
            if not self._has_any and self._strange is None and number <= _MOST_STRANGE:
                said = bare_reason(bytes_in(line)) if _JOINED.search(line) else strange_text(line)
                self._strange = Pasted(b"", number, short(line, MAX_TEXT), problem=said) if said else None
            if self._found:
                yield from self._found
                self._has_any = True
                self._found.clear()
        self._close()
        yield from self._found
        if not self._has_any and not self._found and self._strange is not None:
            yield self._strange

    def _pass(self, line: str) -> None:
        self._has_frame = False
        self._before.append(line)

    def _take(self, line: str, number: int) -> None:
        if self._group is not None:
            if self._continues(self._group, line.rstrip("\r\n"), number):
                self._finish(self._group)
                return
            self._close()
            if not self._rows_before(number) and not _may_have(line):
                self._pass(line)
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

    # One line

    def _first(self, line: str, number: int) -> None:
        """Reads a line that does not continue others."""
        text = clean(line)
        near: list[Near] = []
        left: list[Pasted] = []
        for runs in self._attempts(text, number, near):
            pieces, is_open = self._frames(runs, line)
            if pieces and is_open:
                left = pieces
                break
            if self._emit(pieces):
                return
        if len(line) > _MOST_WORDS:
            self._emit(left)
            return
        row, in_comment = self._row(line, number, text, None)
        if row.may_open:
            was_opened = self._is_opened()
            is_open = was_opened or row.depth > 0
            self._group = Group(is_open, near, in_comment, len(line), self._said(), int(was_opened), left)
            self._group.add(row)
        elif not self._emit(left):
            self._miss(near, [row])

    def _attempts(self, text: str, number: int, near: list[Near] | None) -> Iterator[list[Run]]:
        """Yields the runs of a line in each notation, then all its numbers, whatever is between them.

        Args:
            text: The line, cleaned.
            number: Its number.
            near: Gets what the runs are if none of them is a frame; None if that does not matter.
        """
        line = without_columns(text)
        tried: list[Run] = []
        for notation in (STRINGS, NUMBERS, BASE64):
            runs = [_without_indexes(run) for run in runs_in(line, number, (notation,), 2 * LEAST - 1)]
            yield runs
            tried += runs
        if len(text) > _MOST_WORDS:
            return
        expressed = without_expressions(without_remarks(text)[0])
        if EXPRESSION in expressed:
            runs = [run for run in runs_in(expressed, number, (NUMBERS,)) if run.may_have_expressions]
            yield runs
            tried = [*runs, *tried]
        every = _every(text, number)
        places = without_indexes(every.tokens, 0, LEAST)
        if places is not None:
            tried = [run := every.only(places)]
            yield [run]
        for run in tried if near is not None else ():
            wrong = wrong_frame(run, text, is_row=False) if run.is_long else None
            if near is not None and wrong is not None and all(wrong.data != other.data for other in near):
                near.append(wrong)
        if near:
            return
        # Zeros after a word may be an offset, or the bytes that ask for no memory.
        marked = [place for place, token in enumerate(every.tokens) if WIDTH[token] == 0]
        for some in (marked, *(range(start, len(every.tokens)) for start in range(_MOST_BEFORE))):
            if len(some) >= LEAST - 1 and (one := whole(run := every.only(some))) and is_one_frame(one.data):
                yield [run]

    def _frames(self, runs: list[Run], line: str) -> tuple[list[Pasted], bool]:
        """Returns the frames in the runs of a line, and whether bytes of the next lines may belong to the only one."""
        pieces: list[Pasted] = []
        position = 0
        is_open = False
        for run in runs:
            if not run.is_long:
                continue
            reading = run.readings[0]
            here = self._pieces(run, reading, {run.number: line}, position)
            if here and pieces:
                # A line that shows the same frame in several notations has it once.
                seen = {(piece.data, piece.direction) for piece in pieces}
                here = [piece for piece in here if (piece.data, piece.direction) not in seen]
            pieces += here
            if reading.has_frames:
                position = run.end
                is_open = len(runs) == 1 and (reading.has_rest or (run.is_row and reading.breaks_off))
        return pieces, is_open

    def _pieces(
        self, run: Run, reading: Reading, lines: dict[int, str], position: int = 0, said: Head | None = None
    ) -> list[Pasted]:
        """Returns the frames in a run."""
        found: list[Pasted] = []
        heads: dict[int, Head] = {}
        for part in reading.parts:
            owners: Sequence[int] = ()
            for frame in part.frames:
                data = part.data[frame.start : frame.stop]
                is_in_line = len(data) == len(part.data) and reading.is_complete and len(lines) == 1
                if run.number and (len(run.tokens) == 1 or is_in_line):
                    place = run.number, run.start, run.end
                else:
                    owners = owners or part.owners(run)
                    place = *run.place(owners[frame.start])[:2], run.place(owners[frame.stop - 1])[2]
                piece = self._piece(data, place, lines, position, said, heads)
                if run.unknown:
                    piece = piece._replace(unknown=_unknown(run, part, frame.start, frame.stop, lines))
                found.append(piece)
        return found

    def _piece(
        self,
        data: bytes,
        place: tuple[int, int, int],
        lines: dict[int, str],
        position: int = 0,
        said: Head | None = None,
        heads: dict[int, Head] | None = None,
    ) -> Pasted:
        """Returns bytes with what the text says of them."""
        number, start, stop = place
        line = lines[number]
        heads = {} if heads is None else heads
        if (head := heads.get(number)) is None:
            head = heads[number] = head_before(line, position, start)
        above = said or (self._said() if head.direction is None or head.time is None else NO_HEAD)
        text = line[start:stop] if len(lines) == 1 else "\n".join([*lines.values()][:_MOST_SHOWN])
        direction, time = direction_of(data, line, start, head, above), head.time or above.time
        return Pasted(data, number, short(text, MAX_TEXT), direction, time, column=start + 1)

    def _miss(self, near: list[Near], rows: list[Row], said: Head | None = None) -> None:
        """Emits what lines without a frame have: bytes that were meant as one."""
        lines = {row.number: row.line for row in rows}
        if not near:
            first = rows[0]
            near = [one for one in [self._alone(first)] if one is not None]
        for one in near:
            if one.is_strange:
                if self._strange is None:
                    self._strange = Pasted(b"", one.place[0], short(lines[one.place[0]], MAX_TEXT), problem=one.problem)
                continue
            piece = self._piece(one.data, one.place, lines, said=said)
            piece = piece._replace(cut=one.cut, problem=one.problem, notes=(one.note,) if one.note else ())
            self._emit([piece])

    def _alone(self, row: Row) -> Near | None:
        """Returns what a line without a frame has: a piece that breaks off, or a frame that lacks its header."""
        text = clean(row.line)
        if text.lstrip().startswith(("#", "//")):
            return None
        line = without_columns(without_remarks(text)[0])
        runs = runs_in(line, row.number)
        runs = [run for run in runs if run.is_long] or runs
        found = next((one for run in runs[:1] if (one := broken(run, text, is_sure=False))), None)
        return found or unclosed(text, row.number) or next((one for run in runs[:1] if (one := bare(run, line))), None)

    # Lines that belong together

    def _row(self, line: str, number: int, text: str, group: Group | None) -> tuple[Row, bool]:
        """Returns a line as a part of a frame over several lines, and whether a comment continues."""
        bare_line, in_comment = without_remarks(text, is_inside=group is not None and group.in_comment)
        with_offset = bare_line
        bare_line = without_columns(bare_line, {len(data) for data in group.data()} if group is not None else ())
        first = group.last.runs[0] if group is not None else None
        notation, pattern = NUMBERS, NUMBERS.run
        if first is not None:
            notation, pattern = first.notation, first.notation.more
        elif "\\" in bare_line and STRINGS.run.search(bare_line):
            notation, pattern = STRINGS, STRINGS.run
        if notation is NUMBERS and (group is None or group.has_commas):
            is_inside = group.is_array if group is not None else self._is_opened()
            expressed = without_expressions(bare_line, is_inside=is_inside)
            is_few = expressed.count(EXPRESSION) * 2 < expressed.count(",") + 1
            bare_line = expressed if is_few else bare_line
        prefix = _PREFIX.match(bare_line) if notation is NUMBERS else None
        start = prefix.end() if prefix else 0
        spans = [found.span("run") for found in pattern.finditer(bare_line, start) if found["run"]]
        if not spans:
            return Row(number, line), in_comment
        run = Run(notation, bare_line, *spans[-1], number)
        rest = bare_line[run.end :]
        label = _LABEL.fullmatch(rest) if notation is NUMBERS else None
        is_tail = label is not None or rest.strip(AROUND + ".!?$") in _SUFFIXES
        run.check_sum = self._check_sum()
        every: Run | None = None
        if notation is NUMBERS:
            numbers = _every(bare_line, number)
            marked = [place for place, token in enumerate(numbers.tokens) if WIDTH[token] <= 0]
            index = len(group.tracks[1].runs) if group is not None else self._rows_before(number)
            is_mixed = 0 < len(marked) < len(numbers.tokens)
            places = marked if is_mixed else without_indexes(numbers.tokens, index, 1)
            if places is None and group is None:
                places = without_indexes(numbers.tokens, 0, 1)
            every = None if places is None else numbers.only(places)
        is_head = not bare_line[: run.start].strip(AROUND + "*b")
        depth = sum(map(bare_line.count, "([{")) - sum(map(bare_line.count, ")]}"))
        has_comma = rest.lstrip("'\" )").startswith(",")
        offset = with_offset[: run.start] if with_offset[: run.start] != bare_line[: run.start] else None
        return Row(
            number, line, (run, every), is_head, is_tail, has_comma, depth, label is not None, offset
        ), in_comment

    def _rows_before(self, number: int) -> int:
        """Returns the number of rows of the frame that ended in the line above."""
        return self._ended.rows if self._ended is not None and self._ended.row.number == number - 1 else 0

    def _is_opened(self) -> bool:
        """Returns whether the line above ends with an opening bracket."""
        return bool(self._before) and self._before[-1].rstrip().endswith(("[", "{", "("))

    def _check_sum(self) -> int | None:
        sums = (_CHECK_SUM.match(line) for line in self._before)
        return next((int(found[1], 16) for found in sums if found), None)

    def _continues(self, group: Group, line: str, number: int) -> bool:
        """Takes a line that continues the rows; tells whether it did."""
        last = group.last
        if line.strip() == "*" and last.has_offset:
            self._close(gap=number)
            return False
        if _INDEX_ALONE.fullmatch(line):
            group.add(Row(number, line))
            return True
        text = clean(line)
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
        elif not row.follows(last) or not group.data() or group.is_ended_by(row):
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
                best = run.readings[0]
                if best.is_whole and best.is_flawless and self._emit(self._joined(group, run)):
                    self._end()
                    self._ended = Ended(last, len(track.runs))
                    return
        if not last.is_tail or (group.was_opened and group.depth <= 0):
            self._close()

    def _joined(self, group: Group, run: Run) -> list[Pasted]:
        """Returns the frames in the rows."""
        lines, reading = {row.number: row.line for row in group.rows}, run.readings[0]
        is_sure = reading.is_whole and reading.is_flawless
        is_one = len(group.rows) == 1 or group.is_array or _are_of_one(group.rows)
        if not is_sure and (not is_one or any(row.is_labelled for row in group.rows)):
            return []
        if len(group.rows) > 1 and reading.ends_within and not reading.is_flawless:
            # The length is that of fewer rows, and is wrong.
            return []
        return self._pieces(run, reading, lines, said=group.said)

    def _end(self) -> None:
        """Forgets the rows."""
        assert self._group is not None
        self._before += [row.line for row in self._group.rows[:_MOST_SAID]]
        self._group = None

    def _close(self, gap: int | None = None) -> None:
        """Emits what is in the rows that are not continued.

        Args:
            gap: The number of the line whose `*` says that rows were left out.
        """
        group = self._group
        if group is None:
            return
        rows, near = group.rows, group.near
        self._end()
        first = rows[0]
        if group.size > MAX_COLLECTED:
            if any(may_begin(data) for data in group.data()):
                problem = f"the bytes that start here have more than {MAX_COLLECTED // 1024} KiB of text"
                self._found.append(Pasted(b"", first.number, short(first.line, MAX_TEXT), problem=problem))
            return
        for track in group.live:
            run = Rows(track.runs, is_array=group.is_array) if len(rows) > 1 else track.runs[0]
            pieces = self._joined(group, run)
            # A first row that looks like a frame is not dropped for one that begins after it.
            is_later = bool(near) and bool(pieces) and pieces[0].line != first.number
            if not is_later and self._emit(pieces):
                return
            if gap is not None and (data := run.likely_data()) and may_begin(data):
                problem = f"line {gap}: the dump leaves lines out here, as the * tells; hexdump -v and od -v show all"
                self._emit([Pasted(data, first.number, short(first.line, MAX_TEXT), problem=problem)])
                return
            is_row = not any(row.is_labelled for row in rows)
            is_one = len(rows) > 1 and (group.is_array or _are_of_one(rows))
            one = wrong_frame(run, first.line, is_row=is_row) if is_one else None
            is_later = one is not None and one.place[0] != first.number and not one.is_strange
            if is_later and wrong_frame(track.runs[0], first.line, is_row=True) is not None:
                continue
            if one is not None:
                self._miss([one], rows, group.said)
                return
        if len(rows) == 1 and group.left:
            self._emit(group.left)
        elif not self._is_left_over(group):
            self._apart(rows, near, group.said)

    def _is_left_over(self, group: Group) -> bool:
        """Reports rows that continue those of a frame which is complete without them; tells whether they do."""
        first, ended = group.rows[0], self._ended
        if ended is None or not self._rows_before(first.number) or not first.follows(ended.row):
            return False
        values = [value for run in (group.live[0].runs if group.live else ()) for value in run.tokens]
        are_bytes = max(map(len, values), default=0) <= len("0x00") and len(values) == len(group.rows)
        if not (first.has_offset or are_bytes) or not "".join(values).strip("0x"):
            return False
        count = max(map(len, (group.live[0].data or {}).values()), default=0)
        follow = "1 byte follows" if count == 1 else f"{count} bytes follow"
        problem = f"{follow} the frame that ends in line {ended.row.number}: {short(' '.join(values))}"
        self._found.append(Pasted(b"", first.number, short(first.line, MAX_TEXT), problem=problem))
        return True

    def _apart(self, rows: list[Row], near: list[Near], said: Head) -> None:
        """Emits what each of some rows has by itself, which are not one frame together."""
        left: list[Row] = []
        for row in rows if len(rows) > 1 else ():
            run = row.runs[0]
            if left and run is not None and row.is_tail and not run.readings[0].has_frames:
                begun = None if row.has_offset else wrong_frame(run, row.line, is_row=row.is_head)
                if begun is not None:
                    self._miss(near, left[:1], said)
                    left, near = [], [begun]
                if row.is_head or begun is not None:
                    left.append(row)
                    continue
            own: list[Near] = []
            for runs in self._attempts(clean(row.line), row.number, None if near or left else own):
                pieces, _ = self._frames(runs, row.line)
                if pieces:
                    if left:
                        self._miss(near, left[:1], said)
                    left, near = [], []
                    self._emit(pieces)
                    break
            else:
                near = near or own
                left.append(row)
        if left or len(rows) == 1:
            self._miss(near, left or rows, said)


def _around(run: Run) -> str:
    """Returns what else is in the line of a run."""
    return run.line[: run.start] + run.line[run.end :]


def _are_of_one(rows: list[Row]) -> bool:
    """Returns whether rows may be one frame. Lines of nothing but bytes are only if all but the last are equally long.

    Otherwise each of them is a frame of its own, right or wrong.
    """
    runs = [row.runs[0] for row in rows if row.runs[0] is not None]
    is_plain = all(run.notation is NUMBERS and not _around(run).strip(AROUND) for run in runs)
    if not is_plain or any(row.has_offset for row in rows):
        return True
    sizes = [len(run.likely_data() or b"") for run in runs]
    return len({*sizes[:-1]}) == 1 and sizes[-1] <= sizes[0] and not any(run.readings[0].is_whole for run in runs[1:])


def _unknown(run: Run, part: Part, start: int, stop: int, lines: dict[int, str]) -> tuple[Unknown, ...]:
    """Returns the unknown bytes of a frame, with the expressions that stand for them."""
    found: list[Unknown] = []
    owners = part.owners(run)
    for offset in range(start, stop):
        token = run.tokens[owners[offset]]
        if WIDTH[token] >= 0:
            continue
        first = offset
        while first > 0 and owners[first - 1] == owners[offset]:
            first -= 1
        flags = unknown_bytes(token)
        if offset - first < len(flags) and flags[offset - first]:
            number, column, _ = run.place(owners[offset])
            text = expression_at(lines[number], column) if token == EXPRESSION else ""
            found.append(Unknown(offset - start, number, column + 1, short(text)))
    return tuple(found)


def _may_have(line: str) -> bool:
    """Returns whether a frame, or its first row, may be in a line."""
    time = _TIME_FIRST.match(line)
    start = time.end() if time else 0
    return _MAY_HAVE.search(line, start) is not None or (len(line) < _MOST_ONE and _ONE.match(line, start) is not None)


def _every(line: str, number: int) -> Run:
    """Returns all numbers of a line."""
    run = Run(NUMBERS, line, 0, 0, number)
    run.spans = [found.span(1) for found in EACH.finditer(line) if found[1]]
    run.take([line[start:end] for start, end in run.spans])
    return run


def _without_indexes(run: Run) -> Run:
    places = without_indexes(run.tokens, 0, LEAST) if "0" in run.tokens[:3] else None
    return run if places is None else run.only(places)


def bytes_in(line: str) -> bytes:
    """Returns the bytes of the longest run in a line, in its likeliest reading, whether they are a frame or not."""
    text = without_columns(without_remarks(clean(line))[0])
    notations = (STRINGS, NUMBERS) if "\\" in text else (NUMBERS, BASE64)
    found = (run.likely_data() or b"" for run in runs_in(text, 0, notations))
    return max(found, key=len, default=b"")
