"""One operation: opcode, CMD where the opcode has one, and the arguments that the tables declare for the two."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from ev3proto.errors import BuildError, DecodeError
from ev3proto.messages import Argument, Operation
from ev3proto.schema.argument import SHORT, SIZES, ArgumentSchema, encode_integer
from ev3proto.schema.bytewise import Bytewise
from ev3proto.tables.declaration import DATA8, Declaration, Direction, Opcode, Parameter, Type
from ev3proto.tables.encoding import CONSTANT, RANGES, STRING_CODING
from ev3proto.tables.enumerations import FORMAT_TYPES
from ev3proto.tables.frame import MAX_FRAME

CMD = ArgumentSchema(Parameter("CMD", DATA8, "which of the family's commands it is"))
"""CMD is a parameter like any other: one byte where it is 31 or less, but senders may encode it longer."""

_LISTS = (Type.COUNT, Type.VALUES)


class OperationSchema(Bytewise):
    """The schema of one opcode/CMD pair."""

    def __init__(self, declaration: Declaration, dialect: str) -> None:
        super().__init__()
        self.declaration = declaration
        self.dialect = dialect
        opcode, command = declaration.opcode, declaration.command
        self.start = 1 if command is None else 2
        self.head = bytes((opcode.number,)) + (encode_integer(command.number) if command else b"")
        parameters = declaration.parameters
        self.list_parameter = parameters[-1] if parameters and parameters[-1].type in _LISTS else None
        fixed = parameters[:-1] if self.list_parameter and self.list_parameter.type is Type.VALUES else parameters
        self.fixed = tuple(ArgumentSchema(parameter) for parameter in fixed)
        self.plain = self.fixed if self.list_parameter is None else None
        """The arguments where their number is always the same, None where a list follows."""
        self.readers = tuple((schema.parameter, schema.long_forms) for schema in self.fixed)
        self._elements: dict[tuple[int, Type], ArgumentSchema] = {}
        self.has_outputs = any(
            parameter.is_output or parameter.elements is not Direction.IN for parameter in parameters
        )

    # Reading

    def read(self, data: bytes, at: int) -> tuple[Operation, int]:
        """The operation at an offset, and the offset behind it. DecodeError when another one or none is there."""
        if not data.startswith(self.head[:1], at):
            raise DecodeError(at, f"the opcode of {self.declaration.name} is 0x{self.head[0]:02X}")
        end = at + 1
        if self.declaration.command is not None:
            cmd, end = CMD.read(data, end)
            if cmd.kind != CONSTANT or cmd.value != self.declaration.command.number:
                raise DecodeError(
                    cmd.offset, f"the CMD of {self.declaration.name} is {self.declaration.command.number}"
                )
        end = self.scan(data, end, len(data))
        return Operation((self, data, at, end)), end

    def walk(
        self, data: bytes, at: int, limit: int, room: int | None = None
    ) -> Iterator[tuple[ArgumentSchema, int, int]]:
        """Schema, start and end of one argument after the other, carefully. DecodeError at the first that is faulty.

        room  how many bytes a list may need, where that is not what is left up to `limit`
        """
        start = at
        for schema in self.fixed:
            start, at = at, schema.measure(data, at, limit)
            yield schema, start, at
        if self.list_parameter is not None:
            for index in range(self._count(data, start, at, limit - at if room is None else room)):
                schema = self._element(index, None)
                start, at = at, schema.measure(data, at, limit)
                yield schema, start, at

    def scan(self, data: bytes, at: int, limit: int) -> int:
        """The offset behind the arguments that start at an offset. DecodeError when they are faulty."""
        for _, _, end in self.walk(data, at, limit):
            at = end
        return at

    def _count(self, data: bytes, start: int, end: int, room: int) -> int:
        """How many list elements follow the argument in `data[start:end]`."""
        counter = self.fixed[-1]
        argument, _ = counter.read_at(data, start, end)
        name = argument.name
        if argument.kind != CONSTANT or not isinstance(argument.value, int):
            raise DecodeError(start, f"{name} must be a constant: without it nobody knows how many values follow")
        bound = min(room, RANGES[Type.COUNT].high) if counter.parameter.type is Type.COUNT else room
        if not 0 <= argument.value <= bound:
            raise DecodeError(
                start,
                f"{name} cannot be {argument.value}: there is room for 0 to {bound} values",
                truncated=0 <= argument.value <= RANGES[Type.COUNT].high,
            )
        return argument.value

    def _element(self, index: int, element: Type | None) -> ArgumentSchema:
        """The schema of a list's element; without a type it serves to measure only."""
        parameter = self.list_parameter
        assert parameter is not None
        if element is None:
            element = parameter.element if isinstance(parameter.element, Type) else Type.ARRAY_TYPED
        schema = self._elements.get((index, element))
        if schema is None:
            direction = parameter.elements if parameter.type is Type.COUNT else Direction.IN
            declared = parameter._replace(
                name=f"{parameter.name}[{index}]", type=element, direction=direction, element=None
            )
            schema = self._elements[index, element] = ArgumentSchema(declared)
        return schema

    def _element_type(self, arguments: Sequence[Argument]) -> Type | None:
        """The type of the list's elements where another argument tells it."""
        parameter = self.list_parameter
        if parameter is None or not isinstance(parameter.element, str):
            return None
        for argument in arguments:
            if argument.name == parameter.element and argument.kind == CONSTANT:
                return FORMAT_TYPES.get(int(argument.value))
        return None

    def selector(self, data: bytes, at: int) -> Argument | None:
        """CMD of the operation at an offset."""
        if self.declaration.command is None:
            return None
        return CMD.read(data, at + 1)[0]

    def arguments(self, data: bytes, at: int) -> tuple[Argument, ...]:
        """The arguments of the operation whose opcode is at an offset."""
        start = self.start
        at += start
        if start == 2 and data[at - 1] > 0x3F:
            at += SIZES[data[at - 1]] - 1
        # This loop is ArgumentSchema.read_at for every argument, without its calls: half of all time goes here.
        found: list[Argument] = []
        append, short = found.append, SHORT
        for parameter, long_forms in self.readers:
            first = data[at]
            if first < 128:
                encoding, value = short[first]
                append(Argument((parameter, encoding, value, at, data)))
                at += 1
                continue
            encoding, unpack, size = long_forms[first]  # type: ignore[misc]
            if unpack is None:
                end = data.index(0, at + 1)
                append(Argument((parameter, encoding, data[at + 1 : end].decode(STRING_CODING), at, data)))
                at = end + 1
            else:
                append(Argument((parameter, encoding, unpack(data, at)[0], at, data)))
                at += size
        if self.list_parameter is not None:
            self._append_list(data, at, found)
        return tuple(found)

    def _append_list(self, data: bytes, at: int, found: list[Argument]) -> None:
        """The elements of the list at the end, whose number the last argument in front of it tells."""
        element = self._element_type(found)
        for index in range(int(found[-1].value)):
            end = at + (SIZES[data[at]] or data.index(0, at + 1) + 1 - at)
            argument, at = self._element(index, element).read_at(data, at, end)
            found.append(argument)

    def readable_arguments(self, data: bytes, at: int, end: int) -> tuple[Argument, ...]:
        """The arguments that an operation cut short at `end` still has."""
        found: list[Argument] = []
        try:
            at = at + 1 if self.declaration.command is None else CMD.measure(data, at + 1, end)
            for schema, start, behind in self.walk(data, at, end, room=MAX_FRAME):
                found.append(schema.read_at(data, start, behind)[0])
        except DecodeError:
            pass
        return tuple(found)

    # Building

    def write(self, value: Any) -> bytes:
        """The shortest bytes of an operation.

        value  an `Operation` (its bytes as they are), a sequence of values in the order of the parameters, or a mapping
               of parameter names to values. A list parameter takes a list, from which its count is worked out.
               BuildError names the parameter at fault.
        """
        if isinstance(value, Operation):
            return value.raw
        if isinstance(value, Mapping):
            value = self._in_order(value)
        return self.head + b"".join(self._pieces(list(value)))

    def _in_order(self, named: Mapping[str, Any]) -> list[Any]:
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

    def _pieces(self, values: list[Any]) -> Iterator[bytes]:
        name = self.declaration.name
        if self.list_parameter is not None:
            values = self._flat(values)
        elif len(values) != len(self.fixed):
            names = ", ".join(schema.parameter.name for schema in self.fixed)
            raise BuildError(f"{name} takes {len(self.fixed)} values ({names or 'none'}), not {len(values)}")
        if len(values) < len(self.fixed):
            missing = self.fixed[len(values)].parameter.name
            raise BuildError(f"{name} needs {missing} too")
        arguments: list[Argument] = []
        for schema, value in zip(self.fixed, values, strict=False):
            piece = schema.write(value)
            arguments.append(schema.read(piece, 0)[0])
            yield piece
        if self.list_parameter is not None:
            elements = values[len(self.fixed) :]
            count = arguments[-1]
            if count.kind != CONSTANT:
                raise BuildError(f"{count.name} must be a constant: it tells how many values follow; or give it a list")
            if count.value != len(elements):
                raise BuildError(f"{count.name} says {count.value}, but {len(elements)} values follow")
            element = self._element_type(arguments)
            for index, value in enumerate(elements):
                yield self._element(index, element).write(value)

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
        """The operation with these values (as `write` takes them), by itself at offset 0."""
        raw = self.write(values)
        return Operation((self, raw, 0, len(raw)))


class FamilySchema:
    """An opcode whose CMD decides: the schemas of its commands by number."""

    def __init__(self, opcode: Opcode, dialect: str) -> None:
        self.opcode = opcode
        self.commands = {
            command.number: OperationSchema(Declaration(opcode, command), dialect)
            for command in opcode.commands
            if dialect in command.dialects
        }
