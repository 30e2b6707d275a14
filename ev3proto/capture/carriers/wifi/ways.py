"""Which way the data of a connection go, where somebody named the ports of both its ends."""

from __future__ import annotations

from ev3proto.schema.header import HEADER_SIZE, unpack_header
from ev3proto.tables.discovery import ACCEPT
from ev3proto.tables.frame import MessageType

# Bricks in a chain answer each other both ways.
_REPLIES = frozenset(member.value for member in MessageType if not member.is_command and member.carries != "daisy")


def goes_to_brick(data: bytes) -> bool:
    """Whether data go to the brick: all but replies, and its answer to the unlock text.

    Args:
        data: The first that were seen of a direction.

    Returns:
        What they begin with tells it; where nothing does, they are a command's.

    """
    if data.startswith(ACCEPT):
        return False
    return len(data) < HEADER_SIZE or unpack_header(data, 0)[2] not in _REPLIES
