"""Frames as people make them by hand, with any counter, and the slips that they make."""

from __future__ import annotations

COMMANDS: dict[str, str] = {
    "nothing": "80 0000 01",
    "battery": "00 0400 81 01 60",
    "tone": "80 0000 94 01 01 82 b801 82 e803",
    "file": "80 0000 94 02 01 84 2e2f756900",
    "start motors": "80 0000 a4 00 05 81 32 a6 00 05",
    "stop motors": "80 0000 a3 00 0f 01",
    "turn": "80 0000 ae 00 01 81 32 00 82 6801 00 01",
    "steer": "80 0000 b0 00 06 81 32 81 c8 82 d002 01",
    "tacho count": "00 0400 b3 00 00 60",
    "touch sensor": "00 0400 99 1d 00 00 10 00 01 60",
    "infrared sensor": "00 0400 9a 00 03 00 02 60",
    "light": "80 0000 82 1b 02",
    "name": "00 0000 d4 08 84 6d794556335f3100",
    "variables": "00 0402 10 01 40 60 99 05 00 10 41 61",
    "text on the screen": "80 0000 84 05 01 00 0a 84 68656c6c6f00 84 00",
}
"""Direct commands from their type on: tones, motors, sensors, the screen."""

SYSTEM: dict[str, str] = {
    "list": "01 99 e803 2f686f6d652f726f6f742f00",
    "mailbox": "81 9e 04 61626300 0100 01",
    "number for a mailbox": "81 9e 05 73706565 6400 0400 0000 2041",
}

REPLIES: dict[str, str] = {
    "volts": "02 a470fd40",
    "sensor": "02 0000c841",
    "handle": "03 92 00 05",
}


def frame(contents: str, counter: int) -> bytes:
    """Returns a frame with its contents from the type on."""
    body = counter.to_bytes(2, "little") + bytes.fromhex(contents)
    return len(body).to_bytes(2, "little") + body


def with_length(data: bytes, length: int) -> bytes:
    """Returns a frame with another length field."""
    return length.to_bytes(2, "little") + data[2:]
