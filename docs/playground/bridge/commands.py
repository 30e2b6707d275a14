"""Commands for a real brick: what has to be allowed first, and one sent after the other."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from ev3proto.checking.checking import check
from ev3proto.link.commands import SyncMode, direct
from ev3proto.link.policy import Outcome, Policy, Talk
from ev3proto.ops import output_stop
from ev3proto.schema.frame import parse
from ev3proto.schema.header import frame_size
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.frame import MAX_FRAME
from ev3proto.tables.ports import MotorPorts
from ev3proto.text.spans import Role

from .answers import Answers
from .connection import Connection
from .watching import DIALECT


class Commands:
    """The commands of the input, on their way."""

    def __init__(self, connection: Connection, answers: Answers) -> None:
        self._connection = connection
        self._answers = answers
        self._policy = Policy()
        self._turn = 0

    def send(self, frames: list[bytes], *, is_allowed: bool) -> dict[str, Any]:
        """Sends commands, which may do what is not on the list of reading operations if that `is_allowed`.

        Returns `error`, or `ask`: what they may do, if that has to be allowed first.
        """
        for frame in frames:
            if len(frame) != frame_size(frame):
                return {
                    "error": "The length field does not match: the brick would wait for the rest. See the findings."
                }
            if self._connection.carrier is Carrier.USB and len(frame) > MAX_FRAME:
                return {"error": f"The frame has {len(frame)} bytes; USB carries {MAX_FRAME}."}
        asks = [] if is_allowed else list(dict.fromkeys(ask for frame in frames for ask in self._asks(frame)))
        if asks:
            return {"ask": asks}
        self._turn += 1
        self._answers.begin(len(frames))
        self._send_next(frames, self._turn, is_allowed=is_allowed)
        self._connection.advance()
        return {}

    def stop_motors(self) -> None:
        """Stops all motors at once, before everything that waits, and forgets the commands that do."""
        self._connection.forget()
        self._answers.left = 0
        self._turn += 1
        prepared = direct(output_stop(0, MotorPorts.ALL, True), 0, 0, SyncMode.STD, DIALECT)
        # It wants no reply, so it does not have to wait for that of another command.
        self._answers.of(self._connection.send_at_once(prepared.kind, prepared.body), "sent; all motors stop")

    def leave(self) -> Talk | None:
        """Returns what closes files, and reads listings to their end; None if there are none."""
        return self._policy.leave() if self._policy.has_open else None

    def _asks(self, frame: bytes) -> Iterator[str]:
        """Yields what has to be allowed before a command is sent."""
        report = check(frame)
        if not report.accepted:
            yield f"The brick refuses it, and may have to be restarted: {report.findings[0].message}."
        for harm, name in self._policy.harms(parse(frame, strict=False)).items():
            yield f"{name} {harm.text}."

    def _send_next(self, frames: list[bytes], turn: int, *, is_allowed: bool) -> None:
        """Sends the first of some commands, and the others once it is answered, unless something else came between."""
        if not frames or not self._connection.is_open or turn != self._turn:
            return
        frame = frames[0]
        message = parse(frame, strict=False)

        def done(outcome: Outcome, latency: float, reason: str) -> None:
            self._answers.left = max(0, self._answers.left - 1)
            self._answered(frame, outcome, latency, reason)
            self._send_next(frames[1:], turn, is_allowed=is_allowed)

        self._connection.converse(self._policy.talk(message, is_allowed=is_allowed), done, message.counter)

    def _answered(self, frame: bytes, outcome: Outcome, latency: float, reason: str) -> None:
        if outcome.harms:
            text = " ".join(f"{name} {harm.text}." for harm, name in outcome.harms.items())
            self._answers.of(frame, f"not sent: {text}", Role.FAULT)
        elif reason:
            self._answers.of(frame, reason, Role.FAULT)
        elif outcome.reply is None:
            self._answers.of(frame, "sent; it wants no answer")
        else:
            self._answers.of(frame, f"answered after {latency:.1f} ms:", reply=outcome.reply)
