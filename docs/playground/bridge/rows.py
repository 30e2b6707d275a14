"""The pieces of lines for the page: operations know their place in the reference."""

from __future__ import annotations

import re

from ev3proto.tables import AREAS
from ev3proto.tables.declaration import declarations
from ev3proto.text.spans import Line, Role, Spans, visible


def _links() -> dict[str, str]:
    """Returns the place of each operation in the reference, as Sphinx names headings."""
    names = {
        name: area
        for area, opcodes in AREAS.items()
        for each in declarations(opcodes)
        for name in (each.name, each.opcode.name)
    }
    return {name: f"{area}.html#{re.sub(r'[^a-z0-9]+', '-', name.lower()).strip('-')}" for name, area in names.items()}


_LINKS = _links()


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
