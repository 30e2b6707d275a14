"""The values of a reply by name: its memory, read by the outputs of the command it answers, or its fields."""

from __future__ import annotations

import math
import struct
from collections.abc import Iterator
from typing import NamedTuple

from ev3proto.messages import DirectCommand, DirectReply, Message, SystemCommand, SystemReply
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.semantics.facts import UNTYPED_SIZE
from ev3proto.semantics.footprint import Footprint, results
from ev3proto.semantics.readings import datasets_of
from ev3proto.tables import mailboxes
from ev3proto.tables.declaration import Enumeration, Type
from ev3proto.tables.devices import Dataset
from ev3proto.tables.encoding import RANGES, STRING_CODING
from ev3proto.tables.system import SYSTEM_BY_NUMBER, FieldKind

ValueType = int | float | str | bytes | list[int] | list[float]
"""The types of values from replies."""

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


_MOST_GUESSED = 8
"""The most numbers of global memory that are read without the command."""


class Value(NamedTuple):
    """One value in a reply.

    op       opcode's name, or the system command's
    command  CMD's name, or None
    name     the parameter's or field's name
    value    number, text, or list of numbers
    unit     unit as written, or None
    type     type in memory: DATA8, DATAF, string, u32, ...
    symbol   name of the number in its enumeration, or None
    offset   of its first byte in the reply's frame
    length   bytes in the reply's frame
    quantity what a reading of a device is, such as `angle`; None if type and mode of the command do not tell
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
    quantity: str | None = None

    @property
    def full_name(self) -> str:
        """`UI_READ.GET_VBATT`, or the name of an opcode or system command alone."""
        return f"{self.op}.{self.command}" if self.command else self.op

    @property
    def number(self) -> float:
        """The value as a number. Raises TypeError for a text, bytes or a list; use `value` for those."""
        if isinstance(self.value, int | float):
            return self.value
        raise TypeError(f"{self.name} is not a number: its value is {self.value!r}")

    @property
    def is_nan(self) -> bool:
        """Whether it is the firmware's value for "not a number"."""
        if isinstance(self.value, float):
            return math.isnan(self.value)
        return isinstance(self.value, int) and self.value == _NAN.get(self.type)


def values_of(reply: Message, request: Message | None) -> list[Value]:
    """Returns the values of a reply.

    Args:
        reply: A direct or a system reply; others have no values.
        request: The command that it answers; None if that was not seen.

    Returns:
        Its values in the order of the request's outputs; an empty list if the request is unknown or of another
        kind.
    """
    if isinstance(reply, SystemReply):
        return list(field_values(reply))
    if isinstance(reply, DirectReply) and isinstance(request, DirectCommand):
        return list(reply_values(request, reply))
    return []


def field_values(message: SystemCommand | SystemReply) -> Iterator[Value]:
    """Yields the fields of a system message as values, each with its place in the frame."""
    entry = SYSTEM_BY_NUMBER.get(message.number)
    if entry is None:
        return
    is_reply = isinstance(message, SystemReply)
    at = HEADER_SIZE + 1 + is_reply
    for declared in entry.reply if is_reply else entry.request:
        if declared.name not in message.fields:
            continue
        value = message.fields[declared.name]
        length = _LENGTHS.get(declared.kind, 0) or len(value) + (declared.kind in _TERMINATED)  # type: ignore[arg-type]
        yield Value(message.command or "", None, declared.name, value, None, declared.kind.value, None, at, length)
        at += length


_LENGTHS = {FieldKind.U8: 1, FieldKind.U16: 2, FieldKind.U32: 4}
_TERMINATED = (FieldKind.TEXT, FieldKind.COUNTED_TEXT)


def reply_values(command: DirectCommand, reply: DirectReply) -> Iterator[Value]:
    """Yields the contents of the reply's memory, by the output parameters of the command that it answers.

    Yields:
        A value for each output in global memory that the reply carries completely; nothing for an error.
    """
    if reply.is_error:
        return
    for operation in command.operations:
        if not operation.has_outputs:
            continue
        outputs, datasets = results(operation), datasets_of(operation)
        for found in outputs:
            value = _read(found, outputs, reply.memory, datasets.get(found.number))
            if value is not None:
                yield value


def _read(found: Footprint, outputs: list[Footprint], memory: bytes, dataset: Dataset | None) -> Value | None:
    """Returns the value of one output, None if the memory does not hold it."""
    parameter, is_handle = found.argument.parameter, found.argument.form.handle
    kind = Type.HANDLE if is_handle else parameter.type
    is_list = parameter.length is not None and not is_handle
    if kind is Type.ARRAY_TYPED:
        kind, is_list = _untyped(outputs, found.start, len(memory)), False
    value, length = _contents(found, kind, is_list, memory)
    if value is None:
        return None
    unit, quantity = (None, None) if is_handle else (parameter.unit, None)
    if dataset is not None:
        unit, quantity = dataset.unit or None, dataset.name
    return Value(
        found.operation.name,
        found.operation.command,
        found.argument.name,
        value,
        unit,
        kind.label,
        None if is_handle or parameter.enum is None else _symbol(parameter.enum, value),
        HEADER_SIZE + found.start,
        length,
        quantity,
    )


def _contents(found: Footprint, kind: Type, is_list: bool, memory: bytes) -> tuple[ValueType | None, int]:
    """Returns what the memory holds of an output, and its size; None if that is nothing, or not all of a number."""
    start, layout = found.start, _LAYOUTS.get(kind)
    if kind is Type.STRING:
        piece = memory[start : _end(found, memory)].split(b"\0", 1)[0]
        return (piece.decode(STRING_CODING) if start < len(memory) else None), len(piece)
    if layout is None:
        return None, 0
    count = (_end(found, memory) - start) // kind.size if is_list else 1
    length = count * kind.size
    if length < 1 or start + length > len(memory):
        return None, 0
    numbers = [number for (number,) in layout.iter_unpack(memory[start : start + length])]
    return numbers if is_list else numbers[0], length


def _symbol(enum: Enumeration, value: ValueType) -> str | list[str | None] | None:
    return list(map(enum.name_of, value)) if isinstance(value, list) else enum.name_of(value)


def _end(found: Footprint, memory: bytes) -> int:
    """Returns the end of a text or an array in memory: by the operation, or else the end of the memory."""
    return len(memory) if found.is_open else min(found.end, len(memory))


def _untyped(outputs: list[Footprint], start: int, end: int) -> Type:
    """Returns the type of an output with an array's element type: the one that fits before the next output."""
    end = min((found.start for found in outputs if start < found.start < end), default=end)
    room = max((size for size in _BY_SIZE if size <= end - start), default=UNTYPED_SIZE)
    return _BY_SIZE[room]


def guesses(memory: bytes) -> dict[str, ValueType]:
    """Returns what global memory may hold, by type, likeliest first: for a reply whose command is unknown.

    Numbers are of the largest size that divides the memory, and at most 8: `{"DATAF": 6.0, "DATA32": 1086324736}`,
    or a list of several. A text is printable up to its first zero, and nothing follows.
    """
    found: dict[str, ValueType] = {}
    text, zero, rest = memory.partition(b"\0")
    if zero and len(text) > 1 and not rest.strip(b"\0") and mailboxes.is_printable(text):
        found[Type.STRING.label] = text.decode(STRING_CODING)
    size = next(size for size in (4, 2, 1) if len(memory) % size == 0)
    if 0 < len(memory) <= size * _MOST_GUESSED:
        for kind in (Type.DATAF, Type.DATA32, Type.DATA16, Type.DATA8):
            if kind.size == size:
                numbers = [number for (number,) in _LAYOUTS[kind].iter_unpack(memory)]
                if kind is not Type.DATAF or all(map(_is_plausible, numbers)):
                    found[kind.label] = numbers if len(numbers) > 1 else numbers[0]
    return found


def _is_plausible(number: float) -> bool:
    """Returns whether a float has a size that sensors and motors give; bytes of other types are far from it."""
    return number == 0 or math.isnan(number) or 1e-6 <= abs(number) < 1e7
