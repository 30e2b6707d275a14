"""The page for looking up a number or a name."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.generate.pages.markdown import code, link, page, plain, table
from ev3proto.schema.argument import ENCODINGS
from ev3proto.tables import AREAS
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.declaration import declarations
from ev3proto.tables.encoding import Encoding
from ev3proto.tables.enumerations import ENUMERATIONS
from ev3proto.tables.errors import ERRORS
from ev3proto.tables.frame import MessageType
from ev3proto.tables.system import SYSTEM


def text() -> str:
    """Returns the page."""
    return page("Numbers and names", _lines())


def _lines() -> Iterator[str]:
    yield from _section("Message types", _message_types())
    yield from _section("Opcodes", _opcodes())
    yield from _section("Operations by their first bytes", _operations())
    yield from _section("Numbers of system commands", _system_commands())
    said = "Those of arguments with a byte of their own; the others carry a number in the byte itself."
    yield from _section("Identification bytes", _identification_bytes(), said)
    yield from _section("Errors that the firmware logs", _errors(), "`INFO.GET_ERROR` gives the number.")
    said = "Every name that EV3 programs use for a number, as an attribute of `ev3proto`."
    yield from _section("Constants", _constants(), said)


def _section(title: str, lines: Iterator[str], said: str = "") -> Iterator[str]:
    yield f"## {title}"
    yield ""
    if said:
        yield said
        yield ""
    yield from lines


def _message_types() -> Iterator[str]:
    yield from table(("byte", "name"), ((f"0x{each.value:02X}", code(each.name)) for each in MessageType))


def _opcodes() -> Iterator[str]:
    rows = sorted(
        (opcode.number, opcode.name, area, opcode.text) for area, opcodes in AREAS.items() for opcode in opcodes
    )
    yield from table(
        ("opcode", "decimal", "name", "what it does"),
        (
            (f"0x{number:02X}", str(number), link(name, name, f"{area}.md"), plain(said))
            for number, name, area, said in rows
        ),
    )


def _system_commands() -> Iterator[str]:
    yield from table(
        ("number", "name", "what it does"),
        ((f"0x{each.number:02X}", code(each.name), plain(each.text)) for each in SYSTEM),
    )


def _identification_bytes() -> Iterator[str]:
    yield from table(
        ("byte", "encoding", "bytes that follow"),
        (
            (f"0x{byte:02X}", f"{form.name}{_marks(form)}", "up to a zero" if form.width is None else str(form.width))
            for byte, form in enumerate(ENCODINGS)
            if form is not None and form.width != 0
        ),
    )


def _errors() -> Iterator[str]:
    yield from table(("number", "name"), ((str(number), code(name)) for number, name in enumerate(ERRORS)))


def _constants() -> Iterator[str]:
    found = dict(CONSTANTS)
    for declared in ENUMERATIONS:
        found |= declared.members
    yield from table(("name", "number"), ((code(name), str(number)) for name, number in sorted(found.items())))


def _marks(form: Encoding) -> str:
    return ", handle" * form.handle + ", address" * form.address


def _operations() -> Iterator[str]:
    found = []
    for area, opcodes in AREAS.items():
        for each in declarations(opcodes):
            if each.command is not None:
                found.append((each.opcode.number, each.command.number, each.name, area))
    yield from table(
        ("opcode", "CMD", "operation"),
        ((f"0x{opcode:02X}", str(cmd), link(name, name, f"{area}.md")) for opcode, cmd, name, area in sorted(found)),
    )
