"""Whether a connection is ours, by what is said in it: `tables.claims` has the rule."""

from __future__ import annotations

from ev3proto.capture.carriers.streams import Context
from ev3proto.capture.finding import makes_sense
from ev3proto.capture.record import Announcement, Direction, Event, Record, Skipped
from ev3proto.messages import DaisyCommand, DaisyReply, DirectCommand, DirectReply
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.tables.claims import MOST_PROOFS, PROOFS, STRANGE_IN_A_ROW, STRANGE_PACKETS
from ev3proto.tables.frame import MAX_FRAME


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
        "_has_command",
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
        self._has_command = False  # not only replies claimed it
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

    def _count_faulty(self, side: Direction, *, is_whole: bool = True) -> bool:
        """Counts a packet that is full of frames, though not of flawless ones. False: it is one too many.

        Where the last frame is not whole yet the packet does not count, but it may not be one too many either.
        """
        if not self.is_claimed:
            return False
        is_taken = self._faulty < (STRANGE_PACKETS if self._has_command else STRANGE_IN_A_ROW)
        if is_whole:
            self._faulty += 1
            if self._is_weak:
                self._proofs = 0
        if not is_taken:
            # It is not what is left of a frame.
            self._sides[side] = STRANGE_IN_A_ROW
        return is_taken

    def _meet_ours(self, side: Direction, telling: int, *, is_command: bool) -> None:
        self._sides[side] = STRANGE_IN_A_ROW
        if self._has_ended and not self.is_claimed:
            self._telling += telling
            if self._telling < self._has_ended:
                return
        elif self._is_left:
            return
        self._is_weak = not telling and (self._is_weak or not self.is_claimed)
        self._has_command = is_command or (self._has_command and self.is_claimed)
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
