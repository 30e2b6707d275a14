"""What replies say of the commands that they answer."""

from __future__ import annotations

from ev3proto.messages import Message, SystemReply


def is_error(message: Message) -> bool:
    """True for a reply that says that its command failed. END_OF_FILE is no failure, it is how a file ends."""
    if isinstance(message, SystemReply):
        return message.is_error
    return message.type is not None and message.type.is_error
