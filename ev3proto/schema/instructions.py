"""The instruction set of one dialect: byte code to operations, and operations by name.

`InstructionSet.scan` reads all byte code: operations in a row, each with its arguments.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from functools import cache, cached_property
from typing import Any

from ev3proto.errors import BuildError, DecodeError, near_misses
from ev3proto.messages import Argument, Operation, PartialOperation, Variable
from ev3proto.schema.argument import ArgumentSchema, Reader, encode_integer, read_arguments, reader_of
from ev3proto.schema.reasons import unreadable
from ev3proto.tables import OPCODES, check_dialect
from ev3proto.tables.declaration import DATA8, Command, Declaration, Opcode, Parameter, Type
from ev3proto.tables.encoding import CONSTANT, COUNTS
from ev3proto.tables.enumerations import FORMAT_TYPES

CMD = ArgumentSchema(Parameter("CMD", DATA8, "the command of the family"))
"""CMD is a parameter like any other: one byte if it is 31 or less, but senders may use longer encodings."""

_CMD = (CMD.reader,)
_IN_ORDER = (tuple, list)


class OperationSchema:
    """Reads and writes the operations of one opcode/CMD pair."""

    def __init__(self, declaration: Declaration) -> None:
        self.declaration = declaration
        opcode, command = declaration.opcode, declaration.command
        self.head = bytes((opcode.number,)) + (encode_integer(command.number) if command else b"")
        self.tail = declaration.tail
        self.readers = tuple([reader_of(parameter) for parameter in declaration.fixed])
        """The readers of the arguments before the elements of a list."""
        self._elements: dict[Type, list[ArgumentSchema]] = {}

    @cached_property
    def has_outputs(self) -> bool:
        """Whether the brick writes any of its parameters."""
        written = any(parameter.is_output for parameter in self.declaration.fixed)
        return written or (self.tail is not None and self.tail.element.is_output)

    @cached_property
    def fixed(self) -> tuple[ArgumentSchema, ...]:
        """The schemas of the arguments before the elements of a list."""
        return tuple(ArgumentSchema(parameter) for parameter in self.declaration.fixed)

    # Reading

    def _read_arguments(self, data: bytes, at: int, found: list[Argument]) -> int:
        at = read_arguments(self.readers, data, at, len(data), found)
        if self.tail is not None:
            at = read_arguments(self.elements(found, len(data) - at), data, at, len(data), found)
        return at

    def elements(self, before: Sequence[Argument], room: int) -> Iterator[Reader]:
        """Returns the readers of the elements of a list.

        Args:
            before: The arguments before the elements, the last of which counts them.
            room: Bytes available for the elements.

        Raises:
            DecodeError: The last argument is not a count, or not enough bytes are left for the elements.
        """
        count = self._count(before[-1], room)
        return (schema.reader for schema in self._listed(self.element(before), count))

    def _count(self, counter: Argument, room: int) -> int:
        """Returns the number of list elements that an argument announces, for which `room` bytes are available."""
        most = COUNTS.high
        if counter.kind != CONSTANT or not isinstance(counter.value, int):
            raise unreadable(counter.offset, "no_count", name=counter.name)
        bound = min(room, most) if counter.parameter.counts else room
        if not 0 <= counter.value <= bound:
            is_cut = 0 <= counter.value <= most
            raise unreadable(counter.offset, "no_room", is_cut, name=counter.name, value=counter.value, room=bound)
        return counter.value

    def _listed(self, element: Parameter, count: int) -> Iterator[ArgumentSchema]:
        """Yields the schemas of a list's elements."""
        known = self._elements.setdefault(element.type, [])
        for index in range(count):
            if index == len(known):
                known.append(ArgumentSchema(element._replace(name=f"{element.name}[{index}]")))
            yield known[index]

    def element(self, before: Sequence[Argument]) -> Parameter:
        """Returns the parameter of a list's elements, a number of unknown type if no argument before tells it."""
        assert self.tail is not None
        element = self.tail.element
        for argument in before:
            if argument.name == self.tail.typed_by and argument.kind == CONSTANT:
                return element._replace(type=FORMAT_TYPES.get(int(argument.value), element.type))
        return element

    def selector(self, data: bytes, at: int) -> Argument | None:
        """Reads CMD.

        Args:
            data: The bytes that contain the operation.
            at: The offset of its opcode.

        Returns:
            CMD as an argument, None if the opcode has no CMD.
        """
        if self.declaration.command is None:
            return None
        found: list[Argument] = []
        read_arguments(_CMD, data, at + 1, len(data), found)
        return found[0]

    def arguments(self, data: bytes, at: int, end: int) -> tuple[Argument, ...]:
        """Reads the arguments of an operation again after it was built, copied, or moved into a frame.

        Args:
            data: The bytes that contain the operation.
            at: The offset of its opcode.
            end: The offset after it, or after its last readable argument if it is faulty.

        Returns:
            The arguments after opcode and CMD, up to `end`.
        """
        found: list[Argument] = []
        cmd = self.selector(data, at)
        with suppress(DecodeError):
            self._read_arguments(data, at + 1 if cmd is None else cmd.offset + cmd.length, found)
        return tuple([argument for argument in found if argument.offset < end])

    # Building

    def write(self, value: Any) -> bytes:
        """Writes an operation with every value in its shortest encoding.

        Args:
            value: Values in the order of the parameters, or a mapping of parameter names to values. A list parameter
                takes a list; its count is computed. An `Operation` keeps its bytes.

        Returns:
            Opcode, CMD and arguments.

        Raises:
            BuildError: A value is missing, superfluous or invalid. The error names the parameter.
        """
        if isinstance(value, Operation):
            return value.raw
        values = value if isinstance(value, _IN_ORDER) else self._in_order(value)
        if self.tail is not None:
            return self.head + b"".join(self._pieces_with_list(list(values)))
        if len(values) != len(self.fixed):
            names = ", ".join(schema.parameter.name for schema in self.fixed) or "none"
            raise BuildError(f"{self.declaration.name} takes {len(self.fixed)} values ({names}), not {len(values)}")
        return self.head + b"".join(map(ArgumentSchema.write, self.fixed, values))

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
        counted = None if self.tail is None or self.tail.counter.counts else self.tail.counter.name
        values = []
        for name in names:
            if name not in named and not (name == counted and names[-1] in named):
                raise BuildError(f"{self.declaration.name} also needs {name}")
            values.append(named.get(name))
        return values

    def _pieces_with_list(self, values: list[Any]) -> Iterator[bytes]:
        name = self.declaration.name
        values = self.one_by_one(values)
        if len(values) < len(self.fixed):
            missing = self.fixed[len(values)].parameter.name
            raise BuildError(f"{name} also needs {missing}")
        arguments: list[Argument] = []
        for schema, value in zip(self.fixed, values, strict=False):
            piece = schema.write(value)
            arguments.append(schema.read(piece, 0)[0])
            yield piece
        elements = values[len(self.fixed) :]
        count = arguments[-1]
        if count.kind != CONSTANT:
            raise BuildError(f"{count.name} must be a constant: it is the number of values that follow; or pass a list")
        if count.value != len(elements):
            raise BuildError(f"{count.name} says {count.value}, but {len(elements)} values follow")
        element = self.element(arguments)
        for schema, value in zip(self._listed(element, len(elements)), elements, strict=True):
            yield schema.write(value)

    def one_by_one(self, values: list[Any]) -> list[Any]:
        """Returns one value for each argument.

        Args:
            values: Values in the order of the parameters. If the last one is a list, its elements follow one by one;
                an omitted count (None, or none at all) is theirs.
        """
        is_list = values and isinstance(values[-1], Sequence) and not isinstance(values[-1], str | bytes | Argument)
        if self.tail is None or not is_list:
            return values
        *before, elements = values
        if self.tail.counter.counts and len(values) == len(self.fixed):
            before.append(len(elements))
        elif before and before[-1] is None:
            before[-1] = len(elements)
        return [*before, *elements]

    def make(self, values: Sequence[Any] | Mapping[str, Any]) -> Operation:
        """Returns an operation from values.

        Args:
            values: As for `write`.

        Returns:
            The operation alone, at offset 0.

        Raises:
            BuildError: As for `write`.
        """
        raw = self.write(values)
        return Operation((self, raw, 0, len(raw)))

    def __reduce__(self) -> tuple[Any, ...]:
        """Copies and pickles are the same schema, found by its numbers."""
        command = self.declaration.command
        return _found, (self.declaration.opcode.name, None if command is None else command.name)


_SCHEMAS: dict[int, OperationSchema] = {}


def operation_schema(opcode: Opcode, command: Command | None = None) -> OperationSchema:
    """Returns the schema of an entry of the tables. Dialects that have the entry share it.

    Args:
        opcode: The opcode's entry.
        command: The entry of its CMD. None for an opcode without CMD.

    Returns:
        The schema, created on first use.
    """
    key = id(opcode if command is None else command)  # entries are never dropped, and hashing one is slow
    schema = _SCHEMAS.get(key)
    if schema is None:
        schema = _SCHEMAS[key] = OperationSchema(Declaration(opcode, command))
    return schema


def _found(opcode: str, command: str | None) -> OperationSchema:
    entry = next(entry for entry in OPCODES if entry.name == opcode)
    return operation_schema(entry, next((one for one in entry.commands if one.name == command), None))


class FamilySchema:
    """An opcode with CMDs.

    opcode    its entry in the tables
    commands  the schemas of its commands by number
    short     the same by the byte of their number in the shortest encoding, if that is one byte
    """

    def __init__(self, opcode: Opcode, dialect: str) -> None:
        self.opcode = opcode
        self.commands: dict[Any, OperationSchema] = {
            command.number: operation_schema(opcode, command)
            for command in opcode.commands
            if dialect in command.dialects
        }
        self.short = {schema.head[1]: schema for schema in self.commands.values() if len(schema.head) == 2}


class InstructionSet:
    """Reads byte code: operations in a row up to the end of the bytes.

    dialect   its firmware
    opcodes   the schema of each opcode without CMDs, None for all others
    families  the schemas of each opcode with CMDs, None for all others
    by_name   the schema of each operation: `SOUND.TONE`, `UI_FLUSH`, ...
    """

    def __init__(self, dialect: str) -> None:
        self.dialect = check_dialect(dialect)
        self.opcodes: list[OperationSchema | None] = [None] * 256
        self.families: list[FamilySchema | None] = [None] * 256
        self.by_name: dict[str, OperationSchema] = {}
        for opcode in OPCODES:
            if dialect not in opcode.dialects:
                continue
            if opcode.is_family:
                family = self.families[opcode.number] = FamilySchema(opcode, dialect)
                schemas = list(family.commands.values())
            else:
                schemas = [operation_schema(opcode)]
                self.opcodes[opcode.number] = schemas[0]
            self.by_name.update((schema.declaration.name, schema) for schema in schemas)

    def __getitem__(self, name: str) -> OperationSchema:
        """Returns the schema of one operation.

        Args:
            name: `SOUND.TONE`, in any case.

        Returns:
            The schema.

        Raises:
            KeyError: The operation is unknown. The error suggests the nearest names.
        """
        if not isinstance(name, str):
            raise KeyError(f"the name of an operation is a text, such as SOUND.TONE, not {name!r}")
        found = self.by_name.get(name.upper())
        if found is None:
            raise KeyError(f"the {self.dialect} firmware has no operation {name}{near_misses(name, self.by_name)}")
        return found

    def scan(self, data: bytes, at: int, end: int) -> tuple[list[Operation], DecodeError | None]:
        """Reads the operations from one offset to another, up to the first faulty one.

        Args:
            data: The bytes that contain the byte code.
            at: The offset of the first opcode.
            end: The end of the byte code.

        Returns:
            The operations, and what is wrong with the next one. The last operation is a `PartialOperation` if only
            its first arguments could be read.
        """
        operations: list[Operation] = []
        opcodes = self.opcodes
        while at < end:
            start = at
            schema = opcodes[data[at]]
            arguments: list[Argument] = []
            try:
                if schema is None:
                    schema, at = self.select(data, at, end)
                else:
                    at += 1
                at = read_arguments(schema.readers, data, at, end, arguments)
                if schema.tail is not None:
                    at = read_arguments(schema.elements(arguments, end - at), data, at, end, arguments)
            except DecodeError as fault:
                if schema is not None:
                    stop = arguments[-1].offset + arguments[-1].length if arguments else at
                    operations.append(PartialOperation((schema, data, start, stop, tuple(arguments))))
                return operations, fault.with_traceback(None)  # a traceback keeps the stack alive
            operations.append(Operation((schema, data, start, at, tuple(arguments))))
        return operations, None

    def select(self, data: bytes, at: int, end: int) -> tuple[OperationSchema, int]:
        """Returns the schema for the opcode and CMD at an offset, and where its arguments start."""
        family = self.families[data[at]]
        if family is None:
            raise unreadable(at, "no_opcode", byte=data[at], dialect=self.dialect)
        schema = family.short.get(data[at + 1]) if at + 1 < end else None
        if schema is not None:
            return schema, at + 2
        found: list[Argument] = []
        stop = read_arguments(_CMD, data, at + 1, end, found)
        cmd = found[0]
        if cmd.kind != CONSTANT:
            index, kind = cmd.value, cmd.kind
            said = str(Variable(kind, index)) if cmd.is_variable and isinstance(index, int) else f"a {kind}"
            raise unreadable(at + 1, "variable_cmd", owner=family.opcode.name, value=said)
        schema = family.commands.get(cmd.value)
        if schema is None:
            known = ", ".join(f"{number} {found.declaration.command.name}" for number, found in _first(family.commands))
            raise unreadable(at + 1, "no_cmd", owner=family.opcode.name, value=cmd.value, known=known)
        return schema, stop

    def named(self, name: str) -> OperationSchema:
        """Returns the schema of one operation, like `[name]`. Raises BuildError if it is unknown."""
        try:
            return self.by_name.get(name) or self[name]
        except KeyError as error:
            raise BuildError(error.args[0]) from None


def _first(commands: dict[int, OperationSchema]) -> list[tuple[int, Any]]:
    return sorted(commands.items())[:3]


@cache
def instruction_set(dialect: str = "official") -> InstructionSet:
    """Returns the instruction set of a dialect, created once.

    Args:
        dialect: "official", "xtended" or "compat".

    Returns:
        The instruction set. `instruction_set()["SOUND.TONE"]` is the schema of one operation.

    Raises:
        ValueError: The dialect is unknown.
    """
    return InstructionSet(dialect)


def operation(name: str, *values: Any, dialect: str = "official", **named: Any) -> Operation:
    """Returns an operation from values, each in its shortest encoding.

    Args:
        name: `SOUND.TONE`, `UI_FLUSH`, in any case.
        values: Values in the order of the parameters: numbers, texts, names of an enumeration's members, variables
            (`GV(0)`, `LV(4)`), or bytes that are one encoded argument (`LC2(5)`). A list parameter takes a list.
        dialect: "official", "xtended" or "compat": the firmware of the operation.
        named: Values by parameter name, instead of `values`.

    Returns:
        The operation alone, at offset 0.

    Raises:
        BuildError: The operation is unknown, or cannot have these values. The error names the parameter, the
            value and valid values.
        ValueError: The dialect is unknown.
    """
    schema = instruction_set(dialect).named(name)
    if values and named:
        raise BuildError(f"{name}: pass values in order or by name, not both")
    return schema.make(named or values)
