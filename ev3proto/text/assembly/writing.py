"""Operations in LEGO's notation, the one of its sources: `SOUND(TONE,1,440,1000)`.

It has no word for how a value is encoded: each is as an assembler encodes it. A value that is encoded otherwise is
written as a macro of the other notation, `LC2(1)`, and so are variables that have no name. So nothing is lost. Programs
are written by the same writer, `ev3proto.program.writing`, which knows names for more.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from ev3proto.errors import BuildError
from ev3proto.messages import Argument, Operation
from ev3proto.schema.argument import LABEL_BYTE, ArgumentSchema
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.declaration import Type
from ev3proto.tables.encoding import BITS, CONSTANT, JUMP
from ev3proto.tables.enumerations import NUMBERS
from ev3proto.text.assembly.macro_notation import float_pattern, in_macro
from ev3proto.text.assembly.notations import OF_FRAMES, Rules
from ev3proto.text.assembly.values import integer, measure
from ev3proto.text.assembly.words import CUT, LABEL, NOT_A_FLOAT
from ev3proto.text.phrases import short_float

_ESCAPES = {"'": "\\q", "\\": "\\\\", "\n": "\\n", "\r": "\\r", "\t": "\\t"}
_PLAIN = bytes(range(0x20, 0x7F)).decode() + bytes(range(0xA1, 0x100)).decode("latin-1").replace("\xad", "")


class Labels(NamedTuple):
    """The labels of a code.

    names  by the offset that is jumped to
    forms  by the offset of a jump: its encoding, where the assembler would choose another
    """

    names: Mapping[int | None, str] = {}
    forms: Mapping[int, str] = {}


NO_LABELS = Labels()


def goal_of(step: Operation) -> int | None:
    """The offset that a jump leads to, None for all other operations."""
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
    """The offset after an operation."""
    return step.offset + step.length


def labels_of(steps: Sequence[Operation], places: Iterable[int], rules: Rules, prefix: str) -> Labels:
    """Gives labels their names, and says of which jumps the encoding has to be written.

    Args:
        steps: Operations that follow each other.
        places: Offsets that a label can be at.
        rules: Those of the assembler that is to read them.
        prefix: What the names of labels start with.
    """
    known = set(places)
    jumps = {step.offset: step for step in steps if goal_of(step) in known}
    goals = sorted({goal for goal in map(goal_of, jumps.values()) if goal is not None})
    encodings = {offset: step.arguments[-1].encoding for offset, step in jumps.items()}
    forms = {offset: form for offset, form in encodings.items() if form == "LAB1"}
    while True:
        sizes: list[int] = []
        parts: dict[int | None, int] = {}
        numbers: dict[int, int] = {}
        for step in steps:
            parts[step.offset] = len(sizes)
            size = len(step.arguments[-1].raw) if step.offset in jumps else 0
            sizes += [step.length - size, size]
            numbers[step.offset] = len(sizes) - 1
        if steps:
            parts.setdefault(end_of(steps[-1]), len(sizes))
        wanted = list(sizes)
        free = {numbers[offset]: parts[goal_of(step)] for offset, step in jumps.items() if offset not in forms}
        measure(sizes, free, rules)
        wrong = [offset for offset in jumps if sizes[numbers[offset]] != wanted[numbers[offset]]]
        if not wrong:
            return Labels({offset: f"{prefix}{number}" for number, offset in enumerate(goals, 1)}, forms)
        forms |= {offset: encodings[offset] for offset in wrong}


def lego_lines(operations: Sequence[Operation]) -> Iterator[str]:
    """Writes the operations of one message, with a label at every place that they jump to.

    Args:
        operations: As they follow each other in a frame.

    Yields:
        A line for each operation and each label.
    """
    labels, end = NO_LABELS, 0
    if operations and all(operation.is_complete for operation in operations):
        end = end_of(operations[-1])
        labels = labels_of(operations, [*(one.offset for one in operations), end], OF_FRAMES, LABEL)
    writer = OperationWriter()
    for operation in operations:
        if operation.offset in labels.names:
            yield f"{labels.names[operation.offset]}:"
        yield writer.line(operation, labels)
    if end in labels.names:
        yield f"{labels.names[end]}:"


class OperationWriter:
    """Writes operations as statements.

    rules      those of the assembler that is to read them
    separator  what is written between two values
    """

    separator = ","

    def __init__(self, rules: Rules = OF_FRAMES) -> None:
        self.rules = rules

    def line(self, operation: Operation, labels: Labels = NO_LABELS) -> str:
        """One operation. One that is cut short ends in `...`. Jumps to no label are written as numbers."""
        values: list[str] = []
        cmd = operation.cmd
        if cmd is not None:
            values.append(self.number(cmd, operation.command or ""))
        values += self.arguments(operation, labels)
        if not operation.is_complete:
            values.append(CUT)
        return f"{operation.name}({self.separator.join(values)})"

    def arguments(self, operation: Operation, labels: Labels) -> Iterable[str]:
        """The arguments of an operation."""
        label = labels.names.get(goal_of(operation))
        if label is None:
            return map(self.argument, operation.arguments)
        form = labels.forms.get(operation.offset)
        jump = label if form is None else f"{form}({label})"
        return [*map(self.argument, operation.arguments[:-1]), jump]

    def number(self, argument: Argument, text: str) -> str:
        """A whole number as its text, in the macro of its encoding where that is not the usual one."""
        usual = integer(int(argument.value), self.rules) if argument.kind == CONSTANT else None
        return text if usual == argument.raw else in_macro(argument, text)

    def argument(self, argument: Argument) -> str:
        """One argument: as a plain value if that is encoded to the same bytes."""
        if argument.is_variable or argument.kind == JUMP:
            return in_macro(argument, str(argument.value))
        text, value = _text(argument)
        return text if _encoded(argument, value) == argument.raw else in_macro(argument, _in_its_encoding(argument))


# Values


def _text(argument: Argument) -> tuple[str, int | float | str]:
    """A constant as it is written, and the value that is read from that."""
    value = argument.value
    if isinstance(value, str):
        return _quoted(value), value
    if isinstance(value, float):
        if value != value:
            return NOT_A_FLOAT, value
        text = short_float(value).replace("e+", "e")
        return text if text.endswith("inf") else f"{text}F", float(text)
    parameter = argument.parameter
    if parameter.unsigned and value < 0:
        value += BITS[parameter.type][-1] + 1
    return _name(argument, value) or str(value), value


def _name(argument: Argument, value: int) -> str | None:
    """The firmware's name of a number, where there is one that every assembler knows."""
    parameter = argument.parameter
    if parameter.enum is not None:
        for name, number in parameter.enum.members.items():
            if number == value:
                return name
    known = (name for name, number in parameter.names.items() if number == value)
    return next((name for name in known if name in NUMBERS or name in CONSTANTS), None)


def _encoded(argument: Argument, value: int | float | str) -> bytes:
    """The bytes that a plain value gets as this argument; none where it cannot stand there."""
    if argument.form.handle or argument.form.address:
        return b""
    try:
        return ArgumentSchema(argument.parameter).write(value)
    except BuildError:
        return b""


def _in_its_encoding(argument: Argument) -> str:
    """What stands in the macro of a constant that is in an encoding of its own. Of a float every bit counts."""
    value = argument.value
    if isinstance(value, str):
        return _quoted(value)
    if isinstance(value, int):
        return _name(argument, value) or str(value)
    return float_pattern(argument)


def _quoted(text: str) -> str:
    """A text in LEGO's quotes, with its escapes; for all other control characters, their number in hex."""
    letters = (_ESCAPES.get(letter, letter if letter in _PLAIN else f"\\x{ord(letter):02x}") for letter in text)
    return f"'{''.join(letters)}'"
