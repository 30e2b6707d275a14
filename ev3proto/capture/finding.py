"""Where a stream goes on that is out of step: the next frame, found by what a frame must be like.

Five bytes of a header look right once in some thousand places of any data, so a place is believed for more than that:
all of a frame stands there without a fault, and what follows it may be the next one. Of a frame that is not whole yet
it is asked whether it can become such a one. The dissector finds frames in the same way.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection
from enum import Enum, auto
from itertools import islice

from ev3proto.capture.claims import is_plausible, is_sensible
from ev3proto.schema.frame import FrameSchema
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, frame_size, may_have_length
from ev3proto.tables import system
from ev3proto.tables.frame import LENGTH_FIELD, MAX_LENGTH, MIN_LENGTH, SYSTEM_COMMAND_TYPES, MessageType

Accepts = Callable[[MessageType], bool]
"""Says which types go the way of a stream."""

MOST_TRIALS = 64
"""Places in one piece of a stream where a whole frame is tried, before the piece is given up."""

MOST_FOLLOWING = 2
"""Frames after one that are looked at to tell whether it is one."""

_LEAST_CUT = COMMAND_HEADER_SIZE + 2
"""Bytes of a command that the capture must have to tell what it is."""

_TYPES = {int(member): member for member in MessageType}
# Where a header may stand: most places that are none are passed over at ten times the speed.
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
"""The system commands that any bytes may follow."""


_POLLS = re.compile(b"(?:%b)*" % re.escape(bytes(LENGTH_FIELD)))


def polls_end(buffer: bytes, at: int) -> int:
    """Returns the offset after the polls at an offset: length fields of 0, which the brick passes over."""
    found = _POLLS.match(buffer, at)
    assert found is not None
    return found.end()


class Found(Enum):
    """What stands at the place where a stream may go on.

    NOTHING  no place was found
    OPEN     a frame that is not whole yet, and without a fault so far
    SINGLE   a whole one, after which nothing tells whether it is one
    CHAIN    one, and the next one begins after it
    """

    NOTHING = auto()
    OPEN = auto()
    SINGLE = auto()
    CHAIN = auto()


class Finder:
    """Finds frames in the bytes of a stream.

    schema  reads frames
    """

    __slots__ = ("_schema",)

    def __init__(self, schema: FrameSchema) -> None:
        self._schema = schema

    def may_start(self, buffer: bytes, at: int) -> bool:
        """Whether a frame may start here, as far as its header is there."""
        left = len(buffer) - at
        if left < LENGTH_FIELD:
            return True
        return may_have_length(buffer, at) and (left < HEADER_SIZE or buffer[at + HEADER_SIZE - 1] in _TYPES)

    def stands(self, buffer: bytes, at: int, end: int) -> bool:
        """Whether a frame without a fault stands here, which somebody would send."""
        if end - at < HEADER_SIZE or buffer[at + HEADER_SIZE - 1] not in _TYPES:
            return False
        return is_sensible(self._schema.read_frame(buffer[at:end], strict=False))

    def is_self_evident(self, buffer: bytes, at: int) -> bool:
        """Whether a frame without a fault is one whatever follows it, as few bytes are operations by chance."""
        member = _TYPES.get(buffer[at + HEADER_SIZE - 1])
        return member is not None and member.is_command and member.carries == "direct"

    def may_become(self, buffer: bytes, at: int) -> bool:
        """Whether the frame of which only the start is here may be without a fault."""
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
        """How many frames begin here, one after the other, of those whose headers are here; None where none can.

        Few are enough to tell. The next gap in the stream may come soon.
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
        """The first place where a plausible command stands, and whether it is whole.

        Args:
            buffer: Bytes of a stream that is not known to be ours.
            begins: Offsets where packets begin: anything may follow the command there, elsewhere another frame.
            accepts: Says which types go this way.
            missing: Bytes after these that were not captured: a command that ends with them is whole.

        Returns:
            The place of a whole one; else of the first that may become one, where the bytes end if there is none.

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
        """The place from an offset on where the stream goes on, and what stands there.

        Args:
            buffer: Bytes of the stream.
            at: The first offset that may be the place.
            begins: Offsets where packets begin: there a frame may have faults, or nothing that can follow it.
            accepts: Says which types go this way.
            least: Frames that must begin after a whole one.

        Returns:
            What is there, and the offset, which is where the bytes end for `NOTHING`.

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
            stands = self.stands(buffer, place, end)
            if stands and following:
                return Found.CHAIN, place
            if stands and following is not None:
                single = place if single is None else single
            elif is_begin and (stands or following is not None):
                begun = place if begun is None else begun
        if single is not None:
            return Found.SINGLE, single
        if begun is not None:
            return Found.SINGLE, begun
        if opened is not None:
            return Found.OPEN, opened
        return Found.NOTHING, size
