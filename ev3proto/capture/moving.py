"""The command of a transfer that the brick has not answered."""

from __future__ import annotations

from ev3proto.capture.record import Record
from ev3proto.messages import SystemCommand
from ev3proto.semantics.transfers import piece_of, step_of


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
