"""The commands on their way to a real brick: one at a time, each with its answer or the reason for its silence."""

from __future__ import annotations

import io
import random
import time
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass

from ev3proto.bounded import Bounded
from ev3proto.generate.captures.recording import Recording
from ev3proto.link.errors import LinkError
from ev3proto.link.policy import Outcome, Talk
from ev3proto.link.session import Answered, Oddity, Request, Session, Stray
from ev3proto.schema.header import HEADER_SIZE, Header, frame_size
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.frame import COUNTERS, LENGTH_FIELD, MessageType

from .answers import Answers

PATIENCE = 5.0
"""Seconds after which a command counts as unanswered. A later answer is told all the same."""

MOST_RECORDED = 1 << 26
"""Bytes of a recording; what follows is not recorded."""

MOST_LATE = 256

_KEY = 0

Done = Callable[[Outcome, float, str], object]
"""Takes the outcome of a talk, the milliseconds of its last command, and the reason why that has no answer."""


@dataclass(eq=False, slots=True)
class Command:
    """A command that waits for its turn, or for its reply.

    frame     its bytes
    answered  takes the reply, the milliseconds that it took, and the reason why there is none
    is_kept   whether it keeps its counter; others get a new one
    request   what the session knows of it, once it is sent
    sent      when, in milliseconds of the page's clock
    deadline  when it counts as unanswered, in seconds of Python's clock
    """

    frame: bytes
    answered: Callable[[bytes | None, float, str], None]
    is_kept: bool
    request: Request | None = None
    sent: float = 0.0
    deadline: float = 0.0


class Connection:
    """A connection to a brick. JavaScript moves the bytes.

    carrier  USB or Bluetooth
    is_open  whether it is there
    """

    def __init__(self, carrier: Carrier, carry: Callable[[str], object], answers: Answers) -> None:
        """Begins it. `carry` takes a frame for the brick, in hex; `answers` show what no command waits for."""
        self.carrier = carrier
        self._carry = carry
        self._answers = answers
        # Other tabs and programs may see the same replies: their counters should differ.
        self._session = Session(random.randrange(COUNTERS))
        self._waiting: deque[Command] = deque()
        self._now: Command | None = None
        self._late: Bounded[int, Command] = Bounded(MOST_LATE)
        self._file = io.BytesIO()
        self._recording = Recording(self._file)
        self._recording.opened(_KEY, carrier, ("", 0), ("", 0))
        self.is_open = True

    @property
    def is_idle(self) -> bool:
        """Whether no command is on its way, or waits."""
        return self._now is None and not self._waiting

    # Bytes

    def sent(self, at: float) -> None:
        """Takes the time at which a frame was carried, in milliseconds of the page's clock."""
        if self._now is not None:
            self._now.sent = at

    def heard(self, data: bytes, at: float) -> None:
        """Takes a report of USB, or any bytes of a serial port, and when they came, as `sent` does."""
        if not self.is_open:
            return
        if self.carrier is Carrier.USB and len(data) >= LENGTH_FIELD:
            data = data[: frame_size(data)]
        for event in self._session.feed(data):
            if isinstance(event, Answered):
                self._record(event.frame, False)
                command, self._now = self._now, None
                assert command is not None
                command.answered(event.frame, at - command.sent, "")
            elif isinstance(event, Stray):
                self._record(event.frame, False)
                self._stray(event, at)
        self.advance()

    def _stray(self, event: Stray, at: float) -> None:
        if event.oddity is Oddity.UNASKED:
            self._answers.unasked(event.frame)
        late = self._late.pop(Header.read(event.frame).counter, None) if event.oddity is Oddity.LATE else None
        if late is not None and late.is_kept:
            self._answers.late(late.frame, event.frame, at - late.sent)

    def _record(self, frame: bytes, is_sent: bool) -> None:
        if self._file.tell() < MOST_RECORDED:
            self._recording.data(_KEY, frame, is_sent)

    def recording(self) -> bytes:
        """Returns what was said so far, as pcapng."""
        return self._file.getvalue()

    # Commands

    def turn(self) -> None:
        """Lets time pass: ends what waits for too long."""
        command = self._now
        if command is not None and time.monotonic() > command.deadline:
            self._now = None
            assert command.request is not None
            self._session.abandon(command.request)
            self._late.add(command.request.counter, command)
            command.answered(None, 0.0, f"no answer within {PATIENCE:g} s; a late one is shown when it comes")
        self.advance()

    def advance(self) -> None:
        """Sends commands until one waits for its reply."""
        while self.is_open and self._now is None and self._waiting:
            command = self._waiting.popleft()
            frame = command.frame
            try:
                request = (
                    self._session.adopt(frame)
                    if command.is_kept
                    else self._session.command(MessageType(Header.read(frame).type), frame[HEADER_SIZE:])
                )
            except LinkError as error:
                self._answers.wrong(str(error))
                continue
            command.request = request
            self._record(request.frame, True)
            if request.wants_reply:
                self._now = command
                command.deadline = time.monotonic() + PATIENCE
            self._carry(request.frame.hex())
            if not request.wants_reply:
                command.answered(None, 0.0, "")

    def forget(self) -> None:
        """Forgets the commands that wait."""
        self._waiting.clear()

    def send_at_once(self, kind: MessageType, body: bytes) -> bytes:
        """Sends a command that wants no reply before all others. Returns its frame."""
        frame = self._session.command(kind, body).frame
        self._record(frame, True)
        self._carry(frame.hex())
        return frame

    def close(self, reason: str) -> None:
        """Ends it. The command that has no answer yet gets none."""
        self.is_open = False
        command, self._now = self._now, None
        self._waiting.clear()
        if command is not None:
            command.answered(None, 0.0, f"no answer: {reason}")
        self._recording.close()

    def converse(self, talk: Talk, done: Done, counter: int | None = None) -> None:
        """Has the frames of a talk wait for their turn, which `advance` gives.

        Args:
            talk: Yields the frames.
            done: Takes the outcome, the milliseconds of the last command, and why it has no answer.
            counter: Frames with this counter keep it, and none waits for what is asked for every second.
        """

        def step(reply: bytes | None, latency: float, reason: str) -> None:
            try:
                frame = talk.send(reply)
            except StopIteration as end:
                done(end.value, latency, reason)
                return
            command = Command(frame, step, Header.read(frame).counter == counter)
            (self._waiting.append if counter is None else self._waiting.appendleft)(command)

        step(None, 0.0, "")
