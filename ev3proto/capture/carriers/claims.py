"""Whether a connection is ours, by what is said in it: `tables.claims` has the rule.

What is found in a connection is held back until something in it shows that the connection is ours. Then all of that is
given, as a capture may begin inside a frame. Where nothing does, the bytes count as other traffic.
"""

from __future__ import annotations

from collections.abc import Callable

from ev3proto.capture.carriers.streams import Context
from ev3proto.capture.finding import Finder, count_telling, makes_sense
from ev3proto.capture.record import Announcement, Direction, Event, Record, Skipped
from ev3proto.messages import DaisyCommand, DaisyReply, DirectCommand, DirectReply
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.tables.claims import FAULTS_IN_A_ROW, PROOFS, STRANGE_IN_A_ROW, STRANGE_PACKETS, may_be_of_nxt
from ev3proto.tables.frame import MAX_FRAME

MOST_HELD = 4096
"""Frames without a fault that are held back of a serial port on which there was no command so far."""

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


def _is_proof(event: Event) -> bool:
    """Whether something shows that a TCP connection is a brick's: a text, or a reply just as it was asked for."""
    if not isinstance(event, Record):
        return isinstance(event, Announcement)
    if event.request is None or not _is_right(event):
        return False
    reply, asked = event.message, event.request.message
    if isinstance(reply, DirectReply):
        size = 0 if reply.is_error or not isinstance(asked, DirectCommand) else asked.global_size
        return len(event.frame) == HEADER_SIZE + size
    return not isinstance(reply, DaisyCommand | DaisyReply)


def begins_a_serial_port(event: Event, turn: int) -> bool:
    """Says whether something shows that a serial port is a brick's: a flawless command that makes sense.

    Args:
        event: What was found.
        turn: The first packet after those of the other side: nobody answers in the middle of a command.

    Returns:
        False for replies, too: without the command anything might be one.

    """
    if not isinstance(event, Record) or event.numbers[0] < turn:
        return False
    message = event.message
    is_command = message.type is not None and message.type.is_command
    return is_command and message.fault is None and makes_sense(message) and not may_be_of_nxt(event.frame)


class Claim:
    """What is known of one connection: whether it is ours, and until then what was found in it.

    Attributes:
        is_claimed: It is known to be ours.

    """

    __slots__ = ("_account", "_budget", "_held", "_proofs", "_size", "_strange", "_unread", "is_claimed")

    def __init__(self, context: Context) -> None:
        """Makes the claim of a new connection.

        Args:
            context: Counts the bytes, and limits what is held back.

        """
        self._account = context.account
        self._budget = context.budget
        self.is_claimed = False
        self._held: list[Event] = []
        self._size = 0
        self._strange = 0
        self._unread = 0
        self._proofs = 0

    def meet_stranger(self) -> None:
        """Says that there are bytes that are none of ours: what was held back is none of ours either."""
        if not self.is_claimed:
            self._strange = 1
            self._decline(self._taken())

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
        self.meet_stranger()

    def _decline(self, events: list[Event]) -> None:
        account = self._account
        for event in events:
            if isinstance(event, Skipped):
                account.skipped -= len(event.data)
                account.other += len(event.data)
            elif isinstance(event, Record):
                account.frames -= len(event.frame)
                account.other += len(event.frame)


class SerialPortClaim(Claim):
    """What is known of a serial port. It may become ours at any time, and cease to be; what was before is not given."""

    __slots__ = ("_begins", "_faults")

    def __init__(self, context: Context, begins: Callable[[Event], bool]) -> None:
        """Makes the claim of a new port.

        Args:
            context: Counts the bytes, and limits what is held back.
            begins: Says whether something shows that the port is ours.

        """
        super().__init__(context)
        self._begins = begins
        self._faults = 0

    def take(self, events: list[Event]) -> list[Event]:
        """Takes what was found.

        Args:
            events: What is complete with a packet.

        Returns:
            What is known to be ours.

        """
        if self.is_claimed:
            return self._count_faults(events)
        if any(map(self._begins, events)):
            self.is_claimed = True
            self._unread = 0
            return [*self._taken(), *events]
        self._hold_flawless(events)
        return []

    def end(self) -> list[Event]:
        """Says that nothing more will come.

        Returns:
            Frames without a fault where there was nothing else.

        """
        return self._taken()

    def _hold_flawless(self, events: list[Event]) -> None:
        is_flawless = all(isinstance(event, Record) and event.message.fault is None for event in events)
        if self._strange or not is_flawless or len(self._held) > MOST_HELD:
            self.meet_stranger()
            self._decline(events)
        else:
            self._hold(events)

    def _count_faults(self, events: list[Event]) -> list[Event]:
        unread = 0
        for event in events:
            if type(event) is not Skipped:
                self._proofs += 1
                self._faults = self._unread = 0
                return events
            unread += len(event.data)
        if events:
            self._faults += 1
            self._unread += unread
            # What is left of a frame of which something is missing may come in many packets.
            if self._faults >= FAULTS_IN_A_ROW and (self._proofs < PROOFS or self._unread > MAX_FRAME):
                self.is_claimed = False
                self._faults = self._unread = self._proofs = 0
        return events


class ConnectionClaim(Claim):
    """What is known of a TCP connection. Once it is proven to be ours, it stays ours.

    Attributes:
        is_proven: Something showed it that is no chance.

    """

    __slots__ = (
        "_faulty",
        "_finder",
        "_has_ended",
        "_is_left",
        "_is_weak",
        "_sides",
        "_telling",
        "_waited",
        "is_proven",
    )

    def __init__(self, context: Context) -> None:
        """Makes the claim of a new connection.

        Args:
            context: Counts the bytes, and limits what is held back.

        """
        super().__init__(context)
        self.is_proven = False
        self._is_weak = False
        self._has_ended = 0  # how much must tell that the next claim is none by chance
        self._telling = 0
        self._faulty = 0
        self._is_left = False
        self._sides = dict.fromkeys(Direction, 0)  # strange packets at the beginning of each
        self._waited = dict.fromkeys(Direction, 0)  # bytes of each before the last packet that nothing was found in yet
        self._finder = Finder(context.schema)

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
        if any(map(_is_proof, events)):
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
        if not self.is_claimed or len(frames) < len(events) or not b"".join(frames).endswith(data):
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
        self._proofs = (self._proofs if self.is_claimed else 0) + 1 + telling
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
            self.is_claimed, self._has_ended = False, 1 if self._is_weak else 2
        elif not self.is_claimed and not self._has_ended and self._strange >= STRANGE_PACKETS:
            self._is_left = True

    def _count_strange(self, size: int) -> None:
        if size > HEADER_SIZE:
            self._strange += 1
        else:
            self._unread += size
            if self._unread > MAX_FRAME:
                self._strange = STRANGE_PACKETS

    def end(self) -> list[Event]:
        """Says that nothing more will come.

        Returns:
            What could not be read of a connection that was too short to tell.

        """
        return self._skipped(self._taken())

    def _give_up(self, _number: int) -> None:
        self._is_left = True
        super()._give_up(_number)

    def _skipped(self, events: list[Event]) -> list[Event]:
        """What could not be read, of what was held back; the rest is none of ours."""
        self._decline([event for event in events if not isinstance(event, Skipped)])
        return [event for event in events if isinstance(event, Skipped)]


def _size_of(event: Event) -> int:
    return _HELD_SIZE + len(event.frame if isinstance(event, Record) else event.data)
