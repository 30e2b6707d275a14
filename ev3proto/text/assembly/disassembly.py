"""Messages and operations as assembly, in either notation, without losing any part of a frame.

The notation of the firmware's macros names every encoding: `opSOUND, LC0(TONE), LC0(1), LC2(440), LC2(1000)`. That of
LEGO's sources does not: in `SOUND(TONE,1,440,1000)` each value has the encoding that an assembler chooses. Any other
encoding is written as a macro, `LC2(1)`, and so are variables without a name. Programs are written by
`ev3proto.program.writing`, which has names for more.
"""

from __future__ import annotations

import json
import math
import struct
from bisect import bisect_left
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from decimal import Decimal
from functools import cache
from operator import itemgetter
from typing import NamedTuple

from ev3proto.dialogue import Exchange
from ev3proto.errors import BuildError
from ev3proto.messages import (
    Argument,
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
from ev3proto.schema.argument import LABEL_BYTE, ArgumentSchema
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.declaration import Enumeration, Type
from ev3proto.tables.encoding import BITS, CONSTANT, JUMP
from ev3proto.tables.enumerations import NUMBERS
from ev3proto.tables.frame import MAX_LENGTH
from ev3proto.tables.source import BYTES, ESCAPES
from ev3proto.tables.system import SYSTEM_BY_NUMBER
from ev3proto.text.assembly.notations import CUT, FRAME, MESSAGE, OF_FRAMES, STATUS, Rules, declared_name
from ev3proto.text.assembly.values import integer, measure
from ev3proto.text.phrases import LEGO, MACROS, quoted, short_float, spaced_hex

_BYTES_A_LINE = 32
_LABEL = "Label"
_NOT_A_FLOAT = "DATAF_NAN"

# Messages


def assembly(exchange: Exchange, heading: str, notation: str = MACROS) -> Iterator[str]:
    """Writes a message so that `ev3proto.text.assembly.assemble` makes the same frame of it, faulty or not.

    Args:
        exchange: The message, and what was said before it.
        heading: What the comment in front of it says.
        notation: How its operations are written, one of NOTATIONS.

    Yields:
        Its lines: the comment, its header, then an operation a line, or the command, or bytes.

    Raises:
        TypeError: It is not an Exchange.
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
        yield from _body(message, {MACROS: macro_lines, LEGO: lego_lines}[notation])
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


def _body(message: Message, notation: Callable[[Sequence[Operation]], Iterator[str]]) -> Iterator[str]:
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
    yield from f"{declared_name(entry)}({', '.join(values)})".split("\n")


def _field(value: FieldValue) -> str:
    if isinstance(value, str):
        return quoted(value)
    if isinstance(value, int):
        return str(value)
    lines = list(hex_lines(value))
    return f"{BYTES}({''.join(lines)})" if len(lines) < 2 else "\n".join((f"{BYTES}(", *lines)) + ")"


def _bytes(data: bytes) -> Iterator[str]:
    return (f"{BYTES} {line}" for line in hex_lines(data))


def hex_lines(data: bytes) -> Iterator[str]:
    """Writes bytes in hex, 32 a line."""
    return (spaced_hex(data[start : start + _BYTES_A_LINE]) for start in range(0, len(data), _BYTES_A_LINE))


# Operations in macros


def macro_lines(operations: Sequence[Operation]) -> Iterator[str]:
    """Writes the operations of one message, a line each."""
    return map(operation_line, operations)


def operation_line(operation: Operation) -> str:
    """Writes one operation with the macro of every encoding. One that is cut short ends in `...`.

    Raises:
        TypeError: It is not an Operation.
    """
    if not isinstance(operation, Operation):
        raise TypeError(f"a line is made of an Operation, not of {type(operation).__name__}")
    pieces = [f"op{operation.name}"]
    cmd = operation.cmd
    if cmd is not None:
        pieces.append(in_macro(cmd, operation.command or ""))
    pieces += map(_macro, operation.arguments)
    if not operation.is_complete:
        pieces.append(CUT)
    return ", ".join(pieces)


def in_macro(argument: Argument, value: str, macro: str | None = None) -> str:
    """Writes an argument as a macro, `HND(LV1(4))`; a jump that no macro makes as bytes."""
    if argument.kind == JUMP and argument.raw[0] != LABEL_BYTE:
        # The firmware looks at three bits of it only, so that several bytes mean a label.
        return f"{BYTES}({spaced_hex(argument.raw)})"
    text = f"{macro or argument.encoding}({value})"
    if argument.form.handle:
        text = f"HND({text})"
    return f"ADR({text})" if argument.form.address else text


def _macro(argument: Argument) -> str:
    """Writes an argument in the macro of its encoding. Of a float every bit counts."""
    value = argument.value
    if isinstance(value, str):
        return in_macro(argument, quoted(value))
    if isinstance(value, float):
        text = short_float(value)
        if struct.pack("<f", float(text)) == argument.raw[1:]:
            return in_macro(argument, text, "LCF")
        return in_macro(argument, f"0x{int.from_bytes(argument.raw[1:], 'little'):08X}")
    return in_macro(argument, _name(argument, value) or str(value))


def _name(argument: Argument, value: int) -> str | None:
    """Returns the firmware's name of a constant in the enumeration of its parameter."""
    enum = argument.parameter.enum
    return None if enum is None or argument.kind != CONSTANT else _symbols(enum).get(value)


@cache
def _symbols(enum: Enumeration) -> dict[int, str]:
    """Returns the first name of each number."""
    return {number: name for name, number in reversed(list(enum.members.items()))}


# Operations in LEGO's notation


class Labels(NamedTuple):
    """The labels of a code."""

    names: Mapping[int | None, str] = {}  # by the offset that is jumped to
    forms: Mapping[int, str] = {}  # by the offset of a jump: its encoding, where the assembler would choose another


NO_LABELS = Labels()


def goal_of(step: Operation) -> int | None:
    """Returns the offset that a jump leads to, None for all other operations."""
    parameters = step.declaration.parameters
    if not parameters or parameters[-1].type is not Type.LABEL or step.name == "LABEL" or not step.is_complete:
        return None
    argument = step.arguments[-1]
    if argument.kind not in (CONSTANT, JUMP) or argument.form.handle or argument.form.address:
        return None
    if argument.kind == JUMP and argument.raw[0] != LABEL_BYTE:
        return None
    return end_of(step) + int(argument.value)


def end_of(step: Operation) -> int:
    """Returns the offset after an operation."""
    return step.offset + step.length


class _Jump(NamedTuple):
    """A jump to a place that can have a label: its target, and the offset and encoding of its last argument."""

    goal: int
    start: int
    end: int
    encoding: str


def labels_of(steps: Iterable[Operation], places: Sequence[int], rules: Rules, prefix: str) -> Labels:
    """Names the places that jumps lead to, and finds the jumps whose encoding has to be written.

    `places` are the offsets that a label can be at, in ascending order.
    """
    jumps: dict[int, _Jump] = {}
    for step in steps:
        goal = goal_of(step)
        if goal is not None and _has(places, goal):
            argument, end = step.arguments[-1], end_of(step)
            jumps[step.offset] = _Jump(goal, end - argument.length, end, argument.encoding)
    goals = sorted({jump.goal for jump in jumps.values()})
    names: dict[int | None, str] = {offset: f"{prefix}{number}" for number, offset in enumerate(goals, 1)}
    forms = {offset: jump.encoding for offset, jump in jumps.items() if jump.encoding == "LAB1"}
    given, parts, numbers = _parts_of(jumps, goals, places[0] if places else 0)
    while True:
        sizes = given.copy()
        free = {numbers[offset]: parts[jump.goal] for offset, jump in jumps.items() if offset not in forms}
        measure(sizes, free, rules)
        wrong = [offset for offset, jump in jumps.items() if sizes[numbers[offset]] != jump.end - jump.start]
        if not wrong:
            return Labels(names, forms)
        forms |= {offset: jumps[offset].encoding for offset in wrong}


def _has(places: Sequence[int], offset: int) -> bool:
    found = bisect_left(places, offset)
    return found < len(places) and places[found] == offset


def _parts_of(
    jumps: Mapping[int, _Jump], goals: Iterable[int], at: int
) -> tuple[list[int], dict[int, int], dict[int, int]]:
    """Returns the sizes of a code's parts, and by offset which a goal precedes, and which is a jump's argument."""
    starts = ((jump.start, offset) for offset, jump in jumps.items())
    sizes: list[int] = []
    parts: dict[int, int] = {}
    numbers: dict[int, int] = {}
    for place, offset in sorted([*((goal, None) for goal in goals), *starts], key=itemgetter(0)):
        sizes.append(place - at)
        at = place
        if offset is None:
            parts[place] = len(sizes)
        else:
            numbers[offset] = len(sizes)
            at = jumps[offset].end
            sizes.append(at - place)
    return sizes, parts, numbers


def lego_lines(operations: Sequence[Operation]) -> Iterator[str]:
    """Writes the operations of one message, with a label at every place that they jump to."""
    labels, end = NO_LABELS, 0
    if operations and all(operation.is_complete for operation in operations):
        end = end_of(operations[-1])
        labels = labels_of(operations, [*(one.offset for one in operations), end], OF_FRAMES, _LABEL)
    writer = OperationWriter()
    for operation in operations:
        if operation.offset in labels.names:
            yield f"{labels.names[operation.offset]}:"
        yield writer.line(operation, labels)
    if end in labels.names:
        yield f"{labels.names[end]}:"


class OperationWriter:
    """Writes operations as statements."""

    separator = ","  # what is written between two values

    def __init__(self, rules: Rules = OF_FRAMES) -> None:
        self.rules = rules  # those of the assembler that is to read them

    def line(self, operation: Operation, labels: Labels = NO_LABELS) -> str:
        """Writes one operation. One that is cut short ends in `...`. Jumps to no label are written as numbers."""
        values: list[str] = []
        cmd = operation.cmd
        if cmd is not None:
            values.append(self.number(cmd, operation.command or ""))
        values += self.arguments(operation, labels)
        if not operation.is_complete:
            values.append(CUT)
        return f"{operation.name}({self.separator.join(values)})"

    def arguments(self, operation: Operation, labels: Labels) -> Iterable[str]:
        """Writes the arguments of an operation."""
        label = labels.names.get(goal_of(operation))
        if label is None:
            return map(self.argument, operation.arguments)
        form = labels.forms.get(operation.offset)
        jump = label if form is None else f"{form}({label})"
        return [*map(self.argument, operation.arguments[:-1]), jump]

    def number(self, argument: Argument, text: str) -> str:
        """Writes a whole number as its text, in the macro of its encoding where that is not the usual one."""
        usual = integer(int(argument.value), self.rules) if argument.kind == CONSTANT else None
        return text if usual == argument.raw else in_macro(argument, text)

    def argument(self, argument: Argument) -> str:
        """Writes one argument: as a plain value if that is encoded to the same bytes."""
        if argument.is_variable or argument.kind == JUMP:
            return _macro(argument)
        text, value = _text(argument)
        if _encoded(argument, value) == argument.raw:
            return text
        return in_macro(argument, text) if isinstance(value, str) else _macro(argument)


# Values


def _text(argument: Argument) -> tuple[str, int | float | str]:
    """Returns a constant as it is written, and the value that is read from that."""
    value, parameter = argument.value, argument.parameter
    if isinstance(value, str):
        return text_literal(value), value
    if isinstance(value, float):
        return float_literal(value), value
    if parameter.unsigned and value < 0:
        value += BITS[parameter.type][-1] + 1
    known = (name for name, number in parameter.names.items() if number == value)
    common = next((name for name in known if name in NUMBERS or name in CONSTANTS), None)
    return _name(argument, value) or common or str(value), value


def _encoded(argument: Argument, value: int | float | str) -> bytes:
    """Returns the bytes of a plain value as this argument; none if it cannot be one."""
    if argument.form.handle or argument.form.address:
        return b""
    try:
        return ArgumentSchema(argument.parameter).write(value)
    except BuildError:
        return b""


TEXT_ESCAPES = {character: escape for escape, character in ESCAPES}
_PLAIN = frozenset(map(chr, range(0x20, 0x7F))) - set("'\\")


def text_literal(text: str, escapes: Mapping[str, str] = TEXT_ESCAPES) -> str:
    """Writes a text in LEGO's quotes with its escapes; with other signs in double quotes, with the escapes of C.

    In single quotes, `'_x'` is a number in the sources of LEGO's programs.
    """
    if all(letter in _PLAIN or letter in escapes for letter in text) and not (len(text) == 2 and text[0] == "_"):
        return f"'{''.join(escapes.get(letter, letter) for letter in text)}'"
    return json.dumps(text, ensure_ascii=not text.isprintable())


def float_literal(value: float) -> str:
    """Writes a single as a literal that means the same bits: `1.5F`, `-0.0F`, never with a signed exponent."""
    if not math.isfinite(value):
        return _NOT_A_FLOAT if math.isnan(value) else str(value)
    text = short_float(value) if value else str(value)
    if "e" in text:
        text = format(Decimal(text), "f")
        text = text if "." in text else f"{text}.0"
    return f"{text}F"
