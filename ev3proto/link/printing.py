"""The log line of each frame, and the output for `verbosity`, byte for byte as in the lessons."""

from __future__ import annotations

import logging
from collections.abc import Callable
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

LOGGER = logging.getLogger("ev3proto.link")
"""The logger of all frames, at the level DEBUG."""

VERBOSITIES = (0, 1, 2)
"""Print nothing; frames; frames and their meaning."""

_HEADER_GROUPS = 4
"""`0x`, length, counter, type."""


def known_verbosity(value: int) -> int:
    """Returns the same value. Raises ValueError for values outside VERBOSITIES."""
    if value not in VERBOSITIES:
        raise ValueError(f"verbosity must be 0, 1 or 2, not {value!r}")
    return value


def frame_printer(direction: str, level: int, request: bytes | None, dialect: str) -> Callable[[bytes], None] | None:
    """Returns a function that logs a frame and prints it, at level 2 with its meaning; None if it does neither."""
    is_logged = LOGGER.isEnabledFor(logging.DEBUG)
    if not (level or is_logged):
        return None

    def show(frame: bytes) -> None:
        line = frame_line(direction, frame)
        if is_logged:
            LOGGER.debug("%s", line)
        if level:
            print(f"{datetime.now():%H:%M:%S.%f} {line}")
        if level > 1:
            print(meaning_line(frame, request, dialect))

    return show


def frame_line(direction: str, frame: bytes) -> str:
    """Returns `Sent 0x|0E:00|2A:00|80|00:00|D4:08:84:6D:79:45:56:33:00|`."""
    message = parse(frame, strict=False)
    text = as_hex(message)
    if isinstance(message, SystemReply) and len(frame) > HEADER_SIZE + 1:
        # The answered command and its status are groups of their own.
        body = frame[HEADER_SIZE:]
        groups = (part.hex(":").upper() for part in (body[:1], body[1:2], body[2:]) if part)
        text = "|".join([*text.split("|")[:_HEADER_GROUPS], *groups, ""])
    return f"{direction} {text}"


def meaning_line(frame: bytes, request: bytes | None, dialect: str) -> str:
    """Returns the meaning of a frame on one line; for a reply, `request` is the frame of its command."""
    message = parse(frame, strict=False, dialect=dialect)
    if request is None:
        return f"    {visible(plain_text(command_spans(message)))}"
    command = parse(request, strict=False, dialect=dialect)
    return f"    {visible(plain_text(reply_spans(Exchange(message, command, values_of(message, command)))))}"
