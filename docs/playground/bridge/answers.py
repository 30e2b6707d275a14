"""The answers of a real brick as the page shows them, each below the ones before it."""

from __future__ import annotations

from collections.abc import Callable

from ev3proto.dialogue import Dialogue
from ev3proto.schema.frame import parse
from ev3proto.text.phrases import Seen, command_spans
from ev3proto.text.spans import Role, Spans
from ev3proto.text.tree import tree

from .words import pieces

MOST_ANSWERS = 100
"""Answers that are shown."""


class Answers:
    """What came of commands.

    left  the number of commands that wait for their answers
    """

    def __init__(self, tell: Callable[..., object], is_idle: Callable[[], bool]) -> None:
        """Takes what takes `answers` for the page, and what says whether the connection rests."""
        self._tell = tell
        self._is_idle = is_idle
        self._shown: list[list[Spans]] = []
        self.left = 0

    def begin(self, count: int) -> None:
        """Forgets the answers, and waits for those of a number of commands."""
        self._shown = []
        self.left = count
        self._tell_all()

    def of(self, frame: bytes, text: str, role: str = Role.ASIDE, reply: bytes | None = None) -> None:
        """Shows what came of a command."""
        lines = [] if reply is None else reply_lines(reply, frame)
        self._show([command_spans(parse(frame, strict=False)), [(text, role)], *lines])

    def late(self, frame: bytes, reply: bytes, latency: float) -> None:
        """Shows a reply that came too late."""
        self.of(frame, f"answered late, after {latency:.1f} ms:", reply=reply)

    def unasked(self, frame: bytes) -> None:
        """Shows a frame that the brick sent by itself."""
        self._show([[("sent by the brick, unasked:", Role.HEADING)], *reply_lines(frame, None)])

    def wrong(self, reason: str) -> None:
        """Shows why a command could not be sent."""
        self._show([[(reason, Role.FAULT)]])

    def _show(self, lines: list[Spans]) -> None:
        self._shown = [*self._shown, lines][-MOST_ANSWERS:]
        self._tell_all()

    def _tell_all(self) -> None:
        shown = [[pieces(line) for line in answer] for answer in self._shown]
        self._tell(answers=shown, isWaiting=bool(self.left) or not self._is_idle())


def reply_lines(reply: bytes, command: bytes | None) -> list[Spans]:
    """Returns the lines of a reply, which its command explains if it is known."""
    dialogue = Dialogue()
    if command is not None:
        dialogue.follow(parse(command, strict=False))
    return list(tree(dialogue.follow(parse(reply, strict=False)), Seen()))
