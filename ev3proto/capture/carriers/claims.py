"""Claims of conversations that are byte streams: the pending bytes, and how a claim hands them to its streams."""

from __future__ import annotations

from collections.abc import Callable
from itertools import accumulate

from ev3proto.capture.carriers.streams import Context, Piece, Stream
from ev3proto.capture.claims import Claim, State
from ev3proto.capture.finding import Accepts, Found
from ev3proto.capture.framing import MARK_SIZE
from ev3proto.capture.record import Direction, Event, Record, Skipped
from ev3proto.schema.header import HEADER_SIZE, may_start
from ev3proto.tables.discovery import UNLOCK_REQUEST
from ev3proto.tables.frame import MessageType

_REQUEST = UNLOCK_REQUEST.encode()
_ENDED = "what follows these bytes is not this protocol"


class StreamClaim(Claim):
    """The claim of a conversation with a stream in each direction.

    context      reads frames and counts bytes
    goes_out     tells which message types go to the brick
    comes_back   tells which come from it
    is_sure      the conversation is claimed whatever its bytes are
    has_texts    as over TCP: the direction is known, the unlock text claims it, too, and so do replies alone
    place        where packets are that are not claimed, as they were counted in the account
    """

    def __init__(
        self,
        context: Context,
        goes_out: Accepts,
        comes_back: Accepts,
        *,
        is_sure: bool = False,
        has_texts: bool = False,
        place: str,
    ) -> None:
        super().__init__(
            context.schema,
            lambda member: member.is_command and member.carries != "daisy",
            Direction.SENT if has_texts else None,
            is_sure=is_sure,
        )
        if is_sure:
            self.to_brick = Direction.SENT
        self._account = context.account
        self.place = place
        self._goes_out = goes_out
        self._comes_back = comes_back
        self._has_texts = has_texts
        self._streams: dict[Direction, Stream] = {}
        self._fresh: set[Direction] = set()  # not read since the claim began
        self._waiting: dict[Direction, list[Piece]] = {}

    def waiting(self, direction: Direction) -> int:
        """Returns the approximate memory of the pending bytes of a direction."""
        held = [frame for each in self.held if each.side is direction for frame in each.frames]
        pending = [*held, *(piece.data for piece in self._waiting.get(direction, ()))]
        return sum(MARK_SIZE + len(data) for data in pending)

    def feed(self, stream: Stream, piece: Piece) -> list[Event]:
        """Takes the next bytes of a direction and returns the events of those that are claimed."""
        side = _side(stream)
        self._streams[side] = stream
        if not self.is_claimed:
            return self._search(stream, side, piece)
        if side in self._fresh:
            self._fresh.remove(side)
            stream.cutter.accepts = accepts = self._goes_out if side is self.to_brick else self._comes_back
            code = piece.data[HEADER_SIZE - 1 : HEADER_SIZE]
            may_go = may_start(piece.data) and (not self._has_texts or not code or accepts(MessageType(code[0])))
            stream.cutter.begin(in_step=may_go)
        answered = [event for other in self._streams.values() if other is not stream for event in other.answered()]
        return answered + self._counted(stream, stream.feed(piece))

    def _counted(self, stream: Stream, events: list[Event]) -> list[Event]:
        """Counts the events of a packet, and adds those of the pending bytes if that ends the claim."""
        if self.state is State.SURE:
            return events
        records, unread = [], stream.cutter.passed
        for event in events:
            if isinstance(event, Record):
                records.append(event)
            elif isinstance(event, Skipped):
                unread += len(event.data)
            else:
                self.begin(State.SURE)  # one of the texts
                return events
        self.count(records, unread)
        if self.is_claimed:
            return events
        return events + [event for each in self._streams.values() for event in each.give_up(_ENDED)]

    def leave_hole(self, stream: Stream, missing: int) -> list[Event]:
        """Reports missing bytes in a direction; 0 if their number is unknown."""
        if self.is_claimed:
            return stream.leave_hole(missing)
        self._forget(_side(stream))
        return []

    def take(self, event: Skipped) -> list[Event]:
        """Returns the event of unreadable bytes if the conversation is claimed; else leaves the bytes to others."""
        if self.is_claimed:
            return [event]
        self._account.skipped -= len(event.data)
        self._account.other += len(event.data)
        return []

    def give_up(self, stream: Stream) -> list[Event]:
        """Gives up the pending bytes of a direction, at the memory limit."""
        self._forget(_side(stream))
        self.held.clear()
        return stream.give_up() if self.is_claimed else []

    def end_side(self, stream: Stream) -> list[Event]:
        """Ends a direction."""
        pieces = self._waiting.get(_side(stream), [])
        if not self.is_claimed and b"".join(piece.data for piece in pieces).startswith(_REQUEST):
            # A cut unlock text: only bricks are unlocked in this way.
            self.begin(State.SURE)
            return self._begun(stream, pieces, 0) + stream.end()
        self._forget(_side(stream))
        return stream.end() if self.is_claimed else []

    def _forget(self, side: Direction) -> None:
        self._account.other += sum(len(piece.data) for piece in self._waiting.pop(side, ()))

    # Not claimed

    def _search(self, stream: Stream, side: Direction, piece: Piece) -> list[Event]:
        """Searches for a reason to claim the conversation."""
        pieces = [*self._waiting.pop(side, ()), piece]
        text = b"".join(each.data for each in pieces)
        starts = [0, *accumulate(len(each.data) for each in pieces[:-1])]
        if self._has_texts:
            begins = stream.cutter.begins_with_text(text)
            if begins:
                self.begin(State.SURE)
                return self._begun(stream, pieces, 0)
            if begins is None and not piece.missing:
                self._waiting[side] = pieces
                return []

        def adopt(place: int) -> Callable[[], list[Event]]:
            return lambda: self._adopted(stream, _after(pieces, place))

        found, place, earlier = self.judge(side, text, adopt, starts, piece.missing)
        if found is Found.CHAIN:
            return earlier + self._begun(stream, pieces, place, is_proved=bool(earlier))
        if found is not Found.OPEN or piece.missing:
            place = len(text)
        self._account.other += place
        if place < len(text):
            self._waiting[side] = _after(pieces, place)
        return []

    def _adopted(self, stream: Stream, pieces: list[Piece]) -> list[Event]:
        """Returns the events of commands that a reply has proved."""
        self._account.other -= sum(len(piece.data) for piece in pieces)
        self._account.count_strange(self.place, -len(pieces))
        return self._started(stream, pieces)

    def _begun(self, stream: Stream, pieces: list[Piece], place: int, *, is_proved: bool = False) -> list[Event]:
        """Returns the events of a claim that begins at an offset in some pieces; a reply may have proved commands."""
        side, events = _side(stream), []
        self._waiting.pop(side, None)
        self._fresh = set() if is_proved else set(Direction) - {side}
        for other in tuple(self._waiting):
            if is_proved:
                events += [event for piece in self._waiting.pop(other) for event in self._streams[other].feed(piece)]
            self._forget(other)
        self._account.other += place
        left = _after(pieces, place)
        self._account.count_strange(self.place, 1 - len(left))
        return events + self._counted(stream, self._started(stream, left))

    def _started(self, stream: Stream, pieces: list[Piece]) -> list[Event]:
        stream.cutter.accepts = self._goes_out if _side(stream) is self.to_brick else self._comes_back
        stream.cutter.begin(in_step=True)
        return [event for piece in pieces for event in stream.feed(piece)]


def _side(stream: Stream) -> Direction:
    assert stream.route.direction is not None
    return stream.route.direction


def _after(pieces: list[Piece], place: int) -> list[Piece]:
    left: list[Piece] = []
    for piece in pieces:
        if place < len(piece.data):
            left.append(piece._replace(data=piece.data[place:]) if place else piece)
        place = max(place - len(piece.data), 0)
    return left
