r"""Frames in the notations of other programs: hex as the lessons write it, a C array, a Python byte string.

All of them can be pasted into `ev3proto decode` again.
"""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.dialogue import Exchange
from ev3proto.messages import (
    Argument,
    DaisyCommand,
    DaisyReply,
    DirectCommand,
    Message,
    Operation,
    SystemCommand,
    SystemReply,
)
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE
from ev3proto.semantics.replies import field_values
from ev3proto.tables.frame import LENGTH_FIELD
from ev3proto.text.phrases import ORPHANED, ORPHANED_ERROR, Seen, argument_value, field_texts, heading
from ev3proto.text.spans import plain_text

_BYTES_A_LINE = 12
_MOST_COMMENT = 100
_TAILS = {"direct-reply": "global memory", "daisy-command": "payload", "daisy-reply": "payload"}


def as_hex(message: Message) -> str:
    """Returns length, counter, type, memory and the rest: `0x|0E:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|`."""
    frame = message.build()
    ends = [LENGTH_FIELD, 2 * LENGTH_FIELD, HEADER_SIZE]
    if isinstance(message, DirectCommand):
        ends.append(COMMAND_HEADER_SIZE)
    groups = [frame[start:end] for start, end in zip([0, *ends], [*ends, len(frame)], strict=True)]
    return "".join(["0x|", *(f"{group.hex(':').upper()}|" for group in groups if group)])


def as_python(message: Message, name: str = "frame") -> str:
    r"""Returns `frame = b'\x0e\x00*\x00...'` with a comment above it."""
    return f"# {_heading(message)}\n{name} = {message.build()!r}"


def as_c(message: Message, name: str = "frame") -> str:
    """Returns an array of bytes, each line with a comment on its meaning. It compiles as C99 and as C++."""
    frame = message.build()
    lines = [f"/* {_comment(_heading(message))} */", f"const unsigned char {name}[{len(frame)}] = {{"]
    rows = [row for data, text in _parts(message) for row in _rows(data, text)]
    width = max((len(code) for code, _ in rows), default=0)
    lines += [f"    {code.ljust(width)}  /* {text} */" if text else f"    {code}" for code, text in rows]
    return "\n".join([*lines, "};"])


def _rows(data: bytes, text: str) -> Iterator[tuple[str, str]]:
    """Yields the lines of a part; the comment is in the first."""
    for start in range(0, len(data), _BYTES_A_LINE):
        code = " ".join(f"0x{byte:02X}," for byte in data[start : start + _BYTES_A_LINE])
        yield code, _comment(text) if start == 0 else ""


def _comment(text: str) -> str:
    """Returns a text that is safe in a comment of C."""
    short = text if len(text) <= _MOST_COMMENT else f"{text[:_MOST_COMMENT]}..."
    # Compilers warn about a comment in a comment, and about trigraphs: two question marks and a character.
    return short.replace("*/", "* /").replace("/*", "/ *").replace("??", "? ?")


def _heading(message: Message) -> str:
    return plain_text(heading(Exchange(message), Seen())).removesuffix(ORPHANED).removesuffix(ORPHANED_ERROR)


def _parts(message: Message) -> Iterator[tuple[bytes, str]]:
    """Yields a message's frame in its parts, in order."""
    frame = message.build()
    if message.type is None:
        yield frame, "no EV3 message"
        return
    yield frame[:LENGTH_FIELD], f"length {message.length}"
    yield frame[LENGTH_FIELD : 2 * LENGTH_FIELD], f"counter {message.counter}"
    yield frame[2 * LENGTH_FIELD : HEADER_SIZE], message.type.name
    at = HEADER_SIZE
    for size, text in () if message.flaw.headless else _body(message):
        yield frame[at : at + size], text
        at += size
    end = len(frame) - len(message.rest)
    yield frame[at:end], _TAILS.get(message.kind, "")
    yield frame[end:], "not read"


def _body(message: Message) -> Iterator[tuple[int, str]]:
    """Yields what follows the message type: bytes and their meaning; the last part may be omitted."""
    match message:
        case DirectCommand():
            memory = f"{message.global_size} bytes of global memory, {message.local_size} of local"
            yield COMMAND_HEADER_SIZE - HEADER_SIZE, memory
        case SystemCommand() | SystemReply():
            yield 1, message.command or "no system command"
            if isinstance(message, SystemReply):
                yield 1, f"status {message.status_code if message.status is None else message.status.name}"
            yield from _fields(message)
        case DaisyCommand():
            yield 1, message.command or "no daisy command"
            yield 2, f"from layer {message.layer_from} to layer {message.layer_to}"
        case DaisyReply():
            yield 2, f"from layer {message.layer_from} to layer {message.layer_to}"
    yield from ((operation.length, _told(operation)) for operation in getattr(message, "operations", ()))


def _fields(message: SystemCommand | SystemReply) -> Iterator[tuple[int, str]]:
    for (name, text, meaning), value in zip(field_texts(message), field_values(message), strict=True):
        yield value.length, f"{name} {text} ({meaning})" if meaning else f"{name} {text}"


def _told(operation: Operation) -> str:
    """Returns `SOUND.TONE: VOLUME 1 %, FREQUENCY 440 Hz, DURATION 1000 ms`."""
    arguments = ", ".join(f"{argument.name} {_value(argument)}" for argument in operation.arguments)
    return f"{operation.full_name}: {arguments}" if arguments else operation.full_name


def _value(argument: Argument) -> str:
    if argument.symbol is not None:
        return argument.symbol
    value, unit = argument_value(argument), argument.parameter.unit
    return f"{value} {unit}" if unit and not argument.is_variable and not isinstance(argument.value, str) else value
