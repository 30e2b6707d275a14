"""A real brick compared with the virtual one: commands of a capture that only read, sent again."""

from __future__ import annotations

import io
from collections.abc import Callable
from typing import Any

from ev3proto.capture import read
from ev3proto.capture.dialogues import dialogues
from ev3proto.capture.formats import CaptureFile
from ev3proto.link.harm import Harm
from ev3proto.link.policy import Outcome
from ev3proto.link.replay import Likeness, Replay, compare, plan, steps
from ev3proto.text.phrases import command_spans
from ev3proto.text.spans import plain_text
from ev3proto.version import VERSION

from .answers import reply_lines
from .connection import Connection
from .watching import DIALECT, Watch

MOST_SILENT = 3
"""Unanswered commands in a row after which a comparison ends."""


class Comparison:
    """The commands of a capture, sent again one after the other, and the answers that differ."""

    def __init__(
        self, connection: Connection, watch: Watch, tell: Callable[..., object], capture: bytes, *, computes: bool
    ) -> None:
        """Plans it for a capture of the virtual brick; `next` begins. `computes`: also send what only computes."""
        allowed = frozenset({Harm.COMPUTING} if computes else ())
        events = read(CaptureFile(io.BytesIO(capture))).events()
        self._steps = [step for step, harms in plan(steps(dialogues(events)), allowed) if not harms]
        self._connection = connection
        self._watch = watch
        self._tell = tell
        self._replay = Replay(allowed)
        self._at = self._sent = self._silent = 0
        self._differences: list[dict[str, Any]] = []
        self._is_over = False

    def next(self) -> None:
        """Sends the next command, unless it turns out to do more than read."""
        if self._is_over:
            return
        if self._at == len(self._steps):
            self._connection.converse(self._replay.leave(), lambda *_: self.end(""))
            return
        if self._at % 10 == 0:
            self._tell(comparing={"done": self._at, "count": len(self._steps)})
        self._connection.converse(self._replay.talk(self._steps[self._at]), self._take)

    def _take(self, outcome: Outcome, _: float, reason: str) -> None:
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
                    "answer": "no answer"
                    if reply is None
                    else "; ".join(plain_text(line).strip() for line in reply_lines(reply, frame)),
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
        self._tell(
            comparison={
                "ev3proto": VERSION,
                "carrier": str(self._connection.carrier),
                "firmware": self._watch.facts.get("firmware"),
                "result": f"{text}; ended early: {reason}" if reason else text,
                "answers": self._sent,
                "differ": len(self._differences),
                "differences": self._differences,
            }
        )
