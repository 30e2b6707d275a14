"""What the bytes of a packet tell: whether they are ours. `tables.claims` has the rule."""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum, auto

from ev3proto.capture.finding import Finder, count_telling
from ev3proto.schema.frame import FrameSchema
from ev3proto.schema.header import HEADER_SIZE, frame_size
from ev3proto.tables.frame import LENGTH_FIELD, MessageType

Accepts = Callable[[MessageType], bool]
"""Says which types go the way of a packet."""


class Verdict(Enum):
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


class Weigher:
    """Weighs bytes that may be frames.

    schema  reads frames
    """

    __slots__ = ("_finder", "_schema")

    def __init__(self, schema: FrameSchema) -> None:
        self._schema = schema
        self._finder = Finder(schema)

    def weigh(self, text: bytes, at: int, accepts: Accepts) -> tuple[Verdict, int]:
        """Says what some bytes tell that should begin with a frame.

        Args:
            text: The bytes.
            at: Where the frame should begin.
            accepts: Says which types go this way.

        Returns:
            OURS where a frame tells that it is; PERHAPS where all are without a fault, and none tells it; else the
            first one must be, and the others must look like frames. Also how much they tell.

        """
        start, is_clean, telling = at, True, 0
        while at < len(text):
            if not self._finder.may_start(text, at):
                return Verdict.NOTHING, 0
            end = at + frame_size(text, at) if len(text) - at >= LENGTH_FIELD else len(text) + 1
            if end > len(text):
                is_part = self.may_become(text, at, accepts)
                if at == start:
                    return (Verdict.PART if is_part else Verdict.NOTHING), 0
                is_clean &= is_part
                break
            stands = self._finder.stands(text, at, end) and _is_accepted(text, at, accepts)
            if at == start and not stands:
                return Verdict.NOTHING, 0
            is_clean &= stands
            if is_clean:
                telling += count_telling(self._schema.read_for_later(text[at:end]))
            at = end
        if telling:
            return Verdict.OURS, telling
        return (Verdict.PERHAPS if is_clean else Verdict.NOTHING), 0

    def weigh_first(self, text: bytes, at: int, accepts: Accepts) -> tuple[Verdict, int]:
        """Says the same, but fewer bytes than a header has may follow, whatever they are, if the first frame tells it.

        Args:
            text: The bytes.
            at: Where the frame should begin.
            accepts: Says which types go this way.

        Returns:
            What `weigh` does, of the first frame where it is nothing with what follows.

        """
        found = self.weigh(text, at, accepts)
        if found[0] is not Verdict.NOTHING or len(text) - at < LENGTH_FIELD:
            return found
        end = at + frame_size(text, at)
        if not 0 < len(text) - end < HEADER_SIZE:
            return found
        first = self.weigh(text[:end], at, accepts)
        return first if first[0] is Verdict.OURS else found

    def weigh_anywhere(self, text: bytes, joint: int, accepts: Accepts) -> tuple[Verdict, int]:
        """Says the same of bytes that may begin inside a frame.

        Args:
            text: The bytes.
            joint: Where the newest packet begins: a frame may begin with it.
            accepts: Says which types go this way.

        Returns:
            What is told where a frame begins. Elsewhere than at both beginnings it is believed where it tells itself.

        """
        verdict, telling = self.weigh_first(text, 0, accepts)
        if verdict is Verdict.NOTHING and joint:
            verdict, telling = self.weigh_first(text, joint, accepts)
        if verdict is not Verdict.NOTHING:
            return verdict, telling
        place = self._finder.first_place(text, 1, accepts)
        found = self.weigh(text, place, accepts) if place is not None else (verdict, 0)
        return found if found[0] is Verdict.OURS else (Verdict.NOTHING, 0)

    def may_become(self, text: bytes, at: int, accepts: Accepts) -> bool:
        """Whether the frame of which only the start is here may be a flawless one that goes this way."""
        return self._finder.may_become(text, at) and (len(text) - at < HEADER_SIZE or _is_accepted(text, at, accepts))

    def is_part(self, text: bytes, accepts: Accepts) -> bool:
        """Whether a flawless frame that goes this way may begin here, and is not whole."""
        is_whole = len(text) >= LENGTH_FIELD and frame_size(text) <= len(text)
        return not is_whole and self.may_become(text, 0, accepts)

    def holds_frames(self, text: bytes) -> bool:
        """Whether there are frames and nothing else, whatever is wrong with them."""
        at = 0
        while at < len(text):
            if len(text) - at < HEADER_SIZE or not self._finder.may_start(text, at):
                return False
            at += frame_size(text, at)
        return at == len(text)


def _is_accepted(text: bytes, at: int, accepts: Accepts) -> bool:
    return accepts(MessageType(text[at + HEADER_SIZE - 1]))
