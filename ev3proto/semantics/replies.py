"""What a reply says, by name: its memory read by the outputs of the command it answers, or its own fields."""

from __future__ import annotations

import math
import struct
from collections.abc import Iterator
from typing import NamedTuple

from ev3proto.messages import DirectCommand, DirectReply, Message, SystemReply
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.semantics.footprint import UNTYPED_SIZE, Footprint, results
from ev3proto.tables.declaration import Type
from ev3proto.tables.encoding import RANGES, STRING_CODING
from ev3proto.tables.system import SYSTEM_BY_NUMBER, Kind

ValueType = int | float | str | bytes | list[int] | list[float]
"""What a value from a reply can be."""

_LAYOUTS = {
    kind: struct.Struct(layout)
    for kind, layout in (
        (Type.DATA8, "<b"),
        (Type.DATA16, "<h"),
        (Type.DATA32, "<i"),
        (Type.DATAF, "<f"),
        (Type.HANDLE, "<h"),
    )
}
_BY_SIZE = {1: Type.DATA8, 2: Type.DATA16, 4: Type.DATA32}
_NAN = {str(kind): RANGES[kind].nan for kind in _BY_SIZE.values()}


class Value(NamedTuple):
    """One value in a reply.

    op       opcode's name, or the system command's
    command  CMD's name, None where there is none
    name     the parameter's or field's name
    value    number, text, or list of numbers
    unit     as people write it, None where it has none
    type     what it is in memory: DATA8, DATAF, string, u32, ...
    symbol   name of the number in its enumeration, None where it has none
    offset   of its first byte in the reply's frame
    length   bytes in the reply's frame
    """

    op: str
    command: str | None
    name: str
    value: ValueType
    unit: str | None = None
    type: str = ""
    symbol: str | list[str | None] | None = None
    offset: int = 0
    length: int = 0

    @property
    def full_name(self) -> str:
        """`UI_READ.GET_VBATT`, or the name of an opcode or system command alone."""
        return f"{self.op}.{self.command}" if self.command else self.op

    @property
    def number(self) -> float:
        """The value where it is a number. Raises TypeError for a text, bytes or a list: `value` has those."""
        if isinstance(self.value, int | float):
            return self.value
        raise TypeError(f"{self.name} is no number: its value is {self.value!r}")

    @property
    def is_nan(self) -> bool:
        """True for the value by which the firmware says that there is none."""
        if isinstance(self.value, float):
            return math.isnan(self.value)
        return isinstance(self.value, int) and self.value == _NAN.get(self.type)


def values_of(reply: Message, request: Message | None) -> list[Value]:
    """What a reply says.

    Args:
        reply: A direct or a system reply; nothing is known of others.
        request: The command that it answers; None where that was not seen.

    Returns:
        Its values in the order of the request's outputs; an empty list where the request is not known or is of another
        kind.
    """
    if isinstance(reply, SystemReply):
        return list(system_values(reply))
    if isinstance(reply, DirectReply) and isinstance(request, DirectCommand):
        return list(reply_values(request, reply))
    return []


def system_values(reply: SystemReply) -> Iterator[Value]:
    """The fields of a system reply as values."""
    entry = SYSTEM_BY_NUMBER.get(reply.number)
    if entry is None:
        return
    at = HEADER_SIZE + 2
    for declared in entry.reply:
        if declared.name not in reply.fields:
            continue
        value = reply.fields[declared.name]
        length = _LENGTHS.get(declared.kind, 0) or len(value) + (declared.kind in _TERMINATED)  # type: ignore[arg-type]
        yield Value(reply.command or "", None, declared.name, value, None, declared.kind.value, None, at, length)
        at += length


_LENGTHS = {Kind.U8: 1, Kind.U16: 2, Kind.U32: 4}
_TERMINATED = (Kind.TEXT, Kind.COUNTED_TEXT)


def reply_values(command: DirectCommand, reply: DirectReply) -> Iterator[Value]:
    """What the reply's memory holds, by the output parameters of the command that it answers.

    Yields:
        A value for each output in global memory that the reply carries in whole; nothing for an error.
    """
    if reply.is_error:
        return
    for operation in command.operations:
        if not operation.has_outputs:
            continue
        outputs = results(operation)
        for found in outputs:
            value = _read(found, outputs, reply.memory)
            if value is not None:
                yield value


def _read(found: Footprint, outputs: list[Footprint], memory: bytes) -> Value | None:
    """The value of one output, None where the memory does not hold it."""
    argument, start = found.argument, found.start
    parameter = argument.parameter
    kind = Type.HANDLE if argument.form.handle else parameter.type
    symbol: str | list[str | None] | None = None
    value: ValueType
    if kind is Type.STRING:
        if start >= len(memory):
            return None
        piece = memory[start : _end(found, memory)].split(b"\0", 1)[0]
        value, length = piece.decode(STRING_CODING), len(piece)
    elif kind is Type.ARRAY_TYPED:
        kind = _untyped(outputs, start, len(memory))
        length = kind.size
        if start + length > len(memory):
            return None
        (value,) = _LAYOUTS[kind].unpack_from(memory, start)
    elif kind not in _LAYOUTS:
        return None
    elif parameter.length is None or argument.form.handle:
        layout = _LAYOUTS[kind]
        length = layout.size
        if start + length > len(memory):
            return None
        (value,) = layout.unpack_from(memory, start)
        if parameter.enum is not None and not argument.form.handle:
            symbol = parameter.enum.name_of(value)
    else:
        length = (_end(found, memory) - start) // kind.size * kind.size
        if length < 1:
            return None
        numbers = [number for (number,) in _LAYOUTS[kind].iter_unpack(memory[start : start + length])]
        value = numbers
        symbol = [parameter.enum.name_of(number) for number in numbers] if parameter.enum else None
    return Value(
        found.operation.name,
        found.operation.command,
        argument.name,
        value,
        None if argument.form.handle else parameter.unit,
        kind.label,
        symbol,
        HEADER_SIZE + start,
        length,
    )


def _end(found: Footprint, memory: bytes) -> int:
    """Where a text or an array ends in the memory: where the operation tells, or as far as there is any."""
    return len(memory) if found.is_open else min(found.end, len(memory))


def _untyped(outputs: list[Footprint], start: int, end: int) -> Type:
    """The type of an output that has that of the array it comes from: what fits before the next output."""
    end = min((found.start for found in outputs if start < found.start < end), default=end)
    room = max((size for size in _BY_SIZE if size <= end - start), default=UNTYPED_SIZE)
    return _BY_SIZE[room]
