"""Messages that many tests send: a question, its reply, a sound."""

from __future__ import annotations

import struct


def voltage(counter: int) -> bytes:
    """UI_READ.GET_VBATT, which wants a reply: 10 bytes."""
    return struct.pack("<HHB", 8, counter, 0x00) + bytes.fromhex("0400 81 01 60")


def volts(counter: int, value: float = 7.5) -> bytes:
    """The reply to it: 9 bytes."""
    return struct.pack("<HHBf", 7, counter, 0x02, value)


def tone(counter: int) -> bytes:
    """SOUND.TONE, without a reply: 16 bytes."""
    return struct.pack("<HHB", 14, counter, 0x80) + bytes.fromhex("0000 94 01 01 82B801 82E803")
