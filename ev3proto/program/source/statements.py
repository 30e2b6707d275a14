"""What a source says, whichever dialect it is written in: declarations, objects, operations, their values."""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple


class Number(NamedTuple):
    """A whole number as 32 bits with a sign, or in LEGO's dialect a fraction that a define has."""

    at: int
    value: int


class Float(NamedTuple):
    """A float literal, as the bits of its single."""

    at: int
    bits: int


class Text(NamedTuple):
    """A string: its bytes without the zero."""

    at: int
    data: bytes


class Name(NamedTuple):
    """Whatever the name stands for."""

    at: int
    text: str


class MarkedName(NamedTuple):
    """`@x`, the array that the variable is a handle to; `&x`, what is at the address in it."""

    at: int
    sign: str
    name: Name


class Sum(NamedTuple):
    """An expression: values with an operator between each two.

    is_usual  products are worked out before sums, exactly; else from left to right, each cut to 32 bits
    """

    at: int
    values: tuple[Value, ...]
    operators: tuple[str, ...]
    is_usual: bool = False


class EncodedValue(NamedTuple):
    """`LC2(5)`: a value in the encoding that is named."""

    at: int
    name: str
    value: Value


class RawArgument(NamedTuple):
    """`bytes(81 05)`: an argument, or a piece of code, as its bytes."""

    at: int
    data: bytes


class Unchecked(NamedTuple):
    """`!x`: a value whose type nobody is to look at."""

    at: int
    value: Value


Value = Number | Float | Text | Name | MarkedName | Sum | EncodedValue | RawArgument | Unchecked
Constant = int | Fraction


class DefineStatement(NamedTuple):
    """`define NAME value`."""

    at: int
    name: str
    value: Value


class VariableStatement(NamedTuple):
    """`DATA8 x`, `IN_S text 20`: a variable or a parameter.

    word  the type as it was written
    size  how many elements, where the word wants that
    """

    at: int
    word: str
    name: str
    size: Value | None = None


class LabelStatement(NamedTuple):
    """`again:`."""

    at: int
    name: str


class OperationStatement(NamedTuple):
    """An operation with its arguments."""

    at: int
    name: str
    arguments: tuple[Value, ...]


class ObjectSource(NamedTuple):
    """A thread, a subcall or a block: its kind as a word, its name, what stands between its braces."""

    at: int
    kind: str
    name: str
    body: list[Statement]


Statement = DefineStatement | VariableStatement | LabelStatement | OperationStatement | RawArgument
Item = DefineStatement | VariableStatement | ObjectSource
