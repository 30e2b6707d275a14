"""Operations in the notation of the firmware's macros: `opSOUND, LC0(TONE), LC0(1), LC2(440), LC2(1000)`.

It names every encoding, so nothing of an operation is lost.
"""

from __future__ import annotations

import struct
from functools import cache

from ev3proto.messages import Argument, Operation
from ev3proto.schema.argument import LABEL_BYTE
from ev3proto.tables.declaration import Enumeration
from ev3proto.tables.encoding import CONSTANT, JUMP
from ev3proto.tables.source import BYTES
from ev3proto.text.assembly.words import CUT
from ev3proto.text.phrases import quoted, short_float, spaced_hex


def operation_line(operation: Operation) -> str:
    """Writes one operation. One that is cut short ends in `...`.

    Args:
        operation: The operation.

    Returns:
        The line, without its end.

    Raises:
        TypeError: It is no operation.
    """
    if not isinstance(operation, Operation):
        raise TypeError(f"a line is made of an Operation, not of {type(operation).__name__}")
    pieces = [f"op{operation.name}"]
    cmd = operation.cmd
    if cmd is not None:
        pieces.append(in_macro(cmd, operation.command or ""))
    pieces += map(_argument, operation.arguments)
    if not operation.is_complete:
        pieces.append(CUT)
    return ", ".join(pieces)


def in_macro(argument: Argument, value: str, macro: str | None = None) -> str:
    """Writes an argument as the macro of its encoding: `LC2(440)`, `HND(LV1(4))`.

    Args:
        argument: The argument.
        value: What is to stand in the macro.
        macro: The macro's name, where it is not that of the encoding.

    Returns:
        The macro. For a jump that no macro makes, bytes as they are.
    """
    if argument.kind == JUMP and argument.raw[0] != LABEL_BYTE:
        # The firmware looks at three bits of it only, so that several bytes mean a label.
        return f"{BYTES}({spaced_hex(argument.raw)})"
    text = f"{macro or argument.encoding}({value})"
    if argument.form.handle:
        text = f"HND({text})"
    if argument.form.address:
        text = f"ADR({text})"
    return text


def float_pattern(argument: Argument) -> str:
    """The bits of an argument that is read as a float, in hexadecimal."""
    (pattern,) = struct.unpack("<I", argument.raw[1:])
    return f"0x{pattern:08X}"


def _argument(argument: Argument) -> str:
    value, enum = argument.value, argument.parameter.enum
    if isinstance(value, str):
        return in_macro(argument, quoted(value))
    if isinstance(value, float):
        text = short_float(value)
        if struct.pack("<f", float(text)) == argument.raw[1:]:
            return in_macro(argument, text, "LCF")
        return in_macro(argument, float_pattern(argument))
    named = enum is not None and argument.kind == CONSTANT
    return in_macro(argument, str(_symbols(enum).get(value, value) if named else value))


@cache
def _symbols(enum: Enumeration) -> dict[int, str]:
    """The name that each number is written as."""
    names: dict[int, str] = {}
    for name, number in enum.members.items():
        names.setdefault(number, name)
    return names
