"""A session with a brick, without I/O: counters in use, pairing of replies with commands, abandoned commands.

The caller sends the frames that `command` returns and feeds what arrives. The session has no clock: the
caller decides when to abandon a command. At most one command waits for each counter, so a reply's is certain.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from ev3proto.bounded import Bounded
from ev3proto.link.errors import LinkError
from ev3proto.link.reply_stream import ReplyStream
from ev3proto.schema.frame_buffer import OutOfStep
from ev3proto.schema.header import Header, build_frame
from ev3proto.semantics.pairing import pairing_key
from ev3proto.tables.frame import ASKING_TYPES, COUNTERS, MessageType

FIRST_COUNTER = 42
"""The counter of the first command, as in the lessons."""

MOST_ABANDONED = 1024
"""Maximum number of abandoned commands whose counters are not reused yet, in case their replies come after all."""


@dataclass(eq=False, slots=True)
class Request:
    """A command that was sent."""

    counter: int  # its message counter
    frame: bytes
    wants_reply: bool  # whether the brick should answer it


class Oddity(Enum):
    """The kinds of unexpected frames. The value completes "a frame that ..."."""

    LATE = "answers a command that was given up on"
    FOREIGN = "answers no waiting command"
    UNASKED = "is not a reply: the brick sent it unasked"


@dataclass(frozen=True, slots=True)
class Answered:
    """A reply to a command that waited for it."""

    request: Request
    frame: bytes


@dataclass(frozen=True, slots=True)
class Stray:
    """An unexpected frame."""

    oddity: Oddity
    frame: bytes


Event = Answered | Stray | OutOfStep
"""The events of a session."""


class Session:
    """Commands to one brick and the replies to them."""

    def __init__(self, first_counter: int = FIRST_COUNTER) -> None:
        """Starts a session without commands."""
        self._next = first_counter
        self._waiting: dict[int, Request] = {}
        self._abandoned: Bounded[int, Request] = Bounded(MOST_ABANDONED)
        self._stream = ReplyStream(self._waiting.__contains__)

    @property
    def outstanding(self) -> list[Request]:
        """The commands that wait for their reply, oldest first."""
        return list(self._waiting.values())

    @property
    def pending(self) -> bytes:
        """The bytes of an incomplete frame."""
        return self._stream.pending

    @property
    def missing(self) -> int:
        """Missing bytes of the incomplete frame."""
        return self._stream.missing

    def command(self, kind: MessageType, body: bytes) -> Request:
        """Makes a command with a free counter, which waits if it wants a reply. Raises BuildError and LinkError."""
        counter = self._free_counter()
        frame = build_frame(kind, counter, body)
        request = Request(counter, frame, kind.wants_reply)
        self._next = counter + 1
        if request.wants_reply:
            self._wait_for(request)
        return request

    def adopt(self, frame: bytes) -> Request:
        """Takes a command with its counter. Raises LinkError if a command with that counter is waiting."""
        _, counter, code = Header.read(frame)
        request = Request(counter, frame, code in ASKING_TYPES)
        if request.wants_reply:
            if counter in self._waiting:
                raise LinkError(f"a command with the counter {counter} waits for its reply: give this one another")
            self._wait_for(request)
        return request

    def _wait_for(self, request: Request) -> None:
        self._abandoned.pop(request.counter, None)
        self._waiting[request.counter] = request

    def abandon(self, request: Request) -> None:
        """Abandons a command that waits for a reply. Its counter is not used again for as long as possible."""
        if self._waiting.get(request.counter) is request:
            del self._waiting[request.counter]
            self._abandoned.add(request.counter, request)

    def feed(self, data: bytes) -> list[Event]:
        """Takes bytes from the brick, in any chunks. Returns the events, in order."""
        return [part if isinstance(part, OutOfStep) else self._taken(part) for part in self._stream.feed(data)]

    def _taken(self, frame: bytes) -> Answered | Stray:
        _, counter, code = Header.read(frame)
        if MessageType(code).is_command:
            return Stray(Oddity.UNASKED, frame)
        for commands, oddity in ((self._waiting, None), (self._abandoned, Oddity.LATE)):
            request = commands.get(counter)
            if request is not None and pairing_key(request.frame)[0] == pairing_key(frame)[0]:
                del commands[counter]
                return Answered(request, frame) if oddity is None else Stray(oddity, frame)
        return Stray(Oddity.FOREIGN, frame)

    def _free_counter(self) -> int:
        for step in range(COUNTERS):
            counter = (self._next + step) % COUNTERS
            if counter not in self._waiting and counter not in self._abandoned:
                return counter
        if self._abandoned:
            counter = next(iter(self._abandoned))
            del self._abandoned[counter]
            return counter
        raise LinkError(f"{COUNTERS} commands wait for their reply: no counter is left for another one")
