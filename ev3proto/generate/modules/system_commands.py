"""`ev3proto.system`: a function for each system command."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.generate.modules.source import (
    INDENT,
    MARK,
    bracketed,
    described,
    docstring,
    exported,
    indented,
    joined,
    sentence,
)
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.schema.wire_format import NUMBERS
from ev3proto.tables.frame import MAX_FRAME
from ev3proto.tables.system import SYSTEM, FieldKind, SystemDeclaration, SystemField

_REPLY_HEAD: int = HEADER_SIZE + 2
"""Bytes of a reply before its fields: header, command, status."""

_ROOM = "max_bytes"
"""The field that limits the contents of a reply."""


def module() -> str:
    """Returns the text of `ev3proto.system`."""
    return joined(_system())


def bootloader_module() -> str:
    """Returns the text of `ev3proto.system.bootloader`."""
    return joined(_bootloader())


def _system() -> Iterator[str]:
    entries = [entry for entry in SYSTEM if not entry.bootloader]
    yield from docstring(
        [
            'Every system command as a function: `system.list_files("/home/root/lms2012/sys/")`, and files split into',
            "commands.",
            "",
            "Names are the firmware's in lower case; those of the bootloader are in `system.bootloader`. A path comes",
            "first, lengths are computed, and replies are as long as possible by default. `download` and `pieces`",
            "make several commands each.",
            "",
            MARK,
        ]
    )
    yield ""
    yield "from ev3proto.messages import SystemCommand"
    yield "from ev3proto.system import bootloader"
    yield "from ev3proto.system.moving import download, pieces"
    yield "from ev3proto.system.requests import request"
    yield ""
    yield from exported([*(entry.name.lower() for entry in entries), "bootloader", "download", "pieces"])
    for entry in entries:
        yield from _function(entry)


def _bootloader() -> Iterator[str]:
    entries = [entry for entry in SYSTEM if entry.bootloader]
    yield from docstring(["What only the brick's firmware updater knows (USB only).", "", MARK])
    yield ""
    yield "from ev3proto.messages import SystemCommand"
    yield "from ev3proto.system.requests import request"
    yield ""
    yield from exported(entry.name.lower() for entry in entries)
    for entry in entries:
        yield from _function(entry)


def _function(entry: SystemDeclaration) -> Iterator[str]:
    # The path, then required fields, then optional ones.
    fields = sorted(entry.request, key=lambda field: (_default(entry, field) is not None, field.name != "path"))
    always = ("*", "counter: int = 0", f"reply: bool = {entry.answered}")
    yield ""
    yield ""
    parameters = [*(_parameter(entry, field) for field in fields), *always]
    yield from bracketed(f"def {entry.name.lower()}(", parameters, ") -> SystemCommand:")
    texts = [(field.name, sentence(*_pieces(field))) for field in fields]
    texts.append(("counter", "The message counter, 0 to 65535."))
    texts.append(
        ("reply", "Whether the brick should answer" + ("." if entry.answered else "; it never answers this command."))
    )
    yield from indented(described(entry.text, texts, INDENT))
    values = [f"0x{entry.number:02X}", "counter", "reply", *(f"{field.name}={field.name}" for field in fields)]
    yield from indented(bracketed("return request(", values, ")", INDENT))


def _default(entry: SystemDeclaration, field: SystemField) -> str | None:
    """Returns a field's default; None for a required one."""
    if field.name == _ROOM:
        return str(_room(entry))
    return "None" if field.counts is not None or field.optional else None


def _room(entry: SystemDeclaration) -> int:
    """Returns the most bytes of contents that fit a reply."""
    fixed: int = sum(NUMBERS[field.kind].sizeof() for field in entry.reply if field.kind in NUMBERS)
    return MAX_FRAME - _REPLY_HEAD - fixed


def _parameter(entry: SystemDeclaration, field: SystemField) -> str:
    kind = "int" if field.kind in NUMBERS else "bytes" if field.kind is FieldKind.DATA else "str"
    kind = "str | float | bytes" if field.is_message else kind
    default = _default(entry, field)
    if default is None:
        return f"{field.name}: {kind}"
    return f"{field.name}: {kind}{' | None' if default == 'None' else ''} = {default}"


def _pieces(field: SystemField) -> Iterator[str]:
    yield field.text
    if field.kind in NUMBERS:
        yield f"0 to {(1 << 8 * NUMBERS[field.kind].sizeof()) - 1}"
    if field.most is not None:
        yield f"at most {field.most} bytes{' with its zero' if field.kind is FieldKind.TEXT else ''}"
    if field.counts is not None:
        yield f"computed from {field.counts} when omitted"
