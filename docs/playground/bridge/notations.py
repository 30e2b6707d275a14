"""The frames of an input in the notations of programs."""

from __future__ import annotations

from collections.abc import Callable

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


class Notations:
    """The frames that are shown, and the number of all."""

    def __init__(self) -> None:
        self._frames: list[bytes] = []
        self._lesson: list[str] = []
        self._left = MOST_SHOWN
        self._count = 0

    def add(self, message: Message, frame: bytes) -> None:
        """Takes a frame."""
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
