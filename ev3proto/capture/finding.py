"""Finding the next frame in a stream that is out of step.

In any data, one in a few thousand offsets looks like a header. So a frame must be whole and valid, and what follows it
may be the next one; an incomplete frame must be able to become valid. The dissector does the same.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator, Sequence
from enum import Enum, auto
from itertools import islice

from ev3proto.capture.evidence import is_plausible, is_sensible
from ev3proto.messages import Message
from ev3proto.schema.frame import FrameReader
from ev3proto.schema.frame_buffer import polls_end
from ev3proto.schema.header import (
    COMMAND_HEADER_SIZE,
    HEADER_SIZE,
    TYPE_AT,
    frame_end,
    frame_size,
    may_start,
    with_length,
)
from ev3proto.semantics.identify import length_slip
from ev3proto.tables import system
from ev3proto.tables.frame import (
    COMMAND_TYPES,
    LENGTH_FIELD,
    MAX_LENGTH,
    MESSAGE_TYPES,
    MIN_LENGTH,
    SYSTEM_COMMAND_TYPES,
    MessageType,
)

Accepts = Callable[[MessageType], bool]
"""Tells which message types go in the direction of a stream."""

MOST_TRIALS = 64
"""Maximum number of offsets in a piece of a stream at which a frame is parsed."""

MOST_FOLLOWING = 2
"""Number of following headers that confirm a frame."""

_LEAST = COMMAND_HEADER_SIZE + 2
"""Minimum size of a command that is cut or inside a packet; one byte of operations, such as NOP, proves nothing."""

# Offsets at which a header may be: most others are skipped at ten times the speed.
_STARTS = re.compile(
    b"(?=(?:[%b-\\xff]\\0|.[\\1-%b])..[%b]|.[%b-\\xff]..[%b][%b])"
    % (
        re.escape(bytes((MIN_LENGTH,))),
        re.escape(bytes((MAX_LENGTH >> 8,))),
        re.escape(bytes(sorted(MESSAGE_TYPES))),
        re.escape(bytes((MAX_LENGTH >> 8,))),
        re.escape(bytes(SYSTEM_COMMAND_TYPES.values())),
        re.escape(bytes(sorted(system.LONG_COMMANDS))),
    ),
    re.DOTALL,
)
_WITH_DATA = {
    bytes((command.number,))
    for command in system.SYSTEM
    if any(each.kind is system.FieldKind.DATA for each in command.request)
}
"""The system commands with data, which may be any bytes."""

_SYSTEM = {bytes((number,)) for number, member in MESSAGE_TYPES.items() if member.carries == "system"}


class Found(Enum):
    """What was found at an offset."""

    NOTHING = auto()
    OPEN = auto()  # an incomplete frame, valid so far
    BEGUN = auto()  # a whole frame at the beginning of a packet, faulty or followed by anything
    SINGLE = auto()  # a whole frame, not confirmed by what follows it
    CHAIN = auto()  # a whole frame, and a header after it


class Finder:
    """A search for frames in the bytes of a stream.

    schema  reads frames
    """

    __slots__ = ("schema",)

    def __init__(self, schema: FrameReader) -> None:
        self.schema = schema

    def is_frame(self, buffer: bytes, at: int, end: int) -> bool:
        """Returns whether a valid frame is here that a program would send."""
        if end - at < HEADER_SIZE or buffer[at + HEADER_SIZE - 1] not in MESSAGE_TYPES:
            return False
        return is_sensible(self.schema.read_frame(buffer[at:end], strict=False))

    def is_self_evident(self, buffer: bytes, at: int) -> bool:
        """Returns whether a valid frame needs no other one after it: operations are rarely valid by chance."""
        member = MESSAGE_TYPES.get(buffer[at + HEADER_SIZE - 1])
        return member is not None and member.is_command and member.carries == "direct"

    def slip_of(self, sent: bytes, accept: Callable[[Message], bool]) -> str | None:
        """Returns the slip in the length field of a command that was sent alone in a packet; None if it has none.

        `accept` judges the command with the right length.
        """
        slip = length_slip(sent) if len(sent) > HEADER_SIZE else None
        if slip is None or sent[TYPE_AT] not in COMMAND_TYPES:
            return None
        return slip if accept(self.schema.read_frame(with_length(sent[LENGTH_FIELD:]), strict=False)) else None

    def may_become(self, buffer: bytes, at: int) -> bool:
        """Returns whether an incomplete frame may become a valid one."""
        if not may_start(buffer, at):
            return False
        size = len(buffer)
        if size - at <= HEADER_SIZE:
            return True
        member = MESSAGE_TYPES[buffer[at + HEADER_SIZE - 1]]
        if member.carries == "system":
            return buffer[at + HEADER_SIZE] in system.SYSTEM_BY_NUMBER
        if member.carries == "direct" and member.is_command and size - at > COMMAND_HEADER_SIZE:
            _, fault = self.schema.instructions.scan(buffer, at + COMMAND_HEADER_SIZE, size)
            return fault is None or fault.truncated
        return True

    def follow(self, buffer: bytes, at: int) -> int | None:
        """Returns the number of consecutive headers from here on, a few at most; None if no frame can be here."""
        size, count = len(buffer), 0
        while at < size and count < MOST_FOLLOWING:
            at = polls_end(buffer, at)
            if not may_start(buffer, at):
                return None
            if size - at < HEADER_SIZE:
                break
            count += 1
            at += frame_size(buffer, at)
        return count

    def find_command(
        self, buffer: bytes, begins: Sequence[int], accepts: Accepts, missing: int = 0, *, anywhere: bool = False
    ) -> tuple[Found, int]:
        """Searches for a command with which a claim begins.

        Args:
            buffer: Bytes of a stream that is not claimed.
            begins: Offsets at which packets begin: anything may follow a command there. Elsewhere another header must
                follow, at least its length.
            accepts: Tells which types begin a claim.
            missing: Number of bytes after these that were not captured: a command that ends with them counts as whole.
            anywhere: Frames may begin and end anywhere in packets, as after a gap.

        Returns:
            CHAIN and the offset of a plausible command; else SINGLE and the offset of frames that fill the rest of the
            bytes, whatever they contain; else OPEN and the offset of what may become a command; else NOTHING.

        """
        size = len(buffer)
        places = {*begins, *(hit.start() for hit in islice(_STARTS.finditer(buffer), MOST_TRIALS))}
        if anywhere:
            places |= {*range(max(size - HEADER_SIZE + 1, 0), size)}
        first: dict[Found, int] = {}
        for place in sorted(places):
            if place in begins or Found.SINGLE not in first:
                found = self._examine(buffer, place, begins, accepts, missing, anywhere=anywhere)
                if found is Found.CHAIN:
                    return found, place
                first.setdefault(found, place)
        found = next((each for each in (Found.SINGLE, Found.OPEN) if each in first), Found.NOTHING)
        return found, first.get(found, size)

    def _examine(
        self, buffer: bytes, at: int, begins: Sequence[int], accepts: Accepts, missing: int, *, anywhere: bool
    ) -> Found:
        size, end, is_begin = len(buffer), frame_end(buffer, at), at in begins
        if is_begin and self._has_slip(buffer, at, begins, missing):
            return Found.CHAIN
        if end is not None and not _is_possible(buffer, at, end, begins, accepts):
            return Found.NOTHING
        is_cut = missing > 0 and end == size + missing and size - at >= _LEAST
        if end is None or (end > size and not is_cut):
            return self._unfinished(buffer, at) if is_begin or anywhere else Found.NOTHING
        if is_begin or self._is_confirmed(buffer, at, end, anywhere=anywhere):
            message = self.schema.read_frame(buffer[at:end], strict=False)
            if is_plausible(message, self.schema, is_cut=is_cut):
                return Found.CHAIN
        return Found.SINGLE if is_begin and self._fills(buffer, at, accepts, missing) else Found.NOTHING

    def _has_slip(self, buffer: bytes, at: int, begins: Sequence[int], missing: int) -> bool:
        """Returns whether a packet is a plausible command but for its length field."""
        if missing:
            return False
        sent = buffer[at : min((start for start in begins if start > at), default=len(buffer))]
        return self.slip_of(sent, lambda message: is_plausible(message, self.schema)) is not None

    def _unfinished(self, buffer: bytes, at: int) -> Found:
        is_possible = not _carries_data(buffer, at) and self.may_become(buffer, at)
        return Found.OPEN if is_possible else Found.NOTHING

    def _is_confirmed(self, buffer: bytes, at: int, end: int, *, anywhere: bool) -> bool:
        """Returns whether a frame inside of a packet is long enough, and followed by what may be another."""
        is_enough = end - at >= _LEAST and (anywhere or len(buffer) - end >= LENGTH_FIELD)
        return is_enough and may_start(buffer, end) and self.follow(buffer, end) is not None

    def _fills(self, buffer: bytes, at: int, accepts: Accepts, missing: int) -> bool:
        frames = self.frames_of(buffer, at, missing)
        size = sum(map(frame_size, frames))
        return size == len(buffer) + missing - at and all(
            accepts(MESSAGE_TYPES[each[HEADER_SIZE - 1]]) for each in frames
        )

    def frames_of(self, buffer: bytes, at: int = 0, missing: int = 0) -> list[bytes]:
        """Returns the whole frames that follow each other from an offset on; the last one may be cut by the capture."""
        size, found = len(buffer), []
        while (end := frame_end(buffer, at)) is not None and (end <= size or end == size + missing):
            found.append(buffer[at:end])
            at = end
        return found

    def next_step(
        self, buffer: bytes, at: int, begins: Collection[int], accepts: Accepts, least: int = 0
    ) -> tuple[Found, int]:
        """Searches for the offset at which the stream continues.

        Args:
            buffer: Bytes of the stream.
            at: The first possible offset.
            begins: Offsets at which packets begin: there a frame may be faulty, or followed by anything.
            accepts: Tells which types go this way.
            least: Number of headers that must follow a whole frame.

        Returns:
            What was found, and its offset; the end of the bytes for `NOTHING`.

        """
        size = len(buffer)
        first = {Found.NOTHING: size}
        for place, end in islice(_frames_from(buffer, at, accepts), MOST_TRIALS - 1):
            if end > size:
                if Found.OPEN not in first and self.may_become(buffer, place):
                    first[Found.OPEN] = place
                continue
            following = self.follow(buffer, end)
            if (following or 0) >= least:
                first.setdefault(self._judged(buffer, place, end, following, is_begin=place in begins), place)
            if Found.CHAIN in first:
                return Found.CHAIN, place
        best = next(each for each in (Found.SINGLE, Found.BEGUN, Found.OPEN, Found.NOTHING) if each in first)
        return Found.SINGLE if best is Found.BEGUN else best, first[best]

    def _judged(self, buffer: bytes, at: int, end: int, following: int | None, *, is_begin: bool) -> Found:
        """Returns what a whole frame is, by the number of headers after it."""
        if following is None and not is_begin:
            return Found.NOTHING
        is_frame = self.is_frame(buffer, at, end)
        if is_frame and following is not None:
            return Found.CHAIN if following else Found.SINGLE
        return Found.BEGUN if is_begin and (is_frame or following is not None) else Found.NOTHING


def _frames_from(buffer: bytes, at: int, accepts: Accepts) -> Iterator[tuple[int, int]]:
    """Yields where frames may start from an offset on, and where they would end."""
    for hit in _STARTS.finditer(buffer, at):
        end = frame_end(buffer, hit.start())
        if end is not None and accepts(MESSAGE_TYPES[buffer[hit.start() + HEADER_SIZE - 1]]):
            yield hit.start(), end


def _is_possible(buffer: bytes, at: int, end: int, begins: Sequence[int], accepts: Accepts) -> bool:
    """Returns whether a frame has an accepted type, and no packet begins within its data, which may be other frames."""
    if not accepts(MESSAGE_TYPES[buffer[at + HEADER_SIZE - 1]]):
        return False
    return not (_carries_data(buffer, at) and any(at < start < end for start in begins))


def _carries_data(buffer: bytes, at: int) -> bool:
    """Returns whether the header at an offset is of a system command with data, which may be any bytes."""
    code, number = buffer[at + HEADER_SIZE - 1 : at + HEADER_SIZE], buffer[at + HEADER_SIZE : at + HEADER_SIZE + 1]
    return code in _SYSTEM and number in _WITH_DATA
