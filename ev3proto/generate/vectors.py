"""Test vectors for decoders in other languages: frames, and what each of them says.

The examples of the reference, the same frames with a byte changed, cut off or added, and replies with their commands.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from random import Random
from typing import Any

from ev3proto.dialogue import Exchange, values_of
from ev3proto.generate.pages.examples import example_of, system_example
from ev3proto.messages import DirectCommand
from ev3proto.schema.frame import parse
from ev3proto.tables import operations
from ev3proto.tables.daisy import SENSOR_DATA_SIZE, DaisySubCommand
from ev3proto.tables.declaration import DIALECTS
from ev3proto.tables.frame import LENGTH_FIELD, MessageType
from ev3proto.tables.system import SYSTEM
from ev3proto.text.json_format.from_messages import record
from ev3proto.text.phrases import Seen

FILE_NAME = "ev3-vectors.jsonl"

_COUNTER = b"\1\0"
_MOST_FIELDS = 12
"""Bytes after the status of a reply to a system command."""


def build() -> str:
    """Returns the text of ev3-vectors.jsonl: an object a line, with `frame`, `request` of a reply, and `message`."""
    return "".join(f"{json.dumps(vector)}\n" for vector in _vectors())


def _vectors() -> Iterator[dict[str, Any]]:
    random = Random(1)
    commands = [example_of(each, DIALECTS[0]).frame for each in operations(DIALECTS[0]).values()]
    others = [*(system_example(entry).frame for entry in SYSTEM), *_system_replies(random), *_daisy_frames(random)]
    for frame in (*commands, *others):
        yield _vector(frame)
        yield _vector(_damaged(frame, random))
    for request in commands:
        message = parse(request, expect=DirectCommand)
        if message.global_size:
            yield _vector(_framed(MessageType.DIRECT_REPLY, random.randbytes(message.global_size)), request)


def _vector(frame: bytes, request: bytes | None = None) -> dict[str, Any]:
    message = parse(frame, strict=False)
    asked = None if request is None else parse(request)
    said = record(Exchange(message, asked, values_of(message, asked)), Seen())
    return {"frame": frame.hex(), **({"request": request.hex()} if request else {}), "message": said}


def _framed(kind: MessageType, contents: bytes) -> bytes:
    body = _COUNTER + bytes((kind,)) + contents
    return len(body).to_bytes(LENGTH_FIELD, "little") + body


def _system_replies(random: Random) -> Iterator[bytes]:
    for entry in SYSTEM:
        for kind, status in ((MessageType.SYSTEM_REPLY, 0), (MessageType.SYSTEM_REPLY_ERROR, 1)):
            fields = random.randbytes(random.randrange(_MOST_FIELDS))
            yield _framed(kind, bytes((entry.number, status)) + fields)


def _daisy_frames(random: Random) -> Iterator[bytes]:
    for command in DaisySubCommand:
        yield _framed(MessageType.DAISY_COMMAND_REPLY, bytes((command, 0, 1)) + bytes.fromhex("81010160"))
    for size in (0, 4, SENSOR_DATA_SIZE + 8):
        yield _framed(MessageType.DAISY_REPLY, b"\1\0" + random.randbytes(size))


def _damaged(frame: bytes, random: Random) -> bytes:
    """Returns a frame with a byte changed, cut off or added; the length field of some is right all the same."""
    at = random.randrange(LENGTH_FIELD, len(frame))
    damaged = (
        frame[:at],
        frame[:at] + random.randbytes(1) + frame[at + 1 :],
        frame + random.randbytes(2),
    )[random.randrange(3)]
    if random.randrange(2):
        return damaged
    return (len(damaged) - LENGTH_FIELD).to_bytes(LENGTH_FIELD, "little") + damaged[LENGTH_FIELD:]
