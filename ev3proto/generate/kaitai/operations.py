"""Every operation of a dialect: a type for what follows its opcode and CMD."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.generate.kaitai.naming import family_type, identifier, operation_type, parameter_name
from ev3proto.generate.kaitai.yaml import Hexadecimal, Value
from ev3proto.semantics.domain import comment
from ev3proto.tables import OPCODES, operations
from ev3proto.tables.declaration import Declaration, Enumeration, Opcode, Parameter, Type
from ev3proto.tables.enumerations import FORMAT_TYPES

Mapping = dict[str | int, Value]

COUNT = "_count"
"""What is put after the name of a list, for the argument that tells how many there are."""

NAME = "_name"
"""What is put after the name of an argument, for the name of its value."""


def opcodes(dialect: str) -> list[Opcode]:
    """The opcodes of a dialect."""
    return [opcode for opcode in OPCODES if dialect in opcode.dialects]


def opcode_enum(dialect: str) -> Mapping:
    """The names of the opcodes."""
    return {
        Hexadecimal(opcode.number): {"id": identifier(opcode.name), "doc": opcode.text} for opcode in opcodes(dialect)
    }


def operation_types(dialect: str) -> Iterator[tuple[str, Value]]:
    """The type of an operation, those of families, those of operations that have parameters."""
    cases: Mapping = {}
    for opcode in opcodes(dialect):
        if opcode.is_family:
            cases[f"opcode::{identifier(opcode.name)}"] = family_type(opcode.name)
        elif opcode.parameters:
            cases[f"opcode::{identifier(opcode.name)}"] = operation_type(Declaration(opcode))
    yield (
        "operation",
        {
            "seq": [
                {"id": "opcode", "type": "u1", "enum": "opcode", "valid": {"in-enum": True}},
                {"id": "arguments", "type": {"switch-on": "opcode", "cases": cases}},
            ]
        },
    )
    for opcode in opcodes(dialect):
        if opcode.is_family:
            yield family_type(opcode.name), _family(opcode, dialect)
    for declaration in operations(dialect).values():
        if declaration.parameters:
            yield operation_type(declaration), _operation(declaration)


def used_enumerations(dialect: str) -> list[Enumeration]:
    """The enumerations that parameters refer to; sets of bits are none that a description could have."""
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
        if parameter.type is Type.COUNT:
            fields.append(_argument(name + COUNT, "false", parameter))
            fields.append(_list(name, _is_float(parameter), name + COUNT))
        elif parameter.type is Type.VALUES:
            fields.append(_list(name, _is_float(parameter), before, comment(parameter)))
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


def _is_float(parameter: Parameter) -> str:
    """Whether the elements of a list are floats, as an expression where another argument tells it."""
    if not isinstance(parameter.element, str):
        return str(parameter.element is Type.DATAF).lower()
    teller = identifier(parameter.element)
    floats = [number for number, kind in FORMAT_TYPES.items() if kind is Type.DATAF]
    return f"{teller}.is_number and ({' or '.join(f'{teller}.value == {number}' for number in floats)})"
