"""The vocabulary of the tables: types, parameters, commands, opcodes, enumerations.

No opcode is defined here. The tables beside this file use these classes to describe the firmware, and
everything else in the project (schemas, texts, dissector, exports) reads those tables.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import Enum
from functools import cached_property
from types import MappingProxyType
from typing import NamedTuple, TypedDict, Unpack

DIALECTS = ("official", "xtended", "compat")
"""The firmwares with different instruction sets: LEGO's own, the community's extended one, its compatible sibling."""

EXTENSIONS = ("xtended", "compat")
"""The dialects of an entry that LEGO's firmware lacks."""

UNRELEASED = ()
"""The dialects of an entry that has a number in the headers but no code in any firmware."""


class Type(Enum):
    """The type of a parameter; its value is the name, `size` the bytes of one value in memory (0: it varies)."""

    DATA8 = ("DATA8", 1)
    DATA16 = ("DATA16", 2)
    DATA32 = ("DATA32", 4)
    DATAF = ("DATAF", 4)
    STRING = ("string", 0)
    HANDLE = ("handle", 2)
    ARRAY_TYPED = ("array-typed", 0)
    LABEL = ("label", 4)

    def __init__(self, label: str, size: int) -> None:
        self.label = label
        self.size = size

    def __str__(self) -> str:
        return self.label


class Direction(Enum):
    """The direction of a parameter's value: to the operation, from it, or both."""

    IN = "in"
    OUT = "out"
    INOUT = "inout"

    def __str__(self) -> str:
        return self.value


class Role(Enum):
    """The role of a parameter on which something besides its own argument depends.

    The value describes it in a few words.
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
    DRIVE = "power or speed of motors; negative: backward"
    PORTS = "a list of ports"
    FILE = "the handle of a file that the same command opens"
    ADDRESS = "the address of a program, which only the brick knows"
    ARRAY = "the handle of an array that the same command creates"
    FORMAT = "a format of C's printf"
    SI_READING = "a reading of a device in its unit, as its type and mode tell"
    RAW_READING = "a raw reading of a device"
    PUBLIC = "a text or list that says nothing about its owner: names of devices and modes, units, versions"


class Effect(Enum):
    """A side effect of an operation or system command that its parameters do not show. The value completes "it ...".

    READS and COMPUTES say that there is none: untrusted clients, and replays, may read. What reads changes nothing with
    any constants in their domain, and any variables within the memory that is requested.
    """

    STARTS_SOUND = "starts a sound and returns at once; a sound that is playing ends"
    ENDS_SOUND = "ends the sound that is playing"
    AWAITS_SOUND = "waits until the sound has ended"
    DRAWS = "draws on the canvas, which stays invisible until it is shown"
    WIPES = "draws over most or all of the canvas"
    SHOWS = "shows the canvas"
    DIALOG = "takes over the display and shows its content"
    STARTS_MOVE = "starts a move that ends by itself and returns at once; a move of the same motors ends"
    STOPS_MOTORS = "stops motors"
    AWAITS_MOVE = "waits until the moves of motors have ended"
    RUNS_MOTORS = "makes motors turn"
    STARTS_MOTORS = "starts motors at rest with what was set before"
    AWAITS_START = "starts no motor at rest"
    SYNCHRONIZES = "turns two motors in step"
    SETS_MOTORS = "changes how motors turn, or their counts"
    WAITS = "waits, or reports whether to wait, for what was started before"
    JUMPS_ALWAYS = "never continues with the next operation"
    ENDS = "ends the command: operations after it run only if something jumps to them"
    ENDS_CODE = "ends the code: the firmware reads nothing after it"
    MAY_END = "ends the command itself where its own slot or object is meant"
    NEVER_RUNS = "is refused everywhere"
    FAILS = "ends the command with an error: the firmware has no code for it, or only for addresses in its own memory"
    OF_PROGRAMS = "acts on the objects of its own program"
    WRITES_FILES = "creates, changes or moves files or folders"
    DELETES_FILES = "deletes files or folders"
    CHANGES_SETTINGS = "changes a setting of the brick, which remains after the command has ended"
    RENAMES = "gives the brick another name"
    CONTROLS_PROGRAMS = "starts, stops or changes other programs"
    SENDS_MESSAGES = "puts a message into a mailbox, where a program may react to it"
    PRESSES_BUTTONS = "presses a button as if by hand, which may do anything up to switching the brick off"
    WRITES_TO_DEVICES = "sends bytes to a device at a port, or sets lines of the brick's circuits"
    RESTARTS = "restarts the brick, or ends its firmware"
    WRITES_FIRMWARE = "erases or writes the memory that the firmware is in"
    RUNS_SHELL = "runs a command on the brick's operating system"
    VARIES = "returns a value that differs between bricks and moments"
    READS = "only reads: `proxy --read-only` lets it through, and `replay` sends it"
    COMPUTES = "only computes, jumps or waits: `replay` sends it with `--allow computing`"
    PRINTS = "changes what the display or the debug terminal shows"
    SIGNALS = "changes the lights, or plays a signal"
    RESETS_SENSORS = "resets what sensors have counted"
    USES_MAILBOXES = "opens, closes or reads a mailbox, on which a program may depend"


DATA8, DATA16, DATA32, DATAF = Type.DATA8, Type.DATA16, Type.DATA32, Type.DATAF
STRING, HANDLE, ARRAY_TYPED, LABEL = Type.STRING, Type.HANDLE, Type.ARRAY_TYPED, Type.LABEL

NUMBER_TYPES = (
    ("8", DATA8, "8-bit"),
    ("16", DATA16, "16-bit"),
    ("32", DATA32, "32-bit"),
    ("F", DATAF, "floating-point"),
)
"""The types of numbers, of which many operations have one each: the end of the name, the type, the words for it."""


class Enumeration(NamedTuple):
    """Names of numbers, as the firmware spells them.

    `members` maps each name to its number; where two names share a number the first one is shown.
    `end` is the firmware's name for the number after the last (or for a mask of all): a constant, never a value.
    With `flags`, the value is a set of bits and each member is one bit.
    """

    name: str
    text: str
    members: Mapping[str, int]
    end: tuple[str, int] | None = None
    flags: bool = False
    dialects: tuple[str, ...] = DIALECTS

    def name_of(self, value: object) -> str | None:
        """Returns the name of a number (`A|B` for flags), or None."""
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
    type       its type; of a list of values, that of each value
    text       one line of description
    direction  to the operation, from it, or both
    unit       of the value, as written ("ms", "Hz", "%"); None where it has none
    range      smallest and largest sensible value, both included; None where the type alone limits it
    enum       names of its values
    special    single values with a meaning of their own
    length     for strings, arrays and buffers: the parameter that gives the number of bytes (strings) or elements
               (others), or that number itself where it is fixed
    element    for lists: the type of each value, or the name of the parameter that gives the type
    elements   for lists: the direction of each value
    each       for lists: description of each value
    counts     for lists: it is the count itself, and the values follow it; else the parameter before it is the count
    validated  the type that the firmware's validator assumes, where that differs from `type`
    most       for texts: largest number of bytes, the zero included, where the firmware has a limit
    note       what else to know, such as where and why other published tables differ
    role       what else depends on it, or None
    indexed_by  for arrays of which one element is used: the parameter that gives its index
    stores     the operation writes that element, not the first byte of the variable
    names      names of its values besides those of `enum`: the letters of motor ports, names of another enumeration
    unsigned   the firmware reads its bits unsigned, so numbers up to all bits set are valid
    letters    for texts: the characters that the firmware accepts, if not all
    suffix     for names of files: what the firmware adds to every name
    any_type   for lists: the types of the values are declared elsewhere, so each is written as it is
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
    counts: bool = False
    validated: Type | None = None
    note: str = ""
    most: int | None = None
    role: Role | None = None
    indexed_by: str | None = None
    stores: bool = False
    names: Mapping[str, int] = MappingProxyType({})
    unsigned: bool = False
    any_type: bool = False
    letters: str = ""
    suffix: str = ""
    each: str = ""

    @property
    def is_list(self) -> bool:
        """Whether it is the list at the end of an operation; see `Declaration.tail`."""
        return self.element is not None

    @property
    def label(self) -> str:
        """The name of its type, as it is written; of a list `count` or `values`."""
        if self.is_list:
            return "count" if self.counts else "values"
        return self.type.label

    @property
    def listed(self) -> Parameter:
        """Each value of a list, as a parameter; of type ARRAY_TYPED where another parameter gives the type."""
        kind = self.element if isinstance(self.element, Type) else ARRAY_TYPED
        return self._replace(
            type=kind, direction=self.elements, text=self.each or self.text, element=None, counts=False
        )

    @property
    def is_output(self) -> bool:
        """Whether the operation writes the value."""
        return self.direction is not Direction.IN

    def number_of(self, name: str) -> int | None:
        """Returns the value of a name, None for an unknown name.

        Args:
            name: The firmware's spelling; for a mask of motor ports also joined names, `A+B`.
        """
        if self.enum is not None and name in self.enum.members:
            return self.enum.members[name]
        return self.names.get(name)

    def __hash__(self) -> int:
        return hash((self.name, self.text))


class Facts(TypedDict, total=False):
    """The keyword arguments of the functions below; `Parameter` documents them."""

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
    letters: str
    suffix: str
    each: str


def In(name: str, type: Type, text: str, **facts: Unpack[Facts]) -> Parameter:  # noqa: N802 - a word of the tables' language
    """Returns a parameter that the operation reads."""
    return Parameter(name, type, text, Direction.IN, **facts)


def Out(name: str, type: Type, text: str, **facts: Unpack[Facts]) -> Parameter:  # noqa: N802
    """Returns a parameter that the operation writes."""
    return Parameter(name, type, text, Direction.OUT, **facts)


def InOut(name: str, type: Type, text: str, **facts: Unpack[Facts]) -> Parameter:  # noqa: N802
    """Returns a parameter that the operation reads and writes."""
    return Parameter(name, type, text, Direction.INOUT, **facts)


def Count(  # noqa: N802
    name: str, text: str, element: Type | str = DATA32, elements: Direction = Direction.IN, **facts: Unpack[Facts]
) -> Parameter:
    """Returns a constant that counts the parameters after it (PARNO in the firmware)."""
    return Parameter(name, DATA8, text, element=element, elements=elements, counts=True, **facts)


def Values(name: str, text: str, element: Type, **facts: Unpack[Facts]) -> Parameter:  # noqa: N802
    """Returns a list of values, counted by the parameter before it (PARVALUES in the firmware)."""
    return Parameter(name, element, text, element=element, **facts)


class Command(NamedTuple):
    """One CMD of a family.

    number      the CMD
    name        the firmware's name
    text        one line of description
    parameters  the parameters after it
    dialects    the firmwares that have it
    note        what else to know, such as where and why other published tables differ
    effects     its side effects
    newer       unknown to the validator of the release of 2013
    sentence    what it does with its arguments, for people: `{NAME}` is a value, `{A+B}` a sum; a clause in brackets is
                omitted where its value is not a constant; after | is the clause for a value with a special meaning
    words       what people call it who do not know its name, for searches
    """

    number: int
    name: str
    text: str
    parameters: tuple[Parameter, ...] = ()
    dialects: tuple[str, ...] = DIALECTS
    note: str = ""
    effects: tuple[Effect, ...] = ()
    newer: bool = False
    sentence: str = ""
    words: str = ""


class Opcode(NamedTuple):
    """One opcode: plain, with parameters, or a family, whose first parameter is a CMD that selects the rest.

    Fields as in `Command`, and:

    commands   of a family: its CMDs
    cmd_table  of a family: the validator's table of its CMDs, where that is not its own; the order
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
    sentence: str = ""
    words: str = ""

    @property
    def is_family(self) -> bool:
        """Whether a CMD selects the parameters."""
        return bool(self.commands)

    @property
    def validator_table(self) -> str:
        """The validator's table in which the CMDs of a family are looked up."""
        return self.cmd_table or self.name


class Tail(NamedTuple):
    """The list at the end of an operation: a constant counts the arguments that follow it.

    counter   the parameter that counts
    element   each argument that follows, as a parameter: it has the name of the list, and the type ARRAY_TYPED where
              another parameter gives the type
    typed_by  the name of that parameter, whose value is a FORMAT; None where the type is declared
    """

    counter: Parameter
    element: Parameter
    typed_by: str | None

    @property
    def direction(self) -> Direction:
        """The direction of the arguments that follow."""
        return self.element.direction


@dataclass(frozen=True)
class Declaration:
    """The declaration of one operation: an opcode together with its CMD, if it has one."""

    opcode: Opcode
    command: Command | None = None

    @cached_property
    def name(self) -> str:
        """`SOUND.TONE`, or `UI_FLUSH` where there is no CMD."""
        return f"{self.opcode.name}.{self.command.name}" if self.command else self.opcode.name

    @property
    def text(self) -> str:
        """One line of description."""
        return self.command.text if self.command else self.opcode.text

    @property
    def sentence(self) -> str:
        """What it does with its arguments, see `Command`; empty where its text says enough."""
        return self.command.sentence if self.command else self.opcode.sentence

    @property
    def words(self) -> str:
        """What else people call it, see `Command`."""
        return self.command.words if self.command else self.opcode.words

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The parameters after the opcode and CMD."""
        return self.command.parameters if self.command else self.opcode.parameters

    @cached_property
    def fixed(self) -> tuple[Parameter, ...]:
        """The parameters with one argument each: all, but for the values of a list; its count is the last of them."""
        parameters = self.parameters
        return parameters[:-1] if parameters and parameters[-1].is_list and not parameters[-1].counts else parameters

    @cached_property
    def tail(self) -> Tail | None:
        """The list at its end, None if it has none."""
        last = self.parameters[-1] if self.parameters else None
        if last is None or not last.is_list:
            return None
        return Tail(self.fixed[-1], last.listed, last.element if isinstance(last.element, str) else None)

    @cached_property
    def has_readings(self) -> bool:
        """Whether it receives readings of a device."""
        return any(parameter.role in (Role.SI_READING, Role.RAW_READING) for parameter in self.parameters)

    @property
    def is_jump(self) -> bool:
        """Whether the last parameter is a jump distance or a label."""
        return bool(self.parameters) and self.parameters[-1].role is Role.JUMP

    @property
    def dialects(self) -> tuple[str, ...]:
        """The firmwares that have it."""
        if self.command is None:
            return self.opcode.dialects
        return tuple(dialect for dialect in self.command.dialects if dialect in self.opcode.dialects)

    @property
    def note(self) -> str:
        """Where and why the entry differs from other published tables."""
        return self.command.note if self.command else self.opcode.note

    @property
    def effects(self) -> tuple[Effect, ...]:
        """Its side effects."""
        return self.command.effects if self.command else self.opcode.effects

    @property
    def is_newer(self) -> bool:
        """Whether the validator of the release of 2013 does not know it."""
        return self.command.newer if self.command else self.opcode.newer


def declarations(opcodes: tuple[Opcode, ...]) -> Iterator[Declaration]:
    """Yields every operation of these opcodes, in order."""
    for opcode in opcodes:
        if opcode.is_family:
            for command in opcode.commands:
                yield Declaration(opcode, command)
        else:
            yield Declaration(opcode)
