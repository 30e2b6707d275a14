"""What a text says in whichever notation: values and statements. `at` is always an offset in the text."""

from __future__ import annotations

from typing import NamedTuple


class Pattern(int):
    """A whole number that was written as the bits it has, as hex is: 0xFF is -1 where a DATA8 is meant."""


# Values


class Number(NamedTuple):
    """A number as it was written: a float where it is one, a Pattern where its bits were written."""

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
    """Values with an operator between each two, as they were written; of each operator its place and sign."""

    at: int
    values: tuple[Value, ...]
    operators: tuple[tuple[int, str], ...]


class Form(NamedTuple):
    """`LC2(440)`, `HND(LV1(4))`: a value in the encoding that is named."""

    at: int
    name: str
    value: Value


class Raw(NamedTuple):
    """`bytes(A3 05)`: an argument, or a piece of code, as its bytes."""

    at: int
    data: bytes


class Unchecked(NamedTuple):
    """`!x`: a value whose type is not to be checked."""

    at: int
    value: Value


Value = Number | Text | Name | Element | Marked | Distance | Sum | Form | Raw | Unchecked


class WrittenArgument(NamedTuple):
    """A value, and the name in front of it where it has one: `max_bytes=1000`."""

    name: Name | None
    value: Value

    @property
    def at(self) -> int:
        """Where it starts."""
        return (self.name or self.value).at


# Statements


class Header(NamedTuple):
    """`message TYPE counter 42 globals 4`: what follows is a message of its own. Without a type: a direct command."""

    at: int
    type: Name | None
    facts: tuple[tuple[Name, Number | Name], ...]


class RawFrame(NamedTuple):
    """`frame`: what follows are the bytes of a whole frame, its length field included."""

    at: int


class Define(NamedTuple):
    """`define NAME value`: a name for a constant, a text or an encoded argument. `at` is the name's place."""

    at: int
    name: str
    value: Value


class Declaration(NamedTuple):
    """`DATA8 x`, `ARRAY8 x 20`, `IN_S text 20`, `local DATAF f`: a variable or a parameter.

    at     where its name is
    word   the type as it was written
    size   how many elements, where that is said
    scope  the word in front of it, None where there is none
    """

    at: int
    word: str
    name: str
    size: Value | None = None
    scope: str | None = None


class Label(NamedTuple):
    """`again:`."""

    at: int
    name: str


class Call(NamedTuple):
    """An operation or a system command with its arguments.

    end          the place of a further argument
    is_complete  False where it ends in `...`
    """

    at: int
    name: str
    arguments: tuple[WrittenArgument, ...]
    end: int
    is_complete: bool = True


class Opening(NamedTuple):
    """`vmthread NAME {`: the object that the following statements belong to.

    is_alias  it is a second head of the object that was opened: another header for the same code
    """

    at: int
    word: str
    name: str
    is_alias: bool = False


class Closing(NamedTuple):
    """`}`."""

    at: int


Statement = Header | RawFrame | Raw | Define | Declaration | Label | Call | Opening | Closing
