"""The stub of `ev3proto.system`: a function for each system command."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.generate.stubs.writing import HEAD, docstring, function, indented
from ev3proto.schema.fields import NUMBERS
from ev3proto.system.making import default_of, described, fields_in_order
from ev3proto.tables.system import SYSTEM, Field, Kind, SystemCommand


def stub() -> str:
    """The text of the file."""
    return "\n".join(_lines()) + "\n"


def _lines() -> Iterator[str]:
    yield from docstring(f"Every system command as a function.\n\n{HEAD}")
    yield ""
    yield "from ev3proto.messages import SystemCommand"
    yield "from ev3proto.system.moving import download as download"
    yield "from ev3proto.system.moving import pieces as pieces"
    for entry in SYSTEM:
        if not entry.bootloader:
            yield ""
            yield from _function(entry)
    yield ""
    yield "class _Bootloader:"
    yield from indented(docstring("What only the brick's firmware updater knows (USB only)."))
    for entry in SYSTEM:
        if entry.bootloader:
            yield ""
            yield from indented(_function(entry, "self"))
    yield ""
    yield "bootloader: _Bootloader"


def _function(entry: SystemCommand, *first: str) -> Iterator[str]:
    fields = (_parameter(entry, field) for field in fields_in_order(entry))
    always = ("*", "counter: int = 0", f"reply: bool = {entry.answered}")
    yield from function(entry.name.lower(), [*first, *fields, *always], "SystemCommand", described(entry))


def _parameter(entry: SystemCommand, field: Field) -> str:
    kind = "int" if field.kind in NUMBERS else "bytes" if field.kind is Kind.DATA else "str"
    default = default_of(entry, field)
    if default is None:
        return f"{field.name}: {kind}"
    return f"{field.name}: {kind}{' | None' if default == 'None' else ''} = {default}"
