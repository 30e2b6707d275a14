"""Which way the data of a connection go, where the ports of its ends do not tell, or tell otherwise."""

from __future__ import annotations

from ev3proto.schema.header import HEADER_SIZE, unpack_header
from ev3proto.tables.discovery import ACCEPT, UNLOCK_REQUEST
from ev3proto.tables.frame import MessageType

_REQUEST = UNLOCK_REQUEST.encode()

# Bricks in a chain answer each other both ways.
_REPLIES = frozenset(member.value for member in MessageType if not member.is_command and member.carries != "daisy")


def text_goes_to_brick(data: bytes) -> bool | None:
    """Whether a text goes to the brick, as the one that unlocks it does, or comes from it.

    Args:
        data: The first that were seen of a direction.

    Returns:
        None where they do not begin with a text.
    """
    if data.startswith(_REQUEST):
        return True
    return False if data.startswith(ACCEPT) else None


def goes_to_brick(data: bytes) -> bool:
    """Whether data go to the brick: all but replies, and its answer to the unlock text.

    Args:
        data: The first that were seen of a direction.

    Returns:
        What they begin with tells it; where nothing does, they are a command's.
    """
    if (told := text_goes_to_brick(data)) is not None:
        return told
    return len(data) < HEADER_SIZE or unpack_header(data, 0)[2] not in _REPLIES
