"""Phrases of one line: a value with its unit and name, the heading of a message, a dialogue."""

from __future__ import annotations

import json
import math
import struct
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from ev3proto.dialogue import Exchange, Value, ValueType
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
    own_fault,
)
from ev3proto.schema.frame import parse
from ev3proto.tables.encoding import GLOBAL, LOCAL, TEXT
from ev3proto.tables.frame import LENGTH_FIELD
from ev3proto.tables.mailboxes import Reading
from ev3proto.tables.system import status_meaning
from ev3proto.text.spans import Role, Spans

_LETTERS = {LOCAL: "L", GLOBAL: "G"}
_encode = json.JSONEncoder(ensure_ascii=False).encode
_SINGLE = struct.Struct("<f")


def short_float(value: float) -> str:
    """Returns a single-precision float in as few digits as identify it: `7.92`, not `7.920000076293945`."""
    if not math.isfinite(value):
        return str(value)
    single = _SINGLE.pack(value)
    # Six digits always survive the way through a single, so fewer need not be tried: trailing zeros are dropped.
    for digits in range(6, 10):
        text = f"{value:.{digits}g}"
        try:
            if _SINGLE.pack(float(text)) == single:
                break
        except OverflowError:
            continue
    number = float(text)
    return repr(int(number)) + ".0" if number.is_integer() and abs(number) < 1e7 else repr(number)


def quoted(text: str) -> str:
    """Returns a text in double quotes, with control characters escaped and letters of every language unchanged."""
    return _encode(text)


def spaced_hex(data: bytes) -> str:
    """Returns `0E 00 2A`."""
    return data.hex(" ").upper()


def plain(value: ValueType) -> str:
    """Returns a bare value: number, quoted text, list in brackets, bytes as hex (cut if long, with their count)."""
    if type(value) is int:
        return str(value)
    if isinstance(value, str):
        return quoted(value)
    if isinstance(value, float):
        return short_float(value)
    if isinstance(value, bytes):
        return spaced_hex(value) if len(value) <= 24 else f"{spaced_hex(value[:24])} ... ({len(value)} bytes)"
    if isinstance(value, list):
        return f"[{', '.join(plain(item) for item in value)}]"
    return str(value)


def reading_text(value: Reading) -> str:
    """Returns a reading of a mailbox's message: `"hi"`, `1.5`, `true`."""
    return str(value).lower() if isinstance(value, bool) else plain(value)


def field_texts(message: SystemCommand | SystemReply) -> Iterator[tuple[str, str, str]]:
    """Yields each field of a system message: its name, its value, and the meaning of a mailbox's message.

    The meaning names each reading that fits: `logic false or text ""`.
    """
    found = message.readings if isinstance(message, SystemCommand) else {}
    meaning = " or ".join(f"{kind} {reading_text(value)}" for kind, value in found.items())
    for name, value in message.fields.items():
        yield name, plain(value), meaning if isinstance(value, bytes) else ""


def command_name(message: SystemCommand | SystemReply | DaisyCommand) -> str:
    """Returns the name of the command, its number in hex, or `no command` for a frame that ends before it."""
    return "no command" if message.flaw.headless else message.command or f"0x{message.number:02X}"


def lacks_status(message: Message) -> bool:
    """Returns whether a frame is a system reply that ends before the status."""
    return message.flaw.headless and isinstance(message, SystemReply)


def status_name(message: SystemReply) -> str:
    """Returns `SUCCESS`, `status 99` for a status without a name, or `no status` for a frame that ends before it."""
    if lacks_status(message):
        return "no status"
    return f"status {message.status_code}" if message.status is None else message.status.name


def refusal_meaning(message: SystemReply) -> str:
    """Returns what the status of a failed command means, ` (the file is open)`; empty where nothing is known."""
    meaning = status_meaning(message.number, message.status_code) if message.is_error else None
    return f" ({meaning})" if meaning else ""


def argument_value(argument: Argument) -> str:
    """Returns an argument's value: `440`, `"myEV3"`, `GV(0)`, with handle and address marked."""
    form, text = argument.form, plain(argument.value)
    if form.kind in _LETTERS:
        text = f"{_LETTERS[form.kind]}V({text})"
    if form.handle:
        text = f"handle {text}"
    return f"address {text}" if form.address else text


def argument_meaning(argument: Argument) -> str:
    """Returns what the tables know about a constant: its name in the enumeration, its special meaning, or its unit."""
    parameter, value = argument.parameter, argument.value
    if argument.form.kind in (LOCAL, GLOBAL, TEXT):
        return ""
    symbol = argument.symbol
    if symbol is not None:
        return symbol
    if parameter.special and isinstance(value, int) and value in parameter.special:
        return parameter.special[value]
    return parameter.unit or ""


def value_text(value: Value) -> str:
    """Returns a value from a reply: `7.92 V`, `16 (TYPE_TOUCH)`, `-128 (not a number: no value)`."""
    if value.is_nan:
        return f"{plain(value.value)} (not a number: no value)"
    text = plain(value.value)
    if isinstance(value.symbol, list):
        return f"{text} ({', '.join(name or '?' for name in value.symbol)})"
    if value.symbol is not None:
        return f"{text} ({value.symbol})"
    return f"{text} {value.unit}" if value.unit else text


class Seen(NamedTuple):
    """The circumstances in which a message was seen."""

    direction: str | None = None  # `sent` or `received`, as the computer sees it
    time: str | None = None  # as written in a log, or seconds since the capture began
    missing: int = 0  # number of bytes at its end that the text or the capture left out
    packets: tuple[int, ...] = ()  # the packets of a capture that carried it
    place: str | None = None  # carrier and brick
    answers: int | None = None  # for a reply: the packet of its command
    latency: float | None = None  # for a reply: seconds since then
    frame: bytes | None = None  # the message's bytes if available, which saves building them
    unknown: frozenset[int] = frozenset()  # the offsets of bytes that a text did not give, and which were read as zero
    label: str = ""  # what a text names beside the direction, such as `leader` or `COM3`


def origin(seen: Seen) -> Spans:
    """Returns the text in front of a message: `0.011558 #12 usb 1.7 sent `."""
    line: Spans = []
    if seen.time:
        line.append((f"{seen.time} ", Role.ASIDE))
    if seen.packets:
        line.append((f"{packets_text(seen.packets)} ", Role.ASIDE))
    if seen.place:
        line.append((f"{seen.place} ", Role.PLAIN))
    if seen.direction:
        line.append((f"{seen.direction} ", Role.ASIDE))
    return line


def packets_text(numbers: tuple[int, ...]) -> str:
    """Returns the packets of a capture: `#12`, `#12+13`."""
    return f"#{numbers[0]}" if len(numbers) == 1 else f"#{'+'.join(map(str, numbers))}"


def heading(exchange: Exchange, seen: Seen) -> Spans:
    """Returns `09:12:31.011558 sent DIRECT_COMMAND_REPLY, counter 42, 16 bytes`; replies add command and result."""
    message = exchange.message
    line = origin(seen)
    size = len(message.build() if seen.frame is None else seen.frame)
    if message.type is None:
        line.append((f"no EV3 message, {counted(size, 'byte')}", Role.HEADING))
    else:
        line.append((message.type.name, Role.HEADING))
        counter = "?" if seen.unknown & {LENGTH_FIELD, LENGTH_FIELD + 1} else message.counter
        line.append((f", counter {counter}, {counted(size, 'byte')}", Role.PLAIN))
    if seen.missing and message.stated_length is not None:
        source = "capture" if seen.packets else "text"
        line.append((f" of {size + seen.missing}: the {source} is cut here", Role.MEANING))
    line += _what(exchange)
    if seen.latency is not None:
        line.append((f" ({seen.latency * 1000:.3f} ms after #{seen.answers})", Role.ASIDE))
    return line


def _what(exchange: Exchange) -> Spans:
    message = exchange.message
    line = _command_and_status(message)
    if exchange.is_orphan:
        is_refused = isinstance(message, DirectReply) and message.type is not None and message.type.is_error
        line.append((ORPHANED_ERROR if is_refused else ORPHANED, Role.ASIDE))
    return line


def _command_and_status(message: Message) -> Spans:
    if lacks_status(message):
        return [(": no status", Role.FAULT)]
    if isinstance(message, SystemCommand | SystemReply | DaisyCommand):
        line: Spans = [(": ", Role.PLAIN), (command_name(message), Role.OPERATION)]
        if isinstance(message, SystemReply):
            line.append((f" {status_name(message)}", Role.FAULT if message.is_error else Role.VALUE))
        return line
    if isinstance(message, DirectReply | DaisyReply) and message.type is not None:
        return [(": error", Role.FAULT) if message.type.is_error else (": ok", Role.VALUE)]
    return []


ORPHANED = " (the command it answers was not seen)"
ORPHANED_ERROR = f"{ORPHANED[:-1]}: check that one to find the fault)"
"""A reply does not say why the brick refused the command; `check` does."""

_MOST_OPERATIONS = 8
_MOST_VALUES = 16
_MOST_TEXT = 60


def _after(message: Message, missing: int) -> Spans:
    """Returns the fault of a message, or that its last bytes are missing here."""
    fault = own_fault(message, missing)
    if fault is not None:
        return [(f" (fault at {fault})", Role.FAULT)]
    return [(f" (the last {counted(missing, 'byte')} are missing)", Role.MEANING)] if missing else []


def command_spans(message: Message, missing: int = 0) -> Spans:
    """Returns what a command asks for: its operations with their arguments, or its fields; and what is wrong with it.

    `missing`: the number of bytes at its end that the text or the capture left out.
    """
    line: Spans = []
    if isinstance(message, DirectCommand):
        line += _operations(message.operations) if message.operations else [("no operations", Role.ASIDE)]
    elif isinstance(message, SystemCommand):
        line.append((command_name(message), Role.OPERATION))
        line += _fields(message)
    elif isinstance(message, DaisyCommand):
        line.append((command_name(message), Role.OPERATION))
        line.append((f" from layer {message.layer_from} to layer {message.layer_to}", Role.PLAIN))
        if message.operations:
            line += [(": ", Role.PLAIN), *_operations(message.operations)]
    else:
        line.append(("no EV3 message" if message.type is None else message.type.name, Role.OPERATION))
    return line + _after(message, missing)


def reply_spans(exchange: Exchange, missing: int = 0) -> Spans:
    """Returns what a reply says: its values, or whether the command succeeded. `missing` as for commands."""
    fault = own_fault(exchange.message, missing)
    if fault is not None:
        return [(f"fault at {fault}", Role.FAULT)]
    return _result(exchange) + _after(exchange.message, missing)


def _result(exchange: Exchange) -> Spans:
    message = exchange.message
    if message.type is not None and message.type.is_command:
        return [("fault: the request came back in place of a reply", Role.FAULT)]
    if isinstance(message, SystemReply):
        said: Spans = [(why, Role.MEANING)] if (why := refusal_meaning(message)) else []
        return [(status_name(message), Role.FAULT if message.is_error else Role.VALUE), *_fields(message), *said]
    if message.type is not None and message.type.is_error:
        reason = _refusal(exchange.request)
        return [("error", Role.FAULT), *([(f" ({reason})", Role.MEANING)] if reason else [])]
    return _first_values(exchange.values) if exchange.values else [("ok", Role.VALUE)]


def _first_values(values: Sequence[Value]) -> Spans:
    """Returns the first values, and the number of the others."""
    line: Spans = []
    for number, value in enumerate(values[:_MOST_VALUES]):
        line += [(", ", Role.PLAIN)] if number else []
        line += _value(value)
    if len(values) > _MOST_VALUES:
        line.append((f" and {len(values) - _MOST_VALUES} more", Role.ASIDE))
    return line


def _refusal(command: Message | None) -> str | None:
    """Returns why the brick refused a command, as a check says it; None if a check knows no reason."""
    if not isinstance(command, DirectCommand) or command.fault is not None:
        return None
    from ev3proto.checking.checking import check  # 15 ms, and few replies are errors

    report = check(command)
    if report.accepted or parse(report.frame, strict=False).fault is not None:
        return None  # it failed while running, or other firmware knows more operations
    errors = sorted(report.errors, key=lambda finding: finding.offset != report.rejected_at)
    return f"{errors[0].code}: {errors[0].message}" if errors else None


def dialogue_line(
    command: Message | None,
    reply: Exchange | None,
    latency: float | None,
    *,
    of_command: int = 0,
    of_reply: int = 0,
) -> Spans:
    """Returns a command and its reply, either of which may be unknown, with the seconds between them.

    `of_command` and `of_reply` are the numbers of bytes at their ends that the text or the capture left out.
    """
    unseen: Spans = [("(a command that was not seen)", Role.ASIDE)]
    line = unseen if command is None else command_spans(command, of_command)
    if reply is not None:
        line += [(" -> ", Role.PLAIN), *reply_spans(reply, of_reply)]
        if latency is not None:
            line.append((f"  {latency * 1000:.3f} ms", Role.ASIDE))
        if reply.note is not None:
            line.append((f"  ({reply.note.partition(':')[0]})", Role.ASIDE))
    elif command is not None and command.wants_reply:
        line.append((" -> no reply", Role.FAULT))
        line += _counter(command)
    if reply is not None and command is None:
        line += _counter(reply.message)
    return line


def _counter(message: Message) -> Spans:
    """Returns the counter of a command without a reply, or of a reply without a command."""
    return [] if message.type is None else [(f"  (counter {message.counter})", Role.ASIDE)]


def _operations(operations: tuple[Operation, ...]) -> Spans:
    line: Spans = []
    for number, operation in enumerate(operations[:_MOST_OPERATIONS]):
        line += [("; ", Role.PLAIN)] if number else []
        line += _operation(operation)
    if len(operations) > _MOST_OPERATIONS:
        line.append((f"; and {len(operations) - _MOST_OPERATIONS} more", Role.ASIDE))
    return line


def _operation(operation: Operation) -> Spans:
    line: Spans = [(operation.full_name, Role.OPERATION)]
    arguments = operation.arguments
    if not arguments:
        return line
    line.append(("(", Role.PLAIN))
    for number, argument in enumerate(arguments):
        line += [(", ", Role.PLAIN)] if number else []
        line += [(f"{argument.name}=", Role.NAME), (_argument(argument), Role.VALUE)]
    return [*line, (")", Role.PLAIN)]


def _argument(argument: Argument) -> str:
    return argument.symbol or short_text(argument_value(argument))


def _value(value: Value) -> Spans:
    return [(f"{value.name}=", Role.NAME), (short_text(value_text(value)), Role.VALUE)]


def _fields(message: SystemCommand | SystemReply) -> Spans:
    line: Spans = []
    for name, text, meaning in field_texts(message):
        line += [(f" {name}=", Role.NAME), (short_text(text), Role.VALUE)]
        if meaning:
            line.append((f" ({short_text(meaning)})", Role.MEANING))
    return line


def short_text(text: str) -> str:
    """Returns a text, or its beginning."""
    return text if len(text) <= _MOST_TEXT else f"{text[: _MOST_TEXT - 3]}..."


MACROS = "asm"
"""With the macro of every encoding, so that assembling it gives the same bytes."""

LEGO = "lego"
"""As in LEGO's sources."""

NOTATIONS = (MACROS, LEGO)
