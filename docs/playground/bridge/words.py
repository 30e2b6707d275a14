"""What a frame says in words, what the words mean and where that is told, and how the word at the cursor goes on.

Words are codes of `check`, encodings, operations, their parameters, and the values of those.
"""

from __future__ import annotations

import json
import re

from ev3proto.checking.codes import CODES
from ev3proto.checking.program_codes import PROGRAM_CODES
from ev3proto.dialogue import Exchange
from ev3proto.errors import near_names
from ev3proto.program.checking import explained
from ev3proto.schema.frame import parse
from ev3proto.semantics.domain import comment
from ev3proto.tables import AREAS, OPCODES
from ev3proto.tables.declaration import Declaration, declarations
from ev3proto.tables.encoding import ENCODING_TEXTS
from ev3proto.text.byte_by_byte import byte_lines, header_parts
from ev3proto.text.sentence import sentence
from ev3proto.text.spans import Line, Role, Spans, plain_text, visible

MOST_COMPLETIONS = 10

ALL_CODES = CODES | PROGRAM_CODES

_CALL = re.compile(r"([A-Za-z_]\w*)\s*\(([^()]*)$")
_WORD = re.compile(r"[A-Za-z_][\w.]*$")
_PREFIXED = re.compile(r"op[A-Z]")


def complete(before: str) -> str:
    """Returns the completions at the cursor as JSON; `before` is the line up to it.

    `word` has the letters that a completion replaces; `words`, each with what to insert and what to show; `hint` about
    the parameter at the cursor.
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
    parameter = chosen.parameters[len(given) - 1]
    members = parameter.enum.members if parameter.enum else parameter.names
    return f"{parameter.name}: {comment(parameter)}", [(name, f"{name} = {number}") for name, number in members.items()]


def about(frame: str) -> str:
    """Returns what a frame in hex says: `sentence`, `parts` (name, offset, length, text) and `bytes`, a line each."""
    message = parse(bytes.fromhex(frame), strict=False)
    return json.dumps(
        {
            "sentence": visible(sentence(Exchange(message))),
            "parts": [part._asdict() for part in header_parts(message)],
            "bytes": [visible(line) for line in byte_lines(message)],
        }
    )


def explain(word: str, operation: str = "") -> str:
    """Returns what a word means, as JSON; empty if it is unknown.

    Args:
        word: A code, an encoding, or a parameter; `VALUES[0]` is an element of `VALUES`.
        operation: The operation that has the parameter.
    """
    found = ""
    chosen, name = _BY_NAME.get(operation), word.partition("[")[0]
    parameters = [each for each in (chosen.parameters if chosen else ()) if each.name == name]
    if word in ALL_CODES:
        found = "\n".join(map(plain_text, explained(ALL_CODES[word]))) + "\n"
    elif word in ENCODING_TEXTS:
        found = f"{word}: {': '.join(ENCODING_TEXTS[word])}"
    elif parameters:
        found = f"{name}: {comment(parameters[-1])}"
    return json.dumps(found)


_LINKS = {
    name: f"{area}.html#{re.sub(r'[^a-z0-9]+', '-', name.lower()).strip('-')}"
    for area, opcodes in AREAS.items()
    for each in declarations(opcodes)
    for name in (each.name, each.opcode.name)
}
"""The place of each operation in the reference, as Sphinx names headings."""


def pieces(line: Spans) -> list[list[str]]:
    """Returns the pieces of a line with a role each, and for an operation its place in the reference."""
    found = [[visible(text), role] for text, role in line if text]
    while found and not found[-1][0].rstrip():
        found.pop()
    if found:
        found[-1][0] = found[-1][0].rstrip()
    target = line.target if isinstance(line, Line) else ""
    for piece in found:
        if target and piece[1] == Role.OPERATION:
            piece.append(_LINKS[target])
    return found
