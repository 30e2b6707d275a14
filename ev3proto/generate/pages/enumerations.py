"""The page of enumerations: the names of numbers."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.generate.pages.markdown import code, link, plain_sentence, table
from ev3proto.tables import AREAS
from ev3proto.tables.declaration import Enumeration, declarations
from ev3proto.tables.enumerations import ENUMERATIONS


def blocks() -> Iterator[str]:
    """Yields the blocks of the page."""
    yield (
        "The names that the firmware gives to numbers. In Python each is a class of `ev3proto.enums`. Where all names"
        " of one have a word in common, they have a name without it, too: `enums.LEDPATTERN.LED_RED_FLASH` is"
        " `enums.LED.RED_FLASH`. Operations take the name as a text, too."
    )
    users = _users()
    for declared in ENUMERATIONS:
        yield f"## {declared.name}"
        bits = "\nIts members are bits, and a value is any of them together." if declared.flags else ""
        yield plain_sentence(declared.text) + bits
        rows = ((str(number), f"0x{number & 0xFF:02X}", code(name)) for name, number in declared.members.items())
        yield table(("number", "byte", "name"), rows)
        if declared.end is not None:
            name, number = declared.end
            yield f"`{name}` is {number}, the number after the last or a mask of all; it is a constant, never a value."
        found = users.get(declared.name, [])
        if found:
            yield f"Taken or given by {', '.join(found)}."


def _users() -> dict[str, list[str]]:
    """Returns links to the operations with a parameter of each enumeration."""
    found: dict[str, list[str]] = {}
    for area, opcodes in AREAS.items():
        for declaration in declarations(opcodes):
            enums: dict[str, Enumeration] = {it.enum.name: it.enum for it in declaration.parameters if it.enum}
            for name in enums:
                found.setdefault(name, []).append(link(declaration.name, declaration.name, f"{area}.md"))
    return found
