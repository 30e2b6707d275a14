"""What a message says as rows: one for each argument, value of a reply, field of a system message, and fault."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from ev3proto.dialogue import Exchange, Value
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
from ev3proto.semantics.replies import field_values
from ev3proto.text.phrases import argument_value, command_name, spaced_hex, status_name

_TYPE = HEADER_SIZE - 1

UNKNOWN = "?"
"""The value of bytes that a text does not give."""


class CsvRow(NamedTuple):
    """One thing that a message says.

    offset     of its first byte in the frame
    operation  the operation or system command that it belongs to, such as `SOUND.TONE`; empty if unknown
    name       of the parameter or field; `status`, `memory`, `payload`, `fault`, `missing`, `note`; else empty
    value      a number, or a text
    unit       of the number, such as `Hz`; empty if it has none
    """

    offset: int
    operation: str
    name: str
    value: float | str
    unit: str = ""


def rows(exchange: Exchange, unknown: frozenset[int] = frozenset(), missing: int = 0) -> Iterator[CsvRow]:
    """Yields what a message says, in the order of its bytes; at least one row.

    Args:
        exchange: The message with its facts from the dialogue.
        unknown: The offsets of bytes that a text does not give.
        missing: The number of bytes at its end that the text or the capture left out.
    """
    message = exchange.message
    is_empty = True
    for row in () if message.flaw.headless else _body(exchange, unknown):
        is_empty = False
        yield row
    fault = own_fault(message, missing)
    if fault is not None:
        yield CsvRow(fault.offset, "", "fault", fault.reason)
    elif missing:
        yield CsvRow(len(message.build()), "", "missing", missing, "bytes")
    elif is_empty:
        yield from _status(message)
    if exchange.note is not None:
        yield CsvRow(0, "", "note", exchange.note)


def _of(message: Message) -> str:
    return command_name(message) if isinstance(message, SystemCommand | SystemReply | DaisyCommand) else ""


def _body(exchange: Exchange, unknown: frozenset[int]) -> Iterator[CsvRow]:
    message = exchange.message
    match message:
        case DirectCommand():
            yield from _operations(message.operations, unknown)
        case DirectReply():
            if message.is_error:
                yield from _status(message)
            yield from _values(exchange.values)
            if message.memory and not exchange.values:
                yield CsvRow(HEADER_SIZE, "", "memory", spaced_hex(message.memory))
        case SystemCommand() | SystemReply():
            if isinstance(message, SystemReply) and message.status_code:
                yield from _status(message)
            yield from _values(field_values(message), unknown)
        case DaisyCommand() | DaisyReply():
            at, of = HEADER_SIZE + isinstance(message, DaisyCommand), _of(message)
            yield CsvRow(at, of, "layer_from", message.layer_from)
            yield CsvRow(at + 1, of, "layer_to", message.layer_to)
            if isinstance(message, DaisyCommand) and message.operations:
                yield from _operations(message.operations, unknown)
            elif message.payload:
                yield CsvRow(at + 2, of, "payload", spaced_hex(message.payload))


def _status(message: Message) -> Iterator[CsvRow]:
    """Yields whether a command succeeded; of a command that has no arguments, its name alone."""
    if isinstance(message, SystemReply):
        yield CsvRow(HEADER_SIZE + 1, command_name(message), "status", status_name(message))
    elif message.type is not None and not message.type.is_command:
        yield CsvRow(_TYPE, _of(message), "status", "error" if message.type.is_error else "ok")
    else:
        yield CsvRow(_TYPE, _of(message), "", "")


def _operations(operations: Iterable[Operation], unknown: frozenset[int]) -> Iterator[CsvRow]:
    for operation in operations:
        arguments = operation.arguments
        if not arguments:
            yield CsvRow(operation.offset, operation.full_name, "", "")
        for argument in arguments:
            is_plain = not (argument.is_variable or argument.form.handle or argument.form.address)
            value = argument.value if is_plain else argument_value(argument)
            if not unknown.isdisjoint(range(argument.offset, argument.offset + argument.length)):
                value = UNKNOWN
            unit = argument.parameter.unit or ""
            yield CsvRow(argument.offset, operation.full_name, argument.name, value, unit if is_plain else "")


def _values(values: Iterable[Value], unknown: frozenset[int] = frozenset()) -> Iterator[CsvRow]:
    for value in values:
        is_known = unknown.isdisjoint(range(value.offset, value.offset + value.length))
        yield CsvRow(value.offset, value.full_name, value.name, _cell(value) if is_known else UNKNOWN, value.unit or "")


def _cell(value: Value) -> float | str:
    """Returns a value as one number or text: nothing for NaN, several numbers with spaces between."""
    if value.is_nan:
        return ""
    if isinstance(value.value, bytes):
        return spaced_hex(value.value)
    return " ".join(map(str, value.value)) if isinstance(value.value, list) else value.value
