"""Constants for every parameter: whole numbers at the borders, floats, texts, labels, handles, addresses.

All who judge a value are asked about these, each in an operation whose other arguments are legal.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

from ev3proto.messages import Argument, Operation
from ev3proto.schema.argument import encode_as, encode_float, encode_integer, encode_label, with_bits
from ev3proto.schema.header import build_frame, write_memory
from ev3proto.schema.instructions import OperationSchema, instruction_set
from ev3proto.tables.declaration import DIALECTS, Direction, Parameter, Type
from support.boundaries import kind_of
from support.effort import THOROUGH

GLOBALS, LOCALS = 512, 63
"""Bytes of memory that the commands request."""

WHOLE = (0, 1, -1, 32, 127, 128, -127, -128, 255, 32767, 32768, -32768, 65535, 70000)
FLOATS = (0.0, 1.5, -1.0, 1000.0, math.inf, math.nan)
LABELS = (0, 31, 32, -1)
LARGEST = 2**31 - 1


class Constant(NamedTuple):
    """A constant in an operation.

    schema   the operation
    number   of the parameter, from 0
    value    a number or a text; None for what only encoded bytes can be: labels, handles, addresses
    written  the encoded arguments of the operation, this one in its place
    """

    schema: OperationSchema
    dialect: str
    number: int
    value: float | str | None
    written: tuple[bytes, ...]

    @property
    def name(self) -> str:
        """For messages."""
        value = self.argument.raw.hex(" ") if self.value is None else str(self.value)[:30]
        return f"{self.schema.declaration.name}.{self.argument.name}={value} ({self.code.hex(' ')[:60]})"

    @property
    def code(self) -> bytes:
        """The bytes of the operation."""
        return self.schema.head + b"".join(self.written)

    @property
    def frame(self) -> bytes:
        """A command with it alone."""
        return build_frame(0x00, 1, write_memory(GLOBALS, LOCALS) + self.code)

    @property
    def operation(self) -> Operation:
        """The operation as it is read."""
        frame = self.frame
        return Operation((self.schema, frame, 7, len(frame)))

    @property
    def argument(self) -> Argument:
        """The constant as it is read."""
        return self.operation.arguments[self.number]

    @property
    def is_written(self) -> bool:
        """Whether assembly has the value of a parameter as plain text."""
        is_finite = self.value is not None and (isinstance(self.value, str) or math.isfinite(self.value))
        return is_finite and self.number < len(self.schema.fixed)

    def with_usual(self) -> Constant:
        """Returns the operation with a usual argument in its place."""
        at = min(self.number, len(self.written) - 1)
        return self._replace(written=(*self.written[:at], usual(self.argument.parameter), *self.written[at + 1 :]))

    @property
    def given(self) -> tuple[Any, ...]:
        """What the functions of `ops` take: encoded arguments, and the value if there is one."""
        parameters = self.schema.declaration.parameters
        fixed = len(self.schema.fixed)
        one = self.argument.raw if self.value is None else self.value
        if self.number < fixed:
            values: list[Any] = [*self.written[: self.number], one, *self.written[self.number + 1 :]]
            elements: list[Any] = []
        else:
            values, elements = [*self.written[:-1]], [one]
        if parameters and parameters[-1].is_list:
            # A count is the number of elements, or a parameter of its own in front of them.
            values[fixed - 1 :] = [elements] if parameters[-1].counts else [None, elements]
        return tuple(values)


def usual(parameter: Parameter) -> bytes:
    """Returns a legal argument, which is as likely as any."""
    is_array = parameter.length is not None and parameter.type is not Type.STRING
    if parameter.direction is not Direction.IN or parameter.type is Type.HANDLE or is_array:
        return bytes((0x60,))
    if parameter.type is Type.STRING:
        return encode_as("LCS", "a" if parameter.length is None else "abcd")
    if parameter.type is Type.DATAF:
        return encode_float(0.5)
    if parameter.counts:
        return encode_integer(0)
    legal = {1, 0}
    if parameter.range is not None:
        low, high = parameter.range
        legal = {number for number in legal if low <= number <= high} or {low}
    elif parameter.enum is not None:
        legal = {*parameter.enum.members.values()}
    return encode_integer(min(legal, key=lambda number: (number != 1, number)))


def constants(parameter: Parameter) -> Iterator[tuple[float | str | None, bytes]]:
    """Yields values and their bytes; bytes alone for values that only bytes can be."""
    numbers = {*WHOLE, LARGEST, -LARGEST, -LARGEST - 1, *parameter.special}
    numbers |= {at + step for at in parameter.range or () for step in (-1, 0, 1)}
    if parameter.enum is not None:
        members = parameter.enum.members.values()
        numbers |= {min(members) - 1, min(members), max(members), max(members) + 1}
    for number in sorted(number for number in numbers if -LARGEST - 1 <= number <= LARGEST):
        yield number, encode_as("LC4", number) if number == -LARGEST - 1 else encode_integer(number)
    for value in FLOATS:
        yield value, encode_float(value)
    ends = () if parameter.most is None else ("x" * (parameter.most - 1), "x" * parameter.most)
    # Texts for arrays have the bytes that the array has.
    for text in ("", "A", "./x", *ends) if parameter.length is None else ("abcd", "abcde"):
        yield text, encode_as("LCS", text)
    yield from ((None, encode_label(number)) for number in LABELS)
    yield from ((None, with_bits(encode_as("LC2", number), handle=True)) for number in (5, 1000))
    yield None, with_bits(encode_as("LC1", 5), address=True)


def _is_counter(schema: OperationSchema, parameter: Parameter) -> bool:
    return schema.tail is not None and parameter is schema.tail.counter


def constants_of(schema: OperationSchema, dialect: str, seen: set[object]) -> Iterator[Constant]:
    """Yields the constants of one operation's parameters whose kinds were not seen."""
    fixed = [one.parameter for one in schema.fixed]
    plain = [b"\0" if _is_counter(schema, parameter) else usual(parameter) for parameter in fixed]
    for number, parameter in enumerate(fixed):
        kind = kind_of(schema.declaration, number)
        if _is_counter(schema, parameter) or (kind in seen and not THOROUGH):
            continue
        seen.add(kind)
        for value, data in constants(parameter):
            yield Constant(schema, dialect, number, value, (*plain[:number], data, *plain[number + 1 :]))
    listed = fixed[-1].listed if fixed and _is_counter(schema, fixed[-1]) else None
    if listed is not None and listed.direction is Direction.IN and isinstance(fixed[-1].element, Type):
        for value, data in constants(listed):
            yield Constant(schema, dialect, len(fixed), value, (*plain[:-1], b"\1", data))


def every_constant() -> Iterator[Constant]:
    """Yields constants of each kind of parameter; in the thorough tests, of each parameter of each operation."""
    seen: set[object] = set()
    known: set[int] = set()
    for dialect in DIALECTS:
        for schema in instruction_set(dialect).by_name.values():
            entry = id(schema.declaration.command or schema.declaration.opcode)
            if entry in known:
                continue
            known.add(entry)
            yield from constants_of(schema, dialect, seen)
