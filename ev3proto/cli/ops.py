"""`ev3proto ops`: the instruction set and the system commands, listed, searched, or one of them in full."""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterable, Iterator
from typing import Any

import click

from ev3proto.cli.output import Printer, complain
from ev3proto.errors import near_misses
from ev3proto.schema.instructions import instruction_set
from ev3proto.semantics.domain import element, facts
from ev3proto.tables import AREAS, OPCODES, area_of, operations
from ev3proto.tables.declaration import DIALECTS, UNRELEASED, Declaration, Parameter
from ev3proto.tables.frame import TYPE_ADVICE, TYPE_MEANINGS
from ev3proto.tables.system import SYSTEM, UNUSED_STATUSES, Field, SystemCommand, SystemStatus
from ev3proto.text.spans import Line, Role


@click.command()
@click.argument("words", nargs=-1)
@click.option(
    "--area",
    type=click.Choice([*AREAS, "system"]),
    metavar="AREA",
    help=f"Only those of one area of the firmware: {', '.join(AREAS)}, system.",
)
@click.option("--json", "as_json", is_flag=True, help="One JSON object a line.")
@click.option(
    "--dialect", type=click.Choice(DIALECTS), default="official", show_default=True, help="Whose instruction set."
)
def ops(words: tuple[str, ...], area: str | None, as_json: bool, dialect: str) -> None:
    """Lists the operations, searches them, or shows one in full.

    WORDS is a name or number (sound.tone, "SOUND TONE", 0x94, 148), then it is shown in full; or anything else, then
    every operation is listed that has all the words in its name, its meaning, its parameters or the names of their
    values. Those that have them in their name come first.

    \b
      ev3proto ops sound.tone
      ev3proto ops 0x94
      ev3proto ops battery
      ev3proto ops LED_RED_FLASH
    """  # noqa: D301 - the mark by which click leaves lines as they are
    printer = Printer()
    entries = [entry for entry in _entries(dialect) if area is None or entry.area == area]
    exact = _exact(entries, words) if words else []
    found = exact or _ranked(entries, words)
    if not found:
        hint = near_misses(".".join(words), [entry.name for entry in entries])
        hint = hint or "; without words, ops lists all there are"
        complain(f"nothing has {' '.join(words)!r} in its name or meaning{hint}")
        sys.exit(1)
    for number, entry in enumerate(found):
        if as_json:
            printer.text(json.dumps(entry.record(), ensure_ascii=False))
        elif len(found) == 1 or (exact and all(entry.name == found[0].name for entry in exact)):
            if number:
                printer.text("")
            printer.lines(entry.page())
        else:
            printer.lines([entry.line()])


class Entry:
    """An operation of the virtual machine, as `ops` shows it."""

    def __init__(self, declaration: Declaration, dialect: str) -> None:
        self.declaration = declaration
        self.dialect = dialect
        self.name = declaration.name
        self.number = declaration.opcode.number
        self.area = area_of(declaration.opcode)

    @property
    def aliases(self) -> tuple[str, ...]:
        """The names under which it is found exactly."""
        return (self.name, f"OP{self.name}")

    @property
    def texts(self) -> tuple[str, str, str]:
        """What is searched: the name, the meaning, all that is said of its parameters."""
        parameters = self.declaration.parameters
        said = [f"{parameter.name} {parameter.text}" for parameter in parameters]
        said += [" ".join(parameter.enum.members) for parameter in parameters if parameter.enum is not None]
        return self.name, self.declaration.text, " ".join(said)

    def line(self) -> Line:
        """One line in a list."""
        return [
            (f"0x{self.number:02X} ", Role.ASIDE),
            (self.name.ljust(32), Role.OPERATION),
            (f" {self.declaration.text}", Role.PLAIN),
        ]

    def page(self) -> Iterator[Line]:
        """All there is to know."""
        entry = self.declaration
        yield [(self.name, Role.OPERATION), (f"  {entry.text}", Role.PLAIN)]
        head = instruction_set(self.dialect)[self.name].head
        numbers = f"opcode 0x{self.number:02X}" + (f", CMD {entry.command.number}" if entry.command else "")
        yield [(f"  {numbers}; starts with {head.hex(' ').upper()}; area {self.area}", Role.ASIDE)]
        if entry.dialects != DIALECTS:
            yield [(f"  only in the firmware: {', '.join(entry.dialects)}", Role.ASIDE)]
        if entry.command:
            yield [(f"  of the family {entry.opcode.name}: {entry.opcode.text}", Role.ASIDE)]
        for effect in entry.effects:
            yield [(f"  it {effect.value}", Role.MEANING)]
        if entry.note:
            yield [(f"  note: {entry.note}", Role.MEANING)]
        if not entry.parameters:
            yield [("  no parameters", Role.PLAIN)]
        for parameter in entry.parameters:
            yield from _parameter(parameter)

    def record(self) -> dict[str, Any]:
        """The same for other tools."""
        entry = self.declaration
        return {
            "op": entry.opcode.name,
            "command": entry.command.name if entry.command else None,
            "opcode": self.number,
            "cmd": entry.command.number if entry.command else None,
            "area": self.area,
            "text": entry.text,
            "dialects": list(entry.dialects),
            "effects": [effect.name for effect in entry.effects],
            "parameters": [_parameter_record(parameter) for parameter in entry.parameters],
        }


class SystemEntry:
    """A system command, as `ops` shows it."""

    area = "system"

    def __init__(self, entry: SystemCommand) -> None:
        self.entry = entry
        self.name = entry.name
        self.number = entry.number
        self.aliases: tuple[str, ...] = (entry.name,)

    @property
    def texts(self) -> tuple[str, str, str]:
        """What is searched: the name, the meaning, all that is said of its fields."""
        said = (f"{field.name} {field.text}" for field in self.entry.request + self.entry.reply)
        return self.name, f"{self.entry.text} system", " ".join(said)

    def line(self) -> Line:
        """One line in a list."""
        return [
            (f"0x{self.number:02X} ", Role.ASIDE),
            (f"{self.name} (system)".ljust(32), Role.OPERATION),
            (f" {self.entry.text}", Role.PLAIN),
        ]

    def page(self) -> Iterator[Line]:
        """All there is to know."""
        entry = self.entry
        yield [(self.name, Role.OPERATION), (f"  {entry.text}", Role.PLAIN)]
        kind = "command of the bootloader (USB only)" if entry.bootloader else "system command"
        yield [(f"  {kind} 0x{self.number:02X}", Role.ASIDE)]
        yield from _fields("request", entry.request)
        if entry.answered:
            yield from _fields("reply", entry.reply)
        else:
            yield [("  never replied to", Role.PLAIN)]

    def record(self) -> dict[str, Any]:
        """The same for other tools."""
        return {
            "system": self.name,
            "number": self.number,
            "text": self.entry.text,
            "bootloader": self.entry.bootloader,
            "answered": self.entry.answered,
            "request": [_field_record(field) for field in self.entry.request],
            "reply": [_field_record(field) for field in self.entry.reply],
        }


class NameEntry:
    """A status of system replies or a type of message, as `ops` shows it."""

    area = "system"

    def __init__(self, name: str, number: int, kind: str, text: str, notes: Iterable[str] = ()) -> None:
        self.name = name
        self.number = number
        self.aliases: tuple[str, ...] = (name,)
        self.text = text
        self.kind = kind
        self.notes = tuple(notes)

    @property
    def texts(self) -> tuple[str, str, str]:
        """What is searched: the name, the meaning, the notes."""
        return self.name, f"{self.text} {self.kind}", " ".join(self.notes)

    def line(self) -> Line:
        """One line in a list."""
        return [
            (f"0x{self.number:02X} ", Role.ASIDE),
            (f"{self.name} ({self.kind})".ljust(32), Role.OPERATION),
            (f" {self.text}", Role.PLAIN),
        ]

    def page(self) -> Iterator[Line]:
        """All there is to know."""
        yield [(self.name, Role.OPERATION), (f"  {self.text}", Role.PLAIN)]
        yield [(f"  {self.kind} 0x{self.number:02X}", Role.ASIDE)]
        for note in self.notes:
            yield [(f"  {note}", Role.MEANING)]

    def record(self) -> dict[str, Any]:
        """The same for other tools."""
        return {
            "name": self.name,
            "number": self.number,
            "kind": self.kind,
            "text": self.text,
            "notes": list(self.notes),
        }


AnyEntry = Entry | SystemEntry | NameEntry


def _statuses() -> Iterator[NameEntry]:
    for status in SystemStatus:
        text = f"The system command {'failed' if status.is_failure else 'worked'}"
        notes = [f"{entry.name}: {meaning}" for entry in SYSTEM for known, meaning in entry.statuses if known is status]
        if status in UNUSED_STATUSES:
            notes = ["no command of the published firmware answers with it"]
        yield NameEntry(status.name, status, "status", text, notes)


def _unreleased() -> Iterator[NameEntry]:
    for opcode in OPCODES:
        if opcode.dialects == UNRELEASED:
            yield NameEntry(opcode.name, opcode.number, "opcode of no firmware", opcode.text, [opcode.note])


def _message_types() -> Iterator[NameEntry]:
    for member, text in TYPE_MEANINGS.items():
        yield NameEntry(
            member.name, member, "message type", text, [TYPE_ADVICE[member]] if member in TYPE_ADVICE else []
        )


def _entries(dialect: str) -> list[AnyEntry]:
    return [
        *(Entry(declaration, dialect) for declaration in operations(dialect).values()),
        *(SystemEntry(entry) for entry in SYSTEM),
        *_unreleased(),
        *_statuses(),
        *_message_types(),
    ]


def _exact(entries: list[AnyEntry], words: tuple[str, ...]) -> list[AnyEntry]:
    """The entries that are meant by name or number; a family's name means all of its commands."""
    name = ".".join(words).upper().replace(" ", ".")
    found = [entry for entry in entries if name in entry.aliases]
    if not found and re.fullmatch(r"0X[0-9A-F]+|[0-9]{1,3}", name):
        coded = [entry for entry in entries if not isinstance(entry, NameEntry)]
        found = [entry for entry in coded if entry.number == int(name, 16 if name.startswith("0X") else 10)]
    return found


def _ranked(entries: list[AnyEntry], words: tuple[str, ...]) -> list[AnyEntry]:
    """The entries that have all words: those that have them in their name first, then those that mean them."""
    wanted = [word for each in words for word in _words(each)]
    ranked = []
    for entry in entries:
        searched = list(map(_words, entry.texts))
        ranks = [next((rank for rank, text in enumerate(searched) if _has(text, word)), None) for word in wanted]
        known = [rank for rank in ranks if rank is not None]
        if len(known) == len(ranks):
            ranked.append((sum(known), entry))
    return [entry for _, entry in sorted(ranked, key=lambda pair: pair[0])]


def _words(text: str) -> list[str]:
    return re.findall(r"[a-z0-9]+", text.lower())


_SHORTEST_START = 4
"""A word of so many letters is found at the start of a longer one, too: `motor` in `motors`."""


def _has(words: list[str], wanted: str) -> bool:
    if len(wanted) >= _SHORTEST_START:
        return any(word.startswith(wanted) for word in words)
    return wanted in words or f"{wanted}s" in words


def _parameter(parameter: Parameter) -> Iterator[Line]:
    line: Line = [
        ("  ", Role.PLAIN),
        (parameter.name.ljust(12), Role.NAME),
        (f" {parameter.direction!s:5} {parameter.type.label:12}", Role.VALUE),
        (f" {parameter.text}", Role.PLAIN),
    ]
    pieces = list(facts(parameter))
    each = element(parameter)
    if each is not None:
        pieces.append(f"each is {each}, {parameter.elements}")
    if pieces:
        line.append((f" ({'; '.join(pieces)})", Role.MEANING))
    yield line
    if parameter.enum is not None:
        members = ", ".join(f"{number} {name}" for name, number in parameter.enum.members.items())
        yield [(f"      {parameter.enum.name}: {members}", Role.ASIDE)]
    if parameter.note:
        yield [(f"      note: {parameter.note}", Role.MEANING)]


def _parameter_record(parameter: Parameter) -> dict[str, Any]:
    entry: dict[str, Any] = {
        "name": parameter.name,
        "type": parameter.type.label,
        "direction": str(parameter.direction),
        "text": parameter.text,
    }
    if parameter.unit:
        entry["unit"] = parameter.unit
    if parameter.range:
        entry["range"] = list(parameter.range)
    if parameter.enum:
        entry["enum"] = {"name": parameter.enum.name, "members": dict(parameter.enum.members)}
    if parameter.special:
        entry["special"] = {str(number): meaning for number, meaning in parameter.special.items()}
    if parameter.length is not None:
        entry["length"] = parameter.length
    if parameter.element is not None:
        entry["element"] = str(parameter.element)
        entry["elements"] = str(parameter.elements)
    if parameter.note:
        entry["note"] = parameter.note
    return entry


def _fields(title: str, fields: tuple[Field, ...]) -> Iterator[Line]:
    yield [(f"  {title}:" + ("" if fields else " no fields"), Role.PLAIN)]
    for field in fields:
        optional = " (may be absent)" if field.optional else ""
        yield [
            ("    ", Role.PLAIN),
            (field.name.ljust(16), Role.NAME),
            (f" {field.kind.value:12}", Role.VALUE),
            (f" {field.text}{optional}", Role.PLAIN),
        ]


def _field_record(field: Field) -> dict[str, Any]:
    entry: dict[str, Any] = {"name": field.name, "kind": field.kind.value, "text": field.text}
    if field.optional:
        entry["optional"] = True
    return entry
