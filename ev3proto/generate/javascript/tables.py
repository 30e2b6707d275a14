"""The tables as JavaScript and TypeScript: numbers by name, and a function for each operation and system command."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from ev3proto.semantics.domain import comment, firmwares
from ev3proto.tables import OPCODES
from ev3proto.tables.declaration import Declaration, Direction, Parameter, Type, declarations
from ev3proto.tables.encoding import RANGES
from ev3proto.tables.enumerations import ENUMERATIONS
from ev3proto.tables.frame import MessageType
from ev3proto.tables.system import SYSTEM, FieldKind, SystemDeclaration, SystemStatus

_FIELDS = {
    FieldKind.U8: "u8",
    FieldKind.U16: "u16",
    FieldKind.U32: "u32",
    FieldKind.TEXT: "line",
    FieldKind.COUNTED_TEXT: "line",
    FieldKind.DATA: "bytes",
}
_FIELD_TYPES = {
    "line": "string",
    "bytes": "Iterable<number>",
    "message": "string | number | boolean | Iterable<number>",
}


class Function(NamedTuple):
    """One function in both languages.

    name        its name
    text        what it does
    parameters  name, TypeScript's type and description of each
    builder     the function of the runtime that makes its bytes
    parts       what that one gets, in JavaScript
    """

    name: str
    text: str
    parameters: list[tuple[str, str, str]]
    builder: str
    parts: list[str]


# Operations


def families() -> dict[str, list[Function]]:
    """Returns the functions of all operations by opcode; those of opcodes without a CMD are under the empty name."""
    found: dict[str, list[Function]] = {}
    for declaration in declarations(OPCODES):
        found.setdefault(declaration.opcode.name if declaration.command else "", []).append(_operation(declaration))
    return found


def _operation(declaration: Declaration) -> Function:
    tail = declaration.tail
    alone = declaration.fixed[:-1] if tail else declaration.fixed
    parts = [f"Opcode.{declaration.opcode.name}"]
    if declaration.command:
        parts.append(f"LC({declaration.command.number})")
    parts += [f'{_kind(parameter)}("{parameter.name}", {parameter.name})' for parameter in alone]
    described = [(parameter.name, _type(parameter), comment(parameter)) for parameter in alone]
    if tail:
        name = declaration.parameters[-1].name
        parts.append(f'list("{name}", {name}, {_kind(tail.element)})')
        described.append((name, f"readonly {_type(tail.element)}[]", tail.counter.text))
    name = declaration.command.name if declaration.command else declaration.opcode.name
    return Function(name, declaration.text + firmwares(declaration.dialects), described, "operation", parts)


def _kind(parameter: Parameter) -> str:
    """Returns the function of the runtime that makes the argument of a parameter."""
    if parameter.direction is not Direction.IN:
        return "output"
    if parameter.any_type or parameter.type is Type.ARRAY_TYPED:
        return "any"
    kind = {Type.DATAF: "float", Type.STRING: "text"}.get(parameter.type)
    return kind or _integer(parameter.type, is_unsigned=parameter.unsigned)


def _integer(kind: Type, *, is_unsigned: bool) -> str:
    return kind.name.lower() + ("Unsigned" if is_unsigned else "")


def integers() -> dict[str, tuple[int, int]]:
    """Returns the kinds of whole numbers that parameters have, by name, with the smallest and the largest."""
    used = {_kind(parameter) for declaration in declarations(OPCODES) for parameter in declaration.parameters}
    limits = {
        _integer(kind, is_unsigned=unsigned): (each.low, -2 * each.nan - 1 if unsigned else each.high)
        for kind, each in RANGES.items()
        for unsigned in (False, True)
    }
    return {name: each for name, each in limits.items() if name in used}


def _type(parameter: Parameter) -> str:
    return {"output": "Argument", "any": "Any", "text": "Text"}.get(_kind(parameter), "Value")


# System commands


def requests() -> list[Function]:
    """Returns the functions of all system commands of the firmware."""
    return [_request(command) for command in SYSTEM if not command.bootloader]


def _request(command: SystemDeclaration) -> Function:
    counts = {field.counts: field for field in command.request if field.counts}
    parts = [f"0x{command.number:02X}"]
    described = []
    for field in command.request:
        if field.counts:
            continue
        kind = "message" if field.is_message else _FIELDS[field.kind]
        described.append((field.name, _FIELD_TYPES.get(kind, "number"), field.text))
        if field.name in counts:
            kind = f"counted({_FIELDS[counts[field.name].kind]}, {kind})"
        default = " ?? []" if field.optional else ""
        parts.append(f'{kind}("{field.name}", {field.name}{default})')
    return Function(command.name, command.text, described, "request", parts)


# Numbers


def enumerations() -> dict[str, tuple[str, Mapping[str, int]]]:
    """Returns all names of numbers: the name of each object, its text and its members."""
    return {
        "MessageType": ("Message types", {member.name: member.value for member in MessageType}),
        "SystemStatus": ("The status of a system command", {member.name: member.value for member in SystemStatus}),
        "Opcode": ("Opcodes", {opcode.name: opcode.number for opcode in OPCODES}),
        **{each.name: (each.text + firmwares(each.dialects), each.members) for each in ENUMERATIONS},
    }
