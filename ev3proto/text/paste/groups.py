"""Lines that belong together: the rows of a dump, an array over several lines, strings that are joined."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import NamedTuple

from ev3proto.schema.header import frame_size, may_have_length
from ev3proto.text.paste.frames import LOOKS, is_wrong_frame, may_begin
from ev3proto.text.paste.near import Near
from ev3proto.text.paste.notations import NUMBERS
from ev3proto.text.paste.pieces import LEAST, Head, Pasted
from ev3proto.text.paste.readings import Run

_DIGITS = re.compile(r"0x[0-9a-fA-F]+|[0-9]+")
_FULL_ROW = 16


class Row(NamedTuple):
    """A line that may be a part of a frame.

    number       its number in the text
    line         the line
    runs         the values that may belong to a frame over several lines; those with an index or a mark only
    is_head      nothing is in front of them
    is_tail      nothing follows them
    has_comma    a comma follows
    depth        brackets that the line opens and does not close
    is_labelled  words follow
    offset       what is in front of the values in the row of a dump
    """

    number: int
    line: str
    runs: tuple[Run | None, Run | None] = (None, None)
    is_head: bool = False
    is_tail: bool = False
    has_comma: bool = False
    depth: int = 0
    is_labelled: bool = False
    offset: str | None = None

    @property
    def has_offset(self) -> bool:
        """Whether it is the row of a dump."""
        return self.offset is not None

    @property
    def may_open(self) -> bool:
        """Whether a frame may begin with the row: by its first bytes, or because it is one of a dump."""
        run = self.runs[0]
        if run is None or not self.is_tail:
            return False
        before = run.line[: run.start].rstrip(" \"'b")
        is_closed = self.depth <= 0 and len(run.tokens) >= LEAST and before.endswith(("[", "{", "("))
        counts = [token.lstrip("0") or "0" for token in run.tokens[:8]]
        if (is_closed and run.notation is NUMBERS) or counts == [*"01234567"]:
            return False
        for one in self.runs:
            for name in one.names if one is not None else ():
                data = one.data(name) if one is not None else None
                if data and (self.has_offset or len(data) >= _FULL_ROW or len(data) < 2 or may_have_length(data)):
                    return True
                if data and len(data) >= LEAST and not data[0] and data[1] > LEAST:
                    # The two bytes of the length are swapped.
                    return True
        return False

    def follows(self, last: Row) -> bool:
        """Whether the row is written as the one before it, and begins where that ended."""
        one, other = last.runs[0], self.runs[0]
        assert one is not None
        assert other is not None
        if self.is_head or self.is_labelled:
            return True
        return _DIGITS.sub("0", last.line[: one.start]).strip() == _DIGITS.sub("0", self.line[: other.start]).strip()


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

    was_opened  a bracket is open in front of them
    near        what the first of them is by itself
    in_comment  a comment is open at their end
    size        their characters
    said        what the lines above say of their bytes
    depth       brackets that are open at their end
    left        the frames in the first of them, if the next lines do not belong to it
    tracks      their runs, as they are and without indexes
    has_commas  a comma ends each row but the last
    empty       lines without values at the end
    """

    was_opened: bool
    near: list[Near]
    in_comment: bool
    size: int
    said: Head
    depth: int = 0
    left: list[Pasted] = field(default_factory=list)
    rows: list[Row] = field(default_factory=list)
    tracks: tuple[Track, Track] = field(default_factory=lambda: (Track(), Track()))
    last: Row = field(default_factory=lambda: Row(0, ""))
    has_commas: bool = True
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

    def is_ended_by(self, row: Row) -> bool:
        """Whether a row begins another frame."""
        run, known = row.runs[0], (self.tracks[0].data or {}).items()
        assert run is not None
        if row.offset is not None:
            return not {*row.offset} & {*"123456789abcdefABCDEF"}
        own = run.likely_data() or b""
        if run.readings[0].is_whole:
            # Unless the frame in front of it needs all of these bytes.
            sizes = [(len(data) + len(run.data(name) or b""), data) for name, data in known if len(data) > 1]
            return not any(frame_size(data) >= size for size, data in sizes)
        if len(own) < LOOKS or not may_begin(own):
            return False
        begun = [bytes(data) for _, data in known if len(data) >= LEAST and may_have_length(data)]
        # Two lines of a log may have the same wrong length.
        are_wrong = _is_wrong(own) and any(map(_is_wrong, begun))
        return are_wrong or any(len(data) >= frame_size(data) for data in begun)


def _is_wrong(data: bytes) -> bool:
    return is_wrong_frame(data, is_alone=False, is_decimal=False)
