"""Framing: cuts one direction of a byte stream into frames, the texts around them, and the bytes between these.

Nothing in a stream marks the start of a frame: each starts where the last one ended. If that chain breaks (the capture
begins in the middle, bytes were not captured, a length is impossible), the stream is out of step: the next whole valid
frame has to be found.

`FrameBuffer` keeps the bytes and says where a frame ends (`look`). Its `next` has nothing to judge by but a header; a
capture has more: the packets (a gap can only be between two of them), the texts before the first frame, and the bytes
after a frame, which confirm it. So `Cutter` decides which bytes are a frame.
"""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum, auto
from typing import NamedTuple

from ev3proto.capture.evidence import is_sensible
from ev3proto.capture.finding import MOST_FOLLOWING, Accepts, Finder, Found
from ev3proto.errors import DecodeError, counted
from ev3proto.schema.discovery import Unlock
from ev3proto.schema.frame import FrameReader
from ev3proto.schema.frame_buffer import FrameBuffer, OutOfStep, polls_end
from ev3proto.schema.header import (
    COMMAND_HEADER_SIZE,
    HEADER_SIZE,
    frame_end,
    frame_size,
    impossible_length,
    may_have_length,
    may_start,
)
from ev3proto.semantics.advice import LEFT_OVER, SENT_WITH, advice
from ev3proto.semantics.identify import foreign, identify
from ev3proto.tables.discovery import ACCEPT, MOST_UNLOCK, UNLOCK_REQUEST
from ev3proto.tables.frame import LENGTH_FIELD, MAX_FRAME, MESSAGE_TYPES

MARK_SIZE = 200
"""Approximate memory of a packet with pending bytes, besides these, in bytes."""

_REQUEST = UNLOCK_REQUEST.encode()
_TEXT_STARTS = {ACCEPT[0], _REQUEST[0]}
_LINE_END = b"\r\n"
_BEGUN_INSIDE, _BETWEEN = "the capture begins inside a frame", "bytes between frames"


def _believe(data: bytearray, at: int) -> str | None:
    return None if may_have_length(data, at) else impossible_length(frame_size(data, at) - LENGTH_FIELD)


class PartKind(Enum):
    """The kind of a piece of a stream."""

    FRAME = auto()
    UNLOCK = auto()
    ACCEPT = auto()
    TEXT_END = auto()
    POLL = auto()
    LOST = auto()


_TEXTS = (PartKind.UNLOCK, PartKind.ACCEPT)


class StreamPart(NamedTuple):
    """A piece of a stream."""

    # TEXT_END is the rest of the text before; POLL are length fields of 0 between frames, which the brick skips
    kind: PartKind
    data: bytes
    numbers: tuple[int, ...]  # the packets that carried them
    reason: str = ""  # for LOST: why it cannot be read; for FRAME: what is wrong with its length


class Cutter:
    """Cuts one direction of a stream. It keeps at most one unfinished frame or text besides its last input.

    schema      reads frames, to judge whether one starts at an offset
    in_step     a frame starts with the first byte; by default the first one is searched for
    may_gap     there may be unnoticed gaps between packets
    accepts     tells which message types go this way, for searching
    """

    __slots__ = (
        "_after_text",
        "_buffer",
        "_finder",
        "_in_step",
        "_marks",
        "_may_gap",
        "_next_try",
        "_passed",
        "_reason",
        "_rest",
        "_trials",
        "accepts",
    )

    def __init__(self, schema: FrameReader, *, in_step: bool, may_gap: bool = False) -> None:
        self._finder = Finder(schema)
        self._buffer = FrameBuffer(judge=_believe)
        self._marks: list[tuple[int, int]] = []  # the offset in the buffer and the number of each packet
        self._in_step = in_step
        self._trials = 0  # number of frames to judge before the stream counts as in step again
        self._next_try = 0  # size of the buffer at which the next frame is searched for again
        self._passed = 0  # pending bytes that are in no frame, to be reported together with others
        self._may_gap = may_gap
        self.accepts: Accepts = lambda _: True
        self._rest = 0  # remaining bytes of a frame with a gap; after them the stream is in step
        self._after_text: PartKind | None = None
        self._reason = "" if in_step else _BEGUN_INSIDE

    def feed(self, data: bytes, number: int) -> list[StreamPart]:
        """Takes the next bytes of the stream, from one packet. Returns the pieces that they complete."""
        self._marks.append((len(self._buffer), number))
        self._buffer.append(data)
        return self._cut()

    def takes_whole(self, data: bytes) -> bool:
        """Takes the next bytes of the stream if they are exactly one frame. Returns whether they are."""
        size = len(data)
        if len(self._buffer) or not self._in_step or size < HEADER_SIZE or size > MAX_FRAME:
            return False
        if frame_size(data) != size:
            return False
        self._after_text = None
        return True

    def answered(self) -> list[StreamPart]:
        """Returns a pending command with a wrong length: the other side sends, so nothing more belongs to it."""
        if len(self._marks) != 1 or self._slip_at(self._buffer.pending, 0, is_last=True) is None:
            return []
        return self._cut(is_last=True)

    @property
    def passed(self) -> int:
        """The number of pending bytes that are in no frame."""
        return self._passed

    @property
    def left(self) -> bytes:
        """The pending bytes."""
        return self._buffer.pending

    @property
    def waiting(self) -> list[int]:
        """The numbers of the packets with pending bytes."""
        return [number for _, number in self._marks]

    @property
    def size(self) -> int:
        """The approximate memory of the pending bytes."""
        return len(self._buffer) + MARK_SIZE * len(self._marks)

    def begin(self, *, in_step: bool) -> None:
        """Starts again with the next bytes, if none are pending: in step, or searching for a frame."""
        self._in_step, self._trials, self._next_try, self._rest = in_step, 0, 0, 0
        self._reason = "" if in_step else _BEGUN_INSIDE

    def begins_with_text(self, data: bytes) -> bool | None:
        """Returns whether data begin with a text; None if more bytes are needed to tell."""
        text = None if data[0] not in _TEXT_STARTS or may_start(data, 0) else self._text_at(data, 0)
        if text is None:
            return False
        return True if text[1] <= len(data) else None

    def give_up(self, reason: str) -> list[StreamPart]:
        """Gives up the pending bytes, and searches for the next frame."""
        waiting = self._give_up()
        rest = None if self._is_in_text() else self._rest_after(0)
        waiting += self._take_all(reason)
        self._in_step, self._rest = False, rest or 0
        self._after_text, self._reason = None, _BETWEEN
        return waiting

    def cut_off(self, missing: int) -> list[StreamPart]:
        """Ends the newest packet, of which bytes were not captured. Returns the pending bytes as a cut frame."""
        if not self._is_sure_of_frame():
            return self.leave_hole(missing)
        rest = self._rest_after(missing)
        frame = self._piece(PartKind.FRAME, 0, len(self._buffer))
        self._drop()
        self._in_step, self._rest = rest == 0, rest or 0
        self._reason = f"bytes of a frame of which {counted(missing, 'byte')} were not captured"
        return [frame]

    def _is_sure_of_frame(self) -> bool:
        """Returns whether the pending bytes are a frame, with its header; after a gap, if a packet begins with it."""
        buffer = self._buffer.pending
        if self._rest or len(buffer) < HEADER_SIZE or self._is_in_text():
            return False
        if self._is_sure():
            return True
        is_packet = len(self._marks) == 1 or (self._in_step and not self._trials)
        return is_packet and self._finder.may_become(buffer, 0) and self.accepts(MESSAGE_TYPES[buffer[HEADER_SIZE - 1]])

    def leave_hole(self, missing: int) -> list[StreamPart]:
        """Leaves a gap of missing bytes, 0 if their number is unknown. Gives up the pending bytes."""
        what = "text" if self._is_in_text() else "frame"
        waiting = self._give_up()
        rest = self._rest_after(missing) if missing and what == "frame" else None
        waiting += self._take_all(f"the rest of the {what} is not in the capture")
        self._in_step, self._rest = rest == 0, rest or 0
        self._after_text = None
        self._reason = (
            f"bytes of a frame whose start is missing with {counted(missing, 'byte')}" if missing else _BEGUN_INSIDE
        )
        return waiting

    def _rest_after(self, missing: int) -> int | None:
        """Returns the number of bytes of the pending frame after a gap; None if unknown."""
        if self._rest:
            rest = self._rest - len(self._buffer) - missing
        elif self._in_step and not self._trials and self._buffer.size is not None:
            rest = self._buffer.size - len(self._buffer) - missing
        else:
            return None
        return rest if rest >= 0 else None

    def end(self) -> list[StreamPart]:
        """Ends the stream. Returns the pending bytes."""
        found = self._give_up()
        buffer = self._buffer
        is_text = self._is_in_text()
        reason = (
            f"the stream ends inside a {'text' if is_text else 'frame'}, of which {counted(len(buffer), 'byte')} came"
        )
        if self._in_step and buffer.size is not None and not is_text:
            reason += f" and {buffer.size - len(buffer)} are missing"
        # A frame that was cut is likelier than one without its header.
        said = None if is_text else advice(identify(buffer.pending, missing=False, reader=self._finder.schema))
        return found + self._take_all(said or reason)

    def _give_up(self) -> list[StreamPart]:
        """Returns the pieces of the pending bytes, if no more will come."""
        is_slip = self._slip_at(self._buffer.pending, 0, is_last=True) is not None
        return self._cut(is_last=True) if is_slip or not self._is_sure() else []

    def _is_sure(self) -> bool:
        """Returns whether the pending bytes certainly begin where the last frame ended."""
        return self._in_step and not self._trials and not self._may_gap

    def _is_in_text(self) -> bool:
        return len(self._buffer) >= LENGTH_FIELD and self._is_part_of_text(self._buffer.pending)

    def _take_all(self, reason: str) -> list[StreamPart]:
        if not len(self._buffer):
            return []
        kind = PartKind.LOST
        if self._after_text is PartKind.UNLOCK and not self._buffer.pending.strip(_LINE_END):
            kind = PartKind.TEXT_END
        piece = self._piece(kind, 0, len(self._buffer), self._reason or reason)
        self._drop()
        self._passed = 0
        if kind is PartKind.LOST:
            # If more bytes come, they do not start with a frame.
            self._in_step, self._reason = False, _BETWEEN
        return [piece]

    def _cut(self, *, is_last: bool = False) -> list[StreamPart]:
        buffer, found = self._buffer.pending, list[StreamPart]()
        at = self._take_rest(found) if self._rest and buffer else 0
        if len(buffer) >= self._next_try or is_last or self._ends_with_frame():
            self._next_try = 0
            at = self._take_parts(buffer, at, found, is_last=is_last)
        if at:
            self._marks = [(max(start - at, 0), number) for start, number, stop in self._spans() if stop > at]
            self._buffer.skip(at)
        return found

    def _take_rest(self, found: list[StreamPart]) -> int:
        at = min(self._rest, len(self._buffer))
        found.append(self._piece(PartKind.LOST, 0, at, self._reason))
        self._rest -= at
        self._in_step = not self._rest
        return at

    def _take_parts(self, buffer: bytes, at: int, found: list[StreamPart], *, is_last: bool) -> int:
        while at < len(buffer):
            if (slip := self._slip_at(buffer, at, is_last=is_last)) is not None:
                at = self._take_slip(*slip, at, found)
                continue
            kind, end = self._next(buffer, at, is_last)
            if kind is PartKind.LOST:
                at, waits = self._take_lost(buffer, at, found, is_last=is_last)
                if waits:
                    break
            elif end > len(buffer):
                break
            else:
                found.append(self._piece(kind, at, end))
                self._learn(kind)
                at = end
        return at

    def _take_slip(self, end: int, said: str, at: int, found: list[StreamPart]) -> int:
        """Adds a frame with a wrong length, and the rest of the packet. Returns the offset after them."""
        found.append(self._piece(PartKind.FRAME, at, end, said))
        self._learn(PartKind.FRAME)
        stop = next(stop for _, _, stop in self._spans() if stop >= end)
        if end < stop:
            left = LEFT_OVER.format(bytes=counted(stop - end, "byte"))
            found.append(self._piece(PartKind.LOST, end, stop, left))
        return stop

    def _slip_at(self, buffer: bytes, at: int, *, is_last: bool) -> tuple[int, str] | None:
        """Returns the end of a frame with a wrong length, and what is wrong with it; None for any other.

        A packet begins with it, the length field says nearly the size of that packet, and only with the right length
        the frame makes sense. Its end is the one that the brick sees, as far as bytes are there; it is that of its
        packet if no gap could be after it.
        """
        sent = next((stop for start, _, stop in self._spans() if start == at), at) if self._in_step else at
        slip = self._finder.slip_of(buffer[at:sent], is_sensible)
        if slip is None:
            return None
        end, is_possible = at + frame_size(buffer, at), may_have_length(buffer, at)
        is_right = self._finder.is_frame(buffer, at, end) if end <= len(buffer) else not is_last
        # An empty command has no fault.
        if end == at + COMMAND_HEADER_SIZE or (is_possible and is_right):
            return None
        said = SENT_WITH[slip].format(
            length=end - at - LENGTH_FIELD, follow=sent - at - LENGTH_FIELD, more=LENGTH_FIELD
        )
        return min(end, len(buffer) if is_possible and self._may_gap else sent), said

    def _take_lost(self, buffer: bytes, at: int, found: list[StreamPart], *, is_last: bool) -> tuple[int, bool]:
        """Adds the bytes to the next frame. Returns the offset after them, and whether more bytes are needed."""
        first, least = at, 1
        if self._in_step:
            # If there can be no gap, this is the sender's fault: the packet is complete.
            first, least = at + 1, 1 if self._may_gap else LENGTH_FIELD if at else HEADER_SIZE
        reason = self._lost(at)
        end, waits = self._look_on(buffer, first, -1 if is_last else len(buffer) - least)
        if end > at:
            found.append(self._piece(PartKind.LOST, at, end, reason))
            self._after_text = None
        return end, waits

    def _learn(self, kind: PartKind) -> None:
        """Learns from a piece whether the stream is in step, and after which text it is."""
        if kind is PartKind.FRAME or kind in _TEXTS:
            self._in_step, self._reason = True, ""
            self._trials = max(self._trials - 1, 0) if kind is PartKind.FRAME else 0
        if kind is not PartKind.TEXT_END:
            self._after_text = kind if kind in _TEXTS else None

    def _drop(self) -> None:
        self._buffer.skip(len(self._buffer))
        self._marks = []

    def _spans(self) -> Iterator[tuple[int, int, int]]:
        """Yields the bytes of each packet in the buffer: start, number, end."""
        for index, (start, number) in enumerate(self._marks):
            last = index + 1 == len(self._marks)
            yield start, number, len(self._buffer) if last else self._marks[index + 1][0]

    def _ends_with_frame(self) -> bool:
        """Returns whether the newest packet is exactly one valid frame: the stream continues there."""
        buffer, start = self._buffer.pending, self._marks[-1][0]
        end = frame_end(buffer, start)
        return end == len(buffer) and self._finder.is_frame(buffer, start, end)

    def _piece(self, kind: PartKind, at: int, end: int, reason: str = "") -> StreamPart:
        numbers = tuple(dict.fromkeys(number for start, number, stop in self._spans() if start < end and stop > at))
        return StreamPart(kind, self._buffer[at:end], numbers, reason)

    def _lost(self, at: int) -> str:
        if not self._in_step:
            return self._reason
        self._in_step = False
        self._reason = _BETWEEN
        front = self._buffer.look(at)
        if not isinstance(front, OutOfStep):
            return _BETWEEN
        return advice(foreign(self._buffer[at:MAX_FRAME], self._finder.schema)) or front.reason

    def _next(self, buffer: bytes, at: int, is_last: bool) -> tuple[PartKind, int]:
        """Returns the piece at an offset, and its end, which is after the buffer's end if more bytes are needed."""
        more = len(buffer) + 1
        text = self._text(buffer, at)
        if text is not None:
            return text
        if not self._in_step:
            return PartKind.LOST, more
        if (end := polls_end(buffer, at)) > at:
            return PartKind.POLL, end
        front = self._buffer.look(at)
        if front is None:
            return PartKind.FRAME, more
        if isinstance(front, OutOfStep):
            return PartKind.LOST, more
        if self._is_doubtful(buffer, at, front):
            return self._judge(buffer, at, front, is_last)
        return PartKind.FRAME, front

    def _is_doubtful(self, buffer: bytes, at: int, end: int) -> bool:
        """Returns whether there may be a gap before or in an apparent frame."""
        may_gap = self._may_gap and any(at <= start < end for start, _ in self._marks)
        return (may_gap or self._trials > 0) and len(buffer) - at >= HEADER_SIZE

    def _judge(self, buffer: bytes, at: int, end: int, is_last: bool) -> tuple[PartKind, int]:
        """Returns the piece at the offset of an apparent frame, if there may be a gap before or in it."""
        finder = self._finder
        if end > len(buffer):
            return (PartKind.LOST if self._misleads(buffer, at, is_last) else PartKind.FRAME), end
        follows, is_frame = finder.follow(buffer, end), finder.is_frame(buffer, at, end)
        # A valid frame that ends with its packet is complete, whatever its data look like.
        if is_frame and (follows or end == len(buffer) or finder.is_self_evident(buffer, at)):
            return PartKind.FRAME, end
        if follows is None:
            return PartKind.LOST, end
        return self._judge_by_next(buffer, at, end, follows, is_frame=is_frame, is_last=is_last)

    def _judge_by_next(
        self, buffer: bytes, at: int, end: int, follows: int, *, is_frame: bool, is_last: bool
    ) -> tuple[PartKind, int]:
        """Returns the piece at the offset of an apparent frame, by the frame that may start inside of it."""
        inside = self._after_gap(at, end, is_frame)
        found, place = self._finder.next_step(buffer, inside, self._begins(), self.accepts)
        if place < end and found in (Found.SINGLE, Found.CHAIN):
            return PartKind.LOST, end
        # A header after a valid frame confirms it, two do after another.
        is_open = place < end and found is Found.OPEN and follows <= (not is_frame)
        waits = is_open or (not follows and not is_frame and self._is_split(at, end))
        return PartKind.FRAME, len(buffer) + 1 if waits and not is_last else end

    def _after_gap(self, at: int, end: int, is_frame: bool) -> int:
        """Returns the first offset after a gap in an apparent frame: it is between two packets."""
        if self._trials or not is_frame:
            return at + 1
        return next((start for start, _ in self._marks if start > at), end)

    def _is_split(self, at: int, end: int) -> bool:
        return any(at < start < end for start, _ in self._marks)

    def _misleads(self, buffer: bytes, at: int, is_last: bool) -> bool:
        if not is_last and self._finder.may_become(buffer, at):
            return self._finder.next_step(buffer, at + 1, (), self.accepts, MOST_FOLLOWING)[0] is Found.CHAIN
        found, _ = self._finder.next_step(buffer, at + 1, self._begins(), self.accepts)
        return found in (Found.SINGLE, Found.CHAIN) or (self._trials > 0 and not is_last)

    def _look_on(self, buffer: bytes, at: int, latest: int) -> tuple[int, bool]:
        """Returns where a stream continues if its next header begins by `latest`, and whether more bytes are needed."""
        found, place = self._finder.next_step(buffer, max(at, self._passed), self._begins(), self.accepts)
        if found is Found.OPEN and latest < 0:
            found, place = Found.NOTHING, len(buffer)
        for start in (ACCEPT, _REQUEST):
            hit = buffer.find(start, at, place)
            if hit >= 0 and self._whole_text(buffer, hit):
                found, place = Found.CHAIN, hit
        if found is Found.NOTHING:
            places = range(max(at, len(buffer) - HEADER_SIZE + 1), latest + 1)
            place = next((place for place in places if may_start(buffer, place)), len(buffer))
            if at < place < len(buffer) and not self._passed:
                self._passed, place = place - at, at
                return place, True
        self._passed = 0
        if found in (Found.NOTHING, Found.OPEN):
            # A frame that arrives byte by byte is not judged again at each byte.
            self._next_try = (len(buffer) - place) * 5 // 4 + 1
            return place, True
        self._in_step = True
        self._trials = 1 if found is Found.CHAIN or self._finder.is_self_evident(buffer, place) else 2
        return place, False

    def _begins(self) -> set[int]:
        return {start for start, _ in self._marks}

    # Texts

    def _text(self, buffer: bytes, at: int) -> tuple[PartKind, int] | None:
        """Returns the text at an offset, or the rest of the last one; None if a frame may be there."""
        if self._after_text is not None:
            rest = self._rest_of_text(buffer, at)
            if rest is not None:
                return rest
        if buffer[at] not in _TEXT_STARTS or may_start(buffer, at):
            return None
        return self._text_at(buffer, at)

    def _text_at(self, buffer: bytes, at: int) -> tuple[PartKind, int] | None:
        whole = self._whole_text(buffer, at)
        if whole is not None:
            return whole
        return (PartKind.UNLOCK, len(buffer) + 1) if self._is_part_of_text(buffer[at:]) else None

    def _is_part_of_text(self, part: bytes) -> bool:
        if ACCEPT.startswith(part) or _REQUEST.startswith(part):
            return True
        return part.startswith(_REQUEST) and len(part) < MOST_UNLOCK

    def _rest_of_text(self, buffer: bytes, at: int) -> tuple[PartKind, int] | None:
        """Returns the late end of the last text: line ends after an unlock text, the zero after its answer."""
        if self._after_text is PartKind.ACCEPT:
            return (PartKind.TEXT_END, at + 1) if self._is_zero(buffer, at) else None
        end = at + len(buffer[at:]) - len(buffer[at:].lstrip(_LINE_END))
        while end > at and self._is_frame_rather(buffer, end - 1):
            end -= 1
        if end > at and end == len(buffer):
            # The last byte may be the start of a frame's length.
            end = end - 1 if end - 1 > at else end + 1
        return (PartKind.TEXT_END, end) if end > at else None

    def _whole_text(self, buffer: bytes, at: int) -> tuple[PartKind, int] | None:
        if buffer.startswith(ACCEPT, at):
            end = at + len(ACCEPT)
            return PartKind.ACCEPT, end + self._is_zero(buffer, end)
        if not buffer.startswith(_REQUEST, at):
            return None

        try:
            unlock, end = Unlock.read(buffer, at)
        except DecodeError:
            return None
        if unlock.endings and self._is_frame_rather(buffer, end - 1):
            end -= len(unlock.newline)
        return PartKind.UNLOCK, end

    def _is_zero(self, buffer: bytes, at: int) -> bool:
        """Returns whether this is the zero that the firmware sends after its answer, not the start of a frame."""
        return buffer[at : at + 1] == b"\0" and not self._is_frame_rather(buffer, at)

    def _is_frame_rather(self, buffer: bytes, at: int) -> bool:
        """Returns whether a byte that may end a text is more likely the start of a frame."""
        if len(buffer) - at < LENGTH_FIELD or not may_start(buffer, at):
            return False
        return not self._is_whole_frame(buffer, at + 1)

    def _is_whole_frame(self, buffer: bytes, at: int) -> bool:
        end = frame_end(buffer, at)
        return end is not None and end <= len(buffer) and self._finder.is_frame(buffer, at, end)
