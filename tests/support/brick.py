"""Talking to a virtual brick in assembly."""

from __future__ import annotations

import re

from ev3proto.brick import Brick
from ev3proto.tables.frame import MessageType
from ev3proto.text.assembly import assemble

REPLY_HEADER = 5

_DECLARATION = re.compile(r"((?:local )?DATA\w+ \w+(?: \d+)?)(?=\s)")


class RefusedError(Exception):
    """The brick answered with an error; the message has its memory."""


def ask(brick: Brick, text: str, seconds: float = 0.0) -> str:
    """Sends operations as one direct command and returns the reply's memory in hex, or `busy` if no reply comes.

    Values that a careful sender avoids are sent, too: the brick has to cope with them.

    text     the operations, also in one line; the reply brings the variables that are declared in it
    seconds  how long to wait for a reply
    """
    (message,) = assemble(_DECLARATION.sub(r"\1\n", text), reply=True, unchecked=True)
    frame = message.build()
    replies = brick.receive(frame)
    return answer(replies or brick.advance(seconds))


def answer(replies: list[bytes]) -> str:
    """Returns the memory in the only reply, in hex; `busy` without a reply."""
    if not replies:
        return "busy"
    (reply,) = replies
    memory = reply[REPLY_HEADER:].hex(" ")
    if reply[REPLY_HEADER - 1] != MessageType.DIRECT_REPLY:
        raise RefusedError(memory)
    return memory
