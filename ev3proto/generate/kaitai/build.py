"""Assembles the description: the file's head, a stream of frames, the types, the names of numbers."""

from __future__ import annotations

from ev3proto.generate.kaitai.messages import enumeration_types, message_types
from ev3proto.generate.kaitai.naming import family_type, identifier, operation_type, parameter_name
from ev3proto.generate.kaitai.yaml import Block, Hexadecimal, Value, as_yaml
from ev3proto.semantics.domain import comment
from ev3proto.tables import OPCODES, check_dialect, operations
from ev3proto.tables.declaration import DIALECTS, Declaration, Enumeration, Opcode, Parameter, Tail, Type
from ev3proto.tables.enumerations import FORMAT_TYPES
from ev3proto.version import VERSION

Mapping = dict[str | int, Value]

COUNT = "_count"
"""Suffix of a list's name, for the argument with the number of its elements."""

NAME = "_name"
"""Suffix of an argument's name, for its value."""


def opcodes(dialect: str) -> list[Opcode]:
    """Returns the opcodes of a dialect."""
    return [opcode for opcode in OPCODES if dialect in opcode.dialects]


def opcode_enum(dialect: str) -> Mapping:
    """Returns the enumeration of opcodes."""
    return {
        Hexadecimal(opcode.number): {"id": identifier(opcode.name), "doc": opcode.text} for opcode in opcodes(dialect)
    }


def operation_types(dialect: str) -> Mapping:
    """Returns the types of operations: the switch, families, operations with parameters."""
    cases: Mapping = {}
    found: Mapping = {
        "operation": {
            "seq": [
                {"id": "opcode", "type": "u1", "enum": "opcode", "valid": {"in-enum": True}},
                {"id": "arguments", "type": {"switch-on": "opcode", "cases": cases}},
            ]
        }
    }
    for opcode in opcodes(dialect):
        if opcode.is_family:
            cases[f"opcode::{identifier(opcode.name)}"] = family_type(opcode.name)
            found[family_type(opcode.name)] = _family(opcode, dialect)
        elif opcode.parameters:
            cases[f"opcode::{identifier(opcode.name)}"] = operation_type(Declaration(opcode))
    for declaration in operations(dialect).values():
        if declaration.parameters:
            found[operation_type(declaration)] = _operation(declaration)
    return found


def used_enumerations(dialect: str) -> list[Enumeration]:
    """Returns the enumerations that parameters refer to; a description cannot have sets of bits."""
    found: dict[str, Enumeration] = {}
    for declaration in operations(dialect).values():
        for parameter in declaration.parameters:
            if parameter.enum is not None and not parameter.enum.flags:
                found.setdefault(parameter.enum.name, parameter.enum)
    return sorted(found.values(), key=lambda enum: enum.name)


def _family(opcode: Opcode, dialect: str) -> Mapping:
    commands = [entry for entry in operations(dialect).values() if entry.opcode is opcode]
    names = {entry.command.number: entry for entry in commands if entry.command}
    cases: Mapping = {number: operation_type(entry) for number, entry in names.items() if entry.parameters}
    parameters: list[Value] = [{"id": "parameters", "type": {"switch-on": "cmd.value", "cases": cases}}]
    return {
        "doc": opcode.text,
        "seq": [{"id": "cmd", "type": "argument(false)"}, *(parameters if cases else [])],
        "instances": {"cmd_name": {"value": "cmd.value", "enum": f"cmd_{opcode.name.lower()}"}},
        "enums": {
            f"cmd_{opcode.name.lower()}": {
                number: {"id": identifier(entry.command.name), "doc": entry.text}
                for number, entry in names.items()
                if entry.command
            }
        },
    }


def _operation(declaration: Declaration) -> Mapping:
    fields: list[Value] = []
    instances: Mapping = {}
    before = ""
    for parameter in declaration.parameters:
        name = parameter_name(parameter)
        if parameter.counts:
            before = name + COUNT
            fields.append(_argument(before, "false", parameter))
        if declaration.tail is not None and parameter.is_list:
            doc = "" if parameter.counts else comment(parameter)
            fields.append(_list(name, _is_float(declaration.tail), before, doc))
        else:
            fields.append(_argument(name, str(parameter.type is Type.DATAF).lower(), parameter))
            if parameter.enum is not None and not parameter.enum.flags and not parameter.is_output:
                instances[name + NAME] = {
                    "value": f"{name}.value",
                    "enum": identifier(parameter.enum.name),
                    "if": f"{name}.is_number",
                }
        before = name
    found: Mapping = {"doc": declaration.text, "seq": fields}
    return found | ({"instances": instances} if instances else {})


def _argument(name: str, is_float: str, parameter: Parameter) -> Mapping:
    return {"id": name, "type": f"argument({is_float})", "doc": comment(parameter)}


def _list(name: str, is_float: str, counter: str, doc: str = "") -> Mapping:
    found: Mapping = {"id": name, "type": f"argument({is_float})", "repeat": "expr", "repeat-expr": f"{counter}.value"}
    return found | ({"doc": doc} if doc else {})


def _is_float(tail: Tail) -> str:
    """Returns whether a list's elements are floats, as an expression if another argument tells it."""
    if tail.typed_by is None:
        return str(tail.element.type is Type.DATAF).lower()
    teller = identifier(tail.typed_by)
    floats = [number for number, kind in FORMAT_TYPES.items() if kind is Type.DATAF]
    return f"{teller}.is_number and ({' or '.join(f'{teller}.value == {number}' for number in floats)})"


FILE_NAME = "ev3.ksy"

DOC = """\
All frames of a stream between a computer and a brick, from its first frame on. On USB each report starts with one
frame, and the rest of it is padding. On WiFi two texts precede the frames.

Operations are those of the {dialect} firmware. An argument's type does not say whether its encoding is the shortest.
Not covered: the meaning of a direct reply's bytes, which only the command tells; CMDs that a family does not have
(what follows is then read as the next operation); names of sets of bits.

Made by ev3proto {version} from its tables (ev3proto export kaitai): change those, not this."""


def build(dialect: str = DIALECTS[0]) -> str:
    """Returns the text of ev3.ksy. Raises ValueError for an unknown dialect."""
    return as_yaml(description(dialect))


def description(dialect: str = DIALECTS[0]) -> dict[str | int, Value]:
    """Returns the whole description. Raises ValueError for an unknown dialect."""
    check_dialect(dialect)
    return {
        "meta": {
            "id": "ev3",
            "title": "LEGO MINDSTORMS EV3",
            "license": "MIT",
            "ks-version": "0.11",
            "endian": "le",
            "bit-endian": "be",
            "encoding": "ISO-8859-1",
        },
        "doc": Block(DOC.format(dialect=dialect, version=VERSION)),
        "seq": [{"id": "frames", "type": "frame", "repeat": "eos"}],
        "types": {**message_types(), **operation_types(dialect)},
        "enums": {
            **enumeration_types(),
            "opcode": opcode_enum(dialect),
            **{identifier(enum.name): _members(enum) for enum in used_enumerations(dialect)},
        },
    }


def _members(enum: Enumeration) -> dict[str | int, Value]:
    names: dict[int, str] = {}
    for name, number in enum.members.items():
        names.setdefault(number, name)
    return {number: identifier(name) for number, name in names.items()}
