"""Commands that move files and listings: their directions, and the bytes that a message carries."""

from __future__ import annotations

from ev3proto.capture.record import Record
from ev3proto.messages import Message, SystemCommand, SystemReply
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.system import SYSTEM, SYSTEM_BY_NUMBER, FieldKind, SystemDeclaration


def _answers_with(kind: FieldKind) -> frozenset[str]:
    return frozenset(
        entry.name
        for entry in SYSTEM
        if entry.transfer is not None and any(field.kind is kind for field in entry.reply)
    )


LISTINGS = _answers_with(FieldKind.LISTING)
"""The commands that move listings of folders."""

UPLOADS = _answers_with(FieldKind.DATA) | LISTINGS
"""The commands that move data from the brick; the others move files to it."""


def entry_of(message: Message) -> SystemDeclaration | None:
    """Returns the tables' entry of a system message's command; None for other messages and unknown commands."""
    return SYSTEM_BY_NUMBER.get(message.number) if isinstance(message, SystemCommand | SystemReply) else None


def piece_of(message: Message) -> bytes:
    """Returns the bytes of a file or listing in a message, often none."""
    entry = entry_of(message)
    if entry is None or not isinstance(message, SystemCommand | SystemReply):
        return b""
    declared = entry.request if isinstance(message, SystemCommand) else entry.reply
    for field in declared:
        value = message.fields.get(field.name)
        if field.kind is FieldKind.LISTING and isinstance(value, str):
            return value.encode(STRING_CODING)
        # The command that closes a file has data, too: its hash.
        if field.kind is FieldKind.DATA and isinstance(value, bytes) and entry.transfer != "close":
            return value
    return b""


def begins(message: Message) -> bool:
    """Returns whether a message is a command that begins a transfer."""
    entry = entry_of(message)
    return isinstance(message, SystemCommand) and entry is not None and entry.transfer == "begin"


def unanswered_after(record: Record, before: Record | None) -> Record | None:
    """Returns the command with the last piece of a file, or that began it, that the brick has not answered.

    Args:
        record: The next message of the transfer.
        before: What this returned for the message before it, None at first.
    """
    message = record.message
    if isinstance(message, SystemCommand):
        return record if begins(message) or piece_of(message) else before
    return None if record.request is None or record.request is before else before
