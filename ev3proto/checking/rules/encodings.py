"""Encodings that are longer than they need be."""

from __future__ import annotations

from ev3proto.checking import codes
from ev3proto.checking.context import CheckedOperation
from ev3proto.checking.report import Finding
from ev3proto.errors import counted
from ev3proto.messages import Argument, Variable
from ev3proto.schema.argument import encode_integer, encode_variable
from ev3proto.schema.identification import ENCODINGS
from ev3proto.tables.declaration import Role
from ev3proto.tables.encoding import CONSTANT, CONSTANT_RANGES, GLOBAL, INDEX_RANGES, LOCAL, Encoding


def longer_form(operation: CheckedOperation, has_jumps: bool) -> list[Finding]:
    """What is wrong with CMD of an operation that has one."""
    cmd = operation.parsed.cmd
    assert cmd is not None
    return [longer_finding(operation, cmd, has_jumps)] if is_longer(cmd) else []


_RANGES = {CONSTANT: CONSTANT_RANGES, LOCAL: INDEX_RANGES, GLOBAL: INDEX_RANGES}


def _shorter(form: Encoding) -> range | None:
    """The values that a shorter form than this one can hold; None where there is none."""
    if not form.width or form.handle or form.address:
        return None
    # Wider ones hold all that narrower ones do.
    narrower = [numbers for width, numbers in _RANGES.get(form.kind, {}).items() if width < form.width]
    return narrower[-1] if narrower else None


SHORTER = {id(form): _shorter(form) for form in ENCODINGS if form is not None}
"""The values that a shorter form can hold, by the id of the encoding: there is one object for each."""


def is_longer(argument: Argument) -> bool:
    """Whether its value fits a shorter form."""
    shorter = SHORTER.get(id(argument.form))
    return shorter is not None and type(argument.value) is int and argument.value in shorter


def shortest(argument: Argument) -> bytes:
    """The shortest bytes that say the same as one that `is_longer`."""
    kind, value = argument.form.kind, argument.value
    assert isinstance(value, int)
    return encode_integer(value) if kind == CONSTANT else encode_variable(Variable(kind, value))


def longer_finding(operation: CheckedOperation, argument: Argument, has_jumps: bool) -> Finding:
    """What is said of an argument that `is_longer`.

    Args:
        operation: The operation that it is in.
        argument: The argument.
        has_jumps: Whether the command has jumps, which may be over it.
    """
    kind, value = argument.form.kind, argument.value
    shorter = shortest(argument)
    if argument.parameter.role is Role.JUMP and kind == CONSTANT and isinstance(value, int) and value < 0:
        shorter = _shorter_way_back(argument, value)
    aside = ""
    if has_jumps and argument.parameter.role is not Role.JUMP:
        aside = f", and count {counted(argument.length - len(shorter), 'byte')} less in jumps over it"
    return operation.finding_at(
        codes.LONGER_FORM,
        argument,
        f"{argument.name} is {argument.encoding}, and its value fits {counted(len(shorter), 'byte')}",
        f"write it as {shorter.hex(' ').upper()}{aside}",
    )


def _shorter_way_back(argument: Argument, value: int) -> bytes:
    """A jump to the same place in fewer bytes: it is counted from its end, which is less far from there then."""
    for length in range(1, argument.length):
        data = encode_integer(value + argument.length - length)
        if len(data) == length:
            return data
    return encode_integer(value)
