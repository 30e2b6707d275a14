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
from typing import NamedTuple, TypedDict, Unpack

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


LISTS = (Type.COUNT, Type.VALUES)
"""The types of parameters that stand for a list."""


class Direction(Enum):
    """Which way a parameter carries its value: to the operation, from it, or both."""

    IN = "in"
    OUT = "out"
    INOUT = "inout"

    def __str__(self) -> str:
        return self.value


class Role(Enum):
    """What a parameter is for, where something beside its own argument depends on it.

    Its value is what it is, in a few words.
    """

    JUMP = "how far to jump, or a label"
    LABEL = "the number of a label"
    INDEX = "which element of an array"
    ERROR = "the number of an error"
    OBJECT = "an object of a program"
    LAYER = "a brick of the daisy chain"
    MOTORS = "motor ports, one bit each"
    MOTOR = "one motor port, counted from 0"
    PORT = "one port, of a sensor or a motor"
    PORTS = "a list of ports"
    PRIVATE = "a name, an address or a PIN"


class Effect(Enum):
    """What an operation or system command does besides what its parameters say. The value completes "it ..."."""

    STARTS_SOUND = "starts a sound and returns at once; a sound that is playing ends"
    ENDS_SOUND = "ends the sound that is playing"
    AWAITS_SOUND = "waits until the sound has ended"
    DRAWS = "draws on the canvas, which nobody sees before it is shown"
    WIPES = "draws over all that was on the canvas, or much of it"
    SHOWS = "shows the canvas"
    DIALOG = "takes the display for itself and shows what is on it"
    STARTS_MOVE = "starts a move that ends by itself and returns at once; a move of the same motors ends"
    STOPS_MOTORS = "stops motors"
    AWAITS_MOVE = "waits until the moves of motors have ended"
    RUNS_MOTORS = "makes motors turn"
    SETS_MOTORS = "changes how motors turn, or what their counts are"
    WAITS = "waits, or tells whether to wait: what was begun before it is given some time"
    JUMPS_ALWAYS = "never goes on with the next operation"
    ENDS = "ends the command: nothing after it is run unless something jumps there"
    ENDS_CODE = "ends the code: the firmware reads nothing after it"
    MAY_END = "ends the command itself where its own slot or object is meant"
    NEVER_RUNS = "is refused wherever it stands"
    OF_PROGRAMS = "is about the objects of the program that it stands in"
    WRITES_FILES = "creates, changes or moves files or folders"
    DELETES_FILES = "deletes files or folders"
    CHANGES_SETTINGS = "changes a setting of the brick, which stays when the command has ended"
    RENAMES = "gives the brick another name"
    CONTROLS_PROGRAMS = "starts, stops or changes other programs"
    SENDS_MESSAGES = "puts a message into a mailbox, on which a program may act"
    PRESSES_BUTTONS = "presses a button as if by hand: what that does, up to switching the brick off, is open"
    WRITES_TO_DEVICES = "sends bytes to a device at a port, or sets lines of the brick's circuits"
    RESTARTS = "restarts the brick, or ends its firmware"
    WRITES_FIRMWARE = "erases or writes the memory that the firmware is in"
    RUNS_SHELL = "runs a command on the brick's operating system"
    VARIES = "answers what differs from brick to brick, and from moment to moment"


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
    role       what else depends on it, None where nothing does
    indexed_by  for arrays of which one element is used: the parameter that tells which
    stores     the operation writes that element, so the array is no output that starts at the variable's own place
    names      names of its values besides those of `enum`: the letters of motor ports, names of another enumeration
    unsigned   the firmware reads its bits without sign, so there are numbers up to all bits set
    any_type   for counts: the values that follow have types that others declare, so each is written as what it is
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
    role: Role | None = None
    indexed_by: str | None = None
    stores: bool = False
    names: Mapping[str, int] = MappingProxyType({})
    unsigned: bool = False
    any_type: bool = False

    @property
    def is_output(self) -> bool:
        """True where the operation writes the value."""
        return self.direction is not Direction.IN

    def number_of(self, name: str) -> int | None:
        """The value that a name stands for, None where it is no name of its values.

        Args:
            name: As the firmware spells it; of a mask of motor ports also some joined, `A+B`.
        """
        if self.enum is not None and name in self.enum.members:
            return self.enum.members[name]
        return self.names.get(name)

    def __hash__(self) -> int:
        return hash((self.name, self.text))


class Facts(TypedDict, total=False):
    """What the words below take besides name, type and text; `Parameter` says what each means."""

    unit: str | None
    range: tuple[int, int]
    enum: Enumeration
    special: Mapping[int, str]
    length: str | int
    validated: Type
    note: str
    most: int
    role: Role
    indexed_by: str
    stores: bool
    names: Mapping[str, int]
    unsigned: bool
    any_type: bool


def In(name: str, type: Type, text: str, **facts: Unpack[Facts]) -> Parameter:  # noqa: N802 - a word of the tables' language
    """A parameter that the operation reads."""
    return Parameter(name, type, text, Direction.IN, **facts)


def Out(name: str, type: Type, text: str, **facts: Unpack[Facts]) -> Parameter:  # noqa: N802
    """A parameter that the operation writes."""
    return Parameter(name, type, text, Direction.OUT, **facts)


def InOut(name: str, type: Type, text: str, **facts: Unpack[Facts]) -> Parameter:  # noqa: N802
    """A parameter that the operation reads and writes."""
    return Parameter(name, type, text, Direction.INOUT, **facts)


def Count(  # noqa: N802
    name: str, text: str, element: Type | str = DATA32, elements: Direction = Direction.IN, **facts: Unpack[Facts]
) -> Parameter:
    """A constant that tells how many parameters follow it (PARNO in the firmware)."""
    return Parameter(name, Type.COUNT, text, element=element, elements=elements, **facts)


def Values(name: str, text: str, element: Type, **facts: Unpack[Facts]) -> Parameter:  # noqa: N802
    """As many values as the parameter before it tells (PARVALUES in the firmware)."""
    return Parameter(name, Type.VALUES, text, element=element, **facts)


class Command(NamedTuple):
    """One CMD of a family.

    number      the CMD
    name        the firmware's name
    text        one line: what it means
    parameters  what follows it
    dialects    the firmwares that have it
    note        where the entry differs from other published tables, and why
    effects     what it does besides what its parameters say
    newer       the validator of the release of 2013 does not know it
    """

    number: int
    name: str
    text: str
    parameters: tuple[Parameter, ...] = ()
    dialects: tuple[str, ...] = DIALECTS
    note: str = ""
    effects: tuple[Effect, ...] = ()
    newer: bool = False


class Opcode(NamedTuple):
    """One opcode: either plain, with parameters, or a family whose first parameter is a CMD that selects the rest.

    As in `Command`, and:

    commands   of a family: its CMDs
    cmd_table  of a family: the validator's table that its CMDs are looked up in, where that is not its own; the order
               of these tables is in `ev3proto.tables.validation`
    """

    number: int
    name: str
    text: str
    parameters: tuple[Parameter, ...] = ()
    commands: tuple[Command, ...] = ()
    dialects: tuple[str, ...] = DIALECTS
    note: str = ""
    effects: tuple[Effect, ...] = ()
    newer: bool = False
    cmd_table: str | None = None

    @property
    def is_family(self) -> bool:
        """True where CMD selects the parameters."""
        return bool(self.commands)

    @property
    def validator_table(self) -> str:
        """Of a family: the validator's table that its CMDs are looked up in."""
        return self.cmd_table or self.name


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
    def is_jump(self) -> bool:
        """True where the last parameter says how far to jump, or a label."""
        return bool(self.parameters) and self.parameters[-1].role is Role.JUMP

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

    @property
    def effects(self) -> tuple[Effect, ...]:
        """What it does besides what its parameters say."""
        return self.command.effects if self.command else self.opcode.effects

    @property
    def is_newer(self) -> bool:
        """True where the validator of the release of 2013 does not know it."""
        return self.command.newer if self.command else self.opcode.newer


def declarations(opcodes: tuple[Opcode, ...]) -> Iterator[Declaration]:
    """Every operation that these opcodes make, in their order."""
    for opcode in opcodes:
        if opcode.is_family:
            for command in opcode.commands:
                yield Declaration(opcode, command)
        else:
            yield Declaration(opcode)
