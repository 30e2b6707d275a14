"""The direction of a connection's data, if its ports do not tell it."""

from __future__ import annotations

from ev3proto.schema.header import HEADER_SIZE, unpack_header
from ev3proto.tables.discovery import ACCEPT, UNLOCK_REQUEST
from ev3proto.tables.frame import MessageType

_REQUEST = UNLOCK_REQUEST.encode()


def may_go_to_brick(member: MessageType) -> bool:
    """Returns whether messages of a type go to the brick. Bricks in a chain send commands both ways."""
    return member.is_command or member.carries == "daisy"


def may_come_from_brick(member: MessageType) -> bool:
    """Returns whether messages of a type come from the brick."""
    return not member.is_command or member.carries == "daisy"


_REPLIES = frozenset(member.value for member in MessageType if not may_go_to_brick(member))


def text_goes_to_brick(data: bytes) -> bool | None:
    """Returns whether the first data of a direction, if they are a text, go to the brick; None without a text."""
    if data.startswith(_REQUEST):
        return True
    return False if data.startswith(ACCEPT) else None


def frame_goes_to_brick(data: bytes) -> bool:
    """Returns whether the first data of a direction, without a text, go to the brick: all but replies do."""
    return len(data) < HEADER_SIZE or unpack_header(data, 0)[2] not in _REPLIES
