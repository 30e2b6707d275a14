"""Claims of conversations, without I/O: which packets are this protocol. The rule is in `tables.claims`."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Hashable, Sequence
from enum import Enum, auto
from typing import NamedTuple

from ev3proto.capture.evidence import is_complete_reply, is_sensible, proves
from ev3proto.capture.finding import Accepts, Finder, Found
from ev3proto.capture.record import Event, Record
from ev3proto.schema.frame import FrameReader
from ev3proto.schema.header import may_start
from ev3proto.tables.claims import MOST_HELD, REPLIES, STRANGE_PACKETS
from ev3proto.tables.frame import MAX_FRAME


class State(Enum):
    """The state of a conversation."""

    OPEN = auto()  # not claimed; commands that are not plausible may wait for a reply that proves them
    CLAIMED = auto()  # claimed from a plausible command, or from replies, on
    ANSWERED = auto()  # claimed, and a reply has proved it: faulty frames keep the claim, too
    SURE = auto()  # claimed for good
    ENDED = auto()  # claimed before: a new claim may begin anywhere in a packet


_UNCLAIMED = (State.OPEN, State.ENDED)


class Held(NamedTuple):
    """A packet of commands that a reply may prove."""

    side: Hashable
    frames: list[bytes]
    adopt: Callable[[], list[Event]]  # returns their events, once they are proved


def _is_proof(record: Record) -> bool:
    return record.request is not None and proves(record.frame, record.request.frame)


def _is_meant(record: Record) -> bool:
    return record.is_mended or is_sensible(record.message)


class Claim:
    """The claim of one conversation.

    schema      reads frames
    begins      tells which message types begin a claim
    to_brick    the direction to the brick, as on TCP, where replies alone begin a claim, too; else None
    state       its state
    """

    def __init__(
        self, schema: FrameReader, begins: Accepts, to_brick: Hashable | None = None, *, is_sure: bool = False
    ) -> None:
        self.state = State.SURE if is_sure else State.OPEN
        self.to_brick = self._known = to_brick
        self.held: deque[Held] = deque(maxlen=MOST_HELD)
        self._schema, self._finder, self._begins = schema, Finder(schema), begins
        self._replies = self._strange = self._unread = 0

    @property
    def is_claimed(self) -> bool:
        """Whether the packets are ours."""
        return self.state not in _UNCLAIMED

    def begin(self, state: State = State.CLAIMED) -> None:
        """Claims the conversation from now on."""
        self.state = state
        self._replies = self._strange = self._unread = 0
        self.held.clear()

    def judge(
        self,
        side: Hashable,
        text: bytes,
        adopt: Callable[[int], Callable[[], list[Event]]],
        starts: Sequence[int] = (0,),
        missing: int = 0,
        *,
        needs_reply: bool = False,
    ) -> tuple[Found, int, list[Event]]:
        """Judges the newest packet of a conversation that is not claimed, which may begin a claim.

        Args:
            side: Its direction.
            text: The bytes that wait in that direction, and those of the packet.
            adopt: Returns the function that gives the events of commands from an offset on, for when they are proved.
            starts: Offsets at which packets begin in these bytes, the newest last.
            missing: Number of the packet's bytes that were not captured.
            needs_reply: A command claims nothing before a reply proves it.

        Returns:
            CHAIN and the offset from which on the bytes are ours, with the events of earlier commands; OPEN and the
            offset from which on they wait for more; else anything, the end, and no events.

        """
        if side != self.to_brick or self._known is None:
            proved = self._proved(side, text[starts[-1] :])
            if proved is not None:
                return Found.CHAIN, starts[-1], proved
        if side != self._known is not None:
            return (Found.CHAIN, 0, []) if self._has_replies(text) else (Found.NOTHING, len(text), [])
        anywhere = self.state is State.ENDED
        found, place = self._finder.find_command(text, starts, self._begins, missing, anywhere=anywhere)
        if found is Found.CHAIN and needs_reply:
            found = Found.SINGLE
        if found is Found.CHAIN:
            self.to_brick = side
            self.begin()
        elif found is Found.SINGLE:
            self.held.append(Held(side, self._finder.frames_of(text, place, missing), adopt(place)))
        return found, place, []

    def _proved(self, side: Hashable, reply: bytes) -> list[Event] | None:
        """Returns the events of held commands, from the newest that a reply proves; None if it proves none.

        Its length, counter and type are enough: the rest of a long reply comes in later packets.
        """
        held = [each for each in self.held if each.side != side and may_start(reply)]
        for index in reversed(range(len(held))):
            if any(proves(reply, command) for command in held[index].frames):
                self.to_brick = held[index].side
                self.begin(State.ANSWERED)
                return [event for each in held[index:] for event in each.adopt()]
        return None

    def _has_replies(self, text: bytes) -> bool:
        """Counts complete replies, and returns whether they begin a claim."""
        frames = self._finder.frames_of(text)
        are_replies = all(is_complete_reply(self._schema.read_frame(frame, strict=False)) for frame in frames)
        self._replies = self._replies + len(frames) if are_replies and sum(map(len, frames)) == len(text) else 0
        if self._replies < REPLIES:
            return False
        self.begin()
        return True

    def count(self, records: Sequence[Record], unread: int = 0) -> None:
        """Counts a packet of a claimed conversation, its frames and other bytes; that may end the claim."""
        if not self.is_claimed or self.state is State.SURE or not (records or unread):
            return
        if self.state is State.CLAIMED and any(map(_is_proof, records)):
            self.state = State.ANSWERED
        if records and (self.state is State.ANSWERED or any(map(_is_meant, records))):
            self._strange = self._unread = 0
            return
        self._strange += 1
        self._unread += unread
        # In a dialogue, the rest of a frame may come in many packets.
        if self._strange >= STRANGE_PACKETS and (self.state is not State.ANSWERED or self._unread > MAX_FRAME):
            self.state = State.ENDED
