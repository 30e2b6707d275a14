"""The tables as C: enumerations area by area, with what each operation takes in a comment above its name."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator

from ev3proto.semantics.domain import comment, firmwares
from ev3proto.tables import AREA_TITLES, AREAS, daisy
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.declaration import Command, Direction, Opcode, Parameter
from ev3proto.tables.enumerations import ENUMERATIONS
from ev3proto.tables.frame import MessageType
from ev3proto.tables.system import SYSTEM, SystemDeclaration, SystemField, SystemStatus

WIDTH = 120
INDENT = "    "
LARGEST = 2**15 - 1
"""Largest number of an enumerator that every compiler takes: an int has 16 bits where the processor has 8."""

BOOTLOADER = "BOOTLOADER_"
"""Prefix of the bootloader's commands, which share names with the firmware's."""

STATUS = "SYSTEM_"
"""Prefix of statuses: programs use the name SUCCESS themselves."""

DAISY = "DAISY_"

_ASCII = str.maketrans({"°": "deg "})
"""Replaces characters that not every compiler accepts, even in comments."""


def data() -> str:
    """Returns the whole part, section by section."""
    return "\n".join("\n".join(lines) for lines in _sections()).translate(_ASCII) + "\n"


def heading(title: str, *text: str) -> Iterator[str]:
    """Returns the comment above a section."""
    yield f"/* {title} {'-' * (WIDTH - 7 - len(title))} */"
    yield ""
    if text:
        yield from _comment(text, "")
        yield ""


def _sections() -> Iterator[Iterable[str]]:
    yield _message_types()
    for area, opcodes in AREAS.items():
        yield _area(area, opcodes)
    yield _enumerations()
    yield _system_commands()
    yield _daisy()
    yield _constants()


def _comment(lines: Iterable[str], margin: str) -> Iterator[str]:
    """Returns a comment: on one line if it is one line, else with each line on its own."""
    rows = [row for line in lines for row in _wrapped(line, WIDTH - len(margin) - 6)]
    if len(rows) == 1:
        yield f"{margin}/* {rows[0]} */"
        return
    yield f"{margin}/*"
    yield from (f"{margin} * {row}".rstrip() for row in rows)
    yield f"{margin} */"


def _wrapped(line: str, width: int) -> list[str]:
    indent = len(line) - len(line.lstrip()) + 4
    return textwrap.wrap(line, width, subsequent_indent=" " * indent, break_on_hyphens=False) or [""]


def _enum(entries: Iterable[tuple[str, int, Iterable[str]]], digits: int) -> Iterator[str]:
    """Returns an enumeration of (name, number, comment); numbers have this many hexadecimal digits, 0: decimal."""
    rows: list[str] = []
    for name, number, lines in entries:
        said = list(lines)
        if said and rows:
            rows.append("")
        if said:
            rows += _comment(said, INDENT)
        rows.append(f"{INDENT}{name} = {f'0x{number:0{digits}X}' if digits else number},")
    yield from ("enum {", *rows, "};", "")


def _message_types() -> Iterator[str]:
    yield from heading("Message types")
    yield from _enum(((member.name, member.value, ()) for member in MessageType), 2)


# Operations


def _area(area: str, opcodes: tuple[Opcode, ...]) -> Iterator[str]:
    yield from heading(AREA_TITLES[area])
    yield from _enum(((f"op{opcode.name}", opcode.number, _opcode(opcode)) for opcode in opcodes), 2)
    for opcode in opcodes:
        if opcode.is_family:
            yield f"/* CMDs of op{opcode.name} */"
            yield from _enum(((entry.name, entry.number, _command(entry)) for entry in opcode.commands), 0)


def _opcode(opcode: Opcode) -> Iterator[str]:
    yield opcode.text + firmwares(opcode.dialects) + (": a CMD follows, below" if opcode.is_family else "")
    yield from _parameters(opcode.parameters)


def _command(command: Command) -> Iterator[str]:
    yield command.text + firmwares(command.dialects)
    yield from _parameters(command.parameters)


def _parameters(parameters: tuple[Parameter, ...]) -> Iterator[str]:
    names = max((len(parameter.name) for parameter in parameters), default=0)
    types = max((len(_type(parameter)) for parameter in parameters), default=0)
    for parameter in parameters:
        yield f"  {parameter.name:{names}}  {_type(parameter):{types}}  {comment(parameter)}"


def _type(parameter: Parameter) -> str:
    way = {Direction.IN: "", Direction.OUT: "out ", Direction.INOUT: "in/out "}[parameter.direction]
    return way + parameter.label


# Names of numbers


def _enumerations() -> Iterator[str]:
    yield from heading("Enumerations", "Names of the values of parameters.")
    for enum in ENUMERATIONS:
        yield from _comment([f"{enum.name}: {enum.text}{firmwares(enum.dialects)}"], "")
        members = [(name, number, ()) for name, number in enum.members.items()]
        end = [] if enum.end is None else [(*enum.end, ())]
        yield from _enum([*members, *end], 0)


def _system_commands() -> Iterator[str]:
    yield from heading("System commands", "The byte after the message type, and what follows it.")
    yield from _enum(((_name(command), command.number, _system_command(command)) for command in SYSTEM), 2)
    yield "/* The byte after the command's number in a reply */"
    yield from _enum(((STATUS + status.name, status.value, ()) for status in SystemStatus), 0)


def _name(command: SystemDeclaration) -> str:
    return (BOOTLOADER if command.bootloader else "") + command.name


def _system_command(command: SystemDeclaration) -> Iterator[str]:
    yield command.text
    yield from _fields("asks with", command.request)
    if command.answered:
        yield from _fields("gets", command.reply)
    else:
        yield "  gets no reply"


def _fields(title: str, fields: tuple[SystemField, ...]) -> Iterator[str]:
    described = (f"{field.name} ({'optional ' if field.optional else ''}{field.kind.value})" for field in fields)
    if fields:
        yield f"  {title}: {', '.join(described)}"


def _daisy() -> Iterator[str]:
    yield from heading("Daisy chain", "The byte after the message type, between bricks that are joined by USB.")
    yield from _enum(((DAISY + entry.name, entry.value, [daisy.TEXTS[entry]]) for entry in daisy.DaisySubCommand), 2)


def _constants() -> Iterator[str]:
    yield from heading("Constants", "Sizes, limits, folders, files and positions, as the firmware has them.")
    small = {name: value for name, value in CONSTANTS.items() if isinstance(value, int) and abs(value) <= LARGEST}
    yield from _enum(((name, number, ()) for name, number in small.items()), 0)
    for name, value in CONSTANTS.items():
        if name not in small:
            yield f"#define {name} {_literal(value)}"
    yield ""


def _literal(value: int | str) -> str:
    if isinstance(value, str):
        return f'"{value}"'
    return f"0x{value:X}u" if value > LARGEST else f"({value})"
