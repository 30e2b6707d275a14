"""`ev3proto.ops.argument_types`: what calls accept for a parameter, as types for type checkers and editors."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.generate.modules.source import MARK, bracketed, docstring, imported, joined
from ev3proto.tables import operations as operations_of
from ev3proto.tables.declaration import DIALECTS, Direction, Enumeration, Parameter, Role, Type

_ALIASES = {
    "AnyVariable": "Variable | Placeholder | Argument | bytes",
    "Number": "int | AnyVariable",
    "Real": "float | AnyVariable",
    "Text": "str | AnyVariable",
    "Elements": "int | str | AnyVariable",
    "NamedNumber": "int | str | AnyVariable",
    "Untyped": "float | str | AnyVariable",
    "Jump": "int | Label | AnyVariable",
    "Output": "AnyVariable | None",
    "Outputs": "Sequence[Output] | Variable | Placeholder | int | None",
}
"""The types that do not involve an enumeration."""

_SCALARS = {Type.DATAF: "Real", Type.STRING: "Text", Type.ARRAY_TYPED: "Real"}


def module() -> str:
    """Returns the text of the module."""
    return joined(_lines())


def argument_type(parameter: Parameter) -> str:
    """Returns the type of what a call accepts for a parameter."""
    if parameter.elements is not Direction.IN:
        return "Outputs"
    if parameter.is_list:
        element = None if parameter.any_type else parameter.element
        return f"Sequence[{_SCALARS.get(element, 'Number') if isinstance(element, Type) else 'Untyped'}]"
    if parameter.direction is Direction.OUT:
        return "Output"
    if parameter.direction is Direction.INOUT:
        return "AnyVariable"
    if parameter.enum is not None:
        return _alias(parameter.enum)
    if parameter.type is not Type.STRING and parameter.length is not None:
        return "Elements"
    if parameter.role is Role.JUMP:
        return "Jump"
    if parameter.names:
        return "NamedNumber"
    return _SCALARS.get(parameter.type, "Number")


def _alias(enum: Enumeration) -> str:
    return f"Any{enum.name}"


def _lines() -> Iterator[str]:
    yield from docstring(
        [
            "What the functions of `ev3proto.ops` take for their parameters, for type checkers and editors.",
            "",
            "A number may be given as such, by the name of an enumeration's member, or be in a variable. Bytes are one",
            "encoded argument, such as `LC2(5)`. None leaves the place of an output to `ev3proto.command`.",
            "",
            MARK,
        ]
    )
    enums = _enumerations()
    yield ""
    yield "from __future__ import annotations"
    yield ""
    yield "from collections.abc import Sequence"
    yield "from typing import Literal, TypeAlias"
    yield ""
    yield from imported("ev3proto.enums", [enum.name for enum in enums])
    yield from imported("ev3proto.messages", ["Argument", "Variable"])
    yield from imported("ev3proto.semantics.drafts.placeholders", ["Label", "Placeholder"])
    yield ""
    yield from (f'{name}: TypeAlias = "{meaning}"' for name, meaning in _ALIASES.items())
    for enum in enums:
        yield ""
        names = [f'"{name}"' for name in enum.members]
        yield from bracketed(f"_{enum.name}_NAME: TypeAlias = Literal[", names, "]", indent=" " * 120)
        yield f'{_alias(enum)}: TypeAlias = "{enum.name} | _{enum.name}_NAME | Number"'


def _enumerations() -> list[Enumeration]:
    """Returns the enumerations of inputs of all dialects, in order of first use."""
    found: dict[str, Enumeration] = {}
    for dialect in DIALECTS:
        for declaration in operations_of(dialect).values():
            for parameter in declaration.parameters:
                if parameter.enum is not None and parameter.direction is Direction.IN:
                    found.setdefault(parameter.enum.name, parameter.enum)
    return list(found.values())
