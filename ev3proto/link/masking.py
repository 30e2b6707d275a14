"""Masks names, addresses and PINs in frames, for recordings that are given to others.

Everything is masked but opcodes, CMDs, encodings, places in memory, lengths, and numbers of the operations that
`tables.public` declares public. A reply shows values only if it can answer no other command, and that one only reads.
"""

from __future__ import annotations

import re
from collections import OrderedDict

from ev3proto.link.whitelist import blamed
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
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, Header
from ev3proto.semantics.facts import facts_of
from ev3proto.semantics.footprint import whole_number
from ev3proto.semantics.judgement import judged
from ev3proto.semantics.replies import values_of
from ev3proto.tables.declaration import Role, Type
from ev3proto.tables.encoding import CONSTANT, TEXT
from ev3proto.tables.frame import MAX_FRAME
from ev3proto.tables.public import public_of
from ev3proto.tables.system import SYSTEM_BY_NUMBER, FieldKind

MASK = ord("x")

_MOST_COUNTERS = 1 << 15
"""Commands after which a reply to an earlier one no longer comes."""

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

_NUMBERS = (FieldKind.U8, FieldKind.U16, FieldKind.U32)
_PLACES = range(-1, MAX_FRAME)
"""Offsets in memory, and lengths, of which -1 is "all"."""


class Counters:
    """The counters of the commands to one brick, and what was sent with each: two commands, or one."""

    def __init__(self) -> None:
        self._sent: OrderedDict[int, bytes | None] = OrderedDict()

    def sent(self, frame: bytes) -> None:
        """Takes a command."""
        counter, body = Header.read(frame).counter, frame[HEADER_SIZE - 1 :]
        self._sent[counter] = body if self._sent.pop(counter, body) == body else None
        if len(self._sent) > _MOST_COUNTERS:
            self._sent.popitem(last=False)

    def is_sure(self, reply: bytes) -> bool:
        """Returns whether only one command may have this reply, however many were lost."""
        return self._sent.get(Header.read(reply).counter) is not None


def masked(frame: bytes, request: bytes | None = None, dialect: str = "official") -> bytes:
    """Returns a frame without names, addresses and PINs. `request`: what a reply surely answers."""
    message = parse(frame, strict=False, dialect=dialect)
    if message.type is None or message.fault is not None:
        return _written_over(frame)
    if isinstance(message, DirectReply):
        return _memory(frame, message, None if request is None else parse(request, strict=False, dialect=dialect))
    if isinstance(message, DirectCommand | DaisyCommand):
        start = COMMAND_HEADER_SIZE if isinstance(message, DirectCommand) else HEADER_SIZE + 3
        return _code(frame, message.operations, min(start, len(frame)))
    return _fields(frame, message) if isinstance(message, SystemCommand | SystemReply) else _written_over(frame)


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


def _code(frame: bytes, operations: tuple[Operation, ...], start: int) -> bytes:
    hidden = bytearray(_written_over(frame, start))
    for operation in operations:
        end = operation.offset + operation.length
        head = operation.arguments[0].offset if operation.arguments else end
        hidden[operation.offset : head] = frame[operation.offset : head]
        for argument in operation.arguments:
            raw = argument.raw if _is_public(argument, operation) else _without_value(argument)
            hidden[argument.offset : argument.offset + len(raw)] = raw
    return bytes(hidden)


def _is_public(argument: Argument, operation: Operation) -> bool:
    """Returns whether an argument is a place in memory, a length, or a number that is declared public."""
    declaration = operation.declaration
    lengths = {one.length for one in declaration.parameters} | {declaration.tail and declaration.tail.counter.name}
    if argument.is_variable:
        return argument.value in _PLACES
    if argument.name in lengths:
        return whole_number(argument) in _PLACES
    is_number = argument.kind == CONSTANT and not argument.form.handle and argument.parameter.type is not Type.STRING
    is_legal = is_number and judged(facts_of(argument.parameter), argument) is None
    return is_legal and not declaration.is_newer and public_of(operation.full_name) is not None


def _without_value(argument: Argument) -> bytes:
    raw = argument.raw
    if argument.kind == TEXT:
        return _written_over(raw[:-1], 1) + raw[-1:]
    return _written_over(raw, 1) if argument.form.width else b"\0"


def _memory(frame: bytes, reply: DirectReply, asked: Message | None) -> bytes:
    hidden = bytearray(_written_over(frame))
    if reply.is_error or not isinstance(asked, DirectCommand) or any(blamed(asked)):
        return bytes(hidden)
    # What only reads has no jumps and no ends: all outputs are written.
    shown = {
        (one.full_name, argument.name)
        for one in asked.operations
        if _has_public(one)
        for argument in one.arguments
        if _is_shown(argument)
    }
    for value in values_of(reply, asked):
        end = value.offset + value.length
        if value.type == Type.STRING.label and frame[end : end + 1] == b"\0":
            hidden[end] = 0
        if (value.full_name, value.name) in shown:
            hidden[value.offset : value.offset + value.length] = frame[value.offset : value.offset + value.length]
    return bytes(hidden)


def _has_public(operation: Operation) -> bool:
    layer = next((one for one in operation.arguments if one.parameter.role is Role.LAYER), None)
    return public_of(operation.full_name) is not None and (layer is None or whole_number(layer) == 0)


def _is_shown(argument: Argument) -> bool:
    """Returns whether an output is a number, or a public text; a list may be longer than what the brick writes."""
    parameter = argument.parameter
    is_text = parameter.type is Type.STRING
    return parameter.is_output and (parameter.role is Role.PUBLIC if is_text else parameter.length is None)


def _fields(frame: bytes, message: SystemCommand | SystemReply) -> bytes:
    """Masks the fields of a system message that are not numbers and not declared public."""
    is_reply, entry = isinstance(message, SystemReply), SYSTEM_BY_NUMBER.get(message.number)
    if entry is None:
        return _written_over(frame)
    kinds = {one.name: one for one in (entry.reply if is_reply else entry.request)}
    declared, begin = (REPLIES if is_reply else REQUESTS)[message.number], HEADER_SIZE + (2 if is_reply else 1)
    shown, given, start = bytearray(_written_over(frame, begin)), dict[str, FieldValue](), begin
    for name, value in message.fields.items():
        given[name] = value
        end = begin + len(declared.write_present(given))
        if kinds[name].kind in _NUMBERS or kinds[name].is_public:
            shown[start:end] = frame[start:end]
        elif kinds[name].kind is not FieldKind.DATA:
            shown[end - 1 : end] = frame[end - 1 : end]  # the zero of the text
        start = end
    return bytes(shown)
