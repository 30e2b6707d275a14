"""Functions and families of functions from the tables, made when they are first asked for."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from ev3proto.compose.calls import bound, python_name
from ev3proto.compose.drafts import Draft, draft, may_be_left_away
from ev3proto.errors import near_misses
from ev3proto.ops.describing import described
from ev3proto.schema.instructions import instruction_set
from ev3proto.schema.operation import OperationSchema
from ev3proto.tables import OPCODES, check_dialect
from ev3proto.tables import operations as operations_of
from ev3proto.tables.declaration import Declaration, Opcode


class Namespace:
    """Functions by name; an AttributeError suggests the nearest names.

    dialect  the firmware
    path     how it is called, with a dot behind it; empty for the operations that are in no family
    """

    def __init__(self, dialect: str, path: str, declarations: Sequence[Declaration], text: str = "") -> None:
        self._dialect = dialect
        self._path = path
        self._declarations = {
            python_name(found.command.name if found.command else found.opcode.name): found for found in declarations
        }
        self.__doc__ = text

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        declaration = self._declarations.get(name)
        if declaration is None:
            raise AttributeError(self._unknown(name, self._declarations))
        schema = instruction_set(self._dialect)[declaration.name]
        value = self.__dict__[name] = function(schema, f"{self._path}{name}")
        return value

    def _unknown(self, name: str, known: Mapping[str, Any]) -> str:
        hint = near_misses(name, [other.upper() for other in known]).lower()
        return f"the {self._dialect} firmware has no operation {self._path}{name}{hint}"

    def __dir__(self) -> list[str]:
        return sorted(self._declarations)

    def __repr__(self) -> str:
        return f"<operations {self._path.rstrip('.') or self._dialect}>"


class Operations(Namespace):
    """All operations of a dialect: families, and functions for opcodes without CMD."""

    def __init__(self, dialect: str) -> None:
        found = operations_of(check_dialect(dialect)).values()
        super().__init__(dialect, "", [declaration for declaration in found if declaration.command is None])
        self._families = {python_name(opcode.name): opcode for opcode in families(dialect)}

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        opcode = self._families.get(name)
        if opcode is None:
            if name not in self._declarations:
                raise AttributeError(self._unknown(name, {**self._declarations, **self._families}))
            return super().__getattr__(name)
        value = self.__dict__[name] = Namespace(
            self._dialect, f"{name}.", commands_of(opcode, self._dialect), f"{opcode.name}: {opcode.text}."
        )
        return value

    def __dir__(self) -> list[str]:
        return sorted([*self._declarations, *self._families])


def families(dialect: str) -> list[Opcode]:
    """The opcodes of a dialect that have a CMD."""
    return [opcode for opcode in OPCODES if opcode.is_family and dialect in opcode.dialects]


def commands_of(opcode: Opcode, dialect: str) -> list[Declaration]:
    """The operations of one family."""
    return [
        Declaration(opcode, command) for command in opcode.commands if dialect in Declaration(opcode, command).dialects
    ]


def function(schema: OperationSchema, name: str) -> Callable[..., Draft]:
    """The function for one operation.

    name  as it is called, for messages: `sound.tone`
    """
    declaration = schema.declaration
    names = tuple(python_name(parameter.name) for parameter in declaration.parameters)
    optional = frozenset(number for number in range(len(names)) if may_be_left_away(declaration, number))
    required = tuple(other for number, other in enumerate(names) if number not in optional)

    def operation(*values: Any, unchecked: bool = False, **named: Any) -> Draft:
        if not named and len(values) == len(names):
            return draft(schema, values, unchecked=unchecked)
        return draft(schema, bound(name, names, required, values, named), unchecked=unchecked)

    operation.__name__ = name.rpartition(".")[2]
    operation.__qualname__ = name
    operation.__module__ = "ev3proto.ops" if schema.dialect == "official" else f"ev3proto.ops.{schema.dialect}"
    operation.__doc__ = described(declaration, names)
    operation.__signature__ = _signature(declaration, names)  # type: ignore[attr-defined]
    return operation


def _signature(declaration: Declaration, names: Sequence[str]) -> inspect.Signature:
    """What `help` and interactive shells show. Behind what may be left away, all may in a signature."""
    parameters = []
    has_default = False
    for number, name in enumerate(names):
        has_default |= may_be_left_away(declaration, number)
        default = None if has_default else inspect.Parameter.empty
        parameters.append(inspect.Parameter(name, inspect.Parameter.POSITIONAL_OR_KEYWORD, default=default))
    unchecked = inspect.Parameter("unchecked", inspect.Parameter.KEYWORD_ONLY, default=False, annotation=bool)
    return inspect.Signature([*parameters, unchecked], return_annotation=Draft)
