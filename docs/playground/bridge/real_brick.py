"""A session with a real brick. JavaScript moves the bytes; what they mean is decided by ev3proto's own session."""

from __future__ import annotations

import base64
import json
from collections.abc import Callable, Iterator
from typing import Any

from ev3proto.checking.checking import check
from ev3proto.compose import Draft
from ev3proto.link import file_moves
from ev3proto.link.commands import SyncMode, direct
from ev3proto.link.errors import LinkError
from ev3proto.link.file_moves import Task
from ev3proto.link.policy import Outcome, Policy, Talk
from ev3proto.messages import LV
from ev3proto.ops import com_set, file, output_stop, program_start, program_stop
from ev3proto.schema.frame import parse
from ev3proto.schema.header import build_frame, frame_size
from ev3proto.semantics.transfers import Listing
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.enumerations import SLOT
from ev3proto.tables.frame import MAX_FRAME
from ev3proto.tables.ports import MotorPorts
from ev3proto.text.phrases import command_spans
from ev3proto.text.spans import Role, Spans

from .comparing import Comparison, reply_lines
from .connection import Connection, Listener
from .rows import pieces
from .watching import DIALECT, Watch

PROGRAM = "/home/root/lms2012/prjs/playground/playground.rbf"
"""Where a program of the input is written on a brick."""

MOST_ANSWERS = 100
"""Answers that are shown."""


class RealBrick:
    """What the page does with a brick: commands of the input, files, programs, a panel, a comparison.

    connection  to the brick
    """

    def __init__(self, carrier: str, carry: Callable[[str], object], tell: Callable[[str], object]) -> None:
        """Begins a session.

        Args:
            carrier: "usb" or "bluetooth".
            carry: Takes a frame for the brick, in hex.
            tell: Takes news for the page, as JSON.
        """
        self._news = tell
        self.connection = Connection(Carrier(carrier), Listener(carry, self._late, self._unasked, self._wrong))
        self._watch = Watch(self.connection, self._tell)
        self._policy = Policy()
        self._answers: list[list[Spans]] = []
        self._left = self._turn = 0
        self._comparison: Comparison | None = None

    def _tell(self, **news: Any) -> None:
        self._news(json.dumps(news))

    # Bytes and time

    def sent(self, at: float) -> None:
        """Takes the time at which a frame was carried: see `Connection.sent`."""
        self.connection.sent(at)

    def heard(self, data: bytes, at: float) -> None:
        """Takes bytes from the brick, and when they came: see `Connection.heard`."""
        self.connection.heard(data, at)

    def record(self) -> str:
        """Returns what was said to and by the brick, as pcapng in base64."""
        return base64.b64encode(self.connection.recording()).decode()

    def turn(self) -> None:
        """Lets time pass."""
        self._watch.turn()
        self.connection.turn()

    def watch(self, is_wanted: bool) -> None:
        """Begins or ends asking for name, firmware, battery and ports every second."""
        self._watch.want(is_wanted)
        self.turn()

    def gone(self, reason: str) -> None:
        """Ends the session; its recording stays."""
        if not self.connection.is_open:
            return
        self._left = 0
        self._watch.want(False)
        self.end_comparison(reason)
        self.connection.close(reason)

    # Answers

    def _show(self, lines: list[Spans]) -> None:
        """Shows an answer below the ones before it."""
        self._answers = [*self._answers, lines][-MOST_ANSWERS:]
        self._show_all()

    def _show_all(self) -> None:
        shown = [[pieces(line) for line in answer] for answer in self._answers]
        self._tell(answers=shown, isWaiting=bool(self._left) or not self.connection.is_idle)

    def _say(self, frame: bytes, text: str, role: str = Role.ASIDE, reply: bytes | None = None) -> None:
        """Shows what came of a command."""
        lines = [] if reply is None else reply_lines(reply, frame)
        self._show([command_spans(parse(frame, strict=False)), [(text, role)], *lines])

    def _late(self, frame: bytes, reply: bytes, latency: float) -> None:
        self._say(frame, f"answered late, after {latency:.1f} ms:", reply=reply)

    def _unasked(self, frame: bytes) -> None:
        self._show([[("sent by the brick, unasked:", Role.HEADING)], *reply_lines(frame, None)])

    def _wrong(self, reason: str) -> None:
        self._show([[(reason, Role.FAULT)]])

    # Commands of the input

    def talk(self, given: str, is_allowed: bool) -> dict[str, Any]:
        """Sends what `Input.to_send` returned, as JSON; returns as `send` does."""
        wanted = json.loads(given)
        if wanted["error"]:
            return {"error": wanted["error"]}
        if wanted["program"] is not None:
            return self._run(bytes.fromhex(wanted["program"]), is_allowed=is_allowed)
        return self.send([bytes.fromhex(frame) for frame in wanted["frames"]], is_allowed=is_allowed)

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
            if self.connection.carrier is Carrier.USB and len(frame) > MAX_FRAME:
                return {"error": f"The frame has {len(frame)} bytes; USB carries {MAX_FRAME}."}
        asks = [] if is_allowed else list(dict.fromkeys(ask for frame in frames for ask in self._asks(frame)))
        if asks:
            return {"ask": asks}
        self._answers = []
        self._left = len(frames)
        self._turn += 1
        self._show_all()
        self._send_next(frames, self._turn, is_allowed=is_allowed)
        self.connection.advance()
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
        if not frames or not self.connection.is_open or turn != self._turn:
            return
        frame = frames[0]
        message = parse(frame, strict=False)

        def done(outcome: Outcome, latency: float, reason: str) -> None:
            self._left = max(0, self._left - 1)
            self._answered(frame, outcome, latency, reason)
            self._send_next(frames[1:], turn, is_allowed=is_allowed)

        self.connection.converse(self._policy.talk(message, is_allowed=is_allowed), done, message.counter)

    def _answered(self, frame: bytes, outcome: Outcome, latency: float, reason: str) -> None:
        if outcome.harms:
            text = " ".join(f"{name} {harm.text}." for harm, name in outcome.harms.items())
            self._say(frame, f"not sent: {text}", Role.FAULT)
        elif reason:
            self._say(frame, reason, Role.FAULT)
        elif outcome.reply is None:
            self._say(frame, "sent; it wants no answer")
        else:
            self._say(frame, f"answered after {latency:.1f} ms:", reply=outcome.reply)

    def stop_motors(self) -> None:
        """Stops all motors at once, before everything that waits, and forgets the commands that do."""
        self.connection.forget()
        self._left = 0
        self._turn += 1
        self.end_comparison()
        prepared = direct(output_stop(0, MotorPorts.ALL, True), 0, 0, SyncMode.STD, DIALECT)
        # It wants no reply, so it does not have to wait for that of another command.
        self._say(self.connection.send_at_once(prepared.kind, prepared.body), "sent; all motors stop")

    def leave(self) -> bool:
        """Closes files, and reads listings to their end. Returns whether there are any."""
        if not self.connection.is_open or not self._policy.has_open:
            return False
        # Before all else.
        self.connection.converse(self._policy.leave(), lambda *_: self._tell(hasLeft=True), counter=-1)
        self.connection.advance()
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

    def _run(self, image: bytes, *, is_allowed: bool) -> dict[str, Any]:
        """Writes a program on the brick and starts it; returns as `send` does."""
        if not is_allowed:
            return {"ask": [f"Writes {PROGRAM} on the brick, and starts it."]}
        self._move("put", PROGRAM, image, lambda: self.panel("start", PROGRAM, True))
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
            self._tell(files=said)
            if not said["error"]:
                then()

        self.connection.converse(talk(), done)
        self.connection.advance()

    def panel(self, action: str, text: str, is_allowed: bool) -> dict[str, Any]:
        """Does one of PANEL, as `send` sends a command: it asks first."""
        prepared = direct(PANEL[action](text), 0, 0, SyncMode.SYNC, DIALECT)
        return self.send([build_frame(prepared.kind, 0, prepared.body)], is_allowed=is_allowed)

    # The comparison with the virtual brick

    def compare(self, capture: bytes, computes: bool) -> None:
        """Sends the commands of a capture of the virtual brick that only read, and compares the answers.

        Args:
            capture: The capture.
            computes: Whether to send also what only computes.
        """
        self._watch.ask_firmware()
        self._comparison = Comparison(self.connection, self._watch, self._tell, capture, computes=computes)
        self._comparison.next()
        self.connection.advance()

    def end_comparison(self, reason: str = "cancelled") -> None:
        """Ends a comparison early."""
        if self._comparison is not None:
            self._comparison.end(reason)


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


def _as_json(value: Any) -> Any:
    """Returns what a task found: a folder's names, with sizes of files, or the bytes of a file in base64."""
    if isinstance(value, Listing):
        return {"folders": value.folders, "files": [[each.name, each.size] for each in value.files]}
    return base64.b64encode(value).decode() if isinstance(value, bytes) else None
