"""A message as an indented tree: header, operations, arguments with their encodings and meanings."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.dialogue import Exchange, Transfer
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
from ev3proto.schema.header import HEADER_SIZE, MEMORY_SIZE
from ev3proto.semantics.readings import datasets_of
from ev3proto.semantics.replies import field_values, guesses
from ev3proto.tables.daisy import TEXTS as DAISY_TEXTS
from ev3proto.tables.daisy import DaisySubCommand
from ev3proto.tables.encoding import CONSTANT, ENCODINGS, STRING_CODING, TEXT
from ev3proto.tables.system import SYSTEM_BY_NUMBER, status_meaning
from ev3proto.text.phrases import (
    Seen,
    argument_meaning,
    argument_value,
    field_texts,
    heading,
    plain,
    spaced_hex,
    value_text,
)
from ev3proto.text.spans import Line, Role

_MOST_REST = 32


def tree(exchange: Exchange, seen: Seen) -> Iterator[Line]:
    """Yields the lines of one message."""
    message = exchange.message
    size = len(message.build() if seen.frame is None else seen.frame)
    yield Line(heading(exchange, seen), 0, size)
    match message:
        case DirectCommand():
            if message.global_size or message.local_size:
                sizes = f"{message.global_size} bytes global, {message.local_size} bytes local"
                yield Line([(f"  memory: {sizes}", Role.ASIDE)], HEADER_SIZE, MEMORY_SIZE)
            for operation in message.operations:
                yield from operation_lines(operation, seen.unknown)
        case DirectReply():
            yield from _values(exchange)
        case SystemCommand() | SystemReply():
            yield from _system(message, exchange.transfer, seen.unknown)
        case DaisyCommand() | DaisyReply() if not message.flaw.headless:
            yield from _daisy(message)
    yield from _fault(message, size, seen.missing)


def operation_lines(operation: Operation, unknown: frozenset[int] = frozenset()) -> list[Line]:
    """Yields the lines of one operation: its name, and each argument with its encoding and meaning."""
    name = operation.full_name
    spans = [
        (f"  {operation.offset:4}  ", Role.ASIDE),
        (name, Role.OPERATION),
        (f"  {operation.declaration.text}", Role.ASIDE),
    ]
    lines = [Line(spans, operation.offset, operation.length, target=name)]
    cmd = operation.cmd if operation.is_complete else None
    if cmd is not None and cmd.length > 1:
        spans = [(f"  {cmd.offset:4}    CMD = {cmd.value}", Role.PLAIN), (f"  {cmd.encoding}", Role.ASIDE)]
        lines.append(Line(spans, cmd.offset, cmd.length))
    arguments = operation.arguments
    width = max([len(argument.name) for argument in arguments], default=0)
    datasets = datasets_of(operation)
    for number, argument in enumerate(arguments):
        parameter, offset = argument.parameter, argument.offset
        meaning = argument_meaning(argument)
        dataset = datasets.get(number)
        if unknown and not unknown.isdisjoint(range(offset, offset + argument.length)):
            value, meaning = "?", ""
        else:
            value = argument_value(argument)
        spans = [
            (f"  {str(offset).rjust(4)}    ", Role.ASIDE),  # in half the time of {offset:4}
            (parameter.name.ljust(width), Role.NAME),
            (" = ", Role.PLAIN),
            (value, Role.VALUE),
            (f" {meaning}" if meaning else "", Role.MEANING),
            (f"  {_encoding(argument)}: {parameter.text if dataset is None else dataset}", Role.ASIDE),
        ]
        lines.append(Line(spans, offset, argument.length))
    return lines


def _encoding(argument: Argument) -> str:
    form = argument.form
    # -14 is the byte 32, which may be meant as 50.
    is_small = argument.length == 1 and form.kind == CONSTANT and int(argument.value) < 0
    return f"{form.name} 0x{argument.raw[0]:02X}" if is_small else form.name


def _values(exchange: Exchange) -> Iterator[Line]:
    message = exchange.message
    assert isinstance(message, DirectReply)
    for value in exchange.values:
        spans = [
            (f"  {value.offset:4}  ", Role.ASIDE),
            (value.full_name, Role.OPERATION),
            (f" {value.name}", Role.NAME),
            (" = ", Role.PLAIN),
            (value_text(value), Role.VALUE),
            (f"  {value.type}" + (f": {value.quantity}" if value.quantity else ""), Role.ASIDE),
        ]
        yield Line(spans, value.offset, value.length, target=value.full_name)
    if message.memory and not exchange.values:
        shown = f"  {HEADER_SIZE:4}  global memory: {spaced_hex(message.memory)}"
        meaning = " or ".join(f"{kind} {plain(guess)}" for kind, guess in guesses(message.memory).items())
        spans = [(shown, Role.PLAIN), (f"  {meaning}" if meaning else "", Role.MEANING)]
        yield Line(spans, HEADER_SIZE, len(message.memory))


def _system(message: SystemCommand | SystemReply, transfer: Transfer | None, unknown: frozenset[int]) -> Iterator[Line]:
    entry = SYSTEM_BY_NUMBER.get(message.number)
    if entry is not None and isinstance(message, SystemCommand):
        yield Line([(f"        {entry.text}", Role.ASIDE)])
    if isinstance(message, SystemReply) and (meaning := status_meaning(message.number, message.status_code)):
        yield Line([(f"        {meaning}", Role.MEANING)])
    width = max(map(len, message.fields), default=0)
    for (name, value, meaning), found in zip(field_texts(message), field_values(message), strict=True):
        spans = [
            ("        ", Role.PLAIN),
            (name.ljust(width), Role.NAME),
            (" = ", Role.PLAIN),
            (value if unknown.isdisjoint(range(found.offset, found.offset + found.length)) else "?", Role.VALUE),
            (f"  {meaning}" if meaning else "", Role.MEANING),
        ]
        yield Line(spans, found.offset, found.length)
    if transfer is not None and transfer.path:
        of = "an unknown number of" if transfer.size is None else str(transfer.size)
        progress = f"{transfer.transferred} of {of} bytes"
        yield Line([("        ", Role.PLAIN), (f"{plain(transfer.path)}: {progress}", Role.MEANING)])


def _daisy(message: DaisyCommand | DaisyReply) -> Iterator[Line]:
    if isinstance(message, DaisyCommand) and message.command is not None:
        yield Line([(f"        {DAISY_TEXTS[DaisySubCommand[message.command]]}", Role.ASIDE)])
    yield Line([(f"        from layer {message.layer_from} to layer {message.layer_to}", Role.PLAIN)])
    if isinstance(message, DaisyCommand) and message.operations:
        for operation in message.operations:
            yield from operation_lines(operation)
    elif isinstance(message, DaisyReply) and message.report is not None:
        report = message.report
        said = f"layer {report.layer} port {report.port}: type {report.type} mode {report.mode} status {report.status}"
        yield Line([(f"        {said}", Role.VALUE)])
        yield Line([(f"        data {plain(report.data)}", Role.PLAIN)])
    elif message.payload:
        yield Line([(f"        payload {plain(message.payload)}", Role.PLAIN)])


def _fault(message: Message, size: int, missing: int) -> Iterator[Line]:
    fault = own_fault(message, missing)
    if message.rest:
        shown = spaced_hex(message.rest[:_MOST_REST]) + (" ..." if len(message.rest) > _MOST_REST else "")
        spans = [("        not read: ", Role.ASIDE), (shown, Role.PLAIN), (_letters(message.rest), Role.MEANING)]
        yield Line(spans, size - len(message.rest), len(message.rest))
    if fault is not None:
        yield Line([(f"  fault at {fault}", Role.FAULT)], fault.offset, 1)


def _letters(rest: bytes) -> str:
    """Returns the text in bytes that start like a string, for arguments that are cut in the middle."""
    encoding = ENCODINGS[rest[0]]
    text = rest[1:].split(b"\0", 1)[0].decode(STRING_CODING)
    return f'  "{text}..."' if encoding and encoding.kind == TEXT and text.isprintable() and text else ""
