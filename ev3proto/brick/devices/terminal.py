"""The serial terminal of a brick: the buffer that UI_WRITE fills, the printed part of it, and what is typed there."""

from __future__ import annotations

ROOM = 255
"""Bytes that the buffer holds; it is flushed when it is full."""

_MOST_PRINTED = 1 << 16
"""Maximum number of printed bytes that are kept, the latest ones."""


class Terminal:
    """A terminal without a user."""

    def __init__(self) -> None:
        self.text = bytearray()  # what was written since the last flush
        self.printed = bytearray()  # the last part of what was flushed while the terminal was on
        self.is_on = False  # whether flushing prints
        self.typed = bytearray()  # typed, but not yet read by a program

    def write(self, text: bytes) -> None:
        """Gathers text; whenever the buffer is full it is flushed."""
        at = 0
        while at < len(text):
            room = ROOM - len(self.text)
            self.text += text[at : at + room]
            at += room
            if len(self.text) >= ROOM:
                self.flush()

    def flush(self) -> None:
        """Prints the buffer if the terminal is on, and empties it."""
        if self.is_on:
            self.printed += self.text
            del self.printed[:-_MOST_PRINTED]
        self.text.clear()

    def take_key(self) -> int:
        """Returns the next typed character; 0 without one."""
        return self.typed.pop(0) if self.typed else 0

    def take_line(self) -> bytes | None:
        """Returns the next typed line, without its end; None while it is incomplete."""
        end = next((index for index, character in enumerate(self.typed) if character in b"\r\n"), None)
        if end is None:
            return None
        line = bytes(self.typed[:end])
        del self.typed[: end + 1]
        return line
