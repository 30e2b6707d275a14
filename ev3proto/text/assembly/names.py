"""The names of a text: the firmware's constants, and its own defines, variables, labels and objects."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from functools import cache
from typing import ClassVar, NamedTuple

from ev3proto.errors import near_misses
from ev3proto.schema.instructions import CMD
from ev3proto.schema.names import constant, constant_names
from ev3proto.tables import OPCODES
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.declaration import DATA8, DATA16, DATA32, DATAF, Direction, Parameter, Role, Type
from ev3proto.tables.enumerations import ENUMERATIONS, NUMBERS
from ev3proto.tables.program import aligned
from ev3proto.tables.system import SYSTEM
from ev3proto.text.assembly.errors import SourceError, cited
from ev3proto.text.assembly.notations import Known, Notation
from ev3proto.text.assembly.syntax import Define, Pattern

MAX_DEPTH = 50
"""Maximum nesting depth of defines."""

NOT_NUMBERS = tuple(f"{kind}_NAN" for kind in (DATA8, DATA16, DATA32, DATAF))
"""The firmware's names for the value of each type that means "not a number"."""

OBJECT_PARAMETER = "OBJID"
"""The name of all parameters that are numbers of objects."""


class Variable(NamedTuple):
    """A variable."""

    at: int  # where it is declared in the text
    scope: str  # local or global
    start: int  # bytes from the start of that memory
    type: Type  # of one element; STRING for a buffer, HANDLE for what was declared as one
    elements: int  # how many there are
    is_array: bool = False  # whether it was declared with a number of elements

    @property
    def width(self) -> int:
        """Bytes of an element."""
        return 1 if self.type is Type.STRING else self.type.size

    @property
    def end(self) -> int:
        """The offset after it, in its memory."""
        return self.start + self.width * self.elements


class Callee(NamedTuple):
    """The signature of an object."""

    number: int  # 1 or more
    at: int  # the place of its declaration
    kind: str  # the word that begins it
    # direction and type of each; None for threads, whose calls have no count
    parameters: tuple[tuple[Direction, Type], ...] | None


class Goal(NamedTuple):
    """A label to jump to."""

    name: str


class Encoded(NamedTuple):
    """An encoded argument, as the value of a define."""

    data: bytes


Meaning = int | float | str | Variable | Callee | Goal | Encoded
"""The meaning of a value. LEGO's defines may be Fractions."""


class Memory:
    """An allocator of variables: globals, or the locals of one object."""

    def __init__(self, scope: str, notation: Notation, limit: int) -> None:
        self.scope = scope
        self.size = 0
        self._notation = notation
        self._limit = limit

    def place(self, at: int, name: str, kind: Type, count: int, is_array: bool) -> Variable:
        """Allocates the next variable. Raises SourceError if the memory is full."""
        new = Variable(at, self.scope, 0, kind, count, is_array)
        if self._notation.rules.aligns_elements:
            start = -(-self.size // new.width) * new.width
        else:
            start = aligned(self.size, new.width * count)
        new = new._replace(start=start)
        if new.end > self._limit:
            raise SourceError(
                at, f"{cited(name)} would end {new.end} bytes into {self.scope} memory, which has {self._limit}"
            )
        self.size = new.end
        return new


def is_object(parameter: Parameter | None) -> bool:
    """Returns whether a parameter is the number of an object, which may be given by name."""
    return parameter is not None and (parameter.role is Role.OBJECT or parameter.name == OBJECT_PARAMETER)


@dataclass
class LocalNames:
    """The names of one object, or of one message: variables and defines so far, and labels with their places."""

    places: dict[str, Variable] = field(default_factory=dict)
    defines: dict[str, Define] = field(default_factory=dict)
    labels: dict[str, int] = field(default_factory=dict)


class Names:
    """The names of a text, looked up in the order of its notation.

    value  evaluates a define
    """

    def __init__(self, notation: Notation, value: Callable[[Define, LocalNames], Meaning]) -> None:
        self.notation = notation
        self.globals: dict[str, list[Variable]] = {}
        self.objects: dict[str, Callee] = {}
        self.defines: dict[str, Define] = {}
        self.local = LocalNames()
        self._value = value
        self._worked_out: dict[int, Meaning] = {}
        self._depth = 0

    def meaning(self, name: str, at: int, parameter: Parameter | None = None) -> Meaning | None:
        """Returns the meaning of a name, used at an offset for a parameter, or None."""
        place = self.local.places.get(name)
        for where in self.notation.lookup:
            if where is Known.LOCALS and place is not None:
                return place
            found: Meaning | None = self._LOOKUPS[where](self, name, at, parameter)
            if found is not None:
                return found
        return None

    def _local_define(self, name: str, _at: int, _parameter: Parameter | None) -> Meaning | None:
        local = self.local
        return self.defined(local.defines[name], local) if name in local.defines else None

    def _global_above(self, name: str, at: int, _parameter: Parameter | None) -> Meaning | None:
        above = [it for it in self.globals.get(name, ()) if it.at < at]
        return above[-1] if above else None

    def _object_above(self, name: str, at: int, _parameter: Parameter | None) -> Meaning | None:
        callee = self.objects.get(name)
        return callee if callee and callee.at < at else None

    def _define(self, name: str, _at: int, _parameter: Parameter | None) -> Meaning | None:
        return self.defined(self.defines[name], LocalNames()) if name in self.defines else None

    def _define_above(self, name: str, at: int, _parameter: Parameter | None) -> Meaning | None:
        define = self.defines.get(name)
        return self.defined(define, LocalNames()) if define is not None and define.at < at else None

    def _goal(self, name: str, _at: int, parameter: Parameter | None) -> Meaning | None:
        is_goal = parameter is not None and parameter.role is Role.JUMP
        # In a frame, a label may be set further down.
        is_known = name in self.local.labels or (self.notation.has_messages and name not in self.local.places)
        return Goal(name) if is_goal and is_known else None

    def _label(self, name: str, _at: int, _parameter: Parameter | None) -> Meaning | None:
        labels, define = self.local.labels, self.defines.get(name)
        is_hidden = self.notation.last_counts and define is not None and define.at > labels.get(name, 0)
        return Goal(name) if name in labels and not is_hidden else None

    _LOOKUPS: ClassVar = {
        Known.LOCALS: _local_define,
        Known.GLOBALS: _global_above,
        Known.OBJECTS: lambda self, name, _at, _parameter: self.objects.get(name),
        Known.OBJECTS_ABOVE: _object_above,
        Known.CALLED: lambda self, name, _at, parameter: self.objects.get(name) if is_object(parameter) else None,
        Known.DEFINES: _define,
        Known.DEFINES_ABOVE: _define_above,
        Known.FIRMWARE: lambda self, name, _at, parameter: firmware_constant(
            name, parameter if self.notation.has_messages else None
        ),
        Known.GOALS: _goal,
        Known.LABELS: _label,
    }
    """How a name is looked up in each place."""

    def defined(self, define: Define, local: LocalNames) -> Meaning:
        """Returns the value of a define."""
        if define.at not in self._worked_out:
            if self._depth >= MAX_DEPTH:
                raise SourceError(define.at, f"{cited(define.name)} is defined by itself, or by too many others")
            self._depth += 1
            try:
                self._worked_out[define.at] = self._value(define, local)
            finally:
                self._depth -= 1
        return self._worked_out[define.at]

    def known(self, parameter: Parameter | None = None) -> list[str]:
        """Returns every name that can be a value, the likeliest first."""
        local = self.local
        own = [*local.places, *local.labels, *local.defines, *self.globals, *self.objects, *self.defines]
        if parameter is None or not self.notation.has_messages:
            return [*own, *firmware_names()]
        if parameter.enum is None:
            return [*parameter.names, *own, *firmware_names()]
        others = [name for name in firmware_constants() if name not in _members() and name not in _ends()]
        return [*parameter.enum.members, *parameter.names, *own, *others]


@cache
def firmware_constants() -> dict[str, int | float | str]:
    """Returns every constant of the firmware by name, without opcodes, CMDs and system commands."""
    found: dict[str, int | float | str] = dict(NUMBERS)
    for name, value in CONSTANTS.items():
        found.setdefault(name, Pattern(value) if name in NOT_NUMBERS else value)
    others = {command.name for opcode in OPCODES for command in opcode.commands} | {entry.name for entry in SYSTEM}
    for name in constant_names():
        if name in found or name in others or name.startswith(("op", "SYSTEM_")):
            continue
        plain = constant(name)
        # The remaining texts are options of ev3_dc, not part of the protocol.
        if not isinstance(plain, str):
            found[name] = plain if isinstance(plain, int) else int(CMD.read(plain, 0)[0].value)
    return found


@cache
def firmware_names() -> dict[str, int | float | str]:
    """Returns the same with the number of every CMD by name. None has two."""
    commands = {command.name: command.number for opcode in OPCODES for command in opcode.commands}
    return commands | firmware_constants()


@cache
def _members() -> frozenset[str]:
    return frozenset(name for enumeration in ENUMERATIONS for name in enumeration.members)


@cache
def _ends() -> frozenset[str]:
    return frozenset(enumeration.end[0] for enumeration in ENUMERATIONS if enumeration.end is not None)


def firmware_constant(name: str, parameter: Parameter | None) -> int | float | str | None:
    """Returns the firmware's constant of a name, or None.

    Where the parameter has an enumeration, neither another enumeration's member nor a CMD is one.
    """
    if parameter is not None:
        number = parameter.number_of(name)
        if number is not None:
            return number
        if parameter.enum is not None:
            return None if name in _members() else firmware_constants().get(name)
    return firmware_names().get(name)


def choice(name: str, at: int, what: str, known: Iterable[str], more: str = "") -> str:
    """Returns a name that is known. Raises SourceError for another one, with suggestions."""
    names = list(known)
    if name not in names:
        choices = f"; choose from {', '.join(names)}{more}" if names else "; there are none"
        hint = near_misses(name, names) or choices
        raise SourceError(at, f"{what} {cited(name)}{hint}")
    return name
