"""The instruction set of one dialect: byte code to operations, and operations by name.

Reading goes twice over faulty byte code and once over all other. The quick way only adds up sizes; where that fails,
the careful way goes over the same bytes to say what is wrong and where.
"""

from __future__ import annotations

import copyreg
from functools import cache
from typing import Any

from ev3proto.errors import BuildError, DecodeError, near_misses
from ev3proto.messages import Operation, PartialOperation
from ev3proto.schema.argument import SIZES
from ev3proto.schema.bytewise import Bytewise
from ev3proto.schema.operation import CMD, FamilySchema, OperationSchema
from ev3proto.tables import OPCODES, check_dialect
from ev3proto.tables.declaration import Declaration
from ev3proto.tables.encoding import CONSTANT


class InstructionSet(Bytewise):
    """The schema of byte code: operations one after the other to the end of the bytes."""

    def __init__(self, dialect: str) -> None:
        super().__init__()
        self.dialect = check_dialect(dialect)
        self.opcodes: list[OperationSchema | None] = [None] * 256
        self.families: list[FamilySchema | None] = [None] * 256
        self._short_commands: list[tuple[OperationSchema | None, ...] | None] = [None] * 256
        self.by_name: dict[str, OperationSchema] = {}
        for opcode in OPCODES:
            if dialect not in opcode.dialects:
                continue
            if opcode.is_family:
                family = self.families[opcode.number] = FamilySchema(opcode, dialect)
                self._short_commands[opcode.number] = tuple(family.commands.get(number) for number in range(32))
                self.by_name.update((schema.declaration.name, schema) for schema in family.commands.values())
            else:
                schema = self.opcodes[opcode.number] = OperationSchema(Declaration(opcode), dialect)
                self.by_name[opcode.name] = schema

    def __getitem__(self, name: str) -> OperationSchema:
        """The schema of one operation by name (`SOUND.TONE`, in any case); KeyError suggests the nearest names."""
        found = self.by_name.get(name.upper())
        if found is None:
            raise KeyError(f"the {self.dialect} firmware has no operation {name}{near_misses(name, self.by_name)}")
        return found

    def read(self, data: bytes, at: int) -> tuple[tuple[Operation, ...], int]:
        """All operations from an offset to the end of the bytes. Raises DecodeError."""
        operations, fault = self.read_between(data, at, len(data))
        if fault is not None:
            raise fault
        return operations, len(data)

    def read_between(self, data: bytes, at: int, end: int) -> tuple[tuple[Operation, ...], DecodeError | None]:
        """The operations from one offset to another: all of them and None, or those before a fault and the fault."""
        operations = self.read_quickly(data, at, end)
        return self._carefully(data, at, end) if operations is None else (operations, None)

    def read_quickly(self, data: bytes, at: int, end: int) -> tuple[Operation, ...] | None:
        """All operations from one offset to another, or None where there may be something wrong with them."""
        operations: list[Operation] = []
        opcodes, commands, sizes, append = self.opcodes, self._short_commands, SIZES, operations.append
        try:
            while at < end:
                begin = at
                code = data[at]
                schema = opcodes[code]
                if schema is None:
                    schema = commands[code][data[at + 1]]  # type: ignore[index]
                    at += 2
                else:
                    at += 1
                if schema.plain is None:  # type: ignore[union-attr]
                    at = schema.scan(data, at, end)  # type: ignore[union-attr]
                else:
                    for _ in schema.plain:  # type: ignore[union-attr]
                        at += sizes[data[at]] or data.index(0, at + 1) + 1 - at
                append(Operation((schema, data, begin, at)))  # type: ignore[arg-type]
        except (AttributeError, IndexError, TypeError, ValueError):
            # Unknown opcode or CMD, undefined or missing byte, or only a CMD that is encoded longer than it need be.
            return None
        return tuple(operations) if at == end else None

    def _carefully(self, data: bytes, at: int, end: int) -> tuple[tuple[Operation, ...], DecodeError | None]:
        operations: list[Operation] = []
        while at < end:
            begin = at
            schema: OperationSchema | None = None
            try:
                schema, at = self._select(data, at, end)
                for _, _, behind in schema.walk(data, at, end):
                    at = behind
            except DecodeError as fault:
                if schema is not None:
                    operations.append(PartialOperation((schema, data, begin, at)))
                return tuple(operations), fault
            operations.append(Operation((schema, data, begin, at)))
        return tuple(operations), None

    def _select(self, data: bytes, at: int, end: int) -> tuple[OperationSchema, int]:
        """The schema for the opcode (and CMD) at an offset, and where its arguments start. Raises DecodeError."""
        code = data[at]
        plain = self.opcodes[code]
        if plain is not None:
            return plain, at + 1
        family = self.families[code]
        if family is None:
            raise DecodeError(at, f"0x{code:02X} is no opcode of the {self.dialect} firmware")
        stop = CMD.measure(data, at + 1, end)
        cmd, _ = CMD.read_at(data, at + 1, stop)
        if cmd.kind != CONSTANT:
            raise DecodeError(
                cmd.offset, f"CMD of {family.opcode.name} is {cmd.encoding}: it must be a constant to say what follows"
            )
        schema = family.commands.get(int(cmd.value))
        if schema is None:
            known = ", ".join(f"{number} {found.declaration.command.name}" for number, found in _first(family.commands))
            raise DecodeError(cmd.offset, f"{family.opcode.name} has no CMD {cmd.value} (it has {known}, ...)")
        return schema, stop

    def write(self, value: Any) -> bytes:
        """The byte code of a sequence of operations."""
        return b"".join(operation.raw for operation in value)

    def operation(self, name: str, *values: Any, **named: Any) -> Operation:
        """An operation from values, positional or by parameter name. Raises BuildError."""
        try:
            schema = self[name]
        except KeyError as error:
            raise BuildError(error.args[0]) from None
        if values and named:
            raise BuildError(f"{name}: give its values in order or by name, not both")
        return schema.make(named if named else values)


def _first(commands: dict[int, OperationSchema]) -> list[tuple[int, Any]]:
    return sorted(commands.items())[:3]


@cache
def instruction_set(dialect: str = "official") -> InstructionSet:
    """The instruction set of a dialect, made once. ValueError for an unknown dialect."""
    return InstructionSet(check_dialect(dialect))


def _schema_of(dialect: str, name: str) -> OperationSchema:
    return instruction_set(dialect)[name]


def _by_name(schema: OperationSchema) -> tuple[Any, tuple[str, str]]:
    """A schema is copied and pickled as its name, so that messages are small when they are."""
    return _schema_of, (schema.dialect, schema.declaration.name)


copyreg.pickle(OperationSchema, _by_name)


def operation(name: str, *values: Any, dialect: str = "official", **named: Any) -> Operation:
    """An operation from values, each in its shortest encoding.

    name     `SOUND.TONE`, `UI_FLUSH`, in any case
    values   in the order of the parameters, or by the parameter's name: a number, a text, the name of an enumeration's
             member, a variable (`GV(0)`, `LV(4)`), or bytes that are one encoded argument (`LC2(5)`). A list parameter
             takes a list.

    Raises BuildError, which names the parameter, the value and what would be right.
    """
    return instruction_set(dialect).operation(name, *values, **named)
