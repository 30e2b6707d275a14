"""What a source says that assembles and is not what the operation takes: warnings, as the strict assembler has errors.

The bytes do not depend on any of it. A `!` in front of an argument keeps them quiet.
"""

from __future__ import annotations

from collections.abc import Sequence

from ev3proto.errors import counted
from ev3proto.program.source.names import Callee, Meaning, ProgramVariable
from ev3proto.program.source.statements import Float, Name, OperationStatement, Sum, Text, Value
from ev3proto.schema.instructions import instruction_set
from ev3proto.schema.operation import FamilySchema, OperationSchema
from ev3proto.tables import OPCODES
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.declaration import DIALECTS, Direction, Parameter, Type
from ev3proto.tables.encoding import BITS, RANGES

_NUMBERS = {opcode.name: opcode.number for opcode in OPCODES}
_COMMANDS = {(opcode.name, command.name) for opcode in OPCODES for command in opcode.commands}
_PARAMETERS = {opcode.name: opcode.parameters for opcode in OPCODES}
_UNTYPED = (Type.ARRAY_TYPED, Type.LABEL, Type.COUNT, Type.VALUES)
_LISTS = (Type.COUNT, Type.VALUES)


class Checks:
    """Looks at operations whose arguments are known, and adds to the warnings."""

    def __init__(self, warnings: list[tuple[int, str]], *, is_strict: bool) -> None:
        self._warnings = warnings
        self._is_strict = is_strict
        self._sets = [instruction_set(dialect) for dialect in DIALECTS]

    def operation(self, step: OperationStatement, values: Sequence[Meaning | None]) -> None:
        """The arguments of an operation, CMD included; None for one that nobody is to look at."""
        number = _NUMBERS[step.name]
        schema, family = self._schemas(number)
        arguments: Sequence[Value] = step.arguments
        if family is not None:
            if not values:
                self._warn(step.at, f"the CMD of {step.name} is missing")
                return
            cmd = values[0]
            if not isinstance(cmd, int):
                return
            families = (it.families[number] for it in self._sets)
            schema = next((it.commands[cmd] for it in families if it is not None and cmd in it.commands), None)
            first = arguments[0]
            if type(first) is Name and (step.name, first.text) not in _COMMANDS:
                self._warn(first.at, f"{first.text[:40]} is no CMD of {step.name}, and counts as the number {cmd}")
            if schema is None:
                self._warn(step.at, f"{step.name} has no CMD {cmd}")
                return
            arguments, values = arguments[1:], values[1:]
        if schema is not None:
            self._parameters(step, schema, arguments, values)

    def _schemas(self, number: int) -> tuple[OperationSchema | None, FamilySchema | None]:
        """The schema of an opcode, or those of its CMDs, in the first dialect that has it."""
        for one in self._sets:
            schema, family = one.opcodes[number], one.families[number]
            if schema is not None or family is not None:
                return schema, family
        return None, None

    def _parameters(
        self,
        step: OperationStatement,
        schema: OperationSchema,
        arguments: Sequence[Value],
        values: Sequence[Meaning | None],
    ) -> None:
        name, fixed = schema.declaration.name, schema.fixed
        wanted: int | None = len(fixed)
        if schema.list_parameter is not None:
            count = values[len(fixed) - 1] if len(values) >= len(fixed) else None
            wanted = len(fixed) + count if isinstance(count, int) else None
        if wanted is not None and len(values) != wanted:
            self._warn(step.at, f"{name} takes {counted(wanted, 'argument')}, and here are {len(values)}")
        for one, argument, value in zip(fixed, arguments, values, strict=False):
            self._one(name, one.parameter, argument, value)

    def call(self, step: OperationStatement, values: Sequence[Meaning | None], callee: Callee) -> None:
        """What a CALL hands over."""
        for place, ((direction, kind), argument, value) in enumerate(
            zip(callee.parameters or (), step.arguments[1:], values, strict=False), 1
        ):
            parameter = Parameter(f"parameter {place}", kind, "", direction)
            self._one("CALL", parameter, argument, value)

    def _one(self, operation: str, parameter: Parameter, argument: Value, value: Meaning | None) -> None:
        """One argument for one parameter."""
        kind = type(value)
        if kind is ProgramVariable:
            if value.type is parameter.type:  # type: ignore[union-attr]
                return
            reason = _place(parameter, value)  # type: ignore[arg-type]
        elif kind is int or kind is Float or kind is Text:
            reason = _constant(parameter, value)  # type: ignore[arg-type]
        else:
            return
        if reason is not None:
            shown = f": {argument.text[:40]}" if isinstance(argument, Name) else ""
            self._warn(argument.at, f"{parameter.name} of {operation} {reason}{shown}")

    def _warn(self, at: int, reason: str) -> None:
        self._warnings.append((at, reason))


def named_number(step: OperationStatement, place: int) -> int | None:
    """The number that names of one parameter alone stand for: letters of motor ports, `A+B`.

    Args:
        step: An operation without CMD, as those of motors are.
        place: The number of the argument, from 0.

    Returns:
        The number, None where the names mean nothing there.
    """
    argument = step.arguments[place]
    names = argument.values if isinstance(argument, Sum) and set(argument.operators) == {"+"} else (argument,)
    parameters = _PARAMETERS[step.name]
    if place >= len(parameters):
        return None
    total = 0
    for name in names:
        number = parameters[place].names.get(name.text) if isinstance(name, Name) else None
        if number is None:
            return None
        total += number
    return total


def _constant(parameter: Parameter, value: int | Float | Text) -> str | None:
    """What is wrong with a constant."""
    kind = parameter.type
    if parameter.direction is Direction.OUT:
        return "is an output, and what is written into a constant is lost"
    if isinstance(value, Float):
        return None if kind in (Type.DATAF, Type.ARRAY_TYPED) else f"is a {kind}, and here is a float"
    if isinstance(value, Text):
        is_text = kind in (Type.STRING, Type.ARRAY_TYPED, Type.DATA8)
        return None if is_text else f"is a {kind}, and here is a string"
    if kind is Type.DATAF:
        if value in (0, CONSTANTS["DATAF_NAN"]):
            return None
        return "is a DATAF, and a whole number means its bits there, while floats end in F"
    if kind is Type.STRING:
        return "is a string, and here is a number"
    limits = RANGES.get(kind) if kind in (Type.DATA8, Type.DATA16) else None
    if parameter.unsigned and value in BITS[kind]:
        return None
    if limits is not None and not limits.low <= value <= limits.high and value != limits.nan & (limits.high * 2 + 1):
        return f"is a {kind}, which reaches from {limits.low} to {limits.high}: it cannot be {value}"
    return None


def _place(parameter: Parameter, place: ProgramVariable) -> str | None:
    """What is wrong with a variable."""
    kind = parameter.type
    if kind in _UNTYPED or kind is Type.HANDLE:
        return None
    if kind is Type.STRING:
        return (
            None if place.type in (Type.STRING, Type.DATA8, Type.HANDLE) else f"is a string, and here is a {place.type}"
        )
    if place.type is Type.STRING:
        return None if kind is Type.DATA8 else f"is a {kind}, and here is a string"
    if place.type.size != kind.size or (place.type is Type.DATAF) is not (kind is Type.DATAF):
        return f"is a {kind}, and here is a {place.type}"
    return None
