"""`ev3proto.ops` and its dialects: a module for each family, and a private one for all other opcodes.

What a dialect shares with LEGO's own firmware is re-exported from there; its folder holds only what differs.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from ev3proto.generate.modules.argument_types import argument_type
from ev3proto.generate.modules.source import (
    FIRMWARES,
    INDENT,
    MARK,
    WIDTH,
    bracketed,
    described,
    docstring,
    exported,
    imported,
    indented,
    joined,
    natural,
    python_name,
    sentence,
)
from ev3proto.semantics.domain import facts
from ev3proto.semantics.drafts.functions import may_be_omitted
from ev3proto.tables import OPCODES, area_of
from ev3proto.tables import operations as operations_of
from ev3proto.tables.declaration import DIALECTS, Declaration, Direction, Opcode, Parameter, Type

_PLAIN = "_plain"
"""The module of opcodes without a CMD; the package imports all of it."""

_UNCHECKED = "unchecked: bool = False"

_TEXTS = {
    "official": [
        "Every operation as a function: `ops.sound.tone(volume=1, frequency=440, duration=1000)`, `ops.ui_flush()`.",
        "",
        "Opcodes with a CMD are families, and their commands are functions of those; all other opcodes are functions",
        "here. Names are the firmware's in lower case; a word of Python has a `_` after it (`ops.sound.break_`). A",
        "function gives a `Draft`, and `ev3proto.command` makes a command of drafts. Outputs may be omitted: the",
        "command finds a place for them.",
        "",
        "A value that means nothing to the brick is refused with a BuildError. `unchecked=True` lets it through, as",
        "far as it can be encoded.",
        "",
        "These are the operations of LEGO's own firmware; `ev3proto.ops.xtended` and `ev3proto.ops.compat` have those",
        "of the community's.",
        "",
        MARK,
    ],
    **{
        dialect: [
            f"Every operation of {FIRMWARES[dialect]} as a function, as `ev3proto.ops` has those of LEGO's own.",
            "",
            "What is the same in another firmware is the same function.",
            "",
            MARK,
        ]
        for dialect in DIALECTS[1:]
    },
}


def modules(dialect: str) -> dict[str, str]:
    """Returns the files of one dialect by their path in the project's folder."""
    folder = _package(dialect).replace(".", "/")
    files = {f"{folder}/__init__.py": joined(_index(dialect))}
    for opcode in _families(dialect):
        if _family_home(opcode, dialect) == dialect:
            files[f"{folder}/{python_name(opcode.name)}.py"] = joined(_family(opcode, dialect))
    if own := _plain_homes(dialect).get(dialect):
        files[f"{folder}/{_PLAIN}.py"] = joined(_plain_module(own, dialect))
    return files


def _package(dialect: str) -> str:
    return "ev3proto.ops" if dialect == DIALECTS[0] else f"ev3proto.ops.{dialect}"


def _home(declaration: Declaration) -> str:
    """Returns the dialect whose folder defines an operation: the first that knows it."""
    return next(dialect for dialect in DIALECTS if dialect in declaration.dialects)


def _families(dialect: str) -> list[Opcode]:
    """Returns the opcodes of a dialect that have a CMD."""
    return [opcode for opcode in OPCODES if opcode.is_family and dialect in opcode.dialects]


def _commands(opcode: Opcode, dialect: str) -> list[Declaration]:
    """Returns the operations of one family."""
    return [found for found in operations_of(dialect).values() if found.opcode is opcode]


def _family_home(opcode: Opcode, dialect: str) -> str:
    """Returns the first dialect whose family has the same commands."""
    wanted = _commands(opcode, dialect)
    return next(other for other in DIALECTS if _commands(opcode, other) == wanted)


def _plain_homes(dialect: str) -> dict[str, list[Declaration]]:
    """Returns the operations of a dialect without a CMD, area by area, by the dialect whose folder defines them."""
    plain = [found for found in operations_of(dialect).values() if found.command is None]
    found: dict[str, list[Declaration]] = {}
    for declaration in sorted(plain, key=lambda each: area_of(each.opcode)):
        found.setdefault(_home(declaration), []).append(declaration)
    return found


def _name(declaration: Declaration) -> str:
    return python_name(declaration.command.name if declaration.command else declaration.opcode.name)


# The package of a dialect


def _index(dialect: str) -> Iterator[str]:
    yield from docstring(_TEXTS[dialect])
    families = {python_name(opcode.name): _package(_family_home(opcode, dialect)) for opcode in _families(dialect)}
    plain = _plain_homes(dialect)
    yield ""
    yield "# ruff: noqa: F403, I001 - the private modules say what they export; one import for each module"
    yield ""
    for package in sorted(set(families.values())):
        names = [name for name, home in families.items() if home == package]
        yield from _reexported(package, names)
    for home in sorted(plain, key=DIALECTS.index):
        module = f"{_package(home)}.{_PLAIN}"
        if plain[home] == _plain_homes(home)[home]:
            yield f"from {module} import *"
        else:
            yield from _reexported(module, list(map(_name, plain[home])))


def _reexported(module: str, names: Sequence[str]) -> Iterator[str]:
    pairs = [f"{name} as {name}" for name in sorted(names, key=natural)]
    yield from bracketed(f"from {module} import (", pairs, ")", indent=" " * WIDTH)


# The modules with functions


def _family(opcode: Opcode, dialect: str) -> Iterator[str]:
    declarations = _commands(opcode, dialect)
    own = [declaration for declaration in declarations if _home(declaration) == dialect]
    name = python_name(opcode.name)
    others: dict[str, list[str]] = {}
    for declaration in declarations:
        if _home(declaration) != dialect:
            others.setdefault(f"{_package(_home(declaration))}.{name}", []).append(_name(declaration))
    yield from docstring([sentence(f"{opcode.name}: {opcode.text[:1].lower()}{opcode.text[1:]}"), "", MARK])
    yield from _imports(own, others)
    yield ""
    yield from exported(map(_name, declarations))
    yield from _functions(own, dialect)


def _plain_module(declarations: Sequence[Declaration], dialect: str) -> Iterator[str]:
    package = _package(dialect).removeprefix("ev3proto.")
    yield from docstring([f"Opcodes without a CMD, area by area; `{package}` has each under its name.", "", MARK])
    yield from _imports(declarations, {})
    yield ""
    yield from exported(map(_name, declarations))
    yield from _functions(declarations, dialect)


def _imports(declarations: Sequence[Declaration], others: Mapping[str, Sequence[str]]) -> Iterator[str]:
    types = {argument_type(parameter) for declaration in declarations for parameter in declaration.parameters}
    words = {word for each in types for word in re.findall(r"\w+", each)}
    is_overloaded = any(map(_is_overloaded, declarations))
    aliases = words - {"Sequence"} | ({"Number"} if is_overloaded else set())
    yield ""
    yield "from __future__ import annotations"
    yield ""
    standard = ["from collections.abc import Sequence"] * ("Sequence" in words)
    standard += ["from typing import overload"] * is_overloaded
    yield from standard + [""] * bool(standard)
    for module, names in sorted({**others, **({"ev3proto.ops.argument_types": aliases} if aliases else {})}.items()):
        yield from imported(module, names)
    yield "from ev3proto.semantics.drafts.draft import Draft"
    yield f"from ev3proto.semantics.drafts.functions import {'REQUIRED, ' if is_overloaded else ''}drafts"


def _functions(declarations: Sequence[Declaration], dialect: str) -> Iterator[str]:
    yield ""
    yield f'_OPERATIONS = drafts("{dialect}")'
    for declaration in declarations:
        yield ""
        yield ""
        yield from _function(declaration)


def _optional(declaration: Declaration) -> list[bool]:
    return [may_be_omitted(declaration, number) for number in range(len(declaration.parameters))]


def _is_overloaded(declaration: Declaration) -> bool:
    """Tells whether an optional parameter precedes a required one."""
    optional = _optional(declaration)
    return True in optional and not all(optional[optional.index(True) :])


def _function(declaration: Declaration) -> Iterator[str]:
    name = _name(declaration)
    names = [python_name(parameter.name) for parameter in declaration.parameters]
    optional = _optional(declaration)
    types = [argument_type(parameter) for parameter in declaration.parameters]
    in_order = [
        f"{each}: {kind}{' | None' if may and kind == 'Number' else ''}"
        for each, kind, may in zip(names, types, optional, strict=True)
    ]
    by_name = [f"{each} = None" if may else each for each, may in zip(in_order, optional, strict=True)]
    parameters = by_name
    if _is_overloaded(declaration):
        split = optional.index(True)
        # Positional calls give all of them; keyword calls may leave out optional ones.
        yield "@overload"
        yield from bracketed(f"def {name}(", [*in_order, "*", _UNCHECKED], ") -> Draft: ...")
        yield ""
        yield ""
        yield "@overload"
        yield from bracketed(f"def {name}(", [*in_order[:split], "*", *by_name[split:], _UNCHECKED], ") -> Draft: ...")
        yield ""
        yield ""
        after = [each if may else f"{each} = REQUIRED" for each, may in zip(by_name, optional, strict=True)]
        parameters = [*by_name[:split], *after[split:]]
    yield from bracketed(f"def {name}(", [*parameters, "*", _UNCHECKED], ") -> Draft:")
    texts = [
        (each, text_of(parameter, is_optional=may))
        for each, parameter, may in zip(names, declaration.parameters, optional, strict=True)
    ]
    if names:
        texts.append(("unchecked", "Accept values that mean nothing to the brick, as far as they can be encoded."))
    yield from indented(described(declaration.text, texts, INDENT))
    values = f"({', '.join(names)}{',' if len(names) == 1 else ''})"
    line = f'return _OPERATIONS["{declaration.name}"].draft({values}, unchecked)'
    if len(INDENT) + len(line) <= WIDTH:
        yield f"{INDENT}{line}"
    else:
        yield f'{INDENT}return _OPERATIONS["{declaration.name}"].draft('
        yield from indented(indented(bracketed("(", names, "), unchecked", indent=INDENT * 2)))
        yield f"{INDENT})"


def text_of(parameter: Parameter, *, is_optional: bool) -> str:
    """Returns meaning, unit, range, special values and type: `How loud; 0 to 100 %; 0: silent; DATA8.`"""
    return sentence(*_pieces(parameter, is_optional=is_optional))


def _pieces(parameter: Parameter, *, is_optional: bool) -> Iterator[str]:
    yield parameter.text
    yield from facts(parameter)
    yield _type(parameter)
    if parameter.counts and is_optional:
        yield "an output for each: a list of variables, or how many; one when omitted"
    elif parameter.direction is Direction.OUT:
        yield "an output, in global memory when omitted"
    elif is_optional:
        yield "computed when omitted"


def _type(parameter: Parameter) -> str:
    """Returns the type: `DATA16`, or that of a list's elements."""
    if parameter.is_list:
        element = parameter.element
        if isinstance(element, str):
            return f"a list, of the type in {element.lower()}"
        return f"a list of {element.label}" if isinstance(element, Type) else "a list"
    if parameter.direction is Direction.INOUT:
        return f"{parameter.type.label}, a variable that is read and written"
    return parameter.type.label
