"""What the firmware knows, as data. Read these files to learn the protocol; they import no other part of the package.

`OPCODES` is the instruction set, one file for each of the firmware's areas. `DECLARATIONS` lists its operations (an
opcode with its CMD), `find` looks one up by its written name.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

from ev3proto.tables.branch import BRANCH
from ev3proto.tables.com import COM
from ev3proto.tables.compare import COMPARE
from ev3proto.tables.declaration import DIALECTS, Declaration, Effect, Opcode, declarations
from ev3proto.tables.input import INPUT
from ev3proto.tables.math import MATH
from ev3proto.tables.memory import MEMORY
from ev3proto.tables.move import MOVE
from ev3proto.tables.output import OUTPUT
from ev3proto.tables.sound import SOUND
from ev3proto.tables.timer import TIMER
from ev3proto.tables.ui import UI
from ev3proto.tables.vm import VM

AREAS: dict[str, tuple[Opcode, ...]] = {
    "vm": VM,
    "math": MATH,
    "move": MOVE,
    "branch": BRANCH,
    "compare": COMPARE,
    "ui": UI,
    "timer": TIMER,
    "sound": SOUND,
    "input": INPUT,
    "output": OUTPUT,
    "memory": MEMORY,
    "com": COM,
}
"""The opcodes by the firmware's areas."""

AREA_TITLES = {
    "vm": "Programs and the virtual machine",
    "math": "Arithmetic",
    "move": "Moving and converting values",
    "branch": "Jumps",
    "compare": "Comparisons",
    "ui": "Display, buttons, lights, battery",
    "timer": "Timers",
    "sound": "Sound",
    "input": "Sensors",
    "output": "Motors",
    "memory": "Files and arrays",
    "com": "Communication",
}
"""Titles of the areas, in the words of a table of contents."""

OPCODES: tuple[Opcode, ...] = tuple(opcode for area in AREAS.values() for opcode in area)
"""Every opcode of every dialect."""


def check_dialect(dialect: str) -> str:
    """Returns the dialect; raises ValueError with the known names when it is unknown."""
    if dialect not in DIALECTS:
        raise ValueError(f"dialect must be one of {', '.join(DIALECTS)}, not {dialect!r}")
    return dialect


@cache
def operations(dialect: str = "official") -> dict[str, Declaration]:
    """Returns the operations of one dialect by name (`SOUND.TONE`, `UI_FLUSH`). ValueError for an unknown dialect."""
    check_dialect(dialect)
    return {entry.name: entry for entry in declarations(OPCODES) if dialect in entry.dialects}


class Clash(NamedTuple):
    """A number that two opcodes of a dialect have, or two CMDs of a family."""

    number: str
    names: tuple[str, str]


def clashes() -> list[Clash]:
    """Returns the numbers that are used twice."""
    found: dict[Clash, None] = {}
    for dialect in DIALECTS:
        opcodes: dict[int, Opcode] = {}
        known: dict[tuple[int, int | None], Declaration] = {}
        for entry in declarations(OPCODES):
            if dialect not in entry.dialects:
                continue
            opcode, cmd = entry.opcode, None if entry.command is None else entry.command.number
            holder, other = opcodes.setdefault(opcode.number, opcode), known.setdefault((opcode.number, cmd), entry)
            if holder is not opcode:
                found[Clash(f"0x{opcode.number:02X}", (holder.name, opcode.name))] = None
            elif other is not entry:
                found[Clash(f"CMD {cmd}", (other.name, entry.name))] = None
    return list(found)


@cache
def with_effect(effect: Effect) -> Declaration:
    """Returns the first operation of LEGO's own firmware that has an effect; KeyError where none has."""
    for entry in operations().values():
        if effect in entry.effects:
            return entry
    raise KeyError(effect)


def area_of(opcode: Opcode) -> str:
    """Returns the firmware's area that an opcode belongs to."""
    return next(name for name, opcodes in AREAS.items() if opcode in opcodes)
