"""Transfers in a capture: what the brick has answered of them."""

from __future__ import annotations

from ev3proto.capture.dialogues import is_error
from ev3proto.capture.record import Record
from ev3proto.dialogue import Transfer
from ev3proto.messages import SystemCommand
from ev3proto.semantics.transfers import UPLOADS, piece_of, step_of


class Moved:
    """A transfer and the brick's answers so far.

    failure     the newest reply that reports an error
    unanswered  as `unanswered_after` has it
    """

    def __init__(self, transfer: Transfer) -> None:
        """Starts before the first message."""
        self.transfer = transfer
        self.failure: Record | None = None
        self.unanswered: Record | None = None

    def add(self, record: Record) -> None:
        """Takes the next message."""
        if is_error(record.message):
            self.failure = record
        self.unanswered = unanswered_after(record, self.unanswered)

    @property
    def is_complete(self) -> bool:
        """Whether all of it was transferred, and the brick answered the last piece if that wanted a reply."""
        last = None if self.transfer.command in UPLOADS else self.unanswered
        return self.transfer.is_complete and self.failure is None and not (last and last.message.wants_reply)


def unanswered_after(record: Record, before: Record | None) -> Record | None:
    """Returns the command with the last piece of a file, or that began it, that the brick has not answered.

    Args:
        record: The next message of the transfer.
        before: What this returned for the message before it, None at first.
    """
    message = record.message
    if isinstance(message, SystemCommand):
        return record if step_of(message) == "begin" or piece_of(message) else before
    return None if record.request is None or record.request is before else before
