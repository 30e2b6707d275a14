"""Messages that many tests send: a question, its reply, a sound; and frames from what people write."""

from __future__ import annotations

import struct

from ev3proto.schema.header import with_length


def voltage(counter: int) -> bytes:
    """UI_READ.GET_VBATT, which wants a reply: 10 bytes."""
    return struct.pack("<HHB", 8, counter, 0x00) + bytes.fromhex("0400 81 01 60")


def volts(counter: int, value: float = 7.5) -> bytes:
    """The reply to it: 9 bytes."""
    return struct.pack("<HHBf", 7, counter, 0x02, value)


def tone(counter: int) -> bytes:
    """SOUND.TONE, without a reply: 16 bytes."""
    return struct.pack("<HHB", 14, counter, 0x80) + bytes.fromhex("0000 94 01 01 82B801 82E803")


def frame_of(text: str) -> bytes:
    """Returns the frame that is written as `0x|06:00|2A:00|80|00:00|01|`, with or without its first two characters."""
    return bytes.fromhex(text.removeprefix("0x").replace("|", " ").replace(":", " "))


def raw(code: str, *, memory: int = 0, type: int = 0x80) -> bytes:
    """Returns the frame of a direct command with this code, written in hex."""
    return with_length(bytes((42, 0, type)) + memory.to_bytes(2, "little") + bytes.fromhex(code))
