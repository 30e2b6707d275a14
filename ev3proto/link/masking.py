"""Names, addresses and PINs in frames, written over: for recordings that are given to others.

Masked is every text that operations about communication say or hear, and every text of BLUETOOTHPIN. Lengths stay, so
a masked frame is a frame.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from ev3proto.messages import (
    DaisyCommand,
    DirectCommand,
    DirectReply,
    FieldValue,
    Message,
    SystemCommand,
    SystemReply,
)
from ev3proto.schema.fields import REPLIES, REQUESTS, Fields
from ev3proto.schema.frame import parse
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.semantics.replies import values_of
from ev3proto.tables import AREAS
from ev3proto.tables.declaration import Type
from ev3proto.tables.system import SYSTEM

MASK = ord("x")

_OPERATIONS = frozenset(opcode.name for opcode in AREAS["com"])
_COMMANDS = frozenset(entry.number for entry in SYSTEM if any(field.name == "pin" for field in entry.request))


def masked(frame: bytes, request: bytes | None = None, dialect: str = "official") -> bytes:
    """A frame without names, addresses and PINs.

    Args:
        frame: A whole frame.
        request: For a reply: the frame of the command that it answers.
        dialect: The firmware whose instruction set to read by.
    """
    message = parse(frame, strict=False, dialect=dialect)
    changed = bytearray(frame)
    for start, end in [*_said(message), *_heard(message, request, dialect)]:
        for at in range(start, min(end, len(changed))):
            if changed[at]:
                changed[at] = MASK
    return bytes(changed)


def _said(message: Message) -> list[tuple[int, int]]:
    """Where texts stand in a frame by itself: the constants of a direct command, the fields of a system message."""
    if isinstance(message, DirectCommand | DaisyCommand):
        return [
            (argument.offset + 1, argument.offset + argument.length)
            for operation in message.operations
            if operation.name in _OPERATIONS
            for argument in operation.arguments
            if argument.kind == "string"
        ]
    if isinstance(message, SystemCommand) and message.number in _COMMANDS:
        return list(_fields(REQUESTS[message.number], message.fields, HEADER_SIZE + 1))
    if isinstance(message, SystemReply) and message.number in _COMMANDS:
        return list(_fields(REPLIES[message.number], message.fields, HEADER_SIZE + 2))
    return []


def _fields(schema: Fields, fields: Mapping[str, FieldValue], begin: int) -> Iterator[tuple[int, int]]:
    """Where the texts among the fields stand."""
    given: dict[str, FieldValue] = {}
    start = begin
    for name, value in fields.items():
        given[name] = value
        end = begin + len(schema.write_present(given))
        if isinstance(value, str):
            yield start, end
        start = end


def _heard(message: Message, request: bytes | None, dialect: str) -> list[tuple[int, int]]:
    """Where texts stand in the memory of a direct reply."""
    if request is None or not isinstance(message, DirectReply):
        return []
    return [
        (value.offset, value.offset + value.length)
        for value in values_of(message, parse(request, strict=False, dialect=dialect))
        if value.op in _OPERATIONS and value.type == Type.STRING.label
    ]
