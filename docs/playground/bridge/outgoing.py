"""What an input has to send to a brick."""

from __future__ import annotations

from typing import Any

from ev3proto.messages import Message

MOST_SENT = 100
"""Maximum number of frames sent to a brick at once."""


class Outgoing:
    """The commands of an input, or its program.

    image  of the program
    """

    def __init__(self) -> None:
        self.image: bytes | None = None
        self._commands: list[bytes] = []
        self._count = 0

    def add(self, message: Message, frame: bytes) -> None:
        """Takes a frame, which is sent if it is a command."""
        if message.type is not None and message.type.is_command:
            self._count += 1
            if len(self._commands) < MOST_SENT:
                self._commands.append(frame)

    def answer(self) -> dict[str, Any]:
        """Returns it for JSON: frames in hex and their number, or a program; and an error."""
        is_program = self.image is not None
        return {
            "frames": [] if is_program else [frame.hex() for frame in self._commands],
            "count": 0 if is_program else self._count,
            "program": None if self.image is None else self.image.hex(),
            "error": "" if is_program or self._commands else "The input has no command to send.",
        }
