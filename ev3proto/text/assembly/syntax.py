"""The syntax tree of all notations: values and statements. `at` is always an offset in the text."""

from __future__ import annotations

from typing import NamedTuple


class Pattern(int):
    """An integer written as a bit pattern (hex): 0xFF is -1 for a DATA8."""


# Values


class Number(NamedTuple):
    """A number: an int, a float or a Pattern."""

    at: int
    value: int | float


class Text(NamedTuple):
    """The text between quotes, its escapes replaced."""

    at: int
    value: str


class Name(NamedTuple):
    """A constant, a variable, a label, an object, a CMD."""

    at: int
    text: str


class Element(NamedTuple):
    """`name[3]`: one element of a variable; `name+3`: the byte at that distance from its start."""

    at: int
    text: str
    number: Value
    is_byte: bool = False


class Marked(NamedTuple):
    """`@x`: the array that the variable is a handle to; `&x`: what is at the address in it."""

    at: int
    sign: str
    part: Name | Element


class Distance(NamedTuple):
    """`a:b`: bytes from one label to another."""

    at: int
    start: str
    end: str


class Sum(NamedTuple):
    """Values with operators between them, in their order; each operator has its place and sign."""

    at: int
    values: tuple[Value, ...]
    operators: tuple[tuple[int, str], ...]


class NamedEncoding(NamedTuple):
    """`LC2(440)`, `HND(LV1(4))`: a value in the encoding that is named."""

    at: int
    name: str
    value: Value


class Raw(NamedTuple):
    """`bytes(A3 05)`: an argument or code as bytes."""

    at: int
    data: bytes


class Unchecked(NamedTuple):
    """`!x`: a value whose type is not checked."""

    at: int
    value: Value


Value = Number | Text | Name | Element | Marked | Distance | Sum | NamedEncoding | Raw | Unchecked


class WrittenArgument(NamedTuple):
    """A value, and the name before it, if any: `max_bytes=1000`."""

    name: Name | None
    value: Value

    @property
    def at(self) -> int:
        """The offset of its start."""
        return (self.name or self.value).at


# Statements


class MessageHeader(NamedTuple):
    """`message TYPE counter 42 globals 4`: the start of a message; without a type, of a direct command."""

    at: int
    type: Name | None
    facts: tuple[tuple[Name, Number | Name], ...]


class RawFrame(NamedTuple):
    """`frame`: the start of a frame in bytes, its length field included."""

    at: int


class Define(NamedTuple):
    """`define NAME value`: a name for a constant, a text or an encoded argument. `at` is the name's place."""

    at: int
    name: str
    value: Value


class VariableDeclaration(NamedTuple):
    """`DATA8 x`, `ARRAY8 x 20`, `IN_S text 20`, `local DATAF f`: a variable or a parameter."""

    at: int  # the place of its name
    word: str  # the type as written
    name: str
    size: Value | None = None  # the number of elements, if given
    scope: str | None = None  # the word before it, if any


class Label(NamedTuple):
    """`again:`."""

    at: int
    name: str


class Call(NamedTuple):
    """An operation or a system command with its arguments."""

    at: int
    name: str
    arguments: tuple[WrittenArgument, ...]
    end: int  # the place of a further argument
    is_complete: bool = True  # False if it ends in `...`


class Opening(NamedTuple):
    """`vmthread NAME {`: the start of an object."""

    at: int
    word: str
    name: str
    is_alias: bool = False  # whether it is another head for the code of the object above


class Closing(NamedTuple):
    """`}`."""

    at: int


Statement = MessageHeader | RawFrame | Raw | Define | VariableDeclaration | Label | Call | Opening | Closing
