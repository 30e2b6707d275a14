"""Operations in the firmware's macro notation, which fixes every encoding: `opSOUND, LC0(TONE), LC0(1), LC2(440)`."""

from __future__ import annotations

import struct
from collections.abc import Iterator

from ev3proto.dialogue import Exchange
from ev3proto.messages import Argument, DaisyCommand, DirectCommand, Operation
from ev3proto.text.phrases import quoted, short_float


def operation_line(operation: Operation) -> str:
    """One operation. An operation that is cut short ends in `...`."""
    pieces = [f"op{operation.name}"]
    cmd = operation.cmd
    if cmd is not None:
        pieces.append(_macro(cmd, operation.command or ""))
    pieces += [_macro(argument, _constant(argument)) for argument in operation.arguments]
    if not operation.is_complete:
        pieces.append("...")
    return ", ".join(pieces)


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
    return str(value)


def _macro(argument: Argument, value: str) -> str:
    name = argument.encoding
    if isinstance(argument.value, float) and not value.startswith("0x"):
        name = "LCF"
    text = f"{name}({value})"
    if argument.form.handle:
        text = f"HND({text})"
    if argument.form.address:
        text = f"ADR({text})"
    return text


def assembly(exchange: Exchange, heading: str) -> Iterator[str]:
    """A message's lines: what it is as a comment, then an operation a line; other messages are comments only."""
    message = exchange.message
    yield f"// {heading}"
    if isinstance(message, DirectCommand):
        yield f"// memory: {message.global_size} bytes global, {message.local_size} bytes local"
    if isinstance(message, DirectCommand | DaisyCommand):
        for operation in message.operations:
            yield operation_line(operation)
    else:
        yield f"// {message.build().hex(' ').upper()}"
    if message.fault is not None:
        yield f"// fault at {message.fault}"
