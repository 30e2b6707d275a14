"""The commands on their way to a real brick: one at a time, each with its answer or the reason for its silence."""

from __future__ import annotations

import io
import random
import time
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

from ev3proto.bounded import Bounded
from ev3proto.generate.captures.recording import Recording
from ev3proto.link.errors import LinkError
from ev3proto.link.policy import Outcome, Talk
from ev3proto.link.session import Answered, Oddity, Request, Session, Stray
from ev3proto.schema.header import HEADER_SIZE, Header, frame_size
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.frame import COUNTERS, LENGTH_FIELD, MessageType

PATIENCE = 5.0
"""Seconds after which a command counts as unanswered. A later answer is told all the same."""

MOST_RECORDED = 1 << 26
"""Bytes of a recording; what follows is not recorded."""

MOST_LATE = 256

_KEY = 0


@dataclass(eq=False, slots=True)
class Job:
    """A command that waits for its turn.

    start     makes it a command of the session
    answer    takes the reply and the milliseconds that it took; None and 0 for a command that wants none
    silence   takes the reason why no answer came
    request   the command, once it is sent
    sent      when, in milliseconds of the page's clock
    deadline  when it counts as unanswered, in seconds of Python's clock
    is_late   whether that was before its reply came
    """

    start: Callable[[Session], Request]
    answer: Callable[[Job, bytes | None, float], None]
    silence: Callable[[Job, str], None]
    request: Request | None = None
    sent: float = 0.0
    deadline: float = 0.0
    is_late: bool = False

    @property
    def frame(self) -> bytes:
        """Its bytes, once it is sent."""
        assert self.request is not None
        return self.request.frame


Done = Callable[[Outcome, float, str], None]
"""Takes the outcome of a talk, the milliseconds of its last command, and the reason why that has no answer."""


class Listener(NamedTuple):
    """Who hears of a connection.

    carry    takes a frame for the brick, in hex
    late     takes a command whose reply came late, the reply, and the milliseconds that it took
    unasked  takes a frame that the brick sent by itself
    wrong    takes the reason why a command could not be sent
    """

    carry: Callable[[str], object]
    late: Callable[[Job, bytes, float], object]
    unasked: Callable[[bytes], object]
    wrong: Callable[[str], object]


class Connection:
    """A connection to a brick. JavaScript moves the bytes.

    carrier  USB or Bluetooth
    is_open  whether it is there
    """

    def __init__(self, carrier: Carrier, listener: Listener) -> None:
        self.carrier = carrier
        self._listener = listener
        # Other tabs and programs may see the same replies: their counters should differ.
        self._session = Session(random.randrange(COUNTERS))
        self._jobs: deque[Job] = deque()
        self._now: Job | None = None
        self._late: Bounded[int, Job] = Bounded(MOST_LATE)
        self._file = io.BytesIO()
        self._recording = Recording(self._file)
        self._recording.opened(_KEY, carrier, ("", 0), ("", 0))
        self.is_open = True

    @property
    def is_idle(self) -> bool:
        """Whether no command is on its way, or waits."""
        return self._now is None and not self._jobs

    # Bytes

    def sent(self, at: float) -> None:
        """Takes the time at which a frame was carried, in milliseconds of the page's clock."""
        if self._now is not None:
            self._now.sent = at

    def heard(self, data: bytes, at: float) -> None:
        """Takes what came from the brick.

        Args:
            data: A report of USB, or any bytes of a serial port.
            at: When, in milliseconds of the page's clock.
        """
        if not self.is_open:
            return
        if self.carrier is Carrier.USB and len(data) >= LENGTH_FIELD:
            data = data[: frame_size(data)]
        for event in self._session.feed(data):
            if isinstance(event, Answered):
                self._record(event.frame, False)
                job, self._now = self._now, None
                assert job is not None
                job.answer(job, event.frame, at - job.sent)
            elif isinstance(event, Stray):
                self._record(event.frame, False)
                self._stray(event, at)
        self.advance()

    def _stray(self, event: Stray, at: float) -> None:
        if event.oddity is Oddity.LATE:
            job = self._late.pop(Header.read(event.frame).counter, None)
            if job is not None:
                job.is_late = True
                job.answer(job, event.frame, at - job.sent)
        elif event.oddity is Oddity.UNASKED:
            self._listener.unasked(event.frame)

    def _record(self, frame: bytes, is_sent: bool) -> None:
        if self._file.tell() < MOST_RECORDED:
            self._recording.data(_KEY, frame, is_sent)

    def recording(self) -> bytes:
        """Returns what was said so far, as pcapng."""
        return self._file.getvalue()

    # Commands

    def turn(self) -> None:
        """Lets time pass: ends what waits for too long."""
        job = self._now
        if job is not None and time.monotonic() > job.deadline:
            self._now = None
            assert job.request is not None
            self._session.abandon(job.request)
            self._late.add(job.request.counter, job)
            job.silence(job, f"no answer within {PATIENCE:g} s; a late one is shown when it comes")
        self.advance()

    def advance(self) -> None:
        """Sends commands until one waits for its reply."""
        while self.is_open and self._now is None and self._jobs:
            job = self._jobs.popleft()
            try:
                job.request = job.start(self._session)
            except LinkError as error:
                self._listener.wrong(str(error))
                continue
            self._record(job.request.frame, True)
            if job.request.wants_reply:
                self._now = job
                job.deadline = time.monotonic() + PATIENCE
            self._listener.carry(job.request.frame.hex())
            if not job.request.wants_reply:
                job.answer(job, None, 0.0)

    def add(self, job: Job) -> None:
        """Has a command wait for its turn."""
        self._jobs.append(job)

    def forget(self) -> None:
        """Forgets the commands that wait."""
        self._jobs.clear()

    def send_at_once(self, kind: MessageType, body: bytes) -> bytes:
        """Sends a command that wants no reply before all others. Returns its frame."""
        frame = self._session.command(kind, body).frame
        self._record(frame, True)
        self._listener.carry(frame.hex())
        return frame

    def close(self) -> Job | None:
        """Ends it. Returns the command that has no answer yet."""
        self.is_open = False
        job, self._now = self._now, None
        self._jobs.clear()
        self._recording.close()
        return job

    def converse(self, talk: Talk, done: Done, counter: int | None = None) -> None:
        """Sends the frames of a talk.

        Args:
            talk: Yields the frames.
            done: Takes the outcome, the milliseconds of the last command, and why it has no answer.
            counter: Frames with this counter keep it, and none waits for what is asked for every second.
        """
        last: tuple[float, str] = (0.0, "")

        def step(reply: bytes | None) -> None:
            try:
                frame = talk.send(reply)
            except StopIteration as end:
                done(end.value, *last)
                return
            is_kept = Header.read(frame).counter == counter
            job = Job(_adopting(frame) if is_kept else _again(frame), answered, silent)
            (self._jobs.append if counter is None else self._jobs.appendleft)(job)

        def answered(job: Job, reply: bytes | None, latency: float) -> None:
            nonlocal last
            if job.is_late:
                if reply is not None:
                    self._listener.late(job, reply, latency)
                return
            last = latency, ""
            step(reply)

        def silent(_: Job, reason: str) -> None:
            nonlocal last
            last = 0.0, reason
            step(None)

        step(None)


def _adopting(frame: bytes) -> Callable[[Session], Request]:
    """Returns the start of a command with its own counter."""
    return lambda session: session.adopt(frame)


def _again(frame: bytes) -> Callable[[Session], Request]:
    """Returns the start of a command with a new counter."""
    return lambda session: session.command(MessageType(Header.read(frame).type), frame[HEADER_SIZE:])
