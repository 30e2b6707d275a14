"""Completion: names of operations and of the values of their parameters, at the cursor."""

from __future__ import annotations

import json
import re

from ev3proto.errors import near_names
from ev3proto.semantics.domain import comment
from ev3proto.tables import OPCODES
from ev3proto.tables.declaration import Declaration, Parameter, declarations

MOST_COMPLETIONS = 10

_CALL = re.compile(r"([A-Za-z_]\w*)\s*\(([^()]*)$")
_WORD = re.compile(r"[A-Za-z_][\w.]*$")
_PREFIXED = re.compile(r"op[A-Z]")


def complete(before: str) -> str:
    """Returns the completions at the cursor.

    Args:
        before: The line up to the cursor.

    Returns:
        JSON: `word`, the letters that a completion replaces; `words`, each with what to insert and what to show;
        `hint` about the parameter at the cursor.
    """
    word, prefix, hint, options = _place(before)
    name = word.removeprefix(prefix)
    words = [
        (prefix + each, shown) for each, shown in options if each.upper().startswith(name.upper()) and each != name
    ]
    if not words and name and all(each != name for each, _ in options):
        words = [(each, f"{each}: did you mean this?") for each in meant(before)]
    if len(words) > MOST_COMPLETIONS:
        hint = f"... and {len(words) - MOST_COMPLETIONS} more: type more letters"
    return json.dumps({"word": word, "words": words[:MOST_COMPLETIONS], "hint": hint})


def meant(before: str) -> list[str]:
    """Returns the names that the word at the cursor is close to, the nearest first: those that its error suggests."""
    word, prefix, _, options = _place(before)
    if options is _OPERATIONS:
        known = [*(opcode.name for opcode in OPCODES), *(each.name for each in _DECLARATIONS if "." in word)]
    else:
        known = [name for name, _ in options]
    return [prefix + each for each in near_names(word.removeprefix(prefix), known)]


def _place(before: str) -> tuple[str, str, str, list[tuple[str, str]]]:
    """Returns the word at the cursor, its `op` if that is not part of the name, a hint, and the names that fit."""
    found, call = _WORD.search(before), _CALL.search(before)
    word = found[0] if found else ""
    if call is None:
        return word, "op" if _PREFIXED.match(word) else "", "", _OPERATIONS if word else []
    return word, "", *_inside(call[1].upper().removeprefix("OP"), call[2].split(","))


def _signature(declaration: Declaration) -> str:
    names = [parameter.name for parameter in declaration.parameters]
    head = [] if declaration.command is None else [declaration.command.name]
    return f"{declaration.opcode.name}({', '.join([*head, *names])})"


_DECLARATIONS = list(declarations(OPCODES))
_BY_NAME = {each.name: each for each in _DECLARATIONS}
_OPERATIONS = [
    (each.name, f"{_signature(each)}  {each.text}") for each in sorted(_DECLARATIONS, key=lambda each: each.name)
]


def _inside(opcode: str, given: list[str]) -> tuple[str, list[tuple[str, str]]]:
    """The hint and the names for the last argument of a call."""
    commands = [each for each in _DECLARATIONS if each.command and each.opcode.name == opcode]
    if commands and len(given) == 1:
        return "", [(each.name.rpartition(".")[2], f"{_signature(each)}  {each.text}") for each in commands]
    name = f"{opcode}.{given.pop(0).strip().upper()}" if commands else opcode
    chosen = _BY_NAME.get(name)
    if chosen is None or len(given) > len(chosen.parameters):
        return "", []
    return _values(chosen.parameters[len(given) - 1])


def _values(parameter: Parameter) -> tuple[str, list[tuple[str, str]]]:
    members = parameter.enum.members if parameter.enum else parameter.names
    return f"{parameter.name}: {comment(parameter)}", [(name, f"{name} = {number}") for name, number in members.items()]
