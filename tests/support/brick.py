"""Talking to a virtual brick in assembly."""

from __future__ import annotations

import re

from ev3proto.brick import Brick
from ev3proto.tables.frame import MessageType
from ev3proto.text.assembly import assemble

REPLY_HEADER = 5

_DECLARATION = re.compile(r"((?:local )?DATA\w+ \w+(?: \d+)?)(?=\s)")


class RefusedError(Exception):
    """The brick answered with an error; the text says what its memory holds."""


def ask(brick: Brick, text: str, seconds: float = 0.0) -> str:
    """Sends operations as one direct command and returns the reply's memory in hex, `busy` while there is no reply.

    Values that a careful sender avoids are sent, too: the brick has to cope with them.

    text     the operations; variables that are declared in it are what the reply brings; all may stand on one line
    seconds  how long to wait for a reply
    """
    (message,) = assemble(_DECLARATION.sub(r"\1\n", text), reply=True, unchecked=True)
    frame = message.build()
    replies = brick.receive(frame)
    return answer(replies or brick.advance(seconds))


def answer(replies: list[bytes]) -> str:
    """The memory that the one reply brings, in hex; `busy` where there is none."""
    if not replies:
        return "busy"
    (reply,) = replies
    memory = reply[REPLY_HEADER:].hex(" ")
    if reply[REPLY_HEADER - 1] != MessageType.DIRECT_REPLY:
        raise RefusedError(memory)
    return memory
