"""Whether a serial port of Bluetooth is ours, packet by packet: `tables.claims` has the rule."""

from __future__ import annotations

from typing import NamedTuple

from ev3proto.capture.carriers.bluetooth.adapters import Carried
from ev3proto.capture.carriers.claims import Claim, is_proof
from ev3proto.capture.carriers.streams import Context
from ev3proto.capture.packets import Packet
from ev3proto.capture.record import Direction, Event, Skipped
from ev3proto.capture.weighing import Likeness, Weigher
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.tables.claims import FAULTS_IN_A_ROW, STRANGE_PACKETS
from ev3proto.tables.frame import MAX_FRAME, MessageType

_PIECE_SIZE = 200
"""Bytes of memory that a packet takes while it waits, besides its data, about."""


class Piece(NamedTuple):
    """What a packet carries.

    data     the bytes
    number   the packet
    time_ns  when it was captured
    packet   the packet itself
    found    what carries the bytes in it
    """

    data: bytes
    number: int
    time_ns: int
    packet: Packet
    found: Carried


class PortClaim(Claim):
    """What is known of a serial port. It may become ours at any time, and cease to be."""

    __slots__ = (
        "_budget",
        "_early",
        "_early_side",
        "_faults",
        "_small",
        "_speaker",
        "_to_brick",
        "_waiting",
        "_weigher",
    )

    def __init__(self, context: Context) -> None:
        """Makes the claim of a new port.

        Args:
            context: Counts the bytes, and limits what waits.

        """
        super().__init__(context)
        self._budget = context.budget
        self._weigher = Weigher(context.schema, takes_rest=False)
        self._to_brick: Direction | None = None
        self._speaker: Direction | None = None
        self._waiting: list[Piece] = []  # of a command that is not whole yet, before the port is claimed
        self._early: list[Piece] = []  # replies before the first command
        self._early_side: Direction | None = None
        self._faults = 0
        self._small = 0  # bytes of strange packets that are no larger than a header

    def begin(self, side: Direction, piece: Piece) -> list[Piece]:
        """Takes a packet of a port that is not known to be ours.

        Args:
            side: Its direction.
            piece: What it carries.

        Returns:
            The packets that claim the port, of which this is the last one. None where it is not claimed.

        """
        if side is not self._speaker:
            # Nobody answers in the middle of a command.
            self._decline_pieces(self._taken())
            self._speaker = side
        verdict, telling = Likeness.NOTHING, 0
        if self._waiting:
            text = b"".join(before.data for before in self._waiting) + piece.data
            verdict, telling = self._weigh_commands(text, is_joined=True)
        if verdict is Likeness.NOTHING:
            self._decline_pieces(self._taken())
            verdict, telling = self._weigh_commands(piece.data)
        if verdict is Likeness.PART:
            self._wait(self._waiting, piece)
            return []
        is_reply = verdict is Likeness.NOTHING and self._may_be_reply(side, piece)
        if is_reply and not self._strange and not self._has_ended:
            self._early_side = side
            self._wait(self._early, piece)
            return []
        if not is_reply:
            self._count(side, verdict, telling, len(piece.data))
        if self.is_claimed:
            self._to_brick, self._faults = side, 0
            early, self._early = self._early, []
            return [*early, *self._taken(), piece]
        self.forget()
        self._decline_pieces([piece])
        return []

    def take(self, side: Direction, events: list[Event], text: bytes, size: int, *, is_in_step: bool) -> bool:
        """Takes a packet of a port that is known to be ours.

        Args:
            side: Its direction.
            events: What is complete with it.
            text: What it carries, after the bytes that waited for it.
            size: How many bytes it carries.
            is_in_step: A frame began with the text, if the one before ended where its length said.

        Returns:
            False where the claim ends before it, so that it is none of ours.

        """
        if not self.is_proven:
            if not self._belongs(side, text, size, is_in_step=is_in_step):
                self._decline(events)
                return False
            self.is_proven = self.is_proven or any(map(is_proof, events))
        self._count_faults(events)
        return True

    def end(self, events: list[Event]) -> None:
        """Says that the claim has ended, and what waited is none of ours."""
        self._decline(events)

    def forget(self, _number: int = 0) -> None:
        """Waits no longer for the rest of a command, or for the first one."""
        self._decline_pieces(self._early + self._taken())
        self._early = []

    def _decline_pieces(self, pieces: list[Piece]) -> None:
        self._account.other += sum(len(piece.data) for piece in pieces)

    def _wait(self, waiting: list[Piece], piece: Piece) -> None:
        waiting.append(piece)
        size = sum(len(before.data) + _PIECE_SIZE for before in self._early + self._waiting)
        self._budget.update(self, size, self.forget)

    def _taken(self) -> list[Piece]:
        waiting, self._waiting = self._waiting, []
        self._budget.remove(self)
        return waiting

    def _may_be_reply(self, side: Direction, piece: Piece) -> bool:
        """Whether a packet may be a brick's, with those before it, with which the capture begins."""
        size = sum(len(before.data) for before in self._early)
        if self._early and (side is not self._early_side or size + len(piece.data) > MAX_FRAME):
            self.forget()
        text = b"".join(before.data for before in self._early) + piece.data
        return self._weigher.weigh(text, 0, _is_from_brick).verdict is not Likeness.NOTHING

    def _weigh_commands(self, text: bytes, *, is_joined: bool = False) -> tuple[Likeness, int]:
        """What a text tells that should begin with a command: nobody answers what was not asked."""
        verdict, telling, _ = self._weigher.weigh(text, 0, _is_command)
        if verdict not in (Likeness.PERHAPS, Likeness.OURS):
            return verdict, telling
        if is_joined and MessageType(text[HEADER_SIZE - 1]).carries == "system":
            # Any bytes may follow its header.
            return Likeness.PERHAPS, 0
        return verdict, telling

    def _count(self, side: Direction, verdict: Likeness, telling: int, size: int) -> None:
        if self._is_left:
            # Its connection may be another one meanwhile, so it is not left alone for good.
            self._is_left = False
            self._end_claim()
        if verdict is Likeness.NOTHING:
            self._meet_strange(side, size)
        else:
            self._meet_ours(side, telling, is_command=True)

    def _belongs(self, side: Direction, text: bytes, size: int, *, is_in_step: bool) -> bool:
        accepts = _is_command if side is self._to_brick else _is_from_brick
        if is_in_step and self._weigher.is_part(text, accepts):
            return True
        verdict, telling, _ = self._weigher.weigh_anywhere(text, len(text) - size, accepts)
        if verdict is Likeness.PART:
            # In a stream that is out of step anything may look like a part of a frame.
            verdict = Likeness.NOTHING
        if (
            verdict is Likeness.NOTHING
            and self._weigher.hold_frames(text) is Likeness.OURS
            and self._count_faulty(side)
        ):
            return True
        self._small = self._small + size if verdict is Likeness.NOTHING else 0
        if self._small > STRANGE_PACKETS * HEADER_SIZE:
            # Small packets count together.
            size, self._small = self._small, 0
        self._count(side, verdict, telling, size)
        return self.is_claimed

    def _count_faults(self, events: list[Event]) -> None:
        """After too much without anything of ours a proven port is not known to be ours any more."""
        skipped = [event for event in events if isinstance(event, Skipped)]
        if not self.is_proven or len(skipped) < len(events):
            self._faults = self._unread = 0
        elif events:
            self._faults += 1
            self._unread += sum(len(event.data) for event in skipped)
            # What is left of a frame of which something is missing may come in many packets.
            if self._faults >= FAULTS_IN_A_ROW and self._unread > FAULTS_IN_A_ROW * MAX_FRAME:
                self._end_claim()


def _is_command(member: MessageType) -> bool:
    return member.is_command


def _is_from_brick(member: MessageType) -> bool:
    """Bricks write into each other's mailboxes."""
    return not member.is_command or (member.carries == "system" and not member.wants_reply)
