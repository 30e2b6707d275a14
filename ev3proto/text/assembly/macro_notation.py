"""Operations in the notation of the firmware's macros: `opSOUND, LC0(TONE), LC0(1), LC2(440), LC2(1000)`.

It names every encoding, so nothing of an operation is lost.
"""

from __future__ import annotations

import struct
from functools import cache
from typing import NamedTuple

from ev3proto.messages import Argument, Operation, OperationReader
from ev3proto.schema.argument import SHORT
from ev3proto.schema.identification import ENCODINGS, LABEL_BYTE
from ev3proto.tables.declaration import Enumeration, Type
from ev3proto.tables.encoding import CONSTANT, JUMP, Encoding
from ev3proto.text.assembly.words import BYTES, CUT
from ev3proto.text.patterns import is_usual
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
    usual = _usual(operation[0])
    if is_usual(operation):
        pieces = [usual.head]
    else:
        pieces = [f"op{operation.name}"]
        cmd = operation.cmd
        if cmd is not None:
            pieces.append(in_macro(cmd, operation.command or ""))
    arguments, short = operation.arguments, usual.short
    if len(arguments) > len(short):
        short += (usual.element,) * (len(arguments) - len(short))
    pieces += [
        texts[argument[4][argument[3]]] or _argument(argument)
        for argument, texts in zip(arguments, short, strict=False)
    ]
    if not operation.is_complete:
        pieces.append(CUT)
    return ", ".join(pieces)


class _Usual(NamedTuple):
    """How operations with the same opcode and CMD are written.

    head     what stands before the arguments, where CMD is encoded as is usual
    short    each argument before the elements of a list, by its identification byte, where that is all of it
    element  the same for an element of a list
    """

    head: str
    short: tuple[_Short, ...]
    element: _Short


_Short = tuple[str | None, ...]


@cache
def _usual(schema: OperationReader) -> _Usual:
    declaration = schema.declaration
    opcode, command, parameters = declaration.opcode, declaration.command, declaration.parameters
    head = f"op{opcode.name}" if command is None else f"op{opcode.name}, LC0({command.name})"
    fixed = parameters[:-1] if parameters and parameters[-1].type is Type.VALUES else parameters
    element = _short(parameters[-1].enum if parameters else None)
    return _Usual(head, tuple(_short(parameter.enum) for parameter in fixed), element)


@cache
def _short(enum: Enumeration | None) -> _Short:
    names = {} if enum is None else _symbols(enum)
    short = [f"{form.name}({names.get(value, value) if form.kind == CONSTANT else value})" for form, value in SHORT]
    return (*short, *[None] * (len(ENCODINGS) - len(short)))


_AROUND: dict[int, tuple[str, str]] = {}
"""What stands around a number, by the id of its encoding: there is one object for each."""


def _around(form: Encoding) -> tuple[str, str]:
    before, after = f"{form.name}(", ")"
    if form.handle:
        before, after = f"HND({before}", f"{after})"
    if form.address:
        before, after = f"ADR({before}", f"{after})"
    around = _AROUND[id(form)] = before, after
    return around


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
    """An argument that has more than its identification byte."""
    parameter, form, value, _, _ = argument
    kind, enum = form.kind, parameter.enum
    if type(value) is int and kind != JUMP:
        before, after = _AROUND.get(id(form)) or _around(form)
        if enum is None or kind != CONSTANT:
            return f"{before}{value}{after}"
        return f"{before}{_symbols(enum).get(value, value)}{after}"
    if isinstance(value, str):
        return in_macro(argument, quoted(value))
    if isinstance(value, float):
        text = short_float(value)
        if struct.pack("<f", float(text)) == argument.raw[1:]:
            return in_macro(argument, text, "LCF")
        return in_macro(argument, float_pattern(argument))
    return in_macro(argument, str(value if enum is None else _symbols(enum).get(value, value)))


@cache
def _symbols(enum: Enumeration) -> dict[int, str]:
    """The name that each number is written as."""
    names: dict[int, str] = {}
    for name, number in enum.members.items():
        names.setdefault(number, name)
    return names
