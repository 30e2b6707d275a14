"""How a proxy passes commands on: all of them at once, or only those that read, one of each client in turn."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Protocol

from ev3proto.brick.servers.host import Line
from ev3proto.capture.record import Record
from ev3proto.link.harm import Harm
from ev3proto.link.policy import PATIENCE, Outcome, Policy, Talk
from ev3proto.link.records import Records
from ev3proto.link.refusals import refused
from ev3proto.link.reply_stream import ReplyStream
from ev3proto.link.session import Answered, Oddity, Request, Session, Stray
from ev3proto.link.transfers import Ending, OpenTransfers, next_of
from ev3proto.messages import Message, SystemCommand
from ev3proto.schema.frame import parse
from ev3proto.schema.frame_buffer import OutOfStep
from ev3proto.semantics.advice import advice
from ev3proto.semantics.identify import foreign
from ev3proto.semantics.pairing import Pairing, pairing_key
from ev3proto.semantics.transfers import step_of
from ev3proto.stream import Decoder
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.frame import MAX_FRAME
from ev3proto.tables.system import SystemStatus

_MOST_WAITING = 1024

_NANOSECONDS = 1_000_000_000


@dataclass(eq=False, slots=True)
class Sent:
    """A command of a client."""

    client: Client  # its sender
    message: Message
    command: Record  # as it is shown
    frame: bytes  # as it was sent


class Owner(Protocol):
    """The proxy, as its relay sees it."""

    clients: list[Client]  # those that are served
    records: Records

    @property
    def carrier(self) -> Carrier:
        """What carries frames to the brick."""

    def send(self, frame: bytes) -> None:
        """Sends a frame to the brick. Raises ConnectionLostError."""

    def answer(self, sent: Sent | None, client: Client, frame: bytes, note: str | None = None) -> None:
        """Sends a reply to a client, shows and records it, with a note on the pairing."""

    def unanswered(self, sent: Sent) -> None:
        """Shows a command that has no reply."""

    def say_once(self, sentence: str) -> None:
        """Reports a message to the user of the proxy."""

    def renew(self) -> None:
        """Makes the connection to the brick anew, and calls `renewed` of the relay. Raises ConnectionLostError."""

    def later(self, seconds: float, call: Callable[[], None]) -> Callable[[], None]:
        """Calls a function after a time. Returns a function that cancels it."""

    def now(self) -> float:
        """Returns the time in seconds."""


class Client:
    """A client that is served."""

    def __init__(self, line: Line, name: str, decoder: Decoder, heard: float) -> None:
        self.line = line  # its connection
        self.name = name  # its address and port
        self.decoder = decoder  # what it sent
        self.heard = heard  # when its newest whole frame, or the first byte of another one, came, or was answered
        self.transfers = OpenTransfers()  # for `Passing`
        self.policy = Policy()  # for `Guard`
        self.waiting: deque[Sent] = deque()  # its commands that `Guard` has not done yet, oldest first
        self._reasons: set[str] = set()

    def hold(self, reason: str, is_held: bool) -> None:
        """Reads from the client only while there is no reason against it."""
        (self._reasons.add if is_held else self._reasons.discard)(reason)
        (self.line.pause if self._reasons else self.line.resume)()


class Passing:
    """Passes everything on at once, unchanged, counters included."""

    def __init__(self, owner: Owner) -> None:
        self._owner = owner
        self._pairing: Pairing[Sent] = Pairing(_MOST_WAITING, give_up=self._give_up)
        self._stream = ReplyStream(lambda _counter: True)
        self._nobody = Client(None, "the proxy", Decoder(), 0.0)  # type: ignore[arg-type]
        self._endings: deque[Ending] = deque()  # of the transfers that clients have left open
        self._ended: SystemCommand | None = None  # the command under way for the first of them

    @property
    def is_idle(self) -> bool:
        """Whether nothing has to be done before the end."""
        return not self._endings

    def forward(self, sent: Sent) -> None:
        """Sends a command of the client to the brick."""
        owner = self._owner
        if not sent.message.wants_reply:
            owner.unanswered(sent)
        if len(sent.frame) > MAX_FRAME and owner.carrier is Carrier.USB:
            owner.say_once(
                f"a frame of {len(sent.frame)} bytes was not sent: on USB a frame has at most {MAX_FRAME} bytes; send"
                " the file in pieces"
            )
            reply = refused(sent.message, SystemStatus.SIZE_ERROR)
            if reply is not None:
                owner.answer(sent, sent.client, reply)
            return
        if sent.message.wants_reply:
            self._pairing.remember(*pairing_key(sent.frame), sent, self._now_ns())
        owner.send(sent.frame)

    def heard(self, data: bytes) -> None:
        """Takes bytes from the brick."""
        for part in self._stream.feed(data):
            if isinstance(part, OutOfStep):
                self._owner.say_once(_dropped(part, self._stream.pending))
            elif (answer := self._pairing.answered(*pairing_key(part), self._now_ns())) is None:
                for client in self._owner.clients:
                    self._owner.answer(None, client, part)
            else:
                self._answered(answer.command, part, answer.note)

    def _answered(self, sent: Sent, frame: bytes, note: str | None) -> None:
        """Takes a reply. One to a client that has disconnected is withheld from the next one."""
        reply, is_there = parse(frame, strict=False), sent.client in self._owner.clients
        if sent.message is self._ended:
            self._end(reply)
            return
        sent.client.transfers.learn(sent.message, reply)
        if is_there:
            self._owner.answer(sent, sent.client, frame, note)
        else:
            self._leave(sent.client)

    def gone(self, client: Client) -> None:
        """Shows the commands of a client that has disconnected."""
        for sent in self._pairing.unanswered:
            if sent.client is client:
                self._owner.unanswered(sent)
        self._leave(client)

    def _leave(self, client: Client) -> None:
        self._endings.append(client.transfers.ending())
        if len(self._endings) == 1:
            self._end(None)

    def _end(self, reply: Message | None) -> None:
        """Goes on to end what clients have left open."""
        while self._endings:
            self._ended = next_of(self._endings[0], reply)
            if self._ended is not None:
                frame = self._ended.build()
                sent = Sent(self._nobody, self._ended, self._owner.records.sent(frame), frame)
                self._pairing.remember(*pairing_key(frame), sent, self._now_ns())
                self._owner.send(frame)
                return
            self._endings.popleft()
            reply = None

    def renewed(self) -> None:
        """Learns that the connection to the brick is a new one."""

    def _give_up(self, sent: Sent) -> None:
        """Shows a command that was given up; those of a disconnected client were shown."""
        if sent.client in self._owner.clients:
            self._owner.unanswered(sent)

    def _now_ns(self) -> int:
        return round(self._owner.now() * _NANOSECONDS)


def _dropped(part: OutOfStep, pending: bytes) -> str:
    said = advice(foreign(part.data + pending))
    why = f" ({said})" if said else ""
    return f"the brick sent {len(part.data)} bytes that are not a frame{why}; they were dropped"


class Guard:
    """Passes on commands that only read, one at a time, each client in turn.

    A brick continues the file that was opened last, whatever the handle. So before one client begins a transfer, the
    open one of another is read to its end, piece by piece between the commands of others, and kept for it.
    """

    def __init__(self, owner: Owner) -> None:
        self._owner = owner
        self._session = Session()
        self._turns: deque[Client] = deque()  # those whose commands wait, the next one first
        self._left: deque[Client] = deque()  # those that have disconnected, and may have left something open
        self._talk: Talk | None = None
        self._sent: Sent | None = None
        self._has_read_on = False
        self._request: Request | None = None
        self._cancel: Callable[[], None] = lambda: None

    @property
    def is_idle(self) -> bool:
        """Whether nothing is under way, and nothing has to be closed."""
        return self._talk is None and not self._left

    def forward(self, sent: Sent) -> None:
        """Queues a command of a client."""
        client = sent.client
        if not client.waiting:
            self._turns.append(client)
        client.waiting.append(sent)
        client.hold("a command is under way", True)
        self._next()

    def heard(self, data: bytes) -> None:
        """Takes bytes from the brick."""
        for event in self._session.feed(data):
            if isinstance(event, OutOfStep):
                self._owner.say_once(_dropped(event, self._session.pending))
            elif isinstance(event, Answered) and event.request is self._request:
                self._cancel()
                self._step(event.frame)
            elif isinstance(event, Stray) and event.oddity is Oddity.UNASKED:
                for client in self._owner.clients:
                    self._owner.answer(None, client, event.frame)
        self._next()

    def gone(self, client: Client) -> None:
        """Ends what a client has begun, once its command under way is answered."""
        for sent in client.waiting:
            self._owner.unanswered(sent)
        client.waiting.clear()
        if client in self._turns:
            self._turns.remove(client)
        self._left.append(client)
        self._next()

    def renewed(self) -> None:
        """Learns that the connection to the brick is a new one."""
        self._session = Session()
        self._step(None)
        for client in self._owner.clients:
            client.policy.forget()
        self._left.clear()
        self._next()

    def _next(self) -> None:
        """Begins with what is next, if nothing is under way."""
        while self._talk is None and (self._left or self._turns):
            self._talk = self._left.popleft().policy.leave() if self._left else self._turn()
            self._step(None)

    def _turn(self) -> Talk:
        """Begins the next command, or reads more of the open file that blocks a client which begins another."""
        begins = [one for one in self._turns if step_of(one.waiting[0].message) == "begin"]
        opener = self._opener(begins)
        # The others keep their order until the first of them begins.
        blocked = begins[1:] if opener is None else begins
        ready = [one for one in self._turns if one not in blocked]
        if opener is not None and not (ready and self._has_read_on):
            self._has_read_on = True
            return opener.policy.read_on()
        self._has_read_on = False
        self._turns.remove(ready[0])
        self._sent = ready[0].waiting[0]
        return ready[0].policy.talk(self._sent.message)

    def _opener(self, begins: list[Client]) -> Client | None:
        """Returns the client whose open file blocks the first one that begins another."""
        opener = next((one for one in self._owner.clients if one.policy.has_open), None)
        return opener if begins and opener is not begins[0] else None

    def _step(self, reply: bytes | None) -> None:
        """Continues with a reply, until the next frame is sent to the brick."""
        assert self._talk is not None
        self._request = None
        try:
            frame = self._talk.send(reply)
        except StopIteration as end:
            sent, self._sent, self._talk = self._sent, None, None
            if sent is not None and sent in sent.client.waiting:
                self._done(sent, end.value)
            return
        # With its own counter: no other command waits.
        self._request = self._session.adopt(frame)
        self._cancel = self._owner.later(PATIENCE, self._late)
        self._owner.send(self._request.frame)

    def _done(self, sent: Sent, outcome: Outcome) -> None:
        reply, client = outcome.reply, sent.client
        client.waiting.popleft()
        if client.waiting:
            self._turns.append(client)
        client.hold("a command is under way", bool(client.waiting))
        if outcome.harms:
            reply = self._refused(sent.message, outcome.harms)
        if reply is None or not sent.message.wants_reply:
            self._owner.unanswered(sent)
        else:
            self._owner.answer(sent, client, reply)

    def _refused(self, message: Message, harms: Mapping[Harm, str]) -> bytes | None:
        reasons = ", ".join(f"{name} {harm.text}" for harm, name in harms.items())
        status = SystemStatus.NO_PERMISSION
        if message.type is not None and not message.type.is_command:
            reasons = f"{message.type.name} is not a command"
        elif isinstance(message, SystemCommand) and "handle" in message.fields and set(harms) == {Harm.COMPUTING}:
            reasons = f"{message.command} names a handle that this client has not opened"
            status = SystemStatus.UNKNOWN_HANDLE
        self._owner.say_once(f"blocked by --read-only: {reasons}")
        return refused(message, status)

    def _late(self) -> None:
        self._request = None
        self._owner.say_once(f"no answer from the brick within {PATIENCE:g} s; the connection to it is made anew")
        self._owner.renew()
