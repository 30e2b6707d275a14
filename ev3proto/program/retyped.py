"""Operations whose arguments have types that only the rest of the program shows.

The subcall declares what a CALL hands over, and the operation that made an array what ARRAY.FILL writes. The tables
know neither, so that a float would be read as a whole number. Here such an operation gets a schema that reads it right.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache

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
"""The operations that show the type of the array behind a handle."""

_Handles = dict[tuple[str, int], set[Type]]
"""By the kind and index of the variable that holds a handle: the types of the arrays that it may refer to."""

Kinds = tuple[tuple[Type, Direction], ...]


class RetypedSchema:
    """The schema of an operation, with other types for its last arguments.

    base   the schema by the tables
    first  number of the first argument with another type
    kinds  type and direction of that one and those after it; further arguments stay as they are
    """

    def __init__(self, base: OperationSchema, first: int, kinds: Kinds) -> None:
        self.base = base
        self.declaration = base.declaration
        self.first = first
        self.kinds = kinds
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
            _schema_of_argument(argument, kind, direction).read(data, argument.offset)[0]
            for argument, (kind, direction) in zip(retyped, self.kinds, strict=False)
        )
        return (*kept, *read, *after)

    def __reduce__(self) -> tuple[object, tuple[OperationSchema, int, Kinds]]:
        """Copied and pickled as what it was made from, so that there is one of each."""
        return retyped, (self.base, self.first, self.kinds)


@cache
def _argument_schema(name: str, text: str, kind: Type, direction: Direction) -> ArgumentSchema:
    return ArgumentSchema(Parameter(name, kind, text, direction))


def _schema_of_argument(argument: Argument, kind: Type, direction: Direction) -> ArgumentSchema:
    return _argument_schema(argument.name, argument.parameter.text, kind, direction)


@cache
def retyped(base: OperationSchema, first: int, kinds: Kinds) -> RetypedSchema:
    """Returns the schema of an operation with other types, made once."""
    return RetypedSchema(base, first, kinds)


Callees = Mapping[int, tuple[ProgramParameter, ...]]


def with_types(codes: Sequence[tuple[Operation, ...]], callees: Callees, dialect: str) -> list[tuple[Operation, ...]]:
    """Returns the operations of every code, those of CALL and ARRAY.FILL read with the types that the program shows.

    Args:
        codes: The codes, each once, however many objects share it.
        callees: The parameters that objects declare, by their numbers.
        dialect: The firmware whose instruction set they are read by.
    """
    instructions = instruction_set(dialect)
    call, fill = instructions[CALL], instructions[_FILL]
    makers = {instructions.by_name[name]: kind for name, kind in _MAKERS.items() if name in instructions.by_name}
    shared: _Handles = {}
    own = [_handles(operations, makers, shared) for operations in codes]
    found = []
    for operations, handles in zip(codes, own, strict=True):
        known = handles | shared
        found.append(
            tuple(
                [
                    _typed_call(operation, call, callees)
                    if operation.schema is call
                    else _typed_fill(operation, fill, known)
                    if operation.schema is fill
                    else operation
                    for operation in operations
                ]
            )
        )
    return found


def _handles(operations: tuple[Operation, ...], makers: Mapping[OperationSchema, Type], shared: _Handles) -> _Handles:
    """Returns the variables that hold handles in one code, and the types of their arrays; `shared` gets global ones."""
    found: _Handles = {}
    for operation in operations:
        kind = makers.get(operation.schema)  # type: ignore[call-overload]
        argument = None if kind is None else _handle_of(operation)
        if argument is not None:
            place = found if argument.kind == LOCAL else shared
            place.setdefault((argument.kind, int(argument.value)), set()).add(kind)
    return found


def _handle_of(operation: Operation) -> Argument | None:
    """Returns the variable that holds the array's handle."""
    return next((it for it in operation.arguments if it.is_variable and it.parameter.type is Type.HANDLE), None)


def _typed_call(operation: Operation, schema: OperationSchema, callees: Callees) -> Operation:
    arguments = operation.arguments
    callee = arguments[0] if arguments else None
    if callee is None or callee.kind != CONSTANT or callee.value not in callees:
        return operation
    kinds = _kinds(callees[int(callee.value)])
    return _with_schema(operation, retyped(schema, _FIXED_OF_CALL, kinds))


@cache
def _kinds(parameters: tuple[ProgramParameter, ...]) -> Kinds:
    return tuple((parameter.type, parameter.direction) for parameter in parameters)


def _typed_fill(operation: Operation, schema: OperationSchema, handles: _Handles) -> Operation:
    handle = _handle_of(operation)
    if handle is None or handles.get((handle.kind, int(handle.value))) != {DATAF}:
        return operation
    return _with_schema(operation, retyped(schema, 1, ((DATAF, Direction.IN),)))


def _with_schema(operation: Operation, schema: RetypedSchema) -> Operation:
    _, data, start, end = operation[:4]
    return type(operation)((schema, data, start, end, schema.arguments(data, start, end)))
