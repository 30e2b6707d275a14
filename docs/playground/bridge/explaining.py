"""What a frame says in words, and what the words mean: codes of `check`, encodings, parameters of operations."""

from __future__ import annotations

import json

from ev3proto.checking.codes import CODES
from ev3proto.checking.program_codes import PROGRAM_CODES
from ev3proto.dialogue import Exchange
from ev3proto.program.checking import explained
from ev3proto.schema.frame import parse
from ev3proto.semantics.domain import comment
from ev3proto.tables import OPCODES
from ev3proto.tables.declaration import declarations
from ev3proto.tables.encoding import ENCODING_TEXTS
from ev3proto.text.byte_by_byte import byte_lines, header_parts
from ev3proto.text.sentence import sentence
from ev3proto.text.spans import plain_text, visible

_PARAMETERS = {
    (each.name, parameter.name): parameter for each in declarations(OPCODES) for parameter in each.parameters
}


def about(frame: str) -> str:
    """Returns what a frame says.

    Args:
        frame: The frame, in hex.

    Returns:
        JSON: `sentence`, `parts` (each with name, offset, length, text) and `bytes`, a line each.
    """
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
    parameter = _PARAMETERS.get((operation, word.partition("[")[0]))
    if word in CODES | PROGRAM_CODES:
        found = "\n".join(map(plain_text, explained((CODES | PROGRAM_CODES)[word]))) + "\n"
    elif word in ENCODING_TEXTS:
        found = f"{word}: {': '.join(ENCODING_TEXTS[word])}"
    elif parameter is not None:
        found = f"{parameter.name}: {comment(parameter)}"
    return json.dumps(found)
