"""The instruction set of one dialect: byte code to operations, and operations by name.

`InstructionSet.scan` is how all byte code is read: operations one after the other, each with its arguments.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

from ev3proto.errors import BuildError, DecodeError, near_misses
from ev3proto.messages import Argument, Operation, PartialOperation
from ev3proto.schema.argument import read_arguments
from ev3proto.schema.bytewise import Bytewise
from ev3proto.schema.operation import CMD, FamilySchema, OperationSchema, operation_schema
from ev3proto.tables import OPCODES, check_dialect
from ev3proto.tables.encoding import CONSTANT


class InstructionSet(Bytewise):
    """The schema of byte code: operations one after the other to the end of the bytes.

    dialect   the firmware that it is of
    opcodes   the schema of each opcode that has no CMD, None for all others
    families  the schemas of each opcode that has a CMD, None for all others
    by_name   the schema of each operation: of `SOUND.TONE`, `UI_FLUSH`, ...
    """

    def __init__(self, dialect: str) -> None:
        super().__init__()
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
        """Finds the schema of one operation.

        Args:
            name: `SOUND.TONE`, in any case.

        Returns:
            The schema.

        Raises:
            KeyError: There is no such operation. The error suggests the nearest names.
        """
        if not isinstance(name, str):
            raise KeyError(f"the name of an operation is a text, such as SOUND.TONE, not {name!r}")
        found = self.by_name.get(name.upper())
        if found is None:
            raise KeyError(f"the {self.dialect} firmware has no operation {name}{near_misses(name, self.by_name)}")
        return found

    def read(self, data: bytes, at: int) -> tuple[tuple[Operation, ...], int]:
        """Reads all operations from an offset to the end of the bytes.

        Args:
            data: The byte code.
            at: The offset of the first opcode.

        Returns:
            The operations, and the end.

        Raises:
            DecodeError: An operation is faulty.
        """
        operations, fault = self.scan(data, at, len(data))
        if fault is not None:
            raise fault
        return tuple(operations), len(data)

    def scan(self, data: bytes, at: int, end: int) -> tuple[list[Operation], DecodeError | None]:
        """Reads the operations from one offset to another, up to the first that is faulty.

        Args:
            data: The bytes that the byte code is in.
            at: The offset of the first opcode.
            end: Where the byte code ends.

        Returns:
            The operations, and what is wrong with the next one. The last operation is a `PartialOperation` where only
            its first arguments can be read.

        """
        operations: list[Operation] = []
        opcodes = self.opcodes
        while at < end:
            start = at
            schema = opcodes[data[at]]
            arguments: list[Argument] = []
            try:
                if schema is None:
                    schema, at = self._select(data, at, end)
                else:
                    at += 1
                at = read_arguments(schema.readers, data, at, end, arguments)
                if schema.list_parameter is not None:
                    at = read_arguments(schema.elements(arguments, end - at), data, at, end, arguments)
            except DecodeError as fault:
                if schema is not None:
                    stop = arguments[-1].offset + arguments[-1].length if arguments else at
                    operations.append(PartialOperation((schema, data, start, stop, tuple(arguments))))
                return operations, fault.with_traceback(None)  # a traceback keeps what is on the stack
            operations.append(Operation((schema, data, start, at, tuple(arguments))))
        return operations, None

    def _select(self, data: bytes, at: int, end: int) -> tuple[OperationSchema, int]:
        """The schema for the opcode and CMD at an offset, and where its arguments start. Raises DecodeError."""
        family = self.families[data[at]]
        if family is None:
            raise DecodeError(at, f"0x{data[at]:02X} is no opcode of the {self.dialect} firmware")
        schema = family.short.get(data[at + 1]) if at + 1 < end else None
        if schema is not None:
            return schema, at + 2
        found: list[Argument] = []
        stop = read_arguments((CMD.reader,), data, at + 1, end, found)
        _, form, number, *_ = found[0]
        if form.kind != CONSTANT:
            raise DecodeError(
                at + 1, f"CMD of {family.opcode.name} is {form.name}: it must be a constant to say what follows"
            )
        schema = family.commands.get(number)
        if schema is None:
            known = ", ".join(f"{number} {found.declaration.command.name}" for number, found in _first(family.commands))
            raise DecodeError(at + 1, f"{family.opcode.name} has no CMD {number} (it has {known}, ...)")
        return schema, stop

    def write(self, value: Any) -> bytes:
        """Writes operations as byte code.

        Args:
            value: Operations, one after the other. A mapping is one, too: its `name` and `command`, as an `Operation`
                has them, and as `arguments` what `OperationSchema.write` takes.

        Returns:
            The byte code.

        Raises:
            BuildError: Something is no operation, or an operation cannot have its arguments.

        """
        return b"".join([self._written(operation) for operation in value])

    def _written(self, operation: Any) -> bytes:
        if isinstance(operation, Operation):
            return operation.raw
        if not isinstance(operation, Mapping) or "name" not in operation:
            raise BuildError(f"{operation!r} is no operation: ev3proto.operation makes one")
        name = ".".join(filter(None, (operation["name"], operation.get("command"))))
        return self._named(name).write(operation.get("arguments", ()))

    def _named(self, name: str) -> OperationSchema:
        try:
            return self.by_name.get(name) or self[name]
        except KeyError as error:
            raise BuildError(error.args[0]) from None

    def operation(self, name: str, *values: Any, **named: Any) -> Operation:
        """Makes an operation of values.

        Args:
            name: `SOUND.TONE`, `UI_FLUSH`, in any case.
            values: Values in the order of the parameters.
            named: Values by the parameter's name, in place of `values`.

        Returns:
            The operation by itself, at offset 0.

        Raises:
            BuildError: There is no such operation, or it cannot have these values.

        """
        schema = self._named(name)
        if values and named:
            raise BuildError(f"{name}: give its values in order or by name, not both")
        return schema.make(named or values)


def _first(commands: dict[int, OperationSchema]) -> list[tuple[int, Any]]:
    return sorted(commands.items())[:3]


@cache
def instruction_set(dialect: str = "official") -> InstructionSet:
    """Finds the instruction set of a dialect, which is made once.

    Args:
        dialect: "official", "xtended" or "compat".

    Returns:
        The instruction set. `instruction_set()["SOUND.TONE"]` is the schema of one operation.

    Raises:
        ValueError: There is no such dialect.
    """
    return InstructionSet(dialect)


def operation(name: str, *values: Any, dialect: str = "official", **named: Any) -> Operation:
    """Makes an operation of values, each in its shortest encoding.

    Args:
        name: `SOUND.TONE`, `UI_FLUSH`, in any case.
        values: Values in the order of the parameters: numbers, texts, names of an enumeration's members, variables
            (`GV(0)`, `LV(4)`), or bytes that are one encoded argument (`LC2(5)`). A list parameter takes a list.
        dialect: "official", "xtended" or "compat": the firmware whose operation it is.
        named: Values by the parameter's name, in place of `values`.

    Returns:
        The operation by itself, at offset 0.

    Raises:
        BuildError: There is no such operation, or it cannot have these values. The error names the parameter, the
            value and what would be right.
        ValueError: There is no such dialect.
    """
    return instruction_set(dialect).operation(name, *values, **named)
