"""Boundary values of every kind of parameter, each in a frame of its own, with what all readers must make of it.

The numbers and bytes are written out here from the description of the protocol; of the tables only what an entry
declares is used: type, direction, range, names, the longest text.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator
from functools import cache
from typing import Any, NamedTuple

from ev3proto import GV, LV, Variable
from ev3proto.tables import operations
from ev3proto.tables.declaration import DIALECTS, Declaration, Direction, Parameter, Role, Type

LIMITS = {Type.DATA8: 0x7F, Type.DATA16: 0x7FFF, Type.HANDLE: 0x7FFF, Type.DATA32: 0x7FFFFFFF}
"""The largest number of each type; the smallest is its negative, and the one below means "not a number"."""

NANS = {0x7F: "81 80", 0x7FFF: "82 00 80", 0x7FFFFFFF: "83 00 00 00 80"}
"""The bytes of that number, by the largest one."""

_FLOATS = {
    0.0: "83 00 00 00 00",
    1.5: "83 00 00 C0 3F",
    -2.0: "83 00 00 00 C0",
    3.4028234663852886e38: "83 FF FF 7F 7F",
    float("inf"): "83 00 00 80 7F",
    3.5e38: None,
}
_LONG_TEXT = 200
GLOBALS = 1019


class Boundary(NamedTuple):
    """One value of one parameter.

    entry    the operation
    position  of the parameter
    value    what a caller passes
    raw      the bytes of the argument, or those of count and elements; None: the builder refuses the value
    read     what is read from these bytes
    legal    whether the value means something to the brick, as the entry declares; None: not looked at
    values   one value for each parameter
    """

    entry: Declaration
    dialect: str
    position: int
    value: Any
    raw: bytes | None
    read: Any
    legal: bool | None
    values: tuple[Any, ...]

    @property
    def parameter(self) -> Parameter:
        """The declaration of the parameter."""
        return self.entry.parameters[self.position]

    @property
    def name(self) -> str:
        """A name for messages."""
        return f"{self.entry.name}.{self.parameter.name}={str(self.value)[:40]}"

    @property
    def code(self) -> bytes:
        """The operation: opcode, CMD, arguments."""
        head = bytes((self.entry.opcode.number,))
        if self.entry.command is not None:
            head += number(self.entry.command.number)
        return head + self.arguments

    @property
    def arguments(self) -> bytes:
        """The arguments, in their shortest encodings."""
        assert self.raw is not None
        pieces = [_encoded(value) for value in self.values]
        pieces[self.position] = self.raw
        if self.entry.parameters[-1].is_list and not self.entry.parameters[-1].counts:
            del pieces[-2]  # the list begins with its count
        return b"".join(pieces)

    @property
    def before(self) -> int:
        """The number of bytes of the operation before the argument."""
        return self.code.rindex(self.arguments) + sum(len(_encoded(value)) for value in self.values[: self.position])

    @property
    def frame(self) -> bytes:
        """A direct command with this operation alone, which requests as much global memory as a reply can carry."""
        return struct.pack("<HHBH", 5 + len(self.code), 42, 0, GLOBALS) + self.code


def number(value: int) -> bytes:
    """Returns a number as the shortest constant."""
    if -32 <= value <= 31:
        return bytes((value & 0x3F,))
    if -127 <= value <= 127:
        return struct.pack("<Bb", 0x81, value)
    if -32767 <= value <= 32767:
        return struct.pack("<Bh", 0x82, value)
    return struct.pack("<Bi", 0x83, value)


def _encoded(value: Any) -> bytes:
    if isinstance(value, Variable):
        head, long = (0x60, 0xE1) if value.scope == "global" else (0x40, 0xC1)
        return bytes((head | value.index,)) if value.index < 32 else bytes((long, value.index))
    if isinstance(value, str):
        return b"\x84" + value.encode("latin-1") + b"\0"
    if isinstance(value, float):
        return b"\x83" + struct.pack("<f", value)
    if isinstance(value, list):
        return number(len(value)) + b"".join(map(_encoded, value))
    return number(value)


def _usual(parameter: Parameter, place: int) -> Any:
    """Returns a legal value."""
    if parameter.is_list:
        return [] if parameter.counts else [0.0 if parameter.element is Type.DATAF else 1]
    if parameter.is_output or (parameter.length is not None and parameter.type is not Type.STRING):
        return GV(place)
    if parameter.type is Type.STRING:
        return "a"
    if parameter.type is Type.DATAF:
        return 1.0
    if parameter.enum is not None:
        return next(iter(parameter.enum.members.values()))
    return 1 if parameter.range is None else max(parameter.range[0], min(1, parameter.range[1]))


def kind_of(entry: Declaration, position: int) -> tuple[Any, ...]:
    """Returns what makes a parameter a case of its own."""
    parameter = entry.parameters[position]
    is_first = position == 0 and entry.command is None
    enum = None if parameter.enum is None else parameter.enum.name
    facts = (parameter.type, parameter.direction, parameter.range, enum, tuple(parameter.special), parameter.unsigned)
    listed = (parameter.element, parameter.elements, parameter.counts, parameter.any_type)
    return (*facts, *listed, parameter.validated, parameter.role, parameter.most, parameter.length is None, is_first)


@cache
def boundaries() -> tuple[Boundary, ...]:
    """Returns the boundary values of every kind of parameter."""
    found: list[Boundary] = []
    seen = set()
    for dialect in DIALECTS:
        for entry in operations(dialect).values():
            values = tuple(_usual(parameter, 4 * index) for index, parameter in enumerate(entry.parameters))
            for index, parameter in enumerate(entry.parameters):
                key = kind_of(entry, index)
                is_counter = entry.tail is not None and parameter is entry.tail.counter and not parameter.counts
                if key in seen or is_counter:
                    continue
                seen.add(key)
                for value, raw, read, legal in _cases(parameter):
                    found.append(Boundary(entry, dialect, index, value, raw, read, legal, values))
    return tuple(found)


_Case = tuple[Any, bytes | None, Any, bool | None]


def _cases(parameter: Parameter) -> Iterator[_Case]:
    if parameter.is_list:
        yield from _lists(parameter)
    elif parameter.direction is not Direction.IN:
        for scope, short, long in ((GV, 0x60, 0xE1), (LV, 0x40, 0xC1)):
            for index in (0, 31):
                yield scope(index), bytes((short | index,)), index, None
            for index in (32, 255):
                yield scope(index), bytes((long, index)), index, None
            yield scope(256), bytes((long + 1, 0, 1)), 256, None
            yield scope(65_535), bytes((long + 1, 0xFF, 0xFF)), 65_535, None
            yield scope(65_536), bytes((long + 2, 0, 0, 1, 0)), 65_536, None
            yield scope(0xFFFFFFFF), bytes((long + 2, *b"\xff" * 4)), 0xFFFFFFFF, None
            yield scope(1 << 32), None, None, None
            yield scope(-1), None, None, None
        is_refused = parameter.direction is Direction.OUT or parameter.type is Type.STRING
        yield 1, None if is_refused else b"\x01", 1, None
    elif parameter.type is Type.STRING:
        yield from _texts(parameter)
    elif parameter.type is Type.DATAF:
        for value, data in _FLOATS.items():
            yield value, None if data is None else bytes.fromhex(data), value, None
    elif parameter.type in LIMITS:
        yield from _numbers(parameter)
    elif parameter.type is Type.LABEL:
        for value in (0, 1, 31, 32):
            yield value, number(value), value, None


def _numbers(parameter: Parameter) -> Iterator[_Case]:
    high = LIMITS[parameter.type]
    is_plain = parameter.length is None and parameter.role not in (Role.JUMP, Role.LABEL)
    values = {-high, high, high + 1, 2 * high + 1, 2 * high + 2, -high - 2, 0, -1}
    values |= {at + step for at in (parameter.range or ()) for step in (-1, 0, 1)}
    if parameter.enum is not None:
        members = parameter.enum.members.values()
        values |= {min(members) - 1, min(members), max(members), max(members) + 1}
    for value in sorted(values):
        is_bits = parameter.unsigned and high < value <= 2 * high + 1
        read = value - 2 * high - 2 if is_bits else value
        if read == -high - 1:
            raw: bytes | None = bytes.fromhex(NANS[high])
        else:
            raw = number(read) if -high <= read <= high else None
        legal = _is_legal(parameter, read) if is_plain and -high <= value <= high else None
        yield value, raw, read, legal
    yield -high - 1, bytes.fromhex(NANS[high]), -high - 1, None


def _is_legal(parameter: Parameter, value: int) -> bool | None:
    if value in parameter.special:
        return True
    if parameter.range is not None:
        return parameter.range[0] <= value <= parameter.range[1]
    if parameter.enum is None:
        return True
    if value in parameter.enum.members.values():
        return True
    return None if parameter.enum.flags or any(name.endswith("_START") for name in parameter.enum.members) else False


def _texts(parameter: Parameter) -> Iterator[_Case]:
    yield "", b"\x84\0", "", None
    yield "a" * _LONG_TEXT, b"\x84" + b"a" * _LONG_TEXT + b"\0", "a" * _LONG_TEXT, None
    yield "\xff", b"\x84\xff\0", "\xff", None
    yield "\u0100", None, None, None
    yield "a\0", None, None, None
    if parameter.most is not None and not parameter.letters:
        for count in (parameter.most - 1, parameter.most):
            text = "a" * count
            yield text, b"\x84" + text.encode() + b"\0", text, count < parameter.most


def _lists(parameter: Parameter) -> Iterator[_Case]:
    element: Any = GV(0) if parameter.elements is not Direction.IN else 0.5 if parameter.element is Type.DATAF else 1
    for count in (0, 1, 31, 32, 127, 128):
        value = [element] * count
        raw = b"".join(map(_encoded, value))
        head = struct.pack("<Bh", 0x82, count) if count == 128 else number(count)
        is_possible = count <= 127 or not parameter.counts
        yield value, head + raw if is_possible else None, count, None
