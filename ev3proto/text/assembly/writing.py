"""Messages as assembly, in the firmware's macro notation, which fixes every encoding: nothing of a frame is lost."""

from __future__ import annotations

import struct
from collections.abc import Iterator
from functools import cache

from ev3proto.dialogue import Exchange
from ev3proto.messages import (
    Argument,
    DaisyCommand,
    DaisyReply,
    DirectCommand,
    DirectReply,
    FieldValue,
    Message,
    Operation,
    OperationReader,
    SystemCommand,
    SystemReply,
)
from ev3proto.schema.identification import LABEL_BYTE
from ev3proto.tables.encoding import CONSTANT, GLOBAL, JUMP, LOCAL, Encoding
from ev3proto.tables.frame import MAX_LENGTH
from ev3proto.tables.system import SYSTEM_BY_NUMBER
from ev3proto.text.assembly.words import BYTES, CUT, FRAME, MESSAGE, STATUS, command_name
from ev3proto.text.patterns import is_usual
from ev3proto.text.phrases import quoted, short_float, spaced_hex

_BYTES_A_LINE = 32


def operation_line(operation: Operation) -> str:
    """One operation. An operation that is cut short ends in `...`."""
    if is_usual(operation):
        pieces = [_head(operation[0])]
    else:
        pieces = [f"op{operation.name}"]
        cmd = operation.cmd
        if cmd is not None:
            pieces.append(_macro(cmd, operation.command or ""))
    for argument in operation.arguments:
        parameter, form, value, _, _ = argument
        if type(value) is int and (form.kind in _VARIABLES or (parameter.enum is None and form.kind == CONSTANT)):
            before, after = _AROUND.get(id(form)) or _around(form)
            pieces.append(f"{before}{value}{after}")
        else:
            pieces.append(_macro(argument, _constant(argument)))
    if not operation.is_complete:
        pieces.append(CUT)
    return ", ".join(pieces)


_VARIABLES = (LOCAL, GLOBAL)

_AROUND: dict[int, tuple[str, str]] = {}
"""What stands around a number, by the id of its encoding: there is one object for each."""


def _around(form: Encoding) -> tuple[str, str]:
    before, after = f"{form.name}(", ")"
    if form.handle:
        before, after = f"HND({before}", f"{after})"
    if form.address:
        before, after = f"ADR({before}", f"{after})"
    around = _AROUND[id(form)] = before, after
    return around


@cache
def _head(schema: OperationReader) -> str:
    """An operation up to its arguments, where its CMD is encoded as is usual."""
    opcode, command = schema.declaration.opcode, schema.declaration.command
    return f"op{opcode.name}" if command is None else f"op{opcode.name}, LC0({command.name})"


def _constant(argument: Argument) -> str:
    value = argument.value
    if isinstance(value, str):
        return quoted(value)
    if isinstance(value, float):
        text = short_float(value)
        if struct.pack("<f", float(text)) == argument.raw[1:]:
            return text
        (pattern,) = struct.unpack("<I", argument.raw[1:])
        return f"0x{pattern:08X}"
    enum = argument.parameter.enum
    symbol = argument.symbol
    return symbol if enum is not None and symbol is not None and enum.members.get(symbol) == value else str(value)


def _macro(argument: Argument, value: str) -> str:
    form = argument.form
    if form.kind == JUMP and argument.raw[0] != LABEL_BYTE:
        # The firmware looks at three bits of it only, so that several bytes mean a label.
        return f"{BYTES}({spaced_hex(argument.raw)})"
    before, after = _AROUND.get(id(form)) or _around(form)
    if isinstance(argument.value, float) and not value.startswith("0x"):
        before = before.replace(form.name, "LCF")
    return f"{before}{value}{after}"


def assembly(exchange: Exchange, heading: str) -> Iterator[str]:
    """A message's lines: a comment on it, its header, then an operation a line, or the command, or bytes.

    `ev3proto.text.assembly.assemble` makes the same frame of them again, byte for byte, faulty or not.
    """
    message = exchange.message
    yield f"// {heading}"
    if message.type is None or message.flaw.headless:
        yield FRAME
        yield from _bytes(message.build())
    else:
        yield _header(message)
        yield from _body(message)
        yield from _bytes(message.rest)
    if message.fault is not None:
        yield f"// fault at {message.fault}"


def _header(message: Message) -> str:
    assert message.type is not None
    words = [MESSAGE, message.type.name, f"counter {message.counter}"]
    match message:
        case DirectCommand():
            words += [f"globals {message.global_size}", f"locals {message.local_size}"]
        case DaisyCommand():
            words.append(f"command {message.command or f'0x{message.number:02X}'}")
    if isinstance(message, DaisyCommand | DaisyReply):
        words += [f"layer_from {message.layer_from}", f"layer_to {message.layer_to}"]
    if message.stated_length is not None or message.length > MAX_LENGTH:
        words.append(f"length {message.length}")
    return " ".join(words)


def _body(message: Message) -> Iterator[str]:
    match message:
        case DirectCommand():
            yield from map(operation_line, message.operations)
        case DirectReply():
            yield from _bytes(message.memory)
        case SystemCommand() | SystemReply():
            yield from _system(message)
        case DaisyCommand() if message.operations:
            yield from map(operation_line, message.operations)
        case DaisyCommand() | DaisyReply():
            yield from _bytes(message.payload)


def _system(message: SystemCommand | SystemReply) -> Iterator[str]:
    entry = SYSTEM_BY_NUMBER.get(message.number)
    if entry is None:
        head = (message.number, message.status_code) if isinstance(message, SystemReply) else (message.number,)
        yield from _bytes(bytes(head))
        return
    values = []
    if isinstance(message, SystemReply):
        values.append(f"{STATUS}={message.status_code if message.status is None else message.status.name}")
    values += [f"{name}={_field(value)}" for name, value in message.fields.items()]
    if message.fault is not None:
        values.append(CUT)
    yield from f"{command_name(entry)}({', '.join(values)})".split("\n")


def _field(value: FieldValue) -> str:
    if isinstance(value, str):
        return quoted(value)
    if isinstance(value, int):
        return str(value)
    lines = [spaced_hex(line) for line in _cut(value)]
    return f"{BYTES}({lines[0] if lines else ''})" if len(lines) < 2 else "\n".join((f"{BYTES}(", *lines)) + ")"


def _bytes(data: bytes) -> Iterator[str]:
    for line in _cut(data):
        yield f"{BYTES} {spaced_hex(line)}"


def _cut(data: bytes) -> Iterator[bytes]:
    for start in range(0, len(data), _BYTES_A_LINE):
        yield data[start : start + _BYTES_A_LINE]
