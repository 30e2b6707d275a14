"""Mailboxes: where messages from other bricks and from computers arrive for programs."""

from __future__ import annotations

from dataclasses import dataclass, field

from ev3proto.tables.mailboxes import BOXES, MOST_CONTENT, MOST_NAME


@dataclass
class Mailbox:
    """One mailbox."""

    name: bytes = b""  # the name by which senders address it
    type: int = 0  # the type of its values, one of DATA_FORMAT
    is_open: bool = False  # whether a program has opened it
    # the buffer: each message overwrites the start of earlier ones; there is no queue
    content: bytearray = field(default_factory=lambda: bytearray(MOST_CONTENT))
    size: int = 0  # length of the latest message in bytes
    written: int = 0  # messages since it was opened
    read: int = 0  # number of times one was read

    @property
    def has_news(self) -> bool:
        """Whether there is an unread message."""
        return self.written != self.read


class Mailboxes:
    """All of them."""

    def __init__(self) -> None:
        self.close_all()

    def open(self, number: int, name: bytes, type: int) -> bool:
        """Opens an empty box. Returns False if it is already open."""
        if self.boxes[number].is_open:
            return False
        self.boxes[number] = Mailbox(name[:MOST_NAME], type, True)
        return True

    def deliver(self, name: bytes, content: bytes) -> None:
        """Delivers a message to the first box of that name, open or closed; drops it if there is none.

        A message longer than a box is cut, where the firmware overwrites the next box.
        """
        for box in self.boxes:
            if box.name == name:
                box.size = min(len(content), MOST_CONTENT)
                box.content[: box.size] = content[: box.size]
                box.written += 1
                return

    def close_all(self) -> None:
        """Closes all boxes and forgets their names, as the end of a user's program does."""
        self.boxes = [Mailbox() for _ in range(BOXES)]
