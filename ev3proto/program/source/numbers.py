"""Numbers as they are written in sources, and strings with their escapes."""

from __future__ import annotations

import math
import struct

from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.source import BACKSLASH, ESCAPES, LEGO_ESCAPES

_SINGLE = struct.Struct("<f")
_BITS = struct.Struct("<i")
_LOWEST = -(1 << 31)
_PATTERNS = 1 << 32


def wrapped(value: int) -> int:
    """The lowest 32 bits as a number with a sign: 0xFFFFFFFF is -1."""
    return (value - _LOWEST) % _PATTERNS + _LOWEST


def pattern(value: int) -> int:
    """A number that was written, cut to 32 bits. From 0x80000000 on it is the bits that count, not the number."""
    return value % _PATTERNS if value >= 0 else wrapped(value)


def fits(value: int) -> bool:
    """Whether a number fits 32 bits with a sign."""
    return _LOWEST <= value < -_LOWEST


def single_bits(value: float) -> int:
    """The bits of the nearest single, as a number with a sign. ValueError where a single does not reach."""
    try:
        return int(_BITS.unpack(_SINGLE.pack(value))[0])
    except OverflowError:
        raise ValueError from None


def single_of(bits: int) -> float:
    """The number that the bits of a single mean."""
    return float(_SINGLE.unpack(_BITS.pack(wrapped(bits)))[0])


def is_finite(bits: int) -> bool:
    """Whether the bits of a single mean a number."""
    return math.isfinite(single_of(bits))


def strict_text(body: str, coding: str) -> bytes:
    """The bytes of a string of the strict dialect."""
    for escape, character in (*ESCAPES, BACKSLASH):
        body = body.replace(escape, character)
    return body.encode(coding)


def lego_text(body: str) -> bytes:
    """The bytes of a string of LEGO's dialect: of each character its low byte."""
    for escape, character in (*ESCAPES, *LEGO_ESCAPES):
        body = body.replace(escape, character)
    try:
        return body.encode(STRING_CODING)
    except UnicodeEncodeError:
        return bytes(ord(character) & 0xFF for character in body)
