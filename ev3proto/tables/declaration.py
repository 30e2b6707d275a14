"""The words in which the tables are written: types, parameters, commands, opcodes, enumerations.

Nothing here knows a single opcode. The tables beside this file use these words to say what the firmware knows, and
everything else in the project (schemas, texts, dissector, exports) reads what they say.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import Enum
from functools import cached_property
from types import MappingProxyType
from typing import NamedTuple

DIALECTS = ("official", "xtended", "compat")
"""The firmwares whose instruction sets differ: LEGO's own, the community's extended one, its compatible sibling."""

EXTENSIONS = ("xtended", "compat")
"""What an entry names that LEGO's firmware does not have."""

UNRELEASED = ()
"""What an entry names that has a number in the headers and no code in any firmware."""


class Type(Enum):
    """What a parameter holds; the name is what people read, `size` the bytes of one value in memory (0: it varies)."""

    DATA8 = ("DATA8", 1)
    DATA16 = ("DATA16", 2)
    DATA32 = ("DATA32", 4)
    DATAF = ("DATAF", 4)
    STRING = ("string", 0)
    HANDLE = ("handle", 2)
    ARRAY_TYPED = ("array-typed", 0)
    LABEL = ("label", 4)
    COUNT = ("count", 0)
    VALUES = ("values", 0)

    def __init__(self, label: str, size: int) -> None:
        self.label = label
        self.size = size

    def __str__(self) -> str:
        return self.label


class Direction(Enum):
    """Which way a parameter carries its value: to the operation, from it, or both."""

    IN = "in"
    OUT = "out"
    INOUT = "inout"

    def __str__(self) -> str:
        return self.value


DATA8, DATA16, DATA32, DATAF = Type.DATA8, Type.DATA16, Type.DATA32, Type.DATAF
STRING, HANDLE, ARRAY_TYPED, LABEL = Type.STRING, Type.HANDLE, Type.ARRAY_TYPED, Type.LABEL


class Enumeration(NamedTuple):
    """Names of numbers, as the firmware spells them.

    `members` maps each name to its number; where two names share a number the first is the one shown.
    `end` is the name the firmware gives to the number after the last (or to a mask of all): a constant, never a value.
    With `flags` the value is a set of bits and each member one of them.
    """

    name: str
    text: str
    members: Mapping[str, int]
    end: tuple[str, int] | None = None
    flags: bool = False
    dialects: tuple[str, ...] = DIALECTS

    def name_of(self, value: object) -> str | None:
        """The name of a number (`A|B` for flags), None when it has none."""
        if not isinstance(value, int):
            return None
        for name, number in self.members.items():
            if number == value:
                return name
        if self.flags and value:
            parts = [name for name, number in self.members.items() if value & number == number]
            if parts and sum(self.members[part] for part in parts) == value & 0xFF:
                return "|".join(parts)
        return None

    def __hash__(self) -> int:
        return hash(self.name)


class Parameter(NamedTuple):
    """One parameter of an operation, as the firmware reads it.

    name       the firmware's name
    type       what it holds
    text       one line: what it means
    direction  to the operation, from it, or both
    unit       of the value, as people write it ("ms", "Hz", "%"); None where it has none
    range      smallest and largest value that makes sense, both included; None where the type alone limits it
    enum       names of its values
    special    single values with a meaning of their own
    length     for strings, arrays and buffers: the parameter that tells how many bytes (strings) or elements (others)
               there are, or that number itself where it is fixed
    element    for counts and value lists: the type of what follows, or the name of the parameter that tells the type
    elements   for counts: the direction of what follows
    validated  the type the firmware's validator checks it as, where that is not the type it has
    most       for texts: largest number of bytes, the zero included, where the firmware has a limit
    note       why the entry differs from other published tables, where it does
    """

    name: str
    type: Type
    text: str
    direction: Direction = Direction.IN
    unit: str | None = None
    range: tuple[int, int] | None = None
    enum: Enumeration | None = None
    special: Mapping[int, str] = MappingProxyType({})
    length: str | int | None = None
    element: Type | str | None = None
    elements: Direction = Direction.IN
    validated: Type | None = None
    note: str = ""
    most: int | None = None

    @property
    def is_output(self) -> bool:
        """True where the operation writes the value."""
        return self.direction is not Direction.IN

    def __hash__(self) -> int:
        return hash((self.name, self.text))


def In(name: str, type: Type, text: str, **more: object) -> Parameter:  # noqa: N802 - a word of the tables' language
    """A parameter that the operation reads."""
    return Parameter(name, type, text, Direction.IN, **more)  # type: ignore[arg-type]


def Out(name: str, type: Type, text: str, **more: object) -> Parameter:  # noqa: N802
    """A parameter that the operation writes."""
    return Parameter(name, type, text, Direction.OUT, **more)  # type: ignore[arg-type]


def InOut(name: str, type: Type, text: str, **more: object) -> Parameter:  # noqa: N802
    """A parameter that the operation reads and writes."""
    return Parameter(name, type, text, Direction.INOUT, **more)  # type: ignore[arg-type]


def Count(  # noqa: N802
    name: str, text: str, element: Type | str = DATA32, elements: Direction = Direction.IN, **more: object
) -> Parameter:
    """A constant that tells how many parameters follow it (PARNO in the firmware)."""
    return Parameter(name, Type.COUNT, text, element=element, elements=elements, **more)  # type: ignore[arg-type]


def Values(name: str, text: str, element: Type, **more: object) -> Parameter:  # noqa: N802
    """As many values as the parameter before it tells (PARVALUES in the firmware)."""
    return Parameter(name, Type.VALUES, text, element=element, **more)  # type: ignore[arg-type]


class Command(NamedTuple):
    """One CMD of a family: its number, the firmware's name, one line of meaning, the parameters that follow it."""

    number: int
    name: str
    text: str
    parameters: tuple[Parameter, ...] = ()
    dialects: tuple[str, ...] = DIALECTS
    note: str = ""


class Opcode(NamedTuple):
    """One opcode: either plain, with parameters, or a family whose first parameter is a CMD that selects the rest."""

    number: int
    name: str
    text: str
    parameters: tuple[Parameter, ...] = ()
    commands: tuple[Command, ...] = ()
    dialects: tuple[str, ...] = DIALECTS
    note: str = ""

    @property
    def is_family(self) -> bool:
        """True where CMD selects the parameters."""
        return bool(self.commands)


@dataclass(frozen=True)
class Declaration:
    """An opcode together with its CMD if it has one: what the tables say of one operation."""

    opcode: Opcode
    command: Command | None = None

    @cached_property
    def name(self) -> str:
        """`SOUND.TONE`, or `UI_FLUSH` where there is no CMD."""
        return f"{self.opcode.name}.{self.command.name}" if self.command else self.opcode.name

    @property
    def text(self) -> str:
        """One line of meaning."""
        return self.command.text if self.command else self.opcode.text

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """What follows the opcode and CMD."""
        return self.command.parameters if self.command else self.opcode.parameters

    @property
    def dialects(self) -> tuple[str, ...]:
        """The firmwares that have it."""
        if self.command is None:
            return self.opcode.dialects
        return tuple(dialect for dialect in self.command.dialects if dialect in self.opcode.dialects)

    @property
    def note(self) -> str:
        """Where the entry differs from other published tables, and why."""
        return self.command.note if self.command else self.opcode.note


def declarations(opcodes: tuple[Opcode, ...]) -> Iterator[Declaration]:
    """Every operation that these opcodes make, in their order."""
    for opcode in opcodes:
        if opcode.is_family:
            for command in opcode.commands:
                yield Declaration(opcode, command)
        else:
            yield Declaration(opcode)
