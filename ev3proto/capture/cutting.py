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

from ev3proto.errors import DecodeError
from ev3proto.schema.discovery import UNLOCK
from ev3proto.schema.frame import HEADER_SIZE, FrameSchema
from ev3proto.tables.discovery import ACCEPT, MOST_UNLOCK, UNLOCK_REQUEST
from ev3proto.tables.frame import LENGTH_FIELD, MAX_LENGTH, MIN_LENGTH, MessageType

MOST_TRIALS = 256
"""Places in one piece of a stream where a whole frame is tried, before the piece is given up."""

_TYPES = frozenset(map(int, MessageType))
_REQUEST = UNLOCK_REQUEST.encode()
_TEXT_STARTS = {ACCEPT[0], _REQUEST[0]}
_LINE_ENDS = re.compile(rb"[\r\n]*")


class Kind(Enum):
    """What a piece of a stream is."""

    FRAME = auto()
    UNLOCK = auto()
    ACCEPT = auto()
    TEXT_END = auto()
    LOST = auto()
    OTHER = auto()


class Piece(NamedTuple):
    """A piece of a stream.

    kind     what it is; TEXT_END is the rest of a text that came before, OTHER is none of ours
    data     the bytes
    numbers  the packets they came in
    reason   for LOST: why nobody can read it
    """

    kind: Kind
    data: bytes
    numbers: tuple[int, ...]
    reason: str = ""


class Cutter:
    """Cuts one direction of a stream. It keeps at most one unfinished frame or text beside what it was last given.

    schema      reads frames, to tell whether one stands somewhere
    in_step     a frame starts with the first byte; else the first one is looked for
    is_claimed  the stream is known to be ours; else it is once something like a frame starts with a chunk
    """

    __slots__ = ("_after_text", "_buffer", "_in_step", "_is_claimed", "_marks", "_reason", "_schema")

    def __init__(self, schema: FrameSchema, *, in_step: bool, is_claimed: bool = True) -> None:
        self._schema = schema
        self._buffer = b""
        self._marks: list[tuple[int, int]] = []  # where in the buffer each packet's bytes start
        self._in_step = in_step
        self._is_claimed = is_claimed
        self._after_text: Kind | None = None
        self._reason = "" if in_step else "the capture begins inside a frame"

    def feed(self, data: bytes, number: int) -> list[Piece]:
        """The pieces that are complete with the next bytes of the stream, which came in that packet."""
        if not self._buffer and self._in_step and len(data) >= HEADER_SIZE:
            length = data[0] | data[1] << 8
            if length + LENGTH_FIELD == len(data) and length <= MAX_LENGTH:
                self._after_text = None
                return [Piece(Kind.FRAME, data, (number,))]
        self._marks.append((len(self._buffer), number))
        self._buffer += data
        return self._cut()

    def leave_hole(self, missing: int) -> list[Piece]:
        """Says that bytes are missing in the stream here: what waits for its rest will not get it."""
        waiting = self._take_all(f"the rest of the frame is not in the capture, {_bytes(missing)} are missing")
        self._in_step = False
        self._reason = f"bytes of a frame whose start is missing with {_bytes(missing)}"
        return waiting

    def end(self) -> list[Piece]:
        """Says that nothing more will come."""
        buffer = self._buffer
        reason = f"the stream ends inside a frame, of which {_bytes(len(buffer))} came"
        if self._in_step and self._is_claimed and len(buffer) >= LENGTH_FIELD:
            reason += f" and {(buffer[0] | buffer[1] << 8) + LENGTH_FIELD - len(buffer)} are missing"
        return self._take_all(reason)

    def _take_all(self, reason: str) -> list[Piece]:
        if not self._buffer:
            return []
        kind = Kind.LOST if self._is_claimed else Kind.OTHER
        piece = self._piece(kind, 0, len(self._buffer), self._reason or reason)
        self._buffer, self._marks = b"", []
        return [piece]

    def _cut(self) -> list[Piece]:
        buffer, at = self._buffer, 0
        found: list[Piece] = []
        trials = MOST_TRIALS
        while at < len(buffer):
            kind, end = self._next(buffer, at)
            if kind is Kind.LOST:
                end, trials = self._next_step(buffer, at + 1, trials)
            if end > len(buffer):
                break
            reason = self._lost(buffer, at) if kind is Kind.LOST else ""
            found.append(self._piece(kind, at, end, reason))
            if kind is Kind.FRAME:
                self._in_step, self._reason = True, ""
            elif kind in (Kind.UNLOCK, Kind.ACCEPT):
                self._in_step, self._reason, self._after_text = True, "", kind
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

    def _piece(self, kind: Kind, at: int, end: int, reason: str = "") -> Piece:
        numbers = tuple(dict.fromkeys(number for start, number, stop in self._spans() if start < end and stop > at))
        return Piece(kind, self._buffer[at:end], numbers, reason)

    def _lost(self, buffer: bytes, at: int) -> str:
        if self._in_step:
            length = int.from_bytes(buffer[at : at + LENGTH_FIELD], "little")
            self._in_step = False
            self._reason = "bytes between frames"
            return (
                f"no frame can start here: its length field would say {length}, a frame has {MIN_LENGTH} to"
                f" {MAX_LENGTH} bytes behind it"
            )
        return self._reason

    def _next(self, buffer: bytes, at: int) -> tuple[Kind, int]:
        """What stands at an offset and where it ends, which is behind the buffer's end where more is needed."""
        more = len(buffer) + 1
        text = self._text(buffer, at)
        if text is not None:
            return text
        if len(buffer) - at < LENGTH_FIELD:
            return Kind.FRAME, more
        length = buffer[at] | buffer[at + 1] << 8
        end = at + LENGTH_FIELD + length
        if self._in_step:
            if not MIN_LENGTH <= length <= MAX_LENGTH:
                return Kind.LOST, more
            return Kind.FRAME, end
        if not self._may_start(buffer, at):
            return (Kind.LOST, more) if self._is_claimed else (Kind.OTHER, self._end_of_chunk(at))
        if not self._is_claimed:
            if len(buffer) - at < HEADER_SIZE:
                return Kind.FRAME, more
            self._is_claimed = self._in_step = True
            return Kind.FRAME, end
        is_chunk = any(start == at for start, _ in self._marks)
        if end > len(buffer):
            return (Kind.FRAME, more) if is_chunk else (Kind.LOST, more)
        return (Kind.FRAME, end) if is_chunk or self._is_flawless(buffer[at:end]) else (Kind.LOST, more)

    def _next_step(self, buffer: bytes, at: int, trials: int) -> tuple[int, int]:
        """The first place from an offset on where a frame or text stands, or the end; and the trials that are left."""
        for place in range(at, len(buffer) - HEADER_SIZE + 1):
            if buffer[place] in _TEXT_STARTS and self._whole_text(buffer, place):
                return place, trials
            if not self._may_start(buffer, place):
                continue
            end = place + LENGTH_FIELD + (buffer[place] | buffer[place + 1] << 8)
            if any(start == place for start, _ in self._marks):
                return place, trials
            if end > len(buffer):
                continue
            trials -= 1
            if trials <= 0:
                break
            if self._is_flawless(buffer[place:end]):
                return place, trials
        return len(buffer), trials

    def _may_start(self, buffer: bytes, at: int) -> bool:
        """Whether a frame may start here, as far as its header is there."""
        head = buffer[at : at + HEADER_SIZE]
        if not MIN_LENGTH <= int.from_bytes(head[:LENGTH_FIELD], "little") <= MAX_LENGTH:
            return False
        return len(head) < HEADER_SIZE or head[-1] in _TYPES

    def _end_of_chunk(self, at: int) -> int:
        return next((start for start, _ in self._marks if start > at), len(self._buffer))

    def _is_flawless(self, frame: bytes) -> bool:
        try:
            self._schema.read_frame(frame)
        except DecodeError:
            return False
        return True

    # Texts

    def _text(self, buffer: bytes, at: int) -> tuple[Kind, int] | None:
        """The text that stands at an offset, or the rest of one that came before."""
        behind, self._after_text = self._after_text, None
        if behind is Kind.UNLOCK:
            end = _LINE_ENDS.match(buffer, at).end()  # type: ignore[union-attr]
            if end > at:
                self._after_text = behind
                return Kind.TEXT_END, end
        if behind is Kind.ACCEPT and self._is_zero(buffer, at):
            return Kind.TEXT_END, at + 1
        if buffer[at] not in _TEXT_STARTS or self._may_start(buffer, at):
            return None
        whole = self._whole_text(buffer, at)
        if whole is not None:
            return whole
        part = buffer[at:]
        if ACCEPT.startswith(part) or _REQUEST.startswith(part):
            return Kind.UNLOCK, len(buffer) + 1
        if part.startswith(_REQUEST) and len(part) < MOST_UNLOCK:
            return Kind.UNLOCK, len(buffer) + 1
        return None

    def _whole_text(self, buffer: bytes, at: int) -> tuple[Kind, int] | None:
        if buffer.startswith(ACCEPT, at):
            end = at + len(ACCEPT)
            return Kind.ACCEPT, end + self._is_zero(buffer, end)
        if not buffer.startswith(_REQUEST, at):
            return None
        try:
            _, end = UNLOCK.read(buffer, at)
        except DecodeError:
            return None
        return Kind.UNLOCK, end

    def _is_zero(self, buffer: bytes, at: int) -> bool:
        """Whether the zero stands here that the firmware sends behind its answer: it is no start of a length."""
        return buffer[at : at + 1] == b"\0" and not self._may_start(buffer, at)


def _bytes(count: int) -> str:
    return f"{count} byte{'s' * (count != 1)}"
