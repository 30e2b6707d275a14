"""One connection to a brick, shared by any number of threads: a session on a carrier, and a thread that reads."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable
from concurrent.futures import Future
from concurrent.futures import TimeoutError as FutureTimeoutError

from ev3proto.bounded import Bounded
from ev3proto.errors import counted
from ev3proto.link.carriers.wire import Wire
from ev3proto.link.commands import Prepared, Result
from ev3proto.link.errors import ConnectionLostError, LinkError, NoAnswerError
from ev3proto.link.session import Answered, Event, Oddity, Request, Session, Stray
from ev3proto.schema.frame import parse
from ev3proto.schema.frame_buffer import OutOfStep
from ev3proto.schema.header import HEADER_SIZE, Header
from ev3proto.semantics.advice import advice
from ev3proto.semantics.identify import foreign
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.declaration import Effect
from ev3proto.tables.frame import MessageType

TURN = 0.1
"""Seconds after which the reading thread checks whether the connection was closed, if nothing can unblock it."""

MOST_UNFETCHED = 8192
"""Maximum number of replies that are kept until they are fetched by their counter."""

MOST_UNASKED = 256
"""Maximum number of frames that the brick has sent unasked, kept until they are taken."""

_MOST_SHOWN = 24
_JOIN = 5.0


def known_timeout(seconds: float | None) -> float | None:
    """Returns seconds to wait, limited to Python's maximum; None waits forever. Raises ValueError."""
    if seconds is None:
        return None
    if not isinstance(seconds, int | float) or not seconds >= 0:
        raise ValueError(f"timeout must be seconds, 0 or more, or None, not {seconds!r}")
    return min(seconds, threading.TIMEOUT_MAX)


class Ticket:
    """A pending command and the future of its reply."""

    __slots__ = ("prepared", "reply", "request")

    def __init__(self, prepared: Prepared | None, request: Request) -> None:
        self.prepared = prepared  # the command as prepared; None if a whole frame was given
        self.request = request  # the command that it became
        self.reply: Future[bytes] = Future()  # the future frame of its reply; done at once if it wants none

    def result(self, reply: bytes) -> Result:
        """Returns the program's result for a reply; the reply itself for a whole frame. Raises LinkError."""
        return reply if self.prepared is None else self.prepared.result(self.request.frame, reply)


class Channel:
    """A connection to a brick."""

    def __init__(self, wire: Wire) -> None:
        """Takes over a connected carrier, and begins to read from it."""
        self.carrier: Carrier = wire.carrier  # what carries it
        self.label = wire.label  # which brick, as messages call it
        self._wire = wire
        self._session = Session()
        self._tickets: Bounded[int, Ticket] = Bounded(MOST_UNFETCHED)
        self._by_request: dict[int, Ticket] = {}
        self._sending = threading.Lock()
        self._state = threading.Lock()
        self._is_closing = False
        self._lost: ConnectionLostError | None = None
        self._odd: Event | None = None
        self._unasked: deque[bytes] = deque(maxlen=MOST_UNASKED)
        self._reader = threading.Thread(target=self._read, name=f"reads from {self.label}", daemon=True)
        self._reader.start()

    def send(self, prepared: Prepared, before: Callable[[bytes], None] | None = None) -> Ticket:
        """Sends a command with a new counter. Raises BuildError and ConnectionLostError.

        `before` is called with the frame just before it is sent, in the order of sending.
        """
        return self._send(prepared, lambda: self._session.command(prepared.kind, prepared.body), before)

    def send_frame(self, frame: bytes) -> Ticket:
        """Sends a frame as it is, counter included. Raises LinkError if a command with that counter is waiting."""
        return self._send(None, lambda: self._session.adopt(frame), None)

    def send_again(self, frame: bytes) -> Ticket:
        """Sends a frame of a known type with a new counter. Raises ConnectionLostError."""
        kind = MessageType(Header.read(frame).type)
        return self._send(None, lambda: self._session.command(kind, frame[HEADER_SIZE:]), None)

    def _send(
        self, prepared: Prepared | None, make: Callable[[], Request], before: Callable[[bytes], None] | None
    ) -> Ticket:
        with self._sending:
            with self._state:
                if self._lost is not None:
                    raise ConnectionLostError(str(self._lost))
                request = make()
                ticket = Ticket(prepared, request)
                if request.wants_reply:
                    self._by_request[id(request)] = ticket
                    self._tickets.add(request.counter, ticket)
                else:
                    ticket.reply.set_result(b"")
            if before is not None:
                before(request.frame)
            try:
                self._wire.send(request.frame)
            except ConnectionLostError as error:
                self._end(error)
                raise
        return ticket

    def ticket(self, counter: int) -> Ticket:
        """Returns the command with a counter, if its reply was not fetched yet. Raises LinkError."""
        with self._state:
            found = self._tickets.get(counter)
        if found is None:
            raise LinkError(
                f"no command with the counter {counter} waits for its reply: it wanted none, or its reply was fetched"
            )
        return found

    def wait(self, ticket: Ticket, timeout: float | None, *, keep: bool = False) -> bytes:
        """Returns the reply to a command. Raises NoAnswerError and ConnectionLostError.

        With `keep`, a command without a reply in time can be waited for again.
        """
        try:
            frame = ticket.reply.result(timeout)
        except FutureTimeoutError:
            raise self.give_up(ticket, timeout or 0.0, keep=keep) from None
        self.fetched(ticket)
        return frame

    def give_up(self, ticket: Ticket, timeout: float, *, keep: bool = False) -> NoAnswerError:
        """Returns the error of a reply that did not come in time, and abandons it unless it is kept."""
        with self._state:
            if not keep:
                self._session.abandon(ticket.request)
                self._by_request.pop(id(ticket.request), None)
                self._forget(ticket)
            odd, pending = self._odd, self._session.pending
        sentence = (
            f"no answer from {self.label} to the command with the counter {ticket.request.counter} within {timeout:g} s"
            f"; {self._reason(ticket.request.frame)}"
        )
        if odd is not None:
            sentence += f" The last bytes received were {_told(odd, pending)}"
        return NoAnswerError(sentence)

    def _reason(self, frame: bytes) -> str:
        """Returns why a command may have no answer. Only the wire of a virtual brick knows."""
        waits_for: str = getattr(self._wire, "waits_for", "")
        if waits_for:
            return waits_for
        for operation in getattr(parse(frame, strict=False), "operations", ()):
            if Effect.AWAITS_MOVE in operation.declaration.effects:
                return (
                    f"{operation.name} waits until the moves of motors have ended: are the motors plugged in, and free"
                    " to turn?"
                )
        return "is it busy with a waiting command, switched off, or out of reach?"

    def fetched(self, ticket: Ticket) -> None:
        """Marks a reply as delivered."""
        with self._state:
            self._forget(ticket)

    def take_unasked(self) -> list[bytes]:
        """Returns the frames that the brick has sent unasked since the last call, oldest first."""
        with self._state:
            found = list(self._unasked)
            self._unasked.clear()
        return found

    @property
    def is_open(self) -> bool:
        """Whether the connection is open, as far as is known."""
        return self._lost is None

    def close(self) -> None:
        """Ends the connection; pending waits for a reply raise ConnectionLostError. A second call does nothing."""
        self._end(ConnectionLostError(f"the connection to {self.label} was closed"))
        self._is_closing = True
        self._wire.stop()
        if threading.current_thread() is not self._reader:
            self._reader.join(_JOIN)
        self._wire.close()

    def _forget(self, ticket: Ticket) -> None:
        if self._tickets.get(ticket.request.counter) is ticket:
            del self._tickets[ticket.request.counter]

    def _read(self) -> None:
        while not self._is_closing:
            try:
                data = self._wire.receive(TURN)
            except ConnectionLostError as error:
                self._end(error)
                return
            if data:
                self._take(data)

    def _take(self, data: bytes) -> None:
        done = []
        with self._state:
            for event in self._session.feed(data):
                if isinstance(event, Answered):
                    done.append((self._by_request.pop(id(event.request)), event.frame))
                else:
                    self._odd = event
                    if isinstance(event, Stray) and event.oddity is Oddity.UNASKED:
                        self._unasked.append(event.frame)
        for ticket, frame in done:
            ticket.reply.set_result(frame)

    def _end(self, error: ConnectionLostError) -> None:
        with self._state:
            if self._lost is not None:
                return
            missing = self._session.missing
            if missing:
                came = len(self._session.pending)
                error = ConnectionLostError(
                    f"{error}. It ended within a reply: {counted(came, 'byte')} arrived, {missing} are missing"
                )
            self._lost = error
            waiting = list(self._by_request.values())
            self._by_request.clear()
        for ticket in waiting:
            ticket.reply.set_exception(ConnectionLostError(str(error)))


def _told(event: Event, pending: bytes) -> str:
    if isinstance(event, OutOfStep):
        shown, what, named = event.data, "not a frame", advice(foreign(event.data + pending))
    else:
        assert not isinstance(event, Answered)
        shown, what, named = event.frame, f"a frame that {event.oddity.value}", advice(foreign(event.frame))
    dots = "..." if len(shown) > _MOST_SHOWN else ""
    return f"{what}{f' ({named})' if named else ''}, {shown[:_MOST_SHOWN].hex(':').upper()}{dots}"
