"""What names mean: the firmware's constants, and what a text declares itself (constants, variables, labels)."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache

from ev3proto.messages import Variable
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.schema.names import constant, constant_names
from ev3proto.schema.operation import CMD
from ev3proto.tables import OPCODES
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.declaration import DATA8, DATA16, DATA32, DATAF, Parameter, Type
from ev3proto.tables.encoding import GLOBAL, LOCAL
from ev3proto.tables.enumerations import ENUMERATIONS, NUMBERS
from ev3proto.tables.frame import MAX_FRAME, MAX_LOCALS
from ev3proto.tables.system import SYSTEM
from ev3proto.text.assembly.lexing import Token
from ev3proto.text.assembly.parser import error_at

MOST_NAMES = 10_000
"""Names that a text can declare."""

NOT_NUMBERS = tuple(f"{kind}_NAN" for kind in (DATA8, DATA16, DATA32, DATAF))
"""The firmware's names for the value of each type that is none."""

_MOST_GUESSED = 60
_LIKENESS = 0.67
MOST_MEMORY = {GLOBAL: MAX_FRAME - HEADER_SIZE, LOCAL: MAX_LOCALS}
"""Bytes that variables can take: those that a reply carries, those that a header can ask for."""


class Pattern(int):
    """A whole number that was written as the bits it has, as hex is: 0xFF is -1 where a DATA8 is meant."""


Constant = int | float | str


@dataclass(frozen=True, slots=True)
class Declared:
    """A variable that the text declares.

    variable  its first byte
    type      of one element
    count     of elements
    """

    variable: Variable
    type: Type
    count: int

    @property
    def end(self) -> int:
        """The offset after it, in its memory."""
        return self.variable.index + self.type.size * self.count


class Names:
    """The names that a text declares. Constants last to its end, variables and labels to the end of their message."""

    def __init__(self) -> None:
        self.constants: dict[str, Constant | bytes] = {}
        self.variables: dict[str, Declared] = {}
        self.labels: dict[str, int] = {}
        self.sizes = {GLOBAL: 0, LOCAL: 0}

    def begin_message(self) -> None:
        """Forgets what belongs to one message."""
        self.variables = {}
        self.labels = {}
        self.sizes = {GLOBAL: 0, LOCAL: 0}

    def define(self, token: Token, value: Constant | bytes) -> None:
        """A name for a constant, or for an encoded argument. Raises AssemblyError where the name is taken."""
        if token.text in self.constants:
            if self.constants[token.text] == value:
                return
            raise error_at(token, f"{token.text} is defined already")
        self._check_new(token)
        self.constants[token.text] = value

    def declare(self, token: Token, kind: Type, count: int, scope: str) -> None:
        """A variable after those that are there, at a multiple of its element's size. Raises AssemblyError."""
        self._check_new(token)
        start = -(-self.sizes[scope] // kind.size) * kind.size
        declared = Declared(Variable(scope, start), kind, count)
        if declared.end > MOST_MEMORY[scope]:
            raise error_at(
                token,
                f"{token.text} would end {declared.end} bytes into {scope} memory, which has {MOST_MEMORY[scope]}",
            )
        self.variables[token.text] = declared
        self.sizes[scope] = declared.end

    def mark(self, token: Token, place: int) -> None:
        """A label in front of the piece with that number. Raises AssemblyError where the name is taken."""
        self._check_new(token)
        self.labels[token.text] = place

    def _check_new(self, token: Token) -> None:
        name = token.text
        if name in self.variables:
            raise error_at(token, f"{name} is declared already, as a variable")
        if name in self.labels:
            raise error_at(token, f"{name} is declared already, as a label")
        if len(self.constants) + len(self.variables) + len(self.labels) >= MOST_NAMES:
            raise error_at(token, f"the text declares more than {MOST_NAMES} names")

    def known(self, parameter: Parameter | None) -> list[str]:
        """Every name that can stand for a value, the likeliest first."""
        own = [*self.variables, *self.labels, *self.constants]
        if parameter is None:
            return [*own, *firmware_constants()]
        if parameter.enum is None:
            return [*parameter.names, *own, *firmware_constants(), *_commands()]
        others = [name for name in firmware_constants() if name not in _members() and name not in _ends()]
        return [*parameter.enum.members, *parameter.names, *own, *others]


@cache
def firmware_constants() -> dict[str, Constant]:
    """Every constant of the firmware by name; opcodes, CMDs and system commands are none."""
    found: dict[str, Constant] = dict(NUMBERS)
    for name, value in CONSTANTS.items():
        found.setdefault(name, Pattern(value) if name in NOT_NUMBERS else value)
    others = {command.name for opcode in OPCODES for command in opcode.commands} | {entry.name for entry in SYSTEM}
    for name in constant_names():
        if name in found or name in others or name.startswith(("op", "SYSTEM_")):
            continue
        plain = constant(name)
        # What is left as a text says what ev3_dc is to use, and no part of the protocol.
        if not isinstance(plain, str):
            found[name] = plain if isinstance(plain, int) else int(CMD.read(plain, 0)[0].value)
    return found


@cache
def _members() -> frozenset[str]:
    return frozenset(name for enumeration in ENUMERATIONS for name in enumeration.members)


@cache
def _ends() -> frozenset[str]:
    return frozenset(enumeration.end[0] for enumeration in ENUMERATIONS if enumeration.end is not None)


@cache
def _commands() -> dict[str, int]:
    """The number of every CMD by name. No name has two."""
    return {command.name: command.number for opcode in OPCODES for command in opcode.commands}


def firmware_constant(name: str, parameter: Parameter | None) -> Constant | None:
    """The firmware's constant of a name, None where there is none.

    Args:
        name: The name, as the firmware spells it.
        parameter: What the constant is for, if that is known. Where it has an enumeration, neither another
            enumeration's member nor a CMD can stand for it.
    """
    if parameter is not None:
        number = parameter.number_of(name)
        if number is not None:
            return number
        if parameter.enum is not None:
            return None if name in _members() else firmware_constants().get(name)
    found = firmware_constants().get(name)
    return _commands().get(name) if found is None else found


def suggestion(name: str, known: Iterable[str]) -> str:
    """`: did you mean TONE?` for a name that nearly is a known one, in any case; or nothing. Never the name itself."""
    if len(name) > _MOST_GUESSED:
        return ""
    by_upper: dict[str, str] = {}
    for candidate in known:
        if candidate != name:
            by_upper.setdefault(candidate.upper(), candidate)
    near = (
        [name.upper()] if name.upper() in by_upper else difflib.get_close_matches(name.upper(), by_upper, 3, _LIKENESS)
    )
    return f": did you mean {' or '.join(by_upper[match] for match in near)}?" if near else ""
