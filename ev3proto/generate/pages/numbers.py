"""The page for looking up a number or a name."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.generate.pages.markdown import code, link, plain, table
from ev3proto.tables import AREAS
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.declaration import declarations
from ev3proto.tables.encoding import ENCODINGS, Encoding
from ev3proto.tables.enumerations import ENUMERATIONS
from ev3proto.tables.errors import ERRORS
from ev3proto.tables.frame import MessageType
from ev3proto.tables.system import SYSTEM


def blocks() -> Iterator[str]:
    """Yields the blocks of the page."""
    yield "## Message types"
    yield table(("byte", "name"), ((f"0x{each.value:02X}", code(each.name)) for each in MessageType))
    yield "## Opcodes"
    yield _opcodes()
    yield "## Operations by their first bytes"
    yield _operations()
    yield "## Numbers of system commands"
    yield _system_commands()
    yield "## Identification bytes"
    yield "Those of arguments with a byte of their own; the others carry a number in the byte itself."
    yield _identification_bytes()
    yield "## Errors that the firmware logs"
    yield "`INFO.GET_ERROR` gives the number."
    yield table(("number", "name"), ((str(number), code(name)) for number, name in enumerate(ERRORS)))
    yield "## Constants"
    yield "Every name that EV3 programs use for a number, as an attribute of `ev3proto`."
    yield _constants()


def _opcodes() -> str:
    rows = sorted(
        (opcode.number, opcode.name, area, opcode.text) for area, opcodes in AREAS.items() for opcode in opcodes
    )
    return table(
        ("opcode", "decimal", "name", "what it does"),
        (
            (f"0x{number:02X}", str(number), link(name, name, f"{area}.md"), plain(said))
            for number, name, area, said in rows
        ),
    )


def _system_commands() -> str:
    return table(
        ("number", "name", "what it does"),
        ((f"0x{each.number:02X}", code(each.name), plain(each.text)) for each in SYSTEM),
    )


def _identification_bytes() -> str:
    return table(
        ("byte", "encoding", "bytes that follow"),
        (
            (f"0x{byte:02X}", f"{form.name}{_marks(form)}", "up to a zero" if form.width is None else str(form.width))
            for byte, form in enumerate(ENCODINGS)
            if form is not None and form.width != 0
        ),
    )


def _constants() -> str:
    found = dict(CONSTANTS)
    for declared in ENUMERATIONS:
        found |= declared.members
    return table(("name", "number"), ((code(name), str(number)) for name, number in sorted(found.items())))


def _marks(form: Encoding) -> str:
    return ", handle" * form.handle + ", address" * form.address


def _operations() -> str:
    found = []
    for area, opcodes in AREAS.items():
        for each in declarations(opcodes):
            if each.command is not None:
                found.append((each.opcode.number, each.command.number, each.name, area))
    return table(
        ("opcode", "CMD", "operation"),
        ((f"0x{opcode:02X}", str(cmd), link(name, name, f"{area}.md")) for opcode, cmd, name, area in sorted(found)),
    )
