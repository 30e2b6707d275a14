"""Runs a virtual brick by the real clock, and serves its connections, one frame at a time.

A direct command in progress keeps the whole brick waiting, as on the real one. The next client is the one whose
frame has waited longest; one whose command kept others waiting rests for as long.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial
from random import Random
from typing import Protocol

from ev3proto.brick.brick import Addressed, Brick
from ev3proto.brick.limits import MOST_BUFFERED, MOST_DELAYED, MOST_QUEUED, MOST_SPENT, PATIENCE
from ev3proto.brick.servers import Observer
from ev3proto.errors import counted
from ev3proto.schema.frame_buffer import FrameBuffer
from ev3proto.schema.header import out_of_step
from ev3proto.semantics.advice import advice
from ev3proto.semantics.identify import foreign, identify
from ev3proto.tables.frame import LENGTH_FIELD, MAX_FRAME
from ev3proto.version import REPORT_IT

_COMPUTING_PERIOD, _BUSY_PERIOD, _IDLE_PERIOD = 0.0, 0.002, 0.02
"""Seconds between two checks of the clock: while a direct command computes, once it waits, otherwise."""

_BUSY_SHARE = 0.02
"""How much of the time that a direct command has waited passes until the next check."""

_MOST_SERVING = 0.01
"""Seconds for which frames are served before the event loop continues."""

_LONG = 0.1
"""Seconds after which a command counts as keeping others waiting."""

_LEAST_STEP, _MOST_STEP = 500, 10_000
"""Microseconds that the brick's clock advances at a time."""

_MOST_ADVANCING = 0.01
"""Seconds after which the event loop continues, even if the brick's clock is still behind."""

_MOST_BEHIND = 250_000
"""Microseconds that the brick's clock may be behind. If this computer cannot keep up, the clock is slow."""

_MICROSECONDS = 1_000_000
_MOST_SHOWN = 48
_MOST_SAID = 1000

Say = Callable[[str], None]
"""Reports a message to the server's owner."""


Ends = tuple[tuple[str, int], tuple[str, int]]
_NO_ENDS: Ends = ("", 0), ("", 0)


class ServerError(Exception):
    """The brick cannot be switched on as requested; the text says why and what to do."""


class Line(Protocol):
    """The carrier's side of a connection."""

    def send(self, data: bytes) -> None:
        """Sends bytes to the client."""

    def pause(self) -> None:
        """Stops reading from the client for now."""

    def resume(self) -> None:
        """Resumes reading."""

    def drop(self) -> None:
        """Ends the connection at once."""


class Connection:
    """One client of the brick."""

    def __init__(
        self,
        host: Host,
        line: Line,
        name: str,
        carrier: str,
        ends: Ends = _NO_ENDS,
        opening: Sequence[tuple[bytes, bool]] = (),
    ) -> None:
        self.name = name  # its name in messages
        self.carrier = carrier  # "wifi" or "bluetooth"
        self.ends = ends  # IP address and port of the client, and those of the brick; on WiFi only
        self.opening = opening  # the texts before the first frame, each with whether the client sent it
        self.number = 0  # counted from 1 for each connection
        self.since = 0.0  # when its next frame was there
        self.rests_until = 0.0  # when it is served again, after it kept others waiting
        self.is_gone = False  # whether its client has disconnected; earlier frames are still served, and not answered
        self._host = host
        self._line = line
        self._incoming = FrameBuffer(judge=self._believe)
        self._frame: bytes | None = None  # the next whole frame
        self._is_paused = False
        self._is_throttled = False
        self._is_out_of_step = False
        self._delayed = 0

    def feed(self, data: bytes) -> None:
        """Takes bytes from the client."""
        self._incoming.append(data)
        self._look()
        if self._buffered > MOST_BUFFERED and not self._is_paused:
            self._is_paused = True
            self._line.pause()
        if not self._host.brick.is_busy:
            self._host.wake()

    def throttle(self, is_throttled: bool) -> None:
        """Learns whether the client leaves too much unread; while it does, its frames wait."""
        self._is_throttled = is_throttled
        if not is_throttled:
            self._host.wake()

    def close(self) -> None:
        """Learns that the client has disconnected; as on the real brick, its earlier frames are still served."""
        self.is_gone = True
        self._is_throttled = False
        self._host.serve_disconnected()

    def forget_frames(self) -> None:
        """Forgets the frames of a client that has disconnected."""
        if self.is_gone:
            self._incoming = FrameBuffer()
            self._frame = None

    def _look(self) -> None:
        """Takes the next frame out of the buffer, if it is whole."""
        if self._frame is None and isinstance(frame := self._incoming.next(), bytes):
            self._frame, self.since = frame, asyncio.get_running_loop().time()
            if (said := advice(foreign(frame))) is not None:
                self._host.say_once(f"{self.name}: {said}")

    def _believe(self, data: bytearray, at: int) -> None:
        """Believes any length, as the firmware does; reports the first that no frame can have."""
        if not self._is_out_of_step and (reason := out_of_step(data, at)) is not None:
            self._is_out_of_step = True
            self._host.say_once(f"{self.name}: {advice(foreign(bytes(data[at:MAX_FRAME]))) or reason}")

    @property
    def left(self) -> bytes:
        """The bytes that were not served: whole frames, and those of an incomplete one."""
        return (self._frame or b"") + self._incoming.pending

    @property
    def _buffered(self) -> int:
        return len(self._frame or b"") + len(self._incoming)

    @property
    def is_ready(self) -> bool:
        """Whether a whole frame has arrived and can be served."""
        return self._frame is not None and not self._is_throttled and self._delayed < MOST_DELAYED

    def take(self) -> bytes:
        """Takes the next whole frame."""
        assert self._frame is not None
        frame, self._frame = self._frame, None
        self._look()
        if self._is_paused and self._buffered <= MOST_BUFFERED:
            self._is_paused = False
            self._line.resume()
        return frame

    def send(self, frame: bytes, delay: float) -> None:
        """Sends a reply, with the requested delay."""
        if delay:
            self._delayed += 1
            asyncio.get_running_loop().call_later(delay, self._send_late, frame)
        else:
            self._line.send(frame)

    def _send_late(self, frame: bytes) -> None:
        self._delayed -= 1
        if not self.is_gone:
            self._line.send(frame)
        self._host.wake()


class Host:
    """A brick that is on, and its connections."""

    def __init__(self, brick: Brick, say: Say, faults: Faults | None = None) -> None:
        """Creates it, in the event loop that runs it."""
        self.brick = brick
        self.say = say
        self.connections: list[Connection] = []
        self.observers: list[Observer] = []
        self.faults = faults or Faults()
        self._loop = asyncio.get_running_loop()
        self._begin = self._loop.time()
        self._timer: asyncio.TimerHandle | None = None
        self._is_serving = self._is_stopped = False
        self._now = 0
        self._count = 0
        self._current: tuple[Connection, float] | None = None
        self._was_said: set[str] = set()
        self._schedule()

    # Connections

    def open(
        self,
        line: Line,
        name: str,
        carrier: str,
        ends: Ends = _NO_ENDS,
        opening: Sequence[tuple[bytes, bool]] = (),
    ) -> Connection:
        """Begins to serve a client; `Connection` documents the arguments."""
        connection = Connection(self, line, name, carrier, ends, opening)
        self._count += 1
        connection.number = self._count
        self.connections.append(connection)
        self._tell(lambda observer: observer.opened(connection))
        return connection

    def serve_disconnected(self) -> None:
        """Serves the remaining frames of a limited number of disconnected clients."""
        gone = [each for each in self.connections if each.is_gone]
        for each in gone[:-MOST_QUEUED]:
            each.forget_frames()
        self.wake()

    def queued(self) -> None:
        """Reports that a client waits until another one disconnects."""
        self.say_once("a client waits until another one disconnects; a real brick serves one, too (see --clients)")

    def _end_disconnected(self) -> None:
        """Ends the connections of disconnected clients without remaining frames."""
        for connection in [each for each in self.connections if each.is_gone and not each.is_ready]:
            if self._current is None or self._current[0] is not connection:
                self.connections.remove(connection)
                self._guarded(partial(self.brick.disconnect, connection), "as a client went")
                self._report_end(connection)

    def _report_end(self, connection: Connection) -> None:
        """Tells observers that a connection has ended, and the bytes of an unfinished frame."""
        if left := connection.left:
            reason = _unfinished(left)
            self.say_once(f"{connection.name}: {reason}")
            self._tell(lambda observer: observer.left(connection, left, reason))
        self._tell(lambda observer: observer.closed(connection))

    def stop(self) -> None:
        """Stops the clock."""
        if self._timer is not None:
            self._timer.cancel()
        self._timer = None
        self._is_stopped = True

    def end_all(self) -> None:
        """Ends all connections for the observers: the brick is about to be switched off."""
        for connection in self.connections:
            self._report_end(connection)
        self.observers.clear()

    # Serving

    def wake(self) -> None:
        """Serves the frames that have arrived."""
        if not self._is_serving and not self._is_stopped:
            self._serve()

    def say_once(self, sentence: str) -> None:
        """Reports a message, the first time only."""
        if sentence not in self._was_said and len(self._was_said) < _MOST_SAID:
            self._was_said.add(sentence)
            self.say(sentence)

    def _serve(self) -> None:
        self._is_serving = True
        until = self._loop.time() + _MOST_SERVING
        try:
            self._advance()
            while not self.brick.is_busy:
                self._settle()
                self._end_disconnected()
                connection = self._next()
                if connection is None:
                    break
                self._take_up(connection)
                if self._loop.time() > until:
                    break
                self._advance()
        finally:
            self._is_serving = False
        self._schedule()

    def _show(self, connection: Connection, reply: bytes) -> None:
        self._tell(lambda observer: observer.frame(connection, reply, False))

    def _tell(self, news: Callable[[Observer], None]) -> None:
        """Calls all observers, except those that have raised an error before."""
        for observer in list(self.observers):
            try:
                news(observer)
            except Exception as error:
                self.observers.remove(observer)
                self.say(f"a defect of {type(observer).__name__}, which sees nothing more, {REPORT_IT}: {error!r}")

    def _next(self) -> Connection | None:
        """Returns the connection whose frame has waited longest: a new one is the last, and none waits for ever."""
        best: Connection | None = None
        now = self._loop.time()
        for connection in self.connections:
            is_free = connection.rests_until <= now
            if connection.is_ready and is_free and (best is None or connection.since < best.since):
                best = connection
        return best

    def _take_up(self, connection: Connection) -> None:
        self._current = (connection, self._loop.time())
        frame = connection.take()
        if self.observers:
            self._tell(lambda observer: observer.frame(connection, frame, True))
        shown = frame[:_MOST_SHOWN].hex(" ") + (" ..." if len(frame) > _MOST_SHOWN else "")
        if not self._guarded(lambda: self.brick.receive_from(connection, frame), f"at the frame {shown}"):
            self._current = None

    def _guarded(self, act: Callable[[], list[Addressed]], place: str) -> bool:
        """Calls the brick and delivers the replies. Returns False after a defect, which must not stop the server."""
        try:
            self._deliver(act())
        except Exception as error:
            self.say_once(f"a defect of the virtual brick, {REPORT_IT}: {error!r} {place}")
            return False
        return True

    def _settle(self) -> None:
        """Charges a connection for its ended command; if it kept others waiting, they are served for as long."""
        if self._current is not None:
            connection, begin = self._current
            self._current = None
            now = self._loop.time()
            if now - begin > _LONG and self._is_awaited(connection):
                connection.rests_until = now + min(now - begin, PATIENCE)

    def _is_awaited(self, connection: Connection) -> bool:
        """Returns whether another client has a frame to be served."""
        return any(other.is_ready for other in self.connections if other is not connection)

    def _advance(self) -> None:
        """Advances the brick's clock to the real one."""
        brick = self.brick
        now = int((self._loop.time() - self._begin) * _MICROSECONDS)
        self._now = max(self._now, now - _MOST_BEHIND)
        until = self._loop.time() + _MOST_ADVANCING
        while now - self._now >= _LEAST_STEP or brick.is_computing:
            step = min(now - self._now, _MOST_STEP)
            self._now += step
            if not self._guarded(partial(brick.advance_all, step / _MICROSECONDS), "as time passed"):
                break
            if brick.is_computing or self._loop.time() > until:
                break
        self._watch()

    def _watch(self) -> None:
        """Looks after the command in progress, and says what has happened to the brick."""
        brick = self.brick
        if self._current is not None and brick.is_busy:
            self._hurry(*self._current)
        if brick.has_ended_command:
            brick.has_ended_command = False
            if self._current is not None:
                self._current[0].forget_frames()
                self.say_once(f"{self._current[0].name}: an endless command was ended; a real brick stops answering")
        if brick.equipment.is_dead:
            brick.equipment.is_dead = False
            self.say_once(
                "PROGRAM_STOP 0 ended everything: a real brick is dead until it is restarted, this one continues"
            )

    def _hurry(self, connection: Connection, begin: float) -> None:
        """Says what a command waits for in vain, and ends it if it keeps another client waiting."""
        if self.brick.waits_for:
            self._report_waiting(connection)
        is_long = self.brick.spent > MOST_SPENT
        if (is_long or self._loop.time() - begin > PATIENCE) and self._is_awaited(connection):
            after = f"{MOST_SPENT:g} s of CPU time" if is_long else f"{PATIENCE:g} s"
            self.say_once(f"{connection.name}: its command was ended after {after}, because another client waits")
            connection.forget_frames()
            self._guarded(self.brick.end_command, "as a command was ended")

    def _report_waiting(self, connection: Connection) -> None:
        """Says what a command waits for in vain, once, and tells the observers."""
        reason = self.brick.waits_for
        if f"{connection.name}: {reason}" not in self._was_said:
            self.say_once(f"{connection.name}: {reason}")
            self._tell(lambda observer: observer.waiting(connection, reason))

    def _is_behind(self) -> bool:
        """Returns whether the brick's clock is further behind than one step."""
        return (self._loop.time() - self._begin) * _MICROSECONDS - self._now > _MOST_STEP

    def _deliver(self, replies: list[Addressed]) -> None:
        for channel, reply in replies:
            sent = self.faults.apply_to(reply)
            if isinstance(channel, Connection) and not channel.is_gone and sent is not None:
                if self.observers:
                    self._show(channel, sent)
                channel.send(sent, self.faults.delay)

    def _schedule(self) -> None:
        """Schedules the next check of the clock."""
        if self._timer is not None:
            self._timer.cancel()
        if self.brick.is_computing or self._is_behind():
            period = _COMPUTING_PERIOD
        elif self.brick.is_busy and self._current is not None:
            waited = self._loop.time() - self._current[1]
            period = min(max(_BUSY_PERIOD, _BUSY_SHARE * waited), _IDLE_PERIOD)
        elif self._next() is not None:
            period = _COMPUTING_PERIOD
        else:
            period = _IDLE_PERIOD
        self._timer = self._loop.call_later(period, self.wake)


def _unfinished(left: bytes) -> str:
    """Returns a client's bytes that were not served: whole frames, or an incomplete one."""
    buffer = FrameBuffer(left, judge=lambda _data, _at: None)
    frames = len(list(buffer))
    if frames or not len(buffer):
        return f"the connection ended before {counted(frames, 'frame')} of it {'was' if frames == 1 else 'were'} served"
    if buffer.size is None:
        return f"the connection ended inside a frame: {counted(len(left), 'byte')} of its length came"
    reason = advice(identify(buffer.pending)) or out_of_step(buffer.pending)
    return reason or f"the connection ended inside a frame: {len(buffer)} of its {counted(buffer.size, 'byte')} came"


@dataclass
class Faults:
    """The faults of replies."""

    delay: float = 0.0  # seconds by which each reply is delayed
    drop: float = 0.0  # share of them that are lost, 0 to 1
    corrupt: float = 0.0  # share of them in which one byte after the length field is changed, 0 to 1
    random: Random = field(default_factory=Random)  # the random numbers; a seed makes them repeatable

    def apply_to(self, reply: bytes) -> bytes | None:
        """Returns the bytes to send for a reply; None if it is lost."""
        if self.drop and self.random.random() < self.drop:
            return None
        if self.corrupt and self.random.random() < self.corrupt:
            changed = bytearray(reply)
            # The length stays right, so that later replies can still be read.
            changed[self.random.randrange(LENGTH_FIELD, len(reply))] ^= self.random.randint(1, 0xFF)
            return bytes(changed)
        return reply
