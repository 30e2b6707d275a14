"""The serial number of a brick, read on a new connection."""

from __future__ import annotations

import re
import time

from ev3proto.compose import command
from ev3proto.link.carriers.wire import Wire
from ev3proto.link.session import Answered, Session
from ev3proto.link.targets import Target
from ev3proto.ops import com_get
from ev3proto.schema.frame import parse
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.semantics.replies import values_of
from ev3proto.tables.enumerations import HWTYPE
from ev3proto.tables.frame import MessageType

_DIGITS = re.compile("[0-9a-f]{12}")
_UNKNOWN = "0" * 12
_ROOM = 13
_TURN = 0.1
_TIMEOUT = 2.0


def announced_number(target: Target, wire: Wire) -> str:
    """Returns the serial number by which a proxy is found: that of its brick, or zeros. Raises ConnectionLostError."""
    return target.serial_number or serial_number_of(wire) or _UNKNOWN


def serial_number_of(wire: Wire) -> str | None:
    """Returns a brick's serial number, 12 lower-case hex digits, or None. Raises ConnectionLostError."""
    asked = command(com_get.get_id(HWTYPE.members["HW_BT"], _ROOM), reply=True)
    session = Session()
    request = session.command(MessageType.DIRECT_COMMAND_REPLY, asked.build()[HEADER_SIZE:])
    wire.send(request.frame)
    deadline = time.monotonic() + _TIMEOUT
    while time.monotonic() < deadline:
        for event in session.feed(wire.receive(_TURN)):
            if isinstance(event, Answered):
                values = values_of(parse(event.frame, strict=False), parse(request.frame))
                text = str(values[0].value).lower() if values else ""
                return text if _DIGITS.fullmatch(text) else None
    return None
