"""Whether a TCP connection is ours, packet by packet: `tables.claims` has the rule.

Packets that are none of ours are passed over. What cannot be read in them is held back until something shows that the
connection is ours, as a capture may begin inside a frame. Where nothing does, the bytes count as other traffic.
"""

from __future__ import annotations

from ev3proto.capture.carriers.claims import Claim, is_proof
from ev3proto.capture.carriers.streams import Context, Stream
from ev3proto.capture.carriers.wifi.tcp import SEGMENT_SIZE, Segment
from ev3proto.capture.carriers.wifi.ways import may_come_from_brick, may_go_to_brick
from ev3proto.capture.finding import count_telling
from ev3proto.capture.record import Direction, Event, Record, Skipped
from ev3proto.capture.weighing import Accepts, Likeness, Weigher, Weight
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.tables.frame import MAX_FRAME

_HELD_SIZE = 700
"""Bytes of memory that something found takes while it is held back, besides its bytes, about."""

_ENDED = "what came after these bytes is none of ours"


class _Side:
    """One direction of a connection that is not proven to be ours."""

    __slots__ = ("accepts", "direction", "has_begun", "is_odd", "is_reply", "parts", "rest", "to_brick")

    def __init__(self, direction: Direction) -> None:
        self.direction = direction
        self.to_brick = direction is Direction.SENT
        self.accepts: Accepts = may_go_to_brick if self.to_brick else may_come_from_brick
        self.parts: list[Segment] = []  # of what may be a frame, while the connection is not ours
        self.has_begun = False  # something of the claim that stands was given
        self.rest = 0  # bytes that may be left of a frame of which some are missing in the capture
        self.is_odd = False  # there was a strange packet before any claim
        self.is_reply = False  # the packet before was nothing but replies

    @property
    def text(self) -> bytes:
        """What waits."""
        return b"".join(part.data for part in self.parts)

    def may_begin(self, text: bytes) -> bool:
        """Whether what may be the beginning of a frame is believed to be one."""
        return not self.rest and len(text) >= HEADER_SIZE


class ConnectionClaim(Claim):
    """What is known of a TCP connection, and until it is claimed what was found in it. Once proven, it stays ours."""

    __slots__ = ("_budget", "_held", "_size", "_ways", "_weigher")

    def __init__(self, context: Context) -> None:
        """Makes the claim of a new connection.

        Args:
            context: Counts the bytes, and limits what is held back.

        """
        super().__init__(context)
        self._budget = context.budget
        self._held: list[Event] = []
        self._size = 0
        self._ways = {direction: _Side(direction) for direction in Direction}
        self._weigher = Weigher(context.schema, takes_rest=True)

    def waiting(self, direction: Direction) -> int:
        """Bytes of memory that what waits in a direction takes, about."""
        return sum(SEGMENT_SIZE + len(part.data) for part in self._ways[direction].parts)

    def feed(self, stream: Stream, segment: Segment) -> list[Event]:
        """Takes the next bytes of a direction.

        Args:
            stream: The direction.
            segment: The bytes.

        Returns:
            What is known to be ours.

        """
        side = self._side(stream)
        if self.is_claimed:
            events = self._feed_parts(stream, side)
            if self.is_proven:
                return events + _fed(stream, [segment])
            return events + self._go_on(stream, side, segment)
        waited = stream.give_up(_ENDED) if stream.cutter.left else []
        return waited + self._feed_first(stream, side, segment)

    def leave_hole(self, stream: Stream, missing: int) -> list[Event]:
        """Says that bytes are missing in a direction.

        Args:
            stream: The direction.
            missing: How many, 0 where that is not known.

        Returns:
            What is known to be ours.

        """
        side = self._side(stream)
        before = self._feed_parts(stream, side) if self.is_claimed else self.end_side(stream)
        events = before + stream.leave_hole(missing)
        side.rest = MAX_FRAME
        if self.is_claimed:
            return events
        self._keep(events)
        return []

    def take(self, event: Event) -> list[Event]:
        """Takes what cannot be read.

        Args:
            event: Says why.

        Returns:
            The same, where the connection is ours.

        """
        if self.is_claimed:
            return [event]
        self._keep([event])
        return []

    def give_up(self, stream: Stream) -> list[Event]:
        """Says that too much waits: what waits in a direction does no longer.

        Args:
            stream: The direction.

        Returns:
            What is known to be ours.

        """
        if not self.is_claimed:
            return self.end_side(stream)
        return self._feed_parts(stream, self._side(stream)) + stream.give_up()

    def end_side(self, stream: Stream) -> list[Event]:
        """Says that nothing more will come in a direction.

        Args:
            stream: The direction.

        Returns:
            What is known to be ours.

        """
        side = self._side(stream)
        if self.is_claimed:
            return self._feed_parts(stream, side) + stream.end()
        parts, side.parts = side.parts, []
        events = _fed(stream, parts) + stream.end()
        if not any(count_telling(event.message) for event in events if isinstance(event, Record)):
            self._keep(events)
            return []
        self.is_claimed = True
        return [*self._taken(), *events]

    def end(self) -> list[Event]:
        """Says that nothing more will come.

        Returns:
            What could not be read of a connection that was too short to tell.

        """
        return self._skipped(self._taken())

    def _side(self, stream: Stream) -> _Side:
        assert stream.route.direction is not None
        return self._ways[stream.route.direction]

    # Not claimed

    def _feed_first(self, stream: Stream, side: _Side, segment: Segment) -> list[Event]:
        """Takes the next bytes of a connection that is not claimed."""
        side.parts.append(segment)
        weight = self._weigh(stream, side, side.text)
        if weight.verdict is Likeness.NOTHING and len(side.parts) > 1:
            # What waited was no beginning.
            del side.parts[-1]
            self._decide(side, weight, len(side.text))
            self._decline_parts(stream, side)
            side.parts.append(segment)
            weight = self._weigh(stream, side, segment.data)
        if weight.verdict is Likeness.PART:
            if not segment.missing:
                return []
            weight = self._weigher.weigh_cut(side.text, segment.missing)
            stream.cutter.begin(in_step=True)
        if not self.is_proven:
            self._decide(side, weight, len(side.text))
        if self.is_claimed:
            return self._begin_giving(stream, side, weight)
        self._decline_parts(stream, side)
        return []

    def _begin_giving(self, stream: Stream, side: _Side, weight: Weight) -> list[Event]:
        """What was held back, and what waits, of a connection that just turned out to be ours."""
        held = self._taken()
        events = held if self.is_proven or weight.telling else self._skipped(held)
        side.has_begun = True
        stream.cutter.begin(in_step=weight.at == 0)
        parts, side.parts = side.parts, []
        events += _fed(stream, parts)
        self.is_proven = self.is_proven or any(map(is_proof, events))
        return events

    def _decline_parts(self, stream: Stream, side: _Side) -> None:
        """Passes over what is none of ours. Frames with faults are, where the connection turns out to be ours."""
        text = side.text
        parts, side.parts = side.parts, []
        if self._has_ended or self._is_left:
            self._decline(self._taken())
            self._account.other += len(text)
        else:
            events = _fed(stream, parts, is_ours=False) + stream.give_up("nothing shows that these bytes are a frame")
            is_full = self._weigher.hold_frames(text) is Likeness.OURS
            self._hold(events if is_full else self._skipped(events))

    # Claimed

    def _feed_parts(self, stream: Stream, side: _Side) -> list[Event]:
        """What waited while the other direction showed that the connection is ours."""
        parts, side.parts = side.parts, []
        if parts:
            side.has_begun = True
            stream.cutter.begin(in_step=False)
        return _fed(stream, parts)

    def _go_on(self, stream: Stream, side: _Side, segment: Segment) -> list[Event]:
        """Takes the next bytes of a connection that is claimed, and not proven to be ours."""
        text = stream.cutter.left + segment.data
        weight = self._weigh(stream, side, text)
        is_faulty = weight.verdict is Likeness.NOTHING and self._meet_faulty(side, text)
        if weight.verdict is Likeness.PART and segment.missing:
            weight = self._weigher.weigh_cut(text, segment.missing, is_claimed=True)
        is_rest = weight.verdict is Likeness.NOTHING and side.rest > 0
        side.rest = max(side.rest - len(segment.data), 0) if is_rest else side.rest
        if weight.verdict is not Likeness.PART and not is_faulty and not is_rest and not self.is_proven:
            self._decide(side, weight, len(segment.data))
        if not self.is_claimed:
            return self._leave(stream, side, segment)
        if not side.has_begun:
            side.has_begun = True
            is_open = is_faulty or weight.verdict is Likeness.PART
            is_whole = weight.verdict in (Likeness.OURS, Likeness.PERHAPS)
            stream.cutter.begin(in_step=weight.at == 0 and (is_whole or (is_open and side.may_begin(text))))
        events = _fed(stream, [segment])
        if segment.missing and not stream.cutter.is_in_step:
            side.rest = MAX_FRAME
        self.is_proven = self.is_proven or any(map(is_proof, events))
        return events

    def _leave(self, stream: Stream, side: _Side, segment: Segment) -> list[Event]:
        """What is still ours of a connection whose claim has ended with a packet."""
        for each in self._ways.values():
            each.has_begun = False
        events = stream.give_up(_ENDED)
        side.parts.append(segment)
        self._decline_parts(stream, side)
        return events

    # What is told

    def _weigh(self, stream: Stream, side: _Side, text: bytes) -> Weight:
        begins = stream.cutter.begins_with_text(text)
        if begins:
            self.is_claimed = self.is_proven = True
            return Weight(Likeness.OURS)
        if self._is_left and not self.is_claimed:
            return Weight(Likeness.NOTHING)
        if begins is None:
            return Weight(Likeness.PART)
        if side.to_brick:
            # The capture may have begun inside a frame.
            return self._weigher.weigh_anywhere(text, 0, side.accepts, is_claimed=self.is_claimed)
        return self._weigher.weigh(text, 0, side.accepts)

    def _meet_faulty(self, side: _Side, text: bytes) -> bool:
        """Counts a packet that frames with faults fill, or misdirected ones. False: it is none, or one too many."""
        held = self._weigher.hold_frames(text)
        return held is not Likeness.NOTHING and self._count_faulty(side.direction, is_whole=held is Likeness.OURS)

    def _decide(self, side: _Side, weight: Weight, size: int) -> None:
        """Decides after a packet of which so many bytes are new, by what it tells."""
        if weight.verdict is Likeness.NOTHING:
            if not self.is_claimed:
                side.is_odd, side.is_reply = side.is_odd or size > HEADER_SIZE, False
            self._meet_strange(side.direction, size)
            return
        side.rest = 0
        if not self._is_chance(side, weight):
            self._meet_ours(side.direction, weight.telling, is_command=side.to_brick)

    def _is_chance(self, side: _Side, weight: Weight) -> bool:
        """Whether there are only replies, before any claim and after strange packets, and not for the second time."""
        was_reply, is_first = side.is_reply, not self.is_claimed and not self._has_ended
        side.is_reply = is_first and weight.verdict is Likeness.PERHAPS and not side.to_brick
        return side.is_reply and not was_reply and side.is_odd

    # What is held back

    def _hold(self, events: list[Event]) -> None:
        if events:
            self._held += events
            self._size += sum(map(_size_of, events))
            self._budget.update(self, self._size, self._give_up)

    def _keep(self, events: list[Event]) -> None:
        """Holds back what cannot be read, or leaves it to others."""
        if self._has_ended or self._is_left:
            self._decline(events)
        else:
            self._hold(events)

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

    def _skipped(self, events: list[Event]) -> list[Event]:
        """What could not be read, of what was held back; the rest is none of ours."""
        self._decline([event for event in events if not isinstance(event, Skipped)])
        return [event for event in events if isinstance(event, Skipped)]


def _fed(stream: Stream, parts: list[Segment], *, is_ours: bool = True) -> list[Event]:
    """What is in parts of a direction. Frames that the capture has cut are shown only where it is known to be ours."""
    events: list[Event] = []
    for part in parts:
        events += stream.feed(part.data, part.number, part.time_ns)
        if part.missing:
            events += stream.cut_off(part.missing) if is_ours else stream.leave_hole(part.missing)
    return events


def _size_of(event: Event) -> int:
    return _HELD_SIZE + len(event.frame if isinstance(event, Record) else event.data)
