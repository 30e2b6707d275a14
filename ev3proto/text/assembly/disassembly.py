"""Messages as assembly, in either notation. Nothing of a frame is lost."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from ev3proto.dialogue import Exchange
from ev3proto.messages import (
    DaisyCommand,
    DaisyReply,
    DirectCommand,
    DirectReply,
    FieldValue,
    Message,
    Operation,
    SystemCommand,
    SystemReply,
)
from ev3proto.tables.frame import MAX_LENGTH
from ev3proto.tables.source import BYTES
from ev3proto.tables.system import SYSTEM_BY_NUMBER
from ev3proto.text.assembly.macro_notation import operation_line
from ev3proto.text.assembly.words import CUT, FRAME, MESSAGE, STATUS, command_name
from ev3proto.text.assembly.writing import lego_lines
from ev3proto.text.phrases import LEGO, MACROS, quoted, spaced_hex

_BYTES_A_LINE = 32


Notation = Callable[[Sequence[Operation]], Iterator[str]]
"""The operations of a message as lines."""

_WRITERS: dict[str, Notation] = {MACROS: lambda operations: map(operation_line, operations), LEGO: lego_lines}


def assembly(exchange: Exchange, heading: str, notation: str = MACROS) -> Iterator[str]:
    """Writes a message so that `ev3proto.text.assembly.assemble` makes the same frame of it, faulty or not.

    Args:
        exchange: The message, and what was said before it.
        heading: What the comment in front of it says.
        notation: How its operations are written, one of NOTATIONS.

    Yields:
        Its lines: the comment, its header, then an operation a line, or the command, or bytes.

    Raises:
        TypeError: It is no Exchange.
    """
    if not isinstance(exchange, Exchange):
        raise TypeError(
            f"assembly is made of an Exchange, not {type(exchange).__name__}: ev3proto.Dialogue().follow(message) gives"
            " one"
        )
    message = exchange.message
    yield f"// {heading}"
    if message.type is None or message.flaw.headless:
        yield FRAME
        yield from _bytes(message.build())
    else:
        yield _header(message)
        yield from _body(message, _WRITERS[notation])
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


def _body(message: Message, notation: Notation) -> Iterator[str]:
    match message:
        case DirectCommand():
            yield from notation(message.operations)
        case DirectReply():
            yield from _bytes(message.memory)
        case SystemCommand() | SystemReply():
            yield from _system(message)
        case DaisyCommand() if message.operations:
            yield from notation(message.operations)
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
