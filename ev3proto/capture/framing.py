"""One direction of a byte stream cut into frames, the texts around them, and what is neither.

Nothing in a stream marks where a frame starts: each starts where the one before ended. Where that chain is broken (a
capture begun in the middle, bytes that were not captured, a length that no frame can have) the next frame is looked
for: a place where all of a frame stands without a fault.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from enum import Enum, auto
from typing import NamedTuple

from ev3proto.errors import DecodeError, counted
from ev3proto.schema.discovery import UNLOCK
from ev3proto.schema.frame import FrameSchema
from ev3proto.schema.header import HEADER_SIZE, frame_size, impossible_length, is_frame_size, unpack_header
from ev3proto.tables.discovery import ACCEPT, MOST_UNLOCK, UNLOCK_REQUEST
from ev3proto.tables.frame import LENGTH_FIELD, MAX_FRAME, MAX_LENGTH, MIN_LENGTH, MessageType

MARK_SIZE = 200
"""Bytes of memory that a packet takes whose bytes wait for more, besides these, about."""

MOST_TRIALS = 64
"""Places in one piece of a stream where a whole frame is tried, before the piece is given up."""

_TYPES = frozenset(map(int, MessageType))
_REQUEST = UNLOCK_REQUEST.encode()
_TEXT_STARTS = {ACCEPT[0], _REQUEST[0]}
# Where a frame's header or a text may stand: a stream that is none of ours is passed over ten times as fast with it.
_STARTS = re.compile(
    b"(?=(?:[%b-\\xff]\\0|.[\\1-%b])..[%b]|%b|%b)"
    % (
        re.escape(bytes((MIN_LENGTH,))),
        re.escape(bytes((MAX_LENGTH >> 8,))),
        re.escape(bytes(sorted(_TYPES))),
        re.escape(ACCEPT),
        re.escape(_REQUEST),
    ),
    re.DOTALL,
)
_LINE_END = b"\r\n"
_BEGUN_INSIDE, _BETWEEN = "the capture begins inside a frame", "bytes between frames"


class PartKind(Enum):
    """What a piece of a stream is."""

    FRAME = auto()
    UNLOCK = auto()
    ACCEPT = auto()
    TEXT_END = auto()
    LOST = auto()
    OTHER = auto()


_TEXTS = (PartKind.UNLOCK, PartKind.ACCEPT)


class StreamPart(NamedTuple):
    """A piece of a stream.

    kind     what it is; TEXT_END is the rest of a text that came before, OTHER is none of ours
    data     the bytes
    numbers  the packets they came in
    reason   for LOST: why it cannot be read
    """

    kind: PartKind
    data: bytes
    numbers: tuple[int, ...]
    reason: str = ""


class Cutter:
    """Cuts one direction of a stream. It keeps at most one unfinished frame or text beside what it was last given.

    schema      reads frames, to see whether one starts somewhere
    in_step     a frame starts with the first byte; else the first one is looked for
    is_claimed  the stream is known to be ours; else it is once something like a frame starts with a chunk
    """

    __slots__ = ("_after_text", "_buffer", "_in_step", "_is_claimed", "_marks", "_reason", "_rest", "_schema")

    def __init__(self, schema: FrameSchema, *, in_step: bool, is_claimed: bool = True) -> None:
        self._schema = schema
        self._buffer = b""
        self._marks: list[tuple[int, int]] = []  # where in the buffer each packet's bytes start
        self._in_step = in_step
        self._is_claimed = is_claimed
        self._rest = 0  # bytes to come of a frame in which some are missing; after them the stream is in step
        self._after_text: PartKind | None = None
        self._reason = "" if in_step else _BEGUN_INSIDE

    def feed(self, data: bytes, number: int) -> list[StreamPart]:
        """The pieces that are complete with the next bytes of the stream, which came in that packet."""
        if self.takes_whole(data):
            return [StreamPart(PartKind.FRAME, data, (number,))]
        self._marks.append((len(self._buffer), number))
        self._buffer += data
        return self._cut()

    def takes_whole(self, data: bytes) -> bool:
        """Whether the next bytes of the stream are one frame and nothing else. If so, they are taken with this."""
        size = len(data)
        if self._buffer or not self._in_step or size < HEADER_SIZE or size > MAX_FRAME:
            return False
        if frame_size(data) != size:
            return False
        self._after_text = None
        return True

    @property
    def is_claimed(self) -> bool:
        """Whether the stream is known to be ours."""
        return self._is_claimed

    @property
    def waiting(self) -> list[int]:
        """The packets whose bytes wait for more."""
        return [number for _, number in self._marks] if self._marks else []

    @property
    def size(self) -> int:
        """Bytes of memory that what waits takes, about."""
        return len(self._buffer) + MARK_SIZE * len(self._marks)

    def give_up(self, reason: str) -> list[StreamPart]:
        """Waits no longer for the rest of what is there: the next frame is looked for."""
        waiting = self._give_up() + self._take_all(reason)
        self._in_step, self._after_text, self._reason = False, None, _BETWEEN
        return waiting

    def leave_hole(self, missing: int) -> list[StreamPart]:
        """Says that bytes are missing in the stream here, 0 where it is not known how many: what waits is given up."""
        what = "text" if self._is_in_text() else "frame"
        waiting = self._give_up()
        rest = self._rest_after(missing) if what == "frame" else None
        waiting += self._take_all(f"the rest of the {what} is not in the capture")
        self._in_step, self._rest = rest == 0, rest or 0
        self._after_text = None
        self._reason = (
            f"bytes of a frame whose start is missing with {counted(missing, 'byte')}" if missing else _BEGUN_INSIDE
        )
        return waiting

    def _rest_after(self, missing: int) -> int | None:
        """How many bytes of the frame that waits come after a hole; None where that cannot be known."""
        if self._rest:
            rest = self._rest - len(self._buffer) - missing
        elif self._in_step and missing and len(self._buffer) >= LENGTH_FIELD:
            rest = frame_size(self._buffer) - len(self._buffer) - missing
        else:
            return None
        return rest if rest >= 0 else None

    def end(self) -> list[StreamPart]:
        """Says that nothing more will come."""
        found = self._give_up()
        buffer = self._buffer
        is_text = self._is_in_text()
        reason = (
            f"the stream ends inside a {'text' if is_text else 'frame'}, of which {counted(len(buffer), 'byte')} came"
        )
        if self._in_step and self._is_claimed and len(buffer) >= LENGTH_FIELD and not is_text:
            reason += f" and {frame_size(buffer) - len(buffer)} are missing"
        return found + self._take_all(reason)

    def _give_up(self) -> list[StreamPart]:
        """What there is after a place where a frame might have started, of which no more will come."""
        return [] if self._in_step or not self._is_claimed else self._cut(is_last=True)

    def _is_in_text(self) -> bool:
        """Whether what waits is the beginning of a text."""
        return len(self._buffer) >= LENGTH_FIELD and self._is_part_of_text(self._buffer)

    def _take_all(self, reason: str) -> list[StreamPart]:
        if not self._buffer:
            return []
        kind = PartKind.LOST if self._is_claimed else PartKind.OTHER
        if self._after_text is PartKind.UNLOCK and not self._buffer.strip(_LINE_END):
            kind = PartKind.TEXT_END
        piece = self._piece(kind, 0, len(self._buffer), self._reason or reason)
        self._buffer, self._marks = b"", []
        if kind is PartKind.LOST:
            # Should more come all the same, it does not start with a frame.
            self._in_step, self._reason = False, _BETWEEN
        return [piece]

    def _cut(self, *, is_last: bool = False) -> list[StreamPart]:
        buffer, at = self._buffer, 0
        found: list[StreamPart] = []
        trials = MOST_TRIALS
        if self._rest and buffer:
            at = min(self._rest, len(buffer))
            found.append(self._piece(PartKind.LOST, 0, at, self._reason))
            self._rest -= at
            self._in_step = not self._rest
        while at < len(buffer):
            kind, end = self._next(buffer, at)
            if is_last and kind is PartKind.FRAME and end > len(buffer) and not self._in_step:
                kind = PartKind.LOST
            if kind is PartKind.LOST:
                end, trials = self._next_step(buffer, at + 1, trials)
            if end > len(buffer):
                break
            reason = self._lost(buffer, at) if kind is PartKind.LOST else ""
            found.append(self._piece(kind, at, end, reason))
            if kind is PartKind.FRAME or kind in _TEXTS:
                self._is_claimed, self._in_step, self._reason = True, True, ""
            if kind is not PartKind.TEXT_END:
                self._after_text = kind if kind in _TEXTS else None
            at = end
        if at == 0:
            return found
        self._marks = [(max(start - at, 0), number) for start, number, stop in self._spans() if stop > at]
        self._buffer = buffer[at:]
        return found

    def _spans(self) -> Iterator[tuple[int, int, int]]:
        """Each packet's bytes in the buffer: start, number, end."""
        for index, (start, number) in enumerate(self._marks):
            last = index + 1 == len(self._marks)
            yield start, number, len(self._buffer) if last else self._marks[index + 1][0]

    def _piece(self, kind: PartKind, at: int, end: int, reason: str = "") -> StreamPart:
        numbers = tuple(dict.fromkeys(number for start, number, stop in self._spans() if start < end and stop > at))
        return StreamPart(kind, self._buffer[at:end], numbers, reason)

    def _lost(self, buffer: bytes, at: int) -> str:
        if self._in_step:
            self._in_step = False
            self._reason = _BETWEEN
            return impossible_length(frame_size(buffer, at) - LENGTH_FIELD)
        return self._reason

    def _next(self, buffer: bytes, at: int) -> tuple[PartKind, int]:
        """What stands at an offset and where it ends, which is after the buffer's end where more is needed."""
        more = len(buffer) + 1
        text = self._text(buffer, at)
        if text is not None:
            return text
        if len(buffer) - at < LENGTH_FIELD:
            return PartKind.FRAME, more
        size = frame_size(buffer, at)
        end = at + size
        if self._in_step:
            if not is_frame_size(size):
                return PartKind.LOST, more
            return PartKind.FRAME, end
        if not self._may_start(buffer, at):
            return (PartKind.LOST, more) if self._is_claimed else (PartKind.OTHER, self._end_of_chunk(at))
        if not self._is_claimed:
            if len(buffer) - at < HEADER_SIZE:
                return PartKind.FRAME, more
            self._is_claimed = self._in_step = True
            return PartKind.FRAME, end
        if end <= len(buffer) and self._schema.is_flawless(buffer, at, end):
            return PartKind.FRAME, end
        # Senders begin their frames with a packet: there one may also be at fault, or not be whole yet. But where
        # something stands in the middle of it that cannot be by chance, it is none.
        is_start = any(start == at for start, _ in self._marks)
        if not is_start or any(start > at and self._stands(buffer, start) for start, _ in self._marks[-2:]):
            return PartKind.LOST, more
        return PartKind.FRAME, end if end <= len(buffer) else more

    def _next_step(self, buffer: bytes, at: int, trials: int) -> tuple[int, int]:
        """The first place from an offset on where a frame or text stands, or the end; and the trials that are left."""
        size = len(buffer)
        begins = {start for start, _ in self._marks}
        for found in _STARTS.finditer(buffer, at):
            place = found.start()
            first = buffer[place]
            if first in _TEXT_STARTS and self._whole_text(buffer, place):
                return place, trials
            if place + LENGTH_FIELD + (first | buffer[place + 1] << 8) > size and place not in begins:
                continue  # most places by far: said here, as it is said faster
            length, _, code = unpack_header(buffer, place)
            if not MIN_LENGTH <= length <= MAX_LENGTH or code not in _TYPES:
                continue
            if place in begins:
                return place, trials
            end = place + LENGTH_FIELD + length
            if end > size:
                continue
            trials -= 1
            if trials <= 0:
                break
            if self._schema.is_flawless(buffer, place, end):
                return place, trials
        return len(buffer), trials

    def _may_start(self, buffer: bytes, at: int) -> bool:
        """Whether a frame may start here, as far as its header is there."""
        head = buffer[at : at + HEADER_SIZE]
        if len(head) < LENGTH_FIELD or not is_frame_size(frame_size(head)):
            return False
        return len(head) < HEADER_SIZE or head[-1] in _TYPES

    def _end_of_chunk(self, at: int) -> int:
        return next((start for start, _ in self._marks if start > at), len(self._buffer))

    # Texts

    def _text(self, buffer: bytes, at: int) -> tuple[PartKind, int] | None:
        """The text that stands at an offset, or the rest of one that came before; None where a frame may stand."""
        if self._after_text is not None:
            rest = self._rest_of_text(buffer, at)
            if rest is not None:
                return rest
        if buffer[at] not in _TEXT_STARTS or self._may_start(buffer, at):
            return None
        whole = self._whole_text(buffer, at)
        if whole is not None:
            return whole
        return (PartKind.UNLOCK, len(buffer) + 1) if self._is_part_of_text(buffer[at:]) else None

    def _is_part_of_text(self, part: bytes) -> bool:
        """Whether these bytes are the start of a text, of which more is to come."""
        if ACCEPT.startswith(part) or _REQUEST.startswith(part):
            return True
        return part.startswith(_REQUEST) and len(part) < MOST_UNLOCK

    def _rest_of_text(self, buffer: bytes, at: int) -> tuple[PartKind, int] | None:
        """What comes late of the text before: line ends after an unlock text, the zero after the answer to it."""
        if self._after_text is PartKind.ACCEPT:
            return (PartKind.TEXT_END, at + 1) if self._is_zero(buffer, at) else None
        end = at + len(buffer[at:]) - len(buffer[at:].lstrip(_LINE_END))
        while end > at and self._is_frame_rather(buffer, end - 1):
            end -= 1
        if end > at and end == len(buffer):
            # The last one may be the length of a frame of which nothing more is there.
            end = end - 1 if end - 1 > at else end + 1
        return (PartKind.TEXT_END, end) if end > at else None

    def _whole_text(self, buffer: bytes, at: int) -> tuple[PartKind, int] | None:
        if buffer.startswith(ACCEPT, at):
            end = at + len(ACCEPT)
            return PartKind.ACCEPT, end + self._is_zero(buffer, end)
        if not buffer.startswith(_REQUEST, at):
            return None
        try:
            unlock, end = UNLOCK.read(buffer, at)
        except DecodeError:
            return None
        if unlock.endings and self._is_frame_rather(buffer, end - 1):
            end -= len(unlock.newline)
        return PartKind.UNLOCK, end

    def _is_zero(self, buffer: bytes, at: int) -> bool:
        """Whether the zero stands here that the firmware sends after its answer: it is no start of a length."""
        return buffer[at : at + 1] == b"\0" and not self._is_frame_rather(buffer, at)

    def _is_frame_rather(self, buffer: bytes, at: int) -> bool:
        """Whether a byte that may end a text is more likely the start of a frame, as far as that can be seen."""
        if len(buffer) - at < LENGTH_FIELD or not self._may_start(buffer, at):
            return False
        return not self._stands(buffer, at + 1)

    def _stands(self, buffer: bytes, at: int) -> bool:
        """Whether a whole frame without a fault stands at an offset."""
        if len(buffer) - at < HEADER_SIZE or not self._may_start(buffer, at):
            return False
        end = at + frame_size(buffer, at)
        return end <= len(buffer) and self._schema.is_flawless(buffer, at, end)
