"""A session with a real brick. JavaScript moves the bytes; what they mean is decided by ev3proto's own session."""

from __future__ import annotations

import base64
import json
from collections.abc import Callable
from typing import Any

from ev3proto.compose import Draft
from ev3proto.link import file_moves
from ev3proto.link.commands import SyncMode, direct
from ev3proto.link.errors import LinkError
from ev3proto.link.file_moves import Task
from ev3proto.link.policy import Outcome, Talk
from ev3proto.messages import LV
from ev3proto.ops import com_set, file, program_start, program_stop
from ev3proto.schema.frame import parse
from ev3proto.schema.header import build_frame
from ev3proto.semantics.transfers import Listing
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.enumerations import SLOT

from .answers import Answers
from .commands import Commands
from .comparing import Comparison
from .connection import Connection
from .watching import DIALECT, Watch

PROGRAM = "/home/root/lms2012/prjs/playground/playground.rbf"
"""Where a program of the input is written on a brick."""

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

FILES: dict[str, Callable[[str, bytes], Task[Any]]] = {
    "list": lambda path, _: file_moves.list_dir(path),
    "fetch": lambda path, _: file_moves.upload(path),
    "put": lambda path, data: file_moves.download(data, path),
    "delete": lambda path, _: file_moves.delete(path),
}
"""What can be done with files."""


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
        self._answers = Answers(self._tell, lambda: self.connection.is_idle)
        self.connection = Connection(Carrier(carrier), carry, self._answers)
        self._commands = Commands(self.connection, self._answers)
        self.send = self._commands.send
        self.sent = self.connection.sent
        self.heard = self.connection.heard
        self._watch = Watch(self.connection, self._tell)
        self._comparison: Comparison | None = None

    def _tell(self, **news: Any) -> None:
        self._news(json.dumps(news))

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
        self._answers.left = 0
        self._watch.want(False)
        self.end_comparison(reason)
        self.connection.close(reason)

    def leave(self) -> bool:
        """Closes files, and reads listings to their end. Returns whether there are any."""
        talk = self._commands.leave() if self.connection.is_open else None
        if talk is None:
            return False
        # Before all else.
        self.connection.converse(talk, lambda *_: self._tell(hasLeft=True), counter=-1)
        self.connection.advance()
        return True

    def stop_motors(self) -> None:
        """Stops all motors at once, before everything that waits, and forgets the commands that do."""
        self.end_comparison()
        self._commands.stop_motors()

    def talk(self, given: str, is_allowed: bool) -> dict[str, Any]:
        """Sends what `Frames.to_send` returned, as JSON; returns as `send` does."""
        wanted = json.loads(given)
        if wanted["error"]:
            return {"error": wanted["error"]}
        if wanted["program"] is None:
            return self.send([bytes.fromhex(frame) for frame in wanted["frames"]], is_allowed=is_allowed)
        if not is_allowed:
            return {"ask": [f"Writes {PROGRAM} on the brick, and starts it."]}
        self.files("put", PROGRAM, bytes.fromhex(wanted["program"]), lambda: self.panel("start", PROGRAM, True))
        return {}

    def panel(self, action: str, text: str, is_allowed: bool) -> dict[str, Any]:
        """Does one of PANEL, as `send` sends a command: it asks first."""
        prepared = direct(PANEL[action](text), 0, 0, SyncMode.SYNC, DIALECT)
        return self.send([build_frame(prepared.kind, 0, prepared.body)], is_allowed=is_allowed)

    def files(self, action: str, path: str, data: bytes, then: Callable[[], object] = lambda: None) -> None:
        """Does one of FILES with a path and what is written there, and if that succeeds, something else.

        The page hears what came of it: `action`, `path`, `error`, `result`.
        """
        task = FILES[action](path, data)
        said: dict[str, Any] = {"action": action, "path": path, "error": ""}

        def talk() -> Talk:
            try:
                command = next(task)
                while (reply := (yield command.build())) is not None:
                    command = task.send(parse(reply, strict=False))
                said["error"] = "the brick does not answer"
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

    # The comparison with the virtual brick

    def compare(self, capture: bytes, computes: bool) -> None:
        """Compares the answers to commands of a capture of the virtual brick that only read, or also `computes`."""
        self._watch.ask_firmware()
        self._comparison = Comparison(self.connection, self._watch, self._tell, capture, computes=computes)
        self._comparison.next()
        self.connection.advance()

    def end_comparison(self, reason: str = "cancelled") -> None:
        """Ends a comparison early."""
        if self._comparison is not None:
            self._comparison.end(reason)


def _as_json(value: Any) -> Any:
    """Returns what a task found: a folder's names, with sizes of files, or the bytes of a file in base64."""
    if isinstance(value, Listing):
        return {"folders": value.folders, "files": [[each.name, each.size] for each in value.files]}
    return base64.b64encode(value).decode() if isinstance(value, bytes) else None
