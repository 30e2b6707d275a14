"""Whether a connection is ours, by what is said in it: `tables.claims` has the rule.

What is found in a connection is held back until something in it shows that the connection is ours. Then all of that is
given, as a capture may begin inside a frame. Where nothing does, the bytes count as other traffic.
"""

from __future__ import annotations

from collections.abc import Callable

from ev3proto.capture.carriers.streams import Context
from ev3proto.capture.finding import makes_sense
from ev3proto.capture.record import Announcement, Direction, Event, Record, Skipped
from ev3proto.messages import DirectCommand
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.tables.claims import FAULTS_IN_A_ROW, PROOFS, STRANGE_PACKETS, may_be_of_nxt
from ev3proto.tables.frame import MAX_FRAME

MOST_HELD = 4096
"""Frames without a fault that are held back of a serial port on which there was no command so far."""

_HELD_SIZE = 700
"""Bytes of memory that something found takes while it is held back, besides its bytes, about."""


def begins_a_connection(event: Event, data: bytes) -> bool:
    """Says whether something shows that a TCP connection is a brick's.

    Args:
        event: What was found.
        data: What the last packet of it carried.

    Returns:
        True for the two texts, and for flawless frames that go the right way. One that may have any bytes must end
        with a packet, or answer a command: such bytes are found in everything.

    """
    if not isinstance(event, Record):
        return isinstance(event, Announcement)
    message = event.message
    if message.fault is not None:
        return False
    is_from_host = event.direction is Direction.SENT
    assert message.type is not None
    if message.type.carries != "daisy" and message.type.is_command != is_from_host:
        return False
    frame = event.frame
    is_at_edge = data.endswith(frame) or frame.endswith(data)
    return is_at_edge or event.request is not None or (isinstance(message, DirectCommand) and makes_sense(message))


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
        is_left: Nothing of ours was in its first packets: it is left alone.

    """

    __slots__ = (
        "_account",
        "_begins",
        "_budget",
        "_faults",
        "_held",
        "_is_patient",
        "_proofs",
        "_size",
        "_strange",
        "_unread",
        "is_claimed",
        "is_left",
    )

    def __init__(self, context: Context, begins: Callable[[Event, bytes], bool], *, is_patient: bool) -> None:
        """Makes the claim of a new connection.

        Args:
            context: Counts the bytes, and limits what is held back.
            begins: Says whether something shows that the connection is ours.
            is_patient: It may become ours at any time, and cease to be; what was before is not given.

        """
        self._account = context.account
        self._budget = context.budget
        self._begins = begins
        self._is_patient = is_patient
        self.is_claimed = False
        self._held: list[Event] = []
        self._size = 0
        self._strange = 0
        self._faults = 0
        self._unread = 0
        self._proofs = 0
        self.is_left = False

    def take(self, events: list[Event], data: bytes) -> list[Event]:
        """Takes what was found.

        Args:
            events: What is complete with a packet.
            data: What the packet carried; nothing where it is not a packet that completes them.

        Returns:
            What is known to be ours.

        """
        if self.is_claimed:
            return self._count_faults(events) if self._is_patient else events
        if not self.is_left and any(self._begins(event, data) for event in events):
            self.is_claimed = True
            self._unread = 0
            return [*self._taken(), *events]
        if self._is_patient:
            self._hold_flawless(events)
            return []
        if self.is_left:
            self._decline(events)
            return []
        self._hold(events)
        if data and events:
            self._count_strange(len(data))
        return []

    def _count_strange(self, size: int) -> None:
        if size > HEADER_SIZE:
            self._strange += 1
        else:
            self._unread += size
        if self._strange >= STRANGE_PACKETS or self._unread > MAX_FRAME:
            self.is_left = True
            self.end()

    def end(self) -> list[Event]:
        """Says that nothing more will come.

        Returns:
            What could not be read of a connection that was too short to tell, or frames without a fault where there was
            nothing else.

        """
        held = self._taken()
        if self._is_patient:
            return held
        if self.is_left:
            self._decline(held)
            return []
        self._decline([event for event in held if not isinstance(event, Skipped)])
        return [event for event in held if isinstance(event, Skipped)]

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
        self.is_left = not self._is_patient
        self.meet_stranger()

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

    def _decline(self, events: list[Event]) -> None:
        account = self._account
        for event in events:
            if isinstance(event, Skipped):
                account.skipped -= len(event.data)
                account.other += len(event.data)
            elif isinstance(event, Record):
                account.frames -= len(event.frame)
                account.other += len(event.frame)


def _size_of(event: Event) -> int:
    return _HELD_SIZE + len(event.frame if isinstance(event, Record) else event.data)
