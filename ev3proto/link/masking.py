"""Masks names, addresses and PINs in frames, for recordings that are given to others.

Anything not known to be harmless is overwritten. Lengths stay, so a masked frame has the same operations.
"""

from __future__ import annotations

from functools import cache
from itertools import pairwise

from ev3proto.link.harm import running
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
from ev3proto.semantics.replies import values_of
from ev3proto.tables import AREAS, OPCODES
from ev3proto.tables.declaration import Declaration, Role, Type, declarations
from ev3proto.tables.encoding import TEXT
from ev3proto.tables.system import SYSTEM

MASK = ord("x")

_SHORT_CONSTANT = 0
"""The constant 0 in its shortest encoding."""


def _is_private(declaration: Declaration) -> bool:
    """Returns whether an operation is about names, addresses and PINs, or makes a text that may be one."""
    parameters = declaration.parameters
    texts = [parameter for parameter in parameters if parameter.type is Type.STRING]
    return (
        declaration.opcode in AREAS["com"]
        or any(parameter.role is Role.PRIVATE for parameter in parameters)
        or any(parameter.type is Type.VALUES for parameter in parameters)
        or (any(text.is_output for text in texts) and not all(text.is_output for text in texts))
    )


_OPERATIONS = frozenset(declaration.name for declaration in declarations(OPCODES) if _is_private(declaration))
_COMMANDS = frozenset(entry.number for entry in SYSTEM if any(field.name == "pin" for field in entry.request))


def masked(frame: bytes, request: bytes | None = None, dialect: str = "official") -> bytes:
    """Returns a frame without names, addresses and PINs.

    Commands about communication and texts keep opcodes, CMDs, variables and lengths. What cannot be read or paired,
    errors and daisy replies keep length, counter and type. Of other direct replies the values stay.

    Args:
        frame: A whole frame.
        request: For a reply: the frame of the command that it answers.
        dialect: The firmware whose instruction set to read by.
    """
    message = parse(frame, strict=False, dialect=dialect)
    if message.type is None or message.fault is not None:
        return _written_over(frame)
    asked = None if request is None else parse(request, strict=False, dialect=dialect)
    if isinstance(message, DirectReply):
        return _memory(frame, message, asked, dialect)
    if isinstance(message, DirectCommand):
        return _code(frame, message.operations, COMMAND_HEADER_SIZE) if _is_hidden(message, dialect) else frame
    if isinstance(message, SystemCommand | SystemReply):
        is_private = any(
            isinstance(one, SystemCommand | SystemReply) and one.number in _COMMANDS for one in (message, asked)
        )
        return _texts(frame, message) if is_private else frame
    if isinstance(message, DaisyCommand):
        return (
            _code(frame, message.operations, HEADER_SIZE + 3)
            if _is_hidden(message, dialect) and message.payload
            else frame
        )
    return _written_over(frame)


def _written_over(frame: bytes, kept: int = HEADER_SIZE) -> bytes:
    return frame[:kept].ljust(len(frame), bytes((MASK,)))


def _is_hidden(message: DirectCommand | DaisyCommand, dialect: str) -> bool:
    """Returns whether a command may be about names, addresses and PINs."""
    can_run, is_known = running(message, dialect)
    return not is_known or any(one.full_name in _OPERATIONS for one in (*message.operations, *can_run))


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
    """Returns the names of the parameters that say how long a text, an array or a list is."""
    parameters = declaration.parameters
    counts = [one.name for one, after in pairwise(parameters) if after.type is Type.VALUES]
    counts += [parameter.name for parameter in parameters if parameter.type is Type.COUNT]
    return frozenset((*counts, *(parameter.length for parameter in parameters)))


def _argument(argument: Argument) -> bytes:
    """Returns an argument of the same size and kind without its value."""
    raw = argument.raw
    if argument.kind == TEXT:
        return _written_over(raw[:-1], 1) + raw[-1:]
    return _written_over(raw, 1) if argument.form.width else bytes((_SHORT_CONSTANT,))


def _memory(frame: bytes, reply: DirectReply, asked: Message | None, dialect: str) -> bytes:
    """Masks a direct reply except the values of a harmless command.

    What no output of the command covers, the end of a text among it, may be left over from an earlier command.
    """
    hidden = bytearray(_written_over(frame))
    if reply.is_error or not isinstance(asked, DirectCommand) or asked.fault is not None:
        return bytes(hidden)
    is_hidden = _is_hidden(asked, dialect)
    if not is_hidden:
        hidden[HEADER_SIZE:] = bytes(MASK if byte else 0 for byte in frame[HEADER_SIZE:])
    for value in values_of(reply, asked):
        start, end = value.offset, value.offset + value.length
        if value.type == Type.STRING.label and frame[end : end + 1] == b"\0":
            hidden[end] = 0
        if not is_hidden:
            hidden[start:end] = frame[start:end]
    return bytes(hidden)


def _texts(frame: bytes, message: SystemCommand | SystemReply) -> bytes:
    """Masks a system message except number, status and lengths."""
    is_reply = isinstance(message, SystemReply)
    declared = (REPLIES if is_reply else REQUESTS)[message.number]
    begin = HEADER_SIZE + (2 if is_reply else 1)
    hidden = bytearray(_written_over(frame, begin))
    given: dict[str, FieldValue] = {}
    start = begin
    for name, value in message.fields.items():
        given[name] = value
        end = begin + len(declared.write_present(given))
        if isinstance(value, int):
            hidden[start:end] = frame[start:end]
        elif isinstance(value, str):
            hidden[end - 1] = frame[end - 1]
        start = end
    return bytes(hidden)
