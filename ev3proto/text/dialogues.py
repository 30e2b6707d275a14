"""A command and its reply on one line: what was asked, what came back, how long it took."""

from __future__ import annotations

from ev3proto.dialogue import Exchange, Value
from ev3proto.messages import (
    Argument,
    DaisyCommand,
    DirectCommand,
    Message,
    Operation,
    SystemCommand,
    SystemReply,
)
from ev3proto.tables.system import status_meaning
from ev3proto.text.phrases import argument_value, field_texts, value_text
from ev3proto.text.spans import Line, Role

_MOST_OPERATIONS = 8
_MOST_VALUES = 16
_MOST_TEXT = 60


def command_spans(message: Message) -> Line:
    """What a command asks for: its operations with their arguments, or its fields."""
    line: Line = []
    if isinstance(message, DirectCommand):
        line += _operations(message.operations) if message.operations else [("no operations", Role.ASIDE)]
    elif isinstance(message, SystemCommand):
        line.append((message.command or f"0x{message.number:02X}", Role.OPERATION))
        line += _fields(message)
    elif isinstance(message, DaisyCommand):
        line.append((message.command or f"0x{message.number:02X}", Role.OPERATION))
        line.append((f" from layer {message.layer_from} to layer {message.layer_to}", Role.PLAIN))
        if message.operations:
            line += [(": ", Role.PLAIN), *_operations(message.operations)]
    else:
        line.append(("no EV3 message" if message.type is None else message.type.name, Role.OPERATION))
    if message.fault is not None:
        line.append((f" (fault at {message.fault})", Role.FAULT))
    return line


def reply_spans(exchange: Exchange) -> Line:
    """What a reply says: its values, or how the command went."""
    message = exchange.message
    if message.fault is not None:
        return [(f"fault at {message.fault}", Role.FAULT)]
    if message.type is not None and message.type.is_command:
        return [("fault: the request came back in place of a reply", Role.FAULT)]
    if isinstance(message, SystemReply):
        status = message.status.name if message.status is not None else f"status {message.status_code}"
        meaning = status_meaning(message.number, message.status_code) if message.is_error else None
        said: Line = [(f" ({meaning})", Role.MEANING)] if meaning else []
        return [(status, Role.FAULT if message.is_error else Role.VALUE), *_fields(message), *said]
    if message.type is not None and message.type.is_error:
        return [("error", Role.FAULT)]
    if not exchange.values:
        return [("ok", Role.VALUE)]
    line: Line = []
    for number, value in enumerate(exchange.values[:_MOST_VALUES]):
        line += [(", ", Role.PLAIN)] if number else []
        line += _value(value)
    if len(exchange.values) > _MOST_VALUES:
        line.append((f" and {len(exchange.values) - _MOST_VALUES} more", Role.ASIDE))
    return line


def dialogue_line(command: Message | None, reply: Exchange | None, latency: float | None) -> Line:
    """A command and what came back.

    Args:
        command: None for a reply whose command was not seen.
        reply: None for a command that got none.
        latency: Seconds between them, None where nobody knows.
    """
    line: Line = [("(a command that was not seen)", Role.ASIDE)] if command is None else command_spans(command)
    if reply is not None:
        line += [(" -> ", Role.PLAIN), *reply_spans(reply)]
        if latency is not None:
            line.append((f"  {latency * 1000:.3f} ms", Role.ASIDE))
    elif command is not None and command.wants_reply:
        line.append((" -> no reply", Role.FAULT))
    return line


def _operations(operations: tuple[Operation, ...]) -> Line:
    line: Line = []
    for number, operation in enumerate(operations[:_MOST_OPERATIONS]):
        line += [("; ", Role.PLAIN)] if number else []
        line += _operation(operation)
    if len(operations) > _MOST_OPERATIONS:
        line.append((f"; and {len(operations) - _MOST_OPERATIONS} more", Role.ASIDE))
    return line


def _operation(operation: Operation) -> Line:
    line: Line = [(operation.full_name, Role.OPERATION)]
    arguments = operation.arguments
    if not arguments:
        return line
    line.append(("(", Role.PLAIN))
    for number, argument in enumerate(arguments):
        line += [(", ", Role.PLAIN)] if number else []
        line += [(f"{argument.name}=", Role.NAME), (_argument(argument), Role.VALUE)]
    return [*line, (")", Role.PLAIN)]


def _argument(argument: Argument) -> str:
    return argument.symbol or _short(argument_value(argument))


def _value(value: Value) -> Line:
    return [(f"{value.name}=", Role.NAME), (_short(value_text(value)), Role.VALUE)]


def _fields(message: SystemCommand | SystemReply) -> Line:
    line: Line = []
    for name, text, meaning in field_texts(message):
        line += [(f" {name}=", Role.NAME), (_short(text), Role.VALUE)]
        if meaning:
            line.append((f" ({_short(meaning)})", Role.MEANING))
    return line


def _short(text: str) -> str:
    return text if len(text) <= _MOST_TEXT else f"{text[: _MOST_TEXT - 3]}..."
