"""A session with a real brick. JavaScript moves the bytes; what they mean is decided by ev3proto's own session."""

from __future__ import annotations

import base64
import io
import json
import random
import time
from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from ev3proto.bounded import Bounded
from ev3proto.capture import read
from ev3proto.capture.dialogues import dialogues
from ev3proto.capture.formats import CaptureFile
from ev3proto.checking.checking import check
from ev3proto.compose import Draft
from ev3proto.dialogue import Dialogue
from ev3proto.generate.captures.recording import Recording
from ev3proto.link import file_moves, questions
from ev3proto.link.commands import Prepared, SyncMode, direct
from ev3proto.link.errors import LinkError
from ev3proto.link.file_moves import Task
from ev3proto.link.harm import Harm
from ev3proto.link.policy import Outcome, Policy, Talk
from ev3proto.link.questions import Question
from ev3proto.link.replay import Likeness, Replay, Step, compare, plan, steps
from ev3proto.link.session import Answered, Oddity, Request, Session, Stray
from ev3proto.messages import LV
from ev3proto.ops import com_set, file, input_readsi, output_stop, program_start, program_stop
from ev3proto.schema.frame import parse
from ev3proto.schema.header import HEADER_SIZE, Header, build_frame, frame_size
from ev3proto.semantics.replies import Value
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.devices import DEVICE_TYPES, NO_DEVICE
from ev3proto.tables.enumerations import SLOT
from ev3proto.tables.frame import COUNTERS, LENGTH_FIELD, MAX_FRAME, MessageType
from ev3proto.tables.input import MOTOR_PORTS, SENSOR_PORTS
from ev3proto.tables.ports import MotorPorts
from ev3proto.text.phrases import Seen, command_spans
from ev3proto.text.spans import Role, Spans, plain_text
from ev3proto.text.tree import tree
from ev3proto.version import VERSION

from .rows import pieces

PATIENCE = 5.0
"""Seconds after which a command counts as unanswered. A later answer is shown all the same."""

PERIOD = 1.0
"""Seconds between two questions for battery and ports."""

MOST_SILENT = 3
"""Unanswered commands in a row after which a comparison ends."""

MOST_RECORDED = 1 << 26
"""Bytes of a recording; what follows is not recorded."""

MOST_ANSWERS = 100
"""Answers that are shown."""

MOST_LATE = 256

DIALECT = "official"

PROGRAM = "/home/root/lms2012/prjs/playground/playground.rbf"
"""Where a program of the input is written on a brick."""
_KEY = 0
_NO_CHANGE = -1
_PORT_NAMES = (*(str(port + 1) for port in SENSOR_PORTS), *(chr(ord("A") + number) for number in range(4)))


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


class RealBrick:
    """A connection to a brick. One command at a time is on its way.

    is_open  whether the connection is there
    """

    def __init__(self, carrier: str, label: str, carry: Callable[[str], object], tell: Callable[[str], object]) -> None:
        """Begins a session.

        Args:
            carrier: "usb" or "bluetooth".
            label: Which brick, as sentences call it.
            carry: Takes a frame for the brick, in hex.
            tell: Takes news for the page, as JSON.
        """
        self._carrier = Carrier(carrier)
        self._label = label
        self._carry = carry
        self._tell = tell
        # Other tabs and programs may see the same replies: their counters should differ.
        self._session = Session(random.randrange(COUNTERS))
        self._policy = Policy()
        self._left = 0
        self._jobs: deque[Job] = deque()
        self._now: Job | None = None
        self._late: Bounded[int, Job] = Bounded(MOST_LATE)
        self._answers: list[list[Spans]] = []
        self._file = io.BytesIO()
        self._recording = Recording(self._file)
        self._recording.opened(_KEY, self._carrier, ("", 0), ("", 0))
        self._turn = 0
        self._watches = False
        self._due = 0.0
        self._facts: dict[str, Any] = {}
        self._comparison: Comparison | None = None
        self.is_open = True

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
        if self._carrier is Carrier.USB and len(data) >= LENGTH_FIELD:
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
        self._advance()

    def _stray(self, event: Stray, at: float) -> None:
        if event.oddity is Oddity.LATE:
            job = self._late.pop(Header.read(event.frame).counter, None)
            if job is not None:
                job.is_late = True
                job.answer(job, event.frame, at - job.sent)
        elif event.oddity is Oddity.UNASKED:
            self._show([[("sent by the brick, unasked:", Role.HEADING)], *_tree(event.frame, None)])

    def turn(self) -> None:
        """Lets time pass: ends what waits for too long, and asks what is asked for every second."""
        now = time.monotonic()
        job = self._now
        if job is not None and now > job.deadline:
            self._now = None
            assert job.request is not None
            self._session.abandon(job.request)
            self._late.add(job.request.counter, job)
            job.silence(job, f"no answer within {PATIENCE:g} s; a late one is shown when it comes")
        if self._watches and self._now is None and not self._jobs and now >= self._due:
            self._due = now + PERIOD
            self._watch()
        self._advance()

    def gone(self, reason: str) -> None:
        """Ends the session."""
        if not self.is_open:
            return
        self.is_open = False
        job, self._now = self._now, None
        self._jobs.clear()
        self._left = 0
        self._watches = False
        if self._comparison is not None:
            self._comparison.end(reason)
        if job is not None:
            job.silence(job, f"no answer: {reason}")
        self._recording.close()

    def _advance(self) -> None:
        """Sends commands until one waits for its reply."""
        while self.is_open and self._now is None and self._jobs:
            job = self._jobs.popleft()
            try:
                job.request = job.start(self._session)
            except LinkError as error:
                self._show([[(str(error), Role.FAULT)]])
                continue
            self._record(job.request.frame, True)
            if job.request.wants_reply:
                self._now = job
                job.deadline = time.monotonic() + PATIENCE
            self._carry(job.request.frame.hex())
            if not job.request.wants_reply:
                job.answer(job, None, 0.0)

    def _record(self, frame: bytes, is_sent: bool) -> None:
        if self._file.tell() < MOST_RECORDED:
            self._recording.data(_KEY, frame, is_sent)

    def recording(self) -> bytes:
        """Returns what was said so far, as pcapng."""
        return self._file.getvalue()

    # Commands of the input

    def send(self, frames: list[bytes], *, is_allowed: bool) -> dict[str, Any]:
        """Sends commands.

        Args:
            frames: The commands.
            is_allowed: Whether they may do what is not on the list of reading operations.

        Returns:
            `error`, or `ask`: what they may do, if that has to be allowed first.
        """
        for frame in frames:
            if len(frame) != frame_size(frame):
                return {
                    "error": "The length field does not match: the brick would wait for the rest. See the findings."
                }
            if self._carrier is Carrier.USB and len(frame) > MAX_FRAME:
                return {"error": f"The frame has {len(frame)} bytes; USB carries {MAX_FRAME}."}
        asks = [] if is_allowed else list(dict.fromkeys(ask for frame in frames for ask in self._asks(frame)))
        if asks:
            return {"ask": asks}
        self._answers = []
        self._left = len(frames)
        self._turn += 1
        self._show([])
        self._send_next(frames, self._turn, is_allowed=is_allowed)
        self._advance()
        return {}

    def _asks(self, frame: bytes) -> Iterator[str]:
        """Yields what has to be allowed before a command is sent."""
        report = check(frame)
        if not report.accepted:
            yield f"The brick refuses it, and may have to be restarted: {report.findings[0].message}."
        for harm, name in self._policy.harms(parse(frame, strict=False)).items():
            yield f"{name} {harm.text}."

    def _send_next(self, frames: list[bytes], turn: int, *, is_allowed: bool) -> None:
        """Sends the first of some commands, and the others once it is answered, unless something else came between."""
        if not frames or not self.is_open or turn != self._turn:
            return
        frame = frames[0]
        message = parse(frame, strict=False)

        def done(outcome: Outcome, latency: float, reason: str) -> None:
            self._left = max(0, self._left - 1)
            self._answered(frame, outcome, latency, reason)
            self._send_next(frames[1:], turn, is_allowed=is_allowed)

        self.converse(self._policy.talk(message, is_allowed=is_allowed), done, message.counter)

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
                self._show_late(job, reply, latency)
                return
            last = latency, ""
            step(reply)

        def silent(_: Job, reason: str) -> None:
            nonlocal last
            last = 0.0, reason
            step(None)

        step(None)

    def _answered(self, frame: bytes, outcome: Outcome, latency: float, reason: str) -> None:
        command = command_spans(parse(frame, strict=False))
        if outcome.harms:
            text = " ".join(f"{name} {harm.text}." for harm, name in outcome.harms.items())
            self._show([command, [(f"not sent: {text}", Role.FAULT)]])
        elif reason:
            self._show([command, [(reason, Role.FAULT)]])
        elif outcome.reply is None:
            self._show([command, [("sent; it wants no answer", Role.ASIDE)]])
        else:
            head: Spans = [(f"answered after {latency:.1f} ms:", Role.ASIDE)]
            self._show([command, head, *_tree(outcome.reply, frame)])

    def _show_late(self, job: Job, reply: bytes | None, latency: float) -> None:
        if reply is not None:
            head: Spans = [(f"answered late, after {latency:.1f} ms:", Role.ASIDE)]
            self._show([command_spans(parse(job.frame, strict=False)), head, *_tree(reply, job.frame)])

    def _show(self, lines: list[Spans]) -> None:
        """Shows an answer below the ones before it."""
        if lines:
            self._answers = [*self._answers, lines][-MOST_ANSWERS:]
        shown = [[pieces(line) for line in answer] for answer in self._answers]
        self._tell(json.dumps({"answers": shown, "isWaiting": bool(self._left or self._jobs or self._now)}))

    def stop_motors(self) -> None:
        """Stops all motors at once, before everything that waits, and forgets the commands that do."""
        self._jobs.clear()
        self._left = 0
        self._turn += 1
        if self._comparison is not None:
            self._comparison.end("cancelled")
        prepared = direct(output_stop(0, MotorPorts.ALL, True), 0, 0, SyncMode.STD, DIALECT)
        # It wants no reply, so it does not have to wait for that of another command.
        frame = self._session.command(prepared.kind, prepared.body).frame
        self._record(frame, True)
        self._carry(frame.hex())
        self._show([command_spans(parse(frame)), [("sent; all motors stop", Role.ASIDE)]])

    def leave(self) -> bool:
        """Closes files, and reads listings to their end. Returns whether there are any."""
        if not self.is_open or not self._policy.has_open:
            return False
        # Before all else.
        self.converse(self._policy.leave(), lambda *_: self.tell(hasLeft=True), counter=-1)
        self._advance()
        return True

    # Files and programs

    def files(self, action: str, path: str, data: bytes) -> None:
        """Lists a folder of the brick, or reads, writes or deletes a file. The page hears what came of it.

        Args:
            action: One of TASKS.
            path: The folder or file.
            data: What is written.
        """
        self._move(action, path, data, lambda: None)

    def run(self, image: bytes, *, is_allowed: bool) -> dict[str, Any]:
        """Writes a program on the brick and starts it; returns as `send` does."""
        if not is_allowed:
            return {"ask": [f"Writes {PROGRAM} on the brick, and starts it."]}
        self._move("put", PROGRAM, image, lambda: self.panel("start", PROGRAM, is_allowed=True))
        return {}

    def _move(self, action: str, path: str, data: bytes, then: Callable[[], object]) -> None:
        """Does something with a file, and then something else if that succeeds."""
        task = TASKS[action](path, data)
        said: dict[str, Any] = {"action": action, "path": path, "error": ""}

        def talk() -> Talk:
            try:
                command = next(task)
                while True:
                    reply = yield command.build()
                    answer = None if reply is None else parse(reply, strict=False)
                    if answer is None:
                        said["error"] = "the brick does not answer"
                        return Outcome()
                    command = task.send(answer)
            except StopIteration as end:
                said["result"] = _as_json(end.value)
            except LinkError as error:
                said["error"] = str(error)
            return Outcome()

        def done(*_: object) -> None:
            self.tell(files=said)
            if not said["error"]:
                then()

        self.converse(talk(), done)
        self._advance()

    def panel(self, action: str, text: str, *, is_allowed: bool) -> dict[str, Any]:
        """Does one of PANEL, as `send` sends a command: it asks first."""
        prepared = direct(PANEL[action](text), 0, 0, SyncMode.SYNC, DIALECT)
        return self.send([build_frame(prepared.kind, 0, prepared.body)], is_allowed=is_allowed)

    # What is asked for every second

    def watch(self, is_wanted: bool) -> None:
        """Begins or ends asking for name, firmware, battery and ports every second."""
        self._watches = is_wanted
        self._due = 0.0
        self.turn()

    def _watch(self) -> None:
        self._ask(questions.NAME, lambda name: self._know(name=name))
        self._ask(questions.SYSTEM, lambda system: self._know(firmware=system.fw_version))
        self._ask(questions.BATTERY, self._know_battery)
        self._ask(_TYPES_AND_MODES, self._ask_values)

    def _know_battery(self, battery: questions.Battery) -> None:
        self._know(battery=f"{battery.voltage:.2f} V, {battery.current:.2f} A, {battery.percentage} %")

    def _ask_values(self, found: list[tuple[int, int]]) -> None:
        """Asks for the values of the devices that are plugged in."""
        plugged = [(at, kind, mode) for at, (kind, mode) in enumerate(found) if kind != NO_DEVICE.number]
        drafts = tuple(input_readsi(0, _PORTS[at], 0, _NO_CHANGE) for at, _, _ in plugged)
        if not drafts:
            self._know(ports=[])
            return

        def know(values: list[float]) -> None:
            rows = zip(plugged, values, strict=True)
            self._know(ports=[[_PORT_NAMES[at], *shown(kind, mode, value)] for (at, kind, mode), value in rows])

        self._ask(Question(drafts, lambda values: values), know)

    def _ask(self, question: Question[Any], know: Callable[[Any], None]) -> None:
        prepared = direct(question.operations, 0, 0, SyncMode.SYNC, DIALECT)

        def answered(job: Job, reply: bytes | None, _: float) -> None:
            values = _values(prepared, job.frame, reply)
            if values is not None:
                know(question.read(values))

        self._jobs.append(Job(lambda session: session.command(prepared.kind, prepared.body), answered, self._unknown))

    def _unknown(self, _: Job, reason: str) -> None:
        self._know(silence=reason)

    def _know(self, *, silence: str = "", **facts: Any) -> None:
        self._facts |= facts
        self._tell(json.dumps({"facts": self._facts | {"silence": silence}}))

    # The comparison with the virtual brick

    def compare(self, capture: bytes, *, computes: bool) -> None:
        """Sends the commands of a capture that only read, and compares the answers.

        Args:
            capture: A capture of the virtual brick.
            computes: Whether to send also what only computes.
        """
        allowed = frozenset({Harm.COMPUTING} if computes else ())
        events = read(CaptureFile(io.BytesIO(capture))).events()
        found = [step for step, harms in plan(steps(dialogues(events)), allowed) if not harms]
        self._ask(questions.SYSTEM, lambda system: self._know(firmware=system.fw_version))
        self._comparison = Comparison(self, found, self._carrier, allowed)
        self._comparison.next()
        self._advance()

    def end_comparison(self) -> None:
        """Ends a comparison early."""
        if self._comparison is not None:
            self._comparison.end("cancelled")

    def tell(self, **news: Any) -> None:
        """Tells the page."""
        self._tell(json.dumps(news))

    @property
    def firmware(self) -> str | None:
        """The version of the firmware, if the brick was asked for it."""
        return self._facts.get("firmware")


class Comparison:
    """The commands of a capture, sent again one after the other, and the answers that differ."""

    def __init__(self, brick: RealBrick, found: list[Step], carrier: Carrier, allowed: frozenset[str]) -> None:
        self._brick = brick
        self._steps = found
        self._carrier = carrier
        self._replay = Replay(allowed)
        self._at = self._sent = 0
        self._silent = 0
        self._differences: list[dict[str, Any]] = []
        self._is_over = False

    def next(self) -> None:
        """Sends the next command, unless it turns out to do more than read."""
        if self._is_over:
            return
        if self._at == len(self._steps):
            self._brick.converse(self._replay.leave(), lambda *_: self.end(""))
            return
        if self._at % 10 == 0:
            self._brick.tell(comparing={"done": self._at, "count": len(self._steps)})
        self._brick.converse(self._replay.talk(self._steps[self._at]), self._take)

    def _take(self, outcome: Outcome, _: float, reason: str) -> None:
        if self._is_over:
            return
        step = self._steps[self._at]
        self._at += 1
        if outcome.harms:
            self.next()
            return
        self._sent += 1
        self._silent = self._silent + 1 if reason else 0
        frame, reply = outcome.frame, outcome.reply
        likeness, difference = compare(step, frame, reply, DIALECT)
        if likeness is not Likeness.SAME:
            self._differences.append(
                {
                    "command": plain_text(command_spans(step.command.message)),
                    "sent": frame.hex(),
                    "recorded": None if step.reply is None else step.reply.frame.hex(),
                    "answered": None if reply is None else reply.hex(),
                    "difference": difference,
                    "answer": "no answer" if reply is None else _summary(reply, frame),
                }
            )
        if self._silent == MOST_SILENT:
            self.end("the brick does not answer")
        self.next()

    def end(self, reason: str) -> None:
        """Ends it, and tells the result."""
        if self._is_over:
            return
        self._is_over = True
        text = f"{len(self._differences)} of {self._sent} answers differ"
        self._brick.tell(
            comparison={
                "ev3proto": VERSION,
                "carrier": str(self._carrier),
                "firmware": self._brick.firmware,
                "result": f"{text}; ended early: {reason}" if reason else text,
                "answers": self._sent,
                "differ": len(self._differences),
                "differences": self._differences,
            }
        )


TASKS: dict[str, Callable[[str, bytes], Task[Any]]] = {
    "list": lambda path, _: file_moves.list_dir(path),
    "fetch": lambda path, _: file_moves.upload(path),
    "put": lambda path, data: file_moves.download(data, path),
    "delete": lambda path, _: file_moves.delete(path),
}
"""What can be done with files."""

_USER_SLOT = SLOT.members["USER_SLOT"]
PANEL: dict[str, Callable[[str], list[Draft]]] = {
    "rename": lambda name: [com_set.set_brickname(name)],
    "start": lambda path: [
        file.load_image(_USER_SLOT, path, LV(0), LV(4)),
        program_start(_USER_SLOT, LV(0), LV(4), 0),
    ],
    "stop": lambda _: [program_stop(_USER_SLOT)],
}
"""What can be done with the brick and its programs, as operations."""

_PORTS = (*SENSOR_PORTS, *MOTOR_PORTS)
_TYPES_AND_MODES = Question(
    questions.SENSORS.operations, lambda values: list(zip(map(int, values[::2]), map(int, values[1::2]), strict=True))
)


def _as_json(value: Any) -> Any:
    """Returns what a task found: a folder's names, with sizes of files, or the bytes of a file in base64."""
    if isinstance(value, file_moves.Listing):
        return {"folders": value.folders, "files": [[each.name, each.size] for each in value.files]}
    return base64.b64encode(value).decode() if isinstance(value, bytes) else None


def _adopting(frame: bytes) -> Callable[[Session], Request]:
    """Returns the start of a command with its own counter."""
    return lambda session: session.adopt(frame)


def _again(frame: bytes) -> Callable[[Session], Request]:
    """Returns the start of a command with a new counter."""
    return lambda session: session.command(MessageType(Header.read(frame).type), frame[HEADER_SIZE:])


def _tree(reply: bytes, command: bytes | None) -> list[Spans]:
    dialogue = Dialogue()
    if command is not None:
        dialogue.follow(parse(command, strict=False))
    return list(tree(dialogue.follow(parse(reply, strict=False)), Seen()))


def _summary(reply: bytes, command: bytes) -> str:
    return "; ".join(plain_text(line).strip() for line in _tree(reply, command))


def _values(prepared: Prepared, frame: bytes, reply: bytes | None) -> list[Value] | None:
    """Returns the values in a reply; None for an error."""
    if reply is None:
        return None
    try:
        values = prepared.result(frame, reply)
    except LinkError:
        return None
    assert isinstance(values, list)
    return values


def shown(kind: int, mode: int, value: float) -> tuple[str, str]:
    """Returns what a device is called, and its value with the decimals that the brick shows."""
    device = DEVICE_TYPES.get(kind)
    title = f"type {kind}" if device is None else device.title
    if value != value:
        return title, "-"
    if device is None or not 0 <= mode < len(device.modes):
        return title, f"{value:g}"
    chosen = device.modes[mode]
    unit = chosen.labels[0].unit if chosen.labels else ""
    return title, f"{value:.{chosen.decimals}f} {unit}".strip()
