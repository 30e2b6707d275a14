"""Recognition of assembly in a text of unknown kind."""

from __future__ import annotations

import re

from ev3proto.tables import OPCODES
from ev3proto.tables.source import BYTES, OBJECT_WORDS, OLD_WORDS, PARAMETER_WORDS, VARIABLE_WORDS
from ev3proto.tables.system import SYSTEM
from ev3proto.text.assembly.notations import FRAME, MESSAGE
from ev3proto.text.assembly.python_lists import is_python
from ev3proto.text.paste.elements import narrow

OBJECT = re.compile(rf"^[ \t]*({'|'.join(OBJECT_WORDS)})[ \t]+[A-Za-z_]", re.MULTILINE)
"""The start of an object in a source. A direct command may be one vmthread."""

_DECLARATION = "|".join((*VARIABLE_WORDS, *PARAMETER_WORDS, *OLD_WORDS, r"\#?define", "vmthread"))
_STATEMENT = re.compile(
    rf"""op[A-Z]\w*(?:[\s,(;]|$) | [A-Z][A-Z0-9_]*(?:\.[A-Z0-9_]+)?\s*\(
      | (?:{_DECLARATION})\s+[A-Za-z_]
      | {MESSAGE}(?:\s+(?:[A-Z]+_[A-Z_]+|[a-z_]+\s+\w+)|\s*$) | {FRAME}\s*$ | {BYTES}(?:\s+[0-9A-Fa-f]{{2}})+\s*$
      | [A-Za-z_]\w*:\s*$""",
    re.VERBOSE | re.ASCII,
)
_NAME = re.compile(r"([A-Za-z_]\w*)(?:\.\w+)?\s*(?:\(|$)", re.ASCII)
_LOG_LEVEL = re.compile(r"[A-Z]+\s*\([^)]*\)\s*:", re.ASCII)
"""`INFO(main): sent ...`: a line of a log, though INFO is an operation, too."""
_ADDRESS = re.compile(r"\s*\w+://", re.ASCII)
"""`http://192.168.0.1`: an address, not a label and a comment."""

_NAMES = {opcode.name for opcode in OPCODES} | {entry.name for entry in SYSTEM}


def is_assembly(line: str) -> bool:
    """Returns whether a line can only be assembly, also a misspelt one, or one with a comment."""
    code = narrow(line).partition("//")[0].strip()
    if _LOG_LEVEL.match(code) or _ADDRESS.match(line):
        return False
    if _STATEMENT.match(code) or is_python(line):
        return True
    name = _NAME.match(code)
    return name is not None and name[1].upper() in _NAMES
