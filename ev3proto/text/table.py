r"""The annotated table: the frame's bytes in groups, with a label above and the meaning below each group.

\ len \ cnt \ty\ hd  \op\cd\VOLUME\...
0x|0E:00|2A:00|80|00:00|94|01|01    |...
\ 14  \ 42  \no\ 0,0 \S \T \1     \...
\     \     \  \     \O \O \      \...
"""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.dialogue import Exchange
from ev3proto.messages import (
    DaisyCommand,
    DaisyReply,
    DirectCommand,
    DirectReply,
    Message,
    Operation,
    SystemCommand,
    SystemReply,
    own_fault,
)
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.text.phrases import Seen, argument_value, field_texts, heading, plain, value_text
from ev3proto.text.spans import Line, Role

_SHORT_TYPES = {
    "DIRECT_COMMAND_REPLY": "Re",
    "DIRECT_COMMAND_NO_REPLY": "no",
    "SYSTEM_COMMAND_REPLY": "Re",
    "SYSTEM_COMMAND_NO_REPLY": "no",
    "DAISY_COMMAND_REPLY": "Re",
    "DAISY_COMMAND_NO_REPLY": "no",
    "DIRECT_REPLY": "ok",
    "SYSTEM_REPLY": "ok",
    "DAISY_REPLY": "ok",
    "DIRECT_REPLY_ERROR": "er",
    "SYSTEM_REPLY_ERROR": "er",
    "DAISY_REPLY_ERROR": "er",
}

MOST_COLUMNS = 110
"""Width at which a table continues in a new band, and length at which a meaning is cut."""

_MOST_ROWS = 32
"""Maximum length of an argument's meaning that is written from top to bottom."""

_MOST_BYTES = 12
"""Maximum bytes shown in one cell."""


class Cell:
    """A group of bytes. Upright meanings are written from top to bottom, one letter a row, as names of opcodes are."""

    __slots__ = ("hex", "label", "rows", "width")

    def __init__(self, label: str, data: bytes, meaning: str = "", upright: bool = False) -> None:
        self.label = label  # the text above the bytes
        self.hex = data[:_MOST_BYTES].hex(":").upper()  # the bytes: `0E:00`
        if len(data) > _MOST_BYTES:
            self.hex += ":..."
        if len(meaning) > MOST_COLUMNS:
            meaning = meaning[:MOST_COLUMNS] + "..."
        self.width = max(len(self.hex), len(label), 0 if upright else len(meaning))  # columns it takes
        margin = " " * (self.width - 1)
        # what they say, row by row, as wide as the cell
        self.rows = [letter + margin for letter in meaning] if upright else [meaning.ljust(self.width)]


def table(exchange: Exchange, seen: Seen) -> Iterator[Line]:
    """Yields the lines of one message: a heading, then one or more bands of cells."""
    yield Line(heading(exchange, seen))
    message = exchange.message
    for number, band in enumerate(_bands(list(_cells(message)))):
        yield from _draw(band, first=number == 0)
    for value in exchange.values if isinstance(message, DirectReply) else ():
        spans = [(f"{value.full_name} {value.name} = {value_text(value)}", Role.VALUE)]
        yield Line(spans, value.offset, value.length, target=value.full_name)
    if isinstance(message, SystemCommand):
        for name, _, meaning in field_texts(message):
            if meaning:
                yield Line([(f"{message.command} {name} = {meaning}", Role.VALUE)])
    fault = own_fault(message, seen.missing)
    if fault is not None:
        yield Line([(f"fault at {fault}", Role.FAULT)], fault.offset, 1)


def _bands(cells: list[Cell]) -> Iterator[list[Cell]]:
    band: list[Cell] = []
    columns = 2
    for cell in cells:
        if band and columns + cell.width + 1 > MOST_COLUMNS:
            yield band
            band, columns = [], 2
        band.append(cell)
        columns += cell.width + 1
    if band:
        yield band


def _draw(cells: list[Cell], first: bool) -> list[Line]:
    rule = Line([("-" * (3 + sum([cell.width + 1 for cell in cells])), Role.ASIDE)])
    labels = "".join([f"{cell.label.ljust(cell.width)}\\" for cell in cells])
    digits = "".join([f"{cell.hex.ljust(cell.width)}|" for cell in cells])
    height = max([len(cell.rows) for cell in cells])
    columns = [cell.rows + [" " * cell.width] * (height - len(cell.rows)) for cell in cells]
    return [
        rule,
        Line([(f"  \\{labels}", Role.NAME)]),
        rule,
        Line([(f"{'0x' if first else '  '}|{digits}", Role.HEADING)]),
        rule,
        *[Line([("  \\" + "\\".join(pieces) + "\\", Role.VALUE)]) for pieces in zip(*columns, strict=True)],
        rule,
    ]


def _cells(message: Message) -> Iterator[Cell]:
    frame = message.build()
    if message.type is None:
        yield Cell("bytes", frame)
        return
    yield Cell("len", frame[:2], str(message.length))
    yield Cell("cnt", frame[2:4], str(message.counter))
    yield Cell("ty" if message.type.is_command else "rs", frame[4:5], _SHORT_TYPES[message.type.name])
    end = len(frame) - len(message.rest)
    if end > HEADER_SIZE:
        yield from _body(message, frame[:end])
    if message.rest:
        yield Cell("rest", message.rest)


def _body(message: Message, frame: bytes) -> Iterator[Cell]:
    """Yields the cells after the message type, as far as the frame could be read."""
    match message:
        case DirectCommand():
            yield Cell("hd", frame[5:7], f"{message.global_size},{message.local_size}")
            for operation in message.operations:
                yield from _operation(operation)
        case SystemCommand() | SystemReply():
            yield Cell("cd", frame[5:6], message.command or "?", upright=True)
            if isinstance(message, SystemReply):
                yield Cell("st", frame[6:7], getattr(message.status, "name", "?"), upright=True)
            yield from _fields(message, frame)
        case DirectReply():
            yield Cell("global memory", message.memory)
        case DaisyCommand():
            yield Cell("cd", frame[5:6], message.command or "?", upright=True)
            yield from _sent_on(message, frame[6:8])
        case DaisyReply():
            yield from _sent_on(message, frame[5:7])


def _sent_on(message: DaisyCommand | DaisyReply, layers: bytes) -> Iterator[Cell]:
    """Yields the layers of a daisy message, and its operations or other contents."""
    yield Cell("layers", layers, f"{message.layer_from} -> {message.layer_to}")
    if isinstance(message, DaisyCommand) and message.operations:
        for operation in message.operations:
            yield from _operation(operation)
    elif message.payload:
        yield Cell("payload", message.payload)


def _fields(message: SystemCommand | SystemReply, frame: bytes) -> Iterator[Cell]:
    """Yields the fields as one cell: their names and values below their bytes."""
    start = 7 if isinstance(message, SystemReply) else 6
    if frame[start:]:
        meaning = ", ".join(f"{name}={plain(value)}" for name, value in message.fields.items())
        yield Cell("fields", frame[start:], meaning)


def _operation(operation: Operation) -> Iterator[Cell]:
    yield Cell("op", operation.raw[:1], operation.name, upright=True)
    cmd = operation.cmd
    if cmd is not None:
        yield Cell("cd", cmd.raw, operation.command or "", upright=True)
    read = 1 + (cmd.length if cmd else 0)
    for argument in operation.arguments:
        raw, name = argument.raw, argument.name
        read += len(raw)
        meaning = argument.symbol or argument_value(argument)
        yield Cell(name, raw, meaning, upright=max(len(name), 3 * len(raw)) < len(meaning) <= _MOST_ROWS)
    if read < operation.length:
        yield Cell("rest", operation.raw[read:])
