"""The page of system commands, with the bootloader's, and of the statuses of their replies."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.generate.dissector.fields import filter_name
from ev3proto.generate.pages.examples import explained, system_example
from ev3proto.generate.pages.markdown import block, code, link, listed, plain, plain_sentence, table, try_it
from ev3proto.tables.system import SYSTEM, UNUSED_STATUSES, SystemDeclaration, SystemField, SystemStatus


def blocks() -> Iterator[str]:
    """Yields the blocks of the page."""
    yield (
        "What a brick is sent besides byte code: a number, then fields. A reply repeats the number, then has a"
        " [status](#statuses) and its own fields. Numbers are little-endian, texts end at a zero."
    )
    rows = (
        (f"0x{entry.number:02X}", link(entry.name, heading(entry)), plain(entry.text), "bootloader" * entry.bootloader)
        for entry in SYSTEM
    )
    yield table(("number", "command", "what it does", ""), rows)
    for entry in SYSTEM:
        yield from _entry(entry)
    yield "## Statuses"
    yield table(
        ("number", "name", ""),
        ((f"0x{status.value:02X}", code(status.name), _outcome(status)) for status in SystemStatus),
    )
    yield "What a status means depends on the command:"
    meanings = (
        (code(entry.name), code(status.name), plain(meaning)) for entry in SYSTEM for status, meaning in entry.statuses
    )
    yield table(("command", "status", "it means"), meanings)


def _outcome(status: SystemStatus) -> str:
    if status in UNUSED_STATUSES:
        return "no command of the published firmware answers with it"
    return "the command failed" if status.is_failure else "the command worked"


def heading(entry: SystemDeclaration) -> str:
    """Returns the heading of a command, which links lead to."""
    return f"{entry.name} (bootloader)" if entry.bootloader else entry.name


def _entry(entry: SystemDeclaration) -> Iterator[str]:
    yield f"## {heading(entry)}"
    yield plain_sentence(entry.text)
    yield listed(_facts(entry))
    yield _fields("request", entry, entry.request)
    if entry.answered:
        yield _fields("reply", entry, entry.reply)
    example = system_example(entry)
    yield block("python", [example.call])
    yield block("text", explained(example.frame))
    yield try_it(example.frame)


def _facts(entry: SystemDeclaration) -> Iterator[str]:
    yield f"Number `0x{entry.number:02X}`."
    if entry.bootloader:
        yield "Only the brick's firmware updater knows it, which is reached by USB."
    elif entry.usb_only:
        yield "The firmware takes it by USB only."
    yield from (f"It {plain(effect.value)}." for effect in entry.effects)
    if not entry.answered:
        yield "It is never replied to."


def _fields(title: str, entry: SystemDeclaration, fields: tuple[SystemField, ...]) -> str:
    if not fields:
        return f"Its {title} has no fields."
    return table((title, "type", "what it is", "in Wireshark"), (_field(entry, field) for field in fields))


def _field(entry: SystemDeclaration, field: SystemField) -> tuple[str, str, str, str]:
    meaning = plain_sentence(field.text)
    if field.most is not None:
        meaning += f" At most {field.most} bytes."
    if field.counts is not None:
        meaning += " Worked out when omitted."
    if field.optional:
        meaning += " It may be absent."
    return code(field.name), field.kind.value, meaning, code(f"ev3.{filter_name(entry, field)}")
