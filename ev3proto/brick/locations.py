"""Locations in memory: the place of a parameter's value, which is read and written there in every type.

Everything that programs can reach is a `bytearray`: global and local memory, the contents of arrays, the code itself.
A place is one of these and an offset. Nothing is read or written outside of it: that raises `WildAccess`.
"""

from __future__ import annotations

import struct
from collections.abc import Callable
from typing import Any

from ev3proto.brick.exits import WildAccess
from ev3proto.tables.declaration import Type

_INTEGER8, _INTEGER16, _INTEGER32, _FLOAT = (struct.Struct(layout) for layout in ("<b", "<h", "<i", "<f"))
_BITS32 = struct.Struct("<I")

NOT_A_NUMBER = 0x7FC00000
"""The bits of the brick's own NaN."""


class Location:
    """The location of a value."""

    __slots__ = ("at", "buffer", "handle")

    def __init__(self, buffer: bytearray, at: int, handle: int = -1) -> None:
        self.buffer = buffer
        self.at = at  # offset in it
        # the array that the argument named by its handle, which can be resized; -1 for every other place
        self.handle = handle

    def __repr__(self) -> str:
        return f"<place {self.at} of {len(self.buffer)} bytes{f', handle {self.handle}' * (self.handle >= 0)}>"

    def moved(self, distance: int) -> Location:
        """Returns the place at a distance in bytes."""
        return Location(self.buffer, self.at + distance)

    def check(self, size: int) -> int:
        """Returns the offset. Raises WildAccess where this number of bytes does not fit."""
        if self.at < 0 or self.at + size > len(self.buffer):
            raise WildAccess
        return self.at

    # Numbers

    def read8(self) -> int:
        """Reads a DATA8."""
        return int(_INTEGER8.unpack_from(self.buffer, self.check(1))[0])

    def read16(self) -> int:
        """Reads a DATA16."""
        return int(_INTEGER16.unpack_from(self.buffer, self.check(2))[0])

    def read32(self) -> int:
        """Reads a DATA32."""
        return int(_INTEGER32.unpack_from(self.buffer, self.check(4))[0])

    def read_bits(self) -> int:
        """Reads four bytes as an unsigned number: the bits of a float."""
        return int(_BITS32.unpack_from(self.buffer, self.check(4))[0])

    def read_float(self) -> float:
        """Reads a DATAF."""
        return float(_FLOAT.unpack_from(self.buffer, self.check(4))[0])

    def write8(self, value: int) -> None:
        """Writes the low 8 bits of a number."""
        self.buffer[self.check(1)] = value & 0xFF

    def write16(self, value: int) -> None:
        """Writes the low 16 bits of a number."""
        at = self.check(2)
        self.buffer[at] = value & 0xFF
        self.buffer[at + 1] = value >> 8 & 0xFF

    def write32(self, value: int) -> None:
        """Writes the low 32 bits of a number."""
        _BITS32.pack_into(self.buffer, self.check(4), value & 0xFFFFFFFF)

    def write_float(self, value: float) -> None:
        """Writes a number, rounded to the nearest single; beyond their range infinity, and the brick's own NaN."""
        at = self.check(4)
        if value != value:
            _BITS32.pack_into(self.buffer, at, NOT_A_NUMBER)
            return
        try:
            _FLOAT.pack_into(self.buffer, at, value)
        except OverflowError:
            _FLOAT.pack_into(self.buffer, at, float("inf") if value > 0 else float("-inf"))

    # Texts and bytes

    def read_bytes(self, count: int) -> bytes:
        """Reads a number of bytes; none for a negative number."""
        if count <= 0:
            return b""
        at = self.check(count)
        return bytes(self.buffer[at : at + count])

    def write_bytes(self, data: bytes) -> None:
        """Writes bytes."""
        at = self.check(len(data))
        self.buffer[at : at + len(data)] = data

    def read_text(self, most: int | None = None) -> bytes:
        """Reads a text of at most this number of bytes, without its zero. Without a zero it ends with the memory."""
        if not 0 <= self.at <= len(self.buffer):
            raise WildAccess
        last = len(self.buffer) if most is None else min(self.at + most, len(self.buffer))
        end = self.buffer.find(0, self.at, last)
        return bytes(self.buffer[self.at : end if end >= 0 else last])

    def write_text(self, text: bytes) -> None:
        """Writes a text and its zero."""
        self.write_bytes(text + b"\0")

    def write_cut(self, text: bytes, room: int) -> None:
        """Writes a text and its zero, cut to a number of bytes: 0 writes nothing, a negative number does not cut."""
        if room:
            self.write_text(text[: room - 1] if room > 0 else text)


WRITERS: dict[Type, Callable[[Location, Any], None]] = {
    Type.DATA8: Location.write8,
    Type.DATA16: Location.write16,
    Type.HANDLE: Location.write16,
    Type.DATA32: Location.write32,
    Type.DATAF: Location.write_float,
}
"""How a value of each type with a size is written."""
