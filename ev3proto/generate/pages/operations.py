"""One page for each of the firmware's areas: its operations, with everything that the tables know about each."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.generate.modules.source import FIRMWARES
from ev3proto.generate.pages.examples import example_of, explained, is_accepted
from ev3proto.generate.pages.markdown import block, code, link, listed, plain, plain_sentence, table, try_it
from ev3proto.schema.instructions import instruction_set
from ev3proto.semantics.domain import element, facts
from ev3proto.tables import AREAS
from ev3proto.tables.declaration import DIALECTS, Declaration, Parameter, declarations

ENUMERATIONS_PAGE = "enumerations.md"

_MOST_NAMES = 8
"""Number of an enumeration's names listed with a parameter."""


def blocks(area: str) -> Iterator[str]:
    """Yields the blocks of the page."""
    yield f"The operations of the firmware's area `{area}`. [How to read this](index.md#how-to-read-an-entry)."
    opcodes = AREAS[area]
    yield table(("opcode", "operation", "what it does"), (_summary(entry) for entry in declarations(opcodes)))
    for opcode in opcodes:
        if opcode.is_family:
            yield f"## {opcode.name}"
            yield f"Opcode `0x{opcode.number:02X}`, a family: CMD selects the operation. {plain_sentence(opcode.text)}"
            if opcode.note:
                yield f"Note: {plain_sentence(opcode.note)}"
        for declaration in declarations((opcode,)):
            yield from _entry(declaration, "###" if opcode.is_family else "##")


def _summary(declaration: Declaration) -> tuple[str, str, str]:
    return (_number(declaration), link(declaration.name, declaration.name), plain(declaration.text))


def _number(declaration: Declaration) -> str:
    cmd = "" if declaration.command is None else f" {declaration.command.number}"
    return f"0x{declaration.opcode.number:02X}{cmd}"


def dialect_of(declaration: Declaration) -> str | None:
    """Returns the first firmware version that has it; None if there is none."""
    return next(iter(declaration.dialects), None)


def _entry(declaration: Declaration, level: str) -> Iterator[str]:
    yield f"{level} {declaration.name}"
    yield plain_sentence(declaration.text)
    yield listed(_facts(declaration))
    if declaration.parameters:
        yield table(("parameter", "", "type", "what it is"), map(_parameter, declaration.parameters))
    else:
        yield "It has no parameters."
    dialect = dialect_of(declaration)
    if dialect is not None:
        yield from _example(declaration, dialect)


def _facts(declaration: Declaration) -> Iterator[str]:
    dialect = dialect_of(declaration)
    number = f"Opcode `0x{declaration.opcode.number:02X}`"
    if declaration.command is not None:
        number += f", CMD {declaration.command.number}"
    if dialect is not None:
        head = instruction_set(dialect)[declaration.name].head
        number += f": it starts with `{head.hex(' ').upper()}`"
    yield f"{number}."
    if not declaration.dialects:
        yield "No firmware that was released has it."
    elif declaration.dialects != DIALECTS:
        yield f"Only in {' and '.join(FIRMWARES[each] for each in declaration.dialects)}."
    if declaration.is_newer:
        yield "The validator of the release of 2013 does not know it."
    yield from (f"It {plain(effect.value)}." for effect in declaration.effects)
    if declaration.note:
        yield f"Note: {plain_sentence(declaration.note)}"
    fields = [filter_name(declaration, each) for each in declaration.parameters]
    if not fields:
        fields = [f'ev3.cmd == "{declaration.name}"']
    yield f"In Wireshark: {', '.join(map(code, fields))}."


def filter_name(declaration: Declaration, parameter: Parameter) -> str:
    """Returns Wireshark's name of a parameter: `ev3.sound.tone.frequency`."""
    return f"ev3.{declaration.name}.{parameter.name}".lower()


def _parameter(parameter: Parameter) -> tuple[str, str, str, str]:
    said = list(facts(parameter))
    if parameter.enum is not None:
        said.remove(f"a member of {parameter.enum.name}")
    meaning = [plain_sentence(f"{parameter.text} ({'; '.join(said)})" if said else parameter.text)]
    if parameter.enum is not None:
        members = parameter.enum.members
        listed = [f"{number} {code(name)}" for name, number in members.items()]
        more = "" if len(listed) <= _MOST_NAMES else ", ..."
        place = link(parameter.enum.name, parameter.enum.name, ENUMERATIONS_PAGE)
        meaning.append(f"A member of {place}: {', '.join(listed[:_MOST_NAMES])}{more}.")
    each = element(parameter)
    if each is not None:
        meaning.append(f"Each is {plain(each)}, {parameter.elements}.")
    if parameter.note:
        meaning.append(f"Note: {plain_sentence(parameter.note)}")
    kind = "list" if parameter.is_list else parameter.type.label
    return code(parameter.name), str(parameter.direction), kind, " ".join(meaning)


def _example(declaration: Declaration, dialect: str) -> Iterator[str]:
    example = example_of(declaration, dialect)
    yield block("python", [example.call])
    yield block("text", explained(example.frame, dialect))
    if dialect == DIALECTS[0]:
        yield try_it(example.frame)
    if not is_accepted(example, dialect):
        yield "The validator of the release of 2013 refuses this frame."
