"""`ev3proto ops`: lists, searches and shows operations and system commands."""

from __future__ import annotations

import re
from collections.abc import Iterator
from difflib import get_close_matches
from functools import partial
from typing import Any, NoReturn

import click

from ev3proto.cli.entries import (
    ENCODING,
    MODE,
    Entry,
    device_types,
    encoding,
    encodings,
    error_numbers,
    modes,
    named_entry,
)
from ev3proto.cli.options import AREA, AREAS_HELP, dialect_option, json_option
from ev3proto.cli.output import Failure, Printer, say_json
from ev3proto.errors import near_misses
from ev3proto.schema.instructions import instruction_set
from ev3proto.semantics.domain import element, facts
from ev3proto.tables import OPCODES, area_of, operations
from ev3proto.tables.declaration import DIALECTS, UNRELEASED, Declaration, Parameter
from ev3proto.tables.encoding import ENCODINGS
from ev3proto.tables.frame import TYPE_ADVICE, TYPE_MEANINGS
from ev3proto.tables.system import SYSTEM, UNUSED_STATUSES, SystemDeclaration, SystemField, SystemStatus
from ev3proto.text.spans import Role, Spans


@click.command()
@click.argument("words", nargs=-1)
@click.option("--area", type=AREA, metavar="AREA", help=f"Only operations {AREAS_HELP}")
@json_option
@dialect_option
def ops(words: tuple[str, ...], area: str | None, as_json: bool, dialect: str) -> None:
    """Lists or searches the operations, or shows one in full.

    WORDS is the name or number of an operation to show in full (sound.tone, 0x94, 148), or words to search for in the
    names, meanings, parameters and values of operations. Matches in names come first.

    \b
      ev3proto ops sound.tone
      ev3proto ops 0x94
      ev3proto ops battery
      ev3proto ops LED_RED_FLASH
    """  # noqa: D301 - the mark by which click leaves lines as they are
    every = [*_entries(dialect), *(_other_names() if words else ())]
    entries = [entry for entry in every if area is None or entry.area == area]
    exact = _exact(entries, words)
    found = exact or _ranked(entries, words)
    if not found:
        _fail(entries, words)
    if as_json:
        for entry in found:
            say_json(entry.record())
    else:
        _show(found, in_full=len(found) == 1 or len({entry.name for entry in exact}) == 1)


def _fail(entries: list[Entry], words: tuple[str, ...]) -> NoReturn:
    hint = near_misses(".".join(words), [entry.name for entry in entries]) or _near_word(entries, words)
    hint = hint or "; `ev3proto ops` lists all operations"
    raise Failure(f"no operation matches {' '.join(words)!r}{hint}")


def _show(found: list[Entry], *, in_full: bool) -> None:
    printer = Printer()
    if not in_full:
        printer.lines(entry.line() for entry in found)
        return
    for number, entry in enumerate(found):
        if number:
            printer.text("")
        printer.lines(entry.page())


def _entries(dialect: str) -> list[Entry]:
    return [
        *(_operation(declaration, dialect) for declaration in operations(dialect).values()),
        *map(_system, SYSTEM),
        *(
            named_entry(opcode.name, opcode.number, "opcode of no firmware", opcode.text, [opcode.note])
            for opcode in OPCODES
            if opcode.dialects == UNRELEASED
        ),
        *map(_status, SystemStatus),
        *(
            named_entry(member.name, member, "message type", text, filter(None, [TYPE_ADVICE.get(member)]))
            for member, text in TYPE_MEANINGS.items()
        ),
    ]


def _other_names() -> Iterator[Entry]:
    yield from encodings()
    yield from modes()
    yield from error_numbers()
    yield from device_types()


def _operation(entry: Declaration, dialect: str) -> Entry:
    area = area_of(entry.opcode)
    said = [f"{parameter.name} {parameter.text}" for parameter in entry.parameters]
    said += [" ".join(parameter.enum.members) for parameter in entry.parameters if parameter.enum is not None]

    def record() -> dict[str, Any]:
        command = entry.command
        return {
            "op": entry.opcode.name,
            "command": command.name if command else None,
            "opcode": entry.opcode.number,
            "cmd": command.number if command else None,
            "area": area,
            "text": entry.text,
            "dialects": list(entry.dialects),
            "effects": [effect.name for effect in entry.effects],
            "parameters": list(map(_parameter_record, entry.parameters)),
        }

    about = partial(_about, entry, area, dialect)
    return Entry(entry.name, entry.opcode.number, area, "", entry.text, " ".join(said), about, record, entry.words)


def _about(entry: Declaration, area: str, dialect: str) -> Iterator[Spans]:
    head = instruction_set(dialect)[entry.name].head
    numbers = f"opcode 0x{entry.opcode.number:02X}" + (f", CMD {entry.command.number}" if entry.command else "")
    yield [(f"  {numbers}; starts with {head.hex(' ').upper()}; area {area}", Role.ASIDE)]
    if entry.dialects != DIALECTS:
        yield [(f"  only in the firmware: {', '.join(entry.dialects)}", Role.ASIDE)]
    if entry.command:
        yield [(f"  of the family {entry.opcode.name}: {entry.opcode.text}", Role.ASIDE)]
    yield from ([(f"  it {effect.value}", Role.MEANING)] for effect in entry.effects)
    if entry.note:
        yield [(f"  note: {entry.note}", Role.MEANING)]
    if not entry.parameters:
        yield [("  no parameters", Role.PLAIN)]
    for parameter in entry.parameters:
        yield from _parameter(parameter)


def _system(entry: SystemDeclaration) -> Entry:
    said = " ".join(f"{field.name} {field.text}" for field in entry.request + entry.reply)

    def about() -> Iterator[Spans]:
        kind = "command of the bootloader (USB only)" if entry.bootloader else "system command"
        yield [(f"  {kind} 0x{entry.number:02X}", Role.ASIDE)]
        yield from _fields("request", entry.request)
        yield from _fields("reply", entry.reply) if entry.answered else [[("  never replied to", Role.PLAIN)]]

    def record() -> dict[str, Any]:
        return {
            "system": entry.name,
            "number": entry.number,
            "text": entry.text,
            "bootloader": entry.bootloader,
            "answered": entry.answered,
            "request": list(map(_field_record, entry.request)),
            "reply": list(map(_field_record, entry.reply)),
        }

    return Entry(entry.name, entry.number, "system", "system", entry.text, said, about, record)


def _status(status: SystemStatus) -> Entry:
    text = f"The system command {'failed' if status.is_failure else 'worked'}"
    notes = [f"{entry.name}: {meaning}" for entry in SYSTEM for known, meaning in entry.statuses if known is status]
    if status in UNUSED_STATUSES:
        notes = ["no command of the published firmware answers with it"]
    return named_entry(status.name, status, "status", text, notes)


def _exact(entries: list[Entry], words: tuple[str, ...]) -> list[Entry]:
    """Returns the entries with a name or number; a family's name means all of its commands."""
    name = ".".join(words).upper().replace(" ", ".")
    found = [entry for entry in entries if name == entry.name or (name == f"OP{entry.name}" and not entry.kind)]
    if found or not re.fullmatch(r"0X[0-9A-F]+|[0-9]{1,3}", name):
        return found
    number = int(name, 16 if name.startswith("0X") else 10)
    form = encoding(number) if number < len(ENCODINGS) else None
    others = [entry for entry in entries if entry.number == number and entry.kind not in (ENCODING, MODE)]
    return [*filter(None, [form]), *sorted(others, key=lambda entry: not entry.kind)]


def _ranked(entries: list[Entry], words: tuple[str, ...]) -> list[Entry]:
    """Returns the entries with all words, those first that have them in their names."""
    wanted = [word for each in words for word in _words(each)]
    ranked = []
    for entry in entries:
        searched = list(map(_words, entry.texts))
        ranks = [next((rank for rank, text in enumerate(searched) if _has(text, word)), None) for word in wanted]
        known = [rank for rank in ranks if rank is not None]
        if len(known) == len(ranks):
            ranked.append((sum(known), entry))
    return [entry for _, entry in sorted(ranked, key=lambda pair: pair[0])]


def _near_word(entries: list[Entry], words: tuple[str, ...]) -> str:
    """Returns `: did you mean battery?` for the first unknown word that resembles a known one; or nothing."""
    known = sorted({word for entry in entries for text in entry.texts for word in _words(text)})
    unknown = [word for each in words for word in _words(each) if not (word.isdecimal() or _has(known, word))]
    close = [near for word in unknown for near in get_close_matches(word, known, 1, _LIKENESS)]
    return f": did you mean {close[0]}?" if close else ""


_LIKENESS = 0.8


def _words(text: str) -> list[str]:
    return re.findall(r"[a-z0-9]+", text.lower())


_SHORTEST_START = 4
"""Minimum length of a word that also matches the start of a longer one: `motor` in `motors`."""


def _has(words: list[str], wanted: str) -> bool:
    if len(wanted) >= _SHORTEST_START:
        return any(word.startswith(wanted) for word in words)
    return wanted in words or f"{wanted}s" in words


def _parameter(parameter: Parameter) -> Iterator[Spans]:
    line: Spans = [
        ("  ", Role.PLAIN),
        (parameter.name.ljust(12), Role.NAME),
        (f" {parameter.direction!s:5} {parameter.label:12}", Role.VALUE),
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
        "type": parameter.label,
        "direction": str(parameter.direction),
        "text": parameter.text,
    }
    enum, element_type = parameter.enum, parameter.element
    optional = {
        "unit": parameter.unit,
        "range": list(parameter.range or ()),
        "enum": {"name": enum.name, "members": dict(enum.members)} if enum else None,
        "special": {str(number): meaning for number, meaning in parameter.special.items()},
        "length": parameter.length,
        "element": None if element_type is None else str(element_type),
        "elements": None if element_type is None else str(parameter.elements),
        "note": parameter.note,
    }
    return entry | {name: value for name, value in optional.items() if value or value == 0}


def _fields(title: str, fields: tuple[SystemField, ...]) -> Iterator[Spans]:
    yield [(f"  {title}:" + ("" if fields else " no fields"), Role.PLAIN)]
    for field in fields:
        optional = " (may be absent)" if field.optional else ""
        yield [
            ("    ", Role.PLAIN),
            (field.name.ljust(16), Role.NAME),
            (f" {field.kind.value:12}", Role.VALUE),
            (f" {field.text}{optional}", Role.PLAIN),
        ]


def _field_record(field: SystemField) -> dict[str, Any]:
    entry = {"name": field.name, "kind": field.kind.value, "text": field.text}
    return entry | ({"optional": True} if field.optional else {})
