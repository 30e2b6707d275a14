"""A message as an indented tree: header, operations, arguments with their encodings, and what each of them means."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.dialogue import Exchange, Transfer
from ev3proto.messages import (
    NO_FLAW,
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
from ev3proto.schema.frame import command_head
from ev3proto.schema.header import COMMAND_HEADER_SIZE
from ev3proto.schema.identification import ENCODINGS
from ev3proto.schema.instructions import PADDING, InstructionSet
from ev3proto.schema.operation import OperationSchema
from ev3proto.tables.daisy import TEXTS as DAISY_TEXTS
from ev3proto.tables.daisy import DaisyCommand as DaisySubCommand
from ev3proto.tables.declaration import Parameter
from ev3proto.tables.encoding import STRING_CODING, TEXT
from ev3proto.tables.frame import MAX_FRAME
from ev3proto.tables.system import SYSTEM_BY_NUMBER
from ev3proto.text.heading import Seen, heading
from ev3proto.text.patterns import (
    LONG,
    SHORT_NUMBERS,
    ArgumentTexts,
    Around,
    CommandTexts,
    OperationTexts,
    Pattern,
)
from ev3proto.text.phrases import argument_meaning, argument_value, around_value, plain, spaced_hex, value_text
from ev3proto.text.spans import Line, Role, plain_text

_MOST_REST = 32

_OFFSETS = tuple(f"  {offset:4}  " for offset in range(MAX_FRAME + len(PADDING)))
"""What the line of an operation starts with, by its offset."""

_INDENTED = tuple(f"{text}  " for text in _OFFSETS)
"""What the line of an argument starts with, by its offset."""


def tree(exchange: Exchange, seen: Seen) -> Iterator[Line]:
    """The lines of one message."""
    yield heading(exchange, seen)
    message = exchange.message
    match message:
        case DirectCommand():
            if message.global_size or message.local_size:
                yield [(_memory(message.global_size, message.local_size), Role.ASIDE)]
            for operation in message.operations:
                yield from operation_lines(operation)
        case DirectReply():
            yield from _values(exchange)
        case SystemCommand() | SystemReply():
            yield from _system(message, exchange.transfer)
        case DaisyCommand() | DaisyReply():
            yield from _daisy(message)
    yield from _fault(message, seen.cut)


def tree_texts(exchange: Exchange, seen: Seen) -> list[str]:
    """The same lines as texts."""
    message = exchange.message
    if type(message) is not DirectCommand or message.flaw is not NO_FLAW:
        return [plain_text(line) for line in tree(exchange, seen)]
    texts = [plain_text(heading(exchange, seen))]
    if message.global_size or message.local_size:
        texts.append(_memory(message.global_size, message.local_size))
    _COMMANDS.add_all(texts, message)
    return texts


def command_texts(frame: bytes, origin: str, instructions: InstructionSet) -> list[str] | None:
    """The lines of a direct command without making a message of its frame: a capture is shown in half the time.

    Args:
        frame: From its length field to its last byte.
        origin: What stands before the message's type, with a blank at the end.
        instructions: The instruction set to read by.

    Returns:
        The lines that `tree_texts` gives. None for other messages, and for commands that are faulty or unusual.

    """
    head = command_head(frame)
    if head is None:
        return None
    kind, counter, global_size, local_size = head
    texts = [f"{origin}{kind._name_}, counter {counter}, {len(frame)} bytes"]
    if global_size or local_size:
        texts.append(_memory(global_size, local_size))
    return texts if _COMMANDS.add(texts, frame, COMMAND_HEADER_SIZE, instructions) else None


def _memory(global_size: int, local_size: int) -> str:
    return f"  memory: {global_size} bytes global, {local_size} bytes local"


class _TreeTexts(OperationTexts):
    """The lines of operations of one kind."""

    __slots__ = ("_arguments", "_start", "_title")

    def __init__(self, schema: OperationSchema, parameters: tuple[Parameter, ...]) -> None:
        declaration = schema.declaration
        self._start = schema.start
        self._title = f"{declaration.name.replace('.', ' ', 1)}  {declaration.text}"
        width = max((len(parameter.name) for parameter in parameters), default=0)

        def split(argument: Argument) -> Around:
            before, after = around_value(argument.form)
            meaning, aside = _after_value(argument)
            return f"{argument.name.ljust(width)} = {before}", f"{after}{meaning}{aside}".rstrip()

        self._arguments = [ArgumentTexts(parameter, Pattern(parameter, split), plain) for parameter in parameters]

    def add(self, texts: list[str], data: bytes, at: int) -> int:
        """Adds the lines of the operation at an offset."""
        texts.append(f"{_OFFSETS[at]}{self._title}")
        at += self._start
        for argument in self._arguments:
            first = data[at]
            if first < LONG:
                before, after = argument.short[first] or argument.of_short(first)
                texts.append(f"{_INDENTED[at]}{before}{SHORT_NUMBERS[first]}{after}")
                at += 1
                continue
            narrow = argument.narrow[first]
            if narrow is not None:
                numbers, before, after = narrow
                texts.append(f"{_INDENTED[at]}{before}{numbers[data[at + 1]]}{after}")
                at += 2
                continue
            start = at
            before, value, after, at = argument.read(data, at)
            texts.append(f"{_INDENTED[start]}{before}{value}{after}")
        return at


def operation_lines(operation: Operation) -> Iterator[Line]:
    """The lines of one operation: what it is, and each argument with its encoding and meaning."""
    line: Line = [(f"  {operation.offset:4}  ", Role.ASIDE), (operation.name, Role.OPERATION)]
    if operation.command:
        line.append((f" {operation.command}", Role.OPERATION))
    line.append((f"  {operation.declaration.text}", Role.ASIDE))
    yield line
    cmd = operation.cmd if operation.is_complete else None
    if cmd is not None and cmd.length > 1:
        yield [(f"  {cmd.offset:4}    CMD = {cmd.value}", Role.PLAIN), (f"  {cmd.encoding}", Role.ASIDE)]
    width = max((len(argument.name) for argument in operation.arguments), default=0)
    for argument in operation.arguments:
        yield _argument(argument, width)


_COMMANDS = CommandTexts(_TreeTexts, lambda operation: [plain_text(line) for line in operation_lines(operation)])


def _argument(argument: Argument, width: int) -> Line:
    parameter, _, _, offset, _ = argument
    line: Line = [
        (_INDENTED[offset] if offset < MAX_FRAME else f"  {offset}    ", Role.ASIDE),
        (parameter.name.ljust(width), Role.NAME),
        (" = ", Role.PLAIN),
        (argument_value(argument), Role.VALUE),
    ]
    meaning, aside = _after_value(argument)
    return [*line, (meaning, Role.MEANING), (aside, Role.ASIDE)]


def _after_value(argument: Argument) -> tuple[str, str]:
    meaning = argument_meaning(argument)
    return f" {meaning}" if meaning else "", f"  {argument.form.name}: {argument.parameter.text}"


def _values(exchange: Exchange) -> Iterator[Line]:
    message = exchange.message
    assert isinstance(message, DirectReply)
    for value in exchange.values:
        operation = f"{value.op} {value.command}" if value.command else value.op
        yield [
            (f"  {value.offset:4}  ", Role.ASIDE),
            (operation, Role.OPERATION),
            (f" {value.name}", Role.NAME),
            (" = ", Role.PLAIN),
            (value_text(value), Role.VALUE),
            (f"  {value.type}", Role.ASIDE),
        ]
    if message.memory and not exchange.values:
        yield [(f"     5  global memory: {spaced_hex(message.memory)}", Role.PLAIN)]


def _system(message: SystemCommand | SystemReply, transfer: Transfer | None) -> Iterator[Line]:
    entry = SYSTEM_BY_NUMBER.get(message.number)
    if entry is not None and isinstance(message, SystemCommand):
        yield [(f"        {entry.text}", Role.ASIDE)]
    width = max((len(name) for name in message.fields), default=0)
    for name, value in message.fields.items():
        yield [
            ("        ", Role.PLAIN),
            (name.ljust(width), Role.NAME),
            (" = ", Role.PLAIN),
            (plain(value), Role.VALUE),
        ]
    if transfer is not None and transfer.path:
        of = "an unknown number of" if transfer.size is None else str(transfer.size)
        progress = f"{transfer.transferred} of {of} bytes"
        yield [("        ", Role.PLAIN), (f"{plain(transfer.path)}: {progress}", Role.MEANING)]


def _daisy(message: DaisyCommand | DaisyReply) -> Iterator[Line]:
    if isinstance(message, DaisyCommand) and message.command is not None:
        yield [(f"        {DAISY_TEXTS[DaisySubCommand[message.command]]}", Role.ASIDE)]
    yield [(f"        from layer {message.layer_from} to layer {message.layer_to}", Role.PLAIN)]
    if isinstance(message, DaisyCommand) and message.operations:
        for operation in message.operations:
            yield from operation_lines(operation)
    elif isinstance(message, DaisyReply) and message.report is not None:
        report = message.report
        yield [
            (
                f"        layer {report.layer} port {report.port}: type {report.type} mode {report.mode}"
                f" status {report.status}",
                Role.VALUE,
            )
        ]
        yield [(f"        data {plain(report.data)}", Role.PLAIN)]
    elif message.payload:
        yield [(f"        payload {plain(message.payload)}", Role.PLAIN)]


def _fault(message: Message, cut: bool) -> Iterator[Line]:
    if message.fault is None:
        return
    if message.rest:
        shown = spaced_hex(message.rest[:_MOST_REST]) + (" ..." if len(message.rest) > _MOST_REST else "")
        yield [("        not read: ", Role.ASIDE), (shown, Role.PLAIN), (_letters(message.rest), Role.MEANING)]
    if not (cut and message.fault.truncated):
        yield [(f"  fault at {message.fault}", Role.FAULT)]


def _letters(rest: bytes) -> str:
    """The text in bytes that start like a string, for arguments that are cut in the middle."""
    encoding = ENCODINGS[rest[0]]
    text = rest[1:].split(b"\0", 1)[0].decode(STRING_CODING)
    return f'  "{text}..."' if encoding and encoding.kind == TEXT and text.isprintable() and text else ""
