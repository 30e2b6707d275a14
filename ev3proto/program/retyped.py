"""Operations whose argument types depend on the rest of the program.

The subcall declares the arguments of a CALL, and the operation that made an array determines those of ARRAY.FILL. The
tables know neither, so a float would be read as a whole number. Here such an operation gets the right schema.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import NamedTuple

from ev3proto.messages import Argument, Operation
from ev3proto.program.parameters import ProgramParameter
from ev3proto.schema.argument import ArgumentSchema
from ev3proto.schema.instructions import OperationSchema, instruction_set
from ev3proto.tables.declaration import DATA8, DATA16, DATA32, DATAF, Direction, Parameter, Type
from ev3proto.tables.encoding import CONSTANT, LOCAL

CALL = "CALL"
_FIXED_OF_CALL = 2
_FILL = "ARRAY.FILL"
_MAKERS = {
    f"ARRAY.{word}{suffix}": kind
    for word in ("CREATE", "INIT")
    for suffix, kind in (("8", DATA8), ("16", DATA16), ("32", DATA32), ("F", DATAF))
}
"""The operations that create arrays, and the types of their elements."""

Handles = dict[tuple[str, int], Type | None]
"""By the kind and index of the variable that holds a handle: the type of its array; None if several are made."""

Kinds = tuple[tuple[Type, Direction], ...]


class RetypedSchema:
    """The schema of an operation, with other types for its last arguments."""

    def __init__(self, base: OperationSchema, first: int, kinds: Kinds) -> None:
        self.base = base  # the schema by the tables
        self.declaration = base.declaration
        self.first = first  # number of the first argument with another type
        self.kinds = kinds  # type and direction of that one and those after it; further arguments stay as they are
        self.has_outputs = base.has_outputs or any(direction is not Direction.IN for _, direction in kinds)

    def selector(self, data: bytes, at: int) -> Argument | None:
        """CMD of the operation at an offset."""
        return self.base.selector(data, at)

    def arguments(self, data: bytes, at: int, end: int) -> tuple[Argument, ...]:
        """Returns the arguments of the operation whose opcode is at an offset."""
        return self._retyped(data, self.base.arguments(data, at, end))

    def _retyped(self, data: bytes, arguments: tuple[Argument, ...]) -> tuple[Argument, ...]:
        kept = arguments[: self.first]
        retyped = arguments[self.first : self.first + len(self.kinds)]
        after = arguments[self.first + len(self.kinds) :]
        read = (
            _argument_schema(argument.name, argument.parameter.text, kind, direction).read(data, argument.offset)[0]
            for argument, (kind, direction) in zip(retyped, self.kinds, strict=False)
        )
        return (*kept, *read, *after)

    def __reduce__(self) -> tuple[object, tuple[OperationSchema, int, Kinds]]:
        """Copies and pickles by reference to its base schema, so instances stay unique."""
        return retyped, (self.base, self.first, self.kinds)


@cache
def _argument_schema(name: str, text: str, kind: Type, direction: Direction) -> ArgumentSchema:
    return ArgumentSchema(Parameter(name, kind, text, direction))


@cache
def retyped(base: OperationSchema, first: int, kinds: Kinds) -> RetypedSchema:
    """Returns the schema of an operation with other types; the same one for the same arguments."""
    return RetypedSchema(base, first, kinds)


class HandleFinder:
    """Finds the types of arrays in operations, by the variables that hold their handles."""

    def __init__(self, dialect: str) -> None:
        instructions = instruction_set(dialect)
        self._makers = {
            instructions.by_name[name]: kind for name, kind in _MAKERS.items() if name in instructions.by_name
        }

    def note(self, operation: Operation, own: Handles, shared: Handles) -> None:
        """Notes the array that an operation makes: in `own` if a local variable holds its handle, else in `shared`."""
        kind = self._makers.get(operation.schema)  # type: ignore[call-overload]
        argument = None if kind is None else _handle_of(operation)
        if argument is not None:
            known, place = own if argument.kind == LOCAL else shared, (argument.kind, int(argument.value))
            known[place] = kind if known.get(place, kind) is kind else None


class Types(NamedTuple):
    """Argument types in one code that follow from the rest of the program."""

    callees: Mapping[int, tuple[ProgramParameter, ...]]  # the parameters that objects declare, by their numbers
    own: Handles  # the arrays whose handles local variables of the code hold
    shared: Handles  # the arrays whose handles global variables hold
    dialect: str  # the firmware whose instruction set the code is read by

    def typed(self, operation: Operation) -> Operation:
        """Returns the operation; CALL and ARRAY.FILL with the types that follow from the program."""
        name = operation.full_name
        if name == CALL:
            return self._call(operation)
        return self._fill(operation) if name == _FILL else operation

    def _call(self, operation: Operation) -> Operation:
        arguments = operation.arguments
        callee = arguments[0] if arguments else None
        if callee is None or callee.kind != CONSTANT or callee.value not in self.callees:
            return operation
        kinds = tuple((parameter.type, parameter.direction) for parameter in self.callees[int(callee.value)])
        return self._read(operation, _FIXED_OF_CALL, kinds)

    def _fill(self, operation: Operation) -> Operation:
        handle = _handle_of(operation)
        if handle is None:
            return operation
        known = self.own if handle.kind == LOCAL else self.shared
        if known.get((handle.kind, int(handle.value))) is not DATAF:
            return operation
        return self._read(operation, 1, ((DATAF, Direction.IN),))

    def _read(self, operation: Operation, first: int, kinds: Kinds) -> Operation:
        return operation.read_by(retyped(instruction_set(self.dialect)[operation.full_name], first, kinds))


def _handle_of(operation: Operation) -> Argument | None:
    """Returns the variable that holds the array's handle."""
    return next((it for it in operation.arguments if it.is_variable and it.parameter.type is Type.HANDLE), None)
