"""The serial terminal of a brick: the buffer that UI_WRITE fills, what of it was printed, and what is typed there."""

from __future__ import annotations

ROOM = 255
"""Bytes that the buffer holds; it is flushed when it is full."""

_MOST_PRINTED = 1 << 16
"""Bytes that are kept of what was printed: the last ones."""


class Terminal:
    """A terminal without anybody at it.

    text     what was written since the last flush
    printed  what was flushed while the terminal was on, the end of it
    is_on    whether what is flushed is printed
    typed    what somebody typed and no program has read
    """

    def __init__(self) -> None:
        self.text = bytearray()
        self.printed = bytearray()
        self.is_on = False
        self.typed = bytearray()

    def write(self, text: bytes) -> None:
        """Gathers text; whenever the buffer is full it is flushed."""
        while text:
            room = ROOM - len(self.text)
            self.text += text[:room]
            text = text[room:]
            if len(self.text) >= ROOM:
                self.flush()

    def flush(self) -> None:
        """Prints the buffer if the terminal is on, and empties it."""
        if self.is_on:
            self.printed += self.text
            del self.printed[:-_MOST_PRINTED]
        self.text.clear()

    def take_key(self) -> int:
        """The next character typed; 0 when there is none."""
        return self.typed.pop(0) if self.typed else 0

    def take_line(self) -> bytes | None:
        """The next line typed, without its end; None while there is none."""
        end = next((index for index, character in enumerate(self.typed) if character in b"\r\n"), None)
        if end is None:
            return None
        line = bytes(self.typed[:end])
        del self.typed[: end + 1]
        return line
