"""What each byte of a frame says: one line a byte, and one a field of the header, for people who learn the protocol."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from ev3proto.errors import counted
from ev3proto.messages import (
    Argument,
    DaisyCommand,
    DaisyReply,
    DirectCommand,
    DirectReply,
    Message,
    Operation,
    SystemCommand,
    SystemReply,
)
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE
from ev3proto.semantics.replies import Value, field_values
from ev3proto.tables.encoding import ADDRESS_BIT, ENCODINGS, GLOBAL_BIT, HANDLE_BIT, LONG_BIT, TEXT, VARIABLE_BIT
from ev3proto.tables.frame import COUNTER_SIZE, LENGTH_FIELD, TYPE_MEANINGS
from ev3proto.text.phrases import argument_value, command_name, plain, short_text, status_name

_TYPE = LENGTH_FIELD + COUNTER_SIZE
_SIZE_BITS = 3


class HeaderField(NamedTuple):
    """A field of a header.

    name    `length`, `counter`, `type`, `memory`; of others also `command`, `status`, `layer_from` and `layer_to`
    offset  of its first byte in the frame
    length  the number of its bytes
    text    its value, and what that means
    """

    name: str
    offset: int
    length: int
    text: str


def header_parts(message: Message) -> Iterator[HeaderField]:
    """Yields the fields of a message's header, as far as the frame has them."""
    frame = message.build()
    for part in _parts(message, frame):
        if part.offset + part.length <= len(frame):
            yield part


def _parts(message: Message, frame: bytes) -> Iterator[HeaderField]:
    stated, right = int.from_bytes(frame[:LENGTH_FIELD], "little"), len(frame) - LENGTH_FIELD
    wrong = "" if stated == right else f" according to it; in fact {right}"
    yield HeaderField("length", 0, LENGTH_FIELD, f"{counted(stated, 'byte')} after this field{wrong}")
    # A frame that ends before its type has a counter, which its message lacks.
    counter = int.from_bytes(frame[LENGTH_FIELD:_TYPE], "little")
    yield HeaderField("counter", LENGTH_FIELD, COUNTER_SIZE, f"{counter}; a reply has the counter of its command")
    if message.type is None or len(frame) < HEADER_SIZE:
        return
    meaning = TYPE_MEANINGS[message.type]
    yield HeaderField("type", _TYPE, 1, f"0x{message.type:02X} {message.type.name}: {meaning}")
    if message.flaw.headless:
        return
    if isinstance(message, DirectCommand):
        memory = f"{message.global_size} bytes global, for the reply; {message.local_size} bytes local, for its own use"
        yield HeaderField("memory", HEADER_SIZE, COMMAND_HEADER_SIZE - HEADER_SIZE, memory)
    elif isinstance(message, SystemCommand | SystemReply | DaisyCommand):
        yield HeaderField("command", HEADER_SIZE, 1, f"0x{message.number:02X} {command_name(message)}")
        if isinstance(message, SystemReply):
            yield HeaderField("status", HEADER_SIZE + 1, 1, f"{message.status_code} {status_name(message)}")
    if isinstance(message, DaisyCommand | DaisyReply):
        at = HEADER_SIZE + isinstance(message, DaisyCommand)
        yield HeaderField("layer_from", at, 1, str(message.layer_from))
        yield HeaderField("layer_to", at + 1, 1, str(message.layer_to))


def byte_lines(message: Message) -> list[str]:
    """Returns a line for each byte of a message's frame."""
    frame = message.build()
    lines = [f"0x{byte:02X}, not part of what could be read" for byte in frame]
    for offset, texts in _lines(message, frame):
        # Of a frame that is cut, some bytes are not there.
        for at, text in zip(range(offset, len(frame)), texts, strict=False):
            lines[at] = f"0x{frame[at]:02X}{text}"
    return [f"Byte {at}: {line}" for at, line in enumerate(lines)]


def _lines(message: Message, frame: bytes) -> Iterator[tuple[int, list[str]]]:
    """Yields offsets, and what the bytes from there say."""
    end = 0
    for part in header_parts(message):
        yield part.offset, [f", {_place(at, part.length)}{part.name}: {part.text}" for at in range(part.length)]
        end = part.offset + part.length
    match message:
        case DirectReply():
            yield end, _counted(len(message.memory), "global memory, which the command asked for")
        case DaisyCommand() | DaisyReply():
            yield end, _counted(len(message.payload), "the payload")
        case SystemCommand() | SystemReply():
            yield from ((value.offset, _field(value, frame)) for value in field_values(message))
    for operation in message.operations if isinstance(message, DirectCommand | DaisyCommand) else ():
        yield from _operation(operation, frame)


def _field(field: Value, frame: bytes) -> list[str]:
    """Returns a line for each byte of a field."""
    if isinstance(field.value, bytes):
        return _counted(field.length, field.name)
    told = _letters if isinstance(field.value, str) else _numbered
    data = frame[field.offset : field.offset + field.length]
    return told(data, f"{field.name} = {short_text(plain(field.value))}")


def _operation(operation: Operation, frame: bytes) -> Iterator[tuple[int, list[str]]]:
    yield operation.offset, [f", opcode {operation.name}: {operation.declaration.opcode.text}"]
    if operation.cmd is not None and operation.command is not None:
        shown = f"CMD {operation.command}: {operation.declaration.text}"
        yield operation.cmd.offset, _argument(operation.cmd, shown, frame)
    for argument in operation.arguments:
        yield argument.offset, _argument(argument, f"{argument.name} = {short_text(argument_value(argument))}", frame)


def _argument(argument: Argument, shown: str, frame: bytes) -> list[str]:
    """Returns a line for each byte of an argument."""
    data = frame[argument.offset + 1 : argument.offset + argument.length]
    told = _letters if argument.form.kind == TEXT else _numbered
    return [f" = {identification(frame[argument.offset])}: {shown}", *told(data, shown)]


def _counted(size: int, of: str) -> list[str]:
    """Returns a line for each byte of bytes without a form."""
    return [f", byte {at} of {of}" for at in range(size)]


def _letters(data: bytes, shown: str) -> list[str]:
    """Returns a line for each byte of a text."""
    return [f", {plain(chr(byte))} of {shown}" if byte else f", the end of {shown}" for byte in data]


def _numbered(data: bytes, shown: str) -> list[str]:
    """Returns a line for each byte of a number."""
    return [f", {_place(at, len(data))}{shown}" for at in range(len(data))]


def _place(at: int, count: int) -> str:
    """Returns which byte of a number it is; the lowest comes first."""
    return f"byte {at + 1} of {count} (lowest first) of " if count > 1 else ""


def identification(byte: int) -> str:
    """Returns the bits of an identification byte, and what they say: `1 0 0 0 0 010, long, constant, LC2`.

    Args:
        byte: The byte, 0 to 255.
    """
    encoding = ENCODINGS[byte]
    if encoding is None:
        return f"{byte:08b}, undefined as an identification byte"
    is_variable = bool(byte & VARIABLE_BIT)
    kind = "variable" if is_variable else "constant"
    which = {(True, True): ", global", (True, False): ", local", (False, True): ", label"}
    if not byte & LONG_BIT:
        what = f", {'global' if byte & GLOBAL_BIT else 'local'}, index" if is_variable else ", value"
        return f"{_bits(byte, 1, 1, 1, 5)}, short {kind}{what} in the byte itself ({encoding})"
    marks = [word for bit, word in ((HANDLE_BIT, ", handle"), (ADDRESS_BIT, ", address")) if byte & bit]
    size = "text up to a zero" if encoding.width is None else f"{counted(encoding.width, 'byte')} after it"
    more = "".join([which.get((is_variable, bool(byte & GLOBAL_BIT)), ""), *marks, f", {size}"])
    return f"{_bits(byte, 1, 1, 1, 1, 1, _SIZE_BITS)}, long {kind}{more} ({encoding})"


def _bits(byte: int, *groups: int) -> str:
    """Returns the bits of a byte in groups."""
    digits = iter(f"{byte:08b}")
    return " ".join("".join(next(digits) for _ in range(group)) for group in groups)
