"""The replies to commands that a proxy does not forward: those of a brick that refuses or fails them."""

from __future__ import annotations

from ev3proto.messages import DaisyCommand, DirectCommand, Message, SystemCommand
from ev3proto.schema.fields import REPLIES
from ev3proto.schema.header import MOST_IN_REPLY, build_frame
from ev3proto.tables.frame import MessageType
from ev3proto.tables.system import SYSTEM_BY_NUMBER, FieldKind, SystemStatus

_NO_HANDLE = 0xFF


def refused(message: Message, status: SystemStatus) -> bytes | None:
    """Returns the error reply to a message; None if it wants none. `status` is for a system command."""
    if not message.wants_reply:
        return None
    if isinstance(message, SystemCommand):
        body = bytes((message.number, status)) + _fields(message.number)
        return build_frame(MessageType.SYSTEM_REPLY_ERROR, message.counter, body)
    if isinstance(message, DaisyCommand):
        body = bytes((message.layer_to, message.layer_from))
        return build_frame(MessageType.DAISY_REPLY_ERROR, message.counter, body)
    size = message.global_size if isinstance(message, DirectCommand) else 0
    return build_frame(MessageType.DIRECT_REPLY_ERROR, message.counter, bytes(min(size, MOST_IN_REPLY)))


def _fields(number: int) -> bytes:
    """Returns the fields after the status as the firmware fills them after an error: no handle, sizes of 0."""
    entry = SYSTEM_BY_NUMBER.get(number)
    given = {
        field.name: _NO_HANDLE if field.name == "handle" else 0
        for field in (() if entry is None else entry.reply)
        if field.kind in (FieldKind.U8, FieldKind.U32) and field.counts is None
    }
    return REPLIES[number].write_present(given) if given else b""
