"""Claims of conversations with byte streams, packet by packet; the rule is in `tables.claims`."""

from __future__ import annotations

from ev3proto.capture.carriers.streams import Context, Piece, Stream
from ev3proto.capture.claims import Claim, is_complete_reply
from ev3proto.capture.finding import Accepts
from ev3proto.capture.framing import MARK_SIZE
from ev3proto.capture.record import Direction, Event, Record, Skipped
from ev3proto.schema.header import HEADER_SIZE, frame_size
from ev3proto.tables.claims import REPLIES
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
    joins        a command may begin anywhere in a packet, and is waited for; by default only at a packet's start
    has_texts    the unlock text claims it, too, and so do replies alone
    """

    __slots__ = (
        "_account",
        "_comes_back",
        "_finder",
        "_fresh",
        "_goes_out",
        "_has_texts",
        "_joins",
        "_replies",
        "_schema",
        "_streams",
        "_waiting",
        "to_brick",
    )

    def __init__(
        self,
        context: Context,
        goes_out: Accepts,
        comes_back: Accepts,
        *,
        is_sure: bool = False,
        joins: bool = False,
        has_texts: bool = False,
    ) -> None:
        super().__init__(is_sure=is_sure)
        self._account = context.account
        self._schema = context.schema
        self._finder = context.finder
        self._goes_out = goes_out
        self._comes_back = comes_back
        self._joins = joins
        self._has_texts = has_texts
        self.to_brick: Direction | None = Direction.SENT if has_texts else None
        self._replies = 0
        self._streams: dict[Direction, Stream] = {}
        self._fresh: set[Direction] = set()  # not read since the claim began
        self._waiting: dict[Direction, list[Piece]] = {}

    def waiting(self, direction: Direction) -> int:
        """Returns the approximate memory of the pending bytes of a direction."""
        return sum(MARK_SIZE + len(piece.data) for piece in self._waiting.get(direction, ()))

    def feed(self, stream: Stream, piece: Piece) -> list[Event]:
        """Takes the next bytes of a direction. Returns the events of those that are claimed."""
        side = _side(stream)
        self._streams[side] = stream
        if not self.is_claimed:
            return self._search(stream, side, piece)
        if side in self._fresh:
            self._fresh.remove(side)
            stream.cutter.accepts = accepts = self._goes_out if side is self.to_brick else self._comes_back
            code = piece.data[HEADER_SIZE - 1 : HEADER_SIZE]
            may_start = self._finder.may_start(piece.data, 0)
            may_go = may_start and (not self._has_texts or not code or accepts(MessageType(code[0])))
            stream.cutter.begin(in_step=may_go)
        return self._counted(stream, stream.feed(piece))

    def _counted(self, stream: Stream, events: list[Event]) -> list[Event]:
        """Counts the events of a packet. If that ends the claim, adds those of the pending bytes."""
        unread, is_good = stream.cutter.passed, False
        if self.is_sure or not (events or unread):
            return events
        for event in events:
            if isinstance(event, Record):
                is_good = self.is_ours(event) or is_good
            elif isinstance(event, Skipped):
                unread += len(event.data)
            else:
                self.begin(is_sure=True)
                return events
        self.count(is_good=is_good, unread=unread)
        if self.is_claimed:
            return events
        self._joins = True
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
        return stream.give_up() if self.is_claimed else []

    def end_side(self, stream: Stream) -> list[Event]:
        """Ends a direction."""
        pieces = self._waiting.get(_side(stream), [])
        if not self.is_claimed and b"".join(piece.data for piece in pieces).startswith(_REQUEST):
            # A cut unlock text: only bricks are unlocked in this way.
            return self._begun(stream, _side(stream), pieces, 0, is_sure=True) + stream.end()
        self._forget(_side(stream))
        return stream.end() if self.is_claimed else []

    def _forget(self, side: Direction) -> None:
        self._account.other += sum(len(piece.data) for piece in self._waiting.pop(side, ()))

    # Not claimed

    def _search(self, stream: Stream, side: Direction, piece: Piece) -> list[Event]:
        """Searches for a reason to claim the conversation."""
        pieces = [*self._waiting.pop(side, ()), piece]
        text = b"".join(each.data for each in pieces)
        if self._has_texts:
            begins = stream.cutter.begins_with_text(text)
            if begins:
                return self._begun(stream, side, pieces, 0, is_sure=True)
            if begins is None and not piece.missing:
                self._waiting[side] = pieces
                return []
        if self._has_texts and side is not self.to_brick:
            return self._count_replies(stream, side, piece)
        place, is_whole = self._finder.first_command(text, _starts(pieces), self._goes_out, piece.missing)
        if is_whole:
            self.to_brick = side
            return self._begun(stream, side, pieces, place)
        if piece.missing or not (self._joins or place in _starts(pieces)):
            # A packet is left to others at once, unless a command may begin with it.
            place = len(text)
        self._account.other += place
        if place < len(text):
            self._waiting[side] = _after(pieces, place)
        return []

    def _count_replies(self, stream: Stream, side: Direction, piece: Piece) -> list[Event]:
        data, at = piece.data, 0
        while len(data) - at >= HEADER_SIZE:
            end = at + frame_size(data, at)
            if end > len(data) or not is_complete_reply(self._schema.read_frame(data[at:end], strict=False)):
                break
            self._replies += 1
            at = end
        if at < len(data):
            self._replies = 0
        if self._replies >= REPLIES:
            return self._begun(stream, side, [piece], 0)
        self._account.other += len(data)
        return []

    def _begun(
        self, stream: Stream, side: Direction, pieces: list[Piece], place: int, *, is_sure: bool = False
    ) -> list[Event]:
        """Begins a claim at an offset in some pieces. Returns the events from there on."""
        self.begin(is_sure=is_sure)
        self._replies = 0
        self._waiting.pop(side, None)
        for other in tuple(self._waiting):
            self._forget(other)
        self._fresh = set(Direction) - {side}
        self._account.other += place
        stream.cutter.accepts = self._goes_out if side is self.to_brick else self._comes_back
        stream.cutter.begin(in_step=True)
        return self._counted(stream, [event for piece in _after(pieces, place) for event in stream.feed(piece)])


def _side(stream: Stream) -> Direction:
    assert stream.route.direction is not None
    return stream.route.direction


def _starts(pieces: list[Piece]) -> set[int]:
    """Returns the offsets at which pieces begin."""
    at, starts = 0, set()
    for piece in pieces:
        starts.add(at)
        at += len(piece.data)
    return starts


def _after(pieces: list[Piece], place: int) -> list[Piece]:
    """Returns the pieces from an offset in their bytes on."""
    left: list[Piece] = []
    for piece in pieces:
        if place < len(piece.data):
            left.append(piece._replace(data=piece.data[place:]) if place else piece)
        place = max(place - len(piece.data), 0)
    return left
