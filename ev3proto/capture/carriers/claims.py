"""Whether a connection is ours, by what is said in it: `tables.claims` has the rule.

What is found in a connection is held back until something in it shows that the connection is ours. Then all of that is
given, as a capture may begin inside a frame. Where nothing does, the bytes count as other traffic.
"""

from __future__ import annotations

from ev3proto.capture.carriers.streams import Context
from ev3proto.capture.finding import Finder, count_telling, makes_sense
from ev3proto.capture.record import Announcement, Direction, Event, Record, Skipped
from ev3proto.messages import DaisyCommand, DaisyReply, DirectCommand, DirectReply
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.tables.claims import MOST_PROOFS, PROOFS, STRANGE_IN_A_ROW, STRANGE_PACKETS
from ev3proto.tables.frame import MAX_FRAME

_HELD_SIZE = 700
"""Bytes of memory that something found takes while it is held back, besides its bytes, about."""


def _is_right(event: Event) -> bool:
    """Whether something found in a TCP connection is a flawless frame that makes sense and goes the right way."""
    if not isinstance(event, Record):
        return False
    message = event.message
    if message.fault is not None or message.type is None:
        return False
    # Bricks in a chain send commands both ways.
    is_right_way = message.type.carries == "daisy" or message.type.is_command == (event.direction is Direction.SENT)
    return is_right_way and makes_sense(message)


def is_proof(event: Event) -> bool:
    """Says whether something shows that a connection is a brick's: a text, or a reply just as it was asked for."""
    if not isinstance(event, Record):
        return isinstance(event, Announcement)
    if event.request is None or not _is_right(event):
        return False
    reply, asked = event.message, event.request.message
    if isinstance(reply, DirectReply):
        size = 0 if reply.is_error or not isinstance(asked, DirectCommand) else asked.global_size
        return len(event.frame) == HEADER_SIZE + size
    return not isinstance(reply, DaisyCommand | DaisyReply)


class Claim:
    """What is known of one connection.

    Attributes:
        is_claimed: It is taken for ours.
        is_proven: Something showed it that is no chance.

    """

    __slots__ = (
        "_account",
        "_faulty",
        "_has_ended",
        "_is_left",
        "_is_weak",
        "_proofs",
        "_sides",
        "_strange",
        "_telling",
        "_unread",
        "is_claimed",
        "is_proven",
    )

    def __init__(self, context: Context) -> None:
        """Makes the claim of a new connection.

        Args:
            context: Counts the bytes, and limits what is held back.

        """
        self._account = context.account
        self.is_claimed = self.is_proven = False
        self._is_weak = False
        self._has_ended = 0  # how much must tell that the next claim is none by chance
        self._telling = 0
        self._proofs = 0
        self._strange = 0
        self._unread = 0
        self._faulty = 0
        self._is_left = False
        self._sides = dict.fromkeys(Direction, 0)  # strange packets at the beginning of each

    def _decline(self, events: list[Event]) -> None:
        account = self._account
        for event in events:
            if isinstance(event, Skipped):
                account.skipped -= len(event.data)
                account.other += len(event.data)
            elif isinstance(event, Record):
                account.frames -= len(event.frame)
                account.other += len(event.frame)

    def _count_faulty(self) -> bool:
        """Counts a packet that is full of frames, though not of flawless ones. False: it is one too many."""
        if not self.is_claimed:
            return False
        self._faulty += 1
        if self._is_weak:
            self._proofs = 0
        return self._faulty <= STRANGE_PACKETS

    def _meet_ours(self, side: Direction, telling: int) -> None:
        self._sides[side] = STRANGE_IN_A_ROW
        if self._has_ended and not self.is_claimed:
            self._telling += telling
            if self._telling < self._has_ended:
                return
        elif self._is_left:
            return
        self._is_weak = not telling and (self._is_weak or not self.is_claimed)
        self._proofs = (self._proofs if self.is_claimed else 0) + min(1 + telling, MOST_PROOFS)
        self.is_claimed = True
        self._strange = self._unread = 0
        if telling:
            self._faulty = 0
        if self._proofs >= PROOFS:
            self.is_proven = True

    def _meet_strange(self, side: Direction, size: int) -> None:
        self._telling = 0
        if self.is_claimed and self._is_weak:
            # It may be what is left of a frame, as it is among the first of its side.
            self._sides[side] += 1
            if self._sides[side] <= STRANGE_IN_A_ROW:
                return
        self._count_strange(size)
        if self.is_claimed and self._strange >= (1 if self._is_weak else STRANGE_IN_A_ROW):
            self._end_claim()
        elif not self.is_claimed and not self._has_ended and self._strange >= STRANGE_PACKETS:
            self._is_left = True

    def _count_strange(self, size: int) -> None:
        if size > HEADER_SIZE:
            self._strange += 1
        else:
            self._unread += size
            if self._unread > MAX_FRAME:
                self._strange = STRANGE_PACKETS

    def _end_claim(self) -> None:
        """The claim ends, or too much was strange before there was one: now more must tell that it is ours."""
        self._has_ended = 1 if self.is_claimed and self._is_weak else 2
        self.is_claimed = self.is_proven = False
        self._telling = self._strange = 0


class ConnectionClaim(Claim):
    """What is known of a TCP connection, and until it is claimed what was found in it. Once proven, it stays ours."""

    __slots__ = ("_budget", "_finder", "_held", "_size", "_waited")

    def __init__(self, context: Context) -> None:
        """Makes the claim of a new connection.

        Args:
            context: Counts the bytes, and limits what is held back.

        """
        super().__init__(context)
        self._budget = context.budget
        self._held: list[Event] = []
        self._size = 0
        self._waited = dict.fromkeys(Direction, 0)  # bytes of each before the last packet that nothing was found in yet
        self._finder = Finder(context.schema)

    def _hold(self, events: list[Event]) -> None:
        if events:
            self._held += events
            self._size += sum(map(_size_of, events))
            self._budget.update(self, self._size, self._give_up)

    def _taken(self) -> list[Event]:
        """What was held back, which is not any more."""
        held, self._held, self._size = self._held, [], 0
        if held:
            self._budget.remove(self)
        return held

    def _give_up(self, _number: int) -> None:
        """Too much waits: what is held back here is none of ours."""
        self._is_left = True
        if not self.is_claimed:
            self._decline(self._taken())

    def take(self, events: list[Event], data: bytes, side: Direction) -> list[Event]:
        """Takes what was found.

        Args:
            events: What is complete with a packet.
            data: What the packet carried; nothing where it is not a packet that completes them.
            side: Its direction.

        Returns:
            What is known to be ours.

        """
        if self.is_proven:
            return events
        if any(map(is_proof, events)):
            self.is_claimed = self.is_proven = True
            return [*self._taken(), *events]
        waited = self._waited[side]
        self._waited[side] = 0 if events else waited + len(data)
        frames = [event for event in events if isinstance(event, Record) and _is_right(event)]
        telling = sum(count_telling(event.message) for event in frames)
        was_claimed = self.is_claimed
        if telling:
            self._meet_ours(side, telling)
        elif self._is_exact(frames, events, data, waited):
            self._meet_ours(side, 0)
        elif len(frames) < len(events) and not self._meet_faulty(events, data):
            self._meet_strange(side, len(data))
        if self.is_claimed:
            held = self._taken()
            return [*(held if was_claimed or telling else self._skipped(held)), *events]
        if was_claimed or self._has_ended or self._is_left:
            self._decline([*self._taken(), *events])
        else:
            self._hold(events)
        return []

    def _is_exact(self, frames: list[Record], events: list[Event], data: bytes, waited: int) -> bool:
        """Whether frames without a fault are all that there is in their packets, or what follows may become one."""
        size = sum(len(record.frame) for record in frames)
        if frames and data == b"".join(record.frame for record in frames):
            # What could not be read is of packets before.
            return all(isinstance(event, Record | Skipped) for event in events)
        if len(frames) < len(events) or not frames:
            return False
        if waited or len(data) <= size:
            return len(data) + waited == size
        return self._finder.may_become(data, size)

    def _meet_faulty(self, events: list[Event], data: bytes) -> bool:
        """Counts a packet that frames with faults fill, or misdirected ones. False: it is none, or one too many."""
        frames = [event.frame for event in events if isinstance(event, Record) and event.message.type is not None]
        return len(frames) == len(events) and b"".join(frames).endswith(data) and self._count_faulty()

    def end(self) -> list[Event]:
        """Says that nothing more will come.

        Returns:
            What could not be read of a connection that was too short to tell.

        """
        return self._skipped(self._taken())

    def _skipped(self, events: list[Event]) -> list[Event]:
        """What could not be read, of what was held back; the rest is none of ours."""
        self._decline([event for event in events if not isinstance(event, Skipped)])
        return [event for event in events if isinstance(event, Skipped)]


def _size_of(event: Event) -> int:
    return _HELD_SIZE + len(event.frame if isinstance(event, Record) else event.data)
