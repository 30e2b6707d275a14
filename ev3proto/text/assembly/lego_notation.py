"""Operations in LEGO's notation, the one of its sources: `SOUND(TONE,1,440,1000)`.

It has no word for how a value is encoded: each is in its shortest encoding. A value that a frame has in another one is
written as a macro of the other notation, `LC2(1)`, and so are variables, which have no names here. So nothing is lost.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from ev3proto.errors import BuildError
from ev3proto.messages import Argument, Operation
from ev3proto.schema.argument import ArgumentSchema, encode_integer
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.declaration import Role
from ev3proto.tables.encoding import BITS, CONSTANT, JUMP
from ev3proto.tables.enumerations import NUMBERS
from ev3proto.text.assembly.macro_notation import float_pattern, in_macro
from ev3proto.text.assembly.words import CUT, LABEL, NOT_A_FLOAT
from ev3proto.text.phrases import short_float

_ESCAPES = {"'": "\\q", "\\": "\\\\", "\n": "\\n", "\r": "\\r", "\t": "\\t"}
_PLAIN = bytes(range(0x20, 0x7F)).decode() + bytes(range(0xA1, 0x100)).decode("latin-1").replace("\xad", "")


def lego_lines(operations: Sequence[Operation]) -> Iterator[str]:
    """Writes the operations of one message, with a label at every place that they jump to.

    Args:
        operations: As they follow each other in a frame.

    Yields:
        A line for each operation and each label.
    """
    labels = _labels(operations)
    for operation in operations:
        if operation.offset in labels:
            yield f"{labels[operation.offset]}:"
        yield lego_line(operation, labels)
    end = _end(operations[-1]) if operations else 0
    if end in labels:
        yield f"{labels[end]}:"


def lego_line(operation: Operation, labels: Mapping[int, str] | None = None) -> str:
    """Writes one operation. One that is cut short ends in `...`.

    Args:
        operation: The operation.
        labels: The name of each place that may be jumped to, by its offset. Other jumps are written as numbers.

    Returns:
        The line, without its end.
    """
    values = []
    cmd = operation.cmd
    if cmd is not None:
        name = operation.command or ""
        values.append(name if cmd.raw == encode_integer(int(cmd.value)) else in_macro(cmd, name))
    for argument in operation.arguments:
        target = (labels or {}).get(_target(operation, argument))
        if target is None:
            values.append(_value(argument))
        else:
            values.append(target if len(argument.raw) == 1 else f"{argument.encoding}({target})")
    if not operation.is_complete:
        values.append(CUT)
    return f"{operation.name}({','.join(values)})"


# Jumps


def _labels(operations: Sequence[Operation]) -> dict[int, str]:
    """The offsets that operations jump to, where one of them starts or the last one ends, with names in their order."""
    if not all(operation.is_complete for operation in operations):
        return {}
    places = {operation.offset for operation in operations}
    if operations:
        places.add(_end(operations[-1]))
    wanted = {_target(operation, argument) for operation in operations for argument in operation.arguments}
    return {place: f"{LABEL}{number}" for number, place in enumerate(sorted(wanted & places), 1)}


def _target(operation: Operation, argument: Argument) -> int:
    """The offset that an operation jumps to by an argument, -1 where that is no jump of a known length."""
    is_jump = argument.parameter.role is Role.JUMP and argument.kind == CONSTANT
    if not is_jump or not isinstance(argument.value, int) or argument.form.handle or argument.form.address:
        return -1
    return _end(operation) + argument.value


def _end(operation: Operation) -> int:
    return operation.offset + operation.length


# Values


def _value(argument: Argument) -> str:
    """An argument: as a plain value if that is encoded to the same bytes."""
    if argument.is_variable or argument.kind == JUMP:
        return in_macro(argument, str(argument.value))
    text, value = _text(argument)
    return text if _encoded(argument, value) == argument.raw else in_macro(argument, _in_its_encoding(argument))


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
