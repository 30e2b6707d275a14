"""The short way for the plainest argument of all: the hex digits of one frame, as a command line is mostly given.

It needs none of the other forms, so a command that gets such an argument starts sooner. What it finds, the other forms
would find, too.
"""

from __future__ import annotations

from ev3proto.schema.header import HEADER_SIZE, frame_size, is_frame_size
from ev3proto.tables.frame import MessageType
from ev3proto.text.paste.pieces import MAX_TEXT, Pasted, short

_DIGITS = frozenset("0123456789abcdefABCDEF")
_TYPES = frozenset(MessageType)


def plain_frame(text: str) -> Pasted | None:
    """The frame that the digits of a text are; None for all that is not as plain, or whose length field does not fit.

    Between the bytes there may be a blank or a colon. Then one of them must have a letter: others may be decimal.
    """
    groups = text.replace(":", " ").split(" ")
    digits = "".join(groups)
    if not _DIGITS.issuperset(digits) or len(digits) % 2:
        return None
    if len(groups) > 1 and (digits.isdecimal() or any(len(group) != 2 for group in groups)):
        return None
    data = bytes.fromhex(digits)
    if len(data) < HEADER_SIZE or frame_size(data) != len(data) or not is_frame_size(len(data)):
        return None
    return Pasted(data, 1, short(text, MAX_TEXT)) if data[HEADER_SIZE - 1] in _TYPES else None
