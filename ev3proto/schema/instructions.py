"""The instruction set of one dialect: byte code to operations, and operations by name.

`InstructionSet.scan` is how all byte code is read: operations one after the other, each with its arguments.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from enum import Enum, auto
from functools import cache, cached_property
from typing import Any

from ev3proto.errors import BuildError, DecodeError, near_misses
from ev3proto.messages import Argument, Operation, PartialOperation
from ev3proto.schema.argument import SHORT, SIZES, STRINGS, Reader
from ev3proto.schema.bytewise import Bytewise
from ev3proto.schema.operation import CMD, FamilySchema, OperationSchema, operation_schema
from ev3proto.tables import OPCODES, check_dialect
from ev3proto.tables.encoding import CONSTANT, STRING_CODING

_Layout = tuple[Any, int, Sequence[Reader], bool]
"""An operation as `scan` sees it: its schema, the bytes of opcode and CMD, what reads each argument, whether a list of
them follows."""

_BEYOND = 1 << 32
"""An offset, and a number of bytes, that no byte code has."""

_UNUSUAL: _Layout = (None, _BEYOND, (), False)
"""The layout of unknown opcodes and of CMDs that are longer than they need be. It never ends in the byte code."""

PADDING = bytes(64)
"""Zeros after the byte code, each of them an argument of one byte. An operation that is cut off ends among them, since
none has so many arguments."""

_MOST_PADDED = 1 << 17
"""Bytes that are copied to be padded. A longer image of a program would take too long to be copied for each object."""

_ALL_UNUSUAL: list[_Layout | None] = [_UNUSUAL] * 256

_SHORT_HEAD = 2
"""Bytes of an opcode and a CMD in its shortest encoding."""


def _layout(schema: OperationSchema) -> _Layout:
    return schema, len(schema.head), schema.readers, schema.list_parameter is not None


_Each = list[None]
"""An entry for each argument of an operation. To go through it is the fastest way to count."""

_NO_CMD: list[_Each | None] = [None] * 256

_SIZES = tuple(SIZES)

_COUNTS = [[None] * value if encoding.kind == CONSTANT and value >= 0 else None for encoding, value in SHORT]
"""The elements of a list, by its counter where that is one byte. Only constants count."""


def _after_list(data: bytes, at: int, end: int, fixed: Sequence[object]) -> int:
    """The offset after these arguments, the last of which is a list's counter, and after the list's elements."""
    at = _after_arguments(data, at, end, fixed[:-1])
    elements = _COUNTS[data[at]] if data[at] < len(_COUNTS) else None
    return _BEYOND if elements is None else _after_arguments(data, at + 1, end, elements)


def _after_arguments(data: bytes, at: int, end: int, arguments: Iterable[object]) -> int:
    """The offset after so many arguments."""
    for _ in arguments:
        size = _SIZES[data[at]]
        at = at + size if size else _after_string(data, at, end)
    return at


def _after_string(data: bytes, at: int, end: int) -> int:
    """The offset after a string; `_BEYOND` where its zero is missing, or where no argument can start."""
    stop = data.find(0, at + 1, end) if data[at] in STRINGS else -1
    return stop + 1 if stop >= 0 else _BEYOND


def _each(layout: _Layout) -> _Each | None:
    schema, _, readers, has_list = layout
    return None if schema is None or has_list else [None] * len(readers)


class _Flaw(Enum):
    """What is wrong with byte code: nothing, nothing but that its end comes too early, or something else."""

    NONE = auto()
    END = auto()
    FAULT = auto()


class InstructionSet(Bytewise):
    """The schema of byte code: operations one after the other to the end of the bytes."""

    def __init__(self, dialect: str) -> None:
        super().__init__()
        self.dialect = check_dialect(dialect)
        self._entries = {opcode.number: opcode for opcode in OPCODES if dialect in opcode.dialects}
        self._families: dict[int, FamilySchema] = {}
        # What the loop of `scan` knows of an opcode is made when the opcode is first read: there are hundreds of
        # schemas, and a frame has few.
        self._not_laid_out = set(self._entries)
        self._by_opcode: list[_Layout | None] = [_UNUSUAL] * 256
        self._by_command: list[tuple[_Layout, ...]] = [()] * 256
        # The same for `_usual_end`: the arguments of operations without a list.
        self._counts: list[_Each | None] = [None] * 256
        self._command_counts: list[list[_Each | None]] = [_NO_CMD] * 256

    @cached_property
    def opcodes(self) -> list[OperationSchema | None]:
        """The schema of each opcode that has no CMD, None for all others."""
        return [self._plain(code) for code in range(256)]

    @cached_property
    def families(self) -> list[FamilySchema | None]:
        """The schema of each opcode that has a CMD, None for all others."""
        return [self._family(code) for code in range(256)]

    @cached_property
    def by_name(self) -> dict[str, OperationSchema]:
        """The schema of each operation: of `SOUND.TONE`, `UI_FLUSH`, ..."""
        found: dict[str, OperationSchema] = {}
        for code in self._entries:
            family, plain = self._family(code), self._plain(code)
            schemas = [] if family is None else family.commands.values()
            found.update((schema.declaration.name, schema) for schema in ([plain] if plain else schemas))
        return found

    def _plain(self, code: int) -> OperationSchema | None:
        entry = self._entries.get(code)
        return None if entry is None or entry.is_family else operation_schema(entry)

    def _family(self, code: int) -> FamilySchema | None:
        entry = self._entries.get(code)
        if entry is None or not entry.is_family:
            return None
        if code not in self._families:
            self._families[code] = FamilySchema(entry, self.dialect)
        return self._families[code]

    def _lay_out(self, code: int) -> bool:
        """Makes the layouts of an opcode; whether there were none yet."""
        if code not in self._not_laid_out:
            return False
        self._not_laid_out.discard(code)
        family, plain = self._family(code), self._plain(code)
        if family is not None:
            layouts: list[_Layout] = [_UNUSUAL] * 256
            for schema in family.commands.values():
                if len(schema.head) == _SHORT_HEAD:
                    layouts[schema.head[1]] = _layout(schema)
            self._by_command[code] = tuple(layouts)
            self._by_opcode[code] = None
            self._command_counts[code] = [_each(layout) for layout in layouts]
        if plain is not None:
            layout = self._by_opcode[code] = _layout(plain)
            self._counts[code] = _each(layout)
        return True

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

    def is_usual(self, data: bytes, at: int, end: int) -> bool:
        """Says whether nothing but usual operations without a fault stands between two offsets.

        That is most byte code. Of other byte code `is_flawless` says whether there is a fault in it.

        Args:
            data: The bytes that the byte code is in.
            at: The offset of the first opcode.
            end: Where the byte code ends.

        Returns:
            False where there is a fault, or where a CMD or the counter of a list is longer than it need be.

        """
        return self._usual_end(data, at, end) == end

    def _usual_end(self, data: bytes, at: int, end: int) -> int:
        """The offset of the first operation that is at fault or unusual, `end` where there is none."""
        counts, command_counts, sizes = self._counts, self._command_counts, _SIZES
        start = at
        try:
            while at < end:
                start = at
                code = data[at]
                arguments = counts[code]
                at += 1
                if arguments is None:
                    arguments = command_counts[code][data[at]]
                    at += 1
                    if arguments is None:
                        at = self._after_other(data, start, end)
                        continue
                for _ in arguments:  # this is `_after_arguments`, whose call would take as long as the rest
                    size = sizes[data[at]]
                    if size:
                        at += size
                    else:
                        at = _after_string(data, at, end)
        except IndexError:
            # The data ends inside it, or where a CMD would stand of an opcode that is not known yet.
            return self._usual_end(data, start, end) if self._lay_out(data[start]) else start
        return at if at == end else start

    def _after_other(self, data: bytes, at: int, end: int) -> int:
        """The offset after an operation with a list; the same offset where it could not be known as a usual one yet."""
        code = data[at]
        if self._lay_out(code):
            return at
        _, size, readers, has_list = self._by_opcode[code] or self._by_command[code][data[at + 1]]
        return _after_list(data, at + size, end, readers) if has_list else _BEYOND

    def is_flawless(self, data: bytes, at: int, end: int) -> bool:
        """Says whether `scan` would find no fault, in a fifth of the time, because it makes no operations.

        Args:
            data: The bytes that the byte code is in.
            at: The offset of the first opcode.
            end: Where the byte code ends.

        Returns:
            True where there is no fault.

        """
        return self._flaw(data, at, end) is _Flaw.NONE

    def may_become_flawless(self, data: bytes, at: int, end: int) -> bool:
        """Says whether there would be no fault if more followed.

        Args:
            data: The bytes that the byte code is in.
            at: The offset of the first opcode.
            end: Where the byte code ends that is there.

        Returns:
            True where there is no fault, or none but that the end comes too early.

        """
        return self._flaw(data, at, end) is not _Flaw.FAULT

    def _flaw(self, data: bytes, at: int, end: int) -> _Flaw:
        while True:
            at = self._usual_end(data, at, end)
            if at == end:
                return _Flaw.NONE
            if self._is_unknown(data, at, end):
                return _Flaw.FAULT
            operation, fault = self._scan_one(data, at, end)
            if operation is None or fault is not None:
                return _Flaw.END if fault is not None and fault.truncated else _Flaw.FAULT
            at += operation.length

    def _is_unknown(self, data: bytes, at: int, end: int) -> bool:
        """Whether nothing has that opcode, or that CMD in a form of one byte."""
        code = data[at]
        self._lay_out(code)
        if self._by_opcode[code] is not None:
            return self._by_opcode[code] is _UNUSUAL
        return at + 1 < end and data[at + 1] < len(SHORT) and self._by_command[code][data[at + 1]] is _UNUSUAL

    def usual_schema(self, data: bytes, at: int) -> OperationSchema | None:
        """The schema of the operation at an offset, in bytes in which there is no fault.

        None where its CMD is longer than it need be.
        """
        code = data[at]
        if code in self._not_laid_out:
            self._lay_out(code)
        schema: OperationSchema | None = (self._by_opcode[code] or self._by_command[code][data[at + 1]])[0]
        return schema

    def operations(self, data: bytes, at: int) -> tuple[Operation, ...]:
        """Reads all operations from an offset to the end of bytes in which there is no fault."""
        return tuple(self.scan(data, at, len(data))[0])

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
        # The loop is `_scan_one` without its calls, checks and sentences. `_scan_one` looks again at whatever does not
        # end where it should. With `_scan_one` alone, parsing with every value read takes 3.5 times the plain
        # decoder's time instead of 1.5: `pytest benchmarks`.
        is_long = len(data) > _MOST_PADDED
        padded = b"" if is_long else data + PADDING
        by_opcode, by_command = _ALL_UNUSUAL if is_long else self._by_opcode, self._by_command
        short_forms = SHORT
        layout: _Layout | None = None
        while at < end:
            start = at
            schema, size, readers, has_list = layout or by_opcode[data[at]] or by_command[data[at]][padded[at + 1]]
            layout = None
            at += size
            arguments: list[Argument] = []
            if has_list:
                readers = schema.readers_with_list(arguments, end)
            for parameter, long_forms in readers:
                first = padded[at]
                if first < 128:
                    encoding, value = short_forms[first]
                    arguments.append(Argument((parameter, encoding, value, at, data)))
                    at += 1
                    continue
                form = long_forms[first]
                if form is None:
                    at = _BEYOND
                    break
                encoding, unpack, size = form
                if unpack is None:
                    stop = padded.index(0, at + 1)
                    text = padded[at + 1 : stop].decode(STRING_CODING)
                    arguments.append(Argument((parameter, encoding, text, at, data)))
                    at = stop + 1
                else:
                    arguments.append(Argument((parameter, encoding, unpack(padded, at)[0], at, data)))
                    at += size
            if at <= end and (not has_list or schema.has_whole_list(arguments)):
                operations.append(Operation((schema, data, start, at, tuple(arguments))))
                continue
            if self._lay_out(data[start]):
                at = start
                continue
            if size == _BEYOND and not is_long:
                layout = self._with_long_cmd(data, start)
                if layout is not None:
                    at = start
                    continue
            operation, fault = self._scan_one(data, start, end)
            if operation is not None:
                operations.append(operation)
                at = start + operation.length
            if fault is not None:
                return operations, fault
        return operations, None

    def _with_long_cmd(self, data: bytes, at: int) -> _Layout | None:
        """The layout of an operation whose CMD is longer than it need be, None where there is no such operation."""
        family = self._family(data[at])
        if family is None:
            return None
        try:
            cmd, stop = CMD.read(data, at + 1)
        except DecodeError:
            return None
        schema = family.commands.get(int(cmd.value)) if cmd.kind == CONSTANT else None
        return None if schema is None else (schema, stop - at, schema.readers, schema.list_parameter is not None)

    def _scan_one(self, data: bytes, start: int, end: int) -> tuple[Operation | None, DecodeError | None]:
        """Reads one operation of any kind: the operation as far as it can be read, and what is wrong with it."""
        try:
            schema, at = self._select(data, start, end)
        except DecodeError as fault:
            return None, fault
        try:
            for _, _, stop in schema.scan(data, at, end):
                at = stop
        except DecodeError as fault:
            return PartialOperation((schema, data, start, at)), fault
        # With its arguments, as the loop of `scan` makes it: to read those of a list takes as long as all else.
        return Operation((schema, data, start, at, schema.arguments(data, start))), None

    def _select(self, data: bytes, at: int, end: int) -> tuple[OperationSchema, int]:
        """The schema for the opcode (and CMD) at an offset, and where its arguments start. Raises DecodeError."""
        code = data[at]
        plain = self._plain(code)
        if plain is not None:
            return plain, at + 1
        family = self._family(code)
        if family is None:
            raise DecodeError(at, f"0x{code:02X} is no opcode of the {self.dialect} firmware")
        stop = CMD.measure(data, at + 1, end)
        cmd = CMD.read_measured(data, at + 1, stop)
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
        """Writes a sequence of operations as byte code. Raises BuildError for what is no operation."""
        for operation in value:
            if not isinstance(operation, Operation):
                raise BuildError(f"{operation!r} is no operation: ev3proto.operation makes one")
        return b"".join(operation.raw for operation in value)

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
        schema = self.by_name.get(name)
        if schema is None:
            try:
                schema = self[name]
            except KeyError as error:
                raise BuildError(error.args[0]) from None
        if values and named:
            raise BuildError(f"{name}: give its values in order or by name, not both")
        return schema.make(named or values)


def _first(commands: dict[int, OperationSchema]) -> list[tuple[int, Any]]:
    return sorted(commands.items())[:3]


@cache
def _made(dialect: str) -> InstructionSet:
    return InstructionSet(dialect)


def instruction_set(dialect: str = "official") -> InstructionSet:
    """Finds the instruction set of a dialect, which is made once.

    Args:
        dialect: "official", "xtended" or "compat".

    Returns:
        The instruction set. `instruction_set()["SOUND.TONE"]` is the schema of one operation.

    Raises:
        ValueError: There is no such dialect.
    """
    return _made(dialect)


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
