"""The answers of a real brick, as lines below each other."""

from __future__ import annotations

from typing import Any

from ev3proto.dialogue import Dialogue
from ev3proto.schema.frame import parse
from ev3proto.text.phrases import Seen, command_spans
from ev3proto.text.spans import Role, Spans
from ev3proto.text.tree import tree

from .rows import pieces

MOST_ANSWERS = 100
"""Answers that are shown."""


class Answers:
    """The answers to what was sent last."""

    def __init__(self) -> None:
        self._shown: list[list[Spans]] = []

    def clear(self) -> None:
        """Forgets all."""
        self._shown = []

    def add(self, lines: list[Spans]) -> None:
        """Adds an answer below the ones before it."""
        self._shown = [*self._shown, lines][-MOST_ANSWERS:]

    def said(self, frame: bytes, text: str, role: str = Role.ASIDE, reply: bytes | None = None) -> None:
        """Adds what came of a command: a sentence, and the reply if there is one."""
        lines = [] if reply is None else reply_lines(reply, frame)
        self.add([command_spans(parse(frame, strict=False)), [(text, role)], *lines])

    def as_json(self) -> list[Any]:
        """Returns them for JSON: the pieces of each line."""
        return [[pieces(line) for line in answer] for answer in self._shown]


def reply_lines(reply: bytes, command: bytes | None) -> list[Spans]:
    """Returns the lines of a reply, which its command explains if it is known."""
    dialogue = Dialogue()
    if command is not None:
        dialogue.follow(parse(command, strict=False))
    return list(tree(dialogue.follow(parse(reply, strict=False)), Seen()))
