"""Masks names, addresses and PINs in frames, for recordings that are given to others.

Numbers and texts are shown only where `tables.public` and Role.PUBLIC declare them public. Lengths stay, so a masked
frame has the same operations.
"""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache

from ev3proto.messages import (
    Argument,
    DaisyCommand,
    DirectCommand,
    DirectReply,
    FieldValue,
    Message,
    Operation,
    SystemCommand,
    SystemReply,
)
from ev3proto.schema.fields import REPLIES, REQUESTS
from ev3proto.schema.frame import parse
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE
from ev3proto.semantics.facts import facts_of
from ev3proto.semantics.footprint import whole_number
from ev3proto.semantics.judgement import judge
from ev3proto.semantics.replies import values_of
from ev3proto.tables.declaration import Declaration, Effect, Parameter, Role, Type
from ev3proto.tables.encoding import CONSTANT, JUMP, TEXT
from ev3proto.tables.public import Public, public_of
from ev3proto.tables.system import SYSTEM_BY_NUMBER, FieldKind

MASK = ord("x")

_SHORT_CONSTANT = 0
"""The constant 0 in its shortest encoding."""

_UNLOCK_LINE = re.compile(
    rb"GET /target\?sn=(?P<serial>[^\s]*)(?: ?VMTP1\.0)?\s*|Protocol: ?EV3\s*|Accept:EV340\s*|[\s\0]*"
)
"""The lines before the first frame that are shown."""

_ADDRESS = re.compile(
    r"\b\d{1,3}(?:\.\d{1,3}){3}(?::\d+)?\b"
    r"|(?<![\w:])(?=[\da-fA-F]*:[\da-fA-F]*:)[\da-fA-F:.]{3,}(?:%\w+)?(?::\d+)?"
    r"|\b[\da-fA-F]{12}\b"
)
"""An IPv4, IPv6 or MAC address, or a serial number."""

_ENDING = frozenset(
    (Effect.ENDS, Effect.ENDS_CODE, Effect.MAY_END, Effect.JUMPS_ALWAYS, Effect.NEVER_RUNS, Effect.FAILS)
)
"""The effects of operations after which others may not be reached."""

_TEXTS = (FieldKind.TEXT, FieldKind.COUNTED_TEXT)
"""The kinds of fields that hold texts; others hold numbers and the contents of files and mailboxes."""


def masked(frame: bytes, request: bytes | None = None, dialect: str = "official") -> bytes:
    """Returns a frame without names, addresses and PINs.

    Commands keep opcodes, CMDs, variables and lengths; those without private texts stay, and the values in replies to
    them. What cannot be read or paired, errors and daisy replies keep length, counter and type. Paths and contents of
    files, and the messages of WRITEMAILBOX, stay.
    """
    message = parse(frame, strict=False, dialect=dialect)
    if message.type is None or message.fault is not None:
        return _written_over(frame)
    asked = None if request is None else parse(request, strict=False, dialect=dialect)
    if isinstance(message, DirectReply):
        return _memory(frame, message, asked)
    if isinstance(message, DirectCommand):
        return frame if _is_shown(message) else _code(frame, message.operations, COMMAND_HEADER_SIZE)
    if isinstance(message, SystemCommand | SystemReply):
        return _fields(frame, message)
    if isinstance(message, DaisyCommand):
        is_shown = _is_shown(message) or not message.payload
        return frame if is_shown else _code(frame, message.operations, HEADER_SIZE + 3)
    return _written_over(frame)


def masked_opening(text: bytes) -> bytes:
    """Returns the texts on WiFi before the first frame, without serial number and unknown lines."""
    return b"".join(map(_masked_line, text.splitlines(keepends=True)))


def _masked_line(line: bytes) -> bytes:
    found = _UNLOCK_LINE.fullmatch(line)
    if found is None:
        return re.sub(rb"[^\r\n\0]", bytes((MASK,)), line)
    start, end = found.span("serial")
    return line if start < 0 else line[:start] + b"0" * (end - start) + line[end:]


def masked_note(note: str) -> str:
    """Returns a message for the user without IP addresses, ports and serial numbers."""
    return _ADDRESS.sub(chr(MASK), note)


def _written_over(frame: bytes, kept: int = HEADER_SIZE) -> bytes:
    return frame[:kept].ljust(len(frame), bytes((MASK,)))


def _is_shown(message: DirectCommand | DaisyCommand) -> bool:
    """Returns whether a command and its results have only numbers and texts that are public."""
    return all(
        not operation.declaration.is_newer
        and (row := public_of(operation.full_name)) is not None
        and all(_is_public(argument, operation, row) for argument in operation.arguments)
        for operation in message.operations
    )


def _is_public(argument: Argument, operation: Operation, row: Public) -> bool:
    """Returns whether an argument is a public number or text, or a variable into which the brick writes one."""
    parameter, form = argument.parameter, argument.form
    if form.handle or form.address or form.kind in (JUMP, TEXT):
        return False
    if parameter.type is Type.STRING or parameter.length is not None:
        return parameter.role is Role.PUBLIC and parameter.is_output and _has_room(parameter, operation, row)
    return parameter.is_output or _is_public_number(argument, row)


def _has_room(parameter: Parameter, operation: Operation, row: Public) -> bool:
    """Returns whether a text or an array is as long as what is public."""
    count = whole_number(next((one for one in operation.arguments if one.name == parameter.length), None))
    fits = count is not None and count >= 0 and (row.most is None or count <= row.most)
    return fits or isinstance(parameter.length, int)


def _is_public_number(argument: Argument, row: Public) -> bool:
    number, known = whole_number(argument), facts_of(argument.parameter)
    if argument.name in row.only:
        return number in row.only[argument.name]
    if argument.form.kind == CONSTANT:
        return number is None or judge(known, CONSTANT, number) is None
    # A variable that the brick reads may hold a part of a text, unless there are only a few documented values.
    return known.domain is not None


def _code(frame: bytes, operations: tuple[Operation, ...], start: int) -> bytes:
    """Masks a command except opcodes, CMDs, variables and lengths."""
    hidden = bytearray(_written_over(frame, start))
    for operation in operations:
        end = operation.offset + operation.length
        arguments = operation.arguments
        head = arguments[0].offset if arguments else end
        hidden[operation.offset : head] = frame[operation.offset : head]
        lengths = _lengths(operation.declaration)
        for argument in arguments:
            raw = argument.raw if argument.is_variable or argument.name in lengths else _argument(argument)
            hidden[argument.offset : argument.offset + len(raw)] = raw
    return bytes(hidden)


@cache
def _lengths(declaration: Declaration) -> frozenset[object]:
    """Returns the names of the parameters that give the length of a text, an array or a list."""
    counts = () if declaration.tail is None else (declaration.tail.counter.name,)
    return frozenset((*counts, *(parameter.length for parameter in declaration.parameters)))


def _argument(argument: Argument) -> bytes:
    """Returns an argument of the same size and kind without its value."""
    raw = argument.raw
    if argument.kind == TEXT:
        return _written_over(raw[:-1], 1) + raw[-1:]
    return _written_over(raw, 1) if argument.form.width else bytes((_SHORT_CONSTANT,))


def _memory(frame: bytes, reply: DirectReply, asked: Message | None) -> bytes:
    """Masks a direct reply except the values of a harmless command."""
    # Bytes outside of the command's outputs, or after the end of a text, may be left over from an earlier command.
    hidden = bytearray(_written_over(frame))
    if reply.is_error or not isinstance(asked, DirectCommand) or asked.fault is not None:
        return bytes(hidden)
    is_shown = _is_shown(asked)
    if is_shown:
        hidden[HEADER_SIZE:] = bytes(MASK if byte else 0 for byte in frame[HEADER_SIZE:])
    for value in values_of(reply, _reached(asked)):
        start, end = value.offset, value.offset + value.length
        if value.type == Type.STRING.label and frame[end : end + 1] == b"\0":
            hidden[end] = 0
        if is_shown:
            hidden[start:end] = frame[start:end]
    return bytes(hidden)


def _reached(command: DirectCommand) -> DirectCommand:
    """Returns a command without the operations after its end, whose outputs are left over from earlier ones."""
    operations = command.operations
    ends = (number for number, one in enumerate(operations, 1) if not _ENDING.isdisjoint(one.declaration.effects))
    return replace(command, operations=operations[: next(ends, len(operations))])


def _fields(frame: bytes, message: SystemCommand | SystemReply) -> bytes:
    """Masks the texts of a system message that are not public."""
    is_reply = isinstance(message, SystemReply)
    entry = SYSTEM_BY_NUMBER.get(message.number)
    if entry is None:
        return _written_over(frame)
    private = {
        field.name
        for field in (entry.reply if is_reply else entry.request)
        if field.kind in _TEXTS and not field.is_public
    }
    declared = (REPLIES if is_reply else REQUESTS)[message.number]
    begin = HEADER_SIZE + (2 if is_reply else 1)
    shown = bytearray(frame)
    given: dict[str, FieldValue] = {}
    start = begin
    for name, value in message.fields.items():
        given[name] = value
        end = begin + len(declared.write_present(given))
        if name in private:
            # The last byte is the zero of the text.
            shown[start : end - 1] = bytes((MASK,)) * (end - 1 - start)
        start = end
    return bytes(shown)
