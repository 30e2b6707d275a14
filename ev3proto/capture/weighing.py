"""What the bytes of a packet tell: whether they are ours. `tables.claims` has the rule."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from enum import Enum, auto
from typing import NamedTuple

from ev3proto.capture.finding import Finder, count_telling, makes_sense
from ev3proto.messages import DirectReply, Message
from ev3proto.schema.frame import FrameSchema, frame_schema
from ev3proto.schema.header import HEADER_SIZE, frame_size
from ev3proto.tables.claims import may_be_of_nxt
from ev3proto.tables.declaration import DIALECTS
from ev3proto.tables.frame import LENGTH_FIELD, MessageType

Accepts = Callable[[MessageType], bool]
"""Says which types go the way of a packet."""


class Likeness(Enum):
    """What some bytes tell.

    NOTHING  they are none of ours
    PART     more is needed to tell
    PERHAPS  they are ours or a chance
    OURS     they are ours
    """

    NOTHING = auto()
    PART = auto()
    PERHAPS = auto()
    OURS = auto()


class Weight(NamedTuple):
    """What some bytes tell of a connection.

    verdict  whether it is ours
    telling  how much tells that others' data hardly ever do
    at       the offset where frames begin
    """

    verdict: Likeness
    telling: int = 0
    at: int = 0


class Weigher:
    """Weighs bytes that may be frames.

    schema      reads frames; direct commands that it cannot read are tried with the instructions of other firmware
    takes_rest  any other bytes may follow a frame that tells; else fewer than a header has
    """

    __slots__ = ("_finder", "_schema", "_takes_rest")

    def __init__(self, schema: FrameSchema, *, takes_rest: bool) -> None:
        self._schema = schema
        self._takes_rest = takes_rest
        self._finder = Finder(schema)

    def weigh(self, text: bytes, at: int, accepts: Accepts, *, is_inside: bool = False) -> Weight:
        """Says what some bytes tell that should begin with a frame.

        Args:
            text: The bytes.
            at: Where the frame should begin.
            accepts: Says which types go this way.
            is_inside: It begins inside a packet of a connection that is not claimed: nothing but frames may follow.

        Returns:
            OURS where a frame tells that it is; PERHAPS where all are without a fault, and none tells it. The first one
            must be without, and the others must look like frames, up to one that tells.

        """
        start, is_clean, telling = at, True, 0
        while at < len(text):
            if not self._finder.may_start(text, at):
                is_taken = (self._takes_rest and not is_inside) or len(text) - at < HEADER_SIZE
                return _weight(telling if is_taken else 0, start, is_clean=False)
            end = at + frame_size(text, at) if len(text) - at >= LENGTH_FIELD else len(text) + 1
            if end > len(text):
                is_part = self.may_become(text, at, accepts)
                if at == start:
                    return Weight(Likeness.PART if is_part else Likeness.NOTHING)
                is_clean &= is_part
                break
            message = self._read(text[at:end], accepts)
            if at == start and message is None:
                return Weight(Likeness.NOTHING)
            is_clean &= message is not None
            if is_clean and message is not None:
                telling += count_telling(message)
            at = end
        return _weight(telling, start, is_clean=is_clean)

    def weigh_anywhere(self, text: bytes, joint: int, accepts: Accepts, *, is_claimed: bool = True) -> Weight:
        """Says the same of bytes that may begin inside a frame.

        Args:
            text: The bytes.
            joint: Where the newest packet begins: a frame may begin with it.
            accepts: Says which types go this way.
            is_claimed: The connection is claimed.

        Returns:
            What is told where a frame begins. Elsewhere than at both beginnings it is believed where it tells itself.

        """
        weight = self.weigh(text, 0, accepts)
        if weight.verdict is Likeness.NOTHING and joint:
            weight = self.weigh(text, joint, accepts)
        if weight.verdict is not Likeness.NOTHING:
            return weight
        place = self._finder.first_place(text, 1, accepts)
        found = weight if place is None else self.weigh(text, place, accepts, is_inside=not is_claimed)
        return found if found.verdict is Likeness.OURS else Weight(Likeness.NOTHING)

    def weigh_cut(self, text: bytes, missing: int, *, is_claimed: bool = False) -> Weight:
        """Says what a packet tells that may be the beginning of a flawless frame, where the rest was not captured.

        Args:
            text: What was captured.
            missing: How many bytes came after that.
            is_claimed: The connection is claimed: of the frame its header is enough.

        Returns:
            PERHAPS where the frame ends with the packet, and where what is there of it makes sense.

        """
        is_frame = len(text) >= HEADER_SIZE and frame_size(text) == len(text) + missing
        is_telling = len(text) > HEADER_SIZE and not may_be_of_nxt(text)
        is_ours = is_frame and (is_claimed or (is_telling and makes_sense(self._schema.read_frame(text, strict=False))))
        return Weight(Likeness.PERHAPS if is_ours else Likeness.NOTHING)

    def may_become(self, text: bytes, at: int, accepts: Accepts) -> bool:
        """Whether the frame of which only the start is here may be a flawless one that goes this way."""
        return self._finder.may_become(text, at) and (len(text) - at < HEADER_SIZE or _is_accepted(text, at, accepts))

    def is_part(self, text: bytes, accepts: Accepts) -> bool:
        """Whether a flawless frame that goes this way may begin here, and is not whole."""
        is_whole = len(text) >= LENGTH_FIELD and frame_size(text) <= len(text)
        return not is_whole and self.may_become(text, 0, accepts)

    def hold_frames(self, text: bytes) -> Likeness:
        """Says whether there are frames and nothing else, whatever is wrong with them.

        Args:
            text: The bytes.

        Returns:
            PART where the last one has its header and is not whole, NOTHING where there is anything else.

        """
        at = 0
        while at < len(text):
            if len(text) - at < HEADER_SIZE or not self._finder.may_start(text, at):
                return Likeness.NOTHING
            at += frame_size(text, at)
        return Likeness.OURS if at == len(text) else Likeness.PART

    def _read(self, frame: bytes, accepts: Accepts) -> Message | None:
        """What a frame says; None where it has a fault, goes the wrong way, makes no sense, or may be the NXT's."""
        if not _is_accepted(frame, 0, accepts) or may_be_of_nxt(frame):
            return None
        readings = (schema.read_frame(frame, strict=False) for schema in (self._schema, *_other_schemas(frame)))
        message = next((message for message in readings if message.fault is None), None)
        if message is None or not makes_sense(message):
            return None
        # A reply that a command failed brings no memory.
        is_odd = isinstance(message, DirectReply) and message.is_error and len(frame) > HEADER_SIZE
        return None if is_odd else message


def _weight(telling: int, start: int, *, is_clean: bool) -> Weight:
    if telling:
        return Weight(Likeness.OURS, telling, start)
    return Weight(Likeness.PERHAPS, 0, start) if is_clean else Weight(Likeness.NOTHING)


def _is_accepted(text: bytes, at: int, accepts: Accepts) -> bool:
    return accepts(MessageType(text[at + HEADER_SIZE - 1]))


def _other_schemas(frame: bytes) -> Iterator[FrameSchema]:
    """What reads a direct command by the instructions of each firmware."""
    member = MessageType(frame[HEADER_SIZE - 1])
    if member.carries == "direct" and member.is_command:
        yield from map(frame_schema, DIALECTS)
