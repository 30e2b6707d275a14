"""What a program with `verbosity` prints of each frame, byte for byte as the lessons show it."""

from __future__ import annotations

from datetime import datetime

from ev3proto.dialogue import Exchange
from ev3proto.messages import SystemReply
from ev3proto.schema.frame import parse
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.semantics.replies import values_of
from ev3proto.text.forms import as_hex
from ev3proto.text.phrases import command_spans, reply_spans
from ev3proto.text.spans import plain_text, visible

SENT, RECEIVED = "Sent", "Recv"

_HEADER_GROUPS = 4
"""`0x`, length, counter, type."""


def frame_line(direction: str, frame: bytes, now: datetime | None = None) -> str:
    """`09:12:31.011558 Sent 0x|0E:00|2A:00|80|00:00|D4:08:84:6D:79:45:56:33:00|`.

    Args:
        direction: SENT or RECEIVED.
        frame: The frame.
        now: When; None for the present time.
    """
    message = parse(frame, strict=False)
    text = as_hex(message)
    if isinstance(message, SystemReply) and len(frame) > HEADER_SIZE + 1:
        # The command answered and its status stand by themselves.
        command, status, rest = (part.hex(":").upper() for part in _parts(frame))
        text = "|".join([*text.split("|")[:_HEADER_GROUPS], command, status, *filter(None, (rest,)), ""])
    return f"{now or datetime.now():%H:%M:%S.%f} {direction} {text}"


def meaning_line(frame: bytes, request: bytes | None, dialect: str) -> str:
    """What a frame says, on one line.

    Args:
        frame: The frame.
        request: For a reply: the frame of its command.
        dialect: The firmware whose instruction set to read by.
    """
    message = parse(frame, strict=False, dialect=dialect)
    if request is None:
        return f"    {visible(plain_text(command_spans(message)))}"
    command = parse(request, strict=False, dialect=dialect)
    return f"    {visible(plain_text(reply_spans(Exchange(message, command, values_of(message, command)))))}"


def _parts(frame: bytes) -> tuple[bytes, bytes, bytes]:
    """Of a system reply: the command, its status, and what follows."""
    command, status, *_ = body = frame[HEADER_SIZE:]
    return bytes((command,)), bytes((status,)), body[2:]
