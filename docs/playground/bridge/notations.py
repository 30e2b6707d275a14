"""The frames of an input in the notations of programs, and those that are sent to a brick."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ev3proto.dialogue import Exchange
from ev3proto.messages import Message
from ev3proto.schema.frame import parse
from ev3proto.text.assembly.disassembly import assembly
from ev3proto.text.forms import as_c, as_hex, as_python
from ev3proto.text.phrases import LEGO, spaced_hex

MOST_SHOWN = 200_000
"""Maximum characters of the frames in a notation."""

FEW = 200
"""Frames whose notations are in the answer; those of more are rendered when they are opened."""

MOST_SENT = 100
"""Maximum number of frames sent to a brick at once."""

LESSON = "lesson"
FORMS: dict[str, Callable[[Message, str], str]] = {
    LESSON: lambda message, _: as_hex(message),
    "hex": lambda message, _: spaced_hex(message.build()),
    "javascript": lambda message, name: (
        f"const {name} = new Uint8Array([{', '.join(f'0x{byte:02x}' for byte in message.build())}]);"
    ),
    "c": as_c,
    "python": as_python,
    "operations": lambda message, _: "\n".join(list(assembly(Exchange(message), "", LEGO))[1:]),
}


class Frames:
    """The frames that are shown, the commands that are sent, and the numbers of all.

    image  of the program, which is sent in their place
    """

    def __init__(self) -> None:
        self.image: bytes | None = None
        self._commands: list[bytes] = []
        self._commands_in_all = 0
        self._frames: list[bytes] = []
        self._lesson: list[str] = []
        self._left = MOST_SHOWN
        self._count = 0

    def add(self, message: Message, frame: bytes) -> None:
        """Takes a frame, which is sent if it is a command."""
        if message.type is not None and message.type.is_command:
            self._commands_in_all += 1
            if len(self._commands) < MOST_SENT:
                self._commands.append(frame)
        self._count += 1
        if self._left > 0:
            self._frames.append(frame)
            self._lesson.append(as_hex(message))
            self._left -= len(self._lesson[-1]) + 1

    def made(self, form: str) -> str:
        """Returns the frames in a notation, as far as they are shown."""
        found, left = (self._lesson, 0) if form == LESSON else ([], MOST_SHOWN)
        for number, frame in enumerate(self._frames if left else (), 1):
            if left >= 0:
                name = f"frame_{number}" if self._count > 1 else "frame"
                found.append(FORMS[form](parse(frame, strict=False), name))
                left -= len(found[-1]) + 1
        more = self._count - len(found)
        last = [f"... and {more} more frames; ev3proto on the command line shows all"] * (found != [] and more > 0)
        return "\n".join([*found, *last])

    def all(self, *, is_whole: bool) -> dict[str, str]:
        """Returns the frames in the lesson's notation, and if they are few, in all."""
        forms = FORMS if is_whole and len(self._frames) <= FEW else (LESSON,)
        return {form: self.made(form) for form in forms}

    def to_send(self) -> dict[str, Any]:
        """Returns what is sent, for JSON: frames in hex and their number, or a program; and an error."""
        if self.image is not None:
            return {"frames": [], "count": 0, "program": self.image.hex(), "error": ""}
        frames = [frame.hex() for frame in self._commands]
        error = "" if frames else "The input has no command to send."
        return {"frames": frames, "count": self._commands_in_all, "program": None, "error": error}
