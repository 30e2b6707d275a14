"""Assembles the C header: head, frame, encodings, tables, functions."""

from __future__ import annotations

from string import Template

from ev3proto.generate.cheader import parts, tables
from ev3proto.schema.argument import encode_as
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE
from ev3proto.tables.declaration import Type
from ev3proto.tables.discovery import TCP_PORT
from ev3proto.tables.encoding import ADDRESS_BIT, HANDLE_BIT, NAN_FLOAT, RANGES
from ev3proto.tables.frame import COUNTERS, GLOBAL_BITS, LENGTH_FIELD, MAX_FRAME, MAX_GLOBALS, MAX_LOCALS
from ev3proto.version import VERSION

FILE_NAME = "ev3proto.h"

_VARIABLES = [f"{letter}V{width}" for letter in "LG" for width in (0, 1, 2, 4)]
_FORMS = ("LC0", "LC1", "LC2", "LC4", "LCS", "LCS_OLD", "LAB1", *_VARIABLES)


def build() -> str:
    """Returns the text of ev3proto.h."""
    sections = (parts.HEAD, parts.FRAMES, parts.ENCODINGS, tables.data(), parts.FUNCTIONS, parts.TAIL)
    return Template("\n".join(sections)).substitute(_facts())


def _facts() -> dict[str, object]:
    """Returns the numbers from the tables that the hand-written parts refer to."""
    facts: dict[str, object] = {
        "VERSION": VERSION,
        "TCP_PORT": TCP_PORT,
        "MAX_FRAME": MAX_FRAME,
        "LENGTH_FIELD": LENGTH_FIELD,
        "HEADER_SIZE": HEADER_SIZE,
        "MEMORY_SIZE": COMMAND_HEADER_SIZE - HEADER_SIZE,
        "MAX_COUNTER": COUNTERS - 1,
        "MAX_GLOBALS": MAX_GLOBALS,
        "MAX_LOCALS": MAX_LOCALS,
        "GLOBAL_BITS": GLOBAL_BITS,
        "HANDLE_BIT": f"0x{HANDLE_BIT:02X}",
        "ADDRESS_BIT": f"0x{ADDRESS_BIT:02X}",
        "NAN_FLOAT": f"0x{int.from_bytes(NAN_FLOAT, 'little'):08X}",
        "DATA8_MAX": RANGES[Type.DATA8].high,
        "DATA16_MAX": RANGES[Type.DATA16].high,
    }
    for form in _FORMS:
        head = encode_as(form, "" if form.startswith("LCS") else 0)[0]
        facts[form] = f"0x{head:02X}"
    return facts
