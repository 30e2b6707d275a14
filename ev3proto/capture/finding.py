"""Finding the next frame in a stream that is out of step.

Five bytes look like a header once in some thousand offsets of any data. So a whole valid frame must be there, and what
follows it may be the next one. An incomplete frame must be able to become valid. The dissector finds frames in the same
way.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection
from enum import Enum, auto
from itertools import islice

from ev3proto.capture.claims import is_plausible, is_sensible
from ev3proto.schema.frame import FrameReader
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, frame_size, may_have_length
from ev3proto.tables import system
from ev3proto.tables.frame import LENGTH_FIELD, MAX_LENGTH, MIN_LENGTH, SYSTEM_COMMAND_TYPES, MessageType

Accepts = Callable[[MessageType], bool]
"""Tells which message types go the way of a stream."""

MOST_TRIALS = 64
"""Maximum number of offsets in a piece of a stream at which a frame is tried."""

MOST_FOLLOWING = 2
"""Number of following headers that confirm a frame."""

_LEAST_CUT = COMMAND_HEADER_SIZE + 2
"""Minimum number of captured bytes of a cut command."""

_TYPES = {int(member): member for member in MessageType}
# Offsets at which a header may be: most others are skipped at ten times the speed.
_STARTS = re.compile(
    b"(?=(?:[%b-\\xff]\\0|.[\\1-%b])..[%b]|.[%b-\\xff]..[%b][%b])"
    % (
        re.escape(bytes((MIN_LENGTH,))),
        re.escape(bytes((MAX_LENGTH >> 8,))),
        re.escape(bytes(sorted(_TYPES))),
        re.escape(bytes((MAX_LENGTH >> 8,))),
        re.escape(bytes(SYSTEM_COMMAND_TYPES.values())),
        re.escape(bytes(sorted(system.LONG_COMMANDS))),
    ),
    re.DOTALL,
)
_WITH_DATA = {
    bytes((command.number,))
    for command in system.SYSTEM
    if any(each.kind is system.Kind.DATA for each in command.request)
}
"""The system commands with data, which may be any bytes."""


_POLLS = re.compile(b"(?:%b)*" % re.escape(bytes(LENGTH_FIELD)))


def polls_end(buffer: bytes, at: int) -> int:
    """Returns the offset after the polls at an offset: length fields of 0, which the brick passes over."""
    found = _POLLS.match(buffer, at)
    assert found is not None
    return found.end()


class Found(Enum):
    """What was found at an offset.

    NOTHING  nothing
    OPEN     an incomplete frame, valid so far
    SINGLE   a whole frame, not confirmed by what follows it
    CHAIN    a whole frame, and a header after it
    """

    NOTHING = auto()
    OPEN = auto()
    SINGLE = auto()
    CHAIN = auto()


class Finder:
    """A search for frames in the bytes of a stream.

    schema  reads frames
    """

    __slots__ = ("_schema",)

    def __init__(self, schema: FrameReader) -> None:
        self._schema = schema

    def may_start(self, buffer: bytes, at: int) -> bool:
        """Returns whether a frame may start here, as far as its header is there."""
        left = len(buffer) - at
        if left < LENGTH_FIELD:
            return True
        return may_have_length(buffer, at) and (left < HEADER_SIZE or buffer[at + HEADER_SIZE - 1] in _TYPES)

    def is_frame(self, buffer: bytes, at: int, end: int) -> bool:
        """Returns whether a valid frame is here that a program would send."""
        if end - at < HEADER_SIZE or buffer[at + HEADER_SIZE - 1] not in _TYPES:
            return False
        return is_sensible(self._schema.read_frame(buffer[at:end], strict=False))

    def is_self_evident(self, buffer: bytes, at: int) -> bool:
        """Returns whether a valid frame is one whatever follows it: few bytes are operations by chance."""
        member = _TYPES.get(buffer[at + HEADER_SIZE - 1])
        return member is not None and member.is_command and member.carries == "direct"

    def may_become(self, buffer: bytes, at: int) -> bool:
        """Returns whether an incomplete frame may become a valid one."""
        if not self.may_start(buffer, at):
            return False
        size = len(buffer)
        if size - at <= HEADER_SIZE:
            return True
        member = _TYPES[buffer[at + HEADER_SIZE - 1]]
        if member.carries == "system":
            return buffer[at + HEADER_SIZE] in system.SYSTEM_BY_NUMBER
        if member.carries == "direct" and member.is_command and size - at > COMMAND_HEADER_SIZE:
            _, fault = self._schema.instructions.scan(buffer, at + COMMAND_HEADER_SIZE, size)
            return fault is None or fault.truncated
        return True

    def follow(self, buffer: bytes, at: int) -> int | None:
        """Returns the number of headers from here on, one after the other; None if no frame can be here.

        It counts only a few: the next gap may come soon.
        """
        size, count = len(buffer), 0
        while at < size and count < MOST_FOLLOWING:
            at = polls_end(buffer, at)
            if not self.may_start(buffer, at):
                return None
            if size - at < HEADER_SIZE:
                break
            count += 1
            at += frame_size(buffer, at)
        return count

    def first_command(
        self, buffer: bytes, begins: Collection[int], accepts: Accepts, missing: int = 0
    ) -> tuple[int, bool]:
        """Returns the offset of the first plausible command, and whether it is whole.

        Args:
            buffer: Bytes of a stream that is not claimed.
            begins: Offsets at which packets begin: anything may follow a command there; elsewhere only a frame.
            accepts: Tells which types go this way.
            missing: Number of bytes after these that were not captured: a command that ends with them counts as whole.

        Returns:
            The offset of a whole command; else of the first incomplete one, or the end of the bytes.

        """
        size = len(buffer)
        opened = next(
            (place for place in range(max(size - HEADER_SIZE + 1, 0), size) if self.may_start(buffer, place)), size
        )
        for hit in islice(_STARTS.finditer(buffer), MOST_TRIALS):
            place = hit.start()
            if not may_have_length(buffer, place):
                continue
            end = place + frame_size(buffer, place)
            member = _TYPES[buffer[place + HEADER_SIZE - 1]]
            is_cut = missing > 0 and end == size + missing and size - place >= _LEAST_CUT
            is_split = (end > size and not is_cut) or any(place < start < end for start in begins)
            is_data = member.carries == "system" and buffer[place + HEADER_SIZE : place + HEADER_SIZE + 1] in _WITH_DATA
            if not accepts(member) or member.carries == "daisy" or (is_split and is_data):
                continue
            if end > size and not is_cut:
                if place < opened and self.may_become(buffer, place):
                    opened = place
            elif (place in begins or end >= size or self.may_start(buffer, end)) and is_plausible(
                self._schema.read_frame(buffer[place:end], strict=False), self._schema, is_cut=is_cut
            ):
                return place, True
        return opened, False

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
        size, trials = len(buffer), MOST_TRIALS
        opened = single = begun = None
        for hit in _STARTS.finditer(buffer, at):
            place = hit.start()
            if not may_have_length(buffer, place) or not accepts(_TYPES[buffer[place + HEADER_SIZE - 1]]):
                continue
            end = place + frame_size(buffer, place)
            trials -= 1
            if trials <= 0:
                break
            if end > size:
                if opened is None and self.may_become(buffer, place):
                    opened = place
                continue
            following = self.follow(buffer, end) if end < size else 0
            is_begin = place in begins
            if (following is None and not is_begin) or (following or 0) < least:
                continue
            is_frame = self.is_frame(buffer, place, end)
            if is_frame and following:
                return Found.CHAIN, place
            if is_frame and following is not None:
                single = place if single is None else single
            elif is_begin and (is_frame or following is not None):
                begun = place if begun is None else begun
        if single is not None:
            return Found.SINGLE, single
        if begun is not None:
            return Found.SINGLE, begun
        if opened is not None:
            return Found.OPEN, opened
        return Found.NOTHING, size
