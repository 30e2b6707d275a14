"""Completion: names of operations and of the values of their parameters, at the cursor."""

from __future__ import annotations

import json
import re

from ev3proto.errors import near_names
from ev3proto.semantics.domain import comment
from ev3proto.tables import OPCODES
from ev3proto.tables.declaration import Declaration, declarations

MOST_COMPLETIONS = 10

_CALL = re.compile(r"([A-Za-z_]\w*)\s*\(([^()]*)$")
_WORD = re.compile(r"[A-Za-z_][\w.]*$")
_PREFIXED = re.compile(r"op[A-Z]")


def complete(before: str) -> str:
    """Returns the completions at the cursor.

    Args:
        before: The line up to the cursor.

    Returns:
        JSON: `word`, the letters that a completion replaces; `words`, each with what to insert and what to show; `hint`
        about the parameter at the cursor.
    """
    found = _WORD.search(before)
    word = found[0] if found else ""
    call = _CALL.search(before)
    if call is None:
        hint, options = "", _OPERATIONS if word else []
    else:
        hint, options = _inside(call[1].upper().removeprefix("OP"), call[2].split(","))
    prefix = "op" if call is None and _PREFIXED.match(word) else ""
    name = word.removeprefix(prefix)
    words = [
        (prefix + each, shown) for each, shown in options if each.upper().startswith(name.upper()) and each != name
    ]
    if not words and name and all(each != name for each, _ in options):
        # The same names that the error suggests.
        known = dict(options) if call is not None else _heads(word)
        words = [(prefix + each, f"{each}: did you mean this?") for each in near_names(name, known)]
    if len(words) > MOST_COMPLETIONS:
        hint = f"... and {len(words) - MOST_COMPLETIONS} more: type more letters"
    return json.dumps({"word": word, "words": words[:MOST_COMPLETIONS], "hint": hint})


def _heads(word: str) -> list[str]:
    """Returns what an operation can begin with."""
    return [*(opcode.name for opcode in OPCODES), *(each.name for each in _DECLARATIONS if "." in word)]


def _signature(declaration: Declaration) -> str:
    names = [parameter.name for parameter in declaration.parameters]
    head = [] if declaration.command is None else [declaration.command.name]
    return f"{declaration.opcode.name}({', '.join([*head, *names])})"


_DECLARATIONS = list(declarations(OPCODES))
_OPERATIONS = [
    (each.name, f"{_signature(each)}  {each.text}") for each in sorted(_DECLARATIONS, key=lambda each: each.name)
]


def _inside(opcode: str, given: list[str]) -> tuple[str, list[tuple[str, str]]]:
    """The hint and the names for the last argument of a call."""
    matching = [each for each in _DECLARATIONS if each.opcode.name == opcode or each.name == opcode]
    if not matching:
        return "", []
    if matching[0].command is not None and matching[0].name != opcode:
        if len(given) == 1:
            return "", [(each.command.name, f"{_signature(each)}  {each.text}") for each in matching if each.command]
        chosen = given.pop(0).strip().upper()
        matching = [each for each in matching if each.command and each.command.name == chosen]
    if not matching or len(given) > len(matching[0].parameters):
        return "", []
    parameter = matching[0].parameters[len(given) - 1]
    members = parameter.enum.members if parameter.enum else parameter.names
    return f"{parameter.name}: {comment(parameter)}", [(name, f"{name} = {number}") for name, number in members.items()]
