"""One operation: opcode, CMD where the opcode has one, and the arguments that the tables declare for the two."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any

from ev3proto.errors import BuildError, DecodeError
from ev3proto.messages import Argument, ArgumentValue, Operation
from ev3proto.schema.argument import SHORT, SIZES, ArgumentSchema, Reader, encode_integer, reader_of
from ev3proto.schema.bytewise import Bytewise
from ev3proto.tables import OPCODES
from ev3proto.tables.declaration import DATA8, Command, Declaration, Direction, Opcode, Parameter, Type
from ev3proto.tables.encoding import CONSTANT, RANGES, STRING_CODING
from ev3proto.tables.enumerations import FORMAT_TYPES

CMD = ArgumentSchema(Parameter("CMD", DATA8, "which of the family's commands it is"))
"""CMD is a parameter like any other: one byte where it is 31 or less, but senders may encode it longer."""

_FEW = 32
"""List elements that are read without a look at where the byte code ends, since zeros follow it, more than these."""

_NO_COUNT = 1 << 32
"""More elements than any list has."""


def _count_of(counter: Argument) -> int:
    """How many elements a counter announces. More than any list has where it is no such number."""
    is_count = counter.kind == CONSTANT and isinstance(counter.value, int) and counter.value >= 0
    return int(counter.value) if is_count else _NO_COUNT


_LISTS = (Type.COUNT, Type.VALUES)


class OperationSchema(Bytewise):
    """The schema of one opcode/CMD pair."""

    def __init__(self, declaration: Declaration) -> None:
        super().__init__()
        self.declaration = declaration
        opcode, command = declaration.opcode, declaration.command
        self.start = 1 if command is None else 2
        self.head = bytes((opcode.number,)) + (encode_integer(command.number) if command else b"")
        parameters = declaration.parameters
        self.list_parameter = parameters[-1] if parameters and parameters[-1].type in _LISTS else None
        has_values = self.list_parameter is not None and self.list_parameter.type is Type.VALUES
        self._parameters = parameters[:-1] if has_values else parameters
        self.readers = tuple([reader_of(parameter) for parameter in self._parameters])
        self._elements: dict[Type, list[ArgumentSchema]] = {}

    @cached_property
    def has_outputs(self) -> bool:
        """Whether any of its parameters takes a value that the brick writes."""
        parameters = self.declaration.parameters
        return any(parameter.is_output or parameter.elements is not Direction.IN for parameter in parameters)

    @cached_property
    def fixed(self) -> tuple[ArgumentSchema, ...]:
        """The schemas of the arguments before the elements of a list, made when an operation of this kind is."""
        return tuple(ArgumentSchema(parameter) for parameter in self._parameters)

    @cached_property
    def plain(self) -> tuple[ArgumentSchema, ...] | None:
        """The schemas of the arguments where their number is always the same, None where a list follows."""
        return self.fixed if self.list_parameter is None else None

    # Reading

    def read(self, data: bytes, at: int) -> tuple[Operation, int]:
        """The operation at an offset, and the offset after it. DecodeError when another one or none is there."""
        if not data.startswith(self.head[:1], at):
            raise DecodeError(at, f"the opcode of {self.declaration.name} is 0x{self.head[0]:02X}")
        end = at + 1
        if self.declaration.command is not None:
            cmd, end = CMD.read(data, end)
            if cmd.kind != CONSTANT or cmd.value != self.declaration.command.number:
                raise DecodeError(
                    cmd.offset, f"the CMD of {self.declaration.name} is {self.declaration.command.number}"
                )
        for _, _, stop in self.scan(data, end, len(data)):
            end = stop
        return Operation((self, data, at, end)), end

    def scan(self, data: bytes, at: int, limit: int) -> Iterator[tuple[ArgumentSchema, int, int]]:
        """Finds one argument after the other, and what is wrong with the first that is faulty.

        Args:
            data: The bytes that the operation is in.
            at: The offset of the first argument.
            limit: Where the byte code ends.

        Yields:
            The schema of an argument, its offset, and the offset after it.

        Raises:
            DecodeError: The next argument cannot be read.

        """
        start = at
        for schema in self.fixed:
            start, at = at, schema.measure(data, at, limit)
            yield schema, start, at
        if self.list_parameter is None:
            return
        for schema in self._listed(None, self._count(data, start, at, limit - at)):
            start, at = at, schema.measure(data, at, limit)
            yield schema, start, at

    def _count(self, data: bytes, start: int, end: int, room: int) -> int:
        """How many list elements the argument in `data[start:end]` announces. There are `room` bytes for them."""
        counter = self.fixed[-1]
        argument = counter.read_measured(data, start, end)
        name = argument.name
        if argument.kind != CONSTANT or not isinstance(argument.value, int):
            raise DecodeError(start, f"{name} must be a constant: without it nobody knows how many values follow")
        bound = self._most_listed(room)
        if not 0 <= argument.value <= bound:
            raise DecodeError(
                start,
                f"{name} cannot be {argument.value}: there is room for 0 to {bound} values",
                truncated=0 <= argument.value <= RANGES[Type.COUNT].high,
            )
        return argument.value

    def _listed(self, element: Type | None, count: int) -> list[ArgumentSchema]:
        """The schemas of a list's elements. Without a type they are read as numbers of the brick's choice."""
        parameter = self.list_parameter
        assert parameter is not None
        if element is None:
            element = parameter.element if isinstance(parameter.element, Type) else Type.ARRAY_TYPED
        known = self._elements.setdefault(element, [])
        direction = parameter.elements if parameter.type is Type.COUNT else Direction.IN
        for index in range(len(known), count):
            declared = parameter._replace(
                name=f"{parameter.name}[{index}]", type=element, direction=direction, element=None
            )
            known.append(ArgumentSchema(declared))
        return known[:count]

    def _element_type(self, arguments: Sequence[Argument]) -> Type | None:
        """The type of the list's elements where another argument says it."""
        parameter = self.list_parameter
        if parameter is None or not isinstance(parameter.element, str):
            return None
        for argument in arguments:
            if argument.name == parameter.element and argument.kind == CONSTANT:
                return FORMAT_TYPES.get(int(argument.value))
        return None

    def selector(self, data: bytes, at: int) -> Argument | None:
        """Reads CMD.

        Args:
            data: The bytes that the operation is in.
            at: The offset of its opcode.

        Returns:
            CMD as an argument. None where the opcode has no CMD.

        """
        if self.declaration.command is None:
            return None
        return CMD.read(data, at + 1)[0]

    def arguments(self, data: bytes, at: int) -> tuple[Argument, ...]:
        """Reads the arguments of an operation that was scanned, so that nothing can be wrong with them.

        Args:
            data: The bytes that the operation is in.
            at: The offset of its opcode.

        Returns:
            What follows opcode and CMD. The elements of a list are arguments of their own.

        """
        start = self.start
        at += start
        if start == 2 and data[at - 1] > 0x3F:
            at += SIZES[data[at - 1]] - 1
        found: list[Argument] = []
        readers = self.readers if self.list_parameter is None else self.readers_with_list(found, len(data))
        value: ArgumentValue
        for parameter, long_forms in readers:
            first = data[at]
            if first < len(SHORT):
                encoding, value = SHORT[first]
                end = at + 1
            else:
                form = long_forms[first]
                assert form is not None, "whoever scanned it let no undefined identification byte pass"
                encoding, unpack, size = form
                end = at + size if unpack is not None else data.index(0, at + 1) + 1
                value = unpack(data, at)[0] if unpack is not None else data[at + 1 : end - 1].decode(STRING_CODING)
            found.append(Argument((parameter, encoding, value, at, data)))
            at = end
        return tuple(found)

    def readers_with_list(self, found: list[Argument], end: int) -> Iterator[Reader]:
        """Says what reads each argument of an operation with a list.

        Args:
            found: The arguments that were read so far, which whoever asks appends to.
            end: Where the byte code ends.

        Yields:
            What reads the next argument. Nothing more where the counter is none, or says more than there can be, or
            where the last argument ends too late.
        """
        yield from self.readers
        counter = found[-1]
        count = _count_of(counter)
        if count <= _FEW:
            for schema in self._listed(self._element_type(found), count):
                yield schema.reader
        elif count <= self._most_listed(end - counter[3]):
            for schema in self._listed(self._element_type(found), count):
                if found[-1][3] >= end:
                    return
                yield schema.reader

    def _most_listed(self, room: int) -> int:
        """How many elements a list can have for which there are so many bytes."""
        assert self.list_parameter is not None
        return min(room, RANGES[Type.COUNT].high) if self.list_parameter.type is Type.COUNT else room

    def parameters_at(self, data: bytes, at: int, most: int) -> tuple[Parameter, ...] | None:
        """Finds the parameters of an operation with a list, those of its elements among them.

        Args:
            data: The bytes that the operation is in.
            at: The offset of its opcode. CMD is in its shortest encoding.
            most: How many elements there may be.

        Returns:
            The parameters of what follows opcode and CMD. None where there are more elements, or it cannot be read how
            many there are.

        """
        at += self.start
        found = []
        try:
            for schema in self.fixed:
                argument, at = schema.read(data, at)
                found.append(argument)
        except DecodeError:
            return None
        count = _count_of(found[-1])
        if count > most:
            return None
        element = self._element_type(found)
        return *self._parameters, *(schema.parameter for schema in self._listed(element, count))

    def has_whole_list(self, found: list[Argument]) -> bool:
        """Says whether there are as many list elements among arguments as their counter says."""
        return len(found) - len(self.fixed) == _count_of(found[len(self.fixed) - 1])

    def readable_arguments(self, data: bytes, at: int, end: int) -> tuple[Argument, ...]:
        """Reads the arguments before a fault.

        Args:
            data: The bytes that the operation is in.
            at: The offset of its opcode.
            end: The offset after the last argument that can be read.

        Returns:
            What can be read.

        """
        found: list[Argument] = []
        try:
            start = at + 1 if self.declaration.command is None else CMD.measure(data, at + 1, end)
            for schema, begin, stop in self.scan(data, start, len(data)):
                if stop > end:
                    break
                found.append(schema.read_measured(data, begin, stop))
        except DecodeError:
            pass
        return tuple(found)

    # Building

    def write(self, value: Any) -> bytes:
        """Writes an operation with every value in its shortest encoding.

        Args:
            value: Values in the order of the parameters, or a mapping of parameter names to values. A list parameter
                takes a list, from which its count is worked out. An `Operation` keeps the bytes that it has.

        Returns:
            Opcode, CMD and arguments.

        Raises:
            BuildError: A value is missing, too many, or none that the parameter takes. The error names the parameter.

        """
        if isinstance(value, Operation):
            return value.raw
        values = value if isinstance(value, tuple | list) else self._in_order(value)
        if self.list_parameter is not None:
            return self.head + b"".join(self._pieces_with_list(list(values)))
        if len(values) != len(self.fixed):
            names = ", ".join(schema.parameter.name for schema in self.fixed) or "none"
            raise BuildError(f"{self.declaration.name} takes {len(self.fixed)} values ({names}), not {len(values)}")
        pieces = [
            schema.integers[one] if type(one) is int else schema.write(one)
            for schema, one in zip(self.fixed, values, strict=True)
        ]
        return self.head + b"".join(pieces)

    def _in_order(self, named: Any) -> list[Any]:
        if not isinstance(named, Mapping):
            return list(named)
        parameters = self.declaration.parameters
        names = [parameter.name for parameter in parameters]
        for name in named:
            if name not in names:
                raise BuildError(
                    f"{self.declaration.name} has no parameter {name}: it has {', '.join(names) or 'none'}"
                )
        counted = names[-2] if self.list_parameter and self.list_parameter.type is Type.VALUES else None
        values = []
        for name in names:
            if name in named:
                values.append(named[name])
            elif name == counted and names[-1] in named:
                values.append(len(named[names[-1]]))
            else:
                raise BuildError(f"{self.declaration.name} needs {name} too")
        return values

    def _pieces_with_list(self, values: list[Any]) -> Iterator[bytes]:
        name = self.declaration.name
        values = self._flat(values)
        if len(values) < len(self.fixed):
            missing = self.fixed[len(values)].parameter.name
            raise BuildError(f"{name} needs {missing} too")
        arguments: list[Argument] = []
        for schema, value in zip(self.fixed, values, strict=False):
            piece = schema.write(value)
            arguments.append(schema.read(piece, 0)[0])
            yield piece
        elements = values[len(self.fixed) :]
        count = arguments[-1]
        if count.kind != CONSTANT:
            raise BuildError(f"{count.name} must be a constant: it tells how many values follow; or give it a list")
        if count.value != len(elements):
            raise BuildError(f"{count.name} says {count.value}, but {len(elements)} values follow")
        element = self._element_type(arguments)
        for schema, value in zip(self._listed(element, len(elements)), elements, strict=True):
            yield schema.write(value)

    def _flat(self, values: list[Any]) -> list[Any]:
        """The values one by one, with the count that a list at the end stands for."""
        if not values or isinstance(values[-1], str | bytes | Argument) or not isinstance(values[-1], Sequence):
            return values
        elements = list(values[-1])
        assert self.list_parameter is not None
        if self.list_parameter.type is Type.COUNT and len(values) == len(self.fixed):
            return [*values[:-1], len(elements), *elements]
        return [*values[:-1], *elements]

    def make(self, values: Sequence[Any] | Mapping[str, Any]) -> Operation:
        """Makes an operation of values.

        Args:
            values: As `write` takes them.

        Returns:
            The operation by itself, at offset 0.

        Raises:
            BuildError: As `write` does.

        """
        raw = self.write(values)
        return Operation((self, raw, 0, len(raw)))

    def __reduce__(self) -> tuple[Any, ...]:
        """Copies and pickles are the same schema again, found by its numbers."""
        command = self.declaration.command
        return _found, (self.declaration.opcode.name, None if command is None else command.name)


_SCHEMAS: dict[int, OperationSchema] = {}


def operation_schema(opcode: Opcode, command: Command | None = None) -> OperationSchema:
    """Finds the schema of an entry of the tables. Dialects that have the entry share the schema.

    Args:
        opcode: The opcode's entry.
        command: The entry of its CMD. None for an opcode without CMD.

    Returns:
        The schema. It is made when it is first asked for.

    """
    key = id(opcode if command is None else command)  # entries are never dropped, and to hash one takes long
    schema = _SCHEMAS.get(key)
    if schema is None:
        schema = _SCHEMAS[key] = OperationSchema(Declaration(opcode, command))
    return schema


def _found(opcode: str, command: str | None) -> OperationSchema:
    entry = next(entry for entry in OPCODES if entry.name == opcode)
    return operation_schema(entry, next((one for one in entry.commands if one.name == command), None))


class FamilySchema:
    """An opcode whose CMD decides: the schemas of its commands by number."""

    def __init__(self, opcode: Opcode, dialect: str) -> None:
        self.opcode = opcode
        self.commands = {
            command.number: operation_schema(opcode, command)
            for command in opcode.commands
            if dialect in command.dialects
        }
