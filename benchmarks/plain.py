"""The yardstick: the simplest code that reads byte code.

It returns numbers and texts, without names, offsets, encodings or faults. The benchmark prints how much longer the
codec takes, which has all of those.
"""

from __future__ import annotations

import struct

from ev3proto.tables import operations
from ev3proto.tables.declaration import Type

_i16 = struct.Struct("<h").unpack_from
_u16 = struct.Struct("<H").unpack_from
_i32 = struct.Struct("<i").unpack_from
_u32 = struct.Struct("<I").unpack_from
_f32 = struct.Struct("<f").unpack_from
_header = struct.Struct("<HHBH").unpack_from

Plain = tuple[str, tuple[Type, ...], Type | None]

PLAIN: dict[int, Plain] = {}
FAMILIES: dict[int, dict[int, Plain]] = {}
for _entry in operations().values():
    _listed = None if _entry.tail is None else _entry.tail.element.type
    _shape = (_entry.name, tuple(parameter.type for parameter in _entry.fixed), _listed)
    if _entry.command is None:
        PLAIN[_entry.opcode.number] = _shape
    else:
        FAMILIES.setdefault(_entry.opcode.number, {})[_entry.command.number] = _shape


def argument(frame: bytes, at: int, kind: Type) -> tuple[object, int]:
    """Returns the value at an offset, and the offset after it."""
    first = frame[at]
    if first < 32:
        return first, at + 1
    if first < 64:
        return first - 64, at + 1
    if first < 128:
        return first & 31, at + 1
    width = first & 7
    if first & 64:
        if width == 1:
            return frame[at + 1], at + 2
        if width == 2:
            return _u16(frame, at + 1)[0], at + 3
        return _u32(frame, at + 1)[0], at + 5
    if width == 1:
        return (frame[at + 1] ^ 128) - 128, at + 2
    if width == 2:
        return _i16(frame, at + 1)[0], at + 3
    if width == 3:
        return (_f32 if kind is Type.DATAF else _i32)(frame, at + 1)[0], at + 5
    end = frame.index(0, at + 1)
    return frame[at + 1 : end], end + 1


def decode(frame: bytes) -> list[tuple[str, list[object]]]:
    """Returns the operations of a direct command: names and values."""
    length, _counter, _type, _memory = _header(frame)
    at, end = 7, length + 2
    found = []
    while at < end:
        code = frame[at]
        at += 1
        if code in PLAIN:
            name, kinds, listed = PLAIN[code]
        else:
            number, at = argument(frame, at, Type.DATA8)
            name, kinds, listed = FAMILIES[code][number]  # type: ignore[index]
        values: list[object] = []
        for kind in kinds:
            value, at = argument(frame, at, kind)
            values.append(value)
        if listed is not None:
            for _ in range(values[-1]):  # type: ignore[call-overload]
                value, at = argument(frame, at, listed)
                values.append(value)
        found.append((name, values))
    return found
