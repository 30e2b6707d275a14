"""The stubs of `ev3proto.ops` and of its other dialects: a function for each operation, a class for each family."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from ev3proto.compose.calls import python_name
from ev3proto.compose.drafts import may_be_left_away
from ev3proto.generate.stubs.writing import HEAD, INDENT, WIDTH, docstring, function, indented, literal
from ev3proto.ops.describing import described
from ev3proto.ops.making import commands_of, families
from ev3proto.tables import operations as operations_of
from ev3proto.tables.declaration import Declaration, Direction, Enumeration, Opcode, Parameter, Type

_OFFICIAL = "official"

_FIRMWARES = {
    "official": "LEGO's own firmware",
    "xtended": "the community's extended firmware",
    "compat": "the community's compatible firmware",
}

_UNCHECKED = "unchecked: bool = False"

_TYPES = {
    "_Variable": "Variable | Place | Argument | bytes",
    "_Number": "int | _Variable",
    "_Real": "float | _Variable",
    "_Text": "str | _Variable",
    "_Elements": "int | str | _Variable",
    "_Untyped": "float | str | _Variable",
    "_Output": "_Variable | None",
    "_Outputs": "Sequence[_Output] | Variable | Place | int | None",
}
"""What a call takes for a parameter, under the names that the stubs have for it."""


def stub(dialect: str) -> str:
    """The text of a dialect's file."""
    body = list(_body(dialect))
    head = [*docstring(f"Every operation of {_FIRMWARES[dialect]} as a function.\n\n{HEAD}"), "", "# ruff: noqa: I001"]
    imports = _imports() if dialect == _OFFICIAL else _imports_from_official(dialect, body)
    return "\n".join([*head, "", *imports, *body]) + "\n"


def _imports() -> Iterator[str]:
    enums = _enumerations(_OFFICIAL)
    yield "from collections.abc import Sequence"
    yield "from typing import Literal, TypeAlias, overload"
    yield ""
    yield "from ev3proto.compose import Draft, Place"
    yield from _import("ev3proto.enums", [enum.name for enum in enums])
    yield "from ev3proto.messages import Argument, Variable"
    yield ""
    yield from (f"{name}: TypeAlias = {meaning}" for name, meaning in _TYPES.items())
    for enum in enums:
        yield from _alias(enum)


def _imports_from_official(dialect: str, body: Sequence[str]) -> Iterator[str]:
    """What the body uses; all that is in both firmwares is that of LEGO's."""
    words = {word for line in body for word in re.findall(r"\w+", line)}
    official = {f"_{enum.name}" for enum in _enumerations(_OFFICIAL)}
    own = [enum for enum in _enumerations(dialect) if f"_{enum.name}" not in official]
    if "Sequence" in words:
        yield "from collections.abc import Sequence"
    yield f"from typing import {'Literal, TypeAlias, ' if own else ''}overload"
    yield ""
    yield "from ev3proto.compose import Draft"
    if own:
        yield from _import("ev3proto.enums", [enum.name for enum in own])
    yield from _import("ev3proto.ops", sorted((official | _TYPES.keys()) & (words | ({"_Number"} if own else set()))))
    shared = [python_name(opcode.name) for opcode in families(dialect) if _is_shared(opcode, dialect)]
    shared += [_python_name(declaration) for declaration in _plain(dialect) if declaration in _plain(_OFFICIAL)]
    yield from _import("ev3proto.ops", [f"{name} as {name}" for name in sorted(shared)])
    if own:
        yield ""
    for enum in own:
        yield from _alias(enum)


def _import(module: str, names: Sequence[str]) -> Iterator[str]:
    line = f"from {module} import {', '.join(names)}"
    if len(line) <= WIDTH:
        yield line
    else:
        yield f"from {module} import ("
        yield from (f"{INDENT}{name}," for name in names)
        yield ")"


def _alias(enum: Enumeration) -> Iterator[str]:
    first, *rest = literal(list(enum.members))
    yield from (f"_{enum.name}_name: TypeAlias = {first}", *rest)
    yield f"_{enum.name}: TypeAlias = {enum.name} | _{enum.name}_name | _Number"


def _body(dialect: str) -> Iterator[str]:
    own = [opcode for opcode in families(dialect) if not _is_shared(opcode, dialect)]
    for opcode in own:
        yield ""
        yield from _family(opcode, dialect)
    yield ""
    yield from (f"{python_name(opcode.name)}: {_class_name(opcode)}" for opcode in own)
    for declaration in _plain(dialect):
        if dialect == _OFFICIAL or declaration not in _plain(_OFFICIAL):
            yield ""
            yield from _function(declaration)


def _plain(dialect: str) -> list[Declaration]:
    return [found for found in operations_of(dialect).values() if found.command is None]


def _is_shared(opcode: Opcode, dialect: str) -> bool:
    """Whether a family is that of LEGO's firmware, whose class serves for it."""
    return (
        dialect != _OFFICIAL
        and opcode in families(_OFFICIAL)
        and commands_of(opcode, dialect) == commands_of(opcode, _OFFICIAL)
    )


def _enumerations(dialect: str) -> list[Enumeration]:
    """Those that inputs have, in the order in which they are met."""
    found: dict[str, Enumeration] = {}
    for declaration in operations_of(dialect).values():
        for parameter in declaration.parameters:
            if parameter.enum is not None and parameter.direction is Direction.IN:
                found.setdefault(parameter.enum.name, parameter.enum)
    return list(found.values())


def _class_name(opcode: Opcode) -> str:
    return f"_{''.join(word.capitalize() for word in opcode.name.split('_'))}"


def _family(opcode: Opcode, dialect: str) -> Iterator[str]:
    yield f"class {_class_name(opcode)}:"
    yield from indented(docstring(f"{opcode.name}: {opcode.text}."))
    for declaration in commands_of(opcode, dialect):
        yield ""
        yield from indented(_function(declaration, "self"))


def _python_name(declaration: Declaration) -> str:
    return python_name(declaration.command.name if declaration.command else declaration.opcode.name)


def _function(declaration: Declaration, *first: str) -> Iterator[str]:
    name = _python_name(declaration)
    names = [python_name(parameter.name) for parameter in declaration.parameters]
    optional = [may_be_left_away(declaration, number) for number in range(len(names))]
    types = [_type(parameter) for parameter in declaration.parameters]
    in_order = [
        f"{each}: {kind}{' | None' if may and kind == '_Number' else ''}"
        for each, kind, may in zip(names, types, optional, strict=True)
    ]
    by_name = [f"{each} = None" if may else each for each, may in zip(in_order, optional, strict=True)]
    text = described(declaration, names)
    split = optional.index(True) if True in optional else len(names)
    if all(optional[split:]):
        yield from function(name, [*first, *by_name, "*", _UNCHECKED], "Draft", text)
        return
    # By position all have to stand there; by name, what may be left away need not.
    yield "@overload"
    yield from function(name, [*first, *in_order, "*", _UNCHECKED], "Draft", text)
    yield ""
    yield "@overload"
    yield from function(name, [*first, *in_order[:split], "*", *by_name[split:], _UNCHECKED], "Draft", text)


def _type(parameter: Parameter) -> str:
    """What a call takes for a parameter."""
    if parameter.type is Type.COUNT and parameter.elements is not Direction.IN:
        return "_Outputs"
    if parameter.type in (Type.COUNT, Type.VALUES):
        element = parameter.element
        return f"Sequence[{_SCALARS.get(element, '_Number') if isinstance(element, Type) else '_Untyped'}]"
    if parameter.direction is Direction.OUT:
        return "_Output"
    if parameter.direction is Direction.INOUT:
        return "_Variable"
    if parameter.enum is not None:
        return f"_{parameter.enum.name}"
    if parameter.type is not Type.STRING and parameter.length is not None:
        return "_Elements"
    return _SCALARS.get(parameter.type, "_Number")


_SCALARS = {Type.DATAF: "_Real", Type.STRING: "_Text", Type.ARRAY_TYPED: "_Real"}
