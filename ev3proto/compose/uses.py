"""How an operation uses memory: for each argument that is a variable, how many bytes it takes and how it is aligned."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from ev3proto.messages import Argument, Variable
from ev3proto.tables.declaration import Declaration, Direction, Type
from ev3proto.tables.encoding import CONSTANT
from ev3proto.tables.move import INDEX

_UNTYPED_SIZE = 4
"""Bytes of a value whose type only the brick knows: those of the largest number."""


class Use(NamedTuple):
    """One argument that is a variable.

    number     of the argument in the operation, from 0
    name       the parameter's name
    variable   which one
    alignment  what its index has to be a multiple of: 1, 2 or 4
    size       bytes of memory that it takes, at least
    is_open    it may take more, and nobody can tell from the operation
    is_output  the operation writes it
    """

    number: int
    name: str
    variable: Variable
    alignment: int
    size: int
    is_open: bool
    is_output: bool


def uses_of(declaration: Declaration, arguments: Sequence[Argument]) -> list[Use]:
    """The variables among an operation's arguments, in their order."""
    found: list[Use] = []
    lengths: dict[str, Argument] | None = None
    for number, argument in enumerate(arguments):
        if not argument.is_variable:
            continue
        if lengths is None:
            lengths = {other.name: other for other in arguments}
        size, is_open = _extent(declaration, argument, lengths)
        parameter, form = argument.parameter, argument.form
        found.append(
            Use(
                number,
                argument.name,
                Variable(form.kind, int(argument.value), form.handle, form.address),
                _alignment(argument),
                size,
                is_open,
                parameter.direction is not Direction.IN and not form.address,
            )
        )
    return found


def _alignment(argument: Argument) -> int:
    """The validator looks at one type, the operation itself may read another: both have to be served."""
    parameter = argument.parameter
    if argument.form.handle:
        return Type.HANDLE.size
    if parameter.type is Type.ARRAY_TYPED:
        return _UNTYPED_SIZE
    return max(parameter.type.size, parameter.validated.size if parameter.validated else 1, 1)


def _extent(declaration: Declaration, argument: Argument, lengths: Mapping[str, Argument]) -> tuple[int, bool]:
    """Bytes that a variable takes in memory, and whether it may be more."""
    parameter, form = argument.parameter, argument.form
    if form.handle:
        return Type.HANDLE.size, False
    if form.address:
        return Type.DATA32.size, False
    one = _UNTYPED_SIZE if parameter.type is Type.ARRAY_TYPED else max(parameter.type.size, 1)
    if parameter.length is None:
        # READ8 and its kind take an array, of which one element is at INDEX.
        is_array = INDEX in declaration.parameters and not parameter.is_output and parameter is not INDEX
        return one, is_array or parameter.type is Type.STRING
    if isinstance(parameter.length, int):
        return one * parameter.length, False
    length = lengths.get(parameter.length)
    # -1 stands for no limit; other negative lengths are those of bytes in reverse order.
    if length is None or length.kind != CONSTANT or not isinstance(length.value, int) or length.value == -1:
        return one, True
    return max(one * abs(length.value), 1), False
