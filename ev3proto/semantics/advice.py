"""What to say about bytes that are not a frame: one sentence for each kind, the same in every room."""

from __future__ import annotations

import re

from ev3proto.semantics.identify import Identity, Kind
from ev3proto.system import writemailbox
from ev3proto.tables.strangers import LINES

_MAILBOX = "abc"
"""The mailbox of the example: the name that LEGO's Messaging block begins with."""
_MOST_QUOTED, _MOST_DIGITS, _MOST_SENT = 24, 300, 100

BARE = {
    Kind.NO_LENGTH: "this is a frame without its length bytes",
    Kind.HALF_LENGTH: "this is a frame whose length has one byte; it needs two, the low one first",
    Kind.OPERATIONS: "these are operations without the header of a frame",
}
"""What is said of bytes that lack a part of a frame."""
_SAID = {
    Kind.NXT: "this is a telegram of the NXT ({}), LEGO's earlier brick; an EV3 does not know it",
    Kind.HUB: "this is a message of LEGO's Wireless Protocol ({}), for hubs with Bluetooth Low Energy (its first byte"
    " counts all bytes, the second is the hub, the third the type); an EV3 does not know it",
    **BARE,
}
SLIPS = {
    "length-self": "this is a frame whose length counts its own two bytes",
    "length-swapped": "this is a frame whose length has its high byte first",
}
"""What is said about slips that the header shows."""
STATED = "the length field says that {stated} it, but there are {follow}"
SENT_WITH = {
    "length-self": f"{SLIPS['length-self']}: it says {{length}}, the size of all that was sent; the brick takes"
    " {more} bytes of the next one",
    "length-swapped": f"{SLIPS['length-swapped']}: it says {{length}}, but {{follow}} bytes follow it",
    "length": STATED.replace("{stated}", "{length} bytes follow"),
}
LEFT_OVER = "the frame before ends here by its length field, {bytes} before the end of what was sent"
"""What is said of such a frame in a stream, by the slip, and of the bytes after a frame in one packet."""
_ALSO = "all of it is a telegram of the NXT ({}), LEGO's earlier brick, and also this frame of an EV3"


def advice(found: Identity) -> str | None:
    """Returns a sentence about bytes that are not a frame; None for any other, and for one that was cut."""
    if found.kind is Kind.TEXT:
        return strange_line(found.name) or _of_text(found.name)
    if found.kind is Kind.DIGITS and found.frame is not None:
        size = len(found.frame)
        meant = found.frame.hex(" ").upper() if size <= _MOST_SENT else f"its {size} bytes"
        return f"this is the text {_cut(found.name, _MOST_DIGITS)!r}, a frame written as characters; send {meant}"
    if found.kind is Kind.SLIP:
        return SLIPS.get(found.name)
    return _SAID[found.kind].format(found.name) if found.kind in _SAID else None


def strange_line(line: str) -> str | None:
    """Returns what a line without a frame is about, as a sentence; None for any other."""
    for _, mark, pattern, says in LINES:
        if mark in line and re.search(pattern, line, re.IGNORECASE):
            return says
    return None


def other_reading(found: Identity) -> str | None:
    """Returns a sentence about a right frame of which all is a telegram of the NXT, too; None for any other."""
    return _ALSO.format(found.also) if found.also else None


def _of_text(text: str) -> str:
    """Returns the sentence about a text, with the frame that carries it to a mailbox."""
    said = f"this is the text {_cut(text, _MOST_QUOTED)!r}, not a frame; a Messaging block needs WRITEMAILBOX"
    if len(text) > _MOST_QUOTED:
        return said
    frame = writemailbox(_MAILBOX, text).build().hex(" ").upper()
    return f"{said}: for its mailbox {_MAILBOX!r}, send {frame}"


def _cut(text: str, limit: int) -> str:
    return text if len(text) <= limit else text[: limit - 1].rstrip() + "\u2026"
